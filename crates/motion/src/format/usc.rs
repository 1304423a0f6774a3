//! USC volume 2, of the University of Southern California and networks that adopted it: the layout of CSMIP volume 2.

use super::csmip_v2::{components, identity_in, read, recognises, titles};
use super::{Format, Reader, title};

pub(super) const READER: Reader = Reader {
    format: Format::UscV2,
    recognises: |file| recognises(file) && title::line_with(titles(file), "STATION USC").is_some(),
    components,
    read,
    identity: |file| identity_in(titles(file), 2),
};
