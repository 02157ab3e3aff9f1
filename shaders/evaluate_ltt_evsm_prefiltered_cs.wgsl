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

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_38 {
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

struct type_42 {
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

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_25;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_42;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_29;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_38;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_176_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_168_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_169_ = false;
        } else {
            phi_168_ = lt_bvh_traverse_Tree();
            phi_169_ = true;
        }
        let _e60 = phi_168_;
        let _e62 = phi_169_;
        phi_170_ = _e60;
        phi_171_ = _e62;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e64 = phi_170_;
    let _e66 = phi_171_;
    if _e66 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e64;
    }
    let _e71 = phi_176_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_443_: bool;
    var phi_447_: f32;
    var phi_448_: f32;

    let _e49 = (*param_4).negative_exponent;
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_448_ = _e49;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_443_ = true;
        } else {
            let _e56 = (42f < _e49);
            if _e56 {
            }
            phi_443_ = _e56;
        }
        let _e58 = phi_443_;
        if _e58 {
            phi_447_ = 42f;
        } else {
            phi_447_ = _e49;
        }
        let _e60 = phi_447_;
        phi_448_ = _e60;
    }
    let _e62 = phi_448_;
    return _e62;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_417_: bool;
    var phi_421_: f32;
    var phi_422_: f32;

    let _e49 = (*param_5).positive_exponent;
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_422_ = _e49;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_417_ = true;
        } else {
            let _e56 = (42f < _e49);
            if _e56 {
            }
            phi_417_ = _e56;
        }
        let _e58 = phi_417_;
        if _e58 {
            phi_421_ = 42f;
        } else {
            phi_421_ = _e49;
        }
        let _e60 = phi_421_;
        phi_422_ = _e60;
    }
    let _e62 = phi_422_;
    return _e62;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_230_: bool;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_252_: bool;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_298_: f32;
    var phi_324_: bool;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_346_: bool;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_392_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_205_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_204_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_203_ = 1f;
            } else {
                phi_203_ = param_7;
            }
            let _e55 = phi_203_;
            phi_204_ = _e55;
        }
        let _e57 = phi_204_;
        phi_205_ = _e57;
    }
    let _e59 = phi_205_;
    let _e60 = _lt_math_evsm_Evsm_positive(param_6);
    let _e61 = (_e60 * _e59);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_298_ = _e61;
    } else {
        if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
            phi_235_ = _e61;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_230_ = true;
            } else {
                let _e71 = (-87f > _e61);
                if _e71 {
                }
                phi_230_ = _e71;
            }
            let _e73 = phi_230_;
            if _e73 {
                phi_234_ = -87f;
            } else {
                phi_234_ = _e61;
            }
            let _e75 = phi_234_;
            phi_235_ = _e75;
        }
        let _e77 = phi_235_;
        if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
            phi_257_ = _e77;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_252_ = true;
            } else {
                let _e84 = (88f < _e77);
                if _e84 {
                }
                phi_252_ = _e84;
            }
            let _e86 = phi_252_;
            if _e86 {
                phi_256_ = 88f;
            } else {
                phi_256_ = _e77;
            }
            let _e88 = phi_256_;
            phi_257_ = _e88;
        }
        let _e90 = phi_257_;
        let _e93 = floor(((_e90 * 1.442695f) + 0.5f));
        let _e97 = ((_e90 - (_e93 * 0.69314575f)) - (_e93 * 0.0000014286068f));
        phi_298_ = ((((((((((((((((1f / 5040f) * _e97) + (1f / 720f)) * _e97) + (1f / 120f)) * _e97) + (1f / 24f)) * _e97) + (1f / 6f)) * _e97) + 0.5f) * _e97) + 1f) * _e97) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e93), i32(-2147483648), (_e93 < bitcast<f32>(3472883712u))), 2147483647i, (_e93 > bitcast<f32>(1325400063u))), (_e93 == _e93)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e133 = phi_298_;
    let _e134 = _lt_math_evsm_Evsm_negative(param_6);
    let _e136 = (-(_e134) * _e59);
    if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
        phi_392_ = _e136;
    } else {
        if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
            phi_329_ = _e136;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_324_ = true;
            } else {
                let _e146 = (-87f > _e136);
                if _e146 {
                }
                phi_324_ = _e146;
            }
            let _e148 = phi_324_;
            if _e148 {
                phi_328_ = -87f;
            } else {
                phi_328_ = _e136;
            }
            let _e150 = phi_328_;
            phi_329_ = _e150;
        }
        let _e152 = phi_329_;
        if ((bitcast<u32>(_e152) & 2147483647u) > 2139095040u) {
            phi_351_ = _e152;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_346_ = true;
            } else {
                let _e159 = (88f < _e152);
                if _e159 {
                }
                phi_346_ = _e159;
            }
            let _e161 = phi_346_;
            if _e161 {
                phi_350_ = 88f;
            } else {
                phi_350_ = _e152;
            }
            let _e163 = phi_350_;
            phi_351_ = _e163;
        }
        let _e165 = phi_351_;
        let _e168 = floor(((_e165 * 1.442695f) + 0.5f));
        let _e172 = ((_e165 - (_e168 * 0.69314575f)) - (_e168 * 0.0000014286068f));
        phi_392_ = ((((((((((((((((1f / 5040f) * _e172) + (1f / 720f)) * _e172) + (1f / 120f)) * _e172) + (1f / 24f)) * _e172) + (1f / 6f)) * _e172) + 0.5f) * _e172) + 1f) * _e172) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e168), i32(-2147483648), (_e168 < bitcast<f32>(3472883712u))), 2147483647i, (_e168 > bitcast<f32>(1325400063u))), (_e168 == _e168)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e208 = phi_392_;
    let _e209 = -(_e208);
    return vec4<f32>(_e133, (_e133 * _e133), _e209, (_e209 * _e209));
}

