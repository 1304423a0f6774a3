//! `pounding assess`: is the gap enough under a folder of records, what does touching do, and how sure is that.

mod bumper;
mod runs;

use std::path::PathBuf;

use pounding::assess::{AssessedRun, Bumper, BumperEffect, DesignSpectrum, Rule, Scaling, SpectrumTarget, Suite, TargetFactors};
use pounding::report::{AssessmentReport, FolderOfMotions, ScalingAsked};
use pounding::scene::file::ScaleTo;
use pounding::scene::{Error, Floors, Method, Scene, Structure};
use pounding::text::{Refused, Where, digits};

use super::declared::Declared;
use super::printed::{Printed, Results};
use super::suite;
use bumper::BumperAsked;
use runs::{Asked, RunsUnderMotion};

const EXAMPLES: &str = "\
Examples:
  pounding assess scene.toml --records records
  pounding assess scene.toml --records records --out assessed
  pounding assess scene.toml --records records --scale pga=0.3g
  pounding assess scene.toml --records records --scale 'sa(0.8s)=0.5g'
  pounding assess scene.toml --records records --target ec8:a_g=0.25g,ground=C
  pounding assess scene.toml --records records --bumper k=80MN/m
  pounding assess a.toml --records records --target asce7:s_ds=1,s_d1=0.6,t_l=8

Every horizontal motion of the folder shakes the row in both directions, by the
exact method. Components of one record are one event. The answer is one for
these records: choose and scale them for the site. If their mean spectrum has
less than 90 % of --target somewhere, all are made stronger by one factor until
it has, and the answer says so. The stiffness of impacts is known to an order of
magnitude; forces are ranges over --stiffness.

The folder holds report.html, for people; assess.csv with a line per number;
assess.json; and the figures as SVG and PNG.";

/// The arguments of `assess`.
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The scene, a TOML or JSON file; its record is replaced.
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// A folder of records.
    #[arg(long, value_name = "FOLDER")]
    records: PathBuf,
    /// Scale each record: none, pga=0.3g, or sa(0.8s)=0.5g (5 % damping); by
    /// default as the scene scales its own.
    #[arg(long, value_name = "TO", value_parser = scaling)]
    scale: Option<Scaling>,
    /// Scale each record to a spectrum: ec8:…, asce7:…, or a CSV file of periods
    /// in s and accelerations in g.
    #[arg(long, value_name = "SPECTRUM", conflicts_with = "scale")]
    target: Option<String>,
    /// Periods at which records are compared with --target [s]; by default 0.2 times
    /// the shortest to 2 times the longest first period of the row.
    #[arg(long, value_name = "T..T", value_parser = periods, requires = "target")]
    target_periods: Option<[f64; 2]>,
    /// Scale all records to --target by one factor, instead of each by its own.
    #[arg(long, requires = "target")]
    one_factor: bool,
    /// Compare the largest spectrum over all directions of both horizontal components
    /// with --target, as ASCE 7-16 does.
    #[arg(long, requires = "target")]
    maximum_direction: bool,
    /// The code whose width is told in a sentence: en-1998-1, asce-7-16, ntc-2018,
    /// tbdy-2018, e-030 or gb-50011; by default that of the target.
    #[arg(long, value_name = "CODE", value_parser = Rule::of_code)]
    code: Option<Rule>,
    /// Leave out records that need a larger factor than this, such as 4: they belong
    /// to other earthquakes.
    #[arg(long, value_name = "FACTOR", value_parser = super::positive)]
    max_scale: Option<f64>,
    /// Range of the stiffness of impacts, as factors on that of the scene; by default
    /// 0.1 to the stiffness of two slabs, which is 30 times the usual one.
    #[arg(long, value_name = "FROM..TO", value_parser = factors)]
    stiffness: Option<[f64; 2]>,
    /// What a bumper in every gap that closes changes, half as thick as the gap:
    /// k=80MN/m at each floor, or proposed, the softest that the gap has room for
    /// and that makes nothing worse.
    #[arg(long, value_name = "BUMPER", default_value = "none", value_parser = bumper::asked)]
    bumper: BumperAsked,
    /// Name for the report.
    #[arg(long, value_name = "NAME", requires = "out")]
    author: Option<String>,
    /// Date for the report, in any form.
    #[arg(long, value_name = "DATE", requires = "out")]
    date: Option<String>,
    #[command(flatten)]
    printed: Printed,
    #[command(flatten)]
    results: Results,
    #[command(flatten)]
    declared: Declared,
}

