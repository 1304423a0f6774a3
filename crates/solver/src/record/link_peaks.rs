//! Peaks of links.

use crate::{Impact, Link, LinkLaw, Peak, Push, Recorder, Relation, Span, Travel};

/// Largest values of a link, each of one sign.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct LinkPeak {
    /// Largest push \[N\], ≥ 0.
    pub push: Peak,
    /// Largest pull \[N\], as a negative force; ≤ 0.
    pub pull: Peak,
    /// Largest shortening \[m\], ≥ 0.
    pub shortening: Peak,
    /// Largest elongation \[m\], as a negative deformation; ≤ 0.
    pub elongation: Peak,
}

impl LinkPeak {
    /// The larger of shortening and elongation, with its sign \[m\].
    pub fn deformation(&self) -> Peak {
        let longer = self.elongation.value.abs() > self.shortening.value;
        if longer { self.elongation } else { self.shortening }
    }
}

/// Records forces and deformations of links. A method that finds instants ends its pieces at their extremes; a step knows its ends.
#[derive(Debug, Clone, PartialEq)]
pub struct LinkPeaks {
    links: Vec<Record>,
    /// How the motion travels along the row; `None` if all are shaken at once.
    travel: Option<Travel>,
}

/// A link, with instants and displacements of each end at the start and at the end of its latest piece.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Record {
    relation: Relation,
    /// Whether it can push both ends apart.
    pushes: bool,
    ends: [[(f64, f64); 2]; 2],
    peak: LinkPeak,
}

impl LinkPeaks {
    /// A recorder for these links of a row.
    pub fn new(links: &[Link]) -> Self {
        let record = |link: &Link| Record {
            relation: link.relation,
            pushes: !matches!(link.law, LinkLaw::Restrainer(_)),
            ends: [[(f64::NEG_INFINITY, 0.0); 2]; 2],
            peak: LinkPeak::default(),
        };
        Self {
            links: links.iter().map(record).collect(),
            travel: None,
        }
    }

    /// The recorder for a motion that travels along the row.
    #[must_use]
    pub fn travelled(self, travel: Option<Travel>) -> Self {
        Self { travel, ..self }
    }

    /// Peaks of every link, in the order of the row.
    pub fn all(&self) -> impl Iterator<Item = LinkPeak> {
        self.links.iter().map(|one| one.peak)
    }

    /// Peaks of a link, by its index in the row.
    pub fn of(&self, link: usize) -> LinkPeak {
        self.links[link].peak
    }

    fn book(&mut self, span: &Span<'_>, push: &Push<'_>) {
        let record = &mut self.links[push.pair];
        let peak = &mut record.peak;
        for (force, time) in push.forces.into_iter().zip([span.start_time, span.end_time]) {
            // At the end of a pull the force is zero but for rounding.
            if force > 0.0 && !record.pushes {
                continue;
            }
            let side = if force > 0.0 { &mut peak.push } else { &mut peak.pull };
            side.take(force, time);
        }
        let own = usize::from(!push.on_left);
        record.ends[own] = [(span.start_time, span.start.displacement), (span.end_time, span.end.displacement)];
        let points = record.relation.points();
        let is_fixed = points[1 - own].parts().next().is_none();
        let nodes = points.map(crate::Point::floor);
        for instant in 0..2 {
            let time = record.ends[own][instant].0;
            // The other end of a link is in the same body, so that both are known at the ends of its pieces.
            if is_fixed || record.ends[1 - own][instant].0.total_cmp(&time).is_eq() {
                let travel = self.travel.as_ref();
                let opening = travel.map_or(0.0, |travel| travel.opening(nodes, time).displacement);
                let [left, right] = record.ends.map(|end| end[instant].1);
                let deformation = left - right + opening;
                let side = if deformation > 0.0 {
                    &mut peak.shortening
                } else {
                    &mut peak.elongation
                };
                side.take(deformation, time);
            }
        }
    }
}

impl Recorder for LinkPeaks {
    #[inline]
    fn span(&mut self, span: &Span<'_>) {
        for push in span.links {
            self.book(span, push);
        }
    }

    fn impact(&mut self, _: &Impact) {}
}
