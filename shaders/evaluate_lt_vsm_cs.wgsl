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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_134_: lt_bvh_traverse_Tree;
    var phi_135_: bool;
    var phi_136_: lt_bvh_traverse_Tree;
    var phi_137_: bool;
    var phi_142_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_134_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_135_ = false;
        } else {
            phi_134_ = lt_bvh_traverse_Tree();
            phi_135_ = true;
        }
        let _e49 = phi_134_;
        let _e51 = phi_135_;
        phi_136_ = _e49;
        phi_137_ = _e51;
    } else {
        phi_136_ = lt_bvh_traverse_Tree();
        phi_137_ = true;
    }
    let _e53 = phi_136_;
    let _e55 = phi_137_;
    if _e55 {
        phi_142_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_142_ = _e53;
    }
    let _e60 = phi_142_;
    return lt_bvh_traverse_Tree(_e60.root, _e60.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_168_: f32;
    var phi_169_: f32;
    var phi_170_: f32;
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_288_: bool;
    var phi_292_: f32;
    var phi_304_: bool;
    var phi_311_: f32;
    var phi_326_: f32;
    var phi_327_: f32;
    var phi_328_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_170_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_169_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_168_ = 1f;
            } else {
                phi_168_ = param_7;
            }
            let _e46 = phi_168_;
            phi_169_ = _e46;
        }
        let _e48 = phi_169_;
        phi_170_ = _e48;
    }
    let _e50 = phi_170_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_188_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_187_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_186_ = 1f;
            } else {
                phi_186_ = param_5.x;
            }
            let _e58 = phi_186_;
            phi_187_ = _e58;
        }
        let _e60 = phi_187_;
        phi_188_ = _e60;
    }
    let _e62 = phi_188_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_206_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_5.y;
            }
            let _e70 = phi_204_;
            phi_205_ = _e70;
        }
        let _e72 = phi_205_;
        phi_206_ = _e72;
    }
    let _e74 = phi_206_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_224_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_5.z;
            }
            let _e82 = phi_222_;
            phi_223_ = _e82;
        }
        let _e84 = phi_223_;
        phi_224_ = _e84;
    }
    let _e86 = phi_224_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_242_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_5.w;
            }
            let _e94 = phi_240_;
            phi_241_ = _e94;
        }
        let _e96 = phi_241_;
        phi_242_ = _e96;
    }
    let _e98 = phi_242_;
    let _e99 = (_e62 - _e50);
    let _e100 = (_e74 - _e50);
    let _e101 = (_e86 - _e50);
    let _e102 = (_e98 - _e50);
    let _e103 = (*param_4);
    let _e114 = ((((_e99 * param_6.x) + (_e100 * param_6.y)) + (_e101 * param_6.z)) + (_e102 * param_6.w));
    let _e115 = (_e99 - _e114);
    let _e116 = (_e100 - _e114);
    let _e117 = (_e101 - _e114);
    let _e118 = (_e102 - _e114);
    let _e133 = (((((_e115 * _e115) * param_6.x) + ((_e116 * _e116) * param_6.y)) + ((_e117 * _e117) * param_6.z)) + ((_e118 * _e118) * param_6.w));
    if ((bitcast<u32>(_e103) & 2147483647u) > 2139095040u) {
        phi_288_ = true;
    } else {
        let _e137 = (_e103 > _e133);
        if _e137 {
        }
        phi_288_ = _e137;
    }
    let _e139 = phi_288_;
    if _e139 {
        phi_292_ = _e103;
    } else {
        phi_292_ = _e133;
    }
    let _e141 = phi_292_;
    let _e142 = -(_e114);
    if (_e142 <= 0f) {
        let _e146 = ((bitcast<u32>(_e141) & 2147483647u) > 2139095040u);
        if _e146 {
        }
        phi_304_ = _e146;
    } else {
        phi_304_ = true;
    }
    let _e148 = phi_304_;
    if _e148 {
        phi_311_ = (_e141 / (_e141 + (_e142 * _e142)));
    } else {
        phi_311_ = 1f;
    }
    let _e153 = phi_311_;
    if ((bitcast<u32>(_e153) & 2147483647u) > 2139095040u) {
        phi_328_ = _e153;
    } else {
        if (_e153 < 0f) {
            phi_327_ = 0f;
        } else {
            if (_e153 > 1f) {
                phi_326_ = 1f;
            } else {
                phi_326_ = _e153;
            }
            let _e160 = phi_326_;
            phi_327_ = _e160;
        }
        let _e162 = phi_327_;
        phi_328_ = _e162;
    }
    let _e164 = phi_328_;
    return _e164;
}

