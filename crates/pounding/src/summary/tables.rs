//! The tables of a run: structures, what is left of their motion, storeys, pairs.

use pounding::scene::{Contact, Floor, FloorQuantity, Floors, PairOutcome, PairQuantity, RunErrors, RunResult, Scene, Simulation};
use pounding::solver::Collision;
use pounding::text::{digits, instant};

use crate::text::{NONE, milliseconds, paragraph, percent, short, table};

/// Peaks of every floor and wall.
pub(super) fn structures(prepared: &Simulation, outcome: &RunResult, errors: Option<&RunErrors>) -> String {
    let header = [
        ["Structure", "", ""],
        ["Period", "[s]", ""],
        ["Damping", "ratio", ""],
        ["Peak", "displ.", "[mm]"],
        ["at", "[s]", ""],
        ["Peak", "shear", "[kN]"],
        ["Ductility", "", ""],
        ["Transf.", "momentum", "[kN·s]"],
    ];
    let floors = prepared.floors();
    let rows = floors.by_structure().flat_map(|index| {
        let floor = &floors.all()[index];
        let errors = errors.map(|errors| structure_errors(errors, index, floor));
        let row = structure_row(prepared.scene(), floor, index, outcome);
        std::iter::once(row).chain(errors)
    });
    table(&header, &rows.collect::<Vec<_>>())
}

/// What is left of the motion at the end, and what stands on the floors felt of it; nothing of walls.
pub(super) fn motions(prepared: &Simulation, outcome: &RunResult, errors: Option<&RunErrors>) -> String {
    let header = [
        ["Structure", "", ""],
        ["Residual", "at end", "[mm]"],
        ["Peak abs.", "accel.", "[g]"],
        ["at", "[s]", ""],
    ];
    let gravity = prepared.scene().record.gravity_m_per_s2;
    let floors = prepared.floors();
    let floor = |index: usize| (index, &floors.all()[index]);
    let moving = floors.by_structure().map(floor);
    let moving = moving.filter(|(_, floor)| !floor.is_wall());
    let rows = moving.flat_map(|(index, floor)| {
        let peak = outcome.accelerations[index];
        let row = vec![
            floor.name.clone(),
            short(1e3 * outcome.last.of(index).displacement),
            short(peak.value / gravity),
            instant(peak.time),
        ];
        let error = |errors: &RunErrors| {
            let error = |quantity: FloorQuantity| errors.at(quantity, index).map_or(String::new(), percent);
            vec![
                ERROR.into(),
                error(FloorQuantity::ResidualDisplacementAtEndM),
                error(FloorQuantity::PeakAccelerationMPerS2),
                String::new(),
            ]
        };
        std::iter::once(row).chain(errors.map(error))
    });
    let rows: Vec<_> = rows.collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header, &rows)
}

/// Drifts of the storeys of buildings, from the ground up; nothing where every structure has one storey.
pub(super) fn storeys(floors: &Floors, outcome: &RunResult, errors: Option<&RunErrors>) -> String {
    let header = [
        ["Storey", ""],
        ["Peak", "drift [mm]"],
        ["at", "[s]"],
        ["Residual", "[mm]"],
        ["Drift", "ratio"],
        ["Shear", "[kN]"],
        ["Ductility", ""],
    ];
    let row = |index: usize| {
        let floor = &floors.all()[index];
        floor.storey?;
        let peaks = outcome.peaks.of(index);
        let drift = peaks.drift();
        let below = floors.below(index).map_or(0.0, |below| outcome.last.of(below).displacement);
        let number = |value: Option<f64>| value.map_or_else(|| NONE.into(), short);
        let row = vec![
            floor.name.clone(),
            short(1e3 * drift.value),
            instant(drift.time),
            short(1e3 * (outcome.last.of(index).displacement - below)),
            floor.drift_ratio(drift.value).map_or(NONE.into(), percent),
            short(1e-3 * peaks.restoring_force.value),
            number(floor.ductility(drift.value)),
        ];
        let errors = errors.map(|errors| drift_errors(errors, index, floor));
        Some(std::iter::once(row).chain(errors))
    };
    let rows: Vec<_> = floors.by_structure().filter_map(row).flatten().collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&header, &rows)
}

/// The errors of a storey, for the line below it.
fn drift_errors(errors: &RunErrors, index: usize, floor: &Floor) -> Vec<String> {
    let error = |quantity: FloorQuantity| errors.at(quantity, index).map_or(String::new(), percent);
    // On the ground the drift is the displacement.
    let (peak, last) = if floor.is_upper() {
        (FloorQuantity::PeakDriftM, FloorQuantity::ResidualDriftAtEndM)
    } else {
        (FloorQuantity::PeakDisplacementM, FloorQuantity::ResidualDisplacementAtEndM)
    };
    let drift = |printed: bool| if printed { error(peak) } else { String::new() };
    vec![
        ERROR.into(),
        drift(true),
        String::new(),
        error(last),
        drift(floor.made_of.is_some_and(|made| made.height_m.is_some())),
        error(FloorQuantity::PeakShearForceN),
        drift(floor.can_yield()),
    ]
}

