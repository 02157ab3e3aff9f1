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

struct type_31 {
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

struct type_35 {
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
var<uniform> p: type_35;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(2) 
var<storage> map: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_147_: lt_bvh_traverse_Tree;
    var phi_148_: bool;
    var phi_153_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_145_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_146_ = false;
        } else {
            phi_145_ = lt_bvh_traverse_Tree();
            phi_146_ = true;
        }
        let _e59 = phi_145_;
        let _e61 = phi_146_;
        phi_147_ = _e59;
        phi_148_ = _e61;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e63 = phi_147_;
    let _e65 = phi_148_;
    if _e65 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e63;
    }
    let _e70 = phi_153_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_812_: bool;
    var phi_816_: f32;
    var phi_829_: f32;
    var phi_834_: f32;
    var phi_856_: f32;
    var phi_861_: f32;
    var phi_862_: bool;
    var phi_863_: f32;
    var phi_864_: bool;
    var phi_868_: f32;
    var phi_906_: f32;
    var phi_922_: f32;
    var phi_923_: f32;
    var phi_924_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_799_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_798_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_797_ = 1f;
            } else {
                phi_797_ = param_6;
            }
            let _e55 = phi_797_;
            phi_798_ = _e55;
        }
        let _e57 = phi_798_;
        phi_799_ = _e57;
    }
    let _e59 = phi_799_;
    let _e61 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_812_ = true;
    } else {
        let _e65 = (84f < _e61);
        if _e65 {
        }
        phi_812_ = _e65;
    }
    let _e67 = phi_812_;
    if _e67 {
        phi_816_ = 84f;
    } else {
        phi_816_ = _e61;
    }
    let _e69 = phi_816_;
    let _e71 = (_e69 * (1f - _e59));
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_906_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_829_ = -87f;
        } else {
            phi_829_ = _e71;
        }
        let _e77 = phi_829_;
        if (_e77 > 88f) {
            phi_834_ = 88f;
        } else {
            phi_834_ = _e77;
        }
        let _e80 = phi_834_;
        let _e82 = ((_e80 * 1.442695f) + 0.5f);
        if (_e82 > -8388608f) {
            let _e94 = f32(select(0i, select(select(i32(_e82), i32(-2147483648), (_e82 < bitcast<f32>(3472883712u))), 2147483647i, (_e82 > bitcast<f32>(1325400063u))), (_e82 == _e82)));
            if (_e94 > _e82) {
                phi_856_ = 1f;
            } else {
                phi_856_ = 0f;
            }
            let _e97 = phi_856_;
            if (_e82 < 8388608f) {
                phi_861_ = (_e94 - _e97);
                phi_862_ = false;
            } else {
                phi_861_ = f32();
                phi_862_ = true;
            }
            let _e100 = phi_861_;
            let _e102 = phi_862_;
            phi_863_ = _e100;
            phi_864_ = _e102;
        } else {
            phi_863_ = f32();
            phi_864_ = true;
        }
        let _e104 = phi_863_;
        let _e106 = phi_864_;
        if _e106 {
            phi_868_ = _e82;
        } else {
            phi_868_ = _e104;
        }
        let _e108 = phi_868_;
        let _e112 = ((_e80 - (_e108 * 0.69314575f)) - (_e108 * 0.0000014286068f));
        phi_906_ = ((((((((((((((((1f / 5040f) * _e112) + (1f / 720f)) * _e112) + (1f / 120f)) * _e112) + (1f / 24f)) * _e112) + (1f / 6f)) * _e112) + 0.5f) * _e112) + 1f) * _e112) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e108), i32(-2147483648), (_e108 < bitcast<f32>(3472883712u))), 2147483647i, (_e108 > bitcast<f32>(1325400063u))), (_e108 == _e108)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e148 = phi_906_;
    let _e149 = (param_5.x * _e148);
    if ((bitcast<u32>(_e149) & 2147483647u) > 2139095040u) {
        phi_924_ = _e149;
    } else {
        if (_e149 < 0f) {
            phi_923_ = 0f;
        } else {
            if (_e149 > 1f) {
                phi_922_ = 1f;
            } else {
                phi_922_ = _e149;
            }
            let _e156 = phi_922_;
            phi_923_ = _e156;
        }
        let _e158 = phi_923_;
        phi_924_ = _e158;
    }
    let _e160 = phi_924_;
    return _e160;
}

