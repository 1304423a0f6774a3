//! What it saves to model only what a scene requires: rows of any length, leaner and richer, to be timed.

use crate::StudyError;
use pounding_contact::{ContactLaw, NonlinearViscoelastic};
use pounding_scene::{Contact, Damping, Extras, FileUse, Method, RecordUse, RunBudget, Scene, Sdof, Simulation, Source, Structure};
use std::path::Path;
use strum::EnumCount;

/// What a row does that the leanest one leaves out.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
pub enum Burden {
    /// Nothing: elastic columns, no pairs, peaks and impulses recorded, nothing else.
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

impl Burden {
    /// All of them, the leanest first.
    pub const ALL: [Self; Self::COUNT] = [
        Self::None,
        Self::Yielding,
        Self::Pairs,
        Self::Histories,
        Self::Ledger,
        Self::Touching,
    ];

    /// In the words of a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "lean",
            Self::Yielding => "columns that remember yielding",
            Self::Pairs => "pairs out of reach",
            Self::Histories => "histories",
            Self::Ledger => "ledger",
            Self::Touching => "pairs that touch",
        }
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
        let contacts = match burden {
            Burden::Pairs => Some(10.0),
            Burden::Touching => Some(0.05),
            Burden::None | Burden::Yielding | Burden::Histories | Burden::Ledger => None,
        };
        let law = ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
            impact_stiffness: 2.75e9,
            impact_damping_ratio: 0.35,
        });
        let structure = |index| structure(index, burden == Burden::Yielding);
        let scene = Scene {
            name: format!("{n} structures"),
            record: RecordUse::of(Source::File(FileUse {
                file: record.to_string_lossy().into_owned(),
                ..FileUse::default()
            })),
            duration_s: Some(DURATION),
            structures: (0..n).map(structure).collect(),
            contacts: contacts.map(|gap_m| vec![Contact { gap_m, law, levels: None }; n - 1]),
            neighbour: None,
            arrivals_s: None,
            method,
            budget: RunBudget::default(),
        };
        let prepared = Simulation::new(&scene, Path::new(""))?;
        Ok(Self { prepared, burden })
    }

    /// Runs the row.
    ///
    /// # Errors
    /// [`pounding_scene::Error::Run`] when the run ends early.
    pub fn run(&self) -> Result<(), pounding_scene::Error> {
        match self.burden {
            Burden::None | Burden::Yielding | Burden::Pairs | Burden::Touching => self.prepared.run_unjudged(Extras::default()).map(|_| ()),
            Burden::Histories => {
                let asked = Extras {
                    interval: Some(INTERVAL),
                    closings: false,
                    ..Extras::default()
                };
                self.prepared.run_unjudged(asked).map(|_| ())
            }
            Burden::Ledger => self.prepared.audited(None).map(|_| ()),
        }
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
