//! The loop of two elastic structures, written by hand for AVX-512: what lanes are measured by.
//!
//! The same arithmetic as the central difference method with velocity jumps, for a scene that is known to have two structures,
//! one pair and no wall. Sixteen scenes at once, in two vectors that do not wait for each other.

#![expect(
    unsafe_code,
    reason = "instructions of AVX-512 are called by name: that is the point of it"
)]

use std::arch::x86_64::{
    __m512d, __mmask8, _CMP_GE_OQ, _CMP_GT_OQ, _mm512_abs_pd, _mm512_add_pd, _mm512_cmp_pd_mask,
    _mm512_div_pd, _mm512_loadu_pd, _mm512_mask_add_pd, _mm512_mask_mov_pd, _mm512_maskz_mov_pd,
    _mm512_max_pd, _mm512_mul_pd, _mm512_set1_pd, _mm512_setzero_pd, _mm512_sqrt_pd,
    _mm512_storeu_pd, _mm512_sub_pd,
};

/// Scenes in a group.
pub(super) const GROUP: usize = 16;
const VECTORS: usize = GROUP / 8;

/// Numbers of a group of scenes, a scene after the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Group {
    pub(super) masses: [[f64; GROUP]; 2],
    pub(super) stiffnesses: [[f64; GROUP]; 2],
    pub(super) dampings: [[f64; GROUP]; 2],
    pub(super) gaps: [f64; GROUP],
    pub(super) law: Law,
}

/// What acts between the two, in all scenes.
#[derive(Debug, Clone, Copy)]
pub(super) enum Law {
    /// e \[–\].
    Stereomechanical(f64),
    /// β̄ \[N/m^1.5\] and ξ̄ \[–\].
    Viscoelastic(f64, f64),
}

/// Peak displacements and the sum of the impulses of each scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct Found {
    pub(super) peaks: [[f64; GROUP]; 2],
    pub(super) impulses: [f64; GROUP],
}

/// Runs a group, with peaks and impulses or bare; nothing on a machine without AVX-512.
pub(super) fn run<const PEAKS: bool>(group: &Group, ground: &[f64], dt: f64) -> Option<Found> {
    if !std::is_x86_feature_detected!("avx512f") {
        return None;
    }
    let found = match group.law {
        Law::Stereomechanical(e) => {
            // SAFETY: the machine has the instructions.
            unsafe { steps::<PEAKS, true>(group, ground, dt, [e, 0.0]) }
        }
        Law::Viscoelastic(stiffness, ratio) => {
            // SAFETY: the machine has the instructions.
            unsafe { steps::<PEAKS, false>(group, ground, dt, [stiffness, ratio]) }
        }
    };
    Some(found)
}

/// Constants and state of one structure.
#[derive(Clone, Copy)]
struct Body {
    inverse_mass: __m512d,
    stiffness: __m512d,
    damping: __m512d,
    solve: __m512d,
    carry: __m512d,
    displacement: __m512d,
    increment: __m512d,
    peak: __m512d,
}

/// Eight scenes.
#[derive(Clone, Copy)]
struct Eight {
    bodies: [Body; 2],
    gap: __m512d,
    reduced_mass: __m512d,
    impulse: __m512d,
    force: __m512d,
}

#[target_feature(enable = "avx512f")]
fn load(values: &[f64; GROUP], vector: usize) -> __m512d {
    let part = &values[8 * vector..8 * vector + 8];
    // SAFETY: the part has eight numbers.
    unsafe { _mm512_loadu_pd(part.as_ptr()) }
}

#[target_feature(enable = "avx512f")]
fn begin(group: &Group, vector: usize, dt: f64, ground: f64) -> Eight {
    let one = _mm512_set1_pd(1.0);
    let body = |index: usize| {
        let inverse_mass = _mm512_div_pd(one, load(&group.masses[index], vector));
        let damping = load(&group.dampings[index], vector);
        let rate = _mm512_mul_pd(inverse_mass, damping);
        let half = _mm512_div_pd(_mm512_mul_pd(_mm512_set1_pd(0.5), rate), _mm512_set1_pd(dt));
        let inertia = _mm512_set1_pd(1.0 / (dt * dt));
        Body {
            inverse_mass,
            stiffness: load(&group.stiffnesses[index], vector),
            damping,
            solve: _mm512_div_pd(one, _mm512_add_pd(inertia, half)),
            carry: _mm512_sub_pd(inertia, half),
            displacement: _mm512_setzero_pd(),
            // The textbook start from rest: u₀ − u₋₁ = −Δt² ü₀/2 with ü₀ = −a_g.
            increment: _mm512_set1_pd(dt * (0.5 * dt * ground)),
            peak: _mm512_setzero_pd(),
        }
    };
    let bodies = [body(0), body(1)];
    let both = _mm512_add_pd(bodies[0].inverse_mass, bodies[1].inverse_mass);
    Eight {
        bodies,
        gap: load(&group.gaps, vector),
        reduced_mass: _mm512_div_pd(one, both),
        impulse: _mm512_setzero_pd(),
        force: _mm512_setzero_pd(),
    }
}

