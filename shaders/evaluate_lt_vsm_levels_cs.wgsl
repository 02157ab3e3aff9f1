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
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_37;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_152_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_bvh_traverse_Tree();
            phi_145_ = true;
        }
        let _e52 = phi_144_;
        let _e54 = phi_145_;
        phi_146_ = _e52;
        phi_147_ = _e54;
    } else {
        phi_146_ = lt_bvh_traverse_Tree();
        phi_147_ = true;
    }
    let _e56 = phi_146_;
    let _e58 = phi_147_;
    if _e58 {
        phi_152_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_152_ = _e56;
    }
    let _e63 = phi_152_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_178_: f32;
    var phi_179_: f32;
    var phi_180_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_298_: bool;
    var phi_302_: f32;
    var phi_314_: bool;
    var phi_321_: f32;
    var phi_336_: f32;
    var phi_337_: f32;
    var phi_338_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_180_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_179_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_178_ = 1f;
            } else {
                phi_178_ = param_7;
            }
            let _e49 = phi_178_;
            phi_179_ = _e49;
        }
        let _e51 = phi_179_;
        phi_180_ = _e51;
    }
    let _e53 = phi_180_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_198_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_197_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_196_ = 1f;
            } else {
                phi_196_ = param_5.x;
            }
            let _e61 = phi_196_;
            phi_197_ = _e61;
        }
        let _e63 = phi_197_;
        phi_198_ = _e63;
    }
    let _e65 = phi_198_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_216_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_5.y;
            }
            let _e73 = phi_214_;
            phi_215_ = _e73;
        }
        let _e75 = phi_215_;
        phi_216_ = _e75;
    }
    let _e77 = phi_216_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_234_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_5.z;
            }
            let _e85 = phi_232_;
            phi_233_ = _e85;
        }
        let _e87 = phi_233_;
        phi_234_ = _e87;
    }
    let _e89 = phi_234_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_252_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_251_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_250_ = 1f;
            } else {
                phi_250_ = param_5.w;
            }
            let _e97 = phi_250_;
            phi_251_ = _e97;
        }
        let _e99 = phi_251_;
        phi_252_ = _e99;
    }
    let _e101 = phi_252_;
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
        phi_298_ = true;
    } else {
        let _e140 = (_e106 > _e136);
        if _e140 {
        }
        phi_298_ = _e140;
    }
    let _e142 = phi_298_;
    if _e142 {
        phi_302_ = _e106;
    } else {
        phi_302_ = _e136;
    }
    let _e144 = phi_302_;
    let _e145 = -(_e117);
    if (_e145 <= 0f) {
        let _e149 = ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u);
        if _e149 {
        }
        phi_314_ = _e149;
    } else {
        phi_314_ = true;
    }
    let _e151 = phi_314_;
    if _e151 {
        phi_321_ = (_e144 / (_e144 + (_e145 * _e145)));
    } else {
        phi_321_ = 1f;
    }
    let _e156 = phi_321_;
    if ((bitcast<u32>(_e156) & 2147483647u) > 2139095040u) {
        phi_338_ = _e156;
    } else {
        if (_e156 < 0f) {
            phi_337_ = 0f;
        } else {
            if (_e156 > 1f) {
                phi_336_ = 1f;
            } else {
                phi_336_ = _e156;
            }
            let _e163 = phi_336_;
            phi_337_ = _e163;
        }
        let _e165 = phi_337_;
        phi_338_ = _e165;
    }
    let _e167 = phi_338_;
    return _e167;
}

