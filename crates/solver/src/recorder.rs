/// State of a structure at an instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct State {
    /// Displacement u relative to the ground \[m\], positive to the right.
    pub displacement: f64,
    /// Velocity u̇ \[m/s\].
    pub velocity: f64,
    /// Acceleration ü relative to the ground \[m/s²\].
    pub acceleration: f64,
    /// Restoring force `f_s` \[N\].
    pub restoring_force: f64,
    /// Pounding force from the left neighbour \[N\], ≥ 0 (it pushes to the right).
    pub force_from_left: f64,
    /// Pounding force from the right neighbour \[N\], ≤ 0 (it pushes to the left).
    pub force_from_right: f64,
}

impl State {
    /// Net pounding force \[N\], positive to the right.
    pub fn pounding_force(&self) -> f64 {
        self.force_from_left + self.force_from_right
    }
}

/// The motion of one structure between two instants.
///
/// Spans of a structure follow each other without a gap from t = 0 on; the end of one and the start of the next
/// differ only in velocity and acceleration, and only where an [`Impact`] was reported.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Index of the structure, from the left.
    pub structure: usize,
    /// Start \[s\].
    pub start_time: f64,
    /// End \[s\].
    pub end_time: f64,
    /// State at the start.
    pub start: State,
    /// State at the end.
    pub end: State,
}

impl Span {
    /// Duration \[s\].
    pub fn duration(&self) -> f64 {
        self.end_time - self.start_time
    }

    /// State at an instant inside the span.
    ///
    /// Displacement and velocity are the cubic through displacements and velocities of both ends; forces and
    /// acceleration are linear.
    pub fn at(&self, time: f64) -> State {
        let h = self.duration();
        let s = (time - self.start_time) / h;
        let r = 1.0 - s;
        let linear = |a: f64, b: f64| r * a + s * b;
        let (a, b) = (&self.start, &self.end);
        let rise = b.displacement - a.displacement;
        State {
            displacement: linear(a.displacement, b.displacement)
                + s * r * (r * (a.velocity * h - rise) - s * (b.velocity * h - rise)),
            velocity: 6.0 * s * r * rise / h
                + r * (r - 2.0 * s) * a.velocity
                + s * (s - 2.0 * r) * b.velocity,
            acceleration: linear(a.acceleration, b.acceleration),
            restoring_force: linear(a.restoring_force, b.restoring_force),
            force_from_left: linear(a.force_from_left, b.force_from_left),
            force_from_right: linear(a.force_from_right, b.force_from_right),
        }
    }
}

/// Velocities of a pair \[m/s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocities {
    /// Of the left neighbour.
    pub left: f64,
    /// Of the right neighbour.
    pub right: f64,
}

/// An impulsive impact of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// Index of the pair in its row.
    pub pair: usize,
    /// Index of the left structure.
    pub left: usize,
    /// Index of the right structure.
    pub right: usize,
    /// Instant \[s\].
    pub time: f64,
    /// Impulse P \[N·s\], ≥ 0; the left structure gets −P, the right one +P.
    pub impulse: f64,
    /// Velocities before everything that happens at this instant.
    pub before: Velocities,
    /// Velocities after everything that happens at this instant.
    pub after: Velocities,
}

/// What a run reports to: borrowed spans and impacts in the order of time.
///
/// `()` records nothing and costs nothing; a tuple records what its members do.
pub trait Recorder {
    /// Sees the motion of one structure over one span.
    fn span(&mut self, span: &Span);

    /// Sees one impact; the spans that end at its instant came before.
    fn impact(&mut self, impact: &Impact);
}

impl Recorder for () {
    fn span(&mut self, _: &Span) {}
    fn impact(&mut self, _: &Impact) {}
}

macro_rules! record_in_each {
    ($($name:ident)+) => {
        impl<$($name: Recorder),+> Recorder for ($($name,)+) {
            #[expect(non_snake_case, reason = "type names serve as variables")]
            fn span(&mut self, span: &Span) {
                let ($($name,)+) = self;
                $($name.span(span);)+
            }
            #[expect(non_snake_case, reason = "type names serve as variables")]
            fn impact(&mut self, impact: &Impact) {
                let ($($name,)+) = self;
                $($name.impact(impact);)+
            }
        }
    };
}
record_in_each!(A B);
record_in_each!(A B C);
record_in_each!(A B C D);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_a_cubic_is_followed_exactly() {
        let path = |t: f64| State {
            displacement: 1.0 - 2.0 * t + 3.0 * t * t - 0.5 * t * t * t,
            velocity: -2.0 + 6.0 * t - 1.5 * t * t,
            acceleration: 6.0 - 3.0 * t,
            ..State::default()
        };
        let span = Span {
            structure: 0,
            start_time: 0.5,
            end_time: 2.5,
            start: path(0.5),
            end: path(2.5),
        };
        for time in [0.5, 0.7, 1.3, 2.2, 2.5] {
            let (found, wanted) = (span.at(time), path(time));
            assert!(
                (found.displacement - wanted.displacement).abs() < 1e-14,
                "{time}: {found:?}"
            );
            assert!(
                (found.velocity - wanted.velocity).abs() < 1e-14,
                "{time}: {found:?}"
            );
            assert!(
                (found.acceleration - wanted.acceleration).abs() < 1e-14,
                "{time}: {found:?}"
            );
        }
    }
}
