//! Compliant contact of many scenes between two samples.
//!
//! A lane takes the next waiting scene as soon as its scene is done, and continues with steps of another length.

use fearless_simd::Simd;

use super::Interval;
use super::pair::{Link, PressedContact, Scene};
use super::pressing::Pressing;
use crate::number::{Lanes, MOST_LANES, Mask};

/// Brings the waiting scenes, all in contact by laws with common powers, to the end of the interval or to their partings.
#[inline(always)]
pub(super) fn press<S: Simd>(simd: S, interval: &impl Fn(usize) -> Interval, scenes: &mut [Scene], waiting: &[usize]) {
    let Some(scene) = waiting.first().map(|scene| &scenes[*scene]) else {
        return;
    };
    let Link::Pressed(first) = scene.link else {
        return;
    };
    let mut pressing = Pressing::new(simd, &first.form, scene);
    let mut waiting = waiting.iter();
    let mut inside: [Option<(usize, PressedContact)>; MOST_LANES] = [None; MOST_LANES];
    let inside = &mut inside[..Lanes::<S>::N];
    loop {
        let mut refilled = false;
        for (lane, inside) in inside.iter_mut().enumerate() {
            if inside.is_none()
                && let Some(scene) = waiting.next()
                && let Link::Pressed(contact) = scenes[*scene].link
            {
                pressing.take(lane, &scenes[*scene], &contact, &interval(*scene));
                *inside = Some((*scene, contact));
                refilled = true;
            }
        }
        if inside.iter().all(Option::is_none) {
            return;
        }
        if refilled {
            pressing.begin();
        }
        let ends = pressing.advance();
        let [ended, parted, broken] = [ends.ended, ends.parted, ends.broken].map(Mask::bits);
        for (lane, inside) in inside.iter_mut().enumerate() {
            let is_in = |lanes: u64| lanes >> lane & 1 == 1;
            if !is_in(ended) {
                continue;
            }
            if let Some((place, mut contact)) = inside.take() {
                let scene = &mut scenes[place];
                pressing.put(lane, scene, &mut contact);
                if is_in(broken) {
                    scene.give_up();
                } else if is_in(parted) {
                    scene.part(&contact, pressing.passed(lane), &interval(place));
                } else {
                    scene.link = Link::Pressed(contact);
                    scene.arrive();
                }
            }
        }
    }
}
