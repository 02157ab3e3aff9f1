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
        let _e50 = phi_146_;
        let _e52 = phi_147_;
        phi_148_ = _e50;
        phi_149_ = _e52;
    } else {
        phi_148_ = lt_bvh_traverse_Tree();
        phi_149_ = true;
    }
    let _e54 = phi_148_;
    let _e56 = phi_149_;
    if _e56 {
        phi_154_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_154_ = _e54;
    }
    let _e61 = phi_154_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_300_: bool;
    var phi_304_: f32;
    var phi_316_: bool;
    var phi_323_: f32;
    var phi_338_: f32;
    var phi_339_: f32;
    var phi_340_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_182_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_181_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_180_ = 1f;
            } else {
                phi_180_ = param_7;
            }
            let _e47 = phi_180_;
            phi_181_ = _e47;
        }
        let _e49 = phi_181_;
        phi_182_ = _e49;
    }
    let _e51 = phi_182_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_200_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_199_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_198_ = 1f;
            } else {
                phi_198_ = param_5.x;
            }
            let _e59 = phi_198_;
            phi_199_ = _e59;
        }
        let _e61 = phi_199_;
        phi_200_ = _e61;
    }
    let _e63 = phi_200_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_218_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_5.y;
            }
            let _e71 = phi_216_;
            phi_217_ = _e71;
        }
        let _e73 = phi_217_;
        phi_218_ = _e73;
    }
    let _e75 = phi_218_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_236_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_235_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_234_ = 1f;
            } else {
                phi_234_ = param_5.z;
            }
            let _e83 = phi_234_;
            phi_235_ = _e83;
        }
        let _e85 = phi_235_;
        phi_236_ = _e85;
    }
    let _e87 = phi_236_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_254_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_253_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_252_ = 1f;
            } else {
                phi_252_ = param_5.w;
            }
            let _e95 = phi_252_;
            phi_253_ = _e95;
        }
        let _e97 = phi_253_;
        phi_254_ = _e97;
    }
    let _e99 = phi_254_;
    let _e100 = (_e63 - _e51);
    let _e101 = (_e75 - _e51);
    let _e102 = (_e87 - _e51);
    let _e103 = (_e99 - _e51);
    let _e104 = (*param_4);
    let _e115 = ((((_e100 * param_6.x) + (_e101 * param_6.y)) + (_e102 * param_6.z)) + (_e103 * param_6.w));
    let _e116 = (_e100 - _e115);
    let _e117 = (_e101 - _e115);
    let _e118 = (_e102 - _e115);
    let _e119 = (_e103 - _e115);
    let _e134 = (((((_e116 * _e116) * param_6.x) + ((_e117 * _e117) * param_6.y)) + ((_e118 * _e118) * param_6.z)) + ((_e119 * _e119) * param_6.w));
    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
        phi_300_ = true;
    } else {
        let _e138 = (_e104 > _e134);
        if _e138 {
        }
        phi_300_ = _e138;
    }
    let _e140 = phi_300_;
    if _e140 {
        phi_304_ = _e104;
    } else {
        phi_304_ = _e134;
    }
    let _e142 = phi_304_;
    let _e143 = -(_e115);
    if (_e143 <= 0f) {
        let _e147 = ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u);
        if _e147 {
        }
        phi_316_ = _e147;
    } else {
        phi_316_ = true;
    }
    let _e149 = phi_316_;
    if _e149 {
        phi_323_ = (_e142 / (_e142 + (_e143 * _e143)));
    } else {
        phi_323_ = 1f;
    }
    let _e154 = phi_323_;
    if ((bitcast<u32>(_e154) & 2147483647u) > 2139095040u) {
        phi_340_ = _e154;
    } else {
        if (_e154 < 0f) {
            phi_339_ = 0f;
        } else {
            if (_e154 > 1f) {
                phi_338_ = 1f;
            } else {
                phi_338_ = _e154;
            }
            let _e161 = phi_338_;
            phi_339_ = _e161;
        }
        let _e163 = phi_339_;
        phi_340_ = _e163;
    }
    let _e165 = phi_340_;
    return _e165;
}

