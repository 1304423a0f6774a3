use pounding_text::plain;
use thiserror::Error;

/// A model or excitation that cannot be run, found before the first step.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum ModelError {
    /// A value outside its valid range.
    #[error("{place}: found {}, allowed {allowed}", plain(*found))]
    OutOfRange {
        /// Place of the value, for example `excitation.time_step`.
        place: String,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A value of a node outside its valid range.
    #[error("nodes[{node}].{field}: found {}, allowed {allowed}", plain(*found))]
    Node {
        /// Index of the node.
        node: usize,
        /// Its field.
        field: &'static str,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A value of a pair outside its valid range.
    #[error("pairs[{pair}].{field}: found {}, allowed {allowed}", plain(*found))]
    Pair {
        /// Index of the pair.
        pair: usize,
        /// Its field, or the parameter of its law.
        field: &'static str,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A value of a link outside its valid range.
    #[error("links[{link}].{field}: found {}, allowed {allowed}", plain(*found))]
    Link {
        /// Index of the link.
        link: usize,
        /// Its field.
        field: &'static str,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// A link with an end that is not in the row.
    #[error("links[{link}].{side}: {fault}")]
    LinkEnd {
        /// Index of the link.
        link: usize,
        /// Side of the end: `left` or `right`.
        side: &'static str,
        /// The fault.
        fault: PointFault,
    },
    /// A link that no motion deforms.
    #[error("links[{link}]: found two ends at one point, or none on a floor; allowed are two ends, one of them on a floor")]
    LinkOfNothing {
        /// Index of the link.
        link: usize,
    },
    /// A pair with a point that is not in the row.
    #[error("pairs[{pair}].{side}: {fault}")]
    Point {
        /// Index of the pair.
        pair: usize,
        /// Side of the point: `left` or `right`.
        side: &'static str,
        /// The fault.
        fault: PointFault,
    },
    /// A pair whose points cannot meet.
    #[error("pairs[{pair}]: found points at nodes {left} and {right} of {found}; allowed are two buildings, or a building and a wall")]
    NotNeighbours {
        /// Index of the pair.
        pair: usize,
        /// Node of its left point; for a point between floors, the nearer floor.
        left: usize,
        /// Node of its right point.
        right: usize,
        /// What the two points belong to, in words.
        found: &'static str,
    },
    /// A floor that does not stand on an earlier floor of its building.
    #[error("nodes[{node}]: stands on node {below}; allowed is an earlier floor that is no wall and carries no other one")]
    NotAFloor {
        /// Index of the node.
        node: usize,
        /// Node on which the floor stands.
        below: usize,
    },
    /// The number of arrivals of the ground motion differs from the number of nodes.
    #[error("arrivals: found {found}, allowed one for each of {n_nodes} nodes")]
    Arrivals {
        /// Number of arrivals.
        found: usize,
        /// Number of nodes in the row.
        n_nodes: usize,
    },
    /// Structures that already overlap at t = 0.
    #[error(
        "pairs[{pair}]: the initial displacements overlap by {} m; allowed 0 or less: widen the gap or change \
         the initial displacements",
        plain(*overlap)
    )]
    OverlapsAtStart {
        /// Index of the pair.
        pair: usize,
        /// Deformation at t = 0 \[m\].
        overlap: f64,
    },
    /// Ground acceleration without samples.
    #[error("excitation: found no samples, allowed one or more")]
    NoSamples,
}

/// Why a point is not a point of a row.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum PointFault {
    /// A node that the row does not have.
    #[error("found node {found}, allowed are those below {n_nodes}")]
    NoNode {
        /// Index of the node found.
        found: usize,
        /// Number of nodes in the row.
        n_nodes: usize,
    },
    /// A point between the ground and the ground.
    #[error("found no floor, allowed are a floor, and a point between a floor and what it stands on")]
    NoFloor,
    /// The end of a link between two floors.
    #[error("found a point between floors, allowed are a floor and the ground")]
    NoEnd,
    /// A point between two floors that are not neighbours in a building.
    #[error("found a point between {} and node {upper}, allowed is one between a floor and what it stands on", name(*.lower))]
    NoStorey {
        /// The lower floor; `None` is the ground.
        lower: Option<usize>,
        /// The upper floor.
        upper: usize,
    },
    /// A lean out of range.
    #[error(
        "found a lean of {}, allowed more than 0 and at most 0.5: take the nearer floor as base, or use Point::between",
        plain(*found)
    )]
    Lean {
        /// The value found.
        found: f64,
    },
}

fn name(floor: Option<usize>) -> String {
    floor.map_or_else(|| "the ground".to_owned(), |floor| format!("node {floor}"))
}

