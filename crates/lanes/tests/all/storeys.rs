//! Buildings of several storeys in lanes: every lane gives exactly the bits of its scene alone.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{
    Bilinear, Elastic, Excitation, Floor, Hysteretic, Levels, Link, LinkLaw, Node, Pair, Point, Relation, Row, Spring, Storey,
};
use proptest::prelude::*;

use crate::random_rows::{any_law, config, stereomechanical};
use crate::steps::{BEYOND_THE_CLOCK, CLOCK, SCENES, SETTINGS, all, compare, stiffer};

/// A building, or a wall.
#[derive(Debug, Clone)]
struct Building {
    /// Levels of its floors.
    floors: Vec<usize>,
    /// Mass of a floor \[kg\], period of a storey alone \[s\], drift at yielding \[m\].
    storey: [f64; 3],
    /// Rayleigh damping, α \[1/s\] and β \[s\].
    damping: [f64; 2],
    /// Velocity of all floors at t = 0 \[m/s\], and their displacement per level \[m\].
    moves: [f64; 2],
    is_wall: bool,
}

/// A row of buildings under a record.
#[derive(Debug, Clone)]
struct Case {
    buildings: Vec<Building>,
    /// Gap \[m\] between buildings, and laws of their levels, in turn.
    contacts: Vec<(f64, Vec<ContactLaw>)>,
    /// Samples every 0.01 s \[m/s²\].
    ground: Vec<f64>,
}

fn power_of_ten(exponents: std::ops::Range<f64>) -> impl Strategy<Value = f64> {
    exponents.prop_map(|exponent| libm::pow(10.0, exponent))
}

/// A building with floors at every level or every second level, from the ground up. Some are halls whose only lower floor is the ground.
fn building() -> impl Strategy<Value = Building> {
    let storey = (
        power_of_ten(4.0..6.0),
        power_of_ten(-1.1..0.0),
        prop_oneof![Just(f64::INFINITY), power_of_ten(-4.0..-2.0)],
    );
    let damping = (prop_oneof![Just(0.0), 0.0..2.0_f64], prop_oneof![Just(0.0), 0.0..0.01_f64]);
    let moves = prop_oneof![3 => Just([0.0; 2]), 1 => prop::array::uniform2(-0.3..0.3_f64)];
    let shape = (
        1..=8_usize,
        prop_oneof![4 => Just(1_usize), 1 => Just(2)],
        prop_oneof![5 => Just(0_usize), 1 => Just(1)],
    );
    let all = (shape, storey, damping, moves, 0..6_u32);
    all.prop_map(|((storeys, rise, base), storey, damping, [velocity, lean], kind)| Building {
        floors: (0..storeys).map(|floor| base + floor * rise).collect(),
        storey: storey.into(),
        damping: damping.into(),
        moves: [velocity, -0.001 * lean.abs()],
        is_wall: kind == 0,
    })
}

fn cases(law: fn() -> BoxedStrategy<ContactLaw>) -> impl Strategy<Value = Case> {
    let gap = prop_oneof![Just(0.01), power_of_ten(-5.0..-2.0), 0.0..0.05_f64];
    let contact = (gap, prop::collection::vec(law(), 1..3));
    let record = prop::collection::vec(-8.0..8.0_f64, 2..60);
    (2..=4_usize).prop_flat_map(move |n| {
        let buildings = prop::collection::vec(building(), n);
        let contacts = prop::collection::vec(contact.clone(), n - 1);
        (buildings, contacts, record.clone()).prop_map(|(mut buildings, contacts, ground)| {
            let last = buildings.len() - 1;
            for (index, building) in buildings.iter_mut().enumerate() {
                building.is_wall &= index == last || index == 0;
            }
            // Two walls cannot touch each other.
            buildings[0].is_wall &= !buildings[1].is_wall;
            // All lean alike, so that no gap is closed at t = 0; next to a wall none leans.
            let walls = buildings.iter().any(|building| building.is_wall);
            let lean = if walls { 0.0 } else { buildings[0].moves[1] };
            for building in &mut buildings {
                building.moves[1] = lean;
            }
            Case {
                buildings,
                contacts,
                ground,
            }
        })
    })
}

