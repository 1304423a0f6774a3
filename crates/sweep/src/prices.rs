//! What a whole sweep costs by a method, with what choosing and measuring it takes.

use pounding_scene::Method;

/// The longest time step that is tried \[s\], and how often it is halved.
pub(super) const LONGEST: f64 = 0.02;
pub(super) const HALVED: i32 = 7;

/// How often the longest step of each of them may be halved; nothing of one that is not worth it.
pub(super) type Halved = [Option<i32>; STEPPING.len()];

/// The methods that step, the cheaper ones first; they run side by side.
pub(super) const STEPPING: [fn(f64) -> Method; 1] = [central_difference];

fn central_difference(time_step_s: f64) -> Method {
    Method::central_difference(time_step_s, 1)
}

/// How many scenes by the exact method side by side cost as much as one alone (`cargo xtask bench --peers`).
pub(super) const ALONE: f64 = 13.0;
/// Part of the price of all runs by the exact method \[–\] that another method has to save: prices are no better known.
const SAVES: f64 = 0.1;

/// How many runs there are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Counts {
    /// Of the sweep.
    pub(super) all: f64,
    /// Those that choose a method.
    pub(super) choosing: f64,
    /// Those that measure it.
    pub(super) measuring: f64,
}

/// What a run costs, in force evaluations that take as long, as a mean of some.
#[derive(Debug, Clone, Copy)]
pub(super) struct Prices {
    pub(super) counts: Counts,
    /// By the exact method, alone.
    pub(super) exact: f64,
    /// By the exact method side by side; nothing where no scenes can.
    pub(super) flights: Option<f64>,
    /// By each method that steps, with steps of a second.
    pub(super) steps: [f64; STEPPING.len()],
}

impl Prices {
    /// Whether a sweep by a method of which a run costs this, and trying it this much a run, costs less than by the exact method.
    ///
    /// Runs that choose and measure are run by the exact method, too, which itself needs none of them.
    pub(super) fn is_worth(&self, run: f64, tried: f64) -> bool {
        let Counts {
            all,
            choosing,
            measuring,
        } = self.counts;
        let chosen = choosing * (self.exact + tried);
        let measured = measuring * (self.exact + run);
        chosen + measured + all * run <= (1.0 - SAVES) * all * self.exact
    }

    /// How often the longest step of each method may be halved so that this is worth it, and a run costs no more than otherwise;
    /// nothing where not even the longest is.
    pub(super) fn halved(&self, otherwise: f64) -> Halved {
        let tries = self.tries(|_, _| true);
        self.steps.map(|own| {
            let worth = |halved: &i32| {
                let run = price(own, *halved);
                // All cheaper ones are tried before, and the next finer one of the method confirms it.
                let cheaper = tries.iter().filter(|one| one.price <= 2.0 * run);
                let tried: f64 = cheaper.map(|one| one.price).sum();
                run <= otherwise && self.is_worth(run, tried)
            };
            (0..HALVED).rfind(worth)
        })
    }
}

/// A method with a step to try.
#[derive(Debug, Clone, Copy)]
pub(super) struct Try {
    /// Of the method among those that step.
    pub(super) place: usize,
    /// How often the longest step is halved.
    pub(super) halved: i32,
    /// What a run costs.
    price: f64,
}

/// What a run costs with the longest step halved so often, of a method that costs this with steps of a second.
fn price(with_seconds: f64, halved: i32) -> f64 {
    with_seconds * f64::from(1 << halved) / LONGEST
}

impl Prices {
    /// Methods and steps that may be tried, the cheapest first.
    pub(super) fn tries(&self, may: impl Fn(usize, i32) -> bool) -> Vec<Try> {
        let mut tries = Vec::new();
        for (place, step) in self.steps.into_iter().enumerate() {
            let tried = (0..=HALVED).filter(|halved| may(place, *halved));
            tries.extend(tried.map(|halved| Try {
                place,
                halved,
                price: price(step, halved),
            }));
        }
        tries.sort_by(|one, other| one.price.total_cmp(&other.price));
        tries
    }
}

/// The mean of some numbers; 0 of none.
pub(super) fn mean(numbers: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = numbers.fold((0.0, 0.0), |(sum, count), one| (sum + one, count + 1.0));
    if count > 0.0 { sum / count } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn prices(all: f64, exact: f64, step: f64) -> Prices {
        Prices {
            counts: Counts {
                all,
                choosing: 64.0,
                measuring: 128.0,
            },
            exact,
            flights: None,
            steps: [step, 1.2 * step],
        }
    }

    /// Two towers of seven and six storeys took twenty times as long with the longer steps of a method that does not go side by side.
    #[test]
    fn issue_fine_steps_that_cost_less_are_tried_before_coarse_ones() {
        let prices = Prices {
            steps: [1.0, 20.0],
            ..prices(3200.0, 1e6, 1.0)
        };
        let tries = prices.tries(|_, halved| halved < 6);
        let order: Vec<_> = tries.iter().map(|one| (one.place, one.halved)).collect();
        let first = [
            (0, 0),
            (0, 1),
            (0, 2),
            (0, 3),
            (0, 4),
            (1, 0),
            (0, 5),
            (1, 1),
        ];
        assert_eq!(order[..8], first, "the cheapest first");
        assert_eq!(order.len(), 12, "each once");
    }

    /// Two towers of three storeys, 20 s: 500 runs took four times as long with the steps that were chosen as by the exact method.
    #[test]
    fn issue_steps_that_cost_more_than_exact_runs_are_not_tried() {
        let towers = 6.0 * 20.0;
        let exact = 16.0 * 11_145.0;
        let halved = |all: f64| prices(all, exact, towers).halved(f64::INFINITY)[0];
        assert_eq!(halved(192.0), None, "measuring alone costs as much");
        assert_eq!(halved(500.0), Some(2), "5 ms");
        assert_eq!(halved(1e5), Some(4), "1.25 ms");
        // Elastic structures with impacts: a run costs as much as one with steps of 2 ms.
        let alone = prices(1e4, 9.0 * 2167.0, 2.0 * 20.0);
        assert_eq!(
            alone.halved(f64::INFINITY),
            [Some(3), Some(2)],
            "2.5 and 5 ms"
        );
    }

    #[test]
    fn reference_side_by_side_no_steps_are_finer_than_flights_cost() {
        // Two elastic structures: flights cost as much as steps of about a millisecond.
        let one = prices(1e4, 9.0 * 2167.0, 2.0 * 20.0 / 40.0);
        assert_eq!(one.halved(9.0 * 2167.0 / ALONE)[0], Some(4));
        assert_eq!(one.halved(f64::INFINITY)[0], Some(6));
    }
}
