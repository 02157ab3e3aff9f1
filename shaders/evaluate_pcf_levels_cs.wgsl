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

struct type_29 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_35 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_148_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_140_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_141_ = false;
        } else {
            phi_140_ = lt_bvh_traverse_Tree();
            phi_141_ = true;
        }
        let _e52 = phi_140_;
        let _e54 = phi_141_;
        phi_142_ = _e52;
        phi_143_ = _e54;
    } else {
        phi_142_ = lt_bvh_traverse_Tree();
        phi_143_ = true;
    }
    let _e56 = phi_142_;
    let _e58 = phi_143_;
    if _e58 {
        phi_148_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_148_ = _e56;
    }
    let _e63 = phi_148_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_175_: f32;
    var phi_176_: f32;
    var phi_177_: f32;
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_289_: f32;
    var phi_290_: f32;
    var phi_291_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_327_: f32;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_355_: f32;
    var phi_356_: f32;
    var phi_357_: f32;

    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_177_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_176_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_175_ = 1f;
            } else {
                phi_175_ = param_5.x;
            }
            let _e50 = phi_175_;
            phi_176_ = _e50;
        }
        let _e52 = phi_176_;
        phi_177_ = _e52;
    }
    let _e54 = phi_177_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_195_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_194_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_193_ = 1f;
            } else {
                phi_193_ = param_5.y;
            }
            let _e62 = phi_193_;
            phi_194_ = _e62;
        }
        let _e64 = phi_194_;
        phi_195_ = _e64;
    }
    let _e66 = phi_195_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_213_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_5.z;
            }
            let _e74 = phi_211_;
            phi_212_ = _e74;
        }
        let _e76 = phi_212_;
        phi_213_ = _e76;
    }
    let _e78 = phi_213_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_231_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_5.w;
            }
            let _e86 = phi_229_;
            phi_230_ = _e86;
        }
        let _e88 = phi_230_;
        phi_231_ = _e88;
    }
    let _e90 = phi_231_;
    let _e91 = (*param_4);
    let _e92 = (_e54 + _e91);
    let _e93 = (_e66 + _e91);
    let _e94 = (_e78 + _e91);
    let _e95 = (_e90 + _e91);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_253_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_7;
            }
            let _e102 = phi_251_;
            phi_252_ = _e102;
        }
        let _e104 = phi_252_;
        phi_253_ = _e104;
    }
    let _e106 = phi_253_;
    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
        phi_272_ = _e92;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_271_ = _e106;
        } else {
            if (_e92 < _e106) {
                phi_270_ = 0f;
            } else {
                phi_270_ = 1f;
            }
            let _e115 = phi_270_;
            phi_271_ = _e115;
        }
        let _e117 = phi_271_;
        phi_272_ = _e117;
    }
    let _e119 = phi_272_;
    if ((bitcast<u32>(_e93) & 2147483647u) > 2139095040u) {
        phi_291_ = _e93;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_290_ = _e106;
        } else {
            if (_e93 < _e106) {
                phi_289_ = 0f;
            } else {
                phi_289_ = 1f;
            }
            let _e128 = phi_289_;
            phi_290_ = _e128;
        }
        let _e130 = phi_290_;
        phi_291_ = _e130;
    }
    let _e132 = phi_291_;
    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
        phi_310_ = _e94;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_309_ = _e106;
        } else {
            if (_e94 < _e106) {
                phi_308_ = 0f;
            } else {
                phi_308_ = 1f;
            }
            let _e141 = phi_308_;
            phi_309_ = _e141;
        }
        let _e143 = phi_309_;
        phi_310_ = _e143;
    }
    let _e145 = phi_310_;
    if ((bitcast<u32>(_e95) & 2147483647u) > 2139095040u) {
        phi_329_ = _e95;
    } else {
        if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
            phi_328_ = _e106;
        } else {
            if (_e95 < _e106) {
                phi_327_ = 0f;
            } else {
                phi_327_ = 1f;
            }
            let _e154 = phi_327_;
            phi_328_ = _e154;
        }
        let _e156 = phi_328_;
        phi_329_ = _e156;
    }
    let _e158 = phi_329_;
    let _e169 = ((((_e119 * param_6.x) + (_e132 * param_6.y)) + (_e145 * param_6.z)) + (_e158 * param_6.w));
    if ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u) {
        phi_357_ = _e169;
    } else {
        if (_e169 < 0f) {
            phi_356_ = 0f;
        } else {
            if (_e169 > 1f) {
                phi_355_ = 1f;
            } else {
                phi_355_ = _e169;
            }
            let _e176 = phi_355_;
            phi_356_ = _e176;
        }
        let _e178 = phi_356_;
        phi_357_ = _e178;
    }
    let _e180 = phi_357_;
    return _e180;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_8: f32, param_9: f32) -> f32 {
    var phi_365_: f32;

    if (param_8 < param_9) {
        phi_365_ = param_8;
    } else {
        phi_365_ = param_9;
    }
    let _e43 = phi_365_;
    return _e43;
}