fn function_() {
    var local: f32;
    var phi_384_: bool;
    var phi_385_: bool;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_391_: bool;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_473_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_474_: bool;
    var phi_475_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_476_: bool;
    var phi_483_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_487_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_561_: bool;
    var phi_570_: bool;
    var phi_579_: bool;
    var phi_580_: bool;
    var phi_581_: bool;
    var phi_582_: bool;
    var phi_583_: bool;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_589_: bool;
    var phi_679_: f32;
    var phi_682_: f32;
    var phi_711_: f32;
    var phi_716_: f32;
    var phi_717_: bool;
    var phi_718_: f32;
    var phi_719_: bool;
    var phi_723_: f32;
    var phi_743_: f32;
    var phi_748_: f32;
    var phi_749_: bool;
    var phi_750_: f32;
    var phi_751_: bool;
    var phi_755_: f32;
    var phi_803_: i32;
    var phi_808_: i32;
    var phi_813_: i32;
    var phi_818_: i32;
    var phi_827_: i32;
    var phi_832_: i32;
    var phi_837_: i32;
    var phi_842_: i32;
    var phi_895_: bool;
    var phi_903_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_920_: f32;
    var phi_926_: f32;
    var phi_928_: evaluate_Verdict;
    var phi_938_: u32;
    var phi_947_: f32;
    var phi_949_: evaluate_Verdict;
    var phi_950_: bool;
    var phi_951_: evaluate_Verdict;
    var phi_952_: bool;
    var phi_957_: evaluate_Verdict;
    var phi_962_: evaluate_Verdict;
    var phi_963_: evaluate_Verdict;

    let _e37 = id_1;
    let _e44 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e37, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e59 = p.member.projection;
        if (_e53.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e63 = lt_math_OneLevel(_e59);
        let _e67 = samples.member[(0u + _e53.first_primitive)].normal[0u];
        let _e69 = global[0u];
        if (_e67 == _e69) {
            let _e72 = samples.member[(0u + _e53.first_primitive)].normal[1u];
            let _e74 = global[1u];
            if (_e72 == _e74) {
                let _e77 = samples.member[(0u + _e53.first_primitive)].normal[2u];
                let _e79 = global[2u];
                phi_384_ = (_e77 == _e79);
                phi_385_ = false;
            } else {
                phi_384_ = bool();
                phi_385_ = true;
            }
            let _e82 = phi_384_;
            let _e84 = phi_385_;
            phi_386_ = _e82;
            phi_387_ = _e84;
        } else {
            phi_386_ = bool();
            phi_387_ = true;
        }
        let _e86 = phi_386_;
        let _e88 = phi_387_;
        if _e88 {
            phi_391_ = false;
        } else {
            phi_391_ = _e86;
        }
        let _e90 = phi_391_;
        if !(_e90) {
            let _e93 = samples.member[(0u + _e53.first_primitive)].position;
            let _e95 = p.member.light.place;
            let _e101 = p.member.light.place[3u];
            let _e108 = (_e95.x - (_e93.x * _e101));
            let _e109 = (_e95.y - (_e93.y * _e101));
            let _e110 = (_e95.z - (_e93.z * _e101));
            let _e112 = samples.member[(0u + _e53.first_primitive)].normal;
            if ((((_e112.x * _e108) + (_e112.y * _e109)) + (_e112.z * _e110)) > 0f) {
                let _e126 = (((_e108 * _e108) + (_e109 * _e109)) + (_e110 * _e110));
                let _e128 = p.member.light.axis;
                let _e140 = p.member.light.place[3u];
                if (_e140 == 0f) {
                    phi_462_ = true;
                } else {
                    let _e143 = p.member.light.range_squared;
                    if (_e126 <= _e143) {
                        let _e146 = p.member.light.cos_outer;
                        phi_461_ = (-((((_e108 * _e128.x) + (_e109 * _e128.y)) + (_e110 * _e128.z))) >= (_e146 * sqrt(_e126)));
                    } else {
                        phi_461_ = false;
                    }
                    let _e151 = phi_461_;
                    phi_462_ = _e151;
                }
                let _e153 = phi_462_;
                if _e153 {
                    let _e155 = samples.member[(0u + _e53.first_primitive)].flags;
                    let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e163.unnamed.visibility, false), _e163.unnamed_1);
                    phi_473_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e169.unnamed, ((_e155 & 1u) == 0u));
                    phi_474_ = false;
                } else {
                    phi_473_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_474_ = true;
                }
                let _e174 = phi_473_;
                let _e176 = phi_474_;
                phi_475_ = _e174;
                phi_476_ = _e176;
            } else {
                phi_475_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_476_ = true;
            }
            let _e178 = phi_475_;
            let _e180 = phi_476_;
            if _e180 {
                let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e192 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e186.unnamed.visibility, false), _e186.unnamed_1);
                phi_483_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e192.unnamed, true);
            } else {
                phi_483_ = _e178;
            }
            let _e197 = phi_483_;
            phi_487_ = _e197;
        } else {
            let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
            phi_487_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
        }
        let _e214 = phi_487_;
        if _e214.unnamed_1 {
            phi_963_ = evaluate_Verdict(_e214.unnamed.visibility, _e214.unnamed.is_doubted);
        } else {
            let _e222 = samples.member[(0u + _e53.first_primitive)].position;
            let _e240 = ((((_e63.projection.row_w.x * _e222.x) + (_e63.projection.row_w.y * _e222.y)) + (_e63.projection.row_w.z * _e222.z)) + (_e63.projection.row_w.w * 1f));
            let _e254 = (((((_e63.projection.row_x.x * _e222.x) + (_e63.projection.row_x.y * _e222.y)) + (_e63.projection.row_x.z * _e222.z)) + (_e63.projection.row_x.w * 1f)) / _e240);
            let _e268 = (((((_e63.projection.row_y.x * _e222.x) + (_e63.projection.row_y.y * _e222.y)) + (_e63.projection.row_y.z * _e222.z)) + (_e63.projection.row_y.w * 1f)) / _e240);
            let _e281 = ((((_e63.projection.row_z.x * _e222.x) + (_e63.projection.row_z.y * _e222.y)) + (_e63.projection.row_z.z * _e222.z)) + (_e63.projection.row_z.w * 1f));
            if (_e240 > 0f) {
                if (_e254 >= 0f) {
                    phi_561_ = (_e254 <= 1f);
                } else {
                    phi_561_ = false;
                }
                let _e286 = phi_561_;
                if _e286 {
                    if (_e268 >= 0f) {
                        phi_570_ = (_e268 <= 1f);
                    } else {
                        phi_570_ = false;
                    }
                    let _e290 = phi_570_;
                    if _e290 {
                        if (_e281 >= 0f) {
                            phi_579_ = (_e281 <= 1f);
                        } else {
                            phi_579_ = false;
                        }
                        let _e294 = phi_579_;
                        phi_580_ = _e294;
                        phi_581_ = false;
                    } else {
                        phi_580_ = bool();
                        phi_581_ = true;
                    }
                    let _e296 = phi_580_;
                    let _e298 = phi_581_;
                    phi_582_ = _e296;
                    phi_583_ = _e298;
                } else {
                    phi_582_ = bool();
                    phi_583_ = true;
                }
                let _e300 = phi_582_;
                let _e302 = phi_583_;
                phi_584_ = _e300;
                phi_585_ = _e302;
            } else {
                phi_584_ = bool();
                phi_585_ = true;
            }
            let _e304 = phi_584_;
            let _e306 = phi_585_;
            if _e306 {
                phi_589_ = false;
            } else {
                phi_589_ = _e304;
            }
            let _e308 = phi_589_;
            if _e308 {
                if (0f > 0f) {
                    let _e311 = samples.member[(0u + _e53.first_primitive)].normal;
                    let _e313 = p.member.map_size;
                    let _e383 = ((abs(((((_e59.row_x.x * _e311.x) + (_e59.row_x.y * _e311.y)) + (_e59.row_x.z * _e311.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e311.x) + (_e59.row_y.y * _e311.y)) + (_e59.row_y.z * _e311.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e311.x) + (_e59.row_z.y * _e311.y)) + (_e59.row_z.z * _e311.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e313)));
                    if (_e383 < 0.002f) {
                        phi_679_ = _e383;
                    } else {
                        phi_679_ = 0.002f;
                    }
                    let _e386 = phi_679_;
                    phi_682_ = (_e281 - (0f * _e386));
                } else {
                    phi_682_ = _e281;
                }
                let _e390 = phi_682_;
                let _e392 = p.member.map_size;
                let _e393 = f32(_e392);
                let _e396 = ((_e254 * _e393) - 0.5f);
                let _e397 = ((_e268 * _e393) - 0.5f);
                if (_e396 > -8388608f) {
                    let _e409 = f32(select(0i, select(select(i32(_e396), i32(-2147483648), (_e396 < bitcast<f32>(3472883712u))), 2147483647i, (_e396 > bitcast<f32>(1325400063u))), (_e396 == _e396)));
                    if (_e409 > _e396) {
                        phi_711_ = 1f;
                    } else {
                        phi_711_ = 0f;
                    }
                    let _e412 = phi_711_;
                    if (_e396 < 8388608f) {
                        phi_716_ = (_e409 - _e412);
                        phi_717_ = false;
                    } else {
                        phi_716_ = f32();
                        phi_717_ = true;
                    }
                    let _e415 = phi_716_;
                    let _e417 = phi_717_;
                    phi_718_ = _e415;
                    phi_719_ = _e417;
                } else {
                    phi_718_ = f32();
                    phi_719_ = true;
                }
                let _e419 = phi_718_;
                let _e421 = phi_719_;
                if _e421 {
                    phi_723_ = _e396;
                } else {
                    phi_723_ = _e419;
                }
                let _e423 = phi_723_;
                if (_e397 > -8388608f) {
                    let _e435 = f32(select(0i, select(select(i32(_e397), i32(-2147483648), (_e397 < bitcast<f32>(3472883712u))), 2147483647i, (_e397 > bitcast<f32>(1325400063u))), (_e397 == _e397)));
                    if (_e435 > _e397) {
                        phi_743_ = 1f;
                    } else {
                        phi_743_ = 0f;
                    }
                    let _e438 = phi_743_;
                    if (_e397 < 8388608f) {
                        phi_748_ = (_e435 - _e438);
                        phi_749_ = false;
                    } else {
                        phi_748_ = f32();
                        phi_749_ = true;
                    }
                    let _e441 = phi_748_;
                    let _e443 = phi_749_;
                    phi_750_ = _e441;
                    phi_751_ = _e443;
                } else {
                    phi_750_ = f32();
                    phi_751_ = true;
                }
                let _e445 = phi_750_;
                let _e447 = phi_751_;
                if _e447 {
                    phi_755_ = _e397;
                } else {
                    phi_755_ = _e445;
                }
                let _e449 = phi_755_;
                let _e450 = (_e396 - _e423);
                let _e451 = (_e397 - _e449);
                let _e460 = select(0i, select(select(i32(_e423), i32(-2147483648), (_e423 < bitcast<f32>(3472883712u))), 2147483647i, (_e423 > bitcast<f32>(1325400063u))), (_e423 == _e423));
                let _e469 = select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449));
                let _e480 = p.member.test;
                let _e481 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e480);
                let _e483 = p.member.map_size;
                local = _e481;
                let _e485 = ((0u * _e483) * _e483);
                let _e487 = (bitcast<i32>(_e483) - 1i);
                if (_e460 > 0i) {
                    phi_803_ = _e460;
                } else {
                    phi_803_ = 0i;
                }
                let _e490 = phi_803_;
                if (_e469 > 0i) {
                    phi_808_ = _e469;
                } else {
                    phi_808_ = 0i;
                }
                let _e493 = phi_808_;
                if (_e490 < _e487) {
                    phi_813_ = _e490;
                } else {
                    phi_813_ = _e487;
                }
                let _e496 = phi_813_;
                if (_e493 < _e487) {
                    phi_818_ = _e493;
                } else {
                    phi_818_ = _e487;
                }
                let _e499 = phi_818_;
                let _e500 = bitcast<u32>(_e496);
                let _e502 = (_e460 + 1i);
                let _e503 = (_e469 + 1i);
                if (_e502 > 0i) {
                    phi_827_ = _e502;
                } else {
                    phi_827_ = 0i;
                }
                let _e506 = phi_827_;
                if (_e503 > 0i) {
                    phi_832_ = _e503;
                } else {
                    phi_832_ = 0i;
                }
                let _e509 = phi_832_;
                if (_e506 < _e487) {
                    phi_837_ = _e506;
                } else {
                    phi_837_ = _e487;
                }
                let _e512 = phi_837_;
                if (_e509 < _e487) {
                    phi_842_ = _e509;
                } else {
                    phi_842_ = _e487;
                }
                let _e515 = phi_842_;
                let _e516 = bitcast<u32>(_e512);
                let _e518 = (bitcast<u32>(_e499) * _e483);
                let _e519 = (bitcast<u32>(_e515) * _e483);
                let _e524 = ((_e518 + _e500) + _e485);
                let _e525 = ((_e518 + _e516) + _e485);
                let _e526 = ((_e519 + _e500) + _e485);
                let _e527 = ((_e519 + _e516) + _e485);
                if (_e524 < _e44) {
                } else {
                    return;
                }
                let _e531 = map.member[(0u + _e524)];
                if (_e525 < _e44) {
                } else {
                    return;
                }
                let _e535 = map.member[(0u + _e525)];
                if (_e526 < _e44) {
                } else {
                    return;
                }
                let _e539 = map.member[(0u + _e526)];
                if (_e527 < _e44) {
                } else {
                    return;
                }
                let _e543 = map.member[(0u + _e527)];
                let _e545 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e531, _e535, _e539, _e543), vec4<f32>(((1f - _e450) * (1f - _e451)), (_e450 * (1f - _e451)), ((1f - _e450) * _e451), (_e450 * _e451)), _e390);
                let _e549 = p.member.epsilon;
                if (_e545 <= _e549) {
                    phi_895_ = true;
                } else {
                    phi_895_ = (_e545 >= (1f - _e549));
                }
                let _e554 = phi_895_;
                if ((bitcast<u32>(_e545) & 2147483647u) > 2139095040u) {
                    phi_903_ = true;
                } else {
                    phi_903_ = !(_e554);
                }
                let _e560 = phi_903_;
                if _e560 {
                    if (_e545 > 0f) {
                        if (_e545 < 1f) {
                            phi_915_ = false;
                        } else {
                            phi_915_ = true;
                        }
                        let _e564 = phi_915_;
                        phi_916_ = _e564;
                    } else {
                        phi_916_ = true;
                    }
                    let _e566 = phi_916_;
                    if _e566 {
                        phi_920_ = 0.5f;
                    } else {
                        phi_920_ = _e545;
                    }
                    let _e568 = phi_920_;
                    phi_928_ = evaluate_Verdict(_e568, true);
                } else {
                    if (_e545 > 0.5f) {
                        phi_926_ = 1f;
                    } else {
                        phi_926_ = 0f;
                    }
                    let _e572 = phi_926_;
                    phi_928_ = evaluate_Verdict(_e572, false);
                }
                let _e575 = phi_928_;
                let _e578 = (_e575.visibility < 0.5f);
                if _e575.is_doubted {
                    phi_951_ = evaluate_Verdict();
                    phi_952_ = true;
                } else {
                    if _e578 {
                        phi_938_ = 2u;
                    } else {
                        phi_938_ = 1u;
                    }
                    let _e580 = phi_938_;
                    if ((0u & _e580) != 0u) {
                        if _e578 {
                            phi_947_ = 0.000000059604645f;
                        } else {
                            phi_947_ = 0.99999994f;
                        }
                        let _e584 = phi_947_;
                        phi_949_ = evaluate_Verdict(_e584, true);
                        phi_950_ = false;
                    } else {
                        phi_949_ = evaluate_Verdict();
                        phi_950_ = true;
                    }
                    let _e587 = phi_949_;
                    let _e589 = phi_950_;
                    phi_951_ = _e587;
                    phi_952_ = _e589;
                }
                let _e591 = phi_951_;
                let _e593 = phi_952_;
                if _e593 {
                    phi_957_ = evaluate_Verdict(_e575.visibility, _e575.is_doubted);
                } else {
                    phi_957_ = _e591;
                }
                let _e596 = phi_957_;
                phi_962_ = evaluate_Verdict(_e596.visibility, _e596.is_doubted);
            } else {
                phi_962_ = evaluate_Verdict(0.5f, true);
            }
            let _e602 = phi_962_;
            phi_963_ = _e602;
        }
        let _e604 = phi_963_;
        if (_e53.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e53.first_primitive)] = _e604.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
