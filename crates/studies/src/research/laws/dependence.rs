//! Sorts the numbers of a scene into those that depend on the contact law and those that do not.

use super::entry::{Entry, label, mark, shade};
use super::scenes::{Item, Played, items};
use crate::files::capital;
use crate::research::work_precision::MethodQuantity;
use crate::study::laws::is_linear;
use pounding_plot::{Axis, Curve, CurveKind, Figure, Panel};
use pounding_text::Table;

/// One number of a scene under all laws that are calibrated to one e.
struct Compared<'a> {
    played: &'a Played,
    item: Item,
    /// Values under the compliant laws, in their order. Springs without damping are left out: they deliver another e.
    compliant: Vec<(&'a Entry, f64)>,
    /// Value under the impulsive law.
    impulsive: Option<f64>,
}

impl Compared<'_> {
    fn mean(&self) -> f64 {
        let sum: f64 = self.compliant.iter().map(|(_, value)| value).sum();
        sum / self.compliant.len() as f64
    }

    /// The least and the largest value with their laws, among the laws that pass a test.
    fn extremes(&self, wanted: impl Fn(&Entry) -> bool) -> Option<[(&Entry, f64); 2]> {
        let values = || self.compliant.iter().copied().filter(|(entry, _)| wanted(entry));
        let least = values().min_by(|one, other| one.1.total_cmp(&other.1))?;
        let largest = values().max_by(|one, other| one.1.total_cmp(&other.1))?;
        Some([least, largest])
    }

    /// Largest over smallest value, minus one. `None` if the smallest is zero and the largest is not.
    fn spread(&self, wanted: impl Fn(&Entry) -> bool) -> Option<f64> {
        let [(_, least), (_, largest)] = self.extremes(wanted)?;
        match (least > 0.0, largest > 0.0) {
            (true, _) => Some(largest / least - 1.0),
            (false, true) => None,
            (false, false) => Some(0.0),
        }
    }
}

/// Compares every number of every scene.
fn compare<'a>(played: &'a [Played], entries: &'a [Entry]) -> Vec<Compared<'a>> {
    let of_scene = |scene: &'a Played| {
        let found = |(entry, outcome): (&'a Entry, &'a Result<_, _>)| Some((entry, items(outcome.as_ref().ok()?, entry.is_compliant())));
        let all: Vec<_> = entries.iter().zip(&scene.outcomes).filter_map(found).collect();
        let mut numbers: Vec<Compared<'a>> = Vec::new();
        for (entry, items) in all {
            for item in items {
                let place = numbers.iter().position(|one| one.item.is_as(&item)).unwrap_or(numbers.len());
                if place == numbers.len() {
                    numbers.push(Compared {
                        played: scene,
                        item: item.clone(),
                        compliant: Vec::new(),
                        impulsive: None,
                    });
                }
                let one = &mut numbers[place];
                if !entry.is_compliant() {
                    one.impulsive.get_or_insert(item.value);
                } else if !entry.name().is_elastic() {
                    one.compliant.push((entry, item.value));
                }
            }
        }
        numbers
    };
    let all = played.iter().flat_map(of_scene);
    // The peak of an impulsive law is not comparable with the others.
    all.filter(|compared| !compared.compliant.is_empty()).collect()
}

/// Largest spread of a number that does not depend on the law, and of one that depends on it a little \[–\].
const LIMITS: [f64; 2] = [0.01, 0.1];

/// The words for a spread: whether the number depends on the law.
fn depends(spread: Option<f64>) -> &'static str {
    let [no, little] = LIMITS;
    match spread {
        Some(spread) if spread <= no => "no",
        Some(spread) if spread <= little => "a little",
        _ => "yes",
    }
}

