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
        let _e52 = phi_141_;
        let _e54 = phi_142_;
        phi_143_ = _e52;
        phi_144_ = _e54;
    } else {
        phi_143_ = lt_bvh_traverse_Tree();
        phi_144_ = true;
    }
    let _e56 = phi_143_;
    let _e58 = phi_144_;
    if _e58 {
        phi_149_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_149_ = _e56;
    }
    let _e63 = phi_149_;
    return lt_bvh_traverse_Tree(_e63.root, _e63.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_295_: bool;
    var phi_299_: f32;
    var phi_311_: bool;
    var phi_318_: f32;
    var phi_333_: f32;
    var phi_334_: f32;
    var phi_335_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_177_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_176_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_175_ = 1f;
            } else {
                phi_175_ = param_7;
            }
            let _e49 = phi_175_;
            phi_176_ = _e49;
        }
        let _e51 = phi_176_;
        phi_177_ = _e51;
    }
    let _e53 = phi_177_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_195_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_194_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_193_ = 1f;
            } else {
                phi_193_ = param_5.x;
            }
            let _e61 = phi_193_;
            phi_194_ = _e61;
        }
        let _e63 = phi_194_;
        phi_195_ = _e63;
    }
    let _e65 = phi_195_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_213_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_212_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_211_ = 1f;
            } else {
                phi_211_ = param_5.y;
            }
            let _e73 = phi_211_;
            phi_212_ = _e73;
        }
        let _e75 = phi_212_;
        phi_213_ = _e75;
    }
    let _e77 = phi_213_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_231_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_230_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_229_ = 1f;
            } else {
                phi_229_ = param_5.z;
            }
            let _e85 = phi_229_;
            phi_230_ = _e85;
        }
        let _e87 = phi_230_;
        phi_231_ = _e87;
    }
    let _e89 = phi_231_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_249_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_248_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_247_ = 1f;
            } else {
                phi_247_ = param_5.w;
            }
            let _e97 = phi_247_;
            phi_248_ = _e97;
        }
        let _e99 = phi_248_;
        phi_249_ = _e99;
    }
    let _e101 = phi_249_;
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
        phi_295_ = true;
    } else {
        let _e140 = (_e106 > _e136);
        if _e140 {
        }
        phi_295_ = _e140;
    }
    let _e142 = phi_295_;
    if _e142 {
        phi_299_ = _e106;
    } else {
        phi_299_ = _e136;
    }
    let _e144 = phi_299_;
    let _e145 = -(_e117);
    if (_e145 <= 0f) {
        let _e149 = ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u);
        if _e149 {
        }
        phi_311_ = _e149;
    } else {
        phi_311_ = true;
    }
    let _e151 = phi_311_;
    if _e151 {
        phi_318_ = (_e144 / (_e144 + (_e145 * _e145)));
    } else {
        phi_318_ = 1f;
    }
    let _e156 = phi_318_;
    if ((bitcast<u32>(_e156) & 2147483647u) > 2139095040u) {
        phi_335_ = _e156;
    } else {
        if (_e156 < 0f) {
            phi_334_ = 0f;
        } else {
            if (_e156 > 1f) {
                phi_333_ = 1f;
            } else {
                phi_333_ = _e156;
            }
            let _e163 = phi_333_;
            phi_334_ = _e163;
        }
        let _e165 = phi_334_;
        phi_335_ = _e165;
    }
    let _e167 = phi_335_;
    return _e167;
}

fn lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(param_8: f32, param_9: f32) -> f32 {
    var phi_343_: f32;

    if (param_8 < param_9) {
        phi_343_ = param_8;
    } else {
        phi_343_ = param_9;
    }
    let _e43 = phi_343_;
    return _e43;
}

