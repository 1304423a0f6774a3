//! The effects of pounding on every storey.

use pounding_assess::{Effects, FloorEffects, Known};
use pounding_scene::{RecordUse, Simulation};
use pounding_text::{Answer, Grid, Manner, Shown, Table, Where, digits, percent, short, two_decimals};

use crate::page::sentence;

/// The parts of an answer about effects: a table with a row for each direction of every storey.
pub(super) fn parts<'a>(answer: Answer<'a>, prepared: &Simulation, effects: &Effects) -> Answer<'a> {
    if !effects.touch() {
        let why = prepared.floors().says_no_contact().unwrap_or(Effects::NOTHING_TOUCHES);
        let none = format!("none: {why}");
        return answer
            .say(Where::Page, "", vec![sentence(&none)])
            .say(Where::Terminal, "Effects", vec![none]);
    }
    let notes = format!(
        "Peaks beside the neighbours, and as multiples of those of the same building alone, in both directions of shaking. ~ marks what moves \
         by more than {} when the record is made 1 % weaker, stronger, faster or slower: it holds no better than that. All by the exact \
         method; another exact run, with a tolerance ten thousand times as large and a record larger by one part in 10¹², is within {} of \
         every multiple. Impulsive impacts accelerate without bound and are left out of accelerations. Collisions and impulses are those of \
         both sides of a floor together.",
        percent(Known::ROBUST),
        percent(effects.largest_error())
    );
    answer
        .table(Where::FirstScreen, table(prepared, effects, false))
        .table(Where::Details, table(prepared, effects, true))
        .say_as(Where::Everywhere, Manner::Soft, "Effects", vec![notes])
        .figure("effects")
}

/// A row for each direction of every storey, each building from the ground up; `full` has the peaks and their ranges, too.
fn table(prepared: &Simulation, effects: &Effects, full: bool) -> Grid {
    let floors = prepared.floors();
    let shown = floors.by_structure().filter(|floor| effects.concern(*floor));
    let rows = shown.flat_map(|floor| {
        let other = RecordUse::direction_of(!prepared.scene().record.reversed);
        let (as_given, reversed) = (&effects.as_given[floor], &effects.reversed[floor]);
        [(as_given.name.clone(), as_given), (format!("  {other}"), reversed)]
    });
    let known = move |known: &Known, factor: f64, words: fn(f64) -> String| {
        let mark = if known.is_robust() { "" } else { "~" };
        let range = format!("{} to {}", words(factor * known.low), words(factor * known.high));
        let range = Some(range).filter(|_| full && known.change() > 0.0);
        Shown::from(format!("{mark}{}", words(factor * known.value))).over(range)
    };
    let table = Table::of(rows)
        .shown("Storey, direction", |(name, _)| Shown::from(name.as_str()))
        .shown("Collisions", move |(_, floor)| known(&floor.collisions, 1.0, digits))
        .shown_in("kN·s", "Sum of impulses", move |(_, floor)| known(&floor.impulse_n_s, 1e-3, short));
    let responses = [("Drift", "mm", 1e3), ("Shear", "kN", 1e-3), ("Acceleration", "m/s²", 1.0)]
        .into_iter()
        .enumerate();
    let table = responses.fold(table, |table, (response, (name, unit, factor))| {
        let effect = move |floor: &FloorEffects| floor.responses()[response];
        let table = if full {
            table.shown_in(unit, name, move |(_, floor)| {
                effect(floor).map(|effect| short(factor * effect.beside))
            })
        } else {
            table
        };
        table.shown(format!("{name} × alone"), move |(_, floor)| {
            let ratio = effect(floor).and_then(|effect| effect.amplification);
            Shown::from(ratio.map(|ratio| known(&ratio, 1.0, two_decimals)))
        })
    });
    table.grid()
}
