//! What a scene is pushed along: one change of it, by a number.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, reduced_mass};
use pounding_motion::Record;
use serde::{Deserialize, Serialize};

use pounding_scene::{Damping, Method, Scene, Sdof, Structure, usual_stiffness};

/// A change of a scene of two structures, by a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// Time step over the critical one of the central difference method, 2/ω of the stiffest structure.
    TimeStep,
    /// Mass of the left structure over that of the right one; the periods stay.
    MassRatio,
    /// Period of the left structure over that of the right one; the masses stay.
    PeriodRatio,
    /// Damping ratio of both structures.
    DampingRatio,
    /// Gap \[m\].
    Gap,
    /// Coefficient of restitution, exactly calibrated.
    Restitution,
    /// Number of the contact law in `pounding laws`, from 1 on, exactly calibrated to 0.65, springs without damping as they
    /// are; with the usual impact stiffness.
    Law,
    /// Factor on the impact stiffness of the nonlinear viscoelastic element, with its own damping ratio.
    ImpactStiffness,
    /// Factor on the yield forces.
    YieldForce,
    /// Factor on the record.
    RecordScale,
    /// Ground acceleration of one sample, at a fifth of the run \[m/s²\].
    Spike,
    /// Ground acceleration that is added from a fifth of the run on \[m/s²\].
    Step,
    /// Number of time steps, without damping.
    LongRun,
    /// Gap \[m\] between two structures like the left one.
    IdenticalNeighbours,
    /// Number of structures, left and right ones in turn.
    Row,
    /// Number of structures like the left one without gaps; the first moves towards them at 0.5 m/s, nothing shakes.
    Cradle,
}

/// A scene with its record, on its way to the edge.
#[derive(Debug, Clone)]
pub(crate) struct Pushed {
    pub(crate) scene: Scene,
    pub(crate) record: Record,
    /// Time step of the methods \[s\].
    pub(crate) time_step: f64,
}

/// Approach speed at which a restitution is calibrated, of laws that need one \[m/s\].
const SPEED: f64 = 0.3;

