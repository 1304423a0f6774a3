//! A compliant bumper in a gap, and what it changes.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, LinearSpring};

use super::distribution::Distribution;
use super::peaks::{FloorPeaks, peaks};
use super::run::AssessedRun;
use crate::simulation::Extras;
use crate::{Contact, Error, Floors, PairQuantity, Scene, Simulation};

/// Thickness of a bumper as a part of its gap \[–\].
pub const THICKNESS: f64 = 0.5;

/// How far the approach that 84 % of the runs do not exceed may compress a bumper whose stiffness nobody gives, as a part of its
/// thickness \[–\].
pub const COMPRESSION: f64 = 0.6;

/// A bumper at every floor that faces another across a gap: a linear spring that takes part of the gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bumper {
    /// Index of the contact of the scene.
    pub contact: usize,
    /// Stiffness at one floor \[N/m\], > 0.
    pub stiffness: f64,
    /// Thickness \[m\], which the gap loses, > 0.
    pub thickness: f64,
}

/// What a motion does to a row with bumpers.
#[derive(Debug, Clone, PartialEq)]
pub struct BumperRun {
    /// Of every floor.
    pub floors: Vec<FloorPeaks>,
    /// Of every pair.
    pub pairs: Vec<BumperPair>,
}

/// What a motion does to the bumper of a pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BumperPair {
    /// Largest force \[N\]; `None` if nothing touches it.
    pub peak_force: Option<f64>,
    /// Largest compression \[m\]; 0 if nothing touches it.
    pub compression: f64,
}

impl Bumper {
    /// A bumper in every gap that closes in one of the runs: as stiff as given, or the softest that stops the fastest approach of
    /// 84 % of these runs, of two free floors, at [part](COMPRESSION) of its thickness. A gap of nothing has no room for one.
    ///
    /// # Errors
    /// Those of [`Floors::of`].
    pub fn proposed(scene: &Scene, runs: &[&AssessedRun], stiffness: Option<f64>) -> Result<Vec<Self>, Error> {
        let floors = Floors::of(scene).map_err(|source| crate::in_scene(scene, source))?;
        let contacts = scene.contacts.iter().flatten().enumerate();
        let wide = contacts.filter(|(_, contact)| contact.gap_m > 0.0);
        let bumper = |(contact, of): (usize, &Contact)| {
            let thickness = THICKNESS * of.gap_m;
            let pairs = floors.facing().iter().enumerate();
            let own = pairs.filter(|(_, pair)| pair.contact == contact);
            let touching = own.filter(|(pair, _)| runs.iter().any(|run| run.pairs[*pair].collisions > 0));
            let needed = touching.map(|(index, pair)| {
                let speeds = runs.iter().filter_map(|run| run.pairs[index].approach_speed);
                let speed = Distribution::of(speeds).map_or(0.0, |speeds| speeds.p84());
                let inverse = [pair.left, pair.right].map(|side| {
                    let made = floors.all()[side].made_of;
                    made.map_or(0.0, |made| 1.0 / made.mass_kg)
                });
                let ratio = speed / (COMPRESSION * thickness);
                ratio * ratio / (inverse[0] + inverse[1])
            });
            let needed = needed.reduce(f64::max)?;
            let stiffness = stiffness.unwrap_or(needed);
            (stiffness > 0.0).then_some(Self {
                contact,
                stiffness,
                thickness,
            })
        };
        Ok(wide.filter_map(bumper).collect())
    }

    /// The contact law of the bumper in the gap of a contact: with as much restitution, where that has one.
    pub fn law(&self, contact: &Contact) -> ContactLaw {
        let spring = LinearSpring {
            impact_stiffness: self.stiffness,
        };
        let damped = contact.law.restitution().and_then(|restitution| {
            let law = LawName::ModifiedLinearViscoelastic;
            law.calibrated(self.stiffness, restitution, Calibration::Exact, &FreePair::UNIT)
                .ok()
        });
        damped.unwrap_or(ContactLaw::LinearSpring(spring))
    }

    /// A contact with the bumper in its gap.
    fn in_gap(&self, contact: &Contact) -> Contact {
        Contact {
            gap_m: contact.gap_m - self.thickness,
            law: self.law(contact),
            levels: contact.levels.clone(),
        }
    }
}

impl Simulation {
    /// What this motion does to the row with bumpers in its gaps, by the exact method.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early, [`Error::Broken`] if it breaks a law of mechanics.
    pub fn with_bumpers(&self, bumpers: &[Bumper]) -> Result<BumperRun, Error> {
        let mut scene = self.scene().clone();
        let contacts = scene.contacts.iter_mut().flatten().enumerate();
        for (index, contact) in contacts {
            let own = bumpers.iter().find(|bumper| bumper.contact == index);
            if let Some(bumper) = own {
                *contact = bumper.in_gap(contact);
            }
        }
        let simulation = self.variant(&scene, self.record().clone())?.exact()?;
        let run = simulation.run_with(Extras {
            closings: true,
            ..Extras::default()
        })?;
        let pair = |pair: usize| {
            let value = |quantity| run.values(&simulation).of(quantity, pair);
            BumperPair {
                peak_force: value(PairQuantity::PeakForceN),
                compression: value(PairQuantity::LeastOpeningM).map_or(0.0, |least| (-least).max(0.0)),
            }
        };
        Ok(BumperRun {
            floors: peaks(&simulation, &run),
            pairs: (0..simulation.pairs().len()).map(pair).collect(),
        })
    }
}
