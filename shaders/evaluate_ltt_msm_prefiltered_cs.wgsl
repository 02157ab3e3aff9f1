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

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_39 {
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

struct type_43 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_161_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_153_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_154_ = false;
        } else {
            phi_153_ = lt_bvh_traverse_Tree();
            phi_154_ = true;
        }
        let _e51 = phi_153_;
        let _e53 = phi_154_;
        phi_155_ = _e51;
        phi_156_ = _e53;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e55 = phi_155_;
    let _e57 = phi_156_;
    if _e57 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e55;
    }
    let _e62 = phi_161_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_218_: bool;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: bool;
    var phi_245_: f32;
    var phi_246_: bool;
    var phi_284_: vec2<f32>;
    var phi_318_: f32;
    var phi_319_: f32;
    var phi_320_: f32;
    var phi_349_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_355_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_358_: f32;

    let _e41 = (*param_4);
    let _e42 = (1f - _e41);
    let _e51 = (0.5f * _e41);
    let _e52 = ((param_5.x * _e42) + _e51);
    let _e53 = ((param_5.y * _e42) + _e51);
    let _e55 = ((param_5.w * _e42) + _e51);
    let _e57 = (_e53 - (_e52 * _e52));
    let _e59 = (((param_5.z * _e42) + _e51) - (_e52 * _e53));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_212_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_6;
            }
            let _e71 = phi_210_;
            phi_211_ = _e71;
        }
        let _e73 = phi_211_;
        phi_212_ = _e73;
    }
    let _e75 = phi_212_;
    if (_e52 == _e55) {
        phi_218_ = (_e52 > 0.5f);
    } else {
        phi_218_ = false;
    }
    let _e79 = phi_218_;
    if _e79 {
        if (_e75 > 0f) {
            if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
                phi_242_ = _e52;
            } else {
                if (_e52 < 0f) {
                    phi_241_ = 0f;
                } else {
                    if (_e52 > 1f) {
                        phi_240_ = 1f;
                    } else {
                        phi_240_ = _e52;
                    }
                    let _e87 = phi_240_;
                    phi_241_ = _e87;
                }
                let _e89 = phi_241_;
                phi_242_ = _e89;
            }
            let _e91 = phi_242_;
            phi_243_ = _e91;
            phi_244_ = false;
        } else {
            phi_243_ = f32();
            phi_244_ = true;
        }
        let _e93 = phi_243_;
        let _e95 = phi_244_;
        phi_245_ = _e93;
        phi_246_ = _e95;
    } else {
        phi_245_ = f32();
        phi_246_ = true;
    }
    let _e97 = phi_245_;
    let _e99 = phi_246_;
    if _e99 {
        let _e100 = (_e59 / _e57);
        let _e101 = (_e75 - _e52);
        let _e107 = (((((_e75 * _e75) - _e53) - (_e100 * _e101)) * _e57) / (((_e55 - (_e53 * _e53)) * _e57) - (_e59 * _e59)));
        let _e110 = ((_e101 / _e57) - (_e100 * _e107));
        let _e116 = ((0.5f * _e110) / _e107);
        let _e119 = ((_e116 * _e116) - (((1f - (_e110 * _e52)) - (_e107 * _e53)) / _e107));
        if (_e119 >= 0f) {
            let _e121 = sqrt(_e119);
            phi_284_ = vec2<f32>((-(_e116) - _e121), (-(_e116) + _e121));
        } else {
            phi_284_ = vec2(bitcast<f32>((bitcast<u32>(_e119) | 2143289344u)));
        }
        let _e132 = phi_284_;
        if (_e75 <= _e132.x) {
            phi_357_ = 1f;
        } else {
            if (_e75 > _e132.y) {
                let _e145 = (((_e53 - (_e52 * (_e132.x + _e132.y))) + (_e132.x * _e132.y)) / ((_e75 - _e132.x) * (_e75 - _e132.y)));
                if ((bitcast<u32>(_e145) & 2147483647u) > 2139095040u) {
                    phi_320_ = _e145;
                } else {
                    if (_e145 < 0f) {
                        phi_319_ = 0f;
                    } else {
                        if (_e145 > 1f) {
                            phi_318_ = 1f;
                        } else {
                            phi_318_ = _e145;
                        }
                        let _e152 = phi_318_;
                        phi_319_ = _e152;
                    }
                    let _e154 = phi_319_;
                    phi_320_ = _e154;
                }
                let _e156 = phi_320_;
                phi_356_ = _e156;
            } else {
                if (_e75 > _e132.x) {
                    let _e167 = (1f - (((_e53 - (_e52 * (_e75 + _e132.y))) + (_e75 * _e132.y)) / ((_e132.x - _e75) * (_e132.x - _e132.y))));
                    if ((bitcast<u32>(_e167) & 2147483647u) > 2139095040u) {
                        phi_351_ = _e167;
                    } else {
                        if (_e167 < 0f) {
                            phi_350_ = 0f;
                        } else {
                            if (_e167 > 1f) {
                                phi_349_ = 1f;
                            } else {
                                phi_349_ = _e167;
                            }
                            let _e174 = phi_349_;
                            phi_350_ = _e174;
                        }
                        let _e176 = phi_350_;
                        phi_351_ = _e176;
                    }
                    let _e178 = phi_351_;
                    phi_355_ = _e178;
                } else {
                    phi_355_ = bitcast<f32>((bitcast<u32>(_e132.x) | 2143289344u));
                }
                let _e183 = phi_355_;
                phi_356_ = _e183;
            }
            let _e185 = phi_356_;
            phi_357_ = _e185;
        }
        let _e187 = phi_357_;
        phi_358_ = _e187;
    } else {
        phi_358_ = _e97;
    }
    let _e189 = phi_358_;
    return _e189;
}

