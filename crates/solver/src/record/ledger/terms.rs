use std::ops::AddAssign;

/// The terms of an energy balance \[J\] at an instant: of a floor and its storey, of a building or of a row.
///
/// For a building and for a row: kinetic + strain + damping + hysteretic + impact + contact + link = initial + input + opening. Each term is
/// computed separately from the motion and its forces; none is the remainder of the others.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Terms {
    /// Kinetic and strain energy at the start of the motion, ≥ 0.
    pub initial: f64,
    /// Work of the shaking, ∫ −m·`a_g`·u̇ dt (relative to the ground); of either sign.
    pub input: f64,
    /// Work through contact and links of grounds that move towards each other: ∫ F·Ḋ dt and P·Ḋ, with D the distance by which they have come closer.
    /// Of either sign; half of it is booked with each floor. 0 if all buildings are shaken at once.
    pub opening: f64,
    /// Kinetic energy ½mu̇², of the velocity relative to the ground, ≥ 0.
    pub kinetic: f64,
    /// Energy stored in the columns, `f_s`²/2k, ≥ 0. For columns that harden after yielding: ½ a k d² + h²/2(1 − a)k, with `f_s` = a k d +
    /// h under a drift d.
    pub strain: f64,
    /// Energy dissipated by viscous damping, ∫ c·u̇² dt.
    pub damping: f64,
    /// Energy dissipated by yielding, ∫ h d`u_p` (h is `f_s` without hardening), ≥ 0.
    pub hysteretic: f64,
    /// Energy dissipated by impulsive impacts. For a floor: the energy that it gave, negative if it was accelerated.
    pub impact: f64,
    /// Energy taken by compliant contact, ∫ F·δ̇ dt, including the energy stored while a pair touches. For a floor: the energy that it
    /// gave, negative if it was accelerated.
    pub contact: f64,
    /// Energy taken by links, ∫ F·δ̇ dt, including the energy stored there. For a floor: the energy that it gave.
    pub link: f64,
}

impl Terms {
    /// Residual of the balance \[J\]: 0 for an exact motion of a building or a row.
    pub fn balance(&self) -> f64 {
        let held = self.kinetic + self.strain;
        let spent = self.damping + self.hysteretic + self.impact + self.contact + self.link;
        held + spent - self.input - self.opening - self.initial
    }

    /// Initial energy plus the magnitudes of the other terms \[J\].
    pub fn magnitude(&self) -> f64 {
        self.all().iter().map(|term| term.abs()).sum()
    }

    /// Largest difference of a term from the same term of `other` \[J\].
    pub fn distance(&self, other: &Self) -> f64 {
        let differences = self.all().into_iter().zip(other.all());
        differences.map(|(one, another)| (one - another).abs()).fold(0.0, f64::max)
    }

    fn all(&self) -> [f64; 10] {
        [
            self.initial,
            self.input,
            self.opening,
            self.kinetic,
            self.strain,
            self.damping,
            self.hysteretic,
            self.impact,
            self.contact,
            self.link,
        ]
    }
}

impl AddAssign for Terms {
    fn add_assign(&mut self, other: Self) {
        self.initial += other.initial;
        self.input += other.input;
        self.opening += other.opening;
        self.kinetic += other.kinetic;
        self.strain += other.strain;
        self.damping += other.damping;
        self.hysteretic += other.hysteretic;
        self.impact += other.impact;
        self.contact += other.contact;
        self.link += other.link;
    }
}
