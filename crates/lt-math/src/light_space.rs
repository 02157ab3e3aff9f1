//! World to light map: linear maps for directional, spot and cube-face lights, with depth linear along the light's axis.
//!
//! Positions are f32 and must be relative to an origin near the viewer: at 6·10⁶ units an f32 step is half a unit, and
//! nothing computed from it can be better. Scenes that large keep their own f64 origin and hand over differences. The
//! rows themselves are computed in f64 on the host and rounded once.

use crate::float;
#[cfg(not(target_arch = "spirv"))]
use crate::light_frame::LightFrame;
use bytemuck::{Pod, Zeroable};
use glam::{Vec2, Vec3, Vec4};

/// A light map's projection as four rows: h = (row_x·p, row_y·p, row_w·p) with p = (x, y, z, 1).
///
/// uv = h.xy / h.w lies in [0, 1]² on the map, v downwards, texel row 0 at v = 0; depth = row_z·p is 0 on the near and 1
/// on the far plane, never divided. Directional lights have row_w = (0, 0, 0, 1).
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct LightProjection {
    /// u · w
    pub row_x: Vec4,
    /// v · w
    pub row_y: Vec4,
    /// Linear depth
    pub row_z: Vec4,
    /// w: distance along the axis for spot and point lights, 1 for directional ones
    pub row_w: Vec4,
}

const _: () = assert!(size_of::<LightProjection>() == 64);

/// A world position as a light map sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightPoint {
    /// Place on the map, [0, 1]² inside; v downwards. Multiply by the map's size for texels.
    pub uv: Vec2,
    /// Linear depth, 0 near and 1 far.
    pub depth: f32,
    /// Whether uv and depth are in [0, 1] and the point is in front of the light; false for NaN.
    pub is_inside: bool,
}

impl LightPoint {
    /// Whether it is inside and at least `margin` (in uv) away from the map's edges; not so for NaN.
    #[inline]
    pub fn is_within(&self, margin: f32) -> bool {
        self.is_inside
            && self.uv.x >= margin
            && self.uv.x <= 1.0 - margin
            && self.uv.y >= margin
            && self.uv.y <= 1.0 - margin
    }
}

impl LightProjection {
    /// Projects a world position. Outside the map, `is_inside` is false and the pixel needs a ray.
    #[inline]
    pub fn project(&self, p: Vec3) -> LightPoint {
        let p = Vec4::new(p.x, p.y, p.z, 1.0);
        let w = float::dot4(self.row_w, p);
        let uv = Vec2::new(float::dot4(self.row_x, p) / w, float::dot4(self.row_y, p) / w);
        let depth = float::dot4(self.row_z, p);
        let is_inside = w > 0.0 && is_unit(uv.x) && is_unit(uv.y) && is_unit(depth);
        LightPoint { uv, depth, is_inside }
    }
}

/// Whether `x` lies in [0, 1]; not so for NaN.
#[inline]
#[expect(clippy::manual_range_contains, reason = "rust-gpu 0.11 cannot compile RangeInclusive::contains")]
fn is_unit(x: f32) -> bool {
    x >= 0.0 && x <= 1.0
}

#[cfg(not(target_arch = "spirv"))]
impl LightProjection {
    /// A directional light: the box from `min` to `max`, given in `frame` (see [`LightFrame::to_light`]), fills the map.
    ///
    /// An empty or inverted box gives a projection that no point is inside of.
    pub fn orthographic(frame: &LightFrame, min: Vec3, max: Vec3) -> Self {
        let (min, max) = (min.to_array().map(f64::from), max.to_array().map(f64::from));
        if !(min[0] < max[0] && min[1] < max[1] && min[2] < max[2]) {
            return Self::NOWHERE;
        }
        let size = [max[0] - min[0], max[1] - min[1], max[2] - min[2]];
        Self {
            row_x: row(frame.right, 1.0 / size[0], -min[0] / size[0]),
            row_y: row(frame.up, -1.0 / size[1], max[1] / size[1]),
            row_z: row(frame.forward, 1.0 / size[2], -min[2] / size[2]),
            row_w: Vec4::W,
        }
    }