fn lt_shaders_evaluate_to_light(param_8: vec3<f32>, param_9: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_9.x - (param_8.x * param_9.w)), (param_9.y - (param_8.y * param_9.w)), (param_9.z - (param_8.z * param_9.w)));
}

fn lt_shaders_evaluate_quad_indices(param_10: i32, param_11: i32, param_12: u32) -> array<u32, 4> {
    var phi_476_: i32;
    var phi_481_: i32;
    var phi_486_: i32;
    var phi_491_: i32;
    var phi_500_: i32;
    var phi_505_: i32;
    var phi_510_: i32;
    var phi_515_: i32;

    let _e51 = (bitcast<i32>(param_12) - 1i);
    if (param_10 > 0i) {
        phi_476_ = param_10;
    } else {
        phi_476_ = 0i;
    }
    let _e54 = phi_476_;
    if (param_11 > 0i) {
        phi_481_ = param_11;
    } else {
        phi_481_ = 0i;
    }
    let _e57 = phi_481_;
    if (_e54 < _e51) {
        phi_486_ = _e54;
    } else {
        phi_486_ = _e51;
    }
    let _e60 = phi_486_;
    if (_e57 < _e51) {
        phi_491_ = _e57;
    } else {
        phi_491_ = _e51;
    }
    let _e63 = phi_491_;
    let _e64 = bitcast<u32>(_e60);
    let _e66 = (param_10 + 1i);
    let _e67 = (param_11 + 1i);
    if (_e66 > 0i) {
        phi_500_ = _e66;
    } else {
        phi_500_ = 0i;
    }
    let _e70 = phi_500_;
    if (_e67 > 0i) {
        phi_505_ = _e67;
    } else {
        phi_505_ = 0i;
    }
    let _e73 = phi_505_;
    if (_e70 < _e51) {
        phi_510_ = _e70;
    } else {
        phi_510_ = _e51;
    }
    let _e76 = phi_510_;
    if (_e73 < _e51) {
        phi_515_ = _e73;
    } else {
        phi_515_ = _e51;
    }
    let _e79 = phi_515_;
    let _e80 = bitcast<u32>(_e76);
    let _e82 = (bitcast<u32>(_e63) * param_12);
    let _e83 = (bitcast<u32>(_e79) * param_12);
    return array<u32, 4>((_e82 + _e64), (_e82 + _e80), (_e83 + _e64), (_e83 + _e80));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_13: ptr<function, lt_math_Evsm>, param_14: vec4<f32>, param_15: f32) -> f32 {
    var phi_559_: bool;
    var phi_563_: f32;
    var phi_564_: f32;
    var phi_581_: bool;
    var phi_585_: f32;
    var phi_586_: f32;
    var phi_598_: bool;
    var phi_605_: f32;
    var phi_635_: bool;
    var phi_639_: f32;
    var phi_640_: f32;
    var phi_657_: bool;
    var phi_661_: f32;
    var phi_662_: f32;
    var phi_674_: bool;
    var phi_681_: f32;
    var phi_698_: bool;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_720_: f32;

    let _e50 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_13, param_15);
    let _e51 = _lt_math_evsm_Evsm_positive(param_13);
    let _e53 = (*param_13).min_variance;
    let _e57 = (((_e53 * _e51) * _e51) * _e50.y);
    let _e62 = (param_14.y - (param_14.x * param_14.x));
    let _e63 = (0.00000047683716f * param_14.y);
    if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
        phi_564_ = _e57;
    } else {
        if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
            phi_559_ = true;
        } else {
            let _e70 = (_e63 > _e57);
            if _e70 {
            }
            phi_559_ = _e70;
        }
        let _e72 = phi_559_;
        if _e72 {
            phi_563_ = _e63;
        } else {
            phi_563_ = _e57;
        }
        let _e74 = phi_563_;
        phi_564_ = _e74;
    }
    let _e76 = phi_564_;
    if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
        phi_586_ = _e62;
    } else {
        if ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u) {
            phi_581_ = true;
        } else {
            let _e83 = (_e76 > _e62);
            if _e83 {
            }
            phi_581_ = _e83;
        }
        let _e85 = phi_581_;
        if _e85 {
            phi_585_ = _e76;
        } else {
            phi_585_ = _e62;
        }
        let _e87 = phi_585_;
        phi_586_ = _e87;
    }
    let _e89 = phi_586_;
    let _e90 = (_e50.x - param_14.x);
    if (_e90 <= 0f) {
        let _e94 = ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u);
        if _e94 {
        }
        phi_598_ = _e94;
    } else {
        phi_598_ = true;
    }
    let _e96 = phi_598_;
    if _e96 {
        phi_605_ = (_e89 / (_e89 + (_e90 * _e90)));
    } else {
        phi_605_ = 1f;
    }
    let _e101 = phi_605_;
    let _e102 = _lt_math_evsm_Evsm_negative(param_13);
    let _e104 = (*param_13).min_variance;
    let _e108 = (((_e104 * _e102) * _e102) * _e50.w);
    let _e113 = (param_14.w - (param_14.z * param_14.z));
    let _e114 = (0.00000047683716f * param_14.w);
    if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
        phi_640_ = _e108;
    } else {
        if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
            phi_635_ = true;
        } else {
            let _e121 = (_e114 > _e108);
            if _e121 {
            }
            phi_635_ = _e121;
        }
        let _e123 = phi_635_;
        if _e123 {
            phi_639_ = _e114;
        } else {
            phi_639_ = _e108;
        }
        let _e125 = phi_639_;
        phi_640_ = _e125;
    }
    let _e127 = phi_640_;
    if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
        phi_662_ = _e113;
    } else {
        if ((bitcast<u32>(_e127) & 2147483647u) > 2139095040u) {
            phi_657_ = true;
        } else {
            let _e134 = (_e127 > _e113);
            if _e134 {
            }
            phi_657_ = _e134;
        }
        let _e136 = phi_657_;
        if _e136 {
            phi_661_ = _e127;
        } else {
            phi_661_ = _e113;
        }
        let _e138 = phi_661_;
        phi_662_ = _e138;
    }
    let _e140 = phi_662_;
    let _e141 = (_e50.z - param_14.z);
    if (_e141 <= 0f) {
        let _e145 = ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u);
        if _e145 {
        }
        phi_674_ = _e145;
    } else {
        phi_674_ = true;
    }
    let _e147 = phi_674_;
    if _e147 {
        phi_681_ = (_e140 / (_e140 + (_e141 * _e141)));
    } else {
        phi_681_ = 1f;
    }
    let _e152 = phi_681_;
    if ((bitcast<u32>(_e101) & 2147483647u) > 2139095040u) {
        phi_703_ = _e101;
    } else {
        if ((bitcast<u32>(_e152) & 2147483647u) > 2139095040u) {
            phi_698_ = true;
        } else {
            let _e159 = (_e152 < _e101);
            if _e159 {
            }
            phi_698_ = _e159;
        }
        let _e161 = phi_698_;
        if _e161 {
            phi_702_ = _e152;
        } else {
            phi_702_ = _e101;
        }
        let _e163 = phi_702_;
        phi_703_ = _e163;
    }
    let _e165 = phi_703_;
    if ((bitcast<u32>(_e165) & 2147483647u) > 2139095040u) {
        phi_720_ = _e165;
    } else {
        if (_e165 < 0f) {
            phi_719_ = 0f;
        } else {
            if (_e165 > 1f) {
                phi_718_ = 1f;
            } else {
                phi_718_ = _e165;
            }
            let _e172 = phi_718_;
            phi_719_ = _e172;
        }
        let _e174 = phi_719_;
        phi_720_ = _e174;
    }
    let _e176 = phi_720_;
    return _e176;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_776_: bool;
    var phi_777_: bool;
    var phi_781_: bool;
    var phi_816_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_820_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_922_: bool;
    var phi_923_: bool;
    var phi_924_: bool;
    var phi_928_: bool;
    var phi_1077_: bool;
    var phi_1085_: bool;
    var phi_1090_: f32;
    var phi_1093_: evaluate_Verdict;
    var phi_1094_: evaluate_Verdict;
    var phi_1098_: bool;
    var phi_1099_: u32;
    var phi_1105_: u32;

    let _e48 = id_1;
    let _e49 = local_2;
    let _e54 = arrayLength((&map.member));
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e71 = p.member.light;
        let _e74 = samples.member[_e64.first_primitive].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[_e64.first_primitive].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[_e64.first_primitive].normal[2u];
                let _e86 = global[2u];
                phi_774_ = (_e84 == _e86);
                phi_775_ = false;
            } else {
                phi_774_ = bool();
                phi_775_ = true;
            }
            let _e89 = phi_774_;
            let _e91 = phi_775_;
            phi_776_ = _e89;
            phi_777_ = _e91;
        } else {
            phi_776_ = bool();
            phi_777_ = true;
        }
        let _e93 = phi_776_;
        let _e95 = phi_777_;
        if _e95 {
            phi_781_ = false;
        } else {
            phi_781_ = _e93;
        }
        let _e97 = phi_781_;
        if !(_e97) {
            let _e100 = samples.member[_e64.first_primitive].normal;
            let _e102 = samples.member[_e64.first_primitive].position;
            let _e103 = lt_shaders_evaluate_to_light(_e102, _e71);
            if ((((_e100.x * _e103.x) + (_e100.y * _e103.y)) + (_e100.z * _e103.z)) > 0f) {
                let _e117 = samples.member[_e64.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_816_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_816_;
            phi_820_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_820_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_820_;
        if _e168.unnamed_1 {
            phi_1094_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[_e64.first_primitive].position;
            let _e182 = p.member.projection.row_w;
            let _e193 = ((((_e182.x * _e176.x) + (_e182.y * _e176.y)) + (_e182.z * _e176.z)) + (_e182.w * 1f));
            let _e195 = p.member.projection.row_x;
            let _e207 = (((((_e195.x * _e176.x) + (_e195.y * _e176.y)) + (_e195.z * _e176.z)) + (_e195.w * 1f)) / _e193);
            let _e209 = p.member.projection.row_y;
            let _e221 = (((((_e209.x * _e176.x) + (_e209.y * _e176.y)) + (_e209.z * _e176.z)) + (_e209.w * 1f)) / _e193);
            let _e223 = p.member.projection.row_z;
            let _e234 = ((((_e223.x * _e176.x) + (_e223.y * _e176.y)) + (_e223.z * _e176.z)) + (_e223.w * 1f));
            if (_e193 > 0f) {
                if (_e207 >= 0f) {
                    if (_e207 <= 1f) {
                        if (_e221 >= 0f) {
                            if (_e221 <= 1f) {
                                if (_e234 >= 0f) {
                                    phi_913_ = (_e234 <= 1f);
                                    phi_914_ = false;
                                } else {
                                    phi_913_ = bool();
                                    phi_914_ = true;
                                }
                                let _e243 = phi_913_;
                                let _e245 = phi_914_;
                                phi_915_ = _e243;
                                phi_916_ = _e245;
                            } else {
                                phi_915_ = bool();
                                phi_916_ = true;
                            }
                            let _e247 = phi_915_;
                            let _e249 = phi_916_;
                            phi_917_ = _e247;
                            phi_918_ = _e249;
                        } else {
                            phi_917_ = bool();
                            phi_918_ = true;
                        }
                        let _e251 = phi_917_;
                        let _e253 = phi_918_;
                        phi_919_ = _e251;
                        phi_920_ = _e253;
                    } else {
                        phi_919_ = bool();
                        phi_920_ = true;
                    }
                    let _e255 = phi_919_;
                    let _e257 = phi_920_;
                    phi_921_ = _e255;
                    phi_922_ = _e257;
                } else {
                    phi_921_ = bool();
                    phi_922_ = true;
                }
                let _e259 = phi_921_;
                let _e261 = phi_922_;
                phi_923_ = _e259;
                phi_924_ = _e261;
            } else {
                phi_923_ = bool();
                phi_924_ = true;
            }
            let _e263 = phi_923_;
            let _e265 = phi_924_;
            if _e265 {
                phi_928_ = false;
            } else {
                phi_928_ = _e263;
            }
            let _e267 = phi_928_;
            if _e267 {
                let _e269 = p.member.map_size;
                let _e270 = f32(_e269);
                let _e273 = ((_e207 * _e270) - 0.5f);
                let _e274 = ((_e221 * _e270) - 0.5f);
                let _e275 = floor(_e273);
                let _e276 = floor(_e274);
                let _e277 = (_e273 - _e275);
                let _e278 = (_e274 - _e276);
                let _e299 = ((1f - _e277) * (1f - _e278));
                let _e301 = (_e277 * (1f - _e278));
                let _e303 = ((1f - _e277) * _e278);
                let _e304 = (_e277 * _e278);
                let _e306 = p.member.test;
                let _e307 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e306);
                let _e309 = p.member.map_size;
                local_1 = lt_math_Evsm(_e307.positive_exponent, _e307.negative_exponent, _e307.min_variance);
                let _e314 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e275), i32(-2147483648), (_e275 < bitcast<f32>(3472883712u))), 2147483647i, (_e275 > bitcast<f32>(1325400063u))), (_e275 == _e275)), select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < bitcast<f32>(3472883712u))), 2147483647i, (_e276 > bitcast<f32>(1325400063u))), (_e276 == _e276)), _e309);
                if (_e314[0] < _e54) {
                } else {
                    return;
                }
                let _e319 = map.member[(0u + _e314[0])];
                if (_e314[1] < _e54) {
                } else {
                    return;
                }
                let _e332 = map.member[(0u + _e314[1])];
                if (_e314[2] < _e54) {
                } else {
                    return;
                }
                let _e349 = map.member[(0u + _e314[2])];
                if (_e314[3] < _e54) {
                } else {
                    return;
                }
                let _e366 = map.member[(0u + _e314[3])];
                let _e380 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e319.x * _e299) + (_e332.x * _e301)) + (_e349.x * _e303)) + (_e366.x * _e304)), ((((_e319.y * _e299) + (_e332.y * _e301)) + (_e349.y * _e303)) + (_e366.y * _e304)), ((((_e319.z * _e299) + (_e332.z * _e301)) + (_e349.z * _e303)) + (_e366.z * _e304)), ((((_e319.w * _e299) + (_e332.w * _e301)) + (_e349.w * _e303)) + (_e366.w * _e304))), _e234);
                let _e382 = p.member.epsilon;
                if (_e380 <= _e382) {
                    phi_1077_ = true;
                } else {
                    phi_1077_ = (_e380 >= (1f - _e382));
                }
                let _e387 = phi_1077_;
                if ((bitcast<u32>(_e380) & 2147483647u) > 2139095040u) {
                    phi_1085_ = true;
                } else {
                    phi_1085_ = !(_e387);
                }
                let _e393 = phi_1085_;
                if (_e380 > 0.5f) {
                    phi_1090_ = 1f;
                } else {
                    phi_1090_ = 0f;
                }
                let _e396 = phi_1090_;
                phi_1093_ = evaluate_Verdict(_e396, _e393);
            } else {
                phi_1093_ = evaluate_Verdict(1f, true);
            }
            let _e400 = phi_1093_;
            phi_1094_ = _e400;
        }
        let _e402 = phi_1094_;
        visibility.member[_e64.first_primitive] = _e402.visibility;
        phi_1098_ = _e402.is_doubted;
        phi_1099_ = _e64.first_primitive;
    } else {
        phi_1098_ = false;
        phi_1099_ = 0u;
    }
    let _e407 = phi_1098_;
    let _e409 = phi_1099_;
    if _e407 {
        let _e411 = atomicAdd((&shared_[0u]), 1u);
        phi_1105_ = _e411;
    } else {
        phi_1105_ = 0u;
    }
    let _e413 = phi_1105_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e417 = atomicLoad((&shared_[0u]));
        let _e418 = atomicAdd((&list.member[3u]), _e417);
        atomicStore((&shared_[1u]), _e418);
    }
    workgroupBarrier();
    if _e407 {
        let _e421 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e421) + _e413)]), _e409);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
