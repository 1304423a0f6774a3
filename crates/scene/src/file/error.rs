use pounding_solver::{LedgerError, RunError};
use pounding_text::{RefusalKind, Refused};

/// Errors between a file and a result. Each names the place, what was found and what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A refusal that the user can put right, or a stop by the user.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// A run that ended early.
    #[error("{refused}")]
    Run {
        /// Message.
        refused: Refused,
        /// Error of the solver, with structure and instant.
        source: RunError,
    },
    /// A run that broke a law of mechanics, or an exact run whose energies do not add up to rounding.
    #[error("{refused}")]
    Broken {
        /// Message.
        refused: Refused,
        /// The broken law, with place, instant and amount.
        source: LedgerError,
    },
}

impl Error {
    /// Returns the message.
    pub fn refused(&self) -> &Refused {
        let (Self::Refused(refused) | Self::Run { refused, .. } | Self::Broken { refused, .. }) = self;
        refused
    }

    /// Changes the message.
    #[must_use]
    pub fn said(mut self, change: impl FnOnce(Refused) -> Refused) -> Self {
        let (Self::Refused(refused) | Self::Run { refused, .. } | Self::Broken { refused, .. }) = &mut self;
        *refused = change(std::mem::take(refused));
        self
    }

    /// Whether the user stopped the run.
    pub fn is_stopped(&self) -> bool {
        self.refused().is_kind(RefusalKind::Stopped)
    }

    /// Returns the message without the name of the record file, for a line that names it already.
    pub fn reason(&self) -> String {
        self.refused().reason()
    }
}

impl Error {
    /// Returns the message of a run that ended early.
    pub fn ended(source: &RunError) -> Refused {
        let is_stopped = matches!(source, RunError::Stopped { .. });
        let kind = if is_stopped { RefusalKind::Stopped } else { RefusalKind::Wrong };
        Refused::that(source.to_string()).kind(kind)
    }

    /// Refuses a scene by its name.
    pub fn in_scene(scene: &str, mut refused: Refused) -> Self {
        refused.place_mut().scene = Some(scene.to_owned());
        Self::Refused(refused)
    }
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        let (Error::Refused(refused) | Error::Run { refused, .. } | Error::Broken { refused, .. }) = error;
        refused
    }
}
