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
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
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

struct type_32 {
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
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_173_: lt_mask_LightPlace;
    var phi_174_: bool;
    var phi_175_: lt_mask_LightPlace;
    var phi_176_: bool;
    var phi_181_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_173_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_174_ = false;
        } else {
            phi_173_ = lt_mask_LightPlace();
            phi_174_ = true;
        }
        let _e65 = phi_173_;
        let _e67 = phi_174_;
        phi_175_ = _e65;
        phi_176_ = _e67;
    } else {
        phi_175_ = lt_mask_LightPlace();
        phi_176_ = true;
    }
    let _e69 = phi_175_;
    let _e71 = phi_176_;
    if _e71 {
        phi_181_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_181_ = _e69;
    }
    let _e76 = phi_181_;
    return lt_mask_LightPlace(_e76.word, _e76.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_196_: bool;
    var phi_200_: f32;

    if (param_3 != param_3) {
        phi_196_ = true;
    } else {
        let _e55 = (param_4 >= param_3);
        if _e55 {
        }
        phi_196_ = _e55;
    }
    let _e57 = phi_196_;
    if _e57 {
        phi_200_ = param_4;
    } else {
        phi_200_ = param_3;
    }
    let _e59 = phi_200_;
    return _e59;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_212_: bool;
    var phi_216_: f32;

    if (param_5 != param_5) {
        phi_212_ = true;
    } else {
        let _e55 = (param_6 <= param_5);
        if _e55 {
        }
        phi_212_ = _e55;
    }
    let _e57 = phi_212_;
    if _e57 {
        phi_216_ = param_6;
    } else {
        phi_216_ = param_5;
    }
    let _e59 = phi_216_;
    return _e59;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_1891_: bool;
    var phi_1892_: bool;
    var phi_1893_: bool;
    var phi_1894_: bool;
    var phi_1898_: bool;

    let _e55 = (*param_7).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_7).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_7).normal[2u];
            let _e67 = global[2u];
            phi_1891_ = (_e65 == _e67);
            phi_1892_ = false;
        } else {
            phi_1891_ = bool();
            phi_1892_ = true;
        }
        let _e70 = phi_1891_;
        let _e72 = phi_1892_;
        phi_1893_ = _e70;
        phi_1894_ = _e72;
    } else {
        phi_1893_ = bool();
        phi_1894_ = true;
    }
    let _e74 = phi_1893_;
    let _e76 = phi_1894_;
    if _e76 {
        phi_1898_ = false;
    } else {
        phi_1898_ = _e74;
    }
    let _e78 = phi_1898_;
    return !(_e78);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: abi_Sample;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_339_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_340_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_342_: bool;
    var phi_349_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_353_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_391_: f32;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_458_: bool;
    var phi_459_: bool;
    var phi_460_: bool;
    var phi_461_: bool;
    var phi_462_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_467_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_473_: bool;
    var phi_477_: bool;
    var phi_547_: f32;
    var phi_554_: f32;
    var phi_561_: f32;
    var phi_568_: f32;
    var phi_575_: f32;
    var phi_582_: f32;
    var phi_599_: f32;
    var phi_604_: f32;
    var phi_609_: f32;
    var phi_637_: bool;
    var phi_638_: bool;
    var phi_646_: u32;
    var phi_647_: u32;
    var phi_658_: vec3<f32>;
    var phi_659_: vec3<f32>;
    var phi_672_: u32;
    var phi_677_: u32;
    var phi_682_: u32;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_828_: u32;
    var phi_830_: u32;
    var phi_833_: bool;
    var phi_913_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_940_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_967_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_973_: u32;
    var phi_976_: u32;
    var phi_990_: u32;
    var phi_1000_: u32;
    var phi_1010_: u32;
    var phi_1028_: u32;
    var phi_1038_: u32;
    var phi_1048_: u32;
    var phi_1084_: u32;
    var phi_1097_: u32;
    var phi_1102_: u32;
    var phi_1103_: u32;
    var phi_1104_: u32;
    var phi_974_: u32;
    var phi_977_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1162_: u32;
    var phi_1165_: bool;
    var phi_1209_: vec3<f32>;
    var phi_1210_: vec3<f32>;
    var phi_1239_: vec3<f32>;
    var phi_1240_: vec3<f32>;
    var phi_1269_: vec3<f32>;
    var phi_1270_: vec3<f32>;
    var phi_1288_: bool;
    var phi_1289_: bool;
    var phi_1293_: f32;
    var phi_1294_: f32;
    var phi_1295_: f32;
    var phi_1296_: f32;
    var phi_1304_: f32;
    var phi_1314_: bool;
    var phi_1315_: bool;
    var phi_1319_: f32;
    var phi_1320_: f32;
    var phi_1321_: f32;
    var phi_1322_: f32;
    var phi_1330_: f32;
    var phi_1340_: bool;
    var phi_1341_: bool;
    var phi_1345_: f32;
    var phi_1346_: f32;
    var phi_1347_: f32;
    var phi_1348_: f32;
    var phi_1356_: f32;
    var phi_1371_: f32;
    var phi_1372_: bool;
    var phi_1373_: f32;
    var phi_1374_: bool;
    var phi_1375_: f32;
    var phi_1376_: bool;
    var phi_1394_: f32;
    var phi_1395_: bool;
    var phi_1396_: bool;
    var phi_1397_: f32;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1403_: bool;
    var phi_1404_: f32;
    var phi_1405_: bool;
    var phi_1433_: vec3<f32>;
    var phi_1434_: vec3<f32>;
    var phi_1459_: vec3<f32>;
    var phi_1460_: vec3<f32>;
    var phi_1485_: vec3<f32>;
    var phi_1486_: vec3<f32>;
    var phi_1542_: f32;
    var phi_1551_: f32;
    var phi_1560_: f32;
    var phi_1569_: f32;
    var phi_1576_: f32;
    var phi_1583_: f32;
    var phi_1596_: f32;
    var phi_1605_: f32;
    var phi_1614_: f32;
    var phi_1623_: f32;
    var phi_1630_: f32;
    var phi_1637_: f32;
    var phi_1654_: f32;
    var phi_1659_: f32;
    var phi_1664_: f32;
    var phi_1672_: f32;
    var phi_1677_: f32;
    var phi_1682_: f32;
    var phi_1694_: f32;
    var phi_1699_: f32;
    var phi_1704_: f32;
    var phi_1709_: f32;
    var phi_1714_: lt_bvh_triangle_Intersection;
    var phi_1715_: bool;
    var phi_1716_: lt_bvh_triangle_Intersection;
    var phi_1717_: bool;
    var phi_1721_: lt_bvh_triangle_Intersection;
    var phi_1722_: bool;
    var phi_1723_: lt_bvh_triangle_Intersection;
    var phi_1724_: bool;
    var phi_1725_: bool;
    var phi_1729_: bool;
    var phi_1733_: lt_bvh_triangle_Intersection;
    var phi_1753_: bool;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1163_: u32;
    var phi_1166_: bool;
    var phi_1763_: bool;
    var local_5: bool;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1837_: u32;
    var phi_1838_: u32;
    var phi_831_: u32;
    var phi_834_: bool;
    var phi_1839_: bool;
    var phi_1840_: bool;
    var local_6: bool;
    var phi_1844_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_1851_: bool;
    var phi_1855_: bool;
    var phi_1859_: f32;
    var phi_1860_: f32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;

    let _e54 = id_1;
    let _e61 = arrayLength((&nodes.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.word) != 0i) {
        if (_e73.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e81 = samples.member[(0u + _e73.shift)];
        local_1 = abi_Sample(_e81.position, _e81.magnitude, _e81.normal, _e81.flags, _e81.shading_normal, _e81.albedo);
        let _e90 = _lt_shaders_abi_Sample_is_valid((&local_1));
        if _e90 {
            let _e92 = local_1.position;
            let _e94 = p.member.light.place;
            let _e100 = p.member.light.place[3u];
            let _e107 = (_e94.x - (_e92.x * _e100));
            let _e108 = (_e94.y - (_e92.y * _e100));
            let _e109 = (_e94.z - (_e92.z * _e100));
            let _e111 = local_1.normal;
            if ((((_e111.x * _e107) + (_e111.y * _e108)) + (_e111.z * _e109)) > 0f) {
                let _e125 = (((_e107 * _e107) + (_e108 * _e108)) + (_e109 * _e109));
                let _e127 = p.member.light.axis;
                let _e139 = p.member.light.place[3u];
                if (_e139 == 0f) {
                    phi_328_ = true;
                } else {
                    let _e142 = p.member.light.range_squared;
                    if (_e125 <= _e142) {
                        let _e145 = p.member.light.cos_outer;
                        phi_327_ = (-((((_e107 * _e127.x) + (_e108 * _e127.y)) + (_e109 * _e127.z))) >= (_e145 * sqrt(_e125)));
                    } else {
                        phi_327_ = false;
                    }
                    let _e150 = phi_327_;
                    phi_328_ = _e150;
                }
                let _e152 = phi_328_;
                if _e152 {
                    let _e154 = local_1.flags;
                    let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
                    phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, ((_e154 & 1u) == 0u));
                    phi_340_ = false;
                } else {
                    phi_339_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_340_ = true;
                }
                let _e173 = phi_339_;
                let _e175 = phi_340_;
                phi_341_ = _e173;
                phi_342_ = _e175;
            } else {
                phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_342_ = true;
            }
            let _e177 = phi_341_;
            let _e179 = phi_342_;
            if _e179 {
                let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
                phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, true);
            } else {
                phi_349_ = _e177;
            }
            let _e196 = phi_349_;
            phi_353_ = _e196;
        } else {
            let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e202.unnamed.visibility, false), _e202.unnamed_1);
            phi_353_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e208.unnamed, true);
        }
        let _e213 = phi_353_;
        if _e213.unnamed_1 {
            phi_1860_ = _e213.unnamed.visibility;
        } else {
            let _e219 = local_1.position;
            let _e221 = local_1.normal;
            let _e223 = local_1.magnitude;
            let _e225 = ((8f / 8388608f) * _e223);
            let _e233 = (_e219.x + (_e221.x * _e225));
            let _e235 = (_e219.y + (_e221.y * _e225));
            let _e237 = (_e219.z + (_e221.z * _e225));
            let _e239 = p.member.light.place;
            if (_e239.w == 0f) {
                phi_391_ = 300000000000000000000000000000000000000f;
            } else {
                phi_391_ = 1f;
            }
            let _e243 = phi_391_;
            let _e251 = (_e239.x - (_e233 * _e239.w));
            let _e252 = (_e239.y - (_e235 * _e239.w));
            let _e253 = (_e239.z - (_e237 * _e239.w));
            let _e258 = abs(_e251);
            let _e259 = abs(_e252);
            let _e260 = abs(_e253);
            if (abs(_e233) < 1000000000000000f) {
                if (abs(_e235) < 1000000000000000f) {
                    if (abs(_e237) < 1000000000000000f) {
                        if (_e258 < 1000000000000000f) {
                            if (_e259 < 1000000000000000f) {
                                if (_e260 < 1000000000000000f) {
                                    if (_e258 > 0f) {
                                        phi_447_ = bool();
                                        phi_448_ = true;
                                    } else {
                                        let _e268 = (_e259 > 0f);
                                        if _e268 {
                                            phi_446_ = bool();
                                        } else {
                                            phi_446_ = (_e260 > 0f);
                                        }
                                        let _e271 = phi_446_;
                                        phi_447_ = _e271;
                                        phi_448_ = _e268;
                                    }
                                    let _e273 = phi_447_;
                                    let _e275 = phi_448_;
                                    if _e275 {
                                        phi_452_ = true;
                                    } else {
                                        phi_452_ = _e273;
                                    }
                                    let _e277 = phi_452_;
                                    phi_453_ = _e277;
                                    phi_454_ = false;
                                } else {
                                    phi_453_ = bool();
                                    phi_454_ = true;
                                }
                                let _e279 = phi_453_;
                                let _e281 = phi_454_;
                                phi_455_ = _e279;
                                phi_456_ = false;
                                phi_457_ = _e281;
                            } else {
                                phi_455_ = bool();
                                phi_456_ = true;
                                phi_457_ = false;
                            }
                            let _e283 = phi_455_;
                            let _e285 = phi_456_;
                            let _e287 = phi_457_;
                            phi_458_ = _e283;
                            phi_459_ = _e285;
                            phi_460_ = _e287;
                        } else {
                            phi_458_ = bool();
                            phi_459_ = true;
                            phi_460_ = false;
                        }
                        let _e289 = phi_458_;
                        let _e291 = phi_459_;
                        let _e293 = phi_460_;
                        phi_461_ = _e289;
                        phi_462_ = _e291;
                        phi_463_ = _e293;
                    } else {
                        phi_461_ = bool();
                        phi_462_ = true;
                        phi_463_ = false;
                    }
                    let _e295 = phi_461_;
                    let _e297 = phi_462_;
                    let _e299 = phi_463_;
                    phi_464_ = _e295;
                    phi_465_ = _e297;
                    phi_466_ = _e299;
                } else {
                    phi_464_ = bool();
                    phi_465_ = true;
                    phi_466_ = false;
                }
                let _e301 = phi_464_;
                let _e303 = phi_465_;
                let _e305 = phi_466_;
                phi_467_ = _e301;
                phi_468_ = _e303;
                phi_469_ = _e305;
            } else {
                phi_467_ = bool();
                phi_468_ = true;
                phi_469_ = false;
            }
            let _e307 = phi_467_;
            let _e309 = phi_468_;
            let _e311 = phi_469_;
            if _e309 {
                phi_473_ = true;
            } else {
                phi_473_ = _e311;
            }
            let _e313 = phi_473_;
            if _e313 {
                phi_477_ = false;
            } else {
                phi_477_ = _e307;
            }
            let _e315 = phi_477_;
            if _e315 {
                let _e316 = (0u >= _e61);
                if _e316 {
                    phi_1849_ = bool();
                } else {
                    if (0u < _e61) {
                    } else {
                        return;
                    }
                    let _e322 = nodes.member[(0u + 0u)].frame[0u];
                    let _e326 = nodes.member[(0u + 0u)].frame[1u];
                    let _e330 = nodes.member[(0u + 0u)].frame[2u];
                    let _e334 = nodes.member[(0u + 0u)].frame[0u];
                    let _e338 = nodes.member[(0u + 0u)].frame[1u];
                    let _e342 = nodes.member[(0u + 0u)].frame[2u];
                    let _e346 = nodes.member[(0u + 0u)].frame[3u];
                    let _e380 = core_intrinsics_maximum_number_nsz_f32_(abs(_e251), abs(_e252));
                    let _e381 = core_intrinsics_maximum_number_nsz_f32_(_e380, abs(_e253));
                    let _e382 = (_e381 * 0.0000000000009094947f);
                    if (abs(_e251) < _e382) {
                        phi_547_ = _e382;
                    } else {
                        phi_547_ = abs(_e251);
                    }
                    let _e387 = phi_547_;
                    if (_e251 < 0f) {
                        phi_554_ = (-1f / _e387);
                    } else {
                        phi_554_ = (1f / _e387);
                    }
                    let _e392 = phi_554_;
                    if (abs(_e252) < _e382) {
                        phi_561_ = _e382;
                    } else {
                        phi_561_ = abs(_e252);
                    }
                    let _e397 = phi_561_;
                    if (_e252 < 0f) {
                        phi_568_ = (-1f / _e397);
                    } else {
                        phi_568_ = (1f / _e397);
                    }
                    let _e402 = phi_568_;
                    if (abs(_e253) < _e382) {
                        phi_575_ = _e382;
                    } else {
                        phi_575_ = abs(_e253);
                    }
                    let _e407 = phi_575_;
                    if (_e253 < 0f) {
                        phi_582_ = (-1f / _e407);
                    } else {
                        phi_582_ = (1f / _e407);
                    }
                    let _e412 = phi_582_;
                    let _e416 = abs((bitcast<f32>(_e322) - _e233));
                    let _e417 = abs((bitcast<f32>(_e326) - _e235));
                    let _e418 = abs((bitcast<f32>(_e330) - _e237));
                    let _e422 = abs(((bitcast<f32>(_e334) + (bitcast<f32>((((_e346 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e233));
                    let _e423 = abs(((bitcast<f32>(_e338) + (bitcast<f32>((((_e346 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e235));
                    let _e424 = abs(((bitcast<f32>(_e342) + (bitcast<f32>((((_e346 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e237));
                    if (_e416 > _e422) {
                        phi_599_ = _e416;
                    } else {
                        phi_599_ = _e422;
                    }
                    let _e427 = phi_599_;
                    if (_e417 > _e423) {
                        phi_604_ = _e417;
                    } else {
                        phi_604_ = _e423;
                    }
                    let _e430 = phi_604_;
                    if (_e418 > _e424) {
                        phi_609_ = _e418;
                    } else {
                        phi_609_ = _e424;
                    }
                    let _e433 = phi_609_;
                    let _e434 = core_intrinsics_maximum_number_nsz_f32_(_e427, _e430);
                    let _e435 = core_intrinsics_maximum_number_nsz_f32_(_e434, _e433);
                    let _e439 = (_e435 * 0.0000019073486f);
                    let _e440 = (abs(_e392) * _e439);
                    let _e441 = (abs(_e402) * _e439);
                    let _e442 = (abs(_e412) * _e439);
                    let _e446 = (_e435 * 0.0000009536743f);
                    let _e447 = (abs(_e392) * _e446);
                    let _e448 = (abs(_e402) * _e446);
                    let _e449 = (abs(_e412) * _e446);
                    let _e450 = abs(_e251);
                    let _e451 = abs(_e252);
                    let _e452 = abs(_e253);
                    if (_e450 >= _e451) {
                        if (_e450 >= _e452) {
                            phi_637_ = false;
                        } else {
                            phi_637_ = true;
                        }
                        let _e456 = phi_637_;
                        phi_638_ = _e456;
                    } else {
                        phi_638_ = true;
                    }
                    let _e458 = phi_638_;
                    if _e458 {
                        if (_e451 >= _e452) {
                            phi_646_ = 1u;
                        } else {
                            phi_646_ = 2u;
                        }
                        let _e461 = phi_646_;
                        phi_647_ = _e461;
                    } else {
                        phi_647_ = 0u;
                    }
                    let _e463 = phi_647_;
                    if (_e463 == 0u) {
                        phi_659_ = vec3<f32>(_e252, _e253, _e251);
                    } else {
                        if (_e463 == 1u) {
                            phi_658_ = vec3<f32>(_e253, _e251, _e252);
                        } else {
                            phi_658_ = vec3<f32>(_e251, _e252, _e253);
                        }
                        let _e469 = phi_658_;
                        phi_659_ = _e469;
                    }
                    let _e471 = phi_659_;
                    let _e474 = (_e471.x / _e471.z);
                    let _e477 = (_e471.y / _e471.z);
                    if (_e392 < 0f) {
                        phi_672_ = 0u;
                    } else {
                        phi_672_ = 1u;
                    }
                    let _e482 = phi_672_;
                    if (_e402 < 0f) {
                        phi_677_ = 0u;
                    } else {
                        phi_677_ = 2u;
                    }
                    let _e485 = phi_677_;
                    if (_e412 < 0f) {
                        phi_682_ = 0u;
                    } else {
                        phi_682_ = 4u;
                    }
                    let _e488 = phi_682_;
                    let _e490 = ((_e482 | _e485) | _e488);
                    let _e491 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e491.first[0], _e491.first[1], _e491.first[2], _e491.first[3], _e491.first[4], _e491.first[5], _e491.first[6], _e491.first[7], _e491.first[8], _e491.first[9], _e491.first[10], _e491.first[11], _e491.first[12], _e491.first[13], _e491.first[14], _e491.first[15], _e491.first[16], _e491.first[17], _e491.first[18], _e491.first[19], _e491.first[20], _e491.first[21], _e491.first[22], _e491.first[23], _e491.first[24], _e491.first[25], _e491.first[26], _e491.first[27], _e491.first[28], _e491.first[29], _e491.first[30], _e491.first[31]), array<u32, 32>(_e491.mask[0], _e491.mask[1], _e491.mask[2], _e491.mask[3], _e491.mask[4], _e491.mask[5], _e491.mask[6], _e491.mask[7], _e491.mask[8], _e491.mask[9], _e491.mask[10], _e491.mask[11], _e491.mask[12], _e491.mask[13], _e491.mask[14], _e491.mask[15], _e491.mask[16], _e491.mask[17], _e491.mask[18], _e491.mask[19], _e491.mask[20], _e491.mask[21], _e491.mask[22], _e491.mask[23], _e491.mask[24], _e491.mask[25], _e491.mask[26], _e491.mask[27], _e491.mask[28], _e491.mask[29], _e491.mask[30], _e491.mask[31]), _e491.len, _e491.group, _e491.group_mask);
                    let _e565 = local.group_mask;
                    if ((_e565 & 4278190080u) == 0u) {
                        let _e569 = local.len;
                        if (_e569 == 0u) {
                            phi_796_ = false;
                        } else {
                            let _e573 = local.len;
                            local.len = (_e573 - 1u);
                            let _e576 = local.len;
                            if (_e576 < 32u) {
                            } else {
                                return;
                            }
                            let _e581 = local.first[(0u + _e576)];
                            local.group = _e581;
                            let _e584 = local.len;
                            if (_e584 < 32u) {
                            } else {
                                return;
                            }
                            let _e589 = local.mask[(0u + _e584)];
                            local.group_mask = _e589;
                            phi_796_ = true;
                        }
                        let _e592 = phi_796_;
                        phi_797_ = _e592;
                    } else {
                        phi_797_ = true;
                    }
                    let _e594 = phi_797_;
                    if _e594 {
                        let _e596 = local.group_mask;
                        let _e602 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e596)), 32u, (_e596 == 0u)));
                        let _e606 = local.group_mask;
                        let _e620 = local.group_mask;
                        local.group_mask = (_e620 & ~((1u << bitcast<u32>((_e602 & 31u)))));
                        let _e623 = local.group;
                        phi_828_ = (_e623 + countOneBits(((_e606 & ~((4294967295u << bitcast<u32>((((_e602 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_828_ = 4294967295u;
                    }
                    let _e626 = phi_828_;
                    phi_830_ = _e626;
                    phi_833_ = false;
                    loop {
                        let _e628 = phi_830_;
                        let _e630 = phi_833_;
                        local_9 = _e630;
                        if (_e628 != 4294967295u) {
                            if (_e628 < _e61) {
                            } else {
                                return;
                            }
                            let _e637 = nodes.member[(0u + _e628)].frame[3u];
                            let _e662 = (bitcast<f32>((((_e637 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e392);
                            let _e663 = (bitcast<f32>((((_e637 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e402);
                            let _e664 = (bitcast<f32>((((_e637 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e412);
                            let _e667 = nodes.member[(0u + _e628)].frame[0u];
                            let _e671 = nodes.member[(0u + _e628)].frame[1u];
                            let _e675 = nodes.member[(0u + _e628)].frame[2u];
                            let _e680 = ((bitcast<f32>(_e667) - _e233) * _e392);
                            let _e681 = ((bitcast<f32>(_e671) - _e235) * _e402);
                            let _e682 = ((bitcast<f32>(_e675) - _e237) * _e412);
                            let _e690 = nodes.member[(0u + _e628)].x;
                            if (_e392 < 0f) {
                                let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e690.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e701.unnamed.word, _e690.w), _e701.unnamed_1);
                                let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_mask_LightPlace(_e690.x, _e707.unnamed_1.shift));
                                phi_913_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_mask_LightPlace(_e713.unnamed_1.word, _e690.y));
                            } else {
                                let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e690.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e729.unnamed.word, _e690.y), _e729.unnamed_1);
                                let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_mask_LightPlace(_e690.z, _e735.unnamed_1.shift));
                                phi_913_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_mask_LightPlace(_e741.unnamed_1.word, _e690.w));
                            }
                            let _e749 = phi_913_;
                            let _e759 = nodes.member[(0u + _e628)].y;
                            if (_e402 < 0f) {
                                let _e770 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e759.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e776 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e770.unnamed.word, _e759.w), _e770.unnamed_1);
                                let _e782 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e776.unnamed, lt_mask_LightPlace(_e759.x, _e776.unnamed_1.shift));
                                phi_940_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e782.unnamed, lt_mask_LightPlace(_e782.unnamed_1.word, _e759.y));
                            } else {
                                let _e798 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e759.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e804 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e798.unnamed.word, _e759.y), _e798.unnamed_1);
                                let _e810 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e804.unnamed, lt_mask_LightPlace(_e759.z, _e804.unnamed_1.shift));
                                phi_940_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e810.unnamed, lt_mask_LightPlace(_e810.unnamed_1.word, _e759.w));
                            }
                            let _e818 = phi_940_;
                            let _e828 = nodes.member[(0u + _e628)].z;
                            if (_e412 < 0f) {
                                let _e839 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e828.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e845 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e839.unnamed.word, _e828.w), _e839.unnamed_1);
                                let _e851 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e845.unnamed, lt_mask_LightPlace(_e828.x, _e845.unnamed_1.shift));
                                phi_967_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e851.unnamed, lt_mask_LightPlace(_e851.unnamed_1.word, _e828.y));
                            } else {
                                let _e867 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e828.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e873 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e867.unnamed.word, _e828.y), _e867.unnamed_1);
                                let _e879 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e873.unnamed, lt_mask_LightPlace(_e828.z, _e873.unnamed_1.shift));
                                phi_967_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e879.unnamed, lt_mask_LightPlace(_e879.unnamed_1.word, _e828.w));
                            }
                            let _e887 = phi_967_;
                            phi_973_ = 0u;
                            phi_976_ = 0u;
                            loop {
                                let _e897 = phi_973_;
                                let _e899 = phi_976_;
                                local_2 = _e899;
                                local_3 = _e899;
                                local_4 = _e899;
                                let _e900 = (_e897 < 8u);
                                if _e900 {
                                    let _e902 = (_e897 >> bitcast<u32>(2i));
                                    let _e903 = (_e897 & 3u);
                                    if (_e902 == 0u) {
                                        phi_990_ = _e749.unnamed.word;
                                    } else {
                                        phi_990_ = _e749.unnamed.shift;
                                    }
                                    let _e906 = phi_990_;
                                    if (_e902 == 0u) {
                                        phi_1000_ = _e818.unnamed.word;
                                    } else {
                                        phi_1000_ = _e818.unnamed.shift;
                                    }
                                    let _e915 = phi_1000_;
                                    if (_e902 == 0u) {
                                        phi_1010_ = _e887.unnamed.word;
                                    } else {
                                        phi_1010_ = _e887.unnamed.shift;
                                    }
                                    let _e924 = phi_1010_;
                                    let _e937 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e906 >> bitcast<u32>(((_e903 * 8u) & 31u))) & 255u)) * _e662) + (_e680 - _e440)), ((f32(((_e915 >> bitcast<u32>(((_e903 * 8u) & 31u))) & 255u)) * _e663) + (_e681 - _e441)));
                                    let _e938 = core_intrinsics_maximum_number_nsz_f32_(_e937, ((f32(((_e924 >> bitcast<u32>(((_e903 * 8u) & 31u))) & 255u)) * _e664) + (_e682 - _e442)));
                                    if (_e902 == 0u) {
                                        phi_1028_ = _e749.unnamed_1.word;
                                    } else {
                                        phi_1028_ = _e749.unnamed_1.shift;
                                    }
                                    let _e941 = phi_1028_;
                                    if (_e902 == 0u) {
                                        phi_1038_ = _e818.unnamed_1.word;
                                    } else {
                                        phi_1038_ = _e818.unnamed_1.shift;
                                    }
                                    let _e950 = phi_1038_;
                                    if (_e902 == 0u) {
                                        phi_1048_ = _e887.unnamed_1.word;
                                    } else {
                                        phi_1048_ = _e887.unnamed_1.shift;
                                    }
                                    let _e959 = phi_1048_;
                                    let _e972 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e941 >> bitcast<u32>(((_e903 * 8u) & 31u))) & 255u)) * _e662) + (_e680 + _e440)), ((f32(((_e950 >> bitcast<u32>(((_e903 * 8u) & 31u))) & 255u)) * _e663) + (_e681 + _e441)));
                                    let _e973 = core_intrinsics_minimum_number_nsz_f32_(_e972, ((f32(((_e959 >> bitcast<u32>(((_e903 * 8u) & 31u))) & 255u)) * _e664) + (_e682 + _e442)));
                                    if (_e938 <= _e973) {
                                        if (_e938 <= _e243) {
                                            if (_e973 >= 0f) {
                                                if (_e902 == 0u) {
                                                    let _e980 = nodes.member[(0u + _e628)].links[2u];
                                                    phi_1084_ = _e980;
                                                } else {
                                                    let _e983 = nodes.member[(0u + _e628)].links[3u];
                                                    phi_1084_ = _e983;
                                                }
                                                let _e985 = phi_1084_;
                                                let _e990 = ((_e985 >> bitcast<u32>(((_e903 * 8u) & 31u))) & 255u);
                                                let _e991 = (_e990 & 31u);
                                                if (_e991 >= 24u) {
                                                    phi_1097_ = (24u + ((_e991 - 24u) ^ _e490));
                                                } else {
                                                    phi_1097_ = _e991;
                                                }
                                                let _e997 = phi_1097_;
                                                phi_1102_ = (_e899 | ((_e990 >> bitcast<u32>(5i)) << bitcast<u32>((_e997 & 31u))));
                                            } else {
                                                phi_1102_ = _e899;
                                            }
                                            let _e1005 = phi_1102_;
                                            phi_1103_ = _e1005;
                                        } else {
                                            phi_1103_ = _e899;
                                        }
                                        let _e1007 = phi_1103_;
                                        phi_1104_ = _e1007;
                                    } else {
                                        phi_1104_ = _e899;
                                    }
                                    let _e1009 = phi_1104_;
                                    phi_974_ = (_e897 + 1u);
                                    phi_977_ = _e1009;
                                } else {
                                    phi_974_ = u32();
                                    phi_977_ = u32();
                                }
                                let _e1012 = phi_974_;
                                let _e1014 = phi_977_;
                                continue;
                                continuing {
                                    phi_973_ = _e1012;
                                    phi_976_ = _e1014;
                                    break if !(_e900);
                                }
                            }
                            let _e1018 = nodes.member[(0u + _e628)].links[0u];
                            let _e1022 = nodes.member[(0u + _e628)].frame[3u];
                            let _e1026 = local_2;
                            if ((_e1026 & 4278190080u) == 0u) {
                            } else {
                                let _e1030 = local.group_mask;
                                if ((_e1030 & 4278190080u) == 0u) {
                                } else {
                                    let _e1034 = local.len;
                                    if (_e1034 < 32u) {
                                        let _e1037 = local.group;
                                        let _e1039 = local.len;
                                        if (_e1039 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.first[(0u + _e1039)] = _e1037;
                                        let _e1045 = local.group_mask;
                                        let _e1047 = local.len;
                                        if (_e1047 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.mask[(0u + _e1047)] = _e1045;
                                        let _e1054 = local.len;
                                        local.len = (_e1054 + 1u);
                                    }
                                }
                                local.group = (0u + _e1018);
                                let _e1058 = local_3;
                                local.group_mask = ((_e1058 & 4278190080u) | (_e1022 >> bitcast<u32>(24i)));
                            }
                            let _e1063 = local_4;
                            phi_1162_ = (_e1063 & 16777215u);
                            phi_1165_ = _e630;
                            loop {
                                let _e1066 = phi_1162_;
                                let _e1068 = phi_1165_;
                                local_7 = _e1068;
                                let _e1069 = (_e1066 == 0u);
                                local_5 = _e1069;
                                local_8 = _e1069;
                                if _e1069 {
                                    phi_1163_ = u32();
                                    phi_1166_ = bool();
                                    phi_1763_ = false;
                                } else {
                                    let _e1072 = nodes.member[(0u + _e628)].links[1u];
                                    let _e1077 = ((0u + _e1072) + select(firstTrailingBit(_e1066), 32u, (_e1066 == 0u)));
                                    if (_e1077 < arrayLength((&triangles.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1084 = triangles.member[(0u + _e1077)].v0_;
                                    let _e1086 = (_e1084.x - _e233);
                                    let _e1088 = (_e1084.y - _e235);
                                    let _e1090 = (_e1084.z - _e237);
                                    if (_e463 == 0u) {
                                        phi_1210_ = vec3<f32>(_e1088, _e1090, _e1086);
                                    } else {
                                        if (_e463 == 1u) {
                                            phi_1209_ = vec3<f32>(_e1090, _e1086, _e1088);
                                        } else {
                                            phi_1209_ = (_e1084 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1098 = phi_1209_;
                                        phi_1210_ = _e1098;
                                    }
                                    let _e1100 = phi_1210_;
                                    let _e1104 = (_e1100.x - (_e474 * _e1100.z));
                                    let _e1108 = (_e1100.y - (_e477 * _e1100.z));
                                    let _e1110 = triangles.member[(0u + _e1077)].v1_;
                                    let _e1112 = (_e1110.x - _e233);
                                    let _e1114 = (_e1110.y - _e235);
                                    let _e1116 = (_e1110.z - _e237);
                                    if (_e463 == 0u) {
                                        phi_1240_ = vec3<f32>(_e1114, _e1116, _e1112);
                                    } else {
                                        if (_e463 == 1u) {
                                            phi_1239_ = vec3<f32>(_e1116, _e1112, _e1114);
                                        } else {
                                            phi_1239_ = (_e1110 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1124 = phi_1239_;
                                        phi_1240_ = _e1124;
                                    }
                                    let _e1126 = phi_1240_;
                                    let _e1130 = (_e1126.x - (_e474 * _e1126.z));
                                    let _e1134 = (_e1126.y - (_e477 * _e1126.z));
                                    let _e1136 = triangles.member[(0u + _e1077)].v2_;
                                    let _e1138 = (_e1136.x - _e233);
                                    let _e1140 = (_e1136.y - _e235);
                                    let _e1142 = (_e1136.z - _e237);
                                    if (_e463 == 0u) {
                                        phi_1270_ = vec3<f32>(_e1140, _e1142, _e1138);
                                    } else {
                                        if (_e463 == 1u) {
                                            phi_1269_ = vec3<f32>(_e1142, _e1138, _e1140);
                                        } else {
                                            phi_1269_ = (_e1136 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1150 = phi_1269_;
                                        phi_1270_ = _e1150;
                                    }
                                    let _e1152 = phi_1270_;
                                    let _e1156 = (_e1152.x - (_e474 * _e1152.z));
                                    let _e1160 = (_e1152.y - (_e477 * _e1152.z));
                                    if (_e1130 < _e1156) {
                                        phi_1289_ = true;
                                    } else {
                                        if (_e1130 == _e1156) {
                                            phi_1288_ = (_e1134 < _e1160);
                                        } else {
                                            phi_1288_ = false;
                                        }
                                        let _e1165 = phi_1288_;
                                        phi_1289_ = _e1165;
                                    }
                                    let _e1167 = phi_1289_;
                                    if _e1167 {
                                        phi_1293_ = _e1160;
                                        phi_1294_ = _e1156;
                                        phi_1295_ = _e1134;
                                        phi_1296_ = _e1130;
                                    } else {
                                        phi_1293_ = _e1134;
                                        phi_1294_ = _e1130;
                                        phi_1295_ = _e1160;
                                        phi_1296_ = _e1156;
                                    }
                                    let _e1169 = phi_1293_;
                                    let _e1171 = phi_1294_;
                                    let _e1173 = phi_1295_;
                                    let _e1175 = phi_1296_;
                                    let _e1178 = ((_e1175 * _e1169) - (_e1173 * _e1171));
                                    if _e1167 {
                                        phi_1304_ = -(_e1178);
                                    } else {
                                        phi_1304_ = _e1178;
                                    }
                                    let _e1181 = phi_1304_;
                                    if (_e1156 < _e1104) {
                                        phi_1315_ = true;
                                    } else {
                                        if (_e1156 == _e1104) {
                                            phi_1314_ = (_e1160 < _e1108);
                                        } else {
                                            phi_1314_ = false;
                                        }
                                        let _e1186 = phi_1314_;
                                        phi_1315_ = _e1186;
                                    }
                                    let _e1188 = phi_1315_;
                                    if _e1188 {
                                        phi_1319_ = _e1108;
                                        phi_1320_ = _e1104;
                                        phi_1321_ = _e1160;
                                        phi_1322_ = _e1156;
                                    } else {
                                        phi_1319_ = _e1160;
                                        phi_1320_ = _e1156;
                                        phi_1321_ = _e1108;
                                        phi_1322_ = _e1104;
                                    }
                                    let _e1190 = phi_1319_;
                                    let _e1192 = phi_1320_;
                                    let _e1194 = phi_1321_;
                                    let _e1196 = phi_1322_;
                                    let _e1199 = ((_e1196 * _e1190) - (_e1194 * _e1192));
                                    if _e1188 {
                                        phi_1330_ = -(_e1199);
                                    } else {
                                        phi_1330_ = _e1199;
                                    }
                                    let _e1202 = phi_1330_;
                                    if (_e1104 < _e1130) {
                                        phi_1341_ = true;
                                    } else {
                                        if (_e1104 == _e1130) {
                                            phi_1340_ = (_e1108 < _e1134);
                                        } else {
                                            phi_1340_ = false;
                                        }
                                        let _e1207 = phi_1340_;
                                        phi_1341_ = _e1207;
                                    }
                                    let _e1209 = phi_1341_;
                                    if _e1209 {
                                        phi_1345_ = _e1134;
                                        phi_1346_ = _e1130;
                                        phi_1347_ = _e1108;
                                        phi_1348_ = _e1104;
                                    } else {
                                        phi_1345_ = _e1108;
                                        phi_1346_ = _e1104;
                                        phi_1347_ = _e1134;
                                        phi_1348_ = _e1130;
                                    }
                                    let _e1211 = phi_1345_;
                                    let _e1213 = phi_1346_;
                                    let _e1215 = phi_1347_;
                                    let _e1217 = phi_1348_;
                                    let _e1220 = ((_e1217 * _e1211) - (_e1215 * _e1213));
                                    if _e1209 {
                                        phi_1356_ = -(_e1220);
                                    } else {
                                        phi_1356_ = _e1220;
                                    }
                                    let _e1223 = phi_1356_;
                                    if (_e1181 >= 0f) {
                                        if (_e1202 >= 0f) {
                                            if (_e1223 >= 0f) {
                                                phi_1371_ = ((_e1181 + _e1202) + _e1223);
                                                phi_1372_ = false;
                                            } else {
                                                phi_1371_ = f32();
                                                phi_1372_ = true;
                                            }
                                            let _e1230 = phi_1371_;
                                            let _e1232 = phi_1372_;
                                            phi_1373_ = _e1230;
                                            phi_1374_ = _e1232;
                                        } else {
                                            phi_1373_ = f32();
                                            phi_1374_ = true;
                                        }
                                        let _e1234 = phi_1373_;
                                        let _e1236 = phi_1374_;
                                        phi_1375_ = _e1234;
                                        phi_1376_ = _e1236;
                                    } else {
                                        phi_1375_ = f32();
                                        phi_1376_ = true;
                                    }
                                    let _e1238 = phi_1375_;
                                    let _e1240 = phi_1376_;
                                    if _e1240 {
                                        if (_e1181 <= 0f) {
                                            if (_e1202 <= 0f) {
                                                let _e1243 = (_e1223 <= 0f);
                                                if _e1243 {
                                                }
                                                phi_1394_ = ((_e1181 + _e1202) + _e1223);
                                                phi_1395_ = false;
                                                phi_1396_ = _e1243;
                                            } else {
                                                phi_1394_ = f32();
                                                phi_1395_ = true;
                                                phi_1396_ = false;
                                            }
                                            let _e1247 = phi_1394_;
                                            let _e1249 = phi_1395_;
                                            let _e1251 = phi_1396_;
                                            phi_1397_ = _e1247;
                                            phi_1398_ = _e1249;
                                            phi_1399_ = _e1251;
                                        } else {
                                            phi_1397_ = f32();
                                            phi_1398_ = true;
                                            phi_1399_ = false;
                                        }
                                        let _e1253 = phi_1397_;
                                        let _e1255 = phi_1398_;
                                        let _e1257 = phi_1399_;
                                        if _e1255 {
                                            phi_1403_ = false;
                                        } else {
                                            phi_1403_ = _e1257;
                                        }
                                        let _e1259 = phi_1403_;
                                        phi_1404_ = _e1253;
                                        phi_1405_ = _e1259;
                                    } else {
                                        phi_1404_ = _e1238;
                                        phi_1405_ = true;
                                    }
                                    let _e1261 = phi_1404_;
                                    let _e1263 = phi_1405_;
                                    if _e1263 {
                                        let _e1264 = (_e1261 == 0f);
                                        if _e1264 {
                                            phi_1721_ = lt_bvh_triangle_Intersection();
                                            phi_1722_ = false;
                                        } else {
                                            let _e1266 = triangles.member[(0u + _e1077)].v0_;
                                            let _e1268 = (_e1266.x - _e233);
                                            let _e1270 = (_e1266.y - _e235);
                                            let _e1272 = (_e1266.z - _e237);
                                            if (_e463 == 0u) {
                                                phi_1434_ = vec3<f32>(_e1270, _e1272, _e1268);
                                            } else {
                                                if (_e463 == 1u) {
                                                    phi_1433_ = vec3<f32>(_e1272, _e1268, _e1270);
                                                } else {
                                                    phi_1433_ = (_e1266 - vec3<f32>(_e233, _e235, _e237));
                                                }
                                                let _e1280 = phi_1433_;
                                                phi_1434_ = _e1280;
                                            }
                                            let _e1282 = phi_1434_;
                                            let _e1284 = triangles.member[(0u + _e1077)].v1_;
                                            let _e1286 = triangles.member[(0u + _e1077)].v0_;
                                            let _e1289 = (_e1284.x - _e1286.x);
                                            let _e1292 = (_e1284.y - _e1286.y);
                                            let _e1295 = (_e1284.z - _e1286.z);
                                            if (_e463 == 0u) {
                                                phi_1460_ = vec3<f32>(_e1292, _e1295, _e1289);
                                            } else {
                                                if (_e463 == 1u) {
                                                    phi_1459_ = vec3<f32>(_e1295, _e1289, _e1292);
                                                } else {
                                                    phi_1459_ = (_e1284 - _e1286);
                                                }
                                                let _e1302 = phi_1459_;
                                                phi_1460_ = _e1302;
                                            }
                                            let _e1304 = phi_1460_;
                                            let _e1306 = triangles.member[(0u + _e1077)].v2_;
                                            let _e1308 = triangles.member[(0u + _e1077)].v0_;
                                            let _e1311 = (_e1306.x - _e1308.x);
                                            let _e1314 = (_e1306.y - _e1308.y);
                                            let _e1317 = (_e1306.z - _e1308.z);
                                            if (_e463 == 0u) {
                                                phi_1486_ = vec3<f32>(_e1314, _e1317, _e1311);
                                            } else {
                                                if (_e463 == 1u) {
                                                    phi_1485_ = vec3<f32>(_e1317, _e1311, _e1314);
                                                } else {
                                                    phi_1485_ = (_e1306 - _e1308);
                                                }
                                                let _e1324 = phi_1485_;
                                                phi_1486_ = _e1324;
                                            }
                                            let _e1326 = phi_1486_;
                                            let _e1333 = ((_e1304.y * _e1326.z) - (_e1304.z * _e1326.y));
                                            let _e1340 = ((_e1304.z * _e1326.x) - (_e1304.x * _e1326.z));
                                            let _e1347 = ((_e1304.x * _e1326.y) - (_e1304.y * _e1326.x));
                                            let _e1361 = (((1f / _e471.z) * (((_e1333 * _e1282.x) + (_e1340 * _e1282.y)) + (_e1347 * _e1282.z))) / (((_e1333 * _e474) + (_e1340 * _e477)) + _e1347));
                                            if (_e1361 > 0f) {
                                                if (_e1361 < _e243) {
                                                    let _e1365 = triangles.member[(0u + _e1077)].v0_;
                                                    let _e1367 = triangles.member[(0u + _e1077)].v1_;
                                                    if (_e1365.x < _e1367.x) {
                                                        phi_1542_ = _e1365.x;
                                                    } else {
                                                        phi_1542_ = _e1367.x;
                                                    }
                                                    let _e1374 = phi_1542_;
                                                    if (_e1365.y < _e1367.y) {
                                                        phi_1551_ = _e1365.y;
                                                    } else {
                                                        phi_1551_ = _e1367.y;
                                                    }
                                                    let _e1381 = phi_1551_;
                                                    if (_e1365.z < _e1367.z) {
                                                        phi_1560_ = _e1365.z;
                                                    } else {
                                                        phi_1560_ = _e1367.z;
                                                    }
                                                    let _e1388 = phi_1560_;
                                                    let _e1390 = triangles.member[(0u + _e1077)].v2_;
                                                    if (_e1374 < _e1390.x) {
                                                        phi_1569_ = _e1374;
                                                    } else {
                                                        phi_1569_ = _e1390.x;
                                                    }
                                                    let _e1395 = phi_1569_;
                                                    if (_e1381 < _e1390.y) {
                                                        phi_1576_ = _e1381;
                                                    } else {
                                                        phi_1576_ = _e1390.y;
                                                    }
                                                    let _e1400 = phi_1576_;
                                                    if (_e1388 < _e1390.z) {
                                                        phi_1583_ = _e1388;
                                                    } else {
                                                        phi_1583_ = _e1390.z;
                                                    }
                                                    let _e1405 = phi_1583_;
                                                    let _e1407 = triangles.member[(0u + _e1077)].v0_;
                                                    let _e1409 = triangles.member[(0u + _e1077)].v1_;
                                                    if (_e1407.x > _e1409.x) {
                                                        phi_1596_ = _e1407.x;
                                                    } else {
                                                        phi_1596_ = _e1409.x;
                                                    }
                                                    let _e1416 = phi_1596_;
                                                    if (_e1407.y > _e1409.y) {
                                                        phi_1605_ = _e1407.y;
                                                    } else {
                                                        phi_1605_ = _e1409.y;
                                                    }
                                                    let _e1423 = phi_1605_;
                                                    if (_e1407.z > _e1409.z) {
                                                        phi_1614_ = _e1407.z;
                                                    } else {
                                                        phi_1614_ = _e1409.z;
                                                    }
                                                    let _e1430 = phi_1614_;
                                                    let _e1432 = triangles.member[(0u + _e1077)].v2_;
                                                    if (_e1416 > _e1432.x) {
                                                        phi_1623_ = _e1416;
                                                    } else {
                                                        phi_1623_ = _e1432.x;
                                                    }
                                                    let _e1437 = phi_1623_;
                                                    if (_e1423 > _e1432.y) {
                                                        phi_1630_ = _e1423;
                                                    } else {
                                                        phi_1630_ = _e1432.y;
                                                    }
                                                    let _e1442 = phi_1630_;
                                                    if (_e1430 > _e1432.z) {
                                                        phi_1637_ = _e1430;
                                                    } else {
                                                        phi_1637_ = _e1432.z;
                                                    }
                                                    let _e1447 = phi_1637_;
                                                    let _e1451 = ((_e1395 - _e233) * _e392);
                                                    let _e1452 = ((_e1400 - _e235) * _e402);
                                                    let _e1453 = ((_e1405 - _e237) * _e412);
                                                    let _e1457 = ((_e1437 - _e233) * _e392);
                                                    let _e1458 = ((_e1442 - _e235) * _e402);
                                                    let _e1459 = ((_e1447 - _e237) * _e412);
                                                    if (_e1451 < _e1457) {
                                                        phi_1654_ = _e1451;
                                                    } else {
                                                        phi_1654_ = _e1457;
                                                    }
                                                    let _e1462 = phi_1654_;
                                                    if (_e1452 < _e1458) {
                                                        phi_1659_ = _e1452;
                                                    } else {
                                                        phi_1659_ = _e1458;
                                                    }
                                                    let _e1465 = phi_1659_;
                                                    if (_e1453 < _e1459) {
                                                        phi_1664_ = _e1453;
                                                    } else {
                                                        phi_1664_ = _e1459;
                                                    }
                                                    let _e1468 = phi_1664_;
                                                    if (_e1451 > _e1457) {
                                                        phi_1672_ = _e1451;
                                                    } else {
                                                        phi_1672_ = _e1457;
                                                    }
                                                    let _e1474 = phi_1672_;
                                                    if (_e1452 > _e1458) {
                                                        phi_1677_ = _e1452;
                                                    } else {
                                                        phi_1677_ = _e1458;
                                                    }
                                                    let _e1477 = phi_1677_;
                                                    if (_e1453 > _e1459) {
                                                        phi_1682_ = _e1453;
                                                    } else {
                                                        phi_1682_ = _e1459;
                                                    }
                                                    let _e1480 = phi_1682_;
                                                    let _e1484 = core_intrinsics_maximum_number_nsz_f32_((_e1462 - _e447), (_e1465 - _e448));
                                                    let _e1485 = core_intrinsics_maximum_number_nsz_f32_(_e1484, (_e1468 - _e449));
                                                    let _e1486 = core_intrinsics_minimum_number_nsz_f32_((_e1474 + _e447), (_e1477 + _e448));
                                                    let _e1487 = core_intrinsics_minimum_number_nsz_f32_(_e1486, (_e1480 + _e449));
                                                    if (_e1485 > -300000000000000000000000000000000000000f) {
                                                        phi_1694_ = _e1485;
                                                    } else {
                                                        phi_1694_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1490 = phi_1694_;
                                                    if (_e1487 < 300000000000000000000000000000000000000f) {
                                                        phi_1699_ = _e1487;
                                                    } else {
                                                        phi_1699_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1493 = phi_1699_;
                                                    if (_e1361 < _e1490) {
                                                        phi_1704_ = _e1490;
                                                    } else {
                                                        phi_1704_ = _e1361;
                                                    }
                                                    let _e1496 = phi_1704_;
                                                    if (_e1496 > _e1493) {
                                                        phi_1709_ = _e1493;
                                                    } else {
                                                        phi_1709_ = _e1496;
                                                    }
                                                    let _e1499 = phi_1709_;
                                                    phi_1714_ = lt_bvh_triangle_Intersection(_e1499, (_e1202 / _e1261), (_e1223 / _e1261), (_e1490 <= _e1493));
                                                    phi_1715_ = false;
                                                } else {
                                                    phi_1714_ = lt_bvh_triangle_Intersection();
                                                    phi_1715_ = true;
                                                }
                                                let _e1505 = phi_1714_;
                                                let _e1507 = phi_1715_;
                                                phi_1716_ = _e1505;
                                                phi_1717_ = _e1507;
                                            } else {
                                                phi_1716_ = lt_bvh_triangle_Intersection();
                                                phi_1717_ = true;
                                            }
                                            let _e1509 = phi_1716_;
                                            let _e1511 = phi_1717_;
                                            if _e1511 {
                                            }
                                            phi_1721_ = _e1509;
                                            phi_1722_ = _e1511;
                                        }
                                        let _e1513 = phi_1721_;
                                        let _e1515 = phi_1722_;
                                        phi_1723_ = _e1513;
                                        phi_1724_ = _e1264;
                                        phi_1725_ = _e1515;
                                    } else {
                                        phi_1723_ = lt_bvh_triangle_Intersection();
                                        phi_1724_ = true;
                                        phi_1725_ = false;
                                    }
                                    let _e1517 = phi_1723_;
                                    let _e1519 = phi_1724_;
                                    let _e1521 = phi_1725_;
                                    if _e1519 {
                                        phi_1729_ = true;
                                    } else {
                                        phi_1729_ = _e1521;
                                    }
                                    let _e1523 = phi_1729_;
                                    if _e1523 {
                                        phi_1733_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1733_ = _e1517;
                                    }
                                    let _e1525 = phi_1733_;
                                    if _e1525.is_hit {
                                        if (_e1525.t > 0f) {
                                            if (_e1525.t < _e243) {
                                                if true {
                                                    phi_1753_ = false;
                                                } else {
                                                    phi_1753_ = true;
                                                }
                                                let _e1534 = phi_1753_;
                                                phi_1754_ = true;
                                                phi_1755_ = _e1534;
                                            } else {
                                                phi_1754_ = _e1068;
                                                phi_1755_ = true;
                                            }
                                            let _e1536 = phi_1754_;
                                            let _e1538 = phi_1755_;
                                            phi_1756_ = _e1536;
                                            phi_1757_ = _e1538;
                                        } else {
                                            phi_1756_ = _e1068;
                                            phi_1757_ = true;
                                        }
                                        let _e1540 = phi_1756_;
                                        let _e1542 = phi_1757_;
                                        phi_1758_ = _e1540;
                                        phi_1759_ = _e1542;
                                    } else {
                                        phi_1758_ = _e1068;
                                        phi_1759_ = true;
                                    }
                                    let _e1544 = phi_1758_;
                                    let _e1546 = phi_1759_;
                                    if _e1546 {
                                    }
                                    phi_1163_ = (_e1066 & (_e1066 - 1u));
                                    phi_1166_ = _e1544;
                                    phi_1763_ = _e1546;
                                }
                                let _e1548 = phi_1163_;
                                let _e1550 = phi_1166_;
                                let _e1552 = phi_1763_;
                                continue;
                                continuing {
                                    phi_1162_ = _e1548;
                                    phi_1165_ = _e1550;
                                    break if !(_e1552);
                                }
                            }
                            let _e1555 = local_5;
                            if _e1555 {
                                let _e1557 = local.group_mask;
                                if ((_e1557 & 4278190080u) == 0u) {
                                    let _e1561 = local.len;
                                    if (_e1561 == 0u) {
                                        phi_1805_ = false;
                                    } else {
                                        let _e1565 = local.len;
                                        local.len = (_e1565 - 1u);
                                        let _e1568 = local.len;
                                        if (_e1568 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1573 = local.first[(0u + _e1568)];
                                        local.group = _e1573;
                                        let _e1576 = local.len;
                                        if (_e1576 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1581 = local.mask[(0u + _e1576)];
                                        local.group_mask = _e1581;
                                        phi_1805_ = true;
                                    }
                                    let _e1584 = phi_1805_;
                                    phi_1806_ = _e1584;
                                } else {
                                    phi_1806_ = true;
                                }
                                let _e1586 = phi_1806_;
                                if _e1586 {
                                    let _e1588 = local.group_mask;
                                    let _e1594 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1588)), 32u, (_e1588 == 0u)));
                                    let _e1598 = local.group_mask;
                                    let _e1612 = local.group_mask;
                                    local.group_mask = (_e1612 & ~((1u << bitcast<u32>((_e1594 & 31u)))));
                                    let _e1615 = local.group;
                                    phi_1837_ = (_e1615 + countOneBits(((_e1598 & ~((4294967295u << bitcast<u32>((((_e1594 - 24u) ^ _e490) & 31u))))) & 255u)));
                                } else {
                                    phi_1837_ = 4294967295u;
                                }
                                let _e1618 = phi_1837_;
                                phi_1838_ = _e1618;
                            } else {
                                phi_1838_ = u32();
                            }
                            let _e1620 = phi_1838_;
                            phi_831_ = _e1620;
                            let _e1828 = local_7;
                            phi_834_ = _e1828;
                            let _e1831 = local_8;
                            phi_1839_ = _e1831;
                            phi_1840_ = false;
                        } else {
                            phi_831_ = u32();
                            phi_834_ = bool();
                            phi_1839_ = false;
                            phi_1840_ = true;
                        }
                        let _e1622 = phi_831_;
                        let _e1624 = phi_834_;
                        let _e1626 = phi_1839_;
                        let _e1628 = phi_1840_;
                        local_6 = _e1628;
                        continue;
                        continuing {
                            phi_830_ = _e1622;
                            phi_833_ = _e1624;
                            break if !(_e1626);
                        }
                    }
                    let _e1631 = local_6;
                    if _e1631 {
                        phi_1844_ = false;
                    } else {
                        phi_1844_ = true;
                    }
                    let _e1633 = phi_1844_;
                    if _e1633 {
                        phi_1848_ = true;
                    } else {
                        let _e1837 = local_9;
                        phi_1848_ = _e1837;
                    }
                    let _e1635 = phi_1848_;
                    phi_1849_ = _e1635;
                }
                let _e1637 = phi_1849_;
                phi_1850_ = _e1637;
                phi_1851_ = _e316;
            } else {
                phi_1850_ = bool();
                phi_1851_ = true;
            }
            let _e1639 = phi_1850_;
            let _e1641 = phi_1851_;
            if _e1641 {
                phi_1855_ = false;
            } else {
                phi_1855_ = _e1639;
            }
            let _e1643 = phi_1855_;
            if _e1643 {
                phi_1859_ = 0f;
            } else {
                phi_1859_ = 1f;
            }
            let _e1645 = phi_1859_;
            phi_1860_ = _e1645;
        }
        let _e1647 = phi_1860_;
        if (_e73.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.shift)] = _e1647;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
