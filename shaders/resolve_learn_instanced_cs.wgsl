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

struct type_30 {
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

struct type_37 {
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

struct type_46 {
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

struct type_52 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_52;
@group(0) @binding(2) 
var<storage> nodes: type_46;
@group(0) @binding(3) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage, read_write> bits: type_13;
@group(0) @binding(7) 
var<storage> instances: type_37;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_165_: bool;
    var phi_169_: f32;

    if (param != param) {
        phi_165_ = true;
    } else {
        let _e56 = (param_1 >= param);
        if _e56 {
        }
        phi_165_ = _e56;
    }
    let _e58 = phi_165_;
    if _e58 {
        phi_169_ = param_1;
    } else {
        phi_169_ = param;
    }
    let _e60 = phi_169_;
    return _e60;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_181_: bool;
    var phi_185_: f32;

    if (param_2 != param_2) {
        phi_181_ = true;
    } else {
        let _e56 = (param_3 <= param_2);
        if _e56 {
        }
        phi_181_ = _e56;
    }
    let _e58 = phi_181_;
    if _e58 {
        phi_185_ = param_3;
    } else {
        phi_185_ = param_2;
    }
    let _e60 = phi_185_;
    return _e60;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_269_: f32;
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
    var phi_426_: f32;
    var phi_433_: f32;
    var phi_440_: f32;
    var phi_447_: f32;
    var phi_454_: f32;
    var phi_461_: f32;
    var phi_478_: f32;
    var phi_483_: f32;
    var phi_488_: f32;
    var phi_509_: u32;
    var phi_514_: u32;
    var phi_519_: u32;
    var phi_633_: bool;
    var phi_634_: bool;
    var phi_665_: u32;
    var phi_667_: u32;
    var phi_748_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_775_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_802_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_808_: u32;
    var phi_811_: u32;
    var phi_825_: u32;
    var phi_835_: u32;
    var phi_845_: u32;
    var phi_863_: u32;
    var phi_873_: u32;
    var phi_883_: u32;
    var phi_919_: u32;
    var phi_932_: u32;
    var phi_937_: u32;
    var phi_938_: u32;
    var phi_939_: u32;
    var phi_809_: u32;
    var phi_812_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_997_: u32;
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
    var phi_1684_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1711_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1738_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1744_: u32;
    var phi_1747_: u32;
    var phi_1761_: u32;
    var phi_1771_: u32;
    var phi_1781_: u32;
    var phi_1799_: u32;
    var phi_1809_: u32;
    var phi_1819_: u32;
    var phi_1855_: u32;
    var phi_1868_: u32;
    var phi_1873_: u32;
    var phi_1874_: u32;
    var phi_1875_: u32;
    var phi_1745_: u32;
    var phi_1748_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1933_: u32;
    var phi_1978_: vec3<f32>;
    var phi_1979_: vec3<f32>;
    var phi_2010_: vec3<f32>;
    var phi_2011_: vec3<f32>;
    var phi_2042_: vec3<f32>;
    var phi_2043_: vec3<f32>;
    var phi_2063_: bool;
    var phi_2064_: bool;
    var phi_2068_: f32;
    var phi_2069_: f32;
    var phi_2070_: f32;
    var phi_2071_: f32;
    var phi_2079_: f32;
    var phi_2089_: bool;
    var phi_2090_: bool;
    var phi_2094_: f32;
    var phi_2095_: f32;
    var phi_2096_: f32;
    var phi_2097_: f32;
    var phi_2105_: f32;
    var phi_2115_: bool;
    var phi_2116_: bool;
    var phi_2120_: f32;
    var phi_2121_: f32;
    var phi_2122_: f32;
    var phi_2123_: f32;
    var phi_2131_: f32;
    var phi_2146_: f32;
    var phi_2147_: bool;
    var phi_2148_: f32;
    var phi_2149_: bool;
    var phi_2150_: f32;
    var phi_2151_: bool;
    var phi_2169_: f32;
    var phi_2170_: bool;
    var phi_2171_: bool;
    var phi_2172_: f32;
    var phi_2173_: bool;
    var phi_2174_: bool;
    var phi_2178_: bool;
    var phi_2179_: f32;
    var phi_2180_: bool;
    var phi_2214_: f32;
    var phi_2223_: f32;
    var phi_2232_: f32;
    var phi_2241_: f32;
    var phi_2248_: f32;
    var phi_2255_: f32;
    var phi_2268_: f32;
    var phi_2277_: f32;
    var phi_2286_: f32;
    var phi_2295_: f32;
    var phi_2302_: f32;
    var phi_2309_: f32;
    var phi_2326_: f32;
    var phi_2331_: f32;
    var phi_2336_: f32;
    var phi_2344_: f32;
    var phi_2349_: f32;
    var phi_2354_: f32;
    var phi_2366_: f32;
    var phi_2371_: f32;
    var phi_2376_: f32;
    var phi_2381_: f32;
    var phi_2386_: lt_bvh_triangle_Intersection;
    var phi_2387_: bool;
    var phi_2388_: lt_bvh_triangle_Intersection;
    var phi_2389_: bool;
    var phi_2393_: lt_bvh_triangle_Intersection;
    var phi_2394_: bool;
    var phi_2395_: lt_bvh_triangle_Intersection;
    var phi_2396_: bool;
    var phi_2397_: bool;
    var phi_2401_: bool;
    var phi_2405_: lt_bvh_triangle_Intersection;
    var phi_2430_: bool;
    var phi_2431_: bool;
    var phi_2432_: bool;
    var phi_2433_: bool;
    var phi_2434_: bool;
    var phi_2435_: bool;
    var phi_2436_: bool;
    var phi_2437_: bool;
    var phi_2438_: bool;
    var phi_2439_: bool;
    var phi_2440_: bool;
    var phi_2441_: bool;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var phi_1934_: u32;
    var phi_2447_: bool;
    var phi_2448_: bool;
    var phi_2449_: bool;
    var local_8: bool;
    var phi_2491_: bool;
    var phi_2492_: bool;
    var phi_2523_: u32;
    var phi_2524_: u32;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_1604_: u32;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_2530_: bool;
    var local_9: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2539_: bool;
    var phi_2543_: bool;
    var phi_2544_: bool;
    var phi_2545_: bool;
    var phi_2546_: bool;
    var phi_2550_: bool;
    var phi_2554_: bool;
    var phi_2555_: bool;
    var phi_2556_: bool;
    var phi_2557_: bool;
    var phi_998_: u32;
    var phi_2561_: bool;
    var local_10: bool;
    var phi_2603_: bool;
    var phi_2604_: bool;
    var phi_2635_: u32;
    var phi_2636_: u32;
    var phi_668_: u32;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var local_11: bool;
    var phi_2642_: bool;
    var phi_2646_: bool;
    var phi_2647_: bool;
    var phi_2648_: bool;
    var phi_2649_: bool;
    var phi_2653_: bool;
    var phi_2657_: f32;
    var phi_2678_: u32;
    var phi_2693_: u32;
    var phi_2698_: u32;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;

