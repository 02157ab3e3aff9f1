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
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_366_: f32;
    var phi_368_: f32;
    var phi_499_: f32;
    var phi_500_: f32;
    var phi_520_: f32;
    var phi_521_: f32;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_551_: f32;
    var phi_552_: f32;
    var phi_561_: f32;
    var phi_562_: f32;
    var phi_582_: f32;
    var phi_583_: f32;
    var phi_620_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_680_: f32;
    var phi_681_: f32;
    var phi_701_: f32;
    var phi_702_: f32;
    var phi_711_: f32;
    var phi_712_: f32;
    var phi_732_: f32;
    var phi_733_: f32;
    var phi_766_: u32;

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
                let _e208 = p.member.light.place[3u];
                if (_e208 == 0f) {
                    phi_366_ = 1f;
                } else {
                    let _e214 = (((_e182 * _e182) + (_e183 * _e183)) + (_e184 * _e184));
                    let _e216 = p.member.light.axis;
                    let _e229 = p.member.light.cos_inner;
                    let _e231 = p.member.light.cos_outer;
                    let _e232 = (_e229 - _e231);
                    if (_e232 > 0f) {
                        let _e235 = p.member.light.cos_outer;
                        let _e237 = (((-((((_e182 * _e216.x) + (_e183 * _e216.y)) + (_e184 * _e216.z))) / sqrt(_e214)) - _e235) / _e232);
                        if (_e237 > 0f) {
                            if (_e237 < 1f) {
                                phi_361_ = _e237;
                            } else {
                                phi_361_ = 1f;
                            }
                            let _e241 = phi_361_;
                            phi_362_ = _e241;
                        } else {
                            phi_362_ = 0f;
                        }
                        let _e243 = phi_362_;
                        phi_363_ = _e243;
                    } else {
                        phi_363_ = 1f;
                    }
                    let _e245 = phi_363_;
                    phi_366_ = ((_e245 * _e245) / _e214);
                }
                let _e249 = phi_366_;
                phi_368_ = ((_e202 * _e79) * _e249);
            } else {
                phi_368_ = 0f;
            }
            let _e252 = phi_368_;
            let _e254 = p.member.light_color;
            let _e263 = (0.5f + (0.5f * _e164.y));
            let _e264 = (1f - 0.4f);
            let _e283 = (1f - _e263);
            let _e309 = (0.8f + (0.2f * abs((((_e164.x * -((_e123 * _e132))) + (_e164.y * -(_e134))) + (_e164.z * -((_e125 * _e132)))))));
            let _e311 = samples.member[(0u + _e66.first_primitive)].albedo;
            let _e322 = (1f / 255f);
            let _e323 = (f32((_e311 & 255u)) * _e322);
            let _e324 = (f32(((_e311 >> bitcast<u32>(8i)) & 255u)) * _e322);
            let _e325 = (f32(((_e311 >> bitcast<u32>(16i)) & 255u)) * _e322);
            let _e339 = samples.member[(0u + _e66.first_primitive)].position;
            let _e342 = p.member.camera.eye;
            let _e345 = (_e339.x - _e342.x);
            let _e348 = (_e339.y - _e342.y);
            let _e351 = (_e339.z - _e342.z);
            let _e360 = p.member.light_color[3u];
            let _e364 = (1f - (1f / (1f + (sqrt((((_e345 * _e345) + (_e348 * _e348)) + (_e351 * _e351))) * _e360))));
            let _e365 = (1f - _e364);
            let _e375 = ((((_e323 * _e323) * ((_e254.x * _e252) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e264) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e263) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e283)) * 0.42f) * _e309))) * _e365) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e364));
            let _e376 = ((((_e324 * _e324) * ((_e254.y * _e252) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e264) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e263) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e283)) * 0.42f) * _e309))) * _e365) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e364));
            let _e377 = ((((_e325 * _e325) * ((_e254.z * _e252) + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e264) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e263) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e283)) * 0.42f) * _e309))) * _e365) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e364));
            if (_e375 > 0f) {
                if (_e375 < 1f) {
                    phi_499_ = _e375;
                } else {
                    phi_499_ = 1f;
                }
                let _e381 = phi_499_;
                phi_500_ = _e381;
            } else {
                phi_500_ = 0f;
            }
            let _e383 = phi_500_;
            let _e386 = sqrt(sqrt(_e383));
            let _e394 = ((((0.6620027f * sqrt(_e383)) + (0.6841221f * _e386)) - (0.3235836f * sqrt(_e386))) - (0.022541147f * _e383));
            if (_e394 > 0f) {
                if (_e394 < 1f) {
                    phi_520_ = _e394;
                } else {
                    phi_520_ = 1f;
                }
                let _e398 = phi_520_;
                phi_521_ = _e398;
            } else {
                phi_521_ = 0f;
            }
            let _e400 = phi_521_;
            if (_e376 > 0f) {
                if (_e376 < 1f) {
                    phi_530_ = _e376;
                } else {
                    phi_530_ = 1f;
                }
                let _e404 = phi_530_;
                phi_531_ = _e404;
            } else {
                phi_531_ = 0f;
            }
            let _e406 = phi_531_;
            let _e409 = sqrt(sqrt(_e406));
            let _e417 = ((((0.6620027f * sqrt(_e406)) + (0.6841221f * _e409)) - (0.3235836f * sqrt(_e409))) - (0.022541147f * _e406));
            if (_e417 > 0f) {
                if (_e417 < 1f) {
                    phi_551_ = _e417;
                } else {
                    phi_551_ = 1f;
                }
                let _e421 = phi_551_;
                phi_552_ = _e421;
            } else {
                phi_552_ = 0f;
            }
            let _e423 = phi_552_;
            if (_e377 > 0f) {
                if (_e377 < 1f) {
                    phi_561_ = _e377;
                } else {
                    phi_561_ = 1f;
                }
                let _e427 = phi_561_;
                phi_562_ = _e427;
            } else {
                phi_562_ = 0f;
            }
            let _e429 = phi_562_;
            let _e432 = sqrt(sqrt(_e429));
            let _e440 = ((((0.6620027f * sqrt(_e429)) + (0.6841221f * _e432)) - (0.3235836f * sqrt(_e432))) - (0.022541147f * _e429));
            if (_e440 > 0f) {
                if (_e440 < 1f) {
                    phi_582_ = _e440;
                } else {
                    phi_582_ = 1f;
                }
                let _e444 = phi_582_;
                phi_583_ = _e444;
            } else {
                phi_583_ = 0f;
            }
            let _e446 = phi_583_;
            let _e448 = ((_e400 * 255f) + 0.5f);
            let _e457 = ((_e423 * 255f) + 0.5f);
            let _e469 = ((_e446 * 255f) + 0.5f);
            phi_766_ = (((select(select(u32(_e448), 0u, (_e448 < bitcast<f32>(0u))), 4294967295u, (_e448 > bitcast<f32>(1333788671u))) | (select(select(u32(_e457), 0u, (_e457 < bitcast<f32>(0u))), 4294967295u, (_e457 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e469), 0u, (_e469 < bitcast<f32>(0u))), 4294967295u, (_e469 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e134 > 0f) {
                phi_620_ = _e134;
            } else {
                phi_620_ = 0f;
            }
            let _e483 = phi_620_;
            let _e487 = (1f - ((1f - _e483) * (1f - _e483)));
            let _e488 = (1f - _e487);
            let _e501 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e488) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e487));
            let _e502 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e488) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e487));
            let _e503 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e488) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e487));
            if (_e501 > 0f) {
                if (_e501 < 1f) {
                    phi_649_ = _e501;
                } else {
                    phi_649_ = 1f;
                }
                let _e507 = phi_649_;
                phi_650_ = _e507;
            } else {
                phi_650_ = 0f;
            }
            let _e509 = phi_650_;
            let _e512 = sqrt(sqrt(_e509));
            let _e520 = ((((0.6620027f * sqrt(_e509)) + (0.6841221f * _e512)) - (0.3235836f * sqrt(_e512))) - (0.022541147f * _e509));
            if (_e520 > 0f) {
                if (_e520 < 1f) {
                    phi_670_ = _e520;
                } else {
                    phi_670_ = 1f;
                }
                let _e524 = phi_670_;
                phi_671_ = _e524;
            } else {
                phi_671_ = 0f;
            }
            let _e526 = phi_671_;
            if (_e502 > 0f) {
                if (_e502 < 1f) {
                    phi_680_ = _e502;
                } else {
                    phi_680_ = 1f;
                }
                let _e530 = phi_680_;
                phi_681_ = _e530;
            } else {
                phi_681_ = 0f;
            }
            let _e532 = phi_681_;
            let _e535 = sqrt(sqrt(_e532));
            let _e543 = ((((0.6620027f * sqrt(_e532)) + (0.6841221f * _e535)) - (0.3235836f * sqrt(_e535))) - (0.022541147f * _e532));
            if (_e543 > 0f) {
                if (_e543 < 1f) {
                    phi_701_ = _e543;
                } else {
                    phi_701_ = 1f;
                }
                let _e547 = phi_701_;
                phi_702_ = _e547;
            } else {
                phi_702_ = 0f;
            }
            let _e549 = phi_702_;
            if (_e503 > 0f) {
                if (_e503 < 1f) {
                    phi_711_ = _e503;
                } else {
                    phi_711_ = 1f;
                }
                let _e553 = phi_711_;
                phi_712_ = _e553;
            } else {
                phi_712_ = 0f;
            }
            let _e555 = phi_712_;
            let _e558 = sqrt(sqrt(_e555));
            let _e566 = ((((0.6620027f * sqrt(_e555)) + (0.6841221f * _e558)) - (0.3235836f * sqrt(_e558))) - (0.022541147f * _e555));
            if (_e566 > 0f) {
                if (_e566 < 1f) {
                    phi_732_ = _e566;
                } else {
                    phi_732_ = 1f;
                }
                let _e570 = phi_732_;
                phi_733_ = _e570;
            } else {
                phi_733_ = 0f;
            }
            let _e572 = phi_733_;
            let _e574 = ((_e526 * 255f) + 0.5f);
            let _e583 = ((_e549 * 255f) + 0.5f);
            let _e595 = ((_e572 * 255f) + 0.5f);
            phi_766_ = (((select(select(u32(_e574), 0u, (_e574 < bitcast<f32>(0u))), 4294967295u, (_e574 > bitcast<f32>(1333788671u))) | (select(select(u32(_e583), 0u, (_e583 < bitcast<f32>(0u))), 4294967295u, (_e583 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e595), 0u, (_e595 < bitcast<f32>(0u))), 4294967295u, (_e595 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e608 = phi_766_;
        if (_e66.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e66.first_primitive)] = _e608;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
