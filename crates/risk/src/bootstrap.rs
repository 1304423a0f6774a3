//! Bounds of a fragility: the same fit to events that are drawn again.

use rand_pcg::Pcg64;
use rand_pcg::rand_core::Rng;

use crate::fragility::Fragility;
use crate::stripe::{Count, EventShare, Stripe, Stripes};

/// Fragilities of events that were drawn again, with replacement (B. Efron, *Ann. Stat.* 7 (1979) 1).
#[derive(Debug, Clone, PartialEq)]
pub struct Bootstrap {
    /// The fragilities of the draws that determine one.
    pub fragilities: Vec<Fragility>,
    /// Number of draws.
    pub draws: usize,
}

impl Bootstrap {
    /// Number of draws.
    pub const DRAWS: usize = 1000;

    /// Largest part of draws without a fragility for which there are bounds \[–\].
    pub const MOST_WITHOUT: f64 = 0.05;

    /// Draws the events of stripes again. The draws follow from the stripes alone: they are the same in every run and on every machine.
    pub fn of(stripes: &Stripes) -> Self {
        let mut random = Pcg64::new(SEED, STREAM);
        let known = Drawing::of(stripes);
        let draw = |_| Fragility::of_counts(&known.draw(&mut random));
        Self {
            fragilities: (0..Self::DRAWS).filter_map(draw).collect(),
            draws: Self::DRAWS,
        }
    }

    /// The 95 % bounds of a number of the fragility; `None` if too many draws determine none.
    pub fn bounds(&self, number: impl Fn(&Fragility) -> f64) -> Option<[f64; 2]> {
        let without = self.draws - self.fragilities.len();
        if without as f64 > Self::MOST_WITHOUT * self.draws as f64 {
            return None;
        }
        let mut all: Vec<f64> = self.fragilities.iter().map(number).collect();
        all.sort_by(f64::total_cmp);
        let last = all.len().checked_sub(1)?;
        // 2.5 % of all numbers lie beyond each bound.
        let beyond = all.len() / 40;
        Some([all[beyond], all[last - beyond]])
    }
}

/// Seed and stream of the draws.
const SEED: u128 = 65;
const STREAM: u128 = 1;

/// Stripes whose events are drawn.
struct Drawing {
    /// Number of events that are drawn together, with all of their intensities; `None` if they are drawn stripe by stripe.
    together: Option<usize>,
    stripes: Vec<DrawnStripe>,
}

/// The events of a stripe.
struct DrawnStripe {
    log_intensity: f64,
    /// Number of each event among all, and its share.
    events: Vec<EventShare>,
}

impl Drawing {
    fn of(stripes: &Stripes) -> Self {
        let mut all: Vec<usize> = stripes.all.iter().flat_map(|stripe| &stripe.events).map(|one| one.event).collect();
        all.sort_unstable();
        all.dedup();
        let numbered = |one: &EventShare| EventShare {
            event: all.partition_point(|event| *event < one.event),
            share: one.share,
        };
        let stripe = |one: &Stripe| DrawnStripe {
            log_intensity: libm::log(one.intensity),
            events: one.events.iter().map(numbered).collect(),
        };
        Self {
            together: stripes.same_events.then_some(all.len()),
            stripes: stripes.all.iter().map(stripe).collect(),
        }
    }

    /// The counts of one draw, without intensities that have no event in it.
    fn draw(&self, random: &mut Pcg64) -> Vec<Count> {
        let times = self.together.map(|n| {
            let mut times = vec![0.0; n];
            (0..n).for_each(|_| times[below(random, n)] += 1.0);
            times
        });
        let count = |stripe: &DrawnStripe| {
            let (mut n, mut exceeding) = (0.0, 0.0);
            for one in &stripe.events {
                let (times, share) = match &times {
                    Some(times) => (times[one.event], one.share),
                    None => (1.0, stripe.events[below(random, stripe.events.len())].share),
                };
                n += times;
                exceeding += times * share;
            }
            let log_intensity = stripe.log_intensity;
            (n > 0.0).then_some(Count {
                log_intensity,
                n,
                exceeding,
            })
        };
        self.stripes.iter().filter_map(count).collect()
    }
}

/// A whole number below `n` > 0: the upper half of a product, whose bias is n/2⁶⁴.
fn below(random: &mut Pcg64, n: usize) -> usize {
    let product = u128::from(random.next_u64()) * n as u128;
    usize::try_from(product >> u64::BITS).unwrap_or(0)
}
