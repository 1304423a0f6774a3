//! What became of the scenes of a campaign, in numbers.

use std::collections::BTreeMap;
use std::fmt::{self, Formatter};

use super::check::{Checked, Disagreement, Failure, RESIDUAL, Verdict};
use super::class::Class;
use super::compared::{Compared, Place};
use pounding_text::to_csv;
use strum::EnumCount;

/// A failure that the documentation of limits names.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KnownLimit {
    /// Name of the kind of error.
    pub kind: &'static str,
    /// What cannot be run.
    pub why: &'static str,
}

/// Failures that are named: everything else that fails is a fault.
pub const LIMITS: [KnownLimit; 4] = [
    KnownLimit {
        kind: "ClosedIn",
        why: "a row between walls on grounds that travel towards each other has no room: there is no such motion",
    },
    KnownLimit {
        kind: "BouncesWithoutEnd",
        why: "with e = 1 neighbours that press against each other bounce for ever",
    },
    KnownLimit {
        kind: "NoSeries",
        why: "compliant neighbours without a gap that begin to press through a contact that begins at the same instant",
    },
    KnownLimit {
        kind: "CrawlsInContact",
        why: "a damper that grows with 1/v₀ holds neighbours that touched slowly and press against each other",
    },
];

/// Scenes of which some have to agree.
const MANY: usize = 20;

/// What became of a campaign.
#[derive(Debug)]
pub struct Summary<'a>(pub &'a [Checked]);

/// Kinds of verdicts, in the order of tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, EnumCount)]
enum Fate {
    Agrees,
    Disagrees,
    SecondRouteRounds,
    ExactRounds,
    Unknowable,
    Named,
    ExactFails,
    SecondRouteFails,
    Refused,
    Hangs,
    Panics,
}

impl Fate {
    const ALL: [Self; Self::COUNT] = [
        Self::Agrees,
        Self::Disagrees,
        Self::SecondRouteRounds,
        Self::ExactRounds,
        Self::Unknowable,
        Self::Named,
        Self::ExactFails,
        Self::SecondRouteFails,
        Self::Refused,
        Self::Hangs,
        Self::Panics,
    ];

    fn of(verdict: &Verdict) -> Self {
        match verdict {
            Verdict::Agrees => Self::Agrees,
            Verdict::Disagrees(_) => Self::Disagrees,
            Verdict::SecondRouteRounds(_) => Self::SecondRouteRounds,
            Verdict::ExactRounds(_) => Self::ExactRounds,
            Verdict::Unknowable(_) => Self::Unknowable,
            Verdict::ExactFails(failure) if failure.is_known() => Self::Named,
            Verdict::ExactFails(_) => Self::ExactFails,
            Verdict::SecondRouteFails(_) => Self::SecondRouteFails,
            Verdict::Refused(_) => Self::Refused,
            Verdict::Hangs(_) => Self::Hangs,
            Verdict::Panics(_) => Self::Panics,
        }
    }

    fn words(self) -> &'static str {
        match self {
            Self::Agrees => "agree",
            Self::Disagrees => "disagree",
            Self::SecondRouteRounds => "second rounds",
            Self::ExactRounds => "exact rounds",
            Self::Unknowable => "ill-conditioned",
            Self::Named => "named limit",
            Self::ExactFails => "exact fails",
            Self::SecondRouteFails => "second fails",
            Self::Refused => "refused",
            Self::Hangs => "hang",
            Self::Panics => "panic",
        }
    }
}

impl Verdict {
    /// What is further off than is allowed, the worst kind first.
    fn disagreements(&self) -> &[Disagreement] {
        match self {
            Self::Disagrees(all) | Self::SecondRouteRounds(all) | Self::ExactRounds(all) | Self::Unknowable(all) => all,
            Self::Agrees | Self::ExactFails(_) | Self::SecondRouteFails(_) | Self::Refused(_) | Self::Hangs(_) | Self::Panics(_) => &[],
        }
    }
}

impl Checked {
    /// Whether nothing speaks against the exact method: both routes agree, rounding explains their distance, the second route has no
    /// answer, or the exact method fails in a way that is [named](LIMITS).
    pub fn is_good(&self) -> bool {
        match &self.verdict {
            Verdict::Agrees
            | Verdict::SecondRouteRounds(_)
            | Verdict::ExactRounds(_)
            | Verdict::Unknowable(_)
            | Verdict::SecondRouteFails(_) => true,
            Verdict::ExactFails(failure) => failure.is_known(),
            Verdict::Disagrees(_) | Verdict::Refused(_) | Verdict::Hangs(_) | Verdict::Panics(_) => false,
        }
    }

    /// The cause by which scenes are sorted: what they have in common that do not agree.
    pub fn cause(&self) -> String {
        match &self.verdict {
            Verdict::Agrees | Verdict::Disagrees(_) | Verdict::SecondRouteRounds(_) | Verdict::ExactRounds(_) | Verdict::Unknowable(_) => {
                let worst = self.verdict.disagreements().first();
                worst.map_or(String::new(), |one| one.two.what.words().into())
            }
            Verdict::ExactFails(failure) | Verdict::SecondRouteFails(failure) | Verdict::Refused(failure) => failure.kind.clone(),
            Verdict::Hangs(stage) | Verdict::Panics(stage) => stage.words().into(),
        }
    }

