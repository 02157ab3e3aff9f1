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

struct type_43 {
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
var<storage> levels: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_174_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_166_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_167_ = false;
        } else {
            phi_166_ = lt_bvh_traverse_Tree();
            phi_167_ = true;
        }
        let _e60 = phi_166_;
        let _e62 = phi_167_;
        phi_168_ = _e60;
        phi_169_ = _e62;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e64 = phi_168_;
    let _e66 = phi_169_;
    if _e66 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e64;
    }
    let _e71 = phi_174_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_320_: bool;
    var phi_324_: f32;
    var phi_336_: bool;
    var phi_343_: f32;
    var phi_358_: f32;
    var phi_359_: f32;
    var phi_360_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_202_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_7;
            }
            let _e57 = phi_200_;
            phi_201_ = _e57;
        }
        let _e59 = phi_201_;
        phi_202_ = _e59;
    }
    let _e61 = phi_202_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_220_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_5.x;
            }
            let _e69 = phi_218_;
            phi_219_ = _e69;
        }
        let _e71 = phi_219_;
        phi_220_ = _e71;
    }
    let _e73 = phi_220_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_238_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_5.y;
            }
            let _e81 = phi_236_;
            phi_237_ = _e81;
        }
        let _e83 = phi_237_;
        phi_238_ = _e83;
    }
    let _e85 = phi_238_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_256_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_5.z;
            }
            let _e93 = phi_254_;
            phi_255_ = _e93;
        }
        let _e95 = phi_255_;
        phi_256_ = _e95;
    }
    let _e97 = phi_256_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_274_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_273_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_272_ = 1f;
            } else {
                phi_272_ = param_5.w;
            }
            let _e105 = phi_272_;
            phi_273_ = _e105;
        }
        let _e107 = phi_273_;
        phi_274_ = _e107;
    }
    let _e109 = phi_274_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    let _e114 = (*param_4);
    let _e125 = ((((_e110 * param_6.x) + (_e111 * param_6.y)) + (_e112 * param_6.z)) + (_e113 * param_6.w));
    let _e126 = (_e110 - _e125);
    let _e127 = (_e111 - _e125);
    let _e128 = (_e112 - _e125);
    let _e129 = (_e113 - _e125);
    let _e144 = (((((_e126 * _e126) * param_6.x) + ((_e127 * _e127) * param_6.y)) + ((_e128 * _e128) * param_6.z)) + ((_e129 * _e129) * param_6.w));
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_320_ = true;
    } else {
        let _e148 = (_e114 > _e144);
        if _e148 {
        }
        phi_320_ = _e148;
    }
    let _e150 = phi_320_;
    if _e150 {
        phi_324_ = _e114;
    } else {
        phi_324_ = _e144;
    }
    let _e152 = phi_324_;
    let _e153 = -(_e125);
    if (_e153 <= 0f) {
        let _e157 = ((bitcast<u32>(_e152) & 2147483647u) > 2139095040u);
        if _e157 {
        }
        phi_336_ = _e157;
    } else {
        phi_336_ = true;
    }
    let _e159 = phi_336_;
    if _e159 {
        phi_343_ = (_e152 / (_e152 + (_e153 * _e153)));
    } else {
        phi_343_ = 1f;
    }
    let _e164 = phi_343_;
    if ((bitcast<u32>(_e164) & 2147483647u) > 2139095040u) {
        phi_360_ = _e164;
    } else {
        if (_e164 < 0f) {
            phi_359_ = 0f;
        } else {
            if (_e164 > 1f) {
                phi_358_ = 1f;
            } else {
                phi_358_ = _e164;
            }
            let _e171 = phi_358_;
            phi_359_ = _e171;
        }
        let _e173 = phi_359_;
        phi_360_ = _e173;
    }
    let _e175 = phi_360_;
    return _e175;
}

