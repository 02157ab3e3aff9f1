struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
    member: array<f32>,
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

struct type_36 {
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

struct type_40 {
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
var<storage> samples: type_19;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(5) 
var<storage> list: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_148_: bool;
    var phi_152_: f32;

    if (param != param) {
        phi_148_ = true;
    } else {
        let _e52 = (param_1 >= param);
        if _e52 {
        }
        phi_148_ = _e52;
    }
    let _e54 = phi_148_;
    if _e54 {
        phi_152_ = param_1;
    } else {
        phi_152_ = param;
    }
    let _e56 = phi_152_;
    return _e56;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_164_: bool;
    var phi_168_: f32;

    if (param_2 != param_2) {
        phi_164_ = true;
    } else {
        let _e52 = (param_3 <= param_2);
        if _e52 {
        }
        phi_164_ = _e52;
    }
    let _e54 = phi_164_;
    if _e54 {
        phi_168_ = param_3;
    } else {
        phi_168_ = param_2;
    }
    let _e56 = phi_168_;
    return _e56;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_243_: f32;
    var phi_274_: bool;
    var phi_275_: bool;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_281_: bool;
    var phi_294_: bool;
    var phi_295_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_301_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_320_: bool;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_328_: bool;
    var phi_398_: f32;
    var phi_405_: f32;
    var phi_412_: f32;
    var phi_419_: f32;
    var phi_426_: f32;
    var phi_433_: f32;
    var phi_450_: f32;
    var phi_455_: f32;
    var phi_460_: f32;
    var phi_465_: f32;
    var phi_470_: f32;
    var phi_496_: bool;
    var phi_497_: bool;
    var phi_505_: u32;
    var phi_506_: u32;
    var phi_517_: vec3<f32>;
    var phi_518_: vec3<f32>;
    var phi_531_: u32;
    var phi_536_: u32;
    var phi_541_: u32;
    var phi_655_: bool;
    var phi_656_: bool;
    var phi_687_: u32;
    var phi_689_: u32;
    var phi_692_: bool;
    var phi_772_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_799_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_826_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_832_: u32;
    var phi_835_: u32;
    var phi_849_: u32;
    var phi_859_: u32;
    var phi_869_: u32;
    var phi_887_: u32;
    var phi_897_: u32;
    var phi_907_: u32;
    var phi_943_: u32;
    var phi_956_: u32;
    var phi_961_: u32;
    var phi_962_: u32;
    var phi_963_: u32;
    var phi_833_: u32;
    var phi_836_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1021_: u32;
    var phi_1024_: bool;
    var phi_1068_: vec3<f32>;
    var phi_1069_: vec3<f32>;
    var phi_1098_: vec3<f32>;
    var phi_1099_: vec3<f32>;
    var phi_1128_: vec3<f32>;
    var phi_1129_: vec3<f32>;
    var phi_1147_: bool;
    var phi_1148_: bool;
    var phi_1152_: f32;
    var phi_1153_: f32;
    var phi_1154_: f32;
    var phi_1155_: f32;
    var phi_1163_: f32;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1178_: f32;
    var phi_1179_: f32;
    var phi_1180_: f32;
    var phi_1181_: f32;
    var phi_1189_: f32;
    var phi_1199_: bool;
    var phi_1200_: bool;
    var phi_1204_: f32;
    var phi_1205_: f32;
    var phi_1206_: f32;
    var phi_1207_: f32;
    var phi_1215_: f32;
    var phi_1230_: f32;
    var phi_1231_: bool;
    var phi_1232_: f32;
    var phi_1233_: bool;
    var phi_1234_: f32;
    var phi_1235_: bool;
    var phi_1253_: f32;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1256_: f32;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1262_: bool;
    var phi_1263_: f32;
    var phi_1264_: bool;
    var phi_1292_: vec3<f32>;
    var phi_1293_: vec3<f32>;
    var phi_1318_: vec3<f32>;
    var phi_1319_: vec3<f32>;
    var phi_1344_: vec3<f32>;
    var phi_1345_: vec3<f32>;
    var phi_1401_: f32;
    var phi_1410_: f32;
    var phi_1419_: f32;
    var phi_1428_: f32;
    var phi_1435_: f32;
    var phi_1442_: f32;
    var phi_1455_: f32;
    var phi_1464_: f32;
    var phi_1473_: f32;
    var phi_1482_: f32;
    var phi_1489_: f32;
    var phi_1496_: f32;
    var phi_1513_: f32;
    var phi_1518_: f32;
    var phi_1523_: f32;
    var phi_1531_: f32;
    var phi_1536_: f32;
    var phi_1541_: f32;
    var phi_1553_: f32;
    var phi_1558_: f32;
    var phi_1563_: f32;
    var phi_1568_: f32;
    var phi_1573_: lt_bvh_triangle_Intersection;
    var phi_1574_: bool;
    var phi_1575_: lt_bvh_triangle_Intersection;
    var phi_1576_: bool;
    var phi_1580_: lt_bvh_triangle_Intersection;
    var phi_1581_: bool;
    var phi_1582_: lt_bvh_triangle_Intersection;
    var phi_1583_: bool;
    var phi_1584_: bool;
    var phi_1588_: bool;
    var phi_1592_: lt_bvh_triangle_Intersection;
    var phi_1612_: bool;
    var phi_1613_: bool;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1022_: u32;
    var phi_1025_: bool;
    var phi_1622_: bool;
    var local_4: bool;
    var phi_1664_: bool;
    var phi_1665_: bool;
    var phi_1696_: u32;
    var phi_1697_: u32;
    var phi_690_: u32;
    var phi_693_: bool;
    var phi_1698_: bool;
    var phi_1699_: bool;
    var local_5: bool;
    var phi_1703_: bool;
    var phi_1707_: bool;
    var phi_1708_: bool;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var phi_1714_: bool;
    var phi_1718_: f32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;

