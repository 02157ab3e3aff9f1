//! Depth map: vertices pulled from the tree's own triangles, and a fragment stage only where casters have holes or the map is
//! a perspective one, whose depths hardware cannot interpolate.

use lt_bvh::{Instance, Triangle};
use lt_math::glam::{Vec4, Vec4Swizzles};
use spirv_std::{arch::kill, spirv};

use crate::{
    abi::{DepthParams, Material, Vertex},
    depth::{blocks_at, clip_position, corner, depth_at, on_map, placed_corner, placed_on_map},
};

/// Casters in world space.
#[spirv(vertex)]
pub fn depth_vs(
    #[spirv(vertex_index)] vertex: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(position)] position: &mut Vec4,
) {
    *position = clip_position(p, corner(&triangles[(vertex / 3) as usize], vertex % 3));
}

/// Placed casters.
#[spirv(vertex)]
pub fn depth_instanced_vs(
    #[spirv(vertex_index)] vertex: u32,
    #[spirv(instance_index)] instance: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] instances: &[Instance],
    #[spirv(position)] position: &mut Vec4,
) {
    let world = placed_corner(&triangles[(vertex / 3) as usize], vertex % 3, &instances[instance as usize]);
    *position = clip_position(p, world);
}

/// Casters with holes, in world space.
#[spirv(vertex)]
pub fn depth_alpha_vs(
    #[spirv(vertex_index)] vertex: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(position)] position: &mut Vec4,
    #[spirv(location = 0, flat)] triangle: &mut u32,
) {
    *triangle = vertex / 3;
    *position = clip_position(p, corner(&triangles[(vertex / 3) as usize], vertex % 3));
}

/// Placed casters with holes.
#[spirv(vertex)]
pub fn depth_instanced_alpha_vs(
    #[spirv(vertex_index)] vertex: u32,
    #[spirv(instance_index)] instance: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] instances: &[Instance],
    #[spirv(position)] position: &mut Vec4,
    #[spirv(location = 0, flat)] triangle: &mut u32,
    #[spirv(location = 1, flat)] placed: &mut u32,
) {
    *triangle = vertex / 3;
    *placed = instance;
    let world = placed_corner(&triangles[(vertex / 3) as usize], vertex % 3, &instances[instance as usize]);
    *position = clip_position(p, world);
}

/// Cuts holes, in world space.
#[spirv(fragment)]
pub fn depth_alpha_fs(
    #[spirv(frag_coord)] at: Vec4,
    #[spirv(location = 0, flat)] triangle: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] vertices: &[Vertex],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] materials: &[Material],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] alpha_texels: &[u32],
) {
    let t = triangles[triangle as usize];
    if !blocks_at(at.xy(), &on_map(p, &t), &t, vertices, materials, alpha_texels) {
        kill();
    }
}

/// Cuts holes in placed casters.
#[spirv(fragment)]
pub fn depth_instanced_alpha_fs(
    #[spirv(frag_coord)] at: Vec4,
    #[spirv(location = 0, flat)] triangle: u32,
    #[spirv(location = 1, flat)] placed: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] instances: &[Instance],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] vertices: &[Vertex],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] materials: &[Material],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] alpha_texels: &[u32],
) {
    let t = triangles[triangle as usize];
    let corners = placed_on_map(p, &t, &instances[placed as usize]);
    if !blocks_at(at.xy(), &corners, &t, vertices, materials, alpha_texels) {
        kill();
    }
}

/// Depths on a perspective map.
#[spirv(fragment(depth_replacing))]
pub fn depth_perspective_fs(
    #[spirv(frag_coord)] at: Vec4,
    #[spirv(location = 0, flat)] triangle: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(frag_depth)] depth: &mut f32,
) {
    let t = triangles[triangle as usize];
    let corners = on_map(p, &t);
    *depth = depth_at(at.xy(), &corners);
}

/// Depths on a perspective map, holes cut.
#[spirv(fragment(depth_replacing))]
pub fn depth_perspective_alpha_fs(
    #[spirv(frag_coord)] at: Vec4,
    #[spirv(location = 0, flat)] triangle: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] vertices: &[Vertex],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] materials: &[Material],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] alpha_texels: &[u32],
    #[spirv(frag_depth)] depth: &mut f32,
) {
    let t = triangles[triangle as usize];
    let corners = on_map(p, &t);
    if !blocks_at(at.xy(), &corners, &t, vertices, materials, alpha_texels) {
        kill();
    }
    *depth = depth_at(at.xy(), &corners);
}

/// Depths of placed casters on a perspective map.
#[spirv(fragment(depth_replacing))]
pub fn depth_perspective_instanced_fs(
    #[spirv(frag_coord)] at: Vec4,
    #[spirv(location = 0, flat)] triangle: u32,
    #[spirv(location = 1, flat)] placed: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] instances: &[Instance],
    #[spirv(frag_depth)] depth: &mut f32,
) {
    let t = triangles[triangle as usize];
    let corners = placed_on_map(p, &t, &instances[placed as usize]);
    *depth = depth_at(at.xy(), &corners);
}

/// Depths of placed casters on a perspective map, holes cut.
#[spirv(fragment(depth_replacing))]
pub fn depth_perspective_instanced_alpha_fs(
    #[spirv(frag_coord)] at: Vec4,
    #[spirv(location = 0, flat)] triangle: u32,
    #[spirv(location = 1, flat)] placed: u32,
    #[spirv(uniform, descriptor_set = 0, binding = 0)] p: &DepthParams,
    #[spirv(storage_buffer, descriptor_set = 0, binding = 1)] triangles: &[Triangle],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 2)] instances: &[Instance],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 3)] vertices: &[Vertex],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 4)] materials: &[Material],
    #[spirv(storage_buffer, descriptor_set = 0, binding = 5)] alpha_texels: &[u32],
    #[spirv(frag_depth)] depth: &mut f32,
) {
    let t = triangles[triangle as usize];
    let corners = placed_on_map(p, &t, &instances[placed as usize]);
    if !blocks_at(at.xy(), &corners, &t, vertices, materials, alpha_texels) {
        kill();
    }
    *depth = depth_at(at.xy(), &corners);
}
