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

struct type_18 {
    member: array<abi_Sample>,
}

struct type_22 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_30 {
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

struct type_35 {
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
var<storage> samples: type_18;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_22;
@group(0) @binding(2) 
var<storage> map: type_30;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e59 = phi_147_;
        let _e61 = phi_148_;
        phi_149_ = _e59;
        phi_150_ = _e61;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e63 = phi_149_;
    let _e65 = phi_150_;
    if _e65 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e63;
    }
    let _e70 = phi_155_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_403_: bool;
    var phi_407_: f32;

    let _e48 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_403_ = true;
    } else {
        let _e52 = (42f < _e48);
        if _e52 {
        }
        phi_403_ = _e52;
    }
    let _e54 = phi_403_;
    if _e54 {
        phi_407_ = 42f;
    } else {
        phi_407_ = _e48;
    }
    let _e56 = phi_407_;
    return _e56;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_384_: bool;
    var phi_388_: f32;

    let _e48 = (*param_5).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_384_ = true;
    } else {
        let _e52 = (42f < _e48);
        if _e52 {
        }
        phi_384_ = _e52;
    }
    let _e54 = phi_384_;
    if _e54 {
        phi_388_ = 42f;
    } else {
        phi_388_ = _e48;
    }
    let _e56 = phi_388_;
    return _e56;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_184_: f32;
    var phi_197_: f32;
    var phi_202_: f32;
    var phi_224_: f32;
    var phi_229_: f32;
    var phi_230_: bool;
    var phi_231_: f32;
    var phi_232_: bool;
    var phi_236_: f32;
    var phi_274_: f32;
    var phi_288_: f32;
    var phi_293_: f32;
    var phi_315_: f32;
    var phi_320_: f32;
    var phi_321_: bool;
    var phi_322_: f32;
    var phi_323_: bool;
    var phi_327_: f32;
    var phi_365_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_184_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_183_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_182_ = 1f;
            } else {
                phi_182_ = param_7;
            }
            let _e54 = phi_182_;
            phi_183_ = _e54;
        }
        let _e56 = phi_183_;
        phi_184_ = _e56;
    }
    let _e58 = phi_184_;
    let _e59 = _lt_math_evsm_Evsm_positive(param_6);
    let _e60 = (_e59 * _e58);
    if ((bitcast<u32>(_e60) & 2147483647u) > 2139095040u) {
        phi_274_ = _e60;
    } else {
        if (_e60 < -87f) {
            phi_197_ = -87f;
        } else {
            phi_197_ = _e60;
        }
        let _e66 = phi_197_;
        if (_e66 > 88f) {
            phi_202_ = 88f;
        } else {
            phi_202_ = _e66;
        }
        let _e69 = phi_202_;
        let _e71 = ((_e69 * 1.442695f) + 0.5f);
        if (_e71 > -8388608f) {
            let _e83 = f32(select(0i, select(select(i32(_e71), i32(-2147483648), (_e71 < bitcast<f32>(3472883712u))), 2147483647i, (_e71 > bitcast<f32>(1325400063u))), (_e71 == _e71)));
            if (_e83 > _e71) {
                phi_224_ = 1f;
            } else {
                phi_224_ = 0f;
            }
            let _e86 = phi_224_;
            if (_e71 < 8388608f) {
                phi_229_ = (_e83 - _e86);
                phi_230_ = false;
            } else {
                phi_229_ = f32();
                phi_230_ = true;
            }
            let _e89 = phi_229_;
            let _e91 = phi_230_;
            phi_231_ = _e89;
            phi_232_ = _e91;
        } else {
            phi_231_ = f32();
            phi_232_ = true;
        }
        let _e93 = phi_231_;
        let _e95 = phi_232_;
        if _e95 {
            phi_236_ = _e71;
        } else {
            phi_236_ = _e93;
        }
        let _e97 = phi_236_;
        let _e101 = ((_e69 - (_e97 * 0.69314575f)) - (_e97 * 0.0000014286068f));
        phi_274_ = ((((((((((((((((1f / 5040f) * _e101) + (1f / 720f)) * _e101) + (1f / 120f)) * _e101) + (1f / 24f)) * _e101) + (1f / 6f)) * _e101) + 0.5f) * _e101) + 1f) * _e101) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e97), i32(-2147483648), (_e97 < bitcast<f32>(3472883712u))), 2147483647i, (_e97 > bitcast<f32>(1325400063u))), (_e97 == _e97)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e137 = phi_274_;
    let _e138 = _lt_math_evsm_Evsm_negative(param_6);
    let _e140 = (-(_e138) * _e58);
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_365_ = _e140;
    } else {
        if (_e140 < -87f) {
            phi_288_ = -87f;
        } else {
            phi_288_ = _e140;
        }
        let _e146 = phi_288_;
        if (_e146 > 88f) {
            phi_293_ = 88f;
        } else {
            phi_293_ = _e146;
        }
        let _e149 = phi_293_;
        let _e151 = ((_e149 * 1.442695f) + 0.5f);
        if (_e151 > -8388608f) {
            let _e163 = f32(select(0i, select(select(i32(_e151), i32(-2147483648), (_e151 < bitcast<f32>(3472883712u))), 2147483647i, (_e151 > bitcast<f32>(1325400063u))), (_e151 == _e151)));
            if (_e163 > _e151) {
                phi_315_ = 1f;
            } else {
                phi_315_ = 0f;
            }
            let _e166 = phi_315_;
            if (_e151 < 8388608f) {
                phi_320_ = (_e163 - _e166);
                phi_321_ = false;
            } else {
                phi_320_ = f32();
                phi_321_ = true;
            }
            let _e169 = phi_320_;
            let _e171 = phi_321_;
            phi_322_ = _e169;
            phi_323_ = _e171;
        } else {
            phi_322_ = f32();
            phi_323_ = true;
        }
        let _e173 = phi_322_;
        let _e175 = phi_323_;
        if _e175 {
            phi_327_ = _e151;
        } else {
            phi_327_ = _e173;
        }
        let _e177 = phi_327_;
        let _e181 = ((_e149 - (_e177 * 0.69314575f)) - (_e177 * 0.0000014286068f));
        phi_365_ = ((((((((((((((((1f / 5040f) * _e181) + (1f / 720f)) * _e181) + (1f / 120f)) * _e181) + (1f / 24f)) * _e181) + (1f / 6f)) * _e181) + 0.5f) * _e181) + 1f) * _e181) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e177), i32(-2147483648), (_e177 < bitcast<f32>(3472883712u))), 2147483647i, (_e177 > bitcast<f32>(1325400063u))), (_e177 == _e177)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e217 = phi_365_;
    let _e218 = -(_e217);
    return vec4<f32>(_e137, (_e137 * _e137), _e218, (_e218 * _e218));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_921_: bool;
    var phi_925_: f32;
    var phi_937_: bool;
    var phi_944_: f32;
    var phi_969_: bool;
    var phi_973_: f32;
    var phi_985_: bool;
    var phi_992_: f32;
    var phi_1003_: bool;
    var phi_1007_: f32;
    var phi_1022_: f32;
    var phi_1023_: f32;
    var phi_1024_: f32;

    let _e49 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e50 = _lt_math_evsm_Evsm_positive(param_8);
    let _e52 = (*param_8).min_variance;
    let _e56 = (((_e52 * _e50) * _e50) * _e49.y);
    let _e63 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_921_ = true;
    } else {
        let _e67 = (_e56 > _e63);
        if _e67 {
        }
        phi_921_ = _e67;
    }
    let _e69 = phi_921_;
    if _e69 {
        phi_925_ = _e56;
    } else {
        phi_925_ = _e63;
    }
    let _e71 = phi_925_;
    let _e72 = (_e49.x - param_9.x);
    if (_e72 <= 0f) {
        let _e76 = ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u);
        if _e76 {
        }
        phi_937_ = _e76;
    } else {
        phi_937_ = true;
    }
    let _e78 = phi_937_;
    if _e78 {
        phi_944_ = (_e71 / (_e71 + (_e72 * _e72)));
    } else {
        phi_944_ = 1f;
    }
    let _e83 = phi_944_;
    let _e84 = _lt_math_evsm_Evsm_negative(param_8);
    let _e86 = (*param_8).min_variance;
    let _e90 = (((_e86 * _e84) * _e84) * _e49.w);
    let _e97 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e90) & 2147483647u) > 2139095040u) {
        phi_969_ = true;
    } else {
        let _e101 = (_e90 > _e97);
        if _e101 {
        }
        phi_969_ = _e101;
    }
    let _e103 = phi_969_;
    if _e103 {
        phi_973_ = _e90;
    } else {
        phi_973_ = _e97;
    }
    let _e105 = phi_973_;
    let _e106 = (_e49.z - param_9.z);
    if (_e106 <= 0f) {
        let _e110 = ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u);
        if _e110 {
        }
        phi_985_ = _e110;
    } else {
        phi_985_ = true;
    }
    let _e112 = phi_985_;
    if _e112 {
        phi_992_ = (_e105 / (_e105 + (_e106 * _e106)));
    } else {
        phi_992_ = 1f;
    }
    let _e117 = phi_992_;
    if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
        phi_1003_ = true;
    } else {
        let _e121 = (_e117 < _e83);
        if _e121 {
        }
        phi_1003_ = _e121;
    }
    let _e123 = phi_1003_;
    if _e123 {
        phi_1007_ = _e117;
    } else {
        phi_1007_ = _e83;
    }
    let _e125 = phi_1007_;
    if ((bitcast<u32>(_e125) & 2147483647u) > 2139095040u) {
        phi_1024_ = _e125;
    } else {
        if (_e125 < 0f) {
            phi_1023_ = 0f;
        } else {
            if (_e125 > 1f) {
                phi_1022_ = 1f;
            } else {
                phi_1022_ = _e125;
            }
            let _e132 = phi_1022_;
            phi_1023_ = _e132;
        }
        let _e134 = phi_1023_;
        phi_1024_ = _e134;
    }
    let _e136 = phi_1024_;
    return _e136;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_468_: bool;
    var phi_512_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_516_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_593_: bool;
    var phi_602_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_621_: bool;
    var phi_657_: f32;
    var phi_662_: f32;
    var phi_663_: bool;
    var phi_664_: f32;
    var phi_665_: bool;
    var phi_669_: f32;
    var phi_689_: f32;
    var phi_694_: f32;
    var phi_695_: bool;
    var phi_696_: f32;
    var phi_697_: bool;
    var phi_701_: f32;
    var phi_751_: i32;
    var phi_756_: i32;
    var phi_761_: i32;
    var phi_766_: i32;
    var phi_775_: i32;
    var phi_780_: i32;
    var phi_785_: i32;
    var phi_790_: i32;
    var phi_875_: evaluate_Verdict;
    var phi_876_: evaluate_Verdict;
    var phi_877_: bool;
    var phi_878_: evaluate_Verdict;
    var phi_879_: evaluate_Verdict;
    var phi_880_: bool;
    var phi_884_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e72 = p.member.light;
        let _e75 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_461_ = (_e85 == _e87);
                phi_462_ = false;
            } else {
                phi_461_ = bool();
                phi_462_ = true;
            }
            let _e90 = phi_461_;
            let _e92 = phi_462_;
            phi_463_ = _e90;
            phi_464_ = _e92;
        } else {
            phi_463_ = bool();
            phi_464_ = true;
        }
        let _e94 = phi_463_;
        let _e96 = phi_464_;
        if _e96 {
            phi_468_ = false;
        } else {
            phi_468_ = _e94;
        }
        let _e98 = phi_468_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_512_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_512_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_512_;
            phi_516_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_516_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_516_;
        if _e178.unnamed_1 {
            phi_878_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
            phi_879_ = evaluate_Verdict();
            phi_880_ = true;
        } else {
            let _e186 = samples.member[(0u + _e63.first_primitive)].position;
            let _e192 = p.member.projection.row_w;
            let _e203 = ((((_e192.x * _e186.x) + (_e192.y * _e186.y)) + (_e192.z * _e186.z)) + (_e192.w * 1f));
            let _e205 = p.member.projection.row_x;
            let _e217 = (((((_e205.x * _e186.x) + (_e205.y * _e186.y)) + (_e205.z * _e186.z)) + (_e205.w * 1f)) / _e203);
            let _e219 = p.member.projection.row_y;
            let _e231 = (((((_e219.x * _e186.x) + (_e219.y * _e186.y)) + (_e219.z * _e186.z)) + (_e219.w * 1f)) / _e203);
            let _e233 = p.member.projection.row_z;
            let _e244 = ((((_e233.x * _e186.x) + (_e233.y * _e186.y)) + (_e233.z * _e186.z)) + (_e233.w * 1f));
            if (_e203 > 0f) {
                if (_e217 >= 0f) {
                    phi_593_ = (_e217 <= 1f);
                } else {
                    phi_593_ = false;
                }
                let _e249 = phi_593_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_602_ = (_e231 <= 1f);
                    } else {
                        phi_602_ = false;
                    }
                    let _e253 = phi_602_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_611_ = (_e244 <= 1f);
                        } else {
                            phi_611_ = false;
                        }
                        let _e257 = phi_611_;
                        phi_612_ = _e257;
                        phi_613_ = false;
                    } else {
                        phi_612_ = bool();
                        phi_613_ = true;
                    }
                    let _e259 = phi_612_;
                    let _e261 = phi_613_;
                    phi_614_ = _e259;
                    phi_615_ = _e261;
                } else {
                    phi_614_ = bool();
                    phi_615_ = true;
                }
                let _e263 = phi_614_;
                let _e265 = phi_615_;
                phi_616_ = _e263;
                phi_617_ = _e265;
            } else {
                phi_616_ = bool();
                phi_617_ = true;
            }
            let _e267 = phi_616_;
            let _e269 = phi_617_;
            if _e269 {
                phi_621_ = false;
            } else {
                phi_621_ = _e267;
            }
            let _e271 = phi_621_;
            if _e271 {
                let _e273 = p.member.map_size;
                let _e274 = f32(_e273);
                let _e277 = ((_e217 * _e274) - 0.5f);
                let _e278 = ((_e231 * _e274) - 0.5f);
                if (_e277 > -8388608f) {
                    let _e290 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e290 > _e277) {
                        phi_657_ = 1f;
                    } else {
                        phi_657_ = 0f;
                    }
                    let _e293 = phi_657_;
                    if (_e277 < 8388608f) {
                        phi_662_ = (_e290 - _e293);
                        phi_663_ = false;
                    } else {
                        phi_662_ = f32();
                        phi_663_ = true;
                    }
                    let _e296 = phi_662_;
                    let _e298 = phi_663_;
                    phi_664_ = _e296;
                    phi_665_ = _e298;
                } else {
                    phi_664_ = f32();
                    phi_665_ = true;
                }
                let _e300 = phi_664_;
                let _e302 = phi_665_;
                if _e302 {
                    phi_669_ = _e277;
                } else {
                    phi_669_ = _e300;
                }
                let _e304 = phi_669_;
                if (_e278 > -8388608f) {
                    let _e316 = f32(select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < bitcast<f32>(3472883712u))), 2147483647i, (_e278 > bitcast<f32>(1325400063u))), (_e278 == _e278)));
                    if (_e316 > _e278) {
                        phi_689_ = 1f;
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e319 = phi_689_;
                    if (_e278 < 8388608f) {
                        phi_694_ = (_e316 - _e319);
                        phi_695_ = false;
                    } else {
                        phi_694_ = f32();
                        phi_695_ = true;
                    }
                    let _e322 = phi_694_;
                    let _e324 = phi_695_;
                    phi_696_ = _e322;
                    phi_697_ = _e324;
                } else {
                    phi_696_ = f32();
                    phi_697_ = true;
                }
                let _e326 = phi_696_;
                let _e328 = phi_697_;
                if _e328 {
                    phi_701_ = _e278;
                } else {
                    phi_701_ = _e326;
                }
                let _e330 = phi_701_;
                let _e331 = (_e277 - _e304);
                let _e332 = (_e278 - _e330);
                let _e341 = select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < bitcast<f32>(3472883712u))), 2147483647i, (_e304 > bitcast<f32>(1325400063u))), (_e304 == _e304));
                let _e350 = select(0i, select(select(i32(_e330), i32(-2147483648), (_e330 < bitcast<f32>(3472883712u))), 2147483647i, (_e330 > bitcast<f32>(1325400063u))), (_e330 == _e330));
                let _e353 = ((1f - _e331) * (1f - _e332));
                let _e355 = (_e331 * (1f - _e332));
                let _e357 = ((1f - _e331) * _e332);
                let _e358 = (_e331 * _e332);
                let _e360 = p.member.test;
                let _e361 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e360);
                let _e363 = p.member.map_size;
                local = lt_math_Evsm(_e361.positive_exponent, _e361.negative_exponent, _e361.min_variance);
                let _e369 = (bitcast<i32>(_e363) - 1i);
                if (_e341 > 0i) {
                    phi_751_ = _e341;
                } else {
                    phi_751_ = 0i;
                }
                let _e372 = phi_751_;
                if (_e350 > 0i) {
                    phi_756_ = _e350;
                } else {
                    phi_756_ = 0i;
                }
                let _e375 = phi_756_;
                if (_e372 < _e369) {
                    phi_761_ = _e372;
                } else {
                    phi_761_ = _e369;
                }
                let _e378 = phi_761_;
                if (_e375 < _e369) {
                    phi_766_ = _e375;
                } else {
                    phi_766_ = _e369;
                }
                let _e381 = phi_766_;
                let _e382 = bitcast<u32>(_e378);
                let _e384 = (_e341 + 1i);
                let _e385 = (_e350 + 1i);
                if (_e384 > 0i) {
                    phi_775_ = _e384;
                } else {
                    phi_775_ = 0i;
                }
                let _e388 = phi_775_;
                if (_e385 > 0i) {
                    phi_780_ = _e385;
                } else {
                    phi_780_ = 0i;
                }
                let _e391 = phi_780_;
                if (_e388 < _e369) {
                    phi_785_ = _e388;
                } else {
                    phi_785_ = _e369;
                }
                let _e394 = phi_785_;
                if (_e391 < _e369) {
                    phi_790_ = _e391;
                } else {
                    phi_790_ = _e369;
                }
                let _e397 = phi_790_;
                let _e398 = bitcast<u32>(_e394);
                let _e400 = (bitcast<u32>(_e381) * _e363);
                let _e401 = (bitcast<u32>(_e397) * _e363);
                let _e402 = (_e400 + _e382);
                let _e403 = (_e400 + _e398);
                let _e404 = (_e401 + _e382);
                let _e405 = (_e401 + _e398);
                if (_e402 < _e54) {
                } else {
                    return;
                }
                let _e409 = map.member[(0u + _e402)];
                if (_e403 < _e54) {
                } else {
                    return;
                }
                let _e421 = map.member[(0u + _e403)];
                if (_e404 < _e54) {
                } else {
                    return;
                }
                let _e437 = map.member[(0u + _e404)];
                if (_e405 < _e54) {
                } else {
                    return;
                }
                let _e453 = map.member[(0u + _e405)];
                let _e467 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e409.x * _e353) + (_e421.x * _e355)) + (_e437.x * _e357)) + (_e453.x * _e358)), ((((_e409.y * _e353) + (_e421.y * _e355)) + (_e437.y * _e357)) + (_e453.y * _e358)), ((((_e409.z * _e353) + (_e421.z * _e355)) + (_e437.z * _e357)) + (_e453.z * _e358)), ((((_e409.w * _e353) + (_e421.w * _e355)) + (_e437.w * _e357)) + (_e453.w * _e358))), _e244);
                phi_875_ = evaluate_Verdict(_e467, false);
                phi_876_ = evaluate_Verdict();
                phi_877_ = false;
            } else {
                phi_875_ = evaluate_Verdict();
                phi_876_ = evaluate_Verdict(1f, false);
                phi_877_ = true;
            }
            let _e471 = phi_875_;
            let _e473 = phi_876_;
            let _e475 = phi_877_;
            phi_878_ = _e473;
            phi_879_ = _e471;
            phi_880_ = _e475;
        }
        let _e477 = phi_878_;
        let _e479 = phi_879_;
        let _e481 = phi_880_;
        if _e481 {
            phi_884_ = _e477;
        } else {
            phi_884_ = _e479;
        }
        let _e483 = phi_884_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e483.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
