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

struct lt_math_OneLevel {
    projection: lt_math_LightProjection,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
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
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e60 = phi_148_;
        let _e62 = phi_149_;
        phi_150_ = _e60;
        phi_151_ = _e62;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e64 = phi_150_;
    let _e66 = phi_151_;
    if _e66 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e64;
    }
    let _e71 = phi_156_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_915_: bool;
    var phi_919_: f32;
    var phi_938_: f32;
    var phi_943_: f32;
    var phi_965_: f32;
    var phi_970_: f32;
    var phi_971_: bool;
    var phi_972_: f32;
    var phi_973_: bool;
    var phi_977_: f32;
    var phi_1015_: f32;
    var phi_1026_: f32;
    var phi_1031_: f32;
    var phi_1053_: f32;
    var phi_1058_: f32;
    var phi_1059_: bool;
    var phi_1060_: f32;
    var phi_1061_: bool;
    var phi_1065_: f32;
    var phi_1103_: f32;
    var phi_1114_: f32;
    var phi_1119_: f32;
    var phi_1141_: f32;
    var phi_1146_: f32;
    var phi_1147_: bool;
    var phi_1148_: f32;
    var phi_1149_: bool;
    var phi_1153_: f32;
    var phi_1191_: f32;
    var phi_1202_: f32;
    var phi_1207_: f32;
    var phi_1229_: f32;
    var phi_1234_: f32;
    var phi_1235_: bool;
    var phi_1236_: f32;
    var phi_1237_: bool;
    var phi_1241_: f32;
    var phi_1279_: f32;
    var phi_1332_: bool;
    var phi_1336_: f32;
    var phi_1348_: bool;
    var phi_1355_: f32;
    var phi_1368_: bool;
    var phi_1372_: f32;
    var phi_1392_: f32;
    var phi_1397_: f32;
    var phi_1419_: f32;
    var phi_1424_: f32;
    var phi_1425_: bool;
    var phi_1426_: f32;
    var phi_1427_: bool;
    var phi_1431_: f32;
    var phi_1469_: f32;
    var phi_1480_: f32;
    var phi_1485_: f32;
    var phi_1507_: f32;
    var phi_1512_: f32;
    var phi_1513_: bool;
    var phi_1514_: f32;
    var phi_1515_: bool;
    var phi_1519_: f32;
    var phi_1557_: f32;
    var phi_1568_: f32;
    var phi_1573_: f32;
    var phi_1595_: f32;
    var phi_1600_: f32;
    var phi_1601_: bool;
    var phi_1602_: f32;
    var phi_1603_: bool;
    var phi_1607_: f32;
    var phi_1645_: f32;
    var phi_1656_: f32;
    var phi_1661_: f32;
    var phi_1683_: f32;
    var phi_1688_: f32;
    var phi_1689_: bool;
    var phi_1690_: f32;
    var phi_1691_: bool;
    var phi_1695_: f32;
    var phi_1733_: f32;
    var phi_1786_: bool;
    var phi_1790_: f32;
    var phi_1802_: bool;
    var phi_1809_: f32;
    var phi_1820_: bool;
    var phi_1824_: f32;
    var phi_1839_: f32;
    var phi_1840_: f32;
    var phi_1841_: f32;

    let _e51 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_915_ = true;
    } else {
        let _e55 = (42f < _e51);
        if _e55 {
        }
        phi_915_ = _e55;
    }
    let _e57 = phi_915_;
    if _e57 {
        phi_919_ = 42f;
    } else {
        phi_919_ = _e51;
    }
    let _e59 = phi_919_;
    let _e61 = (_e59 * param_5.x);
    let _e63 = (_e59 * param_5.y);
    let _e65 = (_e59 * param_5.z);
    let _e67 = (_e59 * param_5.w);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_1015_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_938_ = -87f;
        } else {
            phi_938_ = _e61;
        }
        let _e73 = phi_938_;
        if (_e73 > 88f) {
            phi_943_ = 88f;
        } else {
            phi_943_ = _e73;
        }
        let _e76 = phi_943_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_965_ = 1f;
            } else {
                phi_965_ = 0f;
            }
            let _e93 = phi_965_;
            if (_e78 < 8388608f) {
                phi_970_ = (_e90 - _e93);
                phi_971_ = false;
            } else {
                phi_970_ = f32();
                phi_971_ = true;
            }
            let _e96 = phi_970_;
            let _e98 = phi_971_;
            phi_972_ = _e96;
            phi_973_ = _e98;
        } else {
            phi_972_ = f32();
            phi_973_ = true;
        }
        let _e100 = phi_972_;
        let _e102 = phi_973_;
        if _e102 {
            phi_977_ = _e78;
        } else {
            phi_977_ = _e100;
        }
        let _e104 = phi_977_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_1015_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_1015_;
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_1103_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_1026_ = -87f;
        } else {
            phi_1026_ = _e63;
        }
        let _e150 = phi_1026_;
        if (_e150 > 88f) {
            phi_1031_ = 88f;
        } else {
            phi_1031_ = _e150;
        }
        let _e153 = phi_1031_;
        let _e155 = ((_e153 * 1.442695f) + 0.5f);
        if (_e155 > -8388608f) {
            let _e167 = f32(select(0i, select(select(i32(_e155), i32(-2147483648), (_e155 < bitcast<f32>(3472883712u))), 2147483647i, (_e155 > bitcast<f32>(1325400063u))), (_e155 == _e155)));
            if (_e167 > _e155) {
                phi_1053_ = 1f;
            } else {
                phi_1053_ = 0f;
            }
            let _e170 = phi_1053_;
            if (_e155 < 8388608f) {
                phi_1058_ = (_e167 - _e170);
                phi_1059_ = false;
            } else {
                phi_1058_ = f32();
                phi_1059_ = true;
            }
            let _e173 = phi_1058_;
            let _e175 = phi_1059_;
            phi_1060_ = _e173;
            phi_1061_ = _e175;
        } else {
            phi_1060_ = f32();
            phi_1061_ = true;
        }
        let _e177 = phi_1060_;
        let _e179 = phi_1061_;
        if _e179 {
            phi_1065_ = _e155;
        } else {
            phi_1065_ = _e177;
        }
        let _e181 = phi_1065_;
        let _e185 = ((_e153 - (_e181 * 0.69314575f)) - (_e181 * 0.0000014286068f));
        phi_1103_ = ((((((((((((((((1f / 5040f) * _e185) + (1f / 720f)) * _e185) + (1f / 120f)) * _e185) + (1f / 24f)) * _e185) + (1f / 6f)) * _e185) + 0.5f) * _e185) + 1f) * _e185) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e181), i32(-2147483648), (_e181 < bitcast<f32>(3472883712u))), 2147483647i, (_e181 > bitcast<f32>(1325400063u))), (_e181 == _e181)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e221 = phi_1103_;
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_1191_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_1114_ = -87f;
        } else {
            phi_1114_ = _e65;
        }
        let _e227 = phi_1114_;
        if (_e227 > 88f) {
            phi_1119_ = 88f;
        } else {
            phi_1119_ = _e227;
        }
        let _e230 = phi_1119_;
        let _e232 = ((_e230 * 1.442695f) + 0.5f);
        if (_e232 > -8388608f) {
            let _e244 = f32(select(0i, select(select(i32(_e232), i32(-2147483648), (_e232 < bitcast<f32>(3472883712u))), 2147483647i, (_e232 > bitcast<f32>(1325400063u))), (_e232 == _e232)));
            if (_e244 > _e232) {
                phi_1141_ = 1f;
            } else {
                phi_1141_ = 0f;
            }
            let _e247 = phi_1141_;
            if (_e232 < 8388608f) {
                phi_1146_ = (_e244 - _e247);
                phi_1147_ = false;
            } else {
                phi_1146_ = f32();
                phi_1147_ = true;
            }
            let _e250 = phi_1146_;
            let _e252 = phi_1147_;
            phi_1148_ = _e250;
            phi_1149_ = _e252;
        } else {
            phi_1148_ = f32();
            phi_1149_ = true;
        }
        let _e254 = phi_1148_;
        let _e256 = phi_1149_;
        if _e256 {
            phi_1153_ = _e232;
        } else {
            phi_1153_ = _e254;
        }
        let _e258 = phi_1153_;
        let _e262 = ((_e230 - (_e258 * 0.69314575f)) - (_e258 * 0.0000014286068f));
        phi_1191_ = ((((((((((((((((1f / 5040f) * _e262) + (1f / 720f)) * _e262) + (1f / 120f)) * _e262) + (1f / 24f)) * _e262) + (1f / 6f)) * _e262) + 0.5f) * _e262) + 1f) * _e262) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < bitcast<f32>(3472883712u))), 2147483647i, (_e258 > bitcast<f32>(1325400063u))), (_e258 == _e258)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e298 = phi_1191_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_1279_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_1202_ = -87f;
        } else {
            phi_1202_ = _e67;
        }
        let _e304 = phi_1202_;
        if (_e304 > 88f) {
            phi_1207_ = 88f;
        } else {
            phi_1207_ = _e304;
        }
        let _e307 = phi_1207_;
        let _e309 = ((_e307 * 1.442695f) + 0.5f);
        if (_e309 > -8388608f) {
            let _e321 = f32(select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < bitcast<f32>(3472883712u))), 2147483647i, (_e309 > bitcast<f32>(1325400063u))), (_e309 == _e309)));
            if (_e321 > _e309) {
                phi_1229_ = 1f;
            } else {
                phi_1229_ = 0f;
            }
            let _e324 = phi_1229_;
            if (_e309 < 8388608f) {
                phi_1234_ = (_e321 - _e324);
                phi_1235_ = false;
            } else {
                phi_1234_ = f32();
                phi_1235_ = true;
            }
            let _e327 = phi_1234_;
            let _e329 = phi_1235_;
            phi_1236_ = _e327;
            phi_1237_ = _e329;
        } else {
            phi_1236_ = f32();
            phi_1237_ = true;
        }
        let _e331 = phi_1236_;
        let _e333 = phi_1237_;
        if _e333 {
            phi_1241_ = _e309;
        } else {
            phi_1241_ = _e331;
        }
        let _e335 = phi_1241_;
        let _e339 = ((_e307 - (_e335 * 0.69314575f)) - (_e335 * 0.0000014286068f));
        phi_1279_ = ((((((((((((((((1f / 5040f) * _e339) + (1f / 720f)) * _e339) + (1f / 120f)) * _e339) + (1f / 24f)) * _e339) + (1f / 6f)) * _e339) + 0.5f) * _e339) + 1f) * _e339) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < bitcast<f32>(3472883712u))), 2147483647i, (_e335 > bitcast<f32>(1325400063u))), (_e335 == _e335)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e375 = phi_1279_;
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
        phi_1332_ = true;
    } else {
        let _e421 = (_e387 > _e417);
        if _e421 {
        }
        phi_1332_ = _e421;
    }
    let _e423 = phi_1332_;
    if _e423 {
        phi_1336_ = _e387;
    } else {
        phi_1336_ = _e417;
    }
    let _e425 = phi_1336_;
    let _e426 = -(_e398);
    if (_e426 <= 0f) {
        let _e430 = ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u);
        if _e430 {
        }
        phi_1348_ = _e430;
    } else {
        phi_1348_ = true;
    }
    let _e432 = phi_1348_;
    if _e432 {
        phi_1355_ = (_e425 / (_e425 + (_e426 * _e426)));
    } else {
        phi_1355_ = 1f;
    }
    let _e437 = phi_1355_;
    let _e439 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_1368_ = true;
    } else {
        let _e443 = (42f < _e439);
        if _e443 {
        }
        phi_1368_ = _e443;
    }
    let _e445 = phi_1368_;
    if _e445 {
        phi_1372_ = 42f;
    } else {
        phi_1372_ = _e439;
    }
    let _e447 = phi_1372_;
    let _e448 = -(_e447);
    let _e450 = (_e448 * param_5.x);
    let _e452 = (_e448 * param_5.y);
    let _e454 = (_e448 * param_5.z);
    let _e456 = (_e448 * param_5.w);
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_1469_ = _e450;
    } else {
        if (_e450 < -87f) {
            phi_1392_ = -87f;
        } else {
            phi_1392_ = _e450;
        }
        let _e462 = phi_1392_;
        if (_e462 > 88f) {
            phi_1397_ = 88f;
        } else {
            phi_1397_ = _e462;
        }
        let _e465 = phi_1397_;
        let _e467 = ((_e465 * 1.442695f) + 0.5f);
        if (_e467 > -8388608f) {
            let _e479 = f32(select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < bitcast<f32>(3472883712u))), 2147483647i, (_e467 > bitcast<f32>(1325400063u))), (_e467 == _e467)));
            if (_e479 > _e467) {
                phi_1419_ = 1f;
            } else {
                phi_1419_ = 0f;
            }
            let _e482 = phi_1419_;
            if (_e467 < 8388608f) {
                phi_1424_ = (_e479 - _e482);
                phi_1425_ = false;
            } else {
                phi_1424_ = f32();
                phi_1425_ = true;
            }
            let _e485 = phi_1424_;
            let _e487 = phi_1425_;
            phi_1426_ = _e485;
            phi_1427_ = _e487;
        } else {
            phi_1426_ = f32();
            phi_1427_ = true;
        }
        let _e489 = phi_1426_;
        let _e491 = phi_1427_;
        if _e491 {
            phi_1431_ = _e467;
        } else {
            phi_1431_ = _e489;
        }
        let _e493 = phi_1431_;
        let _e497 = ((_e465 - (_e493 * 0.69314575f)) - (_e493 * 0.0000014286068f));
        phi_1469_ = ((((((((((((((((1f / 5040f) * _e497) + (1f / 720f)) * _e497) + (1f / 120f)) * _e497) + (1f / 24f)) * _e497) + (1f / 6f)) * _e497) + 0.5f) * _e497) + 1f) * _e497) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < bitcast<f32>(3472883712u))), 2147483647i, (_e493 > bitcast<f32>(1325400063u))), (_e493 == _e493)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e533 = phi_1469_;
    if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
        phi_1557_ = _e452;
    } else {
        if (_e452 < -87f) {
            phi_1480_ = -87f;
        } else {
            phi_1480_ = _e452;
        }
        let _e539 = phi_1480_;
        if (_e539 > 88f) {
            phi_1485_ = 88f;
        } else {
            phi_1485_ = _e539;
        }
        let _e542 = phi_1485_;
        let _e544 = ((_e542 * 1.442695f) + 0.5f);
        if (_e544 > -8388608f) {
            let _e556 = f32(select(0i, select(select(i32(_e544), i32(-2147483648), (_e544 < bitcast<f32>(3472883712u))), 2147483647i, (_e544 > bitcast<f32>(1325400063u))), (_e544 == _e544)));
            if (_e556 > _e544) {
                phi_1507_ = 1f;
            } else {
                phi_1507_ = 0f;
            }
            let _e559 = phi_1507_;
            if (_e544 < 8388608f) {
                phi_1512_ = (_e556 - _e559);
                phi_1513_ = false;
            } else {
                phi_1512_ = f32();
                phi_1513_ = true;
            }
            let _e562 = phi_1512_;
            let _e564 = phi_1513_;
            phi_1514_ = _e562;
            phi_1515_ = _e564;
        } else {
            phi_1514_ = f32();
            phi_1515_ = true;
        }
        let _e566 = phi_1514_;
        let _e568 = phi_1515_;
        if _e568 {
            phi_1519_ = _e544;
        } else {
            phi_1519_ = _e566;
        }
        let _e570 = phi_1519_;
        let _e574 = ((_e542 - (_e570 * 0.69314575f)) - (_e570 * 0.0000014286068f));
        phi_1557_ = ((((((((((((((((1f / 5040f) * _e574) + (1f / 720f)) * _e574) + (1f / 120f)) * _e574) + (1f / 24f)) * _e574) + (1f / 6f)) * _e574) + 0.5f) * _e574) + 1f) * _e574) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e570), i32(-2147483648), (_e570 < bitcast<f32>(3472883712u))), 2147483647i, (_e570 > bitcast<f32>(1325400063u))), (_e570 == _e570)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e610 = phi_1557_;
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_1645_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_1568_ = -87f;
        } else {
            phi_1568_ = _e454;
        }
        let _e616 = phi_1568_;
        if (_e616 > 88f) {
            phi_1573_ = 88f;
        } else {
            phi_1573_ = _e616;
        }
        let _e619 = phi_1573_;
        let _e621 = ((_e619 * 1.442695f) + 0.5f);
        if (_e621 > -8388608f) {
            let _e633 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
            if (_e633 > _e621) {
                phi_1595_ = 1f;
            } else {
                phi_1595_ = 0f;
            }
            let _e636 = phi_1595_;
            if (_e621 < 8388608f) {
                phi_1600_ = (_e633 - _e636);
                phi_1601_ = false;
            } else {
                phi_1600_ = f32();
                phi_1601_ = true;
            }
            let _e639 = phi_1600_;
            let _e641 = phi_1601_;
            phi_1602_ = _e639;
            phi_1603_ = _e641;
        } else {
            phi_1602_ = f32();
            phi_1603_ = true;
        }
        let _e643 = phi_1602_;
        let _e645 = phi_1603_;
        if _e645 {
            phi_1607_ = _e621;
        } else {
            phi_1607_ = _e643;
        }
        let _e647 = phi_1607_;
        let _e651 = ((_e619 - (_e647 * 0.69314575f)) - (_e647 * 0.0000014286068f));
        phi_1645_ = ((((((((((((((((1f / 5040f) * _e651) + (1f / 720f)) * _e651) + (1f / 120f)) * _e651) + (1f / 24f)) * _e651) + (1f / 6f)) * _e651) + 0.5f) * _e651) + 1f) * _e651) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e687 = phi_1645_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_1733_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_1656_ = -87f;
        } else {
            phi_1656_ = _e456;
        }
        let _e693 = phi_1656_;
        if (_e693 > 88f) {
            phi_1661_ = 88f;
        } else {
            phi_1661_ = _e693;
        }
        let _e696 = phi_1661_;
        let _e698 = ((_e696 * 1.442695f) + 0.5f);
        if (_e698 > -8388608f) {
            let _e710 = f32(select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < bitcast<f32>(3472883712u))), 2147483647i, (_e698 > bitcast<f32>(1325400063u))), (_e698 == _e698)));
            if (_e710 > _e698) {
                phi_1683_ = 1f;
            } else {
                phi_1683_ = 0f;
            }
            let _e713 = phi_1683_;
            if (_e698 < 8388608f) {
                phi_1688_ = (_e710 - _e713);
                phi_1689_ = false;
            } else {
                phi_1688_ = f32();
                phi_1689_ = true;
            }
            let _e716 = phi_1688_;
            let _e718 = phi_1689_;
            phi_1690_ = _e716;
            phi_1691_ = _e718;
        } else {
            phi_1690_ = f32();
            phi_1691_ = true;
        }
        let _e720 = phi_1690_;
        let _e722 = phi_1691_;
        if _e722 {
            phi_1695_ = _e698;
        } else {
            phi_1695_ = _e720;
        }
        let _e724 = phi_1695_;
        let _e728 = ((_e696 - (_e724 * 0.69314575f)) - (_e724 * 0.0000014286068f));
        phi_1733_ = ((((((((((((((((1f / 5040f) * _e728) + (1f / 720f)) * _e728) + (1f / 120f)) * _e728) + (1f / 24f)) * _e728) + (1f / 6f)) * _e728) + 0.5f) * _e728) + 1f) * _e728) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < bitcast<f32>(3472883712u))), 2147483647i, (_e724 > bitcast<f32>(1325400063u))), (_e724 == _e724)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e764 = phi_1733_;
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
        phi_1786_ = true;
    } else {
        let _e810 = (_e776 > _e806);
        if _e810 {
        }
        phi_1786_ = _e810;
    }
    let _e812 = phi_1786_;
    if _e812 {
        phi_1790_ = _e776;
    } else {
        phi_1790_ = _e806;
    }
    let _e814 = phi_1790_;
    let _e815 = -(_e787);
    if (_e815 <= 0f) {
        let _e819 = ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u);
        if _e819 {
        }
        phi_1802_ = _e819;
    } else {
        phi_1802_ = true;
    }
    let _e821 = phi_1802_;
    if _e821 {
        phi_1809_ = (_e814 / (_e814 + (_e815 * _e815)));
    } else {
        phi_1809_ = 1f;
    }
    let _e826 = phi_1809_;
    if ((bitcast<u32>(_e826) & 2147483647u) > 2139095040u) {
        phi_1820_ = true;
    } else {
        let _e830 = (_e826 < _e437);
        if _e830 {
        }
        phi_1820_ = _e830;
    }
    let _e832 = phi_1820_;
    if _e832 {
        phi_1824_ = _e826;
    } else {
        phi_1824_ = _e437;
    }
    let _e834 = phi_1824_;
    if ((bitcast<u32>(_e834) & 2147483647u) > 2139095040u) {
        phi_1841_ = _e834;
    } else {
        if (_e834 < 0f) {
            phi_1840_ = 0f;
        } else {
            if (_e834 > 1f) {
                phi_1839_ = 1f;
            } else {
                phi_1839_ = _e834;
            }
            let _e841 = phi_1839_;
            phi_1840_ = _e841;
        }
        let _e843 = phi_1840_;
        phi_1841_ = _e843;
    }
    let _e845 = phi_1841_;
    return _e845;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_766_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_836_: f32;
    var phi_837_: f32;
    var phi_838_: f32;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_877_: bool;
    var phi_878_: bool;
    var phi_879_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_889_: bool;
    var phi_893_: bool;
    var phi_898_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_766_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_765_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_764_ = 1f;
            } else {
                phi_764_ = param_10;
            }
            let _e57 = phi_764_;
            phi_765_ = _e57;
        }
        let _e59 = phi_765_;
        phi_766_ = _e59;
    }
    let _e61 = phi_766_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_784_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_783_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_782_ = 1f;
            } else {
                phi_782_ = param_8.x;
            }
            let _e69 = phi_782_;
            phi_783_ = _e69;
        }
        let _e71 = phi_783_;
        phi_784_ = _e71;
    }
    let _e73 = phi_784_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_802_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_801_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_800_ = 1f;
            } else {
                phi_800_ = param_8.y;
            }
            let _e81 = phi_800_;
            phi_801_ = _e81;
        }
        let _e83 = phi_801_;
        phi_802_ = _e83;
    }
    let _e85 = phi_802_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_820_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_819_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_818_ = 1f;
            } else {
                phi_818_ = param_8.z;
            }
            let _e93 = phi_818_;
            phi_819_ = _e93;
        }
        let _e95 = phi_819_;
        phi_820_ = _e95;
    }
    let _e97 = phi_820_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_838_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_837_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_836_ = 1f;
            } else {
                phi_836_ = param_8.w;
            }
            let _e105 = phi_836_;
            phi_837_ = _e105;
        }
        let _e107 = phi_837_;
        phi_838_ = _e107;
    }
    let _e109 = phi_838_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_875_ = !(((bitcast<u32>(((((_e110 * param_9.x) + (_e111 * param_9.y)) + (_e112 * param_9.z)) + (_e113 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_876_ = false;
                } else {
                    phi_875_ = bool();
                    phi_876_ = true;
                }
                let _e135 = phi_875_;
                let _e137 = phi_876_;
                phi_877_ = _e135;
                phi_878_ = false;
                phi_879_ = _e137;
            } else {
                phi_877_ = bool();
                phi_878_ = true;
                phi_879_ = false;
            }
            let _e139 = phi_877_;
            let _e141 = phi_878_;
            let _e143 = phi_879_;
            phi_880_ = _e139;
            phi_881_ = _e141;
            phi_882_ = _e143;
        } else {
            phi_880_ = bool();
            phi_881_ = true;
            phi_882_ = false;
        }
        let _e145 = phi_880_;
        let _e147 = phi_881_;
        let _e149 = phi_882_;
        phi_883_ = _e145;
        phi_884_ = _e147;
        phi_885_ = _e149;
    } else {
        phi_883_ = bool();
        phi_884_ = true;
        phi_885_ = false;
    }
    let _e151 = phi_883_;
    let _e153 = phi_884_;
    let _e155 = phi_885_;
    if _e153 {
        phi_889_ = true;
    } else {
        phi_889_ = _e155;
    }
    let _e157 = phi_889_;
    if _e157 {
        phi_893_ = false;
    } else {
        phi_893_ = _e151;
    }
    let _e159 = phi_893_;
    if _e159 {
        phi_898_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e110, _e111, _e112, _e113), param_9);
        phi_898_ = _e160;
    }
    let _e162 = phi_898_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_221_: bool;
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_224_: bool;
    var phi_228_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_310_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_311_: bool;
    var phi_312_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_313_: bool;
    var phi_320_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_324_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_398_: bool;
    var phi_407_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_422_: bool;
    var phi_426_: bool;
    var phi_516_: f32;
    var phi_519_: f32;
    var phi_548_: f32;
    var phi_553_: f32;
    var phi_554_: bool;
    var phi_555_: f32;
    var phi_556_: bool;
    var phi_560_: f32;
    var phi_580_: f32;
    var phi_585_: f32;
    var phi_586_: bool;
    var phi_587_: f32;
    var phi_588_: bool;
    var phi_592_: f32;
    var phi_644_: i32;
    var phi_649_: i32;
    var phi_654_: i32;
    var phi_659_: i32;
    var phi_668_: i32;
    var phi_673_: i32;
    var phi_678_: i32;
    var phi_683_: i32;
    var phi_728_: evaluate_Verdict;
    var phi_729_: evaluate_Verdict;
    var phi_730_: bool;
    var phi_731_: evaluate_Verdict;
    var phi_732_: evaluate_Verdict;
    var phi_733_: bool;
    var phi_737_: evaluate_Verdict;

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
                phi_221_ = (_e88 == _e90);
                phi_222_ = false;
            } else {
                phi_221_ = bool();
                phi_222_ = true;
            }
            let _e93 = phi_221_;
            let _e95 = phi_222_;
            phi_223_ = _e93;
            phi_224_ = _e95;
        } else {
            phi_223_ = bool();
            phi_224_ = true;
        }
        let _e97 = phi_223_;
        let _e99 = phi_224_;
        if _e99 {
            phi_228_ = false;
        } else {
            phi_228_ = _e97;
        }
        let _e101 = phi_228_;
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
                    phi_299_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_298_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_298_ = false;
                    }
                    let _e162 = phi_298_;
                    phi_299_ = _e162;
                }
                let _e164 = phi_299_;
                if _e164 {
                    let _e166 = samples.member[(0u + _e64.first_primitive)].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_310_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_311_ = false;
                } else {
                    phi_310_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_311_ = true;
                }
                let _e185 = phi_310_;
                let _e187 = phi_311_;
                phi_312_ = _e185;
                phi_313_ = _e187;
            } else {
                phi_312_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_313_ = true;
            }
            let _e189 = phi_312_;
            let _e191 = phi_313_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_320_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_320_ = _e189;
            }
            let _e208 = phi_320_;
            phi_324_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_324_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_324_;
        if _e225.unnamed_1 {
            phi_731_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
            phi_732_ = evaluate_Verdict();
            phi_733_ = true;
        } else {
            let _e233 = samples.member[(0u + _e64.first_primitive)].position;
            let _e251 = ((((_e74.projection.row_w.x * _e233.x) + (_e74.projection.row_w.y * _e233.y)) + (_e74.projection.row_w.z * _e233.z)) + (_e74.projection.row_w.w * 1f));
            let _e265 = (((((_e74.projection.row_x.x * _e233.x) + (_e74.projection.row_x.y * _e233.y)) + (_e74.projection.row_x.z * _e233.z)) + (_e74.projection.row_x.w * 1f)) / _e251);
            let _e279 = (((((_e74.projection.row_y.x * _e233.x) + (_e74.projection.row_y.y * _e233.y)) + (_e74.projection.row_y.z * _e233.z)) + (_e74.projection.row_y.w * 1f)) / _e251);
            let _e292 = ((((_e74.projection.row_z.x * _e233.x) + (_e74.projection.row_z.y * _e233.y)) + (_e74.projection.row_z.z * _e233.z)) + (_e74.projection.row_z.w * 1f));
            if (_e251 > 0f) {
                if (_e265 >= 0f) {
                    phi_398_ = (_e265 <= 1f);
                } else {
                    phi_398_ = false;
                }
                let _e297 = phi_398_;
                if _e297 {
                    if (_e279 >= 0f) {
                        phi_407_ = (_e279 <= 1f);
                    } else {
                        phi_407_ = false;
                    }
                    let _e301 = phi_407_;
                    if _e301 {
                        if (_e292 >= 0f) {
                            phi_416_ = (_e292 <= 1f);
                        } else {
                            phi_416_ = false;
                        }
                        let _e305 = phi_416_;
                        phi_417_ = _e305;
                        phi_418_ = false;
                    } else {
                        phi_417_ = bool();
                        phi_418_ = true;
                    }
                    let _e307 = phi_417_;
                    let _e309 = phi_418_;
                    phi_419_ = _e307;
                    phi_420_ = _e309;
                } else {
                    phi_419_ = bool();
                    phi_420_ = true;
                }
                let _e311 = phi_419_;
                let _e313 = phi_420_;
                phi_421_ = _e311;
                phi_422_ = _e313;
            } else {
                phi_421_ = bool();
                phi_422_ = true;
            }
            let _e315 = phi_421_;
            let _e317 = phi_422_;
            if _e317 {
                phi_426_ = false;
            } else {
                phi_426_ = _e315;
            }
            let _e319 = phi_426_;
            if _e319 {
                if (0f > 0f) {
                    let _e322 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e324 = p.member.map_size;
                    let _e394 = ((abs(((((_e70.row_x.x * _e322.x) + (_e70.row_x.y * _e322.y)) + (_e70.row_x.z * _e322.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e322.x) + (_e70.row_y.y * _e322.y)) + (_e70.row_y.z * _e322.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e322.x) + (_e70.row_z.y * _e322.y)) + (_e70.row_z.z * _e322.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e324)));
                    if (_e394 < 0.002f) {
                        phi_516_ = _e394;
                    } else {
                        phi_516_ = 0.002f;
                    }
                    let _e397 = phi_516_;
                    phi_519_ = (_e292 - (0f * _e397));
                } else {
                    phi_519_ = _e292;
                }
                let _e401 = phi_519_;
                let _e403 = p.member.map_size;
                let _e404 = f32(_e403);
                let _e407 = ((_e265 * _e404) - 0.5f);
                let _e408 = ((_e279 * _e404) - 0.5f);
                if (_e407 > -8388608f) {
                    let _e420 = f32(select(0i, select(select(i32(_e407), i32(-2147483648), (_e407 < bitcast<f32>(3472883712u))), 2147483647i, (_e407 > bitcast<f32>(1325400063u))), (_e407 == _e407)));
                    if (_e420 > _e407) {
                        phi_548_ = 1f;
                    } else {
                        phi_548_ = 0f;
                    }
                    let _e423 = phi_548_;
                    if (_e407 < 8388608f) {
                        phi_553_ = (_e420 - _e423);
                        phi_554_ = false;
                    } else {
                        phi_553_ = f32();
                        phi_554_ = true;
                    }
                    let _e426 = phi_553_;
                    let _e428 = phi_554_;
                    phi_555_ = _e426;
                    phi_556_ = _e428;
                } else {
                    phi_555_ = f32();
                    phi_556_ = true;
                }
                let _e430 = phi_555_;
                let _e432 = phi_556_;
                if _e432 {
                    phi_560_ = _e407;
                } else {
                    phi_560_ = _e430;
                }
                let _e434 = phi_560_;
                if (_e408 > -8388608f) {
                    let _e446 = f32(select(0i, select(select(i32(_e408), i32(-2147483648), (_e408 < bitcast<f32>(3472883712u))), 2147483647i, (_e408 > bitcast<f32>(1325400063u))), (_e408 == _e408)));
                    if (_e446 > _e408) {
                        phi_580_ = 1f;
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e449 = phi_580_;
                    if (_e408 < 8388608f) {
                        phi_585_ = (_e446 - _e449);
                        phi_586_ = false;
                    } else {
                        phi_585_ = f32();
                        phi_586_ = true;
                    }
                    let _e452 = phi_585_;
                    let _e454 = phi_586_;
                    phi_587_ = _e452;
                    phi_588_ = _e454;
                } else {
                    phi_587_ = f32();
                    phi_588_ = true;
                }
                let _e456 = phi_587_;
                let _e458 = phi_588_;
                if _e458 {
                    phi_592_ = _e408;
                } else {
                    phi_592_ = _e456;
                }
                let _e460 = phi_592_;
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
                    phi_644_ = _e471;
                } else {
                    phi_644_ = 0i;
                }
                let _e505 = phi_644_;
                if (_e480 > 0i) {
                    phi_649_ = _e480;
                } else {
                    phi_649_ = 0i;
                }
                let _e508 = phi_649_;
                if (_e505 < _e502) {
                    phi_654_ = _e505;
                } else {
                    phi_654_ = _e502;
                }
                let _e511 = phi_654_;
                if (_e508 < _e502) {
                    phi_659_ = _e508;
                } else {
                    phi_659_ = _e502;
                }
                let _e514 = phi_659_;
                let _e515 = bitcast<u32>(_e511);
                let _e517 = (_e471 + 1i);
                let _e518 = (_e480 + 1i);
                if (_e517 > 0i) {
                    phi_668_ = _e517;
                } else {
                    phi_668_ = 0i;
                }
                let _e521 = phi_668_;
                if (_e518 > 0i) {
                    phi_673_ = _e518;
                } else {
                    phi_673_ = 0i;
                }
                let _e524 = phi_673_;
                if (_e521 < _e502) {
                    phi_678_ = _e521;
                } else {
                    phi_678_ = _e502;
                }
                let _e527 = phi_678_;
                if (_e524 < _e502) {
                    phi_683_ = _e524;
                } else {
                    phi_683_ = _e502;
                }
                let _e530 = phi_683_;
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
                phi_728_ = evaluate_Verdict(_e560, false);
                phi_729_ = evaluate_Verdict();
                phi_730_ = false;
            } else {
                phi_728_ = evaluate_Verdict();
                phi_729_ = evaluate_Verdict(1f, false);
                phi_730_ = true;
            }
            let _e564 = phi_728_;
            let _e566 = phi_729_;
            let _e568 = phi_730_;
            phi_731_ = _e566;
            phi_732_ = _e564;
            phi_733_ = _e568;
        }
        let _e570 = phi_731_;
        let _e572 = phi_732_;
        let _e574 = phi_733_;
        if _e574 {
            phi_737_ = _e570;
        } else {
            phi_737_ = _e572;
        }
        let _e576 = phi_737_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e576.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
