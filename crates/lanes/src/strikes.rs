//! Impulses of the pairs that touch at a node, in lanes.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::column::SideBySideColumn;
use super::law::Impulsive;
use super::number::{Lanes, Mask};
use super::rows::Rows;
use super::scenes::LanePair;
use pounding_solver::Relation;
use pounding_solver::formulas::{Closed, Jumps, Rounds, Touching};

/// The impulsive pairs that touch, by the solver that their row has alone.
pub(super) enum Strikes<S: Simd> {
    /// A chain: all scenes at once.
    Chain(Box<Rounds<Lanes<S>>>),
    /// Any other pairs: scene by scene.
    Any(Box<EachAlone<S>>),
}

/// Scenes whose impulses are found one after the other.
pub(super) struct EachAlone<S: Simd> {
    scenes: Vec<Scene>,
    /// Pairs that touch, and nodes that carry their points.
    pairs: Vec<usize>,
    nodes: Vec<usize>,
    /// Impulse of every pair \[N·s\], and velocity of every node after the impacts \[m/s\].
    impulses: Vec<Lanes<S>>,
    velocities: Vec<Lanes<S>>,
}

/// The scene of a lane.
struct Scene {
    jumps: Jumps,
    /// Relation and coefficient of restitution of every pair.
    pairs: Vec<(Relation, Closed)>,
    velocities: Vec<f64>,
}

/// Velocities beyond which a scene has long left all bounds \[m/s\]: it is not told, and its impulses could overflow.
const FASTEST: f64 = 1e100;

impl<S: Simd> Strikes<S> {
    /// Strikes of rows of a common shape. `mobility` gives the velocity of a node under a unit impulse \[1/kg\].
    #[inline(always)]
    pub(super) fn new<Column: SideBySideColumn>(simd: S, rows: Rows<'_, Column>, mobility: impl Fn(usize) -> Lanes<S>) -> Self {
        let (n, n_pairs) = (rows.lane(0).nodes().len(), rows.lane(0).pairs().len());
        if rows.lane(0).is_chain() {
            return Self::Chain(Box::new(Rounds::new((0..n).map(mobility).collect(), n_pairs)));
        }
        let scene = |lane: usize| {
            let row = rows.lane(lane);
            let pairs = row.pairs().iter().map(|pair| {
                let restitution = pair.law.impulsive().map_or(f64::NAN, |law| law.restitution);
                (pair.relation, Closed::on_one_ground(restitution))
            });
            Scene {
                jumps: Jumps::new(row),
                pairs: pairs.collect(),
                velocities: vec![0.0; n],
            }
        };
        let zero = Lanes::splat(simd, 0.0);
        Self::Any(Box::new(EachAlone {
            scenes: (0..Lanes::<S>::N).map(scene).collect(),
            pairs: Vec::with_capacity(n_pairs),
            nodes: Vec::with_capacity(4 * n_pairs),
            impulses: vec![zero; n_pairs],
            velocities: vec![zero; n],
        }))
    }

    /// Adds a pair that touches in these lanes.
    #[inline(always)]
    pub(super) fn push(&mut self, pair: &LanePair<S>, law: Impulsive<S>, touches: Mask<S>) {
        match self {
            Self::Chain(rounds) => rounds.push(pair.index, pair.left, Touching::on_one_ground(touches, law.factor)),
            Self::Any(each) => each.push(pair.index, touches),
        }
    }

    /// Strikes until no pair that touches approaches; false if none does.
    #[inline(always)]
    pub(super) fn strike_all(&mut self, velocity: impl Fn(usize) -> Lanes<S>) -> bool {
        match self {
            Self::Chain(rounds) => rounds.strike_all(velocity),
            Self::Any(each) => each.strike_all(velocity),
        }
    }

    /// The pairs that touch, each with its impulse \[N·s\].
    #[inline(always)]
    pub(super) fn each_pair(&self, mut take: impl FnMut(usize, Lanes<S>)) {
        match self {
            Self::Chain(rounds) => rounds.struck().for_each(|(link, impulse)| take(link.pair, impulse)),
            Self::Any(each) => each.pairs.iter().for_each(|pair| take(*pair, each.impulses[*pair])),
        }
    }

    /// The nodes of these pairs, some more than once, each with its velocity after the impacts \[m/s\].
    #[inline(always)]
    pub(super) fn each_node(&self, mut take: impl FnMut(usize, Lanes<S>)) {
        match self {
            Self::Chain(rounds) => {
                for link in rounds.links() {
                    for node in [link.left, link.right] {
                        take(node, rounds.velocity(node));
                    }
                }
            }
            Self::Any(each) => each.nodes.iter().for_each(|node| take(*node, each.velocities[*node])),
        }
    }

    /// Forgets the pairs.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        match self {
            Self::Chain(rounds) => rounds.clear(),
            Self::Any(each) => each.clear(),
        }
    }
}

impl<S: Simd> EachAlone<S> {
    fn clear(&mut self) {
        self.pairs.clear();
        self.nodes.clear();
        for scene in &mut self.scenes {
            scene.jumps.clear();
        }
    }

    fn push(&mut self, pair: usize, touches: Mask<S>) {
        self.pairs.push(pair);
        let (relation, _) = self.scenes[0].pairs[pair];
        self.nodes.extend(relation.pushes().map(|(node, _)| node));
        for (lane, scene) in self.scenes.iter_mut().enumerate() {
            if touches.test(lane) {
                let (relation, closed) = scene.pairs[pair];
                scene.jumps.push(pair, relation, closed);
            }
        }
    }

    fn strike_all(&mut self, velocity: impl Fn(usize) -> Lanes<S>) -> bool {
        for pair in &self.pairs {
            self.impulses[*pair] = self.impulses[*pair].like(0.0);
        }
        for node in &self.nodes {
            self.velocities[*node] = velocity(*node);
        }
        let mut any = false;
        for (lane, scene) in self.scenes.iter_mut().enumerate() {
            for node in &self.nodes {
                scene.velocities[*node] = self.velocities[*node].lane(lane);
            }
            let slow = |node: &usize| scene.velocities[*node].abs() < FASTEST;
            // On one ground no walls close in.
            if !self.nodes.iter().all(slow) || !matches!(scene.jumps.strike_all(&mut scene.velocities), Ok(true)) {
                continue;
            }
            any = true;
            for (pair, impulse) in scene.jumps.struck() {
                self.impulses[pair].set(lane, impulse);
            }
            for node in &self.nodes {
                self.velocities[*node].set(lane, scene.velocities[*node]);
            }
        }
        any
    }
}
