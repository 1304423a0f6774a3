//! The part of a long row that is shown: the pairs that are hit hardest.

use crate::PairSummary;
use pounding_scene::{Floors, PairQuantity, Simulation};

/// More curves than this cannot be told from each other.
const MOST_FLOORS: usize = 6;
/// More panels than this do not fit on a page.
const MOST_PAIRS: usize = 4;

/// The floors, walls and pairs that pictures show, from left to right.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Selection {
    /// Floors whose displacements are shown; a wall once, whatever it faces.
    pub(super) floors: Vec<usize>,
    /// Pairs of them.
    pub(super) pairs: Vec<usize>,
    /// Pairs with a separate panel.
    pub(super) panels: Vec<usize>,
    /// A sentence about pairs that are left out; empty if none is.
    pub(super) left_out: String,
}

impl Selection {
    /// Selects from the floors of a scene with these pairs: the pairs that are hit hardest, then those that come closest to touching.
    pub(super) fn of(prepared: &Simulation, all_pairs: &[PairSummary]) -> Self {
        let floors = prepared.floors();
        let all: Vec<usize> = (0..floors.all().len()).filter(|floor| drawn(floors, *floor) == *floor).collect();
        let facing = floors.facing();
        let sides = |pair: usize| [facing[pair].left, facing[pair].right].map(|floor| drawn(floors, floor));
        let ranked = ranked(all_pairs);
        let mut shown = Vec::new();
        if all.len() <= MOST_FLOORS || ranked.is_empty() {
            shown.extend(all.iter().copied().take(MOST_FLOORS));
        } else {
            for &pair in &ranked {
                let new = sides(pair).into_iter();
                let new: Vec<usize> = new.filter(|floor| !shown.contains(floor)).collect();
                if shown.len() + new.len() <= MOST_FLOORS {
                    shown.extend(new);
                }
            }
        }
        shown.sort_unstable();
        let both = |pair: &usize| sides(*pair).iter().all(|one| shown.contains(one));
        let pairs = (0..ranked.len()).filter(both).collect();
        let mut panels: Vec<usize> = ranked.iter().copied().take(MOST_PAIRS).collect();
        panels.sort_unstable();
        let left_out = if shown.len() < all.len() {
            let storeys = floors.all().iter().any(|floor| floor.storey.is_some());
            format!(
                "Of {} {} the {} are shown whose pairs are hit hardest, or come closest to it. ",
                all.len(),
                if storeys { "floors" } else { "structures" },
                shown.len()
            )
        } else {
            String::new()
        };
        Self {
            floors: shown,
            pairs,
            panels,
            left_out,
        }
    }
}

/// The floor whose curve shows this one: a wall stands still at all of its levels.
pub(super) fn drawn(floors: &Floors, floor: usize) -> usize {
    let one = &floors.all()[floor];
    if one.is_wall() {
        floors.of_structure(one.structure)[0]
    } else {
        floor
    }
}

/// Pairs, those hit hardest first: by their largest forces, which do not count a building that leans on its neighbour as a hit, or by their
/// largest impulses if impacts have no force. Pairs that are not hit follow, the closest first.
fn ranked(pairs: &[PairSummary]) -> Vec<usize> {
    let force = |pair: &PairSummary| pair.number(PairQuantity::PeakForceN);
    let forces = pairs.iter().all(|pair| pair.collisions() == 0 || force(pair).is_some());
    let hardness = |pair: &PairSummary| {
        let impulse = pair.largest.map(|largest| largest.impulse_n_s);
        let measure = if forces { force(pair) } else { impulse };
        measure.unwrap_or(0.0)
    };
    let mut ranked: Vec<usize> = (0..pairs.len()).collect();
    ranked.sort_by(|one, other| {
        let (one, other) = (&pairs[*one], &pairs[*other]);
        let harder = hardness(other).total_cmp(&hardness(one));
        harder.then(one.least_opening().total_cmp(&other.least_opening()))
    });
    ranked
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn pair(force: Option<f64>, impulse: f64, opening: f64) -> PairSummary {
        let hit = json!({ "start_s": 1.0, "end_s": 1.5, "impulse_n_s": impulse });
        let mut pair = json!({
            "left": "a", "right": "b", "gap_m": 0.01, "law": "linear_spring", "collisions": 0, "total_impulse_n_s": impulse,
            "least_opening_m": opening, "least_opening_time_s": 1.0, "peak_force_n": force,
        });
        if impulse > 0.0 {
            pair["collisions"] = json!(1);
            pair["largest"] = hit;
        }
        serde_json::from_value(pair).expect("a summary")
    }

    /// The pair with the largest force was left out for one that leaned on a wall, whose impulse was larger.
    #[test]
    fn issue_what_leans_is_not_what_is_hit_hardest() {
        let (leaning, hit) = (pair(Some(5.8e6), 2.2e6, 0.0), pair(Some(10.8e6), 3e5, 0.0));
        let (far, near) = (pair(None, 0.0, 0.008), pair(None, 0.0, 0.002));
        let all = [far, leaning, near, hit];
        assert_eq!(ranked(&all), [3, 1, 2, 0]);
        // If an impact has no force, all pairs still have impulses.
        let [far, leaning, near, hit] = all;
        let impulsive = pair(None, 1e6, 0.0);
        assert_eq!(ranked(&[far, leaning, near, hit, impulsive]), [1, 4, 3, 2, 0]);
    }
}
