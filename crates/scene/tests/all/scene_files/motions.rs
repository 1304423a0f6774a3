//! Ground motions from files and formulas, and refusals of them.

use std::path::Path;

use insta::assert_snapshot;
use pounding_scene::{STANDARD_GRAVITY, Scene, Simulation, response_spectrum};

use super::changed;

/// The scene with another record; it is prepared without a file.
fn shaken(record: &str) -> Result<Simulation, String> {
    let text = changed("record.file = \"record.csv\"", record);
    let scene = Scene::parse(text.as_bytes(), Path::new("scene.toml")).map_err(|error| error.to_string())?;
    Simulation::new(&scene, Path::new("")).map_err(|error| error.to_string())
}

#[test]
fn reference_motions_without_a_file() {
    let harmonic = "record.generated.harmonic = { amplitude_m_per_s2 = 2, frequency_hz = 0.5, duration_s = 4, time_step_s = 0.01 }";
    let prepared = shaken(harmonic).expect("a harmonic motion");
    let (time, peak) = prepared.record().peak();
    assert!((time - 0.5).abs() < 1e-12 && (peak - 2.0).abs() < 1e-12, "{peak} at {time}");
    let scaled =
        format!("{harmonic}\nrecord.scale_to = {{ pga_g = 0.1 }}\nrecord.gravity_m_per_s2 = 10\nrecord.scale = 3\nrecord.reversed = true");
    let (_, peak) = shaken(&scaled).expect("a harmonic motion").record().peak();
    assert!((peak + 3.0).abs() < 1e-12, "{peak}");
    let soft = "record.generated.stochastic = { ground = \"soft\", pga_m_per_s2 = 3, strong_from_s = 2, strong_until_s = 8, \
                decay_per_s = 0.5, duration_s = 16, time_step_s = 0.01, seed = 7 }";
    let (_, peak) = shaken(soft).expect("a stochastic motion").record().peak();
    assert!((peak.abs() - 3.0).abs() < 1e-12, "{peak}");
    let by_sa = format!("{soft}\nrecord.scale_to.sa = {{ period_s = 0.8, sa_g = 0.5 }}");
    let prepared = shaken(&by_sa).expect("a stochastic motion");
    let spectrum = response_spectrum(prepared.record(), &[0.8], 0.05).expect("a spectrum");
    let found = spectrum[0].pseudo_acceleration / STANDARD_GRAVITY;
    assert!((found - 0.5).abs() < 1e-12, "{found}");
}

