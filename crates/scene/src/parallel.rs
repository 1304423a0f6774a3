//! Work on many items by all threads, compiled once: every closure of a parallel iterator compiles the pool's loops anew.

use std::sync::Mutex;

use rayon::prelude::*;

/// Applies `work` to every item and returns the results in the order of the items.
pub fn each<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let made: Vec<_> = items.iter().map(|_| Mutex::new(None)).collect();
    for_each(items.len(), &|index| {
        let one = work(&items[index]);
        // Only this thread has the item, so that the lock is free and valid.
        if let Ok(mut place) = made[index].lock() {
            *place = Some(one);
        }
    });
    let made = made.into_iter();
    made.filter_map(|place| place.into_inner().ok().flatten()).collect()
}

/// Applies `work` to two items.
pub fn both<T: Sync, R: Send>(items: &[T; 2], work: impl Fn(&T) -> R + Sync) -> [R; 2] {
    let [one, other] = items;
    rayon::join(|| work(one), || work(other)).into()
}

/// Applies `work` to every item. Returns the results, or the first error in the order of the items, whichever error came first in time.
///
/// # Errors
/// Errors of `work`.
pub fn try_each<T: Sync, R: Send, E: Send>(items: &[T], work: impl Fn(&T) -> Result<R, E> + Sync) -> Result<Vec<R>, E> {
    each(items, work).into_iter().collect()
}

fn for_each(n: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..n).into_par_iter().for_each(work);
}
