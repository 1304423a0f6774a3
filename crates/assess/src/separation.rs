//! Required widths of the gaps of a row: between floors that face each other, and between floors and the columns that they face.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use pounding_scene::{Error, Excess, Extras, Floors, Property, RunResult, STANDARD_GRAVITY, Simulation};
use pounding_solver::{Closing, Closings};

/// Required width of one gap under one record.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Separation {
    /// Index of the structure on the left.
    pub left: usize,
    /// Level of the floors that need the largest width, counted from 1 for the lowest, like `levels` of contacts.
    pub at_level: usize,
    /// Whether the floor at that level faces a column of the neighbour.
    pub at_column: bool,
    /// Width below which the neighbours touch \[m\]: the largest closing of the gap at that level while nothing touches.
    pub required: f64,
    /// Instant of the largest closing \[s\].
    pub time: f64,
    /// Largest displacement of each neighbour while nothing touches \[m\], without sign; of a column at most.
    pub peaks: [f64; 2],
    /// Natural period \[s\] and damping ratio of each neighbour; `None` for a wall.
    pub oscillations: [Option<(f64, f64)>; 2],
    /// Whether the floors of both neighbours are level up to the lower roof, by the heights in the scene or by its field `floors`. Floors that may not
    /// touch count, too.
    pub level: bool,
    /// Whether a neighbour is told to stand on isolators: rules for joints between buildings do not size its moat.
    pub isolated: bool,
    /// Width below which floors hit columns \[m\]; `None` if no floor faces a column.
    pub beside_columns: Option<f64>,
    /// Height of that level, and of the lower of both buildings \[m\]; `None` if the scene does not give them.
    pub heights: Option<[f64; 2]>,
    /// Owners of the ground on both sides.
    pub property: Property,
    /// Ground acceleration of the site \[g\]: that of the target spectrum of a code, or else the peak of the record as it shakes the row.
    pub pga_g: f64,
}

/// Relative uncertainty of the required width \[–\]: the search for the largest closing leaves out terms of 1e-12, and more in long series.
const LOOKED: f64 = 1e-8;

impl Separation {
    /// Returns the required width of every gap under the record of a simulation, by the exact method. Two adjacent walls have no gap.
    ///
    /// Gaps and contact laws of the scene do not matter: every structure moves alone.
    ///
    /// # Errors
    /// Errors of [`Simulation::run_with`].
    pub fn of(simulation: &Simulation) -> Result<Vec<Self>, Error> {
        Ok(JudgedSeparations::of(simulation)?.separations)
    }

    /// Returns the required width of every gap, from a run of the row alone and its closings, as it shakes or under the mirrored shaking.
    pub(crate) fn all(apart: &Simulation, alone: &RunResult, closings: &Closings, reversed: bool) -> Vec<Self> {
        let floors = apart.floors();
        let peak = |floor: usize| alone.peaks.of(floor).displacement.value.abs();
        let mut widest: BTreeMap<usize, Self> = BTreeMap::new();
        for (left, one, other) in floors.all_facing() {
            let closing = if reversed { closings.of_reversed(one) } else { closings.of(one) };
            let Some(closing) = closing else {
                continue;
            };
            let sides = Sides {
                left,
                floors: [one, other],
                peaks: [one, other].map(peak),
                at_column: false,
            };
            widen(&mut widest, Self::at(apart, &sides, closing));
        }
        for (index, one) in floors.beside_all_columns().iter().enumerate() {
            let Some(closing) = closings.of_column(index, reversed) else {
                continue;
            };
            let mut sides = Sides {
                left: one.gap,
                floors: [one.floor, one.above],
                peaks: one.peaks(alone),
                at_column: true,
            };
            if floors.all()[one.floor].structure != one.gap {
                sides.floors.reverse();
                sides.peaks.reverse();
            }
            widen(&mut widest, Self::at(apart, &sides, closing));
        }
        widest.into_values().collect()
    }