impl Axis {
    /// Name in tables.
    pub(crate) fn key(self) -> &'static str {
        match self {
            Self::TimeStep => "time_step_over_critical",
            Self::MassRatio => "mass_ratio",
            Self::PeriodRatio => "period_ratio",
            Self::DampingRatio => "damping_ratio",
            Self::Gap => "gap_m",
            Self::Restitution => "restitution",
            Self::Law => "law",
            Self::ImpactStiffness => "impact_stiffness_factor",
            Self::YieldForce => "yield_force_factor",
            Self::RecordScale => "record_scale",
            Self::Spike => "spike_m_per_s2",
            Self::Step => "step_m_per_s2",
            Self::LongRun => "undamped_steps",
            Self::IdenticalNeighbours => "gap_of_identical_neighbours_m",
            Self::Row => "structures_in_a_row",
            Self::Cradle => "structures_all_touching",
        }
    }

    /// Label in figures.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::TimeStep => "Time step / (2/ω)",
            Self::MassRatio => "Mass ratio",
            Self::PeriodRatio => "Period ratio",
            Self::DampingRatio => "Damping ratio",
            Self::Gap => "Gap (m)",
            Self::Restitution => "Coefficient of restitution",
            Self::Law => "Contact law",
            Self::ImpactStiffness => "Impact stiffness, times",
            Self::YieldForce => "Yield forces, times",
            Self::RecordScale => "Record, times",
            Self::Spike => "Spike (m/s²)",
            Self::Step => "Step (m/s²)",
            Self::LongRun => "Undamped steps",
            Self::IdenticalNeighbours => "Gap of identical neighbours (m)",
            Self::Row => "Structures in a row",
            Self::Cradle => "Structures, all touching",
        }
    }

    /// Changes a scene.
    ///
    /// # Errors
    /// What cannot be changed so, in words.
    pub(crate) fn push(self, pushed: &mut Pushed, value: f64) -> Result<(), String> {
        if sdof(&pushed.scene, 1).is_none() || pushed.scene.contacts.iter().flatten().count() == 0 {
            return Err(format!("{}, of a scene without two structures and a contact", self.key()));
        }
        match self {
            Self::Row | Self::Cradle if value < 2.0 => {
                return Err(format!("{value} {}, allowed 2 or more", self.key()));
            }
            Self::YieldForce if sdof(&pushed.scene, 0).is_some_and(|one| one.yield_force_n.is_none()) => {
                return Err(format!("{}, of elastic structures", self.key()));
            }
            Self::RecordScale => pushed.scale(value)?,
            Self::Spike => {
                pushed.shake(|index, at, sample| if index == at { value } else { sample })?;
            }
            Self::Step => {
                pushed.shake(|index, at, sample| if index < at { sample } else { sample + value })?;
            }
            Self::Restitution => calibrate(&mut pushed.scene, value)?,
            Self::Law => replace_law(&mut pushed.scene, value)?,
            Self::ImpactStiffness => stiffen(&mut pushed.scene, value)?,
            Self::LongRun => {
                Self::DampingRatio.change(&mut pushed.scene, 0.0);
                pushed.scene.duration_s = Some(value * pushed.time_step);
            }
            Self::Cradle => {
                Self::Cradle.change(&mut pushed.scene, value);
                pushed.scale(0.0)?;
            }
            Self::TimeStep => {
                let fastest = pushed.scene.structures.iter().filter_map(Structure::fastest);
                let critical = fastest.map(|one| 2.0 / one.angular_frequency);
                pushed.time_step = value * critical.fold(f64::INFINITY, f64::min);
            }
            Self::MassRatio
            | Self::PeriodRatio
            | Self::DampingRatio
            | Self::Gap
            | Self::YieldForce
            | Self::IdenticalNeighbours
            | Self::Row => self.change(&mut pushed.scene, value),
        }
        Ok(())
    }

    /// The changes that concern structures and contacts alone.
    fn change(self, scene: &mut Scene, value: f64) {
        match self {
            Self::MassRatio => {
                let right = right(scene).map_or(1.0, |sdof| sdof.mass_kg);
                first(scene, |left| {
                    let factor = value * right / left.mass_kg;
                    left.mass_kg *= factor;
                    left.stiffness_n_per_m *= factor;
                });
            }
            Self::PeriodRatio => {
                let right = right(scene).map_or(1.0, Sdof::period);
                first(scene, |left| {
                    let factor = left.period() / (value * right);
                    left.stiffness_n_per_m *= factor * factor;
                });
            }
            Self::DampingRatio => each(scene, |sdof| sdof.damping = Damping::Ratio(value)),
            Self::Gap => gaps(scene, value),
            Self::YieldForce => each(scene, |sdof| {
                sdof.yield_force_n = sdof.yield_force_n.map(|force| value * force);
            }),
            Self::IdenticalNeighbours => {
                scene.structures[1] = scene.structures[0].clone();
                gaps(scene, value);
            }
            Self::Row => row(scene, value, |index| index % 2),
            Self::Cradle => {
                row(scene, value, |_| 0);
                gaps(scene, 0.0);
                first(scene, |left| left.initial_velocity_m_per_s = 0.5);
            }
            Self::TimeStep
            | Self::Restitution
            | Self::Law
            | Self::ImpactStiffness
            | Self::RecordScale
            | Self::Spike
            | Self::Step
            | Self::LongRun => {}
        }
    }
}

impl Pushed {
    /// A scene with a record, before any change.
    pub(crate) fn new(scene: &Scene, record: &Record, time_step: f64) -> Self {
        Self {
            scene: scene.clone(),
            record: record.clone(),
            time_step,
        }
    }

    /// Makes the duration a whole number of time steps, as a user has to.
    pub(crate) fn rounded(mut self) -> Self {
        let n_steps = (self.scene.duration() / self.time_step).round().max(1.0);
        self.scene.duration_s = Some(n_steps * self.time_step);
        self.scene.method = Method::EXACT;
        self
    }

