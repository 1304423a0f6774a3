//! Drivers that run work on many items in parallel and report each finished item.

use pounding_scene::parallel;

/// Runs `work` on every item in parallel; returns the results in the order of the items. Calls `done` after each item.
pub(crate) fn each<T: Sync, R: Send>(items: &[T], done: &(dyn Fn() + Sync), work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    parallel::each(items, |item| {
        let made = work(item);
        done();
        made
    })
}

/// Pairs every item of `ones` with every item of `others`; the first item changes slowest.
pub(crate) fn pairs<'a, A, B>(ones: &'a [A], others: &'a [B]) -> Vec<(&'a A, &'a B)> {
    let with = |one| others.iter().map(move |other| (one, other));
    ones.iter().flat_map(with).collect()
}
