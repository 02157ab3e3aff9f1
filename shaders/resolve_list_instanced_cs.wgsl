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

struct type_31 {
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
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> nodes: type_36;
@group(0) @binding(3) 
var<storage> triangles: type_40;
@group(0) @binding(6) 
var<storage> instances: type_50;
@group(0) @binding(5) 
var<storage> list: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_160_: bool;
    var phi_164_: f32;

    if (param != param) {
        phi_160_ = true;
    } else {
        let _e54 = (param_1 >= param);
        if _e54 {
        }
        phi_160_ = _e54;
    }
    let _e56 = phi_160_;
    if _e56 {
        phi_164_ = param_1;
    } else {
        phi_164_ = param;
    }
    let _e58 = phi_164_;
    return _e58;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_176_: bool;
    var phi_180_: f32;

    if (param_2 != param_2) {
        phi_176_ = true;
    } else {
        let _e54 = (param_3 <= param_2);
        if _e54 {
        }
        phi_176_ = _e54;
    }
    let _e56 = phi_176_;
    if _e56 {
        phi_180_ = param_3;
    } else {
        phi_180_ = param_2;
    }
    let _e58 = phi_180_;
    return _e58;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_262_: f32;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_324_: bool;
    var phi_325_: bool;
    var phi_326_: bool;
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
    var phi_345_: bool;
    var phi_349_: bool;
    var phi_419_: f32;
    var phi_426_: f32;
    var phi_433_: f32;
    var phi_440_: f32;
    var phi_447_: f32;
    var phi_454_: f32;
    var phi_471_: f32;
    var phi_476_: f32;
    var phi_481_: f32;
    var phi_502_: u32;
    var phi_507_: u32;
    var phi_512_: u32;
    var phi_626_: bool;
    var phi_627_: bool;
    var phi_658_: u32;
    var phi_660_: u32;
    var phi_663_: bool;
    var phi_743_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_770_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_797_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_803_: u32;
    var phi_806_: u32;
    var phi_820_: u32;
    var phi_830_: u32;
    var phi_840_: u32;
    var phi_858_: u32;
    var phi_868_: u32;
    var phi_878_: u32;
    var phi_914_: u32;
    var phi_927_: u32;
    var phi_932_: u32;
    var phi_933_: u32;
    var phi_934_: u32;
    var phi_804_: u32;
    var phi_807_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_992_: u32;
    var phi_995_: bool;
    var phi_1044_: f32;
    var phi_1049_: f32;
    var phi_1054_: f32;
    var phi_1062_: f32;
    var phi_1067_: f32;
    var phi_1072_: f32;
    var phi_1216_: bool;
    var phi_1217_: bool;
    var phi_1218_: bool;
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
    var phi_1239_: bool;
    var phi_1243_: bool;
    var phi_1247_: bool;
    var phi_1317_: f32;
    var phi_1324_: f32;
    var phi_1331_: f32;
    var phi_1338_: f32;
    var phi_1345_: f32;
    var phi_1352_: f32;
    var phi_1369_: f32;
    var phi_1374_: f32;
    var phi_1379_: f32;
    var phi_1407_: bool;
    var phi_1408_: bool;
    var phi_1416_: u32;
    var phi_1417_: u32;
    var phi_1428_: vec3<f32>;
    var phi_1429_: vec3<f32>;
    var phi_1442_: u32;
    var phi_1447_: u32;
    var phi_1452_: u32;
    var phi_1566_: bool;
    var phi_1567_: bool;
    var phi_1598_: u32;
    var phi_1600_: u32;
    var phi_1603_: bool;
    var phi_1683_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1710_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1737_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1743_: u32;
    var phi_1746_: u32;
    var phi_1760_: u32;
    var phi_1770_: u32;
    var phi_1780_: u32;
    var phi_1798_: u32;
    var phi_1808_: u32;
    var phi_1818_: u32;
    var phi_1854_: u32;
    var phi_1867_: u32;
    var phi_1872_: u32;
    var phi_1873_: u32;
    var phi_1874_: u32;
    var phi_1744_: u32;
    var phi_1747_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_1932_: u32;
    var phi_1935_: bool;
    var phi_1979_: vec3<f32>;
    var phi_1980_: vec3<f32>;
    var phi_2009_: vec3<f32>;
    var phi_2010_: vec3<f32>;
    var phi_2039_: vec3<f32>;
    var phi_2040_: vec3<f32>;
    var phi_2058_: bool;
    var phi_2059_: bool;
    var phi_2063_: f32;
    var phi_2064_: f32;
    var phi_2065_: f32;
    var phi_2066_: f32;
    var phi_2074_: f32;
    var phi_2084_: bool;
    var phi_2085_: bool;
    var phi_2089_: f32;
    var phi_2090_: f32;
    var phi_2091_: f32;
    var phi_2092_: f32;
    var phi_2100_: f32;
    var phi_2110_: bool;
    var phi_2111_: bool;
    var phi_2115_: f32;
    var phi_2116_: f32;
    var phi_2117_: f32;
    var phi_2118_: f32;
    var phi_2126_: f32;
    var phi_2141_: f32;
    var phi_2142_: bool;
    var phi_2143_: f32;
    var phi_2144_: bool;
    var phi_2145_: f32;
    var phi_2146_: bool;
    var phi_2164_: f32;
    var phi_2165_: bool;
    var phi_2166_: bool;
    var phi_2167_: f32;
    var phi_2168_: bool;
    var phi_2169_: bool;
    var phi_2173_: bool;
    var phi_2174_: f32;
    var phi_2175_: bool;
    var phi_2203_: vec3<f32>;
    var phi_2204_: vec3<f32>;
    var phi_2229_: vec3<f32>;
    var phi_2230_: vec3<f32>;
    var phi_2255_: vec3<f32>;
    var phi_2256_: vec3<f32>;
    var phi_2312_: f32;
    var phi_2321_: f32;
    var phi_2330_: f32;
    var phi_2339_: f32;
    var phi_2346_: f32;
    var phi_2353_: f32;
    var phi_2366_: f32;
    var phi_2375_: f32;
    var phi_2384_: f32;
    var phi_2393_: f32;
    var phi_2400_: f32;
    var phi_2407_: f32;
    var phi_2424_: f32;
    var phi_2429_: f32;
    var phi_2434_: f32;
    var phi_2442_: f32;
    var phi_2447_: f32;
    var phi_2452_: f32;
    var phi_2464_: f32;
    var phi_2469_: f32;
    var phi_2474_: f32;
    var phi_2479_: f32;
    var phi_2484_: lt_bvh_triangle_Intersection;
    var phi_2485_: bool;
    var phi_2486_: lt_bvh_triangle_Intersection;
    var phi_2487_: bool;
    var phi_2491_: lt_bvh_triangle_Intersection;
    var phi_2492_: bool;
    var phi_2493_: lt_bvh_triangle_Intersection;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2499_: bool;
    var phi_2503_: lt_bvh_triangle_Intersection;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var phi_2527_: bool;
    var phi_2528_: bool;
    var phi_2529_: bool;
    var phi_1933_: u32;
    var phi_1936_: bool;
    var phi_2533_: bool;
    var local_8: bool;
    var phi_2575_: bool;
    var phi_2576_: bool;
    var phi_2607_: u32;
    var phi_2608_: u32;
    var phi_1601_: u32;
    var phi_1604_: bool;
    var phi_2609_: bool;
    var phi_2610_: bool;
    var local_9: bool;
    var phi_2614_: bool;
    var phi_2618_: bool;
    var phi_2619_: bool;
    var phi_2620_: bool;
    var phi_2621_: bool;
    var phi_2625_: bool;
    var phi_2629_: bool;
    var phi_2630_: bool;
    var phi_2631_: bool;
    var phi_2632_: bool;
    var phi_2633_: bool;
    var phi_2634_: bool;
    var phi_2635_: bool;
    var phi_993_: u32;
    var phi_996_: bool;
    var phi_2639_: bool;
    var local_10: bool;
    var phi_2681_: bool;
    var phi_2682_: bool;
    var phi_2713_: u32;
    var phi_2714_: u32;
    var phi_661_: u32;
    var phi_664_: bool;
    var phi_2715_: bool;
    var phi_2716_: bool;
    var local_11: bool;
    var phi_2720_: bool;
    var phi_2724_: bool;
    var phi_2725_: bool;
    var phi_2726_: bool;
    var phi_2730_: bool;
    var phi_2731_: bool;
    var phi_2735_: bool;
    var phi_2739_: f32;
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
        let _e92 = p.member.light;
        let _e94 = samples.member[(0u + _e85)].position;
        let _e96 = samples.member[(0u + _e85)].normal;
        let _e98 = samples.member[(0u + _e85)].magnitude;
        let _e100 = ((8f / 8388608f) * _e98);
        let _e108 = (_e94.x + (_e96.x * _e100));
        let _e110 = (_e94.y + (_e96.y * _e100));
        let _e112 = (_e94.z + (_e96.z * _e100));
        if (_e92.w == 0f) {
            phi_262_ = 300000000000000000000000000000000000000f;
        } else {
            phi_262_ = 1f;
        }
        let _e116 = phi_262_;
        let _e124 = (_e92.x - (_e108 * _e92.w));
        let _e125 = (_e92.y - (_e110 * _e92.w));
        let _e126 = (_e92.z - (_e112 * _e92.w));
        let _e130 = abs(_e124);
        let _e131 = abs(_e125);
        let _e132 = abs(_e126);
        if (abs(_e108) < 1000000000000000f) {
            if (abs(_e110) < 1000000000000000f) {
                if (abs(_e112) < 1000000000000000f) {
                    if (_e130 < 1000000000000000f) {
                        if (_e131 < 1000000000000000f) {
                            if (_e132 < 1000000000000000f) {
                                if (_e130 > 0f) {
                                    phi_319_ = bool();
                                    phi_320_ = true;
                                } else {
                                    let _e140 = (_e131 > 0f);
                                    if _e140 {
                                        phi_318_ = bool();
                                    } else {
                                        phi_318_ = (_e132 > 0f);
                                    }
                                    let _e143 = phi_318_;
                                    phi_319_ = _e143;
                                    phi_320_ = _e140;
                                }
                                let _e145 = phi_319_;
                                let _e147 = phi_320_;
                                if _e147 {
                                    phi_324_ = true;
                                } else {
                                    phi_324_ = _e145;
                                }
                                let _e149 = phi_324_;
                                phi_325_ = _e149;
                                phi_326_ = false;
                            } else {
                                phi_325_ = bool();
                                phi_326_ = true;
                            }
                            let _e151 = phi_325_;
                            let _e153 = phi_326_;
                            phi_327_ = _e151;
                            phi_328_ = false;
                            phi_329_ = _e153;
                        } else {
                            phi_327_ = bool();
                            phi_328_ = true;
                            phi_329_ = false;
                        }
                        let _e155 = phi_327_;
                        let _e157 = phi_328_;
                        let _e159 = phi_329_;
                        phi_330_ = _e155;
                        phi_331_ = _e157;
                        phi_332_ = _e159;
                    } else {
                        phi_330_ = bool();
                        phi_331_ = true;
                        phi_332_ = false;
                    }
                    let _e161 = phi_330_;
                    let _e163 = phi_331_;
                    let _e165 = phi_332_;
                    phi_333_ = _e161;
                    phi_334_ = _e163;
                    phi_335_ = _e165;
                } else {
                    phi_333_ = bool();
                    phi_334_ = true;
                    phi_335_ = false;
                }
                let _e167 = phi_333_;
                let _e169 = phi_334_;
                let _e171 = phi_335_;
                phi_336_ = _e167;
                phi_337_ = _e169;
                phi_338_ = _e171;
            } else {
                phi_336_ = bool();
                phi_337_ = true;
                phi_338_ = false;
            }
            let _e173 = phi_336_;
            let _e175 = phi_337_;
            let _e177 = phi_338_;
            phi_339_ = _e173;
            phi_340_ = _e175;
            phi_341_ = _e177;
        } else {
            phi_339_ = bool();
            phi_340_ = true;
            phi_341_ = false;
        }
        let _e179 = phi_339_;
        let _e181 = phi_340_;
        let _e183 = phi_341_;
        if _e181 {
            phi_345_ = true;
        } else {
            phi_345_ = _e183;
        }
        let _e185 = phi_345_;
        if _e185 {
            phi_349_ = false;
        } else {
            phi_349_ = _e179;
        }
        let _e187 = phi_349_;
        if _e187 {
            let _e188 = (_e87 >= _e60);
            if _e188 {
                phi_2724_ = false;
            } else {
                if (_e87 < _e60) {
                } else {
                    return;
                }
                let _e194 = nodes.member[(0u + _e87)].frame[0u];
                let _e198 = nodes.member[(0u + _e87)].frame[1u];
                let _e202 = nodes.member[(0u + _e87)].frame[2u];
                let _e206 = nodes.member[(0u + _e87)].frame[0u];
                let _e210 = nodes.member[(0u + _e87)].frame[1u];
                let _e214 = nodes.member[(0u + _e87)].frame[2u];
                let _e218 = nodes.member[(0u + _e87)].frame[3u];
                let _e252 = core_intrinsics_maximum_number_nsz_f32_(abs(_e124), abs(_e125));
                let _e253 = core_intrinsics_maximum_number_nsz_f32_(_e252, abs(_e126));
                let _e254 = (_e253 * 0.0000000000009094947f);
                if (abs(_e124) < _e254) {
                    phi_419_ = _e254;
                } else {
                    phi_419_ = abs(_e124);
                }
                let _e259 = phi_419_;
                if (_e124 < 0f) {
                    phi_426_ = (-1f / _e259);
                } else {
                    phi_426_ = (1f / _e259);
                }
                let _e264 = phi_426_;
                if (abs(_e125) < _e254) {
                    phi_433_ = _e254;
                } else {
                    phi_433_ = abs(_e125);
                }
                let _e269 = phi_433_;
                if (_e125 < 0f) {
                    phi_440_ = (-1f / _e269);
                } else {
                    phi_440_ = (1f / _e269);
                }
                let _e274 = phi_440_;
                if (abs(_e126) < _e254) {
                    phi_447_ = _e254;
                } else {
                    phi_447_ = abs(_e126);
                }
                let _e279 = phi_447_;
                if (_e126 < 0f) {
                    phi_454_ = (-1f / _e279);
                } else {
                    phi_454_ = (1f / _e279);
                }
                let _e284 = phi_454_;
                let _e288 = abs((bitcast<f32>(_e194) - _e108));
                let _e289 = abs((bitcast<f32>(_e198) - _e110));
                let _e290 = abs((bitcast<f32>(_e202) - _e112));
                let _e294 = abs(((bitcast<f32>(_e206) + (bitcast<f32>((((_e218 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e108));
                let _e295 = abs(((bitcast<f32>(_e210) + (bitcast<f32>((((_e218 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e110));
                let _e296 = abs(((bitcast<f32>(_e214) + (bitcast<f32>((((_e218 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e112));
                if (_e288 > _e294) {
                    phi_471_ = _e288;
                } else {
                    phi_471_ = _e294;
                }
                let _e299 = phi_471_;
                if (_e289 > _e295) {
                    phi_476_ = _e289;
                } else {
                    phi_476_ = _e295;
                }
                let _e302 = phi_476_;
                if (_e290 > _e296) {
                    phi_481_ = _e290;
                } else {
                    phi_481_ = _e296;
                }
                let _e305 = phi_481_;
                let _e306 = core_intrinsics_maximum_number_nsz_f32_(_e299, _e302);
                let _e307 = core_intrinsics_maximum_number_nsz_f32_(_e306, _e305);
                let _e311 = (_e307 * 0.0000019073486f);
                let _e312 = (abs(_e264) * _e311);
                let _e313 = (abs(_e274) * _e311);
                let _e314 = (abs(_e284) * _e311);
                let _e318 = (_e307 * 0.0000009536743f);
                let _e319 = (abs(_e264) * _e318);
                let _e320 = (abs(_e274) * _e318);
                let _e321 = (abs(_e284) * _e318);
                if (_e264 < 0f) {
                    phi_502_ = 0u;
                } else {
                    phi_502_ = 1u;
                }
                let _e324 = phi_502_;
                if (_e274 < 0f) {
                    phi_507_ = 0u;
                } else {
                    phi_507_ = 2u;
                }
                let _e327 = phi_507_;
                if (_e284 < 0f) {
                    phi_512_ = 0u;
                } else {
                    phi_512_ = 4u;
                }
                let _e330 = phi_512_;
                let _e332 = ((_e324 | _e327) | _e330);
                let _e333 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e87, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e333.first[0], _e333.first[1], _e333.first[2], _e333.first[3], _e333.first[4], _e333.first[5], _e333.first[6], _e333.first[7], _e333.first[8], _e333.first[9], _e333.first[10], _e333.first[11], _e333.first[12], _e333.first[13], _e333.first[14], _e333.first[15], _e333.first[16], _e333.first[17], _e333.first[18], _e333.first[19], _e333.first[20], _e333.first[21], _e333.first[22], _e333.first[23], _e333.first[24], _e333.first[25], _e333.first[26], _e333.first[27], _e333.first[28], _e333.first[29], _e333.first[30], _e333.first[31]), array<u32, 32>(_e333.mask[0], _e333.mask[1], _e333.mask[2], _e333.mask[3], _e333.mask[4], _e333.mask[5], _e333.mask[6], _e333.mask[7], _e333.mask[8], _e333.mask[9], _e333.mask[10], _e333.mask[11], _e333.mask[12], _e333.mask[13], _e333.mask[14], _e333.mask[15], _e333.mask[16], _e333.mask[17], _e333.mask[18], _e333.mask[19], _e333.mask[20], _e333.mask[21], _e333.mask[22], _e333.mask[23], _e333.mask[24], _e333.mask[25], _e333.mask[26], _e333.mask[27], _e333.mask[28], _e333.mask[29], _e333.mask[30], _e333.mask[31]), _e333.len, _e333.group, _e333.group_mask);
                let _e407 = local_1.group_mask;
                if ((_e407 & 4278190080u) == 0u) {
                    let _e411 = local_1.len;
                    if (_e411 == 0u) {
                        phi_626_ = false;
                    } else {
                        let _e415 = local_1.len;
                        local_1.len = (_e415 - 1u);
                        let _e418 = local_1.len;
                        if (_e418 < 32u) {
                        } else {
                            return;
                        }
                        let _e423 = local_1.first[(0u + _e418)];
                        local_1.group = _e423;
                        let _e426 = local_1.len;
                        if (_e426 < 32u) {
                        } else {
                            return;
                        }
                        let _e431 = local_1.mask[(0u + _e426)];
                        local_1.group_mask = _e431;
                        phi_626_ = true;
                    }
                    let _e434 = phi_626_;
                    phi_627_ = _e434;
                } else {
                    phi_627_ = true;
                }
                let _e436 = phi_627_;
                if _e436 {
                    let _e438 = local_1.group_mask;
                    let _e444 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e438)), 32u, (_e438 == 0u)));
                    let _e448 = local_1.group_mask;
                    let _e462 = local_1.group_mask;
                    local_1.group_mask = (_e462 & ~((1u << bitcast<u32>((_e444 & 31u)))));
                    let _e465 = local_1.group;
                    phi_658_ = (_e465 + countOneBits(((_e448 & ~((4294967295u << bitcast<u32>((((_e444 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_658_ = 4294967295u;
                }
                let _e468 = phi_658_;
                phi_660_ = _e468;
                phi_663_ = false;
                loop {
                    let _e470 = phi_660_;
                    let _e472 = phi_663_;
                    if (_e470 != 4294967295u) {
                        if (_e470 < _e60) {
                        } else {
                            return;
                        }
                        let _e479 = nodes.member[(0u + _e470)].frame[3u];
                        let _e504 = (bitcast<f32>((((_e479 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e264);
                        let _e505 = (bitcast<f32>((((_e479 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e274);
                        let _e506 = (bitcast<f32>((((_e479 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                        let _e509 = nodes.member[(0u + _e470)].frame[0u];
                        let _e513 = nodes.member[(0u + _e470)].frame[1u];
                        let _e517 = nodes.member[(0u + _e470)].frame[2u];
                        let _e522 = ((bitcast<f32>(_e509) - _e108) * _e264);
                        let _e523 = ((bitcast<f32>(_e513) - _e110) * _e274);
                        let _e524 = ((bitcast<f32>(_e517) - _e112) * _e284);
                        let _e532 = nodes.member[(0u + _e470)].x;
                        if (_e264 < 0f) {
                            let _e543 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e532.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e549 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e543.unnamed.root, _e532.w), _e543.unnamed_1);
                            let _e555 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e549.unnamed, lt_bvh_traverse_Tree(_e532.x, _e549.unnamed_1.first_primitive));
                            phi_743_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e555.unnamed, lt_bvh_traverse_Tree(_e555.unnamed_1.root, _e532.y));
                        } else {
                            let _e571 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e532.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e571.unnamed.root, _e532.y), _e571.unnamed_1);
                            let _e583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e577.unnamed, lt_bvh_traverse_Tree(_e532.z, _e577.unnamed_1.first_primitive));
                            phi_743_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e583.unnamed, lt_bvh_traverse_Tree(_e583.unnamed_1.root, _e532.w));
                        }
                        let _e591 = phi_743_;
                        let _e601 = nodes.member[(0u + _e470)].y;
                        if (_e274 < 0f) {
                            let _e612 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e601.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e618 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e612.unnamed.root, _e601.w), _e612.unnamed_1);
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e618.unnamed, lt_bvh_traverse_Tree(_e601.x, _e618.unnamed_1.first_primitive));
                            phi_770_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e624.unnamed, lt_bvh_traverse_Tree(_e624.unnamed_1.root, _e601.y));
                        } else {
                            let _e640 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e601.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e640.unnamed.root, _e601.y), _e640.unnamed_1);
                            let _e652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e646.unnamed, lt_bvh_traverse_Tree(_e601.z, _e646.unnamed_1.first_primitive));
                            phi_770_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e652.unnamed, lt_bvh_traverse_Tree(_e652.unnamed_1.root, _e601.w));
                        }
                        let _e660 = phi_770_;
                        let _e670 = nodes.member[(0u + _e470)].z;
                        if (_e284 < 0f) {
                            let _e681 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e670.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e687 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e681.unnamed.root, _e670.w), _e681.unnamed_1);
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e687.unnamed, lt_bvh_traverse_Tree(_e670.x, _e687.unnamed_1.first_primitive));
                            phi_797_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e693.unnamed, lt_bvh_traverse_Tree(_e693.unnamed_1.root, _e670.y));
                        } else {
                            let _e709 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e670.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e709.unnamed.root, _e670.y), _e709.unnamed_1);
                            let _e721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e715.unnamed, lt_bvh_traverse_Tree(_e670.z, _e715.unnamed_1.first_primitive));
                            phi_797_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e721.unnamed, lt_bvh_traverse_Tree(_e721.unnamed_1.root, _e670.w));
                        }
                        let _e729 = phi_797_;
                        phi_803_ = 0u;
                        phi_806_ = 0u;
                        loop {
                            let _e739 = phi_803_;
                            let _e741 = phi_806_;
                            local_2 = _e741;
                            local_3 = _e741;
                            local_4 = _e741;
                            let _e742 = (_e739 < 8u);
                            if _e742 {
                                let _e744 = (_e739 >> bitcast<u32>(2i));
                                let _e745 = (_e739 & 3u);
                                if (_e744 == 0u) {
                                    phi_820_ = _e591.unnamed.root;
                                } else {
                                    phi_820_ = _e591.unnamed.first_primitive;
                                }
                                let _e748 = phi_820_;
                                if (_e744 == 0u) {
                                    phi_830_ = _e660.unnamed.root;
                                } else {
                                    phi_830_ = _e660.unnamed.first_primitive;
                                }
                                let _e757 = phi_830_;
                                if (_e744 == 0u) {
                                    phi_840_ = _e729.unnamed.root;
                                } else {
                                    phi_840_ = _e729.unnamed.first_primitive;
                                }
                                let _e766 = phi_840_;
                                let _e779 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e748 >> bitcast<u32>(((_e745 * 8u) & 31u))) & 255u)) * _e504) + (_e522 - _e312)), ((f32(((_e757 >> bitcast<u32>(((_e745 * 8u) & 31u))) & 255u)) * _e505) + (_e523 - _e313)));
                                let _e780 = core_intrinsics_maximum_number_nsz_f32_(_e779, ((f32(((_e766 >> bitcast<u32>(((_e745 * 8u) & 31u))) & 255u)) * _e506) + (_e524 - _e314)));
                                if (_e744 == 0u) {
                                    phi_858_ = _e591.unnamed_1.root;
                                } else {
                                    phi_858_ = _e591.unnamed_1.first_primitive;
                                }
                                let _e783 = phi_858_;
                                if (_e744 == 0u) {
                                    phi_868_ = _e660.unnamed_1.root;
                                } else {
                                    phi_868_ = _e660.unnamed_1.first_primitive;
                                }
                                let _e792 = phi_868_;
                                if (_e744 == 0u) {
                                    phi_878_ = _e729.unnamed_1.root;
                                } else {
                                    phi_878_ = _e729.unnamed_1.first_primitive;
                                }
                                let _e801 = phi_878_;
                                let _e814 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e783 >> bitcast<u32>(((_e745 * 8u) & 31u))) & 255u)) * _e504) + (_e522 + _e312)), ((f32(((_e792 >> bitcast<u32>(((_e745 * 8u) & 31u))) & 255u)) * _e505) + (_e523 + _e313)));
                                let _e815 = core_intrinsics_minimum_number_nsz_f32_(_e814, ((f32(((_e801 >> bitcast<u32>(((_e745 * 8u) & 31u))) & 255u)) * _e506) + (_e524 + _e314)));
                                if (_e780 <= _e815) {
                                    if (_e780 <= _e116) {
                                        if (_e815 >= 0f) {
                                            if (_e744 == 0u) {
                                                let _e822 = nodes.member[(0u + _e470)].links[2u];
                                                phi_914_ = _e822;
                                            } else {
                                                let _e825 = nodes.member[(0u + _e470)].links[3u];
                                                phi_914_ = _e825;
                                            }
                                            let _e827 = phi_914_;
                                            let _e832 = ((_e827 >> bitcast<u32>(((_e745 * 8u) & 31u))) & 255u);
                                            let _e833 = (_e832 & 31u);
                                            if (_e833 >= 24u) {
                                                phi_927_ = (24u + ((_e833 - 24u) ^ _e332));
                                            } else {
                                                phi_927_ = _e833;
                                            }
                                            let _e839 = phi_927_;
                                            phi_932_ = (_e741 | ((_e832 >> bitcast<u32>(5i)) << bitcast<u32>((_e839 & 31u))));
                                        } else {
                                            phi_932_ = _e741;
                                        }
                                        let _e847 = phi_932_;
                                        phi_933_ = _e847;
                                    } else {
                                        phi_933_ = _e741;
                                    }
                                    let _e849 = phi_933_;
                                    phi_934_ = _e849;
                                } else {
                                    phi_934_ = _e741;
                                }
                                let _e851 = phi_934_;
                                phi_804_ = (_e739 + 1u);
                                phi_807_ = _e851;
                            } else {
                                phi_804_ = u32();
                                phi_807_ = u32();
                            }
                            let _e854 = phi_804_;
                            let _e856 = phi_807_;
                            continue;
                            continuing {
                                phi_803_ = _e854;
                                phi_806_ = _e856;
                                break if !(_e742);
                            }
                        }
                        let _e860 = nodes.member[(0u + _e470)].links[0u];
                        let _e864 = nodes.member[(0u + _e470)].frame[3u];
                        let _e868 = local_2;
                        if ((_e868 & 4278190080u) == 0u) {
                        } else {
                            let _e872 = local_1.group_mask;
                            if ((_e872 & 4278190080u) == 0u) {
                            } else {
                                let _e876 = local_1.len;
                                if (_e876 < 32u) {
                                    let _e879 = local_1.group;
                                    let _e881 = local_1.len;
                                    if (_e881 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e881)] = _e879;
                                    let _e887 = local_1.group_mask;
                                    let _e889 = local_1.len;
                                    if (_e889 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e889)] = _e887;
                                    let _e896 = local_1.len;
                                    local_1.len = (_e896 + 1u);
                                }
                            }
                            local_1.group = (_e87 + _e860);
                            let _e900 = local_3;
                            local_1.group_mask = ((_e900 & 4278190080u) | (_e864 >> bitcast<u32>(24i)));
                        }
                        let _e905 = local_4;
                        phi_992_ = (_e905 & 16777215u);
                        phi_995_ = _e472;
                        loop {
                            let _e908 = phi_992_;
                            let _e910 = phi_995_;
                            local_15 = _e910;
                            let _e911 = (_e908 == 0u);
                            local_10 = _e911;
                            local_16 = _e911;
                            if _e911 {
                                phi_993_ = u32();
                                phi_996_ = bool();
                                phi_2639_ = false;
                            } else {
                                let _e914 = nodes.member[(0u + _e470)].links[1u];
                                let _e918 = (_e914 + select(firstTrailingBit(_e908), 32u, (_e908 == 0u)));
                                if (_e918 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e925 = instances.member[(0u + _e918)].low_world;
                                let _e927 = instances.member[(0u + _e918)].high_world;
                                let _e934 = ((_e925.x - _e108) * _e264);
                                let _e935 = ((_e925.y - _e110) * _e274);
                                let _e936 = ((_e925.z - _e112) * _e284);
                                let _e943 = ((_e927.x - _e108) * _e264);
                                let _e944 = ((_e927.y - _e110) * _e274);
                                let _e945 = ((_e927.z - _e112) * _e284);
                                if (_e934 < _e943) {
                                    phi_1044_ = _e934;
                                } else {
                                    phi_1044_ = _e943;
                                }
                                let _e948 = phi_1044_;
                                if (_e935 < _e944) {
                                    phi_1049_ = _e935;
                                } else {
                                    phi_1049_ = _e944;
                                }
                                let _e951 = phi_1049_;
                                if (_e936 < _e945) {
                                    phi_1054_ = _e936;
                                } else {
                                    phi_1054_ = _e945;
                                }
                                let _e954 = phi_1054_;
                                if (_e934 > _e943) {
                                    phi_1062_ = _e934;
                                } else {
                                    phi_1062_ = _e943;
                                }
                                let _e960 = phi_1062_;
                                if (_e935 > _e944) {
                                    phi_1067_ = _e935;
                                } else {
                                    phi_1067_ = _e944;
                                }
                                let _e963 = phi_1067_;
                                if (_e936 > _e945) {
                                    phi_1072_ = _e936;
                                } else {
                                    phi_1072_ = _e945;
                                }
                                let _e966 = phi_1072_;
                                let _e970 = core_intrinsics_maximum_number_nsz_f32_((_e948 - _e319), (_e951 - _e320));
                                let _e971 = core_intrinsics_maximum_number_nsz_f32_(_e970, (_e954 - _e321));
                                let _e972 = core_intrinsics_minimum_number_nsz_f32_((_e960 + _e319), (_e963 + _e320));
                                let _e973 = core_intrinsics_minimum_number_nsz_f32_(_e972, (_e966 + _e321));
                                if (_e971 <= _e973) {
                                    if (_e971 <= _e116) {
                                        if (_e973 >= 0f) {
                                            let _e979 = instances.member[(0u + _e918)].world_to_object[0u];
                                            let _e990 = ((((_e979.x * _e108) + (_e979.y * _e110)) + (_e979.z * _e112)) + (_e979.w * 1f));
                                            let _e992 = instances.member[(0u + _e918)].world_to_object[1u];
                                            let _e1003 = ((((_e992.x * _e108) + (_e992.y * _e110)) + (_e992.z * _e112)) + (_e992.w * 1f));
                                            let _e1005 = instances.member[(0u + _e918)].world_to_object[2u];
                                            let _e1016 = ((((_e1005.x * _e108) + (_e1005.y * _e110)) + (_e1005.z * _e112)) + (_e1005.w * 1f));
                                            let _e1019 = instances.member[(0u + _e918)].world_to_object[0u];
                                            let _e1030 = ((((_e1019.x * _e124) + (_e1019.y * _e125)) + (_e1019.z * _e126)) + (_e1019.w * 0f));
                                            let _e1032 = instances.member[(0u + _e918)].world_to_object[1u];
                                            let _e1043 = ((((_e1032.x * _e124) + (_e1032.y * _e125)) + (_e1032.z * _e126)) + (_e1032.w * 0f));
                                            let _e1045 = instances.member[(0u + _e918)].world_to_object[2u];
                                            let _e1056 = ((((_e1045.x * _e124) + (_e1045.y * _e125)) + (_e1045.z * _e126)) + (_e1045.w * 0f));
                                            let _e1059 = instances.member[(0u + _e918)].root;
                                            let _e1061 = instances.member[(0u + _e918)].first_triangle;
                                            let _e1065 = abs(_e1030);
                                            let _e1066 = abs(_e1043);
                                            let _e1067 = abs(_e1056);
                                            if (abs(_e990) < 1000000000000000f) {
                                                if (abs(_e1003) < 1000000000000000f) {
                                                    if (abs(_e1016) < 1000000000000000f) {
                                                        if (_e1065 < 1000000000000000f) {
                                                            if (_e1066 < 1000000000000000f) {
                                                                if (_e1067 < 1000000000000000f) {
                                                                    if (_e1065 > 0f) {
                                                                        phi_1217_ = bool();
                                                                        phi_1218_ = true;
                                                                    } else {
                                                                        let _e1075 = (_e1066 > 0f);
                                                                        if _e1075 {
                                                                            phi_1216_ = bool();
                                                                        } else {
                                                                            phi_1216_ = (_e1067 > 0f);
                                                                        }
                                                                        let _e1078 = phi_1216_;
                                                                        phi_1217_ = _e1078;
                                                                        phi_1218_ = _e1075;
                                                                    }
                                                                    let _e1080 = phi_1217_;
                                                                    let _e1082 = phi_1218_;
                                                                    if _e1082 {
                                                                        phi_1222_ = true;
                                                                    } else {
                                                                        phi_1222_ = _e1080;
                                                                    }
                                                                    let _e1084 = phi_1222_;
                                                                    phi_1223_ = _e1084;
                                                                    phi_1224_ = false;
                                                                } else {
                                                                    phi_1223_ = bool();
                                                                    phi_1224_ = true;
                                                                }
                                                                let _e1086 = phi_1223_;
                                                                let _e1088 = phi_1224_;
                                                                phi_1225_ = _e1086;
                                                                phi_1226_ = false;
                                                                phi_1227_ = _e1088;
                                                            } else {
                                                                phi_1225_ = bool();
                                                                phi_1226_ = true;
                                                                phi_1227_ = false;
                                                            }
                                                            let _e1090 = phi_1225_;
                                                            let _e1092 = phi_1226_;
                                                            let _e1094 = phi_1227_;
                                                            phi_1228_ = _e1090;
                                                            phi_1229_ = _e1092;
                                                            phi_1230_ = _e1094;
                                                        } else {
                                                            phi_1228_ = bool();
                                                            phi_1229_ = true;
                                                            phi_1230_ = false;
                                                        }
                                                        let _e1096 = phi_1228_;
                                                        let _e1098 = phi_1229_;
                                                        let _e1100 = phi_1230_;
                                                        phi_1231_ = _e1096;
                                                        phi_1232_ = _e1098;
                                                        phi_1233_ = _e1100;
                                                    } else {
                                                        phi_1231_ = bool();
                                                        phi_1232_ = true;
                                                        phi_1233_ = false;
                                                    }
                                                    let _e1102 = phi_1231_;
                                                    let _e1104 = phi_1232_;
                                                    let _e1106 = phi_1233_;
                                                    phi_1234_ = _e1102;
                                                    phi_1235_ = _e1104;
                                                    phi_1236_ = _e1106;
                                                } else {
                                                    phi_1234_ = bool();
                                                    phi_1235_ = true;
                                                    phi_1236_ = false;
                                                }
                                                let _e1108 = phi_1234_;
                                                let _e1110 = phi_1235_;
                                                let _e1112 = phi_1236_;
                                                phi_1237_ = _e1108;
                                                phi_1238_ = _e1110;
                                                phi_1239_ = _e1112;
                                            } else {
                                                phi_1237_ = bool();
                                                phi_1238_ = true;
                                                phi_1239_ = false;
                                            }
                                            let _e1114 = phi_1237_;
                                            let _e1116 = phi_1238_;
                                            let _e1118 = phi_1239_;
                                            if _e1116 {
                                                phi_1243_ = true;
                                            } else {
                                                phi_1243_ = _e1118;
                                            }
                                            let _e1120 = phi_1243_;
                                            if _e1120 {
                                                phi_1247_ = false;
                                            } else {
                                                phi_1247_ = _e1114;
                                            }
                                            let _e1122 = phi_1247_;
                                            if _e1122 {
                                                let _e1123 = (_e1059 >= _e60);
                                                if _e1123 {
                                                    phi_2619_ = bool();
                                                } else {
                                                    if (_e1059 < _e60) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1129 = nodes.member[(0u + _e1059)].frame[0u];
                                                    let _e1133 = nodes.member[(0u + _e1059)].frame[1u];
                                                    let _e1137 = nodes.member[(0u + _e1059)].frame[2u];
                                                    let _e1141 = nodes.member[(0u + _e1059)].frame[0u];
                                                    let _e1145 = nodes.member[(0u + _e1059)].frame[1u];
                                                    let _e1149 = nodes.member[(0u + _e1059)].frame[2u];
                                                    let _e1153 = nodes.member[(0u + _e1059)].frame[3u];
                                                    let _e1187 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1030), abs(_e1043));
                                                    let _e1188 = core_intrinsics_maximum_number_nsz_f32_(_e1187, abs(_e1056));
                                                    let _e1189 = (_e1188 * 0.0000000000009094947f);
                                                    if (abs(_e1030) < _e1189) {
                                                        phi_1317_ = _e1189;
                                                    } else {
                                                        phi_1317_ = abs(_e1030);
                                                    }
                                                    let _e1194 = phi_1317_;
                                                    if (_e1030 < 0f) {
                                                        phi_1324_ = (-1f / _e1194);
                                                    } else {
                                                        phi_1324_ = (1f / _e1194);
                                                    }
                                                    let _e1199 = phi_1324_;
                                                    if (abs(_e1043) < _e1189) {
                                                        phi_1331_ = _e1189;
                                                    } else {
                                                        phi_1331_ = abs(_e1043);
                                                    }
                                                    let _e1204 = phi_1331_;
                                                    if (_e1043 < 0f) {
                                                        phi_1338_ = (-1f / _e1204);
                                                    } else {
                                                        phi_1338_ = (1f / _e1204);
                                                    }
                                                    let _e1209 = phi_1338_;
                                                    if (abs(_e1056) < _e1189) {
                                                        phi_1345_ = _e1189;
                                                    } else {
                                                        phi_1345_ = abs(_e1056);
                                                    }
                                                    let _e1214 = phi_1345_;
                                                    if (_e1056 < 0f) {
                                                        phi_1352_ = (-1f / _e1214);
                                                    } else {
                                                        phi_1352_ = (1f / _e1214);
                                                    }
                                                    let _e1219 = phi_1352_;
                                                    let _e1223 = abs((bitcast<f32>(_e1129) - _e990));
                                                    let _e1224 = abs((bitcast<f32>(_e1133) - _e1003));
                                                    let _e1225 = abs((bitcast<f32>(_e1137) - _e1016));
                                                    let _e1229 = abs(((bitcast<f32>(_e1141) + (bitcast<f32>((((_e1153 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e990));
                                                    let _e1230 = abs(((bitcast<f32>(_e1145) + (bitcast<f32>((((_e1153 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1003));
                                                    let _e1231 = abs(((bitcast<f32>(_e1149) + (bitcast<f32>((((_e1153 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1016));
                                                    if (_e1223 > _e1229) {
                                                        phi_1369_ = _e1223;
                                                    } else {
                                                        phi_1369_ = _e1229;
                                                    }
                                                    let _e1234 = phi_1369_;
                                                    if (_e1224 > _e1230) {
                                                        phi_1374_ = _e1224;
                                                    } else {
                                                        phi_1374_ = _e1230;
                                                    }
                                                    let _e1237 = phi_1374_;
                                                    if (_e1225 > _e1231) {
                                                        phi_1379_ = _e1225;
                                                    } else {
                                                        phi_1379_ = _e1231;
                                                    }
                                                    let _e1240 = phi_1379_;
                                                    let _e1241 = core_intrinsics_maximum_number_nsz_f32_(_e1234, _e1237);
                                                    let _e1242 = core_intrinsics_maximum_number_nsz_f32_(_e1241, _e1240);
                                                    let _e1246 = (_e1242 * 0.0000019073486f);
                                                    let _e1247 = (abs(_e1199) * _e1246);
                                                    let _e1248 = (abs(_e1209) * _e1246);
                                                    let _e1249 = (abs(_e1219) * _e1246);
                                                    let _e1253 = (_e1242 * 0.0000009536743f);
                                                    let _e1254 = (abs(_e1199) * _e1253);
                                                    let _e1255 = (abs(_e1209) * _e1253);
                                                    let _e1256 = (abs(_e1219) * _e1253);
                                                    let _e1257 = abs(_e1030);
                                                    let _e1258 = abs(_e1043);
                                                    let _e1259 = abs(_e1056);
                                                    if (_e1257 >= _e1258) {
                                                        if (_e1257 >= _e1259) {
                                                            phi_1407_ = false;
                                                        } else {
                                                            phi_1407_ = true;
                                                        }
                                                        let _e1263 = phi_1407_;
                                                        phi_1408_ = _e1263;
                                                    } else {
                                                        phi_1408_ = true;
                                                    }
                                                    let _e1265 = phi_1408_;
                                                    if _e1265 {
                                                        if (_e1258 >= _e1259) {
                                                            phi_1416_ = 1u;
                                                        } else {
                                                            phi_1416_ = 2u;
                                                        }
                                                        let _e1268 = phi_1416_;
                                                        phi_1417_ = _e1268;
                                                    } else {
                                                        phi_1417_ = 0u;
                                                    }
                                                    let _e1270 = phi_1417_;
                                                    if (_e1270 == 0u) {
                                                        phi_1429_ = vec3<f32>(_e1043, _e1056, _e1030);
                                                    } else {
                                                        if (_e1270 == 1u) {
                                                            phi_1428_ = vec3<f32>(_e1056, _e1030, _e1043);
                                                        } else {
                                                            phi_1428_ = vec3<f32>(_e1030, _e1043, _e1056);
                                                        }
                                                        let _e1276 = phi_1428_;
                                                        phi_1429_ = _e1276;
                                                    }
                                                    let _e1278 = phi_1429_;
                                                    let _e1281 = (_e1278.x / _e1278.z);
                                                    let _e1284 = (_e1278.y / _e1278.z);
                                                    if (_e1199 < 0f) {
                                                        phi_1442_ = 0u;
                                                    } else {
                                                        phi_1442_ = 1u;
                                                    }
                                                    let _e1289 = phi_1442_;
                                                    if (_e1209 < 0f) {
                                                        phi_1447_ = 0u;
                                                    } else {
                                                        phi_1447_ = 2u;
                                                    }
                                                    let _e1292 = phi_1447_;
                                                    if (_e1219 < 0f) {
                                                        phi_1452_ = 0u;
                                                    } else {
                                                        phi_1452_ = 4u;
                                                    }
                                                    let _e1295 = phi_1452_;
                                                    let _e1297 = ((_e1289 | _e1292) | _e1295);
                                                    let _e1298 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1059, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1298.first[0], _e1298.first[1], _e1298.first[2], _e1298.first[3], _e1298.first[4], _e1298.first[5], _e1298.first[6], _e1298.first[7], _e1298.first[8], _e1298.first[9], _e1298.first[10], _e1298.first[11], _e1298.first[12], _e1298.first[13], _e1298.first[14], _e1298.first[15], _e1298.first[16], _e1298.first[17], _e1298.first[18], _e1298.first[19], _e1298.first[20], _e1298.first[21], _e1298.first[22], _e1298.first[23], _e1298.first[24], _e1298.first[25], _e1298.first[26], _e1298.first[27], _e1298.first[28], _e1298.first[29], _e1298.first[30], _e1298.first[31]), array<u32, 32>(_e1298.mask[0], _e1298.mask[1], _e1298.mask[2], _e1298.mask[3], _e1298.mask[4], _e1298.mask[5], _e1298.mask[6], _e1298.mask[7], _e1298.mask[8], _e1298.mask[9], _e1298.mask[10], _e1298.mask[11], _e1298.mask[12], _e1298.mask[13], _e1298.mask[14], _e1298.mask[15], _e1298.mask[16], _e1298.mask[17], _e1298.mask[18], _e1298.mask[19], _e1298.mask[20], _e1298.mask[21], _e1298.mask[22], _e1298.mask[23], _e1298.mask[24], _e1298.mask[25], _e1298.mask[26], _e1298.mask[27], _e1298.mask[28], _e1298.mask[29], _e1298.mask[30], _e1298.mask[31]), _e1298.len, _e1298.group, _e1298.group_mask);
                                                    let _e1372 = local.group_mask;
                                                    if ((_e1372 & 4278190080u) == 0u) {
                                                        let _e1376 = local.len;
                                                        if (_e1376 == 0u) {
                                                            phi_1566_ = false;
                                                        } else {
                                                            let _e1380 = local.len;
                                                            local.len = (_e1380 - 1u);
                                                            let _e1383 = local.len;
                                                            if (_e1383 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1388 = local.first[(0u + _e1383)];
                                                            local.group = _e1388;
                                                            let _e1391 = local.len;
                                                            if (_e1391 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1396 = local.mask[(0u + _e1391)];
                                                            local.group_mask = _e1396;
                                                            phi_1566_ = true;
                                                        }
                                                        let _e1399 = phi_1566_;
                                                        phi_1567_ = _e1399;
                                                    } else {
                                                        phi_1567_ = true;
                                                    }
                                                    let _e1401 = phi_1567_;
                                                    if _e1401 {
                                                        let _e1403 = local.group_mask;
                                                        let _e1409 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1403)), 32u, (_e1403 == 0u)));
                                                        let _e1413 = local.group_mask;
                                                        let _e1427 = local.group_mask;
                                                        local.group_mask = (_e1427 & ~((1u << bitcast<u32>((_e1409 & 31u)))));
                                                        let _e1430 = local.group;
                                                        phi_1598_ = (_e1430 + countOneBits(((_e1413 & ~((4294967295u << bitcast<u32>((((_e1409 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1598_ = 4294967295u;
                                                    }
                                                    let _e1433 = phi_1598_;
                                                    phi_1600_ = _e1433;
                                                    phi_1603_ = _e910;
                                                    loop {
                                                        let _e1435 = phi_1600_;
                                                        let _e1437 = phi_1603_;
                                                        local_14 = _e1437;
                                                        if (_e1435 != 4294967295u) {
                                                            if (_e1435 < _e60) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1444 = nodes.member[(0u + _e1435)].frame[3u];
                                                            let _e1469 = (bitcast<f32>((((_e1444 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1199);
                                                            let _e1470 = (bitcast<f32>((((_e1444 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1209);
                                                            let _e1471 = (bitcast<f32>((((_e1444 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1219);
                                                            let _e1474 = nodes.member[(0u + _e1435)].frame[0u];
                                                            let _e1478 = nodes.member[(0u + _e1435)].frame[1u];
                                                            let _e1482 = nodes.member[(0u + _e1435)].frame[2u];
                                                            let _e1487 = ((bitcast<f32>(_e1474) - _e990) * _e1199);
                                                            let _e1488 = ((bitcast<f32>(_e1478) - _e1003) * _e1209);
                                                            let _e1489 = ((bitcast<f32>(_e1482) - _e1016) * _e1219);
                                                            let _e1497 = nodes.member[(0u + _e1435)].x;
                                                            if (_e1199 < 0f) {
                                                                let _e1508 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1497.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1514 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1508.unnamed.root, _e1497.w), _e1508.unnamed_1);
                                                                let _e1520 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1514.unnamed, lt_bvh_traverse_Tree(_e1497.x, _e1514.unnamed_1.first_primitive));
                                                                phi_1683_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1520.unnamed, lt_bvh_traverse_Tree(_e1520.unnamed_1.root, _e1497.y));
                                                            } else {
                                                                let _e1536 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1497.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1542 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1536.unnamed.root, _e1497.y), _e1536.unnamed_1);
                                                                let _e1548 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1542.unnamed, lt_bvh_traverse_Tree(_e1497.z, _e1542.unnamed_1.first_primitive));
                                                                phi_1683_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1548.unnamed, lt_bvh_traverse_Tree(_e1548.unnamed_1.root, _e1497.w));
                                                            }
                                                            let _e1556 = phi_1683_;
                                                            let _e1566 = nodes.member[(0u + _e1435)].y;
                                                            if (_e1209 < 0f) {
                                                                let _e1577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1577.unnamed.root, _e1566.w), _e1577.unnamed_1);
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1583.unnamed, lt_bvh_traverse_Tree(_e1566.x, _e1583.unnamed_1.first_primitive));
                                                                phi_1710_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1589.unnamed, lt_bvh_traverse_Tree(_e1589.unnamed_1.root, _e1566.y));
                                                            } else {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1566.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1605.unnamed.root, _e1566.y), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_bvh_traverse_Tree(_e1566.z, _e1611.unnamed_1.first_primitive));
                                                                phi_1710_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_bvh_traverse_Tree(_e1617.unnamed_1.root, _e1566.w));
                                                            }
                                                            let _e1625 = phi_1710_;
                                                            let _e1635 = nodes.member[(0u + _e1435)].z;
                                                            if (_e1219 < 0f) {
                                                                let _e1646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1646.unnamed.root, _e1635.w), _e1646.unnamed_1);
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1652.unnamed, lt_bvh_traverse_Tree(_e1635.x, _e1652.unnamed_1.first_primitive));
                                                                phi_1737_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1658.unnamed, lt_bvh_traverse_Tree(_e1658.unnamed_1.root, _e1635.y));
                                                            } else {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1635.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1674.unnamed.root, _e1635.y), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_bvh_traverse_Tree(_e1635.z, _e1680.unnamed_1.first_primitive));
                                                                phi_1737_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_bvh_traverse_Tree(_e1686.unnamed_1.root, _e1635.w));
                                                            }
                                                            let _e1694 = phi_1737_;
                                                            phi_1743_ = 0u;
                                                            phi_1746_ = 0u;
                                                            loop {
                                                                let _e1704 = phi_1743_;
                                                                let _e1706 = phi_1746_;
                                                                local_5 = _e1706;
                                                                local_6 = _e1706;
                                                                local_7 = _e1706;
                                                                let _e1707 = (_e1704 < 8u);
                                                                if _e1707 {
                                                                    let _e1709 = (_e1704 >> bitcast<u32>(2i));
                                                                    let _e1710 = (_e1704 & 3u);
                                                                    if (_e1709 == 0u) {
                                                                        phi_1760_ = _e1556.unnamed.root;
                                                                    } else {
                                                                        phi_1760_ = _e1556.unnamed.first_primitive;
                                                                    }
                                                                    let _e1713 = phi_1760_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1770_ = _e1625.unnamed.root;
                                                                    } else {
                                                                        phi_1770_ = _e1625.unnamed.first_primitive;
                                                                    }
                                                                    let _e1722 = phi_1770_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1780_ = _e1694.unnamed.root;
                                                                    } else {
                                                                        phi_1780_ = _e1694.unnamed.first_primitive;
                                                                    }
                                                                    let _e1731 = phi_1780_;
                                                                    let _e1744 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1713 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 - _e1247)), ((f32(((_e1722 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 - _e1248)));
                                                                    let _e1745 = core_intrinsics_maximum_number_nsz_f32_(_e1744, ((f32(((_e1731 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 - _e1249)));
                                                                    if (_e1709 == 0u) {
                                                                        phi_1798_ = _e1556.unnamed_1.root;
                                                                    } else {
                                                                        phi_1798_ = _e1556.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1748 = phi_1798_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1808_ = _e1625.unnamed_1.root;
                                                                    } else {
                                                                        phi_1808_ = _e1625.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1757 = phi_1808_;
                                                                    if (_e1709 == 0u) {
                                                                        phi_1818_ = _e1694.unnamed_1.root;
                                                                    } else {
                                                                        phi_1818_ = _e1694.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1766 = phi_1818_;
                                                                    let _e1779 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1748 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1469) + (_e1487 + _e1247)), ((f32(((_e1757 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1470) + (_e1488 + _e1248)));
                                                                    let _e1780 = core_intrinsics_minimum_number_nsz_f32_(_e1779, ((f32(((_e1766 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u)) * _e1471) + (_e1489 + _e1249)));
                                                                    if (_e1745 <= _e1780) {
                                                                        if (_e1745 <= _e116) {
                                                                            if (_e1780 >= 0f) {
                                                                                if (_e1709 == 0u) {
                                                                                    let _e1787 = nodes.member[(0u + _e1435)].links[2u];
                                                                                    phi_1854_ = _e1787;
                                                                                } else {
                                                                                    let _e1790 = nodes.member[(0u + _e1435)].links[3u];
                                                                                    phi_1854_ = _e1790;
                                                                                }
                                                                                let _e1792 = phi_1854_;
                                                                                let _e1797 = ((_e1792 >> bitcast<u32>(((_e1710 * 8u) & 31u))) & 255u);
                                                                                let _e1798 = (_e1797 & 31u);
                                                                                if (_e1798 >= 24u) {
                                                                                    phi_1867_ = (24u + ((_e1798 - 24u) ^ _e1297));
                                                                                } else {
                                                                                    phi_1867_ = _e1798;
                                                                                }
                                                                                let _e1804 = phi_1867_;
                                                                                phi_1872_ = (_e1706 | ((_e1797 >> bitcast<u32>(5i)) << bitcast<u32>((_e1804 & 31u))));
                                                                            } else {
                                                                                phi_1872_ = _e1706;
                                                                            }
                                                                            let _e1812 = phi_1872_;
                                                                            phi_1873_ = _e1812;
                                                                        } else {
                                                                            phi_1873_ = _e1706;
                                                                        }
                                                                        let _e1814 = phi_1873_;
                                                                        phi_1874_ = _e1814;
                                                                    } else {
                                                                        phi_1874_ = _e1706;
                                                                    }
                                                                    let _e1816 = phi_1874_;
                                                                    phi_1744_ = (_e1704 + 1u);
                                                                    phi_1747_ = _e1816;
                                                                } else {
                                                                    phi_1744_ = u32();
                                                                    phi_1747_ = u32();
                                                                }
                                                                let _e1819 = phi_1744_;
                                                                let _e1821 = phi_1747_;
                                                                continue;
                                                                continuing {
                                                                    phi_1743_ = _e1819;
                                                                    phi_1746_ = _e1821;
                                                                    break if !(_e1707);
                                                                }
                                                            }
                                                            let _e1825 = nodes.member[(0u + _e1435)].links[0u];
                                                            let _e1829 = nodes.member[(0u + _e1435)].frame[3u];
                                                            let _e1833 = local_5;
                                                            if ((_e1833 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1837 = local.group_mask;
                                                                if ((_e1837 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1841 = local.len;
                                                                    if (_e1841 < 32u) {
                                                                        let _e1844 = local.group;
                                                                        let _e1846 = local.len;
                                                                        if (_e1846 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1846)] = _e1844;
                                                                        let _e1852 = local.group_mask;
                                                                        let _e1854 = local.len;
                                                                        if (_e1854 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1854)] = _e1852;
                                                                        let _e1861 = local.len;
                                                                        local.len = (_e1861 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1059 + _e1825);
                                                                let _e1865 = local_6;
                                                                local.group_mask = ((_e1865 & 4278190080u) | (_e1829 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1870 = local_7;
                                                            phi_1932_ = (_e1870 & 16777215u);
                                                            phi_1935_ = _e1437;
                                                            loop {
                                                                let _e1873 = phi_1932_;
                                                                let _e1875 = phi_1935_;
                                                                local_12 = _e1875;
                                                                let _e1876 = (_e1873 == 0u);
                                                                local_8 = _e1876;
                                                                local_13 = _e1876;
                                                                if _e1876 {
                                                                    phi_1933_ = u32();
                                                                    phi_1936_ = bool();
                                                                    phi_2533_ = false;
                                                                } else {
                                                                    let _e1879 = nodes.member[(0u + _e1435)].links[1u];
                                                                    let _e1884 = ((_e1061 + _e1879) + select(firstTrailingBit(_e1873), 32u, (_e1873 == 0u)));
                                                                    if (_e1884 < arrayLength((&triangles.member))) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1891 = triangles.member[(0u + _e1884)].v0_;
                                                                    let _e1893 = (_e1891.x - _e990);
                                                                    let _e1895 = (_e1891.y - _e1003);
                                                                    let _e1897 = (_e1891.z - _e1016);
                                                                    if (_e1270 == 0u) {
                                                                        phi_1980_ = vec3<f32>(_e1895, _e1897, _e1893);
                                                                    } else {
                                                                        if (_e1270 == 1u) {
                                                                            phi_1979_ = vec3<f32>(_e1897, _e1893, _e1895);
                                                                        } else {
                                                                            phi_1979_ = (_e1891 - vec3<f32>(_e990, _e1003, _e1016));
                                                                        }
                                                                        let _e1905 = phi_1979_;
                                                                        phi_1980_ = _e1905;
                                                                    }
                                                                    let _e1907 = phi_1980_;
                                                                    let _e1911 = (_e1907.x - (_e1281 * _e1907.z));
                                                                    let _e1915 = (_e1907.y - (_e1284 * _e1907.z));
                                                                    let _e1917 = triangles.member[(0u + _e1884)].v1_;
                                                                    let _e1919 = (_e1917.x - _e990);
                                                                    let _e1921 = (_e1917.y - _e1003);
                                                                    let _e1923 = (_e1917.z - _e1016);
                                                                    if (_e1270 == 0u) {
                                                                        phi_2010_ = vec3<f32>(_e1921, _e1923, _e1919);
                                                                    } else {
                                                                        if (_e1270 == 1u) {
                                                                            phi_2009_ = vec3<f32>(_e1923, _e1919, _e1921);
                                                                        } else {
                                                                            phi_2009_ = (_e1917 - vec3<f32>(_e990, _e1003, _e1016));
                                                                        }
                                                                        let _e1931 = phi_2009_;
                                                                        phi_2010_ = _e1931;
                                                                    }
                                                                    let _e1933 = phi_2010_;
                                                                    let _e1937 = (_e1933.x - (_e1281 * _e1933.z));
                                                                    let _e1941 = (_e1933.y - (_e1284 * _e1933.z));
                                                                    let _e1943 = triangles.member[(0u + _e1884)].v2_;
                                                                    let _e1945 = (_e1943.x - _e990);
                                                                    let _e1947 = (_e1943.y - _e1003);
                                                                    let _e1949 = (_e1943.z - _e1016);
                                                                    if (_e1270 == 0u) {
                                                                        phi_2040_ = vec3<f32>(_e1947, _e1949, _e1945);
                                                                    } else {
                                                                        if (_e1270 == 1u) {
                                                                            phi_2039_ = vec3<f32>(_e1949, _e1945, _e1947);
                                                                        } else {
                                                                            phi_2039_ = (_e1943 - vec3<f32>(_e990, _e1003, _e1016));
                                                                        }
                                                                        let _e1957 = phi_2039_;
                                                                        phi_2040_ = _e1957;
                                                                    }
                                                                    let _e1959 = phi_2040_;
                                                                    let _e1963 = (_e1959.x - (_e1281 * _e1959.z));
                                                                    let _e1967 = (_e1959.y - (_e1284 * _e1959.z));
                                                                    if (_e1937 < _e1963) {
                                                                        phi_2059_ = true;
                                                                    } else {
                                                                        if (_e1937 == _e1963) {
                                                                            phi_2058_ = (_e1941 < _e1967);
                                                                        } else {
                                                                            phi_2058_ = false;
                                                                        }
                                                                        let _e1972 = phi_2058_;
                                                                        phi_2059_ = _e1972;
                                                                    }
                                                                    let _e1974 = phi_2059_;
                                                                    if _e1974 {
                                                                        phi_2063_ = _e1967;
                                                                        phi_2064_ = _e1963;
                                                                        phi_2065_ = _e1941;
                                                                        phi_2066_ = _e1937;
                                                                    } else {
                                                                        phi_2063_ = _e1941;
                                                                        phi_2064_ = _e1937;
                                                                        phi_2065_ = _e1967;
                                                                        phi_2066_ = _e1963;
                                                                    }
                                                                    let _e1976 = phi_2063_;
                                                                    let _e1978 = phi_2064_;
                                                                    let _e1980 = phi_2065_;
                                                                    let _e1982 = phi_2066_;
                                                                    let _e1985 = ((_e1982 * _e1976) - (_e1980 * _e1978));
                                                                    if _e1974 {
                                                                        phi_2074_ = -(_e1985);
                                                                    } else {
                                                                        phi_2074_ = _e1985;
                                                                    }
                                                                    let _e1988 = phi_2074_;
                                                                    if (_e1963 < _e1911) {
                                                                        phi_2085_ = true;
                                                                    } else {
                                                                        if (_e1963 == _e1911) {
                                                                            phi_2084_ = (_e1967 < _e1915);
                                                                        } else {
                                                                            phi_2084_ = false;
                                                                        }
                                                                        let _e1993 = phi_2084_;
                                                                        phi_2085_ = _e1993;
                                                                    }
                                                                    let _e1995 = phi_2085_;
                                                                    if _e1995 {
                                                                        phi_2089_ = _e1915;
                                                                        phi_2090_ = _e1911;
                                                                        phi_2091_ = _e1967;
                                                                        phi_2092_ = _e1963;
                                                                    } else {
                                                                        phi_2089_ = _e1967;
                                                                        phi_2090_ = _e1963;
                                                                        phi_2091_ = _e1915;
                                                                        phi_2092_ = _e1911;
                                                                    }
                                                                    let _e1997 = phi_2089_;
                                                                    let _e1999 = phi_2090_;
                                                                    let _e2001 = phi_2091_;
                                                                    let _e2003 = phi_2092_;
                                                                    let _e2006 = ((_e2003 * _e1997) - (_e2001 * _e1999));
                                                                    if _e1995 {
                                                                        phi_2100_ = -(_e2006);
                                                                    } else {
                                                                        phi_2100_ = _e2006;
                                                                    }
                                                                    let _e2009 = phi_2100_;
                                                                    if (_e1911 < _e1937) {
                                                                        phi_2111_ = true;
                                                                    } else {
                                                                        if (_e1911 == _e1937) {
                                                                            phi_2110_ = (_e1915 < _e1941);
                                                                        } else {
                                                                            phi_2110_ = false;
                                                                        }
                                                                        let _e2014 = phi_2110_;
                                                                        phi_2111_ = _e2014;
                                                                    }
                                                                    let _e2016 = phi_2111_;
                                                                    if _e2016 {
                                                                        phi_2115_ = _e1941;
                                                                        phi_2116_ = _e1937;
                                                                        phi_2117_ = _e1915;
                                                                        phi_2118_ = _e1911;
                                                                    } else {
                                                                        phi_2115_ = _e1915;
                                                                        phi_2116_ = _e1911;
                                                                        phi_2117_ = _e1941;
                                                                        phi_2118_ = _e1937;
                                                                    }
                                                                    let _e2018 = phi_2115_;
                                                                    let _e2020 = phi_2116_;
                                                                    let _e2022 = phi_2117_;
                                                                    let _e2024 = phi_2118_;
                                                                    let _e2027 = ((_e2024 * _e2018) - (_e2022 * _e2020));
                                                                    if _e2016 {
                                                                        phi_2126_ = -(_e2027);
                                                                    } else {
                                                                        phi_2126_ = _e2027;
                                                                    }
                                                                    let _e2030 = phi_2126_;
                                                                    if (_e1988 >= 0f) {
                                                                        if (_e2009 >= 0f) {
                                                                            if (_e2030 >= 0f) {
                                                                                phi_2141_ = ((_e1988 + _e2009) + _e2030);
                                                                                phi_2142_ = false;
                                                                            } else {
                                                                                phi_2141_ = f32();
                                                                                phi_2142_ = true;
                                                                            }
                                                                            let _e2037 = phi_2141_;
                                                                            let _e2039 = phi_2142_;
                                                                            phi_2143_ = _e2037;
                                                                            phi_2144_ = _e2039;
                                                                        } else {
                                                                            phi_2143_ = f32();
                                                                            phi_2144_ = true;
                                                                        }
                                                                        let _e2041 = phi_2143_;
                                                                        let _e2043 = phi_2144_;
                                                                        phi_2145_ = _e2041;
                                                                        phi_2146_ = _e2043;
                                                                    } else {
                                                                        phi_2145_ = f32();
                                                                        phi_2146_ = true;
                                                                    }
                                                                    let _e2045 = phi_2145_;
                                                                    let _e2047 = phi_2146_;
                                                                    if _e2047 {
                                                                        if (_e1988 <= 0f) {
                                                                            if (_e2009 <= 0f) {
                                                                                let _e2050 = (_e2030 <= 0f);
                                                                                if _e2050 {
                                                                                }
                                                                                phi_2164_ = ((_e1988 + _e2009) + _e2030);
                                                                                phi_2165_ = false;
                                                                                phi_2166_ = _e2050;
                                                                            } else {
                                                                                phi_2164_ = f32();
                                                                                phi_2165_ = true;
                                                                                phi_2166_ = false;
                                                                            }
                                                                            let _e2054 = phi_2164_;
                                                                            let _e2056 = phi_2165_;
                                                                            let _e2058 = phi_2166_;
                                                                            phi_2167_ = _e2054;
                                                                            phi_2168_ = _e2056;
                                                                            phi_2169_ = _e2058;
                                                                        } else {
                                                                            phi_2167_ = f32();
                                                                            phi_2168_ = true;
                                                                            phi_2169_ = false;
                                                                        }
                                                                        let _e2060 = phi_2167_;
                                                                        let _e2062 = phi_2168_;
                                                                        let _e2064 = phi_2169_;
                                                                        if _e2062 {
                                                                            phi_2173_ = false;
                                                                        } else {
                                                                            phi_2173_ = _e2064;
                                                                        }
                                                                        let _e2066 = phi_2173_;
                                                                        phi_2174_ = _e2060;
                                                                        phi_2175_ = _e2066;
                                                                    } else {
                                                                        phi_2174_ = _e2045;
                                                                        phi_2175_ = true;
                                                                    }
                                                                    let _e2068 = phi_2174_;
                                                                    let _e2070 = phi_2175_;
                                                                    if _e2070 {
                                                                        let _e2071 = (_e2068 == 0f);
                                                                        if _e2071 {
                                                                            phi_2491_ = lt_bvh_triangle_Intersection();
                                                                            phi_2492_ = false;
                                                                        } else {
                                                                            let _e2073 = triangles.member[(0u + _e1884)].v0_;
                                                                            let _e2075 = (_e2073.x - _e990);
                                                                            let _e2077 = (_e2073.y - _e1003);
                                                                            let _e2079 = (_e2073.z - _e1016);
                                                                            if (_e1270 == 0u) {
                                                                                phi_2204_ = vec3<f32>(_e2077, _e2079, _e2075);
                                                                            } else {
                                                                                if (_e1270 == 1u) {
                                                                                    phi_2203_ = vec3<f32>(_e2079, _e2075, _e2077);
                                                                                } else {
                                                                                    phi_2203_ = (_e2073 - vec3<f32>(_e990, _e1003, _e1016));
                                                                                }
                                                                                let _e2087 = phi_2203_;
                                                                                phi_2204_ = _e2087;
                                                                            }
                                                                            let _e2089 = phi_2204_;
                                                                            let _e2091 = triangles.member[(0u + _e1884)].v1_;
                                                                            let _e2093 = triangles.member[(0u + _e1884)].v0_;
                                                                            let _e2096 = (_e2091.x - _e2093.x);
                                                                            let _e2099 = (_e2091.y - _e2093.y);
                                                                            let _e2102 = (_e2091.z - _e2093.z);
                                                                            if (_e1270 == 0u) {
                                                                                phi_2230_ = vec3<f32>(_e2099, _e2102, _e2096);
                                                                            } else {
                                                                                if (_e1270 == 1u) {
                                                                                    phi_2229_ = vec3<f32>(_e2102, _e2096, _e2099);
                                                                                } else {
                                                                                    phi_2229_ = (_e2091 - _e2093);
                                                                                }
                                                                                let _e2109 = phi_2229_;
                                                                                phi_2230_ = _e2109;
                                                                            }
                                                                            let _e2111 = phi_2230_;
                                                                            let _e2113 = triangles.member[(0u + _e1884)].v2_;
                                                                            let _e2115 = triangles.member[(0u + _e1884)].v0_;
                                                                            let _e2118 = (_e2113.x - _e2115.x);
                                                                            let _e2121 = (_e2113.y - _e2115.y);
                                                                            let _e2124 = (_e2113.z - _e2115.z);
                                                                            if (_e1270 == 0u) {
                                                                                phi_2256_ = vec3<f32>(_e2121, _e2124, _e2118);
                                                                            } else {
                                                                                if (_e1270 == 1u) {
                                                                                    phi_2255_ = vec3<f32>(_e2124, _e2118, _e2121);
                                                                                } else {
                                                                                    phi_2255_ = (_e2113 - _e2115);
                                                                                }
                                                                                let _e2131 = phi_2255_;
                                                                                phi_2256_ = _e2131;
                                                                            }
                                                                            let _e2133 = phi_2256_;
                                                                            let _e2140 = ((_e2111.y * _e2133.z) - (_e2111.z * _e2133.y));
                                                                            let _e2147 = ((_e2111.z * _e2133.x) - (_e2111.x * _e2133.z));
                                                                            let _e2154 = ((_e2111.x * _e2133.y) - (_e2111.y * _e2133.x));
                                                                            let _e2168 = (((1f / _e1278.z) * (((_e2140 * _e2089.x) + (_e2147 * _e2089.y)) + (_e2154 * _e2089.z))) / (((_e2140 * _e1281) + (_e2147 * _e1284)) + _e2154));
                                                                            if (_e2168 > 0f) {
                                                                                if (_e2168 < _e116) {
                                                                                    let _e2172 = triangles.member[(0u + _e1884)].v0_;
                                                                                    let _e2174 = triangles.member[(0u + _e1884)].v1_;
                                                                                    if (_e2172.x < _e2174.x) {
                                                                                        phi_2312_ = _e2172.x;
                                                                                    } else {
                                                                                        phi_2312_ = _e2174.x;
                                                                                    }
                                                                                    let _e2181 = phi_2312_;
                                                                                    if (_e2172.y < _e2174.y) {
                                                                                        phi_2321_ = _e2172.y;
                                                                                    } else {
                                                                                        phi_2321_ = _e2174.y;
                                                                                    }
                                                                                    let _e2188 = phi_2321_;
                                                                                    if (_e2172.z < _e2174.z) {
                                                                                        phi_2330_ = _e2172.z;
                                                                                    } else {
                                                                                        phi_2330_ = _e2174.z;
                                                                                    }
                                                                                    let _e2195 = phi_2330_;
                                                                                    let _e2197 = triangles.member[(0u + _e1884)].v2_;
                                                                                    if (_e2181 < _e2197.x) {
                                                                                        phi_2339_ = _e2181;
                                                                                    } else {
                                                                                        phi_2339_ = _e2197.x;
                                                                                    }
                                                                                    let _e2202 = phi_2339_;
                                                                                    if (_e2188 < _e2197.y) {
                                                                                        phi_2346_ = _e2188;
                                                                                    } else {
                                                                                        phi_2346_ = _e2197.y;
                                                                                    }
                                                                                    let _e2207 = phi_2346_;
                                                                                    if (_e2195 < _e2197.z) {
                                                                                        phi_2353_ = _e2195;
                                                                                    } else {
                                                                                        phi_2353_ = _e2197.z;
                                                                                    }
                                                                                    let _e2212 = phi_2353_;
                                                                                    let _e2214 = triangles.member[(0u + _e1884)].v0_;
                                                                                    let _e2216 = triangles.member[(0u + _e1884)].v1_;
                                                                                    if (_e2214.x > _e2216.x) {
                                                                                        phi_2366_ = _e2214.x;
                                                                                    } else {
                                                                                        phi_2366_ = _e2216.x;
                                                                                    }
                                                                                    let _e2223 = phi_2366_;
                                                                                    if (_e2214.y > _e2216.y) {
                                                                                        phi_2375_ = _e2214.y;
                                                                                    } else {
                                                                                        phi_2375_ = _e2216.y;
                                                                                    }
                                                                                    let _e2230 = phi_2375_;
                                                                                    if (_e2214.z > _e2216.z) {
                                                                                        phi_2384_ = _e2214.z;
                                                                                    } else {
                                                                                        phi_2384_ = _e2216.z;
                                                                                    }
                                                                                    let _e2237 = phi_2384_;
                                                                                    let _e2239 = triangles.member[(0u + _e1884)].v2_;
                                                                                    if (_e2223 > _e2239.x) {
                                                                                        phi_2393_ = _e2223;
                                                                                    } else {
                                                                                        phi_2393_ = _e2239.x;
                                                                                    }
                                                                                    let _e2244 = phi_2393_;
                                                                                    if (_e2230 > _e2239.y) {
                                                                                        phi_2400_ = _e2230;
                                                                                    } else {
                                                                                        phi_2400_ = _e2239.y;
                                                                                    }
                                                                                    let _e2249 = phi_2400_;
                                                                                    if (_e2237 > _e2239.z) {
                                                                                        phi_2407_ = _e2237;
                                                                                    } else {
                                                                                        phi_2407_ = _e2239.z;
                                                                                    }
                                                                                    let _e2254 = phi_2407_;
                                                                                    let _e2258 = ((_e2202 - _e990) * _e1199);
                                                                                    let _e2259 = ((_e2207 - _e1003) * _e1209);
                                                                                    let _e2260 = ((_e2212 - _e1016) * _e1219);
                                                                                    let _e2264 = ((_e2244 - _e990) * _e1199);
                                                                                    let _e2265 = ((_e2249 - _e1003) * _e1209);
                                                                                    let _e2266 = ((_e2254 - _e1016) * _e1219);
                                                                                    if (_e2258 < _e2264) {
                                                                                        phi_2424_ = _e2258;
                                                                                    } else {
                                                                                        phi_2424_ = _e2264;
                                                                                    }
                                                                                    let _e2269 = phi_2424_;
                                                                                    if (_e2259 < _e2265) {
                                                                                        phi_2429_ = _e2259;
                                                                                    } else {
                                                                                        phi_2429_ = _e2265;
                                                                                    }
                                                                                    let _e2272 = phi_2429_;
                                                                                    if (_e2260 < _e2266) {
                                                                                        phi_2434_ = _e2260;
                                                                                    } else {
                                                                                        phi_2434_ = _e2266;
                                                                                    }
                                                                                    let _e2275 = phi_2434_;
                                                                                    if (_e2258 > _e2264) {
                                                                                        phi_2442_ = _e2258;
                                                                                    } else {
                                                                                        phi_2442_ = _e2264;
                                                                                    }
                                                                                    let _e2281 = phi_2442_;
                                                                                    if (_e2259 > _e2265) {
                                                                                        phi_2447_ = _e2259;
                                                                                    } else {
                                                                                        phi_2447_ = _e2265;
                                                                                    }
                                                                                    let _e2284 = phi_2447_;
                                                                                    if (_e2260 > _e2266) {
                                                                                        phi_2452_ = _e2260;
                                                                                    } else {
                                                                                        phi_2452_ = _e2266;
                                                                                    }
                                                                                    let _e2287 = phi_2452_;
                                                                                    let _e2291 = core_intrinsics_maximum_number_nsz_f32_((_e2269 - _e1254), (_e2272 - _e1255));
                                                                                    let _e2292 = core_intrinsics_maximum_number_nsz_f32_(_e2291, (_e2275 - _e1256));
                                                                                    let _e2293 = core_intrinsics_minimum_number_nsz_f32_((_e2281 + _e1254), (_e2284 + _e1255));
                                                                                    let _e2294 = core_intrinsics_minimum_number_nsz_f32_(_e2293, (_e2287 + _e1256));
                                                                                    if (_e2292 > _e971) {
                                                                                        phi_2464_ = _e2292;
                                                                                    } else {
                                                                                        phi_2464_ = _e971;
                                                                                    }
                                                                                    let _e2297 = phi_2464_;
                                                                                    if (_e2294 < _e973) {
                                                                                        phi_2469_ = _e2294;
                                                                                    } else {
                                                                                        phi_2469_ = _e973;
                                                                                    }
                                                                                    let _e2300 = phi_2469_;
                                                                                    if (_e2168 < _e2297) {
                                                                                        phi_2474_ = _e2297;
                                                                                    } else {
                                                                                        phi_2474_ = _e2168;
                                                                                    }
                                                                                    let _e2303 = phi_2474_;
                                                                                    if (_e2303 > _e2300) {
                                                                                        phi_2479_ = _e2300;
                                                                                    } else {
                                                                                        phi_2479_ = _e2303;
                                                                                    }
                                                                                    let _e2306 = phi_2479_;
                                                                                    phi_2484_ = lt_bvh_triangle_Intersection(_e2306, (_e2009 / _e2068), (_e2030 / _e2068), (_e2297 <= _e2300));
                                                                                    phi_2485_ = false;
                                                                                } else {
                                                                                    phi_2484_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2485_ = true;
                                                                                }
                                                                                let _e2312 = phi_2484_;
                                                                                let _e2314 = phi_2485_;
                                                                                phi_2486_ = _e2312;
                                                                                phi_2487_ = _e2314;
                                                                            } else {
                                                                                phi_2486_ = lt_bvh_triangle_Intersection();
                                                                                phi_2487_ = true;
                                                                            }
                                                                            let _e2316 = phi_2486_;
                                                                            let _e2318 = phi_2487_;
                                                                            if _e2318 {
                                                                            }
                                                                            phi_2491_ = _e2316;
                                                                            phi_2492_ = _e2318;
                                                                        }
                                                                        let _e2320 = phi_2491_;
                                                                        let _e2322 = phi_2492_;
                                                                        phi_2493_ = _e2320;
                                                                        phi_2494_ = _e2071;
                                                                        phi_2495_ = _e2322;
                                                                    } else {
                                                                        phi_2493_ = lt_bvh_triangle_Intersection();
                                                                        phi_2494_ = true;
                                                                        phi_2495_ = false;
                                                                    }
                                                                    let _e2324 = phi_2493_;
                                                                    let _e2326 = phi_2494_;
                                                                    let _e2328 = phi_2495_;
                                                                    if _e2326 {
                                                                        phi_2499_ = true;
                                                                    } else {
                                                                        phi_2499_ = _e2328;
                                                                    }
                                                                    let _e2330 = phi_2499_;
                                                                    if _e2330 {
                                                                        phi_2503_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2503_ = _e2324;
                                                                    }
                                                                    let _e2332 = phi_2503_;
                                                                    if _e2332.is_hit {
                                                                        if (_e2332.t > 0f) {
                                                                            if (_e2332.t < _e116) {
                                                                                if true {
                                                                                    phi_2523_ = false;
                                                                                } else {
                                                                                    phi_2523_ = true;
                                                                                }
                                                                                let _e2341 = phi_2523_;
                                                                                phi_2524_ = true;
                                                                                phi_2525_ = _e2341;
                                                                            } else {
                                                                                phi_2524_ = _e1875;
                                                                                phi_2525_ = true;
                                                                            }
                                                                            let _e2343 = phi_2524_;
                                                                            let _e2345 = phi_2525_;
                                                                            phi_2526_ = _e2343;
                                                                            phi_2527_ = _e2345;
                                                                        } else {
                                                                            phi_2526_ = _e1875;
                                                                            phi_2527_ = true;
                                                                        }
                                                                        let _e2347 = phi_2526_;
                                                                        let _e2349 = phi_2527_;
                                                                        phi_2528_ = _e2347;
                                                                        phi_2529_ = _e2349;
                                                                    } else {
                                                                        phi_2528_ = _e1875;
                                                                        phi_2529_ = true;
                                                                    }
                                                                    let _e2351 = phi_2528_;
                                                                    let _e2353 = phi_2529_;
                                                                    if _e2353 {
                                                                    }
                                                                    phi_1933_ = (_e1873 & (_e1873 - 1u));
                                                                    phi_1936_ = _e2351;
                                                                    phi_2533_ = _e2353;
                                                                }
                                                                let _e2355 = phi_1933_;
                                                                let _e2357 = phi_1936_;
                                                                let _e2359 = phi_2533_;
                                                                continue;
                                                                continuing {
                                                                    phi_1932_ = _e2355;
                                                                    phi_1935_ = _e2357;
                                                                    break if !(_e2359);
                                                                }
                                                            }
                                                            let _e2362 = local_8;
                                                            if _e2362 {
                                                                let _e2364 = local.group_mask;
                                                                if ((_e2364 & 4278190080u) == 0u) {
                                                                    let _e2368 = local.len;
                                                                    if (_e2368 == 0u) {
                                                                        phi_2575_ = false;
                                                                    } else {
                                                                        let _e2372 = local.len;
                                                                        local.len = (_e2372 - 1u);
                                                                        let _e2375 = local.len;
                                                                        if (_e2375 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2380 = local.first[(0u + _e2375)];
                                                                        local.group = _e2380;
                                                                        let _e2383 = local.len;
                                                                        if (_e2383 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2388 = local.mask[(0u + _e2383)];
                                                                        local.group_mask = _e2388;
                                                                        phi_2575_ = true;
                                                                    }
                                                                    let _e2391 = phi_2575_;
                                                                    phi_2576_ = _e2391;
                                                                } else {
                                                                    phi_2576_ = true;
                                                                }
                                                                let _e2393 = phi_2576_;
                                                                if _e2393 {
                                                                    let _e2395 = local.group_mask;
                                                                    let _e2401 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2395)), 32u, (_e2395 == 0u)));
                                                                    let _e2405 = local.group_mask;
                                                                    let _e2419 = local.group_mask;
                                                                    local.group_mask = (_e2419 & ~((1u << bitcast<u32>((_e2401 & 31u)))));
                                                                    let _e2422 = local.group;
                                                                    phi_2607_ = (_e2422 + countOneBits(((_e2405 & ~((4294967295u << bitcast<u32>((((_e2401 - 24u) ^ _e1297) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_2607_ = 4294967295u;
                                                                }
                                                                let _e2425 = phi_2607_;
                                                                phi_2608_ = _e2425;
                                                            } else {
                                                                phi_2608_ = u32();
                                                            }
                                                            let _e2427 = phi_2608_;
                                                            phi_1601_ = _e2427;
                                                            let _e2807 = local_12;
                                                            phi_1604_ = _e2807;
                                                            let _e2810 = local_13;
                                                            phi_2609_ = _e2810;
                                                            phi_2610_ = false;
                                                        } else {
                                                            phi_1601_ = u32();
                                                            phi_1604_ = bool();
                                                            phi_2609_ = false;
                                                            phi_2610_ = true;
                                                        }
                                                        let _e2429 = phi_1601_;
                                                        let _e2431 = phi_1604_;
                                                        let _e2433 = phi_2609_;
                                                        let _e2435 = phi_2610_;
                                                        local_9 = _e2435;
                                                        continue;
                                                        continuing {
                                                            phi_1600_ = _e2429;
                                                            phi_1603_ = _e2431;
                                                            break if !(_e2433);
                                                        }
                                                    }
                                                    let _e2438 = local_9;
                                                    if _e2438 {
                                                        phi_2614_ = false;
                                                    } else {
                                                        phi_2614_ = true;
                                                    }
                                                    let _e2440 = phi_2614_;
                                                    if _e2440 {
                                                        phi_2618_ = true;
                                                    } else {
                                                        let _e2816 = local_14;
                                                        phi_2618_ = _e2816;
                                                    }
                                                    let _e2442 = phi_2618_;
                                                    phi_2619_ = _e2442;
                                                }
                                                let _e2444 = phi_2619_;
                                                phi_2620_ = _e2444;
                                                phi_2621_ = _e1123;
                                            } else {
                                                phi_2620_ = bool();
                                                phi_2621_ = true;
                                            }
                                            let _e2446 = phi_2620_;
                                            let _e2448 = phi_2621_;
                                            if _e2448 {
                                                phi_2625_ = _e910;
                                            } else {
                                                phi_2625_ = _e2446;
                                            }
                                            let _e2450 = phi_2625_;
                                            if _e2450 {
                                                phi_2629_ = false;
                                            } else {
                                                phi_2629_ = true;
                                            }
                                            let _e2452 = phi_2629_;
                                            phi_2630_ = _e2450;
                                            phi_2631_ = _e2452;
                                        } else {
                                            phi_2630_ = _e910;
                                            phi_2631_ = true;
                                        }
                                        let _e2454 = phi_2630_;
                                        let _e2456 = phi_2631_;
                                        phi_2632_ = _e2454;
                                        phi_2633_ = _e2456;
                                    } else {
                                        phi_2632_ = _e910;
                                        phi_2633_ = true;
                                    }
                                    let _e2458 = phi_2632_;
                                    let _e2460 = phi_2633_;
                                    phi_2634_ = _e2458;
                                    phi_2635_ = _e2460;
                                } else {
                                    phi_2634_ = _e910;
                                    phi_2635_ = true;
                                }
                                let _e2462 = phi_2634_;
                                let _e2464 = phi_2635_;
                                if _e2464 {
                                }
                                phi_993_ = (_e908 & (_e908 - 1u));
                                phi_996_ = _e2462;
                                phi_2639_ = _e2464;
                            }
                            let _e2466 = phi_993_;
                            let _e2468 = phi_996_;
                            let _e2470 = phi_2639_;
                            continue;
                            continuing {
                                phi_992_ = _e2466;
                                phi_995_ = _e2468;
                                break if !(_e2470);
                            }
                        }
                        let _e2473 = local_10;
                        if _e2473 {
                            let _e2475 = local_1.group_mask;
                            if ((_e2475 & 4278190080u) == 0u) {
                                let _e2479 = local_1.len;
                                if (_e2479 == 0u) {
                                    phi_2681_ = false;
                                } else {
                                    let _e2483 = local_1.len;
                                    local_1.len = (_e2483 - 1u);
                                    let _e2486 = local_1.len;
                                    if (_e2486 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2491 = local_1.first[(0u + _e2486)];
                                    local_1.group = _e2491;
                                    let _e2494 = local_1.len;
                                    if (_e2494 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2499 = local_1.mask[(0u + _e2494)];
                                    local_1.group_mask = _e2499;
                                    phi_2681_ = true;
                                }
                                let _e2502 = phi_2681_;
                                phi_2682_ = _e2502;
                            } else {
                                phi_2682_ = true;
                            }
                            let _e2504 = phi_2682_;
                            if _e2504 {
                                let _e2506 = local_1.group_mask;
                                let _e2512 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2506)), 32u, (_e2506 == 0u)));
                                let _e2516 = local_1.group_mask;
                                let _e2530 = local_1.group_mask;
                                local_1.group_mask = (_e2530 & ~((1u << bitcast<u32>((_e2512 & 31u)))));
                                let _e2533 = local_1.group;
                                phi_2713_ = (_e2533 + countOneBits(((_e2516 & ~((4294967295u << bitcast<u32>((((_e2512 - 24u) ^ _e332) & 31u))))) & 255u)));
                            } else {
                                phi_2713_ = 4294967295u;
                            }
                            let _e2536 = phi_2713_;
                            phi_2714_ = _e2536;
                        } else {
                            phi_2714_ = u32();
                        }
                        let _e2538 = phi_2714_;
                        phi_661_ = _e2538;
                        let _e2839 = local_15;
                        phi_664_ = _e2839;
                        let _e2842 = local_16;
                        phi_2715_ = _e2842;
                        phi_2716_ = false;
                    } else {
                        phi_661_ = u32();
                        phi_664_ = bool();
                        phi_2715_ = false;
                        phi_2716_ = true;
                    }
                    let _e2540 = phi_661_;
                    let _e2542 = phi_664_;
                    let _e2544 = phi_2715_;
                    let _e2546 = phi_2716_;
                    local_11 = _e2546;
                    continue;
                    continuing {
                        phi_660_ = _e2540;
                        phi_663_ = _e2542;
                        break if !(_e2544);
                    }
                }
                let _e2549 = local_11;
                if _e2549 {
                    phi_2720_ = false;
                } else {
                    phi_2720_ = true;
                }
                let _e2551 = phi_2720_;
                if _e2551 {
                }
                phi_2724_ = _e2551;
            }
            let _e2553 = phi_2724_;
            phi_2725_ = _e188;
            phi_2726_ = _e2553;
        } else {
            phi_2725_ = true;
            phi_2726_ = false;
        }
        let _e2555 = phi_2725_;
        let _e2557 = phi_2726_;
        if _e2555 {
            phi_2730_ = false;
            phi_2731_ = true;
        } else {
            phi_2730_ = true;
            phi_2731_ = _e2557;
        }
        let _e2559 = phi_2730_;
        let _e2561 = phi_2731_;
        if _e2561 {
            phi_2735_ = _e2559;
        } else {
            phi_2735_ = false;
        }
        let _e2563 = phi_2735_;
        if _e2563 {
            phi_2739_ = 0f;
        } else {
            phi_2739_ = 1f;
        }
        let _e2565 = phi_2739_;
        if (_e85 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e85)] = _e2565;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
