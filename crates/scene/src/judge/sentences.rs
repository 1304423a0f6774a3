//! Sentences about responses beyond the model or the limits of codes.

use std::fmt::{self, Display, Formatter};

use pounding_text::{percent, short, two_digits};

use super::excess_kind::ExcessKind;
use super::response::Excess;
use crate::Floors;

impl Display for Excess {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        write!(to, "{}: {}", self.name, self.says())
    }
}

impl Excess {
    /// Describes the response in a sentence, with the number of runs that have it.
    fn says(&self) -> String {
        if self.kind.is_unwatched() {
            return self.says_unwatched();
        }
        let worst = match self.often() {
            often if often.is_empty() => often,
            often if self.kind == ExcessKind::Collapse => format!("{often}, "),
            often => format!("{often}, at worst "),
        };
        format!("{worst}{}", self.says_alone())
    }

    fn says_alone(&self) -> String {
        let found = self.found;
        match self.kind {
            ExcessKind::AtColumn | ExcessKind::BesideColumn | ExcessKind::AtFoot | ExcessKind::LeftOut => String::new(),
            ExcessKind::ColumnHit => column_hit(found, self.capacity),
            ExcessKind::Collapse => format!(
                "collapses under gravity: its drift passes {} of its height, and the run ends there (collapse_drift_ratio)",
                percent(found)
            ),
            ExcessKind::Displacement if self.capacity.is_some() => format!(
                "displacement of {} mm of its isolators, above their capacity of {} mm: they may tear, stiffen or slide off, which the model \
                 leaves out",
                short(1e3 * found),
                short(1e3 * self.capacity.unwrap_or_default())
            ),
            ExcessKind::Displacement => format!(
                "drift of {} m: more than 2.5 % of any usual storey; give height_m, and look at the scale of the record",
                short(found)
            ),
            ExcessKind::Stability => gravity(found),
            ExcessKind::Drift => drift(found, self.capacity),
            ExcessKind::Ductility => format!(
                "ductility demand of {}, above 6: columns lose strength, which the model leaves out. {DUCTILE}",
                short(found)
            ),
            ExcessKind::Shear => format!(
                "shear force of {} kN, above its capacity of {} kN: it fails before it does what the model says",
                short(1e-3 * found),
                short(1e-3 * self.capacity.unwrap_or_default())
            ),
            ExcessKind::MassDamping => format!(
                "the mass term of its damping is {} of critical at the period of the peak drifts, above 1 %: dashpots between the floors and \
                 the ground, which no building on isolators has, hold it back and lessen its blows; give damping.rayleigh with \
                 alpha_per_s = 0",
                percent(found)
            ),
            ExcessKind::ResidualDrift if found > ExcessKind::MOST_DRIFT => format!(
                "drift of {} of the height left at the end, more than 2.5 %, which columns hardly survive: the value is one of a model \
                 without loss of strength, and says only that the structure would not be used again",
                percent(found)
            ),
            ExcessKind::ResidualDrift => format!(
                "drift of {} of the height left at the end, above 0.5 % (McCormick et al. 2008): realignment likely; the value depends \
                 on the model of yielding",
                percent(found)
            ),
            ExcessKind::BaseShear => format!(
                "shear force of {} times the weight above, more than 0.4: few structures are that strong (yield_force_n, shear_capacity_n)",
                two_digits(found)
            ),
            ExcessKind::DamperForce => format!(
                "damper force of {} of the yield force, above 10 % (Hall 2006; Charney 2008): strength that no column has, and not in shear; a \
                 smaller damping ratio is nearer to the building",
                percent(found)
            ),
        }
    }

    /// A sentence about the largest drift ratio that is judged as of ductile construction because its storey has no capacity, from drifts
    /// \[m\] of the floors; `None` if it harms no construction, is beyond the limit and thus an excess, or if the row is a bridge.
    pub fn says_assumed(floors: &Floors, drift: impl Fn(usize) -> f64) -> Option<String> {
        if floors.is_bridge() {
            return None;
        }
        let all = floors.all().iter().enumerate();
        let assumed = all.filter(|(_, one)| {
            let told = one.made_of.map(|made| made.capacities.drift_capacity_ratio);
            told == Some(None) && !one.is_isolation_layer()
        });
        let ratios = assumed.filter_map(|(floor, one)| one.drift_ratio(drift(floor)));
        let largest = ratios.reduce(f64::max)?;
        (largest > BRITTLE && largest <= ExcessKind::MOST_DRIFT).then(|| {
            format!(
                "drifts of up to {} of the height are judged by 2.5 %, the limit of ductile construction, which is assumed; masonry and \
                 non-ductile frames fail at 0.4 to 1 % (drift_capacity_ratio)",
                percent(largest)
            )
        })
    }

