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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_35 {
    member: abi_ShadowParams,
}

struct type_39 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_181_: lt_bvh_traverse_Tree;
    var phi_182_: bool;
    var phi_183_: lt_bvh_traverse_Tree;
    var phi_184_: bool;
    var phi_189_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_181_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_182_ = false;
        } else {
            phi_181_ = lt_bvh_traverse_Tree();
            phi_182_ = true;
        }
        let _e72 = phi_181_;
        let _e74 = phi_182_;
        phi_183_ = _e72;
        phi_184_ = _e74;
    } else {
        phi_183_ = lt_bvh_traverse_Tree();
        phi_184_ = true;
    }
    let _e76 = phi_183_;
    let _e78 = phi_184_;
    if _e78 {
        phi_189_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_189_ = _e76;
    }
    let _e83 = phi_189_;
    return lt_bvh_traverse_Tree(_e83.root, _e83.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_369_: bool;
    var phi_373_: f32;
    var phi_392_: f32;
    var phi_397_: f32;
    var phi_419_: f32;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_426_: f32;
    var phi_427_: bool;
    var phi_431_: f32;
    var phi_469_: f32;
    var phi_480_: f32;
    var phi_485_: f32;
    var phi_507_: f32;
    var phi_512_: f32;
    var phi_513_: bool;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_519_: f32;
    var phi_557_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_595_: f32;
    var phi_600_: f32;
    var phi_601_: bool;
    var phi_602_: f32;
    var phi_603_: bool;
    var phi_607_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_661_: f32;
    var phi_683_: f32;
    var phi_688_: f32;
    var phi_689_: bool;
    var phi_690_: f32;
    var phi_691_: bool;
    var phi_695_: f32;
    var phi_733_: f32;
    var phi_786_: bool;
    var phi_790_: f32;
    var phi_802_: bool;
    var phi_809_: f32;
    var phi_822_: bool;
    var phi_826_: f32;
    var phi_846_: f32;
    var phi_851_: f32;
    var phi_873_: f32;
    var phi_878_: f32;
    var phi_879_: bool;
    var phi_880_: f32;
    var phi_881_: bool;
    var phi_885_: f32;
    var phi_923_: f32;
    var phi_934_: f32;
    var phi_939_: f32;
    var phi_961_: f32;
    var phi_966_: f32;
    var phi_967_: bool;
    var phi_968_: f32;
    var phi_969_: bool;
    var phi_973_: f32;
    var phi_1011_: f32;
    var phi_1022_: f32;
    var phi_1027_: f32;
    var phi_1049_: f32;
    var phi_1054_: f32;
    var phi_1055_: bool;
    var phi_1056_: f32;
    var phi_1057_: bool;
    var phi_1061_: f32;
    var phi_1099_: f32;
    var phi_1110_: f32;
    var phi_1115_: f32;
    var phi_1137_: f32;
    var phi_1142_: f32;
    var phi_1143_: bool;
    var phi_1144_: f32;
    var phi_1145_: bool;
    var phi_1149_: f32;
    var phi_1187_: f32;
    var phi_1240_: bool;
    var phi_1244_: f32;
    var phi_1256_: bool;
    var phi_1263_: f32;
    var phi_1274_: bool;
    var phi_1278_: f32;
    var phi_1293_: f32;
    var phi_1294_: f32;
    var phi_1295_: f32;

    let _e63 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_369_ = true;
    } else {
        let _e67 = (42f < _e63);
        if _e67 {
        }
        phi_369_ = _e67;
    }
    let _e69 = phi_369_;
    if _e69 {
        phi_373_ = 42f;
    } else {
        phi_373_ = _e63;
    }
    let _e71 = phi_373_;
    let _e73 = (_e71 * param_5.x);
    let _e75 = (_e71 * param_5.y);
    let _e77 = (_e71 * param_5.z);
    let _e79 = (_e71 * param_5.w);
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_469_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_392_ = -87f;
        } else {
            phi_392_ = _e73;
        }
        let _e85 = phi_392_;
        if (_e85 > 88f) {
            phi_397_ = 88f;
        } else {
            phi_397_ = _e85;
        }
        let _e88 = phi_397_;
        let _e90 = ((_e88 * 1.442695f) + 0.5f);
        if (_e90 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)));
            if (_e102 > _e90) {
                phi_419_ = 1f;
            } else {
                phi_419_ = 0f;
            }
            let _e105 = phi_419_;
            if (_e90 < 8388608f) {
                phi_424_ = (_e102 - _e105);
                phi_425_ = false;
            } else {
                phi_424_ = f32();
                phi_425_ = true;
            }
            let _e108 = phi_424_;
            let _e110 = phi_425_;
            phi_426_ = _e108;
            phi_427_ = _e110;
        } else {
            phi_426_ = f32();
            phi_427_ = true;
        }
        let _e112 = phi_426_;
        let _e114 = phi_427_;
        if _e114 {
            phi_431_ = _e90;
        } else {
            phi_431_ = _e112;
        }
        let _e116 = phi_431_;
        let _e120 = ((_e88 - (_e116 * 0.69314575f)) - (_e116 * 0.0000014286068f));
        phi_469_ = ((((((((((((((((1f / 5040f) * _e120) + (1f / 720f)) * _e120) + (1f / 120f)) * _e120) + (1f / 24f)) * _e120) + (1f / 6f)) * _e120) + 0.5f) * _e120) + 1f) * _e120) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e116), i32(-2147483648), (_e116 < bitcast<f32>(3472883712u))), 2147483647i, (_e116 > bitcast<f32>(1325400063u))), (_e116 == _e116)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e156 = phi_469_;
    if ((bitcast<u32>(_e75) & 2147483647u) > 2139095040u) {
        phi_557_ = _e75;
    } else {
        if (_e75 < -87f) {
            phi_480_ = -87f;
        } else {
            phi_480_ = _e75;
        }
        let _e162 = phi_480_;
        if (_e162 > 88f) {
            phi_485_ = 88f;
        } else {
            phi_485_ = _e162;
        }
        let _e165 = phi_485_;
        let _e167 = ((_e165 * 1.442695f) + 0.5f);
        if (_e167 > -8388608f) {
            let _e179 = f32(select(0i, select(select(i32(_e167), i32(-2147483648), (_e167 < bitcast<f32>(3472883712u))), 2147483647i, (_e167 > bitcast<f32>(1325400063u))), (_e167 == _e167)));
            if (_e179 > _e167) {
                phi_507_ = 1f;
            } else {
                phi_507_ = 0f;
            }
            let _e182 = phi_507_;
            if (_e167 < 8388608f) {
                phi_512_ = (_e179 - _e182);
                phi_513_ = false;
            } else {
                phi_512_ = f32();
                phi_513_ = true;
            }
            let _e185 = phi_512_;
            let _e187 = phi_513_;
            phi_514_ = _e185;
            phi_515_ = _e187;
        } else {
            phi_514_ = f32();
            phi_515_ = true;
        }
        let _e189 = phi_514_;
        let _e191 = phi_515_;
        if _e191 {
            phi_519_ = _e167;
        } else {
            phi_519_ = _e189;
        }
        let _e193 = phi_519_;
        let _e197 = ((_e165 - (_e193 * 0.69314575f)) - (_e193 * 0.0000014286068f));
        phi_557_ = ((((((((((((((((1f / 5040f) * _e197) + (1f / 720f)) * _e197) + (1f / 120f)) * _e197) + (1f / 24f)) * _e197) + (1f / 6f)) * _e197) + 0.5f) * _e197) + 1f) * _e197) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e193), i32(-2147483648), (_e193 < bitcast<f32>(3472883712u))), 2147483647i, (_e193 > bitcast<f32>(1325400063u))), (_e193 == _e193)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e233 = phi_557_;
    if ((bitcast<u32>(_e77) & 2147483647u) > 2139095040u) {
        phi_645_ = _e77;
    } else {
        if (_e77 < -87f) {
            phi_568_ = -87f;
        } else {
            phi_568_ = _e77;
        }
        let _e239 = phi_568_;
        if (_e239 > 88f) {
            phi_573_ = 88f;
        } else {
            phi_573_ = _e239;
        }
        let _e242 = phi_573_;
        let _e244 = ((_e242 * 1.442695f) + 0.5f);
        if (_e244 > -8388608f) {
            let _e256 = f32(select(0i, select(select(i32(_e244), i32(-2147483648), (_e244 < bitcast<f32>(3472883712u))), 2147483647i, (_e244 > bitcast<f32>(1325400063u))), (_e244 == _e244)));
            if (_e256 > _e244) {
                phi_595_ = 1f;
            } else {
                phi_595_ = 0f;
            }
            let _e259 = phi_595_;
            if (_e244 < 8388608f) {
                phi_600_ = (_e256 - _e259);
                phi_601_ = false;
            } else {
                phi_600_ = f32();
                phi_601_ = true;
            }
            let _e262 = phi_600_;
            let _e264 = phi_601_;
            phi_602_ = _e262;
            phi_603_ = _e264;
        } else {
            phi_602_ = f32();
            phi_603_ = true;
        }
        let _e266 = phi_602_;
        let _e268 = phi_603_;
        if _e268 {
            phi_607_ = _e244;
        } else {
            phi_607_ = _e266;
        }
        let _e270 = phi_607_;
        let _e274 = ((_e242 - (_e270 * 0.69314575f)) - (_e270 * 0.0000014286068f));
        phi_645_ = ((((((((((((((((1f / 5040f) * _e274) + (1f / 720f)) * _e274) + (1f / 120f)) * _e274) + (1f / 24f)) * _e274) + (1f / 6f)) * _e274) + 0.5f) * _e274) + 1f) * _e274) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e270), i32(-2147483648), (_e270 < bitcast<f32>(3472883712u))), 2147483647i, (_e270 > bitcast<f32>(1325400063u))), (_e270 == _e270)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e310 = phi_645_;
    if ((bitcast<u32>(_e79) & 2147483647u) > 2139095040u) {
        phi_733_ = _e79;
    } else {
        if (_e79 < -87f) {
            phi_656_ = -87f;
        } else {
            phi_656_ = _e79;
        }
        let _e316 = phi_656_;
        if (_e316 > 88f) {
            phi_661_ = 88f;
        } else {
            phi_661_ = _e316;
        }
        let _e319 = phi_661_;
        let _e321 = ((_e319 * 1.442695f) + 0.5f);
        if (_e321 > -8388608f) {
            let _e333 = f32(select(0i, select(select(i32(_e321), i32(-2147483648), (_e321 < bitcast<f32>(3472883712u))), 2147483647i, (_e321 > bitcast<f32>(1325400063u))), (_e321 == _e321)));
            if (_e333 > _e321) {
                phi_683_ = 1f;
            } else {
                phi_683_ = 0f;
            }
            let _e336 = phi_683_;
            if (_e321 < 8388608f) {
                phi_688_ = (_e333 - _e336);
                phi_689_ = false;
            } else {
                phi_688_ = f32();
                phi_689_ = true;
            }
            let _e339 = phi_688_;
            let _e341 = phi_689_;
            phi_690_ = _e339;
            phi_691_ = _e341;
        } else {
            phi_690_ = f32();
            phi_691_ = true;
        }
        let _e343 = phi_690_;
        let _e345 = phi_691_;
        if _e345 {
            phi_695_ = _e321;
        } else {
            phi_695_ = _e343;
        }
        let _e347 = phi_695_;
        let _e351 = ((_e319 - (_e347 * 0.69314575f)) - (_e347 * 0.0000014286068f));
        phi_733_ = ((((((((((((((((1f / 5040f) * _e351) + (1f / 720f)) * _e351) + (1f / 120f)) * _e351) + (1f / 24f)) * _e351) + (1f / 6f)) * _e351) + 0.5f) * _e351) + 1f) * _e351) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e347), i32(-2147483648), (_e347 < bitcast<f32>(3472883712u))), 2147483647i, (_e347 > bitcast<f32>(1325400063u))), (_e347 == _e347)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e387 = phi_733_;
    let _e389 = (_e156 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e391 = (_e233 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e393 = (_e310 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e395 = (_e387 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e397 = (*param_4).min_variance;
    let _e399 = ((_e397 * _e71) * _e71);
    let _e410 = ((((_e389 * param_6.x) + (_e391 * param_6.y)) + (_e393 * param_6.z)) + (_e395 * param_6.w));
    let _e411 = (_e389 - _e410);
    let _e412 = (_e391 - _e410);
    let _e413 = (_e393 - _e410);
    let _e414 = (_e395 - _e410);
    let _e429 = (((((_e411 * _e411) * param_6.x) + ((_e412 * _e412) * param_6.y)) + ((_e413 * _e413) * param_6.z)) + ((_e414 * _e414) * param_6.w));
    if ((bitcast<u32>(_e399) & 2147483647u) > 2139095040u) {
        phi_786_ = true;
    } else {
        let _e433 = (_e399 > _e429);
        if _e433 {
        }
        phi_786_ = _e433;
    }
    let _e435 = phi_786_;
    if _e435 {
        phi_790_ = _e399;
    } else {
        phi_790_ = _e429;
    }
    let _e437 = phi_790_;
    let _e438 = -(_e410);
    if (_e438 <= 0f) {
        let _e442 = ((bitcast<u32>(_e437) & 2147483647u) > 2139095040u);
        if _e442 {
        }
        phi_802_ = _e442;
    } else {
        phi_802_ = true;
    }
    let _e444 = phi_802_;
    if _e444 {
        phi_809_ = (_e437 / (_e437 + (_e438 * _e438)));
    } else {
        phi_809_ = 1f;
    }
    let _e449 = phi_809_;
    let _e451 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_822_ = true;
    } else {
        let _e455 = (42f < _e451);
        if _e455 {
        }
        phi_822_ = _e455;
    }
    let _e457 = phi_822_;
    if _e457 {
        phi_826_ = 42f;
    } else {
        phi_826_ = _e451;
    }
    let _e459 = phi_826_;
    let _e460 = -(_e459);
    let _e462 = (_e460 * param_5.x);
    let _e464 = (_e460 * param_5.y);
    let _e466 = (_e460 * param_5.z);
    let _e468 = (_e460 * param_5.w);
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_923_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_846_ = -87f;
        } else {
            phi_846_ = _e462;
        }
        let _e474 = phi_846_;
        if (_e474 > 88f) {
            phi_851_ = 88f;
        } else {
            phi_851_ = _e474;
        }
        let _e477 = phi_851_;
        let _e479 = ((_e477 * 1.442695f) + 0.5f);
        if (_e479 > -8388608f) {
            let _e491 = f32(select(0i, select(select(i32(_e479), i32(-2147483648), (_e479 < bitcast<f32>(3472883712u))), 2147483647i, (_e479 > bitcast<f32>(1325400063u))), (_e479 == _e479)));
            if (_e491 > _e479) {
                phi_873_ = 1f;
            } else {
                phi_873_ = 0f;
            }
            let _e494 = phi_873_;
            if (_e479 < 8388608f) {
                phi_878_ = (_e491 - _e494);
                phi_879_ = false;
            } else {
                phi_878_ = f32();
                phi_879_ = true;
            }
            let _e497 = phi_878_;
            let _e499 = phi_879_;
            phi_880_ = _e497;
            phi_881_ = _e499;
        } else {
            phi_880_ = f32();
            phi_881_ = true;
        }
        let _e501 = phi_880_;
        let _e503 = phi_881_;
        if _e503 {
            phi_885_ = _e479;
        } else {
            phi_885_ = _e501;
        }
        let _e505 = phi_885_;
        let _e509 = ((_e477 - (_e505 * 0.69314575f)) - (_e505 * 0.0000014286068f));
        phi_923_ = ((((((((((((((((1f / 5040f) * _e509) + (1f / 720f)) * _e509) + (1f / 120f)) * _e509) + (1f / 24f)) * _e509) + (1f / 6f)) * _e509) + 0.5f) * _e509) + 1f) * _e509) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e505), i32(-2147483648), (_e505 < bitcast<f32>(3472883712u))), 2147483647i, (_e505 > bitcast<f32>(1325400063u))), (_e505 == _e505)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e545 = phi_923_;
    if ((bitcast<u32>(_e464) & 2147483647u) > 2139095040u) {
        phi_1011_ = _e464;
    } else {
        if (_e464 < -87f) {
            phi_934_ = -87f;
        } else {
            phi_934_ = _e464;
        }
        let _e551 = phi_934_;
        if (_e551 > 88f) {
            phi_939_ = 88f;
        } else {
            phi_939_ = _e551;
        }
        let _e554 = phi_939_;
        let _e556 = ((_e554 * 1.442695f) + 0.5f);
        if (_e556 > -8388608f) {
            let _e568 = f32(select(0i, select(select(i32(_e556), i32(-2147483648), (_e556 < bitcast<f32>(3472883712u))), 2147483647i, (_e556 > bitcast<f32>(1325400063u))), (_e556 == _e556)));
            if (_e568 > _e556) {
                phi_961_ = 1f;
            } else {
                phi_961_ = 0f;
            }
            let _e571 = phi_961_;
            if (_e556 < 8388608f) {
                phi_966_ = (_e568 - _e571);
                phi_967_ = false;
            } else {
                phi_966_ = f32();
                phi_967_ = true;
            }
            let _e574 = phi_966_;
            let _e576 = phi_967_;
            phi_968_ = _e574;
            phi_969_ = _e576;
        } else {
            phi_968_ = f32();
            phi_969_ = true;
        }
        let _e578 = phi_968_;
        let _e580 = phi_969_;
        if _e580 {
            phi_973_ = _e556;
        } else {
            phi_973_ = _e578;
        }
        let _e582 = phi_973_;
        let _e586 = ((_e554 - (_e582 * 0.69314575f)) - (_e582 * 0.0000014286068f));
        phi_1011_ = ((((((((((((((((1f / 5040f) * _e586) + (1f / 720f)) * _e586) + (1f / 120f)) * _e586) + (1f / 24f)) * _e586) + (1f / 6f)) * _e586) + 0.5f) * _e586) + 1f) * _e586) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e582), i32(-2147483648), (_e582 < bitcast<f32>(3472883712u))), 2147483647i, (_e582 > bitcast<f32>(1325400063u))), (_e582 == _e582)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e622 = phi_1011_;
    if ((bitcast<u32>(_e466) & 2147483647u) > 2139095040u) {
        phi_1099_ = _e466;
    } else {
        if (_e466 < -87f) {
            phi_1022_ = -87f;
        } else {
            phi_1022_ = _e466;
        }
        let _e628 = phi_1022_;
        if (_e628 > 88f) {
            phi_1027_ = 88f;
        } else {
            phi_1027_ = _e628;
        }
        let _e631 = phi_1027_;
        let _e633 = ((_e631 * 1.442695f) + 0.5f);
        if (_e633 > -8388608f) {
            let _e645 = f32(select(0i, select(select(i32(_e633), i32(-2147483648), (_e633 < bitcast<f32>(3472883712u))), 2147483647i, (_e633 > bitcast<f32>(1325400063u))), (_e633 == _e633)));
            if (_e645 > _e633) {
                phi_1049_ = 1f;
            } else {
                phi_1049_ = 0f;
            }
            let _e648 = phi_1049_;
            if (_e633 < 8388608f) {
                phi_1054_ = (_e645 - _e648);
                phi_1055_ = false;
            } else {
                phi_1054_ = f32();
                phi_1055_ = true;
            }
            let _e651 = phi_1054_;
            let _e653 = phi_1055_;
            phi_1056_ = _e651;
            phi_1057_ = _e653;
        } else {
            phi_1056_ = f32();
            phi_1057_ = true;
        }
        let _e655 = phi_1056_;
        let _e657 = phi_1057_;
        if _e657 {
            phi_1061_ = _e633;
        } else {
            phi_1061_ = _e655;
        }
        let _e659 = phi_1061_;
        let _e663 = ((_e631 - (_e659 * 0.69314575f)) - (_e659 * 0.0000014286068f));
        phi_1099_ = ((((((((((((((((1f / 5040f) * _e663) + (1f / 720f)) * _e663) + (1f / 120f)) * _e663) + (1f / 24f)) * _e663) + (1f / 6f)) * _e663) + 0.5f) * _e663) + 1f) * _e663) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e659), i32(-2147483648), (_e659 < bitcast<f32>(3472883712u))), 2147483647i, (_e659 > bitcast<f32>(1325400063u))), (_e659 == _e659)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e699 = phi_1099_;
    if ((bitcast<u32>(_e468) & 2147483647u) > 2139095040u) {
        phi_1187_ = _e468;
    } else {
        if (_e468 < -87f) {
            phi_1110_ = -87f;
        } else {
            phi_1110_ = _e468;
        }
        let _e705 = phi_1110_;
        if (_e705 > 88f) {
            phi_1115_ = 88f;
        } else {
            phi_1115_ = _e705;
        }
        let _e708 = phi_1115_;
        let _e710 = ((_e708 * 1.442695f) + 0.5f);
        if (_e710 > -8388608f) {
            let _e722 = f32(select(0i, select(select(i32(_e710), i32(-2147483648), (_e710 < bitcast<f32>(3472883712u))), 2147483647i, (_e710 > bitcast<f32>(1325400063u))), (_e710 == _e710)));
            if (_e722 > _e710) {
                phi_1137_ = 1f;
            } else {
                phi_1137_ = 0f;
            }
            let _e725 = phi_1137_;
            if (_e710 < 8388608f) {
                phi_1142_ = (_e722 - _e725);
                phi_1143_ = false;
            } else {
                phi_1142_ = f32();
                phi_1143_ = true;
            }
            let _e728 = phi_1142_;
            let _e730 = phi_1143_;
            phi_1144_ = _e728;
            phi_1145_ = _e730;
        } else {
            phi_1144_ = f32();
            phi_1145_ = true;
        }
        let _e732 = phi_1144_;
        let _e734 = phi_1145_;
        if _e734 {
            phi_1149_ = _e710;
        } else {
            phi_1149_ = _e732;
        }
        let _e736 = phi_1149_;
        let _e740 = ((_e708 - (_e736 * 0.69314575f)) - (_e736 * 0.0000014286068f));
        phi_1187_ = ((((((((((((((((1f / 5040f) * _e740) + (1f / 720f)) * _e740) + (1f / 120f)) * _e740) + (1f / 24f)) * _e740) + (1f / 6f)) * _e740) + 0.5f) * _e740) + 1f) * _e740) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e736), i32(-2147483648), (_e736 < bitcast<f32>(3472883712u))), 2147483647i, (_e736 > bitcast<f32>(1325400063u))), (_e736 == _e736)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e776 = phi_1187_;
    let _e778 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e545);
    let _e780 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e622);
    let _e782 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e699);
    let _e784 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e776);
    let _e786 = (*param_4).min_variance;
    let _e788 = ((_e786 * _e459) * _e459);
    let _e799 = ((((_e778 * param_6.x) + (_e780 * param_6.y)) + (_e782 * param_6.z)) + (_e784 * param_6.w));
    let _e800 = (_e778 - _e799);
    let _e801 = (_e780 - _e799);
    let _e802 = (_e782 - _e799);
    let _e803 = (_e784 - _e799);
    let _e818 = (((((_e800 * _e800) * param_6.x) + ((_e801 * _e801) * param_6.y)) + ((_e802 * _e802) * param_6.z)) + ((_e803 * _e803) * param_6.w));
    if ((bitcast<u32>(_e788) & 2147483647u) > 2139095040u) {
        phi_1240_ = true;
    } else {
        let _e822 = (_e788 > _e818);
        if _e822 {
        }
        phi_1240_ = _e822;
    }
    let _e824 = phi_1240_;
    if _e824 {
        phi_1244_ = _e788;
    } else {
        phi_1244_ = _e818;
    }
    let _e826 = phi_1244_;
    let _e827 = -(_e799);
    if (_e827 <= 0f) {
        let _e831 = ((bitcast<u32>(_e826) & 2147483647u) > 2139095040u);
        if _e831 {
        }
        phi_1256_ = _e831;
    } else {
        phi_1256_ = true;
    }
    let _e833 = phi_1256_;
    if _e833 {
        phi_1263_ = (_e826 / (_e826 + (_e827 * _e827)));
    } else {
        phi_1263_ = 1f;
    }
    let _e838 = phi_1263_;
    if ((bitcast<u32>(_e838) & 2147483647u) > 2139095040u) {
        phi_1274_ = true;
    } else {
        let _e842 = (_e838 < _e449);
        if _e842 {
        }
        phi_1274_ = _e842;
    }
    let _e844 = phi_1274_;
    if _e844 {
        phi_1278_ = _e838;
    } else {
        phi_1278_ = _e449;
    }
    let _e846 = phi_1278_;
    if ((bitcast<u32>(_e846) & 2147483647u) > 2139095040u) {
        phi_1295_ = _e846;
    } else {
        if (_e846 < 0f) {
            phi_1294_ = 0f;
        } else {
            if (_e846 > 1f) {
                phi_1293_ = 1f;
            } else {
                phi_1293_ = _e846;
            }
            let _e853 = phi_1293_;
            phi_1294_ = _e853;
        }
        let _e855 = phi_1294_;
        phi_1295_ = _e855;
    }
    let _e857 = phi_1295_;
    return _e857;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_290_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_343_: bool;
    var phi_347_: bool;
    var phi_352_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_220_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_10;
            }
            let _e69 = phi_218_;
            phi_219_ = _e69;
        }
        let _e71 = phi_219_;
        phi_220_ = _e71;
    }
    let _e73 = phi_220_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_238_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_8.x;
            }
            let _e81 = phi_236_;
            phi_237_ = _e81;
        }
        let _e83 = phi_237_;
        phi_238_ = _e83;
    }
    let _e85 = phi_238_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_256_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_8.y;
            }
            let _e93 = phi_254_;
            phi_255_ = _e93;
        }
        let _e95 = phi_255_;
        phi_256_ = _e95;
    }
    let _e97 = phi_256_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_274_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_273_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_272_ = 1f;
            } else {
                phi_272_ = param_8.z;
            }
            let _e105 = phi_272_;
            phi_273_ = _e105;
        }
        let _e107 = phi_273_;
        phi_274_ = _e107;
    }
    let _e109 = phi_274_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_292_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_291_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_290_ = 1f;
            } else {
                phi_290_ = param_8.w;
            }
            let _e117 = phi_290_;
            phi_291_ = _e117;
        }
        let _e119 = phi_291_;
        phi_292_ = _e119;
    }
    let _e121 = phi_292_;
    let _e122 = (_e85 - _e73);
    let _e123 = (_e97 - _e73);
    let _e124 = (_e109 - _e73);
    let _e125 = (_e121 - _e73);
    if (_e122 >= 0f) {
        if (_e123 >= 0f) {
            if (_e124 >= 0f) {
                if (_e125 >= 0f) {
                    phi_329_ = !(((bitcast<u32>(((((_e122 * param_9.x) + (_e123 * param_9.y)) + (_e124 * param_9.z)) + (_e125 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_330_ = false;
                } else {
                    phi_329_ = bool();
                    phi_330_ = true;
                }
                let _e147 = phi_329_;
                let _e149 = phi_330_;
                phi_331_ = _e147;
                phi_332_ = false;
                phi_333_ = _e149;
            } else {
                phi_331_ = bool();
                phi_332_ = true;
                phi_333_ = false;
            }
            let _e151 = phi_331_;
            let _e153 = phi_332_;
            let _e155 = phi_333_;
            phi_334_ = _e151;
            phi_335_ = _e153;
            phi_336_ = _e155;
        } else {
            phi_334_ = bool();
            phi_335_ = true;
            phi_336_ = false;
        }
        let _e157 = phi_334_;
        let _e159 = phi_335_;
        let _e161 = phi_336_;
        phi_337_ = _e157;
        phi_338_ = _e159;
        phi_339_ = _e161;
    } else {
        phi_337_ = bool();
        phi_338_ = true;
        phi_339_ = false;
    }
    let _e163 = phi_337_;
    let _e165 = phi_338_;
    let _e167 = phi_339_;
    if _e165 {
        phi_343_ = true;
    } else {
        phi_343_ = _e167;
    }
    let _e169 = phi_343_;
    if _e169 {
        phi_347_ = false;
    } else {
        phi_347_ = _e163;
    }
    let _e171 = phi_347_;
    if _e171 {
        phi_352_ = 1f;
    } else {
        let _e172 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e122, _e123, _e124, _e125), param_9);
        phi_352_ = _e172;
    }
    let _e174 = phi_352_;
    return _e174;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1368_: bool;
    var phi_1438_: bool;
    var phi_1439_: bool;
    var phi_1450_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1451_: bool;
    var phi_1452_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1453_: bool;
    var phi_1460_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1464_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1484_: lt_math_LightPoint;
    var phi_1487_: u32;
    var phi_1489_: lt_math_LevelPoint;
    var phi_1575_: bool;
    var phi_1584_: bool;
    var phi_1593_: bool;
    var phi_1594_: bool;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1597_: bool;
    var phi_1598_: bool;
    var phi_1599_: bool;
    var phi_1603_: bool;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1632_: bool;
    var phi_1633_: bool;
    var phi_1634_: bool;
    var phi_1635_: bool;
    var phi_1636_: bool;
    var phi_1637_: bool;
    var phi_1641_: bool;
    var phi_1650_: lt_math_LightPoint;
    var phi_1651_: u32;
    var phi_1652_: lt_math_LevelPoint;
    var phi_1653_: bool;
    var phi_1485_: lt_math_LightPoint;
    var phi_1488_: u32;
    var phi_1490_: lt_math_LevelPoint;
    var phi_1654_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1694_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1697_: bool;
    var phi_1701_: bool;
    var phi_1783_: f32;
    var phi_1901_: f32;
    var phi_1902_: f32;
    var phi_1905_: f32;
    var phi_1934_: f32;
    var phi_1939_: f32;
    var phi_1940_: bool;
    var phi_1941_: f32;
    var phi_1942_: bool;
    var phi_1946_: f32;
    var phi_1966_: f32;
    var phi_1971_: f32;
    var phi_1972_: bool;
    var phi_1973_: f32;
    var phi_1974_: bool;
    var phi_1978_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_2033_: i32;
    var phi_2038_: i32;
    var phi_2043_: i32;
    var phi_2048_: i32;
    var phi_2057_: i32;
    var phi_2062_: i32;
    var phi_2067_: i32;
    var phi_2072_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_2128_: i32;
    var phi_2133_: i32;
    var phi_2138_: i32;
    var phi_2143_: i32;
    var phi_2162_: i32;
    var phi_2167_: i32;
    var phi_2172_: i32;
    var phi_2177_: i32;
    var phi_2196_: i32;
    var phi_2201_: i32;
    var phi_2206_: i32;
    var phi_2211_: i32;
    var phi_2230_: i32;
    var phi_2235_: i32;
    var phi_2240_: i32;
    var phi_2245_: i32;
    var phi_2323_: bool;
    var phi_2331_: bool;
    var phi_2343_: bool;
    var phi_2344_: bool;
    var phi_2348_: f32;
    var phi_2354_: f32;
    var phi_2356_: evaluate_Verdict;
    var phi_2366_: u32;
    var phi_2375_: f32;
    var phi_2377_: evaluate_Verdict;
    var phi_2378_: bool;
    var phi_2379_: evaluate_Verdict;
    var phi_2380_: bool;
    var phi_2385_: evaluate_Verdict;
    var phi_2390_: evaluate_Verdict;
    var phi_2391_: evaluate_Verdict;

    let _e60 = id_1;
    let _e67 = arrayLength((&map.member));
    let _e73 = arrayLength((&marks.member));
    let _e76 = arrayLength((&levels.member));
    let _e79 = p.member.size[0u];
    let _e81 = p.member.size[1u];
    let _e82 = lt_shaders_entry_pixel_index(_e60, _e79, _e81);
    if (bitcast<i32>(_e82.root) != 0i) {
        let _e88 = p.member.level_count;
        if (_e82.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e95 = samples.member[(0u + _e82.first_primitive)].normal[0u];
        let _e97 = global[0u];
        if (_e95 == _e97) {
            let _e100 = samples.member[(0u + _e82.first_primitive)].normal[1u];
            let _e102 = global[1u];
            if (_e100 == _e102) {
                let _e105 = samples.member[(0u + _e82.first_primitive)].normal[2u];
                let _e107 = global[2u];
                phi_1361_ = (_e105 == _e107);
                phi_1362_ = false;
            } else {
                phi_1361_ = bool();
                phi_1362_ = true;
            }
            let _e110 = phi_1361_;
            let _e112 = phi_1362_;
            phi_1363_ = _e110;
            phi_1364_ = _e112;
        } else {
            phi_1363_ = bool();
            phi_1364_ = true;
        }
        let _e114 = phi_1363_;
        let _e116 = phi_1364_;
        if _e116 {
            phi_1368_ = false;
        } else {
            phi_1368_ = _e114;
        }
        let _e118 = phi_1368_;
        if !(_e118) {
            let _e121 = samples.member[(0u + _e82.first_primitive)].position;
            let _e123 = p.member.light.place;
            let _e129 = p.member.light.place[3u];
            let _e136 = (_e123.x - (_e121.x * _e129));
            let _e137 = (_e123.y - (_e121.y * _e129));
            let _e138 = (_e123.z - (_e121.z * _e129));
            let _e140 = samples.member[(0u + _e82.first_primitive)].normal;
            if ((((_e140.x * _e136) + (_e140.y * _e137)) + (_e140.z * _e138)) > 0f) {
                let _e154 = (((_e136 * _e136) + (_e137 * _e137)) + (_e138 * _e138));
                let _e156 = p.member.light.axis;
                let _e168 = p.member.light.place[3u];
                if (_e168 == 0f) {
                    phi_1439_ = true;
                } else {
                    let _e171 = p.member.light.range_squared;
                    if (_e154 <= _e171) {
                        let _e174 = p.member.light.cos_outer;
                        phi_1438_ = (-((((_e136 * _e156.x) + (_e137 * _e156.y)) + (_e138 * _e156.z))) >= (_e174 * sqrt(_e154)));
                    } else {
                        phi_1438_ = false;
                    }
                    let _e179 = phi_1438_;
                    phi_1439_ = _e179;
                }
                let _e181 = phi_1439_;
                if _e181 {
                    let _e183 = samples.member[(0u + _e82.first_primitive)].flags;
                    let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e191.unnamed.visibility, false), _e191.unnamed_1);
                    phi_1450_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e197.unnamed, ((_e183 & 1u) == 0u));
                    phi_1451_ = false;
                } else {
                    phi_1450_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1451_ = true;
                }
                let _e202 = phi_1450_;
                let _e204 = phi_1451_;
                phi_1452_ = _e202;
                phi_1453_ = _e204;
            } else {
                phi_1452_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1453_ = true;
            }
            let _e206 = phi_1452_;
            let _e208 = phi_1453_;
            if _e208 {
                let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
                phi_1460_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
            } else {
                phi_1460_ = _e206;
            }
            let _e225 = phi_1460_;
            phi_1464_ = _e225;
        } else {
            let _e231 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e237 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e231.unnamed.visibility, false), _e231.unnamed_1);
            phi_1464_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e237.unnamed, true);
        }
        let _e242 = phi_1464_;
        if _e242.unnamed_1 {
            phi_2391_ = evaluate_Verdict(_e242.unnamed.visibility, _e242.unnamed.is_doubted);
        } else {
            let _e250 = samples.member[(0u + _e82.first_primitive)].position;
            let _e252 = p.member.map_size;
            let _e254 = (0.5f / f32(_e252));
            let _e261 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e268 = lt_math_LightPoint(vec2<f32>(_e261.uv.x, 0f), _e261.depth, _e261.is_inside);
            let _e272 = lt_math_LightPoint(_e268.uv, 0f, _e268.is_inside);
            phi_1484_ = lt_math_LightPoint();
            phi_1487_ = 0u;
            phi_1489_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e272.uv, _e272.depth, false));
            loop {
                let _e279 = phi_1484_;
                let _e281 = phi_1487_;
                let _e283 = phi_1489_;
                local_1 = _e283;
                local_2 = _e283;
                local_3 = _e283;
                local_4 = _e283;
                if (_e281 < _e88) {
                    if _e283.point.is_inside {
                        phi_1650_ = lt_math_LightPoint();
                        phi_1651_ = u32();
                        phi_1652_ = lt_math_LevelPoint();
                        phi_1653_ = false;
                    } else {
                        if (_e281 < _e76) {
                        } else {
                            return;
                        }
                        let _e294 = levels.member[(0u + _e281)].row_w;
                        let _e305 = ((((_e294.x * _e250.x) + (_e294.y * _e250.y)) + (_e294.z * _e250.z)) + (_e294.w * 1f));
                        let _e307 = levels.member[(0u + _e281)].row_x;
                        let _e319 = (((((_e307.x * _e250.x) + (_e307.y * _e250.y)) + (_e307.z * _e250.z)) + (_e307.w * 1f)) / _e305);
                        let _e321 = levels.member[(0u + _e281)].row_y;
                        let _e333 = (((((_e321.x * _e250.x) + (_e321.y * _e250.y)) + (_e321.z * _e250.z)) + (_e321.w * 1f)) / _e305);
                        let _e335 = levels.member[(0u + _e281)].row_z;
                        let _e346 = ((((_e335.x * _e250.x) + (_e335.y * _e250.y)) + (_e335.z * _e250.z)) + (_e335.w * 1f));
                        if (_e305 > 0f) {
                            if (_e319 >= 0f) {
                                phi_1575_ = (_e319 <= 1f);
                            } else {
                                phi_1575_ = false;
                            }
                            let _e351 = phi_1575_;
                            if _e351 {
                                if (_e333 >= 0f) {
                                    phi_1584_ = (_e333 <= 1f);
                                } else {
                                    phi_1584_ = false;
                                }
                                let _e355 = phi_1584_;
                                if _e355 {
                                    if (_e346 >= 0f) {
                                        phi_1593_ = (_e346 <= 1f);
                                    } else {
                                        phi_1593_ = false;
                                    }
                                    let _e359 = phi_1593_;
                                    phi_1594_ = _e359;
                                    phi_1595_ = false;
                                } else {
                                    phi_1594_ = bool();
                                    phi_1595_ = true;
                                }
                                let _e361 = phi_1594_;
                                let _e363 = phi_1595_;
                                phi_1596_ = _e361;
                                phi_1597_ = _e363;
                            } else {
                                phi_1596_ = bool();
                                phi_1597_ = true;
                            }
                            let _e365 = phi_1596_;
                            let _e367 = phi_1597_;
                            phi_1598_ = _e365;
                            phi_1599_ = _e367;
                        } else {
                            phi_1598_ = bool();
                            phi_1599_ = true;
                        }
                        let _e369 = phi_1598_;
                        let _e371 = phi_1599_;
                        if _e371 {
                            phi_1603_ = false;
                        } else {
                            phi_1603_ = _e369;
                        }
                        let _e373 = phi_1603_;
                        if _e373 {
                            if (_e319 >= _e254) {
                                if (_e319 <= (1f - _e254)) {
                                    if (_e333 >= _e254) {
                                        phi_1630_ = (_e333 <= (1f - _e254));
                                        phi_1631_ = false;
                                    } else {
                                        phi_1630_ = bool();
                                        phi_1631_ = true;
                                    }
                                    let _e381 = phi_1630_;
                                    let _e383 = phi_1631_;
                                    phi_1632_ = _e381;
                                    phi_1633_ = _e383;
                                } else {
                                    phi_1632_ = bool();
                                    phi_1633_ = true;
                                }
                                let _e385 = phi_1632_;
                                let _e387 = phi_1633_;
                                phi_1634_ = _e385;
                                phi_1635_ = _e387;
                            } else {
                                phi_1634_ = bool();
                                phi_1635_ = true;
                            }
                            let _e389 = phi_1634_;
                            let _e391 = phi_1635_;
                            phi_1636_ = _e389;
                            phi_1637_ = _e391;
                        } else {
                            phi_1636_ = bool();
                            phi_1637_ = true;
                        }
                        let _e393 = phi_1636_;
                        let _e395 = phi_1637_;
                        if _e395 {
                            phi_1641_ = false;
                        } else {
                            phi_1641_ = _e393;
                        }
                        let _e397 = phi_1641_;
                        let _e404 = lt_math_LightPoint(vec2<f32>(_e319, _e279.uv.y), _e279.depth, _e279.is_inside);
                        let _e411 = lt_math_LightPoint(vec2<f32>(_e404.uv.x, _e333), _e404.depth, _e404.is_inside);
                        let _e415 = lt_math_LightPoint(_e411.uv, _e346, _e411.is_inside);
                        let _e419 = lt_math_LightPoint(_e415.uv, _e415.depth, _e397);
                        phi_1650_ = _e419;
                        phi_1651_ = (_e281 + 1u);
                        phi_1652_ = lt_math_LevelPoint(_e281, _e419);
                        phi_1653_ = true;
                    }
                    let _e423 = phi_1650_;
                    let _e425 = phi_1651_;
                    let _e427 = phi_1652_;
                    let _e429 = phi_1653_;
                    phi_1485_ = _e423;
                    phi_1488_ = _e425;
                    phi_1490_ = _e427;
                    phi_1654_ = _e429;
                } else {
                    phi_1485_ = lt_math_LightPoint();
                    phi_1488_ = u32();
                    phi_1490_ = lt_math_LevelPoint();
                    phi_1654_ = false;
                }
                let _e431 = phi_1485_;
                let _e433 = phi_1488_;
                let _e435 = phi_1490_;
                let _e437 = phi_1654_;
                continue;
                continuing {
                    phi_1484_ = _e431;
                    phi_1487_ = _e433;
                    phi_1489_ = _e435;
                    break if !(_e437);
                }
            }
            let _e440 = local_1;
            if _e440.point.is_inside {
                if (0f > 0f) {
                    let _e446 = local_2;
                    if (_e446.level < _e76) {
                    } else {
                        return;
                    }
                    let _e451 = levels.member[(0u + _e446.level)];
                    let _e457 = global[0u];
                    if (_e451.row_w.x == _e457) {
                        let _e460 = global[1u];
                        if (_e451.row_w.y == _e460) {
                            let _e463 = global[2u];
                            phi_1694_ = (_e451.row_w.z == _e463);
                            phi_1695_ = false;
                        } else {
                            phi_1694_ = bool();
                            phi_1695_ = true;
                        }
                        let _e466 = phi_1694_;
                        let _e468 = phi_1695_;
                        phi_1696_ = _e466;
                        phi_1697_ = _e468;
                    } else {
                        phi_1696_ = bool();
                        phi_1697_ = true;
                    }
                    let _e470 = phi_1696_;
                    let _e472 = phi_1697_;
                    if _e472 {
                        phi_1701_ = false;
                    } else {
                        phi_1701_ = _e470;
                    }
                    let _e474 = phi_1701_;
                    if _e474 {
                        let _e476 = samples.member[(0u + _e82.first_primitive)].normal;
                        let _e478 = p.member.map_size;
                        let _e548 = ((abs(((((_e451.row_x.x * _e476.x) + (_e451.row_x.y * _e476.y)) + (_e451.row_x.z * _e476.z)) / (((_e451.row_x.x * _e451.row_x.x) + (_e451.row_x.y * _e451.row_x.y)) + (_e451.row_x.z * _e451.row_x.z)))) + abs(((((_e451.row_y.x * _e476.x) + (_e451.row_y.y * _e476.y)) + (_e451.row_y.z * _e476.z)) / (((_e451.row_y.x * _e451.row_y.x) + (_e451.row_y.y * _e451.row_y.y)) + (_e451.row_y.z * _e451.row_y.z))))) / (abs(((((_e451.row_z.x * _e476.x) + (_e451.row_z.y * _e476.y)) + (_e451.row_z.z * _e476.z)) / (((_e451.row_z.x * _e451.row_z.x) + (_e451.row_z.y * _e451.row_z.y)) + (_e451.row_z.z * _e451.row_z.z)))) * f32(_e478)));
                        if (_e548 < 0.002f) {
                            phi_1783_ = _e548;
                        } else {
                            phi_1783_ = 0.002f;
                        }
                        let _e551 = phi_1783_;
                        phi_1902_ = _e551;
                    } else {
                        let _e553 = p.member.map_size;
                        let _e559 = samples.member[(0u + _e82.first_primitive)].position;
                        let _e570 = ((((_e451.row_w.x * _e559.x) + (_e451.row_w.y * _e559.y)) + (_e451.row_w.z * _e559.z)) + _e451.row_w.w);
                        let _e583 = ((_e451.row_x.x - (_e451.row_w.x * _e440.point.uv.x)) / _e570);
                        let _e584 = ((_e451.row_x.y - (_e451.row_w.y * _e440.point.uv.x)) / _e570);
                        let _e585 = ((_e451.row_x.z - (_e451.row_w.z * _e440.point.uv.x)) / _e570);
                        let _e598 = ((_e451.row_y.x - (_e451.row_w.x * _e440.point.uv.y)) / _e570);
                        let _e599 = ((_e451.row_y.y - (_e451.row_w.y * _e440.point.uv.y)) / _e570);
                        let _e600 = ((_e451.row_y.z - (_e451.row_w.z * _e440.point.uv.y)) / _e570);
                        let _e606 = samples.member[(0u + _e82.first_primitive)].normal;
                        let _e611 = ((_e599 * _e606.z) - (_e606.y * _e600));
                        let _e616 = ((_e600 * _e606.x) - (_e606.z * _e598));
                        let _e621 = ((_e598 * _e606.y) - (_e606.x * _e599));
                        let _e623 = samples.member[(0u + _e82.first_primitive)].normal;
                        let _e628 = ((_e584 * _e623.z) - (_e623.y * _e585));
                        let _e633 = ((_e585 * _e623.x) - (_e623.z * _e583));
                        let _e638 = ((_e583 * _e623.y) - (_e623.x * _e584));
                        let _e665 = ((abs(((((_e451.row_z.x * _e611) + (_e451.row_z.y * _e616)) + (_e451.row_z.z * _e621)) / (((_e583 * _e611) + (_e584 * _e616)) + (_e585 * _e621)))) + abs(((((_e451.row_z.x * _e628) + (_e451.row_z.y * _e633)) + (_e451.row_z.z * _e638)) / (((_e598 * _e628) + (_e599 * _e633)) + (_e600 * _e638))))) / f32(_e553));
                        let _e667 = (16f / f32(_e553));
                        if (_e665 < _e667) {
                            phi_1901_ = _e665;
                        } else {
                            phi_1901_ = _e667;
                        }
                        let _e670 = phi_1901_;
                        phi_1902_ = _e670;
                    }
                    let _e672 = phi_1902_;
                    phi_1905_ = (_e440.point.depth - (0f * _e672));
                } else {
                    phi_1905_ = _e440.point.depth;
                }
                let _e676 = phi_1905_;
                let _e682 = p.member.map_size;
                let _e683 = f32(_e682);
                let _e686 = ((_e440.point.uv.x * _e683) - 0.5f);
                let _e687 = ((_e440.point.uv.y * _e683) - 0.5f);
                if (_e686 > -8388608f) {
                    let _e699 = f32(select(0i, select(select(i32(_e686), i32(-2147483648), (_e686 < bitcast<f32>(3472883712u))), 2147483647i, (_e686 > bitcast<f32>(1325400063u))), (_e686 == _e686)));
                    if (_e699 > _e686) {
                        phi_1934_ = 1f;
                    } else {
                        phi_1934_ = 0f;
                    }
                    let _e702 = phi_1934_;
                    if (_e686 < 8388608f) {
                        phi_1939_ = (_e699 - _e702);
                        phi_1940_ = false;
                    } else {
                        phi_1939_ = f32();
                        phi_1940_ = true;
                    }
                    let _e705 = phi_1939_;
                    let _e707 = phi_1940_;
                    phi_1941_ = _e705;
                    phi_1942_ = _e707;
                } else {
                    phi_1941_ = f32();
                    phi_1942_ = true;
                }
                let _e709 = phi_1941_;
                let _e711 = phi_1942_;
                if _e711 {
                    phi_1946_ = _e686;
                } else {
                    phi_1946_ = _e709;
                }
                let _e713 = phi_1946_;
                if (_e687 > -8388608f) {
                    let _e725 = f32(select(0i, select(select(i32(_e687), i32(-2147483648), (_e687 < bitcast<f32>(3472883712u))), 2147483647i, (_e687 > bitcast<f32>(1325400063u))), (_e687 == _e687)));
                    if (_e725 > _e687) {
                        phi_1966_ = 1f;
                    } else {
                        phi_1966_ = 0f;
                    }
                    let _e728 = phi_1966_;
                    if (_e687 < 8388608f) {
                        phi_1971_ = (_e725 - _e728);
                        phi_1972_ = false;
                    } else {
                        phi_1971_ = f32();
                        phi_1972_ = true;
                    }
                    let _e731 = phi_1971_;
                    let _e733 = phi_1972_;
                    phi_1973_ = _e731;
                    phi_1974_ = _e733;
                } else {
                    phi_1973_ = f32();
                    phi_1974_ = true;
                }
                let _e735 = phi_1973_;
                let _e737 = phi_1974_;
                if _e737 {
                    phi_1978_ = _e687;
                } else {
                    phi_1978_ = _e735;
                }
                let _e739 = phi_1978_;
                let _e740 = (_e686 - _e713);
                let _e741 = (_e687 - _e739);
                let _e750 = select(0i, select(select(i32(_e713), i32(-2147483648), (_e713 < bitcast<f32>(3472883712u))), 2147483647i, (_e713 > bitcast<f32>(1325400063u))), (_e713 == _e713));
                let _e759 = select(0i, select(select(i32(_e739), i32(-2147483648), (_e739 < bitcast<f32>(3472883712u))), 2147483647i, (_e739 > bitcast<f32>(1325400063u))), (_e739 == _e739));
                let _e770 = p.member.test;
                let _e771 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e770);
                let _e773 = p.member.map_size;
                let _e775 = local_3;
                local = lt_math_Evsm(_e771.positive_exponent, _e771.negative_exponent, _e771.min_variance);
                let _e782 = ((_e775.level * _e773) * _e773);
                let _e784 = (bitcast<i32>(_e773) - 1i);
                if (_e750 > 0i) {
                    phi_2033_ = _e750;
                } else {
                    phi_2033_ = 0i;
                }
                let _e787 = phi_2033_;
                if (_e759 > 0i) {
                    phi_2038_ = _e759;
                } else {
                    phi_2038_ = 0i;
                }
                let _e790 = phi_2038_;
                if (_e787 < _e784) {
                    phi_2043_ = _e787;
                } else {
                    phi_2043_ = _e784;
                }
                let _e793 = phi_2043_;
                if (_e790 < _e784) {
                    phi_2048_ = _e790;
                } else {
                    phi_2048_ = _e784;
                }
                let _e796 = phi_2048_;
                let _e797 = bitcast<u32>(_e793);
                let _e799 = (_e750 + 1i);
                let _e800 = (_e759 + 1i);
                if (_e799 > 0i) {
                    phi_2057_ = _e799;
                } else {
                    phi_2057_ = 0i;
                }
                let _e803 = phi_2057_;
                if (_e800 > 0i) {
                    phi_2062_ = _e800;
                } else {
                    phi_2062_ = 0i;
                }
                let _e806 = phi_2062_;
                if (_e803 < _e784) {
                    phi_2067_ = _e803;
                } else {
                    phi_2067_ = _e784;
                }
                let _e809 = phi_2067_;
                if (_e806 < _e784) {
                    phi_2072_ = _e806;
                } else {
                    phi_2072_ = _e784;
                }
                let _e812 = phi_2072_;
                let _e813 = bitcast<u32>(_e809);
                let _e815 = (bitcast<u32>(_e796) * _e773);
                let _e816 = (bitcast<u32>(_e812) * _e773);
                let _e821 = ((_e815 + _e797) + _e782);
                let _e822 = ((_e815 + _e813) + _e782);
                let _e823 = ((_e816 + _e797) + _e782);
                let _e824 = ((_e816 + _e813) + _e782);
                if (_e821 < _e67) {
                } else {
                    return;
                }
                let _e828 = map.member[(0u + _e821)];
                if (_e822 < _e67) {
                } else {
                    return;
                }
                let _e832 = map.member[(0u + _e822)];
                if (_e823 < _e67) {
                } else {
                    return;
                }
                let _e836 = map.member[(0u + _e823)];
                if (_e824 < _e67) {
                } else {
                    return;
                }
                let _e840 = map.member[(0u + _e824)];
                let _e842 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e828, _e832, _e836, _e840), vec4<f32>(((1f - _e740) * (1f - _e741)), (_e740 * (1f - _e741)), ((1f - _e740) * _e741), (_e740 * _e741)), _e676);
                let _e844 = p.member.map_size;
                let _e846 = local_4;
                let _e849 = (bitcast<i32>(_e844) - 1i);
                if (_e750 > 0i) {
                    phi_2128_ = _e750;
                } else {
                    phi_2128_ = 0i;
                }
                let _e852 = phi_2128_;
                if (_e759 > 0i) {
                    phi_2133_ = _e759;
                } else {
                    phi_2133_ = 0i;
                }
                let _e855 = phi_2133_;
                if (_e852 < _e849) {
                    phi_2138_ = _e852;
                } else {
                    phi_2138_ = _e849;
                }
                let _e858 = phi_2138_;
                if (_e855 < _e849) {
                    phi_2143_ = _e855;
                } else {
                    phi_2143_ = _e849;
                }
                let _e861 = phi_2143_;
                let _e862 = bitcast<u32>(_e858);
                let _e869 = ((((_e846.level * _e844) + bitcast<u32>(_e861)) * (_e844 / 16u)) + (_e862 / 16u));
                let _e872 = (_e750 + 1i);
                let _e873 = (_e759 + 0i);
                let _e875 = (bitcast<i32>(_e844) - 1i);
                if (_e872 > 0i) {
                    phi_2162_ = _e872;
                } else {
                    phi_2162_ = 0i;
                }
                let _e878 = phi_2162_;
                if (_e873 > 0i) {
                    phi_2167_ = _e873;
                } else {
                    phi_2167_ = 0i;
                }
                let _e881 = phi_2167_;
                if (_e878 < _e875) {
                    phi_2172_ = _e878;
                } else {
                    phi_2172_ = _e875;
                }
                let _e884 = phi_2172_;
                if (_e881 < _e875) {
                    phi_2177_ = _e881;
                } else {
                    phi_2177_ = _e875;
                }
                let _e887 = phi_2177_;
                let _e888 = bitcast<u32>(_e884);
                let _e895 = ((((_e846.level * _e844) + bitcast<u32>(_e887)) * (_e844 / 16u)) + (_e888 / 16u));
                let _e898 = (_e750 + 0i);
                let _e899 = (_e759 + 1i);
                let _e901 = (bitcast<i32>(_e844) - 1i);
                if (_e898 > 0i) {
                    phi_2196_ = _e898;
                } else {
                    phi_2196_ = 0i;
                }
                let _e904 = phi_2196_;
                if (_e899 > 0i) {
                    phi_2201_ = _e899;
                } else {
                    phi_2201_ = 0i;
                }
                let _e907 = phi_2201_;
                if (_e904 < _e901) {
                    phi_2206_ = _e904;
                } else {
                    phi_2206_ = _e901;
                }
                let _e910 = phi_2206_;
                if (_e907 < _e901) {
                    phi_2211_ = _e907;
                } else {
                    phi_2211_ = _e901;
                }
                let _e913 = phi_2211_;
                let _e914 = bitcast<u32>(_e910);
                let _e921 = ((((_e846.level * _e844) + bitcast<u32>(_e913)) * (_e844 / 16u)) + (_e914 / 16u));
                let _e924 = (_e750 + 1i);
                let _e925 = (_e759 + 1i);
                let _e927 = (bitcast<i32>(_e844) - 1i);
                if (_e924 > 0i) {
                    phi_2230_ = _e924;
                } else {
                    phi_2230_ = 0i;
                }
                let _e930 = phi_2230_;
                if (_e925 > 0i) {
                    phi_2235_ = _e925;
                } else {
                    phi_2235_ = 0i;
                }
                let _e933 = phi_2235_;
                if (_e930 < _e927) {
                    phi_2240_ = _e930;
                } else {
                    phi_2240_ = _e927;
                }
                let _e936 = phi_2240_;
                if (_e933 < _e927) {
                    phi_2245_ = _e933;
                } else {
                    phi_2245_ = _e927;
                }
                let _e939 = phi_2245_;
                let _e940 = bitcast<u32>(_e936);
                let _e947 = ((((_e846.level * _e844) + bitcast<u32>(_e939)) * (_e844 / 16u)) + (_e940 / 16u));
                if (_e869 < _e73) {
                } else {
                    return;
                }
                let _e953 = marks.member[(0u + _e869)];
                if (_e895 < _e73) {
                } else {
                    return;
                }
                let _e961 = marks.member[(0u + _e895)];
                if (_e921 < _e73) {
                } else {
                    return;
                }
                let _e970 = marks.member[(0u + _e921)];
                if (_e947 < _e73) {
                } else {
                    return;
                }
                let _e978 = marks.member[(0u + _e947)];
                let _e986 = p.member.epsilon;
                if (_e842 <= _e986) {
                    phi_2323_ = true;
                } else {
                    phi_2323_ = (_e842 >= (1f - _e986));
                }
                let _e991 = phi_2323_;
                if ((bitcast<u32>(_e842) & 2147483647u) > 2139095040u) {
                    phi_2331_ = true;
                } else {
                    phi_2331_ = !(_e991);
                }
                let _e997 = phi_2331_;
                if _e997 {
                    if (_e842 > 0f) {
                        if (_e842 < 1f) {
                            phi_2343_ = false;
                        } else {
                            phi_2343_ = true;
                        }
                        let _e1001 = phi_2343_;
                        phi_2344_ = _e1001;
                    } else {
                        phi_2344_ = true;
                    }
                    let _e1003 = phi_2344_;
                    if _e1003 {
                        phi_2348_ = 0.5f;
                    } else {
                        phi_2348_ = _e842;
                    }
                    let _e1005 = phi_2348_;
                    phi_2356_ = evaluate_Verdict(_e1005, true);
                } else {
                    if (_e842 > 0.5f) {
                        phi_2354_ = 1f;
                    } else {
                        phi_2354_ = 0f;
                    }
                    let _e1009 = phi_2354_;
                    phi_2356_ = evaluate_Verdict(_e1009, false);
                }
                let _e1012 = phi_2356_;
                let _e1015 = (_e1012.visibility < 0.5f);
                if _e1012.is_doubted {
                    phi_2379_ = evaluate_Verdict();
                    phi_2380_ = true;
                } else {
                    if _e1015 {
                        phi_2366_ = 2u;
                    } else {
                        phi_2366_ = 1u;
                    }
                    let _e1017 = phi_2366_;
                    if ((((((_e953 >> bitcast<u32>((((_e862 % 16u) * 2u) & 31u))) & 3u) | ((_e961 >> bitcast<u32>((((_e888 % 16u) * 2u) & 31u))) & 3u)) | (((_e970 >> bitcast<u32>((((_e914 % 16u) * 2u) & 31u))) & 3u) | ((_e978 >> bitcast<u32>((((_e940 % 16u) * 2u) & 31u))) & 3u))) & _e1017) != 0u) {
                        if _e1015 {
                            phi_2375_ = 0.000000059604645f;
                        } else {
                            phi_2375_ = 0.99999994f;
                        }
                        let _e1021 = phi_2375_;
                        phi_2377_ = evaluate_Verdict(_e1021, true);
                        phi_2378_ = false;
                    } else {
                        phi_2377_ = evaluate_Verdict();
                        phi_2378_ = true;
                    }
                    let _e1024 = phi_2377_;
                    let _e1026 = phi_2378_;
                    phi_2379_ = _e1024;
                    phi_2380_ = _e1026;
                }
                let _e1028 = phi_2379_;
                let _e1030 = phi_2380_;
                if _e1030 {
                    phi_2385_ = evaluate_Verdict(_e1012.visibility, _e1012.is_doubted);
                } else {
                    phi_2385_ = _e1028;
                }
                let _e1033 = phi_2385_;
                phi_2390_ = evaluate_Verdict(_e1033.visibility, _e1033.is_doubted);
            } else {
                phi_2390_ = evaluate_Verdict(0.5f, true);
            }
            let _e1039 = phi_2390_;
            phi_2391_ = _e1039;
        }
        let _e1041 = phi_2391_;
        if (_e82.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e82.first_primitive)] = _e1041.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
