//! Links in words: cases with closed forms or two routes in `tests/reach`, through scenes, and what is refused.

use std::path::Path;

use pounding_scene::file::Law;
use pounding_scene::{Error, LinkQuantity, Scene, Simulation};
use serde_json::Value;

use crate::beside::{case, number, prepared};

/// A scene without shaking, with its structures and its links.
fn still(method: &str, duration: f64, structures: &str, links: &str) -> String {
    format!(
        r#"
name = "linked"
record.generated.half_sine = {{ amplitude_m_per_s2 = 0, duration_s = 0.4, time_step_s = 0.01 }}
duration_s = {duration}
{method}
structures = [{structures}]
links = [{links}]
"#
    )
}

fn sdof(name: &str, mass: f64, stiffness: f64, start: &str) -> String {
    format!("{{ sdof = {{ name = \"{name}\", mass_kg = {mass:e}, stiffness_n_per_m = {stiffness:e}, damping.ratio = 0, {start} }} }}")
}

/// Stiffness of a mass that is as good as free \[N/m\]: structures of scenes need one.
const FREE: f64 = 1e-20;

/// Displacement and velocity of every structure at the end, and the numbers of the first link.
struct Ended {
    states: Vec<[f64; 2]>,
    link: Vec<Option<f64>>,
}

impl Ended {
    fn of(text: &str) -> Self {
        let simulation = prepared(text);
        let run = simulation.run(Some(simulation.duration())).expect("it runs");
        let histories = run.histories.as_ref().expect("asked for");
        let last = |floor: usize| histories.of(floor).states.last().expect("states");
        let states = 0..simulation.floors().all().len();
        let values = run.values(&simulation);
        Self {
            states: states.map(|floor| [last(floor).displacement, last(floor).velocity]).collect(),
            link: LinkQuantity::ALL.iter().map(|one| values.of(*one, 0)).collect(),
        }
    }

    fn link(&self, quantity: LinkQuantity) -> f64 {
        self.link[quantity as usize].expect("it is known")
    }
}

fn is_close(what: &str, found: f64, wanted: f64, within: f64) {
    assert!((found / wanted - 1.0).abs() < within, "{what}: {found} instead of {wanted}");
}

/// Two oscillators, the first let go at 50 mm, with the first end of the link in either place.
fn oscillators(inputs: &Value, method: &str, law: &str, between: [&str; 2]) -> String {
    let of = |name: &str| number(inputs, name);
    let first = format!("initial_displacement_m = {}", of("u1_0_m"));
    let structures = [
        sdof("one", of("m1_kg"), of("k1_n_per_m"), &first),
        sdof("two", of("m2_kg"), of("k2_n_per_m"), ""),
    ];
    let [left, right] = between.map(|name| format!("{{ structure = {name} }}"));
    still(
        method,
        2.0,
        &structures.join(", "),
        &format!("{{ between = [{left}, {right}], {law} }}"),
    )
}

#[test]
fn reference_dashpot_and_maxwell() {
    let (inputs, expected) = case("link-dashpot-and-maxwell.json");
    let of = |name: &str| number(&inputs, name);
    let dashpot = format!("law.dashpot.damping_n_s_per_m = {}", of("c_n_s_per_m"));
    let maxwell = format!(
        "law.maxwell = {{ stiffness_n_per_m = {}, damping_n_s_per_m = {} }}",
        of("k_maxwell_n_per_m"),
        of("c_n_s_per_m")
    );
    for (name, law) in [("dashpot", dashpot), ("maxwell", maxwell)] {
        let wanted = |field: &str| number(&expected[name], field);
        let mut all = Vec::new();
        // The order of the ends does not matter, nor whether names or places stand there.
        for between in [["\"one\"", "\"two\""], ["\"two\"", "\"one\""], ["2", "1"], ["1", "\"two\""]] {
            let ended = Ended::of(&oscillators(&inputs, "", &law, between));
            let [one, two] = [ended.states[0], ended.states[1]];
            is_close(name, one[0], wanted("u1_at_2s_m"), 1e-9);
            is_close(name, two[0], wanted("u2_at_2s_m"), 1e-9);
            is_close(name, one[1], wanted("v1_at_2s"), 1e-9);
            is_close(name, two[1], wanted("v2_at_2s"), 1e-9);
            // The brace of the Maxwell element holds F²/2k.
            let force = wanted("link_force_at_2s_n");
            let stored = if name == "maxwell" {
                0.5 * force * force / of("k_maxwell_n_per_m")
            } else {
                0.0
            };
            let energy = ended.link(LinkQuantity::LinkEnergyJ);
            is_close(name, energy, wanted("energy_dissipated_j") + stored, 1e-9);
            all.push(ended.link);
        }
        assert!(all.iter().all(|link| *link == all[0]), "{name}: {all:?}");
    }
}