/// The row with other numbers. A scene that no step of the clock can resolve must not disturb the others.
fn row<Column: Hysteretic>(case: &Case, scene: usize, column: impl Fn(f64, f64) -> Column) -> Row<Column> {
    let factor = 1.0 + 0.03 * scene as f64;
    let floors: Vec<_> = case.buildings.iter().map(|one| one.floors.clone()).collect();
    let levels = Levels::at(&floors);
    let node = |index: usize| -> Node<Column> {
        let (place, _) = levels.place(index);
        let building = &case.buildings[place];
        let [mass, mut period, yields] = building.storey;
        period *= if place % 2 == 0 { factor } else { 1.0 };
        if scene == BEYOND_THE_CLOCK && place == 0 {
            period = 1e-3;
        }
        let omega = 2.0 * std::f64::consts::PI / period;
        let stiffness = mass * omega * omega;
        let column = column(stiffness, stiffness * yields * factor);
        if building.is_wall {
            return Node::wall(column);
        }
        let [alpha, beta] = building.damping;
        let storey = Storey {
            mass: mass * factor,
            damping: beta * stiffness,
            ground_damping: alpha * mass,
            column,
        };
        Node {
            initial_velocity: building.moves[0] / factor,
            initial_displacement: building.moves[1] * levels.level(index) as f64,
            ..levels.floor(index, storey)
        }
    };
    let mut pairs = Vec::new();
    for (left, (gap, laws)) in case.contacts.iter().enumerate() {
        for (level, (one, other)) in levels.facing(left).enumerate() {
            pairs.push(Pair::of_floors(
                one,
                other,
                gap * (2.0 - factor),
                stiffer(laws[level % laws.len()], factor),
            ));
        }
    }
    pairs.sort_by_key(Pair::left);
    let nodes = (0..levels.n_nodes()).map(node).collect();
    Row::new(nodes, pairs).expect("the row is valid")
}

/// The row; each floor on the left also meets the columns below the floor on the right, nearer to their head or to their foot.
fn beside_columns<Column: Hysteretic>(row: &Row<Column>, scene: usize) -> Row<Column> {
    let column = |(index, pair): (usize, &Pair)| {
        let node = &row.nodes()[pair.right()];
        let part = if index % 3 == 1 { 0.3 } else { 0.7 } + 0.01 * scene as f64;
        let right = Point::between(node.support.below(), pair.right(), part).expect("a part");
        (!node.is_wall()).then(|| Pair::new(Point::Floor(pair.left()), right, 0.8 * pair.gap(), pair.law))
    };
    let columns = row.pairs().iter().enumerate().filter_map(column);
    let pairs = row.pairs().iter().copied().chain(columns).collect();
    Row::new(row.nodes().to_vec(), pairs).expect("the row is valid")
}

/// The row with links of every kind that lanes run: a dashpot between roofs, a spring that yields and has a dashpot between the lowest
/// floors, and an elastic one to the ground.
pub(crate) fn linked<Column: Hysteretic>(row: &Row<Column>, scene: usize) -> Row<Column> {
    let factor = 1.0 + 0.05 * scene as f64;
    let spring = Spring {
        stiffness: 2e6 * factor,
        yield_force: 2e4 / factor,
        hardening: 0.1 / factor,
        damping: 4e4 * factor,
    };
    let dashpot = Spring { stiffness: 0.0, ..spring };
    let elastic = Spring {
        yield_force: f64::INFINITY,
        damping: 0.0,
        ..spring
    };
    let n = row.nodes().len();
    let link = |left: Point, right: Point, law: Spring| Link {
        relation: Relation { left, right, offset: 0.0 },
        law: LinkLaw::Spring(law),
    };
    let ends = [
        link(0.into(), 1.into(), spring),
        link(0.into(), (n - 1).into(), dashpot),
        link(1.into(), Point::Ground(1), elastic),
    ];
    // A link of walls alone moves nothing.
    let moves = |link: &Link| link.relation.pushes().any(|(floor, _)| !row.nodes()[floor].is_wall());
    let links = ends.into_iter().filter(moves).collect();
    row.clone().linked(links).expect("links")
}

/// Compares scenes like this one with links.
fn compare_linked(case: &Case) -> Result<(), TestCaseError> {
    let elastic = |stiffness, _| Elastic { stiffness };
    let rows: Vec<_> = (0..SCENES[0]).map(|scene| linked(&row(case, scene, elastic), scene)).collect();
    compare((&all(&rows), RowsOf::Elastic), &case.ground)
}