    let _e55 = id_1;
    let _e62 = arrayLength((&nodes.member));
    let _e68 = arrayLength((&visibility.member));
    let _e71 = arrayLength((&list.member));
    let _e74 = arrayLength((&bits.member));
    let _e81 = ((_e55.y * 2097152u) + _e55.x);
    if (3u < _e71) {
    } else {
        return;
    }
    let _e84 = list.member[3u];
    if (_e81 < _e84) {
        let _e86 = (_e81 + 4u);
        if (_e86 < _e71) {
        } else {
            return;
        }
        let _e90 = list.member[(0u + _e86)];
        let _e92 = p.member.root;
        if (_e90 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e97 = p.member.light;
        let _e99 = samples.member[(0u + _e90)].position;
        let _e101 = samples.member[(0u + _e90)].normal;
        let _e103 = samples.member[(0u + _e90)].magnitude;
        let _e105 = ((8f / 8388608f) * _e103);
        let _e113 = (_e99.x + (_e101.x * _e105));
        let _e115 = (_e99.y + (_e101.y * _e105));
        let _e117 = (_e99.z + (_e101.z * _e105));
        if (_e97.w == 0f) {
            phi_269_ = 300000000000000000000000000000000000000f;
        } else {
            phi_269_ = 1f;
        }
        let _e121 = phi_269_;
        let _e129 = (_e97.x - (_e113 * _e97.w));
        let _e130 = (_e97.y - (_e115 * _e97.w));
        let _e131 = (_e97.z - (_e117 * _e97.w));
        let _e135 = abs(_e129);
        let _e136 = abs(_e130);
        let _e137 = abs(_e131);
        if (abs(_e113) < 1000000000000000f) {
            if (abs(_e115) < 1000000000000000f) {
                if (abs(_e117) < 1000000000000000f) {
                    if (_e135 < 1000000000000000f) {
                        if (_e136 < 1000000000000000f) {
                            if (_e137 < 1000000000000000f) {
                                if (_e135 > 0f) {
                                    phi_326_ = bool();
                                    phi_327_ = true;
                                } else {
                                    let _e145 = (_e136 > 0f);
                                    if _e145 {
                                        phi_325_ = bool();
                                    } else {
                                        phi_325_ = (_e137 > 0f);
                                    }
                                    let _e148 = phi_325_;
                                    phi_326_ = _e148;
                                    phi_327_ = _e145;
                                }
                                let _e150 = phi_326_;
                                let _e152 = phi_327_;
                                if _e152 {
                                    phi_331_ = true;
                                } else {
                                    phi_331_ = _e150;
                                }
                                let _e154 = phi_331_;
                                phi_332_ = _e154;
                                phi_333_ = false;
                            } else {
                                phi_332_ = bool();
                                phi_333_ = true;
                            }
                            let _e156 = phi_332_;
                            let _e158 = phi_333_;
                            phi_334_ = _e156;
                            phi_335_ = false;
                            phi_336_ = _e158;
                        } else {
                            phi_334_ = bool();
                            phi_335_ = true;
                            phi_336_ = false;
                        }
                        let _e160 = phi_334_;
                        let _e162 = phi_335_;
                        let _e164 = phi_336_;
                        phi_337_ = _e160;
                        phi_338_ = _e162;
                        phi_339_ = _e164;
                    } else {
                        phi_337_ = bool();
                        phi_338_ = true;
                        phi_339_ = false;
                    }
                    let _e166 = phi_337_;
                    let _e168 = phi_338_;
                    let _e170 = phi_339_;
                    phi_340_ = _e166;
                    phi_341_ = _e168;
                    phi_342_ = _e170;
                } else {
                    phi_340_ = bool();
                    phi_341_ = true;
                    phi_342_ = false;
                }
                let _e172 = phi_340_;
                let _e174 = phi_341_;
                let _e176 = phi_342_;
                phi_343_ = _e172;
                phi_344_ = _e174;
                phi_345_ = _e176;
            } else {
                phi_343_ = bool();
                phi_344_ = true;
                phi_345_ = false;
            }
            let _e178 = phi_343_;
            let _e180 = phi_344_;
            let _e182 = phi_345_;
            phi_346_ = _e178;
            phi_347_ = _e180;
            phi_348_ = _e182;
        } else {
            phi_346_ = bool();
            phi_347_ = true;
            phi_348_ = false;
        }
        let _e184 = phi_346_;
        let _e186 = phi_347_;
        let _e188 = phi_348_;
        if _e186 {
            phi_352_ = true;
        } else {
            phi_352_ = _e188;
        }
        let _e190 = phi_352_;
        if _e190 {
            phi_356_ = false;
        } else {
            phi_356_ = _e184;
        }
        let _e192 = phi_356_;
        if _e192 {
            let _e193 = (_e92 >= _e62);
            if _e193 {
                phi_2647_ = bool();
            } else {
                if (_e92 < _e62) {
                } else {
                    return;
                }
                let _e199 = nodes.member[(0u + _e92)].frame[0u];
                let _e203 = nodes.member[(0u + _e92)].frame[1u];
                let _e207 = nodes.member[(0u + _e92)].frame[2u];
                let _e211 = nodes.member[(0u + _e92)].frame[0u];
                let _e215 = nodes.member[(0u + _e92)].frame[1u];
                let _e219 = nodes.member[(0u + _e92)].frame[2u];
                let _e223 = nodes.member[(0u + _e92)].frame[3u];
                let _e257 = core_intrinsics_maximum_number_nsz_f32_(abs(_e129), abs(_e130));
                let _e258 = core_intrinsics_maximum_number_nsz_f32_(_e257, abs(_e131));
                let _e259 = (_e258 * 0.0000000000009094947f);
                if (abs(_e129) < _e259) {
                    phi_426_ = _e259;
                } else {
                    phi_426_ = abs(_e129);
                }
                let _e264 = phi_426_;
                if (_e129 < 0f) {
                    phi_433_ = (-1f / _e264);
                } else {
                    phi_433_ = (1f / _e264);
                }
                let _e269 = phi_433_;
                if (abs(_e130) < _e259) {
                    phi_440_ = _e259;
                } else {
                    phi_440_ = abs(_e130);
                }
                let _e274 = phi_440_;
                if (_e130 < 0f) {
                    phi_447_ = (-1f / _e274);
                } else {
                    phi_447_ = (1f / _e274);
                }
                let _e279 = phi_447_;
                if (abs(_e131) < _e259) {
                    phi_454_ = _e259;
                } else {
                    phi_454_ = abs(_e131);
                }
                let _e284 = phi_454_;
                if (_e131 < 0f) {
                    phi_461_ = (-1f / _e284);
                } else {
                    phi_461_ = (1f / _e284);
                }
                let _e289 = phi_461_;
                let _e293 = abs((bitcast<f32>(_e199) - _e113));
                let _e294 = abs((bitcast<f32>(_e203) - _e115));
                let _e295 = abs((bitcast<f32>(_e207) - _e117));
                let _e299 = abs(((bitcast<f32>(_e211) + (bitcast<f32>((((_e223 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e113));
                let _e300 = abs(((bitcast<f32>(_e215) + (bitcast<f32>((((_e223 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e115));
                let _e301 = abs(((bitcast<f32>(_e219) + (bitcast<f32>((((_e223 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e117));
                if (_e293 > _e299) {
                    phi_478_ = _e293;
                } else {
                    phi_478_ = _e299;
                }
                let _e304 = phi_478_;
                if (_e294 > _e300) {
                    phi_483_ = _e294;
                } else {
                    phi_483_ = _e300;
                }
                let _e307 = phi_483_;
                if (_e295 > _e301) {
                    phi_488_ = _e295;
                } else {
                    phi_488_ = _e301;
                }
                let _e310 = phi_488_;
                let _e311 = core_intrinsics_maximum_number_nsz_f32_(_e304, _e307);
                let _e312 = core_intrinsics_maximum_number_nsz_f32_(_e311, _e310);
                let _e316 = (_e312 * 0.0000019073486f);
                let _e317 = (abs(_e269) * _e316);
                let _e318 = (abs(_e279) * _e316);
                let _e319 = (abs(_e289) * _e316);
                let _e323 = (_e312 * 0.0000009536743f);
                let _e324 = (abs(_e269) * _e323);
                let _e325 = (abs(_e279) * _e323);
                let _e326 = (abs(_e289) * _e323);
                if (_e269 < 0f) {
                    phi_509_ = 0u;
                } else {
                    phi_509_ = 1u;
                }
                let _e329 = phi_509_;
                if (_e279 < 0f) {
                    phi_514_ = 0u;
                } else {
                    phi_514_ = 2u;
                }
                let _e332 = phi_514_;
                if (_e289 < 0f) {
                    phi_519_ = 0u;
                } else {
                    phi_519_ = 4u;
                }
                let _e335 = phi_519_;
                let _e337 = ((_e329 | _e332) | _e335);
                let _e338 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e92, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e338.first[0], _e338.first[1], _e338.first[2], _e338.first[3], _e338.first[4], _e338.first[5], _e338.first[6], _e338.first[7], _e338.first[8], _e338.first[9], _e338.first[10], _e338.first[11], _e338.first[12], _e338.first[13], _e338.first[14], _e338.first[15], _e338.first[16], _e338.first[17], _e338.first[18], _e338.first[19], _e338.first[20], _e338.first[21], _e338.first[22], _e338.first[23], _e338.first[24], _e338.first[25], _e338.first[26], _e338.first[27], _e338.first[28], _e338.first[29], _e338.first[30], _e338.first[31]), array<u32, 32>(_e338.mask[0], _e338.mask[1], _e338.mask[2], _e338.mask[3], _e338.mask[4], _e338.mask[5], _e338.mask[6], _e338.mask[7], _e338.mask[8], _e338.mask[9], _e338.mask[10], _e338.mask[11], _e338.mask[12], _e338.mask[13], _e338.mask[14], _e338.mask[15], _e338.mask[16], _e338.mask[17], _e338.mask[18], _e338.mask[19], _e338.mask[20], _e338.mask[21], _e338.mask[22], _e338.mask[23], _e338.mask[24], _e338.mask[25], _e338.mask[26], _e338.mask[27], _e338.mask[28], _e338.mask[29], _e338.mask[30], _e338.mask[31]), _e338.len, _e338.group, _e338.group_mask);
                let _e412 = local_1.group_mask;
                if ((_e412 & 4278190080u) == 0u) {
                    let _e416 = local_1.len;
                    if (_e416 == 0u) {
                        phi_633_ = false;
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
                        phi_633_ = true;
                    }
                    let _e439 = phi_633_;
                    phi_634_ = _e439;
                } else {
                    phi_634_ = true;
                }
                let _e441 = phi_634_;
                if _e441 {
                    let _e443 = local_1.group_mask;
                    let _e449 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e443)), 32u, (_e443 == 0u)));
                    let _e453 = local_1.group_mask;
                    let _e467 = local_1.group_mask;
                    local_1.group_mask = (_e467 & ~((1u << bitcast<u32>((_e449 & 31u)))));
                    let _e470 = local_1.group;
                    phi_665_ = (_e470 + countOneBits(((_e453 & ~((4294967295u << bitcast<u32>((((_e449 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_665_ = 4294967295u;
                }
                let _e473 = phi_665_;
                phi_667_ = _e473;
                loop {
                    let _e475 = phi_667_;
                    if (_e475 != 4294967295u) {
                        if (_e475 < _e62) {
                        } else {
                            return;
                        }
                        let _e482 = nodes.member[(0u + _e475)].frame[3u];
                        let _e507 = (bitcast<f32>((((_e482 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e269);
                        let _e508 = (bitcast<f32>((((_e482 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e279);
                        let _e509 = (bitcast<f32>((((_e482 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e289);
                        let _e512 = nodes.member[(0u + _e475)].frame[0u];
                        let _e516 = nodes.member[(0u + _e475)].frame[1u];
                        let _e520 = nodes.member[(0u + _e475)].frame[2u];
                        let _e525 = ((bitcast<f32>(_e512) - _e113) * _e269);
                        let _e526 = ((bitcast<f32>(_e516) - _e115) * _e279);
                        let _e527 = ((bitcast<f32>(_e520) - _e117) * _e289);
                        let _e535 = nodes.member[(0u + _e475)].x;
                        if (_e269 < 0f) {
                            let _e546 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e535.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e552 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e546.unnamed.root, _e535.w), _e546.unnamed_1);
                            let _e558 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e552.unnamed, lt_bvh_traverse_Tree(_e535.x, _e552.unnamed_1.first_primitive));
                            phi_748_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e558.unnamed, lt_bvh_traverse_Tree(_e558.unnamed_1.root, _e535.y));
                        } else {
                            let _e574 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e535.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e574.unnamed.root, _e535.y), _e574.unnamed_1);
                            let _e586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e580.unnamed, lt_bvh_traverse_Tree(_e535.z, _e580.unnamed_1.first_primitive));
                            phi_748_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e586.unnamed, lt_bvh_traverse_Tree(_e586.unnamed_1.root, _e535.w));
                        }
                        let _e594 = phi_748_;
                        let _e604 = nodes.member[(0u + _e475)].y;
                        if (_e279 < 0f) {
                            let _e615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e604.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e615.unnamed.root, _e604.w), _e615.unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e621.unnamed, lt_bvh_traverse_Tree(_e604.x, _e621.unnamed_1.first_primitive));
                            phi_775_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_bvh_traverse_Tree(_e627.unnamed_1.root, _e604.y));
                        } else {
                            let _e643 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e604.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e643.unnamed.root, _e604.y), _e643.unnamed_1);
                            let _e655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e649.unnamed, lt_bvh_traverse_Tree(_e604.z, _e649.unnamed_1.first_primitive));
                            phi_775_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e655.unnamed, lt_bvh_traverse_Tree(_e655.unnamed_1.root, _e604.w));
                        }
                        let _e663 = phi_775_;
                        let _e673 = nodes.member[(0u + _e475)].z;
                        if (_e289 < 0f) {
                            let _e684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e684.unnamed.root, _e673.w), _e684.unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e690.unnamed, lt_bvh_traverse_Tree(_e673.x, _e690.unnamed_1.first_primitive));
                            phi_802_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_bvh_traverse_Tree(_e696.unnamed_1.root, _e673.y));
                        } else {
                            let _e712 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e673.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e712.unnamed.root, _e673.y), _e712.unnamed_1);
                            let _e724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e718.unnamed, lt_bvh_traverse_Tree(_e673.z, _e718.unnamed_1.first_primitive));
                            phi_802_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e724.unnamed, lt_bvh_traverse_Tree(_e724.unnamed_1.root, _e673.w));
                        }
                        let _e732 = phi_802_;
                        phi_808_ = 0u;
                        phi_811_ = 0u;
                        loop {
                            let _e742 = phi_808_;
                            let _e744 = phi_811_;
                            local_2 = _e744;
                            local_3 = _e744;
                            local_4 = _e744;
                            let _e745 = (_e742 < 8u);
                            if _e745 {
                                let _e747 = (_e742 >> bitcast<u32>(2i));
                                let _e748 = (_e742 & 3u);
                                if (_e747 == 0u) {
                                    phi_825_ = _e594.unnamed.root;
                                } else {
                                    phi_825_ = _e594.unnamed.first_primitive;
                                }
                                let _e751 = phi_825_;
                                if (_e747 == 0u) {
                                    phi_835_ = _e663.unnamed.root;
                                } else {
                                    phi_835_ = _e663.unnamed.first_primitive;
                                }
                                let _e760 = phi_835_;
                                if (_e747 == 0u) {
                                    phi_845_ = _e732.unnamed.root;
                                } else {
                                    phi_845_ = _e732.unnamed.first_primitive;
                                }
                                let _e769 = phi_845_;
                                let _e782 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e751 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 - _e317)), ((f32(((_e760 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 - _e318)));
                                let _e783 = core_intrinsics_maximum_number_nsz_f32_(_e782, ((f32(((_e769 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 - _e319)));
                                if (_e747 == 0u) {
                                    phi_863_ = _e594.unnamed_1.root;
                                } else {
                                    phi_863_ = _e594.unnamed_1.first_primitive;
                                }
                                let _e786 = phi_863_;
                                if (_e747 == 0u) {
                                    phi_873_ = _e663.unnamed_1.root;
                                } else {
                                    phi_873_ = _e663.unnamed_1.first_primitive;
                                }
                                let _e795 = phi_873_;
                                if (_e747 == 0u) {
                                    phi_883_ = _e732.unnamed_1.root;
                                } else {
                                    phi_883_ = _e732.unnamed_1.first_primitive;
                                }
                                let _e804 = phi_883_;
                                let _e817 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e786 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e507) + (_e525 + _e317)), ((f32(((_e795 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e508) + (_e526 + _e318)));
                                let _e818 = core_intrinsics_minimum_number_nsz_f32_(_e817, ((f32(((_e804 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u)) * _e509) + (_e527 + _e319)));
                                if (_e783 <= _e818) {
                                    if (_e783 <= _e121) {
                                        if (_e818 >= 0f) {
                                            if (_e747 == 0u) {
                                                let _e825 = nodes.member[(0u + _e475)].links[2u];
                                                phi_919_ = _e825;
                                            } else {
                                                let _e828 = nodes.member[(0u + _e475)].links[3u];
                                                phi_919_ = _e828;
                                            }
                                            let _e830 = phi_919_;
                                            let _e835 = ((_e830 >> bitcast<u32>(((_e748 * 8u) & 31u))) & 255u);
                                            let _e836 = (_e835 & 31u);
                                            if (_e836 >= 24u) {
                                                phi_932_ = (24u + ((_e836 - 24u) ^ _e337));
                                            } else {
                                                phi_932_ = _e836;
                                            }
                                            let _e842 = phi_932_;
                                            phi_937_ = (_e744 | ((_e835 >> bitcast<u32>(5i)) << bitcast<u32>((_e842 & 31u))));
                                        } else {
                                            phi_937_ = _e744;
                                        }
                                        let _e850 = phi_937_;
                                        phi_938_ = _e850;
                                    } else {
                                        phi_938_ = _e744;
                                    }
                                    let _e852 = phi_938_;
                                    phi_939_ = _e852;
                                } else {
                                    phi_939_ = _e744;
                                }
                                let _e854 = phi_939_;
                                phi_809_ = (_e742 + 1u);
                                phi_812_ = _e854;
                            } else {
                                phi_809_ = u32();
                                phi_812_ = u32();
                            }
                            let _e857 = phi_809_;
                            let _e859 = phi_812_;
                            continue;
                            continuing {
                                phi_808_ = _e857;
                                phi_811_ = _e859;
                                break if !(_e745);
                            }
                        }
                        let _e863 = nodes.member[(0u + _e475)].links[0u];
                        let _e867 = nodes.member[(0u + _e475)].frame[3u];
                        let _e871 = local_2;
                        if ((_e871 & 4278190080u) == 0u) {
                        } else {
                            let _e875 = local_1.group_mask;
                            if ((_e875 & 4278190080u) == 0u) {
                            } else {
                                let _e879 = local_1.len;
                                if (_e879 < 32u) {
                                    let _e882 = local_1.group;
                                    let _e884 = local_1.len;
                                    if (_e884 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e884)] = _e882;
                                    let _e890 = local_1.group_mask;
                                    let _e892 = local_1.len;
                                    if (_e892 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e892)] = _e890;
                                    let _e899 = local_1.len;
                                    local_1.len = (_e899 + 1u);
                                }
                            }
                            local_1.group = (_e92 + _e863);
                            let _e903 = local_3;
                            local_1.group_mask = ((_e903 & 4278190080u) | (_e867 >> bitcast<u32>(24i)));
                        }
                        let _e908 = local_4;
                        phi_997_ = (_e908 & 16777215u);
                        loop {
                            let _e911 = phi_997_;
                            let _e912 = (_e911 == 0u);
                            local_10 = _e912;
                            local_17 = _e912;
                            if _e912 {
                                phi_998_ = u32();
                                phi_2561_ = false;
                            } else {
                                let _e915 = nodes.member[(0u + _e475)].links[1u];
                                let _e919 = (_e915 + select(firstTrailingBit(_e911), 32u, (_e911 == 0u)));
                                if (_e919 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e926 = instances.member[(0u + _e919)].low_world;
                                let _e928 = instances.member[(0u + _e919)].high_world;
                                let _e935 = ((_e926.x - _e113) * _e269);
                                let _e936 = ((_e926.y - _e115) * _e279);
                                let _e937 = ((_e926.z - _e117) * _e289);
                                let _e944 = ((_e928.x - _e113) * _e269);
                                let _e945 = ((_e928.y - _e115) * _e279);
                                let _e946 = ((_e928.z - _e117) * _e289);
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
                                let _e971 = core_intrinsics_maximum_number_nsz_f32_((_e949 - _e324), (_e952 - _e325));
                                let _e972 = core_intrinsics_maximum_number_nsz_f32_(_e971, (_e955 - _e326));
                                let _e973 = core_intrinsics_minimum_number_nsz_f32_((_e961 + _e324), (_e964 + _e325));
                                let _e974 = core_intrinsics_minimum_number_nsz_f32_(_e973, (_e967 + _e326));
                                if (_e972 <= _e974) {
                                    if (_e972 <= _e121) {
                                        if (_e974 >= 0f) {
                                            let _e980 = instances.member[(0u + _e919)].world_to_object[0u];
                                            let _e991 = ((((_e980.x * _e113) + (_e980.y * _e115)) + (_e980.z * _e117)) + (_e980.w * 1f));
                                            let _e993 = instances.member[(0u + _e919)].world_to_object[1u];
                                            let _e1004 = ((((_e993.x * _e113) + (_e993.y * _e115)) + (_e993.z * _e117)) + (_e993.w * 1f));
                                            let _e1006 = instances.member[(0u + _e919)].world_to_object[2u];
                                            let _e1017 = ((((_e1006.x * _e113) + (_e1006.y * _e115)) + (_e1006.z * _e117)) + (_e1006.w * 1f));
                                            let _e1020 = instances.member[(0u + _e919)].world_to_object[0u];
                                            let _e1031 = ((((_e1020.x * _e129) + (_e1020.y * _e130)) + (_e1020.z * _e131)) + (_e1020.w * 0f));
                                            let _e1033 = instances.member[(0u + _e919)].world_to_object[1u];
                                            let _e1044 = ((((_e1033.x * _e129) + (_e1033.y * _e130)) + (_e1033.z * _e131)) + (_e1033.w * 0f));
                                            let _e1046 = instances.member[(0u + _e919)].world_to_object[2u];
                                            let _e1057 = ((((_e1046.x * _e129) + (_e1046.y * _e130)) + (_e1046.z * _e131)) + (_e1046.w * 0f));
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
                                                let _e1124 = (_e1060 >= _e62);
                                                if _e1124 {
                                                    phi_2544_ = bool();
                                                } else {
                                                    if (_e1060 < _e62) {
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
                                                    let _e1287 = (1f / _e1279.z);
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
                                                    loop {
                                                        let _e1436 = phi_1603_;
                                                        if (_e1436 != 4294967295u) {
                                                            if (_e1436 < _e62) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1443 = nodes.member[(0u + _e1436)].frame[3u];
                                                            let _e1468 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1200);
                                                            let _e1469 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1210);
                                                            let _e1470 = (bitcast<f32>((((_e1443 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1220);
                                                            let _e1473 = nodes.member[(0u + _e1436)].frame[0u];
                                                            let _e1477 = nodes.member[(0u + _e1436)].frame[1u];
                                                            let _e1481 = nodes.member[(0u + _e1436)].frame[2u];
                                                            let _e1486 = ((bitcast<f32>(_e1473) - _e991) * _e1200);
                                                            let _e1487 = ((bitcast<f32>(_e1477) - _e1004) * _e1210);
                                                            let _e1488 = ((bitcast<f32>(_e1481) - _e1017) * _e1220);
                                                            let _e1496 = nodes.member[(0u + _e1436)].x;
                                                            if (_e1200 < 0f) {
                                                                let _e1507 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1496.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1513 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1507.unnamed.root, _e1496.w), _e1507.unnamed_1);
                                                                let _e1519 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1513.unnamed, lt_bvh_traverse_Tree(_e1496.x, _e1513.unnamed_1.first_primitive));
                                                                phi_1684_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1519.unnamed, lt_bvh_traverse_Tree(_e1519.unnamed_1.root, _e1496.y));
                                                            } else {
                                                                let _e1535 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1496.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1541 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1535.unnamed.root, _e1496.y), _e1535.unnamed_1);
                                                                let _e1547 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1541.unnamed, lt_bvh_traverse_Tree(_e1496.z, _e1541.unnamed_1.first_primitive));
                                                                phi_1684_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1547.unnamed, lt_bvh_traverse_Tree(_e1547.unnamed_1.root, _e1496.w));
                                                            }
                                                            let _e1555 = phi_1684_;
                                                            let _e1565 = nodes.member[(0u + _e1436)].y;
                                                            if (_e1210 < 0f) {
                                                                let _e1576 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1565.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1582 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1576.unnamed.root, _e1565.w), _e1576.unnamed_1);
                                                                let _e1588 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1582.unnamed, lt_bvh_traverse_Tree(_e1565.x, _e1582.unnamed_1.first_primitive));
                                                                phi_1711_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1588.unnamed, lt_bvh_traverse_Tree(_e1588.unnamed_1.root, _e1565.y));
                                                            } else {
                                                                let _e1604 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1565.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1610 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1604.unnamed.root, _e1565.y), _e1604.unnamed_1);
                                                                let _e1616 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1610.unnamed, lt_bvh_traverse_Tree(_e1565.z, _e1610.unnamed_1.first_primitive));
                                                                phi_1711_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1616.unnamed, lt_bvh_traverse_Tree(_e1616.unnamed_1.root, _e1565.w));
                                                            }
                                                            let _e1624 = phi_1711_;
                                                            let _e1634 = nodes.member[(0u + _e1436)].z;
                                                            if (_e1220 < 0f) {
                                                                let _e1645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1634.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1645.unnamed.root, _e1634.w), _e1645.unnamed_1);
                                                                let _e1657 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1651.unnamed, lt_bvh_traverse_Tree(_e1634.x, _e1651.unnamed_1.first_primitive));
                                                                phi_1738_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1657.unnamed, lt_bvh_traverse_Tree(_e1657.unnamed_1.root, _e1634.y));
                                                            } else {
                                                                let _e1673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1634.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1673.unnamed.root, _e1634.y), _e1673.unnamed_1);
                                                                let _e1685 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1679.unnamed, lt_bvh_traverse_Tree(_e1634.z, _e1679.unnamed_1.first_primitive));
                                                                phi_1738_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1685.unnamed, lt_bvh_traverse_Tree(_e1685.unnamed_1.root, _e1634.w));
                                                            }
                                                            let _e1693 = phi_1738_;
                                                            phi_1744_ = 0u;
                                                            phi_1747_ = 0u;
                                                            loop {
                                                                let _e1703 = phi_1744_;
                                                                let _e1705 = phi_1747_;
                                                                local_5 = _e1705;
                                                                local_6 = _e1705;
                                                                local_7 = _e1705;
                                                                let _e1706 = (_e1703 < 8u);
                                                                if _e1706 {
                                                                    let _e1708 = (_e1703 >> bitcast<u32>(2i));
                                                                    let _e1709 = (_e1703 & 3u);
                                                                    if (_e1708 == 0u) {
                                                                        phi_1761_ = _e1555.unnamed.root;
                                                                    } else {
                                                                        phi_1761_ = _e1555.unnamed.first_primitive;
                                                                    }
                                                                    let _e1712 = phi_1761_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1771_ = _e1624.unnamed.root;
                                                                    } else {
                                                                        phi_1771_ = _e1624.unnamed.first_primitive;
                                                                    }
                                                                    let _e1721 = phi_1771_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1781_ = _e1693.unnamed.root;
                                                                    } else {
                                                                        phi_1781_ = _e1693.unnamed.first_primitive;
                                                                    }
                                                                    let _e1730 = phi_1781_;
                                                                    let _e1743 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1712 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 - _e1248)), ((f32(((_e1721 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1249)));
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(_e1743, ((f32(((_e1730 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1250)));
                                                                    if (_e1708 == 0u) {
                                                                        phi_1799_ = _e1555.unnamed_1.root;
                                                                    } else {
                                                                        phi_1799_ = _e1555.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1747 = phi_1799_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1809_ = _e1624.unnamed_1.root;
                                                                    } else {
                                                                        phi_1809_ = _e1624.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1756 = phi_1809_;
                                                                    if (_e1708 == 0u) {
                                                                        phi_1819_ = _e1693.unnamed_1.root;
                                                                    } else {
                                                                        phi_1819_ = _e1693.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1765 = phi_1819_;
                                                                    let _e1778 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1747 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1468) + (_e1486 + _e1248)), ((f32(((_e1756 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1249)));
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(_e1778, ((f32(((_e1765 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1250)));
                                                                    if (_e1744 <= _e1779) {
                                                                        if (_e1744 <= _e121) {
                                                                            if (_e1779 >= 0f) {
                                                                                if (_e1708 == 0u) {
                                                                                    let _e1786 = nodes.member[(0u + _e1436)].links[2u];
                                                                                    phi_1855_ = _e1786;
                                                                                } else {
                                                                                    let _e1789 = nodes.member[(0u + _e1436)].links[3u];
                                                                                    phi_1855_ = _e1789;
                                                                                }
                                                                                let _e1791 = phi_1855_;
                                                                                let _e1796 = ((_e1791 >> bitcast<u32>(((_e1709 * 8u) & 31u))) & 255u);
                                                                                let _e1797 = (_e1796 & 31u);
                                                                                if (_e1797 >= 24u) {
                                                                                    phi_1868_ = (24u + ((_e1797 - 24u) ^ _e1298));
                                                                                } else {
                                                                                    phi_1868_ = _e1797;
                                                                                }
                                                                                let _e1803 = phi_1868_;
                                                                                phi_1873_ = (_e1705 | ((_e1796 >> bitcast<u32>(5i)) << bitcast<u32>((_e1803 & 31u))));
                                                                            } else {
                                                                                phi_1873_ = _e1705;
                                                                            }
                                                                            let _e1811 = phi_1873_;
                                                                            phi_1874_ = _e1811;
                                                                        } else {
                                                                            phi_1874_ = _e1705;
                                                                        }
                                                                        let _e1813 = phi_1874_;
                                                                        phi_1875_ = _e1813;
                                                                    } else {
                                                                        phi_1875_ = _e1705;
                                                                    }
                                                                    let _e1815 = phi_1875_;
                                                                    phi_1745_ = (_e1703 + 1u);
                                                                    phi_1748_ = _e1815;
                                                                } else {
                                                                    phi_1745_ = u32();
                                                                    phi_1748_ = u32();
                                                                }
                                                                let _e1818 = phi_1745_;
                                                                let _e1820 = phi_1748_;
                                                                continue;
                                                                continuing {
                                                                    phi_1744_ = _e1818;
                                                                    phi_1747_ = _e1820;
                                                                    break if !(_e1706);
                                                                }
                                                            }
                                                            let _e1824 = nodes.member[(0u + _e1436)].links[0u];
                                                            let _e1828 = nodes.member[(0u + _e1436)].frame[3u];
                                                            let _e1832 = local_5;
                                                            if ((_e1832 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1836 = local.group_mask;
                                                                if ((_e1836 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1840 = local.len;
                                                                    if (_e1840 < 32u) {
                                                                        let _e1843 = local.group;
                                                                        let _e1845 = local.len;
                                                                        if (_e1845 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1845)] = _e1843;
                                                                        let _e1851 = local.group_mask;
                                                                        let _e1853 = local.len;
                                                                        if (_e1853 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1853)] = _e1851;
                                                                        let _e1860 = local.len;
                                                                        local.len = (_e1860 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1060 + _e1824);
                                                                let _e1864 = local_6;
                                                                local.group_mask = ((_e1864 & 4278190080u) | (_e1828 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1869 = local_7;
                                                            phi_1933_ = (_e1869 & 16777215u);
                                                            loop {
                                                                let _e1872 = phi_1933_;
                                                                let _e1873 = (_e1872 == 0u);
                                                                local_8 = _e1873;
                                                                local_14 = _e1873;
                                                                if _e1873 {
                                                                    phi_1934_ = u32();
                                                                    phi_2447_ = false;
                                                                    phi_2448_ = false;
                                                                    phi_2449_ = false;
                                                                } else {
                                                                    let _e1876 = nodes.member[(0u + _e1436)].links[1u];
                                                                    let _e1881 = ((_e1062 + _e1876) + select(firstTrailingBit(_e1872), 32u, (_e1872 == 0u)));
                                                                    if (_e1881 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1888 = triangles.member[(0u + _e1881)].v0_;
                                                                    let _e1890 = (_e1888.x - _e991);
                                                                    let _e1892 = (_e1888.y - _e1004);
                                                                    let _e1894 = (_e1888.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_1979_ = vec3<f32>(_e1892, _e1894, _e1890);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_1978_ = vec3<f32>(_e1894, _e1890, _e1892);
                                                                        } else {
                                                                            phi_1978_ = (_e1888 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1902 = phi_1978_;
                                                                        phi_1979_ = _e1902;
                                                                    }
                                                                    let _e1904 = phi_1979_;
                                                                    let _e1908 = (_e1904.x - (_e1282 * _e1904.z));
                                                                    let _e1912 = (_e1904.y - (_e1285 * _e1904.z));
                                                                    let _e1916 = triangles.member[(0u + _e1881)].v1_;
                                                                    let _e1918 = (_e1916.x - _e991);
                                                                    let _e1920 = (_e1916.y - _e1004);
                                                                    let _e1922 = (_e1916.z - _e1017);
                                                                    if (_e1271 == 0u) {
                                                                        phi_2011_ = vec3<f32>(_e1920, _e1922, _e1918);
                                                                    } else {
                                                                        if (_e1271 == 1u) {
                                                                            phi_2010_ = vec3<f32>(_e1922, _e1918, _e1920);
                                                                        } else {
                                                                            phi_2010_ = (_e1916 - vec3<f32>(_e991, _e1004, _e1017));
                                                                        }
                                                                        let _e1930 = phi_2010_;
                                                                        phi_2011_ = _e1930;
                                                                    }
                                                                    let _e1932 = phi_2011_;
                                                                    let _e1936 = (_e1932.x - (_e1282 * _e1932.z));
                                                                    let _e1940 = (_e1932.y - (_e1285 * _e1932.z));
                                                                    let _e1944 = triangles.member[(0u + _e1881)].v2_;
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
                                                                    if (_e1936 < _e1964) {
                                                                        phi_2064_ = true;
                                                                    } else {
                                                                        if (_e1936 == _e1964) {
                                                                            phi_2063_ = (_e1940 < _e1968);
                                                                        } else {
                                                                            phi_2063_ = false;
                                                                        }
                                                                        let _e1975 = phi_2063_;
                                                                        phi_2064_ = _e1975;
                                                                    }
                                                                    let _e1977 = phi_2064_;
                                                                    if _e1977 {
                                                                        phi_2068_ = _e1968;
                                                                        phi_2069_ = _e1964;
                                                                        phi_2070_ = _e1940;
                                                                        phi_2071_ = _e1936;
                                                                    } else {
                                                                        phi_2068_ = _e1940;
                                                                        phi_2069_ = _e1936;
                                                                        phi_2070_ = _e1968;
                                                                        phi_2071_ = _e1964;
                                                                    }
                                                                    let _e1979 = phi_2068_;
                                                                    let _e1981 = phi_2069_;
                                                                    let _e1983 = phi_2070_;
                                                                    let _e1985 = phi_2071_;
                                                                    let _e1988 = ((_e1985 * _e1979) - (_e1983 * _e1981));
                                                                    if _e1977 {
                                                                        phi_2079_ = -(_e1988);
                                                                    } else {
                                                                        phi_2079_ = _e1988;
                                                                    }
                                                                    let _e1991 = phi_2079_;
                                                                    if (_e1964 < _e1908) {
                                                                        phi_2090_ = true;
                                                                    } else {
                                                                        if (_e1964 == _e1908) {
                                                                            phi_2089_ = (_e1968 < _e1912);
                                                                        } else {
                                                                            phi_2089_ = false;
                                                                        }
                                                                        let _e1996 = phi_2089_;
                                                                        phi_2090_ = _e1996;
                                                                    }
                                                                    let _e1998 = phi_2090_;
                                                                    if _e1998 {
                                                                        phi_2094_ = _e1912;
                                                                        phi_2095_ = _e1908;
                                                                        phi_2096_ = _e1968;
                                                                        phi_2097_ = _e1964;
                                                                    } else {
                                                                        phi_2094_ = _e1968;
                                                                        phi_2095_ = _e1964;
                                                                        phi_2096_ = _e1912;
                                                                        phi_2097_ = _e1908;
                                                                    }
                                                                    let _e2000 = phi_2094_;
                                                                    let _e2002 = phi_2095_;
                                                                    let _e2004 = phi_2096_;
                                                                    let _e2006 = phi_2097_;
                                                                    let _e2009 = ((_e2006 * _e2000) - (_e2004 * _e2002));
                                                                    if _e1998 {
                                                                        phi_2105_ = -(_e2009);
                                                                    } else {
                                                                        phi_2105_ = _e2009;
                                                                    }
                                                                    let _e2012 = phi_2105_;
                                                                    if (_e1908 < _e1936) {
                                                                        phi_2116_ = true;
                                                                    } else {
                                                                        if (_e1908 == _e1936) {
                                                                            phi_2115_ = (_e1912 < _e1940);
                                                                        } else {
                                                                            phi_2115_ = false;
                                                                        }
                                                                        let _e2017 = phi_2115_;
                                                                        phi_2116_ = _e2017;
                                                                    }
                                                                    let _e2019 = phi_2116_;
                                                                    if _e2019 {
                                                                        phi_2120_ = _e1940;
                                                                        phi_2121_ = _e1936;
                                                                        phi_2122_ = _e1912;
                                                                        phi_2123_ = _e1908;
                                                                    } else {
                                                                        phi_2120_ = _e1912;
                                                                        phi_2121_ = _e1908;
                                                                        phi_2122_ = _e1940;
                                                                        phi_2123_ = _e1936;
                                                                    }
                                                                    let _e2021 = phi_2120_;
                                                                    let _e2023 = phi_2121_;
                                                                    let _e2025 = phi_2122_;
                                                                    let _e2027 = phi_2123_;
                                                                    let _e2030 = ((_e2027 * _e2021) - (_e2025 * _e2023));
                                                                    if _e2019 {
                                                                        phi_2131_ = -(_e2030);
                                                                    } else {
                                                                        phi_2131_ = _e2030;
                                                                    }
                                                                    let _e2033 = phi_2131_;
                                                                    if (_e1991 >= 0f) {
                                                                        if (_e2012 >= 0f) {
                                                                            if (_e2033 >= 0f) {
                                                                                phi_2146_ = ((_e1991 + _e2012) + _e2033);
                                                                                phi_2147_ = false;
                                                                            } else {
                                                                                phi_2146_ = f32();
                                                                                phi_2147_ = true;
                                                                            }
                                                                            let _e2040 = phi_2146_;
                                                                            let _e2042 = phi_2147_;
                                                                            phi_2148_ = _e2040;
                                                                            phi_2149_ = _e2042;
                                                                        } else {
                                                                            phi_2148_ = f32();
                                                                            phi_2149_ = true;
                                                                        }
                                                                        let _e2044 = phi_2148_;
                                                                        let _e2046 = phi_2149_;
                                                                        phi_2150_ = _e2044;
                                                                        phi_2151_ = _e2046;
                                                                    } else {
                                                                        phi_2150_ = f32();
                                                                        phi_2151_ = true;
                                                                    }
                                                                    let _e2048 = phi_2150_;
                                                                    let _e2050 = phi_2151_;
                                                                    if _e2050 {
                                                                        if (_e1991 <= 0f) {
                                                                            if (_e2012 <= 0f) {
                                                                                let _e2053 = (_e2033 <= 0f);
                                                                                if _e2053 {
                                                                                }
                                                                                phi_2169_ = ((_e1991 + _e2012) + _e2033);
                                                                                phi_2170_ = false;
                                                                                phi_2171_ = _e2053;
                                                                            } else {
                                                                                phi_2169_ = f32();
                                                                                phi_2170_ = true;
                                                                                phi_2171_ = false;
                                                                            }
                                                                            let _e2057 = phi_2169_;
                                                                            let _e2059 = phi_2170_;
                                                                            let _e2061 = phi_2171_;
                                                                            phi_2172_ = _e2057;
                                                                            phi_2173_ = _e2059;
                                                                            phi_2174_ = _e2061;
                                                                        } else {
                                                                            phi_2172_ = f32();
                                                                            phi_2173_ = true;
                                                                            phi_2174_ = false;
                                                                        }
                                                                        let _e2063 = phi_2172_;
                                                                        let _e2065 = phi_2173_;
                                                                        let _e2067 = phi_2174_;
                                                                        if _e2065 {
                                                                            phi_2178_ = false;
                                                                        } else {
                                                                            phi_2178_ = _e2067;
                                                                        }
                                                                        let _e2069 = phi_2178_;
                                                                        phi_2179_ = _e2063;
                                                                        phi_2180_ = _e2069;
                                                                    } else {
                                                                        phi_2179_ = _e2048;
                                                                        phi_2180_ = true;
                                                                    }
                                                                    let _e2071 = phi_2179_;
                                                                    let _e2073 = phi_2180_;
                                                                    if _e2073 {
                                                                        let _e2074 = (_e2071 == 0f);
                                                                        if _e2074 {
                                                                            phi_2393_ = lt_bvh_triangle_Intersection();
                                                                            phi_2394_ = false;
                                                                        } else {
                                                                            let _e2080 = ((((_e1991 * (_e1287 * _e1904.z)) + (_e2012 * (_e1287 * _e1932.z))) + (_e2033 * (_e1287 * _e1960.z))) / _e2071);
                                                                            if (_e2080 > 0f) {
                                                                                if (_e2080 < _e121) {
                                                                                    let _e2084 = triangles.member[(0u + _e1881)].v0_;
                                                                                    let _e2086 = triangles.member[(0u + _e1881)].v1_;
                                                                                    if (_e2084.x < _e2086.x) {
                                                                                        phi_2214_ = _e2084.x;
                                                                                    } else {
                                                                                        phi_2214_ = _e2086.x;
                                                                                    }
                                                                                    let _e2093 = phi_2214_;
                                                                                    if (_e2084.y < _e2086.y) {
                                                                                        phi_2223_ = _e2084.y;
                                                                                    } else {
                                                                                        phi_2223_ = _e2086.y;
                                                                                    }
                                                                                    let _e2100 = phi_2223_;
                                                                                    if (_e2084.z < _e2086.z) {
                                                                                        phi_2232_ = _e2084.z;
                                                                                    } else {
                                                                                        phi_2232_ = _e2086.z;
                                                                                    }
                                                                                    let _e2107 = phi_2232_;
                                                                                    let _e2109 = triangles.member[(0u + _e1881)].v2_;
                                                                                    if (_e2093 < _e2109.x) {
                                                                                        phi_2241_ = _e2093;
                                                                                    } else {
                                                                                        phi_2241_ = _e2109.x;
                                                                                    }
                                                                                    let _e2114 = phi_2241_;
                                                                                    if (_e2100 < _e2109.y) {
                                                                                        phi_2248_ = _e2100;
                                                                                    } else {
                                                                                        phi_2248_ = _e2109.y;
                                                                                    }
                                                                                    let _e2119 = phi_2248_;
                                                                                    if (_e2107 < _e2109.z) {
                                                                                        phi_2255_ = _e2107;
                                                                                    } else {
                                                                                        phi_2255_ = _e2109.z;
                                                                                    }
                                                                                    let _e2124 = phi_2255_;
                                                                                    let _e2126 = triangles.member[(0u + _e1881)].v0_;
                                                                                    let _e2128 = triangles.member[(0u + _e1881)].v1_;
                                                                                    if (_e2126.x > _e2128.x) {
                                                                                        phi_2268_ = _e2126.x;
                                                                                    } else {
                                                                                        phi_2268_ = _e2128.x;
                                                                                    }
                                                                                    let _e2135 = phi_2268_;
                                                                                    if (_e2126.y > _e2128.y) {
                                                                                        phi_2277_ = _e2126.y;
                                                                                    } else {
                                                                                        phi_2277_ = _e2128.y;
                                                                                    }
                                                                                    let _e2142 = phi_2277_;
                                                                                    if (_e2126.z > _e2128.z) {
                                                                                        phi_2286_ = _e2126.z;
                                                                                    } else {
                                                                                        phi_2286_ = _e2128.z;
                                                                                    }
                                                                                    let _e2149 = phi_2286_;
                                                                                    let _e2151 = triangles.member[(0u + _e1881)].v2_;
                                                                                    if (_e2135 > _e2151.x) {
                                                                                        phi_2295_ = _e2135;
                                                                                    } else {
                                                                                        phi_2295_ = _e2151.x;
                                                                                    }
                                                                                    let _e2156 = phi_2295_;
                                                                                    if (_e2142 > _e2151.y) {
                                                                                        phi_2302_ = _e2142;
                                                                                    } else {
                                                                                        phi_2302_ = _e2151.y;
                                                                                    }
                                                                                    let _e2161 = phi_2302_;
                                                                                    if (_e2149 > _e2151.z) {
                                                                                        phi_2309_ = _e2149;
                                                                                    } else {
                                                                                        phi_2309_ = _e2151.z;
                                                                                    }
                                                                                    let _e2166 = phi_2309_;
                                                                                    let _e2170 = ((_e2114 - _e991) * _e1200);
                                                                                    let _e2171 = ((_e2119 - _e1004) * _e1210);
                                                                                    let _e2172 = ((_e2124 - _e1017) * _e1220);
                                                                                    let _e2176 = ((_e2156 - _e991) * _e1200);
                                                                                    let _e2177 = ((_e2161 - _e1004) * _e1210);
                                                                                    let _e2178 = ((_e2166 - _e1017) * _e1220);
                                                                                    if (_e2170 < _e2176) {
                                                                                        phi_2326_ = _e2170;
                                                                                    } else {
                                                                                        phi_2326_ = _e2176;
                                                                                    }
                                                                                    let _e2181 = phi_2326_;
                                                                                    if (_e2171 < _e2177) {
                                                                                        phi_2331_ = _e2171;
                                                                                    } else {
                                                                                        phi_2331_ = _e2177;
                                                                                    }
                                                                                    let _e2184 = phi_2331_;
                                                                                    if (_e2172 < _e2178) {
                                                                                        phi_2336_ = _e2172;
                                                                                    } else {
                                                                                        phi_2336_ = _e2178;
                                                                                    }
                                                                                    let _e2187 = phi_2336_;
                                                                                    if (_e2170 > _e2176) {
                                                                                        phi_2344_ = _e2170;
                                                                                    } else {
                                                                                        phi_2344_ = _e2176;
                                                                                    }
                                                                                    let _e2193 = phi_2344_;
                                                                                    if (_e2171 > _e2177) {
                                                                                        phi_2349_ = _e2171;
                                                                                    } else {
                                                                                        phi_2349_ = _e2177;
                                                                                    }
                                                                                    let _e2196 = phi_2349_;
                                                                                    if (_e2172 > _e2178) {
                                                                                        phi_2354_ = _e2172;
                                                                                    } else {
                                                                                        phi_2354_ = _e2178;
                                                                                    }
                                                                                    let _e2199 = phi_2354_;
                                                                                    let _e2203 = core_intrinsics_maximum_number_nsz_f32_((_e2181 - _e1255), (_e2184 - _e1256));
                                                                                    let _e2204 = core_intrinsics_maximum_number_nsz_f32_(_e2203, (_e2187 - _e1257));
                                                                                    let _e2205 = core_intrinsics_minimum_number_nsz_f32_((_e2193 + _e1255), (_e2196 + _e1256));
                                                                                    let _e2206 = core_intrinsics_minimum_number_nsz_f32_(_e2205, (_e2199 + _e1257));
                                                                                    if (_e2204 > _e972) {
                                                                                        phi_2366_ = _e2204;
                                                                                    } else {
                                                                                        phi_2366_ = _e972;
                                                                                    }
                                                                                    let _e2209 = phi_2366_;
                                                                                    if (_e2206 < _e974) {
                                                                                        phi_2371_ = _e2206;
                                                                                    } else {
                                                                                        phi_2371_ = _e974;
                                                                                    }
                                                                                    let _e2212 = phi_2371_;
                                                                                    if (_e2080 < _e2209) {
                                                                                        phi_2376_ = _e2209;
                                                                                    } else {
                                                                                        phi_2376_ = _e2080;
                                                                                    }
                                                                                    let _e2215 = phi_2376_;
                                                                                    if (_e2215 > _e2212) {
                                                                                        phi_2381_ = _e2212;
                                                                                    } else {
                                                                                        phi_2381_ = _e2215;
                                                                                    }
                                                                                    let _e2218 = phi_2381_;
                                                                                    phi_2386_ = lt_bvh_triangle_Intersection(_e2218, (_e2012 / _e2071), (_e2033 / _e2071), (_e2209 <= _e2212));
                                                                                    phi_2387_ = false;
                                                                                } else {
                                                                                    phi_2386_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2387_ = true;
                                                                                }
                                                                                let _e2224 = phi_2386_;
                                                                                let _e2226 = phi_2387_;
                                                                                phi_2388_ = _e2224;
                                                                                phi_2389_ = _e2226;
                                                                            } else {
                                                                                phi_2388_ = lt_bvh_triangle_Intersection();
                                                                                phi_2389_ = true;
                                                                            }
                                                                            let _e2228 = phi_2388_;
                                                                            let _e2230 = phi_2389_;
                                                                            if _e2230 {
                                                                            }
                                                                            phi_2393_ = _e2228;
                                                                            phi_2394_ = _e2230;
                                                                        }
                                                                        let _e2232 = phi_2393_;
                                                                        let _e2234 = phi_2394_;
                                                                        phi_2395_ = _e2232;
                                                                        phi_2396_ = _e2074;
                                                                        phi_2397_ = _e2234;
                                                                    } else {
                                                                        phi_2395_ = lt_bvh_triangle_Intersection();
                                                                        phi_2396_ = true;
                                                                        phi_2397_ = false;
                                                                    }
                                                                    let _e2236 = phi_2395_;
                                                                    let _e2238 = phi_2396_;
                                                                    let _e2240 = phi_2397_;
                                                                    if _e2238 {
                                                                        phi_2401_ = true;
                                                                    } else {
                                                                        phi_2401_ = _e2240;
                                                                    }
                                                                    let _e2242 = phi_2401_;
                                                                    if _e2242 {
                                                                        phi_2405_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2405_ = _e2236;
                                                                    }
                                                                    let _e2244 = phi_2405_;
                                                                    if _e2244.is_hit {
                                                                        if (_e2244.t > 0f) {
                                                                            if (_e2244.t < _e121) {
                                                                                let _e2251 = triangles.member[(0u + _e1881)].i0_;
                                                                                let _e2253 = ((_e2251 & 2147483648u) == 0u);
                                                                                if _e2253 {
                                                                                    phi_2431_ = false;
                                                                                    phi_2432_ = false;
                                                                                } else {
                                                                                    if true {
                                                                                        phi_2430_ = false;
                                                                                    } else {
                                                                                        phi_2430_ = true;
                                                                                    }
                                                                                    let _e2255 = phi_2430_;
                                                                                    phi_2431_ = _e2255;
                                                                                    phi_2432_ = true;
                                                                                }
                                                                                let _e2257 = phi_2431_;
                                                                                let _e2259 = phi_2432_;
                                                                                phi_2433_ = _e2257;
                                                                                phi_2434_ = _e2253;
                                                                                phi_2435_ = _e2259;
                                                                            } else {
                                                                                phi_2433_ = true;
                                                                                phi_2434_ = false;
                                                                                phi_2435_ = false;
                                                                            }
                                                                            let _e2261 = phi_2433_;
                                                                            let _e2263 = phi_2434_;
                                                                            let _e2265 = phi_2435_;
                                                                            phi_2436_ = _e2261;
                                                                            phi_2437_ = _e2263;
                                                                            phi_2438_ = _e2265;
                                                                        } else {
                                                                            phi_2436_ = true;
                                                                            phi_2437_ = false;
                                                                            phi_2438_ = false;
                                                                        }
                                                                        let _e2267 = phi_2436_;
                                                                        let _e2269 = phi_2437_;
                                                                        let _e2271 = phi_2438_;
                                                                        phi_2439_ = _e2267;
                                                                        phi_2440_ = _e2269;
                                                                        phi_2441_ = _e2271;
                                                                    } else {
                                                                        phi_2439_ = true;
                                                                        phi_2440_ = false;
                                                                        phi_2441_ = false;
                                                                    }
                                                                    let _e2273 = phi_2439_;
                                                                    let _e2275 = phi_2440_;
                                                                    let _e2277 = phi_2441_;
                                                                    if _e2273 {
                                                                        phi_2445_ = false;
                                                                        phi_2446_ = false;
                                                                    } else {
                                                                        phi_2445_ = _e2275;
                                                                        phi_2446_ = _e2277;
                                                                    }
                                                                    let _e2279 = phi_2445_;
                                                                    let _e2281 = phi_2446_;
                                                                    phi_1934_ = (_e1872 & (_e1872 - 1u));
                                                                    phi_2447_ = _e2273;
                                                                    phi_2448_ = _e2279;
                                                                    phi_2449_ = _e2281;
                                                                }
                                                                let _e2283 = phi_1934_;
                                                                let _e2285 = phi_2447_;
                                                                let _e2287 = phi_2448_;
                                                                let _e2289 = phi_2449_;
                                                                local_12 = _e2287;
                                                                local_13 = _e2289;
                                                                continue;
                                                                continuing {
                                                                    phi_1933_ = _e2283;
                                                                    break if !(_e2285);
                                                                }
                                                            }
                                                            let _e2292 = local_8;
                                                            if _e2292 {
                                                                let _e2294 = local.group_mask;
                                                                if ((_e2294 & 4278190080u) == 0u) {
                                                                    let _e2298 = local.len;
                                                                    if (_e2298 == 0u) {
                                                                        phi_2491_ = false;
                                                                    } else {
                                                                        let _e2302 = local.len;
                                                                        local.len = (_e2302 - 1u);
                                                                        let _e2305 = local.len;
                                                                        if (_e2305 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2310 = local.first[(0u + _e2305)];
                                                                        local.group = _e2310;
                                                                        let _e2313 = local.len;
                                                                        if (_e2313 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2318 = local.mask[(0u + _e2313)];
                                                                        local.group_mask = _e2318;
                                                                        phi_2491_ = true;
                                                                    }
                                                                    let _e2321 = phi_2491_;
                                                                    phi_2492_ = _e2321;
                                                                } else {
                                                                    phi_2492_ = true;
                                                                }
                                                                let _e2323 = phi_2492_;
                                                                if _e2323 {
                                                                    let _e2325 = local.group_mask;
                                                                    let _e2331 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2325)), 32u, (_e2325 == 0u)));
                                                                    let _e2335 = local.group_mask;
                                                                    let _e2349 = local.group_mask;
                                                                    local.group_mask = (_e2349 & ~((1u << bitcast<u32>((_e2331 & 31u)))));
                                                                    let _e2352 = local.group;
                                                                    phi_2523_ = (_e2352 + countOneBits(((_e2335 & ~((4294967295u << bitcast<u32>((((_e2331 - 24u) ^ _e1298) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2523_ = 4294967295u;
                                                                }
                                                                let _e2355 = phi_2523_;
                                                                phi_2524_ = _e2355;
                                                                phi_2525_ = false;
                                                                phi_2526_ = false;
                                                            } else {
                                                                phi_2524_ = u32();
                                                                let _e2758 = local_12;
                                                                phi_2525_ = _e2758;
                                                                let _e2761 = local_13;
                                                                phi_2526_ = _e2761;
                                                            }
                                                            let _e2357 = phi_2524_;
                                                            let _e2359 = phi_2525_;
                                                            let _e2361 = phi_2526_;
                                                            phi_1604_ = _e2357;
                                                            let _e2765 = local_14;
                                                            phi_2527_ = _e2765;
                                                            phi_2528_ = false;
                                                            phi_2529_ = _e2359;
                                                            phi_2530_ = _e2361;
                                                        } else {
                                                            phi_1604_ = u32();
                                                            phi_2527_ = false;
                                                            phi_2528_ = true;
                                                            phi_2529_ = false;
                                                            phi_2530_ = false;
                                                        }
                                                        let _e2363 = phi_1604_;
                                                        let _e2365 = phi_2527_;
                                                        let _e2367 = phi_2528_;
                                                        let _e2369 = phi_2529_;
                                                        let _e2371 = phi_2530_;
                                                        local_9 = _e2367;
                                                        local_15 = _e2369;
                                                        local_16 = _e2371;
                                                        continue;
                                                        continuing {
                                                            phi_1603_ = _e2363;
                                                            break if !(_e2365);
                                                        }
                                                    }
                                                    let _e2374 = local_9;
                                                    if _e2374 {
                                                        phi_2534_ = false;
                                                        phi_2535_ = false;
                                                    } else {
                                                        let _e2772 = local_15;
                                                        phi_2534_ = _e2772;
                                                        let _e2775 = local_16;
                                                        phi_2535_ = _e2775;
                                                    }
                                                    let _e2376 = phi_2534_;
                                                    let _e2378 = phi_2535_;
                                                    if _e2376 {
                                                        phi_2539_ = true;
                                                    } else {
                                                        phi_2539_ = _e2378;
                                                    }
                                                    let _e2380 = phi_2539_;
                                                    if _e2380 {
                                                        phi_2543_ = true;
                                                    } else {
                                                        phi_2543_ = false;
                                                    }
                                                    let _e2382 = phi_2543_;
                                                    phi_2544_ = _e2382;
                                                }
                                                let _e2384 = phi_2544_;
                                                phi_2545_ = _e2384;
                                                phi_2546_ = _e1124;
                                            } else {
                                                phi_2545_ = bool();
                                                phi_2546_ = true;
                                            }
                                            let _e2386 = phi_2545_;
                                            let _e2388 = phi_2546_;
                                            if _e2388 {
                                                phi_2550_ = false;
                                            } else {
                                                phi_2550_ = _e2386;
                                            }
                                            let _e2390 = phi_2550_;
                                            if _e2390 {
                                                phi_2554_ = false;
                                            } else {
                                                phi_2554_ = true;
                                            }
                                            let _e2392 = phi_2554_;
                                            phi_2555_ = _e2392;
                                        } else {
                                            phi_2555_ = true;
                                        }
                                        let _e2394 = phi_2555_;
                                        phi_2556_ = _e2394;
                                    } else {
                                        phi_2556_ = true;
                                    }
                                    let _e2396 = phi_2556_;
                                    phi_2557_ = _e2396;
                                } else {
                                    phi_2557_ = true;
                                }
                                let _e2398 = phi_2557_;
                                if _e2398 {
                                }
                                phi_998_ = (_e911 & (_e911 - 1u));
                                phi_2561_ = _e2398;
                            }
                            let _e2400 = phi_998_;
                            let _e2402 = phi_2561_;
                            continue;
                            continuing {
                                phi_997_ = _e2400;
                                break if !(_e2402);
                            }
                        }
                        let _e2405 = local_10;
                        if _e2405 {
                            let _e2407 = local_1.group_mask;
                            if ((_e2407 & 4278190080u) == 0u) {
                                let _e2411 = local_1.len;
                                if (_e2411 == 0u) {
                                    phi_2603_ = false;
                                } else {
                                    let _e2415 = local_1.len;
                                    local_1.len = (_e2415 - 1u);
                                    let _e2418 = local_1.len;
                                    if (_e2418 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2423 = local_1.first[(0u + _e2418)];
                                    local_1.group = _e2423;
                                    let _e2426 = local_1.len;
                                    if (_e2426 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2431 = local_1.mask[(0u + _e2426)];
                                    local_1.group_mask = _e2431;
                                    phi_2603_ = true;
                                }
                                let _e2434 = phi_2603_;
                                phi_2604_ = _e2434;
                            } else {
                                phi_2604_ = true;
                            }
                            let _e2436 = phi_2604_;
                            if _e2436 {
                                let _e2438 = local_1.group_mask;
                                let _e2444 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2438)), 32u, (_e2438 == 0u)));
                                let _e2448 = local_1.group_mask;
                                let _e2462 = local_1.group_mask;
                                local_1.group_mask = (_e2462 & ~((1u << bitcast<u32>((_e2444 & 31u)))));
                                let _e2465 = local_1.group;
                                phi_2635_ = (_e2465 + countOneBits(((_e2448 & ~((4294967295u << bitcast<u32>((((_e2444 - 24u) ^ _e337) & 31u))))) & 255u)));
                            } else {
                                phi_2635_ = 4294967295u;
                            }
                            let _e2468 = phi_2635_;
                            phi_2636_ = _e2468;
                        } else {
                            phi_2636_ = u32();
                        }
                        let _e2470 = phi_2636_;
                        phi_668_ = _e2470;
                        let _e2796 = local_17;
                        phi_2637_ = _e2796;
                        phi_2638_ = false;
                    } else {
                        phi_668_ = u32();
                        phi_2637_ = false;
                        phi_2638_ = true;
                    }
                    let _e2472 = phi_668_;
                    let _e2474 = phi_2637_;
                    let _e2476 = phi_2638_;
                    local_11 = _e2476;
                    continue;
                    continuing {
                        phi_667_ = _e2472;
                        break if !(_e2474);
                    }
                }
                let _e2479 = local_11;
                if _e2479 {
                    phi_2642_ = false;
                } else {
                    phi_2642_ = true;
                }
                let _e2481 = phi_2642_;
                if _e2481 {
                    phi_2646_ = true;
                } else {
                    phi_2646_ = false;
                }
                let _e2483 = phi_2646_;
                phi_2647_ = _e2483;
            }
            let _e2485 = phi_2647_;
            phi_2648_ = _e2485;
            phi_2649_ = _e193;
        } else {
            phi_2648_ = bool();
            phi_2649_ = true;
        }
        let _e2487 = phi_2648_;
        let _e2489 = phi_2649_;
        if _e2489 {
            phi_2653_ = false;
        } else {
            phi_2653_ = _e2487;
        }
        let _e2491 = phi_2653_;
        if _e2491 {
            phi_2657_ = 0f;
        } else {
            phi_2657_ = 1f;
        }
        let _e2493 = phi_2657_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        visibility.member[(0u + _e90)] = _e2493;
        if (_e90 < _e74) {
        } else {
            return;
        }
        let _e2500 = bits.member[(0u + _e90)];
        if ((_e2500 & 2u) == 0u) {
            phi_2678_ = (_e2500 & 1u);
        } else {
            phi_2678_ = (_e2500 & 7u);
        }
        let _e2506 = phi_2678_;
        if (_e90 < _e68) {
        } else {
            return;
        }
        let _e2510 = visibility.member[(0u + _e90)];
        if ((_e2506 & 1u) != 0u) {
            phi_2693_ = (2u | 1u);
        } else {
            phi_2693_ = 2u;
        }
        let _e2516 = phi_2693_;
        if (_e2510 < 0.5f) {
            phi_2698_ = (_e2516 | 4u);
        } else {
            phi_2698_ = _e2516;
        }
        let _e2519 = phi_2698_;
        if (_e90 < _e74) {
        } else {
            return;
        }
        bits.member[(0u + _e90)] = _e2519;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
