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
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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

struct lt_bvh_Instance {
    world_to_object: array<vec4<f32>, 3>,
    object_to_world: array<vec4<f32>, 3>,
    low_world: vec3<f32>,
    root: u32,
    high_world: vec3<f32>,
    first_triangle: u32,
    source: u32,
    padding: array<u32, 3>,
}

struct type_38 {
    member: array<lt_bvh_Instance>,
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

struct type_47 {
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

struct type_53 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(6) 
var<storage> instances: type_38;
@group(0) @binding(0) 
var<uniform> p: type_53;
@group(0) @binding(2) 
var<storage> nodes: type_47;
@group(0) @binding(3) 
var<storage> triangles: type_31;
@group(0) @binding(5) 
var<storage> list: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_162_: bool;
    var phi_166_: f32;

    if (param != param) {
        phi_162_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_162_ = _e54;
    }
    let _e56 = phi_162_;
    if _e56 {
        phi_166_ = param_1;
    } else {
        phi_166_ = param;
    }
    let _e58 = phi_166_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_178_: bool;
    var phi_182_: f32;

    if (param_2 != param_2) {
        phi_178_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_178_ = _e54;
    }
    let _e56 = phi_178_;
    if _e56 {
        phi_182_ = param_3;
    } else {
        phi_182_ = param_2;
    }
    let _e58 = phi_182_;
    return _e58;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_265_: f32;
    var phi_321_: bool;
    var phi_322_: bool;
    var phi_323_: bool;
    var phi_327_: bool;
    var phi_328_: bool;
    var phi_329_: bool;
    var phi_330_: bool;
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
    var phi_348_: bool;
    var phi_352_: bool;
    var phi_422_: f32;
    var phi_429_: f32;
    var phi_436_: f32;
    var phi_443_: f32;
    var phi_450_: f32;
    var phi_457_: f32;
    var phi_474_: f32;
    var phi_479_: f32;
    var phi_484_: f32;
    var phi_505_: u32;
    var phi_510_: u32;
    var phi_515_: u32;
    var phi_629_: bool;
    var phi_630_: bool;
    var phi_661_: u32;
    var phi_663_: u32;
    var phi_744_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_771_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_798_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_804_: u32;
    var phi_807_: u32;
    var phi_821_: u32;
    var phi_831_: u32;
    var phi_841_: u32;
    var phi_859_: u32;
    var phi_869_: u32;
    var phi_879_: u32;
    var phi_915_: u32;
    var phi_928_: u32;
    var phi_933_: u32;
    var phi_934_: u32;
    var phi_935_: u32;
    var phi_805_: u32;
    var phi_808_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_993_: u32;
    var phi_1043_: f32;
    var phi_1048_: f32;
    var phi_1053_: f32;
    var phi_1061_: f32;
    var phi_1066_: f32;
    var phi_1071_: f32;
    var phi_1215_: bool;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1221_: bool;
    var phi_1222_: bool;
    var phi_1223_: bool;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1228_: bool;
    var phi_1229_: bool;
    var phi_1230_: bool;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1235_: bool;
    var phi_1236_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1242_: bool;
    var phi_1246_: bool;
    var phi_1316_: f32;
    var phi_1323_: f32;
    var phi_1330_: f32;
    var phi_1337_: f32;
    var phi_1344_: f32;
    var phi_1351_: f32;
    var phi_1368_: f32;
    var phi_1373_: f32;
    var phi_1378_: f32;
    var phi_1406_: bool;
    var phi_1407_: bool;
    var phi_1415_: u32;
    var phi_1416_: u32;
    var phi_1427_: vec3<f32>;
    var phi_1428_: vec3<f32>;
    var phi_1441_: u32;
    var phi_1446_: u32;
    var phi_1451_: u32;
    var phi_1565_: bool;
    var phi_1566_: bool;
    var phi_1597_: u32;
    var phi_1599_: u32;
    var phi_1680_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1707_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1734_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1740_: u32;
    var phi_1743_: u32;
    var phi_1757_: u32;
    var phi_1767_: u32;
    var phi_1777_: u32;
    var phi_1795_: u32;
    var phi_1805_: u32;
    var phi_1815_: u32;
    var phi_1851_: u32;
    var phi_1864_: u32;
    var phi_1869_: u32;
    var phi_1870_: u32;
    var phi_1871_: u32;
    var phi_1741_: u32;
    var phi_1744_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1929_: u32;
    var phi_1974_: vec3<f32>;
    var phi_1975_: vec3<f32>;
    var phi_2004_: vec3<f32>;
    var phi_2005_: vec3<f32>;
    var phi_2034_: vec3<f32>;
    var phi_2035_: vec3<f32>;
    var phi_2053_: bool;
    var phi_2054_: bool;
    var phi_2058_: f32;
    var phi_2059_: f32;
    var phi_2060_: f32;
    var phi_2061_: f32;
    var phi_2069_: f32;
    var phi_2079_: bool;
    var phi_2080_: bool;
    var phi_2084_: f32;
    var phi_2085_: f32;
    var phi_2086_: f32;
    var phi_2087_: f32;
    var phi_2095_: f32;
    var phi_2105_: bool;
    var phi_2106_: bool;
    var phi_2110_: f32;
    var phi_2111_: f32;
    var phi_2112_: f32;
    var phi_2113_: f32;
    var phi_2121_: f32;
    var phi_2136_: f32;
    var phi_2137_: bool;
    var phi_2138_: f32;
    var phi_2139_: bool;
    var phi_2140_: f32;
    var phi_2141_: bool;
    var phi_2159_: f32;
    var phi_2160_: bool;
    var phi_2161_: bool;
    var phi_2162_: f32;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2168_: bool;
    var phi_2169_: f32;
    var phi_2170_: bool;
    var phi_2198_: vec3<f32>;
    var phi_2199_: vec3<f32>;
    var phi_2224_: vec3<f32>;
    var phi_2225_: vec3<f32>;
    var phi_2250_: vec3<f32>;
    var phi_2251_: vec3<f32>;
    var phi_2307_: f32;
    var phi_2316_: f32;
    var phi_2325_: f32;
    var phi_2334_: f32;
    var phi_2341_: f32;
    var phi_2348_: f32;
    var phi_2361_: f32;
    var phi_2370_: f32;
    var phi_2379_: f32;
    var phi_2388_: f32;
    var phi_2395_: f32;
    var phi_2402_: f32;
    var phi_2419_: f32;
    var phi_2424_: f32;
    var phi_2429_: f32;
    var phi_2437_: f32;
    var phi_2442_: f32;
    var phi_2447_: f32;
    var phi_2459_: f32;
    var phi_2464_: f32;
    var phi_2469_: f32;
    var phi_2474_: f32;
    var phi_2479_: lt_bvh_triangle_Intersection;
    var phi_2480_: bool;
    var phi_2481_: lt_bvh_triangle_Intersection;
    var phi_2482_: bool;
    var phi_2486_: lt_bvh_triangle_Intersection;
    var phi_2487_: bool;
    var phi_2488_: lt_bvh_triangle_Intersection;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2494_: bool;
    var phi_2498_: lt_bvh_triangle_Intersection;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2538_: bool;
    var phi_2539_: bool;
    var phi_1930_: u32;
    var phi_2540_: bool;
    var phi_2541_: bool;
    var phi_2542_: bool;
    var local_8: bool;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2616_: u32;
    var phi_2617_: u32;
    var phi_2618_: bool;
    var phi_2619_: bool;
    var phi_1600_: u32;
    var phi_2620_: bool;
    var phi_2621_: bool;
    var phi_2622_: bool;
    var phi_2623_: bool;
    var local_9: bool;
    var phi_2627_: bool;
    var phi_2628_: bool;
    var phi_2632_: bool;
    var phi_2636_: bool;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2643_: bool;
    var phi_2647_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2650_: bool;
    var phi_994_: u32;
    var phi_2654_: bool;
    var local_10: bool;
    var phi_2696_: bool;
    var phi_2697_: bool;
    var phi_2728_: u32;
    var phi_2729_: u32;
    var phi_664_: u32;
    var phi_2730_: bool;
    var phi_2731_: bool;
    var local_11: bool;
    var phi_2735_: bool;
    var phi_2739_: bool;
    var phi_2740_: bool;
    var phi_2741_: bool;
    var phi_2742_: bool;
    var phi_2746_: bool;
    var phi_2750_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e53 = id_1;
    let _e60 = arrayLength((&nodes.member));
    let _e69 = arrayLength((&list.member));
    let _e76 = ((_e53.y * 2097152u) + _e53.x);
    if (3u < _e69) {
    } else {
        return;
    }
    let _e79 = list.member[3u];
    if (_e76 < _e79) {
        let _e81 = (_e76 + 4u);
        if (_e81 < _e69) {
        } else {
            return;
        }
        let _e85 = list.member[(0u + _e81)];
        let _e87 = p.member.root;
        if (_e85 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e93 = samples.member[(0u + _e85)].position;
        let _e95 = samples.member[(0u + _e85)].normal;
        let _e97 = samples.member[(0u + _e85)].magnitude;
        let _e99 = ((8f / 8388608f) * _e97);
        let _e107 = (_e93.x + (_e95.x * _e99));
        let _e109 = (_e93.y + (_e95.y * _e99));
        let _e111 = (_e93.z + (_e95.z * _e99));
        let _e113 = p.member.light.place;
        if (_e113.w == 0f) {
            phi_265_ = 300000000000000000000000000000000000000f;
        } else {
            phi_265_ = 1f;
        }
        let _e117 = phi_265_;
        let _e125 = (_e113.x - (_e107 * _e113.w));
        let _e126 = (_e113.y - (_e109 * _e113.w));
        let _e127 = (_e113.z - (_e111 * _e113.w));
        let _e131 = abs(_e125);
        let _e132 = abs(_e126);
        let _e133 = abs(_e127);
        if (abs(_e107) < 1000000000000000f) {
            if (abs(_e109) < 1000000000000000f) {
                if (abs(_e111) < 1000000000000000f) {
                    if (_e131 < 1000000000000000f) {
                        if (_e132 < 1000000000000000f) {
                            if (_e133 < 1000000000000000f) {
                                if (_e131 > 0f) {
                                    phi_322_ = bool();
                                    phi_323_ = true;
                                } else {
                                    let _e141 = (_e132 > 0f);
                                    if _e141 {
                                        phi_321_ = bool();
                                    } else {
                                        phi_321_ = (_e133 > 0f);
                                    }
                                    let _e144 = phi_321_;
                                    phi_322_ = _e144;
                                    phi_323_ = _e141;
                                }
                                let _e146 = phi_322_;
                                let _e148 = phi_323_;
                                if _e148 {
                                    phi_327_ = true;
                                } else {
                                    phi_327_ = _e146;
                                }
                                let _e150 = phi_327_;
                                phi_328_ = _e150;
                                phi_329_ = false;
                            } else {
                                phi_328_ = bool();
                                phi_329_ = true;
                            }
                            let _e152 = phi_328_;
                            let _e154 = phi_329_;
                            phi_330_ = _e152;
                            phi_331_ = false;
                            phi_332_ = _e154;
                        } else {
                            phi_330_ = bool();
                            phi_331_ = true;
                            phi_332_ = false;
                        }
                        let _e156 = phi_330_;
                        let _e158 = phi_331_;
                        let _e160 = phi_332_;
                        phi_333_ = _e156;
                        phi_334_ = _e158;
                        phi_335_ = _e160;
                    } else {
                        phi_333_ = bool();
                        phi_334_ = true;
                        phi_335_ = false;
                    }
                    let _e162 = phi_333_;
                    let _e164 = phi_334_;
                    let _e166 = phi_335_;
                    phi_336_ = _e162;
                    phi_337_ = _e164;
                    phi_338_ = _e166;
                } else {
                    phi_336_ = bool();
                    phi_337_ = true;
                    phi_338_ = false;
                }
                let _e168 = phi_336_;
                let _e170 = phi_337_;
                let _e172 = phi_338_;
                phi_339_ = _e168;
                phi_340_ = _e170;
                phi_341_ = _e172;
            } else {
                phi_339_ = bool();
                phi_340_ = true;
                phi_341_ = false;
            }
            let _e174 = phi_339_;
            let _e176 = phi_340_;
            let _e178 = phi_341_;
            phi_342_ = _e174;
            phi_343_ = _e176;
            phi_344_ = _e178;
        } else {
            phi_342_ = bool();
            phi_343_ = true;
            phi_344_ = false;
        }
        let _e180 = phi_342_;
        let _e182 = phi_343_;
        let _e184 = phi_344_;
        if _e182 {
            phi_348_ = true;
        } else {
            phi_348_ = _e184;
        }
        let _e186 = phi_348_;
        if _e186 {
            phi_352_ = false;
        } else {
            phi_352_ = _e180;
        }
        let _e188 = phi_352_;
        if _e188 {
            let _e189 = (_e87 >= _e60);
            if _e189 {
                phi_2740_ = bool();
            } else {
                if (_e87 < _e60) {
                } else {
                    return;
                }
                let _e195 = nodes.member[(0u + _e87)].frame[0u];
                let _e199 = nodes.member[(0u + _e87)].frame[1u];
                let _e203 = nodes.member[(0u + _e87)].frame[2u];
                let _e207 = nodes.member[(0u + _e87)].frame[0u];
                let _e211 = nodes.member[(0u + _e87)].frame[1u];
                let _e215 = nodes.member[(0u + _e87)].frame[2u];
                let _e219 = nodes.member[(0u + _e87)].frame[3u];
                let _e253 = core_intrinsics_maximum_number_nsz_f32_(abs(_e125), abs(_e126));
                let _e254 = core_intrinsics_maximum_number_nsz_f32_(_e253, abs(_e127));
                let _e255 = (_e254 * 0.0000000000009094947f);
                if (abs(_e125) < _e255) {
                    phi_422_ = _e255;
                } else {
                    phi_422_ = abs(_e125);
                }
                let _e260 = phi_422_;
                if (_e125 < 0f) {
                    phi_429_ = (-1f / _e260);
                } else {
                    phi_429_ = (1f / _e260);
                }
                let _e265 = phi_429_;
                if (abs(_e126) < _e255) {
                    phi_436_ = _e255;
                } else {
                    phi_436_ = abs(_e126);
                }
                let _e270 = phi_436_;
                if (_e126 < 0f) {
                    phi_443_ = (-1f / _e270);
                } else {
                    phi_443_ = (1f / _e270);
                }
                let _e275 = phi_443_;
                if (abs(_e127) < _e255) {
                    phi_450_ = _e255;
                } else {
                    phi_450_ = abs(_e127);
                }
                let _e280 = phi_450_;
                if (_e127 < 0f) {
                    phi_457_ = (-1f / _e280);
                } else {
                    phi_457_ = (1f / _e280);
                }
                let _e285 = phi_457_;
                let _e289 = abs((bitcast<f32>(_e195) - _e107));
                let _e290 = abs((bitcast<f32>(_e199) - _e109));
                let _e291 = abs((bitcast<f32>(_e203) - _e111));
                let _e295 = abs(((bitcast<f32>(_e207) + (bitcast<f32>((((_e219 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e107));
                let _e296 = abs(((bitcast<f32>(_e211) + (bitcast<f32>((((_e219 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e109));
                let _e297 = abs(((bitcast<f32>(_e215) + (bitcast<f32>((((_e219 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e111));
                if (_e289 > _e295) {
                    phi_474_ = _e289;
                } else {
                    phi_474_ = _e295;
                }
                let _e300 = phi_474_;
                if (_e290 > _e296) {
                    phi_479_ = _e290;
                } else {
                    phi_479_ = _e296;
                }
                let _e303 = phi_479_;
                if (_e291 > _e297) {
                    phi_484_ = _e291;
                } else {
                    phi_484_ = _e297;
                }
                let _e306 = phi_484_;
                let _e307 = core_intrinsics_maximum_number_nsz_f32_(_e300, _e303);
                let _e308 = core_intrinsics_maximum_number_nsz_f32_(_e307, _e306);
                let _e312 = (_e308 * 0.0000019073486f);
                let _e313 = (abs(_e265) * _e312);
                let _e314 = (abs(_e275) * _e312);
                let _e315 = (abs(_e285) * _e312);
                let _e319 = (_e308 * 0.0000009536743f);
                let _e320 = (abs(_e265) * _e319);
                let _e321 = (abs(_e275) * _e319);
                let _e322 = (abs(_e285) * _e319);
                if (_e265 < 0f) {
                    phi_505_ = 0u;
                } else {
                    phi_505_ = 1u;
                }
                let _e325 = phi_505_;
                if (_e275 < 0f) {
                    phi_510_ = 0u;
                } else {
                    phi_510_ = 2u;
                }
                let _e328 = phi_510_;
                if (_e285 < 0f) {
                    phi_515_ = 0u;
                } else {
                    phi_515_ = 4u;
                }
                let _e331 = phi_515_;
                let _e333 = ((_e325 | _e328) | _e331);
                let _e334 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e87, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e334.first[0], _e334.first[1], _e334.first[2], _e334.first[3], _e334.first[4], _e334.first[5], _e334.first[6], _e334.first[7], _e334.first[8], _e334.first[9], _e334.first[10], _e334.first[11], _e334.first[12], _e334.first[13], _e334.first[14], _e334.first[15], _e334.first[16], _e334.first[17], _e334.first[18], _e334.first[19], _e334.first[20], _e334.first[21], _e334.first[22], _e334.first[23], _e334.first[24], _e334.first[25], _e334.first[26], _e334.first[27], _e334.first[28], _e334.first[29], _e334.first[30], _e334.first[31]), array<u32, 32>(_e334.mask[0], _e334.mask[1], _e334.mask[2], _e334.mask[3], _e334.mask[4], _e334.mask[5], _e334.mask[6], _e334.mask[7], _e334.mask[8], _e334.mask[9], _e334.mask[10], _e334.mask[11], _e334.mask[12], _e334.mask[13], _e334.mask[14], _e334.mask[15], _e334.mask[16], _e334.mask[17], _e334.mask[18], _e334.mask[19], _e334.mask[20], _e334.mask[21], _e334.mask[22], _e334.mask[23], _e334.mask[24], _e334.mask[25], _e334.mask[26], _e334.mask[27], _e334.mask[28], _e334.mask[29], _e334.mask[30], _e334.mask[31]), _e334.len, _e334.group, _e334.group_mask);
                let _e408 = local_1.group_mask;
                if ((_e408 & 4278190080u) == 0u) {
                    let _e412 = local_1.len;
                    if (_e412 == 0u) {
                        phi_629_ = false;
                    } else {
                        let _e416 = local_1.len;
                        local_1.len = (_e416 - 1u);
                        let _e419 = local_1.len;
                        if (_e419 < 32u) {
                        } else {
                            return;
                        }
                        let _e424 = local_1.first[(0u + _e419)];
                        local_1.group = _e424;
                        let _e427 = local_1.len;
                        if (_e427 < 32u) {
                        } else {
                            return;
                        }
                        let _e432 = local_1.mask[(0u + _e427)];
                        local_1.group_mask = _e432;
                        phi_629_ = true;
                    }
                    let _e435 = phi_629_;
                    phi_630_ = _e435;
                } else {
                    phi_630_ = true;
                }
                let _e437 = phi_630_;
                if _e437 {
                    let _e439 = local_1.group_mask;
                    let _e445 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e439)), 32u, (_e439 == 0u)));
                    let _e449 = local_1.group_mask;
                    let _e463 = local_1.group_mask;
                    local_1.group_mask = (_e463 & ~((1u << bitcast<u32>((_e445 & 31u)))));
                    let _e466 = local_1.group;
                    phi_661_ = (_e466 + countOneBits(((_e449 & ~((4294967295u << bitcast<u32>((((_e445 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_661_ = 4294967295u;
                }
                let _e469 = phi_661_;
                phi_663_ = _e469;
                loop {
                    let _e471 = phi_663_;
                    if (_e471 != 4294967295u) {
                        if (_e471 < _e60) {
                        } else {
                            return;
                        }
                        let _e478 = nodes.member[(0u + _e471)].frame[3u];
                        let _e503 = (bitcast<f32>((((_e478 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e265);
                        let _e504 = (bitcast<f32>((((_e478 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e275);
                        let _e505 = (bitcast<f32>((((_e478 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e285);
                        let _e508 = nodes.member[(0u + _e471)].frame[0u];
                        let _e512 = nodes.member[(0u + _e471)].frame[1u];
                        let _e516 = nodes.member[(0u + _e471)].frame[2u];
                        let _e521 = ((bitcast<f32>(_e508) - _e107) * _e265);
                        let _e522 = ((bitcast<f32>(_e512) - _e109) * _e275);
                        let _e523 = ((bitcast<f32>(_e516) - _e111) * _e285);
                        let _e531 = nodes.member[(0u + _e471)].x;
                        if (_e265 < 0f) {
                            let _e542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e531.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e542.unnamed.root, _e531.w), _e542.unnamed_1);
                            let _e554 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e548.unnamed, lt_bvh_traverse_Tree(_e531.x, _e548.unnamed_1.first_primitive));
                            phi_744_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e554.unnamed, lt_bvh_traverse_Tree(_e554.unnamed_1.root, _e531.y));
                        } else {
                            let _e570 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e531.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e570.unnamed.root, _e531.y), _e570.unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e576.unnamed, lt_bvh_traverse_Tree(_e531.z, _e576.unnamed_1.first_primitive));
                            phi_744_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e582.unnamed_1.root, _e531.w));
                        }
                        let _e590 = phi_744_;
                        let _e600 = nodes.member[(0u + _e471)].y;
                        if (_e275 < 0f) {
                            let _e611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e600.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e611.unnamed.root, _e600.w), _e611.unnamed_1);
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e617.unnamed, lt_bvh_traverse_Tree(_e600.x, _e617.unnamed_1.first_primitive));
                            phi_771_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e623.unnamed, lt_bvh_traverse_Tree(_e623.unnamed_1.root, _e600.y));
                        } else {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e600.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e600.y), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e600.z, _e645.unnamed_1.first_primitive));
                            phi_771_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e600.w));
                        }
                        let _e659 = phi_771_;
                        let _e669 = nodes.member[(0u + _e471)].z;
                        if (_e285 < 0f) {
                            let _e680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e669.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e680.unnamed.root, _e669.w), _e680.unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e686.unnamed, lt_bvh_traverse_Tree(_e669.x, _e686.unnamed_1.first_primitive));
                            phi_798_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e692.unnamed_1.root, _e669.y));
                        } else {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e669.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e669.y), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e669.z, _e714.unnamed_1.first_primitive));
                            phi_798_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e669.w));
                        }
                        let _e728 = phi_798_;
                        phi_804_ = 0u;
                        phi_807_ = 0u;
                        loop {
                            let _e738 = phi_804_;
                            let _e740 = phi_807_;
                            local_2 = _e740;
                            local_3 = _e740;
                            local_4 = _e740;
                            let _e741 = (_e738 < 8u);
                            if _e741 {
                                let _e743 = (_e738 >> bitcast<u32>(2i));
                                let _e744 = (_e738 & 3u);
                                if (_e743 == 0u) {
                                    phi_821_ = _e590.unnamed.root;
                                } else {
                                    phi_821_ = _e590.unnamed.first_primitive;
                                }
                                let _e747 = phi_821_;
                                if (_e743 == 0u) {
                                    phi_831_ = _e659.unnamed.root;
                                } else {
                                    phi_831_ = _e659.unnamed.first_primitive;
                                }
                                let _e756 = phi_831_;
                                if (_e743 == 0u) {
                                    phi_841_ = _e728.unnamed.root;
                                } else {
                                    phi_841_ = _e728.unnamed.first_primitive;
                                }
                                let _e765 = phi_841_;
                                let _e778 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e747 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e503) + (_e521 - _e313)), ((f32(((_e756 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e504) + (_e522 - _e314)));
                                let _e779 = core_intrinsics_maximum_number_nsz_f32_(_e778, ((f32(((_e765 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e505) + (_e523 - _e315)));
                                if (_e743 == 0u) {
                                    phi_859_ = _e590.unnamed_1.root;
                                } else {
                                    phi_859_ = _e590.unnamed_1.first_primitive;
                                }
                                let _e782 = phi_859_;
                                if (_e743 == 0u) {
                                    phi_869_ = _e659.unnamed_1.root;
                                } else {
                                    phi_869_ = _e659.unnamed_1.first_primitive;
                                }
                                let _e791 = phi_869_;
                                if (_e743 == 0u) {
                                    phi_879_ = _e728.unnamed_1.root;
                                } else {
                                    phi_879_ = _e728.unnamed_1.first_primitive;
                                }
                                let _e800 = phi_879_;
                                let _e813 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e782 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e503) + (_e521 + _e313)), ((f32(((_e791 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e504) + (_e522 + _e314)));
                                let _e814 = core_intrinsics_minimum_number_nsz_f32_(_e813, ((f32(((_e800 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u)) * _e505) + (_e523 + _e315)));
                                if (_e779 <= _e814) {
                                    if (_e779 <= _e117) {
                                        if (_e814 >= 0f) {
                                            if (_e743 == 0u) {
                                                let _e821 = nodes.member[(0u + _e471)].links[2u];
                                                phi_915_ = _e821;
                                            } else {
                                                let _e824 = nodes.member[(0u + _e471)].links[3u];
                                                phi_915_ = _e824;
                                            }
                                            let _e826 = phi_915_;
                                            let _e831 = ((_e826 >> bitcast<u32>(((_e744 * 8u) & 31u))) & 255u);
                                            let _e832 = (_e831 & 31u);
                                            if (_e832 >= 24u) {
                                                phi_928_ = (24u + ((_e832 - 24u) ^ _e333));
                                            } else {
                                                phi_928_ = _e832;
                                            }
                                            let _e838 = phi_928_;
                                            phi_933_ = (_e740 | ((_e831 >> bitcast<u32>(5i)) << bitcast<u32>((_e838 & 31u))));
                                        } else {
                                            phi_933_ = _e740;
                                        }
                                        let _e846 = phi_933_;
                                        phi_934_ = _e846;
                                    } else {
                                        phi_934_ = _e740;
                                    }
                                    let _e848 = phi_934_;
                                    phi_935_ = _e848;
                                } else {
                                    phi_935_ = _e740;
                                }
                                let _e850 = phi_935_;
                                phi_805_ = (_e738 + 1u);
                                phi_808_ = _e850;
                            } else {
                                phi_805_ = u32();
                                phi_808_ = u32();
                            }
                            let _e853 = phi_805_;
                            let _e855 = phi_808_;
                            continue;
                            continuing {
                                phi_804_ = _e853;
                                phi_807_ = _e855;
                                break if !(_e741);
                            }
                        }
                        let _e859 = nodes.member[(0u + _e471)].links[0u];
                        let _e863 = nodes.member[(0u + _e471)].frame[3u];
                        let _e867 = local_2;
                        if ((_e867 & 4278190080u) == 0u) {
                        } else {
                            let _e871 = local_1.group_mask;
                            if ((_e871 & 4278190080u) == 0u) {
                            } else {
                                let _e875 = local_1.len;
                                if (_e875 < 32u) {
                                    let _e878 = local_1.group;
                                    let _e880 = local_1.len;
                                    if (_e880 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e880)] = _e878;
                                    let _e886 = local_1.group_mask;
                                    let _e888 = local_1.len;
                                    if (_e888 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e888)] = _e886;
                                    let _e895 = local_1.len;
                                    local_1.len = (_e895 + 1u);
                                }
                            }
                            local_1.group = (_e87 + _e859);
                            let _e899 = local_3;
                            local_1.group_mask = ((_e899 & 4278190080u) | (_e863 >> bitcast<u32>(24i)));
                        }
                        let _e904 = local_4;
                        phi_993_ = (_e904 & 16777215u);
                        loop {
                            let _e907 = phi_993_;
                            let _e908 = (_e907 == 0u);
                            local_10 = _e908;
                            local_17 = _e908;
                            if _e908 {
                                phi_994_ = u32();
                                phi_2654_ = false;
                            } else {
                                let _e911 = nodes.member[(0u + _e471)].links[1u];
                                let _e915 = (_e911 + select(firstTrailingBit(_e907), 32u, (_e907 == 0u)));
                                if (_e915 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e922 = instances.member[(0u + _e915)].low_world;
                                let _e924 = instances.member[(0u + _e915)].high_world;
                                let _e931 = ((_e922.x - _e107) * _e265);
                                let _e932 = ((_e922.y - _e109) * _e275);
                                let _e933 = ((_e922.z - _e111) * _e285);
                                let _e940 = ((_e924.x - _e107) * _e265);
                                let _e941 = ((_e924.y - _e109) * _e275);
                                let _e942 = ((_e924.z - _e111) * _e285);
                                if (_e931 < _e940) {
                                    phi_1043_ = _e931;
                                } else {
                                    phi_1043_ = _e940;
                                }
                                let _e945 = phi_1043_;
                                if (_e932 < _e941) {
                                    phi_1048_ = _e932;
                                } else {
                                    phi_1048_ = _e941;
                                }
                                let _e948 = phi_1048_;
                                if (_e933 < _e942) {
                                    phi_1053_ = _e933;
                                } else {
                                    phi_1053_ = _e942;
                                }
                                let _e951 = phi_1053_;
                                if (_e931 > _e940) {
                                    phi_1061_ = _e931;
                                } else {
                                    phi_1061_ = _e940;
                                }
                                let _e957 = phi_1061_;
                                if (_e932 > _e941) {
                                    phi_1066_ = _e932;
                                } else {
                                    phi_1066_ = _e941;
                                }
                                let _e960 = phi_1066_;
                                if (_e933 > _e942) {
                                    phi_1071_ = _e933;
                                } else {
                                    phi_1071_ = _e942;
                                }
                                let _e963 = phi_1071_;
                                let _e967 = core_intrinsics_maximum_number_nsz_f32_((_e945 - _e320), (_e948 - _e321));
                                let _e968 = core_intrinsics_maximum_number_nsz_f32_(_e967, (_e951 - _e322));
                                let _e969 = core_intrinsics_minimum_number_nsz_f32_((_e957 + _e320), (_e960 + _e321));
                                let _e970 = core_intrinsics_minimum_number_nsz_f32_(_e969, (_e963 + _e322));
                                if (_e968 <= _e970) {
                                    if (_e968 <= _e117) {
                                        if (_e970 >= 0f) {
                                            let _e976 = instances.member[(0u + _e915)].world_to_object[0u];
                                            let _e987 = ((((_e976.x * _e107) + (_e976.y * _e109)) + (_e976.z * _e111)) + (_e976.w * 1f));
                                            let _e989 = instances.member[(0u + _e915)].world_to_object[1u];
                                            let _e1000 = ((((_e989.x * _e107) + (_e989.y * _e109)) + (_e989.z * _e111)) + (_e989.w * 1f));
                                            let _e1002 = instances.member[(0u + _e915)].world_to_object[2u];
                                            let _e1013 = ((((_e1002.x * _e107) + (_e1002.y * _e109)) + (_e1002.z * _e111)) + (_e1002.w * 1f));
                                            let _e1016 = instances.member[(0u + _e915)].world_to_object[0u];
                                            let _e1027 = ((((_e1016.x * _e125) + (_e1016.y * _e126)) + (_e1016.z * _e127)) + (_e1016.w * 0f));
                                            let _e1029 = instances.member[(0u + _e915)].world_to_object[1u];
                                            let _e1040 = ((((_e1029.x * _e125) + (_e1029.y * _e126)) + (_e1029.z * _e127)) + (_e1029.w * 0f));
                                            let _e1042 = instances.member[(0u + _e915)].world_to_object[2u];
                                            let _e1053 = ((((_e1042.x * _e125) + (_e1042.y * _e126)) + (_e1042.z * _e127)) + (_e1042.w * 0f));
                                            let _e1056 = instances.member[(0u + _e915)].root;
                                            let _e1058 = instances.member[(0u + _e915)].first_triangle;
                                            let _e1062 = abs(_e1027);
                                            let _e1063 = abs(_e1040);
                                            let _e1064 = abs(_e1053);
                                            if (abs(_e987) < 1000000000000000f) {
                                                if (abs(_e1000) < 1000000000000000f) {
                                                    if (abs(_e1013) < 1000000000000000f) {
                                                        if (_e1062 < 1000000000000000f) {
                                                            if (_e1063 < 1000000000000000f) {
                                                                if (_e1064 < 1000000000000000f) {
                                                                    if (_e1062 > 0f) {
                                                                        phi_1216_ = bool();
                                                                        phi_1217_ = true;
                                                                    } else {
                                                                        let _e1072 = (_e1063 > 0f);
                                                                        if _e1072 {
                                                                            phi_1215_ = bool();
                                                                        } else {
                                                                            phi_1215_ = (_e1064 > 0f);
                                                                        }
                                                                        let _e1075 = phi_1215_;
                                                                        phi_1216_ = _e1075;
                                                                        phi_1217_ = _e1072;
                                                                    }
                                                                    let _e1077 = phi_1216_;
                                                                    let _e1079 = phi_1217_;
                                                                    if _e1079 {
                                                                        phi_1221_ = true;
                                                                    } else {
                                                                        phi_1221_ = _e1077;
                                                                    }
                                                                    let _e1081 = phi_1221_;
                                                                    phi_1222_ = _e1081;
                                                                    phi_1223_ = false;
                                                                } else {
                                                                    phi_1222_ = bool();
                                                                    phi_1223_ = true;
                                                                }
                                                                let _e1083 = phi_1222_;
                                                                let _e1085 = phi_1223_;
                                                                phi_1224_ = _e1083;
                                                                phi_1225_ = false;
                                                                phi_1226_ = _e1085;
                                                            } else {
                                                                phi_1224_ = bool();
                                                                phi_1225_ = true;
                                                                phi_1226_ = false;
                                                            }
                                                            let _e1087 = phi_1224_;
                                                            let _e1089 = phi_1225_;
                                                            let _e1091 = phi_1226_;
                                                            phi_1227_ = _e1087;
                                                            phi_1228_ = _e1089;
                                                            phi_1229_ = _e1091;
                                                        } else {
                                                            phi_1227_ = bool();
                                                            phi_1228_ = true;
                                                            phi_1229_ = false;
                                                        }
                                                        let _e1093 = phi_1227_;
                                                        let _e1095 = phi_1228_;
                                                        let _e1097 = phi_1229_;
                                                        phi_1230_ = _e1093;
                                                        phi_1231_ = _e1095;
                                                        phi_1232_ = _e1097;
                                                    } else {
                                                        phi_1230_ = bool();
                                                        phi_1231_ = true;
                                                        phi_1232_ = false;
                                                    }
                                                    let _e1099 = phi_1230_;
                                                    let _e1101 = phi_1231_;
                                                    let _e1103 = phi_1232_;
                                                    phi_1233_ = _e1099;
                                                    phi_1234_ = _e1101;
                                                    phi_1235_ = _e1103;
                                                } else {
                                                    phi_1233_ = bool();
                                                    phi_1234_ = true;
                                                    phi_1235_ = false;
                                                }
                                                let _e1105 = phi_1233_;
                                                let _e1107 = phi_1234_;
                                                let _e1109 = phi_1235_;
                                                phi_1236_ = _e1105;
                                                phi_1237_ = _e1107;
                                                phi_1238_ = _e1109;
                                            } else {
                                                phi_1236_ = bool();
                                                phi_1237_ = true;
                                                phi_1238_ = false;
                                            }
                                            let _e1111 = phi_1236_;
                                            let _e1113 = phi_1237_;
                                            let _e1115 = phi_1238_;
                                            if _e1113 {
                                                phi_1242_ = true;
                                            } else {
                                                phi_1242_ = _e1115;
                                            }
                                            let _e1117 = phi_1242_;
                                            if _e1117 {
                                                phi_1246_ = false;
                                            } else {
                                                phi_1246_ = _e1111;
                                            }
                                            let _e1119 = phi_1246_;
                                            if _e1119 {
                                                let _e1120 = (_e1056 >= _e60);
                                                if _e1120 {
                                                    phi_2637_ = bool();
                                                } else {
                                                    if (_e1056 < _e60) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1126 = nodes.member[(0u + _e1056)].frame[0u];
                                                    let _e1130 = nodes.member[(0u + _e1056)].frame[1u];
                                                    let _e1134 = nodes.member[(0u + _e1056)].frame[2u];
                                                    let _e1138 = nodes.member[(0u + _e1056)].frame[0u];
                                                    let _e1142 = nodes.member[(0u + _e1056)].frame[1u];
                                                    let _e1146 = nodes.member[(0u + _e1056)].frame[2u];
                                                    let _e1150 = nodes.member[(0u + _e1056)].frame[3u];
                                                    let _e1184 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1027), abs(_e1040));
                                                    let _e1185 = core_intrinsics_maximum_number_nsz_f32_(_e1184, abs(_e1053));
                                                    let _e1186 = (_e1185 * 0.0000000000009094947f);
                                                    if (abs(_e1027) < _e1186) {
                                                        phi_1316_ = _e1186;
                                                    } else {
                                                        phi_1316_ = abs(_e1027);
                                                    }
                                                    let _e1191 = phi_1316_;
                                                    if (_e1027 < 0f) {
                                                        phi_1323_ = (-1f / _e1191);
                                                    } else {
                                                        phi_1323_ = (1f / _e1191);
                                                    }
                                                    let _e1196 = phi_1323_;
                                                    if (abs(_e1040) < _e1186) {
                                                        phi_1330_ = _e1186;
                                                    } else {
                                                        phi_1330_ = abs(_e1040);
                                                    }
                                                    let _e1201 = phi_1330_;
                                                    if (_e1040 < 0f) {
                                                        phi_1337_ = (-1f / _e1201);
                                                    } else {
                                                        phi_1337_ = (1f / _e1201);
                                                    }
                                                    let _e1206 = phi_1337_;
                                                    if (abs(_e1053) < _e1186) {
                                                        phi_1344_ = _e1186;
                                                    } else {
                                                        phi_1344_ = abs(_e1053);
                                                    }
                                                    let _e1211 = phi_1344_;
                                                    if (_e1053 < 0f) {
                                                        phi_1351_ = (-1f / _e1211);
                                                    } else {
                                                        phi_1351_ = (1f / _e1211);
                                                    }
                                                    let _e1216 = phi_1351_;
                                                    let _e1220 = abs((bitcast<f32>(_e1126) - _e987));
                                                    let _e1221 = abs((bitcast<f32>(_e1130) - _e1000));
                                                    let _e1222 = abs((bitcast<f32>(_e1134) - _e1013));
                                                    let _e1226 = abs(((bitcast<f32>(_e1138) + (bitcast<f32>((((_e1150 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e987));
                                                    let _e1227 = abs(((bitcast<f32>(_e1142) + (bitcast<f32>((((_e1150 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1000));
                                                    let _e1228 = abs(((bitcast<f32>(_e1146) + (bitcast<f32>((((_e1150 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1013));
                                                    if (_e1220 > _e1226) {
                                                        phi_1368_ = _e1220;
                                                    } else {
                                                        phi_1368_ = _e1226;
                                                    }
                                                    let _e1231 = phi_1368_;
                                                    if (_e1221 > _e1227) {
                                                        phi_1373_ = _e1221;
                                                    } else {
                                                        phi_1373_ = _e1227;
                                                    }
                                                    let _e1234 = phi_1373_;
                                                    if (_e1222 > _e1228) {
                                                        phi_1378_ = _e1222;
                                                    } else {
                                                        phi_1378_ = _e1228;
                                                    }
                                                    let _e1237 = phi_1378_;
                                                    let _e1238 = core_intrinsics_maximum_number_nsz_f32_(_e1231, _e1234);
                                                    let _e1239 = core_intrinsics_maximum_number_nsz_f32_(_e1238, _e1237);
                                                    let _e1243 = (_e1239 * 0.0000019073486f);
                                                    let _e1244 = (abs(_e1196) * _e1243);
                                                    let _e1245 = (abs(_e1206) * _e1243);
                                                    let _e1246 = (abs(_e1216) * _e1243);
                                                    let _e1250 = (_e1239 * 0.0000009536743f);
                                                    let _e1251 = (abs(_e1196) * _e1250);
                                                    let _e1252 = (abs(_e1206) * _e1250);
                                                    let _e1253 = (abs(_e1216) * _e1250);
                                                    let _e1254 = abs(_e1027);
                                                    let _e1255 = abs(_e1040);
                                                    let _e1256 = abs(_e1053);
                                                    if (_e1254 >= _e1255) {
                                                        if (_e1254 >= _e1256) {
                                                            phi_1406_ = false;
                                                        } else {
                                                            phi_1406_ = true;
                                                        }
                                                        let _e1260 = phi_1406_;
                                                        phi_1407_ = _e1260;
                                                    } else {
                                                        phi_1407_ = true;
                                                    }
                                                    let _e1262 = phi_1407_;
                                                    if _e1262 {
                                                        if (_e1255 >= _e1256) {
                                                            phi_1415_ = 1u;
                                                        } else {
                                                            phi_1415_ = 2u;
                                                        }
                                                        let _e1265 = phi_1415_;
                                                        phi_1416_ = _e1265;
                                                    } else {
                                                        phi_1416_ = 0u;
                                                    }
                                                    let _e1267 = phi_1416_;
                                                    if (_e1267 == 0u) {
                                                        phi_1428_ = vec3<f32>(_e1040, _e1053, _e1027);
                                                    } else {
                                                        if (_e1267 == 1u) {
                                                            phi_1427_ = vec3<f32>(_e1053, _e1027, _e1040);
                                                        } else {
                                                            phi_1427_ = vec3<f32>(_e1027, _e1040, _e1053);
                                                        }
                                                        let _e1273 = phi_1427_;
                                                        phi_1428_ = _e1273;
                                                    }
                                                    let _e1275 = phi_1428_;
                                                    let _e1278 = (_e1275.x / _e1275.z);
                                                    let _e1281 = (_e1275.y / _e1275.z);
                                                    if (_e1196 < 0f) {
                                                        phi_1441_ = 0u;
                                                    } else {
                                                        phi_1441_ = 1u;
                                                    }
                                                    let _e1286 = phi_1441_;
                                                    if (_e1206 < 0f) {
                                                        phi_1446_ = 0u;
                                                    } else {
                                                        phi_1446_ = 2u;
                                                    }
                                                    let _e1289 = phi_1446_;
                                                    if (_e1216 < 0f) {
                                                        phi_1451_ = 0u;
                                                    } else {
                                                        phi_1451_ = 4u;
                                                    }
                                                    let _e1292 = phi_1451_;
                                                    let _e1294 = ((_e1286 | _e1289) | _e1292);
                                                    let _e1295 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1056, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1295.first[0], _e1295.first[1], _e1295.first[2], _e1295.first[3], _e1295.first[4], _e1295.first[5], _e1295.first[6], _e1295.first[7], _e1295.first[8], _e1295.first[9], _e1295.first[10], _e1295.first[11], _e1295.first[12], _e1295.first[13], _e1295.first[14], _e1295.first[15], _e1295.first[16], _e1295.first[17], _e1295.first[18], _e1295.first[19], _e1295.first[20], _e1295.first[21], _e1295.first[22], _e1295.first[23], _e1295.first[24], _e1295.first[25], _e1295.first[26], _e1295.first[27], _e1295.first[28], _e1295.first[29], _e1295.first[30], _e1295.first[31]), array<u32, 32>(_e1295.mask[0], _e1295.mask[1], _e1295.mask[2], _e1295.mask[3], _e1295.mask[4], _e1295.mask[5], _e1295.mask[6], _e1295.mask[7], _e1295.mask[8], _e1295.mask[9], _e1295.mask[10], _e1295.mask[11], _e1295.mask[12], _e1295.mask[13], _e1295.mask[14], _e1295.mask[15], _e1295.mask[16], _e1295.mask[17], _e1295.mask[18], _e1295.mask[19], _e1295.mask[20], _e1295.mask[21], _e1295.mask[22], _e1295.mask[23], _e1295.mask[24], _e1295.mask[25], _e1295.mask[26], _e1295.mask[27], _e1295.mask[28], _e1295.mask[29], _e1295.mask[30], _e1295.mask[31]), _e1295.len, _e1295.group, _e1295.group_mask);
                                                    let _e1369 = local.group_mask;
                                                    if ((_e1369 & 4278190080u) == 0u) {
                                                        let _e1373 = local.len;
                                                        if (_e1373 == 0u) {
                                                            phi_1565_ = false;
                                                        } else {
                                                            let _e1377 = local.len;
                                                            local.len = (_e1377 - 1u);
                                                            let _e1380 = local.len;
                                                            if (_e1380 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1385 = local.first[(0u + _e1380)];
                                                            local.group = _e1385;
                                                            let _e1388 = local.len;
                                                            if (_e1388 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1393 = local.mask[(0u + _e1388)];
                                                            local.group_mask = _e1393;
                                                            phi_1565_ = true;
                                                        }
                                                        let _e1396 = phi_1565_;
                                                        phi_1566_ = _e1396;
                                                    } else {
                                                        phi_1566_ = true;
                                                    }
                                                    let _e1398 = phi_1566_;
                                                    if _e1398 {
                                                        let _e1400 = local.group_mask;
                                                        let _e1406 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1400)), 32u, (_e1400 == 0u)));
                                                        let _e1410 = local.group_mask;
                                                        let _e1424 = local.group_mask;
                                                        local.group_mask = (_e1424 & ~((1u << bitcast<u32>((_e1406 & 31u)))));
                                                        let _e1427 = local.group;
                                                        phi_1597_ = (_e1427 + countOneBits(((_e1410 & ~((4294967295u << bitcast<u32>((((_e1406 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1597_ = 4294967295u;
                                                    }
                                                    let _e1430 = phi_1597_;
                                                    phi_1599_ = _e1430;
                                                    loop {
                                                        let _e1432 = phi_1599_;
                                                        if (_e1432 != 4294967295u) {
                                                            if (_e1432 < _e60) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1439 = nodes.member[(0u + _e1432)].frame[3u];
                                                            let _e1464 = (bitcast<f32>((((_e1439 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1196);
                                                            let _e1465 = (bitcast<f32>((((_e1439 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1206);
                                                            let _e1466 = (bitcast<f32>((((_e1439 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1216);
                                                            let _e1469 = nodes.member[(0u + _e1432)].frame[0u];
                                                            let _e1473 = nodes.member[(0u + _e1432)].frame[1u];
                                                            let _e1477 = nodes.member[(0u + _e1432)].frame[2u];
                                                            let _e1482 = ((bitcast<f32>(_e1469) - _e987) * _e1196);
                                                            let _e1483 = ((bitcast<f32>(_e1473) - _e1000) * _e1206);
                                                            let _e1484 = ((bitcast<f32>(_e1477) - _e1013) * _e1216);
                                                            let _e1492 = nodes.member[(0u + _e1432)].x;
                                                            if (_e1196 < 0f) {
                                                                let _e1503 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1492.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1509 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1503.unnamed.root, _e1492.w), _e1503.unnamed_1);
                                                                let _e1515 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1509.unnamed, lt_bvh_traverse_Tree(_e1492.x, _e1509.unnamed_1.first_primitive));
                                                                phi_1680_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1515.unnamed, lt_bvh_traverse_Tree(_e1515.unnamed_1.root, _e1492.y));
                                                            } else {
                                                                let _e1531 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1492.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1531.unnamed.root, _e1492.y), _e1531.unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1537.unnamed, lt_bvh_traverse_Tree(_e1492.z, _e1537.unnamed_1.first_primitive));
                                                                phi_1680_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1543.unnamed_1.root, _e1492.w));
                                                            }
                                                            let _e1551 = phi_1680_;
                                                            let _e1561 = nodes.member[(0u + _e1432)].y;
                                                            if (_e1206 < 0f) {
                                                                let _e1572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1561.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1572.unnamed.root, _e1561.w), _e1572.unnamed_1);
                                                                let _e1584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1578.unnamed, lt_bvh_traverse_Tree(_e1561.x, _e1578.unnamed_1.first_primitive));
                                                                phi_1707_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1584.unnamed, lt_bvh_traverse_Tree(_e1584.unnamed_1.root, _e1561.y));
                                                            } else {
                                                                let _e1600 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1561.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1600.unnamed.root, _e1561.y), _e1600.unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1606.unnamed, lt_bvh_traverse_Tree(_e1561.z, _e1606.unnamed_1.first_primitive));
                                                                phi_1707_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1612.unnamed_1.root, _e1561.w));
                                                            }
                                                            let _e1620 = phi_1707_;
                                                            let _e1630 = nodes.member[(0u + _e1432)].z;
                                                            if (_e1216 < 0f) {
                                                                let _e1641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1630.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1641.unnamed.root, _e1630.w), _e1641.unnamed_1);
                                                                let _e1653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1647.unnamed, lt_bvh_traverse_Tree(_e1630.x, _e1647.unnamed_1.first_primitive));
                                                                phi_1734_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1653.unnamed, lt_bvh_traverse_Tree(_e1653.unnamed_1.root, _e1630.y));
                                                            } else {
                                                                let _e1669 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1630.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1669.unnamed.root, _e1630.y), _e1669.unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1675.unnamed, lt_bvh_traverse_Tree(_e1630.z, _e1675.unnamed_1.first_primitive));
                                                                phi_1734_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1681.unnamed_1.root, _e1630.w));
                                                            }
                                                            let _e1689 = phi_1734_;
                                                            phi_1740_ = 0u;
                                                            phi_1743_ = 0u;
                                                            loop {
                                                                let _e1699 = phi_1740_;
                                                                let _e1701 = phi_1743_;
                                                                local_5 = _e1701;
                                                                local_6 = _e1701;
                                                                local_7 = _e1701;
                                                                let _e1702 = (_e1699 < 8u);
                                                                if _e1702 {
                                                                    let _e1704 = (_e1699 >> bitcast<u32>(2i));
                                                                    let _e1705 = (_e1699 & 3u);
                                                                    if (_e1704 == 0u) {
                                                                        phi_1757_ = _e1551.unnamed.root;
                                                                    } else {
                                                                        phi_1757_ = _e1551.unnamed.first_primitive;
                                                                    }
                                                                    let _e1708 = phi_1757_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1767_ = _e1620.unnamed.root;
                                                                    } else {
                                                                        phi_1767_ = _e1620.unnamed.first_primitive;
                                                                    }
                                                                    let _e1717 = phi_1767_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1777_ = _e1689.unnamed.root;
                                                                    } else {
                                                                        phi_1777_ = _e1689.unnamed.first_primitive;
                                                                    }
                                                                    let _e1726 = phi_1777_;
                                                                    let _e1739 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1708 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 - _e1244)), ((f32(((_e1717 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1465) + (_e1483 - _e1245)));
                                                                    let _e1740 = core_intrinsics_maximum_number_nsz_f32_(_e1739, ((f32(((_e1726 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1466) + (_e1484 - _e1246)));
                                                                    if (_e1704 == 0u) {
                                                                        phi_1795_ = _e1551.unnamed_1.root;
                                                                    } else {
                                                                        phi_1795_ = _e1551.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1743 = phi_1795_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1805_ = _e1620.unnamed_1.root;
                                                                    } else {
                                                                        phi_1805_ = _e1620.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1752 = phi_1805_;
                                                                    if (_e1704 == 0u) {
                                                                        phi_1815_ = _e1689.unnamed_1.root;
                                                                    } else {
                                                                        phi_1815_ = _e1689.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1761 = phi_1815_;
                                                                    let _e1774 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1743 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1464) + (_e1482 + _e1244)), ((f32(((_e1752 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1465) + (_e1483 + _e1245)));
                                                                    let _e1775 = core_intrinsics_minimum_number_nsz_f32_(_e1774, ((f32(((_e1761 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u)) * _e1466) + (_e1484 + _e1246)));
                                                                    if (_e1740 <= _e1775) {
                                                                        if (_e1740 <= _e117) {
                                                                            if (_e1775 >= 0f) {
                                                                                if (_e1704 == 0u) {
                                                                                    let _e1782 = nodes.member[(0u + _e1432)].links[2u];
                                                                                    phi_1851_ = _e1782;
                                                                                } else {
                                                                                    let _e1785 = nodes.member[(0u + _e1432)].links[3u];
                                                                                    phi_1851_ = _e1785;
                                                                                }
                                                                                let _e1787 = phi_1851_;
                                                                                let _e1792 = ((_e1787 >> bitcast<u32>(((_e1705 * 8u) & 31u))) & 255u);
                                                                                let _e1793 = (_e1792 & 31u);
                                                                                if (_e1793 >= 24u) {
                                                                                    phi_1864_ = (24u + ((_e1793 - 24u) ^ _e1294));
                                                                                } else {
                                                                                    phi_1864_ = _e1793;
                                                                                }
                                                                                let _e1799 = phi_1864_;
                                                                                phi_1869_ = (_e1701 | ((_e1792 >> bitcast<u32>(5i)) << bitcast<u32>((_e1799 & 31u))));
                                                                            } else {
                                                                                phi_1869_ = _e1701;
                                                                            }
                                                                            let _e1807 = phi_1869_;
                                                                            phi_1870_ = _e1807;
                                                                        } else {
                                                                            phi_1870_ = _e1701;
                                                                        }
                                                                        let _e1809 = phi_1870_;
                                                                        phi_1871_ = _e1809;
                                                                    } else {
                                                                        phi_1871_ = _e1701;
                                                                    }
                                                                    let _e1811 = phi_1871_;
                                                                    phi_1741_ = (_e1699 + 1u);
                                                                    phi_1744_ = _e1811;
                                                                } else {
                                                                    phi_1741_ = u32();
                                                                    phi_1744_ = u32();
                                                                }
                                                                let _e1814 = phi_1741_;
                                                                let _e1816 = phi_1744_;
                                                                continue;
                                                                continuing {
                                                                    phi_1740_ = _e1814;
                                                                    phi_1743_ = _e1816;
                                                                    break if !(_e1702);
                                                                }
                                                            }
                                                            let _e1820 = nodes.member[(0u + _e1432)].links[0u];
                                                            let _e1824 = nodes.member[(0u + _e1432)].frame[3u];
                                                            let _e1828 = local_5;
                                                            if ((_e1828 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1832 = local.group_mask;
                                                                if ((_e1832 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1836 = local.len;
                                                                    if (_e1836 < 32u) {
                                                                        let _e1839 = local.group;
                                                                        let _e1841 = local.len;
                                                                        if (_e1841 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1841)] = _e1839;
                                                                        let _e1847 = local.group_mask;
                                                                        let _e1849 = local.len;
                                                                        if (_e1849 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1849)] = _e1847;
                                                                        let _e1856 = local.len;
                                                                        local.len = (_e1856 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1056 + _e1820);
                                                                let _e1860 = local_6;
                                                                local.group_mask = ((_e1860 & 4278190080u) | (_e1824 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1865 = local_7;
                                                            phi_1929_ = (_e1865 & 16777215u);
                                                            loop {
                                                                let _e1868 = phi_1929_;
                                                                let _e1869 = (_e1868 == 0u);
                                                                local_8 = _e1869;
                                                                local_14 = _e1869;
                                                                if _e1869 {
                                                                    phi_1930_ = u32();
                                                                    phi_2540_ = false;
                                                                    phi_2541_ = false;
                                                                    phi_2542_ = false;
                                                                } else {
                                                                    let _e1872 = nodes.member[(0u + _e1432)].links[1u];
                                                                    let _e1877 = ((_e1058 + _e1872) + select(firstTrailingBit(_e1868), 32u, (_e1868 == 0u)));
                                                                    if (_e1877 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1884 = triangles.member[(0u + _e1877)].v0_;
                                                                    let _e1886 = (_e1884.x - _e987);
                                                                    let _e1888 = (_e1884.y - _e1000);
                                                                    let _e1890 = (_e1884.z - _e1013);
                                                                    if (_e1267 == 0u) {
                                                                        phi_1975_ = vec3<f32>(_e1888, _e1890, _e1886);
                                                                    } else {
                                                                        if (_e1267 == 1u) {
                                                                            phi_1974_ = vec3<f32>(_e1890, _e1886, _e1888);
                                                                        } else {
                                                                            phi_1974_ = (_e1884 - vec3<f32>(_e987, _e1000, _e1013));
                                                                        }
                                                                        let _e1898 = phi_1974_;
                                                                        phi_1975_ = _e1898;
                                                                    }
                                                                    let _e1900 = phi_1975_;
                                                                    let _e1904 = (_e1900.x - (_e1278 * _e1900.z));
                                                                    let _e1908 = (_e1900.y - (_e1281 * _e1900.z));
                                                                    let _e1910 = triangles.member[(0u + _e1877)].v1_;
                                                                    let _e1912 = (_e1910.x - _e987);
                                                                    let _e1914 = (_e1910.y - _e1000);
                                                                    let _e1916 = (_e1910.z - _e1013);
                                                                    if (_e1267 == 0u) {
                                                                        phi_2005_ = vec3<f32>(_e1914, _e1916, _e1912);
                                                                    } else {
                                                                        if (_e1267 == 1u) {
                                                                            phi_2004_ = vec3<f32>(_e1916, _e1912, _e1914);
                                                                        } else {
                                                                            phi_2004_ = (_e1910 - vec3<f32>(_e987, _e1000, _e1013));
                                                                        }
                                                                        let _e1924 = phi_2004_;
                                                                        phi_2005_ = _e1924;
                                                                    }
                                                                    let _e1926 = phi_2005_;
                                                                    let _e1930 = (_e1926.x - (_e1278 * _e1926.z));
                                                                    let _e1934 = (_e1926.y - (_e1281 * _e1926.z));
                                                                    let _e1936 = triangles.member[(0u + _e1877)].v2_;
                                                                    let _e1938 = (_e1936.x - _e987);
                                                                    let _e1940 = (_e1936.y - _e1000);
                                                                    let _e1942 = (_e1936.z - _e1013);
                                                                    if (_e1267 == 0u) {
                                                                        phi_2035_ = vec3<f32>(_e1940, _e1942, _e1938);
                                                                    } else {
                                                                        if (_e1267 == 1u) {
                                                                            phi_2034_ = vec3<f32>(_e1942, _e1938, _e1940);
                                                                        } else {
                                                                            phi_2034_ = (_e1936 - vec3<f32>(_e987, _e1000, _e1013));
                                                                        }
                                                                        let _e1950 = phi_2034_;
                                                                        phi_2035_ = _e1950;
                                                                    }
                                                                    let _e1952 = phi_2035_;
                                                                    let _e1956 = (_e1952.x - (_e1278 * _e1952.z));
                                                                    let _e1960 = (_e1952.y - (_e1281 * _e1952.z));
                                                                    if (_e1930 < _e1956) {
                                                                        phi_2054_ = true;
                                                                    } else {
                                                                        if (_e1930 == _e1956) {
                                                                            phi_2053_ = (_e1934 < _e1960);
                                                                        } else {
                                                                            phi_2053_ = false;
                                                                        }
                                                                        let _e1965 = phi_2053_;
                                                                        phi_2054_ = _e1965;
                                                                    }
                                                                    let _e1967 = phi_2054_;
                                                                    if _e1967 {
                                                                        phi_2058_ = _e1960;
                                                                        phi_2059_ = _e1956;
                                                                        phi_2060_ = _e1934;
                                                                        phi_2061_ = _e1930;
                                                                    } else {
                                                                        phi_2058_ = _e1934;
                                                                        phi_2059_ = _e1930;
                                                                        phi_2060_ = _e1960;
                                                                        phi_2061_ = _e1956;
                                                                    }
                                                                    let _e1969 = phi_2058_;
                                                                    let _e1971 = phi_2059_;
                                                                    let _e1973 = phi_2060_;
                                                                    let _e1975 = phi_2061_;
                                                                    let _e1978 = ((_e1975 * _e1969) - (_e1973 * _e1971));
                                                                    if _e1967 {
                                                                        phi_2069_ = -(_e1978);
                                                                    } else {
                                                                        phi_2069_ = _e1978;
                                                                    }
                                                                    let _e1981 = phi_2069_;
                                                                    if (_e1956 < _e1904) {
                                                                        phi_2080_ = true;
                                                                    } else {
                                                                        if (_e1956 == _e1904) {
                                                                            phi_2079_ = (_e1960 < _e1908);
                                                                        } else {
                                                                            phi_2079_ = false;
                                                                        }
                                                                        let _e1986 = phi_2079_;
                                                                        phi_2080_ = _e1986;
                                                                    }
                                                                    let _e1988 = phi_2080_;
                                                                    if _e1988 {
                                                                        phi_2084_ = _e1908;
                                                                        phi_2085_ = _e1904;
                                                                        phi_2086_ = _e1960;
                                                                        phi_2087_ = _e1956;
                                                                    } else {
                                                                        phi_2084_ = _e1960;
                                                                        phi_2085_ = _e1956;
                                                                        phi_2086_ = _e1908;
                                                                        phi_2087_ = _e1904;
                                                                    }
                                                                    let _e1990 = phi_2084_;
                                                                    let _e1992 = phi_2085_;
                                                                    let _e1994 = phi_2086_;
                                                                    let _e1996 = phi_2087_;
                                                                    let _e1999 = ((_e1996 * _e1990) - (_e1994 * _e1992));
                                                                    if _e1988 {
                                                                        phi_2095_ = -(_e1999);
                                                                    } else {
                                                                        phi_2095_ = _e1999;
                                                                    }
                                                                    let _e2002 = phi_2095_;
                                                                    if (_e1904 < _e1930) {
                                                                        phi_2106_ = true;
                                                                    } else {
                                                                        if (_e1904 == _e1930) {
                                                                            phi_2105_ = (_e1908 < _e1934);
                                                                        } else {
                                                                            phi_2105_ = false;
                                                                        }
                                                                        let _e2007 = phi_2105_;
                                                                        phi_2106_ = _e2007;
                                                                    }
                                                                    let _e2009 = phi_2106_;
                                                                    if _e2009 {
                                                                        phi_2110_ = _e1934;
                                                                        phi_2111_ = _e1930;
                                                                        phi_2112_ = _e1908;
                                                                        phi_2113_ = _e1904;
                                                                    } else {
                                                                        phi_2110_ = _e1908;
                                                                        phi_2111_ = _e1904;
                                                                        phi_2112_ = _e1934;
                                                                        phi_2113_ = _e1930;
                                                                    }
                                                                    let _e2011 = phi_2110_;
                                                                    let _e2013 = phi_2111_;
                                                                    let _e2015 = phi_2112_;
                                                                    let _e2017 = phi_2113_;
                                                                    let _e2020 = ((_e2017 * _e2011) - (_e2015 * _e2013));
                                                                    if _e2009 {
                                                                        phi_2121_ = -(_e2020);
                                                                    } else {
                                                                        phi_2121_ = _e2020;
                                                                    }
                                                                    let _e2023 = phi_2121_;
                                                                    if (_e1981 >= 0f) {
                                                                        if (_e2002 >= 0f) {
                                                                            if (_e2023 >= 0f) {
                                                                                phi_2136_ = ((_e1981 + _e2002) + _e2023);
                                                                                phi_2137_ = false;
                                                                            } else {
                                                                                phi_2136_ = f32();
                                                                                phi_2137_ = true;
                                                                            }
                                                                            let _e2030 = phi_2136_;
                                                                            let _e2032 = phi_2137_;
                                                                            phi_2138_ = _e2030;
                                                                            phi_2139_ = _e2032;
                                                                        } else {
                                                                            phi_2138_ = f32();
                                                                            phi_2139_ = true;
                                                                        }
                                                                        let _e2034 = phi_2138_;
                                                                        let _e2036 = phi_2139_;
                                                                        phi_2140_ = _e2034;
                                                                        phi_2141_ = _e2036;
                                                                    } else {
                                                                        phi_2140_ = f32();
                                                                        phi_2141_ = true;
                                                                    }
                                                                    let _e2038 = phi_2140_;
                                                                    let _e2040 = phi_2141_;
                                                                    if _e2040 {
                                                                        if (_e1981 <= 0f) {
                                                                            if (_e2002 <= 0f) {
                                                                                let _e2043 = (_e2023 <= 0f);
                                                                                if _e2043 {
                                                                                }
                                                                                phi_2159_ = ((_e1981 + _e2002) + _e2023);
                                                                                phi_2160_ = false;
                                                                                phi_2161_ = _e2043;
                                                                            } else {
                                                                                phi_2159_ = f32();
                                                                                phi_2160_ = true;
                                                                                phi_2161_ = false;
                                                                            }
                                                                            let _e2047 = phi_2159_;
                                                                            let _e2049 = phi_2160_;
                                                                            let _e2051 = phi_2161_;
                                                                            phi_2162_ = _e2047;
                                                                            phi_2163_ = _e2049;
                                                                            phi_2164_ = _e2051;
                                                                        } else {
                                                                            phi_2162_ = f32();
                                                                            phi_2163_ = true;
                                                                            phi_2164_ = false;
                                                                        }
                                                                        let _e2053 = phi_2162_;
                                                                        let _e2055 = phi_2163_;
                                                                        let _e2057 = phi_2164_;
                                                                        if _e2055 {
                                                                            phi_2168_ = false;
                                                                        } else {
                                                                            phi_2168_ = _e2057;
                                                                        }
                                                                        let _e2059 = phi_2168_;
                                                                        phi_2169_ = _e2053;
                                                                        phi_2170_ = _e2059;
                                                                    } else {
                                                                        phi_2169_ = _e2038;
                                                                        phi_2170_ = true;
                                                                    }
                                                                    let _e2061 = phi_2169_;
                                                                    let _e2063 = phi_2170_;
                                                                    if _e2063 {
                                                                        let _e2064 = (_e2061 == 0f);
                                                                        if _e2064 {
                                                                            phi_2486_ = lt_bvh_triangle_Intersection();
                                                                            phi_2487_ = false;
                                                                        } else {
                                                                            let _e2066 = triangles.member[(0u + _e1877)].v0_;
                                                                            let _e2068 = (_e2066.x - _e987);
                                                                            let _e2070 = (_e2066.y - _e1000);
                                                                            let _e2072 = (_e2066.z - _e1013);
                                                                            if (_e1267 == 0u) {
                                                                                phi_2199_ = vec3<f32>(_e2070, _e2072, _e2068);
                                                                            } else {
                                                                                if (_e1267 == 1u) {
                                                                                    phi_2198_ = vec3<f32>(_e2072, _e2068, _e2070);
                                                                                } else {
                                                                                    phi_2198_ = (_e2066 - vec3<f32>(_e987, _e1000, _e1013));
                                                                                }
                                                                                let _e2080 = phi_2198_;
                                                                                phi_2199_ = _e2080;
                                                                            }
                                                                            let _e2082 = phi_2199_;
                                                                            let _e2084 = triangles.member[(0u + _e1877)].v1_;
                                                                            let _e2086 = triangles.member[(0u + _e1877)].v0_;
                                                                            let _e2089 = (_e2084.x - _e2086.x);
                                                                            let _e2092 = (_e2084.y - _e2086.y);
                                                                            let _e2095 = (_e2084.z - _e2086.z);
                                                                            if (_e1267 == 0u) {
                                                                                phi_2225_ = vec3<f32>(_e2092, _e2095, _e2089);
                                                                            } else {
                                                                                if (_e1267 == 1u) {
                                                                                    phi_2224_ = vec3<f32>(_e2095, _e2089, _e2092);
                                                                                } else {
                                                                                    phi_2224_ = (_e2084 - _e2086);
                                                                                }
                                                                                let _e2102 = phi_2224_;
                                                                                phi_2225_ = _e2102;
                                                                            }
                                                                            let _e2104 = phi_2225_;
                                                                            let _e2106 = triangles.member[(0u + _e1877)].v2_;
                                                                            let _e2108 = triangles.member[(0u + _e1877)].v0_;
                                                                            let _e2111 = (_e2106.x - _e2108.x);
                                                                            let _e2114 = (_e2106.y - _e2108.y);
                                                                            let _e2117 = (_e2106.z - _e2108.z);
                                                                            if (_e1267 == 0u) {
                                                                                phi_2251_ = vec3<f32>(_e2114, _e2117, _e2111);
                                                                            } else {
                                                                                if (_e1267 == 1u) {
                                                                                    phi_2250_ = vec3<f32>(_e2117, _e2111, _e2114);
                                                                                } else {
                                                                                    phi_2250_ = (_e2106 - _e2108);
                                                                                }
                                                                                let _e2124 = phi_2250_;
                                                                                phi_2251_ = _e2124;
                                                                            }
                                                                            let _e2126 = phi_2251_;
                                                                            let _e2133 = ((_e2104.y * _e2126.z) - (_e2104.z * _e2126.y));
                                                                            let _e2140 = ((_e2104.z * _e2126.x) - (_e2104.x * _e2126.z));
                                                                            let _e2147 = ((_e2104.x * _e2126.y) - (_e2104.y * _e2126.x));
                                                                            let _e2161 = (((1f / _e1275.z) * (((_e2133 * _e2082.x) + (_e2140 * _e2082.y)) + (_e2147 * _e2082.z))) / (((_e2133 * _e1278) + (_e2140 * _e1281)) + _e2147));
                                                                            if (_e2161 > 0f) {
                                                                                if (_e2161 < _e117) {
                                                                                    let _e2165 = triangles.member[(0u + _e1877)].v0_;
                                                                                    let _e2167 = triangles.member[(0u + _e1877)].v1_;
                                                                                    if (_e2165.x < _e2167.x) {
                                                                                        phi_2307_ = _e2165.x;
                                                                                    } else {
                                                                                        phi_2307_ = _e2167.x;
                                                                                    }
                                                                                    let _e2174 = phi_2307_;
                                                                                    if (_e2165.y < _e2167.y) {
                                                                                        phi_2316_ = _e2165.y;
                                                                                    } else {
                                                                                        phi_2316_ = _e2167.y;
                                                                                    }
                                                                                    let _e2181 = phi_2316_;
                                                                                    if (_e2165.z < _e2167.z) {
                                                                                        phi_2325_ = _e2165.z;
                                                                                    } else {
                                                                                        phi_2325_ = _e2167.z;
                                                                                    }
                                                                                    let _e2188 = phi_2325_;
                                                                                    let _e2190 = triangles.member[(0u + _e1877)].v2_;
                                                                                    if (_e2174 < _e2190.x) {
                                                                                        phi_2334_ = _e2174;
                                                                                    } else {
                                                                                        phi_2334_ = _e2190.x;
                                                                                    }
                                                                                    let _e2195 = phi_2334_;
                                                                                    if (_e2181 < _e2190.y) {
                                                                                        phi_2341_ = _e2181;
                                                                                    } else {
                                                                                        phi_2341_ = _e2190.y;
                                                                                    }
                                                                                    let _e2200 = phi_2341_;
                                                                                    if (_e2188 < _e2190.z) {
                                                                                        phi_2348_ = _e2188;
                                                                                    } else {
                                                                                        phi_2348_ = _e2190.z;
                                                                                    }
                                                                                    let _e2205 = phi_2348_;
                                                                                    let _e2207 = triangles.member[(0u + _e1877)].v0_;
                                                                                    let _e2209 = triangles.member[(0u + _e1877)].v1_;
                                                                                    if (_e2207.x > _e2209.x) {
                                                                                        phi_2361_ = _e2207.x;
                                                                                    } else {
                                                                                        phi_2361_ = _e2209.x;
                                                                                    }
                                                                                    let _e2216 = phi_2361_;
                                                                                    if (_e2207.y > _e2209.y) {
                                                                                        phi_2370_ = _e2207.y;
                                                                                    } else {
                                                                                        phi_2370_ = _e2209.y;
                                                                                    }
                                                                                    let _e2223 = phi_2370_;
                                                                                    if (_e2207.z > _e2209.z) {
                                                                                        phi_2379_ = _e2207.z;
                                                                                    } else {
                                                                                        phi_2379_ = _e2209.z;
                                                                                    }
                                                                                    let _e2230 = phi_2379_;
                                                                                    let _e2232 = triangles.member[(0u + _e1877)].v2_;
                                                                                    if (_e2216 > _e2232.x) {
                                                                                        phi_2388_ = _e2216;
                                                                                    } else {
                                                                                        phi_2388_ = _e2232.x;
                                                                                    }
                                                                                    let _e2237 = phi_2388_;
                                                                                    if (_e2223 > _e2232.y) {
                                                                                        phi_2395_ = _e2223;
                                                                                    } else {
                                                                                        phi_2395_ = _e2232.y;
                                                                                    }
                                                                                    let _e2242 = phi_2395_;
                                                                                    if (_e2230 > _e2232.z) {
                                                                                        phi_2402_ = _e2230;
                                                                                    } else {
                                                                                        phi_2402_ = _e2232.z;
                                                                                    }
                                                                                    let _e2247 = phi_2402_;
                                                                                    let _e2251 = ((_e2195 - _e987) * _e1196);
                                                                                    let _e2252 = ((_e2200 - _e1000) * _e1206);
                                                                                    let _e2253 = ((_e2205 - _e1013) * _e1216);
                                                                                    let _e2257 = ((_e2237 - _e987) * _e1196);
                                                                                    let _e2258 = ((_e2242 - _e1000) * _e1206);
                                                                                    let _e2259 = ((_e2247 - _e1013) * _e1216);
                                                                                    if (_e2251 < _e2257) {
                                                                                        phi_2419_ = _e2251;
                                                                                    } else {
                                                                                        phi_2419_ = _e2257;
                                                                                    }
                                                                                    let _e2262 = phi_2419_;
                                                                                    if (_e2252 < _e2258) {
                                                                                        phi_2424_ = _e2252;
                                                                                    } else {
                                                                                        phi_2424_ = _e2258;
                                                                                    }
                                                                                    let _e2265 = phi_2424_;
                                                                                    if (_e2253 < _e2259) {
                                                                                        phi_2429_ = _e2253;
                                                                                    } else {
                                                                                        phi_2429_ = _e2259;
                                                                                    }
                                                                                    let _e2268 = phi_2429_;
                                                                                    if (_e2251 > _e2257) {
                                                                                        phi_2437_ = _e2251;
                                                                                    } else {
                                                                                        phi_2437_ = _e2257;
                                                                                    }
                                                                                    let _e2274 = phi_2437_;
                                                                                    if (_e2252 > _e2258) {
                                                                                        phi_2442_ = _e2252;
                                                                                    } else {
                                                                                        phi_2442_ = _e2258;
                                                                                    }
                                                                                    let _e2277 = phi_2442_;
                                                                                    if (_e2253 > _e2259) {
                                                                                        phi_2447_ = _e2253;
                                                                                    } else {
                                                                                        phi_2447_ = _e2259;
                                                                                    }
                                                                                    let _e2280 = phi_2447_;
                                                                                    let _e2284 = core_intrinsics_maximum_number_nsz_f32_((_e2262 - _e1251), (_e2265 - _e1252));
                                                                                    let _e2285 = core_intrinsics_maximum_number_nsz_f32_(_e2284, (_e2268 - _e1253));
                                                                                    let _e2286 = core_intrinsics_minimum_number_nsz_f32_((_e2274 + _e1251), (_e2277 + _e1252));
                                                                                    let _e2287 = core_intrinsics_minimum_number_nsz_f32_(_e2286, (_e2280 + _e1253));
                                                                                    if (_e2285 > _e968) {
                                                                                        phi_2459_ = _e2285;
                                                                                    } else {
                                                                                        phi_2459_ = _e968;
                                                                                    }
                                                                                    let _e2290 = phi_2459_;
                                                                                    if (_e2287 < _e970) {
                                                                                        phi_2464_ = _e2287;
                                                                                    } else {
                                                                                        phi_2464_ = _e970;
                                                                                    }
                                                                                    let _e2293 = phi_2464_;
                                                                                    if (_e2161 < _e2290) {
                                                                                        phi_2469_ = _e2290;
                                                                                    } else {
                                                                                        phi_2469_ = _e2161;
                                                                                    }
                                                                                    let _e2296 = phi_2469_;
                                                                                    if (_e2296 > _e2293) {
                                                                                        phi_2474_ = _e2293;
                                                                                    } else {
                                                                                        phi_2474_ = _e2296;
                                                                                    }
                                                                                    let _e2299 = phi_2474_;
                                                                                    phi_2479_ = lt_bvh_triangle_Intersection(_e2299, (_e2002 / _e2061), (_e2023 / _e2061), (_e2290 <= _e2293));
                                                                                    phi_2480_ = false;
                                                                                } else {
                                                                                    phi_2479_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2480_ = true;
                                                                                }
                                                                                let _e2305 = phi_2479_;
                                                                                let _e2307 = phi_2480_;
                                                                                phi_2481_ = _e2305;
                                                                                phi_2482_ = _e2307;
                                                                            } else {
                                                                                phi_2481_ = lt_bvh_triangle_Intersection();
                                                                                phi_2482_ = true;
                                                                            }
                                                                            let _e2309 = phi_2481_;
                                                                            let _e2311 = phi_2482_;
                                                                            if _e2311 {
                                                                            }
                                                                            phi_2486_ = _e2309;
                                                                            phi_2487_ = _e2311;
                                                                        }
                                                                        let _e2313 = phi_2486_;
                                                                        let _e2315 = phi_2487_;
                                                                        phi_2488_ = _e2313;
                                                                        phi_2489_ = _e2064;
                                                                        phi_2490_ = _e2315;
                                                                    } else {
                                                                        phi_2488_ = lt_bvh_triangle_Intersection();
                                                                        phi_2489_ = true;
                                                                        phi_2490_ = false;
                                                                    }
                                                                    let _e2317 = phi_2488_;
                                                                    let _e2319 = phi_2489_;
                                                                    let _e2321 = phi_2490_;
                                                                    if _e2319 {
                                                                        phi_2494_ = true;
                                                                    } else {
                                                                        phi_2494_ = _e2321;
                                                                    }
                                                                    let _e2323 = phi_2494_;
                                                                    if _e2323 {
                                                                        phi_2498_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2498_ = _e2317;
                                                                    }
                                                                    let _e2325 = phi_2498_;
                                                                    if _e2325.is_hit {
                                                                        if (_e2325.t > 0f) {
                                                                            if (_e2325.t < _e117) {
                                                                                let _e2332 = triangles.member[(0u + _e1877)].i0_;
                                                                                let _e2334 = ((_e2332 & 2147483648u) == 0u);
                                                                                if _e2334 {
                                                                                    phi_2524_ = false;
                                                                                    phi_2525_ = false;
                                                                                } else {
                                                                                    if true {
                                                                                        phi_2523_ = false;
                                                                                    } else {
                                                                                        phi_2523_ = true;
                                                                                    }
                                                                                    let _e2336 = phi_2523_;
                                                                                    phi_2524_ = _e2336;
                                                                                    phi_2525_ = true;
                                                                                }
                                                                                let _e2338 = phi_2524_;
                                                                                let _e2340 = phi_2525_;
                                                                                phi_2526_ = _e2338;
                                                                                phi_2527_ = _e2334;
                                                                                phi_2528_ = _e2340;
                                                                            } else {
                                                                                phi_2526_ = true;
                                                                                phi_2527_ = false;
                                                                                phi_2528_ = false;
                                                                            }
                                                                            let _e2342 = phi_2526_;
                                                                            let _e2344 = phi_2527_;
                                                                            let _e2346 = phi_2528_;
                                                                            phi_2529_ = _e2342;
                                                                            phi_2530_ = _e2344;
                                                                            phi_2531_ = _e2346;
                                                                        } else {
                                                                            phi_2529_ = true;
                                                                            phi_2530_ = false;
                                                                            phi_2531_ = false;
                                                                        }
                                                                        let _e2348 = phi_2529_;
                                                                        let _e2350 = phi_2530_;
                                                                        let _e2352 = phi_2531_;
                                                                        phi_2532_ = _e2348;
                                                                        phi_2533_ = _e2350;
                                                                        phi_2534_ = _e2352;
                                                                    } else {
                                                                        phi_2532_ = true;
                                                                        phi_2533_ = false;
                                                                        phi_2534_ = false;
                                                                    }
                                                                    let _e2354 = phi_2532_;
                                                                    let _e2356 = phi_2533_;
                                                                    let _e2358 = phi_2534_;
                                                                    if _e2354 {
                                                                        phi_2538_ = false;
                                                                        phi_2539_ = false;
                                                                    } else {
                                                                        phi_2538_ = _e2356;
                                                                        phi_2539_ = _e2358;
                                                                    }
                                                                    let _e2360 = phi_2538_;
                                                                    let _e2362 = phi_2539_;
                                                                    phi_1930_ = (_e1868 & (_e1868 - 1u));
                                                                    phi_2540_ = _e2354;
                                                                    phi_2541_ = _e2360;
                                                                    phi_2542_ = _e2362;
                                                                }
                                                                let _e2364 = phi_1930_;
                                                                let _e2366 = phi_2540_;
                                                                let _e2368 = phi_2541_;
                                                                let _e2370 = phi_2542_;
                                                                local_12 = _e2368;
                                                                local_13 = _e2370;
                                                                continue;
                                                                continuing {
                                                                    phi_1929_ = _e2364;
                                                                    break if !(_e2366);
                                                                }
                                                            }
                                                            let _e2373 = local_8;
                                                            if _e2373 {
                                                                let _e2375 = local.group_mask;
                                                                if ((_e2375 & 4278190080u) == 0u) {
                                                                    let _e2379 = local.len;
                                                                    if (_e2379 == 0u) {
                                                                        phi_2584_ = false;
                                                                    } else {
                                                                        let _e2383 = local.len;
                                                                        local.len = (_e2383 - 1u);
                                                                        let _e2386 = local.len;
                                                                        if (_e2386 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2391 = local.first[(0u + _e2386)];
                                                                        local.group = _e2391;
                                                                        let _e2394 = local.len;
                                                                        if (_e2394 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2399 = local.mask[(0u + _e2394)];
                                                                        local.group_mask = _e2399;
                                                                        phi_2584_ = true;
                                                                    }
                                                                    let _e2402 = phi_2584_;
                                                                    phi_2585_ = _e2402;
                                                                } else {
                                                                    phi_2585_ = true;
                                                                }
                                                                let _e2404 = phi_2585_;
                                                                if _e2404 {
                                                                    let _e2406 = local.group_mask;
                                                                    let _e2412 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2406)), 32u, (_e2406 == 0u)));
                                                                    let _e2416 = local.group_mask;
                                                                    let _e2430 = local.group_mask;
                                                                    local.group_mask = (_e2430 & ~((1u << bitcast<u32>((_e2412 & 31u)))));
                                                                    let _e2433 = local.group;
                                                                    phi_2616_ = (_e2433 + countOneBits(((_e2416 & ~((4294967295u << bitcast<u32>((((_e2412 - 24u) ^ _e1294) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2616_ = 4294967295u;
                                                                }
                                                                let _e2436 = phi_2616_;
                                                                phi_2617_ = _e2436;
                                                                phi_2618_ = false;
                                                                phi_2619_ = false;
                                                            } else {
                                                                phi_2617_ = u32();
                                                                let _e2819 = local_12;
                                                                phi_2618_ = _e2819;
                                                                let _e2822 = local_13;
                                                                phi_2619_ = _e2822;
                                                            }
                                                            let _e2438 = phi_2617_;
                                                            let _e2440 = phi_2618_;
                                                            let _e2442 = phi_2619_;
                                                            phi_1600_ = _e2438;
                                                            let _e2826 = local_14;
                                                            phi_2620_ = _e2826;
                                                            phi_2621_ = false;
                                                            phi_2622_ = _e2440;
                                                            phi_2623_ = _e2442;
                                                        } else {
                                                            phi_1600_ = u32();
                                                            phi_2620_ = false;
                                                            phi_2621_ = true;
                                                            phi_2622_ = false;
                                                            phi_2623_ = false;
                                                        }
                                                        let _e2444 = phi_1600_;
                                                        let _e2446 = phi_2620_;
                                                        let _e2448 = phi_2621_;
                                                        let _e2450 = phi_2622_;
                                                        let _e2452 = phi_2623_;
                                                        local_9 = _e2448;
                                                        local_15 = _e2450;
                                                        local_16 = _e2452;
                                                        continue;
                                                        continuing {
                                                            phi_1599_ = _e2444;
                                                            break if !(_e2446);
                                                        }
                                                    }
                                                    let _e2455 = local_9;
                                                    if _e2455 {
                                                        phi_2627_ = false;
                                                        phi_2628_ = false;
                                                    } else {
                                                        let _e2833 = local_15;
                                                        phi_2627_ = _e2833;
                                                        let _e2836 = local_16;
                                                        phi_2628_ = _e2836;
                                                    }
                                                    let _e2457 = phi_2627_;
                                                    let _e2459 = phi_2628_;
                                                    if _e2457 {
                                                        phi_2632_ = true;
                                                    } else {
                                                        phi_2632_ = _e2459;
                                                    }
                                                    let _e2461 = phi_2632_;
                                                    if _e2461 {
                                                        phi_2636_ = true;
                                                    } else {
                                                        phi_2636_ = false;
                                                    }
                                                    let _e2463 = phi_2636_;
                                                    phi_2637_ = _e2463;
                                                }
                                                let _e2465 = phi_2637_;
                                                phi_2638_ = _e2465;
                                                phi_2639_ = _e1120;
                                            } else {
                                                phi_2638_ = bool();
                                                phi_2639_ = true;
                                            }
                                            let _e2467 = phi_2638_;
                                            let _e2469 = phi_2639_;
                                            if _e2469 {
                                                phi_2643_ = false;
                                            } else {
                                                phi_2643_ = _e2467;
                                            }
                                            let _e2471 = phi_2643_;
                                            if _e2471 {
                                                phi_2647_ = false;
                                            } else {
                                                phi_2647_ = true;
                                            }
                                            let _e2473 = phi_2647_;
                                            phi_2648_ = _e2473;
                                        } else {
                                            phi_2648_ = true;
                                        }
                                        let _e2475 = phi_2648_;
                                        phi_2649_ = _e2475;
                                    } else {
                                        phi_2649_ = true;
                                    }
                                    let _e2477 = phi_2649_;
                                    phi_2650_ = _e2477;
                                } else {
                                    phi_2650_ = true;
                                }
                                let _e2479 = phi_2650_;
                                if _e2479 {
                                }
                                phi_994_ = (_e907 & (_e907 - 1u));
                                phi_2654_ = _e2479;
                            }
                            let _e2481 = phi_994_;
                            let _e2483 = phi_2654_;
                            continue;
                            continuing {
                                phi_993_ = _e2481;
                                break if !(_e2483);
                            }
                        }
                        let _e2486 = local_10;
                        if _e2486 {
                            let _e2488 = local_1.group_mask;
                            if ((_e2488 & 4278190080u) == 0u) {
                                let _e2492 = local_1.len;
                                if (_e2492 == 0u) {
                                    phi_2696_ = false;
                                } else {
                                    let _e2496 = local_1.len;
                                    local_1.len = (_e2496 - 1u);
                                    let _e2499 = local_1.len;
                                    if (_e2499 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2504 = local_1.first[(0u + _e2499)];
                                    local_1.group = _e2504;
                                    let _e2507 = local_1.len;
                                    if (_e2507 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2512 = local_1.mask[(0u + _e2507)];
                                    local_1.group_mask = _e2512;
                                    phi_2696_ = true;
                                }
                                let _e2515 = phi_2696_;
                                phi_2697_ = _e2515;
                            } else {
                                phi_2697_ = true;
                            }
                            let _e2517 = phi_2697_;
                            if _e2517 {
                                let _e2519 = local_1.group_mask;
                                let _e2525 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2519)), 32u, (_e2519 == 0u)));
                                let _e2529 = local_1.group_mask;
                                let _e2543 = local_1.group_mask;
                                local_1.group_mask = (_e2543 & ~((1u << bitcast<u32>((_e2525 & 31u)))));
                                let _e2546 = local_1.group;
                                phi_2728_ = (_e2546 + countOneBits(((_e2529 & ~((4294967295u << bitcast<u32>((((_e2525 - 24u) ^ _e333) & 31u))))) & 255u)));
                            } else {
                                phi_2728_ = 4294967295u;
                            }
                            let _e2549 = phi_2728_;
                            phi_2729_ = _e2549;
                        } else {
                            phi_2729_ = u32();
                        }
                        let _e2551 = phi_2729_;
                        phi_664_ = _e2551;
                        let _e2857 = local_17;
                        phi_2730_ = _e2857;
                        phi_2731_ = false;
                    } else {
                        phi_664_ = u32();
                        phi_2730_ = false;
                        phi_2731_ = true;
                    }
                    let _e2553 = phi_664_;
                    let _e2555 = phi_2730_;
                    let _e2557 = phi_2731_;
                    local_11 = _e2557;
                    continue;
                    continuing {
                        phi_663_ = _e2553;
                        break if !(_e2555);
                    }
                }
                let _e2560 = local_11;
                if _e2560 {
                    phi_2735_ = false;
                } else {
                    phi_2735_ = true;
                }
                let _e2562 = phi_2735_;
                if _e2562 {
                    phi_2739_ = true;
                } else {
                    phi_2739_ = false;
                }
                let _e2564 = phi_2739_;
                phi_2740_ = _e2564;
            }
            let _e2566 = phi_2740_;
            phi_2741_ = _e2566;
            phi_2742_ = _e189;
        } else {
            phi_2741_ = bool();
            phi_2742_ = true;
        }
        let _e2568 = phi_2741_;
        let _e2570 = phi_2742_;
        if _e2570 {
            phi_2746_ = false;
        } else {
            phi_2746_ = _e2568;
        }
        let _e2572 = phi_2746_;
        if _e2572 {
            phi_2750_ = 0f;
        } else {
            phi_2750_ = 1f;
        }
        let _e2574 = phi_2750_;
        if (_e85 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e85)] = _e2574;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