/// Compares scenes like this one, whose floors also meet columns.
fn compare_beside_columns(case: &Case) -> Result<(), TestCaseError> {
    let bilinear = |stiffness, yield_force| Bilinear {
        stiffness,
        yield_force,
        hardening: 0.1,
    };
    let rows: Vec<_> = (0..SCENES[0])
        .map(|scene| beside_columns(&row(case, scene, bilinear), scene))
        .collect();
    compare((&all(&rows), RowsOf::Bilinear), &case.ground)
}

/// Compares `count` scenes like this one with themselves alone, with every kind of columns.
fn compare_columns(case: &Case, count: usize) -> Result<(), TestCaseError> {
    let elastic = |stiffness, _| Elastic { stiffness };
    let rows: Vec<_> = (0..count).map(|scene| row(case, scene, elastic)).collect();
    compare((&all(&rows), RowsOf::Elastic), &case.ground)?;
    let plastic = |stiffness, yield_force| Bilinear {
        stiffness,
        yield_force,
        hardening: 0.0,
    };
    let rows: Vec<_> = (0..count).map(|scene| row(case, scene, plastic)).collect();
    compare((&all(&rows), RowsOf::Bilinear), &case.ground)?;
    let bilinear = |stiffness, yield_force| Bilinear {
        stiffness,
        yield_force,
        hardening: 0.1,
    };
    let rows: Vec<_> = (0..count).map(|scene| row(case, scene, bilinear)).collect();
    compare((&all(&rows), RowsOf::Bilinear), &case.ground)
}

proptest! {
    #![proptest_config(config(100))]

    #[test]
    fn limit_a_lane_gives_the_bits_of_its_scene_alone(
        case in cases(any_law),
        count in prop::sample::select(SCENES.to_vec()),
    ) {
        compare_columns(&case, count)?;
    }

    #[test]
    fn limit_impacts_of_storeys_give_the_bits_of_a_scene_alone(case in cases(stereomechanical)) {
        compare_columns(&case, SCENES[0])?;
    }
}

proptest! {
    #![proptest_config(config(100))]

    #[test]
    fn limit_links_give_the_bits_of_a_scene_alone(case in cases(any_law)) {
        compare_linked(&case)?;
    }

    #[test]
    fn limit_links_and_impacts_give_the_bits_of_a_scene_alone(case in cases(stereomechanical)) {
        compare_linked(&case)?;
    }

    #[test]
    fn limit_slabs_beside_columns_give_the_bits_of_a_scene_alone(case in cases(any_law)) {
        compare_beside_columns(&case)?;
    }

    #[test]
    fn limit_impacts_on_columns_give_the_bits_of_a_scene_alone(case in cases(stereomechanical)) {
        compare_beside_columns(&case)?;
    }
}

fn elastic(mass: f64) -> Node<Elastic> {
    Node::structure(mass, 1e4, Elastic { stiffness: 1e7 })
}

fn on(node: Node<Elastic>, below: usize) -> Node<Elastic> {
    node.on_floor(Floor {
        below,
        ground_damping: 1e3,
    })
}

fn impact(left: usize) -> Pair {
    let law = Stereomechanical { restitution: 0.5 };
    Pair::of_floors(left, left + 1, 0.01, ContactLaw::Stereomechanical(law))
}

#[test]
fn limit_rows_of_other_storeys_are_not_taken() {
    let excitation = Excitation::new(1.0, &[0.0]).expect("valid");
    let mut found = SceneSums::default();
    let together = SideBySide::new(SETTINGS, excitation, CLOCK).expect("valid");
    let row = |nodes, pairs| Row::new(nodes, pairs).expect("valid");
    let tower = row(vec![elastic(1e5), on(elastic(1e5), 0)], vec![]);
    let houses = row(vec![elastic(1e5), elastic(1e5)], vec![]);
    let mut takes = |rows: &[&Row<Elastic>]| {
        let n_steps = vec![9; rows.len()];
        together.run(RowsOf::Elastic(rows), &n_steps, &mut found)
    };
    assert!(takes(&[&tower]), "a tower");
    assert!(takes(&[&houses]), "two houses");
    assert!(!takes(&[&tower, &houses]), "a tower beside two houses");
    // A hall with its base at the second level of the tower to its right.
    let nodes = vec![elastic(1e5), elastic(1e5), on(elastic(1e5), 0)];
    assert!(takes(&[&row(nodes, vec![impact(1)])]), "a hall");
}
