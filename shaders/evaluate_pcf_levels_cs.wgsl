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
    pad0_: u32,
    pad1_: u32,
}

struct type_31 {
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
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_141_: lt_bvh_traverse_Tree;
    var phi_142_: bool;
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_149_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_141_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_142_ = false;
        } else {
            phi_141_ = lt_bvh_traverse_Tree();
            phi_142_ = true;
        }
        let _e51 = phi_141_;
        let _e53 = phi_142_;
        phi_143_ = _e51;
        phi_144_ = _e53;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e55 = phi_143_;
    let _e57 = phi_144_;
    if _e57 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e55;
    }
    let _e62 = phi_149_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_176_: f32;
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_290_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_328_: f32;
    var phi_329_: f32;
    var phi_330_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_358_: f32;

    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_178_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_177_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_176_ = 1f;
            } else {
                phi_176_ = param_5.x;
            }
            let _e49 = phi_176_;
            phi_177_ = _e49;
        }
        let _e51 = phi_177_;
        phi_178_ = _e51;
    }
    let _e53 = phi_178_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_196_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_195_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_194_ = 1f;
            } else {
                phi_194_ = param_5.y;
            }
            let _e61 = phi_194_;
            phi_195_ = _e61;
        }
        let _e63 = phi_195_;
        phi_196_ = _e63;
    }
    let _e65 = phi_196_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_214_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_213_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_212_ = 1f;
            } else {
                phi_212_ = param_5.z;
            }
            let _e73 = phi_212_;
            phi_213_ = _e73;
        }
        let _e75 = phi_213_;
        phi_214_ = _e75;
    }
    let _e77 = phi_214_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_232_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_231_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_230_ = 1f;
            } else {
                phi_230_ = param_5.w;
            }
            let _e85 = phi_230_;
            phi_231_ = _e85;
        }
        let _e87 = phi_231_;
        phi_232_ = _e87;
    }
    let _e89 = phi_232_;
    let _e90 = (*param_4);
    let _e91 = (_e53 + _e90);
    let _e92 = (_e65 + _e90);
    let _e93 = (_e77 + _e90);
    let _e94 = (_e89 + _e90);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_254_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_253_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_252_ = 1f;
            } else {
                phi_252_ = param_7;
            }
            let _e101 = phi_252_;
            phi_253_ = _e101;
        }
        let _e103 = phi_253_;
        phi_254_ = _e103;
    }
    let _e105 = phi_254_;
    if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
        phi_273_ = _e91;
    } else {
        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
            phi_272_ = _e105;
        } else {
            if (_e91 < _e105) {
                phi_271_ = 0f;
            } else {
                phi_271_ = 1f;
            }
            let _e114 = phi_271_;
            phi_272_ = _e114;
        }
        let _e116 = phi_272_;
        phi_273_ = _e116;
    }
    let _e118 = phi_273_;
    if ((bitcast<u32>(_e92) & 2147483647u) > 2139095040u) {
        phi_292_ = _e92;
    } else {
        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
            phi_291_ = _e105;
        } else {
            if (_e92 < _e105) {
                phi_290_ = 0f;
            } else {
                phi_290_ = 1f;
            }
            let _e127 = phi_290_;
            phi_291_ = _e127;
        }
        let _e129 = phi_291_;
        phi_292_ = _e129;
    }
    let _e131 = phi_292_;
    if ((bitcast<u32>(_e93) & 2147483647u) > 2139095040u) {
        phi_311_ = _e93;
    } else {
        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
            phi_310_ = _e105;
        } else {
            if (_e93 < _e105) {
                phi_309_ = 0f;
            } else {
                phi_309_ = 1f;
            }
            let _e140 = phi_309_;
            phi_310_ = _e140;
        }
        let _e142 = phi_310_;
        phi_311_ = _e142;
    }
    let _e144 = phi_311_;
    if ((bitcast<u32>(_e94) & 2147483647u) > 2139095040u) {
        phi_330_ = _e94;
    } else {
        if ((bitcast<u32>(_e105) & 2147483647u) > 2139095040u) {
            phi_329_ = _e105;
        } else {
            if (_e94 < _e105) {
                phi_328_ = 0f;
            } else {
                phi_328_ = 1f;
            }
            let _e153 = phi_328_;
            phi_329_ = _e153;
        }
        let _e155 = phi_329_;
        phi_330_ = _e155;
    }
    let _e157 = phi_330_;
    let _e168 = ((((_e118 * param_6.x) + (_e131 * param_6.y)) + (_e144 * param_6.z)) + (_e157 * param_6.w));
    if ((bitcast<u32>(_e168) & 2147483647u) > 2139095040u) {
        phi_358_ = _e168;
    } else {
        if (_e168 < 0f) {
            phi_357_ = 0f;
        } else {
            if (_e168 > 1f) {
                phi_356_ = 1f;
            } else {
                phi_356_ = _e168;
            }
            let _e175 = phi_356_;
            phi_357_ = _e175;
        }
        let _e177 = phi_357_;
        phi_358_ = _e177;
    }
    let _e179 = phi_358_;
    return _e179;
}

