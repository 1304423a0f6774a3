//! Tests of messages about scenes that cannot be read, modelled or run.

use std::fs;
use std::path::Path;

use insta::assert_snapshot;
use pounding::contact::LawName;
use serde_json::{Value, json};

use crate::{folder, good_scene, pounding, quiet, refusal, run};

/// The message for the good scene with one change.
fn refused(test: &str, change: impl Fn(&mut Value)) -> String {
    let mut scene = good_scene();
    change(&mut scene);
    let scene = serde_json::to_string_pretty(&scene).expect("a value is written");
    refusal(&run(test, &scene, Some(&quiet(10))))
}

#[test]
fn extreme_scene_not_there() {
    let ended = pounding(&folder("not_there"), &["run", "scene.json"]);
    let missing = fs::read(Path::new("scene.json")).expect_err("no scene lies beside the crate");
    let message = refusal(&ended).replace(&missing.to_string(), "[what the system says]");
    assert_snapshot!(message, @"error: scene.json: cannot be read: [what the system says]");
}

#[test]
fn extreme_scene_not_json() {
    assert_snapshot!(refusal(&run("not_json", "structures: 2\n", None)), @"error: scene.json, line 1, column 1: not JSON: expected value");
}

#[test]
fn extreme_scene_empty() {
    assert_snapshot!(refusal(&run("empty_scene", "", None)), @"error: scene.json, line 1, column 0: not JSON: EOF while parsing a value");
}

#[test]
fn extreme_scene_cut_off() {
    assert_snapshot!(refusal(&run("cut_off", "{\"name\": \"x\", \"record\": {\"file\": ", None)), @"error: scene.json, line 1, column 33: not JSON: EOF while parsing a value");
}

#[test]
fn extreme_scene_with_something_after_it() {
    let scene = format!("{}\n]", good_scene());
    assert_snapshot!(refusal(&run("after", &scene, None)), @"error: scene.json, line 2, column 1: not JSON: trailing characters");
}

#[test]
fn extreme_study_given_as_scene() {
    let study = fs::read_to_string("../../studies/table-2.json").expect("the study is there");
    assert_snapshot!(refusal(&run("study", &study, None)), @"error: scene.json, line 2, column 3: title: found `title`, which a study has: a scene is one entry of its `scenes`, in a file of its own");
}

#[test]
fn extreme_field_unknown() {
    let message = refused("unknown_field", |scene| {
        scene["structures"][0]["sdof"]["mas_kg"] = json!(75e3);
    });
    assert_snapshot!(message, @"error: scene.json, line 35, column 9: structures[0].sdof.mas_kg: found the field `mas_kg`, allowed are `name`, `mass_kg`, `stiffness_n_per_m`, `period_s`, `damping`, `yield_force_n`, `yield_displacement_m`, `yield_drift_ratio`, `hardening_ratio`, `bouc_wen`, `height_m`, `isolation_layer`, `drift_capacity_ratio`, `shear_capacity_n`, `column_capacity_n`, `columns`, `gravity_load_n`, `slab_depth_m`, `initial_displacement_m`, `initial_velocity_m_per_s`; perhaps `mass_kg` is meant");
}

#[test]
fn extreme_field_missing() {
    let message = refused("missing_field", |scene| {
        let structure = scene["structures"][0]["sdof"].as_object_mut();
        structure.expect("a structure has fields").remove("mass_kg");
    });
    assert_snapshot!(message, @"error: scene.json, line 28, column 15: structures[0].sdof: found no `mass_kg`, which must be there; add it");
}

#[test]
fn extreme_law_given_twice() {
    let message = refused("law_twice", |scene| {
        scene["contacts"][0]["law"] = json!({"hertz_damp": {
            "impact_stiffness_n_per_m1_5": 2.75e9, "impact_damping_factor": 0.5, "restitution": 0.65,
        }});
    });
    assert_snapshot!(message, @"error: scene.json, line 6, column 23: contacts[0].law.hertz_damp: found both `impact_damping_factor` and `restitution`, allowed one of them");
}

#[test]
fn extreme_restitution_beyond_one() {
    let message = refused("restitution_beyond", |scene| {
        scene["contacts"][0]["law"] = json!({"hertz_damp": {
            "impact_stiffness_n_per_m1_5": 2.75e9, "restitution": 1.2,
        }});
    });
    assert_snapshot!(message, @"error: scene.json, line 8, column 11: contacts[0].law.hertz_damp.restitution: found 1.2, allowed more than 0, up to 1");
}

