//! Response spectra of pairs of horizontal components: median and maximum over all directions, geometric mean.

use pounding::assess::{HorizontalPair, Suite};
use pounding::report::{pair_spectra_table, pair_spectral_columns};
use pounding::scene::{PairSpectrum, pair_spectra};
use pounding::text::{Answer, Form, Refused, Table, Where, digits, percent};
use serde_json::{Value, json};

use super::{Arguments, periods};
use crate::progress::Counter;

/// The spectra of every pair among the files.
pub(super) fn run(args: &Arguments) -> Result<String, Refused> {
    let suite = Suite::of(&args.files, args.declared.of_folder())?;
    let pairs = suite.pairs();
    if pairs.is_empty() {
        let found = Refused::at("--pairs").found(format!("{} and no pair of horizontal components", suite.counts()));
        let found = found.allowed_are("two components of one recording, at right angles, with one time step and one unit");
        return Err(found.so("; ", suite.remarks(false).join("; ")));
    }
    let periods = periods(args)?;
    let progress = Counter::new(0, (pairs.len() * periods.len() * args.damping.len()) as u64);
    let spectra = pairs.iter().map(|pair| {
        let done = || progress.add(1);
        Ok((pair.name(), spectra(args, pair, &periods, &done)?))
    });
    let spectra: Vec<(String, Vec<PairSpectrum>)> = spectra.collect::<Result<_, Refused>>()?;
    drop(progress);
    Ok(answer(args, &suite, &pairs, &spectra).text(Form::asked(false, args.csv, args.json)))
}

fn spectra(args: &Arguments, pair: &HorizontalPair<'_>, periods: &[f64], done: &(dyn Fn() + Sync)) -> Result<Vec<PairSpectrum>, Refused> {
    let [first, second] = args.declared.use_pair(pair)?;
    pair_spectra([&first, &second], periods, &args.damping, None, done).map_err(|refused| refused.in_file(&pair.motions[0].path))
}

fn answer<'a>(args: &Arguments, suite: &Suite, pairs: &[HorizontalPair<'_>], spectra: &'a [(String, Vec<PairSpectrum>)]) -> Answer<'a> {
    let gravity = args.declared.gravity;
    let numbers = |spectrum: &'a PairSpectrum| pair_spectral_columns(Table::of(&spectrum.values).gravity(gravity), |values| values);
    let each = pairs.iter().zip(spectra);
    let answer = each.clone().fold(Answer::new(), |answer, (pair, (name, spectra))| {
        let components = [0, 1].map(|index| {
            let from = if pair.angles.from_north { " from north" } else { "" };
            let word = ["first", "second"][index];
            format!(
                "{word}: {}, {}°{from}",
                pair.motions[index].name,
                digits(pair.angles.degrees[index])
            )
        });
        let said = [vec![name.clone()], components.into()].concat();
        spectra.iter().fold(answer.say(Where::Terminal, "Pair", said), |answer, spectrum| {
            let table = numbers(spectrum).grid();
            answer
                .say(Where::Terminal, "Damping", vec![percent(spectrum.damping_ratio)])
                .table(Where::Terminal, table)
        })
    });
    let json = |(pair, (name, spectra)): (&HorizontalPair<'_>, &'a (String, Vec<PairSpectrum>))| {
        let spectra = spectra
            .iter()
            .map(|one| json!({"damping_ratio": one.damping_ratio, "values": numbers(one).json()}));
        json!({
            "pair": name,
            "components": pair.motions.map(|one| one.name.clone()),
            "angles_deg": pair.angles.degrees,
            "from_north": pair.angles.from_north,
            "spectra": spectra.collect::<Vec<Value>>(),
        })
    };
    answer
        .say(Where::Terminal, "Records", suite.said(false))
        .say(Where::Terminal, "Notes", vec![NOTES.into()])
        .fact("gravity_m_per_s2", gravity)
        .fact("pairs", each.map(json).collect::<Vec<_>>())
        .with_csv(move || pair_spectra_table(spectra).csv())
}

const NOTES: &str = "Pseudo-Sa = (2π/T)² Sd. RotD50 and RotD100 are the median and the largest over all directions of the two components \
                     together, each period with its own directions.";
