//! Rectangles with a nearness: what a point must lie in and behind for a triangle to block it.
//!
//! The ray tracer says yes only to rays that meet the triangle's box widened by 16εR, at most 20εR with the slab test's own rounding: so to
//! none of nearness beyond that of the box, and for slivers to none beside the projection of the box. Of a triangle that is no
//! sliver the projection of the triangle itself will do: if a point outside of its rectangle passed all three edge tests, all three vertices would be seen
//! from it within an angle of 4ε, and the triangle would be a sliver. Vertices and point are off by 5εD, 2.5εD and 2.5εD.

use crate::block::BLOCK;
use crate::planes::{Corners, EPSILON, flat, planes};
use crate::view::{Rays, View};
use lt_bvh::lanes::Lanes;
use lt_bvh::{Triangle, permute};
use lt_math::glam::Vec3;

/// Margin of place for triangles that are no slivers, of nearness for all: in units of R.
pub(crate) const MARGIN: f32 = 32.0 * EPSILON;
/// Margin of place for slivers: that of a box, sheared.
const BOX_MARGIN: f32 = 80.0 * EPSILON;
/// Closer to a positioned light than this, in units of D, a triangle is clipped before its slopes are bounded.
pub(crate) const CLIP: f32 = 1e-3;

/// A rectangle of light space and the largest nearness in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Least x.
    pub x0: f32,
    /// Largest x.
    pub x1: f32,
    /// Least y.
    pub y0: f32,
    /// Largest y.
    pub y1: f32,
    /// Largest nearness; a point of more is blocked by nothing inside.
    pub z: f32,
}

impl Rect {
    /// Holds nothing.
    pub const EMPTY: Self = Self {
        x0: f32::INFINITY,
        x1: f32::NEG_INFINITY,
        y0: f32::INFINITY,
        y1: f32::NEG_INFINITY,
        z: f32::NEG_INFINITY,
    };

    /// The smallest rectangle over both.
    #[inline(always)]
    pub fn union(&self, other: &Self) -> Self {
        let min = |a: f32, b: f32| if a < b { a } else { b };
        let max = |a: f32, b: f32| if a > b { a } else { b };
        Rect {
            x0: min(self.x0, other.x0),
            x1: max(self.x1, other.x1),
            y0: min(self.y0, other.y0),
            y1: max(self.y1, other.y1),
            z: max(self.z, other.z),
        }
    }

    /// Whether `inner` lies within.
    pub fn holds(&self, inner: &Self) -> bool {
        self.x0 <= inner.x0
            && self.x1 >= inner.x1
            && self.y0 <= inner.y0
            && self.y1 >= inner.y1
            && self.z >= inner.z
    }

    /// Whether `inner` lies within, whatever its nearness.
    #[inline(always)]
    pub(crate) fn covers(&self, inner: &Self) -> bool {
        self.x0 <= inner.x0 && self.x1 >= inner.x1 && self.y0 <= inner.y0 && self.y1 >= inner.y1
    }

    /// What two rectangles that meet have in common, with the nearness of the other.
    #[inline(always)]
    pub(crate) fn common(&self, other: &Self) -> Self {
        let min = |a: f32, b: f32| if a < b { a } else { b };
        let max = |a: f32, b: f32| if a > b { a } else { b };
        Rect {
            x0: max(self.x0, other.x0),
            x1: min(self.x1, other.x1),
            y0: max(self.y0, other.y0),
            y1: min(self.y1, other.y1),
            z: other.z,
        }
    }

    /// Area; that of an empty one is 0.
    #[inline(always)]
    pub fn area(&self) -> f32 {
        let (w, h) = (self.x1 - self.x0, self.y1 - self.y0);
        if w > 0.0 && h > 0.0 { w * h } else { 0.0 }
    }

    fn with(self, x: f32, y: f32) -> Self {
        Rect { x0: self.x0.min(x), x1: self.x1.max(x), y0: self.y0.min(y), y1: self.y1.max(y), z: self.z }
    }

