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
    var phi_137_: lt_bvh_traverse_Tree;
    var phi_138_: bool;
    var phi_139_: lt_bvh_traverse_Tree;
    var phi_140_: bool;
    var phi_145_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_137_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_138_ = false;
        } else {
            phi_137_ = lt_bvh_traverse_Tree();
            phi_138_ = true;
        }
        let _e47 = phi_137_;
        let _e49 = phi_138_;
        phi_139_ = _e47;
        phi_140_ = _e49;
    } else {
        phi_139_ = lt_bvh_traverse_Tree();
        phi_140_ = true;
    }
    let _e51 = phi_139_;
    let _e53 = phi_140_;
    if _e53 {
        phi_145_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_145_ = _e51;
    }
    let _e58 = phi_145_;
    return lt_bvh_traverse_Tree(_e58.root, _e58.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_202_: bool;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_228_: bool;
    var phi_229_: f32;
    var phi_230_: bool;
    var phi_268_: vec2<f32>;
    var phi_302_: f32;
    var phi_303_: f32;
    var phi_304_: f32;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_339_: f32;
    var phi_340_: f32;
    var phi_341_: f32;
    var phi_342_: f32;

    let _e37 = (*param_4);
    let _e38 = (1f - _e37);
    let _e47 = (0.5f * _e37);
    let _e48 = ((param_5.x * _e38) + _e47);
    let _e49 = ((param_5.y * _e38) + _e47);
    let _e51 = ((param_5.w * _e38) + _e47);
    let _e53 = (_e49 - (_e48 * _e48));
    let _e55 = (((param_5.z * _e38) + _e47) - (_e48 * _e49));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_196_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_195_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_194_ = 1f;
            } else {
                phi_194_ = param_6;
            }
            let _e67 = phi_194_;
            phi_195_ = _e67;
        }
        let _e69 = phi_195_;
        phi_196_ = _e69;
    }
    let _e71 = phi_196_;
    if (_e48 == _e51) {
        phi_202_ = (_e48 > 0.5f);
    } else {
        phi_202_ = false;
    }
    let _e75 = phi_202_;
    if _e75 {
        if (_e71 > 0f) {
            if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
                phi_226_ = _e48;
            } else {
                if (_e48 < 0f) {
                    phi_225_ = 0f;
                } else {
                    if (_e48 > 1f) {
                        phi_224_ = 1f;
                    } else {
                        phi_224_ = _e48;
                    }
                    let _e83 = phi_224_;
                    phi_225_ = _e83;
                }
                let _e85 = phi_225_;
                phi_226_ = _e85;
            }
            let _e87 = phi_226_;
            phi_227_ = _e87;
            phi_228_ = false;
        } else {
            phi_227_ = f32();
            phi_228_ = true;
        }
        let _e89 = phi_227_;
        let _e91 = phi_228_;
        phi_229_ = _e89;
        phi_230_ = _e91;
    } else {
        phi_229_ = f32();
        phi_230_ = true;
    }
    let _e93 = phi_229_;
    let _e95 = phi_230_;
    if _e95 {
        let _e96 = (_e55 / _e53);
        let _e97 = (_e71 - _e48);
        let _e103 = (((((_e71 * _e71) - _e49) - (_e96 * _e97)) * _e53) / (((_e51 - (_e49 * _e49)) * _e53) - (_e55 * _e55)));
        let _e106 = ((_e97 / _e53) - (_e96 * _e103));
        let _e112 = ((0.5f * _e106) / _e103);
        let _e115 = ((_e112 * _e112) - (((1f - (_e106 * _e48)) - (_e103 * _e49)) / _e103));
        if (_e115 >= 0f) {
            let _e117 = sqrt(_e115);
            phi_268_ = vec2<f32>((-(_e112) - _e117), (-(_e112) + _e117));
        } else {
            phi_268_ = vec2(bitcast<f32>((bitcast<u32>(_e115) | 2143289344u)));
        }
        let _e128 = phi_268_;
        if (_e71 <= _e128.x) {
            phi_341_ = 1f;
        } else {
            if (_e71 > _e128.y) {
                let _e141 = (((_e49 - (_e48 * (_e128.x + _e128.y))) + (_e128.x * _e128.y)) / ((_e71 - _e128.x) * (_e71 - _e128.y)));
                if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
                    phi_304_ = _e141;
                } else {
                    if (_e141 < 0f) {
                        phi_303_ = 0f;
                    } else {
                        if (_e141 > 1f) {
                            phi_302_ = 1f;
                        } else {
                            phi_302_ = _e141;
                        }
                        let _e148 = phi_302_;
                        phi_303_ = _e148;
                    }
                    let _e150 = phi_303_;
                    phi_304_ = _e150;
                }
                let _e152 = phi_304_;
                phi_340_ = _e152;
            } else {
                if (_e71 > _e128.x) {
                    let _e163 = (1f - (((_e49 - (_e48 * (_e71 + _e128.y))) + (_e71 * _e128.y)) / ((_e128.x - _e71) * (_e128.x - _e128.y))));
                    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
                        phi_335_ = _e163;
                    } else {
                        if (_e163 < 0f) {
                            phi_334_ = 0f;
                        } else {
                            if (_e163 > 1f) {
                                phi_333_ = 1f;
                            } else {
                                phi_333_ = _e163;
                            }
                            let _e170 = phi_333_;
                            phi_334_ = _e170;
                        }
                        let _e172 = phi_334_;
                        phi_335_ = _e172;
                    }
                    let _e174 = phi_335_;
                    phi_339_ = _e174;
                } else {
                    phi_339_ = bitcast<f32>((bitcast<u32>(_e128.x) | 2143289344u));
                }
                let _e179 = phi_339_;
                phi_340_ = _e179;
            }
            let _e181 = phi_340_;
            phi_341_ = _e181;
        }
        let _e183 = phi_341_;
        phi_342_ = _e183;
    } else {
        phi_342_ = _e93;
    }
    let _e185 = phi_342_;
    return _e185;
}

