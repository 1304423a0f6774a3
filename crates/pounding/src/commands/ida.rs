//! `pounding ida`: how often a row is pounded, from motions of several intensities and a hazard curve.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::atomic::Ordering;

use pounding::assess::{AskedMeasure, IntensityMeasure, SuiteMotion, Watched};
use pounding::report::{JudgedRun, RiskAsked, RiskReport};
use pounding::risk::{HazardCurve, State};
use pounding::scene::{Error, Floors, Scene, periods_between};
use pounding::sweep::{Directions, StripeMotions, StripesAsked};
use pounding::text::{RefusalKind, Refused, Where};

use super::declared::Declared;
use super::printed::{Printed, Results};
use super::suite::MotionLine;
use super::{Failure, suite};
use crate::progress::Progress;

const EXAMPLES: &str = "\
Examples:
  pounding ida scene.toml --records records
  pounding ida scene.toml --records records --im 'sa(0.8)' --hazard hazard.csv
  pounding ida scene.toml --records records --gaps 0.02,0.04,0.08 --out ida
  pounding ida scene.toml --stripe 0.1=weak --stripe 0.4=strong

Every motion is scaled to every intensity (--records), or every intensity has a
folder of motions of its own, as strong as in their files (--stripe). The
fragility is the lognormal one of most likelihood of the share of events at each
intensity. The hazard curve is a CSV file: intensity in g, mean annual frequency.";

/// Help of `--im`.
const MEASURES: &str = "Intensity of a motion: pga, sa(0.8), sa_avg(0.2..2) or T1, sa of the longest first period of the row; required with --hazard, else by default T1";

/// The arguments of `ida`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; its record is replaced.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// A folder of records.
    #[arg(long, value_name = "FOLDER", required_unless_present = "stripe", conflicts_with = "stripe")]
    records: Option<PathBuf>,
    /// An intensity [g] and a folder of records of that intensity; once for each.
    #[arg(long, value_name = "IM=FOLDER", value_parser = stripe)]
    stripe: Vec<(f64, PathBuf)>,
    #[arg(long, help = MEASURES, value_name = "MEASURE", conflicts_with = "stripe", value_parser = AskedMeasure::from_str)]
    im: Option<AskedMeasure>,
    /// Intensities [g]; by default 16 from 0.05 to 2.
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = super::positive, conflicts_with = "stripe")]
    stripes: Vec<f64>,
    /// Least intensity [g].
    #[arg(long, value_name = "G", value_parser = super::positive, conflicts_with_all = ["stripe", "stripes"], default_value_t = 0.05)]
    from: f64,
    /// Largest intensity [g].
    #[arg(long, value_name = "G", value_parser = super::positive, conflicts_with_all = ["stripe", "stripes"], default_value_t = 2.0)]
    to: f64,
    /// Number of intensities, in equal ratios.
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=1000), conflicts_with_all = ["stripe", "stripes"], default_value_t = 16)]
    n: u32,
    /// States that are counted: touch, touch=2 (the second gap), drift=0.01,
    /// force=5e6, shear=5e6 [N], collapse.
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = State::from_str, default_value = "touch")]
    state: Vec<State>,
    /// Widths of all gaps [m] for which touching is told, too.
    #[arg(long, value_name = "LIST", value_delimiter = ',', value_parser = super::positive)]
    gaps: Vec<f64>,
    /// Hazard curve of the site, for the measure of --im.
    #[arg(long, value_name = "CSV")]
    hazard: Option<PathBuf>,
    /// Shake in both directions.
    #[arg(long)]
    both: bool,
    #[command(flatten)]
    printed: Printed,
    #[command(flatten)]
    results: Results,
    #[command(flatten)]
    declared: Declared,
}

/// An intensity and a folder.
fn stripe(text: &str) -> Result<(f64, PathBuf), String> {
    const ALLOWED: &str = "allowed is an intensity in g and a folder, as in 0.4=strong";
    let (intensity, folder) = text.split_once('=').ok_or(ALLOWED)?;
    Ok((super::positive(intensity).map_err(|_| ALLOWED)?, folder.into()))
}

