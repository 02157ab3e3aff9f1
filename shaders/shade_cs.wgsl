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

struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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
    light: abi_LightParams,
    light_color: vec4<f32>,
}

struct type_35 {
    member: abi_ShadeParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> visibility: type_17;
@group(0) @binding(3) 
var<storage, read_write> picture: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_132_: lt_bvh_traverse_Tree;
    var phi_133_: bool;
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_140_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_132_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_133_ = false;
        } else {
            phi_132_ = lt_bvh_traverse_Tree();
            phi_133_ = true;
        }
        let _e62 = phi_132_;
        let _e64 = phi_133_;
        phi_134_ = _e62;
        phi_135_ = _e64;
    } else {
        phi_134_ = lt_bvh_traverse_Tree();
        phi_135_ = true;
    }
    let _e66 = phi_134_;
    let _e68 = phi_135_;
    if _e68 {
        phi_140_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_140_ = _e66;
    }
    let _e73 = phi_140_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn function_() {
    var phi_259_: bool;
    var phi_260_: bool;
    var phi_261_: bool;
    var phi_262_: bool;
    var phi_266_: bool;
    var phi_360_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_365_: f32;
    var phi_367_: f32;
    var phi_384_: vec3<f32>;
    var phi_510_: f32;
    var phi_511_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_541_: f32;
    var phi_542_: f32;
    var phi_562_: f32;
    var phi_563_: f32;
    var phi_572_: f32;
    var phi_573_: f32;
    var phi_593_: f32;
    var phi_594_: f32;
    var phi_631_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_691_: f32;
    var phi_692_: f32;
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_722_: f32;
    var phi_723_: f32;
    var phi_743_: f32;
    var phi_744_: f32;
    var phi_777_: u32;

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
                phi_259_ = (_e148 == _e150);
                phi_260_ = false;
            } else {
                phi_259_ = bool();
                phi_260_ = true;
            }
            let _e153 = phi_259_;
            let _e155 = phi_260_;
            phi_261_ = _e153;
            phi_262_ = _e155;
        } else {
            phi_261_ = bool();
            phi_262_ = true;
        }
        let _e157 = phi_261_;
        let _e159 = phi_262_;
        if _e159 {
            phi_266_ = false;
        } else {
            phi_266_ = _e157;
        }
        let _e161 = phi_266_;
        if !(_e161) {
            let _e164 = samples.member[(0u + _e66.first_primitive)].shading_normal;
            let _e166 = samples.member[(0u + _e66.first_primitive)].position;
            let _e169 = p.member.light.place;
            let _e175 = p.member.light.place[3u];
            let _e182 = (_e169.x - (_e166.x * _e175));
            let _e183 = (_e169.y - (_e166.y * _e175));
            let _e184 = (_e169.z - (_e166.z * _e175));
            let _e191 = (1f / sqrt((((_e182 * _e182) + (_e183 * _e183)) + (_e184 * _e184))));
            let _e202 = (((_e164.x * (_e182 * _e191)) + (_e164.y * (_e183 * _e191))) + (_e164.z * (_e184 * _e191)));
            if (_e202 > 0f) {
                let _e207 = p.member.light.place[3u];
                if (_e207 == 0f) {
                    phi_365_ = 1f;
                } else {
                    let _e213 = (((_e182 * _e182) + (_e183 * _e183)) + (_e184 * _e184));
                    let _e215 = p.member.light.axis;
                    let _e228 = p.member.light.cos_inner;
                    let _e230 = p.member.light.cos_outer;
                    let _e231 = (_e228 - _e230);
                    if (_e231 > 0f) {
                        let _e234 = p.member.light.cos_outer;
                        let _e236 = (((-((((_e182 * _e215.x) + (_e183 * _e215.y)) + (_e184 * _e215.z))) / sqrt(_e213)) - _e234) / _e231);
                        if (_e236 > 0f) {
                            if (_e236 < 1f) {
                                phi_360_ = _e236;
                            } else {
                                phi_360_ = 1f;
                            }
                            let _e240 = phi_360_;
                            phi_361_ = _e240;
                        } else {
                            phi_361_ = 0f;
                        }
                        let _e242 = phi_361_;
                        phi_362_ = _e242;
                    } else {
                        phi_362_ = 1f;
                    }
                    let _e244 = phi_362_;
                    phi_365_ = ((_e244 * _e244) / _e213);
                }
                let _e248 = phi_365_;
                phi_367_ = (_e202 * _e248);
            } else {
                phi_367_ = 0f;
            }
            let _e251 = phi_367_;
            if (_e251 > 0f) {
                let _e254 = p.member.light_color;
                phi_384_ = vec3<f32>((_e254.x * (_e79 * _e251)), (_e254.y * (_e79 * _e251)), (_e254.z * (_e79 * _e251)));
            } else {
                phi_384_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e266 = phi_384_;
            let _e269 = (0.5f + (0.5f * _e164.y));
            let _e270 = (1f - 0.4f);
            let _e289 = (1f - _e269);
            let _e315 = (0.8f + (0.2f * abs((((_e164.x * -((_e123 * _e132))) + (_e164.y * -(_e134))) + (_e164.z * -((_e125 * _e132)))))));
            let _e317 = samples.member[(0u + _e66.first_primitive)].albedo;
            let _e328 = (1f / 255f);
            let _e329 = (f32((_e317 & 255u)) * _e328);
            let _e330 = (f32(((_e317 >> bitcast<u32>(8i)) & 255u)) * _e328);
            let _e331 = (f32(((_e317 >> bitcast<u32>(16i)) & 255u)) * _e328);
            let _e348 = samples.member[(0u + _e66.first_primitive)].position;
            let _e351 = p.member.camera.eye;
            let _e354 = (_e348.x - _e351.x);
            let _e357 = (_e348.y - _e351.y);
            let _e360 = (_e348.z - _e351.z);
            let _e369 = p.member.light_color[3u];
            let _e373 = (1f - (1f / (1f + (sqrt((((_e354 * _e354) + (_e357 * _e357)) + (_e360 * _e360))) * _e369))));
            let _e374 = (1f - _e373);
            let _e384 = ((((_e329 * _e329) * (_e266.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e270) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e269) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e289)) * 0.42f) * _e315))) * _e374) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e373));
            let _e385 = ((((_e330 * _e330) * (_e266.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e270) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e269) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e289)) * 0.42f) * _e315))) * _e374) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e373));
            let _e386 = ((((_e331 * _e331) * (_e266.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e270) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e269) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e289)) * 0.42f) * _e315))) * _e374) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e373));
            if (_e384 > 0f) {
                if (_e384 < 1f) {
                    phi_510_ = _e384;
                } else {
                    phi_510_ = 1f;
                }
                let _e390 = phi_510_;
                phi_511_ = _e390;
            } else {
                phi_511_ = 0f;
            }
            let _e392 = phi_511_;
            let _e395 = sqrt(sqrt(_e392));
            let _e403 = ((((0.6620027f * sqrt(_e392)) + (0.6841221f * _e395)) - (0.3235836f * sqrt(_e395))) - (0.022541147f * _e392));
            if (_e403 > 0f) {
                if (_e403 < 1f) {
                    phi_531_ = _e403;
                } else {
                    phi_531_ = 1f;
                }
                let _e407 = phi_531_;
                phi_532_ = _e407;
            } else {
                phi_532_ = 0f;
            }
            let _e409 = phi_532_;
            if (_e385 > 0f) {
                if (_e385 < 1f) {
                    phi_541_ = _e385;
                } else {
                    phi_541_ = 1f;
                }
                let _e413 = phi_541_;
                phi_542_ = _e413;
            } else {
                phi_542_ = 0f;
            }
            let _e415 = phi_542_;
            let _e418 = sqrt(sqrt(_e415));
            let _e426 = ((((0.6620027f * sqrt(_e415)) + (0.6841221f * _e418)) - (0.3235836f * sqrt(_e418))) - (0.022541147f * _e415));
            if (_e426 > 0f) {
                if (_e426 < 1f) {
                    phi_562_ = _e426;
                } else {
                    phi_562_ = 1f;
                }
                let _e430 = phi_562_;
                phi_563_ = _e430;
            } else {
                phi_563_ = 0f;
            }
            let _e432 = phi_563_;
            if (_e386 > 0f) {
                if (_e386 < 1f) {
                    phi_572_ = _e386;
                } else {
                    phi_572_ = 1f;
                }
                let _e436 = phi_572_;
                phi_573_ = _e436;
            } else {
                phi_573_ = 0f;
            }
            let _e438 = phi_573_;
            let _e441 = sqrt(sqrt(_e438));
            let _e449 = ((((0.6620027f * sqrt(_e438)) + (0.6841221f * _e441)) - (0.3235836f * sqrt(_e441))) - (0.022541147f * _e438));
            if (_e449 > 0f) {
                if (_e449 < 1f) {
                    phi_593_ = _e449;
                } else {
                    phi_593_ = 1f;
                }
                let _e453 = phi_593_;
                phi_594_ = _e453;
            } else {
                phi_594_ = 0f;
            }
            let _e455 = phi_594_;
            let _e457 = ((_e409 * 255f) + 0.5f);
            let _e466 = ((_e432 * 255f) + 0.5f);
            let _e478 = ((_e455 * 255f) + 0.5f);
            phi_777_ = (((select(select(u32(_e457), 0u, (_e457 < bitcast<f32>(0u))), 4294967295u, (_e457 > bitcast<f32>(1333788671u))) | (select(select(u32(_e466), 0u, (_e466 < bitcast<f32>(0u))), 4294967295u, (_e466 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e478), 0u, (_e478 < bitcast<f32>(0u))), 4294967295u, (_e478 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e134 > 0f) {
                phi_631_ = _e134;
            } else {
                phi_631_ = 0f;
            }
            let _e492 = phi_631_;
            let _e496 = (1f - ((1f - _e492) * (1f - _e492)));
            let _e497 = (1f - _e496);
            let _e510 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e497) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e496));
            let _e511 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e497) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e496));
            let _e512 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e497) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e496));
            if (_e510 > 0f) {
                if (_e510 < 1f) {
                    phi_660_ = _e510;
                } else {
                    phi_660_ = 1f;
                }
                let _e516 = phi_660_;
                phi_661_ = _e516;
            } else {
                phi_661_ = 0f;
            }
            let _e518 = phi_661_;
            let _e521 = sqrt(sqrt(_e518));
            let _e529 = ((((0.6620027f * sqrt(_e518)) + (0.6841221f * _e521)) - (0.3235836f * sqrt(_e521))) - (0.022541147f * _e518));
            if (_e529 > 0f) {
                if (_e529 < 1f) {
                    phi_681_ = _e529;
                } else {
                    phi_681_ = 1f;
                }
                let _e533 = phi_681_;
                phi_682_ = _e533;
            } else {
                phi_682_ = 0f;
            }
            let _e535 = phi_682_;
            if (_e511 > 0f) {
                if (_e511 < 1f) {
                    phi_691_ = _e511;
                } else {
                    phi_691_ = 1f;
                }
                let _e539 = phi_691_;
                phi_692_ = _e539;
            } else {
                phi_692_ = 0f;
            }
            let _e541 = phi_692_;
            let _e544 = sqrt(sqrt(_e541));
            let _e552 = ((((0.6620027f * sqrt(_e541)) + (0.6841221f * _e544)) - (0.3235836f * sqrt(_e544))) - (0.022541147f * _e541));
            if (_e552 > 0f) {
                if (_e552 < 1f) {
                    phi_712_ = _e552;
                } else {
                    phi_712_ = 1f;
                }
                let _e556 = phi_712_;
                phi_713_ = _e556;
            } else {
                phi_713_ = 0f;
            }
            let _e558 = phi_713_;
            if (_e512 > 0f) {
                if (_e512 < 1f) {
                    phi_722_ = _e512;
                } else {
                    phi_722_ = 1f;
                }
                let _e562 = phi_722_;
                phi_723_ = _e562;
            } else {
                phi_723_ = 0f;
            }
            let _e564 = phi_723_;
            let _e567 = sqrt(sqrt(_e564));
            let _e575 = ((((0.6620027f * sqrt(_e564)) + (0.6841221f * _e567)) - (0.3235836f * sqrt(_e567))) - (0.022541147f * _e564));
            if (_e575 > 0f) {
                if (_e575 < 1f) {
                    phi_743_ = _e575;
                } else {
                    phi_743_ = 1f;
                }
                let _e579 = phi_743_;
                phi_744_ = _e579;
            } else {
                phi_744_ = 0f;
            }
            let _e581 = phi_744_;
            let _e583 = ((_e535 * 255f) + 0.5f);
            let _e592 = ((_e558 * 255f) + 0.5f);
            let _e604 = ((_e581 * 255f) + 0.5f);
            phi_777_ = (((select(select(u32(_e583), 0u, (_e583 < bitcast<f32>(0u))), 4294967295u, (_e583 > bitcast<f32>(1333788671u))) | (select(select(u32(_e592), 0u, (_e592 < bitcast<f32>(0u))), 4294967295u, (_e592 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e604), 0u, (_e604 < bitcast<f32>(0u))), 4294967295u, (_e604 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e617 = phi_777_;
        if (_e66.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e66.first_primitive)] = _e617;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
