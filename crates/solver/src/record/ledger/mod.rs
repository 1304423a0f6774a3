//! The energy and impulse ledger of a run.

mod account;
mod columns;
mod contact;
mod error;
mod largest;
mod link;
mod opening;
mod sightings;
mod terms;

pub use contact::PairTerms;
pub use error::LedgerError;
pub use link::LinkTerms;
pub use terms::Terms;

use account::Account;
use contact::{ContactAccount, Push};
use largest::{Balances, Largest};
use link::LinkAccount;
use opening::{opening_part, work_of};
use sightings::Sightings;

use crate::model::buildings::Buildings;
use crate::model::incidence::{Incidence, Incident};
use crate::span::Expansion;
use crate::{Excitation, Hysteretic, Impact, Path, Recorder, Row, Span, Travel};

/// Records the energy of every building, and the energy and impulse of every pair.
///
/// If a method knows the motion between its nodes ([`Path::Series`](crate::Path::Series)), works on a building are integrals over this
/// motion. In a step they are the impulses, with the method's weights of the forces, times the mean velocity of the step. The change of
/// kinetic energy then equals the sum of the works to rounding, for any step, and [`identity`](Self::identity) detects a method whose
/// report differs from its computation. The accuracy of the step shows in the comparison of works with energies
/// ([`residual`](Self::residual)), and in the distance from the ledger of a more accurate run ([`error`](Self::error)).
///
/// Kinetic energy, input and contact are booked with a floor, strain and yielding with the storey below it. For a motion known between its
/// nodes, damping is that of the storey and of the floor against the ground. In a step it is all damping on the floor. Energies balance
/// over the floors of a building, at instants at which all of them have been seen. A structure of one storey is a building with one floor.
///
/// Largest values over time are updated once per step of all floors. Pieces of motions known between their nodes end at different instants:
/// for them the update follows every piece, or every n/16th piece in rows of n > 16 nodes.
///
/// Signs: input counts positive into the row, all other terms positive out of the motion; see [`Terms`].
#[derive(Debug, Clone, PartialEq)]
pub struct Ledger<'a> {
    excitation: Excitation<'a>,
    /// How the motion travels along the row; `None` if all are shaken at once.
    travel: Option<Travel>,
    /// Account of each node.
    accounts: Vec<Account>,
    buildings: Buildings,
    sightings: Sightings,
    contacts: Vec<ContactAccount>,
    links: Vec<LinkAccount>,
    /// Incidence of pairs and floors.
    incidence: Incidence,
    /// The impacts since the last time that all pairs were apart.
    meeting: Option<Meeting>,
    /// Number of pairs that have not parted since their last impact.
    n_meeting: usize,
    largest: Largest,
    /// Number of nodes that are not walls.
    n_floors: usize,
    /// Spans since the last update of the largest values.
    unmeasured: usize,
    laws: Laws,
    violation: Option<LedgerError>,
}

/// The laws of mechanics that a run must obey.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub enum Laws {
    /// All laws that hold for any step: contact does not pull, nothing creates energy, impulses are opposite.
    #[default]
    All,
    /// All laws, and conservation of energy to [rounding](Ledger::bound), for a method that knows its motion between nodes.
    Energy {
        /// Relative truncation error of a piece of the motion \[–\]; see [`Exact::tolerance`](crate::Exact::tolerance).
        tolerance: f64,
    },
}

/// A collision of impulsive pairs: all impacts until every pair that was hit has parted.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Meeting {
    start: f64,
    end: f64,
    pair: usize,
    loss: f64,
    allowed: f64,
}

/// Rounding tolerance of the velocities around an impact, relative to them; it includes the rounding of the run before.
const ROUNDING: f64 = 1e-12;
/// Energy that a compliant collision may create, relative to the scale.
///
/// When almost nothing moves yet, the steps resolve nothing. In 400 random rows, no other collision gave back more than its steps allow,
/// and none of these as much as 1e-8 of the scale.
const NEGLIGIBLE: f64 = 1e-6;
/// Least bound of the residual of an exact run.
///
/// Of 845 exact runs of the extremes the worst leaves 4.3e-14 (a mass ratio of a million); a million steps without damping leave 2.8e-14.
const LEAST_BOUND: f64 = 1e-11;
/// Nodes that an update may evaluate per piece. This bounds the cost per piece in long rows.
const LOOKED_AT_PER_PIECE: usize = 16;

