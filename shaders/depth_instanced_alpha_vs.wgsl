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

struct type_11 {
    member: array<lt_bvh_Triangle>,
}

struct abi_DepthParams {
    projection: lt_math_LightProjection,
    map_size: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_15 {
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
var<uniform> p: type_15;
@group(0) @binding(1) 
var<storage> triangles: type_11;
var<private> vertex_1: u32;
var<private> triangle: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);
var<private> instance_1: u32;
@group(0) @binding(2) 
var<storage> instances: type_22;
var<private> placed: u32;

fn function_() {
    var phi_94_: vec3<f32>;
    var phi_95_: vec3<f32>;

    let _e15 = vertex_1;
    let _e16 = instance_1;
    triangle = (_e15 / 3u);
    placed = _e16;
    let _e25 = (_e15 / 3u);
    if (_e25 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e29 = (_e15 % 3u);
    if (_e16 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    if (_e29 == 0u) {
        let _e35 = triangles.member[(0u + _e25)].v0_;
        phi_95_ = _e35;
    } else {
        if (_e29 == 1u) {
            let _e38 = triangles.member[(0u + _e25)].v1_;
            phi_94_ = _e38;
        } else {
            let _e40 = triangles.member[(0u + _e25)].v2_;
            phi_94_ = _e40;
        }
        let _e42 = phi_94_;
        phi_95_ = _e42;
    }
    let _e44 = phi_95_;
    let _e50 = instances.member[(0u + _e16)].object_to_world[0u];
    let _e61 = ((((_e50.x * _e44.x) + (_e50.y * _e44.y)) + (_e50.z * _e44.z)) + (_e50.w * 1f));
    let _e63 = instances.member[(0u + _e16)].object_to_world[1u];
    let _e74 = ((((_e63.x * _e44.x) + (_e63.y * _e44.y)) + (_e63.z * _e44.z)) + (_e63.w * 1f));
    let _e76 = instances.member[(0u + _e16)].object_to_world[2u];
    let _e87 = ((((_e76.x * _e44.x) + (_e76.y * _e44.y)) + (_e76.z * _e44.z)) + (_e76.w * 1f));
    let _e90 = p.member.projection.row_w;
    let _e101 = ((((_e90.x * _e61) + (_e90.y * _e74)) + (_e90.z * _e87)) + (_e90.w * 1f));
    let _e103 = p.member.projection.row_x;
    let _e116 = p.member.projection.row_y;
    let _e133 = p.member.projection.row_z;
    position = vec4<f32>(((2f * ((((_e103.x * _e61) + (_e103.y * _e74)) + (_e103.z * _e87)) + (_e103.w * 1f))) - _e101), (_e101 - (2f * ((((_e116.x * _e61) + (_e116.y * _e74)) + (_e116.z * _e87)) + (_e116.w * 1f)))), (((((_e133.x * _e61) + (_e133.y * _e74)) + (_e133.z * _e87)) + (_e133.w * 1f)) * _e101), _e101);
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
