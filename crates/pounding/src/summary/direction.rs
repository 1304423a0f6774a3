//! Both directions of shaking in the first lines of a run.

use crate::text::paragraph;

/// What each direction does, the worse one first, as a paragraph.
pub(crate) fn text(both: &[String; 2]) -> String {
    paragraph("Answer", &both.join("\n"))
}
