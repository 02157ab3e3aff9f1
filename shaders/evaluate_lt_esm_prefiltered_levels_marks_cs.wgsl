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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_35 {
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_43;
@group(0) @binding(2) 
var<storage> map: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_177_: lt_bvh_traverse_Tree;
    var phi_178_: bool;
    var phi_179_: lt_bvh_traverse_Tree;
    var phi_180_: bool;
    var phi_185_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_177_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_178_ = false;
        } else {
            phi_177_ = lt_bvh_traverse_Tree();
            phi_178_ = true;
        }
        let _e71 = phi_177_;
        let _e73 = phi_178_;
        phi_179_ = _e71;
        phi_180_ = _e73;
    } else {
        phi_179_ = lt_bvh_traverse_Tree();
        phi_180_ = true;
    }
    let _e75 = phi_179_;
    let _e77 = phi_180_;
    if _e77 {
        phi_185_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_185_ = _e75;
    }
    let _e82 = phi_185_;
    return lt_bvh_traverse_Tree(_e82.root, _e82.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_212_: f32;
    var phi_225_: bool;
    var phi_229_: f32;
    var phi_242_: f32;
    var phi_247_: f32;
    var phi_269_: f32;
    var phi_274_: f32;
    var phi_275_: bool;
    var phi_276_: f32;
    var phi_277_: bool;
    var phi_281_: f32;
    var phi_319_: f32;
    var phi_335_: f32;
    var phi_336_: f32;
    var phi_337_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_212_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_211_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_210_ = 1f;
            } else {
                phi_210_ = param_6;
            }
            let _e67 = phi_210_;
            phi_211_ = _e67;
        }
        let _e69 = phi_211_;
        phi_212_ = _e69;
    }
    let _e71 = phi_212_;
    let _e73 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_225_ = true;
    } else {
        let _e77 = (84f < _e73);
        if _e77 {
        }
        phi_225_ = _e77;
    }
    let _e79 = phi_225_;
    if _e79 {
        phi_229_ = 84f;
    } else {
        phi_229_ = _e73;
    }
    let _e81 = phi_229_;
    let _e83 = (_e81 * (1f - _e71));
    if ((bitcast<u32>(_e83) & 2147483647u) > 2139095040u) {
        phi_319_ = _e83;
    } else {
        if (_e83 < -87f) {
            phi_242_ = -87f;
        } else {
            phi_242_ = _e83;
        }
        let _e89 = phi_242_;
        if (_e89 > 88f) {
            phi_247_ = 88f;
        } else {
            phi_247_ = _e89;
        }
        let _e92 = phi_247_;
        let _e94 = ((_e92 * 1.442695f) + 0.5f);
        if (_e94 > -8388608f) {
            let _e106 = f32(select(0i, select(select(i32(_e94), i32(-2147483648), (_e94 < bitcast<f32>(3472883712u))), 2147483647i, (_e94 > bitcast<f32>(1325400063u))), (_e94 == _e94)));
            if (_e106 > _e94) {
                phi_269_ = 1f;
            } else {
                phi_269_ = 0f;
            }
            let _e109 = phi_269_;
            if (_e94 < 8388608f) {
                phi_274_ = (_e106 - _e109);
                phi_275_ = false;
            } else {
                phi_274_ = f32();
                phi_275_ = true;
            }
            let _e112 = phi_274_;
            let _e114 = phi_275_;
            phi_276_ = _e112;
            phi_277_ = _e114;
        } else {
            phi_276_ = f32();
            phi_277_ = true;
        }
        let _e116 = phi_276_;
        let _e118 = phi_277_;
        if _e118 {
            phi_281_ = _e94;
        } else {
            phi_281_ = _e116;
        }
        let _e120 = phi_281_;
        let _e124 = ((_e92 - (_e120 * 0.69314575f)) - (_e120 * 0.0000014286068f));
        phi_319_ = ((((((((((((((((1f / 5040f) * _e124) + (1f / 720f)) * _e124) + (1f / 120f)) * _e124) + (1f / 24f)) * _e124) + (1f / 6f)) * _e124) + 0.5f) * _e124) + 1f) * _e124) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e120), i32(-2147483648), (_e120 < bitcast<f32>(3472883712u))), 2147483647i, (_e120 > bitcast<f32>(1325400063u))), (_e120 == _e120)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e160 = phi_319_;
    let _e161 = (param_5.x * _e160);
    if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
        phi_337_ = _e161;
    } else {
        if (_e161 < 0f) {
            phi_336_ = 0f;
        } else {
            if (_e161 > 1f) {
                phi_335_ = 1f;
            } else {
                phi_335_ = _e161;
            }
            let _e168 = phi_335_;
            phi_336_ = _e168;
        }
        let _e170 = phi_336_;
        phi_337_ = _e170;
    }
    let _e172 = phi_337_;
    return _e172;
}

