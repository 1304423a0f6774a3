//! A step allocates nothing.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use crate::common::{METHODS, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, ground, pairs, yielding};
use crate::watch::Watch;
use pounding_solver::{Excitation, Ledger, Peaks, Row, TransferredMomentum};

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
fn limit_a_step_allocates_nothing() {
    let samples = ground();
    let [impulsive, compliant] = [STEREOMECHANICAL, VISCOELASTIC].map(|law| pairs(3, 0.02, law));
    // Two contacts on one side of a floor form no chain.
    let twice = [&impulsive[..], &impulsive[..]].concat();
    for pairs in [impulsive, compliant, twice] {
        let nodes = vec![yielding(WEAK), yielding(STIFF), yielding(WEAK)];
        let row = Row::new(nodes, pairs).unwrap();
        for (name, method) in METHODS {
            let count = |duration| {
                let excitation = Excitation::new(0.01, &samples).unwrap();
                let mut recorder = (Peaks::new(3), TransferredMomentum::new(3), Ledger::new(&row, excitation));
                let before = allocations();
                let work = method.watch(&row, excitation, clock(0.005, duration), &mut recorder).unwrap();
                (allocations() - before, work)
            };
            let ((short, _), (long, work)) = (count(1.0), count(10.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert_eq!(short, long, "{name}: ten times the steps, the same allocations");
            assert!(short > 0, "{name}: the counter must count");
        }
    }
}
