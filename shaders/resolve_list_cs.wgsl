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
    var phi_149_: bool;
    var phi_153_: f32;

    if (param != param) {
        phi_149_ = true;
    } else {
        let _e53 = (param_1 >= param);
        if _e53 {
        }
        phi_149_ = _e53;
    }
    let _e55 = phi_149_;
    if _e55 {
        phi_153_ = param_1;
    } else {
        phi_153_ = param;
    }
    let _e57 = phi_153_;
    return _e57;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_165_: bool;
    var phi_169_: f32;

    if (param_2 != param_2) {
        phi_165_ = true;
    } else {
        let _e53 = (param_3 <= param_2);
        if _e53 {
        }
        phi_165_ = _e53;
    }
    let _e55 = phi_165_;
    if _e55 {
        phi_169_ = param_3;
    } else {
        phi_169_ = param_2;
    }
    let _e57 = phi_169_;
    return _e57;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_245_: f32;
    var phi_276_: bool;
    var phi_277_: bool;
    var phi_278_: bool;
    var phi_279_: bool;
    var phi_283_: bool;
    var phi_296_: bool;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_303_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
    var phi_330_: bool;
    var phi_400_: f32;
    var phi_407_: f32;
    var phi_414_: f32;
    var phi_421_: f32;
    var phi_428_: f32;
    var phi_435_: f32;
    var phi_452_: f32;
    var phi_457_: f32;
    var phi_462_: f32;
    var phi_467_: f32;
    var phi_472_: f32;
    var phi_498_: bool;
    var phi_499_: bool;
    var phi_507_: u32;
    var phi_508_: u32;
    var phi_519_: vec3<f32>;
    var phi_520_: vec3<f32>;
    var phi_533_: u32;
    var phi_538_: u32;
    var phi_543_: u32;
    var phi_657_: bool;
    var phi_658_: bool;
    var phi_689_: u32;
    var phi_691_: u32;
    var phi_694_: bool;
    var phi_774_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_801_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_828_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_834_: u32;
    var phi_837_: u32;
    var phi_851_: u32;
    var phi_861_: u32;
    var phi_871_: u32;
    var phi_889_: u32;
    var phi_899_: u32;
    var phi_909_: u32;
    var phi_945_: u32;
    var phi_958_: u32;
    var phi_963_: u32;
    var phi_964_: u32;
    var phi_965_: u32;
    var phi_835_: u32;
    var phi_838_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1023_: u32;
    var phi_1026_: bool;
    var phi_1070_: vec3<f32>;
    var phi_1071_: vec3<f32>;
    var phi_1100_: vec3<f32>;
    var phi_1101_: vec3<f32>;
    var phi_1130_: vec3<f32>;
    var phi_1131_: vec3<f32>;
    var phi_1149_: bool;
    var phi_1150_: bool;
    var phi_1154_: f32;
    var phi_1155_: f32;
    var phi_1156_: f32;
    var phi_1157_: f32;
    var phi_1165_: f32;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1180_: f32;
    var phi_1181_: f32;
    var phi_1182_: f32;
    var phi_1183_: f32;
    var phi_1191_: f32;
    var phi_1201_: bool;
    var phi_1202_: bool;
    var phi_1206_: f32;
    var phi_1207_: f32;
    var phi_1208_: f32;
    var phi_1209_: f32;
    var phi_1217_: f32;
    var phi_1232_: f32;
    var phi_1233_: bool;
    var phi_1234_: f32;
    var phi_1235_: bool;
    var phi_1236_: f32;
    var phi_1237_: bool;
    var phi_1255_: f32;
    var phi_1256_: bool;
    var phi_1257_: bool;
    var phi_1258_: f32;
    var phi_1259_: bool;
    var phi_1260_: bool;
    var phi_1264_: bool;
    var phi_1265_: f32;
    var phi_1266_: bool;
    var phi_1294_: vec3<f32>;
    var phi_1295_: vec3<f32>;
    var phi_1320_: vec3<f32>;
    var phi_1321_: vec3<f32>;
    var phi_1346_: vec3<f32>;
    var phi_1347_: vec3<f32>;
    var phi_1403_: f32;
    var phi_1412_: f32;
    var phi_1421_: f32;
    var phi_1430_: f32;
    var phi_1437_: f32;
    var phi_1444_: f32;
    var phi_1457_: f32;
    var phi_1466_: f32;
    var phi_1475_: f32;
    var phi_1484_: f32;
    var phi_1491_: f32;
    var phi_1498_: f32;
    var phi_1515_: f32;
    var phi_1520_: f32;
    var phi_1525_: f32;
    var phi_1533_: f32;
    var phi_1538_: f32;
    var phi_1543_: f32;
    var phi_1555_: f32;
    var phi_1560_: f32;
    var phi_1565_: f32;
    var phi_1570_: f32;
    var phi_1575_: lt_bvh_triangle_Intersection;
    var phi_1576_: bool;
    var phi_1577_: lt_bvh_triangle_Intersection;
    var phi_1578_: bool;
    var phi_1582_: lt_bvh_triangle_Intersection;
    var phi_1583_: bool;
    var phi_1584_: lt_bvh_triangle_Intersection;
    var phi_1585_: bool;
    var phi_1586_: bool;
    var phi_1590_: bool;
    var phi_1594_: lt_bvh_triangle_Intersection;
    var phi_1614_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1617_: bool;
    var phi_1618_: bool;
    var phi_1619_: bool;
    var phi_1620_: bool;
    var phi_1024_: u32;
    var phi_1027_: bool;
    var phi_1624_: bool;
    var local_4: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1698_: u32;
    var phi_1699_: u32;
    var phi_692_: u32;
    var phi_695_: bool;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var local_5: bool;
    var phi_1705_: bool;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var phi_1711_: bool;
    var phi_1712_: bool;
    var phi_1716_: bool;
    var phi_1720_: f32;
    var local_6: bool;
    var local_7: bool;
    var local_8: bool;

    let _e51 = id_1;
    let _e58 = arrayLength((&nodes.member));
    let _e67 = arrayLength((&list.member));
    let _e71 = ((_e51.y * 2097152u) + _e51.x);
    if (3u < _e67) {
    } else {
        return;
    }
    let _e74 = list.member[3u];
    if (_e71 < _e74) {
        let _e76 = (_e71 + 4u);
        if (_e76 < _e67) {
        } else {
            return;
        }
        let _e80 = list.member[(0u + _e76)];
        let _e81 = (_e80 & 2147483647u);
        if (_e81 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e87 = samples.member[(0u + _e81)].position;
        let _e89 = samples.member[(0u + _e81)].normal;
        let _e91 = samples.member[(0u + _e81)].magnitude;
        let _e93 = ((8f / 8388608f) * _e91);
        let _e101 = (_e87.x + (_e89.x * _e93));
        let _e103 = (_e87.y + (_e89.y * _e93));
        let _e105 = (_e87.z + (_e89.z * _e93));
        let _e107 = p.member.light.place;
        if (_e107.w == 0f) {
            phi_245_ = 300000000000000000000000000000000000000f;
        } else {
            phi_245_ = 1f;
        }
        let _e111 = phi_245_;
        let _e119 = (_e107.x - (_e101 * _e107.w));
        let _e120 = (_e107.y - (_e103 * _e107.w));
        let _e121 = (_e107.z - (_e105 * _e107.w));
        let _e123 = abs(_e119);
        let _e124 = abs(_e120);
        let _e125 = abs(_e121);
        if (abs(_e101) < 1000000000000000f) {
            if (abs(_e103) < 1000000000000000f) {
                phi_276_ = (abs(_e105) < 1000000000000000f);
                phi_277_ = false;
            } else {
                phi_276_ = bool();
                phi_277_ = true;
            }
            let _e133 = phi_276_;
            let _e135 = phi_277_;
            phi_278_ = _e133;
            phi_279_ = _e135;
        } else {
            phi_278_ = bool();
            phi_279_ = true;
        }
        let _e137 = phi_278_;
        let _e139 = phi_279_;
        if _e139 {
            phi_283_ = false;
        } else {
            phi_283_ = _e137;
        }
        let _e141 = phi_283_;
        if _e141 {
            if (_e123 < 1000000000000000f) {
                if (_e124 < 1000000000000000f) {
                    phi_296_ = (_e125 < 1000000000000000f);
                    phi_297_ = false;
                } else {
                    phi_296_ = bool();
                    phi_297_ = true;
                }
                let _e146 = phi_296_;
                let _e148 = phi_297_;
                phi_298_ = _e146;
                phi_299_ = _e148;
            } else {
                phi_298_ = bool();
                phi_299_ = true;
            }
            let _e150 = phi_298_;
            let _e152 = phi_299_;
            if _e152 {
                phi_303_ = false;
            } else {
                phi_303_ = _e150;
            }
            let _e154 = phi_303_;
            if _e154 {
                if (_e123 > 0f) {
                    phi_317_ = bool();
                    phi_318_ = true;
                } else {
                    let _e156 = (_e124 > 0f);
                    if _e156 {
                        phi_316_ = bool();
                    } else {
                        phi_316_ = (_e125 > 0f);
                    }
                    let _e159 = phi_316_;
                    phi_317_ = _e159;
                    phi_318_ = _e156;
                }
                let _e161 = phi_317_;
                let _e163 = phi_318_;
                if _e163 {
                    phi_322_ = true;
                } else {
                    phi_322_ = _e161;
                }
                let _e165 = phi_322_;
                phi_323_ = _e165;
                phi_324_ = false;
            } else {
                phi_323_ = bool();
                phi_324_ = true;
            }
            let _e167 = phi_323_;
            let _e169 = phi_324_;
            phi_325_ = _e167;
            phi_326_ = _e169;
        } else {
            phi_325_ = bool();
            phi_326_ = true;
        }
        let _e171 = phi_325_;
        let _e173 = phi_326_;
        if _e173 {
            phi_330_ = false;
        } else {
            phi_330_ = _e171;
        }
        let _e175 = phi_330_;
        if _e175 {
            let _e176 = (0u >= _e58);
            if _e176 {
                phi_1710_ = bool();
            } else {
                if (0u < _e58) {
                } else {
                    return;
                }
                let _e182 = nodes.member[(0u + 0u)].frame[0u];
                let _e186 = nodes.member[(0u + 0u)].frame[1u];
                let _e190 = nodes.member[(0u + 0u)].frame[2u];
                let _e194 = nodes.member[(0u + 0u)].frame[0u];
                let _e198 = nodes.member[(0u + 0u)].frame[1u];
                let _e202 = nodes.member[(0u + 0u)].frame[2u];
                let _e206 = nodes.member[(0u + 0u)].frame[3u];
                let _e240 = core_intrinsics_maximum_number_nsz_f32_(abs(_e119), abs(_e120));
                let _e241 = core_intrinsics_maximum_number_nsz_f32_(_e240, abs(_e121));
                let _e242 = (_e241 * 0.0000000000009094947f);
                if (abs(_e119) < _e242) {
                    phi_400_ = _e242;
                } else {
                    phi_400_ = abs(_e119);
                }
                let _e247 = phi_400_;
                if (_e119 < 0f) {
                    phi_407_ = (-1f / _e247);
                } else {
                    phi_407_ = (1f / _e247);
                }
                let _e252 = phi_407_;
                if (abs(_e120) < _e242) {
                    phi_414_ = _e242;
                } else {
                    phi_414_ = abs(_e120);
                }
                let _e257 = phi_414_;
                if (_e120 < 0f) {
                    phi_421_ = (-1f / _e257);
                } else {
                    phi_421_ = (1f / _e257);
                }
                let _e262 = phi_421_;
                if (abs(_e121) < _e242) {
                    phi_428_ = _e242;
                } else {
                    phi_428_ = abs(_e121);
                }
                let _e267 = phi_428_;
                if (_e121 < 0f) {
                    phi_435_ = (-1f / _e267);
                } else {
                    phi_435_ = (1f / _e267);
                }
                let _e272 = phi_435_;
                let _e276 = abs((bitcast<f32>(_e182) - _e101));
                let _e277 = abs((bitcast<f32>(_e186) - _e103));
                let _e278 = abs((bitcast<f32>(_e190) - _e105));
                let _e282 = abs(((bitcast<f32>(_e194) + (bitcast<f32>((((_e206 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e101));
                let _e283 = abs(((bitcast<f32>(_e198) + (bitcast<f32>((((_e206 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e103));
                let _e284 = abs(((bitcast<f32>(_e202) + (bitcast<f32>((((_e206 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e105));
                if (_e276 > _e282) {
                    phi_452_ = _e276;
                } else {
                    phi_452_ = _e282;
                }
                let _e287 = phi_452_;
                if (_e277 > _e283) {
                    phi_457_ = _e277;
                } else {
                    phi_457_ = _e283;
                }
                let _e290 = phi_457_;
                if (_e278 > _e284) {
                    phi_462_ = _e278;
                } else {
                    phi_462_ = _e284;
                }
                let _e293 = phi_462_;
                if (_e287 > _e290) {
                    phi_467_ = _e287;
                } else {
                    phi_467_ = _e290;
                }
                let _e296 = phi_467_;
                if (_e296 > _e293) {
                    phi_472_ = _e296;
                } else {
                    phi_472_ = _e293;
                }
                let _e299 = phi_472_;
                let _e303 = (_e299 * 0.0000019073486f);
                let _e304 = (abs(_e252) * _e303);
                let _e305 = (abs(_e262) * _e303);
                let _e306 = (abs(_e272) * _e303);
                let _e310 = (_e299 * 0.0000009536743f);
                let _e311 = (abs(_e252) * _e310);
                let _e312 = (abs(_e262) * _e310);
                let _e313 = (abs(_e272) * _e310);
                let _e314 = abs(_e119);
                let _e315 = abs(_e120);
                let _e316 = abs(_e121);
                if (_e314 >= _e315) {
                    if (_e314 >= _e316) {
                        phi_498_ = false;
                    } else {
                        phi_498_ = true;
                    }
                    let _e320 = phi_498_;
                    phi_499_ = _e320;
                } else {
                    phi_499_ = true;
                }
                let _e322 = phi_499_;
                if _e322 {
                    if (_e315 >= _e316) {
                        phi_507_ = 1u;
                    } else {
                        phi_507_ = 2u;
                    }
                    let _e325 = phi_507_;
                    phi_508_ = _e325;
                } else {
                    phi_508_ = 0u;
                }
                let _e327 = phi_508_;
                if (_e327 == 0u) {
                    phi_520_ = vec3<f32>(_e120, _e121, _e119);
                } else {
                    if (_e327 == 1u) {
                        phi_519_ = vec3<f32>(_e121, _e119, _e120);
                    } else {
                        phi_519_ = vec3<f32>(_e119, _e120, _e121);
                    }
                    let _e333 = phi_519_;
                    phi_520_ = _e333;
                }
                let _e335 = phi_520_;
                let _e338 = (_e335.x / _e335.z);
                let _e341 = (_e335.y / _e335.z);
                if (_e252 < 0f) {
                    phi_533_ = 0u;
                } else {
                    phi_533_ = 1u;
                }
                let _e346 = phi_533_;
                if (_e262 < 0f) {
                    phi_538_ = 0u;
                } else {
                    phi_538_ = 2u;
                }
                let _e349 = phi_538_;
                if (_e272 < 0f) {
                    phi_543_ = 0u;
                } else {
                    phi_543_ = 4u;
                }
                let _e352 = phi_543_;
                let _e354 = ((_e346 | _e349) | _e352);
                let _e355 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e355.first[0], _e355.first[1], _e355.first[2], _e355.first[3], _e355.first[4], _e355.first[5], _e355.first[6], _e355.first[7], _e355.first[8], _e355.first[9], _e355.first[10], _e355.first[11], _e355.first[12], _e355.first[13], _e355.first[14], _e355.first[15], _e355.first[16], _e355.first[17], _e355.first[18], _e355.first[19], _e355.first[20], _e355.first[21], _e355.first[22], _e355.first[23], _e355.first[24], _e355.first[25], _e355.first[26], _e355.first[27], _e355.first[28], _e355.first[29], _e355.first[30], _e355.first[31]), array<u32, 32>(_e355.mask[0], _e355.mask[1], _e355.mask[2], _e355.mask[3], _e355.mask[4], _e355.mask[5], _e355.mask[6], _e355.mask[7], _e355.mask[8], _e355.mask[9], _e355.mask[10], _e355.mask[11], _e355.mask[12], _e355.mask[13], _e355.mask[14], _e355.mask[15], _e355.mask[16], _e355.mask[17], _e355.mask[18], _e355.mask[19], _e355.mask[20], _e355.mask[21], _e355.mask[22], _e355.mask[23], _e355.mask[24], _e355.mask[25], _e355.mask[26], _e355.mask[27], _e355.mask[28], _e355.mask[29], _e355.mask[30], _e355.mask[31]), _e355.len, _e355.group, _e355.group_mask);
                let _e429 = local.group_mask;
                if ((_e429 & 4278190080u) == 0u) {
                    let _e433 = local.len;
                    if (_e433 == 0u) {
                        phi_657_ = false;
                    } else {
                        let _e437 = local.len;
                        local.len = (_e437 - 1u);
                        let _e440 = local.len;
                        if (_e440 < 32u) {
                        } else {
                            return;
                        }
                        let _e445 = local.first[(0u + _e440)];
                        local.group = _e445;
                        let _e448 = local.len;
                        if (_e448 < 32u) {
                        } else {
                            return;
                        }
                        let _e453 = local.mask[(0u + _e448)];
                        local.group_mask = _e453;
                        phi_657_ = true;
                    }
                    let _e456 = phi_657_;
                    phi_658_ = _e456;
                } else {
                    phi_658_ = true;
                }
                let _e458 = phi_658_;
                if _e458 {
                    let _e460 = local.group_mask;
                    let _e466 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e460)), 32u, (_e460 == 0u)));
                    let _e470 = local.group_mask;
                    let _e484 = local.group_mask;
                    local.group_mask = (_e484 & ~((1u << bitcast<u32>((_e466 & 31u)))));
                    let _e487 = local.group;
                    phi_689_ = (_e487 + countOneBits(((_e470 & ~((4294967295u << bitcast<u32>((((_e466 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_689_ = 4294967295u;
                }
                let _e490 = phi_689_;
                phi_691_ = _e490;
                phi_694_ = false;
                loop {
                    let _e492 = phi_691_;
                    let _e494 = phi_694_;
                    local_8 = _e494;
                    if (_e492 != 4294967295u) {
                        if (_e492 < _e58) {
                        } else {
                            return;
                        }
                        let _e501 = nodes.member[(0u + _e492)].frame[3u];
                        let _e526 = (bitcast<f32>((((_e501 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e252);
                        let _e527 = (bitcast<f32>((((_e501 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e262);
                        let _e528 = (bitcast<f32>((((_e501 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e272);
                        let _e531 = nodes.member[(0u + _e492)].frame[0u];
                        let _e535 = nodes.member[(0u + _e492)].frame[1u];
                        let _e539 = nodes.member[(0u + _e492)].frame[2u];
                        let _e544 = ((bitcast<f32>(_e531) - _e101) * _e252);
                        let _e545 = ((bitcast<f32>(_e535) - _e103) * _e262);
                        let _e546 = ((bitcast<f32>(_e539) - _e105) * _e272);
                        let _e554 = nodes.member[(0u + _e492)].x;
                        if (_e252 < 0f) {
                            let _e565 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e565.unnamed.root, _e554.w), _e565.unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e571.unnamed, lt_bvh_traverse_Tree(_e554.x, _e571.unnamed_1.first_primitive));
                            phi_774_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e577.unnamed_1.root, _e554.y));
                        } else {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e554.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e593.unnamed.root, _e554.y), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_bvh_traverse_Tree(_e554.z, _e599.unnamed_1.first_primitive));
                            phi_774_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_bvh_traverse_Tree(_e605.unnamed_1.root, _e554.w));
                        }
                        let _e613 = phi_774_;
                        let _e623 = nodes.member[(0u + _e492)].y;
                        if (_e262 < 0f) {
                            let _e634 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e634.unnamed.root, _e623.w), _e634.unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e640.unnamed, lt_bvh_traverse_Tree(_e623.x, _e640.unnamed_1.first_primitive));
                            phi_801_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e646.unnamed_1.root, _e623.y));
                        } else {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e623.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e662.unnamed.root, _e623.y), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_bvh_traverse_Tree(_e623.z, _e668.unnamed_1.first_primitive));
                            phi_801_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_bvh_traverse_Tree(_e674.unnamed_1.root, _e623.w));
                        }
                        let _e682 = phi_801_;
                        let _e692 = nodes.member[(0u + _e492)].z;
                        if (_e272 < 0f) {
                            let _e703 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e703.unnamed.root, _e692.w), _e703.unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e709.unnamed, lt_bvh_traverse_Tree(_e692.x, _e709.unnamed_1.first_primitive));
                            phi_828_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e715.unnamed_1.root, _e692.y));
                        } else {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e692.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e731.unnamed.root, _e692.y), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_bvh_traverse_Tree(_e692.z, _e737.unnamed_1.first_primitive));
                            phi_828_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_bvh_traverse_Tree(_e743.unnamed_1.root, _e692.w));
                        }
                        let _e751 = phi_828_;
                        phi_834_ = 0u;
                        phi_837_ = 0u;
                        loop {
                            let _e761 = phi_834_;
                            let _e763 = phi_837_;
                            local_1 = _e763;
                            local_2 = _e763;
                            local_3 = _e763;
                            let _e764 = (_e761 < 8u);
                            if _e764 {
                                let _e766 = (_e761 >> bitcast<u32>(2i));
                                let _e767 = (_e761 & 3u);
                                if (_e766 == 0u) {
                                    phi_851_ = _e613.unnamed.root;
                                } else {
                                    phi_851_ = _e613.unnamed.first_primitive;
                                }
                                let _e770 = phi_851_;
                                if (_e766 == 0u) {
                                    phi_861_ = _e682.unnamed.root;
                                } else {
                                    phi_861_ = _e682.unnamed.first_primitive;
                                }
                                let _e779 = phi_861_;
                                if (_e766 == 0u) {
                                    phi_871_ = _e751.unnamed.root;
                                } else {
                                    phi_871_ = _e751.unnamed.first_primitive;
                                }
                                let _e788 = phi_871_;
                                let _e801 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e770 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 - _e304)), ((f32(((_e779 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 - _e305)));
                                let _e802 = core_intrinsics_maximum_number_nsz_f32_(_e801, ((f32(((_e788 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e306)));
                                if (_e766 == 0u) {
                                    phi_889_ = _e613.unnamed_1.root;
                                } else {
                                    phi_889_ = _e613.unnamed_1.first_primitive;
                                }
                                let _e805 = phi_889_;
                                if (_e766 == 0u) {
                                    phi_899_ = _e682.unnamed_1.root;
                                } else {
                                    phi_899_ = _e682.unnamed_1.first_primitive;
                                }
                                let _e814 = phi_899_;
                                if (_e766 == 0u) {
                                    phi_909_ = _e751.unnamed_1.root;
                                } else {
                                    phi_909_ = _e751.unnamed_1.first_primitive;
                                }
                                let _e823 = phi_909_;
                                let _e836 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e805 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e526) + (_e544 + _e304)), ((f32(((_e814 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e527) + (_e545 + _e305)));
                                let _e837 = core_intrinsics_minimum_number_nsz_f32_(_e836, ((f32(((_e823 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e306)));
                                if (_e802 <= _e837) {
                                    if (_e802 <= _e111) {
                                        if (_e837 >= 0f) {
                                            if (_e766 == 0u) {
                                                let _e844 = nodes.member[(0u + _e492)].links[2u];
                                                phi_945_ = _e844;
                                            } else {
                                                let _e847 = nodes.member[(0u + _e492)].links[3u];
                                                phi_945_ = _e847;
                                            }
                                            let _e849 = phi_945_;
                                            let _e854 = ((_e849 >> bitcast<u32>(((_e767 * 8u) & 31u))) & 255u);
                                            let _e855 = (_e854 & 31u);
                                            if (_e855 >= 24u) {
                                                phi_958_ = (24u + ((_e855 - 24u) ^ _e354));
                                            } else {
                                                phi_958_ = _e855;
                                            }
                                            let _e861 = phi_958_;
                                            phi_963_ = (_e763 | ((_e854 >> bitcast<u32>(5i)) << bitcast<u32>((_e861 & 31u))));
                                        } else {
                                            phi_963_ = _e763;
                                        }
                                        let _e869 = phi_963_;
                                        phi_964_ = _e869;
                                    } else {
                                        phi_964_ = _e763;
                                    }
                                    let _e871 = phi_964_;
                                    phi_965_ = _e871;
                                } else {
                                    phi_965_ = _e763;
                                }
                                let _e873 = phi_965_;
                                phi_835_ = (_e761 + 1u);
                                phi_838_ = _e873;
                            } else {
                                phi_835_ = u32();
                                phi_838_ = u32();
                            }
                            let _e876 = phi_835_;
                            let _e878 = phi_838_;
                            continue;
                            continuing {
                                phi_834_ = _e876;
                                phi_837_ = _e878;
                                break if !(_e764);
                            }
                        }
                        let _e882 = nodes.member[(0u + _e492)].links[0u];
                        let _e886 = nodes.member[(0u + _e492)].frame[3u];
                        let _e890 = local_1;
                        if ((_e890 & 4278190080u) == 0u) {
                        } else {
                            let _e894 = local.group_mask;
                            if ((_e894 & 4278190080u) == 0u) {
                            } else {
                                let _e898 = local.len;
                                if (_e898 < 32u) {
                                    let _e901 = local.group;
                                    let _e903 = local.len;
                                    if (_e903 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e903)] = _e901;
                                    let _e909 = local.group_mask;
                                    let _e911 = local.len;
                                    if (_e911 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e911)] = _e909;
                                    let _e918 = local.len;
                                    local.len = (_e918 + 1u);
                                }
                            }
                            local.group = (0u + _e882);
                            let _e922 = local_2;
                            local.group_mask = ((_e922 & 4278190080u) | (_e886 >> bitcast<u32>(24i)));
                        }
                        let _e927 = local_3;
                        phi_1023_ = (_e927 & 16777215u);
                        phi_1026_ = _e494;
                        loop {
                            let _e930 = phi_1023_;
                            let _e932 = phi_1026_;
                            local_6 = _e932;
                            let _e933 = (_e930 == 0u);
                            local_4 = _e933;
                            local_7 = _e933;
                            if _e933 {
                                phi_1024_ = u32();
                                phi_1027_ = bool();
                                phi_1624_ = false;
                            } else {
                                let _e936 = nodes.member[(0u + _e492)].links[1u];
                                let _e941 = ((0u + _e936) + select(firstTrailingBit(_e930), 32u, (_e930 == 0u)));
                                if (_e941 < arrayLength((&triangles.member))) {
                                } else {
                                    return;
                                }
                                let _e948 = triangles.member[(0u + _e941)].v0_;
                                let _e950 = (_e948.x - _e101);
                                let _e952 = (_e948.y - _e103);
                                let _e954 = (_e948.z - _e105);
                                if (_e327 == 0u) {
                                    phi_1071_ = vec3<f32>(_e952, _e954, _e950);
                                } else {
                                    if (_e327 == 1u) {
                                        phi_1070_ = vec3<f32>(_e954, _e950, _e952);
                                    } else {
                                        phi_1070_ = (_e948 - vec3<f32>(_e101, _e103, _e105));
                                    }
                                    let _e962 = phi_1070_;
                                    phi_1071_ = _e962;
                                }
                                let _e964 = phi_1071_;
                                let _e968 = (_e964.x - (_e338 * _e964.z));
                                let _e972 = (_e964.y - (_e341 * _e964.z));
                                let _e974 = triangles.member[(0u + _e941)].v1_;
                                let _e976 = (_e974.x - _e101);
                                let _e978 = (_e974.y - _e103);
                                let _e980 = (_e974.z - _e105);
                                if (_e327 == 0u) {
                                    phi_1101_ = vec3<f32>(_e978, _e980, _e976);
                                } else {
                                    if (_e327 == 1u) {
                                        phi_1100_ = vec3<f32>(_e980, _e976, _e978);
                                    } else {
                                        phi_1100_ = (_e974 - vec3<f32>(_e101, _e103, _e105));
                                    }
                                    let _e988 = phi_1100_;
                                    phi_1101_ = _e988;
                                }
                                let _e990 = phi_1101_;
                                let _e994 = (_e990.x - (_e338 * _e990.z));
                                let _e998 = (_e990.y - (_e341 * _e990.z));
                                let _e1000 = triangles.member[(0u + _e941)].v2_;
                                let _e1002 = (_e1000.x - _e101);
                                let _e1004 = (_e1000.y - _e103);
                                let _e1006 = (_e1000.z - _e105);
                                if (_e327 == 0u) {
                                    phi_1131_ = vec3<f32>(_e1004, _e1006, _e1002);
                                } else {
                                    if (_e327 == 1u) {
                                        phi_1130_ = vec3<f32>(_e1006, _e1002, _e1004);
                                    } else {
                                        phi_1130_ = (_e1000 - vec3<f32>(_e101, _e103, _e105));
                                    }
                                    let _e1014 = phi_1130_;
                                    phi_1131_ = _e1014;
                                }
                                let _e1016 = phi_1131_;
                                let _e1020 = (_e1016.x - (_e338 * _e1016.z));
                                let _e1024 = (_e1016.y - (_e341 * _e1016.z));
                                if (_e994 < _e1020) {
                                    phi_1150_ = true;
                                } else {
                                    if (_e994 == _e1020) {
                                        phi_1149_ = (_e998 < _e1024);
                                    } else {
                                        phi_1149_ = false;
                                    }
                                    let _e1029 = phi_1149_;
                                    phi_1150_ = _e1029;
                                }
                                let _e1031 = phi_1150_;
                                if _e1031 {
                                    phi_1154_ = _e1024;
                                    phi_1155_ = _e1020;
                                    phi_1156_ = _e998;
                                    phi_1157_ = _e994;
                                } else {
                                    phi_1154_ = _e998;
                                    phi_1155_ = _e994;
                                    phi_1156_ = _e1024;
                                    phi_1157_ = _e1020;
                                }
                                let _e1033 = phi_1154_;
                                let _e1035 = phi_1155_;
                                let _e1037 = phi_1156_;
                                let _e1039 = phi_1157_;
                                let _e1042 = ((_e1039 * _e1033) - (_e1037 * _e1035));
                                if _e1031 {
                                    phi_1165_ = -(_e1042);
                                } else {
                                    phi_1165_ = _e1042;
                                }
                                let _e1045 = phi_1165_;
                                if (_e1020 < _e968) {
                                    phi_1176_ = true;
                                } else {
                                    if (_e1020 == _e968) {
                                        phi_1175_ = (_e1024 < _e972);
                                    } else {
                                        phi_1175_ = false;
                                    }
                                    let _e1050 = phi_1175_;
                                    phi_1176_ = _e1050;
                                }
                                let _e1052 = phi_1176_;
                                if _e1052 {
                                    phi_1180_ = _e972;
                                    phi_1181_ = _e968;
                                    phi_1182_ = _e1024;
                                    phi_1183_ = _e1020;
                                } else {
                                    phi_1180_ = _e1024;
                                    phi_1181_ = _e1020;
                                    phi_1182_ = _e972;
                                    phi_1183_ = _e968;
                                }
                                let _e1054 = phi_1180_;
                                let _e1056 = phi_1181_;
                                let _e1058 = phi_1182_;
                                let _e1060 = phi_1183_;
                                let _e1063 = ((_e1060 * _e1054) - (_e1058 * _e1056));
                                if _e1052 {
                                    phi_1191_ = -(_e1063);
                                } else {
                                    phi_1191_ = _e1063;
                                }
                                let _e1066 = phi_1191_;
                                if (_e968 < _e994) {
                                    phi_1202_ = true;
                                } else {
                                    if (_e968 == _e994) {
                                        phi_1201_ = (_e972 < _e998);
                                    } else {
                                        phi_1201_ = false;
                                    }
                                    let _e1071 = phi_1201_;
                                    phi_1202_ = _e1071;
                                }
                                let _e1073 = phi_1202_;
                                if _e1073 {
                                    phi_1206_ = _e998;
                                    phi_1207_ = _e994;
                                    phi_1208_ = _e972;
                                    phi_1209_ = _e968;
                                } else {
                                    phi_1206_ = _e972;
                                    phi_1207_ = _e968;
                                    phi_1208_ = _e998;
                                    phi_1209_ = _e994;
                                }
                                let _e1075 = phi_1206_;
                                let _e1077 = phi_1207_;
                                let _e1079 = phi_1208_;
                                let _e1081 = phi_1209_;
                                let _e1084 = ((_e1081 * _e1075) - (_e1079 * _e1077));
                                if _e1073 {
                                    phi_1217_ = -(_e1084);
                                } else {
                                    phi_1217_ = _e1084;
                                }
                                let _e1087 = phi_1217_;
                                if (_e1045 >= 0f) {
                                    if (_e1066 >= 0f) {
                                        if (_e1087 >= 0f) {
                                            phi_1232_ = ((_e1045 + _e1066) + _e1087);
                                            phi_1233_ = false;
                                        } else {
                                            phi_1232_ = f32();
                                            phi_1233_ = true;
                                        }
                                        let _e1094 = phi_1232_;
                                        let _e1096 = phi_1233_;
                                        phi_1234_ = _e1094;
                                        phi_1235_ = _e1096;
                                    } else {
                                        phi_1234_ = f32();
                                        phi_1235_ = true;
                                    }
                                    let _e1098 = phi_1234_;
                                    let _e1100 = phi_1235_;
                                    phi_1236_ = _e1098;
                                    phi_1237_ = _e1100;
                                } else {
                                    phi_1236_ = f32();
                                    phi_1237_ = true;
                                }
                                let _e1102 = phi_1236_;
                                let _e1104 = phi_1237_;
                                if _e1104 {
                                    if (_e1045 <= 0f) {
                                        if (_e1066 <= 0f) {
                                            let _e1107 = (_e1087 <= 0f);
                                            if _e1107 {
                                            }
                                            phi_1255_ = ((_e1045 + _e1066) + _e1087);
                                            phi_1256_ = false;
                                            phi_1257_ = _e1107;
                                        } else {
                                            phi_1255_ = f32();
                                            phi_1256_ = true;
                                            phi_1257_ = false;
                                        }
                                        let _e1111 = phi_1255_;
                                        let _e1113 = phi_1256_;
                                        let _e1115 = phi_1257_;
                                        phi_1258_ = _e1111;
                                        phi_1259_ = _e1113;
                                        phi_1260_ = _e1115;
                                    } else {
                                        phi_1258_ = f32();
                                        phi_1259_ = true;
                                        phi_1260_ = false;
                                    }
                                    let _e1117 = phi_1258_;
                                    let _e1119 = phi_1259_;
                                    let _e1121 = phi_1260_;
                                    if _e1119 {
                                        phi_1264_ = false;
                                    } else {
                                        phi_1264_ = _e1121;
                                    }
                                    let _e1123 = phi_1264_;
                                    phi_1265_ = _e1117;
                                    phi_1266_ = _e1123;
                                } else {
                                    phi_1265_ = _e1102;
                                    phi_1266_ = true;
                                }
                                let _e1125 = phi_1265_;
                                let _e1127 = phi_1266_;
                                if _e1127 {
                                    let _e1128 = (_e1125 == 0f);
                                    if _e1128 {
                                        phi_1582_ = lt_bvh_triangle_Intersection();
                                        phi_1583_ = false;
                                    } else {
                                        let _e1130 = triangles.member[(0u + _e941)].v0_;
                                        let _e1132 = (_e1130.x - _e101);
                                        let _e1134 = (_e1130.y - _e103);
                                        let _e1136 = (_e1130.z - _e105);
                                        if (_e327 == 0u) {
                                            phi_1295_ = vec3<f32>(_e1134, _e1136, _e1132);
                                        } else {
                                            if (_e327 == 1u) {
                                                phi_1294_ = vec3<f32>(_e1136, _e1132, _e1134);
                                            } else {
                                                phi_1294_ = (_e1130 - vec3<f32>(_e101, _e103, _e105));
                                            }
                                            let _e1144 = phi_1294_;
                                            phi_1295_ = _e1144;
                                        }
                                        let _e1146 = phi_1295_;
                                        let _e1148 = triangles.member[(0u + _e941)].v1_;
                                        let _e1150 = triangles.member[(0u + _e941)].v0_;
                                        let _e1153 = (_e1148.x - _e1150.x);
                                        let _e1156 = (_e1148.y - _e1150.y);
                                        let _e1159 = (_e1148.z - _e1150.z);
                                        if (_e327 == 0u) {
                                            phi_1321_ = vec3<f32>(_e1156, _e1159, _e1153);
                                        } else {
                                            if (_e327 == 1u) {
                                                phi_1320_ = vec3<f32>(_e1159, _e1153, _e1156);
                                            } else {
                                                phi_1320_ = (_e1148 - _e1150);
                                            }
                                            let _e1166 = phi_1320_;
                                            phi_1321_ = _e1166;
                                        }
                                        let _e1168 = phi_1321_;
                                        let _e1170 = triangles.member[(0u + _e941)].v2_;
                                        let _e1172 = triangles.member[(0u + _e941)].v0_;
                                        let _e1175 = (_e1170.x - _e1172.x);
                                        let _e1178 = (_e1170.y - _e1172.y);
                                        let _e1181 = (_e1170.z - _e1172.z);
                                        if (_e327 == 0u) {
                                            phi_1347_ = vec3<f32>(_e1178, _e1181, _e1175);
                                        } else {
                                            if (_e327 == 1u) {
                                                phi_1346_ = vec3<f32>(_e1181, _e1175, _e1178);
                                            } else {
                                                phi_1346_ = (_e1170 - _e1172);
                                            }
                                            let _e1188 = phi_1346_;
                                            phi_1347_ = _e1188;
                                        }
                                        let _e1190 = phi_1347_;
                                        let _e1197 = ((_e1168.y * _e1190.z) - (_e1168.z * _e1190.y));
                                        let _e1204 = ((_e1168.z * _e1190.x) - (_e1168.x * _e1190.z));
                                        let _e1211 = ((_e1168.x * _e1190.y) - (_e1168.y * _e1190.x));
                                        let _e1225 = (((1f / _e335.z) * (((_e1197 * _e1146.x) + (_e1204 * _e1146.y)) + (_e1211 * _e1146.z))) / (((_e1197 * _e338) + (_e1204 * _e341)) + _e1211));
                                        if (_e1225 > 0f) {
                                            if (_e1225 < _e111) {
                                                let _e1229 = triangles.member[(0u + _e941)].v0_;
                                                let _e1231 = triangles.member[(0u + _e941)].v1_;
                                                if (_e1229.x < _e1231.x) {
                                                    phi_1403_ = _e1229.x;
                                                } else {
                                                    phi_1403_ = _e1231.x;
                                                }
                                                let _e1238 = phi_1403_;
                                                if (_e1229.y < _e1231.y) {
                                                    phi_1412_ = _e1229.y;
                                                } else {
                                                    phi_1412_ = _e1231.y;
                                                }
                                                let _e1245 = phi_1412_;
                                                if (_e1229.z < _e1231.z) {
                                                    phi_1421_ = _e1229.z;
                                                } else {
                                                    phi_1421_ = _e1231.z;
                                                }
                                                let _e1252 = phi_1421_;
                                                let _e1254 = triangles.member[(0u + _e941)].v2_;
                                                if (_e1238 < _e1254.x) {
                                                    phi_1430_ = _e1238;
                                                } else {
                                                    phi_1430_ = _e1254.x;
                                                }
                                                let _e1259 = phi_1430_;
                                                if (_e1245 < _e1254.y) {
                                                    phi_1437_ = _e1245;
                                                } else {
                                                    phi_1437_ = _e1254.y;
                                                }
                                                let _e1264 = phi_1437_;
                                                if (_e1252 < _e1254.z) {
                                                    phi_1444_ = _e1252;
                                                } else {
                                                    phi_1444_ = _e1254.z;
                                                }
                                                let _e1269 = phi_1444_;
                                                let _e1271 = triangles.member[(0u + _e941)].v0_;
                                                let _e1273 = triangles.member[(0u + _e941)].v1_;
                                                if (_e1271.x > _e1273.x) {
                                                    phi_1457_ = _e1271.x;
                                                } else {
                                                    phi_1457_ = _e1273.x;
                                                }
                                                let _e1280 = phi_1457_;
                                                if (_e1271.y > _e1273.y) {
                                                    phi_1466_ = _e1271.y;
                                                } else {
                                                    phi_1466_ = _e1273.y;
                                                }
                                                let _e1287 = phi_1466_;
                                                if (_e1271.z > _e1273.z) {
                                                    phi_1475_ = _e1271.z;
                                                } else {
                                                    phi_1475_ = _e1273.z;
                                                }
                                                let _e1294 = phi_1475_;
                                                let _e1296 = triangles.member[(0u + _e941)].v2_;
                                                if (_e1280 > _e1296.x) {
                                                    phi_1484_ = _e1280;
                                                } else {
                                                    phi_1484_ = _e1296.x;
                                                }
                                                let _e1301 = phi_1484_;
                                                if (_e1287 > _e1296.y) {
                                                    phi_1491_ = _e1287;
                                                } else {
                                                    phi_1491_ = _e1296.y;
                                                }
                                                let _e1306 = phi_1491_;
                                                if (_e1294 > _e1296.z) {
                                                    phi_1498_ = _e1294;
                                                } else {
                                                    phi_1498_ = _e1296.z;
                                                }
                                                let _e1311 = phi_1498_;
                                                let _e1315 = ((_e1259 - _e101) * _e252);
                                                let _e1316 = ((_e1264 - _e103) * _e262);
                                                let _e1317 = ((_e1269 - _e105) * _e272);
                                                let _e1321 = ((_e1301 - _e101) * _e252);
                                                let _e1322 = ((_e1306 - _e103) * _e262);
                                                let _e1323 = ((_e1311 - _e105) * _e272);
                                                if (_e1315 < _e1321) {
                                                    phi_1515_ = _e1315;
                                                } else {
                                                    phi_1515_ = _e1321;
                                                }
                                                let _e1326 = phi_1515_;
                                                if (_e1316 < _e1322) {
                                                    phi_1520_ = _e1316;
                                                } else {
                                                    phi_1520_ = _e1322;
                                                }
                                                let _e1329 = phi_1520_;
                                                if (_e1317 < _e1323) {
                                                    phi_1525_ = _e1317;
                                                } else {
                                                    phi_1525_ = _e1323;
                                                }
                                                let _e1332 = phi_1525_;
                                                if (_e1315 > _e1321) {
                                                    phi_1533_ = _e1315;
                                                } else {
                                                    phi_1533_ = _e1321;
                                                }
                                                let _e1338 = phi_1533_;
                                                if (_e1316 > _e1322) {
                                                    phi_1538_ = _e1316;
                                                } else {
                                                    phi_1538_ = _e1322;
                                                }
                                                let _e1341 = phi_1538_;
                                                if (_e1317 > _e1323) {
                                                    phi_1543_ = _e1317;
                                                } else {
                                                    phi_1543_ = _e1323;
                                                }
                                                let _e1344 = phi_1543_;
                                                let _e1348 = core_intrinsics_maximum_number_nsz_f32_((_e1326 - _e311), (_e1329 - _e312));
                                                let _e1349 = core_intrinsics_maximum_number_nsz_f32_(_e1348, (_e1332 - _e313));
                                                let _e1350 = core_intrinsics_minimum_number_nsz_f32_((_e1338 + _e311), (_e1341 + _e312));
                                                let _e1351 = core_intrinsics_minimum_number_nsz_f32_(_e1350, (_e1344 + _e313));
                                                if (_e1349 > -300000000000000000000000000000000000000f) {
                                                    phi_1555_ = _e1349;
                                                } else {
                                                    phi_1555_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1354 = phi_1555_;
                                                if (_e1351 < 300000000000000000000000000000000000000f) {
                                                    phi_1560_ = _e1351;
                                                } else {
                                                    phi_1560_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1357 = phi_1560_;
                                                if (_e1225 < _e1354) {
                                                    phi_1565_ = _e1354;
                                                } else {
                                                    phi_1565_ = _e1225;
                                                }
                                                let _e1360 = phi_1565_;
                                                if (_e1360 > _e1357) {
                                                    phi_1570_ = _e1357;
                                                } else {
                                                    phi_1570_ = _e1360;
                                                }
                                                let _e1363 = phi_1570_;
                                                phi_1575_ = lt_bvh_triangle_Intersection(_e1363, (_e1066 / _e1125), (_e1087 / _e1125), (_e1354 <= _e1357));
                                                phi_1576_ = false;
                                            } else {
                                                phi_1575_ = lt_bvh_triangle_Intersection();
                                                phi_1576_ = true;
                                            }
                                            let _e1369 = phi_1575_;
                                            let _e1371 = phi_1576_;
                                            phi_1577_ = _e1369;
                                            phi_1578_ = _e1371;
                                        } else {
                                            phi_1577_ = lt_bvh_triangle_Intersection();
                                            phi_1578_ = true;
                                        }
                                        let _e1373 = phi_1577_;
                                        let _e1375 = phi_1578_;
                                        if _e1375 {
                                        }
                                        phi_1582_ = _e1373;
                                        phi_1583_ = _e1375;
                                    }
                                    let _e1377 = phi_1582_;
                                    let _e1379 = phi_1583_;
                                    phi_1584_ = _e1377;
                                    phi_1585_ = _e1128;
                                    phi_1586_ = _e1379;
                                } else {
                                    phi_1584_ = lt_bvh_triangle_Intersection();
                                    phi_1585_ = true;
                                    phi_1586_ = false;
                                }
                                let _e1381 = phi_1584_;
                                let _e1383 = phi_1585_;
                                let _e1385 = phi_1586_;
                                if _e1383 {
                                    phi_1590_ = true;
                                } else {
                                    phi_1590_ = _e1385;
                                }
                                let _e1387 = phi_1590_;
                                if _e1387 {
                                    phi_1594_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1594_ = _e1381;
                                }
                                let _e1389 = phi_1594_;
                                if _e1389.is_hit {
                                    if (_e1389.t > 0f) {
                                        if (_e1389.t < _e111) {
                                            if true {
                                                phi_1614_ = false;
                                            } else {
                                                phi_1614_ = true;
                                            }
                                            let _e1398 = phi_1614_;
                                            phi_1615_ = true;
                                            phi_1616_ = _e1398;
                                        } else {
                                            phi_1615_ = _e932;
                                            phi_1616_ = true;
                                        }
                                        let _e1400 = phi_1615_;
                                        let _e1402 = phi_1616_;
                                        phi_1617_ = _e1400;
                                        phi_1618_ = _e1402;
                                    } else {
                                        phi_1617_ = _e932;
                                        phi_1618_ = true;
                                    }
                                    let _e1404 = phi_1617_;
                                    let _e1406 = phi_1618_;
                                    phi_1619_ = _e1404;
                                    phi_1620_ = _e1406;
                                } else {
                                    phi_1619_ = _e932;
                                    phi_1620_ = true;
                                }
                                let _e1408 = phi_1619_;
                                let _e1410 = phi_1620_;
                                if _e1410 {
                                }
                                phi_1024_ = (_e930 & (_e930 - 1u));
                                phi_1027_ = _e1408;
                                phi_1624_ = _e1410;
                            }
                            let _e1412 = phi_1024_;
                            let _e1414 = phi_1027_;
                            let _e1416 = phi_1624_;
                            continue;
                            continuing {
                                phi_1023_ = _e1412;
                                phi_1026_ = _e1414;
                                break if !(_e1416);
                            }
                        }
                        let _e1419 = local_4;
                        if _e1419 {
                            let _e1421 = local.group_mask;
                            if ((_e1421 & 4278190080u) == 0u) {
                                let _e1425 = local.len;
                                if (_e1425 == 0u) {
                                    phi_1666_ = false;
                                } else {
                                    let _e1429 = local.len;
                                    local.len = (_e1429 - 1u);
                                    let _e1432 = local.len;
                                    if (_e1432 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1437 = local.first[(0u + _e1432)];
                                    local.group = _e1437;
                                    let _e1440 = local.len;
                                    if (_e1440 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1445 = local.mask[(0u + _e1440)];
                                    local.group_mask = _e1445;
                                    phi_1666_ = true;
                                }
                                let _e1448 = phi_1666_;
                                phi_1667_ = _e1448;
                            } else {
                                phi_1667_ = true;
                            }
                            let _e1450 = phi_1667_;
                            if _e1450 {
                                let _e1452 = local.group_mask;
                                let _e1458 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1452)), 32u, (_e1452 == 0u)));
                                let _e1462 = local.group_mask;
                                let _e1476 = local.group_mask;
                                local.group_mask = (_e1476 & ~((1u << bitcast<u32>((_e1458 & 31u)))));
                                let _e1479 = local.group;
                                phi_1698_ = (_e1479 + countOneBits(((_e1462 & ~((4294967295u << bitcast<u32>((((_e1458 - 24u) ^ _e354) & 31u))))) & 255u)));
                            } else {
                                phi_1698_ = 4294967295u;
                            }
                            let _e1482 = phi_1698_;
                            phi_1699_ = _e1482;
                        } else {
                            phi_1699_ = u32();
                        }
                        let _e1484 = phi_1699_;
                        phi_692_ = _e1484;
                        let _e1680 = local_6;
                        phi_695_ = _e1680;
                        let _e1683 = local_7;
                        phi_1700_ = _e1683;
                        phi_1701_ = false;
                    } else {
                        phi_692_ = u32();
                        phi_695_ = bool();
                        phi_1700_ = false;
                        phi_1701_ = true;
                    }
                    let _e1486 = phi_692_;
                    let _e1488 = phi_695_;
                    let _e1490 = phi_1700_;
                    let _e1492 = phi_1701_;
                    local_5 = _e1492;
                    continue;
                    continuing {
                        phi_691_ = _e1486;
                        phi_694_ = _e1488;
                        break if !(_e1490);
                    }
                }
                let _e1495 = local_5;
                if _e1495 {
                    phi_1705_ = false;
                } else {
                    phi_1705_ = true;
                }
                let _e1497 = phi_1705_;
                if _e1497 {
                    phi_1709_ = true;
                } else {
                    let _e1689 = local_8;
                    phi_1709_ = _e1689;
                }
                let _e1499 = phi_1709_;
                phi_1710_ = _e1499;
            }
            let _e1501 = phi_1710_;
            phi_1711_ = _e1501;
            phi_1712_ = _e176;
        } else {
            phi_1711_ = bool();
            phi_1712_ = true;
        }
        let _e1503 = phi_1711_;
        let _e1505 = phi_1712_;
        if _e1505 {
            phi_1716_ = false;
        } else {
            phi_1716_ = _e1503;
        }
        let _e1507 = phi_1716_;
        if _e1507 {
            phi_1720_ = 0f;
        } else {
            phi_1720_ = 1f;
        }
        let _e1509 = phi_1720_;
        if (_e81 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e81)] = _e1509;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
