//! What a whole sweep costs by a method, with what choosing and measuring it takes.

/// The longest time step that is tried \[s\], and how often it is halved at most.
pub(super) const LONGEST: f64 = 0.02;
pub(super) const HALVED: i32 = 7;

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
    /// By the exact method with the tolerance of the scene.
    pub(super) exact: f64,
    /// By central differences with steps of a second.
    pub(super) steps: f64,
}

/// The time step \[s\] that is the longest one, halved so often.
pub(super) fn step(halved: i32) -> f64 {
    LONGEST / f64::from(1 << halved)
}

impl Prices {
    /// Whether a sweep by a method of which a run costs this, and trying it this much a run, costs less than by the exact method.
    ///
    /// Runs that choose and measure are run by the exact method, too, which itself needs none of them.
    pub(super) fn is_worth(&self, run: f64, tried: f64) -> bool {
        let Counts { all, choosing, measuring } = self.counts;
        let chosen = choosing * (self.exact + tried);
        let measured = measuring * (self.exact + run);
        chosen + measured + all * run <= (1.0 - SAVES) * all * self.exact
    }

    /// How often the longest step may be halved so that it is worth it, and a run costs no more than `otherwise`; `None` if not even
    /// the longest is.
    pub(super) fn halved(&self, otherwise: f64) -> Option<i32> {
        let price = |halved: i32| self.steps / step(halved);
        let worth = |halved: &i32| {
            // All longer ones are tried before, and the next finer one confirms it.
            let tried: f64 = (0..=halved + 1).map(price).sum();
            price(*halved) <= otherwise && self.is_worth(price(*halved), tried)
        };
        (0..HALVED).rfind(worth)
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

    fn prices(all: f64, exact: f64, steps: f64) -> Prices {
        Prices {
            counts: Counts {
                all,
                choosing: 64.0,
                measuring: 128.0,
            },
            exact,
            steps,
        }
    }

    /// Two towers of three storeys, 20 s: 500 runs took four times as long with the steps that were chosen as by the exact method.
    #[test]
    fn issue_steps_that_cost_more_than_exact_runs_are_not_tried() {
        let towers = 6.0 * 20.0;
        let exact = 16.0 * 11_145.0;
        let halved = |all: f64| prices(all, exact, towers).halved(f64::INFINITY);
        assert_eq!(halved(192.0), None, "measuring alone costs as much");
        assert_eq!(halved(500.0), Some(3), "2.5 ms");
        assert_eq!(halved(1e5), Some(4), "1.25 ms");
    }

    #[test]
    fn reference_side_by_side_no_steps_are_finer_than_flights_cost() {
        // Two elastic structures: flights cost as much as steps of about a millisecond.
        let one = prices(1e4, 9.0 * 2167.0, 2.0 * 20.0 / 40.0);
        assert_eq!(one.halved(9.0 * 2167.0 / ALONE), Some(4));
        assert_eq!(one.halved(f64::INFINITY), Some(6));
    }
}
