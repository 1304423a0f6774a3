//! Words about the rules of codes for gaps: what each takes, and the width that a code asks for.

use pounding_assess::{Rule, RuleAssessment};
use pounding_scene::{Property, Scene, Structure};
use pounding_text::{digits, millimetres, millimetres_up};

/// A gap as rules see it.
pub(crate) struct RuledGap<'a> {
    /// Index of the structure on the left.
    pub(crate) left: usize,
    /// Gap of the scene \[m\].
    pub(crate) own: Option<f64>,
    /// Widest gap that a motion asks for \[m\].
    pub(crate) needed: f64,
    /// Widths by the rules.
    pub(crate) rules: &'a [RuleAssessment],
    /// Why some events do not count; `None` if all do.
    pub(crate) not_counted: Option<String>,
    /// The word for a sample: "event", or "case" for an event beside a neighbour that was drawn.
    pub(crate) sample: &'static str,
}

impl RuledGap<'_> {
    fn names(&self, scene: &Scene) -> String {
        let [left, right] = [self.left, self.left + 1].map(|index| scene.structures[index].name());
        format!("{left} and {right}")
    }

    fn property(&self, scene: &Scene) -> Property {
        let contacts = scene.contacts.as_deref().unwrap_or_default();
        contacts.get(self.left).map_or_else(Property::default, |one| one.property)
    }

    /// The width that a code asks for under these motions, in a sentence.
    pub(crate) fn by_code(&self, scene: &Scene, code: Rule) -> String {
        let (words, names) = (code.words(), self.names(scene));
        let contacts = scene.contacts.as_deref().unwrap_or_default();
        if contacts.get(self.left).is_some_and(|contact| contact.seat_width_m.is_some()) {
            return format!(
                "By {}: no width between {names}, because its rule is for buildings; joints and seats of decks: EN 1998-2.",
                code.cited()
            );
        }
        let Some(one) = self.rules.iter().find(|one| one.rule == code) else {
            // Beside isolators only the sum of both peaks has a width.
            let why = if self.rules.iter().all(|one| one.rule == Rule::Abs) {
                "a rule for joints does not size the moat of a building on isolators"
            } else {
                "the rule takes heights: give height_m"
            };
            return format!("By {}: no width between {names}, because {why}.", code.cited());
        };
        let n = one.width.sorted().len();
        let (width, is_mean) = asked(one, self.sample);
        let of = match (is_mean, n) {
            _ if code == Rule::Gb50011 => "by height alone".into(),
            (true, n) => format!("mean of {n} events"),
            (false, 1) => format!("the only {}", self.sample),
            (false, n) => format!("largest of {n} {}s", self.sample),
        };
        let few = if n < words.least_events {
            format!("; the code wants {} or more", words.least_events)
        } else {
            String::new()
        };
        let narrowed = one.narrowed().map_or_else(String::new, |factor| {
            format!(", with {} for level floors, which accepts that slabs meet", digits(factor))
        });
        // Both codes have another width on one property.
        let has_both = matches!(code, Rule::Eurocode8 | Rule::Asce7);
        let is_wall = |index: usize| matches!(scene.structures[index], Structure::Wall);
        let beside_wall = is_wall(self.left) || is_wall(self.left + 1);
        let owners = if has_both && !beside_wall && self.property(scene) == Property::Other {
            ", for two owners of the ground"
        } else {
            ""
        };
        let width_mm = millimetres_up(width);
        if let Some(why) = self.not_counted.as_ref().filter(|_| code != Rule::Gb50011) {
            return format!(
                "By {}: no width between {names}, because {why}; the others would give {width_mm} mm ({of}{few}){owners}{narrowed}.",
                code.cited()
            );
        }
        let own = self.says_own(code, width);
        format!(
            "By {}: {width_mm} mm between {names} ({of}{few}){owners}{narrowed}.{own}",
            code.cited()
        )
    }

    /// Whether the given gap meets the width of a code, and what the strongest motion needs.
    fn says_own(&self, code: Rule, width: f64) -> String {
        let needed = millimetres_up(self.needed);
        let stronger = if width < self.needed {
            format!(" The strongest of these motions needs {needed} mm.")
        } else {
            String::new()
        };
        self.own.map_or(stronger, |own| {
            let own_mm = millimetres(own);
            let meets = if own < width { "do not meet it" } else { "meet it" };
            let keeps = match (own < width, own < self.needed) {
                (false, true) => format!(", but do not keep them apart: the strongest of these motions needs {needed} mm"),
                (true, false) => ", though no motion here closes them".into(),
                _ => String::new(),
            };
            // A width by height alone is asked for whatever the motions.
            let by = if code == Rule::Gb50011 {
                "The"
            } else {
                "If these motions are at its level, the"
            };
            format!(" {by} given {own_mm} mm {meets}{keeps}.")
        })
    }
}

/// The width that a code asks for under all samples \[m\], and whether it is their mean; cases beside drawn neighbours have none.
pub(crate) fn asked(one: &RuleAssessment, sample: &str) -> (f64, bool) {
    if sample == "event" {
        one.asked()
    } else {
        (one.width.largest(), false)
    }
}

/// Editions, clauses and words of the codes among these rules.
pub(crate) fn sources(shown: &[Rule]) -> String {
    let codes = shown.iter().filter(|rule| rule.words().clause.is_some());
    let cited: Vec<String> = codes.map(|rule| format!("{} ({})", rule.cited(), rule.words().says)).collect();
    format!("Codes: {}.", cited.join("; "))
}

/// Conditions of the widths by these rules: factors that are left out, property lines, level floors and clauses that were not seen.
pub(crate) fn notes(scene: &Scene, gaps: &[RuledGap<'_>], shown: &[Rule]) -> Vec<String> {
    let mut said = vec!["Rules take the displacements of the time history; C_d, q, R and I_e of the codes are not applied.".into()];
    let is_wall = |index: usize| matches!(scene.structures[index], Structure::Wall);
    for (property, words) in [
        (
            Property::Other,
            "a property line is assumed, and each keeps its own displacement to it; `property = \"same\"` of the contact tells otherwise",
        ),
        (Property::Same, "both stand on one property, as the scene says"),
    ] {
        let own = gaps.iter().filter(|gap| gap.property(scene) == property);
        let own = own.filter(|gap| !is_wall(gap.left) && !is_wall(gap.left + 1));
        let names: Vec<String> = own.map(|gap| gap.names(scene)).collect();
        if !names.is_empty() {
            said.push(format!("Between {}: {words}.", names.join(", between ")));
        }
    }
    let shown: Vec<Rule> = shown
        .iter()
        .filter(|rule| gaps.iter().flat_map(|gap| gap.rules).any(|one| one.rule == **rule))
        .copied()
        .collect();
    let narrowed = |rule: &Rule| {
        let mut ruled = gaps.iter().flat_map(|gap| gap.rules);
        let factor = ruled.find(|one| one.rule == *rule)?.narrowed()?;
        Some(format!("{} ({})", rule.name(), digits(factor)))
    };
    let narrowed: Vec<String> = shown.iter().filter_map(narrowed).collect();
    if !narrowed.is_empty() {
        said.push(format!("Factors for level floors accept that slabs meet: {}.", narrowed.join(", ")));
    }
    let unseen = shown.iter().filter(|rule| !rule.is_seen());
    said.extend(unseen.map(|rule| format!("{}: clause not seen, so that its width may be wrong.", rule.words().edition)));
    said
}
