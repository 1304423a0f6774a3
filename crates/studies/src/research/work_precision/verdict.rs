//! Whether the exact method is the cheaper one: its error of 1e-6 against 1 % of the central difference method.

use super::measure::Race;
use super::pareto::cheapest;
use super::quantities::MethodQuantity;
use super::table::setting;
use pounding_scene::{EVALUATIONS_PER_PIECE, REFERENCE, RIVAL, price};
use pounding_text::to_csv;

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
        &format!("time_of_exact_over_central_difference_at_{EVALUATIONS_PER_PIECE}_evaluations_a_piece"),
        "why",
    ];
    let mut rows = Vec::new();
    for race in races {
        let present = MethodQuantity::ALL.map(|quantity| (!race.truth.values(quantity).is_empty()).then_some(quantity));
        let present: Vec<_> = present.into_iter().flatten().collect();
        for quantity in &present {
            rows.push(row(race, quantity.key(), &[*quantity]));
        }
        rows.push(row(race, "all", &present));
    }
    to_csv(&header.map(String::from), &rows)
}

/// What a method needs for an error.
struct Need {
    setting: String,
    work: u64,
    /// In force evaluations of equal time.
    price: u64,
}

fn need(race: &Race, key: &str, quantities: &[MethodQuantity], allowed: f64) -> Option<Need> {
    let entrant = race.of(key)?;
    let (rung, work) = cheapest(entrant, |measured| measured.worst(quantities) <= allowed)?;
    let run = rung.outcome.as_ref().ok()?;
    Some(Need {
        setting: setting(entrant.contender, rung.setting),
        work,
        price: price(run.work),
    })
}

fn row(race: &Race, name: &str, quantities: &[MethodQuantity]) -> Vec<String> {
    let exact = need(race, REFERENCE, quantities, EXACT);
    let stepping = need(race, RIVAL, quantities, STEPPING);
    let both = exact.as_ref().zip(stepping.as_ref());
    let ratio = |of: fn(&Need) -> u64| both.map(|(exact, stepping)| of(exact) as f64 / of(stepping) as f64);
    let (work, time) = (ratio(|need| need.work), ratio(|need| need.price));
    let less = match work {
        Some(ratio) => ratio < 1.0,
        None => exact.is_some(),
    };
    let slow = format!("less work, but a piece takes as long as {EVALUATIONS_PER_PIECE} evaluations");
    let why = match (work, time) {
        (Some(work), _) if work >= 1.0 => "a few steps are enough for 1 %, and the exact method needs a piece per structure and sample",
        (_, Some(time)) if time >= 1.0 => &slow,
        (Some(_), _) => "",
        (None, _) if exact.is_none() => "the exact method does not reach 1e-6",
        (None, _) => "the central difference method does not hold 1 % on this ladder",
    };
    let mut row = vec![race.scene.clone(), name.into()];
    for needed in [&exact, &stepping] {
        row.extend(match needed {
            Some(need) => [need.setting.clone(), need.work.to_string()],
            None => ["never".into(), String::new()],
        });
    }
    let printed = |ratio: Option<f64>| ratio.map_or(String::new(), |ratio| format!("{ratio:.3}"));
    row.push(printed(work));
    row.push(if less { "yes" } else { "no" }.into());
    row.push(printed(time));
    row.push(why.into());
    row
}
