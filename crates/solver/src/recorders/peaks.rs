use crate::{Impact, Recorder, Span, State};

/// Value of largest magnitude and when it occurred.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Peak {
    /// The value, with its sign.
    pub value: f64,
    /// Its first instant \[s\].
    pub time: f64,
}

impl Peak {
    fn take(&mut self, value: f64, time: f64) {
        if value.abs() > self.value.abs() {
            *self = Self { value, time };
        }
    }
}

/// Peaks of one structure.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct StructurePeaks {
    /// Displacement \[m\].
    pub displacement: Peak,
    /// Restoring force (shear force of the structure) \[N\].
    pub restoring_force: Peak,
    /// Net pounding force \[N\]; stays 0 where contact is impulsive.
    pub pounding_force: Peak,
}

/// Records the peaks of every structure at the ends of spans.
#[derive(Debug, Clone, PartialEq)]
pub struct Peaks {
    structures: Vec<StructurePeaks>,
}

impl Peaks {
    /// For a row of `n_structures`, walls included.
    pub fn new(n_structures: usize) -> Self {
        Self {
            structures: vec![StructurePeaks::default(); n_structures],
        }
    }

    /// Peaks of one structure, counted from the left.
    pub fn of(&self, structure: usize) -> &StructurePeaks {
        &self.structures[structure]
    }
}

impl Recorder for Peaks {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        let peaks = &mut self.structures[span.structure];
        let mut take = |state: &State, time| {
            peaks.displacement.take(state.displacement, time);
            peaks.restoring_force.take(state.restoring_force, time);
            peaks.pounding_force.take(state.pounding_force(), time);
        };
        if span.start_time == 0.0 {
            take(&span.start, 0.0);
        }
        take(&span.end, span.end_time);
    }

    fn impact(&mut self, _: &Impact) {}
}
