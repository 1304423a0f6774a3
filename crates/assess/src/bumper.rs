//! A compliant bumper in a gap, and its effect.

use pounding_contact::{Calibration, ContactLaw, FreePair, LawName, LinearSpring};
use pounding_scene::{Contact, Error, Extras, Floors, PairQuantity, Scene, Simulation};

use crate::peaks::FloorPeaks;
use crate::run::AssessedRun;

/// A bumper at every floor that faces another floor across a gap: a linear spring that fills part of the gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bumper {
    /// Index of the contact of the scene.
    pub contact: usize,
    /// Stiffness at one floor \[N/m\], > 0.
    pub stiffness: f64,
    /// Thickness \[m\], > 0; the gap is narrower by this much.
    pub thickness: f64,
}

/// Response of a row with bumpers to a motion.
#[derive(Debug, Clone, PartialEq)]
pub struct BumperRun {
    /// Peaks of every floor.
    pub floors: Vec<FloorPeaks>,
    /// Bumper of every pair.
    pub pairs: Vec<BumperPair>,
}

/// Response of the bumper of a pair to a motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BumperPair {
    /// Largest force \[N\]; `None` if nothing touches the bumper.
    pub peak_force: Option<f64>,
    /// Largest compression \[m\]; 0 if nothing touches the bumper.
    pub compression: f64,
}

impl Bumper {
    /// Thickness of a bumper as a part of its gap \[–\].
    pub const THICKNESS: f64 = 0.5;

    /// Part of its thickness \[–\] by which a bumper may be compressed at the largest approach speed of all runs, if its stiffness is not
    /// given.
    pub const COMPRESSION: f64 = 0.6;

    /// Stiffnesses that are tried if none is given, as multiples of the [softest one](Self::proposed): the buildings behind two floors may
    /// push them farther together than two free floors.
    pub const TRIED: [f64; 5] = [1.0, 2.0, 4.0, 8.0, 16.0];

    /// Proposes a bumper for every gap that closes in one of the runs. If no stiffness is given, the bumper is the softest one that stops
    /// two free floors within [`Self::COMPRESSION`] of its thickness, at the largest approach speed of these runs. A gap of zero has no room
    /// for a bumper.
    ///
    /// # Errors
    /// Errors of [`Floors::of`].
    pub fn proposed(scene: &Scene, runs: &[&AssessedRun], stiffness: Option<f64>) -> Result<Vec<Self>, Error> {
        let floors = Floors::of(scene).map_err(|refused| Error::in_scene(&scene.name, refused))?;
        let contacts = scene.contacts.iter().flatten().enumerate();
        let wide = contacts.filter(|(_, contact)| contact.gap_m > 0.0);
        let bumper = |(contact, of): (usize, &Contact)| {
            let thickness = Self::THICKNESS * of.gap_m;
            let pairs = floors.facing().iter().enumerate();
            let own = pairs.filter(|(_, pair)| pair.contact == contact);
            let touching = own.filter(|(pair, _)| runs.iter().any(|run| run.pairs[*pair].collisions > 0));
            let needed = touching.map(|(index, pair)| {
                let speeds = runs.iter().filter_map(|run| run.pairs[index].approach_speed);
                let speed = speeds.fold(0.0, f64::max);
                let inverse = [pair.left, pair.right].map(|side| {
                    let made = floors.all()[side].made_of;
                    made.map_or(0.0, |made| 1.0 / made.mass_kg)
                });
                let ratio = speed / (Self::COMPRESSION * thickness);
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

    /// The bumper with its stiffness multiplied by a factor.
    #[must_use]
    pub fn stiffened(self, factor: f64) -> Self {
        Self {
            stiffness: factor * self.stiffness,
            ..self
        }
    }

    /// Contact law of the bumper in a gap. It has the restitution of the contact's law, if that law has one.
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
            ..contact.clone()
        }
    }
}

impl BumperRun {
    /// Runs the row of a simulation with bumpers in its gaps, by the exact method.
    ///
    /// # Errors
    /// [`Error::Run`] if the run ends early, [`Error::Broken`] if it breaks a law of mechanics.
    pub fn of(simulation: &Simulation, bumpers: &[Bumper]) -> Result<Self, Error> {
        let mut scene = simulation.scene().clone();
        let contacts = scene.contacts.iter_mut().flatten().enumerate();
        for (index, contact) in contacts {
            let own = bumpers.iter().find(|bumper| bumper.contact == index);
            if let Some(bumper) = own {
                *contact = bumper.in_gap(contact);
            }
        }
        let padded = simulation.variant(&scene, simulation.record().clone())?.exact()?;
        let run = padded.run_with(Extras {
            closings: true,
            ..Extras::default()
        })?;
        let pair = |pair: usize| {
            let value = |quantity| run.values(&padded).of(quantity, pair);
            BumperPair {
                peak_force: value(PairQuantity::PeakForceN),
                compression: value(PairQuantity::LeastOpeningM).map_or(0.0, |least| (-least).max(0.0)),
            }
        };
        Ok(Self {
            floors: FloorPeaks::all(&padded, &run),
            pairs: (0..padded.pairs().len()).map(pair).collect(),
        })
    }
}
