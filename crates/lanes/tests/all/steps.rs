//! Scenes in lanes: every lane gives exactly the bits of its scene alone.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_lanes::{Excitations, PairSums, RowsOf, SceneSums, SideBySide};
use pounding_solver::{
    Bilinear, CentralDifference, Clock, Closings, Collisions, Elastic, Excitation, Hysteretic, Integrator, Ledger, Node, Pair, Peaks, Row,
    RunError,
};
use proptest::prelude::*;

use crate::random_rows::{Case, SI, any_law, cases, config};
use crate::storeys::linked;
use crate::watch::Watch;

/// More scenes than advance together; the last group is partly full or absent, for groups of two, four or eight lanes.
pub(crate) const SCENES: [usize; 2] = [13, 19];

pub(crate) const CLOCK: Clock = Clock {
    time_step: 0.005,
    n_steps: 300,
};

pub(crate) const SETTINGS: CentralDifference = CentralDifference { contact_substeps: 1 };

/// A scene that no step of the clock can resolve must not disturb the others. If it moves equally far to both sides, it is left to a run
/// alone.
pub(crate) const BEYOND_THE_CLOCK: usize = 5;

/// A law of this kind with other parameters.
pub(crate) fn stiffer(law: ContactLaw, factor: f64) -> ContactLaw {
    if let ContactLaw::Stereomechanical(mut law) = law {
        law.restitution /= factor;
        return ContactLaw::Stereomechanical(law);
    }
    law.stiffened(factor)
}

/// The row with other numbers.
fn varied(case: &Case, scene: usize) -> Case {
    let factor = 1.0 + 0.05 * f64::from(u32::try_from(scene).expect("few"));
    let mut case = case.clone();
    for (index, [mass, period, ratio, yields]) in case.structures.iter_mut().enumerate() {
        *mass *= factor;
        *ratio /= factor;
        *yields *= factor;
        *period *= if index % 2 == 0 { factor } else { 1.0 };
    }
    for velocity in &mut case.velocities {
        *velocity *= 2.0 - factor;
    }
    for (gap, law) in &mut case.contacts {
        *gap *= 2.0 - factor;
        *law = stiffer(*law, factor);
    }
    if scene == BEYOND_THE_CLOCK {
        case.structures[0][1] = 1e-3;
    }
    case
}

/// Number of steps of a scene; it differs between scenes.
fn steps(scene: usize) -> usize {
    CLOCK.n_steps - 7 * (scene % 3)
}

/// Displacements and drifts, pairs of a scene alone, and whether its ledger refuses it.
type Alone = Result<(Vec<[f64; 2]>, Vec<PairSums>, bool), RunError>;

fn alone<Column: Hysteretic>(n_steps: usize, row: &Row<Column>, excitation: Excitation<'_>) -> Alone {
    let (n, pairs) = (row.nodes().len(), row.pairs());
    let walls = row.nodes().iter().map(Node::is_wall).collect();
    let mut recorder = (
        (Peaks::new(n), Collisions::new(n, pairs)),
        Closings::new(walls, 1.0),
        Ledger::new(row, excitation),
    );
    Integrator::CentralDifference(SETTINGS).watch(row, excitation, Clock { n_steps, ..CLOCK }, &mut recorder)?;
    let ((peaks, collisions), closings, ledger) = recorder;
    let mut tallies = vec![PairSums::default(); pairs.len()];
    for one in collisions.all() {
        let tally = &mut tallies[one.pair];
        tally.collisions += 1.0;
        tally.impulse += one.impulse;
        tally.largest_impulse = tally.largest_impulse.max(one.impulse);
        tally.peak_force = tally.peak_force.max(one.peak_force.unwrap_or(0.0));
    }
    // Lanes record the closings of chains.
    for (tally, pair) in tallies.iter_mut().zip(pairs).filter(|_| row.is_chain()) {
        tally.closing = closings.of(pair.left()).map(|closing| closing.distance);
    }
    let floor = |node| {
        let peaks = peaks.of(node);
        [peaks.displacement, peaks.drift()].map(|peak| peak.value)
    };
    let floors = (0..n).map(floor).collect();
    Ok((floors, tallies, ledger.verdict().is_err()))
}

pub(crate) fn all<Column>(rows: &[Row<Column>]) -> Vec<&Row<Column>> {
    rows.iter().collect()
}

