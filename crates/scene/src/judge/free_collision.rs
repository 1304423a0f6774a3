//! A free collision of two masses, run with any method.

use pounding_contact::{ContactLaw, FreePair, reduced_mass};
use pounding_solver::{AnyRow, Budget, Clock, Elastic, Excitation, Integrator, LastStates, Node, Pair, Recorders, Row, RunError};

use crate::{Error, Method};
use pounding_text::{Refused, plain, short};

/// Two masses that collide without any other force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FreeCollision {
    /// Masses of the neighbours \[kg\], > 0; one may be infinite, a wall.
    pub masses: [f64; 2],
    /// Approach speed at the first touch \[m/s\], > 0.
    pub speed: f64,
}

/// Restitution that a stepping method delivers at a time step, for different instants of the touch within a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DeliveredRestitution {
    /// Least and largest e delivered \[–\].
    pub range: [f64; 2],
    /// Largest distance from the e of the law \[–\], absolute.
    pub error: f64,
    /// Number of time steps from touch to parting; `None` for an impulsive law.
    pub steps_per_contact: Option<f64>,
}

/// Number of instants within a step at which the gap closes.
const N_PHASES: u32 = 16;
/// Number of steps before the touch.
const BEFORE: u32 = 3;

impl FreeCollision {
    /// Returns what a method delivers with a law, compared with the right e.
    ///
    /// # Errors
    /// [`Refused`] with the reason if the run fails.
    pub(crate) fn delivered(
        &self,
        law: ContactLaw,
        method: &Method,
        right: f64,
        duration: Option<f64>,
    ) -> Result<DeliveredRestitution, Refused> {
        let contact = duration.unwrap_or(0.0);
        let step = method.time_step().unwrap_or(duration.unwrap_or(1.0));
        let mut range = [f64::INFINITY, f64::NEG_INFINITY];
        for phase in 0..N_PHASES {
            let part = (f64::from(phase) + 0.5) / f64::from(N_PHASES);
            let run = self.run(law, &method.integrator(), step, part, contact)?;
            let found = run.restitution(self.speed);
            range = [range[0].min(found), range[1].max(found)];
        }
        let off = |found: f64| (found - right).abs();
        Ok(DeliveredRestitution {
            range,
            error: off(range[0]).max(off(range[1])),
            steps_per_contact: duration.map(|duration| duration / step),
        })
    }

    /// Refuses a time step \[s\] of a collision.
    pub fn no_step(found: f64) -> Refused {
        Refused::at("time step")
            .found(format!("{} s", plain(found)))
            .allowed("a finite number > 0 and at most 1e6 steps in the collision")
            .help("take longer steps")
    }

    /// Converts the collision to a free pair.
    pub fn free_pair(&self) -> FreePair {
        FreePair {
            reduced_mass: reduced_mass(1.0 / self.masses[0], 1.0 / self.masses[1]),
            approach_speed: self.speed,
        }
    }

    /// Row of the masses at a gap \[m\], moving towards each other.
    ///
    /// # Errors
    /// Refuses a number that the solver refuses.
    pub fn row(&self, law: ContactLaw, gap: f64) -> Result<AnyRow, Refused> {
        let inverse = self.masses.map(|mass| 1.0 / mass);
        // Velocities about the common centre, so that neither is lost in the rounding of the other.
        let node = |inverse_mass: f64, sign: f64| Node {
            initial_velocity: sign * self.speed * inverse_mass / (inverse[0] + inverse[1]),
            inverse_mass,
            ..Node::structure(1.0, 0.0, Elastic { stiffness: 0.0 })
        };
        let nodes = vec![node(inverse[0], 1.0), node(inverse[1], -1.0)];
        let pair = Pair::of_floors(0, 1, gap, law);
        let row = Row::new(nodes, vec![pair]).map_err(|_| Refused::that("masses and speed: allowed are finite numbers > 0"))?;
        Ok(AnyRow::Elastic(row))
    }

    /// Runs the collision and some time after it. The gap closes `BEFORE` steps plus `part` of a step after the start.
    pub(crate) fn run(&self, law: ContactLaw, integrator: &Integrator, step: f64, part: f64, contact: f64) -> Result<Seen, Refused> {
        let until = (f64::from(BEFORE) + part) * step;
        let row = self.row(law, self.speed * until)?;
        let n_steps = ((until + 2.0 * contact) / step).ceil() + f64::from(BEFORE);
        if !(step.is_finite() && step > 0.0 && n_steps <= MOST_STEPS) {
            return Err(Self::no_step(step));
        }
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "checked: a positive number that is not large"
        )]
        let n_steps = n_steps as usize;
        let clock = Clock { time_step: step, n_steps };
        let rest = Excitation::new(step, &[0.0]).map_err(|_| Self::no_step(step))?;
        let budget = Budget {
            pieces: MOST_PIECES,
            ..Budget::default()
        };
        let mut recorders = Recorders {
            last: Some(LastStates::new(2)),
            ..Recorders::usual(2, row.pairs())
        };
        match row.run(integrator, rest, clock.within(budget), &mut recorders) {
            Ok(_) => Ok(Seen::of(&recorders)),
            Err(RunError::TooManyPieces { .. }) => {
                let duration = short(contact);
                let found =
                    format!("a collision that lasts {duration} s and takes more than 1e5 pieces of the exact method, all that it may");
                let found = Refused::at("stiffness, masses and speed").found(found);
                Err(found.help("take a stiffness nearer to that of buildings"))
            }
            Err(error) => Err(Error::ended(&error)),
        }
    }
}

/// Largest number of steps of a run: some tenths of a second. Each method makes `N_PHASES` runs.
const MOST_STEPS: f64 = 1e6;
/// Largest number of pieces of the exact method: a tenth of a second. Collisions of buildings take less than 3000.
const MOST_PIECES: f64 = 1e5;

/// Velocities at the end \[m/s\], and the impulse \[N·s\].
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Seen {
    velocities: [f64; 2],
    pub(crate) impulse: f64,
}

impl Seen {
    fn of(recorders: &Recorders<'_, '_>) -> Self {
        let velocity = |node: usize| recorders.last.as_ref().map(|last| last.of(node).velocity);
        let impulses = recorders.collisions.all().iter().map(|met| met.impulse);
        Self {
            velocities: [0, 1].map(|node| velocity(node).unwrap_or_default()),
            impulse: impulses.sum(),
        }
    }

    pub(crate) fn restitution(&self, speed: f64) -> f64 {
        (self.velocities[1] - self.velocities[0]) / speed
    }
}
