//! Where the pixels of a batch were in the last frame: [`lt_mask::reproject`] and the temporal depth test, 64 at a time.

use lt_bvh::lanes;
use lt_math::float;
use lt_math::glam::{UVec2, Vec3};
use lt_shaders::abi::{CameraParams, MaskParams};
use lt_shaders::sampling::sample_place;

use super::bits::{at_least, less, more, pack, same};
use super::planes::place_in_block;
use super::samples::{Lanes, Points};
use super::tiles::{PIECE, Tiles};

/// Where the pixels of a batch were in the last frame.
pub struct Places {
    pub x: [u32; PIECE],
    pub y: [u32; PIECE],
    /// Where that is on the screen and the same surface; x and y are on the screen all the same elsewhere.
    pub valid: u64,
    pub moved: u64,
}

/// The pixels themselves: where they were if nothing moved.
#[inline(always)]
pub fn in_this_frame(tiles: Tiles, origin: UVec2, piece: usize) -> Places {
    let corner = place_in_block((piece * PIECE) as u32);
    let last = tiles.size() - 1;
    let mut places = Places { x: [0; PIECE], y: [0; PIECE], valid: !0, moved: 0 };
    let [columns, rows] = &IN_PIECE;
    for i in 0..PIECE {
        // Padding has nothing to say, but must not read outside.
        places.x[i] = (origin.x + corner.0 + columns[i]).min(last.x);
        places.y[i] = (origin.y + corner.1 + rows[i]).min(last.y);
    }
    places
}

/// Column and row in a piece, by position.
pub const IN_PIECE: [[u32; PIECE]; 2] = {
    let mut at = [[0; PIECE]; 2];
    let mut i = 0;
    while i < PIECE {
        let mut bit = 0;
        while bit < 3 {
            at[0][i] |= ((i >> (2 * bit) & 1) << bit) as u32;
            at[1][i] |= ((i >> (2 * bit + 1) & 1) << bit) as u32;
            bit += 1;
        }
        i += 1;
    }
    at
};

impl Places {
    /// [`lt_mask::reproject`] to [`lt_shaders::mask::place_px`], and not behind the last camera.
    #[inline(always)]
    pub fn follow<L: lanes::Lanes>(&mut self, lanes: L, position: &Points, before: &Points, p: &MaskParams) {
        let (then_x, then_y, depth) = place_px(before, &p.previous);
        let (mut way_x, mut way_y, mut to_x, mut to_y) =
            ([0.0; PIECE], [0.0; PIECE], [0.0; PIECE], [0.0; PIECE]);
        for i in 0..PIECE {
            let from = sample_place(UVec2::new(self.x[i], self.y[i]), p.current.grid);
            (way_x[i], way_y[i]) = (then_x[i] - from.x, then_y[i] - from.y);
            (to_x[i], to_y[i]) = (from.x + way_x[i], from.y + way_y[i]);
        }
        let resting = if p.flags & MaskParams::CAMERA_RESTS != 0 {
            same(lanes, &position[0], &before[0])
                & same(lanes, &position[1], &before[1])
                & same(lanes, &position[2], &before[2])
        } else {
            0
        };
        // The floor of these is on the screen exactly where they are.
        let (width, height) = (p.current.size.x as f32, p.current.size.y as f32);
        let on_screen = at_least(lanes, &to_x, 0.0)
            & at_least(lanes, &to_y, 0.0)
            & less(lanes, &to_x, width)
            & less(lanes, &to_y, height);
        let led = on_screen & !resting;
        let floored = |to: &Lanes| to.map(|at| float::whole_lane(float::floor_lane(at)) as u32);
        if led == !0 {
            (self.x, self.y) = (floored(&to_x), floored(&to_y));
        } else {
            let (x, y) = (floored(&to_x), floored(&to_y));
            for i in 0..PIECE {
                let is_led = led >> i & 1 != 0;
                self.x[i] = if is_led { x[i] } else { self.x[i] };
                self.y[i] = if is_led { y[i] } else { self.y[i] };
            }
        }
        self.valid = resting | on_screen & more(lanes, &depth, 0.0);
        let zero = &[0.0; PIECE];
        self.moved = !resting & !(same(lanes, &way_x, zero) & same(lanes, &way_y, zero));
    }

    /// Keeps valid what had about this depth in the last frame ([`lt_mask::is_depth_consistent`]).
    #[inline(always)]
    pub fn compare_depths(&mut self, tiles: Tiles, last: &[f32], expected: &Lanes, p: &MaskParams) {
        let mut is_consistent = [0; PIECE];
        for (i, &expected) in expected.iter().enumerate() {
            let seen = last[tiles.index(UVec2::new(self.x[i], self.y[i]))];
            let is_same = lt_mask::is_depth_consistent(expected, seen, p.depth_tolerance);
            is_consistent[i] = u8::from(is_same);
        }
        self.valid &= pack(&is_consistent);
    }
}

/// [`lt_shaders::mask::place_px`] and [`lt_shaders::mask::view_depth`] of a batch.
#[inline(always)]
fn place_px(position: &Points, camera: &CameraParams) -> (Lanes, Lanes, Lanes) {
    let eye = camera.eye.to_array();
    let per = |v: Vec3| v * (1.0 / v.length_squared());
    let [right, up, forward] = [per(camera.right), per(camera.up), camera.forward].map(|v| v.to_array());
    let (half_width, half_height) = (0.5 * camera.size.x as f32, 0.5 * camera.size.y as f32);
    let (mut x, mut y, mut depths) = ([0.0; PIECE], [0.0; PIECE], [0.0; PIECE]);
    for i in 0..PIECE {
        let to = [position[0][i] - eye[0], position[1][i] - eye[1], position[2][i] - eye[2]];
        let along = |v: [f32; 3]| to[0] * v[0] + to[1] * v[1] + to[2] * v[2];
        let depth = along(forward);
        let nearness = 1.0 / depth;
        x[i] = (along(right) * nearness + 1.0) * half_width;
        y[i] = (1.0 - along(up) * nearness) * half_height;
        depths[i] = depth;
    }
    (x, y, depths)
}

/// [`lt_shaders::mask::view_depth`] of a batch.
#[inline(always)]
pub fn depth_along(position: &Points, camera: &CameraParams) -> Lanes {
    let (eye, forward) = (camera.eye.to_array(), camera.forward.to_array());
    let mut depths = [0.0; PIECE];
    for i in 0..PIECE {
        let to = [position[0][i] - eye[0], position[1][i] - eye[1], position[2][i] - eye[2]];
        depths[i] = to[0] * forward[0] + to[1] * forward[1] + to[2] * forward[2];
    }
    depths
}
