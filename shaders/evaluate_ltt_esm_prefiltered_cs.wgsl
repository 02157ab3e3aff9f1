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

struct type_50 {
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
var<storage, read_write> list: type_50;
@group(0) @binding(2) 
var<storage> map: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e63 = phi_162_;
        let _e65 = phi_163_;
        phi_164_ = _e63;
        phi_165_ = _e65;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e67 = phi_164_;
    let _e69 = phi_165_;
    if _e69 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e67;
    }
    let _e74 = phi_170_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_210_: bool;
    var phi_214_: f32;
    var phi_227_: f32;
    var phi_232_: f32;
    var phi_254_: f32;
    var phi_259_: f32;
    var phi_260_: bool;
    var phi_261_: f32;
    var phi_262_: bool;
    var phi_266_: f32;
    var phi_304_: f32;
    var phi_320_: f32;
    var phi_321_: f32;
    var phi_322_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_197_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_6;
            }
            let _e59 = phi_195_;
            phi_196_ = _e59;
        }
        let _e61 = phi_196_;
        phi_197_ = _e61;
    }
    let _e63 = phi_197_;
    let _e65 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_210_ = true;
    } else {
        let _e69 = (84f < _e65);
        if _e69 {
        }
        phi_210_ = _e69;
    }
    let _e71 = phi_210_;
    if _e71 {
        phi_214_ = 84f;
    } else {
        phi_214_ = _e65;
    }
    let _e73 = phi_214_;
    let _e75 = (_e73 * (1f - _e63));
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_304_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_227_ = -87f;
        } else {
            phi_227_ = _e75;
        }
        let _e81 = phi_227_;
        if (_e81 > 88f) {
            phi_232_ = 88f;
        } else {
            phi_232_ = _e81;
        }
        let _e84 = phi_232_;
        let _e86 = ((_e84 * 1.442695f) + 0.5f);
        if (_e86 > -8388608f) {
            let _e98 = f32(select(0i, select(select(i32(_e86), i32(-2147483648), (_e86 < bitcast<f32>(3472883712u))), 2147483647i, (_e86 > bitcast<f32>(1325400063u))), (_e86 == _e86)));
            if (_e98 > _e86) {
                phi_254_ = 1f;
            } else {
                phi_254_ = 0f;
            }
            let _e101 = phi_254_;
            if (_e86 < 8388608f) {
                phi_259_ = (_e98 - _e101);
                phi_260_ = false;
            } else {
                phi_259_ = f32();
                phi_260_ = true;
            }
            let _e104 = phi_259_;
            let _e106 = phi_260_;
            phi_261_ = _e104;
            phi_262_ = _e106;
        } else {
            phi_261_ = f32();
            phi_262_ = true;
        }
        let _e108 = phi_261_;
        let _e110 = phi_262_;
        if _e110 {
            phi_266_ = _e86;
        } else {
            phi_266_ = _e108;
        }
        let _e112 = phi_266_;
        let _e116 = ((_e84 - (_e112 * 0.69314575f)) - (_e112 * 0.0000014286068f));
        phi_304_ = ((((((((((((((((1f / 5040f) * _e116) + (1f / 720f)) * _e116) + (1f / 120f)) * _e116) + (1f / 24f)) * _e116) + (1f / 6f)) * _e116) + 0.5f) * _e116) + 1f) * _e116) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e112), i32(-2147483648), (_e112 < bitcast<f32>(3472883712u))), 2147483647i, (_e112 > bitcast<f32>(1325400063u))), (_e112 == _e112)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e152 = phi_304_;
    let _e153 = (param_5.x * _e152);
    if ((bitcast<u32>(_e153) & 2147483647u) > 2139095040u) {
        phi_322_ = _e153;
    } else {
        if (_e153 < 0f) {
            phi_321_ = 0f;
        } else {
            if (_e153 > 1f) {
                phi_320_ = 1f;
            } else {
                phi_320_ = _e153;
            }
            let _e160 = phi_320_;
            phi_321_ = _e160;
        }
        let _e162 = phi_321_;
        phi_322_ = _e162;
    }
    let _e164 = phi_322_;
    return _e164;
}

