//! Checks a scene, field by field, before anything is built from it.

mod structure;

use std::fmt::Display;
use std::ops::RangeInclusive;

use pounding_text::{RefusalKind, Refused, digits, plain};

use crate::file::budget::Patience;
use crate::file::{Law, Link, ScaleTo};
use crate::settings::out_of_range;
use crate::{FileUse, Method, RecordUse, Scene, Source, Structure};
use pounding_solver::AnyRow;

/// Refuses a value that is not `valid`. The place becomes text only then, because a sweep checks millions of scenes.
pub(super) fn require(valid: bool, place: impl Display, found: f64, allowed: &'static str) -> Result<(), Refused> {
    let usual = found == 0.0 || USUAL.contains(&found.abs());
    if valid && usual {
        return Ok(());
    }
    Err(out_of_range(place, found, if valid { IN_USUAL } else { allowed }))
}

/// Refuses a scene without structures.
pub(super) fn no_structures() -> Refused {
    Refused::at("structures").found("none").allowed("one or more")
}

/// Magnitudes of the numbers of a scene that are not 0. Within them, products such as a mass times the square of a frequency remain finite,
/// and so do all results.
const USUAL: RangeInclusive<f64> = 1e-100..=1e100;
const IN_USUAL: &str = "0, or numbers from 1e-100 to 1e100 in magnitude";

pub(super) const POSITIVE: &str = "a finite number > 0";
pub(super) const NOT_NEGATIVE: &str = "a finite number >= 0";
const FINITE: &str = "a finite number";

impl Scene {
    /// Refuses the first field that cannot be modelled, in the order of the file.
    ///
    /// # Errors
    /// [`Refused`] with the place of that field.
    pub fn check(&self) -> Result<(), Refused> {
        self.check_within(Patience::ENDLESS)
    }

    /// Refuses the first field that cannot be modelled; gives up at the deadline.
    pub(crate) fn check_within(&self, patience: Patience) -> Result<(), Refused> {
        named("name", &self.name, "a name, for tables and figures")?;
        check_record(&self.record)?;
        if self.structures.is_empty() {
            return Err(no_structures());
        }
        for (index, structure) in self.structures.iter().enumerate() {
            structure::check(index, structure)?;
            patience.look()?;
        }
        if self.neighbour.is_some() {
            let found = Refused::at("neighbour.unknown").found("a neighbour that is not known, which `pounding assess` alone takes");
            return Err(found.help("describe it as the last of `structures` instead"));
        }
        check_budget(self)?;
        if let Some(ratio) = self.collapse_drift_ratio {
            let valid = ratio > 0.0 && ratio <= 1.0;
            require(valid, "collapse_drift_ratio", ratio, "a number > 0 and <= 1")?;
        }
        self.check_method()?;
        check_contacts(self)?;
        for (index, link) in self.links.iter().enumerate() {
            link.check(self).map_err(|refused| refused.inside(&format!("links[{index}]")))?;
        }
        check_arrivals(self)
    }

    /// Refuses a method and a duration that do not fit each other.
    ///
    /// # Errors
    /// [`Refused`] with the place of the field.
    pub fn check_method(&self) -> Result<(), Refused> {
        if let Method::Accuracy(accuracy) = self.method {
            let valid = accuracy > 0.0 && accuracy < 1.0;
            let allowed = "a number > 0 and < 1, such as 0.01 for 1 %";
            require(valid, "method.accuracy", accuracy, allowed)?;
        }
        self.check_links_by_method()?;
        if let Some(duration) = self.duration_s {
            require(duration > 0.0, "duration_s", duration, POSITIVE)?;
        }
        structure::check_tangent_damping(self)?;
        structure::check_friction(self)?;
        let Some(dt) = self.method.time_step() else {
            return Ok(());
        };
        let name = self.method.name();
        let place = format_args!("method.{name}.time_step_s");
        require(dt > 0.0, place, dt, POSITIVE)?;
        match self.duration_s {
            Some(duration) => check_steps(self, dt, duration),
            None => Ok(()),
        }
    }
}

