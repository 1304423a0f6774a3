//! What it saves to model only what a scene requires: rows of any length, leaner and richer, to be timed.

use crate::StudyError;
use crate::listed::listed;
use crate::research::floor_cost::timed_row;
use pounding_scene::{Damping, Extras, Method, Sdof, Simulation, Structure};
use std::path::Path;

listed! {
    /// What a row does that the leanest one leaves out: in the words of a table.
    pub enum Burden { name: &'static str;
        /// Nothing: elastic columns, no pairs, peaks and impulses recorded, nothing else.
        None = "lean",
        /// Columns that remember their yielding and never yield.
        Yielding = "columns that remember yielding",
        /// Neighbours as pairs that never touch.
        Pairs = "pairs out of reach",
        /// Histories of every structure with a state every 0.02 s.
        Histories = "histories",
        /// The ledger.
        Ledger = "ledger",
        /// Neighbours 5 cm apart, which touch.
        Touching = "pairs that touch",
    }
}

/// A row to be timed.
#[derive(Debug)]
pub struct Burdened {
    prepared: Simulation,
    burden: Burden,
}

/// Interval of histories \[s\].
const INTERVAL: f64 = 0.02;
/// Duration of a run \[s\].
const DURATION: f64 = 10.0;

impl Burdened {
    /// So many structures with periods of 0.4 to 1.6 s, all different in rows of up to a hundred, under a record.
    ///
    /// # Errors
    /// [`StudyError`] when the record cannot be read.
    pub fn new(n: usize, method: Method, burden: Burden, record: &Path) -> Result<Self, StudyError> {
        let gap = match burden {
            Burden::Pairs => Some(10.0),
            Burden::Touching => Some(0.05),
            Burden::None | Burden::Yielding | Burden::Histories | Burden::Ledger => None,
        };
        let structures = (0..n).map(|index| structure(index, burden == Burden::Yielding)).collect();
        let prepared = timed_row((format!("{n} structures"), structures), gap, method, (record, DURATION))?;
        Ok(Self { prepared, burden })
    }

    /// Runs the row.
    ///
    /// # Errors
    /// [`pounding_scene::Error::Run`] when the run ends early.
    pub fn run(&self) -> Result<(), pounding_scene::Error> {
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

/// Structures of a hundred tonnes; the multiples of a prime, modulo another, spread the periods.
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
        initial_displacement_m: 0.0,
        initial_velocity_m_per_s: 0.0,
    })
}
