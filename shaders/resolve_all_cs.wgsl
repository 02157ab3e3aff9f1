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

struct type_29 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_34 {
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

struct type_38 {
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
var<storage, read_write> visibility: type_13;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> nodes: type_34;
@group(0) @binding(3) 
var<storage> triangles: type_38;

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
    var phi_1838_: bool;
    var phi_1839_: bool;
    var phi_1840_: bool;
    var phi_1841_: bool;
    var phi_1845_: bool;

    let _e55 = (*param_7).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_7).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_7).normal[2u];
            let _e67 = global[2u];
            phi_1838_ = (_e65 == _e67);
            phi_1839_ = false;
        } else {
            phi_1838_ = bool();
            phi_1839_ = true;
        }
        let _e70 = phi_1838_;
        let _e72 = phi_1839_;
        phi_1840_ = _e70;
        phi_1841_ = _e72;
    } else {
        phi_1840_ = bool();
        phi_1841_ = true;
    }
    let _e74 = phi_1840_;
    let _e76 = phi_1841_;
    if _e76 {
        phi_1845_ = false;
    } else {
        phi_1845_ = _e74;
    }
    let _e78 = phi_1845_;
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
    var phi_780_: bool;
    var phi_860_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_887_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_914_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_920_: u32;
    var phi_923_: u32;
    var phi_937_: u32;
    var phi_947_: u32;
    var phi_957_: u32;
    var phi_975_: u32;
    var phi_985_: u32;
    var phi_995_: u32;
    var phi_1031_: u32;
    var phi_1044_: u32;
    var phi_1049_: u32;
    var phi_1050_: u32;
    var phi_1051_: u32;
    var phi_921_: u32;
    var phi_924_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1109_: u32;
    var phi_1112_: bool;
    var phi_1156_: vec3<f32>;
    var phi_1157_: vec3<f32>;
    var phi_1186_: vec3<f32>;
    var phi_1187_: vec3<f32>;
    var phi_1216_: vec3<f32>;
    var phi_1217_: vec3<f32>;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1240_: f32;
    var phi_1241_: f32;
    var phi_1242_: f32;
    var phi_1243_: f32;
    var phi_1251_: f32;
    var phi_1261_: bool;
    var phi_1262_: bool;
    var phi_1266_: f32;
    var phi_1267_: f32;
    var phi_1268_: f32;
    var phi_1269_: f32;
    var phi_1277_: f32;
    var phi_1287_: bool;
    var phi_1288_: bool;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1294_: f32;
    var phi_1295_: f32;
    var phi_1303_: f32;
    var phi_1318_: f32;
    var phi_1319_: bool;
    var phi_1320_: f32;
    var phi_1321_: bool;
    var phi_1322_: f32;
    var phi_1323_: bool;
    var phi_1341_: f32;
    var phi_1342_: bool;
    var phi_1343_: bool;
    var phi_1344_: f32;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1350_: bool;
    var phi_1351_: f32;
    var phi_1352_: bool;
    var phi_1380_: vec3<f32>;
    var phi_1381_: vec3<f32>;
    var phi_1406_: vec3<f32>;
    var phi_1407_: vec3<f32>;
    var phi_1432_: vec3<f32>;
    var phi_1433_: vec3<f32>;
    var phi_1489_: f32;
    var phi_1498_: f32;
    var phi_1507_: f32;
    var phi_1516_: f32;
    var phi_1523_: f32;
    var phi_1530_: f32;
    var phi_1543_: f32;
    var phi_1552_: f32;
    var phi_1561_: f32;
    var phi_1570_: f32;
    var phi_1577_: f32;
    var phi_1584_: f32;
    var phi_1601_: f32;
    var phi_1606_: f32;
    var phi_1611_: f32;
    var phi_1619_: f32;
    var phi_1624_: f32;
    var phi_1629_: f32;
    var phi_1641_: f32;
    var phi_1646_: f32;
    var phi_1651_: f32;
    var phi_1656_: f32;
    var phi_1661_: lt_bvh_triangle_Intersection;
    var phi_1662_: bool;
    var phi_1663_: lt_bvh_triangle_Intersection;
    var phi_1664_: bool;
    var phi_1668_: lt_bvh_triangle_Intersection;
    var phi_1669_: bool;
    var phi_1670_: lt_bvh_triangle_Intersection;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1676_: bool;
    var phi_1680_: lt_bvh_triangle_Intersection;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1702_: bool;
    var phi_1703_: bool;
    var phi_1704_: bool;
    var phi_1705_: bool;
    var phi_1706_: bool;
    var phi_1110_: u32;
    var phi_1113_: bool;
    var phi_1710_: bool;
    var local_5: bool;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1784_: u32;
    var phi_1785_: u32;
    var phi_778_: u32;
    var phi_781_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var local_6: bool;
    var phi_1791_: bool;
    var phi_1795_: bool;
    var phi_1796_: bool;
    var phi_1797_: bool;
    var phi_1798_: bool;
    var phi_1802_: bool;
    var phi_1806_: f32;
    var phi_1807_: f32;
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
            phi_1807_ = _e170.unnamed.visibility;
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
                    phi_1796_ = bool();
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
                    phi_780_ = false;
                    loop {
                        let _e584 = phi_777_;
                        let _e586 = phi_780_;
                        local_9 = _e586;
                        if (_e584 != 4294967295u) {
                            if (_e584 < _e61) {
                            } else {
                                return;
                            }
                            let _e593 = nodes.member[(0u + _e584)].frame[3u];
                            let _e618 = (bitcast<f32>((((_e593 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e348);
                            let _e619 = (bitcast<f32>((((_e593 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e358);
                            let _e620 = (bitcast<f32>((((_e593 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e368);
                            let _e623 = nodes.member[(0u + _e584)].frame[0u];
                            let _e627 = nodes.member[(0u + _e584)].frame[1u];
                            let _e631 = nodes.member[(0u + _e584)].frame[2u];
                            let _e636 = ((bitcast<f32>(_e623) - _e191) * _e348);
                            let _e637 = ((bitcast<f32>(_e627) - _e193) * _e358);
                            let _e638 = ((bitcast<f32>(_e631) - _e195) * _e368);
                            let _e646 = nodes.member[(0u + _e584)].x;
                            if (_e348 < 0f) {
                                let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e663 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e657.unnamed.root, _e646.w), _e657.unnamed_1);
                                let _e669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e663.unnamed, lt_bvh_traverse_Tree(_e646.x, _e663.unnamed_1.first_primitive));
                                phi_860_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e669.unnamed, lt_bvh_traverse_Tree(_e669.unnamed_1.root, _e646.y));
                            } else {
                                let _e685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e646.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e691 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e685.unnamed.root, _e646.y), _e685.unnamed_1);
                                let _e697 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e691.unnamed, lt_bvh_traverse_Tree(_e646.z, _e691.unnamed_1.first_primitive));
                                phi_860_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e697.unnamed, lt_bvh_traverse_Tree(_e697.unnamed_1.root, _e646.w));
                            }
                            let _e705 = phi_860_;
                            let _e715 = nodes.member[(0u + _e584)].y;
                            if (_e358 < 0f) {
                                let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e732 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e726.unnamed.root, _e715.w), _e726.unnamed_1);
                                let _e738 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e732.unnamed, lt_bvh_traverse_Tree(_e715.x, _e732.unnamed_1.first_primitive));
                                phi_887_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e738.unnamed, lt_bvh_traverse_Tree(_e738.unnamed_1.root, _e715.y));
                            } else {
                                let _e754 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e715.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e760 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e754.unnamed.root, _e715.y), _e754.unnamed_1);
                                let _e766 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e760.unnamed, lt_bvh_traverse_Tree(_e715.z, _e760.unnamed_1.first_primitive));
                                phi_887_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e766.unnamed, lt_bvh_traverse_Tree(_e766.unnamed_1.root, _e715.w));
                            }
                            let _e774 = phi_887_;
                            let _e784 = nodes.member[(0u + _e584)].z;
                            if (_e368 < 0f) {
                                let _e795 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e784.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e801 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e795.unnamed.root, _e784.w), _e795.unnamed_1);
                                let _e807 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e801.unnamed, lt_bvh_traverse_Tree(_e784.x, _e801.unnamed_1.first_primitive));
                                phi_914_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e807.unnamed, lt_bvh_traverse_Tree(_e807.unnamed_1.root, _e784.y));
                            } else {
                                let _e823 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e784.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e829 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e823.unnamed.root, _e784.y), _e823.unnamed_1);
                                let _e835 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e829.unnamed, lt_bvh_traverse_Tree(_e784.z, _e829.unnamed_1.first_primitive));
                                phi_914_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e835.unnamed, lt_bvh_traverse_Tree(_e835.unnamed_1.root, _e784.w));
                            }
                            let _e843 = phi_914_;
                            phi_920_ = 0u;
                            phi_923_ = 0u;
                            loop {
                                let _e853 = phi_920_;
                                let _e855 = phi_923_;
                                local_2 = _e855;
                                local_3 = _e855;
                                local_4 = _e855;
                                let _e856 = (_e853 < 8u);
                                if _e856 {
                                    let _e858 = (_e853 >> bitcast<u32>(2i));
                                    let _e859 = (_e853 & 3u);
                                    if (_e858 == 0u) {
                                        phi_937_ = _e705.unnamed.root;
                                    } else {
                                        phi_937_ = _e705.unnamed.first_primitive;
                                    }
                                    let _e862 = phi_937_;
                                    if (_e858 == 0u) {
                                        phi_947_ = _e774.unnamed.root;
                                    } else {
                                        phi_947_ = _e774.unnamed.first_primitive;
                                    }
                                    let _e871 = phi_947_;
                                    if (_e858 == 0u) {
                                        phi_957_ = _e843.unnamed.root;
                                    } else {
                                        phi_957_ = _e843.unnamed.first_primitive;
                                    }
                                    let _e880 = phi_957_;
                                    let _e893 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e862 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e618) + (_e636 - _e396)), ((f32(((_e871 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e619) + (_e637 - _e397)));
                                    let _e894 = core_intrinsics_maximum_number_nsz_f32_(_e893, ((f32(((_e880 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e620) + (_e638 - _e398)));
                                    if (_e858 == 0u) {
                                        phi_975_ = _e705.unnamed_1.root;
                                    } else {
                                        phi_975_ = _e705.unnamed_1.first_primitive;
                                    }
                                    let _e897 = phi_975_;
                                    if (_e858 == 0u) {
                                        phi_985_ = _e774.unnamed_1.root;
                                    } else {
                                        phi_985_ = _e774.unnamed_1.first_primitive;
                                    }
                                    let _e906 = phi_985_;
                                    if (_e858 == 0u) {
                                        phi_995_ = _e843.unnamed_1.root;
                                    } else {
                                        phi_995_ = _e843.unnamed_1.first_primitive;
                                    }
                                    let _e915 = phi_995_;
                                    let _e928 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e897 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e618) + (_e636 + _e396)), ((f32(((_e906 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e619) + (_e637 + _e397)));
                                    let _e929 = core_intrinsics_minimum_number_nsz_f32_(_e928, ((f32(((_e915 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u)) * _e620) + (_e638 + _e398)));
                                    if (_e894 <= _e929) {
                                        if (_e894 <= _e199) {
                                            if (_e929 >= 0f) {
                                                if (_e858 == 0u) {
                                                    let _e936 = nodes.member[(0u + _e584)].links[2u];
                                                    phi_1031_ = _e936;
                                                } else {
                                                    let _e939 = nodes.member[(0u + _e584)].links[3u];
                                                    phi_1031_ = _e939;
                                                }
                                                let _e941 = phi_1031_;
                                                let _e946 = ((_e941 >> bitcast<u32>(((_e859 * 8u) & 31u))) & 255u);
                                                let _e947 = (_e946 & 31u);
                                                if (_e947 >= 24u) {
                                                    phi_1044_ = (24u + ((_e947 - 24u) ^ _e446));
                                                } else {
                                                    phi_1044_ = _e947;
                                                }
                                                let _e953 = phi_1044_;
                                                phi_1049_ = (_e855 | ((_e946 >> bitcast<u32>(5i)) << bitcast<u32>((_e953 & 31u))));
                                            } else {
                                                phi_1049_ = _e855;
                                            }
                                            let _e961 = phi_1049_;
                                            phi_1050_ = _e961;
                                        } else {
                                            phi_1050_ = _e855;
                                        }
                                        let _e963 = phi_1050_;
                                        phi_1051_ = _e963;
                                    } else {
                                        phi_1051_ = _e855;
                                    }
                                    let _e965 = phi_1051_;
                                    phi_921_ = (_e853 + 1u);
                                    phi_924_ = _e965;
                                } else {
                                    phi_921_ = u32();
                                    phi_924_ = u32();
                                }
                                let _e968 = phi_921_;
                                let _e970 = phi_924_;
                                continue;
                                continuing {
                                    phi_920_ = _e968;
                                    phi_923_ = _e970;
                                    break if !(_e856);
                                }
                            }
                            let _e974 = nodes.member[(0u + _e584)].links[0u];
                            let _e978 = nodes.member[(0u + _e584)].frame[3u];
                            let _e982 = local_2;
                            if ((_e982 & 4278190080u) == 0u) {
                            } else {
                                let _e986 = local.group_mask;
                                if ((_e986 & 4278190080u) == 0u) {
                                } else {
                                    let _e990 = local.len;
                                    if (_e990 < 32u) {
                                        let _e993 = local.group;
                                        let _e995 = local.len;
                                        if (_e995 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.first[(0u + _e995)] = _e993;
                                        let _e1001 = local.group_mask;
                                        let _e1003 = local.len;
                                        if (_e1003 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.mask[(0u + _e1003)] = _e1001;
                                        let _e1010 = local.len;
                                        local.len = (_e1010 + 1u);
                                    }
                                }
                                local.group = (0u + _e974);
                                let _e1014 = local_3;
                                local.group_mask = ((_e1014 & 4278190080u) | (_e978 >> bitcast<u32>(24i)));
                            }
                            let _e1019 = local_4;
                            phi_1109_ = (_e1019 & 16777215u);
                            phi_1112_ = _e586;
                            loop {
                                let _e1022 = phi_1109_;
                                let _e1024 = phi_1112_;
                                local_7 = _e1024;
                                let _e1025 = (_e1022 == 0u);
                                local_5 = _e1025;
                                local_8 = _e1025;
                                if _e1025 {
                                    phi_1110_ = u32();
                                    phi_1113_ = bool();
                                    phi_1710_ = false;
                                } else {
                                    let _e1028 = nodes.member[(0u + _e584)].links[1u];
                                    let _e1033 = ((0u + _e1028) + select(firstTrailingBit(_e1022), 32u, (_e1022 == 0u)));
                                    if (_e1033 < arrayLength((&triangles.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e1040 = triangles.member[(0u + _e1033)].v0_;
                                    let _e1042 = (_e1040.x - _e191);
                                    let _e1044 = (_e1040.y - _e193);
                                    let _e1046 = (_e1040.z - _e195);
                                    if (_e419 == 0u) {
                                        phi_1157_ = vec3<f32>(_e1044, _e1046, _e1042);
                                    } else {
                                        if (_e419 == 1u) {
                                            phi_1156_ = vec3<f32>(_e1046, _e1042, _e1044);
                                        } else {
                                            phi_1156_ = (_e1040 - vec3<f32>(_e191, _e193, _e195));
                                        }
                                        let _e1054 = phi_1156_;
                                        phi_1157_ = _e1054;
                                    }
                                    let _e1056 = phi_1157_;
                                    let _e1060 = (_e1056.x - (_e430 * _e1056.z));
                                    let _e1064 = (_e1056.y - (_e433 * _e1056.z));
                                    let _e1066 = triangles.member[(0u + _e1033)].v1_;
                                    let _e1068 = (_e1066.x - _e191);
                                    let _e1070 = (_e1066.y - _e193);
                                    let _e1072 = (_e1066.z - _e195);
                                    if (_e419 == 0u) {
                                        phi_1187_ = vec3<f32>(_e1070, _e1072, _e1068);
                                    } else {
                                        if (_e419 == 1u) {
                                            phi_1186_ = vec3<f32>(_e1072, _e1068, _e1070);
                                        } else {
                                            phi_1186_ = (_e1066 - vec3<f32>(_e191, _e193, _e195));
                                        }
                                        let _e1080 = phi_1186_;
                                        phi_1187_ = _e1080;
                                    }
                                    let _e1082 = phi_1187_;
                                    let _e1086 = (_e1082.x - (_e430 * _e1082.z));
                                    let _e1090 = (_e1082.y - (_e433 * _e1082.z));
                                    let _e1092 = triangles.member[(0u + _e1033)].v2_;
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
                                    if (_e1086 < _e1112) {
                                        phi_1236_ = true;
                                    } else {
                                        if (_e1086 == _e1112) {
                                            phi_1235_ = (_e1090 < _e1116);
                                        } else {
                                            phi_1235_ = false;
                                        }
                                        let _e1121 = phi_1235_;
                                        phi_1236_ = _e1121;
                                    }
                                    let _e1123 = phi_1236_;
                                    if _e1123 {
                                        phi_1240_ = _e1116;
                                        phi_1241_ = _e1112;
                                        phi_1242_ = _e1090;
                                        phi_1243_ = _e1086;
                                    } else {
                                        phi_1240_ = _e1090;
                                        phi_1241_ = _e1086;
                                        phi_1242_ = _e1116;
                                        phi_1243_ = _e1112;
                                    }
                                    let _e1125 = phi_1240_;
                                    let _e1127 = phi_1241_;
                                    let _e1129 = phi_1242_;
                                    let _e1131 = phi_1243_;
                                    let _e1134 = ((_e1131 * _e1125) - (_e1129 * _e1127));
                                    if _e1123 {
                                        phi_1251_ = -(_e1134);
                                    } else {
                                        phi_1251_ = _e1134;
                                    }
                                    let _e1137 = phi_1251_;
                                    if (_e1112 < _e1060) {
                                        phi_1262_ = true;
                                    } else {
                                        if (_e1112 == _e1060) {
                                            phi_1261_ = (_e1116 < _e1064);
                                        } else {
                                            phi_1261_ = false;
                                        }
                                        let _e1142 = phi_1261_;
                                        phi_1262_ = _e1142;
                                    }
                                    let _e1144 = phi_1262_;
                                    if _e1144 {
                                        phi_1266_ = _e1064;
                                        phi_1267_ = _e1060;
                                        phi_1268_ = _e1116;
                                        phi_1269_ = _e1112;
                                    } else {
                                        phi_1266_ = _e1116;
                                        phi_1267_ = _e1112;
                                        phi_1268_ = _e1064;
                                        phi_1269_ = _e1060;
                                    }
                                    let _e1146 = phi_1266_;
                                    let _e1148 = phi_1267_;
                                    let _e1150 = phi_1268_;
                                    let _e1152 = phi_1269_;
                                    let _e1155 = ((_e1152 * _e1146) - (_e1150 * _e1148));
                                    if _e1144 {
                                        phi_1277_ = -(_e1155);
                                    } else {
                                        phi_1277_ = _e1155;
                                    }
                                    let _e1158 = phi_1277_;
                                    if (_e1060 < _e1086) {
                                        phi_1288_ = true;
                                    } else {
                                        if (_e1060 == _e1086) {
                                            phi_1287_ = (_e1064 < _e1090);
                                        } else {
                                            phi_1287_ = false;
                                        }
                                        let _e1163 = phi_1287_;
                                        phi_1288_ = _e1163;
                                    }
                                    let _e1165 = phi_1288_;
                                    if _e1165 {
                                        phi_1292_ = _e1090;
                                        phi_1293_ = _e1086;
                                        phi_1294_ = _e1064;
                                        phi_1295_ = _e1060;
                                    } else {
                                        phi_1292_ = _e1064;
                                        phi_1293_ = _e1060;
                                        phi_1294_ = _e1090;
                                        phi_1295_ = _e1086;
                                    }
                                    let _e1167 = phi_1292_;
                                    let _e1169 = phi_1293_;
                                    let _e1171 = phi_1294_;
                                    let _e1173 = phi_1295_;
                                    let _e1176 = ((_e1173 * _e1167) - (_e1171 * _e1169));
                                    if _e1165 {
                                        phi_1303_ = -(_e1176);
                                    } else {
                                        phi_1303_ = _e1176;
                                    }
                                    let _e1179 = phi_1303_;
                                    if (_e1137 >= 0f) {
                                        if (_e1158 >= 0f) {
                                            if (_e1179 >= 0f) {
                                                phi_1318_ = ((_e1137 + _e1158) + _e1179);
                                                phi_1319_ = false;
                                            } else {
                                                phi_1318_ = f32();
                                                phi_1319_ = true;
                                            }
                                            let _e1186 = phi_1318_;
                                            let _e1188 = phi_1319_;
                                            phi_1320_ = _e1186;
                                            phi_1321_ = _e1188;
                                        } else {
                                            phi_1320_ = f32();
                                            phi_1321_ = true;
                                        }
                                        let _e1190 = phi_1320_;
                                        let _e1192 = phi_1321_;
                                        phi_1322_ = _e1190;
                                        phi_1323_ = _e1192;
                                    } else {
                                        phi_1322_ = f32();
                                        phi_1323_ = true;
                                    }
                                    let _e1194 = phi_1322_;
                                    let _e1196 = phi_1323_;
                                    if _e1196 {
                                        if (_e1137 <= 0f) {
                                            if (_e1158 <= 0f) {
                                                let _e1199 = (_e1179 <= 0f);
                                                if _e1199 {
                                                }
                                                phi_1341_ = ((_e1137 + _e1158) + _e1179);
                                                phi_1342_ = false;
                                                phi_1343_ = _e1199;
                                            } else {
                                                phi_1341_ = f32();
                                                phi_1342_ = true;
                                                phi_1343_ = false;
                                            }
                                            let _e1203 = phi_1341_;
                                            let _e1205 = phi_1342_;
                                            let _e1207 = phi_1343_;
                                            phi_1344_ = _e1203;
                                            phi_1345_ = _e1205;
                                            phi_1346_ = _e1207;
                                        } else {
                                            phi_1344_ = f32();
                                            phi_1345_ = true;
                                            phi_1346_ = false;
                                        }
                                        let _e1209 = phi_1344_;
                                        let _e1211 = phi_1345_;
                                        let _e1213 = phi_1346_;
                                        if _e1211 {
                                            phi_1350_ = false;
                                        } else {
                                            phi_1350_ = _e1213;
                                        }
                                        let _e1215 = phi_1350_;
                                        phi_1351_ = _e1209;
                                        phi_1352_ = _e1215;
                                    } else {
                                        phi_1351_ = _e1194;
                                        phi_1352_ = true;
                                    }
                                    let _e1217 = phi_1351_;
                                    let _e1219 = phi_1352_;
                                    if _e1219 {
                                        let _e1220 = (_e1217 == 0f);
                                        if _e1220 {
                                            phi_1668_ = lt_bvh_triangle_Intersection();
                                            phi_1669_ = false;
                                        } else {
                                            let _e1222 = triangles.member[(0u + _e1033)].v0_;
                                            let _e1224 = (_e1222.x - _e191);
                                            let _e1226 = (_e1222.y - _e193);
                                            let _e1228 = (_e1222.z - _e195);
                                            if (_e419 == 0u) {
                                                phi_1381_ = vec3<f32>(_e1226, _e1228, _e1224);
                                            } else {
                                                if (_e419 == 1u) {
                                                    phi_1380_ = vec3<f32>(_e1228, _e1224, _e1226);
                                                } else {
                                                    phi_1380_ = (_e1222 - vec3<f32>(_e191, _e193, _e195));
                                                }
                                                let _e1236 = phi_1380_;
                                                phi_1381_ = _e1236;
                                            }
                                            let _e1238 = phi_1381_;
                                            let _e1240 = triangles.member[(0u + _e1033)].v1_;
                                            let _e1242 = triangles.member[(0u + _e1033)].v0_;
                                            let _e1245 = (_e1240.x - _e1242.x);
                                            let _e1248 = (_e1240.y - _e1242.y);
                                            let _e1251 = (_e1240.z - _e1242.z);
                                            if (_e419 == 0u) {
                                                phi_1407_ = vec3<f32>(_e1248, _e1251, _e1245);
                                            } else {
                                                if (_e419 == 1u) {
                                                    phi_1406_ = vec3<f32>(_e1251, _e1245, _e1248);
                                                } else {
                                                    phi_1406_ = (_e1240 - _e1242);
                                                }
                                                let _e1258 = phi_1406_;
                                                phi_1407_ = _e1258;
                                            }
                                            let _e1260 = phi_1407_;
                                            let _e1262 = triangles.member[(0u + _e1033)].v2_;
                                            let _e1264 = triangles.member[(0u + _e1033)].v0_;
                                            let _e1267 = (_e1262.x - _e1264.x);
                                            let _e1270 = (_e1262.y - _e1264.y);
                                            let _e1273 = (_e1262.z - _e1264.z);
                                            if (_e419 == 0u) {
                                                phi_1433_ = vec3<f32>(_e1270, _e1273, _e1267);
                                            } else {
                                                if (_e419 == 1u) {
                                                    phi_1432_ = vec3<f32>(_e1273, _e1267, _e1270);
                                                } else {
                                                    phi_1432_ = (_e1262 - _e1264);
                                                }
                                                let _e1280 = phi_1432_;
                                                phi_1433_ = _e1280;
                                            }
                                            let _e1282 = phi_1433_;
                                            let _e1289 = ((_e1260.y * _e1282.z) - (_e1260.z * _e1282.y));
                                            let _e1296 = ((_e1260.z * _e1282.x) - (_e1260.x * _e1282.z));
                                            let _e1303 = ((_e1260.x * _e1282.y) - (_e1260.y * _e1282.x));
                                            let _e1317 = (((1f / _e427.z) * (((_e1289 * _e1238.x) + (_e1296 * _e1238.y)) + (_e1303 * _e1238.z))) / (((_e1289 * _e430) + (_e1296 * _e433)) + _e1303));
                                            if (_e1317 > 0f) {
                                                if (_e1317 < _e199) {
                                                    let _e1321 = triangles.member[(0u + _e1033)].v0_;
                                                    let _e1323 = triangles.member[(0u + _e1033)].v1_;
                                                    if (_e1321.x < _e1323.x) {
                                                        phi_1489_ = _e1321.x;
                                                    } else {
                                                        phi_1489_ = _e1323.x;
                                                    }
                                                    let _e1330 = phi_1489_;
                                                    if (_e1321.y < _e1323.y) {
                                                        phi_1498_ = _e1321.y;
                                                    } else {
                                                        phi_1498_ = _e1323.y;
                                                    }
                                                    let _e1337 = phi_1498_;
                                                    if (_e1321.z < _e1323.z) {
                                                        phi_1507_ = _e1321.z;
                                                    } else {
                                                        phi_1507_ = _e1323.z;
                                                    }
                                                    let _e1344 = phi_1507_;
                                                    let _e1346 = triangles.member[(0u + _e1033)].v2_;
                                                    if (_e1330 < _e1346.x) {
                                                        phi_1516_ = _e1330;
                                                    } else {
                                                        phi_1516_ = _e1346.x;
                                                    }
                                                    let _e1351 = phi_1516_;
                                                    if (_e1337 < _e1346.y) {
                                                        phi_1523_ = _e1337;
                                                    } else {
                                                        phi_1523_ = _e1346.y;
                                                    }
                                                    let _e1356 = phi_1523_;
                                                    if (_e1344 < _e1346.z) {
                                                        phi_1530_ = _e1344;
                                                    } else {
                                                        phi_1530_ = _e1346.z;
                                                    }
                                                    let _e1361 = phi_1530_;
                                                    let _e1363 = triangles.member[(0u + _e1033)].v0_;
                                                    let _e1365 = triangles.member[(0u + _e1033)].v1_;
                                                    if (_e1363.x > _e1365.x) {
                                                        phi_1543_ = _e1363.x;
                                                    } else {
                                                        phi_1543_ = _e1365.x;
                                                    }
                                                    let _e1372 = phi_1543_;
                                                    if (_e1363.y > _e1365.y) {
                                                        phi_1552_ = _e1363.y;
                                                    } else {
                                                        phi_1552_ = _e1365.y;
                                                    }
                                                    let _e1379 = phi_1552_;
                                                    if (_e1363.z > _e1365.z) {
                                                        phi_1561_ = _e1363.z;
                                                    } else {
                                                        phi_1561_ = _e1365.z;
                                                    }
                                                    let _e1386 = phi_1561_;
                                                    let _e1388 = triangles.member[(0u + _e1033)].v2_;
                                                    if (_e1372 > _e1388.x) {
                                                        phi_1570_ = _e1372;
                                                    } else {
                                                        phi_1570_ = _e1388.x;
                                                    }
                                                    let _e1393 = phi_1570_;
                                                    if (_e1379 > _e1388.y) {
                                                        phi_1577_ = _e1379;
                                                    } else {
                                                        phi_1577_ = _e1388.y;
                                                    }
                                                    let _e1398 = phi_1577_;
                                                    if (_e1386 > _e1388.z) {
                                                        phi_1584_ = _e1386;
                                                    } else {
                                                        phi_1584_ = _e1388.z;
                                                    }
                                                    let _e1403 = phi_1584_;
                                                    let _e1407 = ((_e1351 - _e191) * _e348);
                                                    let _e1408 = ((_e1356 - _e193) * _e358);
                                                    let _e1409 = ((_e1361 - _e195) * _e368);
                                                    let _e1413 = ((_e1393 - _e191) * _e348);
                                                    let _e1414 = ((_e1398 - _e193) * _e358);
                                                    let _e1415 = ((_e1403 - _e195) * _e368);
                                                    if (_e1407 < _e1413) {
                                                        phi_1601_ = _e1407;
                                                    } else {
                                                        phi_1601_ = _e1413;
                                                    }
                                                    let _e1418 = phi_1601_;
                                                    if (_e1408 < _e1414) {
                                                        phi_1606_ = _e1408;
                                                    } else {
                                                        phi_1606_ = _e1414;
                                                    }
                                                    let _e1421 = phi_1606_;
                                                    if (_e1409 < _e1415) {
                                                        phi_1611_ = _e1409;
                                                    } else {
                                                        phi_1611_ = _e1415;
                                                    }
                                                    let _e1424 = phi_1611_;
                                                    if (_e1407 > _e1413) {
                                                        phi_1619_ = _e1407;
                                                    } else {
                                                        phi_1619_ = _e1413;
                                                    }
                                                    let _e1430 = phi_1619_;
                                                    if (_e1408 > _e1414) {
                                                        phi_1624_ = _e1408;
                                                    } else {
                                                        phi_1624_ = _e1414;
                                                    }
                                                    let _e1433 = phi_1624_;
                                                    if (_e1409 > _e1415) {
                                                        phi_1629_ = _e1409;
                                                    } else {
                                                        phi_1629_ = _e1415;
                                                    }
                                                    let _e1436 = phi_1629_;
                                                    let _e1440 = core_intrinsics_maximum_number_nsz_f32_((_e1418 - _e403), (_e1421 - _e404));
                                                    let _e1441 = core_intrinsics_maximum_number_nsz_f32_(_e1440, (_e1424 - _e405));
                                                    let _e1442 = core_intrinsics_minimum_number_nsz_f32_((_e1430 + _e403), (_e1433 + _e404));
                                                    let _e1443 = core_intrinsics_minimum_number_nsz_f32_(_e1442, (_e1436 + _e405));
                                                    if (_e1441 > -300000000000000000000000000000000000000f) {
                                                        phi_1641_ = _e1441;
                                                    } else {
                                                        phi_1641_ = -300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1446 = phi_1641_;
                                                    if (_e1443 < 300000000000000000000000000000000000000f) {
                                                        phi_1646_ = _e1443;
                                                    } else {
                                                        phi_1646_ = 300000000000000000000000000000000000000f;
                                                    }
                                                    let _e1449 = phi_1646_;
                                                    if (_e1317 < _e1446) {
                                                        phi_1651_ = _e1446;
                                                    } else {
                                                        phi_1651_ = _e1317;
                                                    }
                                                    let _e1452 = phi_1651_;
                                                    if (_e1452 > _e1449) {
                                                        phi_1656_ = _e1449;
                                                    } else {
                                                        phi_1656_ = _e1452;
                                                    }
                                                    let _e1455 = phi_1656_;
                                                    phi_1661_ = lt_bvh_triangle_Intersection(_e1455, (_e1158 / _e1217), (_e1179 / _e1217), (_e1446 <= _e1449));
                                                    phi_1662_ = false;
                                                } else {
                                                    phi_1661_ = lt_bvh_triangle_Intersection();
                                                    phi_1662_ = true;
                                                }
                                                let _e1461 = phi_1661_;
                                                let _e1463 = phi_1662_;
                                                phi_1663_ = _e1461;
                                                phi_1664_ = _e1463;
                                            } else {
                                                phi_1663_ = lt_bvh_triangle_Intersection();
                                                phi_1664_ = true;
                                            }
                                            let _e1465 = phi_1663_;
                                            let _e1467 = phi_1664_;
                                            if _e1467 {
                                            }
                                            phi_1668_ = _e1465;
                                            phi_1669_ = _e1467;
                                        }
                                        let _e1469 = phi_1668_;
                                        let _e1471 = phi_1669_;
                                        phi_1670_ = _e1469;
                                        phi_1671_ = _e1220;
                                        phi_1672_ = _e1471;
                                    } else {
                                        phi_1670_ = lt_bvh_triangle_Intersection();
                                        phi_1671_ = true;
                                        phi_1672_ = false;
                                    }
                                    let _e1473 = phi_1670_;
                                    let _e1475 = phi_1671_;
                                    let _e1477 = phi_1672_;
                                    if _e1475 {
                                        phi_1676_ = true;
                                    } else {
                                        phi_1676_ = _e1477;
                                    }
                                    let _e1479 = phi_1676_;
                                    if _e1479 {
                                        phi_1680_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1680_ = _e1473;
                                    }
                                    let _e1481 = phi_1680_;
                                    if _e1481.is_hit {
                                        if (_e1481.t > 0f) {
                                            if (_e1481.t < _e199) {
                                                if true {
                                                    phi_1700_ = false;
                                                } else {
                                                    phi_1700_ = true;
                                                }
                                                let _e1490 = phi_1700_;
                                                phi_1701_ = true;
                                                phi_1702_ = _e1490;
                                            } else {
                                                phi_1701_ = _e1024;
                                                phi_1702_ = true;
                                            }
                                            let _e1492 = phi_1701_;
                                            let _e1494 = phi_1702_;
                                            phi_1703_ = _e1492;
                                            phi_1704_ = _e1494;
                                        } else {
                                            phi_1703_ = _e1024;
                                            phi_1704_ = true;
                                        }
                                        let _e1496 = phi_1703_;
                                        let _e1498 = phi_1704_;
                                        phi_1705_ = _e1496;
                                        phi_1706_ = _e1498;
                                    } else {
                                        phi_1705_ = _e1024;
                                        phi_1706_ = true;
                                    }
                                    let _e1500 = phi_1705_;
                                    let _e1502 = phi_1706_;
                                    if _e1502 {
                                    }
                                    phi_1110_ = (_e1022 & (_e1022 - 1u));
                                    phi_1113_ = _e1500;
                                    phi_1710_ = _e1502;
                                }
                                let _e1504 = phi_1110_;
                                let _e1506 = phi_1113_;
                                let _e1508 = phi_1710_;
                                continue;
                                continuing {
                                    phi_1109_ = _e1504;
                                    phi_1112_ = _e1506;
                                    break if !(_e1508);
                                }
                            }
                            let _e1511 = local_5;
                            if _e1511 {
                                let _e1513 = local.group_mask;
                                if ((_e1513 & 4278190080u) == 0u) {
                                    let _e1517 = local.len;
                                    if (_e1517 == 0u) {
                                        phi_1752_ = false;
                                    } else {
                                        let _e1521 = local.len;
                                        local.len = (_e1521 - 1u);
                                        let _e1524 = local.len;
                                        if (_e1524 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1529 = local.first[(0u + _e1524)];
                                        local.group = _e1529;
                                        let _e1532 = local.len;
                                        if (_e1532 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1537 = local.mask[(0u + _e1532)];
                                        local.group_mask = _e1537;
                                        phi_1752_ = true;
                                    }
                                    let _e1540 = phi_1752_;
                                    phi_1753_ = _e1540;
                                } else {
                                    phi_1753_ = true;
                                }
                                let _e1542 = phi_1753_;
                                if _e1542 {
                                    let _e1544 = local.group_mask;
                                    let _e1550 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1544)), 32u, (_e1544 == 0u)));
                                    let _e1554 = local.group_mask;
                                    let _e1568 = local.group_mask;
                                    local.group_mask = (_e1568 & ~((1u << bitcast<u32>((_e1550 & 31u)))));
                                    let _e1571 = local.group;
                                    phi_1784_ = (_e1571 + countOneBits(((_e1554 & ~((4294967295u << bitcast<u32>((((_e1550 - 24u) ^ _e446) & 31u))))) & 255u)));
                                } else {
                                    phi_1784_ = 4294967295u;
                                }
                                let _e1574 = phi_1784_;
                                phi_1785_ = _e1574;
                            } else {
                                phi_1785_ = u32();
                            }
                            let _e1576 = phi_1785_;
                            phi_778_ = _e1576;
                            let _e1778 = local_7;
                            phi_781_ = _e1778;
                            let _e1781 = local_8;
                            phi_1786_ = _e1781;
                            phi_1787_ = false;
                        } else {
                            phi_778_ = u32();
                            phi_781_ = bool();
                            phi_1786_ = false;
                            phi_1787_ = true;
                        }
                        let _e1578 = phi_778_;
                        let _e1580 = phi_781_;
                        let _e1582 = phi_1786_;
                        let _e1584 = phi_1787_;
                        local_6 = _e1584;
                        continue;
                        continuing {
                            phi_777_ = _e1578;
                            phi_780_ = _e1580;
                            break if !(_e1582);
                        }
                    }
                    let _e1587 = local_6;
                    if _e1587 {
                        phi_1791_ = false;
                    } else {
                        phi_1791_ = true;
                    }
                    let _e1589 = phi_1791_;
                    if _e1589 {
                        phi_1795_ = true;
                    } else {
                        let _e1787 = local_9;
                        phi_1795_ = _e1787;
                    }
                    let _e1591 = phi_1795_;
                    phi_1796_ = _e1591;
                }
                let _e1593 = phi_1796_;
                phi_1797_ = _e1593;
                phi_1798_ = _e272;
            } else {
                phi_1797_ = bool();
                phi_1798_ = true;
            }
            let _e1595 = phi_1797_;
            let _e1597 = phi_1798_;
            if _e1597 {
                phi_1802_ = false;
            } else {
                phi_1802_ = _e1595;
            }
            let _e1599 = phi_1802_;
            if _e1599 {
                phi_1806_ = 0f;
            } else {
                phi_1806_ = 1f;
            }
            let _e1601 = phi_1806_;
            phi_1807_ = _e1601;
        }
        let _e1603 = phi_1807_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e1603;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
