//! Forces of links in the steps of a method.

use crate::model::ground::Ground;
use crate::model::link::LinkMemory;
use crate::pushes::Pushes;
use crate::{Link, RestoringForce, Row, State};

/// The forces of links, and what the links remember.
#[derive(Debug)]
pub(crate) struct LinkForces {
    memories: Vec<LinkMemory>,
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
            net: vec![0.0; row.nodes().len()],
            pushes: Pushes::new(row.linking()),
        })
    }

    /// Net force of links on a floor at the present stage \[N\].
    pub(crate) fn on(&self, floor: usize) -> f64 {
        self.net[floor]
    }

    /// Finds the forces in these states, a time after the start of the step \[s\]. `accepts` says whether they end the step.
    pub(crate) fn pull<Column: RestoringForce>(
        &mut self,
        row: &Row<Column>,
        states: &[State],
        ground: Ground<'_>,
        ahead: f64,
        accepts: bool,
    ) {
        self.pushes.forget_ends();
        self.net.fill(0.0);
        for (index, link) in row.links().iter().enumerate() {
            let opening = ground.opening_of(&link.relation);
            let deformation = link.relation.ahead(|node| states[node].displacement) + opening.displacement;
            let rate = link.relation.ahead(|node| states[node].velocity) + opening.velocity;
            let (force, memory) = link.law.respond(deformation, rate, self.memories[index], ahead);
            if accepts {
                self.memories[index] = memory;
            }
            self.pushes.set(row.linking(), index, force);
            link.relation.spread(force, |floor, force| self.net[floor] += force);
        }
    }
}