fn function_() {
    var local_1: f32;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_422_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_504_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_505_: bool;
    var phi_506_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_507_: bool;
    var phi_514_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_518_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_538_: lt_math_LightPoint;
    var phi_541_: u32;
    var phi_543_: lt_math_LevelPoint;
    var phi_629_: bool;
    var phi_638_: bool;
    var phi_647_: bool;
    var phi_648_: bool;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_657_: bool;
    var phi_684_: bool;
    var phi_685_: bool;
    var phi_686_: bool;
    var phi_687_: bool;
    var phi_688_: bool;
    var phi_689_: bool;
    var phi_690_: bool;
    var phi_691_: bool;
    var phi_695_: bool;
    var phi_704_: lt_math_LightPoint;
    var phi_705_: u32;
    var phi_706_: lt_math_LevelPoint;
    var phi_707_: bool;
    var phi_539_: lt_math_LightPoint;
    var phi_542_: u32;
    var phi_544_: lt_math_LevelPoint;
    var phi_708_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_837_: f32;
    var phi_955_: f32;
    var phi_956_: f32;
    var phi_959_: f32;
    var phi_988_: f32;
    var phi_993_: f32;
    var phi_994_: bool;
    var phi_995_: f32;
    var phi_996_: bool;
    var phi_1000_: f32;
    var phi_1020_: f32;
    var phi_1025_: f32;
    var phi_1026_: bool;
    var phi_1027_: f32;
    var phi_1028_: bool;
    var phi_1032_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1081_: i32;
    var phi_1086_: i32;
    var phi_1091_: i32;
    var phi_1096_: i32;
    var phi_1105_: i32;
    var phi_1110_: i32;
    var phi_1115_: i32;
    var phi_1120_: i32;
    var phi_1173_: bool;
    var phi_1181_: bool;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1198_: f32;
    var phi_1204_: f32;
    var phi_1206_: evaluate_Verdict;
    var phi_1216_: u32;
    var phi_1225_: f32;
    var phi_1227_: evaluate_Verdict;
    var phi_1228_: bool;
    var phi_1229_: evaluate_Verdict;
    var phi_1230_: bool;
    var phi_1235_: evaluate_Verdict;
    var phi_1240_: evaluate_Verdict;
    var phi_1241_: evaluate_Verdict;
    var phi_1245_: bool;
    var phi_1246_: u32;
    var phi_1257_: u32;
    var phi_1274_: u32;

    let _e48 = id_1;
    let _e49 = local_5;
    let _e54 = arrayLength((&map.member));
    let _e59 = arrayLength((&levels.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e48, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.level_count;
        let _e76 = samples.member[_e65.first_primitive].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[_e65.first_primitive].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[_e65.first_primitive].normal[2u];
                let _e88 = global[2u];
                phi_415_ = (_e86 == _e88);
                phi_416_ = false;
            } else {
                phi_415_ = bool();
                phi_416_ = true;
            }
            let _e91 = phi_415_;
            let _e93 = phi_416_;
            phi_417_ = _e91;
            phi_418_ = _e93;
        } else {
            phi_417_ = bool();
            phi_418_ = true;
        }
        let _e95 = phi_417_;
        let _e97 = phi_418_;
        if _e97 {
            phi_422_ = false;
        } else {
            phi_422_ = _e95;
        }
        let _e99 = phi_422_;
        if !(_e99) {
            let _e102 = samples.member[_e65.first_primitive].position;
            let _e104 = p.member.light.place;
            let _e110 = p.member.light.place[3u];
            let _e117 = (_e104.x - (_e102.x * _e110));
            let _e118 = (_e104.y - (_e102.y * _e110));
            let _e119 = (_e104.z - (_e102.z * _e110));
            let _e121 = samples.member[_e65.first_primitive].normal;
            if ((((_e121.x * _e117) + (_e121.y * _e118)) + (_e121.z * _e119)) > 0f) {
                let _e135 = (((_e117 * _e117) + (_e118 * _e118)) + (_e119 * _e119));
                let _e137 = p.member.light.axis;
                let _e149 = p.member.light.place[3u];
                if (_e149 == 0f) {
                    phi_493_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_492_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_492_ = false;
                    }
                    let _e160 = phi_492_;
                    phi_493_ = _e160;
                }
                let _e162 = phi_493_;
                if _e162 {
                    let _e164 = samples.member[_e65.first_primitive].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_504_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_505_ = false;
                } else {
                    phi_504_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_505_ = true;
                }
                let _e183 = phi_504_;
                let _e185 = phi_505_;
                phi_506_ = _e183;
                phi_507_ = _e185;
            } else {
                phi_506_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_507_ = true;
            }
            let _e187 = phi_506_;
            let _e189 = phi_507_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_514_ = _e187;
            }
            let _e206 = phi_514_;
            phi_518_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_518_;
        if _e223.unnamed_1 {
            phi_1241_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[_e65.first_primitive].position;
            let _e233 = p.member.map_size;
            let _e235 = (0.5f / f32(_e233));
            let _e242 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e249 = lt_math_LightPoint(vec2<f32>(_e242.uv.x, 0f), _e242.depth, _e242.is_inside);
            let _e253 = lt_math_LightPoint(_e249.uv, 0f, _e249.is_inside);
            phi_538_ = lt_math_LightPoint();
            phi_541_ = 0u;
            phi_543_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e253.uv, _e253.depth, false));
            loop {
                let _e260 = phi_538_;
                let _e262 = phi_541_;
                let _e264 = phi_543_;
                local_2 = _e264;
                local_3 = _e264;
                local_4 = _e264;
                if (_e262 < _e72) {
                    if _e264.point.is_inside {
                        phi_704_ = lt_math_LightPoint();
                        phi_705_ = u32();
                        phi_706_ = lt_math_LevelPoint();
                        phi_707_ = false;
                    } else {
                        if (_e262 < _e59) {
                        } else {
                            return;
                        }
                        let _e275 = levels.member[(0u + _e262)].row_w;
                        let _e286 = ((((_e275.x * _e231.x) + (_e275.y * _e231.y)) + (_e275.z * _e231.z)) + (_e275.w * 1f));
                        let _e288 = levels.member[(0u + _e262)].row_x;
                        let _e300 = (((((_e288.x * _e231.x) + (_e288.y * _e231.y)) + (_e288.z * _e231.z)) + (_e288.w * 1f)) / _e286);
                        let _e302 = levels.member[(0u + _e262)].row_y;
                        let _e314 = (((((_e302.x * _e231.x) + (_e302.y * _e231.y)) + (_e302.z * _e231.z)) + (_e302.w * 1f)) / _e286);
                        let _e316 = levels.member[(0u + _e262)].row_z;
                        let _e327 = ((((_e316.x * _e231.x) + (_e316.y * _e231.y)) + (_e316.z * _e231.z)) + (_e316.w * 1f));
                        if (_e286 > 0f) {
                            if (_e300 >= 0f) {
                                phi_629_ = (_e300 <= 1f);
                            } else {
                                phi_629_ = false;
                            }
                            let _e332 = phi_629_;
                            if _e332 {
                                if (_e314 >= 0f) {
                                    phi_638_ = (_e314 <= 1f);
                                } else {
                                    phi_638_ = false;
                                }
                                let _e336 = phi_638_;
                                if _e336 {
                                    if (_e327 >= 0f) {
                                        phi_647_ = (_e327 <= 1f);
                                    } else {
                                        phi_647_ = false;
                                    }
                                    let _e340 = phi_647_;
                                    phi_648_ = _e340;
                                    phi_649_ = false;
                                } else {
                                    phi_648_ = bool();
                                    phi_649_ = true;
                                }
                                let _e342 = phi_648_;
                                let _e344 = phi_649_;
                                phi_650_ = _e342;
                                phi_651_ = _e344;
                            } else {
                                phi_650_ = bool();
                                phi_651_ = true;
                            }
                            let _e346 = phi_650_;
                            let _e348 = phi_651_;
                            phi_652_ = _e346;
                            phi_653_ = _e348;
                        } else {
                            phi_652_ = bool();
                            phi_653_ = true;
                        }
                        let _e350 = phi_652_;
                        let _e352 = phi_653_;
                        if _e352 {
                            phi_657_ = false;
                        } else {
                            phi_657_ = _e350;
                        }
                        let _e354 = phi_657_;
                        if _e354 {
                            if (_e300 >= _e235) {
                                if (_e300 <= (1f - _e235)) {
                                    if (_e314 >= _e235) {
                                        phi_684_ = (_e314 <= (1f - _e235));
                                        phi_685_ = false;
                                    } else {
                                        phi_684_ = bool();
                                        phi_685_ = true;
                                    }
                                    let _e362 = phi_684_;
                                    let _e364 = phi_685_;
                                    phi_686_ = _e362;
                                    phi_687_ = _e364;
                                } else {
                                    phi_686_ = bool();
                                    phi_687_ = true;
                                }
                                let _e366 = phi_686_;
                                let _e368 = phi_687_;
                                phi_688_ = _e366;
                                phi_689_ = _e368;
                            } else {
                                phi_688_ = bool();
                                phi_689_ = true;
                            }
                            let _e370 = phi_688_;
                            let _e372 = phi_689_;
                            phi_690_ = _e370;
                            phi_691_ = _e372;
                        } else {
                            phi_690_ = bool();
                            phi_691_ = true;
                        }
                        let _e374 = phi_690_;
                        let _e376 = phi_691_;
                        if _e376 {
                            phi_695_ = false;
                        } else {
                            phi_695_ = _e374;
                        }
                        let _e378 = phi_695_;
                        let _e385 = lt_math_LightPoint(vec2<f32>(_e300, _e260.uv.y), _e260.depth, _e260.is_inside);
                        let _e392 = lt_math_LightPoint(vec2<f32>(_e385.uv.x, _e314), _e385.depth, _e385.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e327, _e392.is_inside);
                        let _e400 = lt_math_LightPoint(_e396.uv, _e396.depth, _e378);
                        phi_704_ = _e400;
                        phi_705_ = (_e262 + 1u);
                        phi_706_ = lt_math_LevelPoint(_e262, _e400);
                        phi_707_ = true;
                    }
                    let _e404 = phi_704_;
                    let _e406 = phi_705_;
                    let _e408 = phi_706_;
                    let _e410 = phi_707_;
                    phi_539_ = _e404;
                    phi_542_ = _e406;
                    phi_544_ = _e408;
                    phi_708_ = _e410;
                } else {
                    phi_539_ = lt_math_LightPoint();
                    phi_542_ = u32();
                    phi_544_ = lt_math_LevelPoint();
                    phi_708_ = false;
                }
                let _e412 = phi_539_;
                let _e414 = phi_542_;
                let _e416 = phi_544_;
                let _e418 = phi_708_;
                continue;
                continuing {
                    phi_538_ = _e412;
                    phi_541_ = _e414;
                    phi_543_ = _e416;
                    break if !(_e418);
                }
            }
            let _e421 = local_2;
            if _e421.point.is_inside {
                if (0f > 0f) {
                    let _e427 = local_3;
                    if (_e427.level < _e59) {
                    } else {
                        return;
                    }
                    let _e432 = levels.member[(0u + _e427.level)];
                    let _e438 = global[0u];
                    if (_e432.row_w.x == _e438) {
                        let _e441 = global[1u];
                        if (_e432.row_w.y == _e441) {
                            let _e444 = global[2u];
                            phi_748_ = (_e432.row_w.z == _e444);
                            phi_749_ = false;
                        } else {
                            phi_748_ = bool();
                            phi_749_ = true;
                        }
                        let _e447 = phi_748_;
                        let _e449 = phi_749_;
                        phi_750_ = _e447;
                        phi_751_ = _e449;
                    } else {
                        phi_750_ = bool();
                        phi_751_ = true;
                    }
                    let _e451 = phi_750_;
                    let _e453 = phi_751_;
                    if _e453 {
                        phi_755_ = false;
                    } else {
                        phi_755_ = _e451;
                    }
                    let _e455 = phi_755_;
                    if _e455 {
                        let _e457 = samples.member[_e65.first_primitive].normal;
                        let _e459 = p.member.map_size;
                        let _e529 = ((abs(((((_e432.row_x.x * _e457.x) + (_e432.row_x.y * _e457.y)) + (_e432.row_x.z * _e457.z)) / (((_e432.row_x.x * _e432.row_x.x) + (_e432.row_x.y * _e432.row_x.y)) + (_e432.row_x.z * _e432.row_x.z)))) + abs(((((_e432.row_y.x * _e457.x) + (_e432.row_y.y * _e457.y)) + (_e432.row_y.z * _e457.z)) / (((_e432.row_y.x * _e432.row_y.x) + (_e432.row_y.y * _e432.row_y.y)) + (_e432.row_y.z * _e432.row_y.z))))) / (abs(((((_e432.row_z.x * _e457.x) + (_e432.row_z.y * _e457.y)) + (_e432.row_z.z * _e457.z)) / (((_e432.row_z.x * _e432.row_z.x) + (_e432.row_z.y * _e432.row_z.y)) + (_e432.row_z.z * _e432.row_z.z)))) * f32(_e459)));
                        if (_e529 < 0.002f) {
                            phi_837_ = _e529;
                        } else {
                            phi_837_ = 0.002f;
                        }
                        let _e532 = phi_837_;
                        phi_956_ = _e532;
                    } else {
                        let _e534 = p.member.map_size;
                        let _e540 = samples.member[_e65.first_primitive].position;
                        let _e551 = ((((_e432.row_w.x * _e540.x) + (_e432.row_w.y * _e540.y)) + (_e432.row_w.z * _e540.z)) + _e432.row_w.w);
                        let _e564 = ((_e432.row_x.x - (_e432.row_w.x * _e421.point.uv.x)) / _e551);
                        let _e565 = ((_e432.row_x.y - (_e432.row_w.y * _e421.point.uv.x)) / _e551);
                        let _e566 = ((_e432.row_x.z - (_e432.row_w.z * _e421.point.uv.x)) / _e551);
                        let _e579 = ((_e432.row_y.x - (_e432.row_w.x * _e421.point.uv.y)) / _e551);
                        let _e580 = ((_e432.row_y.y - (_e432.row_w.y * _e421.point.uv.y)) / _e551);
                        let _e581 = ((_e432.row_y.z - (_e432.row_w.z * _e421.point.uv.y)) / _e551);
                        let _e587 = samples.member[_e65.first_primitive].normal;
                        let _e592 = ((_e580 * _e587.z) - (_e587.y * _e581));
                        let _e597 = ((_e581 * _e587.x) - (_e587.z * _e579));
                        let _e602 = ((_e579 * _e587.y) - (_e587.x * _e580));
                        let _e604 = samples.member[_e65.first_primitive].normal;
                        let _e609 = ((_e565 * _e604.z) - (_e604.y * _e566));
                        let _e614 = ((_e566 * _e604.x) - (_e604.z * _e564));
                        let _e619 = ((_e564 * _e604.y) - (_e604.x * _e565));
                        let _e646 = ((abs(((((_e432.row_z.x * _e592) + (_e432.row_z.y * _e597)) + (_e432.row_z.z * _e602)) / (((_e564 * _e592) + (_e565 * _e597)) + (_e566 * _e602)))) + abs(((((_e432.row_z.x * _e609) + (_e432.row_z.y * _e614)) + (_e432.row_z.z * _e619)) / (((_e579 * _e609) + (_e580 * _e614)) + (_e581 * _e619))))) / f32(_e534));
                        let _e648 = (16f / f32(_e534));
                        if (_e646 < _e648) {
                            phi_955_ = _e646;
                        } else {
                            phi_955_ = _e648;
                        }
                        let _e651 = phi_955_;
                        phi_956_ = _e651;
                    }
                    let _e653 = phi_956_;
                    phi_959_ = (_e421.point.depth - (0f * _e653));
                } else {
                    phi_959_ = _e421.point.depth;
                }
                let _e657 = phi_959_;
                let _e663 = p.member.map_size;
                let _e664 = f32(_e663);
                let _e667 = ((_e421.point.uv.x * _e664) - 0.5f);
                let _e668 = ((_e421.point.uv.y * _e664) - 0.5f);
                if (_e667 > -8388608f) {
                    let _e680 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e680 > _e667) {
                        phi_988_ = 1f;
                    } else {
                        phi_988_ = 0f;
                    }
                    let _e683 = phi_988_;
                    if (_e667 < 8388608f) {
                        phi_993_ = (_e680 - _e683);
                        phi_994_ = false;
                    } else {
                        phi_993_ = f32();
                        phi_994_ = true;
                    }
                    let _e686 = phi_993_;
                    let _e688 = phi_994_;
                    phi_995_ = _e686;
                    phi_996_ = _e688;
                } else {
                    phi_995_ = f32();
                    phi_996_ = true;
                }
                let _e690 = phi_995_;
                let _e692 = phi_996_;
                if _e692 {
                    phi_1000_ = _e667;
                } else {
                    phi_1000_ = _e690;
                }
                let _e694 = phi_1000_;
                if (_e668 > -8388608f) {
                    let _e706 = f32(select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < bitcast<f32>(3472883712u))), 2147483647i, (_e668 > bitcast<f32>(1325400063u))), (_e668 == _e668)));
                    if (_e706 > _e668) {
                        phi_1020_ = 1f;
                    } else {
                        phi_1020_ = 0f;
                    }
                    let _e709 = phi_1020_;
                    if (_e668 < 8388608f) {
                        phi_1025_ = (_e706 - _e709);
                        phi_1026_ = false;
                    } else {
                        phi_1025_ = f32();
                        phi_1026_ = true;
                    }
                    let _e712 = phi_1025_;
                    let _e714 = phi_1026_;
                    phi_1027_ = _e712;
                    phi_1028_ = _e714;
                } else {
                    phi_1027_ = f32();
                    phi_1028_ = true;
                }
                let _e716 = phi_1027_;
                let _e718 = phi_1028_;
                if _e718 {
                    phi_1032_ = _e668;
                } else {
                    phi_1032_ = _e716;
                }
                let _e720 = phi_1032_;
                let _e721 = (_e667 - _e694);
                let _e722 = (_e668 - _e720);
                let _e731 = select(0i, select(select(i32(_e694), i32(-2147483648), (_e694 < bitcast<f32>(3472883712u))), 2147483647i, (_e694 > bitcast<f32>(1325400063u))), (_e694 == _e694));
                let _e740 = select(0i, select(select(i32(_e720), i32(-2147483648), (_e720 < bitcast<f32>(3472883712u))), 2147483647i, (_e720 > bitcast<f32>(1325400063u))), (_e720 == _e720));
                let _e751 = p.member.test;
                let _e752 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e751);
                let _e754 = p.member.map_size;
                let _e756 = local_4;
                local_1 = _e752;
                let _e759 = ((_e756.level * _e754) * _e754);
                let _e761 = (bitcast<i32>(_e754) - 1i);
                if (_e731 > 0i) {
                    phi_1081_ = _e731;
                } else {
                    phi_1081_ = 0i;
                }
                let _e764 = phi_1081_;
                if (_e740 > 0i) {
                    phi_1086_ = _e740;
                } else {
                    phi_1086_ = 0i;
                }
                let _e767 = phi_1086_;
                if (_e764 < _e761) {
                    phi_1091_ = _e764;
                } else {
                    phi_1091_ = _e761;
                }
                let _e770 = phi_1091_;
                if (_e767 < _e761) {
                    phi_1096_ = _e767;
                } else {
                    phi_1096_ = _e761;
                }
                let _e773 = phi_1096_;
                let _e774 = bitcast<u32>(_e770);
                let _e776 = (_e731 + 1i);
                let _e777 = (_e740 + 1i);
                if (_e776 > 0i) {
                    phi_1105_ = _e776;
                } else {
                    phi_1105_ = 0i;
                }
                let _e780 = phi_1105_;
                if (_e777 > 0i) {
                    phi_1110_ = _e777;
                } else {
                    phi_1110_ = 0i;
                }
                let _e783 = phi_1110_;
                if (_e780 < _e761) {
                    phi_1115_ = _e780;
                } else {
                    phi_1115_ = _e761;
                }
                let _e786 = phi_1115_;
                if (_e783 < _e761) {
                    phi_1120_ = _e783;
                } else {
                    phi_1120_ = _e761;
                }
                let _e789 = phi_1120_;
                let _e790 = bitcast<u32>(_e786);
                let _e792 = (bitcast<u32>(_e773) * _e754);
                let _e793 = (bitcast<u32>(_e789) * _e754);
                let _e798 = ((_e792 + _e774) + _e759);
                let _e799 = ((_e792 + _e790) + _e759);
                let _e800 = ((_e793 + _e774) + _e759);
                let _e801 = ((_e793 + _e790) + _e759);
                if (_e798 < _e54) {
                } else {
                    return;
                }
                let _e805 = map.member[(0u + _e798)];
                if (_e799 < _e54) {
                } else {
                    return;
                }
                let _e809 = map.member[(0u + _e799)];
                if (_e800 < _e54) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e800)];
                if (_e801 < _e54) {
                } else {
                    return;
                }
                let _e817 = map.member[(0u + _e801)];
                let _e819 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e805, _e809, _e813, _e817), vec4<f32>(((1f - _e721) * (1f - _e722)), (_e721 * (1f - _e722)), ((1f - _e721) * _e722), (_e721 * _e722)), _e657);
                let _e823 = p.member.epsilon;
                if (_e819 <= _e823) {
                    phi_1173_ = true;
                } else {
                    phi_1173_ = (_e819 >= (1f - _e823));
                }
                let _e828 = phi_1173_;
                if ((bitcast<u32>(_e819) & 2147483647u) > 2139095040u) {
                    phi_1181_ = true;
                } else {
                    phi_1181_ = !(_e828);
                }
                let _e834 = phi_1181_;
                if _e834 {
                    if (_e819 > 0f) {
                        if (_e819 < 1f) {
                            phi_1193_ = false;
                        } else {
                            phi_1193_ = true;
                        }
                        let _e838 = phi_1193_;
                        phi_1194_ = _e838;
                    } else {
                        phi_1194_ = true;
                    }
                    let _e840 = phi_1194_;
                    if _e840 {
                        phi_1198_ = 0.5f;
                    } else {
                        phi_1198_ = _e819;
                    }
                    let _e842 = phi_1198_;
                    phi_1206_ = evaluate_Verdict(_e842, true);
                } else {
                    if (_e819 > 0.5f) {
                        phi_1204_ = 1f;
                    } else {
                        phi_1204_ = 0f;
                    }
                    let _e846 = phi_1204_;
                    phi_1206_ = evaluate_Verdict(_e846, false);
                }
                let _e849 = phi_1206_;
                let _e852 = (_e849.visibility < 0.5f);
                if _e849.is_doubted {
                    phi_1229_ = evaluate_Verdict();
                    phi_1230_ = true;
                } else {
                    if _e852 {
                        phi_1216_ = 2u;
                    } else {
                        phi_1216_ = 1u;
                    }
                    let _e854 = phi_1216_;
                    if ((0u & _e854) != 0u) {
                        if _e852 {
                            phi_1225_ = 0.000000059604645f;
                        } else {
                            phi_1225_ = 0.99999994f;
                        }
                        let _e858 = phi_1225_;
                        phi_1227_ = evaluate_Verdict(_e858, true);
                        phi_1228_ = false;
                    } else {
                        phi_1227_ = evaluate_Verdict();
                        phi_1228_ = true;
                    }
                    let _e861 = phi_1227_;
                    let _e863 = phi_1228_;
                    phi_1229_ = _e861;
                    phi_1230_ = _e863;
                }
                let _e865 = phi_1229_;
                let _e867 = phi_1230_;
                if _e867 {
                    phi_1235_ = evaluate_Verdict(_e849.visibility, _e849.is_doubted);
                } else {
                    phi_1235_ = _e865;
                }
                let _e870 = phi_1235_;
                phi_1240_ = evaluate_Verdict(_e870.visibility, _e870.is_doubted);
            } else {
                phi_1240_ = evaluate_Verdict(0.5f, true);
            }
            let _e876 = phi_1240_;
            phi_1241_ = _e876;
        }
        let _e878 = phi_1241_;
        visibility.member[_e65.first_primitive] = _e878.visibility;
        phi_1245_ = _e878.is_doubted;
        phi_1246_ = _e65.first_primitive;
    } else {
        phi_1245_ = false;
        phi_1246_ = 0u;
    }
    let _e883 = phi_1245_;
    let _e885 = phi_1246_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e883 {
        let _e889 = atomicAdd((&shared_[0u]), 1u);
        phi_1257_ = _e889;
    } else {
        phi_1257_ = 0u;
    }
    let _e891 = phi_1257_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e895 = atomicLoad((&shared_[0u]));
        let _e896 = atomicAdd((&list.member[3u]), _e895);
        atomicStore((&shared_[1u]), _e896);
    }
    workgroupBarrier();
    if _e883 {
        if false {
            phi_1274_ = (_e885 | 2147483648u);
        } else {
            phi_1274_ = _e885;
        }
        let _e900 = phi_1274_;
        let _e902 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e902) + _e891)]), _e900);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
