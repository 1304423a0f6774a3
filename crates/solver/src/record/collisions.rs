use crate::sum::Sum;
use crate::{Impact, Pair, Path, Point, Push, Recorder, Span, Touch, Travel};

/// A contact of a pair, from touch to parting. For an impulsive law: an impact with the rest that follows it.
///
/// A clamped law may release a pair and push again before it has parted; this is still the same collision. An impact after which the
/// neighbours stay together counts once: its impulse includes that of the rest, and its end is their parting. Bounces are separate
/// collisions; the last bounce includes the rest after it. An impact that neighbours at rest pass on is also separate.
///
/// A stepping method has no rest, but an impact in every step of it. With e = 0, impacts at the ends of successive steps are a single
/// collision. With e > 0 each of them is a bounce, and a meeting may consist of several.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Collision {
    /// Index of the pair in its row.
    pub pair: usize,
    /// First instant with a pounding force, or the instant of the impact \[s\].
    pub start: f64,
    /// Uncertainty of the start by rounding \[s\], as in [`Touch::uncertainty`](Touch#structfield.uncertainty). `None` if no gap closed at
    /// the start, and for a stepping method, which finds the start to a step.
    pub uncertainty: Option<f64>,
    /// Rate of deformation at the start v₀ \[m/s\], ≥ 0; `None` if a compliant pair did not approach, and for a stepping method, which does
    /// not find it.
    pub approach_speed: Option<f64>,
    /// Last instant with a pounding force, or that of the last impact \[s\].
    pub end: f64,
    /// Peak pounding force \[N\]; `None` for an impulsive impact, whose force is unbounded, with or without rest.
    pub peak_force: Option<f64>,
    /// First instant of the peak force \[s\], to a step for a stepping method; `None` for an impulsive impact.
    pub peak_force_time: Option<f64>,
    /// Impulse ∫F dt \[N·s\].
    pub impulse: f64,
}

/// Records the collisions of every pair, in the order in which they begin.
#[derive(Debug, Clone, PartialEq)]
pub struct Collisions {
    /// For each node, end and displacement of its last two spans, the last span first. The spans of two neighbours may arrive in either
    /// order.
    seen: Vec<[(f64, f64); 2]>,
    pairs: Vec<Pair>,
    /// How the ground motion travels; `None` if all are shaken at once.
    travel: Option<Travel>,
    /// For each pair, its present collision, or the impact that a rest may follow.
    open: Vec<Option<Open>>,
    /// Whether the run is by a stepping method.
    steps: bool,
    /// The last touch of every pair.
    touches: Vec<Option<Touch>>,
    /// Whether there was any touch.
    is_touched: bool,
    found: Vec<Collision>,
}

/// A collision in progress.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Open {
    /// Its index among the found collisions.
    index: usize,
    /// Its impulse so far. The rounding of the pieces of the exact method is kept as well; lanes of stepping methods do not need it.
    impulse: Sum,
}

impl Collisions {
    /// A recorder for a row of `n_structures` nodes, walls included, with these pairs of any level.
    pub fn new(n_structures: usize, pairs: &[Pair]) -> Self {
        Self {
            seen: vec![[(0.0, 0.0); 2]; n_structures],
            pairs: pairs.to_vec(),
            travel: None,
            open: vec![None; pairs.len()],
            steps: false,
            touches: vec![None; pairs.len()],
            is_touched: false,
            found: Vec::new(),
        }
    }

    /// Records on ground along which the excitation [travels](crate::Row::travel).
    #[must_use]
    pub fn travelled(self, travel: Option<Travel>) -> Self {
        Self { travel, ..self }
    }

    /// The collisions of all pairs.
    pub fn all(&self) -> &[Collision] {
        &self.found
    }

    /// Whether the neighbours of a pair overlap at the start of the span.
    ///
    /// If either was not seen at that instant, they are apart: touching neighbours are followed at common instants.
    fn overlaps(&self, pair: usize, span: &Span<'_>) -> bool {
        let relation = &self.pairs[pair].relation;
        let start = span.start_time;
        let then = |floor: usize| {
            if floor == span.structure {
                return Some(span.start.displacement);
            }
            let mut ends = self.seen[floor].into_iter();
            let end = ends.find(|(time, _)| time.total_cmp(&start).is_eq());
            end.map(|(_, displacement)| displacement)
        };
        if !relation.pushes().all(|(floor, _)| then(floor).is_some()) {
            return false;
        }
        let ahead = relation.ahead(|floor| then(floor).unwrap_or(0.0));
        let ahead = match &self.travel {
            None => ahead,
            Some(travel) => {
                let nodes = relation.points().map(Point::floor);
                ahead + travel.opening(nodes, start).displacement
            }
        };
        ahead - relation.offset > 0.0
    }

