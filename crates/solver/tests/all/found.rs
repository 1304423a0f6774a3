//! Extreme random rows that the exact method once computed wrongly.

use crate::watch::Watch;
use pounding_contact::{ContactLaw, HertzDamp, NonlinearViscoelastic, Stereomechanical};
use pounding_solver::{Bilinear, Clock, Exact, Excitation, Integrator, Ledger, Node, Pair, Row};

/// Marsaglia's 64-bit xorshift. Rows are identified by their seed.
struct Random(u64);

impl Random {
    fn new(seed: u64) -> Self {
        let mut random = Self(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1);
        for _ in 0..10 {
            random.unit();
        }
        random
    }

    /// A number in 0 ..= 1.
    fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.unit()
    }

    /// Uniform in the logarithm.
    fn magnitude(&mut self, a: f64, b: f64) -> f64 {
        libm::exp(self.between(libm::log(a), libm::log(b)))
    }

    /// True once in `n` times, on average.
    fn once_in(&mut self, n: u32) -> bool {
        self.below(n) == 0
    }

    /// A number in 0 .. n.
    fn below(&mut self, n: u32) -> u32 {
        let place = self.unit() * f64::from(n);
        (0..n).rfind(|k| f64::from(*k) <= place).unwrap_or(0)
    }

    fn structure(&mut self, like: Option<[f64; 3]>, yields: bool) -> ([f64; 3], Node<Bilinear>) {
        let [mass, period, ratio] = like.unwrap_or_else(|| {
            let (mass, period) = (1e5 * self.magnitude(1e-3, 1e3), self.magnitude(0.05, 5.0));
            let ratio = if self.once_in(4) {
                0.0
            } else {
                self.between(0.0, 1.5) * if self.once_in(2) { 0.05 } else { 1.0 }
            };
            [mass, period, ratio]
        });
        let omega = 2.0 * std::f64::consts::PI / period;
        let stiffness = mass * omega * omega;
        let yield_force = if yields && !self.once_in(3) {
            stiffness * self.magnitude(1e-4, 0.1)
        } else {
            f64::INFINITY
        };
        let column = Bilinear {
            stiffness,
            yield_force,
            hardening: 0.0,
        };
        let node = Node::structure(mass, 2.0 * ratio * omega * mass, column);
        ([mass, period, ratio], node)
    }

    fn pair(&mut self, right: usize, compliant: u32) -> Pair {
        let gap = match self.below(4) {
            0 => 0.0,
            1 => self.magnitude(1e-9, 1e-3),
            _ => self.between(0.0, 0.1),
        };
        let restitution = match self.below(5) {
            0 => 0.0,
            1 => 0.97,
            2 => self.between(0.9, 1.0),
            _ => self.unit(),
        };
        let law = if compliant == 0 || (compliant == 1 && self.once_in(2)) {
            ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
                impact_stiffness: self.magnitude(1e7, 1e11),
                impact_damping_ratio: self.between(0.0, 2.0),
            })
        } else {
            ContactLaw::Stereomechanical(Stereomechanical { restitution })
        };
        let left = right - 1;
        Pair::of_floors(left, right, gap, law)
    }

    /// A row of 1 to 6 structures and a record with samples every 0.02 s.
    fn case(&mut self) -> (Row<Bilinear>, Vec<f64>) {
        let n = 1 + self.below(6) as usize;
        let yields = self.once_in(2);
        let alike = self.once_in(5);
        let (mut first, mut nodes) = (None, Vec::new());
        for _ in 0..n {
            let (kind, node) = self.structure(first.filter(|_| alike), yields);
            first = Some(kind);
            nodes.push(node);
        }
        if n > 1 && self.once_in(4) {
            nodes[0] = Node::wall(Bilinear {
                stiffness: 1.0,
                yield_force: f64::INFINITY,
                hardening: 0.0,
            });
        }
        let compliant = self.below(3);
        let pairs = (1..n).map(|right| self.pair(right, compliant)).collect();
        let strength = self.magnitude(0.1, 20.0);
        let n_samples = 20 + self.below(200);
        let ground = (0..n_samples).map(|_| strength * self.between(-1.0, 1.0)).collect();
        (Row::new(nodes, pairs).expect("the row is valid"), ground)
    }
}

