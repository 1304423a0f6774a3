use nalgebra::{DMatrix, DVector};

use super::*;

/// Numbers between −1 and 1.
fn numbers(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) + 1;
    move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// The contacts of an instant: columns of A, demands, approaches.
struct Instant {
    columns: DMatrix<f64>,
    demand: DVector<f64>,
    approach: DVector<f64>,
}

impl Instant {
    fn n(&self) -> usize {
        self.demand.len()
    }

    fn solved(&self, problem: &mut Complementarity) -> Result<(bool, DVector<f64>), ClosedIn> {
        problem.begin(self.columns.nrows(), 0);
        for contact in 0..self.n() {
            let column = self.columns.column(contact);
            problem.push(column.iter().copied().enumerate());
            problem.ask(contact, self.demand[contact], 3.0);
        }
        let unique = problem.solve()?;
        Ok((unique, DVector::from_iterator(self.n(), problem.impulses())))
    }

    /// The instant with its contacts in another order.
    fn turned(&self) -> Self {
        let order: Vec<_> = (0..self.n()).map(|place| (place + 1) % self.n()).collect();
        let of = |vector: &DVector<f64>| DVector::from_fn(self.n(), |place, _| vector[order[place]]);
        Self {
            columns: self.columns.select_columns(&order),
            demand: of(&self.demand),
            approach: of(&self.approach),
        }
    }

    /// Every answer with independent pushing contacts, by trying all sets.
    fn answers(&self) -> Vec<DVector<f64>> {
        let answer = |set: Vec<usize>| {
            let columns = self.columns.select_columns(&set);
            let mut impulses = DVector::zeros(self.n());
            if !set.is_empty() {
                let demand = DVector::from_fn(set.len(), |place, _| self.demand[set[place]]);
                let independent = columns.rank(1e-9) == set.len();
                let matrix = columns.transpose() * &columns;
                let found = matrix.lu().solve(&demand).filter(|_| independent)?;
                for (contact, impulse) in set.iter().zip(&found) {
                    impulses[*contact] = *impulse;
                }
            }
            let left = self.columns.transpose() * (&self.columns * &impulses) - &self.demand;
            (impulses.min() > -1e-9 && left.min() > -1e-9).then_some(impulses)
        };
        sets(self.n()).filter_map(answer).collect()
    }

    /// Impulses of least Σ P² with the velocities of an answer, by trying all sets.
    fn least(&self, answer: &DVector<f64>) -> DVector<f64> {
        let driven = &self.columns * answer;
        let left = self.columns.transpose() * &driven - &self.demand;
        let least = |set: Vec<usize>| {
            if set.iter().any(|contact| left[*contact] > 1e-9) {
                return None;
            }
            let columns = self.columns.select_columns(&set);
            let mut impulses = DVector::zeros(self.n());
            if !set.is_empty() {
                let parts = (columns.transpose() * &columns).symmetric_eigen();
                let inverse = parts.eigenvalues.map(|value| if value > 1e-9 { 1.0 / value } else { 0.0 });
                let inverse = DMatrix::from_diagonal(&inverse);
                let vectors = &parts.eigenvectors;
                let found = vectors * inverse * vectors.transpose() * columns.transpose() * &driven;
                for (contact, impulse) in set.iter().zip(&found) {
                    impulses[*contact] = *impulse;
                }
            }
            let is_met = (&self.columns * &impulses - &driven).amax() < 1e-9;
            (is_met && impulses.min() > -1e-9).then_some(impulses)
        };
        let found = sets(self.n()).filter_map(least);
        let by_norm = |one: &DVector<f64>, other: &DVector<f64>| one.norm().total_cmp(&other.norm());
        found.min_by(by_norm).expect("the answer is there")
    }

