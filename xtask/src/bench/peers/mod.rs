//! The same scenes by this project, by other programs and by compiled loops: CPU time and error of each, in one run.
//!
//! Two elastic structures under El Centro, with impacts and with the nonlinear viscoelastic element. Other programs run in one Python
//! process (`worker.py`); all settings take turns, so that what else the machine does meets everybody. Only ratios are kept.

mod entrants;
mod environment;
mod own;
mod race;
mod report;
mod scenes;
mod work;

use std::path::Path;

use pounding_studies::work_precision_figure;

use environment::Worker;
use race::Raced;
use scenes::Scenes;

/// Where the table of all settings, that of error levels and the figure are kept, from the top folder.
const KEPT: [&str; 3] = [
    "results/bench/peers.csv",
    "results/bench/peers-levels.csv",
    "results/bench/peers.png",
];

/// Races all and keeps ratios and a figure.
pub(super) fn run(root: &Path) -> Result<(), String> {
    let ground = scenes::ground(root)?;
    let all = Scenes::of_all_laws(&ground)?;
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
    let (settings, levels) = (report::settings_csv(&raced), report::levels_csv(&raced));
    let files = [settings.into_bytes(), levels.clone().into_bytes(), figure];
    for (path, bytes) in KEPT.into_iter().zip(files) {
        let place = root.join(path);
        std::fs::create_dir_all(place.parent().unwrap_or(root))
            .and_then(|()| std::fs::write(&place, bytes))
            .map_err(|error| format!("{path}: {error}"))?;
    }
    println!(
        "{}\n{levels}\nkept in {}",
        report::checks(&raced),
        KEPT.join(", ")
    );
    Ok(())
}
