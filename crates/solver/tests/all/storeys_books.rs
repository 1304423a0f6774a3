//! Energies of buildings of several storeys, computed from spans and impacts, and checks of spans and impacts.

use pounding_solver::{Hysteresis, Hysteretic, Impact, Node, Recorder, Response, RestoringForce, Row, Span, Support};

/// Columns of any loop, from rest at zero drift.
#[derive(Debug, Clone, Copy)]
pub(crate) struct LoopColumns(pub(crate) Hysteresis);

impl RestoringForce for LoopColumns {
    type Memory = ();

    fn untouched(&self) {}

    fn respond(&self, displacement: f64, (): ()) -> Response<()> {
        Response {
            force: self.0.stiffness * displacement,
            tangent: self.0.stiffness,
            memory: (),
        }
    }
}

impl Hysteretic for LoopColumns {
    fn hysteresis(&self) -> Hysteresis {
        self.0
    }
}

/// Computes energies, and finds the largest violation of the properties of spans and impacts.
pub(crate) struct Books<'a> {
    row: &'a Row<LoopColumns>,
    ground: &'a [f64],
    /// End of the last span of each node: instant, displacement, velocity; impulse since then.
    ends: Vec<[f64; 4]>,
    /// Kinetic energy added by the spans, and works of ground, dampers, columns and pounding forces \[J\].
    pub(crate) terms: [f64; 5],
    /// Sum of the magnitudes of all works \[J\].
    pub(crate) scale: f64,
    /// An instant of impacts, the energy created by them, and the largest such energy before.
    impacts: [f64; 3],
    /// Velocity without an impulse \[m/s\], relative to 1 mm/s or the velocity.
    jump: f64,
    /// Step between spans in displacement \[m\] or time \[s\].
    tear: f64,
    /// Hysteretic force beyond its limit, relative to it.
    beyond: f64,
    /// Pounding force that pulls, relative to the largest.
    pull: [f64; 2],
}

impl<'a> Books<'a> {
    pub(crate) fn new(row: &'a Row<LoopColumns>, ground: &'a [f64]) -> Self {
        let start = |node: &Node<LoopColumns>| {
            let (u, v) = (node.initial_displacement, node.initial_velocity);
            [0.0, u, v, 0.0]
        };
        Self {
            row,
            ground,
            ends: row.nodes().iter().map(start).collect(),
            terms: [0.0; 5],
            scale: 0.0,
            impacts: [-1.0, 0.0, 0.0],
            jump: 0.0,
            tear: 0.0,
            beyond: 0.0,
            pull: [0.0; 2],
        }
    }

    /// Works on a node over a span: of the ground, of its dampers and columns, and of pounding forces.
    fn works(&self, span: &Span<'_>) -> [f64; 4] {
        let node = &self.row.nodes()[span.structure];
        let mass = 1.0 / node.inverse_mass;
        let to_ground = match node.support {
            Support::Ground => 0.0,
            Support::Floor(floor) => floor.ground_damping,
        };
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a count of samples")]
        let sample = (0.5 * (span.start_time + span.end_time) / 0.01) as usize;
        let [before, after] = [sample, sample + 1].map(|index| self.ground.get(index));
        let ground = |time: f64| match (before, after) {
            (Some(before), Some(after)) => before + (after - before) * (time / 0.01 - sample as f64),
            _ => 0.0,
        };
        span.integrate(|time, state| {
            let (rate, v) = (span.drift(time).velocity, state.velocity);
            [
                -mass * ground(time) * v,
                node.damping * rate * rate + to_ground * v * v,
                state.restoring_force * rate,
                state.pounding_force() * v,
            ]
        })
    }

    fn check(&mut self, span: &Span<'_>) {
        let node = &self.row.nodes()[span.structure];
        let [time, displacement, velocity, impulse] = self.ends[span.structure];
        let jump = span.start.velocity - velocity - impulse * node.inverse_mass;
        self.jump = self.jump.max(jump.abs() / (1e-3 + velocity.abs()));
        let tears = [span.start.displacement - displacement, span.start_time - time];
        self.tear = tears.iter().fold(self.tear, |most, tear| most.max(tear.abs()));
        self.ends[span.structure] = [span.end_time, span.end.displacement, span.end.velocity, 0.0];
        let LoopColumns(loops) = node.column;
        if loops.yield_force.is_finite() {
            let [_, drift] = span.drifts();
            let line = loops.hardening * loops.stiffness * drift.displacement;
            let limit = (1.0 - loops.hardening) * loops.yield_force;
            let force = (span.end.restoring_force - line).abs();
            self.beyond = self.beyond.max(force / limit - 1.0);
        }
        // Instants within shorter spans are rounded beyond their end.
        if span.duration() < 1e-12 {
            return;
        }
        for part in [0.0, 0.01, 0.2, 0.5, 0.8, 0.99] {
            let state = span.at(span.start_time + part * span.duration());
            let (left, right) = (state.force_from_left, state.force_from_right);
            self.pull[0] = self.pull[0].max(-left).max(right);
            self.pull[1] = self.pull[1].max(left).max(-right);
        }
    }

    /// Residual of the balance of kinetic energy and works, relative to their magnitudes.
    fn residual(&self) -> f64 {
        let [kinetic, ground, damping, columns, pounding] = self.terms;
        (kinetic - ground + damping + columns - pounding).abs() / self.scale
    }

    /// The largest violation of a law, and its name.
    pub(crate) fn worst(&self) -> (f64, &'static str) {
        let [_, last, most] = self.impacts;
        let [.., columns, pounding] = self.terms;
        let breaches = [
            (self.residual() / 1e-9, "works are not the kinetic energy"),
            (last.max(most) / self.scale / 1e-12, "impacts create energy"),
            (pounding / self.scale / 1e-9, "contacts create energy"),
            (-columns / self.scale / 1e-9, "columns create energy"),
            (self.jump / 1e-9, "a velocity jumps without an impulse"),
            (self.tear / 1e-300, "spans do not join"),
            (self.beyond / 1e-9, "a column is beyond its limit"),
            (self.pull[0] / (1e-9 * self.pull[1] + 1e-12), "a contact pulls"),
        ];
        // NaN violates the first law and is kept: nothing compares larger.
        let worse = |a: (f64, &'static str), b: (f64, &'static str)| if b.0 > a.0 { b } else { a };
        breaches.into_iter().reduce(worse).unwrap_or_default()
    }
}

impl Recorder for Books<'_> {
    fn span(&mut self, span: &Span<'_>) {
        self.check(span);
        if self.row.nodes()[span.structure].is_wall() {
            return;
        }
        let mass = 1.0 / self.row.nodes()[span.structure].inverse_mass;
        let (start, end) = (span.start.velocity, span.end.velocity);
        let works = self.works(span);
        let [ground, damping, columns, pounding] = works;
        let terms = [0.5 * mass * (end - start) * (end + start), ground, damping, columns, pounding];
        for (sum, term) in self.terms.iter_mut().zip(terms) {
            *sum += term;
            self.scale += term.abs();
        }
    }

    fn impact(&mut self, impact: &Impact) {
        let (before, after) = (impact.before, impact.after);
        let rates = before.right + after.right - before.left - after.left;
        let [time, given, most] = self.impacts;
        self.impacts = if impact.time > time {
            [impact.time, 0.0, most.max(given)]
        } else {
            self.impacts
        };
        self.impacts[1] += 0.5 * impact.impulse * rates;
        self.ends[impact.left][3] -= impact.impulse;
        self.ends[impact.right][3] += impact.impulse;
    }
}
