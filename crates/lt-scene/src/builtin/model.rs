//! Mesh building: flat and curved primitives drawn in a local frame, sorted into one mesh per material.

use lt_math::glam::{Affine3A, Vec2, Vec3};

use super::numbers::{TAU, across, sin_cos};
use crate::{Material, Mesh};

/// Geometry under construction, one [`Part`] per material.
#[derive(Clone, Debug, Default)]
pub struct Model {
    /// Where the next primitives stand: local to model space.
    pub frame: Affine3A,
    parts: Vec<Part>,
}

/// The triangles of one material.
#[derive(Clone, Debug, Default)]
pub struct Part {
    frame: Affine3A,
    tint: [u8; 4],
    is_curved: bool,
    is_tinted: bool,
    mesh: Mesh,
}

impl Model {
    /// Nothing yet, drawn at the origin.
    pub fn new() -> Self {
        Self::default()
    }

    /// The part of this material, ready to draw in the current frame, untinted.
    pub fn on(&mut self, material: u32) -> &mut Part {
        let index = match self.parts.iter().position(|p| p.mesh.material == material) {
            Some(index) => index,
            None => {
                let mesh = Mesh { material, ..Mesh::default() };
                self.parts.push(Part { mesh, ..Part::default() });
                self.parts.len() - 1
            }
        };
        let part = &mut self.parts[index];
        part.frame = self.frame;
        part.tint = [255; 4];
        part
    }

    /// Draws with the frame moved by `local`, then moves it back.
    pub fn within(&mut self, local: Affine3A, draw: impl FnOnce(&mut Self)) {
        let outer = self.frame;
        self.frame = outer * local;
        draw(self);
        self.frame = outer;
    }

    /// The finished meshes: attributes that the material or shape does not need are left out.
    pub fn into_meshes(self, name: &str, materials: &[Material]) -> Vec<Mesh> {
        self.parts
            .into_iter()
            .filter(|part| !part.mesh.indices.is_empty())
            .map(|part| {
                let mut mesh = part.mesh;
                let material = &materials[mesh.material as usize];
                mesh.name = format!("{name}/{}", material.name);
                if !part.is_curved {
                    mesh.normals = Vec::new();
                }
                if !part.is_tinted {
                    mesh.colors = Vec::new();
                }
                if material.texture.is_none() {
                    mesh.uvs = Vec::new();
                }
                mesh
            })
            .collect()
    }
}

