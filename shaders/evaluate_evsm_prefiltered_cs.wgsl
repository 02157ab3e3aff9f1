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
    var phi_416_: bool;
    var phi_420_: f32;
    var phi_421_: f32;

    let _e48 = (*param_4).negative_exponent;
    if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
        phi_421_ = _e48;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_416_ = true;
        } else {
            let _e55 = (42f < _e48);
            if _e55 {
            }
            phi_416_ = _e55;
        }
        let _e57 = phi_416_;
        if _e57 {
            phi_420_ = 42f;
        } else {
            phi_420_ = _e48;
        }
        let _e59 = phi_420_;
        phi_421_ = _e59;
    }
    let _e61 = phi_421_;
    return _e61;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_390_: bool;
    var phi_394_: f32;
    var phi_395_: f32;

    let _e48 = (*param_5).positive_exponent;
    if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
        phi_395_ = _e48;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_390_ = true;
        } else {
            let _e55 = (42f < _e48);
            if _e55 {
            }
            phi_390_ = _e55;
        }
        let _e57 = phi_390_;
        if _e57 {
            phi_394_ = 42f;
        } else {
            phi_394_ = _e48;
        }
        let _e59 = phi_394_;
        phi_395_ = _e59;
    }
    let _e61 = phi_395_;
    return _e61;
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
    var phi_941_: bool;
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_958_: bool;
    var phi_965_: f32;
    var phi_996_: bool;
    var phi_1000_: f32;
    var phi_1001_: f32;
    var phi_1013_: bool;
    var phi_1020_: f32;
    var phi_1037_: bool;
    var phi_1041_: f32;
    var phi_1042_: f32;
    var phi_1057_: f32;
    var phi_1058_: f32;
    var phi_1059_: f32;

    let _e49 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e50 = _lt_math_evsm_Evsm_positive(param_8);
    let _e52 = (*param_8).min_variance;
    let _e56 = (((_e52 * _e50) * _e50) * _e49.y);
    let _e63 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_946_ = _e63;
    } else {
        if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
            phi_941_ = true;
        } else {
            let _e70 = (_e56 > _e63);
            if _e70 {
            }
            phi_941_ = _e70;
        }
        let _e72 = phi_941_;
        if _e72 {
            phi_945_ = _e56;
        } else {
            phi_945_ = _e63;
        }
        let _e74 = phi_945_;
        phi_946_ = _e74;
    }
    let _e76 = phi_946_;
    let _e77 = (_e49.x - param_9.x);
    if (_e77 <= 0f) {
        let _e81 = ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u);
        if _e81 {
        }
        phi_958_ = _e81;
    } else {
        phi_958_ = true;
    }
    let _e83 = phi_958_;
    if _e83 {
        phi_965_ = (_e76 / (_e76 + (_e77 * _e77)));
    } else {
        phi_965_ = 1f;
    }
    let _e88 = phi_965_;
    let _e89 = _lt_math_evsm_Evsm_negative(param_8);
    let _e91 = (*param_8).min_variance;
    let _e95 = (((_e91 * _e89) * _e89) * _e49.w);
    let _e102 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e102) & 2147483647u) > 2139095040u) {
        phi_1001_ = _e102;
    } else {
        if ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u) {
            phi_996_ = true;
        } else {
            let _e109 = (_e95 > _e102);
            if _e109 {
            }
            phi_996_ = _e109;
        }
        let _e111 = phi_996_;
        if _e111 {
            phi_1000_ = _e95;
        } else {
            phi_1000_ = _e102;
        }
        let _e113 = phi_1000_;
        phi_1001_ = _e113;
    }
    let _e115 = phi_1001_;
    let _e116 = (_e49.z - param_9.z);
    if (_e116 <= 0f) {
        let _e120 = ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u);
        if _e120 {
        }
        phi_1013_ = _e120;
    } else {
        phi_1013_ = true;
    }
    let _e122 = phi_1013_;
    if _e122 {
        phi_1020_ = (_e115 / (_e115 + (_e116 * _e116)));
    } else {
        phi_1020_ = 1f;
    }
    let _e127 = phi_1020_;
    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
        phi_1042_ = _e88;
    } else {
        if ((bitcast<u32>(_e127) & 2147483647u) > 2139095040u) {
            phi_1037_ = true;
        } else {
            let _e134 = (_e127 < _e88);
            if _e134 {
            }
            phi_1037_ = _e134;
        }
        let _e136 = phi_1037_;
        if _e136 {
            phi_1041_ = _e127;
        } else {
            phi_1041_ = _e88;
        }
        let _e138 = phi_1041_;
        phi_1042_ = _e138;
    }
    let _e140 = phi_1042_;
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_1059_ = _e140;
    } else {
        if (_e140 < 0f) {
            phi_1058_ = 0f;
        } else {
            if (_e140 > 1f) {
                phi_1057_ = 1f;
            } else {
                phi_1057_ = _e140;
            }
            let _e147 = phi_1057_;
            phi_1058_ = _e147;
        }
        let _e149 = phi_1058_;
        phi_1059_ = _e149;
    }
    let _e151 = phi_1059_;
    return _e151;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_475_: bool;
    var phi_476_: bool;
    var phi_477_: bool;
    var phi_478_: bool;
    var phi_482_: bool;
    var phi_526_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_530_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_607_: bool;
    var phi_616_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_635_: bool;
    var phi_671_: f32;
    var phi_676_: f32;
    var phi_677_: bool;
    var phi_678_: f32;
    var phi_679_: bool;
    var phi_683_: f32;
    var phi_703_: f32;
    var phi_708_: f32;
    var phi_709_: bool;
    var phi_710_: f32;
    var phi_711_: bool;
    var phi_715_: f32;
    var phi_765_: i32;
    var phi_770_: i32;
    var phi_775_: i32;
    var phi_780_: i32;
    var phi_789_: i32;
    var phi_794_: i32;
    var phi_799_: i32;
    var phi_804_: i32;
    var phi_889_: evaluate_Verdict;
    var phi_890_: evaluate_Verdict;
    var phi_891_: bool;
    var phi_892_: evaluate_Verdict;
    var phi_893_: evaluate_Verdict;
    var phi_894_: bool;
    var phi_898_: evaluate_Verdict;

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
                phi_475_ = (_e85 == _e87);
                phi_476_ = false;
            } else {
                phi_475_ = bool();
                phi_476_ = true;
            }
            let _e90 = phi_475_;
            let _e92 = phi_476_;
            phi_477_ = _e90;
            phi_478_ = _e92;
        } else {
            phi_477_ = bool();
            phi_478_ = true;
        }
        let _e94 = phi_477_;
        let _e96 = phi_478_;
        if _e96 {
            phi_482_ = false;
        } else {
            phi_482_ = _e94;
        }
        let _e98 = phi_482_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_526_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_526_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_526_;
            phi_530_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_530_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_530_;
        if _e178.unnamed_1 {
            phi_892_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
            phi_893_ = evaluate_Verdict();
            phi_894_ = true;
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
                    phi_607_ = (_e217 <= 1f);
                } else {
                    phi_607_ = false;
                }
                let _e249 = phi_607_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_616_ = (_e231 <= 1f);
                    } else {
                        phi_616_ = false;
                    }
                    let _e253 = phi_616_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_625_ = (_e244 <= 1f);
                        } else {
                            phi_625_ = false;
                        }
                        let _e257 = phi_625_;
                        phi_626_ = _e257;
                        phi_627_ = false;
                    } else {
                        phi_626_ = bool();
                        phi_627_ = true;
                    }
                    let _e259 = phi_626_;
                    let _e261 = phi_627_;
                    phi_628_ = _e259;
                    phi_629_ = _e261;
                } else {
                    phi_628_ = bool();
                    phi_629_ = true;
                }
                let _e263 = phi_628_;
                let _e265 = phi_629_;
                phi_630_ = _e263;
                phi_631_ = _e265;
            } else {
                phi_630_ = bool();
                phi_631_ = true;
            }
            let _e267 = phi_630_;
            let _e269 = phi_631_;
            if _e269 {
                phi_635_ = false;
            } else {
                phi_635_ = _e267;
            }
            let _e271 = phi_635_;
            if _e271 {
                let _e273 = p.member.map_size;
                let _e274 = f32(_e273);
                let _e277 = ((_e217 * _e274) - 0.5f);
                let _e278 = ((_e231 * _e274) - 0.5f);
                if (_e277 > -8388608f) {
                    let _e290 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e290 > _e277) {
                        phi_671_ = 1f;
                    } else {
                        phi_671_ = 0f;
                    }
                    let _e293 = phi_671_;
                    if (_e277 < 8388608f) {
                        phi_676_ = (_e290 - _e293);
                        phi_677_ = false;
                    } else {
                        phi_676_ = f32();
                        phi_677_ = true;
                    }
                    let _e296 = phi_676_;
                    let _e298 = phi_677_;
                    phi_678_ = _e296;
                    phi_679_ = _e298;
                } else {
                    phi_678_ = f32();
                    phi_679_ = true;
                }
                let _e300 = phi_678_;
                let _e302 = phi_679_;
                if _e302 {
                    phi_683_ = _e277;
                } else {
                    phi_683_ = _e300;
                }
                let _e304 = phi_683_;
                if (_e278 > -8388608f) {
                    let _e316 = f32(select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < bitcast<f32>(3472883712u))), 2147483647i, (_e278 > bitcast<f32>(1325400063u))), (_e278 == _e278)));
                    if (_e316 > _e278) {
                        phi_703_ = 1f;
                    } else {
                        phi_703_ = 0f;
                    }
                    let _e319 = phi_703_;
                    if (_e278 < 8388608f) {
                        phi_708_ = (_e316 - _e319);
                        phi_709_ = false;
                    } else {
                        phi_708_ = f32();
                        phi_709_ = true;
                    }
                    let _e322 = phi_708_;
                    let _e324 = phi_709_;
                    phi_710_ = _e322;
                    phi_711_ = _e324;
                } else {
                    phi_710_ = f32();
                    phi_711_ = true;
                }
                let _e326 = phi_710_;
                let _e328 = phi_711_;
                if _e328 {
                    phi_715_ = _e278;
                } else {
                    phi_715_ = _e326;
                }
                let _e330 = phi_715_;
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
                    phi_765_ = _e341;
                } else {
                    phi_765_ = 0i;
                }
                let _e372 = phi_765_;
                if (_e350 > 0i) {
                    phi_770_ = _e350;
                } else {
                    phi_770_ = 0i;
                }
                let _e375 = phi_770_;
                if (_e372 < _e369) {
                    phi_775_ = _e372;
                } else {
                    phi_775_ = _e369;
                }
                let _e378 = phi_775_;
                if (_e375 < _e369) {
                    phi_780_ = _e375;
                } else {
                    phi_780_ = _e369;
                }
                let _e381 = phi_780_;
                let _e382 = bitcast<u32>(_e378);
                let _e384 = (_e341 + 1i);
                let _e385 = (_e350 + 1i);
                if (_e384 > 0i) {
                    phi_789_ = _e384;
                } else {
                    phi_789_ = 0i;
                }
                let _e388 = phi_789_;
                if (_e385 > 0i) {
                    phi_794_ = _e385;
                } else {
                    phi_794_ = 0i;
                }
                let _e391 = phi_794_;
                if (_e388 < _e369) {
                    phi_799_ = _e388;
                } else {
                    phi_799_ = _e369;
                }
                let _e394 = phi_799_;
                if (_e391 < _e369) {
                    phi_804_ = _e391;
                } else {
                    phi_804_ = _e369;
                }
                let _e397 = phi_804_;
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
                phi_889_ = evaluate_Verdict(_e467, false);
                phi_890_ = evaluate_Verdict();
                phi_891_ = false;
            } else {
                phi_889_ = evaluate_Verdict();
                phi_890_ = evaluate_Verdict(1f, false);
                phi_891_ = true;
            }
            let _e471 = phi_889_;
            let _e473 = phi_890_;
            let _e475 = phi_891_;
            phi_892_ = _e473;
            phi_893_ = _e471;
            phi_894_ = _e475;
        }
        let _e477 = phi_892_;
        let _e479 = phi_893_;
        let _e481 = phi_894_;
        if _e481 {
            phi_898_ = _e477;
        } else {
            phi_898_ = _e479;
        }
        let _e483 = phi_898_;
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
