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

@group(0) @binding(0) 
var<uniform> p: type_16;
@group(0) @binding(1) 
var<storage> triangles: type_12;
var<private> vertex_1: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);
var<private> instance_1: u32;
@group(0) @binding(2) 
var<storage> instances: type_22;

fn function_() {
    var phi_91_: vec3<f32>;
    var phi_92_: vec3<f32>;
    var phi_197_: f32;

    let _e14 = vertex_1;
    let _e15 = instance_1;
    let _e23 = (_e14 / 3u);
    if (_e23 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e27 = (_e14 % 3u);
    if (_e15 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    if (_e27 == 0u) {
        let _e33 = triangles.member[(0u + _e23)].v0_;
        phi_92_ = _e33;
    } else {
        if (_e27 == 1u) {
            let _e36 = triangles.member[(0u + _e23)].v1_;
            phi_91_ = _e36;
        } else {
            let _e38 = triangles.member[(0u + _e23)].v2_;
            phi_91_ = _e38;
        }
        let _e40 = phi_91_;
        phi_92_ = _e40;
    }
    let _e42 = phi_92_;
    let _e48 = instances.member[(0u + _e15)].object_to_world[0u];
    let _e59 = ((((_e48.x * _e42.x) + (_e48.y * _e42.y)) + (_e48.z * _e42.z)) + (_e48.w * 1f));
    let _e61 = instances.member[(0u + _e15)].object_to_world[1u];
    let _e72 = ((((_e61.x * _e42.x) + (_e61.y * _e42.y)) + (_e61.z * _e42.z)) + (_e61.w * 1f));
    let _e74 = instances.member[(0u + _e15)].object_to_world[2u];
    let _e85 = ((((_e74.x * _e42.x) + (_e74.y * _e42.y)) + (_e74.z * _e42.z)) + (_e74.w * 1f));
    let _e88 = p.member.projection.row_w;
    let _e99 = ((((_e88.x * _e59) + (_e88.y * _e72)) + (_e88.z * _e85)) + (_e88.w * 1f));
    let _e102 = p.member.projection.row_x;
    let _e116 = p.member.projection.row_y;
    let _e129 = p.member.near;
    if (_e129 > 0f) {
        let _e132 = p.member.near;
        phi_197_ = _e132;
    } else {
        let _e135 = p.member.projection.row_z;
        phi_197_ = (((((_e135.x * _e59) + (_e135.y * _e72)) + (_e135.z * _e85)) + (_e135.w * 1f)) * _e99);
    }
    let _e149 = phi_197_;
    position = vec4<f32>(((2f * ((((_e102.x * _e59) + (_e102.y * _e72)) + (_e102.z * _e85)) + (_e102.w * 1f))) - _e99), (_e99 - (2f * ((((_e116.x * _e59) + (_e116.y * _e72)) + (_e116.z * _e85)) + (_e116.w * 1f)))), _e149, _e99);
    return;
}

@vertex 
fn entry_depth_depth_instanced_vs(@builtin(vertex_index) vertex: u32, @builtin(instance_index) instance: u32) -> @builtin(position) vec4<f32> {
    vertex_1 = vertex;
    instance_1 = instance;
    function_();
    let _e5 = position;
    return _e5;
}
