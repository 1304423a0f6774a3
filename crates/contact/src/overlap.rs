/// State of a pair while it touches, as a contact law sees it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Deformation at the contact δ = `u_left` − `u_right` − gap \[m\], > 0.
    pub deformation: f64,
    /// Rate of deformation δ̇ \[m/s\], positive while approaching.
    pub rate: f64,
    /// Reduced mass of the pair \[kg\], > 0; see [`reduced_mass`].
    pub reduced_mass: f64,
    /// Rate of deformation at the first touch of the present contact v₀ \[m/s\], ≥ 0; 0 if the pair did not approach.
    pub approach_speed: f64,
}

/// Force of a compliant law and its consistent tangents.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactForce<N = f64> {
    /// Pounding force F \[N\], ≥ 0; the left structure gets −F, the right one +F.
    pub force: N,
    /// ∂F/∂δ \[N/m\].
    pub stiffness: N,
    /// ∂F/∂δ̇ \[N·s/m\].
    pub damping: N,
}

/// Reduced mass m₁m₂/(m₁+m₂) \[kg\] of two neighbours given by their inverse masses \[1/kg\].
///
/// A fixed wall has inverse mass 0. Two walls never collide: the result is then infinite, and a row refuses them.
pub fn reduced_mass(inverse_mass_left: f64, inverse_mass_right: f64) -> f64 {
    1.0 / (inverse_mass_left + inverse_mass_right)
}