impl Scene {
    /// Refuses a method that does not take the links of the scene.
    fn check_links_by_method(&self) -> Result<(), Refused> {
        if self.links.is_empty() {
            return Ok(());
        }
        let known = !matches!(self.method, Method::Accuracy(_));
        if !known || !self.method.integrator().takes_links() {
            let found = Refused::at("method").found(format!("{}, which does not take `links`", self.method.name()));
            return Err(found
                .allowed("exact, rk4 or central_difference")
                .help("leave `method` out: the exact method is the default"));
        }
        let why = if matches!(self.method, Method::Exact { .. }) {
            "has no series at v = 0, which the exact method needs"
        } else if self.method.integrator().takes_bare_dampers() {
            return Ok(());
        } else {
            "is too steep at v = 0 for central differences"
        };
        let bare = |link: &Link| {
            matches!(
                link.law,
                Law::Viscous {
                    brace_stiffness_n_per_m: None,
                    ..
                }
            )
        };
        match self.links.iter().position(bare) {
            None => Ok(()),
            Some(index) => {
                let place = format!("links[{index}].law.viscous.brace_stiffness_n_per_m");
                let found = Refused::at(place).found(format!("none: a damper c |v|^α alone {why}"));
                Err(found
                    .allowed("a number > 0")
                    .help("give the stiffness of its brace, or take the method rk4"))
            }
        }
    }
}

fn check_arrivals(scene: &Scene) -> Result<(), Refused> {
    let Some(arrivals) = &scene.arrivals_s else {
        return Ok(());
    };
    let n_structures = scene.structures.len();
    if arrivals.len() != n_structures {
        let allowed = format!(
            "{n_structures} (one for each of {n_structures} structures and walls), or no field `arrivals_s` when all are shaken at once"
        );
        return Err(Refused::at("arrivals_s").found(arrivals.len().to_string()).allowed(allowed));
    }
    for (index, &arrival) in arrivals.iter().enumerate() {
        let place = format_args!("arrivals_s[{index}]");
        require(arrival >= 0.0, place, arrival, NOT_NEGATIVE)?;
    }
    Ok(())
}

/// Refuses a name without a letter.
fn named(place: impl Display, name: &str, allowed: &'static str) -> Result<(), Refused> {
    if name.trim().is_empty() {
        let place = place.to_string();
        return Err(Refused::at(place).found("an empty name").allowed_is(allowed));
    }
    Ok(())
}

/// Refuses a time step with which the response of some structure grows without bound, even if nothing touches.
pub(crate) fn free_limit(scene: &Scene) -> Result<(), Refused> {
    let Some(time_step) = scene.method.time_step() else {
        return Ok(());
    };
    match scene.critical_time_step() {
        Some((structure, limit)) if time_step >= limit => {
            let place = format!("method.{}.time_step_s", scene.method.name());
            let name = scene.structures[structure].name();
            let limit = digits(limit);
            let allowed = format!("less than {limit} (structures[{structure}], \"{name}\", grows without bound from there on)");
            let found = Refused::at(place).found(plain(time_step)).allowed(allowed);
            Err(found.help("contact can ask for less").kind(RefusalKind::Unstable))
        }
        _ => Ok(()),
    }
}

/// Refuses a time step with which the response of a row with links grows without bound, even if nothing touches.
pub(crate) fn linked_limit(scene: &Scene, row: &AnyRow) -> Result<(), Refused> {
    let Some(time_step) = scene.method.time_step() else {
        return Ok(());
    };
    match scene.method.integrator().limit_of_links(row, time_step) {
        Some(limit) => {
            let place = format!("method.{}.time_step_s", scene.method.name());
            let allowed = format!(
                "less than {} (with its links the row grows without bound from there on)",
                digits(limit)
            );
            let found = Refused::at(place).found(plain(time_step)).allowed(allowed);
            Err(found.help("contact can ask for less").kind(RefusalKind::Unstable))
        }
        None => Ok(()),
    }
}

/// Largest budget of steps.
const MOST_STEPS: f64 = 1e9;

fn check_steps(scene: &Scene, dt: f64, duration: f64) -> Result<(), Refused> {
    let place = "duration_s";
    let steps = duration / dt;
    let whole = duration > 0.0 && (steps - steps.round()).abs() <= 1e-6;
    let allowed = "a whole number of the method's time_step_s, at least 1";
    require(whole, place, duration, allowed)?;
    let substeps = scene.method.contact_substeps();
    let needed = steps * n_floors(scene) as f64 * f64::from(substeps);
    let allowed = scene.budget.most_steps();
    if needed <= allowed {
        return Ok(());
    }
    let (of_substeps, or_fewer) = match substeps {
        0 | 1 => (String::new(), ""),
        several => (format!(" with {several} sub-steps in contact"), " or fewer contact_substeps"),
    };
    let duration = digits(duration);
    let found = format!("{duration}, of which the run would take {needed:.1e} time steps times floors{of_substeps}");
    let help = format!("shorten it, take a longer time_step_s{or_fewer}, or make the budget more");
    let found = Refused::at(place).found(found).allowed(format!("{allowed:e} (`budget.steps`)"));
    Err(found.so(": ", help).kind(RefusalKind::Together))
}

