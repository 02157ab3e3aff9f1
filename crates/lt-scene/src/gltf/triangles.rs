//! Turns index lists of every triangle mode into plain triangles (glTF 2.0 specification, 3.7.2.1).

use lt_math::glam::Vec3;

/// How indices form triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Mode {
    Triangles,
    Strip,
    Fan,
}

impl Mode {
    /// Triangles formed by this many indices.
    pub(super) fn triangle_count(self, indices: usize) -> usize {
        match self {
            Self::Triangles => indices / 3,
            Self::Strip | Self::Fan => indices.saturating_sub(2),
        }
    }

    /// Positions in the index list of the corners of triangle `i`.
    pub(super) fn corners(self, i: usize) -> [usize; 3] {
        match self {
            Self::Triangles => [3 * i, 3 * i + 1, 3 * i + 2],
            Self::Strip => [i, i + 1 + i % 2, i + 2 - i % 2],
            Self::Fan => [i + 1, i + 2, 0],
        }
    }
}

/// Whether a triangle of finite corners has no area. Exact but for cancellation: single precision products fit into
/// double precision, so that small triangles do not vanish by underflow.
pub(super) fn is_degenerate([a, b, c]: [Vec3; 3]) -> bool {
    let minus = |p: Vec3, q: Vec3| [0, 1, 2].map(|k| f64::from(p[k]) - f64::from(q[k]));
    let (u, v) = (minus(b, a), minus(c, a));
    (0..3).all(|k| {
        let (i, j) = ((k + 1) % 3, (k + 2) % 3);
        u[i] * v[j] == u[j] * v[i]
    })
}

/// Drops the triangles without area; returns how many.
pub(super) fn drop_degenerate(indices: &mut Vec<u32>, positions: &[Vec3]) -> usize {
    let before = indices.len();
    let corner = |&i: &u32| positions[i as usize];
    let kept = |t: &&[u32; 3]| !is_degenerate([corner(&t[0]), corner(&t[1]), corner(&t[2])]);
    let (all, _) = indices.as_chunks::<3>();
    let left: Vec<u32> = all.iter().filter(kept).flatten().copied().collect();
    *indices = left;
    (before - indices.len()) / 3
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strips_keep_their_winding_and_fans_turn_about_the_first_vertex() {
        assert_eq!(Mode::Strip.corners(0), [0, 1, 2]);
        assert_eq!(Mode::Strip.corners(1), [1, 3, 2]);
        assert_eq!(Mode::Fan.corners(1), [2, 3, 0]);
        assert_eq!(Mode::Triangles.triangle_count(8), 2);
        assert_eq!(Mode::Fan.triangle_count(1), 0);
    }

    #[test]
    fn tiny_triangles_have_area_and_needles_of_three_points_on_a_line_have_not() {
        let tiny = [Vec3::ZERO, Vec3::X * 1e-30, Vec3::Y * 1e-30];
        assert!(!is_degenerate(tiny));
        assert!(is_degenerate([Vec3::ZERO, Vec3::ONE, Vec3::ONE * 2.0]));
        assert!(is_degenerate([Vec3::X, Vec3::X, Vec3::Y]));
    }
}