impl Part {
    /// Colours what follows: linear RGB in [0, 1], multiplied with the material.
    pub fn tint(&mut self, color: Vec3) -> &mut Self {
        let byte = |c: f32| (c.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
        self.tint = [byte(color.x), byte(color.y), byte(color.z), 255];
        self.is_tinted = true;
        self
    }

    /// Keeps vertex normals: for callers that lay vertices themselves.
    pub fn smooth(&mut self) -> &mut Self {
        self.is_curved = true;
        self
    }

    /// Adds a vertex with a unit normal, both local, and returns its index.
    pub fn vertex(&mut self, position: Vec3, normal: Vec3, uv: Vec2) -> u32 {
        let index = self.mesh.positions.len() as u32;
        self.mesh.positions.push(self.frame.transform_point3(position));
        self.mesh.normals.push(self.frame.transform_vector3(normal).normalize_or(Vec3::Y));
        self.mesh.uvs.push(uv);
        self.mesh.colors.push(self.tint);
        index
    }

    /// Joins three vertices, unless they lie on a line (the poles of a sphere, the tip of a cone).
    pub fn triangle(&mut self, a: u32, b: u32, c: u32) {
        let at = |i: u32| self.mesh.positions[i as usize];
        let area = (at(b) - at(a)).cross(at(c) - at(a)).length();
        if area > 1e-9 {
            self.mesh.indices.extend([a, b, c]);
        }
    }

    /// A flat triangle or convex polygon, counter-clockwise, with texture coordinates per corner.
    pub fn polygon(&mut self, corners: &[(Vec3, Vec2)]) {
        let [first, second, .., last] = corners else { return };
        let normal = (second.0 - first.0).cross(last.0 - first.0).normalize_or(Vec3::Y);
        let indices: Vec<u32> = corners.iter().map(|&(p, uv)| self.vertex(p, normal, uv)).collect();
        for pair in indices[1..].windows(2) {
            self.triangle(indices[0], pair[0], pair[1]);
        }
    }

    /// A flat polygon whose texture runs in metres, u along the first edge.
    pub fn face(&mut self, corners: &[Vec3]) {
        let [first, second, .., last] = corners else { return };
        let along = (*second - *first).normalize_or(Vec3::X);
        let normal = along.cross(*last - *first).normalize_or(Vec3::Y);
        let up = normal.cross(along);
        // Anchored at the frame's origin, so that neighbouring faces continue each other's pattern.
        let textured: Vec<_> = corners.iter().map(|&p| (p, Vec2::new(p.dot(along), -p.dot(up)))).collect();
        self.polygon(&textured);
    }

    /// A quadrilateral a b c d, counter-clockwise, textured once from corner a (bottom left) to c (top right).
    pub fn picture(&mut self, [a, b, c, d]: [Vec3; 4]) {
        self.polygon(&[(a, Vec2::new(0.0, 1.0)), (b, Vec2::ONE), (c, Vec2::new(1.0, 0.0)), (d, Vec2::ZERO)]);
    }

    /// An axis-aligned block between two corners.
    pub fn block(&mut self, low: Vec3, high: Vec3) -> &mut Self {
        let at =
            |x: usize, y: usize, z: usize| Vec3::new([low, high][x].x, [low, high][y].y, [low, high][z].z);
        self.face(&[at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1)]);
        self.face(&[at(1, 0, 0), at(0, 0, 0), at(0, 1, 0), at(1, 1, 0)]);
        self.face(&[at(1, 0, 1), at(1, 0, 0), at(1, 1, 0), at(1, 1, 1)]);
        self.face(&[at(0, 0, 0), at(0, 0, 1), at(0, 1, 1), at(0, 1, 0)]);
        self.face(&[at(0, 1, 1), at(1, 1, 1), at(1, 1, 0), at(0, 1, 0)]);
        self.face(&[at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)]);
        self
    }

    /// A straight bar of rectangular section from `a` to `b`, `width` across and `height` high, open at the ends.
    pub fn bar(&mut self, a: Vec3, b: Vec3, width: f32, height: f32) -> &mut Self {
        let axis = (b - a).normalize_or(Vec3::Z);
        let (u, v) = across(axis);
        let corner = |end: Vec3, i: usize| {
            let (su, sv) = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)][i % 4];
            end + u * (0.5 * width * su) + v * (0.5 * height * sv)
        };
        for i in 0..4 {
            self.face(&[corner(a, i), corner(a, i + 1), corner(b, i + 1), corner(b, i)]);
        }
        self
    }

    /// The solid under a convex profile (counter-clockwise in the xy plane seen from +Z) swept from `z0` to `z1 > z0`.
    pub fn extrusion(&mut self, profile: &[Vec2], z0: f32, z1: f32) -> &mut Self {
        let front: Vec<Vec3> = profile.iter().map(|p| p.extend(z1)).collect();
        let back: Vec<Vec3> = profile.iter().rev().map(|p| p.extend(z0)).collect();
        self.face(&front);
        self.face(&back);
        for i in 0..profile.len() {
            let (p, q) = (profile[i], profile[(i + 1) % profile.len()]);
            self.face(&[p.extend(z1), p.extend(z0), q.extend(z0), q.extend(z1)]);
        }
        self
    }

    /// A smooth tube through at least two points; `radius(t)` for t from 0 to 1, texture once around, metres along.
    pub fn tube(&mut self, path: &[Vec3], radius: impl Fn(f32) -> f32, sides: u32) -> &mut Self {
        let Some(last) = path.len().checked_sub(1).filter(|&n| n > 0) else { return self };
        self.is_curved = true;
        let tangent = |i: usize| (path[(i + 1).min(last)] - path[i.saturating_sub(1)]).normalize_or(Vec3::Y);
        let (mut u, _) = across(tangent(0));
        let mut along = 0.0;
        let mut previous: Vec<u32> = Vec::new();
        for (i, &center) in path.iter().enumerate() {
            let axis = tangent(i);
            // Carried along rather than recomputed, so that the tube does not twist.
            u = (u - axis * axis.dot(u)).normalize_or(across(axis).0);
            let v = axis.cross(u);
            let r = radius(i as f32 / last as f32);
            if i > 0 {
                along += center.distance(path[i - 1]);
            }
            let ring: Vec<u32> = (0..=sides)
                .map(|k| {
                    let share = (k % sides) as f32 / sides as f32;
                    let (s, c) = sin_cos(share * TAU);
                    let out = u * c + v * s;
                    self.vertex(center + out * r, out, Vec2::new(k as f32 / sides as f32, -along))
                })
                .collect();
            for k in 0..previous.len().saturating_sub(1) {
                self.triangle(previous[k], previous[k + 1], ring[k + 1]);
                self.triangle(previous[k], ring[k + 1], ring[k]);
            }
            previous = ring;
        }
        self
    }

    /// A cylinder or cone frustum from `a` to `b`, with flat caps.
    pub fn cylinder(&mut self, a: Vec3, b: Vec3, radius_a: f32, radius_b: f32, sides: u32) -> &mut Self {
        self.tube(&[a, b], |t| radius_a + (radius_b - radius_a) * t, sides);
        let axis = (b - a).normalize_or(Vec3::Y);
        let (u, v) = across(axis);
        for (center, radius, sign) in [(b, radius_b, 1.0), (a, radius_a, -1.0)] {
            if radius > 0.0 {
                let rim: Vec<Vec3> = (0..sides)
                    .map(|k| {
                        let (s, c) = sin_cos(k as f32 / sides as f32 * TAU * sign);
                        center + (u * c + v * s) * radius
                    })
                    .collect();
                self.face(&rim);
            }
        }
        self
    }

    /// A surface of revolution about the vertical through `base`: (radius, height) pairs from bottom to top.
    pub fn lathe(&mut self, base: Vec3, profile: &[Vec2], sides: u32) -> &mut Self {
        self.is_curved = true;
        let last = profile.len().saturating_sub(1);
        let mut previous: Vec<u32> = Vec::new();
        for (i, p) in profile.iter().enumerate() {
            let slope = profile[(i + 1).min(last)] - profile[i.saturating_sub(1)];
            let ring: Vec<u32> = (0..=sides)
                .map(|k| {
                    let (s, c) = sin_cos((k % sides) as f32 / sides as f32 * TAU);
                    let normal = Vec3::new(slope.y * c, -slope.x, slope.y * s).normalize_or(Vec3::Y);
                    let uv = Vec2::new(k as f32 / sides as f32, -p.y);
                    self.vertex(base + Vec3::new(p.x * c, p.y, p.x * s), normal, uv)
                })
                .collect();
            for k in 0..previous.len().saturating_sub(1) {
                self.triangle(previous[k], ring[k], ring[k + 1]);
                self.triangle(previous[k], ring[k + 1], previous[k + 1]);
            }
            previous = ring;
        }
        self
    }

    /// An ellipsoid of `rings` × `sides` facets.
    pub fn ellipsoid(&mut self, center: Vec3, radii: Vec3, rings: u32, sides: u32) -> &mut Self {
        self.grid(rings, sides, |row, column| {
            let (sin_polar, cos_polar) = sin_cos(row * TAU * 0.5);
            let (s, c) = sin_cos(column * TAU);
            let sphere = Vec3::new(sin_polar * c, -cos_polar, -sin_polar * s);
            (center + sphere * radii, (sphere / radii).normalize_or(Vec3::Y))
        })
    }

    /// A smooth patch: `shape(row, column)`, both from 0 to 1, gives position and unit normal; counter-clockwise
    /// when columns run right and rows run up. The texture fills it once.
    pub fn grid(&mut self, rows: u32, columns: u32, shape: impl Fn(f32, f32) -> (Vec3, Vec3)) -> &mut Self {
        self.is_curved = true;
        let first = self.mesh.positions.len() as u32;
        for row in 0..=rows {
            for column in 0..=columns {
                let (r, c) = (row as f32 / rows as f32, column as f32 / columns as f32);
                let (position, normal) = shape(r, c);
                self.vertex(position, normal, Vec2::new(c, 1.0 - r));
            }
        }
        let at = |row: u32, column: u32| first + row * (columns + 1) + column;
        for row in 0..rows {
            for column in 0..columns {
                self.triangle(at(row, column), at(row, column + 1), at(row + 1, column + 1));
                self.triangle(at(row, column), at(row + 1, column + 1), at(row + 1, column));
            }
        }
        self
    }

    /// A card with one normal of its own instead of its face normal: foliage shaded as a volume.
    pub fn card(&mut self, [a, b, c, d]: [Vec3; 4], normal: Vec3) -> &mut Self {
        self.is_curved = true;
        let uvs = [Vec2::new(0.0, 1.0), Vec2::ONE, Vec2::new(1.0, 0.0), Vec2::ZERO];
        let corners = [(a, uvs[0]), (b, uvs[1]), (c, uvs[2]), (d, uvs[3])];
        let [i, j, k, l] = corners.map(|(p, uv)| self.vertex(p, normal, uv));
        // Its front is the side the normal leans to: renderers reverse the normal when they see the back.
        let is_front = (b - a).cross(d - a).dot(normal) >= 0.0;
        let (j, l) = if is_front { (j, l) } else { (l, j) };
        self.triangle(i, j, k);
        self.triangle(i, k, l);
        self
    }
}

/// Points of a wire hung between `a` and `b`, `sag` metres below the chord at its middle (parabola for the catenary).
pub fn hanging(a: Vec3, b: Vec3, sag: f32, segments: u32) -> Vec<Vec3> {
    (0..=segments)
        .map(|i| {
            let t = i as f32 / segments as f32;
            a.lerp(b, t) - Vec3::Y * (4.0 * sag * t * (1.0 - t))
        })
        .collect()
}
