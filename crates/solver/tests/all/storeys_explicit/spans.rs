//! Properties of spans and impacts of towers: balances, equilibrium, and the motion of the floor below.

use pounding_contact::{ContactLaw, Stereomechanical};
use pounding_solver::{Bilinear, Excitation, Hysteretic, Impact, Integrator, Motion, Path, Recorder, Row, Span, State, Support, Weighed};

use super::{EXPLICIT, elastic, plastic, side_by_side, soft, started, stiff};
use crate::common::{STEREOMECHANICAL, SUBSTEPPED, VISCOELASTIC, clock, ground};
use crate::watch::Watch;

/// A span with copies of its borrowed data.
#[derive(Debug, Clone, Copy)]
struct Kept {
    floor: usize,
    times: [f64; 2],
    ends: [State; 2],
    below: Option<[Motion; 2]>,
    pounding: f64,
    weighed: Weighed,
}

impl Kept {
    /// Whether a whole step met a neighbour that sub-steps: its force acts for less than half of the step.
    fn met_late(&self) -> bool {
        let [start, end] = self.ends.map(|state| state.pounding_force());
        let half = 0.5 * (self.times[1] - self.times[0]);
        start == 0.0 && (self.pounding - half * end).abs() > 1e-6 * end.abs()
    }
}

/// Keeps everything.
#[derive(Default)]
struct Keeper {
    spans: Vec<Kept>,
    impacts: Vec<Impact>,
}

impl Keeper {
    /// Spans of a floor.
    fn of(&self, floor: usize) -> Vec<&Kept> {
        let of = |span: &&Kept| span.floor == floor;
        self.spans.iter().filter(of).collect()
    }
}

impl Recorder for Keeper {
    fn reads_weighed(&self) -> bool {
        true
    }

    fn span(&mut self, span: &Span<'_>) {
        let Path::Cubic(weighed) = span.path else {
            unreachable!("a stepping method")
        };
        self.spans.push(Kept {
            floor: span.structure,
            times: [span.start_time, span.end_time],
            ends: [span.start, span.end],
            below: span.below,
            pounding: span.impulse_from_left + span.impulse_from_right,
            weighed,
        });
    }

    fn impact(&mut self, impact: &Impact) {
        self.impacts.push(*impact);
    }
}

fn keep<Column: Hysteretic>(row: &Row<Column>, method: Integrator, dt: f64) -> Keeper {
    let (samples, mut keeper) = (ground(), Keeper::default());
    let excitation = Excitation::new(0.01, &samples).expect("the ground motion is finite");
    method.watch(row, excitation, clock(dt, 5.0), &mut keeper).expect("the run ends");
    keeper
}

/// Three towers that collide, yield and move from the start.
fn row(law: ContactLaw) -> Row<Bilinear> {
    let towers = [soft(plastic), stiff(2, plastic), soft(plastic)];
    let (row, _) = side_by_side(&towers, &[0.01, 0.02], law);
    started(&row, |node| (1e-4 * node as f64, 0.1))
}

/// The floor below; `None` on the ground.
fn below<Column: Hysteretic>(row: &Row<Column>, floor: usize) -> Option<usize> {
    match row.nodes()[floor].support {
        Support::Ground => None,
        Support::Floor(floor) => Some(floor.below),
    }
}

const LAWS: [ContactLaw; 2] = [STEREOMECHANICAL, VISCOELASTIC];

/// Checks that m Δu̇ of every floor and span is the sum of the impulses.
fn check_momentum<Column: Hysteretic>(row: &Row<Column>, kept: &Keeper, name: &str) {
    let mut scale: f64 = 0.0;
    for span in &kept.spans {
        let mass = 1.0 / row.nodes()[span.floor].inverse_mass;
        let [start, end] = span.ends;
        scale = scale.max(mass * end.velocity.abs());
        let change = mass * (end.velocity - start.velocity);
        let Weighed {
            restoring,
            damping,
            ground_velocity,
        } = span.weighed;
        let sum = restoring + damping + span.pounding - mass * ground_velocity;
        assert!((change - sum).abs() < 1e-12 * scale, "{name}: {change} {sum} {span:?}");
    }
}

#[test]
fn limit_spans_of_a_building_belong_together() {
    for law in LAWS {
        let row = row(law);
        for (name, method) in EXPLICIT {
            let kept = keep(&row, method, 0.005);
            let n = row.nodes().len();
            let of = |floor: usize| kept.spans.iter().filter(move |span| span.floor == floor);
            for floor in 0..n {
                let mut time: f64 = 0.0;
                for span in of(floor) {
                    assert!(
                        span.times[0].to_bits() == time.to_bits() && span.times[1] > time,
                        "{name}, {floor}: {:?} after {time}",
                        span.times
                    );
                    time = span.times[1];
                }
                assert!((time - 5.0).abs() < 1e-12, "{name}: ends at {time}");
                let Some(lower) = below(&row, floor) else {
                    assert!(of(floor).all(|span| span.below.is_none()), "{name}");
                    continue;
                };
                assert_eq!(of(floor).count(), of(lower).count(), "{name}: {floor}");
                for (upper, lower) in of(floor).zip(of(lower)) {
                    assert_eq!(upper.times.map(f64::to_bits), lower.times.map(f64::to_bits), "{name}");
                    let motion = lower.ends.map(|state| Motion {
                        displacement: state.displacement,
                        velocity: state.velocity,
                    });
                    assert_eq!(upper.below, Some(motion), "{name}: floor {floor}");
                }
            }
        }
    }
}

