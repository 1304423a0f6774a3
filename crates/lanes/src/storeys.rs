//! Buildings of several storeys in lanes.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::body::Extremes;
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::number::{Lanes, MOST_LANES, Mask};
use super::rows::Rows;
use super::scenes::Structure;
use pounding_solver::formulas::Buildings;
use pounding_solver::formulas::{Below, damping_force};
use pounding_solver::formulas::{FloorCoefficients, Floors, solve};

/// The floors of rows of a common shape, building by building, each from the ground up.
pub(super) struct Storeys<S: Simd> {
    buildings: Buildings,
    /// Place of each node of the row among the floors.
    places: Vec<usize>,
    coefficients: Vec<FloorCoefficients<Lanes<S>>>,
    /// Damping coefficient of every floor against the ground, in addition to that of its storey \[N·s/m\].
    ground_damping: Vec<Lanes<S>>,
    /// Acceleration of every floor without damping, at nodes at which some lane touches \[m/s²\].
    accelerations: Vec<Lanes<S>>,
    /// Extremes of the drift of every storey on another floor \[m\].
    drifts: Vec<Extremes<S>>,
}

/// A building at a node; `IN_CONTACT` if some lane of the row touches.
struct Building<'a, S: Simd, Column: SideBySideColumn, const IN_CONTACT: bool> {
    zero: Lanes<S>,
    structures: &'a mut [Structure<S, Column>],
    accelerations: &'a mut [Lanes<S>],
    drifts: &'a mut [Extremes<S>],
}

impl<S: Simd> Storeys<S> {
    /// Advances all floors from a node.
    #[inline(always)]
    fn go_on<Column: SideBySideColumn, const IN_CONTACT: bool>(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        for range in self.buildings.ranges() {
            let mut building = Building::<S, Column, IN_CONTACT> {
                zero: ground.like(0.0),
                structures: &mut structures[range.clone()],
                accelerations: &mut self.accelerations[range.clone()],
                drifts: &mut self.drifts[range.clone()],
            };
            solve(&mut building, &self.coefficients[range.clone()], ground);
        }
    }

    /// Acceleration of a floor in equilibrium after the velocity jumps at a node \[m/s²\].
    #[inline(always)]
    fn acceleration<Column: SideBySideColumn>(
        &self,
        building: &[Structure<S, Column>],
        first: usize,
        level: usize,
        ground: Lanes<S>,
    ) -> Lanes<S> {
        let floor = &building[level];
        let below = level.checked_sub(1).map(|lower| &building[lower]);
        let above = building.get(level + 1);
        let place = first + level;
        let below = below.map(|below| Below {
            ground_damping: self.ground_damping[place],
            velocity: below.contact.at_node.jumped,
        });
        let damping = damping_force(floor.dashpot(), below, above.map(Structure::<S, Column>::dashpot));
        let mut restoring = floor.contact.at_node.restoring_force;
        if let Some(above) = above {
            restoring = restoring - above.contact.at_node.restoring_force;
        }
        let pounding = floor.contact.pounding() - damping;
        let own = &self.coefficients[place].own;
        own.smooth(pounding, restoring, own.mobile * ground)
    }

    /// Acceleration of a floor in equilibrium after the velocity jumps, and the lanes in which it or the velocity has jumped.
    #[inline(always)]
    fn after_jump<Column: SideBySideColumn>(
        &self,
        building: &[Structure<S, Column>],
        first: usize,
        level: usize,
        ground: Lanes<S>,
    ) -> (Lanes<S>, Mask<S>) {
        let floor = &building[level];
        let neighbours = [level.checked_sub(1), Some(level + 1)];
        let neighbours = neighbours.map(|level| building.get(level?));
        let zero = ground.like(0.0);
        let (mut around, mut feels) = ([zero; 2], floor.contact.restarts());
        for (velocity, neighbour) in around.iter_mut().zip(neighbours) {
            if let Some(neighbour) = neighbour {
                *velocity = neighbour.contact.at_node.velocity;
                feels = feels | neighbour.contact.at_node.jumps();
            }
        }
        let velocities = [around[0], floor.contact.at_node.velocity, around[1]];
        let rates = &self.coefficients[first + level].rates;
        let before = self.accelerations[first + level] - rates.deceleration(velocities);
        let after = self.acceleration::<Column>(building, first, level, ground);
        let after = Number::select(feels, after, before);
        (after, floor.contact.restarts() | (after - before).abs().exceeds(zero))
    }
}

