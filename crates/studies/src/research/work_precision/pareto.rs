//! Which method is cheapest for an error.

use super::measure::{Entrant, Measured, Race, Rung};
use super::quantities::MethodQuantity;
use super::table::{agreed, setting};
use pounding_scene::{COMPARED_METHODS, holding};
use pounding_text::to_csv;

/// Errors asked for \[–\], with their names in per cent.
const ALLOWED: [(f64, &str); 5] = [(0.3, "30"), (0.1, "10"), (0.03, "3"), (0.01, "1"), (0.001, "0.1")];

/// The cheapest run of a method that holds what is asked, here and at every smaller setting of the ladder.
pub(super) fn cheapest(entrant: &Entrant, holds: impl Fn(&Measured) -> bool) -> Option<(&Rung, u64)> {
    let holds = |rung: &Rung| rung.outcome.as_ref().is_ok_and(&holds);
    // Of equal costs the finest.
    let rungs = holding(&entrant.rungs, holds).iter().rev();
    rungs
        .filter_map(|rung| Some((rung, rung.outcome.as_ref().ok()?.cost())))
        .min_by_key(|(_, cost)| *cost)
}

/// For every scene, quantity and error the cheapest method, and the setting that each method needs.
pub(super) fn table(races: &[Race]) -> String {
    let header = [
        "scene",
        "quantity",
        "allowed_error_percent",
        "agreed_digits",
        "cheapest_method",
        "cheapest_setting",
        "cheapest_work",
    ];
    let methods = COMPARED_METHODS.iter().map(|contender| contender.key);
    let header: Vec<_> = header.into_iter().chain(methods).map(String::from).collect();
    let mut rows = Vec::new();
    for race in races {
        for quantity in MethodQuantity::ALL {
            if race.truth.values(quantity).is_empty() {
                continue;
            }
            for (allowed, percent) in ALLOWED {
                let within = |error: f64| error <= allowed;
                let agreed = agreed(race.digits(quantity));
                let asked = [quantity.key().into(), percent.into(), agreed];
                rows.push(row(race, asked, |measured| measured.error(quantity).is_some_and(within)));
            }
        }
        if race.truth.n_collisions > 0 {
            let asked = ["number_of_collisions".into(), "0".into(), race.agreed_count().into()];
            rows.push(row(race, asked, |measured| measured.same_count));
        }
    }
    to_csv(&header, &rows)
}

fn row(race: &Race, asked: [String; 3], holds: impl Fn(&Measured) -> bool) -> Vec<String> {
    let found: Vec<_> = COMPARED_METHODS
        .iter()
        .map(|contender| Some((contender, cheapest(race.of(contender.key)?, &holds))))
        .collect();
    let best = found
        .iter()
        .flatten()
        .filter_map(|(contender, found)| Some((contender, (*found)?)))
        .min_by_key(|(_, (_, cost))| *cost);
    let mut row = vec![race.scene.clone()];
    row.extend(asked);
    row.extend(match best {
        Some((contender, (rung, cost))) => [contender.key.into(), setting(contender, rung.setting), cost.to_string()],
        None => ["never".into(), String::new(), String::new()],
    });
    row.extend(found.into_iter().map(|entrant| match entrant {
        Some((contender, Some((rung, _)))) => setting(contender, rung.setting),
        Some((_, None)) => "never".into(),
        None => String::new(),
    }));
    row
}