/// Gives rows the name of their columns.
pub(crate) type OfKind<'a, Column> = fn(&'a [&'a Row<Column>]) -> RowsOf<'a>;

/// Ground accelerations for each of n scenes: larger or smaller, with different lengths.
pub(crate) fn own_grounds(ground: &[f64], n: usize) -> Vec<Vec<f64>> {
    let own = |scene: usize| {
        let factor = 0.5 + 0.1 * f64::from(u32::try_from(scene).expect("few"));
        let samples = ground[..ground.len() - ground.len() * (scene % 4) / 8].iter();
        samples.map(|acceleration| factor * acceleration).collect()
    };
    (0..n).map(own).collect()
}

/// Compares every scene of some rows with itself alone: under a common ground motion, and each under a separate motion.
pub(crate) fn compare<'a, Column: Hysteretic>(
    (rows, kind): (&'a [&'a Row<Column>], OfKind<'a, Column>),
    ground: &[f64],
) -> Result<(), TestCaseError> {
    let excitation = |ground| Excitation::new(0.01, ground).expect("the record is finite");
    let common = vec![excitation(ground); rows.len()];
    compare_under((rows, kind), &common)?;
    let own = own_grounds(ground, rows.len());
    let mut own: Vec<_> = own.iter().map(|ground| excitation(ground)).collect();
    // Samples of a single motion are farther apart.
    own[1] = Excitation::new(0.0125, own[1].samples()).expect("the record is finite");
    compare_under((rows, kind), &own)
}

fn bits_of_pair(sums: &PairSums) -> ([u64; 4], Option<u64>) {
    let PairSums {
        collisions,
        impulse,
        largest_impulse,
        peak_force,
        closing,
    } = *sums;
    let numbers = [collisions, impulse, largest_impulse, peak_force];
    (numbers.map(f64::to_bits), closing.map(f64::to_bits))
}

/// Whether sums equal those of a run without closings.
fn are_the_same<Column: Hysteretic>(full: &SceneSums, lean: &SceneSums, row: &Row<Column>) -> bool {
    let floor =
        |sums: &SceneSums, scene: usize, floor: usize| [sums.displacement(scene, floor), sums.drift(scene, floor)].map(f64::to_bits);
    let pair = |sums: &SceneSums, scene: usize, pair: usize| {
        bits_of_pair(&PairSums {
            closing: None,
            ..sums.pair(scene, pair)
        })
    };
    let steps = |sums: &SceneSums| [sums.steps, sums.touching_steps];
    let scenes = (0..full.len()).all(|scene| {
        let (mut floors, mut pairs) = (0..row.nodes().len(), 0..row.pairs().len());
        full.is_told(scene) == lean.is_told(scene)
            && floors.all(|index| floor(full, scene, index) == floor(lean, scene, index))
            && pairs.all(|index| pair(full, scene, index) == pair(lean, scene, index))
    });
    scenes && steps(full) == steps(lean)
}

fn compare_under<'a, Column: Hysteretic>(
    (rows, kind): (&'a [&'a Row<Column>], OfKind<'a, Column>),
    shaken: &[Excitation<'_>],
) -> Result<(), TestCaseError> {
    let together = SideBySide::new(SETTINGS, Excitations::of(shaken), CLOCK);
    let together = together.expect("the settings are valid");
    let n_steps: Vec<_> = (0..rows.len()).map(steps).collect();
    let sums = |closings: bool| {
        let mut found = SceneSums::default();
        let together = together.clone().with_closings(closings);
        let takes = together.run(kind(rows), &n_steps, &mut found);
        takes.then_some(found).expect("the rows are of one shape")
    };
    let found = sums(rows[0].is_chain());
    prop_assert!(are_the_same(&found, &sums(false), rows[0]), "lean is full");
    prop_assert_eq!(found.len(), rows.len());
    for (scene, (row, excitation)) in rows.iter().zip(shaken).enumerate() {
        let Ok((floors, pairs, is_refused)) = alone(steps(scene), row, *excitation) else {
            prop_assert!(!found.is_told(scene), "{} must diverge too", scene);
            continue;
        };
        // Displacements beyond all bounds are left to runs alone.
        let far = floors.iter().flatten().any(|peak| peak.abs() >= 1e3);
        // Rest after an impact with e = 0 is left to runs alone.
        let may_rest = pairs.iter().zip(row.pairs()).any(|(tally, pair)| {
            let law = pair.law.impulsive();
            tally.collisions > 0.0 && law.is_some_and(|law| law.restitution == 0.0)
        });
        if far {
            prop_assert!(!found.is_told(scene), "{} is left to a run alone", scene);
            continue;
        }
        if (may_rest || scene == BEYOND_THE_CLOCK) && !found.is_told(scene) {
            continue;
        }
        prop_assert!(found.is_told(scene), "{} must not diverge", scene);
        if is_refused {
            prop_assert!(found.is_doubted(scene), "{} breaks a law unseen", scene);
        }
        for (floor, wanted) in floors.iter().enumerate() {
            let lane = [found.displacement(scene, floor), found.drift(scene, floor)];
            let bits = |peaks: [f64; 2]| peaks.map(f64::to_bits);
            prop_assert_eq!(bits(lane), bits(*wanted), "{} {}", scene, floor);
        }
        for (pair, wanted) in pairs.iter().enumerate() {
            let lane = found.pair(scene, pair);
            prop_assert_eq!(
                bits_of_pair(&lane),
                bits_of_pair(wanted),
                "{} {}: {:?} {:?}",
                scene,
                pair,
                lane,
                wanted
            );
        }
    }
    Ok(())
}

