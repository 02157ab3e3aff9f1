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

struct type_50 {
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
var<storage, read_write> list: type_50;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_176_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_168_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_169_ = false;
        } else {
            phi_168_ = lt_bvh_traverse_Tree();
            phi_169_ = true;
        }
        let _e67 = phi_168_;
        let _e69 = phi_169_;
        phi_170_ = _e67;
        phi_171_ = _e69;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e71 = phi_170_;
    let _e73 = phi_171_;
    if _e73 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e71;
    }
    let _e78 = phi_176_;
    return lt_bvh_traverse_Tree(_e78.root, _e78.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_216_: bool;
    var phi_220_: f32;
    var phi_233_: f32;
    var phi_238_: f32;
    var phi_260_: f32;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_267_: f32;
    var phi_268_: bool;
    var phi_272_: f32;
    var phi_310_: f32;
    var phi_326_: f32;
    var phi_327_: f32;
    var phi_328_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_203_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_202_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_201_ = 1f;
            } else {
                phi_201_ = param_6;
            }
            let _e63 = phi_201_;
            phi_202_ = _e63;
        }
        let _e65 = phi_202_;
        phi_203_ = _e65;
    }
    let _e67 = phi_203_;
    let _e69 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_216_ = true;
    } else {
        let _e73 = (84f < _e69);
        if _e73 {
        }
        phi_216_ = _e73;
    }
    let _e75 = phi_216_;
    if _e75 {
        phi_220_ = 84f;
    } else {
        phi_220_ = _e69;
    }
    let _e77 = phi_220_;
    let _e79 = (_e77 * (1f - _e67));
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_310_ = _e79;
    } else {
        if (_e79 < -87f) {
            phi_233_ = -87f;
        } else {
            phi_233_ = _e79;
        }
        let _e85 = phi_233_;
        if (_e85 > 88f) {
            phi_238_ = 88f;
        } else {
            phi_238_ = _e85;
        }
        let _e88 = phi_238_;
        let _e90 = ((_e88 * 1.442695f) + 0.5f);
        if (_e90 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)));
            if (_e102 > _e90) {
                phi_260_ = 1f;
            } else {
                phi_260_ = 0f;
            }
            let _e105 = phi_260_;
            if (_e90 < 8388608f) {
                phi_265_ = (_e102 - _e105);
                phi_266_ = false;
            } else {
                phi_265_ = f32();
                phi_266_ = true;
            }
            let _e108 = phi_265_;
            let _e110 = phi_266_;
            phi_267_ = _e108;
            phi_268_ = _e110;
        } else {
            phi_267_ = f32();
            phi_268_ = true;
        }
        let _e112 = phi_267_;
        let _e114 = phi_268_;
        if _e114 {
            phi_272_ = _e90;
        } else {
            phi_272_ = _e112;
        }
        let _e116 = phi_272_;
        let _e120 = ((_e88 - (_e116 * 0.69314575f)) - (_e116 * 0.0000014286068f));
        phi_310_ = ((((((((((((((((1f / 5040f) * _e120) + (1f / 720f)) * _e120) + (1f / 120f)) * _e120) + (1f / 24f)) * _e120) + (1f / 6f)) * _e120) + 0.5f) * _e120) + 1f) * _e120) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e156 = phi_310_;
    let _e157 = (param_5.x * _e156);
    if ((bitcast<u32>(_e157) & 2147483647u) > 2139095040u) {
        phi_328_ = _e157;
    } else {
        if (_e157 < 0f) {
            phi_327_ = 0f;
        } else {
            if (_e157 > 1f) {
                phi_326_ = 1f;
            } else {
                phi_326_ = _e157;
            }
            let _e164 = phi_326_;
            phi_327_ = _e164;
        }
        let _e166 = phi_327_;
        phi_328_ = _e166;
    }
    let _e168 = phi_328_;
    return _e168;
}

fn function_() {
    var local_1: f32;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_386_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_468_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_469_: bool;
    var phi_470_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_471_: bool;
    var phi_478_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_482_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_556_: bool;
    var phi_565_: bool;
    var phi_574_: bool;
    var phi_575_: bool;
    var phi_576_: bool;
    var phi_577_: bool;
    var phi_578_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_584_: bool;
    var phi_674_: f32;
    var phi_677_: f32;
    var phi_706_: f32;
    var phi_711_: f32;
    var phi_712_: bool;
    var phi_713_: f32;
    var phi_714_: bool;
    var phi_718_: f32;
    var phi_738_: f32;
    var phi_743_: f32;
    var phi_744_: bool;
    var phi_745_: f32;
    var phi_746_: bool;
    var phi_750_: f32;
    var phi_798_: i32;
    var phi_803_: i32;
    var phi_808_: i32;
    var phi_813_: i32;
    var phi_822_: i32;
    var phi_827_: i32;
    var phi_832_: i32;
    var phi_837_: i32;
    var phi_934_: bool;
    var phi_942_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_959_: f32;
    var phi_965_: f32;
    var phi_967_: evaluate_Verdict;
    var phi_977_: u32;
    var phi_986_: f32;
    var phi_988_: evaluate_Verdict;
    var phi_989_: bool;
    var phi_990_: evaluate_Verdict;
    var phi_991_: bool;
    var phi_996_: evaluate_Verdict;
    var phi_1001_: evaluate_Verdict;
    var phi_1002_: evaluate_Verdict;
    var phi_1006_: bool;
    var phi_1007_: u32;
    var phi_1018_: u32;
    var phi_1035_: u32;

    let _e55 = id_1;
    let _e56 = local_2;
    let _e61 = arrayLength((&map.member));
    let _e66 = p.member.size[0u];
    let _e68 = p.member.size[1u];
    let _e69 = lt_shaders_entry_pixel_index(_e55, _e66, _e68);
    if (bitcast<i32>(_e69.root) != 0i) {
        let _e76 = p.member.projection;
        let _e77 = lt_math_OneLevel(_e76);
        let _e81 = samples.member[_e69.first_primitive].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[_e69.first_primitive].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[_e69.first_primitive].normal[2u];
                let _e93 = global[2u];
                phi_379_ = (_e91 == _e93);
                phi_380_ = false;
            } else {
                phi_379_ = bool();
                phi_380_ = true;
            }
            let _e96 = phi_379_;
            let _e98 = phi_380_;
            phi_381_ = _e96;
            phi_382_ = _e98;
        } else {
            phi_381_ = bool();
            phi_382_ = true;
        }
        let _e100 = phi_381_;
        let _e102 = phi_382_;
        if _e102 {
            phi_386_ = false;
        } else {
            phi_386_ = _e100;
        }
        let _e104 = phi_386_;
        if !(_e104) {
            let _e107 = samples.member[_e69.first_primitive].position;
            let _e109 = p.member.light.place;
            let _e115 = p.member.light.place[3u];
            let _e122 = (_e109.x - (_e107.x * _e115));
            let _e123 = (_e109.y - (_e107.y * _e115));
            let _e124 = (_e109.z - (_e107.z * _e115));
            let _e126 = samples.member[_e69.first_primitive].normal;
            if ((((_e126.x * _e122) + (_e126.y * _e123)) + (_e126.z * _e124)) > 0f) {
                let _e140 = (((_e122 * _e122) + (_e123 * _e123)) + (_e124 * _e124));
                let _e142 = p.member.light.axis;
                let _e154 = p.member.light.place[3u];
                if (_e154 == 0f) {
                    phi_457_ = true;
                } else {
                    let _e157 = p.member.light.range_squared;
                    if (_e140 <= _e157) {
                        let _e160 = p.member.light.cos_outer;
                        phi_456_ = (-((((_e122 * _e142.x) + (_e123 * _e142.y)) + (_e124 * _e142.z))) >= (_e160 * sqrt(_e140)));
                    } else {
                        phi_456_ = false;
                    }
                    let _e165 = phi_456_;
                    phi_457_ = _e165;
                }
                let _e167 = phi_457_;
                if _e167 {
                    let _e169 = samples.member[_e69.first_primitive].flags;
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
                    phi_468_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, ((_e169 & 1u) == 0u));
                    phi_469_ = false;
                } else {
                    phi_468_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_469_ = true;
                }
                let _e188 = phi_468_;
                let _e190 = phi_469_;
                phi_470_ = _e188;
                phi_471_ = _e190;
            } else {
                phi_470_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_471_ = true;
            }
            let _e192 = phi_470_;
            let _e194 = phi_471_;
            if _e194 {
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
                phi_478_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
            } else {
                phi_478_ = _e192;
            }
            let _e211 = phi_478_;
            phi_482_ = _e211;
        } else {
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
            phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
        }
        let _e228 = phi_482_;
        if _e228.unnamed_1 {
            phi_1002_ = evaluate_Verdict(_e228.unnamed.visibility, _e228.unnamed.is_doubted);
        } else {
            let _e236 = samples.member[_e69.first_primitive].position;
            let _e254 = ((((_e77.projection.row_w.x * _e236.x) + (_e77.projection.row_w.y * _e236.y)) + (_e77.projection.row_w.z * _e236.z)) + (_e77.projection.row_w.w * 1f));
            let _e268 = (((((_e77.projection.row_x.x * _e236.x) + (_e77.projection.row_x.y * _e236.y)) + (_e77.projection.row_x.z * _e236.z)) + (_e77.projection.row_x.w * 1f)) / _e254);
            let _e282 = (((((_e77.projection.row_y.x * _e236.x) + (_e77.projection.row_y.y * _e236.y)) + (_e77.projection.row_y.z * _e236.z)) + (_e77.projection.row_y.w * 1f)) / _e254);
            let _e295 = ((((_e77.projection.row_z.x * _e236.x) + (_e77.projection.row_z.y * _e236.y)) + (_e77.projection.row_z.z * _e236.z)) + (_e77.projection.row_z.w * 1f));
            if (_e254 > 0f) {
                if (_e268 >= 0f) {
                    phi_556_ = (_e268 <= 1f);
                } else {
                    phi_556_ = false;
                }
                let _e300 = phi_556_;
                if _e300 {
                    if (_e282 >= 0f) {
                        phi_565_ = (_e282 <= 1f);
                    } else {
                        phi_565_ = false;
                    }
                    let _e304 = phi_565_;
                    if _e304 {
                        if (_e295 >= 0f) {
                            phi_574_ = (_e295 <= 1f);
                        } else {
                            phi_574_ = false;
                        }
                        let _e308 = phi_574_;
                        phi_575_ = _e308;
                        phi_576_ = false;
                    } else {
                        phi_575_ = bool();
                        phi_576_ = true;
                    }
                    let _e310 = phi_575_;
                    let _e312 = phi_576_;
                    phi_577_ = _e310;
                    phi_578_ = _e312;
                } else {
                    phi_577_ = bool();
                    phi_578_ = true;
                }
                let _e314 = phi_577_;
                let _e316 = phi_578_;
                phi_579_ = _e314;
                phi_580_ = _e316;
            } else {
                phi_579_ = bool();
                phi_580_ = true;
            }
            let _e318 = phi_579_;
            let _e320 = phi_580_;
            if _e320 {
                phi_584_ = false;
            } else {
                phi_584_ = _e318;
            }
            let _e322 = phi_584_;
            if _e322 {
                if (0f > 0f) {
                    let _e325 = samples.member[_e69.first_primitive].normal;
                    let _e327 = p.member.map_size;
                    let _e397 = ((abs(((((_e76.row_x.x * _e325.x) + (_e76.row_x.y * _e325.y)) + (_e76.row_x.z * _e325.z)) / (((_e76.row_x.x * _e76.row_x.x) + (_e76.row_x.y * _e76.row_x.y)) + (_e76.row_x.z * _e76.row_x.z)))) + abs(((((_e76.row_y.x * _e325.x) + (_e76.row_y.y * _e325.y)) + (_e76.row_y.z * _e325.z)) / (((_e76.row_y.x * _e76.row_y.x) + (_e76.row_y.y * _e76.row_y.y)) + (_e76.row_y.z * _e76.row_y.z))))) / (abs(((((_e76.row_z.x * _e325.x) + (_e76.row_z.y * _e325.y)) + (_e76.row_z.z * _e325.z)) / (((_e76.row_z.x * _e76.row_z.x) + (_e76.row_z.y * _e76.row_z.y)) + (_e76.row_z.z * _e76.row_z.z)))) * f32(_e327)));
                    if (_e397 < 0.002f) {
                        phi_674_ = _e397;
                    } else {
                        phi_674_ = 0.002f;
                    }
                    let _e400 = phi_674_;
                    phi_677_ = (_e295 - (0f * _e400));
                } else {
                    phi_677_ = _e295;
                }
                let _e404 = phi_677_;
                let _e406 = p.member.map_size;
                let _e407 = f32(_e406);
                let _e410 = ((_e268 * _e407) - 0.5f);
                let _e411 = ((_e282 * _e407) - 0.5f);
                if (_e410 > -8388608f) {
                    let _e423 = f32(select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < bitcast<f32>(3472883712u))), 2147483647i, (_e410 > bitcast<f32>(1325400063u))), (_e410 == _e410)));
                    if (_e423 > _e410) {
                        phi_706_ = 1f;
                    } else {
                        phi_706_ = 0f;
                    }
                    let _e426 = phi_706_;
                    if (_e410 < 8388608f) {
                        phi_711_ = (_e423 - _e426);
                        phi_712_ = false;
                    } else {
                        phi_711_ = f32();
                        phi_712_ = true;
                    }
                    let _e429 = phi_711_;
                    let _e431 = phi_712_;
                    phi_713_ = _e429;
                    phi_714_ = _e431;
                } else {
                    phi_713_ = f32();
                    phi_714_ = true;
                }
                let _e433 = phi_713_;
                let _e435 = phi_714_;
                if _e435 {
                    phi_718_ = _e410;
                } else {
                    phi_718_ = _e433;
                }
                let _e437 = phi_718_;
                if (_e411 > -8388608f) {
                    let _e449 = f32(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < bitcast<f32>(3472883712u))), 2147483647i, (_e411 > bitcast<f32>(1325400063u))), (_e411 == _e411)));
                    if (_e449 > _e411) {
                        phi_738_ = 1f;
                    } else {
                        phi_738_ = 0f;
                    }
                    let _e452 = phi_738_;
                    if (_e411 < 8388608f) {
                        phi_743_ = (_e449 - _e452);
                        phi_744_ = false;
                    } else {
                        phi_743_ = f32();
                        phi_744_ = true;
                    }
                    let _e455 = phi_743_;
                    let _e457 = phi_744_;
                    phi_745_ = _e455;
                    phi_746_ = _e457;
                } else {
                    phi_745_ = f32();
                    phi_746_ = true;
                }
                let _e459 = phi_745_;
                let _e461 = phi_746_;
                if _e461 {
                    phi_750_ = _e411;
                } else {
                    phi_750_ = _e459;
                }
                let _e463 = phi_750_;
                let _e464 = (_e410 - _e437);
                let _e465 = (_e411 - _e463);
                let _e474 = select(0i, select(select(i32(_e437), i32(-2147483648), (_e437 < bitcast<f32>(3472883712u))), 2147483647i, (_e437 > bitcast<f32>(1325400063u))), (_e437 == _e437));
                let _e483 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < bitcast<f32>(3472883712u))), 2147483647i, (_e463 > bitcast<f32>(1325400063u))), (_e463 == _e463));
                let _e486 = ((1f - _e464) * (1f - _e465));
                let _e488 = (_e464 * (1f - _e465));
                let _e490 = ((1f - _e464) * _e465);
                let _e491 = (_e464 * _e465);
                let _e493 = p.member.test;
                let _e494 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e493);
                let _e496 = p.member.map_size;
                local_1 = _e494;
                let _e498 = ((0u * _e496) * _e496);
                let _e500 = (bitcast<i32>(_e496) - 1i);
                if (_e474 > 0i) {
                    phi_798_ = _e474;
                } else {
                    phi_798_ = 0i;
                }
                let _e503 = phi_798_;
                if (_e483 > 0i) {
                    phi_803_ = _e483;
                } else {
                    phi_803_ = 0i;
                }
                let _e506 = phi_803_;
                if (_e503 < _e500) {
                    phi_808_ = _e503;
                } else {
                    phi_808_ = _e500;
                }
                let _e509 = phi_808_;
                if (_e506 < _e500) {
                    phi_813_ = _e506;
                } else {
                    phi_813_ = _e500;
                }
                let _e512 = phi_813_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (_e474 + 1i);
                let _e516 = (_e483 + 1i);
                if (_e515 > 0i) {
                    phi_822_ = _e515;
                } else {
                    phi_822_ = 0i;
                }
                let _e519 = phi_822_;
                if (_e516 > 0i) {
                    phi_827_ = _e516;
                } else {
                    phi_827_ = 0i;
                }
                let _e522 = phi_827_;
                if (_e519 < _e500) {
                    phi_832_ = _e519;
                } else {
                    phi_832_ = _e500;
                }
                let _e525 = phi_832_;
                if (_e522 < _e500) {
                    phi_837_ = _e522;
                } else {
                    phi_837_ = _e500;
                }
                let _e528 = phi_837_;
                let _e529 = bitcast<u32>(_e525);
                let _e531 = (bitcast<u32>(_e512) * _e496);
                let _e532 = (bitcast<u32>(_e528) * _e496);
                let _e537 = ((_e531 + _e513) + _e498);
                let _e538 = ((_e531 + _e529) + _e498);
                let _e539 = ((_e532 + _e513) + _e498);
                let _e540 = ((_e532 + _e529) + _e498);
                if (_e537 < _e61) {
                } else {
                    return;
                }
                let _e544 = map.member[(0u + _e537)];
                if (_e538 < _e61) {
                } else {
                    return;
                }
                let _e556 = map.member[(0u + _e538)];
                if (_e539 < _e61) {
                } else {
                    return;
                }
                let _e572 = map.member[(0u + _e539)];
                if (_e540 < _e61) {
                } else {
                    return;
                }
                let _e588 = map.member[(0u + _e540)];
                let _e602 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e544.x * _e486) + (_e556.x * _e488)) + (_e572.x * _e490)) + (_e588.x * _e491)), ((((_e544.y * _e486) + (_e556.y * _e488)) + (_e572.y * _e490)) + (_e588.y * _e491)), ((((_e544.z * _e486) + (_e556.z * _e488)) + (_e572.z * _e490)) + (_e588.z * _e491)), ((((_e544.w * _e486) + (_e556.w * _e488)) + (_e572.w * _e490)) + (_e588.w * _e491))), _e404);
                let _e606 = p.member.epsilon;
                if (_e602 <= _e606) {
                    phi_934_ = true;
                } else {
                    phi_934_ = (_e602 >= (1f - _e606));
                }
                let _e611 = phi_934_;
                if ((bitcast<u32>(_e602) & 2147483647u) > 2139095040u) {
                    phi_942_ = true;
                } else {
                    phi_942_ = !(_e611);
                }
                let _e617 = phi_942_;
                if _e617 {
                    if (_e602 > 0f) {
                        if (_e602 < 1f) {
                            phi_954_ = false;
                        } else {
                            phi_954_ = true;
                        }
                        let _e621 = phi_954_;
                        phi_955_ = _e621;
                    } else {
                        phi_955_ = true;
                    }
                    let _e623 = phi_955_;
                    if _e623 {
                        phi_959_ = 0.5f;
                    } else {
                        phi_959_ = _e602;
                    }
                    let _e625 = phi_959_;
                    phi_967_ = evaluate_Verdict(_e625, true);
                } else {
                    if (_e602 > 0.5f) {
                        phi_965_ = 1f;
                    } else {
                        phi_965_ = 0f;
                    }
                    let _e629 = phi_965_;
                    phi_967_ = evaluate_Verdict(_e629, false);
                }
                let _e632 = phi_967_;
                let _e635 = (_e632.visibility < 0.5f);
                if _e632.is_doubted {
                    phi_990_ = evaluate_Verdict();
                    phi_991_ = true;
                } else {
                    if _e635 {
                        phi_977_ = 2u;
                    } else {
                        phi_977_ = 1u;
                    }
                    let _e637 = phi_977_;
                    if ((0u & _e637) != 0u) {
                        if _e635 {
                            phi_986_ = 0.000000059604645f;
                        } else {
                            phi_986_ = 0.99999994f;
                        }
                        let _e641 = phi_986_;
                        phi_988_ = evaluate_Verdict(_e641, true);
                        phi_989_ = false;
                    } else {
                        phi_988_ = evaluate_Verdict();
                        phi_989_ = true;
                    }
                    let _e644 = phi_988_;
                    let _e646 = phi_989_;
                    phi_990_ = _e644;
                    phi_991_ = _e646;
                }
                let _e648 = phi_990_;
                let _e650 = phi_991_;
                if _e650 {
                    phi_996_ = evaluate_Verdict(_e632.visibility, _e632.is_doubted);
                } else {
                    phi_996_ = _e648;
                }
                let _e653 = phi_996_;
                phi_1001_ = evaluate_Verdict(_e653.visibility, _e653.is_doubted);
            } else {
                phi_1001_ = evaluate_Verdict(0.5f, true);
            }
            let _e659 = phi_1001_;
            phi_1002_ = _e659;
        }
        let _e661 = phi_1002_;
        visibility.member[_e69.first_primitive] = _e661.visibility;
        phi_1006_ = _e661.is_doubted;
        phi_1007_ = _e69.first_primitive;
    } else {
        phi_1006_ = false;
        phi_1007_ = 0u;
    }
    let _e666 = phi_1006_;
    let _e668 = phi_1007_;
    if (_e56 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e666 {
        let _e672 = atomicAdd((&shared_[0u]), 1u);
        phi_1018_ = _e672;
    } else {
        phi_1018_ = 0u;
    }
    let _e674 = phi_1018_;
    workgroupBarrier();
    if (_e56 == 0u) {
        let _e678 = atomicLoad((&shared_[0u]));
        let _e679 = atomicAdd((&list.member[3u]), _e678);
        atomicStore((&shared_[1u]), _e679);
    }
    workgroupBarrier();
    if _e666 {
        if false {
            phi_1035_ = (_e668 | 2147483648u);
        } else {
            phi_1035_ = _e668;
        }
        let _e683 = phi_1035_;
        let _e685 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e685) + _e674)]), _e683);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
