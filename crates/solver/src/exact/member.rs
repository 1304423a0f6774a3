//! A floor or wall between events: its state, the branch of its columns, and its motion as a power series.

use crate::exact::bend::Bend;
use crate::exact::columns::{Branch, Columns, Line};
use crate::model::excitation::Segment;
use crate::roots::CAPACITY;
use crate::{Flight, Floor, Hysteresis, Hysteretic, Knee, Row, State, Support};

/// What the first coefficients of an acceleration are sums of.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Terms {
    /// Magnitude of the terms of the own forces \[N\].
    pub(super) own: f64,
    /// Sum of the magnitudes of the terms of the acceleration \[m/s²\].
    pub(super) acceleration: f64,
    /// The largest of those that storeys join with it.
    pub(super) around: f64,
    /// Magnitude of the ground acceleration and its slope.
    pub(super) ground: (f64, f64),
    /// The fastest rate of those that share the acceleration, or that storeys join, \[1/s\].
    pub(super) rate: f64,
    /// Now \[s\].
    pub(super) time: f64,
}

/// The flight of a structure to the next sample.
#[derive(Debug, Clone, Copy)]
pub(super) struct Ahead {
    pub(super) flight: Flight,
    /// Instant of the sample \[s\].
    pub(super) end: f64,
    /// State there, and the hysteretic part of its force.
    pub(super) state: State,
    pub(super) hysteretic_force: f64,
    /// What its acceleration does not exceed on the way \[m/s²\].
    pub(super) acceleration: f64,
}

impl Ahead {
    /// The same on a clock that shows less.
    pub(super) fn set_back(&mut self, by: f64) {
        self.end -= by;
    }
}

/// A floor with the storey below it, or a wall.
///
/// The columns' force is f = a k d + h: a line, and a part h with the stiffness (1 − a) k that yields at ±(1 − a) `f_y`.
#[derive(Debug, Clone)]
pub(super) struct Member {
    pub(super) inverse_mass: f64,
    /// Infinite for a wall.
    pub(super) mass: f64,
    /// When the ground motion arrives \[s\].
    pub(super) arrival: f64,
    /// The piece of it that the present expansion is under.
    pub(super) ground: Segment,
    /// Damping of the storey; of a floor on the ground all its damping.
    pub(super) damping: f64,
    /// Damping against the ground of a floor that stands on another one.
    pub(super) ground_damping: f64,
    /// The floor that stands on it.
    pub(super) above: Option<usize>,
    /// Of a floor that stands on another one: which, and the drift.
    pub(super) storey: Option<Box<Upper>>,
    /// Neither tied to another floor nor yielding smoothly: the columns' force is a line over the displacement.
    pub(super) plain: bool,
    /// k \[N/m\].
    stiffness: f64,
    /// a k \[N/m\].
    pub(super) hardened_stiffness: f64,
    /// (1 − a) k \[N/m\].
    pub(super) hysteretic_stiffness: f64,
    /// (1 − a) `f_y` \[N\].
    pub(super) limit: f64,
    /// Columns that yield smoothly.
    pub(super) bend: Option<Box<Bend>>,
    pub(super) branch: Branch,
    pub(super) line: Line,
    /// Its rate bounds the motion of a body together with those of all others; see [`fastest_rate`].
    pub(super) fastest_rate: f64,
    /// The net pounding force is known to be zero.
    pub(super) balanced: bool,
    /// The net pounding force is known to have an extremum.
    pub(super) peaked: bool,
    pub(super) terms: Terms,
    /// Where it flies to, if nothing comes in between.
    pub(super) ahead: Option<Ahead>,
    /// State at the start of the piece; displacement, velocity and restoring force lead, the rest follows.
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
    /// The rate of the drift is known to be zero at the start of the piece: its difference would be rounding.
    pub(super) still: bool,
    pub(super) drift: [f64; CAPACITY],
    pub(super) rate: [f64; CAPACITY],
}

impl Member {
    /// A node of a row in its initial state, with the force of its columns there.
    pub(super) fn new<Column: Hysteretic>(row: &Row<Column>, node: usize, initial: &[State]) -> Self {
        let floor = &row.nodes()[node];
        let force = if floor.is_wall() { 0.0 } else { initial[node].restoring_force };
        let columns = Columns::new(floor.column.hysteresis());
        let hysteretic_force = columns.hysteretic_force(force, row.drift(node, initial));
        let Columns {
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
            ground_damping,
            above: row.above(node),
            storey,
            plain: true,
            stiffness,
            hardened_stiffness,
            hysteretic_stiffness,
            limit,
            bend,
            branch: Branch::Elastic,
            line: Line::of(hysteretic_force, limit),
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
        member.plain = !member.is_tied() && member.bend.is_none();
        member
    }

    /// Coefficient `n` of the displacement of its ground, of those that are not left to the state: from the acceleration on.
    pub(super) fn ground_displacement(&self, p: usize, n: usize) -> f64 {
        if n == 2 * p {
            0.5 * self.ground.value
        } else if n == 3 * p {
            self.ground.slope / 6.0
        } else {
            0.0
        }
    }

    /// The same of its velocity.
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
        self.inverse_mass == 0.0
    }

    /// Whether it stands on a floor or carries one.
    pub(super) fn is_tied(&self) -> bool {
        self.storey.is_some() || self.above.is_some()
    }

    /// Whether its columns go another way from where the drift turns.
    pub(super) fn unloads(&self) -> bool {
        self.branch != Branch::Elastic || self.bend.is_some()
    }

