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
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e55 = phi_148_;
        let _e57 = phi_149_;
        phi_150_ = _e55;
        phi_151_ = _e57;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e59 = phi_150_;
    let _e61 = phi_151_;
    if _e61 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e59;
    }
    let _e66 = phi_156_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_184_: f32;
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
    var phi_302_: bool;
    var phi_306_: f32;
    var phi_318_: bool;
    var phi_325_: f32;
    var phi_340_: f32;
    var phi_341_: f32;
    var phi_342_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_184_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_183_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_182_ = 1f;
            } else {
                phi_182_ = param_7;
            }
            let _e52 = phi_182_;
            phi_183_ = _e52;
        }
        let _e54 = phi_183_;
        phi_184_ = _e54;
    }
    let _e56 = phi_184_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_202_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_5.x;
            }
            let _e64 = phi_200_;
            phi_201_ = _e64;
        }
        let _e66 = phi_201_;
        phi_202_ = _e66;
    }
    let _e68 = phi_202_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_220_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_5.y;
            }
            let _e76 = phi_218_;
            phi_219_ = _e76;
        }
        let _e78 = phi_219_;
        phi_220_ = _e78;
    }
    let _e80 = phi_220_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_238_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_5.z;
            }
            let _e88 = phi_236_;
            phi_237_ = _e88;
        }
        let _e90 = phi_237_;
        phi_238_ = _e90;
    }
    let _e92 = phi_238_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_256_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_5.w;
            }
            let _e100 = phi_254_;
            phi_255_ = _e100;
        }
        let _e102 = phi_255_;
        phi_256_ = _e102;
    }
    let _e104 = phi_256_;
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
        phi_302_ = true;
    } else {
        let _e143 = (_e109 > _e139);
        if _e143 {
        }
        phi_302_ = _e143;
    }
    let _e145 = phi_302_;
    if _e145 {
        phi_306_ = _e109;
    } else {
        phi_306_ = _e139;
    }
    let _e147 = phi_306_;
    let _e148 = -(_e120);
    if (_e148 <= 0f) {
        let _e152 = ((bitcast<u32>(_e147) & 2147483647u) > 2139095040u);
        if _e152 {
        }
        phi_318_ = _e152;
    } else {
        phi_318_ = true;
    }
    let _e154 = phi_318_;
    if _e154 {
        phi_325_ = (_e147 / (_e147 + (_e148 * _e148)));
    } else {
        phi_325_ = 1f;
    }
    let _e159 = phi_325_;
    if ((bitcast<u32>(_e159) & 2147483647u) > 2139095040u) {
        phi_342_ = _e159;
    } else {
        if (_e159 < 0f) {
            phi_341_ = 0f;
        } else {
            if (_e159 > 1f) {
                phi_340_ = 1f;
            } else {
                phi_340_ = _e159;
            }
            let _e166 = phi_340_;
            phi_341_ = _e166;
        }
        let _e168 = phi_341_;
        phi_342_ = _e168;
    }
    let _e170 = phi_342_;
    return _e170;
}

