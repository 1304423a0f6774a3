//! Scenes solved by this project, by other programs and by compiled loops: CPU time and error of each, in a single run.
//!
//! The scenes are two elastic structures under El Centro, with impacts and with the nonlinear viscoelastic element, and two yielding towers
//! of several storeys with this element. Other programs run in a Python process (`worker.py`). All settings take turns, so that other load
//! of the machine affects all of them. Only ratios are kept.

mod entrants;
mod environment;
mod figure;
mod own;
mod race;
mod report;
mod scenes;
mod work;

use std::path::Path;

use figure::work_precision_figure;

use crate::measure::{Outcome, RatioTable, keep};
use environment::Worker;
use race::Raced;
use scenes::Scenes;

/// All settings, and their figure, from the last machine.
const SETTINGS: RatioTable = RatioTable {
    path: "results/bench/peers.csv",
    title: "CPU time of a scene over that of central differences in lanes with steps of 0.01 s",
    header: "law,tool,method,setting,error,cpu_time_ratio,over_ours_at_this_error",
};
const FIGURE: &str = "results/bench/peers.png";
/// Error levels, from one machine of each kind of instructions.
const LEVELS: RatioTable = RatioTable {
    path: "results/bench/peers-levels.csv",
    title: "Best of others over our cheapest method at an error",
    header: "instructions,law,error,ours,best_package,package_over_ours,best_loop,loop_over_ours",
};

/// Runs the comparison and keeps ratios and a figure.
pub(super) fn run(root: &Path) -> Outcome<()> {
    let ground = scenes::ground(root)?;
    let all = Scenes::of_all_kinds(&ground)?;
    let home = std::env::current_exe()?.with_file_name("peers");
    environment::prepare(&home, &scenes::as_json(&all, &ground))?;
    let mut worker = Worker::start(&home)?;
    println!("{}", worker.present());
    let raced = all.iter().map(|scenes| race::run(scenes, &mut worker));
    let raced = raced.collect::<Outcome<Vec<Raced>>>()?;
    let panels: Vec<_> = raced.iter().map(report::panel).collect();
    keep(root, FIGURE, &work_precision_figure(&panels)?)?;
    SETTINGS.write(root, &report::settings(&raced))?;
    LEVELS.write(root, &report::levels(&raced))?;
    report::check(&raced);
    Ok(())
}
