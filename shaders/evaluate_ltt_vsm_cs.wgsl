struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
    member: array<f32>,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_45 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_160_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_152_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_153_ = false;
        } else {
            phi_152_ = lt_bvh_traverse_Tree();
            phi_153_ = true;
        }
        let _e54 = phi_152_;
        let _e56 = phi_153_;
        phi_154_ = _e54;
        phi_155_ = _e56;
    } else {
        phi_154_ = lt_bvh_traverse_Tree();
        phi_155_ = true;
    }
    let _e58 = phi_154_;
    let _e60 = phi_155_;
    if _e60 {
        phi_160_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_160_ = _e58;
    }
    let _e65 = phi_160_;
    return lt_bvh_traverse_Tree(_e65.root, _e65.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_306_: bool;
    var phi_310_: f32;
    var phi_322_: bool;
    var phi_329_: f32;
    var phi_344_: f32;
    var phi_345_: f32;
    var phi_346_: f32;

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
            let _e51 = phi_186_;
            phi_187_ = _e51;
        }
        let _e53 = phi_187_;
        phi_188_ = _e53;
    }
    let _e55 = phi_188_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_206_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_5.x;
            }
            let _e63 = phi_204_;
            phi_205_ = _e63;
        }
        let _e65 = phi_205_;
        phi_206_ = _e65;
    }
    let _e67 = phi_206_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_224_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_5.y;
            }
            let _e75 = phi_222_;
            phi_223_ = _e75;
        }
        let _e77 = phi_223_;
        phi_224_ = _e77;
    }
    let _e79 = phi_224_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_242_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_5.z;
            }
            let _e87 = phi_240_;
            phi_241_ = _e87;
        }
        let _e89 = phi_241_;
        phi_242_ = _e89;
    }
    let _e91 = phi_242_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_260_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_5.w;
            }
            let _e99 = phi_258_;
            phi_259_ = _e99;
        }
        let _e101 = phi_259_;
        phi_260_ = _e101;
    }
    let _e103 = phi_260_;
    let _e104 = (_e67 - _e55);
    let _e105 = (_e79 - _e55);
    let _e106 = (_e91 - _e55);
    let _e107 = (_e103 - _e55);
    let _e108 = (*param_4);
    let _e119 = ((((_e104 * param_6.x) + (_e105 * param_6.y)) + (_e106 * param_6.z)) + (_e107 * param_6.w));
    let _e120 = (_e104 - _e119);
    let _e121 = (_e105 - _e119);
    let _e122 = (_e106 - _e119);
    let _e123 = (_e107 - _e119);
    let _e138 = (((((_e120 * _e120) * param_6.x) + ((_e121 * _e121) * param_6.y)) + ((_e122 * _e122) * param_6.z)) + ((_e123 * _e123) * param_6.w));
    if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
        phi_306_ = true;
    } else {
        let _e142 = (_e108 > _e138);
        if _e142 {
        }
        phi_306_ = _e142;
    }
    let _e144 = phi_306_;
    if _e144 {
        phi_310_ = _e108;
    } else {
        phi_310_ = _e138;
    }
    let _e146 = phi_310_;
    let _e147 = -(_e119);
    if (_e147 <= 0f) {
        let _e151 = ((bitcast<u32>(_e146) & 2147483647u) > 2139095040u);
        if _e151 {
        }
        phi_322_ = _e151;
    } else {
        phi_322_ = true;
    }
    let _e153 = phi_322_;
    if _e153 {
        phi_329_ = (_e146 / (_e146 + (_e147 * _e147)));
    } else {
        phi_329_ = 1f;
    }
    let _e158 = phi_329_;
    if ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u) {
        phi_346_ = _e158;
    } else {
        if (_e158 < 0f) {
            phi_345_ = 0f;
        } else {
            if (_e158 > 1f) {
                phi_344_ = 1f;
            } else {
                phi_344_ = _e158;
            }
            let _e165 = phi_344_;
            phi_345_ = _e165;
        }
        let _e167 = phi_345_;
        phi_346_ = _e167;
    }
    let _e169 = phi_346_;
    return _e169;
}

