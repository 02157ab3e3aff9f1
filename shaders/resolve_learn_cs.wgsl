struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
    member: array<f32>,
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

struct type_33 {
    member: abi_ShadowParams,
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

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_41 {
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
var<storage> samples: type_20;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(0) 
var<uniform> p: type_33;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage, read_write> bits: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_160_: bool;
    var phi_164_: f32;

    if (param != param) {
        phi_160_ = true;
    } else {
        let _e57 = (param_1 >= param);
        if _e57 {
        }
        phi_160_ = _e57;
    }
    let _e59 = phi_160_;
    if _e59 {
        phi_164_ = param_1;
    } else {
        phi_164_ = param;
    }
    let _e61 = phi_164_;
    return _e61;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_176_: bool;
    var phi_180_: f32;

    if (param_2 != param_2) {
        phi_176_ = true;
    } else {
        let _e57 = (param_3 <= param_2);
        if _e57 {
        }
        phi_176_ = _e57;
    }
    let _e59 = phi_176_;
    if _e59 {
        phi_180_ = param_3;
    } else {
        phi_180_ = param_2;
    }
    let _e61 = phi_180_;
    return _e61;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_257_: f32;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_295_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_315_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_342_: bool;
    var phi_412_: f32;
    var phi_419_: f32;
    var phi_426_: f32;
    var phi_433_: f32;
    var phi_440_: f32;
    var phi_447_: f32;
    var phi_464_: f32;
    var phi_469_: f32;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_484_: f32;
    var phi_510_: bool;
    var phi_511_: bool;
    var phi_519_: u32;
    var phi_520_: u32;
    var phi_531_: vec3<f32>;
    var phi_532_: vec3<f32>;
    var phi_545_: u32;
    var phi_550_: u32;
    var phi_555_: u32;
    var phi_669_: bool;
    var phi_670_: bool;
    var phi_701_: u32;
    var phi_703_: u32;
    var phi_706_: bool;
    var phi_786_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_813_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_840_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_846_: u32;
    var phi_849_: u32;
    var phi_863_: u32;
    var phi_873_: u32;
    var phi_883_: u32;
    var phi_901_: u32;
    var phi_911_: u32;
    var phi_921_: u32;
    var phi_957_: u32;
    var phi_970_: u32;
    var phi_975_: u32;
    var phi_976_: u32;
    var phi_977_: u32;
    var phi_847_: u32;
    var phi_850_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1035_: u32;
    var phi_1038_: bool;
    var phi_1082_: vec3<f32>;
    var phi_1083_: vec3<f32>;
    var phi_1112_: vec3<f32>;
    var phi_1113_: vec3<f32>;
    var phi_1142_: vec3<f32>;
    var phi_1143_: vec3<f32>;
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
    var phi_1213_: bool;
    var phi_1214_: bool;
    var phi_1218_: f32;
    var phi_1219_: f32;
    var phi_1220_: f32;
    var phi_1221_: f32;
    var phi_1229_: f32;
    var phi_1244_: f32;
    var phi_1245_: bool;
    var phi_1246_: f32;
    var phi_1247_: bool;
    var phi_1248_: f32;
    var phi_1249_: bool;
    var phi_1267_: f32;
    var phi_1268_: bool;
    var phi_1269_: bool;
    var phi_1270_: f32;
    var phi_1271_: bool;
    var phi_1272_: bool;
    var phi_1276_: bool;
    var phi_1277_: f32;
    var phi_1278_: bool;
    var phi_1306_: vec3<f32>;
    var phi_1307_: vec3<f32>;
    var phi_1332_: vec3<f32>;
    var phi_1333_: vec3<f32>;
    var phi_1358_: vec3<f32>;
    var phi_1359_: vec3<f32>;
    var phi_1415_: f32;
    var phi_1424_: f32;
    var phi_1433_: f32;
    var phi_1442_: f32;
    var phi_1449_: f32;
    var phi_1456_: f32;
    var phi_1469_: f32;
    var phi_1478_: f32;
    var phi_1487_: f32;
    var phi_1496_: f32;
    var phi_1503_: f32;
    var phi_1510_: f32;
    var phi_1527_: f32;
    var phi_1532_: f32;
    var phi_1537_: f32;
    var phi_1545_: f32;
    var phi_1550_: f32;
    var phi_1555_: f32;
    var phi_1567_: f32;
    var phi_1572_: f32;
    var phi_1577_: f32;
    var phi_1582_: f32;
    var phi_1587_: lt_bvh_triangle_Intersection;
    var phi_1588_: bool;
    var phi_1589_: lt_bvh_triangle_Intersection;
    var phi_1590_: bool;
    var phi_1594_: lt_bvh_triangle_Intersection;
    var phi_1595_: bool;
    var phi_1596_: lt_bvh_triangle_Intersection;
    var phi_1597_: bool;
    var phi_1598_: bool;
    var phi_1602_: bool;
    var phi_1606_: lt_bvh_triangle_Intersection;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1632_: bool;
    var phi_1036_: u32;
    var phi_1039_: bool;
    var phi_1636_: bool;
    var local_4: bool;
    var phi_1678_: bool;
    var phi_1679_: bool;
    var phi_1710_: u32;
    var phi_1711_: u32;
    var phi_704_: u32;
    var phi_707_: bool;
    var phi_1712_: bool;
    var phi_1713_: bool;
    var local_5: bool;
    var phi_1717_: bool;
    var phi_1721_: bool;
    var phi_1722_: bool;
    var phi_1723_: bool;
    var phi_1724_: bool;
    var phi_1728_: bool;
    var phi_1732_: f32;
    var phi_1773_: u32;
    var phi_1792_: u32;
    var phi_1800_: u32;
    var phi_1808_: u32;
    var phi_1813_: u32;
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
            phi_257_ = 300000000000000000000000000000000000000f;
        } else {
            phi_257_ = 1f;
        }
        let _e117 = phi_257_;
        let _e125 = (_e113.x - (_e107 * _e113.w));
        let _e126 = (_e113.y - (_e109 * _e113.w));
        let _e127 = (_e113.z - (_e111 * _e113.w));
        let _e129 = abs(_e125);
        let _e130 = abs(_e126);
        let _e131 = abs(_e127);
        if (abs(_e107) < 1000000000000000f) {
            if (abs(_e109) < 1000000000000000f) {
                phi_288_ = (abs(_e111) < 1000000000000000f);
                phi_289_ = false;
            } else {
                phi_288_ = bool();
                phi_289_ = true;
            }
            let _e139 = phi_288_;
            let _e141 = phi_289_;
            phi_290_ = _e139;
            phi_291_ = _e141;
        } else {
            phi_290_ = bool();
            phi_291_ = true;
        }
        let _e143 = phi_290_;
        let _e145 = phi_291_;
        if _e145 {
            phi_295_ = false;
        } else {
            phi_295_ = _e143;
        }
        let _e147 = phi_295_;
        if _e147 {
            if (_e129 < 1000000000000000f) {
                if (_e130 < 1000000000000000f) {
                    phi_308_ = (_e131 < 1000000000000000f);
                    phi_309_ = false;
                } else {
                    phi_308_ = bool();
                    phi_309_ = true;
                }
                let _e152 = phi_308_;
                let _e154 = phi_309_;
                phi_310_ = _e152;
                phi_311_ = _e154;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
            }
            let _e156 = phi_310_;
            let _e158 = phi_311_;
            if _e158 {
                phi_315_ = false;
            } else {
                phi_315_ = _e156;
            }
            let _e160 = phi_315_;
            if _e160 {
                if (_e129 > 0f) {
                    phi_329_ = bool();
                    phi_330_ = true;
                } else {
                    let _e162 = (_e130 > 0f);
                    if _e162 {
                        phi_328_ = bool();
                    } else {
                        phi_328_ = (_e131 > 0f);
                    }
                    let _e165 = phi_328_;
                    phi_329_ = _e165;
                    phi_330_ = _e162;
                }
                let _e167 = phi_329_;
                let _e169 = phi_330_;
                if _e169 {
                    phi_334_ = true;
                } else {
                    phi_334_ = _e167;
                }
                let _e171 = phi_334_;
                phi_335_ = _e171;
                phi_336_ = false;
            } else {
                phi_335_ = bool();
                phi_336_ = true;
            }
            let _e173 = phi_335_;
            let _e175 = phi_336_;
            phi_337_ = _e173;
            phi_338_ = _e175;
        } else {
            phi_337_ = bool();
            phi_338_ = true;
        }
        let _e177 = phi_337_;
        let _e179 = phi_338_;
        if _e179 {
            phi_342_ = false;
        } else {
            phi_342_ = _e177;
        }
        let _e181 = phi_342_;
        if _e181 {
            let _e182 = (0u >= _e62);
            if _e182 {
                phi_1722_ = bool();
            } else {
                if (0u < _e62) {
                } else {
                    return;
                }
                let _e188 = nodes.member[(0u + 0u)].frame[0u];
                let _e192 = nodes.member[(0u + 0u)].frame[1u];
                let _e196 = nodes.member[(0u + 0u)].frame[2u];
                let _e200 = nodes.member[(0u + 0u)].frame[0u];
                let _e204 = nodes.member[(0u + 0u)].frame[1u];
                let _e208 = nodes.member[(0u + 0u)].frame[2u];
                let _e212 = nodes.member[(0u + 0u)].frame[3u];
                let _e246 = core_intrinsics_maximum_number_nsz_f32_(abs(_e125), abs(_e126));
                let _e247 = core_intrinsics_maximum_number_nsz_f32_(_e246, abs(_e127));
                let _e248 = (_e247 * 0.0000000000009094947f);
                if (abs(_e125) < _e248) {
                    phi_412_ = _e248;
                } else {
                    phi_412_ = abs(_e125);
                }
                let _e253 = phi_412_;
                if (_e125 < 0f) {
                    phi_419_ = (-1f / _e253);
                } else {
                    phi_419_ = (1f / _e253);
                }
                let _e258 = phi_419_;
                if (abs(_e126) < _e248) {
                    phi_426_ = _e248;
                } else {
                    phi_426_ = abs(_e126);
                }
                let _e263 = phi_426_;
                if (_e126 < 0f) {
                    phi_433_ = (-1f / _e263);
                } else {
                    phi_433_ = (1f / _e263);
                }
                let _e268 = phi_433_;
                if (abs(_e127) < _e248) {
                    phi_440_ = _e248;
                } else {
                    phi_440_ = abs(_e127);
                }
                let _e273 = phi_440_;
                if (_e127 < 0f) {
                    phi_447_ = (-1f / _e273);
                } else {
                    phi_447_ = (1f / _e273);
                }
                let _e278 = phi_447_;
                let _e282 = abs((bitcast<f32>(_e188) - _e107));
                let _e283 = abs((bitcast<f32>(_e192) - _e109));
                let _e284 = abs((bitcast<f32>(_e196) - _e111));
                let _e288 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e212 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e289 = abs(((bitcast<f32>(_e204) + (bitcast<f32>((((_e212 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                let _e290 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e212 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e111));
                if (_e282 > _e288) {
                    phi_464_ = _e282;
                } else {
                    phi_464_ = _e288;
                }
                let _e293 = phi_464_;
                if (_e283 > _e289) {
                    phi_469_ = _e283;
                } else {
                    phi_469_ = _e289;
                }
                let _e296 = phi_469_;
                if (_e284 > _e290) {
                    phi_474_ = _e284;
                } else {
                    phi_474_ = _e290;
                }
                let _e299 = phi_474_;
                if (_e293 > _e296) {
                    phi_479_ = _e293;
                } else {
                    phi_479_ = _e296;
                }
                let _e302 = phi_479_;
                if (_e302 > _e299) {
                    phi_484_ = _e302;
                } else {
                    phi_484_ = _e299;
                }
                let _e305 = phi_484_;
                let _e309 = (_e305 * 0.0000019073486f);
                let _e310 = (abs(_e258) * _e309);
                let _e311 = (abs(_e268) * _e309);
                let _e312 = (abs(_e278) * _e309);
                let _e316 = (_e305 * 0.0000009536743f);
                let _e317 = (abs(_e258) * _e316);
                let _e318 = (abs(_e268) * _e316);
                let _e319 = (abs(_e278) * _e316);
                let _e320 = abs(_e125);
                let _e321 = abs(_e126);
                let _e322 = abs(_e127);
                if (_e320 >= _e321) {
                    if (_e320 >= _e322) {
                        phi_510_ = false;
                    } else {
                        phi_510_ = true;
                    }
                    let _e326 = phi_510_;
                    phi_511_ = _e326;
                } else {
                    phi_511_ = true;
                }
                let _e328 = phi_511_;
                if _e328 {
                    if (_e321 >= _e322) {
                        phi_519_ = 1u;
                    } else {
                        phi_519_ = 2u;
                    }
                    let _e331 = phi_519_;
                    phi_520_ = _e331;
                } else {
                    phi_520_ = 0u;
                }
                let _e333 = phi_520_;
                if (_e333 == 0u) {
                    phi_532_ = vec3<f32>(_e126, _e127, _e125);
                } else {
                    if (_e333 == 1u) {
                        phi_531_ = vec3<f32>(_e127, _e125, _e126);
                    } else {
                        phi_531_ = vec3<f32>(_e125, _e126, _e127);
                    }
                    let _e339 = phi_531_;
                    phi_532_ = _e339;
                }
                let _e341 = phi_532_;
                let _e344 = (_e341.x / _e341.z);
                let _e347 = (_e341.y / _e341.z);
                if (_e258 < 0f) {
                    phi_545_ = 0u;
                } else {
                    phi_545_ = 1u;
                }
                let _e352 = phi_545_;
                if (_e268 < 0f) {
                    phi_550_ = 0u;
                } else {
                    phi_550_ = 2u;
                }
                let _e355 = phi_550_;
                if (_e278 < 0f) {
                    phi_555_ = 0u;
                } else {
                    phi_555_ = 4u;
                }
                let _e358 = phi_555_;
                let _e360 = ((_e352 | _e355) | _e358);
                let _e361 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e361.first[0], _e361.first[1], _e361.first[2], _e361.first[3], _e361.first[4], _e361.first[5], _e361.first[6], _e361.first[7], _e361.first[8], _e361.first[9], _e361.first[10], _e361.first[11], _e361.first[12], _e361.first[13], _e361.first[14], _e361.first[15], _e361.first[16], _e361.first[17], _e361.first[18], _e361.first[19], _e361.first[20], _e361.first[21], _e361.first[22], _e361.first[23], _e361.first[24], _e361.first[25], _e361.first[26], _e361.first[27], _e361.first[28], _e361.first[29], _e361.first[30], _e361.first[31]), array<u32, 32>(_e361.mask[0], _e361.mask[1], _e361.mask[2], _e361.mask[3], _e361.mask[4], _e361.mask[5], _e361.mask[6], _e361.mask[7], _e361.mask[8], _e361.mask[9], _e361.mask[10], _e361.mask[11], _e361.mask[12], _e361.mask[13], _e361.mask[14], _e361.mask[15], _e361.mask[16], _e361.mask[17], _e361.mask[18], _e361.mask[19], _e361.mask[20], _e361.mask[21], _e361.mask[22], _e361.mask[23], _e361.mask[24], _e361.mask[25], _e361.mask[26], _e361.mask[27], _e361.mask[28], _e361.mask[29], _e361.mask[30], _e361.mask[31]), _e361.len, _e361.group, _e361.group_mask);
                let _e435 = local.group_mask;
                if ((_e435 & 4278190080u) == 0u) {
                    let _e439 = local.len;
                    if (_e439 == 0u) {
                        phi_669_ = false;
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
                        phi_669_ = true;
                    }
                    let _e462 = phi_669_;
                    phi_670_ = _e462;
                } else {
                    phi_670_ = true;
                }
                let _e464 = phi_670_;
                if _e464 {
                    let _e466 = local.group_mask;
                    let _e472 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e466)), 32u, (_e466 == 0u)));
                    let _e476 = local.group_mask;
                    let _e490 = local.group_mask;
                    local.group_mask = (_e490 & ~((1u << bitcast<u32>((_e472 & 31u)))));
                    let _e493 = local.group;
                    phi_701_ = (_e493 + countOneBits(((_e476 & ~((4294967295u << bitcast<u32>((((_e472 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_701_ = 4294967295u;
                }
                let _e496 = phi_701_;
                phi_703_ = _e496;
                phi_706_ = false;
                loop {
                    let _e498 = phi_703_;
                    let _e500 = phi_706_;
                    local_8 = _e500;
                    if (_e498 != 4294967295u) {
                        if (_e498 < _e62) {
                        } else {
                            return;
                        }
                        let _e507 = nodes.member[(0u + _e498)].frame[3u];
                        let _e532 = (bitcast<f32>((((_e507 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e258);
                        let _e533 = (bitcast<f32>((((_e507 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e268);
                        let _e534 = (bitcast<f32>((((_e507 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e278);
                        let _e537 = nodes.member[(0u + _e498)].frame[0u];
                        let _e541 = nodes.member[(0u + _e498)].frame[1u];
                        let _e545 = nodes.member[(0u + _e498)].frame[2u];
                        let _e550 = ((bitcast<f32>(_e537) - _e107) * _e258);
                        let _e551 = ((bitcast<f32>(_e541) - _e109) * _e268);
                        let _e552 = ((bitcast<f32>(_e545) - _e111) * _e278);
                        let _e560 = nodes.member[(0u + _e498)].x;
                        if (_e258 < 0f) {
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e571.unnamed.root, _e560.w), _e571.unnamed_1);
                            let _e583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e560.x, _e577.unnamed_1.first_primitive));
                            phi_786_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e583.unnamed, lt_bvh_traverse_Tree(_e583.unnamed_1.root, _e560.y));
                        } else {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e560.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e599.unnamed.root, _e560.y), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e560.z, _e605.unnamed_1.first_primitive));
                            phi_786_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_bvh_traverse_Tree(_e611.unnamed_1.root, _e560.w));
                        }
                        let _e619 = phi_786_;
                        let _e629 = nodes.member[(0u + _e498)].y;
                        if (_e268 < 0f) {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.unnamed.root, _e629.w), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e629.x, _e646.unnamed_1.first_primitive));
                            phi_813_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e652.unnamed_1.root, _e629.y));
                        } else {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e668.unnamed.root, _e629.y), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e629.z, _e674.unnamed_1.first_primitive));
                            phi_813_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_bvh_traverse_Tree(_e680.unnamed_1.root, _e629.w));
                        }
                        let _e688 = phi_813_;
                        let _e698 = nodes.member[(0u + _e498)].z;
                        if (_e278 < 0f) {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.unnamed.root, _e698.w), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e698.x, _e715.unnamed_1.first_primitive));
                            phi_840_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e721.unnamed_1.root, _e698.y));
                        } else {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e698.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e737.unnamed.root, _e698.y), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e698.z, _e743.unnamed_1.first_primitive));
                            phi_840_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_bvh_traverse_Tree(_e749.unnamed_1.root, _e698.w));
                        }
                        let _e757 = phi_840_;
                        phi_846_ = 0u;
                        phi_849_ = 0u;
                        loop {
                            let _e767 = phi_846_;
                            let _e769 = phi_849_;
                            local_1 = _e769;
                            local_2 = _e769;
                            local_3 = _e769;
                            let _e770 = (_e767 < 8u);
                            if _e770 {
                                let _e772 = (_e767 >> bitcast<u32>(2i));
                                let _e773 = (_e767 & 3u);
                                if (_e772 == 0u) {
                                    phi_863_ = _e619.unnamed.root;
                                } else {
                                    phi_863_ = _e619.unnamed.first_primitive;
                                }
                                let _e776 = phi_863_;
                                if (_e772 == 0u) {
                                    phi_873_ = _e688.unnamed.root;
                                } else {
                                    phi_873_ = _e688.unnamed.first_primitive;
                                }
                                let _e785 = phi_873_;
                                if (_e772 == 0u) {
                                    phi_883_ = _e757.unnamed.root;
                                } else {
                                    phi_883_ = _e757.unnamed.first_primitive;
                                }
                                let _e794 = phi_883_;
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e776 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e310)), ((f32(((_e785 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e311)));
                                let _e808 = core_intrinsics_maximum_number_nsz_f32_(_e807, ((f32(((_e794 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e312)));
                                if (_e772 == 0u) {
                                    phi_901_ = _e619.unnamed_1.root;
                                } else {
                                    phi_901_ = _e619.unnamed_1.first_primitive;
                                }
                                let _e811 = phi_901_;
                                if (_e772 == 0u) {
                                    phi_911_ = _e688.unnamed_1.root;
                                } else {
                                    phi_911_ = _e688.unnamed_1.first_primitive;
                                }
                                let _e820 = phi_911_;
                                if (_e772 == 0u) {
                                    phi_921_ = _e757.unnamed_1.root;
                                } else {
                                    phi_921_ = _e757.unnamed_1.first_primitive;
                                }
                                let _e829 = phi_921_;
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e811 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e310)), ((f32(((_e820 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e311)));
                                let _e843 = core_intrinsics_minimum_number_nsz_f32_(_e842, ((f32(((_e829 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e312)));
                                if (_e808 <= _e843) {
                                    if (_e808 <= _e117) {
                                        if (_e843 >= 0f) {
                                            if (_e772 == 0u) {
                                                let _e850 = nodes.member[(0u + _e498)].links[2u];
                                                phi_957_ = _e850;
                                            } else {
                                                let _e853 = nodes.member[(0u + _e498)].links[3u];
                                                phi_957_ = _e853;
                                            }
                                            let _e855 = phi_957_;
                                            let _e860 = ((_e855 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u);
                                            let _e861 = (_e860 & 31u);
                                            if (_e861 >= 24u) {
                                                phi_970_ = (24u + ((_e861 - 24u) ^ _e360));
                                            } else {
                                                phi_970_ = _e861;
                                            }
                                            let _e867 = phi_970_;
                                            phi_975_ = (_e769 | ((_e860 >> bitcast<u32>(5i)) << bitcast<u32>((_e867 & 31u))));
                                        } else {
                                            phi_975_ = _e769;
                                        }
                                        let _e875 = phi_975_;
                                        phi_976_ = _e875;
                                    } else {
                                        phi_976_ = _e769;
                                    }
                                    let _e877 = phi_976_;
                                    phi_977_ = _e877;
                                } else {
                                    phi_977_ = _e769;
                                }
                                let _e879 = phi_977_;
                                phi_847_ = (_e767 + 1u);
                                phi_850_ = _e879;
                            } else {
                                phi_847_ = u32();
                                phi_850_ = u32();
                            }
                            let _e882 = phi_847_;
                            let _e884 = phi_850_;
                            continue;
                            continuing {
                                phi_846_ = _e882;
                                phi_849_ = _e884;
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
                        phi_1035_ = (_e933 & 16777215u);
                        phi_1038_ = _e500;
                        loop {
                            let _e936 = phi_1035_;
                            let _e938 = phi_1038_;
                            local_6 = _e938;
                            let _e939 = (_e936 == 0u);
                            local_4 = _e939;
                            local_7 = _e939;
                            if _e939 {
                                phi_1036_ = u32();
                                phi_1039_ = bool();
                                phi_1636_ = false;
                            } else {
                                let _e942 = nodes.member[(0u + _e498)].links[1u];
                                let _e947 = ((0u + _e942) + select(firstTrailingBit(_e936), 32u, (_e936 == 0u)));
                                if (_e947 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e954 = triangles.member[(0u + _e947)].v0_;
                                let _e956 = (_e954.x - _e107);
                                let _e958 = (_e954.y - _e109);
                                let _e960 = (_e954.z - _e111);
                                if (_e333 == 0u) {
                                    phi_1083_ = vec3<f32>(_e958, _e960, _e956);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1082_ = vec3<f32>(_e960, _e956, _e958);
                                    } else {
                                        phi_1082_ = (_e954 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e968 = phi_1082_;
                                    phi_1083_ = _e968;
                                }
                                let _e970 = phi_1083_;
                                let _e974 = (_e970.x - (_e344 * _e970.z));
                                let _e978 = (_e970.y - (_e347 * _e970.z));
                                let _e980 = triangles.member[(0u + _e947)].v1_;
                                let _e982 = (_e980.x - _e107);
                                let _e984 = (_e980.y - _e109);
                                let _e986 = (_e980.z - _e111);
                                if (_e333 == 0u) {
                                    phi_1113_ = vec3<f32>(_e984, _e986, _e982);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1112_ = vec3<f32>(_e986, _e982, _e984);
                                    } else {
                                        phi_1112_ = (_e980 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e994 = phi_1112_;
                                    phi_1113_ = _e994;
                                }
                                let _e996 = phi_1113_;
                                let _e1000 = (_e996.x - (_e344 * _e996.z));
                                let _e1004 = (_e996.y - (_e347 * _e996.z));
                                let _e1006 = triangles.member[(0u + _e947)].v2_;
                                let _e1008 = (_e1006.x - _e107);
                                let _e1010 = (_e1006.y - _e109);
                                let _e1012 = (_e1006.z - _e111);
                                if (_e333 == 0u) {
                                    phi_1143_ = vec3<f32>(_e1010, _e1012, _e1008);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1142_ = vec3<f32>(_e1012, _e1008, _e1010);
                                    } else {
                                        phi_1142_ = (_e1006 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e1020 = phi_1142_;
                                    phi_1143_ = _e1020;
                                }
                                let _e1022 = phi_1143_;
                                let _e1026 = (_e1022.x - (_e344 * _e1022.z));
                                let _e1030 = (_e1022.y - (_e347 * _e1022.z));
                                if (_e1000 < _e1026) {
                                    phi_1162_ = true;
                                } else {
                                    if (_e1000 == _e1026) {
                                        phi_1161_ = (_e1004 < _e1030);
                                    } else {
                                        phi_1161_ = false;
                                    }
                                    let _e1035 = phi_1161_;
                                    phi_1162_ = _e1035;
                                }
                                let _e1037 = phi_1162_;
                                if _e1037 {
                                    phi_1166_ = _e1030;
                                    phi_1167_ = _e1026;
                                    phi_1168_ = _e1004;
                                    phi_1169_ = _e1000;
                                } else {
                                    phi_1166_ = _e1004;
                                    phi_1167_ = _e1000;
                                    phi_1168_ = _e1030;
                                    phi_1169_ = _e1026;
                                }
                                let _e1039 = phi_1166_;
                                let _e1041 = phi_1167_;
                                let _e1043 = phi_1168_;
                                let _e1045 = phi_1169_;
                                let _e1048 = ((_e1045 * _e1039) - (_e1043 * _e1041));
                                if _e1037 {
                                    phi_1177_ = -(_e1048);
                                } else {
                                    phi_1177_ = _e1048;
                                }
                                let _e1051 = phi_1177_;
                                if (_e1026 < _e974) {
                                    phi_1188_ = true;
                                } else {
                                    if (_e1026 == _e974) {
                                        phi_1187_ = (_e1030 < _e978);
                                    } else {
                                        phi_1187_ = false;
                                    }
                                    let _e1056 = phi_1187_;
                                    phi_1188_ = _e1056;
                                }
                                let _e1058 = phi_1188_;
                                if _e1058 {
                                    phi_1192_ = _e978;
                                    phi_1193_ = _e974;
                                    phi_1194_ = _e1030;
                                    phi_1195_ = _e1026;
                                } else {
                                    phi_1192_ = _e1030;
                                    phi_1193_ = _e1026;
                                    phi_1194_ = _e978;
                                    phi_1195_ = _e974;
                                }
                                let _e1060 = phi_1192_;
                                let _e1062 = phi_1193_;
                                let _e1064 = phi_1194_;
                                let _e1066 = phi_1195_;
                                let _e1069 = ((_e1066 * _e1060) - (_e1064 * _e1062));
                                if _e1058 {
                                    phi_1203_ = -(_e1069);
                                } else {
                                    phi_1203_ = _e1069;
                                }
                                let _e1072 = phi_1203_;
                                if (_e974 < _e1000) {
                                    phi_1214_ = true;
                                } else {
                                    if (_e974 == _e1000) {
                                        phi_1213_ = (_e978 < _e1004);
                                    } else {
                                        phi_1213_ = false;
                                    }
                                    let _e1077 = phi_1213_;
                                    phi_1214_ = _e1077;
                                }
                                let _e1079 = phi_1214_;
                                if _e1079 {
                                    phi_1218_ = _e1004;
                                    phi_1219_ = _e1000;
                                    phi_1220_ = _e978;
                                    phi_1221_ = _e974;
                                } else {
                                    phi_1218_ = _e978;
                                    phi_1219_ = _e974;
                                    phi_1220_ = _e1004;
                                    phi_1221_ = _e1000;
                                }
                                let _e1081 = phi_1218_;
                                let _e1083 = phi_1219_;
                                let _e1085 = phi_1220_;
                                let _e1087 = phi_1221_;
                                let _e1090 = ((_e1087 * _e1081) - (_e1085 * _e1083));
                                if _e1079 {
                                    phi_1229_ = -(_e1090);
                                } else {
                                    phi_1229_ = _e1090;
                                }
                                let _e1093 = phi_1229_;
                                if (_e1051 >= 0f) {
                                    if (_e1072 >= 0f) {
                                        if (_e1093 >= 0f) {
                                            phi_1244_ = ((_e1051 + _e1072) + _e1093);
                                            phi_1245_ = false;
                                        } else {
                                            phi_1244_ = f32();
                                            phi_1245_ = true;
                                        }
                                        let _e1100 = phi_1244_;
                                        let _e1102 = phi_1245_;
                                        phi_1246_ = _e1100;
                                        phi_1247_ = _e1102;
                                    } else {
                                        phi_1246_ = f32();
                                        phi_1247_ = true;
                                    }
                                    let _e1104 = phi_1246_;
                                    let _e1106 = phi_1247_;
                                    phi_1248_ = _e1104;
                                    phi_1249_ = _e1106;
                                } else {
                                    phi_1248_ = f32();
                                    phi_1249_ = true;
                                }
                                let _e1108 = phi_1248_;
                                let _e1110 = phi_1249_;
                                if _e1110 {
                                    if (_e1051 <= 0f) {
                                        if (_e1072 <= 0f) {
                                            let _e1113 = (_e1093 <= 0f);
                                            if _e1113 {
                                            }
                                            phi_1267_ = ((_e1051 + _e1072) + _e1093);
                                            phi_1268_ = false;
                                            phi_1269_ = _e1113;
                                        } else {
                                            phi_1267_ = f32();
                                            phi_1268_ = true;
                                            phi_1269_ = false;
                                        }
                                        let _e1117 = phi_1267_;
                                        let _e1119 = phi_1268_;
                                        let _e1121 = phi_1269_;
                                        phi_1270_ = _e1117;
                                        phi_1271_ = _e1119;
                                        phi_1272_ = _e1121;
                                    } else {
                                        phi_1270_ = f32();
                                        phi_1271_ = true;
                                        phi_1272_ = false;
                                    }
                                    let _e1123 = phi_1270_;
                                    let _e1125 = phi_1271_;
                                    let _e1127 = phi_1272_;
                                    if _e1125 {
                                        phi_1276_ = false;
                                    } else {
                                        phi_1276_ = _e1127;
                                    }
                                    let _e1129 = phi_1276_;
                                    phi_1277_ = _e1123;
                                    phi_1278_ = _e1129;
                                } else {
                                    phi_1277_ = _e1108;
                                    phi_1278_ = true;
                                }
                                let _e1131 = phi_1277_;
                                let _e1133 = phi_1278_;
                                if _e1133 {
                                    let _e1134 = (_e1131 == 0f);
                                    if _e1134 {
                                        phi_1594_ = lt_bvh_triangle_Intersection();
                                        phi_1595_ = false;
                                    } else {
                                        let _e1136 = triangles.member[(0u + _e947)].v0_;
                                        let _e1138 = (_e1136.x - _e107);
                                        let _e1140 = (_e1136.y - _e109);
                                        let _e1142 = (_e1136.z - _e111);
                                        if (_e333 == 0u) {
                                            phi_1307_ = vec3<f32>(_e1140, _e1142, _e1138);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1306_ = vec3<f32>(_e1142, _e1138, _e1140);
                                            } else {
                                                phi_1306_ = (_e1136 - vec3<f32>(_e107, _e109, _e111));
                                            }
                                            let _e1150 = phi_1306_;
                                            phi_1307_ = _e1150;
                                        }
                                        let _e1152 = phi_1307_;
                                        let _e1154 = triangles.member[(0u + _e947)].v1_;
                                        let _e1156 = triangles.member[(0u + _e947)].v0_;
                                        let _e1159 = (_e1154.x - _e1156.x);
                                        let _e1162 = (_e1154.y - _e1156.y);
                                        let _e1165 = (_e1154.z - _e1156.z);
                                        if (_e333 == 0u) {
                                            phi_1333_ = vec3<f32>(_e1162, _e1165, _e1159);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1332_ = vec3<f32>(_e1165, _e1159, _e1162);
                                            } else {
                                                phi_1332_ = (_e1154 - _e1156);
                                            }
                                            let _e1172 = phi_1332_;
                                            phi_1333_ = _e1172;
                                        }
                                        let _e1174 = phi_1333_;
                                        let _e1176 = triangles.member[(0u + _e947)].v2_;
                                        let _e1178 = triangles.member[(0u + _e947)].v0_;
                                        let _e1181 = (_e1176.x - _e1178.x);
                                        let _e1184 = (_e1176.y - _e1178.y);
                                        let _e1187 = (_e1176.z - _e1178.z);
                                        if (_e333 == 0u) {
                                            phi_1359_ = vec3<f32>(_e1184, _e1187, _e1181);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1358_ = vec3<f32>(_e1187, _e1181, _e1184);
                                            } else {
                                                phi_1358_ = (_e1176 - _e1178);
                                            }
                                            let _e1194 = phi_1358_;
                                            phi_1359_ = _e1194;
                                        }
                                        let _e1196 = phi_1359_;
                                        let _e1203 = ((_e1174.y * _e1196.z) - (_e1174.z * _e1196.y));
                                        let _e1210 = ((_e1174.z * _e1196.x) - (_e1174.x * _e1196.z));
                                        let _e1217 = ((_e1174.x * _e1196.y) - (_e1174.y * _e1196.x));
                                        let _e1231 = (((1f / _e341.z) * (((_e1203 * _e1152.x) + (_e1210 * _e1152.y)) + (_e1217 * _e1152.z))) / (((_e1203 * _e344) + (_e1210 * _e347)) + _e1217));
                                        if (_e1231 > 0f) {
                                            if (_e1231 < _e117) {
                                                let _e1235 = triangles.member[(0u + _e947)].v0_;
                                                let _e1237 = triangles.member[(0u + _e947)].v1_;
                                                if (_e1235.x < _e1237.x) {
                                                    phi_1415_ = _e1235.x;
                                                } else {
                                                    phi_1415_ = _e1237.x;
                                                }
                                                let _e1244 = phi_1415_;
                                                if (_e1235.y < _e1237.y) {
                                                    phi_1424_ = _e1235.y;
                                                } else {
                                                    phi_1424_ = _e1237.y;
                                                }
                                                let _e1251 = phi_1424_;
                                                if (_e1235.z < _e1237.z) {
                                                    phi_1433_ = _e1235.z;
                                                } else {
                                                    phi_1433_ = _e1237.z;
                                                }
                                                let _e1258 = phi_1433_;
                                                let _e1260 = triangles.member[(0u + _e947)].v2_;
                                                if (_e1244 < _e1260.x) {
                                                    phi_1442_ = _e1244;
                                                } else {
                                                    phi_1442_ = _e1260.x;
                                                }
                                                let _e1265 = phi_1442_;
                                                if (_e1251 < _e1260.y) {
                                                    phi_1449_ = _e1251;
                                                } else {
                                                    phi_1449_ = _e1260.y;
                                                }
                                                let _e1270 = phi_1449_;
                                                if (_e1258 < _e1260.z) {
                                                    phi_1456_ = _e1258;
                                                } else {
                                                    phi_1456_ = _e1260.z;
                                                }
                                                let _e1275 = phi_1456_;
                                                let _e1277 = triangles.member[(0u + _e947)].v0_;
                                                let _e1279 = triangles.member[(0u + _e947)].v1_;
                                                if (_e1277.x > _e1279.x) {
                                                    phi_1469_ = _e1277.x;
                                                } else {
                                                    phi_1469_ = _e1279.x;
                                                }
                                                let _e1286 = phi_1469_;
                                                if (_e1277.y > _e1279.y) {
                                                    phi_1478_ = _e1277.y;
                                                } else {
                                                    phi_1478_ = _e1279.y;
                                                }
                                                let _e1293 = phi_1478_;
                                                if (_e1277.z > _e1279.z) {
                                                    phi_1487_ = _e1277.z;
                                                } else {
                                                    phi_1487_ = _e1279.z;
                                                }
                                                let _e1300 = phi_1487_;
                                                let _e1302 = triangles.member[(0u + _e947)].v2_;
                                                if (_e1286 > _e1302.x) {
                                                    phi_1496_ = _e1286;
                                                } else {
                                                    phi_1496_ = _e1302.x;
                                                }
                                                let _e1307 = phi_1496_;
                                                if (_e1293 > _e1302.y) {
                                                    phi_1503_ = _e1293;
                                                } else {
                                                    phi_1503_ = _e1302.y;
                                                }
                                                let _e1312 = phi_1503_;
                                                if (_e1300 > _e1302.z) {
                                                    phi_1510_ = _e1300;
                                                } else {
                                                    phi_1510_ = _e1302.z;
                                                }
                                                let _e1317 = phi_1510_;
                                                let _e1321 = ((_e1265 - _e107) * _e258);
                                                let _e1322 = ((_e1270 - _e109) * _e268);
                                                let _e1323 = ((_e1275 - _e111) * _e278);
                                                let _e1327 = ((_e1307 - _e107) * _e258);
                                                let _e1328 = ((_e1312 - _e109) * _e268);
                                                let _e1329 = ((_e1317 - _e111) * _e278);
                                                if (_e1321 < _e1327) {
                                                    phi_1527_ = _e1321;
                                                } else {
                                                    phi_1527_ = _e1327;
                                                }
                                                let _e1332 = phi_1527_;
                                                if (_e1322 < _e1328) {
                                                    phi_1532_ = _e1322;
                                                } else {
                                                    phi_1532_ = _e1328;
                                                }
                                                let _e1335 = phi_1532_;
                                                if (_e1323 < _e1329) {
                                                    phi_1537_ = _e1323;
                                                } else {
                                                    phi_1537_ = _e1329;
                                                }
                                                let _e1338 = phi_1537_;
                                                if (_e1321 > _e1327) {
                                                    phi_1545_ = _e1321;
                                                } else {
                                                    phi_1545_ = _e1327;
                                                }
                                                let _e1344 = phi_1545_;
                                                if (_e1322 > _e1328) {
                                                    phi_1550_ = _e1322;
                                                } else {
                                                    phi_1550_ = _e1328;
                                                }
                                                let _e1347 = phi_1550_;
                                                if (_e1323 > _e1329) {
                                                    phi_1555_ = _e1323;
                                                } else {
                                                    phi_1555_ = _e1329;
                                                }
                                                let _e1350 = phi_1555_;
                                                let _e1354 = core_intrinsics_maximum_number_nsz_f32_((_e1332 - _e317), (_e1335 - _e318));
                                                let _e1355 = core_intrinsics_maximum_number_nsz_f32_(_e1354, (_e1338 - _e319));
                                                let _e1356 = core_intrinsics_minimum_number_nsz_f32_((_e1344 + _e317), (_e1347 + _e318));
                                                let _e1357 = core_intrinsics_minimum_number_nsz_f32_(_e1356, (_e1350 + _e319));
                                                if (_e1355 > -300000000000000000000000000000000000000f) {
                                                    phi_1567_ = _e1355;
                                                } else {
                                                    phi_1567_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1360 = phi_1567_;
                                                if (_e1357 < 300000000000000000000000000000000000000f) {
                                                    phi_1572_ = _e1357;
                                                } else {
                                                    phi_1572_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1363 = phi_1572_;
                                                if (_e1231 < _e1360) {
                                                    phi_1577_ = _e1360;
                                                } else {
                                                    phi_1577_ = _e1231;
                                                }
                                                let _e1366 = phi_1577_;
                                                if (_e1366 > _e1363) {
                                                    phi_1582_ = _e1363;
                                                } else {
                                                    phi_1582_ = _e1366;
                                                }
                                                let _e1369 = phi_1582_;
                                                phi_1587_ = lt_bvh_triangle_Intersection(_e1369, (_e1072 / _e1131), (_e1093 / _e1131), (_e1360 <= _e1363));
                                                phi_1588_ = false;
                                            } else {
                                                phi_1587_ = lt_bvh_triangle_Intersection();
                                                phi_1588_ = true;
                                            }
                                            let _e1375 = phi_1587_;
                                            let _e1377 = phi_1588_;
                                            phi_1589_ = _e1375;
                                            phi_1590_ = _e1377;
                                        } else {
                                            phi_1589_ = lt_bvh_triangle_Intersection();
                                            phi_1590_ = true;
                                        }
                                        let _e1379 = phi_1589_;
                                        let _e1381 = phi_1590_;
                                        if _e1381 {
                                        }
                                        phi_1594_ = _e1379;
                                        phi_1595_ = _e1381;
                                    }
                                    let _e1383 = phi_1594_;
                                    let _e1385 = phi_1595_;
                                    phi_1596_ = _e1383;
                                    phi_1597_ = _e1134;
                                    phi_1598_ = _e1385;
                                } else {
                                    phi_1596_ = lt_bvh_triangle_Intersection();
                                    phi_1597_ = true;
                                    phi_1598_ = false;
                                }
                                let _e1387 = phi_1596_;
                                let _e1389 = phi_1597_;
                                let _e1391 = phi_1598_;
                                if _e1389 {
                                    phi_1602_ = true;
                                } else {
                                    phi_1602_ = _e1391;
                                }
                                let _e1393 = phi_1602_;
                                if _e1393 {
                                    phi_1606_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1606_ = _e1387;
                                }
                                let _e1395 = phi_1606_;
                                if _e1395.is_hit {
                                    if (_e1395.t > 0f) {
                                        if (_e1395.t < _e117) {
                                            if true {
                                                phi_1626_ = false;
                                            } else {
                                                phi_1626_ = true;
                                            }
                                            let _e1404 = phi_1626_;
                                            phi_1627_ = true;
                                            phi_1628_ = _e1404;
                                        } else {
                                            phi_1627_ = _e938;
                                            phi_1628_ = true;
                                        }
                                        let _e1406 = phi_1627_;
                                        let _e1408 = phi_1628_;
                                        phi_1629_ = _e1406;
                                        phi_1630_ = _e1408;
                                    } else {
                                        phi_1629_ = _e938;
                                        phi_1630_ = true;
                                    }
                                    let _e1410 = phi_1629_;
                                    let _e1412 = phi_1630_;
                                    phi_1631_ = _e1410;
                                    phi_1632_ = _e1412;
                                } else {
                                    phi_1631_ = _e938;
                                    phi_1632_ = true;
                                }
                                let _e1414 = phi_1631_;
                                let _e1416 = phi_1632_;
                                if _e1416 {
                                }
                                phi_1036_ = (_e936 & (_e936 - 1u));
                                phi_1039_ = _e1414;
                                phi_1636_ = _e1416;
                            }
                            let _e1418 = phi_1036_;
                            let _e1420 = phi_1039_;
                            let _e1422 = phi_1636_;
                            continue;
                            continuing {
                                phi_1035_ = _e1418;
                                phi_1038_ = _e1420;
                                break if !(_e1422);
                            }
                        }
                        let _e1425 = local_4;
                        if _e1425 {
                            let _e1427 = local.group_mask;
                            if ((_e1427 & 4278190080u) == 0u) {
                                let _e1431 = local.len;
                                if (_e1431 == 0u) {
                                    phi_1678_ = false;
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
                                    phi_1678_ = true;
                                }
                                let _e1454 = phi_1678_;
                                phi_1679_ = _e1454;
                            } else {
                                phi_1679_ = true;
                            }
                            let _e1456 = phi_1679_;
                            if _e1456 {
                                let _e1458 = local.group_mask;
                                let _e1464 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1458)), 32u, (_e1458 == 0u)));
                                let _e1468 = local.group_mask;
                                let _e1482 = local.group_mask;
                                local.group_mask = (_e1482 & ~((1u << bitcast<u32>((_e1464 & 31u)))));
                                let _e1485 = local.group;
                                phi_1710_ = (_e1485 + countOneBits(((_e1468 & ~((4294967295u << bitcast<u32>((((_e1464 - 24u) ^ _e360) & 31u))))) & 255u)));
                            } else {
                                phi_1710_ = 4294967295u;
                            }
                            let _e1488 = phi_1710_;
                            phi_1711_ = _e1488;
                        } else {
                            phi_1711_ = u32();
                        }
                        let _e1490 = phi_1711_;
                        phi_704_ = _e1490;
                        let _e1776 = local_6;
                        phi_707_ = _e1776;
                        let _e1779 = local_7;
                        phi_1712_ = _e1779;
                        phi_1713_ = false;
                    } else {
                        phi_704_ = u32();
                        phi_707_ = bool();
                        phi_1712_ = false;
                        phi_1713_ = true;
                    }
                    let _e1492 = phi_704_;
                    let _e1494 = phi_707_;
                    let _e1496 = phi_1712_;
                    let _e1498 = phi_1713_;
                    local_5 = _e1498;
                    continue;
                    continuing {
                        phi_703_ = _e1492;
                        phi_706_ = _e1494;
                        break if !(_e1496);
                    }
                }
                let _e1501 = local_5;
                if _e1501 {
                    phi_1717_ = false;
                } else {
                    phi_1717_ = true;
                }
                let _e1503 = phi_1717_;
                if _e1503 {
                    phi_1721_ = true;
                } else {
                    let _e1785 = local_8;
                    phi_1721_ = _e1785;
                }
                let _e1505 = phi_1721_;
                phi_1722_ = _e1505;
            }
            let _e1507 = phi_1722_;
            phi_1723_ = _e1507;
            phi_1724_ = _e182;
        } else {
            phi_1723_ = bool();
            phi_1724_ = true;
        }
        let _e1509 = phi_1723_;
        let _e1511 = phi_1724_;
        if _e1511 {
            phi_1728_ = false;
        } else {
            phi_1728_ = _e1509;
        }
        let _e1513 = phi_1728_;
        if _e1513 {
            phi_1732_ = 0f;
        } else {
            phi_1732_ = 1f;
        }
        let _e1515 = phi_1732_;
        if (_e87 < _e68) {
        } else {
            return;
        }
        visibility.member[(0u + _e87)] = _e1515;
        let _e1521 = p.member.light.number;
        let _e1522 = (_e1521 * 3u);
        let _e1523 = (_e1522 / 32u);
        let _e1524 = (_e1522 % 32u);
        let _e1526 = p.member.light.mask_words;
        if (_e87 < _e68) {
        } else {
            return;
        }
        let _e1530 = visibility.member[(0u + _e87)];
        let _e1532 = ((_e87 * _e1526) + _e1523);
        if (_e1524 > 29u) {
            let _e1534 = (_e1532 + 1u);
            if (_e1534 < _e74) {
            } else {
                return;
            }
            let _e1538 = bits.member[(0u + _e1534)];
            phi_1773_ = _e1538;
        } else {
            phi_1773_ = 0u;
        }
        let _e1540 = phi_1773_;
        if (_e1532 < _e74) {
        } else {
            return;
        }
        let _e1544 = bits.member[(0u + _e1532)];
        let _e1547 = (_e1544 >> bitcast<u32>((_e1524 & 31u)));
        if (_e1524 > 29u) {
            phi_1792_ = (_e1547 | (_e1540 << bitcast<u32>(((32u - _e1524) & 31u))));
        } else {
            phi_1792_ = _e1547;
        }
        let _e1555 = phi_1792_;
        if ((_e1555 & 2u) == 0u) {
            phi_1800_ = (_e1555 & 1u);
        } else {
            phi_1800_ = (_e1555 & 7u);
        }
        let _e1561 = phi_1800_;
        if ((_e1561 & 1u) != 0u) {
            phi_1808_ = (2u | 1u);
        } else {
            phi_1808_ = 2u;
        }
        let _e1567 = phi_1808_;
        if (_e1530 < 0.5f) {
            phi_1813_ = (_e1567 | 4u);
        } else {
            phi_1813_ = _e1567;
        }
        let _e1570 = phi_1813_;
        let _e1572 = ((_e87 * _e1526) + _e1523);
        if (_e1572 < _e74) {
        } else {
            return;
        }
        let _e1576 = bits.member[(0u + _e1572)];
        if (_e1572 < _e74) {
        } else {
            return;
        }
        bits.member[(0u + _e1572)] = ((_e1576 & ~((7u << bitcast<u32>((_e1524 & 31u))))) | (_e1570 << bitcast<u32>((_e1524 & 31u))));
        if (_e1524 > 29u) {
            let _e1590 = (_e1572 + 1u);
            if (_e1590 < _e74) {
            } else {
                return;
            }
            let _e1594 = bits.member[(0u + _e1590)];
            let _e1595 = (32u - _e1524);
            let _e1605 = (_e1572 + 1u);
            if (_e1605 < _e74) {
            } else {
                return;
            }
            bits.member[(0u + _e1605)] = ((_e1594 & ~((7u >> bitcast<u32>((_e1595 & 31u))))) | (_e1570 >> bitcast<u32>((_e1595 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
