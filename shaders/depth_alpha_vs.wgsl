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

struct VertexOutput {
    @location(0) @interpolate(flat) member: u32,
    @builtin(position) member_1: vec4<f32>,
}

@group(0) @binding(0) 
var<uniform> p: type_14;
@group(0) @binding(1) 
var<storage> triangles: type_10;
var<private> vertex_1: u32;
var<private> triangle: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);

fn function_() {
    var phi_71_: vec3<f32>;
    var phi_72_: vec3<f32>;

    let _e12 = vertex_1;
    triangle = (_e12 / 3u);
    let _e18 = (_e12 / 3u);
    if (_e18 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e22 = (_e12 % 3u);
    if (_e22 == 0u) {
        let _e25 = triangles.member[(0u + _e18)].v0_;
        phi_72_ = _e25;
    } else {
        if (_e22 == 1u) {
            let _e28 = triangles.member[(0u + _e18)].v1_;
            phi_71_ = _e28;
        } else {
            let _e30 = triangles.member[(0u + _e18)].v2_;
            phi_71_ = _e30;
        }
        let _e32 = phi_71_;
        phi_72_ = _e32;
    }
    let _e34 = phi_72_;
    let _e40 = p.member.projection.row_w;
    let _e51 = ((((_e40.x * _e34.x) + (_e40.y * _e34.y)) + (_e40.z * _e34.z)) + (_e40.w * 1f));
    let _e53 = p.member.projection.row_x;
    let _e66 = p.member.projection.row_y;
    let _e83 = p.member.projection.row_z;
    position = vec4<f32>(((2f * ((((_e53.x * _e34.x) + (_e53.y * _e34.y)) + (_e53.z * _e34.z)) + (_e53.w * 1f))) - _e51), (_e51 - (2f * ((((_e66.x * _e34.x) + (_e66.y * _e34.y)) + (_e66.z * _e34.z)) + (_e66.w * 1f)))), (((((_e83.x * _e34.x) + (_e83.y * _e34.y)) + (_e83.z * _e34.z)) + (_e83.w * 1f)) * _e51), _e51);
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
