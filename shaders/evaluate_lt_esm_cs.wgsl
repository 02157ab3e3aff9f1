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
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_150_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_142_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_143_ = false;
        } else {
            phi_142_ = lt_bvh_traverse_Tree();
            phi_143_ = true;
        }
        let _e59 = phi_142_;
        let _e61 = phi_143_;
        phi_144_ = _e59;
        phi_145_ = _e61;
    } else {
        phi_144_ = lt_bvh_traverse_Tree();
        phi_145_ = true;
    }
    let _e63 = phi_144_;
    let _e65 = phi_145_;
    if _e65 {
        phi_150_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_150_ = _e63;
    }
    let _e70 = phi_150_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_173_: bool;
    var phi_177_: f32;
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_264_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_285_: f32;
    var phi_290_: f32;
    var phi_312_: f32;
    var phi_317_: f32;
    var phi_318_: bool;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_324_: f32;
    var phi_362_: f32;
    var phi_373_: f32;
    var phi_378_: f32;
    var phi_400_: f32;
    var phi_405_: f32;
    var phi_406_: bool;
    var phi_407_: f32;
    var phi_408_: bool;
    var phi_412_: f32;
    var phi_450_: f32;
    var phi_461_: f32;
    var phi_466_: f32;
    var phi_488_: f32;
    var phi_493_: f32;
    var phi_494_: bool;
    var phi_495_: f32;
    var phi_496_: bool;
    var phi_500_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_554_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_588_: f32;
    var phi_626_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: f32;

    let _e50 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_173_ = true;
    } else {
        let _e54 = (84f < _e50);
        if _e54 {
        }
        phi_173_ = _e54;
    }
    let _e56 = phi_173_;
    if _e56 {
        phi_177_ = 84f;
    } else {
        phi_177_ = _e50;
    }
    let _e58 = phi_177_;
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_194_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_193_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_192_ = 1f;
            } else {
                phi_192_ = param_7;
            }
            let _e65 = phi_192_;
            phi_193_ = _e65;
        }
        let _e67 = phi_193_;
        phi_194_ = _e67;
    }
    let _e69 = phi_194_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_212_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_5.x;
            }
            let _e77 = phi_210_;
            phi_211_ = _e77;
        }
        let _e79 = phi_211_;
        phi_212_ = _e79;
    }
    let _e81 = phi_212_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_230_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_229_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_228_ = 1f;
            } else {
                phi_228_ = param_5.y;
            }
            let _e89 = phi_228_;
            phi_229_ = _e89;
        }
        let _e91 = phi_229_;
        phi_230_ = _e91;
    }
    let _e93 = phi_230_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_248_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_247_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_246_ = 1f;
            } else {
                phi_246_ = param_5.z;
            }
            let _e101 = phi_246_;
            phi_247_ = _e101;
        }
        let _e103 = phi_247_;
        phi_248_ = _e103;
    }
    let _e105 = phi_248_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_266_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_265_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_264_ = 1f;
            } else {
                phi_264_ = param_5.w;
            }
            let _e113 = phi_264_;
            phi_265_ = _e113;
        }
        let _e115 = phi_265_;
        phi_266_ = _e115;
    }
    let _e117 = phi_266_;
    let _e122 = (_e58 * (_e81 - _e69));
    let _e123 = (_e58 * (_e93 - _e69));
    let _e124 = (_e58 * (_e105 - _e69));
    let _e125 = (_e58 * (_e117 - _e69));
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_362_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_285_ = -87f;
        } else {
            phi_285_ = _e122;
        }
        let _e131 = phi_285_;
        if (_e131 > 88f) {
            phi_290_ = 88f;
        } else {
            phi_290_ = _e131;
        }
        let _e134 = phi_290_;
        let _e136 = ((_e134 * 1.442695f) + 0.5f);
        if (_e136 > -8388608f) {
            let _e148 = f32(select(0i, select(select(i32(_e136), i32(-2147483648), (_e136 < bitcast<f32>(3472883712u))), 2147483647i, (_e136 > bitcast<f32>(1325400063u))), (_e136 == _e136)));
            if (_e148 > _e136) {
                phi_312_ = 1f;
            } else {
                phi_312_ = 0f;
            }
            let _e151 = phi_312_;
            if (_e136 < 8388608f) {
                phi_317_ = (_e148 - _e151);
                phi_318_ = false;
            } else {
                phi_317_ = f32();
                phi_318_ = true;
            }
            let _e154 = phi_317_;
            let _e156 = phi_318_;
            phi_319_ = _e154;
            phi_320_ = _e156;
        } else {
            phi_319_ = f32();
            phi_320_ = true;
        }
        let _e158 = phi_319_;
        let _e160 = phi_320_;
        if _e160 {
            phi_324_ = _e136;
        } else {
            phi_324_ = _e158;
        }
        let _e162 = phi_324_;
        let _e166 = ((_e134 - (_e162 * 0.69314575f)) - (_e162 * 0.0000014286068f));
        phi_362_ = ((((((((((((((((1f / 5040f) * _e166) + (1f / 720f)) * _e166) + (1f / 120f)) * _e166) + (1f / 24f)) * _e166) + (1f / 6f)) * _e166) + 0.5f) * _e166) + 1f) * _e166) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e162), i32(-2147483648), (_e162 < bitcast<f32>(3472883712u))), 2147483647i, (_e162 > bitcast<f32>(1325400063u))), (_e162 == _e162)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e202 = phi_362_;
    if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
        phi_450_ = _e123;
    } else {
        if (_e123 < -87f) {
            phi_373_ = -87f;
        } else {
            phi_373_ = _e123;
        }
        let _e208 = phi_373_;
        if (_e208 > 88f) {
            phi_378_ = 88f;
        } else {
            phi_378_ = _e208;
        }
        let _e211 = phi_378_;
        let _e213 = ((_e211 * 1.442695f) + 0.5f);
        if (_e213 > -8388608f) {
            let _e225 = f32(select(0i, select(select(i32(_e213), i32(-2147483648), (_e213 < bitcast<f32>(3472883712u))), 2147483647i, (_e213 > bitcast<f32>(1325400063u))), (_e213 == _e213)));
            if (_e225 > _e213) {
                phi_400_ = 1f;
            } else {
                phi_400_ = 0f;
            }
            let _e228 = phi_400_;
            if (_e213 < 8388608f) {
                phi_405_ = (_e225 - _e228);
                phi_406_ = false;
            } else {
                phi_405_ = f32();
                phi_406_ = true;
            }
            let _e231 = phi_405_;
            let _e233 = phi_406_;
            phi_407_ = _e231;
            phi_408_ = _e233;
        } else {
            phi_407_ = f32();
            phi_408_ = true;
        }
        let _e235 = phi_407_;
        let _e237 = phi_408_;
        if _e237 {
            phi_412_ = _e213;
        } else {
            phi_412_ = _e235;
        }
        let _e239 = phi_412_;
        let _e243 = ((_e211 - (_e239 * 0.69314575f)) - (_e239 * 0.0000014286068f));
        phi_450_ = ((((((((((((((((1f / 5040f) * _e243) + (1f / 720f)) * _e243) + (1f / 120f)) * _e243) + (1f / 24f)) * _e243) + (1f / 6f)) * _e243) + 0.5f) * _e243) + 1f) * _e243) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e279 = phi_450_;
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_538_ = _e124;
    } else {
        if (_e124 < -87f) {
            phi_461_ = -87f;
        } else {
            phi_461_ = _e124;
        }
        let _e285 = phi_461_;
        if (_e285 > 88f) {
            phi_466_ = 88f;
        } else {
            phi_466_ = _e285;
        }
        let _e288 = phi_466_;
        let _e290 = ((_e288 * 1.442695f) + 0.5f);
        if (_e290 > -8388608f) {
            let _e302 = f32(select(0i, select(select(i32(_e290), i32(-2147483648), (_e290 < bitcast<f32>(3472883712u))), 2147483647i, (_e290 > bitcast<f32>(1325400063u))), (_e290 == _e290)));
            if (_e302 > _e290) {
                phi_488_ = 1f;
            } else {
                phi_488_ = 0f;
            }
            let _e305 = phi_488_;
            if (_e290 < 8388608f) {
                phi_493_ = (_e302 - _e305);
                phi_494_ = false;
            } else {
                phi_493_ = f32();
                phi_494_ = true;
            }
            let _e308 = phi_493_;
            let _e310 = phi_494_;
            phi_495_ = _e308;
            phi_496_ = _e310;
        } else {
            phi_495_ = f32();
            phi_496_ = true;
        }
        let _e312 = phi_495_;
        let _e314 = phi_496_;
        if _e314 {
            phi_500_ = _e290;
        } else {
            phi_500_ = _e312;
        }
        let _e316 = phi_500_;
        let _e320 = ((_e288 - (_e316 * 0.69314575f)) - (_e316 * 0.0000014286068f));
        phi_538_ = ((((((((((((((((1f / 5040f) * _e320) + (1f / 720f)) * _e320) + (1f / 120f)) * _e320) + (1f / 24f)) * _e320) + (1f / 6f)) * _e320) + 0.5f) * _e320) + 1f) * _e320) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e316), i32(-2147483648), (_e316 < bitcast<f32>(3472883712u))), 2147483647i, (_e316 > bitcast<f32>(1325400063u))), (_e316 == _e316)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e356 = phi_538_;
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_626_ = _e125;
    } else {
        if (_e125 < -87f) {
            phi_549_ = -87f;
        } else {
            phi_549_ = _e125;
        }
        let _e362 = phi_549_;
        if (_e362 > 88f) {
            phi_554_ = 88f;
        } else {
            phi_554_ = _e362;
        }
        let _e365 = phi_554_;
        let _e367 = ((_e365 * 1.442695f) + 0.5f);
        if (_e367 > -8388608f) {
            let _e379 = f32(select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < bitcast<f32>(3472883712u))), 2147483647i, (_e367 > bitcast<f32>(1325400063u))), (_e367 == _e367)));
            if (_e379 > _e367) {
                phi_576_ = 1f;
            } else {
                phi_576_ = 0f;
            }
            let _e382 = phi_576_;
            if (_e367 < 8388608f) {
                phi_581_ = (_e379 - _e382);
                phi_582_ = false;
            } else {
                phi_581_ = f32();
                phi_582_ = true;
            }
            let _e385 = phi_581_;
            let _e387 = phi_582_;
            phi_583_ = _e385;
            phi_584_ = _e387;
        } else {
            phi_583_ = f32();
            phi_584_ = true;
        }
        let _e389 = phi_583_;
        let _e391 = phi_584_;
        if _e391 {
            phi_588_ = _e367;
        } else {
            phi_588_ = _e389;
        }
        let _e393 = phi_588_;
        let _e397 = ((_e365 - (_e393 * 0.69314575f)) - (_e393 * 0.0000014286068f));
        phi_626_ = ((((((((((((((((1f / 5040f) * _e397) + (1f / 720f)) * _e397) + (1f / 120f)) * _e397) + (1f / 24f)) * _e397) + (1f / 6f)) * _e397) + 0.5f) * _e397) + 1f) * _e397) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e433 = phi_626_;
    let _e444 = ((((_e202 * param_6.x) + (_e279 * param_6.y)) + (_e356 * param_6.z)) + (_e433 * param_6.w));
    if ((bitcast<u32>(_e444) & 2147483647u) > 2139095040u) {
        phi_654_ = _e444;
    } else {
        if (_e444 < 0f) {
            phi_653_ = 0f;
        } else {
            if (_e444 > 1f) {
                phi_652_ = 1f;
            } else {
                phi_652_ = _e444;
            }
            let _e451 = phi_652_;
            phi_653_ = _e451;
        }
        let _e453 = phi_653_;
        phi_654_ = _e453;
    }
    let _e455 = phi_654_;
    return _e455;
}

fn function_() {
    var local: f32;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_717_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_799_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_800_: bool;
    var phi_801_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_802_: bool;
    var phi_809_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_813_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_887_: bool;
    var phi_896_: bool;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_909_: bool;
    var phi_910_: bool;
    var phi_911_: bool;
    var phi_915_: bool;
    var phi_1005_: f32;
    var phi_1008_: f32;
    var phi_1037_: f32;
    var phi_1042_: f32;
    var phi_1043_: bool;
    var phi_1044_: f32;
    var phi_1045_: bool;
    var phi_1049_: f32;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1075_: bool;
    var phi_1076_: f32;
    var phi_1077_: bool;
    var phi_1081_: f32;
    var phi_1129_: i32;
    var phi_1134_: i32;
    var phi_1139_: i32;
    var phi_1144_: i32;
    var phi_1153_: i32;
    var phi_1158_: i32;
    var phi_1163_: i32;
    var phi_1168_: i32;
    var phi_1219_: bool;
    var phi_1227_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1244_: f32;
    var phi_1250_: f32;
    var phi_1252_: evaluate_Verdict;
    var phi_1257_: evaluate_Verdict;
    var phi_1258_: evaluate_Verdict;

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
                phi_710_ = (_e87 == _e89);
                phi_711_ = false;
            } else {
                phi_710_ = bool();
                phi_711_ = true;
            }
            let _e92 = phi_710_;
            let _e94 = phi_711_;
            phi_712_ = _e92;
            phi_713_ = _e94;
        } else {
            phi_712_ = bool();
            phi_713_ = true;
        }
        let _e96 = phi_712_;
        let _e98 = phi_713_;
        if _e98 {
            phi_717_ = false;
        } else {
            phi_717_ = _e96;
        }
        let _e100 = phi_717_;
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
                    phi_788_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_787_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_787_ = false;
                    }
                    let _e161 = phi_787_;
                    phi_788_ = _e161;
                }
                let _e163 = phi_788_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_799_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_800_ = false;
                } else {
                    phi_799_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_800_ = true;
                }
                let _e184 = phi_799_;
                let _e186 = phi_800_;
                phi_801_ = _e184;
                phi_802_ = _e186;
            } else {
                phi_801_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_802_ = true;
            }
            let _e188 = phi_801_;
            let _e190 = phi_802_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_809_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_809_ = _e188;
            }
            let _e207 = phi_809_;
            phi_813_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_813_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_813_;
        if _e224.unnamed_1 {
            phi_1258_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[(0u + _e63.first_primitive)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_887_ = (_e264 <= 1f);
                } else {
                    phi_887_ = false;
                }
                let _e296 = phi_887_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_896_ = (_e278 <= 1f);
                    } else {
                        phi_896_ = false;
                    }
                    let _e300 = phi_896_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_905_ = (_e291 <= 1f);
                        } else {
                            phi_905_ = false;
                        }
                        let _e304 = phi_905_;
                        phi_906_ = _e304;
                        phi_907_ = false;
                    } else {
                        phi_906_ = bool();
                        phi_907_ = true;
                    }
                    let _e306 = phi_906_;
                    let _e308 = phi_907_;
                    phi_908_ = _e306;
                    phi_909_ = _e308;
                } else {
                    phi_908_ = bool();
                    phi_909_ = true;
                }
                let _e310 = phi_908_;
                let _e312 = phi_909_;
                phi_910_ = _e310;
                phi_911_ = _e312;
            } else {
                phi_910_ = bool();
                phi_911_ = true;
            }
            let _e314 = phi_910_;
            let _e316 = phi_911_;
            if _e316 {
                phi_915_ = false;
            } else {
                phi_915_ = _e314;
            }
            let _e318 = phi_915_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_1005_ = _e393;
                    } else {
                        phi_1005_ = 0.002f;
                    }
                    let _e396 = phi_1005_;
                    phi_1008_ = (_e291 - (0f * _e396));
                } else {
                    phi_1008_ = _e291;
                }
                let _e400 = phi_1008_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_1037_ = 1f;
                    } else {
                        phi_1037_ = 0f;
                    }
                    let _e422 = phi_1037_;
                    if (_e406 < 8388608f) {
                        phi_1042_ = (_e419 - _e422);
                        phi_1043_ = false;
                    } else {
                        phi_1042_ = f32();
                        phi_1043_ = true;
                    }
                    let _e425 = phi_1042_;
                    let _e427 = phi_1043_;
                    phi_1044_ = _e425;
                    phi_1045_ = _e427;
                } else {
                    phi_1044_ = f32();
                    phi_1045_ = true;
                }
                let _e429 = phi_1044_;
                let _e431 = phi_1045_;
                if _e431 {
                    phi_1049_ = _e406;
                } else {
                    phi_1049_ = _e429;
                }
                let _e433 = phi_1049_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_1069_ = 1f;
                    } else {
                        phi_1069_ = 0f;
                    }
                    let _e448 = phi_1069_;
                    if (_e407 < 8388608f) {
                        phi_1074_ = (_e445 - _e448);
                        phi_1075_ = false;
                    } else {
                        phi_1074_ = f32();
                        phi_1075_ = true;
                    }
                    let _e451 = phi_1074_;
                    let _e453 = phi_1075_;
                    phi_1076_ = _e451;
                    phi_1077_ = _e453;
                } else {
                    phi_1076_ = f32();
                    phi_1077_ = true;
                }
                let _e455 = phi_1076_;
                let _e457 = phi_1077_;
                if _e457 {
                    phi_1081_ = _e407;
                } else {
                    phi_1081_ = _e455;
                }
                let _e459 = phi_1081_;
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
                    phi_1129_ = _e470;
                } else {
                    phi_1129_ = 0i;
                }
                let _e500 = phi_1129_;
                if (_e479 > 0i) {
                    phi_1134_ = _e479;
                } else {
                    phi_1134_ = 0i;
                }
                let _e503 = phi_1134_;
                if (_e500 < _e497) {
                    phi_1139_ = _e500;
                } else {
                    phi_1139_ = _e497;
                }
                let _e506 = phi_1139_;
                if (_e503 < _e497) {
                    phi_1144_ = _e503;
                } else {
                    phi_1144_ = _e497;
                }
                let _e509 = phi_1144_;
                let _e510 = bitcast<u32>(_e506);
                let _e512 = (_e470 + 1i);
                let _e513 = (_e479 + 1i);
                if (_e512 > 0i) {
                    phi_1153_ = _e512;
                } else {
                    phi_1153_ = 0i;
                }
                let _e516 = phi_1153_;
                if (_e513 > 0i) {
                    phi_1158_ = _e513;
                } else {
                    phi_1158_ = 0i;
                }
                let _e519 = phi_1158_;
                if (_e516 < _e497) {
                    phi_1163_ = _e516;
                } else {
                    phi_1163_ = _e497;
                }
                let _e522 = phi_1163_;
                if (_e519 < _e497) {
                    phi_1168_ = _e519;
                } else {
                    phi_1168_ = _e497;
                }
                let _e525 = phi_1168_;
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
                let _e557 = p.member.epsilon;
                if (_e555 <= _e557) {
                    phi_1219_ = true;
                } else {
                    phi_1219_ = (_e555 >= (1f - _e557));
                }
                let _e562 = phi_1219_;
                if ((bitcast<u32>(_e555) & 2147483647u) > 2139095040u) {
                    phi_1227_ = true;
                } else {
                    phi_1227_ = !(_e562);
                }
                let _e568 = phi_1227_;
                if _e568 {
                    if (_e555 > 0f) {
                        if (_e555 < 1f) {
                            phi_1239_ = false;
                        } else {
                            phi_1239_ = true;
                        }
                        let _e572 = phi_1239_;
                        phi_1240_ = _e572;
                    } else {
                        phi_1240_ = true;
                    }
                    let _e574 = phi_1240_;
                    if _e574 {
                        phi_1244_ = 0.5f;
                    } else {
                        phi_1244_ = _e555;
                    }
                    let _e576 = phi_1244_;
                    phi_1252_ = evaluate_Verdict(_e576, true);
                } else {
                    if (_e555 > 0.5f) {
                        phi_1250_ = 1f;
                    } else {
                        phi_1250_ = 0f;
                    }
                    let _e580 = phi_1250_;
                    phi_1252_ = evaluate_Verdict(_e580, false);
                }
                let _e583 = phi_1252_;
                phi_1257_ = evaluate_Verdict(_e583.visibility, _e583.is_doubted);
            } else {
                phi_1257_ = evaluate_Verdict(0.5f, true);
            }
            let _e589 = phi_1257_;
            phi_1258_ = _e589;
        }
        let _e591 = phi_1258_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e591.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
