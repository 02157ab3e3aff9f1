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
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(5) 
var<storage> levels: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e56 = phi_160_;
        let _e58 = phi_161_;
        phi_162_ = _e56;
        phi_163_ = _e58;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e60 = phi_162_;
    let _e62 = phi_163_;
    if _e62 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e60;
    }
    let _e67 = phi_168_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_266_: f32;
    var phi_267_: f32;
    var phi_268_: f32;
    var phi_314_: bool;
    var phi_318_: f32;
    var phi_330_: bool;
    var phi_337_: f32;
    var phi_352_: f32;
    var phi_353_: f32;
    var phi_354_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_196_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_195_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_194_ = 1f;
            } else {
                phi_194_ = param_7;
            }
            let _e53 = phi_194_;
            phi_195_ = _e53;
        }
        let _e55 = phi_195_;
        phi_196_ = _e55;
    }
    let _e57 = phi_196_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_214_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_213_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_212_ = 1f;
            } else {
                phi_212_ = param_5.x;
            }
            let _e65 = phi_212_;
            phi_213_ = _e65;
        }
        let _e67 = phi_213_;
        phi_214_ = _e67;
    }
    let _e69 = phi_214_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_232_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_231_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_230_ = 1f;
            } else {
                phi_230_ = param_5.y;
            }
            let _e77 = phi_230_;
            phi_231_ = _e77;
        }
        let _e79 = phi_231_;
        phi_232_ = _e79;
    }
    let _e81 = phi_232_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_250_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_249_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = param_5.z;
            }
            let _e89 = phi_248_;
            phi_249_ = _e89;
        }
        let _e91 = phi_249_;
        phi_250_ = _e91;
    }
    let _e93 = phi_250_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_268_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_267_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_266_ = 1f;
            } else {
                phi_266_ = param_5.w;
            }
            let _e101 = phi_266_;
            phi_267_ = _e101;
        }
        let _e103 = phi_267_;
        phi_268_ = _e103;
    }
    let _e105 = phi_268_;
    let _e106 = (_e69 - _e57);
    let _e107 = (_e81 - _e57);
    let _e108 = (_e93 - _e57);
    let _e109 = (_e105 - _e57);
    let _e110 = (*param_4);
    let _e121 = ((((_e106 * param_6.x) + (_e107 * param_6.y)) + (_e108 * param_6.z)) + (_e109 * param_6.w));
    let _e122 = (_e106 - _e121);
    let _e123 = (_e107 - _e121);
    let _e124 = (_e108 - _e121);
    let _e125 = (_e109 - _e121);
    let _e140 = (((((_e122 * _e122) * param_6.x) + ((_e123 * _e123) * param_6.y)) + ((_e124 * _e124) * param_6.z)) + ((_e125 * _e125) * param_6.w));
    if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
        phi_314_ = true;
    } else {
        let _e144 = (_e110 > _e140);
        if _e144 {
        }
        phi_314_ = _e144;
    }
    let _e146 = phi_314_;
    if _e146 {
        phi_318_ = _e110;
    } else {
        phi_318_ = _e140;
    }
    let _e148 = phi_318_;
    let _e149 = -(_e121);
    if (_e149 <= 0f) {
        let _e153 = ((bitcast<u32>(_e148) & 2147483647u) > 2139095040u);
        if _e153 {
        }
        phi_330_ = _e153;
    } else {
        phi_330_ = true;
    }
    let _e155 = phi_330_;
    if _e155 {
        phi_337_ = (_e148 / (_e148 + (_e149 * _e149)));
    } else {
        phi_337_ = 1f;
    }
    let _e160 = phi_337_;
    if ((bitcast<u32>(_e160) & 2147483647u) > 2139095040u) {
        phi_354_ = _e160;
    } else {
        if (_e160 < 0f) {
            phi_353_ = 0f;
        } else {
            if (_e160 > 1f) {
                phi_352_ = 1f;
            } else {
                phi_352_ = _e160;
            }
            let _e167 = phi_352_;
            phi_353_ = _e167;
        }
        let _e169 = phi_353_;
        phi_354_ = _e169;
    }
    let _e171 = phi_354_;
    return _e171;
}

