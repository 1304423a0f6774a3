//! What of a long row is shown: the pairs that are hit hardest.

use crate::{PairSummary, Prepared};

/// More curves than this cannot be told from each other.
const MOST_STRUCTURES: usize = 6;
/// More panels than this do not fit on a page.
const MOST_PAIRS: usize = 4;

/// The structures and pairs that pictures show, from left to right.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shown {
    /// Structures whose displacements are shown.
    pub(super) structures: Vec<usize>,
    /// Pairs of them.
    pub(super) pairs: Vec<usize>,
    /// Pairs with a panel of their own.
    pub(super) panels: Vec<usize>,
    /// What is left out, in a sentence; empty where nothing is.
    pub(super) left_out: String,
}

impl Shown {
    /// Of `n` structures with these pairs: the pairs with the largest impulses, then those that come closest to touching.
    pub(super) fn of(prepared: &Prepared, all_pairs: &[PairSummary]) -> Self {
        let (n, facing) = (prepared.floors().all().len(), prepared.floors().facing());
        let sides = |pair: usize| [facing[pair].left, facing[pair].right];
        let n_pairs = all_pairs.len();
        let all_pairs = all_pairs.iter().enumerate();
        let mut ranked: Vec<(f64, f64, usize)> = all_pairs
            .map(|(index, pair)| {
                let largest = pair.largest.map_or(0.0, |largest| largest.impulse_n_s);
                (largest, pair.least_opening_m, index)
            })
            .collect();
        ranked.sort_by(|one, other| {
            let harder = other.0.total_cmp(&one.0);
            harder.then(one.1.total_cmp(&other.1))
        });
        let mut structures = Vec::new();
        if n <= MOST_STRUCTURES || n_pairs == 0 {
            structures.extend(0..n.min(MOST_STRUCTURES));
        } else {
            for &(_, _, pair) in &ranked {
                let new: Vec<usize> = sides(pair)
                    .into_iter()
                    .filter(|index| !structures.contains(index))
                    .collect();
                if structures.len() + new.len() <= MOST_STRUCTURES {
                    structures.extend(new);
                }
            }
        }
        structures.sort_unstable();
        let both = |pair: &usize| sides(*pair).iter().all(|one| structures.contains(one));
        let pairs = (0..n_pairs).filter(both).collect();
        let mut panels: Vec<usize> = ranked.iter().map(|one| one.2).take(MOST_PAIRS).collect();
        panels.sort_unstable();
        let left_out = if structures.len() < n {
            format!(
                "Of {n} structures the {} are shown whose pairs are hit hardest, or come closest to it. ",
                structures.len()
            )
        } else {
            String::new()
        };
        Self {
            structures,
            pairs,
            panels,
            left_out,
        }
    }
}
