//! Parameters of contact laws: a row says everything that is known of one, for files, messages, sweeps and lists.

/// A parameter of a contact law.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    /// Name, as scene files spell it.
    pub name: &'static str,
    /// Unit, – where it has none.
    pub unit: &'static str,
    /// Its meaning, with its symbol.
    pub meaning: &'static str,
    /// The values allowed.
    pub allowed: Range,
    /// Whether a law that becomes stiffer has more of it, in proportion.
    pub stiffens: bool,
    /// A usual value: that of the pounding literature, where it has one.
    pub usual: f64,
}

/// The values allowed of a number.
#[derive(Debug, Clone, Copy)]
pub struct Range {
    /// In words.
    pub words: &'static str,
    /// Whether a value is one of them.
    pub holds: fn(f64) -> bool,
}

/// A parameter of a contact law outside its valid range.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{parameter}: found {}, allowed {allowed}", pounding_text::plain(*found))]
pub struct ParameterError {
    /// Name of the parameter, as scene files spell it.
    pub parameter: &'static str,
    /// The value found.
    pub found: f64,
    /// The values allowed, in words.
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

    /// Refuses a value of a parameter that is not allowed.
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

/// e \[–\]: the parameter of an impulsive law, and what a compliant one is asked to deliver.
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
/// ξ̄ \[–\] of a damper in parts of the critical one.
pub const RATIO: Parameter = Parameter {
    name: "impact_damping_ratio",
    unit: "–",
    meaning: "damping ratio ξ of the contact",
    allowed: Range::NOT_NEGATIVE,
    stiffens: false,
    usual: 0.35,
};
/// a \[–\] of a damper that knows the approach speed, 1 + aδ̇/v₀.
pub const FACTOR: Parameter = Parameter {
    name: "impact_damping_factor",
    unit: "–",
    meaning: "damping factor a",
    allowed: Range::NOT_NEGATIVE,
    stiffens: false,
    usual: 0.6,
};
