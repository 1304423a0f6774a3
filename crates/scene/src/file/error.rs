use pounding_solver::{LedgerError, RunError};
use pounding_text::{RefusalKind, Refused};

/// What can go wrong between a file and a result; each names place, found and allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// Something that its user can put right, or ended.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// A run that ended early.
    #[error("{refused}")]
    Run {
        /// What happened, in words.
        refused: Refused,
        /// What happened, in which structure and when.
        source: RunError,
    },
    /// A run that broke a law of mechanics; an exact one also where its energies do not add up to rounding.
    #[error("{refused}")]
    Broken {
        /// What happened, in words.
        refused: Refused,
        /// The law, where and when it was broken, and by how much.
        source: LedgerError,
    },
}

impl Error {
    /// What is said of it.
    pub fn refused(&self) -> &Refused {
        let (Self::Refused(refused) | Self::Run { refused, .. } | Self::Broken { refused, .. }) = self;
        refused
    }

    /// Changes what is said of it.
    #[must_use]
    pub fn said(mut self, change: impl FnOnce(Refused) -> Refused) -> Self {
        let (Self::Refused(refused) | Self::Run { refused, .. } | Self::Broken { refused, .. }) = &mut self;
        *refused = change(std::mem::take(refused));
        self
    }

    /// Whether somebody ended the run.
    pub fn is_stopped(&self) -> bool {
        self.refused().is_kind(RefusalKind::Stopped)
    }

    /// The message without the name of a record file, beside which it stands.
    pub fn reason(&self) -> String {
        self.refused().reason()
    }
}

impl Error {
    /// A refusal of a scene, by its name.
    pub(crate) fn in_scene(scene: &str, mut refused: Refused) -> Self {
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

/// What is said of a run that ended early.
pub fn ended(source: &RunError) -> Refused {
    let is_stopped = matches!(source, RunError::Stopped { .. });
    let kind = if is_stopped { RefusalKind::Stopped } else { RefusalKind::Wrong };
    Refused::that(source.to_string()).kind(kind)
}