/// Table of the spread over the laws, for every number of every scene.
pub(super) fn table(played: &[Played], entries: &[Entry]) -> String {
    let linear = |entry: &Entry| is_linear(entry.name());
    // If all laws give one number, no law is named as the least or the largest.
    let law = |compared: &Compared<'_>, which: usize| {
        let differ = compared.spread(|_| true).is_none_or(|spread| spread > 0.0);
        compared
            .extremes(|_| true)
            .filter(|_| differ)
            .map(|both| both[which].0.name().name())
    };
    let extreme = |compared: &Compared<'_>, which: usize| compared.extremes(|_| true).map(|both| both[which].1);
    Table::of(compare(played, entries))
        .column("scene", |one| one.played.scene.clone())
        .column("quantity", |one| one.item.quantity)
        .column("structure", |one| one.item.structure)
        .column("unit", |one| one.item.unit)
        .column("laws", |one| one.compliant.len())
        .column("least", |one| extreme(one, 0))
        .column("law_of_least", |one| law(one, 0))
        .column("largest", |one| extreme(one, 1))
        .column("law_of_largest", |one| law(one, 1))
        .column("depends_on_law", |one| depends(one.spread(|_| true)))
        .column("spread", |one| one.spread(|_| true))
        .column("spread_of_linear_springs", |one| one.spread(linear))
        .column("spread_of_hertz_springs", |one| one.spread(|entry| !linear(entry)))
        .column("stereomechanical", |one| one.impulsive)
        .column("stereomechanical_over_mean", |one| one.impulsive.map(|value| value / one.mean()))
        .csv()
}

/// Quantities of the panels, with the relative heights of the panels.
const SHOWN: [(MethodQuantity, f64); 4] = [
    (MethodQuantity::FirstImpulse, 8.0),
    (MethodQuantity::ContactPeak, 8.0),
    (MethodQuantity::Momentum, 22.0),
    (MethodQuantity::Displacement, 22.0),
];

/// Figure of every law's number over the mean of the compliant laws.
pub(super) fn figure(played: &[Played], entries: &[Entry]) -> Figure {
    let all = compare(played, entries);
    let panel = |(quantity, weight): (MethodQuantity, f64)| {
        let rows: Vec<_> = all.iter().filter(|compared| compared.item.quantity == quantity.key()).collect();
        let names = Axis::names(rows.iter().map(|compared| name(compared)).collect());
        Panel {
            weight,
            ..Panel::shared(quantity.words(true), names, curves(&rows, entries))
        }
    };
    let x = Axis::auto("Over the mean of the compliant laws");
    Figure::grid(8.8, 2, x, SHOWN.into_iter().map(panel).collect())
}

fn curves(rows: &[&Compared<'_>], entries: &[Entry]) -> Vec<Curve> {
    let curve = |entry: &Entry| {
        let value = |compared: &&Compared<'_>| {
            let same = |(of, _): &&(&Entry, f64)| of.name() == entry.name();
            let found = compared.compliant.iter().find(same);
            if entry.is_compliant() {
                found.map(|(_, value)| *value)
            } else {
                compared.impulsive
            }
        };
        let point = |(y, compared): (usize, &&Compared<'_>)| {
            // Zeros are left out: they have no ratio.
            let ratio = value(compared)? / compared.mean();
            ratio.is_finite().then_some((ratio, y as f64))
        };
        let points = rows.iter().enumerate().filter_map(point).collect();
        let curve = Curve::new(CurveKind::Points, shade(entry.name()), points);
        curve.marked(mark(entry.name())).named(label(entry.name()))
    };
    let mut shown: Vec<_> = entries.iter().filter(|entry| !entry.name().is_elastic()).collect();
    // Hollow marks are drawn over solid ones, so both stay visible.
    shown.sort_by_key(|entry| (!entry.is_compliant(), is_linear(entry.name())));
    shown.into_iter().map(curve).collect()
}

/// Name of a row of the figure.
fn name(compared: &Compared<'_>) -> String {
    let scene = &compared.played.scene;
    let scene = scene.replace("layout ", "").replace("structures", "").replace(',', "");
    let scene = scene.split_whitespace().collect::<Vec<_>>().join(" ");
    let place = match compared.item.structure {
        None => "",
        Some(1) => " left",
        Some(number) if number == compared.played.n_structures => " right",
        Some(_) => " middle",
    };
    capital(&scene) + place
}