    pub(crate) fn widened(self, margin: f32) -> Self {
        Rect {
            x0: self.x0 - margin,
            x1: self.x1 + margin,
            y0: self.y0 - margin,
            y1: self.y1 + margin,
            ..self
        }
    }

    /// The rectangle of a triangle under a positioned light; see the [module](self). `None` where the view cannot see it.
    #[inline(always)]
    fn of_triangle(view: &View, light: Vec3, triangle: &Triangle, is_sliver: bool) -> Option<Self> {
        let corners = [triangle.v0, triangle.v1, triangle.v2];
        // x / z is the slope either way; distance along the face's axis is −sign · z.
        Self::seen(view, corners.map(|v| (permute(v, view.axis) - light) * -view.sign), is_sliver)
    }

    /// Of a triangle given relative to the light, with its distance along the face's axis as z.
    fn seen(view: &View, r: [Vec3; 3], is_sliver: bool) -> Option<Self> {
        let (low, high) = (r[0].min(r[1]).min(r[2]), r[0].max(r[1]).max(r[2]));
        let margin = if is_sliver { BOX_MARGIN } else { MARGIN } * view.reach;
        let near = low.z - MARGIN * view.reach;
        if high.z + margin < 0.0 {
            return None;
        }
        let mut rect = Self::EMPTY;
        rect.z = f32::INFINITY;
        if near > CLIP * view.size {
            rect.z = 1.0 / near * (1.0 + 8.0 * EPSILON);
            // Not clipped: slopes of vertices, or of the corners of the box.
            if is_sliver {
                rect = (0..8).map(|c| pick(low, high, c)).fold(rect, |q, v| q.with(v.x / v.z, v.y / v.z));
            } else {
                rect = r.into_iter().fold(rect, |q, v| q.with(v.x / v.z, v.y / v.z));
            }
            rect = rect.widened(2.0 * margin / near);
        } else if is_sliver {
            rect = Rect { x0: -1.0, x1: 1.0, y0: -1.0, y1: 1.0, ..rect };
        } else {
            rect = clipped(view, r)?;
        }
        let is_seen = rect.x0 <= 1.0 && rect.x1 >= -1.0 && rect.y0 <= 1.0 && rect.y1 >= -1.0;
        is_seen.then_some(rect)
    }
}

/// The rectangles of up to eight triangles, with [`Rect::EMPTY`] for what the view cannot see.
#[inline(always)]
pub(crate) fn rects<E: Lanes>(lanes: E, view: &View, triangles: &[Triangle]) -> [Rect; BLOCK] {
    rects_and_slivers(lanes, view, triangles).0
}

/// The same, and a bit for each that is a sliver.
#[inline(always)]
pub(crate) fn rects_and_slivers<E: Lanes>(
    lanes: E,
    view: &View,
    triangles: &[Triangle],
) -> ([Rect; BLOCK], u32) {
    let corners = Corners::load(lanes, view, triangles.iter());
    let (_, slivers) = planes(lanes, view, &corners);
    let mut rects = [Rect::EMPTY; BLOCK];
    match view.rays {
        Rays::Parallel { shear, middle, .. } => {
            let rows = sheared(lanes, view, corners.from(lanes, middle), shear, slivers);
            let mut out = [[0.0; BLOCK]; 5];
            for (out, row) in out.iter_mut().zip(rows) {
                lanes.store(row, out);
            }
            for (i, rect) in rects.iter_mut().enumerate() {
                *rect = Rect { x0: out[0][i], x1: out[1][i], y0: out[2][i], y1: out[3][i], z: out[4][i] };
            }
        }
        Rays::Converging { light } => {
            for (i, (rect, triangle)) in rects.iter_mut().zip(triangles).enumerate() {
                let seen = Rect::of_triangle(view, light, triangle, slivers >> i & 1 == 1);
                *rect = seen.unwrap_or(Rect::EMPTY);
            }
        }
    }
    (rects, slivers)
}

