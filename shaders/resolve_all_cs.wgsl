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

struct type_28 {
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

struct type_37 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_45 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_45;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_28;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_176_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_168_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_169_ = false;
        } else {
            phi_168_ = lt_bvh_traverse_Tree();
            phi_169_ = true;
        }
        let _e65 = phi_168_;
        let _e67 = phi_169_;
        phi_170_ = _e65;
        phi_171_ = _e67;
    } else {
        phi_170_ = lt_bvh_traverse_Tree();
        phi_171_ = true;
    }
    let _e69 = phi_170_;
    let _e71 = phi_171_;
    if _e71 {
        phi_176_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_176_ = _e69;
    }
    let _e76 = phi_176_;
    return lt_bvh_traverse_Tree(_e76.root, _e76.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_191_: bool;
    var phi_195_: f32;

    if (param_3 != param_3) {
        phi_191_ = true;
    } else {
        let _e55 = (param_4 >= param_3);
        if _e55 {
        }
        phi_191_ = _e55;
    }
    let _e57 = phi_191_;
    if _e57 {
        phi_195_ = param_4;
    } else {
        phi_195_ = param_3;
    }
    let _e59 = phi_195_;
    return _e59;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_207_: bool;
    var phi_211_: f32;

    if (param_5 != param_5) {
        phi_207_ = true;
    } else {
        let _e55 = (param_6 <= param_5);
        if _e55 {
        }
        phi_207_ = _e55;
    }
    let _e57 = phi_207_;
    if _e57 {
        phi_211_ = param_6;
    } else {
        phi_211_ = param_5;
    }
    let _e59 = phi_211_;
    return _e59;
}