fn check(seed: u64) {
    let (row, ground) = Random::new(seed).case();
    let excitation = Excitation::new(0.02, &ground).expect("the ground motion is finite");
    let clock = Clock {
        time_step: 0.02,
        n_steps: 200,
    };
    let mut ledger = Ledger::new(&row, excitation);
    Integrator::Exact(Exact::default())
        .watch(&row, excitation, clock, &mut ledger)
        .unwrap_or_else(|error| panic!("row {seed}: {error}"));
    let balances = [ledger.residual(), ledger.identity(), ledger.momentum()];
    assert!(balances.iter().all(|balance| *balance < 1e-10), "row {seed}: {balances:?}");
    assert_eq!(ledger.verdict().err(), None, "row {seed}");
}

#[test]
fn issue_a_series_was_used_far_outside_its_reach() {
    // A pair with one side that had just begun to touch a compliant neighbour got an impulse from nothing.
    [200_508, 100_663].into_iter().for_each(check);
}

#[test]
fn issue_structures_at_a_standstill_yielded_by_rounding() {
    // Columns gave energy in yielding: the rounding of a zero acceleration kept them on the yielding branch.
    [100_965, 101_125, 300_635, 300_724, 326, 734, 908, 1_338]
        .into_iter()
        .for_each(check);
}

#[test]
fn issue_neighbours_that_move_alike_touched_and_parted_for_ever() {
    [344, 911, 100_334].into_iter().for_each(check);
}

#[test]
fn issue_rounding_of_a_force_near_zero_is_that_of_its_amplitude() {
    // Neighbours whose forces vanish together touched without end.
    [1_391, 21_209, 20_195, 20_205, 20_633, 21_370].into_iter().for_each(check);
}

/// A light structure between two others parts from one of them at the instant at which the other releases it. A deformation of −3e-22 m was
/// raised to the power 3/2, and the run ended "beyond the range of numbers".
#[test]
fn issue_a_parting_at_another_event_was_gone_past() {
    let node = |mass: f64, period: f64, ratio: f64| {
        let omega = 2.0 * std::f64::consts::PI / period;
        let column = Bilinear {
            stiffness: mass * omega * omega,
            yield_force: f64::INFINITY,
            hardening: 0.0,
        };
        Node::structure(mass, 2.0 * ratio * omega * mass, column)
    };
    let pair = |left: usize, gap: f64, law: ContactLaw| Pair::of_floors(left, left + 1, gap, law);
    let nodes = vec![
        node(683_390.819_104_801_4, 0.054_029_371_412_105_114, 0.0),
        node(173.765_426_887_458_76, 0.325_640_712_577_910_5, 0.0),
        node(7_217_314.971_280_169, 0.508_338_192_654_488_1, 0.739_369_469_950_855),
    ];
    let hard = ContactLaw::HertzDamp(HertzDamp {
        impact_stiffness: 3_430_631_202.669_827_5,
        impact_damping_factor: 9.998_159_397_495_668,
    });
    let soft = ContactLaw::NonlinearViscoelastic(NonlinearViscoelastic {
        impact_stiffness: 51_814_033_768.210_17,
        impact_damping_ratio: 0.560_137_978_749_812_2,
    });
    let pairs = vec![pair(0, 1.616_459_560_867_003_8e-6, hard), pair(1, 0.0, soft)];
    let row = Row::new(nodes, pairs).expect("the row is valid");
    let ground = [7.446_364_965_487_091, -6.484_581_154_281_688];
    let excitation = Excitation::new(0.01, &ground).expect("the record is finite");
    let clock = Clock {
        time_step: 0.01,
        n_steps: 30,
    };
    let mut ledger = Ledger::new(&row, excitation);
    let ran = Integrator::Exact(Exact::default()).watch(&row, excitation, clock, &mut ledger);
    ran.expect("it runs to its end");
    assert!(ledger.residual() < 1e-11, "{:e}", ledger.residual());
}
