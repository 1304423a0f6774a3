//! The sentences and tables of stripes.

use pounding_assess::Suite;
use pounding_risk::{AnnualFrequency, Fragility, FragilityFit, Reached, Risk, State, Stripe, StripeMotion, StripeRun};
use pounding_scene::Implausible;
use pounding_text::{Answer, Cell, Grid, Table, Unit, Where, digits, percent, two_digits};
use serde_json::{Value, json};

use super::cautions::{says_misfit, says_shares, shares_differ};
use super::{Demand, RiskReport, counted, three};
use crate::SCHEMA_VERSION;
use crate::folder::said_briefly;

/// Years of the probability that is told.
const YEARS: f64 = 50.0;

/// Ranges of intensity of the parts of a frequency.
pub(super) const RANGES: u32 = 40;

impl<'a> RiskReport<'a> {
    /// The answer in the order in which people read it.
    pub fn answer(&'a self) -> Answer<'a> {
        let several = self.states.len() > 1;
        let mut answer = Answer::new();
        if let Some((state, risk)) = self.states.first() {
            answer = answer.say(Where::Terminal, "Answer", self.result(*state, risk));
        }
        let named = |(state, risk): &'a (State, Risk)| (*state, risk);
        let states = self.risks(Table::of(self.states.iter().map(named)).both("state", "State", |row| row.0.name(), |row| row.0.shown()));
        let of_gaps = Table::of(self.by_gap.iter().map(|(gap, risk)| (*gap, risk)));
        let gaps = self.risks(of_gaps.number("gap_m", "Gap", &Unit::GAP, |row| row.0));
        // What the model cannot tell comes before its numbers.
        answer = answer.say(Where::Terminal, "Warnings", self.warnings());
        if several {
            answer = answer.table(Where::Terminal, states.grid());
        }
        answer
            .table(Where::Terminal, gaps.grid())
            .table(Where::Terminal, self.stripes_grid())
            .table(Where::Details, self.motions_grid())
            .say(Where::FirstScreen, "Records", self.records(false))
            .say(Where::Details, "Records", self.records(true))
            .say(Where::Terminal, "Notes", self.notes())
            .fact("schema_version", SCHEMA_VERSION)
            .fact("scene", json!(self.scene))
            .fact("intensity_measure", self.measure.map(|measure| measure.to_string()))
            .fact("gaps_m", json!(self.runs.gaps))
            .fact("states", states.json())
            .fact("by_gap", gaps.json())
            .fact("stripes", self.stripes_table().json())
            .fact("motions", self.motions_table().json())
            .fact("contributions", self.contributions())
            .fact("records", self.suites.iter().map(|suite| suite.json()).collect::<Value>())
            .fact("left_out", self.suites.iter().map(|suite| suite.left_out_json()).collect::<Value>())
            .fact("warnings", self.warnings())
            .with_csv(|| self.runs_table().csv())
    }

    /// The median intensity of a state, and how often it is reached.
    fn result(&self, state: State, risk: &Risk) -> Vec<String> {
        let Some(fragility) = risk.fragility() else {
            let of_shares = risk.of_shares.as_ref().map(says_shares);
            return [format!("no fragility of motions that {}", state.words())]
                .into_iter()
                .chain(of_shares)
                .collect();
        };
        let theta = risk.bounds(|one| one.median);
        let unbounded = if theta.is_none() && risk.drawn.is_some() {
            let n = risk.stripes.all.first().map_or(0, Stripe::n);
            format!("; {n} events give it no bounds")
        } else {
            String::new()
        };
        let theta = bounds(theta, three);
        let beta = bounds(risk.bounds(|one| one.dispersion), three);
        let across = match (state, state.limit(&self.runs.gaps)) {
            (State::Touch(_), Some(gap)) => format!(" across {} mm", digits(gap * 1e3)),
            _ => String::new(),
        };
        let mut said = vec![format!(
            "half of the motions {}{across} at {}{} g{theta}; β = {}{beta}{unbounded}",
            state.words(),
            self.measure.map_or_else(String::new, |measure| format!("{measure} = ")),
            three(fragility.median),
            three(fragility.dispersion)
        )];
        if let Some(annual) = risk.annual() {
            let period = risk.rate_bounds.map(|[low, high]| [high.recip(), low.recip()]);
            let years = |years: f64| digits(years.round());
            said.push(format!(
                "once in {} years{}: {} per year, {} in 50 years",
                years(annual.return_period()),
                bounds(period, years),
                three(annual.rate),
                percent(annual.probability_in(YEARS))
            ));
            said.extend(self.says_contributions(fragility));
            said.extend(shares_differ(risk).map(says_shares));
        }
        said
    }

    /// The range of intensities from which the middle half of the frequency comes.
    fn says_contributions(&self, fragility: &Fragility) -> Option<String> {
        let all = self.hazard?.contributions(fragility, RANGES);
        let whole: f64 = all.iter().map(|one| one.rate).sum();
        let at = |part: f64| {
            let mut sum = 0.0;
            let reached = all.iter().find(|one| {
                sum += one.rate;
                sum >= part * whole
            });
            reached.map(|one| one.intensities)
        };
        let (from, to) = (at(0.25)?, at(0.75)?);
        Some(format!(
            "half of that comes from motions of {} to {} g",
            two_digits(from[0]),
            two_digits(to[1])
        ))
    }

    /// Adds the numbers of risks to a table.
    fn risks<Of: 'a>(&self, table: Table<'a, (Of, &'a Risk)>) -> Table<'a, (Of, &'a Risk)> {
        let mut all = self.states.iter().map(|one| &one.1).chain(self.by_gap.iter().map(|one| &one.1));
        let differ = all.any(|risk| shares_differ(risk).is_some());
        let fragility = |number: fn(&Fragility) -> f64| move |row: &(Of, &Risk)| row.1.fragility().map(number);
        let ends = |number: fn(&Fragility) -> f64, end: usize| {
            move |row: &(Of, &Risk)| Cell::exact(row.1.bounds(number).map(|bounds| bounds[end]))
        };
        let between = |number: fn(&Fragility) -> f64| {
            move |row: &(Of, &Risk)| {
                let bounds = row.1.bounds(number);
                bounds.map(|[low, high]| format!("{}–{}", three(low), three(high)))
            }
        };
        let of_fit = |number: fn(&FragilityFit) -> f64| move |row: &(Of, &Risk)| Cell::exact(row.1.fit.as_ref().ok().map(number));
        let median: fn(&Fragility) -> f64 = |one| one.median;
        let dispersion: fn(&Fragility) -> f64 = |one| one.dispersion;
        let table = numbered(table, ["median_g", "θ", "g"], three, fragility(median))
            .column("median_low_g", ends(median, 0))
            .column("median_high_g", ends(median, 1))
            .shown_in("g", "95 %", between(median));
        let table = numbered(table, ["dispersion", "β", ""], three, fragility(dispersion))
            .column("dispersion_low", ends(dispersion, 0))
            .column("dispersion_high", ends(dispersion, 1))
            .shown("95 %", between(dispersion))
            .column("error_of_log_median", of_fit(|fit| fit.error_of_log_median))
            .column("error_of_dispersion", of_fit(|fit| fit.error_of_dispersion))
            .column("correlation", of_fit(|fit| fit.correlation))
            .column("minus_log_likelihood", of_fit(|fit| fit.minus_log_likelihood));
        let table = if self.hazard.is_some() { frequencies(table, differ) } else { table };
        table.column("refused", |row| row.1.refused().map(ToString::to_string))
    }

    /// A row for each state and intensity, for programs: how many events reach the state.
    pub(super) fn stripes_table(&'a self) -> Table<'a, (State, &'a Risk, &'a Stripe)> {
        let rows = self.states.iter().flat_map(|(state, risk)| {
            let stripes = risk.stripes.all.iter();
            stripes.map(move |stripe| (*state, risk, stripe))
        });
        let fitted = |(_, risk, stripe): &(State, &Risk, &Stripe)| Some(risk.fragility()?.probability(stripe.intensity));
        Table::of(rows)
            .column("state", |row| row.0.name())
            .column("intensity_g", |row| Cell::exact(row.2.intensity))
            .column("events", |row| row.2.n())
            .column("exceeding", |row| Cell::exact(row.2.exceeding()))
            .column("share", |row| Cell::exact(row.2.share()))
            .column("fitted", move |row| Cell::exact(fitted(row)))
    }

    /// A row for each intensity, for people.
    fn stripes_grid(&self) -> Grid {
        let table = Table::of(0..self.runs.intensities.len());
        let table = table.shown_in("g", "Intensity", |index| three(self.runs.intensities[*index]));
        let all = self.states.iter().fold(table, |table, (state, risk)| {
            let fitted = |index: usize| Some(risk.fragility()?.probability(self.runs.intensities[index]));
            table
                .shown(state.shown(), |index| counted(&risk.stripes.all[*index]))
                .shown("fitted", move |index| fitted(*index).map(|part| format!("{:.0} %", 100.0 * part)))
        });
        all.grid()
    }

    /// A row for each state and motion, for programs: the least intensity at which the motion reaches the state.
    fn motions_table(&'a self) -> Table<'a, (State, &'a StripeMotion, Option<Reached>)> {
        let rows = self.states.iter().flat_map(|(state, _)| {
            let motions = self.runs.motions.iter().zip(self.runs.reached(*state));
            motions.map(move |(motion, reached)| (*state, motion, reached))
        });
        Table::of(rows)
            .column("state", |row| row.0.name())
            .column("record", |row| row.1.name.clone())
            .column("reversed", |row| row.1.reversed)
            .column("event", |row| row.1.event + 1)
            .column("own_intensity_g", |row| Cell::exact(row.1.own_intensity))
            .column("first_g", |row| Cell::exact(row.2.map(|one| one.first)))
            .column("returns", |row| row.2.map(|one| one.returns))
    }

    /// A row for each motion, for people.
    fn motions_grid(&self) -> Grid {
        let motion = |index: &usize| &self.runs.motions[*index];
        let table = Table::of(0..self.runs.motions.len())
            .shown("Record", |index| motion(index).name())
            .shown("Event", |index| (motion(index).event + 1).to_string())
            .shown_in("g", "Own", |index| motion(index).own_intensity.map(three));
        let all = self.states.iter().fold(table, |table, (state, _)| {
            let reached = self.runs.reached(*state);
            table.shown_in("g", state.shown(), move |index| {
                let one = reached[*index]?;
                Some(format!("{}{}", three(one.first), if one.returns { "*" } else { "" }))
            })
        });
        all.grid()
    }

    /// A row for each run, for programs.
    fn runs_table(&'a self) -> Table<'a, &'a StripeRun> {
        let motion = |run: &&StripeRun| -> &'a StripeMotion { &self.runs.motions[run.motion] };
        let intensity = |run: &&StripeRun| self.runs.intensities[run.stripe];
        let table = Table::of(&self.runs.runs)
            .column("record", move |run| motion(run).name.clone())
            .column("reversed", move |run| motion(run).reversed)
            .column("event", move |run| motion(run).event + 1)
            .column("intensity_g", move |run| Cell::exact(intensity(run)))
            .column("scale", move |run| {
                Cell::exact(motion(run).own_intensity.map(|own| intensity(run) / own))
            });
        let has_required = self
            .runs
            .runs
            .iter()
            .any(|run| run.found.as_ref().is_ok_and(|one| !one.required.is_empty()));
        let gaps = if has_required { self.runs.gaps.len() } else { 0 };
        let table = table.columns(
            0..gaps,
            |gap| format!("gap_{}_required_m", gap + 1),
            |run, gap| Cell::exact(run.found.as_ref().ok().and_then(|one| one.required.get(gap).copied())),
        );
        let kinds: Vec<_> = self.states.iter().map(|(state, _)| std::mem::discriminant(state)).collect();
        self.states
            .iter()
            .enumerate()
            .fold(table, |table, (index, (state, _))| {
                let demand = move |run: &&StripeRun| run.found.as_ref().ok().and_then(|one| state.demand(one));
                let reached = move |run: &&StripeRun| run.found.as_ref().ok().and_then(|one| state.is_reached(one, &self.runs.gaps));
                let table = table.column(state.name(), reached);
                match (state, Demand::of(*state)) {
                    (State::Touch(_), _) | (_, None) => table,
                    // Several limits of one number.
                    _ if kinds[..index].contains(&kinds[index]) => table,
                    (_, Some(words)) => table.column(words.column, move |run| Cell::exact(demand(run))),
                }
            })
            .column("failed", |run| run.found.as_ref().err().cloned())
    }

    /// How many files became how many events, of each folder; of the only one, and with details, the remarks, too.
    fn records(&self, details: bool) -> Vec<String> {
        if let ([suite], false) = (&self.suites[..], details) {
            return said_briefly(suite, "--details names every one");
        }
        let of = |(index, suite): (usize, &&Suite)| {
            let at = self
                .measure
                .is_none()
                .then(|| format!("{} g: ", digits(self.runs.intensities[index])));
            let said = if details { suite.said(true) } else { vec![suite.counts()] };
            let line = move |line: String| format!("{}{line}", at.as_deref().unwrap_or_default());
            said.into_iter().map(line).collect::<Vec<_>>()
        };
        self.suites.iter().enumerate().flat_map(of).collect()
    }

    /// Faults that the answer may have.
    fn warnings(&self) -> Vec<String> {
        let mut said = self.cautions.clone();
        let is_compliant = self.scene.contacts.iter().flatten().any(|one| one.law.is_compliant());
        let of_contact = |state: &State| !matches!(state, State::Touch(_) | State::Collapse);
        if is_compliant && self.states.iter().any(|(state, _)| of_contact(state)) {
            said.push(
                "states other than touching hold for the contact stiffness of the scene, which nobody knows: over 0.1 to 10 times of it \
                 frequencies of forces and of drifts after a blow may differ by tens of times, and the bounds do not know it; run the scene with both"
                    .into(),
            );
        }
        let failed: Vec<_> = self.runs.failed().collect();
        if let Some((motion, intensity, reason)) = failed.first() {
            let n = failed.len();
            said.push(format!(
                "{n} of {} runs failed and count nowhere; the first, {} at {} g: {reason}",
                self.runs.runs.len(),
                motion.name(),
                digits(*intensity)
            ));
        }
        match self.runs.n_collapsed() {
            0 => (),
            n => said.push(format!(
                "{n} of {} runs end as a storey collapses, and count as reaching every state, as usual in incremental dynamic analysis; the state \
                 collapse counts them alone",
                self.runs.runs.len()
            )),
        }
        let states = self.states.iter().map(|(state, risk)| (state.shown(), risk));
        let gaps = self
            .by_gap
            .iter()
            .map(|(gap, risk)| (format!("a gap of {} mm", digits(gap * 1e3)), risk));
        let all: Vec<(String, &Risk)> = states.chain(gaps).collect();
        // The refusal of the first state is that of the command.
        let refused = all.iter().skip(1);
        said.extend(refused.filter_map(|(name, risk)| Some(format!("{name}: {}", risk.refused()?))));
        said.extend(all.iter().filter_map(|(name, risk)| says_misfit(name, risk)));
        said.extend(self.states.iter().filter_map(|(state, risk)| self.says_beyond(*state, risk)));
        said.extend(self.states.iter().filter_map(|(state, risk)| says_without_bounds(*state, risk)));
        said.extend(self.says_factors());
        said.extend(self.suites.iter().filter_map(|suite| suite.says_missing(0)));
        said
    }

    /// Warns of a median beyond the intensities.
    fn says_beyond(&self, state: State, risk: &Risk) -> Option<String> {
        let median = risk.fragility()?.median;
        let (first, last) = (self.runs.intensities.first()?, self.runs.intensities.last()?);
        (!(*first..=*last).contains(&median)).then(|| {
            format!(
                "the median of {} lies beyond the intensities of {} to {} g: it continues their lognormal distribution",
                state.shown(),
                digits(*first),
                digits(*last)
            )
        })
    }

    /// Warns of factors on records that belong to other earthquakes.
    fn says_factors(&self) -> Option<String> {
        let [least, most] = Implausible::USUAL_FACTORS;
        let factors = self.runs.runs.iter().filter_map(|run| {
            let own = self.runs.motions[run.motion].own_intensity?;
            Some(self.runs.intensities[run.stripe] / own)
        });
        let factors: Vec<f64> = factors.collect();
        let beyond = factors.iter().filter(|factor| !(least..=most).contains(*factor)).count();
        let ends = [f64::min, f64::max].map(|end| factors.iter().copied().reduce(end).map_or_else(String::new, three));
        (beyond > 0).then(|| {
            format!(
                "{beyond} of {} runs scale a record by less than {} or more than {} ({} to {}): such motions belong to other earthquakes; take \
                 records of each intensity (--stripe)",
                factors.len(),
                digits(least),
                digits(most),
                ends[0],
                ends[1]
            )
        })
    }

    fn notes(&self) -> Vec<String> {
        let mut said = vec![
            "θ and β: median and dispersion of the lognormal fragility of most likelihood. Components and directions of an event are one \
             sample, which counts with its share. 95 %: events drawn again 1000 times."
                .to_owned(),
        ];
        if self.states.iter().any(|(state, _)| matches!(state, State::Touch(_))) || !self.by_gap.is_empty() {
            said.push("Touching: the gap is narrower than its largest closing while nothing touches, by the exact method.".into());
        }
        if self.measure.is_some() {
            said.push("Intensity of a pair of horizontal components: RotD50, 5 % of damping.".into());
        }
        if self.hazard.is_some() {
            said.push(
                "λ: integral of the fragility over the hazard curve, a power law between its points. In 50 years: Poisson. The bounds do not \
                 know those of the hazard curve."
                    .into(),
            );
        }
        let returns = self.states.iter().filter_map(|(state, _)| {
            let reached = self.runs.reached(*state);
            let n = reached.iter().flatten().filter(|one| one.returns).count();
            (n > 0).then(|| {
                format!(
                    "{n} of {} motions that reach {} leave it again at a higher intensity (* with --details): the share at each intensity \
                     counts, not the first.",
                    reached.iter().flatten().count(),
                    state.shown()
                )
            })
        });
        said.extend(returns);
        said
    }

    /// Parts of the annual frequency of the first state by intensity.
    fn contributions(&self) -> Value {
        let fragility = self.states.first().and_then(|(_, risk)| risk.fragility());
        let Some((hazard, fragility)) = self.hazard.zip(fragility) else {
            return Value::Null;
        };
        let all = hazard.contributions(fragility, RANGES).into_iter();
        all.map(|one| json!({"from_g": one.intensities[0], "to_g": one.intensities[1], "annual_frequency_per_year": one.rate}))
            .collect()
    }
}

/// Adds a number that people read in another form: its name, its heading and its unit.
fn numbered<'a, Of: 'a>(
    table: Table<'a, Of>,
    [name, heading, unit]: [&'static str; 3],
    text: fn(f64) -> String,
    number: impl Fn(&Of) -> Option<f64> + Copy + 'a,
) -> Table<'a, Of> {
    table.both(
        name,
        (heading, unit),
        move |row| Cell::exact(number(row)),
        move |row| number(row).map(text),
    )
}

/// Adds how often states are reached.
fn frequencies<'a, Of: 'a>(table: Table<'a, (Of, &'a Risk)>, differ: bool) -> Table<'a, (Of, &'a Risk)> {
    let of = |number: fn(&AnnualFrequency) -> f64| move |row: &(Of, &Risk)| row.1.annual().map(number);
    let end = |end: usize| move |row: &(Of, &Risk)| Cell::exact(row.1.rate_bounds.map(|bounds| bounds[end]));
    let exact = |number: fn(&AnnualFrequency) -> f64| move |row: &(Of, &Risk)| Cell::exact(row.1.annual().map(number));
    let years = |years: f64| digits(years.round());
    let table = numbered(table, ["annual_frequency_per_year", "λ", "1/year"], three, of(|one| one.rate))
        .column("annual_frequency_low_per_year", end(0))
        .column("annual_frequency_high_per_year", end(1))
        .column("annual_frequency_of_shares_per_year", |row| {
            Cell::exact(row.1.of_shares.map(|one| one.rate))
        })
        .column("part_below_the_curve", exact(|one| one.beyond[0]))
        .column("part_above_the_curve", exact(|one| one.beyond[1]));
    let table = numbered(
        table,
        ["return_period_years", "Once in", "years"],
        years,
        of(AnnualFrequency::return_period),
    );
    let in_years = of(|one| one.probability_in(YEARS));
    let table = numbered(table, ["probability_in_50_years", "In 50 years", ""], percent, in_years);
    // The frequency by the shares stands beside that of the fragility where they differ.
    if !differ {
        return table;
    }
    table.shown_in("1/year", "λ of shares", |row| shares_differ(row.1).map(|one| three(one.rate)))
}

/// Bounds in parentheses, after a blank; empty if there are none.
fn bounds(bounds: Option<[f64; 2]>, text: impl Fn(f64) -> String) -> String {
    bounds.map_or_else(String::new, |[low, high]| format!(" (95 %: {} to {})", text(low), text(high)))
}

/// Warns of a fragility without bounds.
fn says_without_bounds(state: State, risk: &Risk) -> Option<String> {
    let drawn = risk.drawn.as_ref()?;
    let without = drawn.draws - drawn.fragilities.len();
    drawn.bounds(|one| one.median).is_none().then(|| {
        format!(
            "{} has no bounds: {without} of {} draws of the events determine no fragility; take more events or intensities",
            state.shown(),
            drawn.draws
        )
    })
}
