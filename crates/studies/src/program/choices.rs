//! The paper's program, as its numbers show it to have been: a model of somebody's program, and no method to choose.
//!
//! Equations (1) to (4) of the paper leave choices open. [`Program`] names each; [`Program::printed`] gives the printed numbers.

use pounding_motion::Record;
use pounding_solver::Clock;
use strum::EnumCount;

/// The choices of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Program {
    /// How the first step begins.
    pub start: Start,
    /// Whether loads are rounded.
    pub loads: Loads,
    /// Whether the load at the end of the record acts.
    pub last_load: LastLoad,
    /// How long a run lasts.
    pub length: Length,
    /// Which overlaps of impulsive pairs are impacts.
    pub impacts: Impacts,
    /// The velocity of a structure that two pairs hit in one step.
    pub velocities: MiddleVelocity,
    /// The force on it.
    pub forces: MiddleForce,
}

/// How the first step begins; u₋₁ is the displacement one step before t = 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Start {
    /// u₋₁ = u₀ = 0.
    FirstLoadUsed,
    /// u₀ = u₁ = 0; the first equation is that of step 1.
    FirstLoadSkipped,
    /// u₀ = 0 and u₋₁ = Δt² ü₀/2, as textbooks begin.
    Consistent,
}

/// Whether loads are rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Loads {
    /// To five decimals of m/s².
    Rounded,
    /// Not at all.
    AsRecorded,
}

/// Whether the load at the end of the record acts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum LastLoad {
    /// Where steps are those of the record; not where they are shorter.
    OfWholeSteps,
    /// Always.
    Used,
}

/// How long a run lasts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Length {
    /// The loads end, and the run goes on for as long again, until the motion has died out.
    RunsOn,
    /// As long as the loads.
    OfLoads,
}

/// Which overlaps of impulsive pairs are impacts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Impacts {
    /// All, so that a pair that parts is pulled together.
    AnyOverlap,
    /// Those of pairs that approach.
    OnApproach,
}

/// The velocity of a structure that two pairs hit in one step, as the second pair sees it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MiddleVelocity {
    /// That after the impact of the first.
    HandedOn,
    /// That before both.
    BeforeBoth,
}

/// The force on a structure that two pairs touch in one step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum MiddleForce {
    /// That of the second alone: it replaces the other.
    Replaced,
    /// The sum.
    Added,
}

impl Program {
    /// What gives the printed numbers, with one of the two starts.
    pub(crate) const fn printed(start: Start) -> Self {
        Self {
            start,
            loads: Loads::Rounded,
            last_load: LastLoad::OfWholeSteps,
            length: Length::RunsOn,
            impacts: Impacts::AnyOverlap,
            velocities: MiddleVelocity::HandedOn,
            forces: MiddleForce::Replaced,
        }
    }

    /// The method as the paper describes it.
    pub(crate) const DESCRIBED: Self = Self {
        start: Start::Consistent,
        loads: Loads::AsRecorded,
        last_load: LastLoad::Used,
        length: Length::OfLoads,
        impacts: Impacts::OnApproach,
        velocities: MiddleVelocity::BeforeBoth,
        forces: MiddleForce::Added,
    };

    /// The accelerations \[m/s²\] of the steps that are loaded, from t = 0 on: samples of the record, and means of them between.
    pub(crate) fn accelerations(self, record: &Record, clock: Clock) -> Vec<f64> {
        let rounded = |sample: &f64| match self.loads {
            Loads::Rounded => (sample * 1e5).round() / 1e5,
            Loads::AsRecorded => *sample,
        };
        let samples: Vec<f64> = record.samples().iter().map(rounded).collect();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "scenes are refused whose step does not divide their record's"
        )]
        let per_sample = (record.time_step() / clock.time_step).round() as usize;
        let uses_last = per_sample == 1 || self.last_load == LastLoad::Used;
        let n_steps = clock.n_steps + usize::from(uses_last);
        let at = |step: usize| {
            let sample = |index: usize| samples.get(index).copied().unwrap_or(0.0);
            let (index, rest) = (step / per_sample, step % per_sample);
            let part = rest as f64 / per_sample as f64;
            (1.0 - part) * sample(index) + part * sample(index + 1)
        };
        (0..n_steps).map(at).collect()
    }
}

/// A choice, to be taken back.
#[derive(Debug, Clone, Copy, PartialEq, Eq, EnumCount)]
pub(crate) enum Choice {
    Start,
    Loads,
    LastLoad,
    Length,
    Impacts,
    Velocities,
    Forces,
}

impl Choice {
    pub(crate) const ALL: [Self; Self::COUNT] = [
        Self::Start,
        Self::Loads,
        Self::LastLoad,
        Self::Length,
        Self::Impacts,
        Self::Velocities,
        Self::Forces,
    ];

    /// Its name in tables.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Loads => "loads",
            Self::LastLoad => "last_load",
            Self::Length => "length",
            Self::Impacts => "impacts",
            Self::Velocities => "velocities",
            Self::Forces => "forces",
        }
    }

    /// What a program chooses, in words.
    pub(crate) const fn words(self, of: Program) -> &'static str {
        match self {
            Self::Start => match of.start {
                Start::FirstLoadUsed => "first load used",
                Start::FirstLoadSkipped => "first load skipped",
                Start::Consistent => "consistent",
            },
            Self::Loads => match of.loads {
                Loads::Rounded => "rounded",
                Loads::AsRecorded => "as recorded",
            },
            Self::LastLoad => match of.last_load {
                LastLoad::OfWholeSteps => "of whole steps",
                LastLoad::Used => "used",
            },
            Self::Length => match of.length {
                Length::RunsOn => "runs on",
                Length::OfLoads => "of loads",
            },
            Self::Impacts => match of.impacts {
                Impacts::AnyOverlap => "of any overlap",
                Impacts::OnApproach => "on approach",
            },
            Self::Velocities => match of.velocities {
                MiddleVelocity::HandedOn => "handed on",
                MiddleVelocity::BeforeBoth => "before both",
            },
            Self::Forces => match of.forces {
                MiddleForce::Replaced => "replaced",
                MiddleForce::Added => "added",
            },
        }
    }

    /// A program with this choice as the paper describes it.
    pub(crate) const fn taken_back(self, mut program: Program) -> Program {
        let described = Program::DESCRIBED;
        match self {
            Self::Start => program.start = described.start,
            Self::Loads => program.loads = described.loads,
            Self::LastLoad => program.last_load = described.last_load,
            Self::Length => program.length = described.length,
            Self::Impacts => program.impacts = described.impacts,
            Self::Velocities => program.velocities = described.velocities,
            Self::Forces => program.forces = described.forces,
        }
        program
    }
}