    /// Changes samples, given their index and that of a fifth of the run.
    fn shake(&mut self, change: impl Fn(usize, usize, f64) -> f64) -> Result<(), String> {
        let step = self.record.time_step();
        let fifth = 0.2 * self.scene.duration();
        let at = (0..self.record.samples().len())
            .find(|index| *index as f64 * step >= fifth)
            .unwrap_or(0);
        let samples = self.record.samples().iter().enumerate();
        let samples = samples.map(|(index, sample)| change(index, at, *sample));
        self.record = Record::new(step, samples.collect(), self.record.source()).map_err(|error| error.to_string())?;
        Ok(())
    }

    fn scale(&mut self, factor: f64) -> Result<(), String> {
        let scaled = self.record.scaled(factor);
        self.record = scaled.map_err(|error| error.to_string())?;
        Ok(())
    }
}

fn right(scene: &Scene) -> Option<&Sdof> {
    sdof(scene, 1)
}

fn sdof(scene: &Scene, index: usize) -> Option<&Sdof> {
    match scene.structures.get(index) {
        Some(Structure::Sdof(sdof)) => Some(sdof),
        Some(Structure::Building(_) | Structure::Wall) | None => None,
    }
}

fn each(scene: &mut Scene, change: impl Fn(&mut Sdof)) {
    for structure in &mut scene.structures {
        if let Structure::Sdof(sdof) = structure {
            change(sdof);
        }
    }
}

fn first(scene: &mut Scene, change: impl FnOnce(&mut Sdof)) {
    if let Some(Structure::Sdof(sdof)) = scene.structures.first_mut() {
        change(sdof);
    }
}

fn gaps(scene: &mut Scene, gap: f64) {
    for contact in scene.contacts.iter_mut().flatten() {
        contact.gap_m = gap;
    }
}

/// A row of so many structures, each a copy of one of the two.
fn row(scene: &mut Scene, n: f64, which: impl Fn(usize) -> usize) {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small whole number")]
    let n = n as usize;
    let two = scene.structures.clone();
    scene.structures = (0..n).map(|index| two[which(index)].clone()).collect();
    if let Some(contacts) = &mut scene.contacts {
        *contacts = vec![contacts[0].clone(); n - 1];
    }
}

/// Gives the contacts another restitution.
fn calibrate(scene: &mut Scene, restitution: f64) -> Result<(), String> {
    let pair = pair(scene);
    for contact in scene.contacts.iter_mut().flatten() {
        let name = LawName::from_name(contact.law.name()).ok_or_else(|| format!("no law named {}", contact.law.name()))?;
        let form = contact.law.form(pair.reduced_mass, SPEED);
        let stiffness = form.map_or(1.0, |form| form.spring.coefficient);
        contact.law = name
            .calibrated(stiffness, (restitution, Calibration::Exact), &pair)
            .map_err(|error| error.to_string())?;
    }
    Ok(())
}

/// Multiplies the impact stiffness of the nonlinear viscoelastic element.
fn stiffen(scene: &mut Scene, factor: f64) -> Result<(), String> {
    for contact in scene.contacts.iter_mut().flatten() {
        let ContactLaw::NonlinearViscoelastic(law) = &mut contact.law else {
            return Err(format!("impact stiffness of {}", contact.law.name()));
        };
        law.impact_stiffness *= factor;
    }
    Ok(())
}

/// Puts another law between the structures.
fn replace_law(scene: &mut Scene, number: f64) -> Result<(), String> {
    let law = LawName::ALL.into_iter().zip(1_u32..).find(|(_, other)| f64::from(*other) >= number);
    let (name, _) = law.ok_or_else(|| format!("law number {number}"))?;
    let stiffness = usual_stiffness(name);
    let restitution = if name.is_elastic() { 1.0 } else { 0.65 };
    let pair = pair(scene);
    let asked = (restitution, Calibration::Exact);
    let law = name.calibrated(stiffness, asked, &pair);
    let law = law.map_err(|error| error.to_string())?;
    for contact in scene.contacts.iter_mut().flatten() {
        contact.law = law;
    }
    Ok(())
}

/// The first two structures as a free pair.
fn pair(scene: &Scene) -> FreePair {
    let inverse = |index| sdof(scene, index).map_or(0.0, |sdof| 1.0 / sdof.mass_kg);
    FreePair {
        reduced_mass: reduced_mass(inverse(0), inverse(1)),
        approach_speed: SPEED,
    }
}
