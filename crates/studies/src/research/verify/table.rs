//! Results of a campaign in numbers.

use std::collections::BTreeMap;
use std::fmt::{self, Formatter};

use super::check::{Checked, Disagreement, Failure, RESIDUAL, Verdict};
use super::class::Class;
use super::compared::{Compared, NumberPlace};
use pounding_text::{Cell, Table};

/// A failure that the documentation of limits describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KnownLimit {
    /// Name of the kind of error.
    pub kind: &'static str,
    /// The limit that the failure meets.
    pub why: &'static str,
}

/// Documented failures; any other failure is a fault.
pub const LIMITS: [KnownLimit; 4] = [
    limit(
        "ClosedIn",
        "a row between walls on grounds that travel towards each other has no room: there is no such motion",
    ),
    limit(
        "BouncesWithoutEnd",
        "with e = 1 neighbours that press against each other bounce for ever",
    ),
    limit(
        "NoSeries",
        "compliant neighbours without a gap that begin to press through a contact that begins at the same instant",
    ),
    limit(
        "CrawlsInContact",
        "a damper that grows with 1/v₀ holds neighbours that touched slowly and press against each other",
    ),
];

const fn limit(kind: &'static str, why: &'static str) -> KnownLimit {
    KnownLimit { kind, why }
}

/// Smallest number of scenes of which most must agree.
const MANY: usize = 20;

/// The results of a campaign.
#[derive(Debug)]
pub struct Summary<'a>(pub &'a [Checked]);

impl Checked {
    /// Whether the result is consistent with a correct exact method. It is if both routes agree, if rounding explains their distance, if
    /// the second route has no answer, or if the exact method fails in a [documented](LIMITS) way.
    pub fn is_good(&self) -> bool {
        use Verdict::{Disagrees, ExactFails, Hangs, Panics, Refused};
        ![Disagrees, ExactFails, Refused, Hangs, Panics].contains(&self.verdict)
    }

    /// The shared property by which scenes that do not agree are sorted.
    pub fn cause(&self) -> String {
        let worst = self.disagreements.first();
        match &self.failure {
            Some(failure) => failure.kind.clone(),
            None => worst.map_or(String::new(), |one| one.two.what.words().into()),
        }
    }

    /// The result of the scene, one line for each fault.
    pub fn lines(&self) -> Vec<String> {
        let line = |words: String| format!("scene {}: {}: {words}", self.index, self.verdict.words());
        match &self.failure {
            Some(Failure { kind, message }) if message.is_empty() => vec![line(kind.clone())],
            Some(Failure { kind, message }) => vec![line(format!("{kind}: {message}"))],
            None if self.verdict == Verdict::Agrees => Vec::new(),
            None => {
                let numbers = self.disagreements.iter().map(|one| line(one.to_string()));
                numbers.chain(self.story.iter().cloned()).collect()
            }
        }
    }
}

impl Failure {
    /// Whether the failure is documented.
    pub fn is_known(&self) -> bool {
        LIMITS.iter().any(|limit| limit.kind == self.kind)
    }
}

impl fmt::Display for Disagreement {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let two = &self.two;
        let place = match two.place {
            NumberPlace::Floor(floor) => format!(" of floor {floor}"),
            NumberPlace::Touch { pair, touch } => format!(" {touch} of pair {pair}"),
            NumberPlace::Pair(pair) => format!(" of pair {pair}"),
            NumberPlace::Link(link) => format!(" {link}"),
            NumberPlace::Run => String::new(),
        };
        let what = two.what.words();
        write!(
            out,
            "{what}{place}: {:e} and {:e}, {:.1e} apart, allowed {:.1e}, with what the exact run rounds {:.1e}, the second route from itself {:.1e}",
            two.first, two.second, two.distance, self.allowed, self.explained, self.own
        )
    }
}

