struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
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

struct type_37 {
    member: array<vec4<f32>>,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_41 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e64 = phi_165_;
        let _e66 = phi_166_;
        phi_167_ = _e64;
        phi_168_ = _e66;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e68 = phi_167_;
    let _e70 = phi_168_;
    if _e70 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e68;
    }
    let _e75 = phi_173_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_4: ptr<function, lt_math_Evsm>, param_5: f32) -> vec4<f32> {
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_215_: bool;
    var phi_219_: f32;
    var phi_231_: f32;
    var phi_236_: f32;
    var phi_258_: f32;
    var phi_263_: f32;
    var phi_264_: bool;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_270_: f32;
    var phi_308_: f32;
    var phi_321_: bool;
    var phi_325_: f32;
    var phi_338_: f32;
    var phi_343_: f32;
    var phi_365_: f32;
    var phi_370_: f32;
    var phi_371_: bool;
    var phi_372_: f32;
    var phi_373_: bool;
    var phi_377_: f32;
    var phi_415_: f32;

    if ((bitcast<u32>(param_5) & 2147483647u) > 2139095040u) {
        phi_202_ = param_5;
    } else {
        if (param_5 < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_5 > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_5;
            }
            let _e59 = phi_200_;
            phi_201_ = _e59;
        }
        let _e61 = phi_201_;
        phi_202_ = _e61;
    }
    let _e63 = phi_202_;
    let _e65 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_215_ = true;
    } else {
        let _e69 = (42f < _e65);
        if _e69 {
        }
        phi_215_ = _e69;
    }
    let _e71 = phi_215_;
    if _e71 {
        phi_219_ = 42f;
    } else {
        phi_219_ = _e65;
    }
    let _e73 = phi_219_;
    let _e74 = (_e73 * _e63);
    if ((bitcast<u32>(_e74) & 2147483647u) > 2139095040u) {
        phi_308_ = _e74;
    } else {
        if (_e74 < -87f) {
            phi_231_ = -87f;
        } else {
            phi_231_ = _e74;
        }
        let _e80 = phi_231_;
        if (_e80 > 88f) {
            phi_236_ = 88f;
        } else {
            phi_236_ = _e80;
        }
        let _e83 = phi_236_;
        let _e85 = ((_e83 * 1.442695f) + 0.5f);
        if (_e85 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(_e85), i32(-2147483648), (_e85 < bitcast<f32>(3472883712u))), 2147483647i, (_e85 > bitcast<f32>(1325400063u))), (_e85 == _e85)));
            if (_e97 > _e85) {
                phi_258_ = 1f;
            } else {
                phi_258_ = 0f;
            }
            let _e100 = phi_258_;
            if (_e85 < 8388608f) {
                phi_263_ = (_e97 - _e100);
                phi_264_ = false;
            } else {
                phi_263_ = f32();
                phi_264_ = true;
            }
            let _e103 = phi_263_;
            let _e105 = phi_264_;
            phi_265_ = _e103;
            phi_266_ = _e105;
        } else {
            phi_265_ = f32();
            phi_266_ = true;
        }
        let _e107 = phi_265_;
        let _e109 = phi_266_;
        if _e109 {
            phi_270_ = _e85;
        } else {
            phi_270_ = _e107;
        }
        let _e111 = phi_270_;
        let _e115 = ((_e83 - (_e111 * 0.69314575f)) - (_e111 * 0.0000014286068f));
        phi_308_ = ((((((((((((((((1f / 5040f) * _e115) + (1f / 720f)) * _e115) + (1f / 120f)) * _e115) + (1f / 24f)) * _e115) + (1f / 6f)) * _e115) + 0.5f) * _e115) + 1f) * _e115) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e111), i32(-2147483648), (_e111 < bitcast<f32>(3472883712u))), 2147483647i, (_e111 > bitcast<f32>(1325400063u))), (_e111 == _e111)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e151 = phi_308_;
    let _e153 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_321_ = true;
    } else {
        let _e157 = (42f < _e153);
        if _e157 {
        }
        phi_321_ = _e157;
    }
    let _e159 = phi_321_;
    if _e159 {
        phi_325_ = 42f;
    } else {
        phi_325_ = _e153;
    }
    let _e161 = phi_325_;
    let _e163 = (-(_e161) * _e63);
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_415_ = _e163;
    } else {
        if (_e163 < -87f) {
            phi_338_ = -87f;
        } else {
            phi_338_ = _e163;
        }
        let _e169 = phi_338_;
        if (_e169 > 88f) {
            phi_343_ = 88f;
        } else {
            phi_343_ = _e169;
        }
        let _e172 = phi_343_;
        let _e174 = ((_e172 * 1.442695f) + 0.5f);
        if (_e174 > -8388608f) {
            let _e186 = f32(select(0i, select(select(i32(_e174), i32(-2147483648), (_e174 < bitcast<f32>(3472883712u))), 2147483647i, (_e174 > bitcast<f32>(1325400063u))), (_e174 == _e174)));
            if (_e186 > _e174) {
                phi_365_ = 1f;
            } else {
                phi_365_ = 0f;
            }
            let _e189 = phi_365_;
            if (_e174 < 8388608f) {
                phi_370_ = (_e186 - _e189);
                phi_371_ = false;
            } else {
                phi_370_ = f32();
                phi_371_ = true;
            }
            let _e192 = phi_370_;
            let _e194 = phi_371_;
            phi_372_ = _e192;
            phi_373_ = _e194;
        } else {
            phi_372_ = f32();
            phi_373_ = true;
        }
        let _e196 = phi_372_;
        let _e198 = phi_373_;
        if _e198 {
            phi_377_ = _e174;
        } else {
            phi_377_ = _e196;
        }
        let _e200 = phi_377_;
        let _e204 = ((_e172 - (_e200 * 0.69314575f)) - (_e200 * 0.0000014286068f));
        phi_415_ = ((((((((((((((((1f / 5040f) * _e204) + (1f / 720f)) * _e204) + (1f / 120f)) * _e204) + (1f / 24f)) * _e204) + (1f / 6f)) * _e204) + 0.5f) * _e204) + 1f) * _e204) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e200), i32(-2147483648), (_e200 < bitcast<f32>(3472883712u))), 2147483647i, (_e200 > bitcast<f32>(1325400063u))), (_e200 == _e200)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e240 = phi_415_;
    let _e241 = -(_e240);
    return vec4<f32>(_e151, (_e151 * _e151), _e241, (_e241 * _e241));
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_437_: bool;
    var phi_441_: f32;
    var phi_465_: bool;
    var phi_469_: f32;
    var phi_481_: bool;
    var phi_488_: f32;
    var phi_501_: bool;
    var phi_505_: f32;
    var phi_529_: bool;
    var phi_533_: f32;
    var phi_545_: bool;
    var phi_552_: f32;
    var phi_563_: bool;
    var phi_567_: f32;
    var phi_582_: f32;
    var phi_583_: f32;
    var phi_584_: f32;

    let _e54 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_6, param_8);
    let _e56 = (*param_6).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_437_ = true;
    } else {
        let _e60 = (42f < _e56);
        if _e60 {
        }
        phi_437_ = _e60;
    }
    let _e62 = phi_437_;
    if _e62 {
        phi_441_ = 42f;
    } else {
        phi_441_ = _e56;
    }
    let _e64 = phi_441_;
    let _e66 = (*param_6).min_variance;
    let _e70 = (((_e66 * _e64) * _e64) * _e54.y);
    let _e77 = ((param_7.y - (param_7.x * param_7.x)) + (0.00000047683716f * param_7.y));
    if ((bitcast<u32>(_e70) & 2147483647u) > 2139095040u) {
        phi_465_ = true;
    } else {
        let _e81 = (_e70 > _e77);
        if _e81 {
        }
        phi_465_ = _e81;
    }
    let _e83 = phi_465_;
    if _e83 {
        phi_469_ = _e70;
    } else {
        phi_469_ = _e77;
    }
    let _e85 = phi_469_;
    let _e86 = (_e54.x - param_7.x);
    if (_e86 <= 0f) {
        let _e90 = ((bitcast<u32>(_e85) & 2147483647u) > 2139095040u);
        if _e90 {
        }
        phi_481_ = _e90;
    } else {
        phi_481_ = true;
    }
    let _e92 = phi_481_;
    if _e92 {
        phi_488_ = (_e85 / (_e85 + (_e86 * _e86)));
    } else {
        phi_488_ = 1f;
    }
    let _e97 = phi_488_;
    let _e99 = (*param_6).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_501_ = true;
    } else {
        let _e103 = (42f < _e99);
        if _e103 {
        }
        phi_501_ = _e103;
    }
    let _e105 = phi_501_;
    if _e105 {
        phi_505_ = 42f;
    } else {
        phi_505_ = _e99;
    }
    let _e107 = phi_505_;
    let _e109 = (*param_6).min_variance;
    let _e113 = (((_e109 * _e107) * _e107) * _e54.w);
    let _e120 = ((param_7.w - (param_7.z * param_7.z)) + (0.00000047683716f * param_7.w));
    if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
        phi_529_ = true;
    } else {
        let _e124 = (_e113 > _e120);
        if _e124 {
        }
        phi_529_ = _e124;
    }
    let _e126 = phi_529_;
    if _e126 {
        phi_533_ = _e113;
    } else {
        phi_533_ = _e120;
    }
    let _e128 = phi_533_;
    let _e129 = (_e54.z - param_7.z);
    if (_e129 <= 0f) {
        let _e133 = ((bitcast<u32>(_e128) & 2147483647u) > 2139095040u);
        if _e133 {
        }
        phi_545_ = _e133;
    } else {
        phi_545_ = true;
    }
    let _e135 = phi_545_;
    if _e135 {
        phi_552_ = (_e128 / (_e128 + (_e129 * _e129)));
    } else {
        phi_552_ = 1f;
    }
    let _e140 = phi_552_;
    if ((bitcast<u32>(_e140) & 2147483647u) > 2139095040u) {
        phi_563_ = true;
    } else {
        let _e144 = (_e140 < _e97);
        if _e144 {
        }
        phi_563_ = _e144;
    }
    let _e146 = phi_563_;
    if _e146 {
        phi_567_ = _e140;
    } else {
        phi_567_ = _e97;
    }
    let _e148 = phi_567_;
    if ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u) {
        phi_584_ = _e148;
    } else {
        if (_e148 < 0f) {
            phi_583_ = 0f;
        } else {
            if (_e148 > 1f) {
                phi_582_ = 1f;
            } else {
                phi_582_ = _e148;
            }
            let _e155 = phi_582_;
            phi_583_ = _e155;
        }
        let _e157 = phi_583_;
        phi_584_ = _e157;
    }
    let _e159 = phi_584_;
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
    var phi_765_: bool;
    var phi_774_: bool;
    var phi_783_: bool;
    var phi_784_: bool;
    var phi_785_: bool;
    var phi_786_: bool;
    var phi_787_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_793_: bool;
    var phi_883_: f32;
    var phi_886_: f32;
    var phi_915_: f32;
    var phi_920_: f32;
    var phi_921_: bool;
    var phi_922_: f32;
    var phi_923_: bool;
    var phi_927_: f32;
    var phi_947_: f32;
    var phi_952_: f32;
    var phi_953_: bool;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_959_: f32;
    var phi_1011_: i32;
    var phi_1016_: i32;
    var phi_1021_: i32;
    var phi_1026_: i32;
    var phi_1035_: i32;
    var phi_1040_: i32;
    var phi_1045_: i32;
    var phi_1050_: i32;
    var phi_1145_: bool;
    var phi_1153_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1170_: f32;
    var phi_1176_: f32;
    var phi_1178_: evaluate_Verdict;
    var phi_1183_: evaluate_Verdict;
    var phi_1184_: evaluate_Verdict;
    var phi_1188_: bool;
    var phi_1189_: u32;
    var phi_1200_: u32;

    let _e52 = id_1;
    let _e53 = local_2;
    let _e58 = arrayLength((&map.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e52, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.projection;
        let _e74 = lt_math_OneLevel(_e73);
        let _e76 = p.member.light;
        let _e79 = samples.member[_e66.first_primitive].normal[0u];
        let _e81 = global[0u];
        if (_e79 == _e81) {
            let _e84 = samples.member[_e66.first_primitive].normal[1u];
            let _e86 = global[1u];
            if (_e84 == _e86) {
                let _e89 = samples.member[_e66.first_primitive].normal[2u];
                let _e91 = global[2u];
                phi_636_ = (_e89 == _e91);
                phi_637_ = false;
            } else {
                phi_636_ = bool();
                phi_637_ = true;
            }
            let _e94 = phi_636_;
            let _e96 = phi_637_;
            phi_638_ = _e94;
            phi_639_ = _e96;
        } else {
            phi_638_ = bool();
            phi_639_ = true;
        }
        let _e98 = phi_638_;
        let _e100 = phi_639_;
        if _e100 {
            phi_643_ = false;
        } else {
            phi_643_ = _e98;
        }
        let _e102 = phi_643_;
        if !(_e102) {
            let _e105 = samples.member[_e66.first_primitive].normal;
            let _e107 = samples.member[_e66.first_primitive].position;
            if ((((_e105.x * (_e76.x - (_e107.x * _e76.w))) + (_e105.y * (_e76.y - (_e107.y * _e76.w)))) + (_e105.z * (_e76.z - (_e107.z * _e76.w)))) > 0f) {
                let _e131 = samples.member[_e66.first_primitive].flags;
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_687_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, ((_e131 & 1u) == 0u));
            } else {
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
                phi_687_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
            }
            let _e165 = phi_687_;
            phi_691_ = _e165;
        } else {
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
            phi_691_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, true);
        }
        let _e182 = phi_691_;
        if _e182.unnamed_1 {
            phi_1184_ = evaluate_Verdict(_e182.unnamed.visibility, _e182.unnamed.is_doubted);
        } else {
            let _e190 = samples.member[_e66.first_primitive].position;
            let _e208 = ((((_e74.projection.row_w.x * _e190.x) + (_e74.projection.row_w.y * _e190.y)) + (_e74.projection.row_w.z * _e190.z)) + (_e74.projection.row_w.w * 1f));
            let _e222 = (((((_e74.projection.row_x.x * _e190.x) + (_e74.projection.row_x.y * _e190.y)) + (_e74.projection.row_x.z * _e190.z)) + (_e74.projection.row_x.w * 1f)) / _e208);
            let _e236 = (((((_e74.projection.row_y.x * _e190.x) + (_e74.projection.row_y.y * _e190.y)) + (_e74.projection.row_y.z * _e190.z)) + (_e74.projection.row_y.w * 1f)) / _e208);
            let _e249 = ((((_e74.projection.row_z.x * _e190.x) + (_e74.projection.row_z.y * _e190.y)) + (_e74.projection.row_z.z * _e190.z)) + (_e74.projection.row_z.w * 1f));
            if (_e208 > 0f) {
                if (_e222 >= 0f) {
                    phi_765_ = (_e222 <= 1f);
                } else {
                    phi_765_ = false;
                }
                let _e254 = phi_765_;
                if _e254 {
                    if (_e236 >= 0f) {
                        phi_774_ = (_e236 <= 1f);
                    } else {
                        phi_774_ = false;
                    }
                    let _e258 = phi_774_;
                    if _e258 {
                        if (_e249 >= 0f) {
                            phi_783_ = (_e249 <= 1f);
                        } else {
                            phi_783_ = false;
                        }
                        let _e262 = phi_783_;
                        phi_784_ = _e262;
                        phi_785_ = false;
                    } else {
                        phi_784_ = bool();
                        phi_785_ = true;
                    }
                    let _e264 = phi_784_;
                    let _e266 = phi_785_;
                    phi_786_ = _e264;
                    phi_787_ = _e266;
                } else {
                    phi_786_ = bool();
                    phi_787_ = true;
                }
                let _e268 = phi_786_;
                let _e270 = phi_787_;
                phi_788_ = _e268;
                phi_789_ = _e270;
            } else {
                phi_788_ = bool();
                phi_789_ = true;
            }
            let _e272 = phi_788_;
            let _e274 = phi_789_;
            if _e274 {
                phi_793_ = false;
            } else {
                phi_793_ = _e272;
            }
            let _e276 = phi_793_;
            if _e276 {
                if (0f > 0f) {
                    let _e279 = samples.member[_e66.first_primitive].normal;
                    let _e281 = p.member.map_size;
                    let _e351 = ((abs(((((_e73.row_x.x * _e279.x) + (_e73.row_x.y * _e279.y)) + (_e73.row_x.z * _e279.z)) / (((_e73.row_x.x * _e73.row_x.x) + (_e73.row_x.y * _e73.row_x.y)) + (_e73.row_x.z * _e73.row_x.z)))) + abs(((((_e73.row_y.x * _e279.x) + (_e73.row_y.y * _e279.y)) + (_e73.row_y.z * _e279.z)) / (((_e73.row_y.x * _e73.row_y.x) + (_e73.row_y.y * _e73.row_y.y)) + (_e73.row_y.z * _e73.row_y.z))))) / (abs(((((_e73.row_z.x * _e279.x) + (_e73.row_z.y * _e279.y)) + (_e73.row_z.z * _e279.z)) / (((_e73.row_z.x * _e73.row_z.x) + (_e73.row_z.y * _e73.row_z.y)) + (_e73.row_z.z * _e73.row_z.z)))) * f32(_e281)));
                    if (_e351 < 0.002f) {
                        phi_883_ = _e351;
                    } else {
                        phi_883_ = 0.002f;
                    }
                    let _e354 = phi_883_;
                    phi_886_ = (_e249 - (0f * _e354));
                } else {
                    phi_886_ = _e249;
                }
                let _e358 = phi_886_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e222 * _e361) - 0.5f);
                let _e365 = ((_e236 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_915_ = 1f;
                    } else {
                        phi_915_ = 0f;
                    }
                    let _e380 = phi_915_;
                    if (_e364 < 8388608f) {
                        phi_920_ = (_e377 - _e380);
                        phi_921_ = false;
                    } else {
                        phi_920_ = f32();
                        phi_921_ = true;
                    }
                    let _e383 = phi_920_;
                    let _e385 = phi_921_;
                    phi_922_ = _e383;
                    phi_923_ = _e385;
                } else {
                    phi_922_ = f32();
                    phi_923_ = true;
                }
                let _e387 = phi_922_;
                let _e389 = phi_923_;
                if _e389 {
                    phi_927_ = _e364;
                } else {
                    phi_927_ = _e387;
                }
                let _e391 = phi_927_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_947_ = 1f;
                    } else {
                        phi_947_ = 0f;
                    }
                    let _e406 = phi_947_;
                    if (_e365 < 8388608f) {
                        phi_952_ = (_e403 - _e406);
                        phi_953_ = false;
                    } else {
                        phi_952_ = f32();
                        phi_953_ = true;
                    }
                    let _e409 = phi_952_;
                    let _e411 = phi_953_;
                    phi_954_ = _e409;
                    phi_955_ = _e411;
                } else {
                    phi_954_ = f32();
                    phi_955_ = true;
                }
                let _e413 = phi_954_;
                let _e415 = phi_955_;
                if _e415 {
                    phi_959_ = _e365;
                } else {
                    phi_959_ = _e413;
                }
                let _e417 = phi_959_;
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
                local_1 = lt_math_Evsm(_e448.positive_exponent, _e448.negative_exponent, _e448.min_variance);
                let _e456 = ((0u * _e450) * _e450);
                let _e458 = (bitcast<i32>(_e450) - 1i);
                if (_e428 > 0i) {
                    phi_1011_ = _e428;
                } else {
                    phi_1011_ = 0i;
                }
                let _e461 = phi_1011_;
                if (_e437 > 0i) {
                    phi_1016_ = _e437;
                } else {
                    phi_1016_ = 0i;
                }
                let _e464 = phi_1016_;
                if (_e461 < _e458) {
                    phi_1021_ = _e461;
                } else {
                    phi_1021_ = _e458;
                }
                let _e467 = phi_1021_;
                if (_e464 < _e458) {
                    phi_1026_ = _e464;
                } else {
                    phi_1026_ = _e458;
                }
                let _e470 = phi_1026_;
                let _e471 = bitcast<u32>(_e467);
                let _e473 = (_e428 + 1i);
                let _e474 = (_e437 + 1i);
                if (_e473 > 0i) {
                    phi_1035_ = _e473;
                } else {
                    phi_1035_ = 0i;
                }
                let _e477 = phi_1035_;
                if (_e474 > 0i) {
                    phi_1040_ = _e474;
                } else {
                    phi_1040_ = 0i;
                }
                let _e480 = phi_1040_;
                if (_e477 < _e458) {
                    phi_1045_ = _e477;
                } else {
                    phi_1045_ = _e458;
                }
                let _e483 = phi_1045_;
                if (_e480 < _e458) {
                    phi_1050_ = _e480;
                } else {
                    phi_1050_ = _e458;
                }
                let _e486 = phi_1050_;
                let _e487 = bitcast<u32>(_e483);
                let _e489 = (bitcast<u32>(_e470) * _e450);
                let _e490 = (bitcast<u32>(_e486) * _e450);
                let _e495 = ((_e489 + _e471) + _e456);
                let _e496 = ((_e489 + _e487) + _e456);
                let _e497 = ((_e490 + _e471) + _e456);
                let _e498 = ((_e490 + _e487) + _e456);
                if (_e495 < _e58) {
                } else {
                    return;
                }
                let _e502 = map.member[(0u + _e495)];
                if (_e496 < _e58) {
                } else {
                    return;
                }
                let _e514 = map.member[(0u + _e496)];
                if (_e497 < _e58) {
                } else {
                    return;
                }
                let _e530 = map.member[(0u + _e497)];
                if (_e498 < _e58) {
                } else {
                    return;
                }
                let _e546 = map.member[(0u + _e498)];
                let _e560 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e502.x * _e440) + (_e514.x * _e442)) + (_e530.x * _e444)) + (_e546.x * _e445)), ((((_e502.y * _e440) + (_e514.y * _e442)) + (_e530.y * _e444)) + (_e546.y * _e445)), ((((_e502.z * _e440) + (_e514.z * _e442)) + (_e530.z * _e444)) + (_e546.z * _e445)), ((((_e502.w * _e440) + (_e514.w * _e442)) + (_e530.w * _e444)) + (_e546.w * _e445))), _e358);
                let _e562 = p.member.epsilon;
                if (_e560 <= _e562) {
                    phi_1145_ = true;
                } else {
                    phi_1145_ = (_e560 >= (1f - _e562));
                }
                let _e567 = phi_1145_;
                if ((bitcast<u32>(_e560) & 2147483647u) > 2139095040u) {
                    phi_1153_ = true;
                } else {
                    phi_1153_ = !(_e567);
                }
                let _e573 = phi_1153_;
                if _e573 {
                    if (_e560 > 0f) {
                        if (_e560 < 1f) {
                            phi_1165_ = false;
                        } else {
                            phi_1165_ = true;
                        }
                        let _e577 = phi_1165_;
                        phi_1166_ = _e577;
                    } else {
                        phi_1166_ = true;
                    }
                    let _e579 = phi_1166_;
                    if _e579 {
                        phi_1170_ = 0.5f;
                    } else {
                        phi_1170_ = _e560;
                    }
                    let _e581 = phi_1170_;
                    phi_1178_ = evaluate_Verdict(_e581, true);
                } else {
                    if (_e560 > 0.5f) {
                        phi_1176_ = 1f;
                    } else {
                        phi_1176_ = 0f;
                    }
                    let _e585 = phi_1176_;
                    phi_1178_ = evaluate_Verdict(_e585, false);
                }
                let _e588 = phi_1178_;
                phi_1183_ = evaluate_Verdict(_e588.visibility, _e588.is_doubted);
            } else {
                phi_1183_ = evaluate_Verdict(0.5f, true);
            }
            let _e594 = phi_1183_;
            phi_1184_ = _e594;
        }
        let _e596 = phi_1184_;
        visibility.member[_e66.first_primitive] = _e596.visibility;
        phi_1188_ = _e596.is_doubted;
        phi_1189_ = _e66.first_primitive;
    } else {
        phi_1188_ = false;
        phi_1189_ = 0u;
    }
    let _e601 = phi_1188_;
    let _e603 = phi_1189_;
    if (_e53 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e601 {
        let _e607 = atomicAdd((&shared_[0u]), 1u);
        phi_1200_ = _e607;
    } else {
        phi_1200_ = 0u;
    }
    let _e609 = phi_1200_;
    workgroupBarrier();
    if (_e53 == 0u) {
        let _e613 = atomicLoad((&shared_[0u]));
        let _e614 = atomicAdd((&list.member[3u]), _e613);
        atomicStore((&shared_[1u]), _e614);
    }
    workgroupBarrier();
    if _e601 {
        let _e617 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e617) + _e609)]), _e603);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
