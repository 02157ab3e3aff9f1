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
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
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
    var phi_1089_: vec3<f32>;
    var phi_1090_: vec3<f32>;
    var phi_1119_: vec3<f32>;
    var phi_1120_: vec3<f32>;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1143_: f32;
    var phi_1144_: f32;
    var phi_1145_: f32;
    var phi_1146_: f32;
    var phi_1154_: f32;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1169_: f32;
    var phi_1170_: f32;
    var phi_1171_: f32;
    var phi_1172_: f32;
    var phi_1180_: f32;
    var phi_1190_: bool;
    var phi_1191_: bool;
    var phi_1195_: f32;
    var phi_1196_: f32;
    var phi_1197_: f32;
    var phi_1198_: f32;
    var phi_1206_: f32;
    var phi_1221_: f32;
    var phi_1222_: bool;
    var phi_1223_: f32;
    var phi_1224_: bool;
    var phi_1225_: f32;
    var phi_1226_: bool;
    var phi_1244_: f32;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1247_: f32;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1253_: bool;
    var phi_1254_: f32;
    var phi_1255_: bool;
    var phi_1283_: vec3<f32>;
    var phi_1284_: vec3<f32>;
    var phi_1309_: vec3<f32>;
    var phi_1310_: vec3<f32>;
    var phi_1335_: vec3<f32>;
    var phi_1336_: vec3<f32>;
    var phi_1392_: f32;
    var phi_1401_: f32;
    var phi_1410_: f32;
    var phi_1419_: f32;
    var phi_1426_: f32;
    var phi_1433_: f32;
    var phi_1446_: f32;
    var phi_1455_: f32;
    var phi_1464_: f32;
    var phi_1473_: f32;
    var phi_1480_: f32;
    var phi_1487_: f32;
    var phi_1504_: f32;
    var phi_1509_: f32;
    var phi_1514_: f32;
    var phi_1522_: f32;
    var phi_1527_: f32;
    var phi_1532_: f32;
    var phi_1544_: f32;
    var phi_1549_: f32;
    var phi_1554_: f32;
    var phi_1559_: f32;
    var phi_1564_: lt_bvh_triangle_Intersection;
    var phi_1565_: bool;
    var phi_1566_: lt_bvh_triangle_Intersection;
    var phi_1567_: bool;
    var phi_1571_: lt_bvh_triangle_Intersection;
    var phi_1572_: bool;
    var phi_1573_: lt_bvh_triangle_Intersection;
    var phi_1574_: bool;
    var phi_1575_: bool;
    var phi_1579_: bool;
    var phi_1583_: lt_bvh_triangle_Intersection;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1623_: bool;
    var phi_1624_: bool;
    var phi_1015_: u32;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var local_4: bool;
    var phi_1669_: bool;
    var phi_1670_: bool;
    var phi_1701_: u32;
    var phi_1702_: u32;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_685_: u32;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var local_5: bool;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var phi_1717_: bool;
    var phi_1721_: bool;
    var phi_1722_: bool;
    var phi_1723_: bool;
    var phi_1724_: bool;
    var phi_1728_: bool;
    var phi_1732_: f32;
    var phi_1753_: u32;
    var phi_1768_: u32;
    var phi_1773_: u32;
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
                phi_1722_ = bool();
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
                                phi_1625_ = false;
                                phi_1626_ = false;
                                phi_1627_ = false;
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
                                let _e976 = triangles.member[(0u + _e943)].v1_;
                                let _e978 = (_e976.x - _e105);
                                let _e980 = (_e976.y - _e107);
                                let _e982 = (_e976.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1090_ = vec3<f32>(_e980, _e982, _e978);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1089_ = vec3<f32>(_e982, _e978, _e980);
                                    } else {
                                        phi_1089_ = (_e976 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e990 = phi_1089_;
                                    phi_1090_ = _e990;
                                }
                                let _e992 = phi_1090_;
                                let _e996 = (_e992.x - (_e344 * _e992.z));
                                let _e1000 = (_e992.y - (_e347 * _e992.z));
                                let _e1002 = triangles.member[(0u + _e943)].v2_;
                                let _e1004 = (_e1002.x - _e105);
                                let _e1006 = (_e1002.y - _e107);
                                let _e1008 = (_e1002.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1120_ = vec3<f32>(_e1006, _e1008, _e1004);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1119_ = vec3<f32>(_e1008, _e1004, _e1006);
                                    } else {
                                        phi_1119_ = (_e1002 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e1016 = phi_1119_;
                                    phi_1120_ = _e1016;
                                }
                                let _e1018 = phi_1120_;
                                let _e1022 = (_e1018.x - (_e344 * _e1018.z));
                                let _e1026 = (_e1018.y - (_e347 * _e1018.z));
                                if (_e996 < _e1022) {
                                    phi_1139_ = true;
                                } else {
                                    if (_e996 == _e1022) {
                                        phi_1138_ = (_e1000 < _e1026);
                                    } else {
                                        phi_1138_ = false;
                                    }
                                    let _e1031 = phi_1138_;
                                    phi_1139_ = _e1031;
                                }
                                let _e1033 = phi_1139_;
                                if _e1033 {
                                    phi_1143_ = _e1026;
                                    phi_1144_ = _e1022;
                                    phi_1145_ = _e1000;
                                    phi_1146_ = _e996;
                                } else {
                                    phi_1143_ = _e1000;
                                    phi_1144_ = _e996;
                                    phi_1145_ = _e1026;
                                    phi_1146_ = _e1022;
                                }
                                let _e1035 = phi_1143_;
                                let _e1037 = phi_1144_;
                                let _e1039 = phi_1145_;
                                let _e1041 = phi_1146_;
                                let _e1044 = ((_e1041 * _e1035) - (_e1039 * _e1037));
                                if _e1033 {
                                    phi_1154_ = -(_e1044);
                                } else {
                                    phi_1154_ = _e1044;
                                }
                                let _e1047 = phi_1154_;
                                if (_e1022 < _e970) {
                                    phi_1165_ = true;
                                } else {
                                    if (_e1022 == _e970) {
                                        phi_1164_ = (_e1026 < _e974);
                                    } else {
                                        phi_1164_ = false;
                                    }
                                    let _e1052 = phi_1164_;
                                    phi_1165_ = _e1052;
                                }
                                let _e1054 = phi_1165_;
                                if _e1054 {
                                    phi_1169_ = _e974;
                                    phi_1170_ = _e970;
                                    phi_1171_ = _e1026;
                                    phi_1172_ = _e1022;
                                } else {
                                    phi_1169_ = _e1026;
                                    phi_1170_ = _e1022;
                                    phi_1171_ = _e974;
                                    phi_1172_ = _e970;
                                }
                                let _e1056 = phi_1169_;
                                let _e1058 = phi_1170_;
                                let _e1060 = phi_1171_;
                                let _e1062 = phi_1172_;
                                let _e1065 = ((_e1062 * _e1056) - (_e1060 * _e1058));
                                if _e1054 {
                                    phi_1180_ = -(_e1065);
                                } else {
                                    phi_1180_ = _e1065;
                                }
                                let _e1068 = phi_1180_;
                                if (_e970 < _e996) {
                                    phi_1191_ = true;
                                } else {
                                    if (_e970 == _e996) {
                                        phi_1190_ = (_e974 < _e1000);
                                    } else {
                                        phi_1190_ = false;
                                    }
                                    let _e1073 = phi_1190_;
                                    phi_1191_ = _e1073;
                                }
                                let _e1075 = phi_1191_;
                                if _e1075 {
                                    phi_1195_ = _e1000;
                                    phi_1196_ = _e996;
                                    phi_1197_ = _e974;
                                    phi_1198_ = _e970;
                                } else {
                                    phi_1195_ = _e974;
                                    phi_1196_ = _e970;
                                    phi_1197_ = _e1000;
                                    phi_1198_ = _e996;
                                }
                                let _e1077 = phi_1195_;
                                let _e1079 = phi_1196_;
                                let _e1081 = phi_1197_;
                                let _e1083 = phi_1198_;
                                let _e1086 = ((_e1083 * _e1077) - (_e1081 * _e1079));
                                if _e1075 {
                                    phi_1206_ = -(_e1086);
                                } else {
                                    phi_1206_ = _e1086;
                                }
                                let _e1089 = phi_1206_;
                                if (_e1047 >= 0f) {
                                    if (_e1068 >= 0f) {
                                        if (_e1089 >= 0f) {
                                            phi_1221_ = ((_e1047 + _e1068) + _e1089);
                                            phi_1222_ = false;
                                        } else {
                                            phi_1221_ = f32();
                                            phi_1222_ = true;
                                        }
                                        let _e1096 = phi_1221_;
                                        let _e1098 = phi_1222_;
                                        phi_1223_ = _e1096;
                                        phi_1224_ = _e1098;
                                    } else {
                                        phi_1223_ = f32();
                                        phi_1224_ = true;
                                    }
                                    let _e1100 = phi_1223_;
                                    let _e1102 = phi_1224_;
                                    phi_1225_ = _e1100;
                                    phi_1226_ = _e1102;
                                } else {
                                    phi_1225_ = f32();
                                    phi_1226_ = true;
                                }
                                let _e1104 = phi_1225_;
                                let _e1106 = phi_1226_;
                                if _e1106 {
                                    if (_e1047 <= 0f) {
                                        if (_e1068 <= 0f) {
                                            let _e1109 = (_e1089 <= 0f);
                                            if _e1109 {
                                            }
                                            phi_1244_ = ((_e1047 + _e1068) + _e1089);
                                            phi_1245_ = false;
                                            phi_1246_ = _e1109;
                                        } else {
                                            phi_1244_ = f32();
                                            phi_1245_ = true;
                                            phi_1246_ = false;
                                        }
                                        let _e1113 = phi_1244_;
                                        let _e1115 = phi_1245_;
                                        let _e1117 = phi_1246_;
                                        phi_1247_ = _e1113;
                                        phi_1248_ = _e1115;
                                        phi_1249_ = _e1117;
                                    } else {
                                        phi_1247_ = f32();
                                        phi_1248_ = true;
                                        phi_1249_ = false;
                                    }
                                    let _e1119 = phi_1247_;
                                    let _e1121 = phi_1248_;
                                    let _e1123 = phi_1249_;
                                    if _e1121 {
                                        phi_1253_ = false;
                                    } else {
                                        phi_1253_ = _e1123;
                                    }
                                    let _e1125 = phi_1253_;
                                    phi_1254_ = _e1119;
                                    phi_1255_ = _e1125;
                                } else {
                                    phi_1254_ = _e1104;
                                    phi_1255_ = true;
                                }
                                let _e1127 = phi_1254_;
                                let _e1129 = phi_1255_;
                                if _e1129 {
                                    let _e1130 = (_e1127 == 0f);
                                    if _e1130 {
                                        phi_1571_ = lt_bvh_triangle_Intersection();
                                        phi_1572_ = false;
                                    } else {
                                        let _e1132 = triangles.member[(0u + _e943)].v0_;
                                        let _e1134 = (_e1132.x - _e105);
                                        let _e1136 = (_e1132.y - _e107);
                                        let _e1138 = (_e1132.z - _e109);
                                        if (_e333 == 0u) {
                                            phi_1284_ = vec3<f32>(_e1136, _e1138, _e1134);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1283_ = vec3<f32>(_e1138, _e1134, _e1136);
                                            } else {
                                                phi_1283_ = (_e1132 - vec3<f32>(_e105, _e107, _e109));
                                            }
                                            let _e1146 = phi_1283_;
                                            phi_1284_ = _e1146;
                                        }
                                        let _e1148 = phi_1284_;
                                        let _e1150 = triangles.member[(0u + _e943)].v1_;
                                        let _e1152 = triangles.member[(0u + _e943)].v0_;
                                        let _e1155 = (_e1150.x - _e1152.x);
                                        let _e1158 = (_e1150.y - _e1152.y);
                                        let _e1161 = (_e1150.z - _e1152.z);
                                        if (_e333 == 0u) {
                                            phi_1310_ = vec3<f32>(_e1158, _e1161, _e1155);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1309_ = vec3<f32>(_e1161, _e1155, _e1158);
                                            } else {
                                                phi_1309_ = (_e1150 - _e1152);
                                            }
                                            let _e1168 = phi_1309_;
                                            phi_1310_ = _e1168;
                                        }
                                        let _e1170 = phi_1310_;
                                        let _e1172 = triangles.member[(0u + _e943)].v2_;
                                        let _e1174 = triangles.member[(0u + _e943)].v0_;
                                        let _e1177 = (_e1172.x - _e1174.x);
                                        let _e1180 = (_e1172.y - _e1174.y);
                                        let _e1183 = (_e1172.z - _e1174.z);
                                        if (_e333 == 0u) {
                                            phi_1336_ = vec3<f32>(_e1180, _e1183, _e1177);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1335_ = vec3<f32>(_e1183, _e1177, _e1180);
                                            } else {
                                                phi_1335_ = (_e1172 - _e1174);
                                            }
                                            let _e1190 = phi_1335_;
                                            phi_1336_ = _e1190;
                                        }
                                        let _e1192 = phi_1336_;
                                        let _e1199 = ((_e1170.y * _e1192.z) - (_e1170.z * _e1192.y));
                                        let _e1206 = ((_e1170.z * _e1192.x) - (_e1170.x * _e1192.z));
                                        let _e1213 = ((_e1170.x * _e1192.y) - (_e1170.y * _e1192.x));
                                        let _e1227 = (((1f / _e341.z) * (((_e1199 * _e1148.x) + (_e1206 * _e1148.y)) + (_e1213 * _e1148.z))) / (((_e1199 * _e344) + (_e1206 * _e347)) + _e1213));
                                        if (_e1227 > 0f) {
                                            if (_e1227 < _e113) {
                                                let _e1231 = triangles.member[(0u + _e943)].v0_;
                                                let _e1233 = triangles.member[(0u + _e943)].v1_;
                                                if (_e1231.x < _e1233.x) {
                                                    phi_1392_ = _e1231.x;
                                                } else {
                                                    phi_1392_ = _e1233.x;
                                                }
                                                let _e1240 = phi_1392_;
                                                if (_e1231.y < _e1233.y) {
                                                    phi_1401_ = _e1231.y;
                                                } else {
                                                    phi_1401_ = _e1233.y;
                                                }
                                                let _e1247 = phi_1401_;
                                                if (_e1231.z < _e1233.z) {
                                                    phi_1410_ = _e1231.z;
                                                } else {
                                                    phi_1410_ = _e1233.z;
                                                }
                                                let _e1254 = phi_1410_;
                                                let _e1256 = triangles.member[(0u + _e943)].v2_;
                                                if (_e1240 < _e1256.x) {
                                                    phi_1419_ = _e1240;
                                                } else {
                                                    phi_1419_ = _e1256.x;
                                                }
                                                let _e1261 = phi_1419_;
                                                if (_e1247 < _e1256.y) {
                                                    phi_1426_ = _e1247;
                                                } else {
                                                    phi_1426_ = _e1256.y;
                                                }
                                                let _e1266 = phi_1426_;
                                                if (_e1254 < _e1256.z) {
                                                    phi_1433_ = _e1254;
                                                } else {
                                                    phi_1433_ = _e1256.z;
                                                }
                                                let _e1271 = phi_1433_;
                                                let _e1273 = triangles.member[(0u + _e943)].v0_;
                                                let _e1275 = triangles.member[(0u + _e943)].v1_;
                                                if (_e1273.x > _e1275.x) {
                                                    phi_1446_ = _e1273.x;
                                                } else {
                                                    phi_1446_ = _e1275.x;
                                                }
                                                let _e1282 = phi_1446_;
                                                if (_e1273.y > _e1275.y) {
                                                    phi_1455_ = _e1273.y;
                                                } else {
                                                    phi_1455_ = _e1275.y;
                                                }
                                                let _e1289 = phi_1455_;
                                                if (_e1273.z > _e1275.z) {
                                                    phi_1464_ = _e1273.z;
                                                } else {
                                                    phi_1464_ = _e1275.z;
                                                }
                                                let _e1296 = phi_1464_;
                                                let _e1298 = triangles.member[(0u + _e943)].v2_;
                                                if (_e1282 > _e1298.x) {
                                                    phi_1473_ = _e1282;
                                                } else {
                                                    phi_1473_ = _e1298.x;
                                                }
                                                let _e1303 = phi_1473_;
                                                if (_e1289 > _e1298.y) {
                                                    phi_1480_ = _e1289;
                                                } else {
                                                    phi_1480_ = _e1298.y;
                                                }
                                                let _e1308 = phi_1480_;
                                                if (_e1296 > _e1298.z) {
                                                    phi_1487_ = _e1296;
                                                } else {
                                                    phi_1487_ = _e1298.z;
                                                }
                                                let _e1313 = phi_1487_;
                                                let _e1317 = ((_e1261 - _e105) * _e262);
                                                let _e1318 = ((_e1266 - _e107) * _e272);
                                                let _e1319 = ((_e1271 - _e109) * _e282);
                                                let _e1323 = ((_e1303 - _e105) * _e262);
                                                let _e1324 = ((_e1308 - _e107) * _e272);
                                                let _e1325 = ((_e1313 - _e109) * _e282);
                                                if (_e1317 < _e1323) {
                                                    phi_1504_ = _e1317;
                                                } else {
                                                    phi_1504_ = _e1323;
                                                }
                                                let _e1328 = phi_1504_;
                                                if (_e1318 < _e1324) {
                                                    phi_1509_ = _e1318;
                                                } else {
                                                    phi_1509_ = _e1324;
                                                }
                                                let _e1331 = phi_1509_;
                                                if (_e1319 < _e1325) {
                                                    phi_1514_ = _e1319;
                                                } else {
                                                    phi_1514_ = _e1325;
                                                }
                                                let _e1334 = phi_1514_;
                                                if (_e1317 > _e1323) {
                                                    phi_1522_ = _e1317;
                                                } else {
                                                    phi_1522_ = _e1323;
                                                }
                                                let _e1340 = phi_1522_;
                                                if (_e1318 > _e1324) {
                                                    phi_1527_ = _e1318;
                                                } else {
                                                    phi_1527_ = _e1324;
                                                }
                                                let _e1343 = phi_1527_;
                                                if (_e1319 > _e1325) {
                                                    phi_1532_ = _e1319;
                                                } else {
                                                    phi_1532_ = _e1325;
                                                }
                                                let _e1346 = phi_1532_;
                                                let _e1350 = core_intrinsics_maximum_number_nsz_f32_((_e1328 - _e317), (_e1331 - _e318));
                                                let _e1351 = core_intrinsics_maximum_number_nsz_f32_(_e1350, (_e1334 - _e319));
                                                let _e1352 = core_intrinsics_minimum_number_nsz_f32_((_e1340 + _e317), (_e1343 + _e318));
                                                let _e1353 = core_intrinsics_minimum_number_nsz_f32_(_e1352, (_e1346 + _e319));
                                                if (_e1351 > -300000000000000000000000000000000000000f) {
                                                    phi_1544_ = _e1351;
                                                } else {
                                                    phi_1544_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1356 = phi_1544_;
                                                if (_e1353 < 300000000000000000000000000000000000000f) {
                                                    phi_1549_ = _e1353;
                                                } else {
                                                    phi_1549_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1359 = phi_1549_;
                                                if (_e1227 < _e1356) {
                                                    phi_1554_ = _e1356;
                                                } else {
                                                    phi_1554_ = _e1227;
                                                }
                                                let _e1362 = phi_1554_;
                                                if (_e1362 > _e1359) {
                                                    phi_1559_ = _e1359;
                                                } else {
                                                    phi_1559_ = _e1362;
                                                }
                                                let _e1365 = phi_1559_;
                                                phi_1564_ = lt_bvh_triangle_Intersection(_e1365, (_e1068 / _e1127), (_e1089 / _e1127), (_e1356 <= _e1359));
                                                phi_1565_ = false;
                                            } else {
                                                phi_1564_ = lt_bvh_triangle_Intersection();
                                                phi_1565_ = true;
                                            }
                                            let _e1371 = phi_1564_;
                                            let _e1373 = phi_1565_;
                                            phi_1566_ = _e1371;
                                            phi_1567_ = _e1373;
                                        } else {
                                            phi_1566_ = lt_bvh_triangle_Intersection();
                                            phi_1567_ = true;
                                        }
                                        let _e1375 = phi_1566_;
                                        let _e1377 = phi_1567_;
                                        if _e1377 {
                                        }
                                        phi_1571_ = _e1375;
                                        phi_1572_ = _e1377;
                                    }
                                    let _e1379 = phi_1571_;
                                    let _e1381 = phi_1572_;
                                    phi_1573_ = _e1379;
                                    phi_1574_ = _e1130;
                                    phi_1575_ = _e1381;
                                } else {
                                    phi_1573_ = lt_bvh_triangle_Intersection();
                                    phi_1574_ = true;
                                    phi_1575_ = false;
                                }
                                let _e1383 = phi_1573_;
                                let _e1385 = phi_1574_;
                                let _e1387 = phi_1575_;
                                if _e1385 {
                                    phi_1579_ = true;
                                } else {
                                    phi_1579_ = _e1387;
                                }
                                let _e1389 = phi_1579_;
                                if _e1389 {
                                    phi_1583_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1583_ = _e1383;
                                }
                                let _e1391 = phi_1583_;
                                if _e1391.is_hit {
                                    if (_e1391.t > 0f) {
                                        if (_e1391.t < _e113) {
                                            let _e1398 = triangles.member[(0u + _e943)].i0_;
                                            let _e1400 = ((_e1398 & 2147483648u) == 0u);
                                            if _e1400 {
                                                phi_1609_ = false;
                                                phi_1610_ = false;
                                            } else {
                                                if true {
                                                    phi_1608_ = false;
                                                } else {
                                                    phi_1608_ = true;
                                                }
                                                let _e1402 = phi_1608_;
                                                phi_1609_ = _e1402;
                                                phi_1610_ = true;
                                            }
                                            let _e1404 = phi_1609_;
                                            let _e1406 = phi_1610_;
                                            phi_1611_ = _e1404;
                                            phi_1612_ = _e1400;
                                            phi_1613_ = _e1406;
                                        } else {
                                            phi_1611_ = true;
                                            phi_1612_ = false;
                                            phi_1613_ = false;
                                        }
                                        let _e1408 = phi_1611_;
                                        let _e1410 = phi_1612_;
                                        let _e1412 = phi_1613_;
                                        phi_1614_ = _e1408;
                                        phi_1615_ = _e1410;
                                        phi_1616_ = _e1412;
                                    } else {
                                        phi_1614_ = true;
                                        phi_1615_ = false;
                                        phi_1616_ = false;
                                    }
                                    let _e1414 = phi_1614_;
                                    let _e1416 = phi_1615_;
                                    let _e1418 = phi_1616_;
                                    phi_1617_ = _e1414;
                                    phi_1618_ = _e1416;
                                    phi_1619_ = _e1418;
                                } else {
                                    phi_1617_ = true;
                                    phi_1618_ = false;
                                    phi_1619_ = false;
                                }
                                let _e1420 = phi_1617_;
                                let _e1422 = phi_1618_;
                                let _e1424 = phi_1619_;
                                if _e1420 {
                                    phi_1623_ = false;
                                    phi_1624_ = false;
                                } else {
                                    phi_1623_ = _e1422;
                                    phi_1624_ = _e1424;
                                }
                                let _e1426 = phi_1623_;
                                let _e1428 = phi_1624_;
                                phi_1015_ = (_e934 & (_e934 - 1u));
                                phi_1625_ = _e1420;
                                phi_1626_ = _e1426;
                                phi_1627_ = _e1428;
                            }
                            let _e1430 = phi_1015_;
                            let _e1432 = phi_1625_;
                            let _e1434 = phi_1626_;
                            let _e1436 = phi_1627_;
                            local_6 = _e1434;
                            local_7 = _e1436;
                            continue;
                            continuing {
                                phi_1014_ = _e1430;
                                break if !(_e1432);
                            }
                        }
                        let _e1439 = local_4;
                        if _e1439 {
                            let _e1441 = local.group_mask;
                            if ((_e1441 & 4278190080u) == 0u) {
                                let _e1445 = local.len;
                                if (_e1445 == 0u) {
                                    phi_1669_ = false;
                                } else {
                                    let _e1449 = local.len;
                                    local.len = (_e1449 - 1u);
                                    let _e1452 = local.len;
                                    if (_e1452 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1457 = local.first[(0u + _e1452)];
                                    local.group = _e1457;
                                    let _e1460 = local.len;
                                    if (_e1460 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1465 = local.mask[(0u + _e1460)];
                                    local.group_mask = _e1465;
                                    phi_1669_ = true;
                                }
                                let _e1468 = phi_1669_;
                                phi_1670_ = _e1468;
                            } else {
                                phi_1670_ = true;
                            }
                            let _e1470 = phi_1670_;
                            if _e1470 {
                                let _e1472 = local.group_mask;
                                let _e1478 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1472)), 32u, (_e1472 == 0u)));
                                let _e1482 = local.group_mask;
                                let _e1496 = local.group_mask;
                                local.group_mask = (_e1496 & ~((1u << bitcast<u32>((_e1478 & 31u)))));
                                let _e1499 = local.group;
                                phi_1701_ = (_e1499 + countOneBits(((_e1482 & ~((4294967295u << bitcast<u32>((((_e1478 - 24u) ^ _e360) & 31u))))) & 255u)));
                            } else {
                                phi_1701_ = 4294967295u;
                            }
                            let _e1502 = phi_1701_;
                            phi_1702_ = _e1502;
                            phi_1703_ = false;
                            phi_1704_ = false;
                        } else {
                            phi_1702_ = u32();
                            let _e1743 = local_6;
                            phi_1703_ = _e1743;
                            let _e1746 = local_7;
                            phi_1704_ = _e1746;
                        }
                        let _e1504 = phi_1702_;
                        let _e1506 = phi_1703_;
                        let _e1508 = phi_1704_;
                        phi_685_ = _e1504;
                        let _e1750 = local_8;
                        phi_1705_ = _e1750;
                        phi_1706_ = false;
                        phi_1707_ = _e1506;
                        phi_1708_ = _e1508;
                    } else {
                        phi_685_ = u32();
                        phi_1705_ = false;
                        phi_1706_ = true;
                        phi_1707_ = false;
                        phi_1708_ = false;
                    }
                    let _e1510 = phi_685_;
                    let _e1512 = phi_1705_;
                    let _e1514 = phi_1706_;
                    let _e1516 = phi_1707_;
                    let _e1518 = phi_1708_;
                    local_5 = _e1514;
                    local_9 = _e1516;
                    local_10 = _e1518;
                    continue;
                    continuing {
                        phi_684_ = _e1510;
                        break if !(_e1512);
                    }
                }
                let _e1521 = local_5;
                if _e1521 {
                    phi_1712_ = false;
                    phi_1713_ = false;
                } else {
                    let _e1757 = local_9;
                    phi_1712_ = _e1757;
                    let _e1760 = local_10;
                    phi_1713_ = _e1760;
                }
                let _e1523 = phi_1712_;
                let _e1525 = phi_1713_;
                if _e1523 {
                    phi_1717_ = true;
                } else {
                    phi_1717_ = _e1525;
                }
                let _e1527 = phi_1717_;
                if _e1527 {
                    phi_1721_ = true;
                } else {
                    phi_1721_ = false;
                }
                let _e1529 = phi_1721_;
                phi_1722_ = _e1529;
            }
            let _e1531 = phi_1722_;
            phi_1723_ = _e1531;
            phi_1724_ = _e186;
        } else {
            phi_1723_ = bool();
            phi_1724_ = true;
        }
        let _e1533 = phi_1723_;
        let _e1535 = phi_1724_;
        if _e1535 {
            phi_1728_ = false;
        } else {
            phi_1728_ = _e1533;
        }
        let _e1537 = phi_1728_;
        if _e1537 {
            phi_1732_ = 0f;
        } else {
            phi_1732_ = 1f;
        }
        let _e1539 = phi_1732_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        visibility.member[(0u + _e84)] = _e1539;
        if (_e84 < _e71) {
        } else {
            return;
        }
        let _e1546 = bits.member[(0u + _e84)];
        if ((_e1546 & 2u) == 0u) {
            phi_1753_ = (_e1546 & 1u);
        } else {
            phi_1753_ = (_e1546 & 7u);
        }
        let _e1552 = phi_1753_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        let _e1556 = visibility.member[(0u + _e84)];
        if ((_e1552 & 1u) != 0u) {
            phi_1768_ = (2u | 1u);
        } else {
            phi_1768_ = 2u;
        }
        let _e1562 = phi_1768_;
        if (_e1556 < 0.5f) {
            phi_1773_ = (_e1562 | 4u);
        } else {
            phi_1773_ = _e1562;
        }
        let _e1565 = phi_1773_;
        if (_e84 < _e71) {
        } else {
            return;
        }
        bits.member[(0u + _e84)] = _e1565;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
