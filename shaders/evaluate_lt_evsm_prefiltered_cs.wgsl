struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_29 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_29;

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
        let _e60 = phi_151_;
        let _e62 = phi_152_;
        phi_153_ = _e60;
        phi_154_ = _e62;
    } else {
        phi_153_ = lt_bvh_traverse_Tree();
        phi_154_ = true;
    }
    let _e64 = phi_153_;
    let _e66 = phi_154_;
    if _e66 {
        phi_159_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_159_ = _e64;
    }
    let _e71 = phi_159_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_407_: bool;
    var phi_411_: f32;

    let _e49 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_407_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_407_ = _e53;
    }
    let _e55 = phi_407_;
    if _e55 {
        phi_411_ = 42f;
    } else {
        phi_411_ = _e49;
    }
    let _e57 = phi_411_;
    return _e57;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_388_: bool;
    var phi_392_: f32;

    let _e49 = (*param_5).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_388_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_388_ = _e53;
    }
    let _e55 = phi_388_;
    if _e55 {
        phi_392_ = 42f;
    } else {
        phi_392_ = _e49;
    }
    let _e57 = phi_392_;
    return _e57;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_201_: f32;
    var phi_206_: f32;
    var phi_228_: f32;
    var phi_233_: f32;
    var phi_234_: bool;
    var phi_235_: f32;
    var phi_236_: bool;
    var phi_240_: f32;
    var phi_278_: f32;
    var phi_292_: f32;
    var phi_297_: f32;
    var phi_319_: f32;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_326_: f32;
    var phi_327_: bool;
    var phi_331_: f32;
    var phi_369_: f32;

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
            let _e55 = phi_186_;
            phi_187_ = _e55;
        }
        let _e57 = phi_187_;
        phi_188_ = _e57;
    }
    let _e59 = phi_188_;
    let _e60 = _lt_math_evsm_Evsm_positive(param_6);
    let _e61 = (_e60 * _e59);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_278_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_201_ = -87f;
        } else {
            phi_201_ = _e61;
        }
        let _e67 = phi_201_;
        if (_e67 > 88f) {
            phi_206_ = 88f;
        } else {
            phi_206_ = _e67;
        }
        let _e70 = phi_206_;
        let _e72 = ((_e70 * 1.442695f) + 0.5f);
        if (_e72 > -8388608f) {
            let _e84 = f32(select(0i, select(select(i32(_e72), i32(-2147483648), (_e72 < bitcast<f32>(3472883712u))), 2147483647i, (_e72 > bitcast<f32>(1325400063u))), (_e72 == _e72)));
            if (_e84 > _e72) {
                phi_228_ = 1f;
            } else {
                phi_228_ = 0f;
            }
            let _e87 = phi_228_;
            if (_e72 < 8388608f) {
                phi_233_ = (_e84 - _e87);
                phi_234_ = false;
            } else {
                phi_233_ = f32();
                phi_234_ = true;
            }
            let _e90 = phi_233_;
            let _e92 = phi_234_;
            phi_235_ = _e90;
            phi_236_ = _e92;
        } else {
            phi_235_ = f32();
            phi_236_ = true;
        }
        let _e94 = phi_235_;
        let _e96 = phi_236_;
        if _e96 {
            phi_240_ = _e72;
        } else {
            phi_240_ = _e94;
        }
        let _e98 = phi_240_;
        let _e102 = ((_e70 - (_e98 * 0.69314575f)) - (_e98 * 0.0000014286068f));
        phi_278_ = ((((((((((((((((1f / 5040f) * _e102) + (1f / 720f)) * _e102) + (1f / 120f)) * _e102) + (1f / 24f)) * _e102) + (1f / 6f)) * _e102) + 0.5f) * _e102) + 1f) * _e102) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e98), i32(-2147483648), (_e98 < bitcast<f32>(3472883712u))), 2147483647i, (_e98 > bitcast<f32>(1325400063u))), (_e98 == _e98)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e138 = phi_278_;
    let _e139 = _lt_math_evsm_Evsm_negative(param_6);
    let _e141 = (-(_e139) * _e59);
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_369_ = _e141;
    } else {
        if (_e141 < -87f) {
            phi_292_ = -87f;
        } else {
            phi_292_ = _e141;
        }
        let _e147 = phi_292_;
        if (_e147 > 88f) {
            phi_297_ = 88f;
        } else {
            phi_297_ = _e147;
        }
        let _e150 = phi_297_;
        let _e152 = ((_e150 * 1.442695f) + 0.5f);
        if (_e152 > -8388608f) {
            let _e164 = f32(select(0i, select(select(i32(_e152), i32(-2147483648), (_e152 < bitcast<f32>(3472883712u))), 2147483647i, (_e152 > bitcast<f32>(1325400063u))), (_e152 == _e152)));
            if (_e164 > _e152) {
                phi_319_ = 1f;
            } else {
                phi_319_ = 0f;
            }
            let _e167 = phi_319_;
            if (_e152 < 8388608f) {
                phi_324_ = (_e164 - _e167);
                phi_325_ = false;
            } else {
                phi_324_ = f32();
                phi_325_ = true;
            }
            let _e170 = phi_324_;
            let _e172 = phi_325_;
            phi_326_ = _e170;
            phi_327_ = _e172;
        } else {
            phi_326_ = f32();
            phi_327_ = true;
        }
        let _e174 = phi_326_;
        let _e176 = phi_327_;
        if _e176 {
            phi_331_ = _e152;
        } else {
            phi_331_ = _e174;
        }
        let _e178 = phi_331_;
        let _e182 = ((_e150 - (_e178 * 0.69314575f)) - (_e178 * 0.0000014286068f));
        phi_369_ = ((((((((((((((((1f / 5040f) * _e182) + (1f / 720f)) * _e182) + (1f / 120f)) * _e182) + (1f / 24f)) * _e182) + (1f / 6f)) * _e182) + 0.5f) * _e182) + 1f) * _e182) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e178), i32(-2147483648), (_e178 < bitcast<f32>(3472883712u))), 2147483647i, (_e178 > bitcast<f32>(1325400063u))), (_e178 == _e178)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e218 = phi_369_;
    let _e219 = -(_e218);
    return vec4<f32>(_e138, (_e138 * _e138), _e219, (_e219 * _e219));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_441_: bool;
    var phi_445_: f32;
    var phi_457_: bool;
    var phi_464_: f32;
    var phi_489_: bool;
    var phi_493_: f32;
    var phi_505_: bool;
    var phi_512_: f32;
    var phi_523_: bool;
    var phi_527_: f32;
    var phi_542_: f32;
    var phi_543_: f32;
    var phi_544_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e51 = _lt_math_evsm_Evsm_positive(param_8);
    let _e53 = (*param_8).min_variance;
    let _e57 = (((_e53 * _e51) * _e51) * _e50.y);
    let _e64 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
        phi_441_ = true;
    } else {
        let _e68 = (_e57 > _e64);
        if _e68 {
        }
        phi_441_ = _e68;
    }
    let _e70 = phi_441_;
    if _e70 {
        phi_445_ = _e57;
    } else {
        phi_445_ = _e64;
    }
    let _e72 = phi_445_;
    let _e73 = (_e50.x - param_9.x);
    if (_e73 <= 0f) {
        let _e77 = ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u);
        if _e77 {
        }
        phi_457_ = _e77;
    } else {
        phi_457_ = true;
    }
    let _e79 = phi_457_;
    if _e79 {
        phi_464_ = (_e72 / (_e72 + (_e73 * _e73)));
    } else {
        phi_464_ = 1f;
    }
    let _e84 = phi_464_;
    let _e85 = _lt_math_evsm_Evsm_negative(param_8);
    let _e87 = (*param_8).min_variance;
    let _e91 = (((_e87 * _e85) * _e85) * _e50.w);
    let _e98 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
        phi_489_ = true;
    } else {
        let _e102 = (_e91 > _e98);
        if _e102 {
        }
        phi_489_ = _e102;
    }
    let _e104 = phi_489_;
    if _e104 {
        phi_493_ = _e91;
    } else {
        phi_493_ = _e98;
    }
    let _e106 = phi_493_;
    let _e107 = (_e50.z - param_9.z);
    if (_e107 <= 0f) {
        let _e111 = ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u);
        if _e111 {
        }
        phi_505_ = _e111;
    } else {
        phi_505_ = true;
    }
    let _e113 = phi_505_;
    if _e113 {
        phi_512_ = (_e106 / (_e106 + (_e107 * _e107)));
    } else {
        phi_512_ = 1f;
    }
    let _e118 = phi_512_;
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_523_ = true;
    } else {
        let _e122 = (_e118 < _e84);
        if _e122 {
        }
        phi_523_ = _e122;
    }
    let _e124 = phi_523_;
    if _e124 {
        phi_527_ = _e118;
    } else {
        phi_527_ = _e84;
    }
    let _e126 = phi_527_;
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_544_ = _e126;
    } else {
        if (_e126 < 0f) {
            phi_543_ = 0f;
        } else {
            if (_e126 > 1f) {
                phi_542_ = 1f;
            } else {
                phi_542_ = _e126;
            }
            let _e133 = phi_542_;
            phi_543_ = _e133;
        }
        let _e135 = phi_543_;
        phi_544_ = _e135;
    }
    let _e137 = phi_544_;
    return _e137;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_598_: bool;
    var phi_599_: bool;
    var phi_600_: bool;
    var phi_601_: bool;
    var phi_605_: bool;
    var phi_649_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_653_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_730_: bool;
    var phi_739_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_758_: bool;
    var phi_852_: f32;
    var phi_855_: f32;
    var phi_884_: f32;
    var phi_889_: f32;
    var phi_890_: bool;
    var phi_891_: f32;
    var phi_892_: bool;
    var phi_896_: f32;
    var phi_916_: f32;
    var phi_921_: f32;
    var phi_922_: bool;
    var phi_923_: f32;
    var phi_924_: bool;
    var phi_928_: f32;
    var phi_978_: i32;
    var phi_983_: i32;
    var phi_988_: i32;
    var phi_993_: i32;
    var phi_1002_: i32;
    var phi_1007_: i32;
    var phi_1012_: i32;
    var phi_1017_: i32;
    var phi_1108_: bool;
    var phi_1116_: bool;
    var phi_1128_: bool;
    var phi_1129_: bool;
    var phi_1133_: f32;
    var phi_1139_: f32;
    var phi_1141_: evaluate_Verdict;
    var phi_1146_: evaluate_Verdict;
    var phi_1147_: evaluate_Verdict;

    let _e48 = id_1;
    let _e55 = arrayLength((&map.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = p.member.light;
        let _e76 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_598_ = (_e86 == _e88);
                phi_599_ = false;
            } else {
                phi_598_ = bool();
                phi_599_ = true;
            }
            let _e91 = phi_598_;
            let _e93 = phi_599_;
            phi_600_ = _e91;
            phi_601_ = _e93;
        } else {
            phi_600_ = bool();
            phi_601_ = true;
        }
        let _e95 = phi_600_;
        let _e97 = phi_601_;
        if _e97 {
            phi_605_ = false;
        } else {
            phi_605_ = _e95;
        }
        let _e99 = phi_605_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_649_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_649_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_649_;
            phi_653_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_653_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_653_;
        if _e179.unnamed_1 {
            phi_1147_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[(0u + _e64.first_primitive)].position;
            let _e193 = p.member.projection.row_w;
            let _e204 = ((((_e193.x * _e187.x) + (_e193.y * _e187.y)) + (_e193.z * _e187.z)) + (_e193.w * 1f));
            let _e206 = p.member.projection.row_x;
            let _e218 = (((((_e206.x * _e187.x) + (_e206.y * _e187.y)) + (_e206.z * _e187.z)) + (_e206.w * 1f)) / _e204);
            let _e220 = p.member.projection.row_y;
            let _e232 = (((((_e220.x * _e187.x) + (_e220.y * _e187.y)) + (_e220.z * _e187.z)) + (_e220.w * 1f)) / _e204);
            let _e234 = p.member.projection.row_z;
            let _e245 = ((((_e234.x * _e187.x) + (_e234.y * _e187.y)) + (_e234.z * _e187.z)) + (_e234.w * 1f));
            if (_e204 > 0f) {
                if (_e218 >= 0f) {
                    phi_730_ = (_e218 <= 1f);
                } else {
                    phi_730_ = false;
                }
                let _e250 = phi_730_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_739_ = (_e232 <= 1f);
                    } else {
                        phi_739_ = false;
                    }
                    let _e254 = phi_739_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_748_ = (_e245 <= 1f);
                        } else {
                            phi_748_ = false;
                        }
                        let _e258 = phi_748_;
                        phi_749_ = _e258;
                        phi_750_ = false;
                    } else {
                        phi_749_ = bool();
                        phi_750_ = true;
                    }
                    let _e260 = phi_749_;
                    let _e262 = phi_750_;
                    phi_751_ = _e260;
                    phi_752_ = _e262;
                } else {
                    phi_751_ = bool();
                    phi_752_ = true;
                }
                let _e264 = phi_751_;
                let _e266 = phi_752_;
                phi_753_ = _e264;
                phi_754_ = _e266;
            } else {
                phi_753_ = bool();
                phi_754_ = true;
            }
            let _e268 = phi_753_;
            let _e270 = phi_754_;
            if _e270 {
                phi_758_ = false;
            } else {
                phi_758_ = _e268;
            }
            let _e272 = phi_758_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_852_ = _e351;
                    } else {
                        phi_852_ = 0.002f;
                    }
                    let _e354 = phi_852_;
                    phi_855_ = (_e245 - (0f * _e354));
                } else {
                    phi_855_ = _e245;
                }
                let _e358 = phi_855_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_884_ = 1f;
                    } else {
                        phi_884_ = 0f;
                    }
                    let _e380 = phi_884_;
                    if (_e364 < 8388608f) {
                        phi_889_ = (_e377 - _e380);
                        phi_890_ = false;
                    } else {
                        phi_889_ = f32();
                        phi_890_ = true;
                    }
                    let _e383 = phi_889_;
                    let _e385 = phi_890_;
                    phi_891_ = _e383;
                    phi_892_ = _e385;
                } else {
                    phi_891_ = f32();
                    phi_892_ = true;
                }
                let _e387 = phi_891_;
                let _e389 = phi_892_;
                if _e389 {
                    phi_896_ = _e364;
                } else {
                    phi_896_ = _e387;
                }
                let _e391 = phi_896_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_916_ = 1f;
                    } else {
                        phi_916_ = 0f;
                    }
                    let _e406 = phi_916_;
                    if (_e365 < 8388608f) {
                        phi_921_ = (_e403 - _e406);
                        phi_922_ = false;
                    } else {
                        phi_921_ = f32();
                        phi_922_ = true;
                    }
                    let _e409 = phi_921_;
                    let _e411 = phi_922_;
                    phi_923_ = _e409;
                    phi_924_ = _e411;
                } else {
                    phi_923_ = f32();
                    phi_924_ = true;
                }
                let _e413 = phi_923_;
                let _e415 = phi_924_;
                if _e415 {
                    phi_928_ = _e365;
                } else {
                    phi_928_ = _e413;
                }
                let _e417 = phi_928_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e440 = ((1f - _e418) * (1f - _e419));
                let _e442 = (_e418 * (1f - _e419));
                let _e444 = ((1f - _e418) * _e419);
                let _e445 = (_e418 * _e419);
                let _e447 = p.member.test;
                let _e448 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e447);
                let _e450 = p.member.map_size;
                local = lt_math_Evsm(_e448.positive_exponent, _e448.negative_exponent, _e448.min_variance);
                let _e456 = (bitcast<i32>(_e450) - 1i);
                if (_e428 > 0i) {
                    phi_978_ = _e428;
                } else {
                    phi_978_ = 0i;
                }
                let _e459 = phi_978_;
                if (_e437 > 0i) {
                    phi_983_ = _e437;
                } else {
                    phi_983_ = 0i;
                }
                let _e462 = phi_983_;
                if (_e459 < _e456) {
                    phi_988_ = _e459;
                } else {
                    phi_988_ = _e456;
                }
                let _e465 = phi_988_;
                if (_e462 < _e456) {
                    phi_993_ = _e462;
                } else {
                    phi_993_ = _e456;
                }
                let _e468 = phi_993_;
                let _e469 = bitcast<u32>(_e465);
                let _e471 = (_e428 + 1i);
                let _e472 = (_e437 + 1i);
                if (_e471 > 0i) {
                    phi_1002_ = _e471;
                } else {
                    phi_1002_ = 0i;
                }
                let _e475 = phi_1002_;
                if (_e472 > 0i) {
                    phi_1007_ = _e472;
                } else {
                    phi_1007_ = 0i;
                }
                let _e478 = phi_1007_;
                if (_e475 < _e456) {
                    phi_1012_ = _e475;
                } else {
                    phi_1012_ = _e456;
                }
                let _e481 = phi_1012_;
                if (_e478 < _e456) {
                    phi_1017_ = _e478;
                } else {
                    phi_1017_ = _e456;
                }
                let _e484 = phi_1017_;
                let _e485 = bitcast<u32>(_e481);
                let _e487 = (bitcast<u32>(_e468) * _e450);
                let _e488 = (bitcast<u32>(_e484) * _e450);
                let _e489 = (_e487 + _e469);
                let _e490 = (_e487 + _e485);
                let _e491 = (_e488 + _e469);
                let _e492 = (_e488 + _e485);
                if (_e489 < _e55) {
                } else {
                    return;
                }
                let _e496 = map.member[(0u + _e489)];
                if (_e490 < _e55) {
                } else {
                    return;
                }
                let _e508 = map.member[(0u + _e490)];
                if (_e491 < _e55) {
                } else {
                    return;
                }
                let _e524 = map.member[(0u + _e491)];
                if (_e492 < _e55) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e492)];
                let _e554 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e496.x * _e440) + (_e508.x * _e442)) + (_e524.x * _e444)) + (_e540.x * _e445)), ((((_e496.y * _e440) + (_e508.y * _e442)) + (_e524.y * _e444)) + (_e540.y * _e445)), ((((_e496.z * _e440) + (_e508.z * _e442)) + (_e524.z * _e444)) + (_e540.z * _e445)), ((((_e496.w * _e440) + (_e508.w * _e442)) + (_e524.w * _e444)) + (_e540.w * _e445))), _e358);
                let _e556 = p.member.epsilon;
                if (_e554 <= _e556) {
                    phi_1108_ = true;
                } else {
                    phi_1108_ = (_e554 >= (1f - _e556));
                }
                let _e561 = phi_1108_;
                if ((bitcast<u32>(_e554) & 2147483647u) > 2139095040u) {
                    phi_1116_ = true;
                } else {
                    phi_1116_ = !(_e561);
                }
                let _e567 = phi_1116_;
                if _e567 {
                    if (_e554 > 0f) {
                        if (_e554 < 1f) {
                            phi_1128_ = false;
                        } else {
                            phi_1128_ = true;
                        }
                        let _e571 = phi_1128_;
                        phi_1129_ = _e571;
                    } else {
                        phi_1129_ = true;
                    }
                    let _e573 = phi_1129_;
                    if _e573 {
                        phi_1133_ = 0.5f;
                    } else {
                        phi_1133_ = _e554;
                    }
                    let _e575 = phi_1133_;
                    phi_1141_ = evaluate_Verdict(_e575, true);
                } else {
                    if (_e554 > 0.5f) {
                        phi_1139_ = 1f;
                    } else {
                        phi_1139_ = 0f;
                    }
                    let _e579 = phi_1139_;
                    phi_1141_ = evaluate_Verdict(_e579, false);
                }
                let _e582 = phi_1141_;
                phi_1146_ = evaluate_Verdict(_e582.visibility, _e582.is_doubted);
            } else {
                phi_1146_ = evaluate_Verdict(0.5f, true);
            }
            let _e588 = phi_1146_;
            phi_1147_ = _e588;
        }
        let _e590 = phi_1147_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e590.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