fn function_() {
    var local_1: f32;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_416_: bool;
    var phi_486_: bool;
    var phi_487_: bool;
    var phi_498_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_499_: bool;
    var phi_500_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_501_: bool;
    var phi_508_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_512_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_532_: lt_math_LightPoint;
    var phi_535_: u32;
    var phi_537_: lt_math_LevelPoint;
    var phi_623_: bool;
    var phi_632_: bool;
    var phi_641_: bool;
    var phi_642_: bool;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_651_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_680_: bool;
    var phi_681_: bool;
    var phi_682_: bool;
    var phi_683_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_689_: bool;
    var phi_698_: lt_math_LightPoint;
    var phi_699_: u32;
    var phi_700_: lt_math_LevelPoint;
    var phi_701_: bool;
    var phi_533_: lt_math_LightPoint;
    var phi_536_: u32;
    var phi_538_: lt_math_LevelPoint;
    var phi_702_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_749_: bool;
    var phi_831_: f32;
    var phi_949_: f32;
    var phi_950_: f32;
    var phi_953_: f32;
    var phi_982_: f32;
    var phi_987_: f32;
    var phi_988_: bool;
    var phi_989_: f32;
    var phi_990_: bool;
    var phi_994_: f32;
    var phi_1014_: f32;
    var phi_1019_: f32;
    var phi_1020_: bool;
    var phi_1021_: f32;
    var phi_1022_: bool;
    var phi_1026_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1075_: i32;
    var phi_1080_: i32;
    var phi_1085_: i32;
    var phi_1090_: i32;
    var phi_1099_: i32;
    var phi_1104_: i32;
    var phi_1109_: i32;
    var phi_1114_: i32;
    var phi_1165_: bool;
    var phi_1173_: bool;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1190_: f32;
    var phi_1196_: f32;
    var phi_1198_: evaluate_Verdict;
    var phi_1203_: evaluate_Verdict;
    var phi_1204_: evaluate_Verdict;
    var phi_1208_: bool;
    var phi_1209_: u32;
    var phi_1220_: u32;

    let _e44 = id_1;
    let _e45 = local_5;
    let _e50 = arrayLength((&map.member));
    let _e55 = arrayLength((&levels.member));
    let _e58 = p.member.size[0u];
    let _e60 = p.member.size[1u];
    let _e61 = lt_shaders_entry_pixel_index(_e44, _e58, _e60);
    if (bitcast<i32>(_e61.root) != 0i) {
        let _e68 = p.member.level_count;
        let _e72 = samples.member[_e61.first_primitive].normal[0u];
        let _e74 = global[0u];
        if (_e72 == _e74) {
            let _e77 = samples.member[_e61.first_primitive].normal[1u];
            let _e79 = global[1u];
            if (_e77 == _e79) {
                let _e82 = samples.member[_e61.first_primitive].normal[2u];
                let _e84 = global[2u];
                phi_409_ = (_e82 == _e84);
                phi_410_ = false;
            } else {
                phi_409_ = bool();
                phi_410_ = true;
            }
            let _e87 = phi_409_;
            let _e89 = phi_410_;
            phi_411_ = _e87;
            phi_412_ = _e89;
        } else {
            phi_411_ = bool();
            phi_412_ = true;
        }
        let _e91 = phi_411_;
        let _e93 = phi_412_;
        if _e93 {
            phi_416_ = false;
        } else {
            phi_416_ = _e91;
        }
        let _e95 = phi_416_;
        if !(_e95) {
            let _e98 = samples.member[_e61.first_primitive].position;
            let _e100 = p.member.light.place;
            let _e106 = p.member.light.place[3u];
            let _e113 = (_e100.x - (_e98.x * _e106));
            let _e114 = (_e100.y - (_e98.y * _e106));
            let _e115 = (_e100.z - (_e98.z * _e106));
            let _e117 = samples.member[_e61.first_primitive].normal;
            if ((((_e117.x * _e113) + (_e117.y * _e114)) + (_e117.z * _e115)) > 0f) {
                let _e131 = (((_e113 * _e113) + (_e114 * _e114)) + (_e115 * _e115));
                let _e133 = p.member.light.axis;
                let _e145 = p.member.light.place[3u];
                if (_e145 == 0f) {
                    phi_487_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_486_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_486_ = false;
                    }
                    let _e156 = phi_486_;
                    phi_487_ = _e156;
                }
                let _e158 = phi_487_;
                if _e158 {
                    let _e160 = samples.member[_e61.first_primitive].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_498_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_499_ = false;
                } else {
                    phi_498_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_499_ = true;
                }
                let _e179 = phi_498_;
                let _e181 = phi_499_;
                phi_500_ = _e179;
                phi_501_ = _e181;
            } else {
                phi_500_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_501_ = true;
            }
            let _e183 = phi_500_;
            let _e185 = phi_501_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_508_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_508_ = _e183;
            }
            let _e202 = phi_508_;
            phi_512_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_512_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_512_;
        if _e219.unnamed_1 {
            phi_1204_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
        } else {
            let _e227 = samples.member[_e61.first_primitive].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_532_ = lt_math_LightPoint();
            phi_535_ = 0u;
            phi_537_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_532_;
                let _e258 = phi_535_;
                let _e260 = phi_537_;
                local_2 = _e260;
                local_3 = _e260;
                local_4 = _e260;
                if (_e258 < _e68) {
                    if _e260.point.is_inside {
                        phi_698_ = lt_math_LightPoint();
                        phi_699_ = u32();
                        phi_700_ = lt_math_LevelPoint();
                        phi_701_ = false;
                    } else {
                        if (_e258 < _e55) {
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
                                phi_623_ = (_e296 <= 1f);
                            } else {
                                phi_623_ = false;
                            }
                            let _e328 = phi_623_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_632_ = (_e310 <= 1f);
                                } else {
                                    phi_632_ = false;
                                }
                                let _e332 = phi_632_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_641_ = (_e323 <= 1f);
                                    } else {
                                        phi_641_ = false;
                                    }
                                    let _e336 = phi_641_;
                                    phi_642_ = _e336;
                                    phi_643_ = false;
                                } else {
                                    phi_642_ = bool();
                                    phi_643_ = true;
                                }
                                let _e338 = phi_642_;
                                let _e340 = phi_643_;
                                phi_644_ = _e338;
                                phi_645_ = _e340;
                            } else {
                                phi_644_ = bool();
                                phi_645_ = true;
                            }
                            let _e342 = phi_644_;
                            let _e344 = phi_645_;
                            phi_646_ = _e342;
                            phi_647_ = _e344;
                        } else {
                            phi_646_ = bool();
                            phi_647_ = true;
                        }
                        let _e346 = phi_646_;
                        let _e348 = phi_647_;
                        if _e348 {
                            phi_651_ = false;
                        } else {
                            phi_651_ = _e346;
                        }
                        let _e350 = phi_651_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_678_ = (_e310 <= (1f - _e231));
                                        phi_679_ = false;
                                    } else {
                                        phi_678_ = bool();
                                        phi_679_ = true;
                                    }
                                    let _e358 = phi_678_;
                                    let _e360 = phi_679_;
                                    phi_680_ = _e358;
                                    phi_681_ = _e360;
                                } else {
                                    phi_680_ = bool();
                                    phi_681_ = true;
                                }
                                let _e362 = phi_680_;
                                let _e364 = phi_681_;
                                phi_682_ = _e362;
                                phi_683_ = _e364;
                            } else {
                                phi_682_ = bool();
                                phi_683_ = true;
                            }
                            let _e366 = phi_682_;
                            let _e368 = phi_683_;
                            phi_684_ = _e366;
                            phi_685_ = _e368;
                        } else {
                            phi_684_ = bool();
                            phi_685_ = true;
                        }
                        let _e370 = phi_684_;
                        let _e372 = phi_685_;
                        if _e372 {
                            phi_689_ = false;
                        } else {
                            phi_689_ = _e370;
                        }
                        let _e374 = phi_689_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_698_ = _e396;
                        phi_699_ = (_e258 + 1u);
                        phi_700_ = lt_math_LevelPoint(_e258, _e396);
                        phi_701_ = true;
                    }
                    let _e400 = phi_698_;
                    let _e402 = phi_699_;
                    let _e404 = phi_700_;
                    let _e406 = phi_701_;
                    phi_533_ = _e400;
                    phi_536_ = _e402;
                    phi_538_ = _e404;
                    phi_702_ = _e406;
                } else {
                    phi_533_ = lt_math_LightPoint();
                    phi_536_ = u32();
                    phi_538_ = lt_math_LevelPoint();
                    phi_702_ = false;
                }
                let _e408 = phi_533_;
                let _e410 = phi_536_;
                let _e412 = phi_538_;
                let _e414 = phi_702_;
                continue;
                continuing {
                    phi_532_ = _e408;
                    phi_535_ = _e410;
                    phi_537_ = _e412;
                    break if !(_e414);
                }
            }
            let _e417 = local_2;
            if _e417.point.is_inside {
                if (0f > 0f) {
                    let _e423 = local_3;
                    if (_e423.level < _e55) {
                    } else {
                        return;
                    }
                    let _e428 = levels.member[(0u + _e423.level)];
                    let _e434 = global[0u];
                    if (_e428.row_w.x == _e434) {
                        let _e437 = global[1u];
                        if (_e428.row_w.y == _e437) {
                            let _e440 = global[2u];
                            phi_742_ = (_e428.row_w.z == _e440);
                            phi_743_ = false;
                        } else {
                            phi_742_ = bool();
                            phi_743_ = true;
                        }
                        let _e443 = phi_742_;
                        let _e445 = phi_743_;
                        phi_744_ = _e443;
                        phi_745_ = _e445;
                    } else {
                        phi_744_ = bool();
                        phi_745_ = true;
                    }
                    let _e447 = phi_744_;
                    let _e449 = phi_745_;
                    if _e449 {
                        phi_749_ = false;
                    } else {
                        phi_749_ = _e447;
                    }
                    let _e451 = phi_749_;
                    if _e451 {
                        let _e453 = samples.member[_e61.first_primitive].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_831_ = _e525;
                        } else {
                            phi_831_ = 0.002f;
                        }
                        let _e528 = phi_831_;
                        phi_950_ = _e528;
                    } else {
                        let _e530 = p.member.map_size;
                        let _e536 = samples.member[_e61.first_primitive].position;
                        let _e547 = ((((_e428.row_w.x * _e536.x) + (_e428.row_w.y * _e536.y)) + (_e428.row_w.z * _e536.z)) + _e428.row_w.w);
                        let _e560 = ((_e428.row_x.x - (_e428.row_w.x * _e417.point.uv.x)) / _e547);
                        let _e561 = ((_e428.row_x.y - (_e428.row_w.y * _e417.point.uv.x)) / _e547);
                        let _e562 = ((_e428.row_x.z - (_e428.row_w.z * _e417.point.uv.x)) / _e547);
                        let _e575 = ((_e428.row_y.x - (_e428.row_w.x * _e417.point.uv.y)) / _e547);
                        let _e576 = ((_e428.row_y.y - (_e428.row_w.y * _e417.point.uv.y)) / _e547);
                        let _e577 = ((_e428.row_y.z - (_e428.row_w.z * _e417.point.uv.y)) / _e547);
                        let _e583 = samples.member[_e61.first_primitive].normal;
                        let _e588 = ((_e576 * _e583.z) - (_e583.y * _e577));
                        let _e593 = ((_e577 * _e583.x) - (_e583.z * _e575));
                        let _e598 = ((_e575 * _e583.y) - (_e583.x * _e576));
                        let _e600 = samples.member[_e61.first_primitive].normal;
                        let _e605 = ((_e561 * _e600.z) - (_e600.y * _e562));
                        let _e610 = ((_e562 * _e600.x) - (_e600.z * _e560));
                        let _e615 = ((_e560 * _e600.y) - (_e600.x * _e561));
                        let _e642 = ((abs(((((_e428.row_z.x * _e588) + (_e428.row_z.y * _e593)) + (_e428.row_z.z * _e598)) / (((_e560 * _e588) + (_e561 * _e593)) + (_e562 * _e598)))) + abs(((((_e428.row_z.x * _e605) + (_e428.row_z.y * _e610)) + (_e428.row_z.z * _e615)) / (((_e575 * _e605) + (_e576 * _e610)) + (_e577 * _e615))))) / f32(_e530));
                        let _e644 = (16f / f32(_e530));
                        if (_e642 < _e644) {
                            phi_949_ = _e642;
                        } else {
                            phi_949_ = _e644;
                        }
                        let _e647 = phi_949_;
                        phi_950_ = _e647;
                    }
                    let _e649 = phi_950_;
                    phi_953_ = (_e417.point.depth - (0f * _e649));
                } else {
                    phi_953_ = _e417.point.depth;
                }
                let _e653 = phi_953_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e417.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e417.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_982_ = 1f;
                    } else {
                        phi_982_ = 0f;
                    }
                    let _e679 = phi_982_;
                    if (_e663 < 8388608f) {
                        phi_987_ = (_e676 - _e679);
                        phi_988_ = false;
                    } else {
                        phi_987_ = f32();
                        phi_988_ = true;
                    }
                    let _e682 = phi_987_;
                    let _e684 = phi_988_;
                    phi_989_ = _e682;
                    phi_990_ = _e684;
                } else {
                    phi_989_ = f32();
                    phi_990_ = true;
                }
                let _e686 = phi_989_;
                let _e688 = phi_990_;
                if _e688 {
                    phi_994_ = _e663;
                } else {
                    phi_994_ = _e686;
                }
                let _e690 = phi_994_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1014_ = 1f;
                    } else {
                        phi_1014_ = 0f;
                    }
                    let _e705 = phi_1014_;
                    if (_e664 < 8388608f) {
                        phi_1019_ = (_e702 - _e705);
                        phi_1020_ = false;
                    } else {
                        phi_1019_ = f32();
                        phi_1020_ = true;
                    }
                    let _e708 = phi_1019_;
                    let _e710 = phi_1020_;
                    phi_1021_ = _e708;
                    phi_1022_ = _e710;
                } else {
                    phi_1021_ = f32();
                    phi_1022_ = true;
                }
                let _e712 = phi_1021_;
                let _e714 = phi_1022_;
                if _e714 {
                    phi_1026_ = _e664;
                } else {
                    phi_1026_ = _e712;
                }
                let _e716 = phi_1026_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e747 = p.member.test;
                let _e748 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_4;
                local_1 = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e727 > 0i) {
                    phi_1075_ = _e727;
                } else {
                    phi_1075_ = 0i;
                }
                let _e760 = phi_1075_;
                if (_e736 > 0i) {
                    phi_1080_ = _e736;
                } else {
                    phi_1080_ = 0i;
                }
                let _e763 = phi_1080_;
                if (_e760 < _e757) {
                    phi_1085_ = _e760;
                } else {
                    phi_1085_ = _e757;
                }
                let _e766 = phi_1085_;
                if (_e763 < _e757) {
                    phi_1090_ = _e763;
                } else {
                    phi_1090_ = _e757;
                }
                let _e769 = phi_1090_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1099_ = _e772;
                } else {
                    phi_1099_ = 0i;
                }
                let _e776 = phi_1099_;
                if (_e773 > 0i) {
                    phi_1104_ = _e773;
                } else {
                    phi_1104_ = 0i;
                }
                let _e779 = phi_1104_;
                if (_e776 < _e757) {
                    phi_1109_ = _e776;
                } else {
                    phi_1109_ = _e757;
                }
                let _e782 = phi_1109_;
                if (_e779 < _e757) {
                    phi_1114_ = _e779;
                } else {
                    phi_1114_ = _e757;
                }
                let _e785 = phi_1114_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e50) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e50) {
                } else {
                    return;
                }
                let _e805 = map.member[(0u + _e795)];
                if (_e796 < _e50) {
                } else {
                    return;
                }
                let _e809 = map.member[(0u + _e796)];
                if (_e797 < _e50) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e797)];
                let _e815 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e801, _e805, _e809, _e813), vec4<f32>(((1f - _e717) * (1f - _e718)), (_e717 * (1f - _e718)), ((1f - _e717) * _e718), (_e717 * _e718)), _e653);
                let _e817 = p.member.epsilon;
                if (_e815 <= _e817) {
                    phi_1165_ = true;
                } else {
                    phi_1165_ = (_e815 >= (1f - _e817));
                }
                let _e822 = phi_1165_;
                if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                    phi_1173_ = true;
                } else {
                    phi_1173_ = !(_e822);
                }
                let _e828 = phi_1173_;
                if _e828 {
                    if (_e815 > 0f) {
                        if (_e815 < 1f) {
                            phi_1185_ = false;
                        } else {
                            phi_1185_ = true;
                        }
                        let _e832 = phi_1185_;
                        phi_1186_ = _e832;
                    } else {
                        phi_1186_ = true;
                    }
                    let _e834 = phi_1186_;
                    if _e834 {
                        phi_1190_ = 0.5f;
                    } else {
                        phi_1190_ = _e815;
                    }
                    let _e836 = phi_1190_;
                    phi_1198_ = evaluate_Verdict(_e836, true);
                } else {
                    if (_e815 > 0.5f) {
                        phi_1196_ = 1f;
                    } else {
                        phi_1196_ = 0f;
                    }
                    let _e840 = phi_1196_;
                    phi_1198_ = evaluate_Verdict(_e840, false);
                }
                let _e843 = phi_1198_;
                phi_1203_ = evaluate_Verdict(_e843.visibility, _e843.is_doubted);
            } else {
                phi_1203_ = evaluate_Verdict(0.5f, true);
            }
            let _e849 = phi_1203_;
            phi_1204_ = _e849;
        }
        let _e851 = phi_1204_;
        visibility.member[_e61.first_primitive] = _e851.visibility;
        phi_1208_ = _e851.is_doubted;
        phi_1209_ = _e61.first_primitive;
    } else {
        phi_1208_ = false;
        phi_1209_ = 0u;
    }
    let _e856 = phi_1208_;
    let _e858 = phi_1209_;
    if (_e45 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e856 {
        let _e862 = atomicAdd((&shared_[0u]), 1u);
        phi_1220_ = _e862;
    } else {
        phi_1220_ = 0u;
    }
    let _e864 = phi_1220_;
    workgroupBarrier();
    if (_e45 == 0u) {
        let _e868 = atomicLoad((&shared_[0u]));
        let _e869 = atomicAdd((&list.member[3u]), _e868);
        atomicStore((&shared_[1u]), _e869);
    }
    workgroupBarrier();
    if _e856 {
        let _e872 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e872) + _e864)]), _e858);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
