//! Slabs that hit columns: cases with closed forms or two routes in `tests/reach`, through scenes.

use std::fs;
use std::path::Path;

use pounding_scene::{PairQuantity, Scene, Simulation};
use serde_json::Value;

pub(crate) fn case(name: &str) -> (Value, Value) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/reach").join(name);
    let case: Value = serde_json::from_slice(&fs::read(path).expect("it is there")).expect("JSON");
    (case["inputs"].clone(), case["expected"].clone())
}

pub(crate) fn number(of: &Value, name: &str) -> f64 {
    let value = &of[name];
    let written = || value.as_str()?.parse().ok();
    value.as_f64().or_else(written).unwrap_or_else(|| panic!("{name}: {of}"))
}

/// A slab on a spring that flies against the column of the second of two storeys of 3 m, at the part s of its height.
struct Slab<'a> {
    inputs: &'a Value,
    spring: f64,
    stiffnesses: [f64; 2],
    storey: &'a str,
    contact: &'a str,
}

impl Slab<'_> {
    fn scene(&self) -> String {
        let [low, high] = self.stiffnesses;
        let of = |name: &str| number(self.inputs, name);
        // The lower floor of the frame stands beside columns of the slab, which are not part of the case.
        let height = 3.0 + 3.0 * of("s");
        format!(
            r#"
name = "slab against column"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = 0.17
structures = [
  {{ sdof = {{ name = "slab", mass_kg = {}, stiffness_n_per_m = {}, damping.ratio = 0, height_m = {height}, initial_velocity_m_per_s = {} }} }},
  {{ building = {{ name = "frame", damping.ratio = 0, storeys = [
      {{ mass_kg = {}, stiffness_n_per_m = {low}, height_m = 3 }},
      {{ mass_kg = {}, stiffness_n_per_m = {high}, height_m = 3{} }},
  ] }} }},
]
contacts = [{{ gap_m = 0, heights_m = [{height}], {} }}]
"#,
            of("m1_kg"),
            self.spring,
            of("approach_m_per_s"),
            of("mass_below_kg"),
            of("mass_above_kg"),
            self.storey,
            self.contact
        )
    }

    fn prepared(&self) -> Simulation {
        prepared(&self.scene())
    }
}

pub(crate) fn prepared(text: &str) -> Simulation {
    let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).expect("a scene");
    Simulation::new(&scene, "").expect("it is sound")
}

fn is_close(found: f64, wanted: f64, within: f64) {
    assert!((found / wanted - 1.0).abs() < within, "{found} {wanted}");
}

/// The impulse of two masses: the slab, and the point of the column with both of its floors by the parts 1 − W and W.
#[test]
fn reference_the_impulse_of_a_slab_against_a_column() {
    let (inputs, expected) = case("slab-against-column-impulse.json");
    for (shape, name) in [
        ("straight", "straight column, w = s"),
        ("fixed", "fixed-fixed column, w = 3s^2-2s^3"),
    ] {
        let contact = format!(
            "column_shape = \"{shape}\", law.stereomechanical.restitution = {}",
            number(&inputs, "e")
        );
        let slab = Slab {
            inputs: &inputs,
            spring: 1.0,
            stiffnesses: [1.0, 1.0],
            storey: "",
            contact: &contact,
        };
        let simulation = slab.prepared();
        let run = simulation.run(None).expect("it runs");
        let hit = &expected[name];
        is_close(run.of_pair(0).first.expect("it hits").impulse, number(hit, "impulse_n_s"), 1e-9);
        is_close(simulation.on_row(ReducedMass), number(hit, "effective_mass_kg"), 1e-12);
    }
}

/// Reduced mass of the first pair.
struct ReducedMass;

impl pounding_solver::OnRow for ReducedMass {
    type Output = f64;

    fn on<Column: pounding_solver::Hysteretic>(self, row: &pounding_solver::Row<Column>) -> f64 {
        row.reduced_mass(&row.pairs()[0])
    }
}

/// Eight columns in the storey: the one that is hit bends in series with the contact. Shear and moment follow from its ends, which are fixed.
#[test]
fn reference_a_slab_against_a_column_that_bends() {
    let (inputs, expected) = case("slab-against-column-linear.json");
    let of = |name: &str| number(&expected, name);
    let columns = format!(", columns = {}", number(&inputs, "columns"));
    let contact = format!(
        "law.linear_spring.impact_stiffness_n_per_m = {}",
        number(&inputs, "impact_stiffness_n_per_m")
    );
    let slab = Slab {
        inputs: &inputs,
        spring: number(&inputs, "slab_spring_n_per_m"),
        stiffnesses: ["storey_below_n_per_m", "storey_hit_n_per_m"].map(|name| number(&inputs, name)),
        storey: &columns,
        contact: &contact,
    };
    let simulation = slab.prepared();
    let run = simulation.run(None).expect("it runs");
    let values = run.values(&simulation);
    let value = |quantity: PairQuantity| values.of(quantity, 0).expect("it is known");
    let floors = simulation.floors();
    let column = floors.column_of(&floors.facing()[0]).expect("a column");
    is_close(column.upper_part(), of("weight_above"), 1e-12);
    is_close(
        column.bending_stiffness(simulation.floors()).expect("counted"),
        of("local_stiffness_n_per_m"),
        1e-12,
    );
    is_close(value(PairQuantity::PeakForceN), of("peak_force_n"), 1e-9);
    is_close(value(PairQuantity::PeakForceTimeS), of("time_of_peak_s"), 1e-9);
    is_close(run.of_pair(0).first.expect("it hits").end, of("parting_s"), 1e-9);
    // The reaction above is the larger one, and the end above has the larger moment.
    is_close(value(PairQuantity::ColumnShearN), of("reaction_above_n"), 1e-9);
    is_close(value(PairQuantity::ColumnMomentNM), 3.0 * of("fixed_end_moment_above_over_H"), 1e-9);
}

