//! The eight-wide node with boxes in eight bits per plane (Ylitie, Karras, Laine, "Efficient Incoherent Ray
//! Traversal on GPUs Through Compressed Wide BVHs", HPG 2017, section 3).

use crate::grid::byte;
use crate::ray::Ray;
use crate::slab::{Slab, largest};
use bytemuck::{Pod, Zeroable};
use lt_math::glam::{UVec4, Vec3};

/// Eight children in 80 bytes, read as five 16-byte words.
///
/// Child boxes lie on a grid of 255 steps per axis, of a power of two each, from the node's lower corner. A
/// child is empty, an inner node, or a leaf of one to three consecutive primitives. Inner children are
/// consecutive in the node buffer, primitives of all leaf children consecutive in the primitive buffer, and
/// both are counted from the start of the tree they belong to, so trees can be moved and joined freely.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
pub struct Node {
    /// Bits of the lower corner's x, y and z; then, from the low byte, the exponents of the grid steps in x, y
    /// and z, biased as in f32, and the mask of the slots that hold inner nodes.
    pub frame: UVec4,
    /// First inner child; first primitive; then one byte per child: 0 if empty, 0b001 and 24 + slot for an inner
    /// node, and for a leaf the primitive count in unary in the top three bits and the offset from the node's
    /// first primitive below.
    pub links: UVec4,
    /// Lower planes in x of children 0 to 3 and 4 to 7, then upper planes.
    pub x: UVec4,
    /// The same in y.
    pub y: UVec4,
    /// The same in z.
    pub z: UVec4,
}

const _: () = assert!(size_of::<Node>() == 80);

/// Bits of a hit mask that stand for inner nodes; the 24 bits below are primitives.
pub(crate) const INNER_BITS: u32 = 0xff00_0000;

impl Node {
    /// Lower corner of the node's box.
    #[inline(always)]
    pub fn low(&self) -> Vec3 {
        Vec3::new(f32::from_bits(self.frame.x), f32::from_bits(self.frame.y), f32::from_bits(self.frame.z))
    }

    /// Length of a grid step per axis.
    #[inline(always)]
    pub fn step(&self) -> Vec3 {
        let e = self.frame.w;
        Vec3::new(
            f32::from_bits(byte(e, 0) << 23),
            f32::from_bits(byte(e, 1) << 23),
            f32::from_bits(byte(e, 2) << 23),
        )
    }

    /// Upper corner of the node's grid, at or above that of its box.
    #[inline(always)]
    pub fn high(&self) -> Vec3 {
        self.low() + self.step() * 255.0
    }

    /// Mask of the slots that hold inner nodes.
    #[inline(always)]
    pub fn inner_mask(&self) -> u32 {
        self.frame.w >> 24
    }

    /// Prepares a ray for the tree of which this is the root.
    #[inline(always)]
    pub(crate) fn slab(&self, ray: &Ray) -> Slab {
        Slab::new(ray, self.low(), self.high())
    }

    /// Tests all children for the part of the ray from `tmin` to `tmax`, both inclusive.
    ///
    /// Bit 24 + (slot ^ `octant`) of the answer is set for each inner child hit, so that taking the highest
    /// first goes roughly front to back; the bits below are the primitives of leaves hit.
    #[inline(always)]
    pub(crate) fn hits(&self, slab: &Slab, octant: u32, tmin: f32, tmax: f32) -> u32 {
        let scale = self.step() * slab.inverse;
        let start = (self.low() - slab.origin) * slab.inverse;
        let near = start - slab.node_margin;
        let far = start + slab.node_margin;
        // Entry planes are the lower ones where the direction is positive.
        let (xn, xf) = entry_exit(self.x, slab.inverse.x);
        let (yn, yf) = entry_exit(self.y, slab.inverse.y);
        let (zn, zf) = entry_exit(self.z, slab.inverse.z);
        let mut mask = 0;
        let mut slot = 0;
        while slot < 8 {
            let (half, at) = (slot >> 2, slot & 3);
            let pick = |pair: (u32, u32)| byte(if half == 0 { pair.0 } else { pair.1 }, at) as f32;
            let entry = largest(Vec3::new(pick(xn), pick(yn), pick(zn)) * scale + near);
            let exits = Vec3::new(pick(xf), pick(yf), pick(zf)) * scale + far;
            let exit = exits.x.min(exits.y).min(exits.z);
            if entry <= exit && entry <= tmax && exit >= tmin {
                let meta = byte(if half == 0 { self.links.z } else { self.links.w }, at);
                let position = meta & 31;
                let bit = if position >= 24 { 24 + ((position - 24) ^ octant) } else { position };
                mask |= (meta >> 5) << bit;
            }
            slot += 1;
        }
        mask
    }
}

#[inline(always)]
fn entry_exit(planes: UVec4, inverse: f32) -> ((u32, u32), (u32, u32)) {
    if inverse < 0.0 {
        ((planes.z, planes.w), (planes.x, planes.y))
    } else {
        ((planes.x, planes.y), (planes.z, planes.w))
    }
}

/// The octant that orders children front to back: a bit is set per axis along which the ray runs upward.
#[inline(always)]
pub(crate) fn octant(slab: &Slab) -> u32 {
    let x = if slab.inverse.x < 0.0 { 0 } else { 1 };
    let y = if slab.inverse.y < 0.0 { 0 } else { 2 };
    let z = if slab.inverse.z < 0.0 { 0 } else { 4 };
    x | y | z
}
