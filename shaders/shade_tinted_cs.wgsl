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

struct type_36 {
    member: array<vec4<f32>>,
}

struct abi_ShadeParams {
    camera: abi_CameraParams,
    light: abi_LightParams,
    light_color: vec4<f32>,
}

struct type_40 {
    member: abi_ShadeParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_40;
@group(0) @binding(2) 
var<storage> visibility: type_17;
@group(0) @binding(3) 
var<storage, read_write> picture: type_13;
@group(0) @binding(4) 
var<storage> tints: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_138_: lt_bvh_traverse_Tree;
    var phi_139_: bool;
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_146_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_138_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_139_ = false;
        } else {
            phi_138_ = lt_bvh_traverse_Tree();
            phi_139_ = true;
        }
        let _e63 = phi_138_;
        let _e65 = phi_139_;
        phi_140_ = _e63;
        phi_141_ = _e65;
    } else {
        phi_140_ = lt_bvh_traverse_Tree();
        phi_141_ = true;
    }
    let _e67 = phi_140_;
    let _e69 = phi_141_;
    if _e69 {
        phi_146_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_146_ = _e67;
    }
    let _e74 = phi_146_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn function_() {
    var phi_280_: bool;
    var phi_281_: bool;
    var phi_282_: bool;
    var phi_283_: bool;
    var phi_287_: bool;
    var phi_381_: f32;
    var phi_382_: f32;
    var phi_383_: f32;
    var phi_386_: f32;
    var phi_388_: f32;
    var phi_405_: vec3<f32>;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_552_: f32;
    var phi_553_: f32;
    var phi_562_: f32;
    var phi_563_: f32;
    var phi_583_: f32;
    var phi_584_: f32;
    var phi_593_: f32;
    var phi_594_: f32;
    var phi_614_: f32;
    var phi_615_: f32;
    var phi_652_: f32;
    var phi_681_: f32;
    var phi_682_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_733_: f32;
    var phi_734_: f32;
    var phi_743_: f32;
    var phi_744_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_798_: u32;

    let _e50 = id_1;
    let _e67 = p.member.camera.size[0u];
    let _e69 = p.member.camera.size[1u];
    let _e70 = lt_shaders_entry_pixel_index(_e50, _e67, _e69);
    if (bitcast<i32>(_e70.root) != 0i) {
        if (_e70.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        if (_e70.first_primitive < arrayLength((&tints.member))) {
        } else {
            return;
        }
        let _e83 = tints.member[(0u + _e70.first_primitive)];
        if (_e70.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        let _e90 = visibility.member[(0u + _e70.first_primitive)];
        let _e99 = p.member.camera.size[0u];
        let _e103 = ((((f32(_e50.x) + 0.5f) / f32(_e99)) * 2f) - 1f);
        let _e108 = p.member.camera.size[1u];
        let _e112 = (1f - (((f32(_e50.y) + 0.5f) / f32(_e108)) * 2f));
        let _e114 = p.member.camera.forward;
        let _e116 = p.member.camera.right;
        let _e130 = p.member.camera.up;
        let _e137 = ((_e114.x + (_e116.x * _e103)) + (_e130.x * _e112));
        let _e138 = ((_e114.y + (_e116.y * _e103)) + (_e130.y * _e112));
        let _e139 = ((_e114.z + (_e116.z * _e103)) + (_e130.z * _e112));
        let _e146 = (1f / sqrt((((_e137 * _e137) + (_e138 * _e138)) + (_e139 * _e139))));
        let _e148 = (_e138 * _e146);
        let _e152 = samples.member[(0u + _e70.first_primitive)].normal[0u];
        let _e154 = global[0u];
        if (_e152 == _e154) {
            let _e157 = samples.member[(0u + _e70.first_primitive)].normal[1u];
            let _e159 = global[1u];
            if (_e157 == _e159) {
                let _e162 = samples.member[(0u + _e70.first_primitive)].normal[2u];
                let _e164 = global[2u];
                phi_280_ = (_e162 == _e164);
                phi_281_ = false;
            } else {
                phi_280_ = bool();
                phi_281_ = true;
            }
            let _e167 = phi_280_;
            let _e169 = phi_281_;
            phi_282_ = _e167;
            phi_283_ = _e169;
        } else {
            phi_282_ = bool();
            phi_283_ = true;
        }
        let _e171 = phi_282_;
        let _e173 = phi_283_;
        if _e173 {
            phi_287_ = false;
        } else {
            phi_287_ = _e171;
        }
        let _e175 = phi_287_;
        if !(_e175) {
            let _e178 = samples.member[(0u + _e70.first_primitive)].shading_normal;
            let _e180 = samples.member[(0u + _e70.first_primitive)].position;
            let _e183 = p.member.light.place;
            let _e189 = p.member.light.place[3u];
            let _e196 = (_e183.x - (_e180.x * _e189));
            let _e197 = (_e183.y - (_e180.y * _e189));
            let _e198 = (_e183.z - (_e180.z * _e189));
            let _e205 = (1f / sqrt((((_e196 * _e196) + (_e197 * _e197)) + (_e198 * _e198))));
            let _e216 = (((_e178.x * (_e196 * _e205)) + (_e178.y * (_e197 * _e205))) + (_e178.z * (_e198 * _e205)));
            if (_e216 > 0f) {
                let _e221 = p.member.light.place[3u];
                if (_e221 == 0f) {
                    phi_386_ = 1f;
                } else {
                    let _e227 = (((_e196 * _e196) + (_e197 * _e197)) + (_e198 * _e198));
                    let _e229 = p.member.light.axis;
                    let _e242 = p.member.light.cos_inner;
                    let _e244 = p.member.light.cos_outer;
                    let _e245 = (_e242 - _e244);
                    if (_e245 > 0f) {
                        let _e248 = p.member.light.cos_outer;
                        let _e250 = (((-((((_e196 * _e229.x) + (_e197 * _e229.y)) + (_e198 * _e229.z))) / sqrt(_e227)) - _e248) / _e245);
                        if (_e250 > 0f) {
                            if (_e250 < 1f) {
                                phi_381_ = _e250;
                            } else {
                                phi_381_ = 1f;
                            }
                            let _e254 = phi_381_;
                            phi_382_ = _e254;
                        } else {
                            phi_382_ = 0f;
                        }
                        let _e256 = phi_382_;
                        phi_383_ = _e256;
                    } else {
                        phi_383_ = 1f;
                    }
                    let _e258 = phi_383_;
                    phi_386_ = ((_e258 * _e258) / _e227);
                }
                let _e262 = phi_386_;
                phi_388_ = (_e216 * _e262);
            } else {
                phi_388_ = 0f;
            }
            let _e265 = phi_388_;
            if (_e265 > 0f) {
                let _e268 = p.member.light_color;
                phi_405_ = vec3<f32>((_e268.x * ((_e83.x * _e90) * _e265)), (_e268.y * ((_e83.y * _e90) * _e265)), (_e268.z * ((_e83.z * _e90) * _e265)));
            } else {
                phi_405_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e280 = phi_405_;
            let _e283 = (0.5f + (0.5f * _e178.y));
            let _e284 = (1f - 0.4f);
            let _e303 = (1f - _e283);
            let _e329 = (0.8f + (0.2f * abs((((_e178.x * -((_e137 * _e146))) + (_e178.y * -(_e148))) + (_e178.z * -((_e139 * _e146)))))));
            let _e331 = samples.member[(0u + _e70.first_primitive)].albedo;
            let _e342 = (1f / 255f);
            let _e343 = (f32((_e331 & 255u)) * _e342);
            let _e344 = (f32(((_e331 >> bitcast<u32>(8i)) & 255u)) * _e342);
            let _e345 = (f32(((_e331 >> bitcast<u32>(16i)) & 255u)) * _e342);
            let _e362 = samples.member[(0u + _e70.first_primitive)].position;
            let _e365 = p.member.camera.eye;
            let _e368 = (_e362.x - _e365.x);
            let _e371 = (_e362.y - _e365.y);
            let _e374 = (_e362.z - _e365.z);
            let _e383 = p.member.light_color[3u];
            let _e387 = (1f - (1f / (1f + (sqrt((((_e368 * _e368) + (_e371 * _e371)) + (_e374 * _e374))) * _e383))));
            let _e388 = (1f - _e387);
            let _e398 = ((((_e343 * _e343) * (_e280.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e284) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e283) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e303)) * 0.42f) * _e329))) * _e388) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e387));
            let _e399 = ((((_e344 * _e344) * (_e280.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e284) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e283) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e303)) * 0.42f) * _e329))) * _e388) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e387));
            let _e400 = ((((_e345 * _e345) * (_e280.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e284) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e283) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e303)) * 0.42f) * _e329))) * _e388) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e387));
            if (_e398 > 0f) {
                if (_e398 < 1f) {
                    phi_531_ = _e398;
                } else {
                    phi_531_ = 1f;
                }
                let _e404 = phi_531_;
                phi_532_ = _e404;
            } else {
                phi_532_ = 0f;
            }
            let _e406 = phi_532_;
            let _e409 = sqrt(sqrt(_e406));
            let _e417 = ((((0.6620027f * sqrt(_e406)) + (0.6841221f * _e409)) - (0.3235836f * sqrt(_e409))) - (0.022541147f * _e406));
            if (_e417 > 0f) {
                if (_e417 < 1f) {
                    phi_552_ = _e417;
                } else {
                    phi_552_ = 1f;
                }
                let _e421 = phi_552_;
                phi_553_ = _e421;
            } else {
                phi_553_ = 0f;
            }
            let _e423 = phi_553_;
            if (_e399 > 0f) {
                if (_e399 < 1f) {
                    phi_562_ = _e399;
                } else {
                    phi_562_ = 1f;
                }
                let _e427 = phi_562_;
                phi_563_ = _e427;
            } else {
                phi_563_ = 0f;
            }
            let _e429 = phi_563_;
            let _e432 = sqrt(sqrt(_e429));
            let _e440 = ((((0.6620027f * sqrt(_e429)) + (0.6841221f * _e432)) - (0.3235836f * sqrt(_e432))) - (0.022541147f * _e429));
            if (_e440 > 0f) {
                if (_e440 < 1f) {
                    phi_583_ = _e440;
                } else {
                    phi_583_ = 1f;
                }
                let _e444 = phi_583_;
                phi_584_ = _e444;
            } else {
                phi_584_ = 0f;
            }
            let _e446 = phi_584_;
            if (_e400 > 0f) {
                if (_e400 < 1f) {
                    phi_593_ = _e400;
                } else {
                    phi_593_ = 1f;
                }
                let _e450 = phi_593_;
                phi_594_ = _e450;
            } else {
                phi_594_ = 0f;
            }
            let _e452 = phi_594_;
            let _e455 = sqrt(sqrt(_e452));
            let _e463 = ((((0.6620027f * sqrt(_e452)) + (0.6841221f * _e455)) - (0.3235836f * sqrt(_e455))) - (0.022541147f * _e452));
            if (_e463 > 0f) {
                if (_e463 < 1f) {
                    phi_614_ = _e463;
                } else {
                    phi_614_ = 1f;
                }
                let _e467 = phi_614_;
                phi_615_ = _e467;
            } else {
                phi_615_ = 0f;
            }
            let _e469 = phi_615_;
            let _e471 = ((_e423 * 255f) + 0.5f);
            let _e480 = ((_e446 * 255f) + 0.5f);
            let _e492 = ((_e469 * 255f) + 0.5f);
            phi_798_ = (((select(select(u32(_e471), 0u, (_e471 < bitcast<f32>(0u))), 4294967295u, (_e471 > bitcast<f32>(1333788671u))) | (select(select(u32(_e480), 0u, (_e480 < bitcast<f32>(0u))), 4294967295u, (_e480 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e492), 0u, (_e492 < bitcast<f32>(0u))), 4294967295u, (_e492 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e148 > 0f) {
                phi_652_ = _e148;
            } else {
                phi_652_ = 0f;
            }
            let _e506 = phi_652_;
            let _e510 = (1f - ((1f - _e506) * (1f - _e506)));
            let _e511 = (1f - _e510);
            let _e524 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e511) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e510));
            let _e525 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e511) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e510));
            let _e526 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e511) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e510));
            if (_e524 > 0f) {
                if (_e524 < 1f) {
                    phi_681_ = _e524;
                } else {
                    phi_681_ = 1f;
                }
                let _e530 = phi_681_;
                phi_682_ = _e530;
            } else {
                phi_682_ = 0f;
            }
            let _e532 = phi_682_;
            let _e535 = sqrt(sqrt(_e532));
            let _e543 = ((((0.6620027f * sqrt(_e532)) + (0.6841221f * _e535)) - (0.3235836f * sqrt(_e535))) - (0.022541147f * _e532));
            if (_e543 > 0f) {
                if (_e543 < 1f) {
                    phi_702_ = _e543;
                } else {
                    phi_702_ = 1f;
                }
                let _e547 = phi_702_;
                phi_703_ = _e547;
            } else {
                phi_703_ = 0f;
            }
            let _e549 = phi_703_;
            if (_e525 > 0f) {
                if (_e525 < 1f) {
                    phi_712_ = _e525;
                } else {
                    phi_712_ = 1f;
                }
                let _e553 = phi_712_;
                phi_713_ = _e553;
            } else {
                phi_713_ = 0f;
            }
            let _e555 = phi_713_;
            let _e558 = sqrt(sqrt(_e555));
            let _e566 = ((((0.6620027f * sqrt(_e555)) + (0.6841221f * _e558)) - (0.3235836f * sqrt(_e558))) - (0.022541147f * _e555));
            if (_e566 > 0f) {
                if (_e566 < 1f) {
                    phi_733_ = _e566;
                } else {
                    phi_733_ = 1f;
                }
                let _e570 = phi_733_;
                phi_734_ = _e570;
            } else {
                phi_734_ = 0f;
            }
            let _e572 = phi_734_;
            if (_e526 > 0f) {
                if (_e526 < 1f) {
                    phi_743_ = _e526;
                } else {
                    phi_743_ = 1f;
                }
                let _e576 = phi_743_;
                phi_744_ = _e576;
            } else {
                phi_744_ = 0f;
            }
            let _e578 = phi_744_;
            let _e581 = sqrt(sqrt(_e578));
            let _e589 = ((((0.6620027f * sqrt(_e578)) + (0.6841221f * _e581)) - (0.3235836f * sqrt(_e581))) - (0.022541147f * _e578));
            if (_e589 > 0f) {
                if (_e589 < 1f) {
                    phi_764_ = _e589;
                } else {
                    phi_764_ = 1f;
                }
                let _e593 = phi_764_;
                phi_765_ = _e593;
            } else {
                phi_765_ = 0f;
            }
            let _e595 = phi_765_;
            let _e597 = ((_e549 * 255f) + 0.5f);
            let _e606 = ((_e572 * 255f) + 0.5f);
            let _e618 = ((_e595 * 255f) + 0.5f);
            phi_798_ = (((select(select(u32(_e597), 0u, (_e597 < bitcast<f32>(0u))), 4294967295u, (_e597 > bitcast<f32>(1333788671u))) | (select(select(u32(_e606), 0u, (_e606 < bitcast<f32>(0u))), 4294967295u, (_e606 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e618), 0u, (_e618 < bitcast<f32>(0u))), 4294967295u, (_e618 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e631 = phi_798_;
        if (_e70.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e70.first_primitive)] = _e631;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_tinted_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
