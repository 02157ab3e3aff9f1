struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_12 {
    member: array<lt_bvh_Triangle>,
}

struct abi_DepthParams {
    projection: lt_math_LightProjection,
    map_size: u32,
    near: f32,
    pad0_: u32,
    pad1_: u32,
}

struct type_16 {
    member: abi_DepthParams,
}

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_22 {
    member: array<lt_bvh_Instance>,
}

struct VertexOutput {
    @location(0) @interpolate(flat) member: u32,
    @location(1) @interpolate(flat) member_1: u32,
    @builtin(position) member_2: vec4<f32>,
}

@group(0) @binding(0) 
var<uniform> p: type_16;
@group(0) @binding(1) 
var<storage> triangles: type_12;
var<private> vertex_1: u32;
var<private> triangle: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);
var<private> instance_1: u32;
@group(0) @binding(2) 
var<storage> instances: type_22;
var<private> placed: u32;

fn function_() {
    var phi_95_: vec3<f32>;
    var phi_96_: vec3<f32>;
    var phi_201_: f32;

    let _e16 = vertex_1;
    let _e17 = instance_1;
    triangle = (_e16 / 3u);
    placed = _e17;
    let _e26 = (_e16 / 3u);
    if (_e26 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e30 = (_e16 % 3u);
    if (_e17 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    if (_e30 == 0u) {
        let _e36 = triangles.member[(0u + _e26)].v0_;
        phi_96_ = _e36;
    } else {
        if (_e30 == 1u) {
            let _e39 = triangles.member[(0u + _e26)].v1_;
            phi_95_ = _e39;
        } else {
            let _e41 = triangles.member[(0u + _e26)].v2_;
            phi_95_ = _e41;
        }
        let _e43 = phi_95_;
        phi_96_ = _e43;
    }
    let _e45 = phi_96_;
    let _e51 = instances.member[(0u + _e17)].object_to_world[0u];
    let _e62 = ((((_e51.x * _e45.x) + (_e51.y * _e45.y)) + (_e51.z * _e45.z)) + (_e51.w * 1f));
    let _e64 = instances.member[(0u + _e17)].object_to_world[1u];
    let _e75 = ((((_e64.x * _e45.x) + (_e64.y * _e45.y)) + (_e64.z * _e45.z)) + (_e64.w * 1f));
    let _e77 = instances.member[(0u + _e17)].object_to_world[2u];
    let _e88 = ((((_e77.x * _e45.x) + (_e77.y * _e45.y)) + (_e77.z * _e45.z)) + (_e77.w * 1f));
    let _e91 = p.member.projection.row_w;
    let _e102 = ((((_e91.x * _e62) + (_e91.y * _e75)) + (_e91.z * _e88)) + (_e91.w * 1f));
    let _e105 = p.member.projection.row_x;
    let _e119 = p.member.projection.row_y;
    let _e132 = p.member.near;
    if (_e132 > 0f) {
        let _e135 = p.member.near;
        phi_201_ = _e135;
    } else {
        let _e138 = p.member.projection.row_z;
        phi_201_ = (((((_e138.x * _e62) + (_e138.y * _e75)) + (_e138.z * _e88)) + (_e138.w * 1f)) * _e102);
    }
    let _e152 = phi_201_;
    position = vec4<f32>(((2f * ((((_e105.x * _e62) + (_e105.y * _e75)) + (_e105.z * _e88)) + (_e105.w * 1f))) - _e102), (_e102 - (2f * ((((_e119.x * _e62) + (_e119.y * _e75)) + (_e119.z * _e88)) + (_e119.w * 1f)))), _e152, _e102);
    return;
}

@vertex 
fn entry_depth_depth_instanced_alpha_vs(@builtin(vertex_index) vertex: u32, @builtin(instance_index) instance: u32) -> VertexOutput {
    vertex_1 = vertex;
    instance_1 = instance;
    function_();
    let _e7 = triangle;
    let _e8 = placed;
    let _e9 = position;
    return VertexOutput(_e7, _e8, _e9);
}
