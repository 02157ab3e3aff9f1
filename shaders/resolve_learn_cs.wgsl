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
    var phi_148_: bool;
    var phi_152_: f32;

    if (param != param) {
        phi_148_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_148_ = _e54;
    }
    let _e56 = phi_148_;
    if _e56 {
        phi_152_ = param_1;
    } else {
        phi_152_ = param;
    }
    let _e58 = phi_152_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_164_: bool;
    var phi_168_: f32;

    if (param_2 != param_2) {
        phi_164_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_164_ = _e54;
    }
    let _e56 = phi_164_;
    if _e56 {
        phi_168_ = param_3;
    } else {
        phi_168_ = param_2;
    }
    let _e58 = phi_168_;
    return _e58;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_244_: f32;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_305_: bool;
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
    var phi_326_: bool;
    var phi_330_: bool;
    var phi_400_: f32;
    var phi_407_: f32;
    var phi_414_: f32;
    var phi_421_: f32;
    var phi_428_: f32;
    var phi_435_: f32;
    var phi_452_: f32;
    var phi_457_: f32;
    var phi_462_: f32;
    var phi_490_: bool;
    var phi_491_: bool;
    var phi_499_: u32;
    var phi_500_: u32;
    var phi_511_: vec3<f32>;
    var phi_512_: vec3<f32>;
    var phi_525_: u32;
    var phi_530_: u32;
    var phi_535_: u32;
    var phi_649_: bool;
    var phi_650_: bool;
    var phi_681_: u32;
    var phi_683_: u32;
    var phi_764_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_791_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_818_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_824_: u32;
    var phi_827_: u32;
    var phi_841_: u32;
    var phi_851_: u32;
    var phi_861_: u32;
    var phi_879_: u32;
    var phi_889_: u32;
    var phi_899_: u32;
    var phi_935_: u32;
    var phi_948_: u32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_825_: u32;
    var phi_828_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1013_: u32;
    var phi_1058_: vec3<f32>;
    var phi_1059_: vec3<f32>;
    var phi_1088_: vec3<f32>;
    var phi_1089_: vec3<f32>;
    var phi_1118_: vec3<f32>;
    var phi_1119_: vec3<f32>;
    var phi_1137_: bool;
    var phi_1138_: bool;
    var phi_1142_: f32;
    var phi_1143_: f32;
    var phi_1144_: f32;
    var phi_1145_: f32;
    var phi_1153_: f32;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1168_: f32;
    var phi_1169_: f32;
    var phi_1170_: f32;
    var phi_1171_: f32;
    var phi_1179_: f32;
    var phi_1189_: bool;
    var phi_1190_: bool;
    var phi_1194_: f32;
    var phi_1195_: f32;
    var phi_1196_: f32;
    var phi_1197_: f32;
    var phi_1205_: f32;
    var phi_1220_: f32;
    var phi_1221_: bool;
    var phi_1222_: f32;
    var phi_1223_: bool;
    var phi_1224_: f32;
    var phi_1225_: bool;
    var phi_1243_: f32;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1246_: f32;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1252_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1282_: vec3<f32>;
    var phi_1283_: vec3<f32>;
    var phi_1308_: vec3<f32>;
    var phi_1309_: vec3<f32>;
    var phi_1334_: vec3<f32>;
    var phi_1335_: vec3<f32>;
    var phi_1391_: f32;
    var phi_1400_: f32;
    var phi_1409_: f32;
    var phi_1418_: f32;
    var phi_1425_: f32;
    var phi_1432_: f32;
    var phi_1445_: f32;
    var phi_1454_: f32;
    var phi_1463_: f32;
    var phi_1472_: f32;
    var phi_1479_: f32;
    var phi_1486_: f32;
    var phi_1503_: f32;
    var phi_1508_: f32;
    var phi_1513_: f32;
    var phi_1521_: f32;
    var phi_1526_: f32;
    var phi_1531_: f32;
    var phi_1543_: f32;
    var phi_1548_: f32;
    var phi_1553_: f32;
    var phi_1558_: f32;
    var phi_1563_: lt_bvh_triangle_Intersection;
    var phi_1564_: bool;
    var phi_1565_: lt_bvh_triangle_Intersection;
    var phi_1566_: bool;
    var phi_1570_: lt_bvh_triangle_Intersection;
    var phi_1571_: bool;
    var phi_1572_: lt_bvh_triangle_Intersection;
    var phi_1573_: bool;
    var phi_1574_: bool;
    var phi_1578_: bool;
    var phi_1582_: lt_bvh_triangle_Intersection;
    var phi_1607_: bool;
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
    var phi_1622_: bool;
    var phi_1623_: bool;
    var phi_1014_: u32;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var local_4: bool;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1700_: u32;
    var phi_1701_: u32;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_684_: u32;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var local_5: bool;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1716_: bool;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1722_: bool;
    var phi_1723_: bool;
    var phi_1727_: bool;
    var phi_1731_: f32;
    var phi_1752_: u32;
    var phi_1767_: u32;
    var phi_1772_: u32;
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
            phi_244_ = 300000000000000000000000000000000000000f;
        } else {
            phi_244_ = 1f;
        }
        let _e113 = phi_244_;
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
                                    phi_300_ = bool();
                                    phi_301_ = true;
                                } else {
                                    let _e138 = (_e129 > 0f);
                                    if _e138 {
                                        phi_299_ = bool();
                                    } else {
                                        phi_299_ = (_e130 > 0f);
                                    }
                                    let _e141 = phi_299_;
                                    phi_300_ = _e141;
                                    phi_301_ = _e138;
                                }
                                let _e143 = phi_300_;
                                let _e145 = phi_301_;
                                if _e145 {
                                    phi_305_ = true;
                                } else {
                                    phi_305_ = _e143;
                                }
                                let _e147 = phi_305_;
                                phi_306_ = _e147;
                                phi_307_ = false;
                            } else {
                                phi_306_ = bool();
                                phi_307_ = true;
                            }
                            let _e149 = phi_306_;
                            let _e151 = phi_307_;
                            phi_308_ = _e149;
                            phi_309_ = false;
                            phi_310_ = _e151;
                        } else {
                            phi_308_ = bool();
                            phi_309_ = true;
                            phi_310_ = false;
                        }
                        let _e153 = phi_308_;
                        let _e155 = phi_309_;
                        let _e157 = phi_310_;
                        phi_311_ = _e153;
                        phi_312_ = _e155;
                        phi_313_ = _e157;
                    } else {
                        phi_311_ = bool();
                        phi_312_ = true;
                        phi_313_ = false;
                    }
                    let _e159 = phi_311_;
                    let _e161 = phi_312_;
                    let _e163 = phi_313_;
                    phi_314_ = _e159;
                    phi_315_ = _e161;
                    phi_316_ = _e163;
                } else {
                    phi_314_ = bool();
                    phi_315_ = true;
                    phi_316_ = false;
                }
                let _e165 = phi_314_;
                let _e167 = phi_315_;
                let _e169 = phi_316_;
                phi_317_ = _e165;
                phi_318_ = _e167;
                phi_319_ = _e169;
            } else {
                phi_317_ = bool();
                phi_318_ = true;
                phi_319_ = false;
            }
            let _e171 = phi_317_;
            let _e173 = phi_318_;
            let _e175 = phi_319_;
            phi_320_ = _e171;
            phi_321_ = _e173;
            phi_322_ = _e175;
        } else {
            phi_320_ = bool();
            phi_321_ = true;
            phi_322_ = false;
        }
        let _e177 = phi_320_;
        let _e179 = phi_321_;
        let _e181 = phi_322_;
        if _e179 {
            phi_326_ = true;
        } else {
            phi_326_ = _e181;
        }
        let _e183 = phi_326_;
        if _e183 {
            phi_330_ = false;
        } else {
            phi_330_ = _e177;
        }
        let _e185 = phi_330_;
        if _e185 {
            let _e186 = (0u >= _e59);
            if _e186 {
                phi_1721_ = bool();
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
                    phi_400_ = _e252;
                } else {
                    phi_400_ = abs(_e121);
                }
                let _e257 = phi_400_;
                if (_e121 < 0f) {
                    phi_407_ = (-1f / _e257);
                } else {
                    phi_407_ = (1f / _e257);
                }
                let _e262 = phi_407_;
                if (abs(_e122) < _e252) {
                    phi_414_ = _e252;
                } else {
                    phi_414_ = abs(_e122);
                }
                let _e267 = phi_414_;
                if (_e122 < 0f) {
                    phi_421_ = (-1f / _e267);
                } else {
                    phi_421_ = (1f / _e267);
                }
                let _e272 = phi_421_;
                if (abs(_e123) < _e252) {
                    phi_428_ = _e252;
                } else {
                    phi_428_ = abs(_e123);
                }
                let _e277 = phi_428_;
                if (_e123 < 0f) {
                    phi_435_ = (-1f / _e277);
                } else {
                    phi_435_ = (1f / _e277);
                }
                let _e282 = phi_435_;
                let _e286 = abs((bitcast<f32>(_e192) - _e105));
                let _e287 = abs((bitcast<f32>(_e196) - _e107));
                let _e288 = abs((bitcast<f32>(_e200) - _e109));
                let _e292 = abs(((bitcast<f32>(_e204) + (bitcast<f32>((((_e216 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105));
                let _e293 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e216 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e294 = abs(((bitcast<f32>(_e212) + (bitcast<f32>((((_e216 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                if (_e286 > _e292) {
                    phi_452_ = _e286;
                } else {
                    phi_452_ = _e292;
                }
                let _e297 = phi_452_;
                if (_e287 > _e293) {
                    phi_457_ = _e287;
                } else {
                    phi_457_ = _e293;
                }
                let _e300 = phi_457_;
                if (_e288 > _e294) {
                    phi_462_ = _e288;
                } else {
                    phi_462_ = _e294;
                }
                let _e303 = phi_462_;
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
                        phi_490_ = false;
                    } else {
                        phi_490_ = true;
                    }
                    let _e326 = phi_490_;
                    phi_491_ = _e326;
                } else {
                    phi_491_ = true;
                }
                let _e328 = phi_491_;
                if _e328 {
                    if (_e321 >= _e322) {
                        phi_499_ = 1u;
                    } else {
                        phi_499_ = 2u;
                    }
                    let _e331 = phi_499_;
                    phi_500_ = _e331;
                } else {
                    phi_500_ = 0u;
                }
                let _e333 = phi_500_;
                if (_e333 == 0u) {
                    phi_512_ = vec3<f32>(_e122, _e123, _e121);
                } else {
                    if (_e333 == 1u) {
                        phi_511_ = vec3<f32>(_e123, _e121, _e122);
                    } else {
                        phi_511_ = vec3<f32>(_e121, _e122, _e123);
                    }
                    let _e339 = phi_511_;
                    phi_512_ = _e339;
                }
                let _e341 = phi_512_;
                let _e344 = (_e341.x / _e341.z);
                let _e347 = (_e341.y / _e341.z);
                if (_e262 < 0f) {
                    phi_525_ = 0u;
                } else {
                    phi_525_ = 1u;
                }
                let _e352 = phi_525_;
                if (_e272 < 0f) {
                    phi_530_ = 0u;
                } else {
                    phi_530_ = 2u;
                }
                let _e355 = phi_530_;
                if (_e282 < 0f) {
                    phi_535_ = 0u;
                } else {
                    phi_535_ = 4u;
                }
                let _e358 = phi_535_;
                let _e360 = ((_e352 | _e355) | _e358);
                let _e361 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e361.first[0], _e361.first[1], _e361.first[2], _e361.first[3], _e361.first[4], _e361.first[5], _e361.first[6], _e361.first[7], _e361.first[8], _e361.first[9], _e361.first[10], _e361.first[11], _e361.first[12], _e361.first[13], _e361.first[14], _e361.first[15], _e361.first[16], _e361.first[17], _e361.first[18], _e361.first[19], _e361.first[20], _e361.first[21], _e361.first[22], _e361.first[23], _e361.first[24], _e361.first[25], _e361.first[26], _e361.first[27], _e361.first[28], _e361.first[29], _e361.first[30], _e361.first[31]), array<u32, 32>(_e361.mask[0], _e361.mask[1], _e361.mask[2], _e361.mask[3], _e361.mask[4], _e361.mask[5], _e361.mask[6], _e361.mask[7], _e361.mask[8], _e361.mask[9], _e361.mask[10], _e361.mask[11], _e361.mask[12], _e361.mask[13], _e361.mask[14], _e361.mask[15], _e361.mask[16], _e361.mask[17], _e361.mask[18], _e361.mask[19], _e361.mask[20], _e361.mask[21], _e361.mask[22], _e361.mask[23], _e361.mask[24], _e361.mask[25], _e361.mask[26], _e361.mask[27], _e361.mask[28], _e361.mask[29], _e361.mask[30], _e361.mask[31]), _e361.len, _e361.group, _e361.group_mask);
                let _e435 = local.group_mask;
                if ((_e435 & 4278190080u) == 0u) {
                    let _e439 = local.len;
                    if (_e439 == 0u) {
                        phi_649_ = false;
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
                        phi_649_ = true;
                    }
                    let _e462 = phi_649_;
                    phi_650_ = _e462;
                } else {
                    phi_650_ = true;
                }
                let _e464 = phi_650_;
                if _e464 {
                    let _e466 = local.group_mask;
                    let _e472 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e466)), 32u, (_e466 == 0u)));
                    let _e476 = local.group_mask;
                    let _e490 = local.group_mask;
                    local.group_mask = (_e490 & ~((1u << bitcast<u32>((_e472 & 31u)))));
                    let _e493 = local.group;
                    phi_681_ = (_e493 + countOneBits(((_e476 & ~((4294967295u << bitcast<u32>((((_e472 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_681_ = 4294967295u;
                }
                let _e496 = phi_681_;
                phi_683_ = _e496;
                loop {
                    let _e498 = phi_683_;
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
                            phi_764_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e581.unnamed, lt_bvh_traverse_Tree(_e581.unnamed_1.root, _e558.y));
                        } else {
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e558.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e597.unnamed.root, _e558.y), _e597.unnamed_1);
                            let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_bvh_traverse_Tree(_e558.z, _e603.unnamed_1.first_primitive));
                            phi_764_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e609.unnamed, lt_bvh_traverse_Tree(_e609.unnamed_1.root, _e558.w));
                        }
                        let _e617 = phi_764_;
                        let _e627 = nodes.member[(0u + _e498)].y;
                        if (_e272 < 0f) {
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e627.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e638.unnamed.root, _e627.w), _e638.unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_bvh_traverse_Tree(_e627.x, _e644.unnamed_1.first_primitive));
                            phi_791_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_bvh_traverse_Tree(_e650.unnamed_1.root, _e627.y));
                        } else {
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e627.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e666.unnamed.root, _e627.y), _e666.unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e627.z, _e672.unnamed_1.first_primitive));
                            phi_791_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_bvh_traverse_Tree(_e678.unnamed_1.root, _e627.w));
                        }
                        let _e686 = phi_791_;
                        let _e696 = nodes.member[(0u + _e498)].z;
                        if (_e282 < 0f) {
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e696.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e707.unnamed.root, _e696.w), _e707.unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_bvh_traverse_Tree(_e696.x, _e713.unnamed_1.first_primitive));
                            phi_818_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_bvh_traverse_Tree(_e719.unnamed_1.root, _e696.y));
                        } else {
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e696.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e735.unnamed.root, _e696.y), _e735.unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e696.z, _e741.unnamed_1.first_primitive));
                            phi_818_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_bvh_traverse_Tree(_e747.unnamed_1.root, _e696.w));
                        }
                        let _e755 = phi_818_;
                        phi_824_ = 0u;
                        phi_827_ = 0u;
                        loop {
                            let _e765 = phi_824_;
                            let _e767 = phi_827_;
                            local_1 = _e767;
                            local_2 = _e767;
                            local_3 = _e767;
                            let _e768 = (_e765 < 8u);
                            if _e768 {
                                let _e770 = (_e765 >> bitcast<u32>(2i));
                                let _e771 = (_e765 & 3u);
                                if (_e770 == 0u) {
                                    phi_841_ = _e617.unnamed.root;
                                } else {
                                    phi_841_ = _e617.unnamed.first_primitive;
                                }
                                let _e774 = phi_841_;
                                if (_e770 == 0u) {
                                    phi_851_ = _e686.unnamed.root;
                                } else {
                                    phi_851_ = _e686.unnamed.first_primitive;
                                }
                                let _e783 = phi_851_;
                                if (_e770 == 0u) {
                                    phi_861_ = _e755.unnamed.root;
                                } else {
                                    phi_861_ = _e755.unnamed.first_primitive;
                                }
                                let _e792 = phi_861_;
                                let _e805 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e774 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e530) + (_e548 - _e310)), ((f32(((_e783 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e311)));
                                let _e806 = core_intrinsics_maximum_number_nsz_f32_(_e805, ((f32(((_e792 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e312)));
                                if (_e770 == 0u) {
                                    phi_879_ = _e617.unnamed_1.root;
                                } else {
                                    phi_879_ = _e617.unnamed_1.first_primitive;
                                }
                                let _e809 = phi_879_;
                                if (_e770 == 0u) {
                                    phi_889_ = _e686.unnamed_1.root;
                                } else {
                                    phi_889_ = _e686.unnamed_1.first_primitive;
                                }
                                let _e818 = phi_889_;
                                if (_e770 == 0u) {
                                    phi_899_ = _e755.unnamed_1.root;
                                } else {
                                    phi_899_ = _e755.unnamed_1.first_primitive;
                                }
                                let _e827 = phi_899_;
                                let _e840 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e809 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e530) + (_e548 + _e310)), ((f32(((_e818 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e311)));
                                let _e841 = core_intrinsics_minimum_number_nsz_f32_(_e840, ((f32(((_e827 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e312)));
                                if (_e806 <= _e841) {
                                    if (_e806 <= _e113) {
                                        if (_e841 >= 0f) {
                                            if (_e770 == 0u) {
                                                let _e848 = nodes.member[(0u + _e498)].links[2u];
                                                phi_935_ = _e848;
                                            } else {
                                                let _e851 = nodes.member[(0u + _e498)].links[3u];
                                                phi_935_ = _e851;
                                            }
                                            let _e853 = phi_935_;
                                            let _e858 = ((_e853 >> bitcast<u32>(((_e771 * 8u) & 31u))) & 255u);
                                            let _e859 = (_e858 & 31u);
                                            if (_e859 >= 24u) {
                                                phi_948_ = (24u + ((_e859 - 24u) ^ _e360));
                                            } else {
                                                phi_948_ = _e859;
                                            }
                                            let _e865 = phi_948_;
                                            phi_953_ = (_e767 | ((_e858 >> bitcast<u32>(5i)) << bitcast<u32>((_e865 & 31u))));
                                        } else {
                                            phi_953_ = _e767;
                                        }
                                        let _e873 = phi_953_;
                                        phi_954_ = _e873;
                                    } else {
                                        phi_954_ = _e767;
                                    }
                                    let _e875 = phi_954_;
                                    phi_955_ = _e875;
                                } else {
                                    phi_955_ = _e767;
                                }
                                let _e877 = phi_955_;
                                phi_825_ = (_e765 + 1u);
                                phi_828_ = _e877;
                            } else {
                                phi_825_ = u32();
                                phi_828_ = u32();
                            }
                            let _e880 = phi_825_;
                            let _e882 = phi_828_;
                            continue;
                            continuing {
                                phi_824_ = _e880;
                                phi_827_ = _e882;
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
                        phi_1013_ = (_e931 & 16777215u);
                        loop {
                            let _e934 = phi_1013_;
                            let _e935 = (_e934 == 0u);
                            local_4 = _e935;
                            local_8 = _e935;
                            if _e935 {
                                phi_1014_ = u32();
                                phi_1624_ = false;
                                phi_1625_ = false;
                                phi_1626_ = false;
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
                                    phi_1059_ = vec3<f32>(_e954, _e956, _e952);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1058_ = vec3<f32>(_e956, _e952, _e954);
                                    } else {
                                        phi_1058_ = (_e950 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e964 = phi_1058_;
                                    phi_1059_ = _e964;
                                }
                                let _e966 = phi_1059_;
                                let _e970 = (_e966.x - (_e344 * _e966.z));
                                let _e974 = (_e966.y - (_e347 * _e966.z));
                                let _e976 = triangles.member[(0u + _e943)].v1_;
                                let _e978 = (_e976.x - _e105);
                                let _e980 = (_e976.y - _e107);
                                let _e982 = (_e976.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1089_ = vec3<f32>(_e980, _e982, _e978);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1088_ = vec3<f32>(_e982, _e978, _e980);
                                    } else {
                                        phi_1088_ = (_e976 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e990 = phi_1088_;
                                    phi_1089_ = _e990;
                                }
                                let _e992 = phi_1089_;
                                let _e996 = (_e992.x - (_e344 * _e992.z));
                                let _e1000 = (_e992.y - (_e347 * _e992.z));
                                let _e1002 = triangles.member[(0u + _e943)].v2_;
                                let _e1004 = (_e1002.x - _e105);
                                let _e1006 = (_e1002.y - _e107);
                                let _e1008 = (_e1002.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1119_ = vec3<f32>(_e1006, _e1008, _e1004);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1118_ = vec3<f32>(_e1008, _e1004, _e1006);
                                    } else {
                                        phi_1118_ = (_e1002 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e1016 = phi_1118_;
                                    phi_1119_ = _e1016;
                                }
                                let _e1018 = phi_1119_;
                                let _e1022 = (_e1018.x - (_e344 * _e1018.z));
                                let _e1026 = (_e1018.y - (_e347 * _e1018.z));
                                if (_e996 < _e1022) {
                                    phi_1138_ = true;
                                } else {
                                    if (_e996 == _e1022) {
                                        phi_1137_ = (_e1000 < _e1026);
                                    } else {
                                        phi_1137_ = false;
                                    }
                                    let _e1031 = phi_1137_;
                                    phi_1138_ = _e1031;
                                }
                                let _e1033 = phi_1138_;
                                if _e1033 {
                                    phi_1142_ = _e1026;
                                    phi_1143_ = _e1022;
                                    phi_1144_ = _e1000;
                                    phi_1145_ = _e996;
                                } else {
                                    phi_1142_ = _e1000;
                                    phi_1143_ = _e996;
                                    phi_1144_ = _e1026;
                                    phi_1145_ = _e1022;
                                }
                                let _e1035 = phi_1142_;
                                let _e1037 = phi_1143_;
                                let _e1039 = phi_1144_;
                                let _e1041 = phi_1145_;
                                let _e1044 = ((_e1041 * _e1035) - (_e1039 * _e1037));
                                if _e1033 {
                                    phi_1153_ = -(_e1044);
                                } else {
                                    phi_1153_ = _e1044;
                                }
                                let _e1047 = phi_1153_;
                                if (_e1022 < _e970) {
                                    phi_1164_ = true;
                                } else {
                                    if (_e1022 == _e970) {
                                        phi_1163_ = (_e1026 < _e974);
                                    } else {
                                        phi_1163_ = false;
                                    }
                                    let _e1052 = phi_1163_;
                                    phi_1164_ = _e1052;
                                }
                                let _e1054 = phi_1164_;
                                if _e1054 {
                                    phi_1168_ = _e974;
                                    phi_1169_ = _e970;
                                    phi_1170_ = _e1026;
                                    phi_1171_ = _e1022;
                                } else {
                                    phi_1168_ = _e1026;
                                    phi_1169_ = _e1022;
                                    phi_1170_ = _e974;
                                    phi_1171_ = _e970;
                                }
                                let _e1056 = phi_1168_;
                                let _e1058 = phi_1169_;
                                let _e1060 = phi_1170_;
                                let _e1062 = phi_1171_;
                                let _e1065 = ((_e1062 * _e1056) - (_e1060 * _e1058));
                                if _e1054 {
                                    phi_1179_ = -(_e1065);
                                } else {
                                    phi_1179_ = _e1065;
                                }
                                let _e1068 = phi_1179_;
                                if (_e970 < _e996) {
                                    phi_1190_ = true;
                                } else {
                                    if (_e970 == _e996) {
                                        phi_1189_ = (_e974 < _e1000);
                                    } else {
                                        phi_1189_ = false;
                                    }
                                    let _e1073 = phi_1189_;
                                    phi_1190_ = _e1073;
                                }
                                let _e1075 = phi_1190_;
                                if _e1075 {
                                    phi_1194_ = _e1000;
                                    phi_1195_ = _e996;
                                    phi_1196_ = _e974;
                                    phi_1197_ = _e970;
                                } else {
                                    phi_1194_ = _e974;
                                    phi_1195_ = _e970;
                                    phi_1196_ = _e1000;
                                    phi_1197_ = _e996;
                                }
                                let _e1077 = phi_1194_;
                                let _e1079 = phi_1195_;
                                let _e1081 = phi_1196_;
                                let _e1083 = phi_1197_;
                                let _e1086 = ((_e1083 * _e1077) - (_e1081 * _e1079));
                                if _e1075 {
                                    phi_1205_ = -(_e1086);
                                } else {
                                    phi_1205_ = _e1086;
                                }
                                let _e1089 = phi_1205_;
                                if (_e1047 >= 0f) {
                                    if (_e1068 >= 0f) {
                                        if (_e1089 >= 0f) {
                                            phi_1220_ = ((_e1047 + _e1068) + _e1089);
                                            phi_1221_ = false;
                                        } else {
                                            phi_1220_ = f32();
                                            phi_1221_ = true;
                                        }
                                        let _e1096 = phi_1220_;
                                        let _e1098 = phi_1221_;
                                        phi_1222_ = _e1096;
                                        phi_1223_ = _e1098;
                                    } else {
                                        phi_1222_ = f32();
                                        phi_1223_ = true;
                                    }
                                    let _e1100 = phi_1222_;
                                    let _e1102 = phi_1223_;
                                    phi_1224_ = _e1100;
                                    phi_1225_ = _e1102;
                                } else {
                                    phi_1224_ = f32();
                                    phi_1225_ = true;
                                }
                                let _e1104 = phi_1224_;
                                let _e1106 = phi_1225_;
                                if _e1106 {
                                    if (_e1047 <= 0f) {
                                        if (_e1068 <= 0f) {
                                            let _e1109 = (_e1089 <= 0f);
                                            if _e1109 {
                                            }
                                            phi_1243_ = ((_e1047 + _e1068) + _e1089);
                                            phi_1244_ = false;
                                            phi_1245_ = _e1109;
                                        } else {
                                            phi_1243_ = f32();
                                            phi_1244_ = true;
                                            phi_1245_ = false;
                                        }
                                        let _e1113 = phi_1243_;
                                        let _e1115 = phi_1244_;
                                        let _e1117 = phi_1245_;
                                        phi_1246_ = _e1113;
                                        phi_1247_ = _e1115;
                                        phi_1248_ = _e1117;
                                    } else {
                                        phi_1246_ = f32();
                                        phi_1247_ = true;
                                        phi_1248_ = false;
                                    }
                                    let _e1119 = phi_1246_;
                                    let _e1121 = phi_1247_;
                                    let _e1123 = phi_1248_;
                                    if _e1121 {
                                        phi_1252_ = false;
                                    } else {
                                        phi_1252_ = _e1123;
                                    }
                                    let _e1125 = phi_1252_;
                                    phi_1253_ = _e1119;
                                    phi_1254_ = _e1125;
                                } else {
                                    phi_1253_ = _e1104;
                                    phi_1254_ = true;
                                }
                                let _e1127 = phi_1253_;
                                let _e1129 = phi_1254_;
                                if _e1129 {
                                    let _e1130 = (_e1127 == 0f);
                                    if _e1130 {
                                        phi_1570_ = lt_bvh_triangle_Intersection();
                                        phi_1571_ = false;
                                    } else {
                                        let _e1132 = triangles.member[(0u + _e943)].v0_;
                                        let _e1134 = (_e1132.x - _e105);
                                        let _e1136 = (_e1132.y - _e107);
                                        let _e1138 = (_e1132.z - _e109);
                                        if (_e333 == 0u) {
                                            phi_1283_ = vec3<f32>(_e1136, _e1138, _e1134);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1282_ = vec3<f32>(_e1138, _e1134, _e1136);
                                            } else {
                                                phi_1282_ = (_e1132 - vec3<f32>(_e105, _e107, _e109));
                                            }
                                            let _e1146 = phi_1282_;
                                            phi_1283_ = _e1146;
                                        }
                                        let _e1148 = phi_1283_;
                                        let _e1150 = triangles.member[(0u + _e943)].v1_;
                                        let _e1152 = triangles.member[(0u + _e943)].v0_;
                                        let _e1155 = (_e1150.x - _e1152.x);
                                        let _e1158 = (_e1150.y - _e1152.y);
                                        let _e1161 = (_e1150.z - _e1152.z);
                                        if (_e333 == 0u) {
                                            phi_1309_ = vec3<f32>(_e1158, _e1161, _e1155);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1308_ = vec3<f32>(_e1161, _e1155, _e1158);
                                            } else {
                                                phi_1308_ = (_e1150 - _e1152);
                                            }
                                            let _e1168 = phi_1308_;
                                            phi_1309_ = _e1168;
                                        }
                                        let _e1170 = phi_1309_;
                                        let _e1172 = triangles.member[(0u + _e943)].v2_;
                                        let _e1174 = triangles.member[(0u + _e943)].v0_;
                                        let _e1177 = (_e1172.x - _e1174.x);
                                        let _e1180 = (_e1172.y - _e1174.y);
                                        let _e1183 = (_e1172.z - _e1174.z);
                                        if (_e333 == 0u) {
                                            phi_1335_ = vec3<f32>(_e1180, _e1183, _e1177);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1334_ = vec3<f32>(_e1183, _e1177, _e1180);
                                            } else {
                                                phi_1334_ = (_e1172 - _e1174);
                                            }
                                            let _e1190 = phi_1334_;
                                            phi_1335_ = _e1190;
                                        }
                                        let _e1192 = phi_1335_;
                                        let _e1199 = ((_e1170.y * _e1192.z) - (_e1170.z * _e1192.y));
                                        let _e1206 = ((_e1170.z * _e1192.x) - (_e1170.x * _e1192.z));
                                        let _e1213 = ((_e1170.x * _e1192.y) - (_e1170.y * _e1192.x));
                                        let _e1227 = (((1f / _e341.z) * (((_e1199 * _e1148.x) + (_e1206 * _e1148.y)) + (_e1213 * _e1148.z))) / (((_e1199 * _e344) + (_e1206 * _e347)) + _e1213));
                                        if (_e1227 > 0f) {
                                            if (_e1227 < _e113) {
                                                let _e1231 = triangles.member[(0u + _e943)].v0_;
                                                let _e1233 = triangles.member[(0u + _e943)].v1_;
                                                if (_e1231.x < _e1233.x) {
                                                    phi_1391_ = _e1231.x;
                                                } else {
                                                    phi_1391_ = _e1233.x;
                                                }
                                                let _e1240 = phi_1391_;
                                                if (_e1231.y < _e1233.y) {
                                                    phi_1400_ = _e1231.y;
                                                } else {
                                                    phi_1400_ = _e1233.y;
                                                }
                                                let _e1247 = phi_1400_;
                                                if (_e1231.z < _e1233.z) {
                                                    phi_1409_ = _e1231.z;
                                                } else {
                                                    phi_1409_ = _e1233.z;
                                                }
                                                let _e1254 = phi_1409_;
                                                let _e1256 = triangles.member[(0u + _e943)].v2_;
                                                if (_e1240 < _e1256.x) {
                                                    phi_1418_ = _e1240;
                                                } else {
                                                    phi_1418_ = _e1256.x;
                                                }
                                                let _e1261 = phi_1418_;
                                                if (_e1247 < _e1256.y) {
                                                    phi_1425_ = _e1247;
                                                } else {
                                                    phi_1425_ = _e1256.y;
                                                }
                                                let _e1266 = phi_1425_;
                                                if (_e1254 < _e1256.z) {
                                                    phi_1432_ = _e1254;
                                                } else {
                                                    phi_1432_ = _e1256.z;
                                                }
                                                let _e1271 = phi_1432_;
                                                let _e1273 = triangles.member[(0u + _e943)].v0_;
                                                let _e1275 = triangles.member[(0u + _e943)].v1_;
                                                if (_e1273.x > _e1275.x) {
                                                    phi_1445_ = _e1273.x;
                                                } else {
                                                    phi_1445_ = _e1275.x;
                                                }
                                                let _e1282 = phi_1445_;
                                                if (_e1273.y > _e1275.y) {
                                                    phi_1454_ = _e1273.y;
                                                } else {
                                                    phi_1454_ = _e1275.y;
                                                }
                                                let _e1289 = phi_1454_;
                                                if (_e1273.z > _e1275.z) {
                                                    phi_1463_ = _e1273.z;
                                                } else {
                                                    phi_1463_ = _e1275.z;
                                                }
                                                let _e1296 = phi_1463_;
                                                let _e1298 = triangles.member[(0u + _e943)].v2_;
                                                if (_e1282 > _e1298.x) {
                                                    phi_1472_ = _e1282;
                                                } else {
                                                    phi_1472_ = _e1298.x;
                                                }
                                                let _e1303 = phi_1472_;
                                                if (_e1289 > _e1298.y) {
                                                    phi_1479_ = _e1289;
                                                } else {
                                                    phi_1479_ = _e1298.y;
                                                }
                                                let _e1308 = phi_1479_;
                                                if (_e1296 > _e1298.z) {
                                                    phi_1486_ = _e1296;
                                                } else {
                                                    phi_1486_ = _e1298.z;
                                                }
                                                let _e1313 = phi_1486_;
                                                let _e1317 = ((_e1261 - _e105) * _e262);
                                                let _e1318 = ((_e1266 - _e107) * _e272);
                                                let _e1319 = ((_e1271 - _e109) * _e282);
                                                let _e1323 = ((_e1303 - _e105) * _e262);
                                                let _e1324 = ((_e1308 - _e107) * _e272);
                                                let _e1325 = ((_e1313 - _e109) * _e282);
                                                if (_e1317 < _e1323) {
                                                    phi_1503_ = _e1317;
                                                } else {
                                                    phi_1503_ = _e1323;
                                                }
                                                let _e1328 = phi_1503_;
                                                if (_e1318 < _e1324) {
                                                    phi_1508_ = _e1318;
                                                } else {
                                                    phi_1508_ = _e1324;
                                                }
                                                let _e1331 = phi_1508_;
                                                if (_e1319 < _e1325) {
                                                    phi_1513_ = _e1319;
                                                } else {
                                                    phi_1513_ = _e1325;
                                                }
                                                let _e1334 = phi_1513_;
                                                if (_e1317 > _e1323) {
                                                    phi_1521_ = _e1317;
                                                } else {
                                                    phi_1521_ = _e1323;
                                                }
                                                let _e1340 = phi_1521_;
                                                if (_e1318 > _e1324) {
                                                    phi_1526_ = _e1318;
                                                } else {
                                                    phi_1526_ = _e1324;
                                                }
                                                let _e1343 = phi_1526_;
                                                if (_e1319 > _e1325) {
                                                    phi_1531_ = _e1319;
                                                } else {
                                                    phi_1531_ = _e1325;
                                                }
                                                let _e1346 = phi_1531_;
                                                let _e1350 = core_intrinsics_maximum_number_nsz_f32_((_e1328 - _e317), (_e1331 - _e318));
                                                let _e1351 = core_intrinsics_maximum_number_nsz_f32_(_e1350, (_e1334 - _e319));
                                                let _e1352 = core_intrinsics_minimum_number_nsz_f32_((_e1340 + _e317), (_e1343 + _e318));
                                                let _e1353 = core_intrinsics_minimum_number_nsz_f32_(_e1352, (_e1346 + _e319));
                                                if (_e1351 > -300000000000000000000000000000000000000f) {
                                                    phi_1543_ = _e1351;
                                                } else {
                                                    phi_1543_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1356 = phi_1543_;
                                                if (_e1353 < 300000000000000000000000000000000000000f) {
                                                    phi_1548_ = _e1353;
                                                } else {
                                                    phi_1548_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1359 = phi_1548_;
                                                if (_e1227 < _e1356) {
                                                    phi_1553_ = _e1356;
                                                } else {
                                                    phi_1553_ = _e1227;
                                                }
                                                let _e1362 = phi_1553_;
                                                if (_e1362 > _e1359) {
                                                    phi_1558_ = _e1359;
                                                } else {
                                                    phi_1558_ = _e1362;
                                                }
                                                let _e1365 = phi_1558_;
                                                phi_1563_ = lt_bvh_triangle_Intersection(_e1365, (_e1068 / _e1127), (_e1089 / _e1127), (_e1356 <= _e1359));
                                                phi_1564_ = false;
                                            } else {
                                                phi_1563_ = lt_bvh_triangle_Intersection();
                                                phi_1564_ = true;
                                            }
                                            let _e1371 = phi_1563_;
                                            let _e1373 = phi_1564_;
                                            phi_1565_ = _e1371;
                                            phi_1566_ = _e1373;
                                        } else {
                                            phi_1565_ = lt_bvh_triangle_Intersection();
                                            phi_1566_ = true;
                                        }
                                        let _e1375 = phi_1565_;
                                        let _e1377 = phi_1566_;
                                        if _e1377 {
                                        }
                                        phi_1570_ = _e1375;
                                        phi_1571_ = _e1377;
                                    }
                                    let _e1379 = phi_1570_;
                                    let _e1381 = phi_1571_;
                                    phi_1572_ = _e1379;
                                    phi_1573_ = _e1130;
                                    phi_1574_ = _e1381;
                                } else {
                                    phi_1572_ = lt_bvh_triangle_Intersection();
                                    phi_1573_ = true;
                                    phi_1574_ = false;
                                }
                                let _e1383 = phi_1572_;
                                let _e1385 = phi_1573_;
                                let _e1387 = phi_1574_;
                                if _e1385 {
                                    phi_1578_ = true;
                                } else {
                                    phi_1578_ = _e1387;
                                }
                                let _e1389 = phi_1578_;
                                if _e1389 {
                                    phi_1582_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1582_ = _e1383;
                                }
                                let _e1391 = phi_1582_;
                                if _e1391.is_hit {
                                    if (_e1391.t > 0f) {
                                        if (_e1391.t < _e113) {
                                            let _e1398 = triangles.member[(0u + _e943)].i0_;
                                            let _e1400 = ((_e1398 & 2147483648u) == 0u);
                                            if _e1400 {
                                                phi_1608_ = false;
                                                phi_1609_ = false;
                                            } else {
                                                if true {
                                                    phi_1607_ = false;
                                                } else {
                                                    phi_1607_ = true;
                                                }
                                                let _e1402 = phi_1607_;
                                                phi_1608_ = _e1402;
                                                phi_1609_ = true;
                                            }
                                            let _e1404 = phi_1608_;
                                            let _e1406 = phi_1609_;
                                            phi_1610_ = _e1404;
                                            phi_1611_ = _e1400;
                                            phi_1612_ = _e1406;
                                        } else {
                                            phi_1610_ = true;
                                            phi_1611_ = false;
                                            phi_1612_ = false;
                                        }
                                        let _e1408 = phi_1610_;
                                        let _e1410 = phi_1611_;
                                        let _e1412 = phi_1612_;
                                        phi_1613_ = _e1408;
                                        phi_1614_ = _e1410;
                                        phi_1615_ = _e1412;
                                    } else {
                                        phi_1613_ = true;
                                        phi_1614_ = false;
                                        phi_1615_ = false;
                                    }
                                    let _e1414 = phi_1613_;
                                    let _e1416 = phi_1614_;
                                    let _e1418 = phi_1615_;
                                    phi_1616_ = _e1414;
                                    phi_1617_ = _e1416;
                                    phi_1618_ = _e1418;
                                } else {
                                    phi_1616_ = true;
                                    phi_1617_ = false;
                                    phi_1618_ = false;
                                }
                                let _e1420 = phi_1616_;
                                let _e1422 = phi_1617_;
                                let _e1424 = phi_1618_;
                                if _e1420 {
                                    phi_1622_ = false;
                                    phi_1623_ = false;
                                } else {
                                    phi_1622_ = _e1422;
                                    phi_1623_ = _e1424;
                                }
                                let _e1426 = phi_1622_;
                                let _e1428 = phi_1623_;
                                phi_1014_ = (_e934 & (_e934 - 1u));
                                phi_1624_ = _e1420;
                                phi_1625_ = _e1426;
                                phi_1626_ = _e1428;
                            }
                            let _e1430 = phi_1014_;
                            let _e1432 = phi_1624_;
                            let _e1434 = phi_1625_;
                            let _e1436 = phi_1626_;
                            local_6 = _e1434;
                            local_7 = _e1436;
                            continue;
                            continuing {
                                phi_1013_ = _e1430;
                                break if !(_e1432);
                            }
                        }
                        let _e1439 = local_4;
                        if _e1439 {
                            let _e1441 = local.group_mask;
                            if ((_e1441 & 4278190080u) == 0u) {
                                let _e1445 = local.len;
                                if (_e1445 == 0u) {
                                    phi_1668_ = false;
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
                                    phi_1668_ = true;
                                }
                                let _e1468 = phi_1668_;
                                phi_1669_ = _e1468;
                            } else {
                                phi_1669_ = true;
                            }
                            let _e1470 = phi_1669_;
                            if _e1470 {
                                let _e1472 = local.group_mask;
                                let _e1478 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1472)), 32u, (_e1472 == 0u)));
                                let _e1482 = local.group_mask;
                                let _e1496 = local.group_mask;
                                local.group_mask = (_e1496 & ~((1u << bitcast<u32>((_e1478 & 31u)))));
                                let _e1499 = local.group;
                                phi_1700_ = (_e1499 + countOneBits(((_e1482 & ~((4294967295u << bitcast<u32>((((_e1478 - 24u) ^ _e360) & 31u))))) & 255u)));
                            } else {
                                phi_1700_ = 4294967295u;
                            }
                            let _e1502 = phi_1700_;
                            phi_1701_ = _e1502;
                            phi_1702_ = false;
                            phi_1703_ = false;
                        } else {
                            phi_1701_ = u32();
                            let _e1743 = local_6;
                            phi_1702_ = _e1743;
                            let _e1746 = local_7;
                            phi_1703_ = _e1746;
                        }
                        let _e1504 = phi_1701_;
                        let _e1506 = phi_1702_;
                        let _e1508 = phi_1703_;
                        phi_684_ = _e1504;
                        let _e1750 = local_8;
                        phi_1704_ = _e1750;
                        phi_1705_ = false;
                        phi_1706_ = _e1506;
                        phi_1707_ = _e1508;
                    } else {
                        phi_684_ = u32();
                        phi_1704_ = false;
                        phi_1705_ = true;
                        phi_1706_ = false;
                        phi_1707_ = false;
                    }
                    let _e1510 = phi_684_;
                    let _e1512 = phi_1704_;
                    let _e1514 = phi_1705_;
                    let _e1516 = phi_1706_;
                    let _e1518 = phi_1707_;
                    local_5 = _e1514;
                    local_9 = _e1516;
                    local_10 = _e1518;
                    continue;
                    continuing {
                        phi_683_ = _e1510;
                        break if !(_e1512);
                    }
                }
                let _e1521 = local_5;
                if _e1521 {
                    phi_1711_ = false;
                    phi_1712_ = false;
                } else {
                    let _e1757 = local_9;
                    phi_1711_ = _e1757;
                    let _e1760 = local_10;
                    phi_1712_ = _e1760;
                }
                let _e1523 = phi_1711_;
                let _e1525 = phi_1712_;
                if _e1523 {
                    phi_1716_ = true;
                } else {
                    phi_1716_ = _e1525;
                }
                let _e1527 = phi_1716_;
                if _e1527 {
                    phi_1720_ = true;
                } else {
                    phi_1720_ = false;
                }
                let _e1529 = phi_1720_;
                phi_1721_ = _e1529;
            }
            let _e1531 = phi_1721_;
            phi_1722_ = _e1531;
            phi_1723_ = _e186;
        } else {
            phi_1722_ = bool();
            phi_1723_ = true;
        }
        let _e1533 = phi_1722_;
        let _e1535 = phi_1723_;
        if _e1535 {
            phi_1727_ = false;
        } else {
            phi_1727_ = _e1533;
        }
        let _e1537 = phi_1727_;
        if _e1537 {
            phi_1731_ = 0f;
        } else {
            phi_1731_ = 1f;
        }
        let _e1539 = phi_1731_;
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
            phi_1752_ = (_e1546 & 1u);
        } else {
            phi_1752_ = (_e1546 & 7u);
        }
        let _e1552 = phi_1752_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        let _e1556 = visibility.member[(0u + _e84)];
        if ((_e1552 & 1u) != 0u) {
            phi_1767_ = (2u | 1u);
        } else {
            phi_1767_ = 2u;
        }
        let _e1562 = phi_1767_;
        if (_e1556 < 0.5f) {
            phi_1772_ = (_e1562 | 4u);
        } else {
            phi_1772_ = _e1562;
        }
        let _e1565 = phi_1772_;
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
