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

struct type_30 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
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

fn _lt_math_evsm_Evsm_positive(param_4: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_177_: bool;
    var phi_181_: f32;

    let _e49 = (*param_4).positive_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_177_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_177_ = _e53;
    }
    let _e55 = phi_177_;
    if _e55 {
        phi_181_ = 42f;
    } else {
        phi_181_ = _e49;
    }
    let _e57 = phi_181_;
    return _e57;
}

fn _lt_math_evsm_Evsm_negative(param_5: ptr<function, lt_math_Evsm>) -> f32 {
    var phi_196_: bool;
    var phi_200_: f32;

    let _e49 = (*param_5).negative_exponent;
    if ((bitcast<u32>(42f) & 2147483647u) > 2139095040u) {
        phi_196_ = true;
    } else {
        let _e53 = (42f < _e49);
        if _e53 {
        }
        phi_196_ = _e53;
    }
    let _e55 = phi_196_;
    if _e55 {
        phi_200_ = 42f;
    } else {
        phi_200_ = _e49;
    }
    let _e57 = phi_200_;
    return _e57;
}

fn _lt_math_evsm_Evsm_bound_of_offsets(param_6: ptr<function, lt_math_Evsm>, param_7: vec4<f32>, param_8: vec4<f32>) -> f32 {
    var phi_908_: f32;
    var phi_913_: f32;
    var phi_935_: f32;
    var phi_940_: f32;
    var phi_941_: bool;
    var phi_942_: f32;
    var phi_943_: bool;
    var phi_947_: f32;
    var phi_985_: f32;
    var phi_996_: f32;
    var phi_1001_: f32;
    var phi_1023_: f32;
    var phi_1028_: f32;
    var phi_1029_: bool;
    var phi_1030_: f32;
    var phi_1031_: bool;
    var phi_1035_: f32;
    var phi_1073_: f32;
    var phi_1084_: f32;
    var phi_1089_: f32;
    var phi_1111_: f32;
    var phi_1116_: f32;
    var phi_1117_: bool;
    var phi_1118_: f32;
    var phi_1119_: bool;
    var phi_1123_: f32;
    var phi_1161_: f32;
    var phi_1172_: f32;
    var phi_1177_: f32;
    var phi_1199_: f32;
    var phi_1204_: f32;
    var phi_1205_: bool;
    var phi_1206_: f32;
    var phi_1207_: bool;
    var phi_1211_: f32;
    var phi_1249_: f32;
    var phi_1302_: bool;
    var phi_1306_: f32;
    var phi_1318_: bool;
    var phi_1325_: f32;
    var phi_1346_: f32;
    var phi_1351_: f32;
    var phi_1373_: f32;
    var phi_1378_: f32;
    var phi_1379_: bool;
    var phi_1380_: f32;
    var phi_1381_: bool;
    var phi_1385_: f32;
    var phi_1423_: f32;
    var phi_1434_: f32;
    var phi_1439_: f32;
    var phi_1461_: f32;
    var phi_1466_: f32;
    var phi_1467_: bool;
    var phi_1468_: f32;
    var phi_1469_: bool;
    var phi_1473_: f32;
    var phi_1511_: f32;
    var phi_1522_: f32;
    var phi_1527_: f32;
    var phi_1549_: f32;
    var phi_1554_: f32;
    var phi_1555_: bool;
    var phi_1556_: f32;
    var phi_1557_: bool;
    var phi_1561_: f32;
    var phi_1599_: f32;
    var phi_1610_: f32;
    var phi_1615_: f32;
    var phi_1637_: f32;
    var phi_1642_: f32;
    var phi_1643_: bool;
    var phi_1644_: f32;
    var phi_1645_: bool;
    var phi_1649_: f32;
    var phi_1687_: f32;
    var phi_1740_: bool;
    var phi_1744_: f32;
    var phi_1756_: bool;
    var phi_1763_: f32;
    var phi_1774_: bool;
    var phi_1778_: f32;
    var phi_1793_: f32;
    var phi_1794_: f32;
    var phi_1795_: f32;

    let _e50 = _lt_math_evsm_Evsm_positive(param_6);
    let _e52 = (_e50 * param_7.x);
    let _e54 = (_e50 * param_7.y);
    let _e56 = (_e50 * param_7.z);
    let _e58 = (_e50 * param_7.w);
    if ((bitcast<u32>(_e52) & 2147483647u) > 2139095040u) {
        phi_985_ = _e52;
    } else {
        if (_e52 < -87f) {
            phi_908_ = -87f;
        } else {
            phi_908_ = _e52;
        }
        let _e64 = phi_908_;
        if (_e64 > 88f) {
            phi_913_ = 88f;
        } else {
            phi_913_ = _e64;
        }
        let _e67 = phi_913_;
        let _e69 = ((_e67 * 1.442695f) + 0.5f);
        if (_e69 > -8388608f) {
            let _e81 = f32(select(0i, select(select(i32(_e69), i32(-2147483648), (_e69 < bitcast<f32>(3472883712u))), 2147483647i, (_e69 > bitcast<f32>(1325400063u))), (_e69 == _e69)));
            if (_e81 > _e69) {
                phi_935_ = 1f;
            } else {
                phi_935_ = 0f;
            }
            let _e84 = phi_935_;
            if (_e69 < 8388608f) {
                phi_940_ = (_e81 - _e84);
                phi_941_ = false;
            } else {
                phi_940_ = f32();
                phi_941_ = true;
            }
            let _e87 = phi_940_;
            let _e89 = phi_941_;
            phi_942_ = _e87;
            phi_943_ = _e89;
        } else {
            phi_942_ = f32();
            phi_943_ = true;
        }
        let _e91 = phi_942_;
        let _e93 = phi_943_;
        if _e93 {
            phi_947_ = _e69;
        } else {
            phi_947_ = _e91;
        }
        let _e95 = phi_947_;
        let _e99 = ((_e67 - (_e95 * 0.69314575f)) - (_e95 * 0.0000014286068f));
        phi_985_ = ((((((((((((((((1f / 5040f) * _e99) + (1f / 720f)) * _e99) + (1f / 120f)) * _e99) + (1f / 24f)) * _e99) + (1f / 6f)) * _e99) + 0.5f) * _e99) + 1f) * _e99) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e95), i32(-2147483648), (_e95 < bitcast<f32>(3472883712u))), 2147483647i, (_e95 > bitcast<f32>(1325400063u))), (_e95 == _e95)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e135 = phi_985_;
    if ((bitcast<u32>(_e54) & 2147483647u) > 2139095040u) {
        phi_1073_ = _e54;
    } else {
        if (_e54 < -87f) {
            phi_996_ = -87f;
        } else {
            phi_996_ = _e54;
        }
        let _e141 = phi_996_;
        if (_e141 > 88f) {
            phi_1001_ = 88f;
        } else {
            phi_1001_ = _e141;
        }
        let _e144 = phi_1001_;
        let _e146 = ((_e144 * 1.442695f) + 0.5f);
        if (_e146 > -8388608f) {
            let _e158 = f32(select(0i, select(select(i32(_e146), i32(-2147483648), (_e146 < bitcast<f32>(3472883712u))), 2147483647i, (_e146 > bitcast<f32>(1325400063u))), (_e146 == _e146)));
            if (_e158 > _e146) {
                phi_1023_ = 1f;
            } else {
                phi_1023_ = 0f;
            }
            let _e161 = phi_1023_;
            if (_e146 < 8388608f) {
                phi_1028_ = (_e158 - _e161);
                phi_1029_ = false;
            } else {
                phi_1028_ = f32();
                phi_1029_ = true;
            }
            let _e164 = phi_1028_;
            let _e166 = phi_1029_;
            phi_1030_ = _e164;
            phi_1031_ = _e166;
        } else {
            phi_1030_ = f32();
            phi_1031_ = true;
        }
        let _e168 = phi_1030_;
        let _e170 = phi_1031_;
        if _e170 {
            phi_1035_ = _e146;
        } else {
            phi_1035_ = _e168;
        }
        let _e172 = phi_1035_;
        let _e176 = ((_e144 - (_e172 * 0.69314575f)) - (_e172 * 0.0000014286068f));
        phi_1073_ = ((((((((((((((((1f / 5040f) * _e176) + (1f / 720f)) * _e176) + (1f / 120f)) * _e176) + (1f / 24f)) * _e176) + (1f / 6f)) * _e176) + 0.5f) * _e176) + 1f) * _e176) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e172), i32(-2147483648), (_e172 < bitcast<f32>(3472883712u))), 2147483647i, (_e172 > bitcast<f32>(1325400063u))), (_e172 == _e172)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e212 = phi_1073_;
    if ((bitcast<u32>(_e56) & 2147483647u) > 2139095040u) {
        phi_1161_ = _e56;
    } else {
        if (_e56 < -87f) {
            phi_1084_ = -87f;
        } else {
            phi_1084_ = _e56;
        }
        let _e218 = phi_1084_;
        if (_e218 > 88f) {
            phi_1089_ = 88f;
        } else {
            phi_1089_ = _e218;
        }
        let _e221 = phi_1089_;
        let _e223 = ((_e221 * 1.442695f) + 0.5f);
        if (_e223 > -8388608f) {
            let _e235 = f32(select(0i, select(select(i32(_e223), i32(-2147483648), (_e223 < bitcast<f32>(3472883712u))), 2147483647i, (_e223 > bitcast<f32>(1325400063u))), (_e223 == _e223)));
            if (_e235 > _e223) {
                phi_1111_ = 1f;
            } else {
                phi_1111_ = 0f;
            }
            let _e238 = phi_1111_;
            if (_e223 < 8388608f) {
                phi_1116_ = (_e235 - _e238);
                phi_1117_ = false;
            } else {
                phi_1116_ = f32();
                phi_1117_ = true;
            }
            let _e241 = phi_1116_;
            let _e243 = phi_1117_;
            phi_1118_ = _e241;
            phi_1119_ = _e243;
        } else {
            phi_1118_ = f32();
            phi_1119_ = true;
        }
        let _e245 = phi_1118_;
        let _e247 = phi_1119_;
        if _e247 {
            phi_1123_ = _e223;
        } else {
            phi_1123_ = _e245;
        }
        let _e249 = phi_1123_;
        let _e253 = ((_e221 - (_e249 * 0.69314575f)) - (_e249 * 0.0000014286068f));
        phi_1161_ = ((((((((((((((((1f / 5040f) * _e253) + (1f / 720f)) * _e253) + (1f / 120f)) * _e253) + (1f / 24f)) * _e253) + (1f / 6f)) * _e253) + 0.5f) * _e253) + 1f) * _e253) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e249), i32(-2147483648), (_e249 < bitcast<f32>(3472883712u))), 2147483647i, (_e249 > bitcast<f32>(1325400063u))), (_e249 == _e249)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e289 = phi_1161_;
    if ((bitcast<u32>(_e58) & 2147483647u) > 2139095040u) {
        phi_1249_ = _e58;
    } else {
        if (_e58 < -87f) {
            phi_1172_ = -87f;
        } else {
            phi_1172_ = _e58;
        }
        let _e295 = phi_1172_;
        if (_e295 > 88f) {
            phi_1177_ = 88f;
        } else {
            phi_1177_ = _e295;
        }
        let _e298 = phi_1177_;
        let _e300 = ((_e298 * 1.442695f) + 0.5f);
        if (_e300 > -8388608f) {
            let _e312 = f32(select(0i, select(select(i32(_e300), i32(-2147483648), (_e300 < bitcast<f32>(3472883712u))), 2147483647i, (_e300 > bitcast<f32>(1325400063u))), (_e300 == _e300)));
            if (_e312 > _e300) {
                phi_1199_ = 1f;
            } else {
                phi_1199_ = 0f;
            }
            let _e315 = phi_1199_;
            if (_e300 < 8388608f) {
                phi_1204_ = (_e312 - _e315);
                phi_1205_ = false;
            } else {
                phi_1204_ = f32();
                phi_1205_ = true;
            }
            let _e318 = phi_1204_;
            let _e320 = phi_1205_;
            phi_1206_ = _e318;
            phi_1207_ = _e320;
        } else {
            phi_1206_ = f32();
            phi_1207_ = true;
        }
        let _e322 = phi_1206_;
        let _e324 = phi_1207_;
        if _e324 {
            phi_1211_ = _e300;
        } else {
            phi_1211_ = _e322;
        }
        let _e326 = phi_1211_;
        let _e330 = ((_e298 - (_e326 * 0.69314575f)) - (_e326 * 0.0000014286068f));
        phi_1249_ = ((((((((((((((((1f / 5040f) * _e330) + (1f / 720f)) * _e330) + (1f / 120f)) * _e330) + (1f / 24f)) * _e330) + (1f / 6f)) * _e330) + 0.5f) * _e330) + 1f) * _e330) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e326), i32(-2147483648), (_e326 < bitcast<f32>(3472883712u))), 2147483647i, (_e326 > bitcast<f32>(1325400063u))), (_e326 == _e326)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e366 = phi_1249_;
    let _e368 = (_e135 - vec4<f32>(1f, 1f, 1f, 1f).x);
    let _e370 = (_e212 - vec4<f32>(1f, 1f, 1f, 1f).y);
    let _e372 = (_e289 - vec4<f32>(1f, 1f, 1f, 1f).z);
    let _e374 = (_e366 - vec4<f32>(1f, 1f, 1f, 1f).w);
    let _e376 = (*param_6).min_variance;
    let _e378 = ((_e376 * _e50) * _e50);
    let _e389 = ((((_e368 * param_8.x) + (_e370 * param_8.y)) + (_e372 * param_8.z)) + (_e374 * param_8.w));
    let _e390 = (_e368 - _e389);
    let _e391 = (_e370 - _e389);
    let _e392 = (_e372 - _e389);
    let _e393 = (_e374 - _e389);
    let _e408 = (((((_e390 * _e390) * param_8.x) + ((_e391 * _e391) * param_8.y)) + ((_e392 * _e392) * param_8.z)) + ((_e393 * _e393) * param_8.w));
    if ((bitcast<u32>(_e378) & 2147483647u) > 2139095040u) {
        phi_1302_ = true;
    } else {
        let _e412 = (_e378 > _e408);
        if _e412 {
        }
        phi_1302_ = _e412;
    }
    let _e414 = phi_1302_;
    if _e414 {
        phi_1306_ = _e378;
    } else {
        phi_1306_ = _e408;
    }
    let _e416 = phi_1306_;
    let _e417 = -(_e389);
    if (_e417 <= 0f) {
        let _e421 = ((bitcast<u32>(_e416) & 2147483647u) > 2139095040u);
        if _e421 {
        }
        phi_1318_ = _e421;
    } else {
        phi_1318_ = true;
    }
    let _e423 = phi_1318_;
    if _e423 {
        phi_1325_ = (_e416 / (_e416 + (_e417 * _e417)));
    } else {
        phi_1325_ = 1f;
    }
    let _e428 = phi_1325_;
    let _e429 = _lt_math_evsm_Evsm_negative(param_6);
    let _e430 = -(_e429);
    let _e432 = (_e430 * param_7.x);
    let _e434 = (_e430 * param_7.y);
    let _e436 = (_e430 * param_7.z);
    let _e438 = (_e430 * param_7.w);
    if ((bitcast<u32>(_e432) & 2147483647u) > 2139095040u) {
        phi_1423_ = _e432;
    } else {
        if (_e432 < -87f) {
            phi_1346_ = -87f;
        } else {
            phi_1346_ = _e432;
        }
        let _e444 = phi_1346_;
        if (_e444 > 88f) {
            phi_1351_ = 88f;
        } else {
            phi_1351_ = _e444;
        }
        let _e447 = phi_1351_;
        let _e449 = ((_e447 * 1.442695f) + 0.5f);
        if (_e449 > -8388608f) {
            let _e461 = f32(select(0i, select(select(i32(_e449), i32(-2147483648), (_e449 < bitcast<f32>(3472883712u))), 2147483647i, (_e449 > bitcast<f32>(1325400063u))), (_e449 == _e449)));
            if (_e461 > _e449) {
                phi_1373_ = 1f;
            } else {
                phi_1373_ = 0f;
            }
            let _e464 = phi_1373_;
            if (_e449 < 8388608f) {
                phi_1378_ = (_e461 - _e464);
                phi_1379_ = false;
            } else {
                phi_1378_ = f32();
                phi_1379_ = true;
            }
            let _e467 = phi_1378_;
            let _e469 = phi_1379_;
            phi_1380_ = _e467;
            phi_1381_ = _e469;
        } else {
            phi_1380_ = f32();
            phi_1381_ = true;
        }
        let _e471 = phi_1380_;
        let _e473 = phi_1381_;
        if _e473 {
            phi_1385_ = _e449;
        } else {
            phi_1385_ = _e471;
        }
        let _e475 = phi_1385_;
        let _e479 = ((_e447 - (_e475 * 0.69314575f)) - (_e475 * 0.0000014286068f));
        phi_1423_ = ((((((((((((((((1f / 5040f) * _e479) + (1f / 720f)) * _e479) + (1f / 120f)) * _e479) + (1f / 24f)) * _e479) + (1f / 6f)) * _e479) + 0.5f) * _e479) + 1f) * _e479) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e475), i32(-2147483648), (_e475 < bitcast<f32>(3472883712u))), 2147483647i, (_e475 > bitcast<f32>(1325400063u))), (_e475 == _e475)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e515 = phi_1423_;
    if ((bitcast<u32>(_e434) & 2147483647u) > 2139095040u) {
        phi_1511_ = _e434;
    } else {
        if (_e434 < -87f) {
            phi_1434_ = -87f;
        } else {
            phi_1434_ = _e434;
        }
        let _e521 = phi_1434_;
        if (_e521 > 88f) {
            phi_1439_ = 88f;
        } else {
            phi_1439_ = _e521;
        }
        let _e524 = phi_1439_;
        let _e526 = ((_e524 * 1.442695f) + 0.5f);
        if (_e526 > -8388608f) {
            let _e538 = f32(select(0i, select(select(i32(_e526), i32(-2147483648), (_e526 < bitcast<f32>(3472883712u))), 2147483647i, (_e526 > bitcast<f32>(1325400063u))), (_e526 == _e526)));
            if (_e538 > _e526) {
                phi_1461_ = 1f;
            } else {
                phi_1461_ = 0f;
            }
            let _e541 = phi_1461_;
            if (_e526 < 8388608f) {
                phi_1466_ = (_e538 - _e541);
                phi_1467_ = false;
            } else {
                phi_1466_ = f32();
                phi_1467_ = true;
            }
            let _e544 = phi_1466_;
            let _e546 = phi_1467_;
            phi_1468_ = _e544;
            phi_1469_ = _e546;
        } else {
            phi_1468_ = f32();
            phi_1469_ = true;
        }
        let _e548 = phi_1468_;
        let _e550 = phi_1469_;
        if _e550 {
            phi_1473_ = _e526;
        } else {
            phi_1473_ = _e548;
        }
        let _e552 = phi_1473_;
        let _e556 = ((_e524 - (_e552 * 0.69314575f)) - (_e552 * 0.0000014286068f));
        phi_1511_ = ((((((((((((((((1f / 5040f) * _e556) + (1f / 720f)) * _e556) + (1f / 120f)) * _e556) + (1f / 24f)) * _e556) + (1f / 6f)) * _e556) + 0.5f) * _e556) + 1f) * _e556) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e552), i32(-2147483648), (_e552 < bitcast<f32>(3472883712u))), 2147483647i, (_e552 > bitcast<f32>(1325400063u))), (_e552 == _e552)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e592 = phi_1511_;
    if ((bitcast<u32>(_e436) & 2147483647u) > 2139095040u) {
        phi_1599_ = _e436;
    } else {
        if (_e436 < -87f) {
            phi_1522_ = -87f;
        } else {
            phi_1522_ = _e436;
        }
        let _e598 = phi_1522_;
        if (_e598 > 88f) {
            phi_1527_ = 88f;
        } else {
            phi_1527_ = _e598;
        }
        let _e601 = phi_1527_;
        let _e603 = ((_e601 * 1.442695f) + 0.5f);
        if (_e603 > -8388608f) {
            let _e615 = f32(select(0i, select(select(i32(_e603), i32(-2147483648), (_e603 < bitcast<f32>(3472883712u))), 2147483647i, (_e603 > bitcast<f32>(1325400063u))), (_e603 == _e603)));
            if (_e615 > _e603) {
                phi_1549_ = 1f;
            } else {
                phi_1549_ = 0f;
            }
            let _e618 = phi_1549_;
            if (_e603 < 8388608f) {
                phi_1554_ = (_e615 - _e618);
                phi_1555_ = false;
            } else {
                phi_1554_ = f32();
                phi_1555_ = true;
            }
            let _e621 = phi_1554_;
            let _e623 = phi_1555_;
            phi_1556_ = _e621;
            phi_1557_ = _e623;
        } else {
            phi_1556_ = f32();
            phi_1557_ = true;
        }
        let _e625 = phi_1556_;
        let _e627 = phi_1557_;
        if _e627 {
            phi_1561_ = _e603;
        } else {
            phi_1561_ = _e625;
        }
        let _e629 = phi_1561_;
        let _e633 = ((_e601 - (_e629 * 0.69314575f)) - (_e629 * 0.0000014286068f));
        phi_1599_ = ((((((((((((((((1f / 5040f) * _e633) + (1f / 720f)) * _e633) + (1f / 120f)) * _e633) + (1f / 24f)) * _e633) + (1f / 6f)) * _e633) + 0.5f) * _e633) + 1f) * _e633) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e629), i32(-2147483648), (_e629 < bitcast<f32>(3472883712u))), 2147483647i, (_e629 > bitcast<f32>(1325400063u))), (_e629 == _e629)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e669 = phi_1599_;
    if ((bitcast<u32>(_e438) & 2147483647u) > 2139095040u) {
        phi_1687_ = _e438;
    } else {
        if (_e438 < -87f) {
            phi_1610_ = -87f;
        } else {
            phi_1610_ = _e438;
        }
        let _e675 = phi_1610_;
        if (_e675 > 88f) {
            phi_1615_ = 88f;
        } else {
            phi_1615_ = _e675;
        }
        let _e678 = phi_1615_;
        let _e680 = ((_e678 * 1.442695f) + 0.5f);
        if (_e680 > -8388608f) {
            let _e692 = f32(select(0i, select(select(i32(_e680), i32(-2147483648), (_e680 < bitcast<f32>(3472883712u))), 2147483647i, (_e680 > bitcast<f32>(1325400063u))), (_e680 == _e680)));
            if (_e692 > _e680) {
                phi_1637_ = 1f;
            } else {
                phi_1637_ = 0f;
            }
            let _e695 = phi_1637_;
            if (_e680 < 8388608f) {
                phi_1642_ = (_e692 - _e695);
                phi_1643_ = false;
            } else {
                phi_1642_ = f32();
                phi_1643_ = true;
            }
            let _e698 = phi_1642_;
            let _e700 = phi_1643_;
            phi_1644_ = _e698;
            phi_1645_ = _e700;
        } else {
            phi_1644_ = f32();
            phi_1645_ = true;
        }
        let _e702 = phi_1644_;
        let _e704 = phi_1645_;
        if _e704 {
            phi_1649_ = _e680;
        } else {
            phi_1649_ = _e702;
        }
        let _e706 = phi_1649_;
        let _e710 = ((_e678 - (_e706 * 0.69314575f)) - (_e706 * 0.0000014286068f));
        phi_1687_ = ((((((((((((((((1f / 5040f) * _e710) + (1f / 720f)) * _e710) + (1f / 120f)) * _e710) + (1f / 24f)) * _e710) + (1f / 6f)) * _e710) + 0.5f) * _e710) + 1f) * _e710) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e706), i32(-2147483648), (_e706 < bitcast<f32>(3472883712u))), 2147483647i, (_e706 > bitcast<f32>(1325400063u))), (_e706 == _e706)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e746 = phi_1687_;
    let _e748 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e515);
    let _e750 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e592);
    let _e752 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e669);
    let _e754 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e746);
    let _e756 = (*param_6).min_variance;
    let _e758 = ((_e756 * _e429) * _e429);
    let _e769 = ((((_e748 * param_8.x) + (_e750 * param_8.y)) + (_e752 * param_8.z)) + (_e754 * param_8.w));
    let _e770 = (_e748 - _e769);
    let _e771 = (_e750 - _e769);
    let _e772 = (_e752 - _e769);
    let _e773 = (_e754 - _e769);
    let _e788 = (((((_e770 * _e770) * param_8.x) + ((_e771 * _e771) * param_8.y)) + ((_e772 * _e772) * param_8.z)) + ((_e773 * _e773) * param_8.w));
    if ((bitcast<u32>(_e758) & 2147483647u) > 2139095040u) {
        phi_1740_ = true;
    } else {
        let _e792 = (_e758 > _e788);
        if _e792 {
        }
        phi_1740_ = _e792;
    }
    let _e794 = phi_1740_;
    if _e794 {
        phi_1744_ = _e758;
    } else {
        phi_1744_ = _e788;
    }
    let _e796 = phi_1744_;
    let _e797 = -(_e769);
    if (_e797 <= 0f) {
        let _e801 = ((bitcast<u32>(_e796) & 2147483647u) > 2139095040u);
        if _e801 {
        }
        phi_1756_ = _e801;
    } else {
        phi_1756_ = true;
    }
    let _e803 = phi_1756_;
    if _e803 {
        phi_1763_ = (_e796 / (_e796 + (_e797 * _e797)));
    } else {
        phi_1763_ = 1f;
    }
    let _e808 = phi_1763_;
    if ((bitcast<u32>(_e808) & 2147483647u) > 2139095040u) {
        phi_1774_ = true;
    } else {
        let _e812 = (_e808 < _e428);
        if _e812 {
        }
        phi_1774_ = _e812;
    }
    let _e814 = phi_1774_;
    if _e814 {
        phi_1778_ = _e808;
    } else {
        phi_1778_ = _e428;
    }
    let _e816 = phi_1778_;
    if ((bitcast<u32>(_e816) & 2147483647u) > 2139095040u) {
        phi_1795_ = _e816;
    } else {
        if (_e816 < 0f) {
            phi_1794_ = 0f;
        } else {
            if (_e816 > 1f) {
                phi_1793_ = 1f;
            } else {
                phi_1793_ = _e816;
            }
            let _e823 = phi_1793_;
            phi_1794_ = _e823;
        }
        let _e825 = phi_1794_;
        phi_1795_ = _e825;
    }
    let _e827 = phi_1795_;
    return _e827;
}

