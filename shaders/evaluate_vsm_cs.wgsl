struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_29 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_121_: lt_bvh_traverse_Tree;
    var phi_122_: bool;
    var phi_123_: lt_bvh_traverse_Tree;
    var phi_124_: bool;
    var phi_129_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_121_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_122_ = false;
        } else {
            phi_121_ = lt_bvh_traverse_Tree();
            phi_122_ = true;
        }
        let _e45 = phi_121_;
        let _e47 = phi_122_;
        phi_123_ = _e45;
        phi_124_ = _e47;
    } else {
        phi_123_ = lt_bvh_traverse_Tree();
        phi_124_ = true;
    }
    let _e49 = phi_123_;
    let _e51 = phi_124_;
    if _e51 {
        phi_129_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_129_ = _e49;
    }
    let _e56 = phi_129_;
    return lt_bvh_traverse_Tree(_e56.root, _e56.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_591_: f32;
    var phi_592_: f32;
    var phi_593_: f32;
    var phi_609_: f32;
    var phi_610_: f32;
    var phi_611_: f32;
    var phi_627_: f32;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_645_: f32;
    var phi_646_: f32;
    var phi_647_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_711_: bool;
    var phi_715_: f32;
    var phi_727_: bool;
    var phi_734_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_751_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_593_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_592_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_591_ = 1f;
            } else {
                phi_591_ = param_7;
            }
            let _e42 = phi_591_;
            phi_592_ = _e42;
        }
        let _e44 = phi_592_;
        phi_593_ = _e44;
    }
    let _e46 = phi_593_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_611_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_610_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_609_ = 1f;
            } else {
                phi_609_ = param_5.x;
            }
            let _e54 = phi_609_;
            phi_610_ = _e54;
        }
        let _e56 = phi_610_;
        phi_611_ = _e56;
    }
    let _e58 = phi_611_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_629_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_628_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_627_ = 1f;
            } else {
                phi_627_ = param_5.y;
            }
            let _e66 = phi_627_;
            phi_628_ = _e66;
        }
        let _e68 = phi_628_;
        phi_629_ = _e68;
    }
    let _e70 = phi_629_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_647_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_646_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_645_ = 1f;
            } else {
                phi_645_ = param_5.z;
            }
            let _e78 = phi_645_;
            phi_646_ = _e78;
        }
        let _e80 = phi_646_;
        phi_647_ = _e80;
    }
    let _e82 = phi_647_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_665_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_664_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_663_ = 1f;
            } else {
                phi_663_ = param_5.w;
            }
            let _e90 = phi_663_;
            phi_664_ = _e90;
        }
        let _e92 = phi_664_;
        phi_665_ = _e92;
    }
    let _e94 = phi_665_;
    let _e95 = (_e58 - _e46);
    let _e96 = (_e70 - _e46);
    let _e97 = (_e82 - _e46);
    let _e98 = (_e94 - _e46);
    let _e99 = (*param_4);
    let _e110 = ((((_e95 * param_6.x) + (_e96 * param_6.y)) + (_e97 * param_6.z)) + (_e98 * param_6.w));
    let _e111 = (_e95 - _e110);
    let _e112 = (_e96 - _e110);
    let _e113 = (_e97 - _e110);
    let _e114 = (_e98 - _e110);
    let _e129 = (((((_e111 * _e111) * param_6.x) + ((_e112 * _e112) * param_6.y)) + ((_e113 * _e113) * param_6.z)) + ((_e114 * _e114) * param_6.w));
    if ((bitcast<u32>(_e99) & 2147483647u) > 2139095040u) {
        phi_711_ = true;
    } else {
        let _e133 = (_e99 > _e129);
        if _e133 {
        }
        phi_711_ = _e133;
    }
    let _e135 = phi_711_;
    if _e135 {
        phi_715_ = _e99;
    } else {
        phi_715_ = _e129;
    }
    let _e137 = phi_715_;
    let _e138 = -(_e110);
    if (_e138 <= 0f) {
        let _e142 = ((bitcast<u32>(_e137) & 2147483647u) > 2139095040u);
        if _e142 {
        }
        phi_727_ = _e142;
    } else {
        phi_727_ = true;
    }
    let _e144 = phi_727_;
    if _e144 {
        phi_734_ = (_e137 / (_e137 + (_e138 * _e138)));
    } else {
        phi_734_ = 1f;
    }
    let _e149 = phi_734_;
    if ((bitcast<u32>(_e149) & 2147483647u) > 2139095040u) {
        phi_751_ = _e149;
    } else {
        if (_e149 < 0f) {
            phi_750_ = 0f;
        } else {
            if (_e149 > 1f) {
                phi_749_ = 1f;
            } else {
                phi_749_ = _e149;
            }
            let _e156 = phi_749_;
            phi_750_ = _e156;
        }
        let _e158 = phi_750_;
        phi_751_ = _e158;
    }
    let _e160 = phi_751_;
    return _e160;
}

