//! Sentences of an assessment about bumpers in the gaps.

use pounding_assess::{Bumper, BumperEffect, BumperHarm, Distribution};
use pounding_text::{digits, millimetres, short, two_decimals, two_digits};
use serde_json::{Value, json};

use super::AssessmentReport;
use super::tables::statistics;

/// A change in words, of a ratio: "−60 %", "+3 %", and from twice on "× 2.4".
pub(super) fn change(ratio: f64) -> String {
    let per_cent = (100.0 * (ratio - 1.0)).round();
    if ratio >= 2.0 {
        format!("× {}", two_digits(ratio))
    } else if per_cent > 0.0 {
        format!("+{per_cent:.0} %")
    } else if per_cent < 0.0 {
        format!("\u{2212}{:.0} %", per_cent.abs())
    } else {
        "0 %".into()
    }
}

/// Median and 84 % of ratios as changes; of few only the largest.
fn both(of: &Distribution) -> String {
    if of.has_quantiles() {
        format!("{} (84 %: {})", change(of.median()), change(of.p84()))
    } else {
        format!("at most {}", change(of.largest()))
    }
}

impl AssessmentReport {
    /// The effects of bumpers; `None` if nothing touches or none were asked for.
    pub fn bumpers(&self) -> Option<&BumperEffect> {
        self.bumper.as_ref()
    }

    fn bumper_name(&self, bumper: &Bumper) -> String {
        let [left, right] = [bumper.contact, bumper.contact + 1].map(|index| self.scene.structures[index].name());
        format!("{left} and {right}")
    }

    /// The law of a bumper, in words behind its place.
    fn bumper_law(&self, bumper: &Bumper) -> String {
        let contact = self.scene.contacts.iter().flatten().nth(bumper.contact);
        let law = contact.map(|contact| bumper.law(contact));
        law.map_or_else(String::new, |law| {
            let restitution = law
                .restitution()
                .map_or_else(String::new, |restitution| format!(" with e = {}", two_decimals(restitution)));
            format!(", law {}{restitution}", law.name().replace('_', " "))
        })
    }

    /// Sentences about the effects of bumpers at the given gaps; empty without bumpers.
    pub fn bumper_says(&self) -> Vec<String> {
        let Some(effect) = &self.bumper else {
            return Vec::new();
        };
        let one = |bumper: &Bumper| {
            format!(
                "{} mm and {} MN/m between {}{}",
                millimetres(bumper.thickness),
                short(1e-6 * bumper.stiffness),
                self.bumper_name(bumper),
                self.bumper_law(bumper)
            )
        };
        let bumpers: Vec<String> = effect.bumpers.iter().map(one).collect();
        let bumpers = bumpers.join("; ");
        let through = match effect.too_thin {
            0 => None,
            n => Some(format!(
                "compressed by more than their thickness in {n} of {} runs, and what is behind them then hits, which no run models",
                effect.runs
            )),
        };
        let harm = effect.harm().map(|(harm, ratio)| {
            let what = match harm {
                BumperHarm::Force => "the largest force of a gap".into(),
                BumperHarm::Drift(floor) => format!("the drift of {}", self.storey_name(floor)),
                BumperHarm::Acceleration(floor) => format!("the acceleration of {}", self.floor_name(floor)),
            };
            format!("make {what} up to {} times as large", two_digits(ratio))
        });
        // In this order, since nothing is known of a bumper that is compressed through.
        let fault = through.map(|through| format!("are {through}")).or(harm);
        let unfounded = self.unfounded().filter(|_| self.is_proposed());
        vec![match (unfounded, fault) {
            (Some(why), _) => format!("No bumper is proposed: {why}."),
            (None, Some(fault)) if self.is_proposed() => format!(
                "No bumper is proposed: half as thick as their gap and {} to {} times as stiff as the softest that stop two free floors, all fail. \
                 The stiffest ({bumpers}) {fault}.",
                digits(Bumper::TRIED[0]),
                digits(Bumper::TRIED[Bumper::TRIED.len() - 1])
            ),
            (None, Some(fault)) => format!("Bumpers at the given gap ({bumpers}) are no solution: they {fault}."),
            (None, None) => {
                let force = effect.force.as_ref();
                let force = force.map_or_else(String::new, |force| format!("forces by {}, ", both(force)));
                format!(
                    "Bumpers at the given gap ({bumpers}) change {force}drifts by {}, accelerations by {} in the runs that touch. None is \
                     compressed by more than its thickness, and no force, drift or acceleration becomes more than 10 % larger.",
                    both(&effect.drift),
                    both(&effect.acceleration)
                )
            }
        }]
    }

    /// Whether the program chose the stiffness of the bumpers.
    fn is_proposed(&self) -> bool {
        let words = self.bumper_words.as_ref();
        words.is_some_and(|words| words.contains("proposed"))
    }

    /// Whether bumpers have a result: none is compressed through, and proposed ones harm nothing.
    pub(super) fn bumpers_hold(&self) -> bool {
        let holds =
            |effect: &BumperEffect| !effect.is_too_thin() && (!self.is_proposed() || (effect.helps() && self.unfounded().is_none()));
        self.bumper.as_ref().is_some_and(holds)
    }

    /// The effect of bumpers for programs; null without bumpers.
    pub(super) fn bumper_json(&self) -> Value {
        let Some(effect) = &self.bumper else {
            return Value::Null;
        };
        let bumper = |one: &Bumper| {
            let [left, right] = [one.contact, one.contact + 1].map(|index| self.scene.structures[index].name());
            json!({
                "left": left,
                "right": right,
                "law": self.scene.contacts.iter().flatten().nth(one.contact).map(|contact| one.law(contact)),
                "stiffness_n_per_m": one.stiffness,
                "thickness_m": one.thickness,
            })
        };
        if !self.bumpers_hold() {
            return json!({
                "bumpers": if self.is_proposed() { Vec::new() } else { effect.bumpers.iter().map(bumper).collect() },
                "helps": false,
                "why": self.bumper_says(),
                "runs": effect.runs,
                "too_thin_runs": effect.too_thin,
            });
        }
        json!({
            "helps": effect.helps(),
            "bumpers": effect.bumpers.iter().map(bumper).collect::<Vec<_>>(),
            "runs": effect.runs,
            "too_thin_runs": effect.too_thin,
            "force_with_over_without": effect.force.as_ref().map(statistics),
            "drift_with_over_without": statistics(&effect.drift),
            "acceleration_with_over_without": statistics(&effect.acceleration),
            "floors": self.bumper_storeys(effect).json(),
            "pairs": self.bumper_pairs(effect).json(),
        })
    }
}
