//! A floor or wall between events: its state, the branch of its columns, and its motion as a power series.

use crate::exact::bend::Bend;
use crate::exact::columns::{Branch, LoadingLine, LoopConstants};
use crate::exact::link_laws::Linked;
use crate::exact::stick::Stick;
use crate::model::excitation::Segment;
use crate::roots::{CAPACITY, INSTANT};
use crate::{Flight, Floor, Hysteresis, Hysteretic, Knee, Row, State, Support};

/// Magnitudes of the terms of the first coefficients of an acceleration.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Terms {
    /// Magnitude of the terms of the member's forces \[N\].
    pub(super) own: f64,
    /// Sum of the magnitudes of the terms of the acceleration \[m/s²\].
    pub(super) acceleration: f64,
    /// The largest such sum among the members joined by storeys.
    pub(super) around: f64,
    /// Magnitudes of the ground acceleration and its slope.
    pub(super) ground: (f64, f64),
    /// The fastest rate among members that share the acceleration or are joined by storeys \[1/s\].
    pub(super) rate: f64,
    /// Present time \[s\].
    pub(super) time: f64,
}

/// The flight of a structure to the next sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ahead {
    pub(super) flight: Flight,
    /// Instant of the sample \[s\].
    pub(super) end: f64,
    /// State at the sample, and the hysteretic part of the force.
    pub(super) state: State,
    pub(super) hysteretic_force: f64,
    /// Bound of the acceleration during the flight \[m/s²\].
    pub(super) acceleration: f64,
}

impl Ahead {
    /// Shifts the time to a clock that shows `by` less \[s\].
    pub(super) fn set_back(&mut self, by: f64) {
        self.end -= by;
    }
}

/// A floor with the storey below it, or a wall.
///
/// The force of the columns is f = a k d + h: a line, and a hysteretic part h with the stiffness (1 − a) k that yields at ±(1 − a) `f_y`.
#[derive(Debug, Clone)]
pub(super) struct Member {
    pub(super) inverse_mass: f64,
    /// Mass \[kg\]; infinite for a wall.
    pub(super) mass: f64,
    /// When the ground motion arrives \[s\].
    pub(super) arrival: f64,
    /// The piece of ground motion of the present expansion.
    pub(super) ground: Segment,
    /// Damping of the storey on the present branch; for a floor on the ground, all its damping.
    pub(super) damping: f64,
    /// Its damping on the elastic branch, and the part that it loses on the others.
    whole_damping: f64,
    elastic_damping: f64,
    /// Damping against the ground, for a floor that stands on another floor.
    pub(super) ground_damping: f64,
    /// The floor that stands on it.
    pub(super) above: Option<usize>,
    /// The storey below, for a floor that stands on another floor.
    pub(super) storey: Option<Box<Upper>>,
    /// The forces of its links; `None` if it has none.
    pub(super) linked: Option<Box<Linked>>,
    /// Whether the member is neither tied to another floor nor yields smoothly: the force of its columns is then a line over the
    /// displacement.
    pub(super) plain: bool,
    /// k \[N/m\].
    stiffness: f64,
    /// a k \[N/m\].
    pub(super) hardened_stiffness: f64,
    /// (1 − a) k \[N/m\].
    pub(super) hysteretic_stiffness: f64,
    /// (1 − a) `f_y` \[N\].
    pub(super) limit: f64,
    /// Drift at which the storey falls under gravity and ends the run \[m\]; infinite if it never does.
    pub(super) falls_at: f64,
    /// Columns that yield smoothly.
    pub(super) bend: Option<Box<Bend>>,
    /// Friction below it; [`Branch::Elastic`] is then the branch on which it sticks.
    pub(super) stick: Option<Box<Stick>>,
    pub(super) branch: Branch,
    pub(super) line: LoadingLine,
    /// Rate that bounds the motion of a body together with the rates of its other members; see [`fastest_rate`].
    pub(super) fastest_rate: f64,
    /// The net pounding force is zero at this instant.
    pub(super) balanced: bool,
    /// The net pounding force has an extremum at this instant.
    pub(super) peaked: bool,
    pub(super) terms: Terms,
    /// The flight to the next sample, unless an event happens before.
    pub(super) ahead: Option<Ahead>,
    /// State at the start of the piece. Displacement, velocity and restoring force are primary; the others follow from them.
    pub(super) state: State,
    /// h at the start of the piece \[N\].
    pub(super) hysteretic_force: f64,
    pub(super) displacement: [f64; CAPACITY],
    pub(super) velocity: [f64; CAPACITY],
    pub(super) acceleration: [f64; CAPACITY],
}