/// Refuses a budget that allows no work.
fn check_budget(scene: &Scene) -> Result<(), Refused> {
    let budget = &scene.budget;
    if let Some(steps) = budget.steps {
        let valid = steps > 0.0 && steps <= MOST_STEPS;
        let allowed = "a number > 0 and <= 1e9, of which a run remembers each for 8 bytes";
        require(valid, "budget.steps", steps, allowed)?;
    }
    let others = [("budget.pieces", budget.pieces), ("budget.seconds", budget.seconds)];
    for (place, given) in others {
        if let Some(given) = given {
            require(given > 0.0, place, given, POSITIVE)?;
        }
    }
    Ok(())
}

/// Number of floors of all structures; a wall counts as one.
pub(crate) fn n_floors(scene: &Scene) -> usize {
    let floors = |structure: &Structure| match structure {
        Structure::Building(building) => building.storeys.len(),
        Structure::Sdof(_) | Structure::Wall => 1,
    };
    scene.structures.iter().map(floors).sum()
}

fn check_contacts(scene: &Scene) -> Result<(), Refused> {
    let Some(contacts) = &scene.contacts else {
        return Ok(());
    };
    let (n_structures, allowed) = (scene.structures.len(), scene.structures.len() - 1);
    if contacts.len() != allowed {
        let found = Refused::at("contacts").found(format!("{} for {n_structures} structures", contacts.len()));
        return Err(found.allowed(format!(
            "{allowed} (one between each structure and its right neighbour), or no field `contacts` when they stand apart"
        )));
    }
    for (index, contact) in contacts.iter().enumerate() {
        require(
            contact.gap_m >= 0.0,
            format_args!("contacts[{index}].gap_m"),
            contact.gap_m,
            NOT_NEGATIVE,
        )?;
        if let Some(width) = contact.seat_width_m {
            require(width > 0.0, format_args!("contacts[{index}].seat_width_m"), width, POSITIVE)?;
        }
        contact.law.check().map_err(|error| {
            let place = format!("contacts[{index}].law.{}.{}", contact.law.name(), error.parameter);
            out_of_range(place, error.found, error.allowed)
        })?;
    }
    Ok(())
}

/// Refuses the first field of a record that cannot be used, in the order of the file.
pub(crate) fn check_record(record: &RecordUse) -> Result<(), Refused> {
    let gravity = record.gravity_m_per_s2;
    require(gravity > 0.0, "record.gravity_m_per_s2", gravity, POSITIVE)?;
    if let Source::File(file) = &record.source {
        check_pair(file)?;
    }
    if let Some(step) = record.resample_s {
        require(step > 0.0, "record.resample_s", step, POSITIVE)?;
    }
    let is_finite = |target: f64| (target * gravity).is_finite();
    match record.scale_to {
        None => {}
        Some(ScaleTo::PgaG(peak)) => {
            let (valid, allowed) = (peak >= 0.0 && is_finite(peak), "a number >= 0 that is finite in m/s²");
            require(valid, "record.scale_to.pga_g", peak, allowed)?;
        }
        Some(ScaleTo::Sa { sa_g, .. }) => {
            let (valid, allowed) = (sa_g > 0.0 && is_finite(sa_g), "a number > 0 that is finite in m/s²");
            require(valid, "record.scale_to.sa.sa_g", sa_g, allowed)?;
        }
    }
    require(true, "record.scale", record.scale, FINITE)
}

/// Refuses fields of a pair of components that contradict each other.
fn check_pair(file: &FileUse) -> Result<(), Refused> {
    let Some(axis) = file.axis_deg else {
        if file.second_file.is_none() {
            return Ok(());
        }
        let found = Refused::at("record.second_file").found("it without `axis_deg`");
        return Err(found.allowed_is("it beside `axis_deg`").help("name the axis of the row"));
    };
    require((-360.0..=360.0).contains(&axis), "record.axis_deg", axis, "-360 to 360")?;
    if file.component.is_some() {
        let found = Refused::at("record.component").found("it beside `axis_deg`");
        return Err(found
            .allowed_is("one of them")
            .help("delete it: an axis takes both horizontal components"));
    }
    Ok(())
}