fn function_() {
    var local: f32;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_425_: bool;
    var phi_495_: bool;
    var phi_496_: bool;
    var phi_507_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_508_: bool;
    var phi_509_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_510_: bool;
    var phi_517_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_521_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_541_: lt_math_LightPoint;
    var phi_544_: u32;
    var phi_546_: lt_math_LevelPoint;
    var phi_632_: bool;
    var phi_641_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_660_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_694_: bool;
    var phi_698_: bool;
    var phi_707_: lt_math_LightPoint;
    var phi_708_: u32;
    var phi_709_: lt_math_LevelPoint;
    var phi_710_: bool;
    var phi_542_: lt_math_LightPoint;
    var phi_545_: u32;
    var phi_547_: lt_math_LevelPoint;
    var phi_711_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_751_: bool;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_758_: bool;
    var phi_840_: f32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_960_: f32;
    var phi_989_: f32;
    var phi_994_: f32;
    var phi_995_: bool;
    var phi_996_: f32;
    var phi_997_: bool;
    var phi_1001_: f32;
    var phi_1021_: f32;
    var phi_1026_: f32;
    var phi_1027_: bool;
    var phi_1028_: f32;
    var phi_1029_: bool;
    var phi_1033_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1082_: i32;
    var phi_1087_: i32;
    var phi_1092_: i32;
    var phi_1097_: i32;
    var phi_1106_: i32;
    var phi_1111_: i32;
    var phi_1116_: i32;
    var phi_1121_: i32;
    var phi_1166_: evaluate_Verdict;
    var phi_1167_: evaluate_Verdict;
    var phi_1168_: bool;
    var phi_1169_: evaluate_Verdict;
    var phi_1170_: evaluate_Verdict;
    var phi_1171_: bool;
    var phi_1175_: evaluate_Verdict;

    let _e39 = id_1;
    let _e46 = arrayLength((&map.member));
    let _e52 = arrayLength((&levels.member));
    let _e55 = p.member.size[0u];
    let _e57 = p.member.size[1u];
    let _e58 = lt_shaders_entry_pixel_index(_e39, _e55, _e57);
    if (bitcast<i32>(_e58.root) != 0i) {
        let _e64 = p.member.level_count;
        if (_e58.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e71 = samples.member[(0u + _e58.first_primitive)].normal[0u];
        let _e73 = global[0u];
        if (_e71 == _e73) {
            let _e76 = samples.member[(0u + _e58.first_primitive)].normal[1u];
            let _e78 = global[1u];
            if (_e76 == _e78) {
                let _e81 = samples.member[(0u + _e58.first_primitive)].normal[2u];
                let _e83 = global[2u];
                phi_418_ = (_e81 == _e83);
                phi_419_ = false;
            } else {
                phi_418_ = bool();
                phi_419_ = true;
            }
            let _e86 = phi_418_;
            let _e88 = phi_419_;
            phi_420_ = _e86;
            phi_421_ = _e88;
        } else {
            phi_420_ = bool();
            phi_421_ = true;
        }
        let _e90 = phi_420_;
        let _e92 = phi_421_;
        if _e92 {
            phi_425_ = false;
        } else {
            phi_425_ = _e90;
        }
        let _e94 = phi_425_;
        if !(_e94) {
            let _e97 = samples.member[(0u + _e58.first_primitive)].position;
            let _e99 = p.member.light.place;
            let _e105 = p.member.light.place[3u];
            let _e112 = (_e99.x - (_e97.x * _e105));
            let _e113 = (_e99.y - (_e97.y * _e105));
            let _e114 = (_e99.z - (_e97.z * _e105));
            let _e116 = samples.member[(0u + _e58.first_primitive)].normal;
            if ((((_e116.x * _e112) + (_e116.y * _e113)) + (_e116.z * _e114)) > 0f) {
                let _e130 = (((_e112 * _e112) + (_e113 * _e113)) + (_e114 * _e114));
                let _e132 = p.member.light.axis;
                let _e144 = p.member.light.place[3u];
                if (_e144 == 0f) {
                    phi_496_ = true;
                } else {
                    let _e147 = p.member.light.range_squared;
                    if (_e130 <= _e147) {
                        let _e150 = p.member.light.cos_outer;
                        phi_495_ = (-((((_e112 * _e132.x) + (_e113 * _e132.y)) + (_e114 * _e132.z))) >= (_e150 * sqrt(_e130)));
                    } else {
                        phi_495_ = false;
                    }
                    let _e155 = phi_495_;
                    phi_496_ = _e155;
                }
                let _e157 = phi_496_;
                if _e157 {
                    let _e159 = samples.member[(0u + _e58.first_primitive)].flags;
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
                    phi_507_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, ((_e159 & 1u) == 0u));
                    phi_508_ = false;
                } else {
                    phi_507_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_508_ = true;
                }
                let _e178 = phi_507_;
                let _e180 = phi_508_;
                phi_509_ = _e178;
                phi_510_ = _e180;
            } else {
                phi_509_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_510_ = true;
            }
            let _e182 = phi_509_;
            let _e184 = phi_510_;
            if _e184 {
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                phi_517_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, true);
            } else {
                phi_517_ = _e182;
            }
            let _e201 = phi_517_;
            phi_521_ = _e201;
        } else {
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e207.unnamed.visibility, false), _e207.unnamed_1);
            phi_521_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e213.unnamed, true);
        }
        let _e218 = phi_521_;
        if _e218.unnamed_1 {
            phi_1169_ = evaluate_Verdict(_e218.unnamed.visibility, _e218.unnamed.is_doubted);
            phi_1170_ = evaluate_Verdict();
            phi_1171_ = true;
        } else {
            let _e226 = samples.member[(0u + _e58.first_primitive)].position;
            let _e228 = p.member.map_size;
            let _e230 = (0.5f / f32(_e228));
            let _e237 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e244 = lt_math_LightPoint(vec2<f32>(_e237.uv.x, 0f), _e237.depth, _e237.is_inside);
            let _e248 = lt_math_LightPoint(_e244.uv, 0f, _e244.is_inside);
            phi_541_ = lt_math_LightPoint();
            phi_544_ = 0u;
            phi_546_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e248.uv, _e248.depth, false));
            loop {
                let _e255 = phi_541_;
                let _e257 = phi_544_;
                let _e259 = phi_546_;
                local_1 = _e259;
                local_2 = _e259;
                local_3 = _e259;
                if (_e257 < _e64) {
                    if _e259.point.is_inside {
                        phi_707_ = lt_math_LightPoint();
                        phi_708_ = u32();
                        phi_709_ = lt_math_LevelPoint();
                        phi_710_ = false;
                    } else {
                        if (_e257 < _e52) {
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
                                phi_632_ = (_e295 <= 1f);
                            } else {
                                phi_632_ = false;
                            }
                            let _e327 = phi_632_;
                            if _e327 {
                                if (_e309 >= 0f) {
                                    phi_641_ = (_e309 <= 1f);
                                } else {
                                    phi_641_ = false;
                                }
                                let _e331 = phi_641_;
                                if _e331 {
                                    if (_e322 >= 0f) {
                                        phi_650_ = (_e322 <= 1f);
                                    } else {
                                        phi_650_ = false;
                                    }
                                    let _e335 = phi_650_;
                                    phi_651_ = _e335;
                                    phi_652_ = false;
                                } else {
                                    phi_651_ = bool();
                                    phi_652_ = true;
                                }
                                let _e337 = phi_651_;
                                let _e339 = phi_652_;
                                phi_653_ = _e337;
                                phi_654_ = _e339;
                            } else {
                                phi_653_ = bool();
                                phi_654_ = true;
                            }
                            let _e341 = phi_653_;
                            let _e343 = phi_654_;
                            phi_655_ = _e341;
                            phi_656_ = _e343;
                        } else {
                            phi_655_ = bool();
                            phi_656_ = true;
                        }
                        let _e345 = phi_655_;
                        let _e347 = phi_656_;
                        if _e347 {
                            phi_660_ = false;
                        } else {
                            phi_660_ = _e345;
                        }
                        let _e349 = phi_660_;
                        if _e349 {
                            if (_e295 >= _e230) {
                                if (_e295 <= (1f - _e230)) {
                                    if (_e309 >= _e230) {
                                        phi_687_ = (_e309 <= (1f - _e230));
                                        phi_688_ = false;
                                    } else {
                                        phi_687_ = bool();
                                        phi_688_ = true;
                                    }
                                    let _e357 = phi_687_;
                                    let _e359 = phi_688_;
                                    phi_689_ = _e357;
                                    phi_690_ = _e359;
                                } else {
                                    phi_689_ = bool();
                                    phi_690_ = true;
                                }
                                let _e361 = phi_689_;
                                let _e363 = phi_690_;
                                phi_691_ = _e361;
                                phi_692_ = _e363;
                            } else {
                                phi_691_ = bool();
                                phi_692_ = true;
                            }
                            let _e365 = phi_691_;
                            let _e367 = phi_692_;
                            phi_693_ = _e365;
                            phi_694_ = _e367;
                        } else {
                            phi_693_ = bool();
                            phi_694_ = true;
                        }
                        let _e369 = phi_693_;
                        let _e371 = phi_694_;
                        if _e371 {
                            phi_698_ = false;
                        } else {
                            phi_698_ = _e369;
                        }
                        let _e373 = phi_698_;
                        let _e380 = lt_math_LightPoint(vec2<f32>(_e295, _e255.uv.y), _e255.depth, _e255.is_inside);
                        let _e387 = lt_math_LightPoint(vec2<f32>(_e380.uv.x, _e309), _e380.depth, _e380.is_inside);
                        let _e391 = lt_math_LightPoint(_e387.uv, _e322, _e387.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e391.depth, _e373);
                        phi_707_ = _e395;
                        phi_708_ = (_e257 + 1u);
                        phi_709_ = lt_math_LevelPoint(_e257, _e395);
                        phi_710_ = true;
                    }
                    let _e399 = phi_707_;
                    let _e401 = phi_708_;
                    let _e403 = phi_709_;
                    let _e405 = phi_710_;
                    phi_542_ = _e399;
                    phi_545_ = _e401;
                    phi_547_ = _e403;
                    phi_711_ = _e405;
                } else {
                    phi_542_ = lt_math_LightPoint();
                    phi_545_ = u32();
                    phi_547_ = lt_math_LevelPoint();
                    phi_711_ = false;
                }
                let _e407 = phi_542_;
                let _e409 = phi_545_;
                let _e411 = phi_547_;
                let _e413 = phi_711_;
                continue;
                continuing {
                    phi_541_ = _e407;
                    phi_544_ = _e409;
                    phi_546_ = _e411;
                    break if !(_e413);
                }
            }
            let _e416 = local_1;
            if _e416.point.is_inside {
                if (1f > 0f) {
                    let _e422 = local_2;
                    if (_e422.level < _e52) {
                    } else {
                        return;
                    }
                    let _e427 = levels.member[(0u + _e422.level)];
                    let _e433 = global[0u];
                    if (_e427.row_w.x == _e433) {
                        let _e436 = global[1u];
                        if (_e427.row_w.y == _e436) {
                            let _e439 = global[2u];
                            phi_751_ = (_e427.row_w.z == _e439);
                            phi_752_ = false;
                        } else {
                            phi_751_ = bool();
                            phi_752_ = true;
                        }
                        let _e442 = phi_751_;
                        let _e444 = phi_752_;
                        phi_753_ = _e442;
                        phi_754_ = _e444;
                    } else {
                        phi_753_ = bool();
                        phi_754_ = true;
                    }
                    let _e446 = phi_753_;
                    let _e448 = phi_754_;
                    if _e448 {
                        phi_758_ = false;
                    } else {
                        phi_758_ = _e446;
                    }
                    let _e450 = phi_758_;
                    if _e450 {
                        let _e452 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e454 = p.member.map_size;
                        let _e524 = ((abs(((((_e427.row_x.x * _e452.x) + (_e427.row_x.y * _e452.y)) + (_e427.row_x.z * _e452.z)) / (((_e427.row_x.x * _e427.row_x.x) + (_e427.row_x.y * _e427.row_x.y)) + (_e427.row_x.z * _e427.row_x.z)))) + abs(((((_e427.row_y.x * _e452.x) + (_e427.row_y.y * _e452.y)) + (_e427.row_y.z * _e452.z)) / (((_e427.row_y.x * _e427.row_y.x) + (_e427.row_y.y * _e427.row_y.y)) + (_e427.row_y.z * _e427.row_y.z))))) / (abs(((((_e427.row_z.x * _e452.x) + (_e427.row_z.y * _e452.y)) + (_e427.row_z.z * _e452.z)) / (((_e427.row_z.x * _e427.row_z.x) + (_e427.row_z.y * _e427.row_z.y)) + (_e427.row_z.z * _e427.row_z.z)))) * f32(_e454)));
                        if (_e524 < 0.002f) {
                            phi_840_ = _e524;
                        } else {
                            phi_840_ = 0.002f;
                        }
                        let _e527 = phi_840_;
                        phi_957_ = _e527;
                    } else {
                        let _e529 = p.member.map_size;
                        let _e535 = samples.member[(0u + _e58.first_primitive)].position;
                        let _e546 = ((((_e427.row_w.x * _e535.x) + (_e427.row_w.y * _e535.y)) + (_e427.row_w.z * _e535.z)) + _e427.row_w.w);
                        let _e559 = ((_e427.row_x.x - (_e427.row_w.x * _e416.point.uv.x)) / _e546);
                        let _e560 = ((_e427.row_x.y - (_e427.row_w.y * _e416.point.uv.x)) / _e546);
                        let _e561 = ((_e427.row_x.z - (_e427.row_w.z * _e416.point.uv.x)) / _e546);
                        let _e574 = ((_e427.row_y.x - (_e427.row_w.x * _e416.point.uv.y)) / _e546);
                        let _e575 = ((_e427.row_y.y - (_e427.row_w.y * _e416.point.uv.y)) / _e546);
                        let _e576 = ((_e427.row_y.z - (_e427.row_w.z * _e416.point.uv.y)) / _e546);
                        let _e582 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e587 = ((_e575 * _e582.z) - (_e582.y * _e576));
                        let _e592 = ((_e576 * _e582.x) - (_e582.z * _e574));
                        let _e597 = ((_e574 * _e582.y) - (_e582.x * _e575));
                        let _e599 = samples.member[(0u + _e58.first_primitive)].normal;
                        let _e604 = ((_e560 * _e599.z) - (_e599.y * _e561));
                        let _e609 = ((_e561 * _e599.x) - (_e599.z * _e559));
                        let _e614 = ((_e559 * _e599.y) - (_e599.x * _e560));
                        let _e641 = ((abs(((((_e427.row_z.x * _e587) + (_e427.row_z.y * _e592)) + (_e427.row_z.z * _e597)) / (((_e559 * _e587) + (_e560 * _e592)) + (_e561 * _e597)))) + abs(((((_e427.row_z.x * _e604) + (_e427.row_z.y * _e609)) + (_e427.row_z.z * _e614)) / (((_e574 * _e604) + (_e575 * _e609)) + (_e576 * _e614))))) / f32(_e529));
                        if (_e641 < 0.002f) {
                            phi_956_ = _e641;
                        } else {
                            phi_956_ = 0.002f;
                        }
                        let _e644 = phi_956_;
                        phi_957_ = _e644;
                    }
                    let _e646 = phi_957_;
                    phi_960_ = (_e416.point.depth - (1f * _e646));
                } else {
                    phi_960_ = _e416.point.depth;
                }
                let _e650 = phi_960_;
                let _e656 = p.member.map_size;
                let _e657 = f32(_e656);
                let _e660 = ((_e416.point.uv.x * _e657) - 0.5f);
                let _e661 = ((_e416.point.uv.y * _e657) - 0.5f);
                if (_e660 > -8388608f) {
                    let _e673 = f32(select(0i, select(select(i32(_e660), i32(-2147483648), (_e660 < bitcast<f32>(3472883712u))), 2147483647i, (_e660 > bitcast<f32>(1325400063u))), (_e660 == _e660)));
                    if (_e673 > _e660) {
                        phi_989_ = 1f;
                    } else {
                        phi_989_ = 0f;
                    }
                    let _e676 = phi_989_;
                    if (_e660 < 8388608f) {
                        phi_994_ = (_e673 - _e676);
                        phi_995_ = false;
                    } else {
                        phi_994_ = f32();
                        phi_995_ = true;
                    }
                    let _e679 = phi_994_;
                    let _e681 = phi_995_;
                    phi_996_ = _e679;
                    phi_997_ = _e681;
                } else {
                    phi_996_ = f32();
                    phi_997_ = true;
                }
                let _e683 = phi_996_;
                let _e685 = phi_997_;
                if _e685 {
                    phi_1001_ = _e660;
                } else {
                    phi_1001_ = _e683;
                }
                let _e687 = phi_1001_;
                if (_e661 > -8388608f) {
                    let _e699 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e699 > _e661) {
                        phi_1021_ = 1f;
                    } else {
                        phi_1021_ = 0f;
                    }
                    let _e702 = phi_1021_;
                    if (_e661 < 8388608f) {
                        phi_1026_ = (_e699 - _e702);
                        phi_1027_ = false;
                    } else {
                        phi_1026_ = f32();
                        phi_1027_ = true;
                    }
                    let _e705 = phi_1026_;
                    let _e707 = phi_1027_;
                    phi_1028_ = _e705;
                    phi_1029_ = _e707;
                } else {
                    phi_1028_ = f32();
                    phi_1029_ = true;
                }
                let _e709 = phi_1028_;
                let _e711 = phi_1029_;
                if _e711 {
                    phi_1033_ = _e661;
                } else {
                    phi_1033_ = _e709;
                }
                let _e713 = phi_1033_;
                let _e714 = (_e660 - _e687);
                let _e715 = (_e661 - _e713);
                let _e724 = select(0i, select(select(i32(_e687), i32(-2147483648), (_e687 < bitcast<f32>(3472883712u))), 2147483647i, (_e687 > bitcast<f32>(1325400063u))), (_e687 == _e687));
                let _e733 = select(0i, select(select(i32(_e713), i32(-2147483648), (_e713 < bitcast<f32>(3472883712u))), 2147483647i, (_e713 > bitcast<f32>(1325400063u))), (_e713 == _e713));
                let _e744 = p.member.test;
                let _e745 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_3;
                local = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e724 > 0i) {
                    phi_1082_ = _e724;
                } else {
                    phi_1082_ = 0i;
                }
                let _e757 = phi_1082_;
                if (_e733 > 0i) {
                    phi_1087_ = _e733;
                } else {
                    phi_1087_ = 0i;
                }
                let _e760 = phi_1087_;
                if (_e757 < _e754) {
                    phi_1092_ = _e757;
                } else {
                    phi_1092_ = _e754;
                }
                let _e763 = phi_1092_;
                if (_e760 < _e754) {
                    phi_1097_ = _e760;
                } else {
                    phi_1097_ = _e754;
                }
                let _e766 = phi_1097_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e724 + 1i);
                let _e770 = (_e733 + 1i);
                if (_e769 > 0i) {
                    phi_1106_ = _e769;
                } else {
                    phi_1106_ = 0i;
                }
                let _e773 = phi_1106_;
                if (_e770 > 0i) {
                    phi_1111_ = _e770;
                } else {
                    phi_1111_ = 0i;
                }
                let _e776 = phi_1111_;
                if (_e773 < _e754) {
                    phi_1116_ = _e773;
                } else {
                    phi_1116_ = _e754;
                }
                let _e779 = phi_1116_;
                if (_e776 < _e754) {
                    phi_1121_ = _e776;
                } else {
                    phi_1121_ = _e754;
                }
                let _e782 = phi_1121_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (bitcast<u32>(_e766) * _e747);
                let _e786 = (bitcast<u32>(_e782) * _e747);
                let _e791 = ((_e785 + _e767) + _e752);
                let _e792 = ((_e785 + _e783) + _e752);
                let _e793 = ((_e786 + _e767) + _e752);
                let _e794 = ((_e786 + _e783) + _e752);
                if (_e791 < _e46) {
                } else {
                    return;
                }
                let _e798 = map.member[(0u + _e791)];
                if (_e792 < _e46) {
                } else {
                    return;
                }
                let _e802 = map.member[(0u + _e792)];
                if (_e793 < _e46) {
                } else {
                    return;
                }
                let _e806 = map.member[(0u + _e793)];
                if (_e794 < _e46) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e794)];
                let _e812 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e798, _e802, _e806, _e810), vec4<f32>(((1f - _e714) * (1f - _e715)), (_e714 * (1f - _e715)), ((1f - _e714) * _e715), (_e714 * _e715)), _e650);
                phi_1166_ = evaluate_Verdict(_e812, false);
                phi_1167_ = evaluate_Verdict();
                phi_1168_ = false;
            } else {
                phi_1166_ = evaluate_Verdict();
                phi_1167_ = evaluate_Verdict(1f, false);
                phi_1168_ = true;
            }
            let _e816 = phi_1166_;
            let _e818 = phi_1167_;
            let _e820 = phi_1168_;
            phi_1169_ = _e818;
            phi_1170_ = _e816;
            phi_1171_ = _e820;
        }
        let _e822 = phi_1169_;
        let _e824 = phi_1170_;
        let _e826 = phi_1171_;
        if _e826 {
            phi_1175_ = _e822;
        } else {
            phi_1175_ = _e824;
        }
        let _e828 = phi_1175_;
        if (_e58.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e58.first_primitive)] = _e828.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
