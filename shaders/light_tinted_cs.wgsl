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
@group(0) @binding(4) 
var<storage> tints: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_94_: lt_bvh_traverse_Tree;
    var phi_95_: bool;
    var phi_96_: lt_bvh_traverse_Tree;
    var phi_97_: bool;
    var phi_102_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_94_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_95_ = false;
        } else {
            phi_94_ = lt_bvh_traverse_Tree();
            phi_95_ = true;
        }
        let _e32 = phi_94_;
        let _e34 = phi_95_;
        phi_96_ = _e32;
        phi_97_ = _e34;
    } else {
        phi_96_ = lt_bvh_traverse_Tree();
        phi_97_ = true;
    }
    let _e36 = phi_96_;
    let _e38 = phi_97_;
    if _e38 {
        phi_102_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_102_ = _e36;
    }
    let _e43 = phi_102_;
    return lt_bvh_traverse_Tree(_e43.root, _e43.first_primitive);
}

fn function_() {
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_256_: f32;
    var phi_258_: f32;
    var phi_275_: vec3<f32>;

    let _e19 = id_1;
    let _e36 = p.member.camera.size[0u];
    let _e38 = p.member.camera.size[1u];
    let _e39 = lt_shaders_entry_pixel_index(_e19, _e36, _e38);
    if (bitcast<i32>(_e39.root) != 0i) {
        if (_e39.first_primitive < arrayLength((&light.member))) {
        } else {
            return;
        }
        if (_e39.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e39.first_primitive < arrayLength((&tints.member))) {
        } else {
            return;
        }
        let _e53 = tints.member[(0u + _e39.first_primitive)];
        if (_e39.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e60 = visibility.member[(0u + _e39.first_primitive)];
        let _e65 = samples.member[(0u + _e39.first_primitive)].position;
        let _e68 = p.member.light.place;
        let _e74 = p.member.light.place[3u];
        let _e81 = (_e68.x - (_e65.x * _e74));
        let _e82 = (_e68.y - (_e65.y * _e74));
        let _e83 = (_e68.z - (_e65.z * _e74));
        let _e85 = samples.member[(0u + _e39.first_primitive)].shading_normal;
        let _e92 = (1f / sqrt((((_e81 * _e81) + (_e82 * _e82)) + (_e83 * _e83))));
        let _e103 = (((_e85.x * (_e81 * _e92)) + (_e85.y * (_e82 * _e92))) + (_e85.z * (_e83 * _e92)));
        if (_e103 > 0f) {
            let _e108 = p.member.light.place[3u];
            if (_e108 == 0f) {
                phi_256_ = 1f;
            } else {
                let _e114 = (((_e81 * _e81) + (_e82 * _e82)) + (_e83 * _e83));
                let _e116 = p.member.light.axis;
                let _e129 = p.member.light.cos_inner;
                let _e131 = p.member.light.cos_outer;
                let _e132 = (_e129 - _e131);
                if (_e132 > 0f) {
                    let _e135 = p.member.light.cos_outer;
                    let _e137 = (((-((((_e81 * _e116.x) + (_e82 * _e116.y)) + (_e83 * _e116.z))) / sqrt(_e114)) - _e135) / _e132);
                    if (_e137 > 0f) {
                        if (_e137 < 1f) {
                            phi_251_ = _e137;
                        } else {
                            phi_251_ = 1f;
                        }
                        let _e141 = phi_251_;
                        phi_252_ = _e141;
                    } else {
                        phi_252_ = 0f;
                    }
                    let _e143 = phi_252_;
                    phi_253_ = _e143;
                } else {
                    phi_253_ = 1f;
                }
                let _e145 = phi_253_;
                phi_256_ = ((_e145 * _e145) / _e114);
            }
            let _e149 = phi_256_;
            phi_258_ = (_e103 * _e149);
        } else {
            phi_258_ = 0f;
        }
        let _e152 = phi_258_;
        if (_e152 > 0f) {
            let _e155 = p.member.light_color;
            phi_275_ = vec3<f32>((_e155.x * ((_e53.x * _e60) * _e152)), (_e155.y * ((_e53.y * _e60) * _e152)), (_e155.z * ((_e53.z * _e60) * _e152)));
        } else {
            phi_275_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e167 = phi_275_;
        let _e172 = light.member[(0u + _e39.first_primitive)][0u];
        light.member[(0u + _e39.first_primitive)][0u] = (_e172 + _e167.x);
        let _e175 = light.member[(0u + _e39.first_primitive)][1u];
        light.member[(0u + _e39.first_primitive)][1u] = (_e175 + _e167.y);
        let _e178 = light.member[(0u + _e39.first_primitive)][2u];
        light.member[(0u + _e39.first_primitive)][2u] = (_e178 + _e167.z);
        let _e181 = light.member[(0u + _e39.first_primitive)][3u];
        light.member[(0u + _e39.first_primitive)][3u] = (_e181 + 0f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_light_tinted_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
