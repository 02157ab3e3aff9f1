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

struct type_39 {
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

struct type_43 {
    member: abi_ShadowParams,
}

struct type_47 {
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

struct type_55 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_55;
@group(0) @binding(5) 
var<storage> levels: type_47;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_178_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_bvh_traverse_Tree();
            phi_171_ = true;
        }
        let _e61 = phi_170_;
        let _e63 = phi_171_;
        phi_172_ = _e61;
        phi_173_ = _e63;
    } else {
        phi_172_ = lt_bvh_traverse_Tree();
        phi_173_ = true;
    }
    let _e65 = phi_172_;
    let _e67 = phi_173_;
    if _e67 {
        phi_178_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_178_ = _e65;
    }
    let _e72 = phi_178_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_203_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_223_: bool;
    var phi_227_: f32;
    var phi_239_: bool;
    var phi_246_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_263_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_205_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_204_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_203_ = 1f;
            } else {
                phi_203_ = param_6;
            }
            let _e57 = phi_203_;
            phi_204_ = _e57;
        }
        let _e59 = phi_204_;
        phi_205_ = _e59;
    }
    let _e61 = phi_205_;
    let _e64 = (*param_4);
    let _e68 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e64) & 2147483647u) > 2139095040u) {
        phi_223_ = true;
    } else {
        let _e72 = (_e64 > _e68);
        if _e72 {
        }
        phi_223_ = _e72;
    }
    let _e74 = phi_223_;
    if _e74 {
        phi_227_ = _e64;
    } else {
        phi_227_ = _e68;
    }
    let _e76 = phi_227_;
    let _e77 = (_e61 - param_5.x);
    if (_e77 <= 0f) {
        let _e81 = ((bitcast<u32>(_e76) & 2147483647u) > 2139095040u);
        if _e81 {
        }
        phi_239_ = _e81;
    } else {
        phi_239_ = true;
    }
    let _e83 = phi_239_;
    if _e83 {
        phi_246_ = (_e76 / (_e76 + (_e77 * _e77)));
    } else {
        phi_246_ = 1f;
    }
    let _e88 = phi_246_;
    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
        phi_263_ = _e88;
    } else {
        if (_e88 < 0f) {
            phi_262_ = 0f;
        } else {
            if (_e88 > 1f) {
                phi_261_ = 1f;
            } else {
                phi_261_ = _e88;
            }
            let _e95 = phi_261_;
            phi_262_ = _e95;
        }
        let _e97 = phi_262_;
        phi_263_ = _e97;
    }
    let _e99 = phi_263_;
    return _e99;
}

