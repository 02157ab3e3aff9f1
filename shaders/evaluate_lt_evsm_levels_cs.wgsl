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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_38 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_38;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e66 = phi_163_;
        let _e68 = phi_164_;
        phi_165_ = _e66;
        phi_166_ = _e68;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e70 = phi_165_;
    let _e72 = phi_166_;
    if _e72 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e70;
    }
    let _e77 = phi_171_;
    return lt_bvh_traverse_Tree(_e77.root, _e77.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_351_: bool;
    var phi_355_: f32;
    var phi_374_: f32;
    var phi_379_: f32;
    var phi_401_: f32;
    var phi_406_: f32;
    var phi_407_: bool;
    var phi_408_: f32;
    var phi_409_: bool;
    var phi_413_: f32;
    var phi_451_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_489_: f32;
    var phi_494_: f32;
    var phi_495_: bool;
    var phi_496_: f32;
    var phi_497_: bool;
    var phi_501_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_555_: f32;
    var phi_577_: f32;
    var phi_582_: f32;
    var phi_583_: bool;
    var phi_584_: f32;
    var phi_585_: bool;
    var phi_589_: f32;
    var phi_627_: f32;
    var phi_638_: f32;
    var phi_643_: f32;
    var phi_665_: f32;
    var phi_670_: f32;
    var phi_671_: bool;
    var phi_672_: f32;
    var phi_673_: bool;
    var phi_677_: f32;
    var phi_715_: f32;
    var phi_768_: bool;
    var phi_772_: f32;
    var phi_784_: bool;
    var phi_791_: f32;
    var phi_804_: bool;
    var phi_808_: f32;
    var phi_828_: f32;
    var phi_833_: f32;
    var phi_855_: f32;
    var phi_860_: f32;
    var phi_861_: bool;
    var phi_862_: f32;
    var phi_863_: bool;
    var phi_867_: f32;
    var phi_905_: f32;
    var phi_916_: f32;
    var phi_921_: f32;
    var phi_943_: f32;
    var phi_948_: f32;
    var phi_949_: bool;
    var phi_950_: f32;
    var phi_951_: bool;
    var phi_955_: f32;
    var phi_993_: f32;
    var phi_1004_: f32;
    var phi_1009_: f32;
    var phi_1031_: f32;
    var phi_1036_: f32;
    var phi_1037_: bool;
    var phi_1038_: f32;
    var phi_1039_: bool;
    var phi_1043_: f32;
    var phi_1081_: f32;
    var phi_1092_: f32;
    var phi_1097_: f32;
    var phi_1119_: f32;
    var phi_1124_: f32;
    var phi_1125_: bool;
    var phi_1126_: f32;
    var phi_1127_: bool;
    var phi_1131_: f32;
    var phi_1169_: f32;
    var phi_1222_: bool;
    var phi_1226_: f32;
    var phi_1238_: bool;
    var phi_1245_: f32;
    var phi_1256_: bool;
    var phi_1260_: f32;
    var phi_1275_: f32;
    var phi_1276_: f32;
    var phi_1277_: f32;

    let _e57 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_351_ = true;
    } else {
        let _e61 = (42f < _e57);
        if _e61 {
        }
        phi_351_ = _e61;
    }
    let _e63 = phi_351_;
    if _e63 {
        phi_355_ = 42f;
    } else {
        phi_355_ = _e57;
    }
    let _e65 = phi_355_;
    let _e67 = (_e65 * param_5.x);
    let _e69 = (_e65 * param_5.y);
    let _e71 = (_e65 * param_5.z);
    let _e73 = (_e65 * param_5.w);
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_451_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_374_ = -87f;
        } else {
            phi_374_ = _e67;
        }
        let _e79 = phi_374_;
        if (_e79 > 88f) {
            phi_379_ = 88f;
        } else {
            phi_379_ = _e79;
        }
        let _e82 = phi_379_;
        let _e84 = ((_e82 * 1.442695f) + 0.5f);
        if (_e84 > -8388608f) {
            let _e96 = f32(select(0i, select(select(i32(_e84), i32(-2147483648), (_e84 < bitcast<f32>(3472883712u))), 2147483647i, (_e84 > bitcast<f32>(1325400063u))), (_e84 == _e84)));
            if (_e96 > _e84) {
                phi_401_ = 1f;
            } else {
                phi_401_ = 0f;
            }
            let _e99 = phi_401_;
            if (_e84 < 8388608f) {
                phi_406_ = (_e96 - _e99);
                phi_407_ = false;
            } else {
                phi_406_ = f32();
                phi_407_ = true;
            }
            let _e102 = phi_406_;
            let _e104 = phi_407_;
            phi_408_ = _e102;
            phi_409_ = _e104;
        } else {
            phi_408_ = f32();
            phi_409_ = true;
        }
        let _e106 = phi_408_;
        let _e108 = phi_409_;
        if _e108 {
            phi_413_ = _e84;
        } else {
            phi_413_ = _e106;
        }
        let _e110 = phi_413_;
        let _e114 = ((_e82 - (_e110 * 0.69314575f)) - (_e110 * 0.0000014286068f));
        phi_451_ = ((((((((((((((((1f / 5040f) * _e114) + (1f / 720f)) * _e114) + (1f / 120f)) * _e114) + (1f / 24f)) * _e114) + (1f / 6f)) * _e114) + 0.5f) * _e114) + 1f) * _e114) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e110), i32(-2147483648), (_e110 < bitcast<f32>(3472883712u))), 2147483647i, (_e110 > bitcast<f32>(1325400063u))), (_e110 == _e110)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e150 = phi_451_;
    if ((bitcast<u32>(_e69) & 2147483647u) > 2139095040u) {
        phi_539_ = _e69;
    } else {
        if (_e69 < -87f) {
            phi_462_ = -87f;
        } else {
            phi_462_ = _e69;
        }
        let _e156 = phi_462_;
        if (_e156 > 88f) {
            phi_467_ = 88f;
        } else {
            phi_467_ = _e156;
        }
        let _e159 = phi_467_;
        let _e161 = ((_e159 * 1.442695f) + 0.5f);
        if (_e161 > -8388608f) {
            let _e173 = f32(select(0i, select(select(i32(_e161), i32(-2147483648), (_e161 < bitcast<f32>(3472883712u))), 2147483647i, (_e161 > bitcast<f32>(1325400063u))), (_e161 == _e161)));
            if (_e173 > _e161) {
                phi_489_ = 1f;
            } else {
                phi_489_ = 0f;
            }
            let _e176 = phi_489_;
            if (_e161 < 8388608f) {
                phi_494_ = (_e173 - _e176);
                phi_495_ = false;
            } else {
                phi_494_ = f32();
                phi_495_ = true;
            }
            let _e179 = phi_494_;
            let _e181 = phi_495_;
            phi_496_ = _e179;
            phi_497_ = _e181;
        } else {
            phi_496_ = f32();
            phi_497_ = true;
        }
        let _e183 = phi_496_;
        let _e185 = phi_497_;
        if _e185 {
            phi_501_ = _e161;
        } else {
            phi_501_ = _e183;
        }
        let _e187 = phi_501_;
        let _e191 = ((_e159 - (_e187 * 0.69314575f)) - (_e187 * 0.0000014286068f));
        phi_539_ = ((((((((((((((((1f / 5040f) * _e191) + (1f / 720f)) * _e191) + (1f / 120f)) * _e191) + (1f / 24f)) * _e191) + (1f / 6f)) * _e191) + 0.5f) * _e191) + 1f) * _e191) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e187), i32(-2147483648), (_e187 < bitcast<f32>(3472883712u))), 2147483647i, (_e187 > bitcast<f32>(1325400063u))), (_e187 == _e187)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e227 = phi_539_;
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_627_ = _e71;
    } else {
        if (_e71 < -87f) {
            phi_550_ = -87f;
        } else {
            phi_550_ = _e71;
        }
        let _e233 = phi_550_;
        if (_e233 > 88f) {
            phi_555_ = 88f;
        } else {
            phi_555_ = _e233;
        }
        let _e236 = phi_555_;
        let _e238 = ((_e236 * 1.442695f) + 0.5f);
        if (_e238 > -8388608f) {
            let _e250 = f32(select(0i, select(select(i32(_e238), i32(-2147483648), (_e238 < bitcast<f32>(3472883712u))), 2147483647i, (_e238 > bitcast<f32>(1325400063u))), (_e238 == _e238)));
            if (_e250 > _e238) {
                phi_577_ = 1f;
            } else {
                phi_577_ = 0f;
            }
            let _e253 = phi_577_;
            if (_e238 < 8388608f) {
                phi_582_ = (_e250 - _e253);
                phi_583_ = false;
            } else {
                phi_582_ = f32();
                phi_583_ = true;
            }
            let _e256 = phi_582_;
            let _e258 = phi_583_;
            phi_584_ = _e256;
            phi_585_ = _e258;
        } else {
            phi_584_ = f32();
            phi_585_ = true;
        }
        let _e260 = phi_584_;
        let _e262 = phi_585_;
        if _e262 {
            phi_589_ = _e238;
        } else {
            phi_589_ = _e260;
        }
        let _e264 = phi_589_;
        let _e268 = ((_e236 - (_e264 * 0.69314575f)) - (_e264 * 0.0000014286068f));
        phi_627_ = ((((((((((((((((1f / 5040f) * _e268) + (1f / 720f)) * _e268) + (1f / 120f)) * _e268) + (1f / 24f)) * _e268) + (1f / 6f)) * _e268) + 0.5f) * _e268) + 1f) * _e268) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e264), i32(-2147483648), (_e264 < bitcast<f32>(3472883712u))), 2147483647i, (_e264 > bitcast<f32>(1325400063u))), (_e264 == _e264)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e304 = phi_627_;
    if ((bitcast<u32>(_e73) & 2147483647u) > 2139095040u) {
        phi_715_ = _e73;
    } else {
        if (_e73 < -87f) {
            phi_638_ = -87f;
        } else {
            phi_638_ = _e73;
        }
        let _e310 = phi_638_;
        if (_e310 > 88f) {
            phi_643_ = 88f;
        } else {
            phi_643_ = _e310;
        }
        let _e313 = phi_643_;
        let _e315 = ((_e313 * 1.442695f) + 0.5f);
        if (_e315 > -8388608f) {
            let _e327 = f32(select(0i, select(select(i32(_e315), i32(-2147483648), (_e315 < bitcast<f32>(3472883712u))), 2147483647i, (_e315 > bitcast<f32>(1325400063u))), (_e315 == _e315)));
            if (_e327 > _e315) {
                phi_665_ = 1f;
            } else {
                phi_665_ = 0f;
            }
            let _e330 = phi_665_;
            if (_e315 < 8388608f) {
                phi_670_ = (_e327 - _e330);
                phi_671_ = false;
            } else {
                phi_670_ = f32();
                phi_671_ = true;
            }
            let _e333 = phi_670_;
            let _e335 = phi_671_;
            phi_672_ = _e333;
            phi_673_ = _e335;
        } else {
            phi_672_ = f32();
            phi_673_ = true;
        }
        let _e337 = phi_672_;
        let _e339 = phi_673_;
        if _e339 {
            phi_677_ = _e315;
        } else {
            phi_677_ = _e337;
        }
        let _e341 = phi_677_;
        let _e345 = ((_e313 - (_e341 * 0.69314575f)) - (_e341 * 0.0000014286068f));
        phi_715_ = ((((((((((((((((1f / 5040f) * _e345) + (1f / 720f)) * _e345) + (1f / 120f)) * _e345) + (1f / 24f)) * _e345) + (1f / 6f)) * _e345) + 0.5f) * _e345) + 1f) * _e345) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e341), i32(-2147483648), (_e341 < bitcast<f32>(3472883712u))), 2147483647i, (_e341 > bitcast<f32>(1325400063u))), (_e341 == _e341)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e381 = phi_715_;
    let _e383 = (_e150 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e385 = (_e227 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e387 = (_e304 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e389 = (_e381 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e391 = (*param_4).min_variance;
    let _e393 = ((_e391 * _e65) * _e65);
    let _e404 = ((((_e383 * param_6.x) + (_e385 * param_6.y)) + (_e387 * param_6.z)) + (_e389 * param_6.w));
    let _e405 = (_e383 - _e404);
    let _e406 = (_e385 - _e404);
    let _e407 = (_e387 - _e404);
    let _e408 = (_e389 - _e404);
    let _e423 = (((((_e405 * _e405) * param_6.x) + ((_e406 * _e406) * param_6.y)) + ((_e407 * _e407) * param_6.z)) + ((_e408 * _e408) * param_6.w));
    if ((bitcast<u32>(_e393) & 2147483647u) > 2139095040u) {
        phi_768_ = true;
    } else {
        let _e427 = (_e393 > _e423);
        if _e427 {
        }
        phi_768_ = _e427;
    }
    let _e429 = phi_768_;
    if _e429 {
        phi_772_ = _e393;
    } else {
        phi_772_ = _e423;
    }
    let _e431 = phi_772_;
    let _e432 = -(_e404);
    if (_e432 <= 0f) {
        let _e436 = ((bitcast<u32>(_e431) & 2147483647u) > 2139095040u);
        if _e436 {
        }
        phi_784_ = _e436;
    } else {
        phi_784_ = true;
    }
    let _e438 = phi_784_;
    if _e438 {
        phi_791_ = (_e431 / (_e431 + (_e432 * _e432)));
    } else {
        phi_791_ = 1f;
    }
    let _e443 = phi_791_;
    let _e445 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_804_ = true;
    } else {
        let _e449 = (42f < _e445);
        if _e449 {
        }
        phi_804_ = _e449;
    }
    let _e451 = phi_804_;
    if _e451 {
        phi_808_ = 42f;
    } else {
        phi_808_ = _e445;
    }
    let _e453 = phi_808_;
    let _e454 = -(_e453);
    let _e456 = (_e454 * param_5.x);
    let _e458 = (_e454 * param_5.y);
    let _e460 = (_e454 * param_5.z);
    let _e462 = (_e454 * param_5.w);
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_905_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_828_ = -87f;
        } else {
            phi_828_ = _e456;
        }
        let _e468 = phi_828_;
        if (_e468 > 88f) {
            phi_833_ = 88f;
        } else {
            phi_833_ = _e468;
        }
        let _e471 = phi_833_;
        let _e473 = ((_e471 * 1.442695f) + 0.5f);
        if (_e473 > -8388608f) {
            let _e485 = f32(select(0i, select(select(i32(_e473), i32(-2147483648), (_e473 < bitcast<f32>(3472883712u))), 2147483647i, (_e473 > bitcast<f32>(1325400063u))), (_e473 == _e473)));
            if (_e485 > _e473) {
                phi_855_ = 1f;
            } else {
                phi_855_ = 0f;
            }
            let _e488 = phi_855_;
            if (_e473 < 8388608f) {
                phi_860_ = (_e485 - _e488);
                phi_861_ = false;
            } else {
                phi_860_ = f32();
                phi_861_ = true;
            }
            let _e491 = phi_860_;
            let _e493 = phi_861_;
            phi_862_ = _e491;
            phi_863_ = _e493;
        } else {
            phi_862_ = f32();
            phi_863_ = true;
        }
        let _e495 = phi_862_;
        let _e497 = phi_863_;
        if _e497 {
            phi_867_ = _e473;
        } else {
            phi_867_ = _e495;
        }
        let _e499 = phi_867_;
        let _e503 = ((_e471 - (_e499 * 0.69314575f)) - (_e499 * 0.0000014286068f));
        phi_905_ = ((((((((((((((((1f / 5040f) * _e503) + (1f / 720f)) * _e503) + (1f / 120f)) * _e503) + (1f / 24f)) * _e503) + (1f / 6f)) * _e503) + 0.5f) * _e503) + 1f) * _e503) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e499), i32(-2147483648), (_e499 < bitcast<f32>(3472883712u))), 2147483647i, (_e499 > bitcast<f32>(1325400063u))), (_e499 == _e499)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e539 = phi_905_;
    if ((bitcast<u32>(_e458) & 2147483647u) > 2139095040u) {
        phi_993_ = _e458;
    } else {
        if (_e458 < -87f) {
            phi_916_ = -87f;
        } else {
            phi_916_ = _e458;
        }
        let _e545 = phi_916_;
        if (_e545 > 88f) {
            phi_921_ = 88f;
        } else {
            phi_921_ = _e545;
        }
        let _e548 = phi_921_;
        let _e550 = ((_e548 * 1.442695f) + 0.5f);
        if (_e550 > -8388608f) {
            let _e562 = f32(select(0i, select(select(i32(_e550), i32(-2147483648), (_e550 < bitcast<f32>(3472883712u))), 2147483647i, (_e550 > bitcast<f32>(1325400063u))), (_e550 == _e550)));
            if (_e562 > _e550) {
                phi_943_ = 1f;
            } else {
                phi_943_ = 0f;
            }
            let _e565 = phi_943_;
            if (_e550 < 8388608f) {
                phi_948_ = (_e562 - _e565);
                phi_949_ = false;
            } else {
                phi_948_ = f32();
                phi_949_ = true;
            }
            let _e568 = phi_948_;
            let _e570 = phi_949_;
            phi_950_ = _e568;
            phi_951_ = _e570;
        } else {
            phi_950_ = f32();
            phi_951_ = true;
        }
        let _e572 = phi_950_;
        let _e574 = phi_951_;
        if _e574 {
            phi_955_ = _e550;
        } else {
            phi_955_ = _e572;
        }
        let _e576 = phi_955_;
        let _e580 = ((_e548 - (_e576 * 0.69314575f)) - (_e576 * 0.0000014286068f));
        phi_993_ = ((((((((((((((((1f / 5040f) * _e580) + (1f / 720f)) * _e580) + (1f / 120f)) * _e580) + (1f / 24f)) * _e580) + (1f / 6f)) * _e580) + 0.5f) * _e580) + 1f) * _e580) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e576), i32(-2147483648), (_e576 < bitcast<f32>(3472883712u))), 2147483647i, (_e576 > bitcast<f32>(1325400063u))), (_e576 == _e576)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e616 = phi_993_;
    if ((bitcast<u32>(_e460) & 2147483647u) > 2139095040u) {
        phi_1081_ = _e460;
    } else {
        if (_e460 < -87f) {
            phi_1004_ = -87f;
        } else {
            phi_1004_ = _e460;
        }
        let _e622 = phi_1004_;
        if (_e622 > 88f) {
            phi_1009_ = 88f;
        } else {
            phi_1009_ = _e622;
        }
        let _e625 = phi_1009_;
        let _e627 = ((_e625 * 1.442695f) + 0.5f);
        if (_e627 > -8388608f) {
            let _e639 = f32(select(0i, select(select(i32(_e627), i32(-2147483648), (_e627 < bitcast<f32>(3472883712u))), 2147483647i, (_e627 > bitcast<f32>(1325400063u))), (_e627 == _e627)));
            if (_e639 > _e627) {
                phi_1031_ = 1f;
            } else {
                phi_1031_ = 0f;
            }
            let _e642 = phi_1031_;
            if (_e627 < 8388608f) {
                phi_1036_ = (_e639 - _e642);
                phi_1037_ = false;
            } else {
                phi_1036_ = f32();
                phi_1037_ = true;
            }
            let _e645 = phi_1036_;
            let _e647 = phi_1037_;
            phi_1038_ = _e645;
            phi_1039_ = _e647;
        } else {
            phi_1038_ = f32();
            phi_1039_ = true;
        }
        let _e649 = phi_1038_;
        let _e651 = phi_1039_;
        if _e651 {
            phi_1043_ = _e627;
        } else {
            phi_1043_ = _e649;
        }
        let _e653 = phi_1043_;
        let _e657 = ((_e625 - (_e653 * 0.69314575f)) - (_e653 * 0.0000014286068f));
        phi_1081_ = ((((((((((((((((1f / 5040f) * _e657) + (1f / 720f)) * _e657) + (1f / 120f)) * _e657) + (1f / 24f)) * _e657) + (1f / 6f)) * _e657) + 0.5f) * _e657) + 1f) * _e657) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e653), i32(-2147483648), (_e653 < bitcast<f32>(3472883712u))), 2147483647i, (_e653 > bitcast<f32>(1325400063u))), (_e653 == _e653)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e693 = phi_1081_;
    if ((bitcast<u32>(_e462) & 2147483647u) > 2139095040u) {
        phi_1169_ = _e462;
    } else {
        if (_e462 < -87f) {
            phi_1092_ = -87f;
        } else {
            phi_1092_ = _e462;
        }
        let _e699 = phi_1092_;
        if (_e699 > 88f) {
            phi_1097_ = 88f;
        } else {
            phi_1097_ = _e699;
        }
        let _e702 = phi_1097_;
        let _e704 = ((_e702 * 1.442695f) + 0.5f);
        if (_e704 > -8388608f) {
            let _e716 = f32(select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704)));
            if (_e716 > _e704) {
                phi_1119_ = 1f;
            } else {
                phi_1119_ = 0f;
            }
            let _e719 = phi_1119_;
            if (_e704 < 8388608f) {
                phi_1124_ = (_e716 - _e719);
                phi_1125_ = false;
            } else {
                phi_1124_ = f32();
                phi_1125_ = true;
            }
            let _e722 = phi_1124_;
            let _e724 = phi_1125_;
            phi_1126_ = _e722;
            phi_1127_ = _e724;
        } else {
            phi_1126_ = f32();
            phi_1127_ = true;
        }
        let _e726 = phi_1126_;
        let _e728 = phi_1127_;
        if _e728 {
            phi_1131_ = _e704;
        } else {
            phi_1131_ = _e726;
        }
        let _e730 = phi_1131_;
        let _e734 = ((_e702 - (_e730 * 0.69314575f)) - (_e730 * 0.0000014286068f));
        phi_1169_ = ((((((((((((((((1f / 5040f) * _e734) + (1f / 720f)) * _e734) + (1f / 120f)) * _e734) + (1f / 24f)) * _e734) + (1f / 6f)) * _e734) + 0.5f) * _e734) + 1f) * _e734) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e770 = phi_1169_;
    let _e772 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e539);
    let _e774 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e616);
    let _e776 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e693);
    let _e778 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e770);
    let _e780 = (*param_4).min_variance;
    let _e782 = ((_e780 * _e453) * _e453);
    let _e793 = ((((_e772 * param_6.x) + (_e774 * param_6.y)) + (_e776 * param_6.z)) + (_e778 * param_6.w));
    let _e794 = (_e772 - _e793);
    let _e795 = (_e774 - _e793);
    let _e796 = (_e776 - _e793);
    let _e797 = (_e778 - _e793);
    let _e812 = (((((_e794 * _e794) * param_6.x) + ((_e795 * _e795) * param_6.y)) + ((_e796 * _e796) * param_6.z)) + ((_e797 * _e797) * param_6.w));
    if ((bitcast<u32>(_e782) & 2147483647u) > 2139095040u) {
        phi_1222_ = true;
    } else {
        let _e816 = (_e782 > _e812);
        if _e816 {
        }
        phi_1222_ = _e816;
    }
    let _e818 = phi_1222_;
    if _e818 {
        phi_1226_ = _e782;
    } else {
        phi_1226_ = _e812;
    }
    let _e820 = phi_1226_;
    let _e821 = -(_e793);
    if (_e821 <= 0f) {
        let _e825 = ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u);
        if _e825 {
        }
        phi_1238_ = _e825;
    } else {
        phi_1238_ = true;
    }
    let _e827 = phi_1238_;
    if _e827 {
        phi_1245_ = (_e820 / (_e820 + (_e821 * _e821)));
    } else {
        phi_1245_ = 1f;
    }
    let _e832 = phi_1245_;
    if ((bitcast<u32>(_e832) & 2147483647u) > 2139095040u) {
        phi_1256_ = true;
    } else {
        let _e836 = (_e832 < _e443);
        if _e836 {
        }
        phi_1256_ = _e836;
    }
    let _e838 = phi_1256_;
    if _e838 {
        phi_1260_ = _e832;
    } else {
        phi_1260_ = _e443;
    }
    let _e840 = phi_1260_;
    if ((bitcast<u32>(_e840) & 2147483647u) > 2139095040u) {
        phi_1277_ = _e840;
    } else {
        if (_e840 < 0f) {
            phi_1276_ = 0f;
        } else {
            if (_e840 > 1f) {
                phi_1275_ = 1f;
            } else {
                phi_1275_ = _e840;
            }
            let _e847 = phi_1275_;
            phi_1276_ = _e847;
        }
        let _e849 = phi_1276_;
        phi_1277_ = _e849;
    }
    let _e851 = phi_1277_;
    return _e851;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
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
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_325_: bool;
    var phi_329_: bool;
    var phi_334_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_202_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_10;
            }
            let _e63 = phi_200_;
            phi_201_ = _e63;
        }
        let _e65 = phi_201_;
        phi_202_ = _e65;
    }
    let _e67 = phi_202_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_220_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_8.x;
            }
            let _e75 = phi_218_;
            phi_219_ = _e75;
        }
        let _e77 = phi_219_;
        phi_220_ = _e77;
    }
    let _e79 = phi_220_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_238_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_8.y;
            }
            let _e87 = phi_236_;
            phi_237_ = _e87;
        }
        let _e89 = phi_237_;
        phi_238_ = _e89;
    }
    let _e91 = phi_238_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_256_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_8.z;
            }
            let _e99 = phi_254_;
            phi_255_ = _e99;
        }
        let _e101 = phi_255_;
        phi_256_ = _e101;
    }
    let _e103 = phi_256_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_274_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_273_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_272_ = 1f;
            } else {
                phi_272_ = param_8.w;
            }
            let _e111 = phi_272_;
            phi_273_ = _e111;
        }
        let _e113 = phi_273_;
        phi_274_ = _e113;
    }
    let _e115 = phi_274_;
    let _e116 = (_e79 - _e67);
    let _e117 = (_e91 - _e67);
    let _e118 = (_e103 - _e67);
    let _e119 = (_e115 - _e67);
    if (_e116 >= 0f) {
        if (_e117 >= 0f) {
            if (_e118 >= 0f) {
                if (_e119 >= 0f) {
                    phi_311_ = !(((bitcast<u32>(((((_e116 * param_9.x) + (_e117 * param_9.y)) + (_e118 * param_9.z)) + (_e119 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_312_ = false;
                } else {
                    phi_311_ = bool();
                    phi_312_ = true;
                }
                let _e141 = phi_311_;
                let _e143 = phi_312_;
                phi_313_ = _e141;
                phi_314_ = false;
                phi_315_ = _e143;
            } else {
                phi_313_ = bool();
                phi_314_ = true;
                phi_315_ = false;
            }
            let _e145 = phi_313_;
            let _e147 = phi_314_;
            let _e149 = phi_315_;
            phi_316_ = _e145;
            phi_317_ = _e147;
            phi_318_ = _e149;
        } else {
            phi_316_ = bool();
            phi_317_ = true;
            phi_318_ = false;
        }
        let _e151 = phi_316_;
        let _e153 = phi_317_;
        let _e155 = phi_318_;
        phi_319_ = _e151;
        phi_320_ = _e153;
        phi_321_ = _e155;
    } else {
        phi_319_ = bool();
        phi_320_ = true;
        phi_321_ = false;
    }
    let _e157 = phi_319_;
    let _e159 = phi_320_;
    let _e161 = phi_321_;
    if _e159 {
        phi_325_ = true;
    } else {
        phi_325_ = _e161;
    }
    let _e163 = phi_325_;
    if _e163 {
        phi_329_ = false;
    } else {
        phi_329_ = _e157;
    }
    let _e165 = phi_329_;
    if _e165 {
        phi_334_ = 1f;
    } else {
        let _e166 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e116, _e117, _e118, _e119), param_9);
        phi_334_ = _e166;
    }
    let _e168 = phi_334_;
    return _e168;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1340_: bool;
    var phi_1344_: bool;
    var phi_1414_: bool;
    var phi_1415_: bool;
    var phi_1426_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1427_: bool;
    var phi_1428_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1429_: bool;
    var phi_1436_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1440_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1460_: lt_math_LightPoint;
    var phi_1463_: u32;
    var phi_1465_: lt_math_LevelPoint;
    var phi_1551_: bool;
    var phi_1560_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1579_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1617_: bool;
    var phi_1626_: lt_math_LightPoint;
    var phi_1627_: u32;
    var phi_1628_: lt_math_LevelPoint;
    var phi_1629_: bool;
    var phi_1461_: lt_math_LightPoint;
    var phi_1464_: u32;
    var phi_1466_: lt_math_LevelPoint;
    var phi_1630_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1670_: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1673_: bool;
    var phi_1677_: bool;
    var phi_1759_: f32;
    var phi_1877_: f32;
    var phi_1878_: f32;
    var phi_1881_: f32;
    var phi_1910_: f32;
    var phi_1915_: f32;
    var phi_1916_: bool;
    var phi_1917_: f32;
    var phi_1918_: bool;
    var phi_1922_: f32;
    var phi_1942_: f32;
    var phi_1947_: f32;
    var phi_1948_: bool;
    var phi_1949_: f32;
    var phi_1950_: bool;
    var phi_1954_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_2007_: i32;
    var phi_2012_: i32;
    var phi_2017_: i32;
    var phi_2022_: i32;
    var phi_2031_: i32;
    var phi_2036_: i32;
    var phi_2041_: i32;
    var phi_2046_: i32;
    var phi_2097_: bool;
    var phi_2105_: bool;
    var phi_2117_: bool;
    var phi_2118_: bool;
    var phi_2122_: f32;
    var phi_2128_: f32;
    var phi_2130_: evaluate_Verdict;
    var phi_2135_: evaluate_Verdict;
    var phi_2136_: evaluate_Verdict;

    let _e54 = id_1;
    let _e61 = arrayLength((&map.member));
    let _e67 = arrayLength((&levels.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        let _e79 = p.member.level_count;
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e86 = samples.member[(0u + _e73.first_primitive)].normal[0u];
        let _e88 = global[0u];
        if (_e86 == _e88) {
            let _e91 = samples.member[(0u + _e73.first_primitive)].normal[1u];
            let _e93 = global[1u];
            if (_e91 == _e93) {
                let _e96 = samples.member[(0u + _e73.first_primitive)].normal[2u];
                let _e98 = global[2u];
                phi_1337_ = (_e96 == _e98);
                phi_1338_ = false;
            } else {
                phi_1337_ = bool();
                phi_1338_ = true;
            }
            let _e101 = phi_1337_;
            let _e103 = phi_1338_;
            phi_1339_ = _e101;
            phi_1340_ = _e103;
        } else {
            phi_1339_ = bool();
            phi_1340_ = true;
        }
        let _e105 = phi_1339_;
        let _e107 = phi_1340_;
        if _e107 {
            phi_1344_ = false;
        } else {
            phi_1344_ = _e105;
        }
        let _e109 = phi_1344_;
        if !(_e109) {
            let _e112 = samples.member[(0u + _e73.first_primitive)].position;
            let _e114 = p.member.light.place;
            let _e120 = p.member.light.place[3u];
            let _e127 = (_e114.x - (_e112.x * _e120));
            let _e128 = (_e114.y - (_e112.y * _e120));
            let _e129 = (_e114.z - (_e112.z * _e120));
            let _e131 = samples.member[(0u + _e73.first_primitive)].normal;
            if ((((_e131.x * _e127) + (_e131.y * _e128)) + (_e131.z * _e129)) > 0f) {
                let _e145 = (((_e127 * _e127) + (_e128 * _e128)) + (_e129 * _e129));
                let _e147 = p.member.light.axis;
                let _e159 = p.member.light.place[3u];
                if (_e159 == 0f) {
                    phi_1415_ = true;
                } else {
                    let _e162 = p.member.light.range_squared;
                    if (_e145 <= _e162) {
                        let _e165 = p.member.light.cos_outer;
                        phi_1414_ = (-((((_e127 * _e147.x) + (_e128 * _e147.y)) + (_e129 * _e147.z))) >= (_e165 * sqrt(_e145)));
                    } else {
                        phi_1414_ = false;
                    }
                    let _e170 = phi_1414_;
                    phi_1415_ = _e170;
                }
                let _e172 = phi_1415_;
                if _e172 {
                    let _e174 = samples.member[(0u + _e73.first_primitive)].flags;
                    let _e182 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e188 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e182.unnamed.visibility, false), _e182.unnamed_1);
                    phi_1426_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e188.unnamed, ((_e174 & 1u) == 0u));
                    phi_1427_ = false;
                } else {
                    phi_1426_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1427_ = true;
                }
                let _e193 = phi_1426_;
                let _e195 = phi_1427_;
                phi_1428_ = _e193;
                phi_1429_ = _e195;
            } else {
                phi_1428_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1429_ = true;
            }
            let _e197 = phi_1428_;
            let _e199 = phi_1429_;
            if _e199 {
                let _e205 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e211 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e205.unnamed.visibility, false), _e205.unnamed_1);
                phi_1436_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e211.unnamed, true);
            } else {
                phi_1436_ = _e197;
            }
            let _e216 = phi_1436_;
            phi_1440_ = _e216;
        } else {
            let _e222 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e228 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e222.unnamed.visibility, false), _e222.unnamed_1);
            phi_1440_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e228.unnamed, true);
        }
        let _e233 = phi_1440_;
        if _e233.unnamed_1 {
            phi_2136_ = evaluate_Verdict(_e233.unnamed.visibility, _e233.unnamed.is_doubted);
        } else {
            let _e241 = samples.member[(0u + _e73.first_primitive)].position;
            let _e243 = p.member.map_size;
            let _e245 = (0.5f / f32(_e243));
            let _e252 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e259 = lt_math_LightPoint(vec2<f32>(_e252.uv.x, 0f), _e252.depth, _e252.is_inside);
            let _e263 = lt_math_LightPoint(_e259.uv, 0f, _e259.is_inside);
            phi_1460_ = lt_math_LightPoint();
            phi_1463_ = 0u;
            phi_1465_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e263.uv, _e263.depth, false));
            loop {
                let _e270 = phi_1460_;
                let _e272 = phi_1463_;
                let _e274 = phi_1465_;
                local_1 = _e274;
                local_2 = _e274;
                local_3 = _e274;
                if (_e272 < _e79) {
                    if _e274.point.is_inside {
                        phi_1626_ = lt_math_LightPoint();
                        phi_1627_ = u32();
                        phi_1628_ = lt_math_LevelPoint();
                        phi_1629_ = false;
                    } else {
                        if (_e272 < _e67) {
                        } else {
                            return;
                        }
                        let _e285 = levels.member[(0u + _e272)].row_w;
                        let _e296 = ((((_e285.x * _e241.x) + (_e285.y * _e241.y)) + (_e285.z * _e241.z)) + (_e285.w * 1f));
                        let _e298 = levels.member[(0u + _e272)].row_x;
                        let _e310 = (((((_e298.x * _e241.x) + (_e298.y * _e241.y)) + (_e298.z * _e241.z)) + (_e298.w * 1f)) / _e296);
                        let _e312 = levels.member[(0u + _e272)].row_y;
                        let _e324 = (((((_e312.x * _e241.x) + (_e312.y * _e241.y)) + (_e312.z * _e241.z)) + (_e312.w * 1f)) / _e296);
                        let _e326 = levels.member[(0u + _e272)].row_z;
                        let _e337 = ((((_e326.x * _e241.x) + (_e326.y * _e241.y)) + (_e326.z * _e241.z)) + (_e326.w * 1f));
                        if (_e296 > 0f) {
                            if (_e310 >= 0f) {
                                phi_1551_ = (_e310 <= 1f);
                            } else {
                                phi_1551_ = false;
                            }
                            let _e342 = phi_1551_;
                            if _e342 {
                                if (_e324 >= 0f) {
                                    phi_1560_ = (_e324 <= 1f);
                                } else {
                                    phi_1560_ = false;
                                }
                                let _e346 = phi_1560_;
                                if _e346 {
                                    if (_e337 >= 0f) {
                                        phi_1569_ = (_e337 <= 1f);
                                    } else {
                                        phi_1569_ = false;
                                    }
                                    let _e350 = phi_1569_;
                                    phi_1570_ = _e350;
                                    phi_1571_ = false;
                                } else {
                                    phi_1570_ = bool();
                                    phi_1571_ = true;
                                }
                                let _e352 = phi_1570_;
                                let _e354 = phi_1571_;
                                phi_1572_ = _e352;
                                phi_1573_ = _e354;
                            } else {
                                phi_1572_ = bool();
                                phi_1573_ = true;
                            }
                            let _e356 = phi_1572_;
                            let _e358 = phi_1573_;
                            phi_1574_ = _e356;
                            phi_1575_ = _e358;
                        } else {
                            phi_1574_ = bool();
                            phi_1575_ = true;
                        }
                        let _e360 = phi_1574_;
                        let _e362 = phi_1575_;
                        if _e362 {
                            phi_1579_ = false;
                        } else {
                            phi_1579_ = _e360;
                        }
                        let _e364 = phi_1579_;
                        if _e364 {
                            if (_e310 >= _e245) {
                                if (_e310 <= (1f - _e245)) {
                                    if (_e324 >= _e245) {
                                        phi_1606_ = (_e324 <= (1f - _e245));
                                        phi_1607_ = false;
                                    } else {
                                        phi_1606_ = bool();
                                        phi_1607_ = true;
                                    }
                                    let _e372 = phi_1606_;
                                    let _e374 = phi_1607_;
                                    phi_1608_ = _e372;
                                    phi_1609_ = _e374;
                                } else {
                                    phi_1608_ = bool();
                                    phi_1609_ = true;
                                }
                                let _e376 = phi_1608_;
                                let _e378 = phi_1609_;
                                phi_1610_ = _e376;
                                phi_1611_ = _e378;
                            } else {
                                phi_1610_ = bool();
                                phi_1611_ = true;
                            }
                            let _e380 = phi_1610_;
                            let _e382 = phi_1611_;
                            phi_1612_ = _e380;
                            phi_1613_ = _e382;
                        } else {
                            phi_1612_ = bool();
                            phi_1613_ = true;
                        }
                        let _e384 = phi_1612_;
                        let _e386 = phi_1613_;
                        if _e386 {
                            phi_1617_ = false;
                        } else {
                            phi_1617_ = _e384;
                        }
                        let _e388 = phi_1617_;
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e310, _e270.uv.y), _e270.depth, _e270.is_inside);
                        let _e402 = lt_math_LightPoint(vec2<f32>(_e395.uv.x, _e324), _e395.depth, _e395.is_inside);
                        let _e406 = lt_math_LightPoint(_e402.uv, _e337, _e402.is_inside);
                        let _e410 = lt_math_LightPoint(_e406.uv, _e406.depth, _e388);
                        phi_1626_ = _e410;
                        phi_1627_ = (_e272 + 1u);
                        phi_1628_ = lt_math_LevelPoint(_e272, _e410);
                        phi_1629_ = true;
                    }
                    let _e414 = phi_1626_;
                    let _e416 = phi_1627_;
                    let _e418 = phi_1628_;
                    let _e420 = phi_1629_;
                    phi_1461_ = _e414;
                    phi_1464_ = _e416;
                    phi_1466_ = _e418;
                    phi_1630_ = _e420;
                } else {
                    phi_1461_ = lt_math_LightPoint();
                    phi_1464_ = u32();
                    phi_1466_ = lt_math_LevelPoint();
                    phi_1630_ = false;
                }
                let _e422 = phi_1461_;
                let _e424 = phi_1464_;
                let _e426 = phi_1466_;
                let _e428 = phi_1630_;
                continue;
                continuing {
                    phi_1460_ = _e422;
                    phi_1463_ = _e424;
                    phi_1465_ = _e426;
                    break if !(_e428);
                }
            }
            let _e431 = local_1;
            if _e431.point.is_inside {
                if (0f > 0f) {
                    let _e437 = local_2;
                    if (_e437.level < _e67) {
                    } else {
                        return;
                    }
                    let _e442 = levels.member[(0u + _e437.level)];
                    let _e448 = global[0u];
                    if (_e442.row_w.x == _e448) {
                        let _e451 = global[1u];
                        if (_e442.row_w.y == _e451) {
                            let _e454 = global[2u];
                            phi_1670_ = (_e442.row_w.z == _e454);
                            phi_1671_ = false;
                        } else {
                            phi_1670_ = bool();
                            phi_1671_ = true;
                        }
                        let _e457 = phi_1670_;
                        let _e459 = phi_1671_;
                        phi_1672_ = _e457;
                        phi_1673_ = _e459;
                    } else {
                        phi_1672_ = bool();
                        phi_1673_ = true;
                    }
                    let _e461 = phi_1672_;
                    let _e463 = phi_1673_;
                    if _e463 {
                        phi_1677_ = false;
                    } else {
                        phi_1677_ = _e461;
                    }
                    let _e465 = phi_1677_;
                    if _e465 {
                        let _e467 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e469 = p.member.map_size;
                        let _e539 = ((abs(((((_e442.row_x.x * _e467.x) + (_e442.row_x.y * _e467.y)) + (_e442.row_x.z * _e467.z)) / (((_e442.row_x.x * _e442.row_x.x) + (_e442.row_x.y * _e442.row_x.y)) + (_e442.row_x.z * _e442.row_x.z)))) + abs(((((_e442.row_y.x * _e467.x) + (_e442.row_y.y * _e467.y)) + (_e442.row_y.z * _e467.z)) / (((_e442.row_y.x * _e442.row_y.x) + (_e442.row_y.y * _e442.row_y.y)) + (_e442.row_y.z * _e442.row_y.z))))) / (abs(((((_e442.row_z.x * _e467.x) + (_e442.row_z.y * _e467.y)) + (_e442.row_z.z * _e467.z)) / (((_e442.row_z.x * _e442.row_z.x) + (_e442.row_z.y * _e442.row_z.y)) + (_e442.row_z.z * _e442.row_z.z)))) * f32(_e469)));
                        if (_e539 < 0.002f) {
                            phi_1759_ = _e539;
                        } else {
                            phi_1759_ = 0.002f;
                        }
                        let _e542 = phi_1759_;
                        phi_1878_ = _e542;
                    } else {
                        let _e544 = p.member.map_size;
                        let _e550 = samples.member[(0u + _e73.first_primitive)].position;
                        let _e561 = ((((_e442.row_w.x * _e550.x) + (_e442.row_w.y * _e550.y)) + (_e442.row_w.z * _e550.z)) + _e442.row_w.w);
                        let _e574 = ((_e442.row_x.x - (_e442.row_w.x * _e431.point.uv.x)) / _e561);
                        let _e575 = ((_e442.row_x.y - (_e442.row_w.y * _e431.point.uv.x)) / _e561);
                        let _e576 = ((_e442.row_x.z - (_e442.row_w.z * _e431.point.uv.x)) / _e561);
                        let _e589 = ((_e442.row_y.x - (_e442.row_w.x * _e431.point.uv.y)) / _e561);
                        let _e590 = ((_e442.row_y.y - (_e442.row_w.y * _e431.point.uv.y)) / _e561);
                        let _e591 = ((_e442.row_y.z - (_e442.row_w.z * _e431.point.uv.y)) / _e561);
                        let _e597 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e602 = ((_e590 * _e597.z) - (_e597.y * _e591));
                        let _e607 = ((_e591 * _e597.x) - (_e597.z * _e589));
                        let _e612 = ((_e589 * _e597.y) - (_e597.x * _e590));
                        let _e614 = samples.member[(0u + _e73.first_primitive)].normal;
                        let _e619 = ((_e575 * _e614.z) - (_e614.y * _e576));
                        let _e624 = ((_e576 * _e614.x) - (_e614.z * _e574));
                        let _e629 = ((_e574 * _e614.y) - (_e614.x * _e575));
                        let _e656 = ((abs(((((_e442.row_z.x * _e602) + (_e442.row_z.y * _e607)) + (_e442.row_z.z * _e612)) / (((_e574 * _e602) + (_e575 * _e607)) + (_e576 * _e612)))) + abs(((((_e442.row_z.x * _e619) + (_e442.row_z.y * _e624)) + (_e442.row_z.z * _e629)) / (((_e589 * _e619) + (_e590 * _e624)) + (_e591 * _e629))))) / f32(_e544));
                        let _e658 = (16f / f32(_e544));
                        if (_e656 < _e658) {
                            phi_1877_ = _e656;
                        } else {
                            phi_1877_ = _e658;
                        }
                        let _e661 = phi_1877_;
                        phi_1878_ = _e661;
                    }
                    let _e663 = phi_1878_;
                    phi_1881_ = (_e431.point.depth - (0f * _e663));
                } else {
                    phi_1881_ = _e431.point.depth;
                }
                let _e667 = phi_1881_;
                let _e673 = p.member.map_size;
                let _e674 = f32(_e673);
                let _e677 = ((_e431.point.uv.x * _e674) - 0.5f);
                let _e678 = ((_e431.point.uv.y * _e674) - 0.5f);
                if (_e677 > -8388608f) {
                    let _e690 = f32(select(0i, select(select(i32(_e677), i32(-2147483648), (_e677 < bitcast<f32>(3472883712u))), 2147483647i, (_e677 > bitcast<f32>(1325400063u))), (_e677 == _e677)));
                    if (_e690 > _e677) {
                        phi_1910_ = 1f;
                    } else {
                        phi_1910_ = 0f;
                    }
                    let _e693 = phi_1910_;
                    if (_e677 < 8388608f) {
                        phi_1915_ = (_e690 - _e693);
                        phi_1916_ = false;
                    } else {
                        phi_1915_ = f32();
                        phi_1916_ = true;
                    }
                    let _e696 = phi_1915_;
                    let _e698 = phi_1916_;
                    phi_1917_ = _e696;
                    phi_1918_ = _e698;
                } else {
                    phi_1917_ = f32();
                    phi_1918_ = true;
                }
                let _e700 = phi_1917_;
                let _e702 = phi_1918_;
                if _e702 {
                    phi_1922_ = _e677;
                } else {
                    phi_1922_ = _e700;
                }
                let _e704 = phi_1922_;
                if (_e678 > -8388608f) {
                    let _e716 = f32(select(0i, select(select(i32(_e678), i32(-2147483648), (_e678 < bitcast<f32>(3472883712u))), 2147483647i, (_e678 > bitcast<f32>(1325400063u))), (_e678 == _e678)));
                    if (_e716 > _e678) {
                        phi_1942_ = 1f;
                    } else {
                        phi_1942_ = 0f;
                    }
                    let _e719 = phi_1942_;
                    if (_e678 < 8388608f) {
                        phi_1947_ = (_e716 - _e719);
                        phi_1948_ = false;
                    } else {
                        phi_1947_ = f32();
                        phi_1948_ = true;
                    }
                    let _e722 = phi_1947_;
                    let _e724 = phi_1948_;
                    phi_1949_ = _e722;
                    phi_1950_ = _e724;
                } else {
                    phi_1949_ = f32();
                    phi_1950_ = true;
                }
                let _e726 = phi_1949_;
                let _e728 = phi_1950_;
                if _e728 {
                    phi_1954_ = _e678;
                } else {
                    phi_1954_ = _e726;
                }
                let _e730 = phi_1954_;
                let _e731 = (_e677 - _e704);
                let _e732 = (_e678 - _e730);
                let _e741 = select(0i, select(select(i32(_e704), i32(-2147483648), (_e704 < bitcast<f32>(3472883712u))), 2147483647i, (_e704 > bitcast<f32>(1325400063u))), (_e704 == _e704));
                let _e750 = select(0i, select(select(i32(_e730), i32(-2147483648), (_e730 < bitcast<f32>(3472883712u))), 2147483647i, (_e730 > bitcast<f32>(1325400063u))), (_e730 == _e730));
                let _e761 = p.member.test;
                let _e762 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e761);
                let _e764 = p.member.map_size;
                let _e766 = local_3;
                local = lt_math_Evsm(_e762.positive_exponent, _e762.negative_exponent, _e762.min_variance);
                let _e773 = ((_e766.level * _e764) * _e764);
                let _e775 = (bitcast<i32>(_e764) - 1i);
                if (_e741 > 0i) {
                    phi_2007_ = _e741;
                } else {
                    phi_2007_ = 0i;
                }
                let _e778 = phi_2007_;
                if (_e750 > 0i) {
                    phi_2012_ = _e750;
                } else {
                    phi_2012_ = 0i;
                }
                let _e781 = phi_2012_;
                if (_e778 < _e775) {
                    phi_2017_ = _e778;
                } else {
                    phi_2017_ = _e775;
                }
                let _e784 = phi_2017_;
                if (_e781 < _e775) {
                    phi_2022_ = _e781;
                } else {
                    phi_2022_ = _e775;
                }
                let _e787 = phi_2022_;
                let _e788 = bitcast<u32>(_e784);
                let _e790 = (_e741 + 1i);
                let _e791 = (_e750 + 1i);
                if (_e790 > 0i) {
                    phi_2031_ = _e790;
                } else {
                    phi_2031_ = 0i;
                }
                let _e794 = phi_2031_;
                if (_e791 > 0i) {
                    phi_2036_ = _e791;
                } else {
                    phi_2036_ = 0i;
                }
                let _e797 = phi_2036_;
                if (_e794 < _e775) {
                    phi_2041_ = _e794;
                } else {
                    phi_2041_ = _e775;
                }
                let _e800 = phi_2041_;
                if (_e797 < _e775) {
                    phi_2046_ = _e797;
                } else {
                    phi_2046_ = _e775;
                }
                let _e803 = phi_2046_;
                let _e804 = bitcast<u32>(_e800);
                let _e806 = (bitcast<u32>(_e787) * _e764);
                let _e807 = (bitcast<u32>(_e803) * _e764);
                let _e812 = ((_e806 + _e788) + _e773);
                let _e813 = ((_e806 + _e804) + _e773);
                let _e814 = ((_e807 + _e788) + _e773);
                let _e815 = ((_e807 + _e804) + _e773);
                if (_e812 < _e61) {
                } else {
                    return;
                }
                let _e819 = map.member[(0u + _e812)];
                if (_e813 < _e61) {
                } else {
                    return;
                }
                let _e823 = map.member[(0u + _e813)];
                if (_e814 < _e61) {
                } else {
                    return;
                }
                let _e827 = map.member[(0u + _e814)];
                if (_e815 < _e61) {
                } else {
                    return;
                }
                let _e831 = map.member[(0u + _e815)];
                let _e833 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e819, _e823, _e827, _e831), vec4<f32>(((1f - _e731) * (1f - _e732)), (_e731 * (1f - _e732)), ((1f - _e731) * _e732), (_e731 * _e732)), _e667);
                let _e835 = p.member.epsilon;
                if (_e833 <= _e835) {
                    phi_2097_ = true;
                } else {
                    phi_2097_ = (_e833 >= (1f - _e835));
                }
                let _e840 = phi_2097_;
                if ((bitcast<u32>(_e833) & 2147483647u) > 2139095040u) {
                    phi_2105_ = true;
                } else {
                    phi_2105_ = !(_e840);
                }
                let _e846 = phi_2105_;
                if _e846 {
                    if (_e833 > 0f) {
                        if (_e833 < 1f) {
                            phi_2117_ = false;
                        } else {
                            phi_2117_ = true;
                        }
                        let _e850 = phi_2117_;
                        phi_2118_ = _e850;
                    } else {
                        phi_2118_ = true;
                    }
                    let _e852 = phi_2118_;
                    if _e852 {
                        phi_2122_ = 0.5f;
                    } else {
                        phi_2122_ = _e833;
                    }
                    let _e854 = phi_2122_;
                    phi_2130_ = evaluate_Verdict(_e854, true);
                } else {
                    if (_e833 > 0.5f) {
                        phi_2128_ = 1f;
                    } else {
                        phi_2128_ = 0f;
                    }
                    let _e858 = phi_2128_;
                    phi_2130_ = evaluate_Verdict(_e858, false);
                }
                let _e861 = phi_2130_;
                phi_2135_ = evaluate_Verdict(_e861.visibility, _e861.is_doubted);
            } else {
                phi_2135_ = evaluate_Verdict(0.5f, true);
            }
            let _e867 = phi_2135_;
            phi_2136_ = _e867;
        }
        let _e869 = phi_2136_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e869.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
