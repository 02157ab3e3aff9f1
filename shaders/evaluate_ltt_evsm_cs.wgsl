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

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_2: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_43;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e63 = phi_160_;
        let _e65 = phi_161_;
        phi_162_ = _e63;
        phi_163_ = _e65;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e67 = phi_162_;
    let _e69 = phi_163_;
    if _e69 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e67;
    }
    let _e74 = phi_168_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_192_: bool;
    var phi_196_: f32;

    let _e52 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_192_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_192_ = _e56;
    }
    let _e58 = phi_192_;
    if _e58 {
        phi_196_ = 42f;
    } else {
        phi_196_ = _e52;
    }
    let _e60 = phi_196_;
    return _e60;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_211_: bool;
    var phi_215_: f32;

    let _e52 = (*param_5).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_211_ = true;
    } else {
        let _e56 = (42f < _e52);
        if _e56 {
        }
        phi_211_ = _e56;
    }
    let _e58 = phi_211_;
    if _e58 {
        phi_215_ = 42f;
    } else {
        phi_215_ = _e52;
    }
    let _e60 = phi_215_;
    return _e60;
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: vec4<f32>) -> f32 {
    var phi_393_: f32;
    var phi_398_: f32;
    var phi_420_: f32;
    var phi_425_: f32;
    var phi_426_: bool;
    var phi_427_: f32;
    var phi_428_: bool;
    var phi_432_: f32;
    var phi_470_: f32;
    var phi_481_: f32;
    var phi_486_: f32;
    var phi_508_: f32;
    var phi_513_: f32;
    var phi_514_: bool;
    var phi_515_: f32;
    var phi_516_: bool;
    var phi_520_: f32;
    var phi_558_: f32;
    var phi_569_: f32;
    var phi_574_: f32;
    var phi_596_: f32;
    var phi_601_: f32;
    var phi_602_: bool;
    var phi_603_: f32;
    var phi_604_: bool;
    var phi_608_: f32;
    var phi_646_: f32;
    var phi_657_: f32;
    var phi_662_: f32;
    var phi_684_: f32;
    var phi_689_: f32;
    var phi_690_: bool;
    var phi_691_: f32;
    var phi_692_: bool;
    var phi_696_: f32;
    var phi_734_: f32;
    var phi_787_: bool;
    var phi_791_: f32;
    var phi_803_: bool;
    var phi_810_: f32;
    var phi_831_: f32;
    var phi_836_: f32;
    var phi_858_: f32;
    var phi_863_: f32;
    var phi_864_: bool;
    var phi_865_: f32;
    var phi_866_: bool;
    var phi_870_: f32;
    var phi_908_: f32;
    var phi_919_: f32;
    var phi_924_: f32;
    var phi_946_: f32;
    var phi_951_: f32;
    var phi_952_: bool;
    var phi_953_: f32;
    var phi_954_: bool;
    var phi_958_: f32;
    var phi_996_: f32;
    var phi_1007_: f32;
    var phi_1012_: f32;
    var phi_1034_: f32;
    var phi_1039_: f32;
    var phi_1040_: bool;
    var phi_1041_: f32;
    var phi_1042_: bool;
    var phi_1046_: f32;
    var phi_1084_: f32;
    var phi_1095_: f32;
    var phi_1100_: f32;
    var phi_1122_: f32;
    var phi_1127_: f32;
    var phi_1128_: bool;
    var phi_1129_: f32;
    var phi_1130_: bool;
    var phi_1134_: f32;
    var phi_1172_: f32;
    var phi_1225_: bool;
    var phi_1229_: f32;
    var phi_1241_: bool;
    var phi_1248_: f32;
    var phi_1259_: bool;
    var phi_1263_: f32;
    var phi_1278_: f32;
    var phi_1279_: f32;
    var phi_1280_: f32;

    let _e53 = _lt_math_evsm_Evsm_positive(param_6);
    let _e55 = (_e53 * param_7.x);
    let _e57 = (_e53 * param_7.y);
    let _e59 = (_e53 * param_7.z);
    let _e61 = (_e53 * param_7.w);
    if ((bitcast<u32>(_e55) & 2147483647u) > 2139095040u) {
        phi_470_ = _e55;
    } else {
        if (_e55 < -87f) {
            phi_393_ = -87f;
        } else {
            phi_393_ = _e55;
        }
        let _e67 = phi_393_;
        if (_e67 > 88f) {
            phi_398_ = 88f;
        } else {
            phi_398_ = _e67;
        }
        let _e70 = phi_398_;
        let _e72 = ((_e70 * 1.442695f) + 0.5f);
        if (_e72 > -8388608f) {
            let _e84 = f32(select(0i, select(select(i32(_e72), i32(-2147483648), (_e72 < bitcast<f32>(3472883712u))), 2147483647i, (_e72 > bitcast<f32>(1325400063u))), (_e72 == _e72)));
            if (_e84 > _e72) {
                phi_420_ = 1f;
            } else {
                phi_420_ = 0f;
            }
            let _e87 = phi_420_;
            if (_e72 < 8388608f) {
                phi_425_ = (_e84 - _e87);
                phi_426_ = false;
            } else {
                phi_425_ = f32();
                phi_426_ = true;
            }
            let _e90 = phi_425_;
            let _e92 = phi_426_;
            phi_427_ = _e90;
            phi_428_ = _e92;
        } else {
            phi_427_ = f32();
            phi_428_ = true;
        }
        let _e94 = phi_427_;
        let _e96 = phi_428_;
        if _e96 {
            phi_432_ = _e72;
        } else {
            phi_432_ = _e94;
        }
        let _e98 = phi_432_;
        let _e102 = ((_e70 - (_e98 * 0.69314575f)) - (_e98 * 0.0000014286068f));
        phi_470_ = ((((((((((((((((1f / 5040f) * _e102) + (1f / 720f)) * _e102) + (1f / 120f)) * _e102) + (1f / 24f)) * _e102) + (1f / 6f)) * _e102) + 0.5f) * _e102) + 1f) * _e102) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e98), i32(-2147483648), (_e98 < bitcast<f32>(3472883712u))), 2147483647i, (_e98 > bitcast<f32>(1325400063u))), (_e98 == _e98)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e138 = phi_470_;
    if ((bitcast<u32>(_e57) & 2147483647u) > 2139095040u) {
        phi_558_ = _e57;
    } else {
        if (_e57 < -87f) {
            phi_481_ = -87f;
        } else {
            phi_481_ = _e57;
        }
        let _e144 = phi_481_;
        if (_e144 > 88f) {
            phi_486_ = 88f;
        } else {
            phi_486_ = _e144;
        }
        let _e147 = phi_486_;
        let _e149 = ((_e147 * 1.442695f) + 0.5f);
        if (_e149 > -8388608f) {
            let _e161 = f32(select(0i, select(select(i32(_e149), i32(-2147483648), (_e149 < bitcast<f32>(3472883712u))), 2147483647i, (_e149 > bitcast<f32>(1325400063u))), (_e149 == _e149)));
            if (_e161 > _e149) {
                phi_508_ = 1f;
            } else {
                phi_508_ = 0f;
            }
            let _e164 = phi_508_;
            if (_e149 < 8388608f) {
                phi_513_ = (_e161 - _e164);
                phi_514_ = false;
            } else {
                phi_513_ = f32();
                phi_514_ = true;
            }
            let _e167 = phi_513_;
            let _e169 = phi_514_;
            phi_515_ = _e167;
            phi_516_ = _e169;
        } else {
            phi_515_ = f32();
            phi_516_ = true;
        }
        let _e171 = phi_515_;
        let _e173 = phi_516_;
        if _e173 {
            phi_520_ = _e149;
        } else {
            phi_520_ = _e171;
        }
        let _e175 = phi_520_;
        let _e179 = ((_e147 - (_e175 * 0.69314575f)) - (_e175 * 0.0000014286068f));
        phi_558_ = ((((((((((((((((1f / 5040f) * _e179) + (1f / 720f)) * _e179) + (1f / 120f)) * _e179) + (1f / 24f)) * _e179) + (1f / 6f)) * _e179) + 0.5f) * _e179) + 1f) * _e179) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e175), i32(-2147483648), (_e175 < bitcast<f32>(3472883712u))), 2147483647i, (_e175 > bitcast<f32>(1325400063u))), (_e175 == _e175)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e215 = phi_558_;
    if ((bitcast<u32>(_e59) & 2147483647u) > 2139095040u) {
        phi_646_ = _e59;
    } else {
        if (_e59 < -87f) {
            phi_569_ = -87f;
        } else {
            phi_569_ = _e59;
        }
        let _e221 = phi_569_;
        if (_e221 > 88f) {
            phi_574_ = 88f;
        } else {
            phi_574_ = _e221;
        }
        let _e224 = phi_574_;
        let _e226 = ((_e224 * 1.442695f) + 0.5f);
        if (_e226 > -8388608f) {
            let _e238 = f32(select(0i, select(select(i32(_e226), i32(-2147483648), (_e226 < bitcast<f32>(3472883712u))), 2147483647i, (_e226 > bitcast<f32>(1325400063u))), (_e226 == _e226)));
            if (_e238 > _e226) {
                phi_596_ = 1f;
            } else {
                phi_596_ = 0f;
            }
            let _e241 = phi_596_;
            if (_e226 < 8388608f) {
                phi_601_ = (_e238 - _e241);
                phi_602_ = false;
            } else {
                phi_601_ = f32();
                phi_602_ = true;
            }
            let _e244 = phi_601_;
            let _e246 = phi_602_;
            phi_603_ = _e244;
            phi_604_ = _e246;
        } else {
            phi_603_ = f32();
            phi_604_ = true;
        }
        let _e248 = phi_603_;
        let _e250 = phi_604_;
        if _e250 {
            phi_608_ = _e226;
        } else {
            phi_608_ = _e248;
        }
        let _e252 = phi_608_;
        let _e256 = ((_e224 - (_e252 * 0.69314575f)) - (_e252 * 0.0000014286068f));
        phi_646_ = ((((((((((((((((1f / 5040f) * _e256) + (1f / 720f)) * _e256) + (1f / 120f)) * _e256) + (1f / 24f)) * _e256) + (1f / 6f)) * _e256) + 0.5f) * _e256) + 1f) * _e256) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e252), i32(-2147483648), (_e252 < bitcast<f32>(3472883712u))), 2147483647i, (_e252 > bitcast<f32>(1325400063u))), (_e252 == _e252)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e292 = phi_646_;
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_734_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_657_ = -87f;
        } else {
            phi_657_ = _e61;
        }
        let _e298 = phi_657_;
        if (_e298 > 88f) {
            phi_662_ = 88f;
        } else {
            phi_662_ = _e298;
        }
        let _e301 = phi_662_;
        let _e303 = ((_e301 * 1.442695f) + 0.5f);
        if (_e303 > -8388608f) {
            let _e315 = f32(select(0i, select(select(i32(_e303), i32(-2147483648), (_e303 < bitcast<f32>(3472883712u))), 2147483647i, (_e303 > bitcast<f32>(1325400063u))), (_e303 == _e303)));
            if (_e315 > _e303) {
                phi_684_ = 1f;
            } else {
                phi_684_ = 0f;
            }
            let _e318 = phi_684_;
            if (_e303 < 8388608f) {
                phi_689_ = (_e315 - _e318);
                phi_690_ = false;
            } else {
                phi_689_ = f32();
                phi_690_ = true;
            }
            let _e321 = phi_689_;
            let _e323 = phi_690_;
            phi_691_ = _e321;
            phi_692_ = _e323;
        } else {
            phi_691_ = f32();
            phi_692_ = true;
        }
        let _e325 = phi_691_;
        let _e327 = phi_692_;
        if _e327 {
            phi_696_ = _e303;
        } else {
            phi_696_ = _e325;
        }
        let _e329 = phi_696_;
        let _e333 = ((_e301 - (_e329 * 0.69314575f)) - (_e329 * 0.0000014286068f));
        phi_734_ = ((((((((((((((((1f / 5040f) * _e333) + (1f / 720f)) * _e333) + (1f / 120f)) * _e333) + (1f / 24f)) * _e333) + (1f / 6f)) * _e333) + 0.5f) * _e333) + 1f) * _e333) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e329), i32(-2147483648), (_e329 < bitcast<f32>(3472883712u))), 2147483647i, (_e329 > bitcast<f32>(1325400063u))), (_e329 == _e329)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e369 = phi_734_;
    let _e371 = (_e138 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e373 = (_e215 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e375 = (_e292 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e377 = (_e369 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e379 = (*param_6).min_variance;
    let _e381 = ((_e379 * _e53) * _e53);
    let _e392 = ((((_e371 * param_8.x) + (_e373 * param_8.y)) + (_e375 * param_8.z)) + (_e377 * param_8.w));
    let _e393 = (_e371 - _e392);
    let _e394 = (_e373 - _e392);
    let _e395 = (_e375 - _e392);
    let _e396 = (_e377 - _e392);
    let _e411 = (((((_e393 * _e393) * param_8.x) + ((_e394 * _e394) * param_8.y)) + ((_e395 * _e395) * param_8.z)) + ((_e396 * _e396) * param_8.w));
    if ((bitcast<u32>(_e381) & 2147483647u) > 2139095040u) {
        phi_787_ = true;
    } else {
        let _e415 = (_e381 > _e411);
        if _e415 {
        }
        phi_787_ = _e415;
    }
    let _e417 = phi_787_;
    if _e417 {
        phi_791_ = _e381;
    } else {
        phi_791_ = _e411;
    }
    let _e419 = phi_791_;
    let _e420 = -(_e392);
    if (_e420 <= 0f) {
        let _e424 = ((bitcast<u32>(_e419) & 2147483647u) > 2139095040u);
        if _e424 {
        }
        phi_803_ = _e424;
    } else {
        phi_803_ = true;
    }
    let _e426 = phi_803_;
    if _e426 {
        phi_810_ = (_e419 / (_e419 + (_e420 * _e420)));
    } else {
        phi_810_ = 1f;
    }
    let _e431 = phi_810_;
    let _e432 = _lt_math_evsm_Evsm_negative(param_6);
    let _e433 = -(_e432);
    let _e435 = (_e433 * param_7.x);
    let _e437 = (_e433 * param_7.y);
    let _e439 = (_e433 * param_7.z);
    let _e441 = (_e433 * param_7.w);
    if ((bitcast<u32>(_e435) & 2147483647u) > 2139095040u) {
        phi_908_ = _e435;
    } else {
        if (_e435 < -87f) {
            phi_831_ = -87f;
        } else {
            phi_831_ = _e435;
        }
        let _e447 = phi_831_;
        if (_e447 > 88f) {
            phi_836_ = 88f;
        } else {
            phi_836_ = _e447;
        }
        let _e450 = phi_836_;
        let _e452 = ((_e450 * 1.442695f) + 0.5f);
        if (_e452 > -8388608f) {
            let _e464 = f32(select(0i, select(select(i32(_e452), i32(-2147483648), (_e452 < bitcast<f32>(3472883712u))), 2147483647i, (_e452 > bitcast<f32>(1325400063u))), (_e452 == _e452)));
            if (_e464 > _e452) {
                phi_858_ = 1f;
            } else {
                phi_858_ = 0f;
            }
            let _e467 = phi_858_;
            if (_e452 < 8388608f) {
                phi_863_ = (_e464 - _e467);
                phi_864_ = false;
            } else {
                phi_863_ = f32();
                phi_864_ = true;
            }
            let _e470 = phi_863_;
            let _e472 = phi_864_;
            phi_865_ = _e470;
            phi_866_ = _e472;
        } else {
            phi_865_ = f32();
            phi_866_ = true;
        }
        let _e474 = phi_865_;
        let _e476 = phi_866_;
        if _e476 {
            phi_870_ = _e452;
        } else {
            phi_870_ = _e474;
        }
        let _e478 = phi_870_;
        let _e482 = ((_e450 - (_e478 * 0.69314575f)) - (_e478 * 0.0000014286068f));
        phi_908_ = ((((((((((((((((1f / 5040f) * _e482) + (1f / 720f)) * _e482) + (1f / 120f)) * _e482) + (1f / 24f)) * _e482) + (1f / 6f)) * _e482) + 0.5f) * _e482) + 1f) * _e482) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e478), i32(-2147483648), (_e478 < bitcast<f32>(3472883712u))), 2147483647i, (_e478 > bitcast<f32>(1325400063u))), (_e478 == _e478)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e518 = phi_908_;
    if ((bitcast<u32>(_e437) & 2147483647u) > 2139095040u) {
        phi_996_ = _e437;
    } else {
        if (_e437 < -87f) {
            phi_919_ = -87f;
        } else {
            phi_919_ = _e437;
        }
        let _e524 = phi_919_;
        if (_e524 > 88f) {
            phi_924_ = 88f;
        } else {
            phi_924_ = _e524;
        }
        let _e527 = phi_924_;
        let _e529 = ((_e527 * 1.442695f) + 0.5f);
        if (_e529 > -8388608f) {
            let _e541 = f32(select(0i, select(select(i32(_e529), i32(-2147483648), (_e529 < bitcast<f32>(3472883712u))), 2147483647i, (_e529 > bitcast<f32>(1325400063u))), (_e529 == _e529)));
            if (_e541 > _e529) {
                phi_946_ = 1f;
            } else {
                phi_946_ = 0f;
            }
            let _e544 = phi_946_;
            if (_e529 < 8388608f) {
                phi_951_ = (_e541 - _e544);
                phi_952_ = false;
            } else {
                phi_951_ = f32();
                phi_952_ = true;
            }
            let _e547 = phi_951_;
            let _e549 = phi_952_;
            phi_953_ = _e547;
            phi_954_ = _e549;
        } else {
            phi_953_ = f32();
            phi_954_ = true;
        }
        let _e551 = phi_953_;
        let _e553 = phi_954_;
        if _e553 {
            phi_958_ = _e529;
        } else {
            phi_958_ = _e551;
        }
        let _e555 = phi_958_;
        let _e559 = ((_e527 - (_e555 * 0.69314575f)) - (_e555 * 0.0000014286068f));
        phi_996_ = ((((((((((((((((1f / 5040f) * _e559) + (1f / 720f)) * _e559) + (1f / 120f)) * _e559) + (1f / 24f)) * _e559) + (1f / 6f)) * _e559) + 0.5f) * _e559) + 1f) * _e559) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e555), i32(-2147483648), (_e555 < bitcast<f32>(3472883712u))), 2147483647i, (_e555 > bitcast<f32>(1325400063u))), (_e555 == _e555)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e595 = phi_996_;
    if ((bitcast<u32>(_e439) & 2147483647u) > 2139095040u) {
        phi_1084_ = _e439;
    } else {
        if (_e439 < -87f) {
            phi_1007_ = -87f;
        } else {
            phi_1007_ = _e439;
        }
        let _e601 = phi_1007_;
        if (_e601 > 88f) {
            phi_1012_ = 88f;
        } else {
            phi_1012_ = _e601;
        }
        let _e604 = phi_1012_;
        let _e606 = ((_e604 * 1.442695f) + 0.5f);
        if (_e606 > -8388608f) {
            let _e618 = f32(select(0i, select(select(i32(_e606), i32(-2147483648), (_e606 < bitcast<f32>(3472883712u))), 2147483647i, (_e606 > bitcast<f32>(1325400063u))), (_e606 == _e606)));
            if (_e618 > _e606) {
                phi_1034_ = 1f;
            } else {
                phi_1034_ = 0f;
            }
            let _e621 = phi_1034_;
            if (_e606 < 8388608f) {
                phi_1039_ = (_e618 - _e621);
                phi_1040_ = false;
            } else {
                phi_1039_ = f32();
                phi_1040_ = true;
            }
            let _e624 = phi_1039_;
            let _e626 = phi_1040_;
            phi_1041_ = _e624;
            phi_1042_ = _e626;
        } else {
            phi_1041_ = f32();
            phi_1042_ = true;
        }
        let _e628 = phi_1041_;
        let _e630 = phi_1042_;
        if _e630 {
            phi_1046_ = _e606;
        } else {
            phi_1046_ = _e628;
        }
        let _e632 = phi_1046_;
        let _e636 = ((_e604 - (_e632 * 0.69314575f)) - (_e632 * 0.0000014286068f));
        phi_1084_ = ((((((((((((((((1f / 5040f) * _e636) + (1f / 720f)) * _e636) + (1f / 120f)) * _e636) + (1f / 24f)) * _e636) + (1f / 6f)) * _e636) + 0.5f) * _e636) + 1f) * _e636) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e632), i32(-2147483648), (_e632 < bitcast<f32>(3472883712u))), 2147483647i, (_e632 > bitcast<f32>(1325400063u))), (_e632 == _e632)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e672 = phi_1084_;
    if ((bitcast<u32>(_e441) & 2147483647u) > 2139095040u) {
        phi_1172_ = _e441;
    } else {
        if (_e441 < -87f) {
            phi_1095_ = -87f;
        } else {
            phi_1095_ = _e441;
        }
        let _e678 = phi_1095_;
        if (_e678 > 88f) {
            phi_1100_ = 88f;
        } else {
            phi_1100_ = _e678;
        }
        let _e681 = phi_1100_;
        let _e683 = ((_e681 * 1.442695f) + 0.5f);
        if (_e683 > -8388608f) {
            let _e695 = f32(select(0i, select(select(i32(_e683), i32(-2147483648), (_e683 < bitcast<f32>(3472883712u))), 2147483647i, (_e683 > bitcast<f32>(1325400063u))), (_e683 == _e683)));
            if (_e695 > _e683) {
                phi_1122_ = 1f;
            } else {
                phi_1122_ = 0f;
            }
            let _e698 = phi_1122_;
            if (_e683 < 8388608f) {
                phi_1127_ = (_e695 - _e698);
                phi_1128_ = false;
            } else {
                phi_1127_ = f32();
                phi_1128_ = true;
            }
            let _e701 = phi_1127_;
            let _e703 = phi_1128_;
            phi_1129_ = _e701;
            phi_1130_ = _e703;
        } else {
            phi_1129_ = f32();
            phi_1130_ = true;
        }
        let _e705 = phi_1129_;
        let _e707 = phi_1130_;
        if _e707 {
            phi_1134_ = _e683;
        } else {
            phi_1134_ = _e705;
        }
        let _e709 = phi_1134_;
        let _e713 = ((_e681 - (_e709 * 0.69314575f)) - (_e709 * 0.0000014286068f));
        phi_1172_ = ((((((((((((((((1f / 5040f) * _e713) + (1f / 720f)) * _e713) + (1f / 120f)) * _e713) + (1f / 24f)) * _e713) + (1f / 6f)) * _e713) + 0.5f) * _e713) + 1f) * _e713) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e709), i32(-2147483648), (_e709 < bitcast<f32>(3472883712u))), 2147483647i, (_e709 > bitcast<f32>(1325400063u))), (_e709 == _e709)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e749 = phi_1172_;
    let _e751 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e518);
    let _e753 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e595);
    let _e755 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e672);
    let _e757 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e749);
    let _e759 = (*param_6).min_variance;
    let _e761 = ((_e759 * _e432) * _e432);
    let _e772 = ((((_e751 * param_8.x) + (_e753 * param_8.y)) + (_e755 * param_8.z)) + (_e757 * param_8.w));
    let _e773 = (_e751 - _e772);
    let _e774 = (_e753 - _e772);
    let _e775 = (_e755 - _e772);
    let _e776 = (_e757 - _e772);
    let _e791 = (((((_e773 * _e773) * param_8.x) + ((_e774 * _e774) * param_8.y)) + ((_e775 * _e775) * param_8.z)) + ((_e776 * _e776) * param_8.w));
    if ((bitcast<u32>(_e761) & 2147483647u) > 2139095040u) {
        phi_1225_ = true;
    } else {
        let _e795 = (_e761 > _e791);
        if _e795 {
        }
        phi_1225_ = _e795;
    }
    let _e797 = phi_1225_;
    if _e797 {
        phi_1229_ = _e761;
    } else {
        phi_1229_ = _e791;
    }
    let _e799 = phi_1229_;
    let _e800 = -(_e772);
    if (_e800 <= 0f) {
        let _e804 = ((bitcast<u32>(_e799) & 2147483647u) > 2139095040u);
        if _e804 {
        }
        phi_1241_ = _e804;
    } else {
        phi_1241_ = true;
    }
    let _e806 = phi_1241_;
    if _e806 {
        phi_1248_ = (_e799 / (_e799 + (_e800 * _e800)));
    } else {
        phi_1248_ = 1f;
    }
    let _e811 = phi_1248_;
    if ((bitcast<u32>(_e811) & 2147483647u) > 2139095040u) {
        phi_1259_ = true;
    } else {
        let _e815 = (_e811 < _e431);
        if _e815 {
        }
        phi_1259_ = _e815;
    }
    let _e817 = phi_1259_;
    if _e817 {
        phi_1263_ = _e811;
    } else {
        phi_1263_ = _e431;
    }
    let _e819 = phi_1263_;
    if ((bitcast<u32>(_e819) & 2147483647u) > 2139095040u) {
        phi_1280_ = _e819;
    } else {
        if (_e819 < 0f) {
            phi_1279_ = 0f;
        } else {
            if (_e819 > 1f) {
                phi_1278_ = 1f;
            } else {
                phi_1278_ = _e819;
            }
            let _e826 = phi_1278_;
            phi_1279_ = _e826;
        }
        let _e828 = phi_1279_;
        phi_1280_ = _e828;
    }
    let _e830 = phi_1280_;
    return _e830;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, lt_math_Evsm>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_289_: f32;
    var phi_290_: f32;
    var phi_291_: f32;
    var phi_307_: f32;
    var phi_308_: f32;
    var phi_309_: f32;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_349_: bool;
    var phi_350_: bool;
    var phi_351_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_355_: bool;
    var phi_356_: bool;
    var phi_360_: bool;
    var phi_364_: bool;
    var phi_369_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_237_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_236_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = param_12;
            }
            let _e60 = phi_235_;
            phi_236_ = _e60;
        }
        let _e62 = phi_236_;
        phi_237_ = _e62;
    }
    let _e64 = phi_237_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_255_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_254_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_253_ = 1f;
            } else {
                phi_253_ = param_10.x;
            }
            let _e72 = phi_253_;
            phi_254_ = _e72;
        }
        let _e74 = phi_254_;
        phi_255_ = _e74;
    }
    let _e76 = phi_255_;
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_273_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_272_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_271_ = 1f;
            } else {
                phi_271_ = param_10.y;
            }
            let _e84 = phi_271_;
            phi_272_ = _e84;
        }
        let _e86 = phi_272_;
        phi_273_ = _e86;
    }
    let _e88 = phi_273_;
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_291_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_290_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_289_ = 1f;
            } else {
                phi_289_ = param_10.z;
            }
            let _e96 = phi_289_;
            phi_290_ = _e96;
        }
        let _e98 = phi_290_;
        phi_291_ = _e98;
    }
    let _e100 = phi_291_;
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_309_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_308_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_307_ = 1f;
            } else {
                phi_307_ = param_10.w;
            }
            let _e108 = phi_307_;
            phi_308_ = _e108;
        }
        let _e110 = phi_308_;
        phi_309_ = _e110;
    }
    let _e112 = phi_309_;
    let _e113 = (_e76 - _e64);
    let _e114 = (_e88 - _e64);
    let _e115 = (_e100 - _e64);
    let _e116 = (_e112 - _e64);
    if (_e113 >= 0f) {
        if (_e114 >= 0f) {
            if (_e115 >= 0f) {
                if (_e116 >= 0f) {
                    phi_346_ = !(((bitcast<u32>(((((_e113 * param_11.x) + (_e114 * param_11.y)) + (_e115 * param_11.z)) + (_e116 * param_11.w))) & 2147483647u) > 2139095040u));
                    phi_347_ = false;
                } else {
                    phi_346_ = bool();
                    phi_347_ = true;
                }
                let _e138 = phi_346_;
                let _e140 = phi_347_;
                phi_348_ = _e138;
                phi_349_ = false;
                phi_350_ = _e140;
            } else {
                phi_348_ = bool();
                phi_349_ = true;
                phi_350_ = false;
            }
            let _e142 = phi_348_;
            let _e144 = phi_349_;
            let _e146 = phi_350_;
            phi_351_ = _e142;
            phi_352_ = _e144;
            phi_353_ = _e146;
        } else {
            phi_351_ = bool();
            phi_352_ = true;
            phi_353_ = false;
        }
        let _e148 = phi_351_;
        let _e150 = phi_352_;
        let _e152 = phi_353_;
        phi_354_ = _e148;
        phi_355_ = _e150;
        phi_356_ = _e152;
    } else {
        phi_354_ = bool();
        phi_355_ = true;
        phi_356_ = false;
    }
    let _e154 = phi_354_;
    let _e156 = phi_355_;
    let _e158 = phi_356_;
    if _e156 {
        phi_360_ = true;
    } else {
        phi_360_ = _e158;
    }
    let _e160 = phi_360_;
    if _e160 {
        phi_364_ = false;
    } else {
        phi_364_ = _e154;
    }
    let _e162 = phi_364_;
    if _e162 {
        phi_369_ = 1f;
    } else {
        let _e163 = _lt_math_evsm_Evsm_bound_of_offsets(param_9, vec4<f32>(_e113, _e114, _e115, _e116), param_11);
        phi_369_ = _e163;
    }
    let _e165 = phi_369_;
    return _e165;
}

