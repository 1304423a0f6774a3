use crate::{
    CentralDifference, Course, Exact, Excitation, Hht, Hysteretic, Knee, Laws, Link, LinkLaw, MoreauJean, Newmark, Node, Recorder, Rk4,
    Row, RunError, Verlet, Work, exact, explicit::central_difference, explicit::rk4, explicit::verlet, implicit::hht,
    implicit::moreau_jean, implicit::newmark,
};

/// A method of time integration with its settings. Each method has a separate file and the same signature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Integrator {
    /// Central difference method.
    CentralDifference(CentralDifference),
    /// Newmark's method.
    Newmark(Newmark),
    /// HHT-α method.
    Hht(Hht),
    /// Velocity Verlet method.
    Verlet(Verlet),
    /// Classical Runge–Kutta method.
    Rk4(Rk4),
    /// Moreau–Jean time stepping.
    MoreauJean(MoreauJean),
    /// Event-driven integration with power series.
    Exact(Exact),
}

impl Integrator {
    /// Checks the settings of the method.
    ///
    /// # Errors
    /// [`RunError::Setting`] names the setting, what was found and what is allowed.
    pub fn check(&self) -> Result<(), RunError> {
        match self {
            Self::CentralDifference(settings) => settings.check(),
            Self::Newmark(settings) => settings.check(),
            Self::Hht(settings) => settings.check(),
            Self::MoreauJean(settings) => settings.check(),
            Self::Exact(settings) => settings.check(),
            Self::Verlet(_) | Self::Rk4(_) => Ok(()),
        }
    }

    /// Integrates a row from t = 0 to the end of the clock and reports to the recorder. A [`Clock`](crate::Clock) without a budget gets the
    /// default [`Budget`](crate::Budget).
    ///
    /// # Errors
    /// [`RunError`] if a setting is out of range, the response is no longer finite, an equilibrium is not found, or the budget is spent.
    pub fn run<Column: Hysteretic, R: Recorder>(
        &self,
        row: &Row<Column>,
        excitation: Excitation<'_>,
        course: impl Into<Course>,
        recorder: &mut R,
    ) -> Result<Work, RunError> {
        let course = course.into();
        let clock = course.clock;
        if !(clock.time_step.is_finite() && clock.time_step > 0.0) {
            return Err(RunError::Setting {
                setting: "time_step",
                found: clock.time_step,
                allowed: "a finite number > 0",
            });
        }
        if !row.links().is_empty() && !self.takes_links() {
            return Err(RunError::TakesNoLinks);
        }
        let steep = |link: &Link| !self.takes_bare_dampers() && matches!(link.law, LinkLaw::Viscous(_));
        if let Some(link) = row.links().iter().position(steep) {
            return Err(RunError::LinkTooSteep { link });
        }
        self.takes_damping_of(row)?;
        self.takes_friction_of(row)?;
        match *self {
            Self::CentralDifference(settings) => central_difference::run(settings, row, excitation, course, recorder),
            Self::Newmark(settings) => newmark::run(settings, row, excitation, course, recorder),
            Self::Hht(settings) => hht::run(settings, row, excitation, course, recorder),
            Self::Verlet(settings) => verlet::run(settings, row, excitation, course, recorder),
            Self::Rk4(settings) => rk4::run(settings, row, excitation, course, recorder),
            Self::MoreauJean(settings) => moreau_jean::run(settings, row, excitation, course, recorder),
            Self::Exact(settings) => exact::run(settings, row, excitation, course, recorder),
        }
    }

    /// Whether the method takes links between floors.
    pub fn takes_links(&self) -> bool {
        matches!(self, Self::Exact(_) | Self::Rk4(_) | Self::CentralDifference(_))
    }

    /// Whether the method takes links with a damper c |v|^α without a brace; the exact method takes some.
    pub fn takes_bare_dampers(&self) -> bool {
        !matches!(self, Self::CentralDifference(_))
    }

    /// Whether the method lets damping follow the tangent stiffness. The others eliminate the dashpots before the first step, or
    /// carry damping forces from step to step.
    pub fn takes_tangent_damping(&self) -> bool {
        match self {
            Self::Exact(_) | Self::Newmark(_) | Self::Rk4(_) => true,
            Self::CentralDifference(_) | Self::Verlet(_) | Self::Hht(_) | Self::MoreauJean(_) => false,
        }
    }

    /// Refuses damping on the tangent stiffness that the method does not take, or of columns whose tangent changes smoothly.
    fn takes_damping_of<Column: Hysteretic>(&self, row: &Row<Column>) -> Result<(), RunError> {
        let follows = |node: &Node<Column>| {
            let is_smooth = node.column.hysteresis().knee != Knee::Sharp;
            node.elastic_damping > 0.0 && (is_smooth || !self.takes_tangent_damping())
        };
        let refused = row.nodes().iter().position(follows);
        refused.map_or(Ok(()), |structure| Err(RunError::TangentDamping { structure }))
    }

    /// Whether the method takes columns that stick and slide.
    pub fn takes_friction(&self) -> bool {
        matches!(self, Self::Exact(_))
    }

    fn takes_friction_of<Column: Hysteretic>(&self, row: &Row<Column>) -> Result<(), RunError> {
        let sticks = |node: &Node<Column>| node.column.hysteresis().knee == Knee::Rigid;
        match row.nodes().iter().position(sticks) {
            Some(structure) if !self.takes_friction() => Err(RunError::Friction { structure }),
            Some(_) | None => Ok(()),
        }
    }

    /// The laws that a run of the method must obey: only the exact method must keep energy to rounding.
    pub fn laws(&self) -> Laws {
        match self {
            Self::Exact(Exact { tolerance, .. }) => Laws::Energy { tolerance: *tolerance },
            Self::CentralDifference(_) | Self::Newmark(_) | Self::Hht(_) | Self::Verlet(_) | Self::Rk4(_) | Self::MoreauJean(_) => {
                Laws::All
            }
        }
    }
}