#[test]
fn extreme_field_of_other_type() {
    let message = refused("other_type", |scene| {
        scene["structures"][1]["sdof"]["mass_kg"] = json!("3000 t");
    });
    assert_snapshot!(message, @r#"error: scene.json, line 49, column 20: structures[1].sdof.mass_kg: found the text "3000 t", allowed is a number"#);
}

#[test]
fn extreme_method_unknown() {
    let message = refused("unknown_method", |scene| {
        scene["method"] = json!({"runge_kutta": {"time_step_s": 0.01}});
    });
    assert_snapshot!(message, @"error: scene.json, line 15, column 5: method: found `runge_kutta`, allowed are `central_difference`, `newmark`, `hht`, `velocity_verlet`, `rk4`, `moreau_jean`, `exact`, `accuracy`");
}

#[test]
fn extreme_contact_law_unknown() {
    let message = refused("unknown_law", |scene| {
        scene["contacts"][0]["law"] = json!({"rubber": {}});
    });
    let place = "error: scene.json, line 6, column 9: contacts[0].law: found `rubber`, allowed are `stereomechanical`, ";
    assert!(message.starts_with(place), "{message}");
    for law in LawName::ALL {
        // The literature's names for one force are not words of scene files.
        let is_word = law.about().names[0].name == law.name();
        assert_eq!(message.contains(&format!("`{}`", law.name())), is_word, "{message}");
    }
}

/// Words of scenes from before the paper's program left the list of methods.
#[test]
fn extreme_words_of_the_paper_s_program() {
    let refused = |field: &str, word: &str| {
        refused("words_of_before", |scene| {
            scene["method"]["central_difference"][field] = json!(word);
        })
    };
    assert_snapshot!(refused("start", "first_load_used"), @"error: scene.json, line 16, column 16: method.central_difference.start: found `first_load_used`, allowed are `consistent`");
    assert_snapshot!(refused("impacts", "as_published"), @"error: scene.json, line 16, column 18: method.central_difference.impacts: found `as_published`, allowed are `velocity_jump`");
}

#[test]
fn extreme_two_contact_laws() {
    let message = refused("two_laws", |scene| {
        scene["contacts"][0]["law"]["stereomechanical"] = json!({"restitution": 0.65});
    });
    assert_snapshot!(message, @"error: scene.json, line 5, column 14: contacts[0].law: found both `nonlinear_viscoelastic` and `stereomechanical`, allowed is one of them; delete the other");
}

#[test]
fn extreme_two_kinds_of_damping() {
    let message = refused("two_dampings", |scene| {
        scene["structures"][0]["sdof"]["damping"]["ratio"] = json!(0.05);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 29, column 20: structures[0].sdof.damping: found both `ratio` and `rayleigh`, allowed is one of them; delete the other"#);
}

#[test]
fn extreme_damping_as_a_number() {
    let message = refused("number", |scene| {
        scene["structures"][0]["sdof"]["damping"] = json!(0.05);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 29, column 20: structures[0].sdof.damping: found no choice, allowed is one, such as {"ratio": 0.05} in JSON, { ratio = 0.05 } in TOML"#);
}

#[test]
fn extreme_mass_beyond_all_numbers() {
    let scene = good_scene().to_string().replace("75000.0", "1e400");
    assert_snapshot!(refusal(&run("beyond", &scene, Some(&quiet(10)))), @"error: scene.json, line 1, column 416: structures[0].sdof.mass_kg: found a number beyond 1.8e308, allowed are smaller ones");
}

#[test]
fn extreme_mass_negative() {
    let message = refused("negative_mass", |scene| {
        scene["structures"][0]["sdof"]["mass_kg"] = json!(-75e3);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 35, column 9: scene "two structures": structures[0].sdof.mass_kg: found -75000, allowed a finite number > 0"#);
}

#[test]
fn extreme_stiffness_zero() {
    let message = refused("zero_stiffness", |scene| {
        scene["structures"][1]["sdof"]["stiffness_n_per_m"] = json!(0);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 51, column 9: scene "two structures": structures[1].sdof.stiffness_n_per_m: found 0, allowed a finite number > 0"#);
}

#[test]
fn extreme_damping_negative() {
    let message = refused("negative_damping", |scene| {
        scene["structures"][1]["sdof"]["damping"]["rayleigh"]["beta_s"] = json!(-0.001);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 46, column 13: scene "two structures": structures[1].sdof.damping.rayleigh.beta_s: found -0.001, allowed a finite number >= 0"#);
}

#[test]
fn extreme_yield_force_zero() {
    let message = refused("zero_yield_force", |scene| {
        scene["structures"][0]["sdof"]["yield_force_n"] = json!(0);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 38, column 9: scene "two structures": structures[0].sdof.yield_force_n: found 0, allowed a finite number > 0"#);
}

#[test]
fn extreme_no_structures() {
    let message = refused("no_structures", |scene| scene["structures"] = json!([]));
    assert_snapshot!(message, @r#"error: scene.json, line 26, column 3: scene "two structures": structures: found none, allowed one or more"#);
}

#[test]
fn extreme_more_contacts_than_fit() {
    let message = refused("contacts", |scene| {
        let contact = scene["contacts"][0].clone();
        scene["contacts"] = json!([contact, contact]);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 2, column 3: scene "two structures": contacts: found 2 for 2 structures, allowed 1 (one between each structure and its right neighbour), or no field `contacts` when they stand apart"#);
}

#[test]
fn extreme_contact_between_walls() {
    let message = refused("walls", |scene| {
        let contact = scene["contacts"][0].clone();
        scene["structures"] = json!([scene["structures"][0], "wall", "wall"]);
        scene["contacts"] = json!([contact, contact]);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 12, column 5: scene "two structures": contacts[1]: found a wall on either side, allowed at most one wall per contact"#);
}

#[test]
fn extreme_restitution_above_one() {
    let message = refused("restitution", |scene| {
        scene["contacts"][0]["law"] = json!({"stereomechanical": {"restitution": 1.2}});
    });
    assert_snapshot!(message, @r#"error: scene.json, line 7, column 11: scene "two structures": contacts[0].law.stereomechanical.restitution: found 1.2, allowed 0 to 1"#);
}

#[test]
fn extreme_impact_stiffness_zero() {
    let message = refused("impact_stiffness", |scene| {
        scene["contacts"][0]["law"]["nonlinear_viscoelastic"]["impact_stiffness_n_per_m1_5"] = json!(0);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 8, column 11: scene "two structures": contacts[0].law.nonlinear_viscoelastic.impact_stiffness_n_per_m1_5: found 0, allowed a finite number > 0"#);
}

#[test]
fn extreme_gap_negative() {
    let message = refused("gap", |scene| scene["contacts"][0]["gap_m"] = json!(-0.03));
    assert_snapshot!(message, @r#"error: scene.json, line 4, column 7: scene "two structures": contacts[0].gap_m: found -0.03, allowed a finite number >= 0"#);
}

#[test]
fn extreme_settings_of_methods_out_of_range() {
    let refused = |method: Value| {
        refused("method_settings", |scene| {
            scene["method"] = method.clone();
        })
    };
    let divided = json!({"central_difference": {
        "time_step_s": 0.01, "contact_substeps": 1001
    }});
    assert_snapshot!(refused(divided), @r#"error: scene.json, line 16, column 7: scene "two structures": method.central_difference.contact_substeps: found 1001, allowed 1 to 1000"#);
    let hht = json!({"hht": {"time_step_s": 0.01, "alpha": 0.1}});
    assert_snapshot!(refused(hht), @r#"error: scene.json, line 16, column 7: scene "two structures": method.hht.alpha: found 0.1, allowed -1/3 to 0"#);
    let moreau_jean = json!({"moreau_jean": {"time_step_s": 0.01, "theta": 0.4}});
    assert_snapshot!(refused(moreau_jean), @r#"error: scene.json, line 16, column 7: scene "two structures": method.moreau_jean.theta: found 0.4, allowed 0.5 to 1"#);
    let verlet = json!({"velocity_verlet": {"time_step_s": 0.01, "impacts": "as_published"}});
    assert_snapshot!(refused(verlet), @"error: scene.json, line 16, column 18: method.velocity_verlet.impacts: found `as_published`, allowed are `velocity_jump`, `located`");
}

#[test]
fn extreme_gap_closed_at_the_start() {
    let message = refused("closed", |scene| {
        scene["structures"][0]["sdof"]["initial_displacement_m"] = json!(0.04);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 4, column 7: scene "two structures": contacts[0].gap_m: found 0.03, but the initial displacements of structures[0] and [1] close that gap and overlap by 0.01 m; allowed is a gap that they leave open, or other initial_displacement_m"#);
}

#[test]
fn extreme_duration_between_two_steps() {
    let message = refused("duration", |scene| scene["duration_s"] = json!(10.002));
    assert_snapshot!(message, @r#"error: scene.json, line 13, column 3: scene "two structures": duration_s: found 10.002, allowed a whole number of the method's time_step_s, at least 1"#);
    let message = refused("long", |scene| scene["duration_s"] = json!(1e6));
    assert_snapshot!(message, @r#"error: scene.json, line 13, column 3: scene "two structures": duration_s: found 1000000, of which the run would take 4.0e8 time steps times floors, allowed 1e8 (`budget.steps`): shorten it, take a longer time_step_s, or make the budget more"#);
}

#[test]
fn extreme_time_step_zero() {
    let message = refused("time_step", |scene| {
        scene["method"]["central_difference"]["time_step_s"] = json!(0);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 16, column 7: scene "two structures": method.central_difference.time_step_s: found 0, allowed a finite number > 0"#);
}

#[test]
fn extreme_gravity_zero() {
    let message = refused("gravity", |scene| {
        scene["record"]["gravity_m_per_s2"] = json!(0);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 22, column 5: scene "two structures": record.gravity_m_per_s2: found 0, allowed a finite number > 0"#);
}

#[test]
fn extreme_beta_above_one_half() {
    let message = refused("beta", |scene| {
        scene["method"] = json!({"newmark": {"time_step_s": 0.01, "beta": 0.6, "gamma": 0.5}});
    });
    assert_snapshot!(message, @r#"error: scene.json, line 16, column 7: scene "two structures": method.newmark.beta: found 0.6, allowed 0 to 0.5"#);
}

#[test]
fn extreme_time_step_beyond_the_stability_limit() {
    let message = refused("unstable", |scene| {
        scene["method"]["central_difference"]["time_step_s"] = json!(0.1);
    });
    assert_snapshot!(message, @r#"error: scene.json, line 16, column 7: scene "two structures": method.central_difference.time_step_s: found 0.1, allowed less than 0.09549105 (structures[1], "stiff", grows without bound from there on); contact can ask for less; `pounding check` says what its time step can follow, --force runs it while its numbers are finite"#);
}

/// The contact is far too stiff for the time step: it throws the structures apart, and the second contact overflows.
#[test]
fn extreme_run_that_diverges() {
    let message = refused("diverges", |scene| {
        let weak = &mut scene["structures"][0]["sdof"];
        weak["initial_velocity_m_per_s"] = json!(1);
        weak["yield_force_n"] = Value::Null;
        let law = &mut scene["contacts"][0]["law"]["nonlinear_viscoelastic"];
        law["impact_stiffness_n_per_m1_5"] = json!(1e300);
    });
    assert_snapshot!(message, @r#"error: scene.json: scene "two structures": structure 0 at t = 0.6450 s: the response is no longer a finite number; use a smaller time step (found 0.005 s); structure 0 is "weak""#);
}

/// A record given as a scene was read as TOML, and its first line was called bad syntax.
#[test]
fn issue_a_record_is_no_scene() {
    let folder = folder("record_as_scene");
    let text = "PEER\nX\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .01 SEC\n .1 .2\n";
    fs::write(folder.join("q.AT2"), text).expect("written");
    assert_snapshot!(refusal(&pounding(&folder, &["run", "q.AT2"])), @"error: q.AT2: found a record (PEER AT2), allowed is a scene, a TOML or JSON file; `pounding init --record q.AT2` writes one that it shakes");
    assert_eq!(pounding(&folder, &["init", "--record", "q.AT2"]).code, 0, "as it says");
}

/// The message named the line of the table, not that of the field.
#[test]
fn issue_the_line_of_a_field_is_named() {
    let folder = folder("lines_of_fields");
    pounding(&folder, &["init", "scene.toml"]);
    pounding(&folder, &["init", "scene.json"]);
    for (field, before, after, said) in [
        (
            "period_s",
            "1.0",
            "-1.0",
            "structures[0].sdof.period_s: found -1, allowed a finite number > 0",
        ),
        (
            "gap_m",
            "0.02",
            "-0.02",
            "contacts[0].gap_m: found -0.02, allowed a finite number >= 0",
        ),
        (
            "height_m",
            "12.0",
            "\"12 m\"",
            "structures[0].sdof.height_m: found the text \"12 m\", allowed is a number",
        ),
    ] {
        for (name, begin, between) in [("scene.toml", "\n", " = "), ("scene.json", "\"", "\": ")] {
            let text = fs::read_to_string(folder.join(name)).expect("there");
            let from = format!("{begin}{field}{between}{before}");
            assert!(text.contains(&from), "{name} holds {from}");
            let text = text.replacen(&from, &format!("{begin}{field}{between}{after}"), 1);
            let line = text.lines().position(|line| line.contains(&format!("{between}{after}")));
            let line = line.expect("the field") + 1;
            let bad = format!("bad-{name}");
            fs::write(folder.join(&bad), text).expect("written");
            let message = refusal(&pounding(&folder, &["check", &bad]));
            assert!(message.starts_with(&format!("error: {bad}, line {line}, column ")), "{message}");
            assert!(message.ends_with(said), "{message}");
        }
    }
}
