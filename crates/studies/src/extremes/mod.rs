//! Scenes pushed to the edge, each number of each run classified: what is exact, what is refused, what is wrong, and
//! whether the program says so.

mod axis;
mod class;
mod measure;

pub use axis::Axis;
