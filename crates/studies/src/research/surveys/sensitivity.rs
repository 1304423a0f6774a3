//! Sensitivity: the share that each input has in the variance of impulse and drifts, by itself and together with other inputs.
//!
//! The shares are Sobol' indices from two matrices of samples and one more per input, whose column of that input comes from the other
//! matrix (A. Saltelli et al., *Comput. Phys. Commun.* 181 (2010) 259). First-order indices follow their Table 2 (b), total indices M. J.
//! W. Jansen (*Comput. Phys. Commun.* 117 (1999) 35). Samples are a Sobol' sequence; their uncertainty comes from a bootstrap over rows.

use super::cases::{Case, rows, sdof, with_gap};
use crate::files::{Files, capital, drawn};
use crate::statistics::{quantile, sorted};
use crate::study::surveys::Sensitivity;
use crate::{StudyError, StudyFile};
use pounding_contact::{Calibration, FreePair, LawName};
use pounding_plot::{Axis, Curve, CurveKind, Figure, Mark, Panel, Shade};
use pounding_scene::{Damping, Scene, parallel};
use pounding_text::Table;
use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;
use sobol::Sobol;
use sobol::params::JoeKuoD6;

/// Names of the inputs, in the order of the coordinates of a sample.
const INPUTS: [&str; 7] = [
    "gap",
    "restitution e",
    "impact stiffness",
    "damping ratio",
    "direction",
    "intensity",
    "motion",
];
const N_INPUTS: usize = INPUTS.len();
/// Names of the outputs of a run.
const OUTPUTS: [&str; 4] = ["total impulse", "peak force", "drift of the first", "drift of the second"];
const N_OUTPUTS: usize = OUTPUTS.len();

type Sample = [f64; N_INPUTS];
type Output = [f64; N_OUTPUTS];

/// Runs of one row of the matrices: of both matrices, and of the first with each input taken from the second.
#[derive(Debug, Clone)]
struct SampleRuns {
    a: Output,
    b: Output,
    mixed: [Output; N_INPUTS],
}

/// Shares of an input in the variance of an output, by itself and in total, with mean and deviation of the output.
struct Share {
    output: &'static str,
    input: &'static str,
    mean: f64,
    deviation: f64,
    indices: [Index; 2],
}

/// An index with its 95 % bounds.
#[derive(Debug, Clone, Copy)]
struct Index {
    value: f64,
    bounds: (f64, f64),
}

pub(super) fn files(settings: &Sensitivity, file: &StudyFile, cases: &[Case]) -> Result<Files, StudyError> {
    let template = &rows(file, 2)?[0];
    // The two directions of a motion follow each other.
    let n_motions = if settings.vary_motion { cases.len() / 2 } else { 1 };
    let asked = SampledScene {
        settings,
        template,
        cases: &cases[..2 * n_motions],
    };
    let rows = parallel::try_each(&samples(settings.samples), |(a, b)| asked.row(a, b))?;
    let inputs: Vec<usize> = (0..N_INPUTS)
        .filter(|input| settings.vary_motion || INPUTS[*input] != "motion")
        .collect();
    let found: Vec<Vec<Share>> = (0..N_OUTPUTS)
        .map(|output| shares(&rows, &inputs, output, settings.bootstrap))
        .collect();
    Ok(Files::from([
        ("indices.png".into(), drawn(&figure(&found), &file.path)?),
        ("indices.csv".into(), table(rows.len(), found.into_iter().flatten()).into_bytes()),
    ]))
}

/// Rows of both matrices. Each is one point of a sequence, cut in half; the first point, the corner 0, is left out.
fn samples(count: usize) -> Vec<(Sample, Sample)> {
    let sequence = Sobol::<f64>::new(2 * N_INPUTS, &JoeKuoD6::minimal());
    let half = |point: &[f64]| std::array::from_fn(|input| point[input]);
    let both = |point: Vec<f64>| (half(&point[..N_INPUTS]), half(&point[N_INPUTS..]));
    sequence.skip(1).take(count).map(both).collect()
}

struct SampledScene<'a> {
    settings: &'a Sensitivity,
    template: &'a Scene,
    cases: &'a [Case],
}

