//! Boxes of casters: how far they reach over the poses of a scene, and where they are drawn on a map.

use lt_math::LightProjection;
use lt_math::float::dot4;
use lt_math::glam::{Vec2, Vec4, Vec4Swizzles};
use lt_scene::Bounds;
use lt_shaders::marks::UNSTIRRED;

/// How much larger than its casters a box is made that they have left, so that their next step does not leave it again.
const REACH_GROWTH: f32 = 0.1;

/// A box that holds what `before` holds, and `now`; with some room around if that is more than before.
pub fn reach_of(before: Bounds, now: Bounds) -> Bounds {
    if now.is_empty() || encloses(before, now) {
        return before;
    }
    let all = before.including(now.min).including(now.max);
    let room = (all.max - all.min) * (REACH_GROWTH * 0.5);
    all.including(now.min - room).including(now.max + room)
}

/// The part of a map on which a box is drawn, as [`lt_shaders::marks::is_stirred`] takes it.
pub fn place_on(projection: &LightProjection, bounds: Bounds) -> Vec4 {
    if bounds.is_empty() {
        return UNSTIRRED;
    }
    let mut part = UNSTIRRED;
    for corner in bounds.corners() {
        let p = corner.extend(1.0);
        let [x, y, w] = [projection.row_x, projection.row_y, projection.row_w].map(|row| dot4(row, p));
        if w <= 0.0 {
            return Vec4::new(-1.0, -1.0, 2.0, 2.0);
        }
        let (low, high) = (part.xy().min(Vec2::new(x / w, y / w)), part.zw().max(Vec2::new(x / w, y / w)));
        part = low.extend(high.x).extend(high.y);
    }
    part
}

/// Whether one box lies in another, surfaces included.
pub fn encloses(outer: Bounds, inner: Bounds) -> bool {
    outer.contains(inner.min) && outer.contains(inner.max)
}
