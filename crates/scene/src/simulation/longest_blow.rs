//! How long a blow of two structures lasts at most: a longer touch is a push.

use pounding_contact::{FreeImpact, FreePair, reduced_mass};
use pounding_solver::Collision;

use super::{PairOutcome, RunResult, Simulation};

impl Simulation {
    /// Speed at which buildings commonly meet \[m/s\].
    pub(crate) const USUAL_APPROACH: f64 = 0.3;

    /// Duration beyond which a touch of a pair is a push instead of a blow \[s\]: [`PairOutcome::LEANS`], or 1.5 times a free collision if that
    /// is more. The contact is `stiffness` times as stiff as in the scene.
    ///
    /// 1.5 half-periods is the time in a linear contact that a constant push alone would deform as far as the blow alone. Floors that storeys tie
    /// at least as stiffly as the contact move with the floor that is hit.
    pub fn longest_blow(&self, pair: usize, stiffness: f64) -> f64 {
        let facing = &self.floors.facing()[pair];
        let law = self.pairs()[pair].law.stiffened(stiffness);
        let free = |masses: [f64; 2]| {
            let pair = FreePair {
                reduced_mass: reduced_mass(1.0 / masses[0], 1.0 / masses[1]),
                approach_speed: Self::USUAL_APPROACH,
            };
            FreeImpact::of(&law, &pair)
        };
        let floors = [facing.left, facing.right];
        let own = floors.map(|floor| self.moves_with(floor, f64::INFINITY));
        let Some(alone) = free(own) else {
            return PairOutcome::LEANS;
        };
        let secant = alone.peak_force / alone.max_deformation;
        let together = free(floors.map(|floor| self.moves_with(floor, secant)));
        let lasts = together.unwrap_or(alone).force_duration;
        PairOutcome::LEANS.max(1.5 * lasts)
    }

    /// Mass of a floor and of the floors that storeys of at least this stiffness \[N/m\] tie to it \[kg\]; infinite for a wall.
    fn moves_with(&self, floor: usize, stiffness: f64) -> f64 {
        let all = self.floors.all();
        let made = |floor: usize| all[floor].made_of;
        let Some(own) = made(floor) else {
            return f64::INFINITY;
        };
        let is_tied = |floor: &usize| made(*floor).is_some_and(|made| made.columns.stiffness_n_per_m >= stiffness);
        let of_structure = self.floors.of_structure(all[floor].structure);
        let at = of_structure.iter().position(|one| *one == floor).unwrap_or(0);
        // The storey below a floor ties it to the next lower one.
        let above = of_structure[at + 1..].iter().take_while(|one| is_tied(one));
        let below = of_structure[..=at].windows(2).rev().take_while(|two| is_tied(&two[1]));
        let others = above.copied().chain(below.map(|two| two[0]));
        own.mass_kg + others.filter_map(made).map(|made| made.mass_kg).sum::<f64>()
    }
}

impl RunResult {
    /// Longest touch of a pair, if it is a push instead of a blow. The ground, or a residual drift, may press a building against its neighbour;
    /// the impulse is then large without a hard hit.
    pub fn leaning(&self, simulation: &Simulation, pair: usize) -> Option<Collision> {
        let longest = self.of_pair(pair).longest;
        longest.filter(|longest| simulation.is_push(longest, 1.0))
    }
}

impl Simulation {
    /// Whether a touch lasts [longer than a blow](Self::longest_blow).
    pub fn is_push(&self, touch: &Collision, stiffness: f64) -> bool {
        let lasts = touch.end - touch.start;
        // The bound of a pair takes two free collisions.
        lasts > PairOutcome::LEANS && lasts > self.longest_blow(touch.pair, stiffness)
    }
}
