//! The cheapest method for an error, and the price of the exact method at an error of 1e-6 against that of the central difference method at
//! 1 %.

use super::measure::{Entrant, Measured, Race, Rung};
use super::quantities::MethodQuantity;
use super::table::{agreed, setting};
use crate::files::yes_or_no;
use pounding_scene::{ComparedMethod, StepSizes};
use pounding_text::{Cell, Table};

/// Largest errors \[–\] with their names in per cent.
const ALLOWED: [(f64, &str); 5] = [(0.3, "30"), (0.1, "10"), (0.03, "3"), (0.01, "1"), (0.001, "0.1")];

/// The cheapest of some runs.
#[derive(Clone, Copy)]
pub(super) struct Cheapest<'a> {
    pub(super) rung: &'a Rung,
    pub(super) work: u64,
}

/// The cheapest run of a method that passes a test and keeps passing it at every smaller setting of the ladder.
pub(super) fn cheapest(entrant: &Entrant, holds: impl Fn(&Measured) -> bool) -> Option<Cheapest<'_>> {
    let holds = |rung: &Rung| rung.outcome.as_ref().is_ok_and(&holds);
    // Of equal costs the finest run counts.
    let rungs = StepSizes::holding(&entrant.rungs, holds).iter().rev();
    let runs = rungs.filter_map(|rung| {
        let work = rung.outcome.as_ref().ok()?.cost();
        Some(Cheapest { rung, work })
    });
    runs.min_by_key(|run| run.work)
}

/// A quantity and an error, with the cheapest run of each method that reaches it.
struct ErrorGoal<'a> {
    race: &'a Race,
    quantity: &'static str,
    percent: &'static str,
    agreed: String,
    found: Vec<Option<Cheapest<'a>>>,
}

impl<'a> ErrorGoal<'a> {
    fn of(race: &'a Race, quantity: &'static str, percent: &'static str, agreed: String, holds: impl Fn(&Measured) -> bool) -> Self {
        let found = ComparedMethod::ALL
            .iter()
            .map(|contender| cheapest(race.of(contender.key)?, &holds));
        Self {
            race,
            quantity,
            percent,
            agreed,
            found: found.collect(),
        }
    }

    /// The cheapest run of all methods.
    fn best(&self) -> Option<(&'static ComparedMethod, Cheapest<'a>)> {
        let runs = ComparedMethod::ALL.iter().zip(&self.found);
        runs.filter_map(|(contender, found)| Some((contender, (*found)?)))
            .min_by_key(|(_, run)| run.work)
    }
}

/// Table of the cheapest method for every scene, quantity and error, with the setting that each method needs.
pub(super) fn table(races: &[Race]) -> String {
    let mut rows = Vec::new();
    for race in races {
        for quantity in MethodQuantity::ALL {
            if race.truth.values(quantity).is_empty() {
                continue;
            }
            rows.extend(ALLOWED.map(|(allowed, percent)| {
                ErrorGoal::of(race, quantity.key(), percent, agreed(race.digits(quantity)), |measured| {
                    measured.error(quantity).is_some_and(|error| error <= allowed)
                })
            }));
        }
        if race.truth.n_collisions > 0 {
            let agreed = race.agreed_count().into();
            rows.push(ErrorGoal::of(race, "number_of_collisions", "0", agreed, |measured| {
                measured.same_count
            }));
        }
    }
    Table::of(rows)
        .column("scene", |one| one.race.scene.clone())
        .column("quantity", |one| one.quantity)
        .column("allowed_error_percent", |one| one.percent)
        .column("agreed_digits", |one| one.agreed.clone())
        .column("cheapest_method", |one| one.best().map_or("never", |(contender, _)| contender.key))
        .column("cheapest_setting", |one| {
            one.best().map(|(contender, run)| setting(contender, run.rung.setting))
        })
        .column("cheapest_work", |one| one.best().map(|(_, run)| run.work))
        .columns(
            0..ComparedMethod::ALL.len(),
            |method| ComparedMethod::ALL[method].key.into(),
            |one, method| {
                let needed = |run: Cheapest<'_>| setting(&ComparedMethod::ALL[method], run.rung.setting);
                let entrant = one.race.of(ComparedMethod::ALL[method].key);
                entrant.map(|_| one.found[method].map_or("never".into(), needed))
            },
        )
        .csv()
}

