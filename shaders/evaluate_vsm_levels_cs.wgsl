struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
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

struct type_31 {
    member: abi_ShadowParams,
}

struct type_35 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e52 = phi_143_;
        let _e54 = phi_144_;
        phi_145_ = _e52;
        phi_146_ = _e54;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e56 = phi_145_;
    let _e58 = phi_146_;
    if _e58 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e56;
    }
    let _e63 = phi_151_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_297_: bool;
    var phi_301_: f32;
    var phi_313_: bool;
    var phi_320_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_337_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_179_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_178_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_177_ = 1f;
            } else {
                phi_177_ = param_7;
            }
            let _e49 = phi_177_;
            phi_178_ = _e49;
        }
        let _e51 = phi_178_;
        phi_179_ = _e51;
    }
    let _e53 = phi_179_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_197_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_5.x;
            }
            let _e61 = phi_195_;
            phi_196_ = _e61;
        }
        let _e63 = phi_196_;
        phi_197_ = _e63;
    }
    let _e65 = phi_197_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_215_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_214_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_213_ = 1f;
            } else {
                phi_213_ = param_5.y;
            }
            let _e73 = phi_213_;
            phi_214_ = _e73;
        }
        let _e75 = phi_214_;
        phi_215_ = _e75;
    }
    let _e77 = phi_215_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_233_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_232_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_231_ = 1f;
            } else {
                phi_231_ = param_5.z;
            }
            let _e85 = phi_231_;
            phi_232_ = _e85;
        }
        let _e87 = phi_232_;
        phi_233_ = _e87;
    }
    let _e89 = phi_233_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_251_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_250_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_249_ = 1f;
            } else {
                phi_249_ = param_5.w;
            }
            let _e97 = phi_249_;
            phi_250_ = _e97;
        }
        let _e99 = phi_250_;
        phi_251_ = _e99;
    }
    let _e101 = phi_251_;
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
        phi_297_ = true;
    } else {
        let _e140 = (_e106 > _e136);
        if _e140 {
        }
        phi_297_ = _e140;
    }
    let _e142 = phi_297_;
    if _e142 {
        phi_301_ = _e106;
    } else {
        phi_301_ = _e136;
    }
    let _e144 = phi_301_;
    let _e145 = -(_e117);
    if (_e145 <= 0f) {
        let _e149 = ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u);
        if _e149 {
        }
        phi_313_ = _e149;
    } else {
        phi_313_ = true;
    }
    let _e151 = phi_313_;
    if _e151 {
        phi_320_ = (_e144 / (_e144 + (_e145 * _e145)));
    } else {
        phi_320_ = 1f;
    }
    let _e156 = phi_320_;
    if ((bitcast<u32>(_e156) & 2147483647u) > 2139095040u) {
        phi_337_ = _e156;
    } else {
        if (_e156 < 0f) {
            phi_336_ = 0f;
        } else {
            if (_e156 > 1f) {
                phi_335_ = 1f;
            } else {
                phi_335_ = _e156;
            }
            let _e163 = phi_335_;
            phi_336_ = _e163;
        }
        let _e165 = phi_336_;
        phi_337_ = _e165;
    }
    let _e167 = phi_337_;
    return _e167;
}

