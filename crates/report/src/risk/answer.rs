//! The sentences and tables of stripes.

use pounding_risk::{AnnualFrequency, Fragility, FragilityFit, Risk, State, Stripe, StripeMotion, StripeRun};
use pounding_scene::Implausible;
use pounding_text::{Answer, Cell, Table, Unit, Where, digits, percent, short};
use serde_json::{Value, json};

use super::{Demand, RiskReport};
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
        let named = |(state, risk): &'a (State, Risk)| (state.name(), risk);
        let states = self.risks(Table::of(self.states.iter().map(named)).both(
            "state",
            "State",
            |row| row.0.clone(),
            |row| row.0.clone(),
        ));
        let of_gaps = Table::of(self.by_gap.iter().map(|(gap, risk)| (*gap, risk)));
        let gaps = self.risks(of_gaps.number("gap_m", "Gap", &Unit::GAP, |row| row.0));
        if several {
            answer = answer.table(Where::Terminal, states.grid());
        }
        answer
            .table(Where::Terminal, gaps.grid())
            .say(Where::Terminal, "Warnings", self.warnings())
            .table(Where::Terminal, self.stripes_table().grid())
            .table(Where::Details, self.motions_table().grid())
            .say(Where::FirstScreen, "Records", self.records(false))
            .say(Where::Details, "Records", self.records(true))
            .say(Where::Terminal, "Notes", self.notes())
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
            return vec![format!("no fragility of motions that {}", state.words())];
        };
        let theta = bounds(risk.bounds(|one| one.median), short);
        let beta = bounds(risk.bounds(|one| one.dispersion), short);
        let mut said = vec![format!(
            "half of the motions {} at {} = {} g{theta}; β = {}{beta}",
            state.words(),
            self.measured(),
            short(fragility.median),
            short(fragility.dispersion)
        )];
        if let Some(annual) = risk.annual() {
            let period = risk.rate_bounds.map(|[low, high]| [high.recip(), low.recip()]);
            let years = |years: f64| digits(years.round());
            said.push(format!(
                "once in {} years{}: {} per year, {} in 50 years",
                years(annual.return_period()),
                bounds(period, years),
                short(annual.rate),
                percent(annual.probability_in(YEARS))
            ));
            said.extend(self.says_contributions(fragility));
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
        let rough = |number: f64| digits(format!("{number:.1e}").parse().unwrap_or(number));
        Some(format!("half of that comes from motions of {} to {} g", rough(from[0]), rough(to[1])))
    }

    /// Adds the numbers of risks to a table.
    fn risks<Of: 'a>(&self, table: Table<'a, (Of, &'a Risk)>) -> Table<'a, (Of, &'a Risk)> {
        let fragility = |number: fn(&Fragility) -> f64| move |row: &(Of, &Risk)| row.1.fragility().map(number);
        let ends = |number: fn(&Fragility) -> f64, end: usize| {
            move |row: &(Of, &Risk)| Cell::exact(row.1.bounds(number).map(|bounds| bounds[end]))
        };
        let between = |number: fn(&Fragility) -> f64| {
            move |row: &(Of, &Risk)| {
                let bounds = row.1.bounds(number);
                bounds.map(|[low, high]| format!("{}–{}", short(low), short(high)))
            }
        };
        let of_fit = |number: fn(&FragilityFit) -> f64| move |row: &(Of, &Risk)| Cell::exact(row.1.fit.as_ref().ok().map(number));
        let (median, dispersion): (fn(&Fragility) -> f64, fn(&Fragility) -> f64) = (|one| one.median, |one| one.dispersion);
        let table = numbered(table, ["median_g", "θ", "g"], short, fragility(median))
            .column("median_low_g", ends(median, 0))
            .column("median_high_g", ends(median, 1))
            .shown_in("g", "95 %", between(median));
        let table = numbered(table, ["dispersion", "β", ""], short, fragility(dispersion))
            .column("dispersion_low", ends(dispersion, 0))
            .column("dispersion_high", ends(dispersion, 1))
            .shown("95 %", between(dispersion))
            .column("error_of_log_median", of_fit(|fit| fit.error_of_log_median))
            .column("error_of_dispersion", of_fit(|fit| fit.error_of_dispersion))
            .column("correlation", of_fit(|fit| fit.correlation))
            .column("minus_log_likelihood", of_fit(|fit| fit.minus_log_likelihood));
        let table = if self.hazard.is_some() { frequencies(table) } else { table };
        let table = table.column("refused", |row| row.1.refused().map(ToString::to_string));
        let any = self.states.iter().map(|one| &one.1).chain(self.by_gap.iter().map(|one| &one.1));
        if any.skip(1).any(|risk| risk.refused().is_some()) {
            table.shown("", |row| row.1.refused().map_or_else(String::new, |refused| refused.parts().found.unwrap_or_default()))
        } else {
            table
        }
    }

    /// A row for each intensity: how many events reach each state.
    pub(super) fn stripes_table(&'a self) -> Table<'a, usize> {
        let table = Table::of(0..self.runs.intensities.len()).both(
            "intensity_g",
            (self.measured(), "g"),
            |index| Cell::exact(Some(self.runs.intensities[*index])),
            |index| digits(self.runs.intensities[*index]),
        );
        let of = |risk: &'a Risk, index: usize| -> &'a Stripe { &risk.stripes.all[index] };
        self.states.iter().fold(table, |table, (state, risk)| {
            let name = state.name();
            let fitted = move |index: &usize| Some(risk.fragility()?.probability(self.runs.intensities[*index]));
            table
                .column(format!("{name}: events"), move |index| of(risk, *index).n())
                .column(format!("{name}: exceeding"), move |index| Cell::exact(Some(of(risk, *index).exceeding())))
                .shown(name.clone(), move |index| {
                    let stripe = of(risk, *index);
                    format!("{} of {}", digits((stripe.exceeding() * 100.0).round() / 100.0), stripe.n())
                })
                .both(
                    format!("{name}: fitted"),
                    "fitted",
                    move |index| Cell::exact(fitted(index)),
                    move |index| fitted(index).map(|part| format!("{:.0} %", 100.0 * part)),
                )
        })
    }

    /// A row for each motion: the least intensity at which it reaches each state.
    fn motions_table(&'a self) -> Table<'a, usize> {
        let motion = |index: &usize| -> &'a StripeMotion { &self.runs.motions[*index] };
        let table = Table::of(0..self.runs.motions.len())
            .shown("Record", move |index| motion(index).name())
            .column("record", move |index| motion(index).name.clone())
            .column("reversed", move |index| motion(index).reversed)
            .both("event", "Event", move |index| motion(index).event + 1, move |index| {
                (motion(index).event + 1).to_string()
            });
        let table = numbered(table, ["own_intensity_g", "Own", "g"], short, move |index| motion(index).own_intensity);
        self.states.iter().fold(table, |table, (state, _)| {
            let reached = self.runs.reached(*state);
            let again = reached.clone();
            let (name, shown) = (state.name(), reached.clone());
            table
                .both(
                    format!("{name}: first_g"),
                    (format!("{name} from"), "g"),
                    move |index| Cell::exact(reached[*index].map(|one| one.first)),
                    move |index| {
                        let one = shown[*index]?;
                        Some(format!("{}{}", digits(one.first), if one.returns { "*" } else { "" }))
                    },
                )
                .column(format!("{name}: returns"), move |index| again[*index].map(|one| one.returns))
        })
    }

    /// A row for each run, for programs.
    fn runs_table(&'a self) -> Table<'a, &'a StripeRun> {
        let motion = |run: &&StripeRun| -> &'a StripeMotion { &self.runs.motions[run.motion] };
        let intensity = |run: &&StripeRun| self.runs.intensities[run.stripe];
        let table = Table::of(&self.runs.runs)
            .column("record", move |run| motion(run).name.clone())
            .column("reversed", move |run| motion(run).reversed)
            .column("event", move |run| motion(run).event + 1)
            .column("intensity_g", move |run| Cell::exact(Some(intensity(run))))
            .column("scale", move |run| Cell::exact(motion(run).own_intensity.map(|own| intensity(run) / own)));
        let has_required = self.runs.runs.iter().any(|run| run.found.as_ref().is_ok_and(|one| !one.required.is_empty()));
        let gaps = if has_required { self.runs.gaps.len() } else { 0 };
        let table = table.columns(
            0..gaps,
            |gap| format!("gap_{}_required_m", gap + 1),
            |run, gap| Cell::exact(run.found.as_ref().ok().and_then(|one| one.required.get(gap).copied())),
        );
        self.states
            .iter()
            .fold(table, |table, (state, _)| {
                let demand = move |run: &&StripeRun| run.found.as_ref().ok().and_then(|one| state.demand(one));
                let reached = move |run: &&StripeRun| run.found.as_ref().ok().and_then(|one| state.is_reached(one, &self.runs.gaps));
                let table = table.column(state.name(), reached);
                match (state, Demand::of(*state)) {
                    (State::Touch(_), _) | (_, None) => table,
                    (_, Some(words)) => table.column(words.column, move |run| Cell::exact(demand(run))),
                }
            })
            .column("failed", |run| run.found.as_ref().err().cloned())
    }

    fn records(&self, details: bool) -> Vec<String> {
        let of = |(index, suite): (usize, &&pounding_assess::Suite)| {
            let said = if details {
                suite.said(true)
            } else {
                said_briefly(suite, "--details names every one")
            };
            let at = self.measure.is_none().then(|| format!("{} g: ", digits(self.runs.intensities[index])));
            said.into_iter()
                .map(move |line| format!("{}{line}", at.clone().unwrap_or_default()))
                .collect::<Vec<_>>()
        };
        self.suites.iter().enumerate().flat_map(of).collect()
    }

    /// What may be wrong with the answer.
    fn warnings(&self) -> Vec<String> {
        let mut said = Vec::new();
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
                "{n} of {} runs end as a storey collapses: what they reach before counts, what they would reach after does not; the state \
                 collapse counts them",
                self.runs.runs.len()
            )),
        }
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
                state.name(),
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
        let largest = factors.iter().copied().fold(0.0, f64::max);
        (beyond > 0).then(|| {
            format!(
                "{beyond} of {} runs scale a record by less than {} or more than {}, up to {}: it belongs to other earthquakes. Take records \
                 of each intensity (--stripe)",
                factors.len(),
                digits(least),
                digits(most),
                short(largest)
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
                    state.name()
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
    table.both(name, (heading, unit), move |row| Cell::exact(number(row)), move |row| number(row).map(text))
}

/// Adds how often states are reached.
fn frequencies<'a, Of: 'a>(table: Table<'a, (Of, &'a Risk)>) -> Table<'a, (Of, &'a Risk)> {
    let of = |number: fn(&AnnualFrequency) -> f64| move |row: &(Of, &Risk)| row.1.annual().map(number);
    let end = |end: usize| move |row: &(Of, &Risk)| Cell::exact(row.1.rate_bounds.map(|bounds| bounds[end]));
    let exact = |number: fn(&AnnualFrequency) -> f64| move |row: &(Of, &Risk)| Cell::exact(row.1.annual().map(number));
    let years = |years: f64| digits(years.round());
    let table = numbered(table, ["annual_frequency_per_year", "λ", "1/year"], short, of(|one| one.rate))
        .column("annual_frequency_low_per_year", end(0))
        .column("annual_frequency_high_per_year", end(1))
        .column("part_below_the_curve", exact(|one| one.beyond[0]))
        .column("part_above_the_curve", exact(|one| one.beyond[1]));
    let table = numbered(table, ["return_period_years", "Once in", "years"], years, of(AnnualFrequency::return_period));
    let in_years = of(|one| one.probability_in(YEARS));
    numbered(table, ["probability_in_50_years", "In 50 years", ""], percent, in_years)
}

/// Bounds in parentheses, after a blank; empty if there are none.
fn bounds(bounds: Option<[f64; 2]>, text: impl Fn(f64) -> String) -> String {
    bounds.map_or_else(String::new, |[low, high]| format!(" (95 %: {} to {})", text(low), text(high)))
}

/// Says why a fragility has no bounds.
fn says_without_bounds(state: State, risk: &Risk) -> Option<String> {
    let drawn = risk.drawn.as_ref()?;
    let without = drawn.draws - drawn.fragilities.len();
    drawn.bounds(|one| one.median).is_none().then(|| {
        format!(
            "{} has no bounds: {without} of {} draws of the events determine no fragility; take more events or intensities",
            state.name(),
            drawn.draws
        )
    })
}
