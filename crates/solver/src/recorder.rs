use crate::Span;

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
    /// Whether the recorder reads the impulses of [`Weighed`](crate::Weighed); where none does, they are left at zero
    /// and cost nothing.
    const READS_WEIGHED: bool = false;

    /// Sees the motion of one structure over one span.
    fn span(&mut self, span: &Span<'_>);

    /// Sees one impact; the spans that end at its instant came before.
    fn impact(&mut self, impact: &Impact);
}

impl Recorder for () {
    fn span(&mut self, _: &Span<'_>) {}
    fn impact(&mut self, _: &Impact) {}
}

macro_rules! record_in_each {
    ($($name:ident)+) => {
        impl<$($name: Recorder),+> Recorder for ($($name,)+) {
            const READS_WEIGHED: bool = $($name::READS_WEIGHED)||+;

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
        }
    };
}
record_in_each!(A B);
record_in_each!(A B C);
record_in_each!(A B C D);
