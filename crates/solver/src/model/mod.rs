//! The row: structures and buildings, columns, pairs, and the ground that shakes them.

pub(crate) mod approach;
pub(crate) mod balance;
pub(crate) mod bilinear;
pub(crate) mod bouc_wen;
pub(crate) mod buildings;
pub(crate) mod column;
pub(crate) mod damping;
pub(crate) mod dashpots;
pub(crate) mod excitation;
pub(crate) mod ground;
pub(crate) mod incidence;
pub(crate) mod levels;
pub(crate) mod link;
pub(crate) mod mixed;
pub(crate) mod modes;
pub(crate) mod node;
pub(crate) mod profile;
pub(crate) mod relation;
pub(crate) mod row;
pub(crate) mod sampling;
pub(crate) mod sliding;
pub(crate) mod travel;
