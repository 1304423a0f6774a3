//! Tests of `pounding assess` for unknown neighbours, bumpers and animations.

use std::fs;

use serde_json::Value;

use crate::assess::{TOWERS, assess, found, workplace};
use crate::pounding;

/// A building with an unknown neighbour.
const UNKNOWN: &str = r#"
name = "unknown"
record.file = "el-centro-1940-ns-chopra.csv"
structures = [{ building = { name = "Own", period_s = 0.8, damping.ratio = 0.05, storeys = [{ mass_kg = 4e5, height_m = 3.5, repeat = 2 }] } }]
[neighbour.unknown]
period_s = [0.3, 1.2]
mass_ratio = [0.5, 2]
samples = 4
[neighbour.unknown.contact]
gap_m = 0.03
law.hertz_damp = { impact_stiffness_n_per_m1_5 = 2.75e9, restitution = 0.65 }
"#;

/// The periods of the neighbours are in the middle of equal parts of the logarithm. Each needs the gap of a known neighbour.
#[test]
fn reference_an_unknown_neighbour_is_each_that_it_may_be() {
    let work = workplace("assess_unknown", UNKNOWN);
    let all = found(&work, &["--scale", "pga=0.4g"]);
    let drawn = all["neighbour"]["drawn"].as_array().expect("neighbours");
    assert_eq!((drawn.len(), &all["runs"]), (4, &16.into()));
    for (index, one) in drawn.iter().enumerate() {
        let period = one["period_s"].as_f64().expect("a period");
        let wanted = 0.3 * libm::pow(4.0, (index as f64 + 0.5) / 4.0);
        assert!((period / wanted - 1.0).abs() < 1e-12, "{period} {wanted}");
    }
    let one = &drawn[2];
    let number = |name: &str| one[name].as_f64().expect("a number");
    let mass = number("mass_ratio") * 8e5 / 2.0;
    let known = UNKNOWN.split("[neighbour").next().expect("a scene");
    let known = known.replace(
        "} }]",
        &format!(
            "}} }}, {{ building = {{ name = \"N\", period_s = {}, damping.ratio = 0.05, storeys = [{{ mass_kg = {mass}, height_m = 3.5, \
             repeat = 2 }}] }} }}]",
            number("period_s")
        ),
    );
    fs::write(work.join("scene.toml"), known).expect("it can be written");
    let known = found(&work, &["--scale", "pga=0.4g"]);
    let needed = |of: &Value| of["largest"].as_f64().expect("a width");
    let (known, unknown) = (needed(&known["gaps"][0]["required_m"]), needed(&one["required_m"]));
    assert!((known / unknown - 1.0).abs() < 1e-9, "{known} {unknown}");
}

/// The answer has equal bytes with any number of threads, and names the probability first.
#[test]
fn limit_an_unknown_neighbour_gives_the_same_bytes() {
    let work = workplace("assess_unknown_bytes", UNKNOWN);
    let with = |threads: &str| {
        let ended = assert_cmd::Command::cargo_bin("pounding")
            .expect("it is built")
            .args([
                "assess",
                "scene.toml",
                "--records",
                "records",
                "--out",
                threads,
                "--bumper",
                "k=50MN/m",
            ])
            .env("RAYON_NUM_THREADS", threads)
            .current_dir(&work)
            .output()
            .expect("it runs");
        assert!(ended.status.success(), "{ended:?}");
        let names = ["assess.csv", "assess.json", "report.html", "animation.svg", "neighbour.svg"];
        names.map(|name| fs::read(work.join(threads).join(name)).expect(name))
    };
    assert!(with("1") == with("3"));
    let said = assess(&work, &[]).stdout;
    let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
    for wanted in [
        "The neighbour of Own is not known. Drawn: 4 with",
        "84 %: ",
        "is enough in every run beside",
    ] {
        assert!(said.contains(wanted), "{wanted}: {said}");
    }
    let table = String::from_utf8(fs::read(work.join("1/assess.csv")).expect("a table")).expect("text");
    assert!(table.contains("bumper_compression_m") && table.starts_with("record,reversed,scale_factor,neighbour_period_s,"));
}

