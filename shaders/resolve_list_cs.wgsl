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

struct type_30 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_35 {
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

struct type_39 {
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
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> nodes: type_35;
@group(0) @binding(3) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage> list: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_146_: bool;
    var phi_150_: f32;

    if (param != param) {
        phi_146_ = true;
    } else {
        let _e52 = (param_1 >= param);
        if _e52 {
        }
        phi_146_ = _e52;
    }
    let _e54 = phi_146_;
    if _e54 {
        phi_150_ = param_1;
    } else {
        phi_150_ = param;
    }
    let _e56 = phi_150_;
    return _e56;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_162_: bool;
    var phi_166_: f32;

    if (param_2 != param_2) {
        phi_162_ = true;
    } else {
        let _e52 = (param_3 <= param_2);
        if _e52 {
        }
        phi_162_ = _e52;
    }
    let _e54 = phi_162_;
    if _e54 {
        phi_166_ = param_3;
    } else {
        phi_166_ = param_2;
    }
    let _e56 = phi_166_;
    return _e56;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_241_: f32;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
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
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_323_: bool;
    var phi_327_: bool;
    var phi_397_: f32;
    var phi_404_: f32;
    var phi_411_: f32;
    var phi_418_: f32;
    var phi_425_: f32;
    var phi_432_: f32;
    var phi_449_: f32;
    var phi_454_: f32;
    var phi_459_: f32;
    var phi_487_: bool;
    var phi_488_: bool;
    var phi_496_: u32;
    var phi_497_: u32;
    var phi_508_: vec3<f32>;
    var phi_509_: vec3<f32>;
    var phi_522_: u32;
    var phi_527_: u32;
    var phi_532_: u32;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_678_: u32;
    var phi_680_: u32;
    var phi_683_: bool;
    var phi_763_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_790_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_817_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_823_: u32;
    var phi_826_: u32;
    var phi_840_: u32;
    var phi_850_: u32;
    var phi_860_: u32;
    var phi_878_: u32;
    var phi_888_: u32;
    var phi_898_: u32;
    var phi_934_: u32;
    var phi_947_: u32;
    var phi_952_: u32;
    var phi_953_: u32;
    var phi_954_: u32;
    var phi_824_: u32;
    var phi_827_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1012_: u32;
    var phi_1015_: bool;
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
    var phi_1603_: bool;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1013_: u32;
    var phi_1016_: bool;
    var phi_1613_: bool;
    var local_4: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1687_: u32;
    var phi_1688_: u32;
    var phi_681_: u32;
    var phi_684_: bool;
    var phi_1689_: bool;
    var phi_1690_: bool;
    var local_5: bool;
    var phi_1694_: bool;
    var phi_1698_: bool;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1705_: bool;
    var phi_1709_: f32;
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
        let _e85 = samples.member[(0u + _e79)].position;
        let _e87 = samples.member[(0u + _e79)].normal;
        let _e89 = samples.member[(0u + _e79)].magnitude;
        let _e91 = ((8f / 8388608f) * _e89);
        let _e99 = (_e85.x + (_e87.x * _e91));
        let _e101 = (_e85.y + (_e87.y * _e91));
        let _e103 = (_e85.z + (_e87.z * _e91));
        let _e105 = p.member.light.place;
        if (_e105.w == 0f) {
            phi_241_ = 300000000000000000000000000000000000000f;
        } else {
            phi_241_ = 1f;
        }
        let _e109 = phi_241_;
        let _e117 = (_e105.x - (_e99 * _e105.w));
        let _e118 = (_e105.y - (_e101 * _e105.w));
        let _e119 = (_e105.z - (_e103 * _e105.w));
        let _e124 = abs(_e117);
        let _e125 = abs(_e118);
        let _e126 = abs(_e119);
        if (abs(_e99) < 1000000000000000f) {
            if (abs(_e101) < 1000000000000000f) {
                if (abs(_e103) < 1000000000000000f) {
                    if (_e124 < 1000000000000000f) {
                        if (_e125 < 1000000000000000f) {
                            if (_e126 < 1000000000000000f) {
                                if (_e124 > 0f) {
                                    phi_297_ = bool();
                                    phi_298_ = true;
                                } else {
                                    let _e134 = (_e125 > 0f);
                                    if _e134 {
                                        phi_296_ = bool();
                                    } else {
                                        phi_296_ = (_e126 > 0f);
                                    }
                                    let _e137 = phi_296_;
                                    phi_297_ = _e137;
                                    phi_298_ = _e134;
                                }
                                let _e139 = phi_297_;
                                let _e141 = phi_298_;
                                if _e141 {
                                    phi_302_ = true;
                                } else {
                                    phi_302_ = _e139;
                                }
                                let _e143 = phi_302_;
                                phi_303_ = _e143;
                                phi_304_ = false;
                            } else {
                                phi_303_ = bool();
                                phi_304_ = true;
                            }
                            let _e145 = phi_303_;
                            let _e147 = phi_304_;
                            phi_305_ = _e145;
                            phi_306_ = false;
                            phi_307_ = _e147;
                        } else {
                            phi_305_ = bool();
                            phi_306_ = true;
                            phi_307_ = false;
                        }
                        let _e149 = phi_305_;
                        let _e151 = phi_306_;
                        let _e153 = phi_307_;
                        phi_308_ = _e149;
                        phi_309_ = _e151;
                        phi_310_ = _e153;
                    } else {
                        phi_308_ = bool();
                        phi_309_ = true;
                        phi_310_ = false;
                    }
                    let _e155 = phi_308_;
                    let _e157 = phi_309_;
                    let _e159 = phi_310_;
                    phi_311_ = _e155;
                    phi_312_ = _e157;
                    phi_313_ = _e159;
                } else {
                    phi_311_ = bool();
                    phi_312_ = true;
                    phi_313_ = false;
                }
                let _e161 = phi_311_;
                let _e163 = phi_312_;
                let _e165 = phi_313_;
                phi_314_ = _e161;
                phi_315_ = _e163;
                phi_316_ = _e165;
            } else {
                phi_314_ = bool();
                phi_315_ = true;
                phi_316_ = false;
            }
            let _e167 = phi_314_;
            let _e169 = phi_315_;
            let _e171 = phi_316_;
            phi_317_ = _e167;
            phi_318_ = _e169;
            phi_319_ = _e171;
        } else {
            phi_317_ = bool();
            phi_318_ = true;
            phi_319_ = false;
        }
        let _e173 = phi_317_;
        let _e175 = phi_318_;
        let _e177 = phi_319_;
        if _e175 {
            phi_323_ = true;
        } else {
            phi_323_ = _e177;
        }
        let _e179 = phi_323_;
        if _e179 {
            phi_327_ = false;
        } else {
            phi_327_ = _e173;
        }
        let _e181 = phi_327_;
        if _e181 {
            let _e182 = (0u >= _e57);
            if _e182 {
                phi_1699_ = bool();
            } else {
                if (0u < _e57) {
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
                let _e246 = core_intrinsics_maximum_number_nsz_f32_(abs(_e117), abs(_e118));
                let _e247 = core_intrinsics_maximum_number_nsz_f32_(_e246, abs(_e119));
                let _e248 = (_e247 * 0.0000000000009094947f);
                if (abs(_e117) < _e248) {
                    phi_397_ = _e248;
                } else {
                    phi_397_ = abs(_e117);
                }
                let _e253 = phi_397_;
                if (_e117 < 0f) {
                    phi_404_ = (-1f / _e253);
                } else {
                    phi_404_ = (1f / _e253);
                }
                let _e258 = phi_404_;
                if (abs(_e118) < _e248) {
                    phi_411_ = _e248;
                } else {
                    phi_411_ = abs(_e118);
                }
                let _e263 = phi_411_;
                if (_e118 < 0f) {
                    phi_418_ = (-1f / _e263);
                } else {
                    phi_418_ = (1f / _e263);
                }
                let _e268 = phi_418_;
                if (abs(_e119) < _e248) {
                    phi_425_ = _e248;
                } else {
                    phi_425_ = abs(_e119);
                }
                let _e273 = phi_425_;
                if (_e119 < 0f) {
                    phi_432_ = (-1f / _e273);
                } else {
                    phi_432_ = (1f / _e273);
                }
                let _e278 = phi_432_;
                let _e282 = abs((bitcast<f32>(_e188) - _e99));
                let _e283 = abs((bitcast<f32>(_e192) - _e101));
                let _e284 = abs((bitcast<f32>(_e196) - _e103));
                let _e288 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e212 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e99));
                let _e289 = abs(((bitcast<f32>(_e204) + (bitcast<f32>((((_e212 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e101));
                let _e290 = abs(((bitcast<f32>(_e208) + (bitcast<f32>((((_e212 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e103));
                if (_e282 > _e288) {
                    phi_449_ = _e282;
                } else {
                    phi_449_ = _e288;
                }
                let _e293 = phi_449_;
                if (_e283 > _e289) {
                    phi_454_ = _e283;
                } else {
                    phi_454_ = _e289;
                }
                let _e296 = phi_454_;
                if (_e284 > _e290) {
                    phi_459_ = _e284;
                } else {
                    phi_459_ = _e290;
                }
                let _e299 = phi_459_;
                let _e300 = core_intrinsics_maximum_number_nsz_f32_(_e293, _e296);
                let _e301 = core_intrinsics_maximum_number_nsz_f32_(_e300, _e299);
                let _e305 = (_e301 * 0.0000019073486f);
                let _e306 = (abs(_e258) * _e305);
                let _e307 = (abs(_e268) * _e305);
                let _e308 = (abs(_e278) * _e305);
                let _e312 = (_e301 * 0.0000009536743f);
                let _e313 = (abs(_e258) * _e312);
                let _e314 = (abs(_e268) * _e312);
                let _e315 = (abs(_e278) * _e312);
                let _e316 = abs(_e117);
                let _e317 = abs(_e118);
                let _e318 = abs(_e119);
                if (_e316 >= _e317) {
                    if (_e316 >= _e318) {
                        phi_487_ = false;
                    } else {
                        phi_487_ = true;
                    }
                    let _e322 = phi_487_;
                    phi_488_ = _e322;
                } else {
                    phi_488_ = true;
                }
                let _e324 = phi_488_;
                if _e324 {
                    if (_e317 >= _e318) {
                        phi_496_ = 1u;
                    } else {
                        phi_496_ = 2u;
                    }
                    let _e327 = phi_496_;
                    phi_497_ = _e327;
                } else {
                    phi_497_ = 0u;
                }
                let _e329 = phi_497_;
                if (_e329 == 0u) {
                    phi_509_ = vec3<f32>(_e118, _e119, _e117);
                } else {
                    if (_e329 == 1u) {
                        phi_508_ = vec3<f32>(_e119, _e117, _e118);
                    } else {
                        phi_508_ = vec3<f32>(_e117, _e118, _e119);
                    }
                    let _e335 = phi_508_;
                    phi_509_ = _e335;
                }
                let _e337 = phi_509_;
                let _e340 = (_e337.x / _e337.z);
                let _e343 = (_e337.y / _e337.z);
                if (_e258 < 0f) {
                    phi_522_ = 0u;
                } else {
                    phi_522_ = 1u;
                }
                let _e348 = phi_522_;
                if (_e268 < 0f) {
                    phi_527_ = 0u;
                } else {
                    phi_527_ = 2u;
                }
                let _e351 = phi_527_;
                if (_e278 < 0f) {
                    phi_532_ = 0u;
                } else {
                    phi_532_ = 4u;
                }
                let _e354 = phi_532_;
                let _e356 = ((_e348 | _e351) | _e354);
                let _e357 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e357.first[0], _e357.first[1], _e357.first[2], _e357.first[3], _e357.first[4], _e357.first[5], _e357.first[6], _e357.first[7], _e357.first[8], _e357.first[9], _e357.first[10], _e357.first[11], _e357.first[12], _e357.first[13], _e357.first[14], _e357.first[15], _e357.first[16], _e357.first[17], _e357.first[18], _e357.first[19], _e357.first[20], _e357.first[21], _e357.first[22], _e357.first[23], _e357.first[24], _e357.first[25], _e357.first[26], _e357.first[27], _e357.first[28], _e357.first[29], _e357.first[30], _e357.first[31]), array<u32, 32>(_e357.mask[0], _e357.mask[1], _e357.mask[2], _e357.mask[3], _e357.mask[4], _e357.mask[5], _e357.mask[6], _e357.mask[7], _e357.mask[8], _e357.mask[9], _e357.mask[10], _e357.mask[11], _e357.mask[12], _e357.mask[13], _e357.mask[14], _e357.mask[15], _e357.mask[16], _e357.mask[17], _e357.mask[18], _e357.mask[19], _e357.mask[20], _e357.mask[21], _e357.mask[22], _e357.mask[23], _e357.mask[24], _e357.mask[25], _e357.mask[26], _e357.mask[27], _e357.mask[28], _e357.mask[29], _e357.mask[30], _e357.mask[31]), _e357.len, _e357.group, _e357.group_mask);
                let _e431 = local.group_mask;
                if ((_e431 & 4278190080u) == 0u) {
                    let _e435 = local.len;
                    if (_e435 == 0u) {
                        phi_646_ = false;
                    } else {
                        let _e439 = local.len;
                        local.len = (_e439 - 1u);
                        let _e442 = local.len;
                        if (_e442 < 32u) {
                        } else {
                            return;
                        }
                        let _e447 = local.first[(0u + _e442)];
                        local.group = _e447;
                        let _e450 = local.len;
                        if (_e450 < 32u) {
                        } else {
                            return;
                        }
                        let _e455 = local.mask[(0u + _e450)];
                        local.group_mask = _e455;
                        phi_646_ = true;
                    }
                    let _e458 = phi_646_;
                    phi_647_ = _e458;
                } else {
                    phi_647_ = true;
                }
                let _e460 = phi_647_;
                if _e460 {
                    let _e462 = local.group_mask;
                    let _e468 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e462)), 32u, (_e462 == 0u)));
                    let _e472 = local.group_mask;
                    let _e486 = local.group_mask;
                    local.group_mask = (_e486 & ~((1u << bitcast<u32>((_e468 & 31u)))));
                    let _e489 = local.group;
                    phi_678_ = (_e489 + countOneBits(((_e472 & ~((4294967295u << bitcast<u32>((((_e468 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_678_ = 4294967295u;
                }
                let _e492 = phi_678_;
                phi_680_ = _e492;
                phi_683_ = false;
                loop {
                    let _e494 = phi_680_;
                    let _e496 = phi_683_;
                    local_8 = _e496;
                    if (_e494 != 4294967295u) {
                        if (_e494 < _e57) {
                        } else {
                            return;
                        }
                        let _e503 = nodes.member[(0u + _e494)].frame[3u];
                        let _e528 = (bitcast<f32>((((_e503 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e258);
                        let _e529 = (bitcast<f32>((((_e503 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e268);
                        let _e530 = (bitcast<f32>((((_e503 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e278);
                        let _e533 = nodes.member[(0u + _e494)].frame[0u];
                        let _e537 = nodes.member[(0u + _e494)].frame[1u];
                        let _e541 = nodes.member[(0u + _e494)].frame[2u];
                        let _e546 = ((bitcast<f32>(_e533) - _e99) * _e258);
                        let _e547 = ((bitcast<f32>(_e537) - _e101) * _e268);
                        let _e548 = ((bitcast<f32>(_e541) - _e103) * _e278);
                        let _e556 = nodes.member[(0u + _e494)].x;
                        if (_e258 < 0f) {
                            let _e567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e556.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e567.unnamed.word, _e556.w), _e567.unnamed_1);
                            let _e579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e573.unnamed, lt_mask_LightPlace(_e556.x, _e573.unnamed_1.shift));
                            phi_763_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e579.unnamed, lt_mask_LightPlace(_e579.unnamed_1.word, _e556.y));
                        } else {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e556.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e595.unnamed.word, _e556.y), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_mask_LightPlace(_e556.z, _e601.unnamed_1.shift));
                            phi_763_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_mask_LightPlace(_e607.unnamed_1.word, _e556.w));
                        }
                        let _e615 = phi_763_;
                        let _e625 = nodes.member[(0u + _e494)].y;
                        if (_e268 < 0f) {
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e625.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e636.unnamed.word, _e625.w), _e636.unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e642.unnamed, lt_mask_LightPlace(_e625.x, _e642.unnamed_1.shift));
                            phi_790_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_mask_LightPlace(_e648.unnamed_1.word, _e625.y));
                        } else {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e625.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e664.unnamed.word, _e625.y), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_mask_LightPlace(_e625.z, _e670.unnamed_1.shift));
                            phi_790_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_mask_LightPlace(_e676.unnamed_1.word, _e625.w));
                        }
                        let _e684 = phi_790_;
                        let _e694 = nodes.member[(0u + _e494)].z;
                        if (_e278 < 0f) {
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e694.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e705.unnamed.word, _e694.w), _e705.unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_mask_LightPlace(_e694.x, _e711.unnamed_1.shift));
                            phi_817_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_mask_LightPlace(_e717.unnamed_1.word, _e694.y));
                        } else {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e694.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e733.unnamed.word, _e694.y), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_mask_LightPlace(_e694.z, _e739.unnamed_1.shift));
                            phi_817_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_mask_LightPlace(_e745.unnamed_1.word, _e694.w));
                        }
                        let _e753 = phi_817_;
                        phi_823_ = 0u;
                        phi_826_ = 0u;
                        loop {
                            let _e763 = phi_823_;
                            let _e765 = phi_826_;
                            local_1 = _e765;
                            local_2 = _e765;
                            local_3 = _e765;
                            let _e766 = (_e763 < 8u);
                            if _e766 {
                                let _e768 = (_e763 >> bitcast<u32>(2i));
                                let _e769 = (_e763 & 3u);
                                if (_e768 == 0u) {
                                    phi_840_ = _e615.unnamed.word;
                                } else {
                                    phi_840_ = _e615.unnamed.shift;
                                }
                                let _e772 = phi_840_;
                                if (_e768 == 0u) {
                                    phi_850_ = _e684.unnamed.word;
                                } else {
                                    phi_850_ = _e684.unnamed.shift;
                                }
                                let _e781 = phi_850_;
                                if (_e768 == 0u) {
                                    phi_860_ = _e753.unnamed.word;
                                } else {
                                    phi_860_ = _e753.unnamed.shift;
                                }
                                let _e790 = phi_860_;
                                let _e803 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e772 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e306)), ((f32(((_e781 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e529) + (_e547 - _e307)));
                                let _e804 = core_intrinsics_maximum_number_nsz_f32_(_e803, ((f32(((_e790 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e530) + (_e548 - _e308)));
                                if (_e768 == 0u) {
                                    phi_878_ = _e615.unnamed_1.word;
                                } else {
                                    phi_878_ = _e615.unnamed_1.shift;
                                }
                                let _e807 = phi_878_;
                                if (_e768 == 0u) {
                                    phi_888_ = _e684.unnamed_1.word;
                                } else {
                                    phi_888_ = _e684.unnamed_1.shift;
                                }
                                let _e816 = phi_888_;
                                if (_e768 == 0u) {
                                    phi_898_ = _e753.unnamed_1.word;
                                } else {
                                    phi_898_ = _e753.unnamed_1.shift;
                                }
                                let _e825 = phi_898_;
                                let _e838 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e807 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e306)), ((f32(((_e816 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e529) + (_e547 + _e307)));
                                let _e839 = core_intrinsics_minimum_number_nsz_f32_(_e838, ((f32(((_e825 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e530) + (_e548 + _e308)));
                                if (_e804 <= _e839) {
                                    if (_e804 <= _e109) {
                                        if (_e839 >= 0f) {
                                            if (_e768 == 0u) {
                                                let _e846 = nodes.member[(0u + _e494)].links[2u];
                                                phi_934_ = _e846;
                                            } else {
                                                let _e849 = nodes.member[(0u + _e494)].links[3u];
                                                phi_934_ = _e849;
                                            }
                                            let _e851 = phi_934_;
                                            let _e856 = ((_e851 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u);
                                            let _e857 = (_e856 & 31u);
                                            if (_e857 >= 24u) {
                                                phi_947_ = (24u + ((_e857 - 24u) ^ _e356));
                                            } else {
                                                phi_947_ = _e857;
                                            }
                                            let _e863 = phi_947_;
                                            phi_952_ = (_e765 | ((_e856 >> bitcast<u32>(5i)) << bitcast<u32>((_e863 & 31u))));
                                        } else {
                                            phi_952_ = _e765;
                                        }
                                        let _e871 = phi_952_;
                                        phi_953_ = _e871;
                                    } else {
                                        phi_953_ = _e765;
                                    }
                                    let _e873 = phi_953_;
                                    phi_954_ = _e873;
                                } else {
                                    phi_954_ = _e765;
                                }
                                let _e875 = phi_954_;
                                phi_824_ = (_e763 + 1u);
                                phi_827_ = _e875;
                            } else {
                                phi_824_ = u32();
                                phi_827_ = u32();
                            }
                            let _e878 = phi_824_;
                            let _e880 = phi_827_;
                            continue;
                            continuing {
                                phi_823_ = _e878;
                                phi_826_ = _e880;
                                break if !(_e766);
                            }
                        }
                        let _e884 = nodes.member[(0u + _e494)].links[0u];
                        let _e888 = nodes.member[(0u + _e494)].frame[3u];
                        let _e892 = local_1;
                        if ((_e892 & 4278190080u) == 0u) {
                        } else {
                            let _e896 = local.group_mask;
                            if ((_e896 & 4278190080u) == 0u) {
                            } else {
                                let _e900 = local.len;
                                if (_e900 < 32u) {
                                    let _e903 = local.group;
                                    let _e905 = local.len;
                                    if (_e905 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e905)] = _e903;
                                    let _e911 = local.group_mask;
                                    let _e913 = local.len;
                                    if (_e913 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e913)] = _e911;
                                    let _e920 = local.len;
                                    local.len = (_e920 + 1u);
                                }
                            }
                            local.group = (0u + _e884);
                            let _e924 = local_2;
                            local.group_mask = ((_e924 & 4278190080u) | (_e888 >> bitcast<u32>(24i)));
                        }
                        let _e929 = local_3;
                        phi_1012_ = (_e929 & 16777215u);
                        phi_1015_ = _e496;
                        loop {
                            let _e932 = phi_1012_;
                            let _e934 = phi_1015_;
                            local_6 = _e934;
                            let _e935 = (_e932 == 0u);
                            local_4 = _e935;
                            local_7 = _e935;
                            if _e935 {
                                phi_1013_ = u32();
                                phi_1016_ = bool();
                                phi_1613_ = false;
                            } else {
                                let _e938 = nodes.member[(0u + _e494)].links[1u];
                                let _e943 = ((0u + _e938) + select(firstTrailingBit(_e932), 32u, (_e932 == 0u)));
                                if (_e943 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e950 = triangles.member[(0u + _e943)].v0_;
                                let _e952 = (_e950.x - _e99);
                                let _e954 = (_e950.y - _e101);
                                let _e956 = (_e950.z - _e103);
                                if (_e329 == 0u) {
                                    phi_1060_ = vec3<f32>(_e954, _e956, _e952);
                                } else {
                                    if (_e329 == 1u) {
                                        phi_1059_ = vec3<f32>(_e956, _e952, _e954);
                                    } else {
                                        phi_1059_ = (_e950 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e964 = phi_1059_;
                                    phi_1060_ = _e964;
                                }
                                let _e966 = phi_1060_;
                                let _e970 = (_e966.x - (_e340 * _e966.z));
                                let _e974 = (_e966.y - (_e343 * _e966.z));
                                let _e976 = triangles.member[(0u + _e943)].v1_;
                                let _e978 = (_e976.x - _e99);
                                let _e980 = (_e976.y - _e101);
                                let _e982 = (_e976.z - _e103);
                                if (_e329 == 0u) {
                                    phi_1090_ = vec3<f32>(_e980, _e982, _e978);
                                } else {
                                    if (_e329 == 1u) {
                                        phi_1089_ = vec3<f32>(_e982, _e978, _e980);
                                    } else {
                                        phi_1089_ = (_e976 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e990 = phi_1089_;
                                    phi_1090_ = _e990;
                                }
                                let _e992 = phi_1090_;
                                let _e996 = (_e992.x - (_e340 * _e992.z));
                                let _e1000 = (_e992.y - (_e343 * _e992.z));
                                let _e1002 = triangles.member[(0u + _e943)].v2_;
                                let _e1004 = (_e1002.x - _e99);
                                let _e1006 = (_e1002.y - _e101);
                                let _e1008 = (_e1002.z - _e103);
                                if (_e329 == 0u) {
                                    phi_1120_ = vec3<f32>(_e1006, _e1008, _e1004);
                                } else {
                                    if (_e329 == 1u) {
                                        phi_1119_ = vec3<f32>(_e1008, _e1004, _e1006);
                                    } else {
                                        phi_1119_ = (_e1002 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e1016 = phi_1119_;
                                    phi_1120_ = _e1016;
                                }
                                let _e1018 = phi_1120_;
                                let _e1022 = (_e1018.x - (_e340 * _e1018.z));
                                let _e1026 = (_e1018.y - (_e343 * _e1018.z));
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
                                        let _e1134 = (_e1132.x - _e99);
                                        let _e1136 = (_e1132.y - _e101);
                                        let _e1138 = (_e1132.z - _e103);
                                        if (_e329 == 0u) {
                                            phi_1284_ = vec3<f32>(_e1136, _e1138, _e1134);
                                        } else {
                                            if (_e329 == 1u) {
                                                phi_1283_ = vec3<f32>(_e1138, _e1134, _e1136);
                                            } else {
                                                phi_1283_ = (_e1132 - vec3<f32>(_e99, _e101, _e103));
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
                                        if (_e329 == 0u) {
                                            phi_1310_ = vec3<f32>(_e1158, _e1161, _e1155);
                                        } else {
                                            if (_e329 == 1u) {
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
                                        if (_e329 == 0u) {
                                            phi_1336_ = vec3<f32>(_e1180, _e1183, _e1177);
                                        } else {
                                            if (_e329 == 1u) {
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
                                        let _e1227 = (((1f / _e337.z) * (((_e1199 * _e1148.x) + (_e1206 * _e1148.y)) + (_e1213 * _e1148.z))) / (((_e1199 * _e340) + (_e1206 * _e343)) + _e1213));
                                        if (_e1227 > 0f) {
                                            if (_e1227 < _e109) {
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
                                                let _e1317 = ((_e1261 - _e99) * _e258);
                                                let _e1318 = ((_e1266 - _e101) * _e268);
                                                let _e1319 = ((_e1271 - _e103) * _e278);
                                                let _e1323 = ((_e1303 - _e99) * _e258);
                                                let _e1324 = ((_e1308 - _e101) * _e268);
                                                let _e1325 = ((_e1313 - _e103) * _e278);
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
                                                let _e1350 = core_intrinsics_maximum_number_nsz_f32_((_e1328 - _e313), (_e1331 - _e314));
                                                let _e1351 = core_intrinsics_maximum_number_nsz_f32_(_e1350, (_e1334 - _e315));
                                                let _e1352 = core_intrinsics_minimum_number_nsz_f32_((_e1340 + _e313), (_e1343 + _e314));
                                                let _e1353 = core_intrinsics_minimum_number_nsz_f32_(_e1352, (_e1346 + _e315));
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
                                        if (_e1391.t < _e109) {
                                            if true {
                                                phi_1603_ = false;
                                            } else {
                                                phi_1603_ = true;
                                            }
                                            let _e1400 = phi_1603_;
                                            phi_1604_ = true;
                                            phi_1605_ = _e1400;
                                        } else {
                                            phi_1604_ = _e934;
                                            phi_1605_ = true;
                                        }
                                        let _e1402 = phi_1604_;
                                        let _e1404 = phi_1605_;
                                        phi_1606_ = _e1402;
                                        phi_1607_ = _e1404;
                                    } else {
                                        phi_1606_ = _e934;
                                        phi_1607_ = true;
                                    }
                                    let _e1406 = phi_1606_;
                                    let _e1408 = phi_1607_;
                                    phi_1608_ = _e1406;
                                    phi_1609_ = _e1408;
                                } else {
                                    phi_1608_ = _e934;
                                    phi_1609_ = true;
                                }
                                let _e1410 = phi_1608_;
                                let _e1412 = phi_1609_;
                                if _e1412 {
                                }
                                phi_1013_ = (_e932 & (_e932 - 1u));
                                phi_1016_ = _e1410;
                                phi_1613_ = _e1412;
                            }
                            let _e1414 = phi_1013_;
                            let _e1416 = phi_1016_;
                            let _e1418 = phi_1613_;
                            continue;
                            continuing {
                                phi_1012_ = _e1414;
                                phi_1015_ = _e1416;
                                break if !(_e1418);
                            }
                        }
                        let _e1421 = local_4;
                        if _e1421 {
                            let _e1423 = local.group_mask;
                            if ((_e1423 & 4278190080u) == 0u) {
                                let _e1427 = local.len;
                                if (_e1427 == 0u) {
                                    phi_1655_ = false;
                                } else {
                                    let _e1431 = local.len;
                                    local.len = (_e1431 - 1u);
                                    let _e1434 = local.len;
                                    if (_e1434 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1439 = local.first[(0u + _e1434)];
                                    local.group = _e1439;
                                    let _e1442 = local.len;
                                    if (_e1442 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1447 = local.mask[(0u + _e1442)];
                                    local.group_mask = _e1447;
                                    phi_1655_ = true;
                                }
                                let _e1450 = phi_1655_;
                                phi_1656_ = _e1450;
                            } else {
                                phi_1656_ = true;
                            }
                            let _e1452 = phi_1656_;
                            if _e1452 {
                                let _e1454 = local.group_mask;
                                let _e1460 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1454)), 32u, (_e1454 == 0u)));
                                let _e1464 = local.group_mask;
                                let _e1478 = local.group_mask;
                                local.group_mask = (_e1478 & ~((1u << bitcast<u32>((_e1460 & 31u)))));
                                let _e1481 = local.group;
                                phi_1687_ = (_e1481 + countOneBits(((_e1464 & ~((4294967295u << bitcast<u32>((((_e1460 - 24u) ^ _e356) & 31u))))) & 255u)));
                            } else {
                                phi_1687_ = 4294967295u;
                            }
                            let _e1484 = phi_1687_;
                            phi_1688_ = _e1484;
                        } else {
                            phi_1688_ = u32();
                        }
                        let _e1486 = phi_1688_;
                        phi_681_ = _e1486;
                        let _e1684 = local_6;
                        phi_684_ = _e1684;
                        let _e1687 = local_7;
                        phi_1689_ = _e1687;
                        phi_1690_ = false;
                    } else {
                        phi_681_ = u32();
                        phi_684_ = bool();
                        phi_1689_ = false;
                        phi_1690_ = true;
                    }
                    let _e1488 = phi_681_;
                    let _e1490 = phi_684_;
                    let _e1492 = phi_1689_;
                    let _e1494 = phi_1690_;
                    local_5 = _e1494;
                    continue;
                    continuing {
                        phi_680_ = _e1488;
                        phi_683_ = _e1490;
                        break if !(_e1492);
                    }
                }
                let _e1497 = local_5;
                if _e1497 {
                    phi_1694_ = false;
                } else {
                    phi_1694_ = true;
                }
                let _e1499 = phi_1694_;
                if _e1499 {
                    phi_1698_ = true;
                } else {
                    let _e1693 = local_8;
                    phi_1698_ = _e1693;
                }
                let _e1501 = phi_1698_;
                phi_1699_ = _e1501;
            }
            let _e1503 = phi_1699_;
            phi_1700_ = _e1503;
            phi_1701_ = _e182;
        } else {
            phi_1700_ = bool();
            phi_1701_ = true;
        }
        let _e1505 = phi_1700_;
        let _e1507 = phi_1701_;
        if _e1507 {
            phi_1705_ = false;
        } else {
            phi_1705_ = _e1505;
        }
        let _e1509 = phi_1705_;
        if _e1509 {
            phi_1709_ = 0f;
        } else {
            phi_1709_ = 1f;
        }
        let _e1511 = phi_1709_;
        if (_e79 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79)] = _e1511;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
