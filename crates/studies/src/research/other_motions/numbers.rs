//! The numbers of every scene, and what the direction alone changes in them.

use super::shaking::Shaking;
use super::world::{MotionCase, Numbers, Row};
use pounding_text::digits;
use pounding_text::to_csv;

/// Columns that say which structure of which scene.
const KEYS: [&str; 5] = ["table", "scene", "structure", "name", "motion"];

/// A direction in words.
pub(super) fn direction(reversed: bool) -> &'static str {
    if reversed { "reversed" } else { "as recorded" }
}

fn keys(row: &Row, motion: &Shaking) -> Vec<String> {
    vec![
        row.table.clone(),
        row.scene.clone(),
        row.number.to_string(),
        row.structure.clone(),
        motion.name.clone(),
    ]
}

/// Rows of the same structure under every motion stand together.
fn structures(worlds: &[[MotionCase; 2]]) -> std::ops::Range<usize> {
    0..worlds.first().map_or(0, |[world, _]| world.rows.len())
}

/// A row per scene, structure, motion and direction.
pub(super) fn table(motions: &[Shaking], worlds: &[[MotionCase; 2]]) -> String {
    let mut header = KEYS.to_vec();
    header.extend([
        "direction",
        "transferred_momentum_kn_s",
        "collisions",
        "first_touch_s",
        "first_impulse_kn_s",
        "peak_displacement_mm",
        "alone_mm",
        "over_alone",
        "residual_displacement_mm",
        "peak_shear_kn",
    ]);
    let mut rows = Vec::new();
    for structure in structures(worlds) {
        for (motion, world) in motions.iter().zip(worlds) {
            for (world, reversed) in world.iter().zip([false, true]) {
                let row = &world.rows[structure];
                let mut cells = keys(row, motion);
                cells.push(direction(reversed).into());
                cells.extend(printed(&row.numbers));
                rows.push(cells);
            }
        }
    }
    to_csv(&header.into_iter().map(String::from).collect::<Vec<_>>(), &rows)
}

fn printed(numbers: &Numbers) -> [String; 9] {
    let known = |number: Option<f64>| number.map_or_else(String::new, digits);
    [
        digits(numbers.momentum / 1e3),
        numbers.collisions.to_string(),
        known(numbers.first.map(|(start, _)| start)),
        known(numbers.first.map(|(_, impulse)| impulse / 1e3)),
        digits(1e3 * numbers.displacement),
        digits(1e3 * numbers.alone),
        known(numbers.amplification()),
        known(numbers.residual.map(|residual| 1e3 * residual)),
        digits(numbers.shear / 1e3),
    ]
}

/// Every number under the reversed motion over the one under the motion as recorded, without signs; empty where there is
/// nothing to divide by.
pub(super) fn directions(motions: &[Shaking], worlds: &[[MotionCase; 2]]) -> String {
    let mut header = KEYS.to_vec();
    header.extend([
        "transferred_momentum",
        "collisions",
        "first_touch",
        "first_impulse",
        "peak_displacement",
        "residual_displacement",
        "peak_shear",
    ]);
    let mut rows = Vec::new();
    for structure in structures(worlds) {
        for (motion, [recorded, reversed]) in motions.iter().zip(worlds) {
            let row = &recorded.rows[structure];
            let (one, other) = (&row.numbers, &reversed.rows[structure].numbers);
            let mut cells = keys(row, motion);
            cells.extend(ratios(one, other).map(|ratio| ratio.map_or_else(String::new, digits)));
            rows.push(cells);
        }
    }
    to_csv(&header.into_iter().map(String::from).collect::<Vec<_>>(), &rows)
}

fn ratios(recorded: &Numbers, reversed: &Numbers) -> [Option<f64>; 7] {
    let quantities: [fn(&Numbers) -> Option<f64>; 7] = [
        |numbers| Some(numbers.momentum),
        |numbers| Some(numbers.collisions as f64),
        |numbers| numbers.first.map(|(start, _)| start),
        |numbers| numbers.first.map(|(_, impulse)| impulse),
        |numbers| Some(numbers.displacement),
        |numbers| numbers.residual,
        |numbers| Some(numbers.shear),
    ];
    quantities.map(|quantity| {
        let ratio = quantity(reversed)? / quantity(recorded)?;
        ratio.is_finite().then(|| ratio.abs())
    })
}