fn function_() {
    var local_1: f32;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_404_: bool;
    var phi_474_: bool;
    var phi_475_: bool;
    var phi_486_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_487_: bool;
    var phi_488_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_489_: bool;
    var phi_496_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_500_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_574_: bool;
    var phi_583_: bool;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_596_: bool;
    var phi_597_: bool;
    var phi_598_: bool;
    var phi_602_: bool;
    var phi_692_: f32;
    var phi_695_: f32;
    var phi_724_: f32;
    var phi_729_: f32;
    var phi_730_: bool;
    var phi_731_: f32;
    var phi_732_: bool;
    var phi_736_: f32;
    var phi_756_: f32;
    var phi_761_: f32;
    var phi_762_: bool;
    var phi_763_: f32;
    var phi_764_: bool;
    var phi_768_: f32;
    var phi_816_: i32;
    var phi_821_: i32;
    var phi_826_: i32;
    var phi_831_: i32;
    var phi_840_: i32;
    var phi_845_: i32;
    var phi_850_: i32;
    var phi_855_: i32;
    var phi_908_: bool;
    var phi_916_: bool;
    var phi_928_: bool;
    var phi_929_: bool;
    var phi_933_: f32;
    var phi_939_: f32;
    var phi_941_: evaluate_Verdict;
    var phi_951_: u32;
    var phi_960_: f32;
    var phi_962_: evaluate_Verdict;
    var phi_963_: bool;
    var phi_964_: evaluate_Verdict;
    var phi_965_: bool;
    var phi_970_: evaluate_Verdict;
    var phi_975_: evaluate_Verdict;
    var phi_976_: evaluate_Verdict;
    var phi_980_: bool;
    var phi_981_: u32;
    var phi_992_: u32;
    var phi_1009_: u32;

    let _e42 = id_1;
    let _e43 = local_2;
    let _e48 = arrayLength((&map.member));
    let _e53 = p.member.size[0u];
    let _e55 = p.member.size[1u];
    let _e56 = lt_shaders_entry_pixel_index(_e42, _e53, _e55);
    if (bitcast<i32>(_e56.root) != 0i) {
        let _e63 = p.member.projection;
        let _e64 = lt_math_OneLevel(_e63);
        let _e68 = samples.member[_e56.first_primitive].normal[0u];
        let _e70 = global[0u];
        if (_e68 == _e70) {
            let _e73 = samples.member[_e56.first_primitive].normal[1u];
            let _e75 = global[1u];
            if (_e73 == _e75) {
                let _e78 = samples.member[_e56.first_primitive].normal[2u];
                let _e80 = global[2u];
                phi_397_ = (_e78 == _e80);
                phi_398_ = false;
            } else {
                phi_397_ = bool();
                phi_398_ = true;
            }
            let _e83 = phi_397_;
            let _e85 = phi_398_;
            phi_399_ = _e83;
            phi_400_ = _e85;
        } else {
            phi_399_ = bool();
            phi_400_ = true;
        }
        let _e87 = phi_399_;
        let _e89 = phi_400_;
        if _e89 {
            phi_404_ = false;
        } else {
            phi_404_ = _e87;
        }
        let _e91 = phi_404_;
        if !(_e91) {
            let _e94 = samples.member[_e56.first_primitive].position;
            let _e96 = p.member.light.place;
            let _e102 = p.member.light.place[3u];
            let _e109 = (_e96.x - (_e94.x * _e102));
            let _e110 = (_e96.y - (_e94.y * _e102));
            let _e111 = (_e96.z - (_e94.z * _e102));
            let _e113 = samples.member[_e56.first_primitive].normal;
            if ((((_e113.x * _e109) + (_e113.y * _e110)) + (_e113.z * _e111)) > 0f) {
                let _e127 = (((_e109 * _e109) + (_e110 * _e110)) + (_e111 * _e111));
                let _e129 = p.member.light.axis;
                let _e141 = p.member.light.place[3u];
                if (_e141 == 0f) {
                    phi_475_ = true;
                } else {
                    let _e144 = p.member.light.range_squared;
                    if (_e127 <= _e144) {
                        let _e147 = p.member.light.cos_outer;
                        phi_474_ = (-((((_e109 * _e129.x) + (_e110 * _e129.y)) + (_e111 * _e129.z))) >= (_e147 * sqrt(_e127)));
                    } else {
                        phi_474_ = false;
                    }
                    let _e152 = phi_474_;
                    phi_475_ = _e152;
                }
                let _e154 = phi_475_;
                if _e154 {
                    let _e156 = samples.member[_e56.first_primitive].flags;
                    let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e164.unnamed.visibility, false), _e164.unnamed_1);
                    phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e170.unnamed, ((_e156 & 1u) == 0u));
                    phi_487_ = false;
                } else {
                    phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_487_ = true;
                }
                let _e175 = phi_486_;
                let _e177 = phi_487_;
                phi_488_ = _e175;
                phi_489_ = _e177;
            } else {
                phi_488_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_489_ = true;
            }
            let _e179 = phi_488_;
            let _e181 = phi_489_;
            if _e181 {
                let _e187 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e187.unnamed.visibility, false), _e187.unnamed_1);
                phi_496_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e193.unnamed, true);
            } else {
                phi_496_ = _e179;
            }
            let _e198 = phi_496_;
            phi_500_ = _e198;
        } else {
            let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e204.unnamed.visibility, false), _e204.unnamed_1);
            phi_500_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e210.unnamed, true);
        }
        let _e215 = phi_500_;
        if _e215.unnamed_1 {
            phi_976_ = evaluate_Verdict(_e215.unnamed.visibility, _e215.unnamed.is_doubted);
        } else {
            let _e223 = samples.member[_e56.first_primitive].position;
            let _e241 = ((((_e64.projection.row_w.x * _e223.x) + (_e64.projection.row_w.y * _e223.y)) + (_e64.projection.row_w.z * _e223.z)) + (_e64.projection.row_w.w * 1f));
            let _e255 = (((((_e64.projection.row_x.x * _e223.x) + (_e64.projection.row_x.y * _e223.y)) + (_e64.projection.row_x.z * _e223.z)) + (_e64.projection.row_x.w * 1f)) / _e241);
            let _e269 = (((((_e64.projection.row_y.x * _e223.x) + (_e64.projection.row_y.y * _e223.y)) + (_e64.projection.row_y.z * _e223.z)) + (_e64.projection.row_y.w * 1f)) / _e241);
            let _e282 = ((((_e64.projection.row_z.x * _e223.x) + (_e64.projection.row_z.y * _e223.y)) + (_e64.projection.row_z.z * _e223.z)) + (_e64.projection.row_z.w * 1f));
            if (_e241 > 0f) {
                if (_e255 >= 0f) {
                    phi_574_ = (_e255 <= 1f);
                } else {
                    phi_574_ = false;
                }
                let _e287 = phi_574_;
                if _e287 {
                    if (_e269 >= 0f) {
                        phi_583_ = (_e269 <= 1f);
                    } else {
                        phi_583_ = false;
                    }
                    let _e291 = phi_583_;
                    if _e291 {
                        if (_e282 >= 0f) {
                            phi_592_ = (_e282 <= 1f);
                        } else {
                            phi_592_ = false;
                        }
                        let _e295 = phi_592_;
                        phi_593_ = _e295;
                        phi_594_ = false;
                    } else {
                        phi_593_ = bool();
                        phi_594_ = true;
                    }
                    let _e297 = phi_593_;
                    let _e299 = phi_594_;
                    phi_595_ = _e297;
                    phi_596_ = _e299;
                } else {
                    phi_595_ = bool();
                    phi_596_ = true;
                }
                let _e301 = phi_595_;
                let _e303 = phi_596_;
                phi_597_ = _e301;
                phi_598_ = _e303;
            } else {
                phi_597_ = bool();
                phi_598_ = true;
            }
            let _e305 = phi_597_;
            let _e307 = phi_598_;
            if _e307 {
                phi_602_ = false;
            } else {
                phi_602_ = _e305;
            }
            let _e309 = phi_602_;
            if _e309 {
                if (0f > 0f) {
                    let _e312 = samples.member[_e56.first_primitive].normal;
                    let _e314 = p.member.map_size;
                    let _e384 = ((abs(((((_e63.row_x.x * _e312.x) + (_e63.row_x.y * _e312.y)) + (_e63.row_x.z * _e312.z)) / (((_e63.row_x.x * _e63.row_x.x) + (_e63.row_x.y * _e63.row_x.y)) + (_e63.row_x.z * _e63.row_x.z)))) + abs(((((_e63.row_y.x * _e312.x) + (_e63.row_y.y * _e312.y)) + (_e63.row_y.z * _e312.z)) / (((_e63.row_y.x * _e63.row_y.x) + (_e63.row_y.y * _e63.row_y.y)) + (_e63.row_y.z * _e63.row_y.z))))) / (abs(((((_e63.row_z.x * _e312.x) + (_e63.row_z.y * _e312.y)) + (_e63.row_z.z * _e312.z)) / (((_e63.row_z.x * _e63.row_z.x) + (_e63.row_z.y * _e63.row_z.y)) + (_e63.row_z.z * _e63.row_z.z)))) * f32(_e314)));
                    if (_e384 < 0.002f) {
                        phi_692_ = _e384;
                    } else {
                        phi_692_ = 0.002f;
                    }
                    let _e387 = phi_692_;
                    phi_695_ = (_e282 - (0f * _e387));
                } else {
                    phi_695_ = _e282;
                }
                let _e391 = phi_695_;
                let _e393 = p.member.map_size;
                let _e394 = f32(_e393);
                let _e397 = ((_e255 * _e394) - 0.5f);
                let _e398 = ((_e269 * _e394) - 0.5f);
                if (_e397 > -8388608f) {
                    let _e410 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e410 > _e397) {
                        phi_724_ = 1f;
                    } else {
                        phi_724_ = 0f;
                    }
                    let _e413 = phi_724_;
                    if (_e397 < 8388608f) {
                        phi_729_ = (_e410 - _e413);
                        phi_730_ = false;
                    } else {
                        phi_729_ = f32();
                        phi_730_ = true;
                    }
                    let _e416 = phi_729_;
                    let _e418 = phi_730_;
                    phi_731_ = _e416;
                    phi_732_ = _e418;
                } else {
                    phi_731_ = f32();
                    phi_732_ = true;
                }
                let _e420 = phi_731_;
                let _e422 = phi_732_;
                if _e422 {
                    phi_736_ = _e397;
                } else {
                    phi_736_ = _e420;
                }
                let _e424 = phi_736_;
                if (_e398 > -8388608f) {
                    let _e436 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e436 > _e398) {
                        phi_756_ = 1f;
                    } else {
                        phi_756_ = 0f;
                    }
                    let _e439 = phi_756_;
                    if (_e398 < 8388608f) {
                        phi_761_ = (_e436 - _e439);
                        phi_762_ = false;
                    } else {
                        phi_761_ = f32();
                        phi_762_ = true;
                    }
                    let _e442 = phi_761_;
                    let _e444 = phi_762_;
                    phi_763_ = _e442;
                    phi_764_ = _e444;
                } else {
                    phi_763_ = f32();
                    phi_764_ = true;
                }
                let _e446 = phi_763_;
                let _e448 = phi_764_;
                if _e448 {
                    phi_768_ = _e398;
                } else {
                    phi_768_ = _e446;
                }
                let _e450 = phi_768_;
                let _e451 = (_e397 - _e424);
                let _e452 = (_e398 - _e450);
                let _e461 = select(0i, select(select(i32(_e424), i32(-2147483648), (_e424 < bitcast<f32>(3472883712u))), 2147483647i, (_e424 > bitcast<f32>(1325400063u))), (_e424 == _e424));
                let _e470 = select(0i, select(select(i32(_e450), i32(-2147483648), (_e450 < bitcast<f32>(3472883712u))), 2147483647i, (_e450 > bitcast<f32>(1325400063u))), (_e450 == _e450));
                let _e481 = p.member.test;
                let _e482 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e481);
                let _e484 = p.member.map_size;
                local_1 = _e482;
                let _e486 = ((0u * _e484) * _e484);
                let _e488 = (bitcast<i32>(_e484) - 1i);
                if (_e461 > 0i) {
                    phi_816_ = _e461;
                } else {
                    phi_816_ = 0i;
                }
                let _e491 = phi_816_;
                if (_e470 > 0i) {
                    phi_821_ = _e470;
                } else {
                    phi_821_ = 0i;
                }
                let _e494 = phi_821_;
                if (_e491 < _e488) {
                    phi_826_ = _e491;
                } else {
                    phi_826_ = _e488;
                }
                let _e497 = phi_826_;
                if (_e494 < _e488) {
                    phi_831_ = _e494;
                } else {
                    phi_831_ = _e488;
                }
                let _e500 = phi_831_;
                let _e501 = bitcast<u32>(_e497);
                let _e503 = (_e461 + 1i);
                let _e504 = (_e470 + 1i);
                if (_e503 > 0i) {
                    phi_840_ = _e503;
                } else {
                    phi_840_ = 0i;
                }
                let _e507 = phi_840_;
                if (_e504 > 0i) {
                    phi_845_ = _e504;
                } else {
                    phi_845_ = 0i;
                }
                let _e510 = phi_845_;
                if (_e507 < _e488) {
                    phi_850_ = _e507;
                } else {
                    phi_850_ = _e488;
                }
                let _e513 = phi_850_;
                if (_e510 < _e488) {
                    phi_855_ = _e510;
                } else {
                    phi_855_ = _e488;
                }
                let _e516 = phi_855_;
                let _e517 = bitcast<u32>(_e513);
                let _e519 = (bitcast<u32>(_e500) * _e484);
                let _e520 = (bitcast<u32>(_e516) * _e484);
                let _e525 = ((_e519 + _e501) + _e486);
                let _e526 = ((_e519 + _e517) + _e486);
                let _e527 = ((_e520 + _e501) + _e486);
                let _e528 = ((_e520 + _e517) + _e486);
                if (_e525 < _e48) {
                } else {
                    return;
                }
                let _e532 = map.member[(0u + _e525)];
                if (_e526 < _e48) {
                } else {
                    return;
                }
                let _e536 = map.member[(0u + _e526)];
                if (_e527 < _e48) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e527)];
                if (_e528 < _e48) {
                } else {
                    return;
                }
                let _e544 = map.member[(0u + _e528)];
                let _e546 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e532, _e536, _e540, _e544), vec4<f32>(((1f - _e451) * (1f - _e452)), (_e451 * (1f - _e452)), ((1f - _e451) * _e452), (_e451 * _e452)), _e391);
                let _e550 = p.member.epsilon;
                if (_e546 <= _e550) {
                    phi_908_ = true;
                } else {
                    phi_908_ = (_e546 >= (1f - _e550));
                }
                let _e555 = phi_908_;
                if ((bitcast<u32>(_e546) & 2147483647u) > 2139095040u) {
                    phi_916_ = true;
                } else {
                    phi_916_ = !(_e555);
                }
                let _e561 = phi_916_;
                if _e561 {
                    if (_e546 > 0f) {
                        if (_e546 < 1f) {
                            phi_928_ = false;
                        } else {
                            phi_928_ = true;
                        }
                        let _e565 = phi_928_;
                        phi_929_ = _e565;
                    } else {
                        phi_929_ = true;
                    }
                    let _e567 = phi_929_;
                    if _e567 {
                        phi_933_ = 0.5f;
                    } else {
                        phi_933_ = _e546;
                    }
                    let _e569 = phi_933_;
                    phi_941_ = evaluate_Verdict(_e569, true);
                } else {
                    if (_e546 > 0.5f) {
                        phi_939_ = 1f;
                    } else {
                        phi_939_ = 0f;
                    }
                    let _e573 = phi_939_;
                    phi_941_ = evaluate_Verdict(_e573, false);
                }
                let _e576 = phi_941_;
                let _e579 = (_e576.visibility < 0.5f);
                if _e576.is_doubted {
                    phi_964_ = evaluate_Verdict();
                    phi_965_ = true;
                } else {
                    if _e579 {
                        phi_951_ = 2u;
                    } else {
                        phi_951_ = 1u;
                    }
                    let _e581 = phi_951_;
                    if ((0u & _e581) != 0u) {
                        if _e579 {
                            phi_960_ = 0.000000059604645f;
                        } else {
                            phi_960_ = 0.99999994f;
                        }
                        let _e585 = phi_960_;
                        phi_962_ = evaluate_Verdict(_e585, true);
                        phi_963_ = false;
                    } else {
                        phi_962_ = evaluate_Verdict();
                        phi_963_ = true;
                    }
                    let _e588 = phi_962_;
                    let _e590 = phi_963_;
                    phi_964_ = _e588;
                    phi_965_ = _e590;
                }
                let _e592 = phi_964_;
                let _e594 = phi_965_;
                if _e594 {
                    phi_970_ = evaluate_Verdict(_e576.visibility, _e576.is_doubted);
                } else {
                    phi_970_ = _e592;
                }
                let _e597 = phi_970_;
                phi_975_ = evaluate_Verdict(_e597.visibility, _e597.is_doubted);
            } else {
                phi_975_ = evaluate_Verdict(0.5f, true);
            }
            let _e603 = phi_975_;
            phi_976_ = _e603;
        }
        let _e605 = phi_976_;
        visibility.member[_e56.first_primitive] = _e605.visibility;
        phi_980_ = _e605.is_doubted;
        phi_981_ = _e56.first_primitive;
    } else {
        phi_980_ = false;
        phi_981_ = 0u;
    }
    let _e610 = phi_980_;
    let _e612 = phi_981_;
    if (_e43 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e610 {
        let _e616 = atomicAdd((&shared_[0u]), 1u);
        phi_992_ = _e616;
    } else {
        phi_992_ = 0u;
    }
    let _e618 = phi_992_;
    workgroupBarrier();
    if (_e43 == 0u) {
        let _e622 = atomicLoad((&shared_[0u]));
        let _e623 = atomicAdd((&list.member[3u]), _e622);
        atomicStore((&shared_[1u]), _e623);
    }
    workgroupBarrier();
    if _e610 {
        if false {
            phi_1009_ = (_e612 | 2147483648u);
        } else {
            phi_1009_ = _e612;
        }
        let _e627 = phi_1009_;
        let _e629 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e629) + _e618)]), _e627);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
