//! Random scenes by the exact method and by the second route.

use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};
use pounding_studies::verify::{Campaign, Checked, Summary};

/// Default folder of scenes that do not agree, from the top folder.
const USUAL: &str = "target/verify";

/// Settings of a campaign.
#[derive(Debug, clap::Args)]
pub(crate) struct Asked {
    /// Scenes in JSON instead of random ones.
    #[arg(value_name = "SCENE", conflicts_with_all = ["scenes", "first", "seed", "out"])]
    files: Vec<PathBuf>,
    /// Number of scenes.
    #[arg(long, default_value_t = 300)]
    scenes: usize,
    /// Number of the first scene.
    #[arg(long, default_value_t = 0)]
    first: usize,
    /// Seed of the scenes.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Seconds after which a part of the work on a scene counts as a hang.
    #[arg(long, default_value_t = 120)]
    patience: u64,
    /// Folder for the scenes that do not agree, as files that `pounding run` replays, with a table [default: target/verify].
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// Runs a campaign, prints disagreements and their number, and writes these scenes as files.
pub(crate) fn run(root: &Path, asked: &Asked) -> Result<(), String> {
    let campaign = Campaign {
        studies: root.join("studies"),
        seed: asked.seed,
        patience: Duration::from_secs(asked.patience),
    };
    if !asked.files.is_empty() {
        return of_files(&campaign, &asked.files);
    }
    let folder = asked.out.clone().unwrap_or_else(|| root.join(USUAL));
    copy_records(&campaign.studies, &folder)?;
    let style = ProgressStyle::with_template("{bar:40} {pos}/{len} scenes, {elapsed}").expect("the template is well formed");
    let bar = ProgressBar::new(asked.scenes as u64).with_style(style);
    let scenes: Vec<usize> = (asked.first..asked.first + asked.scenes).collect();
    // Written at once: a campaign is long, and findings must survive a stop.
    let written = Mutex::new(Ok(()));
    let checked = campaign.run(&scenes, &|one| {
        bar.inc(1);
        if !one.lines().is_empty()
            && let Err(error) = write(&campaign, one, &folder)
        {
            *written.lock().expect("no thread panics while it writes") = Err(error);
        }
    });
    bar.finish_and_clear();
    written.into_inner().expect("no thread panics while it writes")?;
    let lines = checked.iter().flat_map(Checked::lines);
    let text: String = lines.map(|line| line + "\n").collect();
    let summary = Summary(&checked);
    let table = folder.join(format!("seed-{}.csv", asked.seed));
    fs::write(&table, summary.csv(asked.seed)).map_err(|error| cannot(&table, &error))?;
    crate::reproduce::say(&format!("{text}\n{summary}"))?;
    if summary.is_good() {
        Ok(())
    } else {
        Err(format!(
            "scenes disagree, or the exact method fails; their files are in {}",
            folder.display()
        ))
    }
}

/// Runs scenes of files.
fn of_files(campaign: &Campaign, files: &[PathBuf]) -> Result<(), String> {
    let mut all = Vec::new();
    for (index, path) in files.iter().enumerate() {
        let text = fs::read_to_string(path).map_err(|error| cannot(path, &error))?;
        let scene = serde_json::from_str(&text);
        let scene = scene.map_err(|error| format!("{}: {error}", path.display()))?;
        let base = path.parent().unwrap_or(Path::new(""));
        let checked = campaign.check(index, &scene, base);
        let lines = checked.lines().join("\n");
        crate::reproduce::say(&format!("{}\n{lines}\n", path.display()))?;
        all.push(checked);
    }
    let summary = Summary(&all);
    crate::reproduce::say(&format!("\n{summary}"))?;
    if summary.is_good() {
        Ok(())
    } else {
        Err("scenes disagree, or the exact method fails".into())
    }
}

/// Writes the scene, with the folder's copy of its record.
fn write(campaign: &Campaign, checked: &Checked, folder: &Path) -> Result<(), String> {
    let path = folder.join(format!("{}-{}.json", campaign.seed, checked.index));
    let scene = campaign.scene(checked.index);
    let text = serde_json::to_string_pretty(&scene).expect("a scene is written without errors");
    fs::write(&path, text + "\n").map_err(|error| cannot(&path, &error))?;
    let path = path.with_extension("txt");
    let lines = checked.lines().join("\n");
    fs::write(&path, lines + "\n").map_err(|error| cannot(&path, &error))
}

fn copy_records(studies: &Path, folder: &Path) -> Result<(), String> {
    let (from, to) = (studies.join("records"), folder.join("records"));
    fs::create_dir_all(&to).map_err(|error| cannot(&to, &error))?;
    for entry in fs::read_dir(&from).map_err(|error| cannot(&from, &error))? {
        let path = entry.map_err(|error| cannot(&from, &error))?.path();
        let name = path.file_name().expect("an entry has a name");
        fs::copy(&path, to.join(name)).map_err(|error| cannot(&path, &error))?;
    }
    Ok(())
}

fn cannot(path: &Path, error: &std::io::Error) -> String {
    format!("{}: {error}", path.display())
}
