//! Structures and pairs of as many scenes as there are lanes.

use fearless_simd::Simd;

use super::body::Body;
use super::column::SideBySideColumn;
use super::law::Law;
use super::number::Lanes;
use super::points::LaneRelation;
use super::tally::SceneSum;

/// A structure of every scene.
pub(super) type Structure<S, Column> = Body<S, <Column as SideBySideColumn>::Beside<Lanes<S>>>;

/// Two points that can touch.
pub(super) struct LanePair<S: Simd> {
    /// Its index among the pairs of the row.
    pub(super) index: usize,
    /// Node of the left neighbour.
    pub(super) left: usize,
    pub(super) relation: LaneRelation<S>,
    /// Whether it has open books from the node before. Stored, because asking the books would cost a mask in steps without contact.
    pub(super) lingers: bool,
    pub(super) gap: Lanes<S>,
    pub(super) law: Law<S>,
    /// Deformation at the present node \[m\].
    pub(super) deformation: Lanes<S>,
    pub(super) tally: SceneSum<S>,
}
