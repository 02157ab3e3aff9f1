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
var<storage> levels: type_49;
@group(0) @binding(2) 
var<storage> map: type_39;

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
        let _e57 = phi_166_;
        let _e59 = phi_167_;
        phi_168_ = _e57;
        phi_169_ = _e59;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e61 = phi_168_;
    let _e63 = phi_169_;
    if _e63 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e61;
    }
    let _e68 = phi_174_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_231_: bool;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: bool;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_297_: vec2<f32>;
    var phi_331_: f32;
    var phi_332_: f32;
    var phi_333_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_364_: f32;
    var phi_368_: f32;
    var phi_369_: f32;
    var phi_370_: f32;
    var phi_371_: f32;

    let _e47 = (*param_4);
    let _e48 = (1f - _e47);
    let _e57 = (0.5f * _e47);
    let _e58 = ((param_5.x * _e48) + _e57);
    let _e59 = ((param_5.y * _e48) + _e57);
    let _e61 = ((param_5.w * _e48) + _e57);
    let _e63 = (_e59 - (_e58 * _e58));
    let _e65 = (((param_5.z * _e48) + _e57) - (_e58 * _e59));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_225_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_224_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_223_ = 1f;
            } else {
                phi_223_ = param_6;
            }
            let _e77 = phi_223_;
            phi_224_ = _e77;
        }
        let _e79 = phi_224_;
        phi_225_ = _e79;
    }
    let _e81 = phi_225_;
    if (_e58 == _e61) {
        phi_231_ = (_e58 > 0.5f);
    } else {
        phi_231_ = false;
    }
    let _e85 = phi_231_;
    if _e85 {
        if (_e81 > 0f) {
            if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
                phi_255_ = _e58;
            } else {
                if (_e58 < 0f) {
                    phi_254_ = 0f;
                } else {
                    if (_e58 > 1f) {
                        phi_253_ = 1f;
                    } else {
                        phi_253_ = _e58;
                    }
                    let _e93 = phi_253_;
                    phi_254_ = _e93;
                }
                let _e95 = phi_254_;
                phi_255_ = _e95;
            }
            let _e97 = phi_255_;
            phi_256_ = _e97;
            phi_257_ = false;
        } else {
            phi_256_ = f32();
            phi_257_ = true;
        }
        let _e99 = phi_256_;
        let _e101 = phi_257_;
        phi_258_ = _e99;
        phi_259_ = _e101;
    } else {
        phi_258_ = f32();
        phi_259_ = true;
    }
    let _e103 = phi_258_;
    let _e105 = phi_259_;
    if _e105 {
        let _e106 = (_e65 / _e63);
        let _e107 = (_e81 - _e58);
        let _e113 = (((((_e81 * _e81) - _e59) - (_e106 * _e107)) * _e63) / (((_e61 - (_e59 * _e59)) * _e63) - (_e65 * _e65)));
        let _e116 = ((_e107 / _e63) - (_e106 * _e113));
        let _e122 = ((0.5f * _e116) / _e113);
        let _e125 = ((_e122 * _e122) - (((1f - (_e116 * _e58)) - (_e113 * _e59)) / _e113));
        if (_e125 >= 0f) {
            let _e127 = sqrt(_e125);
            phi_297_ = vec2<f32>((-(_e122) - _e127), (-(_e122) + _e127));
        } else {
            phi_297_ = vec2(bitcast<f32>((bitcast<u32>(_e125) | 2143289344u)));
        }
        let _e138 = phi_297_;
        if (_e81 <= _e138.x) {
            phi_370_ = 1f;
        } else {
            if (_e81 > _e138.y) {
                let _e151 = (((_e59 - (_e58 * (_e138.x + _e138.y))) + (_e138.x * _e138.y)) / ((_e81 - _e138.x) * (_e81 - _e138.y)));
                if ((bitcast<u32>(_e151) & 2147483647u) > 2139095040u) {
                    phi_333_ = _e151;
                } else {
                    if (_e151 < 0f) {
                        phi_332_ = 0f;
                    } else {
                        if (_e151 > 1f) {
                            phi_331_ = 1f;
                        } else {
                            phi_331_ = _e151;
                        }
                        let _e158 = phi_331_;
                        phi_332_ = _e158;
                    }
                    let _e160 = phi_332_;
                    phi_333_ = _e160;
                }
                let _e162 = phi_333_;
                phi_369_ = _e162;
            } else {
                if (_e81 > _e138.x) {
                    let _e173 = (1f - (((_e59 - (_e58 * (_e81 + _e138.y))) + (_e81 * _e138.y)) / ((_e138.x - _e81) * (_e138.x - _e138.y))));
                    if ((bitcast<u32>(_e173) & 2147483647u) > 2139095040u) {
                        phi_364_ = _e173;
                    } else {
                        if (_e173 < 0f) {
                            phi_363_ = 0f;
                        } else {
                            if (_e173 > 1f) {
                                phi_362_ = 1f;
                            } else {
                                phi_362_ = _e173;
                            }
                            let _e180 = phi_362_;
                            phi_363_ = _e180;
                        }
                        let _e182 = phi_363_;
                        phi_364_ = _e182;
                    }
                    let _e184 = phi_364_;
                    phi_368_ = _e184;
                } else {
                    phi_368_ = bitcast<f32>((bitcast<u32>(_e138.x) | 2143289344u));
                }
                let _e189 = phi_368_;
                phi_369_ = _e189;
            }
            let _e191 = phi_369_;
            phi_370_ = _e191;
        }
        let _e193 = phi_370_;
        phi_371_ = _e193;
    } else {
        phi_371_ = _e103;
    }
    let _e195 = phi_371_;
    return _e195;
}

