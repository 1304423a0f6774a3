//! `pounding laws`: every law with its force, formulas, parameters and source.

use pounding::contact::LawName;

use crate::text::paragraph;

/// Every law.
pub(crate) fn answer() -> String {
    let law = |name: &LawName| {
        let about = name.description();
        let lines = [
            ("Law", Some(about.name)),
            ("Force", Some(about.force)),
            ("Formula", about.formula),
            ("Delivers", about.relation.or(Some("found numerically"))),
            ("Fields", Some(&about.parameters.join(", "))),
            ("Source", Some(about.citation)),
        ];
        let lines = lines
            .into_iter()
            .filter_map(|(label, text)| Some(paragraph(label, text?)));
        lines.collect::<String>()
    };
    let laws: Vec<_> = LawName::ALL.iter().map(law).collect();
    format!("{}\n{}", laws.join("\n"), paragraph("Notes", NOTES))
}

const NOTES: &str = "δ deformation, δ̇ its rate, v₀ approach speed, m reduced mass, e restitution.\nFormula: \
                     the authors' damping for an e asked. Delivers: the e of a free impact, exactly. Fields: as in a \
                     scene, where corrected_hertz_damp, hunt_crossley and gonthier are hertz_damp; instead of its damping a law \
                     may be given a `restitution` and a `calibration`.\n`pounding certify` \
                     prints what a law and a method really deliver.";
