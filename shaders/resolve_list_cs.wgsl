struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

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
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
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

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_35 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_39 {
    member: array<lt_bvh_Triangle>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_mask_LightPlace,
    unnamed_1: lt_mask_LightPlace,
}

struct lt_bvh_triangle_Intersection {
    t: f32,
    u: f32,
    v: f32,
    is_hit: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> nodes: type_35;
@group(0) @binding(3) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage> list: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_146_: bool;
    var phi_150_: f32;

    if (param != param) {
        phi_146_ = true;
    } else {
        let _e52 = (param_1 >= param);
        if _e52 {
        }
        phi_146_ = _e52;
    }
    let _e54 = phi_146_;
    if _e54 {
        phi_150_ = param_1;
    } else {
        phi_150_ = param;
    }
    let _e56 = phi_150_;
    return _e56;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_162_: bool;
    var phi_166_: f32;

    if (param_2 != param_2) {
        phi_162_ = true;
    } else {
        let _e52 = (param_3 <= param_2);
        if _e52 {
        }
        phi_162_ = _e52;
    }
    let _e54 = phi_162_;
    if _e54 {
        phi_166_ = param_3;
    } else {
        phi_166_ = param_2;
    }
    let _e56 = phi_166_;
    return _e56;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_241_: f32;
    var phi_272_: bool;
    var phi_273_: bool;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_279_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_299_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_326_: bool;
    var phi_396_: f32;
    var phi_403_: f32;
    var phi_410_: f32;
    var phi_417_: f32;
    var phi_424_: f32;
    var phi_431_: f32;
    var phi_448_: f32;
    var phi_453_: f32;
    var phi_458_: f32;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_494_: bool;
    var phi_495_: bool;
    var phi_503_: u32;
    var phi_504_: u32;
    var phi_515_: vec3<f32>;
    var phi_516_: vec3<f32>;
    var phi_529_: u32;
    var phi_534_: u32;
    var phi_539_: u32;
    var phi_653_: bool;
    var phi_654_: bool;
    var phi_685_: u32;
    var phi_687_: u32;
    var phi_690_: bool;
    var phi_770_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_797_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_824_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_830_: u32;
    var phi_833_: u32;
    var phi_847_: u32;
    var phi_857_: u32;
    var phi_867_: u32;
    var phi_885_: u32;
    var phi_895_: u32;
    var phi_905_: u32;
    var phi_941_: u32;
    var phi_954_: u32;
    var phi_959_: u32;
    var phi_960_: u32;
    var phi_961_: u32;
    var phi_831_: u32;
    var phi_834_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1019_: u32;
    var phi_1022_: bool;
    var phi_1066_: vec3<f32>;
    var phi_1067_: vec3<f32>;
    var phi_1096_: vec3<f32>;
    var phi_1097_: vec3<f32>;
    var phi_1126_: vec3<f32>;
    var phi_1127_: vec3<f32>;
    var phi_1145_: bool;
    var phi_1146_: bool;
    var phi_1150_: f32;
    var phi_1151_: f32;
    var phi_1152_: f32;
    var phi_1153_: f32;
    var phi_1161_: f32;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1178_: f32;
    var phi_1179_: f32;
    var phi_1187_: f32;
    var phi_1197_: bool;
    var phi_1198_: bool;
    var phi_1202_: f32;
    var phi_1203_: f32;
    var phi_1204_: f32;
    var phi_1205_: f32;
    var phi_1213_: f32;
    var phi_1228_: f32;
    var phi_1229_: bool;
    var phi_1230_: f32;
    var phi_1231_: bool;
    var phi_1232_: f32;
    var phi_1233_: bool;
    var phi_1251_: f32;
    var phi_1252_: bool;
    var phi_1253_: bool;
    var phi_1254_: f32;
    var phi_1255_: bool;
    var phi_1256_: bool;
    var phi_1260_: bool;
    var phi_1261_: f32;
    var phi_1262_: bool;
    var phi_1290_: vec3<f32>;
    var phi_1291_: vec3<f32>;
    var phi_1316_: vec3<f32>;
    var phi_1317_: vec3<f32>;
    var phi_1342_: vec3<f32>;
    var phi_1343_: vec3<f32>;
    var phi_1399_: f32;
    var phi_1408_: f32;
    var phi_1417_: f32;
    var phi_1426_: f32;
    var phi_1433_: f32;
    var phi_1440_: f32;
    var phi_1453_: f32;
    var phi_1462_: f32;
    var phi_1471_: f32;
    var phi_1480_: f32;
    var phi_1487_: f32;
    var phi_1494_: f32;
    var phi_1511_: f32;
    var phi_1516_: f32;
    var phi_1521_: f32;
    var phi_1529_: f32;
    var phi_1534_: f32;
    var phi_1539_: f32;
    var phi_1551_: f32;
    var phi_1556_: f32;
    var phi_1561_: f32;
    var phi_1566_: f32;
    var phi_1571_: lt_bvh_triangle_Intersection;
    var phi_1572_: bool;
    var phi_1573_: lt_bvh_triangle_Intersection;
    var phi_1574_: bool;
    var phi_1578_: lt_bvh_triangle_Intersection;
    var phi_1579_: bool;
    var phi_1580_: lt_bvh_triangle_Intersection;
    var phi_1581_: bool;
    var phi_1582_: bool;
    var phi_1586_: bool;
    var phi_1590_: lt_bvh_triangle_Intersection;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1020_: u32;
    var phi_1023_: bool;
    var phi_1620_: bool;
    var local_4: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1694_: u32;
    var phi_1695_: u32;
    var phi_688_: u32;
    var phi_691_: bool;
    var phi_1696_: bool;
    var phi_1697_: bool;
    var local_5: bool;
    var phi_1701_: bool;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1712_: bool;
    var phi_1716_: f32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;

