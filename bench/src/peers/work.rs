//! CPU time for an error, from measurements over a ladder of settings.

/// CPU time for an error, from CPU times and errors of the settings of a method.
///
/// Uses a power law between the cheapest setting that is accurate enough and the most accurate cheaper setting. `None` if no setting is
/// accurate enough. If the cheapest setting is already accurate enough, returns its time, as an upper bound.
pub(super) fn at_error(points: &[(f64, f64)], error: f64) -> Option<f64> {
    let mut points = points.to_vec();
    points.sort_by(|one, other| one.0.total_cmp(&other.0));
    let mut before: Option<(f64, f64)> = None;
    for (time, reached) in points {
        if reached <= error {
            return Some(match before {
                Some((cheaper, worse)) if reached > 0.0 && worse.is_finite() => {
                    let part = libm::log(worse / error) / libm::log(worse / reached);
                    cheaper * libm::pow(time / cheaper, part)
                }
                _ => time,
            });
        }
        if before.is_none_or(|(_, best)| reached < best) {
            before = Some((time, reached));
        }
    }
    None
}

/// Whether the cheapest setting has at most this error: its time is then an upper bound.
pub(super) fn is_bound(points: &[(f64, f64)], error: f64) -> bool {
    let cheapest = points.iter().min_by(|one, other| one.0.total_cmp(&other.0));
    cheapest.is_some_and(|(_, reached)| *reached <= error)
}

/// The smallest CPU time of several methods for an error, and the method.
pub(super) fn cheapest<T: Copy>(methods: &[(T, Vec<(f64, f64)>)], error: f64) -> Option<(T, f64)> {
    let reaching = methods.iter();
    let reaching = reaching.filter_map(|(name, points)| Some((*name, at_error(points, error)?)));
    reaching.min_by(|one, other| one.1.total_cmp(&other.1))
}

/// Lower bound of the CPU time if no method reaches the error: the smallest time of the costliest settings.
pub(super) fn spent_in_vain<T>(methods: &[(T, Vec<(f64, f64)>)]) -> Option<f64> {
    let costliest = methods.iter().filter_map(|(_, points)| {
        let times = points.iter().map(|(time, _)| *time);
        times.max_by(f64::total_cmp)
    });
    costliest.min_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Order two: a hundredth of the error for ten times the time.
    const ORDER_TWO: [(f64, f64); 3] = [(1.0, 1e-1), (10.0, 1e-3), (100.0, 1e-5)];

    #[test]
    fn reference_time_at_an_error_follows_the_order_of_the_method() {
        for (error, expected) in [(1e-3, 10.0), (1e-2, 10f64.sqrt()), (1e-4, 1000f64.sqrt())] {
            let found = at_error(&ORDER_TWO, error).unwrap();
            assert!((found / expected - 1.0).abs() < 1e-12, "{error}: {found} instead of {expected}");
        }
    }

    #[test]
    fn limit_nothing_is_extrapolated() {
        assert_eq!(at_error(&ORDER_TWO, 0.5), Some(1.0), "accurate already");
        assert_eq!(at_error(&ORDER_TWO, 1e-6), None, "never as accurate");
        assert_eq!(at_error(&[], 1.0), None, "no setting");
    }

    #[test]
    fn limit_a_cheapest_setting_that_is_accurate_is_a_bound() {
        assert!(is_bound(&ORDER_TWO, 0.5), "coarser settings may do");
        assert!(!is_bound(&ORDER_TWO, 1e-2), "between two settings");
    }

    #[test]
    fn extreme_errors_that_rise_and_vanish() {
        // The second setting is worse than the first, and costlier: it is ignored.
        let points = [(1.0, 1e-1), (5.0, 1.0), (10.0, 1e-3)];
        let found = at_error(&points, 1e-2).unwrap();
        assert!((found - 10f64.sqrt()).abs() < 1e-12, "found {found}");
        let rounded = [(1.0, f64::INFINITY), (3.0, 0.0)];
        assert_eq!(at_error(&rounded, 1e-8), Some(3.0), "an error of nothing");
    }

    #[test]
    fn limit_the_cheapest_is_named_and_vain_work_is_a_bound() {
        let quick = vec![(1.0, 1e-2), (50.0, 1e-3)];
        let methods = [("slow", ORDER_TWO.to_vec()), ("quick", quick)];
        let (name, _) = cheapest(&methods, 1e-2).unwrap();
        assert_eq!(name, "quick", "at 1e-2");
        let (name, _) = cheapest(&methods, 1e-4).unwrap();
        assert_eq!(name, "slow", "at 1e-4");
        let bound = spent_in_vain(&methods);
        assert_eq!(bound, Some(50.0), "the least of the costliest settings");
    }
}
