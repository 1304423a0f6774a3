use thiserror::Error;

/// A law of mechanics that a run broke.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum LedgerError {
    /// Neighbours that pull at each other.
    #[error(
        "pair {pair} at t = {time:.4} s: found a pounding force of {found:.3} N, which pulls; allowed are 0 N and more: use \
         a smaller time step, or a contact law that does not pull"
    )]
    Tension {
        /// Index of the pair in its row.
        pair: usize,
        /// Instant, or the end of a step \[s\].
        time: f64,
        /// Pounding force, or its mean over the step \[N\].
        found: f64,
    },
    /// An impact that pulls.
    #[error(
        "pair {pair} at t = {time:.4} s: found an impact with an impulse of {found:.3} N s, which pulls; allowed are 0 N s \
         and more: use a smaller time step, or another method"
    )]
    PullingImpact {
        /// Index of the pair in its row.
        pair: usize,
        /// Instant \[s\].
        time: f64,
        /// Impulse \[N·s\].
        found: f64,
    },
    /// A collision of impulsive pairs that gave the row energy.
    #[error(
        "pair {pair}, impacts from t = {start:.4} s to {end:.4} s: found {found:.3e} J created, allowed {allowed:.1e} J; use \
         a smaller time step, or a method whose impacts act on the velocities of their own instant"
    )]
    GainAtImpact {
        /// Index of the pair that was hit first.
        pair: usize,
        /// First impact \[s\].
        start: f64,
        /// Last impact before the pairs came apart \[s\].
        end: f64,
        /// Energy created \[J\].
        found: f64,
        /// Energy that the rounding of velocities explains \[J\].
        allowed: f64,
    },
    /// A collision of a compliant pair that gave the row more energy than it had taken.
    #[error(
        "pair {pair}, collision from t = {start:.4} s to {end:.4} s: found {found:.3e} J more given back than taken, \
         allowed {allowed:.1e} J; use a smaller time step"
    )]
    GainInContact {
        /// Index of the pair in its row.
        pair: usize,
        /// First touch \[s\].
        start: f64,
        /// Parting \[s\].
        end: f64,
        /// Energy created \[J\].
        found: f64,
        /// Energy that the length of the steps explains \[J\].
        allowed: f64,
    },
    /// Columns that gave energy in yielding.
    #[error(
        "structure {structure} at t = {time:.4} s: found {found:.3e} J given by yielding columns, allowed {allowed:.1e} J; \
         this is a fault of the method: use another one, and report it"
    )]
    GainInYielding {
        /// Index of the structure, from the left.
        structure: usize,
        /// End of the step \[s\].
        time: f64,
        /// Energy created \[J\].
        found: f64,
        /// Energy that rounding explains \[J\].
        allowed: f64,
    },
    /// Neighbours without opposite impulses.
    #[error(
        "pair {pair}: found impulses of {left:.3} N s on the left and {right:.3} N s on the right structure, allowed are \
         opposite ones; this is a fault of the method: use another one, and report it"
    )]
    Imbalance {
        /// Index of the pair in its row.
        pair: usize,
        /// Impulse on the left structure \[N·s\].
        left: f64,
        /// Impulse on the right structure \[N·s\].
        right: f64,
    },
    /// A link without opposite impulses at its ends.
    #[error(
        "link {link}: found impulses of {left:.3} N s on its left and {right:.3} N s on its right end, allowed are opposite ones; \
         this is a fault of the method: use another one, and report it"
    )]
    LinkImbalance {
        /// Index of the link in its row.
        link: usize,
        /// Impulse on the left end \[N·s\].
        left: f64,
        /// Impulse on the right end \[N·s\].
        right: f64,
    },
    /// A motion that should be exact but whose energies do not balance.
    #[error(
        "energy: found {found:.1e} of it unexplained, allowed {allowed:.1e}, which rounding leaves of a right run; some number \
         of this run is wrong, which is a fault of the method: use another one, and report it"
    )]
    EnergyUnexplained {
        /// [`Ledger::residual`](crate::Ledger::residual) \[–\].
        found: f64,
        /// [`Ledger::bound`](crate::Ledger::bound) \[–\].
        allowed: f64,
    },
}