fn function_() {
    var local: f32;
    var phi_215_: bool;
    var phi_216_: bool;
    var phi_217_: bool;
    var phi_218_: bool;
    var phi_222_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_304_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_305_: bool;
    var phi_306_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_307_: bool;
    var phi_314_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_318_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_392_: bool;
    var phi_401_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_420_: bool;
    var phi_510_: f32;
    var phi_513_: f32;
    var phi_542_: f32;
    var phi_547_: f32;
    var phi_548_: bool;
    var phi_549_: f32;
    var phi_550_: bool;
    var phi_554_: f32;
    var phi_574_: f32;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_586_: f32;
    var phi_634_: i32;
    var phi_639_: i32;
    var phi_644_: i32;
    var phi_649_: i32;
    var phi_658_: i32;
    var phi_663_: i32;
    var phi_668_: i32;
    var phi_673_: i32;
    var phi_762_: evaluate_Verdict;
    var phi_763_: evaluate_Verdict;
    var phi_764_: bool;
    var phi_765_: evaluate_Verdict;
    var phi_766_: evaluate_Verdict;
    var phi_767_: bool;
    var phi_771_: evaluate_Verdict;

    let _e47 = id_1;
    let _e54 = arrayLength((&map.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e69 = p.member.projection;
        if (_e63.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = lt_math_OneLevel(_e69);
        let _e77 = samples.member[(0u + _e63.first_primitive)].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[(0u + _e63.first_primitive)].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[(0u + _e63.first_primitive)].normal[2u];
                let _e89 = global[2u];
                phi_215_ = (_e87 == _e89);
                phi_216_ = false;
            } else {
                phi_215_ = bool();
                phi_216_ = true;
            }
            let _e92 = phi_215_;
            let _e94 = phi_216_;
            phi_217_ = _e92;
            phi_218_ = _e94;
        } else {
            phi_217_ = bool();
            phi_218_ = true;
        }
        let _e96 = phi_217_;
        let _e98 = phi_218_;
        if _e98 {
            phi_222_ = false;
        } else {
            phi_222_ = _e96;
        }
        let _e100 = phi_222_;
        if !(_e100) {
            let _e103 = samples.member[(0u + _e63.first_primitive)].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[(0u + _e63.first_primitive)].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_293_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_292_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_292_ = false;
                    }
                    let _e161 = phi_292_;
                    phi_293_ = _e161;
                }
                let _e163 = phi_293_;
                if _e163 {
                    let _e165 = samples.member[(0u + _e63.first_primitive)].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_304_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_305_ = false;
                } else {
                    phi_304_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_305_ = true;
                }
                let _e184 = phi_304_;
                let _e186 = phi_305_;
                phi_306_ = _e184;
                phi_307_ = _e186;
            } else {
                phi_306_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_307_ = true;
            }
            let _e188 = phi_306_;
            let _e190 = phi_307_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_314_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_314_ = _e188;
            }
            let _e207 = phi_314_;
            phi_318_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_318_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_318_;
        if _e224.unnamed_1 {
            phi_765_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
            phi_766_ = evaluate_Verdict();
            phi_767_ = true;
        } else {
            let _e232 = samples.member[(0u + _e63.first_primitive)].position;
            let _e250 = ((((_e73.projection.row_w.x * _e232.x) + (_e73.projection.row_w.y * _e232.y)) + (_e73.projection.row_w.z * _e232.z)) + (_e73.projection.row_w.w * 1f));
            let _e264 = (((((_e73.projection.row_x.x * _e232.x) + (_e73.projection.row_x.y * _e232.y)) + (_e73.projection.row_x.z * _e232.z)) + (_e73.projection.row_x.w * 1f)) / _e250);
            let _e278 = (((((_e73.projection.row_y.x * _e232.x) + (_e73.projection.row_y.y * _e232.y)) + (_e73.projection.row_y.z * _e232.z)) + (_e73.projection.row_y.w * 1f)) / _e250);
            let _e291 = ((((_e73.projection.row_z.x * _e232.x) + (_e73.projection.row_z.y * _e232.y)) + (_e73.projection.row_z.z * _e232.z)) + (_e73.projection.row_z.w * 1f));
            if (_e250 > 0f) {
                if (_e264 >= 0f) {
                    phi_392_ = (_e264 <= 1f);
                } else {
                    phi_392_ = false;
                }
                let _e296 = phi_392_;
                if _e296 {
                    if (_e278 >= 0f) {
                        phi_401_ = (_e278 <= 1f);
                    } else {
                        phi_401_ = false;
                    }
                    let _e300 = phi_401_;
                    if _e300 {
                        if (_e291 >= 0f) {
                            phi_410_ = (_e291 <= 1f);
                        } else {
                            phi_410_ = false;
                        }
                        let _e304 = phi_410_;
                        phi_411_ = _e304;
                        phi_412_ = false;
                    } else {
                        phi_411_ = bool();
                        phi_412_ = true;
                    }
                    let _e306 = phi_411_;
                    let _e308 = phi_412_;
                    phi_413_ = _e306;
                    phi_414_ = _e308;
                } else {
                    phi_413_ = bool();
                    phi_414_ = true;
                }
                let _e310 = phi_413_;
                let _e312 = phi_414_;
                phi_415_ = _e310;
                phi_416_ = _e312;
            } else {
                phi_415_ = bool();
                phi_416_ = true;
            }
            let _e314 = phi_415_;
            let _e316 = phi_416_;
            if _e316 {
                phi_420_ = false;
            } else {
                phi_420_ = _e314;
            }
            let _e318 = phi_420_;
            if _e318 {
                if (0f > 0f) {
                    let _e321 = samples.member[(0u + _e63.first_primitive)].normal;
                    let _e323 = p.member.map_size;
                    let _e393 = ((abs(((((_e69.row_x.x * _e321.x) + (_e69.row_x.y * _e321.y)) + (_e69.row_x.z * _e321.z)) / (((_e69.row_x.x * _e69.row_x.x) + (_e69.row_x.y * _e69.row_x.y)) + (_e69.row_x.z * _e69.row_x.z)))) + abs(((((_e69.row_y.x * _e321.x) + (_e69.row_y.y * _e321.y)) + (_e69.row_y.z * _e321.z)) / (((_e69.row_y.x * _e69.row_y.x) + (_e69.row_y.y * _e69.row_y.y)) + (_e69.row_y.z * _e69.row_y.z))))) / (abs(((((_e69.row_z.x * _e321.x) + (_e69.row_z.y * _e321.y)) + (_e69.row_z.z * _e321.z)) / (((_e69.row_z.x * _e69.row_z.x) + (_e69.row_z.y * _e69.row_z.y)) + (_e69.row_z.z * _e69.row_z.z)))) * f32(_e323)));
                    if (_e393 < 0.002f) {
                        phi_510_ = _e393;
                    } else {
                        phi_510_ = 0.002f;
                    }
                    let _e396 = phi_510_;
                    phi_513_ = (_e291 - (0f * _e396));
                } else {
                    phi_513_ = _e291;
                }
                let _e400 = phi_513_;
                let _e402 = p.member.map_size;
                let _e403 = f32(_e402);
                let _e406 = ((_e264 * _e403) - 0.5f);
                let _e407 = ((_e278 * _e403) - 0.5f);
                if (_e406 > -8388608f) {
                    let _e419 = f32(select(0i, select(select(i32(_e406), i32(-2147483648), (_e406 < bitcast<f32>(3472883712u))), 2147483647i, (_e406 > bitcast<f32>(1325400063u))), (_e406 == _e406)));
                    if (_e419 > _e406) {
                        phi_542_ = 1f;
                    } else {
                        phi_542_ = 0f;
                    }
                    let _e422 = phi_542_;
                    if (_e406 < 8388608f) {
                        phi_547_ = (_e419 - _e422);
                        phi_548_ = false;
                    } else {
                        phi_547_ = f32();
                        phi_548_ = true;
                    }
                    let _e425 = phi_547_;
                    let _e427 = phi_548_;
                    phi_549_ = _e425;
                    phi_550_ = _e427;
                } else {
                    phi_549_ = f32();
                    phi_550_ = true;
                }
                let _e429 = phi_549_;
                let _e431 = phi_550_;
                if _e431 {
                    phi_554_ = _e406;
                } else {
                    phi_554_ = _e429;
                }
                let _e433 = phi_554_;
                if (_e407 > -8388608f) {
                    let _e445 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e445 > _e407) {
                        phi_574_ = 1f;
                    } else {
                        phi_574_ = 0f;
                    }
                    let _e448 = phi_574_;
                    if (_e407 < 8388608f) {
                        phi_579_ = (_e445 - _e448);
                        phi_580_ = false;
                    } else {
                        phi_579_ = f32();
                        phi_580_ = true;
                    }
                    let _e451 = phi_579_;
                    let _e453 = phi_580_;
                    phi_581_ = _e451;
                    phi_582_ = _e453;
                } else {
                    phi_581_ = f32();
                    phi_582_ = true;
                }
                let _e455 = phi_581_;
                let _e457 = phi_582_;
                if _e457 {
                    phi_586_ = _e407;
                } else {
                    phi_586_ = _e455;
                }
                let _e459 = phi_586_;
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
                local = _e490;
                let _e494 = ((0u * _e492) * _e492);
                let _e496 = (bitcast<i32>(_e492) - 1i);
                if (_e470 > 0i) {
                    phi_634_ = _e470;
                } else {
                    phi_634_ = 0i;
                }
                let _e499 = phi_634_;
                if (_e479 > 0i) {
                    phi_639_ = _e479;
                } else {
                    phi_639_ = 0i;
                }
                let _e502 = phi_639_;
                if (_e499 < _e496) {
                    phi_644_ = _e499;
                } else {
                    phi_644_ = _e496;
                }
                let _e505 = phi_644_;
                if (_e502 < _e496) {
                    phi_649_ = _e502;
                } else {
                    phi_649_ = _e496;
                }
                let _e508 = phi_649_;
                let _e509 = bitcast<u32>(_e505);
                let _e511 = (_e470 + 1i);
                let _e512 = (_e479 + 1i);
                if (_e511 > 0i) {
                    phi_658_ = _e511;
                } else {
                    phi_658_ = 0i;
                }
                let _e515 = phi_658_;
                if (_e512 > 0i) {
                    phi_663_ = _e512;
                } else {
                    phi_663_ = 0i;
                }
                let _e518 = phi_663_;
                if (_e515 < _e496) {
                    phi_668_ = _e515;
                } else {
                    phi_668_ = _e496;
                }
                let _e521 = phi_668_;
                if (_e518 < _e496) {
                    phi_673_ = _e518;
                } else {
                    phi_673_ = _e496;
                }
                let _e524 = phi_673_;
                let _e525 = bitcast<u32>(_e521);
                let _e527 = (bitcast<u32>(_e508) * _e492);
                let _e528 = (bitcast<u32>(_e524) * _e492);
                let _e533 = ((_e527 + _e509) + _e494);
                let _e534 = ((_e527 + _e525) + _e494);
                let _e535 = ((_e528 + _e509) + _e494);
                let _e536 = ((_e528 + _e525) + _e494);
                if (_e533 < _e54) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e533)];
                if (_e534 < _e54) {
                } else {
                    return;
                }
                let _e552 = map.member[(0u + _e534)];
                if (_e535 < _e54) {
                } else {
                    return;
                }
                let _e568 = map.member[(0u + _e535)];
                if (_e536 < _e54) {
                } else {
                    return;
                }
                let _e584 = map.member[(0u + _e536)];
                let _e598 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local), vec4<f32>(((((_e540.x * _e482) + (_e552.x * _e484)) + (_e568.x * _e486)) + (_e584.x * _e487)), ((((_e540.y * _e482) + (_e552.y * _e484)) + (_e568.y * _e486)) + (_e584.y * _e487)), ((((_e540.z * _e482) + (_e552.z * _e484)) + (_e568.z * _e486)) + (_e584.z * _e487)), ((((_e540.w * _e482) + (_e552.w * _e484)) + (_e568.w * _e486)) + (_e584.w * _e487))), _e400);
                phi_762_ = evaluate_Verdict(_e598, false);
                phi_763_ = evaluate_Verdict();
                phi_764_ = false;
            } else {
                phi_762_ = evaluate_Verdict();
                phi_763_ = evaluate_Verdict(1f, false);
                phi_764_ = true;
            }
            let _e602 = phi_762_;
            let _e604 = phi_763_;
            let _e606 = phi_764_;
            phi_765_ = _e604;
            phi_766_ = _e602;
            phi_767_ = _e606;
        }
        let _e608 = phi_765_;
        let _e610 = phi_766_;
        let _e612 = phi_767_;
        if _e612 {
            phi_771_ = _e608;
        } else {
            phi_771_ = _e610;
        }
        let _e614 = phi_771_;
        if (_e63.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e63.first_primitive)] = _e614.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
