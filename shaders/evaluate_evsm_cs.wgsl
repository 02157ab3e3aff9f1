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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_31 {
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
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_154_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_146_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_147_ = false;
        } else {
            phi_146_ = lt_bvh_traverse_Tree();
            phi_147_ = true;
        }
        let _e56 = phi_146_;
        let _e58 = phi_147_;
        phi_148_ = _e56;
        phi_149_ = _e58;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e60 = phi_148_;
    let _e62 = phi_149_;
    if _e62 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e60;
    }
    let _e67 = phi_154_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_184_: bool;
    var phi_188_: f32;
    var phi_189_: f32;

    let _e45 = (*param_4).positive_exponent;
    if ((bitcast<u32>(_e45) & 2147483647u) > 2139095040u) {
        phi_189_ = _e45;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_184_ = true;
        } else {
            let _e52 = (42f < _e45);
            if _e52 {
            }
            phi_184_ = _e52;
        }
        let _e54 = phi_184_;
        if _e54 {
            phi_188_ = 42f;
        } else {
            phi_188_ = _e45;
        }
        let _e56 = phi_188_;
        phi_189_ = _e56;
    }
    let _e58 = phi_189_;
    return _e58;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_210_: bool;
    var phi_214_: f32;
    var phi_215_: f32;

    let _e45 = (*param_5).negative_exponent;
    if ((bitcast<u32>(_e45) & 2147483647u) > 2139095040u) {
        phi_215_ = _e45;
    } else {
        if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
            phi_210_ = true;
        } else {
            let _e52 = (42f < _e45);
            if _e52 {
            }
            phi_210_ = _e52;
        }
        let _e54 = phi_210_;
        if _e54 {
            phi_214_ = 42f;
        } else {
            phi_214_ = _e45;
        }
        let _e56 = phi_214_;
        phi_215_ = _e56;
    }
    let _e58 = phi_215_;
    return _e58;
}

fn lt_shaders_evaluate_to_light(param_6: vec3<f32>, param_7: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_7.x - (param_6.x * param_7.w)), (param_7.y - (param_6.y * param_7.w)), (param_7.z - (param_6.z * param_7.w)));
}

fn lt_shaders_evaluate_quad_indices(param_8: i32, param_9: i32, param_10: u32) -> array<u32, 4> {
    var phi_243_: i32;
    var phi_248_: i32;
    var phi_253_: i32;
    var phi_258_: i32;
    var phi_267_: i32;
    var phi_272_: i32;
    var phi_277_: i32;
    var phi_282_: i32;

    let _e47 = (bitcast<i32>(param_10) - 1i);
    if (param_8 > 0i) {
        phi_243_ = param_8;
    } else {
        phi_243_ = 0i;
    }
    let _e50 = phi_243_;
    if (param_9 > 0i) {
        phi_248_ = param_9;
    } else {
        phi_248_ = 0i;
    }
    let _e53 = phi_248_;
    if (_e50 < _e47) {
        phi_253_ = _e50;
    } else {
        phi_253_ = _e47;
    }
    let _e56 = phi_253_;
    if (_e53 < _e47) {
        phi_258_ = _e53;
    } else {
        phi_258_ = _e47;
    }
    let _e59 = phi_258_;
    let _e60 = bitcast<u32>(_e56);
    let _e62 = (param_8 + 1i);
    let _e63 = (param_9 + 1i);
    if (_e62 > 0i) {
        phi_267_ = _e62;
    } else {
        phi_267_ = 0i;
    }
    let _e66 = phi_267_;
    if (_e63 > 0i) {
        phi_272_ = _e63;
    } else {
        phi_272_ = 0i;
    }
    let _e69 = phi_272_;
    if (_e66 < _e47) {
        phi_277_ = _e66;
    } else {
        phi_277_ = _e47;
    }
    let _e72 = phi_277_;
    if (_e69 < _e47) {
        phi_282_ = _e69;
    } else {
        phi_282_ = _e47;
    }
    let _e75 = phi_282_;
    let _e76 = bitcast<u32>(_e72);
    let _e78 = (bitcast<u32>(_e59) * param_10);
    let _e79 = (bitcast<u32>(_e75) * param_10);
    return array<u32, 4>((_e78 + _e60), (_e78 + _e76), (_e79 + _e60), (_e79 + _e76));
}