#[test]
fn extreme_motions_that_cannot_be() {
    let refused = |record: &str| shaken(record).expect_err("a motion that is refused");
    let harmonic = "record.generated.harmonic = { amplitude_m_per_s2 = 2, frequency_hz = 0.5, duration_s = 4, time_step_s = 0.01 }";
    assert_snapshot!(refused(&format!("{harmonic}\nrecord.unit = \"g\"")), @"scene.toml, line 3, column 1: record: found `unit` beside `generated`, allowed is it beside `file`; delete it");
    assert_snapshot!(refused(&format!("{harmonic}\nrecord.file = \"x\"")), @"scene.toml, line 3, column 1: record: found both `file` and `generated`, allowed is one of them; delete the other");
    assert_snapshot!(refused("record.file = \"x\"\nrecord.unit = \"kg\""), @"scene.toml, line 4, column 15: record.unit: found `kg`, allowed are `g`, `m_per_s2`, `cm_per_s2`, `mm_per_s2`, `mg`, `g_per_10`");
    let with = |more: &str| refused(&format!("{harmonic}\nrecord.{more}"));
    assert_snapshot!(with("band_pass = { low_hz = 1, high_hz = 50 }"), @r#"scene "two towers": record.band_pass.high_hz: found 50 Hz, allowed is below 50 Hz, half of one over the time step; lower it"#);
    assert_snapshot!(with("band_pass = { low_hz = 0, high_hz = 5 }"), @r#"scene "two towers": record.band_pass.low_hz: found 0, allowed a number of Hz, at least 1e-6 over the time step"#);
    assert_snapshot!(with("band_pass = { low_hz = 5, high_hz = 2 }"), @r#"scene "two towers": record.band_pass: found a low corner (below it the motion is taken away) of 5 Hz and a high one (above it) of 2 Hz, allowed is the first below the second; exchange them"#);
    assert_snapshot!(with("band_pass = { low_hz = 1, high_hz = 2, order = 11 }"), @r#"scene "two towers": record.band_pass.order: found 11, allowed 1 to 10"#);
    assert_snapshot!(with("resample_s = 0"), @r#"scene "two towers": record.resample_s: found 0, allowed a finite number > 0"#);
    assert_snapshot!(with("resample_s = 1e-12"), @r#"scene "two towers": record.resample_s: found 1e-12 s, which over 4 s makes more than 10000000 samples, allowed is a longer step"#);
    assert_snapshot!(with("scale_to.pga_g = -1"), @r#"scene "two towers": record.scale_to.pga_g: found -1, allowed a number >= 0 that is finite in m/s²"#);
    assert_snapshot!(with("scale_to.pga_g = inf"), @r#"scene "two towers": record.scale_to.pga_g: found inf, allowed a number >= 0 that is finite in m/s²"#);
    assert_snapshot!(with("scale_to.sa = { period_s = -1, sa_g = 1 }"), @r#"scene "two towers": record.scale_to.sa.period_s: found -1, allowed 0 s, or 1e-6 s to 1e6 s"#);
    assert_snapshot!(with("scale_to.sa = { period_s = 1, sa_g = 0 }"), @r#"scene "two towers": record.scale_to.sa.sa_g: found 0, allowed a number > 0 that is finite in m/s²"#);
    assert_snapshot!(with("scale_to.sa = { period_s = 1, sa_g = 1, damping_ratio = 2 }"), @r#"scene "two towers": record.scale_to.sa.damping_ratio: found 2, allowed 0 to 1"#);
    assert_snapshot!(with("scale = 1e308"), @r#"scene "two towers": record.scale: found 1e308, allowed 0, or numbers from 1e-100 to 1e100 in magnitude"#);
    assert_snapshot!(with("scale = nan"), @r#"scene "two towers": record.scale: found NaN, allowed 0, or numbers from 1e-100 to 1e100 in magnitude"#);
    assert_snapshot!(with("gravity_m_per_s2 = -9.81"), @r#"scene "two towers": record.gravity_m_per_s2: found -9.81, allowed a finite number > 0"#);
    let at_rest = harmonic.replace("m_per_s2 = 2", "m_per_s2 = 0");
    assert_snapshot!(refused(&format!("{at_rest}\nrecord.scale_to.pga_g = 1")), @r#"scene "two towers": record.scale_to.pga_g: found a motion without any acceleration, allowed is one that a factor can scale; take another"#);
    assert_snapshot!(refused(&format!("{at_rest}\nrecord.scale_to.sa = {{ period_s = 1, sa_g = 1 }}")), @r#"scene "two towers": record.scale_to.sa: found a motion without any acceleration, allowed is one that a factor can scale; take another"#);
    let short = harmonic.replace("duration_s = 4", "duration_s = 0.05");
    assert_snapshot!(refused(&format!("{short}\nrecord.band_pass = {{ low_hz = 1, high_hz = 2 }}")), @r#"scene "two towers": record.band_pass: found a record of 6 samples, allowed are 28 or more to filter forward and backward at order 4; lower `record.band_pass.order`, or set `record.band_pass.causal`"#);
}

#[test]
fn extreme_formulas_that_cannot_be() {
    let changed = |motion: &str, from: &str, to: &str| {
        assert!(motion.contains(from), "{from}");
        shaken(&format!("record.generated.{}", motion.replacen(from, to, 1))).expect_err("a motion that is refused")
    };
    let harmonic = "harmonic = { amplitude_m_per_s2 = 2, frequency_hz = 0.5, duration_s = 4, time_step_s = 0.01 }";
    let harmonic = |from: &str, to: &str| changed(harmonic, from, to);
    assert_snapshot!(harmonic("= 0.5", "= 60"), @r#"scene "two towers": record.generated.harmonic.frequency_hz: found 60 Hz, allowed is below 50 Hz, half of one over the time step; lower it"#);
    assert_snapshot!(harmonic("= 0.5", "= 0"), @r#"scene "two towers": record.generated.harmonic.frequency_hz: found 0, allowed a number > 0 Hz"#);
    assert_snapshot!(harmonic("= 2", "= inf"), @r#"scene "two towers": record.generated.harmonic.amplitude_m_per_s2: found inf, allowed a finite number of m/s²"#);
    assert_snapshot!(harmonic("= 4", "= -4"), @r#"scene "two towers": record.generated.harmonic.duration_s: found -4, allowed a number >= 0 s"#);
    assert_snapshot!(harmonic("= 0.01", "= -0.01"), @r#"scene "two towers": record.generated.harmonic.time_step_s: found -0.01 s, allowed are more than 0 s and up to 1e6 s; correct it"#);
    assert_snapshot!(harmonic("= 0.01", "= 1e-9"), @r#"scene "two towers": record.generated.harmonic.time_step_s: found 1e-9 s, which over 4 s makes more than 10000000 samples, allowed is a longer step"#);
    assert_snapshot!(harmonic("duration_s", "phase_rad = nan, duration_s"), @r#"scene "two towers": record.generated.harmonic.phase_rad: found NaN, allowed a finite number of rad"#);
    assert_snapshot!(harmonic("duration_s", "ramp_periods = 2, duration_s"), @r#"scene "two towers": record.generated.harmonic.ramp_periods: found 2, allowed a number >= 0, such that two ramps fit into the duration"#);
    let ricker = "ricker = { amplitude_m_per_s2 = 2, frequency_hz = 60, time_step_s = 0.01 }";
    assert_snapshot!(changed(ricker, "2", "2"), @r#"scene "two towers": record.generated.ricker.frequency_hz: found 60 Hz, allowed is below 50 Hz, half of one over the time step; lower it"#);
    let half_sine = "half_sine = { amplitude_m_per_s2 = 2, duration_s = 0.015, time_step_s = 0.01 }";
    assert_snapshot!(changed(half_sine, "2", "2"), @r#"scene "two towers": record.generated.half_sine.duration_s: found 0.015, allowed at least two time steps; shorten the time step"#);
    let stochastic = "stochastic = { ground = \"soft\", pga_m_per_s2 = 3, strong_from_s = 2, strong_until_s = 8, \
                      decay_per_s = 0.5, duration_s = 16, time_step_s = 0.02, seed = 7 }";
    let stochastic = |from: &str, to: &str| changed(stochastic, from, to);
    assert_snapshot!(stochastic("= 3", "= -3"), @r#"scene "two towers": record.generated.stochastic.pga_m_per_s2: found -3, allowed a finite number >= 0 m/s²"#);
    assert_snapshot!(stochastic("= 2", "= 0"), @r#"scene "two towers": record.generated.stochastic.strong_from_s: found 0, allowed a number > 0 s"#);
    assert_snapshot!(stochastic("= 8", "= 1"), @r#"scene "two towers": record.generated.stochastic.strong_until_s: found 1, allowed a time not before the one at which the strong shaking begins"#);
    assert_snapshot!(stochastic("= 0.5", "= 0"), @r#"scene "two towers": record.generated.stochastic.decay_per_s: found 0, allowed a number > 0 1/s"#);
    assert_snapshot!(stochastic("seed", "cutoff_hz = 25, seed"), @r#"scene "two towers": record.generated.stochastic.cutoff_hz: found 25 Hz, allowed is below 25 Hz, half of one over the time step; lower it"#);
    assert_snapshot!(stochastic("seed", "cutoff_hz = 0.01, seed"), @r#"scene "two towers": record.generated.stochastic.cutoff_hz: found 0.01, allowed at least one over the duration (of whole time steps), in Hz"#);
    assert_snapshot!(stochastic("= 16", "= 0.02"), @r#"scene "two towers": record.generated.stochastic.duration_s: found 0.02, allowed at least 0.04 s and 2.5 times time_step_s, a period of the usual cutoff_hz"#);
    assert_snapshot!(stochastic("= 16", "= 0"), @r#"scene "two towers": record.generated.stochastic.duration_s: found 0, allowed a number > 0 s"#);
    assert_snapshot!(stochastic("= 16", "= 1e5"), @r#"scene "two towers": record.generated.stochastic.duration_s: found 100000, allowed one for which cutoff × duration × number of samples is at most 1e10"#);
    let ground = "{ filters = { angular_frequency_rad_per_s = 15, damping_ratio = 0.6, \
                  high_pass_angular_frequency_rad_per_s = 1.5, high_pass_damping_ratio = 0.6 } }";
    let filters = |from: &str, to: &str| stochastic("\"soft\"", &ground.replacen(from, to, 1));
    assert_snapshot!(filters("= 15", "= 0"), @r#"scene "two towers": record.generated.stochastic.ground.filters.angular_frequency_rad_per_s: found 0, allowed a finite number > 0"#);
    assert_snapshot!(filters("= 0.6", "= 0"), @r#"scene "two towers": record.generated.stochastic.ground.filters.damping_ratio: found 0, allowed a finite number > 0"#);
    assert_snapshot!(filters("= 1.5", "= 0"), @r#"scene "two towers": record.generated.stochastic.ground.filters.high_pass_angular_frequency_rad_per_s: found 0, allowed a finite number > 0"#);
    assert_snapshot!(filters("= 0.6 }", "= 0 }"), @r#"scene "two towers": record.generated.stochastic.ground.filters.high_pass_damping_ratio: found 0, allowed a finite number > 0"#);
    assert_snapshot!(stochastic("\"soft\"", "{ soft = {} }"), @"scene.toml, line 3, column 51: record.generated.stochastic.ground.soft: found a table, allowed is the word alone");
}

/// A time step of 0.02 s does not hold 25 Hz, the default of the highest frequency. It was refused as if the user had written it.
#[test]
fn issue_the_highest_frequency_follows_the_time_step() {
    let peak = |time_step: &str, cutoff: &str| {
        let motion = format!(
            "record.generated.stochastic = {{ ground = \"firm\", pga_m_per_s2 = 3, strong_from_s = 2, strong_until_s = 8, \
             decay_per_s = 0.5, duration_s = 16, time_step_s = {time_step}, {cutoff} seed = 7 }}"
        );
        let prepared = shaken(&motion).expect("a stochastic motion");
        prepared.record().source().to_owned()
    };
    for (time_step, cutoff) in [("0.02", 20), ("0.1", 4), ("0.01", 25), ("0.005", 25)] {
        let source = peak(time_step, "");
        assert!(source.ends_with(&format!("up to {cutoff} Hz")), "{source}");
        assert_eq!(peak(time_step, &format!("cutoff_hz = {cutoff},")), source);
    }
}