    /// What became of the scene, in a line for each thing that is wrong.
    pub fn lines(&self) -> Vec<String> {
        let fate = Fate::of(&self.verdict).words();
        let line = |words: String| format!("scene {}: {fate}: {words}", self.index);
        match &self.verdict {
            Verdict::Agrees => Vec::new(),
            Verdict::Disagrees(_) | Verdict::SecondRouteRounds(_) | Verdict::ExactRounds(_) | Verdict::Unknowable(_) => {
                let all = self.verdict.disagreements();
                let numbers = all.iter().map(|one| line(one.to_string()));
                numbers.chain(self.story.iter().cloned()).collect()
            }
            Verdict::ExactFails(failure) | Verdict::SecondRouteFails(failure) | Verdict::Refused(failure) => {
                vec![line(format!("{}: {}", failure.kind, failure.message))]
            }
            Verdict::Hangs(stage) | Verdict::Panics(stage) => vec![line(stage.words().into())],
        }
    }
}

impl Failure {
    /// Whether the limits name it.
    pub fn is_known(&self) -> bool {
        LIMITS.iter().any(|limit| limit.kind == self.kind)
    }
}

impl fmt::Display for Disagreement {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let two = &self.two;
        let place = match two.place {
            Place::Floor(floor) => format!(" of floor {floor}"),
            Place::Touch { pair, touch } => format!(" {touch} of pair {pair}"),
            Place::Pair(pair) => format!(" of pair {pair}"),
            Place::Run => String::new(),
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
    /// Whether nothing speaks against the exact method in [any of them](Checked::is_good).
    ///
    /// Of many scenes most have to agree, too: a second route that never has an answer speaks for nothing.
    pub fn is_good(&self) -> bool {
        let agree = self.count(Fate::Agrees, None);
        self.0.iter().all(Checked::is_good) && (self.0.len() < MANY || 2 * agree > self.0.len())
    }

    /// How many scenes have a fate, for each cause.
    fn causes(&self, fate: Fate) -> BTreeMap<String, usize> {
        let mut causes = BTreeMap::new();
        for checked in self.0 {
            if Fate::of(&checked.verdict) == fate {
                *causes.entry(checked.cause()).or_default() += 1;
            }
        }
        causes
    }

    fn count(&self, fate: Fate, class: Option<Class>) -> usize {
        let has = |checked: &&Checked| class.is_none_or(|class| checked.classes.contains(&class)) && Fate::of(&checked.verdict) == fate;
        self.0.iter().filter(has).count()
    }

    fn write_fates(&self, out: &mut Formatter<'_>) -> fmt::Result {
        writeln!(out, "{} scenes", self.0.len())?;
        for fate in Fate::ALL {
            let count = self.count(fate, None);
            if count == 0 {
                continue;
            }
            let causes = self.causes(fate);
            let causes = causes.iter().filter(|(cause, _)| !cause.is_empty());
            let causes: Vec<_> = causes.map(|(cause, count)| format!("{cause} {count}")).collect();
            writeln!(out, "  {:<16} {count:>6}  {}", fate.words(), causes.join(", "))?;
        }
        Ok(())
    }

    fn write_classes(&self, out: &mut Formatter<'_>) -> fmt::Result {
        let seen = Fate::ALL.into_iter().filter(|fate| self.count(*fate, None) > 0);
        let seen: Vec<_> = seen.collect();
        write!(out, "\n{:<24} {:>6}", "scenes with", "all")?;
        for fate in &seen {
            write!(out, " {:>15}", fate.words())?;
        }
        writeln!(out)?;
        for class in Class::ALL {
            let counts = seen.iter().map(|fate| self.count(*fate, Some(class)));
            let counts: Vec<_> = counts.collect();
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
    /// The scenes that do not agree, a row each, as CSV text: of a number the furthest off of the worst kind.
    pub fn csv(&self, seed: u64) -> String {
        let header = [
            "seed",
            "scene",
            "verdict",
            "cause",
            "distance",
            "allowed",
            "with_what_the_exact_run_rounds",
            "second_route_from_itself",
            "touches",
        ];
        let row = |checked: &Checked| {
            let number = |value: f64| {
                if value.is_finite() { format!("{value:.1e}") } else { String::new() }
            };
            let worst = checked.verdict.disagreements().first();
            let of = |value: fn(&Disagreement) -> f64| worst.map(value).map(number).unwrap_or_default();
            vec![
                seed.to_string(),
                checked.index.to_string(),
                Fate::of(&checked.verdict).words().into(),
                checked.cause(),
                of(|one| one.two.distance),
                of(|one| one.allowed),
                of(|one| one.explained),
                of(|one| one.own),
                checked.touches.to_string(),
            ]
        };
        let apart = self.0.iter().filter(|one| !matches!(one.verdict, Verdict::Agrees));
        to_csv(&header.map(String::from), &apart.map(row).collect::<Vec<_>>())
    }
}

impl fmt::Display for Summary<'_> {
    fn fmt(&self, out: &mut Formatter<'_>) -> fmt::Result {
        self.write_fates(out)?;
        self.write_classes(out)?;
        self.write_largest(out)
    }
}
