//! Axes of the extremes: each changes a scene by one number.

use super::laws::free_pair;
use crate::listed::listed;
use pounding_contact::{Calibration, ContactLaw, LawName};
use pounding_motion::Record;
use serde::{Deserialize, Serialize};

use pounding_scene::{Certificate, Damping, Method, Scene, Sdof, Structure};

listed! {
    /// A change of a scene of two structures by one number. The texts are its names in tables and in figures.
    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "snake_case")]
    pub enum Axis { texts: (&'static str, &'static str);
        /// Time step over the critical time step of the central difference method, 2/ω of the stiffest structure \[–\].
        TimeStep = ("time_step_over_critical", "Time step / (2/ω)"),
        /// Mass of the left structure over mass of the right one; the periods stay.
        MassRatio = ("mass_ratio", "Mass ratio"),
        /// Period of the left structure over period of the right one; the masses stay.
        PeriodRatio = ("period_ratio", "Period ratio"),
        /// Damping ratio of both structures.
        DampingRatio = ("damping_ratio", "Damping ratio"),
        /// Gap \[m\].
        Gap = ("gap_m", "Gap (m)"),
        /// Coefficient of restitution, exactly calibrated.
        Restitution = ("restitution", "Coefficient of restitution"),
        /// Number of the contact law in `pounding laws`, counted from 1, with the usual impact stiffness. The law is exactly calibrated to
        /// 0.65; a spring without damping is not calibrated.
        Law = ("law", "Contact law"),
        /// Factor on the impact stiffness of the nonlinear viscoelastic element, with its own damping ratio.
        ImpactStiffness = ("impact_stiffness_factor", "Impact stiffness, times"),
        /// Factor on the yield forces.
        YieldForce = ("yield_force_factor", "Yield forces, times"),
        /// Factor on the record.
        RecordScale = ("record_scale", "Record, times"),
        /// Ground acceleration of one sample, at a fifth of the run \[m/s²\].
        Spike = ("spike_m_per_s2", "Spike (m/s²)"),
        /// Ground acceleration added to all samples after a fifth of the run \[m/s²\].
        Step = ("step_m_per_s2", "Step (m/s²)"),
        /// Number of time steps; the structures have no damping.
        LongRun = ("undamped_steps", "Undamped steps"),
        /// Gap \[m\] between two structures like the left one.
        IdenticalNeighbours = ("gap_of_identical_neighbours_m", "Gap of identical neighbours (m)"),
        /// Number of structures, alternately left and right ones.
        Row = ("structures_in_a_row", "Structures in a row"),
        /// Number of structures like the left one, without gaps and without shaking. The first one moves towards the others at 0.5 m/s.
        Cradle = ("structures_all_touching", "Structures, all touching"),
    }
}

/// A scene with its record while changes are made.
#[derive(Debug, Clone)]
pub(crate) struct Pushed {
    pub(crate) scene: Scene,
    pub(crate) record: Record,
    /// Time step of the methods \[s\].
    pub(crate) time_step: f64,
}

/// Approach speed for the calibration of laws that need one \[m/s\].
const SPEED: f64 = 0.3;

