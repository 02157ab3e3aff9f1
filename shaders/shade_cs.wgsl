struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: vec4<f32>,
    light_color: vec4<f32>,
}

struct type_34 {
    member: abi_ShadeParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> visibility: type_17;
@group(0) @binding(3) 
var<storage, read_write> picture: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_129_: lt_bvh_traverse_Tree;
    var phi_130_: bool;
    var phi_131_: lt_bvh_traverse_Tree;
    var phi_132_: bool;
    var phi_137_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_129_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_130_ = false;
        } else {
            phi_129_ = lt_bvh_traverse_Tree();
            phi_130_ = true;
        }
        let _e62 = phi_129_;
        let _e64 = phi_130_;
        phi_131_ = _e62;
        phi_132_ = _e64;
    } else {
        phi_131_ = lt_bvh_traverse_Tree();
        phi_132_ = true;
    }
    let _e66 = phi_131_;
    let _e68 = phi_132_;
    if _e68 {
        phi_137_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_137_ = _e66;
    }
    let _e73 = phi_137_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn function_() {
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_258_: bool;
    var phi_259_: bool;
    var phi_263_: bool;
    var phi_317_: f32;
    var phi_443_: f32;
    var phi_444_: f32;
    var phi_464_: f32;
    var phi_465_: f32;
    var phi_474_: f32;
    var phi_475_: f32;
    var phi_495_: f32;
    var phi_496_: f32;
    var phi_505_: f32;
    var phi_506_: f32;
    var phi_526_: f32;
    var phi_527_: f32;
    var phi_564_: f32;
    var phi_593_: f32;
    var phi_594_: f32;
    var phi_614_: f32;
    var phi_615_: f32;
    var phi_624_: f32;
    var phi_625_: f32;
    var phi_645_: f32;
    var phi_646_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_676_: f32;
    var phi_677_: f32;
    var phi_710_: u32;

    let _e49 = id_1;
    let _e63 = p.member.camera.size[0u];
    let _e65 = p.member.camera.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e49, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        if (_e66.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e66.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e79 = visibility.member[(0u + _e66.first_primitive)];
        let _e85 = p.member.camera.size[0u];
        let _e89 = ((((f32(_e49.x) + 0.5f) / f32(_e85)) * 2f) - 1f);
        let _e94 = p.member.camera.size[1u];
        let _e98 = (1f - (((f32(_e49.y) + 0.5f) / f32(_e94)) * 2f));
        let _e100 = p.member.camera.forward;
        let _e102 = p.member.camera.right;
        let _e116 = p.member.camera.up;
        let _e123 = ((_e100.x + (_e102.x * _e89)) + (_e116.x * _e98));
        let _e124 = ((_e100.y + (_e102.y * _e89)) + (_e116.y * _e98));
        let _e125 = ((_e100.z + (_e102.z * _e89)) + (_e116.z * _e98));
        let _e132 = (1f / sqrt((((_e123 * _e123) + (_e124 * _e124)) + (_e125 * _e125))));
        let _e134 = (_e124 * _e132);
        let _e138 = samples.member[(0u + _e66.first_primitive)].normal[0u];
        let _e140 = global[0u];
        if (_e138 == _e140) {
            let _e143 = samples.member[(0u + _e66.first_primitive)].normal[1u];
            let _e145 = global[1u];
            if (_e143 == _e145) {
                let _e148 = samples.member[(0u + _e66.first_primitive)].normal[2u];
                let _e150 = global[2u];
                phi_256_ = (_e148 == _e150);
                phi_257_ = false;
            } else {
                phi_256_ = bool();
                phi_257_ = true;
            }
            let _e153 = phi_256_;
            let _e155 = phi_257_;
            phi_258_ = _e153;
            phi_259_ = _e155;
        } else {
            phi_258_ = bool();
            phi_259_ = true;
        }
        let _e157 = phi_258_;
        let _e159 = phi_259_;
        if _e159 {
            phi_263_ = false;
        } else {
            phi_263_ = _e157;
        }
        let _e161 = phi_263_;
        if !(_e161) {
            let _e164 = samples.member[(0u + _e66.first_primitive)].shading_normal;
            let _e166 = p.member.light;
            let _e171 = samples.member[(0u + _e66.first_primitive)].position;
            let _e174 = p.member.light[3u];
            let _e181 = (_e166.x - (_e171.x * _e174));
            let _e182 = (_e166.y - (_e171.y * _e174));
            let _e183 = (_e166.z - (_e171.z * _e174));
            let _e190 = (1f / sqrt((((_e181 * _e181) + (_e182 * _e182)) + (_e183 * _e183))));
            let _e201 = (((_e164.x * (_e181 * _e190)) + (_e164.y * (_e182 * _e190))) + (_e164.z * (_e183 * _e190)));
            let _e203 = p.member.light_color;
            if (_e201 > 0f) {
                phi_317_ = (_e201 * _e79);
            } else {
                phi_317_ = 0f;
            }
            let _e210 = phi_317_;
            let _e216 = (0.5f + (0.5f * _e164.y));
            let _e217 = (1f - 0.4f);
            let _e236 = (1f - _e216);
            let _e262 = (0.8f + (0.2f * abs((((_e164.x * -((_e123 * _e132))) + (_e164.y * -(_e134))) + (_e164.z * -((_e125 * _e132)))))));
            let _e264 = samples.member[(0u + _e66.first_primitive)].albedo;
            let _e275 = (1f / 255f);
            let _e276 = (f32((_e264 & 255u)) * _e275);
            let _e277 = (f32(((_e264 >> bitcast<u32>(8i)) & 255u)) * _e275);
            let _e278 = (f32(((_e264 >> bitcast<u32>(16i)) & 255u)) * _e275);
            let _e292 = samples.member[(0u + _e66.first_primitive)].position;
            let _e295 = p.member.camera.eye;
            let _e298 = (_e292.x - _e295.x);
            let _e301 = (_e292.y - _e295.y);
            let _e304 = (_e292.z - _e295.z);
            let _e313 = p.member.light_color[3u];
            let _e317 = (1f - (1f / (1f + (sqrt((((_e298 * _e298) + (_e301 * _e301)) + (_e304 * _e304))) * _e313))));
            let _e318 = (1f - _e317);
            let _e328 = ((((_e276 * _e276) * ((_e203.x * _e210) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e217) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e216) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e236)) * 0.42f) * _e262))) * _e318) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e317));
            let _e329 = ((((_e277 * _e277) * ((_e203.y * _e210) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e217) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e216) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e236)) * 0.42f) * _e262))) * _e318) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e317));
            let _e330 = ((((_e278 * _e278) * ((_e203.z * _e210) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e217) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e216) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e236)) * 0.42f) * _e262))) * _e318) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e317));
            if (_e328 > 0f) {
                if (_e328 < 1f) {
                    phi_443_ = _e328;
                } else {
                    phi_443_ = 1f;
                }
                let _e334 = phi_443_;
                phi_444_ = _e334;
            } else {
                phi_444_ = 0f;
            }
            let _e336 = phi_444_;
            let _e339 = sqrt(sqrt(_e336));
            let _e347 = ((((0.6620027f * sqrt(_e336)) + (0.6841221f * _e339)) - (0.3235836f * sqrt(_e339))) - (0.022541147f * _e336));
            if (_e347 > 0f) {
                if (_e347 < 1f) {
                    phi_464_ = _e347;
                } else {
                    phi_464_ = 1f;
                }
                let _e351 = phi_464_;
                phi_465_ = _e351;
            } else {
                phi_465_ = 0f;
            }
            let _e353 = phi_465_;
            if (_e329 > 0f) {
                if (_e329 < 1f) {
                    phi_474_ = _e329;
                } else {
                    phi_474_ = 1f;
                }
                let _e357 = phi_474_;
                phi_475_ = _e357;
            } else {
                phi_475_ = 0f;
            }
            let _e359 = phi_475_;
            let _e362 = sqrt(sqrt(_e359));
            let _e370 = ((((0.6620027f * sqrt(_e359)) + (0.6841221f * _e362)) - (0.3235836f * sqrt(_e362))) - (0.022541147f * _e359));
            if (_e370 > 0f) {
                if (_e370 < 1f) {
                    phi_495_ = _e370;
                } else {
                    phi_495_ = 1f;
                }
                let _e374 = phi_495_;
                phi_496_ = _e374;
            } else {
                phi_496_ = 0f;
            }
            let _e376 = phi_496_;
            if (_e330 > 0f) {
                if (_e330 < 1f) {
                    phi_505_ = _e330;
                } else {
                    phi_505_ = 1f;
                }
                let _e380 = phi_505_;
                phi_506_ = _e380;
            } else {
                phi_506_ = 0f;
            }
            let _e382 = phi_506_;
            let _e385 = sqrt(sqrt(_e382));
            let _e393 = ((((0.6620027f * sqrt(_e382)) + (0.6841221f * _e385)) - (0.3235836f * sqrt(_e385))) - (0.022541147f * _e382));
            if (_e393 > 0f) {
                if (_e393 < 1f) {
                    phi_526_ = _e393;
                } else {
                    phi_526_ = 1f;
                }
                let _e397 = phi_526_;
                phi_527_ = _e397;
            } else {
                phi_527_ = 0f;
            }
            let _e399 = phi_527_;
            let _e401 = ((_e353 * 255f) + 0.5f);
            let _e410 = ((_e376 * 255f) + 0.5f);
            let _e422 = ((_e399 * 255f) + 0.5f);
            phi_710_ = (((select(select(u32(_e401), 0u, (_e401 < bitcast<f32>(0u))), 4294967295u, (_e401 > bitcast<f32>(1333788671u))) | (select(select(u32(_e410), 0u, (_e410 < bitcast<f32>(0u))), 4294967295u, (_e410 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e422), 0u, (_e422 < bitcast<f32>(0u))), 4294967295u, (_e422 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e134 > 0f) {
                phi_564_ = _e134;
            } else {
                phi_564_ = 0f;
            }
            let _e436 = phi_564_;
            let _e440 = (1f - ((1f - _e436) * (1f - _e436)));
            let _e441 = (1f - _e440);
            let _e454 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e441) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e440));
            let _e455 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e441) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e440));
            let _e456 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e441) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e440));
            if (_e454 > 0f) {
                if (_e454 < 1f) {
                    phi_593_ = _e454;
                } else {
                    phi_593_ = 1f;
                }
                let _e460 = phi_593_;
                phi_594_ = _e460;
            } else {
                phi_594_ = 0f;
            }
            let _e462 = phi_594_;
            let _e465 = sqrt(sqrt(_e462));
            let _e473 = ((((0.6620027f * sqrt(_e462)) + (0.6841221f * _e465)) - (0.3235836f * sqrt(_e465))) - (0.022541147f * _e462));
            if (_e473 > 0f) {
                if (_e473 < 1f) {
                    phi_614_ = _e473;
                } else {
                    phi_614_ = 1f;
                }
                let _e477 = phi_614_;
                phi_615_ = _e477;
            } else {
                phi_615_ = 0f;
            }
            let _e479 = phi_615_;
            if (_e455 > 0f) {
                if (_e455 < 1f) {
                    phi_624_ = _e455;
                } else {
                    phi_624_ = 1f;
                }
                let _e483 = phi_624_;
                phi_625_ = _e483;
            } else {
                phi_625_ = 0f;
            }
            let _e485 = phi_625_;
            let _e488 = sqrt(sqrt(_e485));
            let _e496 = ((((0.6620027f * sqrt(_e485)) + (0.6841221f * _e488)) - (0.3235836f * sqrt(_e488))) - (0.022541147f * _e485));
            if (_e496 > 0f) {
                if (_e496 < 1f) {
                    phi_645_ = _e496;
                } else {
                    phi_645_ = 1f;
                }
                let _e500 = phi_645_;
                phi_646_ = _e500;
            } else {
                phi_646_ = 0f;
            }
            let _e502 = phi_646_;
            if (_e456 > 0f) {
                if (_e456 < 1f) {
                    phi_655_ = _e456;
                } else {
                    phi_655_ = 1f;
                }
                let _e506 = phi_655_;
                phi_656_ = _e506;
            } else {
                phi_656_ = 0f;
            }
            let _e508 = phi_656_;
            let _e511 = sqrt(sqrt(_e508));
            let _e519 = ((((0.6620027f * sqrt(_e508)) + (0.6841221f * _e511)) - (0.3235836f * sqrt(_e511))) - (0.022541147f * _e508));
            if (_e519 > 0f) {
                if (_e519 < 1f) {
                    phi_676_ = _e519;
                } else {
                    phi_676_ = 1f;
                }
                let _e523 = phi_676_;
                phi_677_ = _e523;
            } else {
                phi_677_ = 0f;
            }
            let _e525 = phi_677_;
            let _e527 = ((_e479 * 255f) + 0.5f);
            let _e536 = ((_e502 * 255f) + 0.5f);
            let _e548 = ((_e525 * 255f) + 0.5f);
            phi_710_ = (((select(select(u32(_e527), 0u, (_e527 < bitcast<f32>(0u))), 4294967295u, (_e527 > bitcast<f32>(1333788671u))) | (select(select(u32(_e536), 0u, (_e536 < bitcast<f32>(0u))), 4294967295u, (_e536 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e548), 0u, (_e548 < bitcast<f32>(0u))), 4294967295u, (_e548 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e561 = phi_710_;
        if (_e66.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e66.first_primitive)] = _e561;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
