//! The light's own space: where a shadow ray is a point and "blocked" is "inside a triangle and beyond its plane".
//!
//! A [`View`] maps shadow rays to points (X, Y, Z) and triangles to planes that are **affine in X and Y**, for a sun and for a light
//! with a position alike:
//!
//! | | X, Y | Z, larger towards the light |
//! |---|---|---|
//! | sun | the ray tracer's shear: x − sₓz, y − s_yz | z along the shear's axis |
//! | face of a positioned light | slopes of the ray, which are the ray tracer's sₓ and s_y | 1 / distance along the axis |
//!
//! The axis is the world axis of the ray's largest component, as in the ray tracer's triangle test; so a positioned light sees six
//! faces of a cube, and no frame of its own needs to be chosen.

use lt_bvh::lanes::Lanes;
use lt_bvh::{LEAST_LENGTH, LightPoint, LightSpace, Ray, main_axis, permute, reciprocal};
use lt_math::glam::{Vec2, Vec3, Vec4};

/// An axis-aligned box in world space; empty where `low > high`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// Lower corner.
    pub low: Vec3,
    /// Upper corner.
    pub high: Vec3,
}

impl Bounds {
    /// Contains nothing.
    pub const EMPTY: Self = Self { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    /// The smallest box that holds this one and a point.
    #[inline]
    pub fn with(self, point: Vec3) -> Self {
        Self { low: self.low.min(point), high: self.high.max(point) }
    }

    /// Whether the point lies in the box, faces included; never for NaN.
    #[inline]
    pub fn contains(&self, p: Vec3) -> bool {
        p.cmpge(self.low).all() && p.cmple(self.high).all()
    }
}

/// How the rays of a view run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rays {
    /// All in one direction: the ray tracer's sₓ, s_y and s_z for it, its reciprocals and the middle of the domain in permuted axes.
    Parallel { shear: Vec3, inverse: Vec3, middle: Vec3 },
    /// To one point, given in permuted axes.
    Converging { light: Vec3 },
}

/// One light, or one of the six faces of a light with a position: maps shadow rays to points (X, Y, Z), and triangles to planes affine
/// in X and Y.
///
/// X and Y are the ray tracer's sheared coordinates under a sun, the slopes of the ray under a light with a position; Z grows towards the
/// light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    pub(crate) rays: Rays,
    /// Axis of the rays' largest component, which becomes z.
    pub(crate) axis: u32,
    /// Sign of that component.
    pub(crate) sign: f32,
    /// D of the error bounds: at least the distance along any axis between any two of: ray origins, vertices, the light.
    pub(crate) size: f32,
    /// The same with the root box of the ray tracer's tree, which its margins are in proportion to.
    pub(crate) reach: f32,
    /// Factors on the error bounds of edges and depth: 1. Tests show what less does.
    pub(crate) caution: [f32; 2],
    /// That root box, in permuted axes.
    pub(crate) root: Bounds,
    /// Where rays may start.
    domain: Bounds,
}

impl View {
    /// The views of a homogeneous light (w = 0: a sun, `xyz` pointing to it; w = 1: a position): one or six, and none for a light that
    /// no ray can be shot at (NaN, or a zero direction).
    ///
    /// `domain` must hold every triangle; rays that start in it are answered fast. `root` is [`crate::Casters::root`] of the same triangles.
    pub fn of_light(light: Vec4, domain: Bounds, root: Bounds) -> impl Iterator<Item = View> {
        let direction = light.truncate();
        let is_usable =
            Ray::new(Vec3::ZERO, direction).is_valid() || (light.w != 0.0 && direction.is_finite());
        let views = if !is_usable {
            0
        } else if light.w == 0.0 {
            1
        } else {
            6
        };
        (0..views).map(move |face| {
            if light.w == 0.0 {
                Self::sun(direction, domain, root)
            } else {
                Self::lamp(direction, face, domain, root)
            }
        })
    }

    fn sun(direction: Vec3, domain: Bounds, root: Bounds) -> Self {
        let (axis, sign) = main_axis(direction);
        let p = permute(direction, axis);
        let middle = permute(domain.low * 0.5 + domain.high * 0.5, axis);
        let shear = Vec3::new(p.x / p.z, p.y / p.z, 1.0 / p.z);
        let rays = Rays::Parallel { shear, inverse: permute(reciprocal(direction), axis), middle };
        Self::new(rays, axis, sign, domain, domain, root)
    }

    fn lamp(light: Vec3, face: u32, domain: Bounds, root: Bounds) -> Self {
        let axis = face >> 1;
        let sign = if face & 1 == 0 { 1.0 } else { -1.0 };
        let rays = Rays::Converging { light: permute(light, axis) };
        Self::new(rays, axis, sign, domain, domain.with(light), root)
    }

    fn new(rays: Rays, axis: u32, sign: f32, domain: Bounds, all: Bounds, root: Bounds) -> Self {
        // A little more than the true extent, for the rounding of the difference itself.
        let size = (all.high - all.low).max_element() * 1.000_001;
        let with_root = all.with(root.low).with(root.high);
        let reach = (with_root.high - with_root.low).max_element() * 1.000_001;
        let root = Bounds { low: permute(root.low, axis), high: permute(root.high, axis) };
        View { rays, axis, sign, size, reach, caution: [1.0; 2], root, domain }
    }

    /// Whether the view takes this ray: it starts in the domain and leaves through this face.
    #[inline(always)]
    pub fn takes(&self, ray: &Ray) -> bool {
        self.is_near(ray) && self.faces(ray)
    }