fn structure_row(scene: &Scene, floor: &Floor, index: usize, outcome: &RunResult) -> Vec<String> {
    let momentum = short(outcome.momentum.of(index) / 1e3);
    let Some((period, damping_ratio)) = floor.oscillation(scene) else {
        let mut row = vec![floor.name.clone()];
        row.resize(7, NONE.into());
        row.push(momentum);
        return row;
    };
    let peaks = outcome.peaks.of(index);
    vec![
        floor.name.clone(),
        short(period),
        short(damping_ratio),
        short(peaks.displacement.value * 1e3),
        instant(peaks.displacement.time),
        short(peaks.restoring_force.value / 1e3),
        floor.ductility(peaks.drift().value).map_or_else(|| NONE.into(), short),
        momentum,
    ]
}

/// The errors of a structure, for the line below it.
fn structure_errors(errors: &RunErrors, index: usize, floor: &Floor) -> Vec<String> {
    let error = |quantity: FloorQuantity| errors.at(quantity, index).map_or(String::new(), percent);
    let time = errors.at(FloorQuantity::PeakDisplacementTimeS, index);
    vec![
        ERROR.into(),
        String::new(),
        String::new(),
        error(FloorQuantity::PeakDisplacementM),
        time.map_or(String::new(), milliseconds),
        error(FloorQuantity::PeakShearForceN),
        // A ductility is a peak drift over a given one.
        if floor.can_yield() {
            let drift = errors.at(FloorQuantity::PeakDriftM, index);
            drift.map_or_else(|| error(FloorQuantity::PeakDisplacementM), percent)
        } else {
            String::new()
        },
        error(FloorQuantity::TransferredMomentumNS),
    ]
}

/// Begins a line of errors.
const ERROR: &str = "  error";

/// Collisions of every pair.
pub(super) fn pairs(prepared: &Simulation, outcome: &RunResult, errors: Option<&RunErrors>) -> String {
    let (floors, scene) = (prepared.floors(), prepared.scene());
    if floors.facing().is_empty() {
        return paragraph("Pairs", "none: no contact is modelled");
    }
    let contacts: Vec<&Contact> = scene.contacts.iter().flatten().collect();
    let header = [
        ["Pair", "", ""],
        ["Gap", "[mm]", ""],
        ["Colli-", "sions", ""],
        ["First", "[s]", ""],
        ["First", "impulse", "[kN·s]"],
        ["Largest", "impulse", "[kN·s]"],
        ["Peak", "force", "[kN]"],
        ["at", "[s]", ""],
    ];
    let rows = floors.pairs_by_contact().into_iter().flat_map(|index| {
        let [left, right] = floors.names(index);
        let gap = contacts[floors.facing()[index].contact].gap_m;
        let mut row = vec![format!("{left} – {right}"), digits(gap * 1e3)];
        row.extend(pair_numbers(&outcome.of_pair(index)));
        let errors = errors.map(|errors| pair_errors(errors, index));
        std::iter::once(row).chain(errors)
    });
    let table = table(&header, &rows.collect::<Vec<_>>());
    let leaning = leaning(floors, outcome);
    if leaning.is_empty() {
        return table;
    }
    format!("{table}\n{leaning}")
}

/// Pairs that lean on each other; nothing where none does.
pub(super) fn leaning(floors: &Floors, outcome: &RunResult) -> String {
    let said = |pair: usize| {
        let one = outcome.of_pair(pair).leaning()?;
        let [left, right] = floors.names(pair);
        Some(format!(
            "{left} – {right} for {} s from {} s on",
            short(one.end - one.start),
            instant(one.start)
        ))
    };
    let pairs = floors.pairs_by_contact().into_iter();
    let said: Vec<String> = pairs.filter_map(said).collect();
    if said.is_empty() {
        return String::new();
    }
    paragraph(
        "Leaning",
        &format!(
            "touches of more than 0.25 s are pushes, and their impulses no measure of a blow: {}",
            said.join("; ")
        ),
    )
}

/// Collisions of a pair: number, time and impulse of the first, largest impulse, and force with its time.
fn pair_numbers(pair: &PairOutcome) -> [String; 6] {
    let impulse = |one: Option<Collision>| one.map_or(NONE.into(), |one| short(one.impulse / 1e3));
    [
        pair.collisions.to_string(),
        pair.first.map_or(NONE.into(), |first| digits(first.start)),
        impulse(pair.first),
        impulse(pair.largest),
        match pair.peak_force {
            None if pair.collisions == 0 => NONE.into(),
            None => "impulsive".into(),
            Some(force) => short(force.value / 1e3),
        },
        pair.peak_force.map_or(NONE.into(), |force| instant(force.time)),
    ]
}

/// The errors of a pair, for the line below it.
fn pair_errors(errors: &RunErrors, pair: usize) -> Vec<String> {
    let error = |quantity: PairQuantity| errors.at(quantity, pair).map_or(String::new(), percent);
    let of_pair = &errors.pairs()[pair];
    vec![
        ERROR.into(),
        String::new(),
        if of_pair.rests {
            "rests".into()
        } else if of_pair.differ() {
            format!("exact {}", of_pair.collisions[1])
        } else {
            "equal".into()
        },
        of_pair.first_start_s.map_or(String::new(), milliseconds),
        error(PairQuantity::FirstImpulseNS),
        error(PairQuantity::LargestImpulseNS),
        error(PairQuantity::PeakForceN),
        String::new(),
    ]
}
