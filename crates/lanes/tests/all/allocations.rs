//! A step in lanes allocates nothing.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use pounding_lanes::{RowsOf, SceneSums, SideBySide};
use pounding_solver::{Elastic, Excitation, Floor, Node, Row};

use crate::common::{STEREOMECHANICAL, VISCOELASTIC, clock, ground, pairs};
use crate::steps::SETTINGS;

/// The system's allocator with a counter.
struct Counting;

thread_local! {
    /// Allocations of this thread; other tests run in other threads.
    pub(crate) static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

#[expect(unsafe_code, reason = "an allocator is unsafe by nature; this one only counts")]
// SAFETY: every call goes to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        // SAFETY: the caller's promise is passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        // SAFETY: the caller's promise is passed on.
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Allocations of this thread so far.
pub(crate) fn allocations() -> usize {
    ALLOCATIONS.get()
}

#[test]
fn limit_a_step_side_by_side_allocates_nothing() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    // Number of storeys of every structure, and number of structures.
    let shapes = [(1, 5), (1, 2), (1, 3), (3, 2)];
    let laws = [STEREOMECHANICAL, VISCOELASTIC];
    for ((storeys, n), law) in shapes.into_iter().flat_map(|one| laws.map(|law| (one, law))) {
        let row = |scene: usize| {
            let node = |index: usize| {
                let stiffness = 2e6 * (1.0 + 2.0 * (index % 2) as f64 + 0.05 * scene as f64);
                let node = Node::structure(1e5, 2e4, Elastic { stiffness });
                let on_floor = |below| {
                    node.on_floor(Floor {
                        below,
                        ground_damping: 1e4,
                    })
                };
                index.checked_sub(n).map_or(node, on_floor)
            };
            let mut all = pairs(n * storeys, 0.002, law);
            all.retain(|pair| pair.right() % n > 0);
            Row::new((0..n * storeys).map(node).collect(), all).unwrap()
        };
        let rows: Vec<_> = (0..9).map(row).collect();
        let rows: Vec<_> = rows.iter().collect();
        let beside = SideBySide::new(SETTINGS, excitation, clock(0.005, 10.0)).unwrap();
        let mut tallies = SceneSums::default();
        let mut count = |n_steps: usize| {
            let n_steps = [n_steps; 9];
            let before = allocations();
            assert!(beside.run(RowsOf::Elastic(&rows), &n_steps, &mut tallies));
            (allocations() - before, tallies.touching_steps)
        };
        // Before the first touch there is no reason to allocate.
        let ((none, apart), (many, touching)) = (count(2), count(2000));
        assert_eq!(apart, 0, "nothing touches yet");
        assert!(touching > 100, "the rows must collide: {touching}");
        assert!(many <= none, "{many} allocations with contact, {none} without");
    }
}
