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

struct type_6 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_24 {
    member: array<abi_Sample>,
}

struct type_28 {
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

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_39 {
    member: array<lt_bvh_Node>,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
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

struct type_46 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_24;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_46;
@group(0) @binding(2) 
var<storage> nodes: type_39;
@group(0) @binding(3) 
var<storage> triangles: type_6;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_28;

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

fn lt_shaders_evaluate_to_light(param_7: vec3<f32>, param_8: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_8.x - (param_7.x * param_8.w)), (param_8.y - (param_7.y * param_8.w)), (param_8.z - (param_7.z * param_8.w)));
}

fn lt_shaders_resolve_shadow_ray(param_9: ptr<function, abi_Sample>, param_10: vec4<f32>) -> lt_bvh_Ray {
    var phi_1810_: f32;

    let _e55 = (*param_9).position;
    let _e57 = (*param_9).normal;
    let _e59 = (*param_9).magnitude;
    let _e61 = ((8f / 8388608f) * _e59);
    let _e69 = (_e55 + vec3<f32>((_e57.x * _e61), (_e57.y * _e61), (_e57.z * _e61)));
    if (param_10.w == 0f) {
        phi_1810_ = 300000000000000000000000000000000000000f;
    } else {
        phi_1810_ = 1f;
    }
    let _e73 = phi_1810_;
    let _e74 = lt_shaders_evaluate_to_light(_e69, param_10);
    return lt_bvh_Ray(_e69, 0f, _e74, _e73);
}

