//! Sweeps: every row is the run of a scene that one could write by hand, in an order given by the run number alone.

mod accuracy;
mod alone;
mod checked;
mod collapses;
mod motions;
mod parts;
mod stripes;
mod towers;

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use pounding_files::Existing;
use pounding_scene::{Scene, Simulation};
use pounding_sweep::{Parts, Shard, Sweep, merge};
use pounding_text::Refused;
use serde_json::{Value, json};

/// A stop flag that is set.
pub(crate) static STOPPED: AtomicBool = AtomicBool::new(true);

/// A folder for a test.
fn folder(test: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("sweep").join(test);
    if folder.exists() {
        fs::remove_dir_all(&folder).expect("the folder of the last run can go");
    }
    fs::create_dir_all(&folder).expect("the folder can be made");
    folder
}

/// Two structures under half a sine; the left one yields.
fn scene() -> Value {
    json!({
        "name": "two",
        "record": {"generated": {"half_sine": {"amplitude_m_per_s2": 4.0, "duration_s": 0.4, "time_step_s": 0.01}}},
        "duration_s": 2.0,
        "structures": [
            {"sdof": {"name": "left", "mass_kg": 1e5, "period_s": 0.8, "damping": {"ratio": 0.05}, "yield_displacement_m": 0.03}},
            {"sdof": {"name": "right", "mass_kg": 2e5, "period_s": 0.4, "damping": {"ratio": 0.05}}},
        ],
        "contacts": [{"gap_m": 0.01, "law": {"linear_spring": {"impact_stiffness_n_per_m": 1e8}}}],
        "method": {"central_difference": {"time_step_s": 0.002}},
    })
}

fn sweep(folder: &Path, words: &Value) -> Sweep {
    read(folder, words, None).expect("a sweep")
}

/// The same, until somebody says stop.
pub(crate) fn read(folder: &Path, words: &Value, stop: Option<&'static AtomicBool>) -> Result<Sweep, Refused> {
    let path = folder.join("sweep.json");
    fs::write(&path, words.to_string()).expect("a file");
    Sweep::read(&path, stop)
}

/// The parts of a table at `out`.
fn opened(sweep: &Sweep, out: &Path, shard: Shard) -> Parts {
    let parts = Parts::open(sweep, out, shard, false).expect("parts");
    parts.expect("no table was finished before")
}

/// The rows of a table, field by field.
fn table(sweep: &Sweep, runs: std::ops::Range<u64>) -> Vec<Vec<String>> {
    let bytes = sweep.rows(&sweep.batch(runs));
    let mut reader = csv::ReaderBuilder::new().has_headers(false).from_reader(&bytes[..]);
    let rows = reader.records().map(|row| row.expect("a row"));
    rows.map(|row| row.iter().map(String::from).collect()).collect()
}

/// A sweep over a law, gaps, masses, a period and the scale of the record.
fn of_everything() -> Value {
    json!({
        "scene": scene(),
        "vary": [
            {"field": "contacts[0].law", "values": [
                {"linear_spring": {"impact_stiffness_n_per_m": 1e8}},
                {"stereomechanical": {"restitution": 0.6}},
            ]},
            {"field": "contacts[*].gap_m", "grid": {"from": 0.0, "to": 0.02, "count": 3}},
            {"fields": ["structures[0].sdof.mass_kg", "structures[1].sdof.mass_kg"], "uniform": {"from": 5e4, "to": 2e5}},
            {"field": "structures[0].sdof.period_s", "log_uniform": {"from": 0.5, "to": 1.5}},
            {"field": "record.scale", "normal": {"mean": 1.0, "standard_deviation": 0.2, "from": 0.5}},
            {"field": "method.central_difference.contact_substeps", "values": [1]},
        ],
        "samples": {"count": 4, "seed": 5, "method": "latin_hypercube"},
        "directions": "both",
        "outputs": {
            "structures": ["peak_displacement_m", "peak_shear_force_n", "ductility", "residual_displacement_at_end_m"],
            "pairs": ["collisions", "first_start_s", "peak_force_n", "total_impulse_n_s"],
        },
    })
}

/// A row by the names of its columns.
struct TableRow<'a> {
    columns: &'a [String],
    fields: &'a [String],
}