impl Summary<'_> {
    /// Whether all scenes are [consistent](Checked::is_good) with a correct exact method.
    ///
    /// In a large campaign most scenes must agree too: a second route that never has an answer proves nothing.
    pub fn is_good(&self) -> bool {
        let agree = self.count(Verdict::Agrees, None);
        self.0.iter().all(Checked::is_good) && (self.0.len() < MANY || 2 * agree > self.0.len())
    }

    fn count(&self, verdict: Verdict, class: Option<Class>) -> usize {
        let has = |checked: &&Checked| class.is_none_or(|class| checked.classes.contains(&class)) && checked.verdict == verdict;
        self.0.iter().filter(has).count()
    }

    fn write_verdicts(&self, out: &mut Formatter<'_>) -> fmt::Result {
        writeln!(out, "{} scenes", self.0.len())?;
        for verdict in Verdict::ALL {
            let own = self.0.iter().filter(|checked| checked.verdict == verdict);
            let mut causes: BTreeMap<String, usize> = BTreeMap::new();
            for checked in own.clone() {
                *causes.entry(checked.cause()).or_default() += 1;
            }
            causes.remove("");
            let causes: Vec<_> = causes.iter().map(|(cause, count)| format!("{cause} {count}")).collect();
            let count = own.count();
            if count > 0 {
                writeln!(out, "  {:<16} {count:>6}  {}", verdict.words(), causes.join(", "))?;
            }
        }
        Ok(())
    }

    fn write_classes(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let seen = Verdict::ALL.into_iter().filter(|verdict| self.count(*verdict, None) > 0);
        let seen: Vec<_> = seen.collect();
        write!(out, "\n{:<24} {:>6}", "scenes with", "all")?;
        for verdict in &seen {
            write!(out, " {:>15}", verdict.words())?;
        }
        writeln!(out)?;
        for class in Class::ALL {
            let counts: Vec<_> = seen.iter().map(|verdict| self.count(*verdict, Some(class))).collect();
            let all: usize = counts.iter().sum();
            write!(out, "{:<24} {all:>6}", class.words())?;
            for count in counts {
                write!(out, " {count:>15}")?;
            }
            writeln!(out)?;
        }
        Ok(())
    }

    fn write_largest(&self, out: &mut Formatter<'_>) -> fmt::Result {
        writeln!(out, "\nlargest distance that is allowed, of what both routes ran")?;
        for (place, what) in Compared::ALL.into_iter().enumerate() {
            if matches!(what, Compared::Touches | Compared::Residual) {
                continue;
            }
            let largest = self.0.iter().map(|checked| checked.largest[place]);
            let largest = largest.fold(0.0, f64::max);
            writeln!(out, "  {:<24} {largest:.1e}", what.words())?;
        }
        let residuals = self.0.iter().filter_map(|checked| checked.residual);
        let largest = residuals.clone().fold(0.0, f64::max);
        let above = residuals.filter(|one| *one > RESIDUAL).count();
        writeln!(out, "largest residual of the energy {largest:.1e}; {above} runs above {RESIDUAL:e}")?;
        let touches: usize = self.0.iter().map(|checked| checked.touches).sum();
        let grazes: usize = self.0.iter().map(|checked| checked.grazes).sum();
        writeln!(
            out,
            "{touches} touches; {grazes} more or less by one of the routes, within rounding"
        )
    }
}

impl Summary<'_> {
    /// The scenes that do not agree as CSV text, one row each with the number that is furthest off.
    pub fn csv(&self, seed: u64) -> String {
        let number = |one: &Checked, value: fn(&Disagreement) -> f64| {
            Cell::number(one.disagreements.first().map(value), |value| format!("{value:.1e}"))
        };
        Table::of(self.0.iter().filter(|one| one.verdict != Verdict::Agrees))
            .column("seed", |_| seed)
            .column("scene", |one| one.index)
            .column("verdict", |one| one.verdict.words())
            .column("cause", |one| one.cause())
            .column("distance", |one| number(one, |one| one.two.distance))
            .column("allowed", |one| number(one, |one| one.allowed))
            .column("with_what_the_exact_run_rounds", |one| number(one, |one| one.explained))
            .column("second_route_from_itself", |one| number(one, |one| one.own))
            .column("touches", |one| one.touches)
            .csv()
    }
}

impl fmt::Display for Summary<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        self.write_verdicts(out)?;
        self.write_classes(out)?;
        self.write_largest(out)
    }
}
