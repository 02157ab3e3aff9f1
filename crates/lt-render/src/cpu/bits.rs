//! Conditions of a piece's samples as 64 bits in tile order: what is combined by the word, and painted on lanes at the end.

use lt_bvh::lanes;

use super::samples::Lanes;
use super::tiles::PIECE;

/// Where a < b; not so for NaN.
#[inline(always)]
pub fn less<L: lanes::Lanes>(lanes: L, a: &Lanes, b: f32) -> u64 {
    let (mut bits, b) = (0, lanes.splat(b));
    for first in (0..PIECE).step_by(L::WIDTH) {
        bits |= u64::from(lanes.lt(lanes.load(&a[first..]), b)) << first;
    }
    bits
}

/// Where a > b; not so for NaN.
#[inline(always)]
pub fn more<L: lanes::Lanes>(lanes: L, a: &Lanes, b: f32) -> u64 {
    let (mut bits, b) = (0, lanes.splat(b));
    for first in (0..PIECE).step_by(L::WIDTH) {
        bits |= u64::from(lanes.lt(b, lanes.load(&a[first..]))) << first;
    }
    bits
}

/// Where a ≤ b; not so for NaN.
#[inline(always)]
pub fn at_most<L: lanes::Lanes>(lanes: L, a: &Lanes, b: f32) -> u64 {
    let (mut bits, b) = (0, lanes.splat(b));
    for first in (0..PIECE).step_by(L::WIDTH) {
        bits |= u64::from(lanes.le(lanes.load(&a[first..]), b)) << first;
    }
    bits
}

/// Where a ≥ b; not so for NaN.
#[inline(always)]
pub fn at_least<L: lanes::Lanes>(lanes: L, a: &Lanes, b: f32) -> u64 {
    let (mut bits, b) = (0, lanes.splat(b));
    for first in (0..PIECE).step_by(L::WIDTH) {
        bits |= u64::from(lanes.le(b, lanes.load(&a[first..]))) << first;
    }
    bits
}

/// Where a = b; not so for NaN.
#[inline(always)]
pub fn same<L: lanes::Lanes>(lanes: L, a: &Lanes, b: &Lanes) -> u64 {
    let mut bits = 0;
    for first in (0..PIECE).step_by(L::WIDTH) {
        let (a, b) = (lanes.load(&a[first..]), lanes.load(&b[first..]));
        bits |= u64::from(lanes.le(a, b) & lanes.le(b, a)) << first;
    }
    bits
}

/// Writes `from` where the bits are set.
#[inline(always)]
pub fn put<L: lanes::Lanes>(lanes: L, bits: u64, from: &Lanes, to: &mut Lanes) {
    for first in (0..PIECE).step_by(L::WIDTH) {
        let mask = (bits >> first) as u32 & L::ALL;
        let picked = lanes.pick(mask, lanes.load(&from[first..]), lanes.load(&to[first..]));
        lanes.store(picked, &mut to[first..]);
    }
}

/// Writes 1 where the bits are set, 0 elsewhere.
#[inline(always)]
pub fn paint<L: lanes::Lanes>(lanes: L, bits: u64, to: &mut Lanes) {
    for first in (0..PIECE).step_by(L::WIDTH) {
        let mask = (bits >> first) as u32 & L::ALL;
        lanes.store(lanes.pick(mask, lanes.splat(1.0), lanes.splat(0.0)), &mut to[first..]);
    }
}

/// 64 zeros and ones as bits.
#[inline(always)]
pub fn pack(ones: &[u8; PIECE]) -> u64 {
    let mut bits = 0;
    for (i, eight) in ones.as_chunks::<8>().0.iter().enumerate() {
        // The product's highest byte collects one bit of each.
        bits |= (u64::from_le_bytes(*eight).wrapping_mul(0x0102_0408_1020_4080) >> 56) << (8 * i);
    }
    bits
}

/// The places of the bits that are set, lowest first.
#[inline(always)]
pub fn places(mut bits: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let place = (bits != 0).then_some(bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        place
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use lt_bvh::SimdLevel;
    use lt_bvh::lanes::{Chosen, NodeLanes, Work};

    /// All of the file's functions on lanes.
    struct All<'a>(&'a Lanes, &'a Lanes);

    impl Work for All<'_> {
        type Output = ([u64; 5], [Lanes; 2]);
        fn run<L: NodeLanes>(self, lanes: L) -> Self::Output {
            let (lanes, All(a, b)) = (lanes.rays(), self);
            let bits = [
                less(lanes, a, 2.0),
                more(lanes, a, 2.0),
                at_most(lanes, a, 2.0),
                at_least(lanes, a, 2.0),
                same(lanes, a, b),
            ];
            let (mut painted, mut mixed) = ([9.0; PIECE], *b);
            paint(lanes, bits[1], &mut painted);
            put(lanes, bits[2], a, &mut mixed);
            (bits, [painted, mixed])
        }
    }

    #[test]
    fn bits_are_what_each_lane_says() {
        let a: Lanes = std::array::from_fn(|i| if i == 17 { f32::NAN } else { (i * 5 % 7) as f32 });
        let b: Lanes = std::array::from_fn(|i| (i * 3 % 7) as f32);
        for level in SimdLevel::available() {
            let (bits, [painted, mixed]) = Chosen::new(level).expect("an available level").run(All(&a, &b));
            for i in 0..PIECE {
                let (a, b) = (a[i], b[i]);
                let told = bits.map(|bits| bits >> i & 1 != 0);
                assert_eq!(told, [a < 2.0, a > 2.0, a <= 2.0, a >= 2.0, a == b], "{level:?} {i}");
                assert_eq!(painted[i], if a > 2.0 { 1.0 } else { 0.0 });
                assert_eq!(mixed[i], if a <= 2.0 { a } else { b });
            }
            assert!(places(bits[4]).eq((0..PIECE).filter(|i| a[*i] == b[*i])), "{level:?}");
        }
    }

    #[test]
    fn ones_are_packed_in_order() {
        for place in 0..PIECE {
            assert_eq!(pack(&std::array::from_fn(|i| u8::from(i == place))), 1 << place);
        }
    }
}
