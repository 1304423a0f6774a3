//! The table of the numbers of a link.

use pounding_solver::LinkPeak;
use pounding_text::Unit;

use super::{QuantityEntry, quantities};
use crate::RunValues;

quantities! {
    /// A number of a link.
    LinkQuantity, Link:
    PeakPushN("peak_push_n", "Largest force that pushes both ends apart; 0 if the link never pushes.") =
        QuantityEntry::new(&Unit::NEWTON, "Push", |run, link| Some(run.link(link)?.push.value));
    PeakPushTimeS("peak_push_time_s", "First instant of the largest push.") =
        QuantityEntry::instant(|run, link| acts(run.link(link)?.push));
    PeakPullN("peak_pull_n", "Largest force that pulls both ends together, as a magnitude; 0 if the link never pulls.") =
        QuantityEntry::new(&Unit::NEWTON, "Pull", |run, link| Some(run.link(link)?.pull.value.abs()));
    PeakPullTimeS("peak_pull_time_s", "First instant of the largest pull.") =
        QuantityEntry::instant(|run, link| acts(run.link(link)?.pull));
    LargestShorteningM("largest_shortening_m", "Largest shortening of the link.") =
        QuantityEntry::new(&Unit::METRE, "Shortening", |run, link| Some(run.link(link)?.shortening.value));
    LargestElongationM("largest_elongation_m", "Largest elongation of the link, as a magnitude.") =
        QuantityEntry::new(&Unit::METRE, "Elongation", |run, link| Some(run.link(link)?.elongation.value.abs()));
    LinkEnergyJ("link_energy_j", "Energy that the link took from the floors, including what it still stores.") =
        QuantityEntry::new(&Unit::ENERGY, "Energy", |run, link| {
            let energy = run.result.link_energies.get(link)?;
            Some(if run.is_rounding(link, *energy) { 0.0 } else { *energy })
        });
}

/// Part of the product of largest force and largest deformation that is rounding.
const ROUNDING: f64 = 1e-9;

fn acts(peak: pounding_solver::Peak) -> Option<f64> {
    (peak.value.abs() > 0.0).then_some(peak.time)
}

impl RunValues<'_> {
    /// Whether an energy of a link \[J\] is rounding, as that of an elastic link which has come to rest.
    fn is_rounding(&self, link: usize, energy: f64) -> bool {
        self.link(link).is_none_or(|peak| {
            let force = peak.push.value.max(-peak.pull.value);
            let way = peak.shortening.value.max(-peak.elongation.value);
            energy.abs() <= ROUNDING * force * way
        })
    }

    /// Peaks of a link; `None` if the row has none.
    pub(crate) fn link(&self, link: usize) -> Option<LinkPeak> {
        self.result.links.as_ref().map(|links| links.of(link))
    }
}
