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
    var phi_1898_: bool;
    var phi_1899_: bool;
    var phi_1900_: bool;
    var phi_1901_: bool;
    var phi_1905_: bool;

    let _e55 = (*param_7).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_7).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_7).normal[2u];
            let _e67 = global[2u];
            phi_1898_ = (_e65 == _e67);
            phi_1899_ = false;
        } else {
            phi_1898_ = bool();
            phi_1899_ = true;
        }
        let _e70 = phi_1898_;
        let _e72 = phi_1899_;
        phi_1900_ = _e70;
        phi_1901_ = _e72;
    } else {
        phi_1900_ = bool();
        phi_1901_ = true;
    }
    let _e74 = phi_1900_;
    let _e76 = phi_1901_;
    if _e76 {
        phi_1905_ = false;
    } else {
        phi_1905_ = _e74;
    }
    let _e78 = phi_1905_;
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
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_429_: bool;
    var phi_442_: bool;
    var phi_443_: bool;
    var phi_444_: bool;
    var phi_445_: bool;
    var phi_449_: bool;
    var phi_462_: bool;
    var phi_463_: bool;
    var phi_464_: bool;
    var phi_468_: bool;
    var phi_469_: bool;
    var phi_470_: bool;
    var phi_471_: bool;
    var phi_472_: bool;
    var phi_476_: bool;
    var phi_546_: f32;
    var phi_553_: f32;
    var phi_560_: f32;
    var phi_567_: f32;
    var phi_574_: f32;
    var phi_581_: f32;
    var phi_598_: f32;
    var phi_603_: f32;
    var phi_608_: f32;
    var phi_613_: f32;
    var phi_618_: f32;
    var phi_644_: bool;
    var phi_645_: bool;
    var phi_653_: u32;
    var phi_654_: u32;
    var phi_665_: vec3<f32>;
    var phi_666_: vec3<f32>;
    var phi_679_: u32;
    var phi_684_: u32;
    var phi_689_: u32;
    var phi_803_: bool;
    var phi_804_: bool;
    var phi_835_: u32;
    var phi_837_: u32;
    var phi_840_: bool;
    var phi_920_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_947_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_974_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_980_: u32;
    var phi_983_: u32;
    var phi_997_: u32;
    var phi_1007_: u32;
    var phi_1017_: u32;
    var phi_1035_: u32;
    var phi_1045_: u32;
    var phi_1055_: u32;
    var phi_1091_: u32;
    var phi_1104_: u32;
    var phi_1109_: u32;
    var phi_1110_: u32;
    var phi_1111_: u32;
    var phi_981_: u32;
    var phi_984_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1169_: u32;
    var phi_1172_: bool;
    var phi_1216_: vec3<f32>;
    var phi_1217_: vec3<f32>;
    var phi_1246_: vec3<f32>;
    var phi_1247_: vec3<f32>;
    var phi_1276_: vec3<f32>;
    var phi_1277_: vec3<f32>;
    var phi_1295_: bool;
    var phi_1296_: bool;
    var phi_1300_: f32;
    var phi_1301_: f32;
    var phi_1302_: f32;
    var phi_1303_: f32;
    var phi_1311_: f32;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1326_: f32;
    var phi_1327_: f32;
    var phi_1328_: f32;
    var phi_1329_: f32;
    var phi_1337_: f32;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1352_: f32;
    var phi_1353_: f32;
    var phi_1354_: f32;
    var phi_1355_: f32;
    var phi_1363_: f32;
    var phi_1378_: f32;
    var phi_1379_: bool;
    var phi_1380_: f32;
    var phi_1381_: bool;
    var phi_1382_: f32;
    var phi_1383_: bool;
    var phi_1401_: f32;
    var phi_1402_: bool;
    var phi_1403_: bool;
    var phi_1404_: f32;
    var phi_1405_: bool;
    var phi_1406_: bool;
    var phi_1410_: bool;
    var phi_1411_: f32;
    var phi_1412_: bool;
    var phi_1440_: vec3<f32>;
    var phi_1441_: vec3<f32>;
    var phi_1466_: vec3<f32>;
    var phi_1467_: vec3<f32>;
    var phi_1492_: vec3<f32>;
    var phi_1493_: vec3<f32>;
    var phi_1549_: f32;
    var phi_1558_: f32;
    var phi_1567_: f32;
    var phi_1576_: f32;
    var phi_1583_: f32;
    var phi_1590_: f32;
    var phi_1603_: f32;
    var phi_1612_: f32;
    var phi_1621_: f32;
    var phi_1630_: f32;
    var phi_1637_: f32;
    var phi_1644_: f32;
    var phi_1661_: f32;
    var phi_1666_: f32;
    var phi_1671_: f32;
    var phi_1679_: f32;
    var phi_1684_: f32;
    var phi_1689_: f32;
    var phi_1701_: f32;
    var phi_1706_: f32;
    var phi_1711_: f32;
    var phi_1716_: f32;
    var phi_1721_: lt_bvh_triangle_Intersection;
    var phi_1722_: bool;
    var phi_1723_: lt_bvh_triangle_Intersection;
    var phi_1724_: bool;
    var phi_1728_: lt_bvh_triangle_Intersection;
    var phi_1729_: bool;
    var phi_1730_: lt_bvh_triangle_Intersection;
    var phi_1731_: bool;
    var phi_1732_: bool;
    var phi_1736_: bool;
    var phi_1740_: lt_bvh_triangle_Intersection;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1764_: bool;
    var phi_1765_: bool;
    var phi_1766_: bool;
    var phi_1170_: u32;
    var phi_1173_: bool;
    var phi_1770_: bool;
    var local_5: bool;
    var phi_1812_: bool;
    var phi_1813_: bool;
    var phi_1844_: u32;
    var phi_1845_: u32;
    var phi_838_: u32;
    var phi_841_: bool;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var local_6: bool;
    var phi_1851_: bool;
    var phi_1855_: bool;
    var phi_1856_: bool;
    var phi_1857_: bool;
    var phi_1858_: bool;
    var phi_1862_: bool;
    var phi_1866_: f32;
    var phi_1867_: f32;
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
            phi_1867_ = _e213.unnamed.visibility;
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
            let _e255 = abs(_e251);
            let _e256 = abs(_e252);
            let _e257 = abs(_e253);
            if (abs(_e233) < 1000000000000000f) {
                if (abs(_e235) < 1000000000000000f) {
                    phi_422_ = (abs(_e237) < 1000000000000000f);
                    phi_423_ = false;
                } else {
                    phi_422_ = bool();
                    phi_423_ = true;
                }
                let _e265 = phi_422_;
                let _e267 = phi_423_;
                phi_424_ = _e265;
                phi_425_ = _e267;
            } else {
                phi_424_ = bool();
                phi_425_ = true;
            }
            let _e269 = phi_424_;
            let _e271 = phi_425_;
            if _e271 {
                phi_429_ = false;
            } else {
                phi_429_ = _e269;
            }
            let _e273 = phi_429_;
            if _e273 {
                if (_e255 < 1000000000000000f) {
                    if (_e256 < 1000000000000000f) {
                        phi_442_ = (_e257 < 1000000000000000f);
                        phi_443_ = false;
                    } else {
                        phi_442_ = bool();
                        phi_443_ = true;
                    }
                    let _e278 = phi_442_;
                    let _e280 = phi_443_;
                    phi_444_ = _e278;
                    phi_445_ = _e280;
                } else {
                    phi_444_ = bool();
                    phi_445_ = true;
                }
                let _e282 = phi_444_;
                let _e284 = phi_445_;
                if _e284 {
                    phi_449_ = false;
                } else {
                    phi_449_ = _e282;
                }
                let _e286 = phi_449_;
                if _e286 {
                    if (_e255 > 0f) {
                        phi_463_ = bool();
                        phi_464_ = true;
                    } else {
                        let _e288 = (_e256 > 0f);
                        if _e288 {
                            phi_462_ = bool();
                        } else {
                            phi_462_ = (_e257 > 0f);
                        }
                        let _e291 = phi_462_;
                        phi_463_ = _e291;
                        phi_464_ = _e288;
                    }
                    let _e293 = phi_463_;
                    let _e295 = phi_464_;
                    if _e295 {
                        phi_468_ = true;
                    } else {
                        phi_468_ = _e293;
                    }
                    let _e297 = phi_468_;
                    phi_469_ = _e297;
                    phi_470_ = false;
                } else {
                    phi_469_ = bool();
                    phi_470_ = true;
                }
                let _e299 = phi_469_;
                let _e301 = phi_470_;
                phi_471_ = _e299;
                phi_472_ = _e301;
            } else {
                phi_471_ = bool();
                phi_472_ = true;
            }
            let _e303 = phi_471_;
            let _e305 = phi_472_;
            if _e305 {
                phi_476_ = false;
            } else {
                phi_476_ = _e303;
            }
            let _e307 = phi_476_;
            if _e307 {
                let _e308 = (0u >= _e61);
                if _e308 {
                    phi_1856_ = bool();
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
                        phi_546_ = _e374;
                    } else {
                        phi_546_ = abs(_e251);
                    }
                    let _e379 = phi_546_;
                    if (_e251 < 0f) {
                        phi_553_ = (-1f / _e379);
                    } else {
                        phi_553_ = (1f / _e379);
                    }
                    let _e384 = phi_553_;
                    if (abs(_e252) < _e374) {
                        phi_560_ = _e374;
                    } else {
                        phi_560_ = abs(_e252);
                    }
                    let _e389 = phi_560_;
                    if (_e252 < 0f) {
                        phi_567_ = (-1f / _e389);
                    } else {
                        phi_567_ = (1f / _e389);
                    }
                    let _e394 = phi_567_;
                    if (abs(_e253) < _e374) {
                        phi_574_ = _e374;
                    } else {
                        phi_574_ = abs(_e253);
                    }
                    let _e399 = phi_574_;
                    if (_e253 < 0f) {
                        phi_581_ = (-1f / _e399);
                    } else {
                        phi_581_ = (1f / _e399);
                    }
                    let _e404 = phi_581_;
                    let _e408 = abs((bitcast<f32>(_e314) - _e233));
                    let _e409 = abs((bitcast<f32>(_e318) - _e235));
                    let _e410 = abs((bitcast<f32>(_e322) - _e237));
                    let _e414 = abs(((bitcast<f32>(_e326) + (bitcast<f32>((((_e338 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e233));
                    let _e415 = abs(((bitcast<f32>(_e330) + (bitcast<f32>((((_e338 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e235));
                    let _e416 = abs(((bitcast<f32>(_e334) + (bitcast<f32>((((_e338 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e237));
                    if (_e408 > _e414) {
                        phi_598_ = _e408;
                    } else {
                        phi_598_ = _e414;
                    }
                    let _e419 = phi_598_;
                    if (_e409 > _e415) {
                        phi_603_ = _e409;
                    } else {
                        phi_603_ = _e415;
                    }
                    let _e422 = phi_603_;
                    if (_e410 > _e416) {
                        phi_608_ = _e410;
                    } else {
                        phi_608_ = _e416;
                    }
                    let _e425 = phi_608_;
                    if (_e419 > _e422) {
                        phi_613_ = _e419;
                    } else {
                        phi_613_ = _e422;
                    }
                    let _e428 = phi_613_;
                    if (_e428 > _e425) {
                        phi_618_ = _e428;
                    } else {
                        phi_618_ = _e425;
                    }
                    let _e431 = phi_618_;
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
                            phi_644_ = false;
                        } else {
                            phi_644_ = true;
                        }
                        let _e452 = phi_644_;
                        phi_645_ = _e452;
                    } else {
                        phi_645_ = true;
                    }
                    let _e454 = phi_645_;
                    if _e454 {
                        if (_e447 >= _e448) {
                            phi_653_ = 1u;
                        } else {
                            phi_653_ = 2u;
                        }
                        let _e457 = phi_653_;
                        phi_654_ = _e457;
                    } else {
                        phi_654_ = 0u;
                    }
                    let _e459 = phi_654_;
                    if (_e459 == 0u) {
                        phi_666_ = vec3<f32>(_e252, _e253, _e251);
                    } else {
                        if (_e459 == 1u) {
                            phi_665_ = vec3<f32>(_e253, _e251, _e252);
                        } else {
                            phi_665_ = vec3<f32>(_e251, _e252, _e253);
                        }
                        let _e465 = phi_665_;
                        phi_666_ = _e465;
                    }
                    let _e467 = phi_666_;
                    let _e470 = (_e467.x / _e467.z);
                    let _e473 = (_e467.y / _e467.z);
                    if (_e384 < 0f) {
                        phi_679_ = 0u;
                    } else {
                        phi_679_ = 1u;
                    }
                    let _e478 = phi_679_;
                    if (_e394 < 0f) {
                        phi_684_ = 0u;
                    } else {
                        phi_684_ = 2u;
                    }
                    let _e481 = phi_684_;
                    if (_e404 < 0f) {
                        phi_689_ = 0u;
                    } else {
                        phi_689_ = 4u;
                    }
                    let _e484 = phi_689_;
                    let _e486 = ((_e478 | _e481) | _e484);
                    let _e487 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e487.first[0], _e487.first[1], _e487.first[2], _e487.first[3], _e487.first[4], _e487.first[5], _e487.first[6], _e487.first[7], _e487.first[8], _e487.first[9], _e487.first[10], _e487.first[11], _e487.first[12], _e487.first[13], _e487.first[14], _e487.first[15], _e487.first[16], _e487.first[17], _e487.first[18], _e487.first[19], _e487.first[20], _e487.first[21], _e487.first[22], _e487.first[23], _e487.first[24], _e487.first[25], _e487.first[26], _e487.first[27], _e487.first[28], _e487.first[29], _e487.first[30], _e487.first[31]), array<u32, 32>(_e487.mask[0], _e487.mask[1], _e487.mask[2], _e487.mask[3], _e487.mask[4], _e487.mask[5], _e487.mask[6], _e487.mask[7], _e487.mask[8], _e487.mask[9], _e487.mask[10], _e487.mask[11], _e487.mask[12], _e487.mask[13], _e487.mask[14], _e487.mask[15], _e487.mask[16], _e487.mask[17], _e487.mask[18], _e487.mask[19], _e487.mask[20], _e487.mask[21], _e487.mask[22], _e487.mask[23], _e487.mask[24], _e487.mask[25], _e487.mask[26], _e487.mask[27], _e487.mask[28], _e487.mask[29], _e487.mask[30], _e487.mask[31]), _e487.len, _e487.group, _e487.group_mask);
                    let _e561 = local.group_mask;
                    if ((_e561 & 4278190080u) == 0u) {
                        let _e565 = local.len;
                        if (_e565 == 0u) {
                            phi_803_ = false;
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
                            phi_803_ = true;
                        }
                        let _e588 = phi_803_;
                        phi_804_ = _e588;
                    } else {
                        phi_804_ = true;
                    }
                    let _e590 = phi_804_;
                    if _e590 {
                        let _e592 = local.group_mask;
                        let _e598 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e592)), 32u, (_e592 == 0u)));
                        let _e602 = local.group_mask;
                        let _e616 = local.group_mask;
                        local.group_mask = (_e616 & ~((1u << bitcast<u32>((_e598 & 31u)))));
                        let _e619 = local.group;
                        phi_835_ = (_e619 + countOneBits(((_e602 & ~((4294967295u << bitcast<u32>((((_e598 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_835_ = 4294967295u;
                    }
                    let _e622 = phi_835_;
                    phi_837_ = _e622;
                    phi_840_ = false;
                    loop {
                        let _e624 = phi_837_;
                        let _e626 = phi_840_;
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
                                let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e686.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e697.unnamed.word, _e686.w), _e697.unnamed_1);
                                let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e703.unnamed, lt_mask_LightPlace(_e686.x, _e703.unnamed_1.shift));
                                phi_920_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_mask_LightPlace(_e709.unnamed_1.word, _e686.y));
                            } else {
                                let _e725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e686.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e725.unnamed.word, _e686.y), _e725.unnamed_1);
                                let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e731.unnamed, lt_mask_LightPlace(_e686.z, _e731.unnamed_1.shift));
                                phi_920_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_mask_LightPlace(_e737.unnamed_1.word, _e686.w));
                            }
                            let _e745 = phi_920_;
                            let _e755 = nodes.member[(0u + _e624)].y;
                            if (_e394 < 0f) {
                                let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e755.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e772 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e766.unnamed.word, _e755.w), _e766.unnamed_1);
                                let _e778 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e772.unnamed, lt_mask_LightPlace(_e755.x, _e772.unnamed_1.shift));
                                phi_947_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e778.unnamed, lt_mask_LightPlace(_e778.unnamed_1.word, _e755.y));
                            } else {
                                let _e794 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e755.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e800 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e794.unnamed.word, _e755.y), _e794.unnamed_1);
                                let _e806 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e800.unnamed, lt_mask_LightPlace(_e755.z, _e800.unnamed_1.shift));
                                phi_947_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e806.unnamed, lt_mask_LightPlace(_e806.unnamed_1.word, _e755.w));
                            }
                            let _e814 = phi_947_;
                            let _e824 = nodes.member[(0u + _e624)].z;
                            if (_e404 < 0f) {
                                let _e835 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e824.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e841 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e835.unnamed.word, _e824.w), _e835.unnamed_1);
                                let _e847 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e841.unnamed, lt_mask_LightPlace(_e824.x, _e841.unnamed_1.shift));
                                phi_974_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e847.unnamed, lt_mask_LightPlace(_e847.unnamed_1.word, _e824.y));
                            } else {
                                let _e863 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e824.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e869 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e863.unnamed.word, _e824.y), _e863.unnamed_1);
                                let _e875 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e869.unnamed, lt_mask_LightPlace(_e824.z, _e869.unnamed_1.shift));
                                phi_974_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e875.unnamed, lt_mask_LightPlace(_e875.unnamed_1.word, _e824.w));
                            }
                            let _e883 = phi_974_;
                            phi_980_ = 0u;
                            phi_983_ = 0u;
                            loop {
                                let _e893 = phi_980_;
                                let _e895 = phi_983_;
                                local_2 = _e895;
                                local_3 = _e895;
                                local_4 = _e895;
                                let _e896 = (_e893 < 8u);
                                if _e896 {
                                    let _e898 = (_e893 >> bitcast<u32>(2i));
                                    let _e899 = (_e893 & 3u);
                                    if (_e898 == 0u) {
                                        phi_997_ = _e745.unnamed.word;
                                    } else {
                                        phi_997_ = _e745.unnamed.shift;
                                    }
                                    let _e902 = phi_997_;
                                    if (_e898 == 0u) {
                                        phi_1007_ = _e814.unnamed.word;
                                    } else {
                                        phi_1007_ = _e814.unnamed.shift;
                                    }
                                    let _e911 = phi_1007_;
                                    if (_e898 == 0u) {
                                        phi_1017_ = _e883.unnamed.word;
                                    } else {
                                        phi_1017_ = _e883.unnamed.shift;
                                    }
                                    let _e920 = phi_1017_;
                                    let _e933 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e902 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e658) + (_e676 - _e436)), ((f32(((_e911 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e659) + (_e677 - _e437)));
                                    let _e934 = core_intrinsics_maximum_number_nsz_f32_(_e933, ((f32(((_e920 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e660) + (_e678 - _e438)));
                                    if (_e898 == 0u) {
                                        phi_1035_ = _e745.unnamed_1.word;
                                    } else {
                                        phi_1035_ = _e745.unnamed_1.shift;
                                    }
                                    let _e937 = phi_1035_;
                                    if (_e898 == 0u) {
                                        phi_1045_ = _e814.unnamed_1.word;
                                    } else {
                                        phi_1045_ = _e814.unnamed_1.shift;
                                    }
                                    let _e946 = phi_1045_;
                                    if (_e898 == 0u) {
                                        phi_1055_ = _e883.unnamed_1.word;
                                    } else {
                                        phi_1055_ = _e883.unnamed_1.shift;
                                    }
                                    let _e955 = phi_1055_;
                                    let _e968 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e937 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e658) + (_e676 + _e436)), ((f32(((_e946 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e659) + (_e677 + _e437)));
                                    let _e969 = core_intrinsics_minimum_number_nsz_f32_(_e968, ((f32(((_e955 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u)) * _e660) + (_e678 + _e438)));
                                    if (_e934 <= _e969) {
                                        if (_e934 <= _e243) {
                                            if (_e969 >= 0f) {
                                                if (_e898 == 0u) {
                                                    let _e976 = nodes.member[(0u + _e624)].links[2u];
                                                    phi_1091_ = _e976;
                                                } else {
                                                    let _e979 = nodes.member[(0u + _e624)].links[3u];
                                                    phi_1091_ = _e979;
                                                }
                                                let _e981 = phi_1091_;
                                                let _e986 = ((_e981 >> bitcast<u32>(((_e899 * 8u) & 31u))) & 255u);
                                                let _e987 = (_e986 & 31u);
                                                if (_e987 >= 24u) {
                                                    phi_1104_ = (24u + ((_e987 - 24u) ^ _e486));
                                                } else {
                                                    phi_1104_ = _e987;
                                                }
                                                let _e993 = phi_1104_;
                                                phi_1109_ = (_e895 | ((_e986 >> bitcast<u32>(5i)) << bitcast<u32>((_e993 & 31u))));
                                            } else {
                                                phi_1109_ = _e895;
                                            }
                                            let _e1001 = phi_1109_;
                                            phi_1110_ = _e1001;
                                        } else {
                                            phi_1110_ = _e895;
                                        }
                                        let _e1003 = phi_1110_;
                                        phi_1111_ = _e1003;
                                    } else {
                                        phi_1111_ = _e895;
                                    }
                                    let _e1005 = phi_1111_;
                                    phi_981_ = (_e893 + 1u);
                                    phi_984_ = _e1005;
                                } else {
                                    phi_981_ = u32();
                                    phi_984_ = u32();
                                }
                                let _e1008 = phi_981_;
                                let _e1010 = phi_984_;
                                continue;
                                continuing {
                                    phi_980_ = _e1008;
                                    phi_983_ = _e1010;
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
                            phi_1169_ = (_e1059 & 16777215u);
                            phi_1172_ = _e626;
                            loop {
                                let _e1062 = phi_1169_;
                                let _e1064 = phi_1172_;
                                local_7 = _e1064;
                                let _e1065 = (_e1062 == 0u);
                                local_5 = _e1065;
                                local_8 = _e1065;
                                if _e1065 {
                                    phi_1170_ = u32();
                                    phi_1173_ = bool();
                                    phi_1770_ = false;
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
                                        phi_1217_ = vec3<f32>(_e1084, _e1086, _e1082);
                                    } else {
                                        if (_e459 == 1u) {
                                            phi_1216_ = vec3<f32>(_e1086, _e1082, _e1084);
                                        } else {
                                            phi_1216_ = (_e1080 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1094 = phi_1216_;
                                        phi_1217_ = _e1094;
                                    }
                                    let _e1096 = phi_1217_;
                                    let _e1100 = (_e1096.x - (_e470 * _e1096.z));
                                    let _e1104 = (_e1096.y - (_e473 * _e1096.z));
                                    let _e1106 = triangles.member[(0u + _e1073)].v1_;
                                    let _e1108 = (_e1106.x - _e233);
                                    let _e1110 = (_e1106.y - _e235);
                                    let _e1112 = (_e1106.z - _e237);
                                    if (_e459 == 0u) {
                                        phi_1247_ = vec3<f32>(_e1110, _e1112, _e1108);
                                    } else {
                                        if (_e459 == 1u) {
                                            phi_1246_ = vec3<f32>(_e1112, _e1108, _e1110);
                                        } else {
                                            phi_1246_ = (_e1106 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1120 = phi_1246_;
                                        phi_1247_ = _e1120;
                                    }
                                    let _e1122 = phi_1247_;
                                    let _e1126 = (_e1122.x - (_e470 * _e1122.z));
                                    let _e1130 = (_e1122.y - (_e473 * _e1122.z));
                                    let _e1132 = triangles.member[(0u + _e1073)].v2_;
                                    let _e1134 = (_e1132.x - _e233);
                                    let _e1136 = (_e1132.y - _e235);
                                    let _e1138 = (_e1132.z - _e237);
                                    if (_e459 == 0u) {
                                        phi_1277_ = vec3<f32>(_e1136, _e1138, _e1134);
                                    } else {
                                        if (_e459 == 1u) {
                                            phi_1276_ = vec3<f32>(_e1138, _e1134, _e1136);
                                        } else {
                                            phi_1276_ = (_e1132 - vec3<f32>(_e233, _e235, _e237));
                                        }
                                        let _e1146 = phi_1276_;
                                        phi_1277_ = _e1146;
                                    }
                                    let _e1148 = phi_1277_;
                                    let _e1152 = (_e1148.x - (_e470 * _e1148.z));
                                    let _e1156 = (_e1148.y - (_e473 * _e1148.z));
                                    if (_e1126 < _e1152) {
                                        phi_1296_ = true;
                                    } else {
                                        if (_e1126 == _e1152) {
                                            phi_1295_ = (_e1130 < _e1156);
                                        } else {
                                            phi_1295_ = false;
                                        }
                                        let _e1161 = phi_1295_;
                                        phi_1296_ = _e1161;
                                    }
                                    let _e1163 = phi_1296_;
                                    if _e1163 {
                                        phi_1300_ = _e1156;
                                        phi_1301_ = _e1152;
                                        phi_1302_ = _e1130;
                                        phi_1303_ = _e1126;
                                    } else {
                                        phi_1300_ = _e1130;
                                        phi_1301_ = _e1126;
                                        phi_1302_ = _e1156;
                                        phi_1303_ = _e1152;
                                    }
                                    let _e1165 = phi_1300_;
                                    let _e1167 = phi_1301_;
                                    let _e1169 = phi_1302_;
                                    let _e1171 = phi_1303_;
                                    let _e1174 = ((_e1171 * _e1165) - (_e1169 * _e1167));
                                    if _e1163 {
                                        phi_1311_ = -(_e1174);
                                    } else {
                                        phi_1311_ = _e1174;
                                    }
                                    let _e1177 = phi_1311_;
                                    if (_e1152 < _e1100) {
                                        phi_1322_ = true;
                                    } else {
                                        if (_e1152 == _e1100) {
                                            phi_1321_ = (_e1156 < _e1104);
                                        } else {
                                            phi_1321_ = false;
                                        }
                                        let _e1182 = phi_1321_;
                                        phi_1322_ = _e1182;
                                    }
                                    let _e1184 = phi_1322_;
                                    if _e1184 {
                                        phi_1326_ = _e1104;
                                        phi_1327_ = _e1100;
                                        phi_1328_ = _e1156;
                                        phi_1329_ = _e1152;
                                    } else {
                                        phi_1326_ = _e1156;
                                        phi_1327_ = _e1152;
                                        phi_1328_ = _e1104;
                                        phi_1329_ = _e1100;
                                    }
                                    let _e1186 = phi_1326_;
                                    let _e1188 = phi_1327_;
                                    let _e1190 = phi_1328_;
                                    let _e1192 = phi_1329_;
                                    let _e1195 = ((_e1192 * _e1186) - (_e1190 * _e1188));
                                    if _e1184 {
                                        phi_1337_ = -(_e1195);
                                    } else {
                                        phi_1337_ = _e1195;
                                    }
                                    let _e1198 = phi_1337_;
                                    if (_e1100 < _e1126) {
                                        phi_1348_ = true;
                                    } else {
                                        if (_e1100 == _e1126) {
                                            phi_1347_ = (_e1104 < _e1130);
                                        } else {
                                            phi_1347_ = false;
                                        }
                                        let _e1203 = phi_1347_;
                                        phi_1348_ = _e1203;
                                    }
                                    let _e1205 = phi_1348_;
                                    if _e1205 {
                                        phi_1352_ = _e1130;
                                        phi_1353_ = _e1126;
                                        phi_1354_ = _e1104;
                                        phi_1355_ = _e1100;
                                    } else {
                                        phi_1352_ = _e1104;
                                        phi_1353_ = _e1100;
                                        phi_1354_ = _e1130;
                                        phi_1355_ = _e1126;
                                    }
                                    let _e1207 = phi_1352_;
                                    let _e1209 = phi_1353_;
                                    let _e1211 = phi_1354_;
                                    let _e1213 = phi_1355_;
                                    let _e1216 = ((_e1213 * _e1207) - (_e1211 * _e1209));
                                    if _e1205 {
                                        phi_1363_ = -(_e1216);
                                    } else {
                                        phi_1363_ = _e1216;
                                    }
                                    let _e1219 = phi_1363_;
                                    if (_e1177 >= 0f) {
                                        if (_e1198 >= 0f) {
                                            if (_e1219 >= 0f) {
                                                phi_1378_ = ((_e1177 + _e1198) + _e1219);
                                                phi_1379_ = false;
                                            } else {
                                                phi_1378_ = f32();
                                                phi_1379_ = true;
                                            }
                                            let _e1226 = phi_1378_;
                                            let _e1228 = phi_1379_;
                                            phi_1380_ = _e1226;
                                            phi_1381_ = _e1228;
                                        } else {
                                            phi_1380_ = f32();
                                            phi_1381_ = true;
                                        }
                                        let _e1230 = phi_1380_;
                                        let _e1232 = phi_1381_;
                                        phi_1382_ = _e1230;
                                        phi_1383_ = _e1232;
                                    } else {
                                        phi_1382_ = f32();
                                        phi_1383_ = true;
                                    }
                                    let _e1234 = phi_1382_;
                                    let _e1236 = phi_1383_;
                                    if _e1236 {
                                        if (_e1177 <= 0f) {
                                            if (_e1198 <= 0f) {
                                                let _e1239 = (_e1219 <= 0f);
                                                if _e1239 {
                                                }
                                                phi_1401_ = ((_e1177 + _e1198) + _e1219);
                                                phi_1402_ = false;
                                                phi_1403_ = _e1239;
                                            } else {
                                                phi_1401_ = f32();
                                                phi_1402_ = true;
                                                phi_1403_ = false;
                                            }
                                            let _e1243 = phi_1401_;
                                            let _e1245 = phi_1402_;
                                            let _e1247 = phi_1403_;
                                            phi_1404_ = _e1243;
                                            phi_1405_ = _e1245;
                                            phi_1406_ = _e1247;
                                        } else {
                                            phi_1404_ = f32();
                                            phi_1405_ = true;
                                            phi_1406_ = false;
                                        }
                                        let _e1249 = phi_1404_;
                                        let _e1251 = phi_1405_;
                                        let _e1253 = phi_1406_;
                                        if _e1251 {
                                            phi_1410_ = false;
                                        } else {
                                            phi_1410_ = _e1253;
                                        }
                                        let _e1255 = phi_1410_;
                                        phi_1411_ = _e1249;
                                        phi_1412_ = _e1255;
                                    } else {
                                        phi_1411_ = _e1234;
                                        phi_1412_ = true;
                                    }
                                    let _e1257 = phi_1411_;
                                    let _e1259 = phi_1412_;
                                    if _e1259 {
                                        let _e1260 = (_e1257 == 0f);
                                        if _e1260 {
                                            phi_1728_ = lt_bvh_triangle_Intersection();
                                            phi_1729_ = false;
                                        } else {
                                            let _e1262 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1264 = (_e1262.x - _e233);
                                            let _e1266 = (_e1262.y - _e235);
                                            let _e1268 = (_e1262.z - _e237);
                                            if (_e459 == 0u) {
                                                phi_1441_ = vec3<f32>(_e1266, _e1268, _e1264);
                                            } else {
                                                if (_e459 == 1u) {
                                                    phi_1440_ = vec3<f32>(_e1268, _e1264, _e1266);
                                                } else {
                                                    phi_1440_ = (_e1262 - vec3<f32>(_e233, _e235, _e237));
                                                }
                                                let _e1276 = phi_1440_;
                                                phi_1441_ = _e1276;
                                            }
                                            let _e1278 = phi_1441_;
                                            let _e1280 = triangles.member[(0u + _e1073)].v1_;
                                            let _e1282 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1285 = (_e1280.x - _e1282.x);
                                            let _e1288 = (_e1280.y - _e1282.y);
                                            let _e1291 = (_e1280.z - _e1282.z);
                                            if (_e459 == 0u) {
                                                phi_1467_ = vec3<f32>(_e1288, _e1291, _e1285);
                                            } else {
                                                if (_e459 == 1u) {
                                                    phi_1466_ = vec3<f32>(_e1291, _e1285, _e1288);
                                                } else {
                                                    phi_1466_ = (_e1280 - _e1282);
                                                }
                                                let _e1298 = phi_1466_;
                                                phi_1467_ = _e1298;
                                            }
                                            let _e1300 = phi_1467_;
                                            let _e1302 = triangles.member[(0u + _e1073)].v2_;
                                            let _e1304 = triangles.member[(0u + _e1073)].v0_;
                                            let _e1307 = (_e1302.x - _e1304.x);
                                            let _e1310 = (_e1302.y - _e1304.y);
                                            let _e1313 = (_e1302.z - _e1304.z);
                                            if (_e459 == 0u) {
                                                phi_1493_ = vec3<f32>(_e1310, _e1313, _e1307);
                                            } else {
                                                if (_e459 == 1u) {
                                                    phi_1492_ = vec3<f32>(_e1313, _e1307, _e1310);
                                                } else {
                                                    phi_1492_ = (_e1302 - _e1304);
                                                }
                                                let _e1320 = phi_1492_;
                                                phi_1493_ = _e1320;
                                            }
                                            let _e1322 = phi_1493_;
                                            let _e1329 = ((_e1300.y * _e1322.z) - (_e1300.z * _e1322.y));
                                            let _e1336 = ((_e1300.z * _e1322.x) - (_e1300.x * _e1322.z));
                                            let _e1343 = ((_e1300.x * _e1322.y) - (_e1300.y * _e1322.x));
                                            let _e1357 = (((1f / _e467.z) * (((_e1329 * _e1278.x) + (_e1336 * _e1278.y)) + (_e1343 * _e1278.z))) / (((_e1329 * _e470) + (_e1336 * _e473)) + _e1343));
                                            if (_e1357 > 0f) {
                                                if (_e1357 < _e243) {
                                                    let _e1361 = triangles.member[(0u + _e1073)].v0_;
                                                    let _e1363 = triangles.member[(0u + _e1073)].v1_;
                                                    if (_e1361.x < _e1363.x) {
                                                        phi_1549_ = _e1361.x;
                                                    } else {
                                                        phi_1549_ = _e1363.x;
                                                    }
                                                    let _e1370 = phi_1549_;
                                                    if (_e1361.y < _e1363.y) {
                                                        phi_1558_ = _e1361.y;
                                                    } else {
                                                        phi_1558_ = _e1363.y;
                                                    }
                                                    let _e1377 = phi_1558_;
                                                    if (_e1361.z < _e1363.z) {
                                                        phi_1567_ = _e1361.z;
                                                    } else {
                                                        phi_1567_ = _e1363.z;
                                                    }
                                                    let _e1384 = phi_1567_;
                                                    let _e1386 = triangles.member[(0u + _e1073)].v2_;
                                                    if (_e1370 < _e1386.x) {
                                                        phi_1576_ = _e1370;
                                                    } else {
                                                        phi_1576_ = _e1386.x;
                                                    }
                                                    let _e1391 = phi_1576_;
                                                    if (_e1377 < _e1386.y) {
                                                        phi_1583_ = _e1377;
                                                    } else {
                                                        phi_1583_ = _e1386.y;
                                                    }
                                                    let _e1396 = phi_1583_;
                                                    if (_e1384 < _e1386.z) {
                                                        phi_1590_ = _e1384;
                                                    } else {
                                                        phi_1590_ = _e1386.z;
                                                    }
                                                    let _e1401 = phi_1590_;
                                                    let _e1403 = triangles.member[(0u + _e1073)].v0_;
                                                    let _e1405 = triangles.member[(0u + _e1073)].v1_;
                                                    if (_e1403.x > _e1405.x) {
                                                        phi_1603_ = _e1403.x;
                                                    } else {
                                                        phi_1603_ = _e1405.x;
                                                    }
                                                    let _e1412 = phi_1603_;
                                                    if (_e1403.y > _e1405.y) {
                                                        phi_1612_ = _e1403.y;
                                                    } else {
                                                        phi_1612_ = _e1405.y;
                                                    }
                                                    let _e1419 = phi_1612_;
                                                    if (_e1403.z > _e1405.z) {
                                                        phi_1621_ = _e1403.z;
                                                    } else {
                                                        phi_1621_ = _e1405.z;
                                                    }
                                                    let _e1426 = phi_1621_;
                                                    let _e1428 = triangles.member[(0u + _e1073)].v2_;
                                                    if (_e1412 > _e1428.x) {
                                                        phi_1630_ = _e1412;
                                                    } else {
                                                        phi_1630_ = _e1428.x;
                                                    }
                                                    let _e1433 = phi_1630_;
                                                    if (_e1419 > _e1428.y) {
                                                        phi_1637_ = _e1419;
                                                    } else {
                                                        phi_1637_ = _e1428.y;
                                                    }
                                                    let _e1438 = phi_1637_;
                                                    if (_e1426 > _e1428.z) {
                                                        phi_1644_ = _e1426;
                                                    } else {
                                                        phi_1644_ = _e1428.z;
                                                    }
                                                    let _e1443 = phi_1644_;
                                                    let _e1447 = ((_e1391 - _e233) * _e384);
                                                    let _e1448 = ((_e1396 - _e235) * _e394);
                                                    let _e1449 = ((_e1401 - _e237) * _e404);
                                                    let _e1453 = ((_e1433 - _e233) * _e384);
                                                    let _e1454 = ((_e1438 - _e235) * _e394);
                                                    let _e1455 = ((_e1443 - _e237) * _e404);
                                                    if (_e1447 < _e1453) {
                                                        phi_1661_ = _e1447;
                                                    } else {
                                                        phi_1661_ = _e1453;
                                                    }
                                                    let _e1458 = phi_1661_;
                                                    if (_e1448 < _e1454) {
                                                        phi_1666_ = _e1448;
                                                    } else {
                                                        phi_1666_ = _e1454;
                                                    }
                                                    let _e1461 = phi_1666_;
                                                    if (_e1449 < _e1455) {
                                                        phi_1671_ = _e1449;
                                                    } else {
                                                        phi_1671_ = _e1455;
                                                    }
                                                    let _e1464 = phi_1671_;
                                                    if (_e1447 > _e1453) {
                                                        phi_1679_ = _e1447;
                                                    } else {
                                                        phi_1679_ = _e1453;
                                                    }
                                                    let _e1470 = phi_1679_;
                                                    if (_e1448 > _e1454) {
                                                        phi_1684_ = _e1448;
                                                    } else {
                                                        phi_1684_ = _e1454;
                                                    }
                                                    let _e1473 = phi_1684_;
                                                    if (_e1449 > _e1455) {
                                                        phi_1689_ = _e1449;
                                                    } else {
                                                        phi_1689_ = _e1455;
                                                    }
                                                    let _e1476 = phi_1689_;
                                                    let _e1480 = core_intrinsics_maximum_number_nsz_f32_((_e1458 - _e443), (_e1461 - _e444));
                                                    let _e1481 = core_intrinsics_maximum_number_nsz_f32_(_e1480, (_e1464 - _e445));
                                                    let _e1482 = core_intrinsics_minimum_number_nsz_f32_((_e1470 + _e443), (_e1473 + _e444));
                                                    let _e1483 = core_intrinsics_minimum_number_nsz_f32_(_e1482, (_e1476 + _e445));
                                                    if (_e1481 > -300000000000000000000000000000000000000f) {
                                                        phi_1701_ = _e1481;
                                                    } else {
                                                        phi_1701_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1486 = phi_1701_;
                                                    if (_e1483 < 300000000000000000000000000000000000000f) {
                                                        phi_1706_ = _e1483;
                                                    } else {
                                                        phi_1706_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1489 = phi_1706_;
                                                    if (_e1357 < _e1486) {
                                                        phi_1711_ = _e1486;
                                                    } else {
                                                        phi_1711_ = _e1357;
                                                    }
                                                    let _e1492 = phi_1711_;
                                                    if (_e1492 > _e1489) {
                                                        phi_1716_ = _e1489;
                                                    } else {
                                                        phi_1716_ = _e1492;
                                                    }
                                                    let _e1495 = phi_1716_;
                                                    phi_1721_ = lt_bvh_triangle_Intersection(_e1495, (_e1198 / _e1257), (_e1219 / _e1257), (_e1486 <= _e1489));
                                                    phi_1722_ = false;
                                                } else {
                                                    phi_1721_ = lt_bvh_triangle_Intersection();
                                                    phi_1722_ = true;
                                                }
                                                let _e1501 = phi_1721_;
                                                let _e1503 = phi_1722_;
                                                phi_1723_ = _e1501;
                                                phi_1724_ = _e1503;
                                            } else {
                                                phi_1723_ = lt_bvh_triangle_Intersection();
                                                phi_1724_ = true;
                                            }
                                            let _e1505 = phi_1723_;
                                            let _e1507 = phi_1724_;
                                            if _e1507 {
                                            }
                                            phi_1728_ = _e1505;
                                            phi_1729_ = _e1507;
                                        }
                                        let _e1509 = phi_1728_;
                                        let _e1511 = phi_1729_;
                                        phi_1730_ = _e1509;
                                        phi_1731_ = _e1260;
                                        phi_1732_ = _e1511;
                                    } else {
                                        phi_1730_ = lt_bvh_triangle_Intersection();
                                        phi_1731_ = true;
                                        phi_1732_ = false;
                                    }
                                    let _e1513 = phi_1730_;
                                    let _e1515 = phi_1731_;
                                    let _e1517 = phi_1732_;
                                    if _e1515 {
                                        phi_1736_ = true;
                                    } else {
                                        phi_1736_ = _e1517;
                                    }
                                    let _e1519 = phi_1736_;
                                    if _e1519 {
                                        phi_1740_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1740_ = _e1513;
                                    }
                                    let _e1521 = phi_1740_;
                                    if _e1521.is_hit {
                                        if (_e1521.t > 0f) {
                                            if (_e1521.t < _e243) {
                                                if true {
                                                    phi_1760_ = false;
                                                } else {
                                                    phi_1760_ = true;
                                                }
                                                let _e1530 = phi_1760_;
                                                phi_1761_ = true;
                                                phi_1762_ = _e1530;
                                            } else {
                                                phi_1761_ = _e1064;
                                                phi_1762_ = true;
                                            }
                                            let _e1532 = phi_1761_;
                                            let _e1534 = phi_1762_;
                                            phi_1763_ = _e1532;
                                            phi_1764_ = _e1534;
                                        } else {
                                            phi_1763_ = _e1064;
                                            phi_1764_ = true;
                                        }
                                        let _e1536 = phi_1763_;
                                        let _e1538 = phi_1764_;
                                        phi_1765_ = _e1536;
                                        phi_1766_ = _e1538;
                                    } else {
                                        phi_1765_ = _e1064;
                                        phi_1766_ = true;
                                    }
                                    let _e1540 = phi_1765_;
                                    let _e1542 = phi_1766_;
                                    if _e1542 {
                                    }
                                    phi_1170_ = (_e1062 & (_e1062 - 1u));
                                    phi_1173_ = _e1540;
                                    phi_1770_ = _e1542;
                                }
                                let _e1544 = phi_1170_;
                                let _e1546 = phi_1173_;
                                let _e1548 = phi_1770_;
                                continue;
                                continuing {
                                    phi_1169_ = _e1544;
                                    phi_1172_ = _e1546;
                                    break if !(_e1548);
                                }
                            }
                            let _e1551 = local_5;
                            if _e1551 {
                                let _e1553 = local.group_mask;
                                if ((_e1553 & 4278190080u) == 0u) {
                                    let _e1557 = local.len;
                                    if (_e1557 == 0u) {
                                        phi_1812_ = false;
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
                                        phi_1812_ = true;
                                    }
                                    let _e1580 = phi_1812_;
                                    phi_1813_ = _e1580;
                                } else {
                                    phi_1813_ = true;
                                }
                                let _e1582 = phi_1813_;
                                if _e1582 {
                                    let _e1584 = local.group_mask;
                                    let _e1590 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1584)), 32u, (_e1584 == 0u)));
                                    let _e1594 = local.group_mask;
                                    let _e1608 = local.group_mask;
                                    local.group_mask = (_e1608 & ~((1u << bitcast<u32>((_e1590 & 31u)))));
                                    let _e1611 = local.group;
                                    phi_1844_ = (_e1611 + countOneBits(((_e1594 & ~((4294967295u << bitcast<u32>((((_e1590 - 24u) ^ _e486) & 31u))))) & 255u)));
                                } else {
                                    phi_1844_ = 4294967295u;
                                }
                                let _e1614 = phi_1844_;
                                phi_1845_ = _e1614;
                            } else {
                                phi_1845_ = u32();
                            }
                            let _e1616 = phi_1845_;
                            phi_838_ = _e1616;
                            let _e1822 = local_7;
                            phi_841_ = _e1822;
                            let _e1825 = local_8;
                            phi_1846_ = _e1825;
                            phi_1847_ = false;
                        } else {
                            phi_838_ = u32();
                            phi_841_ = bool();
                            phi_1846_ = false;
                            phi_1847_ = true;
                        }
                        let _e1618 = phi_838_;
                        let _e1620 = phi_841_;
                        let _e1622 = phi_1846_;
                        let _e1624 = phi_1847_;
                        local_6 = _e1624;
                        continue;
                        continuing {
                            phi_837_ = _e1618;
                            phi_840_ = _e1620;
                            break if !(_e1622);
                        }
                    }
                    let _e1627 = local_6;
                    if _e1627 {
                        phi_1851_ = false;
                    } else {
                        phi_1851_ = true;
                    }
                    let _e1629 = phi_1851_;
                    if _e1629 {
                        phi_1855_ = true;
                    } else {
                        let _e1831 = local_9;
                        phi_1855_ = _e1831;
                    }
                    let _e1631 = phi_1855_;
                    phi_1856_ = _e1631;
                }
                let _e1633 = phi_1856_;
                phi_1857_ = _e1633;
                phi_1858_ = _e308;
            } else {
                phi_1857_ = bool();
                phi_1858_ = true;
            }
            let _e1635 = phi_1857_;
            let _e1637 = phi_1858_;
            if _e1637 {
                phi_1862_ = false;
            } else {
                phi_1862_ = _e1635;
            }
            let _e1639 = phi_1862_;
            if _e1639 {
                phi_1866_ = 0f;
            } else {
                phi_1866_ = 1f;
            }
            let _e1641 = phi_1866_;
            phi_1867_ = _e1641;
        }
        let _e1643 = phi_1867_;
        if (_e73.shift < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.shift)] = _e1643;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
