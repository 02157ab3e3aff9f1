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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_28 {
    member: array<lt_bvh_Triangle>,
}

struct lt_bvh_traverse_Stack {
    first: array<u32, 32>,
    mask: array<u32, 32>,
    len: u32,
    group: u32,
    group_mask: u32,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_37 {
    member: array<lt_bvh_Node>,
}

struct u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_ {
    unnamed: lt_bvh_traverse_Tree,
    unnamed_1: lt_bvh_traverse_Tree,
}

struct lt_bvh_triangle_Intersection {
    t: f32,
    u: f32,
    v: f32,
    is_hit: bool,
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

struct type_43 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_28;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_149_: bool;
    var phi_153_: f32;

    if (param != param) {
        phi_149_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_149_ = _e54;
    }
    let _e56 = phi_149_;
    if _e56 {
        phi_153_ = param_1;
    } else {
        phi_153_ = param;
    }
    let _e58 = phi_153_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_165_: bool;
    var phi_169_: f32;

    if (param_2 != param_2) {
        phi_165_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_165_ = _e54;
    }
    let _e56 = phi_165_;
    if _e56 {
        phi_169_ = param_3;
    } else {
        phi_169_ = param_2;
    }
    let _e58 = phi_169_;
    return _e58;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_245_: f32;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_327_: bool;
    var phi_331_: bool;
    var phi_401_: f32;
    var phi_408_: f32;
    var phi_415_: f32;
    var phi_422_: f32;
    var phi_429_: f32;
    var phi_436_: f32;
    var phi_453_: f32;
    var phi_458_: f32;
    var phi_463_: f32;
    var phi_491_: bool;
    var phi_492_: bool;
    var phi_500_: u32;
    var phi_501_: u32;
    var phi_512_: vec3<f32>;
    var phi_513_: vec3<f32>;
    var phi_526_: u32;
    var phi_531_: u32;
    var phi_536_: u32;
    var phi_650_: bool;
    var phi_651_: bool;
    var phi_682_: u32;
    var phi_684_: u32;
    var phi_765_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_792_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_819_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_825_: u32;
    var phi_828_: u32;
    var phi_842_: u32;
    var phi_852_: u32;
    var phi_862_: u32;
    var phi_880_: u32;
    var phi_890_: u32;
    var phi_900_: u32;
    var phi_936_: u32;
    var phi_949_: u32;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_826_: u32;
    var phi_829_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1014_: u32;
    var phi_1059_: vec3<f32>;
    var phi_1060_: vec3<f32>;
    var phi_1091_: vec3<f32>;
    var phi_1092_: vec3<f32>;
    var phi_1123_: vec3<f32>;
    var phi_1124_: vec3<f32>;
    var phi_1144_: bool;
    var phi_1145_: bool;
    var phi_1149_: f32;
    var phi_1150_: f32;
    var phi_1151_: f32;
    var phi_1152_: f32;
    var phi_1160_: f32;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1175_: f32;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1178_: f32;
    var phi_1186_: f32;
    var phi_1196_: bool;
    var phi_1197_: bool;
    var phi_1201_: f32;
    var phi_1202_: f32;
    var phi_1203_: f32;
    var phi_1204_: f32;
    var phi_1212_: f32;
    var phi_1227_: f32;
    var phi_1228_: bool;
    var phi_1229_: f32;
    var phi_1230_: bool;
    var phi_1231_: f32;
    var phi_1232_: bool;
    var phi_1250_: f32;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1259_: bool;
    var phi_1260_: f32;
    var phi_1261_: bool;
    var phi_1295_: f32;
    var phi_1304_: f32;
    var phi_1313_: f32;
    var phi_1322_: f32;
    var phi_1329_: f32;
    var phi_1336_: f32;
    var phi_1349_: f32;
    var phi_1358_: f32;
    var phi_1367_: f32;
    var phi_1376_: f32;
    var phi_1383_: f32;
    var phi_1390_: f32;
    var phi_1407_: f32;
    var phi_1412_: f32;
    var phi_1417_: f32;
    var phi_1425_: f32;
    var phi_1430_: f32;
    var phi_1435_: f32;
    var phi_1447_: f32;
    var phi_1452_: f32;
    var phi_1457_: f32;
    var phi_1462_: f32;
    var phi_1467_: lt_bvh_triangle_Intersection;
    var phi_1468_: bool;
    var phi_1469_: lt_bvh_triangle_Intersection;
    var phi_1470_: bool;
    var phi_1474_: lt_bvh_triangle_Intersection;
    var phi_1475_: bool;
    var phi_1476_: lt_bvh_triangle_Intersection;
    var phi_1477_: bool;
    var phi_1478_: bool;
    var phi_1482_: bool;
    var phi_1486_: lt_bvh_triangle_Intersection;
    var phi_1511_: bool;
    var phi_1512_: bool;
    var phi_1513_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1516_: bool;
    var phi_1517_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1521_: bool;
    var phi_1522_: bool;
    var phi_1526_: bool;
    var phi_1527_: bool;
    var phi_1015_: u32;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1530_: bool;
    var local_4: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1604_: u32;
    var phi_1605_: u32;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_685_: u32;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var local_5: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1620_: bool;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1631_: bool;
    var phi_1635_: f32;
    var phi_1656_: u32;
    var phi_1671_: u32;
    var phi_1676_: u32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;

