//! The velocity Verlet method side by side: every lane gives the bits of its scene alone.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Elastic, Excitation, Node, Row, RowsOf, SceneSums, SideBySide, Verlet, VerletImpacts,
};
use proptest::prelude::*;

use crate::lanes::{CLOCK, SCENES, all, compare, compare_columns};
use crate::random_rows::{Case, any_law, cases, config};

/// Two structures of a row.
fn shortened(mut case: Case) -> Case {
    case.structures.truncate(2);
    case.velocities.truncate(2);
    case.contacts.truncate(1);
    case
}

fn two() -> impl Strategy<Value = Case> {
    let impulsive = || {
        let law = (0.05..1.0_f64)
            .prop_map(|restitution| ContactLaw::Stereomechanical(Stereomechanical { restitution }));
        law.boxed()
    };
    let all = prop_oneof![cases(any_law), cases(impulsive)];
    let long = all.prop_filter("two structures", |case| case.structures.len() > 1);
    long.prop_map(shortened)
}

proptest! {
    #![proptest_config(config(400))]

    #[test]
    fn limit_a_lane_gives_the_bits_of_its_scene_alone(
        case in two(),
        impacts in prop::sample::select(vec![VerletImpacts::VelocityJump, VerletImpacts::Located]),
        count in prop::sample::select(SCENES.to_vec()),
    ) {
        compare_columns(Verlet { impacts }.into(), &case, count)?;
    }
}

/// Structures that cannot touch.
#[test]
fn limit_structures_without_a_pair_give_the_bits_of_theirs_alone() {
    let row = |scene: u32| {
        let node = |stiffness: f64| Node::structure(1e5, 1e4, Elastic { stiffness });
        let stiffness = 1e6 * (1.0 + 0.1 * f64::from(scene));
        Row::new(vec![node(stiffness), node(4e6)], vec![]).expect("valid")
    };
    let rows: Vec<_> = (0..11).map(row).collect();
    let ground: Vec<f64> = (0..120)
        .map(|n| 3.0 * libm::sin(0.3 * f64::from(n)))
        .collect();
    let settings = Verlet {
        impacts: VerletImpacts::Located,
    };
    let held = compare(settings, (&all(&rows), RowsOf::Elastic), &ground);
    held.expect("the same bits");
}

#[test]
fn limit_rows_that_have_not_two_structures_are_not_taken() {
    let excitation = Excitation::new(1.0, &[0.0]).expect("valid");
    let settings = Verlet {
        impacts: VerletImpacts::Located,
    };
    let together = SideBySide::new(settings, excitation, CLOCK).expect("valid");
    let mut found = SceneSums::default();
    for n in [1, 2, 3] {
        let node = Node::structure(1e5, 1e4, Elastic { stiffness: 1e6 });
        let row = Row::new(vec![node; n], vec![]).expect("valid");
        let ran = together.run(RowsOf::Elastic(&[&row]), &[9], &mut found);
        assert_eq!(ran, n == 2, "{n} structures");
    }
}
