//! Whose is which of a piece's few normals: what a sun asks of a piece, in two lines of the cache in place of sixteen.
//!
//! A piece that shows one to eight planes has their normals in its [`Head`], and which of them each sample lies on.

use bytemuck::{Pod, Zeroable};
use lt_shaders::abi::Sample;

use super::bits::pack;
use super::samples::{Lanes, Points};
use super::tiles::PIECE;

/// Planes of a piece at most.
const MOST: u32 = 8;

/// See the [module](self).
#[repr(C, align(128))]
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
pub(super) struct Head {
    normals: [[f32; 3]; MOST as usize],
    /// Bits of the number of each sample's plane, lowest first, in Morton order.
    which: [u64; 3],
    /// How many planes; 0 if there are more than are told here, or a position is not finite.
    count: u32,
    /// A bit for each plane that receives shadows.
    receives: u32,
}

const _: () = assert!(size_of::<Head>() == 128);

/// Which samples of a piece a light shines towards, a bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Facing {
    /// Those that receive shadows: not settled.
    pub(super) open: u64,
    /// Those that do not.
    pub(super) lit: u64,
}

impl Head {
    /// From the parts of a piece's samples.
    #[inline(always)]
    pub(super) fn of(position: &Points, normals: &Points, flags: &[u32; PIECE]) -> Self {
        let is_finite = |row: &Lanes| row.iter().fold(true, |finite, x| finite & x.is_finite());
        let mut head = Self::zeroed();
        let mut left = if position.iter().all(is_finite) { !0u64 } else { 0 };
        while left != 0 {
            if head.count == MOST {
                return Self::zeroed();
            }
            let first = left.trailing_zeros() as usize;
            let (normal, receives) = (normals.map(|row| row[first]), flags[first] & Sample::RECEIVES);
            let mut is_on_plane = [0; PIECE];
            for (i, is_on_plane) in is_on_plane.iter_mut().enumerate() {
                let differs = |axis: usize| normals[axis][i].to_bits() ^ normal[axis].to_bits();
                let flag = flags[i] & Sample::RECEIVES ^ receives;
                *is_on_plane = u8::from(differs(0) | differs(1) | differs(2) | flag == 0);
            }
            let on_plane = pack(&is_on_plane);
            head.normals[head.count as usize] = normal;
            head.receives |= u32::from(receives != 0) << head.count;
            for (bit, which) in head.which.iter_mut().enumerate() {
                *which |= if head.count >> bit & 1 != 0 { on_plane } else { 0 };
            }
            head.count += 1;
            left &= !on_plane;
        }
        head
    }

    /// Which samples face a sun in the direction `to_light`; `None` where the head does not tell. A normal of zeros faces nothing.
    #[inline(always)]
    pub(super) fn facing(&self, to_light: [f32; 3]) -> Option<Facing> {
        let mut facing = Facing::default();
        for (plane, n) in self.normals.iter().enumerate().take(self.count as usize) {
            if n[0] * to_light[0] + n[1] * to_light[1] + n[2] * to_light[2] > 0.0 {
                let receives = self.receives >> plane & 1 != 0;
                *(if receives { &mut facing.open } else { &mut facing.lit }) |= self.samples_on(plane);
            }
        }
        (self.count > 0).then_some(facing)
    }

    /// A sample's normal, if the head tells.
    #[inline(always)]
    pub(super) fn normal(&self, sample: usize) -> Option<[f32; 3]> {
        let [low, middle, high] = self.which.map(|bits| (bits >> sample & 1) as usize);
        (self.count > 0).then(|| self.normals[low | middle << 1 | high << 2])
    }

    /// A bit for each sample on a plane.
    #[inline(always)]
    fn samples_on(&self, plane: usize) -> u64 {
        let bit = |bit: usize| if plane >> bit & 1 != 0 { self.which[bit] } else { !self.which[bit] };
        bit(0) & bit(1) & bit(2)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pieces of one plane to more than are told, some of which receive no shadow: each sample as its own normal and flags say.
    #[test]
    fn samples_are_told_by_their_planes() {
        let position = [[0.5; PIECE]; 3];
        for count in 1..=MOST as usize + 1 {
            let plane = |i: usize| i * 7 % 64 % count;
            let row = |f: fn(f32) -> f32| std::array::from_fn(|i| f(plane(i) as f32 - 3.0));
            let normals = [row(|n| n), row(|n| 1.0 - 0.5 * n), row(|_| 0.0)];
            let flags = std::array::from_fn(|i| if plane(i) % 3 == 1 { 0 } else { Sample::RECEIVES });
            let head = Head::of(&position, &normals, &flags);
            for to_light in [[1.0, 0.0, 0.0], [0.2, 1.0, 0.0], [-1.0, -0.2, 0.3], [0.0, 0.0, 1.0]] {
                let Some(facing) = head.facing(to_light) else {
                    assert!(count > MOST as usize && head.normal(9).is_none());
                    continue;
                };
                for i in 0..PIECE {
                    let n = normals.map(|row: Lanes| row[i]);
                    assert_eq!(head.normal(i), Some(n));
                    let faces = n[0] * to_light[0] + n[1] * to_light[1] + n[2] * to_light[2] > 0.0;
                    let receives = flags[i] != 0;
                    let told = [facing.open, facing.lit].map(|bits| bits >> i & 1 != 0);
                    assert_eq!(told, [faces && receives, faces && !receives], "{count} planes, sample {i}");
                }
            }
        }
        let mut infinite = position;
        infinite[1][40] = f32::INFINITY;
        let head = Head::of(&infinite, &[[1.0; PIECE]; 3], &[Sample::RECEIVES; PIECE]);
        assert_eq!(head.facing([1.0, 0.0, 0.0]), None, "a place that is no number is asked itself");
    }
}