/// Residual of equilibrium of a floor at an end of its span \[m/s²\].
fn unbalanced<Column: Hysteretic>(row: &Row<Column>, [own, below, above]: [Option<State>; 3], floor: usize, ground: f64) -> f64 {
    let node = &row.nodes()[floor];
    let own = own.expect("a state");
    let velocity = |state: Option<State>| state.map_or(0.0, |state| state.velocity);
    let mut force = own.pounding_force() - own.restoring_force - node.damping * (own.velocity - velocity(below));
    if let Support::Floor(support) = node.support {
        force -= support.ground_damping * own.velocity;
    }
    if let (Some(above), Some(index)) = (above, row.above(floor)) {
        let dashpot = row.nodes()[index].damping * (above.velocity - own.velocity);
        force += above.restoring_force + dashpot;
    }
    own.acceleration - (node.inverse_mass * force - ground)
}

/// Checks that every floor is in equilibrium at both ends of its spans.
fn check_equilibrium<Column: Hysteretic>(row: &Row<Column>, kept: &Keeper, name: &str) {
    let samples = ground();
    let at = |time: f64| {
        let step = (time / 0.01).floor().min(999.0);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small positive number")]
        let index = step as usize;
        let part = time / 0.01 - step;
        (1.0 - part) * samples[index] + part * samples[index + 1]
    };
    for floor in 0..row.nodes().len() {
        let below = below(row, floor).map(|below| kept.of(below));
        let above = row.above(floor).map(|above| kept.of(above));
        for (number, span) in kept.of(floor).iter().enumerate() {
            for end in 0..2 {
                let pick = |spans: &Option<Vec<&Kept>>| spans.as_ref().map(|spans| spans[number].ends[end]);
                let states = [Some(span.ends[end]), pick(&below), pick(&above)];
                let left = unbalanced(row, states, floor, at(span.times[end]));
                assert!(left.abs() < 1e-9, "{name}, floor {floor}, end {end}: {left:e} {span:?}");
            }
        }
    }
}

#[test]
fn limit_floors_balance_in_every_span() {
    for law in LAWS {
        let row = row(law);
        for (name, method) in EXPLICIT {
            let kept = keep(&row, method, 0.005);
            let touches = kept.spans.iter().any(|span| span.pounding != 0.0);
            assert!(touches || !kept.impacts.is_empty(), "{name}: no contact");
            check_momentum(&row, &kept, name);
            check_equilibrium(&row, &kept, name);
        }
    }
}

#[test]
fn limit_floors_balance_where_whole_steps_meet_sub_steps() {
    // A light tower between stiff towers, in contact with one of them, reaches the other within a step.
    let light = vec![(2e4, elastic(5e6)); 3];
    let towers = [stiff(3, elastic), light, stiff(2, elastic)];
    let (row, _) = side_by_side(&towers, &[0.0, 0.0], VISCOELASTIC);
    let kept = keep(&row, SUBSTEPPED, 0.01);
    assert!(kept.spans.iter().any(Kept::met_late), "none is met");
    check_momentum(&row, &kept, "light");
    check_equilibrium(&row, &kept, "light");
}

#[test]
fn reference_impacts_of_floors_follow_the_law() {
    for restitution in [0.0, 0.65, 1.0] {
        let law = ContactLaw::Stereomechanical(Stereomechanical { restitution });
        let towers = [soft(elastic), stiff(3, elastic)];
        let (row, _) = side_by_side(&towers, &[0.01], law);
        for (name, method) in EXPLICIT {
            let kept = keep(&row, method, 0.002);
            assert!(kept.impacts.len() > 10, "{name}: {}", kept.impacts.len());
            let floors = kept.impacts.iter().map(|impact| impact.left);
            assert!(floors.clone().any(|floor| floor != 0), "{name}: upper floors collide");
            for impact in &kept.impacts {
                let (before, after) = (impact.before, impact.after);
                let approach = before.left - before.right;
                let parting = after.right - after.left;
                assert!(
                    approach > 0.0 && (parting - restitution * approach).abs() < 1e-12,
                    "{name}, {restitution}: {impact:?}"
                );
                let mass = |node: usize| 1.0 / row.nodes()[node].inverse_mass;
                let given = mass(impact.left) * (before.left - after.left);
                let got = mass(impact.right) * (after.right - before.right);
                let error = (given - impact.impulse).abs().max((got - impact.impulse).abs());
                assert!(error < 1e-8, "{name}: {given} {got} {impact:?}");
            }
        }
    }
}
