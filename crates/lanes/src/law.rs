//! Contact laws of several scenes in lanes.

use fearless_simd::Simd;
use pounding_contact::{ContactLaw, Form, NonlinearViscoelastic, Number, Slope, Term, ViscoelasticPair};

use super::number::{Lanes, MOST_LANES, Mask};

/// A contact law with the parameters of every lane.
pub(super) enum Law<S: Simd> {
    Impulsive(Impulsive<S>),
    Viscoelastic(ViscoelasticPair<Lanes<S>>),
    /// Any other law.
    Formed(Box<Formed<S>>),
}

/// Stereomechanical impact.
#[derive(Clone, Copy)]
pub(super) struct Impulsive<S: Simd> {
    /// 1 + e.
    pub(super) factor: Lanes<S>,
}

/// A law of the common form. Its damper may depend on the rate of the first touch.
pub(super) struct Formed<S: Simd> {
    laws: [ContactLaw; MOST_LANES],
    reduced_masses: [f64; MOST_LANES],
    remembers: bool,
    /// Rate of the first touch of the present contact \[m/s\].
    approach_speeds: [f64; MOST_LANES],
    /// Lanes in which this rate is known.
    known: Mask<S>,
    form: Form<Lanes<S>>,
}

impl<S: Simd> Law<S> {
    /// Laws of a common kind, with the reduced masses of their pairs \[kg\].
    #[inline(always)]
    pub(super) fn new(simd: S, laws: [ContactLaw; MOST_LANES], masses: [f64; MOST_LANES]) -> Self {
        if laws[0].impulsive().is_some() {
            let restitution = laws.map(|law| law.impulsive().map_or(f64::NAN, |law| law.restitution));
            let restitution = Lanes::new(simd, &restitution);
            return Self::Impulsive(Impulsive {
                factor: restitution.like(1.0) + restitution,
            });
        }
        if let ContactLaw::NonlinearViscoelastic(_) = laws[0] {
            let reduced_mass = Lanes::new(simd, &masses);
            let of = |number: fn(&NonlinearViscoelastic) -> f64| {
                let numbers = laws.map(|law| {
                    if let ContactLaw::NonlinearViscoelastic(element) = law {
                        number(&element)
                    } else {
                        f64::NAN
                    }
                });
                Lanes::new(simd, &numbers)
            };
            return Self::Viscoelastic(ViscoelasticPair {
                impact_stiffness: of(|element| element.impact_stiffness),
                impact_damping_ratio: of(|element| element.impact_damping_ratio),
                reduced_mass,
            });
        }
        let approach_speeds = [0.0; MOST_LANES];
        Self::Formed(Box::new(Formed {
            remembers: laws[0].knows_approach_speed(),
            form: form(simd, &laws, &masses, &approach_speeds),
            laws,
            reduced_masses: masses,
            approach_speeds,
            known: Mask::splat(simd, false),
        }))
    }

    /// Force of a compliant law \[N\] at a deformation and its rate, 0 if the pair does not overlap; `None` for an impulsive law.
    #[inline(always)]
    pub(super) fn force(&mut self, deformation: Lanes<S>, rate: Lanes<S>) -> Option<Lanes<S>> {
        let zero = rate.like(0.0);
        let overlaps = deformation.exceeds(zero);
        let force = match self {
            Self::Impulsive(_) => return None,
            Self::Viscoelastic(pair) => pair.force(deformation, rate).0,
            Self::Formed(law) => {
                law.remember(overlaps, rate);
                law.form.force(deformation, rate)
            }
        };
        Some(Number::select(overlaps, force, zero))
    }
}

impl<S: Simd> Formed<S> {
    /// Stores the rate as approach speed of new overlaps, and forgets that of pairs that do not overlap.
    #[inline(always)]
    fn remember(&mut self, overlaps: Mask<S>, rate: Lanes<S>) {
        if !self.remembers {
            return;
        }
        let new = overlaps & !self.known;
        self.known = overlaps;
        if Lanes::any(new) {
            let rates = rate.values();
            for (lane, (speed, rate)) in self.approach_speeds.iter_mut().zip(rates).enumerate() {
                if new.test(lane) {
                    *speed = rate.max(0.0);
                }
            }
            self.form = form(rate.token(), &self.laws, &self.reduced_masses, &self.approach_speeds);
        }
    }
}

/// The form of compliant laws of a common kind, with reduced masses and approach speeds.
#[inline(always)]
fn form<S: Simd>(simd: S, laws: &[ContactLaw; MOST_LANES], masses: &[f64; MOST_LANES], speeds: &[f64; MOST_LANES]) -> Form<Lanes<S>> {
    let forms = std::array::from_fn::<_, MOST_LANES, _>(|lane| {
        let form = laws[lane].form(masses[lane], speeds[lane]);
        form.expect("a law that is not impulsive has a form")
    });
    let term = |of: fn(&Form) -> Term| Term {
        coefficient: Lanes::new(simd, &forms.map(|form| of(&form).coefficient)),
        power: of(&forms[0]).power,
    };
    let number = |of: fn(&Slope) -> f64| Lanes::new(simd, &forms.map(|form| form.second.as_ref().map_or(f64::NAN, of)));
    Form {
        spring: term(|form| form.spring),
        damper: term(|form| form.damper),
        action: forms[0].action,
        second: forms[0].second.map(|_| Slope {
            from: number(|second| second.from),
            added: number(|second| second.added),
        }),
    }
}
