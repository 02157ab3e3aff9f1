//! The Hamburger and Hausdorff bounds of four weighted depths in hand: the Hankel minors by the Cauchy–Binet formula.
//!
//! Four moments are needed only where the depths have been blended away. With the depths themselves, every minor of the
//! Hankel matrix is a sum over pairs or triples of depths, made of their *differences* (Cauchy–Binet on the Vandermonde
//! factorisation): E\[x²\]E\[x⁴\] − E\[x³\]² = Σ wᵢwⱼ xᵢ²xⱼ²(xᵢ − xⱼ)². Nothing cancels, and no moment bias is needed.
//! Depths are measured from the receiver, which becomes 0, and scaled by a power of two; the problem is covariant.

use crate::float;
use crate::gather::lit_fraction;
use glam::Vec4;

/// How much nearer to the light the receiver is taken to be: 2⁻²¹, eight roundings of depths near 1.
///
/// A receiver on its own caster differs from the map by rounding, and the exact bound knows no mercy. Moving it to the
/// light keeps the bound an upper one; it takes the place of the moment bias of filtered maps.
pub const RECEIVER_ROUNDING: f32 = 4.768_371_6e-7;

/// What the bound does not fall below while the receiver is not behind the footprint's mean.
///
/// A sloped plane's own footprint has its mean at the receiver. Near a texel's centre that texel has nearly all the
/// weight and may lie just in front: the exact bound would then be sure of a shadow that is not there. Above LTT's ε, so
/// that a ray decides.
pub const OWN_SURFACE: f32 = 0.05;

/// Offsets are scaled as if the largest were at least this, 2⁻²⁰, lest sixth powers overflow.
const LEAST_SCALE: f32 = 9.536_743e-7;

/// A minor below this is that of a single depth besides the receiver's, but for shares of no account.
const SINGULAR: f32 = 1.0e-34;

/// Nodes this near outside an interval's end, relatively, count as inside: an atom on the very end must.
const END_TOLERANCE: f32 = 1.0e-5;

/// Receivers nearer to an interval's end, in scaled depth, are left to the Hamburger bound: the end's mass is rounding
/// over this.
const LEAST_END_DISTANCE: f32 = 1.0e-4;

/// Hamburger bound on P(z ≥ d) from depths in [0, 1] and their weights; NaN only for NaN.
#[inline]
pub fn hamburger_upper_bound(depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
    let atoms = Atoms::new(depths, weights, receiver_depth);
    if atoms.is_decided {
        return atoms.believable(atoms.decision);
    }
    atoms.believable(float::saturate(atoms.line_bound(atoms.inverse_nodes())))
}

/// Hausdorff bound on P(z ≥ d) from depths in [0, 1] and their weights; NaN only for NaN.
#[inline]
pub fn hausdorff_upper_bound(depths: Vec4, weights: Vec4, receiver_depth: f32) -> f32 {
    let atoms = Atoms::new(depths, weights, receiver_depth);
    if atoms.is_decided {
        return atoms.believable(atoms.decision);
    }
    let nodes = atoms.inverse_nodes();
    let line = atoms.line_bound(nodes);
    let is_free = atoms.is_in_interval(nodes.near) && atoms.is_in_interval(nodes.far);
    let is_at_end = -atoms.near_end < LEAST_END_DISTANCE || atoms.far_end < LEAST_END_DISTANCE;
    let bound = if is_free || is_at_end { line } else { float::min(atoms.interval_bound(), line) };
    atoms.believable(float::saturate(bound))
}

/// A distribution on four depths x, seen from a receiver at 0, with what all bounds need of it.
#[derive(Clone, Copy)]
struct Atoms {
    x: Vec4,
    weights: Vec4,
    /// The depths 0 and 1 in these coordinates.
    near_end: f32,
    far_end: f32,
    /// Squared distances of depths 0–1, 1–2, 2–3, 3–0.
    ring: Vec4,
    /// Squared distances of depths 0–2 and 1–3.
    diagonals: [f32; 2],
    /// The companions of 0 are the roots of c₀ + c₁x + c₂x²: the first column of the Hankel matrix's adjugate.
    c0: f32,
    c1: f32,
    c2: f32,
    /// Whether no system need be solved, and the answer then.
    is_decided: bool,
    decision: f32,
    /// Whether the receiver is not behind the mean, and so may be what the footprint shows.
    may_be_own_surface: bool,
}

/// 1/x of the two other depths of the extreme case, ascending; 0 stands for infinity, where no mass is.
#[derive(Clone, Copy)]
struct InverseNodes {
    near: f32,
    far: f32,
}

/// The lanes in the order y, z, w, x.
#[inline]
fn rotate(v: Vec4) -> Vec4 {
    Vec4::new(v.y, v.z, v.w, v.x)
}

#[inline]
fn sum(v: Vec4) -> f32 {
    v.x + v.y + v.z + v.w
}

/// Σ over pairs of f(pair)·`ring`/`diagonals`, where f is the product of the two lanes of `v`.
#[inline]
fn pair_products(v: Vec4, ring: Vec4, diagonals: [f32; 2]) -> (Vec4, f32, f32) {
    (v * rotate(v) * ring, v.x * v.z * diagonals[0], v.y * v.w * diagonals[1])
}

