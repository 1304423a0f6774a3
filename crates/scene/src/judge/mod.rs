//! What a user should know before believing a run.

pub(crate) mod between_samples;
pub(crate) mod certificate;
pub(crate) mod certified;
pub(crate) mod excess_kind;
pub(crate) mod free_collision;
mod gathered;
pub(crate) mod implausible;
pub(crate) mod lean;
pub(crate) mod limits;
pub(crate) mod response;
pub(crate) mod review;
mod sentences;
mod unwatched;
pub(crate) mod warning;
