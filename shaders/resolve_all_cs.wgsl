struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
    member: array<f32>,
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

struct type_34 {
    member: abi_ShadowParams,
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

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_42 {
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
var<storage> samples: type_17;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_21;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_175_: lt_bvh_traverse_Tree;
    var phi_176_: bool;
    var phi_177_: lt_bvh_traverse_Tree;
    var phi_178_: bool;
    var phi_183_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_175_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_176_ = false;
        } else {
            phi_175_ = lt_bvh_traverse_Tree();
            phi_176_ = true;
        }
        let _e65 = phi_175_;
        let _e67 = phi_176_;
        phi_177_ = _e65;
        phi_178_ = _e67;
    } else {
        phi_177_ = lt_bvh_traverse_Tree();
        phi_178_ = true;
    }
    let _e69 = phi_177_;
    let _e71 = phi_178_;
    if _e71 {
        phi_183_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_183_ = _e69;
    }
    let _e76 = phi_183_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_198_: bool;
    var phi_202_: f32;

    if (param_3 != param_3) {
        phi_198_ = true;
    } else {
        let _e55 = (param_4 >= param_3);
        if _e55 {
        }
        phi_198_ = _e55;
    }
    let _e57 = phi_198_;
    if _e57 {
        phi_202_ = param_4;
    } else {
        phi_202_ = param_3;
    }
    let _e59 = phi_202_;
    return _e59;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_214_: bool;
    var phi_218_: f32;

    if (param_5 != param_5) {
        phi_214_ = true;
    } else {
        let _e55 = (param_6 <= param_5);
        if _e55 {
        }
        phi_214_ = _e55;
    }
    let _e57 = phi_214_;
    if _e57 {
        phi_218_ = param_6;
    } else {
        phi_218_ = param_5;
    }
    let _e59 = phi_218_;
    return _e59;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_1900_: bool;
    var phi_1901_: bool;
    var phi_1902_: bool;
    var phi_1903_: bool;
    var phi_1907_: bool;

    let _e55 = (*param_7).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_7).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_7).normal[2u];
            let _e67 = global[2u];
            phi_1900_ = (_e65 == _e67);
            phi_1901_ = false;
        } else {
            phi_1900_ = bool();
            phi_1901_ = true;
        }
        let _e70 = phi_1900_;
        let _e72 = phi_1901_;
        phi_1902_ = _e70;
        phi_1903_ = _e72;
    } else {
        phi_1902_ = bool();
        phi_1903_ = true;
    }
    let _e74 = phi_1902_;
    let _e76 = phi_1903_;
    if _e76 {
        phi_1907_ = false;
    } else {
        phi_1907_ = _e74;
    }
    let _e78 = phi_1907_;
    return !(_e78);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: abi_Sample;
    var phi_329_: bool;
    var phi_330_: bool;
    var phi_341_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_342_: bool;
    var phi_343_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_344_: bool;
    var phi_351_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_355_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_393_: f32;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_431_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_451_: bool;
    var phi_464_: bool;
    var phi_465_: bool;
    var phi_466_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_472_: bool;
    var phi_473_: bool;
    var phi_474_: bool;
    var phi_478_: bool;
    var phi_548_: f32;
    var phi_555_: f32;
    var phi_562_: f32;
    var phi_569_: f32;
    var phi_576_: f32;
    var phi_583_: f32;
    var phi_600_: f32;
    var phi_605_: f32;
    var phi_610_: f32;
    var phi_615_: f32;
    var phi_620_: f32;
    var phi_646_: bool;
    var phi_647_: bool;
    var phi_655_: u32;
    var phi_656_: u32;
    var phi_667_: vec3<f32>;
    var phi_668_: vec3<f32>;
    var phi_681_: u32;
    var phi_686_: u32;
    var phi_691_: u32;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_837_: u32;
    var phi_839_: u32;
    var phi_842_: bool;
    var phi_922_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_949_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_976_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_982_: u32;
    var phi_985_: u32;
    var phi_999_: u32;
    var phi_1009_: u32;
    var phi_1019_: u32;
    var phi_1037_: u32;
    var phi_1047_: u32;
    var phi_1057_: u32;
    var phi_1093_: u32;
    var phi_1106_: u32;
    var phi_1111_: u32;
    var phi_1112_: u32;
    var phi_1113_: u32;
    var phi_983_: u32;
    var phi_986_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1171_: u32;
    var phi_1174_: bool;
    var phi_1218_: vec3<f32>;
    var phi_1219_: vec3<f32>;
    var phi_1248_: vec3<f32>;
    var phi_1249_: vec3<f32>;
    var phi_1278_: vec3<f32>;
    var phi_1279_: vec3<f32>;
    var phi_1297_: bool;
    var phi_1298_: bool;
    var phi_1302_: f32;
    var phi_1303_: f32;
    var phi_1304_: f32;
    var phi_1305_: f32;
    var phi_1313_: f32;
    var phi_1323_: bool;
    var phi_1324_: bool;
    var phi_1328_: f32;
    var phi_1329_: f32;
    var phi_1330_: f32;
    var phi_1331_: f32;
    var phi_1339_: f32;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1354_: f32;
    var phi_1355_: f32;
    var phi_1356_: f32;
    var phi_1357_: f32;
    var phi_1365_: f32;
    var phi_1380_: f32;
    var phi_1381_: bool;
    var phi_1382_: f32;
    var phi_1383_: bool;
    var phi_1384_: f32;
    var phi_1385_: bool;
    var phi_1403_: f32;
    var phi_1404_: bool;
    var phi_1405_: bool;
    var phi_1406_: f32;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1412_: bool;
    var phi_1413_: f32;
    var phi_1414_: bool;
    var phi_1442_: vec3<f32>;
    var phi_1443_: vec3<f32>;
    var phi_1468_: vec3<f32>;
    var phi_1469_: vec3<f32>;
    var phi_1494_: vec3<f32>;
    var phi_1495_: vec3<f32>;
    var phi_1551_: f32;
    var phi_1560_: f32;
    var phi_1569_: f32;
    var phi_1578_: f32;
    var phi_1585_: f32;
    var phi_1592_: f32;
    var phi_1605_: f32;
    var phi_1614_: f32;
    var phi_1623_: f32;
    var phi_1632_: f32;
    var phi_1639_: f32;
    var phi_1646_: f32;
    var phi_1663_: f32;
    var phi_1668_: f32;
    var phi_1673_: f32;
    var phi_1681_: f32;
    var phi_1686_: f32;
    var phi_1691_: f32;
    var phi_1703_: f32;
    var phi_1708_: f32;
    var phi_1713_: f32;
    var phi_1718_: f32;
    var phi_1723_: lt_bvh_triangle_Intersection;
    var phi_1724_: bool;
    var phi_1725_: lt_bvh_triangle_Intersection;
    var phi_1726_: bool;
    var phi_1730_: lt_bvh_triangle_Intersection;
    var phi_1731_: bool;
    var phi_1732_: lt_bvh_triangle_Intersection;
    var phi_1733_: bool;
    var phi_1734_: bool;
    var phi_1738_: bool;
    var phi_1742_: lt_bvh_triangle_Intersection;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1767_: bool;
    var phi_1768_: bool;
    var phi_1172_: u32;
    var phi_1175_: bool;
    var phi_1772_: bool;
    var local_5: bool;
    var phi_1814_: bool;
    var phi_1815_: bool;
    var phi_1846_: u32;
    var phi_1847_: u32;
    var phi_840_: u32;
    var phi_843_: bool;
    var phi_1848_: bool;
    var phi_1849_: bool;
    var local_6: bool;
    var phi_1853_: bool;
    var phi_1857_: bool;
    var phi_1858_: bool;
    var phi_1859_: bool;
    var phi_1860_: bool;
    var phi_1864_: bool;
    var phi_1868_: f32;
    var phi_1869_: f32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;

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
                    phi_330_ = true;
                } else {
                    let _e142 = p.member.light.range_squared;
                    if (_e125 <= _e142) {
                        let _e145 = p.member.light.cos_outer;
                        phi_329_ = (-((((_e107 * _e127.x) + (_e108 * _e127.y)) + (_e109 * _e127.z))) >= (_e145 * sqrt(_e125)));
                    } else {
                        phi_329_ = false;
                    }
                    let _e150 = phi_329_;
                    phi_330_ = _e150;
                }
                let _e152 = phi_330_;
                if _e152 {
                    let _e154 = local_1.flags;
                    let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
                    phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, ((_e154 & 1u) == 0u));
                    phi_342_ = false;
                } else {
                    phi_341_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_342_ = true;
                }
                let _e173 = phi_341_;
                let _e175 = phi_342_;
                phi_343_ = _e173;
                phi_344_ = _e175;
            } else {
                phi_343_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_344_ = true;
            }
            let _e177 = phi_343_;
            let _e179 = phi_344_;
            if _e179 {
                let _e185 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e191 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e185.unnamed.visibility, false), _e185.unnamed_1);
                phi_351_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e191.unnamed, true);
            } else {
                phi_351_ = _e177;
            }
            let _e196 = phi_351_;
            phi_355_ = _e196;
        } else {
            let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e208 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e202.unnamed.visibility, false), _e202.unnamed_1);
            phi_355_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e208.unnamed, true);
        }
        let _e213 = phi_355_;
        if _e213.unnamed_1 {
            phi_1869_ = _e213.unnamed.visibility;
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
                phi_393_ = 300000000000000000000000000000000000000f;
            } else {
                phi_393_ = 1f;
            }
            let _e243 = phi_393_;
            let _e251 = (_e239.x - (_e233 * _e239.w));
            let _e252 = (_e239.y - (_e235 * _e239.w));
            let _e253 = (_e239.z - (_e237 * _e239.w));
            let _e255 = abs(_e251);
            let _e256 = abs(_e252);
            let _e257 = abs(_e253);
            if (abs(_e233) < 1000000000000000f) {
                if (abs(_e235) < 1000000000000000f) {
                    phi_424_ = (abs(_e237) < 1000000000000000f);
                    phi_425_ = false;
                } else {
                    phi_424_ = bool();
                    phi_425_ = true;
                }
                let _e265 = phi_424_;
                let _e267 = phi_425_;
                phi_426_ = _e265;
                phi_427_ = _e267;
            } else {
                phi_426_ = bool();
                phi_427_ = true;
            }
            let _e269 = phi_426_;
            let _e271 = phi_427_;
            if _e271 {
                phi_431_ = false;
            } else {
                phi_431_ = _e269;
            }
            let _e273 = phi_431_;
            if _e273 {
                if (_e255 < 1000000000000000f) {
                    if (_e256 < 1000000000000000f) {
                        phi_444_ = (_e257 < 1000000000000000f);
                        phi_445_ = false;
                    } else {
                        phi_444_ = bool();
                        phi_445_ = true;
                    }
                    let _e278 = phi_444_;
                    let _e280 = phi_445_;
                    phi_446_ = _e278;
                    phi_447_ = _e280;
                } else {
                    phi_446_ = bool();
                    phi_447_ = true;
                }
                let _e282 = phi_446_;
                let _e284 = phi_447_;
                if _e284 {
                    phi_451_ = false;
                } else {
                    phi_451_ = _e282;
                }
                let _e286 = phi_451_;
                if _e286 {
                    if (_e255 > 0f) {
                        phi_465_ = bool();
                        phi_466_ = true;
                    } else {
                        let _e288 = (_e256 > 0f);
                        if _e288 {
                            phi_464_ = bool();
                        } else {
                            phi_464_ = (_e257 > 0f);
                        }
                        let _e291 = phi_464_;
                        phi_465_ = _e291;
                        phi_466_ = _e288;
                    }
                    let _e293 = phi_465_;
                    let _e295 = phi_466_;
                    if _e295 {
                        phi_470_ = true;
                    } else {
                        phi_470_ = _e293;
                    }
                    let _e297 = phi_470_;
                    phi_471_ = _e297;
                    phi_472_ = false;
                } else {
                    phi_471_ = bool();
                    phi_472_ = true;
                }
                let _e299 = phi_471_;
                let _e301 = phi_472_;
                phi_473_ = _e299;
                phi_474_ = _e301;
            } else {
                phi_473_ = bool();
                phi_474_ = true;
            }
            let _e303 = phi_473_;
            let _e305 = phi_474_;
            if _e305 {
                phi_478_ = false;
            } else {
                phi_478_ = _e303;
            }
            let _e307 = phi_478_;
            if _e307 {
                let _e308 = (0u >= _e61);
                if _e308 {
                    phi_1858_ = bool();
                } else {
                    if (0u < _e61) {
                    } else {
                        return;
                    }
                    let _e314 = nodes.member[(0u + 0u)].frame[0u];
                    let _e318 = nodes.member[(0u + 0u)].frame[1u];
                    let _e322 = nodes.member[(0u + 0u)].frame[2u];
                    let _e326 = nodes.member[(0u + 0u)].frame[0u];
                    let _e330 = nodes.member[(0u + 0u)].frame[1u];
                    let _e334 = nodes.member[(0u + 0u)].frame[2u];
                    let _e338 = nodes.member[(0u + 0u)].frame[3u];
                    let _e372 = core_intrinsics_maximum_number_nsz_f32_(abs(_e251), abs(_e252));
                    let _e373 = core_intrinsics_maximum_number_nsz_f32_(_e372, abs(_e253));
                    let _e374 = (_e373 * 0.0000000000009094947f);
                    if (abs(_e251) < _e374) {
                        phi_548_ = _e374;
                    } else {
                        phi_548_ = abs(_e251);
                    }
                    let _e379 = phi_548_;
                    if (_e251 < 0f) {
                        phi_555_ = (-1f / _e379);
                    } else {
                        phi_555_ = (1f / _e379);
                    }
                    let _e384 = phi_555_;
                    if (abs(_e252) < _e374) {
                        phi_562_ = _e374;
                    } else {
                        phi_562_ = abs(_e252);
                    }
                    let _e389 = phi_562_;
                    if (_e252 < 0f) {
                        phi_569_ = (-1f / _e389);
                    } else {
                        phi_569_ = (1f / _e389);
                    }
                    let _e394 = phi_569_;
                    if (abs(_e253) < _e374) {
                        phi_576_ = _e374;
                    } else {
                        phi_576_ = abs(_e253);
                    }
                    let _e399 = phi_576_;
                    if (_e253 < 0f) {
                        phi_583_ = (-1f / _e399);
                    } else {
                        phi_583_ = (1f / _e399);
                    }
                    let _e404 = phi_583_;
                    let _e408 = abs((bitcast<f32>(_e314) - _e233));
                    let _e409 = abs((bitcast<f32>(_e318) - _e235));
                    let _e410 = abs((bitcast<f32>(_e322) - _e237));
                    let _e414 = abs(((bitcast<f32>(_e326) + (bitcast<f32>((((_e338 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e233));
                    let _e415 = abs(((bitcast<f32>(_e330) + (bitcast<f32>((((_e338 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e235));
                    let _e416 = abs(((bitcast<f32>(_e334) + (bitcast<f32>((((_e338 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e237));
                    if (_e408 > _e414) {
                        phi_600_ = _e408;
                    } else {
                        phi_600_ = _e414;
                    }
                    let _e419 = phi_600_;
                    if (_e409 > _e415) {
                        phi_605_ = _e409;
                    } else {
                        phi_605_ = _e415;
                    }
                    let _e422 = phi_605_;
                    if (_e410 > _e416) {
                        phi_610_ = _e410;
                    } else {
                        phi_610_ = _e416;
                    }
                    let _e425 = phi_610_;
                    if (_e419 > _e422) {
                        phi_615_ = _e419;
                    } else {
                        phi_615_ = _e422;
                    }
                    let _e428 = phi_615_;
                    if (_e428 > _e425) {
                        phi_620_ = _e428;
                    } else {
                        phi_620_ = _e425;
                    }
                    let _e431 = phi_620_;
                    let _e435 = (_e431 * 0.0000019073486f);
                    let _e436 = (abs(_e384) * _e435);
                    let _e437 = (abs(_e394) * _e435);
                    let _e438 = (abs(_e404) * _e435);
                    let _e442 = (_e431 * 0.0000009536743f);
                    let _e443 = (abs(_e384) * _e442);
                    let _e444 = (abs(_e394) * _e442);
                    let _e445 = (abs(_e404) * _e442);
                    let _e446 = abs(_e251);
                    let _e447 = abs(_e252);
                    let _e448 = abs(_e253);
                    if (_e446 >= _e447) {
                        if (_e446 >= _e448) {
                            phi_646_ = false;
                        } else {
                            phi_646_ = true;
                        }
                        let _e452 = phi_646_;
                        phi_647_ = _e452;
                    } else {
                        phi_647_ = true;
                    }
                    let _e454 = phi_647_;
                    if _e454 {
                        if (_e447 >= _e448) {
                            phi_655_ = 1u;
                        } else {
                            phi_655_ = 2u;
                        }
                        let _e457 = phi_655_;
                        phi_656_ = _e457;
                    } else {
                        phi_656_ = 0u;
                    }
                    let _e459 = phi_656_;
                    if (_e459 == 0u) {
                        phi_668_ = vec3<f32>(_e252, _e253, _e251);
                    } else {
                        if (_e459 == 1u) {
                            phi_667_ = vec3<f32>(_e253, _e251, _e252);
                        } else {
                            phi_667_ = vec3<f32>(_e251, _e252, _e253);
                        }
                        let _e465 = phi_667_;
                        phi_668_ = _e465;
                    }
                    let _e467 = phi_668_;
                    let _e470 = (_e467.x / _e467.z);
                    let _e473 = (_e467.y / _e467.z);
                    if (_e384 < 0f) {
                        phi_681_ = 0u;
                    } else {
                        phi_681_ = 1u;
                    }
                    let _e478 = phi_681_;
                    if (_e394 < 0f) {
                        phi_686_ = 0u;
                    } else {
                        phi_686_ = 2u;
                    }
                    let _e481 = phi_686_;
                    if (_e404 < 0f) {
                        phi_691_ = 0u;
                    } else {
                        phi_691_ = 4u;
                    }
                    let _e484 = phi_691_;
                    let _e486 = ((_e478 | _e481) | _e484);
                    let _e487 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e487.first[0], _e487.first[1], _e487.first[2], _e487.first[3], _e487.first[4], _e487.first[5], _e487.first[6], _e487.first[7], _e487.first[8], _e487.first[9], _e487.first[10], _e487.first[11], _e487.first[12], _e487.first[13], _e487.first[14], _e487.first[15], _e487.first[16], _e487.first[17], _e487.first[18], _e487.first[19], _e487.first[20], _e487.first[21], _e487.first[22], _e487.first[23], _e487.first[24], _e487.first[25], _e487.first[26], _e487.first[27], _e487.first[28], _e487.first[29], _e487.first[30], _e487.first[31]), array<u32, 32>(_e487.mask[0], _e487.mask[1], _e487.mask[2], _e487.mask[3], _e487.mask[4], _e487.mask[5], _e487.mask[6], _e487.mask[7], _e487.mask[8], _e487.mask[9], _e487.mask[10], _e487.mask[11], _e487.mask[12], _e487.mask[13], _e487.mask[14], _e487.mask[15], _e487.mask[16], _e487.mask[17], _e487.mask[18], _e487.mask[19], _e487.mask[20], _e487.mask[21], _e487.mask[22], _e487.mask[23], _e487.mask[24], _e487.mask[25], _e487.mask[26], _e487.mask[27], _e487.mask[28], _e487.mask[29], _e487.mask[30], _e487.mask[31]), _e487.len, _e487.group, _e487.group_mask);
                    let _e561 = local.group_mask;
                    if ((_e561 & 4278190080u) == 0u) {
                        let _e565 = local.len;
                        if (_e565 == 0u) {
                            phi_805_ = false;
                        } else {
                            let _e569 = local.len;
                            local.len = (_e569 - 1u);
                            let _e572 = local.len;
                            if (_e572 < 32u) {
                            } else {
                                return;
                            }
                            let _e577 = local.first[(0u + _e572)];
                            local.group = _e577;
                            let _e580 = local.len;
                            if (_e580 < 32u) {
                            } else {
                                return;
                            }
                            let _e585 = local.mask[(0u + _e580)];
                            local.group_mask = _e585;
                            phi_805_ = true;
                        }
                        let _e588 = phi_805_;
                        phi_806_ = _e588;
                    } else {
                        phi_806_ = true;
                    }
                    let _e590 = phi_806_;
                    if _e590 {
                        let _e592 = local.group_mask;
                        let _e598 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e592)), 32u, (_e592 == 0u)));
                        let _e602 = local.group_mask;
                        let _e616 = local.group_mask;
                        local.group_mask = (_e616 & ~((1u << bitcast<u32>((_e598 & 31u)))));
                        let _e619 = local.group;
                        phi_837_ = (_e619 + countOneBits(((_e602 & ~((4294967295u << bitcast<u32>((((_e598 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_837_ = 4294967295u;
                    }
                    let _e622 = phi_837_;
                    phi_839_ = _e622;
                    phi_842_ = false;
                    loop {
                        let _e624 = phi_839_;
                        let _e626 = phi_842_;
                        local_9 = _e626;
                        if (_e624 != 4294967295u) {
                            if (_e624 < _e61) {
                            } else {
                                return;
                            }
                            let _e633 = nodes.member[(0u + _e624)].frame[3u];
                            let _e658 = (bitcast<f32>((((_e633 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e384);
                            let _e659 = (bitcast<f32>((((_e633 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e394);
                            let _e660 = (bitcast<f32>((((_e633 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e404);
                            let _e663 = nodes.member[(0u + _e624)].frame[0u];
                            let _e667 = nodes.member[(0u + _e624)].frame[1u];
                            let _e671 = nodes.member[(0u + _e624)].frame[2u];
                            let _e676 = ((bitcast<f32>(_e663) - _e233) * _e384);
                            let _e677 = ((bitcast<f32>(_e667) - _e235) * _e394);
                            let _e678 = ((bitcast<f32>(_e671) - _e237) * _e404);
                            let _e686 = nodes.member[(0u + _e624)].x;
                            if (_e384 < 0f) {
                                let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e686.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.unnamed.root, _e686.w), _e697.unnamed_1);
                                let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e703.unnamed, lt_bvh_traverse_Tree(_e686.x, _e703.unnamed_1.first_primitive));
                                phi_922_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_bvh_traverse_Tree(_e709.unnamed_1.root, _e686.y));
                            } else {
                                let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e686.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e725.unnamed.root, _e686.y), _e725.unnamed_1);
                                let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_bvh_traverse_Tree(_e686.z, _e731.unnamed_1.first_primitive));
                                phi_922_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e737.unnamed_1.root, _e686.w));
                            }
                            let _e745 = phi_922_;
                            let _e755 = nodes.member[(0u + _e624)].y;
                            if (_e394 < 0f) {
                                let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e755.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e766.unnamed.root, _e755.w), _e766.unnamed_1);
                                let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e772.unnamed, lt_bvh_traverse_Tree(_e755.x, _e772.unnamed_1.first_primitive));
                                phi_949_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e778.unnamed, lt_bvh_traverse_Tree(_e778.unnamed_1.root, _e755.y));
                            } else {
                                let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e755.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e794.unnamed.root, _e755.y), _e794.unnamed_1);
                                let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e800.unnamed, lt_bvh_traverse_Tree(_e755.z, _e800.unnamed_1.first_primitive));
                                phi_949_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e806.unnamed, lt_bvh_traverse_Tree(_e806.unnamed_1.root, _e755.w));
                            }
                            let _e814 = phi_949_;
                            let _e824 = nodes.member[(0u + _e624)].z;
                            if (_e404 < 0f) {
                                let _e835 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e824.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e841 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e835.unnamed.root, _e824.w), _e835.unnamed_1);
                                let _e847 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e841.unnamed, lt_bvh_traverse_Tree(_e824.x, _e841.unnamed_1.first_primitive));
                                phi_976_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e847.unnamed, lt_bvh_traverse_Tree(_e847.unnamed_1.root, _e824.y));
                            } else {
                                let _e863 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e824.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e869 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e863.unnamed.root, _e824.y), _e863.unnamed_1);
                                let _e875 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e869.unnamed, lt_bvh_traverse_Tree(_e824.z, _e869.unnamed_1.first_primitive));
                                phi_976_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e875.unnamed, lt_bvh_traverse_Tree(_e875.unnamed_1.root, _e824.w));
                            }
                            let _e883 = phi_976_;
                            phi_982_ = 0u;
                            phi_985_ = 0u;
                            loop {
                                let _e893 = phi_982_;
                                let _e895 = phi_985_;
                                local_2 = _e895;
                                local_3 = _e895;
                                local_4 = _e895;
                                let _e896 = (_e893 < 8u);
                                if _e896 {
                                    let _e898 = (_e893 >> bitcast<u32>(2i));
                                    let _e899 = (_e893 & 3u);
                                    if (_e898 == 0u) {
                                        phi_999_ = _e745.unnamed.root;
                                    } else {
                                        phi_999_ = _e745.unnamed.first_primitive;
                                    }
                                    let _e902 = phi_999_;
                                    if (_e898 == 0u) {
                                        phi_1009_ = _e814.unnamed.root;
                                    } else {
                                        phi_1009_ = _e814.unnamed.first_primitive;
                                    }
                                    let _e911 = phi_1009_;
                                    if (_e898 == 0u) {
                                        phi_1019_ = _e883.unnamed.root;
                                    } else {
                                        phi_1019_ = _e883.unnamed.first_primitive;
                                    }
                                    let _e920 = phi_1019_;
                                    let _e933 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e902 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e658) + (_e676 - _e436)), ((f32(((_e911 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e659) + (_e677 - _e437)));
                                    let _e934 = core_intrinsics_maximum_number_nsz_f32_(_e933, ((f32(((_e920 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e660) + (_e678 - _e438)));
                                    if (_e898 == 0u) {
                                        phi_1037_ = _e745.unnamed_1.root;
                                    } else {
                                        phi_1037_ = _e745.unnamed_1.first_primitive;
                                    }
                                    let _e937 = phi_1037_;
                                    if (_e898 == 0u) {
                                        phi_1047_ = _e814.unnamed_1.root;
                                    } else {
                                        phi_1047_ = _e814.unnamed_1.first_primitive;
                                    }
                                    let _e946 = phi_1047_;
                                    if (_e898 == 0u) {
                                        phi_1057_ = _e883.unnamed_1.root;
                                    } else {
                                        phi_1057_ = _e883.unnamed_1.first_primitive;
                                    }
                                    let _e955 = phi_1057_;
                                    let _e968 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e937 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e658) + (_e676 + _e436)), ((f32(((_e946 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e659) + (_e677 + _e437)));
                                    let _e969 = core_intrinsics_minimum_number_nsz_f32_(_e968, ((f32(((_e955 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e660) + (_e678 + _e438)));
                                    if (_e934 <= _e969) {
                                        if (_e934 <= _e243) {
                                            if (_e969 >= 0f) {
                                                if (_e898 == 0u) {
                                                    let _e976 = nodes.member[(0u + _e624)].links[2u];
                                                    phi_1093_ = _e976;
                                                } else {
                                                    let _e979 = nodes.member[(0u + _e624)].links[3u];
                                                    phi_1093_ = _e979;
                                                }
                                                let _e981 = phi_1093_;
                                                let _e986 = ((_e981 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u);
                                                let _e987 = (_e986 & 31u);
                                                if (_e987 >= 24u) {
                                                    phi_1106_ = (24u + ((_e987 - 24u) ^ _e486));
                                                } else {
                                                    phi_1106_ = _e987;
                                                }
                                                let _e993 = phi_1106_;
                                                phi_1111_ = (_e895 | ((_e986 >> bitcast<u32>(5i)) << bitcast<u32>((_e993 & 31u))));
                                            } else {
                                                phi_1111_ = _e895;
                                            }
                                            let _e1001 = phi_1111_;
                                            phi_1112_ = _e1001;
                                        } else {
                                            phi_1112_ = _e895;
                                        }
                                        let _e1003 = phi_1112_;
                                        phi_1113_ = _e1003;
                                    } else {
                                        phi_1113_ = _e895;
                                    }
                                    let _e1005 = phi_1113_;
                                    phi_983_ = (_e893 + 1u);
                                    phi_986_ = _e1005;
                                } else {
                                    phi_983_ = u32();
                                    phi_986_ = u32();
                                }
                                let _e1008 = phi_983_;
                                let _e1010 = phi_986_;
                                continue;
                                continuing {
                                    phi_982_ = _e1008;
                                    phi_985_ = _e1010;
                                    break if !(_e896);
                                }
                            }
                            let _e1014 = nodes.member[(0u + _e624)].links[0u];
                            let _e1018 = nodes.member[(0u + _e624)].frame[3u];
                            let _e1022 = local_2;
                            if ((_e1022 & 4278190080u) == 0u) {
                            } else {
                                let _e1026 = local.group_mask;
                                if ((_e1026 & 4278190080u) == 0u) {
                                } else {
                                    let _e1030 = local.len;
                                    if (_e1030 < 32u) {
                                        let _e1033 = local.group;
                                        let _e1035 = local.len;
                                        if (_e1035 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.first[(0u + _e1035)] = _e1033;
                                        let _e1041 = local.group_mask;
                                        let _e1043 = local.len;
                                        if (_e1043 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.mask[(0u + _e1043)] = _e1041;
                                        let _e1050 = local.len;
                                        local.len = (_e1050 + 1u);
                                    }
                                }
                                local.group = (0u + _e1014);
                                let _e1054 = local_3;
                                local.group_mask = ((_e1054 & 4278190080u) | (_e1018 >> bitcast<u32>(24i)));
                            }
                            let _e1059 = local_4;
                            phi_1171_ = (_e1059 & 16777215u);
                            phi_1174_ = _e626;
                            loop {
                                let _e1062 = phi_1171_;
                                let _e1064 = phi_1174_;
                                local_7 = _e1064;
                                let _e1065 = (_e1062 == 0u);
                                local_5 = _e1065;
                                local_8 = _e1065;
                                if _e1065 {
                                    phi_1172_ = u32();
                                    phi_1175_ = bool();
                                    phi_1772_ = false;
                                } else {
                                    let _e1068 = nodes.member[(0u + _e624)].links[1u];
                                    let _e1073 = ((0u + _e1068) + select(firstTrailingBit(_e1062), 32u, (_e1062 == 0u)));
                                    if (_e1073 < arrayLength((&triangles.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1080 = triangles.member[(0u + _e1073)].v0_;
                                    let _e1082 = (_e1080.x - _e233);
                                    let _e1084 = (_e1080.y - _e235);
                                    let _e1086 = (_e1080.z - _e237);
                                    if (_e459 == 0u) {
                                        phi_1219_ = vec3<f32>(_e1084, _e1086, _e1082);
                                    } else {
                                        if (_e459 == 1u) {
                                            phi_1218_ = vec3<f32>(_e1086, _e1082, _e1084);
                                        } else {
                                            phi_1218_ = (_e1080 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1094 = phi_1218_;
                                        phi_1219_ = _e1094;
                                    }
                                    let _e1096 = phi_1219_;
                                    let _e1100 = (_e1096.x - (_e470 * _e1096.z));
                                    let _e1104 = (_e1096.y - (_e473 * _e1096.z));
                                    let _e1106 = triangles.member[(0u + _e1073)].v1_;
                                    let _e1108 = (_e1106.x - _e233);
                                    let _e1110 = (_e1106.y - _e235);
                                    let _e1112 = (_e1106.z - _e237);
                                    if (_e459 == 0u) {
                                        phi_1249_ = vec3<f32>(_e1110, _e1112, _e1108);
                                    } else {
                                        if (_e459 == 1u) {
                                            phi_1248_ = vec3<f32>(_e1112, _e1108, _e1110);
                                        } else {
                                            phi_1248_ = (_e1106 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1120 = phi_1248_;
                                        phi_1249_ = _e1120;
                                    }
                                    let _e1122 = phi_1249_;
                                    let _e1126 = (_e1122.x - (_e470 * _e1122.z));
                                    let _e1130 = (_e1122.y - (_e473 * _e1122.z));
                                    let _e1132 = triangles.member[(0u + _e1073)].v2_;
                                    let _e1134 = (_e1132.x - _e233);
                                    let _e1136 = (_e1132.y - _e235);
                                    let _e1138 = (_e1132.z - _e237);
                                    if (_e459 == 0u) {
                                        phi_1279_ = vec3<f32>(_e1136, _e1138, _e1134);
                                    } else {
                                        if (_e459 == 1u) {
                                            phi_1278_ = vec3<f32>(_e1138, _e1134, _e1136);
                                        } else {
                                            phi_1278_ = (_e1132 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1146 = phi_1278_;
                                        phi_1279_ = _e1146;
                                    }
                                    let _e1148 = phi_1279_;
                                    let _e1152 = (_e1148.x - (_e470 * _e1148.z));
                                    let _e1156 = (_e1148.y - (_e473 * _e1148.z));
                                    if (_e1126 < _e1152) {
                                        phi_1298_ = true;
                                    } else {
                                        if (_e1126 == _e1152) {
                                            phi_1297_ = (_e1130 < _e1156);
                                        } else {
                                            phi_1297_ = false;
                                        }
                                        let _e1161 = phi_1297_;
                                        phi_1298_ = _e1161;
                                    }
                                    let _e1163 = phi_1298_;
                                    if _e1163 {
                                        phi_1302_ = _e1156;
                                        phi_1303_ = _e1152;
                                        phi_1304_ = _e1130;
                                        phi_1305_ = _e1126;
                                    } else {
                                        phi_1302_ = _e1130;
                                        phi_1303_ = _e1126;
                                        phi_1304_ = _e1156;
                                        phi_1305_ = _e1152;
                                    }
                                    let _e1165 = phi_1302_;
                                    let _e1167 = phi_1303_;
                                    let _e1169 = phi_1304_;
                                    let _e1171 = phi_1305_;
                                    let _e1174 = ((_e1171 * _e1165) - (_e1169 * _e1167));
                                    if _e1163 {
                                        phi_1313_ = -(_e1174);
                                    } else {
                                        phi_1313_ = _e1174;
                                    }
                                    let _e1177 = phi_1313_;
                                    if (_e1152 < _e1100) {
                                        phi_1324_ = true;
                                    } else {
                                        if (_e1152 == _e1100) {
                                            phi_1323_ = (_e1156 < _e1104);
                                        } else {
                                            phi_1323_ = false;
                                        }
                                        let _e1182 = phi_1323_;
                                        phi_1324_ = _e1182;
                                    }
                                    let _e1184 = phi_1324_;
                                    if _e1184 {
                                        phi_1328_ = _e1104;
                                        phi_1329_ = _e1100;
                                        phi_1330_ = _e1156;
                                        phi_1331_ = _e1152;
                                    } else {
                                        phi_1328_ = _e1156;
                                        phi_1329_ = _e1152;
                                        phi_1330_ = _e1104;
                                        phi_1331_ = _e1100;
                                    }
                                    let _e1186 = phi_1328_;
                                    let _e1188 = phi_1329_;
                                    let _e1190 = phi_1330_;
                                    let _e1192 = phi_1331_;
                                    let _e1195 = ((_e1192 * _e1186) - (_e1190 * _e1188));
                                    if _e1184 {
                                        phi_1339_ = -(_e1195);
                                    } else {
                                        phi_1339_ = _e1195;
                                    }
                                    let _e1198 = phi_1339_;
                                    if (_e1100 < _e1126) {
                                        phi_1350_ = true;
                                    } else {
                                        if (_e1100 == _e1126) {
                                            phi_1349_ = (_e1104 < _e1130);
                                        } else {
                                            phi_1349_ = false;
                                        }
                                        let _e1203 = phi_1349_;
                                        phi_1350_ = _e1203;
                                    }
                                    let _e1205 = phi_1350_;
                                    if _e1205 {
                                        phi_1354_ = _e1130;
                                        phi_1355_ = _e1126;
                                        phi_1356_ = _e1104;
                                        phi_1357_ = _e1100;
                                    } else {
                                        phi_1354_ = _e1104;
                                        phi_1355_ = _e1100;
                                        phi_1356_ = _e1130;
                                        phi_1357_ = _e1126;
                                    }
                                    let _e1207 = phi_1354_;
                                    let _e1209 = phi_1355_;
                                    let _e1211 = phi_1356_;
                                    let _e1213 = phi_1357_;
                                    let _e1216 = ((_e1213 * _e1207) - (_e1211 * _e1209));
                                    if _e1205 {
                                        phi_1365_ = -(_e1216);
                                    } else {
                                        phi_1365_ = _e1216;
                                    }
                                    let _e1219 = phi_1365_;
                                    if (_e1177 >= 0f) {
                                        if (_e1198 >= 0f) {
                                            if (_e1219 >= 0f) {
                                                phi_1380_ = ((_e1177 + _e1198) + _e1219);
                                                phi_1381_ = false;
                                            } else {
                                                phi_1380_ = f32();
                                                phi_1381_ = true;
                                            }
                                            let _e1226 = phi_1380_;
                                            let _e1228 = phi_1381_;
                                            phi_1382_ = _e1226;
                                            phi_1383_ = _e1228;
                                        } else {
                                            phi_1382_ = f32();
                                            phi_1383_ = true;
                                        }
                                        let _e1230 = phi_1382_;
                                        let _e1232 = phi_1383_;
                                        phi_1384_ = _e1230;
                                        phi_1385_ = _e1232;
                                    } else {
                                        phi_1384_ = f32();
                                        phi_1385_ = true;
                                    }
                                    let _e1234 = phi_1384_;
                                    let _e1236 = phi_1385_;
                                    if _e1236 {
                                        if (_e1177 <= 0f) {
                                            if (_e1198 <= 0f) {
                                                let _e1239 = (_e1219 <= 0f);
                                                if _e1239 {
                                                }
                                                phi_1403_ = ((_e1177 + _e1198) + _e1219);
                                                phi_1404_ = false;
                                                phi_1405_ = _e1239;
                                            } else {
                                                phi_1403_ = f32();
                                                phi_1404_ = true;
                                                phi_1405_ = false;
                                            }
                                            let _e1243 = phi_1403_;
                                            let _e1245 = phi_1404_;
                                            let _e1247 = phi_1405_;
                                            phi_1406_ = _e1243;
                                            phi_1407_ = _e1245;
                                            phi_1408_ = _e1247;
                                        } else {
                                            phi_1406_ = f32();
                                            phi_1407_ = true;
                                            phi_1408_ = false;
                                        }
                                        let _e1249 = phi_1406_;
                                        let _e1251 = phi_1407_;
                                        let _e1253 = phi_1408_;
                                        if _e1251 {
                                            phi_1412_ = false;
                                        } else {
                                            phi_1412_ = _e1253;
                                        }
                                        let _e1255 = phi_1412_;
                                        phi_1413_ = _e1249;
                                        phi_1414_ = _e1255;
                                    } else {
                                        phi_1413_ = _e1234;
                                        phi_1414_ = true;
                                    }
                                    let _e1257 = phi_1413_;
                                    let _e1259 = phi_1414_;
                                    if _e1259 {
                                        let _e1260 = (_e1257 == 0f);
                                        if _e1260 {
                                            phi_1730_ = lt_bvh_triangle_Intersection();
                                            phi_1731_ = false;
                                        } else {
                                            let _e1262 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1264 = (_e1262.x - _e233);
                                            let _e1266 = (_e1262.y - _e235);
                                            let _e1268 = (_e1262.z - _e237);
                                            if (_e459 == 0u) {
                                                phi_1443_ = vec3<f32>(_e1266, _e1268, _e1264);
                                            } else {
                                                if (_e459 == 1u) {
                                                    phi_1442_ = vec3<f32>(_e1268, _e1264, _e1266);
                                                } else {
                                                    phi_1442_ = (_e1262 - vec3<f32>(_e233, _e235, _e237));
                                                }
                                                let _e1276 = phi_1442_;
                                                phi_1443_ = _e1276;
                                            }
                                            let _e1278 = phi_1443_;
                                            let _e1280 = triangles.member[(0u + _e1073)].v1_;
                                            let _e1282 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1285 = (_e1280.x - _e1282.x);
                                            let _e1288 = (_e1280.y - _e1282.y);
                                            let _e1291 = (_e1280.z - _e1282.z);
                                            if (_e459 == 0u) {
                                                phi_1469_ = vec3<f32>(_e1288, _e1291, _e1285);
                                            } else {
                                                if (_e459 == 1u) {
                                                    phi_1468_ = vec3<f32>(_e1291, _e1285, _e1288);
                                                } else {
                                                    phi_1468_ = (_e1280 - _e1282);
                                                }
                                                let _e1298 = phi_1468_;
                                                phi_1469_ = _e1298;
                                            }
                                            let _e1300 = phi_1469_;
                                            let _e1302 = triangles.member[(0u + _e1073)].v2_;
                                            let _e1304 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1307 = (_e1302.x - _e1304.x);
                                            let _e1310 = (_e1302.y - _e1304.y);
                                            let _e1313 = (_e1302.z - _e1304.z);
                                            if (_e459 == 0u) {
                                                phi_1495_ = vec3<f32>(_e1310, _e1313, _e1307);
                                            } else {
                                                if (_e459 == 1u) {
                                                    phi_1494_ = vec3<f32>(_e1313, _e1307, _e1310);
                                                } else {
                                                    phi_1494_ = (_e1302 - _e1304);
                                                }
                                                let _e1320 = phi_1494_;
                                                phi_1495_ = _e1320;
                                            }
                                            let _e1322 = phi_1495_;
                                            let _e1329 = ((_e1300.y * _e1322.z) - (_e1300.z * _e1322.y));
                                            let _e1336 = ((_e1300.z * _e1322.x) - (_e1300.x * _e1322.z));
                                            let _e1343 = ((_e1300.x * _e1322.y) - (_e1300.y * _e1322.x));
                                            let _e1357 = (((1f / _e467.z) * (((_e1329 * _e1278.x) + (_e1336 * _e1278.y)) + (_e1343 * _e1278.z))) / (((_e1329 * _e470) + (_e1336 * _e473)) + _e1343));
                                            if (_e1357 > 0f) {
                                                if (_e1357 < _e243) {
                                                    let _e1361 = triangles.member[(0u + _e1073)].v0_;
                                                    let _e1363 = triangles.member[(0u + _e1073)].v1_;
                                                    if (_e1361.x < _e1363.x) {
                                                        phi_1551_ = _e1361.x;
                                                    } else {
                                                        phi_1551_ = _e1363.x;
                                                    }
                                                    let _e1370 = phi_1551_;
                                                    if (_e1361.y < _e1363.y) {
                                                        phi_1560_ = _e1361.y;
                                                    } else {
                                                        phi_1560_ = _e1363.y;
                                                    }
                                                    let _e1377 = phi_1560_;
                                                    if (_e1361.z < _e1363.z) {
                                                        phi_1569_ = _e1361.z;
                                                    } else {
                                                        phi_1569_ = _e1363.z;
                                                    }
                                                    let _e1384 = phi_1569_;
                                                    let _e1386 = triangles.member[(0u + _e1073)].v2_;
                                                    if (_e1370 < _e1386.x) {
                                                        phi_1578_ = _e1370;
                                                    } else {
                                                        phi_1578_ = _e1386.x;
                                                    }
                                                    let _e1391 = phi_1578_;
                                                    if (_e1377 < _e1386.y) {
                                                        phi_1585_ = _e1377;
                                                    } else {
                                                        phi_1585_ = _e1386.y;
                                                    }
                                                    let _e1396 = phi_1585_;
                                                    if (_e1384 < _e1386.z) {
                                                        phi_1592_ = _e1384;
                                                    } else {
                                                        phi_1592_ = _e1386.z;
                                                    }
                                                    let _e1401 = phi_1592_;
                                                    let _e1403 = triangles.member[(0u + _e1073)].v0_;
                                                    let _e1405 = triangles.member[(0u + _e1073)].v1_;
                                                    if (_e1403.x > _e1405.x) {
                                                        phi_1605_ = _e1403.x;
                                                    } else {
                                                        phi_1605_ = _e1405.x;
                                                    }
                                                    let _e1412 = phi_1605_;
                                                    if (_e1403.y > _e1405.y) {
                                                        phi_1614_ = _e1403.y;
                                                    } else {
                                                        phi_1614_ = _e1405.y;
                                                    }
                                                    let _e1419 = phi_1614_;
                                                    if (_e1403.z > _e1405.z) {
                                                        phi_1623_ = _e1403.z;
                                                    } else {
                                                        phi_1623_ = _e1405.z;
                                                    }
                                                    let _e1426 = phi_1623_;
                                                    let _e1428 = triangles.member[(0u + _e1073)].v2_;
                                                    if (_e1412 > _e1428.x) {
                                                        phi_1632_ = _e1412;
                                                    } else {
                                                        phi_1632_ = _e1428.x;
                                                    }
                                                    let _e1433 = phi_1632_;
                                                    if (_e1419 > _e1428.y) {
                                                        phi_1639_ = _e1419;
                                                    } else {
                                                        phi_1639_ = _e1428.y;
                                                    }
                                                    let _e1438 = phi_1639_;
                                                    if (_e1426 > _e1428.z) {
                                                        phi_1646_ = _e1426;
                                                    } else {
                                                        phi_1646_ = _e1428.z;
                                                    }
                                                    let _e1443 = phi_1646_;
                                                    let _e1447 = ((_e1391 - _e233) * _e384);
                                                    let _e1448 = ((_e1396 - _e235) * _e394);
                                                    let _e1449 = ((_e1401 - _e237) * _e404);
                                                    let _e1453 = ((_e1433 - _e233) * _e384);
                                                    let _e1454 = ((_e1438 - _e235) * _e394);
                                                    let _e1455 = ((_e1443 - _e237) * _e404);
                                                    if (_e1447 < _e1453) {
                                                        phi_1663_ = _e1447;
                                                    } else {
                                                        phi_1663_ = _e1453;
                                                    }
                                                    let _e1458 = phi_1663_;
                                                    if (_e1448 < _e1454) {
                                                        phi_1668_ = _e1448;
                                                    } else {
                                                        phi_1668_ = _e1454;
                                                    }
                                                    let _e1461 = phi_1668_;
                                                    if (_e1449 < _e1455) {
                                                        phi_1673_ = _e1449;
                                                    } else {
                                                        phi_1673_ = _e1455;
                                                    }
                                                    let _e1464 = phi_1673_;
                                                    if (_e1447 > _e1453) {
                                                        phi_1681_ = _e1447;
                                                    } else {
                                                        phi_1681_ = _e1453;
                                                    }
                                                    let _e1470 = phi_1681_;
                                                    if (_e1448 > _e1454) {
                                                        phi_1686_ = _e1448;
                                                    } else {
                                                        phi_1686_ = _e1454;
                                                    }
                                                    let _e1473 = phi_1686_;
                                                    if (_e1449 > _e1455) {
                                                        phi_1691_ = _e1449;
                                                    } else {
                                                        phi_1691_ = _e1455;
                                                    }
                                                    let _e1476 = phi_1691_;
                                                    let _e1480 = core_intrinsics_maximum_number_nsz_f32_((_e1458 - _e443), (_e1461 - _e444));
                                                    let _e1481 = core_intrinsics_maximum_number_nsz_f32_(_e1480, (_e1464 - _e445));
                                                    let _e1482 = core_intrinsics_minimum_number_nsz_f32_((_e1470 + _e443), (_e1473 + _e444));
                                                    let _e1483 = core_intrinsics_minimum_number_nsz_f32_(_e1482, (_e1476 + _e445));
                                                    if (_e1481 > -300000000000000000000000000000000000000f) {
                                                        phi_1703_ = _e1481;
                                                    } else {
                                                        phi_1703_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1486 = phi_1703_;
                                                    if (_e1483 < 300000000000000000000000000000000000000f) {
                                                        phi_1708_ = _e1483;
                                                    } else {
                                                        phi_1708_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1489 = phi_1708_;
                                                    if (_e1357 < _e1486) {
                                                        phi_1713_ = _e1486;
                                                    } else {
                                                        phi_1713_ = _e1357;
                                                    }
                                                    let _e1492 = phi_1713_;
                                                    if (_e1492 > _e1489) {
                                                        phi_1718_ = _e1489;
                                                    } else {
                                                        phi_1718_ = _e1492;
                                                    }
                                                    let _e1495 = phi_1718_;
                                                    phi_1723_ = lt_bvh_triangle_Intersection(_e1495, (_e1198 / _e1257), (_e1219 / _e1257), (_e1486 <= _e1489));
                                                    phi_1724_ = false;
                                                } else {
                                                    phi_1723_ = lt_bvh_triangle_Intersection();
                                                    phi_1724_ = true;
                                                }
                                                let _e1501 = phi_1723_;
                                                let _e1503 = phi_1724_;
                                                phi_1725_ = _e1501;
                                                phi_1726_ = _e1503;
                                            } else {
                                                phi_1725_ = lt_bvh_triangle_Intersection();
                                                phi_1726_ = true;
                                            }
                                            let _e1505 = phi_1725_;
                                            let _e1507 = phi_1726_;
                                            if _e1507 {
                                            }
                                            phi_1730_ = _e1505;
                                            phi_1731_ = _e1507;
                                        }
                                        let _e1509 = phi_1730_;
                                        let _e1511 = phi_1731_;
                                        phi_1732_ = _e1509;
                                        phi_1733_ = _e1260;
                                        phi_1734_ = _e1511;
                                    } else {
                                        phi_1732_ = lt_bvh_triangle_Intersection();
                                        phi_1733_ = true;
                                        phi_1734_ = false;
                                    }
                                    let _e1513 = phi_1732_;
                                    let _e1515 = phi_1733_;
                                    let _e1517 = phi_1734_;
                                    if _e1515 {
                                        phi_1738_ = true;
                                    } else {
                                        phi_1738_ = _e1517;
                                    }
                                    let _e1519 = phi_1738_;
                                    if _e1519 {
                                        phi_1742_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1742_ = _e1513;
                                    }
                                    let _e1521 = phi_1742_;
                                    if _e1521.is_hit {
                                        if (_e1521.t > 0f) {
                                            if (_e1521.t < _e243) {
                                                if true {
                                                    phi_1762_ = false;
                                                } else {
                                                    phi_1762_ = true;
                                                }
                                                let _e1530 = phi_1762_;
                                                phi_1763_ = true;
                                                phi_1764_ = _e1530;
                                            } else {
                                                phi_1763_ = _e1064;
                                                phi_1764_ = true;
                                            }
                                            let _e1532 = phi_1763_;
                                            let _e1534 = phi_1764_;
                                            phi_1765_ = _e1532;
                                            phi_1766_ = _e1534;
                                        } else {
                                            phi_1765_ = _e1064;
                                            phi_1766_ = true;
                                        }
                                        let _e1536 = phi_1765_;
                                        let _e1538 = phi_1766_;
                                        phi_1767_ = _e1536;
                                        phi_1768_ = _e1538;
                                    } else {
                                        phi_1767_ = _e1064;
                                        phi_1768_ = true;
                                    }
                                    let _e1540 = phi_1767_;
                                    let _e1542 = phi_1768_;
                                    if _e1542 {
                                    }
                                    phi_1172_ = (_e1062 & (_e1062 - 1u));
                                    phi_1175_ = _e1540;
                                    phi_1772_ = _e1542;
                                }
                                let _e1544 = phi_1172_;
                                let _e1546 = phi_1175_;
                                let _e1548 = phi_1772_;
                                continue;
                                continuing {
                                    phi_1171_ = _e1544;
                                    phi_1174_ = _e1546;
                                    break if !(_e1548);
                                }
                            }
                            let _e1551 = local_5;
                            if _e1551 {
                                let _e1553 = local.group_mask;
                                if ((_e1553 & 4278190080u) == 0u) {
                                    let _e1557 = local.len;
                                    if (_e1557 == 0u) {
                                        phi_1814_ = false;
                                    } else {
                                        let _e1561 = local.len;
                                        local.len = (_e1561 - 1u);
                                        let _e1564 = local.len;
                                        if (_e1564 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1569 = local.first[(0u + _e1564)];
                                        local.group = _e1569;
                                        let _e1572 = local.len;
                                        if (_e1572 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1577 = local.mask[(0u + _e1572)];
                                        local.group_mask = _e1577;
                                        phi_1814_ = true;
                                    }
                                    let _e1580 = phi_1814_;
                                    phi_1815_ = _e1580;
                                } else {
                                    phi_1815_ = true;
                                }
                                let _e1582 = phi_1815_;
                                if _e1582 {
                                    let _e1584 = local.group_mask;
                                    let _e1590 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1584)), 32u, (_e1584 == 0u)));
                                    let _e1594 = local.group_mask;
                                    let _e1608 = local.group_mask;
                                    local.group_mask = (_e1608 & ~((1u << bitcast<u32>((_e1590 & 31u)))));
                                    let _e1611 = local.group;
                                    phi_1846_ = (_e1611 + countOneBits(((_e1594 & ~((4294967295u << bitcast<u32>((((_e1590 - 24u) ^ _e486) & 31u))))) & 255u)));
                                } else {
                                    phi_1846_ = 4294967295u;
                                }
                                let _e1614 = phi_1846_;
                                phi_1847_ = _e1614;
                            } else {
                                phi_1847_ = u32();
                            }
                            let _e1616 = phi_1847_;
                            phi_840_ = _e1616;
                            let _e1822 = local_7;
                            phi_843_ = _e1822;
                            let _e1825 = local_8;
                            phi_1848_ = _e1825;
                            phi_1849_ = false;
                        } else {
                            phi_840_ = u32();
                            phi_843_ = bool();
                            phi_1848_ = false;
                            phi_1849_ = true;
                        }
                        let _e1618 = phi_840_;
                        let _e1620 = phi_843_;
                        let _e1622 = phi_1848_;
                        let _e1624 = phi_1849_;
                        local_6 = _e1624;
                        continue;
                        continuing {
                            phi_839_ = _e1618;
                            phi_842_ = _e1620;
                            break if !(_e1622);
                        }
                    }
                    let _e1627 = local_6;
                    if _e1627 {
                        phi_1853_ = false;
                    } else {
                        phi_1853_ = true;
                    }
                    let _e1629 = phi_1853_;
                    if _e1629 {
                        phi_1857_ = true;
                    } else {
                        let _e1831 = local_9;
                        phi_1857_ = _e1831;
                    }
                    let _e1631 = phi_1857_;
                    phi_1858_ = _e1631;
                }
                let _e1633 = phi_1858_;
                phi_1859_ = _e1633;
                phi_1860_ = _e308;
            } else {
                phi_1859_ = bool();
                phi_1860_ = true;
            }
            let _e1635 = phi_1859_;
            let _e1637 = phi_1860_;
            if _e1637 {
                phi_1864_ = false;
            } else {
                phi_1864_ = _e1635;
            }
            let _e1639 = phi_1864_;
            if _e1639 {
                phi_1868_ = 0f;
            } else {
                phi_1868_ = 1f;
            }
            let _e1641 = phi_1868_;
            phi_1869_ = _e1641;
        }
        let _e1643 = phi_1869_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e1643;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
