//! The parts of the work on a scene, and the distance that is always allowed.

/// Distance of the routes that is always allowed: relative \[–\], of instants \[s\].
pub const ALLOWED: f64 = 1e-12;

/// A part of the work on a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// The exact run.
    Exact,
    /// The second route.
    SecondRoute,
    /// Exact runs under records near the scene's.
    Condition,
}

impl Stage {
    /// Its name in text.
    pub fn words(self) -> &'static str {
        match self {
            Self::Exact => "the exact run",
            Self::SecondRoute => "the second route",
            Self::Condition => "the exact runs for the condition",
        }
    }
}
