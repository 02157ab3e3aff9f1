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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_31 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_35 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_136_: lt_bvh_traverse_Tree;
    var phi_137_: bool;
    var phi_138_: lt_bvh_traverse_Tree;
    var phi_139_: bool;
    var phi_144_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_136_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_137_ = false;
        } else {
            phi_136_ = lt_bvh_traverse_Tree();
            phi_137_ = true;
        }
        let _e47 = phi_136_;
        let _e49 = phi_137_;
        phi_138_ = _e47;
        phi_139_ = _e49;
    } else {
        phi_138_ = lt_bvh_traverse_Tree();
        phi_139_ = true;
    }
    let _e51 = phi_138_;
    let _e53 = phi_139_;
    if _e53 {
        phi_144_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_144_ = _e51;
    }
    let _e58 = phi_144_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_820_: bool;
    var phi_842_: f32;
    var phi_843_: f32;
    var phi_844_: f32;
    var phi_845_: f32;
    var phi_846_: bool;
    var phi_847_: f32;
    var phi_848_: bool;
    var phi_886_: vec2<f32>;
    var phi_920_: f32;
    var phi_921_: f32;
    var phi_922_: f32;
    var phi_951_: f32;
    var phi_952_: f32;
    var phi_953_: f32;
    var phi_957_: f32;
    var phi_958_: f32;
    var phi_959_: f32;
    var phi_960_: f32;

    let _e37 = (*param_4);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_5.x * _e38) + _e47);
    let _e49 = ((param_5.y * _e38) + _e47);
    let _e51 = ((param_5.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_5.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_814_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_813_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_812_ = 1f;
            } else {
                phi_812_ = param_6;
            }
            let _e67 = phi_812_;
            phi_813_ = _e67;
        }
        let _e69 = phi_813_;
        phi_814_ = _e69;
    }
    let _e71 = phi_814_;
    if (_e48 == _e51) {
        phi_820_ = (_e48 > 0.5f);
    } else {
        phi_820_ = false;
    }
    let _e75 = phi_820_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_844_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_843_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_842_ = 1f;
                    } else {
                        phi_842_ = _e48;
                    }
                    let _e83 = phi_842_;
                    phi_843_ = _e83;
                }
                let _e85 = phi_843_;
                phi_844_ = _e85;
            }
            let _e87 = phi_844_;
            phi_845_ = _e87;
            phi_846_ = false;
        } else {
            phi_845_ = f32();
            phi_846_ = true;
        }
        let _e89 = phi_845_;
        let _e91 = phi_846_;
        phi_847_ = _e89;
        phi_848_ = _e91;
    } else {
        phi_847_ = f32();
        phi_848_ = true;
    }
    let _e93 = phi_847_;
    let _e95 = phi_848_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_886_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_886_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_886_;
        if (_e71 <= _e128.x) {
            phi_959_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_922_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_921_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_920_ = 1f;
                        } else {
                            phi_920_ = _e141;
                        }
                        let _e148 = phi_920_;
                        phi_921_ = _e148;
                    }
                    let _e150 = phi_921_;
                    phi_922_ = _e150;
                }
                let _e152 = phi_922_;
                phi_958_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_953_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_952_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_951_ = 1f;
                            } else {
                                phi_951_ = _e163;
                            }
                            let _e170 = phi_951_;
                            phi_952_ = _e170;
                        }
                        let _e172 = phi_952_;
                        phi_953_ = _e172;
                    }
                    let _e174 = phi_953_;
                    phi_957_ = _e174;
                } else {
                    phi_957_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_957_;
                phi_958_ = _e179;
            }
            let _e181 = phi_958_;
            phi_959_ = _e181;
        }
        let _e183 = phi_959_;
        phi_960_ = _e183;
    } else {
        phi_960_ = _e93;
    }
    let _e185 = phi_960_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_206_: bool;
    var phi_207_: bool;
    var phi_208_: bool;
    var phi_209_: bool;
    var phi_213_: bool;
    var phi_283_: bool;
    var phi_284_: bool;
    var phi_295_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_296_: bool;
    var phi_297_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_298_: bool;
    var phi_305_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_309_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_383_: bool;
    var phi_392_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_411_: bool;
    var phi_501_: f32;
    var phi_504_: f32;
    var phi_533_: f32;
    var phi_538_: f32;
    var phi_539_: bool;
    var phi_540_: f32;
    var phi_541_: bool;
    var phi_545_: f32;
    var phi_565_: f32;
    var phi_570_: f32;
    var phi_571_: bool;
    var phi_572_: f32;
    var phi_573_: bool;
    var phi_577_: f32;
    var phi_625_: i32;
    var phi_630_: i32;
    var phi_635_: i32;
    var phi_640_: i32;
    var phi_649_: i32;
    var phi_654_: i32;
    var phi_659_: i32;
    var phi_664_: i32;
    var phi_753_: evaluate_Verdict;
    var phi_754_: evaluate_Verdict;
    var phi_755_: bool;
    var phi_756_: evaluate_Verdict;
    var phi_757_: evaluate_Verdict;
    var phi_758_: bool;
    var phi_762_: evaluate_Verdict;

    let _e35 = id_1;
    let _e42 = arrayLength((&map.member));
    let _e48 = p.member.size[0u];
    let _e50 = p.member.size[1u];
    let _e51 = lt_shaders_entry_pixel_index(_e35, _e48, _e50);
    if (bitcast<i32>(_e51.root) != 0i) {
        let _e57 = p.member.projection;
        if (_e51.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e61 = lt_math_OneLevel(_e57);
        let _e65 = samples.member[(0u + _e51.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e51.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e51.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_206_ = (_e75 == _e77);
                phi_207_ = false;
            } else {
                phi_206_ = bool();
                phi_207_ = true;
            }
            let _e80 = phi_206_;
            let _e82 = phi_207_;
            phi_208_ = _e80;
            phi_209_ = _e82;
        } else {
            phi_208_ = bool();
            phi_209_ = true;
        }
        let _e84 = phi_208_;
        let _e86 = phi_209_;
        if _e86 {
            phi_213_ = false;
        } else {
            phi_213_ = _e84;
        }
        let _e88 = phi_213_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e51.first_primitive)].position;
            let _e93 = p.member.light.place;
            let _e99 = p.member.light.place[3u];
            let _e106 = (_e93.x - (_e91.x * _e99));
            let _e107 = (_e93.y - (_e91.y * _e99));
            let _e108 = (_e93.z - (_e91.z * _e99));
            let _e110 = samples.member[(0u + _e51.first_primitive)].normal;
            if ((((_e110.x * _e106) + (_e110.y * _e107)) + (_e110.z * _e108)) > 0f) {
                let _e124 = (((_e106 * _e106) + (_e107 * _e107)) + (_e108 * _e108));
                let _e126 = p.member.light.axis;
                let _e138 = p.member.light.place[3u];
                if (_e138 == 0f) {
                    phi_284_ = true;
                } else {
                    let _e141 = p.member.light.range_squared;
                    if (_e124 <= _e141) {
                        let _e144 = p.member.light.cos_outer;
                        phi_283_ = (-((((_e106 * _e126.x) + (_e107 * _e126.y)) + (_e108 * _e126.z))) >= (_e144 * sqrt(_e124)));
                    } else {
                        phi_283_ = false;
                    }
                    let _e149 = phi_283_;
                    phi_284_ = _e149;
                }
                let _e151 = phi_284_;
                if _e151 {
                    let _e153 = samples.member[(0u + _e51.first_primitive)].flags;
                    let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                    phi_295_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, ((_e153 & 1u) == 0u));
                    phi_296_ = false;
                } else {
                    phi_295_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_296_ = true;
                }
                let _e172 = phi_295_;
                let _e174 = phi_296_;
                phi_297_ = _e172;
                phi_298_ = _e174;
            } else {
                phi_297_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_298_ = true;
            }
            let _e176 = phi_297_;
            let _e178 = phi_298_;
            if _e178 {
                let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
                phi_305_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, true);
            } else {
                phi_305_ = _e176;
            }
            let _e195 = phi_305_;
            phi_309_ = _e195;
        } else {
            let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
            phi_309_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
        }
        let _e212 = phi_309_;
        if _e212.unnamed_1 {
            phi_756_ = evaluate_Verdict(_e212.unnamed.visibility, _e212.unnamed.is_doubted);
            phi_757_ = evaluate_Verdict();
            phi_758_ = true;
        } else {
            let _e220 = samples.member[(0u + _e51.first_primitive)].position;
            let _e238 = ((((_e61.projection.row_w.x * _e220.x) + (_e61.projection.row_w.y * _e220.y)) + (_e61.projection.row_w.z * _e220.z)) + (_e61.projection.row_w.w * 1f));
            let _e252 = (((((_e61.projection.row_x.x * _e220.x) + (_e61.projection.row_x.y * _e220.y)) + (_e61.projection.row_x.z * _e220.z)) + (_e61.projection.row_x.w * 1f)) / _e238);
            let _e266 = (((((_e61.projection.row_y.x * _e220.x) + (_e61.projection.row_y.y * _e220.y)) + (_e61.projection.row_y.z * _e220.z)) + (_e61.projection.row_y.w * 1f)) / _e238);
            let _e279 = ((((_e61.projection.row_z.x * _e220.x) + (_e61.projection.row_z.y * _e220.y)) + (_e61.projection.row_z.z * _e220.z)) + (_e61.projection.row_z.w * 1f));
            if (_e238 > 0f) {
                if (_e252 >= 0f) {
                    phi_383_ = (_e252 <= 1f);
                } else {
                    phi_383_ = false;
                }
                let _e284 = phi_383_;
                if _e284 {
                    if (_e266 >= 0f) {
                        phi_392_ = (_e266 <= 1f);
                    } else {
                        phi_392_ = false;
                    }
                    let _e288 = phi_392_;
                    if _e288 {
                        if (_e279 >= 0f) {
                            phi_401_ = (_e279 <= 1f);
                        } else {
                            phi_401_ = false;
                        }
                        let _e292 = phi_401_;
                        phi_402_ = _e292;
                        phi_403_ = false;
                    } else {
                        phi_402_ = bool();
                        phi_403_ = true;
                    }
                    let _e294 = phi_402_;
                    let _e296 = phi_403_;
                    phi_404_ = _e294;
                    phi_405_ = _e296;
                } else {
                    phi_404_ = bool();
                    phi_405_ = true;
                }
                let _e298 = phi_404_;
                let _e300 = phi_405_;
                phi_406_ = _e298;
                phi_407_ = _e300;
            } else {
                phi_406_ = bool();
                phi_407_ = true;
            }
            let _e302 = phi_406_;
            let _e304 = phi_407_;
            if _e304 {
                phi_411_ = false;
            } else {
                phi_411_ = _e302;
            }
            let _e306 = phi_411_;
            if _e306 {
                if (0f > 0f) {
                    let _e309 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e311 = p.member.map_size;
                    let _e381 = ((abs(((((_e57.row_x.x * _e309.x) + (_e57.row_x.y * _e309.y)) + (_e57.row_x.z * _e309.z)) / (((_e57.row_x.x * _e57.row_x.x) + (_e57.row_x.y * _e57.row_x.y)) + (_e57.row_x.z * _e57.row_x.z)))) + abs(((((_e57.row_y.x * _e309.x) + (_e57.row_y.y * _e309.y)) + (_e57.row_y.z * _e309.z)) / (((_e57.row_y.x * _e57.row_y.x) + (_e57.row_y.y * _e57.row_y.y)) + (_e57.row_y.z * _e57.row_y.z))))) / (abs(((((_e57.row_z.x * _e309.x) + (_e57.row_z.y * _e309.y)) + (_e57.row_z.z * _e309.z)) / (((_e57.row_z.x * _e57.row_z.x) + (_e57.row_z.y * _e57.row_z.y)) + (_e57.row_z.z * _e57.row_z.z)))) * f32(_e311)));
                    if (_e381 < 0.002f) {
                        phi_501_ = _e381;
                    } else {
                        phi_501_ = 0.002f;
                    }
                    let _e384 = phi_501_;
                    phi_504_ = (_e279 - (0f * _e384));
                } else {
                    phi_504_ = _e279;
                }
                let _e388 = phi_504_;
                let _e390 = p.member.map_size;
                let _e391 = f32(_e390);
                let _e394 = ((_e252 * _e391) - 0.5f);
                let _e395 = ((_e266 * _e391) - 0.5f);
                if (_e394 > -8388608f) {
                    let _e407 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e407 > _e394) {
                        phi_533_ = 1f;
                    } else {
                        phi_533_ = 0f;
                    }
                    let _e410 = phi_533_;
                    if (_e394 < 8388608f) {
                        phi_538_ = (_e407 - _e410);
                        phi_539_ = false;
                    } else {
                        phi_538_ = f32();
                        phi_539_ = true;
                    }
                    let _e413 = phi_538_;
                    let _e415 = phi_539_;
                    phi_540_ = _e413;
                    phi_541_ = _e415;
                } else {
                    phi_540_ = f32();
                    phi_541_ = true;
                }
                let _e417 = phi_540_;
                let _e419 = phi_541_;
                if _e419 {
                    phi_545_ = _e394;
                } else {
                    phi_545_ = _e417;
                }
                let _e421 = phi_545_;
                if (_e395 > -8388608f) {
                    let _e433 = f32(select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < bitcast<f32>(3472883712u))), 2147483647i, (_e395 > bitcast<f32>(1325400063u))), (_e395 == _e395)));
                    if (_e433 > _e395) {
                        phi_565_ = 1f;
                    } else {
                        phi_565_ = 0f;
                    }
                    let _e436 = phi_565_;
                    if (_e395 < 8388608f) {
                        phi_570_ = (_e433 - _e436);
                        phi_571_ = false;
                    } else {
                        phi_570_ = f32();
                        phi_571_ = true;
                    }
                    let _e439 = phi_570_;
                    let _e441 = phi_571_;
                    phi_572_ = _e439;
                    phi_573_ = _e441;
                } else {
                    phi_572_ = f32();
                    phi_573_ = true;
                }
                let _e443 = phi_572_;
                let _e445 = phi_573_;
                if _e445 {
                    phi_577_ = _e395;
                } else {
                    phi_577_ = _e443;
                }
                let _e447 = phi_577_;
                let _e448 = (_e394 - _e421);
                let _e449 = (_e395 - _e447);
                let _e458 = select(0i, select(select(i32(_e421), i32(-2147483648), (_e421 < bitcast<f32>(3472883712u))), 2147483647i, (_e421 > bitcast<f32>(1325400063u))), (_e421 == _e421));
                let _e467 = select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < bitcast<f32>(3472883712u))), 2147483647i, (_e447 > bitcast<f32>(1325400063u))), (_e447 == _e447));
                let _e470 = ((1f - _e448) * (1f - _e449));
                let _e472 = (_e448 * (1f - _e449));
                let _e474 = ((1f - _e448) * _e449);
                let _e475 = (_e448 * _e449);
                let _e477 = p.member.test;
                let _e478 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e458 > 0i) {
                    phi_625_ = _e458;
                } else {
                    phi_625_ = 0i;
                }
                let _e487 = phi_625_;
                if (_e467 > 0i) {
                    phi_630_ = _e467;
                } else {
                    phi_630_ = 0i;
                }
                let _e490 = phi_630_;
                if (_e487 < _e484) {
                    phi_635_ = _e487;
                } else {
                    phi_635_ = _e484;
                }
                let _e493 = phi_635_;
                if (_e490 < _e484) {
                    phi_640_ = _e490;
                } else {
                    phi_640_ = _e484;
                }
                let _e496 = phi_640_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e458 + 1i);
                let _e500 = (_e467 + 1i);
                if (_e499 > 0i) {
                    phi_649_ = _e499;
                } else {
                    phi_649_ = 0i;
                }
                let _e503 = phi_649_;
                if (_e500 > 0i) {
                    phi_654_ = _e500;
                } else {
                    phi_654_ = 0i;
                }
                let _e506 = phi_654_;
                if (_e503 < _e484) {
                    phi_659_ = _e503;
                } else {
                    phi_659_ = _e484;
                }
                let _e509 = phi_659_;
                if (_e506 < _e484) {
                    phi_664_ = _e506;
                } else {
                    phi_664_ = _e484;
                }
                let _e512 = phi_664_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (bitcast<u32>(_e496) * _e480);
                let _e516 = (bitcast<u32>(_e512) * _e480);
                let _e521 = ((_e515 + _e497) + _e482);
                let _e522 = ((_e515 + _e513) + _e482);
                let _e523 = ((_e516 + _e497) + _e482);
                let _e524 = ((_e516 + _e513) + _e482);
                if (_e521 < _e42) {
                } else {
                    return;
                }
                let _e528 = map.member[(0u + _e521)];
                if (_e522 < _e42) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e522)];
                if (_e523 < _e42) {
                } else {
                    return;
                }
                let _e556 = map.member[(0u + _e523)];
                if (_e524 < _e42) {
                } else {
                    return;
                }
                let _e572 = map.member[(0u + _e524)];
                let _e586 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e528.x * _e470) + (_e540.x * _e472)) + (_e556.x * _e474)) + (_e572.x * _e475)), ((((_e528.y * _e470) + (_e540.y * _e472)) + (_e556.y * _e474)) + (_e572.y * _e475)), ((((_e528.z * _e470) + (_e540.z * _e472)) + (_e556.z * _e474)) + (_e572.z * _e475)), ((((_e528.w * _e470) + (_e540.w * _e472)) + (_e556.w * _e474)) + (_e572.w * _e475))), _e388);
                phi_753_ = evaluate_Verdict(_e586, false);
                phi_754_ = evaluate_Verdict();
                phi_755_ = false;
            } else {
                phi_753_ = evaluate_Verdict();
                phi_754_ = evaluate_Verdict(1f, false);
                phi_755_ = true;
            }
            let _e590 = phi_753_;
            let _e592 = phi_754_;
            let _e594 = phi_755_;
            phi_756_ = _e592;
            phi_757_ = _e590;
            phi_758_ = _e594;
        }
        let _e596 = phi_756_;
        let _e598 = phi_757_;
        let _e600 = phi_758_;
        if _e600 {
            phi_762_ = _e596;
        } else {
            phi_762_ = _e598;
        }
        let _e602 = phi_762_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e602.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