/// Finds how often the states of a row are reached.
pub(crate) fn run(args: &Arguments) -> Result<String, Failure> {
    let path = &args.scene;
    let message = |error: Error| Refused::from(error.in_file(path));
    let read = args.hazard.iter().chain([path]).cloned().collect();
    let out = args.results.open_beside(&args.folders(), read)?;
    let scene: Scene = super::read(path).map_err(message)?;
    let any_record = Scene {
        duration_s: None,
        ..scene.clone()
    };
    Floors::check(&any_record).map_err(message)?;
    let hazard = args.hazard.as_deref().map(hazard).transpose()?;
    let measure = args.measure(&scene)?;
    let motions = args.motions(&scene, measure)?;
    suite::stop_when_asked();
    let asked = StripesAsked {
        scene: &scene,
        path,
        motions: &motions,
        directions: if args.both { Directions::Both } else { Directions::AsGiven },
        states: &args.state,
        closings: !args.gaps.is_empty(),
    };
    let progress = Progress::of(asked.n_runs());
    let step = |of| progress.step(of);
    let watched = Watched {
        stop: &suite::STOPPED,
        step: &step,
    };
    let runs = asked.run(watched)?;
    drop(progress);
    let report = RiskReport::of(
        &scene,
        motions.suites(),
        &runs,
        RiskAsked {
            states: &args.state,
            gaps: &args.gaps,
            hazard: hazard.as_ref(),
            measure,
        },
    );
    let judged = args.judged(&scene, &motions, report.judged_stripe())?;
    let report = report.with_cautions(&judged);
    let mut answer = report.answer();
    if let Some(out) = out {
        out.write(&report.files())?;
        answer = answer.say(Where::Terminal, "Results", vec![out.path().display().to_string()]);
    }
    let printed = answer.text(args.printed.form());
    match report.refused() {
        None => Ok(printed),
        Some(refused) => Err(Failure {
            printed,
            refused: refused.clone(),
        }),
    }
}

/// Reads a hazard curve.
fn hazard(path: &Path) -> Result<HazardCurve, Refused> {
    let unreadable = |error: std::io::Error| Refused::unreadable(path, &error);
    let read = pounding::scene::file::bytes(path).map_err(unreadable)?;
    let read = String::from_utf8(read).map_err(|error| unreadable(std::io::Error::other(error)))?;
    HazardCurve::parse(&read).map_err(|refused| refused.in_file(path))
}

impl Arguments {
    /// The folders of records.
    fn folders(&self) -> Vec<&Path> {
        let all = self.records.iter().chain(self.stripe.iter().map(|one| &one.1));
        all.map(PathBuf::as_path).collect()
    }

    /// How the intensity of motions is measured; `None` if each intensity has a folder.
    fn measure(&self, scene: &Scene) -> Result<Option<IntensityMeasure>, Refused> {
        if !self.stripe.is_empty() {
            return Ok(None);
        }
        if self.im.is_none() && self.hazard.is_some() {
            let none = Refused::at("--im").found("nothing").allowed_is("the measure of the hazard curve");
            return Err(none.help("name it, such as --im 'sa(0.8)'"));
        }
        self.im.unwrap_or(AskedMeasure::LongestPeriod).of_row(scene).map(Some)
    }

    /// The row under all motions of an intensity, judged; nothing if all runs fail, which the answer says.
    fn judged(&self, scene: &Scene, motions: &StripeMotions, stripe: usize) -> Result<Vec<MotionLine<JudgedRun>>, Refused> {
        let apart = self.state.iter().all(|state| matches!(state, State::Touch(_)));
        let directions: &[bool] = if self.both { &[false, true] } else { &[false] };
        let under = |motion: &SuiteMotion| motions.scene_at(stripe, motion, scene);
        let ran = suite::lines_of(motions.suite_at(stripe), directions, under, |prepared, doubts| {
            JudgedRun::of(prepared, doubts.clone(), apart)
        });
        if suite::STOPPED.load(Ordering::Relaxed) {
            let stopped = Refused::that("stopped before all runs were finished");
            return Err(stopped.kind(RefusalKind::Stopped));
        }
        Ok(ran.map_or_else(|_| Vec::new(), |ran| ran.lines))
    }

    /// The motions of all intensities.
    fn motions(&self, scene: &Scene, measure: Option<IntensityMeasure>) -> Result<StripeMotions, Refused> {
        let Some((measure, folder)) = measure.zip(self.records.as_ref()) else {
            let read = |(intensity, folder): &(f64, PathBuf)| Ok((*intensity, suite::read(folder, &self.declared, scene)?));
            return StripeMotions::own(self.stripe.iter().map(read).collect::<Result<_, Refused>>()?);
        };
        let mut intensities = self.stripes.clone();
        if intensities.is_empty() {
            if self.from >= self.to {
                let found = Refused::at("--from").found(format!("{} g", self.from));
                return Err(found.allowed_is(format!("less than --to, which is {} g", self.to)));
            }
            intensities = periods_between(self.from, self.to, self.n);
        }
        StripeMotions::scaled(suite::read_to_scale(folder, &self.declared, scene)?, measure, intensities)
    }
}
