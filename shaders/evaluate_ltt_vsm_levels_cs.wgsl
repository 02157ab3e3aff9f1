struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

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

struct type_39 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_45 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(5) 
var<storage> levels: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e55 = phi_159_;
        let _e57 = phi_160_;
        phi_161_ = _e55;
        phi_162_ = _e57;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e59 = phi_161_;
    let _e61 = phi_162_;
    if _e61 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e59;
    }
    let _e66 = phi_167_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_193_: f32;
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_265_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_313_: bool;
    var phi_317_: f32;
    var phi_329_: bool;
    var phi_336_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_353_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_195_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_194_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_193_ = 1f;
            } else {
                phi_193_ = param_7;
            }
            let _e52 = phi_193_;
            phi_194_ = _e52;
        }
        let _e54 = phi_194_;
        phi_195_ = _e54;
    }
    let _e56 = phi_195_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_213_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_5.x;
            }
            let _e64 = phi_211_;
            phi_212_ = _e64;
        }
        let _e66 = phi_212_;
        phi_213_ = _e66;
    }
    let _e68 = phi_213_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_231_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_5.y;
            }
            let _e76 = phi_229_;
            phi_230_ = _e76;
        }
        let _e78 = phi_230_;
        phi_231_ = _e78;
    }
    let _e80 = phi_231_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_249_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_248_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_247_ = 1f;
            } else {
                phi_247_ = param_5.z;
            }
            let _e88 = phi_247_;
            phi_248_ = _e88;
        }
        let _e90 = phi_248_;
        phi_249_ = _e90;
    }
    let _e92 = phi_249_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_267_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_266_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_265_ = 1f;
            } else {
                phi_265_ = param_5.w;
            }
            let _e100 = phi_265_;
            phi_266_ = _e100;
        }
        let _e102 = phi_266_;
        phi_267_ = _e102;
    }
    let _e104 = phi_267_;
    let _e105 = (_e68 - _e56);
    let _e106 = (_e80 - _e56);
    let _e107 = (_e92 - _e56);
    let _e108 = (_e104 - _e56);
    let _e109 = (*param_4);
    let _e120 = ((((_e105 * param_6.x) + (_e106 * param_6.y)) + (_e107 * param_6.z)) + (_e108 * param_6.w));
    let _e121 = (_e105 - _e120);
    let _e122 = (_e106 - _e120);
    let _e123 = (_e107 - _e120);
    let _e124 = (_e108 - _e120);
    let _e139 = (((((_e121 * _e121) * param_6.x) + ((_e122 * _e122) * param_6.y)) + ((_e123 * _e123) * param_6.z)) + ((_e124 * _e124) * param_6.w));
    if ((bitcast<u32>(_e109) & 2147483647u) > 2139095040u) {
        phi_313_ = true;
    } else {
        let _e143 = (_e109 > _e139);
        if _e143 {
        }
        phi_313_ = _e143;
    }
    let _e145 = phi_313_;
    if _e145 {
        phi_317_ = _e109;
    } else {
        phi_317_ = _e139;
    }
    let _e147 = phi_317_;
    let _e148 = -(_e120);
    if (_e148 <= 0f) {
        let _e152 = ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u);
        if _e152 {
        }
        phi_329_ = _e152;
    } else {
        phi_329_ = true;
    }
    let _e154 = phi_329_;
    if _e154 {
        phi_336_ = (_e147 / (_e147 + (_e148 * _e148)));
    } else {
        phi_336_ = 1f;
    }
    let _e159 = phi_336_;
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_353_ = _e159;
    } else {
        if (_e159 < 0f) {
            phi_352_ = 0f;
        } else {
            if (_e159 > 1f) {
                phi_351_ = 1f;
            } else {
                phi_351_ = _e159;
            }
            let _e166 = phi_351_;
            phi_352_ = _e166;
        }
        let _e168 = phi_352_;
        phi_353_ = _e168;
    }
    let _e170 = phi_353_;
    return _e170;
}

