//! The table of the numbers of two neighbours.

use pounding_text::{digits, rounded_down, short};

use super::values::RunValues;
use pounding_text::Unit;

use super::{QuantityEntry, QuantityKind, quantities};
use crate::PairOutcome;
use crate::QuantityGroup;

quantities! {
    /// A number of two neighbours that can touch.
    PairQuantity, Pair:
    #[serde(skip_deserializing)]
    GapM("gap_m", "Gap at rest.") = QuantityEntry {
        text: digits,
        ..QuantityEntry::new(&Unit::METRE, "Gap", |run, pair| Some(run.simulation.pairs()[pair].gap())).kind(QuantityKind::Model)
    };
    Collisions("collisions", "Number of collisions, each from touch to parting.") =
        QuantityEntry::new(&Unit::COUNT, "Collisions", |run, pair| Some(run.pair(pair).collisions as f64))
            .kind(QuantityKind::Count).measured(QuantityGroup::All, "collisions");
    FirstStartS("first_start_s", "Start of the first collision.") = QuantityEntry {
        least: |run, pair| if run.pair(pair).first.is_some_and(|first| first.start < RunValues::AT_ONCE) { 1.0 } else { 0.0 },
        absolute: Some("first_start_s"),
        collision: Some("first"),
        text: digits,
        ..QuantityEntry::new(&Unit::SECOND, "First", |run, pair| Some(run.pair(pair).first?.start))
            .kind(QuantityKind::First).measured(QuantityGroup::Time, "first touch")
    };
    FirstImpulseNS("first_impulse_n_s", "Impulse of the first collision.") = QuantityEntry {
        collision: Some("first"),
        ..QuantityEntry::new(&Unit::NEWTON_SECOND, "First impulse", |run, pair| Some(run.pair(pair).first?.impulse))
            .measured(QuantityGroup::Impulse, "first impulse")
    };
    #[serde(skip_deserializing)]
    LargestStartS("largest_start_s", "Start of the collision with the largest impulse.") = QuantityEntry {
        collision: Some("largest"),
        ..QuantityEntry::instant(|run, pair| Some(run.pair(pair).largest?.start))
    };
    LargestImpulseNS("largest_impulse_n_s", "Largest impulse of a collision.") = QuantityEntry {
        collision: Some("largest"),
        ..QuantityEntry::new(&Unit::NEWTON_SECOND, "Largest impulse", |run, pair| Some(run.pair(pair).largest?.impulse))
            .measured(QuantityGroup::Impulse, "largest impulse")
    };
    PeakForceN("peak_force_n", "Largest pounding force; none if one of the collisions is an impact.") =
        QuantityEntry::new(&Unit::POUNDING_FORCE, "Peak force", |run, pair| Some(run.pair(pair).peak_force?.value))
            .measured(QuantityGroup::Force, "pounding force");
    #[serde(skip_deserializing)]
    PeakForceTimeS("peak_force_time_s", "First instant of the peak force.") =
        QuantityEntry::instant(|run, pair| Some(run.pair(pair).peak_force?.time));
    #[serde(skip_deserializing)]
    ColumnShearN("column_shear_n", "Largest shear force in the column that a slab hits, of one column; none between floors.") =
        QuantityEntry::new(&Unit::POUNDING_FORCE, "Column shear", |run, pair| Some(run.column_forces(pair)?[0]));
    #[serde(skip_deserializing)]
    ColumnMomentNM("column_moment_nm", "Largest bending moment in the column that a slab hits, of one column; none between floors.") =
        QuantityEntry::new(&Unit::MOMENT, "Column moment", |run, pair| Some(run.column_forces(pair)?[1]));
    TotalImpulseNS("total_impulse_n_s", "Sum of all impulses.") =
        QuantityEntry::new(&Unit::NEWTON_SECOND, "Total impulse", |run, pair| Some(run.pair(pair).total_impulse))
            .kind(QuantityKind::Total).measured(QuantityGroup::Impulse, "total impulse");
    TouchingS("touching_s", "Time for which they touch, all collisions together; a pair that overlaps without a force no longer counts.") = QuantityEntry {
        least: |_, _| PairOutcome::LEANS,
        ..QuantityEntry::new(&Unit::SECOND, "Touching", |run, pair| Some(run.pair(pair).touching))
            .kind(QuantityKind::Total).measured(QuantityGroup::Time, "time of touching")
    };
    LeastOpeningM("least_opening_m", "Least opening of the gap, 0 or less if they touch; coarse steps can pass below 0 between two nodes without a touch.") = QuantityEntry {
        least: |run, pair| run.least_of_openings(pair),
        text: opening,
        ..QuantityEntry::new(&Unit::METRE, "Least opening", |run, pair| Some(run.opening(pair)?.0))
            .kind(QuantityKind::Least).measured(QuantityGroup::Displacement, "least opening")
    };
    #[serde(skip_deserializing)]
    LeastOpeningTimeS("least_opening_time_s", "Instant of the least opening.") = QuantityEntry::instant(|run, pair| Some(run.opening(pair)?.1));
    LargestOpeningM("largest_opening_m", "Largest opening of the gap.") = QuantityEntry {
        least: |run, pair| run.least_of_openings(pair),
        ..QuantityEntry::new(&Unit::METRE, "Largest opening", |run, pair| Some(run.simulation.pairs()[pair].gap() + run.widening(pair)?.distance))
            .measured(QuantityGroup::Displacement, "largest opening")
    };
    #[serde(skip_deserializing)]
    LargestOpeningTimeS("largest_opening_time_s", "Instant of the largest opening.") =
        QuantityEntry::instant(|run, pair| Some(run.widening(pair)?.time));
    UnseatedS("unseated_s", "First instant at which the right floor has moved farther from the left one than its seat is wide; only of contacts with a seat.") =
        QuantityEntry::new(&Unit::SECOND, "Unseated", |run, pair| run.widening(pair)?.unseated)
            .kind(QuantityKind::First).measured(QuantityGroup::Time, "loss of the seat");
}

/// Writes the least opening of a gap \[mm\], or by how much it is overrun.
fn opening(millimetres: f64) -> String {
    if millimetres > 0.0 {
        rounded_down(millimetres, if millimetres < 1.0 { 4 } else { 1 })
    } else {
        short(millimetres)
    }
}
