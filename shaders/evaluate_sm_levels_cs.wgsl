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

fn _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: f32;

    let _e43 = (*param_4);
    let _e44 = (param_5.x + _e43);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_249_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_248_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_247_ = 1f;
            } else {
                phi_247_ = param_6;
            }
            let _e51 = phi_247_;
            phi_248_ = _e51;
        }
        let _e53 = phi_248_;
        phi_249_ = _e53;
    }
    let _e55 = phi_249_;
    if ((bitcast<u32>(_e44) & 2147483647u) > 2139095040u) {
        phi_268_ = _e44;
    } else {
        if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
            phi_267_ = _e55;
        } else {
            if (_e44 < _e55) {
                phi_266_ = 0f;
            } else {
                phi_266_ = 1f;
            }
            let _e64 = phi_266_;
            phi_267_ = _e64;
        }
        let _e66 = phi_267_;
        phi_268_ = _e66;
    }
    let _e68 = phi_268_;
    return _e68;
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(param_7: f32) -> vec4<f32> {
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_224_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_7;
            }
            let _e46 = phi_222_;
            phi_223_ = _e46;
        }
        let _e48 = phi_223_;
        phi_224_ = _e48;
    }
    let _e50 = phi_224_;
    return vec4<f32>(_e50, 0f, 0f, 0f);
}

fn _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_8: ptr<function, f32>, param_9: vec4<f32>, param_10: vec4<f32>, param_11: f32) -> f32 {
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_202_: f32;
    var phi_205_: f32;

    let _e49 = (((param_10.x + param_10.y) + param_10.z) + param_10.w);
    if ((bitcast<u32>(_e49) & 2147483647u) > 2139095040u) {
        phi_205_ = _e49;
    } else {
        if (param_10.y > param_10.x) {
            phi_185_ = param_9.y;
            phi_186_ = param_10.y;
        } else {
            phi_185_ = param_9.x;
            phi_186_ = param_10.x;
        }
        let _e60 = phi_185_;
        let _e62 = phi_186_;
        if (param_10.z > _e62) {
            phi_194_ = param_9.z;
            phi_195_ = param_10.z;
        } else {
            phi_194_ = _e60;
            phi_195_ = _e62;
        }
        let _e68 = phi_194_;
        let _e70 = phi_195_;
        if (param_10.w > _e70) {
            phi_202_ = param_9.w;
        } else {
            phi_202_ = _e68;
        }
        let _e75 = phi_202_;
        let _e76 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_depth_vector(_e75);
        let _e77 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_8, _e76, param_11);
        phi_205_ = _e77;
    }
    let _e79 = phi_205_;
    return _e79;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_1096_: f32;

    if (param_12 < param_13) {
        phi_1096_ = param_12;
    } else {
        phi_1096_ = param_13;
    }
    let _e43 = phi_1096_;
    return _e43;
}

