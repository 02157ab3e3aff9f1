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

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_47 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_53 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_41;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_53;
@group(0) @binding(5) 
var<storage> levels: type_47;
@group(0) @binding(2) 
var<storage> map: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e56 = phi_162_;
        let _e58 = phi_163_;
        phi_164_ = _e56;
        phi_165_ = _e58;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e60 = phi_164_;
    let _e62 = phi_165_;
    if _e62 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e60;
    }
    let _e67 = phi_170_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_227_: bool;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: bool;
    var phi_254_: f32;
    var phi_255_: bool;
    var phi_293_: vec2<f32>;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_367_: f32;

    let _e46 = (*param_4);
    let _e47 = (1f - _e46);
    let _e56 = (0.5f * _e46);
    let _e57 = ((param_5.x * _e47) + _e56);
    let _e58 = ((param_5.y * _e47) + _e56);
    let _e60 = ((param_5.w * _e47) + _e56);
    let _e62 = (_e58 - (_e57 * _e57));
    let _e64 = (((param_5.z * _e47) + _e56) - (_e57 * _e58));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_221_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_220_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_219_ = 1f;
            } else {
                phi_219_ = param_6;
            }
            let _e76 = phi_219_;
            phi_220_ = _e76;
        }
        let _e78 = phi_220_;
        phi_221_ = _e78;
    }
    let _e80 = phi_221_;
    if (_e57 == _e60) {
        phi_227_ = (_e57 > 0.5f);
    } else {
        phi_227_ = false;
    }
    let _e84 = phi_227_;
    if _e84 {
        if (_e80 > 0f) {
            if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
                phi_251_ = _e57;
            } else {
                if (_e57 < 0f) {
                    phi_250_ = 0f;
                } else {
                    if (_e57 > 1f) {
                        phi_249_ = 1f;
                    } else {
                        phi_249_ = _e57;
                    }
                    let _e92 = phi_249_;
                    phi_250_ = _e92;
                }
                let _e94 = phi_250_;
                phi_251_ = _e94;
            }
            let _e96 = phi_251_;
            phi_252_ = _e96;
            phi_253_ = false;
        } else {
            phi_252_ = f32();
            phi_253_ = true;
        }
        let _e98 = phi_252_;
        let _e100 = phi_253_;
        phi_254_ = _e98;
        phi_255_ = _e100;
    } else {
        phi_254_ = f32();
        phi_255_ = true;
    }
    let _e102 = phi_254_;
    let _e104 = phi_255_;
    if _e104 {
        let _e105 = (_e64 / _e62);
        let _e106 = (_e80 - _e57);
        let _e112 = (((((_e80 * _e80) - _e58) - (_e105 * _e106)) * _e62) / (((_e60 - (_e58 * _e58)) * _e62) - (_e64 * _e64)));
        let _e115 = ((_e106 / _e62) - (_e105 * _e112));
        let _e121 = ((0.5f * _e115) / _e112);
        let _e124 = ((_e121 * _e121) - (((1f - (_e115 * _e57)) - (_e112 * _e58)) / _e112));
        if (_e124 >= 0f) {
            let _e126 = sqrt(_e124);
            phi_293_ = vec2<f32>((-(_e121) - _e126), (-(_e121) + _e126));
        } else {
            phi_293_ = vec2(bitcast<f32>((bitcast<u32>(_e124) | 2143289344u)));
        }
        let _e137 = phi_293_;
        if (_e80 <= _e137.x) {
            phi_366_ = 1f;
        } else {
            if (_e80 > _e137.y) {
                let _e150 = (((_e58 - (_e57 * (_e137.x + _e137.y))) + (_e137.x * _e137.y)) / ((_e80 - _e137.x) * (_e80 - _e137.y)));
                if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
                    phi_329_ = _e150;
                } else {
                    if (_e150 < 0f) {
                        phi_328_ = 0f;
                    } else {
                        if (_e150 > 1f) {
                            phi_327_ = 1f;
                        } else {
                            phi_327_ = _e150;
                        }
                        let _e157 = phi_327_;
                        phi_328_ = _e157;
                    }
                    let _e159 = phi_328_;
                    phi_329_ = _e159;
                }
                let _e161 = phi_329_;
                phi_365_ = _e161;
            } else {
                if (_e80 > _e137.x) {
                    let _e172 = (1f - (((_e58 - (_e57 * (_e80 + _e137.y))) + (_e80 * _e137.y)) / ((_e137.x - _e80) * (_e137.x - _e137.y))));
                    if ((bitcast<u32>(_e172) & 2147483647u) > 2139095040u) {
                        phi_360_ = _e172;
                    } else {
                        if (_e172 < 0f) {
                            phi_359_ = 0f;
                        } else {
                            if (_e172 > 1f) {
                                phi_358_ = 1f;
                            } else {
                                phi_358_ = _e172;
                            }
                            let _e179 = phi_358_;
                            phi_359_ = _e179;
                        }
                        let _e181 = phi_359_;
                        phi_360_ = _e181;
                    }
                    let _e183 = phi_360_;
                    phi_364_ = _e183;
                } else {
                    phi_364_ = bitcast<f32>((bitcast<u32>(_e137.x) | 2143289344u));
                }
                let _e188 = phi_364_;
                phi_365_ = _e188;
            }
            let _e190 = phi_365_;
            phi_366_ = _e190;
        }
        let _e192 = phi_366_;
        phi_367_ = _e192;
    } else {
        phi_367_ = _e102;
    }
    let _e194 = phi_367_;
    return _e194;
}

