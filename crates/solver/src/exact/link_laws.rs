//! Laws of links in the exact method.
//!
//! Springs and restrainers lie on a line between events, F = h + a k δ + c δ̇. The part h = k′ (δ − origin), k′ = (1 − a) k, stays within
//! limits; a restrainer lets go at h = 0. A braced damper has the state F, whose rate is a product of series.

use crate::exact::bend::NOTHING;
use crate::model::link::Braced;
use crate::roots::CAPACITY;
use crate::span::value;
use crate::{LinkLaw, RestoringForce, Row};

/// The branch of a spring or a restrainer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Branch {
    Elastic,
    /// At the upper limit of h: yielding in compression.
    Upper,
    /// At the lower limit: yielding in tension.
    Lower,
    /// A restrainer without a force.
    Slack,
}

/// What happens to a link at an instant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// A spring or a restrainer goes on to this branch.
    To(Branch),
    /// The rate of deformation changes sign.
    Turns,
    /// The force has an extremum.
    Peaks,
    /// The force of a braced damper passes through zero.
    PassesZero,
}

/// The part h of a spring or a restrainer.
#[derive(Debug, Clone, Copy)]
pub(super) struct Line {
    /// k′ \[N/m\].
    pub(super) stiffness: f64,
    /// a k \[N/m\].
    pub(super) hardened: f64,
    /// c \[N·s/m\].
    pub(super) damping: f64,
    /// Limits of h \[N\], the lower first.
    pub(super) limits: [f64; 2],
    /// Whether h ends at zero from below, and the branch beyond.
    pub(super) lets_go: bool,
    pub(super) branch: Branch,
    /// Deformation at which h is zero \[m\].
    pub(super) origin: f64,
    /// h at the start of the piece \[N\].
    pub(super) force: f64,
    /// Elongation beyond the origin at the start of the piece \[m\]; < 0 while a restrainer is slack.
    pub(super) stretch: f64,
}

/// A braced damper: its force at the start of the piece \[N\], and series of the part |F|/c and its powers.
#[derive(Debug, Clone)]
pub(super) struct Flow {
    pub(super) damper: Braced,
    pub(super) force: f64,
    /// Sign of the force.
    pub(super) sign: f64,
    pub(super) powers: Vec<[f64; CAPACITY]>,
}

/// The force of a link that deforms.
#[derive(Debug, Clone)]
pub(super) enum Law {
    Line(Line),
    Flow(Flow),
}

impl Law {
    /// `None` for a law that the exact method has no series for.
    pub(super) fn new(law: LinkLaw) -> Option<Self> {
        let line = |stiffness: f64, hardened: f64, damping: f64, limits: [f64; 2]| Line {
            stiffness,
            hardened,
            damping,
            limits,
            lets_go: false,
            branch: Branch::Elastic,
            origin: 0.0,
            force: 0.0,
            stretch: 0.0,
        };
        Some(match law {
            LinkLaw::Spring(spring) => {
                // A spring that never yields is elastic.
                let hardening = if spring.yield_force.is_finite() { spring.hardening } else { 0.0 };
                let part = 1.0 - hardening;
                let limit = part * spring.yield_force;
                let hardened = hardening * spring.stiffness;
                Self::Line(line(part * spring.stiffness, hardened, spring.damping, [-limit, limit]))
            }
            LinkLaw::Restrainer(restrainer) => Self::Line(Line {
                lets_go: true,
                branch: Branch::Slack,
                origin: -restrainer.slack,
                ..line(restrainer.stiffness, 0.0, 0.0, [-restrainer.yield_force, 0.0])
            }),
            LinkLaw::Braced(damper) => Self::Flow(Flow {
                damper,
                force: 0.0,
                sign: 0.0,
                powers: vec![[0.0; CAPACITY]; damper.inverse_exponent as usize],
            }),
            LinkLaw::Viscous(_) => return None,
        })
    }

    /// Stiffness \[N/m\] and dashpot \[N·s/m\].
    pub(super) fn rates(&self) -> [f64; 2] {
        match self {
            Self::Line(line) => [line.stiffness + line.hardened, line.damping],
            Self::Flow(flow) => [flow.damper.stiffness, 0.0],
        }
    }
}

