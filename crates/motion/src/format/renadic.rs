//! RENADIC (Chile) volume 1: the layout of CSMIP volume 1, always with pairs of time and value.
//!
//! No file was available: this reader follows descriptions of the format.

use super::csmip_v1::{components, read, recognises, titles};
use super::csmip_v2::identity_in;
use super::{Format, Reader, title};

pub(super) const READER: Reader = Reader {
    format: Format::RenadicV1,
    recognises: |file| recognises(file) && title::line_with(titles(file), "RENADIC").is_some(),
    components,
    read,
    identity: |file| identity_in(titles(file), 1),
};
