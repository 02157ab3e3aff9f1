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
    var phi_323_: vec3<f32>;
    var phi_449_: f32;
    var phi_450_: f32;
    var phi_470_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_481_: f32;
    var phi_501_: f32;
    var phi_502_: f32;
    var phi_511_: f32;
    var phi_512_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_570_: f32;
    var phi_599_: f32;
    var phi_600_: f32;
    var phi_620_: f32;
    var phi_621_: f32;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_661_: f32;
    var phi_662_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_716_: u32;

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
            if (_e201 > 0f) {
                let _e204 = p.member.light_color;
                phi_323_ = vec3<f32>((_e204.x * (_e79 * _e201)), (_e204.y * (_e79 * _e201)), (_e204.z * (_e79 * _e201)));
            } else {
                phi_323_ = vec3<f32>(0f, 0f, 0f);
            }
            let _e216 = phi_323_;
            let _e219 = (0.5f + (0.5f * _e164.y));
            let _e220 = (1f - 0.4f);
            let _e239 = (1f - _e219);
            let _e265 = (0.8f + (0.2f * abs((((_e164.x * -((_e123 * _e132))) + (_e164.y * -(_e134))) + (_e164.z * -((_e125 * _e132)))))));
            let _e267 = samples.member[(0u + _e66.first_primitive)].albedo;
            let _e278 = (1f / 255f);
            let _e279 = (f32((_e267 & 255u)) * _e278);
            let _e280 = (f32(((_e267 >> bitcast<u32>(8i)) & 255u)) * _e278);
            let _e281 = (f32(((_e267 >> bitcast<u32>(16i)) & 255u)) * _e278);
            let _e298 = samples.member[(0u + _e66.first_primitive)].position;
            let _e301 = p.member.camera.eye;
            let _e304 = (_e298.x - _e301.x);
            let _e307 = (_e298.y - _e301.y);
            let _e310 = (_e298.z - _e301.z);
            let _e319 = p.member.light_color[3u];
            let _e323 = (1f - (1f / (1f + (sqrt((((_e304 * _e304) + (_e307 * _e307)) + (_e310 * _e310))) * _e319))));
            let _e324 = (1f - _e323);
            let _e334 = ((((_e279 * _e279) * (_e216.x + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e220) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * 0.4f)) * _e219) + (vec3<f32>(0.16f, 0.14f, 0.12f).x * _e239)) * 0.42f) * _e265))) * _e324) + (vec3<f32>(0.72f, 0.8f, 0.9f).x * _e323));
            let _e335 = ((((_e280 * _e280) * (_e216.y + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e220) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * 0.4f)) * _e219) + (vec3<f32>(0.16f, 0.14f, 0.12f).y * _e239)) * 0.42f) * _e265))) * _e324) + (vec3<f32>(0.72f, 0.8f, 0.9f).y * _e323));
            let _e336 = ((((_e281 * _e281) * (_e216.z + ((((((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e220) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * 0.4f)) * _e219) + (vec3<f32>(0.16f, 0.14f, 0.12f).z * _e239)) * 0.42f) * _e265))) * _e324) + (vec3<f32>(0.72f, 0.8f, 0.9f).z * _e323));
            if (_e334 > 0f) {
                if (_e334 < 1f) {
                    phi_449_ = _e334;
                } else {
                    phi_449_ = 1f;
                }
                let _e340 = phi_449_;
                phi_450_ = _e340;
            } else {
                phi_450_ = 0f;
            }
            let _e342 = phi_450_;
            let _e345 = sqrt(sqrt(_e342));
            let _e353 = ((((0.6620027f * sqrt(_e342)) + (0.6841221f * _e345)) - (0.3235836f * sqrt(_e345))) - (0.022541147f * _e342));
            if (_e353 > 0f) {
                if (_e353 < 1f) {
                    phi_470_ = _e353;
                } else {
                    phi_470_ = 1f;
                }
                let _e357 = phi_470_;
                phi_471_ = _e357;
            } else {
                phi_471_ = 0f;
            }
            let _e359 = phi_471_;
            if (_e335 > 0f) {
                if (_e335 < 1f) {
                    phi_480_ = _e335;
                } else {
                    phi_480_ = 1f;
                }
                let _e363 = phi_480_;
                phi_481_ = _e363;
            } else {
                phi_481_ = 0f;
            }
            let _e365 = phi_481_;
            let _e368 = sqrt(sqrt(_e365));
            let _e376 = ((((0.6620027f * sqrt(_e365)) + (0.6841221f * _e368)) - (0.3235836f * sqrt(_e368))) - (0.022541147f * _e365));
            if (_e376 > 0f) {
                if (_e376 < 1f) {
                    phi_501_ = _e376;
                } else {
                    phi_501_ = 1f;
                }
                let _e380 = phi_501_;
                phi_502_ = _e380;
            } else {
                phi_502_ = 0f;
            }
            let _e382 = phi_502_;
            if (_e336 > 0f) {
                if (_e336 < 1f) {
                    phi_511_ = _e336;
                } else {
                    phi_511_ = 1f;
                }
                let _e386 = phi_511_;
                phi_512_ = _e386;
            } else {
                phi_512_ = 0f;
            }
            let _e388 = phi_512_;
            let _e391 = sqrt(sqrt(_e388));
            let _e399 = ((((0.6620027f * sqrt(_e388)) + (0.6841221f * _e391)) - (0.3235836f * sqrt(_e391))) - (0.022541147f * _e388));
            if (_e399 > 0f) {
                if (_e399 < 1f) {
                    phi_532_ = _e399;
                } else {
                    phi_532_ = 1f;
                }
                let _e403 = phi_532_;
                phi_533_ = _e403;
            } else {
                phi_533_ = 0f;
            }
            let _e405 = phi_533_;
            let _e407 = ((_e359 * 255f) + 0.5f);
            let _e416 = ((_e382 * 255f) + 0.5f);
            let _e428 = ((_e405 * 255f) + 0.5f);
            phi_716_ = (((select(select(u32(_e407), 0u, (_e407 < bitcast<f32>(0u))), 4294967295u, (_e407 > bitcast<f32>(1333788671u))) | (select(select(u32(_e416), 0u, (_e416 < bitcast<f32>(0u))), 4294967295u, (_e416 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e428), 0u, (_e428 < bitcast<f32>(0u))), 4294967295u, (_e428 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        } else {
            if (_e134 > 0f) {
                phi_570_ = _e134;
            } else {
                phi_570_ = 0f;
            }
            let _e442 = phi_570_;
            let _e446 = (1f - ((1f - _e442) * (1f - _e442)));
            let _e447 = (1f - _e446);
            let _e460 = ((vec3<f32>(0.72f, 0.8f, 0.9f).x * _e447) + (vec3<f32>(0.22f, 0.42f, 0.78f).x * _e446));
            let _e461 = ((vec3<f32>(0.72f, 0.8f, 0.9f).y * _e447) + (vec3<f32>(0.22f, 0.42f, 0.78f).y * _e446));
            let _e462 = ((vec3<f32>(0.72f, 0.8f, 0.9f).z * _e447) + (vec3<f32>(0.22f, 0.42f, 0.78f).z * _e446));
            if (_e460 > 0f) {
                if (_e460 < 1f) {
                    phi_599_ = _e460;
                } else {
                    phi_599_ = 1f;
                }
                let _e466 = phi_599_;
                phi_600_ = _e466;
            } else {
                phi_600_ = 0f;
            }
            let _e468 = phi_600_;
            let _e471 = sqrt(sqrt(_e468));
            let _e479 = ((((0.6620027f * sqrt(_e468)) + (0.6841221f * _e471)) - (0.3235836f * sqrt(_e471))) - (0.022541147f * _e468));
            if (_e479 > 0f) {
                if (_e479 < 1f) {
                    phi_620_ = _e479;
                } else {
                    phi_620_ = 1f;
                }
                let _e483 = phi_620_;
                phi_621_ = _e483;
            } else {
                phi_621_ = 0f;
            }
            let _e485 = phi_621_;
            if (_e461 > 0f) {
                if (_e461 < 1f) {
                    phi_630_ = _e461;
                } else {
                    phi_630_ = 1f;
                }
                let _e489 = phi_630_;
                phi_631_ = _e489;
            } else {
                phi_631_ = 0f;
            }
            let _e491 = phi_631_;
            let _e494 = sqrt(sqrt(_e491));
            let _e502 = ((((0.6620027f * sqrt(_e491)) + (0.6841221f * _e494)) - (0.3235836f * sqrt(_e494))) - (0.022541147f * _e491));
            if (_e502 > 0f) {
                if (_e502 < 1f) {
                    phi_651_ = _e502;
                } else {
                    phi_651_ = 1f;
                }
                let _e506 = phi_651_;
                phi_652_ = _e506;
            } else {
                phi_652_ = 0f;
            }
            let _e508 = phi_652_;
            if (_e462 > 0f) {
                if (_e462 < 1f) {
                    phi_661_ = _e462;
                } else {
                    phi_661_ = 1f;
                }
                let _e512 = phi_661_;
                phi_662_ = _e512;
            } else {
                phi_662_ = 0f;
            }
            let _e514 = phi_662_;
            let _e517 = sqrt(sqrt(_e514));
            let _e525 = ((((0.6620027f * sqrt(_e514)) + (0.6841221f * _e517)) - (0.3235836f * sqrt(_e517))) - (0.022541147f * _e514));
            if (_e525 > 0f) {
                if (_e525 < 1f) {
                    phi_682_ = _e525;
                } else {
                    phi_682_ = 1f;
                }
                let _e529 = phi_682_;
                phi_683_ = _e529;
            } else {
                phi_683_ = 0f;
            }
            let _e531 = phi_683_;
            let _e533 = ((_e485 * 255f) + 0.5f);
            let _e542 = ((_e508 * 255f) + 0.5f);
            let _e554 = ((_e531 * 255f) + 0.5f);
            phi_716_ = (((select(select(u32(_e533), 0u, (_e533 < bitcast<f32>(0u))), 4294967295u, (_e533 > bitcast<f32>(1333788671u))) | (select(select(u32(_e542), 0u, (_e542 < bitcast<f32>(0u))), 4294967295u, (_e542 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e554), 0u, (_e554 < bitcast<f32>(0u))), 4294967295u, (_e554 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))) | 4278190080u);
        }
        let _e567 = phi_716_;
        if (_e66.first_primitive < arrayLength((&picture.member))) {
        } else {
            return;
        }
        picture.member[(0u + _e66.first_primitive)] = _e567;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_shade_shade_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
