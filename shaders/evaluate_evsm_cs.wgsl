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

struct type_27 {
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
var<uniform> p: type_27;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_143_: lt_bvh_traverse_Tree;
    var phi_144_: bool;
    var phi_145_: lt_bvh_traverse_Tree;
    var phi_146_: bool;
    var phi_151_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_143_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_144_ = false;
        } else {
            phi_143_ = lt_bvh_traverse_Tree();
            phi_144_ = true;
        }
        let _e60 = phi_143_;
        let _e62 = phi_144_;
        phi_145_ = _e60;
        phi_146_ = _e62;
    } else {
        phi_145_ = lt_bvh_traverse_Tree();
        phi_146_ = true;
    }
    let _e64 = phi_145_;
    let _e66 = phi_146_;
    if _e66 {
        phi_151_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_151_ = _e64;
    }
    let _e71 = phi_151_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> lt_math_Evsm {
    return lt_math_Evsm(param_3.x, param_3.y, param_3.z);
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_4: ptr<function, lt_math_Evsm>, param_5: vec4<f32>, param_6: vec4<f32>) -> f32 {
    var phi_863_: bool;
    var phi_867_: f32;
    var phi_886_: f32;
    var phi_891_: f32;
    var phi_913_: f32;
    var phi_918_: f32;
    var phi_919_: bool;
    var phi_920_: f32;
    var phi_921_: bool;
    var phi_925_: f32;
    var phi_963_: f32;
    var phi_974_: f32;
    var phi_979_: f32;
    var phi_1001_: f32;
    var phi_1006_: f32;
    var phi_1007_: bool;
    var phi_1008_: f32;
    var phi_1009_: bool;
    var phi_1013_: f32;
    var phi_1051_: f32;
    var phi_1062_: f32;
    var phi_1067_: f32;
    var phi_1089_: f32;
    var phi_1094_: f32;
    var phi_1095_: bool;
    var phi_1096_: f32;
    var phi_1097_: bool;
    var phi_1101_: f32;
    var phi_1139_: f32;
    var phi_1150_: f32;
    var phi_1155_: f32;
    var phi_1177_: f32;
    var phi_1182_: f32;
    var phi_1183_: bool;
    var phi_1184_: f32;
    var phi_1185_: bool;
    var phi_1189_: f32;
    var phi_1227_: f32;
    var phi_1280_: bool;
    var phi_1284_: f32;
    var phi_1296_: bool;
    var phi_1303_: f32;
    var phi_1316_: bool;
    var phi_1320_: f32;
    var phi_1340_: f32;
    var phi_1345_: f32;
    var phi_1367_: f32;
    var phi_1372_: f32;
    var phi_1373_: bool;
    var phi_1374_: f32;
    var phi_1375_: bool;
    var phi_1379_: f32;
    var phi_1417_: f32;
    var phi_1428_: f32;
    var phi_1433_: f32;
    var phi_1455_: f32;
    var phi_1460_: f32;
    var phi_1461_: bool;
    var phi_1462_: f32;
    var phi_1463_: bool;
    var phi_1467_: f32;
    var phi_1505_: f32;
    var phi_1516_: f32;
    var phi_1521_: f32;
    var phi_1543_: f32;
    var phi_1548_: f32;
    var phi_1549_: bool;
    var phi_1550_: f32;
    var phi_1551_: bool;
    var phi_1555_: f32;
    var phi_1593_: f32;
    var phi_1604_: f32;
    var phi_1609_: f32;
    var phi_1631_: f32;
    var phi_1636_: f32;
    var phi_1637_: bool;
    var phi_1638_: f32;
    var phi_1639_: bool;
    var phi_1643_: f32;
    var phi_1681_: f32;
    var phi_1734_: bool;
    var phi_1738_: f32;
    var phi_1750_: bool;
    var phi_1757_: f32;
    var phi_1768_: bool;
    var phi_1772_: f32;
    var phi_1787_: f32;
    var phi_1788_: f32;
    var phi_1789_: f32;

    let _e51 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_863_ = true;
    } else {
        let _e55 = (42f < _e51);
        if _e55 {
        }
        phi_863_ = _e55;
    }
    let _e57 = phi_863_;
    if _e57 {
        phi_867_ = 42f;
    } else {
        phi_867_ = _e51;
    }
    let _e59 = phi_867_;
    let _e61 = (_e59 * param_5.x);
    let _e63 = (_e59 * param_5.y);
    let _e65 = (_e59 * param_5.z);
    let _e67 = (_e59 * param_5.w);
    if ((bitcast<u32>(_e61) & 2147483647u) > 2139095040u) {
        phi_963_ = _e61;
    } else {
        if (_e61 < -87f) {
            phi_886_ = -87f;
        } else {
            phi_886_ = _e61;
        }
        let _e73 = phi_886_;
        if (_e73 > 88f) {
            phi_891_ = 88f;
        } else {
            phi_891_ = _e73;
        }
        let _e76 = phi_891_;
        let _e78 = ((_e76 * 1.442695f) + 0.5f);
        if (_e78 > -8388608f) {
            let _e90 = f32(select(0i, select(select(i32(_e78), i32(-2147483648), (_e78 < bitcast<f32>(3472883712u))), 2147483647i, (_e78 > bitcast<f32>(1325400063u))), (_e78 == _e78)));
            if (_e90 > _e78) {
                phi_913_ = 1f;
            } else {
                phi_913_ = 0f;
            }
            let _e93 = phi_913_;
            if (_e78 < 8388608f) {
                phi_918_ = (_e90 - _e93);
                phi_919_ = false;
            } else {
                phi_918_ = f32();
                phi_919_ = true;
            }
            let _e96 = phi_918_;
            let _e98 = phi_919_;
            phi_920_ = _e96;
            phi_921_ = _e98;
        } else {
            phi_920_ = f32();
            phi_921_ = true;
        }
        let _e100 = phi_920_;
        let _e102 = phi_921_;
        if _e102 {
            phi_925_ = _e78;
        } else {
            phi_925_ = _e100;
        }
        let _e104 = phi_925_;
        let _e108 = ((_e76 - (_e104 * 0.69314575f)) - (_e104 * 0.0000014286068f));
        phi_963_ = ((((((((((((((((1f / 5040f) * _e108) + (1f / 720f)) * _e108) + (1f / 120f)) * _e108) + (1f / 24f)) * _e108) + (1f / 6f)) * _e108) + 0.5f) * _e108) + 1f) * _e108) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e104), i32(-2147483648), (_e104 < bitcast<f32>(3472883712u))), 2147483647i, (_e104 > bitcast<f32>(1325400063u))), (_e104 == _e104)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e144 = phi_963_;
    if ((bitcast<u32>(_e63) & 2147483647u) > 2139095040u) {
        phi_1051_ = _e63;
    } else {
        if (_e63 < -87f) {
            phi_974_ = -87f;
        } else {
            phi_974_ = _e63;
        }
        let _e150 = phi_974_;
        if (_e150 > 88f) {
            phi_979_ = 88f;
        } else {
            phi_979_ = _e150;
        }
        let _e153 = phi_979_;
        let _e155 = ((_e153 * 1.442695f) + 0.5f);
        if (_e155 > -8388608f) {
            let _e167 = f32(select(0i, select(select(i32(_e155), i32(-2147483648), (_e155 < bitcast<f32>(3472883712u))), 2147483647i, (_e155 > bitcast<f32>(1325400063u))), (_e155 == _e155)));
            if (_e167 > _e155) {
                phi_1001_ = 1f;
            } else {
                phi_1001_ = 0f;
            }
            let _e170 = phi_1001_;
            if (_e155 < 8388608f) {
                phi_1006_ = (_e167 - _e170);
                phi_1007_ = false;
            } else {
                phi_1006_ = f32();
                phi_1007_ = true;
            }
            let _e173 = phi_1006_;
            let _e175 = phi_1007_;
            phi_1008_ = _e173;
            phi_1009_ = _e175;
        } else {
            phi_1008_ = f32();
            phi_1009_ = true;
        }
        let _e177 = phi_1008_;
        let _e179 = phi_1009_;
        if _e179 {
            phi_1013_ = _e155;
        } else {
            phi_1013_ = _e177;
        }
        let _e181 = phi_1013_;
        let _e185 = ((_e153 - (_e181 * 0.69314575f)) - (_e181 * 0.0000014286068f));
        phi_1051_ = ((((((((((((((((1f / 5040f) * _e185) + (1f / 720f)) * _e185) + (1f / 120f)) * _e185) + (1f / 24f)) * _e185) + (1f / 6f)) * _e185) + 0.5f) * _e185) + 1f) * _e185) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e181), i32(-2147483648), (_e181 < bitcast<f32>(3472883712u))), 2147483647i, (_e181 > bitcast<f32>(1325400063u))), (_e181 == _e181)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e221 = phi_1051_;
    if ((bitcast<u32>(_e65) & 2147483647u) > 2139095040u) {
        phi_1139_ = _e65;
    } else {
        if (_e65 < -87f) {
            phi_1062_ = -87f;
        } else {
            phi_1062_ = _e65;
        }
        let _e227 = phi_1062_;
        if (_e227 > 88f) {
            phi_1067_ = 88f;
        } else {
            phi_1067_ = _e227;
        }
        let _e230 = phi_1067_;
        let _e232 = ((_e230 * 1.442695f) + 0.5f);
        if (_e232 > -8388608f) {
            let _e244 = f32(select(0i, select(select(i32(_e232), i32(-2147483648), (_e232 < bitcast<f32>(3472883712u))), 2147483647i, (_e232 > bitcast<f32>(1325400063u))), (_e232 == _e232)));
            if (_e244 > _e232) {
                phi_1089_ = 1f;
            } else {
                phi_1089_ = 0f;
            }
            let _e247 = phi_1089_;
            if (_e232 < 8388608f) {
                phi_1094_ = (_e244 - _e247);
                phi_1095_ = false;
            } else {
                phi_1094_ = f32();
                phi_1095_ = true;
            }
            let _e250 = phi_1094_;
            let _e252 = phi_1095_;
            phi_1096_ = _e250;
            phi_1097_ = _e252;
        } else {
            phi_1096_ = f32();
            phi_1097_ = true;
        }
        let _e254 = phi_1096_;
        let _e256 = phi_1097_;
        if _e256 {
            phi_1101_ = _e232;
        } else {
            phi_1101_ = _e254;
        }
        let _e258 = phi_1101_;
        let _e262 = ((_e230 - (_e258 * 0.69314575f)) - (_e258 * 0.0000014286068f));
        phi_1139_ = ((((((((((((((((1f / 5040f) * _e262) + (1f / 720f)) * _e262) + (1f / 120f)) * _e262) + (1f / 24f)) * _e262) + (1f / 6f)) * _e262) + 0.5f) * _e262) + 1f) * _e262) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e258), i32(-2147483648), (_e258 < bitcast<f32>(3472883712u))), 2147483647i, (_e258 > bitcast<f32>(1325400063u))), (_e258 == _e258)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e298 = phi_1139_;
    if ((bitcast<u32>(_e67) & 2147483647u) > 2139095040u) {
        phi_1227_ = _e67;
    } else {
        if (_e67 < -87f) {
            phi_1150_ = -87f;
        } else {
            phi_1150_ = _e67;
        }
        let _e304 = phi_1150_;
        if (_e304 > 88f) {
            phi_1155_ = 88f;
        } else {
            phi_1155_ = _e304;
        }
        let _e307 = phi_1155_;
        let _e309 = ((_e307 * 1.442695f) + 0.5f);
        if (_e309 > -8388608f) {
            let _e321 = f32(select(0i, select(select(i32(_e309), i32(-2147483648), (_e309 < bitcast<f32>(3472883712u))), 2147483647i, (_e309 > bitcast<f32>(1325400063u))), (_e309 == _e309)));
            if (_e321 > _e309) {
                phi_1177_ = 1f;
            } else {
                phi_1177_ = 0f;
            }
            let _e324 = phi_1177_;
            if (_e309 < 8388608f) {
                phi_1182_ = (_e321 - _e324);
                phi_1183_ = false;
            } else {
                phi_1182_ = f32();
                phi_1183_ = true;
            }
            let _e327 = phi_1182_;
            let _e329 = phi_1183_;
            phi_1184_ = _e327;
            phi_1185_ = _e329;
        } else {
            phi_1184_ = f32();
            phi_1185_ = true;
        }
        let _e331 = phi_1184_;
        let _e333 = phi_1185_;
        if _e333 {
            phi_1189_ = _e309;
        } else {
            phi_1189_ = _e331;
        }
        let _e335 = phi_1189_;
        let _e339 = ((_e307 - (_e335 * 0.69314575f)) - (_e335 * 0.0000014286068f));
        phi_1227_ = ((((((((((((((((1f / 5040f) * _e339) + (1f / 720f)) * _e339) + (1f / 120f)) * _e339) + (1f / 24f)) * _e339) + (1f / 6f)) * _e339) + 0.5f) * _e339) + 1f) * _e339) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e335), i32(-2147483648), (_e335 < bitcast<f32>(3472883712u))), 2147483647i, (_e335 > bitcast<f32>(1325400063u))), (_e335 == _e335)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e375 = phi_1227_;
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
        phi_1280_ = true;
    } else {
        let _e421 = (_e387 > _e417);
        if _e421 {
        }
        phi_1280_ = _e421;
    }
    let _e423 = phi_1280_;
    if _e423 {
        phi_1284_ = _e387;
    } else {
        phi_1284_ = _e417;
    }
    let _e425 = phi_1284_;
    let _e426 = -(_e398);
    if (_e426 <= 0f) {
        let _e430 = ((bitcast<u32>(_e425) & 2147483647u) > 2139095040u);
        if _e430 {
        }
        phi_1296_ = _e430;
    } else {
        phi_1296_ = true;
    }
    let _e432 = phi_1296_;
    if _e432 {
        phi_1303_ = (_e425 / (_e425 + (_e426 * _e426)));
    } else {
        phi_1303_ = 1f;
    }
    let _e437 = phi_1303_;
    let _e439 = (*param_4).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_1316_ = true;
    } else {
        let _e443 = (42f < _e439);
        if _e443 {
        }
        phi_1316_ = _e443;
    }
    let _e445 = phi_1316_;
    if _e445 {
        phi_1320_ = 42f;
    } else {
        phi_1320_ = _e439;
    }
    let _e447 = phi_1320_;
    let _e448 = -(_e447);
    let _e450 = (_e448 * param_5.x);
    let _e452 = (_e448 * param_5.y);
    let _e454 = (_e448 * param_5.z);
    let _e456 = (_e448 * param_5.w);
    if ((bitcast<u32>(_e450) & 2147483647u) > 2139095040u) {
        phi_1417_ = _e450;
    } else {
        if (_e450 < -87f) {
            phi_1340_ = -87f;
        } else {
            phi_1340_ = _e450;
        }
        let _e462 = phi_1340_;
        if (_e462 > 88f) {
            phi_1345_ = 88f;
        } else {
            phi_1345_ = _e462;
        }
        let _e465 = phi_1345_;
        let _e467 = ((_e465 * 1.442695f) + 0.5f);
        if (_e467 > -8388608f) {
            let _e479 = f32(select(0i, select(select(i32(_e467), i32(-2147483648), (_e467 < bitcast<f32>(3472883712u))), 2147483647i, (_e467 > bitcast<f32>(1325400063u))), (_e467 == _e467)));
            if (_e479 > _e467) {
                phi_1367_ = 1f;
            } else {
                phi_1367_ = 0f;
            }
            let _e482 = phi_1367_;
            if (_e467 < 8388608f) {
                phi_1372_ = (_e479 - _e482);
                phi_1373_ = false;
            } else {
                phi_1372_ = f32();
                phi_1373_ = true;
            }
            let _e485 = phi_1372_;
            let _e487 = phi_1373_;
            phi_1374_ = _e485;
            phi_1375_ = _e487;
        } else {
            phi_1374_ = f32();
            phi_1375_ = true;
        }
        let _e489 = phi_1374_;
        let _e491 = phi_1375_;
        if _e491 {
            phi_1379_ = _e467;
        } else {
            phi_1379_ = _e489;
        }
        let _e493 = phi_1379_;
        let _e497 = ((_e465 - (_e493 * 0.69314575f)) - (_e493 * 0.0000014286068f));
        phi_1417_ = ((((((((((((((((1f / 5040f) * _e497) + (1f / 720f)) * _e497) + (1f / 120f)) * _e497) + (1f / 24f)) * _e497) + (1f / 6f)) * _e497) + 0.5f) * _e497) + 1f) * _e497) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e493), i32(-2147483648), (_e493 < bitcast<f32>(3472883712u))), 2147483647i, (_e493 > bitcast<f32>(1325400063u))), (_e493 == _e493)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e533 = phi_1417_;
    if ((bitcast<u32>(_e452) & 2147483647u) > 2139095040u) {
        phi_1505_ = _e452;
    } else {
        if (_e452 < -87f) {
            phi_1428_ = -87f;
        } else {
            phi_1428_ = _e452;
        }
        let _e539 = phi_1428_;
        if (_e539 > 88f) {
            phi_1433_ = 88f;
        } else {
            phi_1433_ = _e539;
        }
        let _e542 = phi_1433_;
        let _e544 = ((_e542 * 1.442695f) + 0.5f);
        if (_e544 > -8388608f) {
            let _e556 = f32(select(0i, select(select(i32(_e544), i32(-2147483648), (_e544 < bitcast<f32>(3472883712u))), 2147483647i, (_e544 > bitcast<f32>(1325400063u))), (_e544 == _e544)));
            if (_e556 > _e544) {
                phi_1455_ = 1f;
            } else {
                phi_1455_ = 0f;
            }
            let _e559 = phi_1455_;
            if (_e544 < 8388608f) {
                phi_1460_ = (_e556 - _e559);
                phi_1461_ = false;
            } else {
                phi_1460_ = f32();
                phi_1461_ = true;
            }
            let _e562 = phi_1460_;
            let _e564 = phi_1461_;
            phi_1462_ = _e562;
            phi_1463_ = _e564;
        } else {
            phi_1462_ = f32();
            phi_1463_ = true;
        }
        let _e566 = phi_1462_;
        let _e568 = phi_1463_;
        if _e568 {
            phi_1467_ = _e544;
        } else {
            phi_1467_ = _e566;
        }
        let _e570 = phi_1467_;
        let _e574 = ((_e542 - (_e570 * 0.69314575f)) - (_e570 * 0.0000014286068f));
        phi_1505_ = ((((((((((((((((1f / 5040f) * _e574) + (1f / 720f)) * _e574) + (1f / 120f)) * _e574) + (1f / 24f)) * _e574) + (1f / 6f)) * _e574) + 0.5f) * _e574) + 1f) * _e574) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e570), i32(-2147483648), (_e570 < bitcast<f32>(3472883712u))), 2147483647i, (_e570 > bitcast<f32>(1325400063u))), (_e570 == _e570)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e610 = phi_1505_;
    if ((bitcast<u32>(_e454) & 2147483647u) > 2139095040u) {
        phi_1593_ = _e454;
    } else {
        if (_e454 < -87f) {
            phi_1516_ = -87f;
        } else {
            phi_1516_ = _e454;
        }
        let _e616 = phi_1516_;
        if (_e616 > 88f) {
            phi_1521_ = 88f;
        } else {
            phi_1521_ = _e616;
        }
        let _e619 = phi_1521_;
        let _e621 = ((_e619 * 1.442695f) + 0.5f);
        if (_e621 > -8388608f) {
            let _e633 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
            if (_e633 > _e621) {
                phi_1543_ = 1f;
            } else {
                phi_1543_ = 0f;
            }
            let _e636 = phi_1543_;
            if (_e621 < 8388608f) {
                phi_1548_ = (_e633 - _e636);
                phi_1549_ = false;
            } else {
                phi_1548_ = f32();
                phi_1549_ = true;
            }
            let _e639 = phi_1548_;
            let _e641 = phi_1549_;
            phi_1550_ = _e639;
            phi_1551_ = _e641;
        } else {
            phi_1550_ = f32();
            phi_1551_ = true;
        }
        let _e643 = phi_1550_;
        let _e645 = phi_1551_;
        if _e645 {
            phi_1555_ = _e621;
        } else {
            phi_1555_ = _e643;
        }
        let _e647 = phi_1555_;
        let _e651 = ((_e619 - (_e647 * 0.69314575f)) - (_e647 * 0.0000014286068f));
        phi_1593_ = ((((((((((((((((1f / 5040f) * _e651) + (1f / 720f)) * _e651) + (1f / 120f)) * _e651) + (1f / 24f)) * _e651) + (1f / 6f)) * _e651) + 0.5f) * _e651) + 1f) * _e651) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e687 = phi_1593_;
    if ((bitcast<u32>(_e456) & 2147483647u) > 2139095040u) {
        phi_1681_ = _e456;
    } else {
        if (_e456 < -87f) {
            phi_1604_ = -87f;
        } else {
            phi_1604_ = _e456;
        }
        let _e693 = phi_1604_;
        if (_e693 > 88f) {
            phi_1609_ = 88f;
        } else {
            phi_1609_ = _e693;
        }
        let _e696 = phi_1609_;
        let _e698 = ((_e696 * 1.442695f) + 0.5f);
        if (_e698 > -8388608f) {
            let _e710 = f32(select(0i, select(select(i32(_e698), i32(-2147483648), (_e698 < bitcast<f32>(3472883712u))), 2147483647i, (_e698 > bitcast<f32>(1325400063u))), (_e698 == _e698)));
            if (_e710 > _e698) {
                phi_1631_ = 1f;
            } else {
                phi_1631_ = 0f;
            }
            let _e713 = phi_1631_;
            if (_e698 < 8388608f) {
                phi_1636_ = (_e710 - _e713);
                phi_1637_ = false;
            } else {
                phi_1636_ = f32();
                phi_1637_ = true;
            }
            let _e716 = phi_1636_;
            let _e718 = phi_1637_;
            phi_1638_ = _e716;
            phi_1639_ = _e718;
        } else {
            phi_1638_ = f32();
            phi_1639_ = true;
        }
        let _e720 = phi_1638_;
        let _e722 = phi_1639_;
        if _e722 {
            phi_1643_ = _e698;
        } else {
            phi_1643_ = _e720;
        }
        let _e724 = phi_1643_;
        let _e728 = ((_e696 - (_e724 * 0.69314575f)) - (_e724 * 0.0000014286068f));
        phi_1681_ = ((((((((((((((((1f / 5040f) * _e728) + (1f / 720f)) * _e728) + (1f / 120f)) * _e728) + (1f / 24f)) * _e728) + (1f / 6f)) * _e728) + 0.5f) * _e728) + 1f) * _e728) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e724), i32(-2147483648), (_e724 < bitcast<f32>(3472883712u))), 2147483647i, (_e724 > bitcast<f32>(1325400063u))), (_e724 == _e724)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e764 = phi_1681_;
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
        phi_1734_ = true;
    } else {
        let _e810 = (_e776 > _e806);
        if _e810 {
        }
        phi_1734_ = _e810;
    }
    let _e812 = phi_1734_;
    if _e812 {
        phi_1738_ = _e776;
    } else {
        phi_1738_ = _e806;
    }
    let _e814 = phi_1738_;
    let _e815 = -(_e787);
    if (_e815 <= 0f) {
        let _e819 = ((bitcast<u32>(_e814) & 2147483647u) > 2139095040u);
        if _e819 {
        }
        phi_1750_ = _e819;
    } else {
        phi_1750_ = true;
    }
    let _e821 = phi_1750_;
    if _e821 {
        phi_1757_ = (_e814 / (_e814 + (_e815 * _e815)));
    } else {
        phi_1757_ = 1f;
    }
    let _e826 = phi_1757_;
    if ((bitcast<u32>(_e826) & 2147483647u) > 2139095040u) {
        phi_1768_ = true;
    } else {
        let _e830 = (_e826 < _e437);
        if _e830 {
        }
        phi_1768_ = _e830;
    }
    let _e832 = phi_1768_;
    if _e832 {
        phi_1772_ = _e826;
    } else {
        phi_1772_ = _e437;
    }
    let _e834 = phi_1772_;
    if ((bitcast<u32>(_e834) & 2147483647u) > 2139095040u) {
        phi_1789_ = _e834;
    } else {
        if (_e834 < 0f) {
            phi_1788_ = 0f;
        } else {
            if (_e834 > 1f) {
                phi_1787_ = 1f;
            } else {
                phi_1787_ = _e834;
            }
            let _e841 = phi_1787_;
            phi_1788_ = _e841;
        }
        let _e843 = phi_1788_;
        phi_1789_ = _e843;
    }
    let _e845 = phi_1789_;
    return _e845;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_7: ptr<function, lt_math_Evsm>, param_8: vec4<f32>, param_9: vec4<f32>, param_10: f32) -> f32 {
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_730_: f32;
    var phi_731_: f32;
    var phi_732_: f32;
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_750_: f32;
    var phi_766_: f32;
    var phi_767_: f32;
    var phi_768_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: f32;
    var phi_823_: bool;
    var phi_824_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_831_: bool;
    var phi_832_: bool;
    var phi_833_: bool;
    var phi_837_: bool;
    var phi_841_: bool;
    var phi_846_: f32;

    if ((bitcast<u32>(param_10) & 2147483647u) > 2139095040u) {
        phi_714_ = param_10;
    } else {
        if (param_10 < 0f) {
            phi_713_ = 0f;
        } else {
            if (param_10 > 1f) {
                phi_712_ = 1f;
            } else {
                phi_712_ = param_10;
            }
            let _e57 = phi_712_;
            phi_713_ = _e57;
        }
        let _e59 = phi_713_;
        phi_714_ = _e59;
    }
    let _e61 = phi_714_;
    if ((bitcast<u32>(param_8.x) & 2147483647u) > 2139095040u) {
        phi_732_ = param_8.x;
    } else {
        if (param_8.x < 0f) {
            phi_731_ = 0f;
        } else {
            if (param_8.x > 1f) {
                phi_730_ = 1f;
            } else {
                phi_730_ = param_8.x;
            }
            let _e69 = phi_730_;
            phi_731_ = _e69;
        }
        let _e71 = phi_731_;
        phi_732_ = _e71;
    }
    let _e73 = phi_732_;
    if ((bitcast<u32>(param_8.y) & 2147483647u) > 2139095040u) {
        phi_750_ = param_8.y;
    } else {
        if (param_8.y < 0f) {
            phi_749_ = 0f;
        } else {
            if (param_8.y > 1f) {
                phi_748_ = 1f;
            } else {
                phi_748_ = param_8.y;
            }
            let _e81 = phi_748_;
            phi_749_ = _e81;
        }
        let _e83 = phi_749_;
        phi_750_ = _e83;
    }
    let _e85 = phi_750_;
    if ((bitcast<u32>(param_8.z) & 2147483647u) > 2139095040u) {
        phi_768_ = param_8.z;
    } else {
        if (param_8.z < 0f) {
            phi_767_ = 0f;
        } else {
            if (param_8.z > 1f) {
                phi_766_ = 1f;
            } else {
                phi_766_ = param_8.z;
            }
            let _e93 = phi_766_;
            phi_767_ = _e93;
        }
        let _e95 = phi_767_;
        phi_768_ = _e95;
    }
    let _e97 = phi_768_;
    if ((bitcast<u32>(param_8.w) & 2147483647u) > 2139095040u) {
        phi_786_ = param_8.w;
    } else {
        if (param_8.w < 0f) {
            phi_785_ = 0f;
        } else {
            if (param_8.w > 1f) {
                phi_784_ = 1f;
            } else {
                phi_784_ = param_8.w;
            }
            let _e105 = phi_784_;
            phi_785_ = _e105;
        }
        let _e107 = phi_785_;
        phi_786_ = _e107;
    }
    let _e109 = phi_786_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_823_ = !(((bitcast<u32>(((((_e110 * param_9.x) + (_e111 * param_9.y)) + (_e112 * param_9.z)) + (_e113 * param_9.w))) & 2147483647u) > 2139095040u));
                    phi_824_ = false;
                } else {
                    phi_823_ = bool();
                    phi_824_ = true;
                }
                let _e135 = phi_823_;
                let _e137 = phi_824_;
                phi_825_ = _e135;
                phi_826_ = false;
                phi_827_ = _e137;
            } else {
                phi_825_ = bool();
                phi_826_ = true;
                phi_827_ = false;
            }
            let _e139 = phi_825_;
            let _e141 = phi_826_;
            let _e143 = phi_827_;
            phi_828_ = _e139;
            phi_829_ = _e141;
            phi_830_ = _e143;
        } else {
            phi_828_ = bool();
            phi_829_ = true;
            phi_830_ = false;
        }
        let _e145 = phi_828_;
        let _e147 = phi_829_;
        let _e149 = phi_830_;
        phi_831_ = _e145;
        phi_832_ = _e147;
        phi_833_ = _e149;
    } else {
        phi_831_ = bool();
        phi_832_ = true;
        phi_833_ = false;
    }
    let _e151 = phi_831_;
    let _e153 = phi_832_;
    let _e155 = phi_833_;
    if _e153 {
        phi_837_ = true;
    } else {
        phi_837_ = _e155;
    }
    let _e157 = phi_837_;
    if _e157 {
        phi_841_ = false;
    } else {
        phi_841_ = _e151;
    }
    let _e159 = phi_841_;
    if _e159 {
        phi_846_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_7, vec4<f32>(_e110, _e111, _e112, _e113), param_9);
        phi_846_ = _e160;
    }
    let _e162 = phi_846_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_217_: bool;
    var phi_218_: bool;
    var phi_219_: bool;
    var phi_220_: bool;
    var phi_224_: bool;
    var phi_268_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_272_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_346_: bool;
    var phi_355_: bool;
    var phi_364_: bool;
    var phi_365_: bool;
    var phi_366_: bool;
    var phi_367_: bool;
    var phi_368_: bool;
    var phi_369_: bool;
    var phi_370_: bool;
    var phi_374_: bool;
    var phi_464_: f32;
    var phi_467_: f32;
    var phi_496_: f32;
    var phi_501_: f32;
    var phi_502_: bool;
    var phi_503_: f32;
    var phi_504_: bool;
    var phi_508_: f32;
    var phi_528_: f32;
    var phi_533_: f32;
    var phi_534_: bool;
    var phi_535_: f32;
    var phi_536_: bool;
    var phi_540_: f32;
    var phi_592_: i32;
    var phi_597_: i32;
    var phi_602_: i32;
    var phi_607_: i32;
    var phi_616_: i32;
    var phi_621_: i32;
    var phi_626_: i32;
    var phi_631_: i32;
    var phi_676_: evaluate_Verdict;
    var phi_677_: evaluate_Verdict;
    var phi_678_: bool;
    var phi_679_: evaluate_Verdict;
    var phi_680_: evaluate_Verdict;
    var phi_681_: bool;
    var phi_685_: evaluate_Verdict;

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
                phi_217_ = (_e89 == _e91);
                phi_218_ = false;
            } else {
                phi_217_ = bool();
                phi_218_ = true;
            }
            let _e94 = phi_217_;
            let _e96 = phi_218_;
            phi_219_ = _e94;
            phi_220_ = _e96;
        } else {
            phi_219_ = bool();
            phi_220_ = true;
        }
        let _e98 = phi_219_;
        let _e100 = phi_220_;
        if _e100 {
            phi_224_ = false;
        } else {
            phi_224_ = _e98;
        }
        let _e102 = phi_224_;
        if !(_e102) {
            let _e105 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e107 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e105.x * (_e76.x - (_e107.x * _e76.w))) + (_e105.y * (_e76.y - (_e107.y * _e76.w)))) + (_e105.z * (_e76.z - (_e107.z * _e76.w)))) > 0f) {
                let _e131 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e139 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e139.unnamed.visibility, false), _e139.unnamed_1);
                phi_268_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e145.unnamed, ((_e131 & 1u) == 0u));
            } else {
                let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
                phi_268_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
            }
            let _e165 = phi_268_;
            phi_272_ = _e165;
        } else {
            let _e171 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e171.unnamed.visibility, false), _e171.unnamed_1);
            phi_272_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e177.unnamed, true);
        }
        let _e182 = phi_272_;
        if _e182.unnamed_1 {
            phi_679_ = evaluate_Verdict(_e182.unnamed.visibility, _e182.unnamed.is_doubted);
            phi_680_ = evaluate_Verdict();
            phi_681_ = true;
        } else {
            let _e190 = samples.member[(0u + _e64.first_primitive)].position;
            let _e208 = ((((_e74.projection.row_w.x * _e190.x) + (_e74.projection.row_w.y * _e190.y)) + (_e74.projection.row_w.z * _e190.z)) + (_e74.projection.row_w.w * 1f));
            let _e222 = (((((_e74.projection.row_x.x * _e190.x) + (_e74.projection.row_x.y * _e190.y)) + (_e74.projection.row_x.z * _e190.z)) + (_e74.projection.row_x.w * 1f)) / _e208);
            let _e236 = (((((_e74.projection.row_y.x * _e190.x) + (_e74.projection.row_y.y * _e190.y)) + (_e74.projection.row_y.z * _e190.z)) + (_e74.projection.row_y.w * 1f)) / _e208);
            let _e249 = ((((_e74.projection.row_z.x * _e190.x) + (_e74.projection.row_z.y * _e190.y)) + (_e74.projection.row_z.z * _e190.z)) + (_e74.projection.row_z.w * 1f));
            if (_e208 > 0f) {
                if (_e222 >= 0f) {
                    phi_346_ = (_e222 <= 1f);
                } else {
                    phi_346_ = false;
                }
                let _e254 = phi_346_;
                if _e254 {
                    if (_e236 >= 0f) {
                        phi_355_ = (_e236 <= 1f);
                    } else {
                        phi_355_ = false;
                    }
                    let _e258 = phi_355_;
                    if _e258 {
                        if (_e249 >= 0f) {
                            phi_364_ = (_e249 <= 1f);
                        } else {
                            phi_364_ = false;
                        }
                        let _e262 = phi_364_;
                        phi_365_ = _e262;
                        phi_366_ = false;
                    } else {
                        phi_365_ = bool();
                        phi_366_ = true;
                    }
                    let _e264 = phi_365_;
                    let _e266 = phi_366_;
                    phi_367_ = _e264;
                    phi_368_ = _e266;
                } else {
                    phi_367_ = bool();
                    phi_368_ = true;
                }
                let _e268 = phi_367_;
                let _e270 = phi_368_;
                phi_369_ = _e268;
                phi_370_ = _e270;
            } else {
                phi_369_ = bool();
                phi_370_ = true;
            }
            let _e272 = phi_369_;
            let _e274 = phi_370_;
            if _e274 {
                phi_374_ = false;
            } else {
                phi_374_ = _e272;
            }
            let _e276 = phi_374_;
            if _e276 {
                if (0f > 0f) {
                    let _e279 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e281 = p.member.map_size;
                    let _e351 = ((abs(((((_e70.row_x.x * _e279.x) + (_e70.row_x.y * _e279.y)) + (_e70.row_x.z * _e279.z)) / (((_e70.row_x.x * _e70.row_x.x) + (_e70.row_x.y * _e70.row_x.y)) + (_e70.row_x.z * _e70.row_x.z)))) + abs(((((_e70.row_y.x * _e279.x) + (_e70.row_y.y * _e279.y)) + (_e70.row_y.z * _e279.z)) / (((_e70.row_y.x * _e70.row_y.x) + (_e70.row_y.y * _e70.row_y.y)) + (_e70.row_y.z * _e70.row_y.z))))) / (abs(((((_e70.row_z.x * _e279.x) + (_e70.row_z.y * _e279.y)) + (_e70.row_z.z * _e279.z)) / (((_e70.row_z.x * _e70.row_z.x) + (_e70.row_z.y * _e70.row_z.y)) + (_e70.row_z.z * _e70.row_z.z)))) * f32(_e281)));
                    if (_e351 < 0.002f) {
                        phi_464_ = _e351;
                    } else {
                        phi_464_ = 0.002f;
                    }
                    let _e354 = phi_464_;
                    phi_467_ = (_e249 - (0f * _e354));
                } else {
                    phi_467_ = _e249;
                }
                let _e358 = phi_467_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e222 * _e361) - 0.5f);
                let _e365 = ((_e236 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_496_ = 1f;
                    } else {
                        phi_496_ = 0f;
                    }
                    let _e380 = phi_496_;
                    if (_e364 < 8388608f) {
                        phi_501_ = (_e377 - _e380);
                        phi_502_ = false;
                    } else {
                        phi_501_ = f32();
                        phi_502_ = true;
                    }
                    let _e383 = phi_501_;
                    let _e385 = phi_502_;
                    phi_503_ = _e383;
                    phi_504_ = _e385;
                } else {
                    phi_503_ = f32();
                    phi_504_ = true;
                }
                let _e387 = phi_503_;
                let _e389 = phi_504_;
                if _e389 {
                    phi_508_ = _e364;
                } else {
                    phi_508_ = _e387;
                }
                let _e391 = phi_508_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_528_ = 1f;
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e406 = phi_528_;
                    if (_e365 < 8388608f) {
                        phi_533_ = (_e403 - _e406);
                        phi_534_ = false;
                    } else {
                        phi_533_ = f32();
                        phi_534_ = true;
                    }
                    let _e409 = phi_533_;
                    let _e411 = phi_534_;
                    phi_535_ = _e409;
                    phi_536_ = _e411;
                } else {
                    phi_535_ = f32();
                    phi_536_ = true;
                }
                let _e413 = phi_535_;
                let _e415 = phi_536_;
                if _e415 {
                    phi_540_ = _e365;
                } else {
                    phi_540_ = _e413;
                }
                let _e417 = phi_540_;
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
                    phi_592_ = _e428;
                } else {
                    phi_592_ = 0i;
                }
                let _e462 = phi_592_;
                if (_e437 > 0i) {
                    phi_597_ = _e437;
                } else {
                    phi_597_ = 0i;
                }
                let _e465 = phi_597_;
                if (_e462 < _e459) {
                    phi_602_ = _e462;
                } else {
                    phi_602_ = _e459;
                }
                let _e468 = phi_602_;
                if (_e465 < _e459) {
                    phi_607_ = _e465;
                } else {
                    phi_607_ = _e459;
                }
                let _e471 = phi_607_;
                let _e472 = bitcast<u32>(_e468);
                let _e474 = (_e428 + 1i);
                let _e475 = (_e437 + 1i);
                if (_e474 > 0i) {
                    phi_616_ = _e474;
                } else {
                    phi_616_ = 0i;
                }
                let _e478 = phi_616_;
                if (_e475 > 0i) {
                    phi_621_ = _e475;
                } else {
                    phi_621_ = 0i;
                }
                let _e481 = phi_621_;
                if (_e478 < _e459) {
                    phi_626_ = _e478;
                } else {
                    phi_626_ = _e459;
                }
                let _e484 = phi_626_;
                if (_e481 < _e459) {
                    phi_631_ = _e481;
                } else {
                    phi_631_ = _e459;
                }
                let _e487 = phi_631_;
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
                phi_676_ = evaluate_Verdict(_e517, false);
                phi_677_ = evaluate_Verdict();
                phi_678_ = false;
            } else {
                phi_676_ = evaluate_Verdict();
                phi_677_ = evaluate_Verdict(1f, false);
                phi_678_ = true;
            }
            let _e521 = phi_676_;
            let _e523 = phi_677_;
            let _e525 = phi_678_;
            phi_679_ = _e523;
            phi_680_ = _e521;
            phi_681_ = _e525;
        }
        let _e527 = phi_679_;
        let _e529 = phi_680_;
        let _e531 = phi_681_;
        if _e531 {
            phi_685_ = _e527;
        } else {
            phi_685_ = _e529;
        }
        let _e533 = phi_685_;
        if (_e64.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e64.first_primitive)] = _e533.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_evsm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
