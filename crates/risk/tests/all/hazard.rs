//! Hazard curves and annual frequencies.

use pounding_risk::{EventShare, Fragility, HazardCurve, Stripe, Stripes};
use proptest::prelude::*;

use crate::{case, number, of_case, stripes};

fn power_law(at: &[f64], k0: f64, k: f64) -> HazardCurve {
    let points = at.iter().map(|im| [*im, k0 * libm::pow(*im, -k)]);
    HazardCurve::of(points.collect()).expect("a curve")
}

/// The case in closed form by C. A. Cornell, to all digits of the fragility.
#[test]
fn reference_the_frequency_of_a_power_law() {
    let (case, fit) = (case(), Fragility::of(&of_case()).expect("a fragility"));
    let (k0, k) = (number(&case["inputs"]["k0"]), number(&case["inputs"]["k"]));
    let wanted = number(&case["expected"]["annual_frequency"]);
    for points in [vec![0.001, 100.0], vec![0.01, 0.2, 0.3, 1.5, 30.0]] {
        let found = power_law(&points, k0, k).annual(&fit.fragility).expect("a frequency");
        assert!((found.rate / wanted - 1.0).abs() < 2e-14, "{} {wanted}", found.rate);
        assert!(found.beyond[0] + found.beyond[1] < 1e-4);
        // Poisson.
        assert!((found.probability_in(50.0) / (1.0 - libm::exp(-50.0 * wanted)) - 1.0).abs() < 1e-12);
        assert!((found.return_period() * found.rate - 1.0).abs() < 1e-15);
    }
}

#[test]
fn extreme_curves_that_are_refused() {
    let parse = |text: &str| HazardCurve::parse(text).expect_err("refused").to_string();
    let allowed = "allowed are an intensity in g and a mean annual frequency, both > 0, intensities rising and frequencies falling";
    assert_eq!(
        parse("im_g,frequency\n0.1,0.01\n0.2,0.01\n"),
        format!("hazard: line 3: found \"0.2,0.01\", {allowed}")
    );
    assert_eq!(
        parse("0.2 0.01\n0.1 0.001\n"),
        format!("hazard: line 2: found \"0.1 0.001\", {allowed}")
    );
    assert_eq!(parse("0 0.01\n"), format!("hazard: line 1: found \"0 0.01\", {allowed}"));
    assert_eq!(
        parse("0.1;0.01\n"),
        "hazard: found 1 points, allowed are two or more, each an intensity in g and a mean annual frequency"
    );
    assert_eq!(
        parse("0,1;0,01\n"),
        "hazard: line 1: found \"0,1;0,01\" with decimal commas, allowed are decimal points: \"0.1; 0.01\""
    );
    let curve = power_law(&[0.2, 0.6], 1e-4, 2.5);
    assert_eq!(curve.frequency(0.199), None);
    assert_eq!(curve.frequency(0.601), None);
    assert!((curve.frequency(0.3).expect("within") / (1e-4 * libm::pow(0.3, -2.5)) - 1.0).abs() < 1e-14);
    let fragility = |median: f64| Fragility { median, dispersion: 0.4 };
    let refused = |median: f64| curve.annual(&fragility(median)).expect_err("refused").to_string();
    assert_eq!(
        [refused(0.2), refused(2.0)],
        [
            "hazard: found 58 % of the annual frequency beyond 0.2 to 0.6 g, allowed is up to 5 %; give the curve to lower intensities",
            "hazard: found 99 % of the annual frequency beyond 0.2 to 0.6 g, allowed is up to 5 %; give the curve to higher intensities"
        ]
    );
}

/// Parts of λ by intensity add up to what lies within the curve.
#[test]
fn limit_contributions_add_up() {
    let curve = HazardCurve::of(vec![[0.05, 0.05], [0.1, 0.02], [0.4, 1e-3], [1.2, 2e-5], [3.0, 1e-7]]).expect("a curve");
    let fragility = Fragility {
        median: 0.4,
        dispersion: 0.5,
    };
    let whole = curve.whole(&fragility);
    let sum: f64 = curve.contributions(&fragility, 37).iter().map(|one| one.rate).sum();
    let within = whole.rate * (1.0 - whole.beyond[0] - whole.beyond[1]);
    assert!((sum / within - 1.0).abs() < 1e-12, "{sum} {within}");
}

