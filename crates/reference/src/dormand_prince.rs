//! The explicit Runge–Kutta method of order 8 by Dormand and Prince with error estimates of order 5 and 3.
//!
//! Source: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*, 2nd ed. (1993), II.5 and II.10, program
//! DOP853, with its coefficients.

use super::equations::{Equations, InStep};
use super::state::State;
use super::variable::Variable;

/// Node c of a stage and its weights `a_j` of the slopes j ≥ 1.
///
/// The weight of slope 0 is c minus the others. Increments are c·k₀ + Σ `a_j`·(`k_j` − k₀), so that weights rounded to f64 sum to c
/// exactly. Otherwise every step would have an error of about 1e-16 of itself, always in the same direction.
type Stage = (f64, &'static [(usize, f64)]);

/// Stages after the first; the last entry is the step itself.
#[rustfmt::skip]
const STAGES: [Stage; 12] = [
    (0.052_600_151_958_767_73, &[]),
    (0.078_900_227_938_151_6, &[(1, 0.059_175_170_953_613_7)]),
    (0.118_350_341_907_227_4, &[(2, 0.088_762_756_430_420_54)]),
    (0.281_649_658_092_772_6, &[(2, -0.884_549_479_328_286_1), (3, 0.924_834_003_261_792)]),
    (1.0 / 3.0, &[(3, 0.170_828_608_729_473_86), (4, 0.125_467_687_566_822_42)]),
    (0.25, &[(3, 0.170_252_211_019_544_05), (4, 0.060_216_538_980_455_96), (5, -0.017_578_125)]),
    (4.0 / 13.0, &[
        (3, 0.170_383_925_712_239_98), (4, 0.107_262_030_446_373_28), (5, -0.015_319_437_748_624_402),
        (6, 0.008_273_789_163_814_023),
    ]),
    (0.651_282_051_282_051_3, &[
        (3, -3.360_892_629_446_941_4), (4, -0.868_219_346_841_726), (5, 27.592_099_699_446_71),
        (6, 20.154_067_550_477_894), (7, -43.489_884_181_069_96),
    ]),
    (0.6, &[
        (3, -2.488_114_619_971_667_7), (4, -0.590_290_826_836_843), (5, 21.230_051_448_181_193),
        (6, 15.279_233_632_882_423), (7, -33.288_210_968_984_86), (8, -0.020_331_201_708_508_627),
    ]),
    (6.0 / 7.0, &[
        (3, 5.186_372_428_844_064), (4, 1.091_437_348_996_729_5), (5, -8.149_787_010_746_927),
        (6, -18.520_065_659_996_96), (7, 22.739_487_099_350_505), (8, 2.493_605_552_679_652_3),
        (9, -3.046_764_471_898_219_6),
    ]),
    (1.0, &[
        (3, -10.534_495_466_737_25), (4, -2.000_872_058_224_862_5), (5, -17.958_931_863_118_8),
        (6, 27.948_884_529_419_96), (7, -2.858_998_277_135_023_5), (8, -8.872_856_933_530_63),
        (9, 12.360_567_175_794_303), (10, 0.643_392_746_015_763_6),
    ]),
    (1.0, &[
        (5, 4.450_312_892_752_409), (6, 1.891_517_899_314_500_3), (7, -5.801_203_960_010_585),
        (8, 0.311_164_366_957_819_9), (9, -0.152_160_949_662_516_1), (10, 0.201_365_400_804_030_34),
        (11, 0.044_710_615_727_772_59),
    ]),
];

/// The step minus the embedded step of order 5, by slope.
const ERROR: [(usize, f64); 8] = [
    (0, 0.013_120_044_994_194_88),
    (5, -1.225_156_446_376_204_4),
    (6, -0.495_758_949_657_250_2),
    (7, 1.664_377_182_454_986_4),
    (8, -0.350_328_848_749_973_66),
    (9, 0.334_179_118_713_017_5),
    (10, 0.081_923_206_485_115_71),
    (11, -0.022_355_307_863_886_294),
];

/// Scratch of the method.
#[derive(Debug, Clone)]
pub(super) struct DormandPrince {
    /// Slopes of the last step; the first is that of its start.
    slopes: Vec<Vec<f64>>,
    point: Vec<f64>,
}

impl DormandPrince {
    pub(super) fn new(n_unknowns: usize) -> Self {
        Self {
            slopes: vec![vec![0.0; n_unknowns]; STAGES.len()],
            point: vec![0.0; n_unknowns],
        }
    }

    /// Slope at the start of the last step.
    pub(super) fn first_slope(&self) -> &[f64] {
        &self.slopes[0]
    }

    /// Makes a step of `length` in a variable.
    pub(super) fn step(&mut self, motion: &Equations, variable: Variable, length: f64, from: &State, to: &mut State) {
        let Self { slopes, point } = self;
        let at = |position: f64| InStep { variable, position };
        motion.slope(at(0.0), &from.high, &mut slopes[0]);
        for (stage, (node, weights)) in STAGES.iter().enumerate() {
            let (first, others) = slopes.split_first_mut().expect("twelve slopes");
            // Slope by slope, in place of unknown by unknown: such loops run in vectors.
            for (sum, start) in point.iter_mut().zip(&*first) {
                *sum = node * start;
            }
            for &(slope, weight) in *weights {
                for ((sum, start), other) in point.iter_mut().zip(&*first).zip(&others[slope - 1]) {
                    *sum += weight * (other - start);
                }
            }
            if stage + 1 == STAGES.len() {
                for (index, sum) in point.iter().enumerate() {
                    to.add(from, index, length * sum);
                }
            } else {
                for ((point, high), low) in point.iter_mut().zip(&from.high).zip(&from.low) {
                    *point = high + (low + length * *point);
                }
                motion.slope(at(node * length), point, &mut others[stage]);
            }
        }
    }

    /// Error of the embedded step of order 5: the largest of the unknowns, each in units of its `scale`; acceptable below 1.
    ///
    /// DOP853 divides by an estimate of order 3 to get an estimate of order 8. After a first touch the velocity is a σ⁵ + b σ¹⁰ + …. The
    /// method meets the first term exactly, which then hides the error of the second term (by observed factors of 20 to 400). The plain
    /// estimate is the cautious choice, and in free flight the longest step decides.
    pub(super) fn error(&mut self, length: f64, scale: impl Fn(usize) -> f64) -> f64 {
        let mut largest = 0.0;
        self.point.fill(0.0);
        for (slope, weight) in ERROR {
            for (sum, slope) in self.point.iter_mut().zip(&self.slopes[slope]) {
                *sum += weight * slope;
            }
        }
        for (index, sum) in self.point.iter().enumerate() {
            // A wall has neither motion nor scale.
            if *sum != 0.0 {
                let error = length * sum.abs() / scale(index);
                // A NaN error must stay NaN.
                if error.is_nan() || error > largest {
                    largest = error;
                }
            }
        }
        largest
    }
}

#[cfg(test)]
mod tests {
    use pounding_contact::{ContactLaw, NonlinearViscoelastic};
    use pounding_solver::{Elastic, Node, Pair, Row};

    use super::super::block::Block;
    use super::super::equations::Segment;
    use super::super::model::{Model, TIME, displacement, velocity};
    use super::super::phases::{ContactPhase, Phases};
    use super::*;

    /// A unit mass on a spring k = 9 against a wall through a Hertz spring β = 2, in restitution.
    fn motion() -> Equations {
        let nodes = vec![
            Node::structure(1.0, 0.0, Elastic { stiffness: 9.0 }),
            Node::wall(Elastic { stiffness: 9.0 }),
        ];
        let law = NonlinearViscoelastic {
            impact_stiffness: 2.0,
            impact_damping_ratio: 0.0,
        };
        let pair = Pair::of_floors(0, 1, 0.0, ContactLaw::NonlinearViscoelastic(law));
        let model = Model::new(&Row::new(nodes, vec![pair]).unwrap()).unwrap();
        let mut phases = Phases::new(&model);
        phases.pairs[0].contact = ContactPhase::Restitution { rising: -1.0 };
        Equations {
            block: Block::new(&model, Vec::new()),
            model,
            phases,
            segment: Segment {
                grounds: vec![(0.0, 0.0); 2],
                ..Segment::default()
            },
        }
    }

    fn energy(state: &State) -> f64 {
        let (u, v) = (state.high[displacement(0)], state.high[velocity(0)]);
        0.5 * v * v + 4.5 * u * u + 0.8 * u * u * u.sqrt()
    }

    /// Error of the energy after one step, and the estimate.
    fn errors(length: f64) -> (f64, f64) {
        let motion = motion();
        let mut from = State::zero(motion.model.n_unknowns());
        from.set(displacement(0), 1.0);
        from.set(motion.model.pairs[0].deformation, 1.0);
        let mut to = from.clone();
        let mut method = DormandPrince::new(motion.model.n_unknowns());
        method.step(&motion, Variable::Time, length, &from, &mut to);
        assert!((to.high[TIME] - length).abs() <= f64::EPSILON * length, "time");
        let estimate = method.error(length, |_| 1.0);
        ((energy(&to) - energy(&from)).abs(), estimate)
    }

    #[test]
    fn order_of_a_step_is_8_and_that_of_its_estimate_5() {
        let slope = |coarse: f64, fine: f64| libm::log2(coarse / fine);
        for length in [0.4, 0.32] {
            let ((coarse, estimate), (fine, finer)) = (errors(length), errors(0.5 * length));
            // A single step has one power more than all steps together.
            let (step, estimated) = (slope(coarse, fine), slope(estimate, finer));
            assert!(step > 8.5, "{length}: {coarse:e} to {fine:e}, slope {step}");
            assert!((5.5..8.0).contains(&estimated), "{length}: slope {estimated} of the estimate");
            assert!(estimate > coarse, "the estimate is cautious");
        }
    }

    #[test]
    fn limit_weights_sum_to_their_nodes() {
        // The printed weights of slope 0 of each stage; here they follow from the others.
        let first = [
            0.052_600_151_958_767_73,
            0.019_725_056_984_537_9,
            0.029_587_585_476_806_85,
            0.241_365_134_159_266_7,
            0.037_037_037_037_037_035,
            0.037_109_375,
            0.037_092_000_118_504_79,
            0.624_110_958_716_075_7,
            0.477_662_536_438_264_34,
            -0.937_142_430_085_987_3,
            2.273_310_147_516_538,
            0.054_293_734_116_568_765,
        ];
        for ((node, weights), printed) in STAGES.iter().zip(first) {
            let others: f64 = weights.iter().map(|(_, weight)| weight).sum();
            assert!((node - others - printed).abs() < 1e-14, "{node}: {printed}");
        }
    }
}