impl Line {
    /// Takes the deformation at t = 0 \[m\].
    pub(super) fn begin(&mut self, deformation: f64) {
        self.stretch = self.origin - deformation;
        if self.branch == Branch::Slack && self.stretch <= 0.0 {
            return;
        }
        self.branch = Branch::Elastic;
        let force = self.stiffness * (deformation - self.origin);
        let [lower, upper] = self.limits;
        self.force = force.clamp(lower, upper);
        let excess = force - self.force;
        if excess != 0.0 {
            self.origin += excess / self.stiffness;
        }
    }

    /// h at a deformation on the present branch.
    pub(super) fn at(&self, deformation: f64) -> f64 {
        match self.branch {
            Branch::Elastic => self.stiffness * (deformation - self.origin),
            Branch::Upper => self.limits[1],
            Branch::Lower => self.limits[0],
            Branch::Slack => 0.0,
        }
    }

    /// Tangent of h \[N/m\].
    pub(super) fn tangent(&self) -> f64 {
        if self.branch == Branch::Elastic { self.stiffness } else { 0.0 }
    }

    /// Changes the branch at a deformation.
    pub(super) fn go_to(&mut self, branch: Branch, deformation: f64) {
        match branch {
            Branch::Upper => self.force = self.limits[1],
            Branch::Lower => self.force = self.limits[0],
            Branch::Slack => (self.force, self.origin, self.stretch) = (0.0, deformation, 0.0),
            Branch::Elastic if self.branch == Branch::Slack => self.force = 0.0,
            Branch::Elastic => self.origin = deformation - self.force / self.stiffness,
        }
        self.branch = branch;
    }

    /// Whether it yields against this rate of deformation.
    pub(super) fn turns(&self, rate: f64) -> bool {
        match self.branch {
            Branch::Upper => rate < 0.0,
            Branch::Lower => rate > 0.0,
            Branch::Elastic | Branch::Slack => false,
        }
    }
}

impl Flow {
    /// Coefficient `n` of the rate at which the damper deforms, from those of the force up to `n`.
    pub(super) fn flows(&mut self, force: &[f64; CAPACITY], n: usize) -> f64 {
        self.powers[0][n] = self.sign * force[n] / self.damper.coefficient;
        for index in 1..self.powers.len() {
            let (known, rest) = self.powers.split_at_mut(index);
            let (before, first) = (&known[index - 1], &known[0]);
            rest[0][n] = (0..=n).map(|m| before[m] * first[n - m]).sum();
        }
        let last = self.powers.len() - 1;
        self.sign * self.powers[last][n]
    }

    /// Whether the series of the flow is that power of the force at x.
    pub(super) fn is_power(&self, len: usize, x: f64, tolerance: f64) -> bool {
        let [part, flow] = [0, self.powers.len() - 1].map(|index| value(&self.powers[index][..len], x));
        let power = (0..self.damper.inverse_exponent).fold(1.0, |power, _| power * part);
        let rounding = 64.0 * f64::EPSILON * power.abs().max(NOTHING);
        (power - flow).abs() <= rounding.max(tolerance)
    }

    /// Whether the force passes through zero with a kink: an odd power needs no sign.
    pub(super) fn has_kink(&self) -> bool {
        self.damper.inverse_exponent.is_multiple_of(2)
    }
}

/// Forces of links on a floor, as series of what they add to the forces against its motion.
#[derive(Debug, Clone)]
pub(super) struct Linked {
    pub(super) against: [f64; CAPACITY],
    /// Magnitude of the terms of these forces \[N\].
    pub(super) magnitude: f64,
    /// Sums of the stiffness \[N/m\], dashpots \[N·s/m\] and relaxation rates \[1/s\] of its links.
    pub(super) stiffness: f64,
    pub(super) damping: f64,
    pub(super) relaxation: f64,
}

impl Linked {
    /// The links of a node; `None` if there are none.
    pub(super) fn at<Column: RestoringForce>(row: &Row<Column>, node: usize) -> Option<Box<Self>> {
        let at = row.linking().at(node);
        if at.is_empty() {
            return None;
        }
        let mut linked = Self {
            against: [0.0; CAPACITY],
            magnitude: 0.0,
            stiffness: 0.0,
            damping: 0.0,
            relaxation: 0.0,
        };
        for link in at {
            let law = row.links()[link.pair].law;
            linked.stiffness += law.stiffness();
            linked.damping += law.dashpot();
            if let LinkLaw::Braced(damper) = law {
                linked.relaxation = linked.relaxation.max(damper.stiffness / damper.coefficient);
            }
        }
        Some(Box::new(linked))
    }
}
