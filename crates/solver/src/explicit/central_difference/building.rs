//! The equations of the floors of a building, of one scene or of several side by side.
//!
//! The dashpots between floors join the next increments of a building: what the equation of a floor says of its increment
//! is found from the top floor down, and held; the increments then follow from the ground up.

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
    /// With c of all its dashpots; what it solves is less by what the elimination of the floors above took.
    pub own: Coefficients<N>,
    /// Its dashpots.
    pub rates: DampingRates<N>,
    /// c/(2mΔt) of the dashpot to the floor below, m the mass of this floor.
    below: N,
    /// What of the last and the next increment of the floor above is added to the next one of this floor.
    from_above: N,
    /// What of the next increment of the floor below is added to it.
    from_below: N,
}

impl FloorCoefficients {
    /// Of all floors, building by building, for steps of this length \[s\].
    pub fn of<Column: RestoringForce>(row: &Row<Column>, dt: f64) -> Vec<Self> {
        let (inertia, weigh) = (1.0 / (dt * dt), |rate: f64| 0.5 * rate / dt);
        let mut all = Vec::with_capacity(row.nodes().len());
        for building in row.buildings().each() {
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
    /// Of the same floor of several scenes, from what gathers a number of each; `time_step` \[s\] is that of all.
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

/// The floors of a building at a node, counted from the ground up: what their equations ask of them, and tell them.
pub trait Floors<N: Number> {
    /// Displacement of a floor \[m\], and by how much it is more than at the node before.
    fn motion(&self, level: usize) -> [N; 2];

    /// Net pounding force on a floor \[N\].
    fn pounding(&self, level: usize) -> N;

    /// Force of the storey below a floor at a drift \[m\], which its columns remember \[N\].
    fn respond(&mut self, level: usize, drift: N) -> N;

    /// Tells a floor its acceleration without damping \[m/s²\], and its next increment but for what the floor below adds to it \[m\];
    /// from the top down.
    fn hold(&mut self, level: usize, acceleration: N, increment: N);

    /// The increment that a floor holds \[m\].
    fn held(&self, level: usize) -> N;

    /// Tells a floor its next increment \[m\]; from the ground up, after all hold theirs.
    fn go_on(&mut self, level: usize, increment: N);
}

/// Solves the equations of a building at a node with this acceleration of the ground \[m/s²\].
#[inline(always)]
pub fn solve<N: Number>(floors: &mut impl Floors<N>, coefficients: &[FloorCoefficients<N>], ground: N) {
    let n = coefficients.len();
    let zero = ground.like(0.0);
    // All of its floors are walls, or none.
    let ground = coefficients[0].own.mobile * ground;
    let mut above = Above {
        force: zero,
        increments: zero,
    };
    for level in (1..n).rev() {
        let below = floors.motion(level - 1);
        above = hold(floors, coefficients, (level, below), above, ground);
    }
    hold(floors, coefficients, (0, [zero; 2]), above, ground);
    let mut below = zero;
    for (level, constants) in coefficients.iter().enumerate() {
        let increment = floors.held(level) + constants.from_below * below;
        floors.go_on(level, increment);
        below = increment;
    }
}

/// What a floor passes on to the one below it.
#[derive(Clone, Copy)]
struct Above<N> {
    /// Force of its storey \[N\].
    force: N,
    /// Sum of its last and its next increment, but for what the floors below it add to them \[m\].
    increments: N,
}

/// Lets a floor hold what its equation says, above a floor that has moved so.
#[inline(always)]
fn hold<N: Number>(
    floors: &mut impl Floors<N>,
    coefficients: &[FloorCoefficients<N>],
    (level, below): (usize, [N; 2]),
    above: Above<N>,
    ground: N,
) -> Above<N> {
    let constants = &coefficients[level];
    let [displacement, increment] = floors.motion(level);
    let force = floors.respond(level, displacement - below[0]);
    let own = &constants.own;
    let smooth = own.smooth((floors.pounding(level), force - above.force), ground);
    let before = own.carry * increment + constants.below * below[1];
    // No more than a product and a sum wait for the floor above.
    let alone = own.solve * (smooth + before);
    let added = constants.from_above * above.increments;
    floors.hold(level, smooth, alone + added);
    Above {
        force,
        increments: (increment + alone) + added,
    }
}
