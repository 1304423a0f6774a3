//! Surveys with thousands of exact runs each, too long for `reproduce`.

use std::fs;
use std::path::Path;
use std::time::Instant;

use indicatif::ProgressBar;
use pounding_studies::{StudyFile, SurveyStudy};

/// Runs the surveys with these names, or all if none is given; writes their folders of results/.
pub(crate) fn run(root: &Path, names: &[String]) -> Result<(), String> {
    let files = StudyFile::read_all(&root.join("studies")).map_err(|error| error.to_string())?;
    let surveys = SurveyStudy::all(&files).map_err(|error| error.to_string())?;
    let known: Vec<&str> = surveys.iter().map(SurveyStudy::id).collect();
    if let Some(unknown) = names.iter().find(|name| !known.contains(&name.as_str())) {
        return Err(format!("studies: found no survey \"{unknown}\", allowed {}", known.join(", ")));
    }
    let asked = |survey: &&SurveyStudy| names.is_empty() || names.iter().any(|name| name == survey.id());
    for survey in surveys.iter().filter(asked) {
        let started = Instant::now();
        let spinner = ProgressBar::new_spinner().with_message(survey.id().to_string());
        spinner.enable_steady_tick(std::time::Duration::from_millis(200));
        let made = survey.run();
        spinner.finish_and_clear();
        let made = made.map_err(|error| error.to_string())?;
        let results = root.join("results");
        // The folder contains only this survey.
        let folder = results.join(survey.id());
        let fail = |error| format!("{}: cannot be written: {error}", folder.display());
        if folder.exists() {
            fs::remove_dir_all(&folder).map_err(fail)?;
        }
        fs::create_dir_all(&folder).map_err(fail)?;
        for (path, bytes) in &made {
            fs::write(results.join(path), bytes).map_err(fail)?;
        }
        crate::reproduce::say(&format!(
            "{} files in {}, {:.0} s\n",
            made.len(),
            folder.display(),
            started.elapsed().as_secs_f64()
        ))?;
    }
    Ok(())
}
