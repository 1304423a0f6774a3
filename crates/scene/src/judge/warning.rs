//! Warnings about a run.

use std::fmt::{self, Formatter};

use pounding_contact::SLOWEST_APPROACH;
use pounding_solver::LedgerError;

use crate::judge::limits::MethodLimits;
use crate::{DeliveredRestitution, Quantity, QuantityGroup, QuantityKind};
use pounding_text::{digits, short};

/// A warning about a run.
#[derive(Debug, Clone, PartialEq)]
pub enum Warning {
    /// The time step is beyond the critical time step of a structure moving alone, and the run was forced.
    BeyondFreeLimit {
        /// The refusal that forcing replaced.
        refusal: String,
    },
    /// A law of mechanics is broken in a run that was forced.
    Broken {
        /// The law, in words.
        law: String,
    },
    /// An exact run leaves more of its energy unexplained than rounding does, but too little to change a decision.
    Doubtful {
        /// Whether it concerns the exact reference run instead of this run.
        reference: bool,
        /// The unexplained energy.
        energy: LedgerError,
    },
    /// A structure has too few steps in its period.
    FewStepsPerPeriod {
        /// Index of the structure.
        structure: usize,
        /// Name of the structure.
        name: String,
        /// Number of steps in its period.
        steps: f64,
        /// Field of the time step in the scene, and its value \[s\].
        time_step: (String, f64),
    },
    /// A pair is unstable while it touches.
    BeyondContactLimit {
        /// The pair.
        place: WarningPlace,
        /// Time step above which it may be unstable \[s\].
        limit: f64,
    },
    /// A collision has too few steps, or so few that its impulse is off.
    UnderResolved {
        /// The pair.
        place: WarningPlace,
        /// Number of steps in the expected collision.
        steps: f64,
        /// e of the law, and what the method delivers instead; `None` if that cannot be measured.
        restitution: Option<(f64, DeliveredRestitution)>,
    },
    /// A pair comes to rest in contact, but this run has an impact in every step because the law is impulsive.
    Rests {
        /// Index of the contact in the scene.
        contact: usize,
        /// Names of its structures.
        names: [String; 2],
    },
    /// A printed number is far from that of the exact run.
    Error {
        /// The number.
        quantity: Quantity,
        /// Largest relative error of the number \[–\].
        error: f64,
    },
    /// Touches are slower than the range of a law with δ̇/v₀.
    SlowTouches {
        /// Index of the contact in the scene.
        contact: usize,
        /// Names of its structures.
        names: [String; 2],
        /// Number of these touches.
        count: usize,
    },
    /// A storey passes its unstable equilibrium under gravity.
    Unstable {
        /// Name of the floor above it.
        name: String,
        /// Drift of the equilibrium \[m\].
        drift: f64,
        /// First instant \[s\].
        time: f64,
        /// Whether the storey collapses in the run.
        collapses: bool,
    },
    /// A floor leaves its seat.
    Unseated {
        /// Index of the contact in the scene.
        contact: usize,
        /// Names of its floors.
        names: [String; 2],
        /// Width of the seat \[m\].
        width: f64,
        /// First instant \[s\].
        time: f64,
    },
    /// The errors are not known, because the exact run fails.
    ErrorUnknown,
}

/// A pair, and the field of the scene that shortens its steps.
#[derive(Debug, Clone, PartialEq)]
pub struct WarningPlace {
    /// Index of the contact in the scene.
    pub contact: usize,
    /// Names of its structures.
    pub names: [String; 2],
    /// Field of the time step in the scene, and its value \[s\].
    pub time_step: (String, f64),
}

impl Warning {
    /// Whether the warning concerns a printed number.
    ///
    /// Warnings about a pair's collisions concern impulses and forces.
    pub fn concerns(&self, asked: Quantity) -> bool {
        match self {
            Self::BeyondFreeLimit { .. }
            | Self::Broken { .. }
            | Self::Doubtful { .. }
            | Self::ErrorUnknown
            | Self::FewStepsPerPeriod { .. } => true,
            Self::BeyondContactLimit { .. } | Self::UnderResolved { .. } | Self::Rests { .. } => {
                let group = asked.about().group;
                matches!(asked, Quantity::Pair(_)) && matches!(group, Some(QuantityGroup::Force | QuantityGroup::Impulse))
            }
            Self::Error { quantity, .. } => asked == *quantity,
            // It concerns the model, which every method shares.
            Self::SlowTouches { .. } | Self::Unstable { .. } | Self::Unseated { .. } => false,
        }
    }
}

