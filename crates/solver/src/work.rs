/// Cost of a run, in counts that are equal on every machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Time steps of the whole row. Sub-steps of structures are not counted here.
    pub steps: u64,
    /// Evaluations of a restoring force.
    pub force_evaluations: u64,
    /// Newton iterations, summed over structures that are alone and clusters that touch.
    pub newton_iterations: u64,
    /// Steps and sub-steps at whose end a pair overlaps, and impacts within them, summed over pairs.
    pub touching_steps: u64,
    /// Pieces of the motion of structures in power series.
    pub segments: u64,
    /// Events of the exact method: instants at which a piece ended.
    pub events: u64,
}
