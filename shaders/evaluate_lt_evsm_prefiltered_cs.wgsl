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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_165_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_157_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_158_ = false;
        } else {
            phi_157_ = lt_bvh_traverse_Tree();
            phi_158_ = true;
        }
        let _e63 = phi_157_;
        let _e65 = phi_158_;
        phi_159_ = _e63;
        phi_160_ = _e65;
    } else {
        phi_159_ = lt_bvh_traverse_Tree();
        phi_160_ = true;
    }
    let _e67 = phi_159_;
    let _e69 = phi_160_;
    if _e69 {
        phi_165_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_165_ = _e67;
    }
    let _e74 = phi_165_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_192_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_207_: bool;
    var phi_211_: f32;
    var phi_223_: f32;
    var phi_228_: f32;
    var phi_250_: f32;
    var phi_255_: f32;
    var phi_256_: bool;
    var phi_257_: f32;
    var phi_258_: bool;
    var phi_262_: f32;
    var phi_300_: f32;
    var phi_313_: bool;
    var phi_317_: f32;
    var phi_330_: f32;
    var phi_335_: f32;
    var phi_357_: f32;
    var phi_362_: f32;
    var phi_363_: bool;
    var phi_364_: f32;
    var phi_365_: bool;
    var phi_369_: f32;
    var phi_407_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_194_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_193_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_192_ = 1f;
            } else {
                phi_192_ = param_5;
            }
            let _e58 = phi_192_;
            phi_193_ = _e58;
        }
        let _e60 = phi_193_;
        phi_194_ = _e60;
    }
    let _e62 = phi_194_;
    let _e64 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_207_ = true;
    } else {
        let _e68 = (42f < _e64);
        if _e68 {
        }
        phi_207_ = _e68;
    }
    let _e70 = phi_207_;
    if _e70 {
        phi_211_ = 42f;
    } else {
        phi_211_ = _e64;
    }
    let _e72 = phi_211_;
    let _e73 = (_e72 * _e62);
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_300_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_223_ = -87f;
        } else {
            phi_223_ = _e73;
        }
        let _e79 = phi_223_;
        if (_e79 > 88f) {
            phi_228_ = 88f;
        } else {
            phi_228_ = _e79;
        }
        let _e82 = phi_228_;
        let _e84 = ((_e82 * 1.442695f) + 0.5f);
        if (_e84 > -8388608f) {
            let _e96 = f32(select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < bitcast<f32>(3472883712u))), 2147483647i, (_e84 > bitcast<f32>(1325400063u))), (_e84 == _e84)));
            if (_e96 > _e84) {
                phi_250_ = 1f;
            } else {
                phi_250_ = 0f;
            }
            let _e99 = phi_250_;
            if (_e84 < 8388608f) {
                phi_255_ = (_e96 - _e99);
                phi_256_ = false;
            } else {
                phi_255_ = f32();
                phi_256_ = true;
            }
            let _e102 = phi_255_;
            let _e104 = phi_256_;
            phi_257_ = _e102;
            phi_258_ = _e104;
        } else {
            phi_257_ = f32();
            phi_258_ = true;
        }
        let _e106 = phi_257_;
        let _e108 = phi_258_;
        if _e108 {
            phi_262_ = _e84;
        } else {
            phi_262_ = _e106;
        }
        let _e110 = phi_262_;
        let _e114 = ((_e82 - (_e110 * 0.69314575f)) - (_e110 * 0.0000014286068f));
        phi_300_ = ((((((((((((((((1f / 5040f) * _e114) + (1f / 720f)) * _e114) + (1f / 120f)) * _e114) + (1f / 24f)) * _e114) + (1f / 6f)) * _e114) + 0.5f) * _e114) + 1f) * _e114) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < bitcast<f32>(3472883712u))), 2147483647i, (_e110 > bitcast<f32>(1325400063u))), (_e110 == _e110)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e150 = phi_300_;
    let _e152 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_313_ = true;
    } else {
        let _e156 = (42f < _e152);
        if _e156 {
        }
        phi_313_ = _e156;
    }
    let _e158 = phi_313_;
    if _e158 {
        phi_317_ = 42f;
    } else {
        phi_317_ = _e152;
    }
    let _e160 = phi_317_;
    let _e162 = (-(_e160) * _e62);
    if ((bitcast<u32>(_e162) & 2147483647u) > 2139095040u) {
        phi_407_ = _e162;
    } else {
        if (_e162 < -87f) {
            phi_330_ = -87f;
        } else {
            phi_330_ = _e162;
        }
        let _e168 = phi_330_;
        if (_e168 > 88f) {
            phi_335_ = 88f;
        } else {
            phi_335_ = _e168;
        }
        let _e171 = phi_335_;
        let _e173 = ((_e171 * 1.442695f) + 0.5f);
        if (_e173 > -8388608f) {
            let _e185 = f32(select(0i, select(select(i32(_e173), i32(-2147483648), (_e173 < bitcast<f32>(3472883712u))), 2147483647i, (_e173 > bitcast<f32>(1325400063u))), (_e173 == _e173)));
            if (_e185 > _e173) {
                phi_357_ = 1f;
            } else {
                phi_357_ = 0f;
            }
            let _e188 = phi_357_;
            if (_e173 < 8388608f) {
                phi_362_ = (_e185 - _e188);
                phi_363_ = false;
            } else {
                phi_362_ = f32();
                phi_363_ = true;
            }
            let _e191 = phi_362_;
            let _e193 = phi_363_;
            phi_364_ = _e191;
            phi_365_ = _e193;
        } else {
            phi_364_ = f32();
            phi_365_ = true;
        }
        let _e195 = phi_364_;
        let _e197 = phi_365_;
        if _e197 {
            phi_369_ = _e173;
        } else {
            phi_369_ = _e195;
        }
        let _e199 = phi_369_;
        let _e203 = ((_e171 - (_e199 * 0.69314575f)) - (_e199 * 0.0000014286068f));
        phi_407_ = ((((((((((((((((1f / 5040f) * _e203) + (1f / 720f)) * _e203) + (1f / 120f)) * _e203) + (1f / 24f)) * _e203) + (1f / 6f)) * _e203) + 0.5f) * _e203) + 1f) * _e203) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e199), i32(-2147483648), (_e199 < bitcast<f32>(3472883712u))), 2147483647i, (_e199 > bitcast<f32>(1325400063u))), (_e199 == _e199)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e239 = phi_407_;
    let _e240 = -(_e239);
    return vec4<f32>(_e150, (_e150 * _e150), _e240, (_e240 * _e240));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_429_: bool;
    var phi_433_: f32;
    var phi_457_: bool;
    var phi_461_: f32;
    var phi_473_: bool;
    var phi_480_: f32;
    var phi_493_: bool;
    var phi_497_: f32;
    var phi_521_: bool;
    var phi_525_: f32;
    var phi_537_: bool;
    var phi_544_: f32;
    var phi_555_: bool;
    var phi_559_: f32;
    var phi_574_: f32;
    var phi_575_: f32;
    var phi_576_: f32;

    let _e53 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e55 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_429_ = true;
    } else {
        let _e59 = (42f < _e55);
        if _e59 {
        }
        phi_429_ = _e59;
    }
    let _e61 = phi_429_;
    if _e61 {
        phi_433_ = 42f;
    } else {
        phi_433_ = _e55;
    }
    let _e63 = phi_433_;
    let _e65 = (*param_6).min_variance;
    let _e69 = (((_e65 * _e63) * _e63) * _e53.y);
    let _e76 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_457_ = true;
    } else {
        let _e80 = (_e69 > _e76);
        if _e80 {
        }
        phi_457_ = _e80;
    }
    let _e82 = phi_457_;
    if _e82 {
        phi_461_ = _e69;
    } else {
        phi_461_ = _e76;
    }
    let _e84 = phi_461_;
    let _e85 = (_e53.x - param_7.x);
    if (_e85 <= 0f) {
        let _e89 = ((bitcast<u32>(_e84) & 2147483647u) > 2139095040u);
        if _e89 {
        }
        phi_473_ = _e89;
    } else {
        phi_473_ = true;
    }
    let _e91 = phi_473_;
    if _e91 {
        phi_480_ = (_e84 / (_e84 + (_e85 * _e85)));
    } else {
        phi_480_ = 1f;
    }
    let _e96 = phi_480_;
    let _e98 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_493_ = true;
    } else {
        let _e102 = (42f < _e98);
        if _e102 {
        }
        phi_493_ = _e102;
    }
    let _e104 = phi_493_;
    if _e104 {
        phi_497_ = 42f;
    } else {
        phi_497_ = _e98;
    }
    let _e106 = phi_497_;
    let _e108 = (*param_6).min_variance;
    let _e112 = (((_e108 * _e106) * _e106) * _e53.w);
    let _e119 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
        phi_521_ = true;
    } else {
        let _e123 = (_e112 > _e119);
        if _e123 {
        }
        phi_521_ = _e123;
    }
    let _e125 = phi_521_;
    if _e125 {
        phi_525_ = _e112;
    } else {
        phi_525_ = _e119;
    }
    let _e127 = phi_525_;
    let _e128 = (_e53.z - param_7.z);
    if (_e128 <= 0f) {
        let _e132 = ((bitcast<u32>(_e127) & 2147483647u) > 2139095040u);
        if _e132 {
        }
        phi_537_ = _e132;
    } else {
        phi_537_ = true;
    }
    let _e134 = phi_537_;
    if _e134 {
        phi_544_ = (_e127 / (_e127 + (_e128 * _e128)));
    } else {
        phi_544_ = 1f;
    }
    let _e139 = phi_544_;
    if ((bitcast<u32>(_e139) & 2147483647u) > 2139095040u) {
        phi_555_ = true;
    } else {
        let _e143 = (_e139 < _e96);
        if _e143 {
        }
        phi_555_ = _e143;
    }
    let _e145 = phi_555_;
    if _e145 {
        phi_559_ = _e139;
    } else {
        phi_559_ = _e96;
    }
    let _e147 = phi_559_;
    if ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u) {
        phi_576_ = _e147;
    } else {
        if (_e147 < 0f) {
            phi_575_ = 0f;
        } else {
            if (_e147 > 1f) {
                phi_574_ = 1f;
            } else {
                phi_574_ = _e147;
            }
            let _e154 = phi_574_;
            phi_575_ = _e154;
        }
        let _e156 = phi_575_;
        phi_576_ = _e156;
    }
    let _e158 = phi_576_;
    return _e158;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_639_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_721_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_722_: bool;
    var phi_723_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_724_: bool;
    var phi_731_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_735_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_809_: bool;
    var phi_818_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_837_: bool;
    var phi_927_: f32;
    var phi_930_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_965_: bool;
    var phi_966_: f32;
    var phi_967_: bool;
    var phi_971_: f32;
    var phi_991_: f32;
    var phi_996_: f32;
    var phi_997_: bool;
    var phi_998_: f32;
    var phi_999_: bool;
    var phi_1003_: f32;
    var phi_1055_: i32;
    var phi_1060_: i32;
    var phi_1065_: i32;
    var phi_1070_: i32;
    var phi_1079_: i32;
    var phi_1084_: i32;
    var phi_1089_: i32;
    var phi_1094_: i32;
    var phi_1191_: bool;
    var phi_1199_: bool;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1216_: f32;
    var phi_1222_: f32;
    var phi_1224_: evaluate_Verdict;
    var phi_1234_: u32;
    var phi_1243_: f32;
    var phi_1245_: evaluate_Verdict;
    var phi_1246_: bool;
    var phi_1247_: evaluate_Verdict;
    var phi_1248_: bool;
    var phi_1253_: evaluate_Verdict;
    var phi_1258_: evaluate_Verdict;
    var phi_1259_: evaluate_Verdict;

    let _e51 = id_1;
    let _e58 = arrayLength((&map.member));
    let _e64 = p.member.size[0u];
    let _e66 = p.member.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e51, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e73 = p.member.projection;
        if (_e67.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e77 = lt_math_OneLevel(_e73);
        let _e81 = samples.member[(0u + _e67.first_primitive)].normal[0u];
        let _e83 = global[0u];
        if (_e81 == _e83) {
            let _e86 = samples.member[(0u + _e67.first_primitive)].normal[1u];
            let _e88 = global[1u];
            if (_e86 == _e88) {
                let _e91 = samples.member[(0u + _e67.first_primitive)].normal[2u];
                let _e93 = global[2u];
                phi_632_ = (_e91 == _e93);
                phi_633_ = false;
            } else {
                phi_632_ = bool();
                phi_633_ = true;
            }
            let _e96 = phi_632_;
            let _e98 = phi_633_;
            phi_634_ = _e96;
            phi_635_ = _e98;
        } else {
            phi_634_ = bool();
            phi_635_ = true;
        }
        let _e100 = phi_634_;
        let _e102 = phi_635_;
        if _e102 {
            phi_639_ = false;
        } else {
            phi_639_ = _e100;
        }
        let _e104 = phi_639_;
        if !(_e104) {
            let _e107 = samples.member[(0u + _e67.first_primitive)].position;
            let _e109 = p.member.light.place;
            let _e115 = p.member.light.place[3u];
            let _e122 = (_e109.x - (_e107.x * _e115));
            let _e123 = (_e109.y - (_e107.y * _e115));
            let _e124 = (_e109.z - (_e107.z * _e115));
            let _e126 = samples.member[(0u + _e67.first_primitive)].normal;
            if ((((_e126.x * _e122) + (_e126.y * _e123)) + (_e126.z * _e124)) > 0f) {
                let _e140 = (((_e122 * _e122) + (_e123 * _e123)) + (_e124 * _e124));
                let _e142 = p.member.light.axis;
                let _e154 = p.member.light.place[3u];
                if (_e154 == 0f) {
                    phi_710_ = true;
                } else {
                    let _e157 = p.member.light.range_squared;
                    if (_e140 <= _e157) {
                        let _e160 = p.member.light.cos_outer;
                        phi_709_ = (-((((_e122 * _e142.x) + (_e123 * _e142.y)) + (_e124 * _e142.z))) >= (_e160 * sqrt(_e140)));
                    } else {
                        phi_709_ = false;
                    }
                    let _e165 = phi_709_;
                    phi_710_ = _e165;
                }
                let _e167 = phi_710_;
                if _e167 {
                    let _e169 = samples.member[(0u + _e67.first_primitive)].flags;
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
                    phi_721_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, ((_e169 & 1u) == 0u));
                    phi_722_ = false;
                } else {
                    phi_721_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_722_ = true;
                }
                let _e188 = phi_721_;
                let _e190 = phi_722_;
                phi_723_ = _e188;
                phi_724_ = _e190;
            } else {
                phi_723_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_724_ = true;
            }
            let _e192 = phi_723_;
            let _e194 = phi_724_;
            if _e194 {
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
                phi_731_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
            } else {
                phi_731_ = _e192;
            }
            let _e211 = phi_731_;
            phi_735_ = _e211;
        } else {
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e223 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e217.unnamed.visibility, false), _e217.unnamed_1);
            phi_735_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e223.unnamed, true);
        }
        let _e228 = phi_735_;
        if _e228.unnamed_1 {
            phi_1259_ = evaluate_Verdict(_e228.unnamed.visibility, _e228.unnamed.is_doubted);
        } else {
            let _e236 = samples.member[(0u + _e67.first_primitive)].position;
            let _e254 = ((((_e77.projection.row_w.x * _e236.x) + (_e77.projection.row_w.y * _e236.y)) + (_e77.projection.row_w.z * _e236.z)) + (_e77.projection.row_w.w * 1f));
            let _e268 = (((((_e77.projection.row_x.x * _e236.x) + (_e77.projection.row_x.y * _e236.y)) + (_e77.projection.row_x.z * _e236.z)) + (_e77.projection.row_x.w * 1f)) / _e254);
            let _e282 = (((((_e77.projection.row_y.x * _e236.x) + (_e77.projection.row_y.y * _e236.y)) + (_e77.projection.row_y.z * _e236.z)) + (_e77.projection.row_y.w * 1f)) / _e254);
            let _e295 = ((((_e77.projection.row_z.x * _e236.x) + (_e77.projection.row_z.y * _e236.y)) + (_e77.projection.row_z.z * _e236.z)) + (_e77.projection.row_z.w * 1f));
            if (_e254 > 0f) {
                if (_e268 >= 0f) {
                    phi_809_ = (_e268 <= 1f);
                } else {
                    phi_809_ = false;
                }
                let _e300 = phi_809_;
                if _e300 {
                    if (_e282 >= 0f) {
                        phi_818_ = (_e282 <= 1f);
                    } else {
                        phi_818_ = false;
                    }
                    let _e304 = phi_818_;
                    if _e304 {
                        if (_e295 >= 0f) {
                            phi_827_ = (_e295 <= 1f);
                        } else {
                            phi_827_ = false;
                        }
                        let _e308 = phi_827_;
                        phi_828_ = _e308;
                        phi_829_ = false;
                    } else {
                        phi_828_ = bool();
                        phi_829_ = true;
                    }
                    let _e310 = phi_828_;
                    let _e312 = phi_829_;
                    phi_830_ = _e310;
                    phi_831_ = _e312;
                } else {
                    phi_830_ = bool();
                    phi_831_ = true;
                }
                let _e314 = phi_830_;
                let _e316 = phi_831_;
                phi_832_ = _e314;
                phi_833_ = _e316;
            } else {
                phi_832_ = bool();
                phi_833_ = true;
            }
            let _e318 = phi_832_;
            let _e320 = phi_833_;
            if _e320 {
                phi_837_ = false;
            } else {
                phi_837_ = _e318;
            }
            let _e322 = phi_837_;
            if _e322 {
                if (0f > 0f) {
                    let _e325 = samples.member[(0u + _e67.first_primitive)].normal;
                    let _e327 = p.member.map_size;
                    let _e397 = ((abs(((((_e73.row_x.x * _e325.x) + (_e73.row_x.y * _e325.y)) + (_e73.row_x.z * _e325.z)) / (((_e73.row_x.x * _e73.row_x.x) + (_e73.row_x.y * _e73.row_x.y)) + (_e73.row_x.z * _e73.row_x.z)))) + abs(((((_e73.row_y.x * _e325.x) + (_e73.row_y.y * _e325.y)) + (_e73.row_y.z * _e325.z)) / (((_e73.row_y.x * _e73.row_y.x) + (_e73.row_y.y * _e73.row_y.y)) + (_e73.row_y.z * _e73.row_y.z))))) / (abs(((((_e73.row_z.x * _e325.x) + (_e73.row_z.y * _e325.y)) + (_e73.row_z.z * _e325.z)) / (((_e73.row_z.x * _e73.row_z.x) + (_e73.row_z.y * _e73.row_z.y)) + (_e73.row_z.z * _e73.row_z.z)))) * f32(_e327)));
                    if (_e397 < 0.002f) {
                        phi_927_ = _e397;
                    } else {
                        phi_927_ = 0.002f;
                    }
                    let _e400 = phi_927_;
                    phi_930_ = (_e295 - (0f * _e400));
                } else {
                    phi_930_ = _e295;
                }
                let _e404 = phi_930_;
                let _e406 = p.member.map_size;
                let _e407 = f32(_e406);
                let _e410 = ((_e268 * _e407) - 0.5f);
                let _e411 = ((_e282 * _e407) - 0.5f);
                if (_e410 > -8388608f) {
                    let _e423 = f32(select(0i, select(select(i32(_e410), i32(-2147483648), (_e410 < bitcast<f32>(3472883712u))), 2147483647i, (_e410 > bitcast<f32>(1325400063u))), (_e410 == _e410)));
                    if (_e423 > _e410) {
                        phi_959_ = 1f;
                    } else {
                        phi_959_ = 0f;
                    }
                    let _e426 = phi_959_;
                    if (_e410 < 8388608f) {
                        phi_964_ = (_e423 - _e426);
                        phi_965_ = false;
                    } else {
                        phi_964_ = f32();
                        phi_965_ = true;
                    }
                    let _e429 = phi_964_;
                    let _e431 = phi_965_;
                    phi_966_ = _e429;
                    phi_967_ = _e431;
                } else {
                    phi_966_ = f32();
                    phi_967_ = true;
                }
                let _e433 = phi_966_;
                let _e435 = phi_967_;
                if _e435 {
                    phi_971_ = _e410;
                } else {
                    phi_971_ = _e433;
                }
                let _e437 = phi_971_;
                if (_e411 > -8388608f) {
                    let _e449 = f32(select(0i, select(select(i32(_e411), i32(-2147483648), (_e411 < bitcast<f32>(3472883712u))), 2147483647i, (_e411 > bitcast<f32>(1325400063u))), (_e411 == _e411)));
                    if (_e449 > _e411) {
                        phi_991_ = 1f;
                    } else {
                        phi_991_ = 0f;
                    }
                    let _e452 = phi_991_;
                    if (_e411 < 8388608f) {
                        phi_996_ = (_e449 - _e452);
                        phi_997_ = false;
                    } else {
                        phi_996_ = f32();
                        phi_997_ = true;
                    }
                    let _e455 = phi_996_;
                    let _e457 = phi_997_;
                    phi_998_ = _e455;
                    phi_999_ = _e457;
                } else {
                    phi_998_ = f32();
                    phi_999_ = true;
                }
                let _e459 = phi_998_;
                let _e461 = phi_999_;
                if _e461 {
                    phi_1003_ = _e411;
                } else {
                    phi_1003_ = _e459;
                }
                let _e463 = phi_1003_;
                let _e464 = (_e410 - _e437);
                let _e465 = (_e411 - _e463);
                let _e474 = select(0i, select(select(i32(_e437), i32(-2147483648), (_e437 < bitcast<f32>(3472883712u))), 2147483647i, (_e437 > bitcast<f32>(1325400063u))), (_e437 == _e437));
                let _e483 = select(0i, select(select(i32(_e463), i32(-2147483648), (_e463 < bitcast<f32>(3472883712u))), 2147483647i, (_e463 > bitcast<f32>(1325400063u))), (_e463 == _e463));
                let _e486 = ((1f - _e464) * (1f - _e465));
                let _e488 = (_e464 * (1f - _e465));
                let _e490 = ((1f - _e464) * _e465);
                let _e491 = (_e464 * _e465);
                let _e493 = p.member.test;
                let _e494 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e493);
                let _e496 = p.member.map_size;
                local = lt_math_Evsm(_e494.positive_exponent, _e494.negative_exponent, _e494.min_variance);
                let _e502 = ((0u * _e496) * _e496);
                let _e504 = (bitcast<i32>(_e496) - 1i);
                if (_e474 > 0i) {
                    phi_1055_ = _e474;
                } else {
                    phi_1055_ = 0i;
                }
                let _e507 = phi_1055_;
                if (_e483 > 0i) {
                    phi_1060_ = _e483;
                } else {
                    phi_1060_ = 0i;
                }
                let _e510 = phi_1060_;
                if (_e507 < _e504) {
                    phi_1065_ = _e507;
                } else {
                    phi_1065_ = _e504;
                }
                let _e513 = phi_1065_;
                if (_e510 < _e504) {
                    phi_1070_ = _e510;
                } else {
                    phi_1070_ = _e504;
                }
                let _e516 = phi_1070_;
                let _e517 = bitcast<u32>(_e513);
                let _e519 = (_e474 + 1i);
                let _e520 = (_e483 + 1i);
                if (_e519 > 0i) {
                    phi_1079_ = _e519;
                } else {
                    phi_1079_ = 0i;
                }
                let _e523 = phi_1079_;
                if (_e520 > 0i) {
                    phi_1084_ = _e520;
                } else {
                    phi_1084_ = 0i;
                }
                let _e526 = phi_1084_;
                if (_e523 < _e504) {
                    phi_1089_ = _e523;
                } else {
                    phi_1089_ = _e504;
                }
                let _e529 = phi_1089_;
                if (_e526 < _e504) {
                    phi_1094_ = _e526;
                } else {
                    phi_1094_ = _e504;
                }
                let _e532 = phi_1094_;
                let _e533 = bitcast<u32>(_e529);
                let _e535 = (bitcast<u32>(_e516) * _e496);
                let _e536 = (bitcast<u32>(_e532) * _e496);
                let _e541 = ((_e535 + _e517) + _e502);
                let _e542 = ((_e535 + _e533) + _e502);
                let _e543 = ((_e536 + _e517) + _e502);
                let _e544 = ((_e536 + _e533) + _e502);
                if (_e541 < _e58) {
                } else {
                    return;
                }
                let _e548 = map.member[(0u + _e541)];
                if (_e542 < _e58) {
                } else {
                    return;
                }
                let _e560 = map.member[(0u + _e542)];
                if (_e543 < _e58) {
                } else {
                    return;
                }
                let _e576 = map.member[(0u + _e543)];
                if (_e544 < _e58) {
                } else {
                    return;
                }
                let _e592 = map.member[(0u + _e544)];
                let _e606 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e548.x * _e486) + (_e560.x * _e488)) + (_e576.x * _e490)) + (_e592.x * _e491)), ((((_e548.y * _e486) + (_e560.y * _e488)) + (_e576.y * _e490)) + (_e592.y * _e491)), ((((_e548.z * _e486) + (_e560.z * _e488)) + (_e576.z * _e490)) + (_e592.z * _e491)), ((((_e548.w * _e486) + (_e560.w * _e488)) + (_e576.w * _e490)) + (_e592.w * _e491))), _e404);
                let _e610 = p.member.epsilon;
                if (_e606 <= _e610) {
                    phi_1191_ = true;
                } else {
                    phi_1191_ = (_e606 >= (1f - _e610));
                }
                let _e615 = phi_1191_;
                if ((bitcast<u32>(_e606) & 2147483647u) > 2139095040u) {
                    phi_1199_ = true;
                } else {
                    phi_1199_ = !(_e615);
                }
                let _e621 = phi_1199_;
                if _e621 {
                    if (_e606 > 0f) {
                        if (_e606 < 1f) {
                            phi_1211_ = false;
                        } else {
                            phi_1211_ = true;
                        }
                        let _e625 = phi_1211_;
                        phi_1212_ = _e625;
                    } else {
                        phi_1212_ = true;
                    }
                    let _e627 = phi_1212_;
                    if _e627 {
                        phi_1216_ = 0.5f;
                    } else {
                        phi_1216_ = _e606;
                    }
                    let _e629 = phi_1216_;
                    phi_1224_ = evaluate_Verdict(_e629, true);
                } else {
                    if (_e606 > 0.5f) {
                        phi_1222_ = 1f;
                    } else {
                        phi_1222_ = 0f;
                    }
                    let _e633 = phi_1222_;
                    phi_1224_ = evaluate_Verdict(_e633, false);
                }
                let _e636 = phi_1224_;
                let _e639 = (_e636.visibility < 0.5f);
                if _e636.is_doubted {
                    phi_1247_ = evaluate_Verdict();
                    phi_1248_ = true;
                } else {
                    if _e639 {
                        phi_1234_ = 2u;
                    } else {
                        phi_1234_ = 1u;
                    }
                    let _e641 = phi_1234_;
                    if ((0u & _e641) != 0u) {
                        if _e639 {
                            phi_1243_ = 0.000000059604645f;
                        } else {
                            phi_1243_ = 0.99999994f;
                        }
                        let _e645 = phi_1243_;
                        phi_1245_ = evaluate_Verdict(_e645, true);
                        phi_1246_ = false;
                    } else {
                        phi_1245_ = evaluate_Verdict();
                        phi_1246_ = true;
                    }
                    let _e648 = phi_1245_;
                    let _e650 = phi_1246_;
                    phi_1247_ = _e648;
                    phi_1248_ = _e650;
                }
                let _e652 = phi_1247_;
                let _e654 = phi_1248_;
                if _e654 {
                    phi_1253_ = evaluate_Verdict(_e636.visibility, _e636.is_doubted);
                } else {
                    phi_1253_ = _e652;
                }
                let _e657 = phi_1253_;
                phi_1258_ = evaluate_Verdict(_e657.visibility, _e657.is_doubted);
            } else {
                phi_1258_ = evaluate_Verdict(0.5f, true);
            }
            let _e663 = phi_1258_;
            phi_1259_ = _e663;
        }
        let _e665 = phi_1259_;
        if (_e67.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e67.first_primitive)] = _e665.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
