//! Gauss–Legendre rules with 8 and 16 nodes.
//!
//! Exact for polynomials of degree 15 and 31, and to rounding for power series with about as many significant terms. Source: any handbook;
//! the nodes were computed with forty digits, and a test checks them against polynomials.

/// Positive nodes on −1 ..= 1 of a rule, half of all nodes, and their weights.
pub(crate) type Rule<const HALF: usize> = [(f64, f64); HALF];

/// The rule for series of few terms.
pub(crate) const EIGHT: &Rule<4> = &[
    (0.183_434_642_495_649_8, 0.362_683_783_378_362),
    (0.525_532_409_916_329, 0.313_706_645_877_887_27),
    (0.796_666_477_413_626_7, 0.222_381_034_453_374_48),
    (0.960_289_856_497_536_3, 0.101_228_536_290_376_26),
];

/// The rule for all others.
pub(crate) const SIXTEEN: &Rule<8> = &[
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_59),
    (0.458_016_777_657_227_37, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_8, 0.149_595_988_816_576_74),
    (0.755_404_408_355_003, 0.124_628_971_255_533_88),
    (0.865_631_202_387_831_8, 0.095_158_511_682_492_79),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_894),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_096),
];

/// Nodes of a rule, on either side of the middle.
pub(crate) type Sides<const HALF: usize> = [[f64; HALF]; 2];

/// Integrals of N functions between two limits. The functions first receive all nodes at once (below and above the middle), and are then
/// evaluated by side and number.
#[inline]
pub(crate) fn integrate_at_once<const N: usize, const HALF: usize, F>(
    rule: &Rule<HALF>,
    from: f64,
    to: f64,
    integrand: impl FnOnce(Sides<HALF>) -> F,
) -> [f64; N]
where
    F: Fn(usize, usize) -> [f64; N],
{
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let nodes = [
        rule.map(|(node, _)| middle - half * node),
        rule.map(|(node, _)| middle + half * node),
    ];
    let values = integrand(nodes);
    let mut sums = [0.0; N];
    for (number, (_, weight)) in rule.iter().enumerate() {
        let sides = values(0, number).into_iter().zip(values(1, number));
        for (sum, (below, above)) in sums.iter_mut().zip(sides) {
            *sum += weight * (below + above);
        }
    }
    sums.map(|sum| half * sum)
}

/// Integrals of functions that receive a single node at a time.
pub(crate) fn integrate<const N: usize, const HALF: usize>(
    rule: &Rule<HALF>,
    from: f64,
    to: f64,
    integrand: impl Fn(f64) -> [f64; N],
) -> [f64; N] {
    integrate_at_once(rule, from, to, |nodes| {
        let integrand = &integrand;
        move |side: usize, number: usize| integrand(nodes[side][number])
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exact_up_to<const HALF: usize>(rule: &Rule<HALF>, degree: u32, missed: f64) {
        let power = |n: u32, x: f64| (0..n).fold(1.0, |product, _| product * x);
        for n in 0..=degree {
            let [found] = integrate(rule, 0.0, 1.0, |x| [power(n, x)]);
            let wanted = 1.0 / f64::from(n + 1);
            assert!((found / wanted - 1.0).abs() < 1e-14, "x^{n}: {found}");
        }
        // The first power that is not exact: otherwise the test would not check the nodes.
        let [found] = integrate(rule, -1.0, 1.0, |x| [power(degree + 1, x)]);
        let error = found * f64::from(degree + 2) / 2.0 - 1.0;
        assert!(error.abs() > missed, "x^{}: {found}", degree + 1);
    }

    #[test]
    fn reference_powers_up_to_the_degree_are_integrated_exactly() {
        exact_up_to(EIGHT, 15, 1e-6);
        exact_up_to(SIXTEEN, 31, 1e-11);
    }
}