fn lt_math_evsm_warp(param_11: vec4<f32>, param_12: f32) -> vec4<f32> {
    var phi_959_: bool;
    var phi_963_: f32;
    var phi_964_: f32;
    var phi_981_: bool;
    var phi_985_: f32;
    var phi_986_: f32;
    var phi_1027_: f32;
    var phi_1052_: bool;
    var phi_1056_: f32;
    var phi_1057_: f32;
    var phi_1074_: bool;
    var phi_1078_: f32;
    var phi_1079_: f32;
    var phi_1120_: f32;
    var phi_1145_: bool;
    var phi_1149_: f32;
    var phi_1150_: f32;
    var phi_1167_: bool;
    var phi_1171_: f32;
    var phi_1172_: f32;
    var phi_1213_: f32;
    var phi_1238_: bool;
    var phi_1242_: f32;
    var phi_1243_: f32;
    var phi_1260_: bool;
    var phi_1264_: f32;
    var phi_1265_: f32;
    var phi_1306_: f32;

    let _e46 = (param_12 * param_11.x);
    if ((bitcast<u32>(_e46) & 2147483647u) > 2139095040u) {
        phi_1027_ = _e46;
    } else {
        if ((bitcast<u32>(_e46) & 2147483647u) > 2139095040u) {
            phi_964_ = _e46;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_959_ = true;
            } else {
                let _e56 = (-87f > _e46);
                if _e56 {
                }
                phi_959_ = _e56;
            }
            let _e58 = phi_959_;
            if _e58 {
                phi_963_ = -87f;
            } else {
                phi_963_ = _e46;
            }
            let _e60 = phi_963_;
            phi_964_ = _e60;
        }
        let _e62 = phi_964_;
        if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
            phi_986_ = _e62;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_981_ = true;
            } else {
                let _e69 = (88f < _e62);
                if _e69 {
                }
                phi_981_ = _e69;
            }
            let _e71 = phi_981_;
            if _e71 {
                phi_985_ = 88f;
            } else {
                phi_985_ = _e62;
            }
            let _e73 = phi_985_;
            phi_986_ = _e73;
        }
        let _e75 = phi_986_;
        let _e78 = floor(((_e75 * 1.442695f) + 0.5f));
        let _e82 = ((_e75 - (_e78 * 0.69314575f)) - (_e78 * 0.0000014286068f));
        phi_1027_ = ((((((((((((((((1f / 5040f) * _e82) + (1f / 720f)) * _e82) + (1f / 120f)) * _e82) + (1f / 24f)) * _e82) + (1f / 6f)) * _e82) + 0.5f) * _e82) + 1f) * _e82) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e118 = phi_1027_;
    let _e120 = (param_12 * param_11.y);
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_1120_ = _e120;
    } else {
        if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
            phi_1057_ = _e120;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_1052_ = true;
            } else {
                let _e130 = (-87f > _e120);
                if _e130 {
                }
                phi_1052_ = _e130;
            }
            let _e132 = phi_1052_;
            if _e132 {
                phi_1056_ = -87f;
            } else {
                phi_1056_ = _e120;
            }
            let _e134 = phi_1056_;
            phi_1057_ = _e134;
        }
        let _e136 = phi_1057_;
        if ((bitcast<u32>(_e136) & 2147483647u) > 2139095040u) {
            phi_1079_ = _e136;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_1074_ = true;
            } else {
                let _e143 = (88f < _e136);
                if _e143 {
                }
                phi_1074_ = _e143;
            }
            let _e145 = phi_1074_;
            if _e145 {
                phi_1078_ = 88f;
            } else {
                phi_1078_ = _e136;
            }
            let _e147 = phi_1078_;
            phi_1079_ = _e147;
        }
        let _e149 = phi_1079_;
        let _e152 = floor(((_e149 * 1.442695f) + 0.5f));
        let _e156 = ((_e149 - (_e152 * 0.69314575f)) - (_e152 * 0.0000014286068f));
        phi_1120_ = ((((((((((((((((1f / 5040f) * _e156) + (1f / 720f)) * _e156) + (1f / 120f)) * _e156) + (1f / 24f)) * _e156) + (1f / 6f)) * _e156) + 0.5f) * _e156) + 1f) * _e156) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e152), i32(-2147483648), (_e152 < bitcast<f32>(3472883712u))), 2147483647i, (_e152 > bitcast<f32>(1325400063u))), (_e152 == _e152)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e192 = phi_1120_;
    let _e194 = (param_12 * param_11.z);
    if ((bitcast<u32>(_e194) & 2147483647u) > 2139095040u) {
        phi_1213_ = _e194;
    } else {
        if ((bitcast<u32>(_e194) & 2147483647u) > 2139095040u) {
            phi_1150_ = _e194;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_1145_ = true;
            } else {
                let _e204 = (-87f > _e194);
                if _e204 {
                }
                phi_1145_ = _e204;
            }
            let _e206 = phi_1145_;
            if _e206 {
                phi_1149_ = -87f;
            } else {
                phi_1149_ = _e194;
            }
            let _e208 = phi_1149_;
            phi_1150_ = _e208;
        }
        let _e210 = phi_1150_;
        if ((bitcast<u32>(_e210) & 2147483647u) > 2139095040u) {
            phi_1172_ = _e210;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_1167_ = true;
            } else {
                let _e217 = (88f < _e210);
                if _e217 {
                }
                phi_1167_ = _e217;
            }
            let _e219 = phi_1167_;
            if _e219 {
                phi_1171_ = 88f;
            } else {
                phi_1171_ = _e210;
            }
            let _e221 = phi_1171_;
            phi_1172_ = _e221;
        }
        let _e223 = phi_1172_;
        let _e226 = floor(((_e223 * 1.442695f) + 0.5f));
        let _e230 = ((_e223 - (_e226 * 0.69314575f)) - (_e226 * 0.0000014286068f));
        phi_1213_ = ((((((((((((((((1f / 5040f) * _e230) + (1f / 720f)) * _e230) + (1f / 120f)) * _e230) + (1f / 24f)) * _e230) + (1f / 6f)) * _e230) + 0.5f) * _e230) + 1f) * _e230) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e226), i32(-2147483648), (_e226 < bitcast<f32>(3472883712u))), 2147483647i, (_e226 > bitcast<f32>(1325400063u))), (_e226 == _e226)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e266 = phi_1213_;
    let _e268 = (param_12 * param_11.w);
    if ((bitcast<u32>(_e268) & 2147483647u) > 2139095040u) {
        phi_1306_ = _e268;
    } else {
        if ((bitcast<u32>(_e268) & 2147483647u) > 2139095040u) {
            phi_1243_ = _e268;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_1238_ = true;
            } else {
                let _e278 = (-87f > _e268);
                if _e278 {
                }
                phi_1238_ = _e278;
            }
            let _e280 = phi_1238_;
            if _e280 {
                phi_1242_ = -87f;
            } else {
                phi_1242_ = _e268;
            }
            let _e282 = phi_1242_;
            phi_1243_ = _e282;
        }
        let _e284 = phi_1243_;
        if ((bitcast<u32>(_e284) & 2147483647u) > 2139095040u) {
            phi_1265_ = _e284;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_1260_ = true;
            } else {
                let _e291 = (88f < _e284);
                if _e291 {
                }
                phi_1260_ = _e291;
            }
            let _e293 = phi_1260_;
            if _e293 {
                phi_1264_ = 88f;
            } else {
                phi_1264_ = _e284;
            }
            let _e295 = phi_1264_;
            phi_1265_ = _e295;
        }
        let _e297 = phi_1265_;
        let _e300 = floor(((_e297 * 1.442695f) + 0.5f));
        let _e304 = ((_e297 - (_e300 * 0.69314575f)) - (_e300 * 0.0000014286068f));
        phi_1306_ = ((((((((((((((((1f / 5040f) * _e304) + (1f / 720f)) * _e304) + (1f / 120f)) * _e304) + (1f / 24f)) * _e304) + (1f / 6f)) * _e304) + 0.5f) * _e304) + 1f) * _e304) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e300), i32(-2147483648), (_e300 < bitcast<f32>(3472883712u))), 2147483647i, (_e300 > bitcast<f32>(1325400063u))), (_e300 == _e300)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e340 = phi_1306_;
    return vec4<f32>(_e118, _e192, _e266, _e340);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_13: ptr<function, lt_math_Evsm>, param_14: vec4<f32>, param_15: vec4<f32>, param_16: f32) -> f32 {
    var phi_634_: f32;
    var phi_635_: f32;
    var phi_636_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_654_: f32;
    var phi_671_: f32;
    var phi_672_: f32;
    var phi_673_: f32;
    var phi_690_: f32;
    var phi_691_: f32;
    var phi_692_: f32;
    var phi_709_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_778_: bool;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_795_: bool;
    var phi_802_: f32;
    var phi_868_: bool;
    var phi_872_: f32;
    var phi_873_: f32;
    var phi_885_: bool;
    var phi_892_: f32;
    var phi_909_: bool;
    var phi_913_: f32;
    var phi_914_: f32;
    var phi_929_: f32;
    var phi_930_: f32;
    var phi_931_: f32;

    if ((bitcast<u32>(param_16) & 2147483647u) > 2139095040u) {
        phi_636_ = param_16;
    } else {
        if (param_16 < 0f) {
            phi_635_ = 0f;
        } else {
            if (param_16 > 1f) {
                phi_634_ = 1f;
            } else {
                phi_634_ = param_16;
            }
            let _e53 = phi_634_;
            phi_635_ = _e53;
        }
        let _e55 = phi_635_;
        phi_636_ = _e55;
    }
    let _e57 = phi_636_;
    if ((bitcast<u32>(param_14.x) & 2147483647u) > 2139095040u) {
        phi_654_ = param_14.x;
    } else {
        if (param_14.x < 0f) {
            phi_653_ = 0f;
        } else {
            if (param_14.x > 1f) {
                phi_652_ = 1f;
            } else {
                phi_652_ = param_14.x;
            }
            let _e65 = phi_652_;
            phi_653_ = _e65;
        }
        let _e67 = phi_653_;
        phi_654_ = _e67;
    }
    let _e69 = phi_654_;
    if ((bitcast<u32>(param_14.y) & 2147483647u) > 2139095040u) {
        phi_673_ = param_14.y;
    } else {
        if (param_14.y < 0f) {
            phi_672_ = 0f;
        } else {
            if (param_14.y > 1f) {
                phi_671_ = 1f;
            } else {
                phi_671_ = param_14.y;
            }
            let _e78 = phi_671_;
            phi_672_ = _e78;
        }
        let _e80 = phi_672_;
        phi_673_ = _e80;
    }
    let _e82 = phi_673_;
    if ((bitcast<u32>(param_14.z) & 2147483647u) > 2139095040u) {
        phi_692_ = param_14.z;
    } else {
        if (param_14.z < 0f) {
            phi_691_ = 0f;
        } else {
            if (param_14.z > 1f) {
                phi_690_ = 1f;
            } else {
                phi_690_ = param_14.z;
            }
            let _e91 = phi_690_;
            phi_691_ = _e91;
        }
        let _e93 = phi_691_;
        phi_692_ = _e93;
    }
    let _e95 = phi_692_;
    if ((bitcast<u32>(param_14.w) & 2147483647u) > 2139095040u) {
        phi_711_ = param_14.w;
    } else {
        if (param_14.w < 0f) {
            phi_710_ = 0f;
        } else {
            if (param_14.w > 1f) {
                phi_709_ = 1f;
            } else {
                phi_709_ = param_14.w;
            }
            let _e104 = phi_709_;
            phi_710_ = _e104;
        }
        let _e106 = phi_710_;
        phi_711_ = _e106;
    }
    let _e108 = phi_711_;
    let _e110 = vec4<f32>((_e69 - _e57), (_e82 - _e57), (_e95 - _e57), (_e108 - _e57));
    let _e111 = _lt_math_evsm_Evsm_positive(param_13);
    let _e112 = lt_math_evsm_warp(_e110, _e111);
    let _e115 = (_e112.x - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e118 = (_e112.y - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e121 = (_e112.z - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e124 = (_e112.w - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e126 = (*param_13).min_variance;
    let _e128 = ((_e126 * _e111) * _e111);
    let _e139 = ((((_e115 * param_15.x) + (_e118 * param_15.y)) + (_e121 * param_15.z)) + (_e124 * param_15.w));
    let _e140 = (_e115 - _e139);
    let _e141 = (_e118 - _e139);
    let _e142 = (_e121 - _e139);
    let _e143 = (_e124 - _e139);
    let _e158 = (((((_e140 * _e140) * param_15.x) + ((_e141 * _e141) * param_15.y)) + ((_e142 * _e142) * param_15.z)) + ((_e143 * _e143) * param_15.w));
    if ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u) {
        phi_783_ = _e158;
    } else {
        if ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u) {
            phi_778_ = true;
        } else {
            let _e165 = (_e128 > _e158);
            if _e165 {
            }
            phi_778_ = _e165;
        }
        let _e167 = phi_778_;
        if _e167 {
            phi_782_ = _e128;
        } else {
            phi_782_ = _e158;
        }
        let _e169 = phi_782_;
        phi_783_ = _e169;
    }
    let _e171 = phi_783_;
    let _e172 = -(_e139);
    if (_e172 <= 0f) {
        let _e176 = ((bitcast<u32>(_e171) & 2147483647u) > 2139095040u);
        if _e176 {
        }
        phi_795_ = _e176;
    } else {
        phi_795_ = true;
    }
    let _e178 = phi_795_;
    if _e178 {
        phi_802_ = (_e171 / (_e171 + (_e172 * _e172)));
    } else {
        phi_802_ = 1f;
    }
    let _e183 = phi_802_;
    let _e184 = _lt_math_evsm_Evsm_negative(param_13);
    let _e186 = lt_math_evsm_warp(_e110, -(_e184));
    let _e189 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e186.x);
    let _e192 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e186.y);
    let _e195 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e186.z);
    let _e198 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e186.w);
    let _e200 = (*param_13).min_variance;
    let _e202 = ((_e200 * _e184) * _e184);
    let _e213 = ((((_e189 * param_15.x) + (_e192 * param_15.y)) + (_e195 * param_15.z)) + (_e198 * param_15.w));
    let _e214 = (_e189 - _e213);
    let _e215 = (_e192 - _e213);
    let _e216 = (_e195 - _e213);
    let _e217 = (_e198 - _e213);
    let _e232 = (((((_e214 * _e214) * param_15.x) + ((_e215 * _e215) * param_15.y)) + ((_e216 * _e216) * param_15.z)) + ((_e217 * _e217) * param_15.w));
    if ((bitcast<u32>(_e232) & 2147483647u) > 2139095040u) {
        phi_873_ = _e232;
    } else {
        if ((bitcast<u32>(_e202) & 2147483647u) > 2139095040u) {
            phi_868_ = true;
        } else {
            let _e239 = (_e202 > _e232);
            if _e239 {
            }
            phi_868_ = _e239;
        }
        let _e241 = phi_868_;
        if _e241 {
            phi_872_ = _e202;
        } else {
            phi_872_ = _e232;
        }
        let _e243 = phi_872_;
        phi_873_ = _e243;
    }
    let _e245 = phi_873_;
    let _e246 = -(_e213);
    if (_e246 <= 0f) {
        let _e250 = ((bitcast<u32>(_e245) & 2147483647u) > 2139095040u);
        if _e250 {
        }
        phi_885_ = _e250;
    } else {
        phi_885_ = true;
    }
    let _e252 = phi_885_;
    if _e252 {
        phi_892_ = (_e245 / (_e245 + (_e246 * _e246)));
    } else {
        phi_892_ = 1f;
    }
    let _e257 = phi_892_;
    if ((bitcast<u32>(_e183) & 2147483647u) > 2139095040u) {
        phi_914_ = _e183;
    } else {
        if ((bitcast<u32>(_e257) & 2147483647u) > 2139095040u) {
            phi_909_ = true;
        } else {
            let _e264 = (_e257 < _e183);
            if _e264 {
            }
            phi_909_ = _e264;
        }
        let _e266 = phi_909_;
        if _e266 {
            phi_913_ = _e257;
        } else {
            phi_913_ = _e183;
        }
        let _e268 = phi_913_;
        phi_914_ = _e268;
    }
    let _e270 = phi_914_;
    if ((bitcast<u32>(_e270) & 2147483647u) > 2139095040u) {
        phi_931_ = _e270;
    } else {
        if (_e270 < 0f) {
            phi_930_ = 0f;
        } else {
            if (_e270 > 1f) {
                phi_929_ = 1f;
            } else {
                phi_929_ = _e270;
            }
            let _e277 = phi_929_;
            phi_930_ = _e277;
        }
        let _e279 = phi_930_;
        phi_931_ = _e279;
    }
    let _e281 = phi_931_;
    return _e281;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_352_: bool;
    var phi_387_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_391_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_484_: bool;
    var phi_485_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_488_: bool;
    var phi_489_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_499_: bool;
    var phi_598_: evaluate_Verdict;
    var phi_599_: evaluate_Verdict;
    var phi_600_: bool;
    var phi_601_: evaluate_Verdict;
    var phi_602_: evaluate_Verdict;
    var phi_603_: bool;
    var phi_607_: evaluate_Verdict;

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
                phi_345_ = (_e82 == _e84);
                phi_346_ = false;
            } else {
                phi_345_ = bool();
                phi_346_ = true;
            }
            let _e87 = phi_345_;
            let _e89 = phi_346_;
            phi_347_ = _e87;
            phi_348_ = _e89;
        } else {
            phi_347_ = bool();
            phi_348_ = true;
        }
        let _e91 = phi_347_;
        let _e93 = phi_348_;
        if _e93 {
            phi_352_ = false;
        } else {
            phi_352_ = _e91;
        }
        let _e95 = phi_352_;
        if !(_e95) {
            let _e98 = samples.member[(0u + _e60.first_primitive)].normal;
            let _e100 = samples.member[(0u + _e60.first_primitive)].position;
            let _e101 = lt_shaders_evaluate_to_light(_e100, _e69);
            if ((((_e98.x * _e101.x) + (_e98.y * _e101.y)) + (_e98.z * _e101.z)) > 0f) {
                let _e115 = samples.member[(0u + _e60.first_primitive)].flags;
                let _e123 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e129 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e123.unnamed.visibility, false), _e123.unnamed_1);
                phi_387_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e129.unnamed, ((_e115 & 1u) == 0u));
            } else {
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e144 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e138.unnamed.visibility, false), _e138.unnamed_1);
                phi_387_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e144.unnamed, true);
            }
            let _e149 = phi_387_;
            phi_391_ = _e149;
        } else {
            let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e155.unnamed.visibility, false), _e155.unnamed_1);
            phi_391_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e161.unnamed, true);
        }
        let _e166 = phi_391_;
        if _e166.unnamed_1 {
            phi_601_ = evaluate_Verdict(_e166.unnamed.visibility, _e166.unnamed.is_doubted);
            phi_602_ = evaluate_Verdict();
            phi_603_ = true;
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
                                    phi_484_ = (_e232 <= 1f);
                                    phi_485_ = false;
                                } else {
                                    phi_484_ = bool();
                                    phi_485_ = true;
                                }
                                let _e241 = phi_484_;
                                let _e243 = phi_485_;
                                phi_486_ = _e241;
                                phi_487_ = _e243;
                            } else {
                                phi_486_ = bool();
                                phi_487_ = true;
                            }
                            let _e245 = phi_486_;
                            let _e247 = phi_487_;
                            phi_488_ = _e245;
                            phi_489_ = _e247;
                        } else {
                            phi_488_ = bool();
                            phi_489_ = true;
                        }
                        let _e249 = phi_488_;
                        let _e251 = phi_489_;
                        phi_490_ = _e249;
                        phi_491_ = _e251;
                    } else {
                        phi_490_ = bool();
                        phi_491_ = true;
                    }
                    let _e253 = phi_490_;
                    let _e255 = phi_491_;
                    phi_492_ = _e253;
                    phi_493_ = _e255;
                } else {
                    phi_492_ = bool();
                    phi_493_ = true;
                }
                let _e257 = phi_492_;
                let _e259 = phi_493_;
                phi_494_ = _e257;
                phi_495_ = _e259;
            } else {
                phi_494_ = bool();
                phi_495_ = true;
            }
            let _e261 = phi_494_;
            let _e263 = phi_495_;
            if _e263 {
                phi_499_ = false;
            } else {
                phi_499_ = _e261;
            }
            let _e265 = phi_499_;
            if _e265 {
                let _e267 = p.member.map_size;
                let _e268 = f32(_e267);
                let _e271 = ((_e205 * _e268) - 0.5f);
                let _e272 = ((_e219 * _e268) - 0.5f);
                let _e273 = floor(_e271);
                let _e274 = floor(_e272);
                let _e275 = (_e271 - _e273);
                let _e276 = (_e272 - _e274);
                let _e305 = p.member.test;
                let _e306 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e305);
                let _e308 = p.member.map_size;
                local = lt_math_Evsm(_e306.positive_exponent, _e306.negative_exponent, _e306.min_variance);
                let _e313 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < bitcast<f32>(3472883712u))), 2147483647i, (_e273 > bitcast<f32>(1325400063u))), (_e273 == _e273)), select(0i, select(select(i32(_e274), i32(-2147483648), (_e274 < bitcast<f32>(3472883712u))), 2147483647i, (_e274 > bitcast<f32>(1325400063u))), (_e274 == _e274)), _e308);
                if (_e313[0] < _e51) {
                } else {
                    return;
                }
                let _e318 = map.member[(0u + _e313[0])];
                if (_e313[1] < _e51) {
                } else {
                    return;
                }
                let _e323 = map.member[(0u + _e313[1])];
                if (_e313[2] < _e51) {
                } else {
                    return;
                }
                let _e328 = map.member[(0u + _e313[2])];
                if (_e313[3] < _e51) {
                } else {
                    return;
                }
                let _e333 = map.member[(0u + _e313[3])];
                let _e335 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e318, _e323, _e328, _e333), vec4<f32>(((1f - _e275) * (1f - _e276)), (_e275 * (1f - _e276)), ((1f - _e275) * _e276), (_e275 * _e276)), _e232);
                phi_598_ = evaluate_Verdict(_e335, false);
                phi_599_ = evaluate_Verdict();
                phi_600_ = false;
            } else {
                phi_598_ = evaluate_Verdict();
                phi_599_ = evaluate_Verdict(1f, false);
                phi_600_ = true;
            }
            let _e339 = phi_598_;
            let _e341 = phi_599_;
            let _e343 = phi_600_;
            phi_601_ = _e341;
            phi_602_ = _e339;
            phi_603_ = _e343;
        }
        let _e345 = phi_601_;
        let _e347 = phi_602_;
        let _e349 = phi_603_;
        if _e349 {
            phi_607_ = _e345;
        } else {
            phi_607_ = _e347;
        }
        let _e351 = phi_607_;
        if (_e60.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e60.first_primitive)] = _e351.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