    /// Compares the solver with every set.
    fn check(&self, problem: &mut Complementarity, place: &str) -> bool {
        let answers = self.answers();
        let Ok((unique, impulses)) = self.solved(problem) else {
            assert!(answers.is_empty(), "{place}: {:?}", answers[0]);
            return false;
        };
        assert!(!answers.is_empty(), "{place}: {impulses}");
        let driven = &self.columns * &impulses;
        let scale = 1.0 + impulses.amax();
        for answer in &answers {
            let off = (&self.columns * answer - &driven).amax() / scale;
            assert!(off < 1e-9, "{place}: {off:e}");
        }
        let left = (self.columns.transpose() * &driven - &self.demand) / scale;
        let allowed = -2e-14;
        assert!(impulses.min() >= 0.0 && left.min() > allowed, "{place}: {left}");
        let least = self.least(&impulses);
        let off = (&least - &impulses).amax() / scale;
        assert!(off < 1e-9, "{place}: {least} {impulses}");
        let differs = |answer: &DVector<f64>| (answer - &answers[0]).amax() > 1e-6 * scale;
        let differ = answers.iter().any(differs);
        assert!(!(unique && differ), "{place}: {impulses}");
        // Between walls all impulses may grow without bound.
        assert!(unique || differ || place.contains("wall"), "{place}: {impulses}");
        let energy = 0.5 * driven.norm_squared() - impulses.dot(&self.approach);
        assert!(energy < 1e-14 * scale, "{place}: creates {energy:e}");
        let turned = self.turned().solved(problem).expect("it was solved").1;
        for contact in 0..self.n() {
            let other = turned[(contact + self.n() - 1) % self.n()];
            let off = (other - impulses[contact]) / scale;
            assert!(off.abs() < 1e-12, "{place}: {off:e}");
        }
        true
    }
}

/// Every set of n contacts.
fn sets(n: usize) -> impl Iterator<Item = Vec<usize>> {
    (0..1_u32 << n).map(move |set| (0..n).filter(|contact| set >> contact & 1 == 1).collect())
}

/// Slabs and walls against points of one storey: the slabs are rows 0 and 1, the floors below and above 2 and 3.
fn storey(seed: u64, kind: u64) -> Instant {
    let mut number = numbers(seed);
    let masses = [(); 4].map(|()| 1.0 + 0.9 * number());
    let mut velocities = [(); 4].map(|()| number());
    let alike = 0.5 + 0.5 * number();
    let is_plastic = seed.is_multiple_of(5);
    let (mut columns, mut demand, mut approach) = (vec![], vec![], vec![]);
    for _ in 0..60 {
        // A share or a floor, in sixteenths: contacts often coincide, and walls never almost face each other.
        let lean = ((24.0 * number()).round().clamp(-16.0, 16.0) + 16.0) / 32.0;
        let own = [lean - 1.0, -lean];
        let weights = match (kind, kind > 0 && number() > 0.0) {
            (0..3, false) => [1.0, 0.0, own[0], own[1]],
            (1, true) => [0.0, -1.0, -own[0], -own[1]],
            (_, false) => [0.0, 0.0, own[0], own[1]],
            (_, true) => [0.0, 0.0, -own[0], -own[1]],
        };
        let moves = if kind == 4 { 0.3 * number() } else { 0.0 };
        let rates = weights.iter().zip(&velocities);
        let rate = rates.map(|(weight, velocity)| weight * velocity).sum::<f64>() + moves;
        if rate < 0.0 && demand.is_empty() {
            velocities = velocities.map(|velocity| -velocity);
            continue;
        }
        let own = if seed % 5 < 3 { alike } else { 0.5 + 0.5 * number() };
        let restitution = if is_plastic { 0.0 } else { own };
        // Pairs that part stay out, except in the last, plastic round.
        let full = demand.len() as u64 == 2 + seed % 4;
        if (rate >= 0.0 || is_plastic) && !full {
            columns.extend((0..4).map(|row| weights[row] / masses[row].sqrt()));
            demand.push((1.0 + restitution) * rate);
            approach.push(rate);
        }
    }
    Instant {
        columns: DMatrix::from_vec(4, demand.len(), columns),
        demand: demand.into(),
        approach: approach.into(),
    }
}

#[test]
fn reference_every_set_of_contacts_of_a_storey() {
    let mut problem = Complementarity::new(5, 4);
    let mut counts = vec![];
    for (kind, name) in (0..).zip(["slab", "slabs", "slab and wall", "walls", "moving walls"]) {
        let solved = (0..3200).filter(|seed| {
            let place = format!("{name}, seed {seed}");
            let instant = storey(*seed, kind);
            instant.n() > 0 && instant.check(&mut problem, &place)
        });
        counts.push(solved.count());
    }
    assert_eq!(counts, [3200, 3200, 3200, 3200, 2799]);
}

