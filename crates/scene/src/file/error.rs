use std::path::Path;

use pounding_solver::{LedgerError, RunError};
use pounding_text::{Kind, Refused};

use super::reading::position_in;

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
        self.refused().is_kind(Kind::Stopped)
    }

    /// The message without the name of a record file, beside which it stands.
    pub fn reason(&self) -> String {
        self.refused().reason()
    }

    /// Names the file that holds the scene, and the line of the field, where the message does not yet name a file.
    #[must_use]
    pub fn in_file(self, path: &Path) -> Self {
        self.said(|refused| in_file(refused, path))
    }
}

impl From<Error> for Refused {
    fn from(error: Error) -> Self {
        let (Error::Refused(refused) | Error::Run { refused, .. } | Error::Broken { refused, .. }) = error;
        refused
    }
}

/// Names the file of a field, and its line where it is found there, unless a file is named already.
pub fn in_file(mut refused: Refused, path: &Path) -> Refused {
    let place = refused.place_mut();
    if place.file.is_none() {
        let field = place.field.as_ref();
        place.spot = place.spot.or(field.and_then(|field| position_in(path, field.path())));
        place.file = Some(path.to_path_buf());
    }
    refused
}

/// What is said of a run that ended early.
pub fn ended(source: &RunError) -> Refused {
    let is_stopped = matches!(source, RunError::Stopped { .. });
    let kind = if is_stopped { Kind::Stopped } else { Kind::Wrong };
    Refused::that(source.to_string()).kind(kind)
}