impl<'a> Ledger<'a> {
    /// A ledger for a run of this row under this excitation.
    pub fn new<Column: Hysteretic>(row: &Row<Column>, excitation: Excitation<'a>) -> Self {
        Self {
            excitation,
            travel: row.travel(excitation),
            accounts: (0..row.nodes().len()).map(|node| Account::new(row, node)).collect(),
            buildings: row.buildings().clone(),
            sightings: Sightings::new(row.buildings()),
            contacts: row.pairs().iter().map(ContactAccount::new).collect(),
            links: row.links().iter().map(LinkAccount::new).collect(),
            incidence: row.incidence().clone(),
            meeting: None,
            n_meeting: 0,
            largest: Largest::default(),
            n_floors: row.nodes().iter().filter(|node| !node.is_wall()).count(),
            unmeasured: 0,
            laws: Laws::All,
            violation: None,
        }
    }

    /// Sets the laws for the [verdict](Self::verdict); the default is [`Laws::All`].
    #[must_use]
    pub fn held_to(self, laws: Laws) -> Self {
        Self { laws, ..self }
    }

    /// Terms of a floor and its storey at the end of its last span, by its node; all 0 for a wall.
    ///
    /// The terms of a structure of one storey balance. Those of a building balance in the sum over its floors ([`Self::of_building`]).
    pub fn of(&self, structure: usize) -> &Terms {
        &self.accounts[structure].terms
    }

    /// Terms of the building that contains a node: the sum over its floors.
    pub fn of_building(&self, node: usize) -> Terms {
        let mut sum = Terms::default();
        for floor in self.buildings.floors(self.buildings.of(node)) {
            sum += self.accounts[*floor].terms;
        }
        sum
    }

    /// Terms of a pair, by its index in the row.
    pub fn of_pair(&self, pair: usize) -> PairTerms {
        self.contacts[pair].terms()
    }

    /// Terms of a link, by its index in the row.
    pub fn of_link(&self, link: usize) -> LinkTerms {
        self.links[link].terms()
    }

    /// Terms of the row: the sum over its floors.
    pub fn terms(&self) -> Terms {
        let mut sum = Terms::default();
        for account in &self.accounts {
            sum += account.terms;
        }
        sum
    }

    /// Scale of energies \[J\]: the largest value over time of the row's initial energy plus the magnitudes of its other terms.
    pub fn scale(&self) -> f64 {
        self.measured().scale
    }

    /// The method's own balance: the largest over time of |change of kinetic energy − works| of a building, summed over buildings, relative
    /// to the [scale](Self::scale) \[–\].
    ///
    /// It is 0 to rounding (1e-12) for every method and every step. A larger value is a fault of the method.
    pub fn identity(&self) -> f64 {
        let largest = self.measured();
        ratio(largest.identity, largest.scale)
    }

    /// The physical balance: the largest over time of |[`Terms::balance`]| of a building, summed over buildings, relative to the
    /// [scale](Self::scale) \[–\].
    ///
    /// It tends to 0 with the time step, at the order of the method. For a method that knows its motion between nodes it is rounding. It
    /// does not measure the error: average acceleration balances elastic structures at every step.
    pub fn residual(&self) -> f64 {
        let largest = self.measured();
        ratio(largest.residual, largest.scale)
    }

    /// The largest [residual](Self::residual) \[–\] that rounding and the tolerance of the method explain in a correct run. `None` if the
    /// run is not [required](Self::held_to) to conserve energy, because a step leaves more.
    pub fn bound(&self) -> Option<f64> {
        let Laws::Energy { tolerance } = self.laws else {
            return None;
        };
        let booked: f64 = self.accounts.iter().map(|account| account.booked).sum();
        // Rounding errors have either sign and add up to less than this in a long run; truncation errors may add up.
        let left = (f64::EPSILON + tolerance) * booked;
        Some(ratio(left, self.scale()).max(LEAST_BOUND))
    }

