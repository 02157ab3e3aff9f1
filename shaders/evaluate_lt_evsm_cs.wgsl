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

struct type_28 {
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
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_28;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

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
        let _e60 = phi_145_;
        let _e62 = phi_146_;
        phi_147_ = _e60;
        phi_148_ = _e62;
    } else {
        phi_147_ = lt_bvh_traverse_Tree();
        phi_148_ = true;
    }
    let _e64 = phi_147_;
    let _e66 = phi_148_;
    if _e66 {
        phi_153_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_153_ = _e64;
    }
    let _e71 = phi_153_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_333_: bool;
    var phi_337_: f32;
    var phi_356_: f32;
    var phi_361_: f32;
    var phi_383_: f32;
    var phi_388_: f32;
    var phi_389_: bool;
    var phi_390_: f32;
    var phi_391_: bool;
    var phi_395_: f32;
    var phi_433_: f32;
    var phi_444_: f32;
    var phi_449_: f32;
    var phi_471_: f32;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_478_: f32;
    var phi_479_: bool;
    var phi_483_: f32;
    var phi_521_: f32;
    var phi_532_: f32;
    var phi_537_: f32;
    var phi_559_: f32;
    var phi_564_: f32;
    var phi_565_: bool;
    var phi_566_: f32;
    var phi_567_: bool;
    var phi_571_: f32;
    var phi_609_: f32;
    var phi_620_: f32;
    var phi_625_: f32;
    var phi_647_: f32;
    var phi_652_: f32;
    var phi_653_: bool;
    var phi_654_: f32;
    var phi_655_: bool;
    var phi_659_: f32;
    var phi_697_: f32;
    var phi_750_: bool;
    var phi_754_: f32;
    var phi_766_: bool;
    var phi_773_: f32;
    var phi_786_: bool;
    var phi_790_: f32;
    var phi_810_: f32;
    var phi_815_: f32;
    var phi_837_: f32;
    var phi_842_: f32;
    var phi_843_: bool;
    var phi_844_: f32;
    var phi_845_: bool;
    var phi_849_: f32;
    var phi_887_: f32;
    var phi_898_: f32;
    var phi_903_: f32;
    var phi_925_: f32;
    var phi_930_: f32;
    var phi_931_: bool;
    var phi_932_: f32;
    var phi_933_: bool;
    var phi_937_: f32;
    var phi_975_: f32;
    var phi_986_: f32;
    var phi_991_: f32;
    var phi_1013_: f32;
    var phi_1018_: f32;
    var phi_1019_: bool;
    var phi_1020_: f32;
    var phi_1021_: bool;
    var phi_1025_: f32;
    var phi_1063_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1101_: f32;
    var phi_1106_: f32;
    var phi_1107_: bool;
    var phi_1108_: f32;
    var phi_1109_: bool;
    var phi_1113_: f32;
    var phi_1151_: f32;
    var phi_1204_: bool;
    var phi_1208_: f32;
    var phi_1220_: bool;
    var phi_1227_: f32;
    var phi_1238_: bool;
    var phi_1242_: f32;
    var phi_1257_: f32;
    var phi_1258_: f32;
    var phi_1259_: f32;

    let _e51 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_333_ = true;
    } else {
        let _e55 = (42f < _e51);
        if _e55 {
        }
        phi_333_ = _e55;
    }
    let _e57 = phi_333_;
    if _e57 {
        phi_337_ = 42f;
    } else {
        phi_337_ = _e51;
    }
    let _e59 = phi_337_;
    let _e61 = (_e59 * param_5.x);
    let _e63 = (_e59 * param_5.y);
    let _e65 = (_e59 * param_5.z);
    let _e67 = (_e59 * param_5.w);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_433_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_356_ = -87f;
        } else {
            phi_356_ = _e61;
        }
        let _e73 = phi_356_;
        if (_e73 > 88f) {
            phi_361_ = 88f;
        } else {
            phi_361_ = _e73;
        }
        let _e76 = phi_361_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_383_ = 1f;
            } else {
                phi_383_ = 0f;
            }
            let _e93 = phi_383_;
            if (_e78 < 8388608f) {
                phi_388_ = (_e90 - _e93);
                phi_389_ = false;
            } else {
                phi_388_ = f32();
                phi_389_ = true;
            }
            let _e96 = phi_388_;
            let _e98 = phi_389_;
            phi_390_ = _e96;
            phi_391_ = _e98;
        } else {
            phi_390_ = f32();
            phi_391_ = true;
        }
        let _e100 = phi_390_;
        let _e102 = phi_391_;
        if _e102 {
            phi_395_ = _e78;
        } else {
            phi_395_ = _e100;
        }
        let _e104 = phi_395_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_433_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_433_;
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_521_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_444_ = -87f;
        } else {
            phi_444_ = _e63;
        }
        let _e150 = phi_444_;
        if (_e150 > 88f) {
            phi_449_ = 88f;
        } else {
            phi_449_ = _e150;
        }
        let _e153 = phi_449_;
        let _e155 = ((_e153 * 1.442695f) + 0.5f);
        if (_e155 > -8388608f) {
            let _e167 = f32(select(0i, select(select(i32(_e155), i32(-2147483648), (_e155 < bitcast<f32>(3472883712u))), 2147483647i, (_e155 > bitcast<f32>(1325400063u))), (_e155 == _e155)));
            if (_e167 > _e155) {
                phi_471_ = 1f;
            } else {
                phi_471_ = 0f;
            }
            let _e170 = phi_471_;
            if (_e155 < 8388608f) {
                phi_476_ = (_e167 - _e170);
                phi_477_ = false;
            } else {
                phi_476_ = f32();
                phi_477_ = true;
            }
            let _e173 = phi_476_;
            let _e175 = phi_477_;
            phi_478_ = _e173;
            phi_479_ = _e175;
        } else {
            phi_478_ = f32();
            phi_479_ = true;
        }
        let _e177 = phi_478_;
        let _e179 = phi_479_;
        if _e179 {
            phi_483_ = _e155;
        } else {
            phi_483_ = _e177;
        }
        let _e181 = phi_483_;
        let _e185 = ((_e153 - (_e181 * 0.69314575f)) - (_e181 * 0.0000014286068f));
        phi_521_ = ((((((((((((((((1f / 5040f) * _e185) + (1f / 720f)) * _e185) + (1f / 120f)) * _e185) + (1f / 24f)) * _e185) + (1f / 6f)) * _e185) + 0.5f) * _e185) + 1f) * _e185) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e181), i32(-2147483648), (_e181 < bitcast<f32>(3472883712u))), 2147483647i, (_e181 > bitcast<f32>(1325400063u))), (_e181 == _e181)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e221 = phi_521_;
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_609_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_532_ = -87f;
        } else {
            phi_532_ = _e65;
        }
        let _e227 = phi_532_;
        if (_e227 > 88f) {
            phi_537_ = 88f;
        } else {
            phi_537_ = _e227;
        }
        let _e230 = phi_537_;
        let _e232 = ((_e230 * 1.442695f) + 0.5f);
        if (_e232 > -8388608f) {
            let _e244 = f32(select(0i, select(select(i32(_e232), i32(-2147483648), (_e232 < bitcast<f32>(3472883712u))), 2147483647i, (_e232 > bitcast<f32>(1325400063u))), (_e232 == _e232)));
            if (_e244 > _e232) {
                phi_559_ = 1f;
            } else {
                phi_559_ = 0f;
            }
            let _e247 = phi_559_;
            if (_e232 < 8388608f) {
                phi_564_ = (_e244 - _e247);
                phi_565_ = false;
            } else {
                phi_564_ = f32();
                phi_565_ = true;
            }
            let _e250 = phi_564_;
            let _e252 = phi_565_;
            phi_566_ = _e250;
            phi_567_ = _e252;
        } else {
            phi_566_ = f32();
            phi_567_ = true;
        }
        let _e254 = phi_566_;
        let _e256 = phi_567_;
        if _e256 {
            phi_571_ = _e232;
        } else {
            phi_571_ = _e254;
        }
        let _e258 = phi_571_;
        let _e262 = ((_e230 - (_e258 * 0.69314575f)) - (_e258 * 0.0000014286068f));
        phi_609_ = ((((((((((((((((1f / 5040f) * _e262) + (1f / 720f)) * _e262) + (1f / 120f)) * _e262) + (1f / 24f)) * _e262) + (1f / 6f)) * _e262) + 0.5f) * _e262) + 1f) * _e262) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < bitcast<f32>(3472883712u))), 2147483647i, (_e258 > bitcast<f32>(1325400063u))), (_e258 == _e258)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e298 = phi_609_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_697_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_620_ = -87f;
        } else {
            phi_620_ = _e67;
        }
        let _e304 = phi_620_;
        if (_e304 > 88f) {
            phi_625_ = 88f;
        } else {
            phi_625_ = _e304;
        }
        let _e307 = phi_625_;
        let _e309 = ((_e307 * 1.442695f) + 0.5f);
        if (_e309 > -8388608f) {
            let _e321 = f32(select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < bitcast<f32>(3472883712u))), 2147483647i, (_e309 > bitcast<f32>(1325400063u))), (_e309 == _e309)));
            if (_e321 > _e309) {
                phi_647_ = 1f;
            } else {
                phi_647_ = 0f;
            }
            let _e324 = phi_647_;
            if (_e309 < 8388608f) {
                phi_652_ = (_e321 - _e324);
                phi_653_ = false;
            } else {
                phi_652_ = f32();
                phi_653_ = true;
            }
            let _e327 = phi_652_;
            let _e329 = phi_653_;
            phi_654_ = _e327;
            phi_655_ = _e329;
        } else {
            phi_654_ = f32();
            phi_655_ = true;
        }
        let _e331 = phi_654_;
        let _e333 = phi_655_;
        if _e333 {
            phi_659_ = _e309;
        } else {
            phi_659_ = _e331;
        }
        let _e335 = phi_659_;
        let _e339 = ((_e307 - (_e335 * 0.69314575f)) - (_e335 * 0.0000014286068f));
        phi_697_ = ((((((((((((((((1f / 5040f) * _e339) + (1f / 720f)) * _e339) + (1f / 120f)) * _e339) + (1f / 24f)) * _e339) + (1f / 6f)) * _e339) + 0.5f) * _e339) + 1f) * _e339) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < bitcast<f32>(3472883712u))), 2147483647i, (_e335 > bitcast<f32>(1325400063u))), (_e335 == _e335)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e375 = phi_697_;
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
        phi_750_ = true;
    } else {
        let _e421 = (_e387 > _e417);
        if _e421 {
        }
        phi_750_ = _e421;
    }
    let _e423 = phi_750_;
    if _e423 {
        phi_754_ = _e387;
    } else {
        phi_754_ = _e417;
    }
    let _e425 = phi_754_;
    let _e426 = -(_e398);
    if (_e426 <= 0f) {
        let _e430 = ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u);
        if _e430 {
        }
        phi_766_ = _e430;
    } else {
        phi_766_ = true;
    }
    let _e432 = phi_766_;
    if _e432 {
        phi_773_ = (_e425 / (_e425 + (_e426 * _e426)));
    } else {
        phi_773_ = 1f;
    }
    let _e437 = phi_773_;
    let _e439 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_786_ = true;
    } else {
        let _e443 = (42f < _e439);
        if _e443 {
        }
        phi_786_ = _e443;
    }
    let _e445 = phi_786_;
    if _e445 {
        phi_790_ = 42f;
    } else {
        phi_790_ = _e439;
    }
    let _e447 = phi_790_;
    let _e448 = -(_e447);
    let _e450 = (_e448 * param_5.x);
    let _e452 = (_e448 * param_5.y);
    let _e454 = (_e448 * param_5.z);
    let _e456 = (_e448 * param_5.w);
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_887_ = _e450;
    } else {
        if (_e450 < -87f) {
            phi_810_ = -87f;
        } else {
            phi_810_ = _e450;
        }
        let _e462 = phi_810_;
        if (_e462 > 88f) {
            phi_815_ = 88f;
        } else {
            phi_815_ = _e462;
        }
        let _e465 = phi_815_;
        let _e467 = ((_e465 * 1.442695f) + 0.5f);
        if (_e467 > -8388608f) {
            let _e479 = f32(select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < bitcast<f32>(3472883712u))), 2147483647i, (_e467 > bitcast<f32>(1325400063u))), (_e467 == _e467)));
            if (_e479 > _e467) {
                phi_837_ = 1f;
            } else {
                phi_837_ = 0f;
            }
            let _e482 = phi_837_;
            if (_e467 < 8388608f) {
                phi_842_ = (_e479 - _e482);
                phi_843_ = false;
            } else {
                phi_842_ = f32();
                phi_843_ = true;
            }
            let _e485 = phi_842_;
            let _e487 = phi_843_;
            phi_844_ = _e485;
            phi_845_ = _e487;
        } else {
            phi_844_ = f32();
            phi_845_ = true;
        }
        let _e489 = phi_844_;
        let _e491 = phi_845_;
        if _e491 {
            phi_849_ = _e467;
        } else {
            phi_849_ = _e489;
        }
        let _e493 = phi_849_;
        let _e497 = ((_e465 - (_e493 * 0.69314575f)) - (_e493 * 0.0000014286068f));
        phi_887_ = ((((((((((((((((1f / 5040f) * _e497) + (1f / 720f)) * _e497) + (1f / 120f)) * _e497) + (1f / 24f)) * _e497) + (1f / 6f)) * _e497) + 0.5f) * _e497) + 1f) * _e497) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < bitcast<f32>(3472883712u))), 2147483647i, (_e493 > bitcast<f32>(1325400063u))), (_e493 == _e493)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e533 = phi_887_;
    if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
        phi_975_ = _e452;
    } else {
        if (_e452 < -87f) {
            phi_898_ = -87f;
        } else {
            phi_898_ = _e452;
        }
        let _e539 = phi_898_;
        if (_e539 > 88f) {
            phi_903_ = 88f;
        } else {
            phi_903_ = _e539;
        }
        let _e542 = phi_903_;
        let _e544 = ((_e542 * 1.442695f) + 0.5f);
        if (_e544 > -8388608f) {
            let _e556 = f32(select(0i, select(select(i32(_e544), i32(-2147483648), (_e544 < bitcast<f32>(3472883712u))), 2147483647i, (_e544 > bitcast<f32>(1325400063u))), (_e544 == _e544)));
            if (_e556 > _e544) {
                phi_925_ = 1f;
            } else {
                phi_925_ = 0f;
            }
            let _e559 = phi_925_;
            if (_e544 < 8388608f) {
                phi_930_ = (_e556 - _e559);
                phi_931_ = false;
            } else {
                phi_930_ = f32();
                phi_931_ = true;
            }
            let _e562 = phi_930_;
            let _e564 = phi_931_;
            phi_932_ = _e562;
            phi_933_ = _e564;
        } else {
            phi_932_ = f32();
            phi_933_ = true;
        }
        let _e566 = phi_932_;
        let _e568 = phi_933_;
        if _e568 {
            phi_937_ = _e544;
        } else {
            phi_937_ = _e566;
        }
        let _e570 = phi_937_;
        let _e574 = ((_e542 - (_e570 * 0.69314575f)) - (_e570 * 0.0000014286068f));
        phi_975_ = ((((((((((((((((1f / 5040f) * _e574) + (1f / 720f)) * _e574) + (1f / 120f)) * _e574) + (1f / 24f)) * _e574) + (1f / 6f)) * _e574) + 0.5f) * _e574) + 1f) * _e574) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e570), i32(-2147483648), (_e570 < bitcast<f32>(3472883712u))), 2147483647i, (_e570 > bitcast<f32>(1325400063u))), (_e570 == _e570)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e610 = phi_975_;
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_1063_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_986_ = -87f;
        } else {
            phi_986_ = _e454;
        }
        let _e616 = phi_986_;
        if (_e616 > 88f) {
            phi_991_ = 88f;
        } else {
            phi_991_ = _e616;
        }
        let _e619 = phi_991_;
        let _e621 = ((_e619 * 1.442695f) + 0.5f);
        if (_e621 > -8388608f) {
            let _e633 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
            if (_e633 > _e621) {
                phi_1013_ = 1f;
            } else {
                phi_1013_ = 0f;
            }
            let _e636 = phi_1013_;
            if (_e621 < 8388608f) {
                phi_1018_ = (_e633 - _e636);
                phi_1019_ = false;
            } else {
                phi_1018_ = f32();
                phi_1019_ = true;
            }
            let _e639 = phi_1018_;
            let _e641 = phi_1019_;
            phi_1020_ = _e639;
            phi_1021_ = _e641;
        } else {
            phi_1020_ = f32();
            phi_1021_ = true;
        }
        let _e643 = phi_1020_;
        let _e645 = phi_1021_;
        if _e645 {
            phi_1025_ = _e621;
        } else {
            phi_1025_ = _e643;
        }
        let _e647 = phi_1025_;
        let _e651 = ((_e619 - (_e647 * 0.69314575f)) - (_e647 * 0.0000014286068f));
        phi_1063_ = ((((((((((((((((1f / 5040f) * _e651) + (1f / 720f)) * _e651) + (1f / 120f)) * _e651) + (1f / 24f)) * _e651) + (1f / 6f)) * _e651) + 0.5f) * _e651) + 1f) * _e651) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e687 = phi_1063_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_1151_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_1074_ = -87f;
        } else {
            phi_1074_ = _e456;
        }
        let _e693 = phi_1074_;
        if (_e693 > 88f) {
            phi_1079_ = 88f;
        } else {
            phi_1079_ = _e693;
        }
        let _e696 = phi_1079_;
        let _e698 = ((_e696 * 1.442695f) + 0.5f);
        if (_e698 > -8388608f) {
            let _e710 = f32(select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < bitcast<f32>(3472883712u))), 2147483647i, (_e698 > bitcast<f32>(1325400063u))), (_e698 == _e698)));
            if (_e710 > _e698) {
                phi_1101_ = 1f;
            } else {
                phi_1101_ = 0f;
            }
            let _e713 = phi_1101_;
            if (_e698 < 8388608f) {
                phi_1106_ = (_e710 - _e713);
                phi_1107_ = false;
            } else {
                phi_1106_ = f32();
                phi_1107_ = true;
            }
            let _e716 = phi_1106_;
            let _e718 = phi_1107_;
            phi_1108_ = _e716;
            phi_1109_ = _e718;
        } else {
            phi_1108_ = f32();
            phi_1109_ = true;
        }
        let _e720 = phi_1108_;
        let _e722 = phi_1109_;
        if _e722 {
            phi_1113_ = _e698;
        } else {
            phi_1113_ = _e720;
        }
        let _e724 = phi_1113_;
        let _e728 = ((_e696 - (_e724 * 0.69314575f)) - (_e724 * 0.0000014286068f));
        phi_1151_ = ((((((((((((((((1f / 5040f) * _e728) + (1f / 720f)) * _e728) + (1f / 120f)) * _e728) + (1f / 24f)) * _e728) + (1f / 6f)) * _e728) + 0.5f) * _e728) + 1f) * _e728) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < bitcast<f32>(3472883712u))), 2147483647i, (_e724 > bitcast<f32>(1325400063u))), (_e724 == _e724)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e764 = phi_1151_;
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
        phi_1204_ = true;
    } else {
        let _e810 = (_e776 > _e806);
        if _e810 {
        }
        phi_1204_ = _e810;
    }
    let _e812 = phi_1204_;
    if _e812 {
        phi_1208_ = _e776;
    } else {
        phi_1208_ = _e806;
    }
    let _e814 = phi_1208_;
    let _e815 = -(_e787);
    if (_e815 <= 0f) {
        let _e819 = ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u);
        if _e819 {
        }
        phi_1220_ = _e819;
    } else {
        phi_1220_ = true;
    }
    let _e821 = phi_1220_;
    if _e821 {
        phi_1227_ = (_e814 / (_e814 + (_e815 * _e815)));
    } else {
        phi_1227_ = 1f;
    }
    let _e826 = phi_1227_;
    if ((bitcast<u32>(_e826) & 2147483647u) > 2139095040u) {
        phi_1238_ = true;
    } else {
        let _e830 = (_e826 < _e437);
        if _e830 {
        }
        phi_1238_ = _e830;
    }
    let _e832 = phi_1238_;
    if _e832 {
        phi_1242_ = _e826;
    } else {
        phi_1242_ = _e437;
    }
    let _e834 = phi_1242_;
    if ((bitcast<u32>(_e834) & 2147483647u) > 2139095040u) {
        phi_1259_ = _e834;
    } else {
        if (_e834 < 0f) {
            phi_1258_ = 0f;
        } else {
            if (_e834 > 1f) {
                phi_1257_ = 1f;
            } else {
                phi_1257_ = _e834;
            }
            let _e841 = phi_1257_;
            phi_1258_ = _e841;
        }
        let _e843 = phi_1258_;
        phi_1259_ = _e843;
    }
    let _e845 = phi_1259_;
    return _e845;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_184_: f32;
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
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_307_: bool;
    var phi_311_: bool;
    var phi_316_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_184_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_183_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_182_ = 1f;
            } else {
                phi_182_ = param_10;
            }
            let _e57 = phi_182_;
            phi_183_ = _e57;
        }
        let _e59 = phi_183_;
        phi_184_ = _e59;
    }
    let _e61 = phi_184_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_202_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_8.x;
            }
            let _e69 = phi_200_;
            phi_201_ = _e69;
        }
        let _e71 = phi_201_;
        phi_202_ = _e71;
    }
    let _e73 = phi_202_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_220_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_8.y;
            }
            let _e81 = phi_218_;
            phi_219_ = _e81;
        }
        let _e83 = phi_219_;
        phi_220_ = _e83;
    }
    let _e85 = phi_220_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_238_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_8.z;
            }
            let _e93 = phi_236_;
            phi_237_ = _e93;
        }
        let _e95 = phi_237_;
        phi_238_ = _e95;
    }
    let _e97 = phi_238_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_256_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_8.w;
            }
            let _e105 = phi_254_;
            phi_255_ = _e105;
        }
        let _e107 = phi_255_;
        phi_256_ = _e107;
    }
    let _e109 = phi_256_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_293_ = !(((bitcast<u32>(((((_e110 * param_9.x) + (_e111 * param_9.y)) + (_e112 * param_9.z)) + (_e113 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_294_ = false;
                } else {
                    phi_293_ = bool();
                    phi_294_ = true;
                }
                let _e135 = phi_293_;
                let _e137 = phi_294_;
                phi_295_ = _e135;
                phi_296_ = false;
                phi_297_ = _e137;
            } else {
                phi_295_ = bool();
                phi_296_ = true;
                phi_297_ = false;
            }
            let _e139 = phi_295_;
            let _e141 = phi_296_;
            let _e143 = phi_297_;
            phi_298_ = _e139;
            phi_299_ = _e141;
            phi_300_ = _e143;
        } else {
            phi_298_ = bool();
            phi_299_ = true;
            phi_300_ = false;
        }
        let _e145 = phi_298_;
        let _e147 = phi_299_;
        let _e149 = phi_300_;
        phi_301_ = _e145;
        phi_302_ = _e147;
        phi_303_ = _e149;
    } else {
        phi_301_ = bool();
        phi_302_ = true;
        phi_303_ = false;
    }
    let _e151 = phi_301_;
    let _e153 = phi_302_;
    let _e155 = phi_303_;
    if _e153 {
        phi_307_ = true;
    } else {
        phi_307_ = _e155;
    }
    let _e157 = phi_307_;
    if _e157 {
        phi_311_ = false;
    } else {
        phi_311_ = _e151;
    }
    let _e159 = phi_311_;
    if _e159 {
        phi_316_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e110, _e111, _e112, _e113), param_9);
        phi_316_ = _e160;
    }
    let _e162 = phi_316_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1316_: bool;
    var phi_1317_: bool;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1323_: bool;
    var phi_1367_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1371_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1445_: bool;
    var phi_1454_: bool;
    var phi_1463_: bool;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1468_: bool;
    var phi_1469_: bool;
    var phi_1473_: bool;
    var phi_1563_: f32;
    var phi_1566_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1601_: bool;
    var phi_1602_: f32;
    var phi_1603_: bool;
    var phi_1607_: f32;
    var phi_1627_: f32;
    var phi_1632_: f32;
    var phi_1633_: bool;
    var phi_1634_: f32;
    var phi_1635_: bool;
    var phi_1639_: f32;
    var phi_1691_: i32;
    var phi_1696_: i32;
    var phi_1701_: i32;
    var phi_1706_: i32;
    var phi_1715_: i32;
    var phi_1720_: i32;
    var phi_1725_: i32;
    var phi_1730_: i32;
    var phi_1781_: bool;
    var phi_1789_: bool;
    var phi_1801_: bool;
    var phi_1802_: bool;
    var phi_1806_: f32;
    var phi_1812_: f32;
    var phi_1814_: evaluate_Verdict;
    var phi_1819_: evaluate_Verdict;
    var phi_1820_: evaluate_Verdict;

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
        let _e76 = p.member.light;
        let _e79 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e81 = global[0u];
        if (_e79 == _e81) {
            let _e84 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e86 = global[1u];
            if (_e84 == _e86) {
                let _e89 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e91 = global[2u];
                phi_1316_ = (_e89 == _e91);
                phi_1317_ = false;
            } else {
                phi_1316_ = bool();
                phi_1317_ = true;
            }
            let _e94 = phi_1316_;
            let _e96 = phi_1317_;
            phi_1318_ = _e94;
            phi_1319_ = _e96;
        } else {
            phi_1318_ = bool();
            phi_1319_ = true;
        }
        let _e98 = phi_1318_;
        let _e100 = phi_1319_;
        if _e100 {
            phi_1323_ = false;
        } else {
            phi_1323_ = _e98;
        }
        let _e102 = phi_1323_;
        if !(_e102) {
            let _e105 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e107 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e105.x * (_e76.x - (_e107.x * _e76.w))) + (_e105.y * (_e76.y - (_e107.y * _e76.w)))) + (_e105.z * (_e76.z - (_e107.z * _e76.w)))) > 0f) {
                let _e131 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_1367_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, ((_e131 & 1u) == 0u));
            } else {
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
                phi_1367_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
            }
            let _e165 = phi_1367_;
            phi_1371_ = _e165;
        } else {
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
            phi_1371_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, true);
        }
        let _e182 = phi_1371_;
        if _e182.unnamed_1 {
            phi_1820_ = evaluate_Verdict(_e182.unnamed.visibility, _e182.unnamed.is_doubted);
        } else {
            let _e190 = samples.member[(0u + _e64.first_primitive)].position;
            let _e208 = ((((_e74.projection.row_w.x * _e190.x) + (_e74.projection.row_w.y * _e190.y)) + (_e74.projection.row_w.z * _e190.z)) + (_e74.projection.row_w.w * 1f));
            let _e222 = (((((_e74.projection.row_x.x * _e190.x) + (_e74.projection.row_x.y * _e190.y)) + (_e74.projection.row_x.z * _e190.z)) + (_e74.projection.row_x.w * 1f)) / _e208);
            let _e236 = (((((_e74.projection.row_y.x * _e190.x) + (_e74.projection.row_y.y * _e190.y)) + (_e74.projection.row_y.z * _e190.z)) + (_e74.projection.row_y.w * 1f)) / _e208);
            let _e249 = ((((_e74.projection.row_z.x * _e190.x) + (_e74.projection.row_z.y * _e190.y)) + (_e74.projection.row_z.z * _e190.z)) + (_e74.projection.row_z.w * 1f));
            if (_e208 > 0f) {
                if (_e222 >= 0f) {
                    phi_1445_ = (_e222 <= 1f);
                } else {
                    phi_1445_ = false;
                }
                let _e254 = phi_1445_;
                if _e254 {
                    if (_e236 >= 0f) {
                        phi_1454_ = (_e236 <= 1f);
                    } else {
                        phi_1454_ = false;
                    }
                    let _e258 = phi_1454_;
                    if _e258 {
                        if (_e249 >= 0f) {
                            phi_1463_ = (_e249 <= 1f);
                        } else {
                            phi_1463_ = false;
                        }
                        let _e262 = phi_1463_;
                        phi_1464_ = _e262;
                        phi_1465_ = false;
                    } else {
                        phi_1464_ = bool();
                        phi_1465_ = true;
                    }
                    let _e264 = phi_1464_;
                    let _e266 = phi_1465_;
                    phi_1466_ = _e264;
                    phi_1467_ = _e266;
                } else {
                    phi_1466_ = bool();
                    phi_1467_ = true;
                }
                let _e268 = phi_1466_;
                let _e270 = phi_1467_;
                phi_1468_ = _e268;
                phi_1469_ = _e270;
            } else {
                phi_1468_ = bool();
                phi_1469_ = true;
            }
            let _e272 = phi_1468_;
            let _e274 = phi_1469_;
            if _e274 {
                phi_1473_ = false;
            } else {
                phi_1473_ = _e272;
            }
            let _e276 = phi_1473_;
            if _e276 {
                if (0f > 0f) {
                    let _e279 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e281 = p.member.map_size;
                    let _e351 = ((abs(((((_e70.row_x.x * _e279.x) + (_e70.row_x.y * _e279.y)) + (_e70.row_x.z * _e279.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e279.x) + (_e70.row_y.y * _e279.y)) + (_e70.row_y.z * _e279.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e279.x) + (_e70.row_z.y * _e279.y)) + (_e70.row_z.z * _e279.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e281)));
                    if (_e351 < 0.002f) {
                        phi_1563_ = _e351;
                    } else {
                        phi_1563_ = 0.002f;
                    }
                    let _e354 = phi_1563_;
                    phi_1566_ = (_e249 - (0f * _e354));
                } else {
                    phi_1566_ = _e249;
                }
                let _e358 = phi_1566_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e222 * _e361) - 0.5f);
                let _e365 = ((_e236 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_1595_ = 1f;
                    } else {
                        phi_1595_ = 0f;
                    }
                    let _e380 = phi_1595_;
                    if (_e364 < 8388608f) {
                        phi_1600_ = (_e377 - _e380);
                        phi_1601_ = false;
                    } else {
                        phi_1600_ = f32();
                        phi_1601_ = true;
                    }
                    let _e383 = phi_1600_;
                    let _e385 = phi_1601_;
                    phi_1602_ = _e383;
                    phi_1603_ = _e385;
                } else {
                    phi_1602_ = f32();
                    phi_1603_ = true;
                }
                let _e387 = phi_1602_;
                let _e389 = phi_1603_;
                if _e389 {
                    phi_1607_ = _e364;
                } else {
                    phi_1607_ = _e387;
                }
                let _e391 = phi_1607_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_1627_ = 1f;
                    } else {
                        phi_1627_ = 0f;
                    }
                    let _e406 = phi_1627_;
                    if (_e365 < 8388608f) {
                        phi_1632_ = (_e403 - _e406);
                        phi_1633_ = false;
                    } else {
                        phi_1632_ = f32();
                        phi_1633_ = true;
                    }
                    let _e409 = phi_1632_;
                    let _e411 = phi_1633_;
                    phi_1634_ = _e409;
                    phi_1635_ = _e411;
                } else {
                    phi_1634_ = f32();
                    phi_1635_ = true;
                }
                let _e413 = phi_1634_;
                let _e415 = phi_1635_;
                if _e415 {
                    phi_1639_ = _e365;
                } else {
                    phi_1639_ = _e413;
                }
                let _e417 = phi_1639_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e448 = p.member.test;
                let _e449 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e448);
                let _e451 = p.member.map_size;
                local = lt_math_Evsm(_e449.positive_exponent, _e449.negative_exponent, _e449.min_variance);
                let _e457 = ((0u * _e451) * _e451);
                let _e459 = (bitcast<i32>(_e451) - 1i);
                if (_e428 > 0i) {
                    phi_1691_ = _e428;
                } else {
                    phi_1691_ = 0i;
                }
                let _e462 = phi_1691_;
                if (_e437 > 0i) {
                    phi_1696_ = _e437;
                } else {
                    phi_1696_ = 0i;
                }
                let _e465 = phi_1696_;
                if (_e462 < _e459) {
                    phi_1701_ = _e462;
                } else {
                    phi_1701_ = _e459;
                }
                let _e468 = phi_1701_;
                if (_e465 < _e459) {
                    phi_1706_ = _e465;
                } else {
                    phi_1706_ = _e459;
                }
                let _e471 = phi_1706_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (_e428 + 1i);
                let _e475 = (_e437 + 1i);
                if (_e474 > 0i) {
                    phi_1715_ = _e474;
                } else {
                    phi_1715_ = 0i;
                }
                let _e478 = phi_1715_;
                if (_e475 > 0i) {
                    phi_1720_ = _e475;
                } else {
                    phi_1720_ = 0i;
                }
                let _e481 = phi_1720_;
                if (_e478 < _e459) {
                    phi_1725_ = _e478;
                } else {
                    phi_1725_ = _e459;
                }
                let _e484 = phi_1725_;
                if (_e481 < _e459) {
                    phi_1730_ = _e481;
                } else {
                    phi_1730_ = _e459;
                }
                let _e487 = phi_1730_;
                let _e488 = bitcast<u32>(_e484);
                let _e490 = (bitcast<u32>(_e471) * _e451);
                let _e491 = (bitcast<u32>(_e487) * _e451);
                let _e496 = ((_e490 + _e472) + _e457);
                let _e497 = ((_e490 + _e488) + _e457);
                let _e498 = ((_e491 + _e472) + _e457);
                let _e499 = ((_e491 + _e488) + _e457);
                if (_e496 < _e55) {
                } else {
                    return;
                }
                let _e503 = map.member[(0u + _e496)];
                if (_e497 < _e55) {
                } else {
                    return;
                }
                let _e507 = map.member[(0u + _e497)];
                if (_e498 < _e55) {
                } else {
                    return;
                }
                let _e511 = map.member[(0u + _e498)];
                if (_e499 < _e55) {
                } else {
                    return;
                }
                let _e515 = map.member[(0u + _e499)];
                let _e517 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e503, _e507, _e511, _e515), vec4<f32>(((1f - _e418) * (1f - _e419)), (_e418 * (1f - _e419)), ((1f - _e418) * _e419), (_e418 * _e419)), _e358);
                let _e519 = p.member.epsilon;
                if (_e517 <= _e519) {
                    phi_1781_ = true;
                } else {
                    phi_1781_ = (_e517 >= (1f - _e519));
                }
                let _e524 = phi_1781_;
                if ((bitcast<u32>(_e517) & 2147483647u) > 2139095040u) {
                    phi_1789_ = true;
                } else {
                    phi_1789_ = !(_e524);
                }
                let _e530 = phi_1789_;
                if _e530 {
                    if (_e517 > 0f) {
                        if (_e517 < 1f) {
                            phi_1801_ = false;
                        } else {
                            phi_1801_ = true;
                        }
                        let _e534 = phi_1801_;
                        phi_1802_ = _e534;
                    } else {
                        phi_1802_ = true;
                    }
                    let _e536 = phi_1802_;
                    if _e536 {
                        phi_1806_ = 0.5f;
                    } else {
                        phi_1806_ = _e517;
                    }
                    let _e538 = phi_1806_;
                    phi_1814_ = evaluate_Verdict(_e538, true);
                } else {
                    if (_e517 > 0.5f) {
                        phi_1812_ = 1f;
                    } else {
                        phi_1812_ = 0f;
                    }
                    let _e542 = phi_1812_;
                    phi_1814_ = evaluate_Verdict(_e542, false);
                }
                let _e545 = phi_1814_;
                phi_1819_ = evaluate_Verdict(_e545.visibility, _e545.is_doubted);
            } else {
                phi_1819_ = evaluate_Verdict(0.5f, true);
            }
            let _e551 = phi_1819_;
            phi_1820_ = _e551;
        }
        let _e553 = phi_1820_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e553.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