impl SampledScene<'_> {
    fn row(&self, a: &Sample, b: &Sample) -> Result<SampleRuns, StudyError> {
        let mut mixed = [[0.0; N_OUTPUTS]; N_INPUTS];
        let of_a = self.run(a)?;
        for (input, output) in mixed.iter_mut().enumerate() {
            let mut sample = *a;
            sample[input] = b[input];
            *output = if self.is_same(a, &sample) { of_a } else { self.run(&sample)? };
        }
        Ok(SampleRuns {
            a: of_a,
            b: self.run(b)?,
            mixed,
        })
    }

    /// Whether both samples give one scene under one motion and direction.
    fn is_same(&self, one: &Sample, other: &Sample) -> bool {
        let continuous = 0..4;
        let alike = |input: usize| one[input].total_cmp(&other[input]).is_eq();
        continuous.chain(5..6).all(alike) && self.case(one) == self.case(other)
    }

    /// Index of the motion and direction.
    fn case(&self, sample: &Sample) -> usize {
        let n_motions = self.cases.len() / 2;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to the number of motions")]
        let motion = ((sample[6] * n_motions as f64) as usize).min(n_motions - 1);
        2 * motion + usize::from(sample[4] >= 0.5)
    }

    fn run(&self, sample: &Sample) -> Result<Output, StudyError> {
        let [gap, restitution, stiffness, damping, _, intensity, _] = *sample;
        let settings = self.settings;
        let law = LawName::NonlinearViscoelastic.calibrated(
            settings.impact_stiffness_n_per_m1_5.log_uniform(stiffness),
            settings.restitution.uniform(restitution),
            Calibration::Exact,
            &FreePair::UNIT,
        );
        let law = law.expect("the study gives stiffnesses and restitutions in range");
        let mut scene = with_gap(self.template, settings.gap_m.uniform(gap));
        for contact in scene.contacts.iter_mut().flatten() {
            contact.law = law;
        }
        for index in 0..2 {
            let ratio = settings.damping_ratio.uniform(damping);
            sdof(&mut scene, index).damping = Damping::Ratio(ratio);
        }
        let case = self.cases[self.case(sample)].scaled(settings.intensity.uniform(intensity))?;
        let response = case.run(&scene)?;
        Ok([response.impulse, response.force, response.peaks[0], response.peaks[1]])
    }
}

fn square(value: f64) -> f64 {
    value * value
}

/// First-order and total index of an input for an output, estimated from some rows.
fn estimate(rows: &[&SampleRuns], input: usize, output: usize) -> [f64; 2] {
    let n = rows.len() as f64;
    let both = rows.iter().flat_map(|row| [row.a[output], row.b[output]]);
    let mean = both.clone().sum::<f64>() / (2.0 * n);
    let variance = both.map(|value| square(value - mean)).sum::<f64>() / (2.0 * n);
    let mut sums = [0.0, 0.0];
    for row in rows {
        let (a, b, mixed) = (row.a[output], row.b[output], row.mixed[input][output]);
        // Subtracting the mean leaves the expected sum unchanged and reduces its noise.
        sums[0] += (b - mean) * (mixed - a);
        sums[1] += 0.5 * square(a - mixed);
    }
    sums.map(|sum| if variance > 0.0 { sum / n / variance } else { 0.0 })
}

/// Both indices with the bounds of the bootstrap.
fn indices(rows: &[SampleRuns], input: usize, output: usize, repetitions: usize) -> [Index; 2] {
    let all: Vec<&SampleRuns> = rows.iter().collect();
    let values = estimate(&all, input, output);
    let mut random = Pcg64::new(1, 2);
    let mut repeated: [Vec<f64>; 2] = Default::default();
    for _ in 0..repetitions {
        let draw = |_| {
            let n = rows.len() as u64;
            &rows[usize::try_from(random.next_u64() % n).expect("less than a usize")]
        };
        let drawn: Vec<&SampleRuns> = (0..rows.len()).map(draw).collect();
        let again = estimate(&drawn, input, output);
        for (all, one) in repeated.iter_mut().zip(again) {
            all.push(one);
        }
    }
    let bound = |all: &[f64], part| quantile(all, part).unwrap_or(f64::NAN);
    let repeated = repeated.map(|all| sorted(all.into_iter()));
    [0, 1].map(|order| Index {
        value: values[order],
        bounds: (bound(&repeated[order], 0.025), bound(&repeated[order], 0.975)),
    })
}

