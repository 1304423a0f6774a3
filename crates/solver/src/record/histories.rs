use crate::{Impact, Recorder, Span, State};

/// States of a floor at equal intervals from t = 0.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    /// The states; state i is at i · interval.
    pub states: Vec<State>,
}

/// Records the history of every floor at equal intervals, independent of the steps of the method.
///
/// If the interval equals the time step, the histories are the nodes of the method, bit for bit. If velocities jump at a recorded instant,
/// the state before the jump is kept.
#[derive(Debug, Clone, PartialEq)]
pub struct Histories {
    interval: f64,
    structures: Vec<History>,
}

/// Instants closer to the end of a span than this fraction of the interval take the end itself.
const SNAP: f64 = 1e-9;

impl Histories {
    /// A recorder for a row of `n_structures` nodes, walls included: a state every `interval` \[s\], up to `duration` \[s\].
    pub fn new(n_structures: usize, interval: f64, duration: f64) -> Self {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a capacity, not a result")]
        let capacity = (duration / interval) as usize + 2;
        let structures = vec![History { states: Vec::new() }; n_structures];
        let mut histories = Self { interval, structures };
        for history in &mut histories.structures {
            history.states.reserve_exact(capacity);
        }
        histories
    }

    /// Interval between states \[s\].
    pub fn interval(&self) -> f64 {
        self.interval
    }

    /// History of a floor, by its node.
    ///
    /// All floors of a building have common instants: the drift of a storey is the difference of two displacements.
    pub fn of(&self, structure: usize) -> &History {
        &self.structures[structure]
    }
}

impl Recorder for Histories {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        let states = &mut self.structures[span.structure].states;
        let near = SNAP * self.interval;
        loop {
            let time = states.len() as f64 * self.interval;
            if time > span.end_time + near {
                return;
            }
            states.push(if (time - span.end_time).abs() <= near {
                span.end
            } else if (time - span.start_time).abs() <= near {
                span.start
            } else {
                span.at(time)
            });
        }
    }

    fn impact(&mut self, _: &Impact) {}
}
