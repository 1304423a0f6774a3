//! The layouts of record files, by their names.

use strum::EnumCount;

/// A `Format` is a layout of record files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, EnumCount)]
pub enum Format {
    /// Two-column CSV with a header of this project.
    Csv,
    /// PEER AT2 and similar files under this name.
    PeerAt2,
    /// CSMIP (CDMG) volume 1, uncorrected.
    CsmipV1,
    /// CSMIP (CDMG) volume 2, corrected.
    CsmipV2,
    /// COSMOS 1.2, volumes 0 to 2.
    Cosmos,
    /// SMC of the US Geological Survey.
    UsgsSmc,
    /// Volume 2 of the University of Southern California.
    UscV2,
    /// K-NET and KiK-net of Japan.
    KNet,
    /// ASC of ESM and ITACA.
    Esm,
    /// V1A and V2A of `GeoNet`, New Zealand.
    GeoNet,
    /// Volume 1 of RENADIC, Chile.
    RenadicV1,
    /// Seismic Analysis Code, binary.
    Sac,
    /// miniSEED 2 and 3, binary.
    MiniSeed,
    /// CWB (CWA), Taiwan.
    Cwb,
    /// AFAD (NSMN), Turkey.
    Afad,
    /// Standard file of UNAM, Mexico.
    Unam,
    /// SCEC Broadband Platform.
    Bbp,
    /// Volume 1 of BHRC, Iran.
    Bhrc,
    /// CSMNC, China.
    Csmnc,
    /// DYNA of the Italian networks.
    Dyna,
    /// EMOD3D, New Zealand.
    Emod3d,
    /// Text of the US Geological Survey of the 1980s.
    UsgsText,
    /// A title, a line with number and step, then values.
    Eqsig,
    /// JSON of the `SimCenter`.
    SimCenter,
    /// Numbers in columns or line after line.
    Plain,
}

impl Format {
    /// All known formats.
    pub const ALL: [Self; Self::COUNT] = [
        Self::Csv,
        Self::PeerAt2,
        Self::CsmipV1,
        Self::CsmipV2,
        Self::Cosmos,
        Self::UsgsSmc,
        Self::UscV2,
        Self::KNet,
        Self::Esm,
        Self::GeoNet,
        Self::RenadicV1,
        Self::Cwb,
        Self::Afad,
        Self::Unam,
        Self::Bbp,
        Self::Bhrc,
        Self::Csmnc,
        Self::Dyna,
        Self::Emod3d,
        Self::UsgsText,
        Self::Sac,
        Self::MiniSeed,
        Self::Eqsig,
        Self::SimCenter,
        Self::Plain,
    ];

    /// Returns the name for messages.
    pub fn name(self) -> &'static str {
        match self {
            Self::Csv => "CSV",
            Self::PeerAt2 => "PEER AT2",
            Self::CsmipV1 => "CSMIP V1",
            Self::CsmipV2 => "CSMIP V2",
            Self::Cosmos => "COSMOS 1.2",
            Self::UsgsSmc => "USGS SMC",
            Self::UscV2 => "USC V2",
            Self::KNet => "K-NET",
            Self::Esm => "ESM ASC",
            Self::GeoNet => "GeoNet",
            Self::RenadicV1 => "RENADIC V1",
            Self::Sac => "SAC",
            Self::MiniSeed => "miniSEED",
            Self::Cwb => "CWB",
            Self::Afad => "AFAD",
            Self::Unam => "UNAM",
            Self::Bbp => "SCEC BBP",
            Self::Bhrc => "BHRC",
            Self::Csmnc => "CSMNC",
            Self::Dyna => "DYNA",
            Self::Emod3d => "EMOD3D",
            Self::UsgsText => "USGS text",
            Self::Eqsig => "eqsig",
            Self::SimCenter => "SimCenter JSON",
            Self::Plain => "plain text",
        }
    }

    /// The names of all formats for a message.
    pub(crate) fn names() -> String {
        Self::ALL.map(Self::name).join(", ")
    }
}
