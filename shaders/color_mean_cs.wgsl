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

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_18 {
    member: array<vec4<f32>>,
}

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: abi_LightParams,
    light_color: vec4<f32>,
}

struct type_22 {
    member: abi_ShadeParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_22;
@group(0) @binding(1) 
var<storage> colors: type_18;
@group(0) @binding(2) 
var<storage, read_write> picture: type_9;

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
        let _e41 = phi_93_;
        let _e43 = phi_94_;
        phi_95_ = _e41;
        phi_96_ = _e43;
    } else {
        phi_95_ = lt_bvh_traverse_Tree();
        phi_96_ = true;
    }
    let _e45 = phi_95_;
    let _e47 = phi_96_;
    if _e47 {
        phi_101_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_101_ = _e45;
    }
    let _e52 = phi_101_;
    return lt_bvh_traverse_Tree(_e52.root, _e52.first_primitive);
}

fn function_() {
    var phi_154_: vec3<f32>;
    var phi_157_: u32;
    var phi_155_: vec3<f32>;
    var phi_158_: u32;
    var local: vec3<f32>;
    var local_1: vec3<f32>;
    var local_2: vec3<f32>;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_282_: f32;
    var phi_283_: f32;
    var phi_303_: f32;
    var phi_304_: f32;

    let _e28 = id_1;
    let _e39 = p.member.camera.size[0u];
    let _e41 = p.member.camera.size[1u];
    let _e45 = p.member.camera.grid[0u];
    let _e47 = p.member.camera.grid[1u];
    if (_e45 == 0u) {
        return;
    }
    if (_e47 == 0u) {
        return;
    }
    let _e52 = lt_shaders_entry_pixel_index(_e28, (_e39 / _e45), (_e41 / _e47));
    if (bitcast<i32>(_e52.root) != 0i) {
        let _e62 = p.member.camera.grid[0u];
        let _e64 = p.member.camera.grid[1u];
        let _e68 = p.member.camera.size[0u];
        phi_154_ = vec3<f32>(0f, 0f, 0f);
        phi_157_ = 0u;
        loop {
            let _e70 = phi_154_;
            let _e72 = phi_157_;
            local = _e70;
            local_1 = _e70;
            local_2 = _e70;
            let _e74 = (_e72 < (_e62 * _e64));
            if _e74 {
                if (_e62 == 0u) {
                    return;
                }
                if (_e62 == 0u) {
                    return;
                }
                let _e84 = ((((_e28.y * _e64) + (_e72 / _e62)) * _e68) + ((_e28.x * _e62) + (_e72 % _e62)));
                if (_e84 < arrayLength((&colors.member))) {
                } else {
                    return;
                }
                let _e88 = colors.member[(0u + _e84)];
                let _e93 = (_e70.x + _e88.x);
                let _e97 = vec3<f32>(_e93, _e70.y, _e70.z);
                let _e99 = (_e97.y + _e88.y);
                phi_155_ = vec3<f32>(_e93, _e99, (vec3<f32>(_e97.x, _e99, _e97.z).z + _e88.z));
                phi_158_ = (_e72 + 1u);
            } else {
                phi_155_ = vec3<f32>();
                phi_158_ = u32();
            }
            let _e109 = phi_155_;
            let _e111 = phi_158_;
            continue;
            continuing {
                phi_154_ = _e109;
                phi_157_ = _e111;
                break if !(_e74);
            }
        }
        let _e114 = f32((_e62 * _e64));
        let _e116 = local;
        let _e118 = (_e116.x / _e114);
        let _e120 = local_1;
        let _e122 = (_e120.y / _e114);
        let _e124 = local_2;
        let _e126 = (_e124.z / _e114);
        if (_e118 > 0f) {
            if (_e118 < 1f) {
                phi_220_ = _e118;
            } else {
                phi_220_ = 1f;
            }
            let _e130 = phi_220_;
            phi_221_ = _e130;
        } else {
            phi_221_ = 0f;
        }
        let _e132 = phi_221_;
        let _e135 = sqrt(sqrt(_e132));
        let _e143 = ((((0.6620027f * sqrt(_e132)) + (0.6841221f * _e135)) - (0.3235836f * sqrt(_e135))) - (0.022541147f * _e132));
        if (_e143 > 0f) {
            if (_e143 < 1f) {
                phi_241_ = _e143;
            } else {
                phi_241_ = 1f;
            }
            let _e147 = phi_241_;
            phi_242_ = _e147;
        } else {
            phi_242_ = 0f;
        }
        let _e149 = phi_242_;
        if (_e122 > 0f) {
            if (_e122 < 1f) {
                phi_251_ = _e122;
            } else {
                phi_251_ = 1f;
            }
            let _e153 = phi_251_;
            phi_252_ = _e153;
        } else {
            phi_252_ = 0f;
        }
        let _e155 = phi_252_;
        let _e158 = sqrt(sqrt(_e155));
        let _e166 = ((((0.6620027f * sqrt(_e155)) + (0.6841221f * _e158)) - (0.3235836f * sqrt(_e158))) - (0.022541147f * _e155));
        if (_e166 > 0f) {
            if (_e166 < 1f) {
                phi_272_ = _e166;
            } else {
                phi_272_ = 1f;
            }
            let _e170 = phi_272_;
            phi_273_ = _e170;
        } else {
            phi_273_ = 0f;
        }
        let _e172 = phi_273_;
        if (_e126 > 0f) {
            if (_e126 < 1f) {
                phi_282_ = _e126;
            } else {
                phi_282_ = 1f;
            }
            let _e176 = phi_282_;
            phi_283_ = _e176;
        } else {
            phi_283_ = 0f;
        }
        let _e178 = phi_283_;
        let _e181 = sqrt(sqrt(_e178));
        let _e189 = ((((0.6620027f * sqrt(_e178)) + (0.6841221f * _e181)) - (0.3235836f * sqrt(_e181))) - (0.022541147f * _e178));
        if (_e189 > 0f) {
            if (_e189 < 1f) {
                phi_303_ = _e189;
            } else {
                phi_303_ = 1f;
            }
            let _e193 = phi_303_;
            phi_304_ = _e193;
        } else {
            phi_304_ = 0f;
        }
        let _e195 = phi_304_;
        let _e197 = ((_e149 * 255f) + 0.5f);
        let _e206 = ((_e172 * 255f) + 0.5f);
        let _e218 = ((_e195 * 255f) + 0.5f);
        if (_e52.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e52.first_primitive)] = (((select(select(u32(_e197), 0u, (_e197 < bitcast<f32>(0u))), 4294967295u, (_e197 > bitcast<f32>(1333788671u))) | (select(select(u32(_e206), 0u, (_e206 < bitcast<f32>(0u))), 4294967295u, (_e206 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e218), 0u, (_e218 < bitcast<f32>(0u))), 4294967295u, (_e218 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_color_mean_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
