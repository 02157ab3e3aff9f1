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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_159_: lt_bvh_traverse_Tree;
    var phi_160_: bool;
    var phi_161_: lt_bvh_traverse_Tree;
    var phi_162_: bool;
    var phi_167_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_159_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_160_ = false;
        } else {
            phi_159_ = lt_bvh_traverse_Tree();
            phi_160_ = true;
        }
        let _e55 = phi_159_;
        let _e57 = phi_160_;
        phi_161_ = _e55;
        phi_162_ = _e57;
    } else {
        phi_161_ = lt_bvh_traverse_Tree();
        phi_162_ = true;
    }
    let _e59 = phi_161_;
    let _e61 = phi_162_;
    if _e61 {
        phi_167_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_167_ = _e59;
    }
    let _e66 = phi_167_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_224_: bool;
    var phi_246_: f32;
    var phi_247_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: bool;
    var phi_251_: f32;
    var phi_252_: bool;
    var phi_290_: vec2<f32>;
    var phi_324_: f32;
    var phi_325_: f32;
    var phi_326_: f32;
    var phi_355_: f32;
    var phi_356_: f32;
    var phi_357_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_364_: f32;

    let _e45 = (*param_4);
    let _e46 = (1f - _e45);
    let _e55 = (0.5f * _e45);
    let _e56 = ((param_5.x * _e46) + _e55);
    let _e57 = ((param_5.y * _e46) + _e55);
    let _e59 = ((param_5.w * _e46) + _e55);
    let _e61 = (_e57 - (_e56 * _e56));
    let _e63 = (((param_5.z * _e46) + _e55) - (_e56 * _e57));
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_218_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_6;
            }
            let _e75 = phi_216_;
            phi_217_ = _e75;
        }
        let _e77 = phi_217_;
        phi_218_ = _e77;
    }
    let _e79 = phi_218_;
    if (_e56 == _e59) {
        phi_224_ = (_e56 > 0.5f);
    } else {
        phi_224_ = false;
    }
    let _e83 = phi_224_;
    if _e83 {
        if (_e79 > 0f) {
            if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
                phi_248_ = _e56;
            } else {
                if (_e56 < 0f) {
                    phi_247_ = 0f;
                } else {
                    if (_e56 > 1f) {
                        phi_246_ = 1f;
                    } else {
                        phi_246_ = _e56;
                    }
                    let _e91 = phi_246_;
                    phi_247_ = _e91;
                }
                let _e93 = phi_247_;
                phi_248_ = _e93;
            }
            let _e95 = phi_248_;
            phi_249_ = _e95;
            phi_250_ = false;
        } else {
            phi_249_ = f32();
            phi_250_ = true;
        }
        let _e97 = phi_249_;
        let _e99 = phi_250_;
        phi_251_ = _e97;
        phi_252_ = _e99;
    } else {
        phi_251_ = f32();
        phi_252_ = true;
    }
    let _e101 = phi_251_;
    let _e103 = phi_252_;
    if _e103 {
        let _e104 = (_e63 / _e61);
        let _e105 = (_e79 - _e56);
        let _e111 = (((((_e79 * _e79) - _e57) - (_e104 * _e105)) * _e61) / (((_e59 - (_e57 * _e57)) * _e61) - (_e63 * _e63)));
        let _e114 = ((_e105 / _e61) - (_e104 * _e111));
        let _e120 = ((0.5f * _e114) / _e111);
        let _e123 = ((_e120 * _e120) - (((1f - (_e114 * _e56)) - (_e111 * _e57)) / _e111));
        if (_e123 >= 0f) {
            let _e125 = sqrt(_e123);
            phi_290_ = vec2<f32>((-(_e120) - _e125), (-(_e120) + _e125));
        } else {
            phi_290_ = vec2(bitcast<f32>((bitcast<u32>(_e123) | 2143289344u)));
        }
        let _e136 = phi_290_;
        if (_e79 <= _e136.x) {
            phi_363_ = 1f;
        } else {
            if (_e79 > _e136.y) {
                let _e149 = (((_e57 - (_e56 * (_e136.x + _e136.y))) + (_e136.x * _e136.y)) / ((_e79 - _e136.x) * (_e79 - _e136.y)));
                if ((bitcast<u32>(_e149) & 2147483647u) > 2139095040u) {
                    phi_326_ = _e149;
                } else {
                    if (_e149 < 0f) {
                        phi_325_ = 0f;
                    } else {
                        if (_e149 > 1f) {
                            phi_324_ = 1f;
                        } else {
                            phi_324_ = _e149;
                        }
                        let _e156 = phi_324_;
                        phi_325_ = _e156;
                    }
                    let _e158 = phi_325_;
                    phi_326_ = _e158;
                }
                let _e160 = phi_326_;
                phi_362_ = _e160;
            } else {
                if (_e79 > _e136.x) {
                    let _e171 = (1f - (((_e57 - (_e56 * (_e79 + _e136.y))) + (_e79 * _e136.y)) / ((_e136.x - _e79) * (_e136.x - _e136.y))));
                    if ((bitcast<u32>(_e171) & 2147483647u) > 2139095040u) {
                        phi_357_ = _e171;
                    } else {
                        if (_e171 < 0f) {
                            phi_356_ = 0f;
                        } else {
                            if (_e171 > 1f) {
                                phi_355_ = 1f;
                            } else {
                                phi_355_ = _e171;
                            }
                            let _e178 = phi_355_;
                            phi_356_ = _e178;
                        }
                        let _e180 = phi_356_;
                        phi_357_ = _e180;
                    }
                    let _e182 = phi_357_;
                    phi_361_ = _e182;
                } else {
                    phi_361_ = bitcast<f32>((bitcast<u32>(_e136.x) | 2143289344u));
                }
                let _e187 = phi_361_;
                phi_362_ = _e187;
            }
            let _e189 = phi_362_;
            phi_363_ = _e189;
        }
        let _e191 = phi_363_;
        phi_364_ = _e191;
    } else {
        phi_364_ = _e101;
    }
    let _e193 = phi_364_;
    return _e193;
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
    var phi_592_: bool;
    var phi_601_: bool;
    var phi_610_: bool;
    var phi_611_: bool;
    var phi_612_: bool;
    var phi_613_: bool;
    var phi_614_: bool;
    var phi_615_: bool;
    var phi_616_: bool;
    var phi_620_: bool;
    var phi_710_: f32;
    var phi_713_: f32;
    var phi_742_: f32;
    var phi_747_: f32;
    var phi_748_: bool;
    var phi_749_: f32;
    var phi_750_: bool;
    var phi_754_: f32;
    var phi_774_: f32;
    var phi_779_: f32;
    var phi_780_: bool;
    var phi_781_: f32;
    var phi_782_: bool;
    var phi_786_: f32;
    var phi_834_: i32;
    var phi_839_: i32;
    var phi_844_: i32;
    var phi_849_: i32;
    var phi_858_: i32;
    var phi_863_: i32;
    var phi_868_: i32;
    var phi_873_: i32;
    var phi_970_: bool;
    var phi_978_: bool;
    var phi_990_: bool;
    var phi_991_: bool;
    var phi_995_: f32;
    var phi_1001_: f32;
    var phi_1003_: evaluate_Verdict;
    var phi_1013_: u32;
    var phi_1022_: f32;
    var phi_1024_: evaluate_Verdict;
    var phi_1025_: bool;
    var phi_1026_: evaluate_Verdict;
    var phi_1027_: bool;
    var phi_1032_: evaluate_Verdict;
    var phi_1037_: evaluate_Verdict;
    var phi_1038_: evaluate_Verdict;
    var phi_1042_: bool;
    var phi_1043_: u32;
    var phi_1054_: u32;
    var phi_1071_: u32;

    let _e43 = id_1;
    let _e44 = local_2;
    let _e49 = arrayLength((&map.member));
    let _e54 = p.member.size[0u];
    let _e56 = p.member.size[1u];
    let _e57 = lt_shaders_entry_pixel_index(_e43, _e54, _e56);
    if (bitcast<i32>(_e57.root) != 0i) {
        let _e64 = p.member.projection;
        let _e65 = lt_math_OneLevel(_e64);
        let _e69 = samples.member[_e57.first_primitive].normal[0u];
        let _e71 = global[0u];
        if (_e69 == _e71) {
            let _e74 = samples.member[_e57.first_primitive].normal[1u];
            let _e76 = global[1u];
            if (_e74 == _e76) {
                let _e79 = samples.member[_e57.first_primitive].normal[2u];
                let _e81 = global[2u];
                phi_415_ = (_e79 == _e81);
                phi_416_ = false;
            } else {
                phi_415_ = bool();
                phi_416_ = true;
            }
            let _e84 = phi_415_;
            let _e86 = phi_416_;
            phi_417_ = _e84;
            phi_418_ = _e86;
        } else {
            phi_417_ = bool();
            phi_418_ = true;
        }
        let _e88 = phi_417_;
        let _e90 = phi_418_;
        if _e90 {
            phi_422_ = false;
        } else {
            phi_422_ = _e88;
        }
        let _e92 = phi_422_;
        if !(_e92) {
            let _e95 = samples.member[_e57.first_primitive].position;
            let _e97 = p.member.light.place;
            let _e103 = p.member.light.place[3u];
            let _e110 = (_e97.x - (_e95.x * _e103));
            let _e111 = (_e97.y - (_e95.y * _e103));
            let _e112 = (_e97.z - (_e95.z * _e103));
            let _e114 = samples.member[_e57.first_primitive].normal;
            if ((((_e114.x * _e110) + (_e114.y * _e111)) + (_e114.z * _e112)) > 0f) {
                let _e128 = (((_e110 * _e110) + (_e111 * _e111)) + (_e112 * _e112));
                let _e130 = p.member.light.axis;
                let _e142 = p.member.light.place[3u];
                if (_e142 == 0f) {
                    phi_493_ = true;
                } else {
                    let _e145 = p.member.light.range_squared;
                    if (_e128 <= _e145) {
                        let _e148 = p.member.light.cos_outer;
                        phi_492_ = (-((((_e110 * _e130.x) + (_e111 * _e130.y)) + (_e112 * _e130.z))) >= (_e148 * sqrt(_e128)));
                    } else {
                        phi_492_ = false;
                    }
                    let _e153 = phi_492_;
                    phi_493_ = _e153;
                }
                let _e155 = phi_493_;
                if _e155 {
                    let _e157 = samples.member[_e57.first_primitive].flags;
                    let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e165.unnamed.visibility, false), _e165.unnamed_1);
                    phi_504_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e171.unnamed, ((_e157 & 1u) == 0u));
                    phi_505_ = false;
                } else {
                    phi_504_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_505_ = true;
                }
                let _e176 = phi_504_;
                let _e178 = phi_505_;
                phi_506_ = _e176;
                phi_507_ = _e178;
            } else {
                phi_506_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_507_ = true;
            }
            let _e180 = phi_506_;
            let _e182 = phi_507_;
            if _e182 {
                let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e194 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e188.unnamed.visibility, false), _e188.unnamed_1);
                phi_514_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e194.unnamed, true);
            } else {
                phi_514_ = _e180;
            }
            let _e199 = phi_514_;
            phi_518_ = _e199;
        } else {
            let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
            phi_518_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
        }
        let _e216 = phi_518_;
        if _e216.unnamed_1 {
            phi_1038_ = evaluate_Verdict(_e216.unnamed.visibility, _e216.unnamed.is_doubted);
        } else {
            let _e224 = samples.member[_e57.first_primitive].position;
            let _e242 = ((((_e65.projection.row_w.x * _e224.x) + (_e65.projection.row_w.y * _e224.y)) + (_e65.projection.row_w.z * _e224.z)) + (_e65.projection.row_w.w * 1f));
            let _e256 = (((((_e65.projection.row_x.x * _e224.x) + (_e65.projection.row_x.y * _e224.y)) + (_e65.projection.row_x.z * _e224.z)) + (_e65.projection.row_x.w * 1f)) / _e242);
            let _e270 = (((((_e65.projection.row_y.x * _e224.x) + (_e65.projection.row_y.y * _e224.y)) + (_e65.projection.row_y.z * _e224.z)) + (_e65.projection.row_y.w * 1f)) / _e242);
            let _e283 = ((((_e65.projection.row_z.x * _e224.x) + (_e65.projection.row_z.y * _e224.y)) + (_e65.projection.row_z.z * _e224.z)) + (_e65.projection.row_z.w * 1f));
            if (_e242 > 0f) {
                if (_e256 >= 0f) {
                    phi_592_ = (_e256 <= 1f);
                } else {
                    phi_592_ = false;
                }
                let _e288 = phi_592_;
                if _e288 {
                    if (_e270 >= 0f) {
                        phi_601_ = (_e270 <= 1f);
                    } else {
                        phi_601_ = false;
                    }
                    let _e292 = phi_601_;
                    if _e292 {
                        if (_e283 >= 0f) {
                            phi_610_ = (_e283 <= 1f);
                        } else {
                            phi_610_ = false;
                        }
                        let _e296 = phi_610_;
                        phi_611_ = _e296;
                        phi_612_ = false;
                    } else {
                        phi_611_ = bool();
                        phi_612_ = true;
                    }
                    let _e298 = phi_611_;
                    let _e300 = phi_612_;
                    phi_613_ = _e298;
                    phi_614_ = _e300;
                } else {
                    phi_613_ = bool();
                    phi_614_ = true;
                }
                let _e302 = phi_613_;
                let _e304 = phi_614_;
                phi_615_ = _e302;
                phi_616_ = _e304;
            } else {
                phi_615_ = bool();
                phi_616_ = true;
            }
            let _e306 = phi_615_;
            let _e308 = phi_616_;
            if _e308 {
                phi_620_ = false;
            } else {
                phi_620_ = _e306;
            }
            let _e310 = phi_620_;
            if _e310 {
                if (0f > 0f) {
                    let _e313 = samples.member[_e57.first_primitive].normal;
                    let _e315 = p.member.map_size;
                    let _e385 = ((abs(((((_e64.row_x.x * _e313.x) + (_e64.row_x.y * _e313.y)) + (_e64.row_x.z * _e313.z)) / (((_e64.row_x.x * _e64.row_x.x) + (_e64.row_x.y * _e64.row_x.y)) + (_e64.row_x.z * _e64.row_x.z)))) + abs(((((_e64.row_y.x * _e313.x) + (_e64.row_y.y * _e313.y)) + (_e64.row_y.z * _e313.z)) / (((_e64.row_y.x * _e64.row_y.x) + (_e64.row_y.y * _e64.row_y.y)) + (_e64.row_y.z * _e64.row_y.z))))) / (abs(((((_e64.row_z.x * _e313.x) + (_e64.row_z.y * _e313.y)) + (_e64.row_z.z * _e313.z)) / (((_e64.row_z.x * _e64.row_z.x) + (_e64.row_z.y * _e64.row_z.y)) + (_e64.row_z.z * _e64.row_z.z)))) * f32(_e315)));
                    if (_e385 < 0.002f) {
                        phi_710_ = _e385;
                    } else {
                        phi_710_ = 0.002f;
                    }
                    let _e388 = phi_710_;
                    phi_713_ = (_e283 - (0f * _e388));
                } else {
                    phi_713_ = _e283;
                }
                let _e392 = phi_713_;
                let _e394 = p.member.map_size;
                let _e395 = f32(_e394);
                let _e398 = ((_e256 * _e395) - 0.5f);
                let _e399 = ((_e270 * _e395) - 0.5f);
                if (_e398 > -8388608f) {
                    let _e411 = f32(select(0i, select(select(i32(_e398), i32(-2147483648), (_e398 < bitcast<f32>(3472883712u))), 2147483647i, (_e398 > bitcast<f32>(1325400063u))), (_e398 == _e398)));
                    if (_e411 > _e398) {
                        phi_742_ = 1f;
                    } else {
                        phi_742_ = 0f;
                    }
                    let _e414 = phi_742_;
                    if (_e398 < 8388608f) {
                        phi_747_ = (_e411 - _e414);
                        phi_748_ = false;
                    } else {
                        phi_747_ = f32();
                        phi_748_ = true;
                    }
                    let _e417 = phi_747_;
                    let _e419 = phi_748_;
                    phi_749_ = _e417;
                    phi_750_ = _e419;
                } else {
                    phi_749_ = f32();
                    phi_750_ = true;
                }
                let _e421 = phi_749_;
                let _e423 = phi_750_;
                if _e423 {
                    phi_754_ = _e398;
                } else {
                    phi_754_ = _e421;
                }
                let _e425 = phi_754_;
                if (_e399 > -8388608f) {
                    let _e437 = f32(select(0i, select(select(i32(_e399), i32(-2147483648), (_e399 < bitcast<f32>(3472883712u))), 2147483647i, (_e399 > bitcast<f32>(1325400063u))), (_e399 == _e399)));
                    if (_e437 > _e399) {
                        phi_774_ = 1f;
                    } else {
                        phi_774_ = 0f;
                    }
                    let _e440 = phi_774_;
                    if (_e399 < 8388608f) {
                        phi_779_ = (_e437 - _e440);
                        phi_780_ = false;
                    } else {
                        phi_779_ = f32();
                        phi_780_ = true;
                    }
                    let _e443 = phi_779_;
                    let _e445 = phi_780_;
                    phi_781_ = _e443;
                    phi_782_ = _e445;
                } else {
                    phi_781_ = f32();
                    phi_782_ = true;
                }
                let _e447 = phi_781_;
                let _e449 = phi_782_;
                if _e449 {
                    phi_786_ = _e399;
                } else {
                    phi_786_ = _e447;
                }
                let _e451 = phi_786_;
                let _e452 = (_e398 - _e425);
                let _e453 = (_e399 - _e451);
                let _e462 = select(0i, select(select(i32(_e425), i32(-2147483648), (_e425 < bitcast<f32>(3472883712u))), 2147483647i, (_e425 > bitcast<f32>(1325400063u))), (_e425 == _e425));
                let _e471 = select(0i, select(select(i32(_e451), i32(-2147483648), (_e451 < bitcast<f32>(3472883712u))), 2147483647i, (_e451 > bitcast<f32>(1325400063u))), (_e451 == _e451));
                let _e474 = ((1f - _e452) * (1f - _e453));
                let _e476 = (_e452 * (1f - _e453));
                let _e478 = ((1f - _e452) * _e453);
                let _e479 = (_e452 * _e453);
                let _e481 = p.member.test;
                let _e482 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e481);
                let _e484 = p.member.map_size;
                local_1 = _e482;
                let _e486 = ((0u * _e484) * _e484);
                let _e488 = (bitcast<i32>(_e484) - 1i);
                if (_e462 > 0i) {
                    phi_834_ = _e462;
                } else {
                    phi_834_ = 0i;
                }
                let _e491 = phi_834_;
                if (_e471 > 0i) {
                    phi_839_ = _e471;
                } else {
                    phi_839_ = 0i;
                }
                let _e494 = phi_839_;
                if (_e491 < _e488) {
                    phi_844_ = _e491;
                } else {
                    phi_844_ = _e488;
                }
                let _e497 = phi_844_;
                if (_e494 < _e488) {
                    phi_849_ = _e494;
                } else {
                    phi_849_ = _e488;
                }
                let _e500 = phi_849_;
                let _e501 = bitcast<u32>(_e497);
                let _e503 = (_e462 + 1i);
                let _e504 = (_e471 + 1i);
                if (_e503 > 0i) {
                    phi_858_ = _e503;
                } else {
                    phi_858_ = 0i;
                }
                let _e507 = phi_858_;
                if (_e504 > 0i) {
                    phi_863_ = _e504;
                } else {
                    phi_863_ = 0i;
                }
                let _e510 = phi_863_;
                if (_e507 < _e488) {
                    phi_868_ = _e507;
                } else {
                    phi_868_ = _e488;
                }
                let _e513 = phi_868_;
                if (_e510 < _e488) {
                    phi_873_ = _e510;
                } else {
                    phi_873_ = _e488;
                }
                let _e516 = phi_873_;
                let _e517 = bitcast<u32>(_e513);
                let _e519 = (bitcast<u32>(_e500) * _e484);
                let _e520 = (bitcast<u32>(_e516) * _e484);
                let _e525 = ((_e519 + _e501) + _e486);
                let _e526 = ((_e519 + _e517) + _e486);
                let _e527 = ((_e520 + _e501) + _e486);
                let _e528 = ((_e520 + _e517) + _e486);
                if (_e525 < _e49) {
                } else {
                    return;
                }
                let _e532 = map.member[(0u + _e525)];
                if (_e526 < _e49) {
                } else {
                    return;
                }
                let _e544 = map.member[(0u + _e526)];
                if (_e527 < _e49) {
                } else {
                    return;
                }
                let _e560 = map.member[(0u + _e527)];
                if (_e528 < _e49) {
                } else {
                    return;
                }
                let _e576 = map.member[(0u + _e528)];
                let _e590 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e532.x * _e474) + (_e544.x * _e476)) + (_e560.x * _e478)) + (_e576.x * _e479)), ((((_e532.y * _e474) + (_e544.y * _e476)) + (_e560.y * _e478)) + (_e576.y * _e479)), ((((_e532.z * _e474) + (_e544.z * _e476)) + (_e560.z * _e478)) + (_e576.z * _e479)), ((((_e532.w * _e474) + (_e544.w * _e476)) + (_e560.w * _e478)) + (_e576.w * _e479))), _e392);
                let _e594 = p.member.epsilon;
                if (_e590 <= _e594) {
                    phi_970_ = true;
                } else {
                    phi_970_ = (_e590 >= (1f - _e594));
                }
                let _e599 = phi_970_;
                if ((bitcast<u32>(_e590) & 2147483647u) > 2139095040u) {
                    phi_978_ = true;
                } else {
                    phi_978_ = !(_e599);
                }
                let _e605 = phi_978_;
                if _e605 {
                    if (_e590 > 0f) {
                        if (_e590 < 1f) {
                            phi_990_ = false;
                        } else {
                            phi_990_ = true;
                        }
                        let _e609 = phi_990_;
                        phi_991_ = _e609;
                    } else {
                        phi_991_ = true;
                    }
                    let _e611 = phi_991_;
                    if _e611 {
                        phi_995_ = 0.5f;
                    } else {
                        phi_995_ = _e590;
                    }
                    let _e613 = phi_995_;
                    phi_1003_ = evaluate_Verdict(_e613, true);
                } else {
                    if (_e590 > 0.5f) {
                        phi_1001_ = 1f;
                    } else {
                        phi_1001_ = 0f;
                    }
                    let _e617 = phi_1001_;
                    phi_1003_ = evaluate_Verdict(_e617, false);
                }
                let _e620 = phi_1003_;
                let _e623 = (_e620.visibility < 0.5f);
                if _e620.is_doubted {
                    phi_1026_ = evaluate_Verdict();
                    phi_1027_ = true;
                } else {
                    if _e623 {
                        phi_1013_ = 2u;
                    } else {
                        phi_1013_ = 1u;
                    }
                    let _e625 = phi_1013_;
                    if ((0u & _e625) != 0u) {
                        if _e623 {
                            phi_1022_ = 0.000000059604645f;
                        } else {
                            phi_1022_ = 0.99999994f;
                        }
                        let _e629 = phi_1022_;
                        phi_1024_ = evaluate_Verdict(_e629, true);
                        phi_1025_ = false;
                    } else {
                        phi_1024_ = evaluate_Verdict();
                        phi_1025_ = true;
                    }
                    let _e632 = phi_1024_;
                    let _e634 = phi_1025_;
                    phi_1026_ = _e632;
                    phi_1027_ = _e634;
                }
                let _e636 = phi_1026_;
                let _e638 = phi_1027_;
                if _e638 {
                    phi_1032_ = evaluate_Verdict(_e620.visibility, _e620.is_doubted);
                } else {
                    phi_1032_ = _e636;
                }
                let _e641 = phi_1032_;
                phi_1037_ = evaluate_Verdict(_e641.visibility, _e641.is_doubted);
            } else {
                phi_1037_ = evaluate_Verdict(0.5f, true);
            }
            let _e647 = phi_1037_;
            phi_1038_ = _e647;
        }
        let _e649 = phi_1038_;
        visibility.member[_e57.first_primitive] = _e649.visibility;
        phi_1042_ = _e649.is_doubted;
        phi_1043_ = _e57.first_primitive;
    } else {
        phi_1042_ = false;
        phi_1043_ = 0u;
    }
    let _e654 = phi_1042_;
    let _e656 = phi_1043_;
    if (_e44 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e654 {
        let _e660 = atomicAdd((&shared_[0u]), 1u);
        phi_1054_ = _e660;
    } else {
        phi_1054_ = 0u;
    }
    let _e662 = phi_1054_;
    workgroupBarrier();
    if (_e44 == 0u) {
        let _e666 = atomicLoad((&shared_[0u]));
        let _e667 = atomicAdd((&list.member[3u]), _e666);
        atomicStore((&shared_[1u]), _e667);
    }
    workgroupBarrier();
    if _e654 {
        if false {
            phi_1071_ = (_e656 | 2147483648u);
        } else {
            phi_1071_ = _e656;
        }
        let _e671 = phi_1071_;
        let _e673 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e673) + _e662)]), _e671);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
