struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_23 {
    member: array<abi_Sample>,
}

struct type_27 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct type_36 {
    member: array<vec4<f32>>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_40 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct type_48 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_23;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_40;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_27;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_48;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_155_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_147_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_148_ = false;
        } else {
            phi_147_ = lt_bvh_traverse_Tree();
            phi_148_ = true;
        }
        let _e50 = phi_147_;
        let _e52 = phi_148_;
        phi_149_ = _e50;
        phi_150_ = _e52;
    } else {
        phi_149_ = lt_bvh_traverse_Tree();
        phi_150_ = true;
    }
    let _e54 = phi_149_;
    let _e56 = phi_150_;
    if _e56 {
        phi_155_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_155_ = _e54;
    }
    let _e61 = phi_155_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_212_: bool;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: bool;
    var phi_239_: f32;
    var phi_240_: bool;
    var phi_278_: vec2<f32>;
    var phi_312_: f32;
    var phi_313_: f32;
    var phi_314_: f32;
    var phi_343_: f32;
    var phi_344_: f32;
    var phi_345_: f32;
    var phi_349_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_352_: f32;

    let _e40 = (*param_4);
    let _e41 = (1f - _e40);
    let _e50 = (0.5f * _e40);
    let _e51 = ((param_5.x * _e41) + _e50);
    let _e52 = ((param_5.y * _e41) + _e50);
    let _e54 = ((param_5.w * _e41) + _e50);
    let _e56 = (_e52 - (_e51 * _e51));
    let _e58 = (((param_5.z * _e41) + _e50) - (_e51 * _e52));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_206_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_6;
            }
            let _e70 = phi_204_;
            phi_205_ = _e70;
        }
        let _e72 = phi_205_;
        phi_206_ = _e72;
    }
    let _e74 = phi_206_;
    if (_e51 == _e54) {
        phi_212_ = (_e51 > 0.5f);
    } else {
        phi_212_ = false;
    }
    let _e78 = phi_212_;
    if _e78 {
        if (_e74 > 0f) {
            if ((bitcast<u32>(_e51) & 2147483647u) > 2139095040u) {
                phi_236_ = _e51;
            } else {
                if (_e51 < 0f) {
                    phi_235_ = 0f;
                } else {
                    if (_e51 > 1f) {
                        phi_234_ = 1f;
                    } else {
                        phi_234_ = _e51;
                    }
                    let _e86 = phi_234_;
                    phi_235_ = _e86;
                }
                let _e88 = phi_235_;
                phi_236_ = _e88;
            }
            let _e90 = phi_236_;
            phi_237_ = _e90;
            phi_238_ = false;
        } else {
            phi_237_ = f32();
            phi_238_ = true;
        }
        let _e92 = phi_237_;
        let _e94 = phi_238_;
        phi_239_ = _e92;
        phi_240_ = _e94;
    } else {
        phi_239_ = f32();
        phi_240_ = true;
    }
    let _e96 = phi_239_;
    let _e98 = phi_240_;
    if _e98 {
        let _e99 = (_e58 / _e56);
        let _e100 = (_e74 - _e51);
        let _e106 = (((((_e74 * _e74) - _e52) - (_e99 * _e100)) * _e56) / (((_e54 - (_e52 * _e52)) * _e56) - (_e58 * _e58)));
        let _e109 = ((_e100 / _e56) - (_e99 * _e106));
        let _e115 = ((0.5f * _e109) / _e106);
        let _e118 = ((_e115 * _e115) - (((1f - (_e109 * _e51)) - (_e106 * _e52)) / _e106));
        if (_e118 >= 0f) {
            let _e120 = sqrt(_e118);
            phi_278_ = vec2<f32>((-(_e115) - _e120), (-(_e115) + _e120));
        } else {
            phi_278_ = vec2(bitcast<f32>((bitcast<u32>(_e118) | 2143289344u)));
        }
        let _e131 = phi_278_;
        if (_e74 <= _e131.x) {
            phi_351_ = 1f;
        } else {
            if (_e74 > _e131.y) {
                let _e144 = (((_e52 - (_e51 * (_e131.x + _e131.y))) + (_e131.x * _e131.y)) / ((_e74 - _e131.x) * (_e74 - _e131.y)));
                if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
                    phi_314_ = _e144;
                } else {
                    if (_e144 < 0f) {
                        phi_313_ = 0f;
                    } else {
                        if (_e144 > 1f) {
                            phi_312_ = 1f;
                        } else {
                            phi_312_ = _e144;
                        }
                        let _e151 = phi_312_;
                        phi_313_ = _e151;
                    }
                    let _e153 = phi_313_;
                    phi_314_ = _e153;
                }
                let _e155 = phi_314_;
                phi_350_ = _e155;
            } else {
                if (_e74 > _e131.x) {
                    let _e166 = (1f - (((_e52 - (_e51 * (_e74 + _e131.y))) + (_e74 * _e131.y)) / ((_e131.x - _e74) * (_e131.x - _e131.y))));
                    if ((bitcast<u32>(_e166) & 2147483647u) > 2139095040u) {
                        phi_345_ = _e166;
                    } else {
                        if (_e166 < 0f) {
                            phi_344_ = 0f;
                        } else {
                            if (_e166 > 1f) {
                                phi_343_ = 1f;
                            } else {
                                phi_343_ = _e166;
                            }
                            let _e173 = phi_343_;
                            phi_344_ = _e173;
                        }
                        let _e175 = phi_344_;
                        phi_345_ = _e175;
                    }
                    let _e177 = phi_345_;
                    phi_349_ = _e177;
                } else {
                    phi_349_ = bitcast<f32>((bitcast<u32>(_e131.x) | 2143289344u));
                }
                let _e182 = phi_349_;
                phi_350_ = _e182;
            }
            let _e184 = phi_350_;
            phi_351_ = _e184;
        }
        let _e186 = phi_351_;
        phi_352_ = _e186;
    } else {
        phi_352_ = _e96;
    }
    let _e188 = phi_352_;
    return _e188;
}

