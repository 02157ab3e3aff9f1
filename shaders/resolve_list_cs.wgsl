struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
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

struct type_29 {
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

struct type_38 {
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
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_44 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_44;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_29;
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
    var phi_761_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_788_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_815_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_821_: u32;
    var phi_824_: u32;
    var phi_838_: u32;
    var phi_848_: u32;
    var phi_858_: u32;
    var phi_876_: u32;
    var phi_886_: u32;
    var phi_896_: u32;
    var phi_932_: u32;
    var phi_945_: u32;
    var phi_950_: u32;
    var phi_951_: u32;
    var phi_952_: u32;
    var phi_822_: u32;
    var phi_825_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1010_: u32;
    var phi_1055_: vec3<f32>;
    var phi_1056_: vec3<f32>;
    var phi_1085_: vec3<f32>;
    var phi_1086_: vec3<f32>;
    var phi_1115_: vec3<f32>;
    var phi_1116_: vec3<f32>;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1139_: f32;
    var phi_1140_: f32;
    var phi_1141_: f32;
    var phi_1142_: f32;
    var phi_1150_: f32;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1165_: f32;
    var phi_1166_: f32;
    var phi_1167_: f32;
    var phi_1168_: f32;
    var phi_1176_: f32;
    var phi_1186_: bool;
    var phi_1187_: bool;
    var phi_1191_: f32;
    var phi_1192_: f32;
    var phi_1193_: f32;
    var phi_1194_: f32;
    var phi_1202_: f32;
    var phi_1217_: f32;
    var phi_1218_: bool;
    var phi_1219_: f32;
    var phi_1220_: bool;
    var phi_1221_: f32;
    var phi_1222_: bool;
    var phi_1240_: f32;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1243_: f32;
    var phi_1244_: bool;
    var phi_1245_: bool;
    var phi_1249_: bool;
    var phi_1250_: f32;
    var phi_1251_: bool;
    var phi_1279_: vec3<f32>;
    var phi_1280_: vec3<f32>;
    var phi_1305_: vec3<f32>;
    var phi_1306_: vec3<f32>;
    var phi_1331_: vec3<f32>;
    var phi_1332_: vec3<f32>;
    var phi_1388_: f32;
    var phi_1397_: f32;
    var phi_1406_: f32;
    var phi_1415_: f32;
    var phi_1422_: f32;
    var phi_1429_: f32;
    var phi_1442_: f32;
    var phi_1451_: f32;
    var phi_1460_: f32;
    var phi_1469_: f32;
    var phi_1476_: f32;
    var phi_1483_: f32;
    var phi_1500_: f32;
    var phi_1505_: f32;
    var phi_1510_: f32;
    var phi_1518_: f32;
    var phi_1523_: f32;
    var phi_1528_: f32;
    var phi_1540_: f32;
    var phi_1545_: f32;
    var phi_1550_: f32;
    var phi_1555_: f32;
    var phi_1560_: lt_bvh_triangle_Intersection;
    var phi_1561_: bool;
    var phi_1562_: lt_bvh_triangle_Intersection;
    var phi_1563_: bool;
    var phi_1567_: lt_bvh_triangle_Intersection;
    var phi_1568_: bool;
    var phi_1569_: lt_bvh_triangle_Intersection;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1575_: bool;
    var phi_1579_: lt_bvh_triangle_Intersection;
    var phi_1604_: bool;
    var phi_1605_: bool;
    var phi_1606_: bool;
    var phi_1607_: bool;
    var phi_1608_: bool;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1011_: u32;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1623_: bool;
    var local_4: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1697_: u32;
    var phi_1698_: u32;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_681_: u32;
    var phi_1701_: bool;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var local_5: bool;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1713_: bool;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1720_: bool;
    var phi_1724_: bool;
    var phi_1728_: f32;
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
                phi_1718_ = bool();
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
                loop {
                    let _e494 = phi_680_;
                    if (_e494 != 4294967295u) {
                        if (_e494 < _e57) {
                        } else {
                            return;
                        }
                        let _e501 = nodes.member[(0u + _e494)].frame[3u];
                        let _e526 = (bitcast<f32>((((_e501 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e258);
                        let _e527 = (bitcast<f32>((((_e501 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e268);
                        let _e528 = (bitcast<f32>((((_e501 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e278);
                        let _e531 = nodes.member[(0u + _e494)].frame[0u];
                        let _e535 = nodes.member[(0u + _e494)].frame[1u];
                        let _e539 = nodes.member[(0u + _e494)].frame[2u];
                        let _e544 = ((bitcast<f32>(_e531) - _e99) * _e258);
                        let _e545 = ((bitcast<f32>(_e535) - _e101) * _e268);
                        let _e546 = ((bitcast<f32>(_e539) - _e103) * _e278);
                        let _e554 = nodes.member[(0u + _e494)].x;
                        if (_e258 < 0f) {
                            let _e565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e565.unnamed.root, _e554.w), _e565.unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e571.unnamed, lt_bvh_traverse_Tree(_e554.x, _e571.unnamed_1.first_primitive));
                            phi_761_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e577.unnamed_1.root, _e554.y));
                        } else {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.unnamed.root, _e554.y), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_bvh_traverse_Tree(_e554.z, _e599.unnamed_1.first_primitive));
                            phi_761_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e605.unnamed_1.root, _e554.w));
                        }
                        let _e613 = phi_761_;
                        let _e623 = nodes.member[(0u + _e494)].y;
                        if (_e268 < 0f) {
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e634.unnamed.root, _e623.w), _e634.unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_bvh_traverse_Tree(_e623.x, _e640.unnamed_1.first_primitive));
                            phi_788_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e646.unnamed_1.root, _e623.y));
                        } else {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.unnamed.root, _e623.y), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e623.z, _e668.unnamed_1.first_primitive));
                            phi_788_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e674.unnamed_1.root, _e623.w));
                        }
                        let _e682 = phi_788_;
                        let _e692 = nodes.member[(0u + _e494)].z;
                        if (_e278 < 0f) {
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e703.unnamed.root, _e692.w), _e703.unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_bvh_traverse_Tree(_e692.x, _e709.unnamed_1.first_primitive));
                            phi_815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e715.unnamed_1.root, _e692.y));
                        } else {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.unnamed.root, _e692.y), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e692.z, _e737.unnamed_1.first_primitive));
                            phi_815_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e743.unnamed_1.root, _e692.w));
                        }
                        let _e751 = phi_815_;
                        phi_821_ = 0u;
                        phi_824_ = 0u;
                        loop {
                            let _e761 = phi_821_;
                            let _e763 = phi_824_;
                            local_1 = _e763;
                            local_2 = _e763;
                            local_3 = _e763;
                            let _e764 = (_e761 < 8u);
                            if _e764 {
                                let _e766 = (_e761 >> bitcast<u32>(2i));
                                let _e767 = (_e761 & 3u);
                                if (_e766 == 0u) {
                                    phi_838_ = _e613.unnamed.root;
                                } else {
                                    phi_838_ = _e613.unnamed.first_primitive;
                                }
                                let _e770 = phi_838_;
                                if (_e766 == 0u) {
                                    phi_848_ = _e682.unnamed.root;
                                } else {
                                    phi_848_ = _e682.unnamed.first_primitive;
                                }
                                let _e779 = phi_848_;
                                if (_e766 == 0u) {
                                    phi_858_ = _e751.unnamed.root;
                                } else {
                                    phi_858_ = _e751.unnamed.first_primitive;
                                }
                                let _e788 = phi_858_;
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e770 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e306)), ((f32(((_e779 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e307)));
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(_e801, ((f32(((_e788 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e308)));
                                if (_e766 == 0u) {
                                    phi_876_ = _e613.unnamed_1.root;
                                } else {
                                    phi_876_ = _e613.unnamed_1.first_primitive;
                                }
                                let _e805 = phi_876_;
                                if (_e766 == 0u) {
                                    phi_886_ = _e682.unnamed_1.root;
                                } else {
                                    phi_886_ = _e682.unnamed_1.first_primitive;
                                }
                                let _e814 = phi_886_;
                                if (_e766 == 0u) {
                                    phi_896_ = _e751.unnamed_1.root;
                                } else {
                                    phi_896_ = _e751.unnamed_1.first_primitive;
                                }
                                let _e823 = phi_896_;
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e805 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e306)), ((f32(((_e814 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e307)));
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(_e836, ((f32(((_e823 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e308)));
                                if (_e802 <= _e837) {
                                    if (_e802 <= _e109) {
                                        if (_e837 >= 0f) {
                                            if (_e766 == 0u) {
                                                let _e844 = nodes.member[(0u + _e494)].links[2u];
                                                phi_932_ = _e844;
                                            } else {
                                                let _e847 = nodes.member[(0u + _e494)].links[3u];
                                                phi_932_ = _e847;
                                            }
                                            let _e849 = phi_932_;
                                            let _e854 = ((_e849 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u);
                                            let _e855 = (_e854 & 31u);
                                            if (_e855 >= 24u) {
                                                phi_945_ = (24u + ((_e855 - 24u) ^ _e356));
                                            } else {
                                                phi_945_ = _e855;
                                            }
                                            let _e861 = phi_945_;
                                            phi_950_ = (_e763 | ((_e854 >> bitcast<u32>(5i)) << bitcast<u32>((_e861 & 31u))));
                                        } else {
                                            phi_950_ = _e763;
                                        }
                                        let _e869 = phi_950_;
                                        phi_951_ = _e869;
                                    } else {
                                        phi_951_ = _e763;
                                    }
                                    let _e871 = phi_951_;
                                    phi_952_ = _e871;
                                } else {
                                    phi_952_ = _e763;
                                }
                                let _e873 = phi_952_;
                                phi_822_ = (_e761 + 1u);
                                phi_825_ = _e873;
                            } else {
                                phi_822_ = u32();
                                phi_825_ = u32();
                            }
                            let _e876 = phi_822_;
                            let _e878 = phi_825_;
                            continue;
                            continuing {
                                phi_821_ = _e876;
                                phi_824_ = _e878;
                                break if !(_e764);
                            }
                        }
                        let _e882 = nodes.member[(0u + _e494)].links[0u];
                        let _e886 = nodes.member[(0u + _e494)].frame[3u];
                        let _e890 = local_1;
                        if ((_e890 & 4278190080u) == 0u) {
                        } else {
                            let _e894 = local.group_mask;
                            if ((_e894 & 4278190080u) == 0u) {
                            } else {
                                let _e898 = local.len;
                                if (_e898 < 32u) {
                                    let _e901 = local.group;
                                    let _e903 = local.len;
                                    if (_e903 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e903)] = _e901;
                                    let _e909 = local.group_mask;
                                    let _e911 = local.len;
                                    if (_e911 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e911)] = _e909;
                                    let _e918 = local.len;
                                    local.len = (_e918 + 1u);
                                }
                            }
                            local.group = (0u + _e882);
                            let _e922 = local_2;
                            local.group_mask = ((_e922 & 4278190080u) | (_e886 >> bitcast<u32>(24i)));
                        }
                        let _e927 = local_3;
                        phi_1010_ = (_e927 & 16777215u);
                        loop {
                            let _e930 = phi_1010_;
                            let _e931 = (_e930 == 0u);
                            local_4 = _e931;
                            local_8 = _e931;
                            if _e931 {
                                phi_1011_ = u32();
                                phi_1621_ = false;
                                phi_1622_ = false;
                                phi_1623_ = false;
                            } else {
                                let _e934 = nodes.member[(0u + _e494)].links[1u];
                                let _e939 = ((0u + _e934) + select(firstTrailingBit(_e930), 32u, (_e930 == 0u)));
                                if (_e939 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e946 = triangles.member[(0u + _e939)].v0_;
                                let _e948 = (_e946.x - _e99);
                                let _e950 = (_e946.y - _e101);
                                let _e952 = (_e946.z - _e103);
                                if (_e329 == 0u) {
                                    phi_1056_ = vec3<f32>(_e950, _e952, _e948);
                                } else {
                                    if (_e329 == 1u) {
                                        phi_1055_ = vec3<f32>(_e952, _e948, _e950);
                                    } else {
                                        phi_1055_ = (_e946 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e960 = phi_1055_;
                                    phi_1056_ = _e960;
                                }
                                let _e962 = phi_1056_;
                                let _e966 = (_e962.x - (_e340 * _e962.z));
                                let _e970 = (_e962.y - (_e343 * _e962.z));
                                let _e972 = triangles.member[(0u + _e939)].v1_;
                                let _e974 = (_e972.x - _e99);
                                let _e976 = (_e972.y - _e101);
                                let _e978 = (_e972.z - _e103);
                                if (_e329 == 0u) {
                                    phi_1086_ = vec3<f32>(_e976, _e978, _e974);
                                } else {
                                    if (_e329 == 1u) {
                                        phi_1085_ = vec3<f32>(_e978, _e974, _e976);
                                    } else {
                                        phi_1085_ = (_e972 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e986 = phi_1085_;
                                    phi_1086_ = _e986;
                                }
                                let _e988 = phi_1086_;
                                let _e992 = (_e988.x - (_e340 * _e988.z));
                                let _e996 = (_e988.y - (_e343 * _e988.z));
                                let _e998 = triangles.member[(0u + _e939)].v2_;
                                let _e1000 = (_e998.x - _e99);
                                let _e1002 = (_e998.y - _e101);
                                let _e1004 = (_e998.z - _e103);
                                if (_e329 == 0u) {
                                    phi_1116_ = vec3<f32>(_e1002, _e1004, _e1000);
                                } else {
                                    if (_e329 == 1u) {
                                        phi_1115_ = vec3<f32>(_e1004, _e1000, _e1002);
                                    } else {
                                        phi_1115_ = (_e998 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e1012 = phi_1115_;
                                    phi_1116_ = _e1012;
                                }
                                let _e1014 = phi_1116_;
                                let _e1018 = (_e1014.x - (_e340 * _e1014.z));
                                let _e1022 = (_e1014.y - (_e343 * _e1014.z));
                                if (_e992 < _e1018) {
                                    phi_1135_ = true;
                                } else {
                                    if (_e992 == _e1018) {
                                        phi_1134_ = (_e996 < _e1022);
                                    } else {
                                        phi_1134_ = false;
                                    }
                                    let _e1027 = phi_1134_;
                                    phi_1135_ = _e1027;
                                }
                                let _e1029 = phi_1135_;
                                if _e1029 {
                                    phi_1139_ = _e1022;
                                    phi_1140_ = _e1018;
                                    phi_1141_ = _e996;
                                    phi_1142_ = _e992;
                                } else {
                                    phi_1139_ = _e996;
                                    phi_1140_ = _e992;
                                    phi_1141_ = _e1022;
                                    phi_1142_ = _e1018;
                                }
                                let _e1031 = phi_1139_;
                                let _e1033 = phi_1140_;
                                let _e1035 = phi_1141_;
                                let _e1037 = phi_1142_;
                                let _e1040 = ((_e1037 * _e1031) - (_e1035 * _e1033));
                                if _e1029 {
                                    phi_1150_ = -(_e1040);
                                } else {
                                    phi_1150_ = _e1040;
                                }
                                let _e1043 = phi_1150_;
                                if (_e1018 < _e966) {
                                    phi_1161_ = true;
                                } else {
                                    if (_e1018 == _e966) {
                                        phi_1160_ = (_e1022 < _e970);
                                    } else {
                                        phi_1160_ = false;
                                    }
                                    let _e1048 = phi_1160_;
                                    phi_1161_ = _e1048;
                                }
                                let _e1050 = phi_1161_;
                                if _e1050 {
                                    phi_1165_ = _e970;
                                    phi_1166_ = _e966;
                                    phi_1167_ = _e1022;
                                    phi_1168_ = _e1018;
                                } else {
                                    phi_1165_ = _e1022;
                                    phi_1166_ = _e1018;
                                    phi_1167_ = _e970;
                                    phi_1168_ = _e966;
                                }
                                let _e1052 = phi_1165_;
                                let _e1054 = phi_1166_;
                                let _e1056 = phi_1167_;
                                let _e1058 = phi_1168_;
                                let _e1061 = ((_e1058 * _e1052) - (_e1056 * _e1054));
                                if _e1050 {
                                    phi_1176_ = -(_e1061);
                                } else {
                                    phi_1176_ = _e1061;
                                }
                                let _e1064 = phi_1176_;
                                if (_e966 < _e992) {
                                    phi_1187_ = true;
                                } else {
                                    if (_e966 == _e992) {
                                        phi_1186_ = (_e970 < _e996);
                                    } else {
                                        phi_1186_ = false;
                                    }
                                    let _e1069 = phi_1186_;
                                    phi_1187_ = _e1069;
                                }
                                let _e1071 = phi_1187_;
                                if _e1071 {
                                    phi_1191_ = _e996;
                                    phi_1192_ = _e992;
                                    phi_1193_ = _e970;
                                    phi_1194_ = _e966;
                                } else {
                                    phi_1191_ = _e970;
                                    phi_1192_ = _e966;
                                    phi_1193_ = _e996;
                                    phi_1194_ = _e992;
                                }
                                let _e1073 = phi_1191_;
                                let _e1075 = phi_1192_;
                                let _e1077 = phi_1193_;
                                let _e1079 = phi_1194_;
                                let _e1082 = ((_e1079 * _e1073) - (_e1077 * _e1075));
                                if _e1071 {
                                    phi_1202_ = -(_e1082);
                                } else {
                                    phi_1202_ = _e1082;
                                }
                                let _e1085 = phi_1202_;
                                if (_e1043 >= 0f) {
                                    if (_e1064 >= 0f) {
                                        if (_e1085 >= 0f) {
                                            phi_1217_ = ((_e1043 + _e1064) + _e1085);
                                            phi_1218_ = false;
                                        } else {
                                            phi_1217_ = f32();
                                            phi_1218_ = true;
                                        }
                                        let _e1092 = phi_1217_;
                                        let _e1094 = phi_1218_;
                                        phi_1219_ = _e1092;
                                        phi_1220_ = _e1094;
                                    } else {
                                        phi_1219_ = f32();
                                        phi_1220_ = true;
                                    }
                                    let _e1096 = phi_1219_;
                                    let _e1098 = phi_1220_;
                                    phi_1221_ = _e1096;
                                    phi_1222_ = _e1098;
                                } else {
                                    phi_1221_ = f32();
                                    phi_1222_ = true;
                                }
                                let _e1100 = phi_1221_;
                                let _e1102 = phi_1222_;
                                if _e1102 {
                                    if (_e1043 <= 0f) {
                                        if (_e1064 <= 0f) {
                                            let _e1105 = (_e1085 <= 0f);
                                            if _e1105 {
                                            }
                                            phi_1240_ = ((_e1043 + _e1064) + _e1085);
                                            phi_1241_ = false;
                                            phi_1242_ = _e1105;
                                        } else {
                                            phi_1240_ = f32();
                                            phi_1241_ = true;
                                            phi_1242_ = false;
                                        }
                                        let _e1109 = phi_1240_;
                                        let _e1111 = phi_1241_;
                                        let _e1113 = phi_1242_;
                                        phi_1243_ = _e1109;
                                        phi_1244_ = _e1111;
                                        phi_1245_ = _e1113;
                                    } else {
                                        phi_1243_ = f32();
                                        phi_1244_ = true;
                                        phi_1245_ = false;
                                    }
                                    let _e1115 = phi_1243_;
                                    let _e1117 = phi_1244_;
                                    let _e1119 = phi_1245_;
                                    if _e1117 {
                                        phi_1249_ = false;
                                    } else {
                                        phi_1249_ = _e1119;
                                    }
                                    let _e1121 = phi_1249_;
                                    phi_1250_ = _e1115;
                                    phi_1251_ = _e1121;
                                } else {
                                    phi_1250_ = _e1100;
                                    phi_1251_ = true;
                                }
                                let _e1123 = phi_1250_;
                                let _e1125 = phi_1251_;
                                if _e1125 {
                                    let _e1126 = (_e1123 == 0f);
                                    if _e1126 {
                                        phi_1567_ = lt_bvh_triangle_Intersection();
                                        phi_1568_ = false;
                                    } else {
                                        let _e1128 = triangles.member[(0u + _e939)].v0_;
                                        let _e1130 = (_e1128.x - _e99);
                                        let _e1132 = (_e1128.y - _e101);
                                        let _e1134 = (_e1128.z - _e103);
                                        if (_e329 == 0u) {
                                            phi_1280_ = vec3<f32>(_e1132, _e1134, _e1130);
                                        } else {
                                            if (_e329 == 1u) {
                                                phi_1279_ = vec3<f32>(_e1134, _e1130, _e1132);
                                            } else {
                                                phi_1279_ = (_e1128 - vec3<f32>(_e99, _e101, _e103));
                                            }
                                            let _e1142 = phi_1279_;
                                            phi_1280_ = _e1142;
                                        }
                                        let _e1144 = phi_1280_;
                                        let _e1146 = triangles.member[(0u + _e939)].v1_;
                                        let _e1148 = triangles.member[(0u + _e939)].v0_;
                                        let _e1151 = (_e1146.x - _e1148.x);
                                        let _e1154 = (_e1146.y - _e1148.y);
                                        let _e1157 = (_e1146.z - _e1148.z);
                                        if (_e329 == 0u) {
                                            phi_1306_ = vec3<f32>(_e1154, _e1157, _e1151);
                                        } else {
                                            if (_e329 == 1u) {
                                                phi_1305_ = vec3<f32>(_e1157, _e1151, _e1154);
                                            } else {
                                                phi_1305_ = (_e1146 - _e1148);
                                            }
                                            let _e1164 = phi_1305_;
                                            phi_1306_ = _e1164;
                                        }
                                        let _e1166 = phi_1306_;
                                        let _e1168 = triangles.member[(0u + _e939)].v2_;
                                        let _e1170 = triangles.member[(0u + _e939)].v0_;
                                        let _e1173 = (_e1168.x - _e1170.x);
                                        let _e1176 = (_e1168.y - _e1170.y);
                                        let _e1179 = (_e1168.z - _e1170.z);
                                        if (_e329 == 0u) {
                                            phi_1332_ = vec3<f32>(_e1176, _e1179, _e1173);
                                        } else {
                                            if (_e329 == 1u) {
                                                phi_1331_ = vec3<f32>(_e1179, _e1173, _e1176);
                                            } else {
                                                phi_1331_ = (_e1168 - _e1170);
                                            }
                                            let _e1186 = phi_1331_;
                                            phi_1332_ = _e1186;
                                        }
                                        let _e1188 = phi_1332_;
                                        let _e1195 = ((_e1166.y * _e1188.z) - (_e1166.z * _e1188.y));
                                        let _e1202 = ((_e1166.z * _e1188.x) - (_e1166.x * _e1188.z));
                                        let _e1209 = ((_e1166.x * _e1188.y) - (_e1166.y * _e1188.x));
                                        let _e1223 = (((1f / _e337.z) * (((_e1195 * _e1144.x) + (_e1202 * _e1144.y)) + (_e1209 * _e1144.z))) / (((_e1195 * _e340) + (_e1202 * _e343)) + _e1209));
                                        if (_e1223 > 0f) {
                                            if (_e1223 < _e109) {
                                                let _e1227 = triangles.member[(0u + _e939)].v0_;
                                                let _e1229 = triangles.member[(0u + _e939)].v1_;
                                                if (_e1227.x < _e1229.x) {
                                                    phi_1388_ = _e1227.x;
                                                } else {
                                                    phi_1388_ = _e1229.x;
                                                }
                                                let _e1236 = phi_1388_;
                                                if (_e1227.y < _e1229.y) {
                                                    phi_1397_ = _e1227.y;
                                                } else {
                                                    phi_1397_ = _e1229.y;
                                                }
                                                let _e1243 = phi_1397_;
                                                if (_e1227.z < _e1229.z) {
                                                    phi_1406_ = _e1227.z;
                                                } else {
                                                    phi_1406_ = _e1229.z;
                                                }
                                                let _e1250 = phi_1406_;
                                                let _e1252 = triangles.member[(0u + _e939)].v2_;
                                                if (_e1236 < _e1252.x) {
                                                    phi_1415_ = _e1236;
                                                } else {
                                                    phi_1415_ = _e1252.x;
                                                }
                                                let _e1257 = phi_1415_;
                                                if (_e1243 < _e1252.y) {
                                                    phi_1422_ = _e1243;
                                                } else {
                                                    phi_1422_ = _e1252.y;
                                                }
                                                let _e1262 = phi_1422_;
                                                if (_e1250 < _e1252.z) {
                                                    phi_1429_ = _e1250;
                                                } else {
                                                    phi_1429_ = _e1252.z;
                                                }
                                                let _e1267 = phi_1429_;
                                                let _e1269 = triangles.member[(0u + _e939)].v0_;
                                                let _e1271 = triangles.member[(0u + _e939)].v1_;
                                                if (_e1269.x > _e1271.x) {
                                                    phi_1442_ = _e1269.x;
                                                } else {
                                                    phi_1442_ = _e1271.x;
                                                }
                                                let _e1278 = phi_1442_;
                                                if (_e1269.y > _e1271.y) {
                                                    phi_1451_ = _e1269.y;
                                                } else {
                                                    phi_1451_ = _e1271.y;
                                                }
                                                let _e1285 = phi_1451_;
                                                if (_e1269.z > _e1271.z) {
                                                    phi_1460_ = _e1269.z;
                                                } else {
                                                    phi_1460_ = _e1271.z;
                                                }
                                                let _e1292 = phi_1460_;
                                                let _e1294 = triangles.member[(0u + _e939)].v2_;
                                                if (_e1278 > _e1294.x) {
                                                    phi_1469_ = _e1278;
                                                } else {
                                                    phi_1469_ = _e1294.x;
                                                }
                                                let _e1299 = phi_1469_;
                                                if (_e1285 > _e1294.y) {
                                                    phi_1476_ = _e1285;
                                                } else {
                                                    phi_1476_ = _e1294.y;
                                                }
                                                let _e1304 = phi_1476_;
                                                if (_e1292 > _e1294.z) {
                                                    phi_1483_ = _e1292;
                                                } else {
                                                    phi_1483_ = _e1294.z;
                                                }
                                                let _e1309 = phi_1483_;
                                                let _e1313 = ((_e1257 - _e99) * _e258);
                                                let _e1314 = ((_e1262 - _e101) * _e268);
                                                let _e1315 = ((_e1267 - _e103) * _e278);
                                                let _e1319 = ((_e1299 - _e99) * _e258);
                                                let _e1320 = ((_e1304 - _e101) * _e268);
                                                let _e1321 = ((_e1309 - _e103) * _e278);
                                                if (_e1313 < _e1319) {
                                                    phi_1500_ = _e1313;
                                                } else {
                                                    phi_1500_ = _e1319;
                                                }
                                                let _e1324 = phi_1500_;
                                                if (_e1314 < _e1320) {
                                                    phi_1505_ = _e1314;
                                                } else {
                                                    phi_1505_ = _e1320;
                                                }
                                                let _e1327 = phi_1505_;
                                                if (_e1315 < _e1321) {
                                                    phi_1510_ = _e1315;
                                                } else {
                                                    phi_1510_ = _e1321;
                                                }
                                                let _e1330 = phi_1510_;
                                                if (_e1313 > _e1319) {
                                                    phi_1518_ = _e1313;
                                                } else {
                                                    phi_1518_ = _e1319;
                                                }
                                                let _e1336 = phi_1518_;
                                                if (_e1314 > _e1320) {
                                                    phi_1523_ = _e1314;
                                                } else {
                                                    phi_1523_ = _e1320;
                                                }
                                                let _e1339 = phi_1523_;
                                                if (_e1315 > _e1321) {
                                                    phi_1528_ = _e1315;
                                                } else {
                                                    phi_1528_ = _e1321;
                                                }
                                                let _e1342 = phi_1528_;
                                                let _e1346 = core_intrinsics_maximum_number_nsz_f32_((_e1324 - _e313), (_e1327 - _e314));
                                                let _e1347 = core_intrinsics_maximum_number_nsz_f32_(_e1346, (_e1330 - _e315));
                                                let _e1348 = core_intrinsics_minimum_number_nsz_f32_((_e1336 + _e313), (_e1339 + _e314));
                                                let _e1349 = core_intrinsics_minimum_number_nsz_f32_(_e1348, (_e1342 + _e315));
                                                if (_e1347 > -300000000000000000000000000000000000000f) {
                                                    phi_1540_ = _e1347;
                                                } else {
                                                    phi_1540_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1352 = phi_1540_;
                                                if (_e1349 < 300000000000000000000000000000000000000f) {
                                                    phi_1545_ = _e1349;
                                                } else {
                                                    phi_1545_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1355 = phi_1545_;
                                                if (_e1223 < _e1352) {
                                                    phi_1550_ = _e1352;
                                                } else {
                                                    phi_1550_ = _e1223;
                                                }
                                                let _e1358 = phi_1550_;
                                                if (_e1358 > _e1355) {
                                                    phi_1555_ = _e1355;
                                                } else {
                                                    phi_1555_ = _e1358;
                                                }
                                                let _e1361 = phi_1555_;
                                                phi_1560_ = lt_bvh_triangle_Intersection(_e1361, (_e1064 / _e1123), (_e1085 / _e1123), (_e1352 <= _e1355));
                                                phi_1561_ = false;
                                            } else {
                                                phi_1560_ = lt_bvh_triangle_Intersection();
                                                phi_1561_ = true;
                                            }
                                            let _e1367 = phi_1560_;
                                            let _e1369 = phi_1561_;
                                            phi_1562_ = _e1367;
                                            phi_1563_ = _e1369;
                                        } else {
                                            phi_1562_ = lt_bvh_triangle_Intersection();
                                            phi_1563_ = true;
                                        }
                                        let _e1371 = phi_1562_;
                                        let _e1373 = phi_1563_;
                                        if _e1373 {
                                        }
                                        phi_1567_ = _e1371;
                                        phi_1568_ = _e1373;
                                    }
                                    let _e1375 = phi_1567_;
                                    let _e1377 = phi_1568_;
                                    phi_1569_ = _e1375;
                                    phi_1570_ = _e1126;
                                    phi_1571_ = _e1377;
                                } else {
                                    phi_1569_ = lt_bvh_triangle_Intersection();
                                    phi_1570_ = true;
                                    phi_1571_ = false;
                                }
                                let _e1379 = phi_1569_;
                                let _e1381 = phi_1570_;
                                let _e1383 = phi_1571_;
                                if _e1381 {
                                    phi_1575_ = true;
                                } else {
                                    phi_1575_ = _e1383;
                                }
                                let _e1385 = phi_1575_;
                                if _e1385 {
                                    phi_1579_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1579_ = _e1379;
                                }
                                let _e1387 = phi_1579_;
                                if _e1387.is_hit {
                                    if (_e1387.t > 0f) {
                                        if (_e1387.t < _e109) {
                                            let _e1394 = triangles.member[(0u + _e939)].i0_;
                                            let _e1396 = ((_e1394 & 2147483648u) == 0u);
                                            if _e1396 {
                                                phi_1605_ = false;
                                                phi_1606_ = false;
                                            } else {
                                                if true {
                                                    phi_1604_ = false;
                                                } else {
                                                    phi_1604_ = true;
                                                }
                                                let _e1398 = phi_1604_;
                                                phi_1605_ = _e1398;
                                                phi_1606_ = true;
                                            }
                                            let _e1400 = phi_1605_;
                                            let _e1402 = phi_1606_;
                                            phi_1607_ = _e1400;
                                            phi_1608_ = _e1396;
                                            phi_1609_ = _e1402;
                                        } else {
                                            phi_1607_ = true;
                                            phi_1608_ = false;
                                            phi_1609_ = false;
                                        }
                                        let _e1404 = phi_1607_;
                                        let _e1406 = phi_1608_;
                                        let _e1408 = phi_1609_;
                                        phi_1610_ = _e1404;
                                        phi_1611_ = _e1406;
                                        phi_1612_ = _e1408;
                                    } else {
                                        phi_1610_ = true;
                                        phi_1611_ = false;
                                        phi_1612_ = false;
                                    }
                                    let _e1410 = phi_1610_;
                                    let _e1412 = phi_1611_;
                                    let _e1414 = phi_1612_;
                                    phi_1613_ = _e1410;
                                    phi_1614_ = _e1412;
                                    phi_1615_ = _e1414;
                                } else {
                                    phi_1613_ = true;
                                    phi_1614_ = false;
                                    phi_1615_ = false;
                                }
                                let _e1416 = phi_1613_;
                                let _e1418 = phi_1614_;
                                let _e1420 = phi_1615_;
                                if _e1416 {
                                    phi_1619_ = false;
                                    phi_1620_ = false;
                                } else {
                                    phi_1619_ = _e1418;
                                    phi_1620_ = _e1420;
                                }
                                let _e1422 = phi_1619_;
                                let _e1424 = phi_1620_;
                                phi_1011_ = (_e930 & (_e930 - 1u));
                                phi_1621_ = _e1416;
                                phi_1622_ = _e1422;
                                phi_1623_ = _e1424;
                            }
                            let _e1426 = phi_1011_;
                            let _e1428 = phi_1621_;
                            let _e1430 = phi_1622_;
                            let _e1432 = phi_1623_;
                            local_6 = _e1430;
                            local_7 = _e1432;
                            continue;
                            continuing {
                                phi_1010_ = _e1426;
                                break if !(_e1428);
                            }
                        }
                        let _e1435 = local_4;
                        if _e1435 {
                            let _e1437 = local.group_mask;
                            if ((_e1437 & 4278190080u) == 0u) {
                                let _e1441 = local.len;
                                if (_e1441 == 0u) {
                                    phi_1665_ = false;
                                } else {
                                    let _e1445 = local.len;
                                    local.len = (_e1445 - 1u);
                                    let _e1448 = local.len;
                                    if (_e1448 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1453 = local.first[(0u + _e1448)];
                                    local.group = _e1453;
                                    let _e1456 = local.len;
                                    if (_e1456 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1461 = local.mask[(0u + _e1456)];
                                    local.group_mask = _e1461;
                                    phi_1665_ = true;
                                }
                                let _e1464 = phi_1665_;
                                phi_1666_ = _e1464;
                            } else {
                                phi_1666_ = true;
                            }
                            let _e1466 = phi_1666_;
                            if _e1466 {
                                let _e1468 = local.group_mask;
                                let _e1474 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1468)), 32u, (_e1468 == 0u)));
                                let _e1478 = local.group_mask;
                                let _e1492 = local.group_mask;
                                local.group_mask = (_e1492 & ~((1u << bitcast<u32>((_e1474 & 31u)))));
                                let _e1495 = local.group;
                                phi_1697_ = (_e1495 + countOneBits(((_e1478 & ~((4294967295u << bitcast<u32>((((_e1474 - 24u) ^ _e356) & 31u))))) & 255u)));
                            } else {
                                phi_1697_ = 4294967295u;
                            }
                            let _e1498 = phi_1697_;
                            phi_1698_ = _e1498;
                            phi_1699_ = false;
                            phi_1700_ = false;
                        } else {
                            phi_1698_ = u32();
                            let _e1713 = local_6;
                            phi_1699_ = _e1713;
                            let _e1716 = local_7;
                            phi_1700_ = _e1716;
                        }
                        let _e1500 = phi_1698_;
                        let _e1502 = phi_1699_;
                        let _e1504 = phi_1700_;
                        phi_681_ = _e1500;
                        let _e1720 = local_8;
                        phi_1701_ = _e1720;
                        phi_1702_ = false;
                        phi_1703_ = _e1502;
                        phi_1704_ = _e1504;
                    } else {
                        phi_681_ = u32();
                        phi_1701_ = false;
                        phi_1702_ = true;
                        phi_1703_ = false;
                        phi_1704_ = false;
                    }
                    let _e1506 = phi_681_;
                    let _e1508 = phi_1701_;
                    let _e1510 = phi_1702_;
                    let _e1512 = phi_1703_;
                    let _e1514 = phi_1704_;
                    local_5 = _e1510;
                    local_9 = _e1512;
                    local_10 = _e1514;
                    continue;
                    continuing {
                        phi_680_ = _e1506;
                        break if !(_e1508);
                    }
                }
                let _e1517 = local_5;
                if _e1517 {
                    phi_1708_ = false;
                    phi_1709_ = false;
                } else {
                    let _e1727 = local_9;
                    phi_1708_ = _e1727;
                    let _e1730 = local_10;
                    phi_1709_ = _e1730;
                }
                let _e1519 = phi_1708_;
                let _e1521 = phi_1709_;
                if _e1519 {
                    phi_1713_ = true;
                } else {
                    phi_1713_ = _e1521;
                }
                let _e1523 = phi_1713_;
                if _e1523 {
                    phi_1717_ = true;
                } else {
                    phi_1717_ = false;
                }
                let _e1525 = phi_1717_;
                phi_1718_ = _e1525;
            }
            let _e1527 = phi_1718_;
            phi_1719_ = _e1527;
            phi_1720_ = _e182;
        } else {
            phi_1719_ = bool();
            phi_1720_ = true;
        }
        let _e1529 = phi_1719_;
        let _e1531 = phi_1720_;
        if _e1531 {
            phi_1724_ = false;
        } else {
            phi_1724_ = _e1529;
        }
        let _e1533 = phi_1724_;
        if _e1533 {
            phi_1728_ = 0f;
        } else {
            phi_1728_ = 1f;
        }
        let _e1535 = phi_1728_;
        if (_e79 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79)] = _e1535;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
