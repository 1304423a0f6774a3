//! The equations of the floors of a building, for a single scene or for several scenes in lanes.
//!
//! The dashpots between floors couple the next increments of a building. The equation of each floor is solved for its increment from the
//! top floor down and stored. The increments then follow from the ground up.

#![expect(
    clippy::inline_always,
    reason = "instructions on lanes exist only inside the function that found the machine to have them"
)]

use pounding_contact::Number;

use super::coefficients::Coefficients;
use crate::model::dashpots::{DampingRates, Eliminated};
use crate::{RestoringForce, Row};

/// Constants of the equation of a floor that is joined to the floors below and above.
#[derive(Debug)]
pub struct FloorCoefficients<N = f64> {
    /// Coefficients with c of all dashpots of the floor. The elimination of the floors above reduces `solve`.
    pub own: Coefficients<N>,
    /// Damping rates of the floor.
    pub rates: DampingRates<N>,
    /// c/(2mΔt) of the dashpot to the floor below, m the mass of this floor.
    below: N,
    /// Factor with which the last and the next increment of the floor above enter the next increment of this floor.
    from_above: N,
    /// Factor with which the next increment of the floor below enters.
    from_below: N,
}

impl FloorCoefficients {
    /// Constants of all floors, building by building, for steps of this length \[s\].
    pub fn of<Column: RestoringForce>(row: &Row<Column>, dt: f64) -> Vec<Self> {
        let (inertia, weigh) = (1.0 / (dt * dt), |rate: f64| 0.5 * rate / dt);
        let mut all = Vec::with_capacity(row.nodes().len());
        for building in row.buildings().each() {
            let (first, mut above) = (all.len(), None);
            for index in building.iter().rev() {
                let rates = DampingRates::new(row, *index);
                let on_ground = *index == building[0];
                let equation = Eliminated::new(&rates, on_ground, above.as_ref(), inertia, weigh);
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
                    from_above: equation.above * solve,
                    from_below: equation.below * solve,
                });
                above = Some(equation);
            }
            all[first..].reverse();
        }
        all
    }
}

impl<N: Number> FloorCoefficients<N> {
    /// Constants of this floor in several scenes; `gather` collects a number from each scene. All scenes share `time_step` \[s\].
    #[inline(always)]
    pub fn beside(gather: impl Fn(fn(&FloorCoefficients) -> f64) -> N, time_step: f64) -> Self {
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
            from_above: gather(|floor| floor.from_above),
            from_below: gather(|floor| floor.from_below),
        }
    }
}

/// The floors of a building at a node, counted from the ground up: inputs and results of their equations.
pub trait Floors<N: Number> {
    /// Displacement of a floor \[m\], and its increment since the node before.
    fn motion(&self, level: usize) -> [N; 2];

    /// Net pounding force on a floor \[N\].
    fn pounding(&self, level: usize) -> N;

    /// Force of the storey below a floor at a drift \[N\]. The columns remember it.
    fn respond(&mut self, level: usize, drift: N) -> N;

    /// Stores the acceleration without damping of a floor \[m/s²\] and its next increment without the share of the floor below \[m\].
    /// Called from the top down.
    fn hold(&mut self, level: usize, acceleration: N, increment: N);

    /// The stored increment of a floor \[m\].
    fn held(&self, level: usize) -> N;

    /// Sets the next increment of a floor \[m\]. Called from the ground up, once all increments are stored.
    fn go_on(&mut self, level: usize, increment: N);
}

/// Solves the equations of a building at a node with this acceleration of the ground \[m/s²\].
#[inline(always)]
pub fn solve<N: Number>(floors: &mut impl Floors<N>, coefficients: &[FloorCoefficients<N>], ground: N) {
    let n = coefficients.len();
    let zero = ground.like(0.0);
    // Either all floors of a building are walls, or none.
    let ground = coefficients[0].own.mobile * ground;
    let mut above = Above {
        force: zero,
        increments: zero,
    };
    for level in (1..n).rev() {
        let below = floors.motion(level - 1);
        above = hold(floors, coefficients, level, below, above, ground);
    }
    hold(floors, coefficients, 0, [zero; 2], above, ground);
    let mut below = zero;
    for (level, constants) in coefficients.iter().enumerate() {
        let increment = floors.held(level) + constants.from_below * below;
        floors.go_on(level, increment);
        below = increment;
    }
}

/// Values that a floor passes to the floor below it.
#[derive(Clone, Copy)]
struct Above<N> {
    /// Force of its storey \[N\].
    force: N,
    /// Sum of its last and its next increment, without the shares of the floors below it \[m\].
    increments: N,
}

/// Stores the result of the equation of a floor, below a floor that has moved.
#[inline(always)]
fn hold<N: Number>(
    floors: &mut impl Floors<N>,
    coefficients: &[FloorCoefficients<N>],
    level: usize,
    below: [N; 2],
    above: Above<N>,
    ground: N,
) -> Above<N> {
    let constants = &coefficients[level];
    let [displacement, increment] = floors.motion(level);
    let force = floors.respond(level, displacement - below[0]);
    let own = &constants.own;
    let smooth = own.smooth(floors.pounding(level), force - above.force, ground);
    let before = own.carry * increment + constants.below * below[1];
    // Only a product and a sum wait for the floor above.
    let alone = own.solve * (smooth + before);
    let added = constants.from_above * above.increments;
    floors.hold(level, smooth, alone + added);
    Above {
        force,
        increments: (increment + alone) + added,
    }
}
