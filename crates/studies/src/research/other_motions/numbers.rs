//! Tables of the numbers of every scene, and of the effect of the direction alone.

use super::shaking::Shaking;
use super::world::{MotionCase, StructureResult};
use crate::files::direction;
use pounding_text::Table;

/// The keys of a table row: a structure of a scene under a motion.
trait Keys {
    fn keys(&self) -> (&StructureResult, &Shaking);
}

/// A table whose first columns name the motion, scene and structure of a row.
fn keyed<'a, One: Keys + 'a>(rows: impl Iterator<Item = One>) -> Table<'a, One> {
    Table::of(rows)
        .column("table", |one: &One| one.keys().0.table.clone())
        .column("scene", |one| one.keys().0.scene.clone())
        .column("structure", |one| one.keys().0.number)
        .column("name", |one| one.keys().0.structure.clone())
        .column("motion", |one| one.keys().1.name.clone())
}

/// Results under a motion in one direction.
struct Directed<'a> {
    result: &'a StructureResult,
    motion: &'a Shaking,
    reversed: bool,
}

impl Keys for Directed<'_> {
    fn keys(&self) -> (&StructureResult, &Shaking) {
        (self.result, self.motion)
    }
}

/// Results under a motion, as given and reversed.
struct Both<'a> {
    results: [&'a StructureResult; 2],
    motion: &'a Shaking,
}

impl Keys for Both<'_> {
    fn keys(&self) -> (&StructureResult, &Shaking) {
        (self.results[0], self.motion)
    }
}

/// Pairs the rows of both directions; rows of one structure under every motion follow each other.
fn both<'a>(motions: &'a [Shaking], worlds: &'a [[MotionCase; 2]]) -> impl Iterator<Item = Both<'a>> {
    let structures = 0..worlds.first().map_or(0, |[world, _]| world.rows.len());
    structures.flat_map(move |structure| {
        let of_motion = move |(motion, both): (_, &'a [MotionCase; 2])| Both {
            results: both.each_ref().map(|world| &world.rows[structure]),
            motion,
        };
        motions.iter().zip(worlds).map(of_motion)
    })
}

/// Table with one row per scene, structure, motion and direction.
pub(super) fn table(motions: &[Shaking], worlds: &[[MotionCase; 2]]) -> String {
    let directed = both(motions, worlds).flat_map(|Both { results, motion }| {
        let of_direction = |reversed| Directed {
            result: results[usize::from(reversed)],
            motion,
            reversed,
        };
        [false, true].map(of_direction)
    });
    keyed(directed)
        .column("direction", |one| direction(one.reversed))
        .column("transferred_momentum_kn_s", |one| one.result.momentum / 1e3)
        .column("collisions", |one| one.result.collisions)
        .column("first_touch_s", |one| one.result.first.map(|(start, _)| start))
        .column("first_impulse_kn_s", |one| one.result.first.map(|(_, impulse)| impulse / 1e3))
        .column("peak_displacement_mm", |one| 1e3 * one.result.displacement)
        .column("alone_mm", |one| 1e3 * one.result.alone)
        .column("over_alone", |one| one.result.amplification())
        .column("residual_displacement_mm", |one| one.result.residual.map(|residual| 1e3 * residual))
        .column("peak_shear_kn", |one| one.result.shear / 1e3)
        .csv()
}

/// A number of a row; `None` if the row does not have it.
type Number = fn(&StructureResult) -> Option<f64>;

/// Numbers to compare between the two directions.
const COMPARED: [(&str, Number); 7] = [
    ("transferred_momentum", |row| Some(row.momentum)),
    ("collisions", |row| Some(row.collisions as f64)),
    ("first_touch", |row| row.first.map(|(start, _)| start)),
    ("first_impulse", |row| row.first.map(|(_, impulse)| impulse)),
    ("peak_displacement", |row| Some(row.displacement)),
    ("residual_displacement", |row| row.residual),
    ("peak_shear", |row| Some(row.shear)),
];

/// Table of every number under the reversed motion over the number under the motion as given, without signs. A cell is empty if the
/// divisor is zero.
pub(super) fn directions(motions: &[Shaking], worlds: &[[MotionCase; 2]]) -> String {
    let ratio = |one: &Both<'_>, (_, number): (&str, Number)| {
        let [recorded, reversed] = one.results.map(number);
        Some((reversed? / recorded?).abs())
    };
    keyed(both(motions, worlds)).columns(COMPARED, |(name, _)| name.into(), ratio).csv()
}
