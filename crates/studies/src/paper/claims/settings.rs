//! Claims about inputs of the runs: time step, damping, restitution (sections 2 and 3, Table 1).

use crate::StudyError;
use pounding_contact::ContactLaw;
use pounding_solver::Damping;

use super::{Finding, Outcome, Runs, change, momentum};
use pounding_scene::Structure;

pub(super) fn stability(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let scene = runs.scene("table-2", "elastic")?.scene;
    let shortest = scene.structures.iter().filter_map(Structure::period).fold(f64::INFINITY, f64::min);
    let critical = shortest / std::f64::consts::PI;
    let dt = scene.method.step();
    Ok((
        format!("critical time step of the stiff structure {critical:.4} s, used {dt} s"),
        Finding::of(dt < critical, true),
    ))
}

pub(super) fn time_step(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let coarse = momentum(runs.scene("table-2", "elastic")?, 0);
    let mut finer = Vec::new();
    for step in ["5", "2.5", "1.25"] {
        let run = runs.scene("claims", &format!("two structures elastic, {step} ms"))?;
        finer.push((step, momentum(run, 0)));
    }
    let close = finer.iter().all(|(_, total)| change(coarse, *total).abs() <= 3.0);
    let words: Vec<_> = finer.iter().map(|(step, total)| format!("{total:.0} at {step} ms")).collect();
    Ok((
        format!(
            "stereomechanical, elastic: total momentum {coarse:.0} kN·s at 10 ms, {}",
            words.join(", ")
        ),
        Finding::of(close, true),
    ))
}

pub(super) fn damping_ratios(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let used = runs.scene("table-2", "elastic")?;
    let as_printed = runs.scene("claims", "Table 1 damping")?;
    let ratios = used.scene.structures.iter().filter_map(Structure::damping_ratio);
    let ratios: Vec<f64> = ratios.map(|ratio| 100.0 * ratio).collect();
    let second = |run: super::SceneRun<'_>| run.outcome.collisions.all().get(1).map_or(f64::NAN, |second| second.impulse);
    let shift = change(second(used), second(as_printed));
    let coefficients = match Damping::rayleigh_from_ratios([1.0, 10.0], [0.05, 0.05]) {
        Ok(Damping::Rayleigh { alpha, beta }) => format!("α = {alpha:.4} 1/s, β = {beta:.6} s"),
        Ok(Damping::Ratio(_)) | Err(_) => unreachable!("two different frequencies give Rayleigh damping"),
    };
    Ok((
        format!(
            "the published forces need 5 % at 1 Hz and 10 Hz ({coefficients}), which gives the structures {:.2} % and \
             {:.2} %; with 5 % in each the force of the second collision changes by {shift:+.1} % and the total from {:.1} to {:.1} \
             kN·s",
            ratios[0],
            ratios[1],
            momentum(used, 0),
            momentum(as_printed, 0)
        ),
        Finding::of(shift.abs() <= 0.1, true),
    ))
}

pub(super) fn restitution(runs: &Runs<'_>) -> Result<Outcome, StudyError> {
    let law = |study| -> Result<Option<ContactLaw>, StudyError> {
        let scene = runs.scene(study, "elastic")?.scene;
        Ok(scene.contacts.iter().flatten().next().map(|contact| contact.law))
    };
    let [asked, delivered] = [law("table-2")?, law("table-4")?].map(|law| law.and_then(|law| law.restitution()).unwrap_or(f64::NAN));
    Ok((
        format!("0.35 delivers {delivered:.4} to a free pair, exactly; asked {asked}"),
        Finding::of((delivered - asked).abs() <= 0.005, true),
    ))
}