/// A storey that stands on a floor, and its drift as series in the variable of its body.
#[derive(Debug, Clone)]
pub(super) struct Upper {
    /// The floor below.
    pub(super) below: usize,
    /// The rate of the drift is zero at the start of the piece: its computed difference would be rounding.
    pub(super) still: bool,
    pub(super) drift: [f64; CAPACITY],
    pub(super) rate: [f64; CAPACITY],
}

impl Member {
    /// A node of a row in its initial state, with the force of its columns there.
    pub(super) fn new<Column: Hysteretic>(row: &Row<Column>, node: usize, initial: &[State]) -> Self {
        let floor = &row.nodes()[node];
        let force = if floor.is_wall() { 0.0 } else { initial[node].restoring_force };
        let columns = LoopConstants::new(floor.column.hysteresis());
        let hysteretic_force = columns.hysteretic_force(force, row.drift(node, initial));
        let LoopConstants {
            stiffness,
            hardened_stiffness,
            hysteretic_stiffness,
            limit,
            bend,
        } = columns;
        let state = State {
            displacement: initial[node].displacement,
            velocity: initial[node].velocity,
            restoring_force: force,
            ..State::default()
        };
        let (storey, ground_damping) = match floor.support {
            Support::Ground => (None, 0.0),
            Support::Floor(Floor { below, ground_damping }) => (Some(Box::new(Upper::over(below))), ground_damping),
        };
        let mut member = Self {
            inverse_mass: floor.inverse_mass,
            mass: 1.0 / floor.inverse_mass,
            arrival: row.arrival(node),
            ground: Segment::default(),
            damping: floor.damping,
            whole_damping: floor.damping,
            elastic_damping: floor.elastic_damping,
            ground_damping,
            above: row.above(node),
            storey,
            linked: Linked::at(row, node),
            plain: true,
            stiffness,
            hardened_stiffness,
            hysteretic_stiffness,
            limit,
            falls_at: f64::INFINITY,
            bend,
            stick: Stick::of(floor.column.hysteresis(), 1.0 / floor.inverse_mass),
            branch: Branch::Elastic,
            line: LoadingLine::of(hysteretic_force, limit),
            fastest_rate: fastest_rate(row, node),
            balanced: false,
            peaked: false,
            terms: Terms::default(),
            ahead: None,
            state,
            hysteretic_force,
            displacement: [0.0; CAPACITY],
            velocity: [0.0; CAPACITY],
            acceleration: [0.0; CAPACITY],
        };
        member.plain = !member.is_tied() && member.bend.is_none() && member.stick.is_none();
        member.slide();
        member
    }

    /// Coefficient `n` of the ground displacement, from the order of the acceleration on; lower orders are in the state.
    pub(super) fn ground_displacement(&self, p: usize, n: usize) -> f64 {
        if n == 2 * p {
            0.5 * self.ground.value
        } else if n == 3 * p {
            self.ground.slope / 6.0
        } else {
            0.0
        }
    }

    /// Coefficient `n` of the ground velocity, from the order of the acceleration on.
    pub(super) fn ground_velocity(&self, p: usize, n: usize) -> f64 {
        if n == p {
            self.ground.value
        } else if n == 2 * p {
            0.5 * self.ground.slope
        } else {
            0.0
        }
    }

    pub(super) fn is_wall(&self) -> bool {
        self.is_still() && self.stick.is_none()
    }

    /// Whether it is a wall, or friction holds it.
    pub(super) fn is_still(&self) -> bool {
        self.inverse_mass == 0.0
    }

    /// Whether it stands on a floor, carries one, or is linked.
    pub(super) fn is_tied(&self) -> bool {
        self.storey.is_some() || self.above.is_some() || self.linked.is_some()
    }

    /// Whether its columns take another path when the drift turns.
    pub(super) fn unloads(&self) -> bool {
        self.branch != Branch::Elastic || self.bend.is_some()
    }

