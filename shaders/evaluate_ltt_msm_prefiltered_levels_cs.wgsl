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
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_174_: lt_bvh_traverse_Tree;
    var phi_175_: bool;
    var phi_180_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_172_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_173_ = false;
        } else {
            phi_172_ = lt_bvh_traverse_Tree();
            phi_173_ = true;
        }
        let _e61 = phi_172_;
        let _e63 = phi_173_;
        phi_174_ = _e61;
        phi_175_ = _e63;
    } else {
        phi_174_ = lt_bvh_traverse_Tree();
        phi_175_ = true;
    }
    let _e65 = phi_174_;
    let _e67 = phi_175_;
    if _e67 {
        phi_180_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_180_ = _e65;
    }
    let _e72 = phi_180_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_229_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_237_: bool;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_263_: bool;
    var phi_264_: f32;
    var phi_265_: bool;
    var phi_303_: vec2<f32>;
    var phi_337_: f32;
    var phi_338_: f32;
    var phi_339_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_374_: f32;
    var phi_375_: f32;
    var phi_376_: f32;
    var phi_377_: f32;

    let _e51 = (*param_4);
    let _e52 = (1f - _e51);
    let _e61 = (0.5f * _e51);
    let _e62 = ((param_5.x * _e52) + _e61);
    let _e63 = ((param_5.y * _e52) + _e61);
    let _e65 = ((param_5.w * _e52) + _e61);
    let _e67 = (_e63 - (_e62 * _e62));
    let _e69 = (((param_5.z * _e52) + _e61) - (_e62 * _e63));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_231_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_6;
            }
            let _e81 = phi_229_;
            phi_230_ = _e81;
        }
        let _e83 = phi_230_;
        phi_231_ = _e83;
    }
    let _e85 = phi_231_;
    if (_e62 == _e65) {
        phi_237_ = (_e62 > 0.5f);
    } else {
        phi_237_ = false;
    }
    let _e89 = phi_237_;
    if _e89 {
        if (_e85 > 0f) {
            if ((bitcast<u32>(_e62) & 2147483647u) > 2139095040u) {
                phi_261_ = _e62;
            } else {
                if (_e62 < 0f) {
                    phi_260_ = 0f;
                } else {
                    if (_e62 > 1f) {
                        phi_259_ = 1f;
                    } else {
                        phi_259_ = _e62;
                    }
                    let _e97 = phi_259_;
                    phi_260_ = _e97;
                }
                let _e99 = phi_260_;
                phi_261_ = _e99;
            }
            let _e101 = phi_261_;
            phi_262_ = _e101;
            phi_263_ = false;
        } else {
            phi_262_ = f32();
            phi_263_ = true;
        }
        let _e103 = phi_262_;
        let _e105 = phi_263_;
        phi_264_ = _e103;
        phi_265_ = _e105;
    } else {
        phi_264_ = f32();
        phi_265_ = true;
    }
    let _e107 = phi_264_;
    let _e109 = phi_265_;
    if _e109 {
        let _e110 = (_e69 / _e67);
        let _e111 = (_e85 - _e62);
        let _e117 = (((((_e85 * _e85) - _e63) - (_e110 * _e111)) * _e67) / (((_e65 - (_e63 * _e63)) * _e67) - (_e69 * _e69)));
        let _e120 = ((_e111 / _e67) - (_e110 * _e117));
        let _e126 = ((0.5f * _e120) / _e117);
        let _e129 = ((_e126 * _e126) - (((1f - (_e120 * _e62)) - (_e117 * _e63)) / _e117));
        if (_e129 >= 0f) {
            let _e131 = sqrt(_e129);
            phi_303_ = vec2<f32>((-(_e126) - _e131), (-(_e126) + _e131));
        } else {
            phi_303_ = vec2(bitcast<f32>((bitcast<u32>(_e129) | 2143289344u)));
        }
        let _e142 = phi_303_;
        if (_e85 <= _e142.x) {
            phi_376_ = 1f;
        } else {
            if (_e85 > _e142.y) {
                let _e155 = (((_e63 - (_e62 * (_e142.x + _e142.y))) + (_e142.x * _e142.y)) / ((_e85 - _e142.x) * (_e85 - _e142.y)));
                if ((bitcast<u32>(_e155) & 2147483647u) > 2139095040u) {
                    phi_339_ = _e155;
                } else {
                    if (_e155 < 0f) {
                        phi_338_ = 0f;
                    } else {
                        if (_e155 > 1f) {
                            phi_337_ = 1f;
                        } else {
                            phi_337_ = _e155;
                        }
                        let _e162 = phi_337_;
                        phi_338_ = _e162;
                    }
                    let _e164 = phi_338_;
                    phi_339_ = _e164;
                }
                let _e166 = phi_339_;
                phi_375_ = _e166;
            } else {
                if (_e85 > _e142.x) {
                    let _e177 = (1f - (((_e63 - (_e62 * (_e85 + _e142.y))) + (_e85 * _e142.y)) / ((_e142.x - _e85) * (_e142.x - _e142.y))));
                    if ((bitcast<u32>(_e177) & 2147483647u) > 2139095040u) {
                        phi_370_ = _e177;
                    } else {
                        if (_e177 < 0f) {
                            phi_369_ = 0f;
                        } else {
                            if (_e177 > 1f) {
                                phi_368_ = 1f;
                            } else {
                                phi_368_ = _e177;
                            }
                            let _e184 = phi_368_;
                            phi_369_ = _e184;
                        }
                        let _e186 = phi_369_;
                        phi_370_ = _e186;
                    }
                    let _e188 = phi_370_;
                    phi_374_ = _e188;
                } else {
                    phi_374_ = bitcast<f32>((bitcast<u32>(_e142.x) | 2143289344u));
                }
                let _e193 = phi_374_;
                phi_375_ = _e193;
            }
            let _e195 = phi_375_;
            phi_376_ = _e195;
        }
        let _e197 = phi_376_;
        phi_377_ = _e197;
    } else {
        phi_377_ = _e107;
    }
    let _e199 = phi_377_;
    return _e199;
}

