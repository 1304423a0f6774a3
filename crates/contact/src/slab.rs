//! Impact stiffness from the slabs that meet.

/// A slab that is struck on its edge and shortens along the row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slab {
    /// Area A of the section that is struck \[m²\], > 0: width times depth of what the blow presses together.
    pub area: f64,
    /// Length L along the row \[m\], > 0.
    pub length: f64,
    /// Young's modulus E \[Pa\], > 0; about 30e9 for concrete.
    pub modulus: f64,
}

/// Density of reinforced concrete \[kg/m³\].
const CONCRETE: f64 = 2500.0;

impl Slab {
    /// Axial stiffness EA/L \[N/m\].
    pub fn stiffness(&self) -> f64 {
        self.modulus * self.area / self.length
    }

    /// Impact stiffness of two slabs that meet \[N/m\], for a linear law: k = 1/(L₁/EA₁ + L₂/EA₂).
    ///
    /// It is an upper estimate: the surfaces that meet are rough, and the blow seldom presses a whole section.
    pub fn impact_stiffness(slabs: &[Self; 2]) -> f64 {
        1.0 / (1.0 / slabs[0].stiffness() + 1.0 / slabs[1].stiffness())
    }

    /// Time 2L/c \[s\] in which a wave runs through a slab of concrete and back, c = √(E/ρ), with ρ = 2500 kg/m³.
    ///
    /// In a collision that is not much longer a floor is no rigid mass (G. Cole, R. Dhakal, A. Carr and D. Bull, *Earthquake Engng Struct.
    /// Dyn.* 40 (2011) 641).
    pub fn wave_time(&self) -> f64 {
        2.0 * self.length / (self.modulus / CONCRETE).sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SLAB: Slab = Slab {
        area: 3.0,
        length: 20.0,
        modulus: 30e9,
    };

    /// Two slabs of 3 m² and 20 m: 4.5 GN/m each, half of it in series; c = 3464 m/s.
    #[test]
    fn reference_two_slabs_of_concrete() {
        assert!((Slab::impact_stiffness(&[SLAB, SLAB]) / 2.25e9 - 1.0).abs() < 1e-12);
        assert!((SLAB.wave_time() - 40.0 / 12e6_f64.sqrt()).abs() < 1e-12);
    }

    /// A slab that does not give way leaves the stiffness of the other.
    #[test]
    fn limit_beside_a_rigid_slab() {
        let rigid = Slab { modulus: 1e30, ..SLAB };
        assert!((Slab::impact_stiffness(&[SLAB, rigid]) / SLAB.stiffness() - 1.0).abs() < 1e-12);
    }
}
