use crate::span::{Load, Path, Weighed, Weights};
use crate::{Relation, Span, State};

/// Velocities of a pair \[m/s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocities {
    /// Velocity of the left neighbour.
    pub left: f64,
    /// Velocity of the right neighbour.
    pub right: f64,
}

/// A floor hit by an impact.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Struck {
    /// Node of the floor.
    pub floor: usize,
    /// Part of the impulse on the floor \[–\]: negative on the left of the pair, which is pushed to the left.
    pub part: f64,
    /// Velocities before and after everything at this instant \[m/s\].
    pub velocities: [f64; 2],
}

/// An impulsive impact of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// Index of the pair in its row.
    pub pair: usize,
    /// Index of the left structure; for a point between two floors, the nearer floor.
    pub left: usize,
    /// Index of the right structure; for a point between two floors, the nearer floor.
    pub right: usize,
    /// The floors that carry both points, at least two.
    pub floors: [Option<Struck>; 4],
    /// Instant \[s\].
    pub time: f64,
    /// Impulse P \[N·s\], ≥ 0; the left structure gets −P, the right one +P.
    pub impulse: f64,
    /// Velocities of both points before everything at this instant.
    pub before: Velocities,
    /// Velocities of both points after everything at this instant.
    pub after: Velocities,
    /// Rate at which the two grounds move towards each other \[m/s\]. The rate of deformation is this rate plus the difference of the
    /// velocities, which are relative to the grounds. 0 if the ground motion arrives at both at once.
    pub opening_rate: f64,
}

impl Impact {
    /// An impact of two points, from the velocities of floors before and after. Pair, instant, impulse and rate of the grounds are still to
    /// be set.
    pub(crate) fn of(relation: &Relation, before: impl Fn(usize) -> f64, after: impl Fn(usize) -> f64) -> Self {
        let mut floors = [None; 4];
        for (place, (floor, part)) in floors.iter_mut().zip(relation.pushes()) {
            *place = Some(Struck {
                floor,
                part,
                velocities: [before(floor), after(floor)],
            });
        }
        let Relation { left, right, .. } = *relation;
        Self {
            pair: 0,
            left: left.floor(),
            right: right.floor(),
            floors,
            time: 0.0,
            impulse: 0.0,
            before: Velocities {
                left: left.of(&before),
                right: right.of(&before),
            },
            after: Velocities {
                left: left.of(&after),
                right: right.of(&after),
            },
            opening_rate: 0.0,
        }
    }

    /// The floors hit by the impact.
    pub fn struck(&self) -> impl Iterator<Item = Struck> + Clone {
        self.floors.into_iter().flatten()
    }

    /// Rates of deformation of the pair before and after \[m/s\], positive while approaching.
    pub fn rates(&self) -> [f64; 2] {
        [self.before, self.after].map(|at| at.left - at.right + self.opening_rate)
    }
}

/// The closing of a gap, from a method that finds the instant; stepping methods report none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Index of the pair in its row.
    pub pair: usize,
    /// Instant \[s\].
    pub time: f64,
    /// Rate of deformation at which the pair approaches v₀ \[m/s\], ≥ 0.
    pub approach_speed: f64,
    /// Half the width of the interval of the instant due to rounding \[s\], ≥ 0; infinite for a touch of a pair that moves alike.
    ///
    /// Let s = 8ε (|u| of both structures + gap, each the largest so far), v ≥ 0 the approach rate, a the relative acceleration and ε =
    /// 2⁻⁵². The value is min(2s / (v + √max(v² − 2|a|s, 0)), √(2s/|a|)) + εt. This is s/v for a transversal touch and √(2s/|a|) for a
    /// grazing touch. Earlier effects of rounding in the run are not included.
    pub uncertainty: f64,
}

impl Touch {
    /// The uncertainty of a touch from s, v and a.
    pub(crate) fn uncertainty(time: f64, deformation: f64, rate: f64, acceleration: f64) -> f64 {
        let (rate, bend) = (rate.max(0.0), 2.0 * acceleration.abs() * deformation);
        let transversal = 2.0 * deformation / (rate + (rate * rate - bend).max(0.0).sqrt());
        let grazing = (2.0 * deformation / acceleration.abs()).sqrt();
        // Structures at zero without a gap are at zero exactly.
        let reach = if deformation > 0.0 { transversal.min(grazing) } else { 0.0 };
        reach + f64::EPSILON * time
    }
}

/// Receiver of the results of a run: borrowed spans and impacts in the order of time.
///
/// `()` records nothing and costs nothing. A tuple passes everything to its members.
pub trait Recorder {
    /// Whether the recorder reads the impulses of [`Weighed`](crate::Weighed). If no recorder reads them, they are 0 and cost nothing.
    /// Called for every span; the answer must not change.
    fn reads_weighed(&self) -> bool {
        false
    }