fn function_() {
    var local: f32;
    var phi_189_: bool;
    var phi_190_: bool;
    var phi_191_: bool;
    var phi_192_: bool;
    var phi_196_: bool;
    var phi_240_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_244_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_321_: bool;
    var phi_330_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_349_: bool;
    var phi_385_: f32;
    var phi_390_: f32;
    var phi_391_: bool;
    var phi_392_: f32;
    var phi_393_: bool;
    var phi_397_: f32;
    var phi_417_: f32;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_475_: i32;
    var phi_480_: i32;
    var phi_485_: i32;
    var phi_490_: i32;
    var phi_499_: i32;
    var phi_504_: i32;
    var phi_509_: i32;
    var phi_514_: i32;
    var phi_555_: evaluate_Verdict;
    var phi_556_: evaluate_Verdict;
    var phi_557_: bool;
    var phi_558_: evaluate_Verdict;
    var phi_559_: evaluate_Verdict;
    var phi_560_: bool;
    var phi_564_: evaluate_Verdict;

    let _e33 = id_1;
    let _e40 = arrayLength((&map.member));
    let _e46 = p.member.size[0u];
    let _e48 = p.member.size[1u];
    let _e49 = lt_shaders_entry_pixel_index(_e33, _e46, _e48);
    if (bitcast<i32>(_e49.root) != 0i) {
        if (_e49.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e58 = p.member.light;
        let _e61 = samples.member[(0u + _e49.first_primitive)].normal[0u];
        let _e63 = global[0u];
        if (_e61 == _e63) {
            let _e66 = samples.member[(0u + _e49.first_primitive)].normal[1u];
            let _e68 = global[1u];
            if (_e66 == _e68) {
                let _e71 = samples.member[(0u + _e49.first_primitive)].normal[2u];
                let _e73 = global[2u];
                phi_189_ = (_e71 == _e73);
                phi_190_ = false;
            } else {
                phi_189_ = bool();
                phi_190_ = true;
            }
            let _e76 = phi_189_;
            let _e78 = phi_190_;
            phi_191_ = _e76;
            phi_192_ = _e78;
        } else {
            phi_191_ = bool();
            phi_192_ = true;
        }
        let _e80 = phi_191_;
        let _e82 = phi_192_;
        if _e82 {
            phi_196_ = false;
        } else {
            phi_196_ = _e80;
        }
        let _e84 = phi_196_;
        if !(_e84) {
            let _e87 = samples.member[(0u + _e49.first_primitive)].normal;
            let _e89 = samples.member[(0u + _e49.first_primitive)].position;
            if ((((_e87.x * (_e58.x - (_e89.x * _e58.w))) + (_e87.y * (_e58.y - (_e89.y * _e58.w)))) + (_e87.z * (_e58.z - (_e89.z * _e58.w)))) > 0f) {
                let _e113 = samples.member[(0u + _e49.first_primitive)].flags;
                let _e121 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e121.unnamed.visibility, false), _e121.unnamed_1);
                phi_240_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e127.unnamed, ((_e113 & 1u) == 0u));
            } else {
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_240_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, true);
            }
            let _e147 = phi_240_;
            phi_244_ = _e147;
        } else {
            let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
            phi_244_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
        }
        let _e164 = phi_244_;
        if _e164.unnamed_1 {
            phi_558_ = evaluate_Verdict(_e164.unnamed.visibility, _e164.unnamed.is_doubted);
            phi_559_ = evaluate_Verdict();
            phi_560_ = true;
        } else {
            let _e172 = samples.member[(0u + _e49.first_primitive)].position;
            let _e178 = p.member.projection.row_w;
            let _e189 = ((((_e178.x * _e172.x) + (_e178.y * _e172.y)) + (_e178.z * _e172.z)) + (_e178.w * 1f));
            let _e191 = p.member.projection.row_x;
            let _e203 = (((((_e191.x * _e172.x) + (_e191.y * _e172.y)) + (_e191.z * _e172.z)) + (_e191.w * 1f)) / _e189);
            let _e205 = p.member.projection.row_y;
            let _e217 = (((((_e205.x * _e172.x) + (_e205.y * _e172.y)) + (_e205.z * _e172.z)) + (_e205.w * 1f)) / _e189);
            let _e219 = p.member.projection.row_z;
            let _e230 = ((((_e219.x * _e172.x) + (_e219.y * _e172.y)) + (_e219.z * _e172.z)) + (_e219.w * 1f));
            if (_e189 > 0f) {
                if (_e203 >= 0f) {
                    phi_321_ = (_e203 <= 1f);
                } else {
                    phi_321_ = false;
                }
                let _e235 = phi_321_;
                if _e235 {
                    if (_e217 >= 0f) {
                        phi_330_ = (_e217 <= 1f);
                    } else {
                        phi_330_ = false;
                    }
                    let _e239 = phi_330_;
                    if _e239 {
                        if (_e230 >= 0f) {
                            phi_339_ = (_e230 <= 1f);
                        } else {
                            phi_339_ = false;
                        }
                        let _e243 = phi_339_;
                        phi_340_ = _e243;
                        phi_341_ = false;
                    } else {
                        phi_340_ = bool();
                        phi_341_ = true;
                    }
                    let _e245 = phi_340_;
                    let _e247 = phi_341_;
                    phi_342_ = _e245;
                    phi_343_ = _e247;
                } else {
                    phi_342_ = bool();
                    phi_343_ = true;
                }
                let _e249 = phi_342_;
                let _e251 = phi_343_;
                phi_344_ = _e249;
                phi_345_ = _e251;
            } else {
                phi_344_ = bool();
                phi_345_ = true;
            }
            let _e253 = phi_344_;
            let _e255 = phi_345_;
            if _e255 {
                phi_349_ = false;
            } else {
                phi_349_ = _e253;
            }
            let _e257 = phi_349_;
            if _e257 {
                let _e259 = p.member.map_size;
                let _e260 = f32(_e259);
                let _e263 = ((_e203 * _e260) - 0.5f);
                let _e264 = ((_e217 * _e260) - 0.5f);
                if (_e263 > -8388608f) {
                    let _e276 = f32(select(0i, select(select(i32(_e263), i32(-2147483648), (_e263 < bitcast<f32>(3472883712u))), 2147483647i, (_e263 > bitcast<f32>(1325400063u))), (_e263 == _e263)));
                    if (_e276 > _e263) {
                        phi_385_ = 1f;
                    } else {
                        phi_385_ = 0f;
                    }
                    let _e279 = phi_385_;
                    if (_e263 < 8388608f) {
                        phi_390_ = (_e276 - _e279);
                        phi_391_ = false;
                    } else {
                        phi_390_ = f32();
                        phi_391_ = true;
                    }
                    let _e282 = phi_390_;
                    let _e284 = phi_391_;
                    phi_392_ = _e282;
                    phi_393_ = _e284;
                } else {
                    phi_392_ = f32();
                    phi_393_ = true;
                }
                let _e286 = phi_392_;
                let _e288 = phi_393_;
                if _e288 {
                    phi_397_ = _e263;
                } else {
                    phi_397_ = _e286;
                }
                let _e290 = phi_397_;
                if (_e264 > -8388608f) {
                    let _e302 = f32(select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)));
                    if (_e302 > _e264) {
                        phi_417_ = 1f;
                    } else {
                        phi_417_ = 0f;
                    }
                    let _e305 = phi_417_;
                    if (_e264 < 8388608f) {
                        phi_422_ = (_e302 - _e305);
                        phi_423_ = false;
                    } else {
                        phi_422_ = f32();
                        phi_423_ = true;
                    }
                    let _e308 = phi_422_;
                    let _e310 = phi_423_;
                    phi_424_ = _e308;
                    phi_425_ = _e310;
                } else {
                    phi_424_ = f32();
                    phi_425_ = true;
                }
                let _e312 = phi_424_;
                let _e314 = phi_425_;
                if _e314 {
                    phi_429_ = _e264;
                } else {
                    phi_429_ = _e312;
                }
                let _e316 = phi_429_;
                let _e317 = (_e263 - _e290);
                let _e318 = (_e264 - _e316);
                let _e327 = select(0i, select(select(i32(_e290), i32(-2147483648), (_e290 < bitcast<f32>(3472883712u))), 2147483647i, (_e290 > bitcast<f32>(1325400063u))), (_e290 == _e290));
                let _e336 = select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < bitcast<f32>(3472883712u))), 2147483647i, (_e316 > bitcast<f32>(1325400063u))), (_e316 == _e316));
                let _e347 = p.member.test;
                let _e348 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e347);
                let _e350 = p.member.map_size;
                local = _e348;
                let _e352 = (bitcast<i32>(_e350) - 1i);
                if (_e327 > 0i) {
                    phi_475_ = _e327;
                } else {
                    phi_475_ = 0i;
                }
                let _e355 = phi_475_;
                if (_e336 > 0i) {
                    phi_480_ = _e336;
                } else {
                    phi_480_ = 0i;
                }
                let _e358 = phi_480_;
                if (_e355 < _e352) {
                    phi_485_ = _e355;
                } else {
                    phi_485_ = _e352;
                }
                let _e361 = phi_485_;
                if (_e358 < _e352) {
                    phi_490_ = _e358;
                } else {
                    phi_490_ = _e352;
                }
                let _e364 = phi_490_;
                let _e365 = bitcast<u32>(_e361);
                let _e367 = (_e327 + 1i);
                let _e368 = (_e336 + 1i);
                if (_e367 > 0i) {
                    phi_499_ = _e367;
                } else {
                    phi_499_ = 0i;
                }
                let _e371 = phi_499_;
                if (_e368 > 0i) {
                    phi_504_ = _e368;
                } else {
                    phi_504_ = 0i;
                }
                let _e374 = phi_504_;
                if (_e371 < _e352) {
                    phi_509_ = _e371;
                } else {
                    phi_509_ = _e352;
                }
                let _e377 = phi_509_;
                if (_e374 < _e352) {
                    phi_514_ = _e374;
                } else {
                    phi_514_ = _e352;
                }
                let _e380 = phi_514_;
                let _e381 = bitcast<u32>(_e377);
                let _e383 = (bitcast<u32>(_e364) * _e350);
                let _e384 = (bitcast<u32>(_e380) * _e350);
                let _e385 = (_e383 + _e365);
                let _e386 = (_e383 + _e381);
                let _e387 = (_e384 + _e365);
                let _e388 = (_e384 + _e381);
                if (_e385 < _e40) {
                } else {
                    return;
                }
                let _e392 = map.member[(0u + _e385)];
                if (_e386 < _e40) {
                } else {
                    return;
                }
                let _e396 = map.member[(0u + _e386)];
                if (_e387 < _e40) {
                } else {
                    return;
                }
                let _e400 = map.member[(0u + _e387)];
                if (_e388 < _e40) {
                } else {
                    return;
                }
                let _e404 = map.member[(0u + _e388)];
                let _e406 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e392, _e396, _e400, _e404), vec4<f32>(((1f - _e317) * (1f - _e318)), (_e317 * (1f - _e318)), ((1f - _e317) * _e318), (_e317 * _e318)), _e230);
                phi_555_ = evaluate_Verdict(_e406, false);
                phi_556_ = evaluate_Verdict();
                phi_557_ = false;
            } else {
                phi_555_ = evaluate_Verdict();
                phi_556_ = evaluate_Verdict(1f, false);
                phi_557_ = true;
            }
            let _e410 = phi_555_;
            let _e412 = phi_556_;
            let _e414 = phi_557_;
            phi_558_ = _e412;
            phi_559_ = _e410;
            phi_560_ = _e414;
        }
        let _e416 = phi_558_;
        let _e418 = phi_559_;
        let _e420 = phi_560_;
        if _e420 {
            phi_564_ = _e416;
        } else {
            phi_564_ = _e418;
        }
        let _e422 = phi_564_;
        if (_e49.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e49.first_primitive)] = _e422.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