/// Slabs whose depths overlap meet as floors; slabs that a contact does not name stay out of it.
#[test]
fn reference_what_stands_at_the_height_of_a_slab() {
    let row = |depth: &str, contact: &str| {
        let text = format!(
            r#"
name = "two"
record.generated.ricker = {{ amplitude_m_per_s2 = 5, frequency_hz = 1, time_step_s = 0.01 }}
structures = [
  {{ building = {{ name = "a", period_s = 0.4, damping.ratio = 0.05, storeys = [{{ mass_kg = 2e5, height_m = 3{depth}, repeat = 3 }}] }} }},
  {{ building = {{ name = "b", period_s = 0.7, damping.ratio = 0.05, storeys = [{{ mass_kg = 2e5, height_m = 3.2{depth}, repeat = 4 }}] }} }},
]
contacts = [{{ gap_m = 0.02, law.stereomechanical.restitution = 0.5{contact} }}]
"#
        );
        prepared(&text)
    };
    let names = |simulation: &Simulation| {
        let floors = simulation.floors();
        let pairs = floors.pairs_by_contact().into_iter();
        pairs.map(|pair| floors.names(pair).join(" – ")).collect::<Vec<_>>()
    };
    insta::assert_snapshot!(names(&row("", "")).join("\n"), @"
    a, floor 1 – b, column of storey 1
    a, column of storey 2 – b, floor 1
    a, floor 2 – b, column of storey 2
    a, column of storey 3 – b, floor 2
    a, floor 3 – b, column of storey 3
    ");
    insta::assert_snapshot!(names(&row(", slab_depth_m = 0.3", "")).join("\n"), @"
    a, floor 1 – b, floor 1
    a, floor 2 – b, column of storey 2
    a, column of storey 3 – b, floor 2
    a, floor 3 – b, column of storey 3
    ");
    insta::assert_snapshot!(names(&row("", ", heights_m = [6]")).join("\n"), @"a, floor 2 – b, column of storey 2");
}

/// A row in which slabs hit columns mirrors its motion in the mirrored row, and gives the same in every method to its order.
#[test]
fn limit_slabs_and_columns_mirror() {
    let text = |order: [&str; 2], sign: &str| {
        format!(
            r#"
name = "two"
record.generated.ricker = {{ amplitude_m_per_s2 = {sign}5, frequency_hz = 1, time_step_s = 0.01 }}
structures = [{}, {}]
contacts = [{{ gap_m = 0.02, law.kelvin_voigt = {{ impact_stiffness_n_per_m = 1e8, restitution = 0.6 }} }}]
"#,
            order[0], order[1]
        )
    };
    let a =
        "{ building = { name = \"a\", period_s = 0.4, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3, repeat = 3 }] } }";
    let b =
        "{ building = { name = \"b\", period_s = 0.7, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3.5, repeat = 4 }] } }";
    let forces = |text: &str| {
        let simulation = prepared(text);
        let run = simulation.run(None).expect("it runs");
        let values = run.values(&simulation);
        let pairs = 0..simulation.pairs().len();
        let mut all: Vec<f64> = pairs.filter_map(|pair| values.of(PairQuantity::PeakForceN, pair)).collect();
        all.sort_by(f64::total_cmp);
        all
    };
    let [one, other] = [text([a, b], ""), text([b, a], "-")].map(|text| forces(&text));
    assert!(one.len() > 2 && one.len() == other.len(), "{one:?} {other:?}");
    for (one, other) in one.iter().zip(&other) {
        is_close(*one, *other, 1e-9);
    }
}

/// A height that meets nothing was silent beside one that meets a column.
#[test]
fn extreme_heights_at_which_nothing_touches() {
    let text = r#"
name = "two"
record.generated.ricker = { amplitude_m_per_s2 = 5, frequency_hz = 1, time_step_s = 0.01 }
structures = [
  { building = { name = "a", period_s = 0.4, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3, repeat = 3 }] } },
  { building = { name = "b", period_s = 0.7, damping.ratio = 0.05, storeys = [{ mass_kg = 2e5, height_m = 3.2, repeat = 4 }] } },
]
contacts = [{ gap_m = 0.02, law.stereomechanical.restitution = 0.5, heights_m = [6, 6.2] }]
"#;
    let refused = |text: &str| {
        let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).expect("a scene");
        Simulation::new(&scene, "").expect_err("it is refused").to_string()
    };
    insta::assert_snapshot!([refused(text), refused(&text.replace("[6, 6.2]", "[]"))].join("\n"), @r#"
    scene "two": contacts[0].heights_m[1]: found 6.2, allowed are heights of slabs up to the lower roof, to a millimetre; leave out `heights_m` for all of them
    scene "two": contacts[0].heights_m: found none, allowed are heights of slabs up to the lower roof, to a millimetre; leave out `heights_m` for all of them
    "#);
}
