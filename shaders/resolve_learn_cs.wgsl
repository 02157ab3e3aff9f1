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

struct type_31 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_36 {
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

struct type_40 {
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
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_158_: bool;
    var phi_162_: f32;

    if (param != param) {
        phi_158_ = true;
    } else {
        let _e57 = (param_1 >= param);
        if _e57 {
        }
        phi_158_ = _e57;
    }
    let _e59 = phi_158_;
    if _e59 {
        phi_162_ = param_1;
    } else {
        phi_162_ = param;
    }
    let _e61 = phi_162_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_174_: bool;
    var phi_178_: f32;

    if (param_2 != param_2) {
        phi_174_ = true;
    } else {
        let _e57 = (param_3 <= param_2);
        if _e57 {
        }
        phi_174_ = _e57;
    }
    let _e59 = phi_174_;
    if _e59 {
        phi_178_ = param_3;
    } else {
        phi_178_ = param_2;
    }
    let _e61 = phi_178_;
    return _e61;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_255_: f32;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_337_: bool;
    var phi_341_: bool;
    var phi_411_: f32;
    var phi_418_: f32;
    var phi_425_: f32;
    var phi_432_: f32;
    var phi_439_: f32;
    var phi_446_: f32;
    var phi_463_: f32;
    var phi_468_: f32;
    var phi_473_: f32;
    var phi_501_: bool;
    var phi_502_: bool;
    var phi_510_: u32;
    var phi_511_: u32;
    var phi_522_: vec3<f32>;
    var phi_523_: vec3<f32>;
    var phi_536_: u32;
    var phi_541_: u32;
    var phi_546_: u32;
    var phi_660_: bool;
    var phi_661_: bool;
    var phi_692_: u32;
    var phi_694_: u32;
    var phi_697_: bool;
    var phi_777_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_804_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_831_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_837_: u32;
    var phi_840_: u32;
    var phi_854_: u32;
    var phi_864_: u32;
    var phi_874_: u32;
    var phi_892_: u32;
    var phi_902_: u32;
    var phi_912_: u32;
    var phi_948_: u32;
    var phi_961_: u32;
    var phi_966_: u32;
    var phi_967_: u32;
    var phi_968_: u32;
    var phi_838_: u32;
    var phi_841_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1026_: u32;
    var phi_1029_: bool;
    var phi_1073_: vec3<f32>;
    var phi_1074_: vec3<f32>;
    var phi_1103_: vec3<f32>;
    var phi_1104_: vec3<f32>;
    var phi_1133_: vec3<f32>;
    var phi_1134_: vec3<f32>;
    var phi_1152_: bool;
    var phi_1153_: bool;
    var phi_1157_: f32;
    var phi_1158_: f32;
    var phi_1159_: f32;
    var phi_1160_: f32;
    var phi_1168_: f32;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1183_: f32;
    var phi_1184_: f32;
    var phi_1185_: f32;
    var phi_1186_: f32;
    var phi_1194_: f32;
    var phi_1204_: bool;
    var phi_1205_: bool;
    var phi_1209_: f32;
    var phi_1210_: f32;
    var phi_1211_: f32;
    var phi_1212_: f32;
    var phi_1220_: f32;
    var phi_1235_: f32;
    var phi_1236_: bool;
    var phi_1237_: f32;
    var phi_1238_: bool;
    var phi_1239_: f32;
    var phi_1240_: bool;
    var phi_1258_: f32;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1261_: f32;
    var phi_1262_: bool;
    var phi_1263_: bool;
    var phi_1267_: bool;
    var phi_1268_: f32;
    var phi_1269_: bool;
    var phi_1297_: vec3<f32>;
    var phi_1298_: vec3<f32>;
    var phi_1323_: vec3<f32>;
    var phi_1324_: vec3<f32>;
    var phi_1349_: vec3<f32>;
    var phi_1350_: vec3<f32>;
    var phi_1406_: f32;
    var phi_1415_: f32;
    var phi_1424_: f32;
    var phi_1433_: f32;
    var phi_1440_: f32;
    var phi_1447_: f32;
    var phi_1460_: f32;
    var phi_1469_: f32;
    var phi_1478_: f32;
    var phi_1487_: f32;
    var phi_1494_: f32;
    var phi_1501_: f32;
    var phi_1518_: f32;
    var phi_1523_: f32;
    var phi_1528_: f32;
    var phi_1536_: f32;
    var phi_1541_: f32;
    var phi_1546_: f32;
    var phi_1558_: f32;
    var phi_1563_: f32;
    var phi_1568_: f32;
    var phi_1573_: f32;
    var phi_1578_: lt_bvh_triangle_Intersection;
    var phi_1579_: bool;
    var phi_1580_: lt_bvh_triangle_Intersection;
    var phi_1581_: bool;
    var phi_1585_: lt_bvh_triangle_Intersection;
    var phi_1586_: bool;
    var phi_1587_: lt_bvh_triangle_Intersection;
    var phi_1588_: bool;
    var phi_1589_: bool;
    var phi_1593_: bool;
    var phi_1597_: lt_bvh_triangle_Intersection;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1623_: bool;
    var phi_1027_: u32;
    var phi_1030_: bool;
    var phi_1627_: bool;
    var local_4: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1701_: u32;
    var phi_1702_: u32;
    var phi_695_: u32;
    var phi_698_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var local_5: bool;
    var phi_1708_: bool;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1714_: bool;
    var phi_1715_: bool;
    var phi_1719_: bool;
    var phi_1723_: f32;
    var phi_1764_: u32;
    var phi_1783_: u32;
    var phi_1791_: u32;
    var phi_1799_: u32;
    var phi_1804_: u32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;

