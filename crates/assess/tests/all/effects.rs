//! Effects of pounding on storeys, compared with known values.

use std::path::Path;

use pounding_assess::{Alone, AssessedRun, Effects, Separation};
use pounding_scene::{RunResult, Scene, Simulation, Structure};

/// Two towers that touch: three storeys beside two, of the same height and other periods.
fn towers() -> Scene {
    let text = br#"
        name = "towers"
        duration_s = 6
        method = "exact"
        [record]
        file = "el-centro-1940-ns-chopra.csv"
        [[structures]]
        [structures.building]
        name = "slow"
        period_s = 0.6
        damping.ratio = 0.05
        storeys = [{ mass_kg = 2e5, height_m = 3.0, repeat = 3, yield_drift_ratio = 0.005 }]
        [[structures]]
        [structures.building]
        name = "quick"
        period_s = 0.25
        damping.ratio = 0.05
        storeys = [{ mass_kg = 2e5, height_m = 3.0, repeat = 2 }]
        [[contacts]]
        gap_m = 0.01
        law.stereomechanical.restitution = 0.6
    "#;
    Scene::parse(text, Path::new("towers.toml")).expect("a scene")
}

fn prepared(scene: &Scene) -> Simulation {
    let records = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/records");
    Simulation::new(scene, &records).expect("it can be modelled")
}

#[test]
fn reference_peaks_are_those_of_the_runs_with_and_without_neighbours() {
    let scene = towers();
    let pair = prepared(&scene);
    let effects = Effects::of(&pair).expect("it runs");
    let outcome = pair.run(None).expect("it runs");
    for (structure, one) in scene.structures.iter().enumerate() {
        let lone = Scene {
            structures: vec![one.clone()],
            contacts: None,
            ..scene.clone()
        };
        let alone = prepared(&lone).run(None).expect("it runs");
        for (storey, &floor) in pair.floors().of_structure(structure).iter().enumerate() {
            let found = &effects.as_given[floor];
            let (drift, shear) = (found.peak_drift_m.unwrap(), found.peak_shear_force_n.unwrap());
            let (beside, lonely) = (outcome.peaks.of(floor), alone.peaks.of(storey));
            let same = |found: f64, wanted: f64| {
                assert!((found - wanted.abs()).abs() <= 1e-12 * found, "{found} {wanted}");
            };
            same(drift.beside, beside.drift().value);
            same(drift.alone, lonely.drift().value);
            same(shear.beside, beside.restoring_force.value);
            same(shear.alone, lonely.restoring_force.value);
            same(drift.amplification.unwrap().value, drift.beside / drift.alone);
        }
    }
    let impulses: f64 = outcome.collisions.all().iter().map(|one| one.impulse).sum();
    let sides: f64 = effects.as_given.iter().map(|one| one.impulse_n_s.value).sum();
    assert!(impulses > 0.0, "they touch");
    assert!((sides - 2.0 * impulses).abs() < 1e-9 * sides, "{sides} {impulses}");
}

#[test]
fn reference_a_mirrored_row_swaps_the_directions() {
    let scene = towers();
    let mut mirrored = scene.clone();
    mirrored.structures.reverse();
    let (one, other) = (prepared(&scene), prepared(&mirrored));
    let (effects, mirror) = (Effects::of(&one).unwrap(), Effects::of(&other).unwrap());
    for structure in 0..2 {
        let floors = one.floors().of_structure(structure);
        for (&floor, &twin) in floors.iter().zip(other.floors().of_structure(1 - structure)) {
            assert_eq!(effects.as_given[floor], mirror.reversed[twin]);
        }
    }
}

/// "As given" was the direction of the scene in effects and that of the file everywhere else: of a reversed scene they were opposites.
#[test]
fn issue_as_given_is_the_direction_of_the_file() {
    let scene = towers();
    let mut reversed = scene.clone();
    reversed.record.reversed = true;
    let [found, of_reversed] = [scene, reversed].map(|scene| Effects::of(&prepared(&scene)).expect("it runs"));
    assert_eq!(found, of_reversed);
}

