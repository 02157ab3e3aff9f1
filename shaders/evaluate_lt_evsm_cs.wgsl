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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_28 {
    member: abi_ShadowParams,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    var phi_144_: lt_bvh_traverse_Tree;
    var phi_145_: bool;
    var phi_146_: lt_bvh_traverse_Tree;
    var phi_147_: bool;
    var phi_152_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_144_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_145_ = false;
        } else {
            phi_144_ = lt_bvh_traverse_Tree();
            phi_145_ = true;
        }
        let _e60 = phi_144_;
        let _e62 = phi_145_;
        phi_146_ = _e60;
        phi_147_ = _e62;
    } else {
        phi_146_ = lt_bvh_traverse_Tree();
        phi_147_ = true;
    }
    let _e64 = phi_146_;
    let _e66 = phi_147_;
    if _e66 {
        phi_152_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_152_ = _e64;
    }
    let _e71 = phi_152_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_332_: bool;
    var phi_336_: f32;
    var phi_355_: f32;
    var phi_360_: f32;
    var phi_382_: f32;
    var phi_387_: f32;
    var phi_388_: bool;
    var phi_389_: f32;
    var phi_390_: bool;
    var phi_394_: f32;
    var phi_432_: f32;
    var phi_443_: f32;
    var phi_448_: f32;
    var phi_470_: f32;
    var phi_475_: f32;
    var phi_476_: bool;
    var phi_477_: f32;
    var phi_478_: bool;
    var phi_482_: f32;
    var phi_520_: f32;
    var phi_531_: f32;
    var phi_536_: f32;
    var phi_558_: f32;
    var phi_563_: f32;
    var phi_564_: bool;
    var phi_565_: f32;
    var phi_566_: bool;
    var phi_570_: f32;
    var phi_608_: f32;
    var phi_619_: f32;
    var phi_624_: f32;
    var phi_646_: f32;
    var phi_651_: f32;
    var phi_652_: bool;
    var phi_653_: f32;
    var phi_654_: bool;
    var phi_658_: f32;
    var phi_696_: f32;
    var phi_749_: bool;
    var phi_753_: f32;
    var phi_765_: bool;
    var phi_772_: f32;
    var phi_785_: bool;
    var phi_789_: f32;
    var phi_809_: f32;
    var phi_814_: f32;
    var phi_836_: f32;
    var phi_841_: f32;
    var phi_842_: bool;
    var phi_843_: f32;
    var phi_844_: bool;
    var phi_848_: f32;
    var phi_886_: f32;
    var phi_897_: f32;
    var phi_902_: f32;
    var phi_924_: f32;
    var phi_929_: f32;
    var phi_930_: bool;
    var phi_931_: f32;
    var phi_932_: bool;
    var phi_936_: f32;
    var phi_974_: f32;
    var phi_985_: f32;
    var phi_990_: f32;
    var phi_1012_: f32;
    var phi_1017_: f32;
    var phi_1018_: bool;
    var phi_1019_: f32;
    var phi_1020_: bool;
    var phi_1024_: f32;
    var phi_1062_: f32;
    var phi_1073_: f32;
    var phi_1078_: f32;
    var phi_1100_: f32;
    var phi_1105_: f32;
    var phi_1106_: bool;
    var phi_1107_: f32;
    var phi_1108_: bool;
    var phi_1112_: f32;
    var phi_1150_: f32;
    var phi_1203_: bool;
    var phi_1207_: f32;
    var phi_1219_: bool;
    var phi_1226_: f32;
    var phi_1237_: bool;
    var phi_1241_: f32;
    var phi_1256_: f32;
    var phi_1257_: f32;
    var phi_1258_: f32;

    let _e51 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_332_ = true;
    } else {
        let _e55 = (42f < _e51);
        if _e55 {
        }
        phi_332_ = _e55;
    }
    let _e57 = phi_332_;
    if _e57 {
        phi_336_ = 42f;
    } else {
        phi_336_ = _e51;
    }
    let _e59 = phi_336_;
    let _e61 = (_e59 * param_5.x);
    let _e63 = (_e59 * param_5.y);
    let _e65 = (_e59 * param_5.z);
    let _e67 = (_e59 * param_5.w);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_432_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_355_ = -87f;
        } else {
            phi_355_ = _e61;
        }
        let _e73 = phi_355_;
        if (_e73 > 88f) {
            phi_360_ = 88f;
        } else {
            phi_360_ = _e73;
        }
        let _e76 = phi_360_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_382_ = 1f;
            } else {
                phi_382_ = 0f;
            }
            let _e93 = phi_382_;
            if (_e78 < 8388608f) {
                phi_387_ = (_e90 - _e93);
                phi_388_ = false;
            } else {
                phi_387_ = f32();
                phi_388_ = true;
            }
            let _e96 = phi_387_;
            let _e98 = phi_388_;
            phi_389_ = _e96;
            phi_390_ = _e98;
        } else {
            phi_389_ = f32();
            phi_390_ = true;
        }
        let _e100 = phi_389_;
        let _e102 = phi_390_;
        if _e102 {
            phi_394_ = _e78;
        } else {
            phi_394_ = _e100;
        }
        let _e104 = phi_394_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_432_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_432_;
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_520_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_443_ = -87f;
        } else {
            phi_443_ = _e63;
        }
        let _e150 = phi_443_;
        if (_e150 > 88f) {
            phi_448_ = 88f;
        } else {
            phi_448_ = _e150;
        }
        let _e153 = phi_448_;
        let _e155 = ((_e153 * 1.442695f) + 0.5f);
        if (_e155 > -8388608f) {
            let _e167 = f32(select(0i, select(select(i32(_e155), i32(-2147483648), (_e155 < bitcast<f32>(3472883712u))), 2147483647i, (_e155 > bitcast<f32>(1325400063u))), (_e155 == _e155)));
            if (_e167 > _e155) {
                phi_470_ = 1f;
            } else {
                phi_470_ = 0f;
            }
            let _e170 = phi_470_;
            if (_e155 < 8388608f) {
                phi_475_ = (_e167 - _e170);
                phi_476_ = false;
            } else {
                phi_475_ = f32();
                phi_476_ = true;
            }
            let _e173 = phi_475_;
            let _e175 = phi_476_;
            phi_477_ = _e173;
            phi_478_ = _e175;
        } else {
            phi_477_ = f32();
            phi_478_ = true;
        }
        let _e177 = phi_477_;
        let _e179 = phi_478_;
        if _e179 {
            phi_482_ = _e155;
        } else {
            phi_482_ = _e177;
        }
        let _e181 = phi_482_;
        let _e185 = ((_e153 - (_e181 * 0.69314575f)) - (_e181 * 0.0000014286068f));
        phi_520_ = ((((((((((((((((1f / 5040f) * _e185) + (1f / 720f)) * _e185) + (1f / 120f)) * _e185) + (1f / 24f)) * _e185) + (1f / 6f)) * _e185) + 0.5f) * _e185) + 1f) * _e185) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e181), i32(-2147483648), (_e181 < bitcast<f32>(3472883712u))), 2147483647i, (_e181 > bitcast<f32>(1325400063u))), (_e181 == _e181)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e221 = phi_520_;
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_608_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_531_ = -87f;
        } else {
            phi_531_ = _e65;
        }
        let _e227 = phi_531_;
        if (_e227 > 88f) {
            phi_536_ = 88f;
        } else {
            phi_536_ = _e227;
        }
        let _e230 = phi_536_;
        let _e232 = ((_e230 * 1.442695f) + 0.5f);
        if (_e232 > -8388608f) {
            let _e244 = f32(select(0i, select(select(i32(_e232), i32(-2147483648), (_e232 < bitcast<f32>(3472883712u))), 2147483647i, (_e232 > bitcast<f32>(1325400063u))), (_e232 == _e232)));
            if (_e244 > _e232) {
                phi_558_ = 1f;
            } else {
                phi_558_ = 0f;
            }
            let _e247 = phi_558_;
            if (_e232 < 8388608f) {
                phi_563_ = (_e244 - _e247);
                phi_564_ = false;
            } else {
                phi_563_ = f32();
                phi_564_ = true;
            }
            let _e250 = phi_563_;
            let _e252 = phi_564_;
            phi_565_ = _e250;
            phi_566_ = _e252;
        } else {
            phi_565_ = f32();
            phi_566_ = true;
        }
        let _e254 = phi_565_;
        let _e256 = phi_566_;
        if _e256 {
            phi_570_ = _e232;
        } else {
            phi_570_ = _e254;
        }
        let _e258 = phi_570_;
        let _e262 = ((_e230 - (_e258 * 0.69314575f)) - (_e258 * 0.0000014286068f));
        phi_608_ = ((((((((((((((((1f / 5040f) * _e262) + (1f / 720f)) * _e262) + (1f / 120f)) * _e262) + (1f / 24f)) * _e262) + (1f / 6f)) * _e262) + 0.5f) * _e262) + 1f) * _e262) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < bitcast<f32>(3472883712u))), 2147483647i, (_e258 > bitcast<f32>(1325400063u))), (_e258 == _e258)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e298 = phi_608_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_696_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_619_ = -87f;
        } else {
            phi_619_ = _e67;
        }
        let _e304 = phi_619_;
        if (_e304 > 88f) {
            phi_624_ = 88f;
        } else {
            phi_624_ = _e304;
        }
        let _e307 = phi_624_;
        let _e309 = ((_e307 * 1.442695f) + 0.5f);
        if (_e309 > -8388608f) {
            let _e321 = f32(select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < bitcast<f32>(3472883712u))), 2147483647i, (_e309 > bitcast<f32>(1325400063u))), (_e309 == _e309)));
            if (_e321 > _e309) {
                phi_646_ = 1f;
            } else {
                phi_646_ = 0f;
            }
            let _e324 = phi_646_;
            if (_e309 < 8388608f) {
                phi_651_ = (_e321 - _e324);
                phi_652_ = false;
            } else {
                phi_651_ = f32();
                phi_652_ = true;
            }
            let _e327 = phi_651_;
            let _e329 = phi_652_;
            phi_653_ = _e327;
            phi_654_ = _e329;
        } else {
            phi_653_ = f32();
            phi_654_ = true;
        }
        let _e331 = phi_653_;
        let _e333 = phi_654_;
        if _e333 {
            phi_658_ = _e309;
        } else {
            phi_658_ = _e331;
        }
        let _e335 = phi_658_;
        let _e339 = ((_e307 - (_e335 * 0.69314575f)) - (_e335 * 0.0000014286068f));
        phi_696_ = ((((((((((((((((1f / 5040f) * _e339) + (1f / 720f)) * _e339) + (1f / 120f)) * _e339) + (1f / 24f)) * _e339) + (1f / 6f)) * _e339) + 0.5f) * _e339) + 1f) * _e339) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < bitcast<f32>(3472883712u))), 2147483647i, (_e335 > bitcast<f32>(1325400063u))), (_e335 == _e335)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e375 = phi_696_;
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
        phi_749_ = true;
    } else {
        let _e421 = (_e387 > _e417);
        if _e421 {
        }
        phi_749_ = _e421;
    }
    let _e423 = phi_749_;
    if _e423 {
        phi_753_ = _e387;
    } else {
        phi_753_ = _e417;
    }
    let _e425 = phi_753_;
    let _e426 = -(_e398);
    if (_e426 <= 0f) {
        let _e430 = ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u);
        if _e430 {
        }
        phi_765_ = _e430;
    } else {
        phi_765_ = true;
    }
    let _e432 = phi_765_;
    if _e432 {
        phi_772_ = (_e425 / (_e425 + (_e426 * _e426)));
    } else {
        phi_772_ = 1f;
    }
    let _e437 = phi_772_;
    let _e439 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_785_ = true;
    } else {
        let _e443 = (42f < _e439);
        if _e443 {
        }
        phi_785_ = _e443;
    }
    let _e445 = phi_785_;
    if _e445 {
        phi_789_ = 42f;
    } else {
        phi_789_ = _e439;
    }
    let _e447 = phi_789_;
    let _e448 = -(_e447);
    let _e450 = (_e448 * param_5.x);
    let _e452 = (_e448 * param_5.y);
    let _e454 = (_e448 * param_5.z);
    let _e456 = (_e448 * param_5.w);
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_886_ = _e450;
    } else {
        if (_e450 < -87f) {
            phi_809_ = -87f;
        } else {
            phi_809_ = _e450;
        }
        let _e462 = phi_809_;
        if (_e462 > 88f) {
            phi_814_ = 88f;
        } else {
            phi_814_ = _e462;
        }
        let _e465 = phi_814_;
        let _e467 = ((_e465 * 1.442695f) + 0.5f);
        if (_e467 > -8388608f) {
            let _e479 = f32(select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < bitcast<f32>(3472883712u))), 2147483647i, (_e467 > bitcast<f32>(1325400063u))), (_e467 == _e467)));
            if (_e479 > _e467) {
                phi_836_ = 1f;
            } else {
                phi_836_ = 0f;
            }
            let _e482 = phi_836_;
            if (_e467 < 8388608f) {
                phi_841_ = (_e479 - _e482);
                phi_842_ = false;
            } else {
                phi_841_ = f32();
                phi_842_ = true;
            }
            let _e485 = phi_841_;
            let _e487 = phi_842_;
            phi_843_ = _e485;
            phi_844_ = _e487;
        } else {
            phi_843_ = f32();
            phi_844_ = true;
        }
        let _e489 = phi_843_;
        let _e491 = phi_844_;
        if _e491 {
            phi_848_ = _e467;
        } else {
            phi_848_ = _e489;
        }
        let _e493 = phi_848_;
        let _e497 = ((_e465 - (_e493 * 0.69314575f)) - (_e493 * 0.0000014286068f));
        phi_886_ = ((((((((((((((((1f / 5040f) * _e497) + (1f / 720f)) * _e497) + (1f / 120f)) * _e497) + (1f / 24f)) * _e497) + (1f / 6f)) * _e497) + 0.5f) * _e497) + 1f) * _e497) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < bitcast<f32>(3472883712u))), 2147483647i, (_e493 > bitcast<f32>(1325400063u))), (_e493 == _e493)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e533 = phi_886_;
    if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
        phi_974_ = _e452;
    } else {
        if (_e452 < -87f) {
            phi_897_ = -87f;
        } else {
            phi_897_ = _e452;
        }
        let _e539 = phi_897_;
        if (_e539 > 88f) {
            phi_902_ = 88f;
        } else {
            phi_902_ = _e539;
        }
        let _e542 = phi_902_;
        let _e544 = ((_e542 * 1.442695f) + 0.5f);
        if (_e544 > -8388608f) {
            let _e556 = f32(select(0i, select(select(i32(_e544), i32(-2147483648), (_e544 < bitcast<f32>(3472883712u))), 2147483647i, (_e544 > bitcast<f32>(1325400063u))), (_e544 == _e544)));
            if (_e556 > _e544) {
                phi_924_ = 1f;
            } else {
                phi_924_ = 0f;
            }
            let _e559 = phi_924_;
            if (_e544 < 8388608f) {
                phi_929_ = (_e556 - _e559);
                phi_930_ = false;
            } else {
                phi_929_ = f32();
                phi_930_ = true;
            }
            let _e562 = phi_929_;
            let _e564 = phi_930_;
            phi_931_ = _e562;
            phi_932_ = _e564;
        } else {
            phi_931_ = f32();
            phi_932_ = true;
        }
        let _e566 = phi_931_;
        let _e568 = phi_932_;
        if _e568 {
            phi_936_ = _e544;
        } else {
            phi_936_ = _e566;
        }
        let _e570 = phi_936_;
        let _e574 = ((_e542 - (_e570 * 0.69314575f)) - (_e570 * 0.0000014286068f));
        phi_974_ = ((((((((((((((((1f / 5040f) * _e574) + (1f / 720f)) * _e574) + (1f / 120f)) * _e574) + (1f / 24f)) * _e574) + (1f / 6f)) * _e574) + 0.5f) * _e574) + 1f) * _e574) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e570), i32(-2147483648), (_e570 < bitcast<f32>(3472883712u))), 2147483647i, (_e570 > bitcast<f32>(1325400063u))), (_e570 == _e570)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e610 = phi_974_;
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_1062_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_985_ = -87f;
        } else {
            phi_985_ = _e454;
        }
        let _e616 = phi_985_;
        if (_e616 > 88f) {
            phi_990_ = 88f;
        } else {
            phi_990_ = _e616;
        }
        let _e619 = phi_990_;
        let _e621 = ((_e619 * 1.442695f) + 0.5f);
        if (_e621 > -8388608f) {
            let _e633 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
            if (_e633 > _e621) {
                phi_1012_ = 1f;
            } else {
                phi_1012_ = 0f;
            }
            let _e636 = phi_1012_;
            if (_e621 < 8388608f) {
                phi_1017_ = (_e633 - _e636);
                phi_1018_ = false;
            } else {
                phi_1017_ = f32();
                phi_1018_ = true;
            }
            let _e639 = phi_1017_;
            let _e641 = phi_1018_;
            phi_1019_ = _e639;
            phi_1020_ = _e641;
        } else {
            phi_1019_ = f32();
            phi_1020_ = true;
        }
        let _e643 = phi_1019_;
        let _e645 = phi_1020_;
        if _e645 {
            phi_1024_ = _e621;
        } else {
            phi_1024_ = _e643;
        }
        let _e647 = phi_1024_;
        let _e651 = ((_e619 - (_e647 * 0.69314575f)) - (_e647 * 0.0000014286068f));
        phi_1062_ = ((((((((((((((((1f / 5040f) * _e651) + (1f / 720f)) * _e651) + (1f / 120f)) * _e651) + (1f / 24f)) * _e651) + (1f / 6f)) * _e651) + 0.5f) * _e651) + 1f) * _e651) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e687 = phi_1062_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_1150_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_1073_ = -87f;
        } else {
            phi_1073_ = _e456;
        }
        let _e693 = phi_1073_;
        if (_e693 > 88f) {
            phi_1078_ = 88f;
        } else {
            phi_1078_ = _e693;
        }
        let _e696 = phi_1078_;
        let _e698 = ((_e696 * 1.442695f) + 0.5f);
        if (_e698 > -8388608f) {
            let _e710 = f32(select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < bitcast<f32>(3472883712u))), 2147483647i, (_e698 > bitcast<f32>(1325400063u))), (_e698 == _e698)));
            if (_e710 > _e698) {
                phi_1100_ = 1f;
            } else {
                phi_1100_ = 0f;
            }
            let _e713 = phi_1100_;
            if (_e698 < 8388608f) {
                phi_1105_ = (_e710 - _e713);
                phi_1106_ = false;
            } else {
                phi_1105_ = f32();
                phi_1106_ = true;
            }
            let _e716 = phi_1105_;
            let _e718 = phi_1106_;
            phi_1107_ = _e716;
            phi_1108_ = _e718;
        } else {
            phi_1107_ = f32();
            phi_1108_ = true;
        }
        let _e720 = phi_1107_;
        let _e722 = phi_1108_;
        if _e722 {
            phi_1112_ = _e698;
        } else {
            phi_1112_ = _e720;
        }
        let _e724 = phi_1112_;
        let _e728 = ((_e696 - (_e724 * 0.69314575f)) - (_e724 * 0.0000014286068f));
        phi_1150_ = ((((((((((((((((1f / 5040f) * _e728) + (1f / 720f)) * _e728) + (1f / 120f)) * _e728) + (1f / 24f)) * _e728) + (1f / 6f)) * _e728) + 0.5f) * _e728) + 1f) * _e728) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < bitcast<f32>(3472883712u))), 2147483647i, (_e724 > bitcast<f32>(1325400063u))), (_e724 == _e724)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e764 = phi_1150_;
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
        phi_1203_ = true;
    } else {
        let _e810 = (_e776 > _e806);
        if _e810 {
        }
        phi_1203_ = _e810;
    }
    let _e812 = phi_1203_;
    if _e812 {
        phi_1207_ = _e776;
    } else {
        phi_1207_ = _e806;
    }
    let _e814 = phi_1207_;
    let _e815 = -(_e787);
    if (_e815 <= 0f) {
        let _e819 = ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u);
        if _e819 {
        }
        phi_1219_ = _e819;
    } else {
        phi_1219_ = true;
    }
    let _e821 = phi_1219_;
    if _e821 {
        phi_1226_ = (_e814 / (_e814 + (_e815 * _e815)));
    } else {
        phi_1226_ = 1f;
    }
    let _e826 = phi_1226_;
    if ((bitcast<u32>(_e826) & 2147483647u) > 2139095040u) {
        phi_1237_ = true;
    } else {
        let _e830 = (_e826 < _e437);
        if _e830 {
        }
        phi_1237_ = _e830;
    }
    let _e832 = phi_1237_;
    if _e832 {
        phi_1241_ = _e826;
    } else {
        phi_1241_ = _e437;
    }
    let _e834 = phi_1241_;
    if ((bitcast<u32>(_e834) & 2147483647u) > 2139095040u) {
        phi_1258_ = _e834;
    } else {
        if (_e834 < 0f) {
            phi_1257_ = 0f;
        } else {
            if (_e834 > 1f) {
                phi_1256_ = 1f;
            } else {
                phi_1256_ = _e834;
            }
            let _e841 = phi_1256_;
            phi_1257_ = _e841;
        }
        let _e843 = phi_1257_;
        phi_1258_ = _e843;
    }
    let _e845 = phi_1258_;
    return _e845;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_292_: bool;
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
    var phi_306_: bool;
    var phi_310_: bool;
    var phi_315_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_183_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_182_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_181_ = 1f;
            } else {
                phi_181_ = param_10;
            }
            let _e57 = phi_181_;
            phi_182_ = _e57;
        }
        let _e59 = phi_182_;
        phi_183_ = _e59;
    }
    let _e61 = phi_183_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_201_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_200_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_199_ = 1f;
            } else {
                phi_199_ = param_8.x;
            }
            let _e69 = phi_199_;
            phi_200_ = _e69;
        }
        let _e71 = phi_200_;
        phi_201_ = _e71;
    }
    let _e73 = phi_201_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_219_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_218_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_217_ = 1f;
            } else {
                phi_217_ = param_8.y;
            }
            let _e81 = phi_217_;
            phi_218_ = _e81;
        }
        let _e83 = phi_218_;
        phi_219_ = _e83;
    }
    let _e85 = phi_219_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_237_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_236_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = param_8.z;
            }
            let _e93 = phi_235_;
            phi_236_ = _e93;
        }
        let _e95 = phi_236_;
        phi_237_ = _e95;
    }
    let _e97 = phi_237_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_255_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_254_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_253_ = 1f;
            } else {
                phi_253_ = param_8.w;
            }
            let _e105 = phi_253_;
            phi_254_ = _e105;
        }
        let _e107 = phi_254_;
        phi_255_ = _e107;
    }
    let _e109 = phi_255_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_292_ = !(((bitcast<u32>(((((_e110 * param_9.x) + (_e111 * param_9.y)) + (_e112 * param_9.z)) + (_e113 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_293_ = false;
                } else {
                    phi_292_ = bool();
                    phi_293_ = true;
                }
                let _e135 = phi_292_;
                let _e137 = phi_293_;
                phi_294_ = _e135;
                phi_295_ = false;
                phi_296_ = _e137;
            } else {
                phi_294_ = bool();
                phi_295_ = true;
                phi_296_ = false;
            }
            let _e139 = phi_294_;
            let _e141 = phi_295_;
            let _e143 = phi_296_;
            phi_297_ = _e139;
            phi_298_ = _e141;
            phi_299_ = _e143;
        } else {
            phi_297_ = bool();
            phi_298_ = true;
            phi_299_ = false;
        }
        let _e145 = phi_297_;
        let _e147 = phi_298_;
        let _e149 = phi_299_;
        phi_300_ = _e145;
        phi_301_ = _e147;
        phi_302_ = _e149;
    } else {
        phi_300_ = bool();
        phi_301_ = true;
        phi_302_ = false;
    }
    let _e151 = phi_300_;
    let _e153 = phi_301_;
    let _e155 = phi_302_;
    if _e153 {
        phi_306_ = true;
    } else {
        phi_306_ = _e155;
    }
    let _e157 = phi_306_;
    if _e157 {
        phi_310_ = false;
    } else {
        phi_310_ = _e151;
    }
    let _e159 = phi_310_;
    if _e159 {
        phi_315_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e110, _e111, _e112, _e113), param_9);
        phi_315_ = _e160;
    }
    let _e162 = phi_315_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_1312_: bool;
    var phi_1313_: bool;
    var phi_1314_: bool;
    var phi_1315_: bool;
    var phi_1319_: bool;
    var phi_1363_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1367_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1444_: bool;
    var phi_1453_: bool;
    var phi_1462_: bool;
    var phi_1463_: bool;
    var phi_1464_: bool;
    var phi_1465_: bool;
    var phi_1466_: bool;
    var phi_1467_: bool;
    var phi_1468_: bool;
    var phi_1472_: bool;
    var phi_1566_: f32;
    var phi_1569_: f32;
    var phi_1598_: f32;
    var phi_1603_: f32;
    var phi_1604_: bool;
    var phi_1605_: f32;
    var phi_1606_: bool;
    var phi_1610_: f32;
    var phi_1630_: f32;
    var phi_1635_: f32;
    var phi_1636_: bool;
    var phi_1637_: f32;
    var phi_1638_: bool;
    var phi_1642_: f32;
    var phi_1692_: i32;
    var phi_1697_: i32;
    var phi_1702_: i32;
    var phi_1707_: i32;
    var phi_1716_: i32;
    var phi_1721_: i32;
    var phi_1726_: i32;
    var phi_1731_: i32;
    var phi_1778_: bool;
    var phi_1786_: bool;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1803_: f32;
    var phi_1809_: f32;
    var phi_1811_: evaluate_Verdict;
    var phi_1816_: evaluate_Verdict;
    var phi_1817_: evaluate_Verdict;

    let _e48 = id_1;
    let _e55 = arrayLength((&map.member));
    let _e61 = p.member.size[0u];
    let _e63 = p.member.size[1u];
    let _e64 = lt_shaders_entry_pixel_index(_e48, _e61, _e63);
    if (bitcast<i32>(_e64.root) != 0i) {
        if (_e64.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e73 = p.member.light;
        let _e76 = samples.member[(0u + _e64.first_primitive)].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[(0u + _e64.first_primitive)].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[(0u + _e64.first_primitive)].normal[2u];
                let _e88 = global[2u];
                phi_1312_ = (_e86 == _e88);
                phi_1313_ = false;
            } else {
                phi_1312_ = bool();
                phi_1313_ = true;
            }
            let _e91 = phi_1312_;
            let _e93 = phi_1313_;
            phi_1314_ = _e91;
            phi_1315_ = _e93;
        } else {
            phi_1314_ = bool();
            phi_1315_ = true;
        }
        let _e95 = phi_1314_;
        let _e97 = phi_1315_;
        if _e97 {
            phi_1319_ = false;
        } else {
            phi_1319_ = _e95;
        }
        let _e99 = phi_1319_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_1363_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_1363_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_1363_;
            phi_1367_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_1367_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_1367_;
        if _e179.unnamed_1 {
            phi_1817_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
        } else {
            let _e187 = samples.member[(0u + _e64.first_primitive)].position;
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
                    phi_1444_ = (_e218 <= 1f);
                } else {
                    phi_1444_ = false;
                }
                let _e250 = phi_1444_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_1453_ = (_e232 <= 1f);
                    } else {
                        phi_1453_ = false;
                    }
                    let _e254 = phi_1453_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_1462_ = (_e245 <= 1f);
                        } else {
                            phi_1462_ = false;
                        }
                        let _e258 = phi_1462_;
                        phi_1463_ = _e258;
                        phi_1464_ = false;
                    } else {
                        phi_1463_ = bool();
                        phi_1464_ = true;
                    }
                    let _e260 = phi_1463_;
                    let _e262 = phi_1464_;
                    phi_1465_ = _e260;
                    phi_1466_ = _e262;
                } else {
                    phi_1465_ = bool();
                    phi_1466_ = true;
                }
                let _e264 = phi_1465_;
                let _e266 = phi_1466_;
                phi_1467_ = _e264;
                phi_1468_ = _e266;
            } else {
                phi_1467_ = bool();
                phi_1468_ = true;
            }
            let _e268 = phi_1467_;
            let _e270 = phi_1468_;
            if _e270 {
                phi_1472_ = false;
            } else {
                phi_1472_ = _e268;
            }
            let _e272 = phi_1472_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_1566_ = _e351;
                    } else {
                        phi_1566_ = 0.002f;
                    }
                    let _e354 = phi_1566_;
                    phi_1569_ = (_e245 - (0f * _e354));
                } else {
                    phi_1569_ = _e245;
                }
                let _e358 = phi_1569_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_1598_ = 1f;
                    } else {
                        phi_1598_ = 0f;
                    }
                    let _e380 = phi_1598_;
                    if (_e364 < 8388608f) {
                        phi_1603_ = (_e377 - _e380);
                        phi_1604_ = false;
                    } else {
                        phi_1603_ = f32();
                        phi_1604_ = true;
                    }
                    let _e383 = phi_1603_;
                    let _e385 = phi_1604_;
                    phi_1605_ = _e383;
                    phi_1606_ = _e385;
                } else {
                    phi_1605_ = f32();
                    phi_1606_ = true;
                }
                let _e387 = phi_1605_;
                let _e389 = phi_1606_;
                if _e389 {
                    phi_1610_ = _e364;
                } else {
                    phi_1610_ = _e387;
                }
                let _e391 = phi_1610_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_1630_ = 1f;
                    } else {
                        phi_1630_ = 0f;
                    }
                    let _e406 = phi_1630_;
                    if (_e365 < 8388608f) {
                        phi_1635_ = (_e403 - _e406);
                        phi_1636_ = false;
                    } else {
                        phi_1635_ = f32();
                        phi_1636_ = true;
                    }
                    let _e409 = phi_1635_;
                    let _e411 = phi_1636_;
                    phi_1637_ = _e409;
                    phi_1638_ = _e411;
                } else {
                    phi_1637_ = f32();
                    phi_1638_ = true;
                }
                let _e413 = phi_1637_;
                let _e415 = phi_1638_;
                if _e415 {
                    phi_1642_ = _e365;
                } else {
                    phi_1642_ = _e413;
                }
                let _e417 = phi_1642_;
                let _e418 = (_e364 - _e391);
                let _e419 = (_e365 - _e417);
                let _e428 = select(0i, select(select(i32(_e391), i32(-2147483648), (_e391 < bitcast<f32>(3472883712u))), 2147483647i, (_e391 > bitcast<f32>(1325400063u))), (_e391 == _e391));
                let _e437 = select(0i, select(select(i32(_e417), i32(-2147483648), (_e417 < bitcast<f32>(3472883712u))), 2147483647i, (_e417 > bitcast<f32>(1325400063u))), (_e417 == _e417));
                let _e448 = p.member.test;
                let _e449 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e448);
                let _e451 = p.member.map_size;
                local = lt_math_Evsm(_e449.positive_exponent, _e449.negative_exponent, _e449.min_variance);
                let _e457 = (bitcast<i32>(_e451) - 1i);
                if (_e428 > 0i) {
                    phi_1692_ = _e428;
                } else {
                    phi_1692_ = 0i;
                }
                let _e460 = phi_1692_;
                if (_e437 > 0i) {
                    phi_1697_ = _e437;
                } else {
                    phi_1697_ = 0i;
                }
                let _e463 = phi_1697_;
                if (_e460 < _e457) {
                    phi_1702_ = _e460;
                } else {
                    phi_1702_ = _e457;
                }
                let _e466 = phi_1702_;
                if (_e463 < _e457) {
                    phi_1707_ = _e463;
                } else {
                    phi_1707_ = _e457;
                }
                let _e469 = phi_1707_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (_e428 + 1i);
                let _e473 = (_e437 + 1i);
                if (_e472 > 0i) {
                    phi_1716_ = _e472;
                } else {
                    phi_1716_ = 0i;
                }
                let _e476 = phi_1716_;
                if (_e473 > 0i) {
                    phi_1721_ = _e473;
                } else {
                    phi_1721_ = 0i;
                }
                let _e479 = phi_1721_;
                if (_e476 < _e457) {
                    phi_1726_ = _e476;
                } else {
                    phi_1726_ = _e457;
                }
                let _e482 = phi_1726_;
                if (_e479 < _e457) {
                    phi_1731_ = _e479;
                } else {
                    phi_1731_ = _e457;
                }
                let _e485 = phi_1731_;
                let _e486 = bitcast<u32>(_e482);
                let _e488 = (bitcast<u32>(_e469) * _e451);
                let _e489 = (bitcast<u32>(_e485) * _e451);
                let _e490 = (_e488 + _e470);
                let _e491 = (_e488 + _e486);
                let _e492 = (_e489 + _e470);
                let _e493 = (_e489 + _e486);
                if (_e490 < _e55) {
                } else {
                    return;
                }
                let _e497 = map.member[(0u + _e490)];
                if (_e491 < _e55) {
                } else {
                    return;
                }
                let _e501 = map.member[(0u + _e491)];
                if (_e492 < _e55) {
                } else {
                    return;
                }
                let _e505 = map.member[(0u + _e492)];
                if (_e493 < _e55) {
                } else {
                    return;
                }
                let _e509 = map.member[(0u + _e493)];
                let _e511 = _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e497, _e501, _e505, _e509), vec4<f32>(((1f - _e418) * (1f - _e419)), (_e418 * (1f - _e419)), ((1f - _e418) * _e419), (_e418 * _e419)), _e358);
                let _e513 = p.member.epsilon;
                if (_e511 <= _e513) {
                    phi_1778_ = true;
                } else {
                    phi_1778_ = (_e511 >= (1f - _e513));
                }
                let _e518 = phi_1778_;
                if ((bitcast<u32>(_e511) & 2147483647u) > 2139095040u) {
                    phi_1786_ = true;
                } else {
                    phi_1786_ = !(_e518);
                }
                let _e524 = phi_1786_;
                if _e524 {
                    if (_e511 > 0f) {
                        if (_e511 < 1f) {
                            phi_1798_ = false;
                        } else {
                            phi_1798_ = true;
                        }
                        let _e528 = phi_1798_;
                        phi_1799_ = _e528;
                    } else {
                        phi_1799_ = true;
                    }
                    let _e530 = phi_1799_;
                    if _e530 {
                        phi_1803_ = 0.5f;
                    } else {
                        phi_1803_ = _e511;
                    }
                    let _e532 = phi_1803_;
                    phi_1811_ = evaluate_Verdict(_e532, true);
                } else {
                    if (_e511 > 0.5f) {
                        phi_1809_ = 1f;
                    } else {
                        phi_1809_ = 0f;
                    }
                    let _e536 = phi_1809_;
                    phi_1811_ = evaluate_Verdict(_e536, false);
                }
                let _e539 = phi_1811_;
                phi_1816_ = evaluate_Verdict(_e539.visibility, _e539.is_doubted);
            } else {
                phi_1816_ = evaluate_Verdict(0.5f, true);
            }
            let _e545 = phi_1816_;
            phi_1817_ = _e545;
        }
        let _e547 = phi_1817_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e547.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
