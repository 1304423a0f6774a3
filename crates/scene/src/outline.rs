//! The outline of a motion in the plane: the largest response in every direction, and its percentiles over all directions.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// The convex outline of points in a plane and of their mirror images through the origin.
///
/// Its extent in a direction is the largest projection of a point without its sign. The extent has the same value in the opposite
/// direction, so half a turn of directions is enough.
pub(crate) struct Outline {
    /// Corners, from left to right above the origin; at least one.
    corners: Vec<[f64; 2]>,
}

/// Directions in which one corner has the largest projection: R cos(θ − φ).
#[derive(Clone, Copy)]
struct Arc {
    radius: f64,
    angle: f64,
    from: f64,
    to: f64,
}

/// Neighbouring directions in which corners close to each other have the largest projection.
pub(crate) struct Sector {
    /// One of the corners.
    corner: [f64; 2],
    /// First and last direction.
    ends: [[f64; 2]; 2],
}

/// Width of a sector of several corners \[rad\].
const SECTOR: f64 = 0.01;

/// Largest width of a sector of one corner \[rad\].
const WIDEST: f64 = 0.2;

/// Largest distance of adjacent corners in a sector, as a part of the largest extent \[–\].
const LONG: f64 = 0.02;

impl Sector {
    fn of(corner: [f64; 2], to: f64, from: f64) -> Self {
        let ends = [to, from].map(|angle| [libm::cos(angle), libm::sin(angle)]);
        Self { corner, ends }
    }

    /// Bounds how far a path reaches beyond the outline in this sector; negative if it stays within. The path leaves a chord between two
    /// points by at most these vectors, for either end.
    pub(crate) fn beyond(&self, chord: [[f64; 2]; 2], bends: [[f64; 2]; 2]) -> f64 {
        let along = |[x, y]: [f64; 2], point: [f64; 2]| x * point[0] + y * point[1];
        let at = |end: &[f64; 2]| {
            let reach = along(*end, chord[0]).abs().max(along(*end, chord[1]).abs());
            let bend = along(*end, bends[0]).abs().max(along(*end, bends[1]).abs());
            // The outline reaches the corner at least, in all directions of the sector.
            reach + bend - along(*end, self.corner)
        };
        at(&self.ends[0]).max(at(&self.ends[1]))
    }
}

impl Outline {
    /// Returns the outline of points.
    pub(crate) fn of(points: impl Iterator<Item = [f64; 2]>) -> Self {
        let mut all: Vec<[f64; 2]> = points.flat_map(|[x, y]| [[x, y], [-x, -y]]).collect();
        all.sort_by(|one, other| one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1])));
        let mut corners: Vec<[f64; 2]> = Vec::new();
        for point in all {
            while let Some(&last) = corners.last() {
                let turns_left = match corners.len() {
                    1 => last[0] >= point[0],
                    n => cross(corners[n - 2], last, point) >= 0.0,
                };
                if !turns_left {
                    break;
                }
                corners.pop();
            }
            corners.push(point);
        }
        if corners.is_empty() {
            corners.push([0.0, 0.0]);
        }
        Self { corners }
    }

    /// Returns the corners, whose outline is the same.
    pub(crate) fn into_corners(self) -> Vec<[f64; 2]> {
        self.corners
    }

    /// Returns the extents along the first and the second axis.
    pub(crate) fn along_axes(&self) -> [f64; 2] {
        [[1.0, 0.0], [0.0, 1.0]].map(|direction| self.along(direction))
    }

    fn along(&self, [x, y]: [f64; 2]) -> f64 {
        let projections = self.corners.iter().map(|corner| (x * corner[0] + y * corner[1]).abs());
        projections.fold(0.0, f64::max)
    }

    /// Returns the corners in few sectors of directions.
    pub(crate) fn sectors(&self) -> Vec<Sector> {
        let (mut sectors, mut open) = (Vec::new(), None);
        let long = LONG * self.corners.iter().map(|[x, y]| libm::hypot(*x, *y)).fold(0.0, f64::max);
        let last = self.corners.len() - 1;
        for (index, arc) in self.arcs().enumerate() {
            let corner = self.corners[index];
            if arc.to - arc.from > SECTOR {
                if let Some((to, first)) = open.take() {
                    sectors.push(Sector::of(first, to, arc.to));
                }
                let mut to = arc.to;
                while to > arc.from {
                    let from = (to - WIDEST).max(arc.from);
                    sectors.push(Sector::of(corner, to, from));
                    to = from;
                }
                continue;
            }
            let (to, first) = open.take().unwrap_or((arc.to, corner));
            let is_long = |next: &[f64; 2]| libm::hypot(next[0] - corner[0], next[1] - corner[1]) > long;
            if index == last || self.corners.get(index + 1).is_some_and(is_long) || to - arc.from > SECTOR {
                sectors.push(Sector::of(first, to, arc.from));
            } else {
                open = Some((to, first));
            }
        }
        sectors
    }

    /// Arcs of directions that cover half a turn, from π down to 0.
    fn arcs(&self) -> impl Iterator<Item = Arc> {
        let normal = |index: usize| {
            let [one, other] = [self.corners[index], self.corners[index + 1]];
            libm::atan2(other[0] - one[0], one[1] - other[1]).clamp(0.0, PI)
        };
        let last = self.corners.len() - 1;
        (0..=last).map(move |index| {
            let [x, y] = self.corners[index];
            let angle = libm::atan2(y, x);
            Arc {
                radius: libm::hypot(x, y),
                angle: if angle < -FRAC_PI_2 { angle + TAU } else { angle },
                from: if index == last { 0.0 } else { normal(index) },
                to: if index == 0 { PI } else { normal(index - 1) },
            }
        })
    }

    /// Returns the least extent, the median and the largest over all directions, each direction with the same weight.
    pub(crate) fn percentiles(&self) -> [f64; 3] {
        let arcs: Vec<Arc> = self.arcs().collect();
        let at = |arc: &Arc, angle: f64| (arc.radius * libm::cos(angle - arc.angle)).abs();
        // Between its ends an arc has no minimum.
        let ends = arcs.iter().flat_map(|arc| [at(arc, arc.from), at(arc, arc.to)]);
        let least = ends.fold(f64::INFINITY, f64::min);
        let most = arcs.iter().map(|arc| arc.radius).fold(0.0, f64::max);
        let half = |extent: f64| arcs.iter().map(|arc| arc.below(extent)).sum::<f64>() >= FRAC_PI_2;
        let (mut from, mut to) = (least, most);
        while to - from > 1e-14 * most {
            let middle = f64::midpoint(from, to);
            *(if half(middle) { &mut to } else { &mut from }) = middle;
        }
        [least, f64::midpoint(from, to), most]
    }
}