    /// Tangent stiffness of the branch \[N/m\].
    pub(super) fn tangent(&self) -> f64 {
        match self.branch {
            Branch::Elastic => self.stiffness,
            Branch::Right | Branch::Left => self.hardened_stiffness,
        }
    }

    /// The same of h; of columns that yield smoothly it says nothing.
    pub(super) fn hysteretic_tangent(&self) -> f64 {
        match self.branch {
            Branch::Elastic => self.hysteretic_stiffness,
            Branch::Right | Branch::Left => 0.0,
        }
    }

    /// h after a piece \[N\], to this drift and by this change of it \[m\]; not of columns that yield smoothly.
    ///
    /// As long as nothing has yielded it follows from the drift: summed up, its rounding would stay when the motion dies away.
    #[inline]
    pub(super) fn hysteretic_force_at(&self, drift: f64, change: f64) -> f64 {
        match self.line {
            Line::FirstLoading => self.hysteretic_stiffness * drift,
            Line::Shifted => self.hysteretic_force + self.hysteretic_tangent() * change,
        }
    }

    /// Coefficients of the drift of the storey.
    pub(super) fn drift(&self) -> &[f64; CAPACITY] {
        self.storey.as_ref().map_or(&self.displacement, |storey| &storey.drift)
    }

    /// Coefficients of its rate.
    pub(super) fn drift_rate(&self) -> &[f64; CAPACITY] {
        self.storey.as_ref().map_or(&self.velocity, |storey| &storey.rate)
    }

    /// Coefficient `n` of the restoring force.
    pub(super) fn restoring_force(&self, n: usize) -> f64 {
        match &self.bend {
            Some(bend) if n > 0 => self.hardened_stiffness * self.drift()[n] + bend.force[n],
            Some(_) | None => self.force_of(self.drift()[n], n),
        }
    }

    /// The same of columns whose force is a line over this coefficient of the drift.
    #[inline]
    pub(super) fn force_of(&self, drift: f64, n: usize) -> f64 {
        if n == 0 {
            self.state.restoring_force
        } else {
            self.tangent() * drift
        }
    }

    /// Ends yielding where the motion from a standstill leads back, and turns columns that yield smoothly the way it leads;
    /// true when it did either. As below, `len` coefficients of this expansion are known.
    pub(super) fn turns_back(&mut self, below: Option<&Self>, (p, len): (usize, usize)) -> bool {
        let Some(leading) = self.leading_rate(below, (p, len)) else {
            return false;
        };
        if let Some(bend) = &mut self.bend {
            return bend.goes_with(leading);
        }
        self.unload(leading)
    }

    /// Whether what rounding leaves of the first rates of the drift leads another way than the motion: it would turn at once, again
    /// and again.
    pub(super) fn goes_astray(&self, below: Option<&Self>, (p, len): (usize, usize)) -> bool {
        let first = self.drift_rate()[..len].iter().find(|rate| **rate != 0.0);
        let leading = self.leading_rate(below, (p, len));
        first.zip(leading).is_some_and(|(first, leading)| (*first > 0.0) != (leading > 0.0))
    }

    /// The first coefficient of the rate of the drift that is more than rounding.
    fn leading_rate(&self, below: Option<&Self>, (p, len): (usize, usize)) -> Option<f64> {
        let mut rates = self.drift_rate()[..len].iter().enumerate();
        // An event sets the rounding of what it makes zero to zero; and a row at rest before its record begins need not ask.
        let leads = |n: usize, rate: f64| rate != 0.0 && rate.abs() > self.noise_of_rate(below, p, n);
        let leading = rates.find(|(n, rate)| leads(*n, **rate));
        leading.map(|(_, rate)| *rate)
    }

    /// Clears what rounding leaves of the first rates of the drift from a standstill: columns would yield, or turn, again at once.
    pub(super) fn clear_standstill(&mut self, below: Option<&Self>, (p, len): (usize, usize)) {
        for n in 0..len.min(CAPACITY - p) {
            if self.drift_rate()[n].abs() > self.noise_of_rate(below, p, n) {
                return;
            }
            // Of a drift that does not begin the force of smooth columns is none: it would pass through zero again at once.
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

    /// Columns yield no longer once their drift, at this rate, turns; true where they did.
    pub(super) fn unload(&mut self, rate: f64) -> bool {
        let turned = match self.branch {
            Branch::Elastic => false,
            Branch::Right => rate < 0.0,
            Branch::Left => rate > 0.0,
        };
        if turned {
            self.branch = Branch::Elastic;
        }
        turned
    }

    /// Rounding of coefficient `n` of the rate of the drift.
    fn noise_of_rate(&self, below: Option<&Self>, p: usize, n: usize) -> f64 {
        let own = self.noise_of_velocity(p, n);
        below.map_or(own, |below| own + below.noise_of_velocity(p, n))
    }
}

/// A member and the floor it stands on, which comes before it.
pub(super) fn with_below(members: &mut [Member], node: usize) -> Option<(&mut Member, Option<&Member>)> {
    let (lower, upper) = members.split_at_mut(node);
    let member = upper.first_mut()?;
    let below = member.storey.as_ref().and_then(|storey| lower.get(storey.below));
    Some((member, below))
}

/// The rate ρ with ρ² = ρ C + K, C and K the sums of the magnitudes in a row of M⁻¹C and M⁻¹K.
///
/// With the largest of its members coefficients of the motion of a body fall at least like ρⁿ/n!.
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
            Knee::Sharp => stiffness,
            // Unloading beyond the elastic line.
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
    let (damping, stiffness) = (damping * floor.inverse_mass, stiffness * floor.inverse_mass);
    0.5 * (damping + (damping * damping + 4.0 * stiffness).sqrt())
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
