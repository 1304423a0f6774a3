//! Many scenes at once, in the lanes of the machine's vectors.
//!
//! Rows of a common shape with different numbers run together by central differences ([`SideBySide`]) or by the exact method
//! ([`ExactSideBySide`]). Every operation of a step acts on up to eight scenes at once. The formulas are those of the solver, generic over
//! [`Number`](pounding_contact::Number). By central differences every lane gives exactly the bits of its scene alone. A step evaluates
//! contact laws only if some lane touches. The results are peaks and sums ([`SceneSums`]); for histories, run a scene alone.
//!
//! Buildings of several storeys run in lanes, too: a single loop solves their equations for one scene and for many. `Frame` chooses once
//! per run whether structures advance separately or by buildings.
//!
//! Pairs may join any points. Impacts of pairs that are no [chain](Row::is_chain) are solved lane by lane, and their closings are not
//! recorded.
//!
//! Links may be springs, which may yield, and dashpots. With them, every step costs as much as one in contact.
//!
//! Not in this crate: other methods, motions that travel, sub-steps in contact, columns that yield smoothly, and links of other kinds.
//!
//! Where to start: [`SideBySide`], then `group.rs`, a group of as many scenes as there are lanes. For the exact method: `exact/mod.rs`.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

mod body;
mod books;
mod closings;
mod column;
mod exact;
mod excitations;
mod frame;
mod group;
mod law;
mod links;
mod number;
mod points;
mod rows;
mod run;
mod scenes;
mod storeys;
mod strikes;
mod tallies;
mod tally;
#[cfg(all(test, target_arch = "x86_64"))]
mod tests;

use fearless_simd::{Level, dispatch};

pub use column::RowsOf;
use column::SideBySideColumn;
pub use exact::ExactSideBySide;
pub use excitations::Excitations;
use excitations::Grounds;
use run::Task;
pub use tallies::{PairSums, SceneSums};

use pounding_solver::formulas::{is_plastic, require};
use pounding_solver::{Budget, CentralDifference, Clock, Link, Pair, Point, Relation, RestoringForce, Row, RunError};

/// Ground motions and the clock of the central difference method, under which many rows run.
#[derive(Debug, Clone)]
pub struct SideBySide<'a> {
    clock: Clock,
    excitations: Excitations<'a>,
    /// Acceleration of a common motion at every node \[m/s²\]. Separate motions are sampled when their scenes run.
    common: Vec<f64>,
    level: Level,
    budget: Budget,
    closings: bool,
}

/// Settings that groups need.
struct Shaken {
    time_step: f64,
    budget: Budget,
    /// Whether the closing of neighbours is recorded.
    closings: bool,
}

/// Structure steps between two checks of the stop flag: a fraction of a second.
const BETWEEN: usize = 1 << 16;

impl<'a> SideBySide<'a> {
    /// Samples the ground motions for the clock of the longest run.
    ///
    /// # Errors
    /// [`RunError::Setting`] if a setting is out of range, or if there are sub-steps in contact.
    pub fn new(settings: CentralDifference, excitations: impl Into<Excitations<'a>>, clock: Clock) -> Result<Self, RunError> {
        settings.check()?;
        let substeps = settings.contact_substeps;
        let allowed = "1 side by side; scenes with more run alone";
        require(substeps == 1, "contact_substeps", substeps.into(), allowed)?;
        let excitations = excitations.into();
        let common = match excitations {
            Excitations::Common(excitation) => excitation.sampled(clock).collect(),
            Excitations::Each(_) => Vec::new(),
        };
        Ok(Self {
            clock,
            excitations,
            common,
            level: Level::new(),
            budget: Budget::default(),
            closings: false,
        })
    }

    /// Also ends runs when the budget's `stop` is set; unfinished scenes are then not told. The rest of the budget is ignored.
    #[must_use]
    pub fn within(self, budget: Budget) -> Self {
        Self { budget, ..self }
    }

    /// Also records how far neighbours come towards each other ([`PairSums::closing`]), which must form a [chain](Row::is_chain). This slows
    /// down steps without contact.
    #[must_use]
    pub fn with_closings(self, closings: bool) -> Self {
        Self { closings, ..self }
    }

    /// Whether lanes take a link: a spring, which may yield, a dashpot, or both.
    pub fn takes_link(link: &Link) -> bool {
        links::spring(link).is_some()
    }

