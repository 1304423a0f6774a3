//! Sentences of an assessment about bumpers in the gaps.

use pounding_assess::{Bumper, BumperEffect, Distribution};
use pounding_text::{millimetres, short, two_decimals, two_digits};
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

fn both(of: &Distribution) -> String {
    format!("{} (84 %: {})", change(of.median()), change(of.p84()))
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
            format!(", law {}{restitution}", law.name())
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
        let is_given = self.bumper_words.as_ref().is_some_and(|words| words.contains("k="));
        let why = if is_given {
            String::new()
        } else {
            format!(
                ", half of the gap, the softest that stop the approach that 84 % of the runs do not exceed at {:.0} % of it",
                100.0 * Bumper::COMPRESSION
            )
        };
        let bumpers = format!("Bumpers at the given gap ({}{why})", bumpers.join("; "));
        // Then the floors behind them hit, which no run models.
        if effect.is_too_thin() {
            return vec![format!(
                "{bumpers} are compressed by more than their thickness in {} of {} runs: what is behind them then hits, which is left out, \
                 so that their effect is not known.",
                effect.too_thin, effect.runs
            )];
        }
        let force = effect.force.as_ref();
        let force = force.map_or_else(String::new, |force| format!("forces by {}, ", both(force)));
        let thin = match effect.too_thin {
            0 => "None is compressed by more than its thickness.".into(),
            n => format!(
                "In {n} of {} runs one is compressed by more than its thickness: what is behind it then hits, which is left out.",
                effect.runs
            ),
        };
        vec![format!(
            "{bumpers} change {force}drifts by {}, accelerations by {} in the runs that touch. {thin}",
            both(&effect.drift),
            both(&effect.acceleration)
        )]
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
        json!({
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
