//! Rows of one shape, as many as there are lanes.

use fearless_simd::Simd;

use super::body::{AtStart, Body};
use super::column::SideBySideColumn;
use super::law::Law;
use super::number::{Lanes, MOST_LANES};
use super::scenes::{Pair, Structure};
use super::tally::SceneSum;
use crate::model::ground::Ground;
use crate::{Node, Row, State};

/// Rows of one shape, as many as there are lanes, or fewer; lanes without one repeat the last.
pub(super) struct Rows<'a, Column> {
    pub(super) rows: &'a [&'a Row<Column>],
    /// Index of the first among all scenes.
    pub(super) first: usize,
}

impl<Column> Clone for Rows<'_, Column> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<Column> Copy for Rows<'_, Column> {}

impl<'a, Column> Rows<'a, Column> {
    /// As many rows as there are lanes, or fewer, and those behind them; rows without others behind them are repeated.
    pub(super) fn split<S: Simd>(self) -> [Self; 2] {
        let (one, other) = self.rows.split_at(self.rows.len().min(Lanes::<S>::N));
        let one = Self { rows: one, ..self };
        if other.is_empty() {
            return [one; 2];
        }
        let first = self.first + one.rows.len();
        [one, Self { rows: other, first }]
    }

    /// The row of a lane.
    pub(super) fn lane(self, lane: usize) -> &'a Row<Column> {
        self.rows[lane.min(self.rows.len() - 1)]
    }

    /// The scene of a lane.
    pub(super) fn scene(self, lane: usize) -> usize {
        self.first + lane.min(self.rows.len() - 1)
    }
}

impl<Column: SideBySideColumn> Rows<'_, Column> {
    /// The states of all rows at t = 0, where the ground has these accelerations \[m/s²\].
    pub(super) fn states<S: Simd>(self, ground: Lanes<S>) -> Vec<Vec<State>> {
        let rows = self.rows.iter().enumerate();
        let of_row =
            |(lane, row): (usize, &&Row<Column>)| row.initial(Ground::Common(ground.lane(lane))).0;
        rows.map(of_row).collect()
    }

    /// A structure of all rows in these states at t = 0, for a time step \[s\].
    #[inline(always)]
    pub(super) fn structure<S: Simd>(
        self,
        simd: S,
        node: usize,
        (states, time_step): (&[Vec<State>], f64),
    ) -> Structure<S, Column> {
        let gather = |number: &dyn Fn(&Node<Column>) -> f64| self.gather(simd, node, number);
        let of_states = |number: &dyn Fn(&Row<Column>, &[State]) -> f64| {
            let mut values = [0.0; MOST_LANES];
            for (lane, value) in values.iter_mut().enumerate().take(Lanes::<S>::N) {
                *value = number(self.lane(lane), &states[lane.min(states.len() - 1)]);
            }
            Lanes::new(simd, &values)
        };
        let start = AtStart {
            displacement: of_states(&|_, states| states[node].displacement),
            velocity: of_states(&|_, states| states[node].velocity),
            acceleration: of_states(&|_, states| states[node].acceleration),
            drift: of_states(&|row, states| row.drift(node, states)),
        };
        Body::new(gather, &start, time_step)
    }

    /// A number of a structure of all rows.
    #[inline(always)]
    pub(super) fn gather<S: Simd>(
        self,
        simd: S,
        node: usize,
        number: &dyn Fn(&Node<Column>) -> f64,
    ) -> Lanes<S> {
        let mut values = [0.0; MOST_LANES];
        for (lane, value) in values.iter_mut().enumerate().take(Lanes::<S>::N) {
            *value = number(&self.lane(lane).nodes()[node]);
        }
        Lanes::new(simd, &values)
    }

    /// Both structures of rows that have two.
    #[inline(always)]
    pub(super) fn two<S: Simd>(
        self,
        simd: S,
        start: (&[Vec<State>], f64),
    ) -> [Structure<S, Column>; 2] {
        [
            self.structure(simd, 0, start),
            self.structure(simd, 1, start),
        ]
    }

    /// The pair of a structure and its right neighbour, if the rows have one.
    #[inline(always)]
    pub(super) fn pair<S: Simd>(self, simd: S, left: usize) -> Option<Pair<S>> {
        let mut pairs = self.rows[0].pairs().iter();
        let index = pairs.position(|pair| pair.left == left)?;
        let pairs: [_; MOST_LANES] = std::array::from_fn(|lane| &self.lane(lane).pairs()[index]);
        let mass = |lane: usize| self.lane(lane).reduced_mass(pairs[lane]);
        Some(Pair {
            index,
            lingers: false,
            gap: Lanes::new(simd, &pairs.map(|pair| pair.gap)),
            law: Law::new(simd, pairs.map(|pair| pair.law), std::array::from_fn(mass)),
            deformation: Lanes::splat(simd, 0.0),
            tally: SceneSum::new(simd),
        })
    }
}
