//! Velocity and displacement of the ground.

use crate::Record;

/// Velocity and displacement of the ground at the samples of a record.
#[derive(Debug, Clone, PartialEq)]
pub struct Integrated {
    /// Velocity at t = 0, Δt, 2Δt, … \[m/s\].
    pub velocity: Vec<f64>,
    /// Displacement at these times \[m\].
    pub displacement: Vec<f64>,
}

/// A step between two samples: acceleration at both ends \[m/s²\], velocity and displacement at the start.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    pub(crate) accelerations: [f64; 2],
    pub(crate) velocity: f64,
    pub(crate) displacement: f64,
}

impl Step {
    /// Velocity \[m/s\] and displacement \[m\] some time \[s\] after the start of a step of `time_step` \[s\].
    pub(crate) fn at(&self, time: f64, time_step: f64) -> [f64; 2] {
        let [start, end] = self.accelerations;
        let rise = (end - start) * (time / time_step);
        [
            self.velocity + time * (start + 0.5 * rise),
            self.displacement + time * (self.velocity + time * (0.5 * start + rise / 6.0)),
        ]
    }
}

impl Record {
    /// Returns velocity and displacement of the ground, which starts from rest.
    ///
    /// The integrals are those of an acceleration that is linear between samples, exact to rounding. The baseline is not corrected, so an
    /// offset of the record shows in velocity and displacement.
    pub fn integrated(&self) -> Integrated {
        let mut velocity = vec![0.0];
        let mut displacement = vec![0.0];
        for step in self.steps() {
            let [v, u] = step.at(self.time_step(), self.time_step());
            velocity.push(v);
            displacement.push(u);
        }
        Integrated { velocity, displacement }
    }

    /// The steps between samples: one fewer than there are samples.
    pub(crate) fn steps(&self) -> impl Iterator<Item = Step> {
        let start = [0.0, 0.0];
        self.samples().windows(2).scan(start, |[velocity, displacement], pair| {
            let step = Step {
                accelerations: [pair[0], pair[1]],
                velocity: *velocity,
                displacement: *displacement,
            };
            [*velocity, *displacement] = step.at(self.time_step(), self.time_step());
            Some(step)
        })
    }
}