/// A deck that leaves an abutment on the left: a wall, or the ground, where `side` says what is on the left.
#[test]
fn reference_a_restrainer_with_slack_that_yields() {
    let (inputs, expected) = case("link-restrainer-slack-yield.json");
    let of = |name: &str| number(&inputs, name);
    let wanted = |name: &str| number(&expected, name);
    let law = format!(
        "law.restrainer = {{ stiffness_n_per_m = {}, slack_m = {}, yield_force_n = {} }}",
        of("k_n_per_m"),
        of("slack_m"),
        of("fy_n")
    );
    let deck = sdof("deck", of("m_kg"), FREE, &format!("initial_velocity_m_per_s = {}", of("v0")));
    let beside_a_wall = format!("{{ wall = {{}} }}, {deck}");
    for (structures, link) in [
        (&beside_a_wall, "between = [{ structure = 1 }, { structure = 2 }]"),
        (
            &deck,
            "between = [{ structure = 1 }, { structure = 1, floor = 0 }], side = \"right\"",
        ),
        (
            &deck,
            "between = [{ structure = 1, floor = 0 }, { structure = 1 }], side = \"left\"",
        ),
    ] {
        let text = still("", wanted("back_at_zero_s"), structures, &format!("{{ {link}, {law} }}"));
        let ended = Ended::of(&text);
        let [displacement, velocity] = *ended.states.last().expect("a deck");
        assert!(displacement.abs() < 1e-9, "{displacement}");
        is_close("return", velocity, wanted("returns_at_m_per_s"), 1e-9);
        is_close("pull", ended.link(LinkQuantity::PeakPullN), of("fy_n"), 1e-9);
        let elongation = ended.link(LinkQuantity::LargestElongationM);
        is_close("opening", elongation, wanted("largest_opening_m"), 1e-9);
        is_close("energy", ended.link(LinkQuantity::LinkEnergyJ), wanted("energy_dissipated_j"), 1e-9);
        assert!(ended.link(LinkQuantity::PeakPushN).abs() < 1e-9, "it never pushes");
    }
}

/// A bare damper c |v|^α stops a free mass after a finite time; its order is four until then.
#[test]
fn order_a_bare_viscous_damper_by_rk4() {
    let (inputs, expected) = case("link-nonlinear-viscous.json");
    let of = |name: &str| number(&inputs, name);
    let wanted = |name: &str| number(&expected, name);
    let deck = sdof("deck", of("m_kg"), FREE, &format!("initial_velocity_m_per_s = {}", of("v0")));
    let link = format!(
        "{{ between = [{{ structure = 1 }}, {{ structure = 1, floor = 0 }}], law.viscous = {{ coefficient = {}, exponent = {} }} }}",
        of("c"),
        of("alpha")
    );
    let ended = |duration: f64, step: f64| {
        let method = format!("method.rk4.time_step_s = {step}");
        Ended::of(&still(&method, duration, &deck, &link)).states[0]
    };
    let off = |step: f64| {
        let [way, velocity] = ended(0.3, step);
        [way / wanted("way_at_0_3_s") - 1.0, velocity / wanted("velocity_at_0_3_s") - 1.0].map(f64::abs)
    };
    let [coarse, fine] = [0.03, 0.015].map(off);
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        let order = libm::log2(coarse / fine);
        assert!((3.8..4.2).contains(&order) && fine < 2e-9, "{coarse} {fine}");
    }
    // A millisecond before it stops, v^(1 − α) is (1 − α) c/m times the time that is left.
    let part = 1.0 - of("alpha");
    let left = part * of("c") / of("m_kg") * (wanted("stops_after_s") - 0.816);
    is_close("before it stops", ended(0.816, 5e-4)[1], libm::pow(left, 1.0 / part), 1e-3);
    // A step that passes the stop swings about it. What is left of velocity and way falls with h^(1/(1 − α)), an order of 1.54.
    let stopped = |step: f64| {
        let [way, velocity] = ended(1.0, step);
        [way - wanted("way_m"), velocity].map(f64::abs)
    };
    let [coarse, fine] = [2e-3, 5e-4].map(stopped);
    for (coarse, fine) in coarse.into_iter().zip(fine) {
        let order = 0.5 * libm::log2(coarse / fine);
        assert!((order * part - 1.0).abs() < 0.05, "{coarse} {fine}");
    }
}

