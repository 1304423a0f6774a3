//! The compared laws, with their looks in figures.

use pounding_contact::{ContactLaw, LawName};

use crate::study::laws::{AtlasSettings, is_linear};
use pounding_plot::{Mark, Shade};
use pounding_scene::{Certificate, Refused};

/// An exactly calibrated law with all its names. Four formulas choose the damping of one force, so this force has four names.
#[derive(Debug)]
pub(super) struct Entry {
    pub(super) names: Vec<LawName>,
    pub(super) certificate: Certificate,
}

/// Number of laws that still differ after exact calibration: four names share the force of Hertz-damp.
pub(super) const N_LAWS: usize = LawName::ALL.len() - 3;

impl Entry {
    /// Every law once, in the order of its first name.
    pub(super) fn all(settings: &AtlasSettings) -> Result<Vec<Self>, Refused> {
        let mut entries: Vec<Self> = Vec::new();
        for law in LawName::ALL {
            let certificate = settings.certificate(law, settings.restitution(law))?;
            match entries.last_mut() {
                Some(last) if last.certificate.law == certificate.law => last.names.push(law),
                _ => entries.push(Self {
                    names: vec![law],
                    certificate,
                }),
            }
        }
        Ok(entries)
    }

    /// The first of its names.
    pub(super) fn name(&self) -> LawName {
        self.names[0]
    }

    /// The calibrated law.
    pub(super) fn law(&self) -> ContactLaw {
        self.certificate.law
    }

    /// Whether it has a force over time.
    pub(super) fn is_compliant(&self) -> bool {
        self.certificate.law.is_compliant()
    }
}

/// Pairs every name of a law with its entry and its row.
pub(super) fn by_name<T: Clone>(entry: &Entry, rows: impl IntoIterator<Item = T>) -> Vec<(LawName, &Entry, T)> {
    let rows: Vec<T> = rows.into_iter().collect();
    let of_name = |name: &LawName| rows.iter().map(|row| (*name, entry, row.clone())).collect::<Vec<_>>();
    entry.names.iter().flat_map(of_name).collect()
}

/// Name of a law in figures.
pub(super) fn label(law: LawName) -> &'static str {
    law.named().label
}

/// Colour of a law: one for linear springs, another for Hertz springs.
pub(super) fn shade(law: LawName) -> Shade {
    if law == LawName::Stereomechanical {
        Shade::Ink
    } else if law == LawName::TwoSlopes {
        Shade::Green
    } else if is_linear(law) {
        Shade::Blue
    } else {
        Shade::Vermilion
    }
}

/// Mark of a law among those of its colour; laws beyond the list share the last mark.
pub(super) fn mark(law: LawName) -> Mark {
    const MARKS: [Mark; 14] = [
        Mark::Stroke,
        Mark::Ring,
        Mark::Disc,
        Mark::HollowSquare,
        Mark::HollowDiamond,
        Mark::Square,
        Mark::Diamond,
        Mark::Triangle,
        Mark::Inverted,
        Mark::Cross,
        Mark::HollowTriangle,
        Mark::Ring,
        Mark::Disc,
        Mark::Stroke,
    ];
    MARKS[(law as usize).min(MARKS.len() - 1)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn limit_four_names_are_one_law() {
        let settings = AtlasSettings {
            masses_kg: [75e3, 3e6],
            approach_speed_m_per_s: 0.3,
            linear_stiffness_n_per_m: 9.35e7,
            hertz_stiffness_n_per_m1_5: 2.75e9,
            restitution: 0.65,
            restitutions: Vec::new(),
            approach_speeds_m_per_s: Vec::new(),
            steps_per_contact: Vec::new(),
        };
        let entries = Entry::all(&settings).expect("laws that take these settings");
        assert_eq!(entries.len(), N_LAWS);
        let names: Vec<_> = entries.iter().flat_map(|entry| &entry.names).collect();
        assert!(names.into_iter().eq(&LawName::ALL), "each law once, in order");
    }
}