fn function_() {
    var local_1: lt_math_Evsm;
    var phi_1334_: bool;
    var phi_1335_: bool;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1341_: bool;
    var phi_1385_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1389_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1466_: bool;
    var phi_1475_: bool;
    var phi_1484_: bool;
    var phi_1485_: bool;
    var phi_1486_: bool;
    var phi_1487_: bool;
    var phi_1488_: bool;
    var phi_1489_: bool;
    var phi_1490_: bool;
    var phi_1494_: bool;
    var phi_1530_: f32;
    var phi_1535_: f32;
    var phi_1536_: bool;
    var phi_1537_: f32;
    var phi_1538_: bool;
    var phi_1542_: f32;
    var phi_1562_: f32;
    var phi_1567_: f32;
    var phi_1568_: bool;
    var phi_1569_: f32;
    var phi_1570_: bool;
    var phi_1574_: f32;
    var phi_1624_: i32;
    var phi_1629_: i32;
    var phi_1634_: i32;
    var phi_1639_: i32;
    var phi_1648_: i32;
    var phi_1653_: i32;
    var phi_1658_: i32;
    var phi_1663_: i32;
    var phi_1710_: bool;
    var phi_1718_: bool;
    var phi_1723_: f32;
    var phi_1726_: evaluate_Verdict;
    var phi_1727_: evaluate_Verdict;
    var phi_1731_: bool;
    var phi_1732_: u32;
    var phi_1738_: u32;

    let _e51 = id_1;
    let _e52 = local_2;
    let _e57 = arrayLength((&map.member));
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e64 = p.member.size[0u];
    let _e66 = p.member.size[1u];
    let _e67 = lt_shaders_entry_pixel_index(_e51, _e64, _e66);
    if (bitcast<i32>(_e67.root) != 0i) {
        let _e74 = p.member.light;
        let _e77 = samples.member[_e67.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e67.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e67.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_1334_ = (_e87 == _e89);
                phi_1335_ = false;
            } else {
                phi_1334_ = bool();
                phi_1335_ = true;
            }
            let _e92 = phi_1334_;
            let _e94 = phi_1335_;
            phi_1336_ = _e92;
            phi_1337_ = _e94;
        } else {
            phi_1336_ = bool();
            phi_1337_ = true;
        }
        let _e96 = phi_1336_;
        let _e98 = phi_1337_;
        if _e98 {
            phi_1341_ = false;
        } else {
            phi_1341_ = _e96;
        }
        let _e100 = phi_1341_;
        if !(_e100) {
            let _e103 = samples.member[_e67.first_primitive].normal;
            let _e105 = samples.member[_e67.first_primitive].position;
            if ((((_e103.x * (_e74.x - (_e105.x * _e74.w))) + (_e103.y * (_e74.y - (_e105.y * _e74.w)))) + (_e103.z * (_e74.z - (_e105.z * _e74.w)))) > 0f) {
                let _e129 = samples.member[_e67.first_primitive].flags;
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_1385_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, ((_e129 & 1u) == 0u));
            } else {
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_1385_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, true);
            }
            let _e163 = phi_1385_;
            phi_1389_ = _e163;
        } else {
            let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
            phi_1389_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, true);
        }
        let _e180 = phi_1389_;
        if _e180.unnamed_1 {
            phi_1727_ = evaluate_Verdict(_e180.unnamed.visibility, _e180.unnamed.is_doubted);
        } else {
            let _e188 = samples.member[_e67.first_primitive].position;
            let _e194 = p.member.projection.row_w;
            let _e205 = ((((_e194.x * _e188.x) + (_e194.y * _e188.y)) + (_e194.z * _e188.z)) + (_e194.w * 1f));
            let _e207 = p.member.projection.row_x;
            let _e219 = (((((_e207.x * _e188.x) + (_e207.y * _e188.y)) + (_e207.z * _e188.z)) + (_e207.w * 1f)) / _e205);
            let _e221 = p.member.projection.row_y;
            let _e233 = (((((_e221.x * _e188.x) + (_e221.y * _e188.y)) + (_e221.z * _e188.z)) + (_e221.w * 1f)) / _e205);
            let _e235 = p.member.projection.row_z;
            let _e246 = ((((_e235.x * _e188.x) + (_e235.y * _e188.y)) + (_e235.z * _e188.z)) + (_e235.w * 1f));
            if (_e205 > 0f) {
                if (_e219 >= 0f) {
                    phi_1466_ = (_e219 <= 1f);
                } else {
                    phi_1466_ = false;
                }
                let _e251 = phi_1466_;
                if _e251 {
                    if (_e233 >= 0f) {
                        phi_1475_ = (_e233 <= 1f);
                    } else {
                        phi_1475_ = false;
                    }
                    let _e255 = phi_1475_;
                    if _e255 {
                        if (_e246 >= 0f) {
                            phi_1484_ = (_e246 <= 1f);
                        } else {
                            phi_1484_ = false;
                        }
                        let _e259 = phi_1484_;
                        phi_1485_ = _e259;
                        phi_1486_ = false;
                    } else {
                        phi_1485_ = bool();
                        phi_1486_ = true;
                    }
                    let _e261 = phi_1485_;
                    let _e263 = phi_1486_;
                    phi_1487_ = _e261;
                    phi_1488_ = _e263;
                } else {
                    phi_1487_ = bool();
                    phi_1488_ = true;
                }
                let _e265 = phi_1487_;
                let _e267 = phi_1488_;
                phi_1489_ = _e265;
                phi_1490_ = _e267;
            } else {
                phi_1489_ = bool();
                phi_1490_ = true;
            }
            let _e269 = phi_1489_;
            let _e271 = phi_1490_;
            if _e271 {
                phi_1494_ = false;
            } else {
                phi_1494_ = _e269;
            }
            let _e273 = phi_1494_;
            if _e273 {
                let _e275 = p.member.map_size;
                let _e276 = f32(_e275);
                let _e279 = ((_e219 * _e276) - 0.5f);
                let _e280 = ((_e233 * _e276) - 0.5f);
                if (_e279 > -8388608f) {
                    let _e292 = f32(select(0i, select(select(i32(_e279), i32(-2147483648), (_e279 < bitcast<f32>(3472883712u))), 2147483647i, (_e279 > bitcast<f32>(1325400063u))), (_e279 == _e279)));
                    if (_e292 > _e279) {
                        phi_1530_ = 1f;
                    } else {
                        phi_1530_ = 0f;
                    }
                    let _e295 = phi_1530_;
                    if (_e279 < 8388608f) {
                        phi_1535_ = (_e292 - _e295);
                        phi_1536_ = false;
                    } else {
                        phi_1535_ = f32();
                        phi_1536_ = true;
                    }
                    let _e298 = phi_1535_;
                    let _e300 = phi_1536_;
                    phi_1537_ = _e298;
                    phi_1538_ = _e300;
                } else {
                    phi_1537_ = f32();
                    phi_1538_ = true;
                }
                let _e302 = phi_1537_;
                let _e304 = phi_1538_;
                if _e304 {
                    phi_1542_ = _e279;
                } else {
                    phi_1542_ = _e302;
                }
                let _e306 = phi_1542_;
                if (_e280 > -8388608f) {
                    let _e318 = f32(select(0i, select(select(i32(_e280), i32(-2147483648), (_e280 < bitcast<f32>(3472883712u))), 2147483647i, (_e280 > bitcast<f32>(1325400063u))), (_e280 == _e280)));
                    if (_e318 > _e280) {
                        phi_1562_ = 1f;
                    } else {
                        phi_1562_ = 0f;
                    }
                    let _e321 = phi_1562_;
                    if (_e280 < 8388608f) {
                        phi_1567_ = (_e318 - _e321);
                        phi_1568_ = false;
                    } else {
                        phi_1567_ = f32();
                        phi_1568_ = true;
                    }
                    let _e324 = phi_1567_;
                    let _e326 = phi_1568_;
                    phi_1569_ = _e324;
                    phi_1570_ = _e326;
                } else {
                    phi_1569_ = f32();
                    phi_1570_ = true;
                }
                let _e328 = phi_1569_;
                let _e330 = phi_1570_;
                if _e330 {
                    phi_1574_ = _e280;
                } else {
                    phi_1574_ = _e328;
                }
                let _e332 = phi_1574_;
                let _e333 = (_e279 - _e306);
                let _e334 = (_e280 - _e332);
                let _e343 = select(0i, select(select(i32(_e306), i32(-2147483648), (_e306 < bitcast<f32>(3472883712u))), 2147483647i, (_e306 > bitcast<f32>(1325400063u))), (_e306 == _e306));
                let _e352 = select(0i, select(select(i32(_e332), i32(-2147483648), (_e332 < bitcast<f32>(3472883712u))), 2147483647i, (_e332 > bitcast<f32>(1325400063u))), (_e332 == _e332));
                let _e363 = p.member.test;
                let _e364 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e363);
                let _e366 = p.member.map_size;
                local_1 = lt_math_Evsm(_e364.positive_exponent, _e364.negative_exponent, _e364.min_variance);
                let _e372 = (bitcast<i32>(_e366) - 1i);
                if (_e343 > 0i) {
                    phi_1624_ = _e343;
                } else {
                    phi_1624_ = 0i;
                }
                let _e375 = phi_1624_;
                if (_e352 > 0i) {
                    phi_1629_ = _e352;
                } else {
                    phi_1629_ = 0i;
                }
                let _e378 = phi_1629_;
                if (_e375 < _e372) {
                    phi_1634_ = _e375;
                } else {
                    phi_1634_ = _e372;
                }
                let _e381 = phi_1634_;
                if (_e378 < _e372) {
                    phi_1639_ = _e378;
                } else {
                    phi_1639_ = _e372;
                }
                let _e384 = phi_1639_;
                let _e385 = bitcast<u32>(_e381);
                let _e387 = (_e343 + 1i);
                let _e388 = (_e352 + 1i);
                if (_e387 > 0i) {
                    phi_1648_ = _e387;
                } else {
                    phi_1648_ = 0i;
                }
                let _e391 = phi_1648_;
                if (_e388 > 0i) {
                    phi_1653_ = _e388;
                } else {
                    phi_1653_ = 0i;
                }
                let _e394 = phi_1653_;
                if (_e391 < _e372) {
                    phi_1658_ = _e391;
                } else {
                    phi_1658_ = _e372;
                }
                let _e397 = phi_1658_;
                if (_e394 < _e372) {
                    phi_1663_ = _e394;
                } else {
                    phi_1663_ = _e372;
                }
                let _e400 = phi_1663_;
                let _e401 = bitcast<u32>(_e397);
                let _e403 = (bitcast<u32>(_e384) * _e366);
                let _e404 = (bitcast<u32>(_e400) * _e366);
                let _e405 = (_e403 + _e385);
                let _e406 = (_e403 + _e401);
                let _e407 = (_e404 + _e385);
                let _e408 = (_e404 + _e401);
                if (_e405 < _e57) {
                } else {
                    return;
                }
                let _e412 = map.member[(0u + _e405)];
                if (_e406 < _e57) {
                } else {
                    return;
                }
                let _e416 = map.member[(0u + _e406)];
                if (_e407 < _e57) {
                } else {
                    return;
                }
                let _e420 = map.member[(0u + _e407)];
                if (_e408 < _e57) {
                } else {
                    return;
                }
                let _e424 = map.member[(0u + _e408)];
                let _e426 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e412, _e416, _e420, _e424), vec4<f32>(((1f - _e333) * (1f - _e334)), (_e333 * (1f - _e334)), ((1f - _e333) * _e334), (_e333 * _e334)), _e246);
                let _e428 = p.member.epsilon;
                if (_e426 <= _e428) {
                    phi_1710_ = true;
                } else {
                    phi_1710_ = (_e426 >= (1f - _e428));
                }
                let _e433 = phi_1710_;
                if ((bitcast<u32>(_e426) & 2147483647u) > 2139095040u) {
                    phi_1718_ = true;
                } else {
                    phi_1718_ = !(_e433);
                }
                let _e439 = phi_1718_;
                if (_e426 > 0.5f) {
                    phi_1723_ = 1f;
                } else {
                    phi_1723_ = 0f;
                }
                let _e442 = phi_1723_;
                phi_1726_ = evaluate_Verdict(_e442, _e439);
            } else {
                phi_1726_ = evaluate_Verdict(1f, true);
            }
            let _e446 = phi_1726_;
            phi_1727_ = _e446;
        }
        let _e448 = phi_1727_;
        visibility.member[_e67.first_primitive] = _e448.visibility;
        phi_1731_ = _e448.is_doubted;
        phi_1732_ = _e67.first_primitive;
    } else {
        phi_1731_ = false;
        phi_1732_ = 0u;
    }
    let _e453 = phi_1731_;
    let _e455 = phi_1732_;
    if _e453 {
        let _e457 = atomicAdd((&shared_[0u]), 1u);
        phi_1738_ = _e457;
    } else {
        phi_1738_ = 0u;
    }
    let _e459 = phi_1738_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e463 = atomicLoad((&shared_[0u]));
        let _e464 = atomicAdd((&list.member[3u]), _e463);
        atomicStore((&shared_[1u]), _e464);
    }
    workgroupBarrier();
    if _e453 {
        let _e467 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e467) + _e459)]), _e455);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_2 = local;
    function_();
}
