//! Impulses of pairs that touch at a node and form no chain: lane by lane, by the solver of a scene alone.

use fearless_simd::Simd;

use super::column::SideBySideColumn;
use super::number::{Lanes, Mask};
use super::rows::Rows;
use pounding_solver::Relation;
use pounding_solver::formulas::{Closed, Jumps};

/// The scene of a lane.
pub(super) struct Strikes {
    jumps: Jumps,
    pairs: Vec<(Relation, Closed)>,
    /// Velocity of every node \[m/s\].
    pub(super) velocities: Vec<f64>,
}

/// Velocities beyond which a scene has long left all bounds \[m/s\]: it is not told, and its impulses could overflow.
const FASTEST: f64 = 1e100;

impl Strikes {
    /// The scene of each lane; none for rows whose pairs form a chain.
    pub(super) fn of<S: Simd, Column: SideBySideColumn>(rows: Rows<'_, Column>) -> Vec<Self> {
        let scene = |lane: usize| {
            let row = rows.lane(lane);
            let pairs = row.pairs().iter().map(|pair| {
                let restitution = pair.law.impulsive().map_or(f64::NAN, |law| law.restitution);
                (pair.relation, Closed::on_one_ground(restitution))
            });
            Self {
                jumps: Jumps::new(row),
                pairs: pairs.collect(),
                velocities: vec![0.0; row.nodes().len()],
            }
        };
        let lanes = if rows.lane(0).is_chain() { 0 } else { Lanes::<S>::N };
        (0..lanes).map(scene).collect()
    }

    /// Strikes pairs that touch in this lane until none approaches; the impulse of each \[N·s\], or `None` if none approaches.
    pub(super) fn strike_all<S: Simd>(&mut self, lane: usize, touching: &[(usize, Mask<S>)]) -> Option<impl Iterator<Item = (usize, f64)>> {
        self.jumps.clear();
        for (pair, _) in touching.iter().filter(|(_, touches)| touches.test(lane)) {
            let (relation, closed) = self.pairs[*pair];
            self.jumps.push(*pair, relation, closed);
        }
        let is_slow = self.velocities.iter().all(|velocity| velocity.abs() < FASTEST);
        // On one ground no walls close in.
        let strikes = is_slow && matches!(self.jumps.strike_all(&mut self.velocities), Ok(true));
        strikes.then(|| self.jumps.struck())
    }
}
