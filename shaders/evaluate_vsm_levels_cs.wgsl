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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_32 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_37 {
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
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e52 = phi_145_;
        let _e54 = phi_146_;
        phi_147_ = _e52;
        phi_148_ = _e54;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e56 = phi_147_;
    let _e58 = phi_148_;
    if _e58 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e56;
    }
    let _e63 = phi_153_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_181_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_299_: bool;
    var phi_303_: f32;
    var phi_315_: bool;
    var phi_322_: f32;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_339_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_181_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_180_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_179_ = 1f;
            } else {
                phi_179_ = param_7;
            }
            let _e49 = phi_179_;
            phi_180_ = _e49;
        }
        let _e51 = phi_180_;
        phi_181_ = _e51;
    }
    let _e53 = phi_181_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_199_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_5.x;
            }
            let _e61 = phi_197_;
            phi_198_ = _e61;
        }
        let _e63 = phi_198_;
        phi_199_ = _e63;
    }
    let _e65 = phi_199_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_217_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_216_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_215_ = 1f;
            } else {
                phi_215_ = param_5.y;
            }
            let _e73 = phi_215_;
            phi_216_ = _e73;
        }
        let _e75 = phi_216_;
        phi_217_ = _e75;
    }
    let _e77 = phi_217_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_235_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_234_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_233_ = 1f;
            } else {
                phi_233_ = param_5.z;
            }
            let _e85 = phi_233_;
            phi_234_ = _e85;
        }
        let _e87 = phi_234_;
        phi_235_ = _e87;
    }
    let _e89 = phi_235_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_253_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_252_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_251_ = 1f;
            } else {
                phi_251_ = param_5.w;
            }
            let _e97 = phi_251_;
            phi_252_ = _e97;
        }
        let _e99 = phi_252_;
        phi_253_ = _e99;
    }
    let _e101 = phi_253_;
    let _e102 = (_e65 - _e53);
    let _e103 = (_e77 - _e53);
    let _e104 = (_e89 - _e53);
    let _e105 = (_e101 - _e53);
    let _e106 = (*param_4);
    let _e117 = ((((_e102 * param_6.x) + (_e103 * param_6.y)) + (_e104 * param_6.z)) + (_e105 * param_6.w));
    let _e118 = (_e102 - _e117);
    let _e119 = (_e103 - _e117);
    let _e120 = (_e104 - _e117);
    let _e121 = (_e105 - _e117);
    let _e136 = (((((_e118 * _e118) * param_6.x) + ((_e119 * _e119) * param_6.y)) + ((_e120 * _e120) * param_6.z)) + ((_e121 * _e121) * param_6.w));
    if ((bitcast<u32>(_e106) & 2147483647u) > 2139095040u) {
        phi_299_ = true;
    } else {
        let _e140 = (_e106 > _e136);
        if _e140 {
        }
        phi_299_ = _e140;
    }
    let _e142 = phi_299_;
    if _e142 {
        phi_303_ = _e106;
    } else {
        phi_303_ = _e136;
    }
    let _e144 = phi_303_;
    let _e145 = -(_e117);
    if (_e145 <= 0f) {
        let _e149 = ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u);
        if _e149 {
        }
        phi_315_ = _e149;
    } else {
        phi_315_ = true;
    }
    let _e151 = phi_315_;
    if _e151 {
        phi_322_ = (_e144 / (_e144 + (_e145 * _e145)));
    } else {
        phi_322_ = 1f;
    }
    let _e156 = phi_322_;
    if ((bitcast<u32>(_e156) & 2147483647u) > 2139095040u) {
        phi_339_ = _e156;
    } else {
        if (_e156 < 0f) {
            phi_338_ = 0f;
        } else {
            if (_e156 > 1f) {
                phi_337_ = 1f;
            } else {
                phi_337_ = _e156;
            }
            let _e163 = phi_337_;
            phi_338_ = _e163;
        }
        let _e165 = phi_338_;
        phi_339_ = _e165;
    }
    let _e167 = phi_339_;
    return _e167;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_8: f32, param_9: f32) -> f32 {
    var phi_347_: f32;

    if (param_8 < param_9) {
        phi_347_ = param_8;
    } else {
        phi_347_ = param_9;
    }
    let _e43 = phi_347_;
    return _e43;
}

