//! Hamburger and Hausdorff bounds of four weighted depths in hand, biased: Hankel minors by the Cauchy–Binet formula.
//!
//! Four moments are needed only where the depths have been blended away. With the depths themselves, every minor of the
//! Hankel matrix is a sum over pairs or triples of depths, made of their *differences* (Cauchy–Binet on the Vandermonde
//! factorisation): E\[x²\]E\[x⁴\] − E\[x³\]² = Σ wᵢwⱼ xᵢ²xⱼ²(xᵢ − xⱼ)². No minor is a difference of two larger numbers.
//!
//! The moment bias b (Peters & Klein 2015, Alg. 2) mixes in the moments (½, ½, ½, ½), and these are the moments of a coin
//! toss between the depths 0 and 1. So a biased footprint is a distribution on six atoms: its four depths with the weights
//! (1 − b)wᵢ, and both ends of the range with b/2 each. What the paper introduces against rounding is kept for what else
//! it does: it blurs every depth by about √b, so that a sloped surface is not sure of its own shadow.
//!
//! Depths are measured from the receiver, which becomes 0. A depth's distances to the two ends are then z and 1 − z.

use crate::float;
use crate::gather::lit_fraction;
use glam::{Vec4, Vec4Swizzles};

/// How much nearer to the light the receiver is taken to be: 2⁻²¹, eight roundings of depths near 1.
///
/// The bias blurs a depth z by about √b·z(1 − z): not at the ends of the range, where a receiver on its own caster would
/// differ from the map by rounding and be sure of a shadow. Moving it to the light keeps the bound an upper one.
pub const RECEIVER_ROUNDING: f32 = 4.768_371_6e-7;

/// A minor below this is that of a single depth besides the receiver's, but for shares of no account.
const SINGULAR: f32 = 1.0e-34;

/// Hamburger bound on P(z ≥ d) from four depths in \[0, 1\], their weights, and the share `moment_bias` of a coin toss
/// between the ends.
///
/// 1 where no depth is in front of the receiver. NaN only for NaN.
#[inline]
pub fn hamburger_upper_bound(depths: Vec4, weights: Vec4, receiver_depth: f32, moment_bias: f32) -> f32 {
    upper_bound::<false>(depths, weights, receiver_depth, moment_bias)
}

/// Hausdorff bound on P(z ≥ d) from four depths in \[0, 1\], their weights, and the share `moment_bias` of a coin toss
/// between the ends; never above [`hamburger_upper_bound`] but for rounding (1e-6).
///
/// 1 where no depth is in front of the receiver. NaN only for NaN.
#[inline]
pub fn hausdorff_upper_bound(depths: Vec4, weights: Vec4, receiver_depth: f32, moment_bias: f32) -> f32 {
    upper_bound::<true>(depths, weights, receiver_depth, moment_bias)
}

#[inline]
fn upper_bound<const IS_BOUNDED: bool>(
    depths: Vec4,
    weights: Vec4,
    receiver_depth: f32,
    moment_bias: f32,
) -> f32 {
    let d = float::saturate(receiver_depth) - RECEIVER_ROUNDING;
    let z = float::saturate4(depths);
    let x = z - Vec4::splat(d);
    // NaN if anything is.
    let mean = float::dot4(x, weights);
    if float::is_nan(mean) {
        return mean;
    }
    if is_in_front(x) {
        return 1.0;
    }
    let atoms = Atoms::new(x, z, d, weights, moment_bias);
    if atoms.c0 < SINGULAR {
        return atoms.attained_bound();
    }
    if IS_BOUNDED {
        let interval = atoms.interval_bound();
        if interval < 1.0 {
            return float::saturate(interval);
        }
    }
    float::saturate(atoms.line_bound(atoms.inverse_nodes()))
}

/// Whether the receiver is in front of, or at, all four depths.
#[inline]
fn is_in_front(x: Vec4) -> bool {
    x.x >= 0.0 && x.y >= 0.0 && x.z >= 0.0 && x.w >= 0.0
}

/// A distribution on four depths and the two ends, seen from a receiver at 0, with what all bounds need of it.
#[derive(Clone, Copy)]
struct Atoms {
    x: Vec4,
    /// Distances of the depths from the ends 0 and 1.
    from_near: Vec4,
    from_far: Vec4,
    /// (1 − b)·w
    weights: Vec4,
    /// b/2
    end_mass: f32,
    /// The depths 0 and 1 in these coordinates.
    near_end: f32,
    far_end: f32,
    /// Squared distances of depths 0–1, 1–2, 2–3, 3–0.
    ring: Vec4,
    /// Squared distances of depths 0–2, 1–3, 2–0, 3–1.
    diagonals: Vec4,
    /// The companions of 0 are the roots of c₀ + c₁x + c₂x²: the first column of the Hankel matrix's adjugate.
    c0: f32,
    c1: f32,
    c2: f32,
    /// The Hankel determinant.
    determinant: f32,
}

/// 1/x of the two other depths of the extreme case, ascending; 0 stands for infinity, where no mass is.
#[derive(Clone, Copy)]
struct InverseNodes {
    near: f32,
    far: f32,
}

/// The sums of the lanes of four vectors, each from left to right.
#[inline]
fn sums(a: Vec4, b: Vec4, c: Vec4, d: Vec4) -> Vec4 {
    Vec4::new(a.x, b.x, c.x, d.x)
        + Vec4::new(a.y, b.y, c.y, d.y)
        + Vec4::new(a.z, b.z, c.z, d.z)
        + Vec4::new(a.w, b.w, c.w, d.w)
}

