//! Gauss–Legendre rule with 16 nodes.
//!
//! Exact for polynomials of degree 31, and to rounding for power series that themselves need no more than about 30
//! terms. Source: any handbook; the nodes were computed with forty digits, and a test holds them to the polynomials.

/// Positive nodes on −1 ..= 1 and their weights.
const RULE: [(f64, f64); 8] = [
    (0.095_012_509_837_637_44, 0.189_450_610_455_068_5),
    (0.281_603_550_779_258_9, 0.182_603_415_044_923_59),
    (0.458_016_777_657_227_37, 0.169_156_519_395_002_54),
    (0.617_876_244_402_643_8, 0.149_595_988_816_576_74),
    (0.755_404_408_355_003, 0.124_628_971_255_533_88),
    (0.865_631_202_387_831_8, 0.095_158_511_682_492_79),
    (0.944_575_023_073_232_6, 0.062_253_523_938_647_894),
    (0.989_400_934_991_649_9, 0.027_152_459_411_754_096),
];

/// Integrals of N functions between two limits.
pub(crate) fn integrate<const N: usize>(
    (from, to): (f64, f64),
    integrand: impl Fn(f64) -> [f64; N],
) -> [f64; N] {
    let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
    let mut sums = [0.0; N];
    for (node, weight) in RULE {
        let (below, above) = (
            integrand(middle - half * node),
            integrand(middle + half * node),
        );
        for ((sum, below), above) in sums.iter_mut().zip(below).zip(above) {
            *sum += weight * (below + above);
        }
    }
    sums.map(|sum| half * sum)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reference_powers_up_to_31_are_integrated_exactly() {
        let power = |n: u32, x: f64| (0..n).fold(1.0, |product, _| product * x);
        for n in 0..=31 {
            let [found] = integrate((0.0, 1.0), |x| [power(n, x)]);
            let wanted = 1.0 / f64::from(n + 1);
            assert!((found / wanted - 1.0).abs() < 1e-14, "x^{n}: {found}");
        }
        // The first power that is not: were it exact too, the test would not see the nodes.
        let [found] = integrate((-1.0, 1.0), |x| [power(32, x)]);
        assert!((found * 33.0 / 2.0 - 1.0).abs() > 1e-11, "x^32: {found}");
    }
}