#[test]
fn extreme_unknown_neighbours_that_are_refused() {
    let said = |from: &str, to: &str| {
        assert!(UNKNOWN.contains(from), "{from}");
        let work = workplace("assess_unknown_refused", &UNKNOWN.replace(from, to));
        assess(&work, &[]).stderr
    };
    let work = workplace("assess_unknown_run", UNKNOWN);
    let run = pounding(&work, &["run", "scene.toml"]).stderr;
    let all = [
        said("period_s = [0.3, 1.2]", "period_s = [0.3, 0.2]"),
        said("mass_ratio = [0.5, 2]", "mass_ratio = [0, 2]"),
        said("samples = 4", "samples = 0"),
        said("samples = 4", "samples = 4\ndamping_ratio = 1"),
        said("gap_m = 0.03", "gap_m = -0.03"),
        said("structures = [{", "structures = [{ wall = {} }, {"),
        run,
    ];
    insta::assert_snapshot!(all.join("\n"));
}

/// A soft bumper in a wide gap reduces the pounding force; a narrow gap gets no bumper.
#[test]
fn limit_a_soft_bumper_in_a_wide_gap_takes_the_force() {
    let wide = TOWERS.replace("gap_m = 0.04", "gap_m = 0.2");
    let work = workplace("assess_bumper", &wide);
    let all = found(&work, &["--scale", "pga=0.5g", "--bumper", "k=20MN/m"]);
    let bumper = &all["bumper"];
    let median = |of: &Value| of["median"].as_f64().expect("a ratio");
    assert!(median(&bumper["force_with_over_without"]) < 0.7, "{bumper}");
    let mut floors = bumper["floors"].as_array().expect("floors").iter();
    assert!(
        floors.any(|floor| median(&floor["acceleration_with_over_without"]) < 0.7),
        "{bumper}"
    );
    for one in bumper["bumpers"].as_array().expect("bumpers") {
        assert!((one["thickness_m"].as_f64().expect("a width") - 0.1).abs() < 1e-12);
    }
    let proposals = |all: &Value| all["proposals"].to_string();
    assert!(!proposals(&all).contains("help"), "{}", proposals(&all));
    // The narrow gap has no room for a soft bumper, and a stiff one is no bumper.
    let narrow = workplace("assess_no_bumper", TOWERS);
    for bumper in ["proposed", "k=90000MN/m"] {
        let all = found(&narrow, &["--scale", "pga=1.2g", "--bumper", bumper]);
        assert!(!proposals(&all).contains("help"), "{}", proposals(&all));
    }
    assert!(found(&work, &[])["bumper"].is_null(), "none unless asked for");
    let refused = assess(&work, &["--bumper", "k=20"]).stderr;
    assert!(refused.contains("has no unit"), "{refused}");
}

/// The animation needs no script, is well formed, and stops for readers who prefer reduced motion.
#[test]
fn reference_the_report_moves_without_a_script() {
    let work = workplace("assess_animation", TOWERS);
    let ended = assess(&work, &["--scale", "pga=0.6g", "--out", "out"]);
    assert_eq!(ended.code, 0, "{}", ended.stderr);
    let read = |name: &str| fs::read_to_string(work.join("out").join(name)).expect(name);
    let (svg, page) = (read("animation.svg"), read("report.html"));
    roxmltree::Document::parse(&svg).expect("it is well formed");
    for wanted in ["@keyframes film-0", "prefers-reduced-motion:reduce", "prefers-color-scheme:dark"] {
        assert!(svg.contains(wanted), "{wanted}");
    }
    assert!(page.contains("class=\"film\"") && !page.contains("<script"));
    assert!(page.contains("class=\"appendix\"") && page.contains("counter(page)"));
}

/// Where nothing touched, the folder had a figure that its page did not show.
#[test]
fn issue_every_figure_of_the_folder_is_on_the_page() {
    let apart = UNKNOWN.split("[neighbour.unknown.contact]").next().expect("a scene");
    for (name, scene) in [("assess_figures_apart", apart), ("assess_figures", UNKNOWN)] {
        let work = workplace(name, scene);
        let ended = assess(&work, &["--scale", "pga=0.4g", "--out", "out"]);
        assert_eq!(ended.code, 0, "{}", ended.stderr);
        let files = fs::read_dir(work.join("out")).expect("a folder");
        let svgs = files.filter(|file| {
            file.as_ref()
                .is_ok_and(|file| file.path().extension().is_some_and(|end| end == "svg"))
        });
        let page = fs::read_to_string(work.join("out/report.html")).expect("a page");
        assert_eq!(page.matches("<figcaption>").count(), svgs.count(), "{name}");
    }
}