impl Atoms {
    #[inline]
    fn new(depths: Vec4, weights: Vec4, receiver_depth: f32) -> Self {
        let d = float::saturate(receiver_depth) - RECEIVER_ROUNDING;
        let offsets = float::saturate4(depths) - Vec4::splat(d);
        let o = offsets;
        let nearest = float::min(float::min(o.x, o.y), float::min(o.z, o.w));
        let farthest = float::max(float::max(o.x, o.y), float::max(o.z, o.w));
        let mean = float::dot4(offsets, weights);

        // A power of two scales without rounding: the exponent's bits of the largest offset. (Those of a NaN wrap.)
        let largest = float::max(float::max(-nearest, farthest), LEAST_SCALE);
        let exponent = largest.to_bits() & 0x7f80_0000;
        let scale = f32::from_bits((254u32 << 23).wrapping_sub(exponent));
        let x = offsets * scale;

        let difference = x - rotate(x);
        let ring = difference * difference;
        let diagonals = [(x.x - x.z) * (x.x - x.z), (x.y - x.w) * (x.y - x.w)];
        let (p, p02, p13) = pair_products(weights * x, ring, diagonals);
        let c0 = sum(p * (x * rotate(x))) + p02 * (x.x * x.z) + p13 * (x.y * x.w);
        let c1 = -(sum(p * (x + rotate(x))) + p02 * (x.x + x.z) + p13 * (x.y + x.w));
        let c2 = sum(p) + p02 + p13;

        // Lit as a whole; or one depth besides the receiver's, where the bound is attained; or NaN.
        let is_lit = nearest >= 0.0;
        let is_nan = float::is_nan(mean);
        let decision = if is_nan {
            mean
        } else if is_lit {
            1.0
        } else {
            float::saturate(lit_fraction(x, weights, 0.0))
        };
        Self {
            x,
            weights,
            near_end: -d * scale,
            far_end: (1.0 - d) * scale,
            ring,
            diagonals,
            c0,
            c1,
            c2,
            is_decided: is_nan || is_lit || c0 < SINGULAR,
            decision,
            may_be_own_surface: mean >= 0.0,
        }
    }

    /// The bound, but not sure of a shadow where the footprint may show the receiver itself; see [`OWN_SURFACE`].
    #[inline]
    fn believable(&self, bound: f32) -> f32 {
        if self.may_be_own_surface && bound < OWN_SURFACE { OWN_SURFACE } else { bound }
    }

    /// Roots of c₀y² + c₁y + c₂. The larger comes first, the other from their product, so that neither cancels.
    #[inline]
    fn inverse_nodes(&self) -> InverseNodes {
        let half = 0.5 * self.c1 / self.c0;
        let product = self.c2 / self.c0;
        let discriminant = half * half - product;
        // Exactly, the roots are real; a GPU's root of a negative number is anything.
        let root = if discriminant > 0.0 { float::sqrt(discriminant) } else { 0.0 };
        if half > 0.0 {
            let y = -half - root;
            let other = product / y;
            InverseNodes { near: y, far: other }
        } else {
            let y = root - half;
            let other = if y > 0.0 { product / y } else { 0.0 };
            InverseNodes { near: other, far: y }
        }
    }

    /// The mass on the receiver's depth in the extreme case on the line: the Hankel determinant over its minor.
    #[inline]
    fn mass_on_receiver(&self) -> f32 {
        let (w, e, [e02, e13]) = (self.weights, self.ring, self.diagonals);
        let triples = w * rotate(w) * rotate(rotate(w)) * e * rotate(e) * Vec4::new(e02, e13, e02, e13);
        sum(triples) / self.c0
    }

    /// The mass of the receiver and of all behind it, summed on the side of the node that is farther away.
    #[inline]
    fn line_bound(&self, nodes: InverseNodes) -> f32 {
        let (u, v) = (nodes.near, nodes.far);
        if u >= 0.0 {
            return 1.0;
        }
        if v <= 0.0 {
            return self.mass_on_receiver();
        }
        let first = float::dot4(self.weights, self.x);
        let second = float::dot4(self.weights, self.x * self.x);
        if -u <= v {
            1.0 - u * u * (v * second - first) / (v - u)
        } else {
            self.mass_on_receiver() + v * v * (first - u * second) / (v - u)
        }
    }

    /// Whether a node lies in the interval of possible depths; infinity does not.
    #[inline]
    fn is_in_interval(&self, inverse_node: f32) -> bool {
        let y = inverse_node;
        y * self.near_end >= 1.0 - END_TOLERANCE || y * self.far_end >= 1.0 - END_TOLERANCE
    }

    /// The bound where a node would leave the interval: the support is then {near end, inner, 0, far end} instead.
    #[inline]
    fn interval_bound(&self) -> f32 {
        let (x, l, r) = (self.x, self.near_end, self.far_end);
        let from_near = x - Vec4::splat(l);
        let from_far = Vec4::splat(r) - x;
        // Weighted by the distances to both ends, which the ends do not outlive: two nodes remain, 0 and inner.
        let q = self.weights * from_near * from_far;
        let first = float::dot4(q, x);
        let second = float::dot4(q, x * x);
        if second < SINGULAR {
            return lit_fraction(x, self.weights, 0.0);
        }
        let j = first / second;
        let tail = self.weights * x * (Vec4::ONE - j * x);
        if j > 0.0 {
            1.0 - sum(tail * from_far) / (l * (l * j - 1.0) * (l - r))
        } else {
            let (p, p02, p13) = pair_products(q, self.ring, self.diagonals);
            let on_receiver = (sum(p) + p02 + p13) / (second * (-l * r));
            on_receiver + sum(tail * from_near) / (r * (1.0 - j * r) * (r - l))
        }
    }
}
