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
    var phi_161_: bool;
    var phi_165_: f32;

    if (param != param) {
        phi_161_ = true;
    } else {
        let _e58 = (param_1 >= param);
        if _e58 {
        }
        phi_161_ = _e58;
    }
    let _e60 = phi_161_;
    if _e60 {
        phi_165_ = param_1;
    } else {
        phi_165_ = param;
    }
    let _e62 = phi_165_;
    return _e62;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_177_: bool;
    var phi_181_: f32;

    if (param_2 != param_2) {
        phi_177_ = true;
    } else {
        let _e58 = (param_3 <= param_2);
        if _e58 {
        }
        phi_177_ = _e58;
    }
    let _e60 = phi_177_;
    if _e60 {
        phi_181_ = param_3;
    } else {
        phi_181_ = param_2;
    }
    let _e62 = phi_181_;
    return _e62;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_259_: f32;
    var phi_290_: bool;
    var phi_291_: bool;
    var phi_292_: bool;
    var phi_293_: bool;
    var phi_297_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_317_: bool;
    var phi_330_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_344_: bool;
    var phi_414_: f32;
    var phi_421_: f32;
    var phi_428_: f32;
    var phi_435_: f32;
    var phi_442_: f32;
    var phi_449_: f32;
    var phi_466_: f32;
    var phi_471_: f32;
    var phi_476_: f32;
    var phi_481_: f32;
    var phi_486_: f32;
    var phi_512_: bool;
    var phi_513_: bool;
    var phi_521_: u32;
    var phi_522_: u32;
    var phi_533_: vec3<f32>;
    var phi_534_: vec3<f32>;
    var phi_547_: u32;
    var phi_552_: u32;
    var phi_557_: u32;
    var phi_671_: bool;
    var phi_672_: bool;
    var phi_703_: u32;
    var phi_705_: u32;
    var phi_708_: bool;
    var phi_788_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_815_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_842_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_848_: u32;
    var phi_851_: u32;
    var phi_865_: u32;
    var phi_875_: u32;
    var phi_885_: u32;
    var phi_903_: u32;
    var phi_913_: u32;
    var phi_923_: u32;
    var phi_959_: u32;
    var phi_972_: u32;
    var phi_977_: u32;
    var phi_978_: u32;
    var phi_979_: u32;
    var phi_849_: u32;
    var phi_852_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1037_: u32;
    var phi_1040_: bool;
    var phi_1084_: vec3<f32>;
    var phi_1085_: vec3<f32>;
    var phi_1114_: vec3<f32>;
    var phi_1115_: vec3<f32>;
    var phi_1144_: vec3<f32>;
    var phi_1145_: vec3<f32>;
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
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1220_: f32;
    var phi_1221_: f32;
    var phi_1222_: f32;
    var phi_1223_: f32;
    var phi_1231_: f32;
    var phi_1246_: f32;
    var phi_1247_: bool;
    var phi_1248_: f32;
    var phi_1249_: bool;
    var phi_1250_: f32;
    var phi_1251_: bool;
    var phi_1269_: f32;
    var phi_1270_: bool;
    var phi_1271_: bool;
    var phi_1272_: f32;
    var phi_1273_: bool;
    var phi_1274_: bool;
    var phi_1278_: bool;
    var phi_1279_: f32;
    var phi_1280_: bool;
    var phi_1308_: vec3<f32>;
    var phi_1309_: vec3<f32>;
    var phi_1334_: vec3<f32>;
    var phi_1335_: vec3<f32>;
    var phi_1360_: vec3<f32>;
    var phi_1361_: vec3<f32>;
    var phi_1417_: f32;
    var phi_1426_: f32;
    var phi_1435_: f32;
    var phi_1444_: f32;
    var phi_1451_: f32;
    var phi_1458_: f32;
    var phi_1471_: f32;
    var phi_1480_: f32;
    var phi_1489_: f32;
    var phi_1498_: f32;
    var phi_1505_: f32;
    var phi_1512_: f32;
    var phi_1529_: f32;
    var phi_1534_: f32;
    var phi_1539_: f32;
    var phi_1547_: f32;
    var phi_1552_: f32;
    var phi_1557_: f32;
    var phi_1569_: f32;
    var phi_1574_: f32;
    var phi_1579_: f32;
    var phi_1584_: f32;
    var phi_1589_: lt_bvh_triangle_Intersection;
    var phi_1590_: bool;
    var phi_1591_: lt_bvh_triangle_Intersection;
    var phi_1592_: bool;
    var phi_1596_: lt_bvh_triangle_Intersection;
    var phi_1597_: bool;
    var phi_1598_: lt_bvh_triangle_Intersection;
    var phi_1599_: bool;
    var phi_1600_: bool;
    var phi_1604_: bool;
    var phi_1608_: lt_bvh_triangle_Intersection;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1630_: bool;
    var phi_1631_: bool;
    var phi_1632_: bool;
    var phi_1633_: bool;
    var phi_1634_: bool;
    var phi_1038_: u32;
    var phi_1041_: bool;
    var phi_1638_: bool;
    var local_4: bool;
    var phi_1680_: bool;
    var phi_1681_: bool;
    var phi_1712_: u32;
    var phi_1713_: u32;
    var phi_706_: u32;
    var phi_709_: bool;
    var phi_1714_: bool;
    var phi_1715_: bool;
    var local_5: bool;
    var phi_1719_: bool;
    var phi_1723_: bool;
    var phi_1724_: bool;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1730_: bool;
    var phi_1734_: f32;
    var phi_1775_: u32;
    var phi_1794_: u32;
    var phi_1802_: u32;
    var phi_1810_: u32;
    var phi_1815_: u32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;

    let _e56 = id_1;
    let _e63 = arrayLength((&nodes.member));
    let _e69 = arrayLength((&visibility.member));
    let _e72 = arrayLength((&list.member));
    let _e75 = arrayLength((&bits.member));
    let _e79 = ((_e56.y * 2097152u) + _e56.x);
    if (3u < _e72) {
    } else {
        return;
    }
    let _e82 = list.member[3u];
    if (_e79 < _e82) {
        let _e84 = (_e79 + 4u);
        if (_e84 < _e72) {
        } else {
            return;
        }
        let _e88 = list.member[(0u + _e84)];
        let _e89 = (_e88 & 2147483647u);
        if (_e89 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e95 = samples.member[(0u + _e89)].position;
        let _e97 = samples.member[(0u + _e89)].normal;
        let _e99 = samples.member[(0u + _e89)].magnitude;
        let _e101 = ((8f / 8388608f) * _e99);
        let _e109 = (_e95.x + (_e97.x * _e101));
        let _e111 = (_e95.y + (_e97.y * _e101));
        let _e113 = (_e95.z + (_e97.z * _e101));
        let _e115 = p.member.light.place;
        if (_e115.w == 0f) {
            phi_259_ = 300000000000000000000000000000000000000f;
        } else {
            phi_259_ = 1f;
        }
        let _e119 = phi_259_;
        let _e127 = (_e115.x - (_e109 * _e115.w));
        let _e128 = (_e115.y - (_e111 * _e115.w));
        let _e129 = (_e115.z - (_e113 * _e115.w));
        let _e131 = abs(_e127);
        let _e132 = abs(_e128);
        let _e133 = abs(_e129);
        if (abs(_e109) < 1000000000000000f) {
            if (abs(_e111) < 1000000000000000f) {
                phi_290_ = (abs(_e113) < 1000000000000000f);
                phi_291_ = false;
            } else {
                phi_290_ = bool();
                phi_291_ = true;
            }
            let _e141 = phi_290_;
            let _e143 = phi_291_;
            phi_292_ = _e141;
            phi_293_ = _e143;
        } else {
            phi_292_ = bool();
            phi_293_ = true;
        }
        let _e145 = phi_292_;
        let _e147 = phi_293_;
        if _e147 {
            phi_297_ = false;
        } else {
            phi_297_ = _e145;
        }
        let _e149 = phi_297_;
        if _e149 {
            if (_e131 < 1000000000000000f) {
                if (_e132 < 1000000000000000f) {
                    phi_310_ = (_e133 < 1000000000000000f);
                    phi_311_ = false;
                } else {
                    phi_310_ = bool();
                    phi_311_ = true;
                }
                let _e154 = phi_310_;
                let _e156 = phi_311_;
                phi_312_ = _e154;
                phi_313_ = _e156;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
            }
            let _e158 = phi_312_;
            let _e160 = phi_313_;
            if _e160 {
                phi_317_ = false;
            } else {
                phi_317_ = _e158;
            }
            let _e162 = phi_317_;
            if _e162 {
                if (_e131 > 0f) {
                    phi_331_ = bool();
                    phi_332_ = true;
                } else {
                    let _e164 = (_e132 > 0f);
                    if _e164 {
                        phi_330_ = bool();
                    } else {
                        phi_330_ = (_e133 > 0f);
                    }
                    let _e167 = phi_330_;
                    phi_331_ = _e167;
                    phi_332_ = _e164;
                }
                let _e169 = phi_331_;
                let _e171 = phi_332_;
                if _e171 {
                    phi_336_ = true;
                } else {
                    phi_336_ = _e169;
                }
                let _e173 = phi_336_;
                phi_337_ = _e173;
                phi_338_ = false;
            } else {
                phi_337_ = bool();
                phi_338_ = true;
            }
            let _e175 = phi_337_;
            let _e177 = phi_338_;
            phi_339_ = _e175;
            phi_340_ = _e177;
        } else {
            phi_339_ = bool();
            phi_340_ = true;
        }
        let _e179 = phi_339_;
        let _e181 = phi_340_;
        if _e181 {
            phi_344_ = false;
        } else {
            phi_344_ = _e179;
        }
        let _e183 = phi_344_;
        if _e183 {
            let _e184 = (0u >= _e63);
            if _e184 {
                phi_1724_ = bool();
            } else {
                if (0u < _e63) {
                } else {
                    return;
                }
                let _e190 = nodes.member[(0u + 0u)].frame[0u];
                let _e194 = nodes.member[(0u + 0u)].frame[1u];
                let _e198 = nodes.member[(0u + 0u)].frame[2u];
                let _e202 = nodes.member[(0u + 0u)].frame[0u];
                let _e206 = nodes.member[(0u + 0u)].frame[1u];
                let _e210 = nodes.member[(0u + 0u)].frame[2u];
                let _e214 = nodes.member[(0u + 0u)].frame[3u];
                let _e248 = core_intrinsics_maximum_number_nsz_f32_(abs(_e127), abs(_e128));
                let _e249 = core_intrinsics_maximum_number_nsz_f32_(_e248, abs(_e129));
                let _e250 = (_e249 * 0.0000000000009094947f);
                if (abs(_e127) < _e250) {
                    phi_414_ = _e250;
                } else {
                    phi_414_ = abs(_e127);
                }
                let _e255 = phi_414_;
                if (_e127 < 0f) {
                    phi_421_ = (-1f / _e255);
                } else {
                    phi_421_ = (1f / _e255);
                }
                let _e260 = phi_421_;
                if (abs(_e128) < _e250) {
                    phi_428_ = _e250;
                } else {
                    phi_428_ = abs(_e128);
                }
                let _e265 = phi_428_;
                if (_e128 < 0f) {
                    phi_435_ = (-1f / _e265);
                } else {
                    phi_435_ = (1f / _e265);
                }
                let _e270 = phi_435_;
                if (abs(_e129) < _e250) {
                    phi_442_ = _e250;
                } else {
                    phi_442_ = abs(_e129);
                }
                let _e275 = phi_442_;
                if (_e129 < 0f) {
                    phi_449_ = (-1f / _e275);
                } else {
                    phi_449_ = (1f / _e275);
                }
                let _e280 = phi_449_;
                let _e284 = abs((bitcast<f32>(_e190) - _e109));
                let _e285 = abs((bitcast<f32>(_e194) - _e111));
                let _e286 = abs((bitcast<f32>(_e198) - _e113));
                let _e290 = abs(((bitcast<f32>(_e202) + (bitcast<f32>((((_e214 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                let _e291 = abs(((bitcast<f32>(_e206) + (bitcast<f32>((((_e214 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e111));
                let _e292 = abs(((bitcast<f32>(_e210) + (bitcast<f32>((((_e214 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e113));
                if (_e284 > _e290) {
                    phi_466_ = _e284;
                } else {
                    phi_466_ = _e290;
                }
                let _e295 = phi_466_;
                if (_e285 > _e291) {
                    phi_471_ = _e285;
                } else {
                    phi_471_ = _e291;
                }
                let _e298 = phi_471_;
                if (_e286 > _e292) {
                    phi_476_ = _e286;
                } else {
                    phi_476_ = _e292;
                }
                let _e301 = phi_476_;
                if (_e295 > _e298) {
                    phi_481_ = _e295;
                } else {
                    phi_481_ = _e298;
                }
                let _e304 = phi_481_;
                if (_e304 > _e301) {
                    phi_486_ = _e304;
                } else {
                    phi_486_ = _e301;
                }
                let _e307 = phi_486_;
                let _e311 = (_e307 * 0.0000019073486f);
                let _e312 = (abs(_e260) * _e311);
                let _e313 = (abs(_e270) * _e311);
                let _e314 = (abs(_e280) * _e311);
                let _e318 = (_e307 * 0.0000009536743f);
                let _e319 = (abs(_e260) * _e318);
                let _e320 = (abs(_e270) * _e318);
                let _e321 = (abs(_e280) * _e318);
                let _e322 = abs(_e127);
                let _e323 = abs(_e128);
                let _e324 = abs(_e129);
                if (_e322 >= _e323) {
                    if (_e322 >= _e324) {
                        phi_512_ = false;
                    } else {
                        phi_512_ = true;
                    }
                    let _e328 = phi_512_;
                    phi_513_ = _e328;
                } else {
                    phi_513_ = true;
                }
                let _e330 = phi_513_;
                if _e330 {
                    if (_e323 >= _e324) {
                        phi_521_ = 1u;
                    } else {
                        phi_521_ = 2u;
                    }
                    let _e333 = phi_521_;
                    phi_522_ = _e333;
                } else {
                    phi_522_ = 0u;
                }
                let _e335 = phi_522_;
                if (_e335 == 0u) {
                    phi_534_ = vec3<f32>(_e128, _e129, _e127);
                } else {
                    if (_e335 == 1u) {
                        phi_533_ = vec3<f32>(_e129, _e127, _e128);
                    } else {
                        phi_533_ = vec3<f32>(_e127, _e128, _e129);
                    }
                    let _e341 = phi_533_;
                    phi_534_ = _e341;
                }
                let _e343 = phi_534_;
                let _e346 = (_e343.x / _e343.z);
                let _e349 = (_e343.y / _e343.z);
                if (_e260 < 0f) {
                    phi_547_ = 0u;
                } else {
                    phi_547_ = 1u;
                }
                let _e354 = phi_547_;
                if (_e270 < 0f) {
                    phi_552_ = 0u;
                } else {
                    phi_552_ = 2u;
                }
                let _e357 = phi_552_;
                if (_e280 < 0f) {
                    phi_557_ = 0u;
                } else {
                    phi_557_ = 4u;
                }
                let _e360 = phi_557_;
                let _e362 = ((_e354 | _e357) | _e360);
                let _e363 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e363.first[0], _e363.first[1], _e363.first[2], _e363.first[3], _e363.first[4], _e363.first[5], _e363.first[6], _e363.first[7], _e363.first[8], _e363.first[9], _e363.first[10], _e363.first[11], _e363.first[12], _e363.first[13], _e363.first[14], _e363.first[15], _e363.first[16], _e363.first[17], _e363.first[18], _e363.first[19], _e363.first[20], _e363.first[21], _e363.first[22], _e363.first[23], _e363.first[24], _e363.first[25], _e363.first[26], _e363.first[27], _e363.first[28], _e363.first[29], _e363.first[30], _e363.first[31]), array<u32, 32>(_e363.mask[0], _e363.mask[1], _e363.mask[2], _e363.mask[3], _e363.mask[4], _e363.mask[5], _e363.mask[6], _e363.mask[7], _e363.mask[8], _e363.mask[9], _e363.mask[10], _e363.mask[11], _e363.mask[12], _e363.mask[13], _e363.mask[14], _e363.mask[15], _e363.mask[16], _e363.mask[17], _e363.mask[18], _e363.mask[19], _e363.mask[20], _e363.mask[21], _e363.mask[22], _e363.mask[23], _e363.mask[24], _e363.mask[25], _e363.mask[26], _e363.mask[27], _e363.mask[28], _e363.mask[29], _e363.mask[30], _e363.mask[31]), _e363.len, _e363.group, _e363.group_mask);
                let _e437 = local.group_mask;
                if ((_e437 & 4278190080u) == 0u) {
                    let _e441 = local.len;
                    if (_e441 == 0u) {
                        phi_671_ = false;
                    } else {
                        let _e445 = local.len;
                        local.len = (_e445 - 1u);
                        let _e448 = local.len;
                        if (_e448 < 32u) {
                        } else {
                            return;
                        }
                        let _e453 = local.first[(0u + _e448)];
                        local.group = _e453;
                        let _e456 = local.len;
                        if (_e456 < 32u) {
                        } else {
                            return;
                        }
                        let _e461 = local.mask[(0u + _e456)];
                        local.group_mask = _e461;
                        phi_671_ = true;
                    }
                    let _e464 = phi_671_;
                    phi_672_ = _e464;
                } else {
                    phi_672_ = true;
                }
                let _e466 = phi_672_;
                if _e466 {
                    let _e468 = local.group_mask;
                    let _e474 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e468)), 32u, (_e468 == 0u)));
                    let _e478 = local.group_mask;
                    let _e492 = local.group_mask;
                    local.group_mask = (_e492 & ~((1u << bitcast<u32>((_e474 & 31u)))));
                    let _e495 = local.group;
                    phi_703_ = (_e495 + countOneBits(((_e478 & ~((4294967295u << bitcast<u32>((((_e474 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_703_ = 4294967295u;
                }
                let _e498 = phi_703_;
                phi_705_ = _e498;
                phi_708_ = false;
                loop {
                    let _e500 = phi_705_;
                    let _e502 = phi_708_;
                    local_8 = _e502;
                    if (_e500 != 4294967295u) {
                        if (_e500 < _e63) {
                        } else {
                            return;
                        }
                        let _e509 = nodes.member[(0u + _e500)].frame[3u];
                        let _e534 = (bitcast<f32>((((_e509 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e260);
                        let _e535 = (bitcast<f32>((((_e509 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e270);
                        let _e536 = (bitcast<f32>((((_e509 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e280);
                        let _e539 = nodes.member[(0u + _e500)].frame[0u];
                        let _e543 = nodes.member[(0u + _e500)].frame[1u];
                        let _e547 = nodes.member[(0u + _e500)].frame[2u];
                        let _e552 = ((bitcast<f32>(_e539) - _e109) * _e260);
                        let _e553 = ((bitcast<f32>(_e543) - _e111) * _e270);
                        let _e554 = ((bitcast<f32>(_e547) - _e113) * _e280);
                        let _e562 = nodes.member[(0u + _e500)].x;
                        if (_e260 < 0f) {
                            let _e573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e562.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e573.unnamed.root, _e562.w), _e573.unnamed_1);
                            let _e585 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e579.unnamed, lt_bvh_traverse_Tree(_e562.x, _e579.unnamed_1.first_primitive));
                            phi_788_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e585.unnamed, lt_bvh_traverse_Tree(_e585.unnamed_1.root, _e562.y));
                        } else {
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e562.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e601.unnamed.root, _e562.y), _e601.unnamed_1);
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_bvh_traverse_Tree(_e562.z, _e607.unnamed_1.first_primitive));
                            phi_788_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e613.unnamed, lt_bvh_traverse_Tree(_e613.unnamed_1.root, _e562.w));
                        }
                        let _e621 = phi_788_;
                        let _e631 = nodes.member[(0u + _e500)].y;
                        if (_e270 < 0f) {
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e631.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e642.unnamed.root, _e631.w), _e642.unnamed_1);
                            let _e654 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_bvh_traverse_Tree(_e631.x, _e648.unnamed_1.first_primitive));
                            phi_815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e654.unnamed, lt_bvh_traverse_Tree(_e654.unnamed_1.root, _e631.y));
                        } else {
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e631.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e670.unnamed.root, _e631.y), _e670.unnamed_1);
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_bvh_traverse_Tree(_e631.z, _e676.unnamed_1.first_primitive));
                            phi_815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_bvh_traverse_Tree(_e682.unnamed_1.root, _e631.w));
                        }
                        let _e690 = phi_815_;
                        let _e700 = nodes.member[(0u + _e500)].z;
                        if (_e280 < 0f) {
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e711.unnamed.root, _e700.w), _e711.unnamed_1);
                            let _e723 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_bvh_traverse_Tree(_e700.x, _e717.unnamed_1.first_primitive));
                            phi_842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e723.unnamed, lt_bvh_traverse_Tree(_e723.unnamed_1.root, _e700.y));
                        } else {
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e700.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e739.unnamed.root, _e700.y), _e739.unnamed_1);
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_bvh_traverse_Tree(_e700.z, _e745.unnamed_1.first_primitive));
                            phi_842_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_bvh_traverse_Tree(_e751.unnamed_1.root, _e700.w));
                        }
                        let _e759 = phi_842_;
                        phi_848_ = 0u;
                        phi_851_ = 0u;
                        loop {
                            let _e769 = phi_848_;
                            let _e771 = phi_851_;
                            local_1 = _e771;
                            local_2 = _e771;
                            local_3 = _e771;
                            let _e772 = (_e769 < 8u);
                            if _e772 {
                                let _e774 = (_e769 >> bitcast<u32>(2i));
                                let _e775 = (_e769 & 3u);
                                if (_e774 == 0u) {
                                    phi_865_ = _e621.unnamed.root;
                                } else {
                                    phi_865_ = _e621.unnamed.first_primitive;
                                }
                                let _e778 = phi_865_;
                                if (_e774 == 0u) {
                                    phi_875_ = _e690.unnamed.root;
                                } else {
                                    phi_875_ = _e690.unnamed.first_primitive;
                                }
                                let _e787 = phi_875_;
                                if (_e774 == 0u) {
                                    phi_885_ = _e759.unnamed.root;
                                } else {
                                    phi_885_ = _e759.unnamed.first_primitive;
                                }
                                let _e796 = phi_885_;
                                let _e809 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e778 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e312)), ((f32(((_e787 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e535) + (_e553 - _e313)));
                                let _e810 = core_intrinsics_maximum_number_nsz_f32_(_e809, ((f32(((_e796 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e536) + (_e554 - _e314)));
                                if (_e774 == 0u) {
                                    phi_903_ = _e621.unnamed_1.root;
                                } else {
                                    phi_903_ = _e621.unnamed_1.first_primitive;
                                }
                                let _e813 = phi_903_;
                                if (_e774 == 0u) {
                                    phi_913_ = _e690.unnamed_1.root;
                                } else {
                                    phi_913_ = _e690.unnamed_1.first_primitive;
                                }
                                let _e822 = phi_913_;
                                if (_e774 == 0u) {
                                    phi_923_ = _e759.unnamed_1.root;
                                } else {
                                    phi_923_ = _e759.unnamed_1.first_primitive;
                                }
                                let _e831 = phi_923_;
                                let _e844 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e813 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e312)), ((f32(((_e822 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e535) + (_e553 + _e313)));
                                let _e845 = core_intrinsics_minimum_number_nsz_f32_(_e844, ((f32(((_e831 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u)) * _e536) + (_e554 + _e314)));
                                if (_e810 <= _e845) {
                                    if (_e810 <= _e119) {
                                        if (_e845 >= 0f) {
                                            if (_e774 == 0u) {
                                                let _e852 = nodes.member[(0u + _e500)].links[2u];
                                                phi_959_ = _e852;
                                            } else {
                                                let _e855 = nodes.member[(0u + _e500)].links[3u];
                                                phi_959_ = _e855;
                                            }
                                            let _e857 = phi_959_;
                                            let _e862 = ((_e857 >> bitcast<u32>(((_e775 * 8u) & 31u))) & 255u);
                                            let _e863 = (_e862 & 31u);
                                            if (_e863 >= 24u) {
                                                phi_972_ = (24u + ((_e863 - 24u) ^ _e362));
                                            } else {
                                                phi_972_ = _e863;
                                            }
                                            let _e869 = phi_972_;
                                            phi_977_ = (_e771 | ((_e862 >> bitcast<u32>(5i)) << bitcast<u32>((_e869 & 31u))));
                                        } else {
                                            phi_977_ = _e771;
                                        }
                                        let _e877 = phi_977_;
                                        phi_978_ = _e877;
                                    } else {
                                        phi_978_ = _e771;
                                    }
                                    let _e879 = phi_978_;
                                    phi_979_ = _e879;
                                } else {
                                    phi_979_ = _e771;
                                }
                                let _e881 = phi_979_;
                                phi_849_ = (_e769 + 1u);
                                phi_852_ = _e881;
                            } else {
                                phi_849_ = u32();
                                phi_852_ = u32();
                            }
                            let _e884 = phi_849_;
                            let _e886 = phi_852_;
                            continue;
                            continuing {
                                phi_848_ = _e884;
                                phi_851_ = _e886;
                                break if !(_e772);
                            }
                        }
                        let _e890 = nodes.member[(0u + _e500)].links[0u];
                        let _e894 = nodes.member[(0u + _e500)].frame[3u];
                        let _e898 = local_1;
                        if ((_e898 & 4278190080u) == 0u) {
                        } else {
                            let _e902 = local.group_mask;
                            if ((_e902 & 4278190080u) == 0u) {
                            } else {
                                let _e906 = local.len;
                                if (_e906 < 32u) {
                                    let _e909 = local.group;
                                    let _e911 = local.len;
                                    if (_e911 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e911)] = _e909;
                                    let _e917 = local.group_mask;
                                    let _e919 = local.len;
                                    if (_e919 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e919)] = _e917;
                                    let _e926 = local.len;
                                    local.len = (_e926 + 1u);
                                }
                            }
                            local.group = (0u + _e890);
                            let _e930 = local_2;
                            local.group_mask = ((_e930 & 4278190080u) | (_e894 >> bitcast<u32>(24i)));
                        }
                        let _e935 = local_3;
                        phi_1037_ = (_e935 & 16777215u);
                        phi_1040_ = _e502;
                        loop {
                            let _e938 = phi_1037_;
                            let _e940 = phi_1040_;
                            local_6 = _e940;
                            let _e941 = (_e938 == 0u);
                            local_4 = _e941;
                            local_7 = _e941;
                            if _e941 {
                                phi_1038_ = u32();
                                phi_1041_ = bool();
                                phi_1638_ = false;
                            } else {
                                let _e944 = nodes.member[(0u + _e500)].links[1u];
                                let _e949 = ((0u + _e944) + select(firstTrailingBit(_e938), 32u, (_e938 == 0u)));
                                if (_e949 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e956 = triangles.member[(0u + _e949)].v0_;
                                let _e958 = (_e956.x - _e109);
                                let _e960 = (_e956.y - _e111);
                                let _e962 = (_e956.z - _e113);
                                if (_e335 == 0u) {
                                    phi_1085_ = vec3<f32>(_e960, _e962, _e958);
                                } else {
                                    if (_e335 == 1u) {
                                        phi_1084_ = vec3<f32>(_e962, _e958, _e960);
                                    } else {
                                        phi_1084_ = (_e956 - vec3<f32>(_e109, _e111, _e113));
                                    }
                                    let _e970 = phi_1084_;
                                    phi_1085_ = _e970;
                                }
                                let _e972 = phi_1085_;
                                let _e976 = (_e972.x - (_e346 * _e972.z));
                                let _e980 = (_e972.y - (_e349 * _e972.z));
                                let _e982 = triangles.member[(0u + _e949)].v1_;
                                let _e984 = (_e982.x - _e109);
                                let _e986 = (_e982.y - _e111);
                                let _e988 = (_e982.z - _e113);
                                if (_e335 == 0u) {
                                    phi_1115_ = vec3<f32>(_e986, _e988, _e984);
                                } else {
                                    if (_e335 == 1u) {
                                        phi_1114_ = vec3<f32>(_e988, _e984, _e986);
                                    } else {
                                        phi_1114_ = (_e982 - vec3<f32>(_e109, _e111, _e113));
                                    }
                                    let _e996 = phi_1114_;
                                    phi_1115_ = _e996;
                                }
                                let _e998 = phi_1115_;
                                let _e1002 = (_e998.x - (_e346 * _e998.z));
                                let _e1006 = (_e998.y - (_e349 * _e998.z));
                                let _e1008 = triangles.member[(0u + _e949)].v2_;
                                let _e1010 = (_e1008.x - _e109);
                                let _e1012 = (_e1008.y - _e111);
                                let _e1014 = (_e1008.z - _e113);
                                if (_e335 == 0u) {
                                    phi_1145_ = vec3<f32>(_e1012, _e1014, _e1010);
                                } else {
                                    if (_e335 == 1u) {
                                        phi_1144_ = vec3<f32>(_e1014, _e1010, _e1012);
                                    } else {
                                        phi_1144_ = (_e1008 - vec3<f32>(_e109, _e111, _e113));
                                    }
                                    let _e1022 = phi_1144_;
                                    phi_1145_ = _e1022;
                                }
                                let _e1024 = phi_1145_;
                                let _e1028 = (_e1024.x - (_e346 * _e1024.z));
                                let _e1032 = (_e1024.y - (_e349 * _e1024.z));
                                if (_e1002 < _e1028) {
                                    phi_1164_ = true;
                                } else {
                                    if (_e1002 == _e1028) {
                                        phi_1163_ = (_e1006 < _e1032);
                                    } else {
                                        phi_1163_ = false;
                                    }
                                    let _e1037 = phi_1163_;
                                    phi_1164_ = _e1037;
                                }
                                let _e1039 = phi_1164_;
                                if _e1039 {
                                    phi_1168_ = _e1032;
                                    phi_1169_ = _e1028;
                                    phi_1170_ = _e1006;
                                    phi_1171_ = _e1002;
                                } else {
                                    phi_1168_ = _e1006;
                                    phi_1169_ = _e1002;
                                    phi_1170_ = _e1032;
                                    phi_1171_ = _e1028;
                                }
                                let _e1041 = phi_1168_;
                                let _e1043 = phi_1169_;
                                let _e1045 = phi_1170_;
                                let _e1047 = phi_1171_;
                                let _e1050 = ((_e1047 * _e1041) - (_e1045 * _e1043));
                                if _e1039 {
                                    phi_1179_ = -(_e1050);
                                } else {
                                    phi_1179_ = _e1050;
                                }
                                let _e1053 = phi_1179_;
                                if (_e1028 < _e976) {
                                    phi_1190_ = true;
                                } else {
                                    if (_e1028 == _e976) {
                                        phi_1189_ = (_e1032 < _e980);
                                    } else {
                                        phi_1189_ = false;
                                    }
                                    let _e1058 = phi_1189_;
                                    phi_1190_ = _e1058;
                                }
                                let _e1060 = phi_1190_;
                                if _e1060 {
                                    phi_1194_ = _e980;
                                    phi_1195_ = _e976;
                                    phi_1196_ = _e1032;
                                    phi_1197_ = _e1028;
                                } else {
                                    phi_1194_ = _e1032;
                                    phi_1195_ = _e1028;
                                    phi_1196_ = _e980;
                                    phi_1197_ = _e976;
                                }
                                let _e1062 = phi_1194_;
                                let _e1064 = phi_1195_;
                                let _e1066 = phi_1196_;
                                let _e1068 = phi_1197_;
                                let _e1071 = ((_e1068 * _e1062) - (_e1066 * _e1064));
                                if _e1060 {
                                    phi_1205_ = -(_e1071);
                                } else {
                                    phi_1205_ = _e1071;
                                }
                                let _e1074 = phi_1205_;
                                if (_e976 < _e1002) {
                                    phi_1216_ = true;
                                } else {
                                    if (_e976 == _e1002) {
                                        phi_1215_ = (_e980 < _e1006);
                                    } else {
                                        phi_1215_ = false;
                                    }
                                    let _e1079 = phi_1215_;
                                    phi_1216_ = _e1079;
                                }
                                let _e1081 = phi_1216_;
                                if _e1081 {
                                    phi_1220_ = _e1006;
                                    phi_1221_ = _e1002;
                                    phi_1222_ = _e980;
                                    phi_1223_ = _e976;
                                } else {
                                    phi_1220_ = _e980;
                                    phi_1221_ = _e976;
                                    phi_1222_ = _e1006;
                                    phi_1223_ = _e1002;
                                }
                                let _e1083 = phi_1220_;
                                let _e1085 = phi_1221_;
                                let _e1087 = phi_1222_;
                                let _e1089 = phi_1223_;
                                let _e1092 = ((_e1089 * _e1083) - (_e1087 * _e1085));
                                if _e1081 {
                                    phi_1231_ = -(_e1092);
                                } else {
                                    phi_1231_ = _e1092;
                                }
                                let _e1095 = phi_1231_;
                                if (_e1053 >= 0f) {
                                    if (_e1074 >= 0f) {
                                        if (_e1095 >= 0f) {
                                            phi_1246_ = ((_e1053 + _e1074) + _e1095);
                                            phi_1247_ = false;
                                        } else {
                                            phi_1246_ = f32();
                                            phi_1247_ = true;
                                        }
                                        let _e1102 = phi_1246_;
                                        let _e1104 = phi_1247_;
                                        phi_1248_ = _e1102;
                                        phi_1249_ = _e1104;
                                    } else {
                                        phi_1248_ = f32();
                                        phi_1249_ = true;
                                    }
                                    let _e1106 = phi_1248_;
                                    let _e1108 = phi_1249_;
                                    phi_1250_ = _e1106;
                                    phi_1251_ = _e1108;
                                } else {
                                    phi_1250_ = f32();
                                    phi_1251_ = true;
                                }
                                let _e1110 = phi_1250_;
                                let _e1112 = phi_1251_;
                                if _e1112 {
                                    if (_e1053 <= 0f) {
                                        if (_e1074 <= 0f) {
                                            let _e1115 = (_e1095 <= 0f);
                                            if _e1115 {
                                            }
                                            phi_1269_ = ((_e1053 + _e1074) + _e1095);
                                            phi_1270_ = false;
                                            phi_1271_ = _e1115;
                                        } else {
                                            phi_1269_ = f32();
                                            phi_1270_ = true;
                                            phi_1271_ = false;
                                        }
                                        let _e1119 = phi_1269_;
                                        let _e1121 = phi_1270_;
                                        let _e1123 = phi_1271_;
                                        phi_1272_ = _e1119;
                                        phi_1273_ = _e1121;
                                        phi_1274_ = _e1123;
                                    } else {
                                        phi_1272_ = f32();
                                        phi_1273_ = true;
                                        phi_1274_ = false;
                                    }
                                    let _e1125 = phi_1272_;
                                    let _e1127 = phi_1273_;
                                    let _e1129 = phi_1274_;
                                    if _e1127 {
                                        phi_1278_ = false;
                                    } else {
                                        phi_1278_ = _e1129;
                                    }
                                    let _e1131 = phi_1278_;
                                    phi_1279_ = _e1125;
                                    phi_1280_ = _e1131;
                                } else {
                                    phi_1279_ = _e1110;
                                    phi_1280_ = true;
                                }
                                let _e1133 = phi_1279_;
                                let _e1135 = phi_1280_;
                                if _e1135 {
                                    let _e1136 = (_e1133 == 0f);
                                    if _e1136 {
                                        phi_1596_ = lt_bvh_triangle_Intersection();
                                        phi_1597_ = false;
                                    } else {
                                        let _e1138 = triangles.member[(0u + _e949)].v0_;
                                        let _e1140 = (_e1138.x - _e109);
                                        let _e1142 = (_e1138.y - _e111);
                                        let _e1144 = (_e1138.z - _e113);
                                        if (_e335 == 0u) {
                                            phi_1309_ = vec3<f32>(_e1142, _e1144, _e1140);
                                        } else {
                                            if (_e335 == 1u) {
                                                phi_1308_ = vec3<f32>(_e1144, _e1140, _e1142);
                                            } else {
                                                phi_1308_ = (_e1138 - vec3<f32>(_e109, _e111, _e113));
                                            }
                                            let _e1152 = phi_1308_;
                                            phi_1309_ = _e1152;
                                        }
                                        let _e1154 = phi_1309_;
                                        let _e1156 = triangles.member[(0u + _e949)].v1_;
                                        let _e1158 = triangles.member[(0u + _e949)].v0_;
                                        let _e1161 = (_e1156.x - _e1158.x);
                                        let _e1164 = (_e1156.y - _e1158.y);
                                        let _e1167 = (_e1156.z - _e1158.z);
                                        if (_e335 == 0u) {
                                            phi_1335_ = vec3<f32>(_e1164, _e1167, _e1161);
                                        } else {
                                            if (_e335 == 1u) {
                                                phi_1334_ = vec3<f32>(_e1167, _e1161, _e1164);
                                            } else {
                                                phi_1334_ = (_e1156 - _e1158);
                                            }
                                            let _e1174 = phi_1334_;
                                            phi_1335_ = _e1174;
                                        }
                                        let _e1176 = phi_1335_;
                                        let _e1178 = triangles.member[(0u + _e949)].v2_;
                                        let _e1180 = triangles.member[(0u + _e949)].v0_;
                                        let _e1183 = (_e1178.x - _e1180.x);
                                        let _e1186 = (_e1178.y - _e1180.y);
                                        let _e1189 = (_e1178.z - _e1180.z);
                                        if (_e335 == 0u) {
                                            phi_1361_ = vec3<f32>(_e1186, _e1189, _e1183);
                                        } else {
                                            if (_e335 == 1u) {
                                                phi_1360_ = vec3<f32>(_e1189, _e1183, _e1186);
                                            } else {
                                                phi_1360_ = (_e1178 - _e1180);
                                            }
                                            let _e1196 = phi_1360_;
                                            phi_1361_ = _e1196;
                                        }
                                        let _e1198 = phi_1361_;
                                        let _e1205 = ((_e1176.y * _e1198.z) - (_e1176.z * _e1198.y));
                                        let _e1212 = ((_e1176.z * _e1198.x) - (_e1176.x * _e1198.z));
                                        let _e1219 = ((_e1176.x * _e1198.y) - (_e1176.y * _e1198.x));
                                        let _e1233 = (((1f / _e343.z) * (((_e1205 * _e1154.x) + (_e1212 * _e1154.y)) + (_e1219 * _e1154.z))) / (((_e1205 * _e346) + (_e1212 * _e349)) + _e1219));
                                        if (_e1233 > 0f) {
                                            if (_e1233 < _e119) {
                                                let _e1237 = triangles.member[(0u + _e949)].v0_;
                                                let _e1239 = triangles.member[(0u + _e949)].v1_;
                                                if (_e1237.x < _e1239.x) {
                                                    phi_1417_ = _e1237.x;
                                                } else {
                                                    phi_1417_ = _e1239.x;
                                                }
                                                let _e1246 = phi_1417_;
                                                if (_e1237.y < _e1239.y) {
                                                    phi_1426_ = _e1237.y;
                                                } else {
                                                    phi_1426_ = _e1239.y;
                                                }
                                                let _e1253 = phi_1426_;
                                                if (_e1237.z < _e1239.z) {
                                                    phi_1435_ = _e1237.z;
                                                } else {
                                                    phi_1435_ = _e1239.z;
                                                }
                                                let _e1260 = phi_1435_;
                                                let _e1262 = triangles.member[(0u + _e949)].v2_;
                                                if (_e1246 < _e1262.x) {
                                                    phi_1444_ = _e1246;
                                                } else {
                                                    phi_1444_ = _e1262.x;
                                                }
                                                let _e1267 = phi_1444_;
                                                if (_e1253 < _e1262.y) {
                                                    phi_1451_ = _e1253;
                                                } else {
                                                    phi_1451_ = _e1262.y;
                                                }
                                                let _e1272 = phi_1451_;
                                                if (_e1260 < _e1262.z) {
                                                    phi_1458_ = _e1260;
                                                } else {
                                                    phi_1458_ = _e1262.z;
                                                }
                                                let _e1277 = phi_1458_;
                                                let _e1279 = triangles.member[(0u + _e949)].v0_;
                                                let _e1281 = triangles.member[(0u + _e949)].v1_;
                                                if (_e1279.x > _e1281.x) {
                                                    phi_1471_ = _e1279.x;
                                                } else {
                                                    phi_1471_ = _e1281.x;
                                                }
                                                let _e1288 = phi_1471_;
                                                if (_e1279.y > _e1281.y) {
                                                    phi_1480_ = _e1279.y;
                                                } else {
                                                    phi_1480_ = _e1281.y;
                                                }
                                                let _e1295 = phi_1480_;
                                                if (_e1279.z > _e1281.z) {
                                                    phi_1489_ = _e1279.z;
                                                } else {
                                                    phi_1489_ = _e1281.z;
                                                }
                                                let _e1302 = phi_1489_;
                                                let _e1304 = triangles.member[(0u + _e949)].v2_;
                                                if (_e1288 > _e1304.x) {
                                                    phi_1498_ = _e1288;
                                                } else {
                                                    phi_1498_ = _e1304.x;
                                                }
                                                let _e1309 = phi_1498_;
                                                if (_e1295 > _e1304.y) {
                                                    phi_1505_ = _e1295;
                                                } else {
                                                    phi_1505_ = _e1304.y;
                                                }
                                                let _e1314 = phi_1505_;
                                                if (_e1302 > _e1304.z) {
                                                    phi_1512_ = _e1302;
                                                } else {
                                                    phi_1512_ = _e1304.z;
                                                }
                                                let _e1319 = phi_1512_;
                                                let _e1323 = ((_e1267 - _e109) * _e260);
                                                let _e1324 = ((_e1272 - _e111) * _e270);
                                                let _e1325 = ((_e1277 - _e113) * _e280);
                                                let _e1329 = ((_e1309 - _e109) * _e260);
                                                let _e1330 = ((_e1314 - _e111) * _e270);
                                                let _e1331 = ((_e1319 - _e113) * _e280);
                                                if (_e1323 < _e1329) {
                                                    phi_1529_ = _e1323;
                                                } else {
                                                    phi_1529_ = _e1329;
                                                }
                                                let _e1334 = phi_1529_;
                                                if (_e1324 < _e1330) {
                                                    phi_1534_ = _e1324;
                                                } else {
                                                    phi_1534_ = _e1330;
                                                }
                                                let _e1337 = phi_1534_;
                                                if (_e1325 < _e1331) {
                                                    phi_1539_ = _e1325;
                                                } else {
                                                    phi_1539_ = _e1331;
                                                }
                                                let _e1340 = phi_1539_;
                                                if (_e1323 > _e1329) {
                                                    phi_1547_ = _e1323;
                                                } else {
                                                    phi_1547_ = _e1329;
                                                }
                                                let _e1346 = phi_1547_;
                                                if (_e1324 > _e1330) {
                                                    phi_1552_ = _e1324;
                                                } else {
                                                    phi_1552_ = _e1330;
                                                }
                                                let _e1349 = phi_1552_;
                                                if (_e1325 > _e1331) {
                                                    phi_1557_ = _e1325;
                                                } else {
                                                    phi_1557_ = _e1331;
                                                }
                                                let _e1352 = phi_1557_;
                                                let _e1356 = core_intrinsics_maximum_number_nsz_f32_((_e1334 - _e319), (_e1337 - _e320));
                                                let _e1357 = core_intrinsics_maximum_number_nsz_f32_(_e1356, (_e1340 - _e321));
                                                let _e1358 = core_intrinsics_minimum_number_nsz_f32_((_e1346 + _e319), (_e1349 + _e320));
                                                let _e1359 = core_intrinsics_minimum_number_nsz_f32_(_e1358, (_e1352 + _e321));
                                                if (_e1357 > -300000000000000000000000000000000000000f) {
                                                    phi_1569_ = _e1357;
                                                } else {
                                                    phi_1569_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1362 = phi_1569_;
                                                if (_e1359 < 300000000000000000000000000000000000000f) {
                                                    phi_1574_ = _e1359;
                                                } else {
                                                    phi_1574_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1365 = phi_1574_;
                                                if (_e1233 < _e1362) {
                                                    phi_1579_ = _e1362;
                                                } else {
                                                    phi_1579_ = _e1233;
                                                }
                                                let _e1368 = phi_1579_;
                                                if (_e1368 > _e1365) {
                                                    phi_1584_ = _e1365;
                                                } else {
                                                    phi_1584_ = _e1368;
                                                }
                                                let _e1371 = phi_1584_;
                                                phi_1589_ = lt_bvh_triangle_Intersection(_e1371, (_e1074 / _e1133), (_e1095 / _e1133), (_e1362 <= _e1365));
                                                phi_1590_ = false;
                                            } else {
                                                phi_1589_ = lt_bvh_triangle_Intersection();
                                                phi_1590_ = true;
                                            }
                                            let _e1377 = phi_1589_;
                                            let _e1379 = phi_1590_;
                                            phi_1591_ = _e1377;
                                            phi_1592_ = _e1379;
                                        } else {
                                            phi_1591_ = lt_bvh_triangle_Intersection();
                                            phi_1592_ = true;
                                        }
                                        let _e1381 = phi_1591_;
                                        let _e1383 = phi_1592_;
                                        if _e1383 {
                                        }
                                        phi_1596_ = _e1381;
                                        phi_1597_ = _e1383;
                                    }
                                    let _e1385 = phi_1596_;
                                    let _e1387 = phi_1597_;
                                    phi_1598_ = _e1385;
                                    phi_1599_ = _e1136;
                                    phi_1600_ = _e1387;
                                } else {
                                    phi_1598_ = lt_bvh_triangle_Intersection();
                                    phi_1599_ = true;
                                    phi_1600_ = false;
                                }
                                let _e1389 = phi_1598_;
                                let _e1391 = phi_1599_;
                                let _e1393 = phi_1600_;
                                if _e1391 {
                                    phi_1604_ = true;
                                } else {
                                    phi_1604_ = _e1393;
                                }
                                let _e1395 = phi_1604_;
                                if _e1395 {
                                    phi_1608_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1608_ = _e1389;
                                }
                                let _e1397 = phi_1608_;
                                if _e1397.is_hit {
                                    if (_e1397.t > 0f) {
                                        if (_e1397.t < _e119) {
                                            if true {
                                                phi_1628_ = false;
                                            } else {
                                                phi_1628_ = true;
                                            }
                                            let _e1406 = phi_1628_;
                                            phi_1629_ = true;
                                            phi_1630_ = _e1406;
                                        } else {
                                            phi_1629_ = _e940;
                                            phi_1630_ = true;
                                        }
                                        let _e1408 = phi_1629_;
                                        let _e1410 = phi_1630_;
                                        phi_1631_ = _e1408;
                                        phi_1632_ = _e1410;
                                    } else {
                                        phi_1631_ = _e940;
                                        phi_1632_ = true;
                                    }
                                    let _e1412 = phi_1631_;
                                    let _e1414 = phi_1632_;
                                    phi_1633_ = _e1412;
                                    phi_1634_ = _e1414;
                                } else {
                                    phi_1633_ = _e940;
                                    phi_1634_ = true;
                                }
                                let _e1416 = phi_1633_;
                                let _e1418 = phi_1634_;
                                if _e1418 {
                                }
                                phi_1038_ = (_e938 & (_e938 - 1u));
                                phi_1041_ = _e1416;
                                phi_1638_ = _e1418;
                            }
                            let _e1420 = phi_1038_;
                            let _e1422 = phi_1041_;
                            let _e1424 = phi_1638_;
                            continue;
                            continuing {
                                phi_1037_ = _e1420;
                                phi_1040_ = _e1422;
                                break if !(_e1424);
                            }
                        }
                        let _e1427 = local_4;
                        if _e1427 {
                            let _e1429 = local.group_mask;
                            if ((_e1429 & 4278190080u) == 0u) {
                                let _e1433 = local.len;
                                if (_e1433 == 0u) {
                                    phi_1680_ = false;
                                } else {
                                    let _e1437 = local.len;
                                    local.len = (_e1437 - 1u);
                                    let _e1440 = local.len;
                                    if (_e1440 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1445 = local.first[(0u + _e1440)];
                                    local.group = _e1445;
                                    let _e1448 = local.len;
                                    if (_e1448 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1453 = local.mask[(0u + _e1448)];
                                    local.group_mask = _e1453;
                                    phi_1680_ = true;
                                }
                                let _e1456 = phi_1680_;
                                phi_1681_ = _e1456;
                            } else {
                                phi_1681_ = true;
                            }
                            let _e1458 = phi_1681_;
                            if _e1458 {
                                let _e1460 = local.group_mask;
                                let _e1466 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1460)), 32u, (_e1460 == 0u)));
                                let _e1470 = local.group_mask;
                                let _e1484 = local.group_mask;
                                local.group_mask = (_e1484 & ~((1u << bitcast<u32>((_e1466 & 31u)))));
                                let _e1487 = local.group;
                                phi_1712_ = (_e1487 + countOneBits(((_e1470 & ~((4294967295u << bitcast<u32>((((_e1466 - 24u) ^ _e362) & 31u))))) & 255u)));
                            } else {
                                phi_1712_ = 4294967295u;
                            }
                            let _e1490 = phi_1712_;
                            phi_1713_ = _e1490;
                        } else {
                            phi_1713_ = u32();
                        }
                        let _e1492 = phi_1713_;
                        phi_706_ = _e1492;
                        let _e1778 = local_6;
                        phi_709_ = _e1778;
                        let _e1781 = local_7;
                        phi_1714_ = _e1781;
                        phi_1715_ = false;
                    } else {
                        phi_706_ = u32();
                        phi_709_ = bool();
                        phi_1714_ = false;
                        phi_1715_ = true;
                    }
                    let _e1494 = phi_706_;
                    let _e1496 = phi_709_;
                    let _e1498 = phi_1714_;
                    let _e1500 = phi_1715_;
                    local_5 = _e1500;
                    continue;
                    continuing {
                        phi_705_ = _e1494;
                        phi_708_ = _e1496;
                        break if !(_e1498);
                    }
                }
                let _e1503 = local_5;
                if _e1503 {
                    phi_1719_ = false;
                } else {
                    phi_1719_ = true;
                }
                let _e1505 = phi_1719_;
                if _e1505 {
                    phi_1723_ = true;
                } else {
                    let _e1787 = local_8;
                    phi_1723_ = _e1787;
                }
                let _e1507 = phi_1723_;
                phi_1724_ = _e1507;
            }
            let _e1509 = phi_1724_;
            phi_1725_ = _e1509;
            phi_1726_ = _e184;
        } else {
            phi_1725_ = bool();
            phi_1726_ = true;
        }
        let _e1511 = phi_1725_;
        let _e1513 = phi_1726_;
        if _e1513 {
            phi_1730_ = false;
        } else {
            phi_1730_ = _e1511;
        }
        let _e1515 = phi_1730_;
        if _e1515 {
            phi_1734_ = 0f;
        } else {
            phi_1734_ = 1f;
        }
        let _e1517 = phi_1734_;
        if (_e89 < _e69) {
        } else {
            return;
        }
        visibility.member[(0u + _e89)] = _e1517;
        let _e1523 = p.member.light.number;
        let _e1524 = (_e1523 * 3u);
        let _e1525 = (_e1524 / 32u);
        let _e1526 = (_e1524 % 32u);
        let _e1528 = p.member.light.mask_words;
        if (_e89 < _e69) {
        } else {
            return;
        }
        let _e1532 = visibility.member[(0u + _e89)];
        let _e1534 = ((_e89 * _e1528) + _e1525);
        if (_e1526 > 29u) {
            let _e1536 = (_e1534 + 1u);
            if (_e1536 < _e75) {
            } else {
                return;
            }
            let _e1540 = bits.member[(0u + _e1536)];
            phi_1775_ = _e1540;
        } else {
            phi_1775_ = 0u;
        }
        let _e1542 = phi_1775_;
        if (_e1534 < _e75) {
        } else {
            return;
        }
        let _e1546 = bits.member[(0u + _e1534)];
        let _e1549 = (_e1546 >> bitcast<u32>((_e1526 & 31u)));
        if (_e1526 > 29u) {
            phi_1794_ = (_e1549 | (_e1542 << bitcast<u32>(((32u - _e1526) & 31u))));
        } else {
            phi_1794_ = _e1549;
        }
        let _e1557 = phi_1794_;
        if ((_e1557 & 2u) == 0u) {
            phi_1802_ = (_e1557 & 1u);
        } else {
            phi_1802_ = (_e1557 & 7u);
        }
        let _e1563 = phi_1802_;
        if ((_e1563 & 1u) != 0u) {
            phi_1810_ = (2u | 1u);
        } else {
            phi_1810_ = 2u;
        }
        let _e1569 = phi_1810_;
        if (_e1532 < 0.5f) {
            phi_1815_ = (_e1569 | 4u);
        } else {
            phi_1815_ = _e1569;
        }
        let _e1572 = phi_1815_;
        let _e1574 = ((_e89 * _e1528) + _e1525);
        if (_e1574 < _e75) {
        } else {
            return;
        }
        let _e1578 = bits.member[(0u + _e1574)];
        if (_e1574 < _e75) {
        } else {
            return;
        }
        bits.member[(0u + _e1574)] = ((_e1578 & ~((7u << bitcast<u32>((_e1526 & 31u))))) | (_e1572 << bitcast<u32>((_e1526 & 31u))));
        if (_e1526 > 29u) {
            let _e1592 = (_e1574 + 1u);
            if (_e1592 < _e75) {
            } else {
                return;
            }
            let _e1596 = bits.member[(0u + _e1592)];
            let _e1597 = (32u - _e1526);
            let _e1607 = (_e1574 + 1u);
            if (_e1607 < _e75) {
            } else {
                return;
            }
            bits.member[(0u + _e1607)] = ((_e1596 & ~((7u >> bitcast<u32>((_e1597 & 31u))))) | (_e1572 >> bitcast<u32>((_e1597 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
