//! What record files hold, for people and for programs.

use pounding::assess::{LeftOutReason, Suite};
use pounding::motion::{Interval, Reading, Unusual};
use pounding::report::{HeaderFacts, MeasuredRecord};
use pounding::scene::{PairValues, SpectrumIntensities};
use pounding::text::{Answer, Cell, Manner, NONE, Table, Where, cut, digits, percent, short, two_digits};
use serde_json::{Value, json};

use super::{ListedMotion, MeasuredMotion};

/// Sentences about one motion, a table of several.
pub(super) fn answer<'a>(motions: &'a [ListedMotion], suite: &Suite, pairs: &[(String, PairValues)], gravity: f64) -> Answer<'a> {
    let answer = match motions {
        [motion] => match &motion.found {
            Ok(found) => of_one(motion, found, gravity),
            Err(refused) => Answer::new().say(Where::Terminal, "Left out", vec![refused.to_string()]),
        },
        motions => of_several(motions, suite, gravity).say(Where::Terminal, "Pairs", said_of(pairs, gravity)),
    };
    answer
        .fact("gravity_m_per_s2", gravity)
        .fact("records", suite.json())
        .fact(
            "pairs",
            pairs.iter().map(|(name, peaks)| pair_json(name, peaks)).collect::<Vec<_>>(),
        )
        .fact("motions", motions.iter().map(json_of).collect::<Vec<_>>())
        .with_csv(move || listed(Table::of(motions), gravity, false).csv())
}

/// Peak accelerations of the pairs, a line each.
fn said_of(pairs: &[(String, PairValues)], gravity: f64) -> Vec<String> {
    let line = |(name, peaks): &(String, PairValues)| {
        let [rotd50, rotd100, mean] = [peaks.rotd50, peaks.rotd100, peaks.geometric_mean].map(|peak| short(peak / gravity));
        format!("{name}: PGA {rotd50} g RotD50, {rotd100} g RotD100, {mean} g geometric mean")
    };
    pairs.iter().map(line).collect()
}

fn pair_json(name: &str, peaks: &PairValues) -> Value {
    json!({
        "pair": name,
        "pga_rotd50_m_per_s2": peaks.rotd50,
        "pga_rotd100_m_per_s2": peaks.rotd100,
        "pga_geometric_mean_m_per_s2": peaks.geometric_mean,
    })
}

fn of_one<'a>(motion: &ListedMotion, found: &MeasuredMotion, gravity: f64) -> Answer<'a> {
    let (file, record) = (found.opened.file(), &found.opened.record);
    let of_file = |text: &str| text.lines().map(String::from).collect::<Vec<_>>();
    let provenance = Some(file.provenance()).filter(|text| !text.trim().is_empty());
    let samples = format!(
        "{} samples, {} s apart, {} s long",
        record.samples().len(),
        record.time_step(),
        digits(record.duration())
    );
    let direction = match &found.placed {
        Ok((Some(_), _)) => "horizontal".into(),
        Ok((None, _)) => "not told, by the file or by its name: it counts as horizontal".into(),
        Err(reason) => format!("shakes no row of a folder: {}", reason.sentence()),
    };
    let drift = found.drift.map(|drift| {
        let (velocity, share) = (short(drift.velocity), percent(drift.share));
        format!("{velocity} m/s on average over the last tenth, {share} of PGV; {DRIFT}")
    });
    Answer::new()
        .say(Where::Terminal, "File", vec![motion.path.display().to_string()])
        .say(Where::Terminal, "Read", file.readings().iter().map(reading).collect())
        .say(Where::Terminal, "It says", provenance.map(of_file).unwrap_or_default())
        .say(Where::Terminal, "Record", vec![samples])
        .say(Where::Terminal, "Direction", vec![direction])
        .say(Where::Terminal, "Unusual", file.unusual().iter().map(ToString::to_string).collect())
        .say_as(Where::Terminal, Manner::Facts, "", measures(found, gravity))
        .say(Where::Terminal, "Drift", drift.into_iter().collect())
        .say(Where::Terminal, "Notes", vec![NOTES.into()])
}

const NOTES: &str = "PGV and PGD without correction of the baseline; Arias intensity with g = 9.80665 m/s²; CAV without \
                     threshold; D: while the Arias intensity grows from 5 % to 75 % and to 95 %; Tm: mean period of Fourier \
                     amplitudes, 0.25 to 20 Hz; Housner: ∫ PSV dT from 0.1 to 2.5 s, ASI: ∫ PSA dT from 0.1 to 0.5 s, damping 5 %.";