#[target_feature(enable = "avx512f")]
fn steps<const PEAKS: bool, const IMPULSIVE: bool>(
    group: &Group,
    ground: &[f64],
    dt: f64,
    law: [f64; 2],
) -> Found {
    let mut eights = [
        begin(group, 0, dt, ground[0]),
        begin(group, 1, dt, ground[0]),
    ];
    for acceleration in ground {
        let acceleration = _mm512_set1_pd(*acceleration);
        let mut touching: __mmask8 = 0;
        let mut deformations = [_mm512_setzero_pd(); VECTORS];
        for (eight, deformation) in eights.iter().zip(&mut deformations) {
            let [left, right] = &eight.bodies;
            let ahead = _mm512_sub_pd(left.displacement, right.displacement);
            *deformation = _mm512_sub_pd(ahead, eight.gap);
            touching |= _mm512_cmp_pd_mask::<_CMP_GE_OQ>(*deformation, _mm512_setzero_pd());
            // The impulse of the step in which a pair parts.
            touching |= _mm512_cmp_pd_mask::<_CMP_GT_OQ>(eight.force, _mm512_setzero_pd());
        }
        if touching == 0 {
            for eight in &mut eights {
                free::<PEAKS>(eight, acceleration);
            }
            continue;
        }
        for (eight, deformation) in eights.iter_mut().zip(deformations) {
            if IMPULSIVE {
                impact::<PEAKS>(eight, (acceleration, deformation), dt, law[0]);
            } else {
                push::<PEAKS>(eight, (acceleration, deformation), dt, law);
            }
        }
    }
    told(&eights)
}

#[target_feature(enable = "avx512f")]
#[inline]
fn told(eights: &[Eight; VECTORS]) -> Found {
    let mut found = Found {
        peaks: [[0.0; GROUP]; 2],
        impulses: [0.0; GROUP],
    };
    for (vector, eight) in eights.iter().enumerate() {
        let part = 8 * vector..8 * vector + 8;
        // SAFETY: each part has eight numbers.
        unsafe {
            _mm512_storeu_pd(found.impulses[part.clone()].as_mut_ptr(), eight.impulse);
        }
        for (body, peaks) in eight.bodies.iter().zip(&mut found.peaks) {
            // The last displacement keeps a bare loop from being optimised away.
            let last = _mm512_abs_pd(body.displacement);
            let shown = _mm512_max_pd(body.peak, _mm512_mul_pd(last, _mm512_set1_pd(1e-300)));
            // SAFETY: each part has eight numbers.
            unsafe {
                _mm512_storeu_pd(peaks[part.clone()].as_mut_ptr(), shown);
            }
        }
    }
    found
}

/// A step without contact.
#[target_feature(enable = "avx512f")]
#[inline]
fn free<const PEAKS: bool>(eight: &mut Eight, ground: __m512d) {
    for body in &mut eight.bodies {
        let force = _mm512_mul_pd(body.stiffness, body.displacement);
        advance::<PEAKS>(body, _mm512_sub_pd(_mm512_setzero_pd(), force), ground);
    }
}

/// The next displacement under a force.
#[target_feature(enable = "avx512f")]
#[inline]
fn advance<const PEAKS: bool>(body: &mut Body, force: __m512d, ground: __m512d) {
    let load = _mm512_sub_pd(_mm512_mul_pd(body.inverse_mass, force), ground);
    let sum = _mm512_add_pd(load, _mm512_mul_pd(body.carry, body.increment));
    if PEAKS {
        body.peak = _mm512_max_pd(body.peak, _mm512_abs_pd(body.displacement));
    }
    body.increment = _mm512_mul_pd(body.solve, sum);
    body.displacement = _mm512_add_pd(body.displacement, body.increment);
}

