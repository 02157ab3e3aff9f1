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
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_159_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_151_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_152_ = false;
        } else {
            phi_151_ = lt_bvh_traverse_Tree();
            phi_152_ = true;
        }
        let _e51 = phi_151_;
        let _e53 = phi_152_;
        phi_153_ = _e51;
        phi_154_ = _e53;
    } else {
        phi_153_ = lt_bvh_traverse_Tree();
        phi_154_ = true;
    }
    let _e55 = phi_153_;
    let _e57 = phi_154_;
    if _e57 {
        phi_159_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_159_ = _e55;
    }
    let _e62 = phi_159_;
    return lt_bvh_traverse_Tree(_e62.root, _e62.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_184_: f32;
    var phi_185_: f32;
    var phi_186_: f32;
    var phi_204_: bool;
    var phi_208_: f32;
    var phi_220_: bool;
    var phi_227_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_186_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_185_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_184_ = 1f;
            } else {
                phi_184_ = param_6;
            }
            let _e47 = phi_184_;
            phi_185_ = _e47;
        }
        let _e49 = phi_185_;
        phi_186_ = _e49;
    }
    let _e51 = phi_186_;
    let _e54 = (*param_4);
    let _e58 = ((param_5.y - (param_5.x * param_5.x)) + (0.00000047683716f * param_5.y));
    if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
        phi_204_ = true;
    } else {
        let _e62 = (_e54 > _e58);
        if _e62 {
        }
        phi_204_ = _e62;
    }
    let _e64 = phi_204_;
    if _e64 {
        phi_208_ = _e54;
    } else {
        phi_208_ = _e58;
    }
    let _e66 = phi_208_;
    let _e67 = (_e51 - param_5.x);
    if (_e67 <= 0f) {
        let _e71 = ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u);
        if _e71 {
        }
        phi_220_ = _e71;
    } else {
        phi_220_ = true;
    }
    let _e73 = phi_220_;
    if _e73 {
        phi_227_ = (_e66 / (_e66 + (_e67 * _e67)));
    } else {
        phi_227_ = 1f;
    }
    let _e78 = phi_227_;
    if ((bitcast<u32>(_e78) & 2147483647u) > 2139095040u) {
        phi_244_ = _e78;
    } else {
        if (_e78 < 0f) {
            phi_243_ = 0f;
        } else {
            if (_e78 > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = _e78;
            }
            let _e85 = phi_242_;
            phi_243_ = _e85;
        }
        let _e87 = phi_243_;
        phi_244_ = _e87;
    }
    let _e89 = phi_244_;
    return _e89;
}

