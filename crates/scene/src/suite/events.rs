//! Which motions are components of one record: they are one event, and no two independent motions.

use super::{Motion, Suite};

/// Numbers the events of the motions, from 0 in the order of the motions.
///
/// Motions of one file are of one event. So are two that have the same record number of PEER, or the same station and the same event
/// or time; two with one title that lie in two directions; two whose names differ in the direction alone, unless their files
/// say that they are of two records; and two that are alike but for a factor.
pub(super) fn number(suite: &mut Suite) {
    let motions = &suite.motions;
    let mut event: Vec<usize> = (0..motions.len()).collect();
    let join = |event: &mut Vec<usize>, one: usize, other: usize| {
        let (to, from) = (event[one], event[other]);
        let of_other = event.iter_mut().filter(|event| **event == from);
        of_other.for_each(|event| *event = to);
    };
    for index in 0..motions.len() {
        for other in 0..index {
            if event[other] != event[index] && are_of_one_record(&motions[other], &motions[index]) {
                join(&mut event, other, index);
            }
        }
    }
    let at = |name: &String| motions.iter().position(|motion| motion.name == *name);
    // Of components of one record it is no wonder.
    suite
        .alike
        .retain(|(one, other, _)| match (at(one), at(other)) {
            (Some(one), Some(other)) if event[one] != event[other] => {
                join(&mut event, one, other);
                true
            }
            _ => false,
        });
    let mut known = Vec::new();
    for (motion, event) in suite.motions.iter_mut().zip(event) {
        let at = known.iter().position(|one| *one == event);
        motion.event = at.unwrap_or_else(|| {
            known.push(event);
            known.len() - 1
        });
    }
    suite.n_events = known.len();
}

fn are_of_one_record(one: &Motion, other: &Motion) -> bool {
    if one.path == other.path {
        return true;
    }
    let number = |motion: &Motion| motion.identity.rsn.or(motion.named.rsn);
    if let (Some(one), Some(other)) = (number(one), number(other)) {
        return one == other;
    }
    let [own, others] = [&one.identity, &other.identity];
    let same = |a: &Option<String>, b: &Option<String>| Some(a.as_ref()? == b.as_ref()?);
    let station = same(&own.station, &others.station);
    let event = same(&own.event, &others.event).or(same(&own.time, &others.time));
    match (station, event) {
        (Some(true), Some(same)) => return same,
        (Some(false), _) | (_, Some(false)) => return false,
        (None, _) | (_, None) => {}
    }
    let is_in_two_directions = one.named.direction != other.named.direction
        || one.named.azimuth != other.named.azimuth
        || one.origin.file.component() != other.origin.file.component();
    let by_title = same(&own.title, &others.title) == Some(true) && is_in_two_directions;
    by_title || (one.path.parent() == other.path.parent() && one.named.same_record(&other.named))
}