/// Rectangles under a sun: least and largest x, y, and the nearness. Vertices relative to the domain's middle.
#[inline(always)]
fn sheared<E: Lanes>(
    lanes: E,
    view: &View,
    [a, b, c]: [[E::F; 3]; 3],
    shear: Vec3,
    slivers: u32,
) -> [E::F; 5] {
    let (p, q, r) = (flat(lanes, a, shear), flat(lanes, b, shear), flat(lanes, c, shear));
    let (low_z, high_z) = (least(lanes, a[2], b[2], c[2]), most(lanes, a[2], b[2], c[2]));
    let margin = lanes.pick(slivers, lanes.splat(BOX_MARGIN * view.reach), lanes.splat(MARGIN * view.size));
    let mut rows = [margin; 5];
    for (axis, slope) in [shear.x, shear.y].into_iter().enumerate() {
        let slope = lanes.splat(slope);
        let (near, far) = (lanes.mul(slope, low_z), lanes.mul(slope, high_z));
        // Of a sliver the projection of the box.
        let box_low = lanes.sub(least(lanes, a[axis], b[axis], c[axis]), lanes.max(near, far));
        let box_high = lanes.sub(most(lanes, a[axis], b[axis], c[axis]), lanes.min(near, far));
        let low = lanes.pick(slivers, box_low, least(lanes, p[axis], q[axis], r[axis]));
        let high = lanes.pick(slivers, box_high, most(lanes, p[axis], q[axis], r[axis]));
        rows[2 * axis] = lanes.sub(low, margin);
        rows[2 * axis + 1] = lanes.add(high, margin);
    }
    let near = if view.sign > 0.0 { high_z } else { lanes.sub(lanes.splat(0.0), low_z) };
    rows[4] = lanes.add(near, lanes.splat(MARGIN * view.reach));
    rows
}

#[inline(always)]
fn least<E: Lanes>(lanes: E, a: E::F, b: E::F, c: E::F) -> E::F {
    lanes.min(lanes.min(a, b), c)
}

#[inline(always)]
fn most<E: Lanes>(lanes: E, a: E::F, b: E::F, c: E::F) -> E::F {
    lanes.max(lanes.max(a, b), c)
}

/// Corner 0 to 7 of a box.
#[inline(always)]
fn pick(low: Vec3, high: Vec3, corner: u32) -> Vec3 {
    Vec3::new(
        if corner & 1 == 0 { low.x } else { high.x },
        if corner & 2 == 0 { low.y } else { high.y },
        if corner & 4 == 0 { low.z } else { high.z },
    )
}

/// The rectangle of what lies in the face's pyramid, somewhat widened, of a triangle that comes close to the light's own plane.
fn clipped(view: &View, r: [Vec3; 3]) -> Option<Rect> {
    let full = Rect { x0: -1.0, x1: 1.0, y0: -1.0, y1: 1.0, z: f32::INFINITY };
    let shift = f64::from(view.size) * 1e-4;
    let mut polygon = [[0.0; 3]; 8];
    let mut len = 3;
    polygon[..3].copy_from_slice(&r.map(|v| v.to_array().map(f64::from)));
    for (axis, sign) in [(0, 1.0), (0, -1.0), (1, 1.0), (1, -1.0)] {
        let inside = |v: [f64; 3]| 1.001 * v[2] + shift - sign * v[axis];
        let (from, count) = (polygon, len);
        len = 0;
        for i in 0..count {
            let (a, b) = (from[i], from[(i + 1) % count]);
            let (da, db) = (inside(a), inside(b));
            if da >= 0.0 {
                polygon[len] = a;
                len += 1;
            }
            if (da < 0.0) != (db < 0.0) {
                let part = da / (da - db);
                polygon[len] = core::array::from_fn(|i| a[i] + (b[i] - a[i]) * part);
                len += 1;
            }
            if len == 8 {
                return Some(full);
            }
        }
        if len == 0 {
            return None;
        }
    }
    let mut rect = Rect { z: f32::INFINITY, ..Rect::EMPTY };
    let mut near = f32::INFINITY;
    for v in &polygon[..len] {
        near = near.min(v[2] as f32);
        if near <= CLIP * view.size {
            return Some(full);
        }
        rect = rect.with((v[0] / v[2]) as f32, (v[1] / v[2]) as f32);
    }
    Some(rect.widened(2.0 * MARGIN * view.reach / near))
}
