//! Buildings of several storeys side by side.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::body::peak;
use super::column::SideBySideColumn;
use super::frame::Frame;
use super::number::{Lanes, MOST_LANES, Mask};
use super::rows::Rows;
use super::scenes::Structure;
use crate::explicit::central_difference::building::{FloorCoefficients, Floors, solve};
use crate::impact::chain::Link;
use crate::model::balance::{Below, damping_force};
use crate::model::buildings::Buildings;

/// The floors of some rows of one shape, building by building.
pub(super) struct Storeys<S: Simd> {
    buildings: Buildings,
    coefficients: Vec<FloorCoefficients<Lanes<S>>>,
    /// Damping coefficient of every floor against the ground, besides that of its storey \[N·s/m\].
    ground_damping: Vec<Lanes<S>>,
    /// Acceleration of every floor without damping, at nodes at which some lane touches \[m/s²\].
    accelerations: Vec<Lanes<S>>,
    /// Least and largest drift of every storey on another floor \[m\].
    drifts: Vec<[Lanes<S>; 2]>,
    /// Room for the increments of the tallest building.
    increments: Vec<Lanes<S>>,
}

/// One building at a node; `IN_CONTACT` where some lane of the row touches.
struct Building<'a, S: Simd, Column: SideBySideColumn, const IN_CONTACT: bool> {
    zero: Lanes<S>,
    /// Nodes of its floors from the ground up.
    floors: &'a [usize],
    /// Of the whole row.
    structures: &'a mut [Structure<S, Column>],
    accelerations: &'a mut [Lanes<S>],
    drifts: &'a mut [[Lanes<S>; 2]],
}

impl<S: Simd> Storeys<S> {
    /// Of rows in which some floor stands on another one; nothing for others.
    #[inline(always)]
    pub(super) fn of<Column: SideBySideColumn>(
        simd: S,
        rows: Rows<'_, Column>,
        time_step: f64,
    ) -> Option<Self> {
        let buildings = Buildings::of(rows.lane(0))?;
        let of_lane = |lane| FloorCoefficients::of(rows.lane(lane), &buildings, time_step);
        let lanes: [_; MOST_LANES] = std::array::from_fn(of_lane);
        let zero = Lanes::splat(simd, 0.0);
        let (mut coefficients, mut ground_damping) = (Vec::new(), Vec::new());
        for (place, node) in buildings.floors().iter().enumerate() {
            let gather = |number: fn(&FloorCoefficients) -> f64| {
                Lanes::new(simd, &lanes.each_ref().map(|floors| number(&floors[place])))
            };
            coefficients.push(FloorCoefficients::beside(gather, time_step));
            let damping = |lane: usize| rows.lane(lane).nodes()[*node].support.ground_damping();
            ground_damping.push(Lanes::new(simd, &std::array::from_fn(damping)));
        }
        Some(Self {
            accelerations: vec![zero; coefficients.len()],
            drifts: vec![
                [f64::INFINITY, f64::NEG_INFINITY].map(|drift| zero.like(drift));
                coefficients.len()
            ],
            increments: vec![zero; buildings.tallest()],
            coefficients,
            ground_damping,
            buildings,
        })
    }

    /// Lets all floors go on from a node.
    #[inline(always)]
    fn go_on<Column: SideBySideColumn, const IN_CONTACT: bool>(
        &mut self,
        structures: &mut [Structure<S, Column>],
        ground: Lanes<S>,
    ) {
        for range in self.buildings.ranges() {
            let floors = &self.buildings.floors()[range.clone()];
            let mut building = Building::<S, Column, IN_CONTACT> {
                zero: ground.like(0.0),
                floors,
                structures,
                accelerations: &mut self.accelerations[range.clone()],
                drifts: &mut self.drifts[range.clone()],
            };
            let increments = &mut self.increments[..floors.len()];
            let coefficients = &self.coefficients[range.clone()];
            solve(&mut building, coefficients, increments, ground);
        }
    }

