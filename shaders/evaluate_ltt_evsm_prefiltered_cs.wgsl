struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_36 {
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

struct type_41 {
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

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_27;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e64 = phi_163_;
        let _e66 = phi_164_;
        phi_165_ = _e64;
        phi_166_ = _e66;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e68 = phi_165_;
    let _e70 = phi_166_;
    if _e70 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e68;
    }
    let _e75 = phi_171_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_213_: bool;
    var phi_217_: f32;
    var phi_229_: f32;
    var phi_234_: f32;
    var phi_256_: f32;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_268_: f32;
    var phi_306_: f32;
    var phi_319_: bool;
    var phi_323_: f32;
    var phi_336_: f32;
    var phi_341_: f32;
    var phi_363_: f32;
    var phi_368_: f32;
    var phi_369_: bool;
    var phi_370_: f32;
    var phi_371_: bool;
    var phi_375_: f32;
    var phi_413_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_200_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_199_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_198_ = 1f;
            } else {
                phi_198_ = param_5;
            }
            let _e59 = phi_198_;
            phi_199_ = _e59;
        }
        let _e61 = phi_199_;
        phi_200_ = _e61;
    }
    let _e63 = phi_200_;
    let _e65 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_213_ = true;
    } else {
        let _e69 = (42f < _e65);
        if _e69 {
        }
        phi_213_ = _e69;
    }
    let _e71 = phi_213_;
    if _e71 {
        phi_217_ = 42f;
    } else {
        phi_217_ = _e65;
    }
    let _e73 = phi_217_;
    let _e74 = (_e73 * _e63);
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_306_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_229_ = -87f;
        } else {
            phi_229_ = _e74;
        }
        let _e80 = phi_229_;
        if (_e80 > 88f) {
            phi_234_ = 88f;
        } else {
            phi_234_ = _e80;
        }
        let _e83 = phi_234_;
        let _e85 = ((_e83 * 1.442695f) + 0.5f);
        if (_e85 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(_e85), i32(-2147483648), (_e85 < bitcast<f32>(3472883712u))), 2147483647i, (_e85 > bitcast<f32>(1325400063u))), (_e85 == _e85)));
            if (_e97 > _e85) {
                phi_256_ = 1f;
            } else {
                phi_256_ = 0f;
            }
            let _e100 = phi_256_;
            if (_e85 < 8388608f) {
                phi_261_ = (_e97 - _e100);
                phi_262_ = false;
            } else {
                phi_261_ = f32();
                phi_262_ = true;
            }
            let _e103 = phi_261_;
            let _e105 = phi_262_;
            phi_263_ = _e103;
            phi_264_ = _e105;
        } else {
            phi_263_ = f32();
            phi_264_ = true;
        }
        let _e107 = phi_263_;
        let _e109 = phi_264_;
        if _e109 {
            phi_268_ = _e85;
        } else {
            phi_268_ = _e107;
        }
        let _e111 = phi_268_;
        let _e115 = ((_e83 - (_e111 * 0.69314575f)) - (_e111 * 0.0000014286068f));
        phi_306_ = ((((((((((((((((1f / 5040f) * _e115) + (1f / 720f)) * _e115) + (1f / 120f)) * _e115) + (1f / 24f)) * _e115) + (1f / 6f)) * _e115) + 0.5f) * _e115) + 1f) * _e115) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < bitcast<f32>(3472883712u))), 2147483647i, (_e111 > bitcast<f32>(1325400063u))), (_e111 == _e111)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e151 = phi_306_;
    let _e153 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_319_ = true;
    } else {
        let _e157 = (42f < _e153);
        if _e157 {
        }
        phi_319_ = _e157;
    }
    let _e159 = phi_319_;
    if _e159 {
        phi_323_ = 42f;
    } else {
        phi_323_ = _e153;
    }
    let _e161 = phi_323_;
    let _e163 = (-(_e161) * _e63);
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_413_ = _e163;
    } else {
        if (_e163 < -87f) {
            phi_336_ = -87f;
        } else {
            phi_336_ = _e163;
        }
        let _e169 = phi_336_;
        if (_e169 > 88f) {
            phi_341_ = 88f;
        } else {
            phi_341_ = _e169;
        }
        let _e172 = phi_341_;
        let _e174 = ((_e172 * 1.442695f) + 0.5f);
        if (_e174 > -8388608f) {
            let _e186 = f32(select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < bitcast<f32>(3472883712u))), 2147483647i, (_e174 > bitcast<f32>(1325400063u))), (_e174 == _e174)));
            if (_e186 > _e174) {
                phi_363_ = 1f;
            } else {
                phi_363_ = 0f;
            }
            let _e189 = phi_363_;
            if (_e174 < 8388608f) {
                phi_368_ = (_e186 - _e189);
                phi_369_ = false;
            } else {
                phi_368_ = f32();
                phi_369_ = true;
            }
            let _e192 = phi_368_;
            let _e194 = phi_369_;
            phi_370_ = _e192;
            phi_371_ = _e194;
        } else {
            phi_370_ = f32();
            phi_371_ = true;
        }
        let _e196 = phi_370_;
        let _e198 = phi_371_;
        if _e198 {
            phi_375_ = _e174;
        } else {
            phi_375_ = _e196;
        }
        let _e200 = phi_375_;
        let _e204 = ((_e172 - (_e200 * 0.69314575f)) - (_e200 * 0.0000014286068f));
        phi_413_ = ((((((((((((((((1f / 5040f) * _e204) + (1f / 720f)) * _e204) + (1f / 120f)) * _e204) + (1f / 24f)) * _e204) + (1f / 6f)) * _e204) + 0.5f) * _e204) + 1f) * _e204) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e200), i32(-2147483648), (_e200 < bitcast<f32>(3472883712u))), 2147483647i, (_e200 > bitcast<f32>(1325400063u))), (_e200 == _e200)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e240 = phi_413_;
    let _e241 = -(_e240);
    return vec4<f32>(_e151, (_e151 * _e151), _e241, (_e241 * _e241));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_435_: bool;
    var phi_439_: f32;
    var phi_463_: bool;
    var phi_467_: f32;
    var phi_479_: bool;
    var phi_486_: f32;
    var phi_499_: bool;
    var phi_503_: f32;
    var phi_527_: bool;
    var phi_531_: f32;
    var phi_543_: bool;
    var phi_550_: f32;
    var phi_561_: bool;
    var phi_565_: f32;
    var phi_580_: f32;
    var phi_581_: f32;
    var phi_582_: f32;

    let _e54 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e56 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_435_ = true;
    } else {
        let _e60 = (42f < _e56);
        if _e60 {
        }
        phi_435_ = _e60;
    }
    let _e62 = phi_435_;
    if _e62 {
        phi_439_ = 42f;
    } else {
        phi_439_ = _e56;
    }
    let _e64 = phi_439_;
    let _e66 = (*param_6).min_variance;
    let _e70 = (((_e66 * _e64) * _e64) * _e54.y);
    let _e77 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_463_ = true;
    } else {
        let _e81 = (_e70 > _e77);
        if _e81 {
        }
        phi_463_ = _e81;
    }
    let _e83 = phi_463_;
    if _e83 {
        phi_467_ = _e70;
    } else {
        phi_467_ = _e77;
    }
    let _e85 = phi_467_;
    let _e86 = (_e54.x - param_7.x);
    if (_e86 <= 0f) {
        let _e90 = ((bitcast<u32>(_e85) & 2147483647u) > 2139095040u);
        if _e90 {
        }
        phi_479_ = _e90;
    } else {
        phi_479_ = true;
    }
    let _e92 = phi_479_;
    if _e92 {
        phi_486_ = (_e85 / (_e85 + (_e86 * _e86)));
    } else {
        phi_486_ = 1f;
    }
    let _e97 = phi_486_;
    let _e99 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_499_ = true;
    } else {
        let _e103 = (42f < _e99);
        if _e103 {
        }
        phi_499_ = _e103;
    }
    let _e105 = phi_499_;
    if _e105 {
        phi_503_ = 42f;
    } else {
        phi_503_ = _e99;
    }
    let _e107 = phi_503_;
    let _e109 = (*param_6).min_variance;
    let _e113 = (((_e109 * _e107) * _e107) * _e54.w);
    let _e120 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
        phi_527_ = true;
    } else {
        let _e124 = (_e113 > _e120);
        if _e124 {
        }
        phi_527_ = _e124;
    }
    let _e126 = phi_527_;
    if _e126 {
        phi_531_ = _e113;
    } else {
        phi_531_ = _e120;
    }
    let _e128 = phi_531_;
    let _e129 = (_e54.z - param_7.z);
    if (_e129 <= 0f) {
        let _e133 = ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u);
        if _e133 {
        }
        phi_543_ = _e133;
    } else {
        phi_543_ = true;
    }
    let _e135 = phi_543_;
    if _e135 {
        phi_550_ = (_e128 / (_e128 + (_e129 * _e129)));
    } else {
        phi_550_ = 1f;
    }
    let _e140 = phi_550_;
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_561_ = true;
    } else {
        let _e144 = (_e140 < _e97);
        if _e144 {
        }
        phi_561_ = _e144;
    }
    let _e146 = phi_561_;
    if _e146 {
        phi_565_ = _e140;
    } else {
        phi_565_ = _e97;
    }
    let _e148 = phi_565_;
    if ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u) {
        phi_582_ = _e148;
    } else {
        if (_e148 < 0f) {
            phi_581_ = 0f;
        } else {
            if (_e148 > 1f) {
                phi_580_ = 1f;
            } else {
                phi_580_ = _e148;
            }
            let _e155 = phi_580_;
            phi_581_ = _e155;
        }
        let _e157 = phi_581_;
        phi_582_ = _e157;
    }
    let _e159 = phi_582_;
    return _e159;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_643_: bool;
    var phi_687_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_691_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_768_: bool;
    var phi_777_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_791_: bool;
    var phi_792_: bool;
    var phi_796_: bool;
    var phi_890_: f32;
    var phi_893_: f32;
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_928_: bool;
    var phi_929_: f32;
    var phi_930_: bool;
    var phi_934_: f32;
    var phi_954_: f32;
    var phi_959_: f32;
    var phi_960_: bool;
    var phi_961_: f32;
    var phi_962_: bool;
    var phi_966_: f32;
    var phi_1016_: i32;
    var phi_1021_: i32;
    var phi_1026_: i32;
    var phi_1031_: i32;
    var phi_1040_: i32;
    var phi_1045_: i32;
    var phi_1050_: i32;
    var phi_1055_: i32;
    var phi_1146_: bool;
    var phi_1154_: bool;
    var phi_1159_: f32;
    var phi_1162_: evaluate_Verdict;
    var phi_1163_: evaluate_Verdict;
    var phi_1167_: bool;
    var phi_1168_: u32;
    var phi_1174_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e65 = p.member.size[0u];
    let _e67 = p.member.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e52, _e65, _e67);
    if (bitcast<i32>(_e68.root) != 0i) {
        let _e75 = p.member.light;
        let _e78 = samples.member[_e68.first_primitive].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[_e68.first_primitive].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[_e68.first_primitive].normal[2u];
                let _e90 = global[2u];
                phi_636_ = (_e88 == _e90);
                phi_637_ = false;
            } else {
                phi_636_ = bool();
                phi_637_ = true;
            }
            let _e93 = phi_636_;
            let _e95 = phi_637_;
            phi_638_ = _e93;
            phi_639_ = _e95;
        } else {
            phi_638_ = bool();
            phi_639_ = true;
        }
        let _e97 = phi_638_;
        let _e99 = phi_639_;
        if _e99 {
            phi_643_ = false;
        } else {
            phi_643_ = _e97;
        }
        let _e101 = phi_643_;
        if !(_e101) {
            let _e104 = samples.member[_e68.first_primitive].normal;
            let _e106 = samples.member[_e68.first_primitive].position;
            if ((((_e104.x * (_e75.x - (_e106.x * _e75.w))) + (_e104.y * (_e75.y - (_e106.y * _e75.w)))) + (_e104.z * (_e75.z - (_e106.z * _e75.w)))) > 0f) {
                let _e130 = samples.member[_e68.first_primitive].flags;
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_687_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, ((_e130 & 1u) == 0u));
            } else {
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e153.unnamed.visibility, false), _e153.unnamed_1);
                phi_687_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e159.unnamed, true);
            }
            let _e164 = phi_687_;
            phi_691_ = _e164;
        } else {
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
            phi_691_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, true);
        }
        let _e181 = phi_691_;
        if _e181.unnamed_1 {
            phi_1163_ = evaluate_Verdict(_e181.unnamed.visibility, _e181.unnamed.is_doubted);
        } else {
            let _e189 = samples.member[_e68.first_primitive].position;
            let _e195 = p.member.projection.row_w;
            let _e206 = ((((_e195.x * _e189.x) + (_e195.y * _e189.y)) + (_e195.z * _e189.z)) + (_e195.w * 1f));
            let _e208 = p.member.projection.row_x;
            let _e220 = (((((_e208.x * _e189.x) + (_e208.y * _e189.y)) + (_e208.z * _e189.z)) + (_e208.w * 1f)) / _e206);
            let _e222 = p.member.projection.row_y;
            let _e234 = (((((_e222.x * _e189.x) + (_e222.y * _e189.y)) + (_e222.z * _e189.z)) + (_e222.w * 1f)) / _e206);
            let _e236 = p.member.projection.row_z;
            let _e247 = ((((_e236.x * _e189.x) + (_e236.y * _e189.y)) + (_e236.z * _e189.z)) + (_e236.w * 1f));
            if (_e206 > 0f) {
                if (_e220 >= 0f) {
                    phi_768_ = (_e220 <= 1f);
                } else {
                    phi_768_ = false;
                }
                let _e252 = phi_768_;
                if _e252 {
                    if (_e234 >= 0f) {
                        phi_777_ = (_e234 <= 1f);
                    } else {
                        phi_777_ = false;
                    }
                    let _e256 = phi_777_;
                    if _e256 {
                        if (_e247 >= 0f) {
                            phi_786_ = (_e247 <= 1f);
                        } else {
                            phi_786_ = false;
                        }
                        let _e260 = phi_786_;
                        phi_787_ = _e260;
                        phi_788_ = false;
                    } else {
                        phi_787_ = bool();
                        phi_788_ = true;
                    }
                    let _e262 = phi_787_;
                    let _e264 = phi_788_;
                    phi_789_ = _e262;
                    phi_790_ = _e264;
                } else {
                    phi_789_ = bool();
                    phi_790_ = true;
                }
                let _e266 = phi_789_;
                let _e268 = phi_790_;
                phi_791_ = _e266;
                phi_792_ = _e268;
            } else {
                phi_791_ = bool();
                phi_792_ = true;
            }
            let _e270 = phi_791_;
            let _e272 = phi_792_;
            if _e272 {
                phi_796_ = false;
            } else {
                phi_796_ = _e270;
            }
            let _e274 = phi_796_;
            if _e274 {
                if (0f > 0f) {
                    let _e277 = samples.member[_e68.first_primitive].normal;
                    let _e279 = p.member.map_size;
                    let _e282 = p.member.projection.row_x;
                    let _e304 = p.member.projection.row_y;
                    let _e326 = p.member.projection.row_z;
                    let _e353 = ((abs(((((_e282.x * _e277.x) + (_e282.y * _e277.y)) + (_e282.z * _e277.z)) / (((_e282.x * _e282.x) + (_e282.y * _e282.y)) + (_e282.z * _e282.z)))) + abs(((((_e304.x * _e277.x) + (_e304.y * _e277.y)) + (_e304.z * _e277.z)) / (((_e304.x * _e304.x) + (_e304.y * _e304.y)) + (_e304.z * _e304.z))))) / (abs(((((_e326.x * _e277.x) + (_e326.y * _e277.y)) + (_e326.z * _e277.z)) / (((_e326.x * _e326.x) + (_e326.y * _e326.y)) + (_e326.z * _e326.z)))) * f32(_e279)));
                    if (_e353 < 0.002f) {
                        phi_890_ = _e353;
                    } else {
                        phi_890_ = 0.002f;
                    }
                    let _e356 = phi_890_;
                    phi_893_ = (_e247 - (0f * _e356));
                } else {
                    phi_893_ = _e247;
                }
                let _e360 = phi_893_;
                let _e362 = p.member.map_size;
                let _e363 = f32(_e362);
                let _e366 = ((_e220 * _e363) - 0.5f);
                let _e367 = ((_e234 * _e363) - 0.5f);
                if (_e366 > -8388608f) {
                    let _e379 = f32(select(0i, select(select(i32(_e366), i32(-2147483648), (_e366 < bitcast<f32>(3472883712u))), 2147483647i, (_e366 > bitcast<f32>(1325400063u))), (_e366 == _e366)));
                    if (_e379 > _e366) {
                        phi_922_ = 1f;
                    } else {
                        phi_922_ = 0f;
                    }
                    let _e382 = phi_922_;
                    if (_e366 < 8388608f) {
                        phi_927_ = (_e379 - _e382);
                        phi_928_ = false;
                    } else {
                        phi_927_ = f32();
                        phi_928_ = true;
                    }
                    let _e385 = phi_927_;
                    let _e387 = phi_928_;
                    phi_929_ = _e385;
                    phi_930_ = _e387;
                } else {
                    phi_929_ = f32();
                    phi_930_ = true;
                }
                let _e389 = phi_929_;
                let _e391 = phi_930_;
                if _e391 {
                    phi_934_ = _e366;
                } else {
                    phi_934_ = _e389;
                }
                let _e393 = phi_934_;
                if (_e367 > -8388608f) {
                    let _e405 = f32(select(0i, select(select(i32(_e367), i32(-2147483648), (_e367 < bitcast<f32>(3472883712u))), 2147483647i, (_e367 > bitcast<f32>(1325400063u))), (_e367 == _e367)));
                    if (_e405 > _e367) {
                        phi_954_ = 1f;
                    } else {
                        phi_954_ = 0f;
                    }
                    let _e408 = phi_954_;
                    if (_e367 < 8388608f) {
                        phi_959_ = (_e405 - _e408);
                        phi_960_ = false;
                    } else {
                        phi_959_ = f32();
                        phi_960_ = true;
                    }
                    let _e411 = phi_959_;
                    let _e413 = phi_960_;
                    phi_961_ = _e411;
                    phi_962_ = _e413;
                } else {
                    phi_961_ = f32();
                    phi_962_ = true;
                }
                let _e415 = phi_961_;
                let _e417 = phi_962_;
                if _e417 {
                    phi_966_ = _e367;
                } else {
                    phi_966_ = _e415;
                }
                let _e419 = phi_966_;
                let _e420 = (_e366 - _e393);
                let _e421 = (_e367 - _e419);
                let _e430 = select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393));
                let _e439 = select(0i, select(select(i32(_e419), i32(-2147483648), (_e419 < bitcast<f32>(3472883712u))), 2147483647i, (_e419 > bitcast<f32>(1325400063u))), (_e419 == _e419));
                let _e442 = ((1f - _e420) * (1f - _e421));
                let _e444 = (_e420 * (1f - _e421));
                let _e446 = ((1f - _e420) * _e421);
                let _e447 = (_e420 * _e421);
                let _e449 = p.member.test;
                let _e450 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e449);
                let _e452 = p.member.map_size;
                local_1 = lt_math_Evsm(_e450.positive_exponent, _e450.negative_exponent, _e450.min_variance);
                let _e458 = (bitcast<i32>(_e452) - 1i);
                if (_e430 > 0i) {
                    phi_1016_ = _e430;
                } else {
                    phi_1016_ = 0i;
                }
                let _e461 = phi_1016_;
                if (_e439 > 0i) {
                    phi_1021_ = _e439;
                } else {
                    phi_1021_ = 0i;
                }
                let _e464 = phi_1021_;
                if (_e461 < _e458) {
                    phi_1026_ = _e461;
                } else {
                    phi_1026_ = _e458;
                }
                let _e467 = phi_1026_;
                if (_e464 < _e458) {
                    phi_1031_ = _e464;
                } else {
                    phi_1031_ = _e458;
                }
                let _e470 = phi_1031_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (_e430 + 1i);
                let _e474 = (_e439 + 1i);
                if (_e473 > 0i) {
                    phi_1040_ = _e473;
                } else {
                    phi_1040_ = 0i;
                }
                let _e477 = phi_1040_;
                if (_e474 > 0i) {
                    phi_1045_ = _e474;
                } else {
                    phi_1045_ = 0i;
                }
                let _e480 = phi_1045_;
                if (_e477 < _e458) {
                    phi_1050_ = _e477;
                } else {
                    phi_1050_ = _e458;
                }
                let _e483 = phi_1050_;
                if (_e480 < _e458) {
                    phi_1055_ = _e480;
                } else {
                    phi_1055_ = _e458;
                }
                let _e486 = phi_1055_;
                let _e487 = bitcast<u32>(_e483);
                let _e489 = (bitcast<u32>(_e470) * _e452);
                let _e490 = (bitcast<u32>(_e486) * _e452);
                let _e491 = (_e489 + _e471);
                let _e492 = (_e489 + _e487);
                let _e493 = (_e490 + _e471);
                let _e494 = (_e490 + _e487);
                if (_e491 < _e58) {
                } else {
                    return;
                }
                let _e498 = map.member[(0u + _e491)];
                if (_e492 < _e58) {
                } else {
                    return;
                }
                let _e510 = map.member[(0u + _e492)];
                if (_e493 < _e58) {
                } else {
                    return;
                }
                let _e526 = map.member[(0u + _e493)];
                if (_e494 < _e58) {
                } else {
                    return;
                }
                let _e542 = map.member[(0u + _e494)];
                let _e556 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e498.x * _e442) + (_e510.x * _e444)) + (_e526.x * _e446)) + (_e542.x * _e447)), ((((_e498.y * _e442) + (_e510.y * _e444)) + (_e526.y * _e446)) + (_e542.y * _e447)), ((((_e498.z * _e442) + (_e510.z * _e444)) + (_e526.z * _e446)) + (_e542.z * _e447)), ((((_e498.w * _e442) + (_e510.w * _e444)) + (_e526.w * _e446)) + (_e542.w * _e447))), _e360);
                let _e558 = p.member.epsilon;
                if (_e556 <= _e558) {
                    phi_1146_ = true;
                } else {
                    phi_1146_ = (_e556 >= (1f - _e558));
                }
                let _e563 = phi_1146_;
                if ((bitcast<u32>(_e556) & 2147483647u) > 2139095040u) {
                    phi_1154_ = true;
                } else {
                    phi_1154_ = !(_e563);
                }
                let _e569 = phi_1154_;
                if (_e556 > 0.5f) {
                    phi_1159_ = 1f;
                } else {
                    phi_1159_ = 0f;
                }
                let _e572 = phi_1159_;
                phi_1162_ = evaluate_Verdict(_e572, _e569);
            } else {
                phi_1162_ = evaluate_Verdict(1f, true);
            }
            let _e576 = phi_1162_;
            phi_1163_ = _e576;
        }
        let _e578 = phi_1163_;
        visibility.member[_e68.first_primitive] = _e578.visibility;
        phi_1167_ = _e578.is_doubted;
        phi_1168_ = _e68.first_primitive;
    } else {
        phi_1167_ = false;
        phi_1168_ = 0u;
    }
    let _e583 = phi_1167_;
    let _e585 = phi_1168_;
    if _e583 {
        let _e587 = atomicAdd((&shared_[0u]), 1u);
        phi_1174_ = _e587;
    } else {
        phi_1174_ = 0u;
    }
    let _e589 = phi_1174_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e593 = atomicLoad((&shared_[0u]));
        let _e594 = atomicAdd((&list.member[3u]), _e593);
        atomicStore((&shared_[1u]), _e594);
    }
    workgroupBarrier();
    if _e583 {
        let _e597 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e597) + _e589)]), _e585);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
