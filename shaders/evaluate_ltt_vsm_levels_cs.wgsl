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

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_43 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
@group(0) @binding(5) 
var<storage> levels: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_163_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_155_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_156_ = false;
        } else {
            phi_155_ = lt_bvh_traverse_Tree();
            phi_156_ = true;
        }
        let _e55 = phi_155_;
        let _e57 = phi_156_;
        phi_157_ = _e55;
        phi_158_ = _e57;
    } else {
        phi_157_ = lt_bvh_traverse_Tree();
        phi_158_ = true;
    }
    let _e59 = phi_157_;
    let _e61 = phi_158_;
    if _e61 {
        phi_163_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_163_ = _e59;
    }
    let _e66 = phi_163_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_189_: f32;
    var phi_190_: f32;
    var phi_191_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_245_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_263_: f32;
    var phi_309_: bool;
    var phi_313_: f32;
    var phi_325_: bool;
    var phi_332_: f32;
    var phi_347_: f32;
    var phi_348_: f32;
    var phi_349_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_191_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_190_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_189_ = 1f;
            } else {
                phi_189_ = param_7;
            }
            let _e52 = phi_189_;
            phi_190_ = _e52;
        }
        let _e54 = phi_190_;
        phi_191_ = _e54;
    }
    let _e56 = phi_191_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_209_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_208_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_207_ = 1f;
            } else {
                phi_207_ = param_5.x;
            }
            let _e64 = phi_207_;
            phi_208_ = _e64;
        }
        let _e66 = phi_208_;
        phi_209_ = _e66;
    }
    let _e68 = phi_209_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_227_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_226_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_225_ = 1f;
            } else {
                phi_225_ = param_5.y;
            }
            let _e76 = phi_225_;
            phi_226_ = _e76;
        }
        let _e78 = phi_226_;
        phi_227_ = _e78;
    }
    let _e80 = phi_227_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_245_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_244_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_243_ = 1f;
            } else {
                phi_243_ = param_5.z;
            }
            let _e88 = phi_243_;
            phi_244_ = _e88;
        }
        let _e90 = phi_244_;
        phi_245_ = _e90;
    }
    let _e92 = phi_245_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_263_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_262_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_261_ = 1f;
            } else {
                phi_261_ = param_5.w;
            }
            let _e100 = phi_261_;
            phi_262_ = _e100;
        }
        let _e102 = phi_262_;
        phi_263_ = _e102;
    }
    let _e104 = phi_263_;
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
        phi_309_ = true;
    } else {
        let _e143 = (_e109 > _e139);
        if _e143 {
        }
        phi_309_ = _e143;
    }
    let _e145 = phi_309_;
    if _e145 {
        phi_313_ = _e109;
    } else {
        phi_313_ = _e139;
    }
    let _e147 = phi_313_;
    let _e148 = -(_e120);
    if (_e148 <= 0f) {
        let _e152 = ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u);
        if _e152 {
        }
        phi_325_ = _e152;
    } else {
        phi_325_ = true;
    }
    let _e154 = phi_325_;
    if _e154 {
        phi_332_ = (_e147 / (_e147 + (_e148 * _e148)));
    } else {
        phi_332_ = 1f;
    }
    let _e159 = phi_332_;
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_349_ = _e159;
    } else {
        if (_e159 < 0f) {
            phi_348_ = 0f;
        } else {
            if (_e159 > 1f) {
                phi_347_ = 1f;
            } else {
                phi_347_ = _e159;
            }
            let _e166 = phi_347_;
            phi_348_ = _e166;
        }
        let _e168 = phi_348_;
        phi_349_ = _e168;
    }
    let _e170 = phi_349_;
    return _e170;
}