    fn at(apart: &Simulation, sides: &Sides, closing: Closing) -> Self {
        let floors = apart.floors();
        // Neighbours that start apart and only move further apart need no gap.
        let (required, time) = if closing.distance > 0.0 {
            (closing.distance, closing.time)
        } else {
            (0.0, 0.0)
        };
        // A floor beside a column stands below the head of the column.
        let level = sides.floors.iter().map(|floor| floors.levels().level(*floor)).min();
        Self {
            left: sides.left,
            at_level: level.unwrap_or(0) + 1,
            at_column: sides.at_column,
            required,
            time,
            peaks: sides.peaks,
            level: floors.are_level(sides.left),
            isolated: [sides.left, sides.left + 1].into_iter().any(|one| floors.is_isolated(one)),
            beside_columns: sides.at_column.then_some(required),
            oscillations: sides.floors.map(|floor| floors.all()[floor].oscillation(apart.scene())),
            heights: heights(floors, sides.floors),
            property: floors.property(sides.left),
            pga_g: apart.record().peak().1.abs() / STANDARD_GRAVITY,
        }
    }

    /// Largest closing \[m\] of neighbours that move alike.
    pub const ALIKE: f64 = 1e-3;

    /// Whether a width \[m\] is less than the required width, by more than its uncertainty.
    pub fn asks_for_more(&self, width: f64) -> bool {
        width < self.required * (1.0 - LOOKED)
    }
}

/// The required widths of a row, and what they do not help against.
#[derive(Debug, Clone, PartialEq)]
pub struct JudgedSeparations {
    /// The [required widths](Separation::of).
    pub separations: Vec<Separation>,
    /// Responses of the structures that stand apart, with their links, as far as they exceed their model or the limits of codes.
    pub excesses: Vec<Excess>,
    /// The drift or force of every such structure that exceeds a capacity of the scene.
    pub over_capacity: Vec<Excess>,
}

impl JudgedSeparations {
    /// Returns the required widths under the record of a simulation, by the exact method.
    ///
    /// # Errors
    /// Errors of [`Simulation::run_with`].
    pub fn of(simulation: &Simulation) -> Result<Self, Error> {
        let apart = simulation.apart()?.exact()?;
        let run = apart.run_with(Extras {
            closings: true,
            ..Extras::default()
        })?;
        let separations = run.closings.as_ref().map(|closings| Separation::all(&apart, &run, closings, false));
        Ok(Self {
            separations: separations.unwrap_or_default(),
            excesses: apart.all_excesses(&run),
            over_capacity: apart.over_capacity(&run),
        })
    }
}

/// Two floors, or a floor and the head of the column that it faces, from the left.
struct Sides {
    /// Index of the structure on the left.
    left: usize,
    floors: [usize; 2],
    peaks: [f64; 2],
    at_column: bool,
}

/// Keeps the level of a gap that needs most, and the largest width at columns.
fn widen(widest: &mut BTreeMap<usize, Separation>, one: Separation) {
    match widest.entry(one.left) {
        Entry::Vacant(entry) => {
            entry.insert(one);
        }
        Entry::Occupied(mut entry) => {
            let so_far = entry.get_mut();
            let both = [so_far.beside_columns, one.beside_columns].into_iter().flatten();
            let beside_columns = both.reduce(f64::max);
            // Where no level needs a millimetre, rules belong to the one that moves most.
            let moves = |one: &Separation| one.peaks[0] + one.peaks[1];
            let alike = one.required.max(so_far.required) < Separation::ALIKE;
            let is_wider = one.required > so_far.required;
            if is_wider && !alike || alike && moves(&one) > moves(so_far) {
                let required = one.required.max(so_far.required);
                *so_far = Separation { required, ..one };
            }
            so_far.beside_columns = beside_columns;
        }
    }
}

/// Height of the level of two floors, and height of the lower of their buildings \[m\]; walls have no height.
fn heights(floors: &Floors, sides: [usize; 2]) -> Option<[f64; 2]> {
    let moves = sides.iter().filter(|side| !floors.all()[**side].is_wall());
    let roof = |side: usize| {
        let structure = floors.all()[side].structure;
        let roof = floors.of_structure(structure).last()?;
        floors.all()[*roof].elevation_m
    };
    let mut least = [f64::INFINITY; 2];
    for side in moves {
        least[0] = least[0].min(floors.all()[*side].elevation_m?);
        least[1] = least[1].min(roof(*side)?);
    }
    least[0].is_finite().then_some(least)
}
