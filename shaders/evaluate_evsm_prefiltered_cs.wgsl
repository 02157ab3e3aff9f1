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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_32 {
    member: array<vec4<f32>>,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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

struct type_36 {
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
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(2) 
var<storage> map: type_32;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_159_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_151_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_152_ = false;
        } else {
            phi_151_ = lt_bvh_traverse_Tree();
            phi_152_ = true;
        }
        let _e56 = phi_151_;
        let _e58 = phi_152_;
        phi_153_ = _e56;
        phi_154_ = _e58;
    } else {
        phi_153_ = lt_bvh_traverse_Tree();
        phi_154_ = true;
    }
    let _e60 = phi_153_;
    let _e62 = phi_154_;
    if _e62 {
        phi_159_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_159_ = _e60;
    }
    let _e67 = phi_159_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_426_: bool;
    var phi_430_: f32;
    var phi_431_: f32;

    let _e45 = (*param_4).negative_exponent;
    if ((bitcast<u32>(_e45) & 2147483647u) > 2139095040u) {
        phi_431_ = _e45;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_426_ = true;
        } else {
            let _e52 = (42f < _e45);
            if _e52 {
            }
            phi_426_ = _e52;
        }
        let _e54 = phi_426_;
        if _e54 {
            phi_430_ = 42f;
        } else {
            phi_430_ = _e45;
        }
        let _e56 = phi_430_;
        phi_431_ = _e56;
    }
    let _e58 = phi_431_;
    return _e58;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_400_: bool;
    var phi_404_: f32;
    var phi_405_: f32;

    let _e45 = (*param_5).positive_exponent;
    if ((bitcast<u32>(_e45) & 2147483647u) > 2139095040u) {
        phi_405_ = _e45;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_400_ = true;
        } else {
            let _e52 = (42f < _e45);
            if _e52 {
            }
            phi_400_ = _e52;
        }
        let _e54 = phi_400_;
        if _e54 {
            phi_404_ = 42f;
        } else {
            phi_404_ = _e45;
        }
        let _e56 = phi_404_;
        phi_405_ = _e56;
    }
    let _e58 = phi_405_;
    return _e58;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_213_: bool;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_235_: bool;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_281_: f32;
    var phi_307_: bool;
    var phi_311_: f32;
    var phi_312_: f32;
    var phi_329_: bool;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_375_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_188_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_187_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_186_ = 1f;
            } else {
                phi_186_ = param_7;
            }
            let _e51 = phi_186_;
            phi_187_ = _e51;
        }
        let _e53 = phi_187_;
        phi_188_ = _e53;
    }
    let _e55 = phi_188_;
    let _e56 = _lt_math_evsm_Evsm_positive(param_6);
    let _e57 = (_e56 * _e55);
    if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
        phi_281_ = _e57;
    } else {
        if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
            phi_218_ = _e57;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_213_ = true;
            } else {
                let _e67 = (-87f > _e57);
                if _e67 {
                }
                phi_213_ = _e67;
            }
            let _e69 = phi_213_;
            if _e69 {
                phi_217_ = -87f;
            } else {
                phi_217_ = _e57;
            }
            let _e71 = phi_217_;
            phi_218_ = _e71;
        }
        let _e73 = phi_218_;
        if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
            phi_240_ = _e73;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_235_ = true;
            } else {
                let _e80 = (88f < _e73);
                if _e80 {
                }
                phi_235_ = _e80;
            }
            let _e82 = phi_235_;
            if _e82 {
                phi_239_ = 88f;
            } else {
                phi_239_ = _e73;
            }
            let _e84 = phi_239_;
            phi_240_ = _e84;
        }
        let _e86 = phi_240_;
        let _e89 = floor(((_e86 * 1.442695f) + 0.5f));
        let _e93 = ((_e86 - (_e89 * 0.69314575f)) - (_e89 * 0.0000014286068f));
        phi_281_ = ((((((((((((((((1f / 5040f) * _e93) + (1f / 720f)) * _e93) + (1f / 120f)) * _e93) + (1f / 24f)) * _e93) + (1f / 6f)) * _e93) + 0.5f) * _e93) + 1f) * _e93) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e89), i32(-2147483648), (_e89 < bitcast<f32>(3472883712u))), 2147483647i, (_e89 > bitcast<f32>(1325400063u))), (_e89 == _e89)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e129 = phi_281_;
    let _e130 = _lt_math_evsm_Evsm_negative(param_6);
    let _e132 = (-(_e130) * _e55);
    if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
        phi_375_ = _e132;
    } else {
        if ((bitcast<u32>(_e132) & 2147483647u) > 2139095040u) {
            phi_312_ = _e132;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_307_ = true;
            } else {
                let _e142 = (-87f > _e132);
                if _e142 {
                }
                phi_307_ = _e142;
            }
            let _e144 = phi_307_;
            if _e144 {
                phi_311_ = -87f;
            } else {
                phi_311_ = _e132;
            }
            let _e146 = phi_311_;
            phi_312_ = _e146;
        }
        let _e148 = phi_312_;
        if ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u) {
            phi_334_ = _e148;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_329_ = true;
            } else {
                let _e155 = (88f < _e148);
                if _e155 {
                }
                phi_329_ = _e155;
            }
            let _e157 = phi_329_;
            if _e157 {
                phi_333_ = 88f;
            } else {
                phi_333_ = _e148;
            }
            let _e159 = phi_333_;
            phi_334_ = _e159;
        }
        let _e161 = phi_334_;
        let _e164 = floor(((_e161 * 1.442695f) + 0.5f));
        let _e168 = ((_e161 - (_e164 * 0.69314575f)) - (_e164 * 0.0000014286068f));
        phi_375_ = ((((((((((((((((1f / 5040f) * _e168) + (1f / 720f)) * _e168) + (1f / 120f)) * _e168) + (1f / 24f)) * _e168) + (1f / 6f)) * _e168) + 0.5f) * _e168) + 1f) * _e168) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e164), i32(-2147483648), (_e164 < bitcast<f32>(3472883712u))), 2147483647i, (_e164 > bitcast<f32>(1325400063u))), (_e164 == _e164)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e204 = phi_375_;
    let _e205 = -(_e204);
    return vec4<f32>(_e129, (_e129 * _e129), _e205, (_e205 * _e205));
}