    /// Whether the ray leaves through this face, yet is none that planes are made for.
    pub(crate) fn is_stray(&self, ray: &Ray) -> bool {
        !self.is_near(ray) && self.faces(ray) && ray.is_valid()
    }

    /// Whether the ray starts in the domain, and not so close to the light that its nearness is no number.
    #[inline(always)]
    fn is_near(&self, ray: &Ray) -> bool {
        let length = ray.direction[self.axis as usize].abs();
        self.domain.contains(ray.origin)
            && (matches!(self.rays, Rays::Parallel { .. }) || length > LEAST_LENGTH)
    }

    #[inline(always)]
    fn faces(&self, ray: &Ray) -> bool {
        matches!(self.rays, Rays::Parallel { .. }) || main_axis(ray.direction) == (self.axis, self.sign)
    }

    /// The ray as a point. It must be one that the view takes.
    #[inline(always)]
    pub fn point(&self, ray: &Ray) -> LightPoint {
        match self.rays {
            Rays::Parallel { shear, middle, .. } => {
                LightPoint::parallel(permute(ray.origin, self.axis), middle, shear.truncate(), self.sign)
            }
            Rays::Converging { .. } => LightPoint::converging(permute(ray.direction, self.axis), self.sign),
        }
    }

    /// The view for kernels, which know all views of a light as one space; without trees.
    pub(crate) fn space(&self) -> LightSpace {
        let space = LightSpace { low: self.domain.low, high: self.domain.high, ..LightSpace::empty() };
        match self.rays {
            Rays::Parallel { shear, middle, .. } => {
                let shear = shear.truncate();
                // Along z, X changes by −sₓ and Y by −s_y.
                let across = Vec2::new(shear.y, -shear.x);
                let size = across.abs().max_element();
                let diagonal = if size > 0.0 { across / size } else { Vec2::ONE };
                let (axis, sign) = (self.axis, self.sign);
                LightSpace { shear, diagonal, middle, axis, sign, is_parallel: 1, ..space }
            }
            Rays::Converging { .. } => LightSpace { diagonal: Vec2::ONE, ..space },
        }
    }

    /// Where rays of this view find their root in a [`LightSpace`].
    pub(crate) fn face(&self) -> usize {
        match self.rays {
            Rays::Parallel { .. } => 0,
            Rays::Converging { .. } => 2 * self.axis as usize + usize::from(self.sign < 0.0),
        }
    }

    /// The coordinates that become x, y and z.
    #[inline(always)]
    pub(crate) fn axes(&self) -> [usize; 3] {
        lt_bvh::lanes::watertight::axes(self.axis as usize)
    }

    /// [`View::point`] and [`View::takes`] of several rays, given by their origins in permuted axes.
    #[inline(always)]
    pub(crate) fn points<L: Lanes>(&self, lanes: L, origin: [L::F; 3]) -> ([L::F; 3], u32) {
        let (low, high) = (permute(self.domain.low, self.axis), permute(self.domain.high, self.axis));
        let mut taken = lanes.le(lanes.splat(low.x), origin[0]) & lanes.le(origin[0], lanes.splat(high.x));
        taken &= lanes.le(lanes.splat(low.y), origin[1]) & lanes.le(origin[1], lanes.splat(high.y));
        taken &= lanes.le(lanes.splat(low.z), origin[2]) & lanes.le(origin[2], lanes.splat(high.z));
        let sign = lanes.splat(self.sign);
        match self.rays {
            Rays::Parallel { shear, middle, .. } => {
                let qx = lanes.sub(origin[0], lanes.splat(middle.x));
                let qy = lanes.sub(origin[1], lanes.splat(middle.y));
                let qz = lanes.sub(origin[2], lanes.splat(middle.z));
                let x = lanes.neg_mul_add(lanes.splat(shear.x), qz, qx);
                let y = lanes.neg_mul_add(lanes.splat(shear.y), qz, qy);
                ([x, y, lanes.mul(sign, qz)], taken)
            }
            Rays::Converging { light } => {
                let dx = lanes.sub(lanes.splat(light.x), origin[0]);
                let dy = lanes.sub(lanes.splat(light.y), origin[1]);
                let dz = lanes.sub(lanes.splat(light.z), origin[2]);
                let (ax, ay, length) = (lanes.abs(dx), lanes.abs(dy), lanes.mul(sign, dz));
                taken &= lanes.lt(lanes.splat(LEAST_LENGTH), length);
                // Of equally large components the first in the order x, y, z is the main one; the axes here are turned.
                taken &= if self.axis == 2 { lanes.lt(ax, length) } else { lanes.le(ax, length) };
                taken &= if self.axis == 0 { lanes.le(ay, length) } else { lanes.lt(ay, length) };
                ([lanes.div(dx, dz), lanes.div(dy, dz), lanes.div(sign, dz)], taken)
            }
        }
    }

    /// Whether no triangle is out of sight.
    pub(crate) fn sees_all(&self) -> bool {
        matches!(self.rays, Rays::Parallel { .. })
    }

    /// The depth test's tolerance of a point of nearness z is `.0 + .1 · z`; see [`crate::planes`].
    #[inline(always)]
    pub(crate) fn depth_tolerance(&self) -> (f32, f32) {
        match self.rays {
            Rays::Parallel { .. } => (1.0, 0.0),
            Rays::Converging { .. } => (0.0, 1.0),
        }
    }
}
