//! The velocity Verlet method side by side: every lane gives the bits of its scene alone.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{
    Bilinear, Elastic, ElastoPlastic, Excitation, Node, Row, RowsOf, SideBySide, Tallies, Verlet,
    VerletImpacts,
};
use proptest::prelude::*;

use crate::lanes::{CLOCK, SCENES, all, compare, varied, with_columns};
use crate::random_rows::{Case, SI, any_law, cases, config};

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
        let settings = Verlet { impacts };
        let scenes: Vec<_> = (0..count).map(|scene| varied(&case, scene)).collect();
        let rows: Vec<_> = scenes.iter().map(|case| case.row(SI)).collect();
        compare(settings, (&all(&rows), RowsOf::ElastoPlastic), &case.ground)?;
        let column = |node: &Node<ElastoPlastic>| Bilinear {
            stiffness: node.column.stiffness,
            yield_force: node.column.yield_force,
            hardening: 0.1,
        };
        let bilinear: Vec<_> = rows.iter().map(|row| with_columns(row, column)).collect();
        compare(settings, (&all(&bilinear), RowsOf::Bilinear), &case.ground)?;
        let column = |node: &Node<ElastoPlastic>| Elastic { stiffness: node.column.stiffness };
        let elastic: Vec<_> = rows.iter().map(|row| with_columns(row, column)).collect();
        compare(settings, (&all(&elastic), RowsOf::Elastic), &case.ground)?;
        let apart = |row: &Row<Elastic>| Row::new(row.nodes().to_vec(), vec![]).expect("valid");
        let apart: Vec<_> = elastic.iter().map(apart).collect();
        compare(settings, (&all(&apart), RowsOf::Elastic), &case.ground)?;
    }
}

#[test]
fn limit_rows_that_have_not_two_structures_are_not_taken() {
    let excitation = Excitation::new(1.0, &[0.0]).expect("valid");
    let settings = Verlet {
        impacts: VerletImpacts::Located,
    };
    let together = SideBySide::new(settings, excitation, CLOCK).expect("valid");
    let mut found = Tallies::default();
    for n in [1, 2, 3] {
        let node = Node::structure(1e5, 1e4, Elastic { stiffness: 1e6 });
        let row = Row::new(vec![node; n], vec![]).expect("valid");
        let ran = together.run(RowsOf::Elastic(&[&row]), &[9], &mut found);
        assert_eq!(ran, n == 2, "{n} structures");
    }
}
