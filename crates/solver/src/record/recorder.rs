use crate::span::{Load, Path, Weighed};
use crate::{Relation, Span, State};

/// Velocities of a pair \[m/s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Velocities {
    /// Of the left neighbour.
    pub left: f64,
    /// Of the right neighbour.
    pub right: f64,
}

/// A floor that an impact strikes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Struck {
    /// Its node.
    pub floor: usize,
    /// Part of the impulse that it gets \[–\]: negative on the left of the pair, which is pushed to the left.
    pub part: f64,
    /// Velocities before and after everything that happens at this instant \[m/s\].
    pub velocities: [f64; 2],
}

/// An impulsive impact of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Impact {
    /// Index of the pair in its row.
    pub pair: usize,
    /// Index of the left structure; of a point between two floors the nearer one.
    pub left: usize,
    /// Index of the right structure.
    pub right: usize,
    /// The floors that carry both points, two at least.
    pub floors: [Option<Struck>; 4],
    /// Instant \[s\].
    pub time: f64,
    /// Impulse P \[N·s\], ≥ 0; the left structure gets −P, the right one +P.
    pub impulse: f64,
    /// Velocities of both points before everything that happens at this instant.
    pub before: Velocities,
    /// Velocities of both points after everything that happens at this instant.
    pub after: Velocities,
    /// Rate at which the grounds of both move towards each other \[m/s\]: with the difference of the velocities, which are
    /// relative to them, it is the rate of deformation. 0 where the ground motion arrives at both at once.
    pub opening_rate: f64,
}

impl Impact {
    /// Of two points, from the velocities of floors before and after; pair, instant, impulse and rate of the grounds are open.
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

    /// The floors that it strikes.
    pub fn struck(&self) -> impl Iterator<Item = Struck> + Clone {
        self.floors.into_iter().flatten()
    }

    /// Rates of deformation of the pair before and after \[m/s\], positive while approaching.
    pub fn rates(&self) -> [f64; 2] {
        [self.before, self.after].map(|at| at.left - at.right + self.opening_rate)
    }
}

/// A gap that closes, of a method that finds the instant; stepping methods report none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Index of the pair in its row.
    pub pair: usize,
    /// Instant \[s\].
    pub time: f64,
    /// Rate of deformation at which the pair approaches v₀ \[m/s\], ≥ 0.
    pub approach_speed: f64,
    /// Half the width of the interval in which rounding leaves the instant \[s\], ≥ 0; infinite where a pair that moves
    /// alike touches.
    ///
    /// With s = 8ε (|u| of both structures + gap, each the largest so far), approach rate v ≥ 0, relative acceleration a
    /// and ε = 2⁻⁵²: min(2s / (v + √max(v² − 2|a|s, 0)), √(2s/|a|)) + εt. That is s/v for a transversal touch and
    /// √(2s/|a|) for a grazing one. Not in it: what the same rounding did earlier in the run.
    pub uncertainty: f64,
}

impl Touch {
    /// The uncertainty of a touch from s, v and a.
    pub(crate) fn uncertainty(time: f64, deformation: f64, (rate, acceleration): (f64, f64)) -> f64 {
        let (rate, bend) = (rate.max(0.0), 2.0 * acceleration.abs() * deformation);
        let transversal = 2.0 * deformation / (rate + (rate * rate - bend).max(0.0).sqrt());
        let grazing = (2.0 * deformation / acceleration.abs()).sqrt();
        // Structures that are at zero, and have no gap, are known to be.
        let reach = if deformation > 0.0 { transversal.min(grazing) } else { 0.0 };
        reach + f64::EPSILON * time
    }
}

/// What a run reports to: borrowed spans and impacts in the order of time.
///
/// `()` records nothing and costs nothing; a tuple records what its members do.
pub trait Recorder {
    /// Whether the recorder reads the impulses of [`Weighed`](crate::Weighed); where none does, they are left at zero
    /// and cost nothing. It is asked anew for every span, and always answers the same.
    fn reads_weighed(&self) -> bool {
        false
    }

    /// Sees the motion of one structure over one span.
    fn span(&mut self, span: &Span<'_>);

    /// Sees one impact; the spans that end at its instant came before.
    fn impact(&mut self, impact: &Impact);

    /// Sees one touch, before what follows from it: an impact at this instant, or spans with a pounding force from it on.
    fn touch(&mut self, _: &Touch) {}
}

impl Span<'_> {
    /// A step of a stepping method for a recorder that reads the impulses of forces, or does not.
    ///
    /// The method made of the loads in the step their sum with these weights, times `scale` \[s\]; the trapezoidal
    /// rule is Δt/2 times 1 and 1 of the loads at both ends.
    #[inline]
    pub(crate) fn step<const N: usize>(
        reads_weighed: bool,
        structure: usize,
        (start_time, end_time): (f64, f64),
        [start, end]: [State; 2],
        (scale, weights): (f64, [f64; N]),
        loads: [Load; N],
    ) -> Self {
        let weigh = |force: fn(&Load) -> f64| {
            let terms = weights.iter().zip(&loads);
            let sum = terms.map(|(weight, load)| weight * force(load));
            scale * sum.reduce(|sum, term| sum + term).unwrap_or(0.0)
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
        }
    }
}

impl Recorder for () {
    fn span(&mut self, _: &Span<'_>) {}
    fn impact(&mut self, _: &Impact) {}
}

impl<R: Recorder> Recorder for &mut R {
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

/// Records where there is a recorder: one type of run serves those that ask for it and those that do not.
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