    /// Adds the action of a pair over a span of the floor on its left.
    fn push(&mut self, span: &Span<'_>, push: &Push<'_>) {
        let pair = push.pair;
        let [start, end] = push.forces;
        let nothing = push.is_none();
        let begins = start == 0.0 && end > 0.0;
        let ends = |open: Open| {
            if !self.pairs[pair].law.is_compliant() {
                // In the exact method a rest follows an impact at once. In a stepping method the step after the impact shows it at its end.
                let end = self.found[open.index].end;
                return nothing && !(self.steps && span.start_time <= end);
            }
            // A clamped force releases neighbours that still overlap. Others have parted, and may touch again at once.
            (nothing || begins) && !self.overlaps(pair, span)
        };
        if self.open[pair].is_some_and(ends) {
            self.open[pair] = None;
        }
        if nothing {
            return;
        }
        let mut open = match self.open[pair] {
            Some(open) => open,
            None => self.begin(pair, span, start),
        };
        if self.steps {
            open.impulse.value += push.impulse;
        } else {
            open.impulse = open.impulse.plus(push.impulse);
        }
        self.open[pair] = Some(open);
        let collision = &mut self.found[open.index];
        collision.impulse = open.impulse.rounded();
        if end > 0.0 || !matches!(span.path, Path::Cubic(_)) {
            collision.end = span.end_time;
        }
        // Some methods push only between the ends, others push once more after parting: only the mean force is known.
        let known = if start == 0.0 && end == 0.0 && span.duration() > 0.0 {
            push.impulse / span.duration()
        } else {
            end
        };
        // A floor that is hit presses a damped neighbour harder at once, so that the force jumps between two spans.
        for (force, time) in [(start, span.start_time), (known, span.end_time)] {
            if collision.peak_force.is_some_and(|peak| force > peak) {
                (collision.peak_force, collision.peak_force_time) = (Some(force), Some(time));
            }
        }
    }

    /// A pair begins to press with this force in a span.
    fn begin(&mut self, pair: usize, span: &Span<'_>, force: f64) -> Open {
        let first = match span.path {
            // A step has only its nodes.
            Path::Cubic(_) if force == 0.0 => span.end_time,
            Path::Cubic(_) | Path::Series(_) | Path::Flight(_) => span.start_time,
        };
        self.found.push(Collision {
            pair,
            start: first,
            uncertainty: self.uncertainty(first),
            approach_speed: self.touches[pair]
                .filter(|touch| touch.begins(first))
                .map(|touch| touch.approach_speed),
            end: first,
            peak_force: Some(force),
            peak_force_time: Some(first),
            impulse: 0.0,
        });
        Open {
            index: self.found.len() - 1,
            impulse: Sum::default(),
        }
    }

    /// Uncertainty of a start at this instant: a touch may cause an impact of the next pair.
    fn uncertainty(&self, start: f64) -> Option<f64> {
        // Steps report no touches, and a long row has many collisions at a time.
        if !self.is_touched {
            return None;
        }
        let touches = self.touches.iter().flatten();
        touches
            .filter(|touch| touch.begins(start))
            .map(|touch| touch.uncertainty)
            .reduce(f64::max)
    }
}

impl Recorder for Collisions {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        let seen = &mut self.seen[span.structure];
        *seen = [(span.end_time, span.end.displacement), seen[0]];
        self.steps = matches!(span.path, Path::Cubic(_));
        for push in span.pushes {
            if push.is_none() && self.open[push.pair].is_none() {
                continue;
            }
            if push.on_left && self.pairs[push.pair].left() == span.structure {
                self.push(span, push);
            }
        }
    }

    fn impact(&mut self, impact: &Impact) {
        let pair = impact.pair;
        // Each step of a rest has an impact.
        let rests = self.steps && is_plastic(&self.pairs[pair]);
        if let Some(open) = self.open[pair].as_mut().filter(|_| rests) {
            let collision = &mut self.found[open.index];
            open.impulse.value += impact.impulse;
            collision.impulse = open.impulse.rounded();
            collision.end = impact.time;
            return;
        }
        self.open[pair] = Some(Open {
            index: self.found.len(),
            impulse: Sum::default().plus(impact.impulse),
        });
        self.found.push(Collision {
            pair,
            start: impact.time,
            uncertainty: self.uncertainty(impact.time),
            approach_speed: Some(impact.rates()[0].max(0.0)),
            end: impact.time,
            peak_force: None,
            peak_force_time: None,
            impulse: impact.impulse,
        });
    }

    fn touch(&mut self, touch: &Touch) {
        // The open collision ended within the rounding of the displacements.
        self.open[touch.pair] = None;
        self.touches[touch.pair] = Some(*touch);
        self.is_touched = true;
    }
}

/// Whether neighbours stay together after an impact: e = 0.
pub fn is_plastic(pair: &Pair) -> bool {
    let law = pair.law.impulsive();
    law.is_some_and(|law| law.restitution == 0.0)
}

impl Touch {
    /// Whether the touch is at exactly this instant.
    fn begins(&self, start: f64) -> bool {
        self.time.total_cmp(&start).is_eq()
    }
}
