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
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_172_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_164_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_165_ = false;
        } else {
            phi_164_ = lt_bvh_traverse_Tree();
            phi_165_ = true;
        }
        let _e63 = phi_164_;
        let _e65 = phi_165_;
        phi_166_ = _e63;
        phi_167_ = _e65;
    } else {
        phi_166_ = lt_bvh_traverse_Tree();
        phi_167_ = true;
    }
    let _e67 = phi_166_;
    let _e69 = phi_167_;
    if _e69 {
        phi_172_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_172_ = _e67;
    }
    let _e74 = phi_172_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_negative(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_420_: bool;
    var phi_424_: f32;

    let _e52 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_420_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_420_ = _e56;
    }
    let _e58 = phi_420_;
    if _e58 {
        phi_424_ = 42f;
    } else {
        phi_424_ = _e52;
    }
    let _e60 = phi_424_;
    return _e60;
}

fn _lt_math_evsm_Evsm_positive(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_401_: bool;
    var phi_405_: f32;

    let _e52 = (*param_5).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_401_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_401_ = _e56;
    }
    let _e58 = phi_401_;
    if _e58 {
        phi_405_ = 42f;
    } else {
        phi_405_ = _e52;
    }
    let _e60 = phi_405_;
    return _e60;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6: ptr<function, lt_math_Evsm>, param_7: f32) -> vec4<f32> {
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_214_: f32;
    var phi_219_: f32;
    var phi_241_: f32;
    var phi_246_: f32;
    var phi_247_: bool;
    var phi_248_: f32;
    var phi_249_: bool;
    var phi_253_: f32;
    var phi_291_: f32;
    var phi_305_: f32;
    var phi_310_: f32;
    var phi_332_: f32;
    var phi_337_: f32;
    var phi_338_: bool;
    var phi_339_: f32;
    var phi_340_: bool;
    var phi_344_: f32;
    var phi_382_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_201_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_7;
            }
            let _e58 = phi_199_;
            phi_200_ = _e58;
        }
        let _e60 = phi_200_;
        phi_201_ = _e60;
    }
    let _e62 = phi_201_;
    let _e63 = _lt_math_evsm_Evsm_positive(param_6);
    let _e64 = (_e63 * _e62);
    if ((bitcast<u32>(_e64) & 2147483647u) > 2139095040u) {
        phi_291_ = _e64;
    } else {
        if (_e64 < -87f) {
            phi_214_ = -87f;
        } else {
            phi_214_ = _e64;
        }
        let _e70 = phi_214_;
        if (_e70 > 88f) {
            phi_219_ = 88f;
        } else {
            phi_219_ = _e70;
        }
        let _e73 = phi_219_;
        let _e75 = ((_e73 * 1.442695f) + 0.5f);
        if (_e75 > -8388608f) {
            let _e87 = f32(select(0i, select(select(i32(_e75), i32(-2147483648), (_e75 < bitcast<f32>(3472883712u))), 2147483647i, (_e75 > bitcast<f32>(1325400063u))), (_e75 == _e75)));
            if (_e87 > _e75) {
                phi_241_ = 1f;
            } else {
                phi_241_ = 0f;
            }
            let _e90 = phi_241_;
            if (_e75 < 8388608f) {
                phi_246_ = (_e87 - _e90);
                phi_247_ = false;
            } else {
                phi_246_ = f32();
                phi_247_ = true;
            }
            let _e93 = phi_246_;
            let _e95 = phi_247_;
            phi_248_ = _e93;
            phi_249_ = _e95;
        } else {
            phi_248_ = f32();
            phi_249_ = true;
        }
        let _e97 = phi_248_;
        let _e99 = phi_249_;
        if _e99 {
            phi_253_ = _e75;
        } else {
            phi_253_ = _e97;
        }
        let _e101 = phi_253_;
        let _e105 = ((_e73 - (_e101 * 0.69314575f)) - (_e101 * 0.0000014286068f));
        phi_291_ = ((((((((((((((((1f / 5040f) * _e105) + (1f / 720f)) * _e105) + (1f / 120f)) * _e105) + (1f / 24f)) * _e105) + (1f / 6f)) * _e105) + 0.5f) * _e105) + 1f) * _e105) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e101), i32(-2147483648), (_e101 < bitcast<f32>(3472883712u))), 2147483647i, (_e101 > bitcast<f32>(1325400063u))), (_e101 == _e101)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e141 = phi_291_;
    let _e142 = _lt_math_evsm_Evsm_negative(param_6);
    let _e144 = (-(_e142) * _e62);
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_382_ = _e144;
    } else {
        if (_e144 < -87f) {
            phi_305_ = -87f;
        } else {
            phi_305_ = _e144;
        }
        let _e150 = phi_305_;
        if (_e150 > 88f) {
            phi_310_ = 88f;
        } else {
            phi_310_ = _e150;
        }
        let _e153 = phi_310_;
        let _e155 = ((_e153 * 1.442695f) + 0.5f);
        if (_e155 > -8388608f) {
            let _e167 = f32(select(0i, select(select(i32(_e155), i32(-2147483648), (_e155 < bitcast<f32>(3472883712u))), 2147483647i, (_e155 > bitcast<f32>(1325400063u))), (_e155 == _e155)));
            if (_e167 > _e155) {
                phi_332_ = 1f;
            } else {
                phi_332_ = 0f;
            }
            let _e170 = phi_332_;
            if (_e155 < 8388608f) {
                phi_337_ = (_e167 - _e170);
                phi_338_ = false;
            } else {
                phi_337_ = f32();
                phi_338_ = true;
            }
            let _e173 = phi_337_;
            let _e175 = phi_338_;
            phi_339_ = _e173;
            phi_340_ = _e175;
        } else {
            phi_339_ = f32();
            phi_340_ = true;
        }
        let _e177 = phi_339_;
        let _e179 = phi_340_;
        if _e179 {
            phi_344_ = _e155;
        } else {
            phi_344_ = _e177;
        }
        let _e181 = phi_344_;
        let _e185 = ((_e153 - (_e181 * 0.69314575f)) - (_e181 * 0.0000014286068f));
        phi_382_ = ((((((((((((((((1f / 5040f) * _e185) + (1f / 720f)) * _e185) + (1f / 120f)) * _e185) + (1f / 24f)) * _e185) + (1f / 6f)) * _e185) + 0.5f) * _e185) + 1f) * _e185) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e181), i32(-2147483648), (_e181 < bitcast<f32>(3472883712u))), 2147483647i, (_e181 > bitcast<f32>(1325400063u))), (_e181 == _e181)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e221 = phi_382_;
    let _e222 = -(_e221);
    return vec4<f32>(_e141, (_e141 * _e141), _e222, (_e222 * _e222));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8: ptr<function, lt_math_Evsm>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_454_: bool;
    var phi_458_: f32;
    var phi_470_: bool;
    var phi_477_: f32;
    var phi_502_: bool;
    var phi_506_: f32;
    var phi_518_: bool;
    var phi_525_: f32;
    var phi_536_: bool;
    var phi_540_: f32;
    var phi_555_: f32;
    var phi_556_: f32;
    var phi_557_: f32;

    let _e53 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_8, param_10);
    let _e54 = _lt_math_evsm_Evsm_positive(param_8);
    let _e56 = (*param_8).min_variance;
    let _e60 = (((_e56 * _e54) * _e54) * _e53.y);
    let _e67 = ((param_9.y - (param_9.x * param_9.x)) + (0.00000047683716f * param_9.y));
    if ((bitcast<u32>(_e60) & 2147483647u) > 2139095040u) {
        phi_454_ = true;
    } else {
        let _e71 = (_e60 > _e67);
        if _e71 {
        }
        phi_454_ = _e71;
    }
    let _e73 = phi_454_;
    if _e73 {
        phi_458_ = _e60;
    } else {
        phi_458_ = _e67;
    }
    let _e75 = phi_458_;
    let _e76 = (_e53.x - param_9.x);
    if (_e76 <= 0f) {
        let _e80 = ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u);
        if _e80 {
        }
        phi_470_ = _e80;
    } else {
        phi_470_ = true;
    }
    let _e82 = phi_470_;
    if _e82 {
        phi_477_ = (_e75 / (_e75 + (_e76 * _e76)));
    } else {
        phi_477_ = 1f;
    }
    let _e87 = phi_477_;
    let _e88 = _lt_math_evsm_Evsm_negative(param_8);
    let _e90 = (*param_8).min_variance;
    let _e94 = (((_e90 * _e88) * _e88) * _e53.w);
    let _e101 = ((param_9.w - (param_9.z * param_9.z)) + (0.00000047683716f * param_9.w));
    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
        phi_502_ = true;
    } else {
        let _e105 = (_e94 > _e101);
        if _e105 {
        }
        phi_502_ = _e105;
    }
    let _e107 = phi_502_;
    if _e107 {
        phi_506_ = _e94;
    } else {
        phi_506_ = _e101;
    }
    let _e109 = phi_506_;
    let _e110 = (_e53.z - param_9.z);
    if (_e110 <= 0f) {
        let _e114 = ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u);
        if _e114 {
        }
        phi_518_ = _e114;
    } else {
        phi_518_ = true;
    }
    let _e116 = phi_518_;
    if _e116 {
        phi_525_ = (_e109 / (_e109 + (_e110 * _e110)));
    } else {
        phi_525_ = 1f;
    }
    let _e121 = phi_525_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_536_ = true;
    } else {
        let _e125 = (_e121 < _e87);
        if _e125 {
        }
        phi_536_ = _e125;
    }
    let _e127 = phi_536_;
    if _e127 {
        phi_540_ = _e121;
    } else {
        phi_540_ = _e87;
    }
    let _e129 = phi_540_;
    if ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u) {
        phi_557_ = _e129;
    } else {
        if (_e129 < 0f) {
            phi_556_ = 0f;
        } else {
            if (_e129 > 1f) {
                phi_555_ = 1f;
            } else {
                phi_555_ = _e129;
            }
            let _e136 = phi_555_;
            phi_556_ = _e136;
        }
        let _e138 = phi_556_;
        phi_557_ = _e138;
    }
    let _e140 = phi_557_;
    return _e140;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_618_: bool;
    var phi_662_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_666_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_743_: bool;
    var phi_752_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_771_: bool;
    var phi_807_: f32;
    var phi_812_: f32;
    var phi_813_: bool;
    var phi_814_: f32;
    var phi_815_: bool;
    var phi_819_: f32;
    var phi_839_: f32;
    var phi_844_: f32;
    var phi_845_: bool;
    var phi_846_: f32;
    var phi_847_: bool;
    var phi_851_: f32;
    var phi_901_: i32;
    var phi_906_: i32;
    var phi_911_: i32;
    var phi_916_: i32;
    var phi_925_: i32;
    var phi_930_: i32;
    var phi_935_: i32;
    var phi_940_: i32;
    var phi_1031_: bool;
    var phi_1039_: bool;
    var phi_1044_: f32;
    var phi_1047_: evaluate_Verdict;
    var phi_1048_: evaluate_Verdict;
    var phi_1052_: bool;
    var phi_1053_: u32;
    var phi_1059_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e64 = p.member.size[0u];
    let _e66 = p.member.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e51, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e74 = p.member.light;
        let _e77 = samples.member[_e67.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e67.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e67.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_611_ = (_e87 == _e89);
                phi_612_ = false;
            } else {
                phi_611_ = bool();
                phi_612_ = true;
            }
            let _e92 = phi_611_;
            let _e94 = phi_612_;
            phi_613_ = _e92;
            phi_614_ = _e94;
        } else {
            phi_613_ = bool();
            phi_614_ = true;
        }
        let _e96 = phi_613_;
        let _e98 = phi_614_;
        if _e98 {
            phi_618_ = false;
        } else {
            phi_618_ = _e96;
        }
        let _e100 = phi_618_;
        if !(_e100) {
            let _e103 = samples.member[_e67.first_primitive].normal;
            let _e105 = samples.member[_e67.first_primitive].position;
            if ((((_e103.x * (_e74.x - (_e105.x * _e74.w))) + (_e103.y * (_e74.y - (_e105.y * _e74.w)))) + (_e103.z * (_e74.z - (_e105.z * _e74.w)))) > 0f) {
                let _e129 = samples.member[_e67.first_primitive].flags;
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_662_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, ((_e129 & 1u) == 0u));
            } else {
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_662_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, true);
            }
            let _e163 = phi_662_;
            phi_666_ = _e163;
        } else {
            let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
            phi_666_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, true);
        }
        let _e180 = phi_666_;
        if _e180.unnamed_1 {
            phi_1048_ = evaluate_Verdict(_e180.unnamed.visibility, _e180.unnamed.is_doubted);
        } else {
            let _e188 = samples.member[_e67.first_primitive].position;
            let _e194 = p.member.projection.row_w;
            let _e205 = ((((_e194.x * _e188.x) + (_e194.y * _e188.y)) + (_e194.z * _e188.z)) + (_e194.w * 1f));
            let _e207 = p.member.projection.row_x;
            let _e219 = (((((_e207.x * _e188.x) + (_e207.y * _e188.y)) + (_e207.z * _e188.z)) + (_e207.w * 1f)) / _e205);
            let _e221 = p.member.projection.row_y;
            let _e233 = (((((_e221.x * _e188.x) + (_e221.y * _e188.y)) + (_e221.z * _e188.z)) + (_e221.w * 1f)) / _e205);
            let _e235 = p.member.projection.row_z;
            let _e246 = ((((_e235.x * _e188.x) + (_e235.y * _e188.y)) + (_e235.z * _e188.z)) + (_e235.w * 1f));
            if (_e205 > 0f) {
                if (_e219 >= 0f) {
                    phi_743_ = (_e219 <= 1f);
                } else {
                    phi_743_ = false;
                }
                let _e251 = phi_743_;
                if _e251 {
                    if (_e233 >= 0f) {
                        phi_752_ = (_e233 <= 1f);
                    } else {
                        phi_752_ = false;
                    }
                    let _e255 = phi_752_;
                    if _e255 {
                        if (_e246 >= 0f) {
                            phi_761_ = (_e246 <= 1f);
                        } else {
                            phi_761_ = false;
                        }
                        let _e259 = phi_761_;
                        phi_762_ = _e259;
                        phi_763_ = false;
                    } else {
                        phi_762_ = bool();
                        phi_763_ = true;
                    }
                    let _e261 = phi_762_;
                    let _e263 = phi_763_;
                    phi_764_ = _e261;
                    phi_765_ = _e263;
                } else {
                    phi_764_ = bool();
                    phi_765_ = true;
                }
                let _e265 = phi_764_;
                let _e267 = phi_765_;
                phi_766_ = _e265;
                phi_767_ = _e267;
            } else {
                phi_766_ = bool();
                phi_767_ = true;
            }
            let _e269 = phi_766_;
            let _e271 = phi_767_;
            if _e271 {
                phi_771_ = false;
            } else {
                phi_771_ = _e269;
            }
            let _e273 = phi_771_;
            if _e273 {
                let _e275 = p.member.map_size;
                let _e276 = f32(_e275);
                let _e279 = ((_e219 * _e276) - 0.5f);
                let _e280 = ((_e233 * _e276) - 0.5f);
                if (_e279 > -8388608f) {
                    let _e292 = f32(select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < bitcast<f32>(3472883712u))), 2147483647i, (_e279 > bitcast<f32>(1325400063u))), (_e279 == _e279)));
                    if (_e292 > _e279) {
                        phi_807_ = 1f;
                    } else {
                        phi_807_ = 0f;
                    }
                    let _e295 = phi_807_;
                    if (_e279 < 8388608f) {
                        phi_812_ = (_e292 - _e295);
                        phi_813_ = false;
                    } else {
                        phi_812_ = f32();
                        phi_813_ = true;
                    }
                    let _e298 = phi_812_;
                    let _e300 = phi_813_;
                    phi_814_ = _e298;
                    phi_815_ = _e300;
                } else {
                    phi_814_ = f32();
                    phi_815_ = true;
                }
                let _e302 = phi_814_;
                let _e304 = phi_815_;
                if _e304 {
                    phi_819_ = _e279;
                } else {
                    phi_819_ = _e302;
                }
                let _e306 = phi_819_;
                if (_e280 > -8388608f) {
                    let _e318 = f32(select(0i, select(select(i32(_e280), i32(-2147483648), (_e280 < bitcast<f32>(3472883712u))), 2147483647i, (_e280 > bitcast<f32>(1325400063u))), (_e280 == _e280)));
                    if (_e318 > _e280) {
                        phi_839_ = 1f;
                    } else {
                        phi_839_ = 0f;
                    }
                    let _e321 = phi_839_;
                    if (_e280 < 8388608f) {
                        phi_844_ = (_e318 - _e321);
                        phi_845_ = false;
                    } else {
                        phi_844_ = f32();
                        phi_845_ = true;
                    }
                    let _e324 = phi_844_;
                    let _e326 = phi_845_;
                    phi_846_ = _e324;
                    phi_847_ = _e326;
                } else {
                    phi_846_ = f32();
                    phi_847_ = true;
                }
                let _e328 = phi_846_;
                let _e330 = phi_847_;
                if _e330 {
                    phi_851_ = _e280;
                } else {
                    phi_851_ = _e328;
                }
                let _e332 = phi_851_;
                let _e333 = (_e279 - _e306);
                let _e334 = (_e280 - _e332);
                let _e343 = select(0i, select(select(i32(_e306), i32(-2147483648), (_e306 < bitcast<f32>(3472883712u))), 2147483647i, (_e306 > bitcast<f32>(1325400063u))), (_e306 == _e306));
                let _e352 = select(0i, select(select(i32(_e332), i32(-2147483648), (_e332 < bitcast<f32>(3472883712u))), 2147483647i, (_e332 > bitcast<f32>(1325400063u))), (_e332 == _e332));
                let _e355 = ((1f - _e333) * (1f - _e334));
                let _e357 = (_e333 * (1f - _e334));
                let _e359 = ((1f - _e333) * _e334);
                let _e360 = (_e333 * _e334);
                let _e362 = p.member.test;
                let _e363 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e362);
                let _e365 = p.member.map_size;
                local_1 = lt_math_Evsm(_e363.positive_exponent, _e363.negative_exponent, _e363.min_variance);
                let _e371 = (bitcast<i32>(_e365) - 1i);
                if (_e343 > 0i) {
                    phi_901_ = _e343;
                } else {
                    phi_901_ = 0i;
                }
                let _e374 = phi_901_;
                if (_e352 > 0i) {
                    phi_906_ = _e352;
                } else {
                    phi_906_ = 0i;
                }
                let _e377 = phi_906_;
                if (_e374 < _e371) {
                    phi_911_ = _e374;
                } else {
                    phi_911_ = _e371;
                }
                let _e380 = phi_911_;
                if (_e377 < _e371) {
                    phi_916_ = _e377;
                } else {
                    phi_916_ = _e371;
                }
                let _e383 = phi_916_;
                let _e384 = bitcast<u32>(_e380);
                let _e386 = (_e343 + 1i);
                let _e387 = (_e352 + 1i);
                if (_e386 > 0i) {
                    phi_925_ = _e386;
                } else {
                    phi_925_ = 0i;
                }
                let _e390 = phi_925_;
                if (_e387 > 0i) {
                    phi_930_ = _e387;
                } else {
                    phi_930_ = 0i;
                }
                let _e393 = phi_930_;
                if (_e390 < _e371) {
                    phi_935_ = _e390;
                } else {
                    phi_935_ = _e371;
                }
                let _e396 = phi_935_;
                if (_e393 < _e371) {
                    phi_940_ = _e393;
                } else {
                    phi_940_ = _e371;
                }
                let _e399 = phi_940_;
                let _e400 = bitcast<u32>(_e396);
                let _e402 = (bitcast<u32>(_e383) * _e365);
                let _e403 = (bitcast<u32>(_e399) * _e365);
                let _e404 = (_e402 + _e384);
                let _e405 = (_e402 + _e400);
                let _e406 = (_e403 + _e384);
                let _e407 = (_e403 + _e400);
                if (_e404 < _e57) {
                } else {
                    return;
                }
                let _e411 = map.member[(0u + _e404)];
                if (_e405 < _e57) {
                } else {
                    return;
                }
                let _e423 = map.member[(0u + _e405)];
                if (_e406 < _e57) {
                } else {
                    return;
                }
                let _e439 = map.member[(0u + _e406)];
                if (_e407 < _e57) {
                } else {
                    return;
                }
                let _e455 = map.member[(0u + _e407)];
                let _e469 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e411.x * _e355) + (_e423.x * _e357)) + (_e439.x * _e359)) + (_e455.x * _e360)), ((((_e411.y * _e355) + (_e423.y * _e357)) + (_e439.y * _e359)) + (_e455.y * _e360)), ((((_e411.z * _e355) + (_e423.z * _e357)) + (_e439.z * _e359)) + (_e455.z * _e360)), ((((_e411.w * _e355) + (_e423.w * _e357)) + (_e439.w * _e359)) + (_e455.w * _e360))), _e246);
                let _e471 = p.member.epsilon;
                if (_e469 <= _e471) {
                    phi_1031_ = true;
                } else {
                    phi_1031_ = (_e469 >= (1f - _e471));
                }
                let _e476 = phi_1031_;
                if ((bitcast<u32>(_e469) & 2147483647u) > 2139095040u) {
                    phi_1039_ = true;
                } else {
                    phi_1039_ = !(_e476);
                }
                let _e482 = phi_1039_;
                if (_e469 > 0.5f) {
                    phi_1044_ = 1f;
                } else {
                    phi_1044_ = 0f;
                }
                let _e485 = phi_1044_;
                phi_1047_ = evaluate_Verdict(_e485, _e482);
            } else {
                phi_1047_ = evaluate_Verdict(1f, true);
            }
            let _e489 = phi_1047_;
            phi_1048_ = _e489;
        }
        let _e491 = phi_1048_;
        visibility.member[_e67.first_primitive] = _e491.visibility;
        phi_1052_ = _e491.is_doubted;
        phi_1053_ = _e67.first_primitive;
    } else {
        phi_1052_ = false;
        phi_1053_ = 0u;
    }
    let _e496 = phi_1052_;
    let _e498 = phi_1053_;
    if _e496 {
        let _e500 = atomicAdd((&shared_[0u]), 1u);
        phi_1059_ = _e500;
    } else {
        phi_1059_ = 0u;
    }
    let _e502 = phi_1059_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e506 = atomicLoad((&shared_[0u]));
        let _e507 = atomicAdd((&list.member[3u]), _e506);
        atomicStore((&shared_[1u]), _e507);
    }
    workgroupBarrier();
    if _e496 {
        let _e510 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e510) + _e502)]), _e498);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