    /// Receives the motion of a structure over a span.
    fn span(&mut self, span: &Span<'_>);

    /// Receives an impact; the spans that end at its instant came before.
    fn impact(&mut self, impact: &Impact);

    /// Receives a touch, before its consequences: an impact at this instant, or spans with a pounding force that start here.
    fn touch(&mut self, _: &Touch) {}

    /// The storey that has fallen, by its floor, and the instant \[s\]: a run ends there. `None` as long as all stand.
    fn fallen(&self) -> Option<(usize, f64)> {
        None
    }

    /// Drift at which the storey of a floor counts as fallen \[m\]; infinite if it never does.
    fn falls_at(&self, _structure: usize) -> f64 {
        f64::INFINITY
    }
}

impl Span<'_> {
    /// Makes the path of a step, with impulses only if a recorder reads them.
    #[inline]
    pub(crate) fn step<const N: usize>(
        reads_weighed: bool,
        structure: usize,
        [start_time, end_time]: [f64; 2],
        [start, end]: [State; 2],
        weights: Weights<N>,
        loads: [Load; N],
    ) -> Self {
        let weigh = |force: fn(&Load) -> f64| {
            let terms = weights.of_loads.iter().zip(&loads);
            let sum = terms.map(|(weight, load)| weight * force(load));
            weights.scale * sum.reduce(|sum, term| sum + term).unwrap_or(0.0)
        };
        let weighed = if reads_weighed {
            Weighed {
                restoring: -weigh(|load| load.restoring),
                damping: -weigh(|load| load.damping),
                ground_velocity: weigh(|load| load.ground),
            }
        } else {
            Weighed::default()
        };
        Self {
            structure,
            start_time,
            end_time,
            start,
            end,
            impulse_from_left: weigh(|load| load.from_left),
            impulse_from_right: weigh(|load| load.from_right),
            below: None,
            path: Path::Cubic(weighed),
            pushes: &[],
            links: &[],
        }
    }
}

impl Recorder for () {
    fn span(&mut self, _: &Span<'_>) {}
    fn impact(&mut self, _: &Impact) {}
}

impl<R: Recorder> Recorder for &mut R {
    #[inline]
    fn fallen(&self) -> Option<(usize, f64)> {
        (**self).fallen()
    }

    fn falls_at(&self, structure: usize) -> f64 {
        (**self).falls_at(structure)
    }

    #[inline]
    fn reads_weighed(&self) -> bool {
        (**self).reads_weighed()
    }

    fn span(&mut self, span: &Span<'_>) {
        (**self).span(span);
    }

    fn impact(&mut self, impact: &Impact) {
        (**self).impact(impact);
    }

    fn touch(&mut self, touch: &Touch) {
        (**self).touch(touch);
    }
}

/// Records only if there is a recorder: runs with and without the recorder then have a common type.
impl<R: Recorder> Recorder for Option<R> {
    #[inline]
    fn reads_weighed(&self) -> bool {
        self.as_ref().is_some_and(Recorder::reads_weighed)
    }

    fn span(&mut self, span: &Span<'_>) {
        if let Some(recorder) = self {
            recorder.span(span);
        }
    }

    fn impact(&mut self, impact: &Impact) {
        if let Some(recorder) = self {
            recorder.impact(impact);
        }
    }

    fn touch(&mut self, touch: &Touch) {
        if let Some(recorder) = self {
            recorder.touch(touch);
        }
    }
}

macro_rules! record_in_each {
    ($($name:ident)+) => {
        impl<$($name: Recorder),+> Recorder for ($($name,)+) {
            #[inline]
            #[expect(non_snake_case, reason = "type names serve as variables")]
            fn reads_weighed(&self) -> bool {
                let ($($name,)+) = self;
                $($name.reads_weighed())||+
            }
            #[expect(non_snake_case, reason = "type names serve as variables")]
            fn span(&mut self, span: &Span<'_>) {
                let ($($name,)+) = self;
                $($name.span(span);)+
            }
            #[expect(non_snake_case, reason = "type names serve as variables")]
            fn impact(&mut self, impact: &Impact) {
                let ($($name,)+) = self;
                $($name.impact(impact);)+
            }
            #[expect(non_snake_case, reason = "type names serve as variables")]
            fn touch(&mut self, touch: &Touch) {
                let ($($name,)+) = self;
                $($name.touch(touch);)+
            }
        }
    };
}
record_in_each!(A B);
record_in_each!(A B C);
record_in_each!(A B C D);