fn lt_shaders_evaluate_to_light(param_8: vec3<f32>, param_9: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_9.x - (param_8.x * param_9.w)), (param_9.y - (param_8.y * param_9.w)), (param_9.z - (param_8.z * param_9.w)));
}

fn lt_shaders_evaluate_quad_indices(param_10: i32, param_11: i32, param_12: u32) -> array<u32, 4> {
    var phi_459_: i32;
    var phi_464_: i32;
    var phi_469_: i32;
    var phi_474_: i32;
    var phi_483_: i32;
    var phi_488_: i32;
    var phi_493_: i32;
    var phi_498_: i32;

    let _e47 = (bitcast<i32>(param_12) - 1i);
    if (param_10 > 0i) {
        phi_459_ = param_10;
    } else {
        phi_459_ = 0i;
    }
    let _e50 = phi_459_;
    if (param_11 > 0i) {
        phi_464_ = param_11;
    } else {
        phi_464_ = 0i;
    }
    let _e53 = phi_464_;
    if (_e50 < _e47) {
        phi_469_ = _e50;
    } else {
        phi_469_ = _e47;
    }
    let _e56 = phi_469_;
    if (_e53 < _e47) {
        phi_474_ = _e53;
    } else {
        phi_474_ = _e47;
    }
    let _e59 = phi_474_;
    let _e60 = bitcast<u32>(_e56);
    let _e62 = (param_10 + 1i);
    let _e63 = (param_11 + 1i);
    if (_e62 > 0i) {
        phi_483_ = _e62;
    } else {
        phi_483_ = 0i;
    }
    let _e66 = phi_483_;
    if (_e63 > 0i) {
        phi_488_ = _e63;
    } else {
        phi_488_ = 0i;
    }
    let _e69 = phi_488_;
    if (_e66 < _e47) {
        phi_493_ = _e66;
    } else {
        phi_493_ = _e47;
    }
    let _e72 = phi_493_;
    if (_e69 < _e47) {
        phi_498_ = _e69;
    } else {
        phi_498_ = _e47;
    }
    let _e75 = phi_498_;
    let _e76 = bitcast<u32>(_e72);
    let _e78 = (bitcast<u32>(_e59) * param_12);
    let _e79 = (bitcast<u32>(_e75) * param_12);
    return array<u32, 4>((_e78 + _e60), (_e78 + _e76), (_e79 + _e60), (_e79 + _e76));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13: ptr<function, lt_math_Evsm>, param_14: vec4<f32>, param_15: f32) -> f32 {
    var phi_909_: bool;
    var phi_913_: f32;
    var phi_914_: f32;
    var phi_931_: bool;
    var phi_935_: f32;
    var phi_936_: f32;
    var phi_948_: bool;
    var phi_955_: f32;
    var phi_985_: bool;
    var phi_989_: f32;
    var phi_990_: f32;
    var phi_1007_: bool;
    var phi_1011_: f32;
    var phi_1012_: f32;
    var phi_1024_: bool;
    var phi_1031_: f32;
    var phi_1048_: bool;
    var phi_1052_: f32;
    var phi_1053_: f32;
    var phi_1068_: f32;
    var phi_1069_: f32;
    var phi_1070_: f32;

    let _e46 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_13, param_15);
    let _e47 = _lt_math_evsm_Evsm_positive(param_13);
    let _e49 = (*param_13).min_variance;
    let _e53 = (((_e49 * _e47) * _e47) * _e46.y);
    let _e58 = (param_14.y - (param_14.x * param_14.x));
    let _e59 = (0.00000047683716f * param_14.y);
    if ((bitcast<u32>(_e53) & 2147483647u) > 2139095040u) {
        phi_914_ = _e53;
    } else {
        if ((bitcast<u32>(_e59) & 2147483647u) > 2139095040u) {
            phi_909_ = true;
        } else {
            let _e66 = (_e59 > _e53);
            if _e66 {
            }
            phi_909_ = _e66;
        }
        let _e68 = phi_909_;
        if _e68 {
            phi_913_ = _e59;
        } else {
            phi_913_ = _e53;
        }
        let _e70 = phi_913_;
        phi_914_ = _e70;
    }
    let _e72 = phi_914_;
    if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
        phi_936_ = _e58;
    } else {
        if ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u) {
            phi_931_ = true;
        } else {
            let _e79 = (_e72 > _e58);
            if _e79 {
            }
            phi_931_ = _e79;
        }
        let _e81 = phi_931_;
        if _e81 {
            phi_935_ = _e72;
        } else {
            phi_935_ = _e58;
        }
        let _e83 = phi_935_;
        phi_936_ = _e83;
    }
    let _e85 = phi_936_;
    let _e86 = (_e46.x - param_14.x);
    if (_e86 <= 0f) {
        let _e90 = ((bitcast<u32>(_e85) & 2147483647u) > 2139095040u);
        if _e90 {
        }
        phi_948_ = _e90;
    } else {
        phi_948_ = true;
    }
    let _e92 = phi_948_;
    if _e92 {
        phi_955_ = (_e85 / (_e85 + (_e86 * _e86)));
    } else {
        phi_955_ = 1f;
    }
    let _e97 = phi_955_;
    let _e98 = _lt_math_evsm_Evsm_negative(param_13);
    let _e100 = (*param_13).min_variance;
    let _e104 = (((_e100 * _e98) * _e98) * _e46.w);
    let _e109 = (param_14.w - (param_14.z * param_14.z));
    let _e110 = (0.00000047683716f * param_14.w);
    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
        phi_990_ = _e104;
    } else {
        if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
            phi_985_ = true;
        } else {
            let _e117 = (_e110 > _e104);
            if _e117 {
            }
            phi_985_ = _e117;
        }
        let _e119 = phi_985_;
        if _e119 {
            phi_989_ = _e110;
        } else {
            phi_989_ = _e104;
        }
        let _e121 = phi_989_;
        phi_990_ = _e121;
    }
    let _e123 = phi_990_;
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_1012_ = _e109;
    } else {
        if ((bitcast<u32>(_e123) & 2147483647u) > 2139095040u) {
            phi_1007_ = true;
        } else {
            let _e130 = (_e123 > _e109);
            if _e130 {
            }
            phi_1007_ = _e130;
        }
        let _e132 = phi_1007_;
        if _e132 {
            phi_1011_ = _e123;
        } else {
            phi_1011_ = _e109;
        }
        let _e134 = phi_1011_;
        phi_1012_ = _e134;
    }
    let _e136 = phi_1012_;
    let _e137 = (_e46.z - param_14.z);
    if (_e137 <= 0f) {
        let _e141 = ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u);
        if _e141 {
        }
        phi_1024_ = _e141;
    } else {
        phi_1024_ = true;
    }
    let _e143 = phi_1024_;
    if _e143 {
        phi_1031_ = (_e136 / (_e136 + (_e137 * _e137)));
    } else {
        phi_1031_ = 1f;
    }
    let _e148 = phi_1031_;
    if ((bitcast<u32>(_e97) & 2147483647u) > 2139095040u) {
        phi_1053_ = _e97;
    } else {
        if ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u) {
            phi_1048_ = true;
        } else {
            let _e155 = (_e148 < _e97);
            if _e155 {
            }
            phi_1048_ = _e155;
        }
        let _e157 = phi_1048_;
        if _e157 {
            phi_1052_ = _e148;
        } else {
            phi_1052_ = _e97;
        }
        let _e159 = phi_1052_;
        phi_1053_ = _e159;
    }
    let _e161 = phi_1053_;
    if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
        phi_1070_ = _e161;
    } else {
        if (_e161 < 0f) {
            phi_1069_ = 0f;
        } else {
            if (_e161 > 1f) {
                phi_1068_ = 1f;
            } else {
                phi_1068_ = _e161;
            }
            let _e168 = phi_1068_;
            phi_1069_ = _e168;
        }
        let _e170 = phi_1069_;
        phi_1070_ = _e170;
    }
    let _e172 = phi_1070_;
    return _e172;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_563_: bool;
    var phi_564_: bool;
    var phi_568_: bool;
    var phi_603_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_607_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_715_: bool;
    var phi_858_: evaluate_Verdict;
    var phi_859_: evaluate_Verdict;
    var phi_860_: bool;
    var phi_861_: evaluate_Verdict;
    var phi_862_: evaluate_Verdict;
    var phi_863_: bool;
    var phi_867_: evaluate_Verdict;

    let _e44 = id_1;
    let _e51 = arrayLength((&map.member));
    let _e57 = p.member.size[0u];
    let _e59 = p.member.size[1u];
    let _e60 = lt_shaders_entry_pixel_index(_e44, _e57, _e59);
    if (bitcast<i32>(_e60.root) != 0i) {
        if (_e60.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e69 = p.member.light;
        let _e72 = samples.member[(0u + _e60.first_primitive)].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[(0u + _e60.first_primitive)].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[(0u + _e60.first_primitive)].normal[2u];
                let _e84 = global[2u];
                phi_561_ = (_e82 == _e84);
                phi_562_ = false;
            } else {
                phi_561_ = bool();
                phi_562_ = true;
            }
            let _e87 = phi_561_;
            let _e89 = phi_562_;
            phi_563_ = _e87;
            phi_564_ = _e89;
        } else {
            phi_563_ = bool();
            phi_564_ = true;
        }
        let _e91 = phi_563_;
        let _e93 = phi_564_;
        if _e93 {
            phi_568_ = false;
        } else {
            phi_568_ = _e91;
        }
        let _e95 = phi_568_;
        if !(_e95) {
            let _e98 = samples.member[(0u + _e60.first_primitive)].normal;
            let _e100 = samples.member[(0u + _e60.first_primitive)].position;
            let _e101 = lt_shaders_evaluate_to_light(_e100, _e69);
            if ((((_e98.x * _e101.x) + (_e98.y * _e101.y)) + (_e98.z * _e101.z)) > 0f) {
                let _e115 = samples.member[(0u + _e60.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_603_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_603_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_603_;
            phi_607_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_607_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_607_;
        if _e166.unnamed_1 {
            phi_861_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
            phi_862_ = evaluate_Verdict();
            phi_863_ = true;
        } else {
            let _e174 = samples.member[(0u + _e60.first_primitive)].position;
            let _e180 = p.member.projection.row_w;
            let _e191 = ((((_e180.x * _e174.x) + (_e180.y * _e174.y)) + (_e180.z * _e174.z)) + (_e180.w * 1f));
            let _e193 = p.member.projection.row_x;
            let _e205 = (((((_e193.x * _e174.x) + (_e193.y * _e174.y)) + (_e193.z * _e174.z)) + (_e193.w * 1f)) / _e191);
            let _e207 = p.member.projection.row_y;
            let _e219 = (((((_e207.x * _e174.x) + (_e207.y * _e174.y)) + (_e207.z * _e174.z)) + (_e207.w * 1f)) / _e191);
            let _e221 = p.member.projection.row_z;
            let _e232 = ((((_e221.x * _e174.x) + (_e221.y * _e174.y)) + (_e221.z * _e174.z)) + (_e221.w * 1f));
            if (_e191 > 0f) {
                if (_e205 >= 0f) {
                    if (_e205 <= 1f) {
                        if (_e219 >= 0f) {
                            if (_e219 <= 1f) {
                                if (_e232 >= 0f) {
                                    phi_700_ = (_e232 <= 1f);
                                    phi_701_ = false;
                                } else {
                                    phi_700_ = bool();
                                    phi_701_ = true;
                                }
                                let _e241 = phi_700_;
                                let _e243 = phi_701_;
                                phi_702_ = _e241;
                                phi_703_ = _e243;
                            } else {
                                phi_702_ = bool();
                                phi_703_ = true;
                            }
                            let _e245 = phi_702_;
                            let _e247 = phi_703_;
                            phi_704_ = _e245;
                            phi_705_ = _e247;
                        } else {
                            phi_704_ = bool();
                            phi_705_ = true;
                        }
                        let _e249 = phi_704_;
                        let _e251 = phi_705_;
                        phi_706_ = _e249;
                        phi_707_ = _e251;
                    } else {
                        phi_706_ = bool();
                        phi_707_ = true;
                    }
                    let _e253 = phi_706_;
                    let _e255 = phi_707_;
                    phi_708_ = _e253;
                    phi_709_ = _e255;
                } else {
                    phi_708_ = bool();
                    phi_709_ = true;
                }
                let _e257 = phi_708_;
                let _e259 = phi_709_;
                phi_710_ = _e257;
                phi_711_ = _e259;
            } else {
                phi_710_ = bool();
                phi_711_ = true;
            }
            let _e261 = phi_710_;
            let _e263 = phi_711_;
            if _e263 {
                phi_715_ = false;
            } else {
                phi_715_ = _e261;
            }
            let _e265 = phi_715_;
            if _e265 {
                let _e267 = p.member.map_size;
                let _e268 = f32(_e267);
                let _e271 = ((_e205 * _e268) - 0.5f);
                let _e272 = ((_e219 * _e268) - 0.5f);
                let _e273 = floor(_e271);
                let _e274 = floor(_e272);
                let _e275 = (_e271 - _e273);
                let _e276 = (_e272 - _e274);
                let _e297 = ((1f - _e275) * (1f - _e276));
                let _e299 = (_e275 * (1f - _e276));
                let _e301 = ((1f - _e275) * _e276);
                let _e302 = (_e275 * _e276);
                let _e304 = p.member.test;
                let _e305 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e304);
                let _e307 = p.member.map_size;
                local = lt_math_Evsm(_e305.positive_exponent, _e305.negative_exponent, _e305.min_variance);
                let _e312 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < bitcast<f32>(3472883712u))), 2147483647i, (_e273 > bitcast<f32>(1325400063u))), (_e273 == _e273)), select(0i, select(select(i32(_e274), i32(-2147483648), (_e274 < bitcast<f32>(3472883712u))), 2147483647i, (_e274 > bitcast<f32>(1325400063u))), (_e274 == _e274)), _e307);
                if (_e312[0] < _e51) {
                } else {
                    return;
                }
                let _e317 = map.member[(0u + _e312[0])];
                if (_e312[1] < _e51) {
                } else {
                    return;
                }
                let _e330 = map.member[(0u + _e312[1])];
                if (_e312[2] < _e51) {
                } else {
                    return;
                }
                let _e347 = map.member[(0u + _e312[2])];
                if (_e312[3] < _e51) {
                } else {
                    return;
                }
                let _e364 = map.member[(0u + _e312[3])];
                let _e378 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e317.x * _e297) + (_e330.x * _e299)) + (_e347.x * _e301)) + (_e364.x * _e302)), ((((_e317.y * _e297) + (_e330.y * _e299)) + (_e347.y * _e301)) + (_e364.y * _e302)), ((((_e317.z * _e297) + (_e330.z * _e299)) + (_e347.z * _e301)) + (_e364.z * _e302)), ((((_e317.w * _e297) + (_e330.w * _e299)) + (_e347.w * _e301)) + (_e364.w * _e302))), _e232);
                phi_858_ = evaluate_Verdict(_e378, false);
                phi_859_ = evaluate_Verdict();
                phi_860_ = false;
            } else {
                phi_858_ = evaluate_Verdict();
                phi_859_ = evaluate_Verdict(1f, false);
                phi_860_ = true;
            }
            let _e382 = phi_858_;
            let _e384 = phi_859_;
            let _e386 = phi_860_;
            phi_861_ = _e384;
            phi_862_ = _e382;
            phi_863_ = _e386;
        }
        let _e388 = phi_861_;
        let _e390 = phi_862_;
        let _e392 = phi_863_;
        if _e392 {
            phi_867_ = _e388;
        } else {
            phi_867_ = _e390;
        }
        let _e394 = phi_867_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e394.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