impl Arc {
    /// Angle of the directions of the arc in which the extent is at most this.
    fn below(&self, extent: f64) -> f64 {
        let width = (self.to - self.from).max(0.0);
        if self.radius <= extent {
            return width;
        }
        let half = libm::acos(extent / self.radius);
        let above = (self.angle + half).min(self.to) - (self.angle - half).max(self.from);
        width - above.clamp(0.0, width)
    }
}

/// Twice the area of a triangle, positive if its corners turn left.
fn cross(one: [f64; 2], other: [f64; 2], third: [f64; 2]) -> f64 {
    (other[0] - one[0]) * (third[1] - one[1]) - (other[1] - one[1]) * (third[0] - one[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn percentiles(points: &[[f64; 2]]) -> [f64; 3] {
        Outline::of(points.iter().copied()).percentiles()
    }

    fn close(found: [f64; 3], wanted: [f64; 3]) {
        for (found, wanted) in found.into_iter().zip(wanted) {
            assert!((found - wanted).abs() < 1e-12, "{found} {wanted}");
        }
    }

    /// A point at radius 1 has the extent |cos|, whose median is cos 45°.
    #[test]
    fn reference_a_line_in_any_direction() {
        for degrees in 0..360 {
            let angle = f64::from(degrees).to_radians();
            let point = [libm::cos(angle), libm::sin(angle)];
            let found = percentiles(&[point, point.map(|one| -0.3 * one), [0.0, 0.0]]);
            close(found, [0.0, 0.5_f64.sqrt(), 1.0]);
        }
    }

    /// Corners of a square of side 2: the extent is √2 cos(θ − 45°) over each quarter turn, with the median at 45° ± 22.5°.
    #[test]
    fn reference_a_square() {
        let found = percentiles(&[[1.0, 1.0], [-1.0, 1.0]]);
        close(found, [1.0, 2.0_f64.sqrt() * libm::cos(22.5_f64.to_radians()), 2.0_f64.sqrt()]);
    }

    /// A point above the middle of a square's side adds corners in its own direction alone. Angles in steps are the second route.
    #[test]
    fn limit_many_angles_lead_to_the_same_percentiles() {
        let points: Vec<[f64; 2]> = (0..500)
            .map(|index| [f64::from(index * 37 % 101) - 50.0, f64::from(index * 53 % 97) - 20.0])
            .collect();
        let outline = Outline::of(points.iter().copied());
        let n = 100_000;
        let extent = |index: i32| {
            let angle = PI * (f64::from(index) + 0.5) / f64::from(n);
            let [x, y] = [libm::cos(angle), libm::sin(angle)];
            points.iter().map(|point| (x * point[0] + y * point[1]).abs()).fold(0.0, f64::max)
        };
        let mut extents: Vec<f64> = (0..n).map(extent).collect();
        extents.sort_by(f64::total_cmp);
        let [least, median, most] = outline.percentiles();
        assert!(
            (least / extents[0] - 1.0).abs() < 1e-4 && least <= extents[0],
            "{least} {}",
            extents[0]
        );
        assert!((most / extents[99_999] - 1.0).abs() < 1e-8, "{most} {}", extents[99_999]);
        assert!((median / extents[50_000] - 1.0).abs() < 1e-5, "{median} {}", extents[50_000]);
        // No sector says that a point is beyond the outline by more than its other corners are, and no point beyond it is missed.
        let sectors = outline.sectors();
        let beyond = |point: [f64; 2]| {
            sectors
                .iter()
                .map(|one| one.beyond([point; 2], [[0.0; 2]; 2]))
                .fold(f64::NEG_INFINITY, f64::max)
        };
        for point in &points {
            assert!(beyond(*point) < 0.02 * most, "{point:?}: {}", beyond(*point));
            let angle = libm::atan2(point[1], point[0]);
            let outside = [1.001 * most * libm::cos(angle), 1.001 * most * libm::sin(angle)];
            assert!(beyond(outside) > 0.0, "{outside:?}");
        }
    }

    #[test]
    fn extreme_outlines_without_width() {
        close(percentiles(&[]), [0.0; 3]);
        close(percentiles(&[[0.0, 0.0]]), [0.0; 3]);
        close(percentiles(&[[0.0, 2.0], [0.0, -1.0]]), [0.0, 2.0_f64.sqrt(), 2.0]);
        close(percentiles(&[[2.0, 0.0]; 3]), [0.0, 2.0_f64.sqrt(), 2.0]);
    }
}