    /// Balance of momentum: the largest over time of |change of momentum − impulses| of a building, summed over buildings, relative to the
    /// largest sum of their magnitudes \[–\]; 0 up to rounding.
    ///
    /// The impulses of a pair cancel: the momentum of the row is its initial value plus the external impulses.
    pub fn momentum(&self) -> f64 {
        let largest = self.measured();
        ratio(largest.momentum, largest.momentum_scale)
    }

    /// Energy error against the ledger of the true motion of the row: the largest difference of a [term](Self::terms) at the end, relative
    /// to the [scale](Self::scale) of the true motion \[–\].
    pub fn error(&self, truth: &Ledger<'_>) -> f64 {
        ratio(self.terms().distance(&truth.terms()), truth.scale())
    }

    /// The terms of the row, if the run obeyed the laws of mechanics.
    ///
    /// # Errors
    /// [`LedgerError`] with the first violation in time by neighbours that pull, impacts that create energy or columns that give energy in
    /// yielding. Otherwise: a compliant collision that creates energy, a pair without opposite impulses, or energy that rounding does not
    /// explain.
    pub fn verdict(&self) -> Result<Terms, LedgerError> {
        if let Some(violation) = self.violation {
            return Err(violation);
        }
        if let Some(meeting) = &self.meeting {
            meeting.judge()?;
        }
        let scale = self.scale();
        for (pair, contact) in self.contacts.iter().enumerate() {
            contact.gives(pair, NEGLIGIBLE * scale)?;
            contact.balanced(pair)?;
        }
        for (link, account) in self.links.iter().enumerate() {
            account.balanced(link)?;
        }
        let found = self.residual();
        match self.bound() {
            // Rounding does not explain NaN.
            Some(allowed) if found > allowed || found.is_nan() => Err(LedgerError::EnergyUnexplained { found, allowed }),
            _ => Ok(self.terms()),
        }
    }

    /// Books a span that is no flight.
    fn book(&mut self, span: &Span<'_>) {
        let account = &mut self.accounts[span.structure];
        let hysteretic = account.terms.hysteretic;
        let works = account.span(span, &self.excitation);
        let outcome = account.flowed(hysteretic, span);
        self.judge(outcome);
        self.sightings.see(&self.buildings, span.structure, span.end_time);
        self.n_meeting -= self.count_at(span.structure);
        let ground = self
            .travel
            .as_ref()
            .map_or(0.0, |travel| travel.ground(span.structure, span.end_time).displacement);
        let momentum = self.accounts[span.structure].momentum_magnitude();
        for (index, push) in span.pushes.iter().enumerate() {
            let open = self.opened(span, index);
            let together = if push.on_left { works.from_right } else { works.from_left };
            let push_on = Push {
                times: (span.start_time, span.end_time),
                displacement: span.end.displacement,
                ground,
                exact: !matches!(span.path, Path::Cubic(_)),
                forces: (push.forces[0], push.forces[1]),
                impulse: push.impulse,
                momentum,
                work: work_of(span, push, together) - open,
            };
            let outcome = self.contacts[push.pair].push(push.pair, span.structure, &push_on);
            self.judge(outcome);
        }
        for push in span.links {
            self.link(span, push);
        }
        self.n_meeting += self.count_at(span.structure);
        if self.meeting.is_some() && self.n_meeting == 0 {
            let ended = self.meeting.take();
            self.judge(ended.map_or(Ok(()), |meeting| meeting.judge()));
        }
        self.measure(match span.path {
            Path::Cubic(_) => self.n_floors,
            Path::Series(_) | Path::Flight(_) => self.accounts.len().div_ceil(LOOKED_AT_PER_PIECE),
        });
    }

    fn judge(&mut self, outcome: Result<(), LedgerError>) {
        let Err(violation) = outcome else {
            return;
        };
        // An energy is known to the rounding of all booked terms.
        let rounding = match violation {
            LedgerError::GainAtImpact { found, .. } | LedgerError::GainInContact { found, .. } => found <= ROUNDING * self.scale(),
            LedgerError::Tension { .. }
            | LedgerError::PullingImpact { .. }
            | LedgerError::GainInYielding { .. }
            | LedgerError::Imbalance { .. }
            | LedgerError::LinkImbalance { .. }
            | LedgerError::EnergyUnexplained { .. } => false,
        };
        if !rounding {
            self.violation.get_or_insert(violation);
        }
    }

