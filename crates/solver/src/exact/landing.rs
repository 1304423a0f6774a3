//! The landing of a piece: what is reported of it, and the states at its end.

use std::ops::Range;

use crate::exact::Run;
use crate::exact::member::Branch;
use crate::exact::watch::Event;
use crate::span::{Power, Series, value};
use crate::{Path, Recorder, Span, State};

impl<R: Recorder> Run<'_, R> {
    /// Ends the piece of a body now: reports its spans and brings its state here.
    pub(super) fn land(&mut self, first: usize, time: f64) {
        if self.landed[first] {
            return;
        }
        let body = &self.bodies[first];
        let (last, x, full) = (body.last, body.position(time), time >= body.end);
        let advanced = time > body.start;
        for node in first..=last {
            self.landed[node] = true;
        }
        for pair in self.pairs_around(first, last) {
            self.carry_deformation(pair, time);
        }
        let events = std::mem::take(&mut self.bodies[first].events);
        for node in first..=last {
            let end = self.end_state(node, x, if full { &events } else { &[] });
            if advanced {
                self.report(node, (first, time), x, end);
                (self.members[node].balanced, self.members[node].peaked) = (false, false);
            }
            self.members[node].state = end;
        }
        for pair in self.pairs_around(first, last) {
            self.refresh_deformation(pair, time);
        }
        if full {
            for event in &events {
                self.apply(*event, time);
            }
        }
        self.bodies[first].events = events;
    }

    /// Pairs inside a body and on both sides of it.
    fn pairs_around(&self, first: usize, last: usize) -> Range<usize> {
        let left = first
            .checked_sub(1)
            .and_then(|left| self.pair_right_of[left]);
        let within = self.pairs_within(first, last);
        let right = self.pair_right_of[last];
        let start = left.or(if within.is_empty() {
            right
        } else {
            Some(within.start)
        });
        let end = right.map(|pair| pair + 1).or(if within.is_empty() {
            left.map(|pair| pair + 1)
        } else {
            Some(within.end)
        });
        start.unwrap_or(0)..end.unwrap_or(0)
    }

    /// State of a node at the end of its piece.
    fn end_state(&self, node: usize, x: f64, events: &[Event]) -> State {
        let body = &self.bodies[self.body_of[node]];
        let (member, len) = (&self.members[node], body.len);
        let (left, right) = self.forces_on(node);
        let force = |pair: Option<usize>| {
            pair.map_or(0.0, |pair| {
                value(&self.contacts[pair].force[..len], x).max(0.0)
            })
        };
        let rise = x * value(&member.displacement[1..len], x);
        let mut end = State {
            displacement: member.displacement[0] + rise,
            velocity: value(&member.velocity[..len], x),
            acceleration: value(&member.acceleration[..len], x),
            restoring_force: member.state.restoring_force + member.tangent() * rise,
            force_from_left: force(left),
            force_from_right: -force(right),
        };
        for event in events {
            match *event {
                Event::Turn(turning) if turning == self.leader(node) => end.velocity = 0.0,
                Event::Yield(yielding, branch) if yielding == node => {
                    end.restoring_force = match branch {
                        Branch::Left => -member.yield_force,
                        Branch::Right | Branch::Elastic => member.yield_force,
                    };
                }
                Event::Turn(_)
                | Event::Yield(..)
                | Event::Balance(_)
                | Event::Extremum(_)
                | Event::Peak(_)
                | Event::Fade(_)
                | Event::Reversal(_)
                | Event::Clamp(_)
                | Event::Grip(_)
                | Event::Part(_) => {}
            }
        }
        end
    }

    fn report(&mut self, node: usize, (first, time): (usize, f64), x: f64, end: State) {
        let body = &self.bodies[first];
        let (left, right) = self.forces_on(node);
        let member = &self.members[node];
        let force = |pair: Option<usize>| {
            pair.map_or(&[][..], |pair| &self.contacts[pair].force[..body.len])
        };
        let impulse = |pair| integral(force(pair), body.power, x);
        let span = Span {
            structure: node,
            start_time: body.start,
            end_time: time,
            start: member.state,
            end,
            impulse_from_left: impulse(left),
            impulse_from_right: -impulse(right),
            below: None,
            path: Path::Series(Series {
                origin: body.start,
                power: body.power,
                displacement: &member.displacement[..body.len],
                velocity: &member.velocity[..body.len],
                acceleration: &member.acceleration[..body.len],
                below: None,
                restoring_force: (member.state.restoring_force, member.tangent()),
                force_from_left: force(left),
                force_from_right: force(right),
            }),
        };
        self.recorder.span(&span);
    }
}

/// ∫ F dt from the start of a piece to x.
fn integral(force: &[f64], power: Power, x: f64) -> f64 {
    let p = power.order();
    let mut sum = 0.0;
    for (n, coefficient) in force.iter().enumerate().rev() {
        sum = sum * x + p as f64 * coefficient / (n + p) as f64;
    }
    sum * power.time(x)
}