/// A reading of a file, with its line.
fn reading(one: &Reading) -> String {
    let line = one.line.map_or(String::new(), |line| format!(" (line {line})"));
    format!("{}: {}{line}", one.what, one.found)
}

fn measures(found: &MeasuredMotion, gravity: f64) -> Vec<String> {
    let measures = &found.measures;
    let (time, peak) = found.opened.record.peak();
    let duration = |interval: Option<Interval>| {
        interval.map_or(NONE.into(), |interval| {
            let [duration, start, end] = [interval.duration(), interval.start, interval.end].map(short);
            format!("{duration} s, from {start} s to {end} s")
        })
    };
    let record = &found.opened.record;
    let tm = record.mean_period().map(|period| format!("Tm: {} s", short(period)));
    // A record too long for a spectrum has none.
    let spectral = SpectrumIntensities::of(record).ok().map(|SpectrumIntensities { housner, asi }| {
        let (housner, asi) = (short(housner), short(asi));
        [format!("Housner: {housner} m"), format!("ASI: {asi} m/s")]
    });
    let strong = measures.bracketed.map(|interval| {
        let uniform = short(measures.uniform);
        format!("0.05 g: {}, {uniform} s of it at or above", duration(Some(interval)))
    });
    let all = [
        format!(
            "PGA: {} g = {} m/s² at {} s",
            short(measures.pga / gravity),
            short(peak),
            digits(time)
        ),
        format!("PGV: {} m/s", short(measures.pgv)),
        format!("PGD: {} m", short(measures.pgd)),
        format!("Arias: {} m/s", short(measures.arias)),
        format!("CAV: {} m/s", short(measures.cav)),
        format!("D5–75: {}", duration(measures.d5_75)),
        format!("D5–95: {}", duration(measures.d5_95)),
    ];
    all.into_iter()
        .chain(strong)
        .chain(tm)
        .chain(spectral.into_iter().flatten())
        .collect()
}

/// A row for each motion, and what became of the files.
fn of_several<'a>(motions: &[ListedMotion], suite: &Suite, gravity: f64) -> Answer<'a> {
    let file = &motions[0].path;
    let of_one_file = motions.iter().all(|motion| motion.path == *file);
    let found = motions.iter().filter_map(|motion| Some((motion, motion.found.as_ref().ok()?)));
    let format = found.clone().map(|(_, found)| found.opened.file().format().name()).next();
    let of_file = [format!("File: {}", file.display()), format!("Format: {}", format.unwrap_or(NONE))];
    let unusual = found.clone().flat_map(|(motion, found)| {
        let unusual = found.opened.file().unusual().iter();
        unusual.map(move |one| (name(motion, of_one_file), one))
    });
    let (peaks, others): (Vec<_>, Vec<_>) = unusual.partition(|(_, one)| matches!(one, Unusual::Peak { .. }));
    let unusual = says_peaks(&peaks).into_iter();
    let unusual = unusual.chain(others.iter().map(|(name, one)| format!("{name}: {one}")));
    let drifting = found.clone().filter(|(_, found)| found.drift.is_some());
    let drifting: Vec<String> = drifting.map(|(motion, _)| name(motion, of_one_file)).collect();
    let drift = (!drifting.is_empty()).then(|| format!("{}: {DRIFT}", drifting.join("; ")));
    let note = if of_one_file {
        Some("--component takes one, by its name, a part of it, or its number")
    } else if motions.iter().any(|motion| motion.component.is_some()) {
        Some("a file with several components has a line for each; --component takes one, by its name, a part of it, or its number")
    } else {
        None
    };
    let of_file = if of_one_file { of_file.into() } else { Vec::new() };
    Answer::new()
        .say_as(Where::Terminal, Manner::Facts, "", of_file)
        .table(
            Where::Terminal,
            listed(Table::of(found.map(|(motion, _)| motion)), gravity, of_one_file).grid(),
        )
        .say(Where::Terminal, "Records", suite.said(true))
        .say(Where::Terminal, "Unusual", unusual.collect())
        .say(Where::Terminal, "Drift", drift.into_iter().collect())
        .say(Where::Terminal, "Notes", note.map(String::from).into_iter().collect())
}

/// Most motions whose peaks are told one by one.
const FEW: usize = 3;