impl TableRow<'_> {
    fn field(&self, name: &str) -> &str {
        let index = self.columns.iter().position(|column| column == name);
        &self.fields[index.unwrap_or_else(|| panic!("{name} in {:?}", self.columns))]
    }

    fn number(&self, name: &str) -> Option<f64> {
        self.field(name).parse().ok()
    }

    /// Its scene as a user would write it.
    fn by_hand(&self) -> Scene {
        let mut scene = scene();
        let mass = self.number("structures[0].sdof.mass_kg = structures[1].sdof.mass_kg");
        for structure in 0..2 {
            scene["structures"][structure]["sdof"]["mass_kg"] = json!(mass);
        }
        let period = self.number("structures[0].sdof.period_s");
        scene["structures"][0]["sdof"]["period_s"] = json!(period);
        let law = self.field("contacts[0].law");
        scene["contacts"][0]["law"] = serde_json::from_str(law).expect("a law");
        scene["contacts"][0]["gap_m"] = json!(self.number("contacts[*].gap_m"));
        scene["record"]["scale"] = json!(self.number("record.scale"));
        scene["record"]["reversed"] = json!(self.field("reversed") == "true");
        serde_json::from_value(scene).expect("a scene")
    }
}

/// Fields are set as by a user: each row has the bits of the written scene.
#[test]
fn limit_a_row_is_the_run_of_the_scene_written_by_hand() {
    let folder = folder("by_hand");
    let sweep = sweep(&folder, &of_everything());
    assert_eq!(sweep.n_runs(), 2 * 2 * 3 * 4);
    let (columns, mut ran) = (sweep.columns(), 0);
    for fields in &table(&sweep, 0..sweep.n_runs()) {
        let row = TableRow { columns: &columns, fields };
        let prepared = Simulation::new(&row.by_hand(), Path::new("")).expect("it can be modelled");
        let outcome = match prepared.run(None) {
            Ok(outcome) => outcome,
            Err(error) => {
                assert_eq!(row.field("failed"), error.reason());
                continue;
            }
        };
        ran += 1;
        assert_eq!(row.field("failed"), "");
        let (pair, left, right) = (outcome.of_pair(0), outcome.peaks.of(0), outcome.peaks.of(1));
        for (name, wanted) in [
            ("left: peak_displacement_m", Some(left.displacement.value)),
            ("left: peak_shear_force_n", Some(left.restoring_force.value)),
            ("right: peak_displacement_m", Some(right.displacement.value)),
            ("right: ductility", None),
            ("left - right: collisions", Some(pair.collisions as f64)),
            ("left - right: first_start_s", pair.first.map(|first| first.start)),
            ("left - right: peak_force_n", pair.peak_force.map(|peak| peak.value)),
            ("left - right: total_impulse_n_s", Some(pair.total_impulse)),
        ] {
            let found = row.number(name);
            assert_eq!(found.map(f64::to_bits), wanted.map(f64::to_bits), "{name}");
        }
    }
    assert!(ran >= 24, "{ran} of 48 ran");
}

/// Runs count through the samples first, then through lists and grids, the last one fastest, and through motions last.
#[test]
fn reference_the_order_of_runs() {
    let folder = folder("order");
    let sweep = sweep(
        &folder,
        &json!({
            "scene": scene(),
            "vary": [
                {"field": "contacts[0].gap_m", "values": [0.01, 0.02]},
                {"field": "structures[0].sdof.mass_kg", "uniform": {"from": 1e5, "to": 2e5}},
                {"field": "structures[1].sdof.mass_kg", "grid": {"from": 1e5, "to": 3e5, "count": 3}},
            ],
            "samples": {"count": 2, "seed": 1, "method": "random"},
            "directions": "both",
        }),
    );
    let rows = table(&sweep, 0..sweep.n_runs());
    let runs: Vec<_> = rows.iter().map(|row| row[0].clone()).collect();
    assert!(runs.into_iter().eq((0..24).map(|run| run.to_string())));
    let picked: Vec<_> = rows.iter().map(|row| [&*row[2], &*row[3], &*row[5]]).collect();
    assert_eq!(
        picked[..4],
        [
            ["false", "0.01", "100000"],
            ["false", "0.01", "100000"],
            ["false", "0.01", "200000"],
            ["false", "0.01", "200000"],
        ]
    );
    assert_eq!(picked[6][1], "0.02");
    assert_eq!(picked[12][0], "true");
    // Every grid point has the same samples.
    assert_eq!(rows[0][4], rows[2][4]);
    assert_eq!(rows[1][4], rows[23][4]);
    assert_ne!(rows[0][4], rows[1][4]);
}

