//! Kinds of responses beyond the range of the model, or beyond the limits of codes.

use pounding_text::{percent, short, two_digits};

/// Drift of a storey of unknown height \[m\] that is more than 2.5 % of any usual height, at most 12 m.
const MOST_UNKNOWN: f64 = 0.3;

/// Kinds of responses that are judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum ExcessKind {
    /// Upper bound of how far a floor and the neighbour's column beside it move together, beyond the gap \[m\].
    AtColumn,
    /// Upper bound of how far a floor and the neighbour's column beside it move together, if no contact gives the gap \[m\].
    BesideColumn,
    /// How far a base slab at the ground moves beyond the gap, whose other side is the foot of the neighbour \[m\].
    AtFoot,
    /// Upper bound of how far two floors of a level that a contact leaves out move together, beyond the gap \[m\].
    LeftOut,
    /// Shear force of a column that a slab hits \[N\]; 0 for impacts, which have no force.
    ColumnHit,
    /// Ratio of the drift to the height of a storey that collapses under gravity \[–\].
    Collapse,
    /// Drift of a storey of unknown height \[m\].
    Displacement,
    /// Stability coefficient P Δ/(V h) of a storey \[–\].
    Stability,
    /// Ratio of the drift to the height of the storey \[–\].
    Drift,
    /// Ratio of the drift to the drift at yielding \[–\].
    Ductility,
    /// Shear force of a storey with a capacity \[N\].
    Shear,
    /// Damping ratio of the mass term of a building on isolators \[–\].
    MassDamping,
    /// Ratio of the drift at the end to the height of the storey \[–\].
    ResidualDrift,
    /// Shear force of the lowest storey over the weight that it carries \[–\].
    BaseShear,
    /// Ratio of the damper's force to the yield force \[–\].
    DamperForce,
}

impl ExcessKind {
    /// Largest drift ratio that codes allow for ordinary buildings of ductile construction \[–\]: NBCC 2015, 4.1.8.13 (3).
    pub const MOST_DRIFT: f64 = 0.025;

    /// Largest ductility demand for which bilinear columns are meaningful \[–\]. A convention: ductile frames are designed for about 6 (NZS
    /// 1170.5).
    pub const MOST_DUCTILITY: f64 = 6.0;

    /// Drift ratio at the end of a run above which a building is likely to be realigned \[–\]: J. McCormick, H. Aburano, M. Ikenaga and M.
    /// Nakashima, 14th World Conf. Earthquake Engng (2008). FEMA P-58 has the median of what can be repaired at 1 %.
    pub const MOST_RESIDUAL: f64 = 0.005;

    /// Stability coefficients \[–\]: gravity matters above the first one, and a design above the second one is not allowed. EN
    /// 1998-1:2004, 4.4.2.2 (2), and ASCE 7-16, 12.8.7.
    pub const MOST_STABILITY: [f64; 2] = [0.1, 0.25];

    /// Largest base shear over weight \[–\] of which a frame is usually capable. A convention: special frames of ASCE 7-16, Table 12.2-1, at
    /// `S_DS` = 1 have 1/8 by design, and 3/8 with their overstrength.
    pub const MOST_BASE_SHEAR: f64 = 0.4;

    /// Largest force of a damper over the yield force \[–\]. A convention, for the reasons of J. F. Hall, *Earthq. Eng. Struct. Dyn.* 35 (2006)
    /// 525, and F. A. Charney, *J. Struct. Eng.* 134 (2008) 581.
    pub const MOST_DAMPER: f64 = 0.1;

    /// Largest damping ratio of the mass term of a building on isolators \[–\]. A convention: isolators have 10 to 30 % of their own.
    pub const MOST_MASS_DAMPING: f64 = 0.01;

    /// General limit of the kind.
    pub(super) fn most(self) -> f64 {
        match self {
            Self::AtColumn | Self::BesideColumn | Self::AtFoot | Self::LeftOut | Self::ColumnHit | Self::Collapse => 0.0,
            Self::Displacement => MOST_UNKNOWN,
            Self::Stability => Self::MOST_STABILITY[0],
            Self::Drift => Self::MOST_DRIFT,
            Self::Ductility => Self::MOST_DUCTILITY,
            // It is judged by a capacity alone.
            Self::Shear => f64::INFINITY,
            Self::MassDamping => Self::MOST_MASS_DAMPING,
            Self::ResidualDrift => Self::MOST_RESIDUAL,
            Self::BaseShear => Self::MOST_BASE_SHEAR,
            Self::DamperForce => Self::MOST_DAMPER,
        }
    }

    /// The general limit behind a value of this kind, in words; empty if the value says enough.
    pub(super) fn bound(self) -> &'static str {
        match self {
            Self::Displacement => ", above 0.3 m",
            Self::Drift => ", above 2.5 %",
            Self::Ductility => ", above 6",
            Self::MassDamping => ", above 1 %",
            Self::ColumnHit => ", which no capacity judges",
            Self::AtColumn
            | Self::BesideColumn
            | Self::AtFoot
            | Self::LeftOut
            | Self::Collapse
            | Self::Stability
            | Self::Shear
            | Self::ResidualDrift
            | Self::BaseShear
            | Self::DamperForce => "",
        }
    }

    /// Whether it is a drift or a force that the columns must bear. Effects of gravity and residual drifts follow from drifts.
    pub fn strains(self) -> bool {
        matches!(
            self,
            Self::Collapse | Self::Displacement | Self::Drift | Self::Ductility | Self::Shear
        )
    }

    /// Whether something may touch without a contact in the model: a column, or floors of a level that is left out.
    pub fn is_unwatched(self) -> bool {
        matches!(self, Self::AtColumn | Self::BesideColumn | Self::AtFoot | Self::LeftOut)
    }

    /// Whether it is about slabs and columns that meet, modelled or not.
    pub fn is_of_contact(self) -> bool {
        self.is_unwatched() || self == Self::ColumnHit
    }

    /// Whether an answer about gaps depends on every response of the kind. Stability, residual drift, base shear and dampers beside columns do
    /// not count: the first two are estimates beyond the model, the others change drifts little.
    pub(super) fn is_caution(self) -> bool {
        self.strains() || self.is_of_contact() || self == Self::MassDamping
    }

    /// Describes a value of this kind in a few words.
    pub fn brief(self, found: f64) -> String {
        match self {
            Self::AtColumn => "may hit a column, which is not modelled".into(),
            Self::BesideColumn => "stands beside a column, which is not modelled".into(),
            Self::AtFoot => "may hit the foot of its neighbour, which is not modelled".into(),
            Self::LeftOut => "may touch, and were not looked at".into(),
            Self::ColumnHit if found > 0.0 => format!("hit by a slab, with a shear force of {} kN", two_digits(1e-3 * found)),
            Self::ColumnHit => "hit by a slab".into(),
            Self::Collapse => format!("collapses under gravity at a drift of {}", percent(found)),
            Self::Displacement => format!("drift of {} mm", short(1e3 * found)),
            Self::Stability => format!("stability coefficient of {}", short(found)),
            Self::Drift => format!("drift of {}", percent(found)),
            Self::Ductility => format!("ductility of {}", short(found)),
            Self::Shear => format!("shear force of {} kN", short(1e-3 * found)),
            Self::MassDamping => format!("dashpots to the ground of {} of critical damping", percent(found)),
            Self::ResidualDrift => format!("{} of drift left", percent(found)),
            Self::BaseShear => format!("shear force of {} times the weight above", two_digits(found)),
            Self::DamperForce => format!("damper force of {} of the yield force", percent(found)),
        }
    }
}