/// Compares `count` scenes like this one, with every kind of columns.
pub(crate) fn compare_columns(case: &Case, count: usize) -> Result<(), TestCaseError> {
    let scenes: Vec<_> = (0..count).map(|scene| varied(case, scene)).collect();
    let row = |(scene, case): (usize, &Case)| displaced(&case.row(SI), scene);
    let rows: Vec<_> = scenes.iter().enumerate().map(row).collect();
    compare((&all(&rows), RowsOf::Bilinear), &case.ground)?;
    let column = |node: &Node<Bilinear>| Bilinear {
        stiffness: node.column.stiffness,
        yield_force: node.column.yield_force,
        hardening: 0.1,
    };
    let bilinear: Vec<_> = rows.iter().map(|row| with_columns(row, column)).collect();
    compare((&all(&bilinear), RowsOf::Bilinear), &case.ground)?;
    // Gravity takes more than these columns gain after yielding.
    let column = |node: &Node<Bilinear>| Bilinear {
        stiffness: node.column.stiffness,
        yield_force: node.column.yield_force,
        hardening: -0.08,
    };
    let leaning: Vec<_> = rows.iter().map(|row| with_columns(row, column)).collect();
    compare((&all(&leaning), RowsOf::Bilinear), &case.ground)?;
    let column = |node: &Node<Bilinear>| Elastic {
        stiffness: node.column.stiffness,
    };
    let elastic: Vec<_> = rows.iter().map(|row| with_columns(row, column)).collect();
    compare((&all(&elastic), RowsOf::Elastic), &case.ground)?;
    // In other scenes another structure is a wall; the middle one never is.
    if elastic[0].nodes().len() < 3 {
        return Ok(());
    }
    let linked: Vec<_> = elastic.iter().enumerate().map(|(scene, row)| linked(row, scene)).collect();
    compare((&all(&linked), RowsOf::Elastic), &case.ground)
}

proptest! {
    #![proptest_config(config(300))]

    #[test]
    fn limit_a_lane_gives_the_bits_of_its_scene_alone(
        case in cases(any_law),
        count in prop::sample::select(SCENES.to_vec()),
    ) {
        compare_columns(&case, count)?;
    }
}

/// The row; in every third scene all structures begin displaced, with unchanged gaps.
fn displaced(row: &Row<Bilinear>, scene: usize) -> Row<Bilinear> {
    let initial_displacement = if scene % 3 == 1 { 0.03 } else { 0.0 };
    let node = |node: &Node<Bilinear>| Node {
        initial_displacement,
        ..*node
    };
    let nodes = row.nodes().iter().map(node).collect();
    Row::new(nodes, row.pairs().to_vec()).expect("the row is valid")
}

/// The row with other columns. Its last structure becomes a wall if it is at rest and not alone, else the first structure under this
/// condition.
fn with_columns<Column: Hysteretic>(row: &Row<Bilinear>, column: impl Fn(&Node<Bilinear>) -> Column) -> Row<Column> {
    let last = row.nodes().len() - 1;
    let rests = |index: &usize| {
        let node = &row.nodes()[*index];
        last > 0 && node.initial_velocity == 0.0 && node.initial_displacement == 0.0
    };
    let wall = [last, 0].into_iter().find(rests);
    let node = |(index, node): (usize, &Node<Bilinear>)| {
        let column = column(node);
        if wall == Some(index) {
            return Node::wall(column);
        }
        Node {
            initial_velocity: node.initial_velocity,
            initial_displacement: node.initial_displacement,
            ..Node::structure(1.0 / node.inverse_mass, node.damping, column)
        }
    };
    let nodes = row.nodes().iter().enumerate().map(node).collect();
    Row::new(nodes, row.pairs().to_vec()).expect("the row is valid")
}

