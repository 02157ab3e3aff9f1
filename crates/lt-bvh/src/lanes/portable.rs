//! Lanes as plain arrays of eight, for every processor.

use super::{Lanes, NodeLanes};

/// Plain arrays of eight.
#[derive(Clone, Copy, Debug)]
pub struct Portable;

#[inline(always)]
fn zip(a: [f32; 8], b: [f32; 8], f: impl Fn(f32, f32) -> f32) -> [f32; 8] {
    core::array::from_fn(|i| f(a[i], b[i]))
}

#[inline(always)]
fn bits(a: [f32; 8], b: [f32; 8], holds: impl Fn(f32, f32) -> bool) -> u32 {
    let mut mask = 0;
    for i in 0..8 {
        mask |= u32::from(holds(a[i], b[i])) << i;
    }
    mask
}

#[inline(always)]
fn pack<T: Copy>(mut mask: u32, from: &[T], to: &mut [T]) {
    let mut len = 0;
    while mask != 0 {
        to[len] = from[mask.trailing_zeros() as usize];
        mask &= mask - 1;
        len += 1;
    }
}

impl Lanes for Portable {
    type F = [f32; 8];
    const WIDTH: usize = 8;
    #[inline(always)]
    fn load(self, from: &[f32]) -> [f32; 8] {
        let mut lanes = [0.0; 8];
        lanes.copy_from_slice(&from[..8]);
        lanes
    }
    #[inline(always)]
    fn store(self, from: [f32; 8], to: &mut [f32]) {
        to[..8].copy_from_slice(&from);
    }
    #[inline(always)]
    fn pick(self, mask: u32, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        core::array::from_fn(|i| if mask >> i & 1 == 1 { a[i] } else { b[i] })
    }
    #[inline(always)]
    fn splat(self, x: f32) -> [f32; 8] {
        [x; 8]
    }
    #[inline(always)]
    fn add(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a + b)
    }
    #[inline(always)]
    fn sub(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a - b)
    }
    #[inline(always)]
    fn mul(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a * b)
    }
    #[inline(always)]
    fn div(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| a / b)
    }
    #[inline(always)]
    fn mul_add(self, a: [f32; 8], b: [f32; 8], c: [f32; 8]) -> [f32; 8] {
        core::array::from_fn(|i| a[i] * b[i] + c[i])
    }
    #[inline(always)]
    fn neg_mul_add(self, a: [f32; 8], b: [f32; 8], c: [f32; 8]) -> [f32; 8] {
        core::array::from_fn(|i| c[i] - a[i] * b[i])
    }
    #[inline(always)]
    fn min(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| if a < b { a } else { b })
    }
    #[inline(always)]
    fn max(self, a: [f32; 8], b: [f32; 8]) -> [f32; 8] {
        zip(a, b, |a, b| if a > b { a } else { b })
    }
    #[inline(always)]
    fn abs(self, a: [f32; 8]) -> [f32; 8] {
        a.map(f32::abs)
    }
    #[inline(always)]
    fn least(self, a: [f32; 8]) -> f32 {
        a.into_iter().fold(f32::INFINITY, |a, b| if b < a { b } else { a })
    }
    #[inline(always)]
    fn most(self, a: [f32; 8]) -> f32 {
        a.into_iter().fold(f32::NEG_INFINITY, |a, b| if b > a { b } else { a })
    }
    #[inline(always)]
    fn le(self, a: [f32; 8], b: [f32; 8]) -> u32 {
        bits(a, b, |a, b| a <= b)
    }
    #[inline(always)]
    fn lt(self, a: [f32; 8], b: [f32; 8]) -> u32 {
        bits(a, b, |a, b| a < b)
    }
    #[inline(always)]
    fn compress(self, mask: u32, from: [f32; 8], to: &mut [f32]) {
        pack(mask, &from, to);
    }
    #[inline(always)]
    fn compress_words(self, mask: u32, from: &[u32], to: &mut [u32]) {
        pack(mask, &from[..8], to);
    }
}

/// [`NodeLanes::filled`] on an array.
#[inline(always)]
pub(super) fn filled(sets: &[u64; 8]) -> u32 {
    let mut mask = 0;
    for (i, set) in sets.iter().enumerate() {
        mask |= u32::from(*set != 0) << i;
    }
    mask
}

/// [`NodeLanes::add_to_sets`] on an array.
#[inline(always)]
pub(super) fn add_to_sets(sets: [u64; 8], mask: u32, bit: u64) -> [u64; 8] {
    let mut sets = sets;
    for (i, set) in sets.iter_mut().enumerate() {
        *set |= bit & u64::from(mask >> i & 1).wrapping_neg();
    }
    sets
}

impl NodeLanes for Portable {
    type Rays = Portable;
    #[inline(always)]
    fn rays(self) -> Portable {
        self
    }
    type Sets = [u64; 8];
    #[inline(always)]
    fn no_sets(self) -> [u64; 8] {
        [0; 8]
    }
    #[inline(always)]
    fn add_to_sets(self, sets: [u64; 8], mask: u32, bit: u64) -> [u64; 8] {
        add_to_sets(sets, mask, bit)
    }
    #[inline(always)]
    fn filled(self, sets: [u64; 8]) -> u32 {
        filled(&sets)
    }
    #[inline(always)]
    fn stored_sets(self, sets: [u64; 8]) -> [u64; 8] {
        sets
    }
}
