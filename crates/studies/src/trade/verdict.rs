//! Whether the exact method is the cheaper one: its error of 1e-6 against 1 % of the central difference method.

use super::measure::Race;
use super::pareto::cheapest;
use super::quantities::Quantity;
use super::table::setting;
use crate::contenders::{REFERENCE, RIVAL};
use crate::ladder::price;
use crate::tables::to_csv;

/// Error asked of the exact method \[–\].
pub(super) const EXACT: f64 = 1e-6;
/// Error asked of the central difference method \[–\].
pub(super) const STEPPING: f64 = 1e-2;

/// For every scene and quantity, and for all of them at once, what either method needs.
pub(super) fn table(races: &[Race]) -> String {
    let header = [
        "scene",
        "quantity",
        "exact_tolerance_for_1e-6",
        "exact_work",
        "central_difference_time_step_for_1_percent",
        "central_difference_work",
        "work_of_exact_over_central_difference",
        "exact_needs_less_work",
        "time_of_exact_over_central_difference_at_25_evaluations_a_piece",
        "why",
    ];
    let mut rows = Vec::new();
    for race in races {
        let present = Quantity::ALL
            .map(|quantity| (!race.truth.values(quantity).is_empty()).then_some(quantity));
        let present: Vec<_> = present.into_iter().flatten().collect();
        for quantity in &present {
            rows.push(row(race, quantity.key(), &[*quantity]));
        }
        rows.push(row(race, "all", &present));
    }
    to_csv(&header.map(String::from), &rows)
}

fn row(race: &Race, name: &str, quantities: &[Quantity]) -> Vec<String> {
    let needs = |key, allowed| {
        let entrant = race.of(key)?;
        let (rung, cost) = cheapest(entrant, |measured| measured.worst(quantities) <= allowed)?;
        let price = rung.outcome.as_ref().map_or(0, |run| price(run.work));
        Some((setting(entrant.contender, rung.setting), cost, price))
    };
    let (exact, stepping) = (needs(REFERENCE, EXACT), needs(RIVAL, STEPPING));
    let ratio = match (&exact, &stepping) {
        (Some((_, exact, _)), Some((_, stepping, _))) => Some(*exact as f64 / *stepping as f64),
        _ => None,
    };
    let time = match (&exact, &stepping) {
        (Some((.., exact)), Some((.., stepping))) => Some(*exact as f64 / *stepping as f64),
        _ => None,
    };
    let (cheaper, why) = match (&exact, &stepping, ratio) {
        (None, _, _) => ("no", "the exact method does not reach 1e-6"),
        (Some(_), None, _) => (
            "yes",
            "the central difference method does not hold 1 % on this ladder",
        ),
        (Some(_), Some(_), Some(ratio)) if ratio < 1.0 => ("yes", ""),
        (Some(_), Some(_), _) => (
            "no",
            "a few steps are enough for 1 %, and the exact method needs a piece per structure and sample",
        ),
    };
    let mut row = vec![race.scene.clone(), name.into()];
    for needed in [exact, stepping] {
        row.extend(match needed {
            Some((setting, cost, _)) => [setting, cost.to_string()],
            None => ["never".into(), String::new()],
        });
    }
    row.push(ratio.map(|ratio| format!("{ratio:.3}")).unwrap_or_default());
    row.push(cheaper.to_string());
    row.push(time.map(|time| format!("{time:.3}")).unwrap_or_default());
    row.push(why.to_string());
    row
}
