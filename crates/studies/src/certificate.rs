//! What a contact law and a method really deliver to two free masses.

use pounding_contact::{
    Calibration, CalibrationError, ContactLaw, FreeImpact, FreePair, LawName, reduced_mass,
};
use pounding_solver::{
    Clock, Elastic, Exact, Excitation, Impact, Integrator, Node, Pair, Recorder, Row, RunError,
    Span,
};

use crate::Method;

/// The collision that a certificate is about.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    /// Masses of the neighbours \[kg\], > 0.
    pub masses: [f64; 2],
    /// Approach speed at the first touch \[m/s\], > 0.
    pub speed: f64,
}

/// What is asked of a law.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wanted {
    /// The law.
    pub law: LawName,
    /// Impact stiffness, in [`LawName::stiffness_unit`]; not looked at for the impulsive law.
    pub stiffness: f64,
    /// Coefficient of restitution e \[–\].
    pub restitution: f64,
    /// How its damping is chosen.
    pub calibration: Calibration,
}

/// What a law delivers to a collision of two free masses.
#[derive(Debug, Clone, PartialEq)]
pub struct Certificate {
    /// The law with its parameters.
    pub law: ContactLaw,
    /// e that the literature's formula would deliver, exactly; nothing where the literature has no formula.
    pub by_formula: Option<f64>,
    /// e delivered, by the law's own relation or, where it has none, by integration of the free impact.
    pub by_relation: Option<f64>,
    /// e delivered by the exact method.
    pub by_exact: f64,
    /// Impulse \[N·s\] of the exact method.
    pub impulse: f64,
    /// Peak force, largest deformation and duration of the free impact; nothing for an impulsive law.
    pub impact: Option<FreeImpact>,
}

/// What a stepping method delivers at a time step, over where in its step the gap closes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Delivered {
    /// Least and largest e delivered \[–\].
    pub range: [f64; 2],
    /// Largest distance from the e that the law delivers \[–\], absolute.
    pub error: f64,
    /// Time steps from touch to parting; nothing for an impulsive law.
    pub steps_per_contact: Option<f64>,
}

/// Parts of a step at which the gap is made to close.
const N_PHASES: u32 = 16;
/// Steps before the touch.
const BEFORE: u32 = 3;

impl Certificate {
    /// Calibrates a law and lets two free masses collide.
    ///
    /// # Errors
    /// [`CertificateError`] for a parameter out of range, and where no run gives an answer.
    pub fn new(wanted: &Wanted, collision: &Collision) -> Result<Self, CertificateError> {
        let pair = collision.free_pair();
        let calibrated = |calibration| {
            let asked = (wanted.restitution, calibration);
            wanted.law.calibrated(wanted.stiffness, asked, &pair)
        };
        let law = calibrated(wanted.calibration)?;
        let has_formula = wanted.law.description().formula.is_some();
        let formula = has_formula.then(|| calibrated(Calibration::Literature));
        let impact = FreeImpact::of(&law, &pair);
        let integrated = |law: &ContactLaw| Some(FreeImpact::of(law, &pair)?.restitution);
        let relation = |law: &ContactLaw| law.restitution().or_else(|| integrated(law));
        let scale = impact.map_or(1.0, |impact| impact.duration);
        let exact = Integrator::Exact(Exact::default());
        let run = collision.run(law, &exact, (scale, 0.5))?;
        Ok(Self {
            by_formula: formula.transpose()?.as_ref().and_then(relation),
            by_relation: relation(&law),
            by_exact: run.restitution(collision.speed),
            impulse: run.impulse,
            law,
            impact,
        })
    }

