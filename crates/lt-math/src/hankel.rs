//! The 3×3 Hankel system of four moments, by one LDLᵀ (Cholesky without roots) factorisation for every moment bound.

use crate::float;
use glam::{Vec2, Vec3, Vec4};

/// LDLᵀ factors of the matrix B with Bᵢⱼ = `E[z^{i+j}]`, i, j = 0…2, built from moments `E[z]` … `E[z⁴]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HankelFactors {
    moments: Vec4,
    /// Second pivot: the variance of z. Positive for a solvable problem, as is the third.
    d22: f32,
    /// L₃₂ · d22
    l32_d22: f32,
    /// Third pivot · d22
    d33_d22: f32,
}

impl HankelFactors {
    /// Factorises the matrix of `moments` = (`E[z]`, `E[z²]`, `E[z³]`, `E[z⁴]`).
    #[inline]
    pub fn new(moments: Vec4) -> Self {
        let b = moments;
        let d22 = b.y - b.x * b.x;
        let l32_d22 = b.z - b.x * b.y;
        let square_variance = b.w - b.y * b.y;
        let d33_d22 = square_variance * d22 - l32_d22 * l32_d22;
        Self { moments, d22, l32_d22, d33_d22 }
    }

    /// The moments that were factorised.
    #[inline]
    pub fn moments(&self) -> Vec4 {
        self.moments
    }

    /// Whether all mass lies on the depths 0 and 1, most of it on 1 (the clear value): the matrix is then singular.
    ///
    /// The first moment equals the fourth then, exactly even in f32 and after biasing, and is the lit fraction for every
    /// depth in (0, 1\].
    /// Mass on the near plane is left unsolved: a receiver there would be a shadow claimed over one rounding.
    #[inline]
    pub fn is_mostly_background(&self) -> bool {
        self.moments.x == self.moments.w && self.moments.x > 0.5
    }

    /// Solves B c = (1, z, z²)ᵀ up to a positive factor; NaN or infinite where a pivot is 0.
    #[inline]
    pub fn solve(&self, z: f32) -> Vec3 {
        let b = self.moments;
        let l32 = self.l32_d22 / self.d22;
        // Forward substitution through L, then division by D, then back through Lᵀ.
        let y1 = z - b.x;
        let y2 = z * z - b.y - l32 * y1;
        let c2 = y2 * self.d22 / self.d33_d22;
        let c1 = y1 / self.d22 - l32 * c2;
        let c0 = 1.0 - c1 * b.x - c2 * b.y;
        Vec3::new(c0, c1, c2)
    }

    /// The two other depths that, with `z`, carry every distribution's extreme case: roots of c₀ + c₁x + c₂x², ascending.
    ///
    /// Both are NaN where rounding has left no real root.
    #[inline]
    pub fn companions(&self, z: f32) -> Vec2 {
        let c = self.solve(z);
        let half_p = 0.5 * c.y / c.z;
        let q = c.x / c.z;
        let discriminant = half_p * half_p - q;
        // A GPU's root of a negative number is anything; and NaN fails this comparison too.
        if discriminant >= 0.0 {
            let root = float::sqrt(discriminant);
            Vec2::new(-half_p - root, -half_p + root)
        } else {
            Vec2::splat(float::nan_from(discriminant))
        }
    }
}

/// The mass that the canonical distribution on the support {`at`, `u`, `v`} with the given moments puts on `at`:
/// `E[(x−u)(x−v)]` / ((at−u)(at−v)).
#[inline]
pub fn mass_at(moments: Vec4, at: f32, u: f32, v: f32) -> f32 {
    (moments.y - moments.x * (u + v) + u * v) / ((at - u) * (at - v))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Moments of two equal masses and one of half the weight.
    const THREE: [(f32, f32); 3] = [(0.1, 0.4), (0.5, 0.4), (0.9, 0.2)];

    fn moments() -> Vec4 {
        THREE.iter().map(|&(z, m)| m * Vec4::new(z, z * z, z * z * z, z * z * z * z)).sum()
    }

    #[test]
    fn solve_satisfies_the_system() {
        let b = moments();
        let z = 0.3;
        let c = HankelFactors::new(b).solve(z);
        let rows = [Vec3::new(1.0, b.x, b.y), Vec3::new(b.x, b.y, b.z), Vec3::new(b.y, b.z, b.w)];
        for (row, expected) in rows.into_iter().zip([1.0, z, z * z]) {
            assert!((row.dot(c) - expected).abs() < 1e-3, "{row} {c}");
        }
    }

    #[test]
    fn companions_of_one_depth_of_three_are_the_other_two() {
        let factors = HankelFactors::new(moments());
        for (z, others) in [(0.1, [0.5, 0.9]), (0.5, [0.1, 0.9]), (0.9, [0.1, 0.5])] {
            let found = factors.companions(z);
            assert!((found - Vec2::from_array(others)).abs().max_element() < 1e-3, "{z} {found}");
        }
    }

    #[test]
    fn masses_are_recovered() {
        for (i, (z, mass)) in THREE.into_iter().enumerate() {
            let (u, v) = (THREE[(i + 1) % 3].0, THREE[(i + 2) % 3].0);
            assert!((mass_at(moments(), z, u, v) - mass).abs() < 1e-5);
        }
    }

    #[test]
    fn impossible_moments_have_no_companions() {
        // A variance below zero.
        let c = HankelFactors::new(Vec4::new(0.5, 0.2, 0.1, 0.05)).companions(0.5);
        assert!(c.is_nan() || c.x <= c.y);
        assert!(HankelFactors::new(Vec4::NAN).companions(0.5).x.is_nan());
        assert!(HankelFactors::new(Vec4::splat(0.0)).companions(0.5).x.is_nan());
    }
}
