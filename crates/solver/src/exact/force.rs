//! The series of deformation, rate and force of compliant contact.

use pounding_contact::{Action, Form, Power as Exponent, Slope, Term};

use crate::exact::contact::{Join, OnSlope, PairState, Phase};
use crate::exact::member::Member;
use crate::roots::CAPACITY;
use crate::span::Power;

impl PairState {
    /// Coefficient `n` of the deformation, from the motion of both sides.
    fn deformation_of(&self, members: &[Member], p: usize, n: usize) -> f64 {
        if n == 0 {
            self.deformation
        } else if n == p {
            self.rate
        } else if n < (2 + self.alike) * p {
            0.0
        } else {
            let ahead = self.relation.ahead(|node| members[node].displacement[n]);
            self.over_grounds(ahead, |node| members[node].ground_displacement(p, n))
        }
    }

    /// Coefficient `n` of the rate of deformation.
    fn rate_of(&self, members: &[Member], p: usize, n: usize) -> f64 {
        if n == 0 {
            self.rate
        } else if n < (1 + self.alike) * p {
            0.0
        } else {
            let faster = self.relation.ahead(|node| members[node].velocity[n]);
            self.over_grounds(faster, |node| members[node].ground_velocity(p, n))
        }
    }

    /// Extends deformation and rate by the coefficients that follow from the accelerations below `n`: p and 2p more.
    fn follow(&mut self, members: &[Member], p: usize, n: usize) {
        let begin = |order: usize| if n == 0 { 0 } else { n + order - 1 };
        for index in begin(2 * p)..n + 2 * p {
            self.deformations[index] = self.deformation_of(members, p, index);
        }
        for index in begin(p)..n + p {
            self.rates[index] = self.rate_of(members, p, index);
        }
    }

    /// Finds coefficient `n` of a compliant force from those below `n`.
    pub(super) fn find_force(&mut self, members: &[Member], power: Power, n: usize) {
        self.follow(members, power.order(), n);
        let (Join::Touching(phase), Some(form)) = (self.join, self.form) else {
            self.force[n] = 0.0;
            return;
        };
        if phase == Phase::Parting {
            self.force[n] = self.remainder(&form, power, n);
            return;
        }
        if form.action == Action::Both {
            self.pull[n] = self.pull(&form, n);
        }
        self.force[n] = if phase == Phase::Clamped {
            0.0
        } else {
            let spring = self.spring(form.spring, power, n) + self.second_slope(&form, n);
            if phase == Phase::Approach || form.action == Action::Both {
                spring + self.damper(form.damper, power, n)
            } else {
                spring
            }
        };
    }

    /// Coefficient `n` of the way that the deformation has made on the second slope; 0 without such a slope.
    pub(super) fn way_beyond(&self, form: &Form, n: usize) -> f64 {
        let from = |second: Slope| if n == 0 { second.from } else { 0.0 };
        form.second.map_or(0.0, |second| self.deformations[n] - from(second))
    }

    /// Coefficient `n` of the force that the second slope adds.
    fn second_slope(&self, form: &Form, n: usize) -> f64 {
        let second = form.second.filter(|_| self.slope == OnSlope::Second);
        second.map_or(0.0, |second| second.added * self.way_beyond(form, n))
    }

    /// The force before the clamp divided by δ^κ: K δ^(n−κ) + C δ̇ has the sign of the force.
    ///
    /// n − κ is 0 or 1 in every law that would pull (a test of the laws checks this). The quotient therefore has no root and stays smooth
    /// at δ = 0.
    fn pull(&self, form: &Form, n: usize) -> f64 {
        // This value is known to be zero; its rounding does not count.
        if n == 0 && self.crossed >= self.time {
            return 0.0;
        }
        let Form { spring, damper, .. } = form;
        let pushes = if spring.power != damper.power {
            self.deformations[n]
        } else if n == 0 {
            1.0
        } else {
            0.0
        };
        spring.coefficient * pushes + damper.coefficient * self.rates[n]
    }

    /// After a parting the remaining force falls linearly to zero; its impulse is below the tolerance.
    fn remainder(&self, form: &Form, power: Power, n: usize) -> f64 {
        let mut force = form.spring.coefficient * self.deformation * self.deformation.sqrt();
        if form.action == Action::Both {
            force = (force + form.damper.at(self.deformation) * self.rate).max(0.0);
        }
        if n == 0 {
            force
        } else if n == power.order() {
            force * (self.rate / self.deformation)
        } else {
            0.0
        }
    }

    /// The power of x with which the deformation begins; `None` while unknown.
    fn leading(&self, power: Power, n: usize) -> Option<usize> {
        if self.deformation > 0.0 {
            return Some(0);
        }
        // After n steps of the recurrence the coefficients below n + 2p are known.
        let known = n + 2 * power.order();
        (power.order()..known)
            .step_by(power.order())
            .find(|&index| self.deformations[index] > 0.0)
    }

    /// Coefficient `n` of K δ^n: with δ = x^q D it is x^(nq) D^n.
    fn spring(&mut self, spring: Term, power: Power, n: usize) -> f64 {
        let Some(leading) = self.leading(power, n) else {
            return 0.0;
        };
        let shift = times(spring.power, leading);
        if n < shift {
            return 0.0;
        }
        let m = n - shift;
        self.spring[m] = self.coefficient(spring.power, &self.spring, leading, m);
        spring.coefficient * self.spring[m]
    }

    /// Coefficient `n` of C δ^κ δ̇.
    fn damper(&mut self, damper: Term, power: Power, n: usize) -> f64 {
        if damper.power == Exponent::Zero {
            return damper.coefficient * self.rates[n];
        }
        let Some(leading) = self.leading(power, n) else {
            return 0.0;
        };
        // The rate begins with the power leading − p, so that the root needs as many coefficients less.
        let (shift, behind) = (times(damper.power, leading), leading.saturating_sub(power.order()));
        if n < shift + behind {
            return 0.0;
        }
        let last = n - shift - behind;
        self.damper[last] = self.coefficient(damper.power, &self.damper, leading, last);
        let rates = self.rates[behind..=n - shift].iter().rev();
        let products = self.damper[..=last].iter().zip(rates);
        damper.coefficient * products.map(|(root, rate)| root * rate).sum::<f64>()
    }

    /// Coefficient `m` of D^exponent, δ = x^q D, from those `before` it (J. C. P. Miller's recurrence).
    fn coefficient(&self, exponent: Exponent, before: &[f64; CAPACITY], leading: usize, m: usize) -> f64 {
        if exponent == Exponent::One {
            return self.deformations[leading + m];
        }
        let first = self.deformations[leading];
        if m == 0 {
            return exponent.of(first);
        }
        let value = exponent.value();
        let known = &self.deformations[leading + 1..=leading + m];
        let terms = (1..).zip(known.iter().zip(before[..m].iter().rev()));
        let term = |(k, (deformation, before)): (usize, (&f64, &f64))| (value * k as f64 - (m - k) as f64) * deformation * before;
        terms.map(term).sum::<f64>() / (m as f64 * first)
    }
}

/// The power of x with which δ^exponent begins if δ begins with x^`leading`.
///
/// At a touch `leading` is a multiple of four, so that every exponent gives a whole power. Later `leading` is 0.
fn times(exponent: Exponent, leading: usize) -> usize {
    match exponent {
        Exponent::Zero => 0,
        Exponent::Quarter => leading / 4,
        Exponent::Half => leading / 2,
        Exponent::One => leading,
        Exponent::ThreeHalves => 3 * leading / 2,
    }
}
