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
    near: f32,
    pad0_: u32,
    pad1_: u32,
}

struct type_15 {
    member: abi_DepthParams,
}

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_15;
@group(0) @binding(1) 
var<storage> triangles: type_10;
var<private> depth: f32 = 0f;

fn lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(param: f32, param_1: f32) -> f32 {
    var phi_356_: f32;

    if (param > param_1) {
        phi_356_ = param;
    } else {
        phi_356_ = param_1;
    }
    let _e16 = phi_356_;
    return _e16;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(param_2: f32, param_3: f32) -> f32 {
    var phi_348_: f32;

    if (param_2 < param_3) {
        phi_348_ = param_2;
    } else {
        phi_348_ = param_3;
    }
    let _e16 = phi_348_;
    return _e16;
}

fn function_() {
    var phi_72_: vec3<f32>;
    var phi_73_: vec3<f32>;
    var phi_146_: vec3<f32>;
    var phi_147_: vec3<f32>;
    var phi_220_: vec3<f32>;
    var phi_221_: vec3<f32>;
    var phi_316_: vec3<f32>;
    var phi_339_: f32;
    var phi_340_: f32;

    let _e12 = at_1;
    let _e13 = triangle_1;
    if (_e13 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e21 = triangles.member[(0u + _e13)];
    if (0u == 0u) {
        phi_73_ = _e21.v0_;
    } else {
        if (0u == 1u) {
            phi_72_ = _e21.v1_;
        } else {
            phi_72_ = _e21.v2_;
        }
        let _e28 = phi_72_;
        phi_73_ = _e28;
    }
    let _e30 = phi_73_;
    let _e32 = p.member.map_size;
    let _e37 = f32(_e32);
    let _e39 = p.member.projection.row_x;
    let _e53 = p.member.projection.row_y;
    let _e67 = p.member.projection.row_z;
    let _e78 = ((((_e67.x * _e30.x) + (_e67.y * _e30.y)) + (_e67.z * _e30.z)) + (_e67.w * 1f));
    let _e80 = p.member.projection.row_w;
    let _e91 = ((((_e80.x * _e30.x) + (_e80.y * _e30.y)) + (_e80.z * _e30.z)) + (_e80.w * 1f));
    if (1u == 0u) {
        phi_147_ = _e21.v0_;
    } else {
        if (1u == 1u) {
            phi_146_ = _e21.v1_;
        } else {
            phi_146_ = _e21.v2_;
        }
        let _e98 = phi_146_;
        phi_147_ = _e98;
    }
    let _e100 = phi_147_;
    let _e102 = p.member.map_size;
    let _e107 = f32(_e102);
    let _e109 = p.member.projection.row_x;
    let _e123 = p.member.projection.row_y;
    let _e137 = p.member.projection.row_z;
    let _e148 = ((((_e137.x * _e100.x) + (_e137.y * _e100.y)) + (_e137.z * _e100.z)) + (_e137.w * 1f));
    let _e150 = p.member.projection.row_w;
    let _e161 = ((((_e150.x * _e100.x) + (_e150.y * _e100.y)) + (_e150.z * _e100.z)) + (_e150.w * 1f));
    if (2u == 0u) {
        phi_221_ = _e21.v0_;
    } else {
        if (2u == 1u) {
            phi_220_ = _e21.v1_;
        } else {
            phi_220_ = _e21.v2_;
        }
        let _e168 = phi_220_;
        phi_221_ = _e168;
    }
    let _e170 = phi_221_;
    let _e172 = p.member.map_size;
    let _e177 = f32(_e172);
    let _e179 = p.member.projection.row_x;
    let _e193 = p.member.projection.row_y;
    let _e207 = p.member.projection.row_z;
    let _e218 = ((((_e207.x * _e170.x) + (_e207.y * _e170.y)) + (_e207.z * _e170.z)) + (_e207.w * 1f));
    let _e220 = p.member.projection.row_w;
    let _e231 = ((((_e220.x * _e170.x) + (_e220.y * _e170.y)) + (_e220.z * _e170.z)) + (_e220.w * 1f));
    let _e236 = ((((((_e39.x * _e30.x) + (_e39.y * _e30.y)) + (_e39.z * _e30.z)) + (_e39.w * 1f)) * _e37) - (_e12.x * _e91));
    let _e237 = ((((((_e53.x * _e30.x) + (_e53.y * _e30.y)) + (_e53.z * _e30.z)) + (_e53.w * 1f)) * _e37) - (_e12.y * _e91));
    let _e240 = ((((((_e109.x * _e100.x) + (_e109.y * _e100.y)) + (_e109.z * _e100.z)) + (_e109.w * 1f)) * _e107) - (_e12.x * _e161));
    let _e241 = ((((((_e123.x * _e100.x) + (_e123.y * _e100.y)) + (_e123.z * _e100.z)) + (_e123.w * 1f)) * _e107) - (_e12.y * _e161));
    let _e244 = ((((((_e179.x * _e170.x) + (_e179.y * _e170.y)) + (_e179.z * _e170.z)) + (_e179.w * 1f)) * _e177) - (_e12.x * _e231));
    let _e245 = ((((((_e193.x * _e170.x) + (_e193.y * _e170.y)) + (_e193.z * _e170.z)) + (_e193.w * 1f)) * _e177) - (_e12.y * _e231));
    let _e248 = ((_e244 * _e241) - (_e245 * _e240));
    let _e251 = ((_e236 * _e245) - (_e237 * _e244));
    let _e254 = ((_e240 * _e237) - (_e241 * _e236));
    let _e256 = ((_e248 + _e251) + _e254);
    if (_e256 == 0f) {
        phi_316_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_316_ = vec3<f32>((_e248 / _e256), (_e251 / _e256), (_e254 / _e256));
    }
    let _e263 = phi_316_;
    let _e271 = (((_e263.x * _e78) + (_e263.y * _e148)) + (_e263.z * _e218));
    let _e272 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e78, _e148);
    let _e273 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e272, _e218);
    let _e274 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e273, 0f);
    let _e275 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e78, _e148);
    let _e276 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e275, _e218);
    let _e277 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e276, 1f);
    if (_e271 > _e274) {
        if (_e271 < _e277) {
            phi_339_ = _e271;
        } else {
            phi_339_ = _e277;
        }
        let _e281 = phi_339_;
        phi_340_ = _e281;
    } else {
        phi_340_ = _e274;
    }
    let _e283 = phi_340_;
    depth = _e283;
    return;
}

@fragment 
fn entry_depth_depth_perspective_fs(@builtin(position) at: vec4<f32>, @location(0) @interpolate(flat) triangle: u32) -> @builtin(frag_depth) f32 {
    at_1 = at;
    triangle_1 = triangle;
    function_();
    let _e5 = depth;
    return _e5;
}