fn _lt_math_evsm_Evsm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_9: ptr<function, lt_math_Evsm>, param_10: vec4<f32>, param_11: vec4<f32>, param_12: f32) -> f32 {
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_768_: f32;
    var phi_769_: f32;
    var phi_770_: f32;
    var phi_786_: f32;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_822_: f32;
    var phi_823_: f32;
    var phi_824_: f32;
    var phi_861_: bool;
    var phi_862_: bool;
    var phi_863_: bool;
    var phi_864_: bool;
    var phi_865_: bool;
    var phi_866_: bool;
    var phi_867_: bool;
    var phi_868_: bool;
    var phi_869_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_875_: bool;
    var phi_879_: bool;
    var phi_884_: f32;

    if ((bitcast<u32>(param_12) & 2147483647u) > 2139095040u) {
        phi_752_ = param_12;
    } else {
        if (param_12 < 0f) {
            phi_751_ = 0f;
        } else {
            if (param_12 > 1f) {
                phi_750_ = 1f;
            } else {
                phi_750_ = param_12;
            }
            let _e57 = phi_750_;
            phi_751_ = _e57;
        }
        let _e59 = phi_751_;
        phi_752_ = _e59;
    }
    let _e61 = phi_752_;
    if ((bitcast<u32>(param_10.x) & 2147483647u) > 2139095040u) {
        phi_770_ = param_10.x;
    } else {
        if (param_10.x < 0f) {
            phi_769_ = 0f;
        } else {
            if (param_10.x > 1f) {
                phi_768_ = 1f;
            } else {
                phi_768_ = param_10.x;
            }
            let _e69 = phi_768_;
            phi_769_ = _e69;
        }
        let _e71 = phi_769_;
        phi_770_ = _e71;
    }
    let _e73 = phi_770_;
    if ((bitcast<u32>(param_10.y) & 2147483647u) > 2139095040u) {
        phi_788_ = param_10.y;
    } else {
        if (param_10.y < 0f) {
            phi_787_ = 0f;
        } else {
            if (param_10.y > 1f) {
                phi_786_ = 1f;
            } else {
                phi_786_ = param_10.y;
            }
            let _e81 = phi_786_;
            phi_787_ = _e81;
        }
        let _e83 = phi_787_;
        phi_788_ = _e83;
    }
    let _e85 = phi_788_;
    if ((bitcast<u32>(param_10.z) & 2147483647u) > 2139095040u) {
        phi_806_ = param_10.z;
    } else {
        if (param_10.z < 0f) {
            phi_805_ = 0f;
        } else {
            if (param_10.z > 1f) {
                phi_804_ = 1f;
            } else {
                phi_804_ = param_10.z;
            }
            let _e93 = phi_804_;
            phi_805_ = _e93;
        }
        let _e95 = phi_805_;
        phi_806_ = _e95;
    }
    let _e97 = phi_806_;
    if ((bitcast<u32>(param_10.w) & 2147483647u) > 2139095040u) {
        phi_824_ = param_10.w;
    } else {
        if (param_10.w < 0f) {
            phi_823_ = 0f;
        } else {
            if (param_10.w > 1f) {
                phi_822_ = 1f;
            } else {
                phi_822_ = param_10.w;
            }
            let _e105 = phi_822_;
            phi_823_ = _e105;
        }
        let _e107 = phi_823_;
        phi_824_ = _e107;
    }
    let _e109 = phi_824_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    if (_e110 >= 0f) {
        if (_e111 >= 0f) {
            if (_e112 >= 0f) {
                if (_e113 >= 0f) {
                    phi_861_ = !(((bitcast<u32>(((((_e110 * param_11.x) + (_e111 * param_11.y)) + (_e112 * param_11.z)) + (_e113 * param_11.w))) & 2147483647u) > 2139095040u));
                    phi_862_ = false;
                } else {
                    phi_861_ = bool();
                    phi_862_ = true;
                }
                let _e135 = phi_861_;
                let _e137 = phi_862_;
                phi_863_ = _e135;
                phi_864_ = false;
                phi_865_ = _e137;
            } else {
                phi_863_ = bool();
                phi_864_ = true;
                phi_865_ = false;
            }
            let _e139 = phi_863_;
            let _e141 = phi_864_;
            let _e143 = phi_865_;
            phi_866_ = _e139;
            phi_867_ = _e141;
            phi_868_ = _e143;
        } else {
            phi_866_ = bool();
            phi_867_ = true;
            phi_868_ = false;
        }
        let _e145 = phi_866_;
        let _e147 = phi_867_;
        let _e149 = phi_868_;
        phi_869_ = _e145;
        phi_870_ = _e147;
        phi_871_ = _e149;
    } else {
        phi_869_ = bool();
        phi_870_ = true;
        phi_871_ = false;
    }
    let _e151 = phi_869_;
    let _e153 = phi_870_;
    let _e155 = phi_871_;
    if _e153 {
        phi_875_ = true;
    } else {
        phi_875_ = _e155;
    }
    let _e157 = phi_875_;
    if _e157 {
        phi_879_ = false;
    } else {
        phi_879_ = _e151;
    }
    let _e159 = phi_879_;
    if _e159 {
        phi_884_ = 1f;
    } else {
        let _e160 = _lt_math_evsm_Evsm_bound_of_offsets(param_9, vec4<f32>(_e110, _e111, _e112, _e113), param_11);
        phi_884_ = _e160;
    }
    let _e162 = phi_884_;
    return _e162;
}

