//! Rows of buildings of several storeys, for tests.

use pounding_solver::{Hysteretic, Levels, Node, Pair, Row, Storey};

/// Rayleigh damping c = αm + βk.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Rayleigh {
    pub(crate) alpha: f64,
    pub(crate) beta: f64,
}

/// Floors of a building from the ground up: mass \[kg\] and columns of each storey.
pub(crate) type Tower<Column> = Vec<(f64, Column)>;

/// A tower of equal storeys.
pub(crate) fn uniform<Column: Copy>(n_storeys: usize, mass: f64, column: Column) -> Tower<Column> {
    vec![(mass, column); n_storeys]
}

/// Neighbouring towers. `pair` makes the pairs of floors on a common level that face each other, from (left building, storey, left node,
/// right node); it may return `None`.
pub(crate) fn row<Column: Hysteretic>(
    towers: &[Tower<Column>],
    damping: Rayleigh,
    pair: impl Fn(usize, usize, [usize; 2]) -> Option<Pair>,
) -> (Row<Column>, Levels) {
    let counts: Vec<_> = towers.iter().map(Vec::len).collect();
    let levels = Levels::new(&counts);
    let floor = |node: usize| -> Node<Column> {
        let (building, storey) = levels.place(node);
        let (mass, column) = towers[building][storey];
        levels.floor(
            node,
            Storey {
                mass,
                damping: damping.beta * column.stiffness(),
                ground_damping: damping.alpha * mass,
                column,
            },
        )
    };
    let nodes = (0..levels.n_nodes()).map(floor).collect();
    let mut pairs = Vec::new();
    for left in 0..towers.len().saturating_sub(1) {
        for (storey, (a, b)) in levels.facing(left).enumerate() {
            pairs.extend(pair(left, storey, [a, b]));
        }
    }
    pairs.sort_by_key(Pair::left);
    let row = Row::new(nodes, pairs).expect("a valid row");
    (row, levels)
}
