//! Further spectra of a record: strengths of constant ductility, and Fourier amplitudes.

use pounding::report::{ductility_columns, ductility_table, fourier_table};
use pounding::scene::{DuctilitySpectrum, ductility_spectra};
use pounding::text::{Answer, Form, Refused, Table, Where, digits, percent, short};
use serde_json::json;

use super::{Arguments, component, periods, record};
use crate::progress::Counter;

/// Strengths at which a structure has each ductility.
pub(super) fn ductilities(args: &Arguments) -> Result<String, Refused> {
    let opened = args.declared.open(args.file())?;
    let periods = periods(args)?;
    let progress = Counter::new(0, (periods.len() * args.damping.len() * args.ductility.len()) as u64);
    let done = || progress.add(1);
    let spectra = ductility_spectra(&opened.record, &periods, [&args.damping, &args.ductility], None, &done);
    let spectra = spectra.map_err(|refused| refused.in_file(args.file()))?;
    drop(progress);
    let gravity = args.declared.gravity;
    let numbers = |spectrum: &DuctilitySpectrum| ductility_columns(Table::of(spectrum.values.clone()).gravity(gravity), |values| values);
    let answer = Answer::new().say(Where::Terminal, "Record", record(args, &opened));
    let answer = spectra.iter().fold(answer, |answer, spectrum| {
        let of = format!("{}, damping {}", digits(spectrum.ductility), percent(spectrum.damping_ratio));
        answer
            .say(Where::Terminal, "Ductility", vec![of])
            .table(Where::Terminal, numbers(spectrum).grid())
    });
    let json = |spectrum: &DuctilitySpectrum| {
        json!({
            "damping_ratio": spectrum.damping_ratio,
            "ductility": spectrum.ductility,
            "values": numbers(spectrum).json(),
        })
    };
    let answer = answer
        .say(Where::Terminal, "Notes", vec![STRENGTHS.into()])
        .fact("file", args.file().display().to_string())
        .fact("component", component(args, &opened))
        .fact("gravity_m_per_s2", gravity)
        .fact("spectra", spectra.iter().map(json).collect::<Vec<_>>())
        .with_csv(|| ductility_table(&spectra).csv());
    Ok(answer.text(Form::asked(false, args.csv, args.json)))
}

const STRENGTHS: &str = "fy/m: yield force over mass, of elastic-perfectly plastic columns; Sd: largest displacement relative to the ground; R: elastic \
                         force over fy. Of several strengths with the ductility, the largest that a search by 2 % finds.";

/// Fourier amplitudes at the frequencies 1/T of the periods.
pub(super) fn fourier(args: &Arguments) -> Result<String, Refused> {
    let opened = args.declared.open(args.file())?;
    let highest = 0.5 / opened.record.time_step();
    let inside = |frequency: &f64| frequency.is_finite() && *frequency <= highest * (1.0 + 1e-12);
    let periods = periods(args)?;
    let n_asked = periods.len();
    let frequencies = periods.into_iter().map(f64::recip).filter(inside);
    let amplitudes: Vec<[f64; 2]> = frequencies.map(|one| [one, opened.record.fourier_amplitude(one)]).collect();
    if amplitudes.is_empty() {
        let found = Refused::at("--periods").found(format!("none of {} s or more", short(highest.recip())));
        let found = found.allowed(format!(
            "periods of two time steps and more: the samples have no frequencies above {} Hz",
            short(highest)
        ));
        return Err(found.help("ask for longer periods"));
    }
    let left_out = match n_asked - amplitudes.len() {
        0 => String::new(),
        n => format!("; {n} of {n_asked} periods are shorter, and left out"),
    };
    let table = fourier_table(amplitudes);
    let notes = format!(
        "|∫ a exp(−2πi f t) dt| of the samples, which have no frequencies above {} Hz{left_out}.",
        short(highest)
    );
    let answer = Answer::new()
        .say(Where::Terminal, "Record", record(args, &opened))
        .table(Where::Terminal, table.grid())
        .say(Where::Terminal, "Notes", vec![notes])
        .fact("file", args.file().display().to_string())
        .fact("component", component(args, &opened))
        .fact("values", table.json())
        .with_csv(|| table.csv());
    Ok(answer.text(Form::asked(false, args.csv, args.json)))
}
