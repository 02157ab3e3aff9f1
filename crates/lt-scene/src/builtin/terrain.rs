//! Heightfields: a smooth square grid over a height function, normals by central differences.

use lt_math::glam::{Vec2, Vec3, Vec3Swizzles};

use super::model::Part;

/// Draws the field over [−`half`, `half`]² in x and z with `cells` squares a side; `tint` colours each vertex and
/// `texture_scale` is texture repeats per metre, counted from the corner of least x and z.
pub fn heightfield(
    part: &mut Part,
    half: f32,
    cells: u32,
    texture_scale: f32,
    height: impl Fn(Vec2) -> f32,
    tint: impl Fn(Vec2) -> Vec3,
) {
    part.smooth();
    let pitch = 2.0 * half / cells as f32;
    let vertices: Vec<u32> = (0..=cells)
        .flat_map(|row| (0..=cells).map(move |column| (row, column)))
        .map(|(row, column)| {
            let p = Vec2::new(column as f32 * pitch - half, row as f32 * pitch - half);
            part.tint(tint(p));
            part.vertex(
                p.extend(height(p)).xzy(),
                normal(p, &height),
                (p + Vec2::splat(half)) * texture_scale,
            )
        })
        .collect();
    let at = |row: u32, column: u32| vertices[(row * (cells + 1) + column) as usize];
    for row in 0..cells {
        for column in 0..cells {
            part.triangle(at(row, column), at(row + 1, column), at(row + 1, column + 1));
            part.triangle(at(row, column), at(row + 1, column + 1), at(row, column + 1));
        }
    }
}

fn normal(p: Vec2, height: &impl Fn(Vec2) -> f32) -> Vec3 {
    let step = 0.5;
    let dx = height(p + Vec2::X * step) - height(p - Vec2::X * step);
    let dz = height(p + Vec2::Y * step) - height(p - Vec2::Y * step);
    Vec3::new(-dx, 2.0 * step, -dz).normalize()
}
