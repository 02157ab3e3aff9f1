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

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_30 {
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
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

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

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_180_: bool;
    var phi_184_: f32;
    var phi_185_: f32;

    let _e48 = (*param_4).positive_exponent;
    if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
        phi_185_ = _e48;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_180_ = true;
        } else {
            let _e55 = (42f < _e48);
            if _e55 {
            }
            phi_180_ = _e55;
        }
        let _e57 = phi_180_;
        if _e57 {
            phi_184_ = 42f;
        } else {
            phi_184_ = _e48;
        }
        let _e59 = phi_184_;
        phi_185_ = _e59;
    }
    let _e61 = phi_185_;
    return _e61;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_206_: bool;
    var phi_210_: f32;
    var phi_211_: f32;

    let _e48 = (*param_5).negative_exponent;
    if ((bitcast<u32>(_e48) & 2147483647u) > 2139095040u) {
        phi_211_ = _e48;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_206_ = true;
        } else {
            let _e55 = (42f < _e48);
            if _e55 {
            }
            phi_206_ = _e55;
        }
        let _e57 = phi_206_;
        if _e57 {
            phi_210_ = 42f;
        } else {
            phi_210_ = _e48;
        }
        let _e59 = phi_210_;
        phi_211_ = _e59;
    }
    let _e61 = phi_211_;
    return _e61;
}

