//! Which method is cheapest for an error.

use super::measure::{Entrant, Measured, Race, Rung};
use super::quantities::MethodQuantity;
use super::table::{agreed, setting};
use pounding_scene::{COMPARED_METHODS, ComparedMethod, holding};
use pounding_text::Table;

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

/// What is asked of every method, and the cheapest run of each that holds it.
struct Asked<'a> {
    race: &'a Race,
    quantity: &'static str,
    percent: &'static str,
    agreed: String,
    found: Vec<Option<Run<'a>>>,
}

/// A run, and its work.
type Run<'a> = (&'a Rung, u64);

impl<'a> Asked<'a> {
    fn of(race: &'a Race, (quantity, percent, agreed): (&'static str, &'static str, String), holds: impl Fn(&Measured) -> bool) -> Self {
        let found = COMPARED_METHODS.iter().map(|contender| cheapest(race.of(contender.key)?, &holds));
        Self {
            race,
            quantity,
            percent,
            agreed,
            found: found.collect(),
        }
    }

    /// The cheapest of all.
    fn best(&self) -> Option<(&'static ComparedMethod, Run<'a>)> {
        let runs = COMPARED_METHODS.iter().zip(&self.found);
        runs.filter_map(|(contender, found)| Some((contender, (*found)?)))
            .min_by_key(|(_, (_, cost))| *cost)
    }
}

/// For every scene, quantity and error the cheapest method, and the setting that each method needs.
pub(super) fn table(races: &[Race]) -> String {
    let mut rows = Vec::new();
    for race in races {
        for quantity in MethodQuantity::ALL {
            if race.truth.values(quantity).is_empty() {
                continue;
            }
            rows.extend(ALLOWED.map(|(allowed, percent)| {
                let asked = (quantity.key(), percent, agreed(race.digits(quantity)));
                Asked::of(race, asked, |measured| {
                    measured.error(quantity).is_some_and(|error| error <= allowed)
                })
            }));
        }
        if race.truth.n_collisions > 0 {
            let asked = ("number_of_collisions", "0", race.agreed_count().into());
            rows.push(Asked::of(race, asked, |measured| measured.same_count));
        }
    }
    Table::of(rows)
        .column("scene", |one| one.race.scene.clone())
        .column("quantity", |one| one.quantity)
        .column("allowed_error_percent", |one| one.percent)
        .column("agreed_digits", |one| one.agreed.clone())
        .column("cheapest_method", |one| one.best().map_or("never", |(contender, _)| contender.key))
        .column("cheapest_setting", |one| {
            one.best().map(|(contender, (rung, _))| setting(contender, rung.setting))
        })
        .column("cheapest_work", |one| one.best().map(|(_, (_, cost))| cost))
        .columns(
            0..COMPARED_METHODS.len(),
            |method| COMPARED_METHODS[method].key.into(),
            |one, method| {
                let needed = |(rung, _): Run<'_>| setting(&COMPARED_METHODS[method], rung.setting);
                let entrant = one.race.of(COMPARED_METHODS[method].key);
                entrant.map(|_| one.found[method].map_or("never".into(), needed))
            },
        )
        .csv()
}
