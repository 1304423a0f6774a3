//! Energy and momentum of a floor and of the storey below it.

use super::columns::LedgerColumns;
use super::largest::Balances;
use super::{LedgerError, Terms};
use crate::{Excitation, Hysteretic, Motion, Path, Row, Span, State, Support, Weighed};

/// Account of a floor and its storey.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Account {
    /// Mass \[kg\]; 0 for a wall, which has no account.
    mass: f64,
    damping: f64,
    /// Part of the damping that yielding takes.
    elastic_damping: f64,
    support: Support,
    /// Arrival of the ground motion \[s\].
    arrival: f64,
    columns: LedgerColumns,
    /// Whether its first span or impact has come.
    open: bool,
    /// Strain energy at the start \[J\].
    first_strain: f64,
    pub(super) terms: Terms,
    /// Kinetic energy at the start \[J\].
    first_kinetic: f64,
    /// Momentum at the start \[N·s\].
    first_momentum: f64,
    momentum: f64,
    /// Work of the restoring force, with the weights of the method \[J\].
    restoring_work: f64,
    /// Impulses of everything that acts on the floor.
    impulses: Acting,
    /// Sum of the magnitudes of all terms, span by span and impact by impact \[J\]: each leaves its rounding.
    pub(super) booked: f64,
}

/// Works \[J\] or impulses \[N·s\] on a floor of everything that acts on it.
///
/// For a motion known between its ends, those of columns and damping belong to the storey below the floor: works on its drift, and impulses
/// from the ground. For a step they are the net action on the floor. Summed over a building, both are equal.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Acting {
    restoring: f64,
    damping: f64,
    ground: f64,
    pub(super) from_left: f64,
    pub(super) from_right: f64,
    impacts: f64,
    links: f64,
}

impl Acting {
    fn besides_impacts([restoring, damping, ground, from_left, from_right]: [f64; 5]) -> Self {
        Self {
            restoring,
            damping,
            ground,
            from_left,
            from_right,
            impacts: 0.0,
            links: 0.0,
        }
    }

    fn all(&self) -> [f64; 7] {
        [
            self.restoring,
            self.damping,
            self.ground,
            self.from_left,
            self.from_right,
            self.impacts,
            self.links,
        ]
    }

    fn magnitude(&self) -> f64 {
        self.all().iter().map(|part| part.abs()).sum()
    }

    fn add(&mut self, other: &Self) {
        self.restoring += other.restoring;
        self.damping += other.damping;
        self.ground += other.ground;
        self.from_left += other.from_left;
        self.from_right += other.from_right;
        self.impacts += other.impacts;
        self.links += other.links;
    }
}

impl Account {
    pub(super) fn new<Column: Hysteretic>(row: &Row<Column>, index: usize) -> Self {
        let node = &row.nodes()[index];
        let columns = LedgerColumns::new(node.column.hysteresis());
        let drift = match node.support.below() {
            None => node.initial_displacement,
            Some(below) => node.initial_displacement - row.nodes()[below].initial_displacement,
        };
        let force = node.column.loaded(drift).force;
        Self {
            mass: if node.is_wall() { 0.0 } else { 1.0 / node.inverse_mass },
            damping: node.damping,
            elastic_damping: node.elastic_damping,
            support: node.support,
            arrival: row.arrival(index),
            columns,
            open: false,
            first_strain: columns.strain(force, drift),
            terms: Terms::default(),
            first_kinetic: 0.0,
            first_momentum: 0.0,
            momentum: 0.0,
            restoring_work: 0.0,
            impulses: Acting::default(),
            booked: 0.0,
        }
    }

    /// Books a span; returns the works on the floor in it.
    pub(super) fn span(&mut self, span: &Span<'_>, excitation: &Excitation<'_>) -> Acting {
        if self.mass == 0.0 {
            return Acting::default();
        }
        let drifts = span.drifts();
        if !self.open {
            self.start(span.start.velocity, self.strain(&span.start, drifts[0]));
        }
        let (works, impulses) = match span.path {
            Path::Cubic(weighed) => self.weighed(span, weighed),
            Path::Series(_) | Path::Flight(_) => self.integrated(span, excitation),
        };
        self.impulses.add(&impulses);
        self.restoring_work += works.restoring;
        self.booked += works.magnitude();
        let (flow, kinetic) = (self.columns.flow(span, drifts), self.kinetic(&span.end));
        let strain = self.strain(&span.end, drifts[1]);
        let terms = &mut self.terms;
        terms.input += works.ground;
        terms.damping -= works.damping;
        terms.contact -= works.from_left + works.from_right;
        terms.hysteretic += flow;
        (terms.kinetic, terms.strain) = (kinetic, strain);
        self.booked += kinetic + strain.abs() + flow.abs();
        self.momentum = self.mass * span.end.velocity;
        works
    }

    /// Books an impact: the impulse on the floor \[N·s\], and its velocities before and after \[m/s\].
    pub(super) fn impact(&mut self, impulse: f64, before: f64, after: f64) {
        if self.mass > 0.0 {
            if !self.open {
                self.start(before, self.first_strain);
            }
            self.impulses.impacts += impulse;
            self.terms.impact -= 0.5 * impulse * (before + after);
            self.terms.kinetic = 0.5 * self.mass * (after * after);
            self.booked += self.terms.kinetic + 0.5 * (impulse * (before + after)).abs();
            self.momentum = self.mass * after;
        }
    }

    /// Books the impulse \[N·s\] of a link on the floor, and its work \[J\].
    pub(super) fn link(&mut self, impulse: f64, work: f64) {
        if self.mass > 0.0 {
            self.impulses.links += impulse;
            self.terms.link -= work;
            self.booked += work.abs();
        }
    }

