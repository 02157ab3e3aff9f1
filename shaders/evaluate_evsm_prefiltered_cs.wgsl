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

struct type_28 {
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

struct type_35 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(2) 
var<storage> map: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e60 = phi_149_;
        let _e62 = phi_150_;
        phi_151_ = _e60;
        phi_152_ = _e62;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e64 = phi_151_;
    let _e66 = phi_152_;
    if _e66 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e64;
    }
    let _e71 = phi_157_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_405_: bool;
    var phi_409_: f32;

    let _e49 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_405_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_405_ = _e53;
    }
    let _e55 = phi_405_;
    if _e55 {
        phi_409_ = 42f;
    } else {
        phi_409_ = _e49;
    }
    let _e57 = phi_409_;
    return _e57;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_386_: bool;
    var phi_390_: f32;

    let _e49 = (*param_5).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_386_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_386_ = _e53;
    }
    let _e55 = phi_386_;
    if _e55 {
        phi_390_ = 42f;
    } else {
        phi_390_ = _e49;
    }
    let _e57 = phi_390_;
    return _e57;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_199_: f32;
    var phi_204_: f32;
    var phi_226_: f32;
    var phi_231_: f32;
    var phi_232_: bool;
    var phi_233_: f32;
    var phi_234_: bool;
    var phi_238_: f32;
    var phi_276_: f32;
    var phi_290_: f32;
    var phi_295_: f32;
    var phi_317_: f32;
    var phi_322_: f32;
    var phi_323_: bool;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_329_: f32;
    var phi_367_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_186_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_185_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_184_ = 1f;
            } else {
                phi_184_ = param_7;
            }
            let _e55 = phi_184_;
            phi_185_ = _e55;
        }
        let _e57 = phi_185_;
        phi_186_ = _e57;
    }
    let _e59 = phi_186_;
    let _e60 = _lt_math_evsm_Evsm_positive(param_6);
    let _e61 = (_e60 * _e59);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_276_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_199_ = -87f;
        } else {
            phi_199_ = _e61;
        }
        let _e67 = phi_199_;
        if (_e67 > 88f) {
            phi_204_ = 88f;
        } else {
            phi_204_ = _e67;
        }
        let _e70 = phi_204_;
        let _e72 = ((_e70 * 1.442695f) + 0.5f);
        if (_e72 > -8388608f) {
            let _e84 = f32(select(0i, select(select(i32(_e72), i32(-2147483648), (_e72 < bitcast<f32>(3472883712u))), 2147483647i, (_e72 > bitcast<f32>(1325400063u))), (_e72 == _e72)));
            if (_e84 > _e72) {
                phi_226_ = 1f;
            } else {
                phi_226_ = 0f;
            }
            let _e87 = phi_226_;
            if (_e72 < 8388608f) {
                phi_231_ = (_e84 - _e87);
                phi_232_ = false;
            } else {
                phi_231_ = f32();
                phi_232_ = true;
            }
            let _e90 = phi_231_;
            let _e92 = phi_232_;
            phi_233_ = _e90;
            phi_234_ = _e92;
        } else {
            phi_233_ = f32();
            phi_234_ = true;
        }
        let _e94 = phi_233_;
        let _e96 = phi_234_;
        if _e96 {
            phi_238_ = _e72;
        } else {
            phi_238_ = _e94;
        }
        let _e98 = phi_238_;
        let _e102 = ((_e70 - (_e98 * 0.69314575f)) - (_e98 * 0.0000014286068f));
        phi_276_ = ((((((((((((((((1f / 5040f) * _e102) + (1f / 720f)) * _e102) + (1f / 120f)) * _e102) + (1f / 24f)) * _e102) + (1f / 6f)) * _e102) + 0.5f) * _e102) + 1f) * _e102) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e98), i32(-2147483648), (_e98 < bitcast<f32>(3472883712u))), 2147483647i, (_e98 > bitcast<f32>(1325400063u))), (_e98 == _e98)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e138 = phi_276_;
    let _e139 = _lt_math_evsm_Evsm_negative(param_6);
    let _e141 = (-(_e139) * _e59);
    if ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u) {
        phi_367_ = _e141;
    } else {
        if (_e141 < -87f) {
            phi_290_ = -87f;
        } else {
            phi_290_ = _e141;
        }
        let _e147 = phi_290_;
        if (_e147 > 88f) {
            phi_295_ = 88f;
        } else {
            phi_295_ = _e147;
        }
        let _e150 = phi_295_;
        let _e152 = ((_e150 * 1.442695f) + 0.5f);
        if (_e152 > -8388608f) {
            let _e164 = f32(select(0i, select(select(i32(_e152), i32(-2147483648), (_e152 < bitcast<f32>(3472883712u))), 2147483647i, (_e152 > bitcast<f32>(1325400063u))), (_e152 == _e152)));
            if (_e164 > _e152) {
                phi_317_ = 1f;
            } else {
                phi_317_ = 0f;
            }
            let _e167 = phi_317_;
            if (_e152 < 8388608f) {
                phi_322_ = (_e164 - _e167);
                phi_323_ = false;
            } else {
                phi_322_ = f32();
                phi_323_ = true;
            }
            let _e170 = phi_322_;
            let _e172 = phi_323_;
            phi_324_ = _e170;
            phi_325_ = _e172;
        } else {
            phi_324_ = f32();
            phi_325_ = true;
        }
        let _e174 = phi_324_;
        let _e176 = phi_325_;
        if _e176 {
            phi_329_ = _e152;
        } else {
            phi_329_ = _e174;
        }
        let _e178 = phi_329_;
        let _e182 = ((_e150 - (_e178 * 0.69314575f)) - (_e178 * 0.0000014286068f));
        phi_367_ = ((((((((((((((((1f / 5040f) * _e182) + (1f / 720f)) * _e182) + (1f / 120f)) * _e182) + (1f / 24f)) * _e182) + (1f / 6f)) * _e182) + 0.5f) * _e182) + 1f) * _e182) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e178), i32(-2147483648), (_e178 < bitcast<f32>(3472883712u))), 2147483647i, (_e178 > bitcast<f32>(1325400063u))), (_e178 == _e178)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e218 = phi_367_;
    let _e219 = -(_e218);
    return vec4<f32>(_e138, (_e138 * _e138), _e219, (_e219 * _e219));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_1013_: bool;
    var phi_1017_: f32;
    var phi_1029_: bool;
    var phi_1036_: f32;
    var phi_1061_: bool;
    var phi_1065_: f32;
    var phi_1077_: bool;
    var phi_1084_: f32;
    var phi_1095_: bool;
    var phi_1099_: f32;
    var phi_1114_: f32;
    var phi_1115_: f32;
    var phi_1116_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e51 = _lt_math_evsm_Evsm_positive(param_8);
    let _e53 = (*param_8).min_variance;
    let _e57 = (((_e53 * _e51) * _e51) * _e50.y);
    let _e64 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
        phi_1013_ = true;
    } else {
        let _e68 = (_e57 > _e64);
        if _e68 {
        }
        phi_1013_ = _e68;
    }
    let _e70 = phi_1013_;
    if _e70 {
        phi_1017_ = _e57;
    } else {
        phi_1017_ = _e64;
    }
    let _e72 = phi_1017_;
    let _e73 = (_e50.x - param_9.x);
    if (_e73 <= 0f) {
        let _e77 = ((bitcast<u32>(_e72) & 2147483647u) > 2139095040u);
        if _e77 {
        }
        phi_1029_ = _e77;
    } else {
        phi_1029_ = true;
    }
    let _e79 = phi_1029_;
    if _e79 {
        phi_1036_ = (_e72 / (_e72 + (_e73 * _e73)));
    } else {
        phi_1036_ = 1f;
    }
    let _e84 = phi_1036_;
    let _e85 = _lt_math_evsm_Evsm_negative(param_8);
    let _e87 = (*param_8).min_variance;
    let _e91 = (((_e87 * _e85) * _e85) * _e50.w);
    let _e98 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
        phi_1061_ = true;
    } else {
        let _e102 = (_e91 > _e98);
        if _e102 {
        }
        phi_1061_ = _e102;
    }
    let _e104 = phi_1061_;
    if _e104 {
        phi_1065_ = _e91;
    } else {
        phi_1065_ = _e98;
    }
    let _e106 = phi_1065_;
    let _e107 = (_e50.z - param_9.z);
    if (_e107 <= 0f) {
        let _e111 = ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u);
        if _e111 {
        }
        phi_1077_ = _e111;
    } else {
        phi_1077_ = true;
    }
    let _e113 = phi_1077_;
    if _e113 {
        phi_1084_ = (_e106 / (_e106 + (_e107 * _e107)));
    } else {
        phi_1084_ = 1f;
    }
    let _e118 = phi_1084_;
    if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
        phi_1095_ = true;
    } else {
        let _e122 = (_e118 < _e84);
        if _e122 {
        }
        phi_1095_ = _e122;
    }
    let _e124 = phi_1095_;
    if _e124 {
        phi_1099_ = _e118;
    } else {
        phi_1099_ = _e84;
    }
    let _e126 = phi_1099_;
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_1116_ = _e126;
    } else {
        if (_e126 < 0f) {
            phi_1115_ = 0f;
        } else {
            if (_e126 > 1f) {
                phi_1114_ = 1f;
            } else {
                phi_1114_ = _e126;
            }
            let _e133 = phi_1114_;
            phi_1115_ = _e133;
        }
        let _e135 = phi_1115_;
        phi_1116_ = _e135;
    }
    let _e137 = phi_1116_;
    return _e137;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_470_: bool;
    var phi_514_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_518_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_595_: bool;
    var phi_604_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_619_: bool;
    var phi_623_: bool;
    var phi_717_: f32;
    var phi_720_: f32;
    var phi_749_: f32;
    var phi_754_: f32;
    var phi_755_: bool;
    var phi_756_: f32;
    var phi_757_: bool;
    var phi_761_: f32;
    var phi_781_: f32;
    var phi_786_: f32;
    var phi_787_: bool;
    var phi_788_: f32;
    var phi_789_: bool;
    var phi_793_: f32;
    var phi_843_: i32;
    var phi_848_: i32;
    var phi_853_: i32;
    var phi_858_: i32;
    var phi_867_: i32;
    var phi_872_: i32;
    var phi_877_: i32;
    var phi_882_: i32;
    var phi_967_: evaluate_Verdict;
    var phi_968_: evaluate_Verdict;
    var phi_969_: bool;
    var phi_970_: evaluate_Verdict;
    var phi_971_: evaluate_Verdict;
    var phi_972_: bool;
    var phi_976_: evaluate_Verdict;

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
                phi_463_ = (_e86 == _e88);
                phi_464_ = false;
            } else {
                phi_463_ = bool();
                phi_464_ = true;
            }
            let _e91 = phi_463_;
            let _e93 = phi_464_;
            phi_465_ = _e91;
            phi_466_ = _e93;
        } else {
            phi_465_ = bool();
            phi_466_ = true;
        }
        let _e95 = phi_465_;
        let _e97 = phi_466_;
        if _e97 {
            phi_470_ = false;
        } else {
            phi_470_ = _e95;
        }
        let _e99 = phi_470_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_514_;
            phi_518_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_518_;
        if _e179.unnamed_1 {
            phi_970_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
            phi_971_ = evaluate_Verdict();
            phi_972_ = true;
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
                    phi_595_ = (_e218 <= 1f);
                } else {
                    phi_595_ = false;
                }
                let _e250 = phi_595_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_604_ = (_e232 <= 1f);
                    } else {
                        phi_604_ = false;
                    }
                    let _e254 = phi_604_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_613_ = (_e245 <= 1f);
                        } else {
                            phi_613_ = false;
                        }
                        let _e258 = phi_613_;
                        phi_614_ = _e258;
                        phi_615_ = false;
                    } else {
                        phi_614_ = bool();
                        phi_615_ = true;
                    }
                    let _e260 = phi_614_;
                    let _e262 = phi_615_;
                    phi_616_ = _e260;
                    phi_617_ = _e262;
                } else {
                    phi_616_ = bool();
                    phi_617_ = true;
                }
                let _e264 = phi_616_;
                let _e266 = phi_617_;
                phi_618_ = _e264;
                phi_619_ = _e266;
            } else {
                phi_618_ = bool();
                phi_619_ = true;
            }
            let _e268 = phi_618_;
            let _e270 = phi_619_;
            if _e270 {
                phi_623_ = false;
            } else {
                phi_623_ = _e268;
            }
            let _e272 = phi_623_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_717_ = _e351;
                    } else {
                        phi_717_ = 0.002f;
                    }
                    let _e354 = phi_717_;
                    phi_720_ = (_e245 - (0f * _e354));
                } else {
                    phi_720_ = _e245;
                }
                let _e358 = phi_720_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_749_ = 1f;
                    } else {
                        phi_749_ = 0f;
                    }
                    let _e380 = phi_749_;
                    if (_e364 < 8388608f) {
                        phi_754_ = (_e377 - _e380);
                        phi_755_ = false;
                    } else {
                        phi_754_ = f32();
                        phi_755_ = true;
                    }
                    let _e383 = phi_754_;
                    let _e385 = phi_755_;
                    phi_756_ = _e383;
                    phi_757_ = _e385;
                } else {
                    phi_756_ = f32();
                    phi_757_ = true;
                }
                let _e387 = phi_756_;
                let _e389 = phi_757_;
                if _e389 {
                    phi_761_ = _e364;
                } else {
                    phi_761_ = _e387;
                }
                let _e391 = phi_761_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_781_ = 1f;
                    } else {
                        phi_781_ = 0f;
                    }
                    let _e406 = phi_781_;
                    if (_e365 < 8388608f) {
                        phi_786_ = (_e403 - _e406);
                        phi_787_ = false;
                    } else {
                        phi_786_ = f32();
                        phi_787_ = true;
                    }
                    let _e409 = phi_786_;
                    let _e411 = phi_787_;
                    phi_788_ = _e409;
                    phi_789_ = _e411;
                } else {
                    phi_788_ = f32();
                    phi_789_ = true;
                }
                let _e413 = phi_788_;
                let _e415 = phi_789_;
                if _e415 {
                    phi_793_ = _e365;
                } else {
                    phi_793_ = _e413;
                }
                let _e417 = phi_793_;
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
                    phi_843_ = _e428;
                } else {
                    phi_843_ = 0i;
                }
                let _e459 = phi_843_;
                if (_e437 > 0i) {
                    phi_848_ = _e437;
                } else {
                    phi_848_ = 0i;
                }
                let _e462 = phi_848_;
                if (_e459 < _e456) {
                    phi_853_ = _e459;
                } else {
                    phi_853_ = _e456;
                }
                let _e465 = phi_853_;
                if (_e462 < _e456) {
                    phi_858_ = _e462;
                } else {
                    phi_858_ = _e456;
                }
                let _e468 = phi_858_;
                let _e469 = bitcast<u32>(_e465);
                let _e471 = (_e428 + 1i);
                let _e472 = (_e437 + 1i);
                if (_e471 > 0i) {
                    phi_867_ = _e471;
                } else {
                    phi_867_ = 0i;
                }
                let _e475 = phi_867_;
                if (_e472 > 0i) {
                    phi_872_ = _e472;
                } else {
                    phi_872_ = 0i;
                }
                let _e478 = phi_872_;
                if (_e475 < _e456) {
                    phi_877_ = _e475;
                } else {
                    phi_877_ = _e456;
                }
                let _e481 = phi_877_;
                if (_e478 < _e456) {
                    phi_882_ = _e478;
                } else {
                    phi_882_ = _e456;
                }
                let _e484 = phi_882_;
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
                phi_967_ = evaluate_Verdict(_e554, false);
                phi_968_ = evaluate_Verdict();
                phi_969_ = false;
            } else {
                phi_967_ = evaluate_Verdict();
                phi_968_ = evaluate_Verdict(1f, false);
                phi_969_ = true;
            }
            let _e558 = phi_967_;
            let _e560 = phi_968_;
            let _e562 = phi_969_;
            phi_970_ = _e560;
            phi_971_ = _e558;
            phi_972_ = _e562;
        }
        let _e564 = phi_970_;
        let _e566 = phi_971_;
        let _e568 = phi_972_;
        if _e568 {
            phi_976_ = _e564;
        } else {
            phi_976_ = _e566;
        }
        let _e570 = phi_976_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e570.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
