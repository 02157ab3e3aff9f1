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

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_16;
@group(0) @binding(1) 
var<storage> triangles: type_11;
@group(0) @binding(2) 
var<storage> instances: type_22;
var<private> depth: f32 = 0f;
var<private> placed_1: u32;

fn lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(param: f32, param_1: f32) -> f32 {
    var phi_69_: f32;

    if (param < param_1) {
        phi_69_ = param;
    } else {
        phi_69_ = param_1;
    }
    let _e18 = phi_69_;
    return _e18;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(param_2: f32, param_3: f32) -> f32 {
    var phi_77_: f32;

    if (param_2 > param_3) {
        phi_77_ = param_2;
    } else {
        phi_77_ = param_3;
    }
    let _e18 = phi_77_;
    return _e18;
}

fn function_() {
    var phi_111_: vec3<f32>;
    var phi_112_: vec3<f32>;
    var phi_225_: vec3<f32>;
    var phi_226_: vec3<f32>;
    var phi_339_: vec3<f32>;
    var phi_340_: vec3<f32>;
    var phi_475_: vec3<f32>;
    var phi_498_: f32;
    var phi_499_: f32;

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
    if (0u == 0u) {
        phi_112_ = _e27.v0_;
    } else {
        if (0u == 1u) {
            phi_111_ = _e27.v1_;
        } else {
            phi_111_ = _e27.v2_;
        }
        let _e37 = phi_111_;
        phi_112_ = _e37;
    }
    let _e39 = phi_112_;
    let _e45 = instances.member[(0u + _e16)].object_to_world[0u];
    let _e56 = ((((_e45.x * _e39.x) + (_e45.y * _e39.y)) + (_e45.z * _e39.z)) + (_e45.w * 1f));
    let _e58 = instances.member[(0u + _e16)].object_to_world[1u];
    let _e69 = ((((_e58.x * _e39.x) + (_e58.y * _e39.y)) + (_e58.z * _e39.z)) + (_e58.w * 1f));
    let _e71 = instances.member[(0u + _e16)].object_to_world[2u];
    let _e82 = ((((_e71.x * _e39.x) + (_e71.y * _e39.y)) + (_e71.z * _e39.z)) + (_e71.w * 1f));
    let _e84 = p.member.map_size;
    let _e86 = f32(_e84);
    let _e88 = p.member.projection.row_x;
    let _e102 = p.member.projection.row_y;
    let _e116 = p.member.projection.row_z;
    let _e127 = ((((_e116.x * _e56) + (_e116.y * _e69)) + (_e116.z * _e82)) + (_e116.w * 1f));
    let _e129 = p.member.projection.row_w;
    let _e140 = ((((_e129.x * _e56) + (_e129.y * _e69)) + (_e129.z * _e82)) + (_e129.w * 1f));
    if (1u == 0u) {
        phi_226_ = _e27.v0_;
    } else {
        if (1u == 1u) {
            phi_225_ = _e27.v1_;
        } else {
            phi_225_ = _e27.v2_;
        }
        let _e147 = phi_225_;
        phi_226_ = _e147;
    }
    let _e149 = phi_226_;
    let _e155 = instances.member[(0u + _e16)].object_to_world[0u];
    let _e166 = ((((_e155.x * _e149.x) + (_e155.y * _e149.y)) + (_e155.z * _e149.z)) + (_e155.w * 1f));
    let _e168 = instances.member[(0u + _e16)].object_to_world[1u];
    let _e179 = ((((_e168.x * _e149.x) + (_e168.y * _e149.y)) + (_e168.z * _e149.z)) + (_e168.w * 1f));
    let _e181 = instances.member[(0u + _e16)].object_to_world[2u];
    let _e192 = ((((_e181.x * _e149.x) + (_e181.y * _e149.y)) + (_e181.z * _e149.z)) + (_e181.w * 1f));
    let _e194 = p.member.map_size;
    let _e196 = f32(_e194);
    let _e198 = p.member.projection.row_x;
    let _e212 = p.member.projection.row_y;
    let _e226 = p.member.projection.row_z;
    let _e237 = ((((_e226.x * _e166) + (_e226.y * _e179)) + (_e226.z * _e192)) + (_e226.w * 1f));
    let _e239 = p.member.projection.row_w;
    let _e250 = ((((_e239.x * _e166) + (_e239.y * _e179)) + (_e239.z * _e192)) + (_e239.w * 1f));
    if (2u == 0u) {
        phi_340_ = _e27.v0_;
    } else {
        if (2u == 1u) {
            phi_339_ = _e27.v1_;
        } else {
            phi_339_ = _e27.v2_;
        }
        let _e257 = phi_339_;
        phi_340_ = _e257;
    }
    let _e259 = phi_340_;
    let _e265 = instances.member[(0u + _e16)].object_to_world[0u];
    let _e276 = ((((_e265.x * _e259.x) + (_e265.y * _e259.y)) + (_e265.z * _e259.z)) + (_e265.w * 1f));
    let _e278 = instances.member[(0u + _e16)].object_to_world[1u];
    let _e289 = ((((_e278.x * _e259.x) + (_e278.y * _e259.y)) + (_e278.z * _e259.z)) + (_e278.w * 1f));
    let _e291 = instances.member[(0u + _e16)].object_to_world[2u];
    let _e302 = ((((_e291.x * _e259.x) + (_e291.y * _e259.y)) + (_e291.z * _e259.z)) + (_e291.w * 1f));
    let _e304 = p.member.map_size;
    let _e306 = f32(_e304);
    let _e308 = p.member.projection.row_x;
    let _e322 = p.member.projection.row_y;
    let _e336 = p.member.projection.row_z;
    let _e347 = ((((_e336.x * _e276) + (_e336.y * _e289)) + (_e336.z * _e302)) + (_e336.w * 1f));
    let _e349 = p.member.projection.row_w;
    let _e360 = ((((_e349.x * _e276) + (_e349.y * _e289)) + (_e349.z * _e302)) + (_e349.w * 1f));
    let _e365 = ((((((_e88.x * _e56) + (_e88.y * _e69)) + (_e88.z * _e82)) + (_e88.w * 1f)) * _e86) - (_e14.x * _e140));
    let _e366 = ((((((_e102.x * _e56) + (_e102.y * _e69)) + (_e102.z * _e82)) + (_e102.w * 1f)) * _e86) - (_e14.y * _e140));
    let _e369 = ((((((_e198.x * _e166) + (_e198.y * _e179)) + (_e198.z * _e192)) + (_e198.w * 1f)) * _e196) - (_e14.x * _e250));
    let _e370 = ((((((_e212.x * _e166) + (_e212.y * _e179)) + (_e212.z * _e192)) + (_e212.w * 1f)) * _e196) - (_e14.y * _e250));
    let _e373 = ((((((_e308.x * _e276) + (_e308.y * _e289)) + (_e308.z * _e302)) + (_e308.w * 1f)) * _e306) - (_e14.x * _e360));
    let _e374 = ((((((_e322.x * _e276) + (_e322.y * _e289)) + (_e322.z * _e302)) + (_e322.w * 1f)) * _e306) - (_e14.y * _e360));
    let _e377 = ((_e373 * _e370) - (_e374 * _e369));
    let _e380 = ((_e365 * _e374) - (_e366 * _e373));
    let _e383 = ((_e369 * _e366) - (_e370 * _e365));
    let _e385 = ((_e377 + _e380) + _e383);
    if (_e385 == 0f) {
        phi_475_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_475_ = vec3<f32>((_e377 / _e385), (_e380 / _e385), (_e383 / _e385));
    }
    let _e392 = phi_475_;
    let _e400 = (((_e392.x * _e127) + (_e392.y * _e237)) + (_e392.z * _e347));
    let _e401 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e127, _e237);
    let _e402 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e401, _e347);
    let _e403 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e402, 0f);
    let _e404 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e127, _e237);
    let _e405 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e404, _e347);
    let _e406 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e405, 1f);
    if (_e400 > _e403) {
        if (_e400 < _e406) {
            phi_498_ = _e400;
        } else {
            phi_498_ = _e406;
        }
        let _e410 = phi_498_;
        phi_499_ = _e410;
    } else {
        phi_499_ = _e403;
    }
    let _e412 = phi_499_;
    depth = _e412;
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
