//! Settings that a message tells its reader to change, by their names in scenes, in the program and for callers.

use std::borrow::Cow;

/// A setting that a message names: a field of a scene. The program may have an option for it, and callers an argument.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Knob {
    /// Unit of the values of a record.
    Unit,
    /// Time between the samples of a record.
    TimeStep,
    /// The component of a record.
    Component,
    /// Value of one count of the record's digitiser.
    PerCount,
    /// Declares that the values of a record are accelerations.
    Acceleration,
    /// Declares that the values of a record follow each other in rows.
    InRows,
    /// Any field of a scene.
    Field(Cow<'static, str>),
}

/// A set of names for settings in a message.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Naming {
    /// Fields of a scene, such as `record.time_step_s`.
    #[default]
    Scene,
    /// Options of the program, such as `--time-step`.
    Option,
    /// Arguments of Rust and Python, such as `time_step`.
    Argument,
}

/// A setting with all its names.
struct Entry {
    field: &'static str,
    option: &'static str,
    /// Empty if the argument has the name of the field.
    argument: &'static str,
    /// Words that follow the field in a message about a scene: the value of a flag, else empty.
    value: &'static str,
}

const fn entry(field: &'static str, option: &'static str, argument: &'static str, value: &'static str) -> Entry {
    Entry {
        field,
        option,
        argument,
        value,
    }
}

const KNOBS: [Entry; 21] = [
    entry("record.unit", "--unit", "unit", ""),
    entry("record.time_step_s", "--time-step", "time_step", ""),
    entry("record.component", "--component", "component", ""),
    entry("record.per_count", "--per-count", "per_count", ""),
    entry("record.acceleration", "--acceleration", "acceleration", " as true"),
    entry("record.in_rows", "--in-rows", "in_rows", " as true"),
    entry("record.axis_deg", "--axis", "axis", ""),
    entry("record.gravity_m_per_s2", "--gravity", "", ""),
    entry("record.detrend", "--detrend", "", ""),
    entry("record.band_pass", "--band-pass", "", ""),
    entry("record.band_pass.low_hz", "--band-pass LOW", "", ""),
    entry("record.band_pass.high_hz", "--band-pass HIGH", "", ""),
    entry("record.band_pass.order", "--order", "order", ""),
    entry("record.band_pass.causal", "--causal", "causal", ""),
    entry("record.resample_s", "--resample", "", ""),
    entry("record.scale_to.pga_g", "--scale-to-pga", "", ""),
    entry("record.scale_to.sa", "--scale-to-sa", "", ""),
    entry("record.scale_to.sa.period_s", "--scale-to-sa T", "", ""),
    entry("record.scale_to.sa.damping_ratio", "--scale-to-sa Z", "", ""),
    entry("record.scale_to.sa.sa_g", "--scale-to-sa SA", "", ""),
    entry("record.scale", "--scale", "", ""),
];

impl Knob {
    /// A field of a scene.
    pub fn field(path: impl Into<Cow<'static, str>>) -> Self {
        Self::Field(path.into())
    }

    /// Path of the field.
    pub fn path(&self) -> &str {
        match self {
            Self::Unit => "record.unit",
            Self::TimeStep => "record.time_step_s",
            Self::Component => "record.component",
            Self::PerCount => "record.per_count",
            Self::Acceleration => "record.acceleration",
            Self::InRows => "record.in_rows",
            Self::Field(path) => path,
        }
    }

    /// The setting as a message asks for it.
    pub(crate) fn asked(&self, naming: Naming) -> String {
        let name = self.named(naming);
        let value = self.entry().map_or("", |entry| entry.value);
        match naming {
            Naming::Scene => format!("`{name}`{value}"),
            Naming::Option if name.starts_with("--") => name.into(),
            Naming::Option | Naming::Argument => format!("`{name}`"),
        }
    }

    /// The setting as the place of a fault.
    pub(crate) fn named(&self, naming: Naming) -> &str {
        let entry = self.entry();
        let own = entry.map_or("", |entry| match naming {
            Naming::Scene => "",
            Naming::Option => entry.option,
            Naming::Argument => entry.argument,
        });
        if own.is_empty() { self.path() } else { own }
    }

    fn entry(&self) -> Option<&'static Entry> {
        KNOBS.iter().find(|entry| entry.field == self.path())
    }
}