    fn says_unwatched(&self) -> String {
        let often = match self.often() {
            often if often.is_empty() => often,
            often => format!("{often} "),
        };
        let farther = short(1e3 * self.found);
        if self.kind == ExcessKind::LeftOut {
            return format!(
                "not looked at, because `levels` of the contact leaves them out; {often}both neighbours together may move up to {farther} mm \
                 farther than the gap"
            );
        }
        if self.kind == ExcessKind::AtFoot {
            return format!(
                "its base slab at the ground faces the foot of its neighbour, where no contact is modelled; {often}it moves up to {farther} mm \
                 farther than the gap"
            );
        }
        // Without a contact nothing touches, and nothing is left out.
        let [than, not_modelled] = if self.kind == ExcessKind::AtColumn {
            [" farther than the gap", ", and is not modelled"]
        } else {
            ["", ""]
        };
        format!(
            "faces columns of its neighbour between floors; {often}both together may move up to {farther} mm{than}: a floor that hits a column \
             can bring a building down{not_modelled}"
        )
    }
}

/// A column that a slab hits, with its shear force \[N\], 0 if impacts have none.
fn column_hit(found: f64, capacity: Option<f64>) -> String {
    let shear = two_digits(1e-3 * found);
    match capacity {
        _ if found <= 0.0 => {
            "a slab of the neighbour hits it between its floors, which can bring the building down; the law has no force that \
                              could be compared with the strength of a column"
                .into()
        }
        Some(capacity) => format!(
            "a slab of the neighbour hits it between its floors: a shear force of {shear} kN in one column for the assumed contact stiffness, \
             above its capacity of {} kN: it fails, which the model leaves out, and the storey may come down",
            short(1e-3 * capacity)
        ),
        None => format!(
            "a slab of the neighbour hits it between its floors: a shear force of {shear} kN in one column for the assumed contact stiffness, \
             which can bring the building down (column_capacity_n; slab_depth_m where slabs overlap)"
        ),
    }
}

/// Least drift ratio at which masonry fails \[–\]: EN 1998-3:2005, annex C, for walls in shear.
const BRITTLE: f64 = 0.004;

/// The assumption behind general limits of drift.
const DUCTILE: &str = "Ductile construction is assumed; masonry and non-ductile frames fail at 0.4 to 1 % (drift_capacity_ratio)";

fn drift(found: f64, capacity: Option<f64>) -> String {
    let found = percent(found);
    match capacity {
        Some(capacity) => format!(
            "drift of {found} of the height, above its capacity of {}: columns that lose strength, which the model leaves out, decide",
            percent(capacity)
        ),
        None => format!(
            "drift of {found} of the height, above 2.5 %, the limit for buildings (NBCC 2015, 4.1.8.13): columns that lose strength, which the model leaves out, \
             decide. {DUCTILE}"
        ),
    }
}

/// What gravity does at a stability coefficient θ = P Δ/(V h): of a perfectly plastic storey it leaves 1 − θ of the strength.
fn gravity(found: f64) -> String {
    let theta = format!("stability coefficient P Δ/(V h) = {}", short(found));
    let [matters, most] = ExcessKind::MOST_STABILITY;
    let left = format!("{:.0} %", 100.0 * (1.0 - found));
    if found >= 1.0 {
        format!(
            "{theta}, above the design limit of {most} (ASCE 7-16, 12.8.7): at this drift gravity, which the model leaves out, asks for at least the \
             whole shear force of the storey, so that nothing is left against shaking; the drifts of this run cannot be relied on, and a run \
             with gravity is needed"
        )
    } else if found > most {
        format!(
            "{theta}, above the design limit of {most} (ASCE 7-16, 12.8.7), which is no collapse: gravity, which the model leaves out, leaves \
             {left} of the strength where the storey yields; a run with gravity is needed"
        )
    } else {
        format!(
            "{theta}, above {matters} (EN 1998-1:2004, 4.4.2.2): gravity, which the model leaves out, adds to the drift, and leaves {left} of the \
             strength where the storey yields"
        )
    }
}