/// A row with links of every law that colliding structures take, shaken.
fn shaken(method: &str, law: &str) -> String {
    format!(
        r#"
name = "shaken"
record.generated.ricker = {{ amplitude_m_per_s2 = 4, frequency_hz = 1.5, time_step_s = 0.02 }}
duration_s = 2
{method}
structures = [
  {{ building = {{ name = "a", period_s = 0.5, damping.ratio = 0.05, storeys = [{{ mass_kg = 2e5, height_m = 3, repeat = 2 }}] }} }},
  {{ sdof = {{ name = "b", mass_kg = 3e5, period_s = 0.8, damping.ratio = 0.05, height_m = 6 }} }},
]
links = [{{ between = [{{ structure = "a" }}, {{ structure = "b" }}], {law} }}]
"#
    )
}

/// RK4 tends to the exact motion. The order is four where the force follows from deformation and rate, and two where a brace flows. It is at
/// least one where a link yields or slackens.
#[test]
fn order_links_by_rk4() {
    for (law, order) in [
        ("law.spring = { stiffness_n_per_m = 2e7, damping_n_s_per_m = 3e5 }", 4.0),
        ("law.dashpot.damping_n_s_per_m = 5e5", 4.0),
        ("law.maxwell = { stiffness_n_per_m = 5e7, damping_n_s_per_m = 5e5 }", 2.0),
        (
            "law.viscous = { coefficient = 3e5, exponent = 0.5, brace_stiffness_n_per_m = 5e7 }",
            2.0,
        ),
        (
            "law.spring = { stiffness_n_per_m = 5e7, yield_force_n = 1e5, hardening_ratio = 0.05 }",
            1.0,
        ),
        (
            "law.restrainer = { stiffness_n_per_m = 2e7, slack_m = 0.005, yield_force_n = 1.5e5 }",
            1.0,
        ),
    ] {
        let exact = Ended::of(&shaken("", law));
        let off = |step: f64| {
            let found = Ended::of(&shaken(&format!("method.rk4.time_step_s = {step}"), law));
            let floors = found.states.iter().zip(&exact.states);
            floors.map(|(found, exact)| (found[0] - exact[0]).abs()).fold(0.0, f64::max)
        };
        let [coarse, fine] = [1e-2, 6.25e-4].map(off);
        let found = 0.25 * libm::log2(coarse / fine);
        assert!(found > 0.95 * order, "{law}: order {found}, {coarse} {fine}");
        assert!(exact.link(LinkQuantity::PeakPullN) > 1e4, "{law}: it must act");
    }
}

/// A restrainer that turned back from yielding yielded again by rounding, without end: in 7 of these 40 rows.
#[test]
fn issue_a_restrainer_that_turns_back_does_not_yield_by_rounding() {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studies/examples");
    let mut scene = Scene::read(&examples.join("bridge-with-restrainers.toml")).expect("a scene");
    scene.contacts = None;
    scene.duration_s = Some(9.0);
    for place in 0..40 {
        let stiffness = 2e7 + 1e8 * f64::from(place) / 39.0;
        for link in &mut scene.links {
            link.law = Law::Restrainer {
                stiffness_n_per_m: stiffness,
                slack_m: 0.02,
                yield_force_n: Some(2e6),
            };
        }
        let simulation = Simulation::new(&scene, examples.as_path()).expect("it is sound");
        let run = simulation.run(None).unwrap_or_else(|error| panic!("{stiffness}: {error}"));
        let pull = run.values(&simulation).of(LinkQuantity::PeakPullN, 0).expect("a pull");
        is_close("pull", pull, 2e6, 1e-9);
    }
}

/// The end of a refusal, after the name of the scene.
fn refused(method: &str, links: &str) -> String {
    let structures = [
        sdof("deck", 1e5, 1e7, ""),
        sdof("deck", 1e5, 1e7, ""),
        "{ building = { name = \"tower\", period_s = 0.5, damping.ratio = 0.05, storeys = [{ mass_kg = 1e5, height_m = 3, repeat = 3 }] } }"
            .into(),
    ];
    let text = still(method, 1.0, &structures.join(", "), links);
    let refused = |error: Error| error.to_string();
    let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml"));
    scene
        .and_then(|scene| Simulation::new(&scene, ""))
        .map_or_else(refused, |_| panic!("{links} is taken"))
}