    let _e55 = id_1;
    let _e62 = arrayLength((&nodes.member));
    let _e68 = arrayLength((&visibility.member));
    let _e71 = arrayLength((&list.member));
    let _e74 = arrayLength((&bits.member));
    let _e78 = ((_e55.y * 2097152u) + _e55.x);
    if (3u < _e71) {
    } else {
        return;
    }
    let _e81 = list.member[3u];
    if (_e78 < _e81) {
        let _e83 = (_e78 + 4u);
        if (_e83 < _e71) {
        } else {
            return;
        }
        let _e87 = list.member[(0u + _e83)];
        if (_e87 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e93 = samples.member[(0u + _e87)].position;
        let _e95 = samples.member[(0u + _e87)].normal;
        let _e97 = samples.member[(0u + _e87)].magnitude;
        let _e99 = ((8f / 8388608f) * _e97);
        let _e107 = (_e93.x + (_e95.x * _e99));
        let _e109 = (_e93.y + (_e95.y * _e99));
        let _e111 = (_e93.z + (_e95.z * _e99));
        let _e113 = p.member.light.place;
        if (_e113.w == 0f) {
            phi_255_ = 300000000000000000000000000000000000000f;
        } else {
            phi_255_ = 1f;
        }
        let _e117 = phi_255_;
        let _e125 = (_e113.x - (_e107 * _e113.w));
        let _e126 = (_e113.y - (_e109 * _e113.w));
        let _e127 = (_e113.z - (_e111 * _e113.w));
        let _e132 = abs(_e125);
        let _e133 = abs(_e126);
        let _e134 = abs(_e127);
        if (abs(_e107) < 1000000000000000f) {
            if (abs(_e109) < 1000000000000000f) {
                if (abs(_e111) < 1000000000000000f) {
                    if (_e132 < 1000000000000000f) {
                        if (_e133 < 1000000000000000f) {
                            if (_e134 < 1000000000000000f) {
                                if (_e132 > 0f) {
                                    phi_311_ = bool();
                                    phi_312_ = true;
                                } else {
                                    let _e142 = (_e133 > 0f);
                                    if _e142 {
                                        phi_310_ = bool();
                                    } else {
                                        phi_310_ = (_e134 > 0f);
                                    }
                                    let _e145 = phi_310_;
                                    phi_311_ = _e145;
                                    phi_312_ = _e142;
                                }
                                let _e147 = phi_311_;
                                let _e149 = phi_312_;
                                if _e149 {
                                    phi_316_ = true;
                                } else {
                                    phi_316_ = _e147;
                                }
                                let _e151 = phi_316_;
                                phi_317_ = _e151;
                                phi_318_ = false;
                            } else {
                                phi_317_ = bool();
                                phi_318_ = true;
                            }
                            let _e153 = phi_317_;
                            let _e155 = phi_318_;
                            phi_319_ = _e153;
                            phi_320_ = false;
                            phi_321_ = _e155;
                        } else {
                            phi_319_ = bool();
                            phi_320_ = true;
                            phi_321_ = false;
                        }
                        let _e157 = phi_319_;
                        let _e159 = phi_320_;
                        let _e161 = phi_321_;
                        phi_322_ = _e157;
                        phi_323_ = _e159;
                        phi_324_ = _e161;
                    } else {
                        phi_322_ = bool();
                        phi_323_ = true;
                        phi_324_ = false;
                    }
                    let _e163 = phi_322_;
                    let _e165 = phi_323_;
                    let _e167 = phi_324_;
                    phi_325_ = _e163;
                    phi_326_ = _e165;
                    phi_327_ = _e167;
                } else {
                    phi_325_ = bool();
                    phi_326_ = true;
                    phi_327_ = false;
                }
                let _e169 = phi_325_;
                let _e171 = phi_326_;
                let _e173 = phi_327_;
                phi_328_ = _e169;
                phi_329_ = _e171;
                phi_330_ = _e173;
            } else {
                phi_328_ = bool();
                phi_329_ = true;
                phi_330_ = false;
            }
            let _e175 = phi_328_;
            let _e177 = phi_329_;
            let _e179 = phi_330_;
            phi_331_ = _e175;
            phi_332_ = _e177;
            phi_333_ = _e179;
        } else {
            phi_331_ = bool();
            phi_332_ = true;
            phi_333_ = false;
        }
        let _e181 = phi_331_;
        let _e183 = phi_332_;
        let _e185 = phi_333_;
        if _e183 {
            phi_337_ = true;
        } else {
            phi_337_ = _e185;
        }
        let _e187 = phi_337_;
        if _e187 {
            phi_341_ = false;
        } else {
            phi_341_ = _e181;
        }
        let _e189 = phi_341_;
        if _e189 {
            let _e190 = (0u >= _e62);
            if _e190 {
                phi_1713_ = bool();
            } else {
                if (0u < _e62) {
                } else {
                    return;
                }
                let _e196 = nodes.member[(0u + 0u)].frame[0u];
                let _e200 = nodes.member[(0u + 0u)].frame[1u];
                let _e204 = nodes.member[(0u + 0u)].frame[2u];
                let _e208 = nodes.member[(0u + 0u)].frame[0u];
                let _e212 = nodes.member[(0u + 0u)].frame[1u];
                let _e216 = nodes.member[(0u + 0u)].frame[2u];
                let _e220 = nodes.member[(0u + 0u)].frame[3u];
                let _e254 = core_intrinsics_maximum_number_nsz_f32_(abs(_e125), abs(_e126));
                let _e255 = core_intrinsics_maximum_number_nsz_f32_(_e254, abs(_e127));
                let _e256 = (_e255 * 0.0000000000009094947f);
                if (abs(_e125) < _e256) {
                    phi_411_ = _e256;
                } else {
                    phi_411_ = abs(_e125);
                }
                let _e261 = phi_411_;
                if (_e125 < 0f) {
                    phi_418_ = (-1f / _e261);
                } else {
                    phi_418_ = (1f / _e261);
                }
                let _e266 = phi_418_;
                if (abs(_e126) < _e256) {
                    phi_425_ = _e256;
                } else {
                    phi_425_ = abs(_e126);
                }
                let _e271 = phi_425_;
                if (_e126 < 0f) {
                    phi_432_ = (-1f / _e271);
                } else {
                    phi_432_ = (1f / _e271);
                }
                let _e276 = phi_432_;
                if (abs(_e127) < _e256) {
                    phi_439_ = _e256;
                } else {
                    phi_439_ = abs(_e127);
                }
                let _e281 = phi_439_;
                if (_e127 < 0f) {
                    phi_446_ = (-1f / _e281);
                } else {
                    phi_446_ = (1f / _e281);
                }
                let _e286 = phi_446_;
                let _e290 = abs((bitcast<f32>(_e196) - _e107));
                let _e291 = abs((bitcast<f32>(_e200) - _e109));
                let _e292 = abs((bitcast<f32>(_e204) - _e111));
                let _e296 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e220 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e297 = abs(((bitcast<f32>(_e212) + (bitcast<f32>((((_e220 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                let _e298 = abs(((bitcast<f32>(_e216) + (bitcast<f32>((((_e220 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e111));
                if (_e290 > _e296) {
                    phi_463_ = _e290;
                } else {
                    phi_463_ = _e296;
                }
                let _e301 = phi_463_;
                if (_e291 > _e297) {
                    phi_468_ = _e291;
                } else {
                    phi_468_ = _e297;
                }
                let _e304 = phi_468_;
                if (_e292 > _e298) {
                    phi_473_ = _e292;
                } else {
                    phi_473_ = _e298;
                }
                let _e307 = phi_473_;
                let _e308 = core_intrinsics_maximum_number_nsz_f32_(_e301, _e304);
                let _e309 = core_intrinsics_maximum_number_nsz_f32_(_e308, _e307);
                let _e313 = (_e309 * 0.0000019073486f);
                let _e314 = (abs(_e266) * _e313);
                let _e315 = (abs(_e276) * _e313);
                let _e316 = (abs(_e286) * _e313);
                let _e320 = (_e309 * 0.0000009536743f);
                let _e321 = (abs(_e266) * _e320);
                let _e322 = (abs(_e276) * _e320);
                let _e323 = (abs(_e286) * _e320);
                let _e324 = abs(_e125);
                let _e325 = abs(_e126);
                let _e326 = abs(_e127);
                if (_e324 >= _e325) {
                    if (_e324 >= _e326) {
                        phi_501_ = false;
                    } else {
                        phi_501_ = true;
                    }
                    let _e330 = phi_501_;
                    phi_502_ = _e330;
                } else {
                    phi_502_ = true;
                }
                let _e332 = phi_502_;
                if _e332 {
                    if (_e325 >= _e326) {
                        phi_510_ = 1u;
                    } else {
                        phi_510_ = 2u;
                    }
                    let _e335 = phi_510_;
                    phi_511_ = _e335;
                } else {
                    phi_511_ = 0u;
                }
                let _e337 = phi_511_;
                if (_e337 == 0u) {
                    phi_523_ = vec3<f32>(_e126, _e127, _e125);
                } else {
                    if (_e337 == 1u) {
                        phi_522_ = vec3<f32>(_e127, _e125, _e126);
                    } else {
                        phi_522_ = vec3<f32>(_e125, _e126, _e127);
                    }
                    let _e343 = phi_522_;
                    phi_523_ = _e343;
                }
                let _e345 = phi_523_;
                let _e348 = (_e345.x / _e345.z);
                let _e351 = (_e345.y / _e345.z);
                if (_e266 < 0f) {
                    phi_536_ = 0u;
                } else {
                    phi_536_ = 1u;
                }
                let _e356 = phi_536_;
                if (_e276 < 0f) {
                    phi_541_ = 0u;
                } else {
                    phi_541_ = 2u;
                }
                let _e359 = phi_541_;
                if (_e286 < 0f) {
                    phi_546_ = 0u;
                } else {
                    phi_546_ = 4u;
                }
                let _e362 = phi_546_;
                let _e364 = ((_e356 | _e359) | _e362);
                let _e365 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e365.first[0], _e365.first[1], _e365.first[2], _e365.first[3], _e365.first[4], _e365.first[5], _e365.first[6], _e365.first[7], _e365.first[8], _e365.first[9], _e365.first[10], _e365.first[11], _e365.first[12], _e365.first[13], _e365.first[14], _e365.first[15], _e365.first[16], _e365.first[17], _e365.first[18], _e365.first[19], _e365.first[20], _e365.first[21], _e365.first[22], _e365.first[23], _e365.first[24], _e365.first[25], _e365.first[26], _e365.first[27], _e365.first[28], _e365.first[29], _e365.first[30], _e365.first[31]), array<u32, 32>(_e365.mask[0], _e365.mask[1], _e365.mask[2], _e365.mask[3], _e365.mask[4], _e365.mask[5], _e365.mask[6], _e365.mask[7], _e365.mask[8], _e365.mask[9], _e365.mask[10], _e365.mask[11], _e365.mask[12], _e365.mask[13], _e365.mask[14], _e365.mask[15], _e365.mask[16], _e365.mask[17], _e365.mask[18], _e365.mask[19], _e365.mask[20], _e365.mask[21], _e365.mask[22], _e365.mask[23], _e365.mask[24], _e365.mask[25], _e365.mask[26], _e365.mask[27], _e365.mask[28], _e365.mask[29], _e365.mask[30], _e365.mask[31]), _e365.len, _e365.group, _e365.group_mask);
                let _e439 = local.group_mask;
                if ((_e439 & 4278190080u) == 0u) {
                    let _e443 = local.len;
                    if (_e443 == 0u) {
                        phi_660_ = false;
                    } else {
                        let _e447 = local.len;
                        local.len = (_e447 - 1u);
                        let _e450 = local.len;
                        if (_e450 < 32u) {
                        } else {
                            return;
                        }
                        let _e455 = local.first[(0u + _e450)];
                        local.group = _e455;
                        let _e458 = local.len;
                        if (_e458 < 32u) {
                        } else {
                            return;
                        }
                        let _e463 = local.mask[(0u + _e458)];
                        local.group_mask = _e463;
                        phi_660_ = true;
                    }
                    let _e466 = phi_660_;
                    phi_661_ = _e466;
                } else {
                    phi_661_ = true;
                }
                let _e468 = phi_661_;
                if _e468 {
                    let _e470 = local.group_mask;
                    let _e476 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e470)), 32u, (_e470 == 0u)));
                    let _e480 = local.group_mask;
                    let _e494 = local.group_mask;
                    local.group_mask = (_e494 & ~((1u << bitcast<u32>((_e476 & 31u)))));
                    let _e497 = local.group;
                    phi_692_ = (_e497 + countOneBits(((_e480 & ~((4294967295u << bitcast<u32>((((_e476 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_692_ = 4294967295u;
                }
                let _e500 = phi_692_;
                phi_694_ = _e500;
                phi_697_ = false;
                loop {
                    let _e502 = phi_694_;
                    let _e504 = phi_697_;
                    local_8 = _e504;
                    if (_e502 != 4294967295u) {
                        if (_e502 < _e62) {
                        } else {
                            return;
                        }
                        let _e511 = nodes.member[(0u + _e502)].frame[3u];
                        let _e536 = (bitcast<f32>((((_e511 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e266);
                        let _e537 = (bitcast<f32>((((_e511 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e276);
                        let _e538 = (bitcast<f32>((((_e511 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e286);
                        let _e541 = nodes.member[(0u + _e502)].frame[0u];
                        let _e545 = nodes.member[(0u + _e502)].frame[1u];
                        let _e549 = nodes.member[(0u + _e502)].frame[2u];
                        let _e554 = ((bitcast<f32>(_e541) - _e107) * _e266);
                        let _e555 = ((bitcast<f32>(_e545) - _e109) * _e276);
                        let _e556 = ((bitcast<f32>(_e549) - _e111) * _e286);
                        let _e564 = nodes.member[(0u + _e502)].x;
                        if (_e266 < 0f) {
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e564.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e575.unnamed.word, _e564.w), _e575.unnamed_1);
                            let _e587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e581.unnamed, lt_mask_LightPlace(_e564.x, _e581.unnamed_1.shift));
                            phi_777_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e587.unnamed, lt_mask_LightPlace(_e587.unnamed_1.word, _e564.y));
                        } else {
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e564.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e603.unnamed.word, _e564.y), _e603.unnamed_1);
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e609.unnamed, lt_mask_LightPlace(_e564.z, _e609.unnamed_1.shift));
                            phi_777_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e615.unnamed, lt_mask_LightPlace(_e615.unnamed_1.word, _e564.w));
                        }
                        let _e623 = phi_777_;
                        let _e633 = nodes.member[(0u + _e502)].y;
                        if (_e276 < 0f) {
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e633.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e644.unnamed.word, _e633.w), _e644.unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_mask_LightPlace(_e633.x, _e650.unnamed_1.shift));
                            phi_804_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_mask_LightPlace(_e656.unnamed_1.word, _e633.y));
                        } else {
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e633.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e672.unnamed.word, _e633.y), _e672.unnamed_1);
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_mask_LightPlace(_e633.z, _e678.unnamed_1.shift));
                            phi_804_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e684.unnamed, lt_mask_LightPlace(_e684.unnamed_1.word, _e633.w));
                        }
                        let _e692 = phi_804_;
                        let _e702 = nodes.member[(0u + _e502)].z;
                        if (_e286 < 0f) {
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e713.unnamed.word, _e702.w), _e713.unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_mask_LightPlace(_e702.x, _e719.unnamed_1.shift));
                            phi_831_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_mask_LightPlace(_e725.unnamed_1.word, _e702.y));
                        } else {
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e702.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e741.unnamed.word, _e702.y), _e741.unnamed_1);
                            let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_mask_LightPlace(_e702.z, _e747.unnamed_1.shift));
                            phi_831_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e753.unnamed, lt_mask_LightPlace(_e753.unnamed_1.word, _e702.w));
                        }
                        let _e761 = phi_831_;
                        phi_837_ = 0u;
                        phi_840_ = 0u;
                        loop {
                            let _e771 = phi_837_;
                            let _e773 = phi_840_;
                            local_1 = _e773;
                            local_2 = _e773;
                            local_3 = _e773;
                            let _e774 = (_e771 < 8u);
                            if _e774 {
                                let _e776 = (_e771 >> bitcast<u32>(2i));
                                let _e777 = (_e771 & 3u);
                                if (_e776 == 0u) {
                                    phi_854_ = _e623.unnamed.word;
                                } else {
                                    phi_854_ = _e623.unnamed.shift;
                                }
                                let _e780 = phi_854_;
                                if (_e776 == 0u) {
                                    phi_864_ = _e692.unnamed.word;
                                } else {
                                    phi_864_ = _e692.unnamed.shift;
                                }
                                let _e789 = phi_864_;
                                if (_e776 == 0u) {
                                    phi_874_ = _e761.unnamed.word;
                                } else {
                                    phi_874_ = _e761.unnamed.shift;
                                }
                                let _e798 = phi_874_;
                                let _e811 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e780 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e536) + (_e554 - _e314)), ((f32(((_e789 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e537) + (_e555 - _e315)));
                                let _e812 = core_intrinsics_maximum_number_nsz_f32_(_e811, ((f32(((_e798 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e538) + (_e556 - _e316)));
                                if (_e776 == 0u) {
                                    phi_892_ = _e623.unnamed_1.word;
                                } else {
                                    phi_892_ = _e623.unnamed_1.shift;
                                }
                                let _e815 = phi_892_;
                                if (_e776 == 0u) {
                                    phi_902_ = _e692.unnamed_1.word;
                                } else {
                                    phi_902_ = _e692.unnamed_1.shift;
                                }
                                let _e824 = phi_902_;
                                if (_e776 == 0u) {
                                    phi_912_ = _e761.unnamed_1.word;
                                } else {
                                    phi_912_ = _e761.unnamed_1.shift;
                                }
                                let _e833 = phi_912_;
                                let _e846 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e815 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e536) + (_e554 + _e314)), ((f32(((_e824 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e537) + (_e555 + _e315)));
                                let _e847 = core_intrinsics_minimum_number_nsz_f32_(_e846, ((f32(((_e833 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e538) + (_e556 + _e316)));
                                if (_e812 <= _e847) {
                                    if (_e812 <= _e117) {
                                        if (_e847 >= 0f) {
                                            if (_e776 == 0u) {
                                                let _e854 = nodes.member[(0u + _e502)].links[2u];
                                                phi_948_ = _e854;
                                            } else {
                                                let _e857 = nodes.member[(0u + _e502)].links[3u];
                                                phi_948_ = _e857;
                                            }
                                            let _e859 = phi_948_;
                                            let _e864 = ((_e859 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u);
                                            let _e865 = (_e864 & 31u);
                                            if (_e865 >= 24u) {
                                                phi_961_ = (24u + ((_e865 - 24u) ^ _e364));
                                            } else {
                                                phi_961_ = _e865;
                                            }
                                            let _e871 = phi_961_;
                                            phi_966_ = (_e773 | ((_e864 >> bitcast<u32>(5i)) << bitcast<u32>((_e871 & 31u))));
                                        } else {
                                            phi_966_ = _e773;
                                        }
                                        let _e879 = phi_966_;
                                        phi_967_ = _e879;
                                    } else {
                                        phi_967_ = _e773;
                                    }
                                    let _e881 = phi_967_;
                                    phi_968_ = _e881;
                                } else {
                                    phi_968_ = _e773;
                                }
                                let _e883 = phi_968_;
                                phi_838_ = (_e771 + 1u);
                                phi_841_ = _e883;
                            } else {
                                phi_838_ = u32();
                                phi_841_ = u32();
                            }
                            let _e886 = phi_838_;
                            let _e888 = phi_841_;
                            continue;
                            continuing {
                                phi_837_ = _e886;
                                phi_840_ = _e888;
                                break if !(_e774);
                            }
                        }
                        let _e892 = nodes.member[(0u + _e502)].links[0u];
                        let _e896 = nodes.member[(0u + _e502)].frame[3u];
                        let _e900 = local_1;
                        if ((_e900 & 4278190080u) == 0u) {
                        } else {
                            let _e904 = local.group_mask;
                            if ((_e904 & 4278190080u) == 0u) {
                            } else {
                                let _e908 = local.len;
                                if (_e908 < 32u) {
                                    let _e911 = local.group;
                                    let _e913 = local.len;
                                    if (_e913 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e913)] = _e911;
                                    let _e919 = local.group_mask;
                                    let _e921 = local.len;
                                    if (_e921 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e921)] = _e919;
                                    let _e928 = local.len;
                                    local.len = (_e928 + 1u);
                                }
                            }
                            local.group = (0u + _e892);
                            let _e932 = local_2;
                            local.group_mask = ((_e932 & 4278190080u) | (_e896 >> bitcast<u32>(24i)));
                        }
                        let _e937 = local_3;
                        phi_1026_ = (_e937 & 16777215u);
                        phi_1029_ = _e504;
                        loop {
                            let _e940 = phi_1026_;
                            let _e942 = phi_1029_;
                            local_6 = _e942;
                            let _e943 = (_e940 == 0u);
                            local_4 = _e943;
                            local_7 = _e943;
                            if _e943 {
                                phi_1027_ = u32();
                                phi_1030_ = bool();
                                phi_1627_ = false;
                            } else {
                                let _e946 = nodes.member[(0u + _e502)].links[1u];
                                let _e951 = ((0u + _e946) + select(firstTrailingBit(_e940), 32u, (_e940 == 0u)));
                                if (_e951 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e958 = triangles.member[(0u + _e951)].v0_;
                                let _e960 = (_e958.x - _e107);
                                let _e962 = (_e958.y - _e109);
                                let _e964 = (_e958.z - _e111);
                                if (_e337 == 0u) {
                                    phi_1074_ = vec3<f32>(_e962, _e964, _e960);
                                } else {
                                    if (_e337 == 1u) {
                                        phi_1073_ = vec3<f32>(_e964, _e960, _e962);
                                    } else {
                                        phi_1073_ = (_e958 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e972 = phi_1073_;
                                    phi_1074_ = _e972;
                                }
                                let _e974 = phi_1074_;
                                let _e978 = (_e974.x - (_e348 * _e974.z));
                                let _e982 = (_e974.y - (_e351 * _e974.z));
                                let _e984 = triangles.member[(0u + _e951)].v1_;
                                let _e986 = (_e984.x - _e107);
                                let _e988 = (_e984.y - _e109);
                                let _e990 = (_e984.z - _e111);
                                if (_e337 == 0u) {
                                    phi_1104_ = vec3<f32>(_e988, _e990, _e986);
                                } else {
                                    if (_e337 == 1u) {
                                        phi_1103_ = vec3<f32>(_e990, _e986, _e988);
                                    } else {
                                        phi_1103_ = (_e984 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e998 = phi_1103_;
                                    phi_1104_ = _e998;
                                }
                                let _e1000 = phi_1104_;
                                let _e1004 = (_e1000.x - (_e348 * _e1000.z));
                                let _e1008 = (_e1000.y - (_e351 * _e1000.z));
                                let _e1010 = triangles.member[(0u + _e951)].v2_;
                                let _e1012 = (_e1010.x - _e107);
                                let _e1014 = (_e1010.y - _e109);
                                let _e1016 = (_e1010.z - _e111);
                                if (_e337 == 0u) {
                                    phi_1134_ = vec3<f32>(_e1014, _e1016, _e1012);
                                } else {
                                    if (_e337 == 1u) {
                                        phi_1133_ = vec3<f32>(_e1016, _e1012, _e1014);
                                    } else {
                                        phi_1133_ = (_e1010 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e1024 = phi_1133_;
                                    phi_1134_ = _e1024;
                                }
                                let _e1026 = phi_1134_;
                                let _e1030 = (_e1026.x - (_e348 * _e1026.z));
                                let _e1034 = (_e1026.y - (_e351 * _e1026.z));
                                if (_e1004 < _e1030) {
                                    phi_1153_ = true;
                                } else {
                                    if (_e1004 == _e1030) {
                                        phi_1152_ = (_e1008 < _e1034);
                                    } else {
                                        phi_1152_ = false;
                                    }
                                    let _e1039 = phi_1152_;
                                    phi_1153_ = _e1039;
                                }
                                let _e1041 = phi_1153_;
                                if _e1041 {
                                    phi_1157_ = _e1034;
                                    phi_1158_ = _e1030;
                                    phi_1159_ = _e1008;
                                    phi_1160_ = _e1004;
                                } else {
                                    phi_1157_ = _e1008;
                                    phi_1158_ = _e1004;
                                    phi_1159_ = _e1034;
                                    phi_1160_ = _e1030;
                                }
                                let _e1043 = phi_1157_;
                                let _e1045 = phi_1158_;
                                let _e1047 = phi_1159_;
                                let _e1049 = phi_1160_;
                                let _e1052 = ((_e1049 * _e1043) - (_e1047 * _e1045));
                                if _e1041 {
                                    phi_1168_ = -(_e1052);
                                } else {
                                    phi_1168_ = _e1052;
                                }
                                let _e1055 = phi_1168_;
                                if (_e1030 < _e978) {
                                    phi_1179_ = true;
                                } else {
                                    if (_e1030 == _e978) {
                                        phi_1178_ = (_e1034 < _e982);
                                    } else {
                                        phi_1178_ = false;
                                    }
                                    let _e1060 = phi_1178_;
                                    phi_1179_ = _e1060;
                                }
                                let _e1062 = phi_1179_;
                                if _e1062 {
                                    phi_1183_ = _e982;
                                    phi_1184_ = _e978;
                                    phi_1185_ = _e1034;
                                    phi_1186_ = _e1030;
                                } else {
                                    phi_1183_ = _e1034;
                                    phi_1184_ = _e1030;
                                    phi_1185_ = _e982;
                                    phi_1186_ = _e978;
                                }
                                let _e1064 = phi_1183_;
                                let _e1066 = phi_1184_;
                                let _e1068 = phi_1185_;
                                let _e1070 = phi_1186_;
                                let _e1073 = ((_e1070 * _e1064) - (_e1068 * _e1066));
                                if _e1062 {
                                    phi_1194_ = -(_e1073);
                                } else {
                                    phi_1194_ = _e1073;
                                }
                                let _e1076 = phi_1194_;
                                if (_e978 < _e1004) {
                                    phi_1205_ = true;
                                } else {
                                    if (_e978 == _e1004) {
                                        phi_1204_ = (_e982 < _e1008);
                                    } else {
                                        phi_1204_ = false;
                                    }
                                    let _e1081 = phi_1204_;
                                    phi_1205_ = _e1081;
                                }
                                let _e1083 = phi_1205_;
                                if _e1083 {
                                    phi_1209_ = _e1008;
                                    phi_1210_ = _e1004;
                                    phi_1211_ = _e982;
                                    phi_1212_ = _e978;
                                } else {
                                    phi_1209_ = _e982;
                                    phi_1210_ = _e978;
                                    phi_1211_ = _e1008;
                                    phi_1212_ = _e1004;
                                }
                                let _e1085 = phi_1209_;
                                let _e1087 = phi_1210_;
                                let _e1089 = phi_1211_;
                                let _e1091 = phi_1212_;
                                let _e1094 = ((_e1091 * _e1085) - (_e1089 * _e1087));
                                if _e1083 {
                                    phi_1220_ = -(_e1094);
                                } else {
                                    phi_1220_ = _e1094;
                                }
                                let _e1097 = phi_1220_;
                                if (_e1055 >= 0f) {
                                    if (_e1076 >= 0f) {
                                        if (_e1097 >= 0f) {
                                            phi_1235_ = ((_e1055 + _e1076) + _e1097);
                                            phi_1236_ = false;
                                        } else {
                                            phi_1235_ = f32();
                                            phi_1236_ = true;
                                        }
                                        let _e1104 = phi_1235_;
                                        let _e1106 = phi_1236_;
                                        phi_1237_ = _e1104;
                                        phi_1238_ = _e1106;
                                    } else {
                                        phi_1237_ = f32();
                                        phi_1238_ = true;
                                    }
                                    let _e1108 = phi_1237_;
                                    let _e1110 = phi_1238_;
                                    phi_1239_ = _e1108;
                                    phi_1240_ = _e1110;
                                } else {
                                    phi_1239_ = f32();
                                    phi_1240_ = true;
                                }
                                let _e1112 = phi_1239_;
                                let _e1114 = phi_1240_;
                                if _e1114 {
                                    if (_e1055 <= 0f) {
                                        if (_e1076 <= 0f) {
                                            let _e1117 = (_e1097 <= 0f);
                                            if _e1117 {
                                            }
                                            phi_1258_ = ((_e1055 + _e1076) + _e1097);
                                            phi_1259_ = false;
                                            phi_1260_ = _e1117;
                                        } else {
                                            phi_1258_ = f32();
                                            phi_1259_ = true;
                                            phi_1260_ = false;
                                        }
                                        let _e1121 = phi_1258_;
                                        let _e1123 = phi_1259_;
                                        let _e1125 = phi_1260_;
                                        phi_1261_ = _e1121;
                                        phi_1262_ = _e1123;
                                        phi_1263_ = _e1125;
                                    } else {
                                        phi_1261_ = f32();
                                        phi_1262_ = true;
                                        phi_1263_ = false;
                                    }
                                    let _e1127 = phi_1261_;
                                    let _e1129 = phi_1262_;
                                    let _e1131 = phi_1263_;
                                    if _e1129 {
                                        phi_1267_ = false;
                                    } else {
                                        phi_1267_ = _e1131;
                                    }
                                    let _e1133 = phi_1267_;
                                    phi_1268_ = _e1127;
                                    phi_1269_ = _e1133;
                                } else {
                                    phi_1268_ = _e1112;
                                    phi_1269_ = true;
                                }
                                let _e1135 = phi_1268_;
                                let _e1137 = phi_1269_;
                                if _e1137 {
                                    let _e1138 = (_e1135 == 0f);
                                    if _e1138 {
                                        phi_1585_ = lt_bvh_triangle_Intersection();
                                        phi_1586_ = false;
                                    } else {
                                        let _e1140 = triangles.member[(0u + _e951)].v0_;
                                        let _e1142 = (_e1140.x - _e107);
                                        let _e1144 = (_e1140.y - _e109);
                                        let _e1146 = (_e1140.z - _e111);
                                        if (_e337 == 0u) {
                                            phi_1298_ = vec3<f32>(_e1144, _e1146, _e1142);
                                        } else {
                                            if (_e337 == 1u) {
                                                phi_1297_ = vec3<f32>(_e1146, _e1142, _e1144);
                                            } else {
                                                phi_1297_ = (_e1140 - vec3<f32>(_e107, _e109, _e111));
                                            }
                                            let _e1154 = phi_1297_;
                                            phi_1298_ = _e1154;
                                        }
                                        let _e1156 = phi_1298_;
                                        let _e1158 = triangles.member[(0u + _e951)].v1_;
                                        let _e1160 = triangles.member[(0u + _e951)].v0_;
                                        let _e1163 = (_e1158.x - _e1160.x);
                                        let _e1166 = (_e1158.y - _e1160.y);
                                        let _e1169 = (_e1158.z - _e1160.z);
                                        if (_e337 == 0u) {
                                            phi_1324_ = vec3<f32>(_e1166, _e1169, _e1163);
                                        } else {
                                            if (_e337 == 1u) {
                                                phi_1323_ = vec3<f32>(_e1169, _e1163, _e1166);
                                            } else {
                                                phi_1323_ = (_e1158 - _e1160);
                                            }
                                            let _e1176 = phi_1323_;
                                            phi_1324_ = _e1176;
                                        }
                                        let _e1178 = phi_1324_;
                                        let _e1180 = triangles.member[(0u + _e951)].v2_;
                                        let _e1182 = triangles.member[(0u + _e951)].v0_;
                                        let _e1185 = (_e1180.x - _e1182.x);
                                        let _e1188 = (_e1180.y - _e1182.y);
                                        let _e1191 = (_e1180.z - _e1182.z);
                                        if (_e337 == 0u) {
                                            phi_1350_ = vec3<f32>(_e1188, _e1191, _e1185);
                                        } else {
                                            if (_e337 == 1u) {
                                                phi_1349_ = vec3<f32>(_e1191, _e1185, _e1188);
                                            } else {
                                                phi_1349_ = (_e1180 - _e1182);
                                            }
                                            let _e1198 = phi_1349_;
                                            phi_1350_ = _e1198;
                                        }
                                        let _e1200 = phi_1350_;
                                        let _e1207 = ((_e1178.y * _e1200.z) - (_e1178.z * _e1200.y));
                                        let _e1214 = ((_e1178.z * _e1200.x) - (_e1178.x * _e1200.z));
                                        let _e1221 = ((_e1178.x * _e1200.y) - (_e1178.y * _e1200.x));
                                        let _e1235 = (((1f / _e345.z) * (((_e1207 * _e1156.x) + (_e1214 * _e1156.y)) + (_e1221 * _e1156.z))) / (((_e1207 * _e348) + (_e1214 * _e351)) + _e1221));
                                        if (_e1235 > 0f) {
                                            if (_e1235 < _e117) {
                                                let _e1239 = triangles.member[(0u + _e951)].v0_;
                                                let _e1241 = triangles.member[(0u + _e951)].v1_;
                                                if (_e1239.x < _e1241.x) {
                                                    phi_1406_ = _e1239.x;
                                                } else {
                                                    phi_1406_ = _e1241.x;
                                                }
                                                let _e1248 = phi_1406_;
                                                if (_e1239.y < _e1241.y) {
                                                    phi_1415_ = _e1239.y;
                                                } else {
                                                    phi_1415_ = _e1241.y;
                                                }
                                                let _e1255 = phi_1415_;
                                                if (_e1239.z < _e1241.z) {
                                                    phi_1424_ = _e1239.z;
                                                } else {
                                                    phi_1424_ = _e1241.z;
                                                }
                                                let _e1262 = phi_1424_;
                                                let _e1264 = triangles.member[(0u + _e951)].v2_;
                                                if (_e1248 < _e1264.x) {
                                                    phi_1433_ = _e1248;
                                                } else {
                                                    phi_1433_ = _e1264.x;
                                                }
                                                let _e1269 = phi_1433_;
                                                if (_e1255 < _e1264.y) {
                                                    phi_1440_ = _e1255;
                                                } else {
                                                    phi_1440_ = _e1264.y;
                                                }
                                                let _e1274 = phi_1440_;
                                                if (_e1262 < _e1264.z) {
                                                    phi_1447_ = _e1262;
                                                } else {
                                                    phi_1447_ = _e1264.z;
                                                }
                                                let _e1279 = phi_1447_;
                                                let _e1281 = triangles.member[(0u + _e951)].v0_;
                                                let _e1283 = triangles.member[(0u + _e951)].v1_;
                                                if (_e1281.x > _e1283.x) {
                                                    phi_1460_ = _e1281.x;
                                                } else {
                                                    phi_1460_ = _e1283.x;
                                                }
                                                let _e1290 = phi_1460_;
                                                if (_e1281.y > _e1283.y) {
                                                    phi_1469_ = _e1281.y;
                                                } else {
                                                    phi_1469_ = _e1283.y;
                                                }
                                                let _e1297 = phi_1469_;
                                                if (_e1281.z > _e1283.z) {
                                                    phi_1478_ = _e1281.z;
                                                } else {
                                                    phi_1478_ = _e1283.z;
                                                }
                                                let _e1304 = phi_1478_;
                                                let _e1306 = triangles.member[(0u + _e951)].v2_;
                                                if (_e1290 > _e1306.x) {
                                                    phi_1487_ = _e1290;
                                                } else {
                                                    phi_1487_ = _e1306.x;
                                                }
                                                let _e1311 = phi_1487_;
                                                if (_e1297 > _e1306.y) {
                                                    phi_1494_ = _e1297;
                                                } else {
                                                    phi_1494_ = _e1306.y;
                                                }
                                                let _e1316 = phi_1494_;
                                                if (_e1304 > _e1306.z) {
                                                    phi_1501_ = _e1304;
                                                } else {
                                                    phi_1501_ = _e1306.z;
                                                }
                                                let _e1321 = phi_1501_;
                                                let _e1325 = ((_e1269 - _e107) * _e266);
                                                let _e1326 = ((_e1274 - _e109) * _e276);
                                                let _e1327 = ((_e1279 - _e111) * _e286);
                                                let _e1331 = ((_e1311 - _e107) * _e266);
                                                let _e1332 = ((_e1316 - _e109) * _e276);
                                                let _e1333 = ((_e1321 - _e111) * _e286);
                                                if (_e1325 < _e1331) {
                                                    phi_1518_ = _e1325;
                                                } else {
                                                    phi_1518_ = _e1331;
                                                }
                                                let _e1336 = phi_1518_;
                                                if (_e1326 < _e1332) {
                                                    phi_1523_ = _e1326;
                                                } else {
                                                    phi_1523_ = _e1332;
                                                }
                                                let _e1339 = phi_1523_;
                                                if (_e1327 < _e1333) {
                                                    phi_1528_ = _e1327;
                                                } else {
                                                    phi_1528_ = _e1333;
                                                }
                                                let _e1342 = phi_1528_;
                                                if (_e1325 > _e1331) {
                                                    phi_1536_ = _e1325;
                                                } else {
                                                    phi_1536_ = _e1331;
                                                }
                                                let _e1348 = phi_1536_;
                                                if (_e1326 > _e1332) {
                                                    phi_1541_ = _e1326;
                                                } else {
                                                    phi_1541_ = _e1332;
                                                }
                                                let _e1351 = phi_1541_;
                                                if (_e1327 > _e1333) {
                                                    phi_1546_ = _e1327;
                                                } else {
                                                    phi_1546_ = _e1333;
                                                }
                                                let _e1354 = phi_1546_;
                                                let _e1358 = core_intrinsics_maximum_number_nsz_f32_((_e1336 - _e321), (_e1339 - _e322));
                                                let _e1359 = core_intrinsics_maximum_number_nsz_f32_(_e1358, (_e1342 - _e323));
                                                let _e1360 = core_intrinsics_minimum_number_nsz_f32_((_e1348 + _e321), (_e1351 + _e322));
                                                let _e1361 = core_intrinsics_minimum_number_nsz_f32_(_e1360, (_e1354 + _e323));
                                                if (_e1359 > -300000000000000000000000000000000000000f) {
                                                    phi_1558_ = _e1359;
                                                } else {
                                                    phi_1558_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1364 = phi_1558_;
                                                if (_e1361 < 300000000000000000000000000000000000000f) {
                                                    phi_1563_ = _e1361;
                                                } else {
                                                    phi_1563_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1367 = phi_1563_;
                                                if (_e1235 < _e1364) {
                                                    phi_1568_ = _e1364;
                                                } else {
                                                    phi_1568_ = _e1235;
                                                }
                                                let _e1370 = phi_1568_;
                                                if (_e1370 > _e1367) {
                                                    phi_1573_ = _e1367;
                                                } else {
                                                    phi_1573_ = _e1370;
                                                }
                                                let _e1373 = phi_1573_;
                                                phi_1578_ = lt_bvh_triangle_Intersection(_e1373, (_e1076 / _e1135), (_e1097 / _e1135), (_e1364 <= _e1367));
                                                phi_1579_ = false;
                                            } else {
                                                phi_1578_ = lt_bvh_triangle_Intersection();
                                                phi_1579_ = true;
                                            }
                                            let _e1379 = phi_1578_;
                                            let _e1381 = phi_1579_;
                                            phi_1580_ = _e1379;
                                            phi_1581_ = _e1381;
                                        } else {
                                            phi_1580_ = lt_bvh_triangle_Intersection();
                                            phi_1581_ = true;
                                        }
                                        let _e1383 = phi_1580_;
                                        let _e1385 = phi_1581_;
                                        if _e1385 {
                                        }
                                        phi_1585_ = _e1383;
                                        phi_1586_ = _e1385;
                                    }
                                    let _e1387 = phi_1585_;
                                    let _e1389 = phi_1586_;
                                    phi_1587_ = _e1387;
                                    phi_1588_ = _e1138;
                                    phi_1589_ = _e1389;
                                } else {
                                    phi_1587_ = lt_bvh_triangle_Intersection();
                                    phi_1588_ = true;
                                    phi_1589_ = false;
                                }
                                let _e1391 = phi_1587_;
                                let _e1393 = phi_1588_;
                                let _e1395 = phi_1589_;
                                if _e1393 {
                                    phi_1593_ = true;
                                } else {
                                    phi_1593_ = _e1395;
                                }
                                let _e1397 = phi_1593_;
                                if _e1397 {
                                    phi_1597_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1597_ = _e1391;
                                }
                                let _e1399 = phi_1597_;
                                if _e1399.is_hit {
                                    if (_e1399.t > 0f) {
                                        if (_e1399.t < _e117) {
                                            if true {
                                                phi_1617_ = false;
                                            } else {
                                                phi_1617_ = true;
                                            }
                                            let _e1408 = phi_1617_;
                                            phi_1618_ = true;
                                            phi_1619_ = _e1408;
                                        } else {
                                            phi_1618_ = _e942;
                                            phi_1619_ = true;
                                        }
                                        let _e1410 = phi_1618_;
                                        let _e1412 = phi_1619_;
                                        phi_1620_ = _e1410;
                                        phi_1621_ = _e1412;
                                    } else {
                                        phi_1620_ = _e942;
                                        phi_1621_ = true;
                                    }
                                    let _e1414 = phi_1620_;
                                    let _e1416 = phi_1621_;
                                    phi_1622_ = _e1414;
                                    phi_1623_ = _e1416;
                                } else {
                                    phi_1622_ = _e942;
                                    phi_1623_ = true;
                                }
                                let _e1418 = phi_1622_;
                                let _e1420 = phi_1623_;
                                if _e1420 {
                                }
                                phi_1027_ = (_e940 & (_e940 - 1u));
                                phi_1030_ = _e1418;
                                phi_1627_ = _e1420;
                            }
                            let _e1422 = phi_1027_;
                            let _e1424 = phi_1030_;
                            let _e1426 = phi_1627_;
                            continue;
                            continuing {
                                phi_1026_ = _e1422;
                                phi_1029_ = _e1424;
                                break if !(_e1426);
                            }
                        }
                        let _e1429 = local_4;
                        if _e1429 {
                            let _e1431 = local.group_mask;
                            if ((_e1431 & 4278190080u) == 0u) {
                                let _e1435 = local.len;
                                if (_e1435 == 0u) {
                                    phi_1669_ = false;
                                } else {
                                    let _e1439 = local.len;
                                    local.len = (_e1439 - 1u);
                                    let _e1442 = local.len;
                                    if (_e1442 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1447 = local.first[(0u + _e1442)];
                                    local.group = _e1447;
                                    let _e1450 = local.len;
                                    if (_e1450 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1455 = local.mask[(0u + _e1450)];
                                    local.group_mask = _e1455;
                                    phi_1669_ = true;
                                }
                                let _e1458 = phi_1669_;
                                phi_1670_ = _e1458;
                            } else {
                                phi_1670_ = true;
                            }
                            let _e1460 = phi_1670_;
                            if _e1460 {
                                let _e1462 = local.group_mask;
                                let _e1468 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1462)), 32u, (_e1462 == 0u)));
                                let _e1472 = local.group_mask;
                                let _e1486 = local.group_mask;
                                local.group_mask = (_e1486 & ~((1u << bitcast<u32>((_e1468 & 31u)))));
                                let _e1489 = local.group;
                                phi_1701_ = (_e1489 + countOneBits(((_e1472 & ~((4294967295u << bitcast<u32>((((_e1468 - 24u) ^ _e364) & 31u))))) & 255u)));
                            } else {
                                phi_1701_ = 4294967295u;
                            }
                            let _e1492 = phi_1701_;
                            phi_1702_ = _e1492;
                        } else {
                            phi_1702_ = u32();
                        }
                        let _e1494 = phi_1702_;
                        phi_695_ = _e1494;
                        let _e1782 = local_6;
                        phi_698_ = _e1782;
                        let _e1785 = local_7;
                        phi_1703_ = _e1785;
                        phi_1704_ = false;
                    } else {
                        phi_695_ = u32();
                        phi_698_ = bool();
                        phi_1703_ = false;
                        phi_1704_ = true;
                    }
                    let _e1496 = phi_695_;
                    let _e1498 = phi_698_;
                    let _e1500 = phi_1703_;
                    let _e1502 = phi_1704_;
                    local_5 = _e1502;
                    continue;
                    continuing {
                        phi_694_ = _e1496;
                        phi_697_ = _e1498;
                        break if !(_e1500);
                    }
                }
                let _e1505 = local_5;
                if _e1505 {
                    phi_1708_ = false;
                } else {
                    phi_1708_ = true;
                }
                let _e1507 = phi_1708_;
                if _e1507 {
                    phi_1712_ = true;
                } else {
                    let _e1791 = local_8;
                    phi_1712_ = _e1791;
                }
                let _e1509 = phi_1712_;
                phi_1713_ = _e1509;
            }
            let _e1511 = phi_1713_;
            phi_1714_ = _e1511;
            phi_1715_ = _e190;
        } else {
            phi_1714_ = bool();
            phi_1715_ = true;
        }
        let _e1513 = phi_1714_;
        let _e1515 = phi_1715_;
        if _e1515 {
            phi_1719_ = false;
        } else {
            phi_1719_ = _e1513;
        }
        let _e1517 = phi_1719_;
        if _e1517 {
            phi_1723_ = 0f;
        } else {
            phi_1723_ = 1f;
        }
        let _e1519 = phi_1723_;
        if (_e87 < _e68) {
        } else {
            return;
        }
        visibility.member[(0u + _e87)] = _e1519;
        let _e1525 = p.member.light.number;
        let _e1526 = (_e1525 * 3u);
        let _e1527 = (_e1526 / 32u);
        let _e1528 = (_e1526 % 32u);
        let _e1530 = p.member.light.mask_words;
        if (_e87 < _e68) {
        } else {
            return;
        }
        let _e1534 = visibility.member[(0u + _e87)];
        let _e1536 = ((_e87 * _e1530) + _e1527);
        if (_e1528 > 29u) {
            let _e1538 = (_e1536 + 1u);
            if (_e1538 < _e74) {
            } else {
                return;
            }
            let _e1542 = bits.member[(0u + _e1538)];
            phi_1764_ = _e1542;
        } else {
            phi_1764_ = 0u;
        }
        let _e1544 = phi_1764_;
        if (_e1536 < _e74) {
        } else {
            return;
        }
        let _e1548 = bits.member[(0u + _e1536)];
        let _e1551 = (_e1548 >> bitcast<u32>((_e1528 & 31u)));
        if (_e1528 > 29u) {
            phi_1783_ = (_e1551 | (_e1544 << bitcast<u32>(((32u - _e1528) & 31u))));
        } else {
            phi_1783_ = _e1551;
        }
        let _e1559 = phi_1783_;
        if ((_e1559 & 2u) == 0u) {
            phi_1791_ = (_e1559 & 1u);
        } else {
            phi_1791_ = (_e1559 & 7u);
        }
        let _e1565 = phi_1791_;
        if ((_e1565 & 1u) != 0u) {
            phi_1799_ = (2u | 1u);
        } else {
            phi_1799_ = 2u;
        }
        let _e1571 = phi_1799_;
        if (_e1534 < 0.5f) {
            phi_1804_ = (_e1571 | 4u);
        } else {
            phi_1804_ = _e1571;
        }
        let _e1574 = phi_1804_;
        let _e1576 = ((_e87 * _e1530) + _e1527);
        if (_e1576 < _e74) {
        } else {
            return;
        }
        let _e1580 = bits.member[(0u + _e1576)];
        if (_e1576 < _e74) {
        } else {
            return;
        }
        bits.member[(0u + _e1576)] = ((_e1580 & ~((7u << bitcast<u32>((_e1528 & 31u))))) | (_e1574 << bitcast<u32>((_e1528 & 31u))));
        if (_e1528 > 29u) {
            let _e1594 = (_e1576 + 1u);
            if (_e1594 < _e74) {
            } else {
                return;
            }
            let _e1598 = bits.member[(0u + _e1594)];
            let _e1599 = (32u - _e1528);
            let _e1609 = (_e1576 + 1u);
            if (_e1609 < _e74) {
            } else {
                return;
            }
            bits.member[(0u + _e1609)] = ((_e1598 & ~((7u >> bitcast<u32>((_e1599 & 31u))))) | (_e1574 >> bitcast<u32>((_e1599 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
