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
    member: array<u32>,
}

struct type_17 {
    member: array<f32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

struct type_51 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_32;
@group(0) @binding(2) 
var<storage> nodes: type_37;
@group(0) @binding(3) 
var<storage> triangles: type_41;
@group(0) @binding(6) 
var<storage> instances: type_51;
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
    var phi_666_: bool;
    var phi_746_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_773_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_800_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_806_: u32;
    var phi_809_: u32;
    var phi_823_: u32;
    var phi_833_: u32;
    var phi_843_: u32;
    var phi_861_: u32;
    var phi_871_: u32;
    var phi_881_: u32;
    var phi_917_: u32;
    var phi_930_: u32;
    var phi_935_: u32;
    var phi_936_: u32;
    var phi_937_: u32;
    var phi_807_: u32;
    var phi_810_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_995_: u32;
    var phi_998_: bool;
    var phi_1047_: f32;
    var phi_1052_: f32;
    var phi_1057_: f32;
    var phi_1065_: f32;
    var phi_1070_: f32;
    var phi_1075_: f32;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
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
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1242_: bool;
    var phi_1246_: bool;
    var phi_1250_: bool;
    var phi_1320_: f32;
    var phi_1327_: f32;
    var phi_1334_: f32;
    var phi_1341_: f32;
    var phi_1348_: f32;
    var phi_1355_: f32;
    var phi_1372_: f32;
    var phi_1377_: f32;
    var phi_1382_: f32;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1419_: u32;
    var phi_1420_: u32;
    var phi_1431_: vec3<f32>;
    var phi_1432_: vec3<f32>;
    var phi_1445_: u32;
    var phi_1450_: u32;
    var phi_1455_: u32;
    var phi_1569_: bool;
    var phi_1570_: bool;
    var phi_1601_: u32;
    var phi_1603_: u32;
    var phi_1606_: bool;
    var phi_1686_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1713_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1740_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1746_: u32;
    var phi_1749_: u32;
    var phi_1763_: u32;
    var phi_1773_: u32;
    var phi_1783_: u32;
    var phi_1801_: u32;
    var phi_1811_: u32;
    var phi_1821_: u32;
    var phi_1857_: u32;
    var phi_1870_: u32;
    var phi_1875_: u32;
    var phi_1876_: u32;
    var phi_1877_: u32;
    var phi_1747_: u32;
    var phi_1750_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1935_: u32;
    var phi_1938_: bool;
    var phi_1982_: vec3<f32>;
    var phi_1983_: vec3<f32>;
    var phi_2012_: vec3<f32>;
    var phi_2013_: vec3<f32>;
    var phi_2042_: vec3<f32>;
    var phi_2043_: vec3<f32>;
    var phi_2061_: bool;
    var phi_2062_: bool;
    var phi_2066_: f32;
    var phi_2067_: f32;
    var phi_2068_: f32;
    var phi_2069_: f32;
    var phi_2077_: f32;
    var phi_2087_: bool;
    var phi_2088_: bool;
    var phi_2092_: f32;
    var phi_2093_: f32;
    var phi_2094_: f32;
    var phi_2095_: f32;
    var phi_2103_: f32;
    var phi_2113_: bool;
    var phi_2114_: bool;
    var phi_2118_: f32;
    var phi_2119_: f32;
    var phi_2120_: f32;
    var phi_2121_: f32;
    var phi_2129_: f32;
    var phi_2144_: f32;
    var phi_2145_: bool;
    var phi_2146_: f32;
    var phi_2147_: bool;
    var phi_2148_: f32;
    var phi_2149_: bool;
    var phi_2167_: f32;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2170_: f32;
    var phi_2171_: bool;
    var phi_2172_: bool;
    var phi_2176_: bool;
    var phi_2177_: f32;
    var phi_2178_: bool;
    var phi_2206_: vec3<f32>;
    var phi_2207_: vec3<f32>;
    var phi_2232_: vec3<f32>;
    var phi_2233_: vec3<f32>;
    var phi_2258_: vec3<f32>;
    var phi_2259_: vec3<f32>;
    var phi_2315_: f32;
    var phi_2324_: f32;
    var phi_2333_: f32;
    var phi_2342_: f32;
    var phi_2349_: f32;
    var phi_2356_: f32;
    var phi_2369_: f32;
    var phi_2378_: f32;
    var phi_2387_: f32;
    var phi_2396_: f32;
    var phi_2403_: f32;
    var phi_2410_: f32;
    var phi_2427_: f32;
    var phi_2432_: f32;
    var phi_2437_: f32;
    var phi_2445_: f32;
    var phi_2450_: f32;
    var phi_2455_: f32;
    var phi_2467_: f32;
    var phi_2472_: f32;
    var phi_2477_: f32;
    var phi_2482_: f32;
    var phi_2487_: lt_bvh_triangle_Intersection;
    var phi_2488_: bool;
    var phi_2489_: lt_bvh_triangle_Intersection;
    var phi_2490_: bool;
    var phi_2494_: lt_bvh_triangle_Intersection;
    var phi_2495_: bool;
    var phi_2496_: lt_bvh_triangle_Intersection;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2502_: bool;
    var phi_2506_: lt_bvh_triangle_Intersection;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var phi_2531_: bool;
    var phi_2532_: bool;
    var phi_1936_: u32;
    var phi_1939_: bool;
    var phi_2536_: bool;
    var local_8: bool;
    var phi_2578_: bool;
    var phi_2579_: bool;
    var phi_2610_: u32;
    var phi_2611_: u32;
    var phi_1604_: u32;
    var phi_1607_: bool;
    var phi_2612_: bool;
    var phi_2613_: bool;
    var local_9: bool;
    var phi_2617_: bool;
    var phi_2621_: bool;
    var phi_2622_: bool;
    var phi_2623_: bool;
    var phi_2624_: bool;
    var phi_2628_: bool;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2635_: bool;
    var phi_2636_: bool;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_996_: u32;
    var phi_999_: bool;
    var phi_2642_: bool;
    var local_10: bool;
    var phi_2684_: bool;
    var phi_2685_: bool;
    var phi_2716_: u32;
    var phi_2717_: u32;
    var phi_664_: u32;
    var phi_667_: bool;
    var phi_2718_: bool;
    var phi_2719_: bool;
    var local_11: bool;
    var phi_2723_: bool;
    var phi_2727_: bool;
    var phi_2728_: bool;
    var phi_2729_: bool;
    var phi_2733_: bool;
    var phi_2734_: bool;
    var phi_2738_: bool;
    var phi_2742_: f32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

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
                phi_2727_ = false;
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
                phi_666_ = false;
                loop {
                    let _e471 = phi_663_;
                    let _e473 = phi_666_;
                    if (_e471 != 4294967295u) {
                        if (_e471 < _e60) {
                        } else {
                            return;
                        }
                        let _e480 = nodes.member[(0u + _e471)].frame[3u];
                        let _e505 = (bitcast<f32>((((_e480 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e265);
                        let _e506 = (bitcast<f32>((((_e480 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e275);
                        let _e507 = (bitcast<f32>((((_e480 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e285);
                        let _e510 = nodes.member[(0u + _e471)].frame[0u];
                        let _e514 = nodes.member[(0u + _e471)].frame[1u];
                        let _e518 = nodes.member[(0u + _e471)].frame[2u];
                        let _e523 = ((bitcast<f32>(_e510) - _e107) * _e265);
                        let _e524 = ((bitcast<f32>(_e514) - _e109) * _e275);
                        let _e525 = ((bitcast<f32>(_e518) - _e111) * _e285);
                        let _e533 = nodes.member[(0u + _e471)].x;
                        if (_e265 < 0f) {
                            let _e544 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e533.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e550 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e544.unnamed.word, _e533.w), _e544.unnamed_1);
                            let _e556 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e550.unnamed, lt_mask_LightPlace(_e533.x, _e550.unnamed_1.shift));
                            phi_746_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e556.unnamed, lt_mask_LightPlace(_e556.unnamed_1.word, _e533.y));
                        } else {
                            let _e572 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e533.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e572.unnamed.word, _e533.y), _e572.unnamed_1);
                            let _e584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e578.unnamed, lt_mask_LightPlace(_e533.z, _e578.unnamed_1.shift));
                            phi_746_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e584.unnamed, lt_mask_LightPlace(_e584.unnamed_1.word, _e533.w));
                        }
                        let _e592 = phi_746_;
                        let _e602 = nodes.member[(0u + _e471)].y;
                        if (_e275 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e613.unnamed.word, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_mask_LightPlace(_e602.x, _e619.unnamed_1.shift));
                            phi_773_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_mask_LightPlace(_e625.unnamed_1.word, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e641.unnamed.word, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e602.z, _e647.unnamed_1.shift));
                            phi_773_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_mask_LightPlace(_e653.unnamed_1.word, _e602.w));
                        }
                        let _e661 = phi_773_;
                        let _e671 = nodes.member[(0u + _e471)].z;
                        if (_e285 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e682.unnamed.word, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e671.x, _e688.unnamed_1.shift));
                            phi_800_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_mask_LightPlace(_e694.unnamed_1.word, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e710.unnamed.word, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e671.z, _e716.unnamed_1.shift));
                            phi_800_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_mask_LightPlace(_e722.unnamed_1.word, _e671.w));
                        }
                        let _e730 = phi_800_;
                        phi_806_ = 0u;
                        phi_809_ = 0u;
                        loop {
                            let _e740 = phi_806_;
                            let _e742 = phi_809_;
                            local_2 = _e742;
                            local_3 = _e742;
                            local_4 = _e742;
                            let _e743 = (_e740 < 8u);
                            if _e743 {
                                let _e745 = (_e740 >> bitcast<u32>(2i));
                                let _e746 = (_e740 & 3u);
                                if (_e745 == 0u) {
                                    phi_823_ = _e592.unnamed.word;
                                } else {
                                    phi_823_ = _e592.unnamed.shift;
                                }
                                let _e749 = phi_823_;
                                if (_e745 == 0u) {
                                    phi_833_ = _e661.unnamed.word;
                                } else {
                                    phi_833_ = _e661.unnamed.shift;
                                }
                                let _e758 = phi_833_;
                                if (_e745 == 0u) {
                                    phi_843_ = _e730.unnamed.word;
                                } else {
                                    phi_843_ = _e730.unnamed.shift;
                                }
                                let _e767 = phi_843_;
                                let _e780 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e749 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e505) + (_e523 - _e313)), ((f32(((_e758 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e506) + (_e524 - _e314)));
                                let _e781 = core_intrinsics_maximum_number_nsz_f32_(_e780, ((f32(((_e767 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e507) + (_e525 - _e315)));
                                if (_e745 == 0u) {
                                    phi_861_ = _e592.unnamed_1.word;
                                } else {
                                    phi_861_ = _e592.unnamed_1.shift;
                                }
                                let _e784 = phi_861_;
                                if (_e745 == 0u) {
                                    phi_871_ = _e661.unnamed_1.word;
                                } else {
                                    phi_871_ = _e661.unnamed_1.shift;
                                }
                                let _e793 = phi_871_;
                                if (_e745 == 0u) {
                                    phi_881_ = _e730.unnamed_1.word;
                                } else {
                                    phi_881_ = _e730.unnamed_1.shift;
                                }
                                let _e802 = phi_881_;
                                let _e815 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e784 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e505) + (_e523 + _e313)), ((f32(((_e793 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e506) + (_e524 + _e314)));
                                let _e816 = core_intrinsics_minimum_number_nsz_f32_(_e815, ((f32(((_e802 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u)) * _e507) + (_e525 + _e315)));
                                if (_e781 <= _e816) {
                                    if (_e781 <= _e117) {
                                        if (_e816 >= 0f) {
                                            if (_e745 == 0u) {
                                                let _e823 = nodes.member[(0u + _e471)].links[2u];
                                                phi_917_ = _e823;
                                            } else {
                                                let _e826 = nodes.member[(0u + _e471)].links[3u];
                                                phi_917_ = _e826;
                                            }
                                            let _e828 = phi_917_;
                                            let _e833 = ((_e828 >> bitcast<u32>(((_e746 * 8u) & 31u))) & 255u);
                                            let _e834 = (_e833 & 31u);
                                            if (_e834 >= 24u) {
                                                phi_930_ = (24u + ((_e834 - 24u) ^ _e333));
                                            } else {
                                                phi_930_ = _e834;
                                            }
                                            let _e840 = phi_930_;
                                            phi_935_ = (_e742 | ((_e833 >> bitcast<u32>(5i)) << bitcast<u32>((_e840 & 31u))));
                                        } else {
                                            phi_935_ = _e742;
                                        }
                                        let _e848 = phi_935_;
                                        phi_936_ = _e848;
                                    } else {
                                        phi_936_ = _e742;
                                    }
                                    let _e850 = phi_936_;
                                    phi_937_ = _e850;
                                } else {
                                    phi_937_ = _e742;
                                }
                                let _e852 = phi_937_;
                                phi_807_ = (_e740 + 1u);
                                phi_810_ = _e852;
                            } else {
                                phi_807_ = u32();
                                phi_810_ = u32();
                            }
                            let _e855 = phi_807_;
                            let _e857 = phi_810_;
                            continue;
                            continuing {
                                phi_806_ = _e855;
                                phi_809_ = _e857;
                                break if !(_e743);
                            }
                        }
                        let _e861 = nodes.member[(0u + _e471)].links[0u];
                        let _e865 = nodes.member[(0u + _e471)].frame[3u];
                        let _e869 = local_2;
                        if ((_e869 & 4278190080u) == 0u) {
                        } else {
                            let _e873 = local_1.group_mask;
                            if ((_e873 & 4278190080u) == 0u) {
                            } else {
                                let _e877 = local_1.len;
                                if (_e877 < 32u) {
                                    let _e880 = local_1.group;
                                    let _e882 = local_1.len;
                                    if (_e882 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e882)] = _e880;
                                    let _e888 = local_1.group_mask;
                                    let _e890 = local_1.len;
                                    if (_e890 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e890)] = _e888;
                                    let _e897 = local_1.len;
                                    local_1.len = (_e897 + 1u);
                                }
                            }
                            local_1.group = (_e87 + _e861);
                            let _e901 = local_3;
                            local_1.group_mask = ((_e901 & 4278190080u) | (_e865 >> bitcast<u32>(24i)));
                        }
                        let _e906 = local_4;
                        phi_995_ = (_e906 & 16777215u);
                        phi_998_ = _e473;
                        loop {
                            let _e909 = phi_995_;
                            let _e911 = phi_998_;
                            local_15 = _e911;
                            let _e912 = (_e909 == 0u);
                            local_10 = _e912;
                            local_16 = _e912;
                            if _e912 {
                                phi_996_ = u32();
                                phi_999_ = bool();
                                phi_2642_ = false;
                            } else {
                                let _e915 = nodes.member[(0u + _e471)].links[1u];
                                let _e919 = (_e915 + select(firstTrailingBit(_e909), 32u, (_e909 == 0u)));
                                if (_e919 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e926 = instances.member[(0u + _e919)].low_world;
                                let _e928 = instances.member[(0u + _e919)].high_world;
                                let _e935 = ((_e926.x - _e107) * _e265);
                                let _e936 = ((_e926.y - _e109) * _e275);
                                let _e937 = ((_e926.z - _e111) * _e285);
                                let _e944 = ((_e928.x - _e107) * _e265);
                                let _e945 = ((_e928.y - _e109) * _e275);
                                let _e946 = ((_e928.z - _e111) * _e285);
                                if (_e935 < _e944) {
                                    phi_1047_ = _e935;
                                } else {
                                    phi_1047_ = _e944;
                                }
                                let _e949 = phi_1047_;
                                if (_e936 < _e945) {
                                    phi_1052_ = _e936;
                                } else {
                                    phi_1052_ = _e945;
                                }
                                let _e952 = phi_1052_;
                                if (_e937 < _e946) {
                                    phi_1057_ = _e937;
                                } else {
                                    phi_1057_ = _e946;
                                }
                                let _e955 = phi_1057_;
                                if (_e935 > _e944) {
                                    phi_1065_ = _e935;
                                } else {
                                    phi_1065_ = _e944;
                                }
                                let _e961 = phi_1065_;
                                if (_e936 > _e945) {
                                    phi_1070_ = _e936;
                                } else {
                                    phi_1070_ = _e945;
                                }
                                let _e964 = phi_1070_;
                                if (_e937 > _e946) {
                                    phi_1075_ = _e937;
                                } else {
                                    phi_1075_ = _e946;
                                }
                                let _e967 = phi_1075_;
                                let _e971 = core_intrinsics_maximum_number_nsz_f32_((_e949 - _e320), (_e952 - _e321));
                                let _e972 = core_intrinsics_maximum_number_nsz_f32_(_e971, (_e955 - _e322));
                                let _e973 = core_intrinsics_minimum_number_nsz_f32_((_e961 + _e320), (_e964 + _e321));
                                let _e974 = core_intrinsics_minimum_number_nsz_f32_(_e973, (_e967 + _e322));
                                if (_e972 <= _e974) {
                                    if (_e972 <= _e117) {
                                        if (_e974 >= 0f) {
                                            let _e980 = instances.member[(0u + _e919)].world_to_object[0u];
                                            let _e991 = ((((_e980.x * _e107) + (_e980.y * _e109)) + (_e980.z * _e111)) + (_e980.w * 1f));
                                            let _e993 = instances.member[(0u + _e919)].world_to_object[1u];
                                            let _e1004 = ((((_e993.x * _e107) + (_e993.y * _e109)) + (_e993.z * _e111)) + (_e993.w * 1f));
                                            let _e1006 = instances.member[(0u + _e919)].world_to_object[2u];
                                            let _e1017 = ((((_e1006.x * _e107) + (_e1006.y * _e109)) + (_e1006.z * _e111)) + (_e1006.w * 1f));
                                            let _e1020 = instances.member[(0u + _e919)].world_to_object[0u];
                                            let _e1031 = ((((_e1020.x * _e125) + (_e1020.y * _e126)) + (_e1020.z * _e127)) + (_e1020.w * 0f));
                                            let _e1033 = instances.member[(0u + _e919)].world_to_object[1u];
                                            let _e1044 = ((((_e1033.x * _e125) + (_e1033.y * _e126)) + (_e1033.z * _e127)) + (_e1033.w * 0f));
                                            let _e1046 = instances.member[(0u + _e919)].world_to_object[2u];
                                            let _e1057 = ((((_e1046.x * _e125) + (_e1046.y * _e126)) + (_e1046.z * _e127)) + (_e1046.w * 0f));
                                            let _e1060 = instances.member[(0u + _e919)].root;
                                            let _e1062 = instances.member[(0u + _e919)].first_triangle;
                                            let _e1066 = abs(_e1031);
                                            let _e1067 = abs(_e1044);
                                            let _e1068 = abs(_e1057);
                                            if (abs(_e991) < 1000000000000000f) {
                                                if (abs(_e1004) < 1000000000000000f) {
                                                    if (abs(_e1017) < 1000000000000000f) {
                                                        if (_e1066 < 1000000000000000f) {
                                                            if (_e1067 < 1000000000000000f) {
                                                                if (_e1068 < 1000000000000000f) {
                                                                    if (_e1066 > 0f) {
                                                                        phi_1220_ = bool();
                                                                        phi_1221_ = true;
                                                                    } else {
                                                                        let _e1076 = (_e1067 > 0f);
                                                                        if _e1076 {
                                                                            phi_1219_ = bool();
                                                                        } else {
                                                                            phi_1219_ = (_e1068 > 0f);
                                                                        }
                                                                        let _e1079 = phi_1219_;
                                                                        phi_1220_ = _e1079;
                                                                        phi_1221_ = _e1076;
                                                                    }
                                                                    let _e1081 = phi_1220_;
                                                                    let _e1083 = phi_1221_;
                                                                    if _e1083 {
                                                                        phi_1225_ = true;
                                                                    } else {
                                                                        phi_1225_ = _e1081;
                                                                    }
                                                                    let _e1085 = phi_1225_;
                                                                    phi_1226_ = _e1085;
                                                                    phi_1227_ = false;
                                                                } else {
                                                                    phi_1226_ = bool();
                                                                    phi_1227_ = true;
                                                                }
                                                                let _e1087 = phi_1226_;
                                                                let _e1089 = phi_1227_;
                                                                phi_1228_ = _e1087;
                                                                phi_1229_ = false;
                                                                phi_1230_ = _e1089;
                                                            } else {
                                                                phi_1228_ = bool();
                                                                phi_1229_ = true;
                                                                phi_1230_ = false;
                                                            }
                                                            let _e1091 = phi_1228_;
                                                            let _e1093 = phi_1229_;
                                                            let _e1095 = phi_1230_;
                                                            phi_1231_ = _e1091;
                                                            phi_1232_ = _e1093;
                                                            phi_1233_ = _e1095;
                                                        } else {
                                                            phi_1231_ = bool();
                                                            phi_1232_ = true;
                                                            phi_1233_ = false;
                                                        }
                                                        let _e1097 = phi_1231_;
                                                        let _e1099 = phi_1232_;
                                                        let _e1101 = phi_1233_;
                                                        phi_1234_ = _e1097;
                                                        phi_1235_ = _e1099;
                                                        phi_1236_ = _e1101;
                                                    } else {
                                                        phi_1234_ = bool();
                                                        phi_1235_ = true;
                                                        phi_1236_ = false;
                                                    }
                                                    let _e1103 = phi_1234_;
                                                    let _e1105 = phi_1235_;
                                                    let _e1107 = phi_1236_;
                                                    phi_1237_ = _e1103;
                                                    phi_1238_ = _e1105;
                                                    phi_1239_ = _e1107;
                                                } else {
                                                    phi_1237_ = bool();
                                                    phi_1238_ = true;
                                                    phi_1239_ = false;
                                                }
                                                let _e1109 = phi_1237_;
                                                let _e1111 = phi_1238_;
                                                let _e1113 = phi_1239_;
                                                phi_1240_ = _e1109;
                                                phi_1241_ = _e1111;
                                                phi_1242_ = _e1113;
                                            } else {
                                                phi_1240_ = bool();
                                                phi_1241_ = true;
                                                phi_1242_ = false;
                                            }
                                            let _e1115 = phi_1240_;
                                            let _e1117 = phi_1241_;
                                            let _e1119 = phi_1242_;
                                            if _e1117 {
                                                phi_1246_ = true;
                                            } else {
                                                phi_1246_ = _e1119;
                                            }
                                            let _e1121 = phi_1246_;
                                            if _e1121 {
                                                phi_1250_ = false;
                                            } else {
                                                phi_1250_ = _e1115;
                                            }
                                            let _e1123 = phi_1250_;
                                            if _e1123 {
                                                let _e1124 = (_e1060 >= _e60);
                                                if _e1124 {
                                                    phi_2622_ = bool();
                                                } else {
                                                    if (_e1060 < _e60) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1130 = nodes.member[(0u + _e1060)].frame[0u];
                                                    let _e1134 = nodes.member[(0u + _e1060)].frame[1u];
                                                    let _e1138 = nodes.member[(0u + _e1060)].frame[2u];
                                                    let _e1142 = nodes.member[(0u + _e1060)].frame[0u];
                                                    let _e1146 = nodes.member[(0u + _e1060)].frame[1u];
                                                    let _e1150 = nodes.member[(0u + _e1060)].frame[2u];
                                                    let _e1154 = nodes.member[(0u + _e1060)].frame[3u];
                                                    let _e1188 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1031), abs(_e1044));
                                                    let _e1189 = core_intrinsics_maximum_number_nsz_f32_(_e1188, abs(_e1057));
                                                    let _e1190 = (_e1189 * 0.0000000000009094947f);
                                                    if (abs(_e1031) < _e1190) {
                                                        phi_1320_ = _e1190;
                                                    } else {
                                                        phi_1320_ = abs(_e1031);
                                                    }
                                                    let _e1195 = phi_1320_;
                                                    if (_e1031 < 0f) {
                                                        phi_1327_ = (-1f / _e1195);
                                                    } else {
                                                        phi_1327_ = (1f / _e1195);
                                                    }
                                                    let _e1200 = phi_1327_;
                                                    if (abs(_e1044) < _e1190) {
                                                        phi_1334_ = _e1190;
                                                    } else {
                                                        phi_1334_ = abs(_e1044);
                                                    }
                                                    let _e1205 = phi_1334_;
                                                    if (_e1044 < 0f) {
                                                        phi_1341_ = (-1f / _e1205);
                                                    } else {
                                                        phi_1341_ = (1f / _e1205);
                                                    }
                                                    let _e1210 = phi_1341_;
                                                    if (abs(_e1057) < _e1190) {
                                                        phi_1348_ = _e1190;
                                                    } else {
                                                        phi_1348_ = abs(_e1057);
                                                    }
                                                    let _e1215 = phi_1348_;
                                                    if (_e1057 < 0f) {
                                                        phi_1355_ = (-1f / _e1215);
                                                    } else {
                                                        phi_1355_ = (1f / _e1215);
                                                    }
                                                    let _e1220 = phi_1355_;
                                                    let _e1224 = abs((bitcast<f32>(_e1130) - _e991));
                                                    let _e1225 = abs((bitcast<f32>(_e1134) - _e1004));
                                                    let _e1226 = abs((bitcast<f32>(_e1138) - _e1017));
                                                    let _e1230 = abs(((bitcast<f32>(_e1142) + (bitcast<f32>((((_e1154 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e991));
                                                    let _e1231 = abs(((bitcast<f32>(_e1146) + (bitcast<f32>((((_e1154 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1004));
                                                    let _e1232 = abs(((bitcast<f32>(_e1150) + (bitcast<f32>((((_e1154 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1017));
                                                    if (_e1224 > _e1230) {
                                                        phi_1372_ = _e1224;
                                                    } else {
                                                        phi_1372_ = _e1230;
                                                    }
                                                    let _e1235 = phi_1372_;
                                                    if (_e1225 > _e1231) {
                                                        phi_1377_ = _e1225;
                                                    } else {
                                                        phi_1377_ = _e1231;
                                                    }
                                                    let _e1238 = phi_1377_;
                                                    if (_e1226 > _e1232) {
                                                        phi_1382_ = _e1226;
                                                    } else {
                                                        phi_1382_ = _e1232;
                                                    }
                                                    let _e1241 = phi_1382_;
                                                    let _e1242 = core_intrinsics_maximum_number_nsz_f32_(_e1235, _e1238);
                                                    let _e1243 = core_intrinsics_maximum_number_nsz_f32_(_e1242, _e1241);
                                                    let _e1247 = (_e1243 * 0.0000019073486f);
                                                    let _e1248 = (abs(_e1200) * _e1247);
                                                    let _e1249 = (abs(_e1210) * _e1247);
                                                    let _e1250 = (abs(_e1220) * _e1247);
                                                    let _e1254 = (_e1243 * 0.0000009536743f);
                                                    let _e1255 = (abs(_e1200) * _e1254);
                                                    let _e1256 = (abs(_e1210) * _e1254);
                                                    let _e1257 = (abs(_e1220) * _e1254);
                                                    let _e1258 = abs(_e1031);
                                                    let _e1259 = abs(_e1044);
                                                    let _e1260 = abs(_e1057);
                                                    if (_e1258 >= _e1259) {
                                                        if (_e1258 >= _e1260) {
                                                            phi_1410_ = false;
                                                        } else {
                                                            phi_1410_ = true;
                                                        }
                                                        let _e1264 = phi_1410_;
                                                        phi_1411_ = _e1264;
                                                    } else {
                                                        phi_1411_ = true;
                                                    }
                                                    let _e1266 = phi_1411_;
                                                    if _e1266 {
                                                        if (_e1259 >= _e1260) {
                                                            phi_1419_ = 1u;
                                                        } else {
                                                            phi_1419_ = 2u;
                                                        }
                                                        let _e1269 = phi_1419_;
                                                        phi_1420_ = _e1269;
                                                    } else {
                                                        phi_1420_ = 0u;
                                                    }
                                                    let _e1271 = phi_1420_;
                                                    if (_e1271 == 0u) {
                                                        phi_1432_ = vec3<f32>(_e1044, _e1057, _e1031);
                                                    } else {
                                                        if (_e1271 == 1u) {
                                                            phi_1431_ = vec3<f32>(_e1057, _e1031, _e1044);
                                                        } else {
                                                            phi_1431_ = vec3<f32>(_e1031, _e1044, _e1057);
                                                        }
                                                        let _e1277 = phi_1431_;
                                                        phi_1432_ = _e1277;
                                                    }
                                                    let _e1279 = phi_1432_;
                                                    let _e1282 = (_e1279.x / _e1279.z);
                                                    let _e1285 = (_e1279.y / _e1279.z);
                                                    if (_e1200 < 0f) {
                                                        phi_1445_ = 0u;
                                                    } else {
                                                        phi_1445_ = 1u;
                                                    }
                                                    let _e1290 = phi_1445_;
                                                    if (_e1210 < 0f) {
                                                        phi_1450_ = 0u;
                                                    } else {
                                                        phi_1450_ = 2u;
                                                    }
                                                    let _e1293 = phi_1450_;
                                                    if (_e1220 < 0f) {
                                                        phi_1455_ = 0u;
                                                    } else {
                                                        phi_1455_ = 4u;
                                                    }
                                                    let _e1296 = phi_1455_;
                                                    let _e1298 = ((_e1290 | _e1293) | _e1296);
                                                    let _e1299 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1060, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1299.first[0], _e1299.first[1], _e1299.first[2], _e1299.first[3], _e1299.first[4], _e1299.first[5], _e1299.first[6], _e1299.first[7], _e1299.first[8], _e1299.first[9], _e1299.first[10], _e1299.first[11], _e1299.first[12], _e1299.first[13], _e1299.first[14], _e1299.first[15], _e1299.first[16], _e1299.first[17], _e1299.first[18], _e1299.first[19], _e1299.first[20], _e1299.first[21], _e1299.first[22], _e1299.first[23], _e1299.first[24], _e1299.first[25], _e1299.first[26], _e1299.first[27], _e1299.first[28], _e1299.first[29], _e1299.first[30], _e1299.first[31]), array<u32, 32>(_e1299.mask[0], _e1299.mask[1], _e1299.mask[2], _e1299.mask[3], _e1299.mask[4], _e1299.mask[5], _e1299.mask[6], _e1299.mask[7], _e1299.mask[8], _e1299.mask[9], _e1299.mask[10], _e1299.mask[11], _e1299.mask[12], _e1299.mask[13], _e1299.mask[14], _e1299.mask[15], _e1299.mask[16], _e1299.mask[17], _e1299.mask[18], _e1299.mask[19], _e1299.mask[20], _e1299.mask[21], _e1299.mask[22], _e1299.mask[23], _e1299.mask[24], _e1299.mask[25], _e1299.mask[26], _e1299.mask[27], _e1299.mask[28], _e1299.mask[29], _e1299.mask[30], _e1299.mask[31]), _e1299.len, _e1299.group, _e1299.group_mask);
                                                    let _e1373 = local.group_mask;
                                                    if ((_e1373 & 4278190080u) == 0u) {
                                                        let _e1377 = local.len;
                                                        if (_e1377 == 0u) {
                                                            phi_1569_ = false;
                                                        } else {
                                                            let _e1381 = local.len;
                                                            local.len = (_e1381 - 1u);
                                                            let _e1384 = local.len;
                                                            if (_e1384 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1389 = local.first[(0u + _e1384)];
                                                            local.group = _e1389;
                                                            let _e1392 = local.len;
                                                            if (_e1392 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1397 = local.mask[(0u + _e1392)];
                                                            local.group_mask = _e1397;
                                                            phi_1569_ = true;
                                                        }
                                                        let _e1400 = phi_1569_;
                                                        phi_1570_ = _e1400;
                                                    } else {
                                                        phi_1570_ = true;
                                                    }
                                                    let _e1402 = phi_1570_;
                                                    if _e1402 {
                                                        let _e1404 = local.group_mask;
                                                        let _e1410 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1404)), 32u, (_e1404 == 0u)));
                                                        let _e1414 = local.group_mask;
                                                        let _e1428 = local.group_mask;
                                                        local.group_mask = (_e1428 & ~((1u << bitcast<u32>((_e1410 & 31u)))));
                                                        let _e1431 = local.group;
                                                        phi_1601_ = (_e1431 + countOneBits(((_e1414 & ~((4294967295u << bitcast<u32>((((_e1410 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1601_ = 4294967295u;
                                                    }
                                                    let _e1434 = phi_1601_;
                                                    phi_1603_ = _e1434;
                                                    phi_1606_ = _e911;
                                                    loop {
                                                        let _e1436 = phi_1603_;
                                                        let _e1438 = phi_1606_;
                                                        local_14 = _e1438;
                                                        if (_e1436 != 4294967295u) {
                                                            if (_e1436 < _e60) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1445 = nodes.member[(0u + _e1436)].frame[3u];
                                                            let _e1470 = (bitcast<f32>((((_e1445 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1200);
                                                            let _e1471 = (bitcast<f32>((((_e1445 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1210);
                                                            let _e1472 = (bitcast<f32>((((_e1445 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1220);
                                                            let _e1475 = nodes.member[(0u + _e1436)].frame[0u];
                                                            let _e1479 = nodes.member[(0u + _e1436)].frame[1u];
                                                            let _e1483 = nodes.member[(0u + _e1436)].frame[2u];
                                                            let _e1488 = ((bitcast<f32>(_e1475) - _e991) * _e1200);
                                                            let _e1489 = ((bitcast<f32>(_e1479) - _e1004) * _e1210);
                                                            let _e1490 = ((bitcast<f32>(_e1483) - _e1017) * _e1220);
                                                            let _e1498 = nodes.member[(0u + _e1436)].x;
                                                            if (_e1200 < 0f) {
                                                                let _e1509 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1498.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1515 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1509.unnamed.word, _e1498.w), _e1509.unnamed_1);
                                                                let _e1521 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1515.unnamed, lt_mask_LightPlace(_e1498.x, _e1515.unnamed_1.shift));
                                                                phi_1686_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1521.unnamed, lt_mask_LightPlace(_e1521.unnamed_1.word, _e1498.y));
                                                            } else {
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1498.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1537.unnamed.word, _e1498.y), _e1537.unnamed_1);
                                                                let _e1549 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_mask_LightPlace(_e1498.z, _e1543.unnamed_1.shift));
                                                                phi_1686_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1549.unnamed, lt_mask_LightPlace(_e1549.unnamed_1.word, _e1498.w));
                                                            }
                                                            let _e1557 = phi_1686_;
                                                            let _e1567 = nodes.member[(0u + _e1436)].y;
                                                            if (_e1210 < 0f) {
                                                                let _e1578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1567.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1578.unnamed.word, _e1567.w), _e1578.unnamed_1);
                                                                let _e1590 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1584.unnamed, lt_mask_LightPlace(_e1567.x, _e1584.unnamed_1.shift));
                                                                phi_1713_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1590.unnamed, lt_mask_LightPlace(_e1590.unnamed_1.word, _e1567.y));
                                                            } else {
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1567.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1606.unnamed.word, _e1567.y), _e1606.unnamed_1);
                                                                let _e1618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_mask_LightPlace(_e1567.z, _e1612.unnamed_1.shift));
                                                                phi_1713_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1618.unnamed, lt_mask_LightPlace(_e1618.unnamed_1.word, _e1567.w));
                                                            }
                                                            let _e1626 = phi_1713_;
                                                            let _e1636 = nodes.member[(0u + _e1436)].z;
                                                            if (_e1220 < 0f) {
                                                                let _e1647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1636.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1647.unnamed.word, _e1636.w), _e1647.unnamed_1);
                                                                let _e1659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1653.unnamed, lt_mask_LightPlace(_e1636.x, _e1653.unnamed_1.shift));
                                                                phi_1740_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1659.unnamed, lt_mask_LightPlace(_e1659.unnamed_1.word, _e1636.y));
                                                            } else {
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1636.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1675.unnamed.word, _e1636.y), _e1675.unnamed_1);
                                                                let _e1687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_mask_LightPlace(_e1636.z, _e1681.unnamed_1.shift));
                                                                phi_1740_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1687.unnamed, lt_mask_LightPlace(_e1687.unnamed_1.word, _e1636.w));
                                                            }
                                                            let _e1695 = phi_1740_;
                                                            phi_1746_ = 0u;
                                                            phi_1749_ = 0u;
                                                            loop {
                                                                let _e1705 = phi_1746_;
                                                                let _e1707 = phi_1749_;
                                                                local_5 = _e1707;
                                                                local_6 = _e1707;
                                                                local_7 = _e1707;
                                                                let _e1708 = (_e1705 < 8u);
                                                                if _e1708 {
                                                                    let _e1710 = (_e1705 >> bitcast<u32>(2i));
                                                                    let _e1711 = (_e1705 & 3u);
                                                                    if (_e1710 == 0u) {
                                                                        phi_1763_ = _e1557.unnamed.word;
                                                                    } else {
                                                                        phi_1763_ = _e1557.unnamed.shift;
                                                                    }
                                                                    let _e1714 = phi_1763_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1773_ = _e1626.unnamed.word;
                                                                    } else {
                                                                        phi_1773_ = _e1626.unnamed.shift;
                                                                    }
                                                                    let _e1723 = phi_1773_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1783_ = _e1695.unnamed.word;
                                                                    } else {
                                                                        phi_1783_ = _e1695.unnamed.shift;
                                                                    }
                                                                    let _e1732 = phi_1783_;
                                                                    let _e1745 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1714 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1248)), ((f32(((_e1723 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 - _e1249)));
                                                                    let _e1746 = core_intrinsics_maximum_number_nsz_f32_(_e1745, ((f32(((_e1732 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1472) + (_e1490 - _e1250)));
                                                                    if (_e1710 == 0u) {
                                                                        phi_1801_ = _e1557.unnamed_1.word;
                                                                    } else {
                                                                        phi_1801_ = _e1557.unnamed_1.shift;
                                                                    }
                                                                    let _e1749 = phi_1801_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1811_ = _e1626.unnamed_1.word;
                                                                    } else {
                                                                        phi_1811_ = _e1626.unnamed_1.shift;
                                                                    }
                                                                    let _e1758 = phi_1811_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1821_ = _e1695.unnamed_1.word;
                                                                    } else {
                                                                        phi_1821_ = _e1695.unnamed_1.shift;
                                                                    }
                                                                    let _e1767 = phi_1821_;
                                                                    let _e1780 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1749 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1248)), ((f32(((_e1758 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 + _e1249)));
                                                                    let _e1781 = core_intrinsics_minimum_number_nsz_f32_(_e1780, ((f32(((_e1767 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1472) + (_e1490 + _e1250)));
                                                                    if (_e1746 <= _e1781) {
                                                                        if (_e1746 <= _e117) {
                                                                            if (_e1781 >= 0f) {
                                                                                if (_e1710 == 0u) {
                                                                                    let _e1788 = nodes.member[(0u + _e1436)].links[2u];
                                                                                    phi_1857_ = _e1788;
                                                                                } else {
                                                                                    let _e1791 = nodes.member[(0u + _e1436)].links[3u];
                                                                                    phi_1857_ = _e1791;
                                                                                }
                                                                                let _e1793 = phi_1857_;
                                                                                let _e1798 = ((_e1793 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u);
                                                                                let _e1799 = (_e1798 & 31u);
                                                                                if (_e1799 >= 24u) {
                                                                                    phi_1870_ = (24u + ((_e1799 - 24u) ^ _e1298));
                                                                                } else {
                                                                                    phi_1870_ = _e1799;
                                                                                }
                                                                                let _e1805 = phi_1870_;
                                                                                phi_1875_ = (_e1707 | ((_e1798 >> bitcast<u32>(5i)) << bitcast<u32>((_e1805 & 31u))));
                                                                            } else {
                                                                                phi_1875_ = _e1707;
                                                                            }
                                                                            let _e1813 = phi_1875_;
                                                                            phi_1876_ = _e1813;
                                                                        } else {
                                                                            phi_1876_ = _e1707;
                                                                        }
                                                                        let _e1815 = phi_1876_;
                                                                        phi_1877_ = _e1815;
                                                                    } else {
                                                                        phi_1877_ = _e1707;
                                                                    }
                                                                    let _e1817 = phi_1877_;
                                                                    phi_1747_ = (_e1705 + 1u);
                                                                    phi_1750_ = _e1817;
                                                                } else {
                                                                    phi_1747_ = u32();
                                                                    phi_1750_ = u32();
                                                                }
                                                                let _e1820 = phi_1747_;
                                                                let _e1822 = phi_1750_;
                                                                continue;
                                                                continuing {
                                                                    phi_1746_ = _e1820;
                                                                    phi_1749_ = _e1822;
                                                                    break if !(_e1708);
                                                                }
                                                            }
                                                            let _e1826 = nodes.member[(0u + _e1436)].links[0u];
                                                            let _e1830 = nodes.member[(0u + _e1436)].frame[3u];
                                                            let _e1834 = local_5;
                                                            if ((_e1834 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1838 = local.group_mask;
                                                                if ((_e1838 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1842 = local.len;
                                                                    if (_e1842 < 32u) {
                                                                        let _e1845 = local.group;
                                                                        let _e1847 = local.len;
                                                                        if (_e1847 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1847)] = _e1845;
                                                                        let _e1853 = local.group_mask;
                                                                        let _e1855 = local.len;
                                                                        if (_e1855 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1855)] = _e1853;
                                                                        let _e1862 = local.len;
                                                                        local.len = (_e1862 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1060 + _e1826);
                                                                let _e1866 = local_6;
                                                                local.group_mask = ((_e1866 & 4278190080u) | (_e1830 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1871 = local_7;
                                                            phi_1935_ = (_e1871 & 16777215u);
                                                            phi_1938_ = _e1438;
                                                            loop {
                                                                let _e1874 = phi_1935_;
                                                                let _e1876 = phi_1938_;
                                                                local_12 = _e1876;
                                                                let _e1877 = (_e1874 == 0u);
                                                                local_8 = _e1877;
                                                                local_13 = _e1877;
                                                                if _e1877 {
                                                                    phi_1936_ = u32();
                                                                    phi_1939_ = bool();
                                                                    phi_2536_ = false;
                                                                } else {
                                                                    let _e1880 = nodes.member[(0u + _e1436)].links[1u];
                                                                    let _e1885 = ((_e1062 + _e1880) + select(firstTrailingBit(_e1874), 32u, (_e1874 == 0u)));
                                                                    if (_e1885 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1892 = triangles.member[(0u + _e1885)].v0_;
                                                                    let _e1894 = (_e1892.x - _e991);
                                                                    let _e1896 = (_e1892.y - _e1004);
                                                                    let _e1898 = (_e1892.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_1983_ = vec3<f32>(_e1896, _e1898, _e1894);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_1982_ = vec3<f32>(_e1898, _e1894, _e1896);
                                                                        } else {
                                                                            phi_1982_ = (_e1892 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1906 = phi_1982_;
                                                                        phi_1983_ = _e1906;
                                                                    }
                                                                    let _e1908 = phi_1983_;
                                                                    let _e1912 = (_e1908.x - (_e1282 * _e1908.z));
                                                                    let _e1916 = (_e1908.y - (_e1285 * _e1908.z));
                                                                    let _e1918 = triangles.member[(0u + _e1885)].v1_;
                                                                    let _e1920 = (_e1918.x - _e991);
                                                                    let _e1922 = (_e1918.y - _e1004);
                                                                    let _e1924 = (_e1918.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2013_ = vec3<f32>(_e1922, _e1924, _e1920);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2012_ = vec3<f32>(_e1924, _e1920, _e1922);
                                                                        } else {
                                                                            phi_2012_ = (_e1918 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1932 = phi_2012_;
                                                                        phi_2013_ = _e1932;
                                                                    }
                                                                    let _e1934 = phi_2013_;
                                                                    let _e1938 = (_e1934.x - (_e1282 * _e1934.z));
                                                                    let _e1942 = (_e1934.y - (_e1285 * _e1934.z));
                                                                    let _e1944 = triangles.member[(0u + _e1885)].v2_;
                                                                    let _e1946 = (_e1944.x - _e991);
                                                                    let _e1948 = (_e1944.y - _e1004);
                                                                    let _e1950 = (_e1944.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2043_ = vec3<f32>(_e1948, _e1950, _e1946);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2042_ = vec3<f32>(_e1950, _e1946, _e1948);
                                                                        } else {
                                                                            phi_2042_ = (_e1944 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1958 = phi_2042_;
                                                                        phi_2043_ = _e1958;
                                                                    }
                                                                    let _e1960 = phi_2043_;
                                                                    let _e1964 = (_e1960.x - (_e1282 * _e1960.z));
                                                                    let _e1968 = (_e1960.y - (_e1285 * _e1960.z));
                                                                    if (_e1938 < _e1964) {
                                                                        phi_2062_ = true;
                                                                    } else {
                                                                        if (_e1938 == _e1964) {
                                                                            phi_2061_ = (_e1942 < _e1968);
                                                                        } else {
                                                                            phi_2061_ = false;
                                                                        }
                                                                        let _e1973 = phi_2061_;
                                                                        phi_2062_ = _e1973;
                                                                    }
                                                                    let _e1975 = phi_2062_;
                                                                    if _e1975 {
                                                                        phi_2066_ = _e1968;
                                                                        phi_2067_ = _e1964;
                                                                        phi_2068_ = _e1942;
                                                                        phi_2069_ = _e1938;
                                                                    } else {
                                                                        phi_2066_ = _e1942;
                                                                        phi_2067_ = _e1938;
                                                                        phi_2068_ = _e1968;
                                                                        phi_2069_ = _e1964;
                                                                    }
                                                                    let _e1977 = phi_2066_;
                                                                    let _e1979 = phi_2067_;
                                                                    let _e1981 = phi_2068_;
                                                                    let _e1983 = phi_2069_;
                                                                    let _e1986 = ((_e1983 * _e1977) - (_e1981 * _e1979));
                                                                    if _e1975 {
                                                                        phi_2077_ = -(_e1986);
                                                                    } else {
                                                                        phi_2077_ = _e1986;
                                                                    }
                                                                    let _e1989 = phi_2077_;
                                                                    if (_e1964 < _e1912) {
                                                                        phi_2088_ = true;
                                                                    } else {
                                                                        if (_e1964 == _e1912) {
                                                                            phi_2087_ = (_e1968 < _e1916);
                                                                        } else {
                                                                            phi_2087_ = false;
                                                                        }
                                                                        let _e1994 = phi_2087_;
                                                                        phi_2088_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2088_;
                                                                    if _e1996 {
                                                                        phi_2092_ = _e1916;
                                                                        phi_2093_ = _e1912;
                                                                        phi_2094_ = _e1968;
                                                                        phi_2095_ = _e1964;
                                                                    } else {
                                                                        phi_2092_ = _e1968;
                                                                        phi_2093_ = _e1964;
                                                                        phi_2094_ = _e1916;
                                                                        phi_2095_ = _e1912;
                                                                    }
                                                                    let _e1998 = phi_2092_;
                                                                    let _e2000 = phi_2093_;
                                                                    let _e2002 = phi_2094_;
                                                                    let _e2004 = phi_2095_;
                                                                    let _e2007 = ((_e2004 * _e1998) - (_e2002 * _e2000));
                                                                    if _e1996 {
                                                                        phi_2103_ = -(_e2007);
                                                                    } else {
                                                                        phi_2103_ = _e2007;
                                                                    }
                                                                    let _e2010 = phi_2103_;
                                                                    if (_e1912 < _e1938) {
                                                                        phi_2114_ = true;
                                                                    } else {
                                                                        if (_e1912 == _e1938) {
                                                                            phi_2113_ = (_e1916 < _e1942);
                                                                        } else {
                                                                            phi_2113_ = false;
                                                                        }
                                                                        let _e2015 = phi_2113_;
                                                                        phi_2114_ = _e2015;
                                                                    }
                                                                    let _e2017 = phi_2114_;
                                                                    if _e2017 {
                                                                        phi_2118_ = _e1942;
                                                                        phi_2119_ = _e1938;
                                                                        phi_2120_ = _e1916;
                                                                        phi_2121_ = _e1912;
                                                                    } else {
                                                                        phi_2118_ = _e1916;
                                                                        phi_2119_ = _e1912;
                                                                        phi_2120_ = _e1942;
                                                                        phi_2121_ = _e1938;
                                                                    }
                                                                    let _e2019 = phi_2118_;
                                                                    let _e2021 = phi_2119_;
                                                                    let _e2023 = phi_2120_;
                                                                    let _e2025 = phi_2121_;
                                                                    let _e2028 = ((_e2025 * _e2019) - (_e2023 * _e2021));
                                                                    if _e2017 {
                                                                        phi_2129_ = -(_e2028);
                                                                    } else {
                                                                        phi_2129_ = _e2028;
                                                                    }
                                                                    let _e2031 = phi_2129_;
                                                                    if (_e1989 >= 0f) {
                                                                        if (_e2010 >= 0f) {
                                                                            if (_e2031 >= 0f) {
                                                                                phi_2144_ = ((_e1989 + _e2010) + _e2031);
                                                                                phi_2145_ = false;
                                                                            } else {
                                                                                phi_2144_ = f32();
                                                                                phi_2145_ = true;
                                                                            }
                                                                            let _e2038 = phi_2144_;
                                                                            let _e2040 = phi_2145_;
                                                                            phi_2146_ = _e2038;
                                                                            phi_2147_ = _e2040;
                                                                        } else {
                                                                            phi_2146_ = f32();
                                                                            phi_2147_ = true;
                                                                        }
                                                                        let _e2042 = phi_2146_;
                                                                        let _e2044 = phi_2147_;
                                                                        phi_2148_ = _e2042;
                                                                        phi_2149_ = _e2044;
                                                                    } else {
                                                                        phi_2148_ = f32();
                                                                        phi_2149_ = true;
                                                                    }
                                                                    let _e2046 = phi_2148_;
                                                                    let _e2048 = phi_2149_;
                                                                    if _e2048 {
                                                                        if (_e1989 <= 0f) {
                                                                            if (_e2010 <= 0f) {
                                                                                let _e2051 = (_e2031 <= 0f);
                                                                                if _e2051 {
                                                                                }
                                                                                phi_2167_ = ((_e1989 + _e2010) + _e2031);
                                                                                phi_2168_ = false;
                                                                                phi_2169_ = _e2051;
                                                                            } else {
                                                                                phi_2167_ = f32();
                                                                                phi_2168_ = true;
                                                                                phi_2169_ = false;
                                                                            }
                                                                            let _e2055 = phi_2167_;
                                                                            let _e2057 = phi_2168_;
                                                                            let _e2059 = phi_2169_;
                                                                            phi_2170_ = _e2055;
                                                                            phi_2171_ = _e2057;
                                                                            phi_2172_ = _e2059;
                                                                        } else {
                                                                            phi_2170_ = f32();
                                                                            phi_2171_ = true;
                                                                            phi_2172_ = false;
                                                                        }
                                                                        let _e2061 = phi_2170_;
                                                                        let _e2063 = phi_2171_;
                                                                        let _e2065 = phi_2172_;
                                                                        if _e2063 {
                                                                            phi_2176_ = false;
                                                                        } else {
                                                                            phi_2176_ = _e2065;
                                                                        }
                                                                        let _e2067 = phi_2176_;
                                                                        phi_2177_ = _e2061;
                                                                        phi_2178_ = _e2067;
                                                                    } else {
                                                                        phi_2177_ = _e2046;
                                                                        phi_2178_ = true;
                                                                    }
                                                                    let _e2069 = phi_2177_;
                                                                    let _e2071 = phi_2178_;
                                                                    if _e2071 {
                                                                        let _e2072 = (_e2069 == 0f);
                                                                        if _e2072 {
                                                                            phi_2494_ = lt_bvh_triangle_Intersection();
                                                                            phi_2495_ = false;
                                                                        } else {
                                                                            let _e2074 = triangles.member[(0u + _e1885)].v0_;
                                                                            let _e2076 = (_e2074.x - _e991);
                                                                            let _e2078 = (_e2074.y - _e1004);
                                                                            let _e2080 = (_e2074.z - _e1017);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2207_ = vec3<f32>(_e2078, _e2080, _e2076);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2206_ = vec3<f32>(_e2080, _e2076, _e2078);
                                                                                } else {
                                                                                    phi_2206_ = (_e2074 - vec3<f32>(_e991, _e1004, _e1017));
                                                                                }
                                                                                let _e2088 = phi_2206_;
                                                                                phi_2207_ = _e2088;
                                                                            }
                                                                            let _e2090 = phi_2207_;
                                                                            let _e2092 = triangles.member[(0u + _e1885)].v1_;
                                                                            let _e2094 = triangles.member[(0u + _e1885)].v0_;
                                                                            let _e2097 = (_e2092.x - _e2094.x);
                                                                            let _e2100 = (_e2092.y - _e2094.y);
                                                                            let _e2103 = (_e2092.z - _e2094.z);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2233_ = vec3<f32>(_e2100, _e2103, _e2097);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2232_ = vec3<f32>(_e2103, _e2097, _e2100);
                                                                                } else {
                                                                                    phi_2232_ = (_e2092 - _e2094);
                                                                                }
                                                                                let _e2110 = phi_2232_;
                                                                                phi_2233_ = _e2110;
                                                                            }
                                                                            let _e2112 = phi_2233_;
                                                                            let _e2114 = triangles.member[(0u + _e1885)].v2_;
                                                                            let _e2116 = triangles.member[(0u + _e1885)].v0_;
                                                                            let _e2119 = (_e2114.x - _e2116.x);
                                                                            let _e2122 = (_e2114.y - _e2116.y);
                                                                            let _e2125 = (_e2114.z - _e2116.z);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2259_ = vec3<f32>(_e2122, _e2125, _e2119);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2258_ = vec3<f32>(_e2125, _e2119, _e2122);
                                                                                } else {
                                                                                    phi_2258_ = (_e2114 - _e2116);
                                                                                }
                                                                                let _e2132 = phi_2258_;
                                                                                phi_2259_ = _e2132;
                                                                            }
                                                                            let _e2134 = phi_2259_;
                                                                            let _e2141 = ((_e2112.y * _e2134.z) - (_e2112.z * _e2134.y));
                                                                            let _e2148 = ((_e2112.z * _e2134.x) - (_e2112.x * _e2134.z));
                                                                            let _e2155 = ((_e2112.x * _e2134.y) - (_e2112.y * _e2134.x));
                                                                            let _e2169 = (((1f / _e1279.z) * (((_e2141 * _e2090.x) + (_e2148 * _e2090.y)) + (_e2155 * _e2090.z))) / (((_e2141 * _e1282) + (_e2148 * _e1285)) + _e2155));
                                                                            if (_e2169 > 0f) {
                                                                                if (_e2169 < _e117) {
                                                                                    let _e2173 = triangles.member[(0u + _e1885)].v0_;
                                                                                    let _e2175 = triangles.member[(0u + _e1885)].v1_;
                                                                                    if (_e2173.x < _e2175.x) {
                                                                                        phi_2315_ = _e2173.x;
                                                                                    } else {
                                                                                        phi_2315_ = _e2175.x;
                                                                                    }
                                                                                    let _e2182 = phi_2315_;
                                                                                    if (_e2173.y < _e2175.y) {
                                                                                        phi_2324_ = _e2173.y;
                                                                                    } else {
                                                                                        phi_2324_ = _e2175.y;
                                                                                    }
                                                                                    let _e2189 = phi_2324_;
                                                                                    if (_e2173.z < _e2175.z) {
                                                                                        phi_2333_ = _e2173.z;
                                                                                    } else {
                                                                                        phi_2333_ = _e2175.z;
                                                                                    }
                                                                                    let _e2196 = phi_2333_;
                                                                                    let _e2198 = triangles.member[(0u + _e1885)].v2_;
                                                                                    if (_e2182 < _e2198.x) {
                                                                                        phi_2342_ = _e2182;
                                                                                    } else {
                                                                                        phi_2342_ = _e2198.x;
                                                                                    }
                                                                                    let _e2203 = phi_2342_;
                                                                                    if (_e2189 < _e2198.y) {
                                                                                        phi_2349_ = _e2189;
                                                                                    } else {
                                                                                        phi_2349_ = _e2198.y;
                                                                                    }
                                                                                    let _e2208 = phi_2349_;
                                                                                    if (_e2196 < _e2198.z) {
                                                                                        phi_2356_ = _e2196;
                                                                                    } else {
                                                                                        phi_2356_ = _e2198.z;
                                                                                    }
                                                                                    let _e2213 = phi_2356_;
                                                                                    let _e2215 = triangles.member[(0u + _e1885)].v0_;
                                                                                    let _e2217 = triangles.member[(0u + _e1885)].v1_;
                                                                                    if (_e2215.x > _e2217.x) {
                                                                                        phi_2369_ = _e2215.x;
                                                                                    } else {
                                                                                        phi_2369_ = _e2217.x;
                                                                                    }
                                                                                    let _e2224 = phi_2369_;
                                                                                    if (_e2215.y > _e2217.y) {
                                                                                        phi_2378_ = _e2215.y;
                                                                                    } else {
                                                                                        phi_2378_ = _e2217.y;
                                                                                    }
                                                                                    let _e2231 = phi_2378_;
                                                                                    if (_e2215.z > _e2217.z) {
                                                                                        phi_2387_ = _e2215.z;
                                                                                    } else {
                                                                                        phi_2387_ = _e2217.z;
                                                                                    }
                                                                                    let _e2238 = phi_2387_;
                                                                                    let _e2240 = triangles.member[(0u + _e1885)].v2_;
                                                                                    if (_e2224 > _e2240.x) {
                                                                                        phi_2396_ = _e2224;
                                                                                    } else {
                                                                                        phi_2396_ = _e2240.x;
                                                                                    }
                                                                                    let _e2245 = phi_2396_;
                                                                                    if (_e2231 > _e2240.y) {
                                                                                        phi_2403_ = _e2231;
                                                                                    } else {
                                                                                        phi_2403_ = _e2240.y;
                                                                                    }
                                                                                    let _e2250 = phi_2403_;
                                                                                    if (_e2238 > _e2240.z) {
                                                                                        phi_2410_ = _e2238;
                                                                                    } else {
                                                                                        phi_2410_ = _e2240.z;
                                                                                    }
                                                                                    let _e2255 = phi_2410_;
                                                                                    let _e2259 = ((_e2203 - _e991) * _e1200);
                                                                                    let _e2260 = ((_e2208 - _e1004) * _e1210);
                                                                                    let _e2261 = ((_e2213 - _e1017) * _e1220);
                                                                                    let _e2265 = ((_e2245 - _e991) * _e1200);
                                                                                    let _e2266 = ((_e2250 - _e1004) * _e1210);
                                                                                    let _e2267 = ((_e2255 - _e1017) * _e1220);
                                                                                    if (_e2259 < _e2265) {
                                                                                        phi_2427_ = _e2259;
                                                                                    } else {
                                                                                        phi_2427_ = _e2265;
                                                                                    }
                                                                                    let _e2270 = phi_2427_;
                                                                                    if (_e2260 < _e2266) {
                                                                                        phi_2432_ = _e2260;
                                                                                    } else {
                                                                                        phi_2432_ = _e2266;
                                                                                    }
                                                                                    let _e2273 = phi_2432_;
                                                                                    if (_e2261 < _e2267) {
                                                                                        phi_2437_ = _e2261;
                                                                                    } else {
                                                                                        phi_2437_ = _e2267;
                                                                                    }
                                                                                    let _e2276 = phi_2437_;
                                                                                    if (_e2259 > _e2265) {
                                                                                        phi_2445_ = _e2259;
                                                                                    } else {
                                                                                        phi_2445_ = _e2265;
                                                                                    }
                                                                                    let _e2282 = phi_2445_;
                                                                                    if (_e2260 > _e2266) {
                                                                                        phi_2450_ = _e2260;
                                                                                    } else {
                                                                                        phi_2450_ = _e2266;
                                                                                    }
                                                                                    let _e2285 = phi_2450_;
                                                                                    if (_e2261 > _e2267) {
                                                                                        phi_2455_ = _e2261;
                                                                                    } else {
                                                                                        phi_2455_ = _e2267;
                                                                                    }
                                                                                    let _e2288 = phi_2455_;
                                                                                    let _e2292 = core_intrinsics_maximum_number_nsz_f32_((_e2270 - _e1255), (_e2273 - _e1256));
                                                                                    let _e2293 = core_intrinsics_maximum_number_nsz_f32_(_e2292, (_e2276 - _e1257));
                                                                                    let _e2294 = core_intrinsics_minimum_number_nsz_f32_((_e2282 + _e1255), (_e2285 + _e1256));
                                                                                    let _e2295 = core_intrinsics_minimum_number_nsz_f32_(_e2294, (_e2288 + _e1257));
                                                                                    if (_e2293 > _e972) {
                                                                                        phi_2467_ = _e2293;
                                                                                    } else {
                                                                                        phi_2467_ = _e972;
                                                                                    }
                                                                                    let _e2298 = phi_2467_;
                                                                                    if (_e2295 < _e974) {
                                                                                        phi_2472_ = _e2295;
                                                                                    } else {
                                                                                        phi_2472_ = _e974;
                                                                                    }
                                                                                    let _e2301 = phi_2472_;
                                                                                    if (_e2169 < _e2298) {
                                                                                        phi_2477_ = _e2298;
                                                                                    } else {
                                                                                        phi_2477_ = _e2169;
                                                                                    }
                                                                                    let _e2304 = phi_2477_;
                                                                                    if (_e2304 > _e2301) {
                                                                                        phi_2482_ = _e2301;
                                                                                    } else {
                                                                                        phi_2482_ = _e2304;
                                                                                    }
                                                                                    let _e2307 = phi_2482_;
                                                                                    phi_2487_ = lt_bvh_triangle_Intersection(_e2307, (_e2010 / _e2069), (_e2031 / _e2069), (_e2298 <= _e2301));
                                                                                    phi_2488_ = false;
                                                                                } else {
                                                                                    phi_2487_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2488_ = true;
                                                                                }
                                                                                let _e2313 = phi_2487_;
                                                                                let _e2315 = phi_2488_;
                                                                                phi_2489_ = _e2313;
                                                                                phi_2490_ = _e2315;
                                                                            } else {
                                                                                phi_2489_ = lt_bvh_triangle_Intersection();
                                                                                phi_2490_ = true;
                                                                            }
                                                                            let _e2317 = phi_2489_;
                                                                            let _e2319 = phi_2490_;
                                                                            if _e2319 {
                                                                            }
                                                                            phi_2494_ = _e2317;
                                                                            phi_2495_ = _e2319;
                                                                        }
                                                                        let _e2321 = phi_2494_;
                                                                        let _e2323 = phi_2495_;
                                                                        phi_2496_ = _e2321;
                                                                        phi_2497_ = _e2072;
                                                                        phi_2498_ = _e2323;
                                                                    } else {
                                                                        phi_2496_ = lt_bvh_triangle_Intersection();
                                                                        phi_2497_ = true;
                                                                        phi_2498_ = false;
                                                                    }
                                                                    let _e2325 = phi_2496_;
                                                                    let _e2327 = phi_2497_;
                                                                    let _e2329 = phi_2498_;
                                                                    if _e2327 {
                                                                        phi_2502_ = true;
                                                                    } else {
                                                                        phi_2502_ = _e2329;
                                                                    }
                                                                    let _e2331 = phi_2502_;
                                                                    if _e2331 {
                                                                        phi_2506_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2506_ = _e2325;
                                                                    }
                                                                    let _e2333 = phi_2506_;
                                                                    if _e2333.is_hit {
                                                                        if (_e2333.t > 0f) {
                                                                            if (_e2333.t < _e117) {
                                                                                if true {
                                                                                    phi_2526_ = false;
                                                                                } else {
                                                                                    phi_2526_ = true;
                                                                                }
                                                                                let _e2342 = phi_2526_;
                                                                                phi_2527_ = true;
                                                                                phi_2528_ = _e2342;
                                                                            } else {
                                                                                phi_2527_ = _e1876;
                                                                                phi_2528_ = true;
                                                                            }
                                                                            let _e2344 = phi_2527_;
                                                                            let _e2346 = phi_2528_;
                                                                            phi_2529_ = _e2344;
                                                                            phi_2530_ = _e2346;
                                                                        } else {
                                                                            phi_2529_ = _e1876;
                                                                            phi_2530_ = true;
                                                                        }
                                                                        let _e2348 = phi_2529_;
                                                                        let _e2350 = phi_2530_;
                                                                        phi_2531_ = _e2348;
                                                                        phi_2532_ = _e2350;
                                                                    } else {
                                                                        phi_2531_ = _e1876;
                                                                        phi_2532_ = true;
                                                                    }
                                                                    let _e2352 = phi_2531_;
                                                                    let _e2354 = phi_2532_;
                                                                    if _e2354 {
                                                                    }
                                                                    phi_1936_ = (_e1874 & (_e1874 - 1u));
                                                                    phi_1939_ = _e2352;
                                                                    phi_2536_ = _e2354;
                                                                }
                                                                let _e2356 = phi_1936_;
                                                                let _e2358 = phi_1939_;
                                                                let _e2360 = phi_2536_;
                                                                continue;
                                                                continuing {
                                                                    phi_1935_ = _e2356;
                                                                    phi_1938_ = _e2358;
                                                                    break if !(_e2360);
                                                                }
                                                            }
                                                            let _e2363 = local_8;
                                                            if _e2363 {
                                                                let _e2365 = local.group_mask;
                                                                if ((_e2365 & 4278190080u) == 0u) {
                                                                    let _e2369 = local.len;
                                                                    if (_e2369 == 0u) {
                                                                        phi_2578_ = false;
                                                                    } else {
                                                                        let _e2373 = local.len;
                                                                        local.len = (_e2373 - 1u);
                                                                        let _e2376 = local.len;
                                                                        if (_e2376 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2381 = local.first[(0u + _e2376)];
                                                                        local.group = _e2381;
                                                                        let _e2384 = local.len;
                                                                        if (_e2384 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2389 = local.mask[(0u + _e2384)];
                                                                        local.group_mask = _e2389;
                                                                        phi_2578_ = true;
                                                                    }
                                                                    let _e2392 = phi_2578_;
                                                                    phi_2579_ = _e2392;
                                                                } else {
                                                                    phi_2579_ = true;
                                                                }
                                                                let _e2394 = phi_2579_;
                                                                if _e2394 {
                                                                    let _e2396 = local.group_mask;
                                                                    let _e2402 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2396)), 32u, (_e2396 == 0u)));
                                                                    let _e2406 = local.group_mask;
                                                                    let _e2420 = local.group_mask;
                                                                    local.group_mask = (_e2420 & ~((1u << bitcast<u32>((_e2402 & 31u)))));
                                                                    let _e2423 = local.group;
                                                                    phi_2610_ = (_e2423 + countOneBits(((_e2406 & ~((4294967295u << bitcast<u32>((((_e2402 - 24u) ^ _e1298) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2610_ = 4294967295u;
                                                                }
                                                                let _e2426 = phi_2610_;
                                                                phi_2611_ = _e2426;
                                                            } else {
                                                                phi_2611_ = u32();
                                                            }
                                                            let _e2428 = phi_2611_;
                                                            phi_1604_ = _e2428;
                                                            let _e2808 = local_12;
                                                            phi_1607_ = _e2808;
                                                            let _e2811 = local_13;
                                                            phi_2612_ = _e2811;
                                                            phi_2613_ = false;
                                                        } else {
                                                            phi_1604_ = u32();
                                                            phi_1607_ = bool();
                                                            phi_2612_ = false;
                                                            phi_2613_ = true;
                                                        }
                                                        let _e2430 = phi_1604_;
                                                        let _e2432 = phi_1607_;
                                                        let _e2434 = phi_2612_;
                                                        let _e2436 = phi_2613_;
                                                        local_9 = _e2436;
                                                        continue;
                                                        continuing {
                                                            phi_1603_ = _e2430;
                                                            phi_1606_ = _e2432;
                                                            break if !(_e2434);
                                                        }
                                                    }
                                                    let _e2439 = local_9;
                                                    if _e2439 {
                                                        phi_2617_ = false;
                                                    } else {
                                                        phi_2617_ = true;
                                                    }
                                                    let _e2441 = phi_2617_;
                                                    if _e2441 {
                                                        phi_2621_ = true;
                                                    } else {
                                                        let _e2817 = local_14;
                                                        phi_2621_ = _e2817;
                                                    }
                                                    let _e2443 = phi_2621_;
                                                    phi_2622_ = _e2443;
                                                }
                                                let _e2445 = phi_2622_;
                                                phi_2623_ = _e2445;
                                                phi_2624_ = _e1124;
                                            } else {
                                                phi_2623_ = bool();
                                                phi_2624_ = true;
                                            }
                                            let _e2447 = phi_2623_;
                                            let _e2449 = phi_2624_;
                                            if _e2449 {
                                                phi_2628_ = _e911;
                                            } else {
                                                phi_2628_ = _e2447;
                                            }
                                            let _e2451 = phi_2628_;
                                            if _e2451 {
                                                phi_2632_ = false;
                                            } else {
                                                phi_2632_ = true;
                                            }
                                            let _e2453 = phi_2632_;
                                            phi_2633_ = _e2451;
                                            phi_2634_ = _e2453;
                                        } else {
                                            phi_2633_ = _e911;
                                            phi_2634_ = true;
                                        }
                                        let _e2455 = phi_2633_;
                                        let _e2457 = phi_2634_;
                                        phi_2635_ = _e2455;
                                        phi_2636_ = _e2457;
                                    } else {
                                        phi_2635_ = _e911;
                                        phi_2636_ = true;
                                    }
                                    let _e2459 = phi_2635_;
                                    let _e2461 = phi_2636_;
                                    phi_2637_ = _e2459;
                                    phi_2638_ = _e2461;
                                } else {
                                    phi_2637_ = _e911;
                                    phi_2638_ = true;
                                }
                                let _e2463 = phi_2637_;
                                let _e2465 = phi_2638_;
                                if _e2465 {
                                }
                                phi_996_ = (_e909 & (_e909 - 1u));
                                phi_999_ = _e2463;
                                phi_2642_ = _e2465;
                            }
                            let _e2467 = phi_996_;
                            let _e2469 = phi_999_;
                            let _e2471 = phi_2642_;
                            continue;
                            continuing {
                                phi_995_ = _e2467;
                                phi_998_ = _e2469;
                                break if !(_e2471);
                            }
                        }
                        let _e2474 = local_10;
                        if _e2474 {
                            let _e2476 = local_1.group_mask;
                            if ((_e2476 & 4278190080u) == 0u) {
                                let _e2480 = local_1.len;
                                if (_e2480 == 0u) {
                                    phi_2684_ = false;
                                } else {
                                    let _e2484 = local_1.len;
                                    local_1.len = (_e2484 - 1u);
                                    let _e2487 = local_1.len;
                                    if (_e2487 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2492 = local_1.first[(0u + _e2487)];
                                    local_1.group = _e2492;
                                    let _e2495 = local_1.len;
                                    if (_e2495 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2500 = local_1.mask[(0u + _e2495)];
                                    local_1.group_mask = _e2500;
                                    phi_2684_ = true;
                                }
                                let _e2503 = phi_2684_;
                                phi_2685_ = _e2503;
                            } else {
                                phi_2685_ = true;
                            }
                            let _e2505 = phi_2685_;
                            if _e2505 {
                                let _e2507 = local_1.group_mask;
                                let _e2513 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2507)), 32u, (_e2507 == 0u)));
                                let _e2517 = local_1.group_mask;
                                let _e2531 = local_1.group_mask;
                                local_1.group_mask = (_e2531 & ~((1u << bitcast<u32>((_e2513 & 31u)))));
                                let _e2534 = local_1.group;
                                phi_2716_ = (_e2534 + countOneBits(((_e2517 & ~((4294967295u << bitcast<u32>((((_e2513 - 24u) ^ _e333) & 31u))))) & 255u)));
                            } else {
                                phi_2716_ = 4294967295u;
                            }
                            let _e2537 = phi_2716_;
                            phi_2717_ = _e2537;
                        } else {
                            phi_2717_ = u32();
                        }
                        let _e2539 = phi_2717_;
                        phi_664_ = _e2539;
                        let _e2840 = local_15;
                        phi_667_ = _e2840;
                        let _e2843 = local_16;
                        phi_2718_ = _e2843;
                        phi_2719_ = false;
                    } else {
                        phi_664_ = u32();
                        phi_667_ = bool();
                        phi_2718_ = false;
                        phi_2719_ = true;
                    }
                    let _e2541 = phi_664_;
                    let _e2543 = phi_667_;
                    let _e2545 = phi_2718_;
                    let _e2547 = phi_2719_;
                    local_11 = _e2547;
                    continue;
                    continuing {
                        phi_663_ = _e2541;
                        phi_666_ = _e2543;
                        break if !(_e2545);
                    }
                }
                let _e2550 = local_11;
                if _e2550 {
                    phi_2723_ = false;
                } else {
                    phi_2723_ = true;
                }
                let _e2552 = phi_2723_;
                if _e2552 {
                }
                phi_2727_ = _e2552;
            }
            let _e2554 = phi_2727_;
            phi_2728_ = _e189;
            phi_2729_ = _e2554;
        } else {
            phi_2728_ = true;
            phi_2729_ = false;
        }
        let _e2556 = phi_2728_;
        let _e2558 = phi_2729_;
        if _e2556 {
            phi_2733_ = false;
            phi_2734_ = true;
        } else {
            phi_2733_ = true;
            phi_2734_ = _e2558;
        }
        let _e2560 = phi_2733_;
        let _e2562 = phi_2734_;
        if _e2562 {
            phi_2738_ = _e2560;
        } else {
            phi_2738_ = false;
        }
        let _e2564 = phi_2738_;
        if _e2564 {
            phi_2742_ = 0f;
        } else {
            phi_2742_ = 1f;
        }
        let _e2566 = phi_2742_;
        if (_e85 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e85)] = _e2566;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