impl fmt::Display for WarningPlace {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        let [left, right] = &self.names;
        write!(to, "contacts[{}] ({left} – {right})", self.contact)
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, to: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::BeyondFreeLimit { refusal: text } | Self::Broken { law: text } => {
                write!(to, "forced: {text}")
            }
            Self::Doubtful { reference, energy } => doubtful(*reference, energy, to),
            Self::FewStepsPerPeriod {
                structure,
                name,
                steps,
                time_step: (knob, found),
            } => {
                let most = at_most(found * steps / MethodLimits::STEPS_PER_PERIOD);
                write!(
                    to,
                    "structures[{structure}] ({name}): its period has {steps:.2} steps; {knob} of {most} or less gives \
                     {}",
                    MethodLimits::STEPS_PER_PERIOD
                )
            }
            Self::BeyondContactLimit { place, limit } => {
                let (knob, found) = &place.time_step;
                write!(
                    to,
                    "{place}: impulses and forces may be unstable while it touches: {knob} is {}, allowed there less than {}",
                    digits(*found),
                    digits(*limit)
                )
            }
            Self::UnderResolved { place, steps, restitution } => under_resolved(place, *steps, restitution.as_ref(), to),
            Self::Rests { contact, names } => {
                let [left, right] = names;
                write!(
                    to,
                    "contacts[{contact}] ({left} – {right}): comes to rest in contact in the exact run, where this run has an \
                     impact in every step; their number and impulses depend on the step and are not compared"
                )
            }
            Self::Error { quantity, error } => off(*quantity, *error, to),
            Self::SlowTouches { contact, names, count } => {
                let [left, right] = names;
                write!(
                    to,
                    "contacts[{contact}] ({left} – {right}): {count} touches below {SLOWEST_APPROACH} m/s, for which its damper, \
                     which grows with 1/v₀, is not defined; they count as {SLOWEST_APPROACH} m/s"
                )
            }
            Self::Unstable {
                name,
                drift,
                time,
                collapses,
            } => unstable(name, [*drift, *time], *collapses, to),
            Self::Unseated {
                contact,
                names,
                width,
                time,
            } => unseated(*contact, names, [*width, *time], to),
            Self::ErrorUnknown => write!(to, "the exact run fails, so that no error is known"),
        }
    }
}

/// Describes a storey that passes its unstable equilibrium at a drift \[m\] and an instant \[s\].
fn unstable(name: &str, [drift, time]: [f64; 2], collapses: bool, to: &mut Formatter<'_>) -> fmt::Result {
    let after = if collapses {
        "nothing brought it back"
    } else {
        "shaking, the floors above or neighbours brought it back, or may still do so"
    };
    write!(
        to,
        "{name} passes its unstable equilibrium, a drift of {} mm, at t = {time:.4} s: from there gravity alone brings it down; {after}",
        short(1e3 * drift)
    )
}

/// Describes a floor that leaves a seat of a width \[m\] at an instant \[s\].
fn unseated(contact: usize, [left, right]: &[String; 2], [width, time]: [f64; 2], to: &mut Formatter<'_>) -> fmt::Result {
    write!(
        to,
        "contacts[{contact}] ({left} – {right}): unseated at t = {time:.4} s, where {right} has moved {} mm away from {left}, the width of its seat: it \
         may fall, which the model leaves out",
        short(1e3 * width)
    )
}

/// Describes an exact run with unexplained energy.
fn doubtful(reference: bool, energy: &LedgerError, to: &mut Formatter<'_>) -> fmt::Result {
    let run = if reference {
        "the exact run, by which errors are measured"
    } else {
        "this run, which should be exact"
    };
    write!(to, "{run}: {energy}")
}

/// Describes too few steps in a collision, and the restitution that they deliver.
fn under_resolved(
    place: &WarningPlace,
    steps: f64,
    restitution: Option<&(f64, DeliveredRestitution)>,
    to: &mut Formatter<'_>,
) -> fmt::Result {
    let (knob, found) = &place.time_step;
    write!(to, "{place}: impulses and forces: a collision has {steps:.2} steps")?;
    if let Some((right, delivered)) = restitution {
        write!(to, ", {}", instead(*right, delivered))?;
    }
    if steps < MethodLimits::STEPS_PER_CONTACT {
        let most = at_most(found * steps / MethodLimits::STEPS_PER_CONTACT);
        write!(to, "; {knob} of {most} or less gives {}", MethodLimits::STEPS_PER_CONTACT)
    } else {
        write!(to, "; a shorter {knob} ({found}) gives more")
    }
}

/// Describes a number far from that of the exact run.
fn off(quantity: Quantity, error: f64, to: &mut Formatter<'_>) -> fmt::Result {
    let about = quantity.about();
    let of = about.words;
    if about.kind == QuantityKind::Count {
        write!(to, "{of}: not as many as in the exact run")
    } else if error.is_finite() {
        let decimals = usize::from(error < 0.1);
        let percent = 100.0 * error;
        if percent < 1e4 {
            write!(to, "{of}: {percent:.decimals$} % off the exact run")
        } else {
            write!(to, "{of}: {percent:.1e} % off the exact run")
        }
    } else {
        write!(to, "{of}: none, or zero, in this run or the exact one alone")
    }
}

/// Rounds a time step down to two digits, so that it meets the limit.
fn at_most(step: f64) -> String {
    let unit = libm::pow(10.0, libm::log10(step).floor() - 1.0);
    // A time step of two digits must not lose its last digit to rounding.
    digits((step / unit * (1.0 + 1e-9)).floor() * unit)
}

/// Describes the delivered e and the e of the law.
fn instead(right: f64, delivered: &DeliveredRestitution) -> String {
    let [least, most] = delivered.range;
    format!("e = {least:.3} to {most:.3} instead of {right:.3}")
}
