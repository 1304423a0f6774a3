//! Some scenes of the campaign of `cargo xtask verify`.

use std::path::Path;
use std::time::Duration;

use pounding_scene::{Method, Simulation};
use pounding_solver::State;
use pounding_studies::verify::{Campaign, Checked, Summary, Verdict};

fn campaign(seed: u64) -> Campaign {
    Campaign {
        studies: Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies"),
        seed,
        patience: Duration::from_secs(300),
    }
}

/// Runs scenes by their numbers on `n_threads` threads.
fn checked(scenes: &[usize], n_threads: usize) -> Vec<Checked> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(n_threads).build().expect("threads");
    pool.install(|| campaign(7).run(scenes, &|_| ()))
}

/// The scenes that agree among the first 31 of the seed; `cargo xtask verify` runs more. Three others end by a documented limit, and number 44 takes more pieces than its
/// budget. The rest are further apart than allowed, mostly by the second route's distance from itself.
const AGREE: [usize; 22] = [0, 1, 3, 5, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 27, 28, 30];

#[test]
fn reference_random_scenes_are_the_same_by_both_routes() {
    let checked = checked(&AGREE, 2);
    let summary = Summary(&checked);
    let apart = checked.iter().filter(|one| !matches!(one.verdict, Verdict::Agrees));
    let apart: Vec<String> = apart.flat_map(Checked::lines).collect();
    assert!(apart.is_empty(), "{}\n{summary}", apart.join("\n"));
    let touches: usize = checked.iter().map(|one| one.touches).sum();
    assert!(touches > 1000, "enough that touches\n{summary}");
}

/// Scenes, by seed and number, that found faults of the exact method:
///
/// - 3/4: the approach speed of a touch was 1e-5 off, 3e-13 s after another touch of its building.
/// - 1/54, 3/44, 3/50: a floor between two neighbours passed impacts on to one that was parting.
/// - 2/17: a drift turned again and again.
/// - 1/202: the ledger could not explain an energy over pieces of 1e-18 s.
/// - 1/225: equal Bouc–Wen columns at rest against each other made no progress.
/// - 1/354, 2/350: the force of displaced Bouc–Wen columns was 2.2e-8 of their yield force off at the start.
/// - 2/380: a floor between two neighbours bounced once more from the elastic one.
/// - 2/201: samples were up to 1e-15 s late, and a rest under a travelling motion had 2.4e-12 too little impulse.
/// - 1/1193, 1/1250: the force between two floors that friction holds was not followed to its end: 1.3e-9 and 1.6e-7 of an impulse were missing.
/// - 1/1215: Bouc–Wen columns under gravity soften before their drift turns, and the peak of the base shear was 4e-6 too small.
/// - 1/1581: columns that have yielded under gravity turn at their largest force and a small drift; it was 5e-5 too small.
/// - 1/1649: friction that holds a floor jumps when the floor above is hit; its peak was 1.6e-3 too small.
/// - 1/1474, 1/1657: a column and a link at their limits turned again and again, by the rounding of a rate after a rest.
///
/// Others found faults of the second route:
///
/// - 2/341, 2/392: a force that an impact lets press or push anew.
/// - 2/164: samples that arrive 1e-15 s late.
/// - 1/103, 1/172: gaps that drifted over travelling grounds, and floors at rest there that kept a velocity.
/// - 3/301: grounds under one motion that moved apart by 2e-16 m.
/// - 1/1175: a parting that only rounding announced, between floors that friction holds.
/// - 1/1310: a force whose rate jumps where a floor sticks.
fn agree(seed: u64, scenes: &[usize]) {
    let checked = campaign(seed).run(scenes, &|_| ());
    // 3/44 is 2.0e-12 off after 301 touches; its rounding is as large.
    let found = |one: &&Checked| !matches!(one.verdict, Verdict::Agrees | Verdict::ExactRounds);
    let apart: Vec<String> = checked.iter().filter(found).flat_map(Checked::lines).collect();
    assert!(apart.is_empty(), "seed {seed}: {apart:#?}");
}

#[test]
fn issue_scenes_of_seed_1_that_found_faults_agree() {
    agree(
        1,
        &[54, 103, 172, 202, 225, 354, 1175, 1193, 1215, 1250, 1310, 1474, 1581, 1649, 1657],
    );
}

#[test]
fn issue_scenes_of_seed_2_that_found_faults_agree() {
    agree(2, &[17, 18, 164, 201, 341, 350, 380, 392]);
}