/// Reads the target of scaling from the command line.
fn scaling(text: &str) -> Result<Scaling, String> {
    const ALLOWED: &str = "allowed are none, pga=0.3g and sa(0.8s)=0.5g, or in m/s2: pga=2.9m/s2";
    if text == "none" {
        return Ok(Scaling::Unscaled);
    }
    let (what, value) = text.split_once('=').ok_or(ALLOWED)?;
    let value = DesignSpectrum::in_g(value).ok_or_else(|| match super::positive(value.trim()) {
        Ok(_) => format!("{value} has no unit: write {value}g or {value}m/s2"),
        Err(_) => ALLOWED.into(),
    })?;
    if what == "pga" {
        return Ok(Scaling::To(ScaleTo::PgaG(value)));
    }
    let period = what
        .strip_prefix("sa(")
        .and_then(|rest| rest.strip_suffix(')'))
        .map(|period| period.strip_suffix('s').unwrap_or(period).trim());
    let period_s = period.and_then(|period| super::positive(period).ok());
    Ok(Scaling::To(ScaleTo::Sa {
        period_s: period_s.ok_or(ALLOWED)?,
        damping_ratio: 0.05,
        sa_g: value,
    }))
}

/// Two periods.
fn periods(text: &str) -> Result<[f64; 2], String> {
    let ends = text.split_once("..").map(|(from, to)| (super::positive(from), super::positive(to)));
    match ends {
        Some((Ok(from), Ok(to))) if from >= 1e-3 && from < to && to <= 100.0 => Ok([from, to]),
        _ => Err("allowed are two periods from 0.001 to 100 s, such as 0.2..2".into()),
    }
}

/// Two factors around 1.
fn factors(text: &str) -> Result<[f64; 2], String> {
    let ends = text.split_once("..").map(|(from, to)| (super::positive(from), super::positive(to)));
    match ends {
        Some((Ok(from), Ok(to))) if from <= 1.0 && to >= 1.0 => Ok([from, to]),
        _ => Err("allowed are two factors with 1 between them, such as 0.1..10".into()),
    }
}

impl Arguments {
    /// The options that ask for this scaling again.
    fn scaling_words(&self) -> Option<String> {
        let most = self.max_scale.map(|most| format!("--max-scale {}", digits(most)));
        let words: Vec<String> = self.target_words().into_iter().chain(most).collect();
        (!words.is_empty()).then(|| words.join(" "))
    }

    fn target_words(&self) -> Option<String> {
        match (&self.target, &self.scale) {
            (Some(target), _) => {
                let periods = self
                    .target_periods
                    .map(|[from, to]| format!(" --target-periods {}..{}", digits(from), digits(to)));
                let one_factor = if self.one_factor { " --one-factor" } else { "" };
                let direction = if self.maximum_direction { " --maximum-direction" } else { "" };
                Some(format!(
                    "--target \"{target}\"{}{one_factor}{direction}",
                    periods.unwrap_or_default()
                ))
            }
            (None, Some(Scaling::To(ScaleTo::PgaG(pga)))) => Some(format!("--scale \"pga={}g\"", digits(*pga))),
            (None, Some(Scaling::To(ScaleTo::Sa { period_s, sa_g, .. }))) => {
                Some(format!("--scale \"sa({}s)={}g\"", digits(*period_s), digits(*sa_g)))
            }
            (None, Some(Scaling::Unscaled)) => Some("--scale none".into()),
            (None, Some(Scaling::AsScene | Scaling::Target(_) | Scaling::Raised { .. }) | None) => None,
        }
    }

    fn scaling(&self) -> Result<Scaling, Refused> {
        match (&self.target, &self.scale) {
            (Some(text), _) => Ok(Scaling::Target(SpectrumTarget {
                periods: self.target_periods,
                maximum_direction: self.maximum_direction,
                factors: if self.one_factor {
                    TargetFactors::Common
                } else {
                    TargetFactors::Each
                },
                ..DesignSpectrum::named(text)?.into()
            })),
            (None, Some(scale)) => Ok(scale.clone()),
            (None, None) => Ok(Scaling::AsScene),
        }
    }
}

/// Assesses a row under a folder of records.
pub(crate) fn run(args: &Arguments) -> Result<String, Refused> {
    let path = &args.scene;
    let message = |error: Error| Refused::from(error.in_file(path));
    let target = args.target.iter().map(PathBuf::from);
    let read = target.chain([path.clone()]).collect();
    let out = args.results.open_beside(&[&args.records], read)?;
    let scene = super::read(path).map_err(message)?;
    let mut records = suite::read(&args.records, &args.declared, &scene)?;
    let asked = args.asked(scene, &mut records)?;
    let ran = asked.run()?;
    let report = args.report(&asked, &ran.lines)?;
    let report = report.ok_or("no run was finished")?;
    let mut answer = report.answer();
    if let Some(out) = out {
        out.write(&report.files())?;
        let page = out.path().join("report.html").display().to_string();
        answer = answer.say(Where::Terminal, "Report", vec![page]);
    }
    ran.answer(answer.text(args.printed.form()))
}

