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
    var phi_767_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_794_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_821_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_827_: u32;
    var phi_830_: u32;
    var phi_844_: u32;
    var phi_854_: u32;
    var phi_864_: u32;
    var phi_882_: u32;
    var phi_892_: u32;
    var phi_902_: u32;
    var phi_938_: u32;
    var phi_951_: u32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_958_: u32;
    var phi_828_: u32;
    var phi_831_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1016_: u32;
    var phi_1061_: vec3<f32>;
    var phi_1062_: vec3<f32>;
    var phi_1091_: vec3<f32>;
    var phi_1092_: vec3<f32>;
    var phi_1121_: vec3<f32>;
    var phi_1122_: vec3<f32>;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1145_: f32;
    var phi_1146_: f32;
    var phi_1147_: f32;
    var phi_1148_: f32;
    var phi_1156_: f32;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1171_: f32;
    var phi_1172_: f32;
    var phi_1173_: f32;
    var phi_1174_: f32;
    var phi_1182_: f32;
    var phi_1192_: bool;
    var phi_1193_: bool;
    var phi_1197_: f32;
    var phi_1198_: f32;
    var phi_1199_: f32;
    var phi_1200_: f32;
    var phi_1208_: f32;
    var phi_1223_: f32;
    var phi_1224_: bool;
    var phi_1225_: f32;
    var phi_1226_: bool;
    var phi_1227_: f32;
    var phi_1228_: bool;
    var phi_1246_: f32;
    var phi_1247_: bool;
    var phi_1248_: bool;
    var phi_1249_: f32;
    var phi_1250_: bool;
    var phi_1251_: bool;
    var phi_1255_: bool;
    var phi_1256_: f32;
    var phi_1257_: bool;
    var phi_1285_: vec3<f32>;
    var phi_1286_: vec3<f32>;
    var phi_1311_: vec3<f32>;
    var phi_1312_: vec3<f32>;
    var phi_1337_: vec3<f32>;
    var phi_1338_: vec3<f32>;
    var phi_1394_: f32;
    var phi_1403_: f32;
    var phi_1412_: f32;
    var phi_1421_: f32;
    var phi_1428_: f32;
    var phi_1435_: f32;
    var phi_1448_: f32;
    var phi_1457_: f32;
    var phi_1466_: f32;
    var phi_1475_: f32;
    var phi_1482_: f32;
    var phi_1489_: f32;
    var phi_1506_: f32;
    var phi_1511_: f32;
    var phi_1516_: f32;
    var phi_1524_: f32;
    var phi_1529_: f32;
    var phi_1534_: f32;
    var phi_1546_: f32;
    var phi_1551_: f32;
    var phi_1556_: f32;
    var phi_1561_: f32;
    var phi_1566_: lt_bvh_triangle_Intersection;
    var phi_1567_: bool;
    var phi_1568_: lt_bvh_triangle_Intersection;
    var phi_1569_: bool;
    var phi_1573_: lt_bvh_triangle_Intersection;
    var phi_1574_: bool;
    var phi_1575_: lt_bvh_triangle_Intersection;
    var phi_1576_: bool;
    var phi_1577_: bool;
    var phi_1581_: bool;
    var phi_1585_: lt_bvh_triangle_Intersection;
    var phi_1610_: bool;
    var phi_1611_: bool;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1621_: bool;
    var phi_1625_: bool;
    var phi_1626_: bool;
    var phi_1017_: u32;
    var phi_1627_: bool;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var local_4: bool;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1703_: u32;
    var phi_1704_: u32;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_687_: u32;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var local_5: bool;
    var phi_1714_: bool;
    var phi_1715_: bool;
    var phi_1719_: bool;
    var phi_1723_: bool;
    var phi_1724_: bool;
    var phi_1725_: bool;
    var phi_1726_: bool;
    var phi_1730_: bool;
    var phi_1734_: f32;
    var phi_1755_: u32;
    var phi_1770_: u32;
    var phi_1775_: u32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;

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
                phi_1724_ = bool();
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
                loop {
                    let _e499 = phi_686_;
                    if (_e499 != 4294967295u) {
                        if (_e499 < _e59) {
                        } else {
                            return;
                        }
                        let _e506 = nodes.member[(0u + _e499)].frame[3u];
                        let _e531 = (bitcast<f32>((((_e506 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e263);
                        let _e532 = (bitcast<f32>((((_e506 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e273);
                        let _e533 = (bitcast<f32>((((_e506 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e283);
                        let _e536 = nodes.member[(0u + _e499)].frame[0u];
                        let _e540 = nodes.member[(0u + _e499)].frame[1u];
                        let _e544 = nodes.member[(0u + _e499)].frame[2u];
                        let _e549 = ((bitcast<f32>(_e536) - _e104) * _e263);
                        let _e550 = ((bitcast<f32>(_e540) - _e106) * _e273);
                        let _e551 = ((bitcast<f32>(_e544) - _e108) * _e283);
                        let _e559 = nodes.member[(0u + _e499)].x;
                        if (_e263 < 0f) {
                            let _e570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e570.unnamed.root, _e559.w), _e570.unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e559.x, _e576.unnamed_1.first_primitive));
                            phi_767_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e582.unnamed_1.root, _e559.y));
                        } else {
                            let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e559.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e598.unnamed.root, _e559.y), _e598.unnamed_1);
                            let _e610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e604.unnamed, lt_bvh_traverse_Tree(_e559.z, _e604.unnamed_1.first_primitive));
                            phi_767_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e610.unnamed, lt_bvh_traverse_Tree(_e610.unnamed_1.root, _e559.w));
                        }
                        let _e618 = phi_767_;
                        let _e628 = nodes.member[(0u + _e499)].y;
                        if (_e273 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e628.x, _e645.unnamed_1.first_primitive));
                            phi_794_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e628.z, _e673.unnamed_1.first_primitive));
                            phi_794_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e628.w));
                        }
                        let _e687 = phi_794_;
                        let _e697 = nodes.member[(0u + _e499)].z;
                        if (_e283 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e697.x, _e714.unnamed_1.first_primitive));
                            phi_821_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e697.z, _e742.unnamed_1.first_primitive));
                            phi_821_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e697.w));
                        }
                        let _e756 = phi_821_;
                        phi_827_ = 0u;
                        phi_830_ = 0u;
                        loop {
                            let _e766 = phi_827_;
                            let _e768 = phi_830_;
                            local_1 = _e768;
                            local_2 = _e768;
                            local_3 = _e768;
                            let _e769 = (_e766 < 8u);
                            if _e769 {
                                let _e771 = (_e766 >> bitcast<u32>(2i));
                                let _e772 = (_e766 & 3u);
                                if (_e771 == 0u) {
                                    phi_844_ = _e618.unnamed.root;
                                } else {
                                    phi_844_ = _e618.unnamed.first_primitive;
                                }
                                let _e775 = phi_844_;
                                if (_e771 == 0u) {
                                    phi_854_ = _e687.unnamed.root;
                                } else {
                                    phi_854_ = _e687.unnamed.first_primitive;
                                }
                                let _e784 = phi_854_;
                                if (_e771 == 0u) {
                                    phi_864_ = _e756.unnamed.root;
                                } else {
                                    phi_864_ = _e756.unnamed.first_primitive;
                                }
                                let _e793 = phi_864_;
                                let _e806 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e775 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 - _e311)), ((f32(((_e784 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 - _e312)));
                                let _e807 = core_intrinsics_maximum_number_nsz_f32_(_e806, ((f32(((_e793 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 - _e313)));
                                if (_e771 == 0u) {
                                    phi_882_ = _e618.unnamed_1.root;
                                } else {
                                    phi_882_ = _e618.unnamed_1.first_primitive;
                                }
                                let _e810 = phi_882_;
                                if (_e771 == 0u) {
                                    phi_892_ = _e687.unnamed_1.root;
                                } else {
                                    phi_892_ = _e687.unnamed_1.first_primitive;
                                }
                                let _e819 = phi_892_;
                                if (_e771 == 0u) {
                                    phi_902_ = _e756.unnamed_1.root;
                                } else {
                                    phi_902_ = _e756.unnamed_1.first_primitive;
                                }
                                let _e828 = phi_902_;
                                let _e841 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e810 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e531) + (_e549 + _e311)), ((f32(((_e819 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e532) + (_e550 + _e312)));
                                let _e842 = core_intrinsics_minimum_number_nsz_f32_(_e841, ((f32(((_e828 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u)) * _e533) + (_e551 + _e313)));
                                if (_e807 <= _e842) {
                                    if (_e807 <= _e114) {
                                        if (_e842 >= 0f) {
                                            if (_e771 == 0u) {
                                                let _e849 = nodes.member[(0u + _e499)].links[2u];
                                                phi_938_ = _e849;
                                            } else {
                                                let _e852 = nodes.member[(0u + _e499)].links[3u];
                                                phi_938_ = _e852;
                                            }
                                            let _e854 = phi_938_;
                                            let _e859 = ((_e854 >> bitcast<u32>(((_e772 * 8u) & 31u))) & 255u);
                                            let _e860 = (_e859 & 31u);
                                            if (_e860 >= 24u) {
                                                phi_951_ = (24u + ((_e860 - 24u) ^ _e361));
                                            } else {
                                                phi_951_ = _e860;
                                            }
                                            let _e866 = phi_951_;
                                            phi_956_ = (_e768 | ((_e859 >> bitcast<u32>(5i)) << bitcast<u32>((_e866 & 31u))));
                                        } else {
                                            phi_956_ = _e768;
                                        }
                                        let _e874 = phi_956_;
                                        phi_957_ = _e874;
                                    } else {
                                        phi_957_ = _e768;
                                    }
                                    let _e876 = phi_957_;
                                    phi_958_ = _e876;
                                } else {
                                    phi_958_ = _e768;
                                }
                                let _e878 = phi_958_;
                                phi_828_ = (_e766 + 1u);
                                phi_831_ = _e878;
                            } else {
                                phi_828_ = u32();
                                phi_831_ = u32();
                            }
                            let _e881 = phi_828_;
                            let _e883 = phi_831_;
                            continue;
                            continuing {
                                phi_827_ = _e881;
                                phi_830_ = _e883;
                                break if !(_e769);
                            }
                        }
                        let _e887 = nodes.member[(0u + _e499)].links[0u];
                        let _e891 = nodes.member[(0u + _e499)].frame[3u];
                        let _e895 = local_1;
                        if ((_e895 & 4278190080u) == 0u) {
                        } else {
                            let _e899 = local.group_mask;
                            if ((_e899 & 4278190080u) == 0u) {
                            } else {
                                let _e903 = local.len;
                                if (_e903 < 32u) {
                                    let _e906 = local.group;
                                    let _e908 = local.len;
                                    if (_e908 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e908)] = _e906;
                                    let _e914 = local.group_mask;
                                    let _e916 = local.len;
                                    if (_e916 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e916)] = _e914;
                                    let _e923 = local.len;
                                    local.len = (_e923 + 1u);
                                }
                            }
                            local.group = (0u + _e887);
                            let _e927 = local_2;
                            local.group_mask = ((_e927 & 4278190080u) | (_e891 >> bitcast<u32>(24i)));
                        }
                        let _e932 = local_3;
                        phi_1016_ = (_e932 & 16777215u);
                        loop {
                            let _e935 = phi_1016_;
                            let _e936 = (_e935 == 0u);
                            local_4 = _e936;
                            local_8 = _e936;
                            if _e936 {
                                phi_1017_ = u32();
                                phi_1627_ = false;
                                phi_1628_ = false;
                                phi_1629_ = false;
                            } else {
                                let _e939 = nodes.member[(0u + _e499)].links[1u];
                                let _e944 = ((0u + _e939) + select(firstTrailingBit(_e935), 32u, (_e935 == 0u)));
                                if (_e944 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e951 = triangles.member[(0u + _e944)].v0_;
                                let _e953 = (_e951.x - _e104);
                                let _e955 = (_e951.y - _e106);
                                let _e957 = (_e951.z - _e108);
                                if (_e334 == 0u) {
                                    phi_1062_ = vec3<f32>(_e955, _e957, _e953);
                                } else {
                                    if (_e334 == 1u) {
                                        phi_1061_ = vec3<f32>(_e957, _e953, _e955);
                                    } else {
                                        phi_1061_ = (_e951 - vec3<f32>(_e104, _e106, _e108));
                                    }
                                    let _e965 = phi_1061_;
                                    phi_1062_ = _e965;
                                }
                                let _e967 = phi_1062_;
                                let _e971 = (_e967.x - (_e345 * _e967.z));
                                let _e975 = (_e967.y - (_e348 * _e967.z));
                                let _e977 = triangles.member[(0u + _e944)].v1_;
                                let _e979 = (_e977.x - _e104);
                                let _e981 = (_e977.y - _e106);
                                let _e983 = (_e977.z - _e108);
                                if (_e334 == 0u) {
                                    phi_1092_ = vec3<f32>(_e981, _e983, _e979);
                                } else {
                                    if (_e334 == 1u) {
                                        phi_1091_ = vec3<f32>(_e983, _e979, _e981);
                                    } else {
                                        phi_1091_ = (_e977 - vec3<f32>(_e104, _e106, _e108));
                                    }
                                    let _e991 = phi_1091_;
                                    phi_1092_ = _e991;
                                }
                                let _e993 = phi_1092_;
                                let _e997 = (_e993.x - (_e345 * _e993.z));
                                let _e1001 = (_e993.y - (_e348 * _e993.z));
                                let _e1003 = triangles.member[(0u + _e944)].v2_;
                                let _e1005 = (_e1003.x - _e104);
                                let _e1007 = (_e1003.y - _e106);
                                let _e1009 = (_e1003.z - _e108);
                                if (_e334 == 0u) {
                                    phi_1122_ = vec3<f32>(_e1007, _e1009, _e1005);
                                } else {
                                    if (_e334 == 1u) {
                                        phi_1121_ = vec3<f32>(_e1009, _e1005, _e1007);
                                    } else {
                                        phi_1121_ = (_e1003 - vec3<f32>(_e104, _e106, _e108));
                                    }
                                    let _e1017 = phi_1121_;
                                    phi_1122_ = _e1017;
                                }
                                let _e1019 = phi_1122_;
                                let _e1023 = (_e1019.x - (_e345 * _e1019.z));
                                let _e1027 = (_e1019.y - (_e348 * _e1019.z));
                                if (_e997 < _e1023) {
                                    phi_1141_ = true;
                                } else {
                                    if (_e997 == _e1023) {
                                        phi_1140_ = (_e1001 < _e1027);
                                    } else {
                                        phi_1140_ = false;
                                    }
                                    let _e1032 = phi_1140_;
                                    phi_1141_ = _e1032;
                                }
                                let _e1034 = phi_1141_;
                                if _e1034 {
                                    phi_1145_ = _e1027;
                                    phi_1146_ = _e1023;
                                    phi_1147_ = _e1001;
                                    phi_1148_ = _e997;
                                } else {
                                    phi_1145_ = _e1001;
                                    phi_1146_ = _e997;
                                    phi_1147_ = _e1027;
                                    phi_1148_ = _e1023;
                                }
                                let _e1036 = phi_1145_;
                                let _e1038 = phi_1146_;
                                let _e1040 = phi_1147_;
                                let _e1042 = phi_1148_;
                                let _e1045 = ((_e1042 * _e1036) - (_e1040 * _e1038));
                                if _e1034 {
                                    phi_1156_ = -(_e1045);
                                } else {
                                    phi_1156_ = _e1045;
                                }
                                let _e1048 = phi_1156_;
                                if (_e1023 < _e971) {
                                    phi_1167_ = true;
                                } else {
                                    if (_e1023 == _e971) {
                                        phi_1166_ = (_e1027 < _e975);
                                    } else {
                                        phi_1166_ = false;
                                    }
                                    let _e1053 = phi_1166_;
                                    phi_1167_ = _e1053;
                                }
                                let _e1055 = phi_1167_;
                                if _e1055 {
                                    phi_1171_ = _e975;
                                    phi_1172_ = _e971;
                                    phi_1173_ = _e1027;
                                    phi_1174_ = _e1023;
                                } else {
                                    phi_1171_ = _e1027;
                                    phi_1172_ = _e1023;
                                    phi_1173_ = _e975;
                                    phi_1174_ = _e971;
                                }
                                let _e1057 = phi_1171_;
                                let _e1059 = phi_1172_;
                                let _e1061 = phi_1173_;
                                let _e1063 = phi_1174_;
                                let _e1066 = ((_e1063 * _e1057) - (_e1061 * _e1059));
                                if _e1055 {
                                    phi_1182_ = -(_e1066);
                                } else {
                                    phi_1182_ = _e1066;
                                }
                                let _e1069 = phi_1182_;
                                if (_e971 < _e997) {
                                    phi_1193_ = true;
                                } else {
                                    if (_e971 == _e997) {
                                        phi_1192_ = (_e975 < _e1001);
                                    } else {
                                        phi_1192_ = false;
                                    }
                                    let _e1074 = phi_1192_;
                                    phi_1193_ = _e1074;
                                }
                                let _e1076 = phi_1193_;
                                if _e1076 {
                                    phi_1197_ = _e1001;
                                    phi_1198_ = _e997;
                                    phi_1199_ = _e975;
                                    phi_1200_ = _e971;
                                } else {
                                    phi_1197_ = _e975;
                                    phi_1198_ = _e971;
                                    phi_1199_ = _e1001;
                                    phi_1200_ = _e997;
                                }
                                let _e1078 = phi_1197_;
                                let _e1080 = phi_1198_;
                                let _e1082 = phi_1199_;
                                let _e1084 = phi_1200_;
                                let _e1087 = ((_e1084 * _e1078) - (_e1082 * _e1080));
                                if _e1076 {
                                    phi_1208_ = -(_e1087);
                                } else {
                                    phi_1208_ = _e1087;
                                }
                                let _e1090 = phi_1208_;
                                if (_e1048 >= 0f) {
                                    if (_e1069 >= 0f) {
                                        if (_e1090 >= 0f) {
                                            phi_1223_ = ((_e1048 + _e1069) + _e1090);
                                            phi_1224_ = false;
                                        } else {
                                            phi_1223_ = f32();
                                            phi_1224_ = true;
                                        }
                                        let _e1097 = phi_1223_;
                                        let _e1099 = phi_1224_;
                                        phi_1225_ = _e1097;
                                        phi_1226_ = _e1099;
                                    } else {
                                        phi_1225_ = f32();
                                        phi_1226_ = true;
                                    }
                                    let _e1101 = phi_1225_;
                                    let _e1103 = phi_1226_;
                                    phi_1227_ = _e1101;
                                    phi_1228_ = _e1103;
                                } else {
                                    phi_1227_ = f32();
                                    phi_1228_ = true;
                                }
                                let _e1105 = phi_1227_;
                                let _e1107 = phi_1228_;
                                if _e1107 {
                                    if (_e1048 <= 0f) {
                                        if (_e1069 <= 0f) {
                                            let _e1110 = (_e1090 <= 0f);
                                            if _e1110 {
                                            }
                                            phi_1246_ = ((_e1048 + _e1069) + _e1090);
                                            phi_1247_ = false;
                                            phi_1248_ = _e1110;
                                        } else {
                                            phi_1246_ = f32();
                                            phi_1247_ = true;
                                            phi_1248_ = false;
                                        }
                                        let _e1114 = phi_1246_;
                                        let _e1116 = phi_1247_;
                                        let _e1118 = phi_1248_;
                                        phi_1249_ = _e1114;
                                        phi_1250_ = _e1116;
                                        phi_1251_ = _e1118;
                                    } else {
                                        phi_1249_ = f32();
                                        phi_1250_ = true;
                                        phi_1251_ = false;
                                    }
                                    let _e1120 = phi_1249_;
                                    let _e1122 = phi_1250_;
                                    let _e1124 = phi_1251_;
                                    if _e1122 {
                                        phi_1255_ = false;
                                    } else {
                                        phi_1255_ = _e1124;
                                    }
                                    let _e1126 = phi_1255_;
                                    phi_1256_ = _e1120;
                                    phi_1257_ = _e1126;
                                } else {
                                    phi_1256_ = _e1105;
                                    phi_1257_ = true;
                                }
                                let _e1128 = phi_1256_;
                                let _e1130 = phi_1257_;
                                if _e1130 {
                                    let _e1131 = (_e1128 == 0f);
                                    if _e1131 {
                                        phi_1573_ = lt_bvh_triangle_Intersection();
                                        phi_1574_ = false;
                                    } else {
                                        let _e1133 = triangles.member[(0u + _e944)].v0_;
                                        let _e1135 = (_e1133.x - _e104);
                                        let _e1137 = (_e1133.y - _e106);
                                        let _e1139 = (_e1133.z - _e108);
                                        if (_e334 == 0u) {
                                            phi_1286_ = vec3<f32>(_e1137, _e1139, _e1135);
                                        } else {
                                            if (_e334 == 1u) {
                                                phi_1285_ = vec3<f32>(_e1139, _e1135, _e1137);
                                            } else {
                                                phi_1285_ = (_e1133 - vec3<f32>(_e104, _e106, _e108));
                                            }
                                            let _e1147 = phi_1285_;
                                            phi_1286_ = _e1147;
                                        }
                                        let _e1149 = phi_1286_;
                                        let _e1151 = triangles.member[(0u + _e944)].v1_;
                                        let _e1153 = triangles.member[(0u + _e944)].v0_;
                                        let _e1156 = (_e1151.x - _e1153.x);
                                        let _e1159 = (_e1151.y - _e1153.y);
                                        let _e1162 = (_e1151.z - _e1153.z);
                                        if (_e334 == 0u) {
                                            phi_1312_ = vec3<f32>(_e1159, _e1162, _e1156);
                                        } else {
                                            if (_e334 == 1u) {
                                                phi_1311_ = vec3<f32>(_e1162, _e1156, _e1159);
                                            } else {
                                                phi_1311_ = (_e1151 - _e1153);
                                            }
                                            let _e1169 = phi_1311_;
                                            phi_1312_ = _e1169;
                                        }
                                        let _e1171 = phi_1312_;
                                        let _e1173 = triangles.member[(0u + _e944)].v2_;
                                        let _e1175 = triangles.member[(0u + _e944)].v0_;
                                        let _e1178 = (_e1173.x - _e1175.x);
                                        let _e1181 = (_e1173.y - _e1175.y);
                                        let _e1184 = (_e1173.z - _e1175.z);
                                        if (_e334 == 0u) {
                                            phi_1338_ = vec3<f32>(_e1181, _e1184, _e1178);
                                        } else {
                                            if (_e334 == 1u) {
                                                phi_1337_ = vec3<f32>(_e1184, _e1178, _e1181);
                                            } else {
                                                phi_1337_ = (_e1173 - _e1175);
                                            }
                                            let _e1191 = phi_1337_;
                                            phi_1338_ = _e1191;
                                        }
                                        let _e1193 = phi_1338_;
                                        let _e1200 = ((_e1171.y * _e1193.z) - (_e1171.z * _e1193.y));
                                        let _e1207 = ((_e1171.z * _e1193.x) - (_e1171.x * _e1193.z));
                                        let _e1214 = ((_e1171.x * _e1193.y) - (_e1171.y * _e1193.x));
                                        let _e1228 = (((1f / _e342.z) * (((_e1200 * _e1149.x) + (_e1207 * _e1149.y)) + (_e1214 * _e1149.z))) / (((_e1200 * _e345) + (_e1207 * _e348)) + _e1214));
                                        if (_e1228 > 0f) {
                                            if (_e1228 < _e114) {
                                                let _e1232 = triangles.member[(0u + _e944)].v0_;
                                                let _e1234 = triangles.member[(0u + _e944)].v1_;
                                                if (_e1232.x < _e1234.x) {
                                                    phi_1394_ = _e1232.x;
                                                } else {
                                                    phi_1394_ = _e1234.x;
                                                }
                                                let _e1241 = phi_1394_;
                                                if (_e1232.y < _e1234.y) {
                                                    phi_1403_ = _e1232.y;
                                                } else {
                                                    phi_1403_ = _e1234.y;
                                                }
                                                let _e1248 = phi_1403_;
                                                if (_e1232.z < _e1234.z) {
                                                    phi_1412_ = _e1232.z;
                                                } else {
                                                    phi_1412_ = _e1234.z;
                                                }
                                                let _e1255 = phi_1412_;
                                                let _e1257 = triangles.member[(0u + _e944)].v2_;
                                                if (_e1241 < _e1257.x) {
                                                    phi_1421_ = _e1241;
                                                } else {
                                                    phi_1421_ = _e1257.x;
                                                }
                                                let _e1262 = phi_1421_;
                                                if (_e1248 < _e1257.y) {
                                                    phi_1428_ = _e1248;
                                                } else {
                                                    phi_1428_ = _e1257.y;
                                                }
                                                let _e1267 = phi_1428_;
                                                if (_e1255 < _e1257.z) {
                                                    phi_1435_ = _e1255;
                                                } else {
                                                    phi_1435_ = _e1257.z;
                                                }
                                                let _e1272 = phi_1435_;
                                                let _e1274 = triangles.member[(0u + _e944)].v0_;
                                                let _e1276 = triangles.member[(0u + _e944)].v1_;
                                                if (_e1274.x > _e1276.x) {
                                                    phi_1448_ = _e1274.x;
                                                } else {
                                                    phi_1448_ = _e1276.x;
                                                }
                                                let _e1283 = phi_1448_;
                                                if (_e1274.y > _e1276.y) {
                                                    phi_1457_ = _e1274.y;
                                                } else {
                                                    phi_1457_ = _e1276.y;
                                                }
                                                let _e1290 = phi_1457_;
                                                if (_e1274.z > _e1276.z) {
                                                    phi_1466_ = _e1274.z;
                                                } else {
                                                    phi_1466_ = _e1276.z;
                                                }
                                                let _e1297 = phi_1466_;
                                                let _e1299 = triangles.member[(0u + _e944)].v2_;
                                                if (_e1283 > _e1299.x) {
                                                    phi_1475_ = _e1283;
                                                } else {
                                                    phi_1475_ = _e1299.x;
                                                }
                                                let _e1304 = phi_1475_;
                                                if (_e1290 > _e1299.y) {
                                                    phi_1482_ = _e1290;
                                                } else {
                                                    phi_1482_ = _e1299.y;
                                                }
                                                let _e1309 = phi_1482_;
                                                if (_e1297 > _e1299.z) {
                                                    phi_1489_ = _e1297;
                                                } else {
                                                    phi_1489_ = _e1299.z;
                                                }
                                                let _e1314 = phi_1489_;
                                                let _e1318 = ((_e1262 - _e104) * _e263);
                                                let _e1319 = ((_e1267 - _e106) * _e273);
                                                let _e1320 = ((_e1272 - _e108) * _e283);
                                                let _e1324 = ((_e1304 - _e104) * _e263);
                                                let _e1325 = ((_e1309 - _e106) * _e273);
                                                let _e1326 = ((_e1314 - _e108) * _e283);
                                                if (_e1318 < _e1324) {
                                                    phi_1506_ = _e1318;
                                                } else {
                                                    phi_1506_ = _e1324;
                                                }
                                                let _e1329 = phi_1506_;
                                                if (_e1319 < _e1325) {
                                                    phi_1511_ = _e1319;
                                                } else {
                                                    phi_1511_ = _e1325;
                                                }
                                                let _e1332 = phi_1511_;
                                                if (_e1320 < _e1326) {
                                                    phi_1516_ = _e1320;
                                                } else {
                                                    phi_1516_ = _e1326;
                                                }
                                                let _e1335 = phi_1516_;
                                                if (_e1318 > _e1324) {
                                                    phi_1524_ = _e1318;
                                                } else {
                                                    phi_1524_ = _e1324;
                                                }
                                                let _e1341 = phi_1524_;
                                                if (_e1319 > _e1325) {
                                                    phi_1529_ = _e1319;
                                                } else {
                                                    phi_1529_ = _e1325;
                                                }
                                                let _e1344 = phi_1529_;
                                                if (_e1320 > _e1326) {
                                                    phi_1534_ = _e1320;
                                                } else {
                                                    phi_1534_ = _e1326;
                                                }
                                                let _e1347 = phi_1534_;
                                                let _e1351 = core_intrinsics_maximum_number_nsz_f32_((_e1329 - _e318), (_e1332 - _e319));
                                                let _e1352 = core_intrinsics_maximum_number_nsz_f32_(_e1351, (_e1335 - _e320));
                                                let _e1353 = core_intrinsics_minimum_number_nsz_f32_((_e1341 + _e318), (_e1344 + _e319));
                                                let _e1354 = core_intrinsics_minimum_number_nsz_f32_(_e1353, (_e1347 + _e320));
                                                if (_e1352 > -300000000000000000000000000000000000000f) {
                                                    phi_1546_ = _e1352;
                                                } else {
                                                    phi_1546_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1357 = phi_1546_;
                                                if (_e1354 < 300000000000000000000000000000000000000f) {
                                                    phi_1551_ = _e1354;
                                                } else {
                                                    phi_1551_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1360 = phi_1551_;
                                                if (_e1228 < _e1357) {
                                                    phi_1556_ = _e1357;
                                                } else {
                                                    phi_1556_ = _e1228;
                                                }
                                                let _e1363 = phi_1556_;
                                                if (_e1363 > _e1360) {
                                                    phi_1561_ = _e1360;
                                                } else {
                                                    phi_1561_ = _e1363;
                                                }
                                                let _e1366 = phi_1561_;
                                                phi_1566_ = lt_bvh_triangle_Intersection(_e1366, (_e1069 / _e1128), (_e1090 / _e1128), (_e1357 <= _e1360));
                                                phi_1567_ = false;
                                            } else {
                                                phi_1566_ = lt_bvh_triangle_Intersection();
                                                phi_1567_ = true;
                                            }
                                            let _e1372 = phi_1566_;
                                            let _e1374 = phi_1567_;
                                            phi_1568_ = _e1372;
                                            phi_1569_ = _e1374;
                                        } else {
                                            phi_1568_ = lt_bvh_triangle_Intersection();
                                            phi_1569_ = true;
                                        }
                                        let _e1376 = phi_1568_;
                                        let _e1378 = phi_1569_;
                                        if _e1378 {
                                        }
                                        phi_1573_ = _e1376;
                                        phi_1574_ = _e1378;
                                    }
                                    let _e1380 = phi_1573_;
                                    let _e1382 = phi_1574_;
                                    phi_1575_ = _e1380;
                                    phi_1576_ = _e1131;
                                    phi_1577_ = _e1382;
                                } else {
                                    phi_1575_ = lt_bvh_triangle_Intersection();
                                    phi_1576_ = true;
                                    phi_1577_ = false;
                                }
                                let _e1384 = phi_1575_;
                                let _e1386 = phi_1576_;
                                let _e1388 = phi_1577_;
                                if _e1386 {
                                    phi_1581_ = true;
                                } else {
                                    phi_1581_ = _e1388;
                                }
                                let _e1390 = phi_1581_;
                                if _e1390 {
                                    phi_1585_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1585_ = _e1384;
                                }
                                let _e1392 = phi_1585_;
                                if _e1392.is_hit {
                                    if (_e1392.t > 0f) {
                                        if (_e1392.t < _e114) {
                                            let _e1399 = triangles.member[(0u + _e944)].i0_;
                                            let _e1401 = ((_e1399 & 2147483648u) == 0u);
                                            if _e1401 {
                                                phi_1611_ = false;
                                                phi_1612_ = false;
                                            } else {
                                                if true {
                                                    phi_1610_ = false;
                                                } else {
                                                    phi_1610_ = true;
                                                }
                                                let _e1403 = phi_1610_;
                                                phi_1611_ = _e1403;
                                                phi_1612_ = true;
                                            }
                                            let _e1405 = phi_1611_;
                                            let _e1407 = phi_1612_;
                                            phi_1613_ = _e1405;
                                            phi_1614_ = _e1401;
                                            phi_1615_ = _e1407;
                                        } else {
                                            phi_1613_ = true;
                                            phi_1614_ = false;
                                            phi_1615_ = false;
                                        }
                                        let _e1409 = phi_1613_;
                                        let _e1411 = phi_1614_;
                                        let _e1413 = phi_1615_;
                                        phi_1616_ = _e1409;
                                        phi_1617_ = _e1411;
                                        phi_1618_ = _e1413;
                                    } else {
                                        phi_1616_ = true;
                                        phi_1617_ = false;
                                        phi_1618_ = false;
                                    }
                                    let _e1415 = phi_1616_;
                                    let _e1417 = phi_1617_;
                                    let _e1419 = phi_1618_;
                                    phi_1619_ = _e1415;
                                    phi_1620_ = _e1417;
                                    phi_1621_ = _e1419;
                                } else {
                                    phi_1619_ = true;
                                    phi_1620_ = false;
                                    phi_1621_ = false;
                                }
                                let _e1421 = phi_1619_;
                                let _e1423 = phi_1620_;
                                let _e1425 = phi_1621_;
                                if _e1421 {
                                    phi_1625_ = false;
                                    phi_1626_ = false;
                                } else {
                                    phi_1625_ = _e1423;
                                    phi_1626_ = _e1425;
                                }
                                let _e1427 = phi_1625_;
                                let _e1429 = phi_1626_;
                                phi_1017_ = (_e935 & (_e935 - 1u));
                                phi_1627_ = _e1421;
                                phi_1628_ = _e1427;
                                phi_1629_ = _e1429;
                            }
                            let _e1431 = phi_1017_;
                            let _e1433 = phi_1627_;
                            let _e1435 = phi_1628_;
                            let _e1437 = phi_1629_;
                            local_6 = _e1435;
                            local_7 = _e1437;
                            continue;
                            continuing {
                                phi_1016_ = _e1431;
                                break if !(_e1433);
                            }
                        }
                        let _e1440 = local_4;
                        if _e1440 {
                            let _e1442 = local.group_mask;
                            if ((_e1442 & 4278190080u) == 0u) {
                                let _e1446 = local.len;
                                if (_e1446 == 0u) {
                                    phi_1671_ = false;
                                } else {
                                    let _e1450 = local.len;
                                    local.len = (_e1450 - 1u);
                                    let _e1453 = local.len;
                                    if (_e1453 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1458 = local.first[(0u + _e1453)];
                                    local.group = _e1458;
                                    let _e1461 = local.len;
                                    if (_e1461 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1466 = local.mask[(0u + _e1461)];
                                    local.group_mask = _e1466;
                                    phi_1671_ = true;
                                }
                                let _e1469 = phi_1671_;
                                phi_1672_ = _e1469;
                            } else {
                                phi_1672_ = true;
                            }
                            let _e1471 = phi_1672_;
                            if _e1471 {
                                let _e1473 = local.group_mask;
                                let _e1479 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1473)), 32u, (_e1473 == 0u)));
                                let _e1483 = local.group_mask;
                                let _e1497 = local.group_mask;
                                local.group_mask = (_e1497 & ~((1u << bitcast<u32>((_e1479 & 31u)))));
                                let _e1500 = local.group;
                                phi_1703_ = (_e1500 + countOneBits(((_e1483 & ~((4294967295u << bitcast<u32>((((_e1479 - 24u) ^ _e361) & 31u))))) & 255u)));
                            } else {
                                phi_1703_ = 4294967295u;
                            }
                            let _e1503 = phi_1703_;
                            phi_1704_ = _e1503;
                            phi_1705_ = false;
                            phi_1706_ = false;
                        } else {
                            phi_1704_ = u32();
                            let _e1744 = local_6;
                            phi_1705_ = _e1744;
                            let _e1747 = local_7;
                            phi_1706_ = _e1747;
                        }
                        let _e1505 = phi_1704_;
                        let _e1507 = phi_1705_;
                        let _e1509 = phi_1706_;
                        phi_687_ = _e1505;
                        let _e1751 = local_8;
                        phi_1707_ = _e1751;
                        phi_1708_ = false;
                        phi_1709_ = _e1507;
                        phi_1710_ = _e1509;
                    } else {
                        phi_687_ = u32();
                        phi_1707_ = false;
                        phi_1708_ = true;
                        phi_1709_ = false;
                        phi_1710_ = false;
                    }
                    let _e1511 = phi_687_;
                    let _e1513 = phi_1707_;
                    let _e1515 = phi_1708_;
                    let _e1517 = phi_1709_;
                    let _e1519 = phi_1710_;
                    local_5 = _e1515;
                    local_9 = _e1517;
                    local_10 = _e1519;
                    continue;
                    continuing {
                        phi_686_ = _e1511;
                        break if !(_e1513);
                    }
                }
                let _e1522 = local_5;
                if _e1522 {
                    phi_1714_ = false;
                    phi_1715_ = false;
                } else {
                    let _e1758 = local_9;
                    phi_1714_ = _e1758;
                    let _e1761 = local_10;
                    phi_1715_ = _e1761;
                }
                let _e1524 = phi_1714_;
                let _e1526 = phi_1715_;
                if _e1524 {
                    phi_1719_ = true;
                } else {
                    phi_1719_ = _e1526;
                }
                let _e1528 = phi_1719_;
                if _e1528 {
                    phi_1723_ = true;
                } else {
                    phi_1723_ = false;
                }
                let _e1530 = phi_1723_;
                phi_1724_ = _e1530;
            }
            let _e1532 = phi_1724_;
            phi_1725_ = _e1532;
            phi_1726_ = _e187;
        } else {
            phi_1725_ = bool();
            phi_1726_ = true;
        }
        let _e1534 = phi_1725_;
        let _e1536 = phi_1726_;
        if _e1536 {
            phi_1730_ = false;
        } else {
            phi_1730_ = _e1534;
        }
        let _e1538 = phi_1730_;
        if _e1538 {
            phi_1734_ = 0f;
        } else {
            phi_1734_ = 1f;
        }
        let _e1540 = phi_1734_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        visibility.member[(0u + _e84)] = _e1540;
        if (_e84 < _e71) {
        } else {
            return;
        }
        let _e1547 = bits.member[(0u + _e84)];
        if ((_e1547 & 2u) == 0u) {
            phi_1755_ = (_e1547 & 1u);
        } else {
            phi_1755_ = (_e1547 & 7u);
        }
        let _e1553 = phi_1755_;
        if (_e84 < _e65) {
        } else {
            return;
        }
        let _e1557 = visibility.member[(0u + _e84)];
        if ((_e1553 & 1u) != 0u) {
            phi_1770_ = (2u | 1u);
        } else {
            phi_1770_ = 2u;
        }
        let _e1563 = phi_1770_;
        if (_e1557 < 0.5f) {
            phi_1775_ = (_e1563 | 4u);
        } else {
            phi_1775_ = _e1563;
        }
        let _e1566 = phi_1775_;
        if (_e84 < _e71) {
        } else {
            return;
        }
        bits.member[(0u + _e84)] = _e1566;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
