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
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_136_: lt_bvh_traverse_Tree;
    var phi_137_: bool;
    var phi_142_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_134_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_135_ = false;
        } else {
            phi_134_ = lt_bvh_traverse_Tree();
            phi_135_ = true;
        }
        let _e58 = phi_134_;
        let _e60 = phi_135_;
        phi_136_ = _e58;
        phi_137_ = _e60;
    } else {
        phi_136_ = lt_bvh_traverse_Tree();
        phi_137_ = true;
    }
    let _e62 = phi_136_;
    let _e64 = phi_137_;
    if _e64 {
        phi_142_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_142_ = _e62;
    }
    let _e69 = phi_142_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_168_: bool;
    var phi_172_: f32;
    var phi_173_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(_e46) & 2147483647u) > 2139095040u) {
        phi_173_ = _e46;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_168_ = true;
        } else {
            let _e53 = (84f < _e46);
            if _e53 {
            }
            phi_168_ = _e53;
        }
        let _e55 = phi_168_;
        if _e55 {
            phi_172_ = 84f;
        } else {
            phi_172_ = _e46;
        }
        let _e57 = phi_172_;
        phi_173_ = _e57;
    }
    let _e59 = phi_173_;
    return _e59;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_632_: f32;
    var phi_648_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_663_: f32;
    var phi_668_: f32;
    var phi_690_: f32;
    var phi_695_: f32;
    var phi_696_: bool;
    var phi_697_: f32;
    var phi_698_: bool;
    var phi_702_: f32;
    var phi_740_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_758_: f32;
    var phi_771_: f32;
    var phi_776_: f32;
    var phi_798_: f32;
    var phi_803_: f32;
    var phi_804_: bool;
    var phi_805_: f32;
    var phi_806_: bool;
    var phi_810_: f32;
    var phi_848_: f32;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_866_: f32;
    var phi_879_: f32;
    var phi_884_: f32;
    var phi_906_: f32;
    var phi_911_: f32;
    var phi_912_: bool;
    var phi_913_: f32;
    var phi_914_: bool;
    var phi_918_: f32;
    var phi_956_: f32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_974_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_1014_: f32;
    var phi_1019_: f32;
    var phi_1020_: bool;
    var phi_1021_: f32;
    var phi_1022_: bool;
    var phi_1026_: f32;
    var phi_1064_: f32;
    var phi_1090_: f32;
    var phi_1091_: f32;
    var phi_1092_: f32;

    let _e49 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_632_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_631_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_630_ = 1f;
            } else {
                phi_630_ = param_8;
            }
            let _e56 = phi_630_;
            phi_631_ = _e56;
        }
        let _e58 = phi_631_;
        phi_632_ = _e58;
    }
    let _e60 = phi_632_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_650_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_649_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_648_ = 1f;
            } else {
                phi_648_ = param_6.x;
            }
            let _e68 = phi_648_;
            phi_649_ = _e68;
        }
        let _e70 = phi_649_;
        phi_650_ = _e70;
    }
    let _e72 = phi_650_;
    let _e74 = (_e49 * (_e72 - _e60));
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_740_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_663_ = -87f;
        } else {
            phi_663_ = _e74;
        }
        let _e80 = phi_663_;
        if (_e80 > 88f) {
            phi_668_ = 88f;
        } else {
            phi_668_ = _e80;
        }
        let _e83 = phi_668_;
        let _e85 = ((_e83 * 1.442695f) + 0.5f);
        if (_e85 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(_e85), i32(-2147483648), (_e85 < bitcast<f32>(3472883712u))), 2147483647i, (_e85 > bitcast<f32>(1325400063u))), (_e85 == _e85)));
            if (_e97 > _e85) {
                phi_690_ = 1f;
            } else {
                phi_690_ = 0f;
            }
            let _e100 = phi_690_;
            if (_e85 < 8388608f) {
                phi_695_ = (_e97 - _e100);
                phi_696_ = false;
            } else {
                phi_695_ = f32();
                phi_696_ = true;
            }
            let _e103 = phi_695_;
            let _e105 = phi_696_;
            phi_697_ = _e103;
            phi_698_ = _e105;
        } else {
            phi_697_ = f32();
            phi_698_ = true;
        }
        let _e107 = phi_697_;
        let _e109 = phi_698_;
        if _e109 {
            phi_702_ = _e85;
        } else {
            phi_702_ = _e107;
        }
        let _e111 = phi_702_;
        let _e115 = ((_e83 - (_e111 * 0.69314575f)) - (_e111 * 0.0000014286068f));
        phi_740_ = ((((((((((((((((1f / 5040f) * _e115) + (1f / 720f)) * _e115) + (1f / 120f)) * _e115) + (1f / 24f)) * _e115) + (1f / 6f)) * _e115) + 0.5f) * _e115) + 1f) * _e115) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < bitcast<f32>(3472883712u))), 2147483647i, (_e111 > bitcast<f32>(1325400063u))), (_e111 == _e111)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e151 = phi_740_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_758_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_757_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_756_ = 1f;
            } else {
                phi_756_ = param_6.y;
            }
            let _e159 = phi_756_;
            phi_757_ = _e159;
        }
        let _e161 = phi_757_;
        phi_758_ = _e161;
    }
    let _e163 = phi_758_;
    let _e165 = (_e49 * (_e163 - _e60));
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_848_ = _e165;
    } else {
        if (_e165 < -87f) {
            phi_771_ = -87f;
        } else {
            phi_771_ = _e165;
        }
        let _e171 = phi_771_;
        if (_e171 > 88f) {
            phi_776_ = 88f;
        } else {
            phi_776_ = _e171;
        }
        let _e174 = phi_776_;
        let _e176 = ((_e174 * 1.442695f) + 0.5f);
        if (_e176 > -8388608f) {
            let _e188 = f32(select(0i, select(select(i32(_e176), i32(-2147483648), (_e176 < bitcast<f32>(3472883712u))), 2147483647i, (_e176 > bitcast<f32>(1325400063u))), (_e176 == _e176)));
            if (_e188 > _e176) {
                phi_798_ = 1f;
            } else {
                phi_798_ = 0f;
            }
            let _e191 = phi_798_;
            if (_e176 < 8388608f) {
                phi_803_ = (_e188 - _e191);
                phi_804_ = false;
            } else {
                phi_803_ = f32();
                phi_804_ = true;
            }
            let _e194 = phi_803_;
            let _e196 = phi_804_;
            phi_805_ = _e194;
            phi_806_ = _e196;
        } else {
            phi_805_ = f32();
            phi_806_ = true;
        }
        let _e198 = phi_805_;
        let _e200 = phi_806_;
        if _e200 {
            phi_810_ = _e176;
        } else {
            phi_810_ = _e198;
        }
        let _e202 = phi_810_;
        let _e206 = ((_e174 - (_e202 * 0.69314575f)) - (_e202 * 0.0000014286068f));
        phi_848_ = ((((((((((((((((1f / 5040f) * _e206) + (1f / 720f)) * _e206) + (1f / 120f)) * _e206) + (1f / 24f)) * _e206) + (1f / 6f)) * _e206) + 0.5f) * _e206) + 1f) * _e206) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e202), i32(-2147483648), (_e202 < bitcast<f32>(3472883712u))), 2147483647i, (_e202 > bitcast<f32>(1325400063u))), (_e202 == _e202)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e242 = phi_848_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_866_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_865_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_864_ = 1f;
            } else {
                phi_864_ = param_6.z;
            }
            let _e250 = phi_864_;
            phi_865_ = _e250;
        }
        let _e252 = phi_865_;
        phi_866_ = _e252;
    }
    let _e254 = phi_866_;
    let _e256 = (_e49 * (_e254 - _e60));
    if ((bitcast<u32>(_e256) & 2147483647u) > 2139095040u) {
        phi_956_ = _e256;
    } else {
        if (_e256 < -87f) {
            phi_879_ = -87f;
        } else {
            phi_879_ = _e256;
        }
        let _e262 = phi_879_;
        if (_e262 > 88f) {
            phi_884_ = 88f;
        } else {
            phi_884_ = _e262;
        }
        let _e265 = phi_884_;
        let _e267 = ((_e265 * 1.442695f) + 0.5f);
        if (_e267 > -8388608f) {
            let _e279 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
            if (_e279 > _e267) {
                phi_906_ = 1f;
            } else {
                phi_906_ = 0f;
            }
            let _e282 = phi_906_;
            if (_e267 < 8388608f) {
                phi_911_ = (_e279 - _e282);
                phi_912_ = false;
            } else {
                phi_911_ = f32();
                phi_912_ = true;
            }
            let _e285 = phi_911_;
            let _e287 = phi_912_;
            phi_913_ = _e285;
            phi_914_ = _e287;
        } else {
            phi_913_ = f32();
            phi_914_ = true;
        }
        let _e289 = phi_913_;
        let _e291 = phi_914_;
        if _e291 {
            phi_918_ = _e267;
        } else {
            phi_918_ = _e289;
        }
        let _e293 = phi_918_;
        let _e297 = ((_e265 - (_e293 * 0.69314575f)) - (_e293 * 0.0000014286068f));
        phi_956_ = ((((((((((((((((1f / 5040f) * _e297) + (1f / 720f)) * _e297) + (1f / 120f)) * _e297) + (1f / 24f)) * _e297) + (1f / 6f)) * _e297) + 0.5f) * _e297) + 1f) * _e297) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e333 = phi_956_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_974_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_973_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_972_ = 1f;
            } else {
                phi_972_ = param_6.w;
            }
            let _e341 = phi_972_;
            phi_973_ = _e341;
        }
        let _e343 = phi_973_;
        phi_974_ = _e343;
    }
    let _e345 = phi_974_;
    let _e347 = (_e49 * (_e345 - _e60));
    if ((bitcast<u32>(_e347) & 2147483647u) > 2139095040u) {
        phi_1064_ = _e347;
    } else {
        if (_e347 < -87f) {
            phi_987_ = -87f;
        } else {
            phi_987_ = _e347;
        }
        let _e353 = phi_987_;
        if (_e353 > 88f) {
            phi_992_ = 88f;
        } else {
            phi_992_ = _e353;
        }
        let _e356 = phi_992_;
        let _e358 = ((_e356 * 1.442695f) + 0.5f);
        if (_e358 > -8388608f) {
            let _e370 = f32(select(0i, select(select(i32(_e358), i32(-2147483648), (_e358 < bitcast<f32>(3472883712u))), 2147483647i, (_e358 > bitcast<f32>(1325400063u))), (_e358 == _e358)));
            if (_e370 > _e358) {
                phi_1014_ = 1f;
            } else {
                phi_1014_ = 0f;
            }
            let _e373 = phi_1014_;
            if (_e358 < 8388608f) {
                phi_1019_ = (_e370 - _e373);
                phi_1020_ = false;
            } else {
                phi_1019_ = f32();
                phi_1020_ = true;
            }
            let _e376 = phi_1019_;
            let _e378 = phi_1020_;
            phi_1021_ = _e376;
            phi_1022_ = _e378;
        } else {
            phi_1021_ = f32();
            phi_1022_ = true;
        }
        let _e380 = phi_1021_;
        let _e382 = phi_1022_;
        if _e382 {
            phi_1026_ = _e358;
        } else {
            phi_1026_ = _e380;
        }
        let _e384 = phi_1026_;
        let _e388 = ((_e356 - (_e384 * 0.69314575f)) - (_e384 * 0.0000014286068f));
        phi_1064_ = ((((((((((((((((1f / 5040f) * _e388) + (1f / 720f)) * _e388) + (1f / 120f)) * _e388) + (1f / 24f)) * _e388) + (1f / 6f)) * _e388) + 0.5f) * _e388) + 1f) * _e388) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < bitcast<f32>(3472883712u))), 2147483647i, (_e384 > bitcast<f32>(1325400063u))), (_e384 == _e384)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e424 = phi_1064_;
    let _e435 = ((((_e151 * param_7.x) + (_e242 * param_7.y)) + (_e333 * param_7.z)) + (_e424 * param_7.w));
    if ((bitcast<u32>(_e435) & 2147483647u) > 2139095040u) {
        phi_1092_ = _e435;
    } else {
        if (_e435 < 0f) {
            phi_1091_ = 0f;
        } else {
            if (_e435 > 1f) {
                phi_1090_ = 1f;
            } else {
                phi_1090_ = _e435;
            }
            let _e442 = phi_1090_;
            phi_1091_ = _e442;
        }
        let _e444 = phi_1091_;
        phi_1092_ = _e444;
    }
    let _e446 = phi_1092_;
    return _e446;
}