/// The method on ground at rest.
fn side_by_side(settings: CentralDifference, clock: Clock) -> Result<SideBySide<'static>, RunError> {
    let excitation = Excitation::new(1.0, &[0.0]).expect("valid");
    SideBySide::new(settings, excitation, clock)
}

fn pair_of(restitution: f64) -> Row<Elastic> {
    let node = |stiffness: f64| Node::structure(1e5, 1e4, Elastic { stiffness });
    let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
    let pair = Pair::of_floors(0, 1, 0.01, law);
    Row::new(vec![node(1e6), node(4e6)], vec![pair]).expect("the row is valid")
}

#[test]
fn limit_rows_of_other_shapes_are_not_taken() {
    let together = side_by_side(SETTINGS, CLOCK).expect("valid");
    let mut found = SceneSums::default();
    let one = pair_of(0.5);
    let apart = Row::new(one.nodes().to_vec(), vec![]).expect("valid");
    assert!(
        !together.run(RowsOf::Elastic(&[&one, &apart]), &[9, 9], &mut found),
        "another number of pairs"
    );
    let late = one.clone().delayed(vec![0.0, 0.1]).expect("valid");
    assert!(!together.run(RowsOf::Elastic(&[&late]), &[9], &mut found), "a motion that travels");
    assert!(!together.run(RowsOf::Elastic(&[]), &[], &mut found), "no row");
    let too_long = CLOCK.n_steps + 1;
    assert!(
        !together.run(RowsOf::Elastic(&[&one]), &[too_long], &mut found),
        "more steps than the clock has"
    );
    assert!(found.is_empty(), "nothing has run");
    assert!(together.run(RowsOf::Elastic(&[&one]), &[9], &mut found), "a row of one shape");
    let empty = Row::new(vec![], vec![]).expect("valid");
    assert!(together.run(RowsOf::Elastic(&[&empty]), &[9], &mut found), "nothing moves");
    let settings = CentralDifference { contact_substeps: 2 };
    let refused = side_by_side(settings, CLOCK);
    insta::assert_snapshot!(refused.expect_err("sub-steps run alone"), @"contact_substeps: found 2, allowed 1 side by side; scenes with more run alone");
}

/// Equally far to the left and to the right: a run alone keeps the first peak, and lanes do not know which was first.
#[test]
fn issue_a_peak_to_both_sides_is_left_to_a_run_alone() {
    // Ω Δt = √2: u = −2⁻⁷, 0, 2⁻⁷ without rounding.
    let column = Elastic {
        stiffness: 4_294_967_296.0,
    };
    let node = Node {
        initial_displacement: -1.0 / 128.0,
        ..Node::structure(131_072.0, 0.0, column)
    };
    let row = Row::new(vec![node], vec![]).expect("valid");
    let clock = Clock {
        time_step: 1.0 / 128.0,
        n_steps: 2,
    };
    let together = side_by_side(SETTINGS, clock).expect("valid");
    let mut found = SceneSums::default();
    assert!(together.run(RowsOf::Elastic(&[&row, &row]), &[1, 2], &mut found), "one shape");
    assert!(found.is_told(0), "it has not come back yet");
    assert!(!found.is_told(1), "both sides: {}", found.displacement(1, 0));
}

#[test]
fn limit_no_lane_looks_at_contact_while_none_touches() {
    let together = side_by_side(SETTINGS, CLOCK).expect("valid");
    let mut found = SceneSums::default();
    // The first structure moves to the right until it meets the second.
    let with_gap = |gap: f64| {
        let row = pair_of(0.5);
        let mut nodes = row.nodes().to_vec();
        nodes[0].initial_velocity = 0.1;
        let Pair { law, .. } = row.pairs()[0];
        let pair = Pair::of_floors(0, 1, gap, law);
        Row::new(nodes, vec![pair]).expect("valid")
    };
    for (gaps, touching) in [(&[1.0][..], false), (&[1.0, 0.01], true)] {
        let rows: Vec<_> = gaps.iter().map(|gap| with_gap(*gap)).collect();
        let rows: Vec<_> = rows.iter().collect();
        let n_steps = vec![CLOCK.n_steps; rows.len()];
        let ran = together.run(RowsOf::Elastic(&rows), &n_steps, &mut found);
        assert!(ran, "rows of one shape");
        let share = found.touching_steps as f64 / found.steps as f64;
        assert_eq!(share > 0.0, touching, "{gaps:?}: {share}");
        assert!(share < 0.1, "they part again: {share}");
    }
}
