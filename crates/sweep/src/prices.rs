//! Cost of a whole sweep by a method, including choice and measurement.

/// The longest time step that is tried \[s\], and the most halvings.
pub(super) const LONGEST: f64 = 0.02;
pub(super) const HALVED: i32 = 7;

/// Number of scenes by the exact method in lanes that cost as much as a scene alone (`cargo xtask bench --peers`).
pub(super) const ALONE: f64 = 13.0;
/// Least saving by another method, as a part of the price of all runs by the exact method \[–\]: prices are not known better.
const SAVES: f64 = 0.1;

/// Numbers of runs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Counts {
    /// Runs of the sweep.
    pub(super) all: f64,
    /// Runs that choose a method.
    pub(super) choosing: f64,
    /// Runs that measure it.
    pub(super) measuring: f64,
}

/// Mean cost of a run, in force evaluations of equal duration.
#[derive(Debug, Clone, Copy)]
pub(super) struct Prices {
    pub(super) counts: Counts,
    /// By the exact method with the tolerance of the scene.
    pub(super) exact: f64,
    /// By central differences with steps of a second.
    pub(super) steps: f64,
}

/// The longest time step after this many halvings \[s\].
pub(super) fn step(halved: i32) -> f64 {
    LONGEST / f64::from(1 << halved)
}

impl Prices {
    /// Whether a sweep by a method with this cost per run, and this cost of trials per run, costs less than by the exact method.
    ///
    /// Choosing and measuring runs also run by the exact method, which itself needs neither.
    pub(super) fn is_worth(&self, run: f64, tried: f64) -> bool {
        let Counts { all, choosing, measuring } = self.counts;
        let chosen = choosing * (self.exact + tried);
        let measured = measuring * (self.exact + run);
        chosen + measured + all * run <= (1.0 - SAVES) * all * self.exact
    }

    /// Number of halvings of the longest step that are still worth it, with a cost per run of at most `otherwise`; `None` if not even the
    /// longest step is.
    pub(super) fn halved(&self, otherwise: f64) -> Option<i32> {
        let price = |halved: i32| self.steps / step(halved);
        let worth = |halved: &i32| {
            // All longer steps are tried before, and the next finer step confirms it.
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

    /// Two towers of three storeys, 20 s: 500 runs took four times as long with the chosen steps as by the exact method.
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