#[test]
fn limit_buildings_far_apart_are_not_changed_at_all() {
    let mut scene = towers();
    for contact in scene.contacts.iter_mut().flatten() {
        contact.gap_m = 5.0;
    }
    let effects = Effects::of(&prepared(&scene)).expect("it runs");
    for floor in effects.as_given.iter().chain(&effects.reversed) {
        for effect in floor.responses() {
            let effect = effect.expect("it is no wall");
            assert_eq!(effect.alone.to_bits(), effect.beside.to_bits());
            let ratio = effect.amplification.expect("it moves");
            assert_eq!((ratio.low.to_bits(), ratio.high.to_bits()), (1_f64.to_bits(), 1_f64.to_bits()));
            assert!(effect.alone > 0.0 && ratio.is_robust(), "{effect:?}");
        }
        assert_eq!(floor.collisions.high.to_bits(), 0);
        assert!(floor.impulse_n_s.is_robust(), "nothing stays nothing");
    }
}

#[test]
fn limit_a_wall_has_hits_alone() {
    let mut scene = towers();
    scene.structures[1] = Structure::Wall;
    let prepared = prepared(&scene);
    let effects = Effects::of(&prepared).expect("it runs");
    let walls: Vec<_> = (0..).zip(prepared.walls()).filter(|(_, wall)| *wall).collect();
    assert_eq!(walls.len(), 3);
    for (floor, _) in walls {
        assert_eq!(effects.as_given[floor].responses(), [None; 3]);
    }
    let of_walls = prepared.walls().into_iter().zip(&effects.as_given);
    let hits = of_walls.filter(|(wall, _)| *wall).map(|(_, one)| one.collisions.value);
    assert!(hits.sum::<f64>() > 0.0, "it is hit");
}

#[test]
fn reference_a_row_for_every_number() {
    let prepared = prepared(&towers());
    let effects = Effects::of(&prepared).expect("it runs");
    let csv = effects.to_csv(prepared.scene(), prepared.floors());
    let lines: Vec<_> = csv.lines().collect();
    // Five floors in two directions. Each has three rows of collisions, and rows alone, beside and ratio for three responses.
    assert_eq!(lines.len(), 1 + 5 * 2 * (3 + 9));
    assert!(lines.iter().all(|line| line.split(',').count() == 9), "{csv}");
    assert!(lines[1].starts_with("slow,1,as_given,collisions,"), "{csv}");
    let last = lines[lines.len() - 1];
    assert!(last.starts_with("quick,2,reversed,acceleration_amplification,"), "{csv}");
    let drift = effects.as_given[0].peak_drift_m.expect("it moves").beside;
    assert!(csv.contains(&format!("slow,1,as_given,peak_drift_m,{drift},,,,\n")), "{csv}");
}

#[test]
fn reference_ranges_are_those_of_changed_records() {
    let scene = towers();
    let effects = Effects::of(&prepared(&scene)).expect("it runs");
    let mut peaks = Vec::new();
    for scale in [1.0, 0.99, 1.01] {
        let mut scaled = scene.clone();
        scaled.record.scale *= scale;
        let outcome = prepared(&scaled).run(None).expect("it runs");
        let mut apart = scaled.clone();
        apart.contacts = None;
        let alone = prepared(&apart).run(None).expect("it runs");
        let of = |one: &RunResult, floor: usize| one.accelerations[floor].value.abs();
        let ratio = |floor: usize| of(&outcome, floor) / of(&alone, floor);
        peaks.push((0..5).map(ratio).collect::<Vec<f64>>());
    }
    let mut moved = false;
    for (floor, found) in effects.as_given.iter().enumerate() {
        let known = found.peak_acceleration_m_per_s2.expect("it moves").amplification.expect("it moves");
        assert!((known.value - peaks[0][floor]).abs() < 1e-9, "{known:?}");
        for changed in &peaks {
            let inside = known.low - 1e-9 <= changed[floor] && changed[floor] <= known.high + 1e-9;
            assert!(inside, "{floor}: {} {known:?}", changed[floor]);
        }
        assert!(known.error < 1e-6, "{known:?}");
        moved |= !known.is_robust();
    }
    assert!(moved, "one per cent moves some of them by more than five");
}

