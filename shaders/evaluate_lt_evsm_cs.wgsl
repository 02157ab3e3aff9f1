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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_149_: lt_bvh_traverse_Tree;
    var phi_150_: bool;
    var phi_151_: lt_bvh_traverse_Tree;
    var phi_152_: bool;
    var phi_157_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_149_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_150_ = false;
        } else {
            phi_149_ = lt_bvh_traverse_Tree();
            phi_150_ = true;
        }
        let _e60 = phi_149_;
        let _e62 = phi_150_;
        phi_151_ = _e60;
        phi_152_ = _e62;
    } else {
        phi_151_ = lt_bvh_traverse_Tree();
        phi_152_ = true;
    }
    let _e64 = phi_151_;
    let _e66 = phi_152_;
    if _e66 {
        phi_157_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_157_ = _e64;
    }
    let _e71 = phi_157_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_337_: bool;
    var phi_341_: f32;
    var phi_360_: f32;
    var phi_365_: f32;
    var phi_387_: f32;
    var phi_392_: f32;
    var phi_393_: bool;
    var phi_394_: f32;
    var phi_395_: bool;
    var phi_399_: f32;
    var phi_437_: f32;
    var phi_448_: f32;
    var phi_453_: f32;
    var phi_475_: f32;
    var phi_480_: f32;
    var phi_481_: bool;
    var phi_482_: f32;
    var phi_483_: bool;
    var phi_487_: f32;
    var phi_525_: f32;
    var phi_536_: f32;
    var phi_541_: f32;
    var phi_563_: f32;
    var phi_568_: f32;
    var phi_569_: bool;
    var phi_570_: f32;
    var phi_571_: bool;
    var phi_575_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_629_: f32;
    var phi_651_: f32;
    var phi_656_: f32;
    var phi_657_: bool;
    var phi_658_: f32;
    var phi_659_: bool;
    var phi_663_: f32;
    var phi_701_: f32;
    var phi_754_: bool;
    var phi_758_: f32;
    var phi_770_: bool;
    var phi_777_: f32;
    var phi_790_: bool;
    var phi_794_: f32;
    var phi_814_: f32;
    var phi_819_: f32;
    var phi_841_: f32;
    var phi_846_: f32;
    var phi_847_: bool;
    var phi_848_: f32;
    var phi_849_: bool;
    var phi_853_: f32;
    var phi_891_: f32;
    var phi_902_: f32;
    var phi_907_: f32;
    var phi_929_: f32;
    var phi_934_: f32;
    var phi_935_: bool;
    var phi_936_: f32;
    var phi_937_: bool;
    var phi_941_: f32;
    var phi_979_: f32;
    var phi_990_: f32;
    var phi_995_: f32;
    var phi_1017_: f32;
    var phi_1022_: f32;
    var phi_1023_: bool;
    var phi_1024_: f32;
    var phi_1025_: bool;
    var phi_1029_: f32;
    var phi_1067_: f32;
    var phi_1078_: f32;
    var phi_1083_: f32;
    var phi_1105_: f32;
    var phi_1110_: f32;
    var phi_1111_: bool;
    var phi_1112_: f32;
    var phi_1113_: bool;
    var phi_1117_: f32;
    var phi_1155_: f32;
    var phi_1208_: bool;
    var phi_1212_: f32;
    var phi_1224_: bool;
    var phi_1231_: f32;
    var phi_1242_: bool;
    var phi_1246_: f32;
    var phi_1261_: f32;
    var phi_1262_: f32;
    var phi_1263_: f32;

    let _e51 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_337_ = true;
    } else {
        let _e55 = (42f < _e51);
        if _e55 {
        }
        phi_337_ = _e55;
    }
    let _e57 = phi_337_;
    if _e57 {
        phi_341_ = 42f;
    } else {
        phi_341_ = _e51;
    }
    let _e59 = phi_341_;
    let _e61 = (_e59 * param_5.x);
    let _e63 = (_e59 * param_5.y);
    let _e65 = (_e59 * param_5.z);
    let _e67 = (_e59 * param_5.w);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_437_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_360_ = -87f;
        } else {
            phi_360_ = _e61;
        }
        let _e73 = phi_360_;
        if (_e73 > 88f) {
            phi_365_ = 88f;
        } else {
            phi_365_ = _e73;
        }
        let _e76 = phi_365_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_387_ = 1f;
            } else {
                phi_387_ = 0f;
            }
            let _e93 = phi_387_;
            if (_e78 < 8388608f) {
                phi_392_ = (_e90 - _e93);
                phi_393_ = false;
            } else {
                phi_392_ = f32();
                phi_393_ = true;
            }
            let _e96 = phi_392_;
            let _e98 = phi_393_;
            phi_394_ = _e96;
            phi_395_ = _e98;
        } else {
            phi_394_ = f32();
            phi_395_ = true;
        }
        let _e100 = phi_394_;
        let _e102 = phi_395_;
        if _e102 {
            phi_399_ = _e78;
        } else {
            phi_399_ = _e100;
        }
        let _e104 = phi_399_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_437_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_437_;
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_525_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_448_ = -87f;
        } else {
            phi_448_ = _e63;
        }
        let _e150 = phi_448_;
        if (_e150 > 88f) {
            phi_453_ = 88f;
        } else {
            phi_453_ = _e150;
        }
        let _e153 = phi_453_;
        let _e155 = ((_e153 * 1.442695f) + 0.5f);
        if (_e155 > -8388608f) {
            let _e167 = f32(select(0i, select(select(i32(_e155), i32(-2147483648), (_e155 < bitcast<f32>(3472883712u))), 2147483647i, (_e155 > bitcast<f32>(1325400063u))), (_e155 == _e155)));
            if (_e167 > _e155) {
                phi_475_ = 1f;
            } else {
                phi_475_ = 0f;
            }
            let _e170 = phi_475_;
            if (_e155 < 8388608f) {
                phi_480_ = (_e167 - _e170);
                phi_481_ = false;
            } else {
                phi_480_ = f32();
                phi_481_ = true;
            }
            let _e173 = phi_480_;
            let _e175 = phi_481_;
            phi_482_ = _e173;
            phi_483_ = _e175;
        } else {
            phi_482_ = f32();
            phi_483_ = true;
        }
        let _e177 = phi_482_;
        let _e179 = phi_483_;
        if _e179 {
            phi_487_ = _e155;
        } else {
            phi_487_ = _e177;
        }
        let _e181 = phi_487_;
        let _e185 = ((_e153 - (_e181 * 0.69314575f)) - (_e181 * 0.0000014286068f));
        phi_525_ = ((((((((((((((((1f / 5040f) * _e185) + (1f / 720f)) * _e185) + (1f / 120f)) * _e185) + (1f / 24f)) * _e185) + (1f / 6f)) * _e185) + 0.5f) * _e185) + 1f) * _e185) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e181), i32(-2147483648), (_e181 < bitcast<f32>(3472883712u))), 2147483647i, (_e181 > bitcast<f32>(1325400063u))), (_e181 == _e181)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e221 = phi_525_;
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_613_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_536_ = -87f;
        } else {
            phi_536_ = _e65;
        }
        let _e227 = phi_536_;
        if (_e227 > 88f) {
            phi_541_ = 88f;
        } else {
            phi_541_ = _e227;
        }
        let _e230 = phi_541_;
        let _e232 = ((_e230 * 1.442695f) + 0.5f);
        if (_e232 > -8388608f) {
            let _e244 = f32(select(0i, select(select(i32(_e232), i32(-2147483648), (_e232 < bitcast<f32>(3472883712u))), 2147483647i, (_e232 > bitcast<f32>(1325400063u))), (_e232 == _e232)));
            if (_e244 > _e232) {
                phi_563_ = 1f;
            } else {
                phi_563_ = 0f;
            }
            let _e247 = phi_563_;
            if (_e232 < 8388608f) {
                phi_568_ = (_e244 - _e247);
                phi_569_ = false;
            } else {
                phi_568_ = f32();
                phi_569_ = true;
            }
            let _e250 = phi_568_;
            let _e252 = phi_569_;
            phi_570_ = _e250;
            phi_571_ = _e252;
        } else {
            phi_570_ = f32();
            phi_571_ = true;
        }
        let _e254 = phi_570_;
        let _e256 = phi_571_;
        if _e256 {
            phi_575_ = _e232;
        } else {
            phi_575_ = _e254;
        }
        let _e258 = phi_575_;
        let _e262 = ((_e230 - (_e258 * 0.69314575f)) - (_e258 * 0.0000014286068f));
        phi_613_ = ((((((((((((((((1f / 5040f) * _e262) + (1f / 720f)) * _e262) + (1f / 120f)) * _e262) + (1f / 24f)) * _e262) + (1f / 6f)) * _e262) + 0.5f) * _e262) + 1f) * _e262) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < bitcast<f32>(3472883712u))), 2147483647i, (_e258 > bitcast<f32>(1325400063u))), (_e258 == _e258)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e298 = phi_613_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_701_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_624_ = -87f;
        } else {
            phi_624_ = _e67;
        }
        let _e304 = phi_624_;
        if (_e304 > 88f) {
            phi_629_ = 88f;
        } else {
            phi_629_ = _e304;
        }
        let _e307 = phi_629_;
        let _e309 = ((_e307 * 1.442695f) + 0.5f);
        if (_e309 > -8388608f) {
            let _e321 = f32(select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < bitcast<f32>(3472883712u))), 2147483647i, (_e309 > bitcast<f32>(1325400063u))), (_e309 == _e309)));
            if (_e321 > _e309) {
                phi_651_ = 1f;
            } else {
                phi_651_ = 0f;
            }
            let _e324 = phi_651_;
            if (_e309 < 8388608f) {
                phi_656_ = (_e321 - _e324);
                phi_657_ = false;
            } else {
                phi_656_ = f32();
                phi_657_ = true;
            }
            let _e327 = phi_656_;
            let _e329 = phi_657_;
            phi_658_ = _e327;
            phi_659_ = _e329;
        } else {
            phi_658_ = f32();
            phi_659_ = true;
        }
        let _e331 = phi_658_;
        let _e333 = phi_659_;
        if _e333 {
            phi_663_ = _e309;
        } else {
            phi_663_ = _e331;
        }
        let _e335 = phi_663_;
        let _e339 = ((_e307 - (_e335 * 0.69314575f)) - (_e335 * 0.0000014286068f));
        phi_701_ = ((((((((((((((((1f / 5040f) * _e339) + (1f / 720f)) * _e339) + (1f / 120f)) * _e339) + (1f / 24f)) * _e339) + (1f / 6f)) * _e339) + 0.5f) * _e339) + 1f) * _e339) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < bitcast<f32>(3472883712u))), 2147483647i, (_e335 > bitcast<f32>(1325400063u))), (_e335 == _e335)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e375 = phi_701_;
    let _e377 = (_e144 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e379 = (_e221 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e381 = (_e298 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e383 = (_e375 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e385 = (*param_4).min_variance;
    let _e387 = ((_e385 * _e59) * _e59);
    let _e398 = ((((_e377 * param_6.x) + (_e379 * param_6.y)) + (_e381 * param_6.z)) + (_e383 * param_6.w));
    let _e399 = (_e377 - _e398);
    let _e400 = (_e379 - _e398);
    let _e401 = (_e381 - _e398);
    let _e402 = (_e383 - _e398);
    let _e417 = (((((_e399 * _e399) * param_6.x) + ((_e400 * _e400) * param_6.y)) + ((_e401 * _e401) * param_6.z)) + ((_e402 * _e402) * param_6.w));
    if ((bitcast<u32>(_e387) & 2147483647u) > 2139095040u) {
        phi_754_ = true;
    } else {
        let _e421 = (_e387 > _e417);
        if _e421 {
        }
        phi_754_ = _e421;
    }
    let _e423 = phi_754_;
    if _e423 {
        phi_758_ = _e387;
    } else {
        phi_758_ = _e417;
    }
    let _e425 = phi_758_;
    let _e426 = -(_e398);
    if (_e426 <= 0f) {
        let _e430 = ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u);
        if _e430 {
        }
        phi_770_ = _e430;
    } else {
        phi_770_ = true;
    }
    let _e432 = phi_770_;
    if _e432 {
        phi_777_ = (_e425 / (_e425 + (_e426 * _e426)));
    } else {
        phi_777_ = 1f;
    }
    let _e437 = phi_777_;
    let _e439 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_790_ = true;
    } else {
        let _e443 = (42f < _e439);
        if _e443 {
        }
        phi_790_ = _e443;
    }
    let _e445 = phi_790_;
    if _e445 {
        phi_794_ = 42f;
    } else {
        phi_794_ = _e439;
    }
    let _e447 = phi_794_;
    let _e448 = -(_e447);
    let _e450 = (_e448 * param_5.x);
    let _e452 = (_e448 * param_5.y);
    let _e454 = (_e448 * param_5.z);
    let _e456 = (_e448 * param_5.w);
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_891_ = _e450;
    } else {
        if (_e450 < -87f) {
            phi_814_ = -87f;
        } else {
            phi_814_ = _e450;
        }
        let _e462 = phi_814_;
        if (_e462 > 88f) {
            phi_819_ = 88f;
        } else {
            phi_819_ = _e462;
        }
        let _e465 = phi_819_;
        let _e467 = ((_e465 * 1.442695f) + 0.5f);
        if (_e467 > -8388608f) {
            let _e479 = f32(select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < bitcast<f32>(3472883712u))), 2147483647i, (_e467 > bitcast<f32>(1325400063u))), (_e467 == _e467)));
            if (_e479 > _e467) {
                phi_841_ = 1f;
            } else {
                phi_841_ = 0f;
            }
            let _e482 = phi_841_;
            if (_e467 < 8388608f) {
                phi_846_ = (_e479 - _e482);
                phi_847_ = false;
            } else {
                phi_846_ = f32();
                phi_847_ = true;
            }
            let _e485 = phi_846_;
            let _e487 = phi_847_;
            phi_848_ = _e485;
            phi_849_ = _e487;
        } else {
            phi_848_ = f32();
            phi_849_ = true;
        }
        let _e489 = phi_848_;
        let _e491 = phi_849_;
        if _e491 {
            phi_853_ = _e467;
        } else {
            phi_853_ = _e489;
        }
        let _e493 = phi_853_;
        let _e497 = ((_e465 - (_e493 * 0.69314575f)) - (_e493 * 0.0000014286068f));
        phi_891_ = ((((((((((((((((1f / 5040f) * _e497) + (1f / 720f)) * _e497) + (1f / 120f)) * _e497) + (1f / 24f)) * _e497) + (1f / 6f)) * _e497) + 0.5f) * _e497) + 1f) * _e497) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < bitcast<f32>(3472883712u))), 2147483647i, (_e493 > bitcast<f32>(1325400063u))), (_e493 == _e493)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e533 = phi_891_;
    if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
        phi_979_ = _e452;
    } else {
        if (_e452 < -87f) {
            phi_902_ = -87f;
        } else {
            phi_902_ = _e452;
        }
        let _e539 = phi_902_;
        if (_e539 > 88f) {
            phi_907_ = 88f;
        } else {
            phi_907_ = _e539;
        }
        let _e542 = phi_907_;
        let _e544 = ((_e542 * 1.442695f) + 0.5f);
        if (_e544 > -8388608f) {
            let _e556 = f32(select(0i, select(select(i32(_e544), i32(-2147483648), (_e544 < bitcast<f32>(3472883712u))), 2147483647i, (_e544 > bitcast<f32>(1325400063u))), (_e544 == _e544)));
            if (_e556 > _e544) {
                phi_929_ = 1f;
            } else {
                phi_929_ = 0f;
            }
            let _e559 = phi_929_;
            if (_e544 < 8388608f) {
                phi_934_ = (_e556 - _e559);
                phi_935_ = false;
            } else {
                phi_934_ = f32();
                phi_935_ = true;
            }
            let _e562 = phi_934_;
            let _e564 = phi_935_;
            phi_936_ = _e562;
            phi_937_ = _e564;
        } else {
            phi_936_ = f32();
            phi_937_ = true;
        }
        let _e566 = phi_936_;
        let _e568 = phi_937_;
        if _e568 {
            phi_941_ = _e544;
        } else {
            phi_941_ = _e566;
        }
        let _e570 = phi_941_;
        let _e574 = ((_e542 - (_e570 * 0.69314575f)) - (_e570 * 0.0000014286068f));
        phi_979_ = ((((((((((((((((1f / 5040f) * _e574) + (1f / 720f)) * _e574) + (1f / 120f)) * _e574) + (1f / 24f)) * _e574) + (1f / 6f)) * _e574) + 0.5f) * _e574) + 1f) * _e574) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e570), i32(-2147483648), (_e570 < bitcast<f32>(3472883712u))), 2147483647i, (_e570 > bitcast<f32>(1325400063u))), (_e570 == _e570)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e610 = phi_979_;
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_1067_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_990_ = -87f;
        } else {
            phi_990_ = _e454;
        }
        let _e616 = phi_990_;
        if (_e616 > 88f) {
            phi_995_ = 88f;
        } else {
            phi_995_ = _e616;
        }
        let _e619 = phi_995_;
        let _e621 = ((_e619 * 1.442695f) + 0.5f);
        if (_e621 > -8388608f) {
            let _e633 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
            if (_e633 > _e621) {
                phi_1017_ = 1f;
            } else {
                phi_1017_ = 0f;
            }
            let _e636 = phi_1017_;
            if (_e621 < 8388608f) {
                phi_1022_ = (_e633 - _e636);
                phi_1023_ = false;
            } else {
                phi_1022_ = f32();
                phi_1023_ = true;
            }
            let _e639 = phi_1022_;
            let _e641 = phi_1023_;
            phi_1024_ = _e639;
            phi_1025_ = _e641;
        } else {
            phi_1024_ = f32();
            phi_1025_ = true;
        }
        let _e643 = phi_1024_;
        let _e645 = phi_1025_;
        if _e645 {
            phi_1029_ = _e621;
        } else {
            phi_1029_ = _e643;
        }
        let _e647 = phi_1029_;
        let _e651 = ((_e619 - (_e647 * 0.69314575f)) - (_e647 * 0.0000014286068f));
        phi_1067_ = ((((((((((((((((1f / 5040f) * _e651) + (1f / 720f)) * _e651) + (1f / 120f)) * _e651) + (1f / 24f)) * _e651) + (1f / 6f)) * _e651) + 0.5f) * _e651) + 1f) * _e651) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e687 = phi_1067_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_1155_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_1078_ = -87f;
        } else {
            phi_1078_ = _e456;
        }
        let _e693 = phi_1078_;
        if (_e693 > 88f) {
            phi_1083_ = 88f;
        } else {
            phi_1083_ = _e693;
        }
        let _e696 = phi_1083_;
        let _e698 = ((_e696 * 1.442695f) + 0.5f);
        if (_e698 > -8388608f) {
            let _e710 = f32(select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < bitcast<f32>(3472883712u))), 2147483647i, (_e698 > bitcast<f32>(1325400063u))), (_e698 == _e698)));
            if (_e710 > _e698) {
                phi_1105_ = 1f;
            } else {
                phi_1105_ = 0f;
            }
            let _e713 = phi_1105_;
            if (_e698 < 8388608f) {
                phi_1110_ = (_e710 - _e713);
                phi_1111_ = false;
            } else {
                phi_1110_ = f32();
                phi_1111_ = true;
            }
            let _e716 = phi_1110_;
            let _e718 = phi_1111_;
            phi_1112_ = _e716;
            phi_1113_ = _e718;
        } else {
            phi_1112_ = f32();
            phi_1113_ = true;
        }
        let _e720 = phi_1112_;
        let _e722 = phi_1113_;
        if _e722 {
            phi_1117_ = _e698;
        } else {
            phi_1117_ = _e720;
        }
        let _e724 = phi_1117_;
        let _e728 = ((_e696 - (_e724 * 0.69314575f)) - (_e724 * 0.0000014286068f));
        phi_1155_ = ((((((((((((((((1f / 5040f) * _e728) + (1f / 720f)) * _e728) + (1f / 120f)) * _e728) + (1f / 24f)) * _e728) + (1f / 6f)) * _e728) + 0.5f) * _e728) + 1f) * _e728) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < bitcast<f32>(3472883712u))), 2147483647i, (_e724 > bitcast<f32>(1325400063u))), (_e724 == _e724)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e764 = phi_1155_;
    let _e766 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e533);
    let _e768 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e610);
    let _e770 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e687);
    let _e772 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e764);
    let _e774 = (*param_4).min_variance;
    let _e776 = ((_e774 * _e447) * _e447);
    let _e787 = ((((_e766 * param_6.x) + (_e768 * param_6.y)) + (_e770 * param_6.z)) + (_e772 * param_6.w));
    let _e788 = (_e766 - _e787);
    let _e789 = (_e768 - _e787);
    let _e790 = (_e770 - _e787);
    let _e791 = (_e772 - _e787);
    let _e806 = (((((_e788 * _e788) * param_6.x) + ((_e789 * _e789) * param_6.y)) + ((_e790 * _e790) * param_6.z)) + ((_e791 * _e791) * param_6.w));
    if ((bitcast<u32>(_e776) & 2147483647u) > 2139095040u) {
        phi_1208_ = true;
    } else {
        let _e810 = (_e776 > _e806);
        if _e810 {
        }
        phi_1208_ = _e810;
    }
    let _e812 = phi_1208_;
    if _e812 {
        phi_1212_ = _e776;
    } else {
        phi_1212_ = _e806;
    }
    let _e814 = phi_1212_;
    let _e815 = -(_e787);
    if (_e815 <= 0f) {
        let _e819 = ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u);
        if _e819 {
        }
        phi_1224_ = _e819;
    } else {
        phi_1224_ = true;
    }
    let _e821 = phi_1224_;
    if _e821 {
        phi_1231_ = (_e814 / (_e814 + (_e815 * _e815)));
    } else {
        phi_1231_ = 1f;
    }
    let _e826 = phi_1231_;
    if ((bitcast<u32>(_e826) & 2147483647u) > 2139095040u) {
        phi_1242_ = true;
    } else {
        let _e830 = (_e826 < _e437);
        if _e830 {
        }
        phi_1242_ = _e830;
    }
    let _e832 = phi_1242_;
    if _e832 {
        phi_1246_ = _e826;
    } else {
        phi_1246_ = _e437;
    }
    let _e834 = phi_1246_;
    if ((bitcast<u32>(_e834) & 2147483647u) > 2139095040u) {
        phi_1263_ = _e834;
    } else {
        if (_e834 < 0f) {
            phi_1262_ = 0f;
        } else {
            if (_e834 > 1f) {
                phi_1261_ = 1f;
            } else {
                phi_1261_ = _e834;
            }
            let _e841 = phi_1261_;
            phi_1262_ = _e841;
        }
        let _e843 = phi_1262_;
        phi_1263_ = _e843;
    }
    let _e845 = phi_1263_;
    return _e845;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_186_: f32;
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_240_: f32;
    var phi_241_: f32;
    var phi_242_: f32;
    var phi_258_: f32;
    var phi_259_: f32;
    var phi_260_: f32;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_320_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_188_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_187_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_186_ = 1f;
            } else {
                phi_186_ = param_10;
            }
            let _e57 = phi_186_;
            phi_187_ = _e57;
        }
        let _e59 = phi_187_;
        phi_188_ = _e59;
    }
    let _e61 = phi_188_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_206_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_205_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_204_ = 1f;
            } else {
                phi_204_ = param_8.x;
            }
            let _e69 = phi_204_;
            phi_205_ = _e69;
        }
        let _e71 = phi_205_;
        phi_206_ = _e71;
    }
    let _e73 = phi_206_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_224_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_223_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_222_ = 1f;
            } else {
                phi_222_ = param_8.y;
            }
            let _e81 = phi_222_;
            phi_223_ = _e81;
        }
        let _e83 = phi_223_;
        phi_224_ = _e83;
    }
    let _e85 = phi_224_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_242_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_241_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_240_ = 1f;
            } else {
                phi_240_ = param_8.z;
            }
            let _e93 = phi_240_;
            phi_241_ = _e93;
        }
        let _e95 = phi_241_;
        phi_242_ = _e95;
    }
    let _e97 = phi_242_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_260_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_259_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_258_ = 1f;
            } else {
                phi_258_ = param_8.w;
            }
            let _e105 = phi_258_;
            phi_259_ = _e105;
        }
        let _e107 = phi_259_;
        phi_260_ = _e107;
    }
    let _e109 = phi_260_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_297_ = !(((bitcast<u32>(((((_e110 * param_9.x) + (_e111 * param_9.y)) + (_e112 * param_9.z)) + (_e113 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_298_ = false;
                } else {
                    phi_297_ = bool();
                    phi_298_ = true;
                }
                let _e135 = phi_297_;
                let _e137 = phi_298_;
                phi_299_ = _e135;
                phi_300_ = false;
                phi_301_ = _e137;
            } else {
                phi_299_ = bool();
                phi_300_ = true;
                phi_301_ = false;
            }
            let _e139 = phi_299_;
            let _e141 = phi_300_;
            let _e143 = phi_301_;
            phi_302_ = _e139;
            phi_303_ = _e141;
            phi_304_ = _e143;
        } else {
            phi_302_ = bool();
            phi_303_ = true;
            phi_304_ = false;
        }
        let _e145 = phi_302_;
        let _e147 = phi_303_;
        let _e149 = phi_304_;
        phi_305_ = _e145;
        phi_306_ = _e147;
        phi_307_ = _e149;
    } else {
        phi_305_ = bool();
        phi_306_ = true;
        phi_307_ = false;
    }
    let _e151 = phi_305_;
    let _e153 = phi_306_;
    let _e155 = phi_307_;
    if _e153 {
        phi_311_ = true;
    } else {
        phi_311_ = _e155;
    }
    let _e157 = phi_311_;
    if _e157 {
        phi_315_ = false;
    } else {
        phi_315_ = _e151;
    }
    let _e159 = phi_315_;
    if _e159 {
        phi_320_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e110, _e111, _e112, _e113), param_9);
        phi_320_ = _e160;
    }
    let _e162 = phi_320_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1319_: bool;
    var phi_1320_: bool;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1326_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1408_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1409_: bool;
    var phi_1410_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1411_: bool;
    var phi_1418_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1422_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1496_: bool;
    var phi_1505_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1516_: bool;
    var phi_1517_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1524_: bool;
    var phi_1614_: f32;
    var phi_1617_: f32;
    var phi_1646_: f32;
    var phi_1651_: f32;
    var phi_1652_: bool;
    var phi_1653_: f32;
    var phi_1654_: bool;
    var phi_1658_: f32;
    var phi_1678_: f32;
    var phi_1683_: f32;
    var phi_1684_: bool;
    var phi_1685_: f32;
    var phi_1686_: bool;
    var phi_1690_: f32;
    var phi_1742_: i32;
    var phi_1747_: i32;
    var phi_1752_: i32;
    var phi_1757_: i32;
    var phi_1766_: i32;
    var phi_1771_: i32;
    var phi_1776_: i32;
    var phi_1781_: i32;
    var phi_1832_: bool;
    var phi_1840_: bool;
    var phi_1852_: bool;
    var phi_1853_: bool;
    var phi_1857_: f32;
    var phi_1863_: f32;
    var phi_1865_: evaluate_Verdict;
    var phi_1870_: evaluate_Verdict;
    var phi_1871_: evaluate_Verdict;

    let _e48 = id_1;
    let _e55 = arrayLength((&map.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        let _e70 = p.member.projection;
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e74 = lt_math_OneLevel(_e70);
        let _e78 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e90 = global[2u];
                phi_1319_ = (_e88 == _e90);
                phi_1320_ = false;
            } else {
                phi_1319_ = bool();
                phi_1320_ = true;
            }
            let _e93 = phi_1319_;
            let _e95 = phi_1320_;
            phi_1321_ = _e93;
            phi_1322_ = _e95;
        } else {
            phi_1321_ = bool();
            phi_1322_ = true;
        }
        let _e97 = phi_1321_;
        let _e99 = phi_1322_;
        if _e99 {
            phi_1326_ = false;
        } else {
            phi_1326_ = _e97;
        }
        let _e101 = phi_1326_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[(0u + _e64.first_primitive)].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_1397_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_1396_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_1396_ = false;
                    }
                    let _e162 = phi_1396_;
                    phi_1397_ = _e162;
                }
                let _e164 = phi_1397_;
                if _e164 {
                    let _e166 = samples.member[(0u + _e64.first_primitive)].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_1408_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_1409_ = false;
                } else {
                    phi_1408_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1409_ = true;
                }
                let _e185 = phi_1408_;
                let _e187 = phi_1409_;
                phi_1410_ = _e185;
                phi_1411_ = _e187;
            } else {
                phi_1410_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1411_ = true;
            }
            let _e189 = phi_1410_;
            let _e191 = phi_1411_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_1418_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_1418_ = _e189;
            }
            let _e208 = phi_1418_;
            phi_1422_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_1422_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_1422_;
        if _e225.unnamed_1 {
            phi_1871_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
        } else {
            let _e233 = samples.member[(0u + _e64.first_primitive)].position;
            let _e251 = ((((_e74.projection.row_w.x * _e233.x) + (_e74.projection.row_w.y * _e233.y)) + (_e74.projection.row_w.z * _e233.z)) + (_e74.projection.row_w.w * 1f));
            let _e265 = (((((_e74.projection.row_x.x * _e233.x) + (_e74.projection.row_x.y * _e233.y)) + (_e74.projection.row_x.z * _e233.z)) + (_e74.projection.row_x.w * 1f)) / _e251);
            let _e279 = (((((_e74.projection.row_y.x * _e233.x) + (_e74.projection.row_y.y * _e233.y)) + (_e74.projection.row_y.z * _e233.z)) + (_e74.projection.row_y.w * 1f)) / _e251);
            let _e292 = ((((_e74.projection.row_z.x * _e233.x) + (_e74.projection.row_z.y * _e233.y)) + (_e74.projection.row_z.z * _e233.z)) + (_e74.projection.row_z.w * 1f));
            if (_e251 > 0f) {
                if (_e265 >= 0f) {
                    phi_1496_ = (_e265 <= 1f);
                } else {
                    phi_1496_ = false;
                }
                let _e297 = phi_1496_;
                if _e297 {
                    if (_e279 >= 0f) {
                        phi_1505_ = (_e279 <= 1f);
                    } else {
                        phi_1505_ = false;
                    }
                    let _e301 = phi_1505_;
                    if _e301 {
                        if (_e292 >= 0f) {
                            phi_1514_ = (_e292 <= 1f);
                        } else {
                            phi_1514_ = false;
                        }
                        let _e305 = phi_1514_;
                        phi_1515_ = _e305;
                        phi_1516_ = false;
                    } else {
                        phi_1515_ = bool();
                        phi_1516_ = true;
                    }
                    let _e307 = phi_1515_;
                    let _e309 = phi_1516_;
                    phi_1517_ = _e307;
                    phi_1518_ = _e309;
                } else {
                    phi_1517_ = bool();
                    phi_1518_ = true;
                }
                let _e311 = phi_1517_;
                let _e313 = phi_1518_;
                phi_1519_ = _e311;
                phi_1520_ = _e313;
            } else {
                phi_1519_ = bool();
                phi_1520_ = true;
            }
            let _e315 = phi_1519_;
            let _e317 = phi_1520_;
            if _e317 {
                phi_1524_ = false;
            } else {
                phi_1524_ = _e315;
            }
            let _e319 = phi_1524_;
            if _e319 {
                if (0f > 0f) {
                    let _e322 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e324 = p.member.map_size;
                    let _e394 = ((abs(((((_e70.row_x.x * _e322.x) + (_e70.row_x.y * _e322.y)) + (_e70.row_x.z * _e322.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e322.x) + (_e70.row_y.y * _e322.y)) + (_e70.row_y.z * _e322.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e322.x) + (_e70.row_z.y * _e322.y)) + (_e70.row_z.z * _e322.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e324)));
                    if (_e394 < 0.002f) {
                        phi_1614_ = _e394;
                    } else {
                        phi_1614_ = 0.002f;
                    }
                    let _e397 = phi_1614_;
                    phi_1617_ = (_e292 - (0f * _e397));
                } else {
                    phi_1617_ = _e292;
                }
                let _e401 = phi_1617_;
                let _e403 = p.member.map_size;
                let _e404 = f32(_e403);
                let _e407 = ((_e265 * _e404) - 0.5f);
                let _e408 = ((_e279 * _e404) - 0.5f);
                if (_e407 > -8388608f) {
                    let _e420 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e420 > _e407) {
                        phi_1646_ = 1f;
                    } else {
                        phi_1646_ = 0f;
                    }
                    let _e423 = phi_1646_;
                    if (_e407 < 8388608f) {
                        phi_1651_ = (_e420 - _e423);
                        phi_1652_ = false;
                    } else {
                        phi_1651_ = f32();
                        phi_1652_ = true;
                    }
                    let _e426 = phi_1651_;
                    let _e428 = phi_1652_;
                    phi_1653_ = _e426;
                    phi_1654_ = _e428;
                } else {
                    phi_1653_ = f32();
                    phi_1654_ = true;
                }
                let _e430 = phi_1653_;
                let _e432 = phi_1654_;
                if _e432 {
                    phi_1658_ = _e407;
                } else {
                    phi_1658_ = _e430;
                }
                let _e434 = phi_1658_;
                if (_e408 > -8388608f) {
                    let _e446 = f32(select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408)));
                    if (_e446 > _e408) {
                        phi_1678_ = 1f;
                    } else {
                        phi_1678_ = 0f;
                    }
                    let _e449 = phi_1678_;
                    if (_e408 < 8388608f) {
                        phi_1683_ = (_e446 - _e449);
                        phi_1684_ = false;
                    } else {
                        phi_1683_ = f32();
                        phi_1684_ = true;
                    }
                    let _e452 = phi_1683_;
                    let _e454 = phi_1684_;
                    phi_1685_ = _e452;
                    phi_1686_ = _e454;
                } else {
                    phi_1685_ = f32();
                    phi_1686_ = true;
                }
                let _e456 = phi_1685_;
                let _e458 = phi_1686_;
                if _e458 {
                    phi_1690_ = _e408;
                } else {
                    phi_1690_ = _e456;
                }
                let _e460 = phi_1690_;
                let _e461 = (_e407 - _e434);
                let _e462 = (_e408 - _e460);
                let _e471 = select(0i, select(select(i32(_e434), i32(-2147483648), (_e434 < bitcast<f32>(3472883712u))), 2147483647i, (_e434 > bitcast<f32>(1325400063u))), (_e434 == _e434));
                let _e480 = select(0i, select(select(i32(_e460), i32(-2147483648), (_e460 < bitcast<f32>(3472883712u))), 2147483647i, (_e460 > bitcast<f32>(1325400063u))), (_e460 == _e460));
                let _e491 = p.member.test;
                let _e492 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e491);
                let _e494 = p.member.map_size;
                local = lt_math_Evsm(_e492.positive_exponent, _e492.negative_exponent, _e492.min_variance);
                let _e500 = ((0u * _e494) * _e494);
                let _e502 = (bitcast<i32>(_e494) - 1i);
                if (_e471 > 0i) {
                    phi_1742_ = _e471;
                } else {
                    phi_1742_ = 0i;
                }
                let _e505 = phi_1742_;
                if (_e480 > 0i) {
                    phi_1747_ = _e480;
                } else {
                    phi_1747_ = 0i;
                }
                let _e508 = phi_1747_;
                if (_e505 < _e502) {
                    phi_1752_ = _e505;
                } else {
                    phi_1752_ = _e502;
                }
                let _e511 = phi_1752_;
                if (_e508 < _e502) {
                    phi_1757_ = _e508;
                } else {
                    phi_1757_ = _e502;
                }
                let _e514 = phi_1757_;
                let _e515 = bitcast<u32>(_e511);
                let _e517 = (_e471 + 1i);
                let _e518 = (_e480 + 1i);
                if (_e517 > 0i) {
                    phi_1766_ = _e517;
                } else {
                    phi_1766_ = 0i;
                }
                let _e521 = phi_1766_;
                if (_e518 > 0i) {
                    phi_1771_ = _e518;
                } else {
                    phi_1771_ = 0i;
                }
                let _e524 = phi_1771_;
                if (_e521 < _e502) {
                    phi_1776_ = _e521;
                } else {
                    phi_1776_ = _e502;
                }
                let _e527 = phi_1776_;
                if (_e524 < _e502) {
                    phi_1781_ = _e524;
                } else {
                    phi_1781_ = _e502;
                }
                let _e530 = phi_1781_;
                let _e531 = bitcast<u32>(_e527);
                let _e533 = (bitcast<u32>(_e514) * _e494);
                let _e534 = (bitcast<u32>(_e530) * _e494);
                let _e539 = ((_e533 + _e515) + _e500);
                let _e540 = ((_e533 + _e531) + _e500);
                let _e541 = ((_e534 + _e515) + _e500);
                let _e542 = ((_e534 + _e531) + _e500);
                if (_e539 < _e55) {
                } else {
                    return;
                }
                let _e546 = map.member[(0u + _e539)];
                if (_e540 < _e55) {
                } else {
                    return;
                }
                let _e550 = map.member[(0u + _e540)];
                if (_e541 < _e55) {
                } else {
                    return;
                }
                let _e554 = map.member[(0u + _e541)];
                if (_e542 < _e55) {
                } else {
                    return;
                }
                let _e558 = map.member[(0u + _e542)];
                let _e560 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e546, _e550, _e554, _e558), vec4<f32>(((1f - _e461) * (1f - _e462)), (_e461 * (1f - _e462)), ((1f - _e461) * _e462), (_e461 * _e462)), _e401);
                let _e562 = p.member.epsilon;
                if (_e560 <= _e562) {
                    phi_1832_ = true;
                } else {
                    phi_1832_ = (_e560 >= (1f - _e562));
                }
                let _e567 = phi_1832_;
                if ((bitcast<u32>(_e560) & 2147483647u) > 2139095040u) {
                    phi_1840_ = true;
                } else {
                    phi_1840_ = !(_e567);
                }
                let _e573 = phi_1840_;
                if _e573 {
                    if (_e560 > 0f) {
                        if (_e560 < 1f) {
                            phi_1852_ = false;
                        } else {
                            phi_1852_ = true;
                        }
                        let _e577 = phi_1852_;
                        phi_1853_ = _e577;
                    } else {
                        phi_1853_ = true;
                    }
                    let _e579 = phi_1853_;
                    if _e579 {
                        phi_1857_ = 0.5f;
                    } else {
                        phi_1857_ = _e560;
                    }
                    let _e581 = phi_1857_;
                    phi_1865_ = evaluate_Verdict(_e581, true);
                } else {
                    if (_e560 > 0.5f) {
                        phi_1863_ = 1f;
                    } else {
                        phi_1863_ = 0f;
                    }
                    let _e585 = phi_1863_;
                    phi_1865_ = evaluate_Verdict(_e585, false);
                }
                let _e588 = phi_1865_;
                phi_1870_ = evaluate_Verdict(_e588.visibility, _e588.is_doubted);
            } else {
                phi_1870_ = evaluate_Verdict(0.5f, true);
            }
            let _e594 = phi_1870_;
            phi_1871_ = _e594;
        }
        let _e596 = phi_1871_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e596.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
