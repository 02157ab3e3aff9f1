struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
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

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_27 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_123_: lt_bvh_traverse_Tree;
    var phi_124_: bool;
    var phi_125_: lt_bvh_traverse_Tree;
    var phi_126_: bool;
    var phi_131_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_123_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_124_ = false;
        } else {
            phi_123_ = lt_bvh_traverse_Tree();
            phi_124_ = true;
        }
        let _e46 = phi_123_;
        let _e48 = phi_124_;
        phi_125_ = _e46;
        phi_126_ = _e48;
    } else {
        phi_125_ = lt_bvh_traverse_Tree();
        phi_126_ = true;
    }
    let _e50 = phi_125_;
    let _e52 = phi_126_;
    if _e52 {
        phi_131_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_131_ = _e50;
    }
    let _e57 = phi_131_;
    return lt_bvh_traverse_Tree(_e57.root, _e57.first_primitive);
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_3: ptr<function, f32>, param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_706_: f32;
    var phi_722_: f32;
    var phi_723_: f32;
    var phi_724_: f32;
    var phi_740_: f32;
    var phi_741_: f32;
    var phi_742_: f32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_821_: f32;
    var phi_838_: f32;
    var phi_839_: f32;
    var phi_840_: f32;
    var phi_866_: f32;
    var phi_867_: f32;
    var phi_868_: f32;

    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_688_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_687_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_686_ = 1f;
            } else {
                phi_686_ = param_4.x;
            }
            let _e44 = phi_686_;
            phi_687_ = _e44;
        }
        let _e46 = phi_687_;
        phi_688_ = _e46;
    }
    let _e48 = phi_688_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_706_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_705_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_704_ = 1f;
            } else {
                phi_704_ = param_4.y;
            }
            let _e56 = phi_704_;
            phi_705_ = _e56;
        }
        let _e58 = phi_705_;
        phi_706_ = _e58;
    }
    let _e60 = phi_706_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_724_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_723_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_722_ = 1f;
            } else {
                phi_722_ = param_4.z;
            }
            let _e68 = phi_722_;
            phi_723_ = _e68;
        }
        let _e70 = phi_723_;
        phi_724_ = _e70;
    }
    let _e72 = phi_724_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_742_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_741_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_740_ = 1f;
            } else {
                phi_740_ = param_4.w;
            }
            let _e80 = phi_740_;
            phi_741_ = _e80;
        }
        let _e82 = phi_741_;
        phi_742_ = _e82;
    }
    let _e84 = phi_742_;
    let _e85 = (*param_3);
    let _e86 = (_e48 + _e85);
    let _e87 = (_e60 + _e85);
    let _e88 = (_e72 + _e85);
    let _e89 = (_e84 + _e85);
    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_764_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_763_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_762_ = 1f;
            } else {
                phi_762_ = param_6;
            }
            let _e96 = phi_762_;
            phi_763_ = _e96;
        }
        let _e98 = phi_763_;
        phi_764_ = _e98;
    }
    let _e100 = phi_764_;
    if ((bitcast<u32>(_e86) & 2147483647u) > 2139095040u) {
        phi_783_ = _e86;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_782_ = _e100;
        } else {
            if (_e86 < _e100) {
                phi_781_ = 0f;
            } else {
                phi_781_ = 1f;
            }
            let _e109 = phi_781_;
            phi_782_ = _e109;
        }
        let _e111 = phi_782_;
        phi_783_ = _e111;
    }
    let _e113 = phi_783_;
    if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
        phi_802_ = _e87;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_801_ = _e100;
        } else {
            if (_e87 < _e100) {
                phi_800_ = 0f;
            } else {
                phi_800_ = 1f;
            }
            let _e122 = phi_800_;
            phi_801_ = _e122;
        }
        let _e124 = phi_801_;
        phi_802_ = _e124;
    }
    let _e126 = phi_802_;
    if ((bitcast<u32>(_e88) & 2147483647u) > 2139095040u) {
        phi_821_ = _e88;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_820_ = _e100;
        } else {
            if (_e88 < _e100) {
                phi_819_ = 0f;
            } else {
                phi_819_ = 1f;
            }
            let _e135 = phi_819_;
            phi_820_ = _e135;
        }
        let _e137 = phi_820_;
        phi_821_ = _e137;
    }
    let _e139 = phi_821_;
    if ((bitcast<u32>(_e89) & 2147483647u) > 2139095040u) {
        phi_840_ = _e89;
    } else {
        if ((bitcast<u32>(_e100) & 2147483647u) > 2139095040u) {
            phi_839_ = _e100;
        } else {
            if (_e89 < _e100) {
                phi_838_ = 0f;
            } else {
                phi_838_ = 1f;
            }
            let _e148 = phi_838_;
            phi_839_ = _e148;
        }
        let _e150 = phi_839_;
        phi_840_ = _e150;
    }
    let _e152 = phi_840_;
    let _e163 = ((((_e113 * param_5.x) + (_e126 * param_5.y)) + (_e139 * param_5.z)) + (_e152 * param_5.w));
    if ((bitcast<u32>(_e163) & 2147483647u) > 2139095040u) {
        phi_868_ = _e163;
    } else {
        if (_e163 < 0f) {
            phi_867_ = 0f;
        } else {
            if (_e163 > 1f) {
                phi_866_ = 1f;
            } else {
                phi_866_ = _e163;
            }
            let _e170 = phi_866_;
            phi_867_ = _e170;
        }
        let _e172 = phi_867_;
        phi_868_ = _e172;
    }
    let _e174 = phi_868_;
    return _e174;
}