/// Shares of every input in the variance of an output.
fn shares(rows: &[SampleRuns], inputs: &[usize], output: usize, repetitions: usize) -> Vec<Share> {
    let values: Vec<f64> = rows.iter().flat_map(|row| [row.a[output], row.b[output]]).collect();
    let n = values.len() as f64;
    let mean = values.iter().sum::<f64>() / n;
    let variance = values.iter().map(|value| square(value - mean)).sum::<f64>() / n;
    let share = |input: &usize| Share {
        output: OUTPUTS[output],
        input: INPUTS[*input],
        mean,
        deviation: variance.sqrt(),
        indices: indices(rows, *input, output, repetitions),
    };
    inputs.iter().map(share).collect()
}

/// Table with one row per output and input.
fn table(samples: usize, shares: impl Iterator<Item = Share>) -> String {
    let mut table = Table::of(shares)
        .column("output", |one| one.output)
        .column("input", |one| one.input)
        .column("samples", |_| samples)
        .column("mean", |one| one.mean)
        .column("standard_deviation", |one| one.deviation);
    for (order, key) in ["first_order", "total"].into_iter().enumerate() {
        table = table
            .column(key, move |one| one.indices[order].value)
            .column(format!("{key}_from"), move |one| one.indices[order].bounds.0)
            .column(format!("{key}_to"), move |one| one.indices[order].bounds.1);
    }
    table.csv()
}

/// Looks of both indices in the figure, with their distance from the line of their input.
const LOOKS: [(&str, Shade, Mark, f64); 2] = [
    ("alone (first order)", Shade::Blue, Mark::Disc, -0.16),
    ("with all others (total)", Shade::Vermilion, Mark::Square, 0.16),
];

/// Figure with one panel per output. Every input has a bar up to its first-order index and a mark at its total index, both with bounds.
fn figure(found: &[Vec<Share>]) -> Figure {
    let panel = |shares: &Vec<Share>| {
        let mut curves = Vec::new();
        for (order, (name, shade, mark, aside)) in LOOKS.into_iter().enumerate() {
            let mut points = Vec::new();
            for (line, share) in shares.iter().enumerate() {
                let (Index { value, bounds }, y) = (share.indices[order], line as f64 + aside);
                let span = [bounds.0, bounds.1].map(|bound| (bound.clamp(0.0, 1.0), y));
                curves.push(Curve::new(CurveKind::Line, shade, span.into()));
                points.push((value.clamp(0.0, 1.0), y));
            }
            curves.push(Curve::new(CurveKind::Points, shade, points).marked(mark).named(name));
        }
        let names = shares.iter().map(|share| share.input.into());
        Panel::shared(capital(shares[0].output), Axis::names(names.collect()), curves)
    };
    let x = Axis::over("Share of the variance (–)", 0.0, 1.0);
    Figure::grid(5.2, 2, x, found.iter().map(panel).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Indices of y = x₁ + 2 x₂ + x₁ x₃ against their closed form. With x uniform on 0 to 1 the variances are V₁ = 1.5²/12, V₂ = 4/12, V₃ =
    /// 0.5²/12 and V₁₃ = 1/144.
    #[test]
    fn reference_indices_of_a_polynomial() {
        let of = |sample: &Sample| {
            let mut output = [0.0; N_OUTPUTS];
            output[0] = sample[0] + 2.0 * sample[1] + sample[0] * sample[2];
            output
        };
        let row = |(a, b): &(Sample, Sample)| {
            let mixed = std::array::from_fn(|input| {
                let mut sample = *a;
                sample[input] = b[input];
                of(&sample)
            });
            SampleRuns { a: of(a), b: of(b), mixed }
        };
        let rows: Vec<SampleRuns> = samples(4096).iter().map(row).collect();
        let rows: Vec<&SampleRuns> = rows.iter().collect();
        let parts = [2.25 / 12.0, 4.0 / 12.0, 0.25 / 12.0, 0.0];
        let both = [1.0 / 144.0, 0.0, 1.0 / 144.0, 0.0];
        let whole: f64 = parts.iter().sum::<f64>() + 1.0 / 144.0;
        for input in 0..parts.len() {
            let [first, total] = estimate(&rows, input, 0);
            let wanted = [parts[input] / whole, (parts[input] + both[input]) / whole];
            assert!((first - wanted[0]).abs() < 5e-3, "{input}: {first} {wanted:?}");
            assert!((total - wanted[1]).abs() < 5e-3, "{input}: {total} {wanted:?}");
        }
    }
}
