struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
}

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_14 {
    member: array<abi_Sample>,
}

struct type_18 {
    member: array<f32>,
}

struct type_28 {
    member: array<vec4<f32>>,
}

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: abi_LightParams,
    light_color: vec4<f32>,
}

struct type_32 {
    member: abi_ShadeParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_14;
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> visibility: type_18;
@group(0) @binding(3) 
var<storage, read_write> light: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_93_: lt_bvh_traverse_Tree;
    var phi_94_: bool;
    var phi_95_: lt_bvh_traverse_Tree;
    var phi_96_: bool;
    var phi_101_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_93_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_94_ = false;
        } else {
            phi_93_ = lt_bvh_traverse_Tree();
            phi_94_ = true;
        }
        let _e31 = phi_93_;
        let _e33 = phi_94_;
        phi_95_ = _e31;
        phi_96_ = _e33;
    } else {
        phi_95_ = lt_bvh_traverse_Tree();
        phi_96_ = true;
    }
    let _e35 = phi_95_;
    let _e37 = phi_96_;
    if _e37 {
        phi_101_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_101_ = _e35;
    }
    let _e42 = phi_101_;
    return lt_bvh_traverse_Tree(_e42.root, _e42.first_primitive);
}

fn function_() {
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_240_: f32;
    var phi_242_: f32;
    var phi_259_: vec3<f32>;

    let _e18 = id_1;
    let _e32 = p.member.camera.size[0u];
    let _e34 = p.member.camera.size[1u];
    let _e35 = lt_shaders_entry_pixel_index(_e18, _e32, _e34);
    if (bitcast<i32>(_e35.root) != 0i) {
        if (_e35.first_primitive < arrayLength((&light.member))) {
        } else {
            return;
        }
        if (_e35.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e35.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e49 = visibility.member[(0u + _e35.first_primitive)];
        let _e51 = samples.member[(0u + _e35.first_primitive)].position;
        let _e54 = p.member.light.place;
        let _e60 = p.member.light.place[3u];
        let _e67 = (_e54.x - (_e51.x * _e60));
        let _e68 = (_e54.y - (_e51.y * _e60));
        let _e69 = (_e54.z - (_e51.z * _e60));
        let _e71 = samples.member[(0u + _e35.first_primitive)].shading_normal;
        let _e78 = (1f / sqrt((((_e67 * _e67) + (_e68 * _e68)) + (_e69 * _e69))));
        let _e89 = (((_e71.x * (_e67 * _e78)) + (_e71.y * (_e68 * _e78))) + (_e71.z * (_e69 * _e78)));
        if (_e89 > 0f) {
            let _e94 = p.member.light.place[3u];
            if (_e94 == 0f) {
                phi_240_ = 1f;
            } else {
                let _e100 = (((_e67 * _e67) + (_e68 * _e68)) + (_e69 * _e69));
                let _e102 = p.member.light.axis;
                let _e115 = p.member.light.cos_inner;
                let _e117 = p.member.light.cos_outer;
                let _e118 = (_e115 - _e117);
                if (_e118 > 0f) {
                    let _e121 = p.member.light.cos_outer;
                    let _e123 = (((-((((_e67 * _e102.x) + (_e68 * _e102.y)) + (_e69 * _e102.z))) / sqrt(_e100)) - _e121) / _e118);
                    if (_e123 > 0f) {
                        if (_e123 < 1f) {
                            phi_235_ = _e123;
                        } else {
                            phi_235_ = 1f;
                        }
                        let _e127 = phi_235_;
                        phi_236_ = _e127;
                    } else {
                        phi_236_ = 0f;
                    }
                    let _e129 = phi_236_;
                    phi_237_ = _e129;
                } else {
                    phi_237_ = 1f;
                }
                let _e131 = phi_237_;
                phi_240_ = ((_e131 * _e131) / _e100);
            }
            let _e135 = phi_240_;
            phi_242_ = (_e89 * _e135);
        } else {
            phi_242_ = 0f;
        }
        let _e138 = phi_242_;
        if (_e138 > 0f) {
            let _e141 = p.member.light_color;
            phi_259_ = vec3<f32>((_e141.x * (_e49 * _e138)), (_e141.y * (_e49 * _e138)), (_e141.z * (_e49 * _e138)));
        } else {
            phi_259_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e153 = phi_259_;
        let _e158 = light.member[(0u + _e35.first_primitive)][0u];
        light.member[(0u + _e35.first_primitive)][0u] = (_e158 + _e153.x);
        let _e161 = light.member[(0u + _e35.first_primitive)][1u];
        light.member[(0u + _e35.first_primitive)][1u] = (_e161 + _e153.y);
        let _e164 = light.member[(0u + _e35.first_primitive)][2u];
        light.member[(0u + _e35.first_primitive)][2u] = (_e164 + _e153.z);
        let _e167 = light.member[(0u + _e35.first_primitive)][3u];
        light.member[(0u + _e35.first_primitive)][3u] = (_e167 + 0f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_light_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
