//! The effects of pounding on every storey.

use pounding_assess::{Effects, FloorEffects, Known};
use pounding_scene::{RecordUse, Simulation};
use pounding_text::{Answer, Grid, Manner, Shown, Table, Unit, Where, percent};

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
         every multiple. All are for the contact stiffness of the scene, which nobody knows well: accelerations depend on it, and `pounding assess` \
         gives their range. Impulsive impacts accelerate without bound and are left out of accelerations. Collisions, \
         impulses and accelerations are those of the floor above the storey, of both its sides together.",
        percent(Known::ROBUST),
        percent(effects.largest_error())
    );
    let ranges = "Below a number stand its least and largest values under these changes of the record.";
    answer
        .table(Where::FirstScreen, table(prepared, effects, false))
        .table(Where::Details, table(prepared, effects, true))
        .say_as(Where::Details, Manner::Soft, "Ranges", vec![ranges.into()])
        .say_as(Where::Everywhere, Manner::Soft, "Effects", vec![notes])
        .figure("effects")
}

/// A row for each direction of every storey, each building from the ground up; `full` has the peaks and their ranges, too.
fn table(prepared: &Simulation, effects: &Effects, full: bool) -> Grid {
    let floors = prepared.floors();
    let shown = floors.by_structure().filter(|floor| effects.concern(*floor));
    let rows = shown.flat_map(|floor| {
        let (as_given, reversed) = (&effects.as_given[floor], &effects.reversed[floor]);
        [
            (floors.storey_name(floor), as_given),
            (format!("  {}", RecordUse::direction_of(true)), reversed),
        ]
    });
    let gravity = prepared.scene().record.gravity_m_per_s2;
    let known = move |known: &Known, unit: &Unit| {
        let mark = if known.is_robust() { "" } else { "~" };
        let [value, low, high] = [known.value, known.low, known.high].map(|value| unit.text_of(value, gravity));
        let range = Some(format!("{low} to {high}")).filter(|_| full && known.change() > 0.0);
        Shown::from(format!("{mark}{value}")).over(range)
    };
    let table = Table::of(rows)
        .shown("Storey, direction", |(name, _)| Shown::from(name.as_str()))
        .shown("Collisions", move |(_, floor)| known(&floor.collisions, &Unit::COUNT))
        .shown_in(Unit::NEWTON_SECOND.shown, "Sum of impulses", move |(_, floor)| {
            known(&floor.impulse_n_s, &Unit::NEWTON_SECOND)
        });
    let responses = [
        ("Drift", &Unit::METRE),
        ("Shear", &Unit::NEWTON),
        ("Acceleration at this stiffness", &Unit::ACCELERATION),
    ];
    let table = responses.into_iter().enumerate().fold(table, |table, (response, (name, unit))| {
        let effect = move |floor: &FloorEffects| floor.responses()[response];
        let table = if full {
            table.shown_in(unit.shown, name, move |(_, floor)| {
                effect(floor).map(|effect| unit.text_of(effect.beside, gravity))
            })
        } else {
            table
        };
        table.shown(format!("{name} × alone"), move |(_, floor)| {
            let ratio = effect(floor).and_then(|effect| effect.amplification);
            Shown::from(ratio.map(|ratio| known(&ratio, &Unit::RATIO)))
        })
    });
    table.grid()
}
