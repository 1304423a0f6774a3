/// What a run cost, in counts that are the same on every machine.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Work {
    /// Time steps taken by the whole row; what structures do within them is not counted here.
    pub steps: u64,
    /// Evaluations of a restoring force.
    pub force_evaluations: u64,
    /// Newton iterations, summed over structures that stand alone and clusters that touch.
    pub newton_iterations: u64,
    /// Steps and sub-steps at whose end a pair overlaps, and impacts within one, summed over pairs.
    pub touching_steps: u64,
    /// Pieces of a structure's motion carried by power series.
    pub segments: u64,
    /// Events of the exact method: instants at which a piece ended.
    pub events: u64,
}