    /// What a method delivers.
    ///
    /// # Errors
    /// [`CertificateError::Run`] where it fails.
    pub fn by(
        &self,
        collision: &Collision,
        method: &Method,
    ) -> Result<Delivered, CertificateError> {
        let duration = self.impact.map(|impact| impact.duration);
        let step = method.time_step().unwrap_or(duration.unwrap_or(1.0));
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for phase in 0..N_PHASES {
            let part = (f64::from(phase) + 0.5) / f64::from(N_PHASES);
            let run = collision.run(self.law, &method.integrator(), (step, part))?;
            let found = run.restitution(collision.speed);
            range = [range[0].min(found), range[1].max(found)];
        }
        let off = |found: f64| (found - self.by_exact).abs();
        Ok(Delivered {
            range,
            error: off(range[0]).max(off(range[1])),
            steps_per_contact: duration.map(|duration| duration / step),
        })
    }
}

impl Collision {
    fn free_pair(&self) -> FreePair {
        FreePair {
            reduced_mass: reduced_mass(1.0 / self.masses[0], 1.0 / self.masses[1]),
            approach_speed: self.speed,
        }
    }

    /// Lets the masses collide; the gap closes `BEFORE` steps and a part of one after the start.
    fn run(
        &self,
        law: ContactLaw,
        integrator: &Integrator,
        (step, part): (f64, f64),
    ) -> Result<Seen, CertificateError> {
        let [left, right] = self.masses;
        let total = left + right;
        // About the common centre, so that neither velocity is small against the other's rounding.
        let node = |mass, velocity| Node {
            initial_velocity: velocity,
            ..Node::structure(mass, 0.0, Elastic { stiffness: 0.0 })
        };
        let nodes = vec![
            node(left, self.speed * right / total),
            node(right, -self.speed * left / total),
        ];
        let until = (f64::from(BEFORE) + part) * step;
        let pair = Pair {
            left: 0,
            right: 1,
            gap: self.speed * until,
            law,
        };
        let row = Row::new(nodes, vec![pair]).map_err(|_| CertificateError::Masses)?;
        let contact = FreeImpact::of(&law, &self.free_pair()).map_or(0.0, |impact| impact.duration);
        let n_steps = ((until + 2.0 * contact) / step).ceil() + f64::from(BEFORE);
        if !(step.is_finite() && step > 0.0 && n_steps <= MOST_STEPS) {
            return Err(CertificateError::TimeStep { found: step });
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "checked: a positive number that is not large"
        )]
        let n_steps = n_steps as usize;
        let clock = Clock {
            time_step: step,
            n_steps,
        };
        let rest = Excitation::new(step, &[0.0])
            .map_err(|_| CertificateError::TimeStep { found: step })?;
        let mut seen = Seen::default();
        integrator.run(&row, rest, clock, &mut seen)?;
        Ok(seen)
    }
}

/// Most steps of a run.
const MOST_STEPS: f64 = 1e7;

/// The last velocities, and the impulse.
#[derive(Debug, Clone, Copy, Default)]
struct Seen {
    velocities: [f64; 2],
    impulse: f64,
}

impl Seen {
    fn restitution(&self, speed: f64) -> f64 {
        (self.velocities[1] - self.velocities[0]) / speed
    }
}

impl Recorder for Seen {
    fn span(&mut self, span: &Span<'_>) {
        self.velocities[span.structure] = span.end.velocity;
        if span.structure == 0 {
            self.impulse -= span.impulse_from_right;
        }
    }

    fn impact(&mut self, impact: &Impact) {
        self.velocities = [impact.after.left, impact.after.right];
        self.impulse += impact.impulse;
    }
}

/// Why there is no certificate.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CertificateError {
    /// A parameter of the law.
    #[error(transparent)]
    Law(#[from] CalibrationError),
    /// Masses or speed out of range.
    #[error("masses and speed: allowed are finite numbers > 0")]
    Masses,
    /// A time step out of range.
    #[error(
        "time step: found {found} s, allowed a finite number > 0 and at most 1e7 steps in the collision"
    )]
    TimeStep {
        /// The time step \[s\].
        found: f64,
    },
    /// A run that ended early.
    #[error(transparent)]
    Run(#[from] RunError),
}
