//! Choices by a word, or by a table with settings.

use std::path::Path;

use insta::assert_snapshot;
use pounding_scene::{Method, Scene, Structure};

use super::{TOML, changed, refusal, scene};

#[test]
fn limit_a_wall_is_a_word_or_an_empty_table() {
    let with = |wall: &str| {
        scene(
            &changed("[[structures]]", &format!("[[structures]]\n{wall}\n\n[[structures]]")),
            "x.toml",
        )
    };
    let of_toml = with("wall = {}");
    assert_eq!(of_toml.structures[0], Structure::Wall);
    assert_eq!(with("[structures.wall]"), of_toml);
    let json = serde_json::to_string(&of_toml).expect("a scene is written");
    assert!(json.contains("[\"wall\","), "{json}");
    for wall in ["[\"wall\",", "[{\"wall\": {}},", "[{\"wall\":{ } },"] {
        assert_eq!(scene(&json.replace("[\"wall\",", wall), "x.json"), of_toml, "{wall}");
    }
}

#[test]
fn limit_the_exact_method_is_a_word_or_an_empty_table() {
    let name = "name = \"two towers\"";
    for method in ["method = \"exact\"", "method = { exact = {} }"] {
        let text = changed(name, &format!("{name}\n{method}"));
        assert_eq!(scene(&text, "x.toml").method, Method::EXACT, "{method}");
    }
    let last = format!("{TOML}\n[method.exact]\n");
    assert_eq!(scene(&last, "x.toml").method, Method::EXACT);
    let json = serde_json::to_string(&scene(TOML, "x.toml")).expect("a scene is written");
    let json = json.replace("{\"exact\":{}}", "\"exact\"");
    assert!(json.contains("\"method\":\"exact\""), "{json}");
    assert_eq!(scene(&json, "x.json").method, Method::EXACT);
}

#[test]
fn extreme_words_alone_that_need_settings() {
    let top = |line: &str| refusal(&changed("name = \"two towers\"", &format!("name = \"x\"\n{line}")));
    assert_snapshot!(top("method = \"hht\""), @r#"scene.toml, line 3, column 10: method: found the word `hht` alone, allowed is a table with its settings, such as {"hht": {"time_step_s": 0.001, "alpha": -0.1}} in JSON, { hht = { time_step_s = 0.001, alpha = -0.1 } } in TOML"#);
    assert_snapshot!(top("method = \"exakt\""), @"scene.toml, line 3, column 10: method: found `exakt`, allowed are `central_difference`, `newmark`, `hht`, `velocity_verlet`, `rk4`, `moreau_jean`, `exact`, `accuracy`; perhaps `exact` is meant");
    assert_snapshot!(top("method = 0.01"), @"scene.toml, line 3, column 10: method: found no choice, allowed is one, the name of one, or a table with one of them and its settings");
    assert_snapshot!(top("method = {}"), @"scene.toml, line 3, column 10: method: found no choice, allowed is one, the name of one, or a table with one of them and its settings");
    assert_snapshot!(top("method = { exact = {}, rk4 = { time_step_s = 0.01 } }"), @"scene.toml, line 3, column 10: method: found both `exact` and `rk4`, allowed is one of them; delete the other");
    assert_snapshot!(top("method = { exact = { time_step_s = 0.01 } }"), @"scene.toml, line 3, column 22: method.exact.time_step_s: found the field `time_step_s`, allowed are `tolerance`, `simultaneous_impacts`");
    assert_snapshot!(refusal(&changed("law.stereomechanical.restitution = 0.65", "law = \"stereomechanical\"")), @r#"scene.toml, line 24, column 7: contacts[0].law: found the word `stereomechanical` alone, allowed is a table with its settings, such as {"stereomechanical": {"restitution": 0.65}} in JSON, { stereomechanical = { restitution = 0.65 } } in TOML"#);
    assert_snapshot!(refusal(&changed("damping.ratio = 0.05", "damping = \"ratio\"")), @r#"scene.toml, line 10, column 11: structures[0].sdof.damping: found the word `ratio` alone, allowed is a table with its settings, such as {"ratio": 0.05} in JSON, { ratio = 0.05 } in TOML"#);
    assert_snapshot!(refusal(&changed("damping.ratio = 0.05", "damping = \"5%\"")), @"scene.toml, line 10, column 11: structures[0].sdof.damping: found `5%`, allowed are `ratio`, `rayleigh`, `two_frequencies`, `modes`");
    assert_snapshot!(refusal(&changed("[[structures]]\n[structures.sdof]\nname = \"old\"", "[[structures]]\nwall = { height_m = 3 }\n[[structures]]\n[structures.sdof]\nname = \"old\"")), @"scene.toml, line 6, column 10: structures[0].wall.height_m: found the field `height_m`, allowed are none; delete it");
    assert_snapshot!(refusal(&changed("record.file = \"record.csv\"", "record.generated = \"ricker\"")), @r#"scene.toml, line 3, column 20: record.generated: found the word `ricker` alone, allowed is a table with its settings, such as {"ricker": {"amplitude_m_per_s2": 2.0, "frequency_hz": 1.0, "time_step_s": 0.01}} in JSON, { ricker = { amplitude_m_per_s2 = 2.0, frequency_hz = 1.0, time_step_s = 0.01 } } in TOML"#);
    let json = |from: &str, to: &str| {
        let text = serde_json::to_string_pretty(&scene(TOML, "x.toml")).expect("a scene is written");
        assert!(text.contains(from), "{text}");
        let text = text.replacen(from, to, 1);
        let refused = Scene::parse(text.as_bytes(), Path::new("scene.json"));
        refused.expect_err("a scene that is refused").to_string()
    };
    let exact = "\"exact\": {}";
    let method = "\"method\": {\n    \"exact\": {}\n  }";
    assert_snapshot!(json(method, "\"method\": \"newmark\""), @r#"scene.json, line 53, column 13: method: found the word `newmark` alone, allowed is a table with its settings, such as {"newmark": {"time_step_s": 0.001, "beta": 0.25, "gamma": 0.5}} in JSON, { newmark = { time_step_s = 0.001, beta = 0.25, gamma = 0.5 } } in TOML"#);
    assert_snapshot!(json(method, "\"method\": null"), @"scene.json, line 53, column 13: method: found no choice, allowed is one, the name of one, or a table with one of them and its settings");
    assert_snapshot!(json(method, "\"method\": {}"), @"scene.json, line 53, column 13: method: found no choice, allowed is one, the name of one, or a table with one of them and its settings");
    assert_snapshot!(json(exact, "\"exact\": {}, \"rk4\": {}"), @"scene.json, line 53, column 13: method: found both `exact` and `rk4`, allowed is one of them; delete the other");
    assert_snapshot!(json(exact, "\"exact\": 1e-6"), @"scene.json, line 54, column 14: method.exact: found the number 1e-6, allowed is a table of fields");
    assert_snapshot!(json("\"structures\": [", "\"structures\": [\"sdof\","), @r#"scene.json, line 9, column 18: structures[0]: found the word `sdof` alone, allowed is a table with its settings, such as {"sdof": {"name": "tower", "mass_kg": 3e5, "period_s": 0.8, "damping": {"ratio": 0.05}}} in JSON, { sdof = { name = "tower", mass_kg = 3e5, period_s = 0.8, damping = { ratio = 0.05 } } } in TOML"#);
    assert_snapshot!(json("\"structures\": [", "\"structures\": [{\"wall\": 3},"), @"scene.json, line 9, column 27: structures[0].wall: found the number 3, allowed is a table of fields");
}
