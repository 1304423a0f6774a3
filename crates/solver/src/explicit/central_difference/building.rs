//! The equations of the floors of a building, of one scene or of several side by side.
//!
//! The dashpots between floors join the next increments of a building: what the equation of a floor says of its increment
//! is found from the top floor down, the increments then from the ground up.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

use super::coefficients::Coefficients;
use crate::model::buildings::Buildings;
use crate::model::dashpots::{DampingRates, Eliminated};
use crate::{RestoringForce, Row};

/// Constants of the equation of a floor that is joined to the floors below and above.
pub(crate) struct FloorCoefficients<N = f64> {
    /// With c of all its dashpots; what it solves is less by what the elimination of the floors above took.
    pub(crate) own: Coefficients<N>,
    pub(crate) rates: DampingRates<N>,
    /// c/(2mΔt) of the dashpot to the floor below, m the mass of this floor.
    below: N,
    /// The same of that to the floor above.
    above: N,
    /// What of the next increment of the floor below is added to that of this one.
    share: N,
}

impl FloorCoefficients {
    /// Of all floors, building by building, for steps of this length \[s\].
    pub(crate) fn of<Column: RestoringForce>(
        row: &Row<Column>,
        buildings: &Buildings,
        dt: f64,
    ) -> Vec<Self> {
        let (inertia, weigh) = (1.0 / (dt * dt), |rate: f64| 0.5 * rate / dt);
        let mut all = Vec::with_capacity(row.nodes().len());
        for building in buildings.each() {
            let (first, mut above) = (all.len(), None);
            for index in building.iter().rev() {
                let rates = DampingRates::new(row, *index);
                let parts = (&rates, *index == building[0]);
                let equation = Eliminated::new(parts, above.as_ref(), inertia, weigh);
                let solve = 1.0 / equation.pivot;
                let half = weigh(rates.storey) + weigh(rates.ground) + weigh(rates.above);
                all.push(Self {
                    own: Coefficients {
                        solve,
                        carry: inertia - half,
                        ..Coefficients::new(&row.nodes()[*index], dt)
                    },
                    rates,
                    below: equation.below,
                    above: equation.above,
                    share: equation.below * solve,
                });
                above = Some(equation);
            }
            all[first..].reverse();
        }
        all
    }
}

impl<N: Number> FloorCoefficients<N> {
    /// Of the same floor of several scenes, from what gathers a number of each; `time_step` \[s\] is that of all.
    #[inline(always)]
    pub(crate) fn beside(
        gather: impl Fn(fn(&FloorCoefficients) -> f64) -> N,
        time_step: f64,
    ) -> Self {
        Self {
            own: Coefficients {
                time_step,
                inverse_mass: gather(|floor| floor.own.inverse_mass),
                damping: gather(|floor| floor.own.damping),
                solve: gather(|floor| floor.own.solve),
                carry: gather(|floor| floor.own.carry),
                mobile: gather(|floor| floor.own.mobile),
            },
            rates: DampingRates {
                storey: gather(|floor| floor.rates.storey),
                ground: gather(|floor| floor.rates.ground),
                above: gather(|floor| floor.rates.above),
            },
            below: gather(|floor| floor.below),
            above: gather(|floor| floor.above),
            share: gather(|floor| floor.share),
        }
    }
}

/// The floors of a building at a node, counted from the ground up: what their equations ask of them, and tell them.
pub(crate) trait Floors<N: Number> {
    /// Displacement of a floor \[m\], and by how much it is more than at the node before.
    fn motion(&self, level: usize) -> [N; 2];

    /// Net pounding force on a floor \[N\].
    fn pounding(&self, level: usize) -> N;

    /// Force of the storey below a floor at a drift \[m\], which its columns remember \[N\].
    fn respond(&mut self, level: usize, drift: N) -> N;

    /// Tells a floor its acceleration without damping \[m/s²\]; from the top down.
    fn accelerate(&mut self, level: usize, acceleration: N);

    /// Tells a floor its next increment \[m\]; from the ground up, after all accelerations.
    fn go_on(&mut self, level: usize, increment: N);
}

/// Solves the equations of a building at a node with this acceleration of the ground \[m/s²\]; there is room for its `increments`.
#[inline(always)]
pub(crate) fn solve<N: Number>(
    floors: &mut impl Floors<N>,
    coefficients: &[FloorCoefficients<N>],
    increments: &mut [N],
    ground: N,
) {
    let n = increments.len();
    // The lengths are told once, so that no floor has to be checked against them.
    let coefficients = &coefficients[..n];
    let zero = ground.like(0.0);
    // All of its floors are walls, or none.
    let ground = coefficients[0].own.mobile * ground;
    let (mut carried, mut above) = (zero, zero);
    for level in (0..n).rev() {
        let constants = &coefficients[level];
        let [displacement, increment] = floors.motion(level);
        let below = level.checked_sub(1);
        let below = below.map_or([zero; 2], |lower| floors.motion(lower));
        let force = floors.respond(level, displacement - below[0]);
        let own = &constants.own;
        let smooth = own.smooth((floors.pounding(level), force - carried), ground);
        let before = own.carry * increment + constants.below * below[1];
        // Without what the floor below adds to it.
        let next = own.solve * (smooth + (before + constants.above * above));
        floors.accelerate(level, smooth);
        increments[level] = next;
        carried = force;
        above = increment + next;
    }
    let mut below = zero;
    for level in 0..n {
        let increment = increments[level] + coefficients[level].share * below;
        floors.go_on(level, increment);
        below = increment;
    }
}