    /// Continues on a branch, with its damping.
    pub(super) fn go_on(&mut self, branch: Branch) {
        self.branch = branch;
        self.damping = match branch {
            Branch::Elastic => self.whole_damping,
            Branch::Right | Branch::Left => self.whole_damping - self.elastic_damping,
        };
        self.stick_or_slide();
    }

    /// Tangent stiffness of the branch \[N/m\].
    pub(super) fn tangent(&self) -> f64 {
        match self.branch {
            Branch::Elastic => self.stiffness,
            Branch::Right | Branch::Left => self.hardened_stiffness,
        }
    }

    /// Tangent stiffness of h \[N/m\]; meaningless for columns that yield smoothly.
    pub(super) fn hysteretic_tangent(&self) -> f64 {
        match self.branch {
            Branch::Elastic => self.hysteretic_stiffness,
            Branch::Right | Branch::Left => 0.0,
        }
    }

    /// h after a piece \[N\], at this drift and after this change of it \[m\]; not for columns that yield smoothly.
    ///
    /// Until the first yielding, h follows from the drift alone: the rounding of a sum would remain when the motion dies away.
    #[inline]
    pub(super) fn hysteretic_force_at(&self, drift: f64, change: f64) -> f64 {
        match self.line {
            LoadingLine::FirstLoading => self.hysteretic_stiffness * drift,
            LoadingLine::Shifted => self.hysteretic_force + self.hysteretic_tangent() * change,
        }
    }

    /// Coefficients of the drift of the storey.
    pub(super) fn drift(&self) -> &[f64; CAPACITY] {
        self.storey.as_ref().map_or(&self.displacement, |storey| &storey.drift)
    }

    /// Coefficients of the rate of the drift.
    pub(super) fn drift_rate(&self) -> &[f64; CAPACITY] {
        self.storey.as_ref().map_or(&self.velocity, |storey| &storey.rate)
    }

    /// Coefficient `n` of the restoring force.
    pub(super) fn restoring_force(&self, n: usize) -> f64 {
        match &self.bend {
            Some(bend) if n > 0 => self.hardened_stiffness * self.drift()[n] + bend.force[n],
            // The friction that holds a floor is found from all other forces.
            None if self.held().is_some() => self.hardened_stiffness * self.drift()[n],
            Some(_) | None => self.force_of(self.drift()[n], n),
        }
    }

    /// Coefficient `n` of the restoring force of columns whose force is a line, from this coefficient of the drift.
    #[inline]
    pub(super) fn force_of(&self, drift: f64, n: usize) -> f64 {
        if n == 0 {
            self.state.restoring_force
        } else {
            self.tangent() * drift
        }
    }

    /// Ends yielding if the motion from a standstill leads back, and gives columns that yield smoothly their new direction; true if
    /// anything changed. `len` coefficients of this expansion are known, as below.
    pub(super) fn turns_back(&mut self, below: Option<&Self>, p: usize, len: usize) -> bool {
        let Some((n, leading)) = self.leading_rate(below, p, len) else {
            return false;
        };
        if let Some(bend) = &mut self.bend {
            return bend.goes_with(leading);
        }
        // After a rest, the rounding of a rate may point against the motion for less than an instant.
        let overtaken = n == 0 && -self.drift_rate()[p] * leading.signum() * INSTANT > leading.abs();
        !overtaken && self.unload(leading)
    }

    /// Whether the rounding of the first rates of the drift points against the motion: the columns would turn at once, again and again.
    pub(super) fn goes_astray(&self, below: Option<&Self>, p: usize, len: usize) -> bool {
        let first = self.drift_rate()[..len].iter().find(|rate| **rate != 0.0);
        let leading = self.leading_rate(below, p, len);
        first
            .zip(leading)
            .is_some_and(|(first, (_, leading))| (*first > 0.0) != (leading > 0.0))
    }

    /// The first coefficient of the rate of the drift that is more than rounding, with its order.
    fn leading_rate(&self, below: Option<&Self>, p: usize, len: usize) -> Option<(usize, f64)> {
        let mut rates = self.drift_rate()[..len].iter().enumerate();
        // An event sets rounded zeros to zero, and a row at rest before its record begins has only zeros.
        let leads = |n: usize, rate: f64| rate != 0.0 && rate.abs() > self.noise_of_rate(below, p, n);
        let leading = rates.find(|(n, rate)| leads(*n, **rate));
        leading.map(|(n, rate)| (n, *rate))
    }

