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
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> nodes: type_35;
@group(0) @binding(3) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_150_: bool;
    var phi_154_: f32;

    if (param != param) {
        phi_150_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_150_ = _e54;
    }
    let _e56 = phi_150_;
    if _e56 {
        phi_154_ = param_1;
    } else {
        phi_154_ = param;
    }
    let _e58 = phi_154_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_166_: bool;
    var phi_170_: f32;

    if (param_2 != param_2) {
        phi_166_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_166_ = _e54;
    }
    let _e56 = phi_166_;
    if _e56 {
        phi_170_ = param_3;
    } else {
        phi_170_ = param_2;
    }
    let _e58 = phi_170_;
    return _e58;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_247_: f32;
    var phi_302_: bool;
    var phi_303_: bool;
    var phi_304_: bool;
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
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_329_: bool;
    var phi_333_: bool;
    var phi_403_: f32;
    var phi_410_: f32;
    var phi_417_: f32;
    var phi_424_: f32;
    var phi_431_: f32;
    var phi_438_: f32;
    var phi_455_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_493_: bool;
    var phi_494_: bool;
    var phi_502_: u32;
    var phi_503_: u32;
    var phi_514_: vec3<f32>;
    var phi_515_: vec3<f32>;
    var phi_528_: u32;
    var phi_533_: u32;
    var phi_538_: u32;
    var phi_652_: bool;
    var phi_653_: bool;
    var phi_684_: u32;
    var phi_686_: u32;
    var phi_689_: bool;
    var phi_769_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_796_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_823_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_829_: u32;
    var phi_832_: u32;
    var phi_846_: u32;
    var phi_856_: u32;
    var phi_866_: u32;
    var phi_884_: u32;
    var phi_894_: u32;
    var phi_904_: u32;
    var phi_940_: u32;
    var phi_953_: u32;
    var phi_958_: u32;
    var phi_959_: u32;
    var phi_960_: u32;
    var phi_830_: u32;
    var phi_833_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1018_: u32;
    var phi_1021_: bool;
    var phi_1065_: vec3<f32>;
    var phi_1066_: vec3<f32>;
    var phi_1095_: vec3<f32>;
    var phi_1096_: vec3<f32>;
    var phi_1125_: vec3<f32>;
    var phi_1126_: vec3<f32>;
    var phi_1144_: bool;
    var phi_1145_: bool;
    var phi_1149_: f32;
    var phi_1150_: f32;
    var phi_1151_: f32;
    var phi_1152_: f32;
    var phi_1160_: f32;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1175_: f32;
    var phi_1176_: f32;
    var phi_1177_: f32;
    var phi_1178_: f32;
    var phi_1186_: f32;
    var phi_1196_: bool;
    var phi_1197_: bool;
    var phi_1201_: f32;
    var phi_1202_: f32;
    var phi_1203_: f32;
    var phi_1204_: f32;
    var phi_1212_: f32;
    var phi_1227_: f32;
    var phi_1228_: bool;
    var phi_1229_: f32;
    var phi_1230_: bool;
    var phi_1231_: f32;
    var phi_1232_: bool;
    var phi_1250_: f32;
    var phi_1251_: bool;
    var phi_1252_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1259_: bool;
    var phi_1260_: f32;
    var phi_1261_: bool;
    var phi_1289_: vec3<f32>;
    var phi_1290_: vec3<f32>;
    var phi_1315_: vec3<f32>;
    var phi_1316_: vec3<f32>;
    var phi_1341_: vec3<f32>;
    var phi_1342_: vec3<f32>;
    var phi_1398_: f32;
    var phi_1407_: f32;
    var phi_1416_: f32;
    var phi_1425_: f32;
    var phi_1432_: f32;
    var phi_1439_: f32;
    var phi_1452_: f32;
    var phi_1461_: f32;
    var phi_1470_: f32;
    var phi_1479_: f32;
    var phi_1486_: f32;
    var phi_1493_: f32;
    var phi_1510_: f32;
    var phi_1515_: f32;
    var phi_1520_: f32;
    var phi_1528_: f32;
    var phi_1533_: f32;
    var phi_1538_: f32;
    var phi_1550_: f32;
    var phi_1555_: f32;
    var phi_1560_: f32;
    var phi_1565_: f32;
    var phi_1570_: lt_bvh_triangle_Intersection;
    var phi_1571_: bool;
    var phi_1572_: lt_bvh_triangle_Intersection;
    var phi_1573_: bool;
    var phi_1577_: lt_bvh_triangle_Intersection;
    var phi_1578_: bool;
    var phi_1579_: lt_bvh_triangle_Intersection;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var phi_1585_: bool;
    var phi_1589_: lt_bvh_triangle_Intersection;
    var phi_1609_: bool;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1019_: u32;
    var phi_1022_: bool;
    var phi_1619_: bool;
    var local_4: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1693_: u32;
    var phi_1694_: u32;
    var phi_687_: u32;
    var phi_690_: bool;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var local_5: bool;
    var phi_1700_: bool;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1711_: bool;
    var phi_1715_: f32;
    var phi_1736_: u32;
    var phi_1751_: u32;
    var phi_1756_: u32;
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
        let _e90 = samples.member[(0u + _e84)].position;
        let _e92 = samples.member[(0u + _e84)].normal;
        let _e94 = samples.member[(0u + _e84)].magnitude;
        let _e96 = ((8f / 8388608f) * _e94);
        let _e104 = (_e90.x + (_e92.x * _e96));
        let _e106 = (_e90.y + (_e92.y * _e96));
        let _e108 = (_e90.z + (_e92.z * _e96));
        let _e110 = p.member.light.place;
        if (_e110.w == 0f) {
            phi_247_ = 300000000000000000000000000000000000000f;
        } else {
            phi_247_ = 1f;
        }
        let _e114 = phi_247_;
        let _e122 = (_e110.x - (_e104 * _e110.w));
        let _e123 = (_e110.y - (_e106 * _e110.w));
        let _e124 = (_e110.z - (_e108 * _e110.w));
        let _e129 = abs(_e122);
        let _e130 = abs(_e123);
        let _e131 = abs(_e124);
        if (abs(_e104) < 1000000000000000f) {
            if (abs(_e106) < 1000000000000000f) {
                if (abs(_e108) < 1000000000000000f) {
                    if (_e129 < 1000000000000000f) {
                        if (_e130 < 1000000000000000f) {
                            if (_e131 < 1000000000000000f) {
                                if (_e129 > 0f) {
                                    phi_303_ = bool();
                                    phi_304_ = true;
                                } else {
                                    let _e139 = (_e130 > 0f);
                                    if _e139 {
                                        phi_302_ = bool();
                                    } else {
                                        phi_302_ = (_e131 > 0f);
                                    }
                                    let _e142 = phi_302_;
                                    phi_303_ = _e142;
                                    phi_304_ = _e139;
                                }
                                let _e144 = phi_303_;
                                let _e146 = phi_304_;
                                if _e146 {
                                    phi_308_ = true;
                                } else {
                                    phi_308_ = _e144;
                                }
                                let _e148 = phi_308_;
                                phi_309_ = _e148;
                                phi_310_ = false;
                            } else {
                                phi_309_ = bool();
                                phi_310_ = true;
                            }
                            let _e150 = phi_309_;
                            let _e152 = phi_310_;
                            phi_311_ = _e150;
                            phi_312_ = false;
                            phi_313_ = _e152;
                        } else {
                            phi_311_ = bool();
                            phi_312_ = true;
                            phi_313_ = false;
                        }
                        let _e154 = phi_311_;
                        let _e156 = phi_312_;
                        let _e158 = phi_313_;
                        phi_314_ = _e154;
                        phi_315_ = _e156;
                        phi_316_ = _e158;
                    } else {
                        phi_314_ = bool();
                        phi_315_ = true;
                        phi_316_ = false;
                    }
                    let _e160 = phi_314_;
                    let _e162 = phi_315_;
                    let _e164 = phi_316_;
                    phi_317_ = _e160;
                    phi_318_ = _e162;
                    phi_319_ = _e164;
                } else {
                    phi_317_ = bool();
                    phi_318_ = true;
                    phi_319_ = false;
                }
                let _e166 = phi_317_;
                let _e168 = phi_318_;
                let _e170 = phi_319_;
                phi_320_ = _e166;
                phi_321_ = _e168;
                phi_322_ = _e170;
            } else {
                phi_320_ = bool();
                phi_321_ = true;
                phi_322_ = false;
            }
            let _e172 = phi_320_;
            let _e174 = phi_321_;
            let _e176 = phi_322_;
            phi_323_ = _e172;
            phi_324_ = _e174;
            phi_325_ = _e176;
        } else {
            phi_323_ = bool();
            phi_324_ = true;
            phi_325_ = false;
        }
        let _e178 = phi_323_;
        let _e180 = phi_324_;
        let _e182 = phi_325_;
        if _e180 {
            phi_329_ = true;
        } else {
            phi_329_ = _e182;
        }
        let _e184 = phi_329_;
        if _e184 {
            phi_333_ = false;
        } else {
            phi_333_ = _e178;
        }
        let _e186 = phi_333_;
        if _e186 {
            let _e187 = (0u >= _e59);
            if _e187 {
                phi_1705_ = bool();
            } else {
                if (0u < _e59) {
                } else {
                    return;
                }
                let _e193 = nodes.member[(0u + 0u)].frame[0u];
                let _e197 = nodes.member[(0u + 0u)].frame[1u];
                let _e201 = nodes.member[(0u + 0u)].frame[2u];
                let _e205 = nodes.member[(0u + 0u)].frame[0u];
                let _e209 = nodes.member[(0u + 0u)].frame[1u];
                let _e213 = nodes.member[(0u + 0u)].frame[2u];
                let _e217 = nodes.member[(0u + 0u)].frame[3u];
                let _e251 = core_intrinsics_maximum_number_nsz_f32_(abs(_e122), abs(_e123));
                let _e252 = core_intrinsics_maximum_number_nsz_f32_(_e251, abs(_e124));
                let _e253 = (_e252 * 0.0000000000009094947f);
                if (abs(_e122) < _e253) {
                    phi_403_ = _e253;
                } else {
                    phi_403_ = abs(_e122);
                }
                let _e258 = phi_403_;
                if (_e122 < 0f) {
                    phi_410_ = (-1f / _e258);
                } else {
                    phi_410_ = (1f / _e258);
                }
                let _e263 = phi_410_;
                if (abs(_e123) < _e253) {
                    phi_417_ = _e253;
                } else {
                    phi_417_ = abs(_e123);
                }
                let _e268 = phi_417_;
                if (_e123 < 0f) {
                    phi_424_ = (-1f / _e268);
                } else {
                    phi_424_ = (1f / _e268);
                }
                let _e273 = phi_424_;
                if (abs(_e124) < _e253) {
                    phi_431_ = _e253;
                } else {
                    phi_431_ = abs(_e124);
                }
                let _e278 = phi_431_;
                if (_e124 < 0f) {
                    phi_438_ = (-1f / _e278);
                } else {
                    phi_438_ = (1f / _e278);
                }
                let _e283 = phi_438_;
                let _e287 = abs((bitcast<f32>(_e193) - _e104));
                let _e288 = abs((bitcast<f32>(_e197) - _e106));
                let _e289 = abs((bitcast<f32>(_e201) - _e108));
                let _e293 = abs(((bitcast<f32>(_e205) + (bitcast<f32>((((_e217 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e104));
                let _e294 = abs(((bitcast<f32>(_e209) + (bitcast<f32>((((_e217 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e106));
                let _e295 = abs(((bitcast<f32>(_e213) + (bitcast<f32>((((_e217 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e108));
                if (_e287 > _e293) {
                    phi_455_ = _e287;
                } else {
                    phi_455_ = _e293;
                }
                let _e298 = phi_455_;
                if (_e288 > _e294) {
                    phi_460_ = _e288;
                } else {
                    phi_460_ = _e294;
                }
                let _e301 = phi_460_;
                if (_e289 > _e295) {
                    phi_465_ = _e289;
                } else {
                    phi_465_ = _e295;
                }
                let _e304 = phi_465_;
                let _e305 = core_intrinsics_maximum_number_nsz_f32_(_e298, _e301);
                let _e306 = core_intrinsics_maximum_number_nsz_f32_(_e305, _e304);
                let _e310 = (_e306 * 0.0000019073486f);
                let _e311 = (abs(_e263) * _e310);
                let _e312 = (abs(_e273) * _e310);
                let _e313 = (abs(_e283) * _e310);
                let _e317 = (_e306 * 0.0000009536743f);
                let _e318 = (abs(_e263) * _e317);
                let _e319 = (abs(_e273) * _e317);
                let _e320 = (abs(_e283) * _e317);
                let _e321 = abs(_e122);
                let _e322 = abs(_e123);
                let _e323 = abs(_e124);
                if (_e321 >= _e322) {
                    if (_e321 >= _e323) {
                        phi_493_ = false;
                    } else {
                        phi_493_ = true;
                    }
                    let _e327 = phi_493_;
                    phi_494_ = _e327;
                } else {
                    phi_494_ = true;
                }
                let _e329 = phi_494_;
                if _e329 {
                    if (_e322 >= _e323) {
                        phi_502_ = 1u;
                    } else {
                        phi_502_ = 2u;
                    }
                    let _e332 = phi_502_;
                    phi_503_ = _e332;
                } else {
                    phi_503_ = 0u;
                }
                let _e334 = phi_503_;
                if (_e334 == 0u) {
                    phi_515_ = vec3<f32>(_e123, _e124, _e122);
                } else {
                    if (_e334 == 1u) {
                        phi_514_ = vec3<f32>(_e124, _e122, _e123);
                    } else {
                        phi_514_ = vec3<f32>(_e122, _e123, _e124);
                    }
                    let _e340 = phi_514_;
                    phi_515_ = _e340;
                }
                let _e342 = phi_515_;
                let _e345 = (_e342.x / _e342.z);
                let _e348 = (_e342.y / _e342.z);
                if (_e263 < 0f) {
                    phi_528_ = 0u;
                } else {
                    phi_528_ = 1u;
                }
                let _e353 = phi_528_;
                if (_e273 < 0f) {
                    phi_533_ = 0u;
                } else {
                    phi_533_ = 2u;
                }
                let _e356 = phi_533_;
                if (_e283 < 0f) {
                    phi_538_ = 0u;
                } else {
                    phi_538_ = 4u;
                }
                let _e359 = phi_538_;
                let _e361 = ((_e353 | _e356) | _e359);
                let _e362 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e362.first[0], _e362.first[1], _e362.first[2], _e362.first[3], _e362.first[4], _e362.first[5], _e362.first[6], _e362.first[7], _e362.first[8], _e362.first[9], _e362.first[10], _e362.first[11], _e362.first[12], _e362.first[13], _e362.first[14], _e362.first[15], _e362.first[16], _e362.first[17], _e362.first[18], _e362.first[19], _e362.first[20], _e362.first[21], _e362.first[22], _e362.first[23], _e362.first[24], _e362.first[25], _e362.first[26], _e362.first[27], _e362.first[28], _e362.first[29], _e362.first[30], _e362.first[31]), array<u32, 32>(_e362.mask[0], _e362.mask[1], _e362.mask[2], _e362.mask[3], _e362.mask[4], _e362.mask[5], _e362.mask[6], _e362.mask[7], _e362.mask[8], _e362.mask[9], _e362.mask[10], _e362.mask[11], _e362.mask[12], _e362.mask[13], _e362.mask[14], _e362.mask[15], _e362.mask[16], _e362.mask[17], _e362.mask[18], _e362.mask[19], _e362.mask[20], _e362.mask[21], _e362.mask[22], _e362.mask[23], _e362.mask[24], _e362.mask[25], _e362.mask[26], _e362.mask[27], _e362.mask[28], _e362.mask[29], _e362.mask[30], _e362.mask[31]), _e362.len, _e362.group, _e362.group_mask);
                let _e436 = local.group_mask;
                if ((_e436 & 4278190080u) == 0u) {
                    let _e440 = local.len;
                    if (_e440 == 0u) {
                        phi_652_ = false;
                    } else {
                        let _e444 = local.len;
                        local.len = (_e444 - 1u);
                        let _e447 = local.len;
                        if (_e447 < 32u) {
                        } else {
                            return;
                        }
                        let _e452 = local.first[(0u + _e447)];
                        local.group = _e452;
                        let _e455 = local.len;
                        if (_e455 < 32u) {
                        } else {
                            return;
                        }
                        let _e460 = local.mask[(0u + _e455)];
                        local.group_mask = _e460;
                        phi_652_ = true;
                    }
                    let _e463 = phi_652_;
                    phi_653_ = _e463;
                } else {
                    phi_653_ = true;
                }
                let _e465 = phi_653_;
                if _e465 {
                    let _e467 = local.group_mask;
                    let _e473 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e467)), 32u, (_e467 == 0u)));
                    let _e477 = local.group_mask;
                    let _e491 = local.group_mask;
                    local.group_mask = (_e491 & ~((1u << bitcast<u32>((_e473 & 31u)))));
                    let _e494 = local.group;
                    phi_684_ = (_e494 + countOneBits(((_e477 & ~((4294967295u << bitcast<u32>((((_e473 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_684_ = 4294967295u;
                }
                let _e497 = phi_684_;
                phi_686_ = _e497;
                phi_689_ = false;
                loop {
                    let _e499 = phi_686_;
                    let _e501 = phi_689_;
                    local_8 = _e501;
                    if (_e499 != 4294967295u) {
                        if (_e499 < _e59) {
                        } else {
                            return;
                        }
                        let _e508 = nodes.member[(0u + _e499)].frame[3u];
                        let _e533 = (bitcast<f32>((((_e508 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e263);
                        let _e534 = (bitcast<f32>((((_e508 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e273);
                        let _e535 = (bitcast<f32>((((_e508 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e283);
                        let _e538 = nodes.member[(0u + _e499)].frame[0u];
                        let _e542 = nodes.member[(0u + _e499)].frame[1u];
                        let _e546 = nodes.member[(0u + _e499)].frame[2u];
                        let _e551 = ((bitcast<f32>(_e538) - _e104) * _e263);
                        let _e552 = ((bitcast<f32>(_e542) - _e106) * _e273);
                        let _e553 = ((bitcast<f32>(_e546) - _e108) * _e283);
                        let _e561 = nodes.member[(0u + _e499)].x;
                        if (_e263 < 0f) {
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e561.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e572.unnamed.root, _e561.w), _e572.unnamed_1);
                            let _e584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_bvh_traverse_Tree(_e561.x, _e578.unnamed_1.first_primitive));
                            phi_769_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e584.unnamed, lt_bvh_traverse_Tree(_e584.unnamed_1.root, _e561.y));
                        } else {
                            let _e600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e561.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e600.unnamed.root, _e561.y), _e600.unnamed_1);
                            let _e612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e606.unnamed, lt_bvh_traverse_Tree(_e561.z, _e606.unnamed_1.first_primitive));
                            phi_769_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e612.unnamed, lt_bvh_traverse_Tree(_e612.unnamed_1.root, _e561.w));
                        }
                        let _e620 = phi_769_;
                        let _e630 = nodes.member[(0u + _e499)].y;
                        if (_e273 < 0f) {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e630.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.unnamed.root, _e630.w), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e630.x, _e647.unnamed_1.first_primitive));
                            phi_796_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e653.unnamed_1.root, _e630.y));
                        } else {
                            let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e669.unnamed.root, _e630.y), _e669.unnamed_1);
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e675.unnamed, lt_bvh_traverse_Tree(_e630.z, _e675.unnamed_1.first_primitive));
                            phi_796_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e681.unnamed, lt_bvh_traverse_Tree(_e681.unnamed_1.root, _e630.w));
                        }
                        let _e689 = phi_796_;
                        let _e699 = nodes.member[(0u + _e499)].z;
                        if (_e283 < 0f) {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.unnamed.root, _e699.w), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e699.x, _e716.unnamed_1.first_primitive));
                            phi_823_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e722.unnamed_1.root, _e699.y));
                        } else {
                            let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e744 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e738.unnamed.root, _e699.y), _e738.unnamed_1);
                            let _e750 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e744.unnamed, lt_bvh_traverse_Tree(_e699.z, _e744.unnamed_1.first_primitive));
                            phi_823_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e750.unnamed, lt_bvh_traverse_Tree(_e750.unnamed_1.root, _e699.w));
                        }
                        let _e758 = phi_823_;
                        phi_829_ = 0u;
                        phi_832_ = 0u;
                        loop {
                            let _e768 = phi_829_;
                            let _e770 = phi_832_;
                            local_1 = _e770;
                            local_2 = _e770;
                            local_3 = _e770;
                            let _e771 = (_e768 < 8u);
                            if _e771 {
                                let _e773 = (_e768 >> bitcast<u32>(2i));
                                let _e774 = (_e768 & 3u);
                                if (_e773 == 0u) {
                                    phi_846_ = _e620.unnamed.root;
                                } else {
                                    phi_846_ = _e620.unnamed.first_primitive;
                                }
                                let _e777 = phi_846_;
                                if (_e773 == 0u) {
                                    phi_856_ = _e689.unnamed.root;
                                } else {
                                    phi_856_ = _e689.unnamed.first_primitive;
                                }
                                let _e786 = phi_856_;
                                if (_e773 == 0u) {
                                    phi_866_ = _e758.unnamed.root;
                                } else {
                                    phi_866_ = _e758.unnamed.first_primitive;
                                }
                                let _e795 = phi_866_;
                                let _e808 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e777 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e311)), ((f32(((_e786 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e534) + (_e552 - _e312)));
                                let _e809 = core_intrinsics_maximum_number_nsz_f32_(_e808, ((f32(((_e795 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e535) + (_e553 - _e313)));
                                if (_e773 == 0u) {
                                    phi_884_ = _e620.unnamed_1.root;
                                } else {
                                    phi_884_ = _e620.unnamed_1.first_primitive;
                                }
                                let _e812 = phi_884_;
                                if (_e773 == 0u) {
                                    phi_894_ = _e689.unnamed_1.root;
                                } else {
                                    phi_894_ = _e689.unnamed_1.first_primitive;
                                }
                                let _e821 = phi_894_;
                                if (_e773 == 0u) {
                                    phi_904_ = _e758.unnamed_1.root;
                                } else {
                                    phi_904_ = _e758.unnamed_1.first_primitive;
                                }
                                let _e830 = phi_904_;
                                let _e843 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e812 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e311)), ((f32(((_e821 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e534) + (_e552 + _e312)));
                                let _e844 = core_intrinsics_minimum_number_nsz_f32_(_e843, ((f32(((_e830 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u)) * _e535) + (_e553 + _e313)));
                                if (_e809 <= _e844) {
                                    if (_e809 <= _e114) {
                                        if (_e844 >= 0f) {
                                            if (_e773 == 0u) {
                                                let _e851 = nodes.member[(0u + _e499)].links[2u];
                                                phi_940_ = _e851;
                                            } else {
                                                let _e854 = nodes.member[(0u + _e499)].links[3u];
                                                phi_940_ = _e854;
                                            }
                                            let _e856 = phi_940_;
                                            let _e861 = ((_e856 >> bitcast<u32>(((_e774 * 8u) & 31u))) & 255u);
                                            let _e862 = (_e861 & 31u);
                                            if (_e862 >= 24u) {
                                                phi_953_ = (24u + ((_e862 - 24u) ^ _e361));
                                            } else {
                                                phi_953_ = _e862;
                                            }
                                            let _e868 = phi_953_;
                                            phi_958_ = (_e770 | ((_e861 >> bitcast<u32>(5i)) << bitcast<u32>((_e868 & 31u))));
                                        } else {
                                            phi_958_ = _e770;
                                        }
                                        let _e876 = phi_958_;
                                        phi_959_ = _e876;
                                    } else {
                                        phi_959_ = _e770;
                                    }
                                    let _e878 = phi_959_;
                                    phi_960_ = _e878;
                                } else {
                                    phi_960_ = _e770;
                                }
                                let _e880 = phi_960_;
                                phi_830_ = (_e768 + 1u);
                                phi_833_ = _e880;
                            } else {
                                phi_830_ = u32();
                                phi_833_ = u32();
                            }
                            let _e883 = phi_830_;
                            let _e885 = phi_833_;
                            continue;
                            continuing {
                                phi_829_ = _e883;
                                phi_832_ = _e885;
                                break if !(_e771);
                            }
                        }
                        let _e889 = nodes.member[(0u + _e499)].links[0u];
                        let _e893 = nodes.member[(0u + _e499)].frame[3u];
                        let _e897 = local_1;
                        if ((_e897 & 4278190080u) == 0u) {
                        } else {
                            let _e901 = local.group_mask;
                            if ((_e901 & 4278190080u) == 0u) {
                            } else {
                                let _e905 = local.len;
                                if (_e905 < 32u) {
                                    let _e908 = local.group;
                                    let _e910 = local.len;
                                    if (_e910 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e910)] = _e908;
                                    let _e916 = local.group_mask;
                                    let _e918 = local.len;
                                    if (_e918 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e918)] = _e916;
                                    let _e925 = local.len;
                                    local.len = (_e925 + 1u);
                                }
                            }
                            local.group = (0u + _e889);
                            let _e929 = local_2;
                            local.group_mask = ((_e929 & 4278190080u) | (_e893 >> bitcast<u32>(24i)));
                        }
                        let _e934 = local_3;
                        phi_1018_ = (_e934 & 16777215u);
                        phi_1021_ = _e501;
                        loop {
                            let _e937 = phi_1018_;
                            let _e939 = phi_1021_;
                            local_6 = _e939;
                            let _e940 = (_e937 == 0u);
                            local_4 = _e940;
                            local_7 = _e940;
                            if _e940 {
                                phi_1019_ = u32();
                                phi_1022_ = bool();
                                phi_1619_ = false;
                            } else {
                                let _e943 = nodes.member[(0u + _e499)].links[1u];
                                let _e948 = ((0u + _e943) + select(firstTrailingBit(_e937), 32u, (_e937 == 0u)));
                                if (_e948 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e955 = triangles.member[(0u + _e948)].v0_;
                                let _e957 = (_e955.x - _e104);
                                let _e959 = (_e955.y - _e106);
                                let _e961 = (_e955.z - _e108);
                                if (_e334 == 0u) {
                                    phi_1066_ = vec3<f32>(_e959, _e961, _e957);
                                } else {
                                    if (_e334 == 1u) {
                                        phi_1065_ = vec3<f32>(_e961, _e957, _e959);
                                    } else {
                                        phi_1065_ = (_e955 - vec3<f32>(_e104, _e106, _e108));
                                    }
                                    let _e969 = phi_1065_;
                                    phi_1066_ = _e969;
                                }
                                let _e971 = phi_1066_;
                                let _e975 = (_e971.x - (_e345 * _e971.z));
                                let _e979 = (_e971.y - (_e348 * _e971.z));
                                let _e981 = triangles.member[(0u + _e948)].v1_;
                                let _e983 = (_e981.x - _e104);
                                let _e985 = (_e981.y - _e106);
                                let _e987 = (_e981.z - _e108);
                                if (_e334 == 0u) {
                                    phi_1096_ = vec3<f32>(_e985, _e987, _e983);
                                } else {
                                    if (_e334 == 1u) {
                                        phi_1095_ = vec3<f32>(_e987, _e983, _e985);
                                    } else {
                                        phi_1095_ = (_e981 - vec3<f32>(_e104, _e106, _e108));
                                    }
                                    let _e995 = phi_1095_;
                                    phi_1096_ = _e995;
                                }
                                let _e997 = phi_1096_;
                                let _e1001 = (_e997.x - (_e345 * _e997.z));
                                let _e1005 = (_e997.y - (_e348 * _e997.z));
                                let _e1007 = triangles.member[(0u + _e948)].v2_;
                                let _e1009 = (_e1007.x - _e104);
                                let _e1011 = (_e1007.y - _e106);
                                let _e1013 = (_e1007.z - _e108);
                                if (_e334 == 0u) {
                                    phi_1126_ = vec3<f32>(_e1011, _e1013, _e1009);
                                } else {
                                    if (_e334 == 1u) {
                                        phi_1125_ = vec3<f32>(_e1013, _e1009, _e1011);
                                    } else {
                                        phi_1125_ = (_e1007 - vec3<f32>(_e104, _e106, _e108));
                                    }
                                    let _e1021 = phi_1125_;
                                    phi_1126_ = _e1021;
                                }
                                let _e1023 = phi_1126_;
                                let _e1027 = (_e1023.x - (_e345 * _e1023.z));
                                let _e1031 = (_e1023.y - (_e348 * _e1023.z));
                                if (_e1001 < _e1027) {
                                    phi_1145_ = true;
                                } else {
                                    if (_e1001 == _e1027) {
                                        phi_1144_ = (_e1005 < _e1031);
                                    } else {
                                        phi_1144_ = false;
                                    }
                                    let _e1036 = phi_1144_;
                                    phi_1145_ = _e1036;
                                }
                                let _e1038 = phi_1145_;
                                if _e1038 {
                                    phi_1149_ = _e1031;
                                    phi_1150_ = _e1027;
                                    phi_1151_ = _e1005;
                                    phi_1152_ = _e1001;
                                } else {
                                    phi_1149_ = _e1005;
                                    phi_1150_ = _e1001;
                                    phi_1151_ = _e1031;
                                    phi_1152_ = _e1027;
                                }
                                let _e1040 = phi_1149_;
                                let _e1042 = phi_1150_;
                                let _e1044 = phi_1151_;
                                let _e1046 = phi_1152_;
                                let _e1049 = ((_e1046 * _e1040) - (_e1044 * _e1042));
                                if _e1038 {
                                    phi_1160_ = -(_e1049);
                                } else {
                                    phi_1160_ = _e1049;
                                }
                                let _e1052 = phi_1160_;
                                if (_e1027 < _e975) {
                                    phi_1171_ = true;
                                } else {
                                    if (_e1027 == _e975) {
                                        phi_1170_ = (_e1031 < _e979);
                                    } else {
                                        phi_1170_ = false;
                                    }
                                    let _e1057 = phi_1170_;
                                    phi_1171_ = _e1057;
                                }
                                let _e1059 = phi_1171_;
                                if _e1059 {
                                    phi_1175_ = _e979;
                                    phi_1176_ = _e975;
                                    phi_1177_ = _e1031;
                                    phi_1178_ = _e1027;
                                } else {
                                    phi_1175_ = _e1031;
                                    phi_1176_ = _e1027;
                                    phi_1177_ = _e979;
                                    phi_1178_ = _e975;
                                }
                                let _e1061 = phi_1175_;
                                let _e1063 = phi_1176_;
                                let _e1065 = phi_1177_;
                                let _e1067 = phi_1178_;
                                let _e1070 = ((_e1067 * _e1061) - (_e1065 * _e1063));
                                if _e1059 {
                                    phi_1186_ = -(_e1070);
                                } else {
                                    phi_1186_ = _e1070;
                                }
                                let _e1073 = phi_1186_;
                                if (_e975 < _e1001) {
                                    phi_1197_ = true;
                                } else {
                                    if (_e975 == _e1001) {
                                        phi_1196_ = (_e979 < _e1005);
                                    } else {
                                        phi_1196_ = false;
                                    }
                                    let _e1078 = phi_1196_;
                                    phi_1197_ = _e1078;
                                }
                                let _e1080 = phi_1197_;
                                if _e1080 {
                                    phi_1201_ = _e1005;
                                    phi_1202_ = _e1001;
                                    phi_1203_ = _e979;
                                    phi_1204_ = _e975;
                                } else {
                                    phi_1201_ = _e979;
                                    phi_1202_ = _e975;
                                    phi_1203_ = _e1005;
                                    phi_1204_ = _e1001;
                                }
                                let _e1082 = phi_1201_;
                                let _e1084 = phi_1202_;
                                let _e1086 = phi_1203_;
                                let _e1088 = phi_1204_;
                                let _e1091 = ((_e1088 * _e1082) - (_e1086 * _e1084));
                                if _e1080 {
                                    phi_1212_ = -(_e1091);
                                } else {
                                    phi_1212_ = _e1091;
                                }
                                let _e1094 = phi_1212_;
                                if (_e1052 >= 0f) {
                                    if (_e1073 >= 0f) {
                                        if (_e1094 >= 0f) {
                                            phi_1227_ = ((_e1052 + _e1073) + _e1094);
                                            phi_1228_ = false;
                                        } else {
                                            phi_1227_ = f32();
                                            phi_1228_ = true;
                                        }
                                        let _e1101 = phi_1227_;
                                        let _e1103 = phi_1228_;
                                        phi_1229_ = _e1101;
                                        phi_1230_ = _e1103;
                                    } else {
                                        phi_1229_ = f32();
                                        phi_1230_ = true;
                                    }
                                    let _e1105 = phi_1229_;
                                    let _e1107 = phi_1230_;
                                    phi_1231_ = _e1105;
                                    phi_1232_ = _e1107;
                                } else {
                                    phi_1231_ = f32();
                                    phi_1232_ = true;
                                }
                                let _e1109 = phi_1231_;
                                let _e1111 = phi_1232_;
                                if _e1111 {
                                    if (_e1052 <= 0f) {
                                        if (_e1073 <= 0f) {
                                            let _e1114 = (_e1094 <= 0f);
                                            if _e1114 {
                                            }
                                            phi_1250_ = ((_e1052 + _e1073) + _e1094);
                                            phi_1251_ = false;
                                            phi_1252_ = _e1114;
                                        } else {
                                            phi_1250_ = f32();
                                            phi_1251_ = true;
                                            phi_1252_ = false;
                                        }
                                        let _e1118 = phi_1250_;
                                        let _e1120 = phi_1251_;
                                        let _e1122 = phi_1252_;
                                        phi_1253_ = _e1118;
                                        phi_1254_ = _e1120;
                                        phi_1255_ = _e1122;
                                    } else {
                                        phi_1253_ = f32();
                                        phi_1254_ = true;
                                        phi_1255_ = false;
                                    }
                                    let _e1124 = phi_1253_;
                                    let _e1126 = phi_1254_;
                                    let _e1128 = phi_1255_;
                                    if _e1126 {
                                        phi_1259_ = false;
                                    } else {
                                        phi_1259_ = _e1128;
                                    }
                                    let _e1130 = phi_1259_;
                                    phi_1260_ = _e1124;
                                    phi_1261_ = _e1130;
                                } else {
                                    phi_1260_ = _e1109;
                                    phi_1261_ = true;
                                }
                                let _e1132 = phi_1260_;
                                let _e1134 = phi_1261_;
                                if _e1134 {
                                    let _e1135 = (_e1132 == 0f);
                                    if _e1135 {
                                        phi_1577_ = lt_bvh_triangle_Intersection();
                                        phi_1578_ = false;
                                    } else {
                                        let _e1137 = triangles.member[(0u + _e948)].v0_;
                                        let _e1139 = (_e1137.x - _e104);
                                        let _e1141 = (_e1137.y - _e106);
                                        let _e1143 = (_e1137.z - _e108);
                                        if (_e334 == 0u) {
                                            phi_1290_ = vec3<f32>(_e1141, _e1143, _e1139);
                                        } else {
                                            if (_e334 == 1u) {
                                                phi_1289_ = vec3<f32>(_e1143, _e1139, _e1141);
                                            } else {
                                                phi_1289_ = (_e1137 - vec3<f32>(_e104, _e106, _e108));
                                            }
                                            let _e1151 = phi_1289_;
                                            phi_1290_ = _e1151;
                                        }
                                        let _e1153 = phi_1290_;
                                        let _e1155 = triangles.member[(0u + _e948)].v1_;
                                        let _e1157 = triangles.member[(0u + _e948)].v0_;
                                        let _e1160 = (_e1155.x - _e1157.x);
                                        let _e1163 = (_e1155.y - _e1157.y);
                                        let _e1166 = (_e1155.z - _e1157.z);
                                        if (_e334 == 0u) {
                                            phi_1316_ = vec3<f32>(_e1163, _e1166, _e1160);
                                        } else {
                                            if (_e334 == 1u) {
                                                phi_1315_ = vec3<f32>(_e1166, _e1160, _e1163);
                                            } else {
                                                phi_1315_ = (_e1155 - _e1157);
                                            }
                                            let _e1173 = phi_1315_;
                                            phi_1316_ = _e1173;
                                        }
                                        let _e1175 = phi_1316_;
                                        let _e1177 = triangles.member[(0u + _e948)].v2_;
                                        let _e1179 = triangles.member[(0u + _e948)].v0_;
                                        let _e1182 = (_e1177.x - _e1179.x);
                                        let _e1185 = (_e1177.y - _e1179.y);
                                        let _e1188 = (_e1177.z - _e1179.z);
                                        if (_e334 == 0u) {
                                            phi_1342_ = vec3<f32>(_e1185, _e1188, _e1182);
                                        } else {
                                            if (_e334 == 1u) {
                                                phi_1341_ = vec3<f32>(_e1188, _e1182, _e1185);
                                            } else {
                                                phi_1341_ = (_e1177 - _e1179);
                                            }
                                            let _e1195 = phi_1341_;
                                            phi_1342_ = _e1195;
                                        }
                                        let _e1197 = phi_1342_;
                                        let _e1204 = ((_e1175.y * _e1197.z) - (_e1175.z * _e1197.y));
                                        let _e1211 = ((_e1175.z * _e1197.x) - (_e1175.x * _e1197.z));
                                        let _e1218 = ((_e1175.x * _e1197.y) - (_e1175.y * _e1197.x));
                                        let _e1232 = (((1f / _e342.z) * (((_e1204 * _e1153.x) + (_e1211 * _e1153.y)) + (_e1218 * _e1153.z))) / (((_e1204 * _e345) + (_e1211 * _e348)) + _e1218));
                                        if (_e1232 > 0f) {
                                            if (_e1232 < _e114) {
                                                let _e1236 = triangles.member[(0u + _e948)].v0_;
                                                let _e1238 = triangles.member[(0u + _e948)].v1_;
                                                if (_e1236.x < _e1238.x) {
                                                    phi_1398_ = _e1236.x;
                                                } else {
                                                    phi_1398_ = _e1238.x;
                                                }
                                                let _e1245 = phi_1398_;
                                                if (_e1236.y < _e1238.y) {
                                                    phi_1407_ = _e1236.y;
                                                } else {
                                                    phi_1407_ = _e1238.y;
                                                }
                                                let _e1252 = phi_1407_;
                                                if (_e1236.z < _e1238.z) {
                                                    phi_1416_ = _e1236.z;
                                                } else {
                                                    phi_1416_ = _e1238.z;
                                                }
                                                let _e1259 = phi_1416_;
                                                let _e1261 = triangles.member[(0u + _e948)].v2_;
                                                if (_e1245 < _e1261.x) {
                                                    phi_1425_ = _e1245;
                                                } else {
                                                    phi_1425_ = _e1261.x;
                                                }
                                                let _e1266 = phi_1425_;
                                                if (_e1252 < _e1261.y) {
                                                    phi_1432_ = _e1252;
                                                } else {
                                                    phi_1432_ = _e1261.y;
                                                }
                                                let _e1271 = phi_1432_;
                                                if (_e1259 < _e1261.z) {
                                                    phi_1439_ = _e1259;
                                                } else {
                                                    phi_1439_ = _e1261.z;
                                                }
                                                let _e1276 = phi_1439_;
                                                let _e1278 = triangles.member[(0u + _e948)].v0_;
                                                let _e1280 = triangles.member[(0u + _e948)].v1_;
                                                if (_e1278.x > _e1280.x) {
                                                    phi_1452_ = _e1278.x;
                                                } else {
                                                    phi_1452_ = _e1280.x;
                                                }
                                                let _e1287 = phi_1452_;
                                                if (_e1278.y > _e1280.y) {
                                                    phi_1461_ = _e1278.y;
                                                } else {
                                                    phi_1461_ = _e1280.y;
                                                }
                                                let _e1294 = phi_1461_;
                                                if (_e1278.z > _e1280.z) {
                                                    phi_1470_ = _e1278.z;
                                                } else {
                                                    phi_1470_ = _e1280.z;
                                                }
                                                let _e1301 = phi_1470_;
                                                let _e1303 = triangles.member[(0u + _e948)].v2_;
                                                if (_e1287 > _e1303.x) {
                                                    phi_1479_ = _e1287;
                                                } else {
                                                    phi_1479_ = _e1303.x;
                                                }
                                                let _e1308 = phi_1479_;
                                                if (_e1294 > _e1303.y) {
                                                    phi_1486_ = _e1294;
                                                } else {
                                                    phi_1486_ = _e1303.y;
                                                }
                                                let _e1313 = phi_1486_;
                                                if (_e1301 > _e1303.z) {
                                                    phi_1493_ = _e1301;
                                                } else {
                                                    phi_1493_ = _e1303.z;
                                                }
                                                let _e1318 = phi_1493_;
                                                let _e1322 = ((_e1266 - _e104) * _e263);
                                                let _e1323 = ((_e1271 - _e106) * _e273);
                                                let _e1324 = ((_e1276 - _e108) * _e283);
                                                let _e1328 = ((_e1308 - _e104) * _e263);
                                                let _e1329 = ((_e1313 - _e106) * _e273);
                                                let _e1330 = ((_e1318 - _e108) * _e283);
                                                if (_e1322 < _e1328) {
                                                    phi_1510_ = _e1322;
                                                } else {
                                                    phi_1510_ = _e1328;
                                                }
                                                let _e1333 = phi_1510_;
                                                if (_e1323 < _e1329) {
                                                    phi_1515_ = _e1323;
                                                } else {
                                                    phi_1515_ = _e1329;
                                                }
                                                let _e1336 = phi_1515_;
                                                if (_e1324 < _e1330) {
                                                    phi_1520_ = _e1324;
                                                } else {
                                                    phi_1520_ = _e1330;
                                                }
                                                let _e1339 = phi_1520_;
                                                if (_e1322 > _e1328) {
                                                    phi_1528_ = _e1322;
                                                } else {
                                                    phi_1528_ = _e1328;
                                                }
                                                let _e1345 = phi_1528_;
                                                if (_e1323 > _e1329) {
                                                    phi_1533_ = _e1323;
                                                } else {
                                                    phi_1533_ = _e1329;
                                                }
                                                let _e1348 = phi_1533_;
                                                if (_e1324 > _e1330) {
                                                    phi_1538_ = _e1324;
                                                } else {
                                                    phi_1538_ = _e1330;
                                                }
                                                let _e1351 = phi_1538_;
                                                let _e1355 = core_intrinsics_maximum_number_nsz_f32_((_e1333 - _e318), (_e1336 - _e319));
                                                let _e1356 = core_intrinsics_maximum_number_nsz_f32_(_e1355, (_e1339 - _e320));
                                                let _e1357 = core_intrinsics_minimum_number_nsz_f32_((_e1345 + _e318), (_e1348 + _e319));
                                                let _e1358 = core_intrinsics_minimum_number_nsz_f32_(_e1357, (_e1351 + _e320));
                                                if (_e1356 > -300000000000000000000000000000000000000f) {
                                                    phi_1550_ = _e1356;
                                                } else {
                                                    phi_1550_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1361 = phi_1550_;
                                                if (_e1358 < 300000000000000000000000000000000000000f) {
                                                    phi_1555_ = _e1358;
                                                } else {
                                                    phi_1555_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1364 = phi_1555_;
                                                if (_e1232 < _e1361) {
                                                    phi_1560_ = _e1361;
                                                } else {
                                                    phi_1560_ = _e1232;
                                                }
                                                let _e1367 = phi_1560_;
                                                if (_e1367 > _e1364) {
                                                    phi_1565_ = _e1364;
                                                } else {
                                                    phi_1565_ = _e1367;
                                                }
                                                let _e1370 = phi_1565_;
                                                phi_1570_ = lt_bvh_triangle_Intersection(_e1370, (_e1073 / _e1132), (_e1094 / _e1132), (_e1361 <= _e1364));
                                                phi_1571_ = false;
                                            } else {
                                                phi_1570_ = lt_bvh_triangle_Intersection();
                                                phi_1571_ = true;
                                            }
                                            let _e1376 = phi_1570_;
                                            let _e1378 = phi_1571_;
                                            phi_1572_ = _e1376;
                                            phi_1573_ = _e1378;
                                        } else {
                                            phi_1572_ = lt_bvh_triangle_Intersection();
                                            phi_1573_ = true;
                                        }
                                        let _e1380 = phi_1572_;
                                        let _e1382 = phi_1573_;
                                        if _e1382 {
                                        }
                                        phi_1577_ = _e1380;
                                        phi_1578_ = _e1382;
                                    }
                                    let _e1384 = phi_1577_;
                                    let _e1386 = phi_1578_;
                                    phi_1579_ = _e1384;
                                    phi_1580_ = _e1135;
                                    phi_1581_ = _e1386;
                                } else {
                                    phi_1579_ = lt_bvh_triangle_Intersection();
                                    phi_1580_ = true;
                                    phi_1581_ = false;
                                }
                                let _e1388 = phi_1579_;
                                let _e1390 = phi_1580_;
                                let _e1392 = phi_1581_;
                                if _e1390 {
                                    phi_1585_ = true;
                                } else {
                                    phi_1585_ = _e1392;
                                }
                                let _e1394 = phi_1585_;
                                if _e1394 {
                                    phi_1589_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1589_ = _e1388;
                                }
                                let _e1396 = phi_1589_;
                                if _e1396.is_hit {
                                    if (_e1396.t > 0f) {
                                        if (_e1396.t < _e114) {
                                            if true {
                                                phi_1609_ = false;
                                            } else {
                                                phi_1609_ = true;
                                            }
                                            let _e1405 = phi_1609_;
                                            phi_1610_ = true;
                                            phi_1611_ = _e1405;
                                        } else {
                                            phi_1610_ = _e939;
                                            phi_1611_ = true;
                                        }
                                        let _e1407 = phi_1610_;
                                        let _e1409 = phi_1611_;
                                        phi_1612_ = _e1407;
                                        phi_1613_ = _e1409;
                                    } else {
                                        phi_1612_ = _e939;
                                        phi_1613_ = true;
                                    }
                                    let _e1411 = phi_1612_;
                                    let _e1413 = phi_1613_;
                                    phi_1614_ = _e1411;
                                    phi_1615_ = _e1413;
                                } else {
                                    phi_1614_ = _e939;
                                    phi_1615_ = true;
                                }
                                let _e1415 = phi_1614_;
                                let _e1417 = phi_1615_;
                                if _e1417 {
                                }
                                phi_1019_ = (_e937 & (_e937 - 1u));
                                phi_1022_ = _e1415;
                                phi_1619_ = _e1417;
                            }
                            let _e1419 = phi_1019_;
                            let _e1421 = phi_1022_;
                            let _e1423 = phi_1619_;
                            continue;
                            continuing {
                                phi_1018_ = _e1419;
                                phi_1021_ = _e1421;
                                break if !(_e1423);
                            }
                        }
                        let _e1426 = local_4;
                        if _e1426 {
                            let _e1428 = local.group_mask;
                            if ((_e1428 & 4278190080u) == 0u) {
                                let _e1432 = local.len;
                                if (_e1432 == 0u) {
                                    phi_1661_ = false;
                                } else {
                                    let _e1436 = local.len;
                                    local.len = (_e1436 - 1u);
                                    let _e1439 = local.len;
                                    if (_e1439 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1444 = local.first[(0u + _e1439)];
                                    local.group = _e1444;
                                    let _e1447 = local.len;
                                    if (_e1447 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1452 = local.mask[(0u + _e1447)];
                                    local.group_mask = _e1452;
                                    phi_1661_ = true;
                                }
                                let _e1455 = phi_1661_;
                                phi_1662_ = _e1455;
                            } else {
                                phi_1662_ = true;
                            }
                            let _e1457 = phi_1662_;
                            if _e1457 {
                                let _e1459 = local.group_mask;
                                let _e1465 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1459)), 32u, (_e1459 == 0u)));
                                let _e1469 = local.group_mask;
                                let _e1483 = local.group_mask;
                                local.group_mask = (_e1483 & ~((1u << bitcast<u32>((_e1465 & 31u)))));
                                let _e1486 = local.group;
                                phi_1693_ = (_e1486 + countOneBits(((_e1469 & ~((4294967295u << bitcast<u32>((((_e1465 - 24u) ^ _e361) & 31u))))) & 255u)));
                            } else {
                                phi_1693_ = 4294967295u;
                            }
                            let _e1489 = phi_1693_;
                            phi_1694_ = _e1489;
                        } else {
                            phi_1694_ = u32();
                        }
                        let _e1491 = phi_1694_;
                        phi_687_ = _e1491;
                        let _e1715 = local_6;
                        phi_690_ = _e1715;
                        let _e1718 = local_7;
                        phi_1695_ = _e1718;
                        phi_1696_ = false;
                    } else {
                        phi_687_ = u32();
                        phi_690_ = bool();
                        phi_1695_ = false;
                        phi_1696_ = true;
                    }
                    let _e1493 = phi_687_;
                    let _e1495 = phi_690_;
                    let _e1497 = phi_1695_;
                    let _e1499 = phi_1696_;
                    local_5 = _e1499;
                    continue;
                    continuing {
                        phi_686_ = _e1493;
                        phi_689_ = _e1495;
                        break if !(_e1497);
                    }
                }
                let _e1502 = local_5;
                if _e1502 {
                    phi_1700_ = false;
                } else {
                    phi_1700_ = true;
                }
                let _e1504 = phi_1700_;
                if _e1504 {
                    phi_1704_ = true;
                } else {
                    let _e1724 = local_8;
                    phi_1704_ = _e1724;
                }
                let _e1506 = phi_1704_;
                phi_1705_ = _e1506;
            }
            let _e1508 = phi_1705_;
            phi_1706_ = _e1508;
            phi_1707_ = _e187;
        } else {
            phi_1706_ = bool();
            phi_1707_ = true;
        }
        let _e1510 = phi_1706_;
        let _e1512 = phi_1707_;
        if _e1512 {
            phi_1711_ = false;
        } else {
            phi_1711_ = _e1510;
        }
        let _e1514 = phi_1711_;
        if _e1514 {
            phi_1715_ = 0f;
        } else {
            phi_1715_ = 1f;
        }
        let _e1516 = phi_1715_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        visibility.member[(0u + _e84)] = _e1516;
        if (_e84 < _e71) {
        } else {
            return;
        }
        let _e1523 = bits.member[(0u + _e84)];
        if ((_e1523 & 2u) == 0u) {
            phi_1736_ = (_e1523 & 1u);
        } else {
            phi_1736_ = (_e1523 & 7u);
        }
        let _e1529 = phi_1736_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        let _e1533 = visibility.member[(0u + _e84)];
        if ((_e1529 & 1u) != 0u) {
            phi_1751_ = (2u | 1u);
        } else {
            phi_1751_ = 2u;
        }
        let _e1539 = phi_1751_;
        if (_e1533 < 0.5f) {
            phi_1756_ = (_e1539 | 4u);
        } else {
            phi_1756_ = _e1539;
        }
        let _e1542 = phi_1756_;
        if (_e84 < _e71) {
        } else {
            return;
        }
        bits.member[(0u + _e84)] = _e1542;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