/// A step with impacts after it, where a touching pair approaches.
#[target_feature(enable = "avx512f")]
#[inline]
fn impact<const PEAKS: bool>(
    eight: &mut Eight,
    (ground, deformation): (__m512d, __m512d),
    dt: f64,
    e: f64,
) {
    let zero = _mm512_setzero_pd();
    let before = eight.bodies;
    free::<PEAKS>(eight, ground);
    let two = _mm512_set1_pd(2.0 * dt);
    let velocity = |index: usize| {
        let (old, new) = (before[index].increment, eight.bodies[index].increment);
        _mm512_div_pd(_mm512_add_pd(new, old), two)
    };
    let velocities = [velocity(0), velocity(1)];
    let rate = _mm512_sub_pd(velocities[0], velocities[1]);
    let touching = _mm512_cmp_pd_mask::<_CMP_GE_OQ>(deformation, zero);
    let hit = touching & _mm512_cmp_pd_mask::<_CMP_GT_OQ>(rate, zero);
    if hit == 0 {
        return;
    }
    let demand = _mm512_mul_pd(_mm512_set1_pd(1.0 + e), rate);
    let mobility = _mm512_add_pd(before[0].inverse_mass, before[1].inverse_mass);
    let impulse = _mm512_div_pd(demand, mobility);
    eight.impulse = _mm512_mask_add_pd(eight.impulse, hit, eight.impulse, impulse);
    for (index, body) in eight.bodies.iter_mut().enumerate() {
        let change = _mm512_mul_pd(body.inverse_mass, impulse);
        let velocity = if index == 0 {
            _mm512_sub_pd(velocities[index], change)
        } else {
            _mm512_add_pd(velocities[index], change)
        };
        let force = _mm512_sub_pd(
            _mm512_sub_pd(zero, _mm512_mul_pd(body.damping, velocity)),
            _mm512_mul_pd(body.stiffness, before[index].displacement),
        );
        let acceleration = _mm512_sub_pd(_mm512_mul_pd(body.inverse_mass, force), ground);
        let half = _mm512_mul_pd(_mm512_set1_pd(0.5 * dt), acceleration);
        let increment = _mm512_mul_pd(_mm512_set1_pd(dt), _mm512_add_pd(velocity, half));
        let displacement = _mm512_add_pd(before[index].displacement, increment);
        body.increment = _mm512_mask_mov_pd(body.increment, hit, increment);
        body.displacement = _mm512_mask_mov_pd(body.displacement, hit, displacement);
    }
}

/// A step under the force of the nonlinear viscoelastic element.
#[target_feature(enable = "avx512f")]
#[inline]
fn push<const PEAKS: bool>(
    eight: &mut Eight,
    (ground, deformation): (__m512d, __m512d),
    dt: f64,
    [stiffness, ratio]: [f64; 2],
) {
    let zero = _mm512_setzero_pd();
    let overlaps = _mm512_cmp_pd_mask::<_CMP_GT_OQ>(deformation, zero);
    let [left, right] = &eight.bodies;
    let closing = _mm512_sub_pd(left.increment, right.increment);
    let rate = _mm512_div_pd(closing, _mm512_set1_pd(dt));
    let root = _mm512_sqrt_pd(deformation);
    let stiffness = _mm512_set1_pd(stiffness);
    let spring = _mm512_mul_pd(_mm512_mul_pd(stiffness, deformation), root);
    let approaches = _mm512_cmp_pd_mask::<_CMP_GT_OQ>(rate, zero);
    let inside = _mm512_mul_pd(_mm512_mul_pd(stiffness, root), eight.reduced_mass);
    let damping = _mm512_mul_pd(_mm512_set1_pd(2.0 * ratio), _mm512_sqrt_pd(inside));
    let damper = _mm512_mul_pd(damping, rate);
    let force = _mm512_mask_add_pd(spring, approaches, spring, damper);
    let force = _mm512_maskz_mov_pd(overlaps, force);
    let sum = _mm512_add_pd(eight.force, force);
    let impulse = _mm512_mul_pd(_mm512_set1_pd(0.5 * dt), sum);
    eight.impulse = _mm512_add_pd(eight.impulse, impulse);
    eight.force = force;
    for (index, body) in eight.bodies.iter_mut().enumerate() {
        let own = if index == 0 {
            _mm512_sub_pd(zero, force)
        } else {
            force
        };
        let restoring = _mm512_mul_pd(body.stiffness, body.displacement);
        advance::<PEAKS>(body, _mm512_sub_pd(own, restoring), ground);
    }
}
