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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_50 {
    member: array<lt_bvh_Instance>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_20;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> nodes: type_38;
@group(0) @binding(3) 
var<storage> triangles: type_42;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage, read_write> bits: type_9;
@group(0) @binding(7) 
var<storage> instances: type_50;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_174_: bool;
    var phi_178_: f32;

    if (param != param) {
        phi_174_ = true;
    } else {
        let _e58 = (param_1 >= param);
        if _e58 {
        }
        phi_174_ = _e58;
    }
    let _e60 = phi_174_;
    if _e60 {
        phi_178_ = param_1;
    } else {
        phi_178_ = param;
    }
    let _e62 = phi_178_;
    return _e62;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_190_: bool;
    var phi_194_: f32;

    if (param_2 != param_2) {
        phi_190_ = true;
    } else {
        let _e58 = (param_3 <= param_2);
        if _e58 {
        }
        phi_190_ = _e58;
    }
    let _e60 = phi_190_;
    if _e60 {
        phi_194_ = param_3;
    } else {
        phi_194_ = param_2;
    }
    let _e62 = phi_194_;
    return _e62;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_280_: f32;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_319_: bool;
    var phi_332_: bool;
    var phi_333_: bool;
    var phi_334_: bool;
    var phi_335_: bool;
    var phi_339_: bool;
    var phi_352_: bool;
    var phi_353_: bool;
    var phi_354_: bool;
    var phi_358_: bool;
    var phi_359_: bool;
    var phi_360_: bool;
    var phi_361_: bool;
    var phi_362_: bool;
    var phi_366_: bool;
    var phi_436_: f32;
    var phi_443_: f32;
    var phi_450_: f32;
    var phi_457_: f32;
    var phi_464_: f32;
    var phi_471_: f32;
    var phi_488_: f32;
    var phi_493_: f32;
    var phi_498_: f32;
    var phi_503_: f32;
    var phi_508_: f32;
    var phi_527_: u32;
    var phi_532_: u32;
    var phi_537_: u32;
    var phi_651_: bool;
    var phi_652_: bool;
    var phi_683_: u32;
    var phi_685_: u32;
    var phi_688_: bool;
    var phi_768_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_795_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_822_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_828_: u32;
    var phi_831_: u32;
    var phi_845_: u32;
    var phi_855_: u32;
    var phi_865_: u32;
    var phi_883_: u32;
    var phi_893_: u32;
    var phi_903_: u32;
    var phi_939_: u32;
    var phi_952_: u32;
    var phi_957_: u32;
    var phi_958_: u32;
    var phi_959_: u32;
    var phi_829_: u32;
    var phi_832_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1017_: u32;
    var phi_1020_: bool;
    var phi_1069_: f32;
    var phi_1074_: f32;
    var phi_1079_: f32;
    var phi_1087_: f32;
    var phi_1092_: f32;
    var phi_1097_: f32;
    var phi_1217_: bool;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1224_: bool;
    var phi_1237_: bool;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1244_: bool;
    var phi_1257_: bool;
    var phi_1258_: bool;
    var phi_1259_: bool;
    var phi_1263_: bool;
    var phi_1264_: bool;
    var phi_1265_: bool;
    var phi_1266_: bool;
    var phi_1267_: bool;
    var phi_1271_: bool;
    var phi_1341_: f32;
    var phi_1348_: f32;
    var phi_1355_: f32;
    var phi_1362_: f32;
    var phi_1369_: f32;
    var phi_1376_: f32;
    var phi_1393_: f32;
    var phi_1398_: f32;
    var phi_1403_: f32;
    var phi_1408_: f32;
    var phi_1413_: f32;
    var phi_1439_: bool;
    var phi_1440_: bool;
    var phi_1448_: u32;
    var phi_1449_: u32;
    var phi_1460_: vec3<f32>;
    var phi_1461_: vec3<f32>;
    var phi_1474_: u32;
    var phi_1479_: u32;
    var phi_1484_: u32;
    var phi_1598_: bool;
    var phi_1599_: bool;
    var phi_1630_: u32;
    var phi_1632_: u32;
    var phi_1635_: bool;
    var phi_1715_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1742_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1769_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1775_: u32;
    var phi_1778_: u32;
    var phi_1792_: u32;
    var phi_1802_: u32;
    var phi_1812_: u32;
    var phi_1830_: u32;
    var phi_1840_: u32;
    var phi_1850_: u32;
    var phi_1886_: u32;
    var phi_1899_: u32;
    var phi_1904_: u32;
    var phi_1905_: u32;
    var phi_1906_: u32;
    var phi_1776_: u32;
    var phi_1779_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1964_: u32;
    var phi_1967_: bool;
    var phi_2011_: vec3<f32>;
    var phi_2012_: vec3<f32>;
    var phi_2041_: vec3<f32>;
    var phi_2042_: vec3<f32>;
    var phi_2071_: vec3<f32>;
    var phi_2072_: vec3<f32>;
    var phi_2090_: bool;
    var phi_2091_: bool;
    var phi_2095_: f32;
    var phi_2096_: f32;
    var phi_2097_: f32;
    var phi_2098_: f32;
    var phi_2106_: f32;
    var phi_2116_: bool;
    var phi_2117_: bool;
    var phi_2121_: f32;
    var phi_2122_: f32;
    var phi_2123_: f32;
    var phi_2124_: f32;
    var phi_2132_: f32;
    var phi_2142_: bool;
    var phi_2143_: bool;
    var phi_2147_: f32;
    var phi_2148_: f32;
    var phi_2149_: f32;
    var phi_2150_: f32;
    var phi_2158_: f32;
    var phi_2173_: f32;
    var phi_2174_: bool;
    var phi_2175_: f32;
    var phi_2176_: bool;
    var phi_2177_: f32;
    var phi_2178_: bool;
    var phi_2196_: f32;
    var phi_2197_: bool;
    var phi_2198_: bool;
    var phi_2199_: f32;
    var phi_2200_: bool;
    var phi_2201_: bool;
    var phi_2205_: bool;
    var phi_2206_: f32;
    var phi_2207_: bool;
    var phi_2235_: vec3<f32>;
    var phi_2236_: vec3<f32>;
    var phi_2261_: vec3<f32>;
    var phi_2262_: vec3<f32>;
    var phi_2287_: vec3<f32>;
    var phi_2288_: vec3<f32>;
    var phi_2344_: f32;
    var phi_2353_: f32;
    var phi_2362_: f32;
    var phi_2371_: f32;
    var phi_2378_: f32;
    var phi_2385_: f32;
    var phi_2398_: f32;
    var phi_2407_: f32;
    var phi_2416_: f32;
    var phi_2425_: f32;
    var phi_2432_: f32;
    var phi_2439_: f32;
    var phi_2456_: f32;
    var phi_2461_: f32;
    var phi_2466_: f32;
    var phi_2474_: f32;
    var phi_2479_: f32;
    var phi_2484_: f32;
    var phi_2496_: f32;
    var phi_2501_: f32;
    var phi_2506_: f32;
    var phi_2511_: f32;
    var phi_2516_: lt_bvh_triangle_Intersection;
    var phi_2517_: bool;
    var phi_2518_: lt_bvh_triangle_Intersection;
    var phi_2519_: bool;
    var phi_2523_: lt_bvh_triangle_Intersection;
    var phi_2524_: bool;
    var phi_2525_: lt_bvh_triangle_Intersection;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2531_: bool;
    var phi_2535_: lt_bvh_triangle_Intersection;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_2558_: bool;
    var phi_2559_: bool;
    var phi_2560_: bool;
    var phi_2561_: bool;
    var phi_1965_: u32;
    var phi_1968_: bool;
    var phi_2565_: bool;
    var local_8: bool;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2639_: u32;
    var phi_2640_: u32;
    var phi_1633_: u32;
    var phi_1636_: bool;
    var phi_2641_: bool;
    var phi_2642_: bool;
    var local_9: bool;
    var phi_2646_: bool;
    var phi_2650_: bool;
    var phi_2651_: bool;
    var phi_2652_: bool;
    var phi_2653_: bool;
    var phi_2657_: bool;
    var phi_2661_: bool;
    var phi_2662_: bool;
    var phi_2663_: bool;
    var phi_2664_: bool;
    var phi_2665_: bool;
    var phi_2666_: bool;
    var phi_2667_: bool;
    var phi_1018_: u32;
    var phi_1021_: bool;
    var phi_2671_: bool;
    var local_10: bool;
    var phi_2713_: bool;
    var phi_2714_: bool;
    var phi_2745_: u32;
    var phi_2746_: u32;
    var phi_686_: u32;
    var phi_689_: bool;
    var phi_2747_: bool;
    var phi_2748_: bool;
    var local_11: bool;
    var phi_2752_: bool;
    var phi_2756_: bool;
    var phi_2757_: bool;
    var phi_2758_: bool;
    var phi_2762_: bool;
    var phi_2763_: bool;
    var phi_2767_: bool;
    var phi_2771_: f32;
    var phi_2812_: u32;
    var phi_2831_: u32;
    var phi_2839_: u32;
    var phi_2847_: u32;
    var phi_2852_: u32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;

    let _e57 = id_1;
    let _e64 = arrayLength((&nodes.member));
    let _e70 = arrayLength((&visibility.member));
    let _e73 = arrayLength((&list.member));
    let _e76 = arrayLength((&bits.member));
    let _e83 = ((_e57.y * 2097152u) + _e57.x);
    if (3u < _e73) {
    } else {
        return;
    }
    let _e86 = list.member[3u];
    if (_e83 < _e86) {
        let _e88 = (_e83 + 4u);
        if (_e88 < _e73) {
        } else {
            return;
        }
        let _e92 = list.member[(0u + _e88)];
        let _e93 = (_e92 & 2147483647u);
        let _e95 = p.member.root;
        if (_e93 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e101 = samples.member[(0u + _e93)].position;
        let _e103 = samples.member[(0u + _e93)].normal;
        let _e105 = samples.member[(0u + _e93)].magnitude;
        let _e107 = ((8f / 8388608f) * _e105);
        let _e115 = (_e101.x + (_e103.x * _e107));
        let _e117 = (_e101.y + (_e103.y * _e107));
        let _e119 = (_e101.z + (_e103.z * _e107));
        let _e121 = p.member.light.place;
        if (_e121.w == 0f) {
            phi_280_ = 300000000000000000000000000000000000000f;
        } else {
            phi_280_ = 1f;
        }
        let _e125 = phi_280_;
        let _e133 = (_e121.x - (_e115 * _e121.w));
        let _e134 = (_e121.y - (_e117 * _e121.w));
        let _e135 = (_e121.z - (_e119 * _e121.w));
        let _e136 = abs(_e133);
        let _e137 = abs(_e134);
        let _e138 = abs(_e135);
        if (abs(_e115) < 1000000000000000f) {
            if (abs(_e117) < 1000000000000000f) {
                phi_312_ = (abs(_e119) < 1000000000000000f);
                phi_313_ = false;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
            }
            let _e146 = phi_312_;
            let _e148 = phi_313_;
            phi_314_ = _e146;
            phi_315_ = _e148;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
        }
        let _e150 = phi_314_;
        let _e152 = phi_315_;
        if _e152 {
            phi_319_ = false;
        } else {
            phi_319_ = _e150;
        }
        let _e154 = phi_319_;
        if _e154 {
            if (_e136 < 1000000000000000f) {
                if (_e137 < 1000000000000000f) {
                    phi_332_ = (_e138 < 1000000000000000f);
                    phi_333_ = false;
                } else {
                    phi_332_ = bool();
                    phi_333_ = true;
                }
                let _e159 = phi_332_;
                let _e161 = phi_333_;
                phi_334_ = _e159;
                phi_335_ = _e161;
            } else {
                phi_334_ = bool();
                phi_335_ = true;
            }
            let _e163 = phi_334_;
            let _e165 = phi_335_;
            if _e165 {
                phi_339_ = false;
            } else {
                phi_339_ = _e163;
            }
            let _e167 = phi_339_;
            if _e167 {
                if (_e136 > 0f) {
                    phi_353_ = bool();
                    phi_354_ = true;
                } else {
                    let _e169 = (_e137 > 0f);
                    if _e169 {
                        phi_352_ = bool();
                    } else {
                        phi_352_ = (_e138 > 0f);
                    }
                    let _e172 = phi_352_;
                    phi_353_ = _e172;
                    phi_354_ = _e169;
                }
                let _e174 = phi_353_;
                let _e176 = phi_354_;
                if _e176 {
                    phi_358_ = true;
                } else {
                    phi_358_ = _e174;
                }
                let _e178 = phi_358_;
                phi_359_ = _e178;
                phi_360_ = false;
            } else {
                phi_359_ = bool();
                phi_360_ = true;
            }
            let _e180 = phi_359_;
            let _e182 = phi_360_;
            phi_361_ = _e180;
            phi_362_ = _e182;
        } else {
            phi_361_ = bool();
            phi_362_ = true;
        }
        let _e184 = phi_361_;
        let _e186 = phi_362_;
        if _e186 {
            phi_366_ = false;
        } else {
            phi_366_ = _e184;
        }
        let _e188 = phi_366_;
        if _e188 {
            let _e189 = (_e95 >= _e64);
            if _e189 {
                phi_2756_ = false;
            } else {
                if (_e95 < _e64) {
                } else {
                    return;
                }
                let _e195 = nodes.member[(0u + _e95)].frame[0u];
                let _e199 = nodes.member[(0u + _e95)].frame[1u];
                let _e203 = nodes.member[(0u + _e95)].frame[2u];
                let _e207 = nodes.member[(0u + _e95)].frame[0u];
                let _e211 = nodes.member[(0u + _e95)].frame[1u];
                let _e215 = nodes.member[(0u + _e95)].frame[2u];
                let _e219 = nodes.member[(0u + _e95)].frame[3u];
                let _e253 = core_intrinsics_maximum_number_nsz_f32_(abs(_e133), abs(_e134));
                let _e254 = core_intrinsics_maximum_number_nsz_f32_(_e253, abs(_e135));
                let _e255 = (_e254 * 0.0000000000009094947f);
                if (abs(_e133) < _e255) {
                    phi_436_ = _e255;
                } else {
                    phi_436_ = abs(_e133);
                }
                let _e260 = phi_436_;
                if (_e133 < 0f) {
                    phi_443_ = (-1f / _e260);
                } else {
                    phi_443_ = (1f / _e260);
                }
                let _e265 = phi_443_;
                if (abs(_e134) < _e255) {
                    phi_450_ = _e255;
                } else {
                    phi_450_ = abs(_e134);
                }
                let _e270 = phi_450_;
                if (_e134 < 0f) {
                    phi_457_ = (-1f / _e270);
                } else {
                    phi_457_ = (1f / _e270);
                }
                let _e275 = phi_457_;
                if (abs(_e135) < _e255) {
                    phi_464_ = _e255;
                } else {
                    phi_464_ = abs(_e135);
                }
                let _e280 = phi_464_;
                if (_e135 < 0f) {
                    phi_471_ = (-1f / _e280);
                } else {
                    phi_471_ = (1f / _e280);
                }
                let _e285 = phi_471_;
                let _e289 = abs((bitcast<f32>(_e195) - _e115));
                let _e290 = abs((bitcast<f32>(_e199) - _e117));
                let _e291 = abs((bitcast<f32>(_e203) - _e119));
                let _e295 = abs(((bitcast<f32>(_e207) + (bitcast<f32>((((_e219 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e115));
                let _e296 = abs(((bitcast<f32>(_e211) + (bitcast<f32>((((_e219 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e117));
                let _e297 = abs(((bitcast<f32>(_e215) + (bitcast<f32>((((_e219 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e119));
                if (_e289 > _e295) {
                    phi_488_ = _e289;
                } else {
                    phi_488_ = _e295;
                }
                let _e300 = phi_488_;
                if (_e290 > _e296) {
                    phi_493_ = _e290;
                } else {
                    phi_493_ = _e296;
                }
                let _e303 = phi_493_;
                if (_e291 > _e297) {
                    phi_498_ = _e291;
                } else {
                    phi_498_ = _e297;
                }
                let _e306 = phi_498_;
                if (_e300 > _e303) {
                    phi_503_ = _e300;
                } else {
                    phi_503_ = _e303;
                }
                let _e309 = phi_503_;
                if (_e309 > _e306) {
                    phi_508_ = _e309;
                } else {
                    phi_508_ = _e306;
                }
                let _e312 = phi_508_;
                let _e316 = (_e312 * 0.0000019073486f);
                let _e317 = (abs(_e265) * _e316);
                let _e318 = (abs(_e275) * _e316);
                let _e319 = (abs(_e285) * _e316);
                let _e323 = (_e312 * 0.0000009536743f);
                let _e324 = (abs(_e265) * _e323);
                let _e325 = (abs(_e275) * _e323);
                let _e326 = (abs(_e285) * _e323);
                if (_e265 < 0f) {
                    phi_527_ = 0u;
                } else {
                    phi_527_ = 1u;
                }
                let _e329 = phi_527_;
                if (_e275 < 0f) {
                    phi_532_ = 0u;
                } else {
                    phi_532_ = 2u;
                }
                let _e332 = phi_532_;
                if (_e285 < 0f) {
                    phi_537_ = 0u;
                } else {
                    phi_537_ = 4u;
                }
                let _e335 = phi_537_;
                let _e337 = ((_e329 | _e332) | _e335);
                let _e338 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e95, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e338.first[0], _e338.first[1], _e338.first[2], _e338.first[3], _e338.first[4], _e338.first[5], _e338.first[6], _e338.first[7], _e338.first[8], _e338.first[9], _e338.first[10], _e338.first[11], _e338.first[12], _e338.first[13], _e338.first[14], _e338.first[15], _e338.first[16], _e338.first[17], _e338.first[18], _e338.first[19], _e338.first[20], _e338.first[21], _e338.first[22], _e338.first[23], _e338.first[24], _e338.first[25], _e338.first[26], _e338.first[27], _e338.first[28], _e338.first[29], _e338.first[30], _e338.first[31]), array<u32, 32>(_e338.mask[0], _e338.mask[1], _e338.mask[2], _e338.mask[3], _e338.mask[4], _e338.mask[5], _e338.mask[6], _e338.mask[7], _e338.mask[8], _e338.mask[9], _e338.mask[10], _e338.mask[11], _e338.mask[12], _e338.mask[13], _e338.mask[14], _e338.mask[15], _e338.mask[16], _e338.mask[17], _e338.mask[18], _e338.mask[19], _e338.mask[20], _e338.mask[21], _e338.mask[22], _e338.mask[23], _e338.mask[24], _e338.mask[25], _e338.mask[26], _e338.mask[27], _e338.mask[28], _e338.mask[29], _e338.mask[30], _e338.mask[31]), _e338.len, _e338.group, _e338.group_mask);
                let _e412 = local_1.group_mask;
                if ((_e412 & 4278190080u) == 0u) {
                    let _e416 = local_1.len;
                    if (_e416 == 0u) {
                        phi_651_ = false;
                    } else {
                        let _e420 = local_1.len;
                        local_1.len = (_e420 - 1u);
                        let _e423 = local_1.len;
                        if (_e423 < 32u) {
                        } else {
                            return;
                        }
                        let _e428 = local_1.first[(0u + _e423)];
                        local_1.group = _e428;
                        let _e431 = local_1.len;
                        if (_e431 < 32u) {
                        } else {
                            return;
                        }
                        let _e436 = local_1.mask[(0u + _e431)];
                        local_1.group_mask = _e436;
                        phi_651_ = true;
                    }
                    let _e439 = phi_651_;
                    phi_652_ = _e439;
                } else {
                    phi_652_ = true;
                }
                let _e441 = phi_652_;
                if _e441 {
                    let _e443 = local_1.group_mask;
                    let _e449 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e443)), 32u, (_e443 == 0u)));
                    let _e453 = local_1.group_mask;
                    let _e467 = local_1.group_mask;
                    local_1.group_mask = (_e467 & ~((1u << bitcast<u32>((_e449 & 31u)))));
                    let _e470 = local_1.group;
                    phi_683_ = (_e470 + countOneBits(((_e453 & ~((4294967295u << bitcast<u32>((((_e449 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_683_ = 4294967295u;
                }
                let _e473 = phi_683_;
                phi_685_ = _e473;
                phi_688_ = false;
                loop {
                    let _e475 = phi_685_;
                    let _e477 = phi_688_;
                    if (_e475 != 4294967295u) {
                        if (_e475 < _e64) {
                        } else {
                            return;
                        }
                        let _e484 = nodes.member[(0u + _e475)].frame[3u];
                        let _e509 = (bitcast<f32>((((_e484 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e265);
                        let _e510 = (bitcast<f32>((((_e484 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e275);
                        let _e511 = (bitcast<f32>((((_e484 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e285);
                        let _e514 = nodes.member[(0u + _e475)].frame[0u];
                        let _e518 = nodes.member[(0u + _e475)].frame[1u];
                        let _e522 = nodes.member[(0u + _e475)].frame[2u];
                        let _e527 = ((bitcast<f32>(_e514) - _e115) * _e265);
                        let _e528 = ((bitcast<f32>(_e518) - _e117) * _e275);
                        let _e529 = ((bitcast<f32>(_e522) - _e119) * _e285);
                        let _e537 = nodes.member[(0u + _e475)].x;
                        if (_e265 < 0f) {
                            let _e548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e537.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e554 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e548.unnamed.root, _e537.w), _e548.unnamed_1);
                            let _e560 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e554.unnamed, lt_bvh_traverse_Tree(_e537.x, _e554.unnamed_1.first_primitive));
                            phi_768_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e560.unnamed, lt_bvh_traverse_Tree(_e560.unnamed_1.root, _e537.y));
                        } else {
                            let _e576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e537.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e576.unnamed.root, _e537.y), _e576.unnamed_1);
                            let _e588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e582.unnamed, lt_bvh_traverse_Tree(_e537.z, _e582.unnamed_1.first_primitive));
                            phi_768_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e588.unnamed, lt_bvh_traverse_Tree(_e588.unnamed_1.root, _e537.w));
                        }
                        let _e596 = phi_768_;
                        let _e606 = nodes.member[(0u + _e475)].y;
                        if (_e275 < 0f) {
                            let _e617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e617.unnamed.root, _e606.w), _e617.unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e623.unnamed, lt_bvh_traverse_Tree(_e606.x, _e623.unnamed_1.first_primitive));
                            phi_795_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_bvh_traverse_Tree(_e629.unnamed_1.root, _e606.y));
                        } else {
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e606.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e645.unnamed.root, _e606.y), _e645.unnamed_1);
                            let _e657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e606.z, _e651.unnamed_1.first_primitive));
                            phi_795_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e657.unnamed, lt_bvh_traverse_Tree(_e657.unnamed_1.root, _e606.w));
                        }
                        let _e665 = phi_795_;
                        let _e675 = nodes.member[(0u + _e475)].z;
                        if (_e285 < 0f) {
                            let _e686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e686.unnamed.root, _e675.w), _e686.unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e692.unnamed, lt_bvh_traverse_Tree(_e675.x, _e692.unnamed_1.first_primitive));
                            phi_822_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_bvh_traverse_Tree(_e698.unnamed_1.root, _e675.y));
                        } else {
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e675.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e714.unnamed.root, _e675.y), _e714.unnamed_1);
                            let _e726 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e675.z, _e720.unnamed_1.first_primitive));
                            phi_822_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e726.unnamed, lt_bvh_traverse_Tree(_e726.unnamed_1.root, _e675.w));
                        }
                        let _e734 = phi_822_;
                        phi_828_ = 0u;
                        phi_831_ = 0u;
                        loop {
                            let _e744 = phi_828_;
                            let _e746 = phi_831_;
                            local_2 = _e746;
                            local_3 = _e746;
                            local_4 = _e746;
                            let _e747 = (_e744 < 8u);
                            if _e747 {
                                let _e749 = (_e744 >> bitcast<u32>(2i));
                                let _e750 = (_e744 & 3u);
                                if (_e749 == 0u) {
                                    phi_845_ = _e596.unnamed.root;
                                } else {
                                    phi_845_ = _e596.unnamed.first_primitive;
                                }
                                let _e753 = phi_845_;
                                if (_e749 == 0u) {
                                    phi_855_ = _e665.unnamed.root;
                                } else {
                                    phi_855_ = _e665.unnamed.first_primitive;
                                }
                                let _e762 = phi_855_;
                                if (_e749 == 0u) {
                                    phi_865_ = _e734.unnamed.root;
                                } else {
                                    phi_865_ = _e734.unnamed.first_primitive;
                                }
                                let _e771 = phi_865_;
                                let _e784 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e753 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e509) + (_e527 - _e317)), ((f32(((_e762 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e510) + (_e528 - _e318)));
                                let _e785 = core_intrinsics_maximum_number_nsz_f32_(_e784, ((f32(((_e771 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e511) + (_e529 - _e319)));
                                if (_e749 == 0u) {
                                    phi_883_ = _e596.unnamed_1.root;
                                } else {
                                    phi_883_ = _e596.unnamed_1.first_primitive;
                                }
                                let _e788 = phi_883_;
                                if (_e749 == 0u) {
                                    phi_893_ = _e665.unnamed_1.root;
                                } else {
                                    phi_893_ = _e665.unnamed_1.first_primitive;
                                }
                                let _e797 = phi_893_;
                                if (_e749 == 0u) {
                                    phi_903_ = _e734.unnamed_1.root;
                                } else {
                                    phi_903_ = _e734.unnamed_1.first_primitive;
                                }
                                let _e806 = phi_903_;
                                let _e819 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e788 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e509) + (_e527 + _e317)), ((f32(((_e797 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e510) + (_e528 + _e318)));
                                let _e820 = core_intrinsics_minimum_number_nsz_f32_(_e819, ((f32(((_e806 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u)) * _e511) + (_e529 + _e319)));
                                if (_e785 <= _e820) {
                                    if (_e785 <= _e125) {
                                        if (_e820 >= 0f) {
                                            if (_e749 == 0u) {
                                                let _e827 = nodes.member[(0u + _e475)].links[2u];
                                                phi_939_ = _e827;
                                            } else {
                                                let _e830 = nodes.member[(0u + _e475)].links[3u];
                                                phi_939_ = _e830;
                                            }
                                            let _e832 = phi_939_;
                                            let _e837 = ((_e832 >> bitcast<u32>(((_e750 * 8u) & 31u))) & 255u);
                                            let _e838 = (_e837 & 31u);
                                            if (_e838 >= 24u) {
                                                phi_952_ = (24u + ((_e838 - 24u) ^ _e337));
                                            } else {
                                                phi_952_ = _e838;
                                            }
                                            let _e844 = phi_952_;
                                            phi_957_ = (_e746 | ((_e837 >> bitcast<u32>(5i)) << bitcast<u32>((_e844 & 31u))));
                                        } else {
                                            phi_957_ = _e746;
                                        }
                                        let _e852 = phi_957_;
                                        phi_958_ = _e852;
                                    } else {
                                        phi_958_ = _e746;
                                    }
                                    let _e854 = phi_958_;
                                    phi_959_ = _e854;
                                } else {
                                    phi_959_ = _e746;
                                }
                                let _e856 = phi_959_;
                                phi_829_ = (_e744 + 1u);
                                phi_832_ = _e856;
                            } else {
                                phi_829_ = u32();
                                phi_832_ = u32();
                            }
                            let _e859 = phi_829_;
                            let _e861 = phi_832_;
                            continue;
                            continuing {
                                phi_828_ = _e859;
                                phi_831_ = _e861;
                                break if !(_e747);
                            }
                        }
                        let _e865 = nodes.member[(0u + _e475)].links[0u];
                        let _e869 = nodes.member[(0u + _e475)].frame[3u];
                        let _e873 = local_2;
                        if ((_e873 & 4278190080u) == 0u) {
                        } else {
                            let _e877 = local_1.group_mask;
                            if ((_e877 & 4278190080u) == 0u) {
                            } else {
                                let _e881 = local_1.len;
                                if (_e881 < 32u) {
                                    let _e884 = local_1.group;
                                    let _e886 = local_1.len;
                                    if (_e886 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e886)] = _e884;
                                    let _e892 = local_1.group_mask;
                                    let _e894 = local_1.len;
                                    if (_e894 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e894)] = _e892;
                                    let _e901 = local_1.len;
                                    local_1.len = (_e901 + 1u);
                                }
                            }
                            local_1.group = (_e95 + _e865);
                            let _e905 = local_3;
                            local_1.group_mask = ((_e905 & 4278190080u) | (_e869 >> bitcast<u32>(24i)));
                        }
                        let _e910 = local_4;
                        phi_1017_ = (_e910 & 16777215u);
                        phi_1020_ = _e477;
                        loop {
                            let _e913 = phi_1017_;
                            let _e915 = phi_1020_;
                            local_15 = _e915;
                            let _e916 = (_e913 == 0u);
                            local_10 = _e916;
                            local_16 = _e916;
                            if _e916 {
                                phi_1018_ = u32();
                                phi_1021_ = bool();
                                phi_2671_ = false;
                            } else {
                                let _e919 = nodes.member[(0u + _e475)].links[1u];
                                let _e923 = (_e919 + select(firstTrailingBit(_e913), 32u, (_e913 == 0u)));
                                if (_e923 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e930 = instances.member[(0u + _e923)].low_world;
                                let _e932 = instances.member[(0u + _e923)].high_world;
                                let _e939 = ((_e930.x - _e115) * _e265);
                                let _e940 = ((_e930.y - _e117) * _e275);
                                let _e941 = ((_e930.z - _e119) * _e285);
                                let _e948 = ((_e932.x - _e115) * _e265);
                                let _e949 = ((_e932.y - _e117) * _e275);
                                let _e950 = ((_e932.z - _e119) * _e285);
                                if (_e939 < _e948) {
                                    phi_1069_ = _e939;
                                } else {
                                    phi_1069_ = _e948;
                                }
                                let _e953 = phi_1069_;
                                if (_e940 < _e949) {
                                    phi_1074_ = _e940;
                                } else {
                                    phi_1074_ = _e949;
                                }
                                let _e956 = phi_1074_;
                                if (_e941 < _e950) {
                                    phi_1079_ = _e941;
                                } else {
                                    phi_1079_ = _e950;
                                }
                                let _e959 = phi_1079_;
                                if (_e939 > _e948) {
                                    phi_1087_ = _e939;
                                } else {
                                    phi_1087_ = _e948;
                                }
                                let _e965 = phi_1087_;
                                if (_e940 > _e949) {
                                    phi_1092_ = _e940;
                                } else {
                                    phi_1092_ = _e949;
                                }
                                let _e968 = phi_1092_;
                                if (_e941 > _e950) {
                                    phi_1097_ = _e941;
                                } else {
                                    phi_1097_ = _e950;
                                }
                                let _e971 = phi_1097_;
                                let _e975 = core_intrinsics_maximum_number_nsz_f32_((_e953 - _e324), (_e956 - _e325));
                                let _e976 = core_intrinsics_maximum_number_nsz_f32_(_e975, (_e959 - _e326));
                                let _e977 = core_intrinsics_minimum_number_nsz_f32_((_e965 + _e324), (_e968 + _e325));
                                let _e978 = core_intrinsics_minimum_number_nsz_f32_(_e977, (_e971 + _e326));
                                if (_e976 <= _e978) {
                                    if (_e976 <= _e125) {
                                        if (_e978 >= 0f) {
                                            let _e984 = instances.member[(0u + _e923)].world_to_object[0u];
                                            let _e995 = ((((_e984.x * _e115) + (_e984.y * _e117)) + (_e984.z * _e119)) + (_e984.w * 1f));
                                            let _e997 = instances.member[(0u + _e923)].world_to_object[1u];
                                            let _e1008 = ((((_e997.x * _e115) + (_e997.y * _e117)) + (_e997.z * _e119)) + (_e997.w * 1f));
                                            let _e1010 = instances.member[(0u + _e923)].world_to_object[2u];
                                            let _e1021 = ((((_e1010.x * _e115) + (_e1010.y * _e117)) + (_e1010.z * _e119)) + (_e1010.w * 1f));
                                            let _e1024 = instances.member[(0u + _e923)].world_to_object[0u];
                                            let _e1035 = ((((_e1024.x * _e133) + (_e1024.y * _e134)) + (_e1024.z * _e135)) + (_e1024.w * 0f));
                                            let _e1037 = instances.member[(0u + _e923)].world_to_object[1u];
                                            let _e1048 = ((((_e1037.x * _e133) + (_e1037.y * _e134)) + (_e1037.z * _e135)) + (_e1037.w * 0f));
                                            let _e1050 = instances.member[(0u + _e923)].world_to_object[2u];
                                            let _e1061 = ((((_e1050.x * _e133) + (_e1050.y * _e134)) + (_e1050.z * _e135)) + (_e1050.w * 0f));
                                            let _e1064 = instances.member[(0u + _e923)].root;
                                            let _e1066 = instances.member[(0u + _e923)].first_triangle;
                                            let _e1067 = abs(_e1035);
                                            let _e1068 = abs(_e1048);
                                            let _e1069 = abs(_e1061);
                                            if (abs(_e995) < 1000000000000000f) {
                                                if (abs(_e1008) < 1000000000000000f) {
                                                    phi_1217_ = (abs(_e1021) < 1000000000000000f);
                                                    phi_1218_ = false;
                                                } else {
                                                    phi_1217_ = bool();
                                                    phi_1218_ = true;
                                                }
                                                let _e1077 = phi_1217_;
                                                let _e1079 = phi_1218_;
                                                phi_1219_ = _e1077;
                                                phi_1220_ = _e1079;
                                            } else {
                                                phi_1219_ = bool();
                                                phi_1220_ = true;
                                            }
                                            let _e1081 = phi_1219_;
                                            let _e1083 = phi_1220_;
                                            if _e1083 {
                                                phi_1224_ = false;
                                            } else {
                                                phi_1224_ = _e1081;
                                            }
                                            let _e1085 = phi_1224_;
                                            if _e1085 {
                                                if (_e1067 < 1000000000000000f) {
                                                    if (_e1068 < 1000000000000000f) {
                                                        phi_1237_ = (_e1069 < 1000000000000000f);
                                                        phi_1238_ = false;
                                                    } else {
                                                        phi_1237_ = bool();
                                                        phi_1238_ = true;
                                                    }
                                                    let _e1090 = phi_1237_;
                                                    let _e1092 = phi_1238_;
                                                    phi_1239_ = _e1090;
                                                    phi_1240_ = _e1092;
                                                } else {
                                                    phi_1239_ = bool();
                                                    phi_1240_ = true;
                                                }
                                                let _e1094 = phi_1239_;
                                                let _e1096 = phi_1240_;
                                                if _e1096 {
                                                    phi_1244_ = false;
                                                } else {
                                                    phi_1244_ = _e1094;
                                                }
                                                let _e1098 = phi_1244_;
                                                if _e1098 {
                                                    if (_e1067 > 0f) {
                                                        phi_1258_ = bool();
                                                        phi_1259_ = true;
                                                    } else {
                                                        let _e1100 = (_e1068 > 0f);
                                                        if _e1100 {
                                                            phi_1257_ = bool();
                                                        } else {
                                                            phi_1257_ = (_e1069 > 0f);
                                                        }
                                                        let _e1103 = phi_1257_;
                                                        phi_1258_ = _e1103;
                                                        phi_1259_ = _e1100;
                                                    }
                                                    let _e1105 = phi_1258_;
                                                    let _e1107 = phi_1259_;
                                                    if _e1107 {
                                                        phi_1263_ = true;
                                                    } else {
                                                        phi_1263_ = _e1105;
                                                    }
                                                    let _e1109 = phi_1263_;
                                                    phi_1264_ = _e1109;
                                                    phi_1265_ = false;
                                                } else {
                                                    phi_1264_ = bool();
                                                    phi_1265_ = true;
                                                }
                                                let _e1111 = phi_1264_;
                                                let _e1113 = phi_1265_;
                                                phi_1266_ = _e1111;
                                                phi_1267_ = _e1113;
                                            } else {
                                                phi_1266_ = bool();
                                                phi_1267_ = true;
                                            }
                                            let _e1115 = phi_1266_;
                                            let _e1117 = phi_1267_;
                                            if _e1117 {
                                                phi_1271_ = false;
                                            } else {
                                                phi_1271_ = _e1115;
                                            }
                                            let _e1119 = phi_1271_;
                                            if _e1119 {
                                                let _e1120 = (_e1064 >= _e64);
                                                if _e1120 {
                                                    phi_2651_ = bool();
                                                } else {
                                                    if (_e1064 < _e64) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1126 = nodes.member[(0u + _e1064)].frame[0u];
                                                    let _e1130 = nodes.member[(0u + _e1064)].frame[1u];
                                                    let _e1134 = nodes.member[(0u + _e1064)].frame[2u];
                                                    let _e1138 = nodes.member[(0u + _e1064)].frame[0u];
                                                    let _e1142 = nodes.member[(0u + _e1064)].frame[1u];
                                                    let _e1146 = nodes.member[(0u + _e1064)].frame[2u];
                                                    let _e1150 = nodes.member[(0u + _e1064)].frame[3u];
                                                    let _e1184 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1035), abs(_e1048));
                                                    let _e1185 = core_intrinsics_maximum_number_nsz_f32_(_e1184, abs(_e1061));
                                                    let _e1186 = (_e1185 * 0.0000000000009094947f);
                                                    if (abs(_e1035) < _e1186) {
                                                        phi_1341_ = _e1186;
                                                    } else {
                                                        phi_1341_ = abs(_e1035);
                                                    }
                                                    let _e1191 = phi_1341_;
                                                    if (_e1035 < 0f) {
                                                        phi_1348_ = (-1f / _e1191);
                                                    } else {
                                                        phi_1348_ = (1f / _e1191);
                                                    }
                                                    let _e1196 = phi_1348_;
                                                    if (abs(_e1048) < _e1186) {
                                                        phi_1355_ = _e1186;
                                                    } else {
                                                        phi_1355_ = abs(_e1048);
                                                    }
                                                    let _e1201 = phi_1355_;
                                                    if (_e1048 < 0f) {
                                                        phi_1362_ = (-1f / _e1201);
                                                    } else {
                                                        phi_1362_ = (1f / _e1201);
                                                    }
                                                    let _e1206 = phi_1362_;
                                                    if (abs(_e1061) < _e1186) {
                                                        phi_1369_ = _e1186;
                                                    } else {
                                                        phi_1369_ = abs(_e1061);
                                                    }
                                                    let _e1211 = phi_1369_;
                                                    if (_e1061 < 0f) {
                                                        phi_1376_ = (-1f / _e1211);
                                                    } else {
                                                        phi_1376_ = (1f / _e1211);
                                                    }
                                                    let _e1216 = phi_1376_;
                                                    let _e1220 = abs((bitcast<f32>(_e1126) - _e995));
                                                    let _e1221 = abs((bitcast<f32>(_e1130) - _e1008));
                                                    let _e1222 = abs((bitcast<f32>(_e1134) - _e1021));
                                                    let _e1226 = abs(((bitcast<f32>(_e1138) + (bitcast<f32>((((_e1150 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e995));
                                                    let _e1227 = abs(((bitcast<f32>(_e1142) + (bitcast<f32>((((_e1150 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1008));
                                                    let _e1228 = abs(((bitcast<f32>(_e1146) + (bitcast<f32>((((_e1150 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1021));
                                                    if (_e1220 > _e1226) {
                                                        phi_1393_ = _e1220;
                                                    } else {
                                                        phi_1393_ = _e1226;
                                                    }
                                                    let _e1231 = phi_1393_;
                                                    if (_e1221 > _e1227) {
                                                        phi_1398_ = _e1221;
                                                    } else {
                                                        phi_1398_ = _e1227;
                                                    }
                                                    let _e1234 = phi_1398_;
                                                    if (_e1222 > _e1228) {
                                                        phi_1403_ = _e1222;
                                                    } else {
                                                        phi_1403_ = _e1228;
                                                    }
                                                    let _e1237 = phi_1403_;
                                                    if (_e1231 > _e1234) {
                                                        phi_1408_ = _e1231;
                                                    } else {
                                                        phi_1408_ = _e1234;
                                                    }
                                                    let _e1240 = phi_1408_;
                                                    if (_e1240 > _e1237) {
                                                        phi_1413_ = _e1240;
                                                    } else {
                                                        phi_1413_ = _e1237;
                                                    }
                                                    let _e1243 = phi_1413_;
                                                    let _e1247 = (_e1243 * 0.0000019073486f);
                                                    let _e1248 = (abs(_e1196) * _e1247);
                                                    let _e1249 = (abs(_e1206) * _e1247);
                                                    let _e1250 = (abs(_e1216) * _e1247);
                                                    let _e1254 = (_e1243 * 0.0000009536743f);
                                                    let _e1255 = (abs(_e1196) * _e1254);
                                                    let _e1256 = (abs(_e1206) * _e1254);
                                                    let _e1257 = (abs(_e1216) * _e1254);
                                                    let _e1258 = abs(_e1035);
                                                    let _e1259 = abs(_e1048);
                                                    let _e1260 = abs(_e1061);
                                                    if (_e1258 >= _e1259) {
                                                        if (_e1258 >= _e1260) {
                                                            phi_1439_ = false;
                                                        } else {
                                                            phi_1439_ = true;
                                                        }
                                                        let _e1264 = phi_1439_;
                                                        phi_1440_ = _e1264;
                                                    } else {
                                                        phi_1440_ = true;
                                                    }
                                                    let _e1266 = phi_1440_;
                                                    if _e1266 {
                                                        if (_e1259 >= _e1260) {
                                                            phi_1448_ = 1u;
                                                        } else {
                                                            phi_1448_ = 2u;
                                                        }
                                                        let _e1269 = phi_1448_;
                                                        phi_1449_ = _e1269;
                                                    } else {
                                                        phi_1449_ = 0u;
                                                    }
                                                    let _e1271 = phi_1449_;
                                                    if (_e1271 == 0u) {
                                                        phi_1461_ = vec3<f32>(_e1048, _e1061, _e1035);
                                                    } else {
                                                        if (_e1271 == 1u) {
                                                            phi_1460_ = vec3<f32>(_e1061, _e1035, _e1048);
                                                        } else {
                                                            phi_1460_ = vec3<f32>(_e1035, _e1048, _e1061);
                                                        }
                                                        let _e1277 = phi_1460_;
                                                        phi_1461_ = _e1277;
                                                    }
                                                    let _e1279 = phi_1461_;
                                                    let _e1282 = (_e1279.x / _e1279.z);
                                                    let _e1285 = (_e1279.y / _e1279.z);
                                                    if (_e1196 < 0f) {
                                                        phi_1474_ = 0u;
                                                    } else {
                                                        phi_1474_ = 1u;
                                                    }
                                                    let _e1290 = phi_1474_;
                                                    if (_e1206 < 0f) {
                                                        phi_1479_ = 0u;
                                                    } else {
                                                        phi_1479_ = 2u;
                                                    }
                                                    let _e1293 = phi_1479_;
                                                    if (_e1216 < 0f) {
                                                        phi_1484_ = 0u;
                                                    } else {
                                                        phi_1484_ = 4u;
                                                    }
                                                    let _e1296 = phi_1484_;
                                                    let _e1298 = ((_e1290 | _e1293) | _e1296);
                                                    let _e1299 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1064, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1299.first[0], _e1299.first[1], _e1299.first[2], _e1299.first[3], _e1299.first[4], _e1299.first[5], _e1299.first[6], _e1299.first[7], _e1299.first[8], _e1299.first[9], _e1299.first[10], _e1299.first[11], _e1299.first[12], _e1299.first[13], _e1299.first[14], _e1299.first[15], _e1299.first[16], _e1299.first[17], _e1299.first[18], _e1299.first[19], _e1299.first[20], _e1299.first[21], _e1299.first[22], _e1299.first[23], _e1299.first[24], _e1299.first[25], _e1299.first[26], _e1299.first[27], _e1299.first[28], _e1299.first[29], _e1299.first[30], _e1299.first[31]), array<u32, 32>(_e1299.mask[0], _e1299.mask[1], _e1299.mask[2], _e1299.mask[3], _e1299.mask[4], _e1299.mask[5], _e1299.mask[6], _e1299.mask[7], _e1299.mask[8], _e1299.mask[9], _e1299.mask[10], _e1299.mask[11], _e1299.mask[12], _e1299.mask[13], _e1299.mask[14], _e1299.mask[15], _e1299.mask[16], _e1299.mask[17], _e1299.mask[18], _e1299.mask[19], _e1299.mask[20], _e1299.mask[21], _e1299.mask[22], _e1299.mask[23], _e1299.mask[24], _e1299.mask[25], _e1299.mask[26], _e1299.mask[27], _e1299.mask[28], _e1299.mask[29], _e1299.mask[30], _e1299.mask[31]), _e1299.len, _e1299.group, _e1299.group_mask);
                                                    let _e1373 = local.group_mask;
                                                    if ((_e1373 & 4278190080u) == 0u) {
                                                        let _e1377 = local.len;
                                                        if (_e1377 == 0u) {
                                                            phi_1598_ = false;
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
                                                            phi_1598_ = true;
                                                        }
                                                        let _e1400 = phi_1598_;
                                                        phi_1599_ = _e1400;
                                                    } else {
                                                        phi_1599_ = true;
                                                    }
                                                    let _e1402 = phi_1599_;
                                                    if _e1402 {
                                                        let _e1404 = local.group_mask;
                                                        let _e1410 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1404)), 32u, (_e1404 == 0u)));
                                                        let _e1414 = local.group_mask;
                                                        let _e1428 = local.group_mask;
                                                        local.group_mask = (_e1428 & ~((1u << bitcast<u32>((_e1410 & 31u)))));
                                                        let _e1431 = local.group;
                                                        phi_1630_ = (_e1431 + countOneBits(((_e1414 & ~((4294967295u << bitcast<u32>((((_e1410 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1630_ = 4294967295u;
                                                    }
                                                    let _e1434 = phi_1630_;
                                                    phi_1632_ = _e1434;
                                                    phi_1635_ = _e915;
                                                    loop {
                                                        let _e1436 = phi_1632_;
                                                        let _e1438 = phi_1635_;
                                                        local_14 = _e1438;
                                                        if (_e1436 != 4294967295u) {
                                                            if (_e1436 < _e64) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1445 = nodes.member[(0u + _e1436)].frame[3u];
                                                            let _e1470 = (bitcast<f32>((((_e1445 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1196);
                                                            let _e1471 = (bitcast<f32>((((_e1445 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1206);
                                                            let _e1472 = (bitcast<f32>((((_e1445 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1216);
                                                            let _e1475 = nodes.member[(0u + _e1436)].frame[0u];
                                                            let _e1479 = nodes.member[(0u + _e1436)].frame[1u];
                                                            let _e1483 = nodes.member[(0u + _e1436)].frame[2u];
                                                            let _e1488 = ((bitcast<f32>(_e1475) - _e995) * _e1196);
                                                            let _e1489 = ((bitcast<f32>(_e1479) - _e1008) * _e1206);
                                                            let _e1490 = ((bitcast<f32>(_e1483) - _e1021) * _e1216);
                                                            let _e1498 = nodes.member[(0u + _e1436)].x;
                                                            if (_e1196 < 0f) {
                                                                let _e1509 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1498.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1515 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1509.unnamed.root, _e1498.w), _e1509.unnamed_1);
                                                                let _e1521 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1515.unnamed, lt_bvh_traverse_Tree(_e1498.x, _e1515.unnamed_1.first_primitive));
                                                                phi_1715_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1521.unnamed, lt_bvh_traverse_Tree(_e1521.unnamed_1.root, _e1498.y));
                                                            } else {
                                                                let _e1537 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1498.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1537.unnamed.root, _e1498.y), _e1537.unnamed_1);
                                                                let _e1549 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1543.unnamed, lt_bvh_traverse_Tree(_e1498.z, _e1543.unnamed_1.first_primitive));
                                                                phi_1715_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1549.unnamed, lt_bvh_traverse_Tree(_e1549.unnamed_1.root, _e1498.w));
                                                            }
                                                            let _e1557 = phi_1715_;
                                                            let _e1567 = nodes.member[(0u + _e1436)].y;
                                                            if (_e1206 < 0f) {
                                                                let _e1578 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1567.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1584 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1578.unnamed.root, _e1567.w), _e1578.unnamed_1);
                                                                let _e1590 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1584.unnamed, lt_bvh_traverse_Tree(_e1567.x, _e1584.unnamed_1.first_primitive));
                                                                phi_1742_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1590.unnamed, lt_bvh_traverse_Tree(_e1590.unnamed_1.root, _e1567.y));
                                                            } else {
                                                                let _e1606 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1567.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1606.unnamed.root, _e1567.y), _e1606.unnamed_1);
                                                                let _e1618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1612.unnamed, lt_bvh_traverse_Tree(_e1567.z, _e1612.unnamed_1.first_primitive));
                                                                phi_1742_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1618.unnamed, lt_bvh_traverse_Tree(_e1618.unnamed_1.root, _e1567.w));
                                                            }
                                                            let _e1626 = phi_1742_;
                                                            let _e1636 = nodes.member[(0u + _e1436)].z;
                                                            if (_e1216 < 0f) {
                                                                let _e1647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1636.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1647.unnamed.root, _e1636.w), _e1647.unnamed_1);
                                                                let _e1659 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1653.unnamed, lt_bvh_traverse_Tree(_e1636.x, _e1653.unnamed_1.first_primitive));
                                                                phi_1769_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1659.unnamed, lt_bvh_traverse_Tree(_e1659.unnamed_1.root, _e1636.y));
                                                            } else {
                                                                let _e1675 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1636.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1675.unnamed.root, _e1636.y), _e1675.unnamed_1);
                                                                let _e1687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1681.unnamed, lt_bvh_traverse_Tree(_e1636.z, _e1681.unnamed_1.first_primitive));
                                                                phi_1769_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1687.unnamed, lt_bvh_traverse_Tree(_e1687.unnamed_1.root, _e1636.w));
                                                            }
                                                            let _e1695 = phi_1769_;
                                                            phi_1775_ = 0u;
                                                            phi_1778_ = 0u;
                                                            loop {
                                                                let _e1705 = phi_1775_;
                                                                let _e1707 = phi_1778_;
                                                                local_5 = _e1707;
                                                                local_6 = _e1707;
                                                                local_7 = _e1707;
                                                                let _e1708 = (_e1705 < 8u);
                                                                if _e1708 {
                                                                    let _e1710 = (_e1705 >> bitcast<u32>(2i));
                                                                    let _e1711 = (_e1705 & 3u);
                                                                    if (_e1710 == 0u) {
                                                                        phi_1792_ = _e1557.unnamed.root;
                                                                    } else {
                                                                        phi_1792_ = _e1557.unnamed.first_primitive;
                                                                    }
                                                                    let _e1714 = phi_1792_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1802_ = _e1626.unnamed.root;
                                                                    } else {
                                                                        phi_1802_ = _e1626.unnamed.first_primitive;
                                                                    }
                                                                    let _e1723 = phi_1802_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1812_ = _e1695.unnamed.root;
                                                                    } else {
                                                                        phi_1812_ = _e1695.unnamed.first_primitive;
                                                                    }
                                                                    let _e1732 = phi_1812_;
                                                                    let _e1745 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1714 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1248)), ((f32(((_e1723 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 - _e1249)));
                                                                    let _e1746 = core_intrinsics_maximum_number_nsz_f32_(_e1745, ((f32(((_e1732 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1472) + (_e1490 - _e1250)));
                                                                    if (_e1710 == 0u) {
                                                                        phi_1830_ = _e1557.unnamed_1.root;
                                                                    } else {
                                                                        phi_1830_ = _e1557.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1749 = phi_1830_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1840_ = _e1626.unnamed_1.root;
                                                                    } else {
                                                                        phi_1840_ = _e1626.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1758 = phi_1840_;
                                                                    if (_e1710 == 0u) {
                                                                        phi_1850_ = _e1695.unnamed_1.root;
                                                                    } else {
                                                                        phi_1850_ = _e1695.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1767 = phi_1850_;
                                                                    let _e1780 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1749 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1248)), ((f32(((_e1758 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 + _e1249)));
                                                                    let _e1781 = core_intrinsics_minimum_number_nsz_f32_(_e1780, ((f32(((_e1767 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u)) * _e1472) + (_e1490 + _e1250)));
                                                                    if (_e1746 <= _e1781) {
                                                                        if (_e1746 <= _e125) {
                                                                            if (_e1781 >= 0f) {
                                                                                if (_e1710 == 0u) {
                                                                                    let _e1788 = nodes.member[(0u + _e1436)].links[2u];
                                                                                    phi_1886_ = _e1788;
                                                                                } else {
                                                                                    let _e1791 = nodes.member[(0u + _e1436)].links[3u];
                                                                                    phi_1886_ = _e1791;
                                                                                }
                                                                                let _e1793 = phi_1886_;
                                                                                let _e1798 = ((_e1793 >> bitcast<u32>(((_e1711 * 8u) & 31u))) & 255u);
                                                                                let _e1799 = (_e1798 & 31u);
                                                                                if (_e1799 >= 24u) {
                                                                                    phi_1899_ = (24u + ((_e1799 - 24u) ^ _e1298));
                                                                                } else {
                                                                                    phi_1899_ = _e1799;
                                                                                }
                                                                                let _e1805 = phi_1899_;
                                                                                phi_1904_ = (_e1707 | ((_e1798 >> bitcast<u32>(5i)) << bitcast<u32>((_e1805 & 31u))));
                                                                            } else {
                                                                                phi_1904_ = _e1707;
                                                                            }
                                                                            let _e1813 = phi_1904_;
                                                                            phi_1905_ = _e1813;
                                                                        } else {
                                                                            phi_1905_ = _e1707;
                                                                        }
                                                                        let _e1815 = phi_1905_;
                                                                        phi_1906_ = _e1815;
                                                                    } else {
                                                                        phi_1906_ = _e1707;
                                                                    }
                                                                    let _e1817 = phi_1906_;
                                                                    phi_1776_ = (_e1705 + 1u);
                                                                    phi_1779_ = _e1817;
                                                                } else {
                                                                    phi_1776_ = u32();
                                                                    phi_1779_ = u32();
                                                                }
                                                                let _e1820 = phi_1776_;
                                                                let _e1822 = phi_1779_;
                                                                continue;
                                                                continuing {
                                                                    phi_1775_ = _e1820;
                                                                    phi_1778_ = _e1822;
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
                                                                local.group = (_e1064 + _e1826);
                                                                let _e1866 = local_6;
                                                                local.group_mask = ((_e1866 & 4278190080u) | (_e1830 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1871 = local_7;
                                                            phi_1964_ = (_e1871 & 16777215u);
                                                            phi_1967_ = _e1438;
                                                            loop {
                                                                let _e1874 = phi_1964_;
                                                                let _e1876 = phi_1967_;
                                                                local_12 = _e1876;
                                                                let _e1877 = (_e1874 == 0u);
                                                                local_8 = _e1877;
                                                                local_13 = _e1877;
                                                                if _e1877 {
                                                                    phi_1965_ = u32();
                                                                    phi_1968_ = bool();
                                                                    phi_2565_ = false;
                                                                } else {
                                                                    let _e1880 = nodes.member[(0u + _e1436)].links[1u];
                                                                    let _e1885 = ((_e1066 + _e1880) + select(firstTrailingBit(_e1874), 32u, (_e1874 == 0u)));
                                                                    if (_e1885 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1892 = triangles.member[(0u + _e1885)].v0_;
                                                                    let _e1894 = (_e1892.x - _e995);
                                                                    let _e1896 = (_e1892.y - _e1008);
                                                                    let _e1898 = (_e1892.z - _e1021);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2012_ = vec3<f32>(_e1896, _e1898, _e1894);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2011_ = vec3<f32>(_e1898, _e1894, _e1896);
                                                                        } else {
                                                                            phi_2011_ = (_e1892 - vec3<f32>(_e995, _e1008, _e1021));
                                                                        }
                                                                        let _e1906 = phi_2011_;
                                                                        phi_2012_ = _e1906;
                                                                    }
                                                                    let _e1908 = phi_2012_;
                                                                    let _e1912 = (_e1908.x - (_e1282 * _e1908.z));
                                                                    let _e1916 = (_e1908.y - (_e1285 * _e1908.z));
                                                                    let _e1918 = triangles.member[(0u + _e1885)].v1_;
                                                                    let _e1920 = (_e1918.x - _e995);
                                                                    let _e1922 = (_e1918.y - _e1008);
                                                                    let _e1924 = (_e1918.z - _e1021);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2042_ = vec3<f32>(_e1922, _e1924, _e1920);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2041_ = vec3<f32>(_e1924, _e1920, _e1922);
                                                                        } else {
                                                                            phi_2041_ = (_e1918 - vec3<f32>(_e995, _e1008, _e1021));
                                                                        }
                                                                        let _e1932 = phi_2041_;
                                                                        phi_2042_ = _e1932;
                                                                    }
                                                                    let _e1934 = phi_2042_;
                                                                    let _e1938 = (_e1934.x - (_e1282 * _e1934.z));
                                                                    let _e1942 = (_e1934.y - (_e1285 * _e1934.z));
                                                                    let _e1944 = triangles.member[(0u + _e1885)].v2_;
                                                                    let _e1946 = (_e1944.x - _e995);
                                                                    let _e1948 = (_e1944.y - _e1008);
                                                                    let _e1950 = (_e1944.z - _e1021);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2072_ = vec3<f32>(_e1948, _e1950, _e1946);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2071_ = vec3<f32>(_e1950, _e1946, _e1948);
                                                                        } else {
                                                                            phi_2071_ = (_e1944 - vec3<f32>(_e995, _e1008, _e1021));
                                                                        }
                                                                        let _e1958 = phi_2071_;
                                                                        phi_2072_ = _e1958;
                                                                    }
                                                                    let _e1960 = phi_2072_;
                                                                    let _e1964 = (_e1960.x - (_e1282 * _e1960.z));
                                                                    let _e1968 = (_e1960.y - (_e1285 * _e1960.z));
                                                                    if (_e1938 < _e1964) {
                                                                        phi_2091_ = true;
                                                                    } else {
                                                                        if (_e1938 == _e1964) {
                                                                            phi_2090_ = (_e1942 < _e1968);
                                                                        } else {
                                                                            phi_2090_ = false;
                                                                        }
                                                                        let _e1973 = phi_2090_;
                                                                        phi_2091_ = _e1973;
                                                                    }
                                                                    let _e1975 = phi_2091_;
                                                                    if _e1975 {
                                                                        phi_2095_ = _e1968;
                                                                        phi_2096_ = _e1964;
                                                                        phi_2097_ = _e1942;
                                                                        phi_2098_ = _e1938;
                                                                    } else {
                                                                        phi_2095_ = _e1942;
                                                                        phi_2096_ = _e1938;
                                                                        phi_2097_ = _e1968;
                                                                        phi_2098_ = _e1964;
                                                                    }
                                                                    let _e1977 = phi_2095_;
                                                                    let _e1979 = phi_2096_;
                                                                    let _e1981 = phi_2097_;
                                                                    let _e1983 = phi_2098_;
                                                                    let _e1986 = ((_e1983 * _e1977) - (_e1981 * _e1979));
                                                                    if _e1975 {
                                                                        phi_2106_ = -(_e1986);
                                                                    } else {
                                                                        phi_2106_ = _e1986;
                                                                    }
                                                                    let _e1989 = phi_2106_;
                                                                    if (_e1964 < _e1912) {
                                                                        phi_2117_ = true;
                                                                    } else {
                                                                        if (_e1964 == _e1912) {
                                                                            phi_2116_ = (_e1968 < _e1916);
                                                                        } else {
                                                                            phi_2116_ = false;
                                                                        }
                                                                        let _e1994 = phi_2116_;
                                                                        phi_2117_ = _e1994;
                                                                    }
                                                                    let _e1996 = phi_2117_;
                                                                    if _e1996 {
                                                                        phi_2121_ = _e1916;
                                                                        phi_2122_ = _e1912;
                                                                        phi_2123_ = _e1968;
                                                                        phi_2124_ = _e1964;
                                                                    } else {
                                                                        phi_2121_ = _e1968;
                                                                        phi_2122_ = _e1964;
                                                                        phi_2123_ = _e1916;
                                                                        phi_2124_ = _e1912;
                                                                    }
                                                                    let _e1998 = phi_2121_;
                                                                    let _e2000 = phi_2122_;
                                                                    let _e2002 = phi_2123_;
                                                                    let _e2004 = phi_2124_;
                                                                    let _e2007 = ((_e2004 * _e1998) - (_e2002 * _e2000));
                                                                    if _e1996 {
                                                                        phi_2132_ = -(_e2007);
                                                                    } else {
                                                                        phi_2132_ = _e2007;
                                                                    }
                                                                    let _e2010 = phi_2132_;
                                                                    if (_e1912 < _e1938) {
                                                                        phi_2143_ = true;
                                                                    } else {
                                                                        if (_e1912 == _e1938) {
                                                                            phi_2142_ = (_e1916 < _e1942);
                                                                        } else {
                                                                            phi_2142_ = false;
                                                                        }
                                                                        let _e2015 = phi_2142_;
                                                                        phi_2143_ = _e2015;
                                                                    }
                                                                    let _e2017 = phi_2143_;
                                                                    if _e2017 {
                                                                        phi_2147_ = _e1942;
                                                                        phi_2148_ = _e1938;
                                                                        phi_2149_ = _e1916;
                                                                        phi_2150_ = _e1912;
                                                                    } else {
                                                                        phi_2147_ = _e1916;
                                                                        phi_2148_ = _e1912;
                                                                        phi_2149_ = _e1942;
                                                                        phi_2150_ = _e1938;
                                                                    }
                                                                    let _e2019 = phi_2147_;
                                                                    let _e2021 = phi_2148_;
                                                                    let _e2023 = phi_2149_;
                                                                    let _e2025 = phi_2150_;
                                                                    let _e2028 = ((_e2025 * _e2019) - (_e2023 * _e2021));
                                                                    if _e2017 {
                                                                        phi_2158_ = -(_e2028);
                                                                    } else {
                                                                        phi_2158_ = _e2028;
                                                                    }
                                                                    let _e2031 = phi_2158_;
                                                                    if (_e1989 >= 0f) {
                                                                        if (_e2010 >= 0f) {
                                                                            if (_e2031 >= 0f) {
                                                                                phi_2173_ = ((_e1989 + _e2010) + _e2031);
                                                                                phi_2174_ = false;
                                                                            } else {
                                                                                phi_2173_ = f32();
                                                                                phi_2174_ = true;
                                                                            }
                                                                            let _e2038 = phi_2173_;
                                                                            let _e2040 = phi_2174_;
                                                                            phi_2175_ = _e2038;
                                                                            phi_2176_ = _e2040;
                                                                        } else {
                                                                            phi_2175_ = f32();
                                                                            phi_2176_ = true;
                                                                        }
                                                                        let _e2042 = phi_2175_;
                                                                        let _e2044 = phi_2176_;
                                                                        phi_2177_ = _e2042;
                                                                        phi_2178_ = _e2044;
                                                                    } else {
                                                                        phi_2177_ = f32();
                                                                        phi_2178_ = true;
                                                                    }
                                                                    let _e2046 = phi_2177_;
                                                                    let _e2048 = phi_2178_;
                                                                    if _e2048 {
                                                                        if (_e1989 <= 0f) {
                                                                            if (_e2010 <= 0f) {
                                                                                let _e2051 = (_e2031 <= 0f);
                                                                                if _e2051 {
                                                                                }
                                                                                phi_2196_ = ((_e1989 + _e2010) + _e2031);
                                                                                phi_2197_ = false;
                                                                                phi_2198_ = _e2051;
                                                                            } else {
                                                                                phi_2196_ = f32();
                                                                                phi_2197_ = true;
                                                                                phi_2198_ = false;
                                                                            }
                                                                            let _e2055 = phi_2196_;
                                                                            let _e2057 = phi_2197_;
                                                                            let _e2059 = phi_2198_;
                                                                            phi_2199_ = _e2055;
                                                                            phi_2200_ = _e2057;
                                                                            phi_2201_ = _e2059;
                                                                        } else {
                                                                            phi_2199_ = f32();
                                                                            phi_2200_ = true;
                                                                            phi_2201_ = false;
                                                                        }
                                                                        let _e2061 = phi_2199_;
                                                                        let _e2063 = phi_2200_;
                                                                        let _e2065 = phi_2201_;
                                                                        if _e2063 {
                                                                            phi_2205_ = false;
                                                                        } else {
                                                                            phi_2205_ = _e2065;
                                                                        }
                                                                        let _e2067 = phi_2205_;
                                                                        phi_2206_ = _e2061;
                                                                        phi_2207_ = _e2067;
                                                                    } else {
                                                                        phi_2206_ = _e2046;
                                                                        phi_2207_ = true;
                                                                    }
                                                                    let _e2069 = phi_2206_;
                                                                    let _e2071 = phi_2207_;
                                                                    if _e2071 {
                                                                        let _e2072 = (_e2069 == 0f);
                                                                        if _e2072 {
                                                                            phi_2523_ = lt_bvh_triangle_Intersection();
                                                                            phi_2524_ = false;
                                                                        } else {
                                                                            let _e2074 = triangles.member[(0u + _e1885)].v0_;
                                                                            let _e2076 = (_e2074.x - _e995);
                                                                            let _e2078 = (_e2074.y - _e1008);
                                                                            let _e2080 = (_e2074.z - _e1021);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2236_ = vec3<f32>(_e2078, _e2080, _e2076);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2235_ = vec3<f32>(_e2080, _e2076, _e2078);
                                                                                } else {
                                                                                    phi_2235_ = (_e2074 - vec3<f32>(_e995, _e1008, _e1021));
                                                                                }
                                                                                let _e2088 = phi_2235_;
                                                                                phi_2236_ = _e2088;
                                                                            }
                                                                            let _e2090 = phi_2236_;
                                                                            let _e2092 = triangles.member[(0u + _e1885)].v1_;
                                                                            let _e2094 = triangles.member[(0u + _e1885)].v0_;
                                                                            let _e2097 = (_e2092.x - _e2094.x);
                                                                            let _e2100 = (_e2092.y - _e2094.y);
                                                                            let _e2103 = (_e2092.z - _e2094.z);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2262_ = vec3<f32>(_e2100, _e2103, _e2097);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2261_ = vec3<f32>(_e2103, _e2097, _e2100);
                                                                                } else {
                                                                                    phi_2261_ = (_e2092 - _e2094);
                                                                                }
                                                                                let _e2110 = phi_2261_;
                                                                                phi_2262_ = _e2110;
                                                                            }
                                                                            let _e2112 = phi_2262_;
                                                                            let _e2114 = triangles.member[(0u + _e1885)].v2_;
                                                                            let _e2116 = triangles.member[(0u + _e1885)].v0_;
                                                                            let _e2119 = (_e2114.x - _e2116.x);
                                                                            let _e2122 = (_e2114.y - _e2116.y);
                                                                            let _e2125 = (_e2114.z - _e2116.z);
                                                                            if (_e1271 == 0u) {
                                                                                phi_2288_ = vec3<f32>(_e2122, _e2125, _e2119);
                                                                            } else {
                                                                                if (_e1271 == 1u) {
                                                                                    phi_2287_ = vec3<f32>(_e2125, _e2119, _e2122);
                                                                                } else {
                                                                                    phi_2287_ = (_e2114 - _e2116);
                                                                                }
                                                                                let _e2132 = phi_2287_;
                                                                                phi_2288_ = _e2132;
                                                                            }
                                                                            let _e2134 = phi_2288_;
                                                                            let _e2141 = ((_e2112.y * _e2134.z) - (_e2112.z * _e2134.y));
                                                                            let _e2148 = ((_e2112.z * _e2134.x) - (_e2112.x * _e2134.z));
                                                                            let _e2155 = ((_e2112.x * _e2134.y) - (_e2112.y * _e2134.x));
                                                                            let _e2169 = (((1f / _e1279.z) * (((_e2141 * _e2090.x) + (_e2148 * _e2090.y)) + (_e2155 * _e2090.z))) / (((_e2141 * _e1282) + (_e2148 * _e1285)) + _e2155));
                                                                            if (_e2169 > 0f) {
                                                                                if (_e2169 < _e125) {
                                                                                    let _e2173 = triangles.member[(0u + _e1885)].v0_;
                                                                                    let _e2175 = triangles.member[(0u + _e1885)].v1_;
                                                                                    if (_e2173.x < _e2175.x) {
                                                                                        phi_2344_ = _e2173.x;
                                                                                    } else {
                                                                                        phi_2344_ = _e2175.x;
                                                                                    }
                                                                                    let _e2182 = phi_2344_;
                                                                                    if (_e2173.y < _e2175.y) {
                                                                                        phi_2353_ = _e2173.y;
                                                                                    } else {
                                                                                        phi_2353_ = _e2175.y;
                                                                                    }
                                                                                    let _e2189 = phi_2353_;
                                                                                    if (_e2173.z < _e2175.z) {
                                                                                        phi_2362_ = _e2173.z;
                                                                                    } else {
                                                                                        phi_2362_ = _e2175.z;
                                                                                    }
                                                                                    let _e2196 = phi_2362_;
                                                                                    let _e2198 = triangles.member[(0u + _e1885)].v2_;
                                                                                    if (_e2182 < _e2198.x) {
                                                                                        phi_2371_ = _e2182;
                                                                                    } else {
                                                                                        phi_2371_ = _e2198.x;
                                                                                    }
                                                                                    let _e2203 = phi_2371_;
                                                                                    if (_e2189 < _e2198.y) {
                                                                                        phi_2378_ = _e2189;
                                                                                    } else {
                                                                                        phi_2378_ = _e2198.y;
                                                                                    }
                                                                                    let _e2208 = phi_2378_;
                                                                                    if (_e2196 < _e2198.z) {
                                                                                        phi_2385_ = _e2196;
                                                                                    } else {
                                                                                        phi_2385_ = _e2198.z;
                                                                                    }
                                                                                    let _e2213 = phi_2385_;
                                                                                    let _e2215 = triangles.member[(0u + _e1885)].v0_;
                                                                                    let _e2217 = triangles.member[(0u + _e1885)].v1_;
                                                                                    if (_e2215.x > _e2217.x) {
                                                                                        phi_2398_ = _e2215.x;
                                                                                    } else {
                                                                                        phi_2398_ = _e2217.x;
                                                                                    }
                                                                                    let _e2224 = phi_2398_;
                                                                                    if (_e2215.y > _e2217.y) {
                                                                                        phi_2407_ = _e2215.y;
                                                                                    } else {
                                                                                        phi_2407_ = _e2217.y;
                                                                                    }
                                                                                    let _e2231 = phi_2407_;
                                                                                    if (_e2215.z > _e2217.z) {
                                                                                        phi_2416_ = _e2215.z;
                                                                                    } else {
                                                                                        phi_2416_ = _e2217.z;
                                                                                    }
                                                                                    let _e2238 = phi_2416_;
                                                                                    let _e2240 = triangles.member[(0u + _e1885)].v2_;
                                                                                    if (_e2224 > _e2240.x) {
                                                                                        phi_2425_ = _e2224;
                                                                                    } else {
                                                                                        phi_2425_ = _e2240.x;
                                                                                    }
                                                                                    let _e2245 = phi_2425_;
                                                                                    if (_e2231 > _e2240.y) {
                                                                                        phi_2432_ = _e2231;
                                                                                    } else {
                                                                                        phi_2432_ = _e2240.y;
                                                                                    }
                                                                                    let _e2250 = phi_2432_;
                                                                                    if (_e2238 > _e2240.z) {
                                                                                        phi_2439_ = _e2238;
                                                                                    } else {
                                                                                        phi_2439_ = _e2240.z;
                                                                                    }
                                                                                    let _e2255 = phi_2439_;
                                                                                    let _e2259 = ((_e2203 - _e995) * _e1196);
                                                                                    let _e2260 = ((_e2208 - _e1008) * _e1206);
                                                                                    let _e2261 = ((_e2213 - _e1021) * _e1216);
                                                                                    let _e2265 = ((_e2245 - _e995) * _e1196);
                                                                                    let _e2266 = ((_e2250 - _e1008) * _e1206);
                                                                                    let _e2267 = ((_e2255 - _e1021) * _e1216);
                                                                                    if (_e2259 < _e2265) {
                                                                                        phi_2456_ = _e2259;
                                                                                    } else {
                                                                                        phi_2456_ = _e2265;
                                                                                    }
                                                                                    let _e2270 = phi_2456_;
                                                                                    if (_e2260 < _e2266) {
                                                                                        phi_2461_ = _e2260;
                                                                                    } else {
                                                                                        phi_2461_ = _e2266;
                                                                                    }
                                                                                    let _e2273 = phi_2461_;
                                                                                    if (_e2261 < _e2267) {
                                                                                        phi_2466_ = _e2261;
                                                                                    } else {
                                                                                        phi_2466_ = _e2267;
                                                                                    }
                                                                                    let _e2276 = phi_2466_;
                                                                                    if (_e2259 > _e2265) {
                                                                                        phi_2474_ = _e2259;
                                                                                    } else {
                                                                                        phi_2474_ = _e2265;
                                                                                    }
                                                                                    let _e2282 = phi_2474_;
                                                                                    if (_e2260 > _e2266) {
                                                                                        phi_2479_ = _e2260;
                                                                                    } else {
                                                                                        phi_2479_ = _e2266;
                                                                                    }
                                                                                    let _e2285 = phi_2479_;
                                                                                    if (_e2261 > _e2267) {
                                                                                        phi_2484_ = _e2261;
                                                                                    } else {
                                                                                        phi_2484_ = _e2267;
                                                                                    }
                                                                                    let _e2288 = phi_2484_;
                                                                                    let _e2292 = core_intrinsics_maximum_number_nsz_f32_((_e2270 - _e1255), (_e2273 - _e1256));
                                                                                    let _e2293 = core_intrinsics_maximum_number_nsz_f32_(_e2292, (_e2276 - _e1257));
                                                                                    let _e2294 = core_intrinsics_minimum_number_nsz_f32_((_e2282 + _e1255), (_e2285 + _e1256));
                                                                                    let _e2295 = core_intrinsics_minimum_number_nsz_f32_(_e2294, (_e2288 + _e1257));
                                                                                    if (_e2293 > _e976) {
                                                                                        phi_2496_ = _e2293;
                                                                                    } else {
                                                                                        phi_2496_ = _e976;
                                                                                    }
                                                                                    let _e2298 = phi_2496_;
                                                                                    if (_e2295 < _e978) {
                                                                                        phi_2501_ = _e2295;
                                                                                    } else {
                                                                                        phi_2501_ = _e978;
                                                                                    }
                                                                                    let _e2301 = phi_2501_;
                                                                                    if (_e2169 < _e2298) {
                                                                                        phi_2506_ = _e2298;
                                                                                    } else {
                                                                                        phi_2506_ = _e2169;
                                                                                    }
                                                                                    let _e2304 = phi_2506_;
                                                                                    if (_e2304 > _e2301) {
                                                                                        phi_2511_ = _e2301;
                                                                                    } else {
                                                                                        phi_2511_ = _e2304;
                                                                                    }
                                                                                    let _e2307 = phi_2511_;
                                                                                    phi_2516_ = lt_bvh_triangle_Intersection(_e2307, (_e2010 / _e2069), (_e2031 / _e2069), (_e2298 <= _e2301));
                                                                                    phi_2517_ = false;
                                                                                } else {
                                                                                    phi_2516_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2517_ = true;
                                                                                }
                                                                                let _e2313 = phi_2516_;
                                                                                let _e2315 = phi_2517_;
                                                                                phi_2518_ = _e2313;
                                                                                phi_2519_ = _e2315;
                                                                            } else {
                                                                                phi_2518_ = lt_bvh_triangle_Intersection();
                                                                                phi_2519_ = true;
                                                                            }
                                                                            let _e2317 = phi_2518_;
                                                                            let _e2319 = phi_2519_;
                                                                            if _e2319 {
                                                                            }
                                                                            phi_2523_ = _e2317;
                                                                            phi_2524_ = _e2319;
                                                                        }
                                                                        let _e2321 = phi_2523_;
                                                                        let _e2323 = phi_2524_;
                                                                        phi_2525_ = _e2321;
                                                                        phi_2526_ = _e2072;
                                                                        phi_2527_ = _e2323;
                                                                    } else {
                                                                        phi_2525_ = lt_bvh_triangle_Intersection();
                                                                        phi_2526_ = true;
                                                                        phi_2527_ = false;
                                                                    }
                                                                    let _e2325 = phi_2525_;
                                                                    let _e2327 = phi_2526_;
                                                                    let _e2329 = phi_2527_;
                                                                    if _e2327 {
                                                                        phi_2531_ = true;
                                                                    } else {
                                                                        phi_2531_ = _e2329;
                                                                    }
                                                                    let _e2331 = phi_2531_;
                                                                    if _e2331 {
                                                                        phi_2535_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2535_ = _e2325;
                                                                    }
                                                                    let _e2333 = phi_2535_;
                                                                    if _e2333.is_hit {
                                                                        if (_e2333.t > 0f) {
                                                                            if (_e2333.t < _e125) {
                                                                                if true {
                                                                                    phi_2555_ = false;
                                                                                } else {
                                                                                    phi_2555_ = true;
                                                                                }
                                                                                let _e2342 = phi_2555_;
                                                                                phi_2556_ = true;
                                                                                phi_2557_ = _e2342;
                                                                            } else {
                                                                                phi_2556_ = _e1876;
                                                                                phi_2557_ = true;
                                                                            }
                                                                            let _e2344 = phi_2556_;
                                                                            let _e2346 = phi_2557_;
                                                                            phi_2558_ = _e2344;
                                                                            phi_2559_ = _e2346;
                                                                        } else {
                                                                            phi_2558_ = _e1876;
                                                                            phi_2559_ = true;
                                                                        }
                                                                        let _e2348 = phi_2558_;
                                                                        let _e2350 = phi_2559_;
                                                                        phi_2560_ = _e2348;
                                                                        phi_2561_ = _e2350;
                                                                    } else {
                                                                        phi_2560_ = _e1876;
                                                                        phi_2561_ = true;
                                                                    }
                                                                    let _e2352 = phi_2560_;
                                                                    let _e2354 = phi_2561_;
                                                                    if _e2354 {
                                                                    }
                                                                    phi_1965_ = (_e1874 & (_e1874 - 1u));
                                                                    phi_1968_ = _e2352;
                                                                    phi_2565_ = _e2354;
                                                                }
                                                                let _e2356 = phi_1965_;
                                                                let _e2358 = phi_1968_;
                                                                let _e2360 = phi_2565_;
                                                                continue;
                                                                continuing {
                                                                    phi_1964_ = _e2356;
                                                                    phi_1967_ = _e2358;
                                                                    break if !(_e2360);
                                                                }
                                                            }
                                                            let _e2363 = local_8;
                                                            if _e2363 {
                                                                let _e2365 = local.group_mask;
                                                                if ((_e2365 & 4278190080u) == 0u) {
                                                                    let _e2369 = local.len;
                                                                    if (_e2369 == 0u) {
                                                                        phi_2607_ = false;
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
                                                                        phi_2607_ = true;
                                                                    }
                                                                    let _e2392 = phi_2607_;
                                                                    phi_2608_ = _e2392;
                                                                } else {
                                                                    phi_2608_ = true;
                                                                }
                                                                let _e2394 = phi_2608_;
                                                                if _e2394 {
                                                                    let _e2396 = local.group_mask;
                                                                    let _e2402 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2396)), 32u, (_e2396 == 0u)));
                                                                    let _e2406 = local.group_mask;
                                                                    let _e2420 = local.group_mask;
                                                                    local.group_mask = (_e2420 & ~((1u << bitcast<u32>((_e2402 & 31u)))));
                                                                    let _e2423 = local.group;
                                                                    phi_2639_ = (_e2423 + countOneBits(((_e2406 & ~((4294967295u << bitcast<u32>((((_e2402 - 24u) ^ _e1298) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2639_ = 4294967295u;
                                                                }
                                                                let _e2426 = phi_2639_;
                                                                phi_2640_ = _e2426;
                                                            } else {
                                                                phi_2640_ = u32();
                                                            }
                                                            let _e2428 = phi_2640_;
                                                            phi_1633_ = _e2428;
                                                            let _e2894 = local_12;
                                                            phi_1636_ = _e2894;
                                                            let _e2897 = local_13;
                                                            phi_2641_ = _e2897;
                                                            phi_2642_ = false;
                                                        } else {
                                                            phi_1633_ = u32();
                                                            phi_1636_ = bool();
                                                            phi_2641_ = false;
                                                            phi_2642_ = true;
                                                        }
                                                        let _e2430 = phi_1633_;
                                                        let _e2432 = phi_1636_;
                                                        let _e2434 = phi_2641_;
                                                        let _e2436 = phi_2642_;
                                                        local_9 = _e2436;
                                                        continue;
                                                        continuing {
                                                            phi_1632_ = _e2430;
                                                            phi_1635_ = _e2432;
                                                            break if !(_e2434);
                                                        }
                                                    }
                                                    let _e2439 = local_9;
                                                    if _e2439 {
                                                        phi_2646_ = false;
                                                    } else {
                                                        phi_2646_ = true;
                                                    }
                                                    let _e2441 = phi_2646_;
                                                    if _e2441 {
                                                        phi_2650_ = true;
                                                    } else {
                                                        let _e2903 = local_14;
                                                        phi_2650_ = _e2903;
                                                    }
                                                    let _e2443 = phi_2650_;
                                                    phi_2651_ = _e2443;
                                                }
                                                let _e2445 = phi_2651_;
                                                phi_2652_ = _e2445;
                                                phi_2653_ = _e1120;
                                            } else {
                                                phi_2652_ = bool();
                                                phi_2653_ = true;
                                            }
                                            let _e2447 = phi_2652_;
                                            let _e2449 = phi_2653_;
                                            if _e2449 {
                                                phi_2657_ = _e915;
                                            } else {
                                                phi_2657_ = _e2447;
                                            }
                                            let _e2451 = phi_2657_;
                                            if _e2451 {
                                                phi_2661_ = false;
                                            } else {
                                                phi_2661_ = true;
                                            }
                                            let _e2453 = phi_2661_;
                                            phi_2662_ = _e2451;
                                            phi_2663_ = _e2453;
                                        } else {
                                            phi_2662_ = _e915;
                                            phi_2663_ = true;
                                        }
                                        let _e2455 = phi_2662_;
                                        let _e2457 = phi_2663_;
                                        phi_2664_ = _e2455;
                                        phi_2665_ = _e2457;
                                    } else {
                                        phi_2664_ = _e915;
                                        phi_2665_ = true;
                                    }
                                    let _e2459 = phi_2664_;
                                    let _e2461 = phi_2665_;
                                    phi_2666_ = _e2459;
                                    phi_2667_ = _e2461;
                                } else {
                                    phi_2666_ = _e915;
                                    phi_2667_ = true;
                                }
                                let _e2463 = phi_2666_;
                                let _e2465 = phi_2667_;
                                if _e2465 {
                                }
                                phi_1018_ = (_e913 & (_e913 - 1u));
                                phi_1021_ = _e2463;
                                phi_2671_ = _e2465;
                            }
                            let _e2467 = phi_1018_;
                            let _e2469 = phi_1021_;
                            let _e2471 = phi_2671_;
                            continue;
                            continuing {
                                phi_1017_ = _e2467;
                                phi_1020_ = _e2469;
                                break if !(_e2471);
                            }
                        }
                        let _e2474 = local_10;
                        if _e2474 {
                            let _e2476 = local_1.group_mask;
                            if ((_e2476 & 4278190080u) == 0u) {
                                let _e2480 = local_1.len;
                                if (_e2480 == 0u) {
                                    phi_2713_ = false;
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
                                    phi_2713_ = true;
                                }
                                let _e2503 = phi_2713_;
                                phi_2714_ = _e2503;
                            } else {
                                phi_2714_ = true;
                            }
                            let _e2505 = phi_2714_;
                            if _e2505 {
                                let _e2507 = local_1.group_mask;
                                let _e2513 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2507)), 32u, (_e2507 == 0u)));
                                let _e2517 = local_1.group_mask;
                                let _e2531 = local_1.group_mask;
                                local_1.group_mask = (_e2531 & ~((1u << bitcast<u32>((_e2513 & 31u)))));
                                let _e2534 = local_1.group;
                                phi_2745_ = (_e2534 + countOneBits(((_e2517 & ~((4294967295u << bitcast<u32>((((_e2513 - 24u) ^ _e337) & 31u))))) & 255u)));
                            } else {
                                phi_2745_ = 4294967295u;
                            }
                            let _e2537 = phi_2745_;
                            phi_2746_ = _e2537;
                        } else {
                            phi_2746_ = u32();
                        }
                        let _e2539 = phi_2746_;
                        phi_686_ = _e2539;
                        let _e2926 = local_15;
                        phi_689_ = _e2926;
                        let _e2929 = local_16;
                        phi_2747_ = _e2929;
                        phi_2748_ = false;
                    } else {
                        phi_686_ = u32();
                        phi_689_ = bool();
                        phi_2747_ = false;
                        phi_2748_ = true;
                    }
                    let _e2541 = phi_686_;
                    let _e2543 = phi_689_;
                    let _e2545 = phi_2747_;
                    let _e2547 = phi_2748_;
                    local_11 = _e2547;
                    continue;
                    continuing {
                        phi_685_ = _e2541;
                        phi_688_ = _e2543;
                        break if !(_e2545);
                    }
                }
                let _e2550 = local_11;
                if _e2550 {
                    phi_2752_ = false;
                } else {
                    phi_2752_ = true;
                }
                let _e2552 = phi_2752_;
                if _e2552 {
                }
                phi_2756_ = _e2552;
            }
            let _e2554 = phi_2756_;
            phi_2757_ = _e189;
            phi_2758_ = _e2554;
        } else {
            phi_2757_ = true;
            phi_2758_ = false;
        }
        let _e2556 = phi_2757_;
        let _e2558 = phi_2758_;
        if _e2556 {
            phi_2762_ = false;
            phi_2763_ = true;
        } else {
            phi_2762_ = true;
            phi_2763_ = _e2558;
        }
        let _e2560 = phi_2762_;
        let _e2562 = phi_2763_;
        if _e2562 {
            phi_2767_ = _e2560;
        } else {
            phi_2767_ = false;
        }
        let _e2564 = phi_2767_;
        if _e2564 {
            phi_2771_ = 0f;
        } else {
            phi_2771_ = 1f;
        }
        let _e2566 = phi_2771_;
        if (_e93 < _e70) {
        } else {
            return;
        }
        visibility.member[(0u + _e93)] = _e2566;
        let _e2572 = p.member.light.number;
        let _e2573 = (_e2572 * 3u);
        let _e2574 = (_e2573 / 32u);
        let _e2575 = (_e2573 % 32u);
        let _e2577 = p.member.light.mask_words;
        if (_e93 < _e70) {
        } else {
            return;
        }
        let _e2581 = visibility.member[(0u + _e93)];
        let _e2583 = ((_e93 * _e2577) + _e2574);
        if (_e2575 > 29u) {
            let _e2585 = (_e2583 + 1u);
            if (_e2585 < _e76) {
            } else {
                return;
            }
            let _e2589 = bits.member[(0u + _e2585)];
            phi_2812_ = _e2589;
        } else {
            phi_2812_ = 0u;
        }
        let _e2591 = phi_2812_;
        if (_e2583 < _e76) {
        } else {
            return;
        }
        let _e2595 = bits.member[(0u + _e2583)];
        let _e2598 = (_e2595 >> bitcast<u32>((_e2575 & 31u)));
        if (_e2575 > 29u) {
            phi_2831_ = (_e2598 | (_e2591 << bitcast<u32>(((32u - _e2575) & 31u))));
        } else {
            phi_2831_ = _e2598;
        }
        let _e2606 = phi_2831_;
        if ((_e2606 & 2u) == 0u) {
            phi_2839_ = (_e2606 & 1u);
        } else {
            phi_2839_ = (_e2606 & 7u);
        }
        let _e2612 = phi_2839_;
        if ((_e2612 & 1u) != 0u) {
            phi_2847_ = (2u | 1u);
        } else {
            phi_2847_ = 2u;
        }
        let _e2618 = phi_2847_;
        if (_e2581 < 0.5f) {
            phi_2852_ = (_e2618 | 4u);
        } else {
            phi_2852_ = _e2618;
        }
        let _e2621 = phi_2852_;
        let _e2623 = ((_e93 * _e2577) + _e2574);
        if (_e2623 < _e76) {
        } else {
            return;
        }
        let _e2627 = bits.member[(0u + _e2623)];
        if (_e2623 < _e76) {
        } else {
            return;
        }
        bits.member[(0u + _e2623)] = ((_e2627 & ~((7u << bitcast<u32>((_e2575 & 31u))))) | (_e2621 << bitcast<u32>((_e2575 & 31u))));
        if (_e2575 > 29u) {
            let _e2641 = (_e2623 + 1u);
            if (_e2641 < _e76) {
            } else {
                return;
            }
            let _e2645 = bits.member[(0u + _e2641)];
            let _e2646 = (32u - _e2575);
            let _e2656 = (_e2623 + 1u);
            if (_e2656 < _e76) {
            } else {
                return;
            }
            bits.member[(0u + _e2656)] = ((_e2645 & ~((7u >> bitcast<u32>((_e2646 & 31u))))) | (_e2621 >> bitcast<u32>((_e2646 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