fn function_() {
    var local_1: f32;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_302_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_384_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_385_: bool;
    var phi_386_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_387_: bool;
    var phi_394_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_398_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_472_: bool;
    var phi_481_: bool;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_496_: bool;
    var phi_500_: bool;
    var phi_590_: f32;
    var phi_593_: f32;
    var phi_622_: f32;
    var phi_627_: f32;
    var phi_628_: bool;
    var phi_629_: f32;
    var phi_630_: bool;
    var phi_634_: f32;
    var phi_654_: f32;
    var phi_659_: f32;
    var phi_660_: bool;
    var phi_661_: f32;
    var phi_662_: bool;
    var phi_666_: f32;
    var phi_714_: i32;
    var phi_719_: i32;
    var phi_724_: i32;
    var phi_729_: i32;
    var phi_738_: i32;
    var phi_743_: i32;
    var phi_748_: i32;
    var phi_753_: i32;
    var phi_848_: bool;
    var phi_856_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_873_: f32;
    var phi_879_: f32;
    var phi_881_: evaluate_Verdict;
    var phi_886_: evaluate_Verdict;
    var phi_887_: evaluate_Verdict;
    var phi_891_: bool;
    var phi_892_: u32;
    var phi_903_: u32;

    let _e39 = id_1;
    let _e40 = local_2;
    let _e45 = arrayLength((&map.member));
    let _e50 = p.member.size[0u];
    let _e52 = p.member.size[1u];
    let _e53 = lt_shaders_entry_pixel_index(_e39, _e50, _e52);
    if (bitcast<i32>(_e53.root) != 0i) {
        let _e60 = p.member.projection;
        let _e61 = lt_math_OneLevel(_e60);
        let _e65 = samples.member[_e53.first_primitive].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[_e53.first_primitive].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[_e53.first_primitive].normal[2u];
                let _e77 = global[2u];
                phi_295_ = (_e75 == _e77);
                phi_296_ = false;
            } else {
                phi_295_ = bool();
                phi_296_ = true;
            }
            let _e80 = phi_295_;
            let _e82 = phi_296_;
            phi_297_ = _e80;
            phi_298_ = _e82;
        } else {
            phi_297_ = bool();
            phi_298_ = true;
        }
        let _e84 = phi_297_;
        let _e86 = phi_298_;
        if _e86 {
            phi_302_ = false;
        } else {
            phi_302_ = _e84;
        }
        let _e88 = phi_302_;
        if !(_e88) {
            let _e91 = samples.member[_e53.first_primitive].position;
            let _e93 = p.member.light.place;
            let _e99 = p.member.light.place[3u];
            let _e106 = (_e93.x - (_e91.x * _e99));
            let _e107 = (_e93.y - (_e91.y * _e99));
            let _e108 = (_e93.z - (_e91.z * _e99));
            let _e110 = samples.member[_e53.first_primitive].normal;
            if ((((_e110.x * _e106) + (_e110.y * _e107)) + (_e110.z * _e108)) > 0f) {
                let _e124 = (((_e106 * _e106) + (_e107 * _e107)) + (_e108 * _e108));
                let _e126 = p.member.light.axis;
                let _e138 = p.member.light.place[3u];
                if (_e138 == 0f) {
                    phi_373_ = true;
                } else {
                    let _e141 = p.member.light.range_squared;
                    if (_e124 <= _e141) {
                        let _e144 = p.member.light.cos_outer;
                        phi_372_ = (-((((_e106 * _e126.x) + (_e107 * _e126.y)) + (_e108 * _e126.z))) >= (_e144 * sqrt(_e124)));
                    } else {
                        phi_372_ = false;
                    }
                    let _e149 = phi_372_;
                    phi_373_ = _e149;
                }
                let _e151 = phi_373_;
                if _e151 {
                    let _e153 = samples.member[_e53.first_primitive].flags;
                    let _e161 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e161.unnamed.visibility, false), _e161.unnamed_1);
                    phi_384_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e167.unnamed, ((_e153 & 1u) == 0u));
                    phi_385_ = false;
                } else {
                    phi_384_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_385_ = true;
                }
                let _e172 = phi_384_;
                let _e174 = phi_385_;
                phi_386_ = _e172;
                phi_387_ = _e174;
            } else {
                phi_386_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_387_ = true;
            }
            let _e176 = phi_386_;
            let _e178 = phi_387_;
            if _e178 {
                let _e184 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e190 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e184.unnamed.visibility, false), _e184.unnamed_1);
                phi_394_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e190.unnamed, true);
            } else {
                phi_394_ = _e176;
            }
            let _e195 = phi_394_;
            phi_398_ = _e195;
        } else {
            let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e207 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e201.unnamed.visibility, false), _e201.unnamed_1);
            phi_398_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e207.unnamed, true);
        }
        let _e212 = phi_398_;
        if _e212.unnamed_1 {
            phi_887_ = evaluate_Verdict(_e212.unnamed.visibility, _e212.unnamed.is_doubted);
        } else {
            let _e220 = samples.member[_e53.first_primitive].position;
            let _e238 = ((((_e61.projection.row_w.x * _e220.x) + (_e61.projection.row_w.y * _e220.y)) + (_e61.projection.row_w.z * _e220.z)) + (_e61.projection.row_w.w * 1f));
            let _e252 = (((((_e61.projection.row_x.x * _e220.x) + (_e61.projection.row_x.y * _e220.y)) + (_e61.projection.row_x.z * _e220.z)) + (_e61.projection.row_x.w * 1f)) / _e238);
            let _e266 = (((((_e61.projection.row_y.x * _e220.x) + (_e61.projection.row_y.y * _e220.y)) + (_e61.projection.row_y.z * _e220.z)) + (_e61.projection.row_y.w * 1f)) / _e238);
            let _e279 = ((((_e61.projection.row_z.x * _e220.x) + (_e61.projection.row_z.y * _e220.y)) + (_e61.projection.row_z.z * _e220.z)) + (_e61.projection.row_z.w * 1f));
            if (_e238 > 0f) {
                if (_e252 >= 0f) {
                    phi_472_ = (_e252 <= 1f);
                } else {
                    phi_472_ = false;
                }
                let _e284 = phi_472_;
                if _e284 {
                    if (_e266 >= 0f) {
                        phi_481_ = (_e266 <= 1f);
                    } else {
                        phi_481_ = false;
                    }
                    let _e288 = phi_481_;
                    if _e288 {
                        if (_e279 >= 0f) {
                            phi_490_ = (_e279 <= 1f);
                        } else {
                            phi_490_ = false;
                        }
                        let _e292 = phi_490_;
                        phi_491_ = _e292;
                        phi_492_ = false;
                    } else {
                        phi_491_ = bool();
                        phi_492_ = true;
                    }
                    let _e294 = phi_491_;
                    let _e296 = phi_492_;
                    phi_493_ = _e294;
                    phi_494_ = _e296;
                } else {
                    phi_493_ = bool();
                    phi_494_ = true;
                }
                let _e298 = phi_493_;
                let _e300 = phi_494_;
                phi_495_ = _e298;
                phi_496_ = _e300;
            } else {
                phi_495_ = bool();
                phi_496_ = true;
            }
            let _e302 = phi_495_;
            let _e304 = phi_496_;
            if _e304 {
                phi_500_ = false;
            } else {
                phi_500_ = _e302;
            }
            let _e306 = phi_500_;
            if _e306 {
                if (0f > 0f) {
                    let _e309 = samples.member[_e53.first_primitive].normal;
                    let _e311 = p.member.map_size;
                    let _e381 = ((abs(((((_e60.row_x.x * _e309.x) + (_e60.row_x.y * _e309.y)) + (_e60.row_x.z * _e309.z)) / (((_e60.row_x.x * _e60.row_x.x) + (_e60.row_x.y * _e60.row_x.y)) + (_e60.row_x.z * _e60.row_x.z)))) + abs(((((_e60.row_y.x * _e309.x) + (_e60.row_y.y * _e309.y)) + (_e60.row_y.z * _e309.z)) / (((_e60.row_y.x * _e60.row_y.x) + (_e60.row_y.y * _e60.row_y.y)) + (_e60.row_y.z * _e60.row_y.z))))) / (abs(((((_e60.row_z.x * _e309.x) + (_e60.row_z.y * _e309.y)) + (_e60.row_z.z * _e309.z)) / (((_e60.row_z.x * _e60.row_z.x) + (_e60.row_z.y * _e60.row_z.y)) + (_e60.row_z.z * _e60.row_z.z)))) * f32(_e311)));
                    if (_e381 < 0.002f) {
                        phi_590_ = _e381;
                    } else {
                        phi_590_ = 0.002f;
                    }
                    let _e384 = phi_590_;
                    phi_593_ = (_e279 - (0f * _e384));
                } else {
                    phi_593_ = _e279;
                }
                let _e388 = phi_593_;
                let _e390 = p.member.map_size;
                let _e391 = f32(_e390);
                let _e394 = ((_e252 * _e391) - 0.5f);
                let _e395 = ((_e266 * _e391) - 0.5f);
                if (_e394 > -8388608f) {
                    let _e407 = f32(select(0i, select(select(i32(_e394), i32(-2147483648), (_e394 < bitcast<f32>(3472883712u))), 2147483647i, (_e394 > bitcast<f32>(1325400063u))), (_e394 == _e394)));
                    if (_e407 > _e394) {
                        phi_622_ = 1f;
                    } else {
                        phi_622_ = 0f;
                    }
                    let _e410 = phi_622_;
                    if (_e394 < 8388608f) {
                        phi_627_ = (_e407 - _e410);
                        phi_628_ = false;
                    } else {
                        phi_627_ = f32();
                        phi_628_ = true;
                    }
                    let _e413 = phi_627_;
                    let _e415 = phi_628_;
                    phi_629_ = _e413;
                    phi_630_ = _e415;
                } else {
                    phi_629_ = f32();
                    phi_630_ = true;
                }
                let _e417 = phi_629_;
                let _e419 = phi_630_;
                if _e419 {
                    phi_634_ = _e394;
                } else {
                    phi_634_ = _e417;
                }
                let _e421 = phi_634_;
                if (_e395 > -8388608f) {
                    let _e433 = f32(select(0i, select(select(i32(_e395), i32(-2147483648), (_e395 < bitcast<f32>(3472883712u))), 2147483647i, (_e395 > bitcast<f32>(1325400063u))), (_e395 == _e395)));
                    if (_e433 > _e395) {
                        phi_654_ = 1f;
                    } else {
                        phi_654_ = 0f;
                    }
                    let _e436 = phi_654_;
                    if (_e395 < 8388608f) {
                        phi_659_ = (_e433 - _e436);
                        phi_660_ = false;
                    } else {
                        phi_659_ = f32();
                        phi_660_ = true;
                    }
                    let _e439 = phi_659_;
                    let _e441 = phi_660_;
                    phi_661_ = _e439;
                    phi_662_ = _e441;
                } else {
                    phi_661_ = f32();
                    phi_662_ = true;
                }
                let _e443 = phi_661_;
                let _e445 = phi_662_;
                if _e445 {
                    phi_666_ = _e395;
                } else {
                    phi_666_ = _e443;
                }
                let _e447 = phi_666_;
                let _e448 = (_e394 - _e421);
                let _e449 = (_e395 - _e447);
                let _e458 = select(0i, select(select(i32(_e421), i32(-2147483648), (_e421 < bitcast<f32>(3472883712u))), 2147483647i, (_e421 > bitcast<f32>(1325400063u))), (_e421 == _e421));
                let _e467 = select(0i, select(select(i32(_e447), i32(-2147483648), (_e447 < bitcast<f32>(3472883712u))), 2147483647i, (_e447 > bitcast<f32>(1325400063u))), (_e447 == _e447));
                let _e470 = ((1f - _e448) * (1f - _e449));
                let _e472 = (_e448 * (1f - _e449));
                let _e474 = ((1f - _e448) * _e449);
                let _e475 = (_e448 * _e449);
                let _e477 = p.member.test;
                let _e478 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e477);
                let _e480 = p.member.map_size;
                local_1 = _e478;
                let _e482 = ((0u * _e480) * _e480);
                let _e484 = (bitcast<i32>(_e480) - 1i);
                if (_e458 > 0i) {
                    phi_714_ = _e458;
                } else {
                    phi_714_ = 0i;
                }
                let _e487 = phi_714_;
                if (_e467 > 0i) {
                    phi_719_ = _e467;
                } else {
                    phi_719_ = 0i;
                }
                let _e490 = phi_719_;
                if (_e487 < _e484) {
                    phi_724_ = _e487;
                } else {
                    phi_724_ = _e484;
                }
                let _e493 = phi_724_;
                if (_e490 < _e484) {
                    phi_729_ = _e490;
                } else {
                    phi_729_ = _e484;
                }
                let _e496 = phi_729_;
                let _e497 = bitcast<u32>(_e493);
                let _e499 = (_e458 + 1i);
                let _e500 = (_e467 + 1i);
                if (_e499 > 0i) {
                    phi_738_ = _e499;
                } else {
                    phi_738_ = 0i;
                }
                let _e503 = phi_738_;
                if (_e500 > 0i) {
                    phi_743_ = _e500;
                } else {
                    phi_743_ = 0i;
                }
                let _e506 = phi_743_;
                if (_e503 < _e484) {
                    phi_748_ = _e503;
                } else {
                    phi_748_ = _e484;
                }
                let _e509 = phi_748_;
                if (_e506 < _e484) {
                    phi_753_ = _e506;
                } else {
                    phi_753_ = _e484;
                }
                let _e512 = phi_753_;
                let _e513 = bitcast<u32>(_e509);
                let _e515 = (bitcast<u32>(_e496) * _e480);
                let _e516 = (bitcast<u32>(_e512) * _e480);
                let _e521 = ((_e515 + _e497) + _e482);
                let _e522 = ((_e515 + _e513) + _e482);
                let _e523 = ((_e516 + _e497) + _e482);
                let _e524 = ((_e516 + _e513) + _e482);
                if (_e521 < _e45) {
                } else {
                    return;
                }
                let _e528 = map.member[(0u + _e521)];
                if (_e522 < _e45) {
                } else {
                    return;
                }
                let _e540 = map.member[(0u + _e522)];
                if (_e523 < _e45) {
                } else {
                    return;
                }
                let _e556 = map.member[(0u + _e523)];
                if (_e524 < _e45) {
                } else {
                    return;
                }
                let _e572 = map.member[(0u + _e524)];
                let _e586 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e528.x * _e470) + (_e540.x * _e472)) + (_e556.x * _e474)) + (_e572.x * _e475)), ((((_e528.y * _e470) + (_e540.y * _e472)) + (_e556.y * _e474)) + (_e572.y * _e475)), ((((_e528.z * _e470) + (_e540.z * _e472)) + (_e556.z * _e474)) + (_e572.z * _e475)), ((((_e528.w * _e470) + (_e540.w * _e472)) + (_e556.w * _e474)) + (_e572.w * _e475))), _e388);
                let _e588 = p.member.epsilon;
                if (_e586 <= _e588) {
                    phi_848_ = true;
                } else {
                    phi_848_ = (_e586 >= (1f - _e588));
                }
                let _e593 = phi_848_;
                if ((bitcast<u32>(_e586) & 2147483647u) > 2139095040u) {
                    phi_856_ = true;
                } else {
                    phi_856_ = !(_e593);
                }
                let _e599 = phi_856_;
                if _e599 {
                    if (_e586 > 0f) {
                        if (_e586 < 1f) {
                            phi_868_ = false;
                        } else {
                            phi_868_ = true;
                        }
                        let _e603 = phi_868_;
                        phi_869_ = _e603;
                    } else {
                        phi_869_ = true;
                    }
                    let _e605 = phi_869_;
                    if _e605 {
                        phi_873_ = 0.5f;
                    } else {
                        phi_873_ = _e586;
                    }
                    let _e607 = phi_873_;
                    phi_881_ = evaluate_Verdict(_e607, true);
                } else {
                    if (_e586 > 0.5f) {
                        phi_879_ = 1f;
                    } else {
                        phi_879_ = 0f;
                    }
                    let _e611 = phi_879_;
                    phi_881_ = evaluate_Verdict(_e611, false);
                }
                let _e614 = phi_881_;
                phi_886_ = evaluate_Verdict(_e614.visibility, _e614.is_doubted);
            } else {
                phi_886_ = evaluate_Verdict(0.5f, true);
            }
            let _e620 = phi_886_;
            phi_887_ = _e620;
        }
        let _e622 = phi_887_;
        visibility.member[_e53.first_primitive] = _e622.visibility;
        phi_891_ = _e622.is_doubted;
        phi_892_ = _e53.first_primitive;
    } else {
        phi_891_ = false;
        phi_892_ = 0u;
    }
    let _e627 = phi_891_;
    let _e629 = phi_892_;
    if (_e40 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e627 {
        let _e633 = atomicAdd((&shared_[0u]), 1u);
        phi_903_ = _e633;
    } else {
        phi_903_ = 0u;
    }
    let _e635 = phi_903_;
    workgroupBarrier();
    if (_e40 == 0u) {
        let _e639 = atomicLoad((&shared_[0u]));
        let _e640 = atomicAdd((&list.member[3u]), _e639);
        atomicStore((&shared_[1u]), _e640);
    }
    workgroupBarrier();
    if _e627 {
        let _e643 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e643) + _e635)]), _e629);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
