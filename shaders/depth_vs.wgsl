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

@group(0) @binding(0) 
var<uniform> p: type_15;
@group(0) @binding(1) 
var<storage> triangles: type_11;
var<private> vertex_1: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);

fn function_() {
    var phi_69_: vec3<f32>;
    var phi_70_: vec3<f32>;
    var phi_135_: f32;

    let _e12 = vertex_1;
    let _e17 = (_e12 / 3u);
    if (_e17 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e21 = (_e12 % 3u);
    if (_e21 == 0u) {
        let _e24 = triangles.member[(0u + _e17)].v0_;
        phi_70_ = _e24;
    } else {
        if (_e21 == 1u) {
            let _e27 = triangles.member[(0u + _e17)].v1_;
            phi_69_ = _e27;
        } else {
            let _e29 = triangles.member[(0u + _e17)].v2_;
            phi_69_ = _e29;
        }
        let _e31 = phi_69_;
        phi_70_ = _e31;
    }
    let _e33 = phi_70_;
    let _e39 = p.member.projection.row_w;
    let _e50 = ((((_e39.x * _e33.x) + (_e39.y * _e33.y)) + (_e39.z * _e33.z)) + (_e39.w * 1f));
    let _e53 = p.member.projection.row_x;
    let _e67 = p.member.projection.row_y;
    let _e80 = p.member.near;
    if (_e80 > 0f) {
        let _e83 = p.member.near;
        phi_135_ = _e83;
    } else {
        let _e86 = p.member.projection.row_z;
        phi_135_ = (((((_e86.x * _e33.x) + (_e86.y * _e33.y)) + (_e86.z * _e33.z)) + (_e86.w * 1f)) * _e50);
    }
    let _e100 = phi_135_;
    position = vec4<f32>(((2f * ((((_e53.x * _e33.x) + (_e53.y * _e33.y)) + (_e53.z * _e33.z)) + (_e53.w * 1f))) - _e50), (_e50 - (2f * ((((_e67.x * _e33.x) + (_e67.y * _e33.y)) + (_e67.z * _e33.z)) + (_e67.w * 1f)))), _e100, _e50);
    return;
}

@vertex 
fn entry_depth_depth_vs(@builtin(vertex_index) vertex: u32) -> @builtin(position) vec4<f32> {
    vertex_1 = vertex;
    function_();
    let _e3 = position;
    return _e3;
}
