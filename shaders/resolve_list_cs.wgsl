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

struct type_6 {
    member: array<lt_bvh_Triangle>,
}

struct type_11 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_25 {
    member: array<abi_Sample>,
}

struct type_29 {
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

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
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
var<storage> samples: type_25;
@group(0) @binding(0) 
var<uniform> p: type_43;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_6;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_29;
@group(0) @binding(5) 
var<storage> list: type_11;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_150_: bool;
    var phi_154_: f32;

    if (param != param) {
        phi_150_ = true;
    } else {
        let _e52 = (param_1 >= param);
        if _e52 {
        }
        phi_150_ = _e52;
    }
    let _e54 = phi_150_;
    if _e54 {
        phi_154_ = param_1;
    } else {
        phi_154_ = param;
    }
    let _e56 = phi_154_;
    return _e56;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_166_: bool;
    var phi_170_: f32;

    if (param_2 != param_2) {
        phi_166_ = true;
    } else {
        let _e52 = (param_3 <= param_2);
        if _e52 {
        }
        phi_166_ = _e52;
    }
    let _e54 = phi_166_;
    if _e54 {
        phi_170_ = param_3;
    } else {
        phi_170_ = param_2;
    }
    let _e56 = phi_170_;
    return _e56;
}

fn lt_shaders_evaluate_to_light(param_4: vec3<f32>, param_5: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_5.x - (param_4.x * param_5.w)), (param_5.y - (param_4.y * param_5.w)), (param_5.z - (param_4.z * param_5.w)));
}