/// Unusual peaks of motions, in one sentence if there are many.
fn says_peaks(peaks: &[(String, &Unusual)]) -> Vec<String> {
    if peaks.len() <= FEW {
        return peaks.iter().map(|(name, one)| format!("{name}: {one}")).collect();
    }
    let found = peaks
        .iter()
        .filter_map(|(_, one)| if let Unusual::Peak { found } = one { Some(*found) } else { None });
    let (least, largest) = found.fold((f64::INFINITY, 0.0_f64), |(least, largest), one| (least.min(one), largest.max(one)));
    let usual = Unusual::USUAL_PEAKS;
    let names: Vec<&str> = peaks.iter().map(|(name, _)| name.as_str()).collect();
    vec![format!(
        "found {} peaks of {} to {} g in the files, usual is {} to {} g; their units decide them: {}",
        peaks.len(),
        two_digits(least),
        two_digits(largest),
        digits(*usual.start()),
        digits(*usual.end()),
        names.join(", ")
    )]
}

/// The cause of a velocity at the end, and what to do.
const DRIFT: &str = "the ground does not come to rest: an offset of the baseline, or a record cut short; PGV and PGD are \
                     those of the drift. A straight line (--detrend linear) or a high-pass (--band-pass) in `motion convert` \
                     takes an offset away, in a scene `detrend` or `band_pass`";

/// Letters of a name in the table, which is then no wider than 80 columns.
const NAME: usize = 21;

/// The name of the component if there is one file, else that of the file, cut before the component.
fn name(motion: &ListedMotion, of_one_file: bool) -> String {
    let path = &motion.path;
    let name = path.file_name().unwrap_or(path.as_os_str());
    let file = name.to_string_lossy().into_owned();
    match &motion.component {
        None => file,
        Some(component) if of_one_file => component.clone(),
        Some(component) => {
            let room = NAME.saturating_sub(component.chars().count() + 1).max(6);
            format!("{} {component}", cut(&file, room))
        }
    }
}

/// The direction of a motion for a program; `None` if nothing tells it.
fn direction(found: &MeasuredMotion) -> Option<&'static str> {
    match &found.placed {
        Ok((direction, _)) => direction.map(|_| "horizontal"),
        Err(reason) => reason.kind.is_vertical().then_some("vertical"),
    }
}

/// Adds the columns of a motion: all for programs, those to compare for people.
fn listed<'a>(table: Table<'a, &'a ListedMotion>, gravity: f64, of_one_file: bool) -> Table<'a, &'a ListedMotion> {
    let read = |motion: &&'a ListedMotion| motion.found.as_ref().ok();
    let file = move |motion: &&'a ListedMotion| read(motion).map(|found| found.opened.file());
    let facts = move |motion: &&'a ListedMotion| file(motion).map(|file| HeaderFacts::of(file.provenance()));
    let placed = move |motion: &&'a ListedMotion| read(motion).map(|found| &found.placed);
    let table = table
        .shown(if of_one_file { "Component" } else { "Record" }, move |motion| {
            name(motion, of_one_file)
        })
        .column("file", |motion| motion.path.display().to_string())
        .column("component", |motion| motion.component.clone())
        .column("direction", move |motion| read(motion).and_then(direction))
        .column("event", move |motion| placed(motion)?.as_ref().ok().map(|(_, event)| event + 1))
        .column("format", move |motion| file(motion).map(|file| file.format().name()))
        .both(
            "unit",
            "Unit",
            move |motion| file(motion).map(|file| file.unit().name()),
            move |motion| file(motion).map(|file| file.unit().symbol()),
        )
        .column("gravity_m_per_s2", move |motion| Cell::exact(read(motion).map(|_| gravity)));
    MeasuredRecord::columns(table, gravity, move |motion| read(motion).map(MeasuredMotion::measured))
        .column("event_name", move |motion| facts(motion)?.event)
        .column("station", move |motion| facts(motion)?.station)
        .column("epicentral_distance_m", move |motion| {
            Cell::exact(facts(motion).and_then(|said| said.epicentral_distance))
        })
        .column("vs30_m_per_s", move |motion| Cell::exact(facts(motion).and_then(|said| said.vs30)))
        .column("left_out", move |motion| {
            placed(motion)?.as_ref().err().map(LeftOutReason::sentence)
        })
        .column("refused", |motion| motion.found.as_ref().err().map(ToString::to_string))
}

/// A motion for programs, with its readings.
fn json_of(motion: &ListedMotion) -> Value {
    let mut all = match &motion.found {
        Err(reason) => json!({"refused": reason.to_string()}),
        Ok(found) => of_found(found),
    };
    all["file"] = json!(motion.path.display().to_string());
    all["component"] = json!(motion.component);
    all
}

fn of_found(found: &MeasuredMotion) -> Value {
    let mut all = found.measured().json(Some(&found.opened.origin));
    all["direction"] = json!(direction(found));
    match &found.placed {
        Ok((_, event)) => all["event"] = json!(event + 1),
        Err(reason) => all["left_out"] = json!(reason.sentence()),
    }
    all
}
