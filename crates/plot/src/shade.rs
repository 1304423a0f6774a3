//! The few colours of the figures.

/// A shade is a colour of the figures.
///
/// The first seven are for curves, preferably in this order. Printed in grey, their lightness (CIE L*, 0 black to 100 white) is about 13,
/// 42, 63, 50, 79, 70 and 54. Ink, blue and vermilion are clearly different. Grey next to vermilion, and rose next to green, also need
/// another [`CurveKind`](super::CurveKind) or [`Mark`](super::Mark).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shade {
    /// Nearly black, also for text and axes.
    Ink,
    /// Deep blue.
    Blue,
    /// Bright orange-red, much lighter than blue.
    Vermilion,
    /// Bluish green.
    Green,
    /// Golden yellow.
    Amber,
    /// Middle grey.
    Grey,
    /// Reddish purple.
    Rose,
    /// Light grey, for markers and fills behind curves.
    Silver,
    /// Very light grey, for grids and grounds.
    Mist,
    /// Paper.
    White,
}

impl Shade {
    /// Returns the colour of curve number `index`, for a row of structures; the colours repeat after six.
    pub const fn nth(index: usize) -> Self {
        const CURVES: [Shade; 6] = [Shade::Blue, Shade::Vermilion, Shade::Ink, Shade::Green, Shade::Amber, Shade::Grey];
        CURVES[index % CURVES.len()]
    }

    /// Returns red, green and blue, 0 to 255: multiples of 17, which PNG keeps exactly (see `raster.rs`).
    pub const fn rgb(self) -> (u8, u8, u8) {
        match self {
            Self::Ink => (0x22, 0x22, 0x22),
            Self::Blue => (0x11, 0x66, 0xAA),
            Self::Vermilion => (0xEE, 0x77, 0x33),
            Self::Green => (0x11, 0x88, 0x66),
            Self::Amber => (0xEE, 0xBB, 0x44),
            Self::Rose => (0xBB, 0x66, 0x99),
            Self::Grey => (0xAA, 0xAA, 0xAA),
            Self::Silver => (0xBB, 0xBB, 0xBB),
            Self::Mist => (0xDD, 0xDD, 0xDD),
            Self::White => (0xFF, 0xFF, 0xFF),
        }
    }
}