#[test]
fn issue_scenes_of_seed_3_that_found_faults_agree() {
    agree(3, &[4, 44, 50, 301]);
}

/// Rows in which slabs hit columns, half of them under gravity: every third scene from number 1000 on.
#[test]
fn reference_slabs_against_columns_are_the_same_by_both_routes() {
    let checked = campaign(1).run(&[1002, 1005, 1011, 1014, 1017, 1020], &|_| ());
    let apart = checked.iter().filter(|one| !matches!(one.verdict, Verdict::Agrees));
    let apart: Vec<String> = apart.flat_map(Checked::lines).collect();
    assert!(apart.is_empty(), "{apart:#?}");
    let beside = |one: &Checked| campaign(1).scene(one.index).floors.is_none();
    assert!(checked.iter().all(beside));
}

#[test]
fn limit_a_campaign_does_not_depend_on_threads() {
    let lines = |n_threads| {
        let checked = checked(&[0, 1, 2, 3], n_threads);
        format!("{:?}\n{}", checked, Summary(&checked))
    };
    assert_eq!(lines(1), lines(2), "one thread and two");
}

#[test]
fn limit_no_force_of_a_history_is_larger_than_its_peak() {
    // The peak of a force that jumps at an impact was 22 % too low, as the run's own history showed.
    let campaign = campaign(7);
    let other = Method::Newmark {
        time_step_s: 0.002,
        beta: 0.25,
        gamma: 0.5,
    };
    let (mut n_runs, mut n_pushed) = (0, 0);
    for index in AGREE {
        let scene = campaign.scene(index);
        let exact = Simulation::new(&scene, campaign.studies.as_path()).expect("a scene");
        for scene in [exact.with_method(other), Ok(exact)].into_iter().flatten() {
            // A run whose ledger a stepping method breaks is refused, like most runs of impulsive towers at this step.
            let Ok(run) = scene.run(Some(0.002)) else {
                continue;
            };
            n_runs += 1;
            let histories = run.histories.as_ref().expect("they were asked for");
            for floor in 0..scene.floors().all().len() {
                let printed = run.peaks.of(floor);
                let states = &histories.of(floor).states;
                let largest = |of: fn(&State) -> f64| states.iter().map(|state| of(state).abs()).fold(0.0, f64::max);
                let pushed = largest(State::pounding_force);
                n_pushed += usize::from(pushed > 0.0);
                for (shown, peak) in [
                    (pushed, printed.pounding_force),
                    (largest(|state| state.displacement), printed.displacement),
                    (largest(|state| state.restoring_force), printed.restoring_force),
                ] {
                    let printed = peak.value.abs();
                    assert!(
                        shown <= printed * (1.0 + 1e-9),
                        "scene {index}, floor {floor}: {shown:e} is shown, {printed:e} printed"
                    );
                }
            }
        }
    }
    assert!(n_runs > 20 && n_pushed > 40, "{n_runs} runs, {n_pushed} floors that are pushed");
}

#[test]
fn limit_a_scene_is_its_file() {
    for index in 0..200 {
        let scene = campaign(7).scene(index);
        let text = serde_json::to_string(&scene).expect("a scene is written");
        let read = serde_json::from_str(&text).expect("what is written is a scene");
        assert_eq!(scene, read, "scene {index}");
    }
}

/// 3/33: after a pulse, floors at rest moved by rounding alone, and two pairs of a building touched in turn at one instant without end. The
/// rounding of the instant had overwritten the zero that an impact leaves.
#[test]
fn issue_floors_that_move_by_rounding_do_not_touch_for_ever() {
    let scene = campaign(3).scene(33);
    let scene = Simulation::new(&scene, &campaign(3).studies).expect("a scene");
    let outcome = scene.run(None).expect("it makes progress");
    assert!(outcome.work.events < 10_000, "{:?}", outcome.work);
}

/// Undecidable differences do not count as faults: 1/67 loses touches with the last digits of its data, and changes of its data by
/// 1e-15 move 2/197.
#[test]
fn limit_what_rounding_decides_is_no_disagreement() {
    let verdict = |seed, scene| campaign(seed).run(&[scene], &|_| ()).remove(0).verdict;
    let lost = verdict(1, 67);
    assert!(matches!(lost, Verdict::Unknowable), "{lost:?}");
    let rounds = verdict(2, 197);
    assert!(matches!(rounds, Verdict::ExactRounds), "{rounds:?}");
}
