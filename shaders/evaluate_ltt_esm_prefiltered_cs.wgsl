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

struct type_47 {
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
var<storage, read_write> list: type_47;
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(2) 
var<storage> map: type_36;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_156_: lt_bvh_traverse_Tree;
    var phi_157_: bool;
    var phi_158_: lt_bvh_traverse_Tree;
    var phi_159_: bool;
    var phi_164_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_156_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_157_ = false;
        } else {
            phi_156_ = lt_bvh_traverse_Tree();
            phi_157_ = true;
        }
        let _e62 = phi_156_;
        let _e64 = phi_157_;
        phi_158_ = _e62;
        phi_159_ = _e64;
    } else {
        phi_158_ = lt_bvh_traverse_Tree();
        phi_159_ = true;
    }
    let _e66 = phi_158_;
    let _e68 = phi_159_;
    if _e68 {
        phi_164_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_164_ = _e66;
    }
    let _e73 = phi_164_;
    return lt_bvh_traverse_Tree(_e73.root, _e73.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_184_: bool;
    var phi_188_: f32;

    let _e50 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_184_ = true;
    } else {
        let _e54 = (84f < _e50);
        if _e54 {
        }
        phi_184_ = _e54;
    }
    let _e56 = phi_184_;
    if _e56 {
        phi_188_ = 84f;
    } else {
        phi_188_ = _e50;
    }
    let _e58 = phi_188_;
    return _e58;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_209_: f32;
    var phi_224_: f32;
    var phi_229_: f32;
    var phi_251_: f32;
    var phi_256_: f32;
    var phi_257_: bool;
    var phi_258_: f32;
    var phi_259_: bool;
    var phi_263_: f32;
    var phi_301_: f32;
    var phi_317_: f32;
    var phi_318_: f32;
    var phi_319_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_209_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_208_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_207_ = 1f;
            } else {
                phi_207_ = param_7;
            }
            let _e58 = phi_207_;
            phi_208_ = _e58;
        }
        let _e60 = phi_208_;
        phi_209_ = _e60;
    }
    let _e62 = phi_209_;
    let _e64 = _lt_math_esm_Esm_clamped_exponent(param_5);
    let _e66 = (_e64 * (1f - _e62));
    if ((bitcast<u32>(_e66) & 2147483647u) > 2139095040u) {
        phi_301_ = _e66;
    } else {
        if (_e66 < -87f) {
            phi_224_ = -87f;
        } else {
            phi_224_ = _e66;
        }
        let _e72 = phi_224_;
        if (_e72 > 88f) {
            phi_229_ = 88f;
        } else {
            phi_229_ = _e72;
        }
        let _e75 = phi_229_;
        let _e77 = ((_e75 * 1.442695f) + 0.5f);
        if (_e77 > -8388608f) {
            let _e89 = f32(select(0i, select(select(i32(_e77), i32(-2147483648), (_e77 < bitcast<f32>(3472883712u))), 2147483647i, (_e77 > bitcast<f32>(1325400063u))), (_e77 == _e77)));
            if (_e89 > _e77) {
                phi_251_ = 1f;
            } else {
                phi_251_ = 0f;
            }
            let _e92 = phi_251_;
            if (_e77 < 8388608f) {
                phi_256_ = (_e89 - _e92);
                phi_257_ = false;
            } else {
                phi_256_ = f32();
                phi_257_ = true;
            }
            let _e95 = phi_256_;
            let _e97 = phi_257_;
            phi_258_ = _e95;
            phi_259_ = _e97;
        } else {
            phi_258_ = f32();
            phi_259_ = true;
        }
        let _e99 = phi_258_;
        let _e101 = phi_259_;
        if _e101 {
            phi_263_ = _e77;
        } else {
            phi_263_ = _e99;
        }
        let _e103 = phi_263_;
        let _e107 = ((_e75 - (_e103 * 0.69314575f)) - (_e103 * 0.0000014286068f));
        phi_301_ = ((((((((((((((((1f / 5040f) * _e107) + (1f / 720f)) * _e107) + (1f / 120f)) * _e107) + (1f / 24f)) * _e107) + (1f / 6f)) * _e107) + 0.5f) * _e107) + 1f) * _e107) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e103), i32(-2147483648), (_e103 < bitcast<f32>(3472883712u))), 2147483647i, (_e103 > bitcast<f32>(1325400063u))), (_e103 == _e103)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e143 = phi_301_;
    let _e144 = (param_6.x * _e143);
    if ((bitcast<u32>(_e144) & 2147483647u) > 2139095040u) {
        phi_319_ = _e144;
    } else {
        if (_e144 < 0f) {
            phi_318_ = 0f;
        } else {
            if (_e144 > 1f) {
                phi_317_ = 1f;
            } else {
                phi_317_ = _e144;
            }
            let _e151 = phi_317_;
            phi_318_ = _e151;
        }
        let _e153 = phi_318_;
        phi_319_ = _e153;
    }
    let _e155 = phi_319_;
    return _e155;
}

