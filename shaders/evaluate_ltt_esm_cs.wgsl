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

struct type_24 {
    member: array<abi_Sample>,
}

struct type_28 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct type_36 {
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

struct type_43 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_24;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_28;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_28;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_157_: lt_bvh_traverse_Tree;
    var phi_158_: bool;
    var phi_163_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_155_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_156_ = false;
        } else {
            phi_155_ = lt_bvh_traverse_Tree();
            phi_156_ = true;
        }
        let _e59 = phi_155_;
        let _e61 = phi_156_;
        phi_157_ = _e59;
        phi_158_ = _e61;
    } else {
        phi_157_ = lt_bvh_traverse_Tree();
        phi_158_ = true;
    }
    let _e63 = phi_157_;
    let _e65 = phi_158_;
    if _e65 {
        phi_163_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_163_ = _e63;
    }
    let _e70 = phi_163_;
    return lt_bvh_traverse_Tree(_e70.root, _e70.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_189_: bool;
    var phi_193_: f32;
    var phi_194_: f32;

    let _e47 = (*param_4);
    if ((bitcast<u32>(_e47) & 2147483647u) > 2139095040u) {
        phi_194_ = _e47;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_189_ = true;
        } else {
            let _e54 = (84f < _e47);
            if _e54 {
            }
            phi_189_ = _e54;
        }
        let _e56 = phi_189_;
        if _e56 {
            phi_193_ = 84f;
        } else {
            phi_193_ = _e47;
        }
        let _e58 = phi_193_;
        phi_194_ = _e58;
    }
    let _e60 = phi_194_;
    return _e60;
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_222_: i32;
    var phi_227_: i32;
    var phi_232_: i32;
    var phi_237_: i32;
    var phi_246_: i32;
    var phi_251_: i32;
    var phi_256_: i32;
    var phi_261_: i32;

    let _e50 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_222_ = param_7;
    } else {
        phi_222_ = 0i;
    }
    let _e53 = phi_222_;
    if (param_8 > 0i) {
        phi_227_ = param_8;
    } else {
        phi_227_ = 0i;
    }
    let _e56 = phi_227_;
    if (_e53 < _e50) {
        phi_232_ = _e53;
    } else {
        phi_232_ = _e50;
    }
    let _e59 = phi_232_;
    if (_e56 < _e50) {
        phi_237_ = _e56;
    } else {
        phi_237_ = _e50;
    }
    let _e62 = phi_237_;
    let _e63 = bitcast<u32>(_e59);
    let _e65 = (param_7 + 1i);
    let _e66 = (param_8 + 1i);
    if (_e65 > 0i) {
        phi_246_ = _e65;
    } else {
        phi_246_ = 0i;
    }
    let _e69 = phi_246_;
    if (_e66 > 0i) {
        phi_251_ = _e66;
    } else {
        phi_251_ = 0i;
    }
    let _e72 = phi_251_;
    if (_e69 < _e50) {
        phi_256_ = _e69;
    } else {
        phi_256_ = _e50;
    }
    let _e75 = phi_256_;
    if (_e72 < _e50) {
        phi_261_ = _e72;
    } else {
        phi_261_ = _e50;
    }
    let _e78 = phi_261_;
    let _e79 = bitcast<u32>(_e75);
    let _e81 = (bitcast<u32>(_e62) * param_9);
    let _e82 = (bitcast<u32>(_e78) * param_9);
    return array<u32, 4>((_e81 + _e63), (_e81 + _e79), (_e82 + _e63), (_e82 + _e79));
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_293_: f32;
    var phi_309_: f32;
    var phi_310_: f32;
    var phi_311_: f32;
    var phi_336_: bool;
    var phi_340_: f32;
    var phi_341_: f32;
    var phi_358_: bool;
    var phi_362_: f32;
    var phi_363_: f32;
    var phi_404_: f32;
    var phi_420_: f32;
    var phi_421_: f32;
    var phi_422_: f32;
    var phi_447_: bool;
    var phi_451_: f32;
    var phi_452_: f32;
    var phi_469_: bool;
    var phi_473_: f32;
    var phi_474_: f32;
    var phi_515_: f32;
    var phi_531_: f32;
    var phi_532_: f32;
    var phi_533_: f32;
    var phi_558_: bool;
    var phi_562_: f32;
    var phi_563_: f32;
    var phi_580_: bool;
    var phi_584_: f32;
    var phi_585_: f32;
    var phi_626_: f32;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_669_: bool;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_691_: bool;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_737_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_765_: f32;

    let _e50 = _lt_math_esm_Esm_clamped_exponent(param_10);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_293_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_292_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_291_ = 1f;
            } else {
                phi_291_ = param_13;
            }
            let _e57 = phi_291_;
            phi_292_ = _e57;
        }
        let _e59 = phi_292_;
        phi_293_ = _e59;
    }
    let _e61 = phi_293_;
    if ((bitcast<u32>(param_11.x) & 2147483647u) > 2139095040u) {
        phi_311_ = param_11.x;
    } else {
        if (param_11.x < 0f) {
            phi_310_ = 0f;
        } else {
            if (param_11.x > 1f) {
                phi_309_ = 1f;
            } else {
                phi_309_ = param_11.x;
            }
            let _e69 = phi_309_;
            phi_310_ = _e69;
        }
        let _e71 = phi_310_;
        phi_311_ = _e71;
    }
    let _e73 = phi_311_;
    let _e75 = (_e50 * (_e73 - _e61));
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_404_ = _e75;
    } else {
        if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
            phi_341_ = _e75;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_336_ = true;
            } else {
                let _e85 = (-87f > _e75);
                if _e85 {
                }
                phi_336_ = _e85;
            }
            let _e87 = phi_336_;
            if _e87 {
                phi_340_ = -87f;
            } else {
                phi_340_ = _e75;
            }
            let _e89 = phi_340_;
            phi_341_ = _e89;
        }
        let _e91 = phi_341_;
        if ((bitcast<u32>(_e91) & 2147483647u) > 2139095040u) {
            phi_363_ = _e91;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_358_ = true;
            } else {
                let _e98 = (88f < _e91);
                if _e98 {
                }
                phi_358_ = _e98;
            }
            let _e100 = phi_358_;
            if _e100 {
                phi_362_ = 88f;
            } else {
                phi_362_ = _e91;
            }
            let _e102 = phi_362_;
            phi_363_ = _e102;
        }
        let _e104 = phi_363_;
        let _e107 = floor(((_e104 * 1.442695f) + 0.5f));
        let _e111 = ((_e104 - (_e107 * 0.69314575f)) - (_e107 * 0.0000014286068f));
        phi_404_ = ((((((((((((((((1f / 5040f) * _e111) + (1f / 720f)) * _e111) + (1f / 120f)) * _e111) + (1f / 24f)) * _e111) + (1f / 6f)) * _e111) + 0.5f) * _e111) + 1f) * _e111) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e107), i32(-2147483648), (_e107 < bitcast<f32>(3472883712u))), 2147483647i, (_e107 > bitcast<f32>(1325400063u))), (_e107 == _e107)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e147 = phi_404_;
    if ((bitcast<u32>(param_11.y) & 2147483647u) > 2139095040u) {
        phi_422_ = param_11.y;
    } else {
        if (param_11.y < 0f) {
            phi_421_ = 0f;
        } else {
            if (param_11.y > 1f) {
                phi_420_ = 1f;
            } else {
                phi_420_ = param_11.y;
            }
            let _e155 = phi_420_;
            phi_421_ = _e155;
        }
        let _e157 = phi_421_;
        phi_422_ = _e157;
    }
    let _e159 = phi_422_;
    let _e161 = (_e50 * (_e159 - _e61));
    if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
        phi_515_ = _e161;
    } else {
        if ((bitcast<u32>(_e161) & 2147483647u) > 2139095040u) {
            phi_452_ = _e161;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_447_ = true;
            } else {
                let _e171 = (-87f > _e161);
                if _e171 {
                }
                phi_447_ = _e171;
            }
            let _e173 = phi_447_;
            if _e173 {
                phi_451_ = -87f;
            } else {
                phi_451_ = _e161;
            }
            let _e175 = phi_451_;
            phi_452_ = _e175;
        }
        let _e177 = phi_452_;
        if ((bitcast<u32>(_e177) & 2147483647u) > 2139095040u) {
            phi_474_ = _e177;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_469_ = true;
            } else {
                let _e184 = (88f < _e177);
                if _e184 {
                }
                phi_469_ = _e184;
            }
            let _e186 = phi_469_;
            if _e186 {
                phi_473_ = 88f;
            } else {
                phi_473_ = _e177;
            }
            let _e188 = phi_473_;
            phi_474_ = _e188;
        }
        let _e190 = phi_474_;
        let _e193 = floor(((_e190 * 1.442695f) + 0.5f));
        let _e197 = ((_e190 - (_e193 * 0.69314575f)) - (_e193 * 0.0000014286068f));
        phi_515_ = ((((((((((((((((1f / 5040f) * _e197) + (1f / 720f)) * _e197) + (1f / 120f)) * _e197) + (1f / 24f)) * _e197) + (1f / 6f)) * _e197) + 0.5f) * _e197) + 1f) * _e197) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e193), i32(-2147483648), (_e193 < bitcast<f32>(3472883712u))), 2147483647i, (_e193 > bitcast<f32>(1325400063u))), (_e193 == _e193)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e233 = phi_515_;
    if ((bitcast<u32>(param_11.z) & 2147483647u) > 2139095040u) {
        phi_533_ = param_11.z;
    } else {
        if (param_11.z < 0f) {
            phi_532_ = 0f;
        } else {
            if (param_11.z > 1f) {
                phi_531_ = 1f;
            } else {
                phi_531_ = param_11.z;
            }
            let _e241 = phi_531_;
            phi_532_ = _e241;
        }
        let _e243 = phi_532_;
        phi_533_ = _e243;
    }
    let _e245 = phi_533_;
    let _e247 = (_e50 * (_e245 - _e61));
    if ((bitcast<u32>(_e247) & 2147483647u) > 2139095040u) {
        phi_626_ = _e247;
    } else {
        if ((bitcast<u32>(_e247) & 2147483647u) > 2139095040u) {
            phi_563_ = _e247;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_558_ = true;
            } else {
                let _e257 = (-87f > _e247);
                if _e257 {
                }
                phi_558_ = _e257;
            }
            let _e259 = phi_558_;
            if _e259 {
                phi_562_ = -87f;
            } else {
                phi_562_ = _e247;
            }
            let _e261 = phi_562_;
            phi_563_ = _e261;
        }
        let _e263 = phi_563_;
        if ((bitcast<u32>(_e263) & 2147483647u) > 2139095040u) {
            phi_585_ = _e263;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_580_ = true;
            } else {
                let _e270 = (88f < _e263);
                if _e270 {
                }
                phi_580_ = _e270;
            }
            let _e272 = phi_580_;
            if _e272 {
                phi_584_ = 88f;
            } else {
                phi_584_ = _e263;
            }
            let _e274 = phi_584_;
            phi_585_ = _e274;
        }
        let _e276 = phi_585_;
        let _e279 = floor(((_e276 * 1.442695f) + 0.5f));
        let _e283 = ((_e276 - (_e279 * 0.69314575f)) - (_e279 * 0.0000014286068f));
        phi_626_ = ((((((((((((((((1f / 5040f) * _e283) + (1f / 720f)) * _e283) + (1f / 120f)) * _e283) + (1f / 24f)) * _e283) + (1f / 6f)) * _e283) + 0.5f) * _e283) + 1f) * _e283) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < bitcast<f32>(3472883712u))), 2147483647i, (_e279 > bitcast<f32>(1325400063u))), (_e279 == _e279)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e319 = phi_626_;
    if ((bitcast<u32>(param_11.w) & 2147483647u) > 2139095040u) {
        phi_644_ = param_11.w;
    } else {
        if (param_11.w < 0f) {
            phi_643_ = 0f;
        } else {
            if (param_11.w > 1f) {
                phi_642_ = 1f;
            } else {
                phi_642_ = param_11.w;
            }
            let _e327 = phi_642_;
            phi_643_ = _e327;
        }
        let _e329 = phi_643_;
        phi_644_ = _e329;
    }
    let _e331 = phi_644_;
    let _e333 = (_e50 * (_e331 - _e61));
    if ((bitcast<u32>(_e333) & 2147483647u) > 2139095040u) {
        phi_737_ = _e333;
    } else {
        if ((bitcast<u32>(_e333) & 2147483647u) > 2139095040u) {
            phi_674_ = _e333;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_669_ = true;
            } else {
                let _e343 = (-87f > _e333);
                if _e343 {
                }
                phi_669_ = _e343;
            }
            let _e345 = phi_669_;
            if _e345 {
                phi_673_ = -87f;
            } else {
                phi_673_ = _e333;
            }
            let _e347 = phi_673_;
            phi_674_ = _e347;
        }
        let _e349 = phi_674_;
        if ((bitcast<u32>(_e349) & 2147483647u) > 2139095040u) {
            phi_696_ = _e349;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_691_ = true;
            } else {
                let _e356 = (88f < _e349);
                if _e356 {
                }
                phi_691_ = _e356;
            }
            let _e358 = phi_691_;
            if _e358 {
                phi_695_ = 88f;
            } else {
                phi_695_ = _e349;
            }
            let _e360 = phi_695_;
            phi_696_ = _e360;
        }
        let _e362 = phi_696_;
        let _e365 = floor(((_e362 * 1.442695f) + 0.5f));
        let _e369 = ((_e362 - (_e365 * 0.69314575f)) - (_e365 * 0.0000014286068f));
        phi_737_ = ((((((((((((((((1f / 5040f) * _e369) + (1f / 720f)) * _e369) + (1f / 120f)) * _e369) + (1f / 24f)) * _e369) + (1f / 6f)) * _e369) + 0.5f) * _e369) + 1f) * _e369) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e405 = phi_737_;
    let _e416 = ((((_e147 * param_12.x) + (_e233 * param_12.y)) + (_e319 * param_12.z)) + (_e405 * param_12.w));
    if ((bitcast<u32>(_e416) & 2147483647u) > 2139095040u) {
        phi_765_ = _e416;
    } else {
        if (_e416 < 0f) {
            phi_764_ = 0f;
        } else {
            if (_e416 > 1f) {
                phi_763_ = 1f;
            } else {
                phi_763_ = _e416;
            }
            let _e423 = phi_763_;
            phi_764_ = _e423;
        }
        let _e425 = phi_764_;
        phi_765_ = _e425;
    }
    let _e427 = phi_765_;
    return _e427;
}

fn function_() {
    var local_1: f32;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_826_: bool;
    var phi_861_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_865_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_958_: bool;
    var phi_959_: bool;
    var phi_960_: bool;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_964_: bool;
    var phi_965_: bool;
    var phi_966_: bool;
    var phi_967_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_973_: bool;
    var phi_1074_: bool;
    var phi_1082_: bool;
    var phi_1087_: f32;
    var phi_1090_: evaluate_Verdict;
    var phi_1091_: evaluate_Verdict;
    var phi_1095_: bool;
    var phi_1096_: u32;
    var phi_1102_: u32;

    let _e47 = id_1;
    let _e48 = local_2;
    let _e53 = arrayLength((&map.member));
    if (_e48 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e47, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e70 = p.member.light;
        let _e73 = samples.member[_e63.first_primitive].normal[0u];
        let _e75 = global[0u];
        if (_e73 == _e75) {
            let _e78 = samples.member[_e63.first_primitive].normal[1u];
            let _e80 = global[1u];
            if (_e78 == _e80) {
                let _e83 = samples.member[_e63.first_primitive].normal[2u];
                let _e85 = global[2u];
                phi_819_ = (_e83 == _e85);
                phi_820_ = false;
            } else {
                phi_819_ = bool();
                phi_820_ = true;
            }
            let _e88 = phi_819_;
            let _e90 = phi_820_;
            phi_821_ = _e88;
            phi_822_ = _e90;
        } else {
            phi_821_ = bool();
            phi_822_ = true;
        }
        let _e92 = phi_821_;
        let _e94 = phi_822_;
        if _e94 {
            phi_826_ = false;
        } else {
            phi_826_ = _e92;
        }
        let _e96 = phi_826_;
        if !(_e96) {
            let _e99 = samples.member[_e63.first_primitive].normal;
            let _e101 = samples.member[_e63.first_primitive].position;
            let _e102 = lt_shaders_evaluate_to_light(_e101, _e70);
            if ((((_e99.x * _e102.x) + (_e99.y * _e102.y)) + (_e99.z * _e102.z)) > 0f) {
                let _e116 = samples.member[_e63.first_primitive].flags;
                let _e124 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e124.unnamed.visibility, false), _e124.unnamed_1);
                phi_861_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e130.unnamed, ((_e116 & 1u) == 0u));
            } else {
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_861_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, true);
            }
            let _e150 = phi_861_;
            phi_865_ = _e150;
        } else {
            let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e156.unnamed.visibility, false), _e156.unnamed_1);
            phi_865_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e162.unnamed, true);
        }
        let _e167 = phi_865_;
        if _e167.unnamed_1 {
            phi_1091_ = evaluate_Verdict(_e167.unnamed.visibility, _e167.unnamed.is_doubted);
        } else {
            let _e175 = samples.member[_e63.first_primitive].position;
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
                    if (_e206 <= 1f) {
                        if (_e220 >= 0f) {
                            if (_e220 <= 1f) {
                                if (_e233 >= 0f) {
                                    phi_958_ = (_e233 <= 1f);
                                    phi_959_ = false;
                                } else {
                                    phi_958_ = bool();
                                    phi_959_ = true;
                                }
                                let _e242 = phi_958_;
                                let _e244 = phi_959_;
                                phi_960_ = _e242;
                                phi_961_ = _e244;
                            } else {
                                phi_960_ = bool();
                                phi_961_ = true;
                            }
                            let _e246 = phi_960_;
                            let _e248 = phi_961_;
                            phi_962_ = _e246;
                            phi_963_ = _e248;
                        } else {
                            phi_962_ = bool();
                            phi_963_ = true;
                        }
                        let _e250 = phi_962_;
                        let _e252 = phi_963_;
                        phi_964_ = _e250;
                        phi_965_ = _e252;
                    } else {
                        phi_964_ = bool();
                        phi_965_ = true;
                    }
                    let _e254 = phi_964_;
                    let _e256 = phi_965_;
                    phi_966_ = _e254;
                    phi_967_ = _e256;
                } else {
                    phi_966_ = bool();
                    phi_967_ = true;
                }
                let _e258 = phi_966_;
                let _e260 = phi_967_;
                phi_968_ = _e258;
                phi_969_ = _e260;
            } else {
                phi_968_ = bool();
                phi_969_ = true;
            }
            let _e262 = phi_968_;
            let _e264 = phi_969_;
            if _e264 {
                phi_973_ = false;
            } else {
                phi_973_ = _e262;
            }
            let _e266 = phi_973_;
            if _e266 {
                let _e268 = p.member.map_size;
                let _e269 = f32(_e268);
                let _e272 = ((_e206 * _e269) - 0.5f);
                let _e273 = ((_e220 * _e269) - 0.5f);
                let _e274 = floor(_e272);
                let _e275 = floor(_e273);
                let _e276 = (_e272 - _e274);
                let _e277 = (_e273 - _e275);
                let _e306 = p.member.test;
                let _e307 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e306);
                let _e309 = p.member.map_size;
                local_1 = _e307;
                let _e310 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e274), i32(-2147483648), (_e274 < bitcast<f32>(3472883712u))), 2147483647i, (_e274 > bitcast<f32>(1325400063u))), (_e274 == _e274)), select(0i, select(select(i32(_e275), i32(-2147483648), (_e275 < bitcast<f32>(3472883712u))), 2147483647i, (_e275 > bitcast<f32>(1325400063u))), (_e275 == _e275)), _e309);
                if (_e310[0] < _e53) {
                } else {
                    return;
                }
                let _e315 = map.member[(0u + _e310[0])];
                if (_e310[1] < _e53) {
                } else {
                    return;
                }
                let _e320 = map.member[(0u + _e310[1])];
                if (_e310[2] < _e53) {
                } else {
                    return;
                }
                let _e325 = map.member[(0u + _e310[2])];
                if (_e310[3] < _e53) {
                } else {
                    return;
                }
                let _e330 = map.member[(0u + _e310[3])];
                let _e332 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e315, _e320, _e325, _e330), vec4<f32>(((1f - _e276) * (1f - _e277)), (_e276 * (1f - _e277)), ((1f - _e276) * _e277), (_e276 * _e277)), _e233);
                let _e334 = p.member.epsilon;
                if (_e332 <= _e334) {
                    phi_1074_ = true;
                } else {
                    phi_1074_ = (_e332 >= (1f - _e334));
                }
                let _e339 = phi_1074_;
                if ((bitcast<u32>(_e332) & 2147483647u) > 2139095040u) {
                    phi_1082_ = true;
                } else {
                    phi_1082_ = !(_e339);
                }
                let _e345 = phi_1082_;
                if (_e332 > 0.5f) {
                    phi_1087_ = 1f;
                } else {
                    phi_1087_ = 0f;
                }
                let _e348 = phi_1087_;
                phi_1090_ = evaluate_Verdict(_e348, _e345);
            } else {
                phi_1090_ = evaluate_Verdict(1f, true);
            }
            let _e352 = phi_1090_;
            phi_1091_ = _e352;
        }
        let _e354 = phi_1091_;
        visibility.member[_e63.first_primitive] = _e354.visibility;
        phi_1095_ = _e354.is_doubted;
        phi_1096_ = _e63.first_primitive;
    } else {
        phi_1095_ = false;
        phi_1096_ = 0u;
    }
    let _e359 = phi_1095_;
    let _e361 = phi_1096_;
    if _e359 {
        let _e363 = atomicAdd((&shared_[0u]), 1u);
        phi_1102_ = _e363;
    } else {
        phi_1102_ = 0u;
    }
    let _e365 = phi_1102_;
    workgroupBarrier();
    if (_e48 == 0u) {
        let _e369 = atomicLoad((&shared_[0u]));
        let _e370 = atomicAdd((&list.member[3u]), _e369);
        atomicStore((&shared_[1u]), _e370);
    }
    workgroupBarrier();
    if _e359 {
        let _e373 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e373) + _e365)]), _e361);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_esm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
