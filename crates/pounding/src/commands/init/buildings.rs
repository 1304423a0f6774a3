//! Buildings of several storeys to begin with, and the contacts between neighbours.

use pounding::text::Refused;
use pounding::text::digits;

/// More storeys than any building has, and more buildings than any street.
const MOST: usize = 200;

/// A number of storeys.
pub(super) fn storeys(text: &str) -> Result<usize, String> {
    match text.trim().parse() {
        Ok(number) if (1..=MOST).contains(&number) => Ok(number),
        _ => Err(format!("allowed is a whole number from 1 to {MOST}")),
    }
}

/// Refuses more buildings than a user would fill in.
pub(super) fn check(buildings: usize) -> Result<(), Refused> {
    if buildings <= MOST {
        return Ok(());
    }
    let found = Refused::at("--storeys").found(format!("{buildings} buildings"));
    let found = found.allowed_are(format!("up to {MOST}"));
    Err(found.help("write a longer row with a program"))
}

/// A gap \[m\].
pub(super) fn gap(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(gap) if (0.0..=10.0).contains(&gap) => Ok(gap),
        _ => Err("allowed is a length from 0 to 10, in metres, such as 0.04".into()),
    }
}

/// Equal storeys, with numbers to be replaced: a period of a tenth of a second per storey is a rule of thumb for frames.
pub(super) fn structures(storeys: &[usize]) -> String {
    let building = |(index, n): (usize, &usize)| {
        let told = |comment: &str| {
            if index == 0 { format!("  # {comment}") } else { String::new() }
        };
        format!(
            "[[structures]]\n\
             [structures.building]\n\
             name = \"building {}\"\n\
             period_s = {}{}\n\
             damping.ratio = 0.05{}\n\
             storeys = [{{ mass_kg = 300e3, height_m = 3.2, repeat = {n} }}]{}\n\n",
            index + 1,
            digits(0.1 * *n as f64),
            told("first period, a rule of thumb: 0.1 s per storey; equal storeys get the stiffness that gives it"),
            told("in the first two modes"),
            told("elastic; yield_drift_ratio = 0.005 lets it yield"),
        )
    };
    let mut text: String = storeys.iter().enumerate().map(building).collect();
    text.truncate(text.trim_end().len());
    text.push('\n');
    text
}

/// A contact between every two neighbours, with a law.
pub(super) fn contacts(n_gaps: usize, gap: f64, law: &str) -> String {
    let contact = |index: usize| {
        let other = if index == 0 {
            "# law.stereomechanical = { restitution = 0.65 }      # an impulse; `pounding laws` lists all laws\n"
        } else {
            ""
        };
        format!(
            "[[contacts]]\n\
             gap_m = {}\n\
             {law}\n\
             {other}\n",
            digits(gap)
        )
    };
    (0..n_gaps).map(contact).collect()
}
