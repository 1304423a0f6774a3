/// An error that ends a run of the second route, the program that is independent of the solver.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SecondRouteError {
    /// A setting out of range.
    #[error("second route: {setting}: found {}, allowed {allowed}", pounding_text::plain(*found))]
    Setting {
        /// Name of the setting.
        setting: &'static str,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// The motion is no longer finite.
    #[error("second route: the motion is no longer finite at t = {time} s")]
    NotFinite {
        /// Start of the step after which the motion is no longer finite \[s\].
        time: f64,
    },
    /// No step is short enough for the tolerance.
    #[error("second route: no step meets the tolerance {tolerance:e} at t = {time} s; raise the tolerance")]
    Tolerance {
        /// Start of the step \[s\].
        time: f64,
        /// The requested tolerance.
        tolerance: f64,
    },
    /// A segment of the run has more events than allowed.
    #[error("second route: more than {limit} events before the next sample arrives at a structure, at t = {time} s")]
    TooManyEvents {
        /// Time at which the limit was passed \[s\].
        time: f64,
        /// The limit.
        limit: usize,
    },
    /// The run was stopped from outside.
    #[error("second route: stopped at t = {time} s")]
    Stopped {
        /// Time reached \[s\].
        time: f64,
    },
    /// A viscous damper without a brace: its force has no rate where its deformation stops.
    #[error("second route: links[{link}] is a viscous damper without a brace; give it a brace")]
    NoBrace {
        /// Place of the link in the row, from 0.
        link: usize,
    },
    /// A storey on another floor that sticks and slides under friction.
    #[error("second route: nodes[{node}] sticks under friction above another floor; give it a yield displacement")]
    Sticks {
        /// Node of its floor.
        node: usize,
    },
    /// Too many connected impulsive pairs touch at the same time. Every subset of them is tried, so their number is limited.
    #[error(
        "second route: {found} impulsive pairs touch at t = {time} s and meet floors of each other, allowed are {limit}; give some of them a gap or a compliant law"
    )]
    TooManyAtOnce {
        /// Time of the touch \[s\].
        time: f64,
        /// Number of connected pairs that touch at this time.
        found: usize,
        /// The limit.
        limit: usize,
    },
}
