//! Forces of links in the steps of a method.

use std::ops::Range;

use crate::model::ground::Ground;
use crate::model::link::LinkMemory;
use crate::pushes::Pushes;
use crate::{Link, Motion, Push, RestoringForce, Row, State};

/// The forces of links, and what the links remember.
#[derive(Debug)]
pub(crate) struct LinkForces {
    memories: Vec<LinkMemory>,
    /// Force of every link at the present stage \[N\].
    forces: Vec<f64>,
    /// Net force of links on every floor at the present stage \[N\], positive to the right.
    net: Vec<f64>,
    /// Forces and impulses on the floors, link by link.
    pub(crate) pushes: Pushes,
}

impl LinkForces {
    /// The links of a row in its initial states; `None` if it has none.
    pub(crate) fn of<Column: RestoringForce>(row: &Row<Column>, states: &[State], ground: Ground<'_>) -> Option<Self> {
        if row.links().is_empty() {
            return None;
        }
        let memory = |link: &Link| {
            let ahead = link.relation.ahead(|node| states[node].displacement);
            LinkMemory::at(ahead + ground.opening_of(&link.relation).displacement)
        };
        Some(Self {
            memories: row.links().iter().map(memory).collect(),
            forces: vec![0.0; row.links().len()],
            net: vec![0.0; row.nodes().len()],
            pushes: Pushes::new(row.linking()),
        })
    }

    /// Lets the spans of all floors begin.
    pub(crate) fn go_on<Column: RestoringForce>(&mut self, row: &Row<Column>) {
        self.pushes.pass();
        for floor in 0..row.nodes().len() {
            self.pushes.go_on(row.linking().slots_at(floor));
        }
    }

    /// Ends the spans in the slots of a floor by the trapezoidal rule, each force for half a step \[s\].
    pub(crate) fn end(&mut self, slots: Range<usize>, half: f64) -> &[Push<'static>] {
        self.pushes.end(slots.clone(), half);
        self.pushes.of(slots)
    }

    /// Net force of links on a floor at the present stage \[N\].
    pub(crate) fn on(&self, floor: usize) -> f64 {
        self.net[floor]
    }

    /// Finds the forces under this motion of the floors, a time after the start of the step \[s\]. `accepts` says whether they end the step.
    pub(crate) fn pull<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        motion: impl Fn(usize) -> Motion,
        ground: Ground<'_>,
        ahead: f64,
        accepts: bool,
    ) {
        self.pushes.forget_ends();
        for (index, link) in row.links().iter().enumerate() {
            let (force, memory) = self.respond(index, link, &motion, ground, ahead);
            if accepts {
                self.memories[index] = memory;
            }
            self.act(row, index, force);
        }
        self.spread(row.links());
    }

    /// Finds the forces of dashpots again, after the velocities of some floors have jumped, and marks the floors of these links.
    pub(crate) fn jump<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        states: &[State],
        ground: Ground<'_>,
        jumped: impl Fn(usize) -> bool,
        feels: &mut [bool],
    ) {
        for (index, link) in row.links().iter().enumerate() {
            let mut floors = link.relation.pushes();
            if link.law.dashpot() <= 0.0 || !floors.any(|(floor, _)| jumped(floor)) {
                continue;
            }
            let (force, _) = self.respond(index, link, |node| (&states[node]).into(), ground, 0.0);
            self.act(row, index, force);
            for (floor, _) in link.relation.pushes() {
                feels[floor] = true;
            }
        }
        self.spread(row.links());
    }

    fn respond(&self, index: usize, link: &Link, motion: impl Fn(usize) -> Motion, ground: Ground<'_>, ahead: f64) -> (f64, LinkMemory) {
        let opening = ground.opening_of(&link.relation);
        let deformation = link.relation.ahead(|node| motion(node).displacement) + opening.displacement;
        let rate = link.relation.ahead(|node| motion(node).velocity) + opening.velocity;
        link.law.respond(deformation, rate, self.memories[index], ahead)
    }

    fn act<Column: RestoringForce>(&mut self, row: &Row<Column>, index: usize, force: f64) {
        self.forces[index] = force;
        self.pushes.set(row.linking(), index, force);
    }

    fn spread(&mut self, links: &[Link]) {
        self.net.fill(0.0);
        for (link, force) in links.iter().zip(&self.forces) {
            link.relation.spread(*force, |floor, force| self.net[floor] += force);
        }
    }
}
