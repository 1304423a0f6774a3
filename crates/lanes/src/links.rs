//! Links between structures in lanes: springs, which may yield, and dashpots.

use fearless_simd::Simd;
use pounding_contact::Number;

use super::body::Body;
use super::column::SideBySideColumn;
use super::number::{Lanes, MOST_LANES, Mask};
use super::points::LaneRelation;
use super::rows::Rows;
use pounding_solver::formulas::Coefficients;
use pounding_solver::{Bilinear, Link, LinkLaw, RestoringForce, Spring};

/// A spring and a dashpot side by side, in every scene.
pub(super) struct LaneLink<S: Simd> {
    relation: LaneRelation<S>,
    spring: <Bilinear as SideBySideColumn>::Beside<Lanes<S>>,
    damping: Lanes<S>,
    /// Plastic deformation \[m\], and deformation at the present node.
    plastic: Lanes<S>,
    deformation: Lanes<S>,
    /// Force at the present node \[N\].
    force: Lanes<S>,
}

/// The spring of a link, if lanes can run it.
pub(super) fn spring(link: &Link) -> Option<Spring> {
    if let LinkLaw::Spring(spring) = link.law {
        Some(spring)
    } else {
        None
    }
}

impl<S: Simd> LaneLink<S> {
    /// A link of rows of a common shape, by its index in them; `place` gives the place of a node's structure.
    #[inline(always)]
    pub(super) fn new<Column: SideBySideColumn>(simd: S, rows: Rows<'_, Column>, index: usize, place: impl Fn(usize) -> usize) -> Self {
        let links: [&Link; MOST_LANES] = std::array::from_fn(|lane| &rows.lane(lane).links()[index]);
        let gather = |number: &dyn Fn(&Spring) -> f64| Lanes::new(simd, &links.map(|link| spring(link).map_or(f64::NAN, |it| number(&it))));
        let zero = Lanes::splat(simd, 0.0);
        Self {
            relation: LaneRelation::new(simd, &links.map(|link| link.relation), place),
            spring: Bilinear::beside(|number| gather(&|spring| number(&spring.alone()))),
            damping: gather(&|spring| spring.damping),
            plastic: zero,
            deformation: zero,
            force: zero,
        }
    }

    /// The force at the present deformation and a rate \[m/s\]; the spring remembers it.
    #[inline(always)]
    fn respond(&mut self, rate: Lanes<S>) -> Lanes<S> {
        let response = self.spring.respond(self.deformation, self.plastic);
        self.plastic = response.memory;
        response.force + self.damping * rate
    }
}

/// Gives all structures the forces of their links at a node, in which they have these velocities \[m/s\].
#[inline(always)]
fn pull<S: Simd, Column: RestoringForce<Lanes<S>>>(
    links: &mut [LaneLink<S>],
    structures: &mut [Body<S, Column>],
    velocity: impl Fn(&Body<S, Column>) -> Lanes<S>,
) {
    // All keep the state from which velocities jump, because a link may pass a jump on to any of them.
    for structure in structures.iter_mut() {
        structure.contact.come_near();
    }
    for link in links.iter_mut() {
        // A run alone adds the opening of the grounds, which is 0.
        let zero = link.force.like(0.0);
        link.deformation = link.relation.ahead(|place| structures[place].motion.displacement) + zero;
        let rate = link.relation.ahead(|place| velocity(&structures[place])) + zero;
        link.force = link.respond(rate);
    }
    spread(links, structures);
}

/// Gives all structures the forces of their links at t = 0.
#[inline(always)]
pub(super) fn begin<S: Simd, Column: RestoringForce<Lanes<S>>>(links: &mut [LaneLink<S>], structures: &mut [Body<S, Column>]) {
    pull(links, structures, |structure| structure.contact.at_node.velocity);
}

/// Gives all structures the forces of their links before the step from a node.
#[inline(always)]
pub(super) fn pull_at_node<S: Simd, Column: RestoringForce<Lanes<S>>>(
    links: &mut [LaneLink<S>],
    structures: &mut [Body<S, Column>],
    time_step: f64,
) {
    pull(links, structures, |structure| {
        Coefficients::extrapolated(time_step, structure.motion.increments())
    });
}

/// Finds the forces of dashpots again in the lanes in which an end has jumped.
#[inline(always)]
pub(super) fn jump<S: Simd, Column: RestoringForce<Lanes<S>>>(links: &mut [LaneLink<S>], structures: &mut [Body<S, Column>]) {
    let Some(first) = links.first() else {
        return;
    };
    let zero = first.force.like(0.0);
    for structure in structures.iter_mut() {
        structure.contact.relinked = zero.exceeds(zero);
    }
    for link in links.iter_mut() {
        let mut jumped = zero.exceeds(zero);
        link.relation
            .each_place(|place| jumped = jumped | structures[place].contact.at_node.jumps());
        let feels: Mask<S> = jumped & link.damping.exceeds(zero);
        if !Lanes::any(feels) {
            continue;
        }
        let rate = link.relation.ahead(|place| structures[place].contact.at_node.jumped) + zero;
        let force = link.respond(rate);
        link.force = Number::select(feels, force, link.force);
        link.relation.each_place(|place| {
            let relinked = &mut structures[place].contact.relinked;
            *relinked = *relinked | feels;
        });
    }
    spread(links, structures);
}

#[inline(always)]
fn spread<S: Simd, Column: RestoringForce<Lanes<S>>>(links: &[LaneLink<S>], structures: &mut [Body<S, Column>]) {
    for structure in structures.iter_mut() {
        structure.contact.link_force = structure.contact.link_force.like(0.0);
    }
    for link in links {
        link.relation.spread(link.force, |place, on_left, force| {
            let contact = &mut structures[place].contact;
            contact.link_force = if on_left {
                contact.link_force - force
            } else {
                contact.link_force + force
            };
        });
    }
}
