//! Work on many items by all threads, compiled once: every closure of a parallel iterator compiles the pool's loops anew.

use std::sync::Mutex;

use rayon::prelude::*;

/// What `work` makes of every item, in their order.
pub fn each<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let made: Vec<_> = items.iter().map(|_| Mutex::new(None)).collect();
    for_each(items.len(), &|index| {
        let one = work(&items[index]);
        // Nobody else has this item, so that the lock is free and sound.
        if let Ok(mut place) = made[index].lock() {
            *place = Some(one);
        }
    });
    let made = made.into_iter();
    made.filter_map(|place| place.into_inner().ok().flatten()).collect()
}

/// The same of two items.
pub fn both<T: Sync, R: Send>(items: &[T; 2], work: impl Fn(&T) -> R + Sync) -> [R; 2] {
    let [one, other] = items;
    rayon::join(|| work(one), || work(other)).into()
}

/// The same, or the first error in the order of the items, whichever came first in time.
///
/// # Errors
/// Those of `work`.
pub fn try_each<T: Sync, R: Send, E: Send>(items: &[T], work: impl Fn(&T) -> Result<R, E> + Sync) -> Result<Vec<R>, E> {
    each(items, work).into_iter().collect()
}

fn for_each(n: usize, work: &(dyn Fn(usize) + Sync)) {
    (0..n).into_par_iter().for_each(work);
}