fn function_() {
    var local: f32;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_409_: bool;
    var phi_479_: bool;
    var phi_480_: bool;
    var phi_491_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_492_: bool;
    var phi_493_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_494_: bool;
    var phi_501_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_505_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_525_: lt_math_LightPoint;
    var phi_528_: u32;
    var phi_530_: lt_math_LevelPoint;
    var phi_616_: bool;
    var phi_625_: bool;
    var phi_634_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_644_: bool;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_682_: bool;
    var phi_691_: lt_math_LightPoint;
    var phi_692_: u32;
    var phi_693_: lt_math_LevelPoint;
    var phi_694_: bool;
    var phi_526_: lt_math_LightPoint;
    var phi_529_: u32;
    var phi_531_: lt_math_LevelPoint;
    var phi_695_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_742_: bool;
    var phi_824_: f32;
    var phi_942_: f32;
    var phi_943_: f32;
    var phi_946_: f32;
    var phi_975_: f32;
    var phi_980_: f32;
    var phi_981_: bool;
    var phi_982_: f32;
    var phi_983_: bool;
    var phi_987_: f32;
    var phi_1007_: f32;
    var phi_1012_: f32;
    var phi_1013_: bool;
    var phi_1014_: f32;
    var phi_1015_: bool;
    var phi_1019_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1068_: i32;
    var phi_1073_: i32;
    var phi_1078_: i32;
    var phi_1083_: i32;
    var phi_1092_: i32;
    var phi_1097_: i32;
    var phi_1102_: i32;
    var phi_1107_: i32;
    var phi_1160_: bool;
    var phi_1168_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1185_: f32;
    var phi_1191_: f32;
    var phi_1193_: evaluate_Verdict;
    var phi_1203_: u32;
    var phi_1212_: f32;
    var phi_1214_: evaluate_Verdict;
    var phi_1215_: bool;
    var phi_1216_: evaluate_Verdict;
    var phi_1217_: bool;
    var phi_1222_: evaluate_Verdict;
    var phi_1227_: evaluate_Verdict;
    var phi_1228_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = arrayLength((&levels.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e43, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e68 = p.member.level_count;
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e75 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e87 = global[2u];
                phi_402_ = (_e85 == _e87);
                phi_403_ = false;
            } else {
                phi_402_ = bool();
                phi_403_ = true;
            }
            let _e90 = phi_402_;
            let _e92 = phi_403_;
            phi_404_ = _e90;
            phi_405_ = _e92;
        } else {
            phi_404_ = bool();
            phi_405_ = true;
        }
        let _e94 = phi_404_;
        let _e96 = phi_405_;
        if _e96 {
            phi_409_ = false;
        } else {
            phi_409_ = _e94;
        }
        let _e98 = phi_409_;
        if !(_e98) {
            let _e101 = samples.member[(0u + _e62.first_primitive)].position;
            let _e103 = p.member.light.place;
            let _e109 = p.member.light.place[3u];
            let _e116 = (_e103.x - (_e101.x * _e109));
            let _e117 = (_e103.y - (_e101.y * _e109));
            let _e118 = (_e103.z - (_e101.z * _e109));
            let _e120 = samples.member[(0u + _e62.first_primitive)].normal;
            if ((((_e120.x * _e116) + (_e120.y * _e117)) + (_e120.z * _e118)) > 0f) {
                let _e134 = (((_e116 * _e116) + (_e117 * _e117)) + (_e118 * _e118));
                let _e136 = p.member.light.axis;
                let _e148 = p.member.light.place[3u];
                if (_e148 == 0f) {
                    phi_480_ = true;
                } else {
                    let _e151 = p.member.light.range_squared;
                    if (_e134 <= _e151) {
                        let _e154 = p.member.light.cos_outer;
                        phi_479_ = (-((((_e116 * _e136.x) + (_e117 * _e136.y)) + (_e118 * _e136.z))) >= (_e154 * sqrt(_e134)));
                    } else {
                        phi_479_ = false;
                    }
                    let _e159 = phi_479_;
                    phi_480_ = _e159;
                }
                let _e161 = phi_480_;
                if _e161 {
                    let _e163 = samples.member[(0u + _e62.first_primitive)].flags;
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
                    phi_491_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, ((_e163 & 1u) == 0u));
                    phi_492_ = false;
                } else {
                    phi_491_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_492_ = true;
                }
                let _e182 = phi_491_;
                let _e184 = phi_492_;
                phi_493_ = _e182;
                phi_494_ = _e184;
            } else {
                phi_493_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_494_ = true;
            }
            let _e186 = phi_493_;
            let _e188 = phi_494_;
            if _e188 {
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e200 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e194.unnamed.visibility, false), _e194.unnamed_1);
                phi_501_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e200.unnamed, true);
            } else {
                phi_501_ = _e186;
            }
            let _e205 = phi_501_;
            phi_505_ = _e205;
        } else {
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e217 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e211.unnamed.visibility, false), _e211.unnamed_1);
            phi_505_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e217.unnamed, true);
        }
        let _e222 = phi_505_;
        if _e222.unnamed_1 {
            phi_1228_ = evaluate_Verdict(_e222.unnamed.visibility, _e222.unnamed.is_doubted);
        } else {
            let _e230 = samples.member[(0u + _e62.first_primitive)].position;
            let _e232 = p.member.map_size;
            let _e234 = (0.5f / f32(_e232));
            let _e241 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e248 = lt_math_LightPoint(vec2<f32>(_e241.uv.x, 0f), _e241.depth, _e241.is_inside);
            let _e252 = lt_math_LightPoint(_e248.uv, 0f, _e248.is_inside);
            phi_525_ = lt_math_LightPoint();
            phi_528_ = 0u;
            phi_530_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e252.uv, _e252.depth, false));
            loop {
                let _e259 = phi_525_;
                let _e261 = phi_528_;
                let _e263 = phi_530_;
                local_1 = _e263;
                local_2 = _e263;
                local_3 = _e263;
                if (_e261 < _e68) {
                    if _e263.point.is_inside {
                        phi_691_ = lt_math_LightPoint();
                        phi_692_ = u32();
                        phi_693_ = lt_math_LevelPoint();
                        phi_694_ = false;
                    } else {
                        if (_e261 < _e56) {
                        } else {
                            return;
                        }
                        let _e274 = levels.member[(0u + _e261)].row_w;
                        let _e285 = ((((_e274.x * _e230.x) + (_e274.y * _e230.y)) + (_e274.z * _e230.z)) + (_e274.w * 1f));
                        let _e287 = levels.member[(0u + _e261)].row_x;
                        let _e299 = (((((_e287.x * _e230.x) + (_e287.y * _e230.y)) + (_e287.z * _e230.z)) + (_e287.w * 1f)) / _e285);
                        let _e301 = levels.member[(0u + _e261)].row_y;
                        let _e313 = (((((_e301.x * _e230.x) + (_e301.y * _e230.y)) + (_e301.z * _e230.z)) + (_e301.w * 1f)) / _e285);
                        let _e315 = levels.member[(0u + _e261)].row_z;
                        let _e326 = ((((_e315.x * _e230.x) + (_e315.y * _e230.y)) + (_e315.z * _e230.z)) + (_e315.w * 1f));
                        if (_e285 > 0f) {
                            if (_e299 >= 0f) {
                                phi_616_ = (_e299 <= 1f);
                            } else {
                                phi_616_ = false;
                            }
                            let _e331 = phi_616_;
                            if _e331 {
                                if (_e313 >= 0f) {
                                    phi_625_ = (_e313 <= 1f);
                                } else {
                                    phi_625_ = false;
                                }
                                let _e335 = phi_625_;
                                if _e335 {
                                    if (_e326 >= 0f) {
                                        phi_634_ = (_e326 <= 1f);
                                    } else {
                                        phi_634_ = false;
                                    }
                                    let _e339 = phi_634_;
                                    phi_635_ = _e339;
                                    phi_636_ = false;
                                } else {
                                    phi_635_ = bool();
                                    phi_636_ = true;
                                }
                                let _e341 = phi_635_;
                                let _e343 = phi_636_;
                                phi_637_ = _e341;
                                phi_638_ = _e343;
                            } else {
                                phi_637_ = bool();
                                phi_638_ = true;
                            }
                            let _e345 = phi_637_;
                            let _e347 = phi_638_;
                            phi_639_ = _e345;
                            phi_640_ = _e347;
                        } else {
                            phi_639_ = bool();
                            phi_640_ = true;
                        }
                        let _e349 = phi_639_;
                        let _e351 = phi_640_;
                        if _e351 {
                            phi_644_ = false;
                        } else {
                            phi_644_ = _e349;
                        }
                        let _e353 = phi_644_;
                        if _e353 {
                            if (_e299 >= _e234) {
                                if (_e299 <= (1f - _e234)) {
                                    if (_e313 >= _e234) {
                                        phi_671_ = (_e313 <= (1f - _e234));
                                        phi_672_ = false;
                                    } else {
                                        phi_671_ = bool();
                                        phi_672_ = true;
                                    }
                                    let _e361 = phi_671_;
                                    let _e363 = phi_672_;
                                    phi_673_ = _e361;
                                    phi_674_ = _e363;
                                } else {
                                    phi_673_ = bool();
                                    phi_674_ = true;
                                }
                                let _e365 = phi_673_;
                                let _e367 = phi_674_;
                                phi_675_ = _e365;
                                phi_676_ = _e367;
                            } else {
                                phi_675_ = bool();
                                phi_676_ = true;
                            }
                            let _e369 = phi_675_;
                            let _e371 = phi_676_;
                            phi_677_ = _e369;
                            phi_678_ = _e371;
                        } else {
                            phi_677_ = bool();
                            phi_678_ = true;
                        }
                        let _e373 = phi_677_;
                        let _e375 = phi_678_;
                        if _e375 {
                            phi_682_ = false;
                        } else {
                            phi_682_ = _e373;
                        }
                        let _e377 = phi_682_;
                        let _e384 = lt_math_LightPoint(vec2<f32>(_e299, _e259.uv.y), _e259.depth, _e259.is_inside);
                        let _e391 = lt_math_LightPoint(vec2<f32>(_e384.uv.x, _e313), _e384.depth, _e384.is_inside);
                        let _e395 = lt_math_LightPoint(_e391.uv, _e326, _e391.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e395.depth, _e377);
                        phi_691_ = _e399;
                        phi_692_ = (_e261 + 1u);
                        phi_693_ = lt_math_LevelPoint(_e261, _e399);
                        phi_694_ = true;
                    }
                    let _e403 = phi_691_;
                    let _e405 = phi_692_;
                    let _e407 = phi_693_;
                    let _e409 = phi_694_;
                    phi_526_ = _e403;
                    phi_529_ = _e405;
                    phi_531_ = _e407;
                    phi_695_ = _e409;
                } else {
                    phi_526_ = lt_math_LightPoint();
                    phi_529_ = u32();
                    phi_531_ = lt_math_LevelPoint();
                    phi_695_ = false;
                }
                let _e411 = phi_526_;
                let _e413 = phi_529_;
                let _e415 = phi_531_;
                let _e417 = phi_695_;
                continue;
                continuing {
                    phi_525_ = _e411;
                    phi_528_ = _e413;
                    phi_530_ = _e415;
                    break if !(_e417);
                }
            }
            let _e420 = local_1;
            if _e420.point.is_inside {
                if (0f > 0f) {
                    let _e426 = local_2;
                    if (_e426.level < _e56) {
                    } else {
                        return;
                    }
                    let _e431 = levels.member[(0u + _e426.level)];
                    let _e437 = global[0u];
                    if (_e431.row_w.x == _e437) {
                        let _e440 = global[1u];
                        if (_e431.row_w.y == _e440) {
                            let _e443 = global[2u];
                            phi_735_ = (_e431.row_w.z == _e443);
                            phi_736_ = false;
                        } else {
                            phi_735_ = bool();
                            phi_736_ = true;
                        }
                        let _e446 = phi_735_;
                        let _e448 = phi_736_;
                        phi_737_ = _e446;
                        phi_738_ = _e448;
                    } else {
                        phi_737_ = bool();
                        phi_738_ = true;
                    }
                    let _e450 = phi_737_;
                    let _e452 = phi_738_;
                    if _e452 {
                        phi_742_ = false;
                    } else {
                        phi_742_ = _e450;
                    }
                    let _e454 = phi_742_;
                    if _e454 {
                        let _e456 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e458 = p.member.map_size;
                        let _e528 = ((abs(((((_e431.row_x.x * _e456.x) + (_e431.row_x.y * _e456.y)) + (_e431.row_x.z * _e456.z)) / (((_e431.row_x.x * _e431.row_x.x) + (_e431.row_x.y * _e431.row_x.y)) + (_e431.row_x.z * _e431.row_x.z)))) + abs(((((_e431.row_y.x * _e456.x) + (_e431.row_y.y * _e456.y)) + (_e431.row_y.z * _e456.z)) / (((_e431.row_y.x * _e431.row_y.x) + (_e431.row_y.y * _e431.row_y.y)) + (_e431.row_y.z * _e431.row_y.z))))) / (abs(((((_e431.row_z.x * _e456.x) + (_e431.row_z.y * _e456.y)) + (_e431.row_z.z * _e456.z)) / (((_e431.row_z.x * _e431.row_z.x) + (_e431.row_z.y * _e431.row_z.y)) + (_e431.row_z.z * _e431.row_z.z)))) * f32(_e458)));
                        if (_e528 < 0.002f) {
                            phi_824_ = _e528;
                        } else {
                            phi_824_ = 0.002f;
                        }
                        let _e531 = phi_824_;
                        phi_943_ = _e531;
                    } else {
                        let _e533 = p.member.map_size;
                        let _e539 = samples.member[(0u + _e62.first_primitive)].position;
                        let _e550 = ((((_e431.row_w.x * _e539.x) + (_e431.row_w.y * _e539.y)) + (_e431.row_w.z * _e539.z)) + _e431.row_w.w);
                        let _e563 = ((_e431.row_x.x - (_e431.row_w.x * _e420.point.uv.x)) / _e550);
                        let _e564 = ((_e431.row_x.y - (_e431.row_w.y * _e420.point.uv.x)) / _e550);
                        let _e565 = ((_e431.row_x.z - (_e431.row_w.z * _e420.point.uv.x)) / _e550);
                        let _e578 = ((_e431.row_y.x - (_e431.row_w.x * _e420.point.uv.y)) / _e550);
                        let _e579 = ((_e431.row_y.y - (_e431.row_w.y * _e420.point.uv.y)) / _e550);
                        let _e580 = ((_e431.row_y.z - (_e431.row_w.z * _e420.point.uv.y)) / _e550);
                        let _e586 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e591 = ((_e579 * _e586.z) - (_e586.y * _e580));
                        let _e596 = ((_e580 * _e586.x) - (_e586.z * _e578));
                        let _e601 = ((_e578 * _e586.y) - (_e586.x * _e579));
                        let _e603 = samples.member[(0u + _e62.first_primitive)].normal;
                        let _e608 = ((_e564 * _e603.z) - (_e603.y * _e565));
                        let _e613 = ((_e565 * _e603.x) - (_e603.z * _e563));
                        let _e618 = ((_e563 * _e603.y) - (_e603.x * _e564));
                        let _e645 = ((abs(((((_e431.row_z.x * _e591) + (_e431.row_z.y * _e596)) + (_e431.row_z.z * _e601)) / (((_e563 * _e591) + (_e564 * _e596)) + (_e565 * _e601)))) + abs(((((_e431.row_z.x * _e608) + (_e431.row_z.y * _e613)) + (_e431.row_z.z * _e618)) / (((_e578 * _e608) + (_e579 * _e613)) + (_e580 * _e618))))) / f32(_e533));
                        let _e647 = (16f / f32(_e533));
                        if (_e645 < _e647) {
                            phi_942_ = _e645;
                        } else {
                            phi_942_ = _e647;
                        }
                        let _e650 = phi_942_;
                        phi_943_ = _e650;
                    }
                    let _e652 = phi_943_;
                    phi_946_ = (_e420.point.depth - (0f * _e652));
                } else {
                    phi_946_ = _e420.point.depth;
                }
                let _e656 = phi_946_;
                let _e662 = p.member.map_size;
                let _e663 = f32(_e662);
                let _e666 = ((_e420.point.uv.x * _e663) - 0.5f);
                let _e667 = ((_e420.point.uv.y * _e663) - 0.5f);
                if (_e666 > -8388608f) {
                    let _e679 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e679 > _e666) {
                        phi_975_ = 1f;
                    } else {
                        phi_975_ = 0f;
                    }
                    let _e682 = phi_975_;
                    if (_e666 < 8388608f) {
                        phi_980_ = (_e679 - _e682);
                        phi_981_ = false;
                    } else {
                        phi_980_ = f32();
                        phi_981_ = true;
                    }
                    let _e685 = phi_980_;
                    let _e687 = phi_981_;
                    phi_982_ = _e685;
                    phi_983_ = _e687;
                } else {
                    phi_982_ = f32();
                    phi_983_ = true;
                }
                let _e689 = phi_982_;
                let _e691 = phi_983_;
                if _e691 {
                    phi_987_ = _e666;
                } else {
                    phi_987_ = _e689;
                }
                let _e693 = phi_987_;
                if (_e667 > -8388608f) {
                    let _e705 = f32(select(0i, select(select(i32(_e667), i32(-2147483648), (_e667 < bitcast<f32>(3472883712u))), 2147483647i, (_e667 > bitcast<f32>(1325400063u))), (_e667 == _e667)));
                    if (_e705 > _e667) {
                        phi_1007_ = 1f;
                    } else {
                        phi_1007_ = 0f;
                    }
                    let _e708 = phi_1007_;
                    if (_e667 < 8388608f) {
                        phi_1012_ = (_e705 - _e708);
                        phi_1013_ = false;
                    } else {
                        phi_1012_ = f32();
                        phi_1013_ = true;
                    }
                    let _e711 = phi_1012_;
                    let _e713 = phi_1013_;
                    phi_1014_ = _e711;
                    phi_1015_ = _e713;
                } else {
                    phi_1014_ = f32();
                    phi_1015_ = true;
                }
                let _e715 = phi_1014_;
                let _e717 = phi_1015_;
                if _e717 {
                    phi_1019_ = _e667;
                } else {
                    phi_1019_ = _e715;
                }
                let _e719 = phi_1019_;
                let _e720 = (_e666 - _e693);
                let _e721 = (_e667 - _e719);
                let _e730 = select(0i, select(select(i32(_e693), i32(-2147483648), (_e693 < bitcast<f32>(3472883712u))), 2147483647i, (_e693 > bitcast<f32>(1325400063u))), (_e693 == _e693));
                let _e739 = select(0i, select(select(i32(_e719), i32(-2147483648), (_e719 < bitcast<f32>(3472883712u))), 2147483647i, (_e719 > bitcast<f32>(1325400063u))), (_e719 == _e719));
                let _e750 = p.member.test;
                let _e751 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e750);
                let _e753 = p.member.map_size;
                let _e755 = local_3;
                local = _e751;
                let _e758 = ((_e755.level * _e753) * _e753);
                let _e760 = (bitcast<i32>(_e753) - 1i);
                if (_e730 > 0i) {
                    phi_1068_ = _e730;
                } else {
                    phi_1068_ = 0i;
                }
                let _e763 = phi_1068_;
                if (_e739 > 0i) {
                    phi_1073_ = _e739;
                } else {
                    phi_1073_ = 0i;
                }
                let _e766 = phi_1073_;
                if (_e763 < _e760) {
                    phi_1078_ = _e763;
                } else {
                    phi_1078_ = _e760;
                }
                let _e769 = phi_1078_;
                if (_e766 < _e760) {
                    phi_1083_ = _e766;
                } else {
                    phi_1083_ = _e760;
                }
                let _e772 = phi_1083_;
                let _e773 = bitcast<u32>(_e769);
                let _e775 = (_e730 + 1i);
                let _e776 = (_e739 + 1i);
                if (_e775 > 0i) {
                    phi_1092_ = _e775;
                } else {
                    phi_1092_ = 0i;
                }
                let _e779 = phi_1092_;
                if (_e776 > 0i) {
                    phi_1097_ = _e776;
                } else {
                    phi_1097_ = 0i;
                }
                let _e782 = phi_1097_;
                if (_e779 < _e760) {
                    phi_1102_ = _e779;
                } else {
                    phi_1102_ = _e760;
                }
                let _e785 = phi_1102_;
                if (_e782 < _e760) {
                    phi_1107_ = _e782;
                } else {
                    phi_1107_ = _e760;
                }
                let _e788 = phi_1107_;
                let _e789 = bitcast<u32>(_e785);
                let _e791 = (bitcast<u32>(_e772) * _e753);
                let _e792 = (bitcast<u32>(_e788) * _e753);
                let _e797 = ((_e791 + _e773) + _e758);
                let _e798 = ((_e791 + _e789) + _e758);
                let _e799 = ((_e792 + _e773) + _e758);
                let _e800 = ((_e792 + _e789) + _e758);
                if (_e797 < _e50) {
                } else {
                    return;
                }
                let _e804 = map.member[(0u + _e797)];
                if (_e798 < _e50) {
                } else {
                    return;
                }
                let _e808 = map.member[(0u + _e798)];
                if (_e799 < _e50) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e799)];
                if (_e800 < _e50) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e800)];
                let _e818 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e804, _e808, _e812, _e816), vec4<f32>(((1f - _e720) * (1f - _e721)), (_e720 * (1f - _e721)), ((1f - _e720) * _e721), (_e720 * _e721)), _e656);
                let _e822 = p.member.epsilon;
                if (_e818 <= _e822) {
                    phi_1160_ = true;
                } else {
                    phi_1160_ = (_e818 >= (1f - _e822));
                }
                let _e827 = phi_1160_;
                if ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u) {
                    phi_1168_ = true;
                } else {
                    phi_1168_ = !(_e827);
                }
                let _e833 = phi_1168_;
                if _e833 {
                    if (_e818 > 0f) {
                        if (_e818 < 1f) {
                            phi_1180_ = false;
                        } else {
                            phi_1180_ = true;
                        }
                        let _e837 = phi_1180_;
                        phi_1181_ = _e837;
                    } else {
                        phi_1181_ = true;
                    }
                    let _e839 = phi_1181_;
                    if _e839 {
                        phi_1185_ = 0.5f;
                    } else {
                        phi_1185_ = _e818;
                    }
                    let _e841 = phi_1185_;
                    phi_1193_ = evaluate_Verdict(_e841, true);
                } else {
                    if (_e818 > 0.5f) {
                        phi_1191_ = 1f;
                    } else {
                        phi_1191_ = 0f;
                    }
                    let _e845 = phi_1191_;
                    phi_1193_ = evaluate_Verdict(_e845, false);
                }
                let _e848 = phi_1193_;
                let _e851 = (_e848.visibility < 0.5f);
                if _e848.is_doubted {
                    phi_1216_ = evaluate_Verdict();
                    phi_1217_ = true;
                } else {
                    if _e851 {
                        phi_1203_ = 2u;
                    } else {
                        phi_1203_ = 1u;
                    }
                    let _e853 = phi_1203_;
                    if ((0u & _e853) != 0u) {
                        if _e851 {
                            phi_1212_ = 0.000000059604645f;
                        } else {
                            phi_1212_ = 0.99999994f;
                        }
                        let _e857 = phi_1212_;
                        phi_1214_ = evaluate_Verdict(_e857, true);
                        phi_1215_ = false;
                    } else {
                        phi_1214_ = evaluate_Verdict();
                        phi_1215_ = true;
                    }
                    let _e860 = phi_1214_;
                    let _e862 = phi_1215_;
                    phi_1216_ = _e860;
                    phi_1217_ = _e862;
                }
                let _e864 = phi_1216_;
                let _e866 = phi_1217_;
                if _e866 {
                    phi_1222_ = evaluate_Verdict(_e848.visibility, _e848.is_doubted);
                } else {
                    phi_1222_ = _e864;
                }
                let _e869 = phi_1222_;
                phi_1227_ = evaluate_Verdict(_e869.visibility, _e869.is_doubted);
            } else {
                phi_1227_ = evaluate_Verdict(0.5f, true);
            }
            let _e875 = phi_1227_;
            phi_1228_ = _e875;
        }
        let _e877 = phi_1228_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e877.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