fn function_() {
    var local_1: f32;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_412_: bool;
    var phi_456_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_460_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_480_: lt_math_LightPoint;
    var phi_483_: u32;
    var phi_485_: lt_math_LevelPoint;
    var phi_571_: bool;
    var phi_580_: bool;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_591_: bool;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_595_: bool;
    var phi_599_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_633_: bool;
    var phi_637_: bool;
    var phi_646_: lt_math_LightPoint;
    var phi_647_: u32;
    var phi_648_: lt_math_LevelPoint;
    var phi_649_: bool;
    var phi_481_: lt_math_LightPoint;
    var phi_484_: u32;
    var phi_486_: lt_math_LevelPoint;
    var phi_650_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_693_: bool;
    var phi_697_: bool;
    var phi_779_: f32;
    var phi_895_: f32;
    var phi_896_: f32;
    var phi_899_: f32;
    var phi_928_: f32;
    var phi_933_: f32;
    var phi_934_: bool;
    var phi_935_: f32;
    var phi_936_: bool;
    var phi_940_: f32;
    var phi_960_: f32;
    var phi_965_: f32;
    var phi_966_: bool;
    var phi_967_: f32;
    var phi_968_: bool;
    var phi_972_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1021_: i32;
    var phi_1026_: i32;
    var phi_1031_: i32;
    var phi_1036_: i32;
    var phi_1045_: i32;
    var phi_1050_: i32;
    var phi_1055_: i32;
    var phi_1060_: i32;
    var phi_1111_: bool;
    var phi_1119_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1136_: f32;
    var phi_1142_: f32;
    var phi_1144_: evaluate_Verdict;
    var phi_1149_: evaluate_Verdict;
    var phi_1150_: evaluate_Verdict;
    var phi_1154_: bool;
    var phi_1155_: u32;
    var phi_1166_: u32;

    let _e43 = id_1;
    let _e44 = local_5;
    let _e49 = arrayLength((&map.member));
    let _e54 = arrayLength((&levels.member));
    let _e57 = p.member.size[0u];
    let _e59 = p.member.size[1u];
    let _e60 = lt_shaders_entry_pixel_index(_e43, _e57, _e59);
    if (bitcast<i32>(_e60.root) != 0i) {
        let _e67 = p.member.level_count;
        let _e69 = p.member.light;
        let _e72 = samples.member[_e60.first_primitive].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[_e60.first_primitive].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[_e60.first_primitive].normal[2u];
                let _e84 = global[2u];
                phi_405_ = (_e82 == _e84);
                phi_406_ = false;
            } else {
                phi_405_ = bool();
                phi_406_ = true;
            }
            let _e87 = phi_405_;
            let _e89 = phi_406_;
            phi_407_ = _e87;
            phi_408_ = _e89;
        } else {
            phi_407_ = bool();
            phi_408_ = true;
        }
        let _e91 = phi_407_;
        let _e93 = phi_408_;
        if _e93 {
            phi_412_ = false;
        } else {
            phi_412_ = _e91;
        }
        let _e95 = phi_412_;
        if !(_e95) {
            let _e98 = samples.member[_e60.first_primitive].normal;
            let _e100 = samples.member[_e60.first_primitive].position;
            if ((((_e98.x * (_e69.x - (_e100.x * _e69.w))) + (_e98.y * (_e69.y - (_e100.y * _e69.w)))) + (_e98.z * (_e69.z - (_e100.z * _e69.w)))) > 0f) {
                let _e124 = samples.member[_e60.first_primitive].flags;
                let _e132 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e138 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e132.unnamed.visibility, false), _e132.unnamed_1);
                phi_456_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e138.unnamed, ((_e124 & 1u) == 0u));
            } else {
                let _e147 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e153 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e147.unnamed.visibility, false), _e147.unnamed_1);
                phi_456_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e153.unnamed, true);
            }
            let _e158 = phi_456_;
            phi_460_ = _e158;
        } else {
            let _e164 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e164.unnamed.visibility, false), _e164.unnamed_1);
            phi_460_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e170.unnamed, true);
        }
        let _e175 = phi_460_;
        if _e175.unnamed_1 {
            phi_1150_ = evaluate_Verdict(_e175.unnamed.visibility, _e175.unnamed.is_doubted);
        } else {
            let _e183 = samples.member[_e60.first_primitive].position;
            let _e185 = p.member.map_size;
            let _e187 = (0.5f / f32(_e185));
            let _e194 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e201 = lt_math_LightPoint(vec2<f32>(_e194.uv.x, 0f), _e194.depth, _e194.is_inside);
            let _e205 = lt_math_LightPoint(_e201.uv, 0f, _e201.is_inside);
            phi_480_ = lt_math_LightPoint();
            phi_483_ = 0u;
            phi_485_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e205.uv, _e205.depth, false));
            loop {
                let _e212 = phi_480_;
                let _e214 = phi_483_;
                let _e216 = phi_485_;
                local_2 = _e216;
                local_3 = _e216;
                local_4 = _e216;
                if (_e214 < _e67) {
                    if _e216.point.is_inside {
                        phi_646_ = lt_math_LightPoint();
                        phi_647_ = u32();
                        phi_648_ = lt_math_LevelPoint();
                        phi_649_ = false;
                    } else {
                        if (_e214 < _e54) {
                        } else {
                            return;
                        }
                        let _e227 = levels.member[(0u + _e214)].row_w;
                        let _e238 = ((((_e227.x * _e183.x) + (_e227.y * _e183.y)) + (_e227.z * _e183.z)) + (_e227.w * 1f));
                        let _e240 = levels.member[(0u + _e214)].row_x;
                        let _e252 = (((((_e240.x * _e183.x) + (_e240.y * _e183.y)) + (_e240.z * _e183.z)) + (_e240.w * 1f)) / _e238);
                        let _e254 = levels.member[(0u + _e214)].row_y;
                        let _e266 = (((((_e254.x * _e183.x) + (_e254.y * _e183.y)) + (_e254.z * _e183.z)) + (_e254.w * 1f)) / _e238);
                        let _e268 = levels.member[(0u + _e214)].row_z;
                        let _e279 = ((((_e268.x * _e183.x) + (_e268.y * _e183.y)) + (_e268.z * _e183.z)) + (_e268.w * 1f));
                        if (_e238 > 0f) {
                            if (_e252 >= 0f) {
                                phi_571_ = (_e252 <= 1f);
                            } else {
                                phi_571_ = false;
                            }
                            let _e284 = phi_571_;
                            if _e284 {
                                if (_e266 >= 0f) {
                                    phi_580_ = (_e266 <= 1f);
                                } else {
                                    phi_580_ = false;
                                }
                                let _e288 = phi_580_;
                                if _e288 {
                                    if (_e279 >= 0f) {
                                        phi_589_ = (_e279 <= 1f);
                                    } else {
                                        phi_589_ = false;
                                    }
                                    let _e292 = phi_589_;
                                    phi_590_ = _e292;
                                    phi_591_ = false;
                                } else {
                                    phi_590_ = bool();
                                    phi_591_ = true;
                                }
                                let _e294 = phi_590_;
                                let _e296 = phi_591_;
                                phi_592_ = _e294;
                                phi_593_ = _e296;
                            } else {
                                phi_592_ = bool();
                                phi_593_ = true;
                            }
                            let _e298 = phi_592_;
                            let _e300 = phi_593_;
                            phi_594_ = _e298;
                            phi_595_ = _e300;
                        } else {
                            phi_594_ = bool();
                            phi_595_ = true;
                        }
                        let _e302 = phi_594_;
                        let _e304 = phi_595_;
                        if _e304 {
                            phi_599_ = false;
                        } else {
                            phi_599_ = _e302;
                        }
                        let _e306 = phi_599_;
                        if _e306 {
                            if (_e252 >= _e187) {
                                if (_e252 <= (1f - _e187)) {
                                    if (_e266 >= _e187) {
                                        phi_626_ = (_e266 <= (1f - _e187));
                                        phi_627_ = false;
                                    } else {
                                        phi_626_ = bool();
                                        phi_627_ = true;
                                    }
                                    let _e314 = phi_626_;
                                    let _e316 = phi_627_;
                                    phi_628_ = _e314;
                                    phi_629_ = _e316;
                                } else {
                                    phi_628_ = bool();
                                    phi_629_ = true;
                                }
                                let _e318 = phi_628_;
                                let _e320 = phi_629_;
                                phi_630_ = _e318;
                                phi_631_ = _e320;
                            } else {
                                phi_630_ = bool();
                                phi_631_ = true;
                            }
                            let _e322 = phi_630_;
                            let _e324 = phi_631_;
                            phi_632_ = _e322;
                            phi_633_ = _e324;
                        } else {
                            phi_632_ = bool();
                            phi_633_ = true;
                        }
                        let _e326 = phi_632_;
                        let _e328 = phi_633_;
                        if _e328 {
                            phi_637_ = false;
                        } else {
                            phi_637_ = _e326;
                        }
                        let _e330 = phi_637_;
                        let _e337 = lt_math_LightPoint(vec2<f32>(_e252, _e212.uv.y), _e212.depth, _e212.is_inside);
                        let _e344 = lt_math_LightPoint(vec2<f32>(_e337.uv.x, _e266), _e337.depth, _e337.is_inside);
                        let _e348 = lt_math_LightPoint(_e344.uv, _e279, _e344.is_inside);
                        let _e352 = lt_math_LightPoint(_e348.uv, _e348.depth, _e330);
                        phi_646_ = _e352;
                        phi_647_ = (_e214 + 1u);
                        phi_648_ = lt_math_LevelPoint(_e214, _e352);
                        phi_649_ = true;
                    }
                    let _e356 = phi_646_;
                    let _e358 = phi_647_;
                    let _e360 = phi_648_;
                    let _e362 = phi_649_;
                    phi_481_ = _e356;
                    phi_484_ = _e358;
                    phi_486_ = _e360;
                    phi_650_ = _e362;
                } else {
                    phi_481_ = lt_math_LightPoint();
                    phi_484_ = u32();
                    phi_486_ = lt_math_LevelPoint();
                    phi_650_ = false;
                }
                let _e364 = phi_481_;
                let _e366 = phi_484_;
                let _e368 = phi_486_;
                let _e370 = phi_650_;
                continue;
                continuing {
                    phi_480_ = _e364;
                    phi_483_ = _e366;
                    phi_485_ = _e368;
                    break if !(_e370);
                }
            }
            let _e373 = local_2;
            if _e373.point.is_inside {
                if (0f > 0f) {
                    let _e379 = local_3;
                    if (_e379.level < _e54) {
                    } else {
                        return;
                    }
                    let _e384 = levels.member[(0u + _e379.level)];
                    let _e390 = global[0u];
                    if (_e384.row_w.x == _e390) {
                        let _e393 = global[1u];
                        if (_e384.row_w.y == _e393) {
                            let _e396 = global[2u];
                            phi_690_ = (_e384.row_w.z == _e396);
                            phi_691_ = false;
                        } else {
                            phi_690_ = bool();
                            phi_691_ = true;
                        }
                        let _e399 = phi_690_;
                        let _e401 = phi_691_;
                        phi_692_ = _e399;
                        phi_693_ = _e401;
                    } else {
                        phi_692_ = bool();
                        phi_693_ = true;
                    }
                    let _e403 = phi_692_;
                    let _e405 = phi_693_;
                    if _e405 {
                        phi_697_ = false;
                    } else {
                        phi_697_ = _e403;
                    }
                    let _e407 = phi_697_;
                    if _e407 {
                        let _e409 = samples.member[_e60.first_primitive].normal;
                        let _e411 = p.member.map_size;
                        let _e481 = ((abs(((((_e384.row_x.x * _e409.x) + (_e384.row_x.y * _e409.y)) + (_e384.row_x.z * _e409.z)) / (((_e384.row_x.x * _e384.row_x.x) + (_e384.row_x.y * _e384.row_x.y)) + (_e384.row_x.z * _e384.row_x.z)))) + abs(((((_e384.row_y.x * _e409.x) + (_e384.row_y.y * _e409.y)) + (_e384.row_y.z * _e409.z)) / (((_e384.row_y.x * _e384.row_y.x) + (_e384.row_y.y * _e384.row_y.y)) + (_e384.row_y.z * _e384.row_y.z))))) / (abs(((((_e384.row_z.x * _e409.x) + (_e384.row_z.y * _e409.y)) + (_e384.row_z.z * _e409.z)) / (((_e384.row_z.x * _e384.row_z.x) + (_e384.row_z.y * _e384.row_z.y)) + (_e384.row_z.z * _e384.row_z.z)))) * f32(_e411)));
                        if (_e481 < 0.002f) {
                            phi_779_ = _e481;
                        } else {
                            phi_779_ = 0.002f;
                        }
                        let _e484 = phi_779_;
                        phi_896_ = _e484;
                    } else {
                        let _e486 = p.member.map_size;
                        let _e492 = samples.member[_e60.first_primitive].position;
                        let _e503 = ((((_e384.row_w.x * _e492.x) + (_e384.row_w.y * _e492.y)) + (_e384.row_w.z * _e492.z)) + _e384.row_w.w);
                        let _e516 = ((_e384.row_x.x - (_e384.row_w.x * _e373.point.uv.x)) / _e503);
                        let _e517 = ((_e384.row_x.y - (_e384.row_w.y * _e373.point.uv.x)) / _e503);
                        let _e518 = ((_e384.row_x.z - (_e384.row_w.z * _e373.point.uv.x)) / _e503);
                        let _e531 = ((_e384.row_y.x - (_e384.row_w.x * _e373.point.uv.y)) / _e503);
                        let _e532 = ((_e384.row_y.y - (_e384.row_w.y * _e373.point.uv.y)) / _e503);
                        let _e533 = ((_e384.row_y.z - (_e384.row_w.z * _e373.point.uv.y)) / _e503);
                        let _e539 = samples.member[_e60.first_primitive].normal;
                        let _e544 = ((_e532 * _e539.z) - (_e539.y * _e533));
                        let _e549 = ((_e533 * _e539.x) - (_e539.z * _e531));
                        let _e554 = ((_e531 * _e539.y) - (_e539.x * _e532));
                        let _e556 = samples.member[_e60.first_primitive].normal;
                        let _e561 = ((_e517 * _e556.z) - (_e556.y * _e518));
                        let _e566 = ((_e518 * _e556.x) - (_e556.z * _e516));
                        let _e571 = ((_e516 * _e556.y) - (_e556.x * _e517));
                        let _e598 = ((abs(((((_e384.row_z.x * _e544) + (_e384.row_z.y * _e549)) + (_e384.row_z.z * _e554)) / (((_e516 * _e544) + (_e517 * _e549)) + (_e518 * _e554)))) + abs(((((_e384.row_z.x * _e561) + (_e384.row_z.y * _e566)) + (_e384.row_z.z * _e571)) / (((_e531 * _e561) + (_e532 * _e566)) + (_e533 * _e571))))) / f32(_e486));
                        if (_e598 < 0.002f) {
                            phi_895_ = _e598;
                        } else {
                            phi_895_ = 0.002f;
                        }
                        let _e601 = phi_895_;
                        phi_896_ = _e601;
                    }
                    let _e603 = phi_896_;
                    phi_899_ = (_e373.point.depth - (0f * _e603));
                } else {
                    phi_899_ = _e373.point.depth;
                }
                let _e607 = phi_899_;
                let _e613 = p.member.map_size;
                let _e614 = f32(_e613);
                let _e617 = ((_e373.point.uv.x * _e614) - 0.5f);
                let _e618 = ((_e373.point.uv.y * _e614) - 0.5f);
                if (_e617 > -8388608f) {
                    let _e630 = f32(select(0i, select(select(i32(_e617), i32(-2147483648), (_e617 < bitcast<f32>(3472883712u))), 2147483647i, (_e617 > bitcast<f32>(1325400063u))), (_e617 == _e617)));
                    if (_e630 > _e617) {
                        phi_928_ = 1f;
                    } else {
                        phi_928_ = 0f;
                    }
                    let _e633 = phi_928_;
                    if (_e617 < 8388608f) {
                        phi_933_ = (_e630 - _e633);
                        phi_934_ = false;
                    } else {
                        phi_933_ = f32();
                        phi_934_ = true;
                    }
                    let _e636 = phi_933_;
                    let _e638 = phi_934_;
                    phi_935_ = _e636;
                    phi_936_ = _e638;
                } else {
                    phi_935_ = f32();
                    phi_936_ = true;
                }
                let _e640 = phi_935_;
                let _e642 = phi_936_;
                if _e642 {
                    phi_940_ = _e617;
                } else {
                    phi_940_ = _e640;
                }
                let _e644 = phi_940_;
                if (_e618 > -8388608f) {
                    let _e656 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e656 > _e618) {
                        phi_960_ = 1f;
                    } else {
                        phi_960_ = 0f;
                    }
                    let _e659 = phi_960_;
                    if (_e618 < 8388608f) {
                        phi_965_ = (_e656 - _e659);
                        phi_966_ = false;
                    } else {
                        phi_965_ = f32();
                        phi_966_ = true;
                    }
                    let _e662 = phi_965_;
                    let _e664 = phi_966_;
                    phi_967_ = _e662;
                    phi_968_ = _e664;
                } else {
                    phi_967_ = f32();
                    phi_968_ = true;
                }
                let _e666 = phi_967_;
                let _e668 = phi_968_;
                if _e668 {
                    phi_972_ = _e618;
                } else {
                    phi_972_ = _e666;
                }
                let _e670 = phi_972_;
                let _e671 = (_e617 - _e644);
                let _e672 = (_e618 - _e670);
                let _e681 = select(0i, select(select(i32(_e644), i32(-2147483648), (_e644 < bitcast<f32>(3472883712u))), 2147483647i, (_e644 > bitcast<f32>(1325400063u))), (_e644 == _e644));
                let _e690 = select(0i, select(select(i32(_e670), i32(-2147483648), (_e670 < bitcast<f32>(3472883712u))), 2147483647i, (_e670 > bitcast<f32>(1325400063u))), (_e670 == _e670));
                let _e701 = p.member.test;
                let _e702 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e701);
                let _e704 = p.member.map_size;
                let _e706 = local_4;
                local_1 = _e702;
                let _e709 = ((_e706.level * _e704) * _e704);
                let _e711 = (bitcast<i32>(_e704) - 1i);
                if (_e681 > 0i) {
                    phi_1021_ = _e681;
                } else {
                    phi_1021_ = 0i;
                }
                let _e714 = phi_1021_;
                if (_e690 > 0i) {
                    phi_1026_ = _e690;
                } else {
                    phi_1026_ = 0i;
                }
                let _e717 = phi_1026_;
                if (_e714 < _e711) {
                    phi_1031_ = _e714;
                } else {
                    phi_1031_ = _e711;
                }
                let _e720 = phi_1031_;
                if (_e717 < _e711) {
                    phi_1036_ = _e717;
                } else {
                    phi_1036_ = _e711;
                }
                let _e723 = phi_1036_;
                let _e724 = bitcast<u32>(_e720);
                let _e726 = (_e681 + 1i);
                let _e727 = (_e690 + 1i);
                if (_e726 > 0i) {
                    phi_1045_ = _e726;
                } else {
                    phi_1045_ = 0i;
                }
                let _e730 = phi_1045_;
                if (_e727 > 0i) {
                    phi_1050_ = _e727;
                } else {
                    phi_1050_ = 0i;
                }
                let _e733 = phi_1050_;
                if (_e730 < _e711) {
                    phi_1055_ = _e730;
                } else {
                    phi_1055_ = _e711;
                }
                let _e736 = phi_1055_;
                if (_e733 < _e711) {
                    phi_1060_ = _e733;
                } else {
                    phi_1060_ = _e711;
                }
                let _e739 = phi_1060_;
                let _e740 = bitcast<u32>(_e736);
                let _e742 = (bitcast<u32>(_e723) * _e704);
                let _e743 = (bitcast<u32>(_e739) * _e704);
                let _e748 = ((_e742 + _e724) + _e709);
                let _e749 = ((_e742 + _e740) + _e709);
                let _e750 = ((_e743 + _e724) + _e709);
                let _e751 = ((_e743 + _e740) + _e709);
                if (_e748 < _e49) {
                } else {
                    return;
                }
                let _e755 = map.member[(0u + _e748)];
                if (_e749 < _e49) {
                } else {
                    return;
                }
                let _e759 = map.member[(0u + _e749)];
                if (_e750 < _e49) {
                } else {
                    return;
                }
                let _e763 = map.member[(0u + _e750)];
                if (_e751 < _e49) {
                } else {
                    return;
                }
                let _e767 = map.member[(0u + _e751)];
                let _e769 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e755, _e759, _e763, _e767), vec4<f32>(((1f - _e671) * (1f - _e672)), (_e671 * (1f - _e672)), ((1f - _e671) * _e672), (_e671 * _e672)), _e607);
                let _e771 = p.member.epsilon;
                if (_e769 <= _e771) {
                    phi_1111_ = true;
                } else {
                    phi_1111_ = (_e769 >= (1f - _e771));
                }
                let _e776 = phi_1111_;
                if ((bitcast<u32>(_e769) & 2147483647u) > 2139095040u) {
                    phi_1119_ = true;
                } else {
                    phi_1119_ = !(_e776);
                }
                let _e782 = phi_1119_;
                if _e782 {
                    if (_e769 > 0f) {
                        if (_e769 < 1f) {
                            phi_1131_ = false;
                        } else {
                            phi_1131_ = true;
                        }
                        let _e786 = phi_1131_;
                        phi_1132_ = _e786;
                    } else {
                        phi_1132_ = true;
                    }
                    let _e788 = phi_1132_;
                    if _e788 {
                        phi_1136_ = 0.5f;
                    } else {
                        phi_1136_ = _e769;
                    }
                    let _e790 = phi_1136_;
                    phi_1144_ = evaluate_Verdict(_e790, true);
                } else {
                    if (_e769 > 0.5f) {
                        phi_1142_ = 1f;
                    } else {
                        phi_1142_ = 0f;
                    }
                    let _e794 = phi_1142_;
                    phi_1144_ = evaluate_Verdict(_e794, false);
                }
                let _e797 = phi_1144_;
                phi_1149_ = evaluate_Verdict(_e797.visibility, _e797.is_doubted);
            } else {
                phi_1149_ = evaluate_Verdict(0.5f, true);
            }
            let _e803 = phi_1149_;
            phi_1150_ = _e803;
        }
        let _e805 = phi_1150_;
        visibility.member[_e60.first_primitive] = _e805.visibility;
        phi_1154_ = _e805.is_doubted;
        phi_1155_ = _e60.first_primitive;
    } else {
        phi_1154_ = false;
        phi_1155_ = 0u;
    }
    let _e810 = phi_1154_;
    let _e812 = phi_1155_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e810 {
        let _e816 = atomicAdd((&shared_[0u]), 1u);
        phi_1166_ = _e816;
    } else {
        phi_1166_ = 0u;
    }
    let _e818 = phi_1166_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e822 = atomicLoad((&shared_[0u]));
        let _e823 = atomicAdd((&list.member[3u]), _e822);
        atomicStore((&shared_[1u]), _e823);
    }
    workgroupBarrier();
    if _e810 {
        let _e826 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e826) + _e818)]), _e812);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