fn function_() {
    var local: f32;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_405_: bool;
    var phi_475_: bool;
    var phi_476_: bool;
    var phi_487_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_488_: bool;
    var phi_489_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_490_: bool;
    var phi_497_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_501_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_521_: lt_math_LightPoint;
    var phi_524_: u32;
    var phi_526_: lt_math_LevelPoint;
    var phi_612_: bool;
    var phi_621_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_640_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_678_: bool;
    var phi_687_: lt_math_LightPoint;
    var phi_688_: u32;
    var phi_689_: lt_math_LevelPoint;
    var phi_690_: bool;
    var phi_522_: lt_math_LightPoint;
    var phi_525_: u32;
    var phi_527_: lt_math_LevelPoint;
    var phi_691_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_733_: bool;
    var phi_734_: bool;
    var phi_738_: bool;
    var phi_820_: f32;
    var phi_938_: f32;
    var phi_939_: f32;
    var phi_942_: f32;
    var phi_971_: f32;
    var phi_976_: f32;
    var phi_977_: bool;
    var phi_978_: f32;
    var phi_979_: bool;
    var phi_983_: f32;
    var phi_1003_: f32;
    var phi_1008_: f32;
    var phi_1009_: bool;
    var phi_1010_: f32;
    var phi_1011_: bool;
    var phi_1015_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1064_: i32;
    var phi_1069_: i32;
    var phi_1074_: i32;
    var phi_1079_: i32;
    var phi_1088_: i32;
    var phi_1093_: i32;
    var phi_1098_: i32;
    var phi_1103_: i32;
    var phi_1154_: bool;
    var phi_1162_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1179_: f32;
    var phi_1185_: f32;
    var phi_1187_: evaluate_Verdict;
    var phi_1192_: evaluate_Verdict;
    var phi_1193_: evaluate_Verdict;

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
                phi_398_ = (_e82 == _e84);
                phi_399_ = false;
            } else {
                phi_398_ = bool();
                phi_399_ = true;
            }
            let _e87 = phi_398_;
            let _e89 = phi_399_;
            phi_400_ = _e87;
            phi_401_ = _e89;
        } else {
            phi_400_ = bool();
            phi_401_ = true;
        }
        let _e91 = phi_400_;
        let _e93 = phi_401_;
        if _e93 {
            phi_405_ = false;
        } else {
            phi_405_ = _e91;
        }
        let _e95 = phi_405_;
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
                    phi_476_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_475_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_475_ = false;
                    }
                    let _e156 = phi_475_;
                    phi_476_ = _e156;
                }
                let _e158 = phi_476_;
                if _e158 {
                    let _e160 = samples.member[(0u + _e59.first_primitive)].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_487_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_488_ = false;
                } else {
                    phi_487_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_488_ = true;
                }
                let _e179 = phi_487_;
                let _e181 = phi_488_;
                phi_489_ = _e179;
                phi_490_ = _e181;
            } else {
                phi_489_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_490_ = true;
            }
            let _e183 = phi_489_;
            let _e185 = phi_490_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_497_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_497_ = _e183;
            }
            let _e202 = phi_497_;
            phi_501_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_501_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_501_;
        if _e219.unnamed_1 {
            phi_1193_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
        } else {
            let _e227 = samples.member[(0u + _e59.first_primitive)].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_521_ = lt_math_LightPoint();
            phi_524_ = 0u;
            phi_526_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_521_;
                let _e258 = phi_524_;
                let _e260 = phi_526_;
                local_1 = _e260;
                local_2 = _e260;
                local_3 = _e260;
                if (_e258 < _e65) {
                    if _e260.point.is_inside {
                        phi_687_ = lt_math_LightPoint();
                        phi_688_ = u32();
                        phi_689_ = lt_math_LevelPoint();
                        phi_690_ = false;
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
                                phi_612_ = (_e296 <= 1f);
                            } else {
                                phi_612_ = false;
                            }
                            let _e328 = phi_612_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_621_ = (_e310 <= 1f);
                                } else {
                                    phi_621_ = false;
                                }
                                let _e332 = phi_621_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_630_ = (_e323 <= 1f);
                                    } else {
                                        phi_630_ = false;
                                    }
                                    let _e336 = phi_630_;
                                    phi_631_ = _e336;
                                    phi_632_ = false;
                                } else {
                                    phi_631_ = bool();
                                    phi_632_ = true;
                                }
                                let _e338 = phi_631_;
                                let _e340 = phi_632_;
                                phi_633_ = _e338;
                                phi_634_ = _e340;
                            } else {
                                phi_633_ = bool();
                                phi_634_ = true;
                            }
                            let _e342 = phi_633_;
                            let _e344 = phi_634_;
                            phi_635_ = _e342;
                            phi_636_ = _e344;
                        } else {
                            phi_635_ = bool();
                            phi_636_ = true;
                        }
                        let _e346 = phi_635_;
                        let _e348 = phi_636_;
                        if _e348 {
                            phi_640_ = false;
                        } else {
                            phi_640_ = _e346;
                        }
                        let _e350 = phi_640_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_667_ = (_e310 <= (1f - _e231));
                                        phi_668_ = false;
                                    } else {
                                        phi_667_ = bool();
                                        phi_668_ = true;
                                    }
                                    let _e358 = phi_667_;
                                    let _e360 = phi_668_;
                                    phi_669_ = _e358;
                                    phi_670_ = _e360;
                                } else {
                                    phi_669_ = bool();
                                    phi_670_ = true;
                                }
                                let _e362 = phi_669_;
                                let _e364 = phi_670_;
                                phi_671_ = _e362;
                                phi_672_ = _e364;
                            } else {
                                phi_671_ = bool();
                                phi_672_ = true;
                            }
                            let _e366 = phi_671_;
                            let _e368 = phi_672_;
                            phi_673_ = _e366;
                            phi_674_ = _e368;
                        } else {
                            phi_673_ = bool();
                            phi_674_ = true;
                        }
                        let _e370 = phi_673_;
                        let _e372 = phi_674_;
                        if _e372 {
                            phi_678_ = false;
                        } else {
                            phi_678_ = _e370;
                        }
                        let _e374 = phi_678_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_687_ = _e396;
                        phi_688_ = (_e258 + 1u);
                        phi_689_ = lt_math_LevelPoint(_e258, _e396);
                        phi_690_ = true;
                    }
                    let _e400 = phi_687_;
                    let _e402 = phi_688_;
                    let _e404 = phi_689_;
                    let _e406 = phi_690_;
                    phi_522_ = _e400;
                    phi_525_ = _e402;
                    phi_527_ = _e404;
                    phi_691_ = _e406;
                } else {
                    phi_522_ = lt_math_LightPoint();
                    phi_525_ = u32();
                    phi_527_ = lt_math_LevelPoint();
                    phi_691_ = false;
                }
                let _e408 = phi_522_;
                let _e410 = phi_525_;
                let _e412 = phi_527_;
                let _e414 = phi_691_;
                continue;
                continuing {
                    phi_521_ = _e408;
                    phi_524_ = _e410;
                    phi_526_ = _e412;
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
                            phi_731_ = (_e428.row_w.z == _e440);
                            phi_732_ = false;
                        } else {
                            phi_731_ = bool();
                            phi_732_ = true;
                        }
                        let _e443 = phi_731_;
                        let _e445 = phi_732_;
                        phi_733_ = _e443;
                        phi_734_ = _e445;
                    } else {
                        phi_733_ = bool();
                        phi_734_ = true;
                    }
                    let _e447 = phi_733_;
                    let _e449 = phi_734_;
                    if _e449 {
                        phi_738_ = false;
                    } else {
                        phi_738_ = _e447;
                    }
                    let _e451 = phi_738_;
                    if _e451 {
                        let _e453 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_820_ = _e525;
                        } else {
                            phi_820_ = 0.002f;
                        }
                        let _e528 = phi_820_;
                        phi_939_ = _e528;
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
                            phi_938_ = _e642;
                        } else {
                            phi_938_ = _e644;
                        }
                        let _e647 = phi_938_;
                        phi_939_ = _e647;
                    }
                    let _e649 = phi_939_;
                    phi_942_ = (_e417.point.depth - (0f * _e649));
                } else {
                    phi_942_ = _e417.point.depth;
                }
                let _e653 = phi_942_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e417.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e417.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_971_ = 1f;
                    } else {
                        phi_971_ = 0f;
                    }
                    let _e679 = phi_971_;
                    if (_e663 < 8388608f) {
                        phi_976_ = (_e676 - _e679);
                        phi_977_ = false;
                    } else {
                        phi_976_ = f32();
                        phi_977_ = true;
                    }
                    let _e682 = phi_976_;
                    let _e684 = phi_977_;
                    phi_978_ = _e682;
                    phi_979_ = _e684;
                } else {
                    phi_978_ = f32();
                    phi_979_ = true;
                }
                let _e686 = phi_978_;
                let _e688 = phi_979_;
                if _e688 {
                    phi_983_ = _e663;
                } else {
                    phi_983_ = _e686;
                }
                let _e690 = phi_983_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1003_ = 1f;
                    } else {
                        phi_1003_ = 0f;
                    }
                    let _e705 = phi_1003_;
                    if (_e664 < 8388608f) {
                        phi_1008_ = (_e702 - _e705);
                        phi_1009_ = false;
                    } else {
                        phi_1008_ = f32();
                        phi_1009_ = true;
                    }
                    let _e708 = phi_1008_;
                    let _e710 = phi_1009_;
                    phi_1010_ = _e708;
                    phi_1011_ = _e710;
                } else {
                    phi_1010_ = f32();
                    phi_1011_ = true;
                }
                let _e712 = phi_1010_;
                let _e714 = phi_1011_;
                if _e714 {
                    phi_1015_ = _e664;
                } else {
                    phi_1015_ = _e712;
                }
                let _e716 = phi_1015_;
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
                    phi_1064_ = _e727;
                } else {
                    phi_1064_ = 0i;
                }
                let _e760 = phi_1064_;
                if (_e736 > 0i) {
                    phi_1069_ = _e736;
                } else {
                    phi_1069_ = 0i;
                }
                let _e763 = phi_1069_;
                if (_e760 < _e757) {
                    phi_1074_ = _e760;
                } else {
                    phi_1074_ = _e757;
                }
                let _e766 = phi_1074_;
                if (_e763 < _e757) {
                    phi_1079_ = _e763;
                } else {
                    phi_1079_ = _e757;
                }
                let _e769 = phi_1079_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1088_ = _e772;
                } else {
                    phi_1088_ = 0i;
                }
                let _e776 = phi_1088_;
                if (_e773 > 0i) {
                    phi_1093_ = _e773;
                } else {
                    phi_1093_ = 0i;
                }
                let _e779 = phi_1093_;
                if (_e776 < _e757) {
                    phi_1098_ = _e776;
                } else {
                    phi_1098_ = _e757;
                }
                let _e782 = phi_1098_;
                if (_e779 < _e757) {
                    phi_1103_ = _e779;
                } else {
                    phi_1103_ = _e757;
                }
                let _e785 = phi_1103_;
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
                let _e817 = p.member.epsilon;
                if (_e815 <= _e817) {
                    phi_1154_ = true;
                } else {
                    phi_1154_ = (_e815 >= (1f - _e817));
                }
                let _e822 = phi_1154_;
                if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                    phi_1162_ = true;
                } else {
                    phi_1162_ = !(_e822);
                }
                let _e828 = phi_1162_;
                if _e828 {
                    if (_e815 > 0f) {
                        if (_e815 < 1f) {
                            phi_1174_ = false;
                        } else {
                            phi_1174_ = true;
                        }
                        let _e832 = phi_1174_;
                        phi_1175_ = _e832;
                    } else {
                        phi_1175_ = true;
                    }
                    let _e834 = phi_1175_;
                    if _e834 {
                        phi_1179_ = 0.5f;
                    } else {
                        phi_1179_ = _e815;
                    }
                    let _e836 = phi_1179_;
                    phi_1187_ = evaluate_Verdict(_e836, true);
                } else {
                    if (_e815 > 0.5f) {
                        phi_1185_ = 1f;
                    } else {
                        phi_1185_ = 0f;
                    }
                    let _e840 = phi_1185_;
                    phi_1187_ = evaluate_Verdict(_e840, false);
                }
                let _e843 = phi_1187_;
                phi_1192_ = evaluate_Verdict(_e843.visibility, _e843.is_doubted);
            } else {
                phi_1192_ = evaluate_Verdict(0.5f, true);
            }
            let _e849 = phi_1192_;
            phi_1193_ = _e849;
        }
        let _e851 = phi_1193_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e851.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
