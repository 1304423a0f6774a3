//! Savings of models without unneeded features, on rows of 2 to 1000 structures.

use std::path::Path;

use pounding_scene::{Capacities, Damping, Error, Extras, Method, Sdof, Simulation, Structure};
use serde_json::json;

use crate::measure::{Outcome, RatioTable, Rounds, in_turn, median};
use crate::rows::timed_row;
use crate::setting::RECORD;

const TABLE: RatioTable = RatioTable {
    path: "results/savings.csv",
    title: "Wall time beside the lean row (no pairs, elastic, peaks and impulses alone)",
    header: "method,structures,burden,wall_time_ratio",
};
/// Lengths of the rows.
const LENGTHS: [usize; 4] = [2, 10, 100, 1000];
/// Least number and duration of runs of each row.
const ROUNDS: Rounds = Rounds::new(3, 2);

/// Times rows with a single additional feature against the lean row, in turn, and keeps the ratios of their medians.
pub(super) fn run(root: &Path) -> Outcome<()> {
    let methods = [
        ("exact", json!({"exact": {}})),
        ("central difference", json!({"central_difference": {"time_step_s": 0.005}})),
        ("Newmark", json!({"newmark": {"time_step_s": 0.005, "beta": 0.25, "gamma": 0.5}})),
    ];
    let order: Vec<usize> = (0..BURDENS.len()).collect();
    let mut lines = Vec::new();
    for (name, method) in methods {
        let method: Method = serde_json::from_value(method)?;
        for n in LENGTHS {
            let row = |(burden, _)| Burdened::new(n, method, burden, &root.join(RECORD));
            let rows = BURDENS.map(row).into_iter().collect::<Result<Vec<_>, _>>()?;
            let times = in_turn(&order, ROUNDS, |one| Ok(rows[one].run().map(drop)?))?;
            let medians: Vec<f64> = times.into_iter().map(median).collect();
            for ((_, burden), time) in BURDENS.iter().zip(&medians).skip(1) {
                let ratio = time / medians[0];
                lines.push(format!("{name},{n},{burden},{ratio:.2}"));
            }
        }
    }
    TABLE.write(root, &lines)
}

/// A feature of a row that the leanest one lacks.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Burden {
    /// No feature: elastic columns, no pairs, only peaks and impulses recorded.
    None,
    /// Columns that remember their yielding and never yield.
    Yielding,
    /// Neighbours as pairs that never touch.
    Pairs,
    /// Histories of every structure with a state every 0.02 s.
    Histories,
    /// The ledger.
    Ledger,
    /// Neighbours 5 cm apart, which touch.
    Touching,
}

/// All burdens with their words in the table, the leanest first.
const BURDENS: [(Burden, &str); 6] = [
    (Burden::None, "lean"),
    (Burden::Yielding, "columns that remember yielding"),
    (Burden::Pairs, "pairs out of reach"),
    (Burden::Histories, "histories"),
    (Burden::Ledger, "ledger"),
    (Burden::Touching, "pairs that touch"),
];

/// A row to time.
#[derive(Debug)]
struct Burdened {
    prepared: Simulation,
    burden: Burden,
}

/// Interval of histories \[s\].
const INTERVAL: f64 = 0.02;
/// Duration of a run \[s\].
const DURATION: f64 = 10.0;

impl Burdened {
    /// `n` structures with periods of 0.4 to 1.6 s under a record; in rows of up to a hundred all periods differ.
    ///
    /// # Errors
    /// [`Error`] if the record cannot be read.
    fn new(n: usize, method: Method, burden: Burden, record: &Path) -> Result<Self, Error> {
        let gap = match burden {
            Burden::Pairs => Some(10.0),
            Burden::Touching => Some(0.05),
            Burden::None | Burden::Yielding | Burden::Histories | Burden::Ledger => None,
        };
        let structures = (0..n).map(|index| structure(index, burden == Burden::Yielding)).collect();
        let prepared = timed_row(format!("{n} structures"), structures, gap, method, record, DURATION)?;
        Ok(Self { prepared, burden })
    }

    /// Runs the row.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early.
    fn run(&self) -> Result<(), Error> {
        if self.burden == Burden::Ledger {
            return self.prepared.audited(None).map(|_| ());
        }
        let histories = self.burden == Burden::Histories;
        let asked = Extras {
            interval: histories.then_some(INTERVAL),
            closings: !histories,
            ..Extras::default()
        };
        self.prepared.run_unjudged(asked).map(|_| ())
    }
}

/// A structure of a hundred tonnes. Multiples of a prime, modulo another, spread the periods.
fn structure(index: usize, remembers: bool) -> Structure {
    let period = 0.4 + 1.2 * ((index * 7919) % 101) as f64 / 101.0;
    let omega = 2.0 * std::f64::consts::PI / period;
    Structure::Sdof(Sdof {
        name: format!("structure {index}"),
        mass_kg: 1e5,
        stiffness_n_per_m: 1e5 * omega * omega,
        damping: Damping::Ratio(0.05),
        hardening_ratio: None,
        bouc_wen: None,
        yield_force_n: remembers.then_some(1e12),
        height_m: None,
        capacities: Capacities::default(),
        initial_displacement_m: 0.0,
        initial_velocity_m_per_s: 0.0,
    })
}
