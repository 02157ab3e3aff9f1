//! Axis-aligned boxes of the builders.

use bytemuck::Zeroable;
use lt_math::glam::Vec3;

/// A box; `low > high` where empty.
#[derive(Clone, Copy, Debug, PartialEq, Zeroable)]
pub(crate) struct Bounds {
    pub low: Vec3,
    pub high: Vec3,
}

impl Bounds {
    pub const EMPTY: Bounds = Bounds { low: Vec3::INFINITY, high: Vec3::NEG_INFINITY };

    pub fn union(&self, other: &Bounds) -> Bounds {
        Bounds { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub fn centre(&self) -> Vec3 {
        (self.low + self.high) * 0.5
    }

    /// Length of the longest side.
    pub fn extent(&self) -> f64 {
        (self.high.as_dvec3() - self.low.as_dvec3()).max_element()
    }

    /// Half the surface area in units of `scale`², in f64 so that no scene scale overflows.
    pub fn half_area(&self) -> f64 {
        let d = (self.high - self.low).as_dvec3();
        d.x * d.y + d.y * d.z + d.z * d.x
    }
}