fn function_() {
    var local_1: f32;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_430_: bool;
    var phi_474_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_478_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_498_: lt_math_LightPoint;
    var phi_501_: u32;
    var phi_503_: lt_math_LevelPoint;
    var phi_589_: bool;
    var phi_598_: bool;
    var phi_607_: bool;
    var phi_608_: bool;
    var phi_609_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_617_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_655_: bool;
    var phi_664_: lt_math_LightPoint;
    var phi_665_: u32;
    var phi_666_: lt_math_LevelPoint;
    var phi_667_: bool;
    var phi_499_: lt_math_LightPoint;
    var phi_502_: u32;
    var phi_504_: lt_math_LevelPoint;
    var phi_668_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_708_: bool;
    var phi_709_: bool;
    var phi_710_: bool;
    var phi_711_: bool;
    var phi_715_: bool;
    var phi_797_: f32;
    var phi_913_: f32;
    var phi_914_: f32;
    var phi_917_: f32;
    var phi_946_: f32;
    var phi_951_: f32;
    var phi_952_: bool;
    var phi_953_: f32;
    var phi_954_: bool;
    var phi_958_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_984_: bool;
    var phi_985_: f32;
    var phi_986_: bool;
    var phi_990_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1039_: i32;
    var phi_1044_: i32;
    var phi_1049_: i32;
    var phi_1054_: i32;
    var phi_1063_: i32;
    var phi_1068_: i32;
    var phi_1073_: i32;
    var phi_1078_: i32;
    var phi_1173_: bool;
    var phi_1181_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1198_: f32;
    var phi_1204_: f32;
    var phi_1206_: evaluate_Verdict;
    var phi_1211_: evaluate_Verdict;
    var phi_1212_: evaluate_Verdict;
    var phi_1216_: bool;
    var phi_1217_: u32;
    var phi_1228_: u32;

    let _e44 = id_1;
    let _e45 = local_5;
    let _e50 = arrayLength((&map.member));
    let _e55 = arrayLength((&levels.member));
    let _e58 = p.member.size[0u];
    let _e60 = p.member.size[1u];
    let _e61 = lt_shaders_entry_pixel_index(_e44, _e58, _e60);
    if (bitcast<i32>(_e61.root) != 0i) {
        let _e68 = p.member.level_count;
        let _e70 = p.member.light;
        let _e73 = samples.member[_e61.first_primitive].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[_e61.first_primitive].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[_e61.first_primitive].normal[2u];
                let _e85 = global[2u];
                phi_423_ = (_e83 == _e85);
                phi_424_ = false;
            } else {
                phi_423_ = bool();
                phi_424_ = true;
            }
            let _e88 = phi_423_;
            let _e90 = phi_424_;
            phi_425_ = _e88;
            phi_426_ = _e90;
        } else {
            phi_425_ = bool();
            phi_426_ = true;
        }
        let _e92 = phi_425_;
        let _e94 = phi_426_;
        if _e94 {
            phi_430_ = false;
        } else {
            phi_430_ = _e92;
        }
        let _e96 = phi_430_;
        if !(_e96) {
            let _e99 = samples.member[_e61.first_primitive].normal;
            let _e101 = samples.member[_e61.first_primitive].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[_e61.first_primitive].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_474_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_474_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_474_;
            phi_478_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_478_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_478_;
        if _e176.unnamed_1 {
            phi_1212_ = evaluate_Verdict(_e176.unnamed.visibility, _e176.unnamed.is_doubted);
        } else {
            let _e184 = samples.member[_e61.first_primitive].position;
            let _e186 = p.member.map_size;
            let _e188 = (0.5f / f32(_e186));
            let _e195 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e202 = lt_math_LightPoint(vec2<f32>(_e195.uv.x, 0f), _e195.depth, _e195.is_inside);
            let _e206 = lt_math_LightPoint(_e202.uv, 0f, _e202.is_inside);
            phi_498_ = lt_math_LightPoint();
            phi_501_ = 0u;
            phi_503_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e206.uv, _e206.depth, false));
            loop {
                let _e213 = phi_498_;
                let _e215 = phi_501_;
                let _e217 = phi_503_;
                local_2 = _e217;
                local_3 = _e217;
                local_4 = _e217;
                if (_e215 < _e68) {
                    if _e217.point.is_inside {
                        phi_664_ = lt_math_LightPoint();
                        phi_665_ = u32();
                        phi_666_ = lt_math_LevelPoint();
                        phi_667_ = false;
                    } else {
                        if (_e215 < _e55) {
                        } else {
                            return;
                        }
                        let _e228 = levels.member[(0u + _e215)].row_w;
                        let _e239 = ((((_e228.x * _e184.x) + (_e228.y * _e184.y)) + (_e228.z * _e184.z)) + (_e228.w * 1f));
                        let _e241 = levels.member[(0u + _e215)].row_x;
                        let _e253 = (((((_e241.x * _e184.x) + (_e241.y * _e184.y)) + (_e241.z * _e184.z)) + (_e241.w * 1f)) / _e239);
                        let _e255 = levels.member[(0u + _e215)].row_y;
                        let _e267 = (((((_e255.x * _e184.x) + (_e255.y * _e184.y)) + (_e255.z * _e184.z)) + (_e255.w * 1f)) / _e239);
                        let _e269 = levels.member[(0u + _e215)].row_z;
                        let _e280 = ((((_e269.x * _e184.x) + (_e269.y * _e184.y)) + (_e269.z * _e184.z)) + (_e269.w * 1f));
                        if (_e239 > 0f) {
                            if (_e253 >= 0f) {
                                phi_589_ = (_e253 <= 1f);
                            } else {
                                phi_589_ = false;
                            }
                            let _e285 = phi_589_;
                            if _e285 {
                                if (_e267 >= 0f) {
                                    phi_598_ = (_e267 <= 1f);
                                } else {
                                    phi_598_ = false;
                                }
                                let _e289 = phi_598_;
                                if _e289 {
                                    if (_e280 >= 0f) {
                                        phi_607_ = (_e280 <= 1f);
                                    } else {
                                        phi_607_ = false;
                                    }
                                    let _e293 = phi_607_;
                                    phi_608_ = _e293;
                                    phi_609_ = false;
                                } else {
                                    phi_608_ = bool();
                                    phi_609_ = true;
                                }
                                let _e295 = phi_608_;
                                let _e297 = phi_609_;
                                phi_610_ = _e295;
                                phi_611_ = _e297;
                            } else {
                                phi_610_ = bool();
                                phi_611_ = true;
                            }
                            let _e299 = phi_610_;
                            let _e301 = phi_611_;
                            phi_612_ = _e299;
                            phi_613_ = _e301;
                        } else {
                            phi_612_ = bool();
                            phi_613_ = true;
                        }
                        let _e303 = phi_612_;
                        let _e305 = phi_613_;
                        if _e305 {
                            phi_617_ = false;
                        } else {
                            phi_617_ = _e303;
                        }
                        let _e307 = phi_617_;
                        if _e307 {
                            if (_e253 >= _e188) {
                                if (_e253 <= (1f - _e188)) {
                                    if (_e267 >= _e188) {
                                        phi_644_ = (_e267 <= (1f - _e188));
                                        phi_645_ = false;
                                    } else {
                                        phi_644_ = bool();
                                        phi_645_ = true;
                                    }
                                    let _e315 = phi_644_;
                                    let _e317 = phi_645_;
                                    phi_646_ = _e315;
                                    phi_647_ = _e317;
                                } else {
                                    phi_646_ = bool();
                                    phi_647_ = true;
                                }
                                let _e319 = phi_646_;
                                let _e321 = phi_647_;
                                phi_648_ = _e319;
                                phi_649_ = _e321;
                            } else {
                                phi_648_ = bool();
                                phi_649_ = true;
                            }
                            let _e323 = phi_648_;
                            let _e325 = phi_649_;
                            phi_650_ = _e323;
                            phi_651_ = _e325;
                        } else {
                            phi_650_ = bool();
                            phi_651_ = true;
                        }
                        let _e327 = phi_650_;
                        let _e329 = phi_651_;
                        if _e329 {
                            phi_655_ = false;
                        } else {
                            phi_655_ = _e327;
                        }
                        let _e331 = phi_655_;
                        let _e338 = lt_math_LightPoint(vec2<f32>(_e253, _e213.uv.y), _e213.depth, _e213.is_inside);
                        let _e345 = lt_math_LightPoint(vec2<f32>(_e338.uv.x, _e267), _e338.depth, _e338.is_inside);
                        let _e349 = lt_math_LightPoint(_e345.uv, _e280, _e345.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e349.depth, _e331);
                        phi_664_ = _e353;
                        phi_665_ = (_e215 + 1u);
                        phi_666_ = lt_math_LevelPoint(_e215, _e353);
                        phi_667_ = true;
                    }
                    let _e357 = phi_664_;
                    let _e359 = phi_665_;
                    let _e361 = phi_666_;
                    let _e363 = phi_667_;
                    phi_499_ = _e357;
                    phi_502_ = _e359;
                    phi_504_ = _e361;
                    phi_668_ = _e363;
                } else {
                    phi_499_ = lt_math_LightPoint();
                    phi_502_ = u32();
                    phi_504_ = lt_math_LevelPoint();
                    phi_668_ = false;
                }
                let _e365 = phi_499_;
                let _e367 = phi_502_;
                let _e369 = phi_504_;
                let _e371 = phi_668_;
                continue;
                continuing {
                    phi_498_ = _e365;
                    phi_501_ = _e367;
                    phi_503_ = _e369;
                    break if !(_e371);
                }
            }
            let _e374 = local_2;
            if _e374.point.is_inside {
                if (0f > 0f) {
                    let _e380 = local_3;
                    if (_e380.level < _e55) {
                    } else {
                        return;
                    }
                    let _e385 = levels.member[(0u + _e380.level)];
                    let _e391 = global[0u];
                    if (_e385.row_w.x == _e391) {
                        let _e394 = global[1u];
                        if (_e385.row_w.y == _e394) {
                            let _e397 = global[2u];
                            phi_708_ = (_e385.row_w.z == _e397);
                            phi_709_ = false;
                        } else {
                            phi_708_ = bool();
                            phi_709_ = true;
                        }
                        let _e400 = phi_708_;
                        let _e402 = phi_709_;
                        phi_710_ = _e400;
                        phi_711_ = _e402;
                    } else {
                        phi_710_ = bool();
                        phi_711_ = true;
                    }
                    let _e404 = phi_710_;
                    let _e406 = phi_711_;
                    if _e406 {
                        phi_715_ = false;
                    } else {
                        phi_715_ = _e404;
                    }
                    let _e408 = phi_715_;
                    if _e408 {
                        let _e410 = samples.member[_e61.first_primitive].normal;
                        let _e412 = p.member.map_size;
                        let _e482 = ((abs(((((_e385.row_x.x * _e410.x) + (_e385.row_x.y * _e410.y)) + (_e385.row_x.z * _e410.z)) / (((_e385.row_x.x * _e385.row_x.x) + (_e385.row_x.y * _e385.row_x.y)) + (_e385.row_x.z * _e385.row_x.z)))) + abs(((((_e385.row_y.x * _e410.x) + (_e385.row_y.y * _e410.y)) + (_e385.row_y.z * _e410.z)) / (((_e385.row_y.x * _e385.row_y.x) + (_e385.row_y.y * _e385.row_y.y)) + (_e385.row_y.z * _e385.row_y.z))))) / (abs(((((_e385.row_z.x * _e410.x) + (_e385.row_z.y * _e410.y)) + (_e385.row_z.z * _e410.z)) / (((_e385.row_z.x * _e385.row_z.x) + (_e385.row_z.y * _e385.row_z.y)) + (_e385.row_z.z * _e385.row_z.z)))) * f32(_e412)));
                        if (_e482 < 0.002f) {
                            phi_797_ = _e482;
                        } else {
                            phi_797_ = 0.002f;
                        }
                        let _e485 = phi_797_;
                        phi_914_ = _e485;
                    } else {
                        let _e487 = p.member.map_size;
                        let _e493 = samples.member[_e61.first_primitive].position;
                        let _e504 = ((((_e385.row_w.x * _e493.x) + (_e385.row_w.y * _e493.y)) + (_e385.row_w.z * _e493.z)) + _e385.row_w.w);
                        let _e517 = ((_e385.row_x.x - (_e385.row_w.x * _e374.point.uv.x)) / _e504);
                        let _e518 = ((_e385.row_x.y - (_e385.row_w.y * _e374.point.uv.x)) / _e504);
                        let _e519 = ((_e385.row_x.z - (_e385.row_w.z * _e374.point.uv.x)) / _e504);
                        let _e532 = ((_e385.row_y.x - (_e385.row_w.x * _e374.point.uv.y)) / _e504);
                        let _e533 = ((_e385.row_y.y - (_e385.row_w.y * _e374.point.uv.y)) / _e504);
                        let _e534 = ((_e385.row_y.z - (_e385.row_w.z * _e374.point.uv.y)) / _e504);
                        let _e540 = samples.member[_e61.first_primitive].normal;
                        let _e545 = ((_e533 * _e540.z) - (_e540.y * _e534));
                        let _e550 = ((_e534 * _e540.x) - (_e540.z * _e532));
                        let _e555 = ((_e532 * _e540.y) - (_e540.x * _e533));
                        let _e557 = samples.member[_e61.first_primitive].normal;
                        let _e562 = ((_e518 * _e557.z) - (_e557.y * _e519));
                        let _e567 = ((_e519 * _e557.x) - (_e557.z * _e517));
                        let _e572 = ((_e517 * _e557.y) - (_e557.x * _e518));
                        let _e599 = ((abs(((((_e385.row_z.x * _e545) + (_e385.row_z.y * _e550)) + (_e385.row_z.z * _e555)) / (((_e517 * _e545) + (_e518 * _e550)) + (_e519 * _e555)))) + abs(((((_e385.row_z.x * _e562) + (_e385.row_z.y * _e567)) + (_e385.row_z.z * _e572)) / (((_e532 * _e562) + (_e533 * _e567)) + (_e534 * _e572))))) / f32(_e487));
                        if (_e599 < 0.002f) {
                            phi_913_ = _e599;
                        } else {
                            phi_913_ = 0.002f;
                        }
                        let _e602 = phi_913_;
                        phi_914_ = _e602;
                    }
                    let _e604 = phi_914_;
                    phi_917_ = (_e374.point.depth - (0f * _e604));
                } else {
                    phi_917_ = _e374.point.depth;
                }
                let _e608 = phi_917_;
                let _e614 = p.member.map_size;
                let _e615 = f32(_e614);
                let _e618 = ((_e374.point.uv.x * _e615) - 0.5f);
                let _e619 = ((_e374.point.uv.y * _e615) - 0.5f);
                if (_e618 > -8388608f) {
                    let _e631 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e631 > _e618) {
                        phi_946_ = 1f;
                    } else {
                        phi_946_ = 0f;
                    }
                    let _e634 = phi_946_;
                    if (_e618 < 8388608f) {
                        phi_951_ = (_e631 - _e634);
                        phi_952_ = false;
                    } else {
                        phi_951_ = f32();
                        phi_952_ = true;
                    }
                    let _e637 = phi_951_;
                    let _e639 = phi_952_;
                    phi_953_ = _e637;
                    phi_954_ = _e639;
                } else {
                    phi_953_ = f32();
                    phi_954_ = true;
                }
                let _e641 = phi_953_;
                let _e643 = phi_954_;
                if _e643 {
                    phi_958_ = _e618;
                } else {
                    phi_958_ = _e641;
                }
                let _e645 = phi_958_;
                if (_e619 > -8388608f) {
                    let _e657 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e657 > _e619) {
                        phi_978_ = 1f;
                    } else {
                        phi_978_ = 0f;
                    }
                    let _e660 = phi_978_;
                    if (_e619 < 8388608f) {
                        phi_983_ = (_e657 - _e660);
                        phi_984_ = false;
                    } else {
                        phi_983_ = f32();
                        phi_984_ = true;
                    }
                    let _e663 = phi_983_;
                    let _e665 = phi_984_;
                    phi_985_ = _e663;
                    phi_986_ = _e665;
                } else {
                    phi_985_ = f32();
                    phi_986_ = true;
                }
                let _e667 = phi_985_;
                let _e669 = phi_986_;
                if _e669 {
                    phi_990_ = _e619;
                } else {
                    phi_990_ = _e667;
                }
                let _e671 = phi_990_;
                let _e672 = (_e618 - _e645);
                let _e673 = (_e619 - _e671);
                let _e682 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < bitcast<f32>(3472883712u))), 2147483647i, (_e645 > bitcast<f32>(1325400063u))), (_e645 == _e645));
                let _e691 = select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671));
                let _e694 = ((1f - _e672) * (1f - _e673));
                let _e696 = (_e672 * (1f - _e673));
                let _e698 = ((1f - _e672) * _e673);
                let _e699 = (_e672 * _e673);
                let _e701 = p.member.test;
                let _e702 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e701);
                let _e704 = p.member.map_size;
                let _e706 = local_4;
                local_1 = _e702;
                let _e709 = ((_e706.level * _e704) * _e704);
                let _e711 = (bitcast<i32>(_e704) - 1i);
                if (_e682 > 0i) {
                    phi_1039_ = _e682;
                } else {
                    phi_1039_ = 0i;
                }
                let _e714 = phi_1039_;
                if (_e691 > 0i) {
                    phi_1044_ = _e691;
                } else {
                    phi_1044_ = 0i;
                }
                let _e717 = phi_1044_;
                if (_e714 < _e711) {
                    phi_1049_ = _e714;
                } else {
                    phi_1049_ = _e711;
                }
                let _e720 = phi_1049_;
                if (_e717 < _e711) {
                    phi_1054_ = _e717;
                } else {
                    phi_1054_ = _e711;
                }
                let _e723 = phi_1054_;
                let _e724 = bitcast<u32>(_e720);
                let _e726 = (_e682 + 1i);
                let _e727 = (_e691 + 1i);
                if (_e726 > 0i) {
                    phi_1063_ = _e726;
                } else {
                    phi_1063_ = 0i;
                }
                let _e730 = phi_1063_;
                if (_e727 > 0i) {
                    phi_1068_ = _e727;
                } else {
                    phi_1068_ = 0i;
                }
                let _e733 = phi_1068_;
                if (_e730 < _e711) {
                    phi_1073_ = _e730;
                } else {
                    phi_1073_ = _e711;
                }
                let _e736 = phi_1073_;
                if (_e733 < _e711) {
                    phi_1078_ = _e733;
                } else {
                    phi_1078_ = _e711;
                }
                let _e739 = phi_1078_;
                let _e740 = bitcast<u32>(_e736);
                let _e742 = (bitcast<u32>(_e723) * _e704);
                let _e743 = (bitcast<u32>(_e739) * _e704);
                let _e748 = ((_e742 + _e724) + _e709);
                let _e749 = ((_e742 + _e740) + _e709);
                let _e750 = ((_e743 + _e724) + _e709);
                let _e751 = ((_e743 + _e740) + _e709);
                if (_e748 < _e50) {
                } else {
                    return;
                }
                let _e755 = map.member[(0u + _e748)];
                if (_e749 < _e50) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e749)];
                if (_e750 < _e50) {
                } else {
                    return;
                }
                let _e783 = map.member[(0u + _e750)];
                if (_e751 < _e50) {
                } else {
                    return;
                }
                let _e799 = map.member[(0u + _e751)];
                let _e813 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e755.x * _e694) + (_e767.x * _e696)) + (_e783.x * _e698)) + (_e799.x * _e699)), ((((_e755.y * _e694) + (_e767.y * _e696)) + (_e783.y * _e698)) + (_e799.y * _e699)), ((((_e755.z * _e694) + (_e767.z * _e696)) + (_e783.z * _e698)) + (_e799.z * _e699)), ((((_e755.w * _e694) + (_e767.w * _e696)) + (_e783.w * _e698)) + (_e799.w * _e699))), _e608);
                let _e815 = p.member.epsilon;
                if (_e813 <= _e815) {
                    phi_1173_ = true;
                } else {
                    phi_1173_ = (_e813 >= (1f - _e815));
                }
                let _e820 = phi_1173_;
                if ((bitcast<u32>(_e813) & 2147483647u) > 2139095040u) {
                    phi_1181_ = true;
                } else {
                    phi_1181_ = !(_e820);
                }
                let _e826 = phi_1181_;
                if _e826 {
                    if (_e813 > 0f) {
                        if (_e813 < 1f) {
                            phi_1193_ = false;
                        } else {
                            phi_1193_ = true;
                        }
                        let _e830 = phi_1193_;
                        phi_1194_ = _e830;
                    } else {
                        phi_1194_ = true;
                    }
                    let _e832 = phi_1194_;
                    if _e832 {
                        phi_1198_ = 0.5f;
                    } else {
                        phi_1198_ = _e813;
                    }
                    let _e834 = phi_1198_;
                    phi_1206_ = evaluate_Verdict(_e834, true);
                } else {
                    if (_e813 > 0.5f) {
                        phi_1204_ = 1f;
                    } else {
                        phi_1204_ = 0f;
                    }
                    let _e838 = phi_1204_;
                    phi_1206_ = evaluate_Verdict(_e838, false);
                }
                let _e841 = phi_1206_;
                phi_1211_ = evaluate_Verdict(_e841.visibility, _e841.is_doubted);
            } else {
                phi_1211_ = evaluate_Verdict(0.5f, true);
            }
            let _e847 = phi_1211_;
            phi_1212_ = _e847;
        }
        let _e849 = phi_1212_;
        visibility.member[_e61.first_primitive] = _e849.visibility;
        phi_1216_ = _e849.is_doubted;
        phi_1217_ = _e61.first_primitive;
    } else {
        phi_1216_ = false;
        phi_1217_ = 0u;
    }
    let _e854 = phi_1216_;
    let _e856 = phi_1217_;
    if (_e45 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e854 {
        let _e860 = atomicAdd((&shared_[0u]), 1u);
        phi_1228_ = _e860;
    } else {
        phi_1228_ = 0u;
    }
    let _e862 = phi_1228_;
    workgroupBarrier();
    if (_e45 == 0u) {
        let _e866 = atomicLoad((&shared_[0u]));
        let _e867 = atomicAdd((&list.member[3u]), _e866);
        atomicStore((&shared_[1u]), _e867);
    }
    workgroupBarrier();
    if _e854 {
        let _e870 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e870) + _e862)]), _e856);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
