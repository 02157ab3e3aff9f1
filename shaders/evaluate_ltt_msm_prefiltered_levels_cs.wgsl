struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

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

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_49 {
    member: array<lt_math_LightProjection>,
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
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_55;
@group(0) @binding(5) 
var<storage> levels: type_49;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e56 = phi_165_;
        let _e58 = phi_166_;
        phi_167_ = _e56;
        phi_168_ = _e58;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e60 = phi_167_;
    let _e62 = phi_168_;
    if _e62 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e60;
    }
    let _e67 = phi_173_;
    return lt_bvh_traverse_Tree(_e67.root, _e67.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_230_: bool;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: bool;
    var phi_257_: f32;
    var phi_258_: bool;
    var phi_296_: vec2<f32>;
    var phi_330_: f32;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_367_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_370_: f32;

    let _e46 = (*param_4);
    let _e47 = (1f - _e46);
    let _e56 = (0.5f * _e46);
    let _e57 = ((param_5.x * _e47) + _e56);
    let _e58 = ((param_5.y * _e47) + _e56);
    let _e60 = ((param_5.w * _e47) + _e56);
    let _e62 = (_e58 - (_e57 * _e57));
    let _e64 = (((param_5.z * _e47) + _e56) - (_e57 * _e58));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_224_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_6;
            }
            let _e76 = phi_222_;
            phi_223_ = _e76;
        }
        let _e78 = phi_223_;
        phi_224_ = _e78;
    }
    let _e80 = phi_224_;
    if (_e57 == _e60) {
        phi_230_ = (_e57 > 0.5f);
    } else {
        phi_230_ = false;
    }
    let _e84 = phi_230_;
    if _e84 {
        if (_e80 > 0f) {
            if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
                phi_254_ = _e57;
            } else {
                if (_e57 < 0f) {
                    phi_253_ = 0f;
                } else {
                    if (_e57 > 1f) {
                        phi_252_ = 1f;
                    } else {
                        phi_252_ = _e57;
                    }
                    let _e92 = phi_252_;
                    phi_253_ = _e92;
                }
                let _e94 = phi_253_;
                phi_254_ = _e94;
            }
            let _e96 = phi_254_;
            phi_255_ = _e96;
            phi_256_ = false;
        } else {
            phi_255_ = f32();
            phi_256_ = true;
        }
        let _e98 = phi_255_;
        let _e100 = phi_256_;
        phi_257_ = _e98;
        phi_258_ = _e100;
    } else {
        phi_257_ = f32();
        phi_258_ = true;
    }
    let _e102 = phi_257_;
    let _e104 = phi_258_;
    if _e104 {
        let _e105 = (_e64 / _e62);
        let _e106 = (_e80 - _e57);
        let _e112 = (((((_e80 * _e80) - _e58) - (_e105 * _e106)) * _e62) / (((_e60 - (_e58 * _e58)) * _e62) - (_e64 * _e64)));
        let _e115 = ((_e106 / _e62) - (_e105 * _e112));
        let _e121 = ((0.5f * _e115) / _e112);
        let _e124 = ((_e121 * _e121) - (((1f - (_e115 * _e57)) - (_e112 * _e58)) / _e112));
        if (_e124 >= 0f) {
            let _e126 = sqrt(_e124);
            phi_296_ = vec2<f32>((-(_e121) - _e126), (-(_e121) + _e126));
        } else {
            phi_296_ = vec2(bitcast<f32>((bitcast<u32>(_e124) | 2143289344u)));
        }
        let _e137 = phi_296_;
        if (_e80 <= _e137.x) {
            phi_369_ = 1f;
        } else {
            if (_e80 > _e137.y) {
                let _e150 = (((_e58 - (_e57 * (_e137.x + _e137.y))) + (_e137.x * _e137.y)) / ((_e80 - _e137.x) * (_e80 - _e137.y)));
                if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
                    phi_332_ = _e150;
                } else {
                    if (_e150 < 0f) {
                        phi_331_ = 0f;
                    } else {
                        if (_e150 > 1f) {
                            phi_330_ = 1f;
                        } else {
                            phi_330_ = _e150;
                        }
                        let _e157 = phi_330_;
                        phi_331_ = _e157;
                    }
                    let _e159 = phi_331_;
                    phi_332_ = _e159;
                }
                let _e161 = phi_332_;
                phi_368_ = _e161;
            } else {
                if (_e80 > _e137.x) {
                    let _e172 = (1f - (((_e58 - (_e57 * (_e80 + _e137.y))) + (_e80 * _e137.y)) / ((_e137.x - _e80) * (_e137.x - _e137.y))));
                    if ((bitcast<u32>(_e172) & 2147483647u) > 2139095040u) {
                        phi_363_ = _e172;
                    } else {
                        if (_e172 < 0f) {
                            phi_362_ = 0f;
                        } else {
                            if (_e172 > 1f) {
                                phi_361_ = 1f;
                            } else {
                                phi_361_ = _e172;
                            }
                            let _e179 = phi_361_;
                            phi_362_ = _e179;
                        }
                        let _e181 = phi_362_;
                        phi_363_ = _e181;
                    }
                    let _e183 = phi_363_;
                    phi_367_ = _e183;
                } else {
                    phi_367_ = bitcast<f32>((bitcast<u32>(_e137.x) | 2143289344u));
                }
                let _e188 = phi_367_;
                phi_368_ = _e188;
            }
            let _e190 = phi_368_;
            phi_369_ = _e190;
        }
        let _e192 = phi_369_;
        phi_370_ = _e192;
    } else {
        phi_370_ = _e102;
    }
    let _e194 = phi_370_;
    return _e194;
}

