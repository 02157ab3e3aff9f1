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
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
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

struct type_31 {
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

struct type_40 {
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

struct type_48 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_48;
@group(0) @binding(2) 
var<storage> nodes: type_40;
@group(0) @binding(3) 
var<storage> triangles: type_31;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_173_: lt_bvh_traverse_Tree;
    var phi_174_: bool;
    var phi_175_: lt_bvh_traverse_Tree;
    var phi_176_: bool;
    var phi_181_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_173_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_174_ = false;
        } else {
            phi_173_ = lt_bvh_traverse_Tree();
            phi_174_ = true;
        }
        let _e65 = phi_173_;
        let _e67 = phi_174_;
        phi_175_ = _e65;
        phi_176_ = _e67;
    } else {
        phi_175_ = lt_bvh_traverse_Tree();
        phi_176_ = true;
    }
    let _e69 = phi_175_;
    let _e71 = phi_176_;
    if _e71 {
        phi_181_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_181_ = _e69;
    }
    let _e76 = phi_181_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
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
    var phi_1910_: bool;
    var phi_1911_: bool;
    var phi_1912_: bool;
    var phi_1913_: bool;
    var phi_1917_: bool;

    let _e55 = (*param_7).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_7).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_7).normal[2u];
            let _e67 = global[2u];
            phi_1910_ = (_e65 == _e67);
            phi_1911_ = false;
        } else {
            phi_1910_ = bool();
            phi_1911_ = true;
        }
        let _e70 = phi_1910_;
        let _e72 = phi_1911_;
        phi_1912_ = _e70;
        phi_1913_ = _e72;
    } else {
        phi_1912_ = bool();
        phi_1913_ = true;
    }
    let _e74 = phi_1912_;
    let _e76 = phi_1913_;
    if _e76 {
        phi_1917_ = false;
    } else {
        phi_1917_ = _e74;
    }
    let _e78 = phi_1917_;
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
    var phi_911_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_938_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_965_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_971_: u32;
    var phi_974_: u32;
    var phi_988_: u32;
    var phi_998_: u32;
    var phi_1008_: u32;
    var phi_1026_: u32;
    var phi_1036_: u32;
    var phi_1046_: u32;
    var phi_1082_: u32;
    var phi_1095_: u32;
    var phi_1100_: u32;
    var phi_1101_: u32;
    var phi_1102_: u32;
    var phi_972_: u32;
    var phi_975_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1160_: u32;
    var phi_1205_: vec3<f32>;
    var phi_1206_: vec3<f32>;
    var phi_1235_: vec3<f32>;
    var phi_1236_: vec3<f32>;
    var phi_1265_: vec3<f32>;
    var phi_1266_: vec3<f32>;
    var phi_1284_: bool;
    var phi_1285_: bool;
    var phi_1289_: f32;
    var phi_1290_: f32;
    var phi_1291_: f32;
    var phi_1292_: f32;
    var phi_1300_: f32;
    var phi_1310_: bool;
    var phi_1311_: bool;
    var phi_1315_: f32;
    var phi_1316_: f32;
    var phi_1317_: f32;
    var phi_1318_: f32;
    var phi_1326_: f32;
    var phi_1336_: bool;
    var phi_1337_: bool;
    var phi_1341_: f32;
    var phi_1342_: f32;
    var phi_1343_: f32;
    var phi_1344_: f32;
    var phi_1352_: f32;
    var phi_1367_: f32;
    var phi_1368_: bool;
    var phi_1369_: f32;
    var phi_1370_: bool;
    var phi_1371_: f32;
    var phi_1372_: bool;
    var phi_1390_: f32;
    var phi_1391_: bool;
    var phi_1392_: bool;
    var phi_1393_: f32;
    var phi_1394_: bool;
    var phi_1395_: bool;
    var phi_1399_: bool;
    var phi_1400_: f32;
    var phi_1401_: bool;
    var phi_1429_: vec3<f32>;
    var phi_1430_: vec3<f32>;
    var phi_1455_: vec3<f32>;
    var phi_1456_: vec3<f32>;
    var phi_1481_: vec3<f32>;
    var phi_1482_: vec3<f32>;
    var phi_1538_: f32;
    var phi_1547_: f32;
    var phi_1556_: f32;
    var phi_1565_: f32;
    var phi_1572_: f32;
    var phi_1579_: f32;
    var phi_1592_: f32;
    var phi_1601_: f32;
    var phi_1610_: f32;
    var phi_1619_: f32;
    var phi_1626_: f32;
    var phi_1633_: f32;
    var phi_1650_: f32;
    var phi_1655_: f32;
    var phi_1660_: f32;
    var phi_1668_: f32;
    var phi_1673_: f32;
    var phi_1678_: f32;
    var phi_1690_: f32;
    var phi_1695_: f32;
    var phi_1700_: f32;
    var phi_1705_: f32;
    var phi_1710_: lt_bvh_triangle_Intersection;
    var phi_1711_: bool;
    var phi_1712_: lt_bvh_triangle_Intersection;
    var phi_1713_: bool;
    var phi_1717_: lt_bvh_triangle_Intersection;
    var phi_1718_: bool;
    var phi_1719_: lt_bvh_triangle_Intersection;
    var phi_1720_: bool;
    var phi_1721_: bool;
    var phi_1725_: bool;
    var phi_1729_: lt_bvh_triangle_Intersection;
    var phi_1754_: bool;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1757_: bool;
    var phi_1758_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1769_: bool;
    var phi_1770_: bool;
    var phi_1161_: u32;
    var phi_1771_: bool;
    var phi_1772_: bool;
    var phi_1773_: bool;
    var local_5: bool;
    var phi_1815_: bool;
    var phi_1816_: bool;
    var phi_1847_: u32;
    var phi_1848_: u32;
    var phi_1849_: bool;
    var phi_1850_: bool;
    var phi_831_: u32;
    var phi_1851_: bool;
    var phi_1852_: bool;
    var phi_1853_: bool;
    var phi_1854_: bool;
    var local_6: bool;
    var phi_1858_: bool;
    var phi_1859_: bool;
    var phi_1863_: bool;
    var phi_1867_: bool;
    var phi_1868_: bool;
    var phi_1869_: bool;
    var phi_1870_: bool;
    var phi_1874_: bool;
    var phi_1878_: f32;
    var phi_1879_: f32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;

    let _e54 = id_1;
    let _e61 = arrayLength((&nodes.member));
    let _e70 = p.member.size[0u];
    let _e72 = p.member.size[1u];
    let _e73 = lt_shaders_entry_pixel_index(_e54, _e70, _e72);
    if (bitcast<i32>(_e73.root) != 0i) {
        if (_e73.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e81 = samples.member[(0u + _e73.first_primitive)];
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
            phi_1879_ = _e213.unnamed.visibility;
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
                    phi_1868_ = bool();
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
                    loop {
                        let _e628 = phi_830_;
                        if (_e628 != 4294967295u) {
                            if (_e628 < _e61) {
                            } else {
                                return;
                            }
                            let _e635 = nodes.member[(0u + _e628)].frame[3u];
                            let _e660 = (bitcast<f32>((((_e635 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e392);
                            let _e661 = (bitcast<f32>((((_e635 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e402);
                            let _e662 = (bitcast<f32>((((_e635 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e412);
                            let _e665 = nodes.member[(0u + _e628)].frame[0u];
                            let _e669 = nodes.member[(0u + _e628)].frame[1u];
                            let _e673 = nodes.member[(0u + _e628)].frame[2u];
                            let _e678 = ((bitcast<f32>(_e665) - _e233) * _e392);
                            let _e679 = ((bitcast<f32>(_e669) - _e235) * _e402);
                            let _e680 = ((bitcast<f32>(_e673) - _e237) * _e412);
                            let _e688 = nodes.member[(0u + _e628)].x;
                            if (_e392 < 0f) {
                                let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e699.unnamed.root, _e688.w), _e699.unnamed_1);
                                let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e705.unnamed, lt_bvh_traverse_Tree(_e688.x, _e705.unnamed_1.first_primitive));
                                phi_911_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_bvh_traverse_Tree(_e711.unnamed_1.root, _e688.y));
                            } else {
                                let _e727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e727.unnamed.root, _e688.y), _e727.unnamed_1);
                                let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e733.unnamed, lt_bvh_traverse_Tree(_e688.z, _e733.unnamed_1.first_primitive));
                                phi_911_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_bvh_traverse_Tree(_e739.unnamed_1.root, _e688.w));
                            }
                            let _e747 = phi_911_;
                            let _e757 = nodes.member[(0u + _e628)].y;
                            if (_e402 < 0f) {
                                let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e768.unnamed.root, _e757.w), _e768.unnamed_1);
                                let _e780 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e774.unnamed, lt_bvh_traverse_Tree(_e757.x, _e774.unnamed_1.first_primitive));
                                phi_938_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e780.unnamed, lt_bvh_traverse_Tree(_e780.unnamed_1.root, _e757.y));
                            } else {
                                let _e796 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e802 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e796.unnamed.root, _e757.y), _e796.unnamed_1);
                                let _e808 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e802.unnamed, lt_bvh_traverse_Tree(_e757.z, _e802.unnamed_1.first_primitive));
                                phi_938_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e808.unnamed, lt_bvh_traverse_Tree(_e808.unnamed_1.root, _e757.w));
                            }
                            let _e816 = phi_938_;
                            let _e826 = nodes.member[(0u + _e628)].z;
                            if (_e412 < 0f) {
                                let _e837 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e826.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e843 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e837.unnamed.root, _e826.w), _e837.unnamed_1);
                                let _e849 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e843.unnamed, lt_bvh_traverse_Tree(_e826.x, _e843.unnamed_1.first_primitive));
                                phi_965_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e849.unnamed, lt_bvh_traverse_Tree(_e849.unnamed_1.root, _e826.y));
                            } else {
                                let _e865 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e826.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e871 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e865.unnamed.root, _e826.y), _e865.unnamed_1);
                                let _e877 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e871.unnamed, lt_bvh_traverse_Tree(_e826.z, _e871.unnamed_1.first_primitive));
                                phi_965_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e877.unnamed, lt_bvh_traverse_Tree(_e877.unnamed_1.root, _e826.w));
                            }
                            let _e885 = phi_965_;
                            phi_971_ = 0u;
                            phi_974_ = 0u;
                            loop {
                                let _e895 = phi_971_;
                                let _e897 = phi_974_;
                                local_2 = _e897;
                                local_3 = _e897;
                                local_4 = _e897;
                                let _e898 = (_e895 < 8u);
                                if _e898 {
                                    let _e900 = (_e895 >> bitcast<u32>(2i));
                                    let _e901 = (_e895 & 3u);
                                    if (_e900 == 0u) {
                                        phi_988_ = _e747.unnamed.root;
                                    } else {
                                        phi_988_ = _e747.unnamed.first_primitive;
                                    }
                                    let _e904 = phi_988_;
                                    if (_e900 == 0u) {
                                        phi_998_ = _e816.unnamed.root;
                                    } else {
                                        phi_998_ = _e816.unnamed.first_primitive;
                                    }
                                    let _e913 = phi_998_;
                                    if (_e900 == 0u) {
                                        phi_1008_ = _e885.unnamed.root;
                                    } else {
                                        phi_1008_ = _e885.unnamed.first_primitive;
                                    }
                                    let _e922 = phi_1008_;
                                    let _e935 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e904 >> bitcast<u32>(((_e901 * 8u) & 31u))) & 255u)) * _e660) + (_e678 - _e440)), ((f32(((_e913 >> bitcast<u32>(((_e901 * 8u) & 31u))) & 255u)) * _e661) + (_e679 - _e441)));
                                    let _e936 = core_intrinsics_maximum_number_nsz_f32_(_e935, ((f32(((_e922 >> bitcast<u32>(((_e901 * 8u) & 31u))) & 255u)) * _e662) + (_e680 - _e442)));
                                    if (_e900 == 0u) {
                                        phi_1026_ = _e747.unnamed_1.root;
                                    } else {
                                        phi_1026_ = _e747.unnamed_1.first_primitive;
                                    }
                                    let _e939 = phi_1026_;
                                    if (_e900 == 0u) {
                                        phi_1036_ = _e816.unnamed_1.root;
                                    } else {
                                        phi_1036_ = _e816.unnamed_1.first_primitive;
                                    }
                                    let _e948 = phi_1036_;
                                    if (_e900 == 0u) {
                                        phi_1046_ = _e885.unnamed_1.root;
                                    } else {
                                        phi_1046_ = _e885.unnamed_1.first_primitive;
                                    }
                                    let _e957 = phi_1046_;
                                    let _e970 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e939 >> bitcast<u32>(((_e901 * 8u) & 31u))) & 255u)) * _e660) + (_e678 + _e440)), ((f32(((_e948 >> bitcast<u32>(((_e901 * 8u) & 31u))) & 255u)) * _e661) + (_e679 + _e441)));
                                    let _e971 = core_intrinsics_minimum_number_nsz_f32_(_e970, ((f32(((_e957 >> bitcast<u32>(((_e901 * 8u) & 31u))) & 255u)) * _e662) + (_e680 + _e442)));
                                    if (_e936 <= _e971) {
                                        if (_e936 <= _e243) {
                                            if (_e971 >= 0f) {
                                                if (_e900 == 0u) {
                                                    let _e978 = nodes.member[(0u + _e628)].links[2u];
                                                    phi_1082_ = _e978;
                                                } else {
                                                    let _e981 = nodes.member[(0u + _e628)].links[3u];
                                                    phi_1082_ = _e981;
                                                }
                                                let _e983 = phi_1082_;
                                                let _e988 = ((_e983 >> bitcast<u32>(((_e901 * 8u) & 31u))) & 255u);
                                                let _e989 = (_e988 & 31u);
                                                if (_e989 >= 24u) {
                                                    phi_1095_ = (24u + ((_e989 - 24u) ^ _e490));
                                                } else {
                                                    phi_1095_ = _e989;
                                                }
                                                let _e995 = phi_1095_;
                                                phi_1100_ = (_e897 | ((_e988 >> bitcast<u32>(5i)) << bitcast<u32>((_e995 & 31u))));
                                            } else {
                                                phi_1100_ = _e897;
                                            }
                                            let _e1003 = phi_1100_;
                                            phi_1101_ = _e1003;
                                        } else {
                                            phi_1101_ = _e897;
                                        }
                                        let _e1005 = phi_1101_;
                                        phi_1102_ = _e1005;
                                    } else {
                                        phi_1102_ = _e897;
                                    }
                                    let _e1007 = phi_1102_;
                                    phi_972_ = (_e895 + 1u);
                                    phi_975_ = _e1007;
                                } else {
                                    phi_972_ = u32();
                                    phi_975_ = u32();
                                }
                                let _e1010 = phi_972_;
                                let _e1012 = phi_975_;
                                continue;
                                continuing {
                                    phi_971_ = _e1010;
                                    phi_974_ = _e1012;
                                    break if !(_e898);
                                }
                            }
                            let _e1016 = nodes.member[(0u + _e628)].links[0u];
                            let _e1020 = nodes.member[(0u + _e628)].frame[3u];
                            let _e1024 = local_2;
                            if ((_e1024 & 4278190080u) == 0u) {
                            } else {
                                let _e1028 = local.group_mask;
                                if ((_e1028 & 4278190080u) == 0u) {
                                } else {
                                    let _e1032 = local.len;
                                    if (_e1032 < 32u) {
                                        let _e1035 = local.group;
                                        let _e1037 = local.len;
                                        if (_e1037 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.first[(0u + _e1037)] = _e1035;
                                        let _e1043 = local.group_mask;
                                        let _e1045 = local.len;
                                        if (_e1045 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.mask[(0u + _e1045)] = _e1043;
                                        let _e1052 = local.len;
                                        local.len = (_e1052 + 1u);
                                    }
                                }
                                local.group = (0u + _e1016);
                                let _e1056 = local_3;
                                local.group_mask = ((_e1056 & 4278190080u) | (_e1020 >> bitcast<u32>(24i)));
                            }
                            let _e1061 = local_4;
                            phi_1160_ = (_e1061 & 16777215u);
                            loop {
                                let _e1064 = phi_1160_;
                                let _e1065 = (_e1064 == 0u);
                                local_5 = _e1065;
                                local_9 = _e1065;
                                if _e1065 {
                                    phi_1161_ = u32();
                                    phi_1771_ = false;
                                    phi_1772_ = false;
                                    phi_1773_ = false;
                                } else {
                                    let _e1068 = nodes.member[(0u + _e628)].links[1u];
                                    let _e1073 = ((0u + _e1068) + select(firstTrailingBit(_e1064), 32u, (_e1064 == 0u)));
                                    if (_e1073 < arrayLength((&triangles.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1080 = triangles.member[(0u + _e1073)].v0_;
                                    let _e1082 = (_e1080.x - _e233);
                                    let _e1084 = (_e1080.y - _e235);
                                    let _e1086 = (_e1080.z - _e237);
                                    if (_e463 == 0u) {
                                        phi_1206_ = vec3<f32>(_e1084, _e1086, _e1082);
                                    } else {
                                        if (_e463 == 1u) {
                                            phi_1205_ = vec3<f32>(_e1086, _e1082, _e1084);
                                        } else {
                                            phi_1205_ = (_e1080 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1094 = phi_1205_;
                                        phi_1206_ = _e1094;
                                    }
                                    let _e1096 = phi_1206_;
                                    let _e1100 = (_e1096.x - (_e474 * _e1096.z));
                                    let _e1104 = (_e1096.y - (_e477 * _e1096.z));
                                    let _e1106 = triangles.member[(0u + _e1073)].v1_;
                                    let _e1108 = (_e1106.x - _e233);
                                    let _e1110 = (_e1106.y - _e235);
                                    let _e1112 = (_e1106.z - _e237);
                                    if (_e463 == 0u) {
                                        phi_1236_ = vec3<f32>(_e1110, _e1112, _e1108);
                                    } else {
                                        if (_e463 == 1u) {
                                            phi_1235_ = vec3<f32>(_e1112, _e1108, _e1110);
                                        } else {
                                            phi_1235_ = (_e1106 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1120 = phi_1235_;
                                        phi_1236_ = _e1120;
                                    }
                                    let _e1122 = phi_1236_;
                                    let _e1126 = (_e1122.x - (_e474 * _e1122.z));
                                    let _e1130 = (_e1122.y - (_e477 * _e1122.z));
                                    let _e1132 = triangles.member[(0u + _e1073)].v2_;
                                    let _e1134 = (_e1132.x - _e233);
                                    let _e1136 = (_e1132.y - _e235);
                                    let _e1138 = (_e1132.z - _e237);
                                    if (_e463 == 0u) {
                                        phi_1266_ = vec3<f32>(_e1136, _e1138, _e1134);
                                    } else {
                                        if (_e463 == 1u) {
                                            phi_1265_ = vec3<f32>(_e1138, _e1134, _e1136);
                                        } else {
                                            phi_1265_ = (_e1132 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1146 = phi_1265_;
                                        phi_1266_ = _e1146;
                                    }
                                    let _e1148 = phi_1266_;
                                    let _e1152 = (_e1148.x - (_e474 * _e1148.z));
                                    let _e1156 = (_e1148.y - (_e477 * _e1148.z));
                                    if (_e1126 < _e1152) {
                                        phi_1285_ = true;
                                    } else {
                                        if (_e1126 == _e1152) {
                                            phi_1284_ = (_e1130 < _e1156);
                                        } else {
                                            phi_1284_ = false;
                                        }
                                        let _e1161 = phi_1284_;
                                        phi_1285_ = _e1161;
                                    }
                                    let _e1163 = phi_1285_;
                                    if _e1163 {
                                        phi_1289_ = _e1156;
                                        phi_1290_ = _e1152;
                                        phi_1291_ = _e1130;
                                        phi_1292_ = _e1126;
                                    } else {
                                        phi_1289_ = _e1130;
                                        phi_1290_ = _e1126;
                                        phi_1291_ = _e1156;
                                        phi_1292_ = _e1152;
                                    }
                                    let _e1165 = phi_1289_;
                                    let _e1167 = phi_1290_;
                                    let _e1169 = phi_1291_;
                                    let _e1171 = phi_1292_;
                                    let _e1174 = ((_e1171 * _e1165) - (_e1169 * _e1167));
                                    if _e1163 {
                                        phi_1300_ = -(_e1174);
                                    } else {
                                        phi_1300_ = _e1174;
                                    }
                                    let _e1177 = phi_1300_;
                                    if (_e1152 < _e1100) {
                                        phi_1311_ = true;
                                    } else {
                                        if (_e1152 == _e1100) {
                                            phi_1310_ = (_e1156 < _e1104);
                                        } else {
                                            phi_1310_ = false;
                                        }
                                        let _e1182 = phi_1310_;
                                        phi_1311_ = _e1182;
                                    }
                                    let _e1184 = phi_1311_;
                                    if _e1184 {
                                        phi_1315_ = _e1104;
                                        phi_1316_ = _e1100;
                                        phi_1317_ = _e1156;
                                        phi_1318_ = _e1152;
                                    } else {
                                        phi_1315_ = _e1156;
                                        phi_1316_ = _e1152;
                                        phi_1317_ = _e1104;
                                        phi_1318_ = _e1100;
                                    }
                                    let _e1186 = phi_1315_;
                                    let _e1188 = phi_1316_;
                                    let _e1190 = phi_1317_;
                                    let _e1192 = phi_1318_;
                                    let _e1195 = ((_e1192 * _e1186) - (_e1190 * _e1188));
                                    if _e1184 {
                                        phi_1326_ = -(_e1195);
                                    } else {
                                        phi_1326_ = _e1195;
                                    }
                                    let _e1198 = phi_1326_;
                                    if (_e1100 < _e1126) {
                                        phi_1337_ = true;
                                    } else {
                                        if (_e1100 == _e1126) {
                                            phi_1336_ = (_e1104 < _e1130);
                                        } else {
                                            phi_1336_ = false;
                                        }
                                        let _e1203 = phi_1336_;
                                        phi_1337_ = _e1203;
                                    }
                                    let _e1205 = phi_1337_;
                                    if _e1205 {
                                        phi_1341_ = _e1130;
                                        phi_1342_ = _e1126;
                                        phi_1343_ = _e1104;
                                        phi_1344_ = _e1100;
                                    } else {
                                        phi_1341_ = _e1104;
                                        phi_1342_ = _e1100;
                                        phi_1343_ = _e1130;
                                        phi_1344_ = _e1126;
                                    }
                                    let _e1207 = phi_1341_;
                                    let _e1209 = phi_1342_;
                                    let _e1211 = phi_1343_;
                                    let _e1213 = phi_1344_;
                                    let _e1216 = ((_e1213 * _e1207) - (_e1211 * _e1209));
                                    if _e1205 {
                                        phi_1352_ = -(_e1216);
                                    } else {
                                        phi_1352_ = _e1216;
                                    }
                                    let _e1219 = phi_1352_;
                                    if (_e1177 >= 0f) {
                                        if (_e1198 >= 0f) {
                                            if (_e1219 >= 0f) {
                                                phi_1367_ = ((_e1177 + _e1198) + _e1219);
                                                phi_1368_ = false;
                                            } else {
                                                phi_1367_ = f32();
                                                phi_1368_ = true;
                                            }
                                            let _e1226 = phi_1367_;
                                            let _e1228 = phi_1368_;
                                            phi_1369_ = _e1226;
                                            phi_1370_ = _e1228;
                                        } else {
                                            phi_1369_ = f32();
                                            phi_1370_ = true;
                                        }
                                        let _e1230 = phi_1369_;
                                        let _e1232 = phi_1370_;
                                        phi_1371_ = _e1230;
                                        phi_1372_ = _e1232;
                                    } else {
                                        phi_1371_ = f32();
                                        phi_1372_ = true;
                                    }
                                    let _e1234 = phi_1371_;
                                    let _e1236 = phi_1372_;
                                    if _e1236 {
                                        if (_e1177 <= 0f) {
                                            if (_e1198 <= 0f) {
                                                let _e1239 = (_e1219 <= 0f);
                                                if _e1239 {
                                                }
                                                phi_1390_ = ((_e1177 + _e1198) + _e1219);
                                                phi_1391_ = false;
                                                phi_1392_ = _e1239;
                                            } else {
                                                phi_1390_ = f32();
                                                phi_1391_ = true;
                                                phi_1392_ = false;
                                            }
                                            let _e1243 = phi_1390_;
                                            let _e1245 = phi_1391_;
                                            let _e1247 = phi_1392_;
                                            phi_1393_ = _e1243;
                                            phi_1394_ = _e1245;
                                            phi_1395_ = _e1247;
                                        } else {
                                            phi_1393_ = f32();
                                            phi_1394_ = true;
                                            phi_1395_ = false;
                                        }
                                        let _e1249 = phi_1393_;
                                        let _e1251 = phi_1394_;
                                        let _e1253 = phi_1395_;
                                        if _e1251 {
                                            phi_1399_ = false;
                                        } else {
                                            phi_1399_ = _e1253;
                                        }
                                        let _e1255 = phi_1399_;
                                        phi_1400_ = _e1249;
                                        phi_1401_ = _e1255;
                                    } else {
                                        phi_1400_ = _e1234;
                                        phi_1401_ = true;
                                    }
                                    let _e1257 = phi_1400_;
                                    let _e1259 = phi_1401_;
                                    if _e1259 {
                                        let _e1260 = (_e1257 == 0f);
                                        if _e1260 {
                                            phi_1717_ = lt_bvh_triangle_Intersection();
                                            phi_1718_ = false;
                                        } else {
                                            let _e1262 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1264 = (_e1262.x - _e233);
                                            let _e1266 = (_e1262.y - _e235);
                                            let _e1268 = (_e1262.z - _e237);
                                            if (_e463 == 0u) {
                                                phi_1430_ = vec3<f32>(_e1266, _e1268, _e1264);
                                            } else {
                                                if (_e463 == 1u) {
                                                    phi_1429_ = vec3<f32>(_e1268, _e1264, _e1266);
                                                } else {
                                                    phi_1429_ = (_e1262 - vec3<f32>(_e233, _e235, _e237));
                                                }
                                                let _e1276 = phi_1429_;
                                                phi_1430_ = _e1276;
                                            }
                                            let _e1278 = phi_1430_;
                                            let _e1280 = triangles.member[(0u + _e1073)].v1_;
                                            let _e1282 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1285 = (_e1280.x - _e1282.x);
                                            let _e1288 = (_e1280.y - _e1282.y);
                                            let _e1291 = (_e1280.z - _e1282.z);
                                            if (_e463 == 0u) {
                                                phi_1456_ = vec3<f32>(_e1288, _e1291, _e1285);
                                            } else {
                                                if (_e463 == 1u) {
                                                    phi_1455_ = vec3<f32>(_e1291, _e1285, _e1288);
                                                } else {
                                                    phi_1455_ = (_e1280 - _e1282);
                                                }
                                                let _e1298 = phi_1455_;
                                                phi_1456_ = _e1298;
                                            }
                                            let _e1300 = phi_1456_;
                                            let _e1302 = triangles.member[(0u + _e1073)].v2_;
                                            let _e1304 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1307 = (_e1302.x - _e1304.x);
                                            let _e1310 = (_e1302.y - _e1304.y);
                                            let _e1313 = (_e1302.z - _e1304.z);
                                            if (_e463 == 0u) {
                                                phi_1482_ = vec3<f32>(_e1310, _e1313, _e1307);
                                            } else {
                                                if (_e463 == 1u) {
                                                    phi_1481_ = vec3<f32>(_e1313, _e1307, _e1310);
                                                } else {
                                                    phi_1481_ = (_e1302 - _e1304);
                                                }
                                                let _e1320 = phi_1481_;
                                                phi_1482_ = _e1320;
                                            }
                                            let _e1322 = phi_1482_;
                                            let _e1329 = ((_e1300.y * _e1322.z) - (_e1300.z * _e1322.y));
                                            let _e1336 = ((_e1300.z * _e1322.x) - (_e1300.x * _e1322.z));
                                            let _e1343 = ((_e1300.x * _e1322.y) - (_e1300.y * _e1322.x));
                                            let _e1357 = (((1f / _e471.z) * (((_e1329 * _e1278.x) + (_e1336 * _e1278.y)) + (_e1343 * _e1278.z))) / (((_e1329 * _e474) + (_e1336 * _e477)) + _e1343));
                                            if (_e1357 > 0f) {
                                                if (_e1357 < _e243) {
                                                    let _e1361 = triangles.member[(0u + _e1073)].v0_;
                                                    let _e1363 = triangles.member[(0u + _e1073)].v1_;
                                                    if (_e1361.x < _e1363.x) {
                                                        phi_1538_ = _e1361.x;
                                                    } else {
                                                        phi_1538_ = _e1363.x;
                                                    }
                                                    let _e1370 = phi_1538_;
                                                    if (_e1361.y < _e1363.y) {
                                                        phi_1547_ = _e1361.y;
                                                    } else {
                                                        phi_1547_ = _e1363.y;
                                                    }
                                                    let _e1377 = phi_1547_;
                                                    if (_e1361.z < _e1363.z) {
                                                        phi_1556_ = _e1361.z;
                                                    } else {
                                                        phi_1556_ = _e1363.z;
                                                    }
                                                    let _e1384 = phi_1556_;
                                                    let _e1386 = triangles.member[(0u + _e1073)].v2_;
                                                    if (_e1370 < _e1386.x) {
                                                        phi_1565_ = _e1370;
                                                    } else {
                                                        phi_1565_ = _e1386.x;
                                                    }
                                                    let _e1391 = phi_1565_;
                                                    if (_e1377 < _e1386.y) {
                                                        phi_1572_ = _e1377;
                                                    } else {
                                                        phi_1572_ = _e1386.y;
                                                    }
                                                    let _e1396 = phi_1572_;
                                                    if (_e1384 < _e1386.z) {
                                                        phi_1579_ = _e1384;
                                                    } else {
                                                        phi_1579_ = _e1386.z;
                                                    }
                                                    let _e1401 = phi_1579_;
                                                    let _e1403 = triangles.member[(0u + _e1073)].v0_;
                                                    let _e1405 = triangles.member[(0u + _e1073)].v1_;
                                                    if (_e1403.x > _e1405.x) {
                                                        phi_1592_ = _e1403.x;
                                                    } else {
                                                        phi_1592_ = _e1405.x;
                                                    }
                                                    let _e1412 = phi_1592_;
                                                    if (_e1403.y > _e1405.y) {
                                                        phi_1601_ = _e1403.y;
                                                    } else {
                                                        phi_1601_ = _e1405.y;
                                                    }
                                                    let _e1419 = phi_1601_;
                                                    if (_e1403.z > _e1405.z) {
                                                        phi_1610_ = _e1403.z;
                                                    } else {
                                                        phi_1610_ = _e1405.z;
                                                    }
                                                    let _e1426 = phi_1610_;
                                                    let _e1428 = triangles.member[(0u + _e1073)].v2_;
                                                    if (_e1412 > _e1428.x) {
                                                        phi_1619_ = _e1412;
                                                    } else {
                                                        phi_1619_ = _e1428.x;
                                                    }
                                                    let _e1433 = phi_1619_;
                                                    if (_e1419 > _e1428.y) {
                                                        phi_1626_ = _e1419;
                                                    } else {
                                                        phi_1626_ = _e1428.y;
                                                    }
                                                    let _e1438 = phi_1626_;
                                                    if (_e1426 > _e1428.z) {
                                                        phi_1633_ = _e1426;
                                                    } else {
                                                        phi_1633_ = _e1428.z;
                                                    }
                                                    let _e1443 = phi_1633_;
                                                    let _e1447 = ((_e1391 - _e233) * _e392);
                                                    let _e1448 = ((_e1396 - _e235) * _e402);
                                                    let _e1449 = ((_e1401 - _e237) * _e412);
                                                    let _e1453 = ((_e1433 - _e233) * _e392);
                                                    let _e1454 = ((_e1438 - _e235) * _e402);
                                                    let _e1455 = ((_e1443 - _e237) * _e412);
                                                    if (_e1447 < _e1453) {
                                                        phi_1650_ = _e1447;
                                                    } else {
                                                        phi_1650_ = _e1453;
                                                    }
                                                    let _e1458 = phi_1650_;
                                                    if (_e1448 < _e1454) {
                                                        phi_1655_ = _e1448;
                                                    } else {
                                                        phi_1655_ = _e1454;
                                                    }
                                                    let _e1461 = phi_1655_;
                                                    if (_e1449 < _e1455) {
                                                        phi_1660_ = _e1449;
                                                    } else {
                                                        phi_1660_ = _e1455;
                                                    }
                                                    let _e1464 = phi_1660_;
                                                    if (_e1447 > _e1453) {
                                                        phi_1668_ = _e1447;
                                                    } else {
                                                        phi_1668_ = _e1453;
                                                    }
                                                    let _e1470 = phi_1668_;
                                                    if (_e1448 > _e1454) {
                                                        phi_1673_ = _e1448;
                                                    } else {
                                                        phi_1673_ = _e1454;
                                                    }
                                                    let _e1473 = phi_1673_;
                                                    if (_e1449 > _e1455) {
                                                        phi_1678_ = _e1449;
                                                    } else {
                                                        phi_1678_ = _e1455;
                                                    }
                                                    let _e1476 = phi_1678_;
                                                    let _e1480 = core_intrinsics_maximum_number_nsz_f32_((_e1458 - _e447), (_e1461 - _e448));
                                                    let _e1481 = core_intrinsics_maximum_number_nsz_f32_(_e1480, (_e1464 - _e449));
                                                    let _e1482 = core_intrinsics_minimum_number_nsz_f32_((_e1470 + _e447), (_e1473 + _e448));
                                                    let _e1483 = core_intrinsics_minimum_number_nsz_f32_(_e1482, (_e1476 + _e449));
                                                    if (_e1481 > -300000000000000000000000000000000000000f) {
                                                        phi_1690_ = _e1481;
                                                    } else {
                                                        phi_1690_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1486 = phi_1690_;
                                                    if (_e1483 < 300000000000000000000000000000000000000f) {
                                                        phi_1695_ = _e1483;
                                                    } else {
                                                        phi_1695_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1489 = phi_1695_;
                                                    if (_e1357 < _e1486) {
                                                        phi_1700_ = _e1486;
                                                    } else {
                                                        phi_1700_ = _e1357;
                                                    }
                                                    let _e1492 = phi_1700_;
                                                    if (_e1492 > _e1489) {
                                                        phi_1705_ = _e1489;
                                                    } else {
                                                        phi_1705_ = _e1492;
                                                    }
                                                    let _e1495 = phi_1705_;
                                                    phi_1710_ = lt_bvh_triangle_Intersection(_e1495, (_e1198 / _e1257), (_e1219 / _e1257), (_e1486 <= _e1489));
                                                    phi_1711_ = false;
                                                } else {
                                                    phi_1710_ = lt_bvh_triangle_Intersection();
                                                    phi_1711_ = true;
                                                }
                                                let _e1501 = phi_1710_;
                                                let _e1503 = phi_1711_;
                                                phi_1712_ = _e1501;
                                                phi_1713_ = _e1503;
                                            } else {
                                                phi_1712_ = lt_bvh_triangle_Intersection();
                                                phi_1713_ = true;
                                            }
                                            let _e1505 = phi_1712_;
                                            let _e1507 = phi_1713_;
                                            if _e1507 {
                                            }
                                            phi_1717_ = _e1505;
                                            phi_1718_ = _e1507;
                                        }
                                        let _e1509 = phi_1717_;
                                        let _e1511 = phi_1718_;
                                        phi_1719_ = _e1509;
                                        phi_1720_ = _e1260;
                                        phi_1721_ = _e1511;
                                    } else {
                                        phi_1719_ = lt_bvh_triangle_Intersection();
                                        phi_1720_ = true;
                                        phi_1721_ = false;
                                    }
                                    let _e1513 = phi_1719_;
                                    let _e1515 = phi_1720_;
                                    let _e1517 = phi_1721_;
                                    if _e1515 {
                                        phi_1725_ = true;
                                    } else {
                                        phi_1725_ = _e1517;
                                    }
                                    let _e1519 = phi_1725_;
                                    if _e1519 {
                                        phi_1729_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1729_ = _e1513;
                                    }
                                    let _e1521 = phi_1729_;
                                    if _e1521.is_hit {
                                        if (_e1521.t > 0f) {
                                            if (_e1521.t < _e243) {
                                                let _e1528 = triangles.member[(0u + _e1073)].i0_;
                                                let _e1530 = ((_e1528 & 2147483648u) == 0u);
                                                if _e1530 {
                                                    phi_1755_ = false;
                                                    phi_1756_ = false;
                                                } else {
                                                    if true {
                                                        phi_1754_ = false;
                                                    } else {
                                                        phi_1754_ = true;
                                                    }
                                                    let _e1532 = phi_1754_;
                                                    phi_1755_ = _e1532;
                                                    phi_1756_ = true;
                                                }
                                                let _e1534 = phi_1755_;
                                                let _e1536 = phi_1756_;
                                                phi_1757_ = _e1534;
                                                phi_1758_ = _e1530;
                                                phi_1759_ = _e1536;
                                            } else {
                                                phi_1757_ = true;
                                                phi_1758_ = false;
                                                phi_1759_ = false;
                                            }
                                            let _e1538 = phi_1757_;
                                            let _e1540 = phi_1758_;
                                            let _e1542 = phi_1759_;
                                            phi_1760_ = _e1538;
                                            phi_1761_ = _e1540;
                                            phi_1762_ = _e1542;
                                        } else {
                                            phi_1760_ = true;
                                            phi_1761_ = false;
                                            phi_1762_ = false;
                                        }
                                        let _e1544 = phi_1760_;
                                        let _e1546 = phi_1761_;
                                        let _e1548 = phi_1762_;
                                        phi_1763_ = _e1544;
                                        phi_1764_ = _e1546;
                                        phi_1765_ = _e1548;
                                    } else {
                                        phi_1763_ = true;
                                        phi_1764_ = false;
                                        phi_1765_ = false;
                                    }
                                    let _e1550 = phi_1763_;
                                    let _e1552 = phi_1764_;
                                    let _e1554 = phi_1765_;
                                    if _e1550 {
                                        phi_1769_ = false;
                                        phi_1770_ = false;
                                    } else {
                                        phi_1769_ = _e1552;
                                        phi_1770_ = _e1554;
                                    }
                                    let _e1556 = phi_1769_;
                                    let _e1558 = phi_1770_;
                                    phi_1161_ = (_e1064 & (_e1064 - 1u));
                                    phi_1771_ = _e1550;
                                    phi_1772_ = _e1556;
                                    phi_1773_ = _e1558;
                                }
                                let _e1560 = phi_1161_;
                                let _e1562 = phi_1771_;
                                let _e1564 = phi_1772_;
                                let _e1566 = phi_1773_;
                                local_7 = _e1564;
                                local_8 = _e1566;
                                continue;
                                continuing {
                                    phi_1160_ = _e1560;
                                    break if !(_e1562);
                                }
                            }
                            let _e1569 = local_5;
                            if _e1569 {
                                let _e1571 = local.group_mask;
                                if ((_e1571 & 4278190080u) == 0u) {
                                    let _e1575 = local.len;
                                    if (_e1575 == 0u) {
                                        phi_1815_ = false;
                                    } else {
                                        let _e1579 = local.len;
                                        local.len = (_e1579 - 1u);
                                        let _e1582 = local.len;
                                        if (_e1582 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1587 = local.first[(0u + _e1582)];
                                        local.group = _e1587;
                                        let _e1590 = local.len;
                                        if (_e1590 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1595 = local.mask[(0u + _e1590)];
                                        local.group_mask = _e1595;
                                        phi_1815_ = true;
                                    }
                                    let _e1598 = phi_1815_;
                                    phi_1816_ = _e1598;
                                } else {
                                    phi_1816_ = true;
                                }
                                let _e1600 = phi_1816_;
                                if _e1600 {
                                    let _e1602 = local.group_mask;
                                    let _e1608 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1602)), 32u, (_e1602 == 0u)));
                                    let _e1612 = local.group_mask;
                                    let _e1626 = local.group_mask;
                                    local.group_mask = (_e1626 & ~((1u << bitcast<u32>((_e1608 & 31u)))));
                                    let _e1629 = local.group;
                                    phi_1847_ = (_e1629 + countOneBits(((_e1612 & ~((4294967295u << bitcast<u32>((((_e1608 - 24u) ^ _e490) & 31u))))) & 255u)));
                                } else {
                                    phi_1847_ = 4294967295u;
                                }
                                let _e1632 = phi_1847_;
                                phi_1848_ = _e1632;
                                phi_1849_ = false;
                                phi_1850_ = false;
                            } else {
                                phi_1848_ = u32();
                                let _e1857 = local_7;
                                phi_1849_ = _e1857;
                                let _e1860 = local_8;
                                phi_1850_ = _e1860;
                            }
                            let _e1634 = phi_1848_;
                            let _e1636 = phi_1849_;
                            let _e1638 = phi_1850_;
                            phi_831_ = _e1634;
                            let _e1864 = local_9;
                            phi_1851_ = _e1864;
                            phi_1852_ = false;
                            phi_1853_ = _e1636;
                            phi_1854_ = _e1638;
                        } else {
                            phi_831_ = u32();
                            phi_1851_ = false;
                            phi_1852_ = true;
                            phi_1853_ = false;
                            phi_1854_ = false;
                        }
                        let _e1640 = phi_831_;
                        let _e1642 = phi_1851_;
                        let _e1644 = phi_1852_;
                        let _e1646 = phi_1853_;
                        let _e1648 = phi_1854_;
                        local_6 = _e1644;
                        local_10 = _e1646;
                        local_11 = _e1648;
                        continue;
                        continuing {
                            phi_830_ = _e1640;
                            break if !(_e1642);
                        }
                    }
                    let _e1651 = local_6;
                    if _e1651 {
                        phi_1858_ = false;
                        phi_1859_ = false;
                    } else {
                        let _e1871 = local_10;
                        phi_1858_ = _e1871;
                        let _e1874 = local_11;
                        phi_1859_ = _e1874;
                    }
                    let _e1653 = phi_1858_;
                    let _e1655 = phi_1859_;
                    if _e1653 {
                        phi_1863_ = true;
                    } else {
                        phi_1863_ = _e1655;
                    }
                    let _e1657 = phi_1863_;
                    if _e1657 {
                        phi_1867_ = true;
                    } else {
                        phi_1867_ = false;
                    }
                    let _e1659 = phi_1867_;
                    phi_1868_ = _e1659;
                }
                let _e1661 = phi_1868_;
                phi_1869_ = _e1661;
                phi_1870_ = _e316;
            } else {
                phi_1869_ = bool();
                phi_1870_ = true;
            }
            let _e1663 = phi_1869_;
            let _e1665 = phi_1870_;
            if _e1665 {
                phi_1874_ = false;
            } else {
                phi_1874_ = _e1663;
            }
            let _e1667 = phi_1874_;
            if _e1667 {
                phi_1878_ = 0f;
            } else {
                phi_1878_ = 1f;
            }
            let _e1669 = phi_1878_;
            phi_1879_ = _e1669;
        }
        let _e1671 = phi_1879_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e1671;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