    /// Books the work on the floor, through a link, of grounds that move towards each other \[J\].
    pub(super) fn open_link(&mut self, work: f64) {
        self.terms.opening += work;
        self.terms.link += work;
    }

    /// Books the work on the floor, through compliant contact, of grounds that move towards each other \[J\].
    pub(super) fn open_contact(&mut self, work: f64) {
        self.terms.opening += work;
        self.terms.contact += work;
    }

    /// Books the work on the floor, through an impact, of grounds that move towards each other \[J\].
    pub(super) fn open_impact(&mut self, work: f64) {
        self.terms.opening += work;
        self.terms.impact += work;
    }

    /// Checks that columns give no energy when they yield, from an earlier hysteretic energy \[J\] to the end of a span.
    pub(super) fn flowed(&self, earlier: f64, span: &Span<'_>) -> Result<(), LedgerError> {
        let found = earlier - self.terms.hysteretic;
        if found <= 0.0 {
            return Ok(());
        }
        let allowed = self.columns.forgiven(earlier, span);
        if found <= allowed {
            return Ok(());
        }
        Err(LedgerError::GainInYielding {
            structure: span.structure,
            time: span.end_time,
            found,
            allowed,
        })
    }

    /// Starts the account at a velocity and a strain energy: those of the first span, or before an impact at the very start.
    fn start(&mut self, velocity: f64, strain: f64) {
        self.open = true;
        self.first_kinetic = 0.5 * self.mass * (velocity * velocity);
        self.first_momentum = self.mass * velocity;
        self.momentum = self.first_momentum;
        self.terms.initial = self.first_kinetic + strain;
        // A neighbour's span may be checked before the first span of this floor.
        (self.terms.kinetic, self.terms.strain) = (self.first_kinetic, strain);
    }

    fn kinetic(&self, state: &State) -> f64 {
        0.5 * self.mass * (state.velocity * state.velocity)
    }

    /// Strain energy of the storey, at its drift.
    fn strain(&self, state: &State, drift: Motion) -> f64 {
        self.columns.strain(state.restoring_force, drift.displacement)
    }

    /// Works and impulses of a step. Each work is the impulse, with the weights of the method, times the mean velocity. If the sum of
    /// impulses is the change of momentum, the sum of works is then the change of kinetic energy.
    fn weighed(&self, span: &Span<'_>, weighed: Weighed) -> (Acting, Acting) {
        let impulses = [
            weighed.restoring,
            weighed.damping,
            -self.mass * weighed.ground_velocity,
            span.impulse_from_left,
            span.impulse_from_right,
        ];
        let mean = 0.5 * (span.start.velocity + span.end.velocity);
        let works = impulses.map(|impulse| mean * impulse);
        (Acting::besides_impacts(works), Acting::besides_impacts(impulses))
    }

    /// Works and impulses of a motion known between its ends: integrals over time, between the samples of the ground motion.
    ///
    /// Forces are known by storey. Those of the storey above act on this floor, too. Combined with their action on the floor above, they
    /// give works on a drift, and impulses that cancel.
    fn integrated(&self, span: &Span<'_>, excitation: &Excitation<'_>) -> (Acting, Acting) {
        let to_ground = self.support.ground_damping();
        let missing = if self.columns.yields(span) { self.elastic_damping } else { 0.0 };
        let storey = self.damping - missing;
        let from_ground = match self.support {
            Support::Ground => 1.0,
            Support::Floor(_) => 0.0,
        };
        let (mut works, mut impulses) = (Acting::default(), Acting::default());
        let mut from = span.start_time;
        while from < span.end_time {
            let segment = excitation.segment(from, self.arrival);
            let to = segment.end.min(span.end_time);
            let [force, damping, ground, left, right, works_of @ ..] = span.integrate_between(from, to, |time, state, drift| {
                let (v, rate) = (state.velocity, drift.velocity);
                let (force, damping) = (-state.restoring_force, -storey * rate);
                let outside = -to_ground * v;
                let ground = -self.mass * (segment.value + segment.slope * (time - from));
                let (left, right) = (state.force_from_left, state.force_from_right);
                [
                    from_ground * force,
                    from_ground * damping + outside,
                    ground,
                    left,
                    right,
                    force * rate,
                    damping * rate + outside * v,
                    ground * v,
                    left * v,
                    right * v,
                ]
            });
            impulses.add(&Acting::besides_impacts([force, damping, ground, left, right]));
            works.add(&Acting::besides_impacts(works_of));
            from = to;
        }
        (works, impulses)
    }

    /// Imbalances of the floor; they vanish in the sum over a building.
    #[inline]
    pub(super) fn balances(&self) -> Balances {
        Balances {
            identity: self.identity(),
            residual: self.terms.balance(),
            momentum: self.momentum(),
        }
    }

    /// Change of kinetic energy minus the works \[J\].
    fn identity(&self) -> f64 {
        let terms = &self.terms;
        let works = self.restoring_work + terms.input + terms.opening - terms.damping - terms.contact - terms.impact - terms.link;
        terms.kinetic - self.first_kinetic - works
    }

    /// Change of momentum minus the impulses \[N·s\].
    fn momentum(&self) -> f64 {
        self.momentum - self.first_momentum - self.impulses.all().iter().sum::<f64>()
    }

    /// Momentum at the start plus the magnitudes of momentum and impulses \[N·s\].
    pub(super) fn momentum_magnitude(&self) -> f64 {
        let sums = self.impulses.all().iter().map(|sum| sum.abs()).sum::<f64>();
        self.first_momentum.abs() + self.momentum.abs() + sums
    }
}
