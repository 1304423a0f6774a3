//! Both directions of shaking in the first lines of a run.

use pounding::report::BothDirections;

use crate::text::paragraph;

/// What each direction does, the worse one first, as a paragraph.
pub(crate) fn text(both: &BothDirections) -> String {
    paragraph("Answer", &both.sentences.join("\n"))
}