fn function_() {
    var local: f32;
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
    var phi_520_: lt_math_LightPoint;
    var phi_523_: u32;
    var phi_525_: lt_math_LevelPoint;
    var phi_611_: bool;
    var phi_620_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_639_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_677_: bool;
    var phi_686_: lt_math_LightPoint;
    var phi_687_: u32;
    var phi_688_: lt_math_LevelPoint;
    var phi_689_: bool;
    var phi_521_: lt_math_LightPoint;
    var phi_524_: u32;
    var phi_526_: lt_math_LevelPoint;
    var phi_690_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_737_: bool;
    var phi_819_: f32;
    var phi_937_: f32;
    var phi_938_: f32;
    var phi_941_: f32;
    var phi_970_: f32;
    var phi_975_: f32;
    var phi_976_: bool;
    var phi_977_: f32;
    var phi_978_: bool;
    var phi_982_: f32;
    var phi_1002_: f32;
    var phi_1007_: f32;
    var phi_1008_: bool;
    var phi_1009_: f32;
    var phi_1010_: bool;
    var phi_1014_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1063_: i32;
    var phi_1068_: i32;
    var phi_1073_: i32;
    var phi_1078_: i32;
    var phi_1087_: i32;
    var phi_1092_: i32;
    var phi_1097_: i32;
    var phi_1102_: i32;
    var phi_1147_: evaluate_Verdict;
    var phi_1148_: evaluate_Verdict;
    var phi_1149_: bool;
    var phi_1150_: evaluate_Verdict;
    var phi_1151_: evaluate_Verdict;
    var phi_1152_: bool;
    var phi_1156_: evaluate_Verdict;

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
                phi_397_ = (_e82 == _e84);
                phi_398_ = false;
            } else {
                phi_397_ = bool();
                phi_398_ = true;
            }
            let _e87 = phi_397_;
            let _e89 = phi_398_;
            phi_399_ = _e87;
            phi_400_ = _e89;
        } else {
            phi_399_ = bool();
            phi_400_ = true;
        }
        let _e91 = phi_399_;
        let _e93 = phi_400_;
        if _e93 {
            phi_404_ = false;
        } else {
            phi_404_ = _e91;
        }
        let _e95 = phi_404_;
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
                    phi_475_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_474_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_474_ = false;
                    }
                    let _e156 = phi_474_;
                    phi_475_ = _e156;
                }
                let _e158 = phi_475_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_487_ = false;
                } else {
                    phi_486_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_487_ = true;
                }
                let _e179 = phi_486_;
                let _e181 = phi_487_;
                phi_488_ = _e179;
                phi_489_ = _e181;
            } else {
                phi_488_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_489_ = true;
            }
            let _e183 = phi_488_;
            let _e185 = phi_489_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_496_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_496_ = _e183;
            }
            let _e202 = phi_496_;
            phi_500_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_500_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_500_;
        if _e219.unnamed_1 {
            phi_1150_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
            phi_1151_ = evaluate_Verdict();
            phi_1152_ = true;
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_520_ = lt_math_LightPoint();
            phi_523_ = 0u;
            phi_525_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_520_;
                let _e258 = phi_523_;
                let _e260 = phi_525_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_686_ = lt_math_LightPoint();
                        phi_687_ = u32();
                        phi_688_ = lt_math_LevelPoint();
                        phi_689_ = false;
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
                                phi_611_ = (_e296 <= 1f);
                            } else {
                                phi_611_ = false;
                            }
                            let _e328 = phi_611_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_620_ = (_e310 <= 1f);
                                } else {
                                    phi_620_ = false;
                                }
                                let _e332 = phi_620_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_629_ = (_e323 <= 1f);
                                    } else {
                                        phi_629_ = false;
                                    }
                                    let _e336 = phi_629_;
                                    phi_630_ = _e336;
                                    phi_631_ = false;
                                } else {
                                    phi_630_ = bool();
                                    phi_631_ = true;
                                }
                                let _e338 = phi_630_;
                                let _e340 = phi_631_;
                                phi_632_ = _e338;
                                phi_633_ = _e340;
                            } else {
                                phi_632_ = bool();
                                phi_633_ = true;
                            }
                            let _e342 = phi_632_;
                            let _e344 = phi_633_;
                            phi_634_ = _e342;
                            phi_635_ = _e344;
                        } else {
                            phi_634_ = bool();
                            phi_635_ = true;
                        }
                        let _e346 = phi_634_;
                        let _e348 = phi_635_;
                        if _e348 {
                            phi_639_ = false;
                        } else {
                            phi_639_ = _e346;
                        }
                        let _e350 = phi_639_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_666_ = (_e310 <= (1f - _e231));
                                        phi_667_ = false;
                                    } else {
                                        phi_666_ = bool();
                                        phi_667_ = true;
                                    }
                                    let _e358 = phi_666_;
                                    let _e360 = phi_667_;
                                    phi_668_ = _e358;
                                    phi_669_ = _e360;
                                } else {
                                    phi_668_ = bool();
                                    phi_669_ = true;
                                }
                                let _e362 = phi_668_;
                                let _e364 = phi_669_;
                                phi_670_ = _e362;
                                phi_671_ = _e364;
                            } else {
                                phi_670_ = bool();
                                phi_671_ = true;
                            }
                            let _e366 = phi_670_;
                            let _e368 = phi_671_;
                            phi_672_ = _e366;
                            phi_673_ = _e368;
                        } else {
                            phi_672_ = bool();
                            phi_673_ = true;
                        }
                        let _e370 = phi_672_;
                        let _e372 = phi_673_;
                        if _e372 {
                            phi_677_ = false;
                        } else {
                            phi_677_ = _e370;
                        }
                        let _e374 = phi_677_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_686_ = _e396;
                        phi_687_ = (_e258 + 1u);
                        phi_688_ = lt_math_LevelPoint(_e258, _e396);
                        phi_689_ = true;
                    }
                    let _e400 = phi_686_;
                    let _e402 = phi_687_;
                    let _e404 = phi_688_;
                    let _e406 = phi_689_;
                    phi_521_ = _e400;
                    phi_524_ = _e402;
                    phi_526_ = _e404;
                    phi_690_ = _e406;
                } else {
                    phi_521_ = lt_math_LightPoint();
                    phi_524_ = u32();
                    phi_526_ = lt_math_LevelPoint();
                    phi_690_ = false;
                }
                let _e408 = phi_521_;
                let _e410 = phi_524_;
                let _e412 = phi_526_;
                let _e414 = phi_690_;
                continue;
                continuing {
                    phi_520_ = _e408;
                    phi_523_ = _e410;
                    phi_525_ = _e412;
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
                            phi_730_ = (_e428.row_w.z == _e440);
                            phi_731_ = false;
                        } else {
                            phi_730_ = bool();
                            phi_731_ = true;
                        }
                        let _e443 = phi_730_;
                        let _e445 = phi_731_;
                        phi_732_ = _e443;
                        phi_733_ = _e445;
                    } else {
                        phi_732_ = bool();
                        phi_733_ = true;
                    }
                    let _e447 = phi_732_;
                    let _e449 = phi_733_;
                    if _e449 {
                        phi_737_ = false;
                    } else {
                        phi_737_ = _e447;
                    }
                    let _e451 = phi_737_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_819_ = _e525;
                        } else {
                            phi_819_ = 0.002f;
                        }
                        let _e528 = phi_819_;
                        phi_938_ = _e528;
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
                        let _e644 = (16f / f32(_e530));
                        if (_e642 < _e644) {
                            phi_937_ = _e642;
                        } else {
                            phi_937_ = _e644;
                        }
                        let _e647 = phi_937_;
                        phi_938_ = _e647;
                    }
                    let _e649 = phi_938_;
                    phi_941_ = (_e417.point.depth - (0f * _e649));
                } else {
                    phi_941_ = _e417.point.depth;
                }
                let _e653 = phi_941_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e417.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e417.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_970_ = 1f;
                    } else {
                        phi_970_ = 0f;
                    }
                    let _e679 = phi_970_;
                    if (_e663 < 8388608f) {
                        phi_975_ = (_e676 - _e679);
                        phi_976_ = false;
                    } else {
                        phi_975_ = f32();
                        phi_976_ = true;
                    }
                    let _e682 = phi_975_;
                    let _e684 = phi_976_;
                    phi_977_ = _e682;
                    phi_978_ = _e684;
                } else {
                    phi_977_ = f32();
                    phi_978_ = true;
                }
                let _e686 = phi_977_;
                let _e688 = phi_978_;
                if _e688 {
                    phi_982_ = _e663;
                } else {
                    phi_982_ = _e686;
                }
                let _e690 = phi_982_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1002_ = 1f;
                    } else {
                        phi_1002_ = 0f;
                    }
                    let _e705 = phi_1002_;
                    if (_e664 < 8388608f) {
                        phi_1007_ = (_e702 - _e705);
                        phi_1008_ = false;
                    } else {
                        phi_1007_ = f32();
                        phi_1008_ = true;
                    }
                    let _e708 = phi_1007_;
                    let _e710 = phi_1008_;
                    phi_1009_ = _e708;
                    phi_1010_ = _e710;
                } else {
                    phi_1009_ = f32();
                    phi_1010_ = true;
                }
                let _e712 = phi_1009_;
                let _e714 = phi_1010_;
                if _e714 {
                    phi_1014_ = _e664;
                } else {
                    phi_1014_ = _e712;
                }
                let _e716 = phi_1014_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e747 = p.member.test;
                let _e748 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_3;
                local = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e727 > 0i) {
                    phi_1063_ = _e727;
                } else {
                    phi_1063_ = 0i;
                }
                let _e760 = phi_1063_;
                if (_e736 > 0i) {
                    phi_1068_ = _e736;
                } else {
                    phi_1068_ = 0i;
                }
                let _e763 = phi_1068_;
                if (_e760 < _e757) {
                    phi_1073_ = _e760;
                } else {
                    phi_1073_ = _e757;
                }
                let _e766 = phi_1073_;
                if (_e763 < _e757) {
                    phi_1078_ = _e763;
                } else {
                    phi_1078_ = _e757;
                }
                let _e769 = phi_1078_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1087_ = _e772;
                } else {
                    phi_1087_ = 0i;
                }
                let _e776 = phi_1087_;
                if (_e773 > 0i) {
                    phi_1092_ = _e773;
                } else {
                    phi_1092_ = 0i;
                }
                let _e779 = phi_1092_;
                if (_e776 < _e757) {
                    phi_1097_ = _e776;
                } else {
                    phi_1097_ = _e757;
                }
                let _e782 = phi_1097_;
                if (_e779 < _e757) {
                    phi_1102_ = _e779;
                } else {
                    phi_1102_ = _e757;
                }
                let _e785 = phi_1102_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e47) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e47) {
                } else {
                    return;
                }
                let _e805 = map.member[(0u + _e795)];
                if (_e796 < _e47) {
                } else {
                    return;
                }
                let _e809 = map.member[(0u + _e796)];
                if (_e797 < _e47) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e797)];
                let _e815 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e801, _e805, _e809, _e813), vec4<f32>(((1f - _e717) * (1f - _e718)), (_e717 * (1f - _e718)), ((1f - _e717) * _e718), (_e717 * _e718)), _e653);
                phi_1147_ = evaluate_Verdict(_e815, false);
                phi_1148_ = evaluate_Verdict();
                phi_1149_ = false;
            } else {
                phi_1147_ = evaluate_Verdict();
                phi_1148_ = evaluate_Verdict(1f, false);
                phi_1149_ = true;
            }
            let _e819 = phi_1147_;
            let _e821 = phi_1148_;
            let _e823 = phi_1149_;
            phi_1150_ = _e821;
            phi_1151_ = _e819;
            phi_1152_ = _e823;
        }
        let _e825 = phi_1150_;
        let _e827 = phi_1151_;
        let _e829 = phi_1152_;
        if _e829 {
            phi_1156_ = _e825;
        } else {
            phi_1156_ = _e827;
        }
        let _e831 = phi_1156_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e831.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