    /// The largest values over time, including this instant.
    fn measured(&self) -> Largest {
        let (mut row, mut now) = (Terms::default(), Largest::default());
        if self.buildings.are_single() {
            for account in &self.accounts {
                row += account.terms;
                now.add(account.balances(), account.momentum_magnitude());
            }
        } else {
            for building in self.buildings.each() {
                let mut sums = Balances::default();
                for floor in building {
                    let account = &self.accounts[*floor];
                    row += account.terms;
                    sums += account.balances();
                    now.momentum_scale += account.momentum_magnitude();
                }
                now.add(sums, 0.0);
            }
        }
        now.scale = row.magnitude();
        self.largest.max(now)
    }

    /// Updates the largest values over time after this many spans; the update evaluates every node. It waits until no building is in the
    /// middle of a step.
    fn measure(&mut self, spans: usize) {
        self.unmeasured += 1;
        if self.unmeasured >= spans && self.sightings.are_whole() {
            self.largest = self.measured();
            self.unmeasured = 0;
        }
    }

    /// Number of pairs at a floor that have not parted since their last impact; call it before and after each change.
    fn count_at(&self, floor: usize) -> usize {
        let meets = |at: &&Incident| self.contacts[at.pair].meets();
        self.incidence.at(floor).iter().filter(meets).count()
    }
}

/// `part`/`whole`; 0 if nothing moved.
fn ratio(part: f64, whole: f64) -> f64 {
    if part == 0.0 { 0.0 } else { part / whole }
}

impl Meeting {
    /// Checks that a collision creates no energy.
    ///
    /// A single impact may create energy. A stepping method can hit a pair again that still overlaps. Of several pairs that are hit
    /// together, a pair can gain energy that another loses.
    fn judge(&self) -> Result<(), LedgerError> {
        if self.loss >= -self.allowed {
            return Ok(());
        }
        Err(LedgerError::GainAtImpact {
            pair: self.pair,
            start: self.start,
            end: self.end,
            found: -self.loss,
            allowed: self.allowed,
        })
    }
}

impl Recorder for Ledger<'_> {
    #[inline]
    fn reads_weighed(&self) -> bool {
        true
    }

    fn span(&mut self, span: &Span<'_>) {
        match span.path {
            Path::Flight(_) => self.book(&span.expanded(&mut Expansion::default())),
            Path::Cubic(_) | Path::Series(_) => self.book(span),
        }
    }

    fn impact(&mut self, impact: &Impact) {
        let (before, after) = (impact.before, impact.after);
        let impulse = impact.impulse;
        for struck in impact.struck() {
            let [before, after] = struck.velocities;
            self.accounts[struck.floor].impact(struck.part * impulse, before, after);
        }
        let rates = impact.rates();
        let loss = 0.5 * impulse * (rates[0] + rates[1]);
        for struck in impact.struck() {
            let part = opening_part(impact.struck().map(|other| other.part), struck.part);
            self.accounts[struck.floor].open_impact(part * impulse * impact.opening_rate);
        }
        let met = usize::from(self.contacts[impact.pair].meets());
        self.contacts[impact.pair].impact(impact.time, impulse, loss);
        let meets = usize::from(self.contacts[impact.pair].meets());
        self.n_meeting += meets - met;
        if impulse < 0.0 {
            self.judge(Err(LedgerError::PullingImpact {
                pair: impact.pair,
                time: impact.time,
                found: impulse,
            }));
        }
        let speeds = [before.left, before.right, after.left, after.right, impact.opening_rate];
        let meeting = self.meeting.get_or_insert(Meeting {
            start: impact.time,
            end: impact.time,
            pair: impact.pair,
            loss: 0.0,
            allowed: 0.0,
        });
        meeting.end = impact.time;
        meeting.loss += loss;
        meeting.allowed += ROUNDING * impulse.abs() * speeds.iter().map(|speed| speed.abs()).sum::<f64>();
    }
}

#[cfg(test)]
mod tests;
