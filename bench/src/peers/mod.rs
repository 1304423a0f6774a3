//! The same scenes by this project, by other programs and by compiled loops: CPU time and error of each, in one run.
//!
//! Two elastic structures under El Centro, with impacts and with the nonlinear viscoelastic element, and two towers of several storeys that
//! yield, with that element. Other programs run in one Python process (`worker.py`); all settings take turns, so that what else the machine
//! does meets everybody. Only ratios are kept.

mod entrants;
mod environment;
mod own;
mod race;
mod report;
mod scenes;
mod work;

use std::path::Path;

use pounding_studies::work_precision_figure;

use super::lanes;
use environment::Worker;
use race::Raced;
use scenes::Scenes;

/// Where the table of all settings and the figure are kept, from the top folder: those of the last machine.
const KEPT: [&str; 2] = ["results/bench/peers.csv", "results/bench/peers.png"];
/// Where the table of error levels is kept, of one machine of each kind of instructions, and its head.
const LEVELS: &str = "results/bench/peers-levels.csv";
const HEADER: &str =
    "instructions,law,error,ours,best_package,package_over_ours,best_loop,loop_over_ours";

/// Races all and keeps ratios and a figure.
pub(super) fn run(root: &Path) -> Result<(), String> {
    let ground = scenes::ground(root)?;
    let all = Scenes::of_all_kinds(&ground)?;
    let own = std::env::current_exe().map_err(|error| format!("this program: {error}"))?;
    let home = own.with_file_name("peers");
    environment::prepare(&home, &scenes::as_json(&all, &ground))?;
    let mut worker = Worker::start(&home)?;
    println!("{}", worker.present());
    let raced: Vec<Raced> = all
        .iter()
        .map(|scenes| race::run(scenes, &mut worker))
        .collect::<Result<_, _>>()?;
    let panels: Vec<_> = raced.iter().map(report::panel).collect();
    let unit = "lanes, 0.01 s";
    let figure = work_precision_figure(&panels, unit).map_err(|error| error.to_string())?;
    let files = [report::settings_csv(&raced).into_bytes(), figure];
    for (path, bytes) in KEPT.into_iter().zip(files) {
        let place = root.join(path);
        std::fs::create_dir_all(place.parent().unwrap_or(root))
            .and_then(|()| std::fs::write(&place, bytes))
            .map_err(|error| format!("{path}: {error}"))?;
    }
    let instructions = lanes::instructions().unwrap_or("others");
    let levels = report::levels(&raced);
    let levels = lanes::keep(&root.join(LEVELS), HEADER, instructions, &levels)?;
    println!(
        "{}\n{levels}\nkept in {LEVELS}, {}",
        report::checks(&raced),
        KEPT.join(", ")
    );
    Ok(())
}