    /// Acceleration of a floor after the velocity jumps at a node \[m/s²\], and where that or its velocity has jumped.
    #[inline(always)]
    fn after_jump<Column: SideBySideColumn>(
        &self,
        structures: &[Structure<S, Column>],
        (floors, level): (&[usize], usize),
        place: usize,
        ground: Lanes<S>,
    ) -> (Lanes<S>, Mask<S>) {
        let floor = &structures[floors[level]];
        let below = level.checked_sub(1).map(|lower| &structures[floors[lower]]);
        let above = floors.get(level + 1).map(|upper| &structures[*upper]);
        let constants = &self.coefficients[place];
        let zero = ground.like(0.0);
        let (mut around, mut feels) = ([zero; 2], floor.contact.jumps());
        for (velocity, neighbour) in around.iter_mut().zip([below, above]) {
            if let Some(neighbour) = neighbour {
                *velocity = neighbour.contact.velocity;
                feels = feels | neighbour.contact.jumps();
            }
        }
        let velocities = [around[0], floor.contact.velocity, around[1]];
        let before = self.accelerations[place] - constants.rates.deceleration(velocities);
        let below = below.map(|below| Below {
            ground_damping: self.ground_damping[place],
            velocity: below.contact.jumped,
        });
        let damping = damping_force(
            floor.dashpot(),
            below,
            above.map(Structure::<S, Column>::dashpot),
        );
        let mut restoring = floor.contact.restoring_force;
        if let Some(above) = above {
            restoring = restoring - above.contact.restoring_force;
        }
        let pounding = floor.contact.pounding() - damping;
        let felt = constants.own.mobile * ground;
        let after = constants.own.smooth((pounding, restoring), felt);
        let after = Number::select(feels, after, before);
        (
            after,
            floor.contact.jumps() | (after - before).abs().exceeds(zero),
        )
    }
}

impl<S: Simd, Column: SideBySideColumn, const IN_CONTACT: bool> Floors<Lanes<S>>
    for Building<'_, S, Column, IN_CONTACT>
{
    #[inline(always)]
    fn motion(&self, level: usize) -> [Lanes<S>; 2] {
        let motion = &self.structures[self.floors[level]].motion;
        [motion.displacement, motion.increment]
    }

    #[inline(always)]
    fn pounding(&self, level: usize) -> Lanes<S> {
        if IN_CONTACT {
            self.structures[self.floors[level]].contact.pounding()
        } else {
            self.zero
        }
    }

    #[inline(always)]
    fn respond(&mut self, level: usize, drift: Lanes<S>) -> Lanes<S> {
        let structure = &mut self.structures[self.floors[level]];
        let force = structure.constants.respond(&mut structure.motion, drift);
        if IN_CONTACT {
            structure.contact.restoring_force = force;
        }
        if level > 0 {
            let [least, largest] = self.drifts[level];
            self.drifts[level] = [least.min(drift), largest.max(drift)];
        }
        force
    }

    #[inline(always)]
    fn accelerate(&mut self, level: usize, acceleration: Lanes<S>) {
        if IN_CONTACT {
            self.accelerations[level] = acceleration;
        }
    }

    #[inline(always)]
    fn go_on(&mut self, level: usize, increment: Lanes<S>) {
        let structure = &mut self.structures[self.floors[level]];
        if IN_CONTACT {
            structure.contact.displacement = structure.motion.displacement;
        }
        structure.motion.go_on(increment);
    }
}

impl<S: Simd, Column: SideBySideColumn> Frame<S, Column> for Storeys<S> {
    const STANDS_ALONE: bool = false;

    #[inline(always)]
    fn step(&mut self, structures: &mut [Structure<S, Column>], ground: Lanes<S>) {
        self.go_on::<Column, false>(structures, ground);
    }

    #[inline(always)]
    fn step_in_contact(
        &mut self,
        structures: &mut [Structure<S, Column>],
        ground: Lanes<S>,
        jumps: bool,
    ) {
        self.go_on::<Column, true>(structures, ground);
        if jumps {
            for structure in structures {
                let velocity = structure.velocity_before();
                structure.contact.velocity = velocity;
                structure.contact.jumped = velocity;
            }
        }
    }

    /// Dashpots let the acceleration of a floor jump with the velocity of its neighbours in the building.
    #[inline(always)]
    fn restart(&mut self, structures: &mut [Structure<S, Column>], _: &[Link], ground: Lanes<S>) {
        for range in self.buildings.ranges() {
            let floors = &self.buildings.floors()[range.clone()];
            for (level, node) in floors.iter().enumerate() {
                let place = range.start + level;
                let (acceleration, jumps) =
                    self.after_jump::<Column>(structures, (floors, level), place, ground);
                structures[*node].restart_from(acceleration, jumps);
            }
        }
    }

    #[inline(always)]
    fn peak_drift(
        &self,
        structures: &[Structure<S, Column>],
        node: usize,
        lane: usize,
    ) -> Option<f64> {
        let motion = &structures[node].motion;
        let place = self.buildings.place(node)?;
        if self
            .buildings
            .ranges()
            .iter()
            .any(|range| range.start == place)
        {
            return motion.peak(lane);
        }
        peak(self.drifts[place], motion.displacement, lane)
    }
}
