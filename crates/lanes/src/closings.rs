//! How far neighbours come towards each other, for scenes in lanes; see [`Closings`](pounding_solver::Closings) for a single scene.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::body::Body;
use super::number::{Lanes, Mask};
use super::scenes::LanePair;
use pounding_solver::RestoringForce;
use pounding_solver::formulas::{Cubic, CubicNode as Node, controls};

/// How far two neighbours have come towards each other \[m\].
#[derive(Clone, Copy)]
pub(super) struct Nearest<S: Simd>(Lanes<S>);

/// Displacement \[m\] and velocity \[m/s\] of the left neighbour minus those of the right neighbour, at an instant \[s\].
#[derive(Clone, Copy)]
pub(super) struct Apart<S: Simd> {
    pub(super) time: Lanes<S>,
    pub(super) displacement: Lanes<S>,
    pub(super) velocity: Lanes<S>,
}

impl<S: Simd> Nearest<S> {
    /// The value before any motion.
    #[inline(always)]
    pub(super) fn new(simd: S) -> Self {
        Self(Lanes::splat(simd, f64::NEG_INFINITY))
    }

    /// The value of a lane \[m\].
    #[inline(always)]
    pub(super) fn lane(&self, lane: usize) -> f64 {
        self.0.lane(lane)
    }

    /// Adds the cubics between two instants, in these lanes. Their control points bound them, so that most cubics are skipped.
    #[inline(always)]
    pub(super) fn follow(&mut self, start: &Apart<S>, end: &Apart<S>, lanes: Mask<S>) {
        let ends = [start, end].map(|apart| [apart.displacement, apart.velocity]);
        let higher = controls(end.time - start.time, ends).map(|height| height.exceeds(self.0));
        let [one, two, three, four] = higher;
        let mut higher = ((one | two | three | four) & lanes).bits();
        while higher != 0 {
            let lane = higher.trailing_zeros() as usize;
            higher &= higher - 1;
            let node = |apart: &Apart<S>| Node {
                time: apart.time.lane(lane),
                displacement: apart.displacement.lane(lane),
                velocity: apart.velocity.lane(lane),
            };
            let cubic = Cubic {
                start: node(start),
                end: node(end),
            };
            let distance = cubic.highest().distance;
            if distance > self.0.lane(lane) {
                self.0.set(lane, distance);
            }
        }
    }
}

/// Closings of the pairs of a group, from node to node of the central difference method.
pub(super) struct Closings<S: Simd> {
    time_step: f64,
    /// Number of the present node.
    node: usize,
    /// Velocities of all structures at the last node, in the order of structures \[m/s\].
    velocities: Vec<Lanes<S>>,
    gaps: Vec<Gap<S>>,
}

/// The gap between two neighbours.
struct Gap<S: Simd> {
    /// Index of the pair in the row, and places of the neighbours among the structures.
    pair: usize,
    places: [usize; 2],
    /// State at the node before, after its jumps, and at the present node.
    last: Apart<S>,
    displacement: Lanes<S>,
    nearest: Nearest<S>,
}

impl<S: Simd> Closings<S> {
    /// Closings of these pairs of a chain of `n` nodes, for steps of this length \[s\]; `place` gives the place of a node's structure.
    #[inline(always)]
    pub(super) fn new(simd: S, time_step: f64, n: usize, pairs: &[LanePair<S>], place: impl Fn(usize) -> usize) -> Self {
        let zero = Lanes::splat(simd, 0.0);
        let gap = |pair: &LanePair<S>| Gap {
            pair: pair.index,
            places: [pair.left, pair.left + 1].map(&place),
            last: Apart {
                time: zero,
                displacement: zero,
                velocity: zero,
            },
            displacement: zero,
            nearest: Nearest::new(simd),
        };
        Self {
            time_step,
            node: 0,
            velocities: vec![zero; n],
            gaps: pairs.iter().map(gap).collect(),
        }
    }

    /// How far the neighbours of a pair have come towards each other in a lane \[m\].
    #[inline(always)]
    pub(super) fn of(&self, pair: usize, lane: usize) -> Option<f64> {
        let gap = self.gaps.iter().find(|gap| gap.pair == pair)?;
        Some(gap.nearest.lane(lane))
    }

    /// Reads the displacements of structures before the step from a node.
    #[inline(always)]
    pub(super) fn look<Column: RestoringForce<Lanes<S>>>(&mut self, structures: &[Body<S, Column>]) {
        for gap in &mut self.gaps {
            let [left, right] = gap.places.map(|place| structures[place].motion.displacement);
            gap.displacement = left - right;
        }
    }

    /// Reads the velocities of structures at this node, known after the step, before they jump.
    #[inline(always)]
    pub(super) fn arrive<Column: RestoringForce<Lanes<S>>>(&mut self, structures: &[Body<S, Column>]) {
        for (velocity, structure) in self.velocities.iter_mut().zip(structures) {
            *velocity = structure.velocity_before();
        }
        for gap in &mut self.gaps {
            let [left, right] = gap.places.map(|place| self.velocities[place]);
            let end = Apart {
                time: left.like(self.node as f64 * self.time_step),
                displacement: gap.displacement,
                velocity: left - right,
            };
            if self.node > 0 {
                let all = Mask::splat(left.token(), true);
                gap.nearest.follow(&gap.last, &end, all);
            }
            gap.last = end;
        }
        self.node += 1;
    }

    /// Sets the velocity of a structure after an impact \[m/s\].
    #[inline(always)]
    pub(super) fn jump(&mut self, place: usize, velocity: Lanes<S>) {
        self.velocities[place] = velocity;
        for gap in self.gaps.iter_mut().filter(|gap| gap.places.contains(&place)) {
            let [left, right] = gap.places.map(|place| self.velocities[place]);
            gap.last.velocity = left - right;
        }
    }
}