#[test]
fn extreme_links_that_are_refused() {
    let spring = "law.spring.stiffness_n_per_m = 1e6";
    let restrainer = "law.restrainer.stiffness_n_per_m = 1e6";
    let between = |one: &str, other: &str| format!("between = [{{ structure = {one} }}, {{ structure = {other} }}]");
    let two = between("1", "3");
    let all = [
        (String::new(), format!("{{ {}, {spring} }}", between("1", "\"towers\""))),
        (String::new(), format!("{{ {}, {spring} }}", between("\"deck\"", "3"))),
        (String::new(), format!("{{ {}, {spring} }}", between("1", "4"))),
        (String::new(), format!("{{ {}, {spring} }}", between("1", "3, floor = 4"))),
        (String::new(), format!("{{ {}, {spring} }}", between("1", "1"))),
        (
            String::new(),
            format!("{{ {}, {spring} }}", between("1, floor = 0", "3, floor = 0")),
        ),
        (String::new(), format!("{{ {}, {restrainer} }}", between("3", "3, floor = 0"))),
        (String::new(), format!("{{ {two}, side = \"right\", {restrainer} }}")),
        (String::new(), format!("{{ {two}, law.spring.stiffness_n_per_m = 0 }}")),
        (
            String::new(),
            format!("{{ {two}, law.spring = {{ stiffness_n_per_m = 1e6, hardening_ratio = 1 }} }}"),
        ),
        (
            String::new(),
            format!("{{ {two}, law.restrainer = {{ stiffness_n_per_m = 1e6, slack_m = -0.01 }} }}"),
        ),
        (
            String::new(),
            format!("{{ {two}, law.viscous = {{ coefficient = 1e5, exponent = 0.35, brace_stiffness_n_per_m = 1e7 }} }}"),
        ),
        (
            String::new(),
            format!("{{ {two}, law.viscous = {{ coefficient = 1e5, exponent = 0.5 }} }}"),
        ),
        (String::new(), format!("{{ {two}, law.rope.stiffness_n_per_m = 1 }}")),
        (
            "method.newmark = { beta = 0.25, gamma = 0.5, time_step_s = 0.001 }".into(),
            format!("{{ {two}, {spring} }}"),
        ),
        ("method.accuracy = 0.01".into(), format!("{{ {two}, {spring} }}")),
    ];
    let all = all.map(|(method, link)| refused(&method, &link));
    insta::assert_snapshot!(all.join("\n"), @r#"
    scene "linked": links[0].between[1].structure: found "towers", allowed one of "deck", "deck", "tower", or a place from 1 to 3
    scene "linked": links[0].between[0].structure: found "deck", the name of several structures, allowed the place in the row, from 1 to 3
    scene "linked": links[0].between[1].structure: found 4, allowed a name, or a place from 1 to 3
    scene "linked": links[0].between[1].floor: found 4, allowed 0 for the ground, to 3 for the highest floor
    scene "linked": links[0].between: found two ends that cannot move against each other, allowed two floors, or a floor and the ground or a wall
    scene "linked": links[0].between: found two ends that cannot move against each other, allowed two floors, or a floor and the ground or a wall
    scene "linked": links[0].side: found none, and the row does not tell which end is on the left, allowed "left" or "right", for the first of `between`
    scene "linked": links[0].side: found a side against the order of the row, allowed that of the first end in the row; delete `side`
    scene "linked": links[0].law.spring.stiffness_n_per_m: found 0, allowed a finite number > 0; a damper without a spring is a `dashpot`
    scene "linked": links[0].law.spring.hardening_ratio: found 1, allowed 0 to less than 1
    scene "linked": links[0].law.restrainer.slack_m: found -0.01, allowed a finite number >= 0
    scene "linked": links[0].law.viscous.exponent: found 0.35, allowed 1/n with a whole number n from 1 to 10, such as 0.5, 0.25 or 0.2; take the nearest one, or leave the brace out and integrate by the method rk4
    scene "linked": links[0].law.viscous.brace_stiffness_n_per_m: found none: a damper c |v|^α alone has no series at v = 0, which the exact method needs, allowed a number > 0; give the stiffness of its brace, or take the method rk4
    scene.toml, line 7, column 66: links[0].law: found `rope`, allowed are `spring`, `dashpot`, `maxwell`, `viscous`, `restrainer`
    scene "linked": method: found newmark, which does not take `links`, allowed exact, rk4 or central_difference; leave `method` out: the exact method is the default
    scene "linked": method: found accuracy, which does not take `links`, allowed exact, rk4 or central_difference; leave `method` out: the exact method is the default
    "#);
}

/// The step of the second one is stable without the link.
#[test]
fn extreme_links_that_central_differences_refuse() {
    let between = "between = [{ structure = 1 }, { structure = 3 }]";
    let all = [
        (0.001, "viscous = { coefficient = 1e5, exponent = 0.5 }"),
        (0.02, "spring.stiffness_n_per_m = 1e9"),
    ];
    let all = all.map(|(time_step, law)| {
        let method = format!("method.central_difference.time_step_s = {time_step}");
        refused(&method, &format!("{{ {between}, law.{law} }}"))
    });
    insta::assert_snapshot!(all.join("\n"), @r#"
    scene "linked": links[0].law.viscous.brace_stiffness_n_per_m: found none: a damper c |v|^α alone is too steep at v = 0 for central differences, allowed a number > 0; give the stiffness of its brace, or take the method rk4
    scene "linked": method.central_difference.time_step_s: found 0.02, allowed less than 0.01397809 (with its links the row grows without bound from there on); contact can ask for less
    "#);
}