impl<S: Simd, Column: SideBySideColumn, const IN_CONTACT: bool> Floors<Lanes<S>> for Building<'_, S, Column, IN_CONTACT> {
    #[inline(always)]
    fn motion(&self, level: usize) -> [Lanes<S>; 2] {
        let motion = &self.structures[level].motion;
        [motion.displacement, motion.increment]
    }

    #[inline(always)]
    fn pounding(&self, level: usize) -> Lanes<S> {
        if IN_CONTACT {
            self.structures[level].contact.pounding()
        } else {
            self.zero
        }
    }

    #[inline(always)]
    fn respond(&mut self, level: usize, drift: Lanes<S>) -> Lanes<S> {
        let structure = &mut self.structures[level];
        let force = structure.constants.respond(&mut structure.motion, drift);
        if IN_CONTACT {
            structure.contact.at_node.restoring_force = force;
        }
        if level > 0 {
            self.drifts[level] = self.drifts[level].with(drift);
        }
        force
    }

    #[inline(always)]
    fn hold(&mut self, level: usize, acceleration: Lanes<S>, increment: Lanes<S>) {
        if IN_CONTACT {
            self.accelerations[level] = acceleration;
            self.structures[level].contact.is_near = false;
        }
        self.structures[level].motion.hold(increment);
    }

    #[inline(always)]
    fn held(&self, level: usize) -> Lanes<S> {
        self.structures[level].motion.held()
    }

    #[inline(always)]
    fn go_on(&mut self, level: usize, increment: Lanes<S>) {
        let structure = &mut self.structures[level];
        if IN_CONTACT {
            structure.contact.at_node.displacement = structure.motion.displacement;
        }
        structure.motion.go_on(increment);
    }
}

impl<S: Simd, Column: SideBySideColumn> Frame<S, Column> for Storeys<S> {
    #[inline(always)]
    fn of(simd: S, rows: Rows<'_, Column>, time_step: f64) -> Self {
        let buildings = rows.lane(0).buildings().clone();
        let of_lane = |lane| FloorCoefficients::of(rows.lane(lane), time_step);
        let lanes: [_; MOST_LANES] = std::array::from_fn(of_lane);
        let zero = Lanes::splat(simd, 0.0);
        let (mut coefficients, mut ground_damping) = (Vec::new(), Vec::new());
        let mut places = vec![0; buildings.all().len()];
        for (place, node) in buildings.all().iter().enumerate() {
            places[*node] = place;
            let gather = |number: fn(&FloorCoefficients) -> f64| Lanes::new(simd, &lanes.each_ref().map(|floors| number(&floors[place])));
            coefficients.push(FloorCoefficients::beside(gather, time_step));
            let damping = |lane: usize| rows.lane(lane).nodes()[*node].support.ground_damping();
            ground_damping.push(Lanes::new(simd, &std::array::from_fn(damping)));
        }
        Self {
            accelerations: vec![zero; coefficients.len()],
            drifts: vec![Extremes::none(simd); coefficients.len()],
            coefficients,
            ground_damping,
            buildings,
            places,
        }
    }

    #[inline(always)]
    fn place(&self, node: usize) -> usize {
        self.places[node]
    }

    #[inline(always)]
    fn node(&self, place: usize) -> usize {
        self.buildings.all()[place]
    }

    #[inline(always)]
    fn begin(&self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        for range in self.buildings.ranges() {
            let building = &mut structures[range.clone()];
            for level in 0..building.len() {
                let acceleration = self.acceleration::<Column>(building, range.start, level, ground);
                building[level].begin(acceleration);
            }
        }
    }

    #[inline(always)]
    fn step(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        self.go_on::<Column, false>(structures, ground);
    }

    #[inline(always)]
    fn step_in_contact(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>, jumps: bool) {
        self.go_on::<Column, true>(structures, ground);
        if jumps {
            for structure in structures {
                let velocity = structure.velocity_before();
                structure.contact.at_node.velocity = velocity;
                structure.contact.at_node.jumped = velocity;
            }
        }
    }

    /// Through dashpots, the acceleration of a floor jumps with the velocity of its neighbours in the building.
    #[inline(always)]
    fn restart(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        for range in self.buildings.ranges() {
            let building = &mut structures[range.clone()];
            for level in 0..building.len() {
                let (acceleration, jumps) = self.after_jump::<Column>(building, range.start, level, ground);
                building[level].restart(acceleration, jumps);
            }
        }
    }

    #[inline(always)]
    fn peak_drift(&self, structures: &[Structure<S, Column>], place: usize, lane: usize) -> Option<f64> {
        let motion = &structures[place].motion;
        let mut ranges = self.buildings.ranges();
        if ranges.any(|range| range.start == place) {
            return motion.peak(lane);
        }
        self.drifts[place].peak(motion.displacement, lane)
    }
}
