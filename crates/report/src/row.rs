//! Who hits whom in a row: a line for each gap, with the end buildings named.

use pounding_scene::{Floors, RunResult, Scene, Simulation};
use pounding_text::{Grid, Shown, Table, two_digits};

use crate::Blow;

/// What happens in a gap.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Meeting {
    /// Index of the structure on its left.
    pub(crate) gap: usize,
    /// How often, in words.
    pub(crate) times: String,
    /// The pair of floors that meets hardest, and how hard.
    pub(crate) hardest: Option<(usize, String)>,
}

/// Shorter rows have one gap: every sentence is about it.
const LEAST: usize = 3;

/// A table of the gaps of a row of three or more; empty for shorter rows.
pub(crate) fn table(scene: &Scene, floors: &Floors, times: &'static str, meetings: Vec<Meeting>) -> Grid {
    let last = scene.structures.len().saturating_sub(1);
    let name = |index: usize| {
        let end = match index {
            0 => " (left end)",
            index if index == last => " (right end)",
            _ => "",
        };
        format!("{}{end}", scene.structures[index].name())
    };
    let meetings = if last + 1 < LEAST { Vec::new() } else { meetings };
    Table::of(meetings)
        .shown("Who hits whom", |one: &Meeting| {
            format!("{} – {}", name(one.gap), name(one.gap + 1))
        })
        .shown(times, |one| one.times.clone())
        .shown("Hardest at", |one| {
            Shown::from(one.hardest.as_ref().map(|(pair, _)| floors.names(*pair).join(" – ")))
        })
        .shown("With up to", |one| Shown::from(one.hardest.as_ref().map(|(_, how)| how.clone())))
        .grid()
}

/// What happens in the gaps of a run.
pub(crate) fn of_run(prepared: &Simulation, outcome: &RunResult) -> Vec<Meeting> {
    let blows = Blow::all(outcome);
    let facing = prepared.floors().facing();
    let gaps = 0..prepared.scene().contacts.iter().flatten().count();
    let meeting = |gap: usize| {
        let own = (0..facing.len()).filter(|pair| facing[*pair].contact == gap);
        let collisions: usize = own.map(|pair| outcome.of_pair(pair).collisions).sum();
        let mut hardest = blows.iter().filter(|blow| facing[blow.pair].contact == gap);
        Meeting {
            gap,
            times: match collisions {
                0 => "never".into(),
                n => n.to_string(),
            },
            hardest: hardest.next().map(|blow| (blow.pair, how(blow))),
        }
    };
    gaps.map(meeting).collect()
}

fn how(blow: &Blow) -> String {
    match *blow {
        Blow { force: Some(force), .. } => format!("{} kN", two_digits(1e-3 * force)),
        Blow { speed: Some(speed), .. } => format!("{} m/s", two_digits(speed)),
        Blow { impulse, .. } => format!("{} kN·s", two_digits(1e-3 * impulse)),
    }
}
