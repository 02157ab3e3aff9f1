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

struct type_30 {
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
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e59 = phi_141_;
        let _e61 = phi_142_;
        phi_143_ = _e59;
        phi_144_ = _e61;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e63 = phi_143_;
    let _e65 = phi_144_;
    if _e65 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e63;
    }
    let _e70 = phi_149_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_747_: bool;
    var phi_751_: f32;
    var phi_766_: f32;
    var phi_767_: f32;
    var phi_768_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_820_: f32;
    var phi_821_: f32;
    var phi_822_: f32;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_840_: f32;
    var phi_859_: f32;
    var phi_864_: f32;
    var phi_886_: f32;
    var phi_891_: f32;
    var phi_892_: bool;
    var phi_893_: f32;
    var phi_894_: bool;
    var phi_898_: f32;
    var phi_936_: f32;
    var phi_947_: f32;
    var phi_952_: f32;
    var phi_974_: f32;
    var phi_979_: f32;
    var phi_980_: bool;
    var phi_981_: f32;
    var phi_982_: bool;
    var phi_986_: f32;
    var phi_1024_: f32;
    var phi_1035_: f32;
    var phi_1040_: f32;
    var phi_1062_: f32;
    var phi_1067_: f32;
    var phi_1068_: bool;
    var phi_1069_: f32;
    var phi_1070_: bool;
    var phi_1074_: f32;
    var phi_1112_: f32;
    var phi_1123_: f32;
    var phi_1128_: f32;
    var phi_1150_: f32;
    var phi_1155_: f32;
    var phi_1156_: bool;
    var phi_1157_: f32;
    var phi_1158_: bool;
    var phi_1162_: f32;
    var phi_1200_: f32;
    var phi_1226_: f32;
    var phi_1227_: f32;
    var phi_1228_: f32;

    let _e50 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_747_ = true;
    } else {
        let _e54 = (84f < _e50);
        if _e54 {
        }
        phi_747_ = _e54;
    }
    let _e56 = phi_747_;
    if _e56 {
        phi_751_ = 84f;
    } else {
        phi_751_ = _e50;
    }
    let _e58 = phi_751_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_768_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_767_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_766_ = 1f;
            } else {
                phi_766_ = param_7;
            }
            let _e65 = phi_766_;
            phi_767_ = _e65;
        }
        let _e67 = phi_767_;
        phi_768_ = _e67;
    }
    let _e69 = phi_768_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_786_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_785_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_784_ = 1f;
            } else {
                phi_784_ = param_5.x;
            }
            let _e77 = phi_784_;
            phi_785_ = _e77;
        }
        let _e79 = phi_785_;
        phi_786_ = _e79;
    }
    let _e81 = phi_786_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_804_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_803_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_802_ = 1f;
            } else {
                phi_802_ = param_5.y;
            }
            let _e89 = phi_802_;
            phi_803_ = _e89;
        }
        let _e91 = phi_803_;
        phi_804_ = _e91;
    }
    let _e93 = phi_804_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_822_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_821_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_820_ = 1f;
            } else {
                phi_820_ = param_5.z;
            }
            let _e101 = phi_820_;
            phi_821_ = _e101;
        }
        let _e103 = phi_821_;
        phi_822_ = _e103;
    }
    let _e105 = phi_822_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_840_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_839_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_838_ = 1f;
            } else {
                phi_838_ = param_5.w;
            }
            let _e113 = phi_838_;
            phi_839_ = _e113;
        }
        let _e115 = phi_839_;
        phi_840_ = _e115;
    }
    let _e117 = phi_840_;
    let _e122 = (_e58 * (_e81 - _e69));
    let _e123 = (_e58 * (_e93 - _e69));
    let _e124 = (_e58 * (_e105 - _e69));
    let _e125 = (_e58 * (_e117 - _e69));
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_936_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_859_ = -87f;
        } else {
            phi_859_ = _e122;
        }
        let _e131 = phi_859_;
        if (_e131 > 88f) {
            phi_864_ = 88f;
        } else {
            phi_864_ = _e131;
        }
        let _e134 = phi_864_;
        let _e136 = ((_e134 * 1.442695f) + 0.5f);
        if (_e136 > -8388608f) {
            let _e148 = f32(select(0i, select(select(i32(_e136), i32(-2147483648), (_e136 < bitcast<f32>(3472883712u))), 2147483647i, (_e136 > bitcast<f32>(1325400063u))), (_e136 == _e136)));
            if (_e148 > _e136) {
                phi_886_ = 1f;
            } else {
                phi_886_ = 0f;
            }
            let _e151 = phi_886_;
            if (_e136 < 8388608f) {
                phi_891_ = (_e148 - _e151);
                phi_892_ = false;
            } else {
                phi_891_ = f32();
                phi_892_ = true;
            }
            let _e154 = phi_891_;
            let _e156 = phi_892_;
            phi_893_ = _e154;
            phi_894_ = _e156;
        } else {
            phi_893_ = f32();
            phi_894_ = true;
        }
        let _e158 = phi_893_;
        let _e160 = phi_894_;
        if _e160 {
            phi_898_ = _e136;
        } else {
            phi_898_ = _e158;
        }
        let _e162 = phi_898_;
        let _e166 = ((_e134 - (_e162 * 0.69314575f)) - (_e162 * 0.0000014286068f));
        phi_936_ = ((((((((((((((((1f / 5040f) * _e166) + (1f / 720f)) * _e166) + (1f / 120f)) * _e166) + (1f / 24f)) * _e166) + (1f / 6f)) * _e166) + 0.5f) * _e166) + 1f) * _e166) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e162), i32(-2147483648), (_e162 < bitcast<f32>(3472883712u))), 2147483647i, (_e162 > bitcast<f32>(1325400063u))), (_e162 == _e162)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e202 = phi_936_;
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_1024_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_947_ = -87f;
        } else {
            phi_947_ = _e123;
        }
        let _e208 = phi_947_;
        if (_e208 > 88f) {
            phi_952_ = 88f;
        } else {
            phi_952_ = _e208;
        }
        let _e211 = phi_952_;
        let _e213 = ((_e211 * 1.442695f) + 0.5f);
        if (_e213 > -8388608f) {
            let _e225 = f32(select(0i, select(select(i32(_e213), i32(-2147483648), (_e213 < bitcast<f32>(3472883712u))), 2147483647i, (_e213 > bitcast<f32>(1325400063u))), (_e213 == _e213)));
            if (_e225 > _e213) {
                phi_974_ = 1f;
            } else {
                phi_974_ = 0f;
            }
            let _e228 = phi_974_;
            if (_e213 < 8388608f) {
                phi_979_ = (_e225 - _e228);
                phi_980_ = false;
            } else {
                phi_979_ = f32();
                phi_980_ = true;
            }
            let _e231 = phi_979_;
            let _e233 = phi_980_;
            phi_981_ = _e231;
            phi_982_ = _e233;
        } else {
            phi_981_ = f32();
            phi_982_ = true;
        }
        let _e235 = phi_981_;
        let _e237 = phi_982_;
        if _e237 {
            phi_986_ = _e213;
        } else {
            phi_986_ = _e235;
        }
        let _e239 = phi_986_;
        let _e243 = ((_e211 - (_e239 * 0.69314575f)) - (_e239 * 0.0000014286068f));
        phi_1024_ = ((((((((((((((((1f / 5040f) * _e243) + (1f / 720f)) * _e243) + (1f / 120f)) * _e243) + (1f / 24f)) * _e243) + (1f / 6f)) * _e243) + 0.5f) * _e243) + 1f) * _e243) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e279 = phi_1024_;
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_1112_ = _e124;
    } else {
        if (_e124 < -87f) {
            phi_1035_ = -87f;
        } else {
            phi_1035_ = _e124;
        }
        let _e285 = phi_1035_;
        if (_e285 > 88f) {
            phi_1040_ = 88f;
        } else {
            phi_1040_ = _e285;
        }
        let _e288 = phi_1040_;
        let _e290 = ((_e288 * 1.442695f) + 0.5f);
        if (_e290 > -8388608f) {
            let _e302 = f32(select(0i, select(select(i32(_e290), i32(-2147483648), (_e290 < bitcast<f32>(3472883712u))), 2147483647i, (_e290 > bitcast<f32>(1325400063u))), (_e290 == _e290)));
            if (_e302 > _e290) {
                phi_1062_ = 1f;
            } else {
                phi_1062_ = 0f;
            }
            let _e305 = phi_1062_;
            if (_e290 < 8388608f) {
                phi_1067_ = (_e302 - _e305);
                phi_1068_ = false;
            } else {
                phi_1067_ = f32();
                phi_1068_ = true;
            }
            let _e308 = phi_1067_;
            let _e310 = phi_1068_;
            phi_1069_ = _e308;
            phi_1070_ = _e310;
        } else {
            phi_1069_ = f32();
            phi_1070_ = true;
        }
        let _e312 = phi_1069_;
        let _e314 = phi_1070_;
        if _e314 {
            phi_1074_ = _e290;
        } else {
            phi_1074_ = _e312;
        }
        let _e316 = phi_1074_;
        let _e320 = ((_e288 - (_e316 * 0.69314575f)) - (_e316 * 0.0000014286068f));
        phi_1112_ = ((((((((((((((((1f / 5040f) * _e320) + (1f / 720f)) * _e320) + (1f / 120f)) * _e320) + (1f / 24f)) * _e320) + (1f / 6f)) * _e320) + 0.5f) * _e320) + 1f) * _e320) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < bitcast<f32>(3472883712u))), 2147483647i, (_e316 > bitcast<f32>(1325400063u))), (_e316 == _e316)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e356 = phi_1112_;
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_1200_ = _e125;
    } else {
        if (_e125 < -87f) {
            phi_1123_ = -87f;
        } else {
            phi_1123_ = _e125;
        }
        let _e362 = phi_1123_;
        if (_e362 > 88f) {
            phi_1128_ = 88f;
        } else {
            phi_1128_ = _e362;
        }
        let _e365 = phi_1128_;
        let _e367 = ((_e365 * 1.442695f) + 0.5f);
        if (_e367 > -8388608f) {
            let _e379 = f32(select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < bitcast<f32>(3472883712u))), 2147483647i, (_e367 > bitcast<f32>(1325400063u))), (_e367 == _e367)));
            if (_e379 > _e367) {
                phi_1150_ = 1f;
            } else {
                phi_1150_ = 0f;
            }
            let _e382 = phi_1150_;
            if (_e367 < 8388608f) {
                phi_1155_ = (_e379 - _e382);
                phi_1156_ = false;
            } else {
                phi_1155_ = f32();
                phi_1156_ = true;
            }
            let _e385 = phi_1155_;
            let _e387 = phi_1156_;
            phi_1157_ = _e385;
            phi_1158_ = _e387;
        } else {
            phi_1157_ = f32();
            phi_1158_ = true;
        }
        let _e389 = phi_1157_;
        let _e391 = phi_1158_;
        if _e391 {
            phi_1162_ = _e367;
        } else {
            phi_1162_ = _e389;
        }
        let _e393 = phi_1162_;
        let _e397 = ((_e365 - (_e393 * 0.69314575f)) - (_e393 * 0.0000014286068f));
        phi_1200_ = ((((((((((((((((1f / 5040f) * _e397) + (1f / 720f)) * _e397) + (1f / 120f)) * _e397) + (1f / 24f)) * _e397) + (1f / 6f)) * _e397) + 0.5f) * _e397) + 1f) * _e397) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e433 = phi_1200_;
    let _e444 = ((((_e202 * param_6.x) + (_e279 * param_6.y)) + (_e356 * param_6.z)) + (_e433 * param_6.w));
    if ((bitcast<u32>(_e444) & 2147483647u) > 2139095040u) {
        phi_1228_ = _e444;
    } else {
        if (_e444 < 0f) {
            phi_1227_ = 0f;
        } else {
            if (_e444 > 1f) {
                phi_1226_ = 1f;
            } else {
                phi_1226_ = _e444;
            }
            let _e451 = phi_1226_;
            phi_1227_ = _e451;
        }
        let _e453 = phi_1227_;
        phi_1228_ = _e453;
    }
    let _e455 = phi_1228_;
    return _e455;
}

fn function_() {
    var local: f32;
    var phi_211_: bool;
    var phi_212_: bool;
    var phi_213_: bool;
    var phi_214_: bool;
    var phi_218_: bool;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_300_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_301_: bool;
    var phi_302_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_303_: bool;
    var phi_310_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_314_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_388_: bool;
    var phi_397_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_416_: bool;
    var phi_506_: f32;
    var phi_509_: f32;
    var phi_538_: f32;
    var phi_543_: f32;
    var phi_544_: bool;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_550_: f32;
    var phi_570_: f32;
    var phi_575_: f32;
    var phi_576_: bool;
    var phi_577_: f32;
    var phi_578_: bool;
    var phi_582_: f32;
    var phi_630_: i32;
    var phi_635_: i32;
    var phi_640_: i32;
    var phi_645_: i32;
    var phi_654_: i32;
    var phi_659_: i32;
    var phi_664_: i32;
    var phi_669_: i32;
    var phi_714_: evaluate_Verdict;
    var phi_715_: evaluate_Verdict;
    var phi_716_: bool;
    var phi_717_: evaluate_Verdict;
    var phi_718_: evaluate_Verdict;
    var phi_719_: bool;
    var phi_723_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e69 = p.member.projection;
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = lt_math_OneLevel(_e69);
        let _e77 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e89 = global[2u];
                phi_211_ = (_e87 == _e89);
                phi_212_ = false;
            } else {
                phi_211_ = bool();
                phi_212_ = true;
            }
            let _e92 = phi_211_;
            let _e94 = phi_212_;
            phi_213_ = _e92;
            phi_214_ = _e94;
        } else {
            phi_213_ = bool();
            phi_214_ = true;
        }
        let _e96 = phi_213_;
        let _e98 = phi_214_;
        if _e98 {
            phi_218_ = false;
        } else {
            phi_218_ = _e96;
        }
        let _e100 = phi_218_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[(0u + _e63.first_primitive)].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_289_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_288_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_288_ = false;
                    }
                    let _e161 = phi_288_;
                    phi_289_ = _e161;
                }
                let _e163 = phi_289_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_300_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_301_ = false;
                } else {
                    phi_300_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_301_ = true;
                }
                let _e184 = phi_300_;
                let _e186 = phi_301_;
                phi_302_ = _e184;
                phi_303_ = _e186;
            } else {
                phi_302_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_303_ = true;
            }
            let _e188 = phi_302_;
            let _e190 = phi_303_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_310_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_310_ = _e188;
            }
            let _e207 = phi_310_;
            phi_314_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_314_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_314_;
        if _e224.unnamed_1 {
            phi_717_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
            phi_718_ = evaluate_Verdict();
            phi_719_ = true;
        } else {
            let _e232 = samples.member[(0u + _e63.first_primitive)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_388_ = (_e264 <= 1f);
                } else {
                    phi_388_ = false;
                }
                let _e296 = phi_388_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_397_ = (_e278 <= 1f);
                    } else {
                        phi_397_ = false;
                    }
                    let _e300 = phi_397_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_406_ = (_e291 <= 1f);
                        } else {
                            phi_406_ = false;
                        }
                        let _e304 = phi_406_;
                        phi_407_ = _e304;
                        phi_408_ = false;
                    } else {
                        phi_407_ = bool();
                        phi_408_ = true;
                    }
                    let _e306 = phi_407_;
                    let _e308 = phi_408_;
                    phi_409_ = _e306;
                    phi_410_ = _e308;
                } else {
                    phi_409_ = bool();
                    phi_410_ = true;
                }
                let _e310 = phi_409_;
                let _e312 = phi_410_;
                phi_411_ = _e310;
                phi_412_ = _e312;
            } else {
                phi_411_ = bool();
                phi_412_ = true;
            }
            let _e314 = phi_411_;
            let _e316 = phi_412_;
            if _e316 {
                phi_416_ = false;
            } else {
                phi_416_ = _e314;
            }
            let _e318 = phi_416_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_506_ = _e393;
                    } else {
                        phi_506_ = 0.002f;
                    }
                    let _e396 = phi_506_;
                    phi_509_ = (_e291 - (0f * _e396));
                } else {
                    phi_509_ = _e291;
                }
                let _e400 = phi_509_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_538_ = 1f;
                    } else {
                        phi_538_ = 0f;
                    }
                    let _e422 = phi_538_;
                    if (_e406 < 8388608f) {
                        phi_543_ = (_e419 - _e422);
                        phi_544_ = false;
                    } else {
                        phi_543_ = f32();
                        phi_544_ = true;
                    }
                    let _e425 = phi_543_;
                    let _e427 = phi_544_;
                    phi_545_ = _e425;
                    phi_546_ = _e427;
                } else {
                    phi_545_ = f32();
                    phi_546_ = true;
                }
                let _e429 = phi_545_;
                let _e431 = phi_546_;
                if _e431 {
                    phi_550_ = _e406;
                } else {
                    phi_550_ = _e429;
                }
                let _e433 = phi_550_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_570_ = 1f;
                    } else {
                        phi_570_ = 0f;
                    }
                    let _e448 = phi_570_;
                    if (_e407 < 8388608f) {
                        phi_575_ = (_e445 - _e448);
                        phi_576_ = false;
                    } else {
                        phi_575_ = f32();
                        phi_576_ = true;
                    }
                    let _e451 = phi_575_;
                    let _e453 = phi_576_;
                    phi_577_ = _e451;
                    phi_578_ = _e453;
                } else {
                    phi_577_ = f32();
                    phi_578_ = true;
                }
                let _e455 = phi_577_;
                let _e457 = phi_578_;
                if _e457 {
                    phi_582_ = _e407;
                } else {
                    phi_582_ = _e455;
                }
                let _e459 = phi_582_;
                let _e460 = (_e406 - _e433);
                let _e461 = (_e407 - _e459);
                let _e470 = select(0i, select(select(i32(_e433), i32(-2147483648), (_e433 < bitcast<f32>(3472883712u))), 2147483647i, (_e433 > bitcast<f32>(1325400063u))), (_e433 == _e433));
                let _e479 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < bitcast<f32>(3472883712u))), 2147483647i, (_e459 > bitcast<f32>(1325400063u))), (_e459 == _e459));
                let _e490 = p.member.test;
                let _e491 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e490);
                let _e493 = p.member.map_size;
                local = _e491;
                let _e495 = ((0u * _e493) * _e493);
                let _e497 = (bitcast<i32>(_e493) - 1i);
                if (_e470 > 0i) {
                    phi_630_ = _e470;
                } else {
                    phi_630_ = 0i;
                }
                let _e500 = phi_630_;
                if (_e479 > 0i) {
                    phi_635_ = _e479;
                } else {
                    phi_635_ = 0i;
                }
                let _e503 = phi_635_;
                if (_e500 < _e497) {
                    phi_640_ = _e500;
                } else {
                    phi_640_ = _e497;
                }
                let _e506 = phi_640_;
                if (_e503 < _e497) {
                    phi_645_ = _e503;
                } else {
                    phi_645_ = _e497;
                }
                let _e509 = phi_645_;
                let _e510 = bitcast<u32>(_e506);
                let _e512 = (_e470 + 1i);
                let _e513 = (_e479 + 1i);
                if (_e512 > 0i) {
                    phi_654_ = _e512;
                } else {
                    phi_654_ = 0i;
                }
                let _e516 = phi_654_;
                if (_e513 > 0i) {
                    phi_659_ = _e513;
                } else {
                    phi_659_ = 0i;
                }
                let _e519 = phi_659_;
                if (_e516 < _e497) {
                    phi_664_ = _e516;
                } else {
                    phi_664_ = _e497;
                }
                let _e522 = phi_664_;
                if (_e519 < _e497) {
                    phi_669_ = _e519;
                } else {
                    phi_669_ = _e497;
                }
                let _e525 = phi_669_;
                let _e526 = bitcast<u32>(_e522);
                let _e528 = (bitcast<u32>(_e509) * _e493);
                let _e529 = (bitcast<u32>(_e525) * _e493);
                let _e534 = ((_e528 + _e510) + _e495);
                let _e535 = ((_e528 + _e526) + _e495);
                let _e536 = ((_e529 + _e510) + _e495);
                let _e537 = ((_e529 + _e526) + _e495);
                if (_e534 < _e54) {
                } else {
                    return;
                }
                let _e541 = map.member[(0u + _e534)];
                if (_e535 < _e54) {
                } else {
                    return;
                }
                let _e545 = map.member[(0u + _e535)];
                if (_e536 < _e54) {
                } else {
                    return;
                }
                let _e549 = map.member[(0u + _e536)];
                if (_e537 < _e54) {
                } else {
                    return;
                }
                let _e553 = map.member[(0u + _e537)];
                let _e555 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e541, _e545, _e549, _e553), vec4<f32>(((1f - _e460) * (1f - _e461)), (_e460 * (1f - _e461)), ((1f - _e460) * _e461), (_e460 * _e461)), _e400);
                phi_714_ = evaluate_Verdict(_e555, false);
                phi_715_ = evaluate_Verdict();
                phi_716_ = false;
            } else {
                phi_714_ = evaluate_Verdict();
                phi_715_ = evaluate_Verdict(1f, false);
                phi_716_ = true;
            }
            let _e559 = phi_714_;
            let _e561 = phi_715_;
            let _e563 = phi_716_;
            phi_717_ = _e561;
            phi_718_ = _e559;
            phi_719_ = _e563;
        }
        let _e565 = phi_717_;
        let _e567 = phi_718_;
        let _e569 = phi_719_;
        if _e569 {
            phi_723_ = _e565;
        } else {
            phi_723_ = _e567;
        }
        let _e571 = phi_723_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e571.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
