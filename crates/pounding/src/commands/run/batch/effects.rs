//! What pounding does to every storey under the records of a folder.

use pounding::assess::{Distribution, Effects};
use pounding::text::two_decimals;

use super::{Found, Line};
use crate::text::{NONE, paragraph, table};

/// A table with a line for every storey; nothing where nobody asked.
pub(super) fn text(lines: &[Line]) -> Vec<String> {
    let found = lines.iter().filter_map(|line| line.found.as_ref().ok());
    let all: Vec<(&Found, &Effects)> = found.filter_map(|found| Some((found, found.effects.as_ref()?))).collect();
    let Some((first, _)) = all.first() else {
        return Vec::new();
    };
    let header = [
        ["Storey,", "median / 84 %"],
        ["Drift", "× alone"],
        ["Shear", "× alone"],
        ["Acceleration", "× alone"],
    ];
    let floors = &first.floors;
    let moving = floors.by_structure().filter(|floor| !floors.all()[*floor].is_wall());
    let row = |floor: usize| {
        let ratio = |response: usize| {
            let both = all.iter().flat_map(|(_, one)| [&one.as_given[floor], &one.reversed[floor]]);
            let ratios = both.filter_map(|one| Some(one.responses()[response]?.amplification?.value));
            Distribution::of(ratios).map_or(NONE.into(), |all| {
                format!("{} / {}", two_decimals(all.median()), two_decimals(all.p84()))
            })
        };
        vec![floors.all()[floor].name.clone(), ratio(0), ratio(1), ratio(2)]
    };
    let rows: Vec<_> = moving.map(row).collect();
    let notes = format!(
        "peaks beside the neighbours over those of the same building alone, by the exact method, under {} motions in both directions; \
         --csv has every motion, --json also how far a change of the record by 1 % moves each number",
        all.len()
    );
    vec![table(&header, &rows), paragraph("Effects", &notes)]
}