    let _e50 = id_1;
    let _e57 = arrayLength((&nodes.member));
    let _e66 = arrayLength((&list.member));
    let _e70 = ((_e50.y * 2097152u) + _e50.x);
    if (3u < _e66) {
    } else {
        return;
    }
    let _e73 = list.member[3u];
    if (_e70 < _e73) {
        let _e75 = (_e70 + 4u);
        if (_e75 < _e66) {
        } else {
            return;
        }
        let _e79 = list.member[(0u + _e75)];
        if (_e79 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e85 = samples.member[(0u + _e79)].position;
        let _e87 = samples.member[(0u + _e79)].normal;
        let _e89 = samples.member[(0u + _e79)].magnitude;
        let _e91 = ((8f / 8388608f) * _e89);
        let _e99 = (_e85.x + (_e87.x * _e91));
        let _e101 = (_e85.y + (_e87.y * _e91));
        let _e103 = (_e85.z + (_e87.z * _e91));
        let _e105 = p.member.light.place;
        if (_e105.w == 0f) {
            phi_243_ = 300000000000000000000000000000000000000f;
        } else {
            phi_243_ = 1f;
        }
        let _e109 = phi_243_;
        let _e117 = (_e105.x - (_e99 * _e105.w));
        let _e118 = (_e105.y - (_e101 * _e105.w));
        let _e119 = (_e105.z - (_e103 * _e105.w));
        let _e121 = abs(_e117);
        let _e122 = abs(_e118);
        let _e123 = abs(_e119);
        if (abs(_e99) < 1000000000000000f) {
            if (abs(_e101) < 1000000000000000f) {
                phi_274_ = (abs(_e103) < 1000000000000000f);
                phi_275_ = false;
            } else {
                phi_274_ = bool();
                phi_275_ = true;
            }
            let _e131 = phi_274_;
            let _e133 = phi_275_;
            phi_276_ = _e131;
            phi_277_ = _e133;
        } else {
            phi_276_ = bool();
            phi_277_ = true;
        }
        let _e135 = phi_276_;
        let _e137 = phi_277_;
        if _e137 {
            phi_281_ = false;
        } else {
            phi_281_ = _e135;
        }
        let _e139 = phi_281_;
        if _e139 {
            if (_e121 < 1000000000000000f) {
                if (_e122 < 1000000000000000f) {
                    phi_294_ = (_e123 < 1000000000000000f);
                    phi_295_ = false;
                } else {
                    phi_294_ = bool();
                    phi_295_ = true;
                }
                let _e144 = phi_294_;
                let _e146 = phi_295_;
                phi_296_ = _e144;
                phi_297_ = _e146;
            } else {
                phi_296_ = bool();
                phi_297_ = true;
            }
            let _e148 = phi_296_;
            let _e150 = phi_297_;
            if _e150 {
                phi_301_ = false;
            } else {
                phi_301_ = _e148;
            }
            let _e152 = phi_301_;
            if _e152 {
                if (_e121 > 0f) {
                    phi_315_ = bool();
                    phi_316_ = true;
                } else {
                    let _e154 = (_e122 > 0f);
                    if _e154 {
                        phi_314_ = bool();
                    } else {
                        phi_314_ = (_e123 > 0f);
                    }
                    let _e157 = phi_314_;
                    phi_315_ = _e157;
                    phi_316_ = _e154;
                }
                let _e159 = phi_315_;
                let _e161 = phi_316_;
                if _e161 {
                    phi_320_ = true;
                } else {
                    phi_320_ = _e159;
                }
                let _e163 = phi_320_;
                phi_321_ = _e163;
                phi_322_ = false;
            } else {
                phi_321_ = bool();
                phi_322_ = true;
            }
            let _e165 = phi_321_;
            let _e167 = phi_322_;
            phi_323_ = _e165;
            phi_324_ = _e167;
        } else {
            phi_323_ = bool();
            phi_324_ = true;
        }
        let _e169 = phi_323_;
        let _e171 = phi_324_;
        if _e171 {
            phi_328_ = false;
        } else {
            phi_328_ = _e169;
        }
        let _e173 = phi_328_;
        if _e173 {
            let _e174 = (0u >= _e57);
            if _e174 {
                phi_1708_ = bool();
            } else {
                if (0u < _e57) {
                } else {
                    return;
                }
                let _e180 = nodes.member[(0u + 0u)].frame[0u];
                let _e184 = nodes.member[(0u + 0u)].frame[1u];
                let _e188 = nodes.member[(0u + 0u)].frame[2u];
                let _e192 = nodes.member[(0u + 0u)].frame[0u];
                let _e196 = nodes.member[(0u + 0u)].frame[1u];
                let _e200 = nodes.member[(0u + 0u)].frame[2u];
                let _e204 = nodes.member[(0u + 0u)].frame[3u];
                let _e238 = core_intrinsics_maximum_number_nsz_f32_(abs(_e117), abs(_e118));
                let _e239 = core_intrinsics_maximum_number_nsz_f32_(_e238, abs(_e119));
                let _e240 = (_e239 * 0.0000000000009094947f);
                if (abs(_e117) < _e240) {
                    phi_398_ = _e240;
                } else {
                    phi_398_ = abs(_e117);
                }
                let _e245 = phi_398_;
                if (_e117 < 0f) {
                    phi_405_ = (-1f / _e245);
                } else {
                    phi_405_ = (1f / _e245);
                }
                let _e250 = phi_405_;
                if (abs(_e118) < _e240) {
                    phi_412_ = _e240;
                } else {
                    phi_412_ = abs(_e118);
                }
                let _e255 = phi_412_;
                if (_e118 < 0f) {
                    phi_419_ = (-1f / _e255);
                } else {
                    phi_419_ = (1f / _e255);
                }
                let _e260 = phi_419_;
                if (abs(_e119) < _e240) {
                    phi_426_ = _e240;
                } else {
                    phi_426_ = abs(_e119);
                }
                let _e265 = phi_426_;
                if (_e119 < 0f) {
                    phi_433_ = (-1f / _e265);
                } else {
                    phi_433_ = (1f / _e265);
                }
                let _e270 = phi_433_;
                let _e274 = abs((bitcast<f32>(_e180) - _e99));
                let _e275 = abs((bitcast<f32>(_e184) - _e101));
                let _e276 = abs((bitcast<f32>(_e188) - _e103));
                let _e280 = abs(((bitcast<f32>(_e192) + (bitcast<f32>((((_e204 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e99));
                let _e281 = abs(((bitcast<f32>(_e196) + (bitcast<f32>((((_e204 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e101));
                let _e282 = abs(((bitcast<f32>(_e200) + (bitcast<f32>((((_e204 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e103));
                if (_e274 > _e280) {
                    phi_450_ = _e274;
                } else {
                    phi_450_ = _e280;
                }
                let _e285 = phi_450_;
                if (_e275 > _e281) {
                    phi_455_ = _e275;
                } else {
                    phi_455_ = _e281;
                }
                let _e288 = phi_455_;
                if (_e276 > _e282) {
                    phi_460_ = _e276;
                } else {
                    phi_460_ = _e282;
                }
                let _e291 = phi_460_;
                if (_e285 > _e288) {
                    phi_465_ = _e285;
                } else {
                    phi_465_ = _e288;
                }
                let _e294 = phi_465_;
                if (_e294 > _e291) {
                    phi_470_ = _e294;
                } else {
                    phi_470_ = _e291;
                }
                let _e297 = phi_470_;
                let _e301 = (_e297 * 0.0000019073486f);
                let _e302 = (abs(_e250) * _e301);
                let _e303 = (abs(_e260) * _e301);
                let _e304 = (abs(_e270) * _e301);
                let _e308 = (_e297 * 0.0000009536743f);
                let _e309 = (abs(_e250) * _e308);
                let _e310 = (abs(_e260) * _e308);
                let _e311 = (abs(_e270) * _e308);
                let _e312 = abs(_e117);
                let _e313 = abs(_e118);
                let _e314 = abs(_e119);
                if (_e312 >= _e313) {
                    if (_e312 >= _e314) {
                        phi_496_ = false;
                    } else {
                        phi_496_ = true;
                    }
                    let _e318 = phi_496_;
                    phi_497_ = _e318;
                } else {
                    phi_497_ = true;
                }
                let _e320 = phi_497_;
                if _e320 {
                    if (_e313 >= _e314) {
                        phi_505_ = 1u;
                    } else {
                        phi_505_ = 2u;
                    }
                    let _e323 = phi_505_;
                    phi_506_ = _e323;
                } else {
                    phi_506_ = 0u;
                }
                let _e325 = phi_506_;
                if (_e325 == 0u) {
                    phi_518_ = vec3<f32>(_e118, _e119, _e117);
                } else {
                    if (_e325 == 1u) {
                        phi_517_ = vec3<f32>(_e119, _e117, _e118);
                    } else {
                        phi_517_ = vec3<f32>(_e117, _e118, _e119);
                    }
                    let _e331 = phi_517_;
                    phi_518_ = _e331;
                }
                let _e333 = phi_518_;
                let _e336 = (_e333.x / _e333.z);
                let _e339 = (_e333.y / _e333.z);
                if (_e250 < 0f) {
                    phi_531_ = 0u;
                } else {
                    phi_531_ = 1u;
                }
                let _e344 = phi_531_;
                if (_e260 < 0f) {
                    phi_536_ = 0u;
                } else {
                    phi_536_ = 2u;
                }
                let _e347 = phi_536_;
                if (_e270 < 0f) {
                    phi_541_ = 0u;
                } else {
                    phi_541_ = 4u;
                }
                let _e350 = phi_541_;
                let _e352 = ((_e344 | _e347) | _e350);
                let _e353 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e353.first[0], _e353.first[1], _e353.first[2], _e353.first[3], _e353.first[4], _e353.first[5], _e353.first[6], _e353.first[7], _e353.first[8], _e353.first[9], _e353.first[10], _e353.first[11], _e353.first[12], _e353.first[13], _e353.first[14], _e353.first[15], _e353.first[16], _e353.first[17], _e353.first[18], _e353.first[19], _e353.first[20], _e353.first[21], _e353.first[22], _e353.first[23], _e353.first[24], _e353.first[25], _e353.first[26], _e353.first[27], _e353.first[28], _e353.first[29], _e353.first[30], _e353.first[31]), array<u32, 32>(_e353.mask[0], _e353.mask[1], _e353.mask[2], _e353.mask[3], _e353.mask[4], _e353.mask[5], _e353.mask[6], _e353.mask[7], _e353.mask[8], _e353.mask[9], _e353.mask[10], _e353.mask[11], _e353.mask[12], _e353.mask[13], _e353.mask[14], _e353.mask[15], _e353.mask[16], _e353.mask[17], _e353.mask[18], _e353.mask[19], _e353.mask[20], _e353.mask[21], _e353.mask[22], _e353.mask[23], _e353.mask[24], _e353.mask[25], _e353.mask[26], _e353.mask[27], _e353.mask[28], _e353.mask[29], _e353.mask[30], _e353.mask[31]), _e353.len, _e353.group, _e353.group_mask);
                let _e427 = local.group_mask;
                if ((_e427 & 4278190080u) == 0u) {
                    let _e431 = local.len;
                    if (_e431 == 0u) {
                        phi_655_ = false;
                    } else {
                        let _e435 = local.len;
                        local.len = (_e435 - 1u);
                        let _e438 = local.len;
                        if (_e438 < 32u) {
                        } else {
                            return;
                        }
                        let _e443 = local.first[(0u + _e438)];
                        local.group = _e443;
                        let _e446 = local.len;
                        if (_e446 < 32u) {
                        } else {
                            return;
                        }
                        let _e451 = local.mask[(0u + _e446)];
                        local.group_mask = _e451;
                        phi_655_ = true;
                    }
                    let _e454 = phi_655_;
                    phi_656_ = _e454;
                } else {
                    phi_656_ = true;
                }
                let _e456 = phi_656_;
                if _e456 {
                    let _e458 = local.group_mask;
                    let _e464 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e458)), 32u, (_e458 == 0u)));
                    let _e468 = local.group_mask;
                    let _e482 = local.group_mask;
                    local.group_mask = (_e482 & ~((1u << bitcast<u32>((_e464 & 31u)))));
                    let _e485 = local.group;
                    phi_687_ = (_e485 + countOneBits(((_e468 & ~((4294967295u << bitcast<u32>((((_e464 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_687_ = 4294967295u;
                }
                let _e488 = phi_687_;
                phi_689_ = _e488;
                phi_692_ = false;
                loop {
                    let _e490 = phi_689_;
                    let _e492 = phi_692_;
                    local_8 = _e492;
                    if (_e490 != 4294967295u) {
                        if (_e490 < _e57) {
                        } else {
                            return;
                        }
                        let _e499 = nodes.member[(0u + _e490)].frame[3u];
                        let _e524 = (bitcast<f32>((((_e499 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e250);
                        let _e525 = (bitcast<f32>((((_e499 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e260);
                        let _e526 = (bitcast<f32>((((_e499 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e270);
                        let _e529 = nodes.member[(0u + _e490)].frame[0u];
                        let _e533 = nodes.member[(0u + _e490)].frame[1u];
                        let _e537 = nodes.member[(0u + _e490)].frame[2u];
                        let _e542 = ((bitcast<f32>(_e529) - _e99) * _e250);
                        let _e543 = ((bitcast<f32>(_e533) - _e101) * _e260);
                        let _e544 = ((bitcast<f32>(_e537) - _e103) * _e270);
                        let _e552 = nodes.member[(0u + _e490)].x;
                        if (_e250 < 0f) {
                            let _e563 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e552.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e569 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e563.unnamed.root, _e552.w), _e563.unnamed_1);
                            let _e575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e569.unnamed, lt_bvh_traverse_Tree(_e552.x, _e569.unnamed_1.first_primitive));
                            phi_772_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e575.unnamed, lt_bvh_traverse_Tree(_e575.unnamed_1.root, _e552.y));
                        } else {
                            let _e591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e552.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e591.unnamed.root, _e552.y), _e591.unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e597.unnamed, lt_bvh_traverse_Tree(_e552.z, _e597.unnamed_1.first_primitive));
                            phi_772_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_bvh_traverse_Tree(_e603.unnamed_1.root, _e552.w));
                        }
                        let _e611 = phi_772_;
                        let _e621 = nodes.member[(0u + _e490)].y;
                        if (_e260 < 0f) {
                            let _e632 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e621.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e638 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e632.unnamed.root, _e621.w), _e632.unnamed_1);
                            let _e644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e638.unnamed, lt_bvh_traverse_Tree(_e621.x, _e638.unnamed_1.first_primitive));
                            phi_799_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e644.unnamed, lt_bvh_traverse_Tree(_e644.unnamed_1.root, _e621.y));
                        } else {
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e621.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e660.unnamed.root, _e621.y), _e660.unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_bvh_traverse_Tree(_e621.z, _e666.unnamed_1.first_primitive));
                            phi_799_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e672.unnamed_1.root, _e621.w));
                        }
                        let _e680 = phi_799_;
                        let _e690 = nodes.member[(0u + _e490)].z;
                        if (_e270 < 0f) {
                            let _e701 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e690.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e707 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e701.unnamed.root, _e690.w), _e701.unnamed_1);
                            let _e713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e707.unnamed, lt_bvh_traverse_Tree(_e690.x, _e707.unnamed_1.first_primitive));
                            phi_826_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e713.unnamed, lt_bvh_traverse_Tree(_e713.unnamed_1.root, _e690.y));
                        } else {
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e690.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e729.unnamed.root, _e690.y), _e729.unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_bvh_traverse_Tree(_e690.z, _e735.unnamed_1.first_primitive));
                            phi_826_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e741.unnamed_1.root, _e690.w));
                        }
                        let _e749 = phi_826_;
                        phi_832_ = 0u;
                        phi_835_ = 0u;
                        loop {
                            let _e759 = phi_832_;
                            let _e761 = phi_835_;
                            local_1 = _e761;
                            local_2 = _e761;
                            local_3 = _e761;
                            let _e762 = (_e759 < 8u);
                            if _e762 {
                                let _e764 = (_e759 >> bitcast<u32>(2i));
                                let _e765 = (_e759 & 3u);
                                if (_e764 == 0u) {
                                    phi_849_ = _e611.unnamed.root;
                                } else {
                                    phi_849_ = _e611.unnamed.first_primitive;
                                }
                                let _e768 = phi_849_;
                                if (_e764 == 0u) {
                                    phi_859_ = _e680.unnamed.root;
                                } else {
                                    phi_859_ = _e680.unnamed.first_primitive;
                                }
                                let _e777 = phi_859_;
                                if (_e764 == 0u) {
                                    phi_869_ = _e749.unnamed.root;
                                } else {
                                    phi_869_ = _e749.unnamed.first_primitive;
                                }
                                let _e786 = phi_869_;
                                let _e799 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e768 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e524) + (_e542 - _e302)), ((f32(((_e777 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e525) + (_e543 - _e303)));
                                let _e800 = core_intrinsics_maximum_number_nsz_f32_(_e799, ((f32(((_e786 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e304)));
                                if (_e764 == 0u) {
                                    phi_887_ = _e611.unnamed_1.root;
                                } else {
                                    phi_887_ = _e611.unnamed_1.first_primitive;
                                }
                                let _e803 = phi_887_;
                                if (_e764 == 0u) {
                                    phi_897_ = _e680.unnamed_1.root;
                                } else {
                                    phi_897_ = _e680.unnamed_1.first_primitive;
                                }
                                let _e812 = phi_897_;
                                if (_e764 == 0u) {
                                    phi_907_ = _e749.unnamed_1.root;
                                } else {
                                    phi_907_ = _e749.unnamed_1.first_primitive;
                                }
                                let _e821 = phi_907_;
                                let _e834 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e803 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e524) + (_e542 + _e302)), ((f32(((_e812 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e525) + (_e543 + _e303)));
                                let _e835 = core_intrinsics_minimum_number_nsz_f32_(_e834, ((f32(((_e821 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e304)));
                                if (_e800 <= _e835) {
                                    if (_e800 <= _e109) {
                                        if (_e835 >= 0f) {
                                            if (_e764 == 0u) {
                                                let _e842 = nodes.member[(0u + _e490)].links[2u];
                                                phi_943_ = _e842;
                                            } else {
                                                let _e845 = nodes.member[(0u + _e490)].links[3u];
                                                phi_943_ = _e845;
                                            }
                                            let _e847 = phi_943_;
                                            let _e852 = ((_e847 >> bitcast<u32>(((_e765 * 8u) & 31u))) & 255u);
                                            let _e853 = (_e852 & 31u);
                                            if (_e853 >= 24u) {
                                                phi_956_ = (24u + ((_e853 - 24u) ^ _e352));
                                            } else {
                                                phi_956_ = _e853;
                                            }
                                            let _e859 = phi_956_;
                                            phi_961_ = (_e761 | ((_e852 >> bitcast<u32>(5i)) << bitcast<u32>((_e859 & 31u))));
                                        } else {
                                            phi_961_ = _e761;
                                        }
                                        let _e867 = phi_961_;
                                        phi_962_ = _e867;
                                    } else {
                                        phi_962_ = _e761;
                                    }
                                    let _e869 = phi_962_;
                                    phi_963_ = _e869;
                                } else {
                                    phi_963_ = _e761;
                                }
                                let _e871 = phi_963_;
                                phi_833_ = (_e759 + 1u);
                                phi_836_ = _e871;
                            } else {
                                phi_833_ = u32();
                                phi_836_ = u32();
                            }
                            let _e874 = phi_833_;
                            let _e876 = phi_836_;
                            continue;
                            continuing {
                                phi_832_ = _e874;
                                phi_835_ = _e876;
                                break if !(_e762);
                            }
                        }
                        let _e880 = nodes.member[(0u + _e490)].links[0u];
                        let _e884 = nodes.member[(0u + _e490)].frame[3u];
                        let _e888 = local_1;
                        if ((_e888 & 4278190080u) == 0u) {
                        } else {
                            let _e892 = local.group_mask;
                            if ((_e892 & 4278190080u) == 0u) {
                            } else {
                                let _e896 = local.len;
                                if (_e896 < 32u) {
                                    let _e899 = local.group;
                                    let _e901 = local.len;
                                    if (_e901 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e901)] = _e899;
                                    let _e907 = local.group_mask;
                                    let _e909 = local.len;
                                    if (_e909 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e909)] = _e907;
                                    let _e916 = local.len;
                                    local.len = (_e916 + 1u);
                                }
                            }
                            local.group = (0u + _e880);
                            let _e920 = local_2;
                            local.group_mask = ((_e920 & 4278190080u) | (_e884 >> bitcast<u32>(24i)));
                        }
                        let _e925 = local_3;
                        phi_1021_ = (_e925 & 16777215u);
                        phi_1024_ = _e492;
                        loop {
                            let _e928 = phi_1021_;
                            let _e930 = phi_1024_;
                            local_6 = _e930;
                            let _e931 = (_e928 == 0u);
                            local_4 = _e931;
                            local_7 = _e931;
                            if _e931 {
                                phi_1022_ = u32();
                                phi_1025_ = bool();
                                phi_1622_ = false;
                            } else {
                                let _e934 = nodes.member[(0u + _e490)].links[1u];
                                let _e939 = ((0u + _e934) + select(firstTrailingBit(_e928), 32u, (_e928 == 0u)));
                                if (_e939 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e946 = triangles.member[(0u + _e939)].v0_;
                                let _e948 = (_e946.x - _e99);
                                let _e950 = (_e946.y - _e101);
                                let _e952 = (_e946.z - _e103);
                                if (_e325 == 0u) {
                                    phi_1069_ = vec3<f32>(_e950, _e952, _e948);
                                } else {
                                    if (_e325 == 1u) {
                                        phi_1068_ = vec3<f32>(_e952, _e948, _e950);
                                    } else {
                                        phi_1068_ = (_e946 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e960 = phi_1068_;
                                    phi_1069_ = _e960;
                                }
                                let _e962 = phi_1069_;
                                let _e966 = (_e962.x - (_e336 * _e962.z));
                                let _e970 = (_e962.y - (_e339 * _e962.z));
                                let _e972 = triangles.member[(0u + _e939)].v1_;
                                let _e974 = (_e972.x - _e99);
                                let _e976 = (_e972.y - _e101);
                                let _e978 = (_e972.z - _e103);
                                if (_e325 == 0u) {
                                    phi_1099_ = vec3<f32>(_e976, _e978, _e974);
                                } else {
                                    if (_e325 == 1u) {
                                        phi_1098_ = vec3<f32>(_e978, _e974, _e976);
                                    } else {
                                        phi_1098_ = (_e972 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e986 = phi_1098_;
                                    phi_1099_ = _e986;
                                }
                                let _e988 = phi_1099_;
                                let _e992 = (_e988.x - (_e336 * _e988.z));
                                let _e996 = (_e988.y - (_e339 * _e988.z));
                                let _e998 = triangles.member[(0u + _e939)].v2_;
                                let _e1000 = (_e998.x - _e99);
                                let _e1002 = (_e998.y - _e101);
                                let _e1004 = (_e998.z - _e103);
                                if (_e325 == 0u) {
                                    phi_1129_ = vec3<f32>(_e1002, _e1004, _e1000);
                                } else {
                                    if (_e325 == 1u) {
                                        phi_1128_ = vec3<f32>(_e1004, _e1000, _e1002);
                                    } else {
                                        phi_1128_ = (_e998 - vec3<f32>(_e99, _e101, _e103));
                                    }
                                    let _e1012 = phi_1128_;
                                    phi_1129_ = _e1012;
                                }
                                let _e1014 = phi_1129_;
                                let _e1018 = (_e1014.x - (_e336 * _e1014.z));
                                let _e1022 = (_e1014.y - (_e339 * _e1014.z));
                                if (_e992 < _e1018) {
                                    phi_1148_ = true;
                                } else {
                                    if (_e992 == _e1018) {
                                        phi_1147_ = (_e996 < _e1022);
                                    } else {
                                        phi_1147_ = false;
                                    }
                                    let _e1027 = phi_1147_;
                                    phi_1148_ = _e1027;
                                }
                                let _e1029 = phi_1148_;
                                if _e1029 {
                                    phi_1152_ = _e1022;
                                    phi_1153_ = _e1018;
                                    phi_1154_ = _e996;
                                    phi_1155_ = _e992;
                                } else {
                                    phi_1152_ = _e996;
                                    phi_1153_ = _e992;
                                    phi_1154_ = _e1022;
                                    phi_1155_ = _e1018;
                                }
                                let _e1031 = phi_1152_;
                                let _e1033 = phi_1153_;
                                let _e1035 = phi_1154_;
                                let _e1037 = phi_1155_;
                                let _e1040 = ((_e1037 * _e1031) - (_e1035 * _e1033));
                                if _e1029 {
                                    phi_1163_ = -(_e1040);
                                } else {
                                    phi_1163_ = _e1040;
                                }
                                let _e1043 = phi_1163_;
                                if (_e1018 < _e966) {
                                    phi_1174_ = true;
                                } else {
                                    if (_e1018 == _e966) {
                                        phi_1173_ = (_e1022 < _e970);
                                    } else {
                                        phi_1173_ = false;
                                    }
                                    let _e1048 = phi_1173_;
                                    phi_1174_ = _e1048;
                                }
                                let _e1050 = phi_1174_;
                                if _e1050 {
                                    phi_1178_ = _e970;
                                    phi_1179_ = _e966;
                                    phi_1180_ = _e1022;
                                    phi_1181_ = _e1018;
                                } else {
                                    phi_1178_ = _e1022;
                                    phi_1179_ = _e1018;
                                    phi_1180_ = _e970;
                                    phi_1181_ = _e966;
                                }
                                let _e1052 = phi_1178_;
                                let _e1054 = phi_1179_;
                                let _e1056 = phi_1180_;
                                let _e1058 = phi_1181_;
                                let _e1061 = ((_e1058 * _e1052) - (_e1056 * _e1054));
                                if _e1050 {
                                    phi_1189_ = -(_e1061);
                                } else {
                                    phi_1189_ = _e1061;
                                }
                                let _e1064 = phi_1189_;
                                if (_e966 < _e992) {
                                    phi_1200_ = true;
                                } else {
                                    if (_e966 == _e992) {
                                        phi_1199_ = (_e970 < _e996);
                                    } else {
                                        phi_1199_ = false;
                                    }
                                    let _e1069 = phi_1199_;
                                    phi_1200_ = _e1069;
                                }
                                let _e1071 = phi_1200_;
                                if _e1071 {
                                    phi_1204_ = _e996;
                                    phi_1205_ = _e992;
                                    phi_1206_ = _e970;
                                    phi_1207_ = _e966;
                                } else {
                                    phi_1204_ = _e970;
                                    phi_1205_ = _e966;
                                    phi_1206_ = _e996;
                                    phi_1207_ = _e992;
                                }
                                let _e1073 = phi_1204_;
                                let _e1075 = phi_1205_;
                                let _e1077 = phi_1206_;
                                let _e1079 = phi_1207_;
                                let _e1082 = ((_e1079 * _e1073) - (_e1077 * _e1075));
                                if _e1071 {
                                    phi_1215_ = -(_e1082);
                                } else {
                                    phi_1215_ = _e1082;
                                }
                                let _e1085 = phi_1215_;
                                if (_e1043 >= 0f) {
                                    if (_e1064 >= 0f) {
                                        if (_e1085 >= 0f) {
                                            phi_1230_ = ((_e1043 + _e1064) + _e1085);
                                            phi_1231_ = false;
                                        } else {
                                            phi_1230_ = f32();
                                            phi_1231_ = true;
                                        }
                                        let _e1092 = phi_1230_;
                                        let _e1094 = phi_1231_;
                                        phi_1232_ = _e1092;
                                        phi_1233_ = _e1094;
                                    } else {
                                        phi_1232_ = f32();
                                        phi_1233_ = true;
                                    }
                                    let _e1096 = phi_1232_;
                                    let _e1098 = phi_1233_;
                                    phi_1234_ = _e1096;
                                    phi_1235_ = _e1098;
                                } else {
                                    phi_1234_ = f32();
                                    phi_1235_ = true;
                                }
                                let _e1100 = phi_1234_;
                                let _e1102 = phi_1235_;
                                if _e1102 {
                                    if (_e1043 <= 0f) {
                                        if (_e1064 <= 0f) {
                                            let _e1105 = (_e1085 <= 0f);
                                            if _e1105 {
                                            }
                                            phi_1253_ = ((_e1043 + _e1064) + _e1085);
                                            phi_1254_ = false;
                                            phi_1255_ = _e1105;
                                        } else {
                                            phi_1253_ = f32();
                                            phi_1254_ = true;
                                            phi_1255_ = false;
                                        }
                                        let _e1109 = phi_1253_;
                                        let _e1111 = phi_1254_;
                                        let _e1113 = phi_1255_;
                                        phi_1256_ = _e1109;
                                        phi_1257_ = _e1111;
                                        phi_1258_ = _e1113;
                                    } else {
                                        phi_1256_ = f32();
                                        phi_1257_ = true;
                                        phi_1258_ = false;
                                    }
                                    let _e1115 = phi_1256_;
                                    let _e1117 = phi_1257_;
                                    let _e1119 = phi_1258_;
                                    if _e1117 {
                                        phi_1262_ = false;
                                    } else {
                                        phi_1262_ = _e1119;
                                    }
                                    let _e1121 = phi_1262_;
                                    phi_1263_ = _e1115;
                                    phi_1264_ = _e1121;
                                } else {
                                    phi_1263_ = _e1100;
                                    phi_1264_ = true;
                                }
                                let _e1123 = phi_1263_;
                                let _e1125 = phi_1264_;
                                if _e1125 {
                                    let _e1126 = (_e1123 == 0f);
                                    if _e1126 {
                                        phi_1580_ = lt_bvh_triangle_Intersection();
                                        phi_1581_ = false;
                                    } else {
                                        let _e1128 = triangles.member[(0u + _e939)].v0_;
                                        let _e1130 = (_e1128.x - _e99);
                                        let _e1132 = (_e1128.y - _e101);
                                        let _e1134 = (_e1128.z - _e103);
                                        if (_e325 == 0u) {
                                            phi_1293_ = vec3<f32>(_e1132, _e1134, _e1130);
                                        } else {
                                            if (_e325 == 1u) {
                                                phi_1292_ = vec3<f32>(_e1134, _e1130, _e1132);
                                            } else {
                                                phi_1292_ = (_e1128 - vec3<f32>(_e99, _e101, _e103));
                                            }
                                            let _e1142 = phi_1292_;
                                            phi_1293_ = _e1142;
                                        }
                                        let _e1144 = phi_1293_;
                                        let _e1146 = triangles.member[(0u + _e939)].v1_;
                                        let _e1148 = triangles.member[(0u + _e939)].v0_;
                                        let _e1151 = (_e1146.x - _e1148.x);
                                        let _e1154 = (_e1146.y - _e1148.y);
                                        let _e1157 = (_e1146.z - _e1148.z);
                                        if (_e325 == 0u) {
                                            phi_1319_ = vec3<f32>(_e1154, _e1157, _e1151);
                                        } else {
                                            if (_e325 == 1u) {
                                                phi_1318_ = vec3<f32>(_e1157, _e1151, _e1154);
                                            } else {
                                                phi_1318_ = (_e1146 - _e1148);
                                            }
                                            let _e1164 = phi_1318_;
                                            phi_1319_ = _e1164;
                                        }
                                        let _e1166 = phi_1319_;
                                        let _e1168 = triangles.member[(0u + _e939)].v2_;
                                        let _e1170 = triangles.member[(0u + _e939)].v0_;
                                        let _e1173 = (_e1168.x - _e1170.x);
                                        let _e1176 = (_e1168.y - _e1170.y);
                                        let _e1179 = (_e1168.z - _e1170.z);
                                        if (_e325 == 0u) {
                                            phi_1345_ = vec3<f32>(_e1176, _e1179, _e1173);
                                        } else {
                                            if (_e325 == 1u) {
                                                phi_1344_ = vec3<f32>(_e1179, _e1173, _e1176);
                                            } else {
                                                phi_1344_ = (_e1168 - _e1170);
                                            }
                                            let _e1186 = phi_1344_;
                                            phi_1345_ = _e1186;
                                        }
                                        let _e1188 = phi_1345_;
                                        let _e1195 = ((_e1166.y * _e1188.z) - (_e1166.z * _e1188.y));
                                        let _e1202 = ((_e1166.z * _e1188.x) - (_e1166.x * _e1188.z));
                                        let _e1209 = ((_e1166.x * _e1188.y) - (_e1166.y * _e1188.x));
                                        let _e1223 = (((1f / _e333.z) * (((_e1195 * _e1144.x) + (_e1202 * _e1144.y)) + (_e1209 * _e1144.z))) / (((_e1195 * _e336) + (_e1202 * _e339)) + _e1209));
                                        if (_e1223 > 0f) {
                                            if (_e1223 < _e109) {
                                                let _e1227 = triangles.member[(0u + _e939)].v0_;
                                                let _e1229 = triangles.member[(0u + _e939)].v1_;
                                                if (_e1227.x < _e1229.x) {
                                                    phi_1401_ = _e1227.x;
                                                } else {
                                                    phi_1401_ = _e1229.x;
                                                }
                                                let _e1236 = phi_1401_;
                                                if (_e1227.y < _e1229.y) {
                                                    phi_1410_ = _e1227.y;
                                                } else {
                                                    phi_1410_ = _e1229.y;
                                                }
                                                let _e1243 = phi_1410_;
                                                if (_e1227.z < _e1229.z) {
                                                    phi_1419_ = _e1227.z;
                                                } else {
                                                    phi_1419_ = _e1229.z;
                                                }
                                                let _e1250 = phi_1419_;
                                                let _e1252 = triangles.member[(0u + _e939)].v2_;
                                                if (_e1236 < _e1252.x) {
                                                    phi_1428_ = _e1236;
                                                } else {
                                                    phi_1428_ = _e1252.x;
                                                }
                                                let _e1257 = phi_1428_;
                                                if (_e1243 < _e1252.y) {
                                                    phi_1435_ = _e1243;
                                                } else {
                                                    phi_1435_ = _e1252.y;
                                                }
                                                let _e1262 = phi_1435_;
                                                if (_e1250 < _e1252.z) {
                                                    phi_1442_ = _e1250;
                                                } else {
                                                    phi_1442_ = _e1252.z;
                                                }
                                                let _e1267 = phi_1442_;
                                                let _e1269 = triangles.member[(0u + _e939)].v0_;
                                                let _e1271 = triangles.member[(0u + _e939)].v1_;
                                                if (_e1269.x > _e1271.x) {
                                                    phi_1455_ = _e1269.x;
                                                } else {
                                                    phi_1455_ = _e1271.x;
                                                }
                                                let _e1278 = phi_1455_;
                                                if (_e1269.y > _e1271.y) {
                                                    phi_1464_ = _e1269.y;
                                                } else {
                                                    phi_1464_ = _e1271.y;
                                                }
                                                let _e1285 = phi_1464_;
                                                if (_e1269.z > _e1271.z) {
                                                    phi_1473_ = _e1269.z;
                                                } else {
                                                    phi_1473_ = _e1271.z;
                                                }
                                                let _e1292 = phi_1473_;
                                                let _e1294 = triangles.member[(0u + _e939)].v2_;
                                                if (_e1278 > _e1294.x) {
                                                    phi_1482_ = _e1278;
                                                } else {
                                                    phi_1482_ = _e1294.x;
                                                }
                                                let _e1299 = phi_1482_;
                                                if (_e1285 > _e1294.y) {
                                                    phi_1489_ = _e1285;
                                                } else {
                                                    phi_1489_ = _e1294.y;
                                                }
                                                let _e1304 = phi_1489_;
                                                if (_e1292 > _e1294.z) {
                                                    phi_1496_ = _e1292;
                                                } else {
                                                    phi_1496_ = _e1294.z;
                                                }
                                                let _e1309 = phi_1496_;
                                                let _e1313 = ((_e1257 - _e99) * _e250);
                                                let _e1314 = ((_e1262 - _e101) * _e260);
                                                let _e1315 = ((_e1267 - _e103) * _e270);
                                                let _e1319 = ((_e1299 - _e99) * _e250);
                                                let _e1320 = ((_e1304 - _e101) * _e260);
                                                let _e1321 = ((_e1309 - _e103) * _e270);
                                                if (_e1313 < _e1319) {
                                                    phi_1513_ = _e1313;
                                                } else {
                                                    phi_1513_ = _e1319;
                                                }
                                                let _e1324 = phi_1513_;
                                                if (_e1314 < _e1320) {
                                                    phi_1518_ = _e1314;
                                                } else {
                                                    phi_1518_ = _e1320;
                                                }
                                                let _e1327 = phi_1518_;
                                                if (_e1315 < _e1321) {
                                                    phi_1523_ = _e1315;
                                                } else {
                                                    phi_1523_ = _e1321;
                                                }
                                                let _e1330 = phi_1523_;
                                                if (_e1313 > _e1319) {
                                                    phi_1531_ = _e1313;
                                                } else {
                                                    phi_1531_ = _e1319;
                                                }
                                                let _e1336 = phi_1531_;
                                                if (_e1314 > _e1320) {
                                                    phi_1536_ = _e1314;
                                                } else {
                                                    phi_1536_ = _e1320;
                                                }
                                                let _e1339 = phi_1536_;
                                                if (_e1315 > _e1321) {
                                                    phi_1541_ = _e1315;
                                                } else {
                                                    phi_1541_ = _e1321;
                                                }
                                                let _e1342 = phi_1541_;
                                                let _e1346 = core_intrinsics_maximum_number_nsz_f32_((_e1324 - _e309), (_e1327 - _e310));
                                                let _e1347 = core_intrinsics_maximum_number_nsz_f32_(_e1346, (_e1330 - _e311));
                                                let _e1348 = core_intrinsics_minimum_number_nsz_f32_((_e1336 + _e309), (_e1339 + _e310));
                                                let _e1349 = core_intrinsics_minimum_number_nsz_f32_(_e1348, (_e1342 + _e311));
                                                if (_e1347 > -300000000000000000000000000000000000000f) {
                                                    phi_1553_ = _e1347;
                                                } else {
                                                    phi_1553_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1352 = phi_1553_;
                                                if (_e1349 < 300000000000000000000000000000000000000f) {
                                                    phi_1558_ = _e1349;
                                                } else {
                                                    phi_1558_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1355 = phi_1558_;
                                                if (_e1223 < _e1352) {
                                                    phi_1563_ = _e1352;
                                                } else {
                                                    phi_1563_ = _e1223;
                                                }
                                                let _e1358 = phi_1563_;
                                                if (_e1358 > _e1355) {
                                                    phi_1568_ = _e1355;
                                                } else {
                                                    phi_1568_ = _e1358;
                                                }
                                                let _e1361 = phi_1568_;
                                                phi_1573_ = lt_bvh_triangle_Intersection(_e1361, (_e1064 / _e1123), (_e1085 / _e1123), (_e1352 <= _e1355));
                                                phi_1574_ = false;
                                            } else {
                                                phi_1573_ = lt_bvh_triangle_Intersection();
                                                phi_1574_ = true;
                                            }
                                            let _e1367 = phi_1573_;
                                            let _e1369 = phi_1574_;
                                            phi_1575_ = _e1367;
                                            phi_1576_ = _e1369;
                                        } else {
                                            phi_1575_ = lt_bvh_triangle_Intersection();
                                            phi_1576_ = true;
                                        }
                                        let _e1371 = phi_1575_;
                                        let _e1373 = phi_1576_;
                                        if _e1373 {
                                        }
                                        phi_1580_ = _e1371;
                                        phi_1581_ = _e1373;
                                    }
                                    let _e1375 = phi_1580_;
                                    let _e1377 = phi_1581_;
                                    phi_1582_ = _e1375;
                                    phi_1583_ = _e1126;
                                    phi_1584_ = _e1377;
                                } else {
                                    phi_1582_ = lt_bvh_triangle_Intersection();
                                    phi_1583_ = true;
                                    phi_1584_ = false;
                                }
                                let _e1379 = phi_1582_;
                                let _e1381 = phi_1583_;
                                let _e1383 = phi_1584_;
                                if _e1381 {
                                    phi_1588_ = true;
                                } else {
                                    phi_1588_ = _e1383;
                                }
                                let _e1385 = phi_1588_;
                                if _e1385 {
                                    phi_1592_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1592_ = _e1379;
                                }
                                let _e1387 = phi_1592_;
                                if _e1387.is_hit {
                                    if (_e1387.t > 0f) {
                                        if (_e1387.t < _e109) {
                                            if true {
                                                phi_1612_ = false;
                                            } else {
                                                phi_1612_ = true;
                                            }
                                            let _e1396 = phi_1612_;
                                            phi_1613_ = true;
                                            phi_1614_ = _e1396;
                                        } else {
                                            phi_1613_ = _e930;
                                            phi_1614_ = true;
                                        }
                                        let _e1398 = phi_1613_;
                                        let _e1400 = phi_1614_;
                                        phi_1615_ = _e1398;
                                        phi_1616_ = _e1400;
                                    } else {
                                        phi_1615_ = _e930;
                                        phi_1616_ = true;
                                    }
                                    let _e1402 = phi_1615_;
                                    let _e1404 = phi_1616_;
                                    phi_1617_ = _e1402;
                                    phi_1618_ = _e1404;
                                } else {
                                    phi_1617_ = _e930;
                                    phi_1618_ = true;
                                }
                                let _e1406 = phi_1617_;
                                let _e1408 = phi_1618_;
                                if _e1408 {
                                }
                                phi_1022_ = (_e928 & (_e928 - 1u));
                                phi_1025_ = _e1406;
                                phi_1622_ = _e1408;
                            }
                            let _e1410 = phi_1022_;
                            let _e1412 = phi_1025_;
                            let _e1414 = phi_1622_;
                            continue;
                            continuing {
                                phi_1021_ = _e1410;
                                phi_1024_ = _e1412;
                                break if !(_e1414);
                            }
                        }
                        let _e1417 = local_4;
                        if _e1417 {
                            let _e1419 = local.group_mask;
                            if ((_e1419 & 4278190080u) == 0u) {
                                let _e1423 = local.len;
                                if (_e1423 == 0u) {
                                    phi_1664_ = false;
                                } else {
                                    let _e1427 = local.len;
                                    local.len = (_e1427 - 1u);
                                    let _e1430 = local.len;
                                    if (_e1430 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1435 = local.first[(0u + _e1430)];
                                    local.group = _e1435;
                                    let _e1438 = local.len;
                                    if (_e1438 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1443 = local.mask[(0u + _e1438)];
                                    local.group_mask = _e1443;
                                    phi_1664_ = true;
                                }
                                let _e1446 = phi_1664_;
                                phi_1665_ = _e1446;
                            } else {
                                phi_1665_ = true;
                            }
                            let _e1448 = phi_1665_;
                            if _e1448 {
                                let _e1450 = local.group_mask;
                                let _e1456 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1450)), 32u, (_e1450 == 0u)));
                                let _e1460 = local.group_mask;
                                let _e1474 = local.group_mask;
                                local.group_mask = (_e1474 & ~((1u << bitcast<u32>((_e1456 & 31u)))));
                                let _e1477 = local.group;
                                phi_1696_ = (_e1477 + countOneBits(((_e1460 & ~((4294967295u << bitcast<u32>((((_e1456 - 24u) ^ _e352) & 31u))))) & 255u)));
                            } else {
                                phi_1696_ = 4294967295u;
                            }
                            let _e1480 = phi_1696_;
                            phi_1697_ = _e1480;
                        } else {
                            phi_1697_ = u32();
                        }
                        let _e1482 = phi_1697_;
                        phi_690_ = _e1482;
                        let _e1678 = local_6;
                        phi_693_ = _e1678;
                        let _e1681 = local_7;
                        phi_1698_ = _e1681;
                        phi_1699_ = false;
                    } else {
                        phi_690_ = u32();
                        phi_693_ = bool();
                        phi_1698_ = false;
                        phi_1699_ = true;
                    }
                    let _e1484 = phi_690_;
                    let _e1486 = phi_693_;
                    let _e1488 = phi_1698_;
                    let _e1490 = phi_1699_;
                    local_5 = _e1490;
                    continue;
                    continuing {
                        phi_689_ = _e1484;
                        phi_692_ = _e1486;
                        break if !(_e1488);
                    }
                }
                let _e1493 = local_5;
                if _e1493 {
                    phi_1703_ = false;
                } else {
                    phi_1703_ = true;
                }
                let _e1495 = phi_1703_;
                if _e1495 {
                    phi_1707_ = true;
                } else {
                    let _e1687 = local_8;
                    phi_1707_ = _e1687;
                }
                let _e1497 = phi_1707_;
                phi_1708_ = _e1497;
            }
            let _e1499 = phi_1708_;
            phi_1709_ = _e1499;
            phi_1710_ = _e174;
        } else {
            phi_1709_ = bool();
            phi_1710_ = true;
        }
        let _e1501 = phi_1709_;
        let _e1503 = phi_1710_;
        if _e1503 {
            phi_1714_ = false;
        } else {
            phi_1714_ = _e1501;
        }
        let _e1505 = phi_1714_;
        if _e1505 {
            phi_1718_ = 0f;
        } else {
            phi_1718_ = 1f;
        }
        let _e1507 = phi_1718_;
        if (_e79 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e79)] = _e1507;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