/// Shares of a lognormal at many intensities, joined by lines, give what the fragility gives, also where stripes end within it.
#[test]
fn limit_many_shares_give_the_frequency_of_their_fragility() {
    let curve = HazardCurve::of(vec![[0.01, 0.2], [0.1, 0.02], [0.4, 1e-3], [1.2, 2e-5], [3.0, 1e-7]]).expect("a curve");
    let fragility = Fragility {
        median: 0.4,
        dispersion: 0.5,
    };
    let wanted = curve.whole(&fragility).rate;
    for [from, to] in [[0.005, 20.0], [0.25, 0.9]] {
        let n = 4000;
        let intensity = |index: u32| from * libm::pow(to / from, f64::from(index) / f64::from(n));
        let stripe = |index: u32| Stripe {
            intensity: intensity(index),
            events: vec![EventShare {
                event: 0,
                share: fragility.probability(intensity(index)),
            }],
        };
        let all = (0..=n).map(stripe).collect();
        let found = curve
            .whole_of_shares(&Stripes { all, same_events: true }, Some(&fragility))
            .expect("a frequency");
        assert!((found.rate / wanted - 1.0).abs() < 1e-5, "{} {wanted}", found.rate);
    }
}

/// No motion up to one intensity and all from the next: the lines need no fragility. λ = −[H P] + [−H]/(k ln(b/a)) by hand.
#[test]
fn limit_shares_that_motions_separate_have_a_frequency() {
    let curve = power_law(&[0.01, 50.0], 1e-3, 2.0);
    let found = curve.whole_of_shares(&stripes(10, &[(0.2, 0), (0.26, 0), (0.3, 10), (0.4, 10)]), None);
    let h = |im: f64| 1e-3 * libm::pow(im, -2.0);
    let wanted = (h(0.26) - h(0.3)) / (2.0 * libm::log(0.3 / 0.26));
    assert!(
        (found.expect("a frequency").rate / wanted - 1.0).abs() < 1e-12,
        "{found:?} {wanted}"
    );
    // A part of the motions at an end, and no fragility: nothing tells what lies beyond.
    assert_eq!(curve.whole_of_shares(&stripes(10, &[(0.2, 1), (0.3, 10)]), None), None);
    assert_eq!(curve.whole_of_shares(&stripes(0, &[(0.2, 0)]), None), None);
}

proptest! {
    /// The closed form of a part against Simpson's rule in ln x: ∫ P k H d ln x.
    #[test]
    fn reference_a_part_of_a_power_law_by_quadrature(
        median in 0.05_f64..5.0, dispersion in 0.05_f64..1.9, k in 0.3_f64..9.0, from in 0.02_f64..2.0, ratio in 1.05_f64..8.0,
    ) {
        let fragility = Fragility { median, dispersion };
        let curve = power_law(&[from, from * ratio], 1e-3 * libm::pow(from, k), k);
        let found = curve.contributions(&fragility, 1)[0].rate;
        let value = |u: f64| {
            let im = from * libm::exp(u);
            fragility.probability(im) * k * 1e-3 * libm::exp(-k * u)
        };
        let n = 4000;
        let step = libm::log(ratio) / f64::from(n);
        let weight = |index: i32| if index == 0 || index == n { 1.0 } else { 2.0 + 2.0 * f64::from(index % 2) };
        let simpson: f64 = (0..=n).map(|index| weight(index) * value(f64::from(index) * step)).sum::<f64>() * step / 3.0;
        // A part is a difference of frequencies, with their rounding.
        prop_assert!((found - simpson).abs() < 1e-9 * simpson + 1e-17, "{found} {simpson}");
    }
}