/// A run that ended before its last step.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum RunError {
    /// Links in a run by a method that takes none.
    #[error("links: found a method that takes none, allowed are exact, rk4 and central_difference")]
    TakesNoLinks,
    /// A link whose force central differences cannot find ahead of a step.
    #[error(
        "links[{link}]: found a viscous damper without a brace, whose force is too steep at rest for central differences; allowed is one with \
         a brace, or the method rk4"
    )]
    LinkTooSteep {
        /// Index of the link.
        link: usize,
    },
    /// A link whose force is no power series.
    #[error(
        "links[{link}]: found a viscous damper without a brace, which the exact method cannot expand; allowed is one with a brace and \
         1/exponent a whole number, or the method rk4"
    )]
    LinkWithoutSeries {
        /// Index of the link.
        link: usize,
    },
    /// A link whose force changes faster than a power series can follow.
    #[error("links[{link}] at t = {time:.4} s: its force changes too fast for the exact method; use a softer brace, or the method rk4")]
    NoLinkSeries {
        /// Index of the link.
        link: usize,
        /// Instant \[s\].
        time: f64,
    },
    /// A number stopped being finite in this step.
    #[error(
        "structure {structure} at t = {time:.4} s: the response is no longer a finite number; use a smaller time step \
         (found {} s)",
        plain(*time_step)
    )]
    Diverged {
        /// Index of the structure, from the left.
        structure: usize,
        /// End of the step \[s\].
        time: f64,
        /// Time step of the run \[s\].
        time_step: f64,
    },
    /// A motion beyond the range of floating-point numbers, in a method without time steps.
    #[error(
        "structure {structure} at t = {time:.4} s: its motion is beyond the range of numbers; use masses, \
         stiffnesses, velocities and a record of usual size"
    )]
    OutOfNumbers {
        /// Index of the structure, from the left.
        structure: usize,
        /// Instant \[s\].
        time: f64,
    },
    /// Newton's method did not reach equilibrium.
    #[error(
        "structures {first} to {last} at t = {time:.4} s: no equilibrium after {iterations} Newton iterations \
         (residual {residual:e} of the forces' sum, allowed {allowed:e}); use a smaller time step"
    )]
    NotConverged {
        /// Index of the leftmost structure of the cluster.
        first: usize,
        /// Index of its rightmost structure.
        last: usize,
        /// End of the step \[s\].
        time: f64,
        /// Iterations done.
        iterations: u32,
        /// Largest residual of equilibrium relative to the sum of the magnitudes of its terms.
        residual: f64,
        /// The residual allowed.
        allowed: f64,
    },
    /// The impulses of pairs that touch did not settle.
    #[error(
        "structures {first} to {last} at t = {time:.4} s: their impulses still change after {iterations} solutions of \
         the step; use a smaller time step"
    )]
    ImpulsesNotFound {
        /// Index of the leftmost structure that touches.
        first: usize,
        /// Index of the rightmost one.
        last: usize,
        /// End of the step \[s\].
        time: f64,
        /// Solutions tried.
        iterations: u32,
    },
    /// A run setting outside its valid range.
    #[error("{setting}: found {}, allowed {allowed}", plain(*found))]
    Setting {
        /// Name of the setting.
        setting: &'static str,
        /// The value found.
        found: f64,
        /// The values allowed, in words.
        allowed: &'static str,
    },
    /// An impulsive pair that bounces without coming to rest: with e = 1, neighbours that press against each other repeat the same bounce
    /// for ever.
    #[error(
        "structures {left} and {right} at t = {time:.4} s: they bounce without coming to rest (after {impacts} impacts, \
         e = {}); with e = 1 neighbours that press against each other never do: use a coefficient of \
         restitution of 0.999 or less, a compliant law or a stepping method",
        plain(*restitution)
    )]
    BouncesWithoutEnd {
        /// Index of the left structure.
        left: usize,
        /// Index of the right structure.
        right: usize,
        /// Instant of the last impact \[s\].
        time: f64,
        /// Impacts of the pair since it was last at rest.
        impacts: u32,
        /// Its coefficient of restitution \[–\].
        restitution: f64,
    },
    /// A structure so stiff, or so strongly damped, that its motion needs too many pieces of the exact method.
    #[error(
        "structure {structure}: so stiff, or so strongly damped, that the exact method would need {pieces:.1e} pieces of \
         its motion, allowed {allowed:e}: make its period longer, the run shorter, the `budget.pieces` of a scene more, or use a stepping method"
    )]
    TooStiff {
        /// Index of the structure.
        structure: usize,
        /// Number of pieces that the run would need.
        pieces: f64,
        /// Most pieces that are allowed.
        allowed: f64,
    },
    /// A touch so slow that the damper of its law, δ̇/v₀, holds neighbours that press against each other almost still.
    #[error(
        "structures {left} and {right} at t = {time:.4} s: they touched at {approach_speed:e} m/s and press against each \
         other; the damper of {law}, which grows with 1/v₀, is too strong there to be followed (after {pieces} pieces of \
         one contact): use less impact stiffness or damping, a law without the approach speed, or a stepping method"
    )]
    CrawlsInContact {
        /// Index of the left structure.
        left: usize,
        /// Index of the right structure.
        right: usize,
        /// The instant \[s\].
        time: f64,
        /// Rate of deformation at the touch \[m/s\].
        approach_speed: f64,
        /// Name of the law.
        law: &'static str,
        /// Pieces of the motion in this contact.
        pieces: u32,
    },
    /// A contact for which the exact method has no series.
    #[error(
        "structures {left} and {right} at t = {time:e} s: no series of the exact method follows how they begin to press: \
         their contact is too stiff, or it begins together with a neighbour's, without a gap in between; give it less impact \
         stiffness, a gap of 1e-6 m or an impulsive law, or take a stepping method"
    )]
    NoSeries {
        /// Index of the left structure.
        left: usize,
        /// Index of the right structure.
        right: usize,
        /// The instant \[s\].
        time: f64,
    },
    /// Walls, or floors that friction holds, that close in without a gap on the structures between them, because their grounds move at
    /// different times.
    #[error(
        "structures {left} and {right} at t = {time:.4} s: walls (or floors that friction holds) close in on them from both sides, and \
         impulsive contact leaves them nowhere to go; let the motion arrive everywhere at once, widen a gap, or use a compliant law"
    )]
    ClosedIn {
        /// Index of the left structure.
        left: usize,
        /// Index of the right structure.
        right: usize,
        /// The instant \[s\].
        time: f64,
    },
    /// Too many events at an instant.
    #[error(
        "t = {time:.4} s: impacts follow each other without end (after {events} events); allowed are 1000 and 10 per structure \
         at one instant. With e = 1 neighbours never come to rest; with less, several pairs that come to rest \
         at once can stop the exact method, above all on a ground that travels along the row: use a \
         compliant law (such as kelvin_voigt with the same restitution), another coefficient of restitution or a stepping method; of a compliant law, less impact stiffness"
    )]
    NoProgress {
        /// The instant \[s\].
        time: f64,
        /// Events of the run so far.
        events: u64,
    },
    /// Damping on the tangent stiffness that the method does not take.
    #[error(
        "structure {structure}: its damping follows the tangent stiffness, which exact, newmark and rk4 take, of \
         columns with a sharp knee: choose one of these methods, or damping on the initial stiffness"
    )]
    TangentDamping {
        /// Index of the structure.
        structure: usize,
    },
    /// Columns that stick and slide, in a run by a method that does not take them.
    #[error(
        "structure {structure}: its isolators stick and slide without any displacement before, which only the exact method takes: choose \
         it, or a yield displacement > 0"
    )]
    Friction {
        /// Index of the structure.
        structure: usize,
    },
    /// The run needs more pieces than the budget allows.
    #[error(
        "t = {time:.4} s: the exact method has taken more than {allowed:e} pieces of motion, all that `budget.pieces` allows: make it \
         more, the run shorter, structures and contacts less stiff or less damped, or use a stepping method"
    )]
    TooManyPieces {
        /// Time reached \[s\].
        time: f64,
        /// Number of pieces allowed.
        allowed: f64,
    },
    /// The run has more structures and samples than the budget has pieces.
    #[error(
        "the exact method would need {pieces:.1e} pieces of motion, one or more of every structure from sample to sample, allowed \
         {allowed:e} (`budget.pieces`): make that more, take fewer structures, a shorter run or a stepping method"
    )]
    TooLarge {
        /// Smallest number of pieces that the run would need.
        pieces: f64,
        /// Number of pieces allowed.
        allowed: f64,
    },
    /// A contact so strongly damped that it could need too many pieces.
    #[error(
        "structures {left} and {right}: their contact is so strongly damped that the exact method could need {pieces:.1e} pieces of \
         motion, allowed {allowed:e} (`budget.pieces`): make that more, the impact damping less, or use a stepping method"
    )]
    TooDamped {
        /// Index of the left structure.
        left: usize,
        /// Index of the right structure.
        right: usize,
        /// Number of pieces that the contact could need.
        pieces: f64,
        /// Number of pieces allowed.
        allowed: f64,
    },
    /// The run takes more time than the budget allows.
    #[error(
        "t = {time:.4} s: the run has taken more than {seconds} s, all that `budget.seconds` allows: make it more, the run shorter, or \
         its time step longer"
    )]
    TooLong {
        /// Time reached \[s\].
        time: f64,
        /// Longest time allowed \[s\].
        seconds: f64,
    },
    /// The stop flag of the budget was set.
    #[error("t = {time:.4} s: the run was stopped")]
    Stopped {
        /// Time reached \[s\].
        time: f64,
    },
}

impl RunError {
    /// The error with all times later by `by` \[s\], for a run whose clock was set back by this time.
    pub(crate) fn later(mut self, by: f64) -> Self {
        if let Self::BouncesWithoutEnd { time, .. }
        | Self::CrawlsInContact { time, .. }
        | Self::NoSeries { time, .. }
        | Self::ClosedIn { time, .. }
        | Self::NoProgress { time, .. }
        | Self::OutOfNumbers { time, .. }
        | Self::TooManyPieces { time, .. }
        | Self::TooLong { time, .. }
        | Self::Stopped { time } = &mut self
        {
            *time += by;
        }
        self
    }
}

/// Refuses a setting whose `found` value is not `valid`.
///
/// # Errors
/// [`RunError::Setting`] if it is not valid.
pub fn require(valid: bool, setting: &'static str, found: f64, allowed: &'static str) -> Result<(), RunError> {
    if valid {
        Ok(())
    } else {
        Err(RunError::Setting { setting, found, allowed })
    }
}
