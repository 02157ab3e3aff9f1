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

struct type_10 {
    member: array<lt_bvh_Triangle>,
}

struct abi_DepthParams {
    projection: lt_math_LightProjection,
    map_size: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_14 {
    member: abi_DepthParams,
}

@group(0) @binding(0) 
var<uniform> p: type_14;
@group(0) @binding(1) 
var<storage> triangles: type_10;
var<private> vertex_1: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);

fn function_() {
    var phi_68_: vec3<f32>;
    var phi_69_: vec3<f32>;

    let _e11 = vertex_1;
    let _e16 = (_e11 / 3u);
    if (_e16 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e20 = (_e11 % 3u);
    if (_e20 == 0u) {
        let _e23 = triangles.member[(0u + _e16)].v0_;
        phi_69_ = _e23;
    } else {
        if (_e20 == 1u) {
            let _e26 = triangles.member[(0u + _e16)].v1_;
            phi_68_ = _e26;
        } else {
            let _e28 = triangles.member[(0u + _e16)].v2_;
            phi_68_ = _e28;
        }
        let _e30 = phi_68_;
        phi_69_ = _e30;
    }
    let _e32 = phi_69_;
    let _e38 = p.member.projection.row_w;
    let _e49 = ((((_e38.x * _e32.x) + (_e38.y * _e32.y)) + (_e38.z * _e32.z)) + (_e38.w * 1f));
    let _e51 = p.member.projection.row_x;
    let _e64 = p.member.projection.row_y;
    let _e81 = p.member.projection.row_z;
    position = vec4<f32>(((2f * ((((_e51.x * _e32.x) + (_e51.y * _e32.y)) + (_e51.z * _e32.z)) + (_e51.w * 1f))) - _e49), (_e49 - (2f * ((((_e64.x * _e32.x) + (_e64.y * _e32.y)) + (_e64.z * _e32.z)) + (_e64.w * 1f)))), (((((_e81.x * _e32.x) + (_e81.y * _e32.y)) + (_e81.z * _e32.z)) + (_e81.w * 1f)) * _e49), _e49);
    return;
}

@vertex 
fn entry_depth_depth_vs(@builtin(vertex_index) vertex: u32) -> @builtin(position) vec4<f32> {
    vertex_1 = vertex;
    function_();
    let _e3 = position;
    return _e3;
}
