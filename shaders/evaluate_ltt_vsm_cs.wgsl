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

struct type_36 {
    member: abi_ShadowParams,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_2: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_142_: lt_bvh_traverse_Tree;
    var phi_143_: bool;
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_150_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_142_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_143_ = false;
        } else {
            phi_142_ = lt_bvh_traverse_Tree();
            phi_143_ = true;
        }
        let _e50 = phi_142_;
        let _e52 = phi_143_;
        phi_144_ = _e50;
        phi_145_ = _e52;
    } else {
        phi_144_ = lt_bvh_traverse_Tree();
        phi_145_ = true;
    }
    let _e54 = phi_144_;
    let _e56 = phi_145_;
    if _e56 {
        phi_150_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_150_ = _e54;
    }
    let _e61 = phi_150_;
    return lt_bvh_traverse_Tree(_e61.root, _e61.first_primitive);
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_176_: f32;
    var phi_177_: f32;
    var phi_178_: f32;
    var phi_194_: f32;
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_212_: f32;
    var phi_213_: f32;
    var phi_214_: f32;
    var phi_230_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_248_: f32;
    var phi_249_: f32;
    var phi_250_: f32;
    var phi_296_: bool;
    var phi_300_: f32;
    var phi_312_: bool;
    var phi_319_: f32;
    var phi_334_: f32;
    var phi_335_: f32;
    var phi_336_: f32;

    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_178_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_177_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_176_ = 1f;
            } else {
                phi_176_ = param_7;
            }
            let _e47 = phi_176_;
            phi_177_ = _e47;
        }
        let _e49 = phi_177_;
        phi_178_ = _e49;
    }
    let _e51 = phi_178_;
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_196_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_195_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_194_ = 1f;
            } else {
                phi_194_ = param_5.x;
            }
            let _e59 = phi_194_;
            phi_195_ = _e59;
        }
        let _e61 = phi_195_;
        phi_196_ = _e61;
    }
    let _e63 = phi_196_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_214_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_213_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_212_ = 1f;
            } else {
                phi_212_ = param_5.y;
            }
            let _e71 = phi_212_;
            phi_213_ = _e71;
        }
        let _e73 = phi_213_;
        phi_214_ = _e73;
    }
    let _e75 = phi_214_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_232_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_231_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_230_ = 1f;
            } else {
                phi_230_ = param_5.z;
            }
            let _e83 = phi_230_;
            phi_231_ = _e83;
        }
        let _e85 = phi_231_;
        phi_232_ = _e85;
    }
    let _e87 = phi_232_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_250_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_249_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_248_ = 1f;
            } else {
                phi_248_ = param_5.w;
            }
            let _e95 = phi_248_;
            phi_249_ = _e95;
        }
        let _e97 = phi_249_;
        phi_250_ = _e97;
    }
    let _e99 = phi_250_;
    let _e100 = (_e63 - _e51);
    let _e101 = (_e75 - _e51);
    let _e102 = (_e87 - _e51);
    let _e103 = (_e99 - _e51);
    let _e104 = (*param_4);
    let _e115 = ((((_e100 * param_6.x) + (_e101 * param_6.y)) + (_e102 * param_6.z)) + (_e103 * param_6.w));
    let _e116 = (_e100 - _e115);
    let _e117 = (_e101 - _e115);
    let _e118 = (_e102 - _e115);
    let _e119 = (_e103 - _e115);
    let _e134 = (((((_e116 * _e116) * param_6.x) + ((_e117 * _e117) * param_6.y)) + ((_e118 * _e118) * param_6.z)) + ((_e119 * _e119) * param_6.w));
    if ((bitcast<u32>(_e104) & 2147483647u) > 2139095040u) {
        phi_296_ = true;
    } else {
        let _e138 = (_e104 > _e134);
        if _e138 {
        }
        phi_296_ = _e138;
    }
    let _e140 = phi_296_;
    if _e140 {
        phi_300_ = _e104;
    } else {
        phi_300_ = _e134;
    }
    let _e142 = phi_300_;
    let _e143 = -(_e115);
    if (_e143 <= 0f) {
        let _e147 = ((bitcast<u32>(_e142) & 2147483647u) > 2139095040u);
        if _e147 {
        }
        phi_312_ = _e147;
    } else {
        phi_312_ = true;
    }
    let _e149 = phi_312_;
    if _e149 {
        phi_319_ = (_e142 / (_e142 + (_e143 * _e143)));
    } else {
        phi_319_ = 1f;
    }
    let _e154 = phi_319_;
    if ((bitcast<u32>(_e154) & 2147483647u) > 2139095040u) {
        phi_336_ = _e154;
    } else {
        if (_e154 < 0f) {
            phi_335_ = 0f;
        } else {
            if (_e154 > 1f) {
                phi_334_ = 1f;
            } else {
                phi_334_ = _e154;
            }
            let _e161 = phi_334_;
            phi_335_ = _e161;
        }
        let _e163 = phi_335_;
        phi_336_ = _e163;
    }
    let _e165 = phi_336_;
    return _e165;
}

