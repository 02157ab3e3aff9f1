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

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_144_: bool;
    var phi_148_: f32;

    if (param != param) {
        phi_144_ = true;
    } else {
        let _e52 = (param_1 >= param);
        if _e52 {
        }
        phi_144_ = _e52;
    }
    let _e54 = phi_144_;
    if _e54 {
        phi_148_ = param_1;
    } else {
        phi_148_ = param;
    }
    let _e56 = phi_148_;
    return _e56;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_160_: bool;
    var phi_164_: f32;

    if (param_2 != param_2) {
        phi_160_ = true;
    } else {
        let _e52 = (param_3 <= param_2);
        if _e52 {
        }
        phi_160_ = _e52;
    }
    let _e54 = phi_160_;
    if _e54 {
        phi_164_ = param_3;
    } else {
        phi_164_ = param_2;
    }
    let _e56 = phi_164_;
    return _e56;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_238_: f32;
    var phi_293_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
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
    var phi_320_: bool;
    var phi_324_: bool;
    var phi_394_: f32;
    var phi_401_: f32;
    var phi_408_: f32;
    var phi_415_: f32;
    var phi_422_: f32;
    var phi_429_: f32;
    var phi_446_: f32;
    var phi_451_: f32;
    var phi_456_: f32;
    var phi_484_: bool;
    var phi_485_: bool;
    var phi_493_: u32;
    var phi_494_: u32;
    var phi_505_: vec3<f32>;
    var phi_506_: vec3<f32>;
    var phi_519_: u32;
    var phi_524_: u32;
    var phi_529_: u32;
    var phi_643_: bool;
    var phi_644_: bool;
    var phi_675_: u32;
    var phi_677_: u32;
    var phi_758_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_785_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_812_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_818_: u32;
    var phi_821_: u32;
    var phi_835_: u32;
    var phi_845_: u32;
    var phi_855_: u32;
    var phi_873_: u32;
    var phi_883_: u32;
    var phi_893_: u32;
    var phi_929_: u32;
    var phi_942_: u32;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_819_: u32;
    var phi_822_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1007_: u32;
    var phi_1052_: vec3<f32>;
    var phi_1053_: vec3<f32>;
    var phi_1082_: vec3<f32>;
    var phi_1083_: vec3<f32>;
    var phi_1112_: vec3<f32>;
    var phi_1113_: vec3<f32>;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1136_: f32;
    var phi_1137_: f32;
    var phi_1138_: f32;
    var phi_1139_: f32;
    var phi_1147_: f32;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1162_: f32;
    var phi_1163_: f32;
    var phi_1164_: f32;
    var phi_1165_: f32;
    var phi_1173_: f32;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1188_: f32;
    var phi_1189_: f32;
    var phi_1190_: f32;
    var phi_1191_: f32;
    var phi_1199_: f32;
    var phi_1214_: f32;
    var phi_1215_: bool;
    var phi_1216_: f32;
    var phi_1217_: bool;
    var phi_1218_: f32;
    var phi_1219_: bool;
    var phi_1237_: f32;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: f32;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1246_: bool;
    var phi_1247_: f32;
    var phi_1248_: bool;
    var phi_1276_: vec3<f32>;
    var phi_1277_: vec3<f32>;
    var phi_1302_: vec3<f32>;
    var phi_1303_: vec3<f32>;
    var phi_1328_: vec3<f32>;
    var phi_1329_: vec3<f32>;
    var phi_1385_: f32;
    var phi_1394_: f32;
    var phi_1403_: f32;
    var phi_1412_: f32;
    var phi_1419_: f32;
    var phi_1426_: f32;
    var phi_1439_: f32;
    var phi_1448_: f32;
    var phi_1457_: f32;
    var phi_1466_: f32;
    var phi_1473_: f32;
    var phi_1480_: f32;
    var phi_1497_: f32;
    var phi_1502_: f32;
    var phi_1507_: f32;
    var phi_1515_: f32;
    var phi_1520_: f32;
    var phi_1525_: f32;
    var phi_1537_: f32;
    var phi_1542_: f32;
    var phi_1547_: f32;
    var phi_1552_: f32;
    var phi_1557_: lt_bvh_triangle_Intersection;
    var phi_1558_: bool;
    var phi_1559_: lt_bvh_triangle_Intersection;
    var phi_1560_: bool;
    var phi_1564_: lt_bvh_triangle_Intersection;
    var phi_1565_: bool;
    var phi_1566_: lt_bvh_triangle_Intersection;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1572_: bool;
    var phi_1576_: lt_bvh_triangle_Intersection;
    var phi_1601_: bool;
    var phi_1602_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1008_: u32;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var local_4: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1694_: u32;
    var phi_1695_: u32;
    var phi_1696_: bool;
    var phi_1697_: bool;
    var phi_678_: u32;
    var phi_1698_: bool;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var local_5: bool;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1710_: bool;
    var phi_1714_: bool;
    var phi_1715_: bool;
    var phi_1716_: bool;
    var phi_1717_: bool;
    var phi_1721_: bool;
    var phi_1725_: f32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;

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
        let _e84 = p.member.light;
        let _e86 = samples.member[(0u + _e79)].position;
        let _e88 = samples.member[(0u + _e79)].normal;
        let _e90 = samples.member[(0u + _e79)].magnitude;
        let _e92 = ((8f / 8388608f) * _e90);
        let _e100 = (_e86.x + (_e88.x * _e92));
        let _e102 = (_e86.y + (_e88.y * _e92));
        let _e104 = (_e86.z + (_e88.z * _e92));
        if (_e84.w == 0f) {
            phi_238_ = 300000000000000000000000000000000000000f;
        } else {
            phi_238_ = 1f;
        }
        let _e108 = phi_238_;
        let _e116 = (_e84.x - (_e100 * _e84.w));
        let _e117 = (_e84.y - (_e102 * _e84.w));
        let _e118 = (_e84.z - (_e104 * _e84.w));
        let _e123 = abs(_e116);
        let _e124 = abs(_e117);
        let _e125 = abs(_e118);
        if (abs(_e100) < 1000000000000000f) {
            if (abs(_e102) < 1000000000000000f) {
                if (abs(_e104) < 1000000000000000f) {
                    if (_e123 < 1000000000000000f) {
                        if (_e124 < 1000000000000000f) {
                            if (_e125 < 1000000000000000f) {
                                if (_e123 > 0f) {
                                    phi_294_ = bool();
                                    phi_295_ = true;
                                } else {
                                    let _e133 = (_e124 > 0f);
                                    if _e133 {
                                        phi_293_ = bool();
                                    } else {
                                        phi_293_ = (_e125 > 0f);
                                    }
                                    let _e136 = phi_293_;
                                    phi_294_ = _e136;
                                    phi_295_ = _e133;
                                }
                                let _e138 = phi_294_;
                                let _e140 = phi_295_;
                                if _e140 {
                                    phi_299_ = true;
                                } else {
                                    phi_299_ = _e138;
                                }
                                let _e142 = phi_299_;
                                phi_300_ = _e142;
                                phi_301_ = false;
                            } else {
                                phi_300_ = bool();
                                phi_301_ = true;
                            }
                            let _e144 = phi_300_;
                            let _e146 = phi_301_;
                            phi_302_ = _e144;
                            phi_303_ = false;
                            phi_304_ = _e146;
                        } else {
                            phi_302_ = bool();
                            phi_303_ = true;
                            phi_304_ = false;
                        }
                        let _e148 = phi_302_;
                        let _e150 = phi_303_;
                        let _e152 = phi_304_;
                        phi_305_ = _e148;
                        phi_306_ = _e150;
                        phi_307_ = _e152;
                    } else {
                        phi_305_ = bool();
                        phi_306_ = true;
                        phi_307_ = false;
                    }
                    let _e154 = phi_305_;
                    let _e156 = phi_306_;
                    let _e158 = phi_307_;
                    phi_308_ = _e154;
                    phi_309_ = _e156;
                    phi_310_ = _e158;
                } else {
                    phi_308_ = bool();
                    phi_309_ = true;
                    phi_310_ = false;
                }
                let _e160 = phi_308_;
                let _e162 = phi_309_;
                let _e164 = phi_310_;
                phi_311_ = _e160;
                phi_312_ = _e162;
                phi_313_ = _e164;
            } else {
                phi_311_ = bool();
                phi_312_ = true;
                phi_313_ = false;
            }
            let _e166 = phi_311_;
            let _e168 = phi_312_;
            let _e170 = phi_313_;
            phi_314_ = _e166;
            phi_315_ = _e168;
            phi_316_ = _e170;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
            phi_316_ = false;
        }
        let _e172 = phi_314_;
        let _e174 = phi_315_;
        let _e176 = phi_316_;
        if _e174 {
            phi_320_ = true;
        } else {
            phi_320_ = _e176;
        }
        let _e178 = phi_320_;
        if _e178 {
            phi_324_ = false;
        } else {
            phi_324_ = _e172;
        }
        let _e180 = phi_324_;
        if _e180 {
            let _e181 = (0u >= _e57);
            if _e181 {
                phi_1715_ = bool();
            } else {
                if (0u < _e57) {
                } else {
                    return;
                }
                let _e187 = nodes.member[(0u + 0u)].frame[0u];
                let _e191 = nodes.member[(0u + 0u)].frame[1u];
                let _e195 = nodes.member[(0u + 0u)].frame[2u];
                let _e199 = nodes.member[(0u + 0u)].frame[0u];
                let _e203 = nodes.member[(0u + 0u)].frame[1u];
                let _e207 = nodes.member[(0u + 0u)].frame[2u];
                let _e211 = nodes.member[(0u + 0u)].frame[3u];
                let _e245 = core_intrinsics_maximum_number_nsz_f32_(abs(_e116), abs(_e117));
                let _e246 = core_intrinsics_maximum_number_nsz_f32_(_e245, abs(_e118));
                let _e247 = (_e246 * 0.0000000000009094947f);
                if (abs(_e116) < _e247) {
                    phi_394_ = _e247;
                } else {
                    phi_394_ = abs(_e116);
                }
                let _e252 = phi_394_;
                if (_e116 < 0f) {
                    phi_401_ = (-1f / _e252);
                } else {
                    phi_401_ = (1f / _e252);
                }
                let _e257 = phi_401_;
                if (abs(_e117) < _e247) {
                    phi_408_ = _e247;
                } else {
                    phi_408_ = abs(_e117);
                }
                let _e262 = phi_408_;
                if (_e117 < 0f) {
                    phi_415_ = (-1f / _e262);
                } else {
                    phi_415_ = (1f / _e262);
                }
                let _e267 = phi_415_;
                if (abs(_e118) < _e247) {
                    phi_422_ = _e247;
                } else {
                    phi_422_ = abs(_e118);
                }
                let _e272 = phi_422_;
                if (_e118 < 0f) {
                    phi_429_ = (-1f / _e272);
                } else {
                    phi_429_ = (1f / _e272);
                }
                let _e277 = phi_429_;
                let _e281 = abs((bitcast<f32>(_e187) - _e100));
                let _e282 = abs((bitcast<f32>(_e191) - _e102));
                let _e283 = abs((bitcast<f32>(_e195) - _e104));
                let _e287 = abs(((bitcast<f32>(_e199) + (bitcast<f32>((((_e211 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e100));
                let _e288 = abs(((bitcast<f32>(_e203) + (bitcast<f32>((((_e211 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e102));
                let _e289 = abs(((bitcast<f32>(_e207) + (bitcast<f32>((((_e211 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e104));
                if (_e281 > _e287) {
                    phi_446_ = _e281;
                } else {
                    phi_446_ = _e287;
                }
                let _e292 = phi_446_;
                if (_e282 > _e288) {
                    phi_451_ = _e282;
                } else {
                    phi_451_ = _e288;
                }
                let _e295 = phi_451_;
                if (_e283 > _e289) {
                    phi_456_ = _e283;
                } else {
                    phi_456_ = _e289;
                }
                let _e298 = phi_456_;
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(_e292, _e295);
                let _e300 = core_intrinsics_maximum_number_nsz_f32_(_e299, _e298);
                let _e304 = (_e300 * 0.0000019073486f);
                let _e305 = (abs(_e257) * _e304);
                let _e306 = (abs(_e267) * _e304);
                let _e307 = (abs(_e277) * _e304);
                let _e311 = (_e300 * 0.0000009536743f);
                let _e312 = (abs(_e257) * _e311);
                let _e313 = (abs(_e267) * _e311);
                let _e314 = (abs(_e277) * _e311);
                let _e315 = abs(_e116);
                let _e316 = abs(_e117);
                let _e317 = abs(_e118);
                if (_e315 >= _e316) {
                    if (_e315 >= _e317) {
                        phi_484_ = false;
                    } else {
                        phi_484_ = true;
                    }
                    let _e321 = phi_484_;
                    phi_485_ = _e321;
                } else {
                    phi_485_ = true;
                }
                let _e323 = phi_485_;
                if _e323 {
                    if (_e316 >= _e317) {
                        phi_493_ = 1u;
                    } else {
                        phi_493_ = 2u;
                    }
                    let _e326 = phi_493_;
                    phi_494_ = _e326;
                } else {
                    phi_494_ = 0u;
                }
                let _e328 = phi_494_;
                if (_e328 == 0u) {
                    phi_506_ = vec3<f32>(_e117, _e118, _e116);
                } else {
                    if (_e328 == 1u) {
                        phi_505_ = vec3<f32>(_e118, _e116, _e117);
                    } else {
                        phi_505_ = vec3<f32>(_e116, _e117, _e118);
                    }
                    let _e334 = phi_505_;
                    phi_506_ = _e334;
                }
                let _e336 = phi_506_;
                let _e339 = (_e336.x / _e336.z);
                let _e342 = (_e336.y / _e336.z);
                if (_e257 < 0f) {
                    phi_519_ = 0u;
                } else {
                    phi_519_ = 1u;
                }
                let _e347 = phi_519_;
                if (_e267 < 0f) {
                    phi_524_ = 0u;
                } else {
                    phi_524_ = 2u;
                }
                let _e350 = phi_524_;
                if (_e277 < 0f) {
                    phi_529_ = 0u;
                } else {
                    phi_529_ = 4u;
                }
                let _e353 = phi_529_;
                let _e355 = ((_e347 | _e350) | _e353);
                let _e356 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e356.first[0], _e356.first[1], _e356.first[2], _e356.first[3], _e356.first[4], _e356.first[5], _e356.first[6], _e356.first[7], _e356.first[8], _e356.first[9], _e356.first[10], _e356.first[11], _e356.first[12], _e356.first[13], _e356.first[14], _e356.first[15], _e356.first[16], _e356.first[17], _e356.first[18], _e356.first[19], _e356.first[20], _e356.first[21], _e356.first[22], _e356.first[23], _e356.first[24], _e356.first[25], _e356.first[26], _e356.first[27], _e356.first[28], _e356.first[29], _e356.first[30], _e356.first[31]), array<u32, 32>(_e356.mask[0], _e356.mask[1], _e356.mask[2], _e356.mask[3], _e356.mask[4], _e356.mask[5], _e356.mask[6], _e356.mask[7], _e356.mask[8], _e356.mask[9], _e356.mask[10], _e356.mask[11], _e356.mask[12], _e356.mask[13], _e356.mask[14], _e356.mask[15], _e356.mask[16], _e356.mask[17], _e356.mask[18], _e356.mask[19], _e356.mask[20], _e356.mask[21], _e356.mask[22], _e356.mask[23], _e356.mask[24], _e356.mask[25], _e356.mask[26], _e356.mask[27], _e356.mask[28], _e356.mask[29], _e356.mask[30], _e356.mask[31]), _e356.len, _e356.group, _e356.group_mask);
                let _e430 = local.group_mask;
                if ((_e430 & 4278190080u) == 0u) {
                    let _e434 = local.len;
                    if (_e434 == 0u) {
                        phi_643_ = false;
                    } else {
                        let _e438 = local.len;
                        local.len = (_e438 - 1u);
                        let _e441 = local.len;
                        if (_e441 < 32u) {
                        } else {
                            return;
                        }
                        let _e446 = local.first[(0u + _e441)];
                        local.group = _e446;
                        let _e449 = local.len;
                        if (_e449 < 32u) {
                        } else {
                            return;
                        }
                        let _e454 = local.mask[(0u + _e449)];
                        local.group_mask = _e454;
                        phi_643_ = true;
                    }
                    let _e457 = phi_643_;
                    phi_644_ = _e457;
                } else {
                    phi_644_ = true;
                }
                let _e459 = phi_644_;
                if _e459 {
                    let _e461 = local.group_mask;
                    let _e467 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e461)), 32u, (_e461 == 0u)));
                    let _e471 = local.group_mask;
                    let _e485 = local.group_mask;
                    local.group_mask = (_e485 & ~((1u << bitcast<u32>((_e467 & 31u)))));
                    let _e488 = local.group;
                    phi_675_ = (_e488 + countOneBits(((_e471 & ~((4294967295u << bitcast<u32>((((_e467 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_675_ = 4294967295u;
                }
                let _e491 = phi_675_;
                phi_677_ = _e491;
                loop {
                    let _e493 = phi_677_;
                    if (_e493 != 4294967295u) {
                        if (_e493 < _e57) {
                        } else {
                            return;
                        }
                        let _e500 = nodes.member[(0u + _e493)].frame[3u];
                        let _e525 = (bitcast<f32>((((_e500 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e257);
                        let _e526 = (bitcast<f32>((((_e500 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e267);
                        let _e527 = (bitcast<f32>((((_e500 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e277);
                        let _e530 = nodes.member[(0u + _e493)].frame[0u];
                        let _e534 = nodes.member[(0u + _e493)].frame[1u];
                        let _e538 = nodes.member[(0u + _e493)].frame[2u];
                        let _e543 = ((bitcast<f32>(_e530) - _e100) * _e257);
                        let _e544 = ((bitcast<f32>(_e534) - _e102) * _e267);
                        let _e545 = ((bitcast<f32>(_e538) - _e104) * _e277);
                        let _e553 = nodes.member[(0u + _e493)].x;
                        if (_e257 < 0f) {
                            let _e564 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e553.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e564.unnamed.root, _e553.w), _e564.unnamed_1);
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e570.unnamed, lt_bvh_traverse_Tree(_e553.x, _e570.unnamed_1.first_primitive));
                            phi_758_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e576.unnamed_1.root, _e553.y));
                        } else {
                            let _e592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e553.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e592.unnamed.root, _e553.y), _e592.unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e598.unnamed, lt_bvh_traverse_Tree(_e553.z, _e598.unnamed_1.first_primitive));
                            phi_758_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e604.unnamed_1.root, _e553.w));
                        }
                        let _e612 = phi_758_;
                        let _e622 = nodes.member[(0u + _e493)].y;
                        if (_e267 < 0f) {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e622.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.unnamed.root, _e622.w), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_bvh_traverse_Tree(_e622.x, _e639.unnamed_1.first_primitive));
                            phi_785_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e645.unnamed_1.root, _e622.y));
                        } else {
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e622.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e661.unnamed.root, _e622.y), _e661.unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e667.unnamed, lt_bvh_traverse_Tree(_e622.z, _e667.unnamed_1.first_primitive));
                            phi_785_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e673.unnamed_1.root, _e622.w));
                        }
                        let _e681 = phi_785_;
                        let _e691 = nodes.member[(0u + _e493)].z;
                        if (_e277 < 0f) {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e691.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.unnamed.root, _e691.w), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_bvh_traverse_Tree(_e691.x, _e708.unnamed_1.first_primitive));
                            phi_812_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e714.unnamed_1.root, _e691.y));
                        } else {
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e691.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e730.unnamed.root, _e691.y), _e730.unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_bvh_traverse_Tree(_e691.z, _e736.unnamed_1.first_primitive));
                            phi_812_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e742.unnamed_1.root, _e691.w));
                        }
                        let _e750 = phi_812_;
                        phi_818_ = 0u;
                        phi_821_ = 0u;
                        loop {
                            let _e760 = phi_818_;
                            let _e762 = phi_821_;
                            local_1 = _e762;
                            local_2 = _e762;
                            local_3 = _e762;
                            let _e763 = (_e760 < 8u);
                            if _e763 {
                                let _e765 = (_e760 >> bitcast<u32>(2i));
                                let _e766 = (_e760 & 3u);
                                if (_e765 == 0u) {
                                    phi_835_ = _e612.unnamed.root;
                                } else {
                                    phi_835_ = _e612.unnamed.first_primitive;
                                }
                                let _e769 = phi_835_;
                                if (_e765 == 0u) {
                                    phi_845_ = _e681.unnamed.root;
                                } else {
                                    phi_845_ = _e681.unnamed.first_primitive;
                                }
                                let _e778 = phi_845_;
                                if (_e765 == 0u) {
                                    phi_855_ = _e750.unnamed.root;
                                } else {
                                    phi_855_ = _e750.unnamed.first_primitive;
                                }
                                let _e787 = phi_855_;
                                let _e800 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e769 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e525) + (_e543 - _e305)), ((f32(((_e778 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e306)));
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(_e800, ((f32(((_e787 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e307)));
                                if (_e765 == 0u) {
                                    phi_873_ = _e612.unnamed_1.root;
                                } else {
                                    phi_873_ = _e612.unnamed_1.first_primitive;
                                }
                                let _e804 = phi_873_;
                                if (_e765 == 0u) {
                                    phi_883_ = _e681.unnamed_1.root;
                                } else {
                                    phi_883_ = _e681.unnamed_1.first_primitive;
                                }
                                let _e813 = phi_883_;
                                if (_e765 == 0u) {
                                    phi_893_ = _e750.unnamed_1.root;
                                } else {
                                    phi_893_ = _e750.unnamed_1.first_primitive;
                                }
                                let _e822 = phi_893_;
                                let _e835 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e804 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e525) + (_e543 + _e305)), ((f32(((_e813 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e306)));
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(_e835, ((f32(((_e822 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e307)));
                                if (_e801 <= _e836) {
                                    if (_e801 <= _e108) {
                                        if (_e836 >= 0f) {
                                            if (_e765 == 0u) {
                                                let _e843 = nodes.member[(0u + _e493)].links[2u];
                                                phi_929_ = _e843;
                                            } else {
                                                let _e846 = nodes.member[(0u + _e493)].links[3u];
                                                phi_929_ = _e846;
                                            }
                                            let _e848 = phi_929_;
                                            let _e853 = ((_e848 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u);
                                            let _e854 = (_e853 & 31u);
                                            if (_e854 >= 24u) {
                                                phi_942_ = (24u + ((_e854 - 24u) ^ _e355));
                                            } else {
                                                phi_942_ = _e854;
                                            }
                                            let _e860 = phi_942_;
                                            phi_947_ = (_e762 | ((_e853 >> bitcast<u32>(5i)) << bitcast<u32>((_e860 & 31u))));
                                        } else {
                                            phi_947_ = _e762;
                                        }
                                        let _e868 = phi_947_;
                                        phi_948_ = _e868;
                                    } else {
                                        phi_948_ = _e762;
                                    }
                                    let _e870 = phi_948_;
                                    phi_949_ = _e870;
                                } else {
                                    phi_949_ = _e762;
                                }
                                let _e872 = phi_949_;
                                phi_819_ = (_e760 + 1u);
                                phi_822_ = _e872;
                            } else {
                                phi_819_ = u32();
                                phi_822_ = u32();
                            }
                            let _e875 = phi_819_;
                            let _e877 = phi_822_;
                            continue;
                            continuing {
                                phi_818_ = _e875;
                                phi_821_ = _e877;
                                break if !(_e763);
                            }
                        }
                        let _e881 = nodes.member[(0u + _e493)].links[0u];
                        let _e885 = nodes.member[(0u + _e493)].frame[3u];
                        let _e889 = local_1;
                        if ((_e889 & 4278190080u) == 0u) {
                        } else {
                            let _e893 = local.group_mask;
                            if ((_e893 & 4278190080u) == 0u) {
                            } else {
                                let _e897 = local.len;
                                if (_e897 < 32u) {
                                    let _e900 = local.group;
                                    let _e902 = local.len;
                                    if (_e902 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e902)] = _e900;
                                    let _e908 = local.group_mask;
                                    let _e910 = local.len;
                                    if (_e910 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e910)] = _e908;
                                    let _e917 = local.len;
                                    local.len = (_e917 + 1u);
                                }
                            }
                            local.group = (0u + _e881);
                            let _e921 = local_2;
                            local.group_mask = ((_e921 & 4278190080u) | (_e885 >> bitcast<u32>(24i)));
                        }
                        let _e926 = local_3;
                        phi_1007_ = (_e926 & 16777215u);
                        loop {
                            let _e929 = phi_1007_;
                            let _e930 = (_e929 == 0u);
                            local_4 = _e930;
                            local_8 = _e930;
                            if _e930 {
                                phi_1008_ = u32();
                                phi_1618_ = false;
                                phi_1619_ = false;
                                phi_1620_ = false;
                            } else {
                                let _e933 = nodes.member[(0u + _e493)].links[1u];
                                let _e938 = ((0u + _e933) + select(firstTrailingBit(_e929), 32u, (_e929 == 0u)));
                                if (_e938 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e945 = triangles.member[(0u + _e938)].v0_;
                                let _e947 = (_e945.x - _e100);
                                let _e949 = (_e945.y - _e102);
                                let _e951 = (_e945.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1053_ = vec3<f32>(_e949, _e951, _e947);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1052_ = vec3<f32>(_e951, _e947, _e949);
                                    } else {
                                        phi_1052_ = (_e945 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e959 = phi_1052_;
                                    phi_1053_ = _e959;
                                }
                                let _e961 = phi_1053_;
                                let _e965 = (_e961.x - (_e339 * _e961.z));
                                let _e969 = (_e961.y - (_e342 * _e961.z));
                                let _e971 = triangles.member[(0u + _e938)].v1_;
                                let _e973 = (_e971.x - _e100);
                                let _e975 = (_e971.y - _e102);
                                let _e977 = (_e971.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1083_ = vec3<f32>(_e975, _e977, _e973);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1082_ = vec3<f32>(_e977, _e973, _e975);
                                    } else {
                                        phi_1082_ = (_e971 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e985 = phi_1082_;
                                    phi_1083_ = _e985;
                                }
                                let _e987 = phi_1083_;
                                let _e991 = (_e987.x - (_e339 * _e987.z));
                                let _e995 = (_e987.y - (_e342 * _e987.z));
                                let _e997 = triangles.member[(0u + _e938)].v2_;
                                let _e999 = (_e997.x - _e100);
                                let _e1001 = (_e997.y - _e102);
                                let _e1003 = (_e997.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1113_ = vec3<f32>(_e1001, _e1003, _e999);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1112_ = vec3<f32>(_e1003, _e999, _e1001);
                                    } else {
                                        phi_1112_ = (_e997 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e1011 = phi_1112_;
                                    phi_1113_ = _e1011;
                                }
                                let _e1013 = phi_1113_;
                                let _e1017 = (_e1013.x - (_e339 * _e1013.z));
                                let _e1021 = (_e1013.y - (_e342 * _e1013.z));
                                if (_e991 < _e1017) {
                                    phi_1132_ = true;
                                } else {
                                    if (_e991 == _e1017) {
                                        phi_1131_ = (_e995 < _e1021);
                                    } else {
                                        phi_1131_ = false;
                                    }
                                    let _e1026 = phi_1131_;
                                    phi_1132_ = _e1026;
                                }
                                let _e1028 = phi_1132_;
                                if _e1028 {
                                    phi_1136_ = _e1021;
                                    phi_1137_ = _e1017;
                                    phi_1138_ = _e995;
                                    phi_1139_ = _e991;
                                } else {
                                    phi_1136_ = _e995;
                                    phi_1137_ = _e991;
                                    phi_1138_ = _e1021;
                                    phi_1139_ = _e1017;
                                }
                                let _e1030 = phi_1136_;
                                let _e1032 = phi_1137_;
                                let _e1034 = phi_1138_;
                                let _e1036 = phi_1139_;
                                let _e1039 = ((_e1036 * _e1030) - (_e1034 * _e1032));
                                if _e1028 {
                                    phi_1147_ = -(_e1039);
                                } else {
                                    phi_1147_ = _e1039;
                                }
                                let _e1042 = phi_1147_;
                                if (_e1017 < _e965) {
                                    phi_1158_ = true;
                                } else {
                                    if (_e1017 == _e965) {
                                        phi_1157_ = (_e1021 < _e969);
                                    } else {
                                        phi_1157_ = false;
                                    }
                                    let _e1047 = phi_1157_;
                                    phi_1158_ = _e1047;
                                }
                                let _e1049 = phi_1158_;
                                if _e1049 {
                                    phi_1162_ = _e969;
                                    phi_1163_ = _e965;
                                    phi_1164_ = _e1021;
                                    phi_1165_ = _e1017;
                                } else {
                                    phi_1162_ = _e1021;
                                    phi_1163_ = _e1017;
                                    phi_1164_ = _e969;
                                    phi_1165_ = _e965;
                                }
                                let _e1051 = phi_1162_;
                                let _e1053 = phi_1163_;
                                let _e1055 = phi_1164_;
                                let _e1057 = phi_1165_;
                                let _e1060 = ((_e1057 * _e1051) - (_e1055 * _e1053));
                                if _e1049 {
                                    phi_1173_ = -(_e1060);
                                } else {
                                    phi_1173_ = _e1060;
                                }
                                let _e1063 = phi_1173_;
                                if (_e965 < _e991) {
                                    phi_1184_ = true;
                                } else {
                                    if (_e965 == _e991) {
                                        phi_1183_ = (_e969 < _e995);
                                    } else {
                                        phi_1183_ = false;
                                    }
                                    let _e1068 = phi_1183_;
                                    phi_1184_ = _e1068;
                                }
                                let _e1070 = phi_1184_;
                                if _e1070 {
                                    phi_1188_ = _e995;
                                    phi_1189_ = _e991;
                                    phi_1190_ = _e969;
                                    phi_1191_ = _e965;
                                } else {
                                    phi_1188_ = _e969;
                                    phi_1189_ = _e965;
                                    phi_1190_ = _e995;
                                    phi_1191_ = _e991;
                                }
                                let _e1072 = phi_1188_;
                                let _e1074 = phi_1189_;
                                let _e1076 = phi_1190_;
                                let _e1078 = phi_1191_;
                                let _e1081 = ((_e1078 * _e1072) - (_e1076 * _e1074));
                                if _e1070 {
                                    phi_1199_ = -(_e1081);
                                } else {
                                    phi_1199_ = _e1081;
                                }
                                let _e1084 = phi_1199_;
                                if (_e1042 >= 0f) {
                                    if (_e1063 >= 0f) {
                                        if (_e1084 >= 0f) {
                                            phi_1214_ = ((_e1042 + _e1063) + _e1084);
                                            phi_1215_ = false;
                                        } else {
                                            phi_1214_ = f32();
                                            phi_1215_ = true;
                                        }
                                        let _e1091 = phi_1214_;
                                        let _e1093 = phi_1215_;
                                        phi_1216_ = _e1091;
                                        phi_1217_ = _e1093;
                                    } else {
                                        phi_1216_ = f32();
                                        phi_1217_ = true;
                                    }
                                    let _e1095 = phi_1216_;
                                    let _e1097 = phi_1217_;
                                    phi_1218_ = _e1095;
                                    phi_1219_ = _e1097;
                                } else {
                                    phi_1218_ = f32();
                                    phi_1219_ = true;
                                }
                                let _e1099 = phi_1218_;
                                let _e1101 = phi_1219_;
                                if _e1101 {
                                    if (_e1042 <= 0f) {
                                        if (_e1063 <= 0f) {
                                            let _e1104 = (_e1084 <= 0f);
                                            if _e1104 {
                                            }
                                            phi_1237_ = ((_e1042 + _e1063) + _e1084);
                                            phi_1238_ = false;
                                            phi_1239_ = _e1104;
                                        } else {
                                            phi_1237_ = f32();
                                            phi_1238_ = true;
                                            phi_1239_ = false;
                                        }
                                        let _e1108 = phi_1237_;
                                        let _e1110 = phi_1238_;
                                        let _e1112 = phi_1239_;
                                        phi_1240_ = _e1108;
                                        phi_1241_ = _e1110;
                                        phi_1242_ = _e1112;
                                    } else {
                                        phi_1240_ = f32();
                                        phi_1241_ = true;
                                        phi_1242_ = false;
                                    }
                                    let _e1114 = phi_1240_;
                                    let _e1116 = phi_1241_;
                                    let _e1118 = phi_1242_;
                                    if _e1116 {
                                        phi_1246_ = false;
                                    } else {
                                        phi_1246_ = _e1118;
                                    }
                                    let _e1120 = phi_1246_;
                                    phi_1247_ = _e1114;
                                    phi_1248_ = _e1120;
                                } else {
                                    phi_1247_ = _e1099;
                                    phi_1248_ = true;
                                }
                                let _e1122 = phi_1247_;
                                let _e1124 = phi_1248_;
                                if _e1124 {
                                    let _e1125 = (_e1122 == 0f);
                                    if _e1125 {
                                        phi_1564_ = lt_bvh_triangle_Intersection();
                                        phi_1565_ = false;
                                    } else {
                                        let _e1127 = triangles.member[(0u + _e938)].v0_;
                                        let _e1129 = (_e1127.x - _e100);
                                        let _e1131 = (_e1127.y - _e102);
                                        let _e1133 = (_e1127.z - _e104);
                                        if (_e328 == 0u) {
                                            phi_1277_ = vec3<f32>(_e1131, _e1133, _e1129);
                                        } else {
                                            if (_e328 == 1u) {
                                                phi_1276_ = vec3<f32>(_e1133, _e1129, _e1131);
                                            } else {
                                                phi_1276_ = (_e1127 - vec3<f32>(_e100, _e102, _e104));
                                            }
                                            let _e1141 = phi_1276_;
                                            phi_1277_ = _e1141;
                                        }
                                        let _e1143 = phi_1277_;
                                        let _e1145 = triangles.member[(0u + _e938)].v1_;
                                        let _e1147 = triangles.member[(0u + _e938)].v0_;
                                        let _e1150 = (_e1145.x - _e1147.x);
                                        let _e1153 = (_e1145.y - _e1147.y);
                                        let _e1156 = (_e1145.z - _e1147.z);
                                        if (_e328 == 0u) {
                                            phi_1303_ = vec3<f32>(_e1153, _e1156, _e1150);
                                        } else {
                                            if (_e328 == 1u) {
                                                phi_1302_ = vec3<f32>(_e1156, _e1150, _e1153);
                                            } else {
                                                phi_1302_ = (_e1145 - _e1147);
                                            }
                                            let _e1163 = phi_1302_;
                                            phi_1303_ = _e1163;
                                        }
                                        let _e1165 = phi_1303_;
                                        let _e1167 = triangles.member[(0u + _e938)].v2_;
                                        let _e1169 = triangles.member[(0u + _e938)].v0_;
                                        let _e1172 = (_e1167.x - _e1169.x);
                                        let _e1175 = (_e1167.y - _e1169.y);
                                        let _e1178 = (_e1167.z - _e1169.z);
                                        if (_e328 == 0u) {
                                            phi_1329_ = vec3<f32>(_e1175, _e1178, _e1172);
                                        } else {
                                            if (_e328 == 1u) {
                                                phi_1328_ = vec3<f32>(_e1178, _e1172, _e1175);
                                            } else {
                                                phi_1328_ = (_e1167 - _e1169);
                                            }
                                            let _e1185 = phi_1328_;
                                            phi_1329_ = _e1185;
                                        }
                                        let _e1187 = phi_1329_;
                                        let _e1194 = ((_e1165.y * _e1187.z) - (_e1165.z * _e1187.y));
                                        let _e1201 = ((_e1165.z * _e1187.x) - (_e1165.x * _e1187.z));
                                        let _e1208 = ((_e1165.x * _e1187.y) - (_e1165.y * _e1187.x));
                                        let _e1222 = (((1f / _e336.z) * (((_e1194 * _e1143.x) + (_e1201 * _e1143.y)) + (_e1208 * _e1143.z))) / (((_e1194 * _e339) + (_e1201 * _e342)) + _e1208));
                                        if (_e1222 > 0f) {
                                            if (_e1222 < _e108) {
                                                let _e1226 = triangles.member[(0u + _e938)].v0_;
                                                let _e1228 = triangles.member[(0u + _e938)].v1_;
                                                if (_e1226.x < _e1228.x) {
                                                    phi_1385_ = _e1226.x;
                                                } else {
                                                    phi_1385_ = _e1228.x;
                                                }
                                                let _e1235 = phi_1385_;
                                                if (_e1226.y < _e1228.y) {
                                                    phi_1394_ = _e1226.y;
                                                } else {
                                                    phi_1394_ = _e1228.y;
                                                }
                                                let _e1242 = phi_1394_;
                                                if (_e1226.z < _e1228.z) {
                                                    phi_1403_ = _e1226.z;
                                                } else {
                                                    phi_1403_ = _e1228.z;
                                                }
                                                let _e1249 = phi_1403_;
                                                let _e1251 = triangles.member[(0u + _e938)].v2_;
                                                if (_e1235 < _e1251.x) {
                                                    phi_1412_ = _e1235;
                                                } else {
                                                    phi_1412_ = _e1251.x;
                                                }
                                                let _e1256 = phi_1412_;
                                                if (_e1242 < _e1251.y) {
                                                    phi_1419_ = _e1242;
                                                } else {
                                                    phi_1419_ = _e1251.y;
                                                }
                                                let _e1261 = phi_1419_;
                                                if (_e1249 < _e1251.z) {
                                                    phi_1426_ = _e1249;
                                                } else {
                                                    phi_1426_ = _e1251.z;
                                                }
                                                let _e1266 = phi_1426_;
                                                let _e1268 = triangles.member[(0u + _e938)].v0_;
                                                let _e1270 = triangles.member[(0u + _e938)].v1_;
                                                if (_e1268.x > _e1270.x) {
                                                    phi_1439_ = _e1268.x;
                                                } else {
                                                    phi_1439_ = _e1270.x;
                                                }
                                                let _e1277 = phi_1439_;
                                                if (_e1268.y > _e1270.y) {
                                                    phi_1448_ = _e1268.y;
                                                } else {
                                                    phi_1448_ = _e1270.y;
                                                }
                                                let _e1284 = phi_1448_;
                                                if (_e1268.z > _e1270.z) {
                                                    phi_1457_ = _e1268.z;
                                                } else {
                                                    phi_1457_ = _e1270.z;
                                                }
                                                let _e1291 = phi_1457_;
                                                let _e1293 = triangles.member[(0u + _e938)].v2_;
                                                if (_e1277 > _e1293.x) {
                                                    phi_1466_ = _e1277;
                                                } else {
                                                    phi_1466_ = _e1293.x;
                                                }
                                                let _e1298 = phi_1466_;
                                                if (_e1284 > _e1293.y) {
                                                    phi_1473_ = _e1284;
                                                } else {
                                                    phi_1473_ = _e1293.y;
                                                }
                                                let _e1303 = phi_1473_;
                                                if (_e1291 > _e1293.z) {
                                                    phi_1480_ = _e1291;
                                                } else {
                                                    phi_1480_ = _e1293.z;
                                                }
                                                let _e1308 = phi_1480_;
                                                let _e1312 = ((_e1256 - _e100) * _e257);
                                                let _e1313 = ((_e1261 - _e102) * _e267);
                                                let _e1314 = ((_e1266 - _e104) * _e277);
                                                let _e1318 = ((_e1298 - _e100) * _e257);
                                                let _e1319 = ((_e1303 - _e102) * _e267);
                                                let _e1320 = ((_e1308 - _e104) * _e277);
                                                if (_e1312 < _e1318) {
                                                    phi_1497_ = _e1312;
                                                } else {
                                                    phi_1497_ = _e1318;
                                                }
                                                let _e1323 = phi_1497_;
                                                if (_e1313 < _e1319) {
                                                    phi_1502_ = _e1313;
                                                } else {
                                                    phi_1502_ = _e1319;
                                                }
                                                let _e1326 = phi_1502_;
                                                if (_e1314 < _e1320) {
                                                    phi_1507_ = _e1314;
                                                } else {
                                                    phi_1507_ = _e1320;
                                                }
                                                let _e1329 = phi_1507_;
                                                if (_e1312 > _e1318) {
                                                    phi_1515_ = _e1312;
                                                } else {
                                                    phi_1515_ = _e1318;
                                                }
                                                let _e1335 = phi_1515_;
                                                if (_e1313 > _e1319) {
                                                    phi_1520_ = _e1313;
                                                } else {
                                                    phi_1520_ = _e1319;
                                                }
                                                let _e1338 = phi_1520_;
                                                if (_e1314 > _e1320) {
                                                    phi_1525_ = _e1314;
                                                } else {
                                                    phi_1525_ = _e1320;
                                                }
                                                let _e1341 = phi_1525_;
                                                let _e1345 = core_intrinsics_maximum_number_nsz_f32_((_e1323 - _e312), (_e1326 - _e313));
                                                let _e1346 = core_intrinsics_maximum_number_nsz_f32_(_e1345, (_e1329 - _e314));
                                                let _e1347 = core_intrinsics_minimum_number_nsz_f32_((_e1335 + _e312), (_e1338 + _e313));
                                                let _e1348 = core_intrinsics_minimum_number_nsz_f32_(_e1347, (_e1341 + _e314));
                                                if (_e1346 > -300000000000000000000000000000000000000f) {
                                                    phi_1537_ = _e1346;
                                                } else {
                                                    phi_1537_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1351 = phi_1537_;
                                                if (_e1348 < 300000000000000000000000000000000000000f) {
                                                    phi_1542_ = _e1348;
                                                } else {
                                                    phi_1542_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1354 = phi_1542_;
                                                if (_e1222 < _e1351) {
                                                    phi_1547_ = _e1351;
                                                } else {
                                                    phi_1547_ = _e1222;
                                                }
                                                let _e1357 = phi_1547_;
                                                if (_e1357 > _e1354) {
                                                    phi_1552_ = _e1354;
                                                } else {
                                                    phi_1552_ = _e1357;
                                                }
                                                let _e1360 = phi_1552_;
                                                phi_1557_ = lt_bvh_triangle_Intersection(_e1360, (_e1063 / _e1122), (_e1084 / _e1122), (_e1351 <= _e1354));
                                                phi_1558_ = false;
                                            } else {
                                                phi_1557_ = lt_bvh_triangle_Intersection();
                                                phi_1558_ = true;
                                            }
                                            let _e1366 = phi_1557_;
                                            let _e1368 = phi_1558_;
                                            phi_1559_ = _e1366;
                                            phi_1560_ = _e1368;
                                        } else {
                                            phi_1559_ = lt_bvh_triangle_Intersection();
                                            phi_1560_ = true;
                                        }
                                        let _e1370 = phi_1559_;
                                        let _e1372 = phi_1560_;
                                        if _e1372 {
                                        }
                                        phi_1564_ = _e1370;
                                        phi_1565_ = _e1372;
                                    }
                                    let _e1374 = phi_1564_;
                                    let _e1376 = phi_1565_;
                                    phi_1566_ = _e1374;
                                    phi_1567_ = _e1125;
                                    phi_1568_ = _e1376;
                                } else {
                                    phi_1566_ = lt_bvh_triangle_Intersection();
                                    phi_1567_ = true;
                                    phi_1568_ = false;
                                }
                                let _e1378 = phi_1566_;
                                let _e1380 = phi_1567_;
                                let _e1382 = phi_1568_;
                                if _e1380 {
                                    phi_1572_ = true;
                                } else {
                                    phi_1572_ = _e1382;
                                }
                                let _e1384 = phi_1572_;
                                if _e1384 {
                                    phi_1576_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1576_ = _e1378;
                                }
                                let _e1386 = phi_1576_;
                                if _e1386.is_hit {
                                    if (_e1386.t > 0f) {
                                        if (_e1386.t < _e108) {
                                            let _e1393 = triangles.member[(0u + _e938)].i0_;
                                            let _e1395 = ((_e1393 & 2147483648u) == 0u);
                                            if _e1395 {
                                                phi_1602_ = false;
                                                phi_1603_ = false;
                                            } else {
                                                if true {
                                                    phi_1601_ = false;
                                                } else {
                                                    phi_1601_ = true;
                                                }
                                                let _e1397 = phi_1601_;
                                                phi_1602_ = _e1397;
                                                phi_1603_ = true;
                                            }
                                            let _e1399 = phi_1602_;
                                            let _e1401 = phi_1603_;
                                            phi_1604_ = _e1399;
                                            phi_1605_ = _e1395;
                                            phi_1606_ = _e1401;
                                        } else {
                                            phi_1604_ = true;
                                            phi_1605_ = false;
                                            phi_1606_ = false;
                                        }
                                        let _e1403 = phi_1604_;
                                        let _e1405 = phi_1605_;
                                        let _e1407 = phi_1606_;
                                        phi_1607_ = _e1403;
                                        phi_1608_ = _e1405;
                                        phi_1609_ = _e1407;
                                    } else {
                                        phi_1607_ = true;
                                        phi_1608_ = false;
                                        phi_1609_ = false;
                                    }
                                    let _e1409 = phi_1607_;
                                    let _e1411 = phi_1608_;
                                    let _e1413 = phi_1609_;
                                    phi_1610_ = _e1409;
                                    phi_1611_ = _e1411;
                                    phi_1612_ = _e1413;
                                } else {
                                    phi_1610_ = true;
                                    phi_1611_ = false;
                                    phi_1612_ = false;
                                }
                                let _e1415 = phi_1610_;
                                let _e1417 = phi_1611_;
                                let _e1419 = phi_1612_;
                                if _e1415 {
                                    phi_1616_ = false;
                                    phi_1617_ = false;
                                } else {
                                    phi_1616_ = _e1417;
                                    phi_1617_ = _e1419;
                                }
                                let _e1421 = phi_1616_;
                                let _e1423 = phi_1617_;
                                phi_1008_ = (_e929 & (_e929 - 1u));
                                phi_1618_ = _e1415;
                                phi_1619_ = _e1421;
                                phi_1620_ = _e1423;
                            }
                            let _e1425 = phi_1008_;
                            let _e1427 = phi_1618_;
                            let _e1429 = phi_1619_;
                            let _e1431 = phi_1620_;
                            local_6 = _e1429;
                            local_7 = _e1431;
                            continue;
                            continuing {
                                phi_1007_ = _e1425;
                                break if !(_e1427);
                            }
                        }
                        let _e1434 = local_4;
                        if _e1434 {
                            let _e1436 = local.group_mask;
                            if ((_e1436 & 4278190080u) == 0u) {
                                let _e1440 = local.len;
                                if (_e1440 == 0u) {
                                    phi_1662_ = false;
                                } else {
                                    let _e1444 = local.len;
                                    local.len = (_e1444 - 1u);
                                    let _e1447 = local.len;
                                    if (_e1447 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1452 = local.first[(0u + _e1447)];
                                    local.group = _e1452;
                                    let _e1455 = local.len;
                                    if (_e1455 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1460 = local.mask[(0u + _e1455)];
                                    local.group_mask = _e1460;
                                    phi_1662_ = true;
                                }
                                let _e1463 = phi_1662_;
                                phi_1663_ = _e1463;
                            } else {
                                phi_1663_ = true;
                            }
                            let _e1465 = phi_1663_;
                            if _e1465 {
                                let _e1467 = local.group_mask;
                                let _e1473 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1467)), 32u, (_e1467 == 0u)));
                                let _e1477 = local.group_mask;
                                let _e1491 = local.group_mask;
                                local.group_mask = (_e1491 & ~((1u << bitcast<u32>((_e1473 & 31u)))));
                                let _e1494 = local.group;
                                phi_1694_ = (_e1494 + countOneBits(((_e1477 & ~((4294967295u << bitcast<u32>((((_e1473 - 24u) ^ _e355) & 31u))))) & 255u)));
                            } else {
                                phi_1694_ = 4294967295u;
                            }
                            let _e1497 = phi_1694_;
                            phi_1695_ = _e1497;
                            phi_1696_ = false;
                            phi_1697_ = false;
                        } else {
                            phi_1695_ = u32();
                            let _e1712 = local_6;
                            phi_1696_ = _e1712;
                            let _e1715 = local_7;
                            phi_1697_ = _e1715;
                        }
                        let _e1499 = phi_1695_;
                        let _e1501 = phi_1696_;
                        let _e1503 = phi_1697_;
                        phi_678_ = _e1499;
                        let _e1719 = local_8;
                        phi_1698_ = _e1719;
                        phi_1699_ = false;
                        phi_1700_ = _e1501;
                        phi_1701_ = _e1503;
                    } else {
                        phi_678_ = u32();
                        phi_1698_ = false;
                        phi_1699_ = true;
                        phi_1700_ = false;
                        phi_1701_ = false;
                    }
                    let _e1505 = phi_678_;
                    let _e1507 = phi_1698_;
                    let _e1509 = phi_1699_;
                    let _e1511 = phi_1700_;
                    let _e1513 = phi_1701_;
                    local_5 = _e1509;
                    local_9 = _e1511;
                    local_10 = _e1513;
                    continue;
                    continuing {
                        phi_677_ = _e1505;
                        break if !(_e1507);
                    }
                }
                let _e1516 = local_5;
                if _e1516 {
                    phi_1705_ = false;
                    phi_1706_ = false;
                } else {
                    let _e1726 = local_9;
                    phi_1705_ = _e1726;
                    let _e1729 = local_10;
                    phi_1706_ = _e1729;
                }
                let _e1518 = phi_1705_;
                let _e1520 = phi_1706_;
                if _e1518 {
                    phi_1710_ = true;
                } else {
                    phi_1710_ = _e1520;
                }
                let _e1522 = phi_1710_;
                if _e1522 {
                    phi_1714_ = true;
                } else {
                    phi_1714_ = false;
                }
                let _e1524 = phi_1714_;
                phi_1715_ = _e1524;
            }
            let _e1526 = phi_1715_;
            phi_1716_ = _e1526;
            phi_1717_ = _e181;
        } else {
            phi_1716_ = bool();
            phi_1717_ = true;
        }
        let _e1528 = phi_1716_;
        let _e1530 = phi_1717_;
        if _e1530 {
            phi_1721_ = false;
        } else {
            phi_1721_ = _e1528;
        }
        let _e1532 = phi_1721_;
        if _e1532 {
            phi_1725_ = 0f;
        } else {
            phi_1725_ = 1f;
        }
        let _e1534 = phi_1725_;
        if (_e79 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79)] = _e1534;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