fn function_() {
    var local_1: f32;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_325_: bool;
    var phi_395_: bool;
    var phi_396_: bool;
    var phi_407_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_408_: bool;
    var phi_409_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_410_: bool;
    var phi_417_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_421_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_441_: lt_math_LightPoint;
    var phi_444_: u32;
    var phi_446_: lt_math_LevelPoint;
    var phi_532_: bool;
    var phi_541_: bool;
    var phi_550_: bool;
    var phi_551_: bool;
    var phi_552_: bool;
    var phi_553_: bool;
    var phi_554_: bool;
    var phi_555_: bool;
    var phi_556_: bool;
    var phi_560_: bool;
    var phi_587_: bool;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_591_: bool;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_598_: bool;
    var phi_607_: lt_math_LightPoint;
    var phi_608_: u32;
    var phi_609_: lt_math_LevelPoint;
    var phi_610_: bool;
    var phi_442_: lt_math_LightPoint;
    var phi_445_: u32;
    var phi_447_: lt_math_LevelPoint;
    var phi_611_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_658_: bool;
    var phi_740_: f32;
    var phi_858_: f32;
    var phi_859_: f32;
    var phi_862_: f32;
    var phi_891_: f32;
    var phi_896_: f32;
    var phi_897_: bool;
    var phi_898_: f32;
    var phi_899_: bool;
    var phi_903_: f32;
    var phi_923_: f32;
    var phi_928_: f32;
    var phi_929_: bool;
    var phi_930_: f32;
    var phi_931_: bool;
    var phi_935_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_984_: i32;
    var phi_989_: i32;
    var phi_994_: i32;
    var phi_999_: i32;
    var phi_1008_: i32;
    var phi_1013_: i32;
    var phi_1018_: i32;
    var phi_1023_: i32;
    var phi_1120_: bool;
    var phi_1128_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1145_: f32;
    var phi_1151_: f32;
    var phi_1153_: evaluate_Verdict;
    var phi_1163_: u32;
    var phi_1172_: f32;
    var phi_1174_: evaluate_Verdict;
    var phi_1175_: bool;
    var phi_1176_: evaluate_Verdict;
    var phi_1177_: bool;
    var phi_1182_: evaluate_Verdict;
    var phi_1187_: evaluate_Verdict;
    var phi_1188_: evaluate_Verdict;
    var phi_1192_: bool;
    var phi_1193_: u32;
    var phi_1204_: u32;
    var phi_1221_: u32;

    let _e49 = id_1;
    let _e50 = local_5;
    let _e55 = arrayLength((&map.member));
    let _e60 = arrayLength((&levels.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e49, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.level_count;
        let _e77 = samples.member[_e66.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e66.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e66.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_318_ = (_e87 == _e89);
                phi_319_ = false;
            } else {
                phi_318_ = bool();
                phi_319_ = true;
            }
            let _e92 = phi_318_;
            let _e94 = phi_319_;
            phi_320_ = _e92;
            phi_321_ = _e94;
        } else {
            phi_320_ = bool();
            phi_321_ = true;
        }
        let _e96 = phi_320_;
        let _e98 = phi_321_;
        if _e98 {
            phi_325_ = false;
        } else {
            phi_325_ = _e96;
        }
        let _e100 = phi_325_;
        if !(_e100) {
            let _e103 = samples.member[_e66.first_primitive].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[_e66.first_primitive].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_396_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_395_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_395_ = false;
                    }
                    let _e161 = phi_395_;
                    phi_396_ = _e161;
                }
                let _e163 = phi_396_;
                if _e163 {
                    let _e165 = samples.member[_e66.first_primitive].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_407_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_408_ = false;
                } else {
                    phi_407_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_408_ = true;
                }
                let _e184 = phi_407_;
                let _e186 = phi_408_;
                phi_409_ = _e184;
                phi_410_ = _e186;
            } else {
                phi_409_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_410_ = true;
            }
            let _e188 = phi_409_;
            let _e190 = phi_410_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_417_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_417_ = _e188;
            }
            let _e207 = phi_417_;
            phi_421_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_421_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_421_;
        if _e224.unnamed_1 {
            phi_1188_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[_e66.first_primitive].position;
            let _e234 = p.member.map_size;
            let _e236 = (0.5f / f32(_e234));
            let _e243 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e250 = lt_math_LightPoint(vec2<f32>(_e243.uv.x, 0f), _e243.depth, _e243.is_inside);
            let _e254 = lt_math_LightPoint(_e250.uv, 0f, _e250.is_inside);
            phi_441_ = lt_math_LightPoint();
            phi_444_ = 0u;
            phi_446_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e254.uv, _e254.depth, false));
            loop {
                let _e261 = phi_441_;
                let _e263 = phi_444_;
                let _e265 = phi_446_;
                local_2 = _e265;
                local_3 = _e265;
                local_4 = _e265;
                if (_e263 < _e73) {
                    if _e265.point.is_inside {
                        phi_607_ = lt_math_LightPoint();
                        phi_608_ = u32();
                        phi_609_ = lt_math_LevelPoint();
                        phi_610_ = false;
                    } else {
                        if (_e263 < _e60) {
                        } else {
                            return;
                        }
                        let _e276 = levels.member[(0u + _e263)].row_w;
                        let _e287 = ((((_e276.x * _e232.x) + (_e276.y * _e232.y)) + (_e276.z * _e232.z)) + (_e276.w * 1f));
                        let _e289 = levels.member[(0u + _e263)].row_x;
                        let _e301 = (((((_e289.x * _e232.x) + (_e289.y * _e232.y)) + (_e289.z * _e232.z)) + (_e289.w * 1f)) / _e287);
                        let _e303 = levels.member[(0u + _e263)].row_y;
                        let _e315 = (((((_e303.x * _e232.x) + (_e303.y * _e232.y)) + (_e303.z * _e232.z)) + (_e303.w * 1f)) / _e287);
                        let _e317 = levels.member[(0u + _e263)].row_z;
                        let _e328 = ((((_e317.x * _e232.x) + (_e317.y * _e232.y)) + (_e317.z * _e232.z)) + (_e317.w * 1f));
                        if (_e287 > 0f) {
                            if (_e301 >= 0f) {
                                phi_532_ = (_e301 <= 1f);
                            } else {
                                phi_532_ = false;
                            }
                            let _e333 = phi_532_;
                            if _e333 {
                                if (_e315 >= 0f) {
                                    phi_541_ = (_e315 <= 1f);
                                } else {
                                    phi_541_ = false;
                                }
                                let _e337 = phi_541_;
                                if _e337 {
                                    if (_e328 >= 0f) {
                                        phi_550_ = (_e328 <= 1f);
                                    } else {
                                        phi_550_ = false;
                                    }
                                    let _e341 = phi_550_;
                                    phi_551_ = _e341;
                                    phi_552_ = false;
                                } else {
                                    phi_551_ = bool();
                                    phi_552_ = true;
                                }
                                let _e343 = phi_551_;
                                let _e345 = phi_552_;
                                phi_553_ = _e343;
                                phi_554_ = _e345;
                            } else {
                                phi_553_ = bool();
                                phi_554_ = true;
                            }
                            let _e347 = phi_553_;
                            let _e349 = phi_554_;
                            phi_555_ = _e347;
                            phi_556_ = _e349;
                        } else {
                            phi_555_ = bool();
                            phi_556_ = true;
                        }
                        let _e351 = phi_555_;
                        let _e353 = phi_556_;
                        if _e353 {
                            phi_560_ = false;
                        } else {
                            phi_560_ = _e351;
                        }
                        let _e355 = phi_560_;
                        if _e355 {
                            if (_e301 >= _e236) {
                                if (_e301 <= (1f - _e236)) {
                                    if (_e315 >= _e236) {
                                        phi_587_ = (_e315 <= (1f - _e236));
                                        phi_588_ = false;
                                    } else {
                                        phi_587_ = bool();
                                        phi_588_ = true;
                                    }
                                    let _e363 = phi_587_;
                                    let _e365 = phi_588_;
                                    phi_589_ = _e363;
                                    phi_590_ = _e365;
                                } else {
                                    phi_589_ = bool();
                                    phi_590_ = true;
                                }
                                let _e367 = phi_589_;
                                let _e369 = phi_590_;
                                phi_591_ = _e367;
                                phi_592_ = _e369;
                            } else {
                                phi_591_ = bool();
                                phi_592_ = true;
                            }
                            let _e371 = phi_591_;
                            let _e373 = phi_592_;
                            phi_593_ = _e371;
                            phi_594_ = _e373;
                        } else {
                            phi_593_ = bool();
                            phi_594_ = true;
                        }
                        let _e375 = phi_593_;
                        let _e377 = phi_594_;
                        if _e377 {
                            phi_598_ = false;
                        } else {
                            phi_598_ = _e375;
                        }
                        let _e379 = phi_598_;
                        let _e386 = lt_math_LightPoint(vec2<f32>(_e301, _e261.uv.y), _e261.depth, _e261.is_inside);
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e386.uv.x, _e315), _e386.depth, _e386.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e328, _e393.is_inside);
                        let _e401 = lt_math_LightPoint(_e397.uv, _e397.depth, _e379);
                        phi_607_ = _e401;
                        phi_608_ = (_e263 + 1u);
                        phi_609_ = lt_math_LevelPoint(_e263, _e401);
                        phi_610_ = true;
                    }
                    let _e405 = phi_607_;
                    let _e407 = phi_608_;
                    let _e409 = phi_609_;
                    let _e411 = phi_610_;
                    phi_442_ = _e405;
                    phi_445_ = _e407;
                    phi_447_ = _e409;
                    phi_611_ = _e411;
                } else {
                    phi_442_ = lt_math_LightPoint();
                    phi_445_ = u32();
                    phi_447_ = lt_math_LevelPoint();
                    phi_611_ = false;
                }
                let _e413 = phi_442_;
                let _e415 = phi_445_;
                let _e417 = phi_447_;
                let _e419 = phi_611_;
                continue;
                continuing {
                    phi_441_ = _e413;
                    phi_444_ = _e415;
                    phi_446_ = _e417;
                    break if !(_e419);
                }
            }
            let _e422 = local_2;
            if _e422.point.is_inside {
                if (0f > 0f) {
                    let _e428 = local_3;
                    if (_e428.level < _e60) {
                    } else {
                        return;
                    }
                    let _e433 = levels.member[(0u + _e428.level)];
                    let _e439 = global[0u];
                    if (_e433.row_w.x == _e439) {
                        let _e442 = global[1u];
                        if (_e433.row_w.y == _e442) {
                            let _e445 = global[2u];
                            phi_651_ = (_e433.row_w.z == _e445);
                            phi_652_ = false;
                        } else {
                            phi_651_ = bool();
                            phi_652_ = true;
                        }
                        let _e448 = phi_651_;
                        let _e450 = phi_652_;
                        phi_653_ = _e448;
                        phi_654_ = _e450;
                    } else {
                        phi_653_ = bool();
                        phi_654_ = true;
                    }
                    let _e452 = phi_653_;
                    let _e454 = phi_654_;
                    if _e454 {
                        phi_658_ = false;
                    } else {
                        phi_658_ = _e452;
                    }
                    let _e456 = phi_658_;
                    if _e456 {
                        let _e458 = samples.member[_e66.first_primitive].normal;
                        let _e460 = p.member.map_size;
                        let _e530 = ((abs(((((_e433.row_x.x * _e458.x) + (_e433.row_x.y * _e458.y)) + (_e433.row_x.z * _e458.z)) / (((_e433.row_x.x * _e433.row_x.x) + (_e433.row_x.y * _e433.row_x.y)) + (_e433.row_x.z * _e433.row_x.z)))) + abs(((((_e433.row_y.x * _e458.x) + (_e433.row_y.y * _e458.y)) + (_e433.row_y.z * _e458.z)) / (((_e433.row_y.x * _e433.row_y.x) + (_e433.row_y.y * _e433.row_y.y)) + (_e433.row_y.z * _e433.row_y.z))))) / (abs(((((_e433.row_z.x * _e458.x) + (_e433.row_z.y * _e458.y)) + (_e433.row_z.z * _e458.z)) / (((_e433.row_z.x * _e433.row_z.x) + (_e433.row_z.y * _e433.row_z.y)) + (_e433.row_z.z * _e433.row_z.z)))) * f32(_e460)));
                        if (_e530 < 0.002f) {
                            phi_740_ = _e530;
                        } else {
                            phi_740_ = 0.002f;
                        }
                        let _e533 = phi_740_;
                        phi_859_ = _e533;
                    } else {
                        let _e535 = p.member.map_size;
                        let _e541 = samples.member[_e66.first_primitive].position;
                        let _e552 = ((((_e433.row_w.x * _e541.x) + (_e433.row_w.y * _e541.y)) + (_e433.row_w.z * _e541.z)) + _e433.row_w.w);
                        let _e565 = ((_e433.row_x.x - (_e433.row_w.x * _e422.point.uv.x)) / _e552);
                        let _e566 = ((_e433.row_x.y - (_e433.row_w.y * _e422.point.uv.x)) / _e552);
                        let _e567 = ((_e433.row_x.z - (_e433.row_w.z * _e422.point.uv.x)) / _e552);
                        let _e580 = ((_e433.row_y.x - (_e433.row_w.x * _e422.point.uv.y)) / _e552);
                        let _e581 = ((_e433.row_y.y - (_e433.row_w.y * _e422.point.uv.y)) / _e552);
                        let _e582 = ((_e433.row_y.z - (_e433.row_w.z * _e422.point.uv.y)) / _e552);
                        let _e588 = samples.member[_e66.first_primitive].normal;
                        let _e593 = ((_e581 * _e588.z) - (_e588.y * _e582));
                        let _e598 = ((_e582 * _e588.x) - (_e588.z * _e580));
                        let _e603 = ((_e580 * _e588.y) - (_e588.x * _e581));
                        let _e605 = samples.member[_e66.first_primitive].normal;
                        let _e610 = ((_e566 * _e605.z) - (_e605.y * _e567));
                        let _e615 = ((_e567 * _e605.x) - (_e605.z * _e565));
                        let _e620 = ((_e565 * _e605.y) - (_e605.x * _e566));
                        let _e647 = ((abs(((((_e433.row_z.x * _e593) + (_e433.row_z.y * _e598)) + (_e433.row_z.z * _e603)) / (((_e565 * _e593) + (_e566 * _e598)) + (_e567 * _e603)))) + abs(((((_e433.row_z.x * _e610) + (_e433.row_z.y * _e615)) + (_e433.row_z.z * _e620)) / (((_e580 * _e610) + (_e581 * _e615)) + (_e582 * _e620))))) / f32(_e535));
                        let _e649 = (16f / f32(_e535));
                        if (_e647 < _e649) {
                            phi_858_ = _e647;
                        } else {
                            phi_858_ = _e649;
                        }
                        let _e652 = phi_858_;
                        phi_859_ = _e652;
                    }
                    let _e654 = phi_859_;
                    phi_862_ = (_e422.point.depth - (0f * _e654));
                } else {
                    phi_862_ = _e422.point.depth;
                }
                let _e658 = phi_862_;
                let _e664 = p.member.map_size;
                let _e665 = f32(_e664);
                let _e668 = ((_e422.point.uv.x * _e665) - 0.5f);
                let _e669 = ((_e422.point.uv.y * _e665) - 0.5f);
                if (_e668 > -8388608f) {
                    let _e681 = f32(select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < bitcast<f32>(3472883712u))), 2147483647i, (_e668 > bitcast<f32>(1325400063u))), (_e668 == _e668)));
                    if (_e681 > _e668) {
                        phi_891_ = 1f;
                    } else {
                        phi_891_ = 0f;
                    }
                    let _e684 = phi_891_;
                    if (_e668 < 8388608f) {
                        phi_896_ = (_e681 - _e684);
                        phi_897_ = false;
                    } else {
                        phi_896_ = f32();
                        phi_897_ = true;
                    }
                    let _e687 = phi_896_;
                    let _e689 = phi_897_;
                    phi_898_ = _e687;
                    phi_899_ = _e689;
                } else {
                    phi_898_ = f32();
                    phi_899_ = true;
                }
                let _e691 = phi_898_;
                let _e693 = phi_899_;
                if _e693 {
                    phi_903_ = _e668;
                } else {
                    phi_903_ = _e691;
                }
                let _e695 = phi_903_;
                if (_e669 > -8388608f) {
                    let _e707 = f32(select(0i, select(select(i32(_e669), i32(-2147483648), (_e669 < bitcast<f32>(3472883712u))), 2147483647i, (_e669 > bitcast<f32>(1325400063u))), (_e669 == _e669)));
                    if (_e707 > _e669) {
                        phi_923_ = 1f;
                    } else {
                        phi_923_ = 0f;
                    }
                    let _e710 = phi_923_;
                    if (_e669 < 8388608f) {
                        phi_928_ = (_e707 - _e710);
                        phi_929_ = false;
                    } else {
                        phi_928_ = f32();
                        phi_929_ = true;
                    }
                    let _e713 = phi_928_;
                    let _e715 = phi_929_;
                    phi_930_ = _e713;
                    phi_931_ = _e715;
                } else {
                    phi_930_ = f32();
                    phi_931_ = true;
                }
                let _e717 = phi_930_;
                let _e719 = phi_931_;
                if _e719 {
                    phi_935_ = _e669;
                } else {
                    phi_935_ = _e717;
                }
                let _e721 = phi_935_;
                let _e722 = (_e668 - _e695);
                let _e723 = (_e669 - _e721);
                let _e732 = select(0i, select(select(i32(_e695), i32(-2147483648), (_e695 < bitcast<f32>(3472883712u))), 2147483647i, (_e695 > bitcast<f32>(1325400063u))), (_e695 == _e695));
                let _e741 = select(0i, select(select(i32(_e721), i32(-2147483648), (_e721 < bitcast<f32>(3472883712u))), 2147483647i, (_e721 > bitcast<f32>(1325400063u))), (_e721 == _e721));
                let _e744 = ((1f - _e722) * (1f - _e723));
                let _e746 = (_e722 * (1f - _e723));
                let _e748 = ((1f - _e722) * _e723);
                let _e749 = (_e722 * _e723);
                let _e751 = p.member.test;
                let _e752 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e751);
                let _e754 = p.member.map_size;
                let _e756 = local_4;
                local_1 = _e752;
                let _e759 = ((_e756.level * _e754) * _e754);
                let _e761 = (bitcast<i32>(_e754) - 1i);
                if (_e732 > 0i) {
                    phi_984_ = _e732;
                } else {
                    phi_984_ = 0i;
                }
                let _e764 = phi_984_;
                if (_e741 > 0i) {
                    phi_989_ = _e741;
                } else {
                    phi_989_ = 0i;
                }
                let _e767 = phi_989_;
                if (_e764 < _e761) {
                    phi_994_ = _e764;
                } else {
                    phi_994_ = _e761;
                }
                let _e770 = phi_994_;
                if (_e767 < _e761) {
                    phi_999_ = _e767;
                } else {
                    phi_999_ = _e761;
                }
                let _e773 = phi_999_;
                let _e774 = bitcast<u32>(_e770);
                let _e776 = (_e732 + 1i);
                let _e777 = (_e741 + 1i);
                if (_e776 > 0i) {
                    phi_1008_ = _e776;
                } else {
                    phi_1008_ = 0i;
                }
                let _e780 = phi_1008_;
                if (_e777 > 0i) {
                    phi_1013_ = _e777;
                } else {
                    phi_1013_ = 0i;
                }
                let _e783 = phi_1013_;
                if (_e780 < _e761) {
                    phi_1018_ = _e780;
                } else {
                    phi_1018_ = _e761;
                }
                let _e786 = phi_1018_;
                if (_e783 < _e761) {
                    phi_1023_ = _e783;
                } else {
                    phi_1023_ = _e761;
                }
                let _e789 = phi_1023_;
                let _e790 = bitcast<u32>(_e786);
                let _e792 = (bitcast<u32>(_e773) * _e754);
                let _e793 = (bitcast<u32>(_e789) * _e754);
                let _e798 = ((_e792 + _e774) + _e759);
                let _e799 = ((_e792 + _e790) + _e759);
                let _e800 = ((_e793 + _e774) + _e759);
                let _e801 = ((_e793 + _e790) + _e759);
                if (_e798 < _e55) {
                } else {
                    return;
                }
                let _e805 = map.member[(0u + _e798)];
                if (_e799 < _e55) {
                } else {
                    return;
                }
                let _e817 = map.member[(0u + _e799)];
                if (_e800 < _e55) {
                } else {
                    return;
                }
                let _e833 = map.member[(0u + _e800)];
                if (_e801 < _e55) {
                } else {
                    return;
                }
                let _e849 = map.member[(0u + _e801)];
                let _e863 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e805.x * _e744) + (_e817.x * _e746)) + (_e833.x * _e748)) + (_e849.x * _e749)), ((((_e805.y * _e744) + (_e817.y * _e746)) + (_e833.y * _e748)) + (_e849.y * _e749)), ((((_e805.z * _e744) + (_e817.z * _e746)) + (_e833.z * _e748)) + (_e849.z * _e749)), ((((_e805.w * _e744) + (_e817.w * _e746)) + (_e833.w * _e748)) + (_e849.w * _e749))), _e658);
                let _e867 = p.member.epsilon;
                if (_e863 <= _e867) {
                    phi_1120_ = true;
                } else {
                    phi_1120_ = (_e863 >= (1f - _e867));
                }
                let _e872 = phi_1120_;
                if ((bitcast<u32>(_e863) & 2147483647u) > 2139095040u) {
                    phi_1128_ = true;
                } else {
                    phi_1128_ = !(_e872);
                }
                let _e878 = phi_1128_;
                if _e878 {
                    if (_e863 > 0f) {
                        if (_e863 < 1f) {
                            phi_1140_ = false;
                        } else {
                            phi_1140_ = true;
                        }
                        let _e882 = phi_1140_;
                        phi_1141_ = _e882;
                    } else {
                        phi_1141_ = true;
                    }
                    let _e884 = phi_1141_;
                    if _e884 {
                        phi_1145_ = 0.5f;
                    } else {
                        phi_1145_ = _e863;
                    }
                    let _e886 = phi_1145_;
                    phi_1153_ = evaluate_Verdict(_e886, true);
                } else {
                    if (_e863 > 0.5f) {
                        phi_1151_ = 1f;
                    } else {
                        phi_1151_ = 0f;
                    }
                    let _e890 = phi_1151_;
                    phi_1153_ = evaluate_Verdict(_e890, false);
                }
                let _e893 = phi_1153_;
                let _e896 = (_e893.visibility < 0.5f);
                if _e893.is_doubted {
                    phi_1176_ = evaluate_Verdict();
                    phi_1177_ = true;
                } else {
                    if _e896 {
                        phi_1163_ = 2u;
                    } else {
                        phi_1163_ = 1u;
                    }
                    let _e898 = phi_1163_;
                    if ((0u & _e898) != 0u) {
                        if _e896 {
                            phi_1172_ = 0.000000059604645f;
                        } else {
                            phi_1172_ = 0.99999994f;
                        }
                        let _e902 = phi_1172_;
                        phi_1174_ = evaluate_Verdict(_e902, true);
                        phi_1175_ = false;
                    } else {
                        phi_1174_ = evaluate_Verdict();
                        phi_1175_ = true;
                    }
                    let _e905 = phi_1174_;
                    let _e907 = phi_1175_;
                    phi_1176_ = _e905;
                    phi_1177_ = _e907;
                }
                let _e909 = phi_1176_;
                let _e911 = phi_1177_;
                if _e911 {
                    phi_1182_ = evaluate_Verdict(_e893.visibility, _e893.is_doubted);
                } else {
                    phi_1182_ = _e909;
                }
                let _e914 = phi_1182_;
                phi_1187_ = evaluate_Verdict(_e914.visibility, _e914.is_doubted);
            } else {
                phi_1187_ = evaluate_Verdict(0.5f, true);
            }
            let _e920 = phi_1187_;
            phi_1188_ = _e920;
        }
        let _e922 = phi_1188_;
        visibility.member[_e66.first_primitive] = _e922.visibility;
        phi_1192_ = _e922.is_doubted;
        phi_1193_ = _e66.first_primitive;
    } else {
        phi_1192_ = false;
        phi_1193_ = 0u;
    }
    let _e927 = phi_1192_;
    let _e929 = phi_1193_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e927 {
        let _e933 = atomicAdd((&shared_[0u]), 1u);
        phi_1204_ = _e933;
    } else {
        phi_1204_ = 0u;
    }
    let _e935 = phi_1204_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e939 = atomicLoad((&shared_[0u]));
        let _e940 = atomicAdd((&list.member[3u]), _e939);
        atomicStore((&shared_[1u]), _e940);
    }
    workgroupBarrier();
    if _e927 {
        if false {
            phi_1221_ = (_e929 | 2147483648u);
        } else {
            phi_1221_ = _e929;
        }
        let _e944 = phi_1221_;
        let _e946 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e946) + _e935)]), _e944);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