fn function_() {
    var local: f32;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_433_: bool;
    var phi_477_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_481_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_501_: lt_math_LightPoint;
    var phi_504_: u32;
    var phi_506_: lt_math_LevelPoint;
    var phi_592_: bool;
    var phi_601_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_620_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_658_: bool;
    var phi_667_: lt_math_LightPoint;
    var phi_668_: u32;
    var phi_669_: lt_math_LevelPoint;
    var phi_670_: bool;
    var phi_502_: lt_math_LightPoint;
    var phi_505_: u32;
    var phi_507_: lt_math_LevelPoint;
    var phi_671_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_711_: bool;
    var phi_712_: bool;
    var phi_713_: bool;
    var phi_714_: bool;
    var phi_718_: bool;
    var phi_800_: f32;
    var phi_916_: f32;
    var phi_917_: f32;
    var phi_920_: f32;
    var phi_949_: f32;
    var phi_954_: f32;
    var phi_955_: bool;
    var phi_956_: f32;
    var phi_957_: bool;
    var phi_961_: f32;
    var phi_981_: f32;
    var phi_986_: f32;
    var phi_987_: bool;
    var phi_988_: f32;
    var phi_989_: bool;
    var phi_993_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1042_: i32;
    var phi_1047_: i32;
    var phi_1052_: i32;
    var phi_1057_: i32;
    var phi_1066_: i32;
    var phi_1071_: i32;
    var phi_1076_: i32;
    var phi_1081_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1153_: f32;
    var phi_1155_: evaluate_Verdict;
    var phi_1156_: bool;
    var phi_1157_: evaluate_Verdict;
    var phi_1158_: bool;
    var phi_1163_: evaluate_Verdict;
    var phi_1164_: bool;
    var phi_1166_: evaluate_Verdict;
    var phi_1167_: evaluate_Verdict;
    var phi_1168_: bool;
    var phi_1172_: evaluate_Verdict;
    var phi_1173_: evaluate_Verdict;
    var phi_1174_: bool;
    var phi_1178_: evaluate_Verdict;

    let _e40 = id_1;
    let _e47 = arrayLength((&map.member));
    let _e53 = arrayLength((&levels.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e40, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        let _e65 = p.member.level_count;
        if (_e59.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e70 = p.member.light;
        let _e73 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e85 = global[2u];
                phi_426_ = (_e83 == _e85);
                phi_427_ = false;
            } else {
                phi_426_ = bool();
                phi_427_ = true;
            }
            let _e88 = phi_426_;
            let _e90 = phi_427_;
            phi_428_ = _e88;
            phi_429_ = _e90;
        } else {
            phi_428_ = bool();
            phi_429_ = true;
        }
        let _e92 = phi_428_;
        let _e94 = phi_429_;
        if _e94 {
            phi_433_ = false;
        } else {
            phi_433_ = _e92;
        }
        let _e96 = phi_433_;
        if !(_e96) {
            let _e99 = samples.member[(0u + _e59.first_primitive)].normal;
            let _e101 = samples.member[(0u + _e59.first_primitive)].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[(0u + _e59.first_primitive)].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_477_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_477_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_477_;
            phi_481_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_481_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_481_;
        if _e176.unnamed_1 {
            phi_1172_ = evaluate_Verdict(_e176.unnamed.visibility, _e176.unnamed.is_doubted);
            phi_1173_ = evaluate_Verdict();
            phi_1174_ = true;
        } else {
            let _e184 = samples.member[(0u + _e59.first_primitive)].position;
            let _e186 = p.member.map_size;
            let _e188 = (0.5f / f32(_e186));
            let _e195 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e202 = lt_math_LightPoint(vec2<f32>(_e195.uv.x, 0f), _e195.depth, _e195.is_inside);
            let _e206 = lt_math_LightPoint(_e202.uv, 0f, _e202.is_inside);
            phi_501_ = lt_math_LightPoint();
            phi_504_ = 0u;
            phi_506_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e206.uv, _e206.depth, false));
            loop {
                let _e213 = phi_501_;
                let _e215 = phi_504_;
                let _e217 = phi_506_;
                local_1 = _e217;
                local_2 = _e217;
                local_3 = _e217;
                local_4 = _e217;
                if (_e215 < _e65) {
                    if _e217.point.is_inside {
                        phi_667_ = lt_math_LightPoint();
                        phi_668_ = u32();
                        phi_669_ = lt_math_LevelPoint();
                        phi_670_ = false;
                    } else {
                        if (_e215 < _e53) {
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
                                phi_592_ = (_e253 <= 1f);
                            } else {
                                phi_592_ = false;
                            }
                            let _e285 = phi_592_;
                            if _e285 {
                                if (_e267 >= 0f) {
                                    phi_601_ = (_e267 <= 1f);
                                } else {
                                    phi_601_ = false;
                                }
                                let _e289 = phi_601_;
                                if _e289 {
                                    if (_e280 >= 0f) {
                                        phi_610_ = (_e280 <= 1f);
                                    } else {
                                        phi_610_ = false;
                                    }
                                    let _e293 = phi_610_;
                                    phi_611_ = _e293;
                                    phi_612_ = false;
                                } else {
                                    phi_611_ = bool();
                                    phi_612_ = true;
                                }
                                let _e295 = phi_611_;
                                let _e297 = phi_612_;
                                phi_613_ = _e295;
                                phi_614_ = _e297;
                            } else {
                                phi_613_ = bool();
                                phi_614_ = true;
                            }
                            let _e299 = phi_613_;
                            let _e301 = phi_614_;
                            phi_615_ = _e299;
                            phi_616_ = _e301;
                        } else {
                            phi_615_ = bool();
                            phi_616_ = true;
                        }
                        let _e303 = phi_615_;
                        let _e305 = phi_616_;
                        if _e305 {
                            phi_620_ = false;
                        } else {
                            phi_620_ = _e303;
                        }
                        let _e307 = phi_620_;
                        if _e307 {
                            if (_e253 >= _e188) {
                                if (_e253 <= (1f - _e188)) {
                                    if (_e267 >= _e188) {
                                        phi_647_ = (_e267 <= (1f - _e188));
                                        phi_648_ = false;
                                    } else {
                                        phi_647_ = bool();
                                        phi_648_ = true;
                                    }
                                    let _e315 = phi_647_;
                                    let _e317 = phi_648_;
                                    phi_649_ = _e315;
                                    phi_650_ = _e317;
                                } else {
                                    phi_649_ = bool();
                                    phi_650_ = true;
                                }
                                let _e319 = phi_649_;
                                let _e321 = phi_650_;
                                phi_651_ = _e319;
                                phi_652_ = _e321;
                            } else {
                                phi_651_ = bool();
                                phi_652_ = true;
                            }
                            let _e323 = phi_651_;
                            let _e325 = phi_652_;
                            phi_653_ = _e323;
                            phi_654_ = _e325;
                        } else {
                            phi_653_ = bool();
                            phi_654_ = true;
                        }
                        let _e327 = phi_653_;
                        let _e329 = phi_654_;
                        if _e329 {
                            phi_658_ = false;
                        } else {
                            phi_658_ = _e327;
                        }
                        let _e331 = phi_658_;
                        let _e338 = lt_math_LightPoint(vec2<f32>(_e253, _e213.uv.y), _e213.depth, _e213.is_inside);
                        let _e345 = lt_math_LightPoint(vec2<f32>(_e338.uv.x, _e267), _e338.depth, _e338.is_inside);
                        let _e349 = lt_math_LightPoint(_e345.uv, _e280, _e345.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e349.depth, _e331);
                        phi_667_ = _e353;
                        phi_668_ = (_e215 + 1u);
                        phi_669_ = lt_math_LevelPoint(_e215, _e353);
                        phi_670_ = true;
                    }
                    let _e357 = phi_667_;
                    let _e359 = phi_668_;
                    let _e361 = phi_669_;
                    let _e363 = phi_670_;
                    phi_502_ = _e357;
                    phi_505_ = _e359;
                    phi_507_ = _e361;
                    phi_671_ = _e363;
                } else {
                    phi_502_ = lt_math_LightPoint();
                    phi_505_ = u32();
                    phi_507_ = lt_math_LevelPoint();
                    phi_671_ = false;
                }
                let _e365 = phi_502_;
                let _e367 = phi_505_;
                let _e369 = phi_507_;
                let _e371 = phi_671_;
                continue;
                continuing {
                    phi_501_ = _e365;
                    phi_504_ = _e367;
                    phi_506_ = _e369;
                    break if !(_e371);
                }
            }
            let _e374 = local_1;
            if _e374.point.is_inside {
                if (1f > 0f) {
                    let _e380 = local_2;
                    if (_e380.level < _e53) {
                    } else {
                        return;
                    }
                    let _e385 = levels.member[(0u + _e380.level)];
                    let _e391 = global[0u];
                    if (_e385.row_w.x == _e391) {
                        let _e394 = global[1u];
                        if (_e385.row_w.y == _e394) {
                            let _e397 = global[2u];
                            phi_711_ = (_e385.row_w.z == _e397);
                            phi_712_ = false;
                        } else {
                            phi_711_ = bool();
                            phi_712_ = true;
                        }
                        let _e400 = phi_711_;
                        let _e402 = phi_712_;
                        phi_713_ = _e400;
                        phi_714_ = _e402;
                    } else {
                        phi_713_ = bool();
                        phi_714_ = true;
                    }
                    let _e404 = phi_713_;
                    let _e406 = phi_714_;
                    if _e406 {
                        phi_718_ = false;
                    } else {
                        phi_718_ = _e404;
                    }
                    let _e408 = phi_718_;
                    if _e408 {
                        let _e410 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e412 = p.member.map_size;
                        let _e482 = ((abs(((((_e385.row_x.x * _e410.x) + (_e385.row_x.y * _e410.y)) + (_e385.row_x.z * _e410.z)) / (((_e385.row_x.x * _e385.row_x.x) + (_e385.row_x.y * _e385.row_x.y)) + (_e385.row_x.z * _e385.row_x.z)))) + abs(((((_e385.row_y.x * _e410.x) + (_e385.row_y.y * _e410.y)) + (_e385.row_y.z * _e410.z)) / (((_e385.row_y.x * _e385.row_y.x) + (_e385.row_y.y * _e385.row_y.y)) + (_e385.row_y.z * _e385.row_y.z))))) / (abs(((((_e385.row_z.x * _e410.x) + (_e385.row_z.y * _e410.y)) + (_e385.row_z.z * _e410.z)) / (((_e385.row_z.x * _e385.row_z.x) + (_e385.row_z.y * _e385.row_z.y)) + (_e385.row_z.z * _e385.row_z.z)))) * f32(_e412)));
                        if (_e482 < 0.002f) {
                            phi_800_ = _e482;
                        } else {
                            phi_800_ = 0.002f;
                        }
                        let _e485 = phi_800_;
                        phi_917_ = _e485;
                    } else {
                        let _e487 = p.member.map_size;
                        let _e493 = samples.member[(0u + _e59.first_primitive)].position;
                        let _e504 = ((((_e385.row_w.x * _e493.x) + (_e385.row_w.y * _e493.y)) + (_e385.row_w.z * _e493.z)) + _e385.row_w.w);
                        let _e517 = ((_e385.row_x.x - (_e385.row_w.x * _e374.point.uv.x)) / _e504);
                        let _e518 = ((_e385.row_x.y - (_e385.row_w.y * _e374.point.uv.x)) / _e504);
                        let _e519 = ((_e385.row_x.z - (_e385.row_w.z * _e374.point.uv.x)) / _e504);
                        let _e532 = ((_e385.row_y.x - (_e385.row_w.x * _e374.point.uv.y)) / _e504);
                        let _e533 = ((_e385.row_y.y - (_e385.row_w.y * _e374.point.uv.y)) / _e504);
                        let _e534 = ((_e385.row_y.z - (_e385.row_w.z * _e374.point.uv.y)) / _e504);
                        let _e540 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e545 = ((_e533 * _e540.z) - (_e540.y * _e534));
                        let _e550 = ((_e534 * _e540.x) - (_e540.z * _e532));
                        let _e555 = ((_e532 * _e540.y) - (_e540.x * _e533));
                        let _e557 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e562 = ((_e518 * _e557.z) - (_e557.y * _e519));
                        let _e567 = ((_e519 * _e557.x) - (_e557.z * _e517));
                        let _e572 = ((_e517 * _e557.y) - (_e557.x * _e518));
                        let _e599 = ((abs(((((_e385.row_z.x * _e545) + (_e385.row_z.y * _e550)) + (_e385.row_z.z * _e555)) / (((_e517 * _e545) + (_e518 * _e550)) + (_e519 * _e555)))) + abs(((((_e385.row_z.x * _e562) + (_e385.row_z.y * _e567)) + (_e385.row_z.z * _e572)) / (((_e532 * _e562) + (_e533 * _e567)) + (_e534 * _e572))))) / f32(_e487));
                        if (_e599 < 0.002f) {
                            phi_916_ = _e599;
                        } else {
                            phi_916_ = 0.002f;
                        }
                        let _e602 = phi_916_;
                        phi_917_ = _e602;
                    }
                    let _e604 = phi_917_;
                    phi_920_ = (_e374.point.depth - (1f * _e604));
                } else {
                    phi_920_ = _e374.point.depth;
                }
                let _e608 = phi_920_;
                let _e614 = p.member.map_size;
                let _e615 = f32(_e614);
                let _e618 = ((_e374.point.uv.x * _e615) - 0.5f);
                let _e619 = ((_e374.point.uv.y * _e615) - 0.5f);
                if (_e618 > -8388608f) {
                    let _e631 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e631 > _e618) {
                        phi_949_ = 1f;
                    } else {
                        phi_949_ = 0f;
                    }
                    let _e634 = phi_949_;
                    if (_e618 < 8388608f) {
                        phi_954_ = (_e631 - _e634);
                        phi_955_ = false;
                    } else {
                        phi_954_ = f32();
                        phi_955_ = true;
                    }
                    let _e637 = phi_954_;
                    let _e639 = phi_955_;
                    phi_956_ = _e637;
                    phi_957_ = _e639;
                } else {
                    phi_956_ = f32();
                    phi_957_ = true;
                }
                let _e641 = phi_956_;
                let _e643 = phi_957_;
                if _e643 {
                    phi_961_ = _e618;
                } else {
                    phi_961_ = _e641;
                }
                let _e645 = phi_961_;
                if (_e619 > -8388608f) {
                    let _e657 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e657 > _e619) {
                        phi_981_ = 1f;
                    } else {
                        phi_981_ = 0f;
                    }
                    let _e660 = phi_981_;
                    if (_e619 < 8388608f) {
                        phi_986_ = (_e657 - _e660);
                        phi_987_ = false;
                    } else {
                        phi_986_ = f32();
                        phi_987_ = true;
                    }
                    let _e663 = phi_986_;
                    let _e665 = phi_987_;
                    phi_988_ = _e663;
                    phi_989_ = _e665;
                } else {
                    phi_988_ = f32();
                    phi_989_ = true;
                }
                let _e667 = phi_988_;
                let _e669 = phi_989_;
                if _e669 {
                    phi_993_ = _e619;
                } else {
                    phi_993_ = _e667;
                }
                let _e671 = phi_993_;
                let _e672 = (_e618 - _e645);
                let _e673 = (_e619 - _e671);
                let _e682 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < bitcast<f32>(3472883712u))), 2147483647i, (_e645 > bitcast<f32>(1325400063u))), (_e645 == _e645));
                let _e691 = select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671));
                let _e702 = p.member.test;
                let _e703 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e702);
                let _e705 = p.member.map_size;
                let _e707 = local_3;
                local = _e703;
                let _e710 = ((_e707.level * _e705) * _e705);
                let _e712 = (bitcast<i32>(_e705) - 1i);
                if (_e682 > 0i) {
                    phi_1042_ = _e682;
                } else {
                    phi_1042_ = 0i;
                }
                let _e715 = phi_1042_;
                if (_e691 > 0i) {
                    phi_1047_ = _e691;
                } else {
                    phi_1047_ = 0i;
                }
                let _e718 = phi_1047_;
                if (_e715 < _e712) {
                    phi_1052_ = _e715;
                } else {
                    phi_1052_ = _e712;
                }
                let _e721 = phi_1052_;
                if (_e718 < _e712) {
                    phi_1057_ = _e718;
                } else {
                    phi_1057_ = _e712;
                }
                let _e724 = phi_1057_;
                let _e725 = bitcast<u32>(_e721);
                let _e727 = (_e682 + 1i);
                let _e728 = (_e691 + 1i);
                if (_e727 > 0i) {
                    phi_1066_ = _e727;
                } else {
                    phi_1066_ = 0i;
                }
                let _e731 = phi_1066_;
                if (_e728 > 0i) {
                    phi_1071_ = _e728;
                } else {
                    phi_1071_ = 0i;
                }
                let _e734 = phi_1071_;
                if (_e731 < _e712) {
                    phi_1076_ = _e731;
                } else {
                    phi_1076_ = _e712;
                }
                let _e737 = phi_1076_;
                if (_e734 < _e712) {
                    phi_1081_ = _e734;
                } else {
                    phi_1081_ = _e712;
                }
                let _e740 = phi_1081_;
                let _e741 = bitcast<u32>(_e737);
                let _e743 = (bitcast<u32>(_e724) * _e705);
                let _e744 = (bitcast<u32>(_e740) * _e705);
                let _e749 = ((_e743 + _e725) + _e710);
                let _e750 = ((_e743 + _e741) + _e710);
                let _e751 = ((_e744 + _e725) + _e710);
                let _e752 = ((_e744 + _e741) + _e710);
                if (_e749 < _e47) {
                } else {
                    return;
                }
                let _e756 = map.member[(0u + _e749)];
                if (_e750 < _e47) {
                } else {
                    return;
                }
                let _e760 = map.member[(0u + _e750)];
                if (_e751 < _e47) {
                } else {
                    return;
                }
                let _e764 = map.member[(0u + _e751)];
                if (_e752 < _e47) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e752)];
                let _e770 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e756, _e760, _e764, _e768), vec4<f32>(((1f - _e672) * (1f - _e673)), (_e672 * (1f - _e673)), ((1f - _e672) * _e673), (_e672 * _e673)), _e608);
                let _e772 = p.member.fade_uv;
                if (_e772 > 0f) {
                    let _e775 = local_4;
                    if ((_e775.level + 1u) == _e65) {
                        let _e784 = p.member.fade_uv;
                        let _e786 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e374.point.uv.x, (1f - _e374.point.uv.x));
                        let _e788 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e374.point.uv.y, (1f - _e374.point.uv.y));
                        let _e789 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e786, _e788);
                        if (_e789 < _e784) {
                            phi_1153_ = (1f - ((1f - _e770) * (_e789 / _e784)));
                        } else {
                            phi_1153_ = _e770;
                        }
                        let _e796 = phi_1153_;
                        phi_1155_ = evaluate_Verdict(_e796, false);
                        phi_1156_ = false;
                    } else {
                        phi_1155_ = evaluate_Verdict();
                        phi_1156_ = true;
                    }
                    let _e799 = phi_1155_;
                    let _e801 = phi_1156_;
                    phi_1157_ = _e799;
                    phi_1158_ = _e801;
                } else {
                    phi_1157_ = evaluate_Verdict();
                    phi_1158_ = true;
                }
                let _e803 = phi_1157_;
                let _e805 = phi_1158_;
                if _e805 {
                    phi_1163_ = evaluate_Verdict(_e770, false);
                    phi_1164_ = false;
                } else {
                    phi_1163_ = evaluate_Verdict();
                    phi_1164_ = true;
                }
                let _e808 = phi_1163_;
                let _e810 = phi_1164_;
                phi_1166_ = _e808;
                phi_1167_ = _e803;
                phi_1168_ = _e810;
            } else {
                phi_1166_ = evaluate_Verdict();
                phi_1167_ = evaluate_Verdict(1f, false);
                phi_1168_ = true;
            }
            let _e813 = phi_1166_;
            let _e815 = phi_1167_;
            let _e817 = phi_1168_;
            if _e817 {
            }
            phi_1172_ = _e815;
            phi_1173_ = _e813;
            phi_1174_ = _e817;
        }
        let _e819 = phi_1172_;
        let _e821 = phi_1173_;
        let _e823 = phi_1174_;
        if _e823 {
            phi_1178_ = _e819;
        } else {
            phi_1178_ = _e821;
        }
        let _e825 = phi_1178_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e825.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
