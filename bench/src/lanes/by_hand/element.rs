//! The force of the nonlinear viscoelastic element.

#![expect(
    clippy::inline_always,
    reason = "instructions exist only inside the function that found the machine to have them"
)]

use super::vector::Vectors;

/// One element of all scenes.
#[derive(Clone, Copy)]
pub(super) struct Element {
    /// β̄ \[N/m^1.5\].
    pub(super) stiffness: f64,
    /// ξ̄ \[–\].
    pub(super) ratio: f64,
}

impl Element {
    /// Force of a pair at a deformation and its rate; not a number where the pair is apart.
    #[inline(always)]
    pub(super) fn force<V: Vectors>(
        self,
        v: V,
        reduced_mass: V::Vector,
        [deformation, rate]: [V::Vector; 2],
    ) -> V::Vector {
        let root = v.sqrt(deformation);
        let stiffness = v.all(self.stiffness);
        let spring = v.mul(v.mul(stiffness, deformation), root);
        let inside = v.mul(v.mul(stiffness, root), reduced_mass);
        let damping = v.mul(v.all(2.0 * self.ratio), v.sqrt(inside));
        let both = v.add(spring, v.mul(damping, rate));
        v.select(v.exceeds(rate, v.all(0.0)), both, spring)
    }
}