    /// Whether two rows have equal floors and pairs on the same floors, with laws of equal kinds. The ground motion must arrive everywhere at
    /// once in the first row, no damping may follow the tangent stiffness, and links on the same floors must be springs and dashpots.
    pub fn are_alike<Column: RestoringForce>(row: &Row<Column>, other: &Row<Column>) -> bool {
        let kind = |pair: &Pair| std::mem::discriminant(&pair.law);
        let at_once = (0..row.nodes().len()).all(|node| row.arrival(node) == 0.0);
        let mut pairs = row.pairs().iter().zip(other.pairs());
        let mut nodes = row.nodes().iter().zip(other.nodes());
        let mut links = row.links().iter().zip(other.links());
        let are_springs = |link: &Link, other: &Link| Self::takes_link(link) && Self::takes_link(other);
        at_once
            && !row.has_tangent_damping()
            && !other.has_tangent_damping()
            && row.links().len() == other.links().len()
            && links.all(|(link, other)| are_on_equal_floors(link.relation, other.relation) && are_springs(link, other))
            && row.nodes().len() == other.nodes().len()
            && nodes.all(|(node, other)| node.support.below() == other.support.below())
            && row.pairs().len() == other.pairs().len()
            && pairs.all(|(pair, other)| are_on_equal_floors(pair.relation, other.relation) && kind(pair) == kind(other))
    }

    /// Runs rows of a common shape, each for its number of steps, and stores their results. Returns false without any result if they cannot
    /// run in lanes.
    ///
    /// Rows of a common shape [are alike](Self::are_alike). No row may have more steps than the clock. If each scene has its own ground
    /// motion, the motions must be as many as the rows.
    pub fn run(&self, rows: RowsOf<'_>, n_steps: &[usize], tallies: &mut SceneSums) -> bool {
        match rows {
            RowsOf::Elastic(rows) => self.run_alike(rows, n_steps, tallies),
            RowsOf::Bilinear(rows) => self.run_alike(rows, n_steps, tallies),
        }
    }

    fn run_alike<Column: SideBySideColumn>(&self, rows: &[&Row<Column>], n_steps: &[usize], tallies: &mut SceneSums) -> bool {
        let reach = 1..=self.clock.n_steps;
        let in_reach = rows.len() == n_steps.len() && n_steps.iter().all(|n| reach.contains(n));
        let in_reach = in_reach && self.excitations.are_for(rows.len());
        let closes = |row: &Row<Column>| !self.closings || row.is_chain();
        let Some(first) = rows.first().filter(|row| in_reach && are_alike(rows) && closes(row)) else {
            tallies.begin(0, 0, 0);
            return false;
        };
        tallies.begin(rows.len(), first.nodes().len(), first.pairs().len());
        let task = Task {
            rows,
            n_steps,
            grounds: match self.excitations {
                Excitations::Common(_) => Grounds::Common(&self.common),
                Excitations::Each(each) => Grounds::own(each, self.clock.time_step),
            },
            tallies,
        };
        let method = Shaken {
            time_step: self.clock.time_step,
            budget: self.budget,
            closings: self.closings,
        };
        dispatch!(self.level, simd => run::run(simd, &method, task));
        let is_compliant = |pair: &Pair| pair.law.is_compliant();
        let both = first.pairs().iter().any(is_compliant) && !first.pairs().iter().all(is_compliant);
        // The impacts of a rest are one collision, which only a run of the scene alone can count.
        for (scene, row) in rows.iter().enumerate() {
            if both {
                // The books do not contain velocity jumps during compliant contact.
                tallies.doubt(scene);
            }
            let several = |pair: usize| tallies.pair(scene, pair).collisions > 1.0;
            let mut pairs = row.pairs().iter().enumerate();
            if pairs.any(|(pair, of)| is_plastic(of) && several(pair)) {
                tallies.told[scene] = false;
            }
        }
        true
    }
}

/// Whether two relations have their points on the same floors; points between floors may be anywhere nearer to the same one.
fn are_on_equal_floors(one: Relation, other: Relation) -> bool {
    let mut points = one.points().into_iter().zip(other.points());
    points.all(|points| match points {
        (Point::Share(one), Point::Share(other)) => (one.base, one.other) == (other.base, other.other),
        (one, other) => one == other,
    })
}

/// Whether rows have a common shape that can run in lanes.
fn are_alike<Column: RestoringForce>(rows: &[&Row<Column>]) -> bool {
    rows.iter().all(|row| SideBySide::are_alike(row, rows[0]))
}
