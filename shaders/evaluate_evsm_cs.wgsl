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

struct type_27 {
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
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

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
        let _e60 = phi_142_;
        let _e62 = phi_143_;
        phi_144_ = _e60;
        phi_145_ = _e62;
    } else {
        phi_144_ = lt_bvh_traverse_Tree();
        phi_145_ = true;
    }
    let _e64 = phi_144_;
    let _e66 = phi_145_;
    if _e66 {
        phi_150_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_150_ = _e64;
    }
    let _e71 = phi_150_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_860_: bool;
    var phi_864_: f32;
    var phi_883_: f32;
    var phi_888_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_916_: bool;
    var phi_917_: f32;
    var phi_918_: bool;
    var phi_922_: f32;
    var phi_960_: f32;
    var phi_971_: f32;
    var phi_976_: f32;
    var phi_998_: f32;
    var phi_1003_: f32;
    var phi_1004_: bool;
    var phi_1005_: f32;
    var phi_1006_: bool;
    var phi_1010_: f32;
    var phi_1048_: f32;
    var phi_1059_: f32;
    var phi_1064_: f32;
    var phi_1086_: f32;
    var phi_1091_: f32;
    var phi_1092_: bool;
    var phi_1093_: f32;
    var phi_1094_: bool;
    var phi_1098_: f32;
    var phi_1136_: f32;
    var phi_1147_: f32;
    var phi_1152_: f32;
    var phi_1174_: f32;
    var phi_1179_: f32;
    var phi_1180_: bool;
    var phi_1181_: f32;
    var phi_1182_: bool;
    var phi_1186_: f32;
    var phi_1224_: f32;
    var phi_1277_: bool;
    var phi_1281_: f32;
    var phi_1293_: bool;
    var phi_1300_: f32;
    var phi_1313_: bool;
    var phi_1317_: f32;
    var phi_1337_: f32;
    var phi_1342_: f32;
    var phi_1364_: f32;
    var phi_1369_: f32;
    var phi_1370_: bool;
    var phi_1371_: f32;
    var phi_1372_: bool;
    var phi_1376_: f32;
    var phi_1414_: f32;
    var phi_1425_: f32;
    var phi_1430_: f32;
    var phi_1452_: f32;
    var phi_1457_: f32;
    var phi_1458_: bool;
    var phi_1459_: f32;
    var phi_1460_: bool;
    var phi_1464_: f32;
    var phi_1502_: f32;
    var phi_1513_: f32;
    var phi_1518_: f32;
    var phi_1540_: f32;
    var phi_1545_: f32;
    var phi_1546_: bool;
    var phi_1547_: f32;
    var phi_1548_: bool;
    var phi_1552_: f32;
    var phi_1590_: f32;
    var phi_1601_: f32;
    var phi_1606_: f32;
    var phi_1628_: f32;
    var phi_1633_: f32;
    var phi_1634_: bool;
    var phi_1635_: f32;
    var phi_1636_: bool;
    var phi_1640_: f32;
    var phi_1678_: f32;
    var phi_1731_: bool;
    var phi_1735_: f32;
    var phi_1747_: bool;
    var phi_1754_: f32;
    var phi_1765_: bool;
    var phi_1769_: f32;
    var phi_1784_: f32;
    var phi_1785_: f32;
    var phi_1786_: f32;

    let _e51 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_860_ = true;
    } else {
        let _e55 = (42f < _e51);
        if _e55 {
        }
        phi_860_ = _e55;
    }
    let _e57 = phi_860_;
    if _e57 {
        phi_864_ = 42f;
    } else {
        phi_864_ = _e51;
    }
    let _e59 = phi_864_;
    let _e61 = (_e59 * param_5.x);
    let _e63 = (_e59 * param_5.y);
    let _e65 = (_e59 * param_5.z);
    let _e67 = (_e59 * param_5.w);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_960_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_883_ = -87f;
        } else {
            phi_883_ = _e61;
        }
        let _e73 = phi_883_;
        if (_e73 > 88f) {
            phi_888_ = 88f;
        } else {
            phi_888_ = _e73;
        }
        let _e76 = phi_888_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_910_ = 1f;
            } else {
                phi_910_ = 0f;
            }
            let _e93 = phi_910_;
            if (_e78 < 8388608f) {
                phi_915_ = (_e90 - _e93);
                phi_916_ = false;
            } else {
                phi_915_ = f32();
                phi_916_ = true;
            }
            let _e96 = phi_915_;
            let _e98 = phi_916_;
            phi_917_ = _e96;
            phi_918_ = _e98;
        } else {
            phi_917_ = f32();
            phi_918_ = true;
        }
        let _e100 = phi_917_;
        let _e102 = phi_918_;
        if _e102 {
            phi_922_ = _e78;
        } else {
            phi_922_ = _e100;
        }
        let _e104 = phi_922_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_960_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_960_;
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_1048_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_971_ = -87f;
        } else {
            phi_971_ = _e63;
        }
        let _e150 = phi_971_;
        if (_e150 > 88f) {
            phi_976_ = 88f;
        } else {
            phi_976_ = _e150;
        }
        let _e153 = phi_976_;
        let _e155 = ((_e153 * 1.442695f) + 0.5f);
        if (_e155 > -8388608f) {
            let _e167 = f32(select(0i, select(select(i32(_e155), i32(-2147483648), (_e155 < bitcast<f32>(3472883712u))), 2147483647i, (_e155 > bitcast<f32>(1325400063u))), (_e155 == _e155)));
            if (_e167 > _e155) {
                phi_998_ = 1f;
            } else {
                phi_998_ = 0f;
            }
            let _e170 = phi_998_;
            if (_e155 < 8388608f) {
                phi_1003_ = (_e167 - _e170);
                phi_1004_ = false;
            } else {
                phi_1003_ = f32();
                phi_1004_ = true;
            }
            let _e173 = phi_1003_;
            let _e175 = phi_1004_;
            phi_1005_ = _e173;
            phi_1006_ = _e175;
        } else {
            phi_1005_ = f32();
            phi_1006_ = true;
        }
        let _e177 = phi_1005_;
        let _e179 = phi_1006_;
        if _e179 {
            phi_1010_ = _e155;
        } else {
            phi_1010_ = _e177;
        }
        let _e181 = phi_1010_;
        let _e185 = ((_e153 - (_e181 * 0.69314575f)) - (_e181 * 0.0000014286068f));
        phi_1048_ = ((((((((((((((((1f / 5040f) * _e185) + (1f / 720f)) * _e185) + (1f / 120f)) * _e185) + (1f / 24f)) * _e185) + (1f / 6f)) * _e185) + 0.5f) * _e185) + 1f) * _e185) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e181), i32(-2147483648), (_e181 < bitcast<f32>(3472883712u))), 2147483647i, (_e181 > bitcast<f32>(1325400063u))), (_e181 == _e181)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e221 = phi_1048_;
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_1136_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_1059_ = -87f;
        } else {
            phi_1059_ = _e65;
        }
        let _e227 = phi_1059_;
        if (_e227 > 88f) {
            phi_1064_ = 88f;
        } else {
            phi_1064_ = _e227;
        }
        let _e230 = phi_1064_;
        let _e232 = ((_e230 * 1.442695f) + 0.5f);
        if (_e232 > -8388608f) {
            let _e244 = f32(select(0i, select(select(i32(_e232), i32(-2147483648), (_e232 < bitcast<f32>(3472883712u))), 2147483647i, (_e232 > bitcast<f32>(1325400063u))), (_e232 == _e232)));
            if (_e244 > _e232) {
                phi_1086_ = 1f;
            } else {
                phi_1086_ = 0f;
            }
            let _e247 = phi_1086_;
            if (_e232 < 8388608f) {
                phi_1091_ = (_e244 - _e247);
                phi_1092_ = false;
            } else {
                phi_1091_ = f32();
                phi_1092_ = true;
            }
            let _e250 = phi_1091_;
            let _e252 = phi_1092_;
            phi_1093_ = _e250;
            phi_1094_ = _e252;
        } else {
            phi_1093_ = f32();
            phi_1094_ = true;
        }
        let _e254 = phi_1093_;
        let _e256 = phi_1094_;
        if _e256 {
            phi_1098_ = _e232;
        } else {
            phi_1098_ = _e254;
        }
        let _e258 = phi_1098_;
        let _e262 = ((_e230 - (_e258 * 0.69314575f)) - (_e258 * 0.0000014286068f));
        phi_1136_ = ((((((((((((((((1f / 5040f) * _e262) + (1f / 720f)) * _e262) + (1f / 120f)) * _e262) + (1f / 24f)) * _e262) + (1f / 6f)) * _e262) + 0.5f) * _e262) + 1f) * _e262) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < bitcast<f32>(3472883712u))), 2147483647i, (_e258 > bitcast<f32>(1325400063u))), (_e258 == _e258)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e298 = phi_1136_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_1224_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_1147_ = -87f;
        } else {
            phi_1147_ = _e67;
        }
        let _e304 = phi_1147_;
        if (_e304 > 88f) {
            phi_1152_ = 88f;
        } else {
            phi_1152_ = _e304;
        }
        let _e307 = phi_1152_;
        let _e309 = ((_e307 * 1.442695f) + 0.5f);
        if (_e309 > -8388608f) {
            let _e321 = f32(select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < bitcast<f32>(3472883712u))), 2147483647i, (_e309 > bitcast<f32>(1325400063u))), (_e309 == _e309)));
            if (_e321 > _e309) {
                phi_1174_ = 1f;
            } else {
                phi_1174_ = 0f;
            }
            let _e324 = phi_1174_;
            if (_e309 < 8388608f) {
                phi_1179_ = (_e321 - _e324);
                phi_1180_ = false;
            } else {
                phi_1179_ = f32();
                phi_1180_ = true;
            }
            let _e327 = phi_1179_;
            let _e329 = phi_1180_;
            phi_1181_ = _e327;
            phi_1182_ = _e329;
        } else {
            phi_1181_ = f32();
            phi_1182_ = true;
        }
        let _e331 = phi_1181_;
        let _e333 = phi_1182_;
        if _e333 {
            phi_1186_ = _e309;
        } else {
            phi_1186_ = _e331;
        }
        let _e335 = phi_1186_;
        let _e339 = ((_e307 - (_e335 * 0.69314575f)) - (_e335 * 0.0000014286068f));
        phi_1224_ = ((((((((((((((((1f / 5040f) * _e339) + (1f / 720f)) * _e339) + (1f / 120f)) * _e339) + (1f / 24f)) * _e339) + (1f / 6f)) * _e339) + 0.5f) * _e339) + 1f) * _e339) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < bitcast<f32>(3472883712u))), 2147483647i, (_e335 > bitcast<f32>(1325400063u))), (_e335 == _e335)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e375 = phi_1224_;
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
        phi_1277_ = true;
    } else {
        let _e421 = (_e387 > _e417);
        if _e421 {
        }
        phi_1277_ = _e421;
    }
    let _e423 = phi_1277_;
    if _e423 {
        phi_1281_ = _e387;
    } else {
        phi_1281_ = _e417;
    }
    let _e425 = phi_1281_;
    let _e426 = -(_e398);
    if (_e426 <= 0f) {
        let _e430 = ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u);
        if _e430 {
        }
        phi_1293_ = _e430;
    } else {
        phi_1293_ = true;
    }
    let _e432 = phi_1293_;
    if _e432 {
        phi_1300_ = (_e425 / (_e425 + (_e426 * _e426)));
    } else {
        phi_1300_ = 1f;
    }
    let _e437 = phi_1300_;
    let _e439 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_1313_ = true;
    } else {
        let _e443 = (42f < _e439);
        if _e443 {
        }
        phi_1313_ = _e443;
    }
    let _e445 = phi_1313_;
    if _e445 {
        phi_1317_ = 42f;
    } else {
        phi_1317_ = _e439;
    }
    let _e447 = phi_1317_;
    let _e448 = -(_e447);
    let _e450 = (_e448 * param_5.x);
    let _e452 = (_e448 * param_5.y);
    let _e454 = (_e448 * param_5.z);
    let _e456 = (_e448 * param_5.w);
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_1414_ = _e450;
    } else {
        if (_e450 < -87f) {
            phi_1337_ = -87f;
        } else {
            phi_1337_ = _e450;
        }
        let _e462 = phi_1337_;
        if (_e462 > 88f) {
            phi_1342_ = 88f;
        } else {
            phi_1342_ = _e462;
        }
        let _e465 = phi_1342_;
        let _e467 = ((_e465 * 1.442695f) + 0.5f);
        if (_e467 > -8388608f) {
            let _e479 = f32(select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < bitcast<f32>(3472883712u))), 2147483647i, (_e467 > bitcast<f32>(1325400063u))), (_e467 == _e467)));
            if (_e479 > _e467) {
                phi_1364_ = 1f;
            } else {
                phi_1364_ = 0f;
            }
            let _e482 = phi_1364_;
            if (_e467 < 8388608f) {
                phi_1369_ = (_e479 - _e482);
                phi_1370_ = false;
            } else {
                phi_1369_ = f32();
                phi_1370_ = true;
            }
            let _e485 = phi_1369_;
            let _e487 = phi_1370_;
            phi_1371_ = _e485;
            phi_1372_ = _e487;
        } else {
            phi_1371_ = f32();
            phi_1372_ = true;
        }
        let _e489 = phi_1371_;
        let _e491 = phi_1372_;
        if _e491 {
            phi_1376_ = _e467;
        } else {
            phi_1376_ = _e489;
        }
        let _e493 = phi_1376_;
        let _e497 = ((_e465 - (_e493 * 0.69314575f)) - (_e493 * 0.0000014286068f));
        phi_1414_ = ((((((((((((((((1f / 5040f) * _e497) + (1f / 720f)) * _e497) + (1f / 120f)) * _e497) + (1f / 24f)) * _e497) + (1f / 6f)) * _e497) + 0.5f) * _e497) + 1f) * _e497) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < bitcast<f32>(3472883712u))), 2147483647i, (_e493 > bitcast<f32>(1325400063u))), (_e493 == _e493)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e533 = phi_1414_;
    if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
        phi_1502_ = _e452;
    } else {
        if (_e452 < -87f) {
            phi_1425_ = -87f;
        } else {
            phi_1425_ = _e452;
        }
        let _e539 = phi_1425_;
        if (_e539 > 88f) {
            phi_1430_ = 88f;
        } else {
            phi_1430_ = _e539;
        }
        let _e542 = phi_1430_;
        let _e544 = ((_e542 * 1.442695f) + 0.5f);
        if (_e544 > -8388608f) {
            let _e556 = f32(select(0i, select(select(i32(_e544), i32(-2147483648), (_e544 < bitcast<f32>(3472883712u))), 2147483647i, (_e544 > bitcast<f32>(1325400063u))), (_e544 == _e544)));
            if (_e556 > _e544) {
                phi_1452_ = 1f;
            } else {
                phi_1452_ = 0f;
            }
            let _e559 = phi_1452_;
            if (_e544 < 8388608f) {
                phi_1457_ = (_e556 - _e559);
                phi_1458_ = false;
            } else {
                phi_1457_ = f32();
                phi_1458_ = true;
            }
            let _e562 = phi_1457_;
            let _e564 = phi_1458_;
            phi_1459_ = _e562;
            phi_1460_ = _e564;
        } else {
            phi_1459_ = f32();
            phi_1460_ = true;
        }
        let _e566 = phi_1459_;
        let _e568 = phi_1460_;
        if _e568 {
            phi_1464_ = _e544;
        } else {
            phi_1464_ = _e566;
        }
        let _e570 = phi_1464_;
        let _e574 = ((_e542 - (_e570 * 0.69314575f)) - (_e570 * 0.0000014286068f));
        phi_1502_ = ((((((((((((((((1f / 5040f) * _e574) + (1f / 720f)) * _e574) + (1f / 120f)) * _e574) + (1f / 24f)) * _e574) + (1f / 6f)) * _e574) + 0.5f) * _e574) + 1f) * _e574) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e570), i32(-2147483648), (_e570 < bitcast<f32>(3472883712u))), 2147483647i, (_e570 > bitcast<f32>(1325400063u))), (_e570 == _e570)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e610 = phi_1502_;
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_1590_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_1513_ = -87f;
        } else {
            phi_1513_ = _e454;
        }
        let _e616 = phi_1513_;
        if (_e616 > 88f) {
            phi_1518_ = 88f;
        } else {
            phi_1518_ = _e616;
        }
        let _e619 = phi_1518_;
        let _e621 = ((_e619 * 1.442695f) + 0.5f);
        if (_e621 > -8388608f) {
            let _e633 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
            if (_e633 > _e621) {
                phi_1540_ = 1f;
            } else {
                phi_1540_ = 0f;
            }
            let _e636 = phi_1540_;
            if (_e621 < 8388608f) {
                phi_1545_ = (_e633 - _e636);
                phi_1546_ = false;
            } else {
                phi_1545_ = f32();
                phi_1546_ = true;
            }
            let _e639 = phi_1545_;
            let _e641 = phi_1546_;
            phi_1547_ = _e639;
            phi_1548_ = _e641;
        } else {
            phi_1547_ = f32();
            phi_1548_ = true;
        }
        let _e643 = phi_1547_;
        let _e645 = phi_1548_;
        if _e645 {
            phi_1552_ = _e621;
        } else {
            phi_1552_ = _e643;
        }
        let _e647 = phi_1552_;
        let _e651 = ((_e619 - (_e647 * 0.69314575f)) - (_e647 * 0.0000014286068f));
        phi_1590_ = ((((((((((((((((1f / 5040f) * _e651) + (1f / 720f)) * _e651) + (1f / 120f)) * _e651) + (1f / 24f)) * _e651) + (1f / 6f)) * _e651) + 0.5f) * _e651) + 1f) * _e651) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e687 = phi_1590_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_1678_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_1601_ = -87f;
        } else {
            phi_1601_ = _e456;
        }
        let _e693 = phi_1601_;
        if (_e693 > 88f) {
            phi_1606_ = 88f;
        } else {
            phi_1606_ = _e693;
        }
        let _e696 = phi_1606_;
        let _e698 = ((_e696 * 1.442695f) + 0.5f);
        if (_e698 > -8388608f) {
            let _e710 = f32(select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < bitcast<f32>(3472883712u))), 2147483647i, (_e698 > bitcast<f32>(1325400063u))), (_e698 == _e698)));
            if (_e710 > _e698) {
                phi_1628_ = 1f;
            } else {
                phi_1628_ = 0f;
            }
            let _e713 = phi_1628_;
            if (_e698 < 8388608f) {
                phi_1633_ = (_e710 - _e713);
                phi_1634_ = false;
            } else {
                phi_1633_ = f32();
                phi_1634_ = true;
            }
            let _e716 = phi_1633_;
            let _e718 = phi_1634_;
            phi_1635_ = _e716;
            phi_1636_ = _e718;
        } else {
            phi_1635_ = f32();
            phi_1636_ = true;
        }
        let _e720 = phi_1635_;
        let _e722 = phi_1636_;
        if _e722 {
            phi_1640_ = _e698;
        } else {
            phi_1640_ = _e720;
        }
        let _e724 = phi_1640_;
        let _e728 = ((_e696 - (_e724 * 0.69314575f)) - (_e724 * 0.0000014286068f));
        phi_1678_ = ((((((((((((((((1f / 5040f) * _e728) + (1f / 720f)) * _e728) + (1f / 120f)) * _e728) + (1f / 24f)) * _e728) + (1f / 6f)) * _e728) + 0.5f) * _e728) + 1f) * _e728) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < bitcast<f32>(3472883712u))), 2147483647i, (_e724 > bitcast<f32>(1325400063u))), (_e724 == _e724)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e764 = phi_1678_;
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
        phi_1731_ = true;
    } else {
        let _e810 = (_e776 > _e806);
        if _e810 {
        }
        phi_1731_ = _e810;
    }
    let _e812 = phi_1731_;
    if _e812 {
        phi_1735_ = _e776;
    } else {
        phi_1735_ = _e806;
    }
    let _e814 = phi_1735_;
    let _e815 = -(_e787);
    if (_e815 <= 0f) {
        let _e819 = ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u);
        if _e819 {
        }
        phi_1747_ = _e819;
    } else {
        phi_1747_ = true;
    }
    let _e821 = phi_1747_;
    if _e821 {
        phi_1754_ = (_e814 / (_e814 + (_e815 * _e815)));
    } else {
        phi_1754_ = 1f;
    }
    let _e826 = phi_1754_;
    if ((bitcast<u32>(_e826) & 2147483647u) > 2139095040u) {
        phi_1765_ = true;
    } else {
        let _e830 = (_e826 < _e437);
        if _e830 {
        }
        phi_1765_ = _e830;
    }
    let _e832 = phi_1765_;
    if _e832 {
        phi_1769_ = _e826;
    } else {
        phi_1769_ = _e437;
    }
    let _e834 = phi_1769_;
    if ((bitcast<u32>(_e834) & 2147483647u) > 2139095040u) {
        phi_1786_ = _e834;
    } else {
        if (_e834 < 0f) {
            phi_1785_ = 0f;
        } else {
            if (_e834 > 1f) {
                phi_1784_ = 1f;
            } else {
                phi_1784_ = _e834;
            }
            let _e841 = phi_1784_;
            phi_1785_ = _e841;
        }
        let _e843 = phi_1785_;
        phi_1786_ = _e843;
    }
    let _e845 = phi_1786_;
    return _e845;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_709_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_727_: f32;
    var phi_728_: f32;
    var phi_729_: f32;
    var phi_745_: f32;
    var phi_746_: f32;
    var phi_747_: f32;
    var phi_763_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_820_: bool;
    var phi_821_: bool;
    var phi_822_: bool;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: bool;
    var phi_838_: bool;
    var phi_843_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_711_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_710_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_709_ = 1f;
            } else {
                phi_709_ = param_10;
            }
            let _e57 = phi_709_;
            phi_710_ = _e57;
        }
        let _e59 = phi_710_;
        phi_711_ = _e59;
    }
    let _e61 = phi_711_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_729_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_728_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_727_ = 1f;
            } else {
                phi_727_ = param_8.x;
            }
            let _e69 = phi_727_;
            phi_728_ = _e69;
        }
        let _e71 = phi_728_;
        phi_729_ = _e71;
    }
    let _e73 = phi_729_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_747_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_746_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_745_ = 1f;
            } else {
                phi_745_ = param_8.y;
            }
            let _e81 = phi_745_;
            phi_746_ = _e81;
        }
        let _e83 = phi_746_;
        phi_747_ = _e83;
    }
    let _e85 = phi_747_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_765_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_764_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_763_ = 1f;
            } else {
                phi_763_ = param_8.z;
            }
            let _e93 = phi_763_;
            phi_764_ = _e93;
        }
        let _e95 = phi_764_;
        phi_765_ = _e95;
    }
    let _e97 = phi_765_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_783_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_782_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_781_ = 1f;
            } else {
                phi_781_ = param_8.w;
            }
            let _e105 = phi_781_;
            phi_782_ = _e105;
        }
        let _e107 = phi_782_;
        phi_783_ = _e107;
    }
    let _e109 = phi_783_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_820_ = !(((bitcast<u32>(((((_e110 * param_9.x) + (_e111 * param_9.y)) + (_e112 * param_9.z)) + (_e113 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_821_ = false;
                } else {
                    phi_820_ = bool();
                    phi_821_ = true;
                }
                let _e135 = phi_820_;
                let _e137 = phi_821_;
                phi_822_ = _e135;
                phi_823_ = false;
                phi_824_ = _e137;
            } else {
                phi_822_ = bool();
                phi_823_ = true;
                phi_824_ = false;
            }
            let _e139 = phi_822_;
            let _e141 = phi_823_;
            let _e143 = phi_824_;
            phi_825_ = _e139;
            phi_826_ = _e141;
            phi_827_ = _e143;
        } else {
            phi_825_ = bool();
            phi_826_ = true;
            phi_827_ = false;
        }
        let _e145 = phi_825_;
        let _e147 = phi_826_;
        let _e149 = phi_827_;
        phi_828_ = _e145;
        phi_829_ = _e147;
        phi_830_ = _e149;
    } else {
        phi_828_ = bool();
        phi_829_ = true;
        phi_830_ = false;
    }
    let _e151 = phi_828_;
    let _e153 = phi_829_;
    let _e155 = phi_830_;
    if _e153 {
        phi_834_ = true;
    } else {
        phi_834_ = _e155;
    }
    let _e157 = phi_834_;
    if _e157 {
        phi_838_ = false;
    } else {
        phi_838_ = _e151;
    }
    let _e159 = phi_838_;
    if _e159 {
        phi_843_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e110, _e111, _e112, _e113), param_9);
        phi_843_ = _e160;
    }
    let _e162 = phi_843_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_213_: bool;
    var phi_214_: bool;
    var phi_215_: bool;
    var phi_216_: bool;
    var phi_220_: bool;
    var phi_264_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_268_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_345_: bool;
    var phi_354_: bool;
    var phi_363_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_368_: bool;
    var phi_369_: bool;
    var phi_373_: bool;
    var phi_467_: f32;
    var phi_470_: f32;
    var phi_499_: f32;
    var phi_504_: f32;
    var phi_505_: bool;
    var phi_506_: f32;
    var phi_507_: bool;
    var phi_511_: f32;
    var phi_531_: f32;
    var phi_536_: f32;
    var phi_537_: bool;
    var phi_538_: f32;
    var phi_539_: bool;
    var phi_543_: f32;
    var phi_593_: i32;
    var phi_598_: i32;
    var phi_603_: i32;
    var phi_608_: i32;
    var phi_617_: i32;
    var phi_622_: i32;
    var phi_627_: i32;
    var phi_632_: i32;
    var phi_673_: evaluate_Verdict;
    var phi_674_: evaluate_Verdict;
    var phi_675_: bool;
    var phi_676_: evaluate_Verdict;
    var phi_677_: evaluate_Verdict;
    var phi_678_: bool;
    var phi_682_: evaluate_Verdict;

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
                phi_213_ = (_e86 == _e88);
                phi_214_ = false;
            } else {
                phi_213_ = bool();
                phi_214_ = true;
            }
            let _e91 = phi_213_;
            let _e93 = phi_214_;
            phi_215_ = _e91;
            phi_216_ = _e93;
        } else {
            phi_215_ = bool();
            phi_216_ = true;
        }
        let _e95 = phi_215_;
        let _e97 = phi_216_;
        if _e97 {
            phi_220_ = false;
        } else {
            phi_220_ = _e95;
        }
        let _e99 = phi_220_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_264_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_264_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_264_;
            phi_268_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_268_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_268_;
        if _e179.unnamed_1 {
            phi_676_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
            phi_677_ = evaluate_Verdict();
            phi_678_ = true;
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
                    phi_345_ = (_e218 <= 1f);
                } else {
                    phi_345_ = false;
                }
                let _e250 = phi_345_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_354_ = (_e232 <= 1f);
                    } else {
                        phi_354_ = false;
                    }
                    let _e254 = phi_354_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_363_ = (_e245 <= 1f);
                        } else {
                            phi_363_ = false;
                        }
                        let _e258 = phi_363_;
                        phi_364_ = _e258;
                        phi_365_ = false;
                    } else {
                        phi_364_ = bool();
                        phi_365_ = true;
                    }
                    let _e260 = phi_364_;
                    let _e262 = phi_365_;
                    phi_366_ = _e260;
                    phi_367_ = _e262;
                } else {
                    phi_366_ = bool();
                    phi_367_ = true;
                }
                let _e264 = phi_366_;
                let _e266 = phi_367_;
                phi_368_ = _e264;
                phi_369_ = _e266;
            } else {
                phi_368_ = bool();
                phi_369_ = true;
            }
            let _e268 = phi_368_;
            let _e270 = phi_369_;
            if _e270 {
                phi_373_ = false;
            } else {
                phi_373_ = _e268;
            }
            let _e272 = phi_373_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_467_ = _e351;
                    } else {
                        phi_467_ = 0.002f;
                    }
                    let _e354 = phi_467_;
                    phi_470_ = (_e245 - (0f * _e354));
                } else {
                    phi_470_ = _e245;
                }
                let _e358 = phi_470_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_499_ = 1f;
                    } else {
                        phi_499_ = 0f;
                    }
                    let _e380 = phi_499_;
                    if (_e364 < 8388608f) {
                        phi_504_ = (_e377 - _e380);
                        phi_505_ = false;
                    } else {
                        phi_504_ = f32();
                        phi_505_ = true;
                    }
                    let _e383 = phi_504_;
                    let _e385 = phi_505_;
                    phi_506_ = _e383;
                    phi_507_ = _e385;
                } else {
                    phi_506_ = f32();
                    phi_507_ = true;
                }
                let _e387 = phi_506_;
                let _e389 = phi_507_;
                if _e389 {
                    phi_511_ = _e364;
                } else {
                    phi_511_ = _e387;
                }
                let _e391 = phi_511_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_531_ = 1f;
                    } else {
                        phi_531_ = 0f;
                    }
                    let _e406 = phi_531_;
                    if (_e365 < 8388608f) {
                        phi_536_ = (_e403 - _e406);
                        phi_537_ = false;
                    } else {
                        phi_536_ = f32();
                        phi_537_ = true;
                    }
                    let _e409 = phi_536_;
                    let _e411 = phi_537_;
                    phi_538_ = _e409;
                    phi_539_ = _e411;
                } else {
                    phi_538_ = f32();
                    phi_539_ = true;
                }
                let _e413 = phi_538_;
                let _e415 = phi_539_;
                if _e415 {
                    phi_543_ = _e365;
                } else {
                    phi_543_ = _e413;
                }
                let _e417 = phi_543_;
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
                    phi_593_ = _e428;
                } else {
                    phi_593_ = 0i;
                }
                let _e460 = phi_593_;
                if (_e437 > 0i) {
                    phi_598_ = _e437;
                } else {
                    phi_598_ = 0i;
                }
                let _e463 = phi_598_;
                if (_e460 < _e457) {
                    phi_603_ = _e460;
                } else {
                    phi_603_ = _e457;
                }
                let _e466 = phi_603_;
                if (_e463 < _e457) {
                    phi_608_ = _e463;
                } else {
                    phi_608_ = _e457;
                }
                let _e469 = phi_608_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (_e428 + 1i);
                let _e473 = (_e437 + 1i);
                if (_e472 > 0i) {
                    phi_617_ = _e472;
                } else {
                    phi_617_ = 0i;
                }
                let _e476 = phi_617_;
                if (_e473 > 0i) {
                    phi_622_ = _e473;
                } else {
                    phi_622_ = 0i;
                }
                let _e479 = phi_622_;
                if (_e476 < _e457) {
                    phi_627_ = _e476;
                } else {
                    phi_627_ = _e457;
                }
                let _e482 = phi_627_;
                if (_e479 < _e457) {
                    phi_632_ = _e479;
                } else {
                    phi_632_ = _e457;
                }
                let _e485 = phi_632_;
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
                phi_673_ = evaluate_Verdict(_e511, false);
                phi_674_ = evaluate_Verdict();
                phi_675_ = false;
            } else {
                phi_673_ = evaluate_Verdict();
                phi_674_ = evaluate_Verdict(1f, false);
                phi_675_ = true;
            }
            let _e515 = phi_673_;
            let _e517 = phi_674_;
            let _e519 = phi_675_;
            phi_676_ = _e517;
            phi_677_ = _e515;
            phi_678_ = _e519;
        }
        let _e521 = phi_676_;
        let _e523 = phi_677_;
        let _e525 = phi_678_;
        if _e525 {
            phi_682_ = _e521;
        } else {
            phi_682_ = _e523;
        }
        let _e527 = phi_682_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e527.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
