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
    near: f32,
    pad0_: u32,
    pad1_: u32,
}

struct type_15 {
    member: abi_DepthParams,
}

struct VertexOutput {
    @location(0) @interpolate(flat) member: u32,
    @builtin(position) member_1: vec4<f32>,
}

@group(0) @binding(0) 
var<uniform> p: type_15;
@group(0) @binding(1) 
var<storage> triangles: type_11;
var<private> vertex_1: u32;
var<private> triangle: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);

fn function_() {
    var phi_72_: vec3<f32>;
    var phi_73_: vec3<f32>;
    var phi_138_: f32;

    let _e13 = vertex_1;
    triangle = (_e13 / 3u);
    let _e19 = (_e13 / 3u);
    if (_e19 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e23 = (_e13 % 3u);
    if (_e23 == 0u) {
        let _e26 = triangles.member[(0u + _e19)].v0_;
        phi_73_ = _e26;
    } else {
        if (_e23 == 1u) {
            let _e29 = triangles.member[(0u + _e19)].v1_;
            phi_72_ = _e29;
        } else {
            let _e31 = triangles.member[(0u + _e19)].v2_;
            phi_72_ = _e31;
        }
        let _e33 = phi_72_;
        phi_73_ = _e33;
    }
    let _e35 = phi_73_;
    let _e41 = p.member.projection.row_w;
    let _e52 = ((((_e41.x * _e35.x) + (_e41.y * _e35.y)) + (_e41.z * _e35.z)) + (_e41.w * 1f));
    let _e55 = p.member.projection.row_x;
    let _e69 = p.member.projection.row_y;
    let _e82 = p.member.near;
    if (_e82 > 0f) {
        let _e85 = p.member.near;
        phi_138_ = _e85;
    } else {
        let _e88 = p.member.projection.row_z;
        phi_138_ = (((((_e88.x * _e35.x) + (_e88.y * _e35.y)) + (_e88.z * _e35.z)) + (_e88.w * 1f)) * _e52);
    }
    let _e102 = phi_138_;
    position = vec4<f32>(((2f * ((((_e55.x * _e35.x) + (_e55.y * _e35.y)) + (_e55.z * _e35.z)) + (_e55.w * 1f))) - _e52), (_e52 - (2f * ((((_e69.x * _e35.x) + (_e69.y * _e35.y)) + (_e69.z * _e35.z)) + (_e69.w * 1f)))), _e102, _e52);
    return;
}

@vertex 
fn entry_depth_depth_alpha_vs(@builtin(vertex_index) vertex: u32) -> VertexOutput {
    vertex_1 = vertex;
    function_();
    let _e4 = triangle;
    let _e5 = position;
    return VertexOutput(_e4, _e5);
}