fn function_() {
    var local: f32;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_414_: bool;
    var phi_484_: bool;
    var phi_485_: bool;
    var phi_496_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_497_: bool;
    var phi_498_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_499_: bool;
    var phi_506_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_510_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_530_: lt_math_LightPoint;
    var phi_533_: u32;
    var phi_535_: lt_math_LevelPoint;
    var phi_621_: bool;
    var phi_630_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_649_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_687_: bool;
    var phi_696_: lt_math_LightPoint;
    var phi_697_: u32;
    var phi_698_: lt_math_LevelPoint;
    var phi_699_: bool;
    var phi_531_: lt_math_LightPoint;
    var phi_534_: u32;
    var phi_536_: lt_math_LevelPoint;
    var phi_700_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_747_: bool;
    var phi_829_: f32;
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_949_: f32;
    var phi_978_: f32;
    var phi_983_: f32;
    var phi_984_: bool;
    var phi_985_: f32;
    var phi_986_: bool;
    var phi_990_: f32;
    var phi_1010_: f32;
    var phi_1015_: f32;
    var phi_1016_: bool;
    var phi_1017_: f32;
    var phi_1018_: bool;
    var phi_1022_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1071_: i32;
    var phi_1076_: i32;
    var phi_1081_: i32;
    var phi_1086_: i32;
    var phi_1095_: i32;
    var phi_1100_: i32;
    var phi_1105_: i32;
    var phi_1110_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1182_: f32;
    var phi_1184_: evaluate_Verdict;
    var phi_1185_: bool;
    var phi_1186_: evaluate_Verdict;
    var phi_1187_: bool;
    var phi_1192_: evaluate_Verdict;
    var phi_1193_: bool;
    var phi_1195_: evaluate_Verdict;
    var phi_1196_: evaluate_Verdict;
    var phi_1197_: bool;
    var phi_1201_: evaluate_Verdict;
    var phi_1202_: evaluate_Verdict;
    var phi_1203_: bool;
    var phi_1207_: evaluate_Verdict;

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
        let _e72 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e84 = global[2u];
                phi_407_ = (_e82 == _e84);
                phi_408_ = false;
            } else {
                phi_407_ = bool();
                phi_408_ = true;
            }
            let _e87 = phi_407_;
            let _e89 = phi_408_;
            phi_409_ = _e87;
            phi_410_ = _e89;
        } else {
            phi_409_ = bool();
            phi_410_ = true;
        }
        let _e91 = phi_409_;
        let _e93 = phi_410_;
        if _e93 {
            phi_414_ = false;
        } else {
            phi_414_ = _e91;
        }
        let _e95 = phi_414_;
        if !(_e95) {
            let _e98 = samples.member[(0u + _e59.first_primitive)].position;
            let _e100 = p.member.light.place;
            let _e106 = p.member.light.place[3u];
            let _e113 = (_e100.x - (_e98.x * _e106));
            let _e114 = (_e100.y - (_e98.y * _e106));
            let _e115 = (_e100.z - (_e98.z * _e106));
            let _e117 = samples.member[(0u + _e59.first_primitive)].normal;
            if ((((_e117.x * _e113) + (_e117.y * _e114)) + (_e117.z * _e115)) > 0f) {
                let _e131 = (((_e113 * _e113) + (_e114 * _e114)) + (_e115 * _e115));
                let _e133 = p.member.light.axis;
                let _e145 = p.member.light.place[3u];
                if (_e145 == 0f) {
                    phi_485_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_484_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_484_ = false;
                    }
                    let _e156 = phi_484_;
                    phi_485_ = _e156;
                }
                let _e158 = phi_485_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_496_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_497_ = false;
                } else {
                    phi_496_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_497_ = true;
                }
                let _e179 = phi_496_;
                let _e181 = phi_497_;
                phi_498_ = _e179;
                phi_499_ = _e181;
            } else {
                phi_498_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_499_ = true;
            }
            let _e183 = phi_498_;
            let _e185 = phi_499_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_506_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_506_ = _e183;
            }
            let _e202 = phi_506_;
            phi_510_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_510_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_510_;
        if _e219.unnamed_1 {
            phi_1201_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1202_ = evaluate_Verdict();
            phi_1203_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_530_ = lt_math_LightPoint();
            phi_533_ = 0u;
            phi_535_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_530_;
                let _e258 = phi_533_;
                let _e260 = phi_535_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                local_4 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_696_ = lt_math_LightPoint();
                        phi_697_ = u32();
                        phi_698_ = lt_math_LevelPoint();
                        phi_699_ = false;
                    } else {
                        if (_e258 < _e53) {
                        } else {
                            return;
                        }
                        let _e271 = levels.member[(0u + _e258)].row_w;
                        let _e282 = ((((_e271.x * _e227.x) + (_e271.y * _e227.y)) + (_e271.z * _e227.z)) + (_e271.w * 1f));
                        let _e284 = levels.member[(0u + _e258)].row_x;
                        let _e296 = (((((_e284.x * _e227.x) + (_e284.y * _e227.y)) + (_e284.z * _e227.z)) + (_e284.w * 1f)) / _e282);
                        let _e298 = levels.member[(0u + _e258)].row_y;
                        let _e310 = (((((_e298.x * _e227.x) + (_e298.y * _e227.y)) + (_e298.z * _e227.z)) + (_e298.w * 1f)) / _e282);
                        let _e312 = levels.member[(0u + _e258)].row_z;
                        let _e323 = ((((_e312.x * _e227.x) + (_e312.y * _e227.y)) + (_e312.z * _e227.z)) + (_e312.w * 1f));
                        if (_e282 > 0f) {
                            if (_e296 >= 0f) {
                                phi_621_ = (_e296 <= 1f);
                            } else {
                                phi_621_ = false;
                            }
                            let _e328 = phi_621_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_630_ = (_e310 <= 1f);
                                } else {
                                    phi_630_ = false;
                                }
                                let _e332 = phi_630_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_639_ = (_e323 <= 1f);
                                    } else {
                                        phi_639_ = false;
                                    }
                                    let _e336 = phi_639_;
                                    phi_640_ = _e336;
                                    phi_641_ = false;
                                } else {
                                    phi_640_ = bool();
                                    phi_641_ = true;
                                }
                                let _e338 = phi_640_;
                                let _e340 = phi_641_;
                                phi_642_ = _e338;
                                phi_643_ = _e340;
                            } else {
                                phi_642_ = bool();
                                phi_643_ = true;
                            }
                            let _e342 = phi_642_;
                            let _e344 = phi_643_;
                            phi_644_ = _e342;
                            phi_645_ = _e344;
                        } else {
                            phi_644_ = bool();
                            phi_645_ = true;
                        }
                        let _e346 = phi_644_;
                        let _e348 = phi_645_;
                        if _e348 {
                            phi_649_ = false;
                        } else {
                            phi_649_ = _e346;
                        }
                        let _e350 = phi_649_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_676_ = (_e310 <= (1f - _e231));
                                        phi_677_ = false;
                                    } else {
                                        phi_676_ = bool();
                                        phi_677_ = true;
                                    }
                                    let _e358 = phi_676_;
                                    let _e360 = phi_677_;
                                    phi_678_ = _e358;
                                    phi_679_ = _e360;
                                } else {
                                    phi_678_ = bool();
                                    phi_679_ = true;
                                }
                                let _e362 = phi_678_;
                                let _e364 = phi_679_;
                                phi_680_ = _e362;
                                phi_681_ = _e364;
                            } else {
                                phi_680_ = bool();
                                phi_681_ = true;
                            }
                            let _e366 = phi_680_;
                            let _e368 = phi_681_;
                            phi_682_ = _e366;
                            phi_683_ = _e368;
                        } else {
                            phi_682_ = bool();
                            phi_683_ = true;
                        }
                        let _e370 = phi_682_;
                        let _e372 = phi_683_;
                        if _e372 {
                            phi_687_ = false;
                        } else {
                            phi_687_ = _e370;
                        }
                        let _e374 = phi_687_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_696_ = _e396;
                        phi_697_ = (_e258 + 1u);
                        phi_698_ = lt_math_LevelPoint(_e258, _e396);
                        phi_699_ = true;
                    }
                    let _e400 = phi_696_;
                    let _e402 = phi_697_;
                    let _e404 = phi_698_;
                    let _e406 = phi_699_;
                    phi_531_ = _e400;
                    phi_534_ = _e402;
                    phi_536_ = _e404;
                    phi_700_ = _e406;
                } else {
                    phi_531_ = lt_math_LightPoint();
                    phi_534_ = u32();
                    phi_536_ = lt_math_LevelPoint();
                    phi_700_ = false;
                }
                let _e408 = phi_531_;
                let _e410 = phi_534_;
                let _e412 = phi_536_;
                let _e414 = phi_700_;
                continue;
                continuing {
                    phi_530_ = _e408;
                    phi_533_ = _e410;
                    phi_535_ = _e412;
                    break if !(_e414);
                }
            }
            let _e417 = local_1;
            if _e417.point.is_inside {
                if (0f > 0f) {
                    let _e423 = local_2;
                    if (_e423.level < _e53) {
                    } else {
                        return;
                    }
                    let _e428 = levels.member[(0u + _e423.level)];
                    let _e434 = global[0u];
                    if (_e428.row_w.x == _e434) {
                        let _e437 = global[1u];
                        if (_e428.row_w.y == _e437) {
                            let _e440 = global[2u];
                            phi_740_ = (_e428.row_w.z == _e440);
                            phi_741_ = false;
                        } else {
                            phi_740_ = bool();
                            phi_741_ = true;
                        }
                        let _e443 = phi_740_;
                        let _e445 = phi_741_;
                        phi_742_ = _e443;
                        phi_743_ = _e445;
                    } else {
                        phi_742_ = bool();
                        phi_743_ = true;
                    }
                    let _e447 = phi_742_;
                    let _e449 = phi_743_;
                    if _e449 {
                        phi_747_ = false;
                    } else {
                        phi_747_ = _e447;
                    }
                    let _e451 = phi_747_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_829_ = _e525;
                        } else {
                            phi_829_ = 0.002f;
                        }
                        let _e528 = phi_829_;
                        phi_946_ = _e528;
                    } else {
                        let _e530 = p.member.map_size;
                        let _e536 = samples.member[(0u + _e59.first_primitive)].position;
                        let _e547 = ((((_e428.row_w.x * _e536.x) + (_e428.row_w.y * _e536.y)) + (_e428.row_w.z * _e536.z)) + _e428.row_w.w);
                        let _e560 = ((_e428.row_x.x - (_e428.row_w.x * _e417.point.uv.x)) / _e547);
                        let _e561 = ((_e428.row_x.y - (_e428.row_w.y * _e417.point.uv.x)) / _e547);
                        let _e562 = ((_e428.row_x.z - (_e428.row_w.z * _e417.point.uv.x)) / _e547);
                        let _e575 = ((_e428.row_y.x - (_e428.row_w.x * _e417.point.uv.y)) / _e547);
                        let _e576 = ((_e428.row_y.y - (_e428.row_w.y * _e417.point.uv.y)) / _e547);
                        let _e577 = ((_e428.row_y.z - (_e428.row_w.z * _e417.point.uv.y)) / _e547);
                        let _e583 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e588 = ((_e576 * _e583.z) - (_e583.y * _e577));
                        let _e593 = ((_e577 * _e583.x) - (_e583.z * _e575));
                        let _e598 = ((_e575 * _e583.y) - (_e583.x * _e576));
                        let _e600 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e605 = ((_e561 * _e600.z) - (_e600.y * _e562));
                        let _e610 = ((_e562 * _e600.x) - (_e600.z * _e560));
                        let _e615 = ((_e560 * _e600.y) - (_e600.x * _e561));
                        let _e642 = ((abs(((((_e428.row_z.x * _e588) + (_e428.row_z.y * _e593)) + (_e428.row_z.z * _e598)) / (((_e560 * _e588) + (_e561 * _e593)) + (_e562 * _e598)))) + abs(((((_e428.row_z.x * _e605) + (_e428.row_z.y * _e610)) + (_e428.row_z.z * _e615)) / (((_e575 * _e605) + (_e576 * _e610)) + (_e577 * _e615))))) / f32(_e530));
                        if (_e642 < 0.002f) {
                            phi_945_ = _e642;
                        } else {
                            phi_945_ = 0.002f;
                        }
                        let _e645 = phi_945_;
                        phi_946_ = _e645;
                    }
                    let _e647 = phi_946_;
                    phi_949_ = (_e417.point.depth - (0f * _e647));
                } else {
                    phi_949_ = _e417.point.depth;
                }
                let _e651 = phi_949_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_978_ = 1f;
                    } else {
                        phi_978_ = 0f;
                    }
                    let _e677 = phi_978_;
                    if (_e661 < 8388608f) {
                        phi_983_ = (_e674 - _e677);
                        phi_984_ = false;
                    } else {
                        phi_983_ = f32();
                        phi_984_ = true;
                    }
                    let _e680 = phi_983_;
                    let _e682 = phi_984_;
                    phi_985_ = _e680;
                    phi_986_ = _e682;
                } else {
                    phi_985_ = f32();
                    phi_986_ = true;
                }
                let _e684 = phi_985_;
                let _e686 = phi_986_;
                if _e686 {
                    phi_990_ = _e661;
                } else {
                    phi_990_ = _e684;
                }
                let _e688 = phi_990_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_1010_ = 1f;
                    } else {
                        phi_1010_ = 0f;
                    }
                    let _e703 = phi_1010_;
                    if (_e662 < 8388608f) {
                        phi_1015_ = (_e700 - _e703);
                        phi_1016_ = false;
                    } else {
                        phi_1015_ = f32();
                        phi_1016_ = true;
                    }
                    let _e706 = phi_1015_;
                    let _e708 = phi_1016_;
                    phi_1017_ = _e706;
                    phi_1018_ = _e708;
                } else {
                    phi_1017_ = f32();
                    phi_1018_ = true;
                }
                let _e710 = phi_1017_;
                let _e712 = phi_1018_;
                if _e712 {
                    phi_1022_ = _e662;
                } else {
                    phi_1022_ = _e710;
                }
                let _e714 = phi_1022_;
                let _e715 = (_e661 - _e688);
                let _e716 = (_e662 - _e714);
                let _e725 = select(0i, select(select(i32(_e688), i32(-2147483648), (_e688 < bitcast<f32>(3472883712u))), 2147483647i, (_e688 > bitcast<f32>(1325400063u))), (_e688 == _e688));
                let _e734 = select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < bitcast<f32>(3472883712u))), 2147483647i, (_e714 > bitcast<f32>(1325400063u))), (_e714 == _e714));
                let _e745 = p.member.test;
                let _e746 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e745);
                let _e748 = p.member.map_size;
                let _e750 = local_3;
                local = _e746;
                let _e753 = ((_e750.level * _e748) * _e748);
                let _e755 = (bitcast<i32>(_e748) - 1i);
                if (_e725 > 0i) {
                    phi_1071_ = _e725;
                } else {
                    phi_1071_ = 0i;
                }
                let _e758 = phi_1071_;
                if (_e734 > 0i) {
                    phi_1076_ = _e734;
                } else {
                    phi_1076_ = 0i;
                }
                let _e761 = phi_1076_;
                if (_e758 < _e755) {
                    phi_1081_ = _e758;
                } else {
                    phi_1081_ = _e755;
                }
                let _e764 = phi_1081_;
                if (_e761 < _e755) {
                    phi_1086_ = _e761;
                } else {
                    phi_1086_ = _e755;
                }
                let _e767 = phi_1086_;
                let _e768 = bitcast<u32>(_e764);
                let _e770 = (_e725 + 1i);
                let _e771 = (_e734 + 1i);
                if (_e770 > 0i) {
                    phi_1095_ = _e770;
                } else {
                    phi_1095_ = 0i;
                }
                let _e774 = phi_1095_;
                if (_e771 > 0i) {
                    phi_1100_ = _e771;
                } else {
                    phi_1100_ = 0i;
                }
                let _e777 = phi_1100_;
                if (_e774 < _e755) {
                    phi_1105_ = _e774;
                } else {
                    phi_1105_ = _e755;
                }
                let _e780 = phi_1105_;
                if (_e777 < _e755) {
                    phi_1110_ = _e777;
                } else {
                    phi_1110_ = _e755;
                }
                let _e783 = phi_1110_;
                let _e784 = bitcast<u32>(_e780);
                let _e786 = (bitcast<u32>(_e767) * _e748);
                let _e787 = (bitcast<u32>(_e783) * _e748);
                let _e792 = ((_e786 + _e768) + _e753);
                let _e793 = ((_e786 + _e784) + _e753);
                let _e794 = ((_e787 + _e768) + _e753);
                let _e795 = ((_e787 + _e784) + _e753);
                if (_e792 < _e47) {
                } else {
                    return;
                }
                let _e799 = map.member[(0u + _e792)];
                if (_e793 < _e47) {
                } else {
                    return;
                }
                let _e803 = map.member[(0u + _e793)];
                if (_e794 < _e47) {
                } else {
                    return;
                }
                let _e807 = map.member[(0u + _e794)];
                if (_e795 < _e47) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e795)];
                let _e813 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e799, _e803, _e807, _e811), vec4<f32>(((1f - _e715) * (1f - _e716)), (_e715 * (1f - _e716)), ((1f - _e715) * _e716), (_e715 * _e716)), _e651);
                let _e815 = p.member.fade_uv;
                if (_e815 > 0f) {
                    let _e818 = local_4;
                    if ((_e818.level + 1u) == _e65) {
                        let _e827 = p.member.fade_uv;
                        let _e829 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e417.point.uv.x, (1f - _e417.point.uv.x));
                        let _e831 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e417.point.uv.y, (1f - _e417.point.uv.y));
                        let _e832 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e829, _e831);
                        if (_e832 < _e827) {
                            phi_1182_ = (1f - ((1f - _e813) * (_e832 / _e827)));
                        } else {
                            phi_1182_ = _e813;
                        }
                        let _e839 = phi_1182_;
                        phi_1184_ = evaluate_Verdict(_e839, false);
                        phi_1185_ = false;
                    } else {
                        phi_1184_ = evaluate_Verdict();
                        phi_1185_ = true;
                    }
                    let _e842 = phi_1184_;
                    let _e844 = phi_1185_;
                    phi_1186_ = _e842;
                    phi_1187_ = _e844;
                } else {
                    phi_1186_ = evaluate_Verdict();
                    phi_1187_ = true;
                }
                let _e846 = phi_1186_;
                let _e848 = phi_1187_;
                if _e848 {
                    phi_1192_ = evaluate_Verdict(_e813, false);
                    phi_1193_ = false;
                } else {
                    phi_1192_ = evaluate_Verdict();
                    phi_1193_ = true;
                }
                let _e851 = phi_1192_;
                let _e853 = phi_1193_;
                phi_1195_ = _e851;
                phi_1196_ = _e846;
                phi_1197_ = _e853;
            } else {
                phi_1195_ = evaluate_Verdict();
                phi_1196_ = evaluate_Verdict(1f, false);
                phi_1197_ = true;
            }
            let _e856 = phi_1195_;
            let _e858 = phi_1196_;
            let _e860 = phi_1197_;
            if _e860 {
            }
            phi_1201_ = _e858;
            phi_1202_ = _e856;
            phi_1203_ = _e860;
        }
        let _e862 = phi_1201_;
        let _e864 = phi_1202_;
        let _e866 = phi_1203_;
        if _e866 {
            phi_1207_ = _e862;
        } else {
            phi_1207_ = _e864;
        }
        let _e868 = phi_1207_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e868.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