fn function_() {
    var local: f32;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_336_: bool;
    var phi_380_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_384_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_404_: lt_math_LightPoint;
    var phi_407_: u32;
    var phi_409_: lt_math_LevelPoint;
    var phi_495_: bool;
    var phi_504_: bool;
    var phi_513_: bool;
    var phi_514_: bool;
    var phi_515_: bool;
    var phi_516_: bool;
    var phi_517_: bool;
    var phi_518_: bool;
    var phi_519_: bool;
    var phi_523_: bool;
    var phi_550_: bool;
    var phi_551_: bool;
    var phi_552_: bool;
    var phi_553_: bool;
    var phi_554_: bool;
    var phi_555_: bool;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_561_: bool;
    var phi_570_: lt_math_LightPoint;
    var phi_571_: u32;
    var phi_572_: lt_math_LevelPoint;
    var phi_573_: bool;
    var phi_405_: lt_math_LightPoint;
    var phi_408_: u32;
    var phi_410_: lt_math_LevelPoint;
    var phi_574_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_617_: bool;
    var phi_621_: bool;
    var phi_703_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_823_: f32;
    var phi_852_: f32;
    var phi_857_: f32;
    var phi_858_: bool;
    var phi_859_: f32;
    var phi_860_: bool;
    var phi_864_: f32;
    var phi_884_: f32;
    var phi_889_: f32;
    var phi_890_: bool;
    var phi_891_: f32;
    var phi_892_: bool;
    var phi_896_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_945_: i32;
    var phi_950_: i32;
    var phi_955_: i32;
    var phi_960_: i32;
    var phi_969_: i32;
    var phi_974_: i32;
    var phi_979_: i32;
    var phi_984_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1056_: f32;
    var phi_1058_: evaluate_Verdict;
    var phi_1059_: bool;
    var phi_1060_: evaluate_Verdict;
    var phi_1061_: bool;
    var phi_1066_: evaluate_Verdict;
    var phi_1067_: bool;
    var phi_1069_: evaluate_Verdict;
    var phi_1070_: evaluate_Verdict;
    var phi_1071_: bool;
    var phi_1075_: evaluate_Verdict;
    var phi_1076_: evaluate_Verdict;
    var phi_1077_: bool;
    var phi_1081_: evaluate_Verdict;

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
                phi_329_ = (_e83 == _e85);
                phi_330_ = false;
            } else {
                phi_329_ = bool();
                phi_330_ = true;
            }
            let _e88 = phi_329_;
            let _e90 = phi_330_;
            phi_331_ = _e88;
            phi_332_ = _e90;
        } else {
            phi_331_ = bool();
            phi_332_ = true;
        }
        let _e92 = phi_331_;
        let _e94 = phi_332_;
        if _e94 {
            phi_336_ = false;
        } else {
            phi_336_ = _e92;
        }
        let _e96 = phi_336_;
        if !(_e96) {
            let _e99 = samples.member[(0u + _e59.first_primitive)].normal;
            let _e101 = samples.member[(0u + _e59.first_primitive)].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[(0u + _e59.first_primitive)].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_380_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_380_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_380_;
            phi_384_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_384_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_384_;
        if _e176.unnamed_1 {
            phi_1075_ = evaluate_Verdict(_e176.unnamed.visibility, _e176.unnamed.is_doubted);
            phi_1076_ = evaluate_Verdict();
            phi_1077_ = true;
        } else {
            let _e184 = samples.member[(0u + _e59.first_primitive)].position;
            let _e186 = p.member.map_size;
            let _e188 = (0.5f / f32(_e186));
            let _e195 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e202 = lt_math_LightPoint(vec2<f32>(_e195.uv.x, 0f), _e195.depth, _e195.is_inside);
            let _e206 = lt_math_LightPoint(_e202.uv, 0f, _e202.is_inside);
            phi_404_ = lt_math_LightPoint();
            phi_407_ = 0u;
            phi_409_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e206.uv, _e206.depth, false));
            loop {
                let _e213 = phi_404_;
                let _e215 = phi_407_;
                let _e217 = phi_409_;
                local_1 = _e217;
                local_2 = _e217;
                local_3 = _e217;
                local_4 = _e217;
                if (_e215 < _e65) {
                    if _e217.point.is_inside {
                        phi_570_ = lt_math_LightPoint();
                        phi_571_ = u32();
                        phi_572_ = lt_math_LevelPoint();
                        phi_573_ = false;
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
                                phi_495_ = (_e253 <= 1f);
                            } else {
                                phi_495_ = false;
                            }
                            let _e285 = phi_495_;
                            if _e285 {
                                if (_e267 >= 0f) {
                                    phi_504_ = (_e267 <= 1f);
                                } else {
                                    phi_504_ = false;
                                }
                                let _e289 = phi_504_;
                                if _e289 {
                                    if (_e280 >= 0f) {
                                        phi_513_ = (_e280 <= 1f);
                                    } else {
                                        phi_513_ = false;
                                    }
                                    let _e293 = phi_513_;
                                    phi_514_ = _e293;
                                    phi_515_ = false;
                                } else {
                                    phi_514_ = bool();
                                    phi_515_ = true;
                                }
                                let _e295 = phi_514_;
                                let _e297 = phi_515_;
                                phi_516_ = _e295;
                                phi_517_ = _e297;
                            } else {
                                phi_516_ = bool();
                                phi_517_ = true;
                            }
                            let _e299 = phi_516_;
                            let _e301 = phi_517_;
                            phi_518_ = _e299;
                            phi_519_ = _e301;
                        } else {
                            phi_518_ = bool();
                            phi_519_ = true;
                        }
                        let _e303 = phi_518_;
                        let _e305 = phi_519_;
                        if _e305 {
                            phi_523_ = false;
                        } else {
                            phi_523_ = _e303;
                        }
                        let _e307 = phi_523_;
                        if _e307 {
                            if (_e253 >= _e188) {
                                if (_e253 <= (1f - _e188)) {
                                    if (_e267 >= _e188) {
                                        phi_550_ = (_e267 <= (1f - _e188));
                                        phi_551_ = false;
                                    } else {
                                        phi_550_ = bool();
                                        phi_551_ = true;
                                    }
                                    let _e315 = phi_550_;
                                    let _e317 = phi_551_;
                                    phi_552_ = _e315;
                                    phi_553_ = _e317;
                                } else {
                                    phi_552_ = bool();
                                    phi_553_ = true;
                                }
                                let _e319 = phi_552_;
                                let _e321 = phi_553_;
                                phi_554_ = _e319;
                                phi_555_ = _e321;
                            } else {
                                phi_554_ = bool();
                                phi_555_ = true;
                            }
                            let _e323 = phi_554_;
                            let _e325 = phi_555_;
                            phi_556_ = _e323;
                            phi_557_ = _e325;
                        } else {
                            phi_556_ = bool();
                            phi_557_ = true;
                        }
                        let _e327 = phi_556_;
                        let _e329 = phi_557_;
                        if _e329 {
                            phi_561_ = false;
                        } else {
                            phi_561_ = _e327;
                        }
                        let _e331 = phi_561_;
                        let _e338 = lt_math_LightPoint(vec2<f32>(_e253, _e213.uv.y), _e213.depth, _e213.is_inside);
                        let _e345 = lt_math_LightPoint(vec2<f32>(_e338.uv.x, _e267), _e338.depth, _e338.is_inside);
                        let _e349 = lt_math_LightPoint(_e345.uv, _e280, _e345.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e349.depth, _e331);
                        phi_570_ = _e353;
                        phi_571_ = (_e215 + 1u);
                        phi_572_ = lt_math_LevelPoint(_e215, _e353);
                        phi_573_ = true;
                    }
                    let _e357 = phi_570_;
                    let _e359 = phi_571_;
                    let _e361 = phi_572_;
                    let _e363 = phi_573_;
                    phi_405_ = _e357;
                    phi_408_ = _e359;
                    phi_410_ = _e361;
                    phi_574_ = _e363;
                } else {
                    phi_405_ = lt_math_LightPoint();
                    phi_408_ = u32();
                    phi_410_ = lt_math_LevelPoint();
                    phi_574_ = false;
                }
                let _e365 = phi_405_;
                let _e367 = phi_408_;
                let _e369 = phi_410_;
                let _e371 = phi_574_;
                continue;
                continuing {
                    phi_404_ = _e365;
                    phi_407_ = _e367;
                    phi_409_ = _e369;
                    break if !(_e371);
                }
            }
            let _e374 = local_1;
            if _e374.point.is_inside {
                if (0.5f > 0f) {
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
                            phi_614_ = (_e385.row_w.z == _e397);
                            phi_615_ = false;
                        } else {
                            phi_614_ = bool();
                            phi_615_ = true;
                        }
                        let _e400 = phi_614_;
                        let _e402 = phi_615_;
                        phi_616_ = _e400;
                        phi_617_ = _e402;
                    } else {
                        phi_616_ = bool();
                        phi_617_ = true;
                    }
                    let _e404 = phi_616_;
                    let _e406 = phi_617_;
                    if _e406 {
                        phi_621_ = false;
                    } else {
                        phi_621_ = _e404;
                    }
                    let _e408 = phi_621_;
                    if _e408 {
                        let _e410 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e412 = p.member.map_size;
                        let _e482 = ((abs(((((_e385.row_x.x * _e410.x) + (_e385.row_x.y * _e410.y)) + (_e385.row_x.z * _e410.z)) / (((_e385.row_x.x * _e385.row_x.x) + (_e385.row_x.y * _e385.row_x.y)) + (_e385.row_x.z * _e385.row_x.z)))) + abs(((((_e385.row_y.x * _e410.x) + (_e385.row_y.y * _e410.y)) + (_e385.row_y.z * _e410.z)) / (((_e385.row_y.x * _e385.row_y.x) + (_e385.row_y.y * _e385.row_y.y)) + (_e385.row_y.z * _e385.row_y.z))))) / (abs(((((_e385.row_z.x * _e410.x) + (_e385.row_z.y * _e410.y)) + (_e385.row_z.z * _e410.z)) / (((_e385.row_z.x * _e385.row_z.x) + (_e385.row_z.y * _e385.row_z.y)) + (_e385.row_z.z * _e385.row_z.z)))) * f32(_e412)));
                        if (_e482 < 0.002f) {
                            phi_703_ = _e482;
                        } else {
                            phi_703_ = 0.002f;
                        }
                        let _e485 = phi_703_;
                        phi_820_ = _e485;
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
                            phi_819_ = _e599;
                        } else {
                            phi_819_ = 0.002f;
                        }
                        let _e602 = phi_819_;
                        phi_820_ = _e602;
                    }
                    let _e604 = phi_820_;
                    phi_823_ = (_e374.point.depth - (0.5f * _e604));
                } else {
                    phi_823_ = _e374.point.depth;
                }
                let _e608 = phi_823_;
                let _e614 = p.member.map_size;
                let _e615 = f32(_e614);
                let _e618 = ((_e374.point.uv.x * _e615) - 0.5f);
                let _e619 = ((_e374.point.uv.y * _e615) - 0.5f);
                if (_e618 > -8388608f) {
                    let _e631 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e631 > _e618) {
                        phi_852_ = 1f;
                    } else {
                        phi_852_ = 0f;
                    }
                    let _e634 = phi_852_;
                    if (_e618 < 8388608f) {
                        phi_857_ = (_e631 - _e634);
                        phi_858_ = false;
                    } else {
                        phi_857_ = f32();
                        phi_858_ = true;
                    }
                    let _e637 = phi_857_;
                    let _e639 = phi_858_;
                    phi_859_ = _e637;
                    phi_860_ = _e639;
                } else {
                    phi_859_ = f32();
                    phi_860_ = true;
                }
                let _e641 = phi_859_;
                let _e643 = phi_860_;
                if _e643 {
                    phi_864_ = _e618;
                } else {
                    phi_864_ = _e641;
                }
                let _e645 = phi_864_;
                if (_e619 > -8388608f) {
                    let _e657 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e657 > _e619) {
                        phi_884_ = 1f;
                    } else {
                        phi_884_ = 0f;
                    }
                    let _e660 = phi_884_;
                    if (_e619 < 8388608f) {
                        phi_889_ = (_e657 - _e660);
                        phi_890_ = false;
                    } else {
                        phi_889_ = f32();
                        phi_890_ = true;
                    }
                    let _e663 = phi_889_;
                    let _e665 = phi_890_;
                    phi_891_ = _e663;
                    phi_892_ = _e665;
                } else {
                    phi_891_ = f32();
                    phi_892_ = true;
                }
                let _e667 = phi_891_;
                let _e669 = phi_892_;
                if _e669 {
                    phi_896_ = _e619;
                } else {
                    phi_896_ = _e667;
                }
                let _e671 = phi_896_;
                let _e672 = (_e618 - _e645);
                let _e673 = (_e619 - _e671);
                let _e682 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < bitcast<f32>(3472883712u))), 2147483647i, (_e645 > bitcast<f32>(1325400063u))), (_e645 == _e645));
                let _e691 = select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671));
                let _e702 = p.member.test;
                let _e703 = _lt_math_sm_Sm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e702);
                let _e705 = p.member.map_size;
                let _e707 = local_3;
                local = _e703;
                let _e710 = ((_e707.level * _e705) * _e705);
                let _e712 = (bitcast<i32>(_e705) - 1i);
                if (_e682 > 0i) {
                    phi_945_ = _e682;
                } else {
                    phi_945_ = 0i;
                }
                let _e715 = phi_945_;
                if (_e691 > 0i) {
                    phi_950_ = _e691;
                } else {
                    phi_950_ = 0i;
                }
                let _e718 = phi_950_;
                if (_e715 < _e712) {
                    phi_955_ = _e715;
                } else {
                    phi_955_ = _e712;
                }
                let _e721 = phi_955_;
                if (_e718 < _e712) {
                    phi_960_ = _e718;
                } else {
                    phi_960_ = _e712;
                }
                let _e724 = phi_960_;
                let _e725 = bitcast<u32>(_e721);
                let _e727 = (_e682 + 1i);
                let _e728 = (_e691 + 1i);
                if (_e727 > 0i) {
                    phi_969_ = _e727;
                } else {
                    phi_969_ = 0i;
                }
                let _e731 = phi_969_;
                if (_e728 > 0i) {
                    phi_974_ = _e728;
                } else {
                    phi_974_ = 0i;
                }
                let _e734 = phi_974_;
                if (_e731 < _e712) {
                    phi_979_ = _e731;
                } else {
                    phi_979_ = _e712;
                }
                let _e737 = phi_979_;
                if (_e734 < _e712) {
                    phi_984_ = _e734;
                } else {
                    phi_984_ = _e712;
                }
                let _e740 = phi_984_;
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
                let _e770 = _lt_math_sm_Sm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e756, _e760, _e764, _e768), vec4<f32>(((1f - _e672) * (1f - _e673)), (_e672 * (1f - _e673)), ((1f - _e672) * _e673), (_e672 * _e673)), _e608);
                let _e772 = p.member.fade_uv;
                if (_e772 > 0f) {
                    let _e775 = local_4;
                    if ((_e775.level + 1u) == _e65) {
                        let _e784 = p.member.fade_uv;
                        let _e786 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e374.point.uv.x, (1f - _e374.point.uv.x));
                        let _e788 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e374.point.uv.y, (1f - _e374.point.uv.y));
                        let _e789 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e786, _e788);
                        if (_e789 < _e784) {
                            phi_1056_ = (1f - ((1f - _e770) * (_e789 / _e784)));
                        } else {
                            phi_1056_ = _e770;
                        }
                        let _e796 = phi_1056_;
                        phi_1058_ = evaluate_Verdict(_e796, false);
                        phi_1059_ = false;
                    } else {
                        phi_1058_ = evaluate_Verdict();
                        phi_1059_ = true;
                    }
                    let _e799 = phi_1058_;
                    let _e801 = phi_1059_;
                    phi_1060_ = _e799;
                    phi_1061_ = _e801;
                } else {
                    phi_1060_ = evaluate_Verdict();
                    phi_1061_ = true;
                }
                let _e803 = phi_1060_;
                let _e805 = phi_1061_;
                if _e805 {
                    phi_1066_ = evaluate_Verdict(_e770, false);
                    phi_1067_ = false;
                } else {
                    phi_1066_ = evaluate_Verdict();
                    phi_1067_ = true;
                }
                let _e808 = phi_1066_;
                let _e810 = phi_1067_;
                phi_1069_ = _e808;
                phi_1070_ = _e803;
                phi_1071_ = _e810;
            } else {
                phi_1069_ = evaluate_Verdict();
                phi_1070_ = evaluate_Verdict(1f, false);
                phi_1071_ = true;
            }
            let _e813 = phi_1069_;
            let _e815 = phi_1070_;
            let _e817 = phi_1071_;
            if _e817 {
            }
            phi_1075_ = _e815;
            phi_1076_ = _e813;
            phi_1077_ = _e817;
        }
        let _e819 = phi_1075_;
        let _e821 = phi_1076_;
        let _e823 = phi_1077_;
        if _e823 {
            phi_1081_ = _e819;
        } else {
            phi_1081_ = _e821;
        }
        let _e825 = phi_1081_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e825.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_sm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