impl Atoms {
    /// Of the fifteen pairs, four depths' lie on the ring (four) and the diagonals (two, each twice with half its weight);
    /// eight join a depth and an end, and one the two ends. Of the twenty triples, four are depths alone, twelve join a
    /// pair of depths and an end, and four a depth and both ends.
    #[inline]
    fn new(x: Vec4, z: Vec4, d: f32, weights: Vec4, moment_bias: f32) -> Self {
        let h = 0.5 * moment_bias;
        let weights = weights * (1.0 - moment_bias);
        let (l, r) = (-d, 1.0 - d);
        let (from_near, from_far) = (z, Vec4::ONE - z);

        let difference = x - x.yzwx();
        let ring = difference * difference;
        let difference = x - x.zwxy();
        let diagonals = difference * difference;
        let ring_pairs = weights * weights.yzwx() * ring;
        let diagonal_pairs = 0.5 * weights * weights.zwxy() * diagonals;

        let (product, diagonal_product) = (x * x.yzwx(), x * x.zwxy());
        let (p, q) = (ring_pairs * product, diagonal_pairs * diagonal_product);
        let (near_squared, far_squared) = (from_near * from_near, from_far * from_far);
        let masses = h * weights;
        let near_pairs = masses * x * near_squared * l;
        let far_pairs = masses * x * far_squared * r;
        let c0 = p * product + q * diagonal_product + x * (near_pairs * l + far_pairs * r);
        let c1 = p * (x + x.yzwx())
            + q * (x + x.zwxy())
            + near_pairs * (x + Vec4::splat(l))
            + far_pairs * (x + Vec4::splat(r));
        let c2 = p + q + near_pairs + far_pairs;

        let near_ring = near_squared * near_squared.yzwx();
        let far_ring = far_squared * far_squared.yzwx();
        let near_diagonal = near_squared * near_squared.zwxy();
        let far_diagonal = far_squared * far_squared.zwxy();
        let with_one_end =
            ring_pairs * (near_ring + far_ring) + diagonal_pairs * (near_diagonal + far_diagonal);
        let with_both_ends = masses * near_squared * far_squared;
        let of_depths = ring_pairs * weights.zwxy() * ring.yzwx() * diagonals;
        let determinant = of_depths + h * (with_one_end + with_both_ends);

        let of_all = sums(c0, c1, c2, determinant);
        let ends = h * h * l * r;
        Self {
            x,
            from_near,
            from_far,
            weights,
            end_mass: h,
            near_end: l,
            far_end: r,
            ring,
            diagonals,
            c0: of_all.x + ends * l * r,
            c1: -(of_all.y + ends * (l + r)),
            c2: of_all.z + ends,
            determinant: of_all.w,
        }
    }

    /// The bound where at most one depth besides the receiver's has a mass: it is attained.
    #[inline]
    fn attained_bound(&self) -> f32 {
        float::saturate(lit_fraction(self.x, self.weights, 0.0) + self.end_mass)
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
        self.determinant / self.c0
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
        let (h, l, r) = (self.end_mass, self.near_end, self.far_end);
        let first = float::dot4(self.weights, self.x) + h * (l + r);
        let second = float::dot4(self.weights, self.x * self.x) + h * (l * l + r * r);
        if -u <= v {
            1.0 - u * u * (v * second - first) / (v - u)
        } else {
            self.mass_on_receiver() + v * v * (first - u * second) / (v - u)
        }
    }

    /// The bound where a node would leave the interval: the support is then {near end, inner, 0, far end} instead. 1 where
    /// none would.
    ///
    /// Of the two supports, the one that the interval bears is the one whose masses are all positive (Karlin & Studden
    /// 1966, ch. II). An end's mass is the other end's value in c₀ + c₁x + c₂x², over a common divisor: so this asks
    /// which ends lie between the nodes, without the rounding of the nodes.
    #[inline]
    fn interval_bound(&self) -> f32 {
        let (x, l, r) = (self.x, self.near_end, self.far_end);
        // Weighted by the distances to both ends, which the ends do not outlive: two nodes remain, 0 and inner.
        let q = self.weights * self.from_near * self.from_far;
        let first = float::dot4(q, x);
        let second = float::dot4(q, x * x);
        if second < SINGULAR {
            return self.attained_bound();
        }
        let (to_near, to_far) = (second - l * first, r * first - second);
        let on_near = self.end_mass + self.pairs(self.weights * x * self.from_far) / (l * to_near);
        let on_far = self.end_mass + self.pairs(self.weights * x * self.from_near) / (r * to_far);
        let is_inner_behind = first > 0.0;
        let is_inner_inside = if is_inner_behind { to_far > 0.0 } else { to_near < 0.0 };
        if is_inner_inside && on_near >= 0.0 && on_far >= 0.0 {
            if is_inner_behind { 1.0 - on_near } else { self.pairs(q) / (second * (-l * r)) + on_far }
        } else {
            1.0
        }
    }

    /// Σ `m`ᵢ`m`ⱼ(xᵢ − xⱼ)² over the six pairs of depths.
    #[inline]
    fn pairs(&self, m: Vec4) -> f32 {
        float::dot4(m, m.yzwx() * self.ring + 0.5 * m.zwxy() * self.diagonals)
    }
}