    /// Clears the rounding of the first rates of the drift from a standstill: columns would yield, or turn, at once.
    pub(super) fn clear_standstill(&mut self, below: Option<&Self>, p: usize, len: usize) {
        for n in 0..len.min(CAPACITY - p) {
            if self.drift_rate()[n].abs() > self.noise_of_rate(below, p, n) {
                return;
            }
            // A drift that does not begin gives smooth columns no force: otherwise it would pass through zero at once.
            if let Some(bend) = &mut self.bend {
                bend.force[n + p] = 0.0;
            }
            if let Some(storey) = &mut self.storey {
                (storey.rate[n], storey.drift[n + p]) = (0.0, 0.0);
                continue;
            }
            (self.velocity[n], self.displacement[n + p]) = (0.0, 0.0);
            if n >= p {
                self.acceleration[n - p] = 0.0;
            }
        }
    }

    /// Ends yielding if the drift turns at this rate; true if it did.
    pub(super) fn unload(&mut self, rate: f64) -> bool {
        let turned = match self.branch {
            Branch::Elastic => false,
            Branch::Right => rate < 0.0,
            Branch::Left => rate > 0.0,
        };
        if turned {
            self.go_on(Branch::Elastic);
        }
        turned
    }

    /// Rounding of coefficient `n` of the rate of the drift.
    fn noise_of_rate(&self, below: Option<&Self>, p: usize, n: usize) -> f64 {
        let own = self.noise_of_velocity(p, n);
        below.map_or(own, |below| own + below.noise_of_velocity(p, n))
    }
}

/// A member, and the floor on which it stands, which comes before it.
pub(super) fn with_below(members: &mut [Member], node: usize) -> Option<(&mut Member, Option<&Member>)> {
    let (lower, upper) = members.split_at_mut(node);
    let member = upper.first_mut()?;
    let below = member.storey.as_ref().and_then(|storey| lower.get(storey.below));
    Some((member, below))
}

/// The rate ρ with ρ² = ρ C + K, where C and K are the sums of the magnitudes in a row of M⁻¹C and M⁻¹K; more by that of links that relax.
///
/// With ρ the largest rate of its members, the coefficients of the motion of a body fall at least like ρⁿ/n!.
fn fastest_rate<Column: Hysteretic>(row: &Row<Column>, node: usize) -> f64 {
    let (nodes, floor) = (row.nodes(), &row.nodes()[node]);
    let steepest = |node: usize| {
        let Hysteresis {
            stiffness,
            hardening,
            knee,
            ..
        } = nodes[node].column.hysteresis();
        match knee {
            // Under gravity the stiffness after yielding may be negative.
            Knee::Sharp | Knee::Rigid => stiffness * hardening.abs().max(1.0),
            // Unloading may be stiffer than the elastic line.
            Knee::Smooth(smoothness) => {
                let bend = (2.0 * smoothness.unloading).max(1.0);
                stiffness * (hardening + (1.0 - hardening) * bend)
            }
        }
    };
    let (mut damping, mut stiffness) = (floor.damping, steepest(node));
    if let Support::Floor(Floor { ground_damping, .. }) = floor.support {
        (damping, stiffness) = (2.0 * damping + ground_damping, 2.0 * stiffness);
    }
    if let Some(above) = row.above(node) {
        damping += 2.0 * nodes[above].damping;
        stiffness += 2.0 * steepest(above);
    }
    let mut relaxation = 0.0;
    if let Some(linked) = Linked::at(row, node) {
        damping += 2.0 * linked.damping;
        stiffness += 2.0 * linked.stiffness;
        relaxation = linked.relaxation;
    }
    let (damping, stiffness) = (damping * floor.inverse_mass, stiffness * floor.inverse_mass);
    relaxation + 0.5 * (damping + (damping * damping + 4.0 * stiffness).sqrt())
}

impl Upper {
    fn over(below: usize) -> Self {
        Self {
            below,
            still: false,
            drift: [0.0; CAPACITY],
            rate: [0.0; CAPACITY],
        }
    }
}