fn function_() {
    var local_1: f32;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_380_: bool;
    var phi_450_: bool;
    var phi_451_: bool;
    var phi_462_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_463_: bool;
    var phi_464_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_465_: bool;
    var phi_472_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_476_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_550_: bool;
    var phi_559_: bool;
    var phi_568_: bool;
    var phi_569_: bool;
    var phi_570_: bool;
    var phi_571_: bool;
    var phi_572_: bool;
    var phi_573_: bool;
    var phi_574_: bool;
    var phi_578_: bool;
    var phi_668_: f32;
    var phi_671_: f32;
    var phi_700_: f32;
    var phi_705_: f32;
    var phi_706_: bool;
    var phi_707_: f32;
    var phi_708_: bool;
    var phi_712_: f32;
    var phi_732_: f32;
    var phi_737_: f32;
    var phi_738_: bool;
    var phi_739_: f32;
    var phi_740_: bool;
    var phi_744_: f32;
    var phi_792_: i32;
    var phi_797_: i32;
    var phi_802_: i32;
    var phi_807_: i32;
    var phi_816_: i32;
    var phi_821_: i32;
    var phi_826_: i32;
    var phi_831_: i32;
    var phi_926_: bool;
    var phi_934_: bool;
    var phi_946_: bool;
    var phi_947_: bool;
    var phi_951_: f32;
    var phi_957_: f32;
    var phi_959_: evaluate_Verdict;
    var phi_964_: evaluate_Verdict;
    var phi_965_: evaluate_Verdict;
    var phi_969_: bool;
    var phi_970_: u32;
    var phi_981_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e51, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.projection;
        let _e73 = lt_math_OneLevel(_e72);
        let _e77 = samples.member[_e65.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e65.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e65.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_373_ = (_e87 == _e89);
                phi_374_ = false;
            } else {
                phi_373_ = bool();
                phi_374_ = true;
            }
            let _e92 = phi_373_;
            let _e94 = phi_374_;
            phi_375_ = _e92;
            phi_376_ = _e94;
        } else {
            phi_375_ = bool();
            phi_376_ = true;
        }
        let _e96 = phi_375_;
        let _e98 = phi_376_;
        if _e98 {
            phi_380_ = false;
        } else {
            phi_380_ = _e96;
        }
        let _e100 = phi_380_;
        if !(_e100) {
            let _e103 = samples.member[_e65.first_primitive].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[_e65.first_primitive].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_451_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_450_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_450_ = false;
                    }
                    let _e161 = phi_450_;
                    phi_451_ = _e161;
                }
                let _e163 = phi_451_;
                if _e163 {
                    let _e165 = samples.member[_e65.first_primitive].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_463_ = false;
                } else {
                    phi_462_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_463_ = true;
                }
                let _e184 = phi_462_;
                let _e186 = phi_463_;
                phi_464_ = _e184;
                phi_465_ = _e186;
            } else {
                phi_464_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_465_ = true;
            }
            let _e188 = phi_464_;
            let _e190 = phi_465_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_472_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_472_ = _e188;
            }
            let _e207 = phi_472_;
            phi_476_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_476_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_476_;
        if _e224.unnamed_1 {
            phi_965_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[_e65.first_primitive].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_550_ = (_e264 <= 1f);
                } else {
                    phi_550_ = false;
                }
                let _e296 = phi_550_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_559_ = (_e278 <= 1f);
                    } else {
                        phi_559_ = false;
                    }
                    let _e300 = phi_559_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_568_ = (_e291 <= 1f);
                        } else {
                            phi_568_ = false;
                        }
                        let _e304 = phi_568_;
                        phi_569_ = _e304;
                        phi_570_ = false;
                    } else {
                        phi_569_ = bool();
                        phi_570_ = true;
                    }
                    let _e306 = phi_569_;
                    let _e308 = phi_570_;
                    phi_571_ = _e306;
                    phi_572_ = _e308;
                } else {
                    phi_571_ = bool();
                    phi_572_ = true;
                }
                let _e310 = phi_571_;
                let _e312 = phi_572_;
                phi_573_ = _e310;
                phi_574_ = _e312;
            } else {
                phi_573_ = bool();
                phi_574_ = true;
            }
            let _e314 = phi_573_;
            let _e316 = phi_574_;
            if _e316 {
                phi_578_ = false;
            } else {
                phi_578_ = _e314;
            }
            let _e318 = phi_578_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[_e65.first_primitive].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e72.row_x.x * _e321.x) + (_e72.row_x.y * _e321.y)) + (_e72.row_x.z * _e321.z)) / (((_e72.row_x.x * _e72.row_x.x) + (_e72.row_x.y * _e72.row_x.y)) + (_e72.row_x.z * _e72.row_x.z)))) + abs(((((_e72.row_y.x * _e321.x) + (_e72.row_y.y * _e321.y)) + (_e72.row_y.z * _e321.z)) / (((_e72.row_y.x * _e72.row_y.x) + (_e72.row_y.y * _e72.row_y.y)) + (_e72.row_y.z * _e72.row_y.z))))) / (abs(((((_e72.row_z.x * _e321.x) + (_e72.row_z.y * _e321.y)) + (_e72.row_z.z * _e321.z)) / (((_e72.row_z.x * _e72.row_z.x) + (_e72.row_z.y * _e72.row_z.y)) + (_e72.row_z.z * _e72.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_668_ = _e393;
                    } else {
                        phi_668_ = 0.002f;
                    }
                    let _e396 = phi_668_;
                    phi_671_ = (_e291 - (0f * _e396));
                } else {
                    phi_671_ = _e291;
                }
                let _e400 = phi_671_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_700_ = 1f;
                    } else {
                        phi_700_ = 0f;
                    }
                    let _e422 = phi_700_;
                    if (_e406 < 8388608f) {
                        phi_705_ = (_e419 - _e422);
                        phi_706_ = false;
                    } else {
                        phi_705_ = f32();
                        phi_706_ = true;
                    }
                    let _e425 = phi_705_;
                    let _e427 = phi_706_;
                    phi_707_ = _e425;
                    phi_708_ = _e427;
                } else {
                    phi_707_ = f32();
                    phi_708_ = true;
                }
                let _e429 = phi_707_;
                let _e431 = phi_708_;
                if _e431 {
                    phi_712_ = _e406;
                } else {
                    phi_712_ = _e429;
                }
                let _e433 = phi_712_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_732_ = 1f;
                    } else {
                        phi_732_ = 0f;
                    }
                    let _e448 = phi_732_;
                    if (_e407 < 8388608f) {
                        phi_737_ = (_e445 - _e448);
                        phi_738_ = false;
                    } else {
                        phi_737_ = f32();
                        phi_738_ = true;
                    }
                    let _e451 = phi_737_;
                    let _e453 = phi_738_;
                    phi_739_ = _e451;
                    phi_740_ = _e453;
                } else {
                    phi_739_ = f32();
                    phi_740_ = true;
                }
                let _e455 = phi_739_;
                let _e457 = phi_740_;
                if _e457 {
                    phi_744_ = _e407;
                } else {
                    phi_744_ = _e455;
                }
                let _e459 = phi_744_;
                let _e460 = (_e406 - _e433);
                let _e461 = (_e407 - _e459);
                let _e470 = select(0i, select(select(i32(_e433), i32(-2147483648), (_e433 < bitcast<f32>(3472883712u))), 2147483647i, (_e433 > bitcast<f32>(1325400063u))), (_e433 == _e433));
                let _e479 = select(0i, select(select(i32(_e459), i32(-2147483648), (_e459 < bitcast<f32>(3472883712u))), 2147483647i, (_e459 > bitcast<f32>(1325400063u))), (_e459 == _e459));
                let _e482 = ((1f - _e460) * (1f - _e461));
                let _e484 = (_e460 * (1f - _e461));
                let _e486 = ((1f - _e460) * _e461);
                let _e487 = (_e460 * _e461);
                let _e489 = p.member.test;
                let _e490 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e489);
                let _e492 = p.member.map_size;
                local_1 = _e490;
                let _e494 = ((0u * _e492) * _e492);
                let _e496 = (bitcast<i32>(_e492) - 1i);
                if (_e470 > 0i) {
                    phi_792_ = _e470;
                } else {
                    phi_792_ = 0i;
                }
                let _e499 = phi_792_;
                if (_e479 > 0i) {
                    phi_797_ = _e479;
                } else {
                    phi_797_ = 0i;
                }
                let _e502 = phi_797_;
                if (_e499 < _e496) {
                    phi_802_ = _e499;
                } else {
                    phi_802_ = _e496;
                }
                let _e505 = phi_802_;
                if (_e502 < _e496) {
                    phi_807_ = _e502;
                } else {
                    phi_807_ = _e496;
                }
                let _e508 = phi_807_;
                let _e509 = bitcast<u32>(_e505);
                let _e511 = (_e470 + 1i);
                let _e512 = (_e479 + 1i);
                if (_e511 > 0i) {
                    phi_816_ = _e511;
                } else {
                    phi_816_ = 0i;
                }
                let _e515 = phi_816_;
                if (_e512 > 0i) {
                    phi_821_ = _e512;
                } else {
                    phi_821_ = 0i;
                }
                let _e518 = phi_821_;
                if (_e515 < _e496) {
                    phi_826_ = _e515;
                } else {
                    phi_826_ = _e496;
                }
                let _e521 = phi_826_;
                if (_e518 < _e496) {
                    phi_831_ = _e518;
                } else {
                    phi_831_ = _e496;
                }
                let _e524 = phi_831_;
                let _e525 = bitcast<u32>(_e521);
                let _e527 = (bitcast<u32>(_e508) * _e492);
                let _e528 = (bitcast<u32>(_e524) * _e492);
                let _e533 = ((_e527 + _e509) + _e494);
                let _e534 = ((_e527 + _e525) + _e494);
                let _e535 = ((_e528 + _e509) + _e494);
                let _e536 = ((_e528 + _e525) + _e494);
                if (_e533 < _e57) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e533)];
                if (_e534 < _e57) {
                } else {
                    return;
                }
                let _e552 = map.member[(0u + _e534)];
                if (_e535 < _e57) {
                } else {
                    return;
                }
                let _e568 = map.member[(0u + _e535)];
                if (_e536 < _e57) {
                } else {
                    return;
                }
                let _e584 = map.member[(0u + _e536)];
                let _e598 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e540.x * _e482) + (_e552.x * _e484)) + (_e568.x * _e486)) + (_e584.x * _e487)), ((((_e540.y * _e482) + (_e552.y * _e484)) + (_e568.y * _e486)) + (_e584.y * _e487)), ((((_e540.z * _e482) + (_e552.z * _e484)) + (_e568.z * _e486)) + (_e584.z * _e487)), ((((_e540.w * _e482) + (_e552.w * _e484)) + (_e568.w * _e486)) + (_e584.w * _e487))), _e400);
                let _e600 = p.member.epsilon;
                if (_e598 <= _e600) {
                    phi_926_ = true;
                } else {
                    phi_926_ = (_e598 >= (1f - _e600));
                }
                let _e605 = phi_926_;
                if ((bitcast<u32>(_e598) & 2147483647u) > 2139095040u) {
                    phi_934_ = true;
                } else {
                    phi_934_ = !(_e605);
                }
                let _e611 = phi_934_;
                if _e611 {
                    if (_e598 > 0f) {
                        if (_e598 < 1f) {
                            phi_946_ = false;
                        } else {
                            phi_946_ = true;
                        }
                        let _e615 = phi_946_;
                        phi_947_ = _e615;
                    } else {
                        phi_947_ = true;
                    }
                    let _e617 = phi_947_;
                    if _e617 {
                        phi_951_ = 0.5f;
                    } else {
                        phi_951_ = _e598;
                    }
                    let _e619 = phi_951_;
                    phi_959_ = evaluate_Verdict(_e619, true);
                } else {
                    if (_e598 > 0.5f) {
                        phi_957_ = 1f;
                    } else {
                        phi_957_ = 0f;
                    }
                    let _e623 = phi_957_;
                    phi_959_ = evaluate_Verdict(_e623, false);
                }
                let _e626 = phi_959_;
                phi_964_ = evaluate_Verdict(_e626.visibility, _e626.is_doubted);
            } else {
                phi_964_ = evaluate_Verdict(0.5f, true);
            }
            let _e632 = phi_964_;
            phi_965_ = _e632;
        }
        let _e634 = phi_965_;
        visibility.member[_e65.first_primitive] = _e634.visibility;
        phi_969_ = _e634.is_doubted;
        phi_970_ = _e65.first_primitive;
    } else {
        phi_969_ = false;
        phi_970_ = 0u;
    }
    let _e639 = phi_969_;
    let _e641 = phi_970_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e639 {
        let _e645 = atomicAdd((&shared_[0u]), 1u);
        phi_981_ = _e645;
    } else {
        phi_981_ = 0u;
    }
    let _e647 = phi_981_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e651 = atomicLoad((&shared_[0u]));
        let _e652 = atomicAdd((&list.member[3u]), _e651);
        atomicStore((&shared_[1u]), _e652);
    }
    workgroupBarrier();
    if _e639 {
        let _e655 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e655) + _e647)]), _e641);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
