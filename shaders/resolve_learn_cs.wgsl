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
    var phi_286_: bool;
    var phi_287_: bool;
    var phi_288_: bool;
    var phi_289_: bool;
    var phi_293_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_313_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_340_: bool;
    var phi_410_: f32;
    var phi_417_: f32;
    var phi_424_: f32;
    var phi_431_: f32;
    var phi_438_: f32;
    var phi_445_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_472_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_508_: bool;
    var phi_509_: bool;
    var phi_517_: u32;
    var phi_518_: u32;
    var phi_529_: vec3<f32>;
    var phi_530_: vec3<f32>;
    var phi_543_: u32;
    var phi_548_: u32;
    var phi_553_: u32;
    var phi_667_: bool;
    var phi_668_: bool;
    var phi_699_: u32;
    var phi_701_: u32;
    var phi_704_: bool;
    var phi_784_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_811_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_838_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_844_: u32;
    var phi_847_: u32;
    var phi_861_: u32;
    var phi_871_: u32;
    var phi_881_: u32;
    var phi_899_: u32;
    var phi_909_: u32;
    var phi_919_: u32;
    var phi_955_: u32;
    var phi_968_: u32;
    var phi_973_: u32;
    var phi_974_: u32;
    var phi_975_: u32;
    var phi_845_: u32;
    var phi_848_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1033_: u32;
    var phi_1036_: bool;
    var phi_1080_: vec3<f32>;
    var phi_1081_: vec3<f32>;
    var phi_1110_: vec3<f32>;
    var phi_1111_: vec3<f32>;
    var phi_1140_: vec3<f32>;
    var phi_1141_: vec3<f32>;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1164_: f32;
    var phi_1165_: f32;
    var phi_1166_: f32;
    var phi_1167_: f32;
    var phi_1175_: f32;
    var phi_1185_: bool;
    var phi_1186_: bool;
    var phi_1190_: f32;
    var phi_1191_: f32;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1201_: f32;
    var phi_1211_: bool;
    var phi_1212_: bool;
    var phi_1216_: f32;
    var phi_1217_: f32;
    var phi_1218_: f32;
    var phi_1219_: f32;
    var phi_1227_: f32;
    var phi_1242_: f32;
    var phi_1243_: bool;
    var phi_1244_: f32;
    var phi_1245_: bool;
    var phi_1246_: f32;
    var phi_1247_: bool;
    var phi_1265_: f32;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1268_: f32;
    var phi_1269_: bool;
    var phi_1270_: bool;
    var phi_1274_: bool;
    var phi_1275_: f32;
    var phi_1276_: bool;
    var phi_1304_: vec3<f32>;
    var phi_1305_: vec3<f32>;
    var phi_1330_: vec3<f32>;
    var phi_1331_: vec3<f32>;
    var phi_1356_: vec3<f32>;
    var phi_1357_: vec3<f32>;
    var phi_1413_: f32;
    var phi_1422_: f32;
    var phi_1431_: f32;
    var phi_1440_: f32;
    var phi_1447_: f32;
    var phi_1454_: f32;
    var phi_1467_: f32;
    var phi_1476_: f32;
    var phi_1485_: f32;
    var phi_1494_: f32;
    var phi_1501_: f32;
    var phi_1508_: f32;
    var phi_1525_: f32;
    var phi_1530_: f32;
    var phi_1535_: f32;
    var phi_1543_: f32;
    var phi_1548_: f32;
    var phi_1553_: f32;
    var phi_1565_: f32;
    var phi_1570_: f32;
    var phi_1575_: f32;
    var phi_1580_: f32;
    var phi_1585_: lt_bvh_triangle_Intersection;
    var phi_1586_: bool;
    var phi_1587_: lt_bvh_triangle_Intersection;
    var phi_1588_: bool;
    var phi_1592_: lt_bvh_triangle_Intersection;
    var phi_1593_: bool;
    var phi_1594_: lt_bvh_triangle_Intersection;
    var phi_1595_: bool;
    var phi_1596_: bool;
    var phi_1600_: bool;
    var phi_1604_: lt_bvh_triangle_Intersection;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1034_: u32;
    var phi_1037_: bool;
    var phi_1634_: bool;
    var local_4: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1708_: u32;
    var phi_1709_: u32;
    var phi_702_: u32;
    var phi_705_: bool;
    var phi_1710_: bool;
    var phi_1711_: bool;
    var local_5: bool;
    var phi_1715_: bool;
    var phi_1719_: bool;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1722_: bool;
    var phi_1726_: bool;
    var phi_1730_: f32;
    var phi_1771_: u32;
    var phi_1790_: u32;
    var phi_1798_: u32;
    var phi_1806_: u32;
    var phi_1811_: u32;
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
        let _e129 = abs(_e125);
        let _e130 = abs(_e126);
        let _e131 = abs(_e127);
        if (abs(_e107) < 1000000000000000f) {
            if (abs(_e109) < 1000000000000000f) {
                phi_286_ = (abs(_e111) < 1000000000000000f);
                phi_287_ = false;
            } else {
                phi_286_ = bool();
                phi_287_ = true;
            }
            let _e139 = phi_286_;
            let _e141 = phi_287_;
            phi_288_ = _e139;
            phi_289_ = _e141;
        } else {
            phi_288_ = bool();
            phi_289_ = true;
        }
        let _e143 = phi_288_;
        let _e145 = phi_289_;
        if _e145 {
            phi_293_ = false;
        } else {
            phi_293_ = _e143;
        }
        let _e147 = phi_293_;
        if _e147 {
            if (_e129 < 1000000000000000f) {
                if (_e130 < 1000000000000000f) {
                    phi_306_ = (_e131 < 1000000000000000f);
                    phi_307_ = false;
                } else {
                    phi_306_ = bool();
                    phi_307_ = true;
                }
                let _e152 = phi_306_;
                let _e154 = phi_307_;
                phi_308_ = _e152;
                phi_309_ = _e154;
            } else {
                phi_308_ = bool();
                phi_309_ = true;
            }
            let _e156 = phi_308_;
            let _e158 = phi_309_;
            if _e158 {
                phi_313_ = false;
            } else {
                phi_313_ = _e156;
            }
            let _e160 = phi_313_;
            if _e160 {
                if (_e129 > 0f) {
                    phi_327_ = bool();
                    phi_328_ = true;
                } else {
                    let _e162 = (_e130 > 0f);
                    if _e162 {
                        phi_326_ = bool();
                    } else {
                        phi_326_ = (_e131 > 0f);
                    }
                    let _e165 = phi_326_;
                    phi_327_ = _e165;
                    phi_328_ = _e162;
                }
                let _e167 = phi_327_;
                let _e169 = phi_328_;
                if _e169 {
                    phi_332_ = true;
                } else {
                    phi_332_ = _e167;
                }
                let _e171 = phi_332_;
                phi_333_ = _e171;
                phi_334_ = false;
            } else {
                phi_333_ = bool();
                phi_334_ = true;
            }
            let _e173 = phi_333_;
            let _e175 = phi_334_;
            phi_335_ = _e173;
            phi_336_ = _e175;
        } else {
            phi_335_ = bool();
            phi_336_ = true;
        }
        let _e177 = phi_335_;
        let _e179 = phi_336_;
        if _e179 {
            phi_340_ = false;
        } else {
            phi_340_ = _e177;
        }
        let _e181 = phi_340_;
        if _e181 {
            let _e182 = (0u >= _e62);
            if _e182 {
                phi_1720_ = bool();
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
                    phi_410_ = _e248;
                } else {
                    phi_410_ = abs(_e125);
                }
                let _e253 = phi_410_;
                if (_e125 < 0f) {
                    phi_417_ = (-1f / _e253);
                } else {
                    phi_417_ = (1f / _e253);
                }
                let _e258 = phi_417_;
                if (abs(_e126) < _e248) {
                    phi_424_ = _e248;
                } else {
                    phi_424_ = abs(_e126);
                }
                let _e263 = phi_424_;
                if (_e126 < 0f) {
                    phi_431_ = (-1f / _e263);
                } else {
                    phi_431_ = (1f / _e263);
                }
                let _e268 = phi_431_;
                if (abs(_e127) < _e248) {
                    phi_438_ = _e248;
                } else {
                    phi_438_ = abs(_e127);
                }
                let _e273 = phi_438_;
                if (_e127 < 0f) {
                    phi_445_ = (-1f / _e273);
                } else {
                    phi_445_ = (1f / _e273);
                }
                let _e278 = phi_445_;
                let _e282 = abs((bitcast<f32>(_e188) - _e107));
                let _e283 = abs((bitcast<f32>(_e192) - _e109));
                let _e284 = abs((bitcast<f32>(_e196) - _e111));
                let _e288 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e212 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e289 = abs(((bitcast<f32>(_e204) + (bitcast<f32>((((_e212 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                let _e290 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e212 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e111));
                if (_e282 > _e288) {
                    phi_462_ = _e282;
                } else {
                    phi_462_ = _e288;
                }
                let _e293 = phi_462_;
                if (_e283 > _e289) {
                    phi_467_ = _e283;
                } else {
                    phi_467_ = _e289;
                }
                let _e296 = phi_467_;
                if (_e284 > _e290) {
                    phi_472_ = _e284;
                } else {
                    phi_472_ = _e290;
                }
                let _e299 = phi_472_;
                if (_e293 > _e296) {
                    phi_477_ = _e293;
                } else {
                    phi_477_ = _e296;
                }
                let _e302 = phi_477_;
                if (_e302 > _e299) {
                    phi_482_ = _e302;
                } else {
                    phi_482_ = _e299;
                }
                let _e305 = phi_482_;
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
                        phi_508_ = false;
                    } else {
                        phi_508_ = true;
                    }
                    let _e326 = phi_508_;
                    phi_509_ = _e326;
                } else {
                    phi_509_ = true;
                }
                let _e328 = phi_509_;
                if _e328 {
                    if (_e321 >= _e322) {
                        phi_517_ = 1u;
                    } else {
                        phi_517_ = 2u;
                    }
                    let _e331 = phi_517_;
                    phi_518_ = _e331;
                } else {
                    phi_518_ = 0u;
                }
                let _e333 = phi_518_;
                if (_e333 == 0u) {
                    phi_530_ = vec3<f32>(_e126, _e127, _e125);
                } else {
                    if (_e333 == 1u) {
                        phi_529_ = vec3<f32>(_e127, _e125, _e126);
                    } else {
                        phi_529_ = vec3<f32>(_e125, _e126, _e127);
                    }
                    let _e339 = phi_529_;
                    phi_530_ = _e339;
                }
                let _e341 = phi_530_;
                let _e344 = (_e341.x / _e341.z);
                let _e347 = (_e341.y / _e341.z);
                if (_e258 < 0f) {
                    phi_543_ = 0u;
                } else {
                    phi_543_ = 1u;
                }
                let _e352 = phi_543_;
                if (_e268 < 0f) {
                    phi_548_ = 0u;
                } else {
                    phi_548_ = 2u;
                }
                let _e355 = phi_548_;
                if (_e278 < 0f) {
                    phi_553_ = 0u;
                } else {
                    phi_553_ = 4u;
                }
                let _e358 = phi_553_;
                let _e360 = ((_e352 | _e355) | _e358);
                let _e361 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e361.first[0], _e361.first[1], _e361.first[2], _e361.first[3], _e361.first[4], _e361.first[5], _e361.first[6], _e361.first[7], _e361.first[8], _e361.first[9], _e361.first[10], _e361.first[11], _e361.first[12], _e361.first[13], _e361.first[14], _e361.first[15], _e361.first[16], _e361.first[17], _e361.first[18], _e361.first[19], _e361.first[20], _e361.first[21], _e361.first[22], _e361.first[23], _e361.first[24], _e361.first[25], _e361.first[26], _e361.first[27], _e361.first[28], _e361.first[29], _e361.first[30], _e361.first[31]), array<u32, 32>(_e361.mask[0], _e361.mask[1], _e361.mask[2], _e361.mask[3], _e361.mask[4], _e361.mask[5], _e361.mask[6], _e361.mask[7], _e361.mask[8], _e361.mask[9], _e361.mask[10], _e361.mask[11], _e361.mask[12], _e361.mask[13], _e361.mask[14], _e361.mask[15], _e361.mask[16], _e361.mask[17], _e361.mask[18], _e361.mask[19], _e361.mask[20], _e361.mask[21], _e361.mask[22], _e361.mask[23], _e361.mask[24], _e361.mask[25], _e361.mask[26], _e361.mask[27], _e361.mask[28], _e361.mask[29], _e361.mask[30], _e361.mask[31]), _e361.len, _e361.group, _e361.group_mask);
                let _e435 = local.group_mask;
                if ((_e435 & 4278190080u) == 0u) {
                    let _e439 = local.len;
                    if (_e439 == 0u) {
                        phi_667_ = false;
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
                        phi_667_ = true;
                    }
                    let _e462 = phi_667_;
                    phi_668_ = _e462;
                } else {
                    phi_668_ = true;
                }
                let _e464 = phi_668_;
                if _e464 {
                    let _e466 = local.group_mask;
                    let _e472 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e466)), 32u, (_e466 == 0u)));
                    let _e476 = local.group_mask;
                    let _e490 = local.group_mask;
                    local.group_mask = (_e490 & ~((1u << bitcast<u32>((_e472 & 31u)))));
                    let _e493 = local.group;
                    phi_699_ = (_e493 + countOneBits(((_e476 & ~((4294967295u << bitcast<u32>((((_e472 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_699_ = 4294967295u;
                }
                let _e496 = phi_699_;
                phi_701_ = _e496;
                phi_704_ = false;
                loop {
                    let _e498 = phi_701_;
                    let _e500 = phi_704_;
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
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e560.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e571.unnamed.word, _e560.w), _e571.unnamed_1);
                            let _e583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_mask_LightPlace(_e560.x, _e577.unnamed_1.shift));
                            phi_784_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e583.unnamed, lt_mask_LightPlace(_e583.unnamed_1.word, _e560.y));
                        } else {
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e560.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e599.unnamed.word, _e560.y), _e599.unnamed_1);
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_mask_LightPlace(_e560.z, _e605.unnamed_1.shift));
                            phi_784_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e611.unnamed, lt_mask_LightPlace(_e611.unnamed_1.word, _e560.w));
                        }
                        let _e619 = phi_784_;
                        let _e629 = nodes.member[(0u + _e498)].y;
                        if (_e268 < 0f) {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e629.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e640.unnamed.word, _e629.w), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_mask_LightPlace(_e629.x, _e646.unnamed_1.shift));
                            phi_811_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_mask_LightPlace(_e652.unnamed_1.word, _e629.y));
                        } else {
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e629.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e668.unnamed.word, _e629.y), _e668.unnamed_1);
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e629.z, _e674.unnamed_1.shift));
                            phi_811_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e680.unnamed, lt_mask_LightPlace(_e680.unnamed_1.word, _e629.w));
                        }
                        let _e688 = phi_811_;
                        let _e698 = nodes.member[(0u + _e498)].z;
                        if (_e278 < 0f) {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e698.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e709.unnamed.word, _e698.w), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_mask_LightPlace(_e698.x, _e715.unnamed_1.shift));
                            phi_838_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_mask_LightPlace(_e721.unnamed_1.word, _e698.y));
                        } else {
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e698.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e737.unnamed.word, _e698.y), _e737.unnamed_1);
                            let _e749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e698.z, _e743.unnamed_1.shift));
                            phi_838_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e749.unnamed, lt_mask_LightPlace(_e749.unnamed_1.word, _e698.w));
                        }
                        let _e757 = phi_838_;
                        phi_844_ = 0u;
                        phi_847_ = 0u;
                        loop {
                            let _e767 = phi_844_;
                            let _e769 = phi_847_;
                            local_1 = _e769;
                            local_2 = _e769;
                            local_3 = _e769;
                            let _e770 = (_e767 < 8u);
                            if _e770 {
                                let _e772 = (_e767 >> bitcast<u32>(2i));
                                let _e773 = (_e767 & 3u);
                                if (_e772 == 0u) {
                                    phi_861_ = _e619.unnamed.word;
                                } else {
                                    phi_861_ = _e619.unnamed.shift;
                                }
                                let _e776 = phi_861_;
                                if (_e772 == 0u) {
                                    phi_871_ = _e688.unnamed.word;
                                } else {
                                    phi_871_ = _e688.unnamed.shift;
                                }
                                let _e785 = phi_871_;
                                if (_e772 == 0u) {
                                    phi_881_ = _e757.unnamed.word;
                                } else {
                                    phi_881_ = _e757.unnamed.shift;
                                }
                                let _e794 = phi_881_;
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e776 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e310)), ((f32(((_e785 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e311)));
                                let _e808 = core_intrinsics_maximum_number_nsz_f32_(_e807, ((f32(((_e794 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e312)));
                                if (_e772 == 0u) {
                                    phi_899_ = _e619.unnamed_1.word;
                                } else {
                                    phi_899_ = _e619.unnamed_1.shift;
                                }
                                let _e811 = phi_899_;
                                if (_e772 == 0u) {
                                    phi_909_ = _e688.unnamed_1.word;
                                } else {
                                    phi_909_ = _e688.unnamed_1.shift;
                                }
                                let _e820 = phi_909_;
                                if (_e772 == 0u) {
                                    phi_919_ = _e757.unnamed_1.word;
                                } else {
                                    phi_919_ = _e757.unnamed_1.shift;
                                }
                                let _e829 = phi_919_;
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e811 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e310)), ((f32(((_e820 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e311)));
                                let _e843 = core_intrinsics_minimum_number_nsz_f32_(_e842, ((f32(((_e829 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e312)));
                                if (_e808 <= _e843) {
                                    if (_e808 <= _e117) {
                                        if (_e843 >= 0f) {
                                            if (_e772 == 0u) {
                                                let _e850 = nodes.member[(0u + _e498)].links[2u];
                                                phi_955_ = _e850;
                                            } else {
                                                let _e853 = nodes.member[(0u + _e498)].links[3u];
                                                phi_955_ = _e853;
                                            }
                                            let _e855 = phi_955_;
                                            let _e860 = ((_e855 >> bitcast<u32>(((_e773 * 8u) & 31u))) & 255u);
                                            let _e861 = (_e860 & 31u);
                                            if (_e861 >= 24u) {
                                                phi_968_ = (24u + ((_e861 - 24u) ^ _e360));
                                            } else {
                                                phi_968_ = _e861;
                                            }
                                            let _e867 = phi_968_;
                                            phi_973_ = (_e769 | ((_e860 >> bitcast<u32>(5i)) << bitcast<u32>((_e867 & 31u))));
                                        } else {
                                            phi_973_ = _e769;
                                        }
                                        let _e875 = phi_973_;
                                        phi_974_ = _e875;
                                    } else {
                                        phi_974_ = _e769;
                                    }
                                    let _e877 = phi_974_;
                                    phi_975_ = _e877;
                                } else {
                                    phi_975_ = _e769;
                                }
                                let _e879 = phi_975_;
                                phi_845_ = (_e767 + 1u);
                                phi_848_ = _e879;
                            } else {
                                phi_845_ = u32();
                                phi_848_ = u32();
                            }
                            let _e882 = phi_845_;
                            let _e884 = phi_848_;
                            continue;
                            continuing {
                                phi_844_ = _e882;
                                phi_847_ = _e884;
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
                        phi_1033_ = (_e933 & 16777215u);
                        phi_1036_ = _e500;
                        loop {
                            let _e936 = phi_1033_;
                            let _e938 = phi_1036_;
                            local_6 = _e938;
                            let _e939 = (_e936 == 0u);
                            local_4 = _e939;
                            local_7 = _e939;
                            if _e939 {
                                phi_1034_ = u32();
                                phi_1037_ = bool();
                                phi_1634_ = false;
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
                                    phi_1081_ = vec3<f32>(_e958, _e960, _e956);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1080_ = vec3<f32>(_e960, _e956, _e958);
                                    } else {
                                        phi_1080_ = (_e954 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e968 = phi_1080_;
                                    phi_1081_ = _e968;
                                }
                                let _e970 = phi_1081_;
                                let _e974 = (_e970.x - (_e344 * _e970.z));
                                let _e978 = (_e970.y - (_e347 * _e970.z));
                                let _e980 = triangles.member[(0u + _e947)].v1_;
                                let _e982 = (_e980.x - _e107);
                                let _e984 = (_e980.y - _e109);
                                let _e986 = (_e980.z - _e111);
                                if (_e333 == 0u) {
                                    phi_1111_ = vec3<f32>(_e984, _e986, _e982);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1110_ = vec3<f32>(_e986, _e982, _e984);
                                    } else {
                                        phi_1110_ = (_e980 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e994 = phi_1110_;
                                    phi_1111_ = _e994;
                                }
                                let _e996 = phi_1111_;
                                let _e1000 = (_e996.x - (_e344 * _e996.z));
                                let _e1004 = (_e996.y - (_e347 * _e996.z));
                                let _e1006 = triangles.member[(0u + _e947)].v2_;
                                let _e1008 = (_e1006.x - _e107);
                                let _e1010 = (_e1006.y - _e109);
                                let _e1012 = (_e1006.z - _e111);
                                if (_e333 == 0u) {
                                    phi_1141_ = vec3<f32>(_e1010, _e1012, _e1008);
                                } else {
                                    if (_e333 == 1u) {
                                        phi_1140_ = vec3<f32>(_e1012, _e1008, _e1010);
                                    } else {
                                        phi_1140_ = (_e1006 - vec3<f32>(_e107, _e109, _e111));
                                    }
                                    let _e1020 = phi_1140_;
                                    phi_1141_ = _e1020;
                                }
                                let _e1022 = phi_1141_;
                                let _e1026 = (_e1022.x - (_e344 * _e1022.z));
                                let _e1030 = (_e1022.y - (_e347 * _e1022.z));
                                if (_e1000 < _e1026) {
                                    phi_1160_ = true;
                                } else {
                                    if (_e1000 == _e1026) {
                                        phi_1159_ = (_e1004 < _e1030);
                                    } else {
                                        phi_1159_ = false;
                                    }
                                    let _e1035 = phi_1159_;
                                    phi_1160_ = _e1035;
                                }
                                let _e1037 = phi_1160_;
                                if _e1037 {
                                    phi_1164_ = _e1030;
                                    phi_1165_ = _e1026;
                                    phi_1166_ = _e1004;
                                    phi_1167_ = _e1000;
                                } else {
                                    phi_1164_ = _e1004;
                                    phi_1165_ = _e1000;
                                    phi_1166_ = _e1030;
                                    phi_1167_ = _e1026;
                                }
                                let _e1039 = phi_1164_;
                                let _e1041 = phi_1165_;
                                let _e1043 = phi_1166_;
                                let _e1045 = phi_1167_;
                                let _e1048 = ((_e1045 * _e1039) - (_e1043 * _e1041));
                                if _e1037 {
                                    phi_1175_ = -(_e1048);
                                } else {
                                    phi_1175_ = _e1048;
                                }
                                let _e1051 = phi_1175_;
                                if (_e1026 < _e974) {
                                    phi_1186_ = true;
                                } else {
                                    if (_e1026 == _e974) {
                                        phi_1185_ = (_e1030 < _e978);
                                    } else {
                                        phi_1185_ = false;
                                    }
                                    let _e1056 = phi_1185_;
                                    phi_1186_ = _e1056;
                                }
                                let _e1058 = phi_1186_;
                                if _e1058 {
                                    phi_1190_ = _e978;
                                    phi_1191_ = _e974;
                                    phi_1192_ = _e1030;
                                    phi_1193_ = _e1026;
                                } else {
                                    phi_1190_ = _e1030;
                                    phi_1191_ = _e1026;
                                    phi_1192_ = _e978;
                                    phi_1193_ = _e974;
                                }
                                let _e1060 = phi_1190_;
                                let _e1062 = phi_1191_;
                                let _e1064 = phi_1192_;
                                let _e1066 = phi_1193_;
                                let _e1069 = ((_e1066 * _e1060) - (_e1064 * _e1062));
                                if _e1058 {
                                    phi_1201_ = -(_e1069);
                                } else {
                                    phi_1201_ = _e1069;
                                }
                                let _e1072 = phi_1201_;
                                if (_e974 < _e1000) {
                                    phi_1212_ = true;
                                } else {
                                    if (_e974 == _e1000) {
                                        phi_1211_ = (_e978 < _e1004);
                                    } else {
                                        phi_1211_ = false;
                                    }
                                    let _e1077 = phi_1211_;
                                    phi_1212_ = _e1077;
                                }
                                let _e1079 = phi_1212_;
                                if _e1079 {
                                    phi_1216_ = _e1004;
                                    phi_1217_ = _e1000;
                                    phi_1218_ = _e978;
                                    phi_1219_ = _e974;
                                } else {
                                    phi_1216_ = _e978;
                                    phi_1217_ = _e974;
                                    phi_1218_ = _e1004;
                                    phi_1219_ = _e1000;
                                }
                                let _e1081 = phi_1216_;
                                let _e1083 = phi_1217_;
                                let _e1085 = phi_1218_;
                                let _e1087 = phi_1219_;
                                let _e1090 = ((_e1087 * _e1081) - (_e1085 * _e1083));
                                if _e1079 {
                                    phi_1227_ = -(_e1090);
                                } else {
                                    phi_1227_ = _e1090;
                                }
                                let _e1093 = phi_1227_;
                                if (_e1051 >= 0f) {
                                    if (_e1072 >= 0f) {
                                        if (_e1093 >= 0f) {
                                            phi_1242_ = ((_e1051 + _e1072) + _e1093);
                                            phi_1243_ = false;
                                        } else {
                                            phi_1242_ = f32();
                                            phi_1243_ = true;
                                        }
                                        let _e1100 = phi_1242_;
                                        let _e1102 = phi_1243_;
                                        phi_1244_ = _e1100;
                                        phi_1245_ = _e1102;
                                    } else {
                                        phi_1244_ = f32();
                                        phi_1245_ = true;
                                    }
                                    let _e1104 = phi_1244_;
                                    let _e1106 = phi_1245_;
                                    phi_1246_ = _e1104;
                                    phi_1247_ = _e1106;
                                } else {
                                    phi_1246_ = f32();
                                    phi_1247_ = true;
                                }
                                let _e1108 = phi_1246_;
                                let _e1110 = phi_1247_;
                                if _e1110 {
                                    if (_e1051 <= 0f) {
                                        if (_e1072 <= 0f) {
                                            let _e1113 = (_e1093 <= 0f);
                                            if _e1113 {
                                            }
                                            phi_1265_ = ((_e1051 + _e1072) + _e1093);
                                            phi_1266_ = false;
                                            phi_1267_ = _e1113;
                                        } else {
                                            phi_1265_ = f32();
                                            phi_1266_ = true;
                                            phi_1267_ = false;
                                        }
                                        let _e1117 = phi_1265_;
                                        let _e1119 = phi_1266_;
                                        let _e1121 = phi_1267_;
                                        phi_1268_ = _e1117;
                                        phi_1269_ = _e1119;
                                        phi_1270_ = _e1121;
                                    } else {
                                        phi_1268_ = f32();
                                        phi_1269_ = true;
                                        phi_1270_ = false;
                                    }
                                    let _e1123 = phi_1268_;
                                    let _e1125 = phi_1269_;
                                    let _e1127 = phi_1270_;
                                    if _e1125 {
                                        phi_1274_ = false;
                                    } else {
                                        phi_1274_ = _e1127;
                                    }
                                    let _e1129 = phi_1274_;
                                    phi_1275_ = _e1123;
                                    phi_1276_ = _e1129;
                                } else {
                                    phi_1275_ = _e1108;
                                    phi_1276_ = true;
                                }
                                let _e1131 = phi_1275_;
                                let _e1133 = phi_1276_;
                                if _e1133 {
                                    let _e1134 = (_e1131 == 0f);
                                    if _e1134 {
                                        phi_1592_ = lt_bvh_triangle_Intersection();
                                        phi_1593_ = false;
                                    } else {
                                        let _e1136 = triangles.member[(0u + _e947)].v0_;
                                        let _e1138 = (_e1136.x - _e107);
                                        let _e1140 = (_e1136.y - _e109);
                                        let _e1142 = (_e1136.z - _e111);
                                        if (_e333 == 0u) {
                                            phi_1305_ = vec3<f32>(_e1140, _e1142, _e1138);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1304_ = vec3<f32>(_e1142, _e1138, _e1140);
                                            } else {
                                                phi_1304_ = (_e1136 - vec3<f32>(_e107, _e109, _e111));
                                            }
                                            let _e1150 = phi_1304_;
                                            phi_1305_ = _e1150;
                                        }
                                        let _e1152 = phi_1305_;
                                        let _e1154 = triangles.member[(0u + _e947)].v1_;
                                        let _e1156 = triangles.member[(0u + _e947)].v0_;
                                        let _e1159 = (_e1154.x - _e1156.x);
                                        let _e1162 = (_e1154.y - _e1156.y);
                                        let _e1165 = (_e1154.z - _e1156.z);
                                        if (_e333 == 0u) {
                                            phi_1331_ = vec3<f32>(_e1162, _e1165, _e1159);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1330_ = vec3<f32>(_e1165, _e1159, _e1162);
                                            } else {
                                                phi_1330_ = (_e1154 - _e1156);
                                            }
                                            let _e1172 = phi_1330_;
                                            phi_1331_ = _e1172;
                                        }
                                        let _e1174 = phi_1331_;
                                        let _e1176 = triangles.member[(0u + _e947)].v2_;
                                        let _e1178 = triangles.member[(0u + _e947)].v0_;
                                        let _e1181 = (_e1176.x - _e1178.x);
                                        let _e1184 = (_e1176.y - _e1178.y);
                                        let _e1187 = (_e1176.z - _e1178.z);
                                        if (_e333 == 0u) {
                                            phi_1357_ = vec3<f32>(_e1184, _e1187, _e1181);
                                        } else {
                                            if (_e333 == 1u) {
                                                phi_1356_ = vec3<f32>(_e1187, _e1181, _e1184);
                                            } else {
                                                phi_1356_ = (_e1176 - _e1178);
                                            }
                                            let _e1194 = phi_1356_;
                                            phi_1357_ = _e1194;
                                        }
                                        let _e1196 = phi_1357_;
                                        let _e1203 = ((_e1174.y * _e1196.z) - (_e1174.z * _e1196.y));
                                        let _e1210 = ((_e1174.z * _e1196.x) - (_e1174.x * _e1196.z));
                                        let _e1217 = ((_e1174.x * _e1196.y) - (_e1174.y * _e1196.x));
                                        let _e1231 = (((1f / _e341.z) * (((_e1203 * _e1152.x) + (_e1210 * _e1152.y)) + (_e1217 * _e1152.z))) / (((_e1203 * _e344) + (_e1210 * _e347)) + _e1217));
                                        if (_e1231 > 0f) {
                                            if (_e1231 < _e117) {
                                                let _e1235 = triangles.member[(0u + _e947)].v0_;
                                                let _e1237 = triangles.member[(0u + _e947)].v1_;
                                                if (_e1235.x < _e1237.x) {
                                                    phi_1413_ = _e1235.x;
                                                } else {
                                                    phi_1413_ = _e1237.x;
                                                }
                                                let _e1244 = phi_1413_;
                                                if (_e1235.y < _e1237.y) {
                                                    phi_1422_ = _e1235.y;
                                                } else {
                                                    phi_1422_ = _e1237.y;
                                                }
                                                let _e1251 = phi_1422_;
                                                if (_e1235.z < _e1237.z) {
                                                    phi_1431_ = _e1235.z;
                                                } else {
                                                    phi_1431_ = _e1237.z;
                                                }
                                                let _e1258 = phi_1431_;
                                                let _e1260 = triangles.member[(0u + _e947)].v2_;
                                                if (_e1244 < _e1260.x) {
                                                    phi_1440_ = _e1244;
                                                } else {
                                                    phi_1440_ = _e1260.x;
                                                }
                                                let _e1265 = phi_1440_;
                                                if (_e1251 < _e1260.y) {
                                                    phi_1447_ = _e1251;
                                                } else {
                                                    phi_1447_ = _e1260.y;
                                                }
                                                let _e1270 = phi_1447_;
                                                if (_e1258 < _e1260.z) {
                                                    phi_1454_ = _e1258;
                                                } else {
                                                    phi_1454_ = _e1260.z;
                                                }
                                                let _e1275 = phi_1454_;
                                                let _e1277 = triangles.member[(0u + _e947)].v0_;
                                                let _e1279 = triangles.member[(0u + _e947)].v1_;
                                                if (_e1277.x > _e1279.x) {
                                                    phi_1467_ = _e1277.x;
                                                } else {
                                                    phi_1467_ = _e1279.x;
                                                }
                                                let _e1286 = phi_1467_;
                                                if (_e1277.y > _e1279.y) {
                                                    phi_1476_ = _e1277.y;
                                                } else {
                                                    phi_1476_ = _e1279.y;
                                                }
                                                let _e1293 = phi_1476_;
                                                if (_e1277.z > _e1279.z) {
                                                    phi_1485_ = _e1277.z;
                                                } else {
                                                    phi_1485_ = _e1279.z;
                                                }
                                                let _e1300 = phi_1485_;
                                                let _e1302 = triangles.member[(0u + _e947)].v2_;
                                                if (_e1286 > _e1302.x) {
                                                    phi_1494_ = _e1286;
                                                } else {
                                                    phi_1494_ = _e1302.x;
                                                }
                                                let _e1307 = phi_1494_;
                                                if (_e1293 > _e1302.y) {
                                                    phi_1501_ = _e1293;
                                                } else {
                                                    phi_1501_ = _e1302.y;
                                                }
                                                let _e1312 = phi_1501_;
                                                if (_e1300 > _e1302.z) {
                                                    phi_1508_ = _e1300;
                                                } else {
                                                    phi_1508_ = _e1302.z;
                                                }
                                                let _e1317 = phi_1508_;
                                                let _e1321 = ((_e1265 - _e107) * _e258);
                                                let _e1322 = ((_e1270 - _e109) * _e268);
                                                let _e1323 = ((_e1275 - _e111) * _e278);
                                                let _e1327 = ((_e1307 - _e107) * _e258);
                                                let _e1328 = ((_e1312 - _e109) * _e268);
                                                let _e1329 = ((_e1317 - _e111) * _e278);
                                                if (_e1321 < _e1327) {
                                                    phi_1525_ = _e1321;
                                                } else {
                                                    phi_1525_ = _e1327;
                                                }
                                                let _e1332 = phi_1525_;
                                                if (_e1322 < _e1328) {
                                                    phi_1530_ = _e1322;
                                                } else {
                                                    phi_1530_ = _e1328;
                                                }
                                                let _e1335 = phi_1530_;
                                                if (_e1323 < _e1329) {
                                                    phi_1535_ = _e1323;
                                                } else {
                                                    phi_1535_ = _e1329;
                                                }
                                                let _e1338 = phi_1535_;
                                                if (_e1321 > _e1327) {
                                                    phi_1543_ = _e1321;
                                                } else {
                                                    phi_1543_ = _e1327;
                                                }
                                                let _e1344 = phi_1543_;
                                                if (_e1322 > _e1328) {
                                                    phi_1548_ = _e1322;
                                                } else {
                                                    phi_1548_ = _e1328;
                                                }
                                                let _e1347 = phi_1548_;
                                                if (_e1323 > _e1329) {
                                                    phi_1553_ = _e1323;
                                                } else {
                                                    phi_1553_ = _e1329;
                                                }
                                                let _e1350 = phi_1553_;
                                                let _e1354 = core_intrinsics_maximum_number_nsz_f32_((_e1332 - _e317), (_e1335 - _e318));
                                                let _e1355 = core_intrinsics_maximum_number_nsz_f32_(_e1354, (_e1338 - _e319));
                                                let _e1356 = core_intrinsics_minimum_number_nsz_f32_((_e1344 + _e317), (_e1347 + _e318));
                                                let _e1357 = core_intrinsics_minimum_number_nsz_f32_(_e1356, (_e1350 + _e319));
                                                if (_e1355 > -300000000000000000000000000000000000000f) {
                                                    phi_1565_ = _e1355;
                                                } else {
                                                    phi_1565_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1360 = phi_1565_;
                                                if (_e1357 < 300000000000000000000000000000000000000f) {
                                                    phi_1570_ = _e1357;
                                                } else {
                                                    phi_1570_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1363 = phi_1570_;
                                                if (_e1231 < _e1360) {
                                                    phi_1575_ = _e1360;
                                                } else {
                                                    phi_1575_ = _e1231;
                                                }
                                                let _e1366 = phi_1575_;
                                                if (_e1366 > _e1363) {
                                                    phi_1580_ = _e1363;
                                                } else {
                                                    phi_1580_ = _e1366;
                                                }
                                                let _e1369 = phi_1580_;
                                                phi_1585_ = lt_bvh_triangle_Intersection(_e1369, (_e1072 / _e1131), (_e1093 / _e1131), (_e1360 <= _e1363));
                                                phi_1586_ = false;
                                            } else {
                                                phi_1585_ = lt_bvh_triangle_Intersection();
                                                phi_1586_ = true;
                                            }
                                            let _e1375 = phi_1585_;
                                            let _e1377 = phi_1586_;
                                            phi_1587_ = _e1375;
                                            phi_1588_ = _e1377;
                                        } else {
                                            phi_1587_ = lt_bvh_triangle_Intersection();
                                            phi_1588_ = true;
                                        }
                                        let _e1379 = phi_1587_;
                                        let _e1381 = phi_1588_;
                                        if _e1381 {
                                        }
                                        phi_1592_ = _e1379;
                                        phi_1593_ = _e1381;
                                    }
                                    let _e1383 = phi_1592_;
                                    let _e1385 = phi_1593_;
                                    phi_1594_ = _e1383;
                                    phi_1595_ = _e1134;
                                    phi_1596_ = _e1385;
                                } else {
                                    phi_1594_ = lt_bvh_triangle_Intersection();
                                    phi_1595_ = true;
                                    phi_1596_ = false;
                                }
                                let _e1387 = phi_1594_;
                                let _e1389 = phi_1595_;
                                let _e1391 = phi_1596_;
                                if _e1389 {
                                    phi_1600_ = true;
                                } else {
                                    phi_1600_ = _e1391;
                                }
                                let _e1393 = phi_1600_;
                                if _e1393 {
                                    phi_1604_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1604_ = _e1387;
                                }
                                let _e1395 = phi_1604_;
                                if _e1395.is_hit {
                                    if (_e1395.t > 0f) {
                                        if (_e1395.t < _e117) {
                                            if true {
                                                phi_1624_ = false;
                                            } else {
                                                phi_1624_ = true;
                                            }
                                            let _e1404 = phi_1624_;
                                            phi_1625_ = true;
                                            phi_1626_ = _e1404;
                                        } else {
                                            phi_1625_ = _e938;
                                            phi_1626_ = true;
                                        }
                                        let _e1406 = phi_1625_;
                                        let _e1408 = phi_1626_;
                                        phi_1627_ = _e1406;
                                        phi_1628_ = _e1408;
                                    } else {
                                        phi_1627_ = _e938;
                                        phi_1628_ = true;
                                    }
                                    let _e1410 = phi_1627_;
                                    let _e1412 = phi_1628_;
                                    phi_1629_ = _e1410;
                                    phi_1630_ = _e1412;
                                } else {
                                    phi_1629_ = _e938;
                                    phi_1630_ = true;
                                }
                                let _e1414 = phi_1629_;
                                let _e1416 = phi_1630_;
                                if _e1416 {
                                }
                                phi_1034_ = (_e936 & (_e936 - 1u));
                                phi_1037_ = _e1414;
                                phi_1634_ = _e1416;
                            }
                            let _e1418 = phi_1034_;
                            let _e1420 = phi_1037_;
                            let _e1422 = phi_1634_;
                            continue;
                            continuing {
                                phi_1033_ = _e1418;
                                phi_1036_ = _e1420;
                                break if !(_e1422);
                            }
                        }
                        let _e1425 = local_4;
                        if _e1425 {
                            let _e1427 = local.group_mask;
                            if ((_e1427 & 4278190080u) == 0u) {
                                let _e1431 = local.len;
                                if (_e1431 == 0u) {
                                    phi_1676_ = false;
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
                                    phi_1676_ = true;
                                }
                                let _e1454 = phi_1676_;
                                phi_1677_ = _e1454;
                            } else {
                                phi_1677_ = true;
                            }
                            let _e1456 = phi_1677_;
                            if _e1456 {
                                let _e1458 = local.group_mask;
                                let _e1464 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1458)), 32u, (_e1458 == 0u)));
                                let _e1468 = local.group_mask;
                                let _e1482 = local.group_mask;
                                local.group_mask = (_e1482 & ~((1u << bitcast<u32>((_e1464 & 31u)))));
                                let _e1485 = local.group;
                                phi_1708_ = (_e1485 + countOneBits(((_e1468 & ~((4294967295u << bitcast<u32>((((_e1464 - 24u) ^ _e360) & 31u))))) & 255u)));
                            } else {
                                phi_1708_ = 4294967295u;
                            }
                            let _e1488 = phi_1708_;
                            phi_1709_ = _e1488;
                        } else {
                            phi_1709_ = u32();
                        }
                        let _e1490 = phi_1709_;
                        phi_702_ = _e1490;
                        let _e1776 = local_6;
                        phi_705_ = _e1776;
                        let _e1779 = local_7;
                        phi_1710_ = _e1779;
                        phi_1711_ = false;
                    } else {
                        phi_702_ = u32();
                        phi_705_ = bool();
                        phi_1710_ = false;
                        phi_1711_ = true;
                    }
                    let _e1492 = phi_702_;
                    let _e1494 = phi_705_;
                    let _e1496 = phi_1710_;
                    let _e1498 = phi_1711_;
                    local_5 = _e1498;
                    continue;
                    continuing {
                        phi_701_ = _e1492;
                        phi_704_ = _e1494;
                        break if !(_e1496);
                    }
                }
                let _e1501 = local_5;
                if _e1501 {
                    phi_1715_ = false;
                } else {
                    phi_1715_ = true;
                }
                let _e1503 = phi_1715_;
                if _e1503 {
                    phi_1719_ = true;
                } else {
                    let _e1785 = local_8;
                    phi_1719_ = _e1785;
                }
                let _e1505 = phi_1719_;
                phi_1720_ = _e1505;
            }
            let _e1507 = phi_1720_;
            phi_1721_ = _e1507;
            phi_1722_ = _e182;
        } else {
            phi_1721_ = bool();
            phi_1722_ = true;
        }
        let _e1509 = phi_1721_;
        let _e1511 = phi_1722_;
        if _e1511 {
            phi_1726_ = false;
        } else {
            phi_1726_ = _e1509;
        }
        let _e1513 = phi_1726_;
        if _e1513 {
            phi_1730_ = 0f;
        } else {
            phi_1730_ = 1f;
        }
        let _e1515 = phi_1730_;
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
            phi_1771_ = _e1538;
        } else {
            phi_1771_ = 0u;
        }
        let _e1540 = phi_1771_;
        if (_e1532 < _e74) {
        } else {
            return;
        }
        let _e1544 = bits.member[(0u + _e1532)];
        let _e1547 = (_e1544 >> bitcast<u32>((_e1524 & 31u)));
        if (_e1524 > 29u) {
            phi_1790_ = (_e1547 | (_e1540 << bitcast<u32>(((32u - _e1524) & 31u))));
        } else {
            phi_1790_ = _e1547;
        }
        let _e1555 = phi_1790_;
        if ((_e1555 & 2u) == 0u) {
            phi_1798_ = (_e1555 & 1u);
        } else {
            phi_1798_ = (_e1555 & 7u);
        }
        let _e1561 = phi_1798_;
        if ((_e1561 & 1u) != 0u) {
            phi_1806_ = (2u | 1u);
        } else {
            phi_1806_ = 2u;
        }
        let _e1567 = phi_1806_;
        if (_e1530 < 0.5f) {
            phi_1811_ = (_e1567 | 4u);
        } else {
            phi_1811_ = _e1567;
        }
        let _e1570 = phi_1811_;
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