#[test]
fn reference_many_contacts_that_may_depend_on_each_other() {
    let mut problem = Complementarity::new(12, 14);
    for seed in 0..2000 {
        let mut number = numbers(seed);
        let n = 1 + (seed % 12) as usize;
        // Every second problem has a singular W, with the demand in its range.
        let n_rows = if seed % 24 < 12 { n + 2 } else { n.div_ceil(2) };
        let columns = DMatrix::from_fn(n_rows, n, |_, _| number());
        let demand = if n_rows > n {
            DVector::from_fn(n, |_, _| number())
        } else {
            columns.transpose() * DVector::from_fn(n_rows, |_, _| number())
        };
        let instant = Instant {
            approach: demand.clone(),
            columns,
            demand,
        };
        let impulses = instant.solved(&mut problem).expect("there is an answer").1;
        let given = instant.columns.transpose() * (&instant.columns * &impulses);
        for contact in 0..n {
            let (impulse, left) = (impulses[contact], given[contact] - instant.demand[contact]);
            let close = 1e-12 * (1.0 + impulses.amax());
            assert!(impulse >= 0.0 && left > -close, "{seed}, {contact}: {left}");
            assert!(impulse == 0.0 || left < close, "{seed}, {contact}: {left}");
        }
    }
}

#[test]
fn issue_a_push_on_a_shared_floor_may_leave_the_other_contact_alone() {
    // With a growing set the second contact pulls with 46 kN s. Masses of 300 and 200 t; the slabs meet columns of the only storey above
    // and below its floor.
    let (slab, floor) = (3e5_f64.sqrt(), 2e5_f64.sqrt());
    let rates = [1.0, 0.2];
    let columns = [
        [(0, 1.0 / slab), (2, -0.4 / floor), (3, -0.6 / floor)],
        [(1, 1.0 / slab), (3, -0.7 / floor), (4, -0.3 / floor)],
    ];
    let mut problem = Complementarity::new(2, 5);
    problem.begin(5, 0);
    for (contact, column) in columns.into_iter().enumerate() {
        problem.push(column.into_iter());
        problem.ask(contact, 1.65 * rates[contact], 1.0);
    }
    assert_eq!(problem.solve(), Ok(true));
    let impulses: Vec<_> = problem.impulses().collect();
    assert!((impulses[0] - 278_089.887_640_449_4).abs() < 1e-9, "{impulses:?}");
    assert_eq!(impulses[1].to_bits(), 0);
    problem.apply(impulses.into_iter());
    let after = rates[1] - problem.taken(1);
    assert!((after + 0.383_988_764_044_943_8).abs() < 1e-15, "{after}");
}

#[test]
fn extreme_a_mass_between_two_walls() {
    // The two contacts are opposite; neither may take back the demand of the other.
    let mut problem = Complementarity::new(2, 1);
    for (demand, wanted) in [
        ([1.0, -1.0], Ok([1.0, 0.0])),
        ([-1.0, 0.5], Ok([0.0, 0.5])),
        ([0.0, 0.0], Ok([0.0, 0.0])),
        ([1.0, -0.5], Err(ClosedIn { contact: 1 })),
    ] {
        problem.begin(1, 0);
        for (contact, side) in [1.0, -1.0].into_iter().enumerate() {
            problem.push([(0, side)].into_iter());
            problem.ask(contact, demand[contact], 0.0);
        }
        let found = problem.solve().map(|_| problem.impulses().collect::<Vec<_>>());
        assert_eq!(found, wanted.map(Vec::from));
    }
}

#[test]
fn limit_equal_contacts_share_and_allocate_nothing() {
    let mut problem = Complementarity::new(USUAL, 8);
    let room = |problem: &Complementarity| {
        let of = |search: &Search| {
            let lists = search.pushing.capacity() + search.free.capacity();
            let basis = search.basis.capacity();
            search.contacts.capacity() + search.columns.capacity() + lists + basis
        };
        let lists = problem.tight.capacity() + problem.members.capacity();
        let idle = problem.idle.capacity() + problem.fixed.capacity();
        of(&problem.search) + of(&problem.change) + lists + idle
    };
    let before = room(&problem);
    // Sixteen contacts at one point of each of four storeys.
    let mut number = numbers(1);
    let weights = [(); 4].map(|()| [1.5 + number(), 1.5 + number()]);
    problem.begin(8, 0);
    for contact in 0..USUAL {
        let weights = weights[contact % 4].iter().copied().enumerate();
        problem.push(weights.map(|(floor, weight)| (2 * (contact % 4) + floor, weight)));
        problem.ask(contact, 1.0, 1.0);
    }
    assert_eq!(problem.solve(), Ok(false));
    for (contact, impulse) in problem.impulses().enumerate() {
        let [below, above] = weights[contact % 4];
        let wanted = 1.0 / (below * below + above * above) / 16.0;
        assert!((impulse - wanted).abs() < 1e-14, "{contact}: {impulse}");
    }
    assert_eq!(room(&problem), before);
}
