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
    var phi_680_: bool;
    var phi_760_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_787_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_814_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_820_: u32;
    var phi_823_: u32;
    var phi_837_: u32;
    var phi_847_: u32;
    var phi_857_: u32;
    var phi_875_: u32;
    var phi_885_: u32;
    var phi_895_: u32;
    var phi_931_: u32;
    var phi_944_: u32;
    var phi_949_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_821_: u32;
    var phi_824_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1009_: u32;
    var phi_1012_: bool;
    var phi_1056_: vec3<f32>;
    var phi_1057_: vec3<f32>;
    var phi_1086_: vec3<f32>;
    var phi_1087_: vec3<f32>;
    var phi_1116_: vec3<f32>;
    var phi_1117_: vec3<f32>;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1140_: f32;
    var phi_1141_: f32;
    var phi_1142_: f32;
    var phi_1143_: f32;
    var phi_1151_: f32;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1166_: f32;
    var phi_1167_: f32;
    var phi_1168_: f32;
    var phi_1169_: f32;
    var phi_1177_: f32;
    var phi_1187_: bool;
    var phi_1188_: bool;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1194_: f32;
    var phi_1195_: f32;
    var phi_1203_: f32;
    var phi_1218_: f32;
    var phi_1219_: bool;
    var phi_1220_: f32;
    var phi_1221_: bool;
    var phi_1222_: f32;
    var phi_1223_: bool;
    var phi_1241_: f32;
    var phi_1242_: bool;
    var phi_1243_: bool;
    var phi_1244_: f32;
    var phi_1245_: bool;
    var phi_1246_: bool;
    var phi_1250_: bool;
    var phi_1251_: f32;
    var phi_1252_: bool;
    var phi_1280_: vec3<f32>;
    var phi_1281_: vec3<f32>;
    var phi_1306_: vec3<f32>;
    var phi_1307_: vec3<f32>;
    var phi_1332_: vec3<f32>;
    var phi_1333_: vec3<f32>;
    var phi_1389_: f32;
    var phi_1398_: f32;
    var phi_1407_: f32;
    var phi_1416_: f32;
    var phi_1423_: f32;
    var phi_1430_: f32;
    var phi_1443_: f32;
    var phi_1452_: f32;
    var phi_1461_: f32;
    var phi_1470_: f32;
    var phi_1477_: f32;
    var phi_1484_: f32;
    var phi_1501_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1519_: f32;
    var phi_1524_: f32;
    var phi_1529_: f32;
    var phi_1541_: f32;
    var phi_1546_: f32;
    var phi_1551_: f32;
    var phi_1556_: f32;
    var phi_1561_: lt_bvh_triangle_Intersection;
    var phi_1562_: bool;
    var phi_1563_: lt_bvh_triangle_Intersection;
    var phi_1564_: bool;
    var phi_1568_: lt_bvh_triangle_Intersection;
    var phi_1569_: bool;
    var phi_1570_: lt_bvh_triangle_Intersection;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1576_: bool;
    var phi_1580_: lt_bvh_triangle_Intersection;
    var phi_1600_: bool;
    var phi_1601_: bool;
    var phi_1602_: bool;
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1010_: u32;
    var phi_1013_: bool;
    var phi_1610_: bool;
    var local_4: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1684_: u32;
    var phi_1685_: u32;
    var phi_678_: u32;
    var phi_681_: bool;
    var phi_1686_: bool;
    var phi_1687_: bool;
    var local_5: bool;
    var phi_1691_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1702_: bool;
    var phi_1706_: f32;
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
                phi_1696_ = bool();
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
                phi_680_ = false;
                loop {
                    let _e493 = phi_677_;
                    let _e495 = phi_680_;
                    local_8 = _e495;
                    if (_e493 != 4294967295u) {
                        if (_e493 < _e57) {
                        } else {
                            return;
                        }
                        let _e502 = nodes.member[(0u + _e493)].frame[3u];
                        let _e527 = (bitcast<f32>((((_e502 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e257);
                        let _e528 = (bitcast<f32>((((_e502 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e267);
                        let _e529 = (bitcast<f32>((((_e502 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e277);
                        let _e532 = nodes.member[(0u + _e493)].frame[0u];
                        let _e536 = nodes.member[(0u + _e493)].frame[1u];
                        let _e540 = nodes.member[(0u + _e493)].frame[2u];
                        let _e545 = ((bitcast<f32>(_e532) - _e100) * _e257);
                        let _e546 = ((bitcast<f32>(_e536) - _e102) * _e267);
                        let _e547 = ((bitcast<f32>(_e540) - _e104) * _e277);
                        let _e555 = nodes.member[(0u + _e493)].x;
                        if (_e257 < 0f) {
                            let _e566 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e555.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e566.unnamed.root, _e555.w), _e566.unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e572.unnamed, lt_bvh_traverse_Tree(_e555.x, _e572.unnamed_1.first_primitive));
                            phi_760_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e578.unnamed_1.root, _e555.y));
                        } else {
                            let _e594 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e555.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e594.unnamed.root, _e555.y), _e594.unnamed_1);
                            let _e606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e600.unnamed, lt_bvh_traverse_Tree(_e555.z, _e600.unnamed_1.first_primitive));
                            phi_760_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e606.unnamed, lt_bvh_traverse_Tree(_e606.unnamed_1.root, _e555.w));
                        }
                        let _e614 = phi_760_;
                        let _e624 = nodes.member[(0u + _e493)].y;
                        if (_e267 < 0f) {
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e635.unnamed.root, _e624.w), _e635.unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_bvh_traverse_Tree(_e624.x, _e641.unnamed_1.first_primitive));
                            phi_787_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e647.unnamed_1.root, _e624.y));
                        } else {
                            let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e624.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e663.unnamed.root, _e624.y), _e663.unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_bvh_traverse_Tree(_e624.z, _e669.unnamed_1.first_primitive));
                            phi_787_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_bvh_traverse_Tree(_e675.unnamed_1.root, _e624.w));
                        }
                        let _e683 = phi_787_;
                        let _e693 = nodes.member[(0u + _e493)].z;
                        if (_e277 < 0f) {
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e704.unnamed.root, _e693.w), _e704.unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_bvh_traverse_Tree(_e693.x, _e710.unnamed_1.first_primitive));
                            phi_814_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e716.unnamed_1.root, _e693.y));
                        } else {
                            let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e693.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e732.unnamed.root, _e693.y), _e732.unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e693.z, _e738.unnamed_1.first_primitive));
                            phi_814_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_bvh_traverse_Tree(_e744.unnamed_1.root, _e693.w));
                        }
                        let _e752 = phi_814_;
                        phi_820_ = 0u;
                        phi_823_ = 0u;
                        loop {
                            let _e762 = phi_820_;
                            let _e764 = phi_823_;
                            local_1 = _e764;
                            local_2 = _e764;
                            local_3 = _e764;
                            let _e765 = (_e762 < 8u);
                            if _e765 {
                                let _e767 = (_e762 >> bitcast<u32>(2i));
                                let _e768 = (_e762 & 3u);
                                if (_e767 == 0u) {
                                    phi_837_ = _e614.unnamed.root;
                                } else {
                                    phi_837_ = _e614.unnamed.first_primitive;
                                }
                                let _e771 = phi_837_;
                                if (_e767 == 0u) {
                                    phi_847_ = _e683.unnamed.root;
                                } else {
                                    phi_847_ = _e683.unnamed.first_primitive;
                                }
                                let _e780 = phi_847_;
                                if (_e767 == 0u) {
                                    phi_857_ = _e752.unnamed.root;
                                } else {
                                    phi_857_ = _e752.unnamed.first_primitive;
                                }
                                let _e789 = phi_857_;
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e771 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e305)), ((f32(((_e780 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e306)));
                                let _e803 = core_intrinsics_maximum_number_nsz_f32_(_e802, ((f32(((_e789 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 - _e307)));
                                if (_e767 == 0u) {
                                    phi_875_ = _e614.unnamed_1.root;
                                } else {
                                    phi_875_ = _e614.unnamed_1.first_primitive;
                                }
                                let _e806 = phi_875_;
                                if (_e767 == 0u) {
                                    phi_885_ = _e683.unnamed_1.root;
                                } else {
                                    phi_885_ = _e683.unnamed_1.first_primitive;
                                }
                                let _e815 = phi_885_;
                                if (_e767 == 0u) {
                                    phi_895_ = _e752.unnamed_1.root;
                                } else {
                                    phi_895_ = _e752.unnamed_1.first_primitive;
                                }
                                let _e824 = phi_895_;
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e806 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e305)), ((f32(((_e815 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e306)));
                                let _e838 = core_intrinsics_minimum_number_nsz_f32_(_e837, ((f32(((_e824 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u)) * _e529) + (_e547 + _e307)));
                                if (_e803 <= _e838) {
                                    if (_e803 <= _e108) {
                                        if (_e838 >= 0f) {
                                            if (_e767 == 0u) {
                                                let _e845 = nodes.member[(0u + _e493)].links[2u];
                                                phi_931_ = _e845;
                                            } else {
                                                let _e848 = nodes.member[(0u + _e493)].links[3u];
                                                phi_931_ = _e848;
                                            }
                                            let _e850 = phi_931_;
                                            let _e855 = ((_e850 >> bitcast<u32>(((_e768 * 8u) & 31u))) & 255u);
                                            let _e856 = (_e855 & 31u);
                                            if (_e856 >= 24u) {
                                                phi_944_ = (24u + ((_e856 - 24u) ^ _e355));
                                            } else {
                                                phi_944_ = _e856;
                                            }
                                            let _e862 = phi_944_;
                                            phi_949_ = (_e764 | ((_e855 >> bitcast<u32>(5i)) << bitcast<u32>((_e862 & 31u))));
                                        } else {
                                            phi_949_ = _e764;
                                        }
                                        let _e870 = phi_949_;
                                        phi_950_ = _e870;
                                    } else {
                                        phi_950_ = _e764;
                                    }
                                    let _e872 = phi_950_;
                                    phi_951_ = _e872;
                                } else {
                                    phi_951_ = _e764;
                                }
                                let _e874 = phi_951_;
                                phi_821_ = (_e762 + 1u);
                                phi_824_ = _e874;
                            } else {
                                phi_821_ = u32();
                                phi_824_ = u32();
                            }
                            let _e877 = phi_821_;
                            let _e879 = phi_824_;
                            continue;
                            continuing {
                                phi_820_ = _e877;
                                phi_823_ = _e879;
                                break if !(_e765);
                            }
                        }
                        let _e883 = nodes.member[(0u + _e493)].links[0u];
                        let _e887 = nodes.member[(0u + _e493)].frame[3u];
                        let _e891 = local_1;
                        if ((_e891 & 4278190080u) == 0u) {
                        } else {
                            let _e895 = local.group_mask;
                            if ((_e895 & 4278190080u) == 0u) {
                            } else {
                                let _e899 = local.len;
                                if (_e899 < 32u) {
                                    let _e902 = local.group;
                                    let _e904 = local.len;
                                    if (_e904 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e904)] = _e902;
                                    let _e910 = local.group_mask;
                                    let _e912 = local.len;
                                    if (_e912 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e912)] = _e910;
                                    let _e919 = local.len;
                                    local.len = (_e919 + 1u);
                                }
                            }
                            local.group = (0u + _e883);
                            let _e923 = local_2;
                            local.group_mask = ((_e923 & 4278190080u) | (_e887 >> bitcast<u32>(24i)));
                        }
                        let _e928 = local_3;
                        phi_1009_ = (_e928 & 16777215u);
                        phi_1012_ = _e495;
                        loop {
                            let _e931 = phi_1009_;
                            let _e933 = phi_1012_;
                            local_6 = _e933;
                            let _e934 = (_e931 == 0u);
                            local_4 = _e934;
                            local_7 = _e934;
                            if _e934 {
                                phi_1010_ = u32();
                                phi_1013_ = bool();
                                phi_1610_ = false;
                            } else {
                                let _e937 = nodes.member[(0u + _e493)].links[1u];
                                let _e942 = ((0u + _e937) + select(firstTrailingBit(_e931), 32u, (_e931 == 0u)));
                                if (_e942 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e949 = triangles.member[(0u + _e942)].v0_;
                                let _e951 = (_e949.x - _e100);
                                let _e953 = (_e949.y - _e102);
                                let _e955 = (_e949.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1057_ = vec3<f32>(_e953, _e955, _e951);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1056_ = vec3<f32>(_e955, _e951, _e953);
                                    } else {
                                        phi_1056_ = (_e949 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e963 = phi_1056_;
                                    phi_1057_ = _e963;
                                }
                                let _e965 = phi_1057_;
                                let _e969 = (_e965.x - (_e339 * _e965.z));
                                let _e973 = (_e965.y - (_e342 * _e965.z));
                                let _e975 = triangles.member[(0u + _e942)].v1_;
                                let _e977 = (_e975.x - _e100);
                                let _e979 = (_e975.y - _e102);
                                let _e981 = (_e975.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1087_ = vec3<f32>(_e979, _e981, _e977);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1086_ = vec3<f32>(_e981, _e977, _e979);
                                    } else {
                                        phi_1086_ = (_e975 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e989 = phi_1086_;
                                    phi_1087_ = _e989;
                                }
                                let _e991 = phi_1087_;
                                let _e995 = (_e991.x - (_e339 * _e991.z));
                                let _e999 = (_e991.y - (_e342 * _e991.z));
                                let _e1001 = triangles.member[(0u + _e942)].v2_;
                                let _e1003 = (_e1001.x - _e100);
                                let _e1005 = (_e1001.y - _e102);
                                let _e1007 = (_e1001.z - _e104);
                                if (_e328 == 0u) {
                                    phi_1117_ = vec3<f32>(_e1005, _e1007, _e1003);
                                } else {
                                    if (_e328 == 1u) {
                                        phi_1116_ = vec3<f32>(_e1007, _e1003, _e1005);
                                    } else {
                                        phi_1116_ = (_e1001 - vec3<f32>(_e100, _e102, _e104));
                                    }
                                    let _e1015 = phi_1116_;
                                    phi_1117_ = _e1015;
                                }
                                let _e1017 = phi_1117_;
                                let _e1021 = (_e1017.x - (_e339 * _e1017.z));
                                let _e1025 = (_e1017.y - (_e342 * _e1017.z));
                                if (_e995 < _e1021) {
                                    phi_1136_ = true;
                                } else {
                                    if (_e995 == _e1021) {
                                        phi_1135_ = (_e999 < _e1025);
                                    } else {
                                        phi_1135_ = false;
                                    }
                                    let _e1030 = phi_1135_;
                                    phi_1136_ = _e1030;
                                }
                                let _e1032 = phi_1136_;
                                if _e1032 {
                                    phi_1140_ = _e1025;
                                    phi_1141_ = _e1021;
                                    phi_1142_ = _e999;
                                    phi_1143_ = _e995;
                                } else {
                                    phi_1140_ = _e999;
                                    phi_1141_ = _e995;
                                    phi_1142_ = _e1025;
                                    phi_1143_ = _e1021;
                                }
                                let _e1034 = phi_1140_;
                                let _e1036 = phi_1141_;
                                let _e1038 = phi_1142_;
                                let _e1040 = phi_1143_;
                                let _e1043 = ((_e1040 * _e1034) - (_e1038 * _e1036));
                                if _e1032 {
                                    phi_1151_ = -(_e1043);
                                } else {
                                    phi_1151_ = _e1043;
                                }
                                let _e1046 = phi_1151_;
                                if (_e1021 < _e969) {
                                    phi_1162_ = true;
                                } else {
                                    if (_e1021 == _e969) {
                                        phi_1161_ = (_e1025 < _e973);
                                    } else {
                                        phi_1161_ = false;
                                    }
                                    let _e1051 = phi_1161_;
                                    phi_1162_ = _e1051;
                                }
                                let _e1053 = phi_1162_;
                                if _e1053 {
                                    phi_1166_ = _e973;
                                    phi_1167_ = _e969;
                                    phi_1168_ = _e1025;
                                    phi_1169_ = _e1021;
                                } else {
                                    phi_1166_ = _e1025;
                                    phi_1167_ = _e1021;
                                    phi_1168_ = _e973;
                                    phi_1169_ = _e969;
                                }
                                let _e1055 = phi_1166_;
                                let _e1057 = phi_1167_;
                                let _e1059 = phi_1168_;
                                let _e1061 = phi_1169_;
                                let _e1064 = ((_e1061 * _e1055) - (_e1059 * _e1057));
                                if _e1053 {
                                    phi_1177_ = -(_e1064);
                                } else {
                                    phi_1177_ = _e1064;
                                }
                                let _e1067 = phi_1177_;
                                if (_e969 < _e995) {
                                    phi_1188_ = true;
                                } else {
                                    if (_e969 == _e995) {
                                        phi_1187_ = (_e973 < _e999);
                                    } else {
                                        phi_1187_ = false;
                                    }
                                    let _e1072 = phi_1187_;
                                    phi_1188_ = _e1072;
                                }
                                let _e1074 = phi_1188_;
                                if _e1074 {
                                    phi_1192_ = _e999;
                                    phi_1193_ = _e995;
                                    phi_1194_ = _e973;
                                    phi_1195_ = _e969;
                                } else {
                                    phi_1192_ = _e973;
                                    phi_1193_ = _e969;
                                    phi_1194_ = _e999;
                                    phi_1195_ = _e995;
                                }
                                let _e1076 = phi_1192_;
                                let _e1078 = phi_1193_;
                                let _e1080 = phi_1194_;
                                let _e1082 = phi_1195_;
                                let _e1085 = ((_e1082 * _e1076) - (_e1080 * _e1078));
                                if _e1074 {
                                    phi_1203_ = -(_e1085);
                                } else {
                                    phi_1203_ = _e1085;
                                }
                                let _e1088 = phi_1203_;
                                if (_e1046 >= 0f) {
                                    if (_e1067 >= 0f) {
                                        if (_e1088 >= 0f) {
                                            phi_1218_ = ((_e1046 + _e1067) + _e1088);
                                            phi_1219_ = false;
                                        } else {
                                            phi_1218_ = f32();
                                            phi_1219_ = true;
                                        }
                                        let _e1095 = phi_1218_;
                                        let _e1097 = phi_1219_;
                                        phi_1220_ = _e1095;
                                        phi_1221_ = _e1097;
                                    } else {
                                        phi_1220_ = f32();
                                        phi_1221_ = true;
                                    }
                                    let _e1099 = phi_1220_;
                                    let _e1101 = phi_1221_;
                                    phi_1222_ = _e1099;
                                    phi_1223_ = _e1101;
                                } else {
                                    phi_1222_ = f32();
                                    phi_1223_ = true;
                                }
                                let _e1103 = phi_1222_;
                                let _e1105 = phi_1223_;
                                if _e1105 {
                                    if (_e1046 <= 0f) {
                                        if (_e1067 <= 0f) {
                                            let _e1108 = (_e1088 <= 0f);
                                            if _e1108 {
                                            }
                                            phi_1241_ = ((_e1046 + _e1067) + _e1088);
                                            phi_1242_ = false;
                                            phi_1243_ = _e1108;
                                        } else {
                                            phi_1241_ = f32();
                                            phi_1242_ = true;
                                            phi_1243_ = false;
                                        }
                                        let _e1112 = phi_1241_;
                                        let _e1114 = phi_1242_;
                                        let _e1116 = phi_1243_;
                                        phi_1244_ = _e1112;
                                        phi_1245_ = _e1114;
                                        phi_1246_ = _e1116;
                                    } else {
                                        phi_1244_ = f32();
                                        phi_1245_ = true;
                                        phi_1246_ = false;
                                    }
                                    let _e1118 = phi_1244_;
                                    let _e1120 = phi_1245_;
                                    let _e1122 = phi_1246_;
                                    if _e1120 {
                                        phi_1250_ = false;
                                    } else {
                                        phi_1250_ = _e1122;
                                    }
                                    let _e1124 = phi_1250_;
                                    phi_1251_ = _e1118;
                                    phi_1252_ = _e1124;
                                } else {
                                    phi_1251_ = _e1103;
                                    phi_1252_ = true;
                                }
                                let _e1126 = phi_1251_;
                                let _e1128 = phi_1252_;
                                if _e1128 {
                                    let _e1129 = (_e1126 == 0f);
                                    if _e1129 {
                                        phi_1568_ = lt_bvh_triangle_Intersection();
                                        phi_1569_ = false;
                                    } else {
                                        let _e1131 = triangles.member[(0u + _e942)].v0_;
                                        let _e1133 = (_e1131.x - _e100);
                                        let _e1135 = (_e1131.y - _e102);
                                        let _e1137 = (_e1131.z - _e104);
                                        if (_e328 == 0u) {
                                            phi_1281_ = vec3<f32>(_e1135, _e1137, _e1133);
                                        } else {
                                            if (_e328 == 1u) {
                                                phi_1280_ = vec3<f32>(_e1137, _e1133, _e1135);
                                            } else {
                                                phi_1280_ = (_e1131 - vec3<f32>(_e100, _e102, _e104));
                                            }
                                            let _e1145 = phi_1280_;
                                            phi_1281_ = _e1145;
                                        }
                                        let _e1147 = phi_1281_;
                                        let _e1149 = triangles.member[(0u + _e942)].v1_;
                                        let _e1151 = triangles.member[(0u + _e942)].v0_;
                                        let _e1154 = (_e1149.x - _e1151.x);
                                        let _e1157 = (_e1149.y - _e1151.y);
                                        let _e1160 = (_e1149.z - _e1151.z);
                                        if (_e328 == 0u) {
                                            phi_1307_ = vec3<f32>(_e1157, _e1160, _e1154);
                                        } else {
                                            if (_e328 == 1u) {
                                                phi_1306_ = vec3<f32>(_e1160, _e1154, _e1157);
                                            } else {
                                                phi_1306_ = (_e1149 - _e1151);
                                            }
                                            let _e1167 = phi_1306_;
                                            phi_1307_ = _e1167;
                                        }
                                        let _e1169 = phi_1307_;
                                        let _e1171 = triangles.member[(0u + _e942)].v2_;
                                        let _e1173 = triangles.member[(0u + _e942)].v0_;
                                        let _e1176 = (_e1171.x - _e1173.x);
                                        let _e1179 = (_e1171.y - _e1173.y);
                                        let _e1182 = (_e1171.z - _e1173.z);
                                        if (_e328 == 0u) {
                                            phi_1333_ = vec3<f32>(_e1179, _e1182, _e1176);
                                        } else {
                                            if (_e328 == 1u) {
                                                phi_1332_ = vec3<f32>(_e1182, _e1176, _e1179);
                                            } else {
                                                phi_1332_ = (_e1171 - _e1173);
                                            }
                                            let _e1189 = phi_1332_;
                                            phi_1333_ = _e1189;
                                        }
                                        let _e1191 = phi_1333_;
                                        let _e1198 = ((_e1169.y * _e1191.z) - (_e1169.z * _e1191.y));
                                        let _e1205 = ((_e1169.z * _e1191.x) - (_e1169.x * _e1191.z));
                                        let _e1212 = ((_e1169.x * _e1191.y) - (_e1169.y * _e1191.x));
                                        let _e1226 = (((1f / _e336.z) * (((_e1198 * _e1147.x) + (_e1205 * _e1147.y)) + (_e1212 * _e1147.z))) / (((_e1198 * _e339) + (_e1205 * _e342)) + _e1212));
                                        if (_e1226 > 0f) {
                                            if (_e1226 < _e108) {
                                                let _e1230 = triangles.member[(0u + _e942)].v0_;
                                                let _e1232 = triangles.member[(0u + _e942)].v1_;
                                                if (_e1230.x < _e1232.x) {
                                                    phi_1389_ = _e1230.x;
                                                } else {
                                                    phi_1389_ = _e1232.x;
                                                }
                                                let _e1239 = phi_1389_;
                                                if (_e1230.y < _e1232.y) {
                                                    phi_1398_ = _e1230.y;
                                                } else {
                                                    phi_1398_ = _e1232.y;
                                                }
                                                let _e1246 = phi_1398_;
                                                if (_e1230.z < _e1232.z) {
                                                    phi_1407_ = _e1230.z;
                                                } else {
                                                    phi_1407_ = _e1232.z;
                                                }
                                                let _e1253 = phi_1407_;
                                                let _e1255 = triangles.member[(0u + _e942)].v2_;
                                                if (_e1239 < _e1255.x) {
                                                    phi_1416_ = _e1239;
                                                } else {
                                                    phi_1416_ = _e1255.x;
                                                }
                                                let _e1260 = phi_1416_;
                                                if (_e1246 < _e1255.y) {
                                                    phi_1423_ = _e1246;
                                                } else {
                                                    phi_1423_ = _e1255.y;
                                                }
                                                let _e1265 = phi_1423_;
                                                if (_e1253 < _e1255.z) {
                                                    phi_1430_ = _e1253;
                                                } else {
                                                    phi_1430_ = _e1255.z;
                                                }
                                                let _e1270 = phi_1430_;
                                                let _e1272 = triangles.member[(0u + _e942)].v0_;
                                                let _e1274 = triangles.member[(0u + _e942)].v1_;
                                                if (_e1272.x > _e1274.x) {
                                                    phi_1443_ = _e1272.x;
                                                } else {
                                                    phi_1443_ = _e1274.x;
                                                }
                                                let _e1281 = phi_1443_;
                                                if (_e1272.y > _e1274.y) {
                                                    phi_1452_ = _e1272.y;
                                                } else {
                                                    phi_1452_ = _e1274.y;
                                                }
                                                let _e1288 = phi_1452_;
                                                if (_e1272.z > _e1274.z) {
                                                    phi_1461_ = _e1272.z;
                                                } else {
                                                    phi_1461_ = _e1274.z;
                                                }
                                                let _e1295 = phi_1461_;
                                                let _e1297 = triangles.member[(0u + _e942)].v2_;
                                                if (_e1281 > _e1297.x) {
                                                    phi_1470_ = _e1281;
                                                } else {
                                                    phi_1470_ = _e1297.x;
                                                }
                                                let _e1302 = phi_1470_;
                                                if (_e1288 > _e1297.y) {
                                                    phi_1477_ = _e1288;
                                                } else {
                                                    phi_1477_ = _e1297.y;
                                                }
                                                let _e1307 = phi_1477_;
                                                if (_e1295 > _e1297.z) {
                                                    phi_1484_ = _e1295;
                                                } else {
                                                    phi_1484_ = _e1297.z;
                                                }
                                                let _e1312 = phi_1484_;
                                                let _e1316 = ((_e1260 - _e100) * _e257);
                                                let _e1317 = ((_e1265 - _e102) * _e267);
                                                let _e1318 = ((_e1270 - _e104) * _e277);
                                                let _e1322 = ((_e1302 - _e100) * _e257);
                                                let _e1323 = ((_e1307 - _e102) * _e267);
                                                let _e1324 = ((_e1312 - _e104) * _e277);
                                                if (_e1316 < _e1322) {
                                                    phi_1501_ = _e1316;
                                                } else {
                                                    phi_1501_ = _e1322;
                                                }
                                                let _e1327 = phi_1501_;
                                                if (_e1317 < _e1323) {
                                                    phi_1506_ = _e1317;
                                                } else {
                                                    phi_1506_ = _e1323;
                                                }
                                                let _e1330 = phi_1506_;
                                                if (_e1318 < _e1324) {
                                                    phi_1511_ = _e1318;
                                                } else {
                                                    phi_1511_ = _e1324;
                                                }
                                                let _e1333 = phi_1511_;
                                                if (_e1316 > _e1322) {
                                                    phi_1519_ = _e1316;
                                                } else {
                                                    phi_1519_ = _e1322;
                                                }
                                                let _e1339 = phi_1519_;
                                                if (_e1317 > _e1323) {
                                                    phi_1524_ = _e1317;
                                                } else {
                                                    phi_1524_ = _e1323;
                                                }
                                                let _e1342 = phi_1524_;
                                                if (_e1318 > _e1324) {
                                                    phi_1529_ = _e1318;
                                                } else {
                                                    phi_1529_ = _e1324;
                                                }
                                                let _e1345 = phi_1529_;
                                                let _e1349 = core_intrinsics_maximum_number_nsz_f32_((_e1327 - _e312), (_e1330 - _e313));
                                                let _e1350 = core_intrinsics_maximum_number_nsz_f32_(_e1349, (_e1333 - _e314));
                                                let _e1351 = core_intrinsics_minimum_number_nsz_f32_((_e1339 + _e312), (_e1342 + _e313));
                                                let _e1352 = core_intrinsics_minimum_number_nsz_f32_(_e1351, (_e1345 + _e314));
                                                if (_e1350 > -300000000000000000000000000000000000000f) {
                                                    phi_1541_ = _e1350;
                                                } else {
                                                    phi_1541_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1355 = phi_1541_;
                                                if (_e1352 < 300000000000000000000000000000000000000f) {
                                                    phi_1546_ = _e1352;
                                                } else {
                                                    phi_1546_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1358 = phi_1546_;
                                                if (_e1226 < _e1355) {
                                                    phi_1551_ = _e1355;
                                                } else {
                                                    phi_1551_ = _e1226;
                                                }
                                                let _e1361 = phi_1551_;
                                                if (_e1361 > _e1358) {
                                                    phi_1556_ = _e1358;
                                                } else {
                                                    phi_1556_ = _e1361;
                                                }
                                                let _e1364 = phi_1556_;
                                                phi_1561_ = lt_bvh_triangle_Intersection(_e1364, (_e1067 / _e1126), (_e1088 / _e1126), (_e1355 <= _e1358));
                                                phi_1562_ = false;
                                            } else {
                                                phi_1561_ = lt_bvh_triangle_Intersection();
                                                phi_1562_ = true;
                                            }
                                            let _e1370 = phi_1561_;
                                            let _e1372 = phi_1562_;
                                            phi_1563_ = _e1370;
                                            phi_1564_ = _e1372;
                                        } else {
                                            phi_1563_ = lt_bvh_triangle_Intersection();
                                            phi_1564_ = true;
                                        }
                                        let _e1374 = phi_1563_;
                                        let _e1376 = phi_1564_;
                                        if _e1376 {
                                        }
                                        phi_1568_ = _e1374;
                                        phi_1569_ = _e1376;
                                    }
                                    let _e1378 = phi_1568_;
                                    let _e1380 = phi_1569_;
                                    phi_1570_ = _e1378;
                                    phi_1571_ = _e1129;
                                    phi_1572_ = _e1380;
                                } else {
                                    phi_1570_ = lt_bvh_triangle_Intersection();
                                    phi_1571_ = true;
                                    phi_1572_ = false;
                                }
                                let _e1382 = phi_1570_;
                                let _e1384 = phi_1571_;
                                let _e1386 = phi_1572_;
                                if _e1384 {
                                    phi_1576_ = true;
                                } else {
                                    phi_1576_ = _e1386;
                                }
                                let _e1388 = phi_1576_;
                                if _e1388 {
                                    phi_1580_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1580_ = _e1382;
                                }
                                let _e1390 = phi_1580_;
                                if _e1390.is_hit {
                                    if (_e1390.t > 0f) {
                                        if (_e1390.t < _e108) {
                                            if true {
                                                phi_1600_ = false;
                                            } else {
                                                phi_1600_ = true;
                                            }
                                            let _e1399 = phi_1600_;
                                            phi_1601_ = true;
                                            phi_1602_ = _e1399;
                                        } else {
                                            phi_1601_ = _e933;
                                            phi_1602_ = true;
                                        }
                                        let _e1401 = phi_1601_;
                                        let _e1403 = phi_1602_;
                                        phi_1603_ = _e1401;
                                        phi_1604_ = _e1403;
                                    } else {
                                        phi_1603_ = _e933;
                                        phi_1604_ = true;
                                    }
                                    let _e1405 = phi_1603_;
                                    let _e1407 = phi_1604_;
                                    phi_1605_ = _e1405;
                                    phi_1606_ = _e1407;
                                } else {
                                    phi_1605_ = _e933;
                                    phi_1606_ = true;
                                }
                                let _e1409 = phi_1605_;
                                let _e1411 = phi_1606_;
                                if _e1411 {
                                }
                                phi_1010_ = (_e931 & (_e931 - 1u));
                                phi_1013_ = _e1409;
                                phi_1610_ = _e1411;
                            }
                            let _e1413 = phi_1010_;
                            let _e1415 = phi_1013_;
                            let _e1417 = phi_1610_;
                            continue;
                            continuing {
                                phi_1009_ = _e1413;
                                phi_1012_ = _e1415;
                                break if !(_e1417);
                            }
                        }
                        let _e1420 = local_4;
                        if _e1420 {
                            let _e1422 = local.group_mask;
                            if ((_e1422 & 4278190080u) == 0u) {
                                let _e1426 = local.len;
                                if (_e1426 == 0u) {
                                    phi_1652_ = false;
                                } else {
                                    let _e1430 = local.len;
                                    local.len = (_e1430 - 1u);
                                    let _e1433 = local.len;
                                    if (_e1433 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1438 = local.first[(0u + _e1433)];
                                    local.group = _e1438;
                                    let _e1441 = local.len;
                                    if (_e1441 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1446 = local.mask[(0u + _e1441)];
                                    local.group_mask = _e1446;
                                    phi_1652_ = true;
                                }
                                let _e1449 = phi_1652_;
                                phi_1653_ = _e1449;
                            } else {
                                phi_1653_ = true;
                            }
                            let _e1451 = phi_1653_;
                            if _e1451 {
                                let _e1453 = local.group_mask;
                                let _e1459 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1453)), 32u, (_e1453 == 0u)));
                                let _e1463 = local.group_mask;
                                let _e1477 = local.group_mask;
                                local.group_mask = (_e1477 & ~((1u << bitcast<u32>((_e1459 & 31u)))));
                                let _e1480 = local.group;
                                phi_1684_ = (_e1480 + countOneBits(((_e1463 & ~((4294967295u << bitcast<u32>((((_e1459 - 24u) ^ _e355) & 31u))))) & 255u)));
                            } else {
                                phi_1684_ = 4294967295u;
                            }
                            let _e1483 = phi_1684_;
                            phi_1685_ = _e1483;
                        } else {
                            phi_1685_ = u32();
                        }
                        let _e1485 = phi_1685_;
                        phi_678_ = _e1485;
                        let _e1683 = local_6;
                        phi_681_ = _e1683;
                        let _e1686 = local_7;
                        phi_1686_ = _e1686;
                        phi_1687_ = false;
                    } else {
                        phi_678_ = u32();
                        phi_681_ = bool();
                        phi_1686_ = false;
                        phi_1687_ = true;
                    }
                    let _e1487 = phi_678_;
                    let _e1489 = phi_681_;
                    let _e1491 = phi_1686_;
                    let _e1493 = phi_1687_;
                    local_5 = _e1493;
                    continue;
                    continuing {
                        phi_677_ = _e1487;
                        phi_680_ = _e1489;
                        break if !(_e1491);
                    }
                }
                let _e1496 = local_5;
                if _e1496 {
                    phi_1691_ = false;
                } else {
                    phi_1691_ = true;
                }
                let _e1498 = phi_1691_;
                if _e1498 {
                    phi_1695_ = true;
                } else {
                    let _e1692 = local_8;
                    phi_1695_ = _e1692;
                }
                let _e1500 = phi_1695_;
                phi_1696_ = _e1500;
            }
            let _e1502 = phi_1696_;
            phi_1697_ = _e1502;
            phi_1698_ = _e181;
        } else {
            phi_1697_ = bool();
            phi_1698_ = true;
        }
        let _e1504 = phi_1697_;
        let _e1506 = phi_1698_;
        if _e1506 {
            phi_1702_ = false;
        } else {
            phi_1702_ = _e1504;
        }
        let _e1508 = phi_1702_;
        if _e1508 {
            phi_1706_ = 0f;
        } else {
            phi_1706_ = 1f;
        }
        let _e1510 = phi_1706_;
        if (_e79 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79)] = _e1510;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