fn lt_math_evsm_warp(param_6: vec4<f32>, param_7: f32) -> vec4<f32> {
    var phi_984_: f32;
    var phi_989_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1017_: bool;
    var phi_1018_: f32;
    var phi_1019_: bool;
    var phi_1023_: f32;
    var phi_1061_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1101_: f32;
    var phi_1106_: f32;
    var phi_1107_: bool;
    var phi_1108_: f32;
    var phi_1109_: bool;
    var phi_1113_: f32;
    var phi_1151_: f32;
    var phi_1164_: f32;
    var phi_1169_: f32;
    var phi_1191_: f32;
    var phi_1196_: f32;
    var phi_1197_: bool;
    var phi_1198_: f32;
    var phi_1199_: bool;
    var phi_1203_: f32;
    var phi_1241_: f32;
    var phi_1254_: f32;
    var phi_1259_: f32;
    var phi_1281_: f32;
    var phi_1286_: f32;
    var phi_1287_: bool;
    var phi_1288_: f32;
    var phi_1289_: bool;
    var phi_1293_: f32;
    var phi_1331_: f32;

    let _e49 = (param_7 * param_6.x);
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_1061_ = _e49;
    } else {
        if (_e49 < -87f) {
            phi_984_ = -87f;
        } else {
            phi_984_ = _e49;
        }
        let _e55 = phi_984_;
        if (_e55 > 88f) {
            phi_989_ = 88f;
        } else {
            phi_989_ = _e55;
        }
        let _e58 = phi_989_;
        let _e60 = ((_e58 * 1.442695f) + 0.5f);
        if (_e60 > -8388608f) {
            let _e72 = f32(select(0i, select(select(i32(_e60), i32(-2147483648), (_e60 < bitcast<f32>(3472883712u))), 2147483647i, (_e60 > bitcast<f32>(1325400063u))), (_e60 == _e60)));
            if (_e72 > _e60) {
                phi_1011_ = 1f;
            } else {
                phi_1011_ = 0f;
            }
            let _e75 = phi_1011_;
            if (_e60 < 8388608f) {
                phi_1016_ = (_e72 - _e75);
                phi_1017_ = false;
            } else {
                phi_1016_ = f32();
                phi_1017_ = true;
            }
            let _e78 = phi_1016_;
            let _e80 = phi_1017_;
            phi_1018_ = _e78;
            phi_1019_ = _e80;
        } else {
            phi_1018_ = f32();
            phi_1019_ = true;
        }
        let _e82 = phi_1018_;
        let _e84 = phi_1019_;
        if _e84 {
            phi_1023_ = _e60;
        } else {
            phi_1023_ = _e82;
        }
        let _e86 = phi_1023_;
        let _e90 = ((_e58 - (_e86 * 0.69314575f)) - (_e86 * 0.0000014286068f));
        phi_1061_ = ((((((((((((((((1f / 5040f) * _e90) + (1f / 720f)) * _e90) + (1f / 120f)) * _e90) + (1f / 24f)) * _e90) + (1f / 6f)) * _e90) + 0.5f) * _e90) + 1f) * _e90) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e86), i32(-2147483648), (_e86 < bitcast<f32>(3472883712u))), 2147483647i, (_e86 > bitcast<f32>(1325400063u))), (_e86 == _e86)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e126 = phi_1061_;
    let _e128 = (param_7 * param_6.y);
    if ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u) {
        phi_1151_ = _e128;
    } else {
        if (_e128 < -87f) {
            phi_1074_ = -87f;
        } else {
            phi_1074_ = _e128;
        }
        let _e134 = phi_1074_;
        if (_e134 > 88f) {
            phi_1079_ = 88f;
        } else {
            phi_1079_ = _e134;
        }
        let _e137 = phi_1079_;
        let _e139 = ((_e137 * 1.442695f) + 0.5f);
        if (_e139 > -8388608f) {
            let _e151 = f32(select(0i, select(select(i32(_e139), i32(-2147483648), (_e139 < bitcast<f32>(3472883712u))), 2147483647i, (_e139 > bitcast<f32>(1325400063u))), (_e139 == _e139)));
            if (_e151 > _e139) {
                phi_1101_ = 1f;
            } else {
                phi_1101_ = 0f;
            }
            let _e154 = phi_1101_;
            if (_e139 < 8388608f) {
                phi_1106_ = (_e151 - _e154);
                phi_1107_ = false;
            } else {
                phi_1106_ = f32();
                phi_1107_ = true;
            }
            let _e157 = phi_1106_;
            let _e159 = phi_1107_;
            phi_1108_ = _e157;
            phi_1109_ = _e159;
        } else {
            phi_1108_ = f32();
            phi_1109_ = true;
        }
        let _e161 = phi_1108_;
        let _e163 = phi_1109_;
        if _e163 {
            phi_1113_ = _e139;
        } else {
            phi_1113_ = _e161;
        }
        let _e165 = phi_1113_;
        let _e169 = ((_e137 - (_e165 * 0.69314575f)) - (_e165 * 0.0000014286068f));
        phi_1151_ = ((((((((((((((((1f / 5040f) * _e169) + (1f / 720f)) * _e169) + (1f / 120f)) * _e169) + (1f / 24f)) * _e169) + (1f / 6f)) * _e169) + 0.5f) * _e169) + 1f) * _e169) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e165), i32(-2147483648), (_e165 < bitcast<f32>(3472883712u))), 2147483647i, (_e165 > bitcast<f32>(1325400063u))), (_e165 == _e165)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e205 = phi_1151_;
    let _e207 = (param_7 * param_6.z);
    if ((bitcast<u32>(_e207) & 2147483647u) > 2139095040u) {
        phi_1241_ = _e207;
    } else {
        if (_e207 < -87f) {
            phi_1164_ = -87f;
        } else {
            phi_1164_ = _e207;
        }
        let _e213 = phi_1164_;
        if (_e213 > 88f) {
            phi_1169_ = 88f;
        } else {
            phi_1169_ = _e213;
        }
        let _e216 = phi_1169_;
        let _e218 = ((_e216 * 1.442695f) + 0.5f);
        if (_e218 > -8388608f) {
            let _e230 = f32(select(0i, select(select(i32(_e218), i32(-2147483648), (_e218 < bitcast<f32>(3472883712u))), 2147483647i, (_e218 > bitcast<f32>(1325400063u))), (_e218 == _e218)));
            if (_e230 > _e218) {
                phi_1191_ = 1f;
            } else {
                phi_1191_ = 0f;
            }
            let _e233 = phi_1191_;
            if (_e218 < 8388608f) {
                phi_1196_ = (_e230 - _e233);
                phi_1197_ = false;
            } else {
                phi_1196_ = f32();
                phi_1197_ = true;
            }
            let _e236 = phi_1196_;
            let _e238 = phi_1197_;
            phi_1198_ = _e236;
            phi_1199_ = _e238;
        } else {
            phi_1198_ = f32();
            phi_1199_ = true;
        }
        let _e240 = phi_1198_;
        let _e242 = phi_1199_;
        if _e242 {
            phi_1203_ = _e218;
        } else {
            phi_1203_ = _e240;
        }
        let _e244 = phi_1203_;
        let _e248 = ((_e216 - (_e244 * 0.69314575f)) - (_e244 * 0.0000014286068f));
        phi_1241_ = ((((((((((((((((1f / 5040f) * _e248) + (1f / 720f)) * _e248) + (1f / 120f)) * _e248) + (1f / 24f)) * _e248) + (1f / 6f)) * _e248) + 0.5f) * _e248) + 1f) * _e248) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e244), i32(-2147483648), (_e244 < bitcast<f32>(3472883712u))), 2147483647i, (_e244 > bitcast<f32>(1325400063u))), (_e244 == _e244)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e284 = phi_1241_;
    let _e286 = (param_7 * param_6.w);
    if ((bitcast<u32>(_e286) & 2147483647u) > 2139095040u) {
        phi_1331_ = _e286;
    } else {
        if (_e286 < -87f) {
            phi_1254_ = -87f;
        } else {
            phi_1254_ = _e286;
        }
        let _e292 = phi_1254_;
        if (_e292 > 88f) {
            phi_1259_ = 88f;
        } else {
            phi_1259_ = _e292;
        }
        let _e295 = phi_1259_;
        let _e297 = ((_e295 * 1.442695f) + 0.5f);
        if (_e297 > -8388608f) {
            let _e309 = f32(select(0i, select(select(i32(_e297), i32(-2147483648), (_e297 < bitcast<f32>(3472883712u))), 2147483647i, (_e297 > bitcast<f32>(1325400063u))), (_e297 == _e297)));
            if (_e309 > _e297) {
                phi_1281_ = 1f;
            } else {
                phi_1281_ = 0f;
            }
            let _e312 = phi_1281_;
            if (_e297 < 8388608f) {
                phi_1286_ = (_e309 - _e312);
                phi_1287_ = false;
            } else {
                phi_1286_ = f32();
                phi_1287_ = true;
            }
            let _e315 = phi_1286_;
            let _e317 = phi_1287_;
            phi_1288_ = _e315;
            phi_1289_ = _e317;
        } else {
            phi_1288_ = f32();
            phi_1289_ = true;
        }
        let _e319 = phi_1288_;
        let _e321 = phi_1289_;
        if _e321 {
            phi_1293_ = _e297;
        } else {
            phi_1293_ = _e319;
        }
        let _e323 = phi_1293_;
        let _e327 = ((_e295 - (_e323 * 0.69314575f)) - (_e323 * 0.0000014286068f));
        phi_1331_ = ((((((((((((((((1f / 5040f) * _e327) + (1f / 720f)) * _e327) + (1f / 120f)) * _e327) + (1f / 24f)) * _e327) + (1f / 6f)) * _e327) + 0.5f) * _e327) + 1f) * _e327) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e323), i32(-2147483648), (_e323 < bitcast<f32>(3472883712u))), 2147483647i, (_e323 > bitcast<f32>(1325400063u))), (_e323 == _e323)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e363 = phi_1331_;
    return vec4<f32>(_e126, _e205, _e284, _e363);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_708_: f32;
    var phi_709_: f32;
    var phi_710_: f32;
    var phi_727_: f32;
    var phi_728_: f32;
    var phi_729_: f32;
    var phi_746_: f32;
    var phi_747_: f32;
    var phi_748_: f32;
    var phi_815_: bool;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_832_: bool;
    var phi_839_: f32;
    var phi_905_: bool;
    var phi_909_: f32;
    var phi_910_: f32;
    var phi_922_: bool;
    var phi_929_: f32;
    var phi_946_: bool;
    var phi_950_: f32;
    var phi_951_: f32;
    var phi_966_: f32;
    var phi_967_: f32;
    var phi_968_: f32;

    if ((bitcast<u32>(param_11) & 2147483647u) > 2139095040u) {
        phi_673_ = param_11;
    } else {
        if (param_11 < 0f) {
            phi_672_ = 0f;
        } else {
            if (param_11 > 1f) {
                phi_671_ = 1f;
            } else {
                phi_671_ = param_11;
            }
            let _e56 = phi_671_;
            phi_672_ = _e56;
        }
        let _e58 = phi_672_;
        phi_673_ = _e58;
    }
    let _e60 = phi_673_;
    if ((bitcast<u32>(param_9.x) & 2147483647u) > 2139095040u) {
        phi_691_ = param_9.x;
    } else {
        if (param_9.x < 0f) {
            phi_690_ = 0f;
        } else {
            if (param_9.x > 1f) {
                phi_689_ = 1f;
            } else {
                phi_689_ = param_9.x;
            }
            let _e68 = phi_689_;
            phi_690_ = _e68;
        }
        let _e70 = phi_690_;
        phi_691_ = _e70;
    }
    let _e72 = phi_691_;
    if ((bitcast<u32>(param_9.y) & 2147483647u) > 2139095040u) {
        phi_710_ = param_9.y;
    } else {
        if (param_9.y < 0f) {
            phi_709_ = 0f;
        } else {
            if (param_9.y > 1f) {
                phi_708_ = 1f;
            } else {
                phi_708_ = param_9.y;
            }
            let _e81 = phi_708_;
            phi_709_ = _e81;
        }
        let _e83 = phi_709_;
        phi_710_ = _e83;
    }
    let _e85 = phi_710_;
    if ((bitcast<u32>(param_9.z) & 2147483647u) > 2139095040u) {
        phi_729_ = param_9.z;
    } else {
        if (param_9.z < 0f) {
            phi_728_ = 0f;
        } else {
            if (param_9.z > 1f) {
                phi_727_ = 1f;
            } else {
                phi_727_ = param_9.z;
            }
            let _e94 = phi_727_;
            phi_728_ = _e94;
        }
        let _e96 = phi_728_;
        phi_729_ = _e96;
    }
    let _e98 = phi_729_;
    if ((bitcast<u32>(param_9.w) & 2147483647u) > 2139095040u) {
        phi_748_ = param_9.w;
    } else {
        if (param_9.w < 0f) {
            phi_747_ = 0f;
        } else {
            if (param_9.w > 1f) {
                phi_746_ = 1f;
            } else {
                phi_746_ = param_9.w;
            }
            let _e107 = phi_746_;
            phi_747_ = _e107;
        }
        let _e109 = phi_747_;
        phi_748_ = _e109;
    }
    let _e111 = phi_748_;
    let _e113 = vec4<f32>((_e72 - _e60), (_e85 - _e60), (_e98 - _e60), (_e111 - _e60));
    let _e114 = _lt_math_evsm_Evsm_positive(param_8);
    let _e115 = lt_math_evsm_warp(_e113, _e114);
    let _e118 = (_e115.x - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e121 = (_e115.y - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e124 = (_e115.z - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e127 = (_e115.w - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e129 = (*param_8).min_variance;
    let _e131 = ((_e129 * _e114) * _e114);
    let _e142 = ((((_e118 * param_10.x) + (_e121 * param_10.y)) + (_e124 * param_10.z)) + (_e127 * param_10.w));
    let _e143 = (_e118 - _e142);
    let _e144 = (_e121 - _e142);
    let _e145 = (_e124 - _e142);
    let _e146 = (_e127 - _e142);
    let _e161 = (((((_e143 * _e143) * param_10.x) + ((_e144 * _e144) * param_10.y)) + ((_e145 * _e145) * param_10.z)) + ((_e146 * _e146) * param_10.w));
    if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
        phi_820_ = _e161;
    } else {
        if ((bitcast<u32>(_e131) & 2147483647u) > 2139095040u) {
            phi_815_ = true;
        } else {
            let _e168 = (_e131 > _e161);
            if _e168 {
            }
            phi_815_ = _e168;
        }
        let _e170 = phi_815_;
        if _e170 {
            phi_819_ = _e131;
        } else {
            phi_819_ = _e161;
        }
        let _e172 = phi_819_;
        phi_820_ = _e172;
    }
    let _e174 = phi_820_;
    let _e175 = -(_e142);
    if (_e175 <= 0f) {
        let _e179 = ((bitcast<u32>(_e174) & 2147483647u) > 2139095040u);
        if _e179 {
        }
        phi_832_ = _e179;
    } else {
        phi_832_ = true;
    }
    let _e181 = phi_832_;
    if _e181 {
        phi_839_ = (_e174 / (_e174 + (_e175 * _e175)));
    } else {
        phi_839_ = 1f;
    }
    let _e186 = phi_839_;
    let _e187 = _lt_math_evsm_Evsm_negative(param_8);
    let _e189 = lt_math_evsm_warp(_e113, -(_e187));
    let _e192 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e189.x);
    let _e195 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e189.y);
    let _e198 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e189.z);
    let _e201 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e189.w);
    let _e203 = (*param_8).min_variance;
    let _e205 = ((_e203 * _e187) * _e187);
    let _e216 = ((((_e192 * param_10.x) + (_e195 * param_10.y)) + (_e198 * param_10.z)) + (_e201 * param_10.w));
    let _e217 = (_e192 - _e216);
    let _e218 = (_e195 - _e216);
    let _e219 = (_e198 - _e216);
    let _e220 = (_e201 - _e216);
    let _e235 = (((((_e217 * _e217) * param_10.x) + ((_e218 * _e218) * param_10.y)) + ((_e219 * _e219) * param_10.z)) + ((_e220 * _e220) * param_10.w));
    if ((bitcast<u32>(_e235) & 2147483647u) > 2139095040u) {
        phi_910_ = _e235;
    } else {
        if ((bitcast<u32>(_e205) & 2147483647u) > 2139095040u) {
            phi_905_ = true;
        } else {
            let _e242 = (_e205 > _e235);
            if _e242 {
            }
            phi_905_ = _e242;
        }
        let _e244 = phi_905_;
        if _e244 {
            phi_909_ = _e205;
        } else {
            phi_909_ = _e235;
        }
        let _e246 = phi_909_;
        phi_910_ = _e246;
    }
    let _e248 = phi_910_;
    let _e249 = -(_e216);
    if (_e249 <= 0f) {
        let _e253 = ((bitcast<u32>(_e248) & 2147483647u) > 2139095040u);
        if _e253 {
        }
        phi_922_ = _e253;
    } else {
        phi_922_ = true;
    }
    let _e255 = phi_922_;
    if _e255 {
        phi_929_ = (_e248 / (_e248 + (_e249 * _e249)));
    } else {
        phi_929_ = 1f;
    }
    let _e260 = phi_929_;
    if ((bitcast<u32>(_e186) & 2147483647u) > 2139095040u) {
        phi_951_ = _e186;
    } else {
        if ((bitcast<u32>(_e260) & 2147483647u) > 2139095040u) {
            phi_946_ = true;
        } else {
            let _e267 = (_e260 < _e186);
            if _e267 {
            }
            phi_946_ = _e267;
        }
        let _e269 = phi_946_;
        if _e269 {
            phi_950_ = _e260;
        } else {
            phi_950_ = _e186;
        }
        let _e271 = phi_950_;
        phi_951_ = _e271;
    }
    let _e273 = phi_951_;
    if ((bitcast<u32>(_e273) & 2147483647u) > 2139095040u) {
        phi_968_ = _e273;
    } else {
        if (_e273 < 0f) {
            phi_967_ = 0f;
        } else {
            if (_e273 > 1f) {
                phi_966_ = 1f;
            } else {
                phi_966_ = _e273;
            }
            let _e280 = phi_966_;
            phi_967_ = _e280;
        }
        let _e282 = phi_967_;
        phi_968_ = _e282;
    }
    let _e284 = phi_968_;
    return _e284;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_265_: bool;
    var phi_266_: bool;
    var phi_267_: bool;
    var phi_268_: bool;
    var phi_272_: bool;
    var phi_316_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_320_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_397_: bool;
    var phi_406_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_425_: bool;
    var phi_461_: f32;
    var phi_466_: f32;
    var phi_467_: bool;
    var phi_468_: f32;
    var phi_469_: bool;
    var phi_473_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_499_: bool;
    var phi_500_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_555_: i32;
    var phi_560_: i32;
    var phi_565_: i32;
    var phi_570_: i32;
    var phi_579_: i32;
    var phi_584_: i32;
    var phi_589_: i32;
    var phi_594_: i32;
    var phi_635_: evaluate_Verdict;
    var phi_636_: evaluate_Verdict;
    var phi_637_: bool;
    var phi_638_: evaluate_Verdict;
    var phi_639_: evaluate_Verdict;
    var phi_640_: bool;
    var phi_644_: evaluate_Verdict;

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
                phi_265_ = (_e85 == _e87);
                phi_266_ = false;
            } else {
                phi_265_ = bool();
                phi_266_ = true;
            }
            let _e90 = phi_265_;
            let _e92 = phi_266_;
            phi_267_ = _e90;
            phi_268_ = _e92;
        } else {
            phi_267_ = bool();
            phi_268_ = true;
        }
        let _e94 = phi_267_;
        let _e96 = phi_268_;
        if _e96 {
            phi_272_ = false;
        } else {
            phi_272_ = _e94;
        }
        let _e98 = phi_272_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e63.first_primitive)].normal;
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[(0u + _e63.first_primitive)].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_316_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_316_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_316_;
            phi_320_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_320_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_320_;
        if _e178.unnamed_1 {
            phi_638_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
            phi_639_ = evaluate_Verdict();
            phi_640_ = true;
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
                    phi_397_ = (_e217 <= 1f);
                } else {
                    phi_397_ = false;
                }
                let _e249 = phi_397_;
                if _e249 {
                    if (_e231 >= 0f) {
                        phi_406_ = (_e231 <= 1f);
                    } else {
                        phi_406_ = false;
                    }
                    let _e253 = phi_406_;
                    if _e253 {
                        if (_e244 >= 0f) {
                            phi_415_ = (_e244 <= 1f);
                        } else {
                            phi_415_ = false;
                        }
                        let _e257 = phi_415_;
                        phi_416_ = _e257;
                        phi_417_ = false;
                    } else {
                        phi_416_ = bool();
                        phi_417_ = true;
                    }
                    let _e259 = phi_416_;
                    let _e261 = phi_417_;
                    phi_418_ = _e259;
                    phi_419_ = _e261;
                } else {
                    phi_418_ = bool();
                    phi_419_ = true;
                }
                let _e263 = phi_418_;
                let _e265 = phi_419_;
                phi_420_ = _e263;
                phi_421_ = _e265;
            } else {
                phi_420_ = bool();
                phi_421_ = true;
            }
            let _e267 = phi_420_;
            let _e269 = phi_421_;
            if _e269 {
                phi_425_ = false;
            } else {
                phi_425_ = _e267;
            }
            let _e271 = phi_425_;
            if _e271 {
                let _e273 = p.member.map_size;
                let _e274 = f32(_e273);
                let _e277 = ((_e217 * _e274) - 0.5f);
                let _e278 = ((_e231 * _e274) - 0.5f);
                if (_e277 > -8388608f) {
                    let _e290 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e290 > _e277) {
                        phi_461_ = 1f;
                    } else {
                        phi_461_ = 0f;
                    }
                    let _e293 = phi_461_;
                    if (_e277 < 8388608f) {
                        phi_466_ = (_e290 - _e293);
                        phi_467_ = false;
                    } else {
                        phi_466_ = f32();
                        phi_467_ = true;
                    }
                    let _e296 = phi_466_;
                    let _e298 = phi_467_;
                    phi_468_ = _e296;
                    phi_469_ = _e298;
                } else {
                    phi_468_ = f32();
                    phi_469_ = true;
                }
                let _e300 = phi_468_;
                let _e302 = phi_469_;
                if _e302 {
                    phi_473_ = _e277;
                } else {
                    phi_473_ = _e300;
                }
                let _e304 = phi_473_;
                if (_e278 > -8388608f) {
                    let _e316 = f32(select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < bitcast<f32>(3472883712u))), 2147483647i, (_e278 > bitcast<f32>(1325400063u))), (_e278 == _e278)));
                    if (_e316 > _e278) {
                        phi_493_ = 1f;
                    } else {
                        phi_493_ = 0f;
                    }
                    let _e319 = phi_493_;
                    if (_e278 < 8388608f) {
                        phi_498_ = (_e316 - _e319);
                        phi_499_ = false;
                    } else {
                        phi_498_ = f32();
                        phi_499_ = true;
                    }
                    let _e322 = phi_498_;
                    let _e324 = phi_499_;
                    phi_500_ = _e322;
                    phi_501_ = _e324;
                } else {
                    phi_500_ = f32();
                    phi_501_ = true;
                }
                let _e326 = phi_500_;
                let _e328 = phi_501_;
                if _e328 {
                    phi_505_ = _e278;
                } else {
                    phi_505_ = _e326;
                }
                let _e330 = phi_505_;
                let _e331 = (_e277 - _e304);
                let _e332 = (_e278 - _e330);
                let _e341 = select(0i, select(select(i32(_e304), i32(-2147483648), (_e304 < bitcast<f32>(3472883712u))), 2147483647i, (_e304 > bitcast<f32>(1325400063u))), (_e304 == _e304));
                let _e350 = select(0i, select(select(i32(_e330), i32(-2147483648), (_e330 < bitcast<f32>(3472883712u))), 2147483647i, (_e330 > bitcast<f32>(1325400063u))), (_e330 == _e330));
                let _e361 = p.member.test;
                let _e362 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e361);
                let _e364 = p.member.map_size;
                local = lt_math_Evsm(_e362.positive_exponent, _e362.negative_exponent, _e362.min_variance);
                let _e370 = (bitcast<i32>(_e364) - 1i);
                if (_e341 > 0i) {
                    phi_555_ = _e341;
                } else {
                    phi_555_ = 0i;
                }
                let _e373 = phi_555_;
                if (_e350 > 0i) {
                    phi_560_ = _e350;
                } else {
                    phi_560_ = 0i;
                }
                let _e376 = phi_560_;
                if (_e373 < _e370) {
                    phi_565_ = _e373;
                } else {
                    phi_565_ = _e370;
                }
                let _e379 = phi_565_;
                if (_e376 < _e370) {
                    phi_570_ = _e376;
                } else {
                    phi_570_ = _e370;
                }
                let _e382 = phi_570_;
                let _e383 = bitcast<u32>(_e379);
                let _e385 = (_e341 + 1i);
                let _e386 = (_e350 + 1i);
                if (_e385 > 0i) {
                    phi_579_ = _e385;
                } else {
                    phi_579_ = 0i;
                }
                let _e389 = phi_579_;
                if (_e386 > 0i) {
                    phi_584_ = _e386;
                } else {
                    phi_584_ = 0i;
                }
                let _e392 = phi_584_;
                if (_e389 < _e370) {
                    phi_589_ = _e389;
                } else {
                    phi_589_ = _e370;
                }
                let _e395 = phi_589_;
                if (_e392 < _e370) {
                    phi_594_ = _e392;
                } else {
                    phi_594_ = _e370;
                }
                let _e398 = phi_594_;
                let _e399 = bitcast<u32>(_e395);
                let _e401 = (bitcast<u32>(_e382) * _e364);
                let _e402 = (bitcast<u32>(_e398) * _e364);
                let _e403 = (_e401 + _e383);
                let _e404 = (_e401 + _e399);
                let _e405 = (_e402 + _e383);
                let _e406 = (_e402 + _e399);
                if (_e403 < _e54) {
                } else {
                    return;
                }
                let _e410 = map.member[(0u + _e403)];
                if (_e404 < _e54) {
                } else {
                    return;
                }
                let _e414 = map.member[(0u + _e404)];
                if (_e405 < _e54) {
                } else {
                    return;
                }
                let _e418 = map.member[(0u + _e405)];
                if (_e406 < _e54) {
                } else {
                    return;
                }
                let _e422 = map.member[(0u + _e406)];
                let _e424 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e410, _e414, _e418, _e422), vec4<f32>(((1f - _e331) * (1f - _e332)), (_e331 * (1f - _e332)), ((1f - _e331) * _e332), (_e331 * _e332)), _e244);
                phi_635_ = evaluate_Verdict(_e424, false);
                phi_636_ = evaluate_Verdict();
                phi_637_ = false;
            } else {
                phi_635_ = evaluate_Verdict();
                phi_636_ = evaluate_Verdict(1f, false);
                phi_637_ = true;
            }
            let _e428 = phi_635_;
            let _e430 = phi_636_;
            let _e432 = phi_637_;
            phi_638_ = _e430;
            phi_639_ = _e428;
            phi_640_ = _e432;
        }
        let _e434 = phi_638_;
        let _e436 = phi_639_;
        let _e438 = phi_640_;
        if _e438 {
            phi_644_ = _e434;
        } else {
            phi_644_ = _e436;
        }
        let _e440 = phi_644_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e440.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
