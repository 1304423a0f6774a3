//! Work on many items by all threads, with a call after each.

use pounding_scene::parallel;

/// Results of `work` for every item, in their order; `done` is called after each.
pub(crate) fn each<T: Sync, R: Send>(items: &[T], done: &(dyn Fn() + Sync), work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    parallel::each(items, |item| {
        let made = work(item);
        done();
        made
    })
}

/// Every item of one list with every item of another, the first list's in its order.
pub(crate) fn pairs<'a, A, B>(ones: &'a [A], others: &'a [B]) -> Vec<(&'a A, &'a B)> {
    let with = |one| others.iter().map(move |other| (one, other));
    ones.iter().flat_map(with).collect()
}