fn function_() {
    var local_1: f32;
    var phi_391_: bool;
    var phi_392_: bool;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_398_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_480_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_481_: bool;
    var phi_482_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_483_: bool;
    var phi_490_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_494_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_568_: bool;
    var phi_577_: bool;
    var phi_586_: bool;
    var phi_587_: bool;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_591_: bool;
    var phi_592_: bool;
    var phi_596_: bool;
    var phi_686_: f32;
    var phi_689_: f32;
    var phi_718_: f32;
    var phi_723_: f32;
    var phi_724_: bool;
    var phi_725_: f32;
    var phi_726_: bool;
    var phi_730_: f32;
    var phi_750_: f32;
    var phi_755_: f32;
    var phi_756_: bool;
    var phi_757_: f32;
    var phi_758_: bool;
    var phi_762_: f32;
    var phi_810_: i32;
    var phi_815_: i32;
    var phi_820_: i32;
    var phi_825_: i32;
    var phi_834_: i32;
    var phi_839_: i32;
    var phi_844_: i32;
    var phi_849_: i32;
    var phi_900_: bool;
    var phi_908_: bool;
    var phi_920_: bool;
    var phi_921_: bool;
    var phi_925_: f32;
    var phi_931_: f32;
    var phi_933_: evaluate_Verdict;
    var phi_938_: evaluate_Verdict;
    var phi_939_: evaluate_Verdict;
    var phi_943_: bool;
    var phi_944_: u32;
    var phi_955_: u32;

    let _e38 = id_1;
    let _e39 = local_2;
    let _e44 = arrayLength((&map.member));
    let _e49 = p.member.size[0u];
    let _e51 = p.member.size[1u];
    let _e52 = lt_shaders_entry_pixel_index(_e38, _e49, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        let _e59 = p.member.projection;
        let _e60 = lt_math_OneLevel(_e59);
        let _e64 = samples.member[_e52.first_primitive].normal[0u];
        let _e66 = global[0u];
        if (_e64 == _e66) {
            let _e69 = samples.member[_e52.first_primitive].normal[1u];
            let _e71 = global[1u];
            if (_e69 == _e71) {
                let _e74 = samples.member[_e52.first_primitive].normal[2u];
                let _e76 = global[2u];
                phi_391_ = (_e74 == _e76);
                phi_392_ = false;
            } else {
                phi_391_ = bool();
                phi_392_ = true;
            }
            let _e79 = phi_391_;
            let _e81 = phi_392_;
            phi_393_ = _e79;
            phi_394_ = _e81;
        } else {
            phi_393_ = bool();
            phi_394_ = true;
        }
        let _e83 = phi_393_;
        let _e85 = phi_394_;
        if _e85 {
            phi_398_ = false;
        } else {
            phi_398_ = _e83;
        }
        let _e87 = phi_398_;
        if !(_e87) {
            let _e90 = samples.member[_e52.first_primitive].position;
            let _e92 = p.member.light.place;
            let _e98 = p.member.light.place[3u];
            let _e105 = (_e92.x - (_e90.x * _e98));
            let _e106 = (_e92.y - (_e90.y * _e98));
            let _e107 = (_e92.z - (_e90.z * _e98));
            let _e109 = samples.member[_e52.first_primitive].normal;
            if ((((_e109.x * _e105) + (_e109.y * _e106)) + (_e109.z * _e107)) > 0f) {
                let _e123 = (((_e105 * _e105) + (_e106 * _e106)) + (_e107 * _e107));
                let _e125 = p.member.light.axis;
                let _e137 = p.member.light.place[3u];
                if (_e137 == 0f) {
                    phi_469_ = true;
                } else {
                    let _e140 = p.member.light.range_squared;
                    if (_e123 <= _e140) {
                        let _e143 = p.member.light.cos_outer;
                        phi_468_ = (-((((_e105 * _e125.x) + (_e106 * _e125.y)) + (_e107 * _e125.z))) >= (_e143 * sqrt(_e123)));
                    } else {
                        phi_468_ = false;
                    }
                    let _e148 = phi_468_;
                    phi_469_ = _e148;
                }
                let _e150 = phi_469_;
                if _e150 {
                    let _e152 = samples.member[_e52.first_primitive].flags;
                    let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                    phi_480_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, ((_e152 & 1u) == 0u));
                    phi_481_ = false;
                } else {
                    phi_480_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_481_ = true;
                }
                let _e171 = phi_480_;
                let _e173 = phi_481_;
                phi_482_ = _e171;
                phi_483_ = _e173;
            } else {
                phi_482_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_483_ = true;
            }
            let _e175 = phi_482_;
            let _e177 = phi_483_;
            if _e177 {
                let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e189 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e183.unnamed.visibility, false), _e183.unnamed_1);
                phi_490_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e189.unnamed, true);
            } else {
                phi_490_ = _e175;
            }
            let _e194 = phi_490_;
            phi_494_ = _e194;
        } else {
            let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e206 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e200.unnamed.visibility, false), _e200.unnamed_1);
            phi_494_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e206.unnamed, true);
        }
        let _e211 = phi_494_;
        if _e211.unnamed_1 {
            phi_939_ = evaluate_Verdict(_e211.unnamed.visibility, _e211.unnamed.is_doubted);
        } else {
            let _e219 = samples.member[_e52.first_primitive].position;
            let _e237 = ((((_e60.projection.row_w.x * _e219.x) + (_e60.projection.row_w.y * _e219.y)) + (_e60.projection.row_w.z * _e219.z)) + (_e60.projection.row_w.w * 1f));
            let _e251 = (((((_e60.projection.row_x.x * _e219.x) + (_e60.projection.row_x.y * _e219.y)) + (_e60.projection.row_x.z * _e219.z)) + (_e60.projection.row_x.w * 1f)) / _e237);
            let _e265 = (((((_e60.projection.row_y.x * _e219.x) + (_e60.projection.row_y.y * _e219.y)) + (_e60.projection.row_y.z * _e219.z)) + (_e60.projection.row_y.w * 1f)) / _e237);
            let _e278 = ((((_e60.projection.row_z.x * _e219.x) + (_e60.projection.row_z.y * _e219.y)) + (_e60.projection.row_z.z * _e219.z)) + (_e60.projection.row_z.w * 1f));
            if (_e237 > 0f) {
                if (_e251 >= 0f) {
                    phi_568_ = (_e251 <= 1f);
                } else {
                    phi_568_ = false;
                }
                let _e283 = phi_568_;
                if _e283 {
                    if (_e265 >= 0f) {
                        phi_577_ = (_e265 <= 1f);
                    } else {
                        phi_577_ = false;
                    }
                    let _e287 = phi_577_;
                    if _e287 {
                        if (_e278 >= 0f) {
                            phi_586_ = (_e278 <= 1f);
                        } else {
                            phi_586_ = false;
                        }
                        let _e291 = phi_586_;
                        phi_587_ = _e291;
                        phi_588_ = false;
                    } else {
                        phi_587_ = bool();
                        phi_588_ = true;
                    }
                    let _e293 = phi_587_;
                    let _e295 = phi_588_;
                    phi_589_ = _e293;
                    phi_590_ = _e295;
                } else {
                    phi_589_ = bool();
                    phi_590_ = true;
                }
                let _e297 = phi_589_;
                let _e299 = phi_590_;
                phi_591_ = _e297;
                phi_592_ = _e299;
            } else {
                phi_591_ = bool();
                phi_592_ = true;
            }
            let _e301 = phi_591_;
            let _e303 = phi_592_;
            if _e303 {
                phi_596_ = false;
            } else {
                phi_596_ = _e301;
            }
            let _e305 = phi_596_;
            if _e305 {
                if (0f > 0f) {
                    let _e308 = samples.member[_e52.first_primitive].normal;
                    let _e310 = p.member.map_size;
                    let _e380 = ((abs(((((_e59.row_x.x * _e308.x) + (_e59.row_x.y * _e308.y)) + (_e59.row_x.z * _e308.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e308.x) + (_e59.row_y.y * _e308.y)) + (_e59.row_y.z * _e308.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e308.x) + (_e59.row_z.y * _e308.y)) + (_e59.row_z.z * _e308.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e310)));
                    if (_e380 < 0.002f) {
                        phi_686_ = _e380;
                    } else {
                        phi_686_ = 0.002f;
                    }
                    let _e383 = phi_686_;
                    phi_689_ = (_e278 - (0f * _e383));
                } else {
                    phi_689_ = _e278;
                }
                let _e387 = phi_689_;
                let _e389 = p.member.map_size;
                let _e390 = f32(_e389);
                let _e393 = ((_e251 * _e390) - 0.5f);
                let _e394 = ((_e265 * _e390) - 0.5f);
                if (_e393 > -8388608f) {
                    let _e406 = f32(select(0i, select(select(i32(_e393), i32(-2147483648), (_e393 < bitcast<f32>(3472883712u))), 2147483647i, (_e393 > bitcast<f32>(1325400063u))), (_e393 == _e393)));
                    if (_e406 > _e393) {
                        phi_718_ = 1f;
                    } else {
                        phi_718_ = 0f;
                    }
                    let _e409 = phi_718_;
                    if (_e393 < 8388608f) {
                        phi_723_ = (_e406 - _e409);
                        phi_724_ = false;
                    } else {
                        phi_723_ = f32();
                        phi_724_ = true;
                    }
                    let _e412 = phi_723_;
                    let _e414 = phi_724_;
                    phi_725_ = _e412;
                    phi_726_ = _e414;
                } else {
                    phi_725_ = f32();
                    phi_726_ = true;
                }
                let _e416 = phi_725_;
                let _e418 = phi_726_;
                if _e418 {
                    phi_730_ = _e393;
                } else {
                    phi_730_ = _e416;
                }
                let _e420 = phi_730_;
                if (_e394 > -8388608f) {
                    let _e432 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e432 > _e394) {
                        phi_750_ = 1f;
                    } else {
                        phi_750_ = 0f;
                    }
                    let _e435 = phi_750_;
                    if (_e394 < 8388608f) {
                        phi_755_ = (_e432 - _e435);
                        phi_756_ = false;
                    } else {
                        phi_755_ = f32();
                        phi_756_ = true;
                    }
                    let _e438 = phi_755_;
                    let _e440 = phi_756_;
                    phi_757_ = _e438;
                    phi_758_ = _e440;
                } else {
                    phi_757_ = f32();
                    phi_758_ = true;
                }
                let _e442 = phi_757_;
                let _e444 = phi_758_;
                if _e444 {
                    phi_762_ = _e394;
                } else {
                    phi_762_ = _e442;
                }
                let _e446 = phi_762_;
                let _e447 = (_e393 - _e420);
                let _e448 = (_e394 - _e446);
                let _e457 = select(0i, select(select(i32(_e420), i32(-2147483648), (_e420 < bitcast<f32>(3472883712u))), 2147483647i, (_e420 > bitcast<f32>(1325400063u))), (_e420 == _e420));
                let _e466 = select(0i, select(select(i32(_e446), i32(-2147483648), (_e446 < bitcast<f32>(3472883712u))), 2147483647i, (_e446 > bitcast<f32>(1325400063u))), (_e446 == _e446));
                let _e477 = p.member.test;
                let _e478 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local_1 = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e457 > 0i) {
                    phi_810_ = _e457;
                } else {
                    phi_810_ = 0i;
                }
                let _e487 = phi_810_;
                if (_e466 > 0i) {
                    phi_815_ = _e466;
                } else {
                    phi_815_ = 0i;
                }
                let _e490 = phi_815_;
                if (_e487 < _e484) {
                    phi_820_ = _e487;
                } else {
                    phi_820_ = _e484;
                }
                let _e493 = phi_820_;
                if (_e490 < _e484) {
                    phi_825_ = _e490;
                } else {
                    phi_825_ = _e484;
                }
                let _e496 = phi_825_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e457 + 1i);
                let _e500 = (_e466 + 1i);
                if (_e499 > 0i) {
                    phi_834_ = _e499;
                } else {
                    phi_834_ = 0i;
                }
                let _e503 = phi_834_;
                if (_e500 > 0i) {
                    phi_839_ = _e500;
                } else {
                    phi_839_ = 0i;
                }
                let _e506 = phi_839_;
                if (_e503 < _e484) {
                    phi_844_ = _e503;
                } else {
                    phi_844_ = _e484;
                }
                let _e509 = phi_844_;
                if (_e506 < _e484) {
                    phi_849_ = _e506;
                } else {
                    phi_849_ = _e484;
                }
                let _e512 = phi_849_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (bitcast<u32>(_e496) * _e480);
                let _e516 = (bitcast<u32>(_e512) * _e480);
                let _e521 = ((_e515 + _e497) + _e482);
                let _e522 = ((_e515 + _e513) + _e482);
                let _e523 = ((_e516 + _e497) + _e482);
                let _e524 = ((_e516 + _e513) + _e482);
                if (_e521 < _e44) {
                } else {
                    return;
                }
                let _e528 = map.member[(0u + _e521)];
                if (_e522 < _e44) {
                } else {
                    return;
                }
                let _e532 = map.member[(0u + _e522)];
                if (_e523 < _e44) {
                } else {
                    return;
                }
                let _e536 = map.member[(0u + _e523)];
                if (_e524 < _e44) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e524)];
                let _e542 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e528, _e532, _e536, _e540), vec4<f32>(((1f - _e447) * (1f - _e448)), (_e447 * (1f - _e448)), ((1f - _e447) * _e448), (_e447 * _e448)), _e387);
                let _e544 = p.member.epsilon;
                if (_e542 <= _e544) {
                    phi_900_ = true;
                } else {
                    phi_900_ = (_e542 >= (1f - _e544));
                }
                let _e549 = phi_900_;
                if ((bitcast<u32>(_e542) & 2147483647u) > 2139095040u) {
                    phi_908_ = true;
                } else {
                    phi_908_ = !(_e549);
                }
                let _e555 = phi_908_;
                if _e555 {
                    if (_e542 > 0f) {
                        if (_e542 < 1f) {
                            phi_920_ = false;
                        } else {
                            phi_920_ = true;
                        }
                        let _e559 = phi_920_;
                        phi_921_ = _e559;
                    } else {
                        phi_921_ = true;
                    }
                    let _e561 = phi_921_;
                    if _e561 {
                        phi_925_ = 0.5f;
                    } else {
                        phi_925_ = _e542;
                    }
                    let _e563 = phi_925_;
                    phi_933_ = evaluate_Verdict(_e563, true);
                } else {
                    if (_e542 > 0.5f) {
                        phi_931_ = 1f;
                    } else {
                        phi_931_ = 0f;
                    }
                    let _e567 = phi_931_;
                    phi_933_ = evaluate_Verdict(_e567, false);
                }
                let _e570 = phi_933_;
                phi_938_ = evaluate_Verdict(_e570.visibility, _e570.is_doubted);
            } else {
                phi_938_ = evaluate_Verdict(0.5f, true);
            }
            let _e576 = phi_938_;
            phi_939_ = _e576;
        }
        let _e578 = phi_939_;
        visibility.member[_e52.first_primitive] = _e578.visibility;
        phi_943_ = _e578.is_doubted;
        phi_944_ = _e52.first_primitive;
    } else {
        phi_943_ = false;
        phi_944_ = 0u;
    }
    let _e583 = phi_943_;
    let _e585 = phi_944_;
    if (_e39 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e583 {
        let _e589 = atomicAdd((&shared_[0u]), 1u);
        phi_955_ = _e589;
    } else {
        phi_955_ = 0u;
    }
    let _e591 = phi_955_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e595 = atomicLoad((&shared_[0u]));
        let _e596 = atomicAdd((&list.member[3u]), _e595);
        atomicStore((&shared_[1u]), _e596);
    }
    workgroupBarrier();
    if _e583 {
        let _e599 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e599) + _e591)]), _e585);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
