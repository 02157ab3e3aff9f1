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
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
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
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: bool;

    let _e55 = (*param_7).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_7).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_7).normal[2u];
            let _e67 = global[2u];
            phi_1760_ = (_e65 == _e67);
            phi_1761_ = false;
        } else {
            phi_1760_ = bool();
            phi_1761_ = true;
        }
        let _e70 = phi_1760_;
        let _e72 = phi_1761_;
        phi_1762_ = _e70;
        phi_1763_ = _e72;
    } else {
        phi_1762_ = bool();
        phi_1763_ = true;
    }
    let _e74 = phi_1762_;
    let _e76 = phi_1763_;
    if _e76 {
        phi_1767_ = false;
    } else {
        phi_1767_ = _e74;
    }
    let _e78 = phi_1767_;
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
    var phi_1184_: vec3<f32>;
    var phi_1185_: vec3<f32>;
    var phi_1216_: vec3<f32>;
    var phi_1217_: vec3<f32>;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1242_: f32;
    var phi_1243_: f32;
    var phi_1244_: f32;
    var phi_1245_: f32;
    var phi_1253_: f32;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1268_: f32;
    var phi_1269_: f32;
    var phi_1270_: f32;
    var phi_1271_: f32;
    var phi_1279_: f32;
    var phi_1289_: bool;
    var phi_1290_: bool;
    var phi_1294_: f32;
    var phi_1295_: f32;
    var phi_1296_: f32;
    var phi_1297_: f32;
    var phi_1305_: f32;
    var phi_1320_: f32;
    var phi_1321_: bool;
    var phi_1322_: f32;
    var phi_1323_: bool;
    var phi_1324_: f32;
    var phi_1325_: bool;
    var phi_1343_: f32;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: f32;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1352_: bool;
    var phi_1353_: f32;
    var phi_1354_: bool;
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
    var phi_1108_: u32;
    var phi_1621_: bool;
    var phi_1622_: bool;
    var phi_1623_: bool;
    var local_5: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1697_: u32;
    var phi_1698_: u32;
    var phi_1699_: bool;
    var phi_1700_: bool;
    var phi_778_: u32;
    var phi_1701_: bool;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var local_6: bool;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1713_: bool;
    var phi_1717_: bool;
    var phi_1718_: bool;
    var phi_1719_: bool;
    var phi_1720_: bool;
    var phi_1724_: bool;
    var phi_1728_: f32;
    var phi_1729_: f32;
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
            phi_1729_ = _e170.unnamed.visibility;
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
                    phi_1718_ = bool();
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
                    let _e435 = (1f / _e427.z);
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
                                    phi_1621_ = false;
                                    phi_1622_ = false;
                                    phi_1623_ = false;
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
                                    let _e1064 = triangles.member[(0u + _e1029)].v1_;
                                    let _e1066 = (_e1064.x - _e191);
                                    let _e1068 = (_e1064.y - _e193);
                                    let _e1070 = (_e1064.z - _e195);
                                    if (_e419 == 0u) {
                                        phi_1185_ = vec3<f32>(_e1068, _e1070, _e1066);
                                    } else {
                                        if (_e419 == 1u) {
                                            phi_1184_ = vec3<f32>(_e1070, _e1066, _e1068);
                                        } else {
                                            phi_1184_ = (_e1064 - vec3<f32>(_e191, _e193, _e195));
                                        }
                                        let _e1078 = phi_1184_;
                                        phi_1185_ = _e1078;
                                    }
                                    let _e1080 = phi_1185_;
                                    let _e1084 = (_e1080.x - (_e430 * _e1080.z));
                                    let _e1088 = (_e1080.y - (_e433 * _e1080.z));
                                    let _e1092 = triangles.member[(0u + _e1029)].v2_;
                                    let _e1094 = (_e1092.x - _e191);
                                    let _e1096 = (_e1092.y - _e193);
                                    let _e1098 = (_e1092.z - _e195);
                                    if (_e419 == 0u) {
                                        phi_1217_ = vec3<f32>(_e1096, _e1098, _e1094);
                                    } else {
                                        if (_e419 == 1u) {
                                            phi_1216_ = vec3<f32>(_e1098, _e1094, _e1096);
                                        } else {
                                            phi_1216_ = (_e1092 - vec3<f32>(_e191, _e193, _e195));
                                        }
                                        let _e1106 = phi_1216_;
                                        phi_1217_ = _e1106;
                                    }
                                    let _e1108 = phi_1217_;
                                    let _e1112 = (_e1108.x - (_e430 * _e1108.z));
                                    let _e1116 = (_e1108.y - (_e433 * _e1108.z));
                                    if (_e1084 < _e1112) {
                                        phi_1238_ = true;
                                    } else {
                                        if (_e1084 == _e1112) {
                                            phi_1237_ = (_e1088 < _e1116);
                                        } else {
                                            phi_1237_ = false;
                                        }
                                        let _e1123 = phi_1237_;
                                        phi_1238_ = _e1123;
                                    }
                                    let _e1125 = phi_1238_;
                                    if _e1125 {
                                        phi_1242_ = _e1116;
                                        phi_1243_ = _e1112;
                                        phi_1244_ = _e1088;
                                        phi_1245_ = _e1084;
                                    } else {
                                        phi_1242_ = _e1088;
                                        phi_1243_ = _e1084;
                                        phi_1244_ = _e1116;
                                        phi_1245_ = _e1112;
                                    }
                                    let _e1127 = phi_1242_;
                                    let _e1129 = phi_1243_;
                                    let _e1131 = phi_1244_;
                                    let _e1133 = phi_1245_;
                                    let _e1136 = ((_e1133 * _e1127) - (_e1131 * _e1129));
                                    if _e1125 {
                                        phi_1253_ = -(_e1136);
                                    } else {
                                        phi_1253_ = _e1136;
                                    }
                                    let _e1139 = phi_1253_;
                                    if (_e1112 < _e1056) {
                                        phi_1264_ = true;
                                    } else {
                                        if (_e1112 == _e1056) {
                                            phi_1263_ = (_e1116 < _e1060);
                                        } else {
                                            phi_1263_ = false;
                                        }
                                        let _e1144 = phi_1263_;
                                        phi_1264_ = _e1144;
                                    }
                                    let _e1146 = phi_1264_;
                                    if _e1146 {
                                        phi_1268_ = _e1060;
                                        phi_1269_ = _e1056;
                                        phi_1270_ = _e1116;
                                        phi_1271_ = _e1112;
                                    } else {
                                        phi_1268_ = _e1116;
                                        phi_1269_ = _e1112;
                                        phi_1270_ = _e1060;
                                        phi_1271_ = _e1056;
                                    }
                                    let _e1148 = phi_1268_;
                                    let _e1150 = phi_1269_;
                                    let _e1152 = phi_1270_;
                                    let _e1154 = phi_1271_;
                                    let _e1157 = ((_e1154 * _e1148) - (_e1152 * _e1150));
                                    if _e1146 {
                                        phi_1279_ = -(_e1157);
                                    } else {
                                        phi_1279_ = _e1157;
                                    }
                                    let _e1160 = phi_1279_;
                                    if (_e1056 < _e1084) {
                                        phi_1290_ = true;
                                    } else {
                                        if (_e1056 == _e1084) {
                                            phi_1289_ = (_e1060 < _e1088);
                                        } else {
                                            phi_1289_ = false;
                                        }
                                        let _e1165 = phi_1289_;
                                        phi_1290_ = _e1165;
                                    }
                                    let _e1167 = phi_1290_;
                                    if _e1167 {
                                        phi_1294_ = _e1088;
                                        phi_1295_ = _e1084;
                                        phi_1296_ = _e1060;
                                        phi_1297_ = _e1056;
                                    } else {
                                        phi_1294_ = _e1060;
                                        phi_1295_ = _e1056;
                                        phi_1296_ = _e1088;
                                        phi_1297_ = _e1084;
                                    }
                                    let _e1169 = phi_1294_;
                                    let _e1171 = phi_1295_;
                                    let _e1173 = phi_1296_;
                                    let _e1175 = phi_1297_;
                                    let _e1178 = ((_e1175 * _e1169) - (_e1173 * _e1171));
                                    if _e1167 {
                                        phi_1305_ = -(_e1178);
                                    } else {
                                        phi_1305_ = _e1178;
                                    }
                                    let _e1181 = phi_1305_;
                                    if (_e1139 >= 0f) {
                                        if (_e1160 >= 0f) {
                                            if (_e1181 >= 0f) {
                                                phi_1320_ = ((_e1139 + _e1160) + _e1181);
                                                phi_1321_ = false;
                                            } else {
                                                phi_1320_ = f32();
                                                phi_1321_ = true;
                                            }
                                            let _e1188 = phi_1320_;
                                            let _e1190 = phi_1321_;
                                            phi_1322_ = _e1188;
                                            phi_1323_ = _e1190;
                                        } else {
                                            phi_1322_ = f32();
                                            phi_1323_ = true;
                                        }
                                        let _e1192 = phi_1322_;
                                        let _e1194 = phi_1323_;
                                        phi_1324_ = _e1192;
                                        phi_1325_ = _e1194;
                                    } else {
                                        phi_1324_ = f32();
                                        phi_1325_ = true;
                                    }
                                    let _e1196 = phi_1324_;
                                    let _e1198 = phi_1325_;
                                    if _e1198 {
                                        if (_e1139 <= 0f) {
                                            if (_e1160 <= 0f) {
                                                let _e1201 = (_e1181 <= 0f);
                                                if _e1201 {
                                                }
                                                phi_1343_ = ((_e1139 + _e1160) + _e1181);
                                                phi_1344_ = false;
                                                phi_1345_ = _e1201;
                                            } else {
                                                phi_1343_ = f32();
                                                phi_1344_ = true;
                                                phi_1345_ = false;
                                            }
                                            let _e1205 = phi_1343_;
                                            let _e1207 = phi_1344_;
                                            let _e1209 = phi_1345_;
                                            phi_1346_ = _e1205;
                                            phi_1347_ = _e1207;
                                            phi_1348_ = _e1209;
                                        } else {
                                            phi_1346_ = f32();
                                            phi_1347_ = true;
                                            phi_1348_ = false;
                                        }
                                        let _e1211 = phi_1346_;
                                        let _e1213 = phi_1347_;
                                        let _e1215 = phi_1348_;
                                        if _e1213 {
                                            phi_1352_ = false;
                                        } else {
                                            phi_1352_ = _e1215;
                                        }
                                        let _e1217 = phi_1352_;
                                        phi_1353_ = _e1211;
                                        phi_1354_ = _e1217;
                                    } else {
                                        phi_1353_ = _e1196;
                                        phi_1354_ = true;
                                    }
                                    let _e1219 = phi_1353_;
                                    let _e1221 = phi_1354_;
                                    if _e1221 {
                                        let _e1222 = (_e1219 == 0f);
                                        if _e1222 {
                                            phi_1567_ = lt_bvh_triangle_Intersection();
                                            phi_1568_ = false;
                                        } else {
                                            let _e1228 = ((((_e1139 * (_e435 * _e1052.z)) + (_e1160 * (_e435 * _e1080.z))) + (_e1181 * (_e435 * _e1108.z))) / _e1219);
                                            if (_e1228 > 0f) {
                                                if (_e1228 < _e199) {
                                                    let _e1232 = triangles.member[(0u + _e1029)].v0_;
                                                    let _e1234 = triangles.member[(0u + _e1029)].v1_;
                                                    if (_e1232.x < _e1234.x) {
                                                        phi_1388_ = _e1232.x;
                                                    } else {
                                                        phi_1388_ = _e1234.x;
                                                    }
                                                    let _e1241 = phi_1388_;
                                                    if (_e1232.y < _e1234.y) {
                                                        phi_1397_ = _e1232.y;
                                                    } else {
                                                        phi_1397_ = _e1234.y;
                                                    }
                                                    let _e1248 = phi_1397_;
                                                    if (_e1232.z < _e1234.z) {
                                                        phi_1406_ = _e1232.z;
                                                    } else {
                                                        phi_1406_ = _e1234.z;
                                                    }
                                                    let _e1255 = phi_1406_;
                                                    let _e1257 = triangles.member[(0u + _e1029)].v2_;
                                                    if (_e1241 < _e1257.x) {
                                                        phi_1415_ = _e1241;
                                                    } else {
                                                        phi_1415_ = _e1257.x;
                                                    }
                                                    let _e1262 = phi_1415_;
                                                    if (_e1248 < _e1257.y) {
                                                        phi_1422_ = _e1248;
                                                    } else {
                                                        phi_1422_ = _e1257.y;
                                                    }
                                                    let _e1267 = phi_1422_;
                                                    if (_e1255 < _e1257.z) {
                                                        phi_1429_ = _e1255;
                                                    } else {
                                                        phi_1429_ = _e1257.z;
                                                    }
                                                    let _e1272 = phi_1429_;
                                                    let _e1274 = triangles.member[(0u + _e1029)].v0_;
                                                    let _e1276 = triangles.member[(0u + _e1029)].v1_;
                                                    if (_e1274.x > _e1276.x) {
                                                        phi_1442_ = _e1274.x;
                                                    } else {
                                                        phi_1442_ = _e1276.x;
                                                    }
                                                    let _e1283 = phi_1442_;
                                                    if (_e1274.y > _e1276.y) {
                                                        phi_1451_ = _e1274.y;
                                                    } else {
                                                        phi_1451_ = _e1276.y;
                                                    }
                                                    let _e1290 = phi_1451_;
                                                    if (_e1274.z > _e1276.z) {
                                                        phi_1460_ = _e1274.z;
                                                    } else {
                                                        phi_1460_ = _e1276.z;
                                                    }
                                                    let _e1297 = phi_1460_;
                                                    let _e1299 = triangles.member[(0u + _e1029)].v2_;
                                                    if (_e1283 > _e1299.x) {
                                                        phi_1469_ = _e1283;
                                                    } else {
                                                        phi_1469_ = _e1299.x;
                                                    }
                                                    let _e1304 = phi_1469_;
                                                    if (_e1290 > _e1299.y) {
                                                        phi_1476_ = _e1290;
                                                    } else {
                                                        phi_1476_ = _e1299.y;
                                                    }
                                                    let _e1309 = phi_1476_;
                                                    if (_e1297 > _e1299.z) {
                                                        phi_1483_ = _e1297;
                                                    } else {
                                                        phi_1483_ = _e1299.z;
                                                    }
                                                    let _e1314 = phi_1483_;
                                                    let _e1318 = ((_e1262 - _e191) * _e348);
                                                    let _e1319 = ((_e1267 - _e193) * _e358);
                                                    let _e1320 = ((_e1272 - _e195) * _e368);
                                                    let _e1324 = ((_e1304 - _e191) * _e348);
                                                    let _e1325 = ((_e1309 - _e193) * _e358);
                                                    let _e1326 = ((_e1314 - _e195) * _e368);
                                                    if (_e1318 < _e1324) {
                                                        phi_1500_ = _e1318;
                                                    } else {
                                                        phi_1500_ = _e1324;
                                                    }
                                                    let _e1329 = phi_1500_;
                                                    if (_e1319 < _e1325) {
                                                        phi_1505_ = _e1319;
                                                    } else {
                                                        phi_1505_ = _e1325;
                                                    }
                                                    let _e1332 = phi_1505_;
                                                    if (_e1320 < _e1326) {
                                                        phi_1510_ = _e1320;
                                                    } else {
                                                        phi_1510_ = _e1326;
                                                    }
                                                    let _e1335 = phi_1510_;
                                                    if (_e1318 > _e1324) {
                                                        phi_1518_ = _e1318;
                                                    } else {
                                                        phi_1518_ = _e1324;
                                                    }
                                                    let _e1341 = phi_1518_;
                                                    if (_e1319 > _e1325) {
                                                        phi_1523_ = _e1319;
                                                    } else {
                                                        phi_1523_ = _e1325;
                                                    }
                                                    let _e1344 = phi_1523_;
                                                    if (_e1320 > _e1326) {
                                                        phi_1528_ = _e1320;
                                                    } else {
                                                        phi_1528_ = _e1326;
                                                    }
                                                    let _e1347 = phi_1528_;
                                                    let _e1351 = core_intrinsics_maximum_number_nsz_f32_((_e1329 - _e403), (_e1332 - _e404));
                                                    let _e1352 = core_intrinsics_maximum_number_nsz_f32_(_e1351, (_e1335 - _e405));
                                                    let _e1353 = core_intrinsics_minimum_number_nsz_f32_((_e1341 + _e403), (_e1344 + _e404));
                                                    let _e1354 = core_intrinsics_minimum_number_nsz_f32_(_e1353, (_e1347 + _e405));
                                                    if (_e1352 > -300000000000000000000000000000000000000f) {
                                                        phi_1540_ = _e1352;
                                                    } else {
                                                        phi_1540_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1357 = phi_1540_;
                                                    if (_e1354 < 300000000000000000000000000000000000000f) {
                                                        phi_1545_ = _e1354;
                                                    } else {
                                                        phi_1545_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1360 = phi_1545_;
                                                    if (_e1228 < _e1357) {
                                                        phi_1550_ = _e1357;
                                                    } else {
                                                        phi_1550_ = _e1228;
                                                    }
                                                    let _e1363 = phi_1550_;
                                                    if (_e1363 > _e1360) {
                                                        phi_1555_ = _e1360;
                                                    } else {
                                                        phi_1555_ = _e1363;
                                                    }
                                                    let _e1366 = phi_1555_;
                                                    phi_1560_ = lt_bvh_triangle_Intersection(_e1366, (_e1160 / _e1219), (_e1181 / _e1219), (_e1357 <= _e1360));
                                                    phi_1561_ = false;
                                                } else {
                                                    phi_1560_ = lt_bvh_triangle_Intersection();
                                                    phi_1561_ = true;
                                                }
                                                let _e1372 = phi_1560_;
                                                let _e1374 = phi_1561_;
                                                phi_1562_ = _e1372;
                                                phi_1563_ = _e1374;
                                            } else {
                                                phi_1562_ = lt_bvh_triangle_Intersection();
                                                phi_1563_ = true;
                                            }
                                            let _e1376 = phi_1562_;
                                            let _e1378 = phi_1563_;
                                            if _e1378 {
                                            }
                                            phi_1567_ = _e1376;
                                            phi_1568_ = _e1378;
                                        }
                                        let _e1380 = phi_1567_;
                                        let _e1382 = phi_1568_;
                                        phi_1569_ = _e1380;
                                        phi_1570_ = _e1222;
                                        phi_1571_ = _e1382;
                                    } else {
                                        phi_1569_ = lt_bvh_triangle_Intersection();
                                        phi_1570_ = true;
                                        phi_1571_ = false;
                                    }
                                    let _e1384 = phi_1569_;
                                    let _e1386 = phi_1570_;
                                    let _e1388 = phi_1571_;
                                    if _e1386 {
                                        phi_1575_ = true;
                                    } else {
                                        phi_1575_ = _e1388;
                                    }
                                    let _e1390 = phi_1575_;
                                    if _e1390 {
                                        phi_1579_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1579_ = _e1384;
                                    }
                                    let _e1392 = phi_1579_;
                                    if _e1392.is_hit {
                                        if (_e1392.t > 0f) {
                                            if (_e1392.t < _e199) {
                                                let _e1399 = triangles.member[(0u + _e1029)].i0_;
                                                let _e1401 = ((_e1399 & 2147483648u) == 0u);
                                                if _e1401 {
                                                    phi_1605_ = false;
                                                    phi_1606_ = false;
                                                } else {
                                                    if true {
                                                        phi_1604_ = false;
                                                    } else {
                                                        phi_1604_ = true;
                                                    }
                                                    let _e1403 = phi_1604_;
                                                    phi_1605_ = _e1403;
                                                    phi_1606_ = true;
                                                }
                                                let _e1405 = phi_1605_;
                                                let _e1407 = phi_1606_;
                                                phi_1607_ = _e1405;
                                                phi_1608_ = _e1401;
                                                phi_1609_ = _e1407;
                                            } else {
                                                phi_1607_ = true;
                                                phi_1608_ = false;
                                                phi_1609_ = false;
                                            }
                                            let _e1409 = phi_1607_;
                                            let _e1411 = phi_1608_;
                                            let _e1413 = phi_1609_;
                                            phi_1610_ = _e1409;
                                            phi_1611_ = _e1411;
                                            phi_1612_ = _e1413;
                                        } else {
                                            phi_1610_ = true;
                                            phi_1611_ = false;
                                            phi_1612_ = false;
                                        }
                                        let _e1415 = phi_1610_;
                                        let _e1417 = phi_1611_;
                                        let _e1419 = phi_1612_;
                                        phi_1613_ = _e1415;
                                        phi_1614_ = _e1417;
                                        phi_1615_ = _e1419;
                                    } else {
                                        phi_1613_ = true;
                                        phi_1614_ = false;
                                        phi_1615_ = false;
                                    }
                                    let _e1421 = phi_1613_;
                                    let _e1423 = phi_1614_;
                                    let _e1425 = phi_1615_;
                                    if _e1421 {
                                        phi_1619_ = false;
                                        phi_1620_ = false;
                                    } else {
                                        phi_1619_ = _e1423;
                                        phi_1620_ = _e1425;
                                    }
                                    let _e1427 = phi_1619_;
                                    let _e1429 = phi_1620_;
                                    phi_1108_ = (_e1020 & (_e1020 - 1u));
                                    phi_1621_ = _e1421;
                                    phi_1622_ = _e1427;
                                    phi_1623_ = _e1429;
                                }
                                let _e1431 = phi_1108_;
                                let _e1433 = phi_1621_;
                                let _e1435 = phi_1622_;
                                let _e1437 = phi_1623_;
                                local_7 = _e1435;
                                local_8 = _e1437;
                                continue;
                                continuing {
                                    phi_1107_ = _e1431;
                                    break if !(_e1433);
                                }
                            }
                            let _e1440 = local_5;
                            if _e1440 {
                                let _e1442 = local.group_mask;
                                if ((_e1442 & 4278190080u) == 0u) {
                                    let _e1446 = local.len;
                                    if (_e1446 == 0u) {
                                        phi_1665_ = false;
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
                                        phi_1665_ = true;
                                    }
                                    let _e1469 = phi_1665_;
                                    phi_1666_ = _e1469;
                                } else {
                                    phi_1666_ = true;
                                }
                                let _e1471 = phi_1666_;
                                if _e1471 {
                                    let _e1473 = local.group_mask;
                                    let _e1479 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1473)), 32u, (_e1473 == 0u)));
                                    let _e1483 = local.group_mask;
                                    let _e1497 = local.group_mask;
                                    local.group_mask = (_e1497 & ~((1u << bitcast<u32>((_e1479 & 31u)))));
                                    let _e1500 = local.group;
                                    phi_1697_ = (_e1500 + countOneBits(((_e1483 & ~((4294967295u << bitcast<u32>((((_e1479 - 24u) ^ _e446) & 31u))))) & 255u)));
                                } else {
                                    phi_1697_ = 4294967295u;
                                }
                                let _e1503 = phi_1697_;
                                phi_1698_ = _e1503;
                                phi_1699_ = false;
                                phi_1700_ = false;
                            } else {
                                phi_1698_ = u32();
                                let _e1716 = local_7;
                                phi_1699_ = _e1716;
                                let _e1719 = local_8;
                                phi_1700_ = _e1719;
                            }
                            let _e1505 = phi_1698_;
                            let _e1507 = phi_1699_;
                            let _e1509 = phi_1700_;
                            phi_778_ = _e1505;
                            let _e1723 = local_9;
                            phi_1701_ = _e1723;
                            phi_1702_ = false;
                            phi_1703_ = _e1507;
                            phi_1704_ = _e1509;
                        } else {
                            phi_778_ = u32();
                            phi_1701_ = false;
                            phi_1702_ = true;
                            phi_1703_ = false;
                            phi_1704_ = false;
                        }
                        let _e1511 = phi_778_;
                        let _e1513 = phi_1701_;
                        let _e1515 = phi_1702_;
                        let _e1517 = phi_1703_;
                        let _e1519 = phi_1704_;
                        local_6 = _e1515;
                        local_10 = _e1517;
                        local_11 = _e1519;
                        continue;
                        continuing {
                            phi_777_ = _e1511;
                            break if !(_e1513);
                        }
                    }
                    let _e1522 = local_6;
                    if _e1522 {
                        phi_1708_ = false;
                        phi_1709_ = false;
                    } else {
                        let _e1730 = local_10;
                        phi_1708_ = _e1730;
                        let _e1733 = local_11;
                        phi_1709_ = _e1733;
                    }
                    let _e1524 = phi_1708_;
                    let _e1526 = phi_1709_;
                    if _e1524 {
                        phi_1713_ = true;
                    } else {
                        phi_1713_ = _e1526;
                    }
                    let _e1528 = phi_1713_;
                    if _e1528 {
                        phi_1717_ = true;
                    } else {
                        phi_1717_ = false;
                    }
                    let _e1530 = phi_1717_;
                    phi_1718_ = _e1530;
                }
                let _e1532 = phi_1718_;
                phi_1719_ = _e1532;
                phi_1720_ = _e272;
            } else {
                phi_1719_ = bool();
                phi_1720_ = true;
            }
            let _e1534 = phi_1719_;
            let _e1536 = phi_1720_;
            if _e1536 {
                phi_1724_ = false;
            } else {
                phi_1724_ = _e1534;
            }
            let _e1538 = phi_1724_;
            if _e1538 {
                phi_1728_ = 0f;
            } else {
                phi_1728_ = 1f;
            }
            let _e1540 = phi_1728_;
            phi_1729_ = _e1540;
        }
        let _e1542 = phi_1729_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e1542;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