    let _e50 = id_1;
    let _e57 = arrayLength((&nodes.member));
    let _e66 = arrayLength((&list.member));
    let _e70 = ((_e50.y * 2097152u) + _e50.x);
    if (3u < _e66) {
    } else {
        return;
    }
    let _e73 = list.member[3u];
    if (_e70 < _e73) {
        let _e75 = (_e70 + 4u);
        if (_e75 < _e66) {
        } else {
            return;
        }
        let _e79 = list.member[(0u + _e75)];
        if (_e79 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e79)].position;
        let _e87 = samples.member[(0u + _e79)].normal;
        let _e89 = samples.member[(0u + _e79)].magnitude;
        let _e91 = ((8f / 8388608f) * _e89);
        let _e99 = (_e85.x + (_e87.x * _e91));
        let _e101 = (_e85.y + (_e87.y * _e91));
        let _e103 = (_e85.z + (_e87.z * _e91));
        let _e105 = p.member.light.place;
        if (_e105.w == 0f) {
            phi_241_ = 300000000000000000000000000000000000000f;
        } else {
            phi_241_ = 1f;
        }
        let _e109 = phi_241_;
        let _e117 = (_e105.x - (_e99 * _e105.w));
        let _e118 = (_e105.y - (_e101 * _e105.w));
        let _e119 = (_e105.z - (_e103 * _e105.w));
        let _e121 = abs(_e117);
        let _e122 = abs(_e118);
        let _e123 = abs(_e119);
        if (abs(_e99) < 1000000000000000f) {
            if (abs(_e101) < 1000000000000000f) {
                phi_272_ = (abs(_e103) < 1000000000000000f);
                phi_273_ = false;
            } else {
                phi_272_ = bool();
                phi_273_ = true;
            }
            let _e131 = phi_272_;
            let _e133 = phi_273_;
            phi_274_ = _e131;
            phi_275_ = _e133;
        } else {
            phi_274_ = bool();
            phi_275_ = true;
        }
        let _e135 = phi_274_;
        let _e137 = phi_275_;
        if _e137 {
            phi_279_ = false;
        } else {
            phi_279_ = _e135;
        }
        let _e139 = phi_279_;
        if _e139 {
            if (_e121 < 1000000000000000f) {
                if (_e122 < 1000000000000000f) {
                    phi_292_ = (_e123 < 1000000000000000f);
                    phi_293_ = false;
                } else {
                    phi_292_ = bool();
                    phi_293_ = true;
                }
                let _e144 = phi_292_;
                let _e146 = phi_293_;
                phi_294_ = _e144;
                phi_295_ = _e146;
            } else {
                phi_294_ = bool();
                phi_295_ = true;
            }
            let _e148 = phi_294_;
            let _e150 = phi_295_;
            if _e150 {
                phi_299_ = false;
            } else {
                phi_299_ = _e148;
            }
            let _e152 = phi_299_;
            if _e152 {
                if (_e121 > 0f) {
                    phi_313_ = bool();
                    phi_314_ = true;
                } else {
                    let _e154 = (_e122 > 0f);
                    if _e154 {
                        phi_312_ = bool();
                    } else {
                        phi_312_ = (_e123 > 0f);
                    }
                    let _e157 = phi_312_;
                    phi_313_ = _e157;
                    phi_314_ = _e154;
                }
                let _e159 = phi_313_;
                let _e161 = phi_314_;
                if _e161 {
                    phi_318_ = true;
                } else {
                    phi_318_ = _e159;
                }
                let _e163 = phi_318_;
                phi_319_ = _e163;
                phi_320_ = false;
            } else {
                phi_319_ = bool();
                phi_320_ = true;
            }
            let _e165 = phi_319_;
            let _e167 = phi_320_;
            phi_321_ = _e165;
            phi_322_ = _e167;
        } else {
            phi_321_ = bool();
            phi_322_ = true;
        }
        let _e169 = phi_321_;
        let _e171 = phi_322_;
        if _e171 {
            phi_326_ = false;
        } else {
            phi_326_ = _e169;
        }
        let _e173 = phi_326_;
        if _e173 {
            let _e174 = (0u >= _e57);
            if _e174 {
                phi_1706_ = bool();
            } else {
                if (0u < _e57) {
                } else {
                    return;
                }
                let _e180 = nodes.member[(0u + 0u)].frame[0u];
                let _e184 = nodes.member[(0u + 0u)].frame[1u];
                let _e188 = nodes.member[(0u + 0u)].frame[2u];
                let _e192 = nodes.member[(0u + 0u)].frame[0u];
                let _e196 = nodes.member[(0u + 0u)].frame[1u];
                let _e200 = nodes.member[(0u + 0u)].frame[2u];
                let _e204 = nodes.member[(0u + 0u)].frame[3u];
                let _e238 = core_intrinsics_maximum_number_nsz_f32_(abs(_e117), abs(_e118));
                let _e239 = core_intrinsics_maximum_number_nsz_f32_(_e238, abs(_e119));
                let _e240 = (_e239 * 0.0000000000009094947f);
                if (abs(_e117) < _e240) {
                    phi_396_ = _e240;
                } else {
                    phi_396_ = abs(_e117);
                }
                let _e245 = phi_396_;
                if (_e117 < 0f) {
                    phi_403_ = (-1f / _e245);
                } else {
                    phi_403_ = (1f / _e245);
                }
                let _e250 = phi_403_;
                if (abs(_e118) < _e240) {
                    phi_410_ = _e240;
                } else {
                    phi_410_ = abs(_e118);
                }
                let _e255 = phi_410_;
                if (_e118 < 0f) {
                    phi_417_ = (-1f / _e255);
                } else {
                    phi_417_ = (1f / _e255);
                }
                let _e260 = phi_417_;
                if (abs(_e119) < _e240) {
                    phi_424_ = _e240;
                } else {
                    phi_424_ = abs(_e119);
                }
                let _e265 = phi_424_;
                if (_e119 < 0f) {
                    phi_431_ = (-1f / _e265);
                } else {
                    phi_431_ = (1f / _e265);
                }
                let _e270 = phi_431_;
                let _e274 = abs((bitcast<f32>(_e180) - _e99));
                let _e275 = abs((bitcast<f32>(_e184) - _e101));
                let _e276 = abs((bitcast<f32>(_e188) - _e103));
                let _e280 = abs(((bitcast<f32>(_e192) + (bitcast<f32>((((_e204 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e99));
                let _e281 = abs(((bitcast<f32>(_e196) + (bitcast<f32>((((_e204 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e101));
                let _e282 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e204 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e103));
                if (_e274 > _e280) {
                    phi_448_ = _e274;
                } else {
                    phi_448_ = _e280;
                }
                let _e285 = phi_448_;
                if (_e275 > _e281) {
                    phi_453_ = _e275;
                } else {
                    phi_453_ = _e281;
                }
                let _e288 = phi_453_;
                if (_e276 > _e282) {
                    phi_458_ = _e276;
                } else {
                    phi_458_ = _e282;
                }
                let _e291 = phi_458_;
                if (_e285 > _e288) {
                    phi_463_ = _e285;
                } else {
                    phi_463_ = _e288;
                }
                let _e294 = phi_463_;
                if (_e294 > _e291) {
                    phi_468_ = _e294;
                } else {
                    phi_468_ = _e291;
                }
                let _e297 = phi_468_;
                let _e301 = (_e297 * 0.0000019073486f);
                let _e302 = (abs(_e250) * _e301);
                let _e303 = (abs(_e260) * _e301);
                let _e304 = (abs(_e270) * _e301);
                let _e308 = (_e297 * 0.0000009536743f);
                let _e309 = (abs(_e250) * _e308);
                let _e310 = (abs(_e260) * _e308);
                let _e311 = (abs(_e270) * _e308);
                let _e312 = abs(_e117);
                let _e313 = abs(_e118);
                let _e314 = abs(_e119);
                if (_e312 >= _e313) {
                    if (_e312 >= _e314) {
                        phi_494_ = false;
                    } else {
                        phi_494_ = true;
                    }
                    let _e318 = phi_494_;
                    phi_495_ = _e318;
                } else {
                    phi_495_ = true;
                }
                let _e320 = phi_495_;
                if _e320 {
                    if (_e313 >= _e314) {
                        phi_503_ = 1u;
                    } else {
                        phi_503_ = 2u;
                    }
                    let _e323 = phi_503_;
                    phi_504_ = _e323;
                } else {
                    phi_504_ = 0u;
                }
                let _e325 = phi_504_;
                if (_e325 == 0u) {
                    phi_516_ = vec3<f32>(_e118, _e119, _e117);
                } else {
                    if (_e325 == 1u) {
                        phi_515_ = vec3<f32>(_e119, _e117, _e118);
                    } else {
                        phi_515_ = vec3<f32>(_e117, _e118, _e119);
                    }
                    let _e331 = phi_515_;
                    phi_516_ = _e331;
                }
                let _e333 = phi_516_;
                let _e336 = (_e333.x / _e333.z);
                let _e339 = (_e333.y / _e333.z);
                if (_e250 < 0f) {
                    phi_529_ = 0u;
                } else {
                    phi_529_ = 1u;
                }
                let _e344 = phi_529_;
                if (_e260 < 0f) {
                    phi_534_ = 0u;
                } else {
                    phi_534_ = 2u;
                }
                let _e347 = phi_534_;
                if (_e270 < 0f) {
                    phi_539_ = 0u;
                } else {
                    phi_539_ = 4u;
                }
                let _e350 = phi_539_;
                let _e352 = ((_e344 | _e347) | _e350);
                let _e353 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e353.first[0], _e353.first[1], _e353.first[2], _e353.first[3], _e353.first[4], _e353.first[5], _e353.first[6], _e353.first[7], _e353.first[8], _e353.first[9], _e353.first[10], _e353.first[11], _e353.first[12], _e353.first[13], _e353.first[14], _e353.first[15], _e353.first[16], _e353.first[17], _e353.first[18], _e353.first[19], _e353.first[20], _e353.first[21], _e353.first[22], _e353.first[23], _e353.first[24], _e353.first[25], _e353.first[26], _e353.first[27], _e353.first[28], _e353.first[29], _e353.first[30], _e353.first[31]), array<u32, 32>(_e353.mask[0], _e353.mask[1], _e353.mask[2], _e353.mask[3], _e353.mask[4], _e353.mask[5], _e353.mask[6], _e353.mask[7], _e353.mask[8], _e353.mask[9], _e353.mask[10], _e353.mask[11], _e353.mask[12], _e353.mask[13], _e353.mask[14], _e353.mask[15], _e353.mask[16], _e353.mask[17], _e353.mask[18], _e353.mask[19], _e353.mask[20], _e353.mask[21], _e353.mask[22], _e353.mask[23], _e353.mask[24], _e353.mask[25], _e353.mask[26], _e353.mask[27], _e353.mask[28], _e353.mask[29], _e353.mask[30], _e353.mask[31]), _e353.len, _e353.group, _e353.group_mask);
                let _e427 = local.group_mask;
                if ((_e427 & 4278190080u) == 0u) {
                    let _e431 = local.len;
                    if (_e431 == 0u) {
                        phi_653_ = false;
                    } else {
                        let _e435 = local.len;
                        local.len = (_e435 - 1u);
                        let _e438 = local.len;
                        if (_e438 < 32u) {
                        } else {
                            return;
                        }
                        let _e443 = local.first[(0u + _e438)];
                        local.group = _e443;
                        let _e446 = local.len;
                        if (_e446 < 32u) {
                        } else {
                            return;
                        }
                        let _e451 = local.mask[(0u + _e446)];
                        local.group_mask = _e451;
                        phi_653_ = true;
                    }
                    let _e454 = phi_653_;
                    phi_654_ = _e454;
                } else {
                    phi_654_ = true;
                }
                let _e456 = phi_654_;
                if _e456 {
                    let _e458 = local.group_mask;
                    let _e464 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e458)), 32u, (_e458 == 0u)));
                    let _e468 = local.group_mask;
                    let _e482 = local.group_mask;
                    local.group_mask = (_e482 & ~((1u << bitcast<u32>((_e464 & 31u)))));
                    let _e485 = local.group;
                    phi_685_ = (_e485 + countOneBits(((_e468 & ~((4294967295u << bitcast<u32>((((_e464 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_685_ = 4294967295u;
                }
                let _e488 = phi_685_;
                phi_687_ = _e488;
                phi_690_ = false;
                loop {
                    let _e490 = phi_687_;
                    let _e492 = phi_690_;
                    local_8 = _e492;
                    if (_e490 != 4294967295u) {
                        if (_e490 < _e57) {
                        } else {
                            return;
                        }
                        let _e499 = nodes.member[(0u + _e490)].frame[3u];
                        let _e524 = (bitcast<f32>((((_e499 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e250);
                        let _e525 = (bitcast<f32>((((_e499 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e260);
                        let _e526 = (bitcast<f32>((((_e499 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e270);
                        let _e529 = nodes.member[(0u + _e490)].frame[0u];
                        let _e533 = nodes.member[(0u + _e490)].frame[1u];
                        let _e537 = nodes.member[(0u + _e490)].frame[2u];
                        let _e542 = ((bitcast<f32>(_e529) - _e99) * _e250);
                        let _e543 = ((bitcast<f32>(_e533) - _e101) * _e260);
                        let _e544 = ((bitcast<f32>(_e537) - _e103) * _e270);
                        let _e552 = nodes.member[(0u + _e490)].x;
                        if (_e250 < 0f) {
                            let _e563 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e552.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e569 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e563.unnamed.word, _e552.w), _e563.unnamed_1);
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e569.unnamed, lt_mask_LightPlace(_e552.x, _e569.unnamed_1.shift));
                            phi_770_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e575.unnamed, lt_mask_LightPlace(_e575.unnamed_1.word, _e552.y));
                        } else {
                            let _e591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e552.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e591.unnamed.word, _e552.y), _e591.unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e597.unnamed, lt_mask_LightPlace(_e552.z, _e597.unnamed_1.shift));
                            phi_770_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_mask_LightPlace(_e603.unnamed_1.word, _e552.w));
                        }
                        let _e611 = phi_770_;
                        let _e621 = nodes.member[(0u + _e490)].y;
                        if (_e260 < 0f) {
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e621.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e632.unnamed.word, _e621.w), _e632.unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_mask_LightPlace(_e621.x, _e638.unnamed_1.shift));
                            phi_797_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_mask_LightPlace(_e644.unnamed_1.word, _e621.y));
                        } else {
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e621.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e660.unnamed.word, _e621.y), _e660.unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_mask_LightPlace(_e621.z, _e666.unnamed_1.shift));
                            phi_797_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_mask_LightPlace(_e672.unnamed_1.word, _e621.w));
                        }
                        let _e680 = phi_797_;
                        let _e690 = nodes.member[(0u + _e490)].z;
                        if (_e270 < 0f) {
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e690.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.unnamed.word, _e690.w), _e701.unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_mask_LightPlace(_e690.x, _e707.unnamed_1.shift));
                            phi_824_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_mask_LightPlace(_e713.unnamed_1.word, _e690.y));
                        } else {
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e690.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e729.unnamed.word, _e690.y), _e729.unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_mask_LightPlace(_e690.z, _e735.unnamed_1.shift));
                            phi_824_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_mask_LightPlace(_e741.unnamed_1.word, _e690.w));
                        }
                        let _e749 = phi_824_;
                        phi_830_ = 0u;
                        phi_833_ = 0u;
                        loop {
                            let _e759 = phi_830_;
                            let _e761 = phi_833_;
                            local_1 = _e761;
                            local_2 = _e761;
                            local_3 = _e761;
                            let _e762 = (_e759 < 8u);
                            if _e762 {
                                let _e764 = (_e759 >> bitcast<u32>(2i));
                                let _e765 = (_e759 & 3u);
                                if (_e764 == 0u) {
                                    phi_847_ = _e611.unnamed.word;
                                } else {
                                    phi_847_ = _e611.unnamed.shift;
                                }
                                let _e768 = phi_847_;
                                if (_e764 == 0u) {
                                    phi_857_ = _e680.unnamed.word;
                                } else {
                                    phi_857_ = _e680.unnamed.shift;
                                }
                                let _e777 = phi_857_;
                                if (_e764 == 0u) {
                                    phi_867_ = _e749.unnamed.word;
                                } else {
                                    phi_867_ = _e749.unnamed.shift;
                                }
                                let _e786 = phi_867_;
                                let _e799 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e768 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e524) + (_e542 - _e302)), ((f32(((_e777 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e525) + (_e543 - _e303)));
                                let _e800 = core_intrinsics_maximum_number_nsz_f32_(_e799, ((f32(((_e786 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e304)));
                                if (_e764 == 0u) {
                                    phi_885_ = _e611.unnamed_1.word;
                                } else {
                                    phi_885_ = _e611.unnamed_1.shift;
                                }
                                let _e803 = phi_885_;
                                if (_e764 == 0u) {
                                    phi_895_ = _e680.unnamed_1.word;
                                } else {
                                    phi_895_ = _e680.unnamed_1.shift;
                                }
                                let _e812 = phi_895_;
                                if (_e764 == 0u) {
                                    phi_905_ = _e749.unnamed_1.word;
                                } else {
                                    phi_905_ = _e749.unnamed_1.shift;
                                }
                                let _e821 = phi_905_;
                                let _e834 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e803 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e524) + (_e542 + _e302)), ((f32(((_e812 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e525) + (_e543 + _e303)));
                                let _e835 = core_intrinsics_minimum_number_nsz_f32_(_e834, ((f32(((_e821 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e304)));
                                if (_e800 <= _e835) {
                                    if (_e800 <= _e109) {
                                        if (_e835 >= 0f) {
                                            if (_e764 == 0u) {
                                                let _e842 = nodes.member[(0u + _e490)].links[2u];
                                                phi_941_ = _e842;
                                            } else {
                                                let _e845 = nodes.member[(0u + _e490)].links[3u];
                                                phi_941_ = _e845;
                                            }
                                            let _e847 = phi_941_;
                                            let _e852 = ((_e847 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u);
                                            let _e853 = (_e852 & 31u);
                                            if (_e853 >= 24u) {
                                                phi_954_ = (24u + ((_e853 - 24u) ^ _e352));
                                            } else {
                                                phi_954_ = _e853;
                                            }
                                            let _e859 = phi_954_;
                                            phi_959_ = (_e761 | ((_e852 >> bitcast<u32>(5i)) << bitcast<u32>((_e859 & 31u))));
                                        } else {
                                            phi_959_ = _e761;
                                        }
                                        let _e867 = phi_959_;
                                        phi_960_ = _e867;
                                    } else {
                                        phi_960_ = _e761;
                                    }
                                    let _e869 = phi_960_;
                                    phi_961_ = _e869;
                                } else {
                                    phi_961_ = _e761;
                                }
                                let _e871 = phi_961_;
                                phi_831_ = (_e759 + 1u);
                                phi_834_ = _e871;
                            } else {
                                phi_831_ = u32();
                                phi_834_ = u32();
                            }
                            let _e874 = phi_831_;
                            let _e876 = phi_834_;
                            continue;
                            continuing {
                                phi_830_ = _e874;
                                phi_833_ = _e876;
                                break if !(_e762);
                            }
                        }
                        let _e880 = nodes.member[(0u + _e490)].links[0u];
                        let _e884 = nodes.member[(0u + _e490)].frame[3u];
                        let _e888 = local_1;
                        if ((_e888 & 4278190080u) == 0u) {
                        } else {
                            let _e892 = local.group_mask;
                            if ((_e892 & 4278190080u) == 0u) {
                            } else {
                                let _e896 = local.len;
                                if (_e896 < 32u) {
                                    let _e899 = local.group;
                                    let _e901 = local.len;
                                    if (_e901 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e901)] = _e899;
                                    let _e907 = local.group_mask;
                                    let _e909 = local.len;
                                    if (_e909 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e909)] = _e907;
                                    let _e916 = local.len;
                                    local.len = (_e916 + 1u);
                                }
                            }
                            local.group = (0u + _e880);
                            let _e920 = local_2;
                            local.group_mask = ((_e920 & 4278190080u) | (_e884 >> bitcast<u32>(24i)));
                        }
                        let _e925 = local_3;
                        phi_1019_ = (_e925 & 16777215u);
                        phi_1022_ = _e492;
                        loop {
                            let _e928 = phi_1019_;
                            let _e930 = phi_1022_;
                            local_6 = _e930;
                            let _e931 = (_e928 == 0u);
                            local_4 = _e931;
                            local_7 = _e931;
                            if _e931 {
                                phi_1020_ = u32();
                                phi_1023_ = bool();
                                phi_1620_ = false;
                            } else {
                                let _e934 = nodes.member[(0u + _e490)].links[1u];
                                let _e939 = ((0u + _e934) + select(firstTrailingBit(_e928), 32u, (_e928 == 0u)));
                                if (_e939 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e946 = triangles.member[(0u + _e939)].v0_;
                                let _e948 = (_e946.x - _e99);
                                let _e950 = (_e946.y - _e101);
                                let _e952 = (_e946.z - _e103);
                                if (_e325 == 0u) {
                                    phi_1067_ = vec3<f32>(_e950, _e952, _e948);
                                } else {
                                    if (_e325 == 1u) {
                                        phi_1066_ = vec3<f32>(_e952, _e948, _e950);
                                    } else {
                                        phi_1066_ = (_e946 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e960 = phi_1066_;
                                    phi_1067_ = _e960;
                                }
                                let _e962 = phi_1067_;
                                let _e966 = (_e962.x - (_e336 * _e962.z));
                                let _e970 = (_e962.y - (_e339 * _e962.z));
                                let _e972 = triangles.member[(0u + _e939)].v1_;
                                let _e974 = (_e972.x - _e99);
                                let _e976 = (_e972.y - _e101);
                                let _e978 = (_e972.z - _e103);
                                if (_e325 == 0u) {
                                    phi_1097_ = vec3<f32>(_e976, _e978, _e974);
                                } else {
                                    if (_e325 == 1u) {
                                        phi_1096_ = vec3<f32>(_e978, _e974, _e976);
                                    } else {
                                        phi_1096_ = (_e972 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e986 = phi_1096_;
                                    phi_1097_ = _e986;
                                }
                                let _e988 = phi_1097_;
                                let _e992 = (_e988.x - (_e336 * _e988.z));
                                let _e996 = (_e988.y - (_e339 * _e988.z));
                                let _e998 = triangles.member[(0u + _e939)].v2_;
                                let _e1000 = (_e998.x - _e99);
                                let _e1002 = (_e998.y - _e101);
                                let _e1004 = (_e998.z - _e103);
                                if (_e325 == 0u) {
                                    phi_1127_ = vec3<f32>(_e1002, _e1004, _e1000);
                                } else {
                                    if (_e325 == 1u) {
                                        phi_1126_ = vec3<f32>(_e1004, _e1000, _e1002);
                                    } else {
                                        phi_1126_ = (_e998 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e1012 = phi_1126_;
                                    phi_1127_ = _e1012;
                                }
                                let _e1014 = phi_1127_;
                                let _e1018 = (_e1014.x - (_e336 * _e1014.z));
                                let _e1022 = (_e1014.y - (_e339 * _e1014.z));
                                if (_e992 < _e1018) {
                                    phi_1146_ = true;
                                } else {
                                    if (_e992 == _e1018) {
                                        phi_1145_ = (_e996 < _e1022);
                                    } else {
                                        phi_1145_ = false;
                                    }
                                    let _e1027 = phi_1145_;
                                    phi_1146_ = _e1027;
                                }
                                let _e1029 = phi_1146_;
                                if _e1029 {
                                    phi_1150_ = _e1022;
                                    phi_1151_ = _e1018;
                                    phi_1152_ = _e996;
                                    phi_1153_ = _e992;
                                } else {
                                    phi_1150_ = _e996;
                                    phi_1151_ = _e992;
                                    phi_1152_ = _e1022;
                                    phi_1153_ = _e1018;
                                }
                                let _e1031 = phi_1150_;
                                let _e1033 = phi_1151_;
                                let _e1035 = phi_1152_;
                                let _e1037 = phi_1153_;
                                let _e1040 = ((_e1037 * _e1031) - (_e1035 * _e1033));
                                if _e1029 {
                                    phi_1161_ = -(_e1040);
                                } else {
                                    phi_1161_ = _e1040;
                                }
                                let _e1043 = phi_1161_;
                                if (_e1018 < _e966) {
                                    phi_1172_ = true;
                                } else {
                                    if (_e1018 == _e966) {
                                        phi_1171_ = (_e1022 < _e970);
                                    } else {
                                        phi_1171_ = false;
                                    }
                                    let _e1048 = phi_1171_;
                                    phi_1172_ = _e1048;
                                }
                                let _e1050 = phi_1172_;
                                if _e1050 {
                                    phi_1176_ = _e970;
                                    phi_1177_ = _e966;
                                    phi_1178_ = _e1022;
                                    phi_1179_ = _e1018;
                                } else {
                                    phi_1176_ = _e1022;
                                    phi_1177_ = _e1018;
                                    phi_1178_ = _e970;
                                    phi_1179_ = _e966;
                                }
                                let _e1052 = phi_1176_;
                                let _e1054 = phi_1177_;
                                let _e1056 = phi_1178_;
                                let _e1058 = phi_1179_;
                                let _e1061 = ((_e1058 * _e1052) - (_e1056 * _e1054));
                                if _e1050 {
                                    phi_1187_ = -(_e1061);
                                } else {
                                    phi_1187_ = _e1061;
                                }
                                let _e1064 = phi_1187_;
                                if (_e966 < _e992) {
                                    phi_1198_ = true;
                                } else {
                                    if (_e966 == _e992) {
                                        phi_1197_ = (_e970 < _e996);
                                    } else {
                                        phi_1197_ = false;
                                    }
                                    let _e1069 = phi_1197_;
                                    phi_1198_ = _e1069;
                                }
                                let _e1071 = phi_1198_;
                                if _e1071 {
                                    phi_1202_ = _e996;
                                    phi_1203_ = _e992;
                                    phi_1204_ = _e970;
                                    phi_1205_ = _e966;
                                } else {
                                    phi_1202_ = _e970;
                                    phi_1203_ = _e966;
                                    phi_1204_ = _e996;
                                    phi_1205_ = _e992;
                                }
                                let _e1073 = phi_1202_;
                                let _e1075 = phi_1203_;
                                let _e1077 = phi_1204_;
                                let _e1079 = phi_1205_;
                                let _e1082 = ((_e1079 * _e1073) - (_e1077 * _e1075));
                                if _e1071 {
                                    phi_1213_ = -(_e1082);
                                } else {
                                    phi_1213_ = _e1082;
                                }
                                let _e1085 = phi_1213_;
                                if (_e1043 >= 0f) {
                                    if (_e1064 >= 0f) {
                                        if (_e1085 >= 0f) {
                                            phi_1228_ = ((_e1043 + _e1064) + _e1085);
                                            phi_1229_ = false;
                                        } else {
                                            phi_1228_ = f32();
                                            phi_1229_ = true;
                                        }
                                        let _e1092 = phi_1228_;
                                        let _e1094 = phi_1229_;
                                        phi_1230_ = _e1092;
                                        phi_1231_ = _e1094;
                                    } else {
                                        phi_1230_ = f32();
                                        phi_1231_ = true;
                                    }
                                    let _e1096 = phi_1230_;
                                    let _e1098 = phi_1231_;
                                    phi_1232_ = _e1096;
                                    phi_1233_ = _e1098;
                                } else {
                                    phi_1232_ = f32();
                                    phi_1233_ = true;
                                }
                                let _e1100 = phi_1232_;
                                let _e1102 = phi_1233_;
                                if _e1102 {
                                    if (_e1043 <= 0f) {
                                        if (_e1064 <= 0f) {
                                            let _e1105 = (_e1085 <= 0f);
                                            if _e1105 {
                                            }
                                            phi_1251_ = ((_e1043 + _e1064) + _e1085);
                                            phi_1252_ = false;
                                            phi_1253_ = _e1105;
                                        } else {
                                            phi_1251_ = f32();
                                            phi_1252_ = true;
                                            phi_1253_ = false;
                                        }
                                        let _e1109 = phi_1251_;
                                        let _e1111 = phi_1252_;
                                        let _e1113 = phi_1253_;
                                        phi_1254_ = _e1109;
                                        phi_1255_ = _e1111;
                                        phi_1256_ = _e1113;
                                    } else {
                                        phi_1254_ = f32();
                                        phi_1255_ = true;
                                        phi_1256_ = false;
                                    }
                                    let _e1115 = phi_1254_;
                                    let _e1117 = phi_1255_;
                                    let _e1119 = phi_1256_;
                                    if _e1117 {
                                        phi_1260_ = false;
                                    } else {
                                        phi_1260_ = _e1119;
                                    }
                                    let _e1121 = phi_1260_;
                                    phi_1261_ = _e1115;
                                    phi_1262_ = _e1121;
                                } else {
                                    phi_1261_ = _e1100;
                                    phi_1262_ = true;
                                }
                                let _e1123 = phi_1261_;
                                let _e1125 = phi_1262_;
                                if _e1125 {
                                    let _e1126 = (_e1123 == 0f);
                                    if _e1126 {
                                        phi_1578_ = lt_bvh_triangle_Intersection();
                                        phi_1579_ = false;
                                    } else {
                                        let _e1128 = triangles.member[(0u + _e939)].v0_;
                                        let _e1130 = (_e1128.x - _e99);
                                        let _e1132 = (_e1128.y - _e101);
                                        let _e1134 = (_e1128.z - _e103);
                                        if (_e325 == 0u) {
                                            phi_1291_ = vec3<f32>(_e1132, _e1134, _e1130);
                                        } else {
                                            if (_e325 == 1u) {
                                                phi_1290_ = vec3<f32>(_e1134, _e1130, _e1132);
                                            } else {
                                                phi_1290_ = (_e1128 - vec3<f32>(_e99, _e101, _e103));
                                            }
                                            let _e1142 = phi_1290_;
                                            phi_1291_ = _e1142;
                                        }
                                        let _e1144 = phi_1291_;
                                        let _e1146 = triangles.member[(0u + _e939)].v1_;
                                        let _e1148 = triangles.member[(0u + _e939)].v0_;
                                        let _e1151 = (_e1146.x - _e1148.x);
                                        let _e1154 = (_e1146.y - _e1148.y);
                                        let _e1157 = (_e1146.z - _e1148.z);
                                        if (_e325 == 0u) {
                                            phi_1317_ = vec3<f32>(_e1154, _e1157, _e1151);
                                        } else {
                                            if (_e325 == 1u) {
                                                phi_1316_ = vec3<f32>(_e1157, _e1151, _e1154);
                                            } else {
                                                phi_1316_ = (_e1146 - _e1148);
                                            }
                                            let _e1164 = phi_1316_;
                                            phi_1317_ = _e1164;
                                        }
                                        let _e1166 = phi_1317_;
                                        let _e1168 = triangles.member[(0u + _e939)].v2_;
                                        let _e1170 = triangles.member[(0u + _e939)].v0_;
                                        let _e1173 = (_e1168.x - _e1170.x);
                                        let _e1176 = (_e1168.y - _e1170.y);
                                        let _e1179 = (_e1168.z - _e1170.z);
                                        if (_e325 == 0u) {
                                            phi_1343_ = vec3<f32>(_e1176, _e1179, _e1173);
                                        } else {
                                            if (_e325 == 1u) {
                                                phi_1342_ = vec3<f32>(_e1179, _e1173, _e1176);
                                            } else {
                                                phi_1342_ = (_e1168 - _e1170);
                                            }
                                            let _e1186 = phi_1342_;
                                            phi_1343_ = _e1186;
                                        }
                                        let _e1188 = phi_1343_;
                                        let _e1195 = ((_e1166.y * _e1188.z) - (_e1166.z * _e1188.y));
                                        let _e1202 = ((_e1166.z * _e1188.x) - (_e1166.x * _e1188.z));
                                        let _e1209 = ((_e1166.x * _e1188.y) - (_e1166.y * _e1188.x));
                                        let _e1223 = (((1f / _e333.z) * (((_e1195 * _e1144.x) + (_e1202 * _e1144.y)) + (_e1209 * _e1144.z))) / (((_e1195 * _e336) + (_e1202 * _e339)) + _e1209));
                                        if (_e1223 > 0f) {
                                            if (_e1223 < _e109) {
                                                let _e1227 = triangles.member[(0u + _e939)].v0_;
                                                let _e1229 = triangles.member[(0u + _e939)].v1_;
                                                if (_e1227.x < _e1229.x) {
                                                    phi_1399_ = _e1227.x;
                                                } else {
                                                    phi_1399_ = _e1229.x;
                                                }
                                                let _e1236 = phi_1399_;
                                                if (_e1227.y < _e1229.y) {
                                                    phi_1408_ = _e1227.y;
                                                } else {
                                                    phi_1408_ = _e1229.y;
                                                }
                                                let _e1243 = phi_1408_;
                                                if (_e1227.z < _e1229.z) {
                                                    phi_1417_ = _e1227.z;
                                                } else {
                                                    phi_1417_ = _e1229.z;
                                                }
                                                let _e1250 = phi_1417_;
                                                let _e1252 = triangles.member[(0u + _e939)].v2_;
                                                if (_e1236 < _e1252.x) {
                                                    phi_1426_ = _e1236;
                                                } else {
                                                    phi_1426_ = _e1252.x;
                                                }
                                                let _e1257 = phi_1426_;
                                                if (_e1243 < _e1252.y) {
                                                    phi_1433_ = _e1243;
                                                } else {
                                                    phi_1433_ = _e1252.y;
                                                }
                                                let _e1262 = phi_1433_;
                                                if (_e1250 < _e1252.z) {
                                                    phi_1440_ = _e1250;
                                                } else {
                                                    phi_1440_ = _e1252.z;
                                                }
                                                let _e1267 = phi_1440_;
                                                let _e1269 = triangles.member[(0u + _e939)].v0_;
                                                let _e1271 = triangles.member[(0u + _e939)].v1_;
                                                if (_e1269.x > _e1271.x) {
                                                    phi_1453_ = _e1269.x;
                                                } else {
                                                    phi_1453_ = _e1271.x;
                                                }
                                                let _e1278 = phi_1453_;
                                                if (_e1269.y > _e1271.y) {
                                                    phi_1462_ = _e1269.y;
                                                } else {
                                                    phi_1462_ = _e1271.y;
                                                }
                                                let _e1285 = phi_1462_;
                                                if (_e1269.z > _e1271.z) {
                                                    phi_1471_ = _e1269.z;
                                                } else {
                                                    phi_1471_ = _e1271.z;
                                                }
                                                let _e1292 = phi_1471_;
                                                let _e1294 = triangles.member[(0u + _e939)].v2_;
                                                if (_e1278 > _e1294.x) {
                                                    phi_1480_ = _e1278;
                                                } else {
                                                    phi_1480_ = _e1294.x;
                                                }
                                                let _e1299 = phi_1480_;
                                                if (_e1285 > _e1294.y) {
                                                    phi_1487_ = _e1285;
                                                } else {
                                                    phi_1487_ = _e1294.y;
                                                }
                                                let _e1304 = phi_1487_;
                                                if (_e1292 > _e1294.z) {
                                                    phi_1494_ = _e1292;
                                                } else {
                                                    phi_1494_ = _e1294.z;
                                                }
                                                let _e1309 = phi_1494_;
                                                let _e1313 = ((_e1257 - _e99) * _e250);
                                                let _e1314 = ((_e1262 - _e101) * _e260);
                                                let _e1315 = ((_e1267 - _e103) * _e270);
                                                let _e1319 = ((_e1299 - _e99) * _e250);
                                                let _e1320 = ((_e1304 - _e101) * _e260);
                                                let _e1321 = ((_e1309 - _e103) * _e270);
                                                if (_e1313 < _e1319) {
                                                    phi_1511_ = _e1313;
                                                } else {
                                                    phi_1511_ = _e1319;
                                                }
                                                let _e1324 = phi_1511_;
                                                if (_e1314 < _e1320) {
                                                    phi_1516_ = _e1314;
                                                } else {
                                                    phi_1516_ = _e1320;
                                                }
                                                let _e1327 = phi_1516_;
                                                if (_e1315 < _e1321) {
                                                    phi_1521_ = _e1315;
                                                } else {
                                                    phi_1521_ = _e1321;
                                                }
                                                let _e1330 = phi_1521_;
                                                if (_e1313 > _e1319) {
                                                    phi_1529_ = _e1313;
                                                } else {
                                                    phi_1529_ = _e1319;
                                                }
                                                let _e1336 = phi_1529_;
                                                if (_e1314 > _e1320) {
                                                    phi_1534_ = _e1314;
                                                } else {
                                                    phi_1534_ = _e1320;
                                                }
                                                let _e1339 = phi_1534_;
                                                if (_e1315 > _e1321) {
                                                    phi_1539_ = _e1315;
                                                } else {
                                                    phi_1539_ = _e1321;
                                                }
                                                let _e1342 = phi_1539_;
                                                let _e1346 = core_intrinsics_maximum_number_nsz_f32_((_e1324 - _e309), (_e1327 - _e310));
                                                let _e1347 = core_intrinsics_maximum_number_nsz_f32_(_e1346, (_e1330 - _e311));
                                                let _e1348 = core_intrinsics_minimum_number_nsz_f32_((_e1336 + _e309), (_e1339 + _e310));
                                                let _e1349 = core_intrinsics_minimum_number_nsz_f32_(_e1348, (_e1342 + _e311));
                                                if (_e1347 > -300000000000000000000000000000000000000f) {
                                                    phi_1551_ = _e1347;
                                                } else {
                                                    phi_1551_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1352 = phi_1551_;
                                                if (_e1349 < 300000000000000000000000000000000000000f) {
                                                    phi_1556_ = _e1349;
                                                } else {
                                                    phi_1556_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1355 = phi_1556_;
                                                if (_e1223 < _e1352) {
                                                    phi_1561_ = _e1352;
                                                } else {
                                                    phi_1561_ = _e1223;
                                                }
                                                let _e1358 = phi_1561_;
                                                if (_e1358 > _e1355) {
                                                    phi_1566_ = _e1355;
                                                } else {
                                                    phi_1566_ = _e1358;
                                                }
                                                let _e1361 = phi_1566_;
                                                phi_1571_ = lt_bvh_triangle_Intersection(_e1361, (_e1064 / _e1123), (_e1085 / _e1123), (_e1352 <= _e1355));
                                                phi_1572_ = false;
                                            } else {
                                                phi_1571_ = lt_bvh_triangle_Intersection();
                                                phi_1572_ = true;
                                            }
                                            let _e1367 = phi_1571_;
                                            let _e1369 = phi_1572_;
                                            phi_1573_ = _e1367;
                                            phi_1574_ = _e1369;
                                        } else {
                                            phi_1573_ = lt_bvh_triangle_Intersection();
                                            phi_1574_ = true;
                                        }
                                        let _e1371 = phi_1573_;
                                        let _e1373 = phi_1574_;
                                        if _e1373 {
                                        }
                                        phi_1578_ = _e1371;
                                        phi_1579_ = _e1373;
                                    }
                                    let _e1375 = phi_1578_;
                                    let _e1377 = phi_1579_;
                                    phi_1580_ = _e1375;
                                    phi_1581_ = _e1126;
                                    phi_1582_ = _e1377;
                                } else {
                                    phi_1580_ = lt_bvh_triangle_Intersection();
                                    phi_1581_ = true;
                                    phi_1582_ = false;
                                }
                                let _e1379 = phi_1580_;
                                let _e1381 = phi_1581_;
                                let _e1383 = phi_1582_;
                                if _e1381 {
                                    phi_1586_ = true;
                                } else {
                                    phi_1586_ = _e1383;
                                }
                                let _e1385 = phi_1586_;
                                if _e1385 {
                                    phi_1590_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1590_ = _e1379;
                                }
                                let _e1387 = phi_1590_;
                                if _e1387.is_hit {
                                    if (_e1387.t > 0f) {
                                        if (_e1387.t < _e109) {
                                            if true {
                                                phi_1610_ = false;
                                            } else {
                                                phi_1610_ = true;
                                            }
                                            let _e1396 = phi_1610_;
                                            phi_1611_ = true;
                                            phi_1612_ = _e1396;
                                        } else {
                                            phi_1611_ = _e930;
                                            phi_1612_ = true;
                                        }
                                        let _e1398 = phi_1611_;
                                        let _e1400 = phi_1612_;
                                        phi_1613_ = _e1398;
                                        phi_1614_ = _e1400;
                                    } else {
                                        phi_1613_ = _e930;
                                        phi_1614_ = true;
                                    }
                                    let _e1402 = phi_1613_;
                                    let _e1404 = phi_1614_;
                                    phi_1615_ = _e1402;
                                    phi_1616_ = _e1404;
                                } else {
                                    phi_1615_ = _e930;
                                    phi_1616_ = true;
                                }
                                let _e1406 = phi_1615_;
                                let _e1408 = phi_1616_;
                                if _e1408 {
                                }
                                phi_1020_ = (_e928 & (_e928 - 1u));
                                phi_1023_ = _e1406;
                                phi_1620_ = _e1408;
                            }
                            let _e1410 = phi_1020_;
                            let _e1412 = phi_1023_;
                            let _e1414 = phi_1620_;
                            continue;
                            continuing {
                                phi_1019_ = _e1410;
                                phi_1022_ = _e1412;
                                break if !(_e1414);
                            }
                        }
                        let _e1417 = local_4;
                        if _e1417 {
                            let _e1419 = local.group_mask;
                            if ((_e1419 & 4278190080u) == 0u) {
                                let _e1423 = local.len;
                                if (_e1423 == 0u) {
                                    phi_1662_ = false;
                                } else {
                                    let _e1427 = local.len;
                                    local.len = (_e1427 - 1u);
                                    let _e1430 = local.len;
                                    if (_e1430 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1435 = local.first[(0u + _e1430)];
                                    local.group = _e1435;
                                    let _e1438 = local.len;
                                    if (_e1438 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1443 = local.mask[(0u + _e1438)];
                                    local.group_mask = _e1443;
                                    phi_1662_ = true;
                                }
                                let _e1446 = phi_1662_;
                                phi_1663_ = _e1446;
                            } else {
                                phi_1663_ = true;
                            }
                            let _e1448 = phi_1663_;
                            if _e1448 {
                                let _e1450 = local.group_mask;
                                let _e1456 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1450)), 32u, (_e1450 == 0u)));
                                let _e1460 = local.group_mask;
                                let _e1474 = local.group_mask;
                                local.group_mask = (_e1474 & ~((1u << bitcast<u32>((_e1456 & 31u)))));
                                let _e1477 = local.group;
                                phi_1694_ = (_e1477 + countOneBits(((_e1460 & ~((4294967295u << bitcast<u32>((((_e1456 - 24u) ^ _e352) & 31u))))) & 255u)));
                            } else {
                                phi_1694_ = 4294967295u;
                            }
                            let _e1480 = phi_1694_;
                            phi_1695_ = _e1480;
                        } else {
                            phi_1695_ = u32();
                        }
                        let _e1482 = phi_1695_;
                        phi_688_ = _e1482;
                        let _e1678 = local_6;
                        phi_691_ = _e1678;
                        let _e1681 = local_7;
                        phi_1696_ = _e1681;
                        phi_1697_ = false;
                    } else {
                        phi_688_ = u32();
                        phi_691_ = bool();
                        phi_1696_ = false;
                        phi_1697_ = true;
                    }
                    let _e1484 = phi_688_;
                    let _e1486 = phi_691_;
                    let _e1488 = phi_1696_;
                    let _e1490 = phi_1697_;
                    local_5 = _e1490;
                    continue;
                    continuing {
                        phi_687_ = _e1484;
                        phi_690_ = _e1486;
                        break if !(_e1488);
                    }
                }
                let _e1493 = local_5;
                if _e1493 {
                    phi_1701_ = false;
                } else {
                    phi_1701_ = true;
                }
                let _e1495 = phi_1701_;
                if _e1495 {
                    phi_1705_ = true;
                } else {
                    let _e1687 = local_8;
                    phi_1705_ = _e1687;
                }
                let _e1497 = phi_1705_;
                phi_1706_ = _e1497;
            }
            let _e1499 = phi_1706_;
            phi_1707_ = _e1499;
            phi_1708_ = _e174;
        } else {
            phi_1707_ = bool();
            phi_1708_ = true;
        }
        let _e1501 = phi_1707_;
        let _e1503 = phi_1708_;
        if _e1503 {
            phi_1712_ = false;
        } else {
            phi_1712_ = _e1501;
        }
        let _e1505 = phi_1712_;
        if _e1505 {
            phi_1716_ = 0f;
        } else {
            phi_1716_ = 1f;
        }
        let _e1507 = phi_1716_;
        if (_e79 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79)] = _e1507;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