impl Axis {
    /// Name in tables.
    pub(crate) fn key(self) -> &'static str {
        self.texts().0
    }

    /// Changes a scene.
    ///
    /// # Errors
    /// A message that names the change and the value that the scene does not allow.
    pub(crate) fn push(self, pushed: &mut Pushed, value: f64) -> Result<(), String> {
        let scene = &mut pushed.scene;
        let contacts = scene.contacts.iter().flatten().count();
        let (Some(left), Some(right), 1..) = (sdof(scene, 0).cloned(), sdof(scene, 1).cloned(), contacts) else {
            return Err(format!("{}, of a scene without two structures and a contact", self.key()));
        };
        match self {
            Self::Row | Self::Cradle if value < 2.0 => return Err(format!("{value} {}, allowed 2 or more", self.key())),
            Self::YieldForce if left.yield_force_n.is_none() => return Err(format!("{}, of elastic structures", self.key())),
            Self::TimeStep => {
                let fastest = scene.structures.iter().filter_map(Structure::fastest);
                let critical = fastest.map(|one| 2.0 / one.angular_frequency);
                pushed.time_step = value * critical.fold(f64::INFINITY, f64::min);
            }
            Self::MassRatio => first(scene, |left| {
                let factor = value * right.mass_kg / left.mass_kg;
                left.mass_kg *= factor;
                left.stiffness_n_per_m *= factor;
            }),
            Self::PeriodRatio => first(scene, |left| {
                let factor = left.period() / (value * right.period());
                left.stiffness_n_per_m *= factor * factor;
            }),
            Self::DampingRatio => each(scene, |sdof| sdof.damping = Damping::Ratio(value)),
            Self::Gap => gaps(scene, value),
            Self::Restitution => calibrate(scene, value)?,
            Self::Law => replace_law(scene, value)?,
            Self::ImpactStiffness => stiffen(scene, value)?,
            Self::YieldForce => each(scene, |sdof| sdof.yield_force_n = sdof.yield_force_n.map(|force| value * force)),
            Self::RecordScale => pushed.scale(value)?,
            Self::Spike => pushed.shake(|index, at, sample| if index == at { value } else { sample })?,
            Self::Step => pushed.shake(|index, at, sample| if index < at { sample } else { sample + value })?,
            Self::LongRun => {
                each(scene, |sdof| sdof.damping = Damping::Ratio(0.0));
                scene.duration_s = Some(value * pushed.time_step);
            }
            Self::IdenticalNeighbours => {
                scene.structures[1] = scene.structures[0].clone();
                gaps(scene, value);
            }
            Self::Row => row(scene, value, |index| index % 2),
            Self::Cradle => {
                row(scene, value, |_| 0);
                gaps(scene, 0.0);
                first(scene, |left| left.initial_velocity_m_per_s = 0.5);
                pushed.scale(0.0)?;
            }
        }
        Ok(())
    }
}

impl Pushed {
    /// A scene with its record, unchanged.
    pub(crate) fn new(scene: &Scene, record: &Record, time_step: f64) -> Self {
        Self {
            scene: scene.clone(),
            record: record.clone(),
            time_step,
        }
    }

    /// Rounds the duration to a whole number of time steps, as a user must.
    pub(crate) fn rounded(mut self) -> Self {
        let n_steps = (self.scene.duration() / self.time_step).round().max(1.0);
        self.scene.duration_s = Some(n_steps * self.time_step);
        self.scene.method = Method::EXACT;
        self
    }

    /// Changes every sample by a function of its index, of the index at a fifth of the run, and of its value.
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

/// Makes a row of `n` structures; `which` chooses one of the two originals for each.
fn row(scene: &mut Scene, n: f64, which: impl Fn(usize) -> usize) {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a small whole number")]
    let n = n as usize;
    let two = scene.structures.clone();
    scene.structures = (0..n).map(|index| two[which(index)].clone()).collect();
    if let Some(contacts) = &mut scene.contacts {
        *contacts = vec![contacts[0].clone(); n - 1];
    }
}

/// Calibrates the contacts to another restitution.
fn calibrate(scene: &mut Scene, restitution: f64) -> Result<(), String> {
    let pair = free_pair(&scene.structures, SPEED);
    for contact in scene.contacts.iter_mut().flatten() {
        let name = LawName::from_name(contact.law.name()).ok_or_else(|| format!("no law named {}", contact.law.name()))?;
        let form = contact.law.form(pair.reduced_mass, SPEED);
        let stiffness = form.map_or(1.0, |form| form.spring.coefficient);
        contact.law = name
            .calibrated(stiffness, restitution, Calibration::Exact, &pair)
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

/// Replaces the contact law by another.
fn replace_law(scene: &mut Scene, number: f64) -> Result<(), String> {
    let law = LawName::ALL.into_iter().zip(1_u32..).find(|(_, other)| f64::from(*other) >= number);
    let (name, _) = law.ok_or_else(|| format!("law number {number}"))?;
    let stiffness = Certificate::usual_stiffness(name);
    let restitution = if name.is_elastic() { 1.0 } else { 0.65 };
    let pair = free_pair(&scene.structures, SPEED);
    let law = name.calibrated(stiffness, restitution, Calibration::Exact, &pair);
    let law = law.map_err(|error| error.to_string())?;
    for contact in scene.contacts.iter_mut().flatten() {
        contact.law = law;
    }
    Ok(())
}