    /// A spot light at `eye` looking along `frame.forward`: a square pyramid of full opening angle `fov_rad`, between the
    /// planes at distances `near` and `far` along the axis.
    ///
    /// Angles outside (0, π), or not 0 ≤ near < far, give a projection that no point is inside of.
    pub fn perspective(eye: Vec3, frame: &LightFrame, fov_rad: f32, near: f32, far: f32) -> Self {
        if !(fov_rad > 0.0 && fov_rad < core::f32::consts::PI) {
            return Self::NOWHERE;
        }
        Self::pyramid(eye, frame, num_traits::Float::tan(0.5 * f64::from(fov_rad)), near, far)
    }

    /// [`LightProjection::perspective`] of half the angle `cone_rad`, widened so that `border_texels` texels on each side of
    /// a map of `map_size`² lie outside that angle: footprints at the cone's edge find all their texels.
    ///
    /// Angles outside (0, π/2), a map of no more than two borders, or not 0 ≤ near < far, give a projection that no point is
    /// inside of.
    pub fn bordered(
        eye: Vec3,
        frame: &LightFrame,
        cone_rad: f32,
        (border_texels, map_size): (u32, u32),
        near: f32,
        far: f32,
    ) -> Self {
        if !(cone_rad > 0.0 && cone_rad < core::f32::consts::FRAC_PI_2 && map_size > 2 * border_texels) {
            return Self::NOWHERE;
        }
        let widened = f64::from(map_size) / f64::from(map_size - 2 * border_texels);
        Self::pyramid(eye, frame, num_traits::Float::tan(f64::from(cone_rad)) * widened, near, far)
    }

    /// Face 0…5 (+X, −X, +Y, −Y, +Z, −Z) of a point light at `eye`; see [`LightFrame::of_cube_face`].
    ///
    /// Not 0 ≤ near < far gives a projection that no point is inside of.
    pub fn cube_face(eye: Vec3, face: u32, near: f32, far: f32) -> Self {
        Self::pyramid(eye, &LightFrame::of_cube_face(face), 1.0, near, far)
    }

    /// Has no inside: w is 0 everywhere.
    const NOWHERE: Self = Self { row_x: Vec4::ZERO, row_y: Vec4::ZERO, row_z: Vec4::ZERO, row_w: Vec4::ZERO };

    fn pyramid(eye: Vec3, frame: &LightFrame, tangent: f64, near: f32, far: f32) -> Self {
        if !(near >= 0.0 && near < far) {
            return Self::NOWHERE;
        }
        let (near, range) = (f64::from(near), f64::from(far) - f64::from(near));
        let along = |axis: Vec3| (axis.to_array().map(f64::from), -dot(axis, eye));
        let (right, right_offset) = along(frame.right);
        let (up, up_offset) = along(frame.up);
        let (forward, forward_offset) = along(frame.forward);
        let scale = 0.5 / tangent;
        let combine = |a: [f64; 3], a_offset: f64, s: f64| {
            Vec4::new(
                (s * a[0] + 0.5 * forward[0]) as f32,
                (s * a[1] + 0.5 * forward[1]) as f32,
                (s * a[2] + 0.5 * forward[2]) as f32,
                (s * a_offset + 0.5 * forward_offset) as f32,
            )
        };
        Self {
            row_x: combine(right, right_offset, scale),
            row_y: combine(up, up_offset, -scale),
            row_z: row(frame.forward, 1.0 / range, (forward_offset - near) / range),
            row_w: row(frame.forward, 1.0, forward_offset),
        }
    }
}

/// (axis · scale, offset), rounded once.
#[cfg(not(target_arch = "spirv"))]
fn row(axis: Vec3, scale: f64, offset: f64) -> Vec4 {
    let [x, y, z] = axis.to_array().map(|a| (f64::from(a) * scale) as f32);
    Vec4::new(x, y, z, offset as f32)
}

