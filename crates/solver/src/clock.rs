/// The fixed grid of a stepping run: nodes at i·Δt, i = 0..=n. The exact method uses only its end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clock {
    /// Time step Δt \[s\], > 0.
    pub time_step: f64,
    /// Number of steps n; the run ends at n·Δt.
    pub n_steps: usize,
}

impl Clock {
    /// Time of node `step` \[s\].
    #[inline]
    pub fn time(&self, step: usize) -> f64 {
        step as f64 * self.time_step
    }
}
