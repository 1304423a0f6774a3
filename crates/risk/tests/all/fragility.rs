//! Fragilities of most likelihood and their bounds.

use pounding_risk::{Bootstrap, EventShare, Fragility, Stripe, Stripes};
use proptest::prelude::*;

use crate::{case, number, of_case, stripes};

/// All sixteen digits of another program, except rounding in the last ones.
#[test]
fn reference_the_case_of_eight_stripes() {
    let fit = Fragility::of(&of_case()).expect("a fragility");
    let expected = &case()["expected"];
    for (name, found) in [
        ("theta_g", fit.fragility.median),
        ("beta", fit.fragility.dispersion),
        ("se_ln_theta", fit.error_of_log_median),
        ("se_beta", fit.error_of_dispersion),
        ("correlation", fit.correlation),
        ("minus_log_likelihood", fit.minus_log_likelihood),
    ] {
        let wanted = number(&expected[name]);
        assert!((found / wanted - 1.0).abs() < 2e-15 * 10.0, "{name}: {found} {wanted}");
    }
}

/// Shares of many motions that follow a lognormal fragility have that fragility.
#[test]
fn limit_shares_of_a_fragility_give_it_back() {
    let known = Fragility {
        median: 0.7,
        dispersion: 0.35,
    };
    let stripe = |intensity: f64| Stripe {
        intensity,
        events: vec![EventShare {
            event: 0,
            share: known.probability(intensity),
        }],
    };
    let all = [0.3, 0.5, 0.8, 1.1, 1.9].map(stripe).to_vec();
    let fit = Fragility::of(&Stripes { all, same_events: true }).expect("a fragility").fragility;
    assert!((fit.median / known.median - 1.0).abs() < 1e-12, "{fit:?}");
    assert!((fit.dispersion / known.dispersion - 1.0).abs() < 1e-12, "{fit:?}");
}

#[test]
fn extreme_stripes_that_determine_no_fragility_say_why() {
    let refused = |all: &[(f64, usize)]| Fragility::of(&stripes(10, all)).expect_err("refused").to_string();
    let said = [
        refused(&[]),
        refused(&[(0.1, 0), (0.2, 0)]),
        refused(&[(0.1, 10), (0.2, 10)]),
        refused(&[(0.1, 0), (0.2, 0), (0.4, 10)]),
        refused(&[(0.1, 0), (0.2, 4), (0.4, 10)]),
        refused(&[(0.2, 4)]),
        refused(&[(0.1, 6), (0.2, 5), (0.4, 3)]),
        refused(&[(0.1, 4), (0.2, 5), (0.4, 5)]),
    ];
    let wanted = [
        "stripes: found none, allowed are two or more",
        "stripes: found the state under none of the motions from 0.1 to 0.2 g, allowed is a part of them at two or more intensities; \
         take higher intensities than 0.2 g",
        "stripes: found the state under all of the motions from 0.1 to 0.2 g, allowed is a part of them at two or more intensities; \
         take lower intensities than 0.1 g",
        "stripes: found the state under no motion up to 0.2 g and under all from 0.4 g, so that β → 0, allowed is a part of the motions at \
         two or more intensities; take more intensities around them, or more motions",
        "stripes: found the state under a part of the motions at 0.2 g alone, so that β → 0, allowed is a part of the motions at two or \
         more intensities; take more intensities around it, or more motions",
        "stripes: found the state under a part of the motions at 0.2 g alone, so that β → 0, allowed is a part of the motions at two or \
         more intensities; take more intensities around it, or more motions",
        "stripes: found shares that do not grow with the intensity, allowed are shares that do; take another intensity measure, or more \
         intensities",
        "stripes: found a dispersion of 5.491, allowed is less than 2; take another intensity measure, such as sa_avg, or more motions",
    ];
    for (said, wanted) in said.iter().zip(wanted) {
        assert_eq!(said, wanted);
    }
}

/// With independent stripes the bootstrap and the expected information estimate the same errors.
#[test]
fn limit_bounds_of_independent_stripes_are_those_of_the_information() {
    let mut all = of_case();
    all.same_events = false;
    let fit = Fragility::of(&all).expect("a fragility");
    let drawn = Bootstrap::of(&all);
    let [low, high] = drawn.bounds(|one| libm::log(one.median)).expect("bounds");
    let half = 1.96 * fit.error_of_log_median;
    assert!(((high - low) / (2.0 * half) - 1.0).abs() < 0.1, "{low} {high} {half}");
    let [low, high] = drawn.bounds(|one| one.dispersion).expect("bounds");
    let half = 1.96 * fit.error_of_dispersion;
    assert!(((high - low) / (2.0 * half) - 1.0).abs() < 0.15, "{low} {high} {half}");
    assert_eq!(drawn, Bootstrap::of(&all), "the same draws");
}

/// Events of one folder are drawn with all of their intensities: each event of the case touches from one intensity on, so that stripes depend
/// on each other and the median is less certain.
#[test]
fn limit_events_at_all_intensities_are_drawn_together() {
    let width = |same_events: bool| {
        let all = Stripes { same_events, ..of_case() };
        let [low, high] = Bootstrap::of(&all).bounds(|one| libm::log(one.median)).expect("bounds");
        high - low
    };
    assert!(width(true) > 1.2 * width(false), "{} {}", width(true), width(false));
}

/// Draws that separate the motions have no fragility; too many of them, and there are no bounds.
#[test]
fn extreme_few_motions_have_no_bounds() {
    let few = stripes(3, &[(0.1, 0), (0.2, 1), (0.3, 2), (0.4, 3)]);
    assert!(Fragility::of(&few).is_ok());
    let drawn = Bootstrap::of(&few);
    assert!(drawn.fragilities.len() < drawn.draws);
    assert_eq!(drawn.bounds(|one| one.median), None);
}

proptest! {
    /// The fit has the largest likelihood of its surroundings, whatever the counts.
    #[test]
    fn limit_the_fit_has_the_largest_likelihood(counts in prop::collection::vec(0_usize..=20, 3..9)) {
        let at = |index: usize| 0.1 * libm::pow(1.4, index as f64);
        let all: Vec<(f64, usize)> = counts.iter().enumerate().map(|(index, count)| (at(index), *count)).collect();
        let Ok(fit) = Fragility::of(&stripes(20, &all)) else {
            return Ok(());
        };
        let minus = |one: Fragility| -> f64 {
            let of = |(intensity, count): &(f64, usize)| {
                let probability = one.probability(*intensity);
                let term = |n: usize, probability: f64| if n > 0 { n as f64 * libm::log(probability) } else { 0.0 };
                term(*count, probability) + term(20 - count, 1.0 - probability)
            };
            -all.iter().map(of).sum::<f64>()
        };
        let Fragility { median, dispersion } = fit.fragility;
        prop_assert!((minus(fit.fragility) - fit.minus_log_likelihood).abs() < 1e-9 * fit.minus_log_likelihood);
        for (by, wider) in [(1.01, 1.0), (0.99, 1.0), (1.0, 1.01), (1.0, 0.99)] {
            let other = Fragility { median: by * median, dispersion: wider * dispersion };
            prop_assert!(minus(other) > fit.minus_log_likelihood - 1e-9, "{fit:?}");
        }
    }
}
