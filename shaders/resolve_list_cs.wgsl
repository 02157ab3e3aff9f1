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

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_145_: bool;
    var phi_149_: f32;

    if (param != param) {
        phi_145_ = true;
    } else {
        let _e52 = (param_1 >= param);
        if _e52 {
        }
        phi_145_ = _e52;
    }
    let _e54 = phi_145_;
    if _e54 {
        phi_149_ = param_1;
    } else {
        phi_149_ = param;
    }
    let _e56 = phi_149_;
    return _e56;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_161_: bool;
    var phi_165_: f32;

    if (param_2 != param_2) {
        phi_161_ = true;
    } else {
        let _e52 = (param_3 <= param_2);
        if _e52 {
        }
        phi_161_ = _e52;
    }
    let _e54 = phi_161_;
    if _e54 {
        phi_165_ = param_3;
    } else {
        phi_165_ = param_2;
    }
    let _e56 = phi_165_;
    return _e56;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_239_: f32;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
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
    var phi_317_: bool;
    var phi_321_: bool;
    var phi_325_: bool;
    var phi_395_: f32;
    var phi_402_: f32;
    var phi_409_: f32;
    var phi_416_: f32;
    var phi_423_: f32;
    var phi_430_: f32;
    var phi_447_: f32;
    var phi_452_: f32;
    var phi_457_: f32;
    var phi_485_: bool;
    var phi_486_: bool;
    var phi_494_: u32;
    var phi_495_: u32;
    var phi_506_: vec3<f32>;
    var phi_507_: vec3<f32>;
    var phi_520_: u32;
    var phi_525_: u32;
    var phi_530_: u32;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_676_: u32;
    var phi_678_: u32;
    var phi_759_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_786_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_813_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_819_: u32;
    var phi_822_: u32;
    var phi_836_: u32;
    var phi_846_: u32;
    var phi_856_: u32;
    var phi_874_: u32;
    var phi_884_: u32;
    var phi_894_: u32;
    var phi_930_: u32;
    var phi_943_: u32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_820_: u32;
    var phi_823_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1008_: u32;
    var phi_1053_: vec3<f32>;
    var phi_1054_: vec3<f32>;
    var phi_1085_: vec3<f32>;
    var phi_1086_: vec3<f32>;
    var phi_1117_: vec3<f32>;
    var phi_1118_: vec3<f32>;
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
    var phi_1289_: f32;
    var phi_1298_: f32;
    var phi_1307_: f32;
    var phi_1316_: f32;
    var phi_1323_: f32;
    var phi_1330_: f32;
    var phi_1343_: f32;
    var phi_1352_: f32;
    var phi_1361_: f32;
    var phi_1370_: f32;
    var phi_1377_: f32;
    var phi_1384_: f32;
    var phi_1401_: f32;
    var phi_1406_: f32;
    var phi_1411_: f32;
    var phi_1419_: f32;
    var phi_1424_: f32;
    var phi_1429_: f32;
    var phi_1441_: f32;
    var phi_1446_: f32;
    var phi_1451_: f32;
    var phi_1456_: f32;
    var phi_1461_: lt_bvh_triangle_Intersection;
    var phi_1462_: bool;
    var phi_1463_: lt_bvh_triangle_Intersection;
    var phi_1464_: bool;
    var phi_1468_: lt_bvh_triangle_Intersection;
    var phi_1469_: bool;
    var phi_1470_: lt_bvh_triangle_Intersection;
    var phi_1471_: bool;
    var phi_1472_: bool;
    var phi_1476_: bool;
    var phi_1480_: lt_bvh_triangle_Intersection;
    var phi_1505_: bool;
    var phi_1506_: bool;
    var phi_1507_: bool;
    var phi_1508_: bool;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1511_: bool;
    var phi_1512_: bool;
    var phi_1513_: bool;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1516_: bool;
    var phi_1520_: bool;
    var phi_1521_: bool;
    var phi_1009_: u32;
    var phi_1522_: bool;
    var phi_1523_: bool;
    var phi_1524_: bool;
    var local_4: bool;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1598_: u32;
    var phi_1599_: u32;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_679_: u32;
    var phi_1602_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var local_5: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1614_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1625_: bool;
    var phi_1629_: f32;
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
            phi_239_ = 300000000000000000000000000000000000000f;
        } else {
            phi_239_ = 1f;
        }
        let _e108 = phi_239_;
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
                                    phi_295_ = bool();
                                    phi_296_ = true;
                                } else {
                                    let _e133 = (_e124 > 0f);
                                    if _e133 {
                                        phi_294_ = bool();
                                    } else {
                                        phi_294_ = (_e125 > 0f);
                                    }
                                    let _e136 = phi_294_;
                                    phi_295_ = _e136;
                                    phi_296_ = _e133;
                                }
                                let _e138 = phi_295_;
                                let _e140 = phi_296_;
                                if _e140 {
                                    phi_300_ = true;
                                } else {
                                    phi_300_ = _e138;
                                }
                                let _e142 = phi_300_;
                                phi_301_ = _e142;
                                phi_302_ = false;
                            } else {
                                phi_301_ = bool();
                                phi_302_ = true;
                            }
                            let _e144 = phi_301_;
                            let _e146 = phi_302_;
                            phi_303_ = _e144;
                            phi_304_ = false;
                            phi_305_ = _e146;
                        } else {
                            phi_303_ = bool();
                            phi_304_ = true;
                            phi_305_ = false;
                        }
                        let _e148 = phi_303_;
                        let _e150 = phi_304_;
                        let _e152 = phi_305_;
                        phi_306_ = _e148;
                        phi_307_ = _e150;
                        phi_308_ = _e152;
                    } else {
                        phi_306_ = bool();
                        phi_307_ = true;
                        phi_308_ = false;
                    }
                    let _e154 = phi_306_;
                    let _e156 = phi_307_;
                    let _e158 = phi_308_;
                    phi_309_ = _e154;
                    phi_310_ = _e156;
                    phi_311_ = _e158;
                } else {
                    phi_309_ = bool();
                    phi_310_ = true;
                    phi_311_ = false;
                }
                let _e160 = phi_309_;
                let _e162 = phi_310_;
                let _e164 = phi_311_;
                phi_312_ = _e160;
                phi_313_ = _e162;
                phi_314_ = _e164;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
                phi_314_ = false;
            }
            let _e166 = phi_312_;
            let _e168 = phi_313_;
            let _e170 = phi_314_;
            phi_315_ = _e166;
            phi_316_ = _e168;
            phi_317_ = _e170;
        } else {
            phi_315_ = bool();
            phi_316_ = true;
            phi_317_ = false;
        }
        let _e172 = phi_315_;
        let _e174 = phi_316_;
        let _e176 = phi_317_;
        if _e174 {
            phi_321_ = true;
        } else {
            phi_321_ = _e176;
        }
        let _e178 = phi_321_;
        if _e178 {
            phi_325_ = false;
        } else {
            phi_325_ = _e172;
        }
        let _e180 = phi_325_;
        if _e180 {
            let _e181 = (0u >= _e57);
            if _e181 {
                phi_1619_ = bool();
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
                    phi_395_ = _e247;
                } else {
                    phi_395_ = abs(_e116);
                }
                let _e252 = phi_395_;
                if (_e116 < 0f) {
                    phi_402_ = (-1f / _e252);
                } else {
                    phi_402_ = (1f / _e252);
                }
                let _e257 = phi_402_;
                if (abs(_e117) < _e247) {
                    phi_409_ = _e247;
                } else {
                    phi_409_ = abs(_e117);
                }
                let _e262 = phi_409_;
                if (_e117 < 0f) {
                    phi_416_ = (-1f / _e262);
                } else {
                    phi_416_ = (1f / _e262);
                }
                let _e267 = phi_416_;
                if (abs(_e118) < _e247) {
                    phi_423_ = _e247;
                } else {
                    phi_423_ = abs(_e118);
                }
                let _e272 = phi_423_;
                if (_e118 < 0f) {
                    phi_430_ = (-1f / _e272);
                } else {
                    phi_430_ = (1f / _e272);
                }
                let _e277 = phi_430_;
                let _e281 = abs((bitcast<f32>(_e187) - _e100));
                let _e282 = abs((bitcast<f32>(_e191) - _e102));
                let _e283 = abs((bitcast<f32>(_e195) - _e104));
                let _e287 = abs(((bitcast<f32>(_e199) + (bitcast<f32>((((_e211 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e100));
                let _e288 = abs(((bitcast<f32>(_e203) + (bitcast<f32>((((_e211 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e102));
                let _e289 = abs(((bitcast<f32>(_e207) + (bitcast<f32>((((_e211 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e104));
                if (_e281 > _e287) {
                    phi_447_ = _e281;
                } else {
                    phi_447_ = _e287;
                }
                let _e292 = phi_447_;
                if (_e282 > _e288) {
                    phi_452_ = _e282;
                } else {
                    phi_452_ = _e288;
                }
                let _e295 = phi_452_;
                if (_e283 > _e289) {
                    phi_457_ = _e283;
                } else {
                    phi_457_ = _e289;
                }
                let _e298 = phi_457_;
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
                        phi_485_ = false;
                    } else {
                        phi_485_ = true;
                    }
                    let _e321 = phi_485_;
                    phi_486_ = _e321;
                } else {
                    phi_486_ = true;
                }
                let _e323 = phi_486_;
                if _e323 {
                    if (_e316 >= _e317) {
                        phi_494_ = 1u;
                    } else {
                        phi_494_ = 2u;
                    }
                    let _e326 = phi_494_;
                    phi_495_ = _e326;
                } else {
                    phi_495_ = 0u;
                }
                let _e328 = phi_495_;
                if (_e328 == 0u) {
                    phi_507_ = vec3<f32>(_e117, _e118, _e116);
                } else {
                    if (_e328 == 1u) {
                        phi_506_ = vec3<f32>(_e118, _e116, _e117);
                    } else {
                        phi_506_ = vec3<f32>(_e116, _e117, _e118);
                    }
                    let _e334 = phi_506_;
                    phi_507_ = _e334;
                }
                let _e336 = phi_507_;
                let _e339 = (_e336.x / _e336.z);
                let _e342 = (_e336.y / _e336.z);
                let _e344 = (1f / _e336.z);
                if (_e257 < 0f) {
                    phi_520_ = 0u;
                } else {
                    phi_520_ = 1u;
                }
                let _e347 = phi_520_;
                if (_e267 < 0f) {
                    phi_525_ = 0u;
                } else {
                    phi_525_ = 2u;
                }
                let _e350 = phi_525_;
                if (_e277 < 0f) {
                    phi_530_ = 0u;
                } else {
                    phi_530_ = 4u;
                }
                let _e353 = phi_530_;
                let _e355 = ((_e347 | _e350) | _e353);
                let _e356 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e356.first[0], _e356.first[1], _e356.first[2], _e356.first[3], _e356.first[4], _e356.first[5], _e356.first[6], _e356.first[7], _e356.first[8], _e356.first[9], _e356.first[10], _e356.first[11], _e356.first[12], _e356.first[13], _e356.first[14], _e356.first[15], _e356.first[16], _e356.first[17], _e356.first[18], _e356.first[19], _e356.first[20], _e356.first[21], _e356.first[22], _e356.first[23], _e356.first[24], _e356.first[25], _e356.first[26], _e356.first[27], _e356.first[28], _e356.first[29], _e356.first[30], _e356.first[31]), array<u32, 32>(_e356.mask[0], _e356.mask[1], _e356.mask[2], _e356.mask[3], _e356.mask[4], _e356.mask[5], _e356.mask[6], _e356.mask[7], _e356.mask[8], _e356.mask[9], _e356.mask[10], _e356.mask[11], _e356.mask[12], _e356.mask[13], _e356.mask[14], _e356.mask[15], _e356.mask[16], _e356.mask[17], _e356.mask[18], _e356.mask[19], _e356.mask[20], _e356.mask[21], _e356.mask[22], _e356.mask[23], _e356.mask[24], _e356.mask[25], _e356.mask[26], _e356.mask[27], _e356.mask[28], _e356.mask[29], _e356.mask[30], _e356.mask[31]), _e356.len, _e356.group, _e356.group_mask);
                let _e430 = local.group_mask;
                if ((_e430 & 4278190080u) == 0u) {
                    let _e434 = local.len;
                    if (_e434 == 0u) {
                        phi_644_ = false;
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
                        phi_644_ = true;
                    }
                    let _e457 = phi_644_;
                    phi_645_ = _e457;
                } else {
                    phi_645_ = true;
                }
                let _e459 = phi_645_;
                if _e459 {
                    let _e461 = local.group_mask;
                    let _e467 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e461)), 32u, (_e461 == 0u)));
                    let _e471 = local.group_mask;
                    let _e485 = local.group_mask;
                    local.group_mask = (_e485 & ~((1u << bitcast<u32>((_e467 & 31u)))));
                    let _e488 = local.group;
                    phi_676_ = (_e488 + countOneBits(((_e471 & ~((4294967295u << bitcast<u32>((((_e467 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_676_ = 4294967295u;
                }
                let _e491 = phi_676_;
                phi_678_ = _e491;
                loop {
                    let _e493 = phi_678_;
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
                            phi_759_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e576.unnamed_1.root, _e553.y));
                        } else {
                            let _e592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e553.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e592.unnamed.root, _e553.y), _e592.unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e598.unnamed, lt_bvh_traverse_Tree(_e553.z, _e598.unnamed_1.first_primitive));
                            phi_759_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e604.unnamed_1.root, _e553.w));
                        }
                        let _e612 = phi_759_;
                        let _e622 = nodes.member[(0u + _e493)].y;
                        if (_e267 < 0f) {
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e622.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.unnamed.root, _e622.w), _e633.unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e639.unnamed, lt_bvh_traverse_Tree(_e622.x, _e639.unnamed_1.first_primitive));
                            phi_786_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e645.unnamed_1.root, _e622.y));
                        } else {
                            let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e622.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e661.unnamed.root, _e622.y), _e661.unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e667.unnamed, lt_bvh_traverse_Tree(_e622.z, _e667.unnamed_1.first_primitive));
                            phi_786_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e673.unnamed_1.root, _e622.w));
                        }
                        let _e681 = phi_786_;
                        let _e691 = nodes.member[(0u + _e493)].z;
                        if (_e277 < 0f) {
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e691.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.unnamed.root, _e691.w), _e702.unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e708.unnamed, lt_bvh_traverse_Tree(_e691.x, _e708.unnamed_1.first_primitive));
                            phi_813_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e714.unnamed_1.root, _e691.y));
                        } else {
                            let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e691.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e730.unnamed.root, _e691.y), _e730.unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_bvh_traverse_Tree(_e691.z, _e736.unnamed_1.first_primitive));
                            phi_813_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e742.unnamed_1.root, _e691.w));
                        }
                        let _e750 = phi_813_;
                        phi_819_ = 0u;
                        phi_822_ = 0u;
                        loop {
                            let _e760 = phi_819_;
                            let _e762 = phi_822_;
                            local_1 = _e762;
                            local_2 = _e762;
                            local_3 = _e762;
                            let _e763 = (_e760 < 8u);
                            if _e763 {
                                let _e765 = (_e760 >> bitcast<u32>(2i));
                                let _e766 = (_e760 & 3u);
                                if (_e765 == 0u) {
                                    phi_836_ = _e612.unnamed.root;
                                } else {
                                    phi_836_ = _e612.unnamed.first_primitive;
                                }
                                let _e769 = phi_836_;
                                if (_e765 == 0u) {
                                    phi_846_ = _e681.unnamed.root;
                                } else {
                                    phi_846_ = _e681.unnamed.first_primitive;
                                }
                                let _e778 = phi_846_;
                                if (_e765 == 0u) {
                                    phi_856_ = _e750.unnamed.root;
                                } else {
                                    phi_856_ = _e750.unnamed.first_primitive;
                                }
                                let _e787 = phi_856_;
                                let _e800 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e769 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e525) + (_e543 - _e305)), ((f32(((_e778 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e306)));
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(_e800, ((f32(((_e787 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e307)));
                                if (_e765 == 0u) {
                                    phi_874_ = _e612.unnamed_1.root;
                                } else {
                                    phi_874_ = _e612.unnamed_1.first_primitive;
                                }
                                let _e804 = phi_874_;
                                if (_e765 == 0u) {
                                    phi_884_ = _e681.unnamed_1.root;
                                } else {
                                    phi_884_ = _e681.unnamed_1.first_primitive;
                                }
                                let _e813 = phi_884_;
                                if (_e765 == 0u) {
                                    phi_894_ = _e750.unnamed_1.root;
                                } else {
                                    phi_894_ = _e750.unnamed_1.first_primitive;
                                }
                                let _e822 = phi_894_;
                                let _e835 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e804 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e525) + (_e543 + _e305)), ((f32(((_e813 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e306)));
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(_e835, ((f32(((_e822 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e307)));
                                if (_e801 <= _e836) {
                                    if (_e801 <= _e108) {
                                        if (_e836 >= 0f) {
                                            if (_e765 == 0u) {
                                                let _e843 = nodes.member[(0u + _e493)].links[2u];
                                                phi_930_ = _e843;
                                            } else {
                                                let _e846 = nodes.member[(0u + _e493)].links[3u];
                                                phi_930_ = _e846;
                                            }
                                            let _e848 = phi_930_;
                                            let _e853 = ((_e848 >> bitcast<u32>(((_e766 * 8u) & 31u))) & 255u);
                                            let _e854 = (_e853 & 31u);
                                            if (_e854 >= 24u) {
                                                phi_943_ = (24u + ((_e854 - 24u) ^ _e355));
                                            } else {
                                                phi_943_ = _e854;
                                            }
                                            let _e860 = phi_943_;
                                            phi_948_ = (_e762 | ((_e853 >> bitcast<u32>(5i)) << bitcast<u32>((_e860 & 31u))));
                                        } else {
                                            phi_948_ = _e762;
                                        }
                                        let _e868 = phi_948_;
                                        phi_949_ = _e868;
                                    } else {
                                        phi_949_ = _e762;
                                    }
                                    let _e870 = phi_949_;
                                    phi_950_ = _e870;
                                } else {
                                    phi_950_ = _e762;
                                }
                                let _e872 = phi_950_;
                                phi_820_ = (_e760 + 1u);
                                phi_823_ = _e872;
                            } else {
                                phi_820_ = u32();
                                phi_823_ = u32();
                            }
                            let _e875 = phi_820_;
                            let _e877 = phi_823_;
                            continue;
                            continuing {
                                phi_819_ = _e875;
                                phi_822_ = _e877;
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
                        phi_1008_ = (_e926 & 16777215u);
                        loop {
                            let _e929 = phi_1008_;
                            let _e930 = (_e929 == 0u);
                            local_4 = _e930;
                            local_8 = _e930;
                            if _e930 {
                                phi_1009_ = u32();
                                phi_1522_ = false;
                                phi_1523_ = false;
                                phi_1524_ = false;
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
                                    phi_1054_ = vec3<f32>(_e949, _e951, _e947);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1053_ = vec3<f32>(_e951, _e947, _e949);
                                    } else {
                                        phi_1053_ = (_e945 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e959 = phi_1053_;
                                    phi_1054_ = _e959;
                                }
                                let _e961 = phi_1054_;
                                let _e965 = (_e961.x - (_e339 * _e961.z));
                                let _e969 = (_e961.y - (_e342 * _e961.z));
                                let _e973 = triangles.member[(0u + _e938)].v1_;
                                let _e975 = (_e973.x - _e100);
                                let _e977 = (_e973.y - _e102);
                                let _e979 = (_e973.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1086_ = vec3<f32>(_e977, _e979, _e975);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1085_ = vec3<f32>(_e979, _e975, _e977);
                                    } else {
                                        phi_1085_ = (_e973 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e987 = phi_1085_;
                                    phi_1086_ = _e987;
                                }
                                let _e989 = phi_1086_;
                                let _e993 = (_e989.x - (_e339 * _e989.z));
                                let _e997 = (_e989.y - (_e342 * _e989.z));
                                let _e1001 = triangles.member[(0u + _e938)].v2_;
                                let _e1003 = (_e1001.x - _e100);
                                let _e1005 = (_e1001.y - _e102);
                                let _e1007 = (_e1001.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1118_ = vec3<f32>(_e1005, _e1007, _e1003);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1117_ = vec3<f32>(_e1007, _e1003, _e1005);
                                    } else {
                                        phi_1117_ = (_e1001 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e1015 = phi_1117_;
                                    phi_1118_ = _e1015;
                                }
                                let _e1017 = phi_1118_;
                                let _e1021 = (_e1017.x - (_e339 * _e1017.z));
                                let _e1025 = (_e1017.y - (_e342 * _e1017.z));
                                if (_e993 < _e1021) {
                                    phi_1139_ = true;
                                } else {
                                    if (_e993 == _e1021) {
                                        phi_1138_ = (_e997 < _e1025);
                                    } else {
                                        phi_1138_ = false;
                                    }
                                    let _e1032 = phi_1138_;
                                    phi_1139_ = _e1032;
                                }
                                let _e1034 = phi_1139_;
                                if _e1034 {
                                    phi_1143_ = _e1025;
                                    phi_1144_ = _e1021;
                                    phi_1145_ = _e997;
                                    phi_1146_ = _e993;
                                } else {
                                    phi_1143_ = _e997;
                                    phi_1144_ = _e993;
                                    phi_1145_ = _e1025;
                                    phi_1146_ = _e1021;
                                }
                                let _e1036 = phi_1143_;
                                let _e1038 = phi_1144_;
                                let _e1040 = phi_1145_;
                                let _e1042 = phi_1146_;
                                let _e1045 = ((_e1042 * _e1036) - (_e1040 * _e1038));
                                if _e1034 {
                                    phi_1154_ = -(_e1045);
                                } else {
                                    phi_1154_ = _e1045;
                                }
                                let _e1048 = phi_1154_;
                                if (_e1021 < _e965) {
                                    phi_1165_ = true;
                                } else {
                                    if (_e1021 == _e965) {
                                        phi_1164_ = (_e1025 < _e969);
                                    } else {
                                        phi_1164_ = false;
                                    }
                                    let _e1053 = phi_1164_;
                                    phi_1165_ = _e1053;
                                }
                                let _e1055 = phi_1165_;
                                if _e1055 {
                                    phi_1169_ = _e969;
                                    phi_1170_ = _e965;
                                    phi_1171_ = _e1025;
                                    phi_1172_ = _e1021;
                                } else {
                                    phi_1169_ = _e1025;
                                    phi_1170_ = _e1021;
                                    phi_1171_ = _e969;
                                    phi_1172_ = _e965;
                                }
                                let _e1057 = phi_1169_;
                                let _e1059 = phi_1170_;
                                let _e1061 = phi_1171_;
                                let _e1063 = phi_1172_;
                                let _e1066 = ((_e1063 * _e1057) - (_e1061 * _e1059));
                                if _e1055 {
                                    phi_1180_ = -(_e1066);
                                } else {
                                    phi_1180_ = _e1066;
                                }
                                let _e1069 = phi_1180_;
                                if (_e965 < _e993) {
                                    phi_1191_ = true;
                                } else {
                                    if (_e965 == _e993) {
                                        phi_1190_ = (_e969 < _e997);
                                    } else {
                                        phi_1190_ = false;
                                    }
                                    let _e1074 = phi_1190_;
                                    phi_1191_ = _e1074;
                                }
                                let _e1076 = phi_1191_;
                                if _e1076 {
                                    phi_1195_ = _e997;
                                    phi_1196_ = _e993;
                                    phi_1197_ = _e969;
                                    phi_1198_ = _e965;
                                } else {
                                    phi_1195_ = _e969;
                                    phi_1196_ = _e965;
                                    phi_1197_ = _e997;
                                    phi_1198_ = _e993;
                                }
                                let _e1078 = phi_1195_;
                                let _e1080 = phi_1196_;
                                let _e1082 = phi_1197_;
                                let _e1084 = phi_1198_;
                                let _e1087 = ((_e1084 * _e1078) - (_e1082 * _e1080));
                                if _e1076 {
                                    phi_1206_ = -(_e1087);
                                } else {
                                    phi_1206_ = _e1087;
                                }
                                let _e1090 = phi_1206_;
                                if (_e1048 >= 0f) {
                                    if (_e1069 >= 0f) {
                                        if (_e1090 >= 0f) {
                                            phi_1221_ = ((_e1048 + _e1069) + _e1090);
                                            phi_1222_ = false;
                                        } else {
                                            phi_1221_ = f32();
                                            phi_1222_ = true;
                                        }
                                        let _e1097 = phi_1221_;
                                        let _e1099 = phi_1222_;
                                        phi_1223_ = _e1097;
                                        phi_1224_ = _e1099;
                                    } else {
                                        phi_1223_ = f32();
                                        phi_1224_ = true;
                                    }
                                    let _e1101 = phi_1223_;
                                    let _e1103 = phi_1224_;
                                    phi_1225_ = _e1101;
                                    phi_1226_ = _e1103;
                                } else {
                                    phi_1225_ = f32();
                                    phi_1226_ = true;
                                }
                                let _e1105 = phi_1225_;
                                let _e1107 = phi_1226_;
                                if _e1107 {
                                    if (_e1048 <= 0f) {
                                        if (_e1069 <= 0f) {
                                            let _e1110 = (_e1090 <= 0f);
                                            if _e1110 {
                                            }
                                            phi_1244_ = ((_e1048 + _e1069) + _e1090);
                                            phi_1245_ = false;
                                            phi_1246_ = _e1110;
                                        } else {
                                            phi_1244_ = f32();
                                            phi_1245_ = true;
                                            phi_1246_ = false;
                                        }
                                        let _e1114 = phi_1244_;
                                        let _e1116 = phi_1245_;
                                        let _e1118 = phi_1246_;
                                        phi_1247_ = _e1114;
                                        phi_1248_ = _e1116;
                                        phi_1249_ = _e1118;
                                    } else {
                                        phi_1247_ = f32();
                                        phi_1248_ = true;
                                        phi_1249_ = false;
                                    }
                                    let _e1120 = phi_1247_;
                                    let _e1122 = phi_1248_;
                                    let _e1124 = phi_1249_;
                                    if _e1122 {
                                        phi_1253_ = false;
                                    } else {
                                        phi_1253_ = _e1124;
                                    }
                                    let _e1126 = phi_1253_;
                                    phi_1254_ = _e1120;
                                    phi_1255_ = _e1126;
                                } else {
                                    phi_1254_ = _e1105;
                                    phi_1255_ = true;
                                }
                                let _e1128 = phi_1254_;
                                let _e1130 = phi_1255_;
                                if _e1130 {
                                    let _e1131 = (_e1128 == 0f);
                                    if _e1131 {
                                        phi_1468_ = lt_bvh_triangle_Intersection();
                                        phi_1469_ = false;
                                    } else {
                                        let _e1137 = ((((_e1048 * (_e344 * _e961.z)) + (_e1069 * (_e344 * _e989.z))) + (_e1090 * (_e344 * _e1017.z))) / _e1128);
                                        if (_e1137 > 0f) {
                                            if (_e1137 < _e108) {
                                                let _e1141 = triangles.member[(0u + _e938)].v0_;
                                                let _e1143 = triangles.member[(0u + _e938)].v1_;
                                                if (_e1141.x < _e1143.x) {
                                                    phi_1289_ = _e1141.x;
                                                } else {
                                                    phi_1289_ = _e1143.x;
                                                }
                                                let _e1150 = phi_1289_;
                                                if (_e1141.y < _e1143.y) {
                                                    phi_1298_ = _e1141.y;
                                                } else {
                                                    phi_1298_ = _e1143.y;
                                                }
                                                let _e1157 = phi_1298_;
                                                if (_e1141.z < _e1143.z) {
                                                    phi_1307_ = _e1141.z;
                                                } else {
                                                    phi_1307_ = _e1143.z;
                                                }
                                                let _e1164 = phi_1307_;
                                                let _e1166 = triangles.member[(0u + _e938)].v2_;
                                                if (_e1150 < _e1166.x) {
                                                    phi_1316_ = _e1150;
                                                } else {
                                                    phi_1316_ = _e1166.x;
                                                }
                                                let _e1171 = phi_1316_;
                                                if (_e1157 < _e1166.y) {
                                                    phi_1323_ = _e1157;
                                                } else {
                                                    phi_1323_ = _e1166.y;
                                                }
                                                let _e1176 = phi_1323_;
                                                if (_e1164 < _e1166.z) {
                                                    phi_1330_ = _e1164;
                                                } else {
                                                    phi_1330_ = _e1166.z;
                                                }
                                                let _e1181 = phi_1330_;
                                                let _e1183 = triangles.member[(0u + _e938)].v0_;
                                                let _e1185 = triangles.member[(0u + _e938)].v1_;
                                                if (_e1183.x > _e1185.x) {
                                                    phi_1343_ = _e1183.x;
                                                } else {
                                                    phi_1343_ = _e1185.x;
                                                }
                                                let _e1192 = phi_1343_;
                                                if (_e1183.y > _e1185.y) {
                                                    phi_1352_ = _e1183.y;
                                                } else {
                                                    phi_1352_ = _e1185.y;
                                                }
                                                let _e1199 = phi_1352_;
                                                if (_e1183.z > _e1185.z) {
                                                    phi_1361_ = _e1183.z;
                                                } else {
                                                    phi_1361_ = _e1185.z;
                                                }
                                                let _e1206 = phi_1361_;
                                                let _e1208 = triangles.member[(0u + _e938)].v2_;
                                                if (_e1192 > _e1208.x) {
                                                    phi_1370_ = _e1192;
                                                } else {
                                                    phi_1370_ = _e1208.x;
                                                }
                                                let _e1213 = phi_1370_;
                                                if (_e1199 > _e1208.y) {
                                                    phi_1377_ = _e1199;
                                                } else {
                                                    phi_1377_ = _e1208.y;
                                                }
                                                let _e1218 = phi_1377_;
                                                if (_e1206 > _e1208.z) {
                                                    phi_1384_ = _e1206;
                                                } else {
                                                    phi_1384_ = _e1208.z;
                                                }
                                                let _e1223 = phi_1384_;
                                                let _e1227 = ((_e1171 - _e100) * _e257);
                                                let _e1228 = ((_e1176 - _e102) * _e267);
                                                let _e1229 = ((_e1181 - _e104) * _e277);
                                                let _e1233 = ((_e1213 - _e100) * _e257);
                                                let _e1234 = ((_e1218 - _e102) * _e267);
                                                let _e1235 = ((_e1223 - _e104) * _e277);
                                                if (_e1227 < _e1233) {
                                                    phi_1401_ = _e1227;
                                                } else {
                                                    phi_1401_ = _e1233;
                                                }
                                                let _e1238 = phi_1401_;
                                                if (_e1228 < _e1234) {
                                                    phi_1406_ = _e1228;
                                                } else {
                                                    phi_1406_ = _e1234;
                                                }
                                                let _e1241 = phi_1406_;
                                                if (_e1229 < _e1235) {
                                                    phi_1411_ = _e1229;
                                                } else {
                                                    phi_1411_ = _e1235;
                                                }
                                                let _e1244 = phi_1411_;
                                                if (_e1227 > _e1233) {
                                                    phi_1419_ = _e1227;
                                                } else {
                                                    phi_1419_ = _e1233;
                                                }
                                                let _e1250 = phi_1419_;
                                                if (_e1228 > _e1234) {
                                                    phi_1424_ = _e1228;
                                                } else {
                                                    phi_1424_ = _e1234;
                                                }
                                                let _e1253 = phi_1424_;
                                                if (_e1229 > _e1235) {
                                                    phi_1429_ = _e1229;
                                                } else {
                                                    phi_1429_ = _e1235;
                                                }
                                                let _e1256 = phi_1429_;
                                                let _e1260 = core_intrinsics_maximum_number_nsz_f32_((_e1238 - _e312), (_e1241 - _e313));
                                                let _e1261 = core_intrinsics_maximum_number_nsz_f32_(_e1260, (_e1244 - _e314));
                                                let _e1262 = core_intrinsics_minimum_number_nsz_f32_((_e1250 + _e312), (_e1253 + _e313));
                                                let _e1263 = core_intrinsics_minimum_number_nsz_f32_(_e1262, (_e1256 + _e314));
                                                if (_e1261 > -300000000000000000000000000000000000000f) {
                                                    phi_1441_ = _e1261;
                                                } else {
                                                    phi_1441_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1266 = phi_1441_;
                                                if (_e1263 < 300000000000000000000000000000000000000f) {
                                                    phi_1446_ = _e1263;
                                                } else {
                                                    phi_1446_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1269 = phi_1446_;
                                                if (_e1137 < _e1266) {
                                                    phi_1451_ = _e1266;
                                                } else {
                                                    phi_1451_ = _e1137;
                                                }
                                                let _e1272 = phi_1451_;
                                                if (_e1272 > _e1269) {
                                                    phi_1456_ = _e1269;
                                                } else {
                                                    phi_1456_ = _e1272;
                                                }
                                                let _e1275 = phi_1456_;
                                                phi_1461_ = lt_bvh_triangle_Intersection(_e1275, (_e1069 / _e1128), (_e1090 / _e1128), (_e1266 <= _e1269));
                                                phi_1462_ = false;
                                            } else {
                                                phi_1461_ = lt_bvh_triangle_Intersection();
                                                phi_1462_ = true;
                                            }
                                            let _e1281 = phi_1461_;
                                            let _e1283 = phi_1462_;
                                            phi_1463_ = _e1281;
                                            phi_1464_ = _e1283;
                                        } else {
                                            phi_1463_ = lt_bvh_triangle_Intersection();
                                            phi_1464_ = true;
                                        }
                                        let _e1285 = phi_1463_;
                                        let _e1287 = phi_1464_;
                                        if _e1287 {
                                        }
                                        phi_1468_ = _e1285;
                                        phi_1469_ = _e1287;
                                    }
                                    let _e1289 = phi_1468_;
                                    let _e1291 = phi_1469_;
                                    phi_1470_ = _e1289;
                                    phi_1471_ = _e1131;
                                    phi_1472_ = _e1291;
                                } else {
                                    phi_1470_ = lt_bvh_triangle_Intersection();
                                    phi_1471_ = true;
                                    phi_1472_ = false;
                                }
                                let _e1293 = phi_1470_;
                                let _e1295 = phi_1471_;
                                let _e1297 = phi_1472_;
                                if _e1295 {
                                    phi_1476_ = true;
                                } else {
                                    phi_1476_ = _e1297;
                                }
                                let _e1299 = phi_1476_;
                                if _e1299 {
                                    phi_1480_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1480_ = _e1293;
                                }
                                let _e1301 = phi_1480_;
                                if _e1301.is_hit {
                                    if (_e1301.t > 0f) {
                                        if (_e1301.t < _e108) {
                                            let _e1308 = triangles.member[(0u + _e938)].i0_;
                                            let _e1310 = ((_e1308 & 2147483648u) == 0u);
                                            if _e1310 {
                                                phi_1506_ = false;
                                                phi_1507_ = false;
                                            } else {
                                                if true {
                                                    phi_1505_ = false;
                                                } else {
                                                    phi_1505_ = true;
                                                }
                                                let _e1312 = phi_1505_;
                                                phi_1506_ = _e1312;
                                                phi_1507_ = true;
                                            }
                                            let _e1314 = phi_1506_;
                                            let _e1316 = phi_1507_;
                                            phi_1508_ = _e1314;
                                            phi_1509_ = _e1310;
                                            phi_1510_ = _e1316;
                                        } else {
                                            phi_1508_ = true;
                                            phi_1509_ = false;
                                            phi_1510_ = false;
                                        }
                                        let _e1318 = phi_1508_;
                                        let _e1320 = phi_1509_;
                                        let _e1322 = phi_1510_;
                                        phi_1511_ = _e1318;
                                        phi_1512_ = _e1320;
                                        phi_1513_ = _e1322;
                                    } else {
                                        phi_1511_ = true;
                                        phi_1512_ = false;
                                        phi_1513_ = false;
                                    }
                                    let _e1324 = phi_1511_;
                                    let _e1326 = phi_1512_;
                                    let _e1328 = phi_1513_;
                                    phi_1514_ = _e1324;
                                    phi_1515_ = _e1326;
                                    phi_1516_ = _e1328;
                                } else {
                                    phi_1514_ = true;
                                    phi_1515_ = false;
                                    phi_1516_ = false;
                                }
                                let _e1330 = phi_1514_;
                                let _e1332 = phi_1515_;
                                let _e1334 = phi_1516_;
                                if _e1330 {
                                    phi_1520_ = false;
                                    phi_1521_ = false;
                                } else {
                                    phi_1520_ = _e1332;
                                    phi_1521_ = _e1334;
                                }
                                let _e1336 = phi_1520_;
                                let _e1338 = phi_1521_;
                                phi_1009_ = (_e929 & (_e929 - 1u));
                                phi_1522_ = _e1330;
                                phi_1523_ = _e1336;
                                phi_1524_ = _e1338;
                            }
                            let _e1340 = phi_1009_;
                            let _e1342 = phi_1522_;
                            let _e1344 = phi_1523_;
                            let _e1346 = phi_1524_;
                            local_6 = _e1344;
                            local_7 = _e1346;
                            continue;
                            continuing {
                                phi_1008_ = _e1340;
                                break if !(_e1342);
                            }
                        }
                        let _e1349 = local_4;
                        if _e1349 {
                            let _e1351 = local.group_mask;
                            if ((_e1351 & 4278190080u) == 0u) {
                                let _e1355 = local.len;
                                if (_e1355 == 0u) {
                                    phi_1566_ = false;
                                } else {
                                    let _e1359 = local.len;
                                    local.len = (_e1359 - 1u);
                                    let _e1362 = local.len;
                                    if (_e1362 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1367 = local.first[(0u + _e1362)];
                                    local.group = _e1367;
                                    let _e1370 = local.len;
                                    if (_e1370 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1375 = local.mask[(0u + _e1370)];
                                    local.group_mask = _e1375;
                                    phi_1566_ = true;
                                }
                                let _e1378 = phi_1566_;
                                phi_1567_ = _e1378;
                            } else {
                                phi_1567_ = true;
                            }
                            let _e1380 = phi_1567_;
                            if _e1380 {
                                let _e1382 = local.group_mask;
                                let _e1388 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1382)), 32u, (_e1382 == 0u)));
                                let _e1392 = local.group_mask;
                                let _e1406 = local.group_mask;
                                local.group_mask = (_e1406 & ~((1u << bitcast<u32>((_e1388 & 31u)))));
                                let _e1409 = local.group;
                                phi_1598_ = (_e1409 + countOneBits(((_e1392 & ~((4294967295u << bitcast<u32>((((_e1388 - 24u) ^ _e355) & 31u))))) & 255u)));
                            } else {
                                phi_1598_ = 4294967295u;
                            }
                            let _e1412 = phi_1598_;
                            phi_1599_ = _e1412;
                            phi_1600_ = false;
                            phi_1601_ = false;
                        } else {
                            phi_1599_ = u32();
                            let _e1621 = local_6;
                            phi_1600_ = _e1621;
                            let _e1624 = local_7;
                            phi_1601_ = _e1624;
                        }
                        let _e1414 = phi_1599_;
                        let _e1416 = phi_1600_;
                        let _e1418 = phi_1601_;
                        phi_679_ = _e1414;
                        let _e1628 = local_8;
                        phi_1602_ = _e1628;
                        phi_1603_ = false;
                        phi_1604_ = _e1416;
                        phi_1605_ = _e1418;
                    } else {
                        phi_679_ = u32();
                        phi_1602_ = false;
                        phi_1603_ = true;
                        phi_1604_ = false;
                        phi_1605_ = false;
                    }
                    let _e1420 = phi_679_;
                    let _e1422 = phi_1602_;
                    let _e1424 = phi_1603_;
                    let _e1426 = phi_1604_;
                    let _e1428 = phi_1605_;
                    local_5 = _e1424;
                    local_9 = _e1426;
                    local_10 = _e1428;
                    continue;
                    continuing {
                        phi_678_ = _e1420;
                        break if !(_e1422);
                    }
                }
                let _e1431 = local_5;
                if _e1431 {
                    phi_1609_ = false;
                    phi_1610_ = false;
                } else {
                    let _e1635 = local_9;
                    phi_1609_ = _e1635;
                    let _e1638 = local_10;
                    phi_1610_ = _e1638;
                }
                let _e1433 = phi_1609_;
                let _e1435 = phi_1610_;
                if _e1433 {
                    phi_1614_ = true;
                } else {
                    phi_1614_ = _e1435;
                }
                let _e1437 = phi_1614_;
                if _e1437 {
                    phi_1618_ = true;
                } else {
                    phi_1618_ = false;
                }
                let _e1439 = phi_1618_;
                phi_1619_ = _e1439;
            }
            let _e1441 = phi_1619_;
            phi_1620_ = _e1441;
            phi_1621_ = _e181;
        } else {
            phi_1620_ = bool();
            phi_1621_ = true;
        }
        let _e1443 = phi_1620_;
        let _e1445 = phi_1621_;
        if _e1445 {
            phi_1625_ = false;
        } else {
            phi_1625_ = _e1443;
        }
        let _e1447 = phi_1625_;
        if _e1447 {
            phi_1629_ = 0f;
        } else {
            phi_1629_ = 1f;
        }
        let _e1449 = phi_1629_;
        if (_e79 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79)] = _e1449;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
