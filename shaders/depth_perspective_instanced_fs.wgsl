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

struct type_21 {
    member: array<lt_bvh_Instance>,
}

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_15;
@group(0) @binding(1) 
var<storage> triangles: type_10;
@group(0) @binding(2) 
var<storage> instances: type_21;
var<private> depth: f32 = 0f;
var<private> placed_1: u32;

fn lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(param: f32, param_1: f32) -> f32 {
    var phi_67_: f32;

    if (param < param_1) {
        phi_67_ = param;
    } else {
        phi_67_ = param_1;
    }
    let _e18 = phi_67_;
    return _e18;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(param_2: f32, param_3: f32) -> f32 {
    var phi_75_: f32;

    if (param_2 > param_3) {
        phi_75_ = param_2;
    } else {
        phi_75_ = param_3;
    }
    let _e18 = phi_75_;
    return _e18;
}

fn function_() {
    var phi_110_: vec3<f32>;
    var phi_111_: vec3<f32>;
    var phi_220_: vec3<f32>;
    var phi_221_: vec3<f32>;
    var phi_330_: vec3<f32>;
    var phi_331_: vec3<f32>;
    var phi_462_: vec3<f32>;
    var phi_485_: f32;
    var phi_486_: f32;

    let _e14 = at_1;
    let _e15 = triangle_1;
    let _e16 = placed_1;
    if (_e15 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e27 = triangles.member[(0u + _e15)];
    if (_e16 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    let _e31 = instances.member[(0u + _e16)];
    if (0u == 0u) {
        phi_111_ = _e27.v0_;
    } else {
        if (0u == 1u) {
            phi_110_ = _e27.v1_;
        } else {
            phi_110_ = _e27.v2_;
        }
        let _e38 = phi_110_;
        phi_111_ = _e38;
    }
    let _e40 = phi_111_;
    let _e56 = ((((_e31.object_to_world[0].x * _e40.x) + (_e31.object_to_world[0].y * _e40.y)) + (_e31.object_to_world[0].z * _e40.z)) + (_e31.object_to_world[0].w * 1f));
    let _e69 = ((((_e31.object_to_world[1].x * _e40.x) + (_e31.object_to_world[1].y * _e40.y)) + (_e31.object_to_world[1].z * _e40.z)) + (_e31.object_to_world[1].w * 1f));
    let _e82 = ((((_e31.object_to_world[2].x * _e40.x) + (_e31.object_to_world[2].y * _e40.y)) + (_e31.object_to_world[2].z * _e40.z)) + (_e31.object_to_world[2].w * 1f));
    let _e84 = p.member.map_size;
    let _e86 = f32(_e84);
    let _e88 = p.member.projection.row_x;
    let _e102 = p.member.projection.row_y;
    let _e116 = p.member.projection.row_z;
    let _e127 = ((((_e116.x * _e56) + (_e116.y * _e69)) + (_e116.z * _e82)) + (_e116.w * 1f));
    let _e129 = p.member.projection.row_w;
    let _e140 = ((((_e129.x * _e56) + (_e129.y * _e69)) + (_e129.z * _e82)) + (_e129.w * 1f));
    if (1u == 0u) {
        phi_221_ = _e27.v0_;
    } else {
        if (1u == 1u) {
            phi_220_ = _e27.v1_;
        } else {
            phi_220_ = _e27.v2_;
        }
        let _e147 = phi_220_;
        phi_221_ = _e147;
    }
    let _e149 = phi_221_;
    let _e165 = ((((_e31.object_to_world[0].x * _e149.x) + (_e31.object_to_world[0].y * _e149.y)) + (_e31.object_to_world[0].z * _e149.z)) + (_e31.object_to_world[0].w * 1f));
    let _e178 = ((((_e31.object_to_world[1].x * _e149.x) + (_e31.object_to_world[1].y * _e149.y)) + (_e31.object_to_world[1].z * _e149.z)) + (_e31.object_to_world[1].w * 1f));
    let _e191 = ((((_e31.object_to_world[2].x * _e149.x) + (_e31.object_to_world[2].y * _e149.y)) + (_e31.object_to_world[2].z * _e149.z)) + (_e31.object_to_world[2].w * 1f));
    let _e193 = p.member.map_size;
    let _e195 = f32(_e193);
    let _e197 = p.member.projection.row_x;
    let _e211 = p.member.projection.row_y;
    let _e225 = p.member.projection.row_z;
    let _e236 = ((((_e225.x * _e165) + (_e225.y * _e178)) + (_e225.z * _e191)) + (_e225.w * 1f));
    let _e238 = p.member.projection.row_w;
    let _e249 = ((((_e238.x * _e165) + (_e238.y * _e178)) + (_e238.z * _e191)) + (_e238.w * 1f));
    if (2u == 0u) {
        phi_331_ = _e27.v0_;
    } else {
        if (2u == 1u) {
            phi_330_ = _e27.v1_;
        } else {
            phi_330_ = _e27.v2_;
        }
        let _e256 = phi_330_;
        phi_331_ = _e256;
    }
    let _e258 = phi_331_;
    let _e274 = ((((_e31.object_to_world[0].x * _e258.x) + (_e31.object_to_world[0].y * _e258.y)) + (_e31.object_to_world[0].z * _e258.z)) + (_e31.object_to_world[0].w * 1f));
    let _e287 = ((((_e31.object_to_world[1].x * _e258.x) + (_e31.object_to_world[1].y * _e258.y)) + (_e31.object_to_world[1].z * _e258.z)) + (_e31.object_to_world[1].w * 1f));
    let _e300 = ((((_e31.object_to_world[2].x * _e258.x) + (_e31.object_to_world[2].y * _e258.y)) + (_e31.object_to_world[2].z * _e258.z)) + (_e31.object_to_world[2].w * 1f));
    let _e302 = p.member.map_size;
    let _e304 = f32(_e302);
    let _e306 = p.member.projection.row_x;
    let _e320 = p.member.projection.row_y;
    let _e334 = p.member.projection.row_z;
    let _e345 = ((((_e334.x * _e274) + (_e334.y * _e287)) + (_e334.z * _e300)) + (_e334.w * 1f));
    let _e347 = p.member.projection.row_w;
    let _e358 = ((((_e347.x * _e274) + (_e347.y * _e287)) + (_e347.z * _e300)) + (_e347.w * 1f));
    let _e363 = ((((((_e88.x * _e56) + (_e88.y * _e69)) + (_e88.z * _e82)) + (_e88.w * 1f)) * _e86) - (_e14.x * _e140));
    let _e364 = ((((((_e102.x * _e56) + (_e102.y * _e69)) + (_e102.z * _e82)) + (_e102.w * 1f)) * _e86) - (_e14.y * _e140));
    let _e367 = ((((((_e197.x * _e165) + (_e197.y * _e178)) + (_e197.z * _e191)) + (_e197.w * 1f)) * _e195) - (_e14.x * _e249));
    let _e368 = ((((((_e211.x * _e165) + (_e211.y * _e178)) + (_e211.z * _e191)) + (_e211.w * 1f)) * _e195) - (_e14.y * _e249));
    let _e371 = ((((((_e306.x * _e274) + (_e306.y * _e287)) + (_e306.z * _e300)) + (_e306.w * 1f)) * _e304) - (_e14.x * _e358));
    let _e372 = ((((((_e320.x * _e274) + (_e320.y * _e287)) + (_e320.z * _e300)) + (_e320.w * 1f)) * _e304) - (_e14.y * _e358));
    let _e375 = ((_e371 * _e368) - (_e372 * _e367));
    let _e378 = ((_e363 * _e372) - (_e364 * _e371));
    let _e381 = ((_e367 * _e364) - (_e368 * _e363));
    let _e383 = ((_e375 + _e378) + _e381);
    if (_e383 == 0f) {
        phi_462_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_462_ = vec3<f32>((_e375 / _e383), (_e378 / _e383), (_e381 / _e383));
    }
    let _e390 = phi_462_;
    let _e398 = (((_e390.x * _e127) + (_e390.y * _e236)) + (_e390.z * _e345));
    let _e399 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e127, _e236);
    let _e400 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e399, _e345);
    let _e401 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e400, 0f);
    let _e402 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e127, _e236);
    let _e403 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e402, _e345);
    let _e404 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e403, 1f);
    if (_e398 > _e401) {
        if (_e398 < _e404) {
            phi_485_ = _e398;
        } else {
            phi_485_ = _e404;
        }
        let _e408 = phi_485_;
        phi_486_ = _e408;
    } else {
        phi_486_ = _e401;
    }
    let _e410 = phi_486_;
    depth = _e410;
    return;
}

@fragment 
fn entry_depth_depth_perspective_instanced_fs(@builtin(position) at: vec4<f32>, @location(0) @interpolate(flat) triangle: u32, @location(1) @interpolate(flat) placed: u32) -> @builtin(frag_depth) f32 {
    at_1 = at;
    triangle_1 = triangle;
    placed_1 = placed;
    function_();
    let _e7 = depth;
    return _e7;
}