fn function_() {
    var local_1: f32;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_433_: bool;
    var phi_503_: bool;
    var phi_504_: bool;
    var phi_515_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_516_: bool;
    var phi_517_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_518_: bool;
    var phi_525_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_529_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_549_: lt_math_LightPoint;
    var phi_552_: u32;
    var phi_554_: lt_math_LevelPoint;
    var phi_640_: bool;
    var phi_649_: bool;
    var phi_658_: bool;
    var phi_659_: bool;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_662_: bool;
    var phi_663_: bool;
    var phi_664_: bool;
    var phi_668_: bool;
    var phi_695_: bool;
    var phi_696_: bool;
    var phi_697_: bool;
    var phi_698_: bool;
    var phi_699_: bool;
    var phi_700_: bool;
    var phi_701_: bool;
    var phi_702_: bool;
    var phi_706_: bool;
    var phi_715_: lt_math_LightPoint;
    var phi_716_: u32;
    var phi_717_: lt_math_LevelPoint;
    var phi_718_: bool;
    var phi_550_: lt_math_LightPoint;
    var phi_553_: u32;
    var phi_555_: lt_math_LevelPoint;
    var phi_719_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_766_: bool;
    var phi_848_: f32;
    var phi_966_: f32;
    var phi_967_: f32;
    var phi_970_: f32;
    var phi_999_: f32;
    var phi_1004_: f32;
    var phi_1005_: bool;
    var phi_1006_: f32;
    var phi_1007_: bool;
    var phi_1011_: f32;
    var phi_1031_: f32;
    var phi_1036_: f32;
    var phi_1037_: bool;
    var phi_1038_: f32;
    var phi_1039_: bool;
    var phi_1043_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1092_: i32;
    var phi_1097_: i32;
    var phi_1102_: i32;
    var phi_1107_: i32;
    var phi_1116_: i32;
    var phi_1121_: i32;
    var phi_1126_: i32;
    var phi_1131_: i32;
    var phi_1226_: bool;
    var phi_1234_: bool;
    var phi_1246_: bool;
    var phi_1247_: bool;
    var phi_1251_: f32;
    var phi_1257_: f32;
    var phi_1259_: evaluate_Verdict;
    var phi_1264_: evaluate_Verdict;
    var phi_1265_: evaluate_Verdict;
    var phi_1269_: bool;
    var phi_1270_: u32;
    var phi_1281_: u32;

    let _e45 = id_1;
    let _e46 = local_5;
    let _e51 = arrayLength((&map.member));
    let _e56 = arrayLength((&levels.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e45, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        let _e69 = p.member.level_count;
        let _e73 = samples.member[_e62.first_primitive].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[_e62.first_primitive].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[_e62.first_primitive].normal[2u];
                let _e85 = global[2u];
                phi_426_ = (_e83 == _e85);
                phi_427_ = false;
            } else {
                phi_426_ = bool();
                phi_427_ = true;
            }
            let _e88 = phi_426_;
            let _e90 = phi_427_;
            phi_428_ = _e88;
            phi_429_ = _e90;
        } else {
            phi_428_ = bool();
            phi_429_ = true;
        }
        let _e92 = phi_428_;
        let _e94 = phi_429_;
        if _e94 {
            phi_433_ = false;
        } else {
            phi_433_ = _e92;
        }
        let _e96 = phi_433_;
        if !(_e96) {
            let _e99 = samples.member[_e62.first_primitive].position;
            let _e101 = p.member.light.place;
            let _e107 = p.member.light.place[3u];
            let _e114 = (_e101.x - (_e99.x * _e107));
            let _e115 = (_e101.y - (_e99.y * _e107));
            let _e116 = (_e101.z - (_e99.z * _e107));
            let _e118 = samples.member[_e62.first_primitive].normal;
            if ((((_e118.x * _e114) + (_e118.y * _e115)) + (_e118.z * _e116)) > 0f) {
                let _e132 = (((_e114 * _e114) + (_e115 * _e115)) + (_e116 * _e116));
                let _e134 = p.member.light.axis;
                let _e146 = p.member.light.place[3u];
                if (_e146 == 0f) {
                    phi_504_ = true;
                } else {
                    let _e149 = p.member.light.range_squared;
                    if (_e132 <= _e149) {
                        let _e152 = p.member.light.cos_outer;
                        phi_503_ = (-((((_e114 * _e134.x) + (_e115 * _e134.y)) + (_e116 * _e134.z))) >= (_e152 * sqrt(_e132)));
                    } else {
                        phi_503_ = false;
                    }
                    let _e157 = phi_503_;
                    phi_504_ = _e157;
                }
                let _e159 = phi_504_;
                if _e159 {
                    let _e161 = samples.member[_e62.first_primitive].flags;
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
                    phi_515_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, ((_e161 & 1u) == 0u));
                    phi_516_ = false;
                } else {
                    phi_515_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_516_ = true;
                }
                let _e180 = phi_515_;
                let _e182 = phi_516_;
                phi_517_ = _e180;
                phi_518_ = _e182;
            } else {
                phi_517_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_518_ = true;
            }
            let _e184 = phi_517_;
            let _e186 = phi_518_;
            if _e186 {
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e192.unnamed.visibility, false), _e192.unnamed_1);
                phi_525_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e198.unnamed, true);
            } else {
                phi_525_ = _e184;
            }
            let _e203 = phi_525_;
            phi_529_ = _e203;
        } else {
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e209.unnamed.visibility, false), _e209.unnamed_1);
            phi_529_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e215.unnamed, true);
        }
        let _e220 = phi_529_;
        if _e220.unnamed_1 {
            phi_1265_ = evaluate_Verdict(_e220.unnamed.visibility, _e220.unnamed.is_doubted);
        } else {
            let _e228 = samples.member[_e62.first_primitive].position;
            let _e230 = p.member.map_size;
            let _e232 = (0.5f / f32(_e230));
            let _e239 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e246 = lt_math_LightPoint(vec2<f32>(_e239.uv.x, 0f), _e239.depth, _e239.is_inside);
            let _e250 = lt_math_LightPoint(_e246.uv, 0f, _e246.is_inside);
            phi_549_ = lt_math_LightPoint();
            phi_552_ = 0u;
            phi_554_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e250.uv, _e250.depth, false));
            loop {
                let _e257 = phi_549_;
                let _e259 = phi_552_;
                let _e261 = phi_554_;
                local_2 = _e261;
                local_3 = _e261;
                local_4 = _e261;
                if (_e259 < _e69) {
                    if _e261.point.is_inside {
                        phi_715_ = lt_math_LightPoint();
                        phi_716_ = u32();
                        phi_717_ = lt_math_LevelPoint();
                        phi_718_ = false;
                    } else {
                        if (_e259 < _e56) {
                        } else {
                            return;
                        }
                        let _e272 = levels.member[(0u + _e259)].row_w;
                        let _e283 = ((((_e272.x * _e228.x) + (_e272.y * _e228.y)) + (_e272.z * _e228.z)) + (_e272.w * 1f));
                        let _e285 = levels.member[(0u + _e259)].row_x;
                        let _e297 = (((((_e285.x * _e228.x) + (_e285.y * _e228.y)) + (_e285.z * _e228.z)) + (_e285.w * 1f)) / _e283);
                        let _e299 = levels.member[(0u + _e259)].row_y;
                        let _e311 = (((((_e299.x * _e228.x) + (_e299.y * _e228.y)) + (_e299.z * _e228.z)) + (_e299.w * 1f)) / _e283);
                        let _e313 = levels.member[(0u + _e259)].row_z;
                        let _e324 = ((((_e313.x * _e228.x) + (_e313.y * _e228.y)) + (_e313.z * _e228.z)) + (_e313.w * 1f));
                        if (_e283 > 0f) {
                            if (_e297 >= 0f) {
                                phi_640_ = (_e297 <= 1f);
                            } else {
                                phi_640_ = false;
                            }
                            let _e329 = phi_640_;
                            if _e329 {
                                if (_e311 >= 0f) {
                                    phi_649_ = (_e311 <= 1f);
                                } else {
                                    phi_649_ = false;
                                }
                                let _e333 = phi_649_;
                                if _e333 {
                                    if (_e324 >= 0f) {
                                        phi_658_ = (_e324 <= 1f);
                                    } else {
                                        phi_658_ = false;
                                    }
                                    let _e337 = phi_658_;
                                    phi_659_ = _e337;
                                    phi_660_ = false;
                                } else {
                                    phi_659_ = bool();
                                    phi_660_ = true;
                                }
                                let _e339 = phi_659_;
                                let _e341 = phi_660_;
                                phi_661_ = _e339;
                                phi_662_ = _e341;
                            } else {
                                phi_661_ = bool();
                                phi_662_ = true;
                            }
                            let _e343 = phi_661_;
                            let _e345 = phi_662_;
                            phi_663_ = _e343;
                            phi_664_ = _e345;
                        } else {
                            phi_663_ = bool();
                            phi_664_ = true;
                        }
                        let _e347 = phi_663_;
                        let _e349 = phi_664_;
                        if _e349 {
                            phi_668_ = false;
                        } else {
                            phi_668_ = _e347;
                        }
                        let _e351 = phi_668_;
                        if _e351 {
                            if (_e297 >= _e232) {
                                if (_e297 <= (1f - _e232)) {
                                    if (_e311 >= _e232) {
                                        phi_695_ = (_e311 <= (1f - _e232));
                                        phi_696_ = false;
                                    } else {
                                        phi_695_ = bool();
                                        phi_696_ = true;
                                    }
                                    let _e359 = phi_695_;
                                    let _e361 = phi_696_;
                                    phi_697_ = _e359;
                                    phi_698_ = _e361;
                                } else {
                                    phi_697_ = bool();
                                    phi_698_ = true;
                                }
                                let _e363 = phi_697_;
                                let _e365 = phi_698_;
                                phi_699_ = _e363;
                                phi_700_ = _e365;
                            } else {
                                phi_699_ = bool();
                                phi_700_ = true;
                            }
                            let _e367 = phi_699_;
                            let _e369 = phi_700_;
                            phi_701_ = _e367;
                            phi_702_ = _e369;
                        } else {
                            phi_701_ = bool();
                            phi_702_ = true;
                        }
                        let _e371 = phi_701_;
                        let _e373 = phi_702_;
                        if _e373 {
                            phi_706_ = false;
                        } else {
                            phi_706_ = _e371;
                        }
                        let _e375 = phi_706_;
                        let _e382 = lt_math_LightPoint(vec2<f32>(_e297, _e257.uv.y), _e257.depth, _e257.is_inside);
                        let _e389 = lt_math_LightPoint(vec2<f32>(_e382.uv.x, _e311), _e382.depth, _e382.is_inside);
                        let _e393 = lt_math_LightPoint(_e389.uv, _e324, _e389.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e393.depth, _e375);
                        phi_715_ = _e397;
                        phi_716_ = (_e259 + 1u);
                        phi_717_ = lt_math_LevelPoint(_e259, _e397);
                        phi_718_ = true;
                    }
                    let _e401 = phi_715_;
                    let _e403 = phi_716_;
                    let _e405 = phi_717_;
                    let _e407 = phi_718_;
                    phi_550_ = _e401;
                    phi_553_ = _e403;
                    phi_555_ = _e405;
                    phi_719_ = _e407;
                } else {
                    phi_550_ = lt_math_LightPoint();
                    phi_553_ = u32();
                    phi_555_ = lt_math_LevelPoint();
                    phi_719_ = false;
                }
                let _e409 = phi_550_;
                let _e411 = phi_553_;
                let _e413 = phi_555_;
                let _e415 = phi_719_;
                continue;
                continuing {
                    phi_549_ = _e409;
                    phi_552_ = _e411;
                    phi_554_ = _e413;
                    break if !(_e415);
                }
            }
            let _e418 = local_2;
            if _e418.point.is_inside {
                if (0f > 0f) {
                    let _e424 = local_3;
                    if (_e424.level < _e56) {
                    } else {
                        return;
                    }
                    let _e429 = levels.member[(0u + _e424.level)];
                    let _e435 = global[0u];
                    if (_e429.row_w.x == _e435) {
                        let _e438 = global[1u];
                        if (_e429.row_w.y == _e438) {
                            let _e441 = global[2u];
                            phi_759_ = (_e429.row_w.z == _e441);
                            phi_760_ = false;
                        } else {
                            phi_759_ = bool();
                            phi_760_ = true;
                        }
                        let _e444 = phi_759_;
                        let _e446 = phi_760_;
                        phi_761_ = _e444;
                        phi_762_ = _e446;
                    } else {
                        phi_761_ = bool();
                        phi_762_ = true;
                    }
                    let _e448 = phi_761_;
                    let _e450 = phi_762_;
                    if _e450 {
                        phi_766_ = false;
                    } else {
                        phi_766_ = _e448;
                    }
                    let _e452 = phi_766_;
                    if _e452 {
                        let _e454 = samples.member[_e62.first_primitive].normal;
                        let _e456 = p.member.map_size;
                        let _e526 = ((abs(((((_e429.row_x.x * _e454.x) + (_e429.row_x.y * _e454.y)) + (_e429.row_x.z * _e454.z)) / (((_e429.row_x.x * _e429.row_x.x) + (_e429.row_x.y * _e429.row_x.y)) + (_e429.row_x.z * _e429.row_x.z)))) + abs(((((_e429.row_y.x * _e454.x) + (_e429.row_y.y * _e454.y)) + (_e429.row_y.z * _e454.z)) / (((_e429.row_y.x * _e429.row_y.x) + (_e429.row_y.y * _e429.row_y.y)) + (_e429.row_y.z * _e429.row_y.z))))) / (abs(((((_e429.row_z.x * _e454.x) + (_e429.row_z.y * _e454.y)) + (_e429.row_z.z * _e454.z)) / (((_e429.row_z.x * _e429.row_z.x) + (_e429.row_z.y * _e429.row_z.y)) + (_e429.row_z.z * _e429.row_z.z)))) * f32(_e456)));
                        if (_e526 < 0.002f) {
                            phi_848_ = _e526;
                        } else {
                            phi_848_ = 0.002f;
                        }
                        let _e529 = phi_848_;
                        phi_967_ = _e529;
                    } else {
                        let _e531 = p.member.map_size;
                        let _e537 = samples.member[_e62.first_primitive].position;
                        let _e548 = ((((_e429.row_w.x * _e537.x) + (_e429.row_w.y * _e537.y)) + (_e429.row_w.z * _e537.z)) + _e429.row_w.w);
                        let _e561 = ((_e429.row_x.x - (_e429.row_w.x * _e418.point.uv.x)) / _e548);
                        let _e562 = ((_e429.row_x.y - (_e429.row_w.y * _e418.point.uv.x)) / _e548);
                        let _e563 = ((_e429.row_x.z - (_e429.row_w.z * _e418.point.uv.x)) / _e548);
                        let _e576 = ((_e429.row_y.x - (_e429.row_w.x * _e418.point.uv.y)) / _e548);
                        let _e577 = ((_e429.row_y.y - (_e429.row_w.y * _e418.point.uv.y)) / _e548);
                        let _e578 = ((_e429.row_y.z - (_e429.row_w.z * _e418.point.uv.y)) / _e548);
                        let _e584 = samples.member[_e62.first_primitive].normal;
                        let _e589 = ((_e577 * _e584.z) - (_e584.y * _e578));
                        let _e594 = ((_e578 * _e584.x) - (_e584.z * _e576));
                        let _e599 = ((_e576 * _e584.y) - (_e584.x * _e577));
                        let _e601 = samples.member[_e62.first_primitive].normal;
                        let _e606 = ((_e562 * _e601.z) - (_e601.y * _e563));
                        let _e611 = ((_e563 * _e601.x) - (_e601.z * _e561));
                        let _e616 = ((_e561 * _e601.y) - (_e601.x * _e562));
                        let _e643 = ((abs(((((_e429.row_z.x * _e589) + (_e429.row_z.y * _e594)) + (_e429.row_z.z * _e599)) / (((_e561 * _e589) + (_e562 * _e594)) + (_e563 * _e599)))) + abs(((((_e429.row_z.x * _e606) + (_e429.row_z.y * _e611)) + (_e429.row_z.z * _e616)) / (((_e576 * _e606) + (_e577 * _e611)) + (_e578 * _e616))))) / f32(_e531));
                        let _e645 = (16f / f32(_e531));
                        if (_e643 < _e645) {
                            phi_966_ = _e643;
                        } else {
                            phi_966_ = _e645;
                        }
                        let _e648 = phi_966_;
                        phi_967_ = _e648;
                    }
                    let _e650 = phi_967_;
                    phi_970_ = (_e418.point.depth - (0f * _e650));
                } else {
                    phi_970_ = _e418.point.depth;
                }
                let _e654 = phi_970_;
                let _e660 = p.member.map_size;
                let _e661 = f32(_e660);
                let _e664 = ((_e418.point.uv.x * _e661) - 0.5f);
                let _e665 = ((_e418.point.uv.y * _e661) - 0.5f);
                if (_e664 > -8388608f) {
                    let _e677 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e677 > _e664) {
                        phi_999_ = 1f;
                    } else {
                        phi_999_ = 0f;
                    }
                    let _e680 = phi_999_;
                    if (_e664 < 8388608f) {
                        phi_1004_ = (_e677 - _e680);
                        phi_1005_ = false;
                    } else {
                        phi_1004_ = f32();
                        phi_1005_ = true;
                    }
                    let _e683 = phi_1004_;
                    let _e685 = phi_1005_;
                    phi_1006_ = _e683;
                    phi_1007_ = _e685;
                } else {
                    phi_1006_ = f32();
                    phi_1007_ = true;
                }
                let _e687 = phi_1006_;
                let _e689 = phi_1007_;
                if _e689 {
                    phi_1011_ = _e664;
                } else {
                    phi_1011_ = _e687;
                }
                let _e691 = phi_1011_;
                if (_e665 > -8388608f) {
                    let _e703 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e703 > _e665) {
                        phi_1031_ = 1f;
                    } else {
                        phi_1031_ = 0f;
                    }
                    let _e706 = phi_1031_;
                    if (_e665 < 8388608f) {
                        phi_1036_ = (_e703 - _e706);
                        phi_1037_ = false;
                    } else {
                        phi_1036_ = f32();
                        phi_1037_ = true;
                    }
                    let _e709 = phi_1036_;
                    let _e711 = phi_1037_;
                    phi_1038_ = _e709;
                    phi_1039_ = _e711;
                } else {
                    phi_1038_ = f32();
                    phi_1039_ = true;
                }
                let _e713 = phi_1038_;
                let _e715 = phi_1039_;
                if _e715 {
                    phi_1043_ = _e665;
                } else {
                    phi_1043_ = _e713;
                }
                let _e717 = phi_1043_;
                let _e718 = (_e664 - _e691);
                let _e719 = (_e665 - _e717);
                let _e728 = select(0i, select(select(i32(_e691), i32(-2147483648), (_e691 < bitcast<f32>(3472883712u))), 2147483647i, (_e691 > bitcast<f32>(1325400063u))), (_e691 == _e691));
                let _e737 = select(0i, select(select(i32(_e717), i32(-2147483648), (_e717 < bitcast<f32>(3472883712u))), 2147483647i, (_e717 > bitcast<f32>(1325400063u))), (_e717 == _e717));
                let _e740 = ((1f - _e718) * (1f - _e719));
                let _e742 = (_e718 * (1f - _e719));
                let _e744 = ((1f - _e718) * _e719);
                let _e745 = (_e718 * _e719);
                let _e747 = p.member.test;
                let _e748 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_4;
                local_1 = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e728 > 0i) {
                    phi_1092_ = _e728;
                } else {
                    phi_1092_ = 0i;
                }
                let _e760 = phi_1092_;
                if (_e737 > 0i) {
                    phi_1097_ = _e737;
                } else {
                    phi_1097_ = 0i;
                }
                let _e763 = phi_1097_;
                if (_e760 < _e757) {
                    phi_1102_ = _e760;
                } else {
                    phi_1102_ = _e757;
                }
                let _e766 = phi_1102_;
                if (_e763 < _e757) {
                    phi_1107_ = _e763;
                } else {
                    phi_1107_ = _e757;
                }
                let _e769 = phi_1107_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e728 + 1i);
                let _e773 = (_e737 + 1i);
                if (_e772 > 0i) {
                    phi_1116_ = _e772;
                } else {
                    phi_1116_ = 0i;
                }
                let _e776 = phi_1116_;
                if (_e773 > 0i) {
                    phi_1121_ = _e773;
                } else {
                    phi_1121_ = 0i;
                }
                let _e779 = phi_1121_;
                if (_e776 < _e757) {
                    phi_1126_ = _e776;
                } else {
                    phi_1126_ = _e757;
                }
                let _e782 = phi_1126_;
                if (_e779 < _e757) {
                    phi_1131_ = _e779;
                } else {
                    phi_1131_ = _e757;
                }
                let _e785 = phi_1131_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e51) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e51) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e795)];
                if (_e796 < _e51) {
                } else {
                    return;
                }
                let _e829 = map.member[(0u + _e796)];
                if (_e797 < _e51) {
                } else {
                    return;
                }
                let _e845 = map.member[(0u + _e797)];
                let _e859 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e801.x * _e740) + (_e813.x * _e742)) + (_e829.x * _e744)) + (_e845.x * _e745)), ((((_e801.y * _e740) + (_e813.y * _e742)) + (_e829.y * _e744)) + (_e845.y * _e745)), ((((_e801.z * _e740) + (_e813.z * _e742)) + (_e829.z * _e744)) + (_e845.z * _e745)), ((((_e801.w * _e740) + (_e813.w * _e742)) + (_e829.w * _e744)) + (_e845.w * _e745))), _e654);
                let _e861 = p.member.epsilon;
                if (_e859 <= _e861) {
                    phi_1226_ = true;
                } else {
                    phi_1226_ = (_e859 >= (1f - _e861));
                }
                let _e866 = phi_1226_;
                if ((bitcast<u32>(_e859) & 2147483647u) > 2139095040u) {
                    phi_1234_ = true;
                } else {
                    phi_1234_ = !(_e866);
                }
                let _e872 = phi_1234_;
                if _e872 {
                    if (_e859 > 0f) {
                        if (_e859 < 1f) {
                            phi_1246_ = false;
                        } else {
                            phi_1246_ = true;
                        }
                        let _e876 = phi_1246_;
                        phi_1247_ = _e876;
                    } else {
                        phi_1247_ = true;
                    }
                    let _e878 = phi_1247_;
                    if _e878 {
                        phi_1251_ = 0.5f;
                    } else {
                        phi_1251_ = _e859;
                    }
                    let _e880 = phi_1251_;
                    phi_1259_ = evaluate_Verdict(_e880, true);
                } else {
                    if (_e859 > 0.5f) {
                        phi_1257_ = 1f;
                    } else {
                        phi_1257_ = 0f;
                    }
                    let _e884 = phi_1257_;
                    phi_1259_ = evaluate_Verdict(_e884, false);
                }
                let _e887 = phi_1259_;
                phi_1264_ = evaluate_Verdict(_e887.visibility, _e887.is_doubted);
            } else {
                phi_1264_ = evaluate_Verdict(0.5f, true);
            }
            let _e893 = phi_1264_;
            phi_1265_ = _e893;
        }
        let _e895 = phi_1265_;
        visibility.member[_e62.first_primitive] = _e895.visibility;
        phi_1269_ = _e895.is_doubted;
        phi_1270_ = _e62.first_primitive;
    } else {
        phi_1269_ = false;
        phi_1270_ = 0u;
    }
    let _e900 = phi_1269_;
    let _e902 = phi_1270_;
    if (_e46 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e900 {
        let _e906 = atomicAdd((&shared_[0u]), 1u);
        phi_1281_ = _e906;
    } else {
        phi_1281_ = 0u;
    }
    let _e908 = phi_1281_;
    workgroupBarrier();
    if (_e46 == 0u) {
        let _e912 = atomicLoad((&shared_[0u]));
        let _e913 = atomicAdd((&list.member[3u]), _e912);
        atomicStore((&shared_[1u]), _e913);
    }
    workgroupBarrier();
    if _e900 {
        let _e916 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e916) + _e908)]), _e902);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
