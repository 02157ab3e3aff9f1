//! Where the pixels of a batch were in the last frame: [`lt_mask::reproject`] and the temporal depth test, 64 at a time.

use lt_math::float;
use lt_math::glam::UVec2;
use lt_shaders::abi::{CameraParams, MaskParams};
use lt_shaders::sampling::sample_place;

use super::planes::place_in_block;
use super::samples::{Lanes, Points};
use super::tiles::{PIECE, Tiles};

/// Where the pixels of a batch were in the last frame.
pub struct Places {
    pub x: [u32; PIECE],
    pub y: [u32; PIECE],
    /// 1 where that is on the screen and the same surface, else 0; x and y are then on the screen all the same.
    pub is_valid: [u32; PIECE],
    pub has_moved: [u32; PIECE],
}

/// The pixels themselves: where they were if nothing moved.
#[inline(always)]
pub fn in_this_frame(tiles: Tiles, origin: UVec2, piece: usize) -> Places {
    let corner = place_in_block((piece * PIECE) as u32);
    let last = tiles.size() - 1;
    let mut places = Places { x: [0; PIECE], y: [0; PIECE], is_valid: [1; PIECE], has_moved: [0; PIECE] };
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
    pub fn follow(&mut self, position: &Points, before: &Points, p: &MaskParams) {
        let (then_x, then_y, depth) = place_px(before, &p.previous);
        let (width, height) = (p.current.size.x as f32, p.current.size.y as f32);
        let camera_rests = p.flags & MaskParams::CAMERA_RESTS != 0;
        for i in 0..PIECE {
            let is_same = |axis: usize| position[axis][i] == before[axis][i];
            let rests = camera_rests & is_same(0) & is_same(1) & is_same(2);
            let from = sample_place(UVec2::new(self.x[i], self.y[i]), p.current.grid);
            let (x, y) = (then_x[i] - from.x, then_y[i] - from.y);
            let (to_x, to_y) = (from.x + x, from.y + y);
            // The floor of these is on the screen exactly where they are.
            let is_on_screen = (to_x >= 0.0) & (to_y >= 0.0) & (to_x < width) & (to_y < height);
            let whole = |at: f32| float::whole_lane(float::floor_lane(at)) as u32;
            let is_led = is_on_screen & !rests;
            self.x[i] = if is_led { whole(to_x) } else { self.x[i] };
            self.y[i] = if is_led { whole(to_y) } else { self.y[i] };
            self.is_valid[i] = u32::from(rests | (is_on_screen & (depth[i] > 0.0)));
            self.has_moved[i] = u32::from(!rests & ((x != 0.0) | (y != 0.0)));
        }
    }

    /// Keeps valid what had about this depth in the last frame ([`lt_mask::is_depth_consistent`]).
    #[inline(always)]
    pub fn compare_depths(&mut self, tiles: Tiles, last: &[f32], expected: &Lanes, p: &MaskParams) {
        for (i, &expected) in expected.iter().enumerate() {
            let seen = last[tiles.index(UVec2::new(self.x[i], self.y[i]))];
            let is_same = lt_mask::is_depth_consistent(expected, seen, p.depth_tolerance);
            self.is_valid[i] &= u32::from(is_same);
        }
    }
}

/// [`lt_shaders::mask::place_px`] and [`lt_shaders::mask::view_depth`] of a batch.
#[inline(always)]
fn place_px(position: &Points, camera: &CameraParams) -> (Lanes, Lanes, Lanes) {
    let eye = camera.eye.to_array();
    let [right, up, forward] = [camera.right, camera.up, camera.forward].map(|v| v.to_array());
    let (width, height) = (camera.right.length_squared(), camera.up.length_squared());
    let (half_width, half_height) = (0.5 * camera.size.x as f32, 0.5 * camera.size.y as f32);
    let (mut x, mut y, mut depths) = ([0.0; PIECE], [0.0; PIECE], [0.0; PIECE]);
    for i in 0..PIECE {
        let to = [position[0][i] - eye[0], position[1][i] - eye[1], position[2][i] - eye[2]];
        let along = |v: [f32; 3]| to[0] * v[0] + to[1] * v[1] + to[2] * v[2];
        let depth = along(forward);
        x[i] = (along(right) / (width * depth) + 1.0) * half_width;
        y[i] = (1.0 - along(up) / (height * depth)) * half_height;
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
