//! Triangles before the eye of a perspective map: what is nearer than its near plane or far beside it is cut off.

use lt_math::glam::{Vec2, Vec3, Vec4};

/// Texels beside the map that triangles may reach without being cut: far inside what the rasteriser's integers hold.
const GUARD_TEXELS: f32 = 65536.0;

/// What remains of a triangle, in texels.
pub enum Polygon {
    /// All of it.
    Whole([Vec2; 3]),
    /// A convex polygon; fewer than three corners if nothing remains.
    Cut(Vec<Vec2>),
}

/// Cuts a triangle of homogeneous corners (texels; z unused) at the plane w = `near` and at a guard band around the map.
pub fn cut(corners: &[Vec4; 3], near: f32, size: f32) -> Polygon {
    let corners = corners.map(|c| Vec3::new(c.x, c.y, c.w));
    let sides: [fn(Vec3, f32, f32) -> f32; 5] = [
        |p, near, _| p.z - near,
        |p, _, _| p.x + GUARD_TEXELS * p.z,
        |p, _, size| (GUARD_TEXELS + size) * p.z - p.x,
        |p, _, _| p.y + GUARD_TEXELS * p.z,
        |p, _, size| (GUARD_TEXELS + size) * p.z - p.y,
    ];
    let on_map = |p: Vec3| Vec2::new(p.x / p.z, p.y / p.z);
    if corners.iter().all(|&p| sides.iter().all(|side| side(p, near, size) >= 0.0)) {
        return Polygon::Whole(corners.map(on_map));
    }
    let mut polygon = corners.to_vec();
    for side in sides {
        let mut kept = Vec::with_capacity(polygon.len() + 1);
        for i in 0..polygon.len() {
            let (a, b) = (polygon[i], polygon[(i + 1) % polygon.len()]);
            let (sa, sb) = (side(a, near, size), side(b, near, size));
            if sa >= 0.0 {
                kept.push(a);
            }
            if (sa < 0.0) != (sb < 0.0) {
                // From inside to outside whichever way the edge runs, so that neighbours are cut at the same point.
                kept.push(if sa < 0.0 {
                    b + (a - b) * (sb / (sb - sa))
                } else {
                    a + (b - a) * (sa / (sa - sb))
                });
            }
        }
        polygon = kept;
    }
    Polygon::Cut(polygon.into_iter().map(on_map).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners_of(polygon: Polygon) -> Vec<Vec2> {
        match polygon {
            Polygon::Whole(at) => at.to_vec(),
            Polygon::Cut(at) => at,
        }
    }

    #[test]
    fn what_lies_before_the_eye_is_left_whole() {
        let corners =
            [[0.0, 0.0, 1.0], [8.0, 0.0, 2.0], [0.0, 12.0, 4.0]].map(|c| Vec4::new(c[0], c[1], 0.0, c[2]));
        let polygon = cut(&corners, 0.1, 64.0);
        assert!(matches!(polygon, Polygon::Whole(_)));
        assert_eq!(corners_of(polygon), [Vec2::ZERO, Vec2::new(4.0, 0.0), Vec2::new(0.0, 3.0)]);
    }

    #[test]
    fn what_lies_behind_is_cut_off_and_the_rest_stays_in_the_guard_band() {
        let corners =
            [[1.0, 1.0, -1.0], [8.0, 0.0, 2.0], [0.0, 12.0, 4.0]].map(|c| Vec4::new(c[0], c[1], 0.0, c[2]));
        let polygon = corners_of(cut(&corners, 1e-6, 64.0));
        assert!(polygon.len() >= 4, "{polygon:?}");
        // Rounding lets a corner slip a little.
        assert!(polygon.iter().all(|p| p.abs().max_element() <= 1.01 * GUARD_TEXELS), "{polygon:?}");
        assert!(corners_of(cut(&corners.map(|c| c * Vec4::new(1.0, 1.0, 1.0, -1.0)), 3.0, 64.0)).is_empty());
    }
}