fn _lt_shaders_abi_Sample_is_valid(param_11: ptr<function, abi_Sample>) -> bool {
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1763_: bool;
    var phi_1767_: bool;

    let _e55 = (*param_11).normal[0u];
    let _e57 = global[0u];
    if (_e55 == _e57) {
        let _e60 = (*param_11).normal[1u];
        let _e62 = global[1u];
        if (_e60 == _e62) {
            let _e65 = (*param_11).normal[2u];
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

fn lt_shaders_evaluate_settle(param_12: ptr<function, abi_Sample>, param_13: vec4<f32>) -> u0028_evaluate_Verdict_u0020_bool_u0029_ {
    var phi_1731_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1735_: u0028_evaluate_Verdict_u0020_bool_u0029_;

    let _e54 = _lt_shaders_abi_Sample_is_valid(param_12);
    if _e54 {
        let _e56 = (*param_12).normal;
        let _e58 = (*param_12).position;
        let _e59 = lt_shaders_evaluate_to_light(_e58, param_13);
        if ((((_e56.x * _e59.x) + (_e56.y * _e59.y)) + (_e56.z * _e59.z)) > 0f) {
            let _e73 = (*param_12).flags;
            let _e81 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e87 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e81.unnamed.visibility, false), _e81.unnamed_1);
            phi_1731_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e87.unnamed, ((_e73 & 1u) == 0u));
        } else {
            let _e96 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e102 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e96.unnamed.visibility, false), _e96.unnamed_1);
            phi_1731_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e102.unnamed, true);
        }
        let _e107 = phi_1731_;
        phi_1735_ = _e107;
    } else {
        let _e113 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
        let _e119 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e113.unnamed.visibility, false), _e113.unnamed_1);
        phi_1735_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e119.unnamed, true);
    }
    let _e124 = phi_1735_;
    return _e124;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: abi_Sample;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_327_: bool;
    var phi_331_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_336_: bool;
    var phi_337_: bool;
    var phi_338_: bool;
    var phi_339_: bool;
    var phi_340_: bool;
    var phi_341_: bool;
    var phi_342_: bool;
    var phi_343_: bool;
    var phi_344_: bool;
    var phi_345_: bool;
    var phi_346_: bool;
    var phi_347_: bool;
    var phi_348_: bool;
    var phi_352_: bool;
    var phi_356_: bool;
    var phi_431_: f32;
    var phi_438_: f32;
    var phi_446_: f32;
    var phi_453_: f32;
    var phi_461_: f32;
    var phi_468_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_503_: f32;
    var phi_536_: bool;
    var phi_537_: bool;
    var phi_545_: u32;
    var phi_546_: u32;
    var phi_564_: vec3<f32>;
    var phi_565_: vec3<f32>;
    var phi_579_: u32;
    var phi_584_: u32;
    var phi_589_: u32;
    var phi_703_: bool;
    var phi_704_: bool;
    var phi_735_: u32;
    var phi_737_: u32;
    var phi_823_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_850_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_877_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_883_: u32;
    var phi_886_: u32;
    var phi_900_: u32;
    var phi_910_: u32;
    var phi_920_: u32;
    var phi_938_: u32;
    var phi_948_: u32;
    var phi_958_: u32;
    var phi_994_: u32;
    var phi_1007_: u32;
    var phi_1012_: u32;
    var phi_1013_: u32;
    var phi_1014_: u32;
    var phi_884_: u32;
    var phi_887_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1072_: u32;
    var phi_1119_: vec3<f32>;
    var phi_1120_: vec3<f32>;
    var phi_1153_: vec3<f32>;
    var phi_1154_: vec3<f32>;
    var phi_1187_: vec3<f32>;
    var phi_1188_: vec3<f32>;
    var phi_1208_: bool;
    var phi_1209_: bool;
    var phi_1213_: f32;
    var phi_1214_: f32;
    var phi_1215_: f32;
    var phi_1216_: f32;
    var phi_1224_: f32;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1239_: f32;
    var phi_1240_: f32;
    var phi_1241_: f32;
    var phi_1242_: f32;
    var phi_1250_: f32;
    var phi_1260_: bool;
    var phi_1261_: bool;
    var phi_1265_: f32;
    var phi_1266_: f32;
    var phi_1267_: f32;
    var phi_1268_: f32;
    var phi_1276_: f32;
    var phi_1291_: f32;
    var phi_1292_: bool;
    var phi_1293_: f32;
    var phi_1294_: bool;
    var phi_1295_: f32;
    var phi_1296_: bool;
    var phi_1314_: f32;
    var phi_1315_: bool;
    var phi_1316_: bool;
    var phi_1317_: f32;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1323_: bool;
    var phi_1324_: f32;
    var phi_1325_: bool;
    var phi_1351_: f32;
    var phi_1360_: f32;
    var phi_1369_: f32;
    var phi_1378_: f32;
    var phi_1385_: f32;
    var phi_1392_: f32;
    var phi_1405_: f32;
    var phi_1414_: f32;
    var phi_1423_: f32;
    var phi_1432_: f32;
    var phi_1439_: f32;
    var phi_1446_: f32;
    var phi_1469_: f32;
    var phi_1474_: f32;
    var phi_1479_: f32;
    var phi_1487_: f32;
    var phi_1492_: f32;
    var phi_1497_: f32;
    var phi_1509_: f32;
    var phi_1514_: f32;
    var phi_1519_: f32;
    var phi_1524_: f32;
    var phi_1529_: lt_bvh_triangle_Intersection;
    var phi_1530_: lt_bvh_triangle_Intersection;
    var phi_1531_: bool;
    var phi_1535_: lt_bvh_triangle_Intersection;
    var phi_1562_: bool;
    var phi_1563_: bool;
    var phi_1564_: bool;
    var phi_1565_: bool;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1568_: bool;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1577_: bool;
    var phi_1578_: bool;
    var phi_1073_: u32;
    var phi_1579_: bool;
    var phi_1580_: bool;
    var phi_1581_: bool;
    var local_5: bool;
    var phi_1623_: bool;
    var phi_1624_: bool;
    var phi_1655_: u32;
    var phi_1656_: u32;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_738_: u32;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var local_6: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1671_: bool;
    var phi_1675_: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1678_: bool;
    var phi_1682_: bool;
    var phi_1686_: f32;
    var phi_1687_: f32;
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
        let _e91 = lt_shaders_evaluate_settle((&local_1), _e90);
        if _e91.unnamed_1 {
            phi_1687_ = _e91.unnamed.visibility;
        } else {
            let _e96 = p.member.light;
            let _e97 = lt_shaders_resolve_shadow_ray((&local_1), _e96);
            let _e107 = abs(_e97.direction.x);
            let _e109 = abs(_e97.direction.y);
            let _e111 = abs(_e97.direction.z);
            if (abs(_e97.origin.x) < 1000000000000000f) {
                if (abs(_e97.origin.y) < 1000000000000000f) {
                    if (abs(_e97.origin.z) < 1000000000000000f) {
                        if (_e107 < 1000000000000000f) {
                            if (_e109 < 1000000000000000f) {
                                if (_e111 < 1000000000000000f) {
                                    if (_e107 > 0f) {
                                        phi_326_ = bool();
                                        phi_327_ = true;
                                    } else {
                                        let _e119 = (_e109 > 0f);
                                        if _e119 {
                                            phi_325_ = bool();
                                        } else {
                                            phi_325_ = (_e111 > 0f);
                                        }
                                        let _e122 = phi_325_;
                                        phi_326_ = _e122;
                                        phi_327_ = _e119;
                                    }
                                    let _e124 = phi_326_;
                                    let _e126 = phi_327_;
                                    if _e126 {
                                        phi_331_ = true;
                                    } else {
                                        phi_331_ = _e124;
                                    }
                                    let _e128 = phi_331_;
                                    phi_332_ = _e128;
                                    phi_333_ = false;
                                } else {
                                    phi_332_ = bool();
                                    phi_333_ = true;
                                }
                                let _e130 = phi_332_;
                                let _e132 = phi_333_;
                                phi_334_ = _e130;
                                phi_335_ = false;
                                phi_336_ = _e132;
                            } else {
                                phi_334_ = bool();
                                phi_335_ = true;
                                phi_336_ = false;
                            }
                            let _e134 = phi_334_;
                            let _e136 = phi_335_;
                            let _e138 = phi_336_;
                            phi_337_ = _e134;
                            phi_338_ = _e136;
                            phi_339_ = _e138;
                        } else {
                            phi_337_ = bool();
                            phi_338_ = true;
                            phi_339_ = false;
                        }
                        let _e140 = phi_337_;
                        let _e142 = phi_338_;
                        let _e144 = phi_339_;
                        phi_340_ = _e140;
                        phi_341_ = _e142;
                        phi_342_ = _e144;
                    } else {
                        phi_340_ = bool();
                        phi_341_ = true;
                        phi_342_ = false;
                    }
                    let _e146 = phi_340_;
                    let _e148 = phi_341_;
                    let _e150 = phi_342_;
                    phi_343_ = _e146;
                    phi_344_ = _e148;
                    phi_345_ = _e150;
                } else {
                    phi_343_ = bool();
                    phi_344_ = true;
                    phi_345_ = false;
                }
                let _e152 = phi_343_;
                let _e154 = phi_344_;
                let _e156 = phi_345_;
                phi_346_ = _e152;
                phi_347_ = _e154;
                phi_348_ = _e156;
            } else {
                phi_346_ = bool();
                phi_347_ = true;
                phi_348_ = false;
            }
            let _e158 = phi_346_;
            let _e160 = phi_347_;
            let _e162 = phi_348_;
            if _e160 {
                phi_352_ = true;
            } else {
                phi_352_ = _e162;
            }
            let _e164 = phi_352_;
            if _e164 {
                phi_356_ = false;
            } else {
                phi_356_ = _e158;
            }
            let _e166 = phi_356_;
            if _e166 {
                let _e167 = (0u >= _e61);
                if _e167 {
                    phi_1676_ = bool();
                } else {
                    if (0u < _e61) {
                    } else {
                        return;
                    }
                    let _e173 = nodes.member[(0u + 0u)].frame[0u];
                    let _e177 = nodes.member[(0u + 0u)].frame[1u];
                    let _e181 = nodes.member[(0u + 0u)].frame[2u];
                    let _e185 = nodes.member[(0u + 0u)].frame[0u];
                    let _e189 = nodes.member[(0u + 0u)].frame[1u];
                    let _e193 = nodes.member[(0u + 0u)].frame[2u];
                    let _e197 = nodes.member[(0u + 0u)].frame[3u];
                    let _e235 = core_intrinsics_maximum_number_nsz_f32_(abs(_e97.direction.x), abs(_e97.direction.y));
                    let _e236 = core_intrinsics_maximum_number_nsz_f32_(_e235, abs(_e97.direction.z));
                    let _e237 = (_e236 * 0.0000000000009094947f);
                    if (abs(_e97.direction.x) < _e237) {
                        phi_431_ = _e237;
                    } else {
                        phi_431_ = abs(_e97.direction.x);
                    }
                    let _e244 = phi_431_;
                    if (_e97.direction.x < 0f) {
                        phi_438_ = (-1f / _e244);
                    } else {
                        phi_438_ = (1f / _e244);
                    }
                    let _e249 = phi_438_;
                    if (abs(_e97.direction.y) < _e237) {
                        phi_446_ = _e237;
                    } else {
                        phi_446_ = abs(_e97.direction.y);
                    }
                    let _e256 = phi_446_;
                    if (_e97.direction.y < 0f) {
                        phi_453_ = (-1f / _e256);
                    } else {
                        phi_453_ = (1f / _e256);
                    }
                    let _e261 = phi_453_;
                    if (abs(_e97.direction.z) < _e237) {
                        phi_461_ = _e237;
                    } else {
                        phi_461_ = abs(_e97.direction.z);
                    }
                    let _e268 = phi_461_;
                    if (_e97.direction.z < 0f) {
                        phi_468_ = (-1f / _e268);
                    } else {
                        phi_468_ = (1f / _e268);
                    }
                    let _e273 = phi_468_;
                    let _e281 = abs((bitcast<f32>(_e173) - _e97.origin.x));
                    let _e282 = abs((bitcast<f32>(_e177) - _e97.origin.y));
                    let _e283 = abs((bitcast<f32>(_e181) - _e97.origin.z));
                    let _e291 = abs(((bitcast<f32>(_e185) + (bitcast<f32>((((_e197 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e97.origin.x));
                    let _e292 = abs(((bitcast<f32>(_e189) + (bitcast<f32>((((_e197 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e97.origin.y));
                    let _e293 = abs(((bitcast<f32>(_e193) + (bitcast<f32>((((_e197 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e97.origin.z));
                    if (_e281 > _e291) {
                        phi_493_ = _e281;
                    } else {
                        phi_493_ = _e291;
                    }
                    let _e296 = phi_493_;
                    if (_e282 > _e292) {
                        phi_498_ = _e282;
                    } else {
                        phi_498_ = _e292;
                    }
                    let _e299 = phi_498_;
                    if (_e283 > _e293) {
                        phi_503_ = _e283;
                    } else {
                        phi_503_ = _e293;
                    }
                    let _e302 = phi_503_;
                    let _e303 = core_intrinsics_maximum_number_nsz_f32_(_e296, _e299);
                    let _e304 = core_intrinsics_maximum_number_nsz_f32_(_e303, _e302);
                    let _e309 = (_e304 * 0.0000019073486f);
                    let _e310 = (abs(_e249) * _e309);
                    let _e311 = (abs(_e261) * _e309);
                    let _e312 = (abs(_e273) * _e309);
                    let _e316 = (_e304 * 0.0000009536743f);
                    let _e317 = (abs(_e249) * _e316);
                    let _e318 = (abs(_e261) * _e316);
                    let _e319 = (abs(_e273) * _e316);
                    let _e322 = abs(_e97.direction.x);
                    let _e324 = abs(_e97.direction.y);
                    let _e326 = abs(_e97.direction.z);
                    if (_e322 >= _e324) {
                        if (_e322 >= _e326) {
                            phi_536_ = false;
                        } else {
                            phi_536_ = true;
                        }
                        let _e330 = phi_536_;
                        phi_537_ = _e330;
                    } else {
                        phi_537_ = true;
                    }
                    let _e332 = phi_537_;
                    if _e332 {
                        if (_e324 >= _e326) {
                            phi_545_ = 1u;
                        } else {
                            phi_545_ = 2u;
                        }
                        let _e335 = phi_545_;
                        phi_546_ = _e335;
                    } else {
                        phi_546_ = 0u;
                    }
                    let _e337 = phi_546_;
                    if (_e337 == 0u) {
                        phi_565_ = vec3<f32>(_e97.direction.y, _e97.direction.z, _e97.direction.x);
                    } else {
                        if (_e337 == 1u) {
                            phi_564_ = vec3<f32>(_e97.direction.z, _e97.direction.x, _e97.direction.y);
                        } else {
                            phi_564_ = _e97.direction;
                        }
                        let _e350 = phi_564_;
                        phi_565_ = _e350;
                    }
                    let _e352 = phi_565_;
                    let _e356 = (_e352.x / _e352.z);
                    let _e359 = (_e352.y / _e352.z);
                    let _e361 = (1f / _e352.z);
                    if (_e249 < 0f) {
                        phi_579_ = 0u;
                    } else {
                        phi_579_ = 1u;
                    }
                    let _e364 = phi_579_;
                    if (_e261 < 0f) {
                        phi_584_ = 0u;
                    } else {
                        phi_584_ = 2u;
                    }
                    let _e367 = phi_584_;
                    if (_e273 < 0f) {
                        phi_589_ = 0u;
                    } else {
                        phi_589_ = 4u;
                    }
                    let _e370 = phi_589_;
                    let _e372 = ((_e364 | _e367) | _e370);
                    let _e373 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e373.first[0], _e373.first[1], _e373.first[2], _e373.first[3], _e373.first[4], _e373.first[5], _e373.first[6], _e373.first[7], _e373.first[8], _e373.first[9], _e373.first[10], _e373.first[11], _e373.first[12], _e373.first[13], _e373.first[14], _e373.first[15], _e373.first[16], _e373.first[17], _e373.first[18], _e373.first[19], _e373.first[20], _e373.first[21], _e373.first[22], _e373.first[23], _e373.first[24], _e373.first[25], _e373.first[26], _e373.first[27], _e373.first[28], _e373.first[29], _e373.first[30], _e373.first[31]), array<u32, 32>(_e373.mask[0], _e373.mask[1], _e373.mask[2], _e373.mask[3], _e373.mask[4], _e373.mask[5], _e373.mask[6], _e373.mask[7], _e373.mask[8], _e373.mask[9], _e373.mask[10], _e373.mask[11], _e373.mask[12], _e373.mask[13], _e373.mask[14], _e373.mask[15], _e373.mask[16], _e373.mask[17], _e373.mask[18], _e373.mask[19], _e373.mask[20], _e373.mask[21], _e373.mask[22], _e373.mask[23], _e373.mask[24], _e373.mask[25], _e373.mask[26], _e373.mask[27], _e373.mask[28], _e373.mask[29], _e373.mask[30], _e373.mask[31]), _e373.len, _e373.group, _e373.group_mask);
                    let _e447 = local.group_mask;
                    if ((_e447 & 4278190080u) == 0u) {
                        let _e451 = local.len;
                        if (_e451 == 0u) {
                            phi_703_ = false;
                        } else {
                            let _e455 = local.len;
                            local.len = (_e455 - 1u);
                            let _e458 = local.len;
                            if (_e458 < 32u) {
                            } else {
                                return;
                            }
                            let _e463 = local.first[(0u + _e458)];
                            local.group = _e463;
                            let _e466 = local.len;
                            if (_e466 < 32u) {
                            } else {
                                return;
                            }
                            let _e471 = local.mask[(0u + _e466)];
                            local.group_mask = _e471;
                            phi_703_ = true;
                        }
                        let _e474 = phi_703_;
                        phi_704_ = _e474;
                    } else {
                        phi_704_ = true;
                    }
                    let _e476 = phi_704_;
                    if _e476 {
                        let _e478 = local.group_mask;
                        let _e484 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e478)), 32u, (_e478 == 0u)));
                        let _e488 = local.group_mask;
                        let _e502 = local.group_mask;
                        local.group_mask = (_e502 & ~((1u << bitcast<u32>((_e484 & 31u)))));
                        let _e505 = local.group;
                        phi_735_ = (_e505 + countOneBits(((_e488 & ~((4294967295u << bitcast<u32>((((_e484 - 24u) ^ 7u) & 31u))))) & 255u)));
                    } else {
                        phi_735_ = 4294967295u;
                    }
                    let _e508 = phi_735_;
                    phi_737_ = _e508;
                    loop {
                        let _e510 = phi_737_;
                        if (_e510 != 4294967295u) {
                            if (_e510 < _e61) {
                            } else {
                                return;
                            }
                            let _e519 = nodes.member[(0u + _e510)].frame[3u];
                            let _e544 = (bitcast<f32>((((_e519 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e249);
                            let _e545 = (bitcast<f32>((((_e519 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e261);
                            let _e546 = (bitcast<f32>((((_e519 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e273);
                            let _e549 = nodes.member[(0u + _e510)].frame[0u];
                            let _e553 = nodes.member[(0u + _e510)].frame[1u];
                            let _e557 = nodes.member[(0u + _e510)].frame[2u];
                            let _e565 = ((bitcast<f32>(_e549) - _e97.origin.x) * _e249);
                            let _e566 = ((bitcast<f32>(_e553) - _e97.origin.y) * _e261);
                            let _e567 = ((bitcast<f32>(_e557) - _e97.origin.z) * _e273);
                            let _e575 = nodes.member[(0u + _e510)].x;
                            if (_e249 < 0f) {
                                let _e586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e575.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e586.unnamed.root, _e575.w), _e586.unnamed_1);
                                let _e598 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e592.unnamed, lt_bvh_traverse_Tree(_e575.x, _e592.unnamed_1.first_primitive));
                                phi_823_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e598.unnamed, lt_bvh_traverse_Tree(_e598.unnamed_1.root, _e575.y));
                            } else {
                                let _e614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e575.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e614.unnamed.root, _e575.y), _e614.unnamed_1);
                                let _e626 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e620.unnamed, lt_bvh_traverse_Tree(_e575.z, _e620.unnamed_1.first_primitive));
                                phi_823_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e626.unnamed, lt_bvh_traverse_Tree(_e626.unnamed_1.root, _e575.w));
                            }
                            let _e634 = phi_823_;
                            let _e644 = nodes.member[(0u + _e510)].y;
                            if (_e261 < 0f) {
                                let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e644.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e655.unnamed.root, _e644.w), _e655.unnamed_1);
                                let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e661.unnamed, lt_bvh_traverse_Tree(_e644.x, _e661.unnamed_1.first_primitive));
                                phi_850_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e667.unnamed, lt_bvh_traverse_Tree(_e667.unnamed_1.root, _e644.y));
                            } else {
                                let _e683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e644.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e683.unnamed.root, _e644.y), _e683.unnamed_1);
                                let _e695 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e689.unnamed, lt_bvh_traverse_Tree(_e644.z, _e689.unnamed_1.first_primitive));
                                phi_850_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e695.unnamed, lt_bvh_traverse_Tree(_e695.unnamed_1.root, _e644.w));
                            }
                            let _e703 = phi_850_;
                            let _e713 = nodes.member[(0u + _e510)].z;
                            if (_e273 < 0f) {
                                let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e713.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e724.unnamed.root, _e713.w), _e724.unnamed_1);
                                let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e730.unnamed, lt_bvh_traverse_Tree(_e713.x, _e730.unnamed_1.first_primitive));
                                phi_877_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e736.unnamed, lt_bvh_traverse_Tree(_e736.unnamed_1.root, _e713.y));
                            } else {
                                let _e752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e713.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                let _e758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e752.unnamed.root, _e713.y), _e752.unnamed_1);
                                let _e764 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e758.unnamed, lt_bvh_traverse_Tree(_e713.z, _e758.unnamed_1.first_primitive));
                                phi_877_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e764.unnamed, lt_bvh_traverse_Tree(_e764.unnamed_1.root, _e713.w));
                            }
                            let _e772 = phi_877_;
                            phi_883_ = 0u;
                            phi_886_ = 0u;
                            loop {
                                let _e782 = phi_883_;
                                let _e784 = phi_886_;
                                local_2 = _e784;
                                local_3 = _e784;
                                local_4 = _e784;
                                let _e785 = (_e782 < 8u);
                                if _e785 {
                                    let _e787 = (_e782 >> bitcast<u32>(2i));
                                    let _e788 = (_e782 & 3u);
                                    if (_e787 == 0u) {
                                        phi_900_ = _e634.unnamed.root;
                                    } else {
                                        phi_900_ = _e634.unnamed.first_primitive;
                                    }
                                    let _e791 = phi_900_;
                                    if (_e787 == 0u) {
                                        phi_910_ = _e703.unnamed.root;
                                    } else {
                                        phi_910_ = _e703.unnamed.first_primitive;
                                    }
                                    let _e800 = phi_910_;
                                    if (_e787 == 0u) {
                                        phi_920_ = _e772.unnamed.root;
                                    } else {
                                        phi_920_ = _e772.unnamed.first_primitive;
                                    }
                                    let _e809 = phi_920_;
                                    let _e822 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e791 >> bitcast<u32>(((_e788 * 8u) & 31u))) & 255u)) * _e544) + (_e565 - _e310)), ((f32(((_e800 >> bitcast<u32>(((_e788 * 8u) & 31u))) & 255u)) * _e545) + (_e566 - _e311)));
                                    let _e823 = core_intrinsics_maximum_number_nsz_f32_(_e822, ((f32(((_e809 >> bitcast<u32>(((_e788 * 8u) & 31u))) & 255u)) * _e546) + (_e567 - _e312)));
                                    if (_e787 == 0u) {
                                        phi_938_ = _e634.unnamed_1.root;
                                    } else {
                                        phi_938_ = _e634.unnamed_1.first_primitive;
                                    }
                                    let _e826 = phi_938_;
                                    if (_e787 == 0u) {
                                        phi_948_ = _e703.unnamed_1.root;
                                    } else {
                                        phi_948_ = _e703.unnamed_1.first_primitive;
                                    }
                                    let _e835 = phi_948_;
                                    if (_e787 == 0u) {
                                        phi_958_ = _e772.unnamed_1.root;
                                    } else {
                                        phi_958_ = _e772.unnamed_1.first_primitive;
                                    }
                                    let _e844 = phi_958_;
                                    let _e857 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e826 >> bitcast<u32>(((_e788 * 8u) & 31u))) & 255u)) * _e544) + (_e565 + _e310)), ((f32(((_e835 >> bitcast<u32>(((_e788 * 8u) & 31u))) & 255u)) * _e545) + (_e566 + _e311)));
                                    let _e858 = core_intrinsics_minimum_number_nsz_f32_(_e857, ((f32(((_e844 >> bitcast<u32>(((_e788 * 8u) & 31u))) & 255u)) * _e546) + (_e567 + _e312)));
                                    if (_e823 <= _e858) {
                                        if (_e823 <= _e97.tmax) {
                                            if (_e858 >= _e97.tmin) {
                                                if (_e787 == 0u) {
                                                    let _e865 = nodes.member[(0u + _e510)].links[2u];
                                                    phi_994_ = _e865;
                                                } else {
                                                    let _e868 = nodes.member[(0u + _e510)].links[3u];
                                                    phi_994_ = _e868;
                                                }
                                                let _e870 = phi_994_;
                                                let _e875 = ((_e870 >> bitcast<u32>(((_e788 * 8u) & 31u))) & 255u);
                                                let _e876 = (_e875 & 31u);
                                                if (_e876 >= 24u) {
                                                    phi_1007_ = (24u + ((_e876 - 24u) ^ _e372));
                                                } else {
                                                    phi_1007_ = _e876;
                                                }
                                                let _e882 = phi_1007_;
                                                phi_1012_ = (_e784 | ((_e875 >> bitcast<u32>(5i)) << bitcast<u32>((_e882 & 31u))));
                                            } else {
                                                phi_1012_ = _e784;
                                            }
                                            let _e890 = phi_1012_;
                                            phi_1013_ = _e890;
                                        } else {
                                            phi_1013_ = _e784;
                                        }
                                        let _e892 = phi_1013_;
                                        phi_1014_ = _e892;
                                    } else {
                                        phi_1014_ = _e784;
                                    }
                                    let _e894 = phi_1014_;
                                    phi_884_ = (_e782 + 1u);
                                    phi_887_ = _e894;
                                } else {
                                    phi_884_ = u32();
                                    phi_887_ = u32();
                                }
                                let _e897 = phi_884_;
                                let _e899 = phi_887_;
                                continue;
                                continuing {
                                    phi_883_ = _e897;
                                    phi_886_ = _e899;
                                    break if !(_e785);
                                }
                            }
                            let _e903 = nodes.member[(0u + _e510)].links[0u];
                            let _e907 = nodes.member[(0u + _e510)].frame[3u];
                            let _e911 = local_2;
                            if ((_e911 & 4278190080u) == 0u) {
                            } else {
                                let _e915 = local.group_mask;
                                if ((_e915 & 4278190080u) == 0u) {
                                } else {
                                    let _e919 = local.len;
                                    if (_e919 < 32u) {
                                        let _e922 = local.group;
                                        let _e924 = local.len;
                                        if (_e924 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.first[(0u + _e924)] = _e922;
                                        let _e930 = local.group_mask;
                                        let _e932 = local.len;
                                        if (_e932 < 32u) {
                                        } else {
                                            return;
                                        }
                                        local.mask[(0u + _e932)] = _e930;
                                        let _e939 = local.len;
                                        local.len = (_e939 + 1u);
                                    }
                                }
                                local.group = (0u + _e903);
                                let _e943 = local_3;
                                local.group_mask = ((_e943 & 4278190080u) | (_e907 >> bitcast<u32>(24i)));
                            }
                            let _e948 = local_4;
                            phi_1072_ = (_e948 & 16777215u);
                            loop {
                                let _e951 = phi_1072_;
                                let _e952 = (_e951 == 0u);
                                local_5 = _e952;
                                local_9 = _e952;
                                if _e952 {
                                    phi_1073_ = u32();
                                    phi_1579_ = false;
                                    phi_1580_ = false;
                                    phi_1581_ = false;
                                } else {
                                    let _e955 = nodes.member[(0u + _e510)].links[1u];
                                    let _e960 = ((0u + _e955) + select(firstTrailingBit(_e951), 32u, (_e951 == 0u)));
                                    if (_e960 < arrayLength((&triangles.member))) {
                                    } else {
                                        return;
                                    }
                                    let _e967 = triangles.member[(0u + _e960)].v0_;
                                    let _e970 = (_e967.x - _e97.origin.x);
                                    let _e973 = (_e967.y - _e97.origin.y);
                                    let _e976 = (_e967.z - _e97.origin.z);
                                    if (_e337 == 0u) {
                                        phi_1120_ = vec3<f32>(_e973, _e976, _e970);
                                    } else {
                                        if (_e337 == 1u) {
                                            phi_1119_ = vec3<f32>(_e976, _e970, _e973);
                                        } else {
                                            phi_1119_ = (_e967 - _e97.origin);
                                        }
                                        let _e983 = phi_1119_;
                                        phi_1120_ = _e983;
                                    }
                                    let _e985 = phi_1120_;
                                    let _e989 = (_e985.x - (_e356 * _e985.z));
                                    let _e993 = (_e985.y - (_e359 * _e985.z));
                                    let _e997 = triangles.member[(0u + _e960)].v1_;
                                    let _e1000 = (_e997.x - _e97.origin.x);
                                    let _e1003 = (_e997.y - _e97.origin.y);
                                    let _e1006 = (_e997.z - _e97.origin.z);
                                    if (_e337 == 0u) {
                                        phi_1154_ = vec3<f32>(_e1003, _e1006, _e1000);
                                    } else {
                                        if (_e337 == 1u) {
                                            phi_1153_ = vec3<f32>(_e1006, _e1000, _e1003);
                                        } else {
                                            phi_1153_ = (_e997 - _e97.origin);
                                        }
                                        let _e1013 = phi_1153_;
                                        phi_1154_ = _e1013;
                                    }
                                    let _e1015 = phi_1154_;
                                    let _e1019 = (_e1015.x - (_e356 * _e1015.z));
                                    let _e1023 = (_e1015.y - (_e359 * _e1015.z));
                                    let _e1027 = triangles.member[(0u + _e960)].v2_;
                                    let _e1030 = (_e1027.x - _e97.origin.x);
                                    let _e1033 = (_e1027.y - _e97.origin.y);
                                    let _e1036 = (_e1027.z - _e97.origin.z);
                                    if (_e337 == 0u) {
                                        phi_1188_ = vec3<f32>(_e1033, _e1036, _e1030);
                                    } else {
                                        if (_e337 == 1u) {
                                            phi_1187_ = vec3<f32>(_e1036, _e1030, _e1033);
                                        } else {
                                            phi_1187_ = (_e1027 - _e97.origin);
                                        }
                                        let _e1043 = phi_1187_;
                                        phi_1188_ = _e1043;
                                    }
                                    let _e1045 = phi_1188_;
                                    let _e1049 = (_e1045.x - (_e356 * _e1045.z));
                                    let _e1053 = (_e1045.y - (_e359 * _e1045.z));
                                    if (_e1019 < _e1049) {
                                        phi_1209_ = true;
                                    } else {
                                        if (_e1019 == _e1049) {
                                            phi_1208_ = (_e1023 < _e1053);
                                        } else {
                                            phi_1208_ = false;
                                        }
                                        let _e1060 = phi_1208_;
                                        phi_1209_ = _e1060;
                                    }
                                    let _e1062 = phi_1209_;
                                    if _e1062 {
                                        phi_1213_ = _e1053;
                                        phi_1214_ = _e1049;
                                        phi_1215_ = _e1023;
                                        phi_1216_ = _e1019;
                                    } else {
                                        phi_1213_ = _e1023;
                                        phi_1214_ = _e1019;
                                        phi_1215_ = _e1053;
                                        phi_1216_ = _e1049;
                                    }
                                    let _e1064 = phi_1213_;
                                    let _e1066 = phi_1214_;
                                    let _e1068 = phi_1215_;
                                    let _e1070 = phi_1216_;
                                    let _e1073 = ((_e1070 * _e1064) - (_e1068 * _e1066));
                                    if _e1062 {
                                        phi_1224_ = -(_e1073);
                                    } else {
                                        phi_1224_ = _e1073;
                                    }
                                    let _e1076 = phi_1224_;
                                    if (_e1049 < _e989) {
                                        phi_1235_ = true;
                                    } else {
                                        if (_e1049 == _e989) {
                                            phi_1234_ = (_e1053 < _e993);
                                        } else {
                                            phi_1234_ = false;
                                        }
                                        let _e1081 = phi_1234_;
                                        phi_1235_ = _e1081;
                                    }
                                    let _e1083 = phi_1235_;
                                    if _e1083 {
                                        phi_1239_ = _e993;
                                        phi_1240_ = _e989;
                                        phi_1241_ = _e1053;
                                        phi_1242_ = _e1049;
                                    } else {
                                        phi_1239_ = _e1053;
                                        phi_1240_ = _e1049;
                                        phi_1241_ = _e993;
                                        phi_1242_ = _e989;
                                    }
                                    let _e1085 = phi_1239_;
                                    let _e1087 = phi_1240_;
                                    let _e1089 = phi_1241_;
                                    let _e1091 = phi_1242_;
                                    let _e1094 = ((_e1091 * _e1085) - (_e1089 * _e1087));
                                    if _e1083 {
                                        phi_1250_ = -(_e1094);
                                    } else {
                                        phi_1250_ = _e1094;
                                    }
                                    let _e1097 = phi_1250_;
                                    if (_e989 < _e1019) {
                                        phi_1261_ = true;
                                    } else {
                                        if (_e989 == _e1019) {
                                            phi_1260_ = (_e993 < _e1023);
                                        } else {
                                            phi_1260_ = false;
                                        }
                                        let _e1102 = phi_1260_;
                                        phi_1261_ = _e1102;
                                    }
                                    let _e1104 = phi_1261_;
                                    if _e1104 {
                                        phi_1265_ = _e1023;
                                        phi_1266_ = _e1019;
                                        phi_1267_ = _e993;
                                        phi_1268_ = _e989;
                                    } else {
                                        phi_1265_ = _e993;
                                        phi_1266_ = _e989;
                                        phi_1267_ = _e1023;
                                        phi_1268_ = _e1019;
                                    }
                                    let _e1106 = phi_1265_;
                                    let _e1108 = phi_1266_;
                                    let _e1110 = phi_1267_;
                                    let _e1112 = phi_1268_;
                                    let _e1115 = ((_e1112 * _e1106) - (_e1110 * _e1108));
                                    if _e1104 {
                                        phi_1276_ = -(_e1115);
                                    } else {
                                        phi_1276_ = _e1115;
                                    }
                                    let _e1118 = phi_1276_;
                                    if (_e1076 >= 0f) {
                                        if (_e1097 >= 0f) {
                                            if (_e1118 >= 0f) {
                                                phi_1291_ = ((_e1076 + _e1097) + _e1118);
                                                phi_1292_ = false;
                                            } else {
                                                phi_1291_ = f32();
                                                phi_1292_ = true;
                                            }
                                            let _e1125 = phi_1291_;
                                            let _e1127 = phi_1292_;
                                            phi_1293_ = _e1125;
                                            phi_1294_ = _e1127;
                                        } else {
                                            phi_1293_ = f32();
                                            phi_1294_ = true;
                                        }
                                        let _e1129 = phi_1293_;
                                        let _e1131 = phi_1294_;
                                        phi_1295_ = _e1129;
                                        phi_1296_ = _e1131;
                                    } else {
                                        phi_1295_ = f32();
                                        phi_1296_ = true;
                                    }
                                    let _e1133 = phi_1295_;
                                    let _e1135 = phi_1296_;
                                    if _e1135 {
                                        if (_e1076 <= 0f) {
                                            if (_e1097 <= 0f) {
                                                let _e1138 = (_e1118 <= 0f);
                                                if _e1138 {
                                                }
                                                phi_1314_ = ((_e1076 + _e1097) + _e1118);
                                                phi_1315_ = false;
                                                phi_1316_ = _e1138;
                                            } else {
                                                phi_1314_ = f32();
                                                phi_1315_ = true;
                                                phi_1316_ = false;
                                            }
                                            let _e1142 = phi_1314_;
                                            let _e1144 = phi_1315_;
                                            let _e1146 = phi_1316_;
                                            phi_1317_ = _e1142;
                                            phi_1318_ = _e1144;
                                            phi_1319_ = _e1146;
                                        } else {
                                            phi_1317_ = f32();
                                            phi_1318_ = true;
                                            phi_1319_ = false;
                                        }
                                        let _e1148 = phi_1317_;
                                        let _e1150 = phi_1318_;
                                        let _e1152 = phi_1319_;
                                        if _e1150 {
                                            phi_1323_ = false;
                                        } else {
                                            phi_1323_ = _e1152;
                                        }
                                        let _e1154 = phi_1323_;
                                        phi_1324_ = _e1148;
                                        phi_1325_ = _e1154;
                                    } else {
                                        phi_1324_ = _e1133;
                                        phi_1325_ = true;
                                    }
                                    let _e1156 = phi_1324_;
                                    let _e1158 = phi_1325_;
                                    if _e1158 {
                                        let _e1159 = (_e1156 == 0f);
                                        if _e1159 {
                                            phi_1529_ = lt_bvh_triangle_Intersection();
                                        } else {
                                            let _e1165 = ((((_e1076 * (_e361 * _e985.z)) + (_e1097 * (_e361 * _e1015.z))) + (_e1118 * (_e361 * _e1045.z))) / _e1156);
                                            let _e1167 = triangles.member[(0u + _e960)].v0_;
                                            let _e1169 = triangles.member[(0u + _e960)].v1_;
                                            if (_e1167.x < _e1169.x) {
                                                phi_1351_ = _e1167.x;
                                            } else {
                                                phi_1351_ = _e1169.x;
                                            }
                                            let _e1176 = phi_1351_;
                                            if (_e1167.y < _e1169.y) {
                                                phi_1360_ = _e1167.y;
                                            } else {
                                                phi_1360_ = _e1169.y;
                                            }
                                            let _e1183 = phi_1360_;
                                            if (_e1167.z < _e1169.z) {
                                                phi_1369_ = _e1167.z;
                                            } else {
                                                phi_1369_ = _e1169.z;
                                            }
                                            let _e1190 = phi_1369_;
                                            let _e1192 = triangles.member[(0u + _e960)].v2_;
                                            if (_e1176 < _e1192.x) {
                                                phi_1378_ = _e1176;
                                            } else {
                                                phi_1378_ = _e1192.x;
                                            }
                                            let _e1197 = phi_1378_;
                                            if (_e1183 < _e1192.y) {
                                                phi_1385_ = _e1183;
                                            } else {
                                                phi_1385_ = _e1192.y;
                                            }
                                            let _e1202 = phi_1385_;
                                            if (_e1190 < _e1192.z) {
                                                phi_1392_ = _e1190;
                                            } else {
                                                phi_1392_ = _e1192.z;
                                            }
                                            let _e1207 = phi_1392_;
                                            let _e1209 = triangles.member[(0u + _e960)].v0_;
                                            let _e1211 = triangles.member[(0u + _e960)].v1_;
                                            if (_e1209.x > _e1211.x) {
                                                phi_1405_ = _e1209.x;
                                            } else {
                                                phi_1405_ = _e1211.x;
                                            }
                                            let _e1218 = phi_1405_;
                                            if (_e1209.y > _e1211.y) {
                                                phi_1414_ = _e1209.y;
                                            } else {
                                                phi_1414_ = _e1211.y;
                                            }
                                            let _e1225 = phi_1414_;
                                            if (_e1209.z > _e1211.z) {
                                                phi_1423_ = _e1209.z;
                                            } else {
                                                phi_1423_ = _e1211.z;
                                            }
                                            let _e1232 = phi_1423_;
                                            let _e1234 = triangles.member[(0u + _e960)].v2_;
                                            if (_e1218 > _e1234.x) {
                                                phi_1432_ = _e1218;
                                            } else {
                                                phi_1432_ = _e1234.x;
                                            }
                                            let _e1239 = phi_1432_;
                                            if (_e1225 > _e1234.y) {
                                                phi_1439_ = _e1225;
                                            } else {
                                                phi_1439_ = _e1234.y;
                                            }
                                            let _e1244 = phi_1439_;
                                            if (_e1232 > _e1234.z) {
                                                phi_1446_ = _e1232;
                                            } else {
                                                phi_1446_ = _e1234.z;
                                            }
                                            let _e1249 = phi_1446_;
                                            let _e1256 = ((_e1197 - _e97.origin.x) * _e249);
                                            let _e1257 = ((_e1202 - _e97.origin.y) * _e261);
                                            let _e1258 = ((_e1207 - _e97.origin.z) * _e273);
                                            let _e1265 = ((_e1239 - _e97.origin.x) * _e249);
                                            let _e1266 = ((_e1244 - _e97.origin.y) * _e261);
                                            let _e1267 = ((_e1249 - _e97.origin.z) * _e273);
                                            if (_e1256 < _e1265) {
                                                phi_1469_ = _e1256;
                                            } else {
                                                phi_1469_ = _e1265;
                                            }
                                            let _e1270 = phi_1469_;
                                            if (_e1257 < _e1266) {
                                                phi_1474_ = _e1257;
                                            } else {
                                                phi_1474_ = _e1266;
                                            }
                                            let _e1273 = phi_1474_;
                                            if (_e1258 < _e1267) {
                                                phi_1479_ = _e1258;
                                            } else {
                                                phi_1479_ = _e1267;
                                            }
                                            let _e1276 = phi_1479_;
                                            if (_e1256 > _e1265) {
                                                phi_1487_ = _e1256;
                                            } else {
                                                phi_1487_ = _e1265;
                                            }
                                            let _e1282 = phi_1487_;
                                            if (_e1257 > _e1266) {
                                                phi_1492_ = _e1257;
                                            } else {
                                                phi_1492_ = _e1266;
                                            }
                                            let _e1285 = phi_1492_;
                                            if (_e1258 > _e1267) {
                                                phi_1497_ = _e1258;
                                            } else {
                                                phi_1497_ = _e1267;
                                            }
                                            let _e1288 = phi_1497_;
                                            let _e1292 = core_intrinsics_maximum_number_nsz_f32_((_e1270 - _e317), (_e1273 - _e318));
                                            let _e1293 = core_intrinsics_maximum_number_nsz_f32_(_e1292, (_e1276 - _e319));
                                            let _e1294 = core_intrinsics_minimum_number_nsz_f32_((_e1282 + _e317), (_e1285 + _e318));
                                            let _e1295 = core_intrinsics_minimum_number_nsz_f32_(_e1294, (_e1288 + _e319));
                                            if (_e1293 > -300000000000000000000000000000000000000f) {
                                                phi_1509_ = _e1293;
                                            } else {
                                                phi_1509_ = -300000000000000000000000000000000000000f;
                                            }
                                            let _e1298 = phi_1509_;
                                            if (_e1295 < 300000000000000000000000000000000000000f) {
                                                phi_1514_ = _e1295;
                                            } else {
                                                phi_1514_ = 300000000000000000000000000000000000000f;
                                            }
                                            let _e1301 = phi_1514_;
                                            if (_e1165 < _e1298) {
                                                phi_1519_ = _e1298;
                                            } else {
                                                phi_1519_ = _e1165;
                                            }
                                            let _e1304 = phi_1519_;
                                            if (_e1304 > _e1301) {
                                                phi_1524_ = _e1301;
                                            } else {
                                                phi_1524_ = _e1304;
                                            }
                                            let _e1307 = phi_1524_;
                                            phi_1529_ = lt_bvh_triangle_Intersection(_e1307, (_e1097 / _e1156), (_e1118 / _e1156), (_e1298 <= _e1301));
                                        }
                                        let _e1313 = phi_1529_;
                                        phi_1530_ = _e1313;
                                        phi_1531_ = _e1159;
                                    } else {
                                        phi_1530_ = lt_bvh_triangle_Intersection();
                                        phi_1531_ = true;
                                    }
                                    let _e1315 = phi_1530_;
                                    let _e1317 = phi_1531_;
                                    if _e1317 {
                                        phi_1535_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                    } else {
                                        phi_1535_ = _e1315;
                                    }
                                    let _e1319 = phi_1535_;
                                    if _e1319.is_hit {
                                        if (_e1319.t > _e97.tmin) {
                                            if (_e1319.t < _e97.tmax) {
                                                let _e1328 = triangles.member[(0u + _e960)].i0_;
                                                let _e1330 = ((_e1328 & 2147483648u) == 0u);
                                                if _e1330 {
                                                    phi_1563_ = false;
                                                    phi_1564_ = false;
                                                } else {
                                                    if true {
                                                        phi_1562_ = false;
                                                    } else {
                                                        phi_1562_ = true;
                                                    }
                                                    let _e1332 = phi_1562_;
                                                    phi_1563_ = _e1332;
                                                    phi_1564_ = true;
                                                }
                                                let _e1334 = phi_1563_;
                                                let _e1336 = phi_1564_;
                                                phi_1565_ = _e1334;
                                                phi_1566_ = _e1330;
                                                phi_1567_ = _e1336;
                                            } else {
                                                phi_1565_ = true;
                                                phi_1566_ = false;
                                                phi_1567_ = false;
                                            }
                                            let _e1338 = phi_1565_;
                                            let _e1340 = phi_1566_;
                                            let _e1342 = phi_1567_;
                                            phi_1568_ = _e1338;
                                            phi_1569_ = _e1340;
                                            phi_1570_ = _e1342;
                                        } else {
                                            phi_1568_ = true;
                                            phi_1569_ = false;
                                            phi_1570_ = false;
                                        }
                                        let _e1344 = phi_1568_;
                                        let _e1346 = phi_1569_;
                                        let _e1348 = phi_1570_;
                                        phi_1571_ = _e1344;
                                        phi_1572_ = _e1346;
                                        phi_1573_ = _e1348;
                                    } else {
                                        phi_1571_ = true;
                                        phi_1572_ = false;
                                        phi_1573_ = false;
                                    }
                                    let _e1350 = phi_1571_;
                                    let _e1352 = phi_1572_;
                                    let _e1354 = phi_1573_;
                                    if _e1350 {
                                        phi_1577_ = false;
                                        phi_1578_ = false;
                                    } else {
                                        phi_1577_ = _e1352;
                                        phi_1578_ = _e1354;
                                    }
                                    let _e1356 = phi_1577_;
                                    let _e1358 = phi_1578_;
                                    phi_1073_ = (_e951 & (_e951 - 1u));
                                    phi_1579_ = _e1350;
                                    phi_1580_ = _e1356;
                                    phi_1581_ = _e1358;
                                }
                                let _e1360 = phi_1073_;
                                let _e1362 = phi_1579_;
                                let _e1364 = phi_1580_;
                                let _e1366 = phi_1581_;
                                local_7 = _e1364;
                                local_8 = _e1366;
                                continue;
                                continuing {
                                    phi_1072_ = _e1360;
                                    break if !(_e1362);
                                }
                            }
                            let _e1369 = local_5;
                            if _e1369 {
                                let _e1371 = local.group_mask;
                                if ((_e1371 & 4278190080u) == 0u) {
                                    let _e1375 = local.len;
                                    if (_e1375 == 0u) {
                                        phi_1623_ = false;
                                    } else {
                                        let _e1379 = local.len;
                                        local.len = (_e1379 - 1u);
                                        let _e1382 = local.len;
                                        if (_e1382 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1387 = local.first[(0u + _e1382)];
                                        local.group = _e1387;
                                        let _e1390 = local.len;
                                        if (_e1390 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1395 = local.mask[(0u + _e1390)];
                                        local.group_mask = _e1395;
                                        phi_1623_ = true;
                                    }
                                    let _e1398 = phi_1623_;
                                    phi_1624_ = _e1398;
                                } else {
                                    phi_1624_ = true;
                                }
                                let _e1400 = phi_1624_;
                                if _e1400 {
                                    let _e1402 = local.group_mask;
                                    let _e1408 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1402)), 32u, (_e1402 == 0u)));
                                    let _e1412 = local.group_mask;
                                    let _e1426 = local.group_mask;
                                    local.group_mask = (_e1426 & ~((1u << bitcast<u32>((_e1408 & 31u)))));
                                    let _e1429 = local.group;
                                    phi_1655_ = (_e1429 + countOneBits(((_e1412 & ~((4294967295u << bitcast<u32>((((_e1408 - 24u) ^ _e372) & 31u))))) & 255u)));
                                } else {
                                    phi_1655_ = 4294967295u;
                                }
                                let _e1432 = phi_1655_;
                                phi_1656_ = _e1432;
                                phi_1657_ = false;
                                phi_1658_ = false;
                            } else {
                                phi_1656_ = u32();
                                let _e1635 = local_7;
                                phi_1657_ = _e1635;
                                let _e1638 = local_8;
                                phi_1658_ = _e1638;
                            }
                            let _e1434 = phi_1656_;
                            let _e1436 = phi_1657_;
                            let _e1438 = phi_1658_;
                            phi_738_ = _e1434;
                            let _e1642 = local_9;
                            phi_1659_ = _e1642;
                            phi_1660_ = false;
                            phi_1661_ = _e1436;
                            phi_1662_ = _e1438;
                        } else {
                            phi_738_ = u32();
                            phi_1659_ = false;
                            phi_1660_ = true;
                            phi_1661_ = false;
                            phi_1662_ = false;
                        }
                        let _e1440 = phi_738_;
                        let _e1442 = phi_1659_;
                        let _e1444 = phi_1660_;
                        let _e1446 = phi_1661_;
                        let _e1448 = phi_1662_;
                        local_6 = _e1444;
                        local_10 = _e1446;
                        local_11 = _e1448;
                        continue;
                        continuing {
                            phi_737_ = _e1440;
                            break if !(_e1442);
                        }
                    }
                    let _e1451 = local_6;
                    if _e1451 {
                        phi_1666_ = false;
                        phi_1667_ = false;
                    } else {
                        let _e1649 = local_10;
                        phi_1666_ = _e1649;
                        let _e1652 = local_11;
                        phi_1667_ = _e1652;
                    }
                    let _e1453 = phi_1666_;
                    let _e1455 = phi_1667_;
                    if _e1453 {
                        phi_1671_ = true;
                    } else {
                        phi_1671_ = _e1455;
                    }
                    let _e1457 = phi_1671_;
                    if _e1457 {
                        phi_1675_ = true;
                    } else {
                        phi_1675_ = false;
                    }
                    let _e1459 = phi_1675_;
                    phi_1676_ = _e1459;
                }
                let _e1461 = phi_1676_;
                phi_1677_ = _e1461;
                phi_1678_ = _e167;
            } else {
                phi_1677_ = bool();
                phi_1678_ = true;
            }
            let _e1463 = phi_1677_;
            let _e1465 = phi_1678_;
            if _e1465 {
                phi_1682_ = false;
            } else {
                phi_1682_ = _e1463;
            }
            let _e1467 = phi_1682_;
            if _e1467 {
                phi_1686_ = 0f;
            } else {
                phi_1686_ = 1f;
            }
            let _e1469 = phi_1686_;
            phi_1687_ = _e1469;
        }
        let _e1471 = phi_1687_;
        if (_e73.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e73.first_primitive)] = _e1471;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_resolve_resolve_all_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
