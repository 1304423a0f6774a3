//! Motions of one intensity, and how many of them exceed a state.

/// An event at one intensity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EventShare {
    /// Number of the event. In [`Stripes`] of the same events it is the same at all intensities.
    pub event: usize,
    /// Share of its runs that exceed the state \[–\], 0 to 1: components and directions of a record are one sample.
    pub share: f64,
}

/// Motions of one intensity.
#[derive(Debug, Clone, PartialEq)]
pub struct Stripe {
    /// Their intensity \[g\], > 0.
    pub intensity: f64,
    /// Their events, each once.
    pub events: Vec<EventShare>,
}

impl Stripe {
    /// Number of events.
    pub fn n(&self) -> usize {
        self.events.len()
    }

    /// Number of events that exceed the state; an event of several runs counts with its share.
    pub fn exceeding(&self) -> f64 {
        self.events.iter().map(|one| one.share).sum()
    }

    /// Share of events that exceed the state \[–\]; NaN without events.
    pub fn share(&self) -> f64 {
        self.exceeding() / self.n() as f64
    }
}

/// Stripes of motions.
#[derive(Debug, Clone, PartialEq)]
pub struct Stripes {
    /// The stripes, in rising order of their intensities.
    pub all: Vec<Stripe>,
    /// Whether the same events stand at all intensities, as in an incremental dynamic analysis. A resample then takes an event with all of its
    /// intensities.
    pub same_events: bool,
}

/// The counts of a stripe, on the logarithm of its intensity.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Count {
    pub(crate) log_intensity: f64,
    pub(crate) n: f64,
    pub(crate) exceeding: f64,
}

impl Stripes {
    /// Counts of the stripes that have events.
    pub(crate) fn counts(&self) -> Vec<Count> {
        let stripes = self.all.iter().filter(|stripe| stripe.n() > 0);
        let count = |stripe: &Stripe| Count {
            log_intensity: libm::log(stripe.intensity),
            n: stripe.n() as f64,
            exceeding: stripe.exceeding(),
        };
        stripes.map(count).collect()
    }
}