fn function_() {
    var local_1: f32;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_435_: bool;
    var phi_439_: bool;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_521_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_522_: bool;
    var phi_523_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_524_: bool;
    var phi_531_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_535_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_555_: lt_math_LightPoint;
    var phi_558_: u32;
    var phi_560_: lt_math_LevelPoint;
    var phi_646_: bool;
    var phi_655_: bool;
    var phi_664_: bool;
    var phi_665_: bool;
    var phi_666_: bool;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_674_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_705_: bool;
    var phi_706_: bool;
    var phi_707_: bool;
    var phi_708_: bool;
    var phi_712_: bool;
    var phi_721_: lt_math_LightPoint;
    var phi_722_: u32;
    var phi_723_: lt_math_LevelPoint;
    var phi_724_: bool;
    var phi_556_: lt_math_LightPoint;
    var phi_559_: u32;
    var phi_561_: lt_math_LevelPoint;
    var phi_725_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_772_: bool;
    var phi_854_: f32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_976_: f32;
    var phi_1005_: f32;
    var phi_1010_: f32;
    var phi_1011_: bool;
    var phi_1012_: f32;
    var phi_1013_: bool;
    var phi_1017_: f32;
    var phi_1037_: f32;
    var phi_1042_: f32;
    var phi_1043_: bool;
    var phi_1044_: f32;
    var phi_1045_: bool;
    var phi_1049_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1098_: i32;
    var phi_1103_: i32;
    var phi_1108_: i32;
    var phi_1113_: i32;
    var phi_1122_: i32;
    var phi_1127_: i32;
    var phi_1132_: i32;
    var phi_1137_: i32;
    var phi_1234_: bool;
    var phi_1242_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1259_: f32;
    var phi_1265_: f32;
    var phi_1267_: evaluate_Verdict;
    var phi_1277_: u32;
    var phi_1286_: f32;
    var phi_1288_: evaluate_Verdict;
    var phi_1289_: bool;
    var phi_1290_: evaluate_Verdict;
    var phi_1291_: bool;
    var phi_1296_: evaluate_Verdict;
    var phi_1301_: evaluate_Verdict;
    var phi_1302_: evaluate_Verdict;
    var phi_1306_: bool;
    var phi_1307_: u32;
    var phi_1318_: u32;
    var phi_1335_: u32;

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
                phi_432_ = (_e87 == _e89);
                phi_433_ = false;
            } else {
                phi_432_ = bool();
                phi_433_ = true;
            }
            let _e92 = phi_432_;
            let _e94 = phi_433_;
            phi_434_ = _e92;
            phi_435_ = _e94;
        } else {
            phi_434_ = bool();
            phi_435_ = true;
        }
        let _e96 = phi_434_;
        let _e98 = phi_435_;
        if _e98 {
            phi_439_ = false;
        } else {
            phi_439_ = _e96;
        }
        let _e100 = phi_439_;
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
                    phi_510_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_509_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_509_ = false;
                    }
                    let _e161 = phi_509_;
                    phi_510_ = _e161;
                }
                let _e163 = phi_510_;
                if _e163 {
                    let _e165 = samples.member[_e66.first_primitive].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_521_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_522_ = false;
                } else {
                    phi_521_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_522_ = true;
                }
                let _e184 = phi_521_;
                let _e186 = phi_522_;
                phi_523_ = _e184;
                phi_524_ = _e186;
            } else {
                phi_523_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_524_ = true;
            }
            let _e188 = phi_523_;
            let _e190 = phi_524_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_531_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_531_ = _e188;
            }
            let _e207 = phi_531_;
            phi_535_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_535_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_535_;
        if _e224.unnamed_1 {
            phi_1302_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[_e66.first_primitive].position;
            let _e234 = p.member.map_size;
            let _e236 = (0.5f / f32(_e234));
            let _e243 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e250 = lt_math_LightPoint(vec2<f32>(_e243.uv.x, 0f), _e243.depth, _e243.is_inside);
            let _e254 = lt_math_LightPoint(_e250.uv, 0f, _e250.is_inside);
            phi_555_ = lt_math_LightPoint();
            phi_558_ = 0u;
            phi_560_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e254.uv, _e254.depth, false));
            loop {
                let _e261 = phi_555_;
                let _e263 = phi_558_;
                let _e265 = phi_560_;
                local_2 = _e265;
                local_3 = _e265;
                local_4 = _e265;
                if (_e263 < _e73) {
                    if _e265.point.is_inside {
                        phi_721_ = lt_math_LightPoint();
                        phi_722_ = u32();
                        phi_723_ = lt_math_LevelPoint();
                        phi_724_ = false;
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
                                phi_646_ = (_e301 <= 1f);
                            } else {
                                phi_646_ = false;
                            }
                            let _e333 = phi_646_;
                            if _e333 {
                                if (_e315 >= 0f) {
                                    phi_655_ = (_e315 <= 1f);
                                } else {
                                    phi_655_ = false;
                                }
                                let _e337 = phi_655_;
                                if _e337 {
                                    if (_e328 >= 0f) {
                                        phi_664_ = (_e328 <= 1f);
                                    } else {
                                        phi_664_ = false;
                                    }
                                    let _e341 = phi_664_;
                                    phi_665_ = _e341;
                                    phi_666_ = false;
                                } else {
                                    phi_665_ = bool();
                                    phi_666_ = true;
                                }
                                let _e343 = phi_665_;
                                let _e345 = phi_666_;
                                phi_667_ = _e343;
                                phi_668_ = _e345;
                            } else {
                                phi_667_ = bool();
                                phi_668_ = true;
                            }
                            let _e347 = phi_667_;
                            let _e349 = phi_668_;
                            phi_669_ = _e347;
                            phi_670_ = _e349;
                        } else {
                            phi_669_ = bool();
                            phi_670_ = true;
                        }
                        let _e351 = phi_669_;
                        let _e353 = phi_670_;
                        if _e353 {
                            phi_674_ = false;
                        } else {
                            phi_674_ = _e351;
                        }
                        let _e355 = phi_674_;
                        if _e355 {
                            if (_e301 >= _e236) {
                                if (_e301 <= (1f - _e236)) {
                                    if (_e315 >= _e236) {
                                        phi_701_ = (_e315 <= (1f - _e236));
                                        phi_702_ = false;
                                    } else {
                                        phi_701_ = bool();
                                        phi_702_ = true;
                                    }
                                    let _e363 = phi_701_;
                                    let _e365 = phi_702_;
                                    phi_703_ = _e363;
                                    phi_704_ = _e365;
                                } else {
                                    phi_703_ = bool();
                                    phi_704_ = true;
                                }
                                let _e367 = phi_703_;
                                let _e369 = phi_704_;
                                phi_705_ = _e367;
                                phi_706_ = _e369;
                            } else {
                                phi_705_ = bool();
                                phi_706_ = true;
                            }
                            let _e371 = phi_705_;
                            let _e373 = phi_706_;
                            phi_707_ = _e371;
                            phi_708_ = _e373;
                        } else {
                            phi_707_ = bool();
                            phi_708_ = true;
                        }
                        let _e375 = phi_707_;
                        let _e377 = phi_708_;
                        if _e377 {
                            phi_712_ = false;
                        } else {
                            phi_712_ = _e375;
                        }
                        let _e379 = phi_712_;
                        let _e386 = lt_math_LightPoint(vec2<f32>(_e301, _e261.uv.y), _e261.depth, _e261.is_inside);
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e386.uv.x, _e315), _e386.depth, _e386.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e328, _e393.is_inside);
                        let _e401 = lt_math_LightPoint(_e397.uv, _e397.depth, _e379);
                        phi_721_ = _e401;
                        phi_722_ = (_e263 + 1u);
                        phi_723_ = lt_math_LevelPoint(_e263, _e401);
                        phi_724_ = true;
                    }
                    let _e405 = phi_721_;
                    let _e407 = phi_722_;
                    let _e409 = phi_723_;
                    let _e411 = phi_724_;
                    phi_556_ = _e405;
                    phi_559_ = _e407;
                    phi_561_ = _e409;
                    phi_725_ = _e411;
                } else {
                    phi_556_ = lt_math_LightPoint();
                    phi_559_ = u32();
                    phi_561_ = lt_math_LevelPoint();
                    phi_725_ = false;
                }
                let _e413 = phi_556_;
                let _e415 = phi_559_;
                let _e417 = phi_561_;
                let _e419 = phi_725_;
                continue;
                continuing {
                    phi_555_ = _e413;
                    phi_558_ = _e415;
                    phi_560_ = _e417;
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
                            phi_765_ = (_e433.row_w.z == _e445);
                            phi_766_ = false;
                        } else {
                            phi_765_ = bool();
                            phi_766_ = true;
                        }
                        let _e448 = phi_765_;
                        let _e450 = phi_766_;
                        phi_767_ = _e448;
                        phi_768_ = _e450;
                    } else {
                        phi_767_ = bool();
                        phi_768_ = true;
                    }
                    let _e452 = phi_767_;
                    let _e454 = phi_768_;
                    if _e454 {
                        phi_772_ = false;
                    } else {
                        phi_772_ = _e452;
                    }
                    let _e456 = phi_772_;
                    if _e456 {
                        let _e458 = samples.member[_e66.first_primitive].normal;
                        let _e460 = p.member.map_size;
                        let _e530 = ((abs(((((_e433.row_x.x * _e458.x) + (_e433.row_x.y * _e458.y)) + (_e433.row_x.z * _e458.z)) / (((_e433.row_x.x * _e433.row_x.x) + (_e433.row_x.y * _e433.row_x.y)) + (_e433.row_x.z * _e433.row_x.z)))) + abs(((((_e433.row_y.x * _e458.x) + (_e433.row_y.y * _e458.y)) + (_e433.row_y.z * _e458.z)) / (((_e433.row_y.x * _e433.row_y.x) + (_e433.row_y.y * _e433.row_y.y)) + (_e433.row_y.z * _e433.row_y.z))))) / (abs(((((_e433.row_z.x * _e458.x) + (_e433.row_z.y * _e458.y)) + (_e433.row_z.z * _e458.z)) / (((_e433.row_z.x * _e433.row_z.x) + (_e433.row_z.y * _e433.row_z.y)) + (_e433.row_z.z * _e433.row_z.z)))) * f32(_e460)));
                        if (_e530 < 0.002f) {
                            phi_854_ = _e530;
                        } else {
                            phi_854_ = 0.002f;
                        }
                        let _e533 = phi_854_;
                        phi_973_ = _e533;
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
                            phi_972_ = _e647;
                        } else {
                            phi_972_ = _e649;
                        }
                        let _e652 = phi_972_;
                        phi_973_ = _e652;
                    }
                    let _e654 = phi_973_;
                    phi_976_ = (_e422.point.depth - (0f * _e654));
                } else {
                    phi_976_ = _e422.point.depth;
                }
                let _e658 = phi_976_;
                let _e664 = p.member.map_size;
                let _e665 = f32(_e664);
                let _e668 = ((_e422.point.uv.x * _e665) - 0.5f);
                let _e669 = ((_e422.point.uv.y * _e665) - 0.5f);
                if (_e668 > -8388608f) {
                    let _e681 = f32(select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < bitcast<f32>(3472883712u))), 2147483647i, (_e668 > bitcast<f32>(1325400063u))), (_e668 == _e668)));
                    if (_e681 > _e668) {
                        phi_1005_ = 1f;
                    } else {
                        phi_1005_ = 0f;
                    }
                    let _e684 = phi_1005_;
                    if (_e668 < 8388608f) {
                        phi_1010_ = (_e681 - _e684);
                        phi_1011_ = false;
                    } else {
                        phi_1010_ = f32();
                        phi_1011_ = true;
                    }
                    let _e687 = phi_1010_;
                    let _e689 = phi_1011_;
                    phi_1012_ = _e687;
                    phi_1013_ = _e689;
                } else {
                    phi_1012_ = f32();
                    phi_1013_ = true;
                }
                let _e691 = phi_1012_;
                let _e693 = phi_1013_;
                if _e693 {
                    phi_1017_ = _e668;
                } else {
                    phi_1017_ = _e691;
                }
                let _e695 = phi_1017_;
                if (_e669 > -8388608f) {
                    let _e707 = f32(select(0i, select(select(i32(_e669), i32(-2147483648), (_e669 < bitcast<f32>(3472883712u))), 2147483647i, (_e669 > bitcast<f32>(1325400063u))), (_e669 == _e669)));
                    if (_e707 > _e669) {
                        phi_1037_ = 1f;
                    } else {
                        phi_1037_ = 0f;
                    }
                    let _e710 = phi_1037_;
                    if (_e669 < 8388608f) {
                        phi_1042_ = (_e707 - _e710);
                        phi_1043_ = false;
                    } else {
                        phi_1042_ = f32();
                        phi_1043_ = true;
                    }
                    let _e713 = phi_1042_;
                    let _e715 = phi_1043_;
                    phi_1044_ = _e713;
                    phi_1045_ = _e715;
                } else {
                    phi_1044_ = f32();
                    phi_1045_ = true;
                }
                let _e717 = phi_1044_;
                let _e719 = phi_1045_;
                if _e719 {
                    phi_1049_ = _e669;
                } else {
                    phi_1049_ = _e717;
                }
                let _e721 = phi_1049_;
                let _e722 = (_e668 - _e695);
                let _e723 = (_e669 - _e721);
                let _e732 = select(0i, select(select(i32(_e695), i32(-2147483648), (_e695 < bitcast<f32>(3472883712u))), 2147483647i, (_e695 > bitcast<f32>(1325400063u))), (_e695 == _e695));
                let _e741 = select(0i, select(select(i32(_e721), i32(-2147483648), (_e721 < bitcast<f32>(3472883712u))), 2147483647i, (_e721 > bitcast<f32>(1325400063u))), (_e721 == _e721));
                let _e744 = ((1f - _e722) * (1f - _e723));
                let _e746 = (_e722 * (1f - _e723));
                let _e748 = ((1f - _e722) * _e723);
                let _e749 = (_e722 * _e723);
                let _e751 = p.member.test;
                let _e752 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e751);
                let _e754 = p.member.map_size;
                let _e756 = local_4;
                local_1 = _e752;
                let _e759 = ((_e756.level * _e754) * _e754);
                let _e761 = (bitcast<i32>(_e754) - 1i);
                if (_e732 > 0i) {
                    phi_1098_ = _e732;
                } else {
                    phi_1098_ = 0i;
                }
                let _e764 = phi_1098_;
                if (_e741 > 0i) {
                    phi_1103_ = _e741;
                } else {
                    phi_1103_ = 0i;
                }
                let _e767 = phi_1103_;
                if (_e764 < _e761) {
                    phi_1108_ = _e764;
                } else {
                    phi_1108_ = _e761;
                }
                let _e770 = phi_1108_;
                if (_e767 < _e761) {
                    phi_1113_ = _e767;
                } else {
                    phi_1113_ = _e761;
                }
                let _e773 = phi_1113_;
                let _e774 = bitcast<u32>(_e770);
                let _e776 = (_e732 + 1i);
                let _e777 = (_e741 + 1i);
                if (_e776 > 0i) {
                    phi_1122_ = _e776;
                } else {
                    phi_1122_ = 0i;
                }
                let _e780 = phi_1122_;
                if (_e777 > 0i) {
                    phi_1127_ = _e777;
                } else {
                    phi_1127_ = 0i;
                }
                let _e783 = phi_1127_;
                if (_e780 < _e761) {
                    phi_1132_ = _e780;
                } else {
                    phi_1132_ = _e761;
                }
                let _e786 = phi_1132_;
                if (_e783 < _e761) {
                    phi_1137_ = _e783;
                } else {
                    phi_1137_ = _e761;
                }
                let _e789 = phi_1137_;
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
                let _e863 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e805.x * _e744) + (_e817.x * _e746)) + (_e833.x * _e748)) + (_e849.x * _e749)), ((((_e805.y * _e744) + (_e817.y * _e746)) + (_e833.y * _e748)) + (_e849.y * _e749)), ((((_e805.z * _e744) + (_e817.z * _e746)) + (_e833.z * _e748)) + (_e849.z * _e749)), ((((_e805.w * _e744) + (_e817.w * _e746)) + (_e833.w * _e748)) + (_e849.w * _e749))), _e658);
                let _e867 = p.member.epsilon;
                if (_e863 <= _e867) {
                    phi_1234_ = true;
                } else {
                    phi_1234_ = (_e863 >= (1f - _e867));
                }
                let _e872 = phi_1234_;
                if ((bitcast<u32>(_e863) & 2147483647u) > 2139095040u) {
                    phi_1242_ = true;
                } else {
                    phi_1242_ = !(_e872);
                }
                let _e878 = phi_1242_;
                if _e878 {
                    if (_e863 > 0f) {
                        if (_e863 < 1f) {
                            phi_1254_ = false;
                        } else {
                            phi_1254_ = true;
                        }
                        let _e882 = phi_1254_;
                        phi_1255_ = _e882;
                    } else {
                        phi_1255_ = true;
                    }
                    let _e884 = phi_1255_;
                    if _e884 {
                        phi_1259_ = 0.5f;
                    } else {
                        phi_1259_ = _e863;
                    }
                    let _e886 = phi_1259_;
                    phi_1267_ = evaluate_Verdict(_e886, true);
                } else {
                    if (_e863 > 0.5f) {
                        phi_1265_ = 1f;
                    } else {
                        phi_1265_ = 0f;
                    }
                    let _e890 = phi_1265_;
                    phi_1267_ = evaluate_Verdict(_e890, false);
                }
                let _e893 = phi_1267_;
                let _e896 = (_e893.visibility < 0.5f);
                if _e893.is_doubted {
                    phi_1290_ = evaluate_Verdict();
                    phi_1291_ = true;
                } else {
                    if _e896 {
                        phi_1277_ = 2u;
                    } else {
                        phi_1277_ = 1u;
                    }
                    let _e898 = phi_1277_;
                    if ((0u & _e898) != 0u) {
                        if _e896 {
                            phi_1286_ = 0.000000059604645f;
                        } else {
                            phi_1286_ = 0.99999994f;
                        }
                        let _e902 = phi_1286_;
                        phi_1288_ = evaluate_Verdict(_e902, true);
                        phi_1289_ = false;
                    } else {
                        phi_1288_ = evaluate_Verdict();
                        phi_1289_ = true;
                    }
                    let _e905 = phi_1288_;
                    let _e907 = phi_1289_;
                    phi_1290_ = _e905;
                    phi_1291_ = _e907;
                }
                let _e909 = phi_1290_;
                let _e911 = phi_1291_;
                if _e911 {
                    phi_1296_ = evaluate_Verdict(_e893.visibility, _e893.is_doubted);
                } else {
                    phi_1296_ = _e909;
                }
                let _e914 = phi_1296_;
                phi_1301_ = evaluate_Verdict(_e914.visibility, _e914.is_doubted);
            } else {
                phi_1301_ = evaluate_Verdict(0.5f, true);
            }
            let _e920 = phi_1301_;
            phi_1302_ = _e920;
        }
        let _e922 = phi_1302_;
        visibility.member[_e66.first_primitive] = _e922.visibility;
        phi_1306_ = _e922.is_doubted;
        phi_1307_ = _e66.first_primitive;
    } else {
        phi_1306_ = false;
        phi_1307_ = 0u;
    }
    let _e927 = phi_1306_;
    let _e929 = phi_1307_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e927 {
        let _e933 = atomicAdd((&shared_[0u]), 1u);
        phi_1318_ = _e933;
    } else {
        phi_1318_ = 0u;
    }
    let _e935 = phi_1318_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e939 = atomicLoad((&shared_[0u]));
        let _e940 = atomicAdd((&list.member[3u]), _e939);
        atomicStore((&shared_[1u]), _e940);
    }
    workgroupBarrier();
    if _e927 {
        if false {
            phi_1335_ = (_e929 | 2147483648u);
        } else {
            phi_1335_ = _e929;
        }
        let _e944 = phi_1335_;
        let _e946 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e946) + _e935)]), _e944);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
