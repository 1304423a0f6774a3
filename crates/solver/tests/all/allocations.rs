//! A step allocates nothing.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

use crate::common::{
    METHODS, STEREOMECHANICAL, STIFF, VISCOELASTIC, WEAK, clock, ground, pairs, yielding,
};
use crate::watch::Watch;
use pounding_solver::{
    CentralDifference, Elastic, Excitation, Floor, Ledger, Node, Peaks, Row, RowsOf, SceneSums,
    SideBySide, Stepping, TransferredMomentum, Verlet, VerletImpacts,
};

/// The system's allocator with a counter.
struct Counting;

thread_local! {
    /// Allocations of this thread: other tests run beside this one.
    pub(crate) static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

#[expect(
    unsafe_code,
    reason = "an allocator is unsafe by nature; this one only counts"
)]
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
    for law in [STEREOMECHANICAL, VISCOELASTIC] {
        let nodes = vec![yielding(WEAK), yielding(STIFF), yielding(WEAK)];
        let row = Row::new(nodes, pairs(3, 0.02, law)).unwrap();
        for (name, method) in METHODS {
            let count = |duration| {
                let excitation = Excitation::new(0.01, &samples).unwrap();
                let mut recorder = (
                    Peaks::new(3),
                    TransferredMomentum::new(3),
                    Ledger::new(&row, excitation),
                );
                let before = allocations();
                let work = method
                    .watch(&row, excitation, clock(0.005, duration), &mut recorder)
                    .unwrap();
                (allocations() - before, work)
            };
            let ((short, _), (long, work)) = (count(1.0), count(10.0));
            assert!(work.touching_steps > 0, "{name}: the row must collide");
            assert_eq!(
                short, long,
                "{name}: ten times the steps, the same allocations"
            );
            assert!(short > 0, "{name}: the counter must count");
        }
    }
}

#[test]
fn limit_a_step_side_by_side_allocates_nothing() {
    let samples = ground();
    let excitation = Excitation::new(0.01, &samples).unwrap();
    let verlet = Verlet {
        impacts: VerletImpacts::Located,
    };
    let central = Stepping::from(CentralDifference::default());
    // Storeys of every structure, and structures.
    let methods = [
        (central, 1, 5),
        (central, 1, 2),
        (central, 1, 3),
        (central, 3, 2),
        (verlet.into(), 1, 2),
    ];
    let laws = [STEREOMECHANICAL, VISCOELASTIC];
    for ((method, storeys, n), law) in methods
        .into_iter()
        .flat_map(|one| laws.map(|law| (one, law)))
    {
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
            all.retain(|pair| pair.right % n > 0);
            Row::new((0..n * storeys).map(node).collect(), all).unwrap()
        };
        let rows: Vec<_> = (0..9).map(row).collect();
        let rows: Vec<_> = rows.iter().collect();
        let beside = SideBySide::new(method, excitation, clock(0.005, 10.0)).unwrap();
        let mut tallies = SceneSums::default();
        let mut count = |n_steps: usize| {
            let n_steps = [n_steps; 9];
            let before = allocations();
            assert!(beside.run(RowsOf::Elastic(&rows), &n_steps, &mut tallies));
            (allocations() - before, tallies.touching_steps)
        };
        // Before anything touches there is nothing to allocate for.
        let ((none, apart), (many, touching)) = (count(2), count(2000));
        assert_eq!(apart, 0, "nothing touches yet");
        assert!(touching > 100, "the rows must collide: {touching}");
        assert!(
            many <= none,
            "{many} allocations with contact, {none} without"
        );
    }
}