fn function_() {
    var local_1: f32;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_413_: bool;
    var phi_457_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_461_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_538_: bool;
    var phi_547_: bool;
    var phi_556_: bool;
    var phi_557_: bool;
    var phi_558_: bool;
    var phi_559_: bool;
    var phi_560_: bool;
    var phi_561_: bool;
    var phi_562_: bool;
    var phi_566_: bool;
    var phi_602_: f32;
    var phi_607_: f32;
    var phi_608_: bool;
    var phi_609_: f32;
    var phi_610_: bool;
    var phi_614_: f32;
    var phi_634_: f32;
    var phi_639_: f32;
    var phi_640_: bool;
    var phi_641_: f32;
    var phi_642_: bool;
    var phi_646_: f32;
    var phi_692_: i32;
    var phi_697_: i32;
    var phi_702_: i32;
    var phi_707_: i32;
    var phi_716_: i32;
    var phi_721_: i32;
    var phi_726_: i32;
    var phi_731_: i32;
    var phi_822_: bool;
    var phi_830_: bool;
    var phi_835_: f32;
    var phi_838_: evaluate_Verdict;
    var phi_839_: evaluate_Verdict;
    var phi_843_: bool;
    var phi_844_: u32;
    var phi_850_: u32;

    let _e38 = id_1;
    let _e39 = local_2;
    let _e44 = arrayLength((&map.member));
    if (_e39 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e51 = p.member.size[0u];
    let _e53 = p.member.size[1u];
    let _e54 = lt_shaders_entry_pixel_index(_e38, _e51, _e53);
    if (bitcast<i32>(_e54.root) != 0i) {
        let _e61 = p.member.light;
        let _e64 = samples.member[_e54.first_primitive].normal[0u];
        let _e66 = global[0u];
        if (_e64 == _e66) {
            let _e69 = samples.member[_e54.first_primitive].normal[1u];
            let _e71 = global[1u];
            if (_e69 == _e71) {
                let _e74 = samples.member[_e54.first_primitive].normal[2u];
                let _e76 = global[2u];
                phi_406_ = (_e74 == _e76);
                phi_407_ = false;
            } else {
                phi_406_ = bool();
                phi_407_ = true;
            }
            let _e79 = phi_406_;
            let _e81 = phi_407_;
            phi_408_ = _e79;
            phi_409_ = _e81;
        } else {
            phi_408_ = bool();
            phi_409_ = true;
        }
        let _e83 = phi_408_;
        let _e85 = phi_409_;
        if _e85 {
            phi_413_ = false;
        } else {
            phi_413_ = _e83;
        }
        let _e87 = phi_413_;
        if !(_e87) {
            let _e90 = samples.member[_e54.first_primitive].normal;
            let _e92 = samples.member[_e54.first_primitive].position;
            if ((((_e90.x * (_e61.x - (_e92.x * _e61.w))) + (_e90.y * (_e61.y - (_e92.y * _e61.w)))) + (_e90.z * (_e61.z - (_e92.z * _e61.w)))) > 0f) {
                let _e116 = samples.member[_e54.first_primitive].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_457_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_457_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_457_;
            phi_461_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_461_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_461_;
        if _e167.unnamed_1 {
            phi_839_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
        } else {
            let _e175 = samples.member[_e54.first_primitive].position;
            let _e181 = p.member.projection.row_w;
            let _e192 = ((((_e181.x * _e175.x) + (_e181.y * _e175.y)) + (_e181.z * _e175.z)) + (_e181.w * 1f));
            let _e194 = p.member.projection.row_x;
            let _e206 = (((((_e194.x * _e175.x) + (_e194.y * _e175.y)) + (_e194.z * _e175.z)) + (_e194.w * 1f)) / _e192);
            let _e208 = p.member.projection.row_y;
            let _e220 = (((((_e208.x * _e175.x) + (_e208.y * _e175.y)) + (_e208.z * _e175.z)) + (_e208.w * 1f)) / _e192);
            let _e222 = p.member.projection.row_z;
            let _e233 = ((((_e222.x * _e175.x) + (_e222.y * _e175.y)) + (_e222.z * _e175.z)) + (_e222.w * 1f));
            if (_e192 > 0f) {
                if (_e206 >= 0f) {
                    phi_538_ = (_e206 <= 1f);
                } else {
                    phi_538_ = false;
                }
                let _e238 = phi_538_;
                if _e238 {
                    if (_e220 >= 0f) {
                        phi_547_ = (_e220 <= 1f);
                    } else {
                        phi_547_ = false;
                    }
                    let _e242 = phi_547_;
                    if _e242 {
                        if (_e233 >= 0f) {
                            phi_556_ = (_e233 <= 1f);
                        } else {
                            phi_556_ = false;
                        }
                        let _e246 = phi_556_;
                        phi_557_ = _e246;
                        phi_558_ = false;
                    } else {
                        phi_557_ = bool();
                        phi_558_ = true;
                    }
                    let _e248 = phi_557_;
                    let _e250 = phi_558_;
                    phi_559_ = _e248;
                    phi_560_ = _e250;
                } else {
                    phi_559_ = bool();
                    phi_560_ = true;
                }
                let _e252 = phi_559_;
                let _e254 = phi_560_;
                phi_561_ = _e252;
                phi_562_ = _e254;
            } else {
                phi_561_ = bool();
                phi_562_ = true;
            }
            let _e256 = phi_561_;
            let _e258 = phi_562_;
            if _e258 {
                phi_566_ = false;
            } else {
                phi_566_ = _e256;
            }
            let _e260 = phi_566_;
            if _e260 {
                let _e262 = p.member.map_size;
                let _e263 = f32(_e262);
                let _e266 = ((_e206 * _e263) - 0.5f);
                let _e267 = ((_e220 * _e263) - 0.5f);
                if (_e266 > -8388608f) {
                    let _e279 = f32(select(0i, select(select(i32(_e266), i32(-2147483648), (_e266 < bitcast<f32>(3472883712u))), 2147483647i, (_e266 > bitcast<f32>(1325400063u))), (_e266 == _e266)));
                    if (_e279 > _e266) {
                        phi_602_ = 1f;
                    } else {
                        phi_602_ = 0f;
                    }
                    let _e282 = phi_602_;
                    if (_e266 < 8388608f) {
                        phi_607_ = (_e279 - _e282);
                        phi_608_ = false;
                    } else {
                        phi_607_ = f32();
                        phi_608_ = true;
                    }
                    let _e285 = phi_607_;
                    let _e287 = phi_608_;
                    phi_609_ = _e285;
                    phi_610_ = _e287;
                } else {
                    phi_609_ = f32();
                    phi_610_ = true;
                }
                let _e289 = phi_609_;
                let _e291 = phi_610_;
                if _e291 {
                    phi_614_ = _e266;
                } else {
                    phi_614_ = _e289;
                }
                let _e293 = phi_614_;
                if (_e267 > -8388608f) {
                    let _e305 = f32(select(0i, select(select(i32(_e267), i32(-2147483648), (_e267 < bitcast<f32>(3472883712u))), 2147483647i, (_e267 > bitcast<f32>(1325400063u))), (_e267 == _e267)));
                    if (_e305 > _e267) {
                        phi_634_ = 1f;
                    } else {
                        phi_634_ = 0f;
                    }
                    let _e308 = phi_634_;
                    if (_e267 < 8388608f) {
                        phi_639_ = (_e305 - _e308);
                        phi_640_ = false;
                    } else {
                        phi_639_ = f32();
                        phi_640_ = true;
                    }
                    let _e311 = phi_639_;
                    let _e313 = phi_640_;
                    phi_641_ = _e311;
                    phi_642_ = _e313;
                } else {
                    phi_641_ = f32();
                    phi_642_ = true;
                }
                let _e315 = phi_641_;
                let _e317 = phi_642_;
                if _e317 {
                    phi_646_ = _e267;
                } else {
                    phi_646_ = _e315;
                }
                let _e319 = phi_646_;
                let _e320 = (_e266 - _e293);
                let _e321 = (_e267 - _e319);
                let _e330 = select(0i, select(select(i32(_e293), i32(-2147483648), (_e293 < bitcast<f32>(3472883712u))), 2147483647i, (_e293 > bitcast<f32>(1325400063u))), (_e293 == _e293));
                let _e339 = select(0i, select(select(i32(_e319), i32(-2147483648), (_e319 < bitcast<f32>(3472883712u))), 2147483647i, (_e319 > bitcast<f32>(1325400063u))), (_e319 == _e319));
                let _e342 = ((1f - _e320) * (1f - _e321));
                let _e344 = (_e320 * (1f - _e321));
                let _e346 = ((1f - _e320) * _e321);
                let _e347 = (_e320 * _e321);
                let _e349 = p.member.test;
                let _e350 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e349);
                let _e352 = p.member.map_size;
                local_1 = _e350;
                let _e354 = (bitcast<i32>(_e352) - 1i);
                if (_e330 > 0i) {
                    phi_692_ = _e330;
                } else {
                    phi_692_ = 0i;
                }
                let _e357 = phi_692_;
                if (_e339 > 0i) {
                    phi_697_ = _e339;
                } else {
                    phi_697_ = 0i;
                }
                let _e360 = phi_697_;
                if (_e357 < _e354) {
                    phi_702_ = _e357;
                } else {
                    phi_702_ = _e354;
                }
                let _e363 = phi_702_;
                if (_e360 < _e354) {
                    phi_707_ = _e360;
                } else {
                    phi_707_ = _e354;
                }
                let _e366 = phi_707_;
                let _e367 = bitcast<u32>(_e363);
                let _e369 = (_e330 + 1i);
                let _e370 = (_e339 + 1i);
                if (_e369 > 0i) {
                    phi_716_ = _e369;
                } else {
                    phi_716_ = 0i;
                }
                let _e373 = phi_716_;
                if (_e370 > 0i) {
                    phi_721_ = _e370;
                } else {
                    phi_721_ = 0i;
                }
                let _e376 = phi_721_;
                if (_e373 < _e354) {
                    phi_726_ = _e373;
                } else {
                    phi_726_ = _e354;
                }
                let _e379 = phi_726_;
                if (_e376 < _e354) {
                    phi_731_ = _e376;
                } else {
                    phi_731_ = _e354;
                }
                let _e382 = phi_731_;
                let _e383 = bitcast<u32>(_e379);
                let _e385 = (bitcast<u32>(_e366) * _e352);
                let _e386 = (bitcast<u32>(_e382) * _e352);
                let _e387 = (_e385 + _e367);
                let _e388 = (_e385 + _e383);
                let _e389 = (_e386 + _e367);
                let _e390 = (_e386 + _e383);
                if (_e387 < _e44) {
                } else {
                    return;
                }
                let _e394 = map.member[(0u + _e387)];
                if (_e388 < _e44) {
                } else {
                    return;
                }
                let _e406 = map.member[(0u + _e388)];
                if (_e389 < _e44) {
                } else {
                    return;
                }
                let _e422 = map.member[(0u + _e389)];
                if (_e390 < _e44) {
                } else {
                    return;
                }
                let _e438 = map.member[(0u + _e390)];
                let _e452 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e394.x * _e342) + (_e406.x * _e344)) + (_e422.x * _e346)) + (_e438.x * _e347)), ((((_e394.y * _e342) + (_e406.y * _e344)) + (_e422.y * _e346)) + (_e438.y * _e347)), ((((_e394.z * _e342) + (_e406.z * _e344)) + (_e422.z * _e346)) + (_e438.z * _e347)), ((((_e394.w * _e342) + (_e406.w * _e344)) + (_e422.w * _e346)) + (_e438.w * _e347))), _e233);
                let _e454 = p.member.epsilon;
                if (_e452 <= _e454) {
                    phi_822_ = true;
                } else {
                    phi_822_ = (_e452 >= (1f - _e454));
                }
                let _e459 = phi_822_;
                if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
                    phi_830_ = true;
                } else {
                    phi_830_ = !(_e459);
                }
                let _e465 = phi_830_;
                if (_e452 > 0.5f) {
                    phi_835_ = 1f;
                } else {
                    phi_835_ = 0f;
                }
                let _e468 = phi_835_;
                phi_838_ = evaluate_Verdict(_e468, _e465);
            } else {
                phi_838_ = evaluate_Verdict(1f, true);
            }
            let _e472 = phi_838_;
            phi_839_ = _e472;
        }
        let _e474 = phi_839_;
        visibility.member[_e54.first_primitive] = _e474.visibility;
        phi_843_ = _e474.is_doubted;
        phi_844_ = _e54.first_primitive;
    } else {
        phi_843_ = false;
        phi_844_ = 0u;
    }
    let _e479 = phi_843_;
    let _e481 = phi_844_;
    if _e479 {
        let _e483 = atomicAdd((&shared_[0u]), 1u);
        phi_850_ = _e483;
    } else {
        phi_850_ = 0u;
    }
    let _e485 = phi_850_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e489 = atomicLoad((&shared_[0u]));
        let _e490 = atomicAdd((&list.member[3u]), _e489);
        atomicStore((&shared_[1u]), _e490);
    }
    workgroupBarrier();
    if _e479 {
        let _e493 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e493) + _e485)]), _e481);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