#[cfg(not(target_arch = "spirv"))]
fn dot(a: Vec3, b: Vec3) -> f64 {
    let (a, b) = (a.to_array().map(f64::from), b.to_array().map(f64::from));
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::light_frame::cube_face_of_direction;
    use proptest::prelude::*;

    fn near(a: f32, b: f32) -> bool {
        (a - b).abs() < 1e-5
    }

    #[test]
    fn the_box_of_a_directional_light_fills_the_map() {
        let frame = LightFrame::from_direction(Vec3::new(0.3, -1.0, 0.2));
        let (min, max) = (Vec3::new(-2.0, -3.0, -5.0), Vec3::new(4.0, 1.0, 7.0));
        let projection = LightProjection::orthographic(&frame, min, max);
        let world = |l: Vec3| frame.right * l.x + frame.up * l.y + frame.forward * l.z;
        for (corner, uv, depth) in [
            (Vec3::new(-2.0, 1.0, -5.0), [0.0, 0.0], 0.0),
            (Vec3::new(4.0, 1.0, 7.0), [1.0, 0.0], 1.0),
            (Vec3::new(-2.0, -3.0, 1.0), [0.0, 1.0], 0.5),
            (Vec3::new(1.0, -1.0, 4.0), [0.5, 0.5], 0.75),
        ] {
            let p = projection.project(world(corner));
            assert!(near(p.uv.x, uv[0]) && near(p.uv.y, uv[1]) && near(p.depth, depth), "{corner} {p:?}");
        }
        assert_eq!(projection.row_w, Vec4::W);
        assert!(projection.project(world(Vec3::new(0.0, 0.0, 0.0))).is_inside);
        for outside in [
            Vec3::new(4.1, 0.0, 0.0),
            Vec3::new(-2.1, 0.0, 0.0),
            Vec3::new(0.0, 1.1, 0.0),
            Vec3::new(0.0, -3.1, 0.0),
            Vec3::new(0.0, 0.0, 7.1),
            Vec3::new(0.0, 0.0, -5.1),
        ] {
            assert!(!projection.project(world(outside)).is_inside, "{outside}");
        }
    }

    #[test]
    fn a_spot_light_sees_a_pyramid_with_linear_depth() {
        let frame = LightFrame::from_direction(Vec3::NEG_Z);
        let eye = Vec3::new(1.0, 2.0, 3.0);
        let projection = LightProjection::perspective(eye, &frame, core::f32::consts::FRAC_PI_2, 1.0, 9.0);
        let at = |x: f32, y: f32, z: f32| {
            projection.project(eye + frame.right * x + frame.up * y + frame.forward * z)
        };
        let middle = at(0.0, 0.0, 5.0);
        assert!(
            near(middle.uv.x, 0.5) && near(middle.uv.y, 0.5) && near(middle.depth, 0.5) && middle.is_inside
        );
        let corner = at(-5.0, 5.0, 5.0);
        assert!(near(corner.uv.x, 0.0) && near(corner.uv.y, 0.0));
        assert!(near(at(2.0, 0.0, 4.0).uv.x, 0.75) && near(at(0.0, 2.0, 4.0).uv.y, 0.25));
        assert!(at(0.0, 0.0, 1.01).is_inside && at(0.0, 0.0, 8.99).is_inside);
        for outside in
            [at(0.0, 0.0, 0.9), at(0.0, 0.0, 9.1), at(0.0, 0.0, -5.0), at(0.0, 0.0, 0.0), at(5.1, 0.0, 5.0)]
        {
            assert!(!outside.is_inside, "{outside:?}");
        }
    }

    proptest! {
        #[test]
        fn every_direction_lies_well_inside_some_bordered_face(
            x in -1.0f32..1.0, y in -1.0f32..1.0, z in -1.0f32..1.0, snap in 0u32..4
        ) {
            // Onto the faces' borders and corners, too.
            let largest = x.abs().max(y.abs()).max(z.abs());
            let onto = |c: f32, bit: u32| if snap & bit != 0 { largest.copysign(c) } else { c };
            let direction = Vec3::new(onto(x, 1), onto(y, 2), z);
            prop_assume!(largest > 0.02);
            let eye = Vec3::new(3.0, -4.0, 5.0);
            let faces: [LightProjection; 6] = core::array::from_fn(|face| {
                let frame = LightFrame::of_cube_face(face as u32);
                LightProjection::bordered(eye, &frame, core::f32::consts::FRAC_PI_4, (2, 512), 0.0, 10.0)
            });
            let levels = crate::Levels { projections: &faces, count: 6 };
            prop_assert!(crate::LevelSource::find(&levels, eye + direction, 512).point.is_inside, "{direction}");
        }

        #[test]
        fn every_direction_is_inside_exactly_the_face_it_leaves_through(
            x in -1.0f32..1.0, y in -1.0f32..1.0, z in -1.0f32..1.0
        ) {
            let direction = Vec3::new(x, y, z);
            let a = direction.abs();
            let mut sorted = a.to_array();
            sorted.sort_by(f32::total_cmp);
            prop_assume!(sorted[2] > 0.02 && sorted[2] - sorted[1] > 1e-4);
            let eye = Vec3::new(3.0, -4.0, 5.0);
            for face in 0..6 {
                let p = LightProjection::cube_face(eye, face, 0.01, 10.0).project(eye + direction);
                prop_assert_eq!(p.is_inside, face == cube_face_of_direction(direction), "{:?}", p);
            }
        }
    }

    #[test]
    fn nan_and_infinity_are_outside() {
        let frame = LightFrame::from_direction(Vec3::NEG_Y);
        for projection in [
            LightProjection::orthographic(&frame, Vec3::NEG_ONE, Vec3::ONE),
            LightProjection::perspective(Vec3::ZERO, &frame, 1.0, 0.1, 1.0),
        ] {
            for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
                for p in [Vec3::new(bad, 0.0, -0.5), Vec3::new(0.0, bad, 0.0), Vec3::splat(bad)] {
                    assert!(!projection.project(p).is_inside, "{p}");
                }
            }
        }
    }

    #[test]
    fn senseless_parameters_have_no_inside() {
        let frame = LightFrame::from_direction(Vec3::NEG_Y);
        let spot = |fov, near, far| LightProjection::perspective(Vec3::ZERO, &frame, fov, near, far);
        for projection in [
            LightProjection::orthographic(&frame, Vec3::ONE, Vec3::NEG_ONE),
            LightProjection::orthographic(&frame, Vec3::ZERO, Vec3::ZERO),
            LightProjection::orthographic(&frame, Vec3::NAN, Vec3::ONE),
            spot(0.0, 0.1, 1.0),
            spot(4.0, 0.1, 1.0),
            spot(f32::NAN, 0.1, 1.0),
            spot(1.0, 1.0, 1.0),
            spot(1.0, -1.0, 1.0),
            LightProjection::cube_face(Vec3::ZERO, 0, 2.0, 1.0),
        ] {
            for p in [Vec3::ZERO, Vec3::new(0.0, -0.5, 0.0), Vec3::new(0.5, 0.0, 0.0)] {
                assert!(!projection.project(p).is_inside, "{projection:?}");
            }
        }
    }

    /// The rounding that the module's documentation warns of, as map texels of 2048 over 100 units.
    #[test]
    fn offsets_of_500_and_8000_keep_a_tenth_of_a_texel() {
        let frame = LightFrame::from_direction(Vec3::new(0.3, -1.0, 0.2));
        for origin in [500.0f32, 8000.0] {
            let p = Vec3::splat(origin);
            let centre = frame.to_light(p);
            let projection = LightProjection::orthographic(&frame, centre - 50.0, centre + 50.0);
            for i in 0..100 {
                let shift = Vec3::new(i as f32 * 0.25 - 12.5, i as f32 * 0.125 - 6.0, 1.0);
                let exact = |axis: Vec3, centre: f32| {
                    let (a, q) = (axis.to_array(), (p + shift).to_array());
                    (0..3).map(|k| f64::from(a[k]) * f64::from(q[k])).sum::<f64>() - f64::from(centre)
                };
                let u = exact(frame.right, centre.x) / 100.0 + 0.5;
                let error = (f64::from(projection.project(p + shift).uv.x) - u).abs() * 2048.0;
                assert!(error < 0.1, "{origin}: {error} texels");
            }
        }
    }
}