fn _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_7: vec4<f32>) -> f32 {
    return param_7.x;
}

fn function_() {
    var local: f32;
    var phi_191_: bool;
    var phi_192_: bool;
    var phi_193_: bool;
    var phi_194_: bool;
    var phi_198_: bool;
    var phi_242_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_246_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_320_: bool;
    var phi_329_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_348_: bool;
    var phi_438_: f32;
    var phi_441_: f32;
    var phi_470_: f32;
    var phi_475_: f32;
    var phi_476_: bool;
    var phi_477_: f32;
    var phi_478_: bool;
    var phi_482_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_514_: f32;
    var phi_562_: i32;
    var phi_567_: i32;
    var phi_572_: i32;
    var phi_577_: i32;
    var phi_586_: i32;
    var phi_591_: i32;
    var phi_596_: i32;
    var phi_601_: i32;
    var phi_646_: evaluate_Verdict;
    var phi_647_: evaluate_Verdict;
    var phi_648_: bool;
    var phi_649_: evaluate_Verdict;
    var phi_650_: evaluate_Verdict;
    var phi_651_: bool;
    var phi_655_: evaluate_Verdict;

    let _e34 = id_1;
    let _e41 = arrayLength((&map.member));
    let _e47 = p.member.size[0u];
    let _e49 = p.member.size[1u];
    let _e50 = lt_shaders_entry_pixel_index(_e34, _e47, _e49);
    if (bitcast<i32>(_e50.root) != 0i) {
        let _e56 = p.member.projection;
        if (_e50.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e60 = lt_math_OneLevel(_e56);
        let _e62 = p.member.light;
        let _e65 = samples.member[(0u + _e50.first_primitive)].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[(0u + _e50.first_primitive)].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[(0u + _e50.first_primitive)].normal[2u];
                let _e77 = global[2u];
                phi_191_ = (_e75 == _e77);
                phi_192_ = false;
            } else {
                phi_191_ = bool();
                phi_192_ = true;
            }
            let _e80 = phi_191_;
            let _e82 = phi_192_;
            phi_193_ = _e80;
            phi_194_ = _e82;
        } else {
            phi_193_ = bool();
            phi_194_ = true;
        }
        let _e84 = phi_193_;
        let _e86 = phi_194_;
        if _e86 {
            phi_198_ = false;
        } else {
            phi_198_ = _e84;
        }
        let _e88 = phi_198_;
        if !(_e88) {
            let _e91 = samples.member[(0u + _e50.first_primitive)].normal;
            let _e93 = samples.member[(0u + _e50.first_primitive)].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[(0u + _e50.first_primitive)].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_242_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_242_;
            phi_246_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_246_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_246_;
        if _e168.unnamed_1 {
            phi_649_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
            phi_650_ = evaluate_Verdict();
            phi_651_ = true;
        } else {
            let _e176 = samples.member[(0u + _e50.first_primitive)].position;
            let _e194 = ((((_e60.projection.row_w.x * _e176.x) + (_e60.projection.row_w.y * _e176.y)) + (_e60.projection.row_w.z * _e176.z)) + (_e60.projection.row_w.w * 1f));
            let _e208 = (((((_e60.projection.row_x.x * _e176.x) + (_e60.projection.row_x.y * _e176.y)) + (_e60.projection.row_x.z * _e176.z)) + (_e60.projection.row_x.w * 1f)) / _e194);
            let _e222 = (((((_e60.projection.row_y.x * _e176.x) + (_e60.projection.row_y.y * _e176.y)) + (_e60.projection.row_y.z * _e176.z)) + (_e60.projection.row_y.w * 1f)) / _e194);
            let _e235 = ((((_e60.projection.row_z.x * _e176.x) + (_e60.projection.row_z.y * _e176.y)) + (_e60.projection.row_z.z * _e176.z)) + (_e60.projection.row_z.w * 1f));
            if (_e194 > 0f) {
                if (_e208 >= 0f) {
                    phi_320_ = (_e208 <= 1f);
                } else {
                    phi_320_ = false;
                }
                let _e240 = phi_320_;
                if _e240 {
                    if (_e222 >= 0f) {
                        phi_329_ = (_e222 <= 1f);
                    } else {
                        phi_329_ = false;
                    }
                    let _e244 = phi_329_;
                    if _e244 {
                        if (_e235 >= 0f) {
                            phi_338_ = (_e235 <= 1f);
                        } else {
                            phi_338_ = false;
                        }
                        let _e248 = phi_338_;
                        phi_339_ = _e248;
                        phi_340_ = false;
                    } else {
                        phi_339_ = bool();
                        phi_340_ = true;
                    }
                    let _e250 = phi_339_;
                    let _e252 = phi_340_;
                    phi_341_ = _e250;
                    phi_342_ = _e252;
                } else {
                    phi_341_ = bool();
                    phi_342_ = true;
                }
                let _e254 = phi_341_;
                let _e256 = phi_342_;
                phi_343_ = _e254;
                phi_344_ = _e256;
            } else {
                phi_343_ = bool();
                phi_344_ = true;
            }
            let _e258 = phi_343_;
            let _e260 = phi_344_;
            if _e260 {
                phi_348_ = false;
            } else {
                phi_348_ = _e258;
            }
            let _e262 = phi_348_;
            if _e262 {
                if (1f > 0f) {
                    let _e265 = samples.member[(0u + _e50.first_primitive)].normal;
                    let _e267 = p.member.map_size;
                    let _e337 = ((abs(((((_e56.row_x.x * _e265.x) + (_e56.row_x.y * _e265.y)) + (_e56.row_x.z * _e265.z)) / (((_e56.row_x.x * _e56.row_x.x) + (_e56.row_x.y * _e56.row_x.y)) + (_e56.row_x.z * _e56.row_x.z)))) + abs(((((_e56.row_y.x * _e265.x) + (_e56.row_y.y * _e265.y)) + (_e56.row_y.z * _e265.z)) / (((_e56.row_y.x * _e56.row_y.x) + (_e56.row_y.y * _e56.row_y.y)) + (_e56.row_y.z * _e56.row_y.z))))) / (abs(((((_e56.row_z.x * _e265.x) + (_e56.row_z.y * _e265.y)) + (_e56.row_z.z * _e265.z)) / (((_e56.row_z.x * _e56.row_z.x) + (_e56.row_z.y * _e56.row_z.y)) + (_e56.row_z.z * _e56.row_z.z)))) * f32(_e267)));
                    if (_e337 < 0.002f) {
                        phi_438_ = _e337;
                    } else {
                        phi_438_ = 0.002f;
                    }
                    let _e340 = phi_438_;
                    phi_441_ = (_e235 - (1f * _e340));
                } else {
                    phi_441_ = _e235;
                }
                let _e344 = phi_441_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e208 * _e347) - 0.5f);
                let _e351 = ((_e222 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_470_ = 1f;
                    } else {
                        phi_470_ = 0f;
                    }
                    let _e366 = phi_470_;
                    if (_e350 < 8388608f) {
                        phi_475_ = (_e363 - _e366);
                        phi_476_ = false;
                    } else {
                        phi_475_ = f32();
                        phi_476_ = true;
                    }
                    let _e369 = phi_475_;
                    let _e371 = phi_476_;
                    phi_477_ = _e369;
                    phi_478_ = _e371;
                } else {
                    phi_477_ = f32();
                    phi_478_ = true;
                }
                let _e373 = phi_477_;
                let _e375 = phi_478_;
                if _e375 {
                    phi_482_ = _e350;
                } else {
                    phi_482_ = _e373;
                }
                let _e377 = phi_482_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_502_ = 1f;
                    } else {
                        phi_502_ = 0f;
                    }
                    let _e392 = phi_502_;
                    if (_e351 < 8388608f) {
                        phi_507_ = (_e389 - _e392);
                        phi_508_ = false;
                    } else {
                        phi_507_ = f32();
                        phi_508_ = true;
                    }
                    let _e395 = phi_507_;
                    let _e397 = phi_508_;
                    phi_509_ = _e395;
                    phi_510_ = _e397;
                } else {
                    phi_509_ = f32();
                    phi_510_ = true;
                }
                let _e399 = phi_509_;
                let _e401 = phi_510_;
                if _e401 {
                    phi_514_ = _e351;
                } else {
                    phi_514_ = _e399;
                }
                let _e403 = phi_514_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local = _e435;
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_562_ = _e414;
                } else {
                    phi_562_ = 0i;
                }
                let _e444 = phi_562_;
                if (_e423 > 0i) {
                    phi_567_ = _e423;
                } else {
                    phi_567_ = 0i;
                }
                let _e447 = phi_567_;
                if (_e444 < _e441) {
                    phi_572_ = _e444;
                } else {
                    phi_572_ = _e441;
                }
                let _e450 = phi_572_;
                if (_e447 < _e441) {
                    phi_577_ = _e447;
                } else {
                    phi_577_ = _e441;
                }
                let _e453 = phi_577_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e414 + 1i);
                let _e457 = (_e423 + 1i);
                if (_e456 > 0i) {
                    phi_586_ = _e456;
                } else {
                    phi_586_ = 0i;
                }
                let _e460 = phi_586_;
                if (_e457 > 0i) {
                    phi_591_ = _e457;
                } else {
                    phi_591_ = 0i;
                }
                let _e463 = phi_591_;
                if (_e460 < _e441) {
                    phi_596_ = _e460;
                } else {
                    phi_596_ = _e441;
                }
                let _e466 = phi_596_;
                if (_e463 < _e441) {
                    phi_601_ = _e463;
                } else {
                    phi_601_ = _e441;
                }
                let _e469 = phi_601_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e41) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e41) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e479)];
                if (_e480 < _e41) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e480)];
                if (_e481 < _e41) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e481)];
                let _e499 = _lt_math_pcf_Pcf_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e485, _e489, _e493, _e497), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                phi_646_ = evaluate_Verdict(_e499, false);
                phi_647_ = evaluate_Verdict();
                phi_648_ = false;
            } else {
                phi_646_ = evaluate_Verdict();
                phi_647_ = evaluate_Verdict(1f, false);
                phi_648_ = true;
            }
            let _e503 = phi_646_;
            let _e505 = phi_647_;
            let _e507 = phi_648_;
            phi_649_ = _e505;
            phi_650_ = _e503;
            phi_651_ = _e507;
        }
        let _e509 = phi_649_;
        let _e511 = phi_650_;
        let _e513 = phi_651_;
        if _e513 {
            phi_655_ = _e509;
        } else {
            phi_655_ = _e511;
        }
        let _e515 = phi_655_;
        if (_e50.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e50.first_primitive)] = _e515.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_pcf_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
