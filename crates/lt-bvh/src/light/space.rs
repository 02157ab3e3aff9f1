//! Shadow rays as points.

use crate::axes::{main_axis, permute};
use crate::ray::{NONE, Ray};
use bytemuck::{Pod, Zeroable};
use lt_math::glam::{UVec4, Vec2, Vec3};

/// A shadow ray in light space.
///
/// Axes are permuted so that z is the one along which the ray runs fastest ([`permute`]), and the sign is that of the ray along it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LightPoint {
    /// First place coordinate.
    pub x: f32,
    /// Second place coordinate.
    pub y: f32,
    /// Nearness to the light: what blocks has more.
    pub z: f32,
}

impl LightPoint {
    /// The ray from `origin` to a sun: `origin` less its share of the ray's way along z. `origin` and `middle`, which is subtracted first,
    /// are given in permuted axes; `shear` has the ray tracer's sₓ and s_y, the ray's slopes.
    #[inline(always)]
    pub fn parallel(origin: Vec3, middle: Vec3, shear: Vec2, sign: f32) -> Self {
        let q = origin - middle;
        LightPoint { x: q.x - shear.x * q.z, y: q.y - shear.y * q.z, z: sign * q.z }
    }

    /// A ray to a light with a position, whose `direction`, in permuted axes, is the whole way to it: its slopes, and 1 / its length
    /// along z.
    #[inline(always)]
    pub fn converging(direction: Vec3, sign: f32) -> Self {
        LightPoint { x: direction.x / direction.z, y: direction.y / direction.z, z: sign / direction.z }
    }
}

/// A ray shorter than this to a positioned light, along its main axis, is no point: its slopes and nearness may be denormal or infinite.
pub const LEAST_LENGTH: f32 = 1e-30;

/// A light's space as kernels take it: how rays become points, and where the trees over what each face of the light sees begin.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct LightSpace {
    /// Of a sun: the ray tracer's sₓ and s_y.
    pub shear: Vec2,
    /// The third coordinate of a place is this times x and y: at most 1 in magnitude each.
    pub diagonal: Vec2,
    /// Of a sun: what is subtracted from origins, in permuted axes.
    pub middle: Vec3,
    /// Of a sun: the sign of its direction along the axis.
    pub sign: f32,
    /// Lower corner of the box in which rays must start to be points, world.
    pub low: Vec3,
    /// 1 for a sun, 0 for a light with a position.
    pub is_parallel: u32,
    /// Upper corner.
    pub high: Vec3,
    /// Of a sun: the axis that becomes z.
    pub axis: u32,
    /// Root nodes by the direction of the rays' main axis: +x (or all rays to a sun), −x, +y, −y. [`NONE`] where there is nothing.
    pub roots: UVec4,
    /// +z, −z; the rest is padding.
    pub roots_z: UVec4,
}

const _: () = assert!(size_of::<LightSpace>() == 96);

impl LightSpace {
    /// A space with nothing in it.
    pub fn empty() -> Self {
        LightSpace { roots: UVec4::splat(NONE), roots_z: UVec4::splat(NONE), ..Zeroable::zeroed() }
    }

    /// Whether a valid ray is a point here: it starts within the box, and not too close to a positioned light.
    #[inline(always)]
    pub fn takes(&self, ray: &Ray) -> bool {
        let (o, low, high) = (ray.origin, self.low, self.high);
        let is_inside = low.x <= o.x && o.x <= high.x && low.y <= o.y && o.y <= high.y;
        let d = ray.direction.abs();
        let is_long = d.x > LEAST_LENGTH || d.y > LEAST_LENGTH || d.z > LEAST_LENGTH;
        is_inside && low.z <= o.z && o.z <= high.z && (self.is_parallel != 0 || is_long)
    }

    /// The third coordinate of a point's place.
    #[inline(always)]
    pub fn diagonal(&self, point: &LightPoint) -> f32 {
        self.diagonal.x * point.x + self.diagonal.y * point.y
    }

    /// The ray as a point, and the root of the tree that it walks ([`NONE`] for none). It must be one that is taken.
    #[inline(always)]
    pub fn point(&self, ray: &Ray) -> (LightPoint, u32) {
        if self.is_parallel != 0 {
            let origin = permute(ray.origin, self.axis);
            return (LightPoint::parallel(origin, self.middle, self.shear, self.sign), self.roots.x);
        }
        let (axis, sign) = main_axis(ray.direction);
        let is_negative = sign < 0.0;
        let root = if axis == 0 {
            if is_negative { self.roots.y } else { self.roots.x }
        } else if axis == 1 {
            if is_negative { self.roots.w } else { self.roots.z }
        } else if is_negative {
            self.roots_z.y
        } else {
            self.roots_z.x
        };
        (LightPoint::converging(permute(ray.direction, axis), sign), root)
    }
}