/// Any range of runs gives the rows of the whole sweep.
#[test]
fn limit_a_range_of_runs_is_a_piece_of_the_whole() {
    let folder = folder("ranges");
    let sweep = sweep(
        &folder,
        &json!({
            "scene": scene(),
            "vary": [{"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}}],
            "samples": {"count": 20, "seed": 9, "method": "sobol"},
            "directions": "both",
        }),
    );
    let whole = table(&sweep, 0..40);
    for range in [0..1, 7..8, 13..29, 19..21, 39..40] {
        let (start, end) = (range.start, range.end);
        let piece = usize::try_from(start).expect("small")..usize::try_from(end).expect("small");
        assert_eq!(table(&sweep, range), whole[piece]);
    }
}

/// Runs that cannot be modelled, with a too long time step, or with an initial overlap are rows with their reasons.
#[test]
fn extreme_runs_that_fail_are_rows() {
    let folder = folder("failed");
    let sweep = sweep(
        &folder,
        &json!({
            "scene": scene(),
            "vary": [
                {"field": "structures[0].sdof.period_s", "values": [0.8, 0.004]},
                {"field": "structures[0].sdof.initial_displacement_m", "values": [0.0, 0.05]},
                {"field": "structures[1].sdof.mass_kg", "normal": {"mean": 1e5, "standard_deviation": 1e5}},
            ],
            "samples": {"count": 40, "seed": 2, "method": "random"},
        }),
    );
    let rows = table(&sweep, 0..sweep.n_runs());
    let reasons = |begin: &str| {
        let begins = |row: &&Vec<String>| row.last().is_some_and(|reason| reason.contains(begin));
        rows.iter().filter(begins).count()
    };
    assert!(reasons("structures[1].sdof.period_s") + reasons("mass_kg: found -") > 5, "{rows:?}");
    assert!(reasons("allowed less than") > 20, "{rows:?}");
    assert!(reasons("overlap by") > 20, "{rows:?}");
    let ran = rows.iter().filter(|row| row.last().is_some_and(String::is_empty)).count();
    assert!((20..40).contains(&ran), "{ran}");
    // A failed row has its values, and no results.
    let failed = rows.iter().find(|row| row.last().is_some_and(|reason| !reason.is_empty()));
    let failed = failed.expect("some failed");
    // After run, record, direction and three fields.
    let results = 6..failed.len() - 1;
    assert!(failed[results].iter().all(String::is_empty), "{failed:?}");
}

/// Shards and interruptions give the bytes of an uninterrupted run.
#[test]
fn limit_shards_make_the_bytes_of_the_whole() {
    let folder = folder("shards");
    let words = json!({
        "scene": scene(),
        "vary": [{"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}}],
        "samples": {"count": 300, "seed": 4, "method": "sobol"},
        // This output prevents lanes, which have larger parts.
        "outputs": {"pairs": ["first_start_s", "total_impulse_n_s"]},
    });
    let going = sweep(&folder, &words);
    let fill = |sweep: &Sweep, out: &str, shard: Shard| {
        let parts = opened(sweep, &folder.join(out), shard);
        let there = parts.fill(sweep, &|_| ()).expect("a disk");
        (parts, there)
    };
    let (whole, _) = fill(&going, "whole.csv", Shard::WHOLE);
    let table = folder.join("whole.csv");
    let joined = whole.join(Existing::Kept).expect("a table");
    assert_eq!((joined.runs, joined.failed), (300, 0));
    let wanted = fs::read(&table).expect("a file");
    let mut folders = Vec::new();
    for index in 1..=3 {
        let shard = Shard::new(index, 3).expect("a shard");
        let (parts, there) = fill(&going, &format!("{index}.csv"), shard);
        assert_eq!(there, parts.n_runs());
        folders.push(parts.folder().to_path_buf());
        let out = folder.join("merged.csv");
        // Remains of a killed process, longer than the table, are deleted.
        let left = folder.join(".merged.csv.1f.new");
        fs::write(&left, vec![b'x'; 1 << 20]).expect("a disk");
        let merged = merge(&out, &folders, Existing::Kept);
        if index < 3 {
            let message = merged.expect_err("shards are missing").to_string();
            assert!(message.contains(&format!("{} to 299 are missing", index * 100)), "{message}");
        } else {
            assert_eq!(merged.expect("all are there").runs, 300);
            assert_eq!(fs::read(&out).expect("a file"), wanted);
        }
    }
    // After an immediate stop there are no parts; a truncated part is named.
    let stopped = read(&folder, &words, Some(&STOPPED)).expect("a sweep");
    assert_eq!(fill(&stopped, "stopped.csv", Shard::WHOLE).1, 0);
    let part = folders[0].join("part-000000007.csv");
    let text = fs::read_to_string(&part).expect("a part");
    fs::write(&part, &text[..text.len() - 5]).expect("a disk");
    let message = merge(&folder.join("cut.csv"), &folders, Existing::Kept)
        .expect_err("damaged")
        .to_string();
    assert!(
        message.contains("part-000000007.csv: found other bytes than were written"),
        "{message}"
    );
    assert!(!folder.join("cut.csv").exists(), "half a table is none");
}

/// A compressed table contains the bytes of the plain table.
#[test]
fn limit_a_compressed_table_is_the_same_table() {
    use std::io::Read as _;
    let folder = folder("compressed");
    let sweep = sweep(
        &folder,
        &json!({
            "scene": scene(),
            "vary": [{"field": "contacts[0].gap_m", "grid": {"from": 0.0, "to": 0.02, "count": 1500}}],
        }),
    );
    let (plain, compressed) = (folder.join("runs.csv"), folder.join("runs.csv.zst"));
    let parts = opened(&sweep, &plain, Shard::WHOLE);
    parts.fill(&sweep, &|_| ()).expect("a disk");
    let folders = [parts.folder().to_path_buf()];
    drop(parts);
    for out in [&plain, &compressed] {
        let joined = merge(out, &folders, Existing::Kept);
        assert_eq!(joined.expect("a table").runs, 1500);
    }
    let file = fs::File::open(&compressed).expect("a file");
    let mut text = Vec::new();
    let mut decoder = ruzstd::decoding::StreamingDecoder::new(file).expect("a frame");
    decoder.read_to_end(&mut text).expect("a frame");
    let wanted = fs::read(&plain).expect("a file");
    assert!(text == wanted, "{} and {} bytes", text.len(), wanted.len());
    let length = fs::metadata(&compressed).expect("a file").len();
    assert!(2 * length < text.len() as u64, "{length} of {}", text.len());
}

/// A sweep without verdict that requests these numbers of structures.
fn asked(quantities: &[&str]) -> Sweep {
    let folder = folder(&format!("beside-{}", quantities.len()));
    let mut scene = scene();
    // The duration of each run is that of its record plus two of its periods: runs do not end together.
    scene["record"] = json!({"generated": {"stochastic": {
        "ground": "firm", "pga_m_per_s2": 4.0, "strong_from_s": 0.5, "strong_until_s": 3.0,
        "decay_per_s": 1.0, "duration_s": 4.0, "time_step_s": 0.02, "seed": 3,
    }}});
    scene.as_object_mut().expect("a table").remove("duration_s");
    sweep(
        &folder,
        &json!({
            "scene": scene,
            "vary": [
                {"field": "contacts[0].gap_m", "uniform": {"from": 0.0, "to": 0.02}},
                {"field": "structures[0].sdof.period_s", "uniform": {"from": 0.2, "to": 1.5}},
                {"field": "contacts[0].law.linear_spring.impact_stiffness_n_per_m", "log_uniform": {"from": 1e6, "to": 1e9}},
            ],
            "samples": {"count": 300, "seed": 5, "method": "sobol"},
            "directions": "both",
            "outputs": {
                "structures": quantities,
                "pairs": ["collisions", "peak_force_n", "total_impulse_n_s"],
            },
            "verdict": false,
        }),
    )
}

/// Runs in lanes give the rows of runs alone: another output, unknown to lanes, makes the sweep run alone.
#[test]
fn limit_rows_of_runs_side_by_side_are_those_of_runs_alone() {
    let together = asked(&["peak_displacement_m"]);
    let alone = asked(&["peak_displacement_m", "peak_displacement_time_s"]);
    let place = |sweep: &Sweep, ends: &str| {
        let columns = sweep.columns();
        let found = columns.iter().position(|name| name.ends_with(ends));
        found.expect("a column")
    };
    assert_eq!([&together, &alone].map(|sweep| sweep.batch(0..600).beside), [600, 0]);
    let mut collisions = 0.0;
    for (together_row, alone_row) in table(&together, 0..600).iter().zip(&table(&alone, 0..600)) {
        for column in [
            "left: peak_displacement_m",
            "right: peak_displacement_m",
            "collisions",
            "peak_force_n",
            "total_impulse_n_s",
            "failed",
        ] {
            let both = [&together_row[place(&together, column)], &alone_row[place(&alone, column)]];
            assert_eq!(both[0], both[1], "{column} of run {}", together_row[0]);
        }
        collisions += together_row[place(&together, "collisions")].parse::<f64>().unwrap_or(0.0);
    }
    assert!(collisions > 100.0, "{collisions} collisions are too few to tell");
}