fn function_() {
    var local_1: f32;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_390_: bool;
    var phi_391_: bool;
    var phi_395_: bool;
    var phi_439_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_443_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_517_: bool;
    var phi_526_: bool;
    var phi_535_: bool;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_538_: bool;
    var phi_539_: bool;
    var phi_540_: bool;
    var phi_541_: bool;
    var phi_545_: bool;
    var phi_635_: f32;
    var phi_638_: f32;
    var phi_667_: f32;
    var phi_672_: f32;
    var phi_673_: bool;
    var phi_674_: f32;
    var phi_675_: bool;
    var phi_679_: f32;
    var phi_699_: f32;
    var phi_704_: f32;
    var phi_705_: bool;
    var phi_706_: f32;
    var phi_707_: bool;
    var phi_711_: f32;
    var phi_759_: i32;
    var phi_764_: i32;
    var phi_769_: i32;
    var phi_774_: i32;
    var phi_783_: i32;
    var phi_788_: i32;
    var phi_793_: i32;
    var phi_798_: i32;
    var phi_849_: bool;
    var phi_857_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_874_: f32;
    var phi_880_: f32;
    var phi_882_: evaluate_Verdict;
    var phi_887_: evaluate_Verdict;
    var phi_888_: evaluate_Verdict;
    var phi_892_: bool;
    var phi_893_: u32;
    var phi_904_: u32;

    let _e38 = id_1;
    let _e39 = local_2;
    let _e44 = arrayLength((&map.member));
    let _e49 = p.member.size[0u];
    let _e51 = p.member.size[1u];
    let _e52 = lt_shaders_entry_pixel_index(_e38, _e49, _e51);
    if (bitcast<i32>(_e52.root) != 0i) {
        let _e59 = p.member.projection;
        let _e60 = lt_math_OneLevel(_e59);
        let _e62 = p.member.light;
        let _e65 = samples.member[_e52.first_primitive].normal[0u];
        let _e67 = global[0u];
        if (_e65 == _e67) {
            let _e70 = samples.member[_e52.first_primitive].normal[1u];
            let _e72 = global[1u];
            if (_e70 == _e72) {
                let _e75 = samples.member[_e52.first_primitive].normal[2u];
                let _e77 = global[2u];
                phi_388_ = (_e75 == _e77);
                phi_389_ = false;
            } else {
                phi_388_ = bool();
                phi_389_ = true;
            }
            let _e80 = phi_388_;
            let _e82 = phi_389_;
            phi_390_ = _e80;
            phi_391_ = _e82;
        } else {
            phi_390_ = bool();
            phi_391_ = true;
        }
        let _e84 = phi_390_;
        let _e86 = phi_391_;
        if _e86 {
            phi_395_ = false;
        } else {
            phi_395_ = _e84;
        }
        let _e88 = phi_395_;
        if !(_e88) {
            let _e91 = samples.member[_e52.first_primitive].normal;
            let _e93 = samples.member[_e52.first_primitive].position;
            if ((((_e91.x * (_e62.x - (_e93.x * _e62.w))) + (_e91.y * (_e62.y - (_e93.y * _e62.w)))) + (_e91.z * (_e62.z - (_e93.z * _e62.w)))) > 0f) {
                let _e117 = samples.member[_e52.first_primitive].flags;
                let _e125 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e131 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e125.unnamed.visibility, false), _e125.unnamed_1);
                phi_439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e131.unnamed, ((_e117 & 1u) == 0u));
            } else {
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e146 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e140.unnamed.visibility, false), _e140.unnamed_1);
                phi_439_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e146.unnamed, true);
            }
            let _e151 = phi_439_;
            phi_443_ = _e151;
        } else {
            let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e163 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e157.unnamed.visibility, false), _e157.unnamed_1);
            phi_443_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e163.unnamed, true);
        }
        let _e168 = phi_443_;
        if _e168.unnamed_1 {
            phi_888_ = evaluate_Verdict(_e168.unnamed.visibility, _e168.unnamed.is_doubted);
        } else {
            let _e176 = samples.member[_e52.first_primitive].position;
            let _e194 = ((((_e60.projection.row_w.x * _e176.x) + (_e60.projection.row_w.y * _e176.y)) + (_e60.projection.row_w.z * _e176.z)) + (_e60.projection.row_w.w * 1f));
            let _e208 = (((((_e60.projection.row_x.x * _e176.x) + (_e60.projection.row_x.y * _e176.y)) + (_e60.projection.row_x.z * _e176.z)) + (_e60.projection.row_x.w * 1f)) / _e194);
            let _e222 = (((((_e60.projection.row_y.x * _e176.x) + (_e60.projection.row_y.y * _e176.y)) + (_e60.projection.row_y.z * _e176.z)) + (_e60.projection.row_y.w * 1f)) / _e194);
            let _e235 = ((((_e60.projection.row_z.x * _e176.x) + (_e60.projection.row_z.y * _e176.y)) + (_e60.projection.row_z.z * _e176.z)) + (_e60.projection.row_z.w * 1f));
            if (_e194 > 0f) {
                if (_e208 >= 0f) {
                    phi_517_ = (_e208 <= 1f);
                } else {
                    phi_517_ = false;
                }
                let _e240 = phi_517_;
                if _e240 {
                    if (_e222 >= 0f) {
                        phi_526_ = (_e222 <= 1f);
                    } else {
                        phi_526_ = false;
                    }
                    let _e244 = phi_526_;
                    if _e244 {
                        if (_e235 >= 0f) {
                            phi_535_ = (_e235 <= 1f);
                        } else {
                            phi_535_ = false;
                        }
                        let _e248 = phi_535_;
                        phi_536_ = _e248;
                        phi_537_ = false;
                    } else {
                        phi_536_ = bool();
                        phi_537_ = true;
                    }
                    let _e250 = phi_536_;
                    let _e252 = phi_537_;
                    phi_538_ = _e250;
                    phi_539_ = _e252;
                } else {
                    phi_538_ = bool();
                    phi_539_ = true;
                }
                let _e254 = phi_538_;
                let _e256 = phi_539_;
                phi_540_ = _e254;
                phi_541_ = _e256;
            } else {
                phi_540_ = bool();
                phi_541_ = true;
            }
            let _e258 = phi_540_;
            let _e260 = phi_541_;
            if _e260 {
                phi_545_ = false;
            } else {
                phi_545_ = _e258;
            }
            let _e262 = phi_545_;
            if _e262 {
                if (0f > 0f) {
                    let _e265 = samples.member[_e52.first_primitive].normal;
                    let _e267 = p.member.map_size;
                    let _e337 = ((abs(((((_e59.row_x.x * _e265.x) + (_e59.row_x.y * _e265.y)) + (_e59.row_x.z * _e265.z)) / (((_e59.row_x.x * _e59.row_x.x) + (_e59.row_x.y * _e59.row_x.y)) + (_e59.row_x.z * _e59.row_x.z)))) + abs(((((_e59.row_y.x * _e265.x) + (_e59.row_y.y * _e265.y)) + (_e59.row_y.z * _e265.z)) / (((_e59.row_y.x * _e59.row_y.x) + (_e59.row_y.y * _e59.row_y.y)) + (_e59.row_y.z * _e59.row_y.z))))) / (abs(((((_e59.row_z.x * _e265.x) + (_e59.row_z.y * _e265.y)) + (_e59.row_z.z * _e265.z)) / (((_e59.row_z.x * _e59.row_z.x) + (_e59.row_z.y * _e59.row_z.y)) + (_e59.row_z.z * _e59.row_z.z)))) * f32(_e267)));
                    if (_e337 < 0.002f) {
                        phi_635_ = _e337;
                    } else {
                        phi_635_ = 0.002f;
                    }
                    let _e340 = phi_635_;
                    phi_638_ = (_e235 - (0f * _e340));
                } else {
                    phi_638_ = _e235;
                }
                let _e344 = phi_638_;
                let _e346 = p.member.map_size;
                let _e347 = f32(_e346);
                let _e350 = ((_e208 * _e347) - 0.5f);
                let _e351 = ((_e222 * _e347) - 0.5f);
                if (_e350 > -8388608f) {
                    let _e363 = f32(select(0i, select(select(i32(_e350), i32(-2147483648), (_e350 < bitcast<f32>(3472883712u))), 2147483647i, (_e350 > bitcast<f32>(1325400063u))), (_e350 == _e350)));
                    if (_e363 > _e350) {
                        phi_667_ = 1f;
                    } else {
                        phi_667_ = 0f;
                    }
                    let _e366 = phi_667_;
                    if (_e350 < 8388608f) {
                        phi_672_ = (_e363 - _e366);
                        phi_673_ = false;
                    } else {
                        phi_672_ = f32();
                        phi_673_ = true;
                    }
                    let _e369 = phi_672_;
                    let _e371 = phi_673_;
                    phi_674_ = _e369;
                    phi_675_ = _e371;
                } else {
                    phi_674_ = f32();
                    phi_675_ = true;
                }
                let _e373 = phi_674_;
                let _e375 = phi_675_;
                if _e375 {
                    phi_679_ = _e350;
                } else {
                    phi_679_ = _e373;
                }
                let _e377 = phi_679_;
                if (_e351 > -8388608f) {
                    let _e389 = f32(select(0i, select(select(i32(_e351), i32(-2147483648), (_e351 < bitcast<f32>(3472883712u))), 2147483647i, (_e351 > bitcast<f32>(1325400063u))), (_e351 == _e351)));
                    if (_e389 > _e351) {
                        phi_699_ = 1f;
                    } else {
                        phi_699_ = 0f;
                    }
                    let _e392 = phi_699_;
                    if (_e351 < 8388608f) {
                        phi_704_ = (_e389 - _e392);
                        phi_705_ = false;
                    } else {
                        phi_704_ = f32();
                        phi_705_ = true;
                    }
                    let _e395 = phi_704_;
                    let _e397 = phi_705_;
                    phi_706_ = _e395;
                    phi_707_ = _e397;
                } else {
                    phi_706_ = f32();
                    phi_707_ = true;
                }
                let _e399 = phi_706_;
                let _e401 = phi_707_;
                if _e401 {
                    phi_711_ = _e351;
                } else {
                    phi_711_ = _e399;
                }
                let _e403 = phi_711_;
                let _e404 = (_e350 - _e377);
                let _e405 = (_e351 - _e403);
                let _e414 = select(0i, select(select(i32(_e377), i32(-2147483648), (_e377 < bitcast<f32>(3472883712u))), 2147483647i, (_e377 > bitcast<f32>(1325400063u))), (_e377 == _e377));
                let _e423 = select(0i, select(select(i32(_e403), i32(-2147483648), (_e403 < bitcast<f32>(3472883712u))), 2147483647i, (_e403 > bitcast<f32>(1325400063u))), (_e403 == _e403));
                let _e434 = p.member.test;
                let _e435 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e434);
                let _e437 = p.member.map_size;
                local_1 = _e435;
                let _e439 = ((0u * _e437) * _e437);
                let _e441 = (bitcast<i32>(_e437) - 1i);
                if (_e414 > 0i) {
                    phi_759_ = _e414;
                } else {
                    phi_759_ = 0i;
                }
                let _e444 = phi_759_;
                if (_e423 > 0i) {
                    phi_764_ = _e423;
                } else {
                    phi_764_ = 0i;
                }
                let _e447 = phi_764_;
                if (_e444 < _e441) {
                    phi_769_ = _e444;
                } else {
                    phi_769_ = _e441;
                }
                let _e450 = phi_769_;
                if (_e447 < _e441) {
                    phi_774_ = _e447;
                } else {
                    phi_774_ = _e441;
                }
                let _e453 = phi_774_;
                let _e454 = bitcast<u32>(_e450);
                let _e456 = (_e414 + 1i);
                let _e457 = (_e423 + 1i);
                if (_e456 > 0i) {
                    phi_783_ = _e456;
                } else {
                    phi_783_ = 0i;
                }
                let _e460 = phi_783_;
                if (_e457 > 0i) {
                    phi_788_ = _e457;
                } else {
                    phi_788_ = 0i;
                }
                let _e463 = phi_788_;
                if (_e460 < _e441) {
                    phi_793_ = _e460;
                } else {
                    phi_793_ = _e441;
                }
                let _e466 = phi_793_;
                if (_e463 < _e441) {
                    phi_798_ = _e463;
                } else {
                    phi_798_ = _e441;
                }
                let _e469 = phi_798_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (bitcast<u32>(_e453) * _e437);
                let _e473 = (bitcast<u32>(_e469) * _e437);
                let _e478 = ((_e472 + _e454) + _e439);
                let _e479 = ((_e472 + _e470) + _e439);
                let _e480 = ((_e473 + _e454) + _e439);
                let _e481 = ((_e473 + _e470) + _e439);
                if (_e478 < _e44) {
                } else {
                    return;
                }
                let _e485 = map.member[(0u + _e478)];
                if (_e479 < _e44) {
                } else {
                    return;
                }
                let _e489 = map.member[(0u + _e479)];
                if (_e480 < _e44) {
                } else {
                    return;
                }
                let _e493 = map.member[(0u + _e480)];
                if (_e481 < _e44) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e481)];
                let _e499 = _lt_math_vsm_Vsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e485, _e489, _e493, _e497), vec4<f32>(((1f - _e404) * (1f - _e405)), (_e404 * (1f - _e405)), ((1f - _e404) * _e405), (_e404 * _e405)), _e344);
                let _e501 = p.member.epsilon;
                if (_e499 <= _e501) {
                    phi_849_ = true;
                } else {
                    phi_849_ = (_e499 >= (1f - _e501));
                }
                let _e506 = phi_849_;
                if ((bitcast<u32>(_e499) & 2147483647u) > 2139095040u) {
                    phi_857_ = true;
                } else {
                    phi_857_ = !(_e506);
                }
                let _e512 = phi_857_;
                if _e512 {
                    if (_e499 > 0f) {
                        if (_e499 < 1f) {
                            phi_869_ = false;
                        } else {
                            phi_869_ = true;
                        }
                        let _e516 = phi_869_;
                        phi_870_ = _e516;
                    } else {
                        phi_870_ = true;
                    }
                    let _e518 = phi_870_;
                    if _e518 {
                        phi_874_ = 0.5f;
                    } else {
                        phi_874_ = _e499;
                    }
                    let _e520 = phi_874_;
                    phi_882_ = evaluate_Verdict(_e520, true);
                } else {
                    if (_e499 > 0.5f) {
                        phi_880_ = 1f;
                    } else {
                        phi_880_ = 0f;
                    }
                    let _e524 = phi_880_;
                    phi_882_ = evaluate_Verdict(_e524, false);
                }
                let _e527 = phi_882_;
                phi_887_ = evaluate_Verdict(_e527.visibility, _e527.is_doubted);
            } else {
                phi_887_ = evaluate_Verdict(0.5f, true);
            }
            let _e533 = phi_887_;
            phi_888_ = _e533;
        }
        let _e535 = phi_888_;
        visibility.member[_e52.first_primitive] = _e535.visibility;
        phi_892_ = _e535.is_doubted;
        phi_893_ = _e52.first_primitive;
    } else {
        phi_892_ = false;
        phi_893_ = 0u;
    }
    let _e540 = phi_892_;
    let _e542 = phi_893_;
    if (_e39 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e540 {
        let _e546 = atomicAdd((&shared_[0u]), 1u);
        phi_904_ = _e546;
    } else {
        phi_904_ = 0u;
    }
    let _e548 = phi_904_;
    workgroupBarrier();
    if (_e39 == 0u) {
        let _e552 = atomicLoad((&shared_[0u]));
        let _e553 = atomicAdd((&list.member[3u]), _e552);
        atomicStore((&shared_[1u]), _e553);
    }
    workgroupBarrier();
    if _e540 {
        let _e556 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e556) + _e548)]), _e542);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_vsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