fn function_() {
    var local: f32;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_410_: bool;
    var phi_480_: bool;
    var phi_481_: bool;
    var phi_492_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_493_: bool;
    var phi_494_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_495_: bool;
    var phi_502_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_506_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_526_: lt_math_LightPoint;
    var phi_529_: u32;
    var phi_531_: lt_math_LevelPoint;
    var phi_617_: bool;
    var phi_626_: bool;
    var phi_635_: bool;
    var phi_636_: bool;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_639_: bool;
    var phi_640_: bool;
    var phi_641_: bool;
    var phi_645_: bool;
    var phi_672_: bool;
    var phi_673_: bool;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_676_: bool;
    var phi_677_: bool;
    var phi_678_: bool;
    var phi_679_: bool;
    var phi_683_: bool;
    var phi_692_: lt_math_LightPoint;
    var phi_693_: u32;
    var phi_694_: lt_math_LevelPoint;
    var phi_695_: bool;
    var phi_527_: lt_math_LightPoint;
    var phi_530_: u32;
    var phi_532_: lt_math_LevelPoint;
    var phi_696_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: bool;
    var phi_743_: bool;
    var phi_825_: f32;
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_947_: f32;
    var phi_976_: f32;
    var phi_981_: f32;
    var phi_982_: bool;
    var phi_983_: f32;
    var phi_984_: bool;
    var phi_988_: f32;
    var phi_1008_: f32;
    var phi_1013_: f32;
    var phi_1014_: bool;
    var phi_1015_: f32;
    var phi_1016_: bool;
    var phi_1020_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1071_: i32;
    var phi_1076_: i32;
    var phi_1081_: i32;
    var phi_1086_: i32;
    var phi_1095_: i32;
    var phi_1100_: i32;
    var phi_1105_: i32;
    var phi_1110_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1210_: i32;
    var phi_1215_: i32;
    var phi_1220_: i32;
    var phi_1225_: i32;
    var phi_1244_: i32;
    var phi_1249_: i32;
    var phi_1254_: i32;
    var phi_1259_: i32;
    var phi_1278_: i32;
    var phi_1283_: i32;
    var phi_1288_: i32;
    var phi_1293_: i32;
    var phi_1312_: i32;
    var phi_1317_: i32;
    var phi_1322_: i32;
    var phi_1327_: i32;
    var phi_1405_: bool;
    var phi_1413_: bool;
    var phi_1425_: bool;
    var phi_1426_: bool;
    var phi_1430_: f32;
    var phi_1436_: f32;
    var phi_1438_: evaluate_Verdict;
    var phi_1448_: u32;
    var phi_1457_: f32;
    var phi_1459_: evaluate_Verdict;
    var phi_1460_: bool;
    var phi_1461_: evaluate_Verdict;
    var phi_1462_: bool;
    var phi_1467_: evaluate_Verdict;
    var phi_1472_: evaluate_Verdict;
    var phi_1473_: evaluate_Verdict;

    let _e59 = id_1;
    let _e66 = arrayLength((&map.member));
    let _e72 = arrayLength((&marks.member));
    let _e75 = arrayLength((&levels.member));
    let _e78 = p.member.size[0u];
    let _e80 = p.member.size[1u];
    let _e81 = lt_shaders_entry_pixel_index(_e59, _e78, _e80);
    if (bitcast<i32>(_e81.root) != 0i) {
        let _e87 = p.member.level_count;
        if (_e81.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e94 = samples.member[(0u + _e81.first_primitive)].normal[0u];
        let _e96 = global[0u];
        if (_e94 == _e96) {
            let _e99 = samples.member[(0u + _e81.first_primitive)].normal[1u];
            let _e101 = global[1u];
            if (_e99 == _e101) {
                let _e104 = samples.member[(0u + _e81.first_primitive)].normal[2u];
                let _e106 = global[2u];
                phi_403_ = (_e104 == _e106);
                phi_404_ = false;
            } else {
                phi_403_ = bool();
                phi_404_ = true;
            }
            let _e109 = phi_403_;
            let _e111 = phi_404_;
            phi_405_ = _e109;
            phi_406_ = _e111;
        } else {
            phi_405_ = bool();
            phi_406_ = true;
        }
        let _e113 = phi_405_;
        let _e115 = phi_406_;
        if _e115 {
            phi_410_ = false;
        } else {
            phi_410_ = _e113;
        }
        let _e117 = phi_410_;
        if !(_e117) {
            let _e120 = samples.member[(0u + _e81.first_primitive)].position;
            let _e122 = p.member.light.place;
            let _e128 = p.member.light.place[3u];
            let _e135 = (_e122.x - (_e120.x * _e128));
            let _e136 = (_e122.y - (_e120.y * _e128));
            let _e137 = (_e122.z - (_e120.z * _e128));
            let _e139 = samples.member[(0u + _e81.first_primitive)].normal;
            if ((((_e139.x * _e135) + (_e139.y * _e136)) + (_e139.z * _e137)) > 0f) {
                let _e153 = (((_e135 * _e135) + (_e136 * _e136)) + (_e137 * _e137));
                let _e155 = p.member.light.axis;
                let _e167 = p.member.light.place[3u];
                if (_e167 == 0f) {
                    phi_481_ = true;
                } else {
                    let _e170 = p.member.light.range_squared;
                    if (_e153 <= _e170) {
                        let _e173 = p.member.light.cos_outer;
                        phi_480_ = (-((((_e135 * _e155.x) + (_e136 * _e155.y)) + (_e137 * _e155.z))) >= (_e173 * sqrt(_e153)));
                    } else {
                        phi_480_ = false;
                    }
                    let _e178 = phi_480_;
                    phi_481_ = _e178;
                }
                let _e180 = phi_481_;
                if _e180 {
                    let _e182 = samples.member[(0u + _e81.first_primitive)].flags;
                    let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e190.unnamed.visibility, false), _e190.unnamed_1);
                    phi_492_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e196.unnamed, ((_e182 & 1u) == 0u));
                    phi_493_ = false;
                } else {
                    phi_492_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_493_ = true;
                }
                let _e201 = phi_492_;
                let _e203 = phi_493_;
                phi_494_ = _e201;
                phi_495_ = _e203;
            } else {
                phi_494_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_495_ = true;
            }
            let _e205 = phi_494_;
            let _e207 = phi_495_;
            if _e207 {
                let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
                phi_502_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
            } else {
                phi_502_ = _e205;
            }
            let _e224 = phi_502_;
            phi_506_ = _e224;
        } else {
            let _e230 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e236 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e230.unnamed.visibility, false), _e230.unnamed_1);
            phi_506_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e236.unnamed, true);
        }
        let _e241 = phi_506_;
        if _e241.unnamed_1 {
            phi_1473_ = evaluate_Verdict(_e241.unnamed.visibility, _e241.unnamed.is_doubted);
        } else {
            let _e249 = samples.member[(0u + _e81.first_primitive)].position;
            let _e251 = p.member.map_size;
            let _e253 = (0.5f / f32(_e251));
            let _e260 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e267 = lt_math_LightPoint(vec2<f32>(_e260.uv.x, 0f), _e260.depth, _e260.is_inside);
            let _e271 = lt_math_LightPoint(_e267.uv, 0f, _e267.is_inside);
            phi_526_ = lt_math_LightPoint();
            phi_529_ = 0u;
            phi_531_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e271.uv, _e271.depth, false));
            loop {
                let _e278 = phi_526_;
                let _e280 = phi_529_;
                let _e282 = phi_531_;
                local_1 = _e282;
                local_2 = _e282;
                local_3 = _e282;
                local_4 = _e282;
                if (_e280 < _e87) {
                    if _e282.point.is_inside {
                        phi_692_ = lt_math_LightPoint();
                        phi_693_ = u32();
                        phi_694_ = lt_math_LevelPoint();
                        phi_695_ = false;
                    } else {
                        if (_e280 < _e75) {
                        } else {
                            return;
                        }
                        let _e293 = levels.member[(0u + _e280)].row_w;
                        let _e304 = ((((_e293.x * _e249.x) + (_e293.y * _e249.y)) + (_e293.z * _e249.z)) + (_e293.w * 1f));
                        let _e306 = levels.member[(0u + _e280)].row_x;
                        let _e318 = (((((_e306.x * _e249.x) + (_e306.y * _e249.y)) + (_e306.z * _e249.z)) + (_e306.w * 1f)) / _e304);
                        let _e320 = levels.member[(0u + _e280)].row_y;
                        let _e332 = (((((_e320.x * _e249.x) + (_e320.y * _e249.y)) + (_e320.z * _e249.z)) + (_e320.w * 1f)) / _e304);
                        let _e334 = levels.member[(0u + _e280)].row_z;
                        let _e345 = ((((_e334.x * _e249.x) + (_e334.y * _e249.y)) + (_e334.z * _e249.z)) + (_e334.w * 1f));
                        if (_e304 > 0f) {
                            if (_e318 >= 0f) {
                                phi_617_ = (_e318 <= 1f);
                            } else {
                                phi_617_ = false;
                            }
                            let _e350 = phi_617_;
                            if _e350 {
                                if (_e332 >= 0f) {
                                    phi_626_ = (_e332 <= 1f);
                                } else {
                                    phi_626_ = false;
                                }
                                let _e354 = phi_626_;
                                if _e354 {
                                    if (_e345 >= 0f) {
                                        phi_635_ = (_e345 <= 1f);
                                    } else {
                                        phi_635_ = false;
                                    }
                                    let _e358 = phi_635_;
                                    phi_636_ = _e358;
                                    phi_637_ = false;
                                } else {
                                    phi_636_ = bool();
                                    phi_637_ = true;
                                }
                                let _e360 = phi_636_;
                                let _e362 = phi_637_;
                                phi_638_ = _e360;
                                phi_639_ = _e362;
                            } else {
                                phi_638_ = bool();
                                phi_639_ = true;
                            }
                            let _e364 = phi_638_;
                            let _e366 = phi_639_;
                            phi_640_ = _e364;
                            phi_641_ = _e366;
                        } else {
                            phi_640_ = bool();
                            phi_641_ = true;
                        }
                        let _e368 = phi_640_;
                        let _e370 = phi_641_;
                        if _e370 {
                            phi_645_ = false;
                        } else {
                            phi_645_ = _e368;
                        }
                        let _e372 = phi_645_;
                        if _e372 {
                            if (_e318 >= _e253) {
                                if (_e318 <= (1f - _e253)) {
                                    if (_e332 >= _e253) {
                                        phi_672_ = (_e332 <= (1f - _e253));
                                        phi_673_ = false;
                                    } else {
                                        phi_672_ = bool();
                                        phi_673_ = true;
                                    }
                                    let _e380 = phi_672_;
                                    let _e382 = phi_673_;
                                    phi_674_ = _e380;
                                    phi_675_ = _e382;
                                } else {
                                    phi_674_ = bool();
                                    phi_675_ = true;
                                }
                                let _e384 = phi_674_;
                                let _e386 = phi_675_;
                                phi_676_ = _e384;
                                phi_677_ = _e386;
                            } else {
                                phi_676_ = bool();
                                phi_677_ = true;
                            }
                            let _e388 = phi_676_;
                            let _e390 = phi_677_;
                            phi_678_ = _e388;
                            phi_679_ = _e390;
                        } else {
                            phi_678_ = bool();
                            phi_679_ = true;
                        }
                        let _e392 = phi_678_;
                        let _e394 = phi_679_;
                        if _e394 {
                            phi_683_ = false;
                        } else {
                            phi_683_ = _e392;
                        }
                        let _e396 = phi_683_;
                        let _e403 = lt_math_LightPoint(vec2<f32>(_e318, _e278.uv.y), _e278.depth, _e278.is_inside);
                        let _e410 = lt_math_LightPoint(vec2<f32>(_e403.uv.x, _e332), _e403.depth, _e403.is_inside);
                        let _e414 = lt_math_LightPoint(_e410.uv, _e345, _e410.is_inside);
                        let _e418 = lt_math_LightPoint(_e414.uv, _e414.depth, _e396);
                        phi_692_ = _e418;
                        phi_693_ = (_e280 + 1u);
                        phi_694_ = lt_math_LevelPoint(_e280, _e418);
                        phi_695_ = true;
                    }
                    let _e422 = phi_692_;
                    let _e424 = phi_693_;
                    let _e426 = phi_694_;
                    let _e428 = phi_695_;
                    phi_527_ = _e422;
                    phi_530_ = _e424;
                    phi_532_ = _e426;
                    phi_696_ = _e428;
                } else {
                    phi_527_ = lt_math_LightPoint();
                    phi_530_ = u32();
                    phi_532_ = lt_math_LevelPoint();
                    phi_696_ = false;
                }
                let _e430 = phi_527_;
                let _e432 = phi_530_;
                let _e434 = phi_532_;
                let _e436 = phi_696_;
                continue;
                continuing {
                    phi_526_ = _e430;
                    phi_529_ = _e432;
                    phi_531_ = _e434;
                    break if !(_e436);
                }
            }
            let _e439 = local_1;
            if _e439.point.is_inside {
                if (0f > 0f) {
                    let _e445 = local_2;
                    if (_e445.level < _e75) {
                    } else {
                        return;
                    }
                    let _e450 = levels.member[(0u + _e445.level)];
                    let _e456 = global[0u];
                    if (_e450.row_w.x == _e456) {
                        let _e459 = global[1u];
                        if (_e450.row_w.y == _e459) {
                            let _e462 = global[2u];
                            phi_736_ = (_e450.row_w.z == _e462);
                            phi_737_ = false;
                        } else {
                            phi_736_ = bool();
                            phi_737_ = true;
                        }
                        let _e465 = phi_736_;
                        let _e467 = phi_737_;
                        phi_738_ = _e465;
                        phi_739_ = _e467;
                    } else {
                        phi_738_ = bool();
                        phi_739_ = true;
                    }
                    let _e469 = phi_738_;
                    let _e471 = phi_739_;
                    if _e471 {
                        phi_743_ = false;
                    } else {
                        phi_743_ = _e469;
                    }
                    let _e473 = phi_743_;
                    if _e473 {
                        let _e475 = samples.member[(0u + _e81.first_primitive)].normal;
                        let _e477 = p.member.map_size;
                        let _e547 = ((abs(((((_e450.row_x.x * _e475.x) + (_e450.row_x.y * _e475.y)) + (_e450.row_x.z * _e475.z)) / (((_e450.row_x.x * _e450.row_x.x) + (_e450.row_x.y * _e450.row_x.y)) + (_e450.row_x.z * _e450.row_x.z)))) + abs(((((_e450.row_y.x * _e475.x) + (_e450.row_y.y * _e475.y)) + (_e450.row_y.z * _e475.z)) / (((_e450.row_y.x * _e450.row_y.x) + (_e450.row_y.y * _e450.row_y.y)) + (_e450.row_y.z * _e450.row_y.z))))) / (abs(((((_e450.row_z.x * _e475.x) + (_e450.row_z.y * _e475.y)) + (_e450.row_z.z * _e475.z)) / (((_e450.row_z.x * _e450.row_z.x) + (_e450.row_z.y * _e450.row_z.y)) + (_e450.row_z.z * _e450.row_z.z)))) * f32(_e477)));
                        if (_e547 < 0.002f) {
                            phi_825_ = _e547;
                        } else {
                            phi_825_ = 0.002f;
                        }
                        let _e550 = phi_825_;
                        phi_944_ = _e550;
                    } else {
                        let _e552 = p.member.map_size;
                        let _e558 = samples.member[(0u + _e81.first_primitive)].position;
                        let _e569 = ((((_e450.row_w.x * _e558.x) + (_e450.row_w.y * _e558.y)) + (_e450.row_w.z * _e558.z)) + _e450.row_w.w);
                        let _e582 = ((_e450.row_x.x - (_e450.row_w.x * _e439.point.uv.x)) / _e569);
                        let _e583 = ((_e450.row_x.y - (_e450.row_w.y * _e439.point.uv.x)) / _e569);
                        let _e584 = ((_e450.row_x.z - (_e450.row_w.z * _e439.point.uv.x)) / _e569);
                        let _e597 = ((_e450.row_y.x - (_e450.row_w.x * _e439.point.uv.y)) / _e569);
                        let _e598 = ((_e450.row_y.y - (_e450.row_w.y * _e439.point.uv.y)) / _e569);
                        let _e599 = ((_e450.row_y.z - (_e450.row_w.z * _e439.point.uv.y)) / _e569);
                        let _e605 = samples.member[(0u + _e81.first_primitive)].normal;
                        let _e610 = ((_e598 * _e605.z) - (_e605.y * _e599));
                        let _e615 = ((_e599 * _e605.x) - (_e605.z * _e597));
                        let _e620 = ((_e597 * _e605.y) - (_e605.x * _e598));
                        let _e622 = samples.member[(0u + _e81.first_primitive)].normal;
                        let _e627 = ((_e583 * _e622.z) - (_e622.y * _e584));
                        let _e632 = ((_e584 * _e622.x) - (_e622.z * _e582));
                        let _e637 = ((_e582 * _e622.y) - (_e622.x * _e583));
                        let _e664 = ((abs(((((_e450.row_z.x * _e610) + (_e450.row_z.y * _e615)) + (_e450.row_z.z * _e620)) / (((_e582 * _e610) + (_e583 * _e615)) + (_e584 * _e620)))) + abs(((((_e450.row_z.x * _e627) + (_e450.row_z.y * _e632)) + (_e450.row_z.z * _e637)) / (((_e597 * _e627) + (_e598 * _e632)) + (_e599 * _e637))))) / f32(_e552));
                        let _e666 = (16f / f32(_e552));
                        if (_e664 < _e666) {
                            phi_943_ = _e664;
                        } else {
                            phi_943_ = _e666;
                        }
                        let _e669 = phi_943_;
                        phi_944_ = _e669;
                    }
                    let _e671 = phi_944_;
                    phi_947_ = (_e439.point.depth - (0f * _e671));
                } else {
                    phi_947_ = _e439.point.depth;
                }
                let _e675 = phi_947_;
                let _e681 = p.member.map_size;
                let _e682 = f32(_e681);
                let _e685 = ((_e439.point.uv.x * _e682) - 0.5f);
                let _e686 = ((_e439.point.uv.y * _e682) - 0.5f);
                if (_e685 > -8388608f) {
                    let _e698 = f32(select(0i, select(select(i32(_e685), i32(-2147483648), (_e685 < bitcast<f32>(3472883712u))), 2147483647i, (_e685 > bitcast<f32>(1325400063u))), (_e685 == _e685)));
                    if (_e698 > _e685) {
                        phi_976_ = 1f;
                    } else {
                        phi_976_ = 0f;
                    }
                    let _e701 = phi_976_;
                    if (_e685 < 8388608f) {
                        phi_981_ = (_e698 - _e701);
                        phi_982_ = false;
                    } else {
                        phi_981_ = f32();
                        phi_982_ = true;
                    }
                    let _e704 = phi_981_;
                    let _e706 = phi_982_;
                    phi_983_ = _e704;
                    phi_984_ = _e706;
                } else {
                    phi_983_ = f32();
                    phi_984_ = true;
                }
                let _e708 = phi_983_;
                let _e710 = phi_984_;
                if _e710 {
                    phi_988_ = _e685;
                } else {
                    phi_988_ = _e708;
                }
                let _e712 = phi_988_;
                if (_e686 > -8388608f) {
                    let _e724 = f32(select(0i, select(select(i32(_e686), i32(-2147483648), (_e686 < bitcast<f32>(3472883712u))), 2147483647i, (_e686 > bitcast<f32>(1325400063u))), (_e686 == _e686)));
                    if (_e724 > _e686) {
                        phi_1008_ = 1f;
                    } else {
                        phi_1008_ = 0f;
                    }
                    let _e727 = phi_1008_;
                    if (_e686 < 8388608f) {
                        phi_1013_ = (_e724 - _e727);
                        phi_1014_ = false;
                    } else {
                        phi_1013_ = f32();
                        phi_1014_ = true;
                    }
                    let _e730 = phi_1013_;
                    let _e732 = phi_1014_;
                    phi_1015_ = _e730;
                    phi_1016_ = _e732;
                } else {
                    phi_1015_ = f32();
                    phi_1016_ = true;
                }
                let _e734 = phi_1015_;
                let _e736 = phi_1016_;
                if _e736 {
                    phi_1020_ = _e686;
                } else {
                    phi_1020_ = _e734;
                }
                let _e738 = phi_1020_;
                let _e739 = (_e685 - _e712);
                let _e740 = (_e686 - _e738);
                let _e749 = select(0i, select(select(i32(_e712), i32(-2147483648), (_e712 < bitcast<f32>(3472883712u))), 2147483647i, (_e712 > bitcast<f32>(1325400063u))), (_e712 == _e712));
                let _e758 = select(0i, select(select(i32(_e738), i32(-2147483648), (_e738 < bitcast<f32>(3472883712u))), 2147483647i, (_e738 > bitcast<f32>(1325400063u))), (_e738 == _e738));
                let _e761 = ((1f - _e739) * (1f - _e740));
                let _e763 = (_e739 * (1f - _e740));
                let _e765 = ((1f - _e739) * _e740);
                let _e766 = (_e739 * _e740);
                let _e768 = p.member.test;
                let _e769 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e768);
                let _e771 = p.member.map_size;
                let _e773 = local_3;
                local = _e769;
                let _e776 = ((_e773.level * _e771) * _e771);
                let _e778 = (bitcast<i32>(_e771) - 1i);
                if (_e749 > 0i) {
                    phi_1071_ = _e749;
                } else {
                    phi_1071_ = 0i;
                }
                let _e781 = phi_1071_;
                if (_e758 > 0i) {
                    phi_1076_ = _e758;
                } else {
                    phi_1076_ = 0i;
                }
                let _e784 = phi_1076_;
                if (_e781 < _e778) {
                    phi_1081_ = _e781;
                } else {
                    phi_1081_ = _e778;
                }
                let _e787 = phi_1081_;
                if (_e784 < _e778) {
                    phi_1086_ = _e784;
                } else {
                    phi_1086_ = _e778;
                }
                let _e790 = phi_1086_;
                let _e791 = bitcast<u32>(_e787);
                let _e793 = (_e749 + 1i);
                let _e794 = (_e758 + 1i);
                if (_e793 > 0i) {
                    phi_1095_ = _e793;
                } else {
                    phi_1095_ = 0i;
                }
                let _e797 = phi_1095_;
                if (_e794 > 0i) {
                    phi_1100_ = _e794;
                } else {
                    phi_1100_ = 0i;
                }
                let _e800 = phi_1100_;
                if (_e797 < _e778) {
                    phi_1105_ = _e797;
                } else {
                    phi_1105_ = _e778;
                }
                let _e803 = phi_1105_;
                if (_e800 < _e778) {
                    phi_1110_ = _e800;
                } else {
                    phi_1110_ = _e778;
                }
                let _e806 = phi_1110_;
                let _e807 = bitcast<u32>(_e803);
                let _e809 = (bitcast<u32>(_e790) * _e771);
                let _e810 = (bitcast<u32>(_e806) * _e771);
                let _e815 = ((_e809 + _e791) + _e776);
                let _e816 = ((_e809 + _e807) + _e776);
                let _e817 = ((_e810 + _e791) + _e776);
                let _e818 = ((_e810 + _e807) + _e776);
                if (_e815 < _e66) {
                } else {
                    return;
                }
                let _e822 = map.member[(0u + _e815)];
                if (_e816 < _e66) {
                } else {
                    return;
                }
                let _e834 = map.member[(0u + _e816)];
                if (_e817 < _e66) {
                } else {
                    return;
                }
                let _e850 = map.member[(0u + _e817)];
                if (_e818 < _e66) {
                } else {
                    return;
                }
                let _e866 = map.member[(0u + _e818)];
                let _e880 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e822.x * _e761) + (_e834.x * _e763)) + (_e850.x * _e765)) + (_e866.x * _e766)), ((((_e822.y * _e761) + (_e834.y * _e763)) + (_e850.y * _e765)) + (_e866.y * _e766)), ((((_e822.z * _e761) + (_e834.z * _e763)) + (_e850.z * _e765)) + (_e866.z * _e766)), ((((_e822.w * _e761) + (_e834.w * _e763)) + (_e850.w * _e765)) + (_e866.w * _e766))), _e675);
                let _e882 = p.member.map_size;
                let _e884 = local_4;
                let _e887 = (bitcast<i32>(_e882) - 1i);
                if (_e749 > 0i) {
                    phi_1210_ = _e749;
                } else {
                    phi_1210_ = 0i;
                }
                let _e890 = phi_1210_;
                if (_e758 > 0i) {
                    phi_1215_ = _e758;
                } else {
                    phi_1215_ = 0i;
                }
                let _e893 = phi_1215_;
                if (_e890 < _e887) {
                    phi_1220_ = _e890;
                } else {
                    phi_1220_ = _e887;
                }
                let _e896 = phi_1220_;
                if (_e893 < _e887) {
                    phi_1225_ = _e893;
                } else {
                    phi_1225_ = _e887;
                }
                let _e899 = phi_1225_;
                let _e900 = bitcast<u32>(_e896);
                let _e907 = ((((_e884.level * _e882) + bitcast<u32>(_e899)) * (_e882 / 16u)) + (_e900 / 16u));
                let _e910 = (_e749 + 1i);
                let _e911 = (_e758 + 0i);
                let _e913 = (bitcast<i32>(_e882) - 1i);
                if (_e910 > 0i) {
                    phi_1244_ = _e910;
                } else {
                    phi_1244_ = 0i;
                }
                let _e916 = phi_1244_;
                if (_e911 > 0i) {
                    phi_1249_ = _e911;
                } else {
                    phi_1249_ = 0i;
                }
                let _e919 = phi_1249_;
                if (_e916 < _e913) {
                    phi_1254_ = _e916;
                } else {
                    phi_1254_ = _e913;
                }
                let _e922 = phi_1254_;
                if (_e919 < _e913) {
                    phi_1259_ = _e919;
                } else {
                    phi_1259_ = _e913;
                }
                let _e925 = phi_1259_;
                let _e926 = bitcast<u32>(_e922);
                let _e933 = ((((_e884.level * _e882) + bitcast<u32>(_e925)) * (_e882 / 16u)) + (_e926 / 16u));
                let _e936 = (_e749 + 0i);
                let _e937 = (_e758 + 1i);
                let _e939 = (bitcast<i32>(_e882) - 1i);
                if (_e936 > 0i) {
                    phi_1278_ = _e936;
                } else {
                    phi_1278_ = 0i;
                }
                let _e942 = phi_1278_;
                if (_e937 > 0i) {
                    phi_1283_ = _e937;
                } else {
                    phi_1283_ = 0i;
                }
                let _e945 = phi_1283_;
                if (_e942 < _e939) {
                    phi_1288_ = _e942;
                } else {
                    phi_1288_ = _e939;
                }
                let _e948 = phi_1288_;
                if (_e945 < _e939) {
                    phi_1293_ = _e945;
                } else {
                    phi_1293_ = _e939;
                }
                let _e951 = phi_1293_;
                let _e952 = bitcast<u32>(_e948);
                let _e959 = ((((_e884.level * _e882) + bitcast<u32>(_e951)) * (_e882 / 16u)) + (_e952 / 16u));
                let _e962 = (_e749 + 1i);
                let _e963 = (_e758 + 1i);
                let _e965 = (bitcast<i32>(_e882) - 1i);
                if (_e962 > 0i) {
                    phi_1312_ = _e962;
                } else {
                    phi_1312_ = 0i;
                }
                let _e968 = phi_1312_;
                if (_e963 > 0i) {
                    phi_1317_ = _e963;
                } else {
                    phi_1317_ = 0i;
                }
                let _e971 = phi_1317_;
                if (_e968 < _e965) {
                    phi_1322_ = _e968;
                } else {
                    phi_1322_ = _e965;
                }
                let _e974 = phi_1322_;
                if (_e971 < _e965) {
                    phi_1327_ = _e971;
                } else {
                    phi_1327_ = _e965;
                }
                let _e977 = phi_1327_;
                let _e978 = bitcast<u32>(_e974);
                let _e985 = ((((_e884.level * _e882) + bitcast<u32>(_e977)) * (_e882 / 16u)) + (_e978 / 16u));
                if (_e907 < _e72) {
                } else {
                    return;
                }
                let _e991 = marks.member[(0u + _e907)];
                if (_e933 < _e72) {
                } else {
                    return;
                }
                let _e999 = marks.member[(0u + _e933)];
                if (_e959 < _e72) {
                } else {
                    return;
                }
                let _e1008 = marks.member[(0u + _e959)];
                if (_e985 < _e72) {
                } else {
                    return;
                }
                let _e1016 = marks.member[(0u + _e985)];
                let _e1024 = p.member.epsilon;
                if (_e880 <= _e1024) {
                    phi_1405_ = true;
                } else {
                    phi_1405_ = (_e880 >= (1f - _e1024));
                }
                let _e1029 = phi_1405_;
                if ((bitcast<u32>(_e880) & 2147483647u) > 2139095040u) {
                    phi_1413_ = true;
                } else {
                    phi_1413_ = !(_e1029);
                }
                let _e1035 = phi_1413_;
                if _e1035 {
                    if (_e880 > 0f) {
                        if (_e880 < 1f) {
                            phi_1425_ = false;
                        } else {
                            phi_1425_ = true;
                        }
                        let _e1039 = phi_1425_;
                        phi_1426_ = _e1039;
                    } else {
                        phi_1426_ = true;
                    }
                    let _e1041 = phi_1426_;
                    if _e1041 {
                        phi_1430_ = 0.5f;
                    } else {
                        phi_1430_ = _e880;
                    }
                    let _e1043 = phi_1430_;
                    phi_1438_ = evaluate_Verdict(_e1043, true);
                } else {
                    if (_e880 > 0.5f) {
                        phi_1436_ = 1f;
                    } else {
                        phi_1436_ = 0f;
                    }
                    let _e1047 = phi_1436_;
                    phi_1438_ = evaluate_Verdict(_e1047, false);
                }
                let _e1050 = phi_1438_;
                let _e1053 = (_e1050.visibility < 0.5f);
                if _e1050.is_doubted {
                    phi_1461_ = evaluate_Verdict();
                    phi_1462_ = true;
                } else {
                    if _e1053 {
                        phi_1448_ = 2u;
                    } else {
                        phi_1448_ = 1u;
                    }
                    let _e1055 = phi_1448_;
                    if ((((((_e991 >> bitcast<u32>((((_e900 % 16u) * 2u) & 31u))) & 3u) | ((_e999 >> bitcast<u32>((((_e926 % 16u) * 2u) & 31u))) & 3u)) | (((_e1008 >> bitcast<u32>((((_e952 % 16u) * 2u) & 31u))) & 3u) | ((_e1016 >> bitcast<u32>((((_e978 % 16u) * 2u) & 31u))) & 3u))) & _e1055) != 0u) {
                        if _e1053 {
                            phi_1457_ = 0.000000059604645f;
                        } else {
                            phi_1457_ = 0.99999994f;
                        }
                        let _e1059 = phi_1457_;
                        phi_1459_ = evaluate_Verdict(_e1059, true);
                        phi_1460_ = false;
                    } else {
                        phi_1459_ = evaluate_Verdict();
                        phi_1460_ = true;
                    }
                    let _e1062 = phi_1459_;
                    let _e1064 = phi_1460_;
                    phi_1461_ = _e1062;
                    phi_1462_ = _e1064;
                }
                let _e1066 = phi_1461_;
                let _e1068 = phi_1462_;
                if _e1068 {
                    phi_1467_ = evaluate_Verdict(_e1050.visibility, _e1050.is_doubted);
                } else {
                    phi_1467_ = _e1066;
                }
                let _e1071 = phi_1467_;
                phi_1472_ = evaluate_Verdict(_e1071.visibility, _e1071.is_doubted);
            } else {
                phi_1472_ = evaluate_Verdict(0.5f, true);
            }
            let _e1077 = phi_1472_;
            phi_1473_ = _e1077;
        }
        let _e1079 = phi_1473_;
        if (_e81.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e81.first_primitive)] = _e1079.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_prefiltered_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
