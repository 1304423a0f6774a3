//! Responses beyond the model or the limits of codes, gathered over several runs.

use std::cmp::Ordering;
use std::collections::BTreeSet;

use super::excess_kind::ExcessKind;
use super::response::{Excess, Often};

impl Excess {
    /// Gathers responses over several samples, such as runs, the most harmful kind first. Each kind has its worst above a general limit
    /// and its worst above a capacity of the scene, with the number of samples in which the same storey exceeds that limit. A sample is
    /// [all of its responses](crate::Simulation::all_excesses). `sample` is the word for a sample.
    pub fn gathered(samples: impl IntoIterator<Item: AsRef<[Self]>>, sample: &'static str) -> Vec<Self> {
        let samples: Vec<_> = samples.into_iter().collect();
        let all = samples.iter().flat_map(|one| one.as_ref().iter().cloned());
        let mut worst: Vec<Self> = all.collect();
        Self::keep_worst(&mut worst);
        let of = samples.len();
        for one in &mut worst {
            let with = samples
                .iter()
                .filter(|sample| sample.as_ref().iter().any(|other| one.is_of_same(other)));
            one.often = Some(Often {
                n: with.count(),
                of,
                sample,
            });
        }
        worst
    }

    /// Returns the worst response of every kind above a general limit and above a capacity of the scene, the most harmful kind first; of
    /// equal ones the first.
    pub fn worst(mut all: Vec<Self>) -> Vec<Self> {
        Self::keep_worst(&mut all);
        all
    }

    fn keep_worst(all: &mut Vec<Self>) {
        all.sort_by(Self::by_kind_and_share);
        let mut said = BTreeSet::new();
        all.retain(|one| said.insert((one.kind, one.capacity.is_some())));
    }

    fn by_kind_and_share(&self, other: &Self) -> Ordering {
        self.kind.cmp(&other.kind).then(other.share().total_cmp(&self.share()))
    }

    /// Whether both are of one storey above one limit, general or of the scene. A column that is hit has the number of the others in its name,
    /// and stands for all of them.
    fn is_of_same(&self, other: &Self) -> bool {
        let is_place = self.kind == ExcessKind::ColumnHit || self.name == other.name;
        is_place && self.kind == other.kind && self.capacity.is_some() == other.capacity.is_some()
    }
}
