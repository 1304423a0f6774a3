//! Whether the exact method is the cheaper one: its error of 1e-6 against 1 % of the central difference method.

use super::measure::Race;
use super::pareto::cheapest;
use super::quantities::MethodQuantity;
use super::table::setting;
use crate::files::yes_or_no;
use pounding_scene::{EVALUATIONS_PER_PIECE, REFERENCE, RIVAL, price};
use pounding_text::{Cell, Table};

/// Error asked of the exact method \[–\].
pub(super) const EXACT: f64 = 1e-6;
/// Error asked of the central difference method \[–\].
pub(super) const STEPPING: f64 = 1e-2;

/// What a method needs for an error.
struct Need {
    setting: String,
    work: u64,
    /// In force evaluations of equal time.
    price: u64,
}

impl Need {
    fn of(race: &Race, key: &str, quantities: &[MethodQuantity], allowed: f64) -> Option<Self> {
        let entrant = race.of(key)?;
        let (rung, work) = cheapest(entrant, |measured| measured.worst(quantities) <= allowed)?;
        Some(Self {
            setting: setting(entrant.contender, rung.setting),
            work,
            price: price(rung.outcome.as_ref().ok()?.work),
        })
    }
}

/// What both methods need for their errors of some quantities.
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
            exact: Need::of(race, REFERENCE, quantities, EXACT),
            stepping: Need::of(race, RIVAL, quantities, STEPPING),
        }
    }

    /// What the exact method needs over what the other does.
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
            (_, Some(time)) if time >= 1.0 => format!("less work, but a piece takes as long as {EVALUATIONS_PER_PIECE} evaluations"),
            (Some(_), _) => String::new(),
            (None, _) if self.exact.is_none() => "the exact method does not reach 1e-6".into(),
            (None, _) => "the central difference method does not hold 1 % on this ladder".into(),
        }
    }
}

/// For every scene and quantity, and for all of them at once, what either method needs.
pub(super) fn table<'a>(races: &'a [Race]) -> String {
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
    let time = format!("time_of_exact_over_central_difference_at_{EVALUATIONS_PER_PIECE}_evaluations_a_piece");
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
