//! The ground at an instant, for stepping methods.

use crate::model::travel::Travel;
use crate::{Clock, Excitation, Motion, Pair, Relation, State};

/// The ground motion of a run, chosen once.
pub(crate) enum Shaking<'a> {
    /// All buildings are shaken at once: ground acceleration at every node of the clock \[m/s²\].
    Common(Vec<f64>),
    /// The motion arrives at the buildings at different times.
    Delayed(Delayed<'a>),
}

/// A ground motion that travels along a row.
#[derive(Debug)]
pub(crate) struct Delayed<'a> {
    excitation: Excitation<'a>,
    travel: Travel,
    /// Arrival at every node, in samples.
    arrivals: Vec<f64>,
    /// Samples in a time step.
    ratio: f64,
}

/// The ground at an instant.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Ground<'a> {
    /// Its acceleration \[m/s²\].
    Common(f64),
    Delayed {
        of: &'a Delayed<'a>,
        /// Time steps since t = 0, and the elapsed part of the next step.
        step: usize,
        part: f64,
    },
}

/// An instant, and the ground at it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Now<'a> {
    pub(crate) ground: Ground<'a>,
    /// Time \[s\].
    pub(crate) time: f64,
}

impl<'a> Shaking<'a> {
    /// Shaking of a row with this many nodes. `travel` is `Some` if the motion does not arrive everywhere at once.
    pub(crate) fn new(n_nodes: usize, travel: Option<Travel>, excitation: Excitation<'a>, clock: Clock) -> Self {
        match travel {
            None => Self::Common(excitation.sampled(clock).collect()),
            Some(travel) => {
                let arrival = |node: usize| travel.arrival(node) / excitation.time_step();
                Self::Delayed(Delayed {
                    excitation,
                    arrivals: (0..n_nodes).map(arrival).collect(),
                    travel,
                    ratio: clock.time_step / excitation.time_step(),
                })
            }
        }
    }

    /// The ground at a node of the clock.
    #[inline]
    pub(crate) fn at(&self, step: usize) -> Ground<'_> {
        match self {
            Self::Common(samples) => Ground::Common(samples[step]),
            Self::Delayed(of) => Ground::Delayed { of, step, part: 0.0 },
        }
    }

    /// The ground at a part of the time step after a node of the clock; accelerations are linear in the step.
    pub(crate) fn within(&self, step: usize, part: f64) -> Ground<'_> {
        match self {
            Self::Common(samples) => {
                let rise = samples[step + 1] - samples[step];
                Ground::Common(samples[step] + part * rise)
            }
            Self::Delayed(of) => Ground::Delayed { of, step, part },
        }
    }
}

impl Ground<'_> {
    /// Acceleration of the ground under a node \[m/s²\].
    #[inline]
    pub(crate) fn under(self, node: usize) -> f64 {
        match self {
            Self::Common(acceleration) => acceleration,
            Self::Delayed { of, step, part } => of.acceleration(node, step, part),
        }
    }

    /// Deformation of a pair \[m\] whose left neighbour is displaced by `ahead` more than the right neighbour \[m\].
    #[inline]
    pub(crate) fn deformation(self, pair: &Pair, ahead: f64) -> f64 {
        match self {
            Self::Common(_) => ahead - pair.gap(),
            Self::Delayed { .. } => ahead + self.opening(pair).displacement - pair.gap(),
        }
    }

    /// Rate of deformation of a pair \[m/s\] whose left neighbour is faster than the right neighbour by `faster` \[m/s\].
    #[inline]
    pub(crate) fn rate(self, pair: &Pair, faster: f64) -> f64 {
        match self {
            Self::Common(_) => faster,
            Self::Delayed { .. } => faster + self.opening(pair).velocity,
        }
    }

    /// Deformation of a pair in these states of all structures \[m\]; positive if it overlaps.
    #[inline]
    pub(crate) fn deformation_of(self, pair: &Pair, states: &[State]) -> f64 {
        self.deformation(pair, pair.relation.ahead(|node| states[node].displacement))
    }

    /// Rate of deformation of a pair in these states \[m/s\], positive while approaching.
    #[inline]
    pub(crate) fn rate_of(self, pair: &Pair, states: &[State]) -> f64 {
        self.rate(pair, pair.relation.ahead(|node| states[node].velocity))
    }

    /// How far the grounds of a pair have moved towards each other, and at which rate; 0 if they move alike.
    #[inline]
    pub(crate) fn opening(self, pair: &Pair) -> Motion {
        self.opening_of(&pair.relation)
    }

    /// How far the grounds of two points have moved towards each other, and at which rate; 0 if they move alike.
    #[inline]
    pub(crate) fn opening_of(self, relation: &Relation) -> Motion {
        match self {
            Self::Common(_) => Motion::default(),
            Self::Delayed { of, step, part } => of.opening(relation, step, part),
        }
    }

    /// Magnitudes of the rounding of this opening and its rate.
    #[inline]
    pub(crate) fn extent(self, pair: &Pair) -> Motion {
        match self {
            Self::Common(_) => Motion::default(),
            Self::Delayed { of, step, part } => of.extent(&pair.relation, step, part),
        }
    }

    /// The ground earlier by a part of a time step; only for openings.
    pub(crate) fn earlier(self, by: f64) -> Self {
        match self {
            Self::Common(_) => self,
            Self::Delayed { of, step, part } => Self::Delayed { of, step, part: part - by },
        }
    }
}

impl Delayed<'_> {
    #[inline(never)] // Rows whose ground moves alike would share its registers.
    fn acceleration(&self, node: usize, step: usize, part: f64) -> f64 {
        let at = |step: usize| {
            let position = step as f64 * self.ratio - self.arrivals[node];
            self.excitation.at_position(position)
        };
        let start = at(step);
        if part > 0.0 { start + part * (at(step + 1) - start) } else { start }
    }

    fn grounds(&self, relation: &Relation, step: usize, part: f64) -> [Motion; 2] {
        let position = (step as f64 + part) * self.ratio;
        let under = |node: usize| self.travel.at(position - self.arrivals[node]);
        relation.points().map(|point| under(point.floor()))
    }

    #[inline(never)]
    fn opening(&self, relation: &Relation, step: usize, part: f64) -> Motion {
        let [left, right] = self.grounds(relation, step, part);
        left.since(right)
    }

    #[inline(never)]
    fn extent(&self, relation: &Relation, step: usize, part: f64) -> Motion {
        let [left, right] = self.grounds(relation, step, part);
        Motion {
            displacement: left.displacement.abs() + right.displacement.abs(),
            velocity: left.velocity.abs() + right.velocity.abs(),
        }
    }
}
