use super::Peak;
use crate::roots::CAPACITY;
use crate::span::{Expansion, value};
use crate::turning::{reach, sign_changes};
use crate::{Impact, Path, Recorder, Series, Span};

/// Records the peak drift rate of every storey \[m/s\], to which the force of its damper is proportional.
///
/// Both ends of a span count, because velocities jump at impacts, and so does the largest value in between if the motion is known there.
#[derive(Debug, Clone, PartialEq)]
pub struct DriftRates(Vec<Peak>);

impl DriftRates {
    /// A recorder for a row of `n_nodes`, walls included.
    pub fn new(n_nodes: usize) -> Self {
        Self(vec![Peak::default(); n_nodes])
    }

    /// Peak of the storey below a floor, by the node of the floor; 0 for a wall.
    pub fn of(&self, node: usize) -> Peak {
        self.0[node]
    }
}

impl Recorder for DriftRates {
    fn span(&mut self, span: &Span<'_>) {
        let peak = &mut self.0[span.structure];
        let [start, end] = span.drifts().map(|drift| drift.velocity);
        peak.take(start, span.start_time);
        match span.path {
            Path::Cubic(_) => {}
            Path::Flight(_) => {
                let mut room = Expansion::default();
                if let Path::Series(series) = span.expanded(&mut room).path {
                    take_inside(peak, span, &series);
                }
            }
            Path::Series(series) => take_inside(peak, span, &series),
        }
        peak.take(end, span.end_time);
    }

    fn impact(&mut self, _: &Impact) {}
}

/// Updates a peak with the largest values inside a span, if its motion could exceed the peak.
fn take_inside(peak: &mut Peak, span: &Span<'_>, series: &Series<'_>) {
    let mut rates = [0.0; CAPACITY];
    let rates = &mut rates[..series.velocity.len()];
    rates.copy_from_slice(series.velocity);
    if let Some([_, below]) = series.below {
        for (rate, below) in rates.iter_mut().zip(below) {
            *rate -= below;
        }
    }
    let (first, last) = (series.x(span.start_time), span.x(*series, span.end_time));
    let most = rates.first().map_or(0.0, |rate| rate.abs()) + reach(rates.iter().skip(1).copied(), last);
    if most <= peak.value.abs() {
        return;
    }
    // In the fourth root of time the lowest power of a velocity is the fourth, and that of its rate the third: it is divided off.
    let order = series.power.order();
    let mut slopes = [0.0; CAPACITY];
    let mut len = 0;
    for (n, rate) in rates.iter().enumerate().skip(order) {
        slopes[n - order] = n as f64 * rate;
        len = n - order + 1;
    }
    sign_changes(&slopes[..len], [first, last], |x| peak.take(value(rates, x), series.time(x)));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::span::Power;
    use crate::{Motion, State};

    /// A floor at 3t² − 2t³ above a floor at rest: the rate 6t − 6t² is 1.5 m/s at half a second, and 0 at both ends. In x with t = x⁴ the
    /// result must be equal; with a floor below at 1 m/s it is 1 m/s at the ends.
    #[test]
    fn reference_the_largest_rate_inside_a_span() {
        let plain: &[f64] = &[0.0, 6.0, -6.0];
        let mut rooted = [0.0; 9];
        (rooted[4], rooted[8]) = (6.0, -6.0);
        for (power, velocity) in [(Power::One, plain), (Power::Four, &rooted[..])] {
            for (below, largest, at) in [(0.0, 1.5, 0.5), (1.0, -1.0, 0.0)] {
                let series = Series {
                    origin: 0.0,
                    power,
                    end: f64::INFINITY,
                    displacement: &[],
                    velocity,
                    acceleration: &[],
                    below: Some([&[], &[below]]),
                    restoring_force: (0.0, 0.0),
                    bent: &[],
                    force_from_left: &[],
                    force_from_right: &[],
                };
                let under = Motion {
                    velocity: below,
                    displacement: 0.0,
                };
                let mut rates = DriftRates::new(1);
                rates.span(&Span {
                    structure: 0,
                    start_time: 0.0,
                    end_time: 1.0,
                    start: State::default(),
                    end: State::default(),
                    impulse_from_left: 0.0,
                    impulse_from_right: 0.0,
                    below: Some([under; 2]),
                    pushes: &[],
                    links: &[],
                    path: Path::Series(series),
                });
                let Peak { value, time } = rates.of(0);
                assert!(
                    (value - largest).abs() < 1e-14 && (time - at).abs() < 1e-14,
                    "{power:?}: {value} {time}"
                );
            }
        }
    }
}