fn function_() {
    var local_1: f32;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_432_: bool;
    var phi_502_: bool;
    var phi_503_: bool;
    var phi_514_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_515_: bool;
    var phi_516_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_517_: bool;
    var phi_524_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_528_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_548_: lt_math_LightPoint;
    var phi_551_: u32;
    var phi_553_: lt_math_LevelPoint;
    var phi_639_: bool;
    var phi_648_: bool;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_667_: bool;
    var phi_694_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_705_: bool;
    var phi_714_: lt_math_LightPoint;
    var phi_715_: u32;
    var phi_716_: lt_math_LevelPoint;
    var phi_717_: bool;
    var phi_549_: lt_math_LightPoint;
    var phi_552_: u32;
    var phi_554_: lt_math_LevelPoint;
    var phi_718_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_765_: bool;
    var phi_847_: f32;
    var phi_963_: f32;
    var phi_964_: f32;
    var phi_967_: f32;
    var phi_996_: f32;
    var phi_1001_: f32;
    var phi_1002_: bool;
    var phi_1003_: f32;
    var phi_1004_: bool;
    var phi_1008_: f32;
    var phi_1028_: f32;
    var phi_1033_: f32;
    var phi_1034_: bool;
    var phi_1035_: f32;
    var phi_1036_: bool;
    var phi_1040_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1089_: i32;
    var phi_1094_: i32;
    var phi_1099_: i32;
    var phi_1104_: i32;
    var phi_1113_: i32;
    var phi_1118_: i32;
    var phi_1123_: i32;
    var phi_1128_: i32;
    var phi_1223_: bool;
    var phi_1231_: bool;
    var phi_1243_: bool;
    var phi_1244_: bool;
    var phi_1248_: f32;
    var phi_1254_: f32;
    var phi_1256_: evaluate_Verdict;
    var phi_1261_: evaluate_Verdict;
    var phi_1262_: evaluate_Verdict;
    var phi_1266_: bool;
    var phi_1267_: u32;
    var phi_1278_: u32;

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
                phi_425_ = (_e82 == _e84);
                phi_426_ = false;
            } else {
                phi_425_ = bool();
                phi_426_ = true;
            }
            let _e87 = phi_425_;
            let _e89 = phi_426_;
            phi_427_ = _e87;
            phi_428_ = _e89;
        } else {
            phi_427_ = bool();
            phi_428_ = true;
        }
        let _e91 = phi_427_;
        let _e93 = phi_428_;
        if _e93 {
            phi_432_ = false;
        } else {
            phi_432_ = _e91;
        }
        let _e95 = phi_432_;
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
                    phi_503_ = true;
                } else {
                    let _e148 = p.member.light.range_squared;
                    if (_e131 <= _e148) {
                        let _e151 = p.member.light.cos_outer;
                        phi_502_ = (-((((_e113 * _e133.x) + (_e114 * _e133.y)) + (_e115 * _e133.z))) >= (_e151 * sqrt(_e131)));
                    } else {
                        phi_502_ = false;
                    }
                    let _e156 = phi_502_;
                    phi_503_ = _e156;
                }
                let _e158 = phi_503_;
                if _e158 {
                    let _e160 = samples.member[_e61.first_primitive].flags;
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
                    phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, ((_e160 & 1u) == 0u));
                    phi_515_ = false;
                } else {
                    phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_515_ = true;
                }
                let _e179 = phi_514_;
                let _e181 = phi_515_;
                phi_516_ = _e179;
                phi_517_ = _e181;
            } else {
                phi_516_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_517_ = true;
            }
            let _e183 = phi_516_;
            let _e185 = phi_517_;
            if _e185 {
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                phi_524_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, true);
            } else {
                phi_524_ = _e183;
            }
            let _e202 = phi_524_;
            phi_528_ = _e202;
        } else {
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e208.unnamed.visibility, false), _e208.unnamed_1);
            phi_528_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e214.unnamed, true);
        }
        let _e219 = phi_528_;
        if _e219.unnamed_1 {
            phi_1262_ = evaluate_Verdict(_e219.unnamed.visibility, _e219.unnamed.is_doubted);
        } else {
            let _e227 = samples.member[_e61.first_primitive].position;
            let _e229 = p.member.map_size;
            let _e231 = (0.5f / f32(_e229));
            let _e238 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e245 = lt_math_LightPoint(vec2<f32>(_e238.uv.x, 0f), _e238.depth, _e238.is_inside);
            let _e249 = lt_math_LightPoint(_e245.uv, 0f, _e245.is_inside);
            phi_548_ = lt_math_LightPoint();
            phi_551_ = 0u;
            phi_553_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e249.uv, _e249.depth, false));
            loop {
                let _e256 = phi_548_;
                let _e258 = phi_551_;
                let _e260 = phi_553_;
                local_2 = _e260;
                local_3 = _e260;
                local_4 = _e260;
                if (_e258 < _e68) {
                    if _e260.point.is_inside {
                        phi_714_ = lt_math_LightPoint();
                        phi_715_ = u32();
                        phi_716_ = lt_math_LevelPoint();
                        phi_717_ = false;
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
                                phi_639_ = (_e296 <= 1f);
                            } else {
                                phi_639_ = false;
                            }
                            let _e328 = phi_639_;
                            if _e328 {
                                if (_e310 >= 0f) {
                                    phi_648_ = (_e310 <= 1f);
                                } else {
                                    phi_648_ = false;
                                }
                                let _e332 = phi_648_;
                                if _e332 {
                                    if (_e323 >= 0f) {
                                        phi_657_ = (_e323 <= 1f);
                                    } else {
                                        phi_657_ = false;
                                    }
                                    let _e336 = phi_657_;
                                    phi_658_ = _e336;
                                    phi_659_ = false;
                                } else {
                                    phi_658_ = bool();
                                    phi_659_ = true;
                                }
                                let _e338 = phi_658_;
                                let _e340 = phi_659_;
                                phi_660_ = _e338;
                                phi_661_ = _e340;
                            } else {
                                phi_660_ = bool();
                                phi_661_ = true;
                            }
                            let _e342 = phi_660_;
                            let _e344 = phi_661_;
                            phi_662_ = _e342;
                            phi_663_ = _e344;
                        } else {
                            phi_662_ = bool();
                            phi_663_ = true;
                        }
                        let _e346 = phi_662_;
                        let _e348 = phi_663_;
                        if _e348 {
                            phi_667_ = false;
                        } else {
                            phi_667_ = _e346;
                        }
                        let _e350 = phi_667_;
                        if _e350 {
                            if (_e296 >= _e231) {
                                if (_e296 <= (1f - _e231)) {
                                    if (_e310 >= _e231) {
                                        phi_694_ = (_e310 <= (1f - _e231));
                                        phi_695_ = false;
                                    } else {
                                        phi_694_ = bool();
                                        phi_695_ = true;
                                    }
                                    let _e358 = phi_694_;
                                    let _e360 = phi_695_;
                                    phi_696_ = _e358;
                                    phi_697_ = _e360;
                                } else {
                                    phi_696_ = bool();
                                    phi_697_ = true;
                                }
                                let _e362 = phi_696_;
                                let _e364 = phi_697_;
                                phi_698_ = _e362;
                                phi_699_ = _e364;
                            } else {
                                phi_698_ = bool();
                                phi_699_ = true;
                            }
                            let _e366 = phi_698_;
                            let _e368 = phi_699_;
                            phi_700_ = _e366;
                            phi_701_ = _e368;
                        } else {
                            phi_700_ = bool();
                            phi_701_ = true;
                        }
                        let _e370 = phi_700_;
                        let _e372 = phi_701_;
                        if _e372 {
                            phi_705_ = false;
                        } else {
                            phi_705_ = _e370;
                        }
                        let _e374 = phi_705_;
                        let _e381 = lt_math_LightPoint(vec2<f32>(_e296, _e256.uv.y), _e256.depth, _e256.is_inside);
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e381.uv.x, _e310), _e381.depth, _e381.is_inside);
                        let _e392 = lt_math_LightPoint(_e388.uv, _e323, _e388.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e392.depth, _e374);
                        phi_714_ = _e396;
                        phi_715_ = (_e258 + 1u);
                        phi_716_ = lt_math_LevelPoint(_e258, _e396);
                        phi_717_ = true;
                    }
                    let _e400 = phi_714_;
                    let _e402 = phi_715_;
                    let _e404 = phi_716_;
                    let _e406 = phi_717_;
                    phi_549_ = _e400;
                    phi_552_ = _e402;
                    phi_554_ = _e404;
                    phi_718_ = _e406;
                } else {
                    phi_549_ = lt_math_LightPoint();
                    phi_552_ = u32();
                    phi_554_ = lt_math_LevelPoint();
                    phi_718_ = false;
                }
                let _e408 = phi_549_;
                let _e410 = phi_552_;
                let _e412 = phi_554_;
                let _e414 = phi_718_;
                continue;
                continuing {
                    phi_548_ = _e408;
                    phi_551_ = _e410;
                    phi_553_ = _e412;
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
                            phi_758_ = (_e428.row_w.z == _e440);
                            phi_759_ = false;
                        } else {
                            phi_758_ = bool();
                            phi_759_ = true;
                        }
                        let _e443 = phi_758_;
                        let _e445 = phi_759_;
                        phi_760_ = _e443;
                        phi_761_ = _e445;
                    } else {
                        phi_760_ = bool();
                        phi_761_ = true;
                    }
                    let _e447 = phi_760_;
                    let _e449 = phi_761_;
                    if _e449 {
                        phi_765_ = false;
                    } else {
                        phi_765_ = _e447;
                    }
                    let _e451 = phi_765_;
                    if _e451 {
                        let _e453 = samples.member[_e61.first_primitive].normal;
                        let _e455 = p.member.map_size;
                        let _e525 = ((abs(((((_e428.row_x.x * _e453.x) + (_e428.row_x.y * _e453.y)) + (_e428.row_x.z * _e453.z)) / (((_e428.row_x.x * _e428.row_x.x) + (_e428.row_x.y * _e428.row_x.y)) + (_e428.row_x.z * _e428.row_x.z)))) + abs(((((_e428.row_y.x * _e453.x) + (_e428.row_y.y * _e453.y)) + (_e428.row_y.z * _e453.z)) / (((_e428.row_y.x * _e428.row_y.x) + (_e428.row_y.y * _e428.row_y.y)) + (_e428.row_y.z * _e428.row_y.z))))) / (abs(((((_e428.row_z.x * _e453.x) + (_e428.row_z.y * _e453.y)) + (_e428.row_z.z * _e453.z)) / (((_e428.row_z.x * _e428.row_z.x) + (_e428.row_z.y * _e428.row_z.y)) + (_e428.row_z.z * _e428.row_z.z)))) * f32(_e455)));
                        if (_e525 < 0.002f) {
                            phi_847_ = _e525;
                        } else {
                            phi_847_ = 0.002f;
                        }
                        let _e528 = phi_847_;
                        phi_964_ = _e528;
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
                        if (_e642 < 0.002f) {
                            phi_963_ = _e642;
                        } else {
                            phi_963_ = 0.002f;
                        }
                        let _e645 = phi_963_;
                        phi_964_ = _e645;
                    }
                    let _e647 = phi_964_;
                    phi_967_ = (_e417.point.depth - (0f * _e647));
                } else {
                    phi_967_ = _e417.point.depth;
                }
                let _e651 = phi_967_;
                let _e657 = p.member.map_size;
                let _e658 = f32(_e657);
                let _e661 = ((_e417.point.uv.x * _e658) - 0.5f);
                let _e662 = ((_e417.point.uv.y * _e658) - 0.5f);
                if (_e661 > -8388608f) {
                    let _e674 = f32(select(0i, select(select(i32(_e661), i32(-2147483648), (_e661 < bitcast<f32>(3472883712u))), 2147483647i, (_e661 > bitcast<f32>(1325400063u))), (_e661 == _e661)));
                    if (_e674 > _e661) {
                        phi_996_ = 1f;
                    } else {
                        phi_996_ = 0f;
                    }
                    let _e677 = phi_996_;
                    if (_e661 < 8388608f) {
                        phi_1001_ = (_e674 - _e677);
                        phi_1002_ = false;
                    } else {
                        phi_1001_ = f32();
                        phi_1002_ = true;
                    }
                    let _e680 = phi_1001_;
                    let _e682 = phi_1002_;
                    phi_1003_ = _e680;
                    phi_1004_ = _e682;
                } else {
                    phi_1003_ = f32();
                    phi_1004_ = true;
                }
                let _e684 = phi_1003_;
                let _e686 = phi_1004_;
                if _e686 {
                    phi_1008_ = _e661;
                } else {
                    phi_1008_ = _e684;
                }
                let _e688 = phi_1008_;
                if (_e662 > -8388608f) {
                    let _e700 = f32(select(0i, select(select(i32(_e662), i32(-2147483648), (_e662 < bitcast<f32>(3472883712u))), 2147483647i, (_e662 > bitcast<f32>(1325400063u))), (_e662 == _e662)));
                    if (_e700 > _e662) {
                        phi_1028_ = 1f;
                    } else {
                        phi_1028_ = 0f;
                    }
                    let _e703 = phi_1028_;
                    if (_e662 < 8388608f) {
                        phi_1033_ = (_e700 - _e703);
                        phi_1034_ = false;
                    } else {
                        phi_1033_ = f32();
                        phi_1034_ = true;
                    }
                    let _e706 = phi_1033_;
                    let _e708 = phi_1034_;
                    phi_1035_ = _e706;
                    phi_1036_ = _e708;
                } else {
                    phi_1035_ = f32();
                    phi_1036_ = true;
                }
                let _e710 = phi_1035_;
                let _e712 = phi_1036_;
                if _e712 {
                    phi_1040_ = _e662;
                } else {
                    phi_1040_ = _e710;
                }
                let _e714 = phi_1040_;
                let _e715 = (_e661 - _e688);
                let _e716 = (_e662 - _e714);
                let _e725 = select(0i, select(select(i32(_e688), i32(-2147483648), (_e688 < bitcast<f32>(3472883712u))), 2147483647i, (_e688 > bitcast<f32>(1325400063u))), (_e688 == _e688));
                let _e734 = select(0i, select(select(i32(_e714), i32(-2147483648), (_e714 < bitcast<f32>(3472883712u))), 2147483647i, (_e714 > bitcast<f32>(1325400063u))), (_e714 == _e714));
                let _e737 = ((1f - _e715) * (1f - _e716));
                let _e739 = (_e715 * (1f - _e716));
                let _e741 = ((1f - _e715) * _e716);
                let _e742 = (_e715 * _e716);
                let _e744 = p.member.test;
                let _e745 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e744);
                let _e747 = p.member.map_size;
                let _e749 = local_4;
                local_1 = _e745;
                let _e752 = ((_e749.level * _e747) * _e747);
                let _e754 = (bitcast<i32>(_e747) - 1i);
                if (_e725 > 0i) {
                    phi_1089_ = _e725;
                } else {
                    phi_1089_ = 0i;
                }
                let _e757 = phi_1089_;
                if (_e734 > 0i) {
                    phi_1094_ = _e734;
                } else {
                    phi_1094_ = 0i;
                }
                let _e760 = phi_1094_;
                if (_e757 < _e754) {
                    phi_1099_ = _e757;
                } else {
                    phi_1099_ = _e754;
                }
                let _e763 = phi_1099_;
                if (_e760 < _e754) {
                    phi_1104_ = _e760;
                } else {
                    phi_1104_ = _e754;
                }
                let _e766 = phi_1104_;
                let _e767 = bitcast<u32>(_e763);
                let _e769 = (_e725 + 1i);
                let _e770 = (_e734 + 1i);
                if (_e769 > 0i) {
                    phi_1113_ = _e769;
                } else {
                    phi_1113_ = 0i;
                }
                let _e773 = phi_1113_;
                if (_e770 > 0i) {
                    phi_1118_ = _e770;
                } else {
                    phi_1118_ = 0i;
                }
                let _e776 = phi_1118_;
                if (_e773 < _e754) {
                    phi_1123_ = _e773;
                } else {
                    phi_1123_ = _e754;
                }
                let _e779 = phi_1123_;
                if (_e776 < _e754) {
                    phi_1128_ = _e776;
                } else {
                    phi_1128_ = _e754;
                }
                let _e782 = phi_1128_;
                let _e783 = bitcast<u32>(_e779);
                let _e785 = (bitcast<u32>(_e766) * _e747);
                let _e786 = (bitcast<u32>(_e782) * _e747);
                let _e791 = ((_e785 + _e767) + _e752);
                let _e792 = ((_e785 + _e783) + _e752);
                let _e793 = ((_e786 + _e767) + _e752);
                let _e794 = ((_e786 + _e783) + _e752);
                if (_e791 < _e50) {
                } else {
                    return;
                }
                let _e798 = map.member[(0u + _e791)];
                if (_e792 < _e50) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e792)];
                if (_e793 < _e50) {
                } else {
                    return;
                }
                let _e826 = map.member[(0u + _e793)];
                if (_e794 < _e50) {
                } else {
                    return;
                }
                let _e842 = map.member[(0u + _e794)];
                let _e856 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e798.x * _e737) + (_e810.x * _e739)) + (_e826.x * _e741)) + (_e842.x * _e742)), ((((_e798.y * _e737) + (_e810.y * _e739)) + (_e826.y * _e741)) + (_e842.y * _e742)), ((((_e798.z * _e737) + (_e810.z * _e739)) + (_e826.z * _e741)) + (_e842.z * _e742)), ((((_e798.w * _e737) + (_e810.w * _e739)) + (_e826.w * _e741)) + (_e842.w * _e742))), _e651);
                let _e858 = p.member.epsilon;
                if (_e856 <= _e858) {
                    phi_1223_ = true;
                } else {
                    phi_1223_ = (_e856 >= (1f - _e858));
                }
                let _e863 = phi_1223_;
                if ((bitcast<u32>(_e856) & 2147483647u) > 2139095040u) {
                    phi_1231_ = true;
                } else {
                    phi_1231_ = !(_e863);
                }
                let _e869 = phi_1231_;
                if _e869 {
                    if (_e856 > 0f) {
                        if (_e856 < 1f) {
                            phi_1243_ = false;
                        } else {
                            phi_1243_ = true;
                        }
                        let _e873 = phi_1243_;
                        phi_1244_ = _e873;
                    } else {
                        phi_1244_ = true;
                    }
                    let _e875 = phi_1244_;
                    if _e875 {
                        phi_1248_ = 0.5f;
                    } else {
                        phi_1248_ = _e856;
                    }
                    let _e877 = phi_1248_;
                    phi_1256_ = evaluate_Verdict(_e877, true);
                } else {
                    if (_e856 > 0.5f) {
                        phi_1254_ = 1f;
                    } else {
                        phi_1254_ = 0f;
                    }
                    let _e881 = phi_1254_;
                    phi_1256_ = evaluate_Verdict(_e881, false);
                }
                let _e884 = phi_1256_;
                phi_1261_ = evaluate_Verdict(_e884.visibility, _e884.is_doubted);
            } else {
                phi_1261_ = evaluate_Verdict(0.5f, true);
            }
            let _e890 = phi_1261_;
            phi_1262_ = _e890;
        }
        let _e892 = phi_1262_;
        visibility.member[_e61.first_primitive] = _e892.visibility;
        phi_1266_ = _e892.is_doubted;
        phi_1267_ = _e61.first_primitive;
    } else {
        phi_1266_ = false;
        phi_1267_ = 0u;
    }
    let _e897 = phi_1266_;
    let _e899 = phi_1267_;
    if (_e45 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e897 {
        let _e903 = atomicAdd((&shared_[0u]), 1u);
        phi_1278_ = _e903;
    } else {
        phi_1278_ = 0u;
    }
    let _e905 = phi_1278_;
    workgroupBarrier();
    if (_e45 == 0u) {
        let _e909 = atomicLoad((&shared_[0u]));
        let _e910 = atomicAdd((&list.member[3u]), _e909);
        atomicStore((&shared_[1u]), _e910);
    }
    workgroupBarrier();
    if _e897 {
        let _e913 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e913) + _e905)]), _e899);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