fn function_() {
    var local: f32;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_411_: bool;
    var phi_455_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_459_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_479_: lt_math_LightPoint;
    var phi_482_: u32;
    var phi_484_: lt_math_LevelPoint;
    var phi_570_: bool;
    var phi_579_: bool;
    var phi_588_: bool;
    var phi_589_: bool;
    var phi_590_: bool;
    var phi_591_: bool;
    var phi_592_: bool;
    var phi_593_: bool;
    var phi_594_: bool;
    var phi_598_: bool;
    var phi_625_: bool;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_628_: bool;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_631_: bool;
    var phi_632_: bool;
    var phi_636_: bool;
    var phi_645_: lt_math_LightPoint;
    var phi_646_: u32;
    var phi_647_: lt_math_LevelPoint;
    var phi_648_: bool;
    var phi_480_: lt_math_LightPoint;
    var phi_483_: u32;
    var phi_485_: lt_math_LevelPoint;
    var phi_649_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_692_: bool;
    var phi_696_: bool;
    var phi_778_: f32;
    var phi_894_: f32;
    var phi_895_: f32;
    var phi_898_: f32;
    var phi_927_: f32;
    var phi_932_: f32;
    var phi_933_: bool;
    var phi_934_: f32;
    var phi_935_: bool;
    var phi_939_: f32;
    var phi_959_: f32;
    var phi_964_: f32;
    var phi_965_: bool;
    var phi_966_: f32;
    var phi_967_: bool;
    var phi_971_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1020_: i32;
    var phi_1025_: i32;
    var phi_1030_: i32;
    var phi_1035_: i32;
    var phi_1044_: i32;
    var phi_1049_: i32;
    var phi_1054_: i32;
    var phi_1059_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1131_: f32;
    var phi_1133_: evaluate_Verdict;
    var phi_1134_: bool;
    var phi_1135_: evaluate_Verdict;
    var phi_1136_: bool;
    var phi_1141_: evaluate_Verdict;
    var phi_1142_: bool;
    var phi_1144_: evaluate_Verdict;
    var phi_1145_: evaluate_Verdict;
    var phi_1146_: bool;
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
        let _e70 = p.member.light;
        let _e73 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e85 = global[2u];
                phi_404_ = (_e83 == _e85);
                phi_405_ = false;
            } else {
                phi_404_ = bool();
                phi_405_ = true;
            }
            let _e88 = phi_404_;
            let _e90 = phi_405_;
            phi_406_ = _e88;
            phi_407_ = _e90;
        } else {
            phi_406_ = bool();
            phi_407_ = true;
        }
        let _e92 = phi_406_;
        let _e94 = phi_407_;
        if _e94 {
            phi_411_ = false;
        } else {
            phi_411_ = _e92;
        }
        let _e96 = phi_411_;
        if !(_e96) {
            let _e99 = samples.member[(0u + _e59.first_primitive)].normal;
            let _e101 = samples.member[(0u + _e59.first_primitive)].position;
            if ((((_e99.x * (_e70.x - (_e101.x * _e70.w))) + (_e99.y * (_e70.y - (_e101.y * _e70.w)))) + (_e99.z * (_e70.z - (_e101.z * _e70.w)))) > 0f) {
                let _e125 = samples.member[(0u + _e59.first_primitive)].flags;
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e133.unnamed.visibility, false), _e133.unnamed_1);
                phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e139.unnamed, ((_e125 & 1u) == 0u));
            } else {
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e148.unnamed.visibility, false), _e148.unnamed_1);
                phi_455_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e154.unnamed, true);
            }
            let _e159 = phi_455_;
            phi_459_ = _e159;
        } else {
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
            phi_459_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, true);
        }
        let _e176 = phi_459_;
        if _e176.unnamed_1 {
            phi_1150_ = evaluate_Verdict(_e176.unnamed.visibility, _e176.unnamed.is_doubted);
            phi_1151_ = evaluate_Verdict();
            phi_1152_ = true;
        } else {
            let _e184 = samples.member[(0u + _e59.first_primitive)].position;
            let _e186 = p.member.map_size;
            let _e188 = (0.5f / f32(_e186));
            let _e195 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e202 = lt_math_LightPoint(vec2<f32>(_e195.uv.x, 0f), _e195.depth, _e195.is_inside);
            let _e206 = lt_math_LightPoint(_e202.uv, 0f, _e202.is_inside);
            phi_479_ = lt_math_LightPoint();
            phi_482_ = 0u;
            phi_484_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e206.uv, _e206.depth, false));
            loop {
                let _e213 = phi_479_;
                let _e215 = phi_482_;
                let _e217 = phi_484_;
                local_1 = _e217;
                local_2 = _e217;
                local_3 = _e217;
                local_4 = _e217;
                if (_e215 < _e65) {
                    if _e217.point.is_inside {
                        phi_645_ = lt_math_LightPoint();
                        phi_646_ = u32();
                        phi_647_ = lt_math_LevelPoint();
                        phi_648_ = false;
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
                                phi_570_ = (_e253 <= 1f);
                            } else {
                                phi_570_ = false;
                            }
                            let _e285 = phi_570_;
                            if _e285 {
                                if (_e267 >= 0f) {
                                    phi_579_ = (_e267 <= 1f);
                                } else {
                                    phi_579_ = false;
                                }
                                let _e289 = phi_579_;
                                if _e289 {
                                    if (_e280 >= 0f) {
                                        phi_588_ = (_e280 <= 1f);
                                    } else {
                                        phi_588_ = false;
                                    }
                                    let _e293 = phi_588_;
                                    phi_589_ = _e293;
                                    phi_590_ = false;
                                } else {
                                    phi_589_ = bool();
                                    phi_590_ = true;
                                }
                                let _e295 = phi_589_;
                                let _e297 = phi_590_;
                                phi_591_ = _e295;
                                phi_592_ = _e297;
                            } else {
                                phi_591_ = bool();
                                phi_592_ = true;
                            }
                            let _e299 = phi_591_;
                            let _e301 = phi_592_;
                            phi_593_ = _e299;
                            phi_594_ = _e301;
                        } else {
                            phi_593_ = bool();
                            phi_594_ = true;
                        }
                        let _e303 = phi_593_;
                        let _e305 = phi_594_;
                        if _e305 {
                            phi_598_ = false;
                        } else {
                            phi_598_ = _e303;
                        }
                        let _e307 = phi_598_;
                        if _e307 {
                            if (_e253 >= _e188) {
                                if (_e253 <= (1f - _e188)) {
                                    if (_e267 >= _e188) {
                                        phi_625_ = (_e267 <= (1f - _e188));
                                        phi_626_ = false;
                                    } else {
                                        phi_625_ = bool();
                                        phi_626_ = true;
                                    }
                                    let _e315 = phi_625_;
                                    let _e317 = phi_626_;
                                    phi_627_ = _e315;
                                    phi_628_ = _e317;
                                } else {
                                    phi_627_ = bool();
                                    phi_628_ = true;
                                }
                                let _e319 = phi_627_;
                                let _e321 = phi_628_;
                                phi_629_ = _e319;
                                phi_630_ = _e321;
                            } else {
                                phi_629_ = bool();
                                phi_630_ = true;
                            }
                            let _e323 = phi_629_;
                            let _e325 = phi_630_;
                            phi_631_ = _e323;
                            phi_632_ = _e325;
                        } else {
                            phi_631_ = bool();
                            phi_632_ = true;
                        }
                        let _e327 = phi_631_;
                        let _e329 = phi_632_;
                        if _e329 {
                            phi_636_ = false;
                        } else {
                            phi_636_ = _e327;
                        }
                        let _e331 = phi_636_;
                        let _e338 = lt_math_LightPoint(vec2<f32>(_e253, _e213.uv.y), _e213.depth, _e213.is_inside);
                        let _e345 = lt_math_LightPoint(vec2<f32>(_e338.uv.x, _e267), _e338.depth, _e338.is_inside);
                        let _e349 = lt_math_LightPoint(_e345.uv, _e280, _e345.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e349.depth, _e331);
                        phi_645_ = _e353;
                        phi_646_ = (_e215 + 1u);
                        phi_647_ = lt_math_LevelPoint(_e215, _e353);
                        phi_648_ = true;
                    }
                    let _e357 = phi_645_;
                    let _e359 = phi_646_;
                    let _e361 = phi_647_;
                    let _e363 = phi_648_;
                    phi_480_ = _e357;
                    phi_483_ = _e359;
                    phi_485_ = _e361;
                    phi_649_ = _e363;
                } else {
                    phi_480_ = lt_math_LightPoint();
                    phi_483_ = u32();
                    phi_485_ = lt_math_LevelPoint();
                    phi_649_ = false;
                }
                let _e365 = phi_480_;
                let _e367 = phi_483_;
                let _e369 = phi_485_;
                let _e371 = phi_649_;
                continue;
                continuing {
                    phi_479_ = _e365;
                    phi_482_ = _e367;
                    phi_484_ = _e369;
                    break if !(_e371);
                }
            }
            let _e374 = local_1;
            if _e374.point.is_inside {
                if (0f > 0f) {
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
                            phi_689_ = (_e385.row_w.z == _e397);
                            phi_690_ = false;
                        } else {
                            phi_689_ = bool();
                            phi_690_ = true;
                        }
                        let _e400 = phi_689_;
                        let _e402 = phi_690_;
                        phi_691_ = _e400;
                        phi_692_ = _e402;
                    } else {
                        phi_691_ = bool();
                        phi_692_ = true;
                    }
                    let _e404 = phi_691_;
                    let _e406 = phi_692_;
                    if _e406 {
                        phi_696_ = false;
                    } else {
                        phi_696_ = _e404;
                    }
                    let _e408 = phi_696_;
                    if _e408 {
                        let _e410 = samples.member[(0u + _e59.first_primitive)].normal;
                        let _e412 = p.member.map_size;
                        let _e482 = ((abs(((((_e385.row_x.x * _e410.x) + (_e385.row_x.y * _e410.y)) + (_e385.row_x.z * _e410.z)) / (((_e385.row_x.x * _e385.row_x.x) + (_e385.row_x.y * _e385.row_x.y)) + (_e385.row_x.z * _e385.row_x.z)))) + abs(((((_e385.row_y.x * _e410.x) + (_e385.row_y.y * _e410.y)) + (_e385.row_y.z * _e410.z)) / (((_e385.row_y.x * _e385.row_y.x) + (_e385.row_y.y * _e385.row_y.y)) + (_e385.row_y.z * _e385.row_y.z))))) / (abs(((((_e385.row_z.x * _e410.x) + (_e385.row_z.y * _e410.y)) + (_e385.row_z.z * _e410.z)) / (((_e385.row_z.x * _e385.row_z.x) + (_e385.row_z.y * _e385.row_z.y)) + (_e385.row_z.z * _e385.row_z.z)))) * f32(_e412)));
                        if (_e482 < 0.002f) {
                            phi_778_ = _e482;
                        } else {
                            phi_778_ = 0.002f;
                        }
                        let _e485 = phi_778_;
                        phi_895_ = _e485;
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
                            phi_894_ = _e599;
                        } else {
                            phi_894_ = 0.002f;
                        }
                        let _e602 = phi_894_;
                        phi_895_ = _e602;
                    }
                    let _e604 = phi_895_;
                    phi_898_ = (_e374.point.depth - (0f * _e604));
                } else {
                    phi_898_ = _e374.point.depth;
                }
                let _e608 = phi_898_;
                let _e614 = p.member.map_size;
                let _e615 = f32(_e614);
                let _e618 = ((_e374.point.uv.x * _e615) - 0.5f);
                let _e619 = ((_e374.point.uv.y * _e615) - 0.5f);
                if (_e618 > -8388608f) {
                    let _e631 = f32(select(0i, select(select(i32(_e618), i32(-2147483648), (_e618 < bitcast<f32>(3472883712u))), 2147483647i, (_e618 > bitcast<f32>(1325400063u))), (_e618 == _e618)));
                    if (_e631 > _e618) {
                        phi_927_ = 1f;
                    } else {
                        phi_927_ = 0f;
                    }
                    let _e634 = phi_927_;
                    if (_e618 < 8388608f) {
                        phi_932_ = (_e631 - _e634);
                        phi_933_ = false;
                    } else {
                        phi_932_ = f32();
                        phi_933_ = true;
                    }
                    let _e637 = phi_932_;
                    let _e639 = phi_933_;
                    phi_934_ = _e637;
                    phi_935_ = _e639;
                } else {
                    phi_934_ = f32();
                    phi_935_ = true;
                }
                let _e641 = phi_934_;
                let _e643 = phi_935_;
                if _e643 {
                    phi_939_ = _e618;
                } else {
                    phi_939_ = _e641;
                }
                let _e645 = phi_939_;
                if (_e619 > -8388608f) {
                    let _e657 = f32(select(0i, select(select(i32(_e619), i32(-2147483648), (_e619 < bitcast<f32>(3472883712u))), 2147483647i, (_e619 > bitcast<f32>(1325400063u))), (_e619 == _e619)));
                    if (_e657 > _e619) {
                        phi_959_ = 1f;
                    } else {
                        phi_959_ = 0f;
                    }
                    let _e660 = phi_959_;
                    if (_e619 < 8388608f) {
                        phi_964_ = (_e657 - _e660);
                        phi_965_ = false;
                    } else {
                        phi_964_ = f32();
                        phi_965_ = true;
                    }
                    let _e663 = phi_964_;
                    let _e665 = phi_965_;
                    phi_966_ = _e663;
                    phi_967_ = _e665;
                } else {
                    phi_966_ = f32();
                    phi_967_ = true;
                }
                let _e667 = phi_966_;
                let _e669 = phi_967_;
                if _e669 {
                    phi_971_ = _e619;
                } else {
                    phi_971_ = _e667;
                }
                let _e671 = phi_971_;
                let _e672 = (_e618 - _e645);
                let _e673 = (_e619 - _e671);
                let _e682 = select(0i, select(select(i32(_e645), i32(-2147483648), (_e645 < bitcast<f32>(3472883712u))), 2147483647i, (_e645 > bitcast<f32>(1325400063u))), (_e645 == _e645));
                let _e691 = select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671));
                let _e702 = p.member.test;
                let _e703 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e702);
                let _e705 = p.member.map_size;
                let _e707 = local_3;
                local = _e703;
                let _e710 = ((_e707.level * _e705) * _e705);
                let _e712 = (bitcast<i32>(_e705) - 1i);
                if (_e682 > 0i) {
                    phi_1020_ = _e682;
                } else {
                    phi_1020_ = 0i;
                }
                let _e715 = phi_1020_;
                if (_e691 > 0i) {
                    phi_1025_ = _e691;
                } else {
                    phi_1025_ = 0i;
                }
                let _e718 = phi_1025_;
                if (_e715 < _e712) {
                    phi_1030_ = _e715;
                } else {
                    phi_1030_ = _e712;
                }
                let _e721 = phi_1030_;
                if (_e718 < _e712) {
                    phi_1035_ = _e718;
                } else {
                    phi_1035_ = _e712;
                }
                let _e724 = phi_1035_;
                let _e725 = bitcast<u32>(_e721);
                let _e727 = (_e682 + 1i);
                let _e728 = (_e691 + 1i);
                if (_e727 > 0i) {
                    phi_1044_ = _e727;
                } else {
                    phi_1044_ = 0i;
                }
                let _e731 = phi_1044_;
                if (_e728 > 0i) {
                    phi_1049_ = _e728;
                } else {
                    phi_1049_ = 0i;
                }
                let _e734 = phi_1049_;
                if (_e731 < _e712) {
                    phi_1054_ = _e731;
                } else {
                    phi_1054_ = _e712;
                }
                let _e737 = phi_1054_;
                if (_e734 < _e712) {
                    phi_1059_ = _e734;
                } else {
                    phi_1059_ = _e712;
                }
                let _e740 = phi_1059_;
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
                let _e770 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e756, _e760, _e764, _e768), vec4<f32>(((1f - _e672) * (1f - _e673)), (_e672 * (1f - _e673)), ((1f - _e672) * _e673), (_e672 * _e673)), _e608);
                let _e772 = p.member.fade_uv;
                if (_e772 > 0f) {
                    let _e775 = local_4;
                    if ((_e775.level + 1u) == _e65) {
                        let _e784 = p.member.fade_uv;
                        let _e786 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e374.point.uv.x, (1f - _e374.point.uv.x));
                        let _e788 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e374.point.uv.y, (1f - _e374.point.uv.y));
                        let _e789 = lt_shaders_evaluate_faded_u007b_closure_u0023_0_u007d(_e786, _e788);
                        if (_e789 < _e784) {
                            phi_1131_ = (1f - ((1f - _e770) * (_e789 / _e784)));
                        } else {
                            phi_1131_ = _e770;
                        }
                        let _e796 = phi_1131_;
                        phi_1133_ = evaluate_Verdict(_e796, false);
                        phi_1134_ = false;
                    } else {
                        phi_1133_ = evaluate_Verdict();
                        phi_1134_ = true;
                    }
                    let _e799 = phi_1133_;
                    let _e801 = phi_1134_;
                    phi_1135_ = _e799;
                    phi_1136_ = _e801;
                } else {
                    phi_1135_ = evaluate_Verdict();
                    phi_1136_ = true;
                }
                let _e803 = phi_1135_;
                let _e805 = phi_1136_;
                if _e805 {
                    phi_1141_ = evaluate_Verdict(_e770, false);
                    phi_1142_ = false;
                } else {
                    phi_1141_ = evaluate_Verdict();
                    phi_1142_ = true;
                }
                let _e808 = phi_1141_;
                let _e810 = phi_1142_;
                phi_1144_ = _e808;
                phi_1145_ = _e803;
                phi_1146_ = _e810;
            } else {
                phi_1144_ = evaluate_Verdict();
                phi_1145_ = evaluate_Verdict(1f, false);
                phi_1146_ = true;
            }
            let _e813 = phi_1144_;
            let _e815 = phi_1145_;
            let _e817 = phi_1146_;
            if _e817 {
            }
            phi_1150_ = _e815;
            phi_1151_ = _e813;
            phi_1152_ = _e817;
        }
        let _e819 = phi_1150_;
        let _e821 = phi_1151_;
        let _e823 = phi_1152_;
        if _e823 {
            phi_1156_ = _e819;
        } else {
            phi_1156_ = _e821;
        }
        let _e825 = phi_1156_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e825.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