/// A slower record was cut at the duration of the scene, so that the response at its end was missing.
#[test]
fn issue_a_slower_record_runs_to_its_end() {
    // The ground begins to move 0.1 s before the end, and the gap closes 0.07 to 0.08 s later: beyond three seconds in the slower record.
    let sample = |index: usize| if index < 290 { 0.0 } else { 8.0 };
    let rows = (0..=300).map(|index| format!("{},{}\n", index as f64 * 0.01, sample(index)));
    let rows: String = rows.collect();
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("late.csv");
    std::fs::write(&path, format!("time_s,acceleration_m_per_s2\n{rows}")).expect("a file");
    let text = r#"
        name = "late"
        duration_s = 3
        record.file = "late.csv"
        structures = [
          { sdof = { name = "slow", mass_kg = 2e5, period_s = 0.6, damping.ratio = 0.05 } },
          { sdof = { name = "quick", mass_kg = 2e5, period_s = 0.25, damping.ratio = 0.05 } },
        ]
        contacts = [{ gap_m = 0.005, law.stereomechanical.restitution = 0.6 }]
    "#;
    let scene = Scene::parse(text.as_bytes(), Path::new("late.toml")).expect("a scene");
    let pair = Simulation::new(&scene, path.parent().expect("a folder")).expect("a good scene");
    let effects = Effects::of(&pair).expect("it runs");
    let both = [&effects.as_given[0], &effects.reversed[0]];
    let hit = both.iter().find(|one| one.collisions.value > 0.0);
    let collisions = hit.expect("they meet in one direction").collisions;
    assert!(collisions.low > 0.0, "whatever the record's speed: {collisions:?}");
}

/// The run alone in one direction gives the answer of the other direction to the last bit, even if columns yield. A row that does not begin
/// at rest, or that yields smoothly, is run again.
#[test]
fn limit_a_run_alone_serves_both_directions() {
    let push = |scene: &mut Scene| {
        let Structure::Building(building) = &mut scene.structures[0] else {
            unreachable!("it is one");
        };
        building.storeys[0].initial_displacement_m = 0.01;
    };
    let mut moved = towers();
    push(&mut moved);
    for scene in [towers(), moved] {
        let direction = |reversed: bool| {
            let mut scene = scene.clone();
            scene.record.reversed = reversed;
            prepared(&scene)
        };
        for first in [false, true] {
            let alone = Alone::of(&direction(first)).expect("it runs");
            let other = direction(!first);
            let run = |known| AssessedRun::of(&other, known, AssessedRun::STIFFNESS_FACTORS).expect("it runs");
            assert_eq!(run(Some(&alone)), run(None), "{first}");
        }
    }
}

/// A damper between the buildings changes how floors come closer, but not what they would do alone.
#[test]
fn limit_alone_is_without_links_and_required_gaps_are_with_them() {
    let linked = |gap: f64| {
        let mut scene = towers();
        let links = r#"[{ "between": [{ "structure": "slow", "floor": 2 }, { "structure": "quick" }], "law": { "dashpot": { "damping_n_s_per_m": 2e6 } } }]"#;
        scene.links = serde_json::from_str(links).expect("links");
        scene.contacts.as_mut().expect("a contact")[0].gap_m = gap;
        prepared(&scene)
    };
    let unlinked = prepared(&towers());
    let [with, without] = [&linked(0.01), &unlinked].map(|row| Effects::of(row).expect("it runs"));
    for (with, without) in with.as_given.iter().zip(&without.as_given) {
        let [with, without] = [with, without].map(|floor| floor.peak_drift_m.expect("a drift"));
        assert!((with.alone / without.alone - 1.0).abs() < 1e-12, "{with:?} {without:?}");
        assert!((with.beside / without.beside - 1.0).abs() > 1e-2, "{with:?} {without:?}");
    }
    let required = |row: &Simulation| Separation::of(row).expect("it runs")[0].required;
    let gap = required(&linked(0.01));
    assert!((gap / required(&unlinked) - 1.0).abs() > 0.1, "{gap}");
    // The linked row touches at any smaller gap, and at no larger one.
    for (factor, touches) in [(1.0 - 1e-9, true), (1.0 + 1e-9, false)] {
        let run = linked(factor * gap).run(None).expect("it runs");
        assert_eq!(run.collisions.all().is_empty(), !touches, "{factor}");
    }
}