impl Arguments {
    /// Rows and settings, the same for every motion.
    fn asked<'a>(&self, scene: Scene, records: &'a mut Suite) -> Result<Asked<'a>, Refused> {
        let message = |error: Error| Refused::from(error.in_file(&self.scene));
        let scene = Scene {
            method: Method::EXACT,
            ..scene.seeking_gaps()
        };
        let rows = scene.beside_neighbours();
        let rows = rows.map_err(|source| message(Error::in_scene(&scene.name, source)))?;
        let moves = |one: &Structure| !matches!(one, Structure::Wall);
        let row = &rows[0].0.structures;
        if row.len() < 2 || !row.iter().any(moves) {
            let n = match row.len() {
                0 => "none".to_owned(),
                n => format!("{n}, of which {} move", row.iter().filter(|one| moves(one)).count()),
            };
            let two = Refused::at("structures").found(n).allowed_are("two or more, one of which moves");
            let why = "a gap lies between two; of a neighbour that is not known give neighbour.unknown";
            return Err(two.so(": ", why).in_file(&self.scene));
        }
        Floors::check(&rows[0].0).map_err(message)?;
        let known = Scene {
            neighbour: None,
            ..scene.clone()
        };
        let scaling = self.scaling()?.raised(&known, records, self.max_scale);
        if records.motions.is_empty() {
            let most = digits(self.max_scale.unwrap_or_default());
            let found = Refused::at("--max-scale").found(format!("{most}, which every record exceeds"));
            let found = found.allowed_is("a larger factor, or a folder with stronger records");
            return Err(found.so("; ", records.said_of_left_out(false).join("; ")));
        }
        let stiffness = self.stiffness.unwrap_or_else(|| AssessedRun::stiffness_range(&known));
        Ok(Asked {
            scene,
            known,
            rows,
            scaling,
            stiffness,
            records,
        })
    }

    /// The runs that were finished, summed up, with the bumpers that were asked for; `None` if there are none.
    fn report(&self, asked: &Asked<'_>, lines: &[suite::MotionLine<RunsUnderMotion>]) -> Result<Option<AssessmentReport>, Refused> {
        let message = |error: Error| Refused::from(error.in_file(&self.scene));
        let bumpers = match self.bumper {
            BumperAsked::None => Vec::new(),
            BumperAsked::Proposed => asked.bumpers(lines, None).map_err(message)?,
            BumperAsked::Stiffness(stiffness) => asked.bumpers(lines, Some(stiffness)).map_err(message)?,
        };
        let animation = self.results.out.as_ref().and_then(|_| asked.animation(lines));
        let tried: &[f64] = if self.bumper == BumperAsked::Proposed && !bumpers.is_empty() {
            &Bumper::TRIED
        } else {
            &[1.0]
        };
        let mut report = None;
        for factor in tried {
            let bumpers: Vec<Bumper> = bumpers.iter().map(|one| one.stiffened(*factor)).collect();
            report = self.report_with(asked, lines, &bumpers)?;
            let is_enough = |report: &AssessmentReport| report.bumpers().is_none_or(BumperEffect::helps);
            if report.as_ref().is_none_or(is_enough) {
                break;
            }
        }
        Ok(report.map(|report| report.with_animation(animation)))
    }

    /// The runs that were finished, summed up, with these bumpers.
    fn report_with(
        &self,
        asked: &Asked<'_>,
        lines: &[suite::MotionLine<RunsUnderMotion>],
        bumpers: &[Bumper],
    ) -> Result<Option<AssessmentReport>, Refused> {
        let message = |error: Error| Refused::from(error.in_file(&self.scene));
        let with_bumpers = asked.with_bumpers(lines, bumpers)?;
        let folder = FolderOfMotions::of(asked.records, lines, self.printed.details);
        let scaling = ScalingAsked {
            to: asked.scaling.clone(),
            words: self.scaling_words(),
        };
        let motions = asked.motions(lines, &with_bumpers);
        let report = AssessmentReport::of(asked.rows[0].0.clone(), motions).map_err(message)?;
        Ok(report.map(|report| {
            report
                .asked_of(asked.scene.clone())
                .with_folder(folder)
                .with_stiffness(asked.stiffness)
                .with_code(self.code.or_else(|| asked.scaling.code()))
                .with_scaling(scaling)
                .with_bumpers(bumpers, self.bumper.words())
                .signed(self.author.clone(), self.date.clone())
        }))
    }
}