fn function_() {
    var local_1: f32;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_416_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_498_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_499_: bool;
    var phi_500_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_501_: bool;
    var phi_508_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_512_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_586_: bool;
    var phi_595_: bool;
    var phi_604_: bool;
    var phi_605_: bool;
    var phi_606_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_614_: bool;
    var phi_704_: f32;
    var phi_707_: f32;
    var phi_736_: f32;
    var phi_741_: f32;
    var phi_742_: bool;
    var phi_743_: f32;
    var phi_744_: bool;
    var phi_748_: f32;
    var phi_768_: f32;
    var phi_773_: f32;
    var phi_774_: bool;
    var phi_775_: f32;
    var phi_776_: bool;
    var phi_780_: f32;
    var phi_828_: i32;
    var phi_833_: i32;
    var phi_838_: i32;
    var phi_843_: i32;
    var phi_852_: i32;
    var phi_857_: i32;
    var phi_862_: i32;
    var phi_867_: i32;
    var phi_962_: bool;
    var phi_970_: bool;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_987_: f32;
    var phi_993_: f32;
    var phi_995_: evaluate_Verdict;
    var phi_1000_: evaluate_Verdict;
    var phi_1001_: evaluate_Verdict;
    var phi_1005_: bool;
    var phi_1006_: u32;
    var phi_1017_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e39, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.projection;
        let _e61 = lt_math_OneLevel(_e60);
        let _e65 = samples.member[_e53.first_primitive].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[_e53.first_primitive].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[_e53.first_primitive].normal[2u];
                let _e77 = global[2u];
                phi_409_ = (_e75 == _e77);
                phi_410_ = false;
            } else {
                phi_409_ = bool();
                phi_410_ = true;
            }
            let _e80 = phi_409_;
            let _e82 = phi_410_;
            phi_411_ = _e80;
            phi_412_ = _e82;
        } else {
            phi_411_ = bool();
            phi_412_ = true;
        }
        let _e84 = phi_411_;
        let _e86 = phi_412_;
        if _e86 {
            phi_416_ = false;
        } else {
            phi_416_ = _e84;
        }
        let _e88 = phi_416_;
        if !(_e88) {
            let _e91 = samples.member[_e53.first_primitive].position;
            let _e93 = p.member.light.place;
            let _e99 = p.member.light.place[3u];
            let _e106 = (_e93.x - (_e91.x * _e99));
            let _e107 = (_e93.y - (_e91.y * _e99));
            let _e108 = (_e93.z - (_e91.z * _e99));
            let _e110 = samples.member[_e53.first_primitive].normal;
            if ((((_e110.x * _e106) + (_e110.y * _e107)) + (_e110.z * _e108)) > 0f) {
                let _e124 = (((_e106 * _e106) + (_e107 * _e107)) + (_e108 * _e108));
                let _e126 = p.member.light.axis;
                let _e138 = p.member.light.place[3u];
                if (_e138 == 0f) {
                    phi_487_ = true;
                } else {
                    let _e141 = p.member.light.range_squared;
                    if (_e124 <= _e141) {
                        let _e144 = p.member.light.cos_outer;
                        phi_486_ = (-((((_e106 * _e126.x) + (_e107 * _e126.y)) + (_e108 * _e126.z))) >= (_e144 * sqrt(_e124)));
                    } else {
                        phi_486_ = false;
                    }
                    let _e149 = phi_486_;
                    phi_487_ = _e149;
                }
                let _e151 = phi_487_;
                if _e151 {
                    let _e153 = samples.member[_e53.first_primitive].flags;
                    let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                    phi_498_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, ((_e153 & 1u) == 0u));
                    phi_499_ = false;
                } else {
                    phi_498_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_499_ = true;
                }
                let _e172 = phi_498_;
                let _e174 = phi_499_;
                phi_500_ = _e172;
                phi_501_ = _e174;
            } else {
                phi_500_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_501_ = true;
            }
            let _e176 = phi_500_;
            let _e178 = phi_501_;
            if _e178 {
                let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
                phi_508_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, true);
            } else {
                phi_508_ = _e176;
            }
            let _e195 = phi_508_;
            phi_512_ = _e195;
        } else {
            let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
            phi_512_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
        }
        let _e212 = phi_512_;
        if _e212.unnamed_1 {
            phi_1001_ = evaluate_Verdict(_e212.unnamed.visibility, _e212.unnamed.is_doubted);
        } else {
            let _e220 = samples.member[_e53.first_primitive].position;
            let _e238 = ((((_e61.projection.row_w.x * _e220.x) + (_e61.projection.row_w.y * _e220.y)) + (_e61.projection.row_w.z * _e220.z)) + (_e61.projection.row_w.w * 1f));
            let _e252 = (((((_e61.projection.row_x.x * _e220.x) + (_e61.projection.row_x.y * _e220.y)) + (_e61.projection.row_x.z * _e220.z)) + (_e61.projection.row_x.w * 1f)) / _e238);
            let _e266 = (((((_e61.projection.row_y.x * _e220.x) + (_e61.projection.row_y.y * _e220.y)) + (_e61.projection.row_y.z * _e220.z)) + (_e61.projection.row_y.w * 1f)) / _e238);
            let _e279 = ((((_e61.projection.row_z.x * _e220.x) + (_e61.projection.row_z.y * _e220.y)) + (_e61.projection.row_z.z * _e220.z)) + (_e61.projection.row_z.w * 1f));
            if (_e238 > 0f) {
                if (_e252 >= 0f) {
                    phi_586_ = (_e252 <= 1f);
                } else {
                    phi_586_ = false;
                }
                let _e284 = phi_586_;
                if _e284 {
                    if (_e266 >= 0f) {
                        phi_595_ = (_e266 <= 1f);
                    } else {
                        phi_595_ = false;
                    }
                    let _e288 = phi_595_;
                    if _e288 {
                        if (_e279 >= 0f) {
                            phi_604_ = (_e279 <= 1f);
                        } else {
                            phi_604_ = false;
                        }
                        let _e292 = phi_604_;
                        phi_605_ = _e292;
                        phi_606_ = false;
                    } else {
                        phi_605_ = bool();
                        phi_606_ = true;
                    }
                    let _e294 = phi_605_;
                    let _e296 = phi_606_;
                    phi_607_ = _e294;
                    phi_608_ = _e296;
                } else {
                    phi_607_ = bool();
                    phi_608_ = true;
                }
                let _e298 = phi_607_;
                let _e300 = phi_608_;
                phi_609_ = _e298;
                phi_610_ = _e300;
            } else {
                phi_609_ = bool();
                phi_610_ = true;
            }
            let _e302 = phi_609_;
            let _e304 = phi_610_;
            if _e304 {
                phi_614_ = false;
            } else {
                phi_614_ = _e302;
            }
            let _e306 = phi_614_;
            if _e306 {
                if (0f > 0f) {
                    let _e309 = samples.member[_e53.first_primitive].normal;
                    let _e311 = p.member.map_size;
                    let _e381 = ((abs(((((_e60.row_x.x * _e309.x) + (_e60.row_x.y * _e309.y)) + (_e60.row_x.z * _e309.z)) / (((_e60.row_x.x * _e60.row_x.x) + (_e60.row_x.y * _e60.row_x.y)) + (_e60.row_x.z * _e60.row_x.z)))) + abs(((((_e60.row_y.x * _e309.x) + (_e60.row_y.y * _e309.y)) + (_e60.row_y.z * _e309.z)) / (((_e60.row_y.x * _e60.row_y.x) + (_e60.row_y.y * _e60.row_y.y)) + (_e60.row_y.z * _e60.row_y.z))))) / (abs(((((_e60.row_z.x * _e309.x) + (_e60.row_z.y * _e309.y)) + (_e60.row_z.z * _e309.z)) / (((_e60.row_z.x * _e60.row_z.x) + (_e60.row_z.y * _e60.row_z.y)) + (_e60.row_z.z * _e60.row_z.z)))) * f32(_e311)));
                    if (_e381 < 0.002f) {
                        phi_704_ = _e381;
                    } else {
                        phi_704_ = 0.002f;
                    }
                    let _e384 = phi_704_;
                    phi_707_ = (_e279 - (0f * _e384));
                } else {
                    phi_707_ = _e279;
                }
                let _e388 = phi_707_;
                let _e390 = p.member.map_size;
                let _e391 = f32(_e390);
                let _e394 = ((_e252 * _e391) - 0.5f);
                let _e395 = ((_e266 * _e391) - 0.5f);
                if (_e394 > -8388608f) {
                    let _e407 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e407 > _e394) {
                        phi_736_ = 1f;
                    } else {
                        phi_736_ = 0f;
                    }
                    let _e410 = phi_736_;
                    if (_e394 < 8388608f) {
                        phi_741_ = (_e407 - _e410);
                        phi_742_ = false;
                    } else {
                        phi_741_ = f32();
                        phi_742_ = true;
                    }
                    let _e413 = phi_741_;
                    let _e415 = phi_742_;
                    phi_743_ = _e413;
                    phi_744_ = _e415;
                } else {
                    phi_743_ = f32();
                    phi_744_ = true;
                }
                let _e417 = phi_743_;
                let _e419 = phi_744_;
                if _e419 {
                    phi_748_ = _e394;
                } else {
                    phi_748_ = _e417;
                }
                let _e421 = phi_748_;
                if (_e395 > -8388608f) {
                    let _e433 = f32(select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < bitcast<f32>(3472883712u))), 2147483647i, (_e395 > bitcast<f32>(1325400063u))), (_e395 == _e395)));
                    if (_e433 > _e395) {
                        phi_768_ = 1f;
                    } else {
                        phi_768_ = 0f;
                    }
                    let _e436 = phi_768_;
                    if (_e395 < 8388608f) {
                        phi_773_ = (_e433 - _e436);
                        phi_774_ = false;
                    } else {
                        phi_773_ = f32();
                        phi_774_ = true;
                    }
                    let _e439 = phi_773_;
                    let _e441 = phi_774_;
                    phi_775_ = _e439;
                    phi_776_ = _e441;
                } else {
                    phi_775_ = f32();
                    phi_776_ = true;
                }
                let _e443 = phi_775_;
                let _e445 = phi_776_;
                if _e445 {
                    phi_780_ = _e395;
                } else {
                    phi_780_ = _e443;
                }
                let _e447 = phi_780_;
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
                local_1 = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e458 > 0i) {
                    phi_828_ = _e458;
                } else {
                    phi_828_ = 0i;
                }
                let _e487 = phi_828_;
                if (_e467 > 0i) {
                    phi_833_ = _e467;
                } else {
                    phi_833_ = 0i;
                }
                let _e490 = phi_833_;
                if (_e487 < _e484) {
                    phi_838_ = _e487;
                } else {
                    phi_838_ = _e484;
                }
                let _e493 = phi_838_;
                if (_e490 < _e484) {
                    phi_843_ = _e490;
                } else {
                    phi_843_ = _e484;
                }
                let _e496 = phi_843_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e458 + 1i);
                let _e500 = (_e467 + 1i);
                if (_e499 > 0i) {
                    phi_852_ = _e499;
                } else {
                    phi_852_ = 0i;
                }
                let _e503 = phi_852_;
                if (_e500 > 0i) {
                    phi_857_ = _e500;
                } else {
                    phi_857_ = 0i;
                }
                let _e506 = phi_857_;
                if (_e503 < _e484) {
                    phi_862_ = _e503;
                } else {
                    phi_862_ = _e484;
                }
                let _e509 = phi_862_;
                if (_e506 < _e484) {
                    phi_867_ = _e506;
                } else {
                    phi_867_ = _e484;
                }
                let _e512 = phi_867_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (bitcast<u32>(_e496) * _e480);
                let _e516 = (bitcast<u32>(_e512) * _e480);
                let _e521 = ((_e515 + _e497) + _e482);
                let _e522 = ((_e515 + _e513) + _e482);
                let _e523 = ((_e516 + _e497) + _e482);
                let _e524 = ((_e516 + _e513) + _e482);
                if (_e521 < _e45) {
                } else {
                    return;
                }
                let _e528 = map.member[(0u + _e521)];
                if (_e522 < _e45) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e522)];
                if (_e523 < _e45) {
                } else {
                    return;
                }
                let _e556 = map.member[(0u + _e523)];
                if (_e524 < _e45) {
                } else {
                    return;
                }
                let _e572 = map.member[(0u + _e524)];
                let _e586 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e528.x * _e470) + (_e540.x * _e472)) + (_e556.x * _e474)) + (_e572.x * _e475)), ((((_e528.y * _e470) + (_e540.y * _e472)) + (_e556.y * _e474)) + (_e572.y * _e475)), ((((_e528.z * _e470) + (_e540.z * _e472)) + (_e556.z * _e474)) + (_e572.z * _e475)), ((((_e528.w * _e470) + (_e540.w * _e472)) + (_e556.w * _e474)) + (_e572.w * _e475))), _e388);
                let _e588 = p.member.epsilon;
                if (_e586 <= _e588) {
                    phi_962_ = true;
                } else {
                    phi_962_ = (_e586 >= (1f - _e588));
                }
                let _e593 = phi_962_;
                if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                    phi_970_ = true;
                } else {
                    phi_970_ = !(_e593);
                }
                let _e599 = phi_970_;
                if _e599 {
                    if (_e586 > 0f) {
                        if (_e586 < 1f) {
                            phi_982_ = false;
                        } else {
                            phi_982_ = true;
                        }
                        let _e603 = phi_982_;
                        phi_983_ = _e603;
                    } else {
                        phi_983_ = true;
                    }
                    let _e605 = phi_983_;
                    if _e605 {
                        phi_987_ = 0.5f;
                    } else {
                        phi_987_ = _e586;
                    }
                    let _e607 = phi_987_;
                    phi_995_ = evaluate_Verdict(_e607, true);
                } else {
                    if (_e586 > 0.5f) {
                        phi_993_ = 1f;
                    } else {
                        phi_993_ = 0f;
                    }
                    let _e611 = phi_993_;
                    phi_995_ = evaluate_Verdict(_e611, false);
                }
                let _e614 = phi_995_;
                phi_1000_ = evaluate_Verdict(_e614.visibility, _e614.is_doubted);
            } else {
                phi_1000_ = evaluate_Verdict(0.5f, true);
            }
            let _e620 = phi_1000_;
            phi_1001_ = _e620;
        }
        let _e622 = phi_1001_;
        visibility.member[_e53.first_primitive] = _e622.visibility;
        phi_1005_ = _e622.is_doubted;
        phi_1006_ = _e53.first_primitive;
    } else {
        phi_1005_ = false;
        phi_1006_ = 0u;
    }
    let _e627 = phi_1005_;
    let _e629 = phi_1006_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e627 {
        let _e633 = atomicAdd((&shared_[0u]), 1u);
        phi_1017_ = _e633;
    } else {
        phi_1017_ = 0u;
    }
    let _e635 = phi_1017_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e639 = atomicLoad((&shared_[0u]));
        let _e640 = atomicAdd((&list.member[3u]), _e639);
        atomicStore((&shared_[1u]), _e640);
    }
    workgroupBarrier();
    if _e627 {
        let _e643 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e643) + _e635)]), _e629);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
