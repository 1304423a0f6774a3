//! Parameters of contact laws. Files, messages, sweeps and lists read these entries.

/// A parameter of a contact law.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    /// Name in scene files.
    pub name: &'static str,
    /// Unit; – if it has none.
    pub unit: &'static str,
    /// Meaning, with symbol.
    pub meaning: &'static str,
    /// Allowed values.
    pub allowed: Range,
    /// Whether the parameter grows in proportion to the stiffness of a law that becomes stiffer.
    pub stiffens: bool,
    /// A usual value, from the pounding literature if it has one.
    pub usual: f64,
}

/// The allowed values of a number.
#[derive(Debug, Clone, Copy)]
pub struct Range {
    /// The allowed values in words.
    pub words: &'static str,
    /// Whether a value is allowed.
    pub holds: fn(f64) -> bool,
}

/// A parameter of a contact law outside its valid range.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{parameter}: found {}, allowed {allowed}", pounding_text::plain(*found))]
pub struct ParameterError {
    /// Name of the parameter in scene files.
    pub parameter: &'static str,
    /// The value found.
    pub found: f64,
    /// The allowed values, in words.
    pub allowed: &'static str,
}

impl Range {
    /// Finite and more than 0.
    pub const POSITIVE: Self = Self {
        words: "a finite number > 0",
        holds: |number| number > 0.0 && number.is_finite(),
    };
    /// Finite and not below 0.
    pub const NOT_NEGATIVE: Self = Self {
        words: "a finite number >= 0",
        holds: |number| number >= 0.0 && number.is_finite(),
    };

    /// Refuses a value that is not allowed.
    pub(crate) fn check(self, parameter: &'static str, found: f64) -> Result<(), ParameterError> {
        if (self.holds)(found) {
            return Ok(());
        }
        Err(ParameterError {
            parameter,
            found,
            allowed: self.words,
        })
    }
}

/// e \[–\]: the parameter of an impulsive law, and the target of the calibration of a compliant law.
pub const RESTITUTION: Parameter = Parameter {
    name: "restitution",
    unit: "–",
    meaning: "coefficient of restitution e",
    allowed: Range {
        words: "0 to 1",
        holds: |e| (0.0..=1.0).contains(&e),
    },
    stiffens: false,
    usual: 0.65,
};
/// k \[N/m\] of a linear spring.
pub const LINEAR: Parameter = Parameter {
    name: "impact_stiffness_n_per_m",
    unit: "N/m",
    meaning: "stiffness k of a linear spring",
    allowed: Range::POSITIVE,
    stiffens: true,
    usual: 9.35e7,
};
/// β̄ \[N/m^1.5\] of a Hertz spring.
pub const HERTZ: Parameter = Parameter {
    name: "impact_stiffness_n_per_m1_5",
    unit: "N/m^1.5",
    meaning: "stiffness β̄ of a Hertz spring",
    allowed: Range::POSITIVE,
    stiffens: true,
    usual: 2.75e9,
};
/// ξ̄ \[–\] of a damper, as a part of critical damping.
pub const RATIO: Parameter = Parameter {
    name: "impact_damping_ratio",
    unit: "–",
    meaning: "damping ratio ξ of the contact",
    allowed: Range::NOT_NEGATIVE,
    stiffens: false,
    usual: 0.35,
};
/// a \[–\] of a damper that depends on the approach speed, 1 + aδ̇/v₀.
pub const FACTOR: Parameter = Parameter {
    name: "impact_damping_factor",
    unit: "–",
    meaning: "damping factor a",
    allowed: Range::NOT_NEGATIVE,
    stiffens: false,
    usual: 0.6,
};