fn function_() {
    var local_1: f32;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_415_: bool;
    var phi_485_: bool;
    var phi_486_: bool;
    var phi_497_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_498_: bool;
    var phi_499_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_500_: bool;
    var phi_507_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_511_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_531_: lt_math_LightPoint;
    var phi_534_: u32;
    var phi_536_: lt_math_LevelPoint;
    var phi_622_: bool;
    var phi_631_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_650_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_688_: bool;
    var phi_697_: lt_math_LightPoint;
    var phi_698_: u32;
    var phi_699_: lt_math_LevelPoint;
    var phi_700_: bool;
    var phi_532_: lt_math_LightPoint;
    var phi_535_: u32;
    var phi_537_: lt_math_LevelPoint;
    var phi_701_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_748_: bool;
    var phi_830_: f32;
    var phi_946_: f32;
    var phi_947_: f32;
    var phi_950_: f32;
    var phi_979_: f32;
    var phi_984_: f32;
    var phi_985_: bool;
    var phi_986_: f32;
    var phi_987_: bool;
    var phi_991_: f32;
    var phi_1011_: f32;
    var phi_1016_: f32;
    var phi_1017_: bool;
    var phi_1018_: f32;
    var phi_1019_: bool;
    var phi_1023_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1072_: i32;
    var phi_1077_: i32;
    var phi_1082_: i32;
    var phi_1087_: i32;
    var phi_1096_: i32;
    var phi_1101_: i32;
    var phi_1106_: i32;
    var phi_1111_: i32;
    var phi_1162_: bool;
    var phi_1170_: bool;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1187_: f32;
    var phi_1193_: f32;
    var phi_1195_: evaluate_Verdict;
    var phi_1200_: evaluate_Verdict;
    var phi_1201_: evaluate_Verdict;
    var phi_1205_: bool;
    var phi_1206_: u32;
    var phi_1217_: u32;

    let _e43 = id_1;
    let _e44 = local_5;
    let _e49 = arrayLength((&map.member));
    let _e54 = arrayLength((&levels.member));
    let _e57 = p.member.size[0u];
    let _e59 = p.member.size[1u];
    let _e60 = lt_shaders_entry_pixel_index(_e43, _e57, _e59);
    if (bitcast<i32>(_e60.root) != 0i) {
        let _e67 = p.member.level_count;
        let _e71 = samples.member[_e60.first_primitive].normal[0u];
        let _e73 = global[0u];
        if (_e71 == _e73) {
            let _e76 = samples.member[_e60.first_primitive].normal[1u];
            let _e78 = global[1u];
            if (_e76 == _e78) {
                let _e81 = samples.member[_e60.first_primitive].normal[2u];
                let _e83 = global[2u];
                phi_408_ = (_e81 == _e83);
                phi_409_ = false;
            } else {
                phi_408_ = bool();
                phi_409_ = true;
            }
            let _e86 = phi_408_;
            let _e88 = phi_409_;
            phi_410_ = _e86;
            phi_411_ = _e88;
        } else {
            phi_410_ = bool();
            phi_411_ = true;
        }
        let _e90 = phi_410_;
        let _e92 = phi_411_;
        if _e92 {
            phi_415_ = false;
        } else {
            phi_415_ = _e90;
        }
        let _e94 = phi_415_;
        if !(_e94) {
            let _e97 = samples.member[_e60.first_primitive].position;
            let _e99 = p.member.light.place;
            let _e105 = p.member.light.place[3u];
            let _e112 = (_e99.x - (_e97.x * _e105));
            let _e113 = (_e99.y - (_e97.y * _e105));
            let _e114 = (_e99.z - (_e97.z * _e105));
            let _e116 = samples.member[_e60.first_primitive].normal;
            if ((((_e116.x * _e112) + (_e116.y * _e113)) + (_e116.z * _e114)) > 0f) {
                let _e130 = (((_e112 * _e112) + (_e113 * _e113)) + (_e114 * _e114));
                let _e132 = p.member.light.axis;
                let _e144 = p.member.light.place[3u];
                if (_e144 == 0f) {
                    phi_486_ = true;
                } else {
                    let _e147 = p.member.light.range_squared;
                    if (_e130 <= _e147) {
                        let _e150 = p.member.light.cos_outer;
                        phi_485_ = (-((((_e112 * _e132.x) + (_e113 * _e132.y)) + (_e114 * _e132.z))) >= (_e150 * sqrt(_e130)));
                    } else {
                        phi_485_ = false;
                    }
                    let _e155 = phi_485_;
                    phi_486_ = _e155;
                }
                let _e157 = phi_486_;
                if _e157 {
                    let _e159 = samples.member[_e60.first_primitive].flags;
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                    phi_497_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, ((_e159 & 1u) == 0u));
                    phi_498_ = false;
                } else {
                    phi_497_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_498_ = true;
                }
                let _e178 = phi_497_;
                let _e180 = phi_498_;
                phi_499_ = _e178;
                phi_500_ = _e180;
            } else {
                phi_499_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_500_ = true;
            }
            let _e182 = phi_499_;
            let _e184 = phi_500_;
            if _e184 {
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                phi_507_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, true);
            } else {
                phi_507_ = _e182;
            }
            let _e201 = phi_507_;
            phi_511_ = _e201;
        } else {
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
            phi_511_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
        }
        let _e218 = phi_511_;
        if _e218.unnamed_1 {
            phi_1201_ = evaluate_Verdict(_e218.unnamed.visibility, _e218.unnamed.is_doubted);
        } else {
            let _e226 = samples.member[_e60.first_primitive].position;
            let _e228 = p.member.map_size;
            let _e230 = (0.5f / f32(_e228));
            let _e237 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e244 = lt_math_LightPoint(vec2<f32>(_e237.uv.x, 0f), _e237.depth, _e237.is_inside);
            let _e248 = lt_math_LightPoint(_e244.uv, 0f, _e244.is_inside);
            phi_531_ = lt_math_LightPoint();
            phi_534_ = 0u;
            phi_536_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e248.uv, _e248.depth, false));
            loop {
                let _e255 = phi_531_;
                let _e257 = phi_534_;
                let _e259 = phi_536_;
                local_2 = _e259;
                local_3 = _e259;
                local_4 = _e259;
                if (_e257 < _e67) {
                    if _e259.point.is_inside {
                        phi_697_ = lt_math_LightPoint();
                        phi_698_ = u32();
                        phi_699_ = lt_math_LevelPoint();
                        phi_700_ = false;
                    } else {
                        if (_e257 < _e54) {
                        } else {
                            return;
                        }
                        let _e270 = levels.member[(0u + _e257)].row_w;
                        let _e281 = ((((_e270.x * _e226.x) + (_e270.y * _e226.y)) + (_e270.z * _e226.z)) + (_e270.w * 1f));
                        let _e283 = levels.member[(0u + _e257)].row_x;
                        let _e295 = (((((_e283.x * _e226.x) + (_e283.y * _e226.y)) + (_e283.z * _e226.z)) + (_e283.w * 1f)) / _e281);
                        let _e297 = levels.member[(0u + _e257)].row_y;
                        let _e309 = (((((_e297.x * _e226.x) + (_e297.y * _e226.y)) + (_e297.z * _e226.z)) + (_e297.w * 1f)) / _e281);
                        let _e311 = levels.member[(0u + _e257)].row_z;
                        let _e322 = ((((_e311.x * _e226.x) + (_e311.y * _e226.y)) + (_e311.z * _e226.z)) + (_e311.w * 1f));
                        if (_e281 > 0f) {
                            if (_e295 >= 0f) {
                                phi_622_ = (_e295 <= 1f);
                            } else {
                                phi_622_ = false;
                            }
                            let _e327 = phi_622_;
                            if _e327 {
                                if (_e309 >= 0f) {
                                    phi_631_ = (_e309 <= 1f);
                                } else {
                                    phi_631_ = false;
                                }
                                let _e331 = phi_631_;
                                if _e331 {
                                    if (_e322 >= 0f) {
                                        phi_640_ = (_e322 <= 1f);
                                    } else {
                                        phi_640_ = false;
                                    }
                                    let _e335 = phi_640_;
                                    phi_641_ = _e335;
                                    phi_642_ = false;
                                } else {
                                    phi_641_ = bool();
                                    phi_642_ = true;
                                }
                                let _e337 = phi_641_;
                                let _e339 = phi_642_;
                                phi_643_ = _e337;
                                phi_644_ = _e339;
                            } else {
                                phi_643_ = bool();
                                phi_644_ = true;
                            }
                            let _e341 = phi_643_;
                            let _e343 = phi_644_;
                            phi_645_ = _e341;
                            phi_646_ = _e343;
                        } else {
                            phi_645_ = bool();
                            phi_646_ = true;
                        }
                        let _e345 = phi_645_;
                        let _e347 = phi_646_;
                        if _e347 {
                            phi_650_ = false;
                        } else {
                            phi_650_ = _e345;
                        }
                        let _e349 = phi_650_;
                        if _e349 {
                            if (_e295 >= _e230) {
                                if (_e295 <= (1f - _e230)) {
                                    if (_e309 >= _e230) {
                                        phi_677_ = (_e309 <= (1f - _e230));
                                        phi_678_ = false;
                                    } else {
                                        phi_677_ = bool();
                                        phi_678_ = true;
                                    }
                                    let _e357 = phi_677_;
                                    let _e359 = phi_678_;
                                    phi_679_ = _e357;
                                    phi_680_ = _e359;
                                } else {
                                    phi_679_ = bool();
                                    phi_680_ = true;
                                }
                                let _e361 = phi_679_;
                                let _e363 = phi_680_;
                                phi_681_ = _e361;
                                phi_682_ = _e363;
                            } else {
                                phi_681_ = bool();
                                phi_682_ = true;
                            }
                            let _e365 = phi_681_;
                            let _e367 = phi_682_;
                            phi_683_ = _e365;
                            phi_684_ = _e367;
                        } else {
                            phi_683_ = bool();
                            phi_684_ = true;
                        }
                        let _e369 = phi_683_;
                        let _e371 = phi_684_;
                        if _e371 {
                            phi_688_ = false;
                        } else {
                            phi_688_ = _e369;
                        }
                        let _e373 = phi_688_;
                        let _e380 = lt_math_LightPoint(vec2<f32>(_e295, _e255.uv.y), _e255.depth, _e255.is_inside);
                        let _e387 = lt_math_LightPoint(vec2<f32>(_e380.uv.x, _e309), _e380.depth, _e380.is_inside);
                        let _e391 = lt_math_LightPoint(_e387.uv, _e322, _e387.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e391.depth, _e373);
                        phi_697_ = _e395;
                        phi_698_ = (_e257 + 1u);
                        phi_699_ = lt_math_LevelPoint(_e257, _e395);
                        phi_700_ = true;
                    }
                    let _e399 = phi_697_;
                    let _e401 = phi_698_;
                    let _e403 = phi_699_;
                    let _e405 = phi_700_;
                    phi_532_ = _e399;
                    phi_535_ = _e401;
                    phi_537_ = _e403;
                    phi_701_ = _e405;
                } else {
                    phi_532_ = lt_math_LightPoint();
                    phi_535_ = u32();
                    phi_537_ = lt_math_LevelPoint();
                    phi_701_ = false;
                }
                let _e407 = phi_532_;
                let _e409 = phi_535_;
                let _e411 = phi_537_;
                let _e413 = phi_701_;
                continue;
                continuing {
                    phi_531_ = _e407;
                    phi_534_ = _e409;
                    phi_536_ = _e411;
                    break if !(_e413);
                }
            }
            let _e416 = local_2;
            if _e416.point.is_inside {
                if (0f > 0f) {
                    let _e422 = local_3;
                    if (_e422.level < _e54) {
                    } else {
                        return;
                    }
                    let _e427 = levels.member[(0u + _e422.level)];
                    let _e433 = global[0u];
                    if (_e427.row_w.x == _e433) {
                        let _e436 = global[1u];
                        if (_e427.row_w.y == _e436) {
                            let _e439 = global[2u];
                            phi_741_ = (_e427.row_w.z == _e439);
                            phi_742_ = false;
                        } else {
                            phi_741_ = bool();
                            phi_742_ = true;
                        }
                        let _e442 = phi_741_;
                        let _e444 = phi_742_;
                        phi_743_ = _e442;
                        phi_744_ = _e444;
                    } else {
                        phi_743_ = bool();
                        phi_744_ = true;
                    }
                    let _e446 = phi_743_;
                    let _e448 = phi_744_;
                    if _e448 {
                        phi_748_ = false;
                    } else {
                        phi_748_ = _e446;
                    }
                    let _e450 = phi_748_;
                    if _e450 {
                        let _e452 = samples.member[_e60.first_primitive].normal;
                        let _e454 = p.member.map_size;
                        let _e524 = ((abs(((((_e427.row_x.x * _e452.x) + (_e427.row_x.y * _e452.y)) + (_e427.row_x.z * _e452.z)) / (((_e427.row_x.x * _e427.row_x.x) + (_e427.row_x.y * _e427.row_x.y)) + (_e427.row_x.z * _e427.row_x.z)))) + abs(((((_e427.row_y.x * _e452.x) + (_e427.row_y.y * _e452.y)) + (_e427.row_y.z * _e452.z)) / (((_e427.row_y.x * _e427.row_y.x) + (_e427.row_y.y * _e427.row_y.y)) + (_e427.row_y.z * _e427.row_y.z))))) / (abs(((((_e427.row_z.x * _e452.x) + (_e427.row_z.y * _e452.y)) + (_e427.row_z.z * _e452.z)) / (((_e427.row_z.x * _e427.row_z.x) + (_e427.row_z.y * _e427.row_z.y)) + (_e427.row_z.z * _e427.row_z.z)))) * f32(_e454)));
                        if (_e524 < 0.002f) {
                            phi_830_ = _e524;
                        } else {
                            phi_830_ = 0.002f;
                        }
                        let _e527 = phi_830_;
                        phi_947_ = _e527;
                    } else {
                        let _e529 = p.member.map_size;
                        let _e535 = samples.member[_e60.first_primitive].position;
                        let _e546 = ((((_e427.row_w.x * _e535.x) + (_e427.row_w.y * _e535.y)) + (_e427.row_w.z * _e535.z)) + _e427.row_w.w);
                        let _e559 = ((_e427.row_x.x - (_e427.row_w.x * _e416.point.uv.x)) / _e546);
                        let _e560 = ((_e427.row_x.y - (_e427.row_w.y * _e416.point.uv.x)) / _e546);
                        let _e561 = ((_e427.row_x.z - (_e427.row_w.z * _e416.point.uv.x)) / _e546);
                        let _e574 = ((_e427.row_y.x - (_e427.row_w.x * _e416.point.uv.y)) / _e546);
                        let _e575 = ((_e427.row_y.y - (_e427.row_w.y * _e416.point.uv.y)) / _e546);
                        let _e576 = ((_e427.row_y.z - (_e427.row_w.z * _e416.point.uv.y)) / _e546);
                        let _e582 = samples.member[_e60.first_primitive].normal;
                        let _e587 = ((_e575 * _e582.z) - (_e582.y * _e576));
                        let _e592 = ((_e576 * _e582.x) - (_e582.z * _e574));
                        let _e597 = ((_e574 * _e582.y) - (_e582.x * _e575));
                        let _e599 = samples.member[_e60.first_primitive].normal;
                        let _e604 = ((_e560 * _e599.z) - (_e599.y * _e561));
                        let _e609 = ((_e561 * _e599.x) - (_e599.z * _e559));
                        let _e614 = ((_e559 * _e599.y) - (_e599.x * _e560));
                        let _e641 = ((abs(((((_e427.row_z.x * _e587) + (_e427.row_z.y * _e592)) + (_e427.row_z.z * _e597)) / (((_e559 * _e587) + (_e560 * _e592)) + (_e561 * _e597)))) + abs(((((_e427.row_z.x * _e604) + (_e427.row_z.y * _e609)) + (_e427.row_z.z * _e614)) / (((_e574 * _e604) + (_e575 * _e609)) + (_e576 * _e614))))) / f32(_e529));
                        if (_e641 < 0.002f) {
                            phi_946_ = _e641;
                        } else {
                            phi_946_ = 0.002f;
                        }
                        let _e644 = phi_946_;
                        phi_947_ = _e644;
                    }
                    let _e646 = phi_947_;
                    phi_950_ = (_e416.point.depth - (0f * _e646));
                } else {
                    phi_950_ = _e416.point.depth;
                }
                let _e650 = phi_950_;
                let _e656 = p.member.map_size;
                let _e657 = f32(_e656);
                let _e660 = ((_e416.point.uv.x * _e657) - 0.5f);
                let _e661 = ((_e416.point.uv.y * _e657) - 0.5f);
                if (_e660 > -8388608f) {
                    let _e673 = f32(select(0i, select(select(i32(_e660), i32(-2147483648), (_e660 < bitcast<f32>(3472883712u))), 2147483647i, (_e660 > bitcast<f32>(1325400063u))), (_e660 == _e660)));
                    if (_e673 > _e660) {
                        phi_979_ = 1f;
                    } else {
                        phi_979_ = 0f;
                    }
                    let _e676 = phi_979_;
                    if (_e660 < 8388608f) {
                        phi_984_ = (_e673 - _e676);
                        phi_985_ = false;
                    } else {
                        phi_984_ = f32();
                        phi_985_ = true;
                    }
                    let _e679 = phi_984_;
                    let _e681 = phi_985_;
                    phi_986_ = _e679;
                    phi_987_ = _e681;
                } else {
                    phi_986_ = f32();
                    phi_987_ = true;
                }
                let _e683 = phi_986_;
                let _e685 = phi_987_;
                if _e685 {
                    phi_991_ = _e660;
                } else {
                    phi_991_ = _e683;
                }
                let _e687 = phi_991_;
                if (_e661 > -8388608f) {
                    let _e699 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e699 > _e661) {
                        phi_1011_ = 1f;
                    } else {
                        phi_1011_ = 0f;
                    }
                    let _e702 = phi_1011_;
                    if (_e661 < 8388608f) {
                        phi_1016_ = (_e699 - _e702);
                        phi_1017_ = false;
                    } else {
                        phi_1016_ = f32();
                        phi_1017_ = true;
                    }
                    let _e705 = phi_1016_;
                    let _e707 = phi_1017_;
                    phi_1018_ = _e705;
                    phi_1019_ = _e707;
                } else {
                    phi_1018_ = f32();
                    phi_1019_ = true;
                }
                let _e709 = phi_1018_;
                let _e711 = phi_1019_;
                if _e711 {
                    phi_1023_ = _e661;
                } else {
                    phi_1023_ = _e709;
                }
                let _e713 = phi_1023_;
                let _e714 = (_e660 - _e687);
                let _e715 = (_e661 - _e713);
                let _e724 = select(0i, select(select(i32(_e687), i32(-2147483648), (_e687 < bitcast<f32>(3472883712u))), 2147483647i, (_e687 > bitcast<f32>(1325400063u))), (_e687 == _e687));
                let _e733 = select(0i, select(select(i32(_e713), i32(-2147483648), (_e713 < bitcast<f32>(3472883712u))), 2147483647i, (_e713 > bitcast<f32>(1325400063u))), (_e713 == _e713));
                let _e744 = p.member.test;
                let _e745 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_4;
                local_1 = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e724 > 0i) {
                    phi_1072_ = _e724;
                } else {
                    phi_1072_ = 0i;
                }
                let _e757 = phi_1072_;
                if (_e733 > 0i) {
                    phi_1077_ = _e733;
                } else {
                    phi_1077_ = 0i;
                }
                let _e760 = phi_1077_;
                if (_e757 < _e754) {
                    phi_1082_ = _e757;
                } else {
                    phi_1082_ = _e754;
                }
                let _e763 = phi_1082_;
                if (_e760 < _e754) {
                    phi_1087_ = _e760;
                } else {
                    phi_1087_ = _e754;
                }
                let _e766 = phi_1087_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e724 + 1i);
                let _e770 = (_e733 + 1i);
                if (_e769 > 0i) {
                    phi_1096_ = _e769;
                } else {
                    phi_1096_ = 0i;
                }
                let _e773 = phi_1096_;
                if (_e770 > 0i) {
                    phi_1101_ = _e770;
                } else {
                    phi_1101_ = 0i;
                }
                let _e776 = phi_1101_;
                if (_e773 < _e754) {
                    phi_1106_ = _e773;
                } else {
                    phi_1106_ = _e754;
                }
                let _e779 = phi_1106_;
                if (_e776 < _e754) {
                    phi_1111_ = _e776;
                } else {
                    phi_1111_ = _e754;
                }
                let _e782 = phi_1111_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (bitcast<u32>(_e766) * _e747);
                let _e786 = (bitcast<u32>(_e782) * _e747);
                let _e791 = ((_e785 + _e767) + _e752);
                let _e792 = ((_e785 + _e783) + _e752);
                let _e793 = ((_e786 + _e767) + _e752);
                let _e794 = ((_e786 + _e783) + _e752);
                if (_e791 < _e49) {
                } else {
                    return;
                }
                let _e798 = map.member[(0u + _e791)];
                if (_e792 < _e49) {
                } else {
                    return;
                }
                let _e802 = map.member[(0u + _e792)];
                if (_e793 < _e49) {
                } else {
                    return;
                }
                let _e806 = map.member[(0u + _e793)];
                if (_e794 < _e49) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e794)];
                let _e812 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e798, _e802, _e806, _e810), vec4<f32>(((1f - _e714) * (1f - _e715)), (_e714 * (1f - _e715)), ((1f - _e714) * _e715), (_e714 * _e715)), _e650);
                let _e814 = p.member.epsilon;
                if (_e812 <= _e814) {
                    phi_1162_ = true;
                } else {
                    phi_1162_ = (_e812 >= (1f - _e814));
                }
                let _e819 = phi_1162_;
                if ((bitcast<u32>(_e812) & 2147483647u) > 2139095040u) {
                    phi_1170_ = true;
                } else {
                    phi_1170_ = !(_e819);
                }
                let _e825 = phi_1170_;
                if _e825 {
                    if (_e812 > 0f) {
                        if (_e812 < 1f) {
                            phi_1182_ = false;
                        } else {
                            phi_1182_ = true;
                        }
                        let _e829 = phi_1182_;
                        phi_1183_ = _e829;
                    } else {
                        phi_1183_ = true;
                    }
                    let _e831 = phi_1183_;
                    if _e831 {
                        phi_1187_ = 0.5f;
                    } else {
                        phi_1187_ = _e812;
                    }
                    let _e833 = phi_1187_;
                    phi_1195_ = evaluate_Verdict(_e833, true);
                } else {
                    if (_e812 > 0.5f) {
                        phi_1193_ = 1f;
                    } else {
                        phi_1193_ = 0f;
                    }
                    let _e837 = phi_1193_;
                    phi_1195_ = evaluate_Verdict(_e837, false);
                }
                let _e840 = phi_1195_;
                phi_1200_ = evaluate_Verdict(_e840.visibility, _e840.is_doubted);
            } else {
                phi_1200_ = evaluate_Verdict(0.5f, true);
            }
            let _e846 = phi_1200_;
            phi_1201_ = _e846;
        }
        let _e848 = phi_1201_;
        visibility.member[_e60.first_primitive] = _e848.visibility;
        phi_1205_ = _e848.is_doubted;
        phi_1206_ = _e60.first_primitive;
    } else {
        phi_1205_ = false;
        phi_1206_ = 0u;
    }
    let _e853 = phi_1205_;
    let _e855 = phi_1206_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e853 {
        let _e859 = atomicAdd((&shared_[0u]), 1u);
        phi_1217_ = _e859;
    } else {
        phi_1217_ = 0u;
    }
    let _e861 = phi_1217_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e865 = atomicLoad((&shared_[0u]));
        let _e866 = atomicAdd((&list.member[3u]), _e865);
        atomicStore((&shared_[1u]), _e866);
    }
    workgroupBarrier();
    if _e853 {
        let _e869 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e869) + _e861)]), _e855);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