    let _e52 = id_1;
    let _e59 = arrayLength((&nodes.member));
    let _e65 = arrayLength((&visibility.member));
    let _e68 = arrayLength((&list.member));
    let _e71 = arrayLength((&bits.member));
    let _e75 = ((_e52.y * 2097152u) + _e52.x);
    if (3u < _e68) {
    } else {
        return;
    }
    let _e78 = list.member[3u];
    if (_e75 < _e78) {
        let _e80 = (_e75 + 4u);
        if (_e80 < _e68) {
        } else {
            return;
        }
        let _e84 = list.member[(0u + _e80)];
        if (_e84 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e89 = p.member.light;
        let _e91 = samples.member[(0u + _e84)].position;
        let _e93 = samples.member[(0u + _e84)].normal;
        let _e95 = samples.member[(0u + _e84)].magnitude;
        let _e97 = ((8f / 8388608f) * _e95);
        let _e105 = (_e91.x + (_e93.x * _e97));
        let _e107 = (_e91.y + (_e93.y * _e97));
        let _e109 = (_e91.z + (_e93.z * _e97));
        if (_e89.w == 0f) {
            phi_245_ = 300000000000000000000000000000000000000f;
        } else {
            phi_245_ = 1f;
        }
        let _e113 = phi_245_;
        let _e121 = (_e89.x - (_e105 * _e89.w));
        let _e122 = (_e89.y - (_e107 * _e89.w));
        let _e123 = (_e89.z - (_e109 * _e89.w));
        let _e128 = abs(_e121);
        let _e129 = abs(_e122);
        let _e130 = abs(_e123);
        if (abs(_e105) < 1000000000000000f) {
            if (abs(_e107) < 1000000000000000f) {
                if (abs(_e109) < 1000000000000000f) {
                    if (_e128 < 1000000000000000f) {
                        if (_e129 < 1000000000000000f) {
                            if (_e130 < 1000000000000000f) {
                                if (_e128 > 0f) {
                                    phi_301_ = bool();
                                    phi_302_ = true;
                                } else {
                                    let _e138 = (_e129 > 0f);
                                    if _e138 {
                                        phi_300_ = bool();
                                    } else {
                                        phi_300_ = (_e130 > 0f);
                                    }
                                    let _e141 = phi_300_;
                                    phi_301_ = _e141;
                                    phi_302_ = _e138;
                                }
                                let _e143 = phi_301_;
                                let _e145 = phi_302_;
                                if _e145 {
                                    phi_306_ = true;
                                } else {
                                    phi_306_ = _e143;
                                }
                                let _e147 = phi_306_;
                                phi_307_ = _e147;
                                phi_308_ = false;
                            } else {
                                phi_307_ = bool();
                                phi_308_ = true;
                            }
                            let _e149 = phi_307_;
                            let _e151 = phi_308_;
                            phi_309_ = _e149;
                            phi_310_ = false;
                            phi_311_ = _e151;
                        } else {
                            phi_309_ = bool();
                            phi_310_ = true;
                            phi_311_ = false;
                        }
                        let _e153 = phi_309_;
                        let _e155 = phi_310_;
                        let _e157 = phi_311_;
                        phi_312_ = _e153;
                        phi_313_ = _e155;
                        phi_314_ = _e157;
                    } else {
                        phi_312_ = bool();
                        phi_313_ = true;
                        phi_314_ = false;
                    }
                    let _e159 = phi_312_;
                    let _e161 = phi_313_;
                    let _e163 = phi_314_;
                    phi_315_ = _e159;
                    phi_316_ = _e161;
                    phi_317_ = _e163;
                } else {
                    phi_315_ = bool();
                    phi_316_ = true;
                    phi_317_ = false;
                }
                let _e165 = phi_315_;
                let _e167 = phi_316_;
                let _e169 = phi_317_;
                phi_318_ = _e165;
                phi_319_ = _e167;
                phi_320_ = _e169;
            } else {
                phi_318_ = bool();
                phi_319_ = true;
                phi_320_ = false;
            }
            let _e171 = phi_318_;
            let _e173 = phi_319_;
            let _e175 = phi_320_;
            phi_321_ = _e171;
            phi_322_ = _e173;
            phi_323_ = _e175;
        } else {
            phi_321_ = bool();
            phi_322_ = true;
            phi_323_ = false;
        }
        let _e177 = phi_321_;
        let _e179 = phi_322_;
        let _e181 = phi_323_;
        if _e179 {
            phi_327_ = true;
        } else {
            phi_327_ = _e181;
        }
        let _e183 = phi_327_;
        if _e183 {
            phi_331_ = false;
        } else {
            phi_331_ = _e177;
        }
        let _e185 = phi_331_;
        if _e185 {
            let _e186 = (0u >= _e59);
            if _e186 {
                phi_1625_ = bool();
            } else {
                if (0u < _e59) {
                } else {
                    return;
                }
                let _e192 = nodes.member[(0u + 0u)].frame[0u];
                let _e196 = nodes.member[(0u + 0u)].frame[1u];
                let _e200 = nodes.member[(0u + 0u)].frame[2u];
                let _e204 = nodes.member[(0u + 0u)].frame[0u];
                let _e208 = nodes.member[(0u + 0u)].frame[1u];
                let _e212 = nodes.member[(0u + 0u)].frame[2u];
                let _e216 = nodes.member[(0u + 0u)].frame[3u];
                let _e250 = core_intrinsics_maximum_number_nsz_f32_(abs(_e121), abs(_e122));
                let _e251 = core_intrinsics_maximum_number_nsz_f32_(_e250, abs(_e123));
                let _e252 = (_e251 * 0.0000000000009094947f);
                if (abs(_e121) < _e252) {
                    phi_401_ = _e252;
                } else {
                    phi_401_ = abs(_e121);
                }
                let _e257 = phi_401_;
                if (_e121 < 0f) {
                    phi_408_ = (-1f / _e257);
                } else {
                    phi_408_ = (1f / _e257);
                }
                let _e262 = phi_408_;
                if (abs(_e122) < _e252) {
                    phi_415_ = _e252;
                } else {
                    phi_415_ = abs(_e122);
                }
                let _e267 = phi_415_;
                if (_e122 < 0f) {
                    phi_422_ = (-1f / _e267);
                } else {
                    phi_422_ = (1f / _e267);
                }
                let _e272 = phi_422_;
                if (abs(_e123) < _e252) {
                    phi_429_ = _e252;
                } else {
                    phi_429_ = abs(_e123);
                }
                let _e277 = phi_429_;
                if (_e123 < 0f) {
                    phi_436_ = (-1f / _e277);
                } else {
                    phi_436_ = (1f / _e277);
                }
                let _e282 = phi_436_;
                let _e286 = abs((bitcast<f32>(_e192) - _e105));
                let _e287 = abs((bitcast<f32>(_e196) - _e107));
                let _e288 = abs((bitcast<f32>(_e200) - _e109));
                let _e292 = abs(((bitcast<f32>(_e204) + (bitcast<f32>((((_e216 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105));
                let _e293 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e216 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e294 = abs(((bitcast<f32>(_e212) + (bitcast<f32>((((_e216 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                if (_e286 > _e292) {
                    phi_453_ = _e286;
                } else {
                    phi_453_ = _e292;
                }
                let _e297 = phi_453_;
                if (_e287 > _e293) {
                    phi_458_ = _e287;
                } else {
                    phi_458_ = _e293;
                }
                let _e300 = phi_458_;
                if (_e288 > _e294) {
                    phi_463_ = _e288;
                } else {
                    phi_463_ = _e294;
                }
                let _e303 = phi_463_;
                let _e304 = core_intrinsics_maximum_number_nsz_f32_(_e297, _e300);
                let _e305 = core_intrinsics_maximum_number_nsz_f32_(_e304, _e303);
                let _e309 = (_e305 * 0.0000019073486f);
                let _e310 = (abs(_e262) * _e309);
                let _e311 = (abs(_e272) * _e309);
                let _e312 = (abs(_e282) * _e309);
                let _e316 = (_e305 * 0.0000009536743f);
                let _e317 = (abs(_e262) * _e316);
                let _e318 = (abs(_e272) * _e316);
                let _e319 = (abs(_e282) * _e316);
                let _e320 = abs(_e121);
                let _e321 = abs(_e122);
                let _e322 = abs(_e123);
                if (_e320 >= _e321) {
                    if (_e320 >= _e322) {
                        phi_491_ = false;
                    } else {
                        phi_491_ = true;
                    }
                    let _e326 = phi_491_;
                    phi_492_ = _e326;
                } else {
                    phi_492_ = true;
                }
                let _e328 = phi_492_;
                if _e328 {
                    if (_e321 >= _e322) {
                        phi_500_ = 1u;
                    } else {
                        phi_500_ = 2u;
                    }
                    let _e331 = phi_500_;
                    phi_501_ = _e331;
                } else {
                    phi_501_ = 0u;
                }
                let _e333 = phi_501_;
                if (_e333 == 0u) {
                    phi_513_ = vec3<f32>(_e122, _e123, _e121);
                } else {
                    if (_e333 == 1u) {
                        phi_512_ = vec3<f32>(_e123, _e121, _e122);
                    } else {
                        phi_512_ = vec3<f32>(_e121, _e122, _e123);
                    }
                    let _e339 = phi_512_;
                    phi_513_ = _e339;
                }
                let _e341 = phi_513_;
                let _e344 = (_e341.x / _e341.z);
                let _e347 = (_e341.y / _e341.z);
                let _e349 = (1f / _e341.z);
                if (_e262 < 0f) {
                    phi_526_ = 0u;
                } else {
                    phi_526_ = 1u;
                }
                let _e352 = phi_526_;
                if (_e272 < 0f) {
                    phi_531_ = 0u;
                } else {
                    phi_531_ = 2u;
                }
                let _e355 = phi_531_;
                if (_e282 < 0f) {
                    phi_536_ = 0u;
                } else {
                    phi_536_ = 4u;
                }
                let _e358 = phi_536_;
                let _e360 = ((_e352 | _e355) | _e358);
                let _e361 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e361.first[0], _e361.first[1], _e361.first[2], _e361.first[3], _e361.first[4], _e361.first[5], _e361.first[6], _e361.first[7], _e361.first[8], _e361.first[9], _e361.first[10], _e361.first[11], _e361.first[12], _e361.first[13], _e361.first[14], _e361.first[15], _e361.first[16], _e361.first[17], _e361.first[18], _e361.first[19], _e361.first[20], _e361.first[21], _e361.first[22], _e361.first[23], _e361.first[24], _e361.first[25], _e361.first[26], _e361.first[27], _e361.first[28], _e361.first[29], _e361.first[30], _e361.first[31]), array<u32, 32>(_e361.mask[0], _e361.mask[1], _e361.mask[2], _e361.mask[3], _e361.mask[4], _e361.mask[5], _e361.mask[6], _e361.mask[7], _e361.mask[8], _e361.mask[9], _e361.mask[10], _e361.mask[11], _e361.mask[12], _e361.mask[13], _e361.mask[14], _e361.mask[15], _e361.mask[16], _e361.mask[17], _e361.mask[18], _e361.mask[19], _e361.mask[20], _e361.mask[21], _e361.mask[22], _e361.mask[23], _e361.mask[24], _e361.mask[25], _e361.mask[26], _e361.mask[27], _e361.mask[28], _e361.mask[29], _e361.mask[30], _e361.mask[31]), _e361.len, _e361.group, _e361.group_mask);
                let _e435 = local.group_mask;
                if ((_e435 & 4278190080u) == 0u) {
                    let _e439 = local.len;
                    if (_e439 == 0u) {
                        phi_650_ = false;
                    } else {
                        let _e443 = local.len;
                        local.len = (_e443 - 1u);
                        let _e446 = local.len;
                        if (_e446 < 32u) {
                        } else {
                            return;
                        }
                        let _e451 = local.first[(0u + _e446)];
                        local.group = _e451;
                        let _e454 = local.len;
                        if (_e454 < 32u) {
                        } else {
                            return;
                        }
                        let _e459 = local.mask[(0u + _e454)];
                        local.group_mask = _e459;
                        phi_650_ = true;
                    }
                    let _e462 = phi_650_;
                    phi_651_ = _e462;
                } else {
                    phi_651_ = true;
                }
                let _e464 = phi_651_;
                if _e464 {
                    let _e466 = local.group_mask;
                    let _e472 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e466)), 32u, (_e466 == 0u)));
                    let _e476 = local.group_mask;
                    let _e490 = local.group_mask;
                    local.group_mask = (_e490 & ~((1u << bitcast<u32>((_e472 & 31u)))));
                    let _e493 = local.group;
                    phi_682_ = (_e493 + countOneBits(((_e476 & ~((4294967295u << bitcast<u32>((((_e472 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_682_ = 4294967295u;
                }
                let _e496 = phi_682_;
                phi_684_ = _e496;
                loop {
                    let _e498 = phi_684_;
                    if (_e498 != 4294967295u) {
                        if (_e498 < _e59) {
                        } else {
                            return;
                        }
                        let _e505 = nodes.member[(0u + _e498)].frame[3u];
                        let _e530 = (bitcast<f32>((((_e505 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e262);
                        let _e531 = (bitcast<f32>((((_e505 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e272);
                        let _e532 = (bitcast<f32>((((_e505 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e282);
                        let _e535 = nodes.member[(0u + _e498)].frame[0u];
                        let _e539 = nodes.member[(0u + _e498)].frame[1u];
                        let _e543 = nodes.member[(0u + _e498)].frame[2u];
                        let _e548 = ((bitcast<f32>(_e535) - _e105) * _e262);
                        let _e549 = ((bitcast<f32>(_e539) - _e107) * _e272);
                        let _e550 = ((bitcast<f32>(_e543) - _e109) * _e282);
                        let _e558 = nodes.member[(0u + _e498)].x;
                        if (_e262 < 0f) {
                            let _e569 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e558.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e569.unnamed.root, _e558.w), _e569.unnamed_1);
                            let _e581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e575.unnamed, lt_bvh_traverse_Tree(_e558.x, _e575.unnamed_1.first_primitive));
                            phi_765_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e581.unnamed, lt_bvh_traverse_Tree(_e581.unnamed_1.root, _e558.y));
                        } else {
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e558.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e597.unnamed.root, _e558.y), _e597.unnamed_1);
                            let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_bvh_traverse_Tree(_e558.z, _e603.unnamed_1.first_primitive));
                            phi_765_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e609.unnamed, lt_bvh_traverse_Tree(_e609.unnamed_1.root, _e558.w));
                        }
                        let _e617 = phi_765_;
                        let _e627 = nodes.member[(0u + _e498)].y;
                        if (_e272 < 0f) {
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e627.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e638.unnamed.root, _e627.w), _e638.unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_bvh_traverse_Tree(_e627.x, _e644.unnamed_1.first_primitive));
                            phi_792_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_bvh_traverse_Tree(_e650.unnamed_1.root, _e627.y));
                        } else {
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e627.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e666.unnamed.root, _e627.y), _e666.unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e627.z, _e672.unnamed_1.first_primitive));
                            phi_792_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_bvh_traverse_Tree(_e678.unnamed_1.root, _e627.w));
                        }
                        let _e686 = phi_792_;
                        let _e696 = nodes.member[(0u + _e498)].z;
                        if (_e282 < 0f) {
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e696.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e707.unnamed.root, _e696.w), _e707.unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_bvh_traverse_Tree(_e696.x, _e713.unnamed_1.first_primitive));
                            phi_819_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_bvh_traverse_Tree(_e719.unnamed_1.root, _e696.y));
                        } else {
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e696.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e735.unnamed.root, _e696.y), _e735.unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e696.z, _e741.unnamed_1.first_primitive));
                            phi_819_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_bvh_traverse_Tree(_e747.unnamed_1.root, _e696.w));
                        }
                        let _e755 = phi_819_;
                        phi_825_ = 0u;
                        phi_828_ = 0u;
                        loop {
                            let _e765 = phi_825_;
                            let _e767 = phi_828_;
                            local_1 = _e767;
                            local_2 = _e767;
                            local_3 = _e767;
                            let _e768 = (_e765 < 8u);
                            if _e768 {
                                let _e770 = (_e765 >> bitcast<u32>(2i));
                                let _e771 = (_e765 & 3u);
                                if (_e770 == 0u) {
                                    phi_842_ = _e617.unnamed.root;
                                } else {
                                    phi_842_ = _e617.unnamed.first_primitive;
                                }
                                let _e774 = phi_842_;
                                if (_e770 == 0u) {
                                    phi_852_ = _e686.unnamed.root;
                                } else {
                                    phi_852_ = _e686.unnamed.first_primitive;
                                }
                                let _e783 = phi_852_;
                                if (_e770 == 0u) {
                                    phi_862_ = _e755.unnamed.root;
                                } else {
                                    phi_862_ = _e755.unnamed.first_primitive;
                                }
                                let _e792 = phi_862_;
                                let _e805 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e774 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e530) + (_e548 - _e310)), ((f32(((_e783 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e311)));
                                let _e806 = core_intrinsics_maximum_number_nsz_f32_(_e805, ((f32(((_e792 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e312)));
                                if (_e770 == 0u) {
                                    phi_880_ = _e617.unnamed_1.root;
                                } else {
                                    phi_880_ = _e617.unnamed_1.first_primitive;
                                }
                                let _e809 = phi_880_;
                                if (_e770 == 0u) {
                                    phi_890_ = _e686.unnamed_1.root;
                                } else {
                                    phi_890_ = _e686.unnamed_1.first_primitive;
                                }
                                let _e818 = phi_890_;
                                if (_e770 == 0u) {
                                    phi_900_ = _e755.unnamed_1.root;
                                } else {
                                    phi_900_ = _e755.unnamed_1.first_primitive;
                                }
                                let _e827 = phi_900_;
                                let _e840 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e809 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e530) + (_e548 + _e310)), ((f32(((_e818 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e311)));
                                let _e841 = core_intrinsics_minimum_number_nsz_f32_(_e840, ((f32(((_e827 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e312)));
                                if (_e806 <= _e841) {
                                    if (_e806 <= _e113) {
                                        if (_e841 >= 0f) {
                                            if (_e770 == 0u) {
                                                let _e848 = nodes.member[(0u + _e498)].links[2u];
                                                phi_936_ = _e848;
                                            } else {
                                                let _e851 = nodes.member[(0u + _e498)].links[3u];
                                                phi_936_ = _e851;
                                            }
                                            let _e853 = phi_936_;
                                            let _e858 = ((_e853 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u);
                                            let _e859 = (_e858 & 31u);
                                            if (_e859 >= 24u) {
                                                phi_949_ = (24u + ((_e859 - 24u) ^ _e360));
                                            } else {
                                                phi_949_ = _e859;
                                            }
                                            let _e865 = phi_949_;
                                            phi_954_ = (_e767 | ((_e858 >> bitcast<u32>(5i)) << bitcast<u32>((_e865 & 31u))));
                                        } else {
                                            phi_954_ = _e767;
                                        }
                                        let _e873 = phi_954_;
                                        phi_955_ = _e873;
                                    } else {
                                        phi_955_ = _e767;
                                    }
                                    let _e875 = phi_955_;
                                    phi_956_ = _e875;
                                } else {
                                    phi_956_ = _e767;
                                }
                                let _e877 = phi_956_;
                                phi_826_ = (_e765 + 1u);
                                phi_829_ = _e877;
                            } else {
                                phi_826_ = u32();
                                phi_829_ = u32();
                            }
                            let _e880 = phi_826_;
                            let _e882 = phi_829_;
                            continue;
                            continuing {
                                phi_825_ = _e880;
                                phi_828_ = _e882;
                                break if !(_e768);
                            }
                        }
                        let _e886 = nodes.member[(0u + _e498)].links[0u];
                        let _e890 = nodes.member[(0u + _e498)].frame[3u];
                        let _e894 = local_1;
                        if ((_e894 & 4278190080u) == 0u) {
                        } else {
                            let _e898 = local.group_mask;
                            if ((_e898 & 4278190080u) == 0u) {
                            } else {
                                let _e902 = local.len;
                                if (_e902 < 32u) {
                                    let _e905 = local.group;
                                    let _e907 = local.len;
                                    if (_e907 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e907)] = _e905;
                                    let _e913 = local.group_mask;
                                    let _e915 = local.len;
                                    if (_e915 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e915)] = _e913;
                                    let _e922 = local.len;
                                    local.len = (_e922 + 1u);
                                }
                            }
                            local.group = (0u + _e886);
                            let _e926 = local_2;
                            local.group_mask = ((_e926 & 4278190080u) | (_e890 >> bitcast<u32>(24i)));
                        }
                        let _e931 = local_3;
                        phi_1014_ = (_e931 & 16777215u);
                        loop {
                            let _e934 = phi_1014_;
                            let _e935 = (_e934 == 0u);
                            local_4 = _e935;
                            local_8 = _e935;
                            if _e935 {
                                phi_1015_ = u32();
                                phi_1528_ = false;
                                phi_1529_ = false;
                                phi_1530_ = false;
                            } else {
                                let _e938 = nodes.member[(0u + _e498)].links[1u];
                                let _e943 = ((0u + _e938) + select(firstTrailingBit(_e934), 32u, (_e934 == 0u)));
                                if (_e943 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e950 = triangles.member[(0u + _e943)].v0_;
                                let _e952 = (_e950.x - _e105);
                                let _e954 = (_e950.y - _e107);
                                let _e956 = (_e950.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1060_ = vec3<f32>(_e954, _e956, _e952);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1059_ = vec3<f32>(_e956, _e952, _e954);
                                    } else {
                                        phi_1059_ = (_e950 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e964 = phi_1059_;
                                    phi_1060_ = _e964;
                                }
                                let _e966 = phi_1060_;
                                let _e970 = (_e966.x - (_e344 * _e966.z));
                                let _e974 = (_e966.y - (_e347 * _e966.z));
                                let _e978 = triangles.member[(0u + _e943)].v1_;
                                let _e980 = (_e978.x - _e105);
                                let _e982 = (_e978.y - _e107);
                                let _e984 = (_e978.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1092_ = vec3<f32>(_e982, _e984, _e980);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1091_ = vec3<f32>(_e984, _e980, _e982);
                                    } else {
                                        phi_1091_ = (_e978 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e992 = phi_1091_;
                                    phi_1092_ = _e992;
                                }
                                let _e994 = phi_1092_;
                                let _e998 = (_e994.x - (_e344 * _e994.z));
                                let _e1002 = (_e994.y - (_e347 * _e994.z));
                                let _e1006 = triangles.member[(0u + _e943)].v2_;
                                let _e1008 = (_e1006.x - _e105);
                                let _e1010 = (_e1006.y - _e107);
                                let _e1012 = (_e1006.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1124_ = vec3<f32>(_e1010, _e1012, _e1008);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1123_ = vec3<f32>(_e1012, _e1008, _e1010);
                                    } else {
                                        phi_1123_ = (_e1006 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e1020 = phi_1123_;
                                    phi_1124_ = _e1020;
                                }
                                let _e1022 = phi_1124_;
                                let _e1026 = (_e1022.x - (_e344 * _e1022.z));
                                let _e1030 = (_e1022.y - (_e347 * _e1022.z));
                                if (_e998 < _e1026) {
                                    phi_1145_ = true;
                                } else {
                                    if (_e998 == _e1026) {
                                        phi_1144_ = (_e1002 < _e1030);
                                    } else {
                                        phi_1144_ = false;
                                    }
                                    let _e1037 = phi_1144_;
                                    phi_1145_ = _e1037;
                                }
                                let _e1039 = phi_1145_;
                                if _e1039 {
                                    phi_1149_ = _e1030;
                                    phi_1150_ = _e1026;
                                    phi_1151_ = _e1002;
                                    phi_1152_ = _e998;
                                } else {
                                    phi_1149_ = _e1002;
                                    phi_1150_ = _e998;
                                    phi_1151_ = _e1030;
                                    phi_1152_ = _e1026;
                                }
                                let _e1041 = phi_1149_;
                                let _e1043 = phi_1150_;
                                let _e1045 = phi_1151_;
                                let _e1047 = phi_1152_;
                                let _e1050 = ((_e1047 * _e1041) - (_e1045 * _e1043));
                                if _e1039 {
                                    phi_1160_ = -(_e1050);
                                } else {
                                    phi_1160_ = _e1050;
                                }
                                let _e1053 = phi_1160_;
                                if (_e1026 < _e970) {
                                    phi_1171_ = true;
                                } else {
                                    if (_e1026 == _e970) {
                                        phi_1170_ = (_e1030 < _e974);
                                    } else {
                                        phi_1170_ = false;
                                    }
                                    let _e1058 = phi_1170_;
                                    phi_1171_ = _e1058;
                                }
                                let _e1060 = phi_1171_;
                                if _e1060 {
                                    phi_1175_ = _e974;
                                    phi_1176_ = _e970;
                                    phi_1177_ = _e1030;
                                    phi_1178_ = _e1026;
                                } else {
                                    phi_1175_ = _e1030;
                                    phi_1176_ = _e1026;
                                    phi_1177_ = _e974;
                                    phi_1178_ = _e970;
                                }
                                let _e1062 = phi_1175_;
                                let _e1064 = phi_1176_;
                                let _e1066 = phi_1177_;
                                let _e1068 = phi_1178_;
                                let _e1071 = ((_e1068 * _e1062) - (_e1066 * _e1064));
                                if _e1060 {
                                    phi_1186_ = -(_e1071);
                                } else {
                                    phi_1186_ = _e1071;
                                }
                                let _e1074 = phi_1186_;
                                if (_e970 < _e998) {
                                    phi_1197_ = true;
                                } else {
                                    if (_e970 == _e998) {
                                        phi_1196_ = (_e974 < _e1002);
                                    } else {
                                        phi_1196_ = false;
                                    }
                                    let _e1079 = phi_1196_;
                                    phi_1197_ = _e1079;
                                }
                                let _e1081 = phi_1197_;
                                if _e1081 {
                                    phi_1201_ = _e1002;
                                    phi_1202_ = _e998;
                                    phi_1203_ = _e974;
                                    phi_1204_ = _e970;
                                } else {
                                    phi_1201_ = _e974;
                                    phi_1202_ = _e970;
                                    phi_1203_ = _e1002;
                                    phi_1204_ = _e998;
                                }
                                let _e1083 = phi_1201_;
                                let _e1085 = phi_1202_;
                                let _e1087 = phi_1203_;
                                let _e1089 = phi_1204_;
                                let _e1092 = ((_e1089 * _e1083) - (_e1087 * _e1085));
                                if _e1081 {
                                    phi_1212_ = -(_e1092);
                                } else {
                                    phi_1212_ = _e1092;
                                }
                                let _e1095 = phi_1212_;
                                if (_e1053 >= 0f) {
                                    if (_e1074 >= 0f) {
                                        if (_e1095 >= 0f) {
                                            phi_1227_ = ((_e1053 + _e1074) + _e1095);
                                            phi_1228_ = false;
                                        } else {
                                            phi_1227_ = f32();
                                            phi_1228_ = true;
                                        }
                                        let _e1102 = phi_1227_;
                                        let _e1104 = phi_1228_;
                                        phi_1229_ = _e1102;
                                        phi_1230_ = _e1104;
                                    } else {
                                        phi_1229_ = f32();
                                        phi_1230_ = true;
                                    }
                                    let _e1106 = phi_1229_;
                                    let _e1108 = phi_1230_;
                                    phi_1231_ = _e1106;
                                    phi_1232_ = _e1108;
                                } else {
                                    phi_1231_ = f32();
                                    phi_1232_ = true;
                                }
                                let _e1110 = phi_1231_;
                                let _e1112 = phi_1232_;
                                if _e1112 {
                                    if (_e1053 <= 0f) {
                                        if (_e1074 <= 0f) {
                                            let _e1115 = (_e1095 <= 0f);
                                            if _e1115 {
                                            }
                                            phi_1250_ = ((_e1053 + _e1074) + _e1095);
                                            phi_1251_ = false;
                                            phi_1252_ = _e1115;
                                        } else {
                                            phi_1250_ = f32();
                                            phi_1251_ = true;
                                            phi_1252_ = false;
                                        }
                                        let _e1119 = phi_1250_;
                                        let _e1121 = phi_1251_;
                                        let _e1123 = phi_1252_;
                                        phi_1253_ = _e1119;
                                        phi_1254_ = _e1121;
                                        phi_1255_ = _e1123;
                                    } else {
                                        phi_1253_ = f32();
                                        phi_1254_ = true;
                                        phi_1255_ = false;
                                    }
                                    let _e1125 = phi_1253_;
                                    let _e1127 = phi_1254_;
                                    let _e1129 = phi_1255_;
                                    if _e1127 {
                                        phi_1259_ = false;
                                    } else {
                                        phi_1259_ = _e1129;
                                    }
                                    let _e1131 = phi_1259_;
                                    phi_1260_ = _e1125;
                                    phi_1261_ = _e1131;
                                } else {
                                    phi_1260_ = _e1110;
                                    phi_1261_ = true;
                                }
                                let _e1133 = phi_1260_;
                                let _e1135 = phi_1261_;
                                if _e1135 {
                                    let _e1136 = (_e1133 == 0f);
                                    if _e1136 {
                                        phi_1474_ = lt_bvh_triangle_Intersection();
                                        phi_1475_ = false;
                                    } else {
                                        let _e1142 = ((((_e1053 * (_e349 * _e966.z)) + (_e1074 * (_e349 * _e994.z))) + (_e1095 * (_e349 * _e1022.z))) / _e1133);
                                        if (_e1142 > 0f) {
                                            if (_e1142 < _e113) {
                                                let _e1146 = triangles.member[(0u + _e943)].v0_;
                                                let _e1148 = triangles.member[(0u + _e943)].v1_;
                                                if (_e1146.x < _e1148.x) {
                                                    phi_1295_ = _e1146.x;
                                                } else {
                                                    phi_1295_ = _e1148.x;
                                                }
                                                let _e1155 = phi_1295_;
                                                if (_e1146.y < _e1148.y) {
                                                    phi_1304_ = _e1146.y;
                                                } else {
                                                    phi_1304_ = _e1148.y;
                                                }
                                                let _e1162 = phi_1304_;
                                                if (_e1146.z < _e1148.z) {
                                                    phi_1313_ = _e1146.z;
                                                } else {
                                                    phi_1313_ = _e1148.z;
                                                }
                                                let _e1169 = phi_1313_;
                                                let _e1171 = triangles.member[(0u + _e943)].v2_;
                                                if (_e1155 < _e1171.x) {
                                                    phi_1322_ = _e1155;
                                                } else {
                                                    phi_1322_ = _e1171.x;
                                                }
                                                let _e1176 = phi_1322_;
                                                if (_e1162 < _e1171.y) {
                                                    phi_1329_ = _e1162;
                                                } else {
                                                    phi_1329_ = _e1171.y;
                                                }
                                                let _e1181 = phi_1329_;
                                                if (_e1169 < _e1171.z) {
                                                    phi_1336_ = _e1169;
                                                } else {
                                                    phi_1336_ = _e1171.z;
                                                }
                                                let _e1186 = phi_1336_;
                                                let _e1188 = triangles.member[(0u + _e943)].v0_;
                                                let _e1190 = triangles.member[(0u + _e943)].v1_;
                                                if (_e1188.x > _e1190.x) {
                                                    phi_1349_ = _e1188.x;
                                                } else {
                                                    phi_1349_ = _e1190.x;
                                                }
                                                let _e1197 = phi_1349_;
                                                if (_e1188.y > _e1190.y) {
                                                    phi_1358_ = _e1188.y;
                                                } else {
                                                    phi_1358_ = _e1190.y;
                                                }
                                                let _e1204 = phi_1358_;
                                                if (_e1188.z > _e1190.z) {
                                                    phi_1367_ = _e1188.z;
                                                } else {
                                                    phi_1367_ = _e1190.z;
                                                }
                                                let _e1211 = phi_1367_;
                                                let _e1213 = triangles.member[(0u + _e943)].v2_;
                                                if (_e1197 > _e1213.x) {
                                                    phi_1376_ = _e1197;
                                                } else {
                                                    phi_1376_ = _e1213.x;
                                                }
                                                let _e1218 = phi_1376_;
                                                if (_e1204 > _e1213.y) {
                                                    phi_1383_ = _e1204;
                                                } else {
                                                    phi_1383_ = _e1213.y;
                                                }
                                                let _e1223 = phi_1383_;
                                                if (_e1211 > _e1213.z) {
                                                    phi_1390_ = _e1211;
                                                } else {
                                                    phi_1390_ = _e1213.z;
                                                }
                                                let _e1228 = phi_1390_;
                                                let _e1232 = ((_e1176 - _e105) * _e262);
                                                let _e1233 = ((_e1181 - _e107) * _e272);
                                                let _e1234 = ((_e1186 - _e109) * _e282);
                                                let _e1238 = ((_e1218 - _e105) * _e262);
                                                let _e1239 = ((_e1223 - _e107) * _e272);
                                                let _e1240 = ((_e1228 - _e109) * _e282);
                                                if (_e1232 < _e1238) {
                                                    phi_1407_ = _e1232;
                                                } else {
                                                    phi_1407_ = _e1238;
                                                }
                                                let _e1243 = phi_1407_;
                                                if (_e1233 < _e1239) {
                                                    phi_1412_ = _e1233;
                                                } else {
                                                    phi_1412_ = _e1239;
                                                }
                                                let _e1246 = phi_1412_;
                                                if (_e1234 < _e1240) {
                                                    phi_1417_ = _e1234;
                                                } else {
                                                    phi_1417_ = _e1240;
                                                }
                                                let _e1249 = phi_1417_;
                                                if (_e1232 > _e1238) {
                                                    phi_1425_ = _e1232;
                                                } else {
                                                    phi_1425_ = _e1238;
                                                }
                                                let _e1255 = phi_1425_;
                                                if (_e1233 > _e1239) {
                                                    phi_1430_ = _e1233;
                                                } else {
                                                    phi_1430_ = _e1239;
                                                }
                                                let _e1258 = phi_1430_;
                                                if (_e1234 > _e1240) {
                                                    phi_1435_ = _e1234;
                                                } else {
                                                    phi_1435_ = _e1240;
                                                }
                                                let _e1261 = phi_1435_;
                                                let _e1265 = core_intrinsics_maximum_number_nsz_f32_((_e1243 - _e317), (_e1246 - _e318));
                                                let _e1266 = core_intrinsics_maximum_number_nsz_f32_(_e1265, (_e1249 - _e319));
                                                let _e1267 = core_intrinsics_minimum_number_nsz_f32_((_e1255 + _e317), (_e1258 + _e318));
                                                let _e1268 = core_intrinsics_minimum_number_nsz_f32_(_e1267, (_e1261 + _e319));
                                                if (_e1266 > -300000000000000000000000000000000000000f) {
                                                    phi_1447_ = _e1266;
                                                } else {
                                                    phi_1447_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1271 = phi_1447_;
                                                if (_e1268 < 300000000000000000000000000000000000000f) {
                                                    phi_1452_ = _e1268;
                                                } else {
                                                    phi_1452_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1274 = phi_1452_;
                                                if (_e1142 < _e1271) {
                                                    phi_1457_ = _e1271;
                                                } else {
                                                    phi_1457_ = _e1142;
                                                }
                                                let _e1277 = phi_1457_;
                                                if (_e1277 > _e1274) {
                                                    phi_1462_ = _e1274;
                                                } else {
                                                    phi_1462_ = _e1277;
                                                }
                                                let _e1280 = phi_1462_;
                                                phi_1467_ = lt_bvh_triangle_Intersection(_e1280, (_e1074 / _e1133), (_e1095 / _e1133), (_e1271 <= _e1274));
                                                phi_1468_ = false;
                                            } else {
                                                phi_1467_ = lt_bvh_triangle_Intersection();
                                                phi_1468_ = true;
                                            }
                                            let _e1286 = phi_1467_;
                                            let _e1288 = phi_1468_;
                                            phi_1469_ = _e1286;
                                            phi_1470_ = _e1288;
                                        } else {
                                            phi_1469_ = lt_bvh_triangle_Intersection();
                                            phi_1470_ = true;
                                        }
                                        let _e1290 = phi_1469_;
                                        let _e1292 = phi_1470_;
                                        if _e1292 {
                                        }
                                        phi_1474_ = _e1290;
                                        phi_1475_ = _e1292;
                                    }
                                    let _e1294 = phi_1474_;
                                    let _e1296 = phi_1475_;
                                    phi_1476_ = _e1294;
                                    phi_1477_ = _e1136;
                                    phi_1478_ = _e1296;
                                } else {
                                    phi_1476_ = lt_bvh_triangle_Intersection();
                                    phi_1477_ = true;
                                    phi_1478_ = false;
                                }
                                let _e1298 = phi_1476_;
                                let _e1300 = phi_1477_;
                                let _e1302 = phi_1478_;
                                if _e1300 {
                                    phi_1482_ = true;
                                } else {
                                    phi_1482_ = _e1302;
                                }
                                let _e1304 = phi_1482_;
                                if _e1304 {
                                    phi_1486_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1486_ = _e1298;
                                }
                                let _e1306 = phi_1486_;
                                if _e1306.is_hit {
                                    if (_e1306.t > 0f) {
                                        if (_e1306.t < _e113) {
                                            let _e1313 = triangles.member[(0u + _e943)].i0_;
                                            let _e1315 = ((_e1313 & 2147483648u) == 0u);
                                            if _e1315 {
                                                phi_1512_ = false;
                                                phi_1513_ = false;
                                            } else {
                                                if true {
                                                    phi_1511_ = false;
                                                } else {
                                                    phi_1511_ = true;
                                                }
                                                let _e1317 = phi_1511_;
                                                phi_1512_ = _e1317;
                                                phi_1513_ = true;
                                            }
                                            let _e1319 = phi_1512_;
                                            let _e1321 = phi_1513_;
                                            phi_1514_ = _e1319;
                                            phi_1515_ = _e1315;
                                            phi_1516_ = _e1321;
                                        } else {
                                            phi_1514_ = true;
                                            phi_1515_ = false;
                                            phi_1516_ = false;
                                        }
                                        let _e1323 = phi_1514_;
                                        let _e1325 = phi_1515_;
                                        let _e1327 = phi_1516_;
                                        phi_1517_ = _e1323;
                                        phi_1518_ = _e1325;
                                        phi_1519_ = _e1327;
                                    } else {
                                        phi_1517_ = true;
                                        phi_1518_ = false;
                                        phi_1519_ = false;
                                    }
                                    let _e1329 = phi_1517_;
                                    let _e1331 = phi_1518_;
                                    let _e1333 = phi_1519_;
                                    phi_1520_ = _e1329;
                                    phi_1521_ = _e1331;
                                    phi_1522_ = _e1333;
                                } else {
                                    phi_1520_ = true;
                                    phi_1521_ = false;
                                    phi_1522_ = false;
                                }
                                let _e1335 = phi_1520_;
                                let _e1337 = phi_1521_;
                                let _e1339 = phi_1522_;
                                if _e1335 {
                                    phi_1526_ = false;
                                    phi_1527_ = false;
                                } else {
                                    phi_1526_ = _e1337;
                                    phi_1527_ = _e1339;
                                }
                                let _e1341 = phi_1526_;
                                let _e1343 = phi_1527_;
                                phi_1015_ = (_e934 & (_e934 - 1u));
                                phi_1528_ = _e1335;
                                phi_1529_ = _e1341;
                                phi_1530_ = _e1343;
                            }
                            let _e1345 = phi_1015_;
                            let _e1347 = phi_1528_;
                            let _e1349 = phi_1529_;
                            let _e1351 = phi_1530_;
                            local_6 = _e1349;
                            local_7 = _e1351;
                            continue;
                            continuing {
                                phi_1014_ = _e1345;
                                break if !(_e1347);
                            }
                        }
                        let _e1354 = local_4;
                        if _e1354 {
                            let _e1356 = local.group_mask;
                            if ((_e1356 & 4278190080u) == 0u) {
                                let _e1360 = local.len;
                                if (_e1360 == 0u) {
                                    phi_1572_ = false;
                                } else {
                                    let _e1364 = local.len;
                                    local.len = (_e1364 - 1u);
                                    let _e1367 = local.len;
                                    if (_e1367 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1372 = local.first[(0u + _e1367)];
                                    local.group = _e1372;
                                    let _e1375 = local.len;
                                    if (_e1375 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1380 = local.mask[(0u + _e1375)];
                                    local.group_mask = _e1380;
                                    phi_1572_ = true;
                                }
                                let _e1383 = phi_1572_;
                                phi_1573_ = _e1383;
                            } else {
                                phi_1573_ = true;
                            }
                            let _e1385 = phi_1573_;
                            if _e1385 {
                                let _e1387 = local.group_mask;
                                let _e1393 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1387)), 32u, (_e1387 == 0u)));
                                let _e1397 = local.group_mask;
                                let _e1411 = local.group_mask;
                                local.group_mask = (_e1411 & ~((1u << bitcast<u32>((_e1393 & 31u)))));
                                let _e1414 = local.group;
                                phi_1604_ = (_e1414 + countOneBits(((_e1397 & ~((4294967295u << bitcast<u32>((((_e1393 - 24u) ^ _e360) & 31u))))) & 255u)));
                            } else {
                                phi_1604_ = 4294967295u;
                            }
                            let _e1417 = phi_1604_;
                            phi_1605_ = _e1417;
                            phi_1606_ = false;
                            phi_1607_ = false;
                        } else {
                            phi_1605_ = u32();
                            let _e1652 = local_6;
                            phi_1606_ = _e1652;
                            let _e1655 = local_7;
                            phi_1607_ = _e1655;
                        }
                        let _e1419 = phi_1605_;
                        let _e1421 = phi_1606_;
                        let _e1423 = phi_1607_;
                        phi_685_ = _e1419;
                        let _e1659 = local_8;
                        phi_1608_ = _e1659;
                        phi_1609_ = false;
                        phi_1610_ = _e1421;
                        phi_1611_ = _e1423;
                    } else {
                        phi_685_ = u32();
                        phi_1608_ = false;
                        phi_1609_ = true;
                        phi_1610_ = false;
                        phi_1611_ = false;
                    }
                    let _e1425 = phi_685_;
                    let _e1427 = phi_1608_;
                    let _e1429 = phi_1609_;
                    let _e1431 = phi_1610_;
                    let _e1433 = phi_1611_;
                    local_5 = _e1429;
                    local_9 = _e1431;
                    local_10 = _e1433;
                    continue;
                    continuing {
                        phi_684_ = _e1425;
                        break if !(_e1427);
                    }
                }
                let _e1436 = local_5;
                if _e1436 {
                    phi_1615_ = false;
                    phi_1616_ = false;
                } else {
                    let _e1666 = local_9;
                    phi_1615_ = _e1666;
                    let _e1669 = local_10;
                    phi_1616_ = _e1669;
                }
                let _e1438 = phi_1615_;
                let _e1440 = phi_1616_;
                if _e1438 {
                    phi_1620_ = true;
                } else {
                    phi_1620_ = _e1440;
                }
                let _e1442 = phi_1620_;
                if _e1442 {
                    phi_1624_ = true;
                } else {
                    phi_1624_ = false;
                }
                let _e1444 = phi_1624_;
                phi_1625_ = _e1444;
            }
            let _e1446 = phi_1625_;
            phi_1626_ = _e1446;
            phi_1627_ = _e186;
        } else {
            phi_1626_ = bool();
            phi_1627_ = true;
        }
        let _e1448 = phi_1626_;
        let _e1450 = phi_1627_;
        if _e1450 {
            phi_1631_ = false;
        } else {
            phi_1631_ = _e1448;
        }
        let _e1452 = phi_1631_;
        if _e1452 {
            phi_1635_ = 0f;
        } else {
            phi_1635_ = 1f;
        }
        let _e1454 = phi_1635_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        visibility.member[(0u + _e84)] = _e1454;
        if (_e84 < _e71) {
        } else {
            return;
        }
        let _e1461 = bits.member[(0u + _e84)];
        if ((_e1461 & 2u) == 0u) {
            phi_1656_ = (_e1461 & 1u);
        } else {
            phi_1656_ = (_e1461 & 7u);
        }
        let _e1467 = phi_1656_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        let _e1471 = visibility.member[(0u + _e84)];
        if ((_e1467 & 1u) != 0u) {
            phi_1671_ = (2u | 1u);
        } else {
            phi_1671_ = 2u;
        }
        let _e1477 = phi_1671_;
        if (_e1471 < 0.5f) {
            phi_1676_ = (_e1477 | 4u);
        } else {
            phi_1676_ = _e1477;
        }
        let _e1480 = phi_1676_;
        if (_e84 < _e71) {
        } else {
            return;
        }
        bits.member[(0u + _e84)] = _e1480;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