fn function_() {
    var local_1: f32;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_380_: bool;
    var phi_424_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_428_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_505_: bool;
    var phi_514_: bool;
    var phi_523_: bool;
    var phi_524_: bool;
    var phi_525_: bool;
    var phi_526_: bool;
    var phi_527_: bool;
    var phi_528_: bool;
    var phi_529_: bool;
    var phi_533_: bool;
    var phi_569_: f32;
    var phi_574_: f32;
    var phi_575_: bool;
    var phi_576_: f32;
    var phi_577_: bool;
    var phi_581_: f32;
    var phi_601_: f32;
    var phi_606_: f32;
    var phi_607_: bool;
    var phi_608_: f32;
    var phi_609_: bool;
    var phi_613_: f32;
    var phi_659_: i32;
    var phi_664_: i32;
    var phi_669_: i32;
    var phi_674_: i32;
    var phi_683_: i32;
    var phi_688_: i32;
    var phi_693_: i32;
    var phi_698_: i32;
    var phi_789_: bool;
    var phi_797_: bool;
    var phi_802_: f32;
    var phi_805_: evaluate_Verdict;
    var phi_806_: evaluate_Verdict;
    var phi_810_: bool;
    var phi_811_: u32;
    var phi_817_: u32;

    let _e50 = id_1;
    let _e51 = local_2;
    let _e56 = arrayLength((&map.member));
    if (_e51 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e50, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.light;
        let _e76 = samples.member[_e66.first_primitive].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[_e66.first_primitive].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[_e66.first_primitive].normal[2u];
                let _e88 = global[2u];
                phi_373_ = (_e86 == _e88);
                phi_374_ = false;
            } else {
                phi_373_ = bool();
                phi_374_ = true;
            }
            let _e91 = phi_373_;
            let _e93 = phi_374_;
            phi_375_ = _e91;
            phi_376_ = _e93;
        } else {
            phi_375_ = bool();
            phi_376_ = true;
        }
        let _e95 = phi_375_;
        let _e97 = phi_376_;
        if _e97 {
            phi_380_ = false;
        } else {
            phi_380_ = _e95;
        }
        let _e99 = phi_380_;
        if !(_e99) {
            let _e102 = samples.member[_e66.first_primitive].normal;
            let _e104 = samples.member[_e66.first_primitive].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[_e66.first_primitive].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_424_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_424_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_424_;
            phi_428_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_428_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_428_;
        if _e179.unnamed_1 {
            phi_806_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[_e66.first_primitive].position;
            let _e193 = p.member.projection.row_w;
            let _e204 = ((((_e193.x * _e187.x) + (_e193.y * _e187.y)) + (_e193.z * _e187.z)) + (_e193.w * 1f));
            let _e206 = p.member.projection.row_x;
            let _e218 = (((((_e206.x * _e187.x) + (_e206.y * _e187.y)) + (_e206.z * _e187.z)) + (_e206.w * 1f)) / _e204);
            let _e220 = p.member.projection.row_y;
            let _e232 = (((((_e220.x * _e187.x) + (_e220.y * _e187.y)) + (_e220.z * _e187.z)) + (_e220.w * 1f)) / _e204);
            let _e234 = p.member.projection.row_z;
            let _e245 = ((((_e234.x * _e187.x) + (_e234.y * _e187.y)) + (_e234.z * _e187.z)) + (_e234.w * 1f));
            if (_e204 > 0f) {
                if (_e218 >= 0f) {
                    phi_505_ = (_e218 <= 1f);
                } else {
                    phi_505_ = false;
                }
                let _e250 = phi_505_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_514_ = (_e232 <= 1f);
                    } else {
                        phi_514_ = false;
                    }
                    let _e254 = phi_514_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_523_ = (_e245 <= 1f);
                        } else {
                            phi_523_ = false;
                        }
                        let _e258 = phi_523_;
                        phi_524_ = _e258;
                        phi_525_ = false;
                    } else {
                        phi_524_ = bool();
                        phi_525_ = true;
                    }
                    let _e260 = phi_524_;
                    let _e262 = phi_525_;
                    phi_526_ = _e260;
                    phi_527_ = _e262;
                } else {
                    phi_526_ = bool();
                    phi_527_ = true;
                }
                let _e264 = phi_526_;
                let _e266 = phi_527_;
                phi_528_ = _e264;
                phi_529_ = _e266;
            } else {
                phi_528_ = bool();
                phi_529_ = true;
            }
            let _e268 = phi_528_;
            let _e270 = phi_529_;
            if _e270 {
                phi_533_ = false;
            } else {
                phi_533_ = _e268;
            }
            let _e272 = phi_533_;
            if _e272 {
                let _e274 = p.member.map_size;
                let _e275 = f32(_e274);
                let _e278 = ((_e218 * _e275) - 0.5f);
                let _e279 = ((_e232 * _e275) - 0.5f);
                if (_e278 > -8388608f) {
                    let _e291 = f32(select(0i, select(select(i32(_e278), i32(-2147483648), (_e278 < bitcast<f32>(3472883712u))), 2147483647i, (_e278 > bitcast<f32>(1325400063u))), (_e278 == _e278)));
                    if (_e291 > _e278) {
                        phi_569_ = 1f;
                    } else {
                        phi_569_ = 0f;
                    }
                    let _e294 = phi_569_;
                    if (_e278 < 8388608f) {
                        phi_574_ = (_e291 - _e294);
                        phi_575_ = false;
                    } else {
                        phi_574_ = f32();
                        phi_575_ = true;
                    }
                    let _e297 = phi_574_;
                    let _e299 = phi_575_;
                    phi_576_ = _e297;
                    phi_577_ = _e299;
                } else {
                    phi_576_ = f32();
                    phi_577_ = true;
                }
                let _e301 = phi_576_;
                let _e303 = phi_577_;
                if _e303 {
                    phi_581_ = _e278;
                } else {
                    phi_581_ = _e301;
                }
                let _e305 = phi_581_;
                if (_e279 > -8388608f) {
                    let _e317 = f32(select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < bitcast<f32>(3472883712u))), 2147483647i, (_e279 > bitcast<f32>(1325400063u))), (_e279 == _e279)));
                    if (_e317 > _e279) {
                        phi_601_ = 1f;
                    } else {
                        phi_601_ = 0f;
                    }
                    let _e320 = phi_601_;
                    if (_e279 < 8388608f) {
                        phi_606_ = (_e317 - _e320);
                        phi_607_ = false;
                    } else {
                        phi_606_ = f32();
                        phi_607_ = true;
                    }
                    let _e323 = phi_606_;
                    let _e325 = phi_607_;
                    phi_608_ = _e323;
                    phi_609_ = _e325;
                } else {
                    phi_608_ = f32();
                    phi_609_ = true;
                }
                let _e327 = phi_608_;
                let _e329 = phi_609_;
                if _e329 {
                    phi_613_ = _e279;
                } else {
                    phi_613_ = _e327;
                }
                let _e331 = phi_613_;
                let _e332 = (_e278 - _e305);
                let _e333 = (_e279 - _e331);
                let _e342 = select(0i, select(select(i32(_e305), i32(-2147483648), (_e305 < bitcast<f32>(3472883712u))), 2147483647i, (_e305 > bitcast<f32>(1325400063u))), (_e305 == _e305));
                let _e351 = select(0i, select(select(i32(_e331), i32(-2147483648), (_e331 < bitcast<f32>(3472883712u))), 2147483647i, (_e331 > bitcast<f32>(1325400063u))), (_e331 == _e331));
                let _e354 = ((1f - _e332) * (1f - _e333));
                let _e356 = (_e332 * (1f - _e333));
                let _e358 = ((1f - _e332) * _e333);
                let _e359 = (_e332 * _e333);
                let _e361 = p.member.test;
                let _e362 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e361);
                let _e364 = p.member.map_size;
                local_1 = _e362;
                let _e366 = (bitcast<i32>(_e364) - 1i);
                if (_e342 > 0i) {
                    phi_659_ = _e342;
                } else {
                    phi_659_ = 0i;
                }
                let _e369 = phi_659_;
                if (_e351 > 0i) {
                    phi_664_ = _e351;
                } else {
                    phi_664_ = 0i;
                }
                let _e372 = phi_664_;
                if (_e369 < _e366) {
                    phi_669_ = _e369;
                } else {
                    phi_669_ = _e366;
                }
                let _e375 = phi_669_;
                if (_e372 < _e366) {
                    phi_674_ = _e372;
                } else {
                    phi_674_ = _e366;
                }
                let _e378 = phi_674_;
                let _e379 = bitcast<u32>(_e375);
                let _e381 = (_e342 + 1i);
                let _e382 = (_e351 + 1i);
                if (_e381 > 0i) {
                    phi_683_ = _e381;
                } else {
                    phi_683_ = 0i;
                }
                let _e385 = phi_683_;
                if (_e382 > 0i) {
                    phi_688_ = _e382;
                } else {
                    phi_688_ = 0i;
                }
                let _e388 = phi_688_;
                if (_e385 < _e366) {
                    phi_693_ = _e385;
                } else {
                    phi_693_ = _e366;
                }
                let _e391 = phi_693_;
                if (_e388 < _e366) {
                    phi_698_ = _e388;
                } else {
                    phi_698_ = _e366;
                }
                let _e394 = phi_698_;
                let _e395 = bitcast<u32>(_e391);
                let _e397 = (bitcast<u32>(_e378) * _e364);
                let _e398 = (bitcast<u32>(_e394) * _e364);
                let _e399 = (_e397 + _e379);
                let _e400 = (_e397 + _e395);
                let _e401 = (_e398 + _e379);
                let _e402 = (_e398 + _e395);
                if (_e399 < _e56) {
                } else {
                    return;
                }
                let _e406 = map.member[(0u + _e399)];
                if (_e400 < _e56) {
                } else {
                    return;
                }
                let _e418 = map.member[(0u + _e400)];
                if (_e401 < _e56) {
                } else {
                    return;
                }
                let _e434 = map.member[(0u + _e401)];
                if (_e402 < _e56) {
                } else {
                    return;
                }
                let _e450 = map.member[(0u + _e402)];
                let _e464 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility((&local_1), vec4<f32>(((((_e406.x * _e354) + (_e418.x * _e356)) + (_e434.x * _e358)) + (_e450.x * _e359)), ((((_e406.y * _e354) + (_e418.y * _e356)) + (_e434.y * _e358)) + (_e450.y * _e359)), ((((_e406.z * _e354) + (_e418.z * _e356)) + (_e434.z * _e358)) + (_e450.z * _e359)), ((((_e406.w * _e354) + (_e418.w * _e356)) + (_e434.w * _e358)) + (_e450.w * _e359))), _e245);
                let _e466 = p.member.epsilon;
                if (_e464 <= _e466) {
                    phi_789_ = true;
                } else {
                    phi_789_ = (_e464 >= (1f - _e466));
                }
                let _e471 = phi_789_;
                if ((bitcast<u32>(_e464) & 2147483647u) > 2139095040u) {
                    phi_797_ = true;
                } else {
                    phi_797_ = !(_e471);
                }
                let _e477 = phi_797_;
                if (_e464 > 0.5f) {
                    phi_802_ = 1f;
                } else {
                    phi_802_ = 0f;
                }
                let _e480 = phi_802_;
                phi_805_ = evaluate_Verdict(_e480, _e477);
            } else {
                phi_805_ = evaluate_Verdict(1f, true);
            }
            let _e484 = phi_805_;
            phi_806_ = _e484;
        }
        let _e486 = phi_806_;
        visibility.member[_e66.first_primitive] = _e486.visibility;
        phi_810_ = _e486.is_doubted;
        phi_811_ = _e66.first_primitive;
    } else {
        phi_810_ = false;
        phi_811_ = 0u;
    }
    let _e491 = phi_810_;
    let _e493 = phi_811_;
    if _e491 {
        let _e495 = atomicAdd((&shared_[0u]), 1u);
        phi_817_ = _e495;
    } else {
        phi_817_ = 0u;
    }
    let _e497 = phi_817_;
    workgroupBarrier();
    if (_e51 == 0u) {
        let _e501 = atomicLoad((&shared_[0u]));
        let _e502 = atomicAdd((&list.member[3u]), _e501);
        atomicStore((&shared_[1u]), _e502);
    }
    workgroupBarrier();
    if _e491 {
        let _e505 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e505) + _e497)]), _e493);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_prefiltered_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
