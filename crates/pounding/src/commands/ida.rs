//! `pounding ida`: how often a row is pounded, from motions of several intensities and a hazard curve.

use std::path::{Path, PathBuf};
use std::str::FromStr;
use std::sync::atomic::Ordering;

use pounding::assess::{IntensityMeasure, Suite, SuiteMotion, Watched};
use pounding::report::{JudgedRun, RiskAsked, RiskReport};
use pounding::risk::{HazardCurve, State};
use pounding::scene::{Error, Floors, RecordUse, Scene, Structure, periods_between};
use pounding::sweep::{Directions, StripeMotions, StripesAsked};
use pounding::text::{Form, RefusalKind, Refused, Where};

use super::declared::Declared;
use super::suite::MotionLine;
use super::{Failure, suite};
use crate::folder::Out;
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
const MEASURES: &str = "Intensity of a motion: pga, sa(0.8) or sa_avg(0.2..2); required with --hazard, else by default sa of the longest first period of the row";

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
    #[arg(long, help = MEASURES, value_name = "MEASURE", conflicts_with = "stripe", value_parser = IntensityMeasure::from_str)]
    im: Option<IntensityMeasure>,
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
    /// Write figures and tables here.
    #[arg(long, value_name = "FOLDER")]
    out: Option<PathBuf>,
    /// Write into a folder that holds other things; they stay.
    #[arg(long, requires = "out")]
    overwrite: bool,
    #[command(flatten)]
    declared: Declared,
}

/// How the answer is printed.
#[derive(Debug, clap::Args)]
struct Printed {
    /// Print more: every motion, and every record that is left out.
    #[arg(long)]
    details: bool,
    /// Print a table for a program, SI units, a line per run.
    #[arg(long, conflicts_with_all = ["json", "details"])]
    csv: bool,
    /// Print JSON, SI units.
    #[arg(long, conflicts_with = "details")]
    json: bool,
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
    let out = args.open()?;
    let scene: Scene = super::read(path).map_err(message)?;
    let any_record = Scene {
        duration_s: None,
        ..scene.clone()
    };
    Floors::check(&any_record).map_err(message)?;
    let hazard = args.hazard.as_deref().map(hazard).transpose()?;
    let measure = args.measure(&scene, hazard.is_some())?;
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
        suites(&motions),
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
    let Printed { details, csv, json } = args.printed;
    let printed = answer.text(Form::asked(details, csv, json));
    match report.refused() {
        None => Ok(printed),
        Some(refused) => Err(Failure {
            printed,
            refused: refused.clone(),
        }),
    }
}

/// The folders of records.
fn suites(motions: &StripeMotions) -> Vec<&Suite> {
    match motions {
        StripeMotions::Scaled { suite, .. } => vec![suite],
        StripeMotions::Own(all) => all.iter().map(|one| &one.1).collect(),
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
    /// Takes the folder of `--out`; `None` if none is asked for.
    fn open(&self) -> Result<Option<Out>, Refused> {
        let Some(out) = &self.out else {
            return Ok(None);
        };
        let out = Out::open(out, self.overwrite)?;
        let folders: Vec<&PathBuf> = self.records.iter().chain(self.stripe.iter().map(|one| &one.1)).collect();
        let read = folders.iter().flat_map(|folder| super::inputs_in(folder));
        let read: Vec<PathBuf> = read.chain([self.scene.clone()]).chain(self.hazard.clone()).collect();
        out.keep(&read)?;
        folders.iter().try_for_each(|folder| out.apart_from(folder))?;
        Ok(Some(out))
    }

    /// How the intensity of motions is measured; `None` if each intensity has a folder.
    fn measure(&self, scene: &Scene, with_hazard: bool) -> Result<Option<IntensityMeasure>, Refused> {
        if !self.stripe.is_empty() || self.im.is_some() {
            return Ok(self.im);
        }
        if with_hazard {
            let none = Refused::at("--im").found("nothing").allowed_is("the measure of the hazard curve");
            return Err(none.help("name it, such as --im 'sa(0.8)'"));
        }
        let longest = scene.structures.iter().filter_map(Structure::longest_period).reduce(f64::max);
        let none = || Refused::at("structures").found("walls alone").allowed_are("one or more that move");
        Ok(Some(IntensityMeasure::Sa(longest.ok_or_else(none)?)))
    }

    /// The row under all motions of an intensity, judged; nothing if all runs fail, which the answer says.
    fn judged(&self, scene: &Scene, motions: &StripeMotions, stripe: usize) -> Result<Vec<MotionLine<JudgedRun>>, Refused> {
        let apart = self.state.iter().all(|state| matches!(state, State::Touch(_)));
        let directions: &[bool] = if self.both { &[false, true] } else { &[false] };
        let scaled = |scale: f64| Scene {
            record: RecordUse {
                scale,
                scale_to: None,
                ..scene.record.clone()
            },
            ..scene.clone()
        };
        let under = |motion: &SuiteMotion| {
            let recorded = motion.shake(&scaled(1.0), false, None)?;
            let scale = match motions {
                StripeMotions::Scaled { measure, intensities, .. } => intensities[stripe] / measure.of(motion, scene)?,
                StripeMotions::Own(_) => 1.0,
            };
            Ok((scaled(scale), recorded.doubts()))
        };
        let suite = match motions {
            StripeMotions::Scaled { suite, .. } => suite,
            StripeMotions::Own(all) => &all[stripe].1,
        };
        let ran = suite::lines_of(suite, directions, under, |prepared, doubts| {
            JudgedRun::of(prepared, doubts.clone(), apart)
        });
        if suite::STOPPED.load(Ordering::Relaxed) {
            let stopped = Refused::that("stopped before all runs were finished");
            return Err(stopped.kind(RefusalKind::Stopped));
        }
        Ok(ran.map_or_else(|_| Vec::new(), |ran| ran.lines))
    }

    /// The motions of all intensities, in rising order.
    fn motions(&self, scene: &Scene, measure: Option<IntensityMeasure>) -> Result<StripeMotions, Refused> {
        let rising = |all: &[f64], option: &'static str| {
            if all.windows(2).all(|two| two[0] < two[1]) {
                return Ok(());
            }
            let twice = Refused::at(option).found("an intensity twice");
            Err(twice.allowed_is("each once"))
        };
        let Some((measure, folder)) = measure.zip(self.records.as_ref()) else {
            let mut all = self.stripe.clone();
            all.sort_by(|one, other| one.0.total_cmp(&other.0));
            rising(&all.iter().map(|one| one.0).collect::<Vec<_>>(), "--stripe")?;
            let read = all
                .into_iter()
                .map(|(intensity, folder)| Ok((intensity, suite::read(&folder, &self.declared, scene)?)));
            return Ok(StripeMotions::Own(read.collect::<Result<_, Refused>>()?));
        };
        let mut intensities = self.stripes.clone();
        if intensities.is_empty() {
            if self.from >= self.to {
                let found = Refused::at("--from").found(format!("{} g", self.from));
                return Err(found.allowed_is(format!("less than --to, which is {} g", self.to)));
            }
            intensities = periods_between(self.from, self.to, self.n);
        }
        intensities.sort_by(f64::total_cmp);
        rising(&intensities, "--stripes")?;
        Ok(StripeMotions::Scaled {
            suite: suite::read_to_scale(folder, &self.declared, scene)?,
            measure,
            intensities,
        })
    }
}