fn lt_shaders_doubt_slot_of(param_6: vec3<u32>) -> u32 {
    return ((param_6.y * 2097152u) + param_6.x);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_260_: f32;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
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
    var phi_336_: bool;
    var phi_340_: bool;
    var phi_414_: f32;
    var phi_421_: f32;
    var phi_429_: f32;
    var phi_436_: f32;
    var phi_444_: f32;
    var phi_451_: f32;
    var phi_468_: f32;
    var phi_473_: f32;
    var phi_478_: f32;
    var phi_509_: bool;
    var phi_510_: bool;
    var phi_518_: u32;
    var phi_519_: u32;
    var phi_536_: vec3<f32>;
    var phi_537_: vec3<f32>;
    var phi_550_: u32;
    var phi_555_: u32;
    var phi_560_: u32;
    var phi_674_: bool;
    var phi_675_: bool;
    var phi_706_: u32;
    var phi_708_: u32;
    var phi_789_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_816_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_843_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_849_: u32;
    var phi_852_: u32;
    var phi_866_: u32;
    var phi_876_: u32;
    var phi_886_: u32;
    var phi_904_: u32;
    var phi_914_: u32;
    var phi_924_: u32;
    var phi_960_: u32;
    var phi_973_: u32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_980_: u32;
    var phi_850_: u32;
    var phi_853_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1038_: u32;
    var phi_1083_: vec3<f32>;
    var phi_1084_: vec3<f32>;
    var phi_1115_: vec3<f32>;
    var phi_1116_: vec3<f32>;
    var phi_1147_: vec3<f32>;
    var phi_1148_: vec3<f32>;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1173_: f32;
    var phi_1174_: f32;
    var phi_1175_: f32;
    var phi_1176_: f32;
    var phi_1184_: f32;
    var phi_1194_: bool;
    var phi_1195_: bool;
    var phi_1199_: f32;
    var phi_1200_: f32;
    var phi_1201_: f32;
    var phi_1202_: f32;
    var phi_1210_: f32;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1225_: f32;
    var phi_1226_: f32;
    var phi_1227_: f32;
    var phi_1228_: f32;
    var phi_1236_: f32;
    var phi_1251_: f32;
    var phi_1252_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1255_: f32;
    var phi_1256_: bool;
    var phi_1274_: f32;
    var phi_1275_: bool;
    var phi_1276_: bool;
    var phi_1277_: f32;
    var phi_1278_: bool;
    var phi_1279_: bool;
    var phi_1283_: bool;
    var phi_1284_: f32;
    var phi_1285_: bool;
    var phi_1311_: f32;
    var phi_1320_: f32;
    var phi_1329_: f32;
    var phi_1338_: f32;
    var phi_1345_: f32;
    var phi_1352_: f32;
    var phi_1365_: f32;
    var phi_1374_: f32;
    var phi_1383_: f32;
    var phi_1392_: f32;
    var phi_1399_: f32;
    var phi_1406_: f32;
    var phi_1423_: f32;
    var phi_1428_: f32;
    var phi_1433_: f32;
    var phi_1441_: f32;
    var phi_1446_: f32;
    var phi_1451_: f32;
    var phi_1463_: f32;
    var phi_1468_: f32;
    var phi_1473_: f32;
    var phi_1478_: f32;
    var phi_1483_: lt_bvh_triangle_Intersection;
    var phi_1484_: lt_bvh_triangle_Intersection;
    var phi_1485_: bool;
    var phi_1489_: lt_bvh_triangle_Intersection;
    var phi_1514_: bool;
    var phi_1515_: bool;
    var phi_1516_: bool;
    var phi_1517_: bool;
    var phi_1518_: bool;
    var phi_1519_: bool;
    var phi_1520_: bool;
    var phi_1521_: bool;
    var phi_1522_: bool;
    var phi_1523_: bool;
    var phi_1524_: bool;
    var phi_1525_: bool;
    var phi_1529_: bool;
    var phi_1530_: bool;
    var phi_1039_: u32;
    var phi_1531_: bool;
    var phi_1532_: bool;
    var phi_1533_: bool;
    var local_4: bool;
    var phi_1575_: bool;
    var phi_1576_: bool;
    var phi_1607_: u32;
    var phi_1608_: u32;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_709_: u32;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var local_5: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1623_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1634_: bool;
    var phi_1638_: f32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;

    let _e50 = id_1;
    let _e57 = arrayLength((&nodes.member));
    let _e66 = arrayLength((&list.member));
    let _e67 = lt_shaders_doubt_slot_of(_e50);
    if (3u < _e66) {
    } else {
        return;
    }
    let _e70 = list.member[3u];
    if (_e67 < _e70) {
        let _e72 = (_e67 + 4u);
        if (_e72 < _e66) {
        } else {
            return;
        }
        let _e76 = list.member[(0u + _e72)];
        if (_e76 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e81 = p.member.light;
        let _e83 = samples.member[(0u + _e76)].position;
        let _e85 = samples.member[(0u + _e76)].normal;
        let _e87 = samples.member[(0u + _e76)].magnitude;
        let _e89 = ((8f / 8388608f) * _e87);
        let _e91 = (_e85.x * _e89);
        let _e93 = (_e85.y * _e89);
        let _e95 = (_e85.z * _e89);
        let _e97 = (_e83.x + _e91);
        let _e99 = (_e83.y + _e93);
        let _e101 = (_e83.z + _e95);
        let _e103 = (_e83 + vec3<f32>(_e91, _e93, _e95));
        if (_e81.w == 0f) {
            phi_260_ = 300000000000000000000000000000000000000f;
        } else {
            phi_260_ = 1f;
        }
        let _e107 = phi_260_;
        let _e108 = lt_shaders_evaluate_to_light(_e103, _e81);
        let _e109 = lt_bvh_Ray(_e103, 0f, _e108, _e107);
        let _e114 = abs(_e108.x);
        let _e116 = abs(_e108.y);
        let _e118 = abs(_e108.z);
        if (abs(_e97) < 1000000000000000f) {
            if (abs(_e99) < 1000000000000000f) {
                if (abs(_e101) < 1000000000000000f) {
                    if (_e114 < 1000000000000000f) {
                        if (_e116 < 1000000000000000f) {
                            if (_e118 < 1000000000000000f) {
                                if (_e114 > 0f) {
                                    phi_310_ = bool();
                                    phi_311_ = true;
                                } else {
                                    let _e126 = (_e116 > 0f);
                                    if _e126 {
                                        phi_309_ = bool();
                                    } else {
                                        phi_309_ = (_e118 > 0f);
                                    }
                                    let _e129 = phi_309_;
                                    phi_310_ = _e129;
                                    phi_311_ = _e126;
                                }
                                let _e131 = phi_310_;
                                let _e133 = phi_311_;
                                if _e133 {
                                    phi_315_ = true;
                                } else {
                                    phi_315_ = _e131;
                                }
                                let _e135 = phi_315_;
                                phi_316_ = _e135;
                                phi_317_ = false;
                            } else {
                                phi_316_ = bool();
                                phi_317_ = true;
                            }
                            let _e137 = phi_316_;
                            let _e139 = phi_317_;
                            phi_318_ = _e137;
                            phi_319_ = false;
                            phi_320_ = _e139;
                        } else {
                            phi_318_ = bool();
                            phi_319_ = true;
                            phi_320_ = false;
                        }
                        let _e141 = phi_318_;
                        let _e143 = phi_319_;
                        let _e145 = phi_320_;
                        phi_321_ = _e141;
                        phi_322_ = _e143;
                        phi_323_ = _e145;
                    } else {
                        phi_321_ = bool();
                        phi_322_ = true;
                        phi_323_ = false;
                    }
                    let _e147 = phi_321_;
                    let _e149 = phi_322_;
                    let _e151 = phi_323_;
                    phi_324_ = _e147;
                    phi_325_ = _e149;
                    phi_326_ = _e151;
                } else {
                    phi_324_ = bool();
                    phi_325_ = true;
                    phi_326_ = false;
                }
                let _e153 = phi_324_;
                let _e155 = phi_325_;
                let _e157 = phi_326_;
                phi_327_ = _e153;
                phi_328_ = _e155;
                phi_329_ = _e157;
            } else {
                phi_327_ = bool();
                phi_328_ = true;
                phi_329_ = false;
            }
            let _e159 = phi_327_;
            let _e161 = phi_328_;
            let _e163 = phi_329_;
            phi_330_ = _e159;
            phi_331_ = _e161;
            phi_332_ = _e163;
        } else {
            phi_330_ = bool();
            phi_331_ = true;
            phi_332_ = false;
        }
        let _e165 = phi_330_;
        let _e167 = phi_331_;
        let _e169 = phi_332_;
        if _e167 {
            phi_336_ = true;
        } else {
            phi_336_ = _e169;
        }
        let _e171 = phi_336_;
        if _e171 {
            phi_340_ = false;
        } else {
            phi_340_ = _e165;
        }
        let _e173 = phi_340_;
        if _e173 {
            let _e174 = (0u >= _e57);
            if _e174 {
                phi_1628_ = bool();
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
                let _e241 = core_intrinsics_maximum_number_nsz_f32_(abs(_e108.x), abs(_e108.y));
                let _e242 = core_intrinsics_maximum_number_nsz_f32_(_e241, abs(_e108.z));
                let _e243 = (_e242 * 0.0000000000009094947f);
                if (abs(_e109.direction.x) < _e243) {
                    phi_414_ = _e243;
                } else {
                    phi_414_ = abs(_e109.direction.x);
                }
                let _e250 = phi_414_;
                if (_e109.direction.x < 0f) {
                    phi_421_ = (-1f / _e250);
                } else {
                    phi_421_ = (1f / _e250);
                }
                let _e255 = phi_421_;
                if (abs(_e109.direction.y) < _e243) {
                    phi_429_ = _e243;
                } else {
                    phi_429_ = abs(_e109.direction.y);
                }
                let _e262 = phi_429_;
                if (_e109.direction.y < 0f) {
                    phi_436_ = (-1f / _e262);
                } else {
                    phi_436_ = (1f / _e262);
                }
                let _e267 = phi_436_;
                if (abs(_e109.direction.z) < _e243) {
                    phi_444_ = _e243;
                } else {
                    phi_444_ = abs(_e109.direction.z);
                }
                let _e274 = phi_444_;
                if (_e109.direction.z < 0f) {
                    phi_451_ = (-1f / _e274);
                } else {
                    phi_451_ = (1f / _e274);
                }
                let _e279 = phi_451_;
                let _e283 = abs((bitcast<f32>(_e180) - _e97));
                let _e284 = abs((bitcast<f32>(_e184) - _e99));
                let _e285 = abs((bitcast<f32>(_e188) - _e101));
                let _e289 = abs(((bitcast<f32>(_e192) + (bitcast<f32>((((_e204 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e97));
                let _e290 = abs(((bitcast<f32>(_e196) + (bitcast<f32>((((_e204 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e99));
                let _e291 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e204 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e101));
                if (_e283 > _e289) {
                    phi_468_ = _e283;
                } else {
                    phi_468_ = _e289;
                }
                let _e294 = phi_468_;
                if (_e284 > _e290) {
                    phi_473_ = _e284;
                } else {
                    phi_473_ = _e290;
                }
                let _e297 = phi_473_;
                if (_e285 > _e291) {
                    phi_478_ = _e285;
                } else {
                    phi_478_ = _e291;
                }
                let _e300 = phi_478_;
                let _e301 = core_intrinsics_maximum_number_nsz_f32_(_e294, _e297);
                let _e302 = core_intrinsics_maximum_number_nsz_f32_(_e301, _e300);
                let _e306 = (_e302 * 0.0000019073486f);
                let _e307 = (abs(_e255) * _e306);
                let _e308 = (abs(_e267) * _e306);
                let _e309 = (abs(_e279) * _e306);
                let _e313 = (_e302 * 0.0000009536743f);
                let _e314 = (abs(_e255) * _e313);
                let _e315 = (abs(_e267) * _e313);
                let _e316 = (abs(_e279) * _e313);
                let _e318 = abs(_e108.x);
                let _e320 = abs(_e108.y);
                let _e322 = abs(_e108.z);
                if (_e318 >= _e320) {
                    if (_e318 >= _e322) {
                        phi_509_ = false;
                    } else {
                        phi_509_ = true;
                    }
                    let _e326 = phi_509_;
                    phi_510_ = _e326;
                } else {
                    phi_510_ = true;
                }
                let _e328 = phi_510_;
                if _e328 {
                    if (_e320 >= _e322) {
                        phi_518_ = 1u;
                    } else {
                        phi_518_ = 2u;
                    }
                    let _e331 = phi_518_;
                    phi_519_ = _e331;
                } else {
                    phi_519_ = 0u;
                }
                let _e333 = phi_519_;
                if (_e333 == 0u) {
                    phi_537_ = vec3<f32>(_e108.y, _e108.z, _e108.x);
                } else {
                    if (_e333 == 1u) {
                        phi_536_ = vec3<f32>(_e108.z, _e108.x, _e108.y);
                    } else {
                        phi_536_ = _e108;
                    }
                    let _e345 = phi_536_;
                    phi_537_ = _e345;
                }
                let _e347 = phi_537_;
                let _e350 = (_e347.x / _e347.z);
                let _e353 = (_e347.y / _e347.z);
                let _e355 = (1f / _e347.z);
                if (_e255 < 0f) {
                    phi_550_ = 0u;
                } else {
                    phi_550_ = 1u;
                }
                let _e358 = phi_550_;
                if (_e267 < 0f) {
                    phi_555_ = 0u;
                } else {
                    phi_555_ = 2u;
                }
                let _e361 = phi_555_;
                if (_e279 < 0f) {
                    phi_560_ = 0u;
                } else {
                    phi_560_ = 4u;
                }
                let _e364 = phi_560_;
                let _e366 = ((_e358 | _e361) | _e364);
                let _e367 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e367.first[0], _e367.first[1], _e367.first[2], _e367.first[3], _e367.first[4], _e367.first[5], _e367.first[6], _e367.first[7], _e367.first[8], _e367.first[9], _e367.first[10], _e367.first[11], _e367.first[12], _e367.first[13], _e367.first[14], _e367.first[15], _e367.first[16], _e367.first[17], _e367.first[18], _e367.first[19], _e367.first[20], _e367.first[21], _e367.first[22], _e367.first[23], _e367.first[24], _e367.first[25], _e367.first[26], _e367.first[27], _e367.first[28], _e367.first[29], _e367.first[30], _e367.first[31]), array<u32, 32>(_e367.mask[0], _e367.mask[1], _e367.mask[2], _e367.mask[3], _e367.mask[4], _e367.mask[5], _e367.mask[6], _e367.mask[7], _e367.mask[8], _e367.mask[9], _e367.mask[10], _e367.mask[11], _e367.mask[12], _e367.mask[13], _e367.mask[14], _e367.mask[15], _e367.mask[16], _e367.mask[17], _e367.mask[18], _e367.mask[19], _e367.mask[20], _e367.mask[21], _e367.mask[22], _e367.mask[23], _e367.mask[24], _e367.mask[25], _e367.mask[26], _e367.mask[27], _e367.mask[28], _e367.mask[29], _e367.mask[30], _e367.mask[31]), _e367.len, _e367.group, _e367.group_mask);
                let _e441 = local.group_mask;
                if ((_e441 & 4278190080u) == 0u) {
                    let _e445 = local.len;
                    if (_e445 == 0u) {
                        phi_674_ = false;
                    } else {
                        let _e449 = local.len;
                        local.len = (_e449 - 1u);
                        let _e452 = local.len;
                        if (_e452 < 32u) {
                        } else {
                            return;
                        }
                        let _e457 = local.first[(0u + _e452)];
                        local.group = _e457;
                        let _e460 = local.len;
                        if (_e460 < 32u) {
                        } else {
                            return;
                        }
                        let _e465 = local.mask[(0u + _e460)];
                        local.group_mask = _e465;
                        phi_674_ = true;
                    }
                    let _e468 = phi_674_;
                    phi_675_ = _e468;
                } else {
                    phi_675_ = true;
                }
                let _e470 = phi_675_;
                if _e470 {
                    let _e472 = local.group_mask;
                    let _e478 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e472)), 32u, (_e472 == 0u)));
                    let _e482 = local.group_mask;
                    let _e496 = local.group_mask;
                    local.group_mask = (_e496 & ~((1u << bitcast<u32>((_e478 & 31u)))));
                    let _e499 = local.group;
                    phi_706_ = (_e499 + countOneBits(((_e482 & ~((4294967295u << bitcast<u32>((((_e478 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_706_ = 4294967295u;
                }
                let _e502 = phi_706_;
                phi_708_ = _e502;
                loop {
                    let _e504 = phi_708_;
                    if (_e504 != 4294967295u) {
                        if (_e504 < _e57) {
                        } else {
                            return;
                        }
                        let _e511 = nodes.member[(0u + _e504)].frame[3u];
                        let _e536 = (bitcast<f32>((((_e511 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e255);
                        let _e537 = (bitcast<f32>((((_e511 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e267);
                        let _e538 = (bitcast<f32>((((_e511 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e279);
                        let _e541 = nodes.member[(0u + _e504)].frame[0u];
                        let _e545 = nodes.member[(0u + _e504)].frame[1u];
                        let _e549 = nodes.member[(0u + _e504)].frame[2u];
                        let _e554 = ((bitcast<f32>(_e541) - _e97) * _e255);
                        let _e555 = ((bitcast<f32>(_e545) - _e99) * _e267);
                        let _e556 = ((bitcast<f32>(_e549) - _e101) * _e279);
                        let _e564 = nodes.member[(0u + _e504)].x;
                        if (_e255 < 0f) {
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e564.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e575.unnamed.root, _e564.w), _e575.unnamed_1);
                            let _e587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e581.unnamed, lt_bvh_traverse_Tree(_e564.x, _e581.unnamed_1.first_primitive));
                            phi_789_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e587.unnamed, lt_bvh_traverse_Tree(_e587.unnamed_1.root, _e564.y));
                        } else {
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e564.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e603.unnamed.root, _e564.y), _e603.unnamed_1);
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e609.unnamed, lt_bvh_traverse_Tree(_e564.z, _e609.unnamed_1.first_primitive));
                            phi_789_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e615.unnamed, lt_bvh_traverse_Tree(_e615.unnamed_1.root, _e564.w));
                        }
                        let _e623 = phi_789_;
                        let _e633 = nodes.member[(0u + _e504)].y;
                        if (_e267 < 0f) {
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e644.unnamed.root, _e633.w), _e644.unnamed_1);
                            let _e656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e650.unnamed, lt_bvh_traverse_Tree(_e633.x, _e650.unnamed_1.first_primitive));
                            phi_816_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e656.unnamed, lt_bvh_traverse_Tree(_e656.unnamed_1.root, _e633.y));
                        } else {
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e633.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e672.unnamed.root, _e633.y), _e672.unnamed_1);
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e678.unnamed, lt_bvh_traverse_Tree(_e633.z, _e678.unnamed_1.first_primitive));
                            phi_816_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e684.unnamed, lt_bvh_traverse_Tree(_e684.unnamed_1.root, _e633.w));
                        }
                        let _e692 = phi_816_;
                        let _e702 = nodes.member[(0u + _e504)].z;
                        if (_e279 < 0f) {
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e713.unnamed.root, _e702.w), _e713.unnamed_1);
                            let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e719.unnamed, lt_bvh_traverse_Tree(_e702.x, _e719.unnamed_1.first_primitive));
                            phi_843_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e725.unnamed, lt_bvh_traverse_Tree(_e725.unnamed_1.root, _e702.y));
                        } else {
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e702.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e741.unnamed.root, _e702.y), _e741.unnamed_1);
                            let _e753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e747.unnamed, lt_bvh_traverse_Tree(_e702.z, _e747.unnamed_1.first_primitive));
                            phi_843_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e753.unnamed, lt_bvh_traverse_Tree(_e753.unnamed_1.root, _e702.w));
                        }
                        let _e761 = phi_843_;
                        phi_849_ = 0u;
                        phi_852_ = 0u;
                        loop {
                            let _e771 = phi_849_;
                            let _e773 = phi_852_;
                            local_1 = _e773;
                            local_2 = _e773;
                            local_3 = _e773;
                            let _e774 = (_e771 < 8u);
                            if _e774 {
                                let _e776 = (_e771 >> bitcast<u32>(2i));
                                let _e777 = (_e771 & 3u);
                                if (_e776 == 0u) {
                                    phi_866_ = _e623.unnamed.root;
                                } else {
                                    phi_866_ = _e623.unnamed.first_primitive;
                                }
                                let _e780 = phi_866_;
                                if (_e776 == 0u) {
                                    phi_876_ = _e692.unnamed.root;
                                } else {
                                    phi_876_ = _e692.unnamed.first_primitive;
                                }
                                let _e789 = phi_876_;
                                if (_e776 == 0u) {
                                    phi_886_ = _e761.unnamed.root;
                                } else {
                                    phi_886_ = _e761.unnamed.first_primitive;
                                }
                                let _e798 = phi_886_;
                                let _e811 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e780 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e536) + (_e554 - _e307)), ((f32(((_e789 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e537) + (_e555 - _e308)));
                                let _e812 = core_intrinsics_maximum_number_nsz_f32_(_e811, ((f32(((_e798 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e538) + (_e556 - _e309)));
                                if (_e776 == 0u) {
                                    phi_904_ = _e623.unnamed_1.root;
                                } else {
                                    phi_904_ = _e623.unnamed_1.first_primitive;
                                }
                                let _e815 = phi_904_;
                                if (_e776 == 0u) {
                                    phi_914_ = _e692.unnamed_1.root;
                                } else {
                                    phi_914_ = _e692.unnamed_1.first_primitive;
                                }
                                let _e824 = phi_914_;
                                if (_e776 == 0u) {
                                    phi_924_ = _e761.unnamed_1.root;
                                } else {
                                    phi_924_ = _e761.unnamed_1.first_primitive;
                                }
                                let _e833 = phi_924_;
                                let _e846 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e815 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e536) + (_e554 + _e307)), ((f32(((_e824 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e537) + (_e555 + _e308)));
                                let _e847 = core_intrinsics_minimum_number_nsz_f32_(_e846, ((f32(((_e833 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u)) * _e538) + (_e556 + _e309)));
                                if (_e812 <= _e847) {
                                    if (_e812 <= _e107) {
                                        if (_e847 >= 0f) {
                                            if (_e776 == 0u) {
                                                let _e854 = nodes.member[(0u + _e504)].links[2u];
                                                phi_960_ = _e854;
                                            } else {
                                                let _e857 = nodes.member[(0u + _e504)].links[3u];
                                                phi_960_ = _e857;
                                            }
                                            let _e859 = phi_960_;
                                            let _e864 = ((_e859 >> bitcast<u32>(((_e777 * 8u) & 31u))) & 255u);
                                            let _e865 = (_e864 & 31u);
                                            if (_e865 >= 24u) {
                                                phi_973_ = (24u + ((_e865 - 24u) ^ _e366));
                                            } else {
                                                phi_973_ = _e865;
                                            }
                                            let _e871 = phi_973_;
                                            phi_978_ = (_e773 | ((_e864 >> bitcast<u32>(5i)) << bitcast<u32>((_e871 & 31u))));
                                        } else {
                                            phi_978_ = _e773;
                                        }
                                        let _e879 = phi_978_;
                                        phi_979_ = _e879;
                                    } else {
                                        phi_979_ = _e773;
                                    }
                                    let _e881 = phi_979_;
                                    phi_980_ = _e881;
                                } else {
                                    phi_980_ = _e773;
                                }
                                let _e883 = phi_980_;
                                phi_850_ = (_e771 + 1u);
                                phi_853_ = _e883;
                            } else {
                                phi_850_ = u32();
                                phi_853_ = u32();
                            }
                            let _e886 = phi_850_;
                            let _e888 = phi_853_;
                            continue;
                            continuing {
                                phi_849_ = _e886;
                                phi_852_ = _e888;
                                break if !(_e774);
                            }
                        }
                        let _e892 = nodes.member[(0u + _e504)].links[0u];
                        let _e896 = nodes.member[(0u + _e504)].frame[3u];
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
                        phi_1038_ = (_e937 & 16777215u);
                        loop {
                            let _e940 = phi_1038_;
                            let _e941 = (_e940 == 0u);
                            local_4 = _e941;
                            local_8 = _e941;
                            if _e941 {
                                phi_1039_ = u32();
                                phi_1531_ = false;
                                phi_1532_ = false;
                                phi_1533_ = false;
                            } else {
                                let _e944 = nodes.member[(0u + _e504)].links[1u];
                                let _e949 = ((0u + _e944) + select(firstTrailingBit(_e940), 32u, (_e940 == 0u)));
                                if (_e949 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e956 = triangles.member[(0u + _e949)].v0_;
                                let _e958 = (_e956.x - _e97);
                                let _e960 = (_e956.y - _e99);
                                let _e962 = (_e956.z - _e101);
                                if (_e333 == 0u) {
                                    phi_1084_ = vec3<f32>(_e960, _e962, _e958);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1083_ = vec3<f32>(_e962, _e958, _e960);
                                    } else {
                                        phi_1083_ = (_e956 - vec3<f32>(_e97, _e99, _e101));
                                    }
                                    let _e970 = phi_1083_;
                                    phi_1084_ = _e970;
                                }
                                let _e972 = phi_1084_;
                                let _e976 = (_e972.x - (_e350 * _e972.z));
                                let _e980 = (_e972.y - (_e353 * _e972.z));
                                let _e984 = triangles.member[(0u + _e949)].v1_;
                                let _e986 = (_e984.x - _e97);
                                let _e988 = (_e984.y - _e99);
                                let _e990 = (_e984.z - _e101);
                                if (_e333 == 0u) {
                                    phi_1116_ = vec3<f32>(_e988, _e990, _e986);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1115_ = vec3<f32>(_e990, _e986, _e988);
                                    } else {
                                        phi_1115_ = (_e984 - vec3<f32>(_e97, _e99, _e101));
                                    }
                                    let _e998 = phi_1115_;
                                    phi_1116_ = _e998;
                                }
                                let _e1000 = phi_1116_;
                                let _e1004 = (_e1000.x - (_e350 * _e1000.z));
                                let _e1008 = (_e1000.y - (_e353 * _e1000.z));
                                let _e1012 = triangles.member[(0u + _e949)].v2_;
                                let _e1014 = (_e1012.x - _e97);
                                let _e1016 = (_e1012.y - _e99);
                                let _e1018 = (_e1012.z - _e101);
                                if (_e333 == 0u) {
                                    phi_1148_ = vec3<f32>(_e1016, _e1018, _e1014);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1147_ = vec3<f32>(_e1018, _e1014, _e1016);
                                    } else {
                                        phi_1147_ = (_e1012 - vec3<f32>(_e97, _e99, _e101));
                                    }
                                    let _e1026 = phi_1147_;
                                    phi_1148_ = _e1026;
                                }
                                let _e1028 = phi_1148_;
                                let _e1032 = (_e1028.x - (_e350 * _e1028.z));
                                let _e1036 = (_e1028.y - (_e353 * _e1028.z));
                                if (_e1004 < _e1032) {
                                    phi_1169_ = true;
                                } else {
                                    if (_e1004 == _e1032) {
                                        phi_1168_ = (_e1008 < _e1036);
                                    } else {
                                        phi_1168_ = false;
                                    }
                                    let _e1043 = phi_1168_;
                                    phi_1169_ = _e1043;
                                }
                                let _e1045 = phi_1169_;
                                if _e1045 {
                                    phi_1173_ = _e1036;
                                    phi_1174_ = _e1032;
                                    phi_1175_ = _e1008;
                                    phi_1176_ = _e1004;
                                } else {
                                    phi_1173_ = _e1008;
                                    phi_1174_ = _e1004;
                                    phi_1175_ = _e1036;
                                    phi_1176_ = _e1032;
                                }
                                let _e1047 = phi_1173_;
                                let _e1049 = phi_1174_;
                                let _e1051 = phi_1175_;
                                let _e1053 = phi_1176_;
                                let _e1056 = ((_e1053 * _e1047) - (_e1051 * _e1049));
                                if _e1045 {
                                    phi_1184_ = -(_e1056);
                                } else {
                                    phi_1184_ = _e1056;
                                }
                                let _e1059 = phi_1184_;
                                if (_e1032 < _e976) {
                                    phi_1195_ = true;
                                } else {
                                    if (_e1032 == _e976) {
                                        phi_1194_ = (_e1036 < _e980);
                                    } else {
                                        phi_1194_ = false;
                                    }
                                    let _e1064 = phi_1194_;
                                    phi_1195_ = _e1064;
                                }
                                let _e1066 = phi_1195_;
                                if _e1066 {
                                    phi_1199_ = _e980;
                                    phi_1200_ = _e976;
                                    phi_1201_ = _e1036;
                                    phi_1202_ = _e1032;
                                } else {
                                    phi_1199_ = _e1036;
                                    phi_1200_ = _e1032;
                                    phi_1201_ = _e980;
                                    phi_1202_ = _e976;
                                }
                                let _e1068 = phi_1199_;
                                let _e1070 = phi_1200_;
                                let _e1072 = phi_1201_;
                                let _e1074 = phi_1202_;
                                let _e1077 = ((_e1074 * _e1068) - (_e1072 * _e1070));
                                if _e1066 {
                                    phi_1210_ = -(_e1077);
                                } else {
                                    phi_1210_ = _e1077;
                                }
                                let _e1080 = phi_1210_;
                                if (_e976 < _e1004) {
                                    phi_1221_ = true;
                                } else {
                                    if (_e976 == _e1004) {
                                        phi_1220_ = (_e980 < _e1008);
                                    } else {
                                        phi_1220_ = false;
                                    }
                                    let _e1085 = phi_1220_;
                                    phi_1221_ = _e1085;
                                }
                                let _e1087 = phi_1221_;
                                if _e1087 {
                                    phi_1225_ = _e1008;
                                    phi_1226_ = _e1004;
                                    phi_1227_ = _e980;
                                    phi_1228_ = _e976;
                                } else {
                                    phi_1225_ = _e980;
                                    phi_1226_ = _e976;
                                    phi_1227_ = _e1008;
                                    phi_1228_ = _e1004;
                                }
                                let _e1089 = phi_1225_;
                                let _e1091 = phi_1226_;
                                let _e1093 = phi_1227_;
                                let _e1095 = phi_1228_;
                                let _e1098 = ((_e1095 * _e1089) - (_e1093 * _e1091));
                                if _e1087 {
                                    phi_1236_ = -(_e1098);
                                } else {
                                    phi_1236_ = _e1098;
                                }
                                let _e1101 = phi_1236_;
                                if (_e1059 >= 0f) {
                                    if (_e1080 >= 0f) {
                                        if (_e1101 >= 0f) {
                                            phi_1251_ = ((_e1059 + _e1080) + _e1101);
                                            phi_1252_ = false;
                                        } else {
                                            phi_1251_ = f32();
                                            phi_1252_ = true;
                                        }
                                        let _e1108 = phi_1251_;
                                        let _e1110 = phi_1252_;
                                        phi_1253_ = _e1108;
                                        phi_1254_ = _e1110;
                                    } else {
                                        phi_1253_ = f32();
                                        phi_1254_ = true;
                                    }
                                    let _e1112 = phi_1253_;
                                    let _e1114 = phi_1254_;
                                    phi_1255_ = _e1112;
                                    phi_1256_ = _e1114;
                                } else {
                                    phi_1255_ = f32();
                                    phi_1256_ = true;
                                }
                                let _e1116 = phi_1255_;
                                let _e1118 = phi_1256_;
                                if _e1118 {
                                    if (_e1059 <= 0f) {
                                        if (_e1080 <= 0f) {
                                            let _e1121 = (_e1101 <= 0f);
                                            if _e1121 {
                                            }
                                            phi_1274_ = ((_e1059 + _e1080) + _e1101);
                                            phi_1275_ = false;
                                            phi_1276_ = _e1121;
                                        } else {
                                            phi_1274_ = f32();
                                            phi_1275_ = true;
                                            phi_1276_ = false;
                                        }
                                        let _e1125 = phi_1274_;
                                        let _e1127 = phi_1275_;
                                        let _e1129 = phi_1276_;
                                        phi_1277_ = _e1125;
                                        phi_1278_ = _e1127;
                                        phi_1279_ = _e1129;
                                    } else {
                                        phi_1277_ = f32();
                                        phi_1278_ = true;
                                        phi_1279_ = false;
                                    }
                                    let _e1131 = phi_1277_;
                                    let _e1133 = phi_1278_;
                                    let _e1135 = phi_1279_;
                                    if _e1133 {
                                        phi_1283_ = false;
                                    } else {
                                        phi_1283_ = _e1135;
                                    }
                                    let _e1137 = phi_1283_;
                                    phi_1284_ = _e1131;
                                    phi_1285_ = _e1137;
                                } else {
                                    phi_1284_ = _e1116;
                                    phi_1285_ = true;
                                }
                                let _e1139 = phi_1284_;
                                let _e1141 = phi_1285_;
                                if _e1141 {
                                    let _e1142 = (_e1139 == 0f);
                                    if _e1142 {
                                        phi_1483_ = lt_bvh_triangle_Intersection();
                                    } else {
                                        let _e1148 = ((((_e1059 * (_e355 * _e972.z)) + (_e1080 * (_e355 * _e1000.z))) + (_e1101 * (_e355 * _e1028.z))) / _e1139);
                                        let _e1150 = triangles.member[(0u + _e949)].v0_;
                                        let _e1152 = triangles.member[(0u + _e949)].v1_;
                                        if (_e1150.x < _e1152.x) {
                                            phi_1311_ = _e1150.x;
                                        } else {
                                            phi_1311_ = _e1152.x;
                                        }
                                        let _e1159 = phi_1311_;
                                        if (_e1150.y < _e1152.y) {
                                            phi_1320_ = _e1150.y;
                                        } else {
                                            phi_1320_ = _e1152.y;
                                        }
                                        let _e1166 = phi_1320_;
                                        if (_e1150.z < _e1152.z) {
                                            phi_1329_ = _e1150.z;
                                        } else {
                                            phi_1329_ = _e1152.z;
                                        }
                                        let _e1173 = phi_1329_;
                                        let _e1175 = triangles.member[(0u + _e949)].v2_;
                                        if (_e1159 < _e1175.x) {
                                            phi_1338_ = _e1159;
                                        } else {
                                            phi_1338_ = _e1175.x;
                                        }
                                        let _e1180 = phi_1338_;
                                        if (_e1166 < _e1175.y) {
                                            phi_1345_ = _e1166;
                                        } else {
                                            phi_1345_ = _e1175.y;
                                        }
                                        let _e1185 = phi_1345_;
                                        if (_e1173 < _e1175.z) {
                                            phi_1352_ = _e1173;
                                        } else {
                                            phi_1352_ = _e1175.z;
                                        }
                                        let _e1190 = phi_1352_;
                                        let _e1192 = triangles.member[(0u + _e949)].v0_;
                                        let _e1194 = triangles.member[(0u + _e949)].v1_;
                                        if (_e1192.x > _e1194.x) {
                                            phi_1365_ = _e1192.x;
                                        } else {
                                            phi_1365_ = _e1194.x;
                                        }
                                        let _e1201 = phi_1365_;
                                        if (_e1192.y > _e1194.y) {
                                            phi_1374_ = _e1192.y;
                                        } else {
                                            phi_1374_ = _e1194.y;
                                        }
                                        let _e1208 = phi_1374_;
                                        if (_e1192.z > _e1194.z) {
                                            phi_1383_ = _e1192.z;
                                        } else {
                                            phi_1383_ = _e1194.z;
                                        }
                                        let _e1215 = phi_1383_;
                                        let _e1217 = triangles.member[(0u + _e949)].v2_;
                                        if (_e1201 > _e1217.x) {
                                            phi_1392_ = _e1201;
                                        } else {
                                            phi_1392_ = _e1217.x;
                                        }
                                        let _e1222 = phi_1392_;
                                        if (_e1208 > _e1217.y) {
                                            phi_1399_ = _e1208;
                                        } else {
                                            phi_1399_ = _e1217.y;
                                        }
                                        let _e1227 = phi_1399_;
                                        if (_e1215 > _e1217.z) {
                                            phi_1406_ = _e1215;
                                        } else {
                                            phi_1406_ = _e1217.z;
                                        }
                                        let _e1232 = phi_1406_;
                                        let _e1236 = ((_e1180 - _e97) * _e255);
                                        let _e1237 = ((_e1185 - _e99) * _e267);
                                        let _e1238 = ((_e1190 - _e101) * _e279);
                                        let _e1242 = ((_e1222 - _e97) * _e255);
                                        let _e1243 = ((_e1227 - _e99) * _e267);
                                        let _e1244 = ((_e1232 - _e101) * _e279);
                                        if (_e1236 < _e1242) {
                                            phi_1423_ = _e1236;
                                        } else {
                                            phi_1423_ = _e1242;
                                        }
                                        let _e1247 = phi_1423_;
                                        if (_e1237 < _e1243) {
                                            phi_1428_ = _e1237;
                                        } else {
                                            phi_1428_ = _e1243;
                                        }
                                        let _e1250 = phi_1428_;
                                        if (_e1238 < _e1244) {
                                            phi_1433_ = _e1238;
                                        } else {
                                            phi_1433_ = _e1244;
                                        }
                                        let _e1253 = phi_1433_;
                                        if (_e1236 > _e1242) {
                                            phi_1441_ = _e1236;
                                        } else {
                                            phi_1441_ = _e1242;
                                        }
                                        let _e1259 = phi_1441_;
                                        if (_e1237 > _e1243) {
                                            phi_1446_ = _e1237;
                                        } else {
                                            phi_1446_ = _e1243;
                                        }
                                        let _e1262 = phi_1446_;
                                        if (_e1238 > _e1244) {
                                            phi_1451_ = _e1238;
                                        } else {
                                            phi_1451_ = _e1244;
                                        }
                                        let _e1265 = phi_1451_;
                                        let _e1269 = core_intrinsics_maximum_number_nsz_f32_((_e1247 - _e314), (_e1250 - _e315));
                                        let _e1270 = core_intrinsics_maximum_number_nsz_f32_(_e1269, (_e1253 - _e316));
                                        let _e1271 = core_intrinsics_minimum_number_nsz_f32_((_e1259 + _e314), (_e1262 + _e315));
                                        let _e1272 = core_intrinsics_minimum_number_nsz_f32_(_e1271, (_e1265 + _e316));
                                        if (_e1270 > -300000000000000000000000000000000000000f) {
                                            phi_1463_ = _e1270;
                                        } else {
                                            phi_1463_ = -300000000000000000000000000000000000000f;
                                        }
                                        let _e1275 = phi_1463_;
                                        if (_e1272 < 300000000000000000000000000000000000000f) {
                                            phi_1468_ = _e1272;
                                        } else {
                                            phi_1468_ = 300000000000000000000000000000000000000f;
                                        }
                                        let _e1278 = phi_1468_;
                                        if (_e1148 < _e1275) {
                                            phi_1473_ = _e1275;
                                        } else {
                                            phi_1473_ = _e1148;
                                        }
                                        let _e1281 = phi_1473_;
                                        if (_e1281 > _e1278) {
                                            phi_1478_ = _e1278;
                                        } else {
                                            phi_1478_ = _e1281;
                                        }
                                        let _e1284 = phi_1478_;
                                        phi_1483_ = lt_bvh_triangle_Intersection(_e1284, (_e1080 / _e1139), (_e1101 / _e1139), (_e1275 <= _e1278));
                                    }
                                    let _e1290 = phi_1483_;
                                    phi_1484_ = _e1290;
                                    phi_1485_ = _e1142;
                                } else {
                                    phi_1484_ = lt_bvh_triangle_Intersection();
                                    phi_1485_ = true;
                                }
                                let _e1292 = phi_1484_;
                                let _e1294 = phi_1485_;
                                if _e1294 {
                                    phi_1489_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1489_ = _e1292;
                                }
                                let _e1296 = phi_1489_;
                                if _e1296.is_hit {
                                    if (_e1296.t > 0f) {
                                        if (_e1296.t < _e107) {
                                            let _e1303 = triangles.member[(0u + _e949)].i0_;
                                            let _e1305 = ((_e1303 & 2147483648u) == 0u);
                                            if _e1305 {
                                                phi_1515_ = false;
                                                phi_1516_ = false;
                                            } else {
                                                if true {
                                                    phi_1514_ = false;
                                                } else {
                                                    phi_1514_ = true;
                                                }
                                                let _e1307 = phi_1514_;
                                                phi_1515_ = _e1307;
                                                phi_1516_ = true;
                                            }
                                            let _e1309 = phi_1515_;
                                            let _e1311 = phi_1516_;
                                            phi_1517_ = _e1309;
                                            phi_1518_ = _e1305;
                                            phi_1519_ = _e1311;
                                        } else {
                                            phi_1517_ = true;
                                            phi_1518_ = false;
                                            phi_1519_ = false;
                                        }
                                        let _e1313 = phi_1517_;
                                        let _e1315 = phi_1518_;
                                        let _e1317 = phi_1519_;
                                        phi_1520_ = _e1313;
                                        phi_1521_ = _e1315;
                                        phi_1522_ = _e1317;
                                    } else {
                                        phi_1520_ = true;
                                        phi_1521_ = false;
                                        phi_1522_ = false;
                                    }
                                    let _e1319 = phi_1520_;
                                    let _e1321 = phi_1521_;
                                    let _e1323 = phi_1522_;
                                    phi_1523_ = _e1319;
                                    phi_1524_ = _e1321;
                                    phi_1525_ = _e1323;
                                } else {
                                    phi_1523_ = true;
                                    phi_1524_ = false;
                                    phi_1525_ = false;
                                }
                                let _e1325 = phi_1523_;
                                let _e1327 = phi_1524_;
                                let _e1329 = phi_1525_;
                                if _e1325 {
                                    phi_1529_ = false;
                                    phi_1530_ = false;
                                } else {
                                    phi_1529_ = _e1327;
                                    phi_1530_ = _e1329;
                                }
                                let _e1331 = phi_1529_;
                                let _e1333 = phi_1530_;
                                phi_1039_ = (_e940 & (_e940 - 1u));
                                phi_1531_ = _e1325;
                                phi_1532_ = _e1331;
                                phi_1533_ = _e1333;
                            }
                            let _e1335 = phi_1039_;
                            let _e1337 = phi_1531_;
                            let _e1339 = phi_1532_;
                            let _e1341 = phi_1533_;
                            local_6 = _e1339;
                            local_7 = _e1341;
                            continue;
                            continuing {
                                phi_1038_ = _e1335;
                                break if !(_e1337);
                            }
                        }
                        let _e1344 = local_4;
                        if _e1344 {
                            let _e1346 = local.group_mask;
                            if ((_e1346 & 4278190080u) == 0u) {
                                let _e1350 = local.len;
                                if (_e1350 == 0u) {
                                    phi_1575_ = false;
                                } else {
                                    let _e1354 = local.len;
                                    local.len = (_e1354 - 1u);
                                    let _e1357 = local.len;
                                    if (_e1357 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1362 = local.first[(0u + _e1357)];
                                    local.group = _e1362;
                                    let _e1365 = local.len;
                                    if (_e1365 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1370 = local.mask[(0u + _e1365)];
                                    local.group_mask = _e1370;
                                    phi_1575_ = true;
                                }
                                let _e1373 = phi_1575_;
                                phi_1576_ = _e1373;
                            } else {
                                phi_1576_ = true;
                            }
                            let _e1375 = phi_1576_;
                            if _e1375 {
                                let _e1377 = local.group_mask;
                                let _e1383 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1377)), 32u, (_e1377 == 0u)));
                                let _e1387 = local.group_mask;
                                let _e1401 = local.group_mask;
                                local.group_mask = (_e1401 & ~((1u << bitcast<u32>((_e1383 & 31u)))));
                                let _e1404 = local.group;
                                phi_1607_ = (_e1404 + countOneBits(((_e1387 & ~((4294967295u << bitcast<u32>((((_e1383 - 24u) ^ _e366) & 31u))))) & 255u)));
                            } else {
                                phi_1607_ = 4294967295u;
                            }
                            let _e1407 = phi_1607_;
                            phi_1608_ = _e1407;
                            phi_1609_ = false;
                            phi_1610_ = false;
                        } else {
                            phi_1608_ = u32();
                            let _e1609 = local_6;
                            phi_1609_ = _e1609;
                            let _e1612 = local_7;
                            phi_1610_ = _e1612;
                        }
                        let _e1409 = phi_1608_;
                        let _e1411 = phi_1609_;
                        let _e1413 = phi_1610_;
                        phi_709_ = _e1409;
                        let _e1616 = local_8;
                        phi_1611_ = _e1616;
                        phi_1612_ = false;
                        phi_1613_ = _e1411;
                        phi_1614_ = _e1413;
                    } else {
                        phi_709_ = u32();
                        phi_1611_ = false;
                        phi_1612_ = true;
                        phi_1613_ = false;
                        phi_1614_ = false;
                    }
                    let _e1415 = phi_709_;
                    let _e1417 = phi_1611_;
                    let _e1419 = phi_1612_;
                    let _e1421 = phi_1613_;
                    let _e1423 = phi_1614_;
                    local_5 = _e1419;
                    local_9 = _e1421;
                    local_10 = _e1423;
                    continue;
                    continuing {
                        phi_708_ = _e1415;
                        break if !(_e1417);
                    }
                }
                let _e1426 = local_5;
                if _e1426 {
                    phi_1618_ = false;
                    phi_1619_ = false;
                } else {
                    let _e1623 = local_9;
                    phi_1618_ = _e1623;
                    let _e1626 = local_10;
                    phi_1619_ = _e1626;
                }
                let _e1428 = phi_1618_;
                let _e1430 = phi_1619_;
                if _e1428 {
                    phi_1623_ = true;
                } else {
                    phi_1623_ = _e1430;
                }
                let _e1432 = phi_1623_;
                if _e1432 {
                    phi_1627_ = true;
                } else {
                    phi_1627_ = false;
                }
                let _e1434 = phi_1627_;
                phi_1628_ = _e1434;
            }
            let _e1436 = phi_1628_;
            phi_1629_ = _e1436;
            phi_1630_ = _e174;
        } else {
            phi_1629_ = bool();
            phi_1630_ = true;
        }
        let _e1438 = phi_1629_;
        let _e1440 = phi_1630_;
        if _e1440 {
            phi_1634_ = false;
        } else {
            phi_1634_ = _e1438;
        }
        let _e1442 = phi_1634_;
        if _e1442 {
            phi_1638_ = 0f;
        } else {
            phi_1638_ = 1f;
        }
        let _e1444 = phi_1638_;
        if (_e76 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e76)] = _e1444;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