/// Largest error of the exact method in the comparison \[–\].
pub(super) const EXACT: f64 = 1e-6;
/// Largest error of the central difference method in the comparison \[–\].
pub(super) const STEPPING: f64 = 1e-2;

/// The cost of a method for an error.
struct Need {
    setting: String,
    work: u64,
    /// Cost as a number of force evaluations that take the same time.
    price: u64,
}

impl Need {
    fn of(race: &Race, key: &str, quantities: &[MethodQuantity], allowed: f64) -> Option<Self> {
        let entrant = race.of(key)?;
        let Cheapest { rung, work } = cheapest(entrant, |measured| measured.worst(quantities) <= allowed)?;
        Some(Self {
            setting: setting(entrant.contender, rung.setting),
            work,
            price: ComparedMethod::price(rung.outcome.as_ref().ok()?.work),
        })
    }
}

/// Costs of both methods for their errors in some quantities.
struct Both<'a> {
    scene: &'a str,
    quantity: &'static str,
    exact: Option<Need>,
    stepping: Option<Need>,
}

impl<'a> Both<'a> {
    fn of(race: &'a Race, quantity: &'static str, quantities: &[MethodQuantity]) -> Self {
        Self {
            scene: &race.scene,
            quantity,
            exact: Need::of(race, ComparedMethod::REFERENCE, quantities, EXACT),
            stepping: Need::of(race, ComparedMethod::RIVAL, quantities, STEPPING),
        }
    }

    /// Ratio of the exact method's need to that of the other.
    fn ratio(&self, of: fn(&Need) -> u64) -> Option<f64> {
        Some(of(self.exact.as_ref()?) as f64 / of(self.stepping.as_ref()?) as f64)
    }

    fn needs_less(&self) -> bool {
        self.ratio(|need| need.work).map_or(self.exact.is_some(), |ratio| ratio < 1.0)
    }

    fn why(&self) -> String {
        match (self.ratio(|need| need.work), self.ratio(|need| need.price)) {
            (Some(work), _) if work >= 1.0 => {
                "a few steps are enough for 1 %, and the exact method needs a piece per structure and sample".into()
            }
            (_, Some(time)) if time >= 1.0 => {
                format!(
                    "less work, but a piece takes as long as {} evaluations",
                    ComparedMethod::EVALUATIONS_PER_PIECE
                )
            }
            (Some(_), _) => String::new(),
            (None, _) if self.exact.is_none() => "the exact method does not reach 1e-6".into(),
            (None, _) => "the central difference method does not hold 1 % on this ladder".into(),
        }
    }
}

/// Table of the costs of both methods for every scene and quantity, and for all quantities at once.
pub(super) fn exact_or_stepping<'a>(races: &'a [Race]) -> String {
    let of_race = |race: &'a Race| {
        let mut present = MethodQuantity::ALL.to_vec();
        present.retain(|quantity| !race.truth.values(*quantity).is_empty());
        let mut rows: Vec<_> = present
            .iter()
            .map(|quantity| Both::of(race, quantity.key(), &[*quantity]))
            .collect();
        rows.push(Both::of(race, "all", &present));
        rows
    };
    let setting = |need: &Option<Need>| need.as_ref().map_or("never".to_string(), |need| need.setting.clone());
    let work = |need: &Option<Need>| need.as_ref().map(|need| need.work);
    let ratio = |ratio: Option<f64>| Cell::number(ratio, |ratio| format!("{ratio:.3}"));
    let time = format!(
        "time_of_exact_over_central_difference_at_{}_evaluations_a_piece",
        ComparedMethod::EVALUATIONS_PER_PIECE
    );
    Table::of(races.iter().flat_map(of_race))
        .column("scene", |one| one.scene.to_string())
        .column("quantity", |one| one.quantity)
        .column("exact_tolerance_for_1e-6", |one| setting(&one.exact))
        .column("exact_work", |one| work(&one.exact))
        .column("central_difference_time_step_for_1_percent", |one| setting(&one.stepping))
        .column("central_difference_work", |one| work(&one.stepping))
        .column("work_of_exact_over_central_difference", |one| ratio(one.ratio(|need| need.work)))
        .column("exact_needs_less_work", |one| yes_or_no(one.needs_less()))
        .column(time, |one| ratio(one.ratio(|need| need.price)))
        .column("why", Both::why)
        .csv()
}
