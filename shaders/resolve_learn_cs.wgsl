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

struct type_29 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_34 {
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

struct type_38 {
    member: array<lt_bvh_Triangle>,
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

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> nodes: type_34;
@group(0) @binding(3) 
var<storage> triangles: type_38;
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
    var phi_686_: bool;
    var phi_766_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_793_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_820_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_826_: u32;
    var phi_829_: u32;
    var phi_843_: u32;
    var phi_853_: u32;
    var phi_863_: u32;
    var phi_881_: u32;
    var phi_891_: u32;
    var phi_901_: u32;
    var phi_937_: u32;
    var phi_950_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_827_: u32;
    var phi_830_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1015_: u32;
    var phi_1018_: bool;
    var phi_1062_: vec3<f32>;
    var phi_1063_: vec3<f32>;
    var phi_1092_: vec3<f32>;
    var phi_1093_: vec3<f32>;
    var phi_1122_: vec3<f32>;
    var phi_1123_: vec3<f32>;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1146_: f32;
    var phi_1147_: f32;
    var phi_1148_: f32;
    var phi_1149_: f32;
    var phi_1157_: f32;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1172_: f32;
    var phi_1173_: f32;
    var phi_1174_: f32;
    var phi_1175_: f32;
    var phi_1183_: f32;
    var phi_1193_: bool;
    var phi_1194_: bool;
    var phi_1198_: f32;
    var phi_1199_: f32;
    var phi_1200_: f32;
    var phi_1201_: f32;
    var phi_1209_: f32;
    var phi_1224_: f32;
    var phi_1225_: bool;
    var phi_1226_: f32;
    var phi_1227_: bool;
    var phi_1228_: f32;
    var phi_1229_: bool;
    var phi_1247_: f32;
    var phi_1248_: bool;
    var phi_1249_: bool;
    var phi_1250_: f32;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1256_: bool;
    var phi_1257_: f32;
    var phi_1258_: bool;
    var phi_1286_: vec3<f32>;
    var phi_1287_: vec3<f32>;
    var phi_1312_: vec3<f32>;
    var phi_1313_: vec3<f32>;
    var phi_1338_: vec3<f32>;
    var phi_1339_: vec3<f32>;
    var phi_1395_: f32;
    var phi_1404_: f32;
    var phi_1413_: f32;
    var phi_1422_: f32;
    var phi_1429_: f32;
    var phi_1436_: f32;
    var phi_1449_: f32;
    var phi_1458_: f32;
    var phi_1467_: f32;
    var phi_1476_: f32;
    var phi_1483_: f32;
    var phi_1490_: f32;
    var phi_1507_: f32;
    var phi_1512_: f32;
    var phi_1517_: f32;
    var phi_1525_: f32;
    var phi_1530_: f32;
    var phi_1535_: f32;
    var phi_1547_: f32;
    var phi_1552_: f32;
    var phi_1557_: f32;
    var phi_1562_: f32;
    var phi_1567_: lt_bvh_triangle_Intersection;
    var phi_1568_: bool;
    var phi_1569_: lt_bvh_triangle_Intersection;
    var phi_1570_: bool;
    var phi_1574_: lt_bvh_triangle_Intersection;
    var phi_1575_: bool;
    var phi_1576_: lt_bvh_triangle_Intersection;
    var phi_1577_: bool;
    var phi_1578_: bool;
    var phi_1582_: bool;
    var phi_1586_: lt_bvh_triangle_Intersection;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1016_: u32;
    var phi_1019_: bool;
    var phi_1616_: bool;
    var local_4: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1690_: u32;
    var phi_1691_: u32;
    var phi_684_: u32;
    var phi_687_: bool;
    var phi_1692_: bool;
    var phi_1693_: bool;
    var local_5: bool;
    var phi_1697_: bool;
    var phi_1701_: bool;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_1708_: bool;
    var phi_1712_: f32;
    var phi_1733_: u32;
    var phi_1748_: u32;
    var phi_1753_: u32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;

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
                phi_1702_ = bool();
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
                phi_686_ = false;
                loop {
                    let _e498 = phi_683_;
                    let _e500 = phi_686_;
                    local_8 = _e500;
                    if (_e498 != 4294967295u) {
                        if (_e498 < _e59) {
                        } else {
                            return;
                        }
                        let _e507 = nodes.member[(0u + _e498)].frame[3u];
                        let _e532 = (bitcast<f32>((((_e507 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e262);
                        let _e533 = (bitcast<f32>((((_e507 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e272);
                        let _e534 = (bitcast<f32>((((_e507 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e282);
                        let _e537 = nodes.member[(0u + _e498)].frame[0u];
                        let _e541 = nodes.member[(0u + _e498)].frame[1u];
                        let _e545 = nodes.member[(0u + _e498)].frame[2u];
                        let _e550 = ((bitcast<f32>(_e537) - _e105) * _e262);
                        let _e551 = ((bitcast<f32>(_e541) - _e107) * _e272);
                        let _e552 = ((bitcast<f32>(_e545) - _e109) * _e282);
                        let _e560 = nodes.member[(0u + _e498)].x;
                        if (_e262 < 0f) {
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e571.unnamed.root, _e560.w), _e571.unnamed_1);
                            let _e583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e560.x, _e577.unnamed_1.first_primitive));
                            phi_766_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e583.unnamed, lt_bvh_traverse_Tree(_e583.unnamed_1.root, _e560.y));
                        } else {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.unnamed.root, _e560.y), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e560.z, _e605.unnamed_1.first_primitive));
                            phi_766_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_bvh_traverse_Tree(_e611.unnamed_1.root, _e560.w));
                        }
                        let _e619 = phi_766_;
                        let _e629 = nodes.member[(0u + _e498)].y;
                        if (_e272 < 0f) {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.unnamed.root, _e629.w), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e629.x, _e646.unnamed_1.first_primitive));
                            phi_793_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e652.unnamed_1.root, _e629.y));
                        } else {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.unnamed.root, _e629.y), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e629.z, _e674.unnamed_1.first_primitive));
                            phi_793_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e680.unnamed_1.root, _e629.w));
                        }
                        let _e688 = phi_793_;
                        let _e698 = nodes.member[(0u + _e498)].z;
                        if (_e282 < 0f) {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.unnamed.root, _e698.w), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e698.x, _e715.unnamed_1.first_primitive));
                            phi_820_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e721.unnamed_1.root, _e698.y));
                        } else {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e737.unnamed.root, _e698.y), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e698.z, _e743.unnamed_1.first_primitive));
                            phi_820_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e749.unnamed_1.root, _e698.w));
                        }
                        let _e757 = phi_820_;
                        phi_826_ = 0u;
                        phi_829_ = 0u;
                        loop {
                            let _e767 = phi_826_;
                            let _e769 = phi_829_;
                            local_1 = _e769;
                            local_2 = _e769;
                            local_3 = _e769;
                            let _e770 = (_e767 < 8u);
                            if _e770 {
                                let _e772 = (_e767 >> bitcast<u32>(2i));
                                let _e773 = (_e767 & 3u);
                                if (_e772 == 0u) {
                                    phi_843_ = _e619.unnamed.root;
                                } else {
                                    phi_843_ = _e619.unnamed.first_primitive;
                                }
                                let _e776 = phi_843_;
                                if (_e772 == 0u) {
                                    phi_853_ = _e688.unnamed.root;
                                } else {
                                    phi_853_ = _e688.unnamed.first_primitive;
                                }
                                let _e785 = phi_853_;
                                if (_e772 == 0u) {
                                    phi_863_ = _e757.unnamed.root;
                                } else {
                                    phi_863_ = _e757.unnamed.first_primitive;
                                }
                                let _e794 = phi_863_;
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e776 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e310)), ((f32(((_e785 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e311)));
                                let _e808 = core_intrinsics_maximum_number_nsz_f32_(_e807, ((f32(((_e794 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e312)));
                                if (_e772 == 0u) {
                                    phi_881_ = _e619.unnamed_1.root;
                                } else {
                                    phi_881_ = _e619.unnamed_1.first_primitive;
                                }
                                let _e811 = phi_881_;
                                if (_e772 == 0u) {
                                    phi_891_ = _e688.unnamed_1.root;
                                } else {
                                    phi_891_ = _e688.unnamed_1.first_primitive;
                                }
                                let _e820 = phi_891_;
                                if (_e772 == 0u) {
                                    phi_901_ = _e757.unnamed_1.root;
                                } else {
                                    phi_901_ = _e757.unnamed_1.first_primitive;
                                }
                                let _e829 = phi_901_;
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e811 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e310)), ((f32(((_e820 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e311)));
                                let _e843 = core_intrinsics_minimum_number_nsz_f32_(_e842, ((f32(((_e829 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e312)));
                                if (_e808 <= _e843) {
                                    if (_e808 <= _e113) {
                                        if (_e843 >= 0f) {
                                            if (_e772 == 0u) {
                                                let _e850 = nodes.member[(0u + _e498)].links[2u];
                                                phi_937_ = _e850;
                                            } else {
                                                let _e853 = nodes.member[(0u + _e498)].links[3u];
                                                phi_937_ = _e853;
                                            }
                                            let _e855 = phi_937_;
                                            let _e860 = ((_e855 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u);
                                            let _e861 = (_e860 & 31u);
                                            if (_e861 >= 24u) {
                                                phi_950_ = (24u + ((_e861 - 24u) ^ _e360));
                                            } else {
                                                phi_950_ = _e861;
                                            }
                                            let _e867 = phi_950_;
                                            phi_955_ = (_e769 | ((_e860 >> bitcast<u32>(5i)) << bitcast<u32>((_e867 & 31u))));
                                        } else {
                                            phi_955_ = _e769;
                                        }
                                        let _e875 = phi_955_;
                                        phi_956_ = _e875;
                                    } else {
                                        phi_956_ = _e769;
                                    }
                                    let _e877 = phi_956_;
                                    phi_957_ = _e877;
                                } else {
                                    phi_957_ = _e769;
                                }
                                let _e879 = phi_957_;
                                phi_827_ = (_e767 + 1u);
                                phi_830_ = _e879;
                            } else {
                                phi_827_ = u32();
                                phi_830_ = u32();
                            }
                            let _e882 = phi_827_;
                            let _e884 = phi_830_;
                            continue;
                            continuing {
                                phi_826_ = _e882;
                                phi_829_ = _e884;
                                break if !(_e770);
                            }
                        }
                        let _e888 = nodes.member[(0u + _e498)].links[0u];
                        let _e892 = nodes.member[(0u + _e498)].frame[3u];
                        let _e896 = local_1;
                        if ((_e896 & 4278190080u) == 0u) {
                        } else {
                            let _e900 = local.group_mask;
                            if ((_e900 & 4278190080u) == 0u) {
                            } else {
                                let _e904 = local.len;
                                if (_e904 < 32u) {
                                    let _e907 = local.group;
                                    let _e909 = local.len;
                                    if (_e909 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e909)] = _e907;
                                    let _e915 = local.group_mask;
                                    let _e917 = local.len;
                                    if (_e917 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e917)] = _e915;
                                    let _e924 = local.len;
                                    local.len = (_e924 + 1u);
                                }
                            }
                            local.group = (0u + _e888);
                            let _e928 = local_2;
                            local.group_mask = ((_e928 & 4278190080u) | (_e892 >> bitcast<u32>(24i)));
                        }
                        let _e933 = local_3;
                        phi_1015_ = (_e933 & 16777215u);
                        phi_1018_ = _e500;
                        loop {
                            let _e936 = phi_1015_;
                            let _e938 = phi_1018_;
                            local_6 = _e938;
                            let _e939 = (_e936 == 0u);
                            local_4 = _e939;
                            local_7 = _e939;
                            if _e939 {
                                phi_1016_ = u32();
                                phi_1019_ = bool();
                                phi_1616_ = false;
                            } else {
                                let _e942 = nodes.member[(0u + _e498)].links[1u];
                                let _e947 = ((0u + _e942) + select(firstTrailingBit(_e936), 32u, (_e936 == 0u)));
                                if (_e947 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e954 = triangles.member[(0u + _e947)].v0_;
                                let _e956 = (_e954.x - _e105);
                                let _e958 = (_e954.y - _e107);
                                let _e960 = (_e954.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1063_ = vec3<f32>(_e958, _e960, _e956);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1062_ = vec3<f32>(_e960, _e956, _e958);
                                    } else {
                                        phi_1062_ = (_e954 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e968 = phi_1062_;
                                    phi_1063_ = _e968;
                                }
                                let _e970 = phi_1063_;
                                let _e974 = (_e970.x - (_e344 * _e970.z));
                                let _e978 = (_e970.y - (_e347 * _e970.z));
                                let _e980 = triangles.member[(0u + _e947)].v1_;
                                let _e982 = (_e980.x - _e105);
                                let _e984 = (_e980.y - _e107);
                                let _e986 = (_e980.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1093_ = vec3<f32>(_e984, _e986, _e982);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1092_ = vec3<f32>(_e986, _e982, _e984);
                                    } else {
                                        phi_1092_ = (_e980 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e994 = phi_1092_;
                                    phi_1093_ = _e994;
                                }
                                let _e996 = phi_1093_;
                                let _e1000 = (_e996.x - (_e344 * _e996.z));
                                let _e1004 = (_e996.y - (_e347 * _e996.z));
                                let _e1006 = triangles.member[(0u + _e947)].v2_;
                                let _e1008 = (_e1006.x - _e105);
                                let _e1010 = (_e1006.y - _e107);
                                let _e1012 = (_e1006.z - _e109);
                                if (_e333 == 0u) {
                                    phi_1123_ = vec3<f32>(_e1010, _e1012, _e1008);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1122_ = vec3<f32>(_e1012, _e1008, _e1010);
                                    } else {
                                        phi_1122_ = (_e1006 - vec3<f32>(_e105, _e107, _e109));
                                    }
                                    let _e1020 = phi_1122_;
                                    phi_1123_ = _e1020;
                                }
                                let _e1022 = phi_1123_;
                                let _e1026 = (_e1022.x - (_e344 * _e1022.z));
                                let _e1030 = (_e1022.y - (_e347 * _e1022.z));
                                if (_e1000 < _e1026) {
                                    phi_1142_ = true;
                                } else {
                                    if (_e1000 == _e1026) {
                                        phi_1141_ = (_e1004 < _e1030);
                                    } else {
                                        phi_1141_ = false;
                                    }
                                    let _e1035 = phi_1141_;
                                    phi_1142_ = _e1035;
                                }
                                let _e1037 = phi_1142_;
                                if _e1037 {
                                    phi_1146_ = _e1030;
                                    phi_1147_ = _e1026;
                                    phi_1148_ = _e1004;
                                    phi_1149_ = _e1000;
                                } else {
                                    phi_1146_ = _e1004;
                                    phi_1147_ = _e1000;
                                    phi_1148_ = _e1030;
                                    phi_1149_ = _e1026;
                                }
                                let _e1039 = phi_1146_;
                                let _e1041 = phi_1147_;
                                let _e1043 = phi_1148_;
                                let _e1045 = phi_1149_;
                                let _e1048 = ((_e1045 * _e1039) - (_e1043 * _e1041));
                                if _e1037 {
                                    phi_1157_ = -(_e1048);
                                } else {
                                    phi_1157_ = _e1048;
                                }
                                let _e1051 = phi_1157_;
                                if (_e1026 < _e974) {
                                    phi_1168_ = true;
                                } else {
                                    if (_e1026 == _e974) {
                                        phi_1167_ = (_e1030 < _e978);
                                    } else {
                                        phi_1167_ = false;
                                    }
                                    let _e1056 = phi_1167_;
                                    phi_1168_ = _e1056;
                                }
                                let _e1058 = phi_1168_;
                                if _e1058 {
                                    phi_1172_ = _e978;
                                    phi_1173_ = _e974;
                                    phi_1174_ = _e1030;
                                    phi_1175_ = _e1026;
                                } else {
                                    phi_1172_ = _e1030;
                                    phi_1173_ = _e1026;
                                    phi_1174_ = _e978;
                                    phi_1175_ = _e974;
                                }
                                let _e1060 = phi_1172_;
                                let _e1062 = phi_1173_;
                                let _e1064 = phi_1174_;
                                let _e1066 = phi_1175_;
                                let _e1069 = ((_e1066 * _e1060) - (_e1064 * _e1062));
                                if _e1058 {
                                    phi_1183_ = -(_e1069);
                                } else {
                                    phi_1183_ = _e1069;
                                }
                                let _e1072 = phi_1183_;
                                if (_e974 < _e1000) {
                                    phi_1194_ = true;
                                } else {
                                    if (_e974 == _e1000) {
                                        phi_1193_ = (_e978 < _e1004);
                                    } else {
                                        phi_1193_ = false;
                                    }
                                    let _e1077 = phi_1193_;
                                    phi_1194_ = _e1077;
                                }
                                let _e1079 = phi_1194_;
                                if _e1079 {
                                    phi_1198_ = _e1004;
                                    phi_1199_ = _e1000;
                                    phi_1200_ = _e978;
                                    phi_1201_ = _e974;
                                } else {
                                    phi_1198_ = _e978;
                                    phi_1199_ = _e974;
                                    phi_1200_ = _e1004;
                                    phi_1201_ = _e1000;
                                }
                                let _e1081 = phi_1198_;
                                let _e1083 = phi_1199_;
                                let _e1085 = phi_1200_;
                                let _e1087 = phi_1201_;
                                let _e1090 = ((_e1087 * _e1081) - (_e1085 * _e1083));
                                if _e1079 {
                                    phi_1209_ = -(_e1090);
                                } else {
                                    phi_1209_ = _e1090;
                                }
                                let _e1093 = phi_1209_;
                                if (_e1051 >= 0f) {
                                    if (_e1072 >= 0f) {
                                        if (_e1093 >= 0f) {
                                            phi_1224_ = ((_e1051 + _e1072) + _e1093);
                                            phi_1225_ = false;
                                        } else {
                                            phi_1224_ = f32();
                                            phi_1225_ = true;
                                        }
                                        let _e1100 = phi_1224_;
                                        let _e1102 = phi_1225_;
                                        phi_1226_ = _e1100;
                                        phi_1227_ = _e1102;
                                    } else {
                                        phi_1226_ = f32();
                                        phi_1227_ = true;
                                    }
                                    let _e1104 = phi_1226_;
                                    let _e1106 = phi_1227_;
                                    phi_1228_ = _e1104;
                                    phi_1229_ = _e1106;
                                } else {
                                    phi_1228_ = f32();
                                    phi_1229_ = true;
                                }
                                let _e1108 = phi_1228_;
                                let _e1110 = phi_1229_;
                                if _e1110 {
                                    if (_e1051 <= 0f) {
                                        if (_e1072 <= 0f) {
                                            let _e1113 = (_e1093 <= 0f);
                                            if _e1113 {
                                            }
                                            phi_1247_ = ((_e1051 + _e1072) + _e1093);
                                            phi_1248_ = false;
                                            phi_1249_ = _e1113;
                                        } else {
                                            phi_1247_ = f32();
                                            phi_1248_ = true;
                                            phi_1249_ = false;
                                        }
                                        let _e1117 = phi_1247_;
                                        let _e1119 = phi_1248_;
                                        let _e1121 = phi_1249_;
                                        phi_1250_ = _e1117;
                                        phi_1251_ = _e1119;
                                        phi_1252_ = _e1121;
                                    } else {
                                        phi_1250_ = f32();
                                        phi_1251_ = true;
                                        phi_1252_ = false;
                                    }
                                    let _e1123 = phi_1250_;
                                    let _e1125 = phi_1251_;
                                    let _e1127 = phi_1252_;
                                    if _e1125 {
                                        phi_1256_ = false;
                                    } else {
                                        phi_1256_ = _e1127;
                                    }
                                    let _e1129 = phi_1256_;
                                    phi_1257_ = _e1123;
                                    phi_1258_ = _e1129;
                                } else {
                                    phi_1257_ = _e1108;
                                    phi_1258_ = true;
                                }
                                let _e1131 = phi_1257_;
                                let _e1133 = phi_1258_;
                                if _e1133 {
                                    let _e1134 = (_e1131 == 0f);
                                    if _e1134 {
                                        phi_1574_ = lt_bvh_triangle_Intersection();
                                        phi_1575_ = false;
                                    } else {
                                        let _e1136 = triangles.member[(0u + _e947)].v0_;
                                        let _e1138 = (_e1136.x - _e105);
                                        let _e1140 = (_e1136.y - _e107);
                                        let _e1142 = (_e1136.z - _e109);
                                        if (_e333 == 0u) {
                                            phi_1287_ = vec3<f32>(_e1140, _e1142, _e1138);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1286_ = vec3<f32>(_e1142, _e1138, _e1140);
                                            } else {
                                                phi_1286_ = (_e1136 - vec3<f32>(_e105, _e107, _e109));
                                            }
                                            let _e1150 = phi_1286_;
                                            phi_1287_ = _e1150;
                                        }
                                        let _e1152 = phi_1287_;
                                        let _e1154 = triangles.member[(0u + _e947)].v1_;
                                        let _e1156 = triangles.member[(0u + _e947)].v0_;
                                        let _e1159 = (_e1154.x - _e1156.x);
                                        let _e1162 = (_e1154.y - _e1156.y);
                                        let _e1165 = (_e1154.z - _e1156.z);
                                        if (_e333 == 0u) {
                                            phi_1313_ = vec3<f32>(_e1162, _e1165, _e1159);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1312_ = vec3<f32>(_e1165, _e1159, _e1162);
                                            } else {
                                                phi_1312_ = (_e1154 - _e1156);
                                            }
                                            let _e1172 = phi_1312_;
                                            phi_1313_ = _e1172;
                                        }
                                        let _e1174 = phi_1313_;
                                        let _e1176 = triangles.member[(0u + _e947)].v2_;
                                        let _e1178 = triangles.member[(0u + _e947)].v0_;
                                        let _e1181 = (_e1176.x - _e1178.x);
                                        let _e1184 = (_e1176.y - _e1178.y);
                                        let _e1187 = (_e1176.z - _e1178.z);
                                        if (_e333 == 0u) {
                                            phi_1339_ = vec3<f32>(_e1184, _e1187, _e1181);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1338_ = vec3<f32>(_e1187, _e1181, _e1184);
                                            } else {
                                                phi_1338_ = (_e1176 - _e1178);
                                            }
                                            let _e1194 = phi_1338_;
                                            phi_1339_ = _e1194;
                                        }
                                        let _e1196 = phi_1339_;
                                        let _e1203 = ((_e1174.y * _e1196.z) - (_e1174.z * _e1196.y));
                                        let _e1210 = ((_e1174.z * _e1196.x) - (_e1174.x * _e1196.z));
                                        let _e1217 = ((_e1174.x * _e1196.y) - (_e1174.y * _e1196.x));
                                        let _e1231 = (((1f / _e341.z) * (((_e1203 * _e1152.x) + (_e1210 * _e1152.y)) + (_e1217 * _e1152.z))) / (((_e1203 * _e344) + (_e1210 * _e347)) + _e1217));
                                        if (_e1231 > 0f) {
                                            if (_e1231 < _e113) {
                                                let _e1235 = triangles.member[(0u + _e947)].v0_;
                                                let _e1237 = triangles.member[(0u + _e947)].v1_;
                                                if (_e1235.x < _e1237.x) {
                                                    phi_1395_ = _e1235.x;
                                                } else {
                                                    phi_1395_ = _e1237.x;
                                                }
                                                let _e1244 = phi_1395_;
                                                if (_e1235.y < _e1237.y) {
                                                    phi_1404_ = _e1235.y;
                                                } else {
                                                    phi_1404_ = _e1237.y;
                                                }
                                                let _e1251 = phi_1404_;
                                                if (_e1235.z < _e1237.z) {
                                                    phi_1413_ = _e1235.z;
                                                } else {
                                                    phi_1413_ = _e1237.z;
                                                }
                                                let _e1258 = phi_1413_;
                                                let _e1260 = triangles.member[(0u + _e947)].v2_;
                                                if (_e1244 < _e1260.x) {
                                                    phi_1422_ = _e1244;
                                                } else {
                                                    phi_1422_ = _e1260.x;
                                                }
                                                let _e1265 = phi_1422_;
                                                if (_e1251 < _e1260.y) {
                                                    phi_1429_ = _e1251;
                                                } else {
                                                    phi_1429_ = _e1260.y;
                                                }
                                                let _e1270 = phi_1429_;
                                                if (_e1258 < _e1260.z) {
                                                    phi_1436_ = _e1258;
                                                } else {
                                                    phi_1436_ = _e1260.z;
                                                }
                                                let _e1275 = phi_1436_;
                                                let _e1277 = triangles.member[(0u + _e947)].v0_;
                                                let _e1279 = triangles.member[(0u + _e947)].v1_;
                                                if (_e1277.x > _e1279.x) {
                                                    phi_1449_ = _e1277.x;
                                                } else {
                                                    phi_1449_ = _e1279.x;
                                                }
                                                let _e1286 = phi_1449_;
                                                if (_e1277.y > _e1279.y) {
                                                    phi_1458_ = _e1277.y;
                                                } else {
                                                    phi_1458_ = _e1279.y;
                                                }
                                                let _e1293 = phi_1458_;
                                                if (_e1277.z > _e1279.z) {
                                                    phi_1467_ = _e1277.z;
                                                } else {
                                                    phi_1467_ = _e1279.z;
                                                }
                                                let _e1300 = phi_1467_;
                                                let _e1302 = triangles.member[(0u + _e947)].v2_;
                                                if (_e1286 > _e1302.x) {
                                                    phi_1476_ = _e1286;
                                                } else {
                                                    phi_1476_ = _e1302.x;
                                                }
                                                let _e1307 = phi_1476_;
                                                if (_e1293 > _e1302.y) {
                                                    phi_1483_ = _e1293;
                                                } else {
                                                    phi_1483_ = _e1302.y;
                                                }
                                                let _e1312 = phi_1483_;
                                                if (_e1300 > _e1302.z) {
                                                    phi_1490_ = _e1300;
                                                } else {
                                                    phi_1490_ = _e1302.z;
                                                }
                                                let _e1317 = phi_1490_;
                                                let _e1321 = ((_e1265 - _e105) * _e262);
                                                let _e1322 = ((_e1270 - _e107) * _e272);
                                                let _e1323 = ((_e1275 - _e109) * _e282);
                                                let _e1327 = ((_e1307 - _e105) * _e262);
                                                let _e1328 = ((_e1312 - _e107) * _e272);
                                                let _e1329 = ((_e1317 - _e109) * _e282);
                                                if (_e1321 < _e1327) {
                                                    phi_1507_ = _e1321;
                                                } else {
                                                    phi_1507_ = _e1327;
                                                }
                                                let _e1332 = phi_1507_;
                                                if (_e1322 < _e1328) {
                                                    phi_1512_ = _e1322;
                                                } else {
                                                    phi_1512_ = _e1328;
                                                }
                                                let _e1335 = phi_1512_;
                                                if (_e1323 < _e1329) {
                                                    phi_1517_ = _e1323;
                                                } else {
                                                    phi_1517_ = _e1329;
                                                }
                                                let _e1338 = phi_1517_;
                                                if (_e1321 > _e1327) {
                                                    phi_1525_ = _e1321;
                                                } else {
                                                    phi_1525_ = _e1327;
                                                }
                                                let _e1344 = phi_1525_;
                                                if (_e1322 > _e1328) {
                                                    phi_1530_ = _e1322;
                                                } else {
                                                    phi_1530_ = _e1328;
                                                }
                                                let _e1347 = phi_1530_;
                                                if (_e1323 > _e1329) {
                                                    phi_1535_ = _e1323;
                                                } else {
                                                    phi_1535_ = _e1329;
                                                }
                                                let _e1350 = phi_1535_;
                                                let _e1354 = core_intrinsics_maximum_number_nsz_f32_((_e1332 - _e317), (_e1335 - _e318));
                                                let _e1355 = core_intrinsics_maximum_number_nsz_f32_(_e1354, (_e1338 - _e319));
                                                let _e1356 = core_intrinsics_minimum_number_nsz_f32_((_e1344 + _e317), (_e1347 + _e318));
                                                let _e1357 = core_intrinsics_minimum_number_nsz_f32_(_e1356, (_e1350 + _e319));
                                                if (_e1355 > -300000000000000000000000000000000000000f) {
                                                    phi_1547_ = _e1355;
                                                } else {
                                                    phi_1547_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1360 = phi_1547_;
                                                if (_e1357 < 300000000000000000000000000000000000000f) {
                                                    phi_1552_ = _e1357;
                                                } else {
                                                    phi_1552_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1363 = phi_1552_;
                                                if (_e1231 < _e1360) {
                                                    phi_1557_ = _e1360;
                                                } else {
                                                    phi_1557_ = _e1231;
                                                }
                                                let _e1366 = phi_1557_;
                                                if (_e1366 > _e1363) {
                                                    phi_1562_ = _e1363;
                                                } else {
                                                    phi_1562_ = _e1366;
                                                }
                                                let _e1369 = phi_1562_;
                                                phi_1567_ = lt_bvh_triangle_Intersection(_e1369, (_e1072 / _e1131), (_e1093 / _e1131), (_e1360 <= _e1363));
                                                phi_1568_ = false;
                                            } else {
                                                phi_1567_ = lt_bvh_triangle_Intersection();
                                                phi_1568_ = true;
                                            }
                                            let _e1375 = phi_1567_;
                                            let _e1377 = phi_1568_;
                                            phi_1569_ = _e1375;
                                            phi_1570_ = _e1377;
                                        } else {
                                            phi_1569_ = lt_bvh_triangle_Intersection();
                                            phi_1570_ = true;
                                        }
                                        let _e1379 = phi_1569_;
                                        let _e1381 = phi_1570_;
                                        if _e1381 {
                                        }
                                        phi_1574_ = _e1379;
                                        phi_1575_ = _e1381;
                                    }
                                    let _e1383 = phi_1574_;
                                    let _e1385 = phi_1575_;
                                    phi_1576_ = _e1383;
                                    phi_1577_ = _e1134;
                                    phi_1578_ = _e1385;
                                } else {
                                    phi_1576_ = lt_bvh_triangle_Intersection();
                                    phi_1577_ = true;
                                    phi_1578_ = false;
                                }
                                let _e1387 = phi_1576_;
                                let _e1389 = phi_1577_;
                                let _e1391 = phi_1578_;
                                if _e1389 {
                                    phi_1582_ = true;
                                } else {
                                    phi_1582_ = _e1391;
                                }
                                let _e1393 = phi_1582_;
                                if _e1393 {
                                    phi_1586_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1586_ = _e1387;
                                }
                                let _e1395 = phi_1586_;
                                if _e1395.is_hit {
                                    if (_e1395.t > 0f) {
                                        if (_e1395.t < _e113) {
                                            if true {
                                                phi_1606_ = false;
                                            } else {
                                                phi_1606_ = true;
                                            }
                                            let _e1404 = phi_1606_;
                                            phi_1607_ = true;
                                            phi_1608_ = _e1404;
                                        } else {
                                            phi_1607_ = _e938;
                                            phi_1608_ = true;
                                        }
                                        let _e1406 = phi_1607_;
                                        let _e1408 = phi_1608_;
                                        phi_1609_ = _e1406;
                                        phi_1610_ = _e1408;
                                    } else {
                                        phi_1609_ = _e938;
                                        phi_1610_ = true;
                                    }
                                    let _e1410 = phi_1609_;
                                    let _e1412 = phi_1610_;
                                    phi_1611_ = _e1410;
                                    phi_1612_ = _e1412;
                                } else {
                                    phi_1611_ = _e938;
                                    phi_1612_ = true;
                                }
                                let _e1414 = phi_1611_;
                                let _e1416 = phi_1612_;
                                if _e1416 {
                                }
                                phi_1016_ = (_e936 & (_e936 - 1u));
                                phi_1019_ = _e1414;
                                phi_1616_ = _e1416;
                            }
                            let _e1418 = phi_1016_;
                            let _e1420 = phi_1019_;
                            let _e1422 = phi_1616_;
                            continue;
                            continuing {
                                phi_1015_ = _e1418;
                                phi_1018_ = _e1420;
                                break if !(_e1422);
                            }
                        }
                        let _e1425 = local_4;
                        if _e1425 {
                            let _e1427 = local.group_mask;
                            if ((_e1427 & 4278190080u) == 0u) {
                                let _e1431 = local.len;
                                if (_e1431 == 0u) {
                                    phi_1658_ = false;
                                } else {
                                    let _e1435 = local.len;
                                    local.len = (_e1435 - 1u);
                                    let _e1438 = local.len;
                                    if (_e1438 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1443 = local.first[(0u + _e1438)];
                                    local.group = _e1443;
                                    let _e1446 = local.len;
                                    if (_e1446 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1451 = local.mask[(0u + _e1446)];
                                    local.group_mask = _e1451;
                                    phi_1658_ = true;
                                }
                                let _e1454 = phi_1658_;
                                phi_1659_ = _e1454;
                            } else {
                                phi_1659_ = true;
                            }
                            let _e1456 = phi_1659_;
                            if _e1456 {
                                let _e1458 = local.group_mask;
                                let _e1464 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1458)), 32u, (_e1458 == 0u)));
                                let _e1468 = local.group_mask;
                                let _e1482 = local.group_mask;
                                local.group_mask = (_e1482 & ~((1u << bitcast<u32>((_e1464 & 31u)))));
                                let _e1485 = local.group;
                                phi_1690_ = (_e1485 + countOneBits(((_e1468 & ~((4294967295u << bitcast<u32>((((_e1464 - 24u) ^ _e360) & 31u))))) & 255u)));
                            } else {
                                phi_1690_ = 4294967295u;
                            }
                            let _e1488 = phi_1690_;
                            phi_1691_ = _e1488;
                        } else {
                            phi_1691_ = u32();
                        }
                        let _e1490 = phi_1691_;
                        phi_684_ = _e1490;
                        let _e1714 = local_6;
                        phi_687_ = _e1714;
                        let _e1717 = local_7;
                        phi_1692_ = _e1717;
                        phi_1693_ = false;
                    } else {
                        phi_684_ = u32();
                        phi_687_ = bool();
                        phi_1692_ = false;
                        phi_1693_ = true;
                    }
                    let _e1492 = phi_684_;
                    let _e1494 = phi_687_;
                    let _e1496 = phi_1692_;
                    let _e1498 = phi_1693_;
                    local_5 = _e1498;
                    continue;
                    continuing {
                        phi_683_ = _e1492;
                        phi_686_ = _e1494;
                        break if !(_e1496);
                    }
                }
                let _e1501 = local_5;
                if _e1501 {
                    phi_1697_ = false;
                } else {
                    phi_1697_ = true;
                }
                let _e1503 = phi_1697_;
                if _e1503 {
                    phi_1701_ = true;
                } else {
                    let _e1723 = local_8;
                    phi_1701_ = _e1723;
                }
                let _e1505 = phi_1701_;
                phi_1702_ = _e1505;
            }
            let _e1507 = phi_1702_;
            phi_1703_ = _e1507;
            phi_1704_ = _e186;
        } else {
            phi_1703_ = bool();
            phi_1704_ = true;
        }
        let _e1509 = phi_1703_;
        let _e1511 = phi_1704_;
        if _e1511 {
            phi_1708_ = false;
        } else {
            phi_1708_ = _e1509;
        }
        let _e1513 = phi_1708_;
        if _e1513 {
            phi_1712_ = 0f;
        } else {
            phi_1712_ = 1f;
        }
        let _e1515 = phi_1712_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        visibility.member[(0u + _e84)] = _e1515;
        if (_e84 < _e71) {
        } else {
            return;
        }
        let _e1522 = bits.member[(0u + _e84)];
        if ((_e1522 & 2u) == 0u) {
            phi_1733_ = (_e1522 & 1u);
        } else {
            phi_1733_ = (_e1522 & 7u);
        }
        let _e1528 = phi_1733_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        let _e1532 = visibility.member[(0u + _e84)];
        if ((_e1528 & 1u) != 0u) {
            phi_1748_ = (2u | 1u);
        } else {
            phi_1748_ = 2u;
        }
        let _e1538 = phi_1748_;
        if (_e1532 < 0.5f) {
            phi_1753_ = (_e1538 | 4u);
        } else {
            phi_1753_ = _e1538;
        }
        let _e1541 = phi_1753_;
        if (_e84 < _e71) {
        } else {
            return;
        }
        bits.member[(0u + _e84)] = _e1541;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