fn function_() {
    var local: f32;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_405_: bool;
    var phi_475_: bool;
    var phi_476_: bool;
    var phi_487_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_488_: bool;
    var phi_489_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_490_: bool;
    var phi_497_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_501_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_575_: bool;
    var phi_584_: bool;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_596_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_603_: bool;
    var phi_693_: f32;
    var phi_696_: f32;
    var phi_725_: f32;
    var phi_730_: f32;
    var phi_731_: bool;
    var phi_732_: f32;
    var phi_733_: bool;
    var phi_737_: f32;
    var phi_757_: f32;
    var phi_762_: f32;
    var phi_763_: bool;
    var phi_764_: f32;
    var phi_765_: bool;
    var phi_769_: f32;
    var phi_817_: i32;
    var phi_822_: i32;
    var phi_827_: i32;
    var phi_832_: i32;
    var phi_841_: i32;
    var phi_846_: i32;
    var phi_851_: i32;
    var phi_856_: i32;
    var phi_951_: bool;
    var phi_959_: bool;
    var phi_971_: bool;
    var phi_972_: bool;
    var phi_976_: f32;
    var phi_982_: f32;
    var phi_984_: evaluate_Verdict;
    var phi_989_: evaluate_Verdict;
    var phi_990_: evaluate_Verdict;

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
                phi_398_ = (_e75 == _e77);
                phi_399_ = false;
            } else {
                phi_398_ = bool();
                phi_399_ = true;
            }
            let _e80 = phi_398_;
            let _e82 = phi_399_;
            phi_400_ = _e80;
            phi_401_ = _e82;
        } else {
            phi_400_ = bool();
            phi_401_ = true;
        }
        let _e84 = phi_400_;
        let _e86 = phi_401_;
        if _e86 {
            phi_405_ = false;
        } else {
            phi_405_ = _e84;
        }
        let _e88 = phi_405_;
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
                    phi_476_ = true;
                } else {
                    let _e141 = p.member.light.range_squared;
                    if (_e124 <= _e141) {
                        let _e144 = p.member.light.cos_outer;
                        phi_475_ = (-((((_e106 * _e126.x) + (_e107 * _e126.y)) + (_e108 * _e126.z))) >= (_e144 * sqrt(_e124)));
                    } else {
                        phi_475_ = false;
                    }
                    let _e149 = phi_475_;
                    phi_476_ = _e149;
                }
                let _e151 = phi_476_;
                if _e151 {
                    let _e153 = samples.member[(0u + _e51.first_primitive)].flags;
                    let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                    phi_487_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, ((_e153 & 1u) == 0u));
                    phi_488_ = false;
                } else {
                    phi_487_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_488_ = true;
                }
                let _e172 = phi_487_;
                let _e174 = phi_488_;
                phi_489_ = _e172;
                phi_490_ = _e174;
            } else {
                phi_489_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_490_ = true;
            }
            let _e176 = phi_489_;
            let _e178 = phi_490_;
            if _e178 {
                let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
                phi_497_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, true);
            } else {
                phi_497_ = _e176;
            }
            let _e195 = phi_497_;
            phi_501_ = _e195;
        } else {
            let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
            phi_501_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
        }
        let _e212 = phi_501_;
        if _e212.unnamed_1 {
            phi_990_ = evaluate_Verdict(_e212.unnamed.visibility, _e212.unnamed.is_doubted);
        } else {
            let _e220 = samples.member[(0u + _e51.first_primitive)].position;
            let _e238 = ((((_e61.projection.row_w.x * _e220.x) + (_e61.projection.row_w.y * _e220.y)) + (_e61.projection.row_w.z * _e220.z)) + (_e61.projection.row_w.w * 1f));
            let _e252 = (((((_e61.projection.row_x.x * _e220.x) + (_e61.projection.row_x.y * _e220.y)) + (_e61.projection.row_x.z * _e220.z)) + (_e61.projection.row_x.w * 1f)) / _e238);
            let _e266 = (((((_e61.projection.row_y.x * _e220.x) + (_e61.projection.row_y.y * _e220.y)) + (_e61.projection.row_y.z * _e220.z)) + (_e61.projection.row_y.w * 1f)) / _e238);
            let _e279 = ((((_e61.projection.row_z.x * _e220.x) + (_e61.projection.row_z.y * _e220.y)) + (_e61.projection.row_z.z * _e220.z)) + (_e61.projection.row_z.w * 1f));
            if (_e238 > 0f) {
                if (_e252 >= 0f) {
                    phi_575_ = (_e252 <= 1f);
                } else {
                    phi_575_ = false;
                }
                let _e284 = phi_575_;
                if _e284 {
                    if (_e266 >= 0f) {
                        phi_584_ = (_e266 <= 1f);
                    } else {
                        phi_584_ = false;
                    }
                    let _e288 = phi_584_;
                    if _e288 {
                        if (_e279 >= 0f) {
                            phi_593_ = (_e279 <= 1f);
                        } else {
                            phi_593_ = false;
                        }
                        let _e292 = phi_593_;
                        phi_594_ = _e292;
                        phi_595_ = false;
                    } else {
                        phi_594_ = bool();
                        phi_595_ = true;
                    }
                    let _e294 = phi_594_;
                    let _e296 = phi_595_;
                    phi_596_ = _e294;
                    phi_597_ = _e296;
                } else {
                    phi_596_ = bool();
                    phi_597_ = true;
                }
                let _e298 = phi_596_;
                let _e300 = phi_597_;
                phi_598_ = _e298;
                phi_599_ = _e300;
            } else {
                phi_598_ = bool();
                phi_599_ = true;
            }
            let _e302 = phi_598_;
            let _e304 = phi_599_;
            if _e304 {
                phi_603_ = false;
            } else {
                phi_603_ = _e302;
            }
            let _e306 = phi_603_;
            if _e306 {
                if (0f > 0f) {
                    let _e309 = samples.member[(0u + _e51.first_primitive)].normal;
                    let _e311 = p.member.map_size;
                    let _e381 = ((abs(((((_e57.row_x.x * _e309.x) + (_e57.row_x.y * _e309.y)) + (_e57.row_x.z * _e309.z)) / (((_e57.row_x.x * _e57.row_x.x) + (_e57.row_x.y * _e57.row_x.y)) + (_e57.row_x.z * _e57.row_x.z)))) + abs(((((_e57.row_y.x * _e309.x) + (_e57.row_y.y * _e309.y)) + (_e57.row_y.z * _e309.z)) / (((_e57.row_y.x * _e57.row_y.x) + (_e57.row_y.y * _e57.row_y.y)) + (_e57.row_y.z * _e57.row_y.z))))) / (abs(((((_e57.row_z.x * _e309.x) + (_e57.row_z.y * _e309.y)) + (_e57.row_z.z * _e309.z)) / (((_e57.row_z.x * _e57.row_z.x) + (_e57.row_z.y * _e57.row_z.y)) + (_e57.row_z.z * _e57.row_z.z)))) * f32(_e311)));
                    if (_e381 < 0.002f) {
                        phi_693_ = _e381;
                    } else {
                        phi_693_ = 0.002f;
                    }
                    let _e384 = phi_693_;
                    phi_696_ = (_e279 - (0f * _e384));
                } else {
                    phi_696_ = _e279;
                }
                let _e388 = phi_696_;
                let _e390 = p.member.map_size;
                let _e391 = f32(_e390);
                let _e394 = ((_e252 * _e391) - 0.5f);
                let _e395 = ((_e266 * _e391) - 0.5f);
                if (_e394 > -8388608f) {
                    let _e407 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e407 > _e394) {
                        phi_725_ = 1f;
                    } else {
                        phi_725_ = 0f;
                    }
                    let _e410 = phi_725_;
                    if (_e394 < 8388608f) {
                        phi_730_ = (_e407 - _e410);
                        phi_731_ = false;
                    } else {
                        phi_730_ = f32();
                        phi_731_ = true;
                    }
                    let _e413 = phi_730_;
                    let _e415 = phi_731_;
                    phi_732_ = _e413;
                    phi_733_ = _e415;
                } else {
                    phi_732_ = f32();
                    phi_733_ = true;
                }
                let _e417 = phi_732_;
                let _e419 = phi_733_;
                if _e419 {
                    phi_737_ = _e394;
                } else {
                    phi_737_ = _e417;
                }
                let _e421 = phi_737_;
                if (_e395 > -8388608f) {
                    let _e433 = f32(select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < bitcast<f32>(3472883712u))), 2147483647i, (_e395 > bitcast<f32>(1325400063u))), (_e395 == _e395)));
                    if (_e433 > _e395) {
                        phi_757_ = 1f;
                    } else {
                        phi_757_ = 0f;
                    }
                    let _e436 = phi_757_;
                    if (_e395 < 8388608f) {
                        phi_762_ = (_e433 - _e436);
                        phi_763_ = false;
                    } else {
                        phi_762_ = f32();
                        phi_763_ = true;
                    }
                    let _e439 = phi_762_;
                    let _e441 = phi_763_;
                    phi_764_ = _e439;
                    phi_765_ = _e441;
                } else {
                    phi_764_ = f32();
                    phi_765_ = true;
                }
                let _e443 = phi_764_;
                let _e445 = phi_765_;
                if _e445 {
                    phi_769_ = _e395;
                } else {
                    phi_769_ = _e443;
                }
                let _e447 = phi_769_;
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
                    phi_817_ = _e458;
                } else {
                    phi_817_ = 0i;
                }
                let _e487 = phi_817_;
                if (_e467 > 0i) {
                    phi_822_ = _e467;
                } else {
                    phi_822_ = 0i;
                }
                let _e490 = phi_822_;
                if (_e487 < _e484) {
                    phi_827_ = _e487;
                } else {
                    phi_827_ = _e484;
                }
                let _e493 = phi_827_;
                if (_e490 < _e484) {
                    phi_832_ = _e490;
                } else {
                    phi_832_ = _e484;
                }
                let _e496 = phi_832_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e458 + 1i);
                let _e500 = (_e467 + 1i);
                if (_e499 > 0i) {
                    phi_841_ = _e499;
                } else {
                    phi_841_ = 0i;
                }
                let _e503 = phi_841_;
                if (_e500 > 0i) {
                    phi_846_ = _e500;
                } else {
                    phi_846_ = 0i;
                }
                let _e506 = phi_846_;
                if (_e503 < _e484) {
                    phi_851_ = _e503;
                } else {
                    phi_851_ = _e484;
                }
                let _e509 = phi_851_;
                if (_e506 < _e484) {
                    phi_856_ = _e506;
                } else {
                    phi_856_ = _e484;
                }
                let _e512 = phi_856_;
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
                let _e588 = p.member.epsilon;
                if (_e586 <= _e588) {
                    phi_951_ = true;
                } else {
                    phi_951_ = (_e586 >= (1f - _e588));
                }
                let _e593 = phi_951_;
                if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                    phi_959_ = true;
                } else {
                    phi_959_ = !(_e593);
                }
                let _e599 = phi_959_;
                if _e599 {
                    if (_e586 > 0f) {
                        if (_e586 < 1f) {
                            phi_971_ = false;
                        } else {
                            phi_971_ = true;
                        }
                        let _e603 = phi_971_;
                        phi_972_ = _e603;
                    } else {
                        phi_972_ = true;
                    }
                    let _e605 = phi_972_;
                    if _e605 {
                        phi_976_ = 0.5f;
                    } else {
                        phi_976_ = _e586;
                    }
                    let _e607 = phi_976_;
                    phi_984_ = evaluate_Verdict(_e607, true);
                } else {
                    if (_e586 > 0.5f) {
                        phi_982_ = 1f;
                    } else {
                        phi_982_ = 0f;
                    }
                    let _e611 = phi_982_;
                    phi_984_ = evaluate_Verdict(_e611, false);
                }
                let _e614 = phi_984_;
                phi_989_ = evaluate_Verdict(_e614.visibility, _e614.is_doubted);
            } else {
                phi_989_ = evaluate_Verdict(0.5f, true);
            }
            let _e620 = phi_989_;
            phi_990_ = _e620;
        }
        let _e622 = phi_990_;
        if (_e51.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e51.first_primitive)] = _e622.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