fn function_() {
    var local: lt_math_Evsm;
    var phi_254_: bool;
    var phi_255_: bool;
    var phi_256_: bool;
    var phi_257_: bool;
    var phi_261_: bool;
    var phi_305_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_309_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_386_: bool;
    var phi_395_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_414_: bool;
    var phi_508_: f32;
    var phi_511_: f32;
    var phi_540_: f32;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_547_: f32;
    var phi_548_: bool;
    var phi_552_: f32;
    var phi_572_: f32;
    var phi_577_: f32;
    var phi_578_: bool;
    var phi_579_: f32;
    var phi_580_: bool;
    var phi_584_: f32;
    var phi_634_: i32;
    var phi_639_: i32;
    var phi_644_: i32;
    var phi_649_: i32;
    var phi_658_: i32;
    var phi_663_: i32;
    var phi_668_: i32;
    var phi_673_: i32;
    var phi_714_: evaluate_Verdict;
    var phi_715_: evaluate_Verdict;
    var phi_716_: bool;
    var phi_717_: evaluate_Verdict;
    var phi_718_: evaluate_Verdict;
    var phi_719_: bool;
    var phi_723_: evaluate_Verdict;

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
                phi_254_ = (_e86 == _e88);
                phi_255_ = false;
            } else {
                phi_254_ = bool();
                phi_255_ = true;
            }
            let _e91 = phi_254_;
            let _e93 = phi_255_;
            phi_256_ = _e91;
            phi_257_ = _e93;
        } else {
            phi_256_ = bool();
            phi_257_ = true;
        }
        let _e95 = phi_256_;
        let _e97 = phi_257_;
        if _e97 {
            phi_261_ = false;
        } else {
            phi_261_ = _e95;
        }
        let _e99 = phi_261_;
        if !(_e99) {
            let _e102 = samples.member[(0u + _e64.first_primitive)].normal;
            let _e104 = samples.member[(0u + _e64.first_primitive)].position;
            if ((((_e102.x * (_e73.x - (_e104.x * _e73.w))) + (_e102.y * (_e73.y - (_e104.y * _e73.w)))) + (_e102.z * (_e73.z - (_e104.z * _e73.w)))) > 0f) {
                let _e128 = samples.member[(0u + _e64.first_primitive)].flags;
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e136.unnamed.visibility, false), _e136.unnamed_1);
                phi_305_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e142.unnamed, ((_e128 & 1u) == 0u));
            } else {
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e157 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e151.unnamed.visibility, false), _e151.unnamed_1);
                phi_305_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e157.unnamed, true);
            }
            let _e162 = phi_305_;
            phi_309_ = _e162;
        } else {
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e168.unnamed.visibility, false), _e168.unnamed_1);
            phi_309_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e174.unnamed, true);
        }
        let _e179 = phi_309_;
        if _e179.unnamed_1 {
            phi_717_ = evaluate_Verdict(_e179.unnamed.visibility, _e179.unnamed.is_doubted);
            phi_718_ = evaluate_Verdict();
            phi_719_ = true;
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
                    phi_386_ = (_e218 <= 1f);
                } else {
                    phi_386_ = false;
                }
                let _e250 = phi_386_;
                if _e250 {
                    if (_e232 >= 0f) {
                        phi_395_ = (_e232 <= 1f);
                    } else {
                        phi_395_ = false;
                    }
                    let _e254 = phi_395_;
                    if _e254 {
                        if (_e245 >= 0f) {
                            phi_404_ = (_e245 <= 1f);
                        } else {
                            phi_404_ = false;
                        }
                        let _e258 = phi_404_;
                        phi_405_ = _e258;
                        phi_406_ = false;
                    } else {
                        phi_405_ = bool();
                        phi_406_ = true;
                    }
                    let _e260 = phi_405_;
                    let _e262 = phi_406_;
                    phi_407_ = _e260;
                    phi_408_ = _e262;
                } else {
                    phi_407_ = bool();
                    phi_408_ = true;
                }
                let _e264 = phi_407_;
                let _e266 = phi_408_;
                phi_409_ = _e264;
                phi_410_ = _e266;
            } else {
                phi_409_ = bool();
                phi_410_ = true;
            }
            let _e268 = phi_409_;
            let _e270 = phi_410_;
            if _e270 {
                phi_414_ = false;
            } else {
                phi_414_ = _e268;
            }
            let _e272 = phi_414_;
            if _e272 {
                if (0f > 0f) {
                    let _e275 = samples.member[(0u + _e64.first_primitive)].normal;
                    let _e277 = p.member.map_size;
                    let _e280 = p.member.projection.row_x;
                    let _e302 = p.member.projection.row_y;
                    let _e324 = p.member.projection.row_z;
                    let _e351 = ((abs(((((_e280.x * _e275.x) + (_e280.y * _e275.y)) + (_e280.z * _e275.z)) / (((_e280.x * _e280.x) + (_e280.y * _e280.y)) + (_e280.z * _e280.z)))) + abs(((((_e302.x * _e275.x) + (_e302.y * _e275.y)) + (_e302.z * _e275.z)) / (((_e302.x * _e302.x) + (_e302.y * _e302.y)) + (_e302.z * _e302.z))))) / (abs(((((_e324.x * _e275.x) + (_e324.y * _e275.y)) + (_e324.z * _e275.z)) / (((_e324.x * _e324.x) + (_e324.y * _e324.y)) + (_e324.z * _e324.z)))) * f32(_e277)));
                    if (_e351 < 0.002f) {
                        phi_508_ = _e351;
                    } else {
                        phi_508_ = 0.002f;
                    }
                    let _e354 = phi_508_;
                    phi_511_ = (_e245 - (0f * _e354));
                } else {
                    phi_511_ = _e245;
                }
                let _e358 = phi_511_;
                let _e360 = p.member.map_size;
                let _e361 = f32(_e360);
                let _e364 = ((_e218 * _e361) - 0.5f);
                let _e365 = ((_e232 * _e361) - 0.5f);
                if (_e364 > -8388608f) {
                    let _e377 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
                    if (_e377 > _e364) {
                        phi_540_ = 1f;
                    } else {
                        phi_540_ = 0f;
                    }
                    let _e380 = phi_540_;
                    if (_e364 < 8388608f) {
                        phi_545_ = (_e377 - _e380);
                        phi_546_ = false;
                    } else {
                        phi_545_ = f32();
                        phi_546_ = true;
                    }
                    let _e383 = phi_545_;
                    let _e385 = phi_546_;
                    phi_547_ = _e383;
                    phi_548_ = _e385;
                } else {
                    phi_547_ = f32();
                    phi_548_ = true;
                }
                let _e387 = phi_547_;
                let _e389 = phi_548_;
                if _e389 {
                    phi_552_ = _e364;
                } else {
                    phi_552_ = _e387;
                }
                let _e391 = phi_552_;
                if (_e365 > -8388608f) {
                    let _e403 = f32(select(0i, select(select(i32(_e365), i32(-2147483648), (_e365 < bitcast<f32>(3472883712u))), 2147483647i, (_e365 > bitcast<f32>(1325400063u))), (_e365 == _e365)));
                    if (_e403 > _e365) {
                        phi_572_ = 1f;
                    } else {
                        phi_572_ = 0f;
                    }
                    let _e406 = phi_572_;
                    if (_e365 < 8388608f) {
                        phi_577_ = (_e403 - _e406);
                        phi_578_ = false;
                    } else {
                        phi_577_ = f32();
                        phi_578_ = true;
                    }
                    let _e409 = phi_577_;
                    let _e411 = phi_578_;
                    phi_579_ = _e409;
                    phi_580_ = _e411;
                } else {
                    phi_579_ = f32();
                    phi_580_ = true;
                }
                let _e413 = phi_579_;
                let _e415 = phi_580_;
                if _e415 {
                    phi_584_ = _e365;
                } else {
                    phi_584_ = _e413;
                }
                let _e417 = phi_584_;
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
                    phi_634_ = _e428;
                } else {
                    phi_634_ = 0i;
                }
                let _e460 = phi_634_;
                if (_e437 > 0i) {
                    phi_639_ = _e437;
                } else {
                    phi_639_ = 0i;
                }
                let _e463 = phi_639_;
                if (_e460 < _e457) {
                    phi_644_ = _e460;
                } else {
                    phi_644_ = _e457;
                }
                let _e466 = phi_644_;
                if (_e463 < _e457) {
                    phi_649_ = _e463;
                } else {
                    phi_649_ = _e457;
                }
                let _e469 = phi_649_;
                let _e470 = bitcast<u32>(_e466);
                let _e472 = (_e428 + 1i);
                let _e473 = (_e437 + 1i);
                if (_e472 > 0i) {
                    phi_658_ = _e472;
                } else {
                    phi_658_ = 0i;
                }
                let _e476 = phi_658_;
                if (_e473 > 0i) {
                    phi_663_ = _e473;
                } else {
                    phi_663_ = 0i;
                }
                let _e479 = phi_663_;
                if (_e476 < _e457) {
                    phi_668_ = _e476;
                } else {
                    phi_668_ = _e457;
                }
                let _e482 = phi_668_;
                if (_e479 < _e457) {
                    phi_673_ = _e479;
                } else {
                    phi_673_ = _e457;
                }
                let _e485 = phi_673_;
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
                phi_714_ = evaluate_Verdict(_e511, false);
                phi_715_ = evaluate_Verdict();
                phi_716_ = false;
            } else {
                phi_714_ = evaluate_Verdict();
                phi_715_ = evaluate_Verdict(1f, false);
                phi_716_ = true;
            }
            let _e515 = phi_714_;
            let _e517 = phi_715_;
            let _e519 = phi_716_;
            phi_717_ = _e517;
            phi_718_ = _e515;
            phi_719_ = _e519;
        }
        let _e521 = phi_717_;
        let _e523 = phi_718_;
        let _e525 = phi_719_;
        if _e525 {
            phi_723_ = _e521;
        } else {
            phi_723_ = _e523;
        }
        let _e527 = phi_723_;
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
