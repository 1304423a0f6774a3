//! Laws in files.

use pounding_contact::{Calibration, ContactLaw, Exact, LawName};

use crate::{damped, law, stiffness};

/// Reads a law from its settings after the stiffness.
fn read(name: LawName, words: &str) -> Result<ContactLaw, String> {
    let parameter = name.parameters()[0].name;
    let (law, stiffness) = (name_of_law(name), stiffness(name));
    let text = format!(r#"{{"{law}": {{"{parameter}": {stiffness:e}, {words}}}}}"#);
    serde_json::from_str(&text).map_err(|error| error.to_string())
}

/// Name of the force. Several names of the literature share it.
fn name_of_law(name: LawName) -> &'static str {
    let law = law(name, 0.5, Calibration::Exact).expect("within range");
    law.name()
}

/// Laws whose damping follows from e for every pair.
fn calibrated() -> impl Iterator<Item = LawName> {
    damped().filter(|name| matches!(name.about().exact, Exact::Any(_)))
}

#[test]
fn limit_a_law_given_by_its_restitution_is_the_calibrated_one() {
    for name in calibrated() {
        let known = |calibration| law(name, 0.65, calibration).expect("within range");
        let read = |words: &str| read(name, words).expect("a law");
        let exact = known(Calibration::Exact);
        assert_eq!(read(r#""restitution": 0.65"#), exact);
        assert_eq!(read(r#""restitution": 0.65, "calibration": "exact""#), exact);
        // Names that share a force differ in the literature's formula. Files use the formula of the force's first name.
        if name_of_law(name) == name.name() {
            let literature = r#""restitution": 0.65, "calibration": "literature""#;
            assert_eq!(read(literature), known(Calibration::Literature));
        }
        let written = serde_json::to_string(&exact).expect("it can be written");
        let again: ContactLaw = serde_json::from_str(&written).expect("it can be read");
        // Reading may round the last digit.
        let [again, exact] = [again, exact].map(|law| law.restitution().expect("a closed form"));
        assert!((again - exact).abs() < 1e-15, "{written}: {again}");
    }
}

#[test]
fn extreme_a_law_given_in_too_few_or_too_many_words_is_refused() {
    for name in calibrated() {
        let damping = name.parameters()[1].name;
        let refused = |words: &str, part: &str| {
            let message = read(name, words).expect_err(words);
            assert!(message.contains(part), "{words}: {message}");
        };
        let both = format!(r#""{damping}": 0.3, "restitution": 0.65"#);
        refused(&both, &format!("found both `{damping}` and `restitution`"));
        refused(r#""calibration": "exact""#, &format!("found neither `{damping}` nor `restitution`"));
        let alone = format!(r#""{damping}": 0.3, "calibration": "exact""#);
        refused(&alone, "found `calibration` without `restitution`");
        refused(r#""restitution": 1.2"#, "restitution: found 1.2, allowed more than 0, up to 1");
        refused(r#""restitution": 0.65, "speed": 1"#, "unknown field `speed`");
        refused(r#""restitution": 0.65, "calibration": "best""#, "unknown variant `best`");
    }
}
