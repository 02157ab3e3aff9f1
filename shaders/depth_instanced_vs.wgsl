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

@group(0) @binding(0) 
var<uniform> p: type_15;
@group(0) @binding(1) 
var<storage> triangles: type_11;
var<private> vertex_1: u32;
var<private> position: vec4<f32> = vec4<f32>(0f, 0f, 0f, 1f);
var<private> instance_1: u32;
@group(0) @binding(2) 
var<storage> instances: type_22;

fn function_() {
    var phi_90_: vec3<f32>;
    var phi_91_: vec3<f32>;

    let _e13 = vertex_1;
    let _e14 = instance_1;
    let _e22 = (_e13 / 3u);
    if (_e22 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e26 = (_e13 % 3u);
    if (_e14 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    if (_e26 == 0u) {
        let _e32 = triangles.member[(0u + _e22)].v0_;
        phi_91_ = _e32;
    } else {
        if (_e26 == 1u) {
            let _e35 = triangles.member[(0u + _e22)].v1_;
            phi_90_ = _e35;
        } else {
            let _e37 = triangles.member[(0u + _e22)].v2_;
            phi_90_ = _e37;
        }
        let _e39 = phi_90_;
        phi_91_ = _e39;
    }
    let _e41 = phi_91_;
    let _e47 = instances.member[(0u + _e14)].object_to_world[0u];
    let _e58 = ((((_e47.x * _e41.x) + (_e47.y * _e41.y)) + (_e47.z * _e41.z)) + (_e47.w * 1f));
    let _e60 = instances.member[(0u + _e14)].object_to_world[1u];
    let _e71 = ((((_e60.x * _e41.x) + (_e60.y * _e41.y)) + (_e60.z * _e41.z)) + (_e60.w * 1f));
    let _e73 = instances.member[(0u + _e14)].object_to_world[2u];
    let _e84 = ((((_e73.x * _e41.x) + (_e73.y * _e41.y)) + (_e73.z * _e41.z)) + (_e73.w * 1f));
    let _e87 = p.member.projection.row_w;
    let _e98 = ((((_e87.x * _e58) + (_e87.y * _e71)) + (_e87.z * _e84)) + (_e87.w * 1f));
    let _e100 = p.member.projection.row_x;
    let _e113 = p.member.projection.row_y;
    let _e130 = p.member.projection.row_z;
    position = vec4<f32>(((2f * ((((_e100.x * _e58) + (_e100.y * _e71)) + (_e100.z * _e84)) + (_e100.w * 1f))) - _e98), (_e98 - (2f * ((((_e113.x * _e58) + (_e113.y * _e71)) + (_e113.z * _e84)) + (_e113.w * 1f)))), (((((_e130.x * _e58) + (_e130.y * _e71)) + (_e130.z * _e84)) + (_e130.w * 1f)) * _e98), _e98);
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
