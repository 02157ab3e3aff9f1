struct type_7 {
    member: array<u32>,
}

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

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: vec4<f32>,
    light_color: vec4<f32>,
}

struct type_19 {
    member: abi_ShadeParams,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(0) 
var<uniform> p: type_19;
@group(0) @binding(1) 
var<storage> samples: type_23;
@group(0) @binding(2) 
var<storage> visibility: type_27;
@group(0) @binding(3) 
var<storage, read_write> picture: type_7;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_705_: lt_bvh_traverse_Tree;
    var phi_706_: bool;
    var phi_707_: lt_bvh_traverse_Tree;
    var phi_708_: bool;
    var phi_713_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_705_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_706_ = false;
        } else {
            phi_705_ = lt_bvh_traverse_Tree();
            phi_706_ = true;
        }
        let _e62 = phi_705_;
        let _e64 = phi_706_;
        phi_707_ = _e62;
        phi_708_ = _e64;
    } else {
        phi_707_ = lt_bvh_traverse_Tree();
        phi_708_ = true;
    }
    let _e66 = phi_707_;
    let _e68 = phi_708_;
    if _e68 {
        phi_713_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_713_ = _e66;
    }
    let _e73 = phi_713_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn function_() {
    var phi_225_: bool;
    var phi_226_: bool;
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_232_: bool;
    var phi_286_: f32;
    var phi_412_: f32;
    var phi_413_: f32;
    var phi_433_: f32;
    var phi_434_: f32;
    var phi_443_: f32;
    var phi_444_: f32;
    var phi_464_: f32;
    var phi_465_: f32;
    var phi_474_: f32;
    var phi_475_: f32;
    var phi_495_: f32;
    var phi_496_: f32;
    var phi_533_: f32;
    var phi_562_: f32;
    var phi_563_: f32;
    var phi_583_: f32;
    var phi_584_: f32;
    var phi_593_: f32;
    var phi_594_: f32;
    var phi_614_: f32;
    var phi_615_: f32;
    var phi_624_: f32;
    var phi_625_: f32;
    var phi_645_: f32;
    var phi_646_: f32;
    var phi_679_: u32;

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
                phi_225_ = (_e148 == _e150);
                phi_226_ = false;
            } else {
                phi_225_ = bool();
                phi_226_ = true;
            }
            let _e153 = phi_225_;
            let _e155 = phi_226_;
            phi_227_ = _e153;
            phi_228_ = _e155;
        } else {
            phi_227_ = bool();
            phi_228_ = true;
        }
        let _e157 = phi_227_;
        let _e159 = phi_228_;
        if _e159 {
            phi_232_ = false;
        } else {
            phi_232_ = _e157;
        }
        let _e161 = phi_232_;
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
                phi_286_ = (_e201 * _e79);
            } else {
                phi_286_ = 0f;
            }
            let _e210 = phi_286_;
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
                    phi_412_ = _e328;
                } else {
                    phi_412_ = 1f;
                }
                let _e334 = phi_412_;
                phi_413_ = _e334;
            } else {
                phi_413_ = 0f;
            }
            let _e336 = phi_413_;
            let _e339 = sqrt(sqrt(_e336));
            let _e347 = ((((0.6620027f * sqrt(_e336)) + (0.6841221f * _e339)) - (0.3235836f * sqrt(_e339))) - (0.022541147f * _e336));
            if (_e347 > 0f) {
                if (_e347 < 1f) {
                    phi_433_ = _e347;
                } else {
                    phi_433_ = 1f;
                }
                let _e351 = phi_433_;
                phi_434_ = _e351;
            } else {
                phi_434_ = 0f;
            }
            let _e353 = phi_434_;
            if (_e329 > 0f) {
                if (_e329 < 1f) {
                    phi_443_ = _e329;
                } else {
                    phi_443_ = 1f;
                }
                let _e357 = phi_443_;
                phi_444_ = _e357;
            } else {
                phi_444_ = 0f;
            }
            let _e359 = phi_444_;
            let _e362 = sqrt(sqrt(_e359));
            let _e370 = ((((0.6620027f * sqrt(_e359)) + (0.6841221f * _e362)) - (0.3235836f * sqrt(_e362))) - (0.022541147f * _e359));
            if (_e370 > 0f) {
                if (_e370 < 1f) {
                    phi_464_ = _e370;
                } else {
                    phi_464_ = 1f;
                }
                let _e374 = phi_464_;
                phi_465_ = _e374;
            } else {
                phi_465_ = 0f;
            }
            let _e376 = phi_465_;
            if (_e330 > 0f) {
                if (_e330 < 1f) {
                    phi_474_ = _e330;
                } else {
                    phi_474_ = 1f;
                }
                let _e380 = phi_474_;
                phi_475_ = _e380;
            } else {
                phi_475_ = 0f;
            }
            let _e382 = phi_475_;
            let _e385 = sqrt(sqrt(_e382));
            let _e393 = ((((0.6620027f * sqrt(_e382)) + (0.6841221f * _e385)) - (0.3235836f * sqrt(_e385))) - (0.022541147f * _e382));
            if (_e393 > 0f) {
                if (_e393 < 1f) {
                    phi_495_ = _e393;
                } else {
                    phi_495_ = 1f;
                }
                let _e397 = phi_495_;
                phi_496_ = _e397;
            } else {
                phi_496_ = 0f;
            }
            let _e399 = phi_496_;
            let _e401 = ((_e353 * 255f) + 0.5f);
            let _e410 = ((_e376 * 255f) + 0.5f);
            let _e422 = ((_e399 * 255f) + 0.5f);
            phi_679_ = (((select(select(u32(_e401), 0u, (_e401 < bitcast<f32>(0u))), 4294967295u, (_e401 > bitcast<f32>(1333788671u))) | (select(select(u32(_e410), 0u, (_e410 < bitcast<f32>(0u))), 4294967295u, (_e410 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e422), 0u, (_e422 < bitcast<f32>(0u))), 4294967295u, (_e422 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e134 > 0f) {
                phi_533_ = _e134;
            } else {
                phi_533_ = 0f;
            }
            let _e436 = phi_533_;
            let _e440 = (1f - ((1f - _e436) * (1f - _e436)));
            let _e441 = (1f - _e440);
            let _e454 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e441) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e440));
            let _e455 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e441) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e440));
            let _e456 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e441) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e440));
            if (_e454 > 0f) {
                if (_e454 < 1f) {
                    phi_562_ = _e454;
                } else {
                    phi_562_ = 1f;
                }
                let _e460 = phi_562_;
                phi_563_ = _e460;
            } else {
                phi_563_ = 0f;
            }
            let _e462 = phi_563_;
            let _e465 = sqrt(sqrt(_e462));
            let _e473 = ((((0.6620027f * sqrt(_e462)) + (0.6841221f * _e465)) - (0.3235836f * sqrt(_e465))) - (0.022541147f * _e462));
            if (_e473 > 0f) {
                if (_e473 < 1f) {
                    phi_583_ = _e473;
                } else {
                    phi_583_ = 1f;
                }
                let _e477 = phi_583_;
                phi_584_ = _e477;
            } else {
                phi_584_ = 0f;
            }
            let _e479 = phi_584_;
            if (_e455 > 0f) {
                if (_e455 < 1f) {
                    phi_593_ = _e455;
                } else {
                    phi_593_ = 1f;
                }
                let _e483 = phi_593_;
                phi_594_ = _e483;
            } else {
                phi_594_ = 0f;
            }
            let _e485 = phi_594_;
            let _e488 = sqrt(sqrt(_e485));
            let _e496 = ((((0.6620027f * sqrt(_e485)) + (0.6841221f * _e488)) - (0.3235836f * sqrt(_e488))) - (0.022541147f * _e485));
            if (_e496 > 0f) {
                if (_e496 < 1f) {
                    phi_614_ = _e496;
                } else {
                    phi_614_ = 1f;
                }
                let _e500 = phi_614_;
                phi_615_ = _e500;
            } else {
                phi_615_ = 0f;
            }
            let _e502 = phi_615_;
            if (_e456 > 0f) {
                if (_e456 < 1f) {
                    phi_624_ = _e456;
                } else {
                    phi_624_ = 1f;
                }
                let _e506 = phi_624_;
                phi_625_ = _e506;
            } else {
                phi_625_ = 0f;
            }
            let _e508 = phi_625_;
            let _e511 = sqrt(sqrt(_e508));
            let _e519 = ((((0.6620027f * sqrt(_e508)) + (0.6841221f * _e511)) - (0.3235836f * sqrt(_e511))) - (0.022541147f * _e508));
            if (_e519 > 0f) {
                if (_e519 < 1f) {
                    phi_645_ = _e519;
                } else {
                    phi_645_ = 1f;
                }
                let _e523 = phi_645_;
                phi_646_ = _e523;
            } else {
                phi_646_ = 0f;
            }
            let _e525 = phi_646_;
            let _e527 = ((_e479 * 255f) + 0.5f);
            let _e536 = ((_e502 * 255f) + 0.5f);
            let _e548 = ((_e525 * 255f) + 0.5f);
            phi_679_ = (((select(select(u32(_e527), 0u, (_e527 < bitcast<f32>(0u))), 4294967295u, (_e527 > bitcast<f32>(1333788671u))) | (select(select(u32(_e536), 0u, (_e536 < bitcast<f32>(0u))), 4294967295u, (_e536 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e548), 0u, (_e548 < bitcast<f32>(0u))), 4294967295u, (_e548 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e561 = phi_679_;
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