fn function_() {
    var local: f32;
    var phi_227_: bool;
    var phi_228_: bool;
    var phi_229_: bool;
    var phi_230_: bool;
    var phi_234_: bool;
    var phi_278_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_282_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_359_: bool;
    var phi_368_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_380_: bool;
    var phi_381_: bool;
    var phi_382_: bool;
    var phi_383_: bool;
    var phi_387_: bool;
    var phi_423_: f32;
    var phi_428_: f32;
    var phi_429_: bool;
    var phi_430_: f32;
    var phi_431_: bool;
    var phi_435_: f32;
    var phi_455_: f32;
    var phi_460_: f32;
    var phi_461_: bool;
    var phi_462_: f32;
    var phi_463_: bool;
    var phi_467_: f32;
    var phi_513_: i32;
    var phi_518_: i32;
    var phi_523_: i32;
    var phi_528_: i32;
    var phi_537_: i32;
    var phi_542_: i32;
    var phi_547_: i32;
    var phi_552_: i32;
    var phi_593_: evaluate_Verdict;
    var phi_594_: evaluate_Verdict;
    var phi_595_: bool;
    var phi_596_: evaluate_Verdict;
    var phi_597_: evaluate_Verdict;
    var phi_598_: bool;
    var phi_602_: evaluate_Verdict;

    let _e46 = id_1;
    let _e53 = arrayLength((&map.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e46, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e71 = p.member.light;
        let _e74 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_227_ = (_e84 == _e86);
                phi_228_ = false;
            } else {
                phi_227_ = bool();
                phi_228_ = true;
            }
            let _e89 = phi_227_;
            let _e91 = phi_228_;
            phi_229_ = _e89;
            phi_230_ = _e91;
        } else {
            phi_229_ = bool();
            phi_230_ = true;
        }
        let _e93 = phi_229_;
        let _e95 = phi_230_;
        if _e95 {
            phi_234_ = false;
        } else {
            phi_234_ = _e93;
        }
        let _e97 = phi_234_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e62.first_primitive)].normal;
            let _e102 = samples.member[(0u + _e62.first_primitive)].position;
            if ((((_e100.x * (_e71.x - (_e102.x * _e71.w))) + (_e100.y * (_e71.y - (_e102.y * _e71.w)))) + (_e100.z * (_e71.z - (_e102.z * _e71.w)))) > 0f) {
                let _e126 = samples.member[(0u + _e62.first_primitive)].flags;
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e134.unnamed.visibility, false), _e134.unnamed_1);
                phi_278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e140.unnamed, ((_e126 & 1u) == 0u));
            } else {
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e149.unnamed.visibility, false), _e149.unnamed_1);
                phi_278_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e155.unnamed, true);
            }
            let _e160 = phi_278_;
            phi_282_ = _e160;
        } else {
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
            phi_282_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, true);
        }
        let _e177 = phi_282_;
        if _e177.unnamed_1 {
            phi_596_ = evaluate_Verdict(_e177.unnamed.visibility, _e177.unnamed.is_doubted);
            phi_597_ = evaluate_Verdict();
            phi_598_ = true;
        } else {
            let _e185 = samples.member[(0u + _e62.first_primitive)].position;
            let _e191 = p.member.projection.row_w;
            let _e202 = ((((_e191.x * _e185.x) + (_e191.y * _e185.y)) + (_e191.z * _e185.z)) + (_e191.w * 1f));
            let _e204 = p.member.projection.row_x;
            let _e216 = (((((_e204.x * _e185.x) + (_e204.y * _e185.y)) + (_e204.z * _e185.z)) + (_e204.w * 1f)) / _e202);
            let _e218 = p.member.projection.row_y;
            let _e230 = (((((_e218.x * _e185.x) + (_e218.y * _e185.y)) + (_e218.z * _e185.z)) + (_e218.w * 1f)) / _e202);
            let _e232 = p.member.projection.row_z;
            let _e243 = ((((_e232.x * _e185.x) + (_e232.y * _e185.y)) + (_e232.z * _e185.z)) + (_e232.w * 1f));
            if (_e202 > 0f) {
                if (_e216 >= 0f) {
                    phi_359_ = (_e216 <= 1f);
                } else {
                    phi_359_ = false;
                }
                let _e248 = phi_359_;
                if _e248 {
                    if (_e230 >= 0f) {
                        phi_368_ = (_e230 <= 1f);
                    } else {
                        phi_368_ = false;
                    }
                    let _e252 = phi_368_;
                    if _e252 {
                        if (_e243 >= 0f) {
                            phi_377_ = (_e243 <= 1f);
                        } else {
                            phi_377_ = false;
                        }
                        let _e256 = phi_377_;
                        phi_378_ = _e256;
                        phi_379_ = false;
                    } else {
                        phi_378_ = bool();
                        phi_379_ = true;
                    }
                    let _e258 = phi_378_;
                    let _e260 = phi_379_;
                    phi_380_ = _e258;
                    phi_381_ = _e260;
                } else {
                    phi_380_ = bool();
                    phi_381_ = true;
                }
                let _e262 = phi_380_;
                let _e264 = phi_381_;
                phi_382_ = _e262;
                phi_383_ = _e264;
            } else {
                phi_382_ = bool();
                phi_383_ = true;
            }
            let _e266 = phi_382_;
            let _e268 = phi_383_;
            if _e268 {
                phi_387_ = false;
            } else {
                phi_387_ = _e266;
            }
            let _e270 = phi_387_;
            if _e270 {
                let _e272 = p.member.map_size;
                let _e273 = f32(_e272);
                let _e276 = ((_e216 * _e273) - 0.5f);
                let _e277 = ((_e230 * _e273) - 0.5f);
                if (_e276 > -8388608f) {
                    let _e289 = f32(select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < bitcast<f32>(3472883712u))), 2147483647i, (_e276 > bitcast<f32>(1325400063u))), (_e276 == _e276)));
                    if (_e289 > _e276) {
                        phi_423_ = 1f;
                    } else {
                        phi_423_ = 0f;
                    }
                    let _e292 = phi_423_;
                    if (_e276 < 8388608f) {
                        phi_428_ = (_e289 - _e292);
                        phi_429_ = false;
                    } else {
                        phi_428_ = f32();
                        phi_429_ = true;
                    }
                    let _e295 = phi_428_;
                    let _e297 = phi_429_;
                    phi_430_ = _e295;
                    phi_431_ = _e297;
                } else {
                    phi_430_ = f32();
                    phi_431_ = true;
                }
                let _e299 = phi_430_;
                let _e301 = phi_431_;
                if _e301 {
                    phi_435_ = _e276;
                } else {
                    phi_435_ = _e299;
                }
                let _e303 = phi_435_;
                if (_e277 > -8388608f) {
                    let _e315 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e315 > _e277) {
                        phi_455_ = 1f;
                    } else {
                        phi_455_ = 0f;
                    }
                    let _e318 = phi_455_;
                    if (_e277 < 8388608f) {
                        phi_460_ = (_e315 - _e318);
                        phi_461_ = false;
                    } else {
                        phi_460_ = f32();
                        phi_461_ = true;
                    }
                    let _e321 = phi_460_;
                    let _e323 = phi_461_;
                    phi_462_ = _e321;
                    phi_463_ = _e323;
                } else {
                    phi_462_ = f32();
                    phi_463_ = true;
                }
                let _e325 = phi_462_;
                let _e327 = phi_463_;
                if _e327 {
                    phi_467_ = _e277;
                } else {
                    phi_467_ = _e325;
                }
                let _e329 = phi_467_;
                let _e330 = (_e276 - _e303);
                let _e331 = (_e277 - _e329);
                let _e340 = select(0i, select(select(i32(_e303), i32(-2147483648), (_e303 < bitcast<f32>(3472883712u))), 2147483647i, (_e303 > bitcast<f32>(1325400063u))), (_e303 == _e303));
                let _e349 = select(0i, select(select(i32(_e329), i32(-2147483648), (_e329 < bitcast<f32>(3472883712u))), 2147483647i, (_e329 > bitcast<f32>(1325400063u))), (_e329 == _e329));
                let _e360 = p.member.test;
                let _e361 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e360);
                let _e363 = p.member.map_size;
                local = _e361;
                let _e365 = (bitcast<i32>(_e363) - 1i);
                if (_e340 > 0i) {
                    phi_513_ = _e340;
                } else {
                    phi_513_ = 0i;
                }
                let _e368 = phi_513_;
                if (_e349 > 0i) {
                    phi_518_ = _e349;
                } else {
                    phi_518_ = 0i;
                }
                let _e371 = phi_518_;
                if (_e368 < _e365) {
                    phi_523_ = _e368;
                } else {
                    phi_523_ = _e365;
                }
                let _e374 = phi_523_;
                if (_e371 < _e365) {
                    phi_528_ = _e371;
                } else {
                    phi_528_ = _e365;
                }
                let _e377 = phi_528_;
                let _e378 = bitcast<u32>(_e374);
                let _e380 = (_e340 + 1i);
                let _e381 = (_e349 + 1i);
                if (_e380 > 0i) {
                    phi_537_ = _e380;
                } else {
                    phi_537_ = 0i;
                }
                let _e384 = phi_537_;
                if (_e381 > 0i) {
                    phi_542_ = _e381;
                } else {
                    phi_542_ = 0i;
                }
                let _e387 = phi_542_;
                if (_e384 < _e365) {
                    phi_547_ = _e384;
                } else {
                    phi_547_ = _e365;
                }
                let _e390 = phi_547_;
                if (_e387 < _e365) {
                    phi_552_ = _e387;
                } else {
                    phi_552_ = _e365;
                }
                let _e393 = phi_552_;
                let _e394 = bitcast<u32>(_e390);
                let _e396 = (bitcast<u32>(_e377) * _e363);
                let _e397 = (bitcast<u32>(_e393) * _e363);
                let _e398 = (_e396 + _e378);
                let _e399 = (_e396 + _e394);
                let _e400 = (_e397 + _e378);
                let _e401 = (_e397 + _e394);
                if (_e398 < _e53) {
                } else {
                    return;
                }
                let _e405 = map.member[(0u + _e398)];
                if (_e399 < _e53) {
                } else {
                    return;
                }
                let _e409 = map.member[(0u + _e399)];
                if (_e400 < _e53) {
                } else {
                    return;
                }
                let _e413 = map.member[(0u + _e400)];
                if (_e401 < _e53) {
                } else {
                    return;
                }
                let _e417 = map.member[(0u + _e401)];
                let _e419 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e405, _e409, _e413, _e417), vec4<f32>(((1f - _e330) * (1f - _e331)), (_e330 * (1f - _e331)), ((1f - _e330) * _e331), (_e330 * _e331)), _e243);
                phi_593_ = evaluate_Verdict(_e419, false);
                phi_594_ = evaluate_Verdict();
                phi_595_ = false;
            } else {
                phi_593_ = evaluate_Verdict();
                phi_594_ = evaluate_Verdict(1f, false);
                phi_595_ = true;
            }
            let _e423 = phi_593_;
            let _e425 = phi_594_;
            let _e427 = phi_595_;
            phi_596_ = _e425;
            phi_597_ = _e423;
            phi_598_ = _e427;
        }
        let _e429 = phi_596_;
        let _e431 = phi_597_;
        let _e433 = phi_598_;
        if _e433 {
            phi_602_ = _e429;
        } else {
            phi_602_ = _e431;
        }
        let _e435 = phi_602_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e435.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