fn _lt_shaders_abi_Sample_is_valid(param_7: ptr<function, abi_Sample>) -> bool {
    var phi_1857_: bool;
    var phi_1858_: bool;
    var phi_1859_: bool;
    var phi_1860_: bool;
    var phi_1864_: bool;

    let _e55 = (*param_7).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_7).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_7).normal[2u];
            let _e67 = global[2u];
            phi_1857_ = (_e65 == _e67);
            phi_1858_ = false;
        } else {
            phi_1857_ = bool();
            phi_1858_ = true;
        }
        let _e70 = phi_1857_;
        let _e72 = phi_1858_;
        phi_1859_ = _e70;
        phi_1860_ = _e72;
    } else {
        phi_1859_ = bool();
        phi_1860_ = true;
    }
    let _e74 = phi_1859_;
    let _e76 = phi_1860_;
    if _e76 {
        phi_1864_ = false;
    } else {
        phi_1864_ = _e74;
    }
    let _e78 = phi_1864_;
    return !(_e78);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: abi_Sample;
    var phi_297_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_301_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_338_: f32;
    var phi_393_: bool;
    var phi_394_: bool;
    var phi_395_: bool;
    var phi_399_: bool;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
    var phi_403_: bool;
    var phi_404_: bool;
    var phi_405_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_411_: bool;
    var phi_412_: bool;
    var phi_413_: bool;
    var phi_414_: bool;
    var phi_415_: bool;
    var phi_416_: bool;
    var phi_420_: bool;
    var phi_424_: bool;
    var phi_494_: f32;
    var phi_501_: f32;
    var phi_508_: f32;
    var phi_515_: f32;
    var phi_522_: f32;
    var phi_529_: f32;
    var phi_546_: f32;
    var phi_551_: f32;
    var phi_556_: f32;
    var phi_584_: bool;
    var phi_585_: bool;
    var phi_593_: u32;
    var phi_594_: u32;
    var phi_605_: vec3<f32>;
    var phi_606_: vec3<f32>;
    var phi_619_: u32;
    var phi_624_: u32;
    var phi_629_: u32;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_775_: u32;
    var phi_777_: u32;
    var phi_858_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_885_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_912_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_918_: u32;
    var phi_921_: u32;
    var phi_935_: u32;
    var phi_945_: u32;
    var phi_955_: u32;
    var phi_973_: u32;
    var phi_983_: u32;
    var phi_993_: u32;
    var phi_1029_: u32;
    var phi_1042_: u32;
    var phi_1047_: u32;
    var phi_1048_: u32;
    var phi_1049_: u32;
    var phi_919_: u32;
    var phi_922_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1107_: u32;
    var phi_1152_: vec3<f32>;
    var phi_1153_: vec3<f32>;
    var phi_1182_: vec3<f32>;
    var phi_1183_: vec3<f32>;
    var phi_1212_: vec3<f32>;
    var phi_1213_: vec3<f32>;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1236_: f32;
    var phi_1237_: f32;
    var phi_1238_: f32;
    var phi_1239_: f32;
    var phi_1247_: f32;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1262_: f32;
    var phi_1263_: f32;
    var phi_1264_: f32;
    var phi_1265_: f32;
    var phi_1273_: f32;
    var phi_1283_: bool;
    var phi_1284_: bool;
    var phi_1288_: f32;
    var phi_1289_: f32;
    var phi_1290_: f32;
    var phi_1291_: f32;
    var phi_1299_: f32;
    var phi_1314_: f32;
    var phi_1315_: bool;
    var phi_1316_: f32;
    var phi_1317_: bool;
    var phi_1318_: f32;
    var phi_1319_: bool;
    var phi_1337_: f32;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1340_: f32;
    var phi_1341_: bool;
    var phi_1342_: bool;
    var phi_1346_: bool;
    var phi_1347_: f32;
    var phi_1348_: bool;
    var phi_1376_: vec3<f32>;
    var phi_1377_: vec3<f32>;
    var phi_1402_: vec3<f32>;
    var phi_1403_: vec3<f32>;
    var phi_1428_: vec3<f32>;
    var phi_1429_: vec3<f32>;
    var phi_1485_: f32;
    var phi_1494_: f32;
    var phi_1503_: f32;
    var phi_1512_: f32;
    var phi_1519_: f32;
    var phi_1526_: f32;
    var phi_1539_: f32;
    var phi_1548_: f32;
    var phi_1557_: f32;
    var phi_1566_: f32;
    var phi_1573_: f32;
    var phi_1580_: f32;
    var phi_1597_: f32;
    var phi_1602_: f32;
    var phi_1607_: f32;
    var phi_1615_: f32;
    var phi_1620_: f32;
    var phi_1625_: f32;
    var phi_1637_: f32;
    var phi_1642_: f32;
    var phi_1647_: f32;
    var phi_1652_: f32;
    var phi_1657_: lt_bvh_triangle_Intersection;
    var phi_1658_: bool;
    var phi_1659_: lt_bvh_triangle_Intersection;
    var phi_1660_: bool;
    var phi_1664_: lt_bvh_triangle_Intersection;
    var phi_1665_: bool;
    var phi_1666_: lt_bvh_triangle_Intersection;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1672_: bool;
    var phi_1676_: lt_bvh_triangle_Intersection;
    var phi_1701_: bool;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1716_: bool;
    var phi_1717_: bool;
    var phi_1108_: u32;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1720_: bool;
    var local_5: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1794_: u32;
    var phi_1795_: u32;
    var phi_1796_: bool;
    var phi_1797_: bool;
    var phi_778_: u32;
    var phi_1798_: bool;
    var phi_1799_: bool;
    var phi_1800_: bool;
    var phi_1801_: bool;
    var local_6: bool;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1810_: bool;
    var phi_1814_: bool;
    var phi_1815_: bool;
    var phi_1816_: bool;
    var phi_1817_: bool;
    var phi_1821_: bool;
    var phi_1825_: f32;
    var phi_1826_: f32;
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
        let _e90 = p.member.light;
        let _e91 = _lt_shaders_abi_Sample_is_valid((&local_1));
        if _e91 {
            let _e93 = local_1.normal;
            let _e95 = local_1.position;
            if ((((_e93.x * (_e90.x - (_e95.x * _e90.w))) + (_e93.y * (_e90.y - (_e95.y * _e90.w)))) + (_e93.z * (_e90.z - (_e95.z * _e90.w)))) > 0f) {
                let _e119 = local_1.flags;
                let _e127 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e133 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e127.unnamed.visibility, false), _e127.unnamed_1);
                phi_297_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e133.unnamed, ((_e119 & 1u) == 0u));
            } else {
                let _e142 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e148 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e142.unnamed.visibility, false), _e142.unnamed_1);
                phi_297_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e148.unnamed, true);
            }
            let _e153 = phi_297_;
            phi_301_ = _e153;
        } else {
            let _e159 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e165 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e159.unnamed.visibility, false), _e159.unnamed_1);
            phi_301_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e165.unnamed, true);
        }
        let _e170 = phi_301_;
        if _e170.unnamed_1 {
            phi_1826_ = _e170.unnamed.visibility;
        } else {
            let _e175 = p.member.light;
            let _e177 = local_1.position;
            let _e179 = local_1.normal;
            let _e181 = local_1.magnitude;
            let _e183 = ((8f / 8388608f) * _e181);
            let _e191 = (_e177.x + (_e179.x * _e183));
            let _e193 = (_e177.y + (_e179.y * _e183));
            let _e195 = (_e177.z + (_e179.z * _e183));
            if (_e175.w == 0f) {
                phi_338_ = 300000000000000000000000000000000000000f;
            } else {
                phi_338_ = 1f;
            }
            let _e199 = phi_338_;
            let _e207 = (_e175.x - (_e191 * _e175.w));
            let _e208 = (_e175.y - (_e193 * _e175.w));
            let _e209 = (_e175.z - (_e195 * _e175.w));
            let _e214 = abs(_e207);
            let _e215 = abs(_e208);
            let _e216 = abs(_e209);
            if (abs(_e191) < 1000000000000000f) {
                if (abs(_e193) < 1000000000000000f) {
                    if (abs(_e195) < 1000000000000000f) {
                        if (_e214 < 1000000000000000f) {
                            if (_e215 < 1000000000000000f) {
                                if (_e216 < 1000000000000000f) {
                                    if (_e214 > 0f) {
                                        phi_394_ = bool();
                                        phi_395_ = true;
                                    } else {
                                        let _e224 = (_e215 > 0f);
                                        if _e224 {
                                            phi_393_ = bool();
                                        } else {
                                            phi_393_ = (_e216 > 0f);
                                        }
                                        let _e227 = phi_393_;
                                        phi_394_ = _e227;
                                        phi_395_ = _e224;
                                    }
                                    let _e229 = phi_394_;
                                    let _e231 = phi_395_;
                                    if _e231 {
                                        phi_399_ = true;
                                    } else {
                                        phi_399_ = _e229;
                                    }
                                    let _e233 = phi_399_;
                                    phi_400_ = _e233;
                                    phi_401_ = false;
                                } else {
                                    phi_400_ = bool();
                                    phi_401_ = true;
                                }
                                let _e235 = phi_400_;
                                let _e237 = phi_401_;
                                phi_402_ = _e235;
                                phi_403_ = false;
                                phi_404_ = _e237;
                            } else {
                                phi_402_ = bool();
                                phi_403_ = true;
                                phi_404_ = false;
                            }
                            let _e239 = phi_402_;
                            let _e241 = phi_403_;
                            let _e243 = phi_404_;
                            phi_405_ = _e239;
                            phi_406_ = _e241;
                            phi_407_ = _e243;
                        } else {
                            phi_405_ = bool();
                            phi_406_ = true;
                            phi_407_ = false;
                        }
                        let _e245 = phi_405_;
                        let _e247 = phi_406_;
                        let _e249 = phi_407_;
                        phi_408_ = _e245;
                        phi_409_ = _e247;
                        phi_410_ = _e249;
                    } else {
                        phi_408_ = bool();
                        phi_409_ = true;
                        phi_410_ = false;
                    }
                    let _e251 = phi_408_;
                    let _e253 = phi_409_;
                    let _e255 = phi_410_;
                    phi_411_ = _e251;
                    phi_412_ = _e253;
                    phi_413_ = _e255;
                } else {
                    phi_411_ = bool();
                    phi_412_ = true;
                    phi_413_ = false;
                }
                let _e257 = phi_411_;
                let _e259 = phi_412_;
                let _e261 = phi_413_;
                phi_414_ = _e257;
                phi_415_ = _e259;
                phi_416_ = _e261;
            } else {
                phi_414_ = bool();
                phi_415_ = true;
                phi_416_ = false;
            }
            let _e263 = phi_414_;
            let _e265 = phi_415_;
            let _e267 = phi_416_;
            if _e265 {
                phi_420_ = true;
            } else {
                phi_420_ = _e267;
            }
            let _e269 = phi_420_;
            if _e269 {
                phi_424_ = false;
            } else {
                phi_424_ = _e263;
            }
            let _e271 = phi_424_;
            if _e271 {
                let _e272 = (0u >= _e61);
                if _e272 {
                    phi_1815_ = bool();
                } else {
                    if (0u < _e61) {
                    } else {
                        return;
                    }
                    let _e278 = nodes.member[(0u + 0u)].frame[0u];
                    let _e282 = nodes.member[(0u + 0u)].frame[1u];
                    let _e286 = nodes.member[(0u + 0u)].frame[2u];
                    let _e290 = nodes.member[(0u + 0u)].frame[0u];
                    let _e294 = nodes.member[(0u + 0u)].frame[1u];
                    let _e298 = nodes.member[(0u + 0u)].frame[2u];
                    let _e302 = nodes.member[(0u + 0u)].frame[3u];
                    let _e336 = core_intrinsics_maximum_number_nsz_f32_(abs(_e207), abs(_e208));
                    let _e337 = core_intrinsics_maximum_number_nsz_f32_(_e336, abs(_e209));
                    let _e338 = (_e337 * 0.0000000000009094947f);
                    if (abs(_e207) < _e338) {
                        phi_494_ = _e338;
                    } else {
                        phi_494_ = abs(_e207);
                    }
                    let _e343 = phi_494_;
                    if (_e207 < 0f) {
                        phi_501_ = (-1f / _e343);
                    } else {
                        phi_501_ = (1f / _e343);
                    }
                    let _e348 = phi_501_;
                    if (abs(_e208) < _e338) {
                        phi_508_ = _e338;
                    } else {
                        phi_508_ = abs(_e208);
                    }
                    let _e353 = phi_508_;
                    if (_e208 < 0f) {
                        phi_515_ = (-1f / _e353);
                    } else {
                        phi_515_ = (1f / _e353);
                    }
                    let _e358 = phi_515_;
                    if (abs(_e209) < _e338) {
                        phi_522_ = _e338;
                    } else {
                        phi_522_ = abs(_e209);
                    }
                    let _e363 = phi_522_;
                    if (_e209 < 0f) {
                        phi_529_ = (-1f / _e363);
                    } else {
                        phi_529_ = (1f / _e363);
                    }
                    let _e368 = phi_529_;
                    let _e372 = abs((bitcast<f32>(_e278) - _e191));
                    let _e373 = abs((bitcast<f32>(_e282) - _e193));
                    let _e374 = abs((bitcast<f32>(_e286) - _e195));
                    let _e378 = abs(((bitcast<f32>(_e290) + (bitcast<f32>((((_e302 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e191));
                    let _e379 = abs(((bitcast<f32>(_e294) + (bitcast<f32>((((_e302 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e193));
                    let _e380 = abs(((bitcast<f32>(_e298) + (bitcast<f32>((((_e302 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e195));
                    if (_e372 > _e378) {
                        phi_546_ = _e372;
                    } else {
                        phi_546_ = _e378;
                    }
                    let _e383 = phi_546_;
                    if (_e373 > _e379) {
                        phi_551_ = _e373;
                    } else {
                        phi_551_ = _e379;
                    }
                    let _e386 = phi_551_;
                    if (_e374 > _e380) {
                        phi_556_ = _e374;
                    } else {
                        phi_556_ = _e380;
                    }
                    let _e389 = phi_556_;
                    let _e390 = core_intrinsics_maximum_number_nsz_f32_(_e383, _e386);
                    let _e391 = core_intrinsics_maximum_number_nsz_f32_(_e390, _e389);
                    let _e395 = (_e391 * 0.0000019073486f);
                    let _e396 = (abs(_e348) * _e395);
                    let _e397 = (abs(_e358) * _e395);
                    let _e398 = (abs(_e368) * _e395);
                    let _e402 = (_e391 * 0.0000009536743f);
                    let _e403 = (abs(_e348) * _e402);
                    let _e404 = (abs(_e358) * _e402);
                    let _e405 = (abs(_e368) * _e402);
                    let _e406 = abs(_e207);
                    let _e407 = abs(_e208);
                    let _e408 = abs(_e209);
                    if (_e406 >= _e407) {
                        if (_e406 >= _e408) {
                            phi_584_ = false;
                        } else {
                            phi_584_ = true;
                        }
                        let _e412 = phi_584_;
                        phi_585_ = _e412;
                    } else {
                        phi_585_ = true;
                    }
                    let _e414 = phi_585_;
                    if _e414 {
                        if (_e407 >= _e408) {
                            phi_593_ = 1u;
                        } else {
                            phi_593_ = 2u;
                        }
                        let _e417 = phi_593_;
                        phi_594_ = _e417;
                    } else {
                        phi_594_ = 0u;
                    }
                    let _e419 = phi_594_;
                    if (_e419 == 0u) {
                        phi_606_ = vec3<f32>(_e208, _e209, _e207);
                    } else {
                        if (_e419 == 1u) {
                            phi_605_ = vec3<f32>(_e209, _e207, _e208);
                        } else {
                            phi_605_ = vec3<f32>(_e207, _e208, _e209);
                        }
                        let _e425 = phi_605_;
                        phi_606_ = _e425;
                    }
                    let _e427 = phi_606_;
                    let _e430 = (_e427.x / _e427.z);
                    let _e433 = (_e427.y / _e427.z);
                    if (_e348 < 0f) {
                        phi_619_ = 0u;
                    } else {
                        phi_619_ = 1u;
                    }
                    let _e438 = phi_619_;
                    if (_e358 < 0f) {
                        phi_624_ = 0u;
                    } else {
                        phi_624_ = 2u;
                    }
                    let _e441 = phi_624_;
                    if (_e368 < 0f) {
                        phi_629_ = 0u;
                    } else {
                        phi_629_ = 4u;
                    }
                    let _e444 = phi_629_;
                    let _e446 = ((_e438 | _e441) | _e444);
                    let _e447 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e447.first[0], _e447.first[1], _e447.first[2], _e447.first[3], _e447.first[4], _e447.first[5], _e447.first[6], _e447.first[7], _e447.first[8], _e447.first[9], _e447.first[10], _e447.first[11], _e447.first[12], _e447.first[13], _e447.first[14], _e447.first[15], _e447.first[16], _e447.first[17], _e447.first[18], _e447.first[19], _e447.first[20], _e447.first[21], _e447.first[22], _e447.first[23], _e447.first[24], _e447.first[25], _e447.first[26], _e447.first[27], _e447.first[28], _e447.first[29], _e447.first[30], _e447.first[31]), array<u32, 32>(_e447.mask[0], _e447.mask[1], _e447.mask[2], _e447.mask[3], _e447.mask[4], _e447.mask[5], _e447.mask[6], _e447.mask[7], _e447.mask[8], _e447.mask[9], _e447.mask[10], _e447.mask[11], _e447.mask[12], _e447.mask[13], _e447.mask[14], _e447.mask[15], _e447.mask[16], _e447.mask[17], _e447.mask[18], _e447.mask[19], _e447.mask[20], _e447.mask[21], _e447.mask[22], _e447.mask[23], _e447.mask[24], _e447.mask[25], _e447.mask[26], _e447.mask[27], _e447.mask[28], _e447.mask[29], _e447.mask[30], _e447.mask[31]), _e447.len, _e447.group, _e447.group_mask);
                    let _e521 = local.group_mask;
                    if ((_e521 & 4278190080u) == 0u) {
                        let _e525 = local.len;
                        if (_e525 == 0u) {
                            phi_743_ = false;
                        } else {
                            let _e529 = local.len;
                            local.len = (_e529 - 1u);
                            let _e532 = local.len;
                            if (_e532 < 32u) {
                            } else {
                                return;
                            }
                            let _e537 = local.first[(0u + _e532)];
                            local.group = _e537;
                            let _e540 = local.len;
                            if (_e540 < 32u) {
                            } else {
                                return;
                            }
                            let _e545 = local.mask[(0u + _e540)];
                            local.group_mask = _e545;
                            phi_743_ = true;
                        }
                        let _e548 = phi_743_;
                        phi_744_ = _e548;
                    } else {
                        phi_744_ = true;
                    }
                    let _e550 = phi_744_;
                    if _e550 {
                        let _e552 = local.group_mask;
                        let _e558 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e552)), 32u, (_e552 == 0u)));
                        let _e562 = local.group_mask;
                        let _e576 = local.group_mask;
                        local.group_mask = (_e576 & ~((1u << bitcast<u32>((_e558 & 31u)))));
                        let _e579 = local.group;
                        phi_775_ = (_e579 + countOneBits(((_e562 & ~((4294967295u << bitcast<u32>((((_e558 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_775_ = 4294967295u;
                    }
                    let _e582 = phi_775_;
                    phi_777_ = _e582;
                    loop {
                        let _e584 = phi_777_;
                        if (_e584 != 4294967295u) {
                            if (_e584 < _e61) {
                            } else {
                                return;
                            }
                            let _e591 = nodes.member[(0u + _e584)].frame[3u];
                            let _e616 = (bitcast<f32>((((_e591 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e348);
                            let _e617 = (bitcast<f32>((((_e591 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e358);
                            let _e618 = (bitcast<f32>((((_e591 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e368);
                            let _e621 = nodes.member[(0u + _e584)].frame[0u];
                            let _e625 = nodes.member[(0u + _e584)].frame[1u];
                            let _e629 = nodes.member[(0u + _e584)].frame[2u];
                            let _e634 = ((bitcast<f32>(_e621) - _e191) * _e348);
                            let _e635 = ((bitcast<f32>(_e625) - _e193) * _e358);
                            let _e636 = ((bitcast<f32>(_e629) - _e195) * _e368);
                            let _e644 = nodes.member[(0u + _e584)].x;
                            if (_e348 < 0f) {
                                let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e644.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e655.unnamed.root, _e644.w), _e655.unnamed_1);
                                let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_bvh_traverse_Tree(_e644.x, _e661.unnamed_1.first_primitive));
                                phi_858_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e667.unnamed, lt_bvh_traverse_Tree(_e667.unnamed_1.root, _e644.y));
                            } else {
                                let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e644.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e683.unnamed.root, _e644.y), _e683.unnamed_1);
                                let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_bvh_traverse_Tree(_e644.z, _e689.unnamed_1.first_primitive));
                                phi_858_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e695.unnamed, lt_bvh_traverse_Tree(_e695.unnamed_1.root, _e644.w));
                            }
                            let _e703 = phi_858_;
                            let _e713 = nodes.member[(0u + _e584)].y;
                            if (_e358 < 0f) {
                                let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e713.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e724.unnamed.root, _e713.w), _e724.unnamed_1);
                                let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_bvh_traverse_Tree(_e713.x, _e730.unnamed_1.first_primitive));
                                phi_885_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_bvh_traverse_Tree(_e736.unnamed_1.root, _e713.y));
                            } else {
                                let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e713.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e752.unnamed.root, _e713.y), _e752.unnamed_1);
                                let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_bvh_traverse_Tree(_e713.z, _e758.unnamed_1.first_primitive));
                                phi_885_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e764.unnamed, lt_bvh_traverse_Tree(_e764.unnamed_1.root, _e713.w));
                            }
                            let _e772 = phi_885_;
                            let _e782 = nodes.member[(0u + _e584)].z;
                            if (_e368 < 0f) {
                                let _e793 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e782.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e799 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e793.unnamed.root, _e782.w), _e793.unnamed_1);
                                let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e799.unnamed, lt_bvh_traverse_Tree(_e782.x, _e799.unnamed_1.first_primitive));
                                phi_912_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e805.unnamed, lt_bvh_traverse_Tree(_e805.unnamed_1.root, _e782.y));
                            } else {
                                let _e821 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e782.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e827 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e821.unnamed.root, _e782.y), _e821.unnamed_1);
                                let _e833 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e827.unnamed, lt_bvh_traverse_Tree(_e782.z, _e827.unnamed_1.first_primitive));
                                phi_912_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e833.unnamed, lt_bvh_traverse_Tree(_e833.unnamed_1.root, _e782.w));
                            }
                            let _e841 = phi_912_;
                            phi_918_ = 0u;
                            phi_921_ = 0u;
                            loop {
                                let _e851 = phi_918_;
                                let _e853 = phi_921_;
                                local_2 = _e853;
                                local_3 = _e853;
                                local_4 = _e853;
                                let _e854 = (_e851 < 8u);
                                if _e854 {
                                    let _e856 = (_e851 >> bitcast<u32>(2i));
                                    let _e857 = (_e851 & 3u);
                                    if (_e856 == 0u) {
                                        phi_935_ = _e703.unnamed.root;
                                    } else {
                                        phi_935_ = _e703.unnamed.first_primitive;
                                    }
                                    let _e860 = phi_935_;
                                    if (_e856 == 0u) {
                                        phi_945_ = _e772.unnamed.root;
                                    } else {
                                        phi_945_ = _e772.unnamed.first_primitive;
                                    }
                                    let _e869 = phi_945_;
                                    if (_e856 == 0u) {
                                        phi_955_ = _e841.unnamed.root;
                                    } else {
                                        phi_955_ = _e841.unnamed.first_primitive;
                                    }
                                    let _e878 = phi_955_;
                                    let _e891 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e860 >> bitcast<u32>(((_e857 * 8u) & 31u))) & 255u)) * _e616) + (_e634 - _e396)), ((f32(((_e869 >> bitcast<u32>(((_e857 * 8u) & 31u))) & 255u)) * _e617) + (_e635 - _e397)));
                                    let _e892 = core_intrinsics_maximum_number_nsz_f32_(_e891, ((f32(((_e878 >> bitcast<u32>(((_e857 * 8u) & 31u))) & 255u)) * _e618) + (_e636 - _e398)));
                                    if (_e856 == 0u) {
                                        phi_973_ = _e703.unnamed_1.root;
                                    } else {
                                        phi_973_ = _e703.unnamed_1.first_primitive;
                                    }
                                    let _e895 = phi_973_;
                                    if (_e856 == 0u) {
                                        phi_983_ = _e772.unnamed_1.root;
                                    } else {
                                        phi_983_ = _e772.unnamed_1.first_primitive;
                                    }
                                    let _e904 = phi_983_;
                                    if (_e856 == 0u) {
                                        phi_993_ = _e841.unnamed_1.root;
                                    } else {
                                        phi_993_ = _e841.unnamed_1.first_primitive;
                                    }
                                    let _e913 = phi_993_;
                                    let _e926 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e895 >> bitcast<u32>(((_e857 * 8u) & 31u))) & 255u)) * _e616) + (_e634 + _e396)), ((f32(((_e904 >> bitcast<u32>(((_e857 * 8u) & 31u))) & 255u)) * _e617) + (_e635 + _e397)));
                                    let _e927 = core_intrinsics_minimum_number_nsz_f32_(_e926, ((f32(((_e913 >> bitcast<u32>(((_e857 * 8u) & 31u))) & 255u)) * _e618) + (_e636 + _e398)));
                                    if (_e892 <= _e927) {
                                        if (_e892 <= _e199) {
                                            if (_e927 >= 0f) {
                                                if (_e856 == 0u) {
                                                    let _e934 = nodes.member[(0u + _e584)].links[2u];
                                                    phi_1029_ = _e934;
                                                } else {
                                                    let _e937 = nodes.member[(0u + _e584)].links[3u];
                                                    phi_1029_ = _e937;
                                                }
                                                let _e939 = phi_1029_;
                                                let _e944 = ((_e939 >> bitcast<u32>(((_e857 * 8u) & 31u))) & 255u);
                                                let _e945 = (_e944 & 31u);
                                                if (_e945 >= 24u) {
                                                    phi_1042_ = (24u + ((_e945 - 24u) ^ _e446));
                                                } else {
                                                    phi_1042_ = _e945;
                                                }
                                                let _e951 = phi_1042_;
                                                phi_1047_ = (_e853 | ((_e944 >> bitcast<u32>(5i)) << bitcast<u32>((_e951 & 31u))));
                                            } else {
                                                phi_1047_ = _e853;
                                            }
                                            let _e959 = phi_1047_;
                                            phi_1048_ = _e959;
                                        } else {
                                            phi_1048_ = _e853;
                                        }
                                        let _e961 = phi_1048_;
                                        phi_1049_ = _e961;
                                    } else {
                                        phi_1049_ = _e853;
                                    }
                                    let _e963 = phi_1049_;
                                    phi_919_ = (_e851 + 1u);
                                    phi_922_ = _e963;
                                } else {
                                    phi_919_ = u32();
                                    phi_922_ = u32();
                                }
                                let _e966 = phi_919_;
                                let _e968 = phi_922_;
                                continue;
                                continuing {
                                    phi_918_ = _e966;
                                    phi_921_ = _e968;
                                    break if !(_e854);
                                }
                            }
                            let _e972 = nodes.member[(0u + _e584)].links[0u];
                            let _e976 = nodes.member[(0u + _e584)].frame[3u];
                            let _e980 = local_2;
                            if ((_e980 & 4278190080u) == 0u) {
                            } else {
                                let _e984 = local.group_mask;
                                if ((_e984 & 4278190080u) == 0u) {
                                } else {
                                    let _e988 = local.len;
                                    if (_e988 < 32u) {
                                        let _e991 = local.group;
                                        let _e993 = local.len;
                                        if (_e993 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.first[(0u + _e993)] = _e991;
                                        let _e999 = local.group_mask;
                                        let _e1001 = local.len;
                                        if (_e1001 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.mask[(0u + _e1001)] = _e999;
                                        let _e1008 = local.len;
                                        local.len = (_e1008 + 1u);
                                    }
                                }
                                local.group = (0u + _e972);
                                let _e1012 = local_3;
                                local.group_mask = ((_e1012 & 4278190080u) | (_e976 >> bitcast<u32>(24i)));
                            }
                            let _e1017 = local_4;
                            phi_1107_ = (_e1017 & 16777215u);
                            loop {
                                let _e1020 = phi_1107_;
                                let _e1021 = (_e1020 == 0u);
                                local_5 = _e1021;
                                local_9 = _e1021;
                                if _e1021 {
                                    phi_1108_ = u32();
                                    phi_1718_ = false;
                                    phi_1719_ = false;
                                    phi_1720_ = false;
                                } else {
                                    let _e1024 = nodes.member[(0u + _e584)].links[1u];
                                    let _e1029 = ((0u + _e1024) + select(firstTrailingBit(_e1020), 32u, (_e1020 == 0u)));
                                    if (_e1029 < arrayLength((&triangles.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1036 = triangles.member[(0u + _e1029)].v0_;
                                    let _e1038 = (_e1036.x - _e191);
                                    let _e1040 = (_e1036.y - _e193);
                                    let _e1042 = (_e1036.z - _e195);
                                    if (_e419 == 0u) {
                                        phi_1153_ = vec3<f32>(_e1040, _e1042, _e1038);
                                    } else {
                                        if (_e419 == 1u) {
                                            phi_1152_ = vec3<f32>(_e1042, _e1038, _e1040);
                                        } else {
                                            phi_1152_ = (_e1036 - vec3<f32>(_e191, _e193, _e195));
                                        }
                                        let _e1050 = phi_1152_;
                                        phi_1153_ = _e1050;
                                    }
                                    let _e1052 = phi_1153_;
                                    let _e1056 = (_e1052.x - (_e430 * _e1052.z));
                                    let _e1060 = (_e1052.y - (_e433 * _e1052.z));
                                    let _e1062 = triangles.member[(0u + _e1029)].v1_;
                                    let _e1064 = (_e1062.x - _e191);
                                    let _e1066 = (_e1062.y - _e193);
                                    let _e1068 = (_e1062.z - _e195);
                                    if (_e419 == 0u) {
                                        phi_1183_ = vec3<f32>(_e1066, _e1068, _e1064);
                                    } else {
                                        if (_e419 == 1u) {
                                            phi_1182_ = vec3<f32>(_e1068, _e1064, _e1066);
                                        } else {
                                            phi_1182_ = (_e1062 - vec3<f32>(_e191, _e193, _e195));
                                        }
                                        let _e1076 = phi_1182_;
                                        phi_1183_ = _e1076;
                                    }
                                    let _e1078 = phi_1183_;
                                    let _e1082 = (_e1078.x - (_e430 * _e1078.z));
                                    let _e1086 = (_e1078.y - (_e433 * _e1078.z));
                                    let _e1088 = triangles.member[(0u + _e1029)].v2_;
                                    let _e1090 = (_e1088.x - _e191);
                                    let _e1092 = (_e1088.y - _e193);
                                    let _e1094 = (_e1088.z - _e195);
                                    if (_e419 == 0u) {
                                        phi_1213_ = vec3<f32>(_e1092, _e1094, _e1090);
                                    } else {
                                        if (_e419 == 1u) {
                                            phi_1212_ = vec3<f32>(_e1094, _e1090, _e1092);
                                        } else {
                                            phi_1212_ = (_e1088 - vec3<f32>(_e191, _e193, _e195));
                                        }
                                        let _e1102 = phi_1212_;
                                        phi_1213_ = _e1102;
                                    }
                                    let _e1104 = phi_1213_;
                                    let _e1108 = (_e1104.x - (_e430 * _e1104.z));
                                    let _e1112 = (_e1104.y - (_e433 * _e1104.z));
                                    if (_e1082 < _e1108) {
                                        phi_1232_ = true;
                                    } else {
                                        if (_e1082 == _e1108) {
                                            phi_1231_ = (_e1086 < _e1112);
                                        } else {
                                            phi_1231_ = false;
                                        }
                                        let _e1117 = phi_1231_;
                                        phi_1232_ = _e1117;
                                    }
                                    let _e1119 = phi_1232_;
                                    if _e1119 {
                                        phi_1236_ = _e1112;
                                        phi_1237_ = _e1108;
                                        phi_1238_ = _e1086;
                                        phi_1239_ = _e1082;
                                    } else {
                                        phi_1236_ = _e1086;
                                        phi_1237_ = _e1082;
                                        phi_1238_ = _e1112;
                                        phi_1239_ = _e1108;
                                    }
                                    let _e1121 = phi_1236_;
                                    let _e1123 = phi_1237_;
                                    let _e1125 = phi_1238_;
                                    let _e1127 = phi_1239_;
                                    let _e1130 = ((_e1127 * _e1121) - (_e1125 * _e1123));
                                    if _e1119 {
                                        phi_1247_ = -(_e1130);
                                    } else {
                                        phi_1247_ = _e1130;
                                    }
                                    let _e1133 = phi_1247_;
                                    if (_e1108 < _e1056) {
                                        phi_1258_ = true;
                                    } else {
                                        if (_e1108 == _e1056) {
                                            phi_1257_ = (_e1112 < _e1060);
                                        } else {
                                            phi_1257_ = false;
                                        }
                                        let _e1138 = phi_1257_;
                                        phi_1258_ = _e1138;
                                    }
                                    let _e1140 = phi_1258_;
                                    if _e1140 {
                                        phi_1262_ = _e1060;
                                        phi_1263_ = _e1056;
                                        phi_1264_ = _e1112;
                                        phi_1265_ = _e1108;
                                    } else {
                                        phi_1262_ = _e1112;
                                        phi_1263_ = _e1108;
                                        phi_1264_ = _e1060;
                                        phi_1265_ = _e1056;
                                    }
                                    let _e1142 = phi_1262_;
                                    let _e1144 = phi_1263_;
                                    let _e1146 = phi_1264_;
                                    let _e1148 = phi_1265_;
                                    let _e1151 = ((_e1148 * _e1142) - (_e1146 * _e1144));
                                    if _e1140 {
                                        phi_1273_ = -(_e1151);
                                    } else {
                                        phi_1273_ = _e1151;
                                    }
                                    let _e1154 = phi_1273_;
                                    if (_e1056 < _e1082) {
                                        phi_1284_ = true;
                                    } else {
                                        if (_e1056 == _e1082) {
                                            phi_1283_ = (_e1060 < _e1086);
                                        } else {
                                            phi_1283_ = false;
                                        }
                                        let _e1159 = phi_1283_;
                                        phi_1284_ = _e1159;
                                    }
                                    let _e1161 = phi_1284_;
                                    if _e1161 {
                                        phi_1288_ = _e1086;
                                        phi_1289_ = _e1082;
                                        phi_1290_ = _e1060;
                                        phi_1291_ = _e1056;
                                    } else {
                                        phi_1288_ = _e1060;
                                        phi_1289_ = _e1056;
                                        phi_1290_ = _e1086;
                                        phi_1291_ = _e1082;
                                    }
                                    let _e1163 = phi_1288_;
                                    let _e1165 = phi_1289_;
                                    let _e1167 = phi_1290_;
                                    let _e1169 = phi_1291_;
                                    let _e1172 = ((_e1169 * _e1163) - (_e1167 * _e1165));
                                    if _e1161 {
                                        phi_1299_ = -(_e1172);
                                    } else {
                                        phi_1299_ = _e1172;
                                    }
                                    let _e1175 = phi_1299_;
                                    if (_e1133 >= 0f) {
                                        if (_e1154 >= 0f) {
                                            if (_e1175 >= 0f) {
                                                phi_1314_ = ((_e1133 + _e1154) + _e1175);
                                                phi_1315_ = false;
                                            } else {
                                                phi_1314_ = f32();
                                                phi_1315_ = true;
                                            }
                                            let _e1182 = phi_1314_;
                                            let _e1184 = phi_1315_;
                                            phi_1316_ = _e1182;
                                            phi_1317_ = _e1184;
                                        } else {
                                            phi_1316_ = f32();
                                            phi_1317_ = true;
                                        }
                                        let _e1186 = phi_1316_;
                                        let _e1188 = phi_1317_;
                                        phi_1318_ = _e1186;
                                        phi_1319_ = _e1188;
                                    } else {
                                        phi_1318_ = f32();
                                        phi_1319_ = true;
                                    }
                                    let _e1190 = phi_1318_;
                                    let _e1192 = phi_1319_;
                                    if _e1192 {
                                        if (_e1133 <= 0f) {
                                            if (_e1154 <= 0f) {
                                                let _e1195 = (_e1175 <= 0f);
                                                if _e1195 {
                                                }
                                                phi_1337_ = ((_e1133 + _e1154) + _e1175);
                                                phi_1338_ = false;
                                                phi_1339_ = _e1195;
                                            } else {
                                                phi_1337_ = f32();
                                                phi_1338_ = true;
                                                phi_1339_ = false;
                                            }
                                            let _e1199 = phi_1337_;
                                            let _e1201 = phi_1338_;
                                            let _e1203 = phi_1339_;
                                            phi_1340_ = _e1199;
                                            phi_1341_ = _e1201;
                                            phi_1342_ = _e1203;
                                        } else {
                                            phi_1340_ = f32();
                                            phi_1341_ = true;
                                            phi_1342_ = false;
                                        }
                                        let _e1205 = phi_1340_;
                                        let _e1207 = phi_1341_;
                                        let _e1209 = phi_1342_;
                                        if _e1207 {
                                            phi_1346_ = false;
                                        } else {
                                            phi_1346_ = _e1209;
                                        }
                                        let _e1211 = phi_1346_;
                                        phi_1347_ = _e1205;
                                        phi_1348_ = _e1211;
                                    } else {
                                        phi_1347_ = _e1190;
                                        phi_1348_ = true;
                                    }
                                    let _e1213 = phi_1347_;
                                    let _e1215 = phi_1348_;
                                    if _e1215 {
                                        let _e1216 = (_e1213 == 0f);
                                        if _e1216 {
                                            phi_1664_ = lt_bvh_triangle_Intersection();
                                            phi_1665_ = false;
                                        } else {
                                            let _e1218 = triangles.member[(0u + _e1029)].v0_;
                                            let _e1220 = (_e1218.x - _e191);
                                            let _e1222 = (_e1218.y - _e193);
                                            let _e1224 = (_e1218.z - _e195);
                                            if (_e419 == 0u) {
                                                phi_1377_ = vec3<f32>(_e1222, _e1224, _e1220);
                                            } else {
                                                if (_e419 == 1u) {
                                                    phi_1376_ = vec3<f32>(_e1224, _e1220, _e1222);
                                                } else {
                                                    phi_1376_ = (_e1218 - vec3<f32>(_e191, _e193, _e195));
                                                }
                                                let _e1232 = phi_1376_;
                                                phi_1377_ = _e1232;
                                            }
                                            let _e1234 = phi_1377_;
                                            let _e1236 = triangles.member[(0u + _e1029)].v1_;
                                            let _e1238 = triangles.member[(0u + _e1029)].v0_;
                                            let _e1241 = (_e1236.x - _e1238.x);
                                            let _e1244 = (_e1236.y - _e1238.y);
                                            let _e1247 = (_e1236.z - _e1238.z);
                                            if (_e419 == 0u) {
                                                phi_1403_ = vec3<f32>(_e1244, _e1247, _e1241);
                                            } else {
                                                if (_e419 == 1u) {
                                                    phi_1402_ = vec3<f32>(_e1247, _e1241, _e1244);
                                                } else {
                                                    phi_1402_ = (_e1236 - _e1238);
                                                }
                                                let _e1254 = phi_1402_;
                                                phi_1403_ = _e1254;
                                            }
                                            let _e1256 = phi_1403_;
                                            let _e1258 = triangles.member[(0u + _e1029)].v2_;
                                            let _e1260 = triangles.member[(0u + _e1029)].v0_;
                                            let _e1263 = (_e1258.x - _e1260.x);
                                            let _e1266 = (_e1258.y - _e1260.y);
                                            let _e1269 = (_e1258.z - _e1260.z);
                                            if (_e419 == 0u) {
                                                phi_1429_ = vec3<f32>(_e1266, _e1269, _e1263);
                                            } else {
                                                if (_e419 == 1u) {
                                                    phi_1428_ = vec3<f32>(_e1269, _e1263, _e1266);
                                                } else {
                                                    phi_1428_ = (_e1258 - _e1260);
                                                }
                                                let _e1276 = phi_1428_;
                                                phi_1429_ = _e1276;
                                            }
                                            let _e1278 = phi_1429_;
                                            let _e1285 = ((_e1256.y * _e1278.z) - (_e1256.z * _e1278.y));
                                            let _e1292 = ((_e1256.z * _e1278.x) - (_e1256.x * _e1278.z));
                                            let _e1299 = ((_e1256.x * _e1278.y) - (_e1256.y * _e1278.x));
                                            let _e1313 = (((1f / _e427.z) * (((_e1285 * _e1234.x) + (_e1292 * _e1234.y)) + (_e1299 * _e1234.z))) / (((_e1285 * _e430) + (_e1292 * _e433)) + _e1299));
                                            if (_e1313 > 0f) {
                                                if (_e1313 < _e199) {
                                                    let _e1317 = triangles.member[(0u + _e1029)].v0_;
                                                    let _e1319 = triangles.member[(0u + _e1029)].v1_;
                                                    if (_e1317.x < _e1319.x) {
                                                        phi_1485_ = _e1317.x;
                                                    } else {
                                                        phi_1485_ = _e1319.x;
                                                    }
                                                    let _e1326 = phi_1485_;
                                                    if (_e1317.y < _e1319.y) {
                                                        phi_1494_ = _e1317.y;
                                                    } else {
                                                        phi_1494_ = _e1319.y;
                                                    }
                                                    let _e1333 = phi_1494_;
                                                    if (_e1317.z < _e1319.z) {
                                                        phi_1503_ = _e1317.z;
                                                    } else {
                                                        phi_1503_ = _e1319.z;
                                                    }
                                                    let _e1340 = phi_1503_;
                                                    let _e1342 = triangles.member[(0u + _e1029)].v2_;
                                                    if (_e1326 < _e1342.x) {
                                                        phi_1512_ = _e1326;
                                                    } else {
                                                        phi_1512_ = _e1342.x;
                                                    }
                                                    let _e1347 = phi_1512_;
                                                    if (_e1333 < _e1342.y) {
                                                        phi_1519_ = _e1333;
                                                    } else {
                                                        phi_1519_ = _e1342.y;
                                                    }
                                                    let _e1352 = phi_1519_;
                                                    if (_e1340 < _e1342.z) {
                                                        phi_1526_ = _e1340;
                                                    } else {
                                                        phi_1526_ = _e1342.z;
                                                    }
                                                    let _e1357 = phi_1526_;
                                                    let _e1359 = triangles.member[(0u + _e1029)].v0_;
                                                    let _e1361 = triangles.member[(0u + _e1029)].v1_;
                                                    if (_e1359.x > _e1361.x) {
                                                        phi_1539_ = _e1359.x;
                                                    } else {
                                                        phi_1539_ = _e1361.x;
                                                    }
                                                    let _e1368 = phi_1539_;
                                                    if (_e1359.y > _e1361.y) {
                                                        phi_1548_ = _e1359.y;
                                                    } else {
                                                        phi_1548_ = _e1361.y;
                                                    }
                                                    let _e1375 = phi_1548_;
                                                    if (_e1359.z > _e1361.z) {
                                                        phi_1557_ = _e1359.z;
                                                    } else {
                                                        phi_1557_ = _e1361.z;
                                                    }
                                                    let _e1382 = phi_1557_;
                                                    let _e1384 = triangles.member[(0u + _e1029)].v2_;
                                                    if (_e1368 > _e1384.x) {
                                                        phi_1566_ = _e1368;
                                                    } else {
                                                        phi_1566_ = _e1384.x;
                                                    }
                                                    let _e1389 = phi_1566_;
                                                    if (_e1375 > _e1384.y) {
                                                        phi_1573_ = _e1375;
                                                    } else {
                                                        phi_1573_ = _e1384.y;
                                                    }
                                                    let _e1394 = phi_1573_;
                                                    if (_e1382 > _e1384.z) {
                                                        phi_1580_ = _e1382;
                                                    } else {
                                                        phi_1580_ = _e1384.z;
                                                    }
                                                    let _e1399 = phi_1580_;
                                                    let _e1403 = ((_e1347 - _e191) * _e348);
                                                    let _e1404 = ((_e1352 - _e193) * _e358);
                                                    let _e1405 = ((_e1357 - _e195) * _e368);
                                                    let _e1409 = ((_e1389 - _e191) * _e348);
                                                    let _e1410 = ((_e1394 - _e193) * _e358);
                                                    let _e1411 = ((_e1399 - _e195) * _e368);
                                                    if (_e1403 < _e1409) {
                                                        phi_1597_ = _e1403;
                                                    } else {
                                                        phi_1597_ = _e1409;
                                                    }
                                                    let _e1414 = phi_1597_;
                                                    if (_e1404 < _e1410) {
                                                        phi_1602_ = _e1404;
                                                    } else {
                                                        phi_1602_ = _e1410;
                                                    }
                                                    let _e1417 = phi_1602_;
                                                    if (_e1405 < _e1411) {
                                                        phi_1607_ = _e1405;
                                                    } else {
                                                        phi_1607_ = _e1411;
                                                    }
                                                    let _e1420 = phi_1607_;
                                                    if (_e1403 > _e1409) {
                                                        phi_1615_ = _e1403;
                                                    } else {
                                                        phi_1615_ = _e1409;
                                                    }
                                                    let _e1426 = phi_1615_;
                                                    if (_e1404 > _e1410) {
                                                        phi_1620_ = _e1404;
                                                    } else {
                                                        phi_1620_ = _e1410;
                                                    }
                                                    let _e1429 = phi_1620_;
                                                    if (_e1405 > _e1411) {
                                                        phi_1625_ = _e1405;
                                                    } else {
                                                        phi_1625_ = _e1411;
                                                    }
                                                    let _e1432 = phi_1625_;
                                                    let _e1436 = core_intrinsics_maximum_number_nsz_f32_((_e1414 - _e403), (_e1417 - _e404));
                                                    let _e1437 = core_intrinsics_maximum_number_nsz_f32_(_e1436, (_e1420 - _e405));
                                                    let _e1438 = core_intrinsics_minimum_number_nsz_f32_((_e1426 + _e403), (_e1429 + _e404));
                                                    let _e1439 = core_intrinsics_minimum_number_nsz_f32_(_e1438, (_e1432 + _e405));
                                                    if (_e1437 > -300000000000000000000000000000000000000f) {
                                                        phi_1637_ = _e1437;
                                                    } else {
                                                        phi_1637_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1442 = phi_1637_;
                                                    if (_e1439 < 300000000000000000000000000000000000000f) {
                                                        phi_1642_ = _e1439;
                                                    } else {
                                                        phi_1642_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1445 = phi_1642_;
                                                    if (_e1313 < _e1442) {
                                                        phi_1647_ = _e1442;
                                                    } else {
                                                        phi_1647_ = _e1313;
                                                    }
                                                    let _e1448 = phi_1647_;
                                                    if (_e1448 > _e1445) {
                                                        phi_1652_ = _e1445;
                                                    } else {
                                                        phi_1652_ = _e1448;
                                                    }
                                                    let _e1451 = phi_1652_;
                                                    phi_1657_ = lt_bvh_triangle_Intersection(_e1451, (_e1154 / _e1213), (_e1175 / _e1213), (_e1442 <= _e1445));
                                                    phi_1658_ = false;
                                                } else {
                                                    phi_1657_ = lt_bvh_triangle_Intersection();
                                                    phi_1658_ = true;
                                                }
                                                let _e1457 = phi_1657_;
                                                let _e1459 = phi_1658_;
                                                phi_1659_ = _e1457;
                                                phi_1660_ = _e1459;
                                            } else {
                                                phi_1659_ = lt_bvh_triangle_Intersection();
                                                phi_1660_ = true;
                                            }
                                            let _e1461 = phi_1659_;
                                            let _e1463 = phi_1660_;
                                            if _e1463 {
                                            }
                                            phi_1664_ = _e1461;
                                            phi_1665_ = _e1463;
                                        }
                                        let _e1465 = phi_1664_;
                                        let _e1467 = phi_1665_;
                                        phi_1666_ = _e1465;
                                        phi_1667_ = _e1216;
                                        phi_1668_ = _e1467;
                                    } else {
                                        phi_1666_ = lt_bvh_triangle_Intersection();
                                        phi_1667_ = true;
                                        phi_1668_ = false;
                                    }
                                    let _e1469 = phi_1666_;
                                    let _e1471 = phi_1667_;
                                    let _e1473 = phi_1668_;
                                    if _e1471 {
                                        phi_1672_ = true;
                                    } else {
                                        phi_1672_ = _e1473;
                                    }
                                    let _e1475 = phi_1672_;
                                    if _e1475 {
                                        phi_1676_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1676_ = _e1469;
                                    }
                                    let _e1477 = phi_1676_;
                                    if _e1477.is_hit {
                                        if (_e1477.t > 0f) {
                                            if (_e1477.t < _e199) {
                                                let _e1484 = triangles.member[(0u + _e1029)].i0_;
                                                let _e1486 = ((_e1484 & 2147483648u) == 0u);
                                                if _e1486 {
                                                    phi_1702_ = false;
                                                    phi_1703_ = false;
                                                } else {
                                                    if true {
                                                        phi_1701_ = false;
                                                    } else {
                                                        phi_1701_ = true;
                                                    }
                                                    let _e1488 = phi_1701_;
                                                    phi_1702_ = _e1488;
                                                    phi_1703_ = true;
                                                }
                                                let _e1490 = phi_1702_;
                                                let _e1492 = phi_1703_;
                                                phi_1704_ = _e1490;
                                                phi_1705_ = _e1486;
                                                phi_1706_ = _e1492;
                                            } else {
                                                phi_1704_ = true;
                                                phi_1705_ = false;
                                                phi_1706_ = false;
                                            }
                                            let _e1494 = phi_1704_;
                                            let _e1496 = phi_1705_;
                                            let _e1498 = phi_1706_;
                                            phi_1707_ = _e1494;
                                            phi_1708_ = _e1496;
                                            phi_1709_ = _e1498;
                                        } else {
                                            phi_1707_ = true;
                                            phi_1708_ = false;
                                            phi_1709_ = false;
                                        }
                                        let _e1500 = phi_1707_;
                                        let _e1502 = phi_1708_;
                                        let _e1504 = phi_1709_;
                                        phi_1710_ = _e1500;
                                        phi_1711_ = _e1502;
                                        phi_1712_ = _e1504;
                                    } else {
                                        phi_1710_ = true;
                                        phi_1711_ = false;
                                        phi_1712_ = false;
                                    }
                                    let _e1506 = phi_1710_;
                                    let _e1508 = phi_1711_;
                                    let _e1510 = phi_1712_;
                                    if _e1506 {
                                        phi_1716_ = false;
                                        phi_1717_ = false;
                                    } else {
                                        phi_1716_ = _e1508;
                                        phi_1717_ = _e1510;
                                    }
                                    let _e1512 = phi_1716_;
                                    let _e1514 = phi_1717_;
                                    phi_1108_ = (_e1020 & (_e1020 - 1u));
                                    phi_1718_ = _e1506;
                                    phi_1719_ = _e1512;
                                    phi_1720_ = _e1514;
                                }
                                let _e1516 = phi_1108_;
                                let _e1518 = phi_1718_;
                                let _e1520 = phi_1719_;
                                let _e1522 = phi_1720_;
                                local_7 = _e1520;
                                local_8 = _e1522;
                                continue;
                                continuing {
                                    phi_1107_ = _e1516;
                                    break if !(_e1518);
                                }
                            }
                            let _e1525 = local_5;
                            if _e1525 {
                                let _e1527 = local.group_mask;
                                if ((_e1527 & 4278190080u) == 0u) {
                                    let _e1531 = local.len;
                                    if (_e1531 == 0u) {
                                        phi_1762_ = false;
                                    } else {
                                        let _e1535 = local.len;
                                        local.len = (_e1535 - 1u);
                                        let _e1538 = local.len;
                                        if (_e1538 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1543 = local.first[(0u + _e1538)];
                                        local.group = _e1543;
                                        let _e1546 = local.len;
                                        if (_e1546 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1551 = local.mask[(0u + _e1546)];
                                        local.group_mask = _e1551;
                                        phi_1762_ = true;
                                    }
                                    let _e1554 = phi_1762_;
                                    phi_1763_ = _e1554;
                                } else {
                                    phi_1763_ = true;
                                }
                                let _e1556 = phi_1763_;
                                if _e1556 {
                                    let _e1558 = local.group_mask;
                                    let _e1564 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1558)), 32u, (_e1558 == 0u)));
                                    let _e1568 = local.group_mask;
                                    let _e1582 = local.group_mask;
                                    local.group_mask = (_e1582 & ~((1u << bitcast<u32>((_e1564 & 31u)))));
                                    let _e1585 = local.group;
                                    phi_1794_ = (_e1585 + countOneBits(((_e1568 & ~((4294967295u << bitcast<u32>((((_e1564 - 24u) ^ _e446) & 31u))))) & 255u)));
                                } else {
                                    phi_1794_ = 4294967295u;
                                }
                                let _e1588 = phi_1794_;
                                phi_1795_ = _e1588;
                                phi_1796_ = false;
                                phi_1797_ = false;
                            } else {
                                phi_1795_ = u32();
                                let _e1807 = local_7;
                                phi_1796_ = _e1807;
                                let _e1810 = local_8;
                                phi_1797_ = _e1810;
                            }
                            let _e1590 = phi_1795_;
                            let _e1592 = phi_1796_;
                            let _e1594 = phi_1797_;
                            phi_778_ = _e1590;
                            let _e1814 = local_9;
                            phi_1798_ = _e1814;
                            phi_1799_ = false;
                            phi_1800_ = _e1592;
                            phi_1801_ = _e1594;
                        } else {
                            phi_778_ = u32();
                            phi_1798_ = false;
                            phi_1799_ = true;
                            phi_1800_ = false;
                            phi_1801_ = false;
                        }
                        let _e1596 = phi_778_;
                        let _e1598 = phi_1798_;
                        let _e1600 = phi_1799_;
                        let _e1602 = phi_1800_;
                        let _e1604 = phi_1801_;
                        local_6 = _e1600;
                        local_10 = _e1602;
                        local_11 = _e1604;
                        continue;
                        continuing {
                            phi_777_ = _e1596;
                            break if !(_e1598);
                        }
                    }
                    let _e1607 = local_6;
                    if _e1607 {
                        phi_1805_ = false;
                        phi_1806_ = false;
                    } else {
                        let _e1821 = local_10;
                        phi_1805_ = _e1821;
                        let _e1824 = local_11;
                        phi_1806_ = _e1824;
                    }
                    let _e1609 = phi_1805_;
                    let _e1611 = phi_1806_;
                    if _e1609 {
                        phi_1810_ = true;
                    } else {
                        phi_1810_ = _e1611;
                    }
                    let _e1613 = phi_1810_;
                    if _e1613 {
                        phi_1814_ = true;
                    } else {
                        phi_1814_ = false;
                    }
                    let _e1615 = phi_1814_;
                    phi_1815_ = _e1615;
                }
                let _e1617 = phi_1815_;
                phi_1816_ = _e1617;
                phi_1817_ = _e272;
            } else {
                phi_1816_ = bool();
                phi_1817_ = true;
            }
            let _e1619 = phi_1816_;
            let _e1621 = phi_1817_;
            if _e1621 {
                phi_1821_ = false;
            } else {
                phi_1821_ = _e1619;
            }
            let _e1623 = phi_1821_;
            if _e1623 {
                phi_1825_ = 0f;
            } else {
                phi_1825_ = 1f;
            }
            let _e1625 = phi_1825_;
            phi_1826_ = _e1625;
        }
        let _e1627 = phi_1826_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e1627;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
