struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    pad0_: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    pad3_: vec2<u32>,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct type_22 {
    member: array<vec4<f32>>,
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

struct type_30 {
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

struct type_34 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_38 {
    member: array<abi_Vertex>,
}

struct abi_Material {
    base_color: vec4<f32>,
    cutoff: f32,
    flags: u32,
    alpha_offset: u32,
    alpha_size: u32,
    color_offset: u32,
    color_size: u32,
    transmission: f32,
    pad: u32,
}

struct type_42 {
    member: array<abi_Material>,
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

struct type_55 {
    member: array<lt_bvh_Instance>,
}

struct type_59 {
    member: abi_CameraParams,
}

struct lt_bvh_Ray {
    origin: vec3<f32>,
    tmin: f32,
    direction: vec3<f32>,
    tmax: f32,
}

struct lt_bvh_Hit {
    t: f32,
    u: f32,
    v: f32,
    triangle: u32,
    instance: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(3) 
var<storage> vertices: type_38;
@group(0) @binding(4) 
var<storage> materials: type_42;
@group(0) @binding(0) 
var<uniform> p: type_59;
@group(0) @binding(1) 
var<storage> nodes: type_30;
@group(0) @binding(2) 
var<storage> triangles: type_34;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_55;
@group(0) @binding(7) 
var<storage> before: type_22;
@group(0) @binding(8) 
var<storage, read_write> past: type_22;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_203_: lt_mask_LightPlace;
    var phi_204_: bool;
    var phi_205_: lt_mask_LightPlace;
    var phi_206_: bool;
    var phi_211_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_203_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_204_ = false;
        } else {
            phi_203_ = lt_mask_LightPlace();
            phi_204_ = true;
        }
        let _e76 = phi_203_;
        let _e78 = phi_204_;
        phi_205_ = _e76;
        phi_206_ = _e78;
    } else {
        phi_205_ = lt_mask_LightPlace();
        phi_206_ = true;
    }
    let _e80 = phi_205_;
    let _e82 = phi_206_;
    if _e82 {
        phi_211_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_211_ = _e80;
    }
    let _e87 = phi_211_;
    return lt_mask_LightPlace(_e87.word, _e87.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_226_: bool;
    var phi_230_: f32;

    if (param_3 != param_3) {
        phi_226_ = true;
    } else {
        let _e66 = (param_4 >= param_3);
        if _e66 {
        }
        phi_226_ = _e66;
    }
    let _e68 = phi_226_;
    if _e68 {
        phi_230_ = param_4;
    } else {
        phi_230_ = param_3;
    }
    let _e70 = phi_230_;
    return _e70;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_242_: bool;
    var phi_246_: f32;

    if (param_5 != param_5) {
        phi_242_ = true;
    } else {
        let _e66 = (param_6 <= param_5);
        if _e66 {
        }
        phi_242_ = _e66;
    }
    let _e68 = phi_242_;
    if _e68 {
        phi_246_ = param_6;
    } else {
        phi_246_ = param_5;
    }
    let _e70 = phi_246_;
    return _e70;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_258_: f32;

    if (param_9 > param_10) {
        phi_258_ = param_9;
    } else {
        phi_258_ = param_10;
    }
    let _e67 = phi_258_;
    return _e67;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_386_: bool;
    var phi_387_: bool;
    var phi_388_: bool;
    var phi_389_: bool;
    var phi_393_: bool;
    var phi_406_: bool;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_413_: bool;
    var phi_426_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_432_: bool;
    var phi_433_: bool;
    var phi_434_: bool;
    var phi_435_: bool;
    var phi_436_: bool;
    var phi_440_: bool;
    var phi_516_: f32;
    var phi_523_: f32;
    var phi_531_: f32;
    var phi_538_: f32;
    var phi_546_: f32;
    var phi_553_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_586_: f32;
    var phi_591_: f32;
    var phi_596_: f32;
    var phi_615_: u32;
    var phi_620_: u32;
    var phi_625_: u32;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_771_: u32;
    var phi_773_: u32;
    var phi_776_: lt_bvh_Hit;
    var phi_861_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_888_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_915_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_921_: u32;
    var phi_924_: u32;
    var phi_938_: u32;
    var phi_948_: u32;
    var phi_958_: u32;
    var phi_976_: u32;
    var phi_986_: u32;
    var phi_996_: u32;
    var phi_1032_: u32;
    var phi_1045_: u32;
    var phi_1050_: u32;
    var phi_1051_: u32;
    var phi_1052_: u32;
    var phi_922_: u32;
    var phi_925_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1110_: u32;
    var phi_1113_: lt_bvh_Hit;
    var phi_1168_: f32;
    var phi_1173_: f32;
    var phi_1178_: f32;
    var phi_1186_: f32;
    var phi_1191_: f32;
    var phi_1196_: f32;
    var phi_1328_: bool;
    var phi_1329_: bool;
    var phi_1330_: bool;
    var phi_1331_: bool;
    var phi_1335_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1355_: bool;
    var phi_1368_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1374_: bool;
    var phi_1375_: bool;
    var phi_1376_: bool;
    var phi_1377_: bool;
    var phi_1378_: bool;
    var phi_1382_: bool;
    var phi_1452_: f32;
    var phi_1459_: f32;
    var phi_1466_: f32;
    var phi_1473_: f32;
    var phi_1480_: f32;
    var phi_1487_: f32;
    var phi_1504_: f32;
    var phi_1509_: f32;
    var phi_1514_: f32;
    var phi_1519_: f32;
    var phi_1524_: f32;
    var phi_1550_: bool;
    var phi_1551_: bool;
    var phi_1559_: u32;
    var phi_1560_: u32;
    var phi_1571_: vec3<f32>;
    var phi_1572_: vec3<f32>;
    var phi_1585_: u32;
    var phi_1590_: u32;
    var phi_1595_: u32;
    var phi_1709_: bool;
    var phi_1710_: bool;
    var phi_1741_: u32;
    var phi_1743_: lt_bvh_Hit;
    var phi_1746_: u32;
    var phi_1827_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1854_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1881_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1887_: u32;
    var phi_1890_: u32;
    var phi_1904_: u32;
    var phi_1914_: u32;
    var phi_1924_: u32;
    var phi_1942_: u32;
    var phi_1952_: u32;
    var phi_1962_: u32;
    var phi_1998_: u32;
    var phi_2011_: u32;
    var phi_2016_: u32;
    var phi_2017_: u32;
    var phi_2018_: u32;
    var phi_1888_: u32;
    var phi_1891_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2076_: lt_bvh_Hit;
    var phi_2079_: u32;
    var phi_2123_: vec3<f32>;
    var phi_2124_: vec3<f32>;
    var phi_2153_: vec3<f32>;
    var phi_2154_: vec3<f32>;
    var phi_2183_: vec3<f32>;
    var phi_2184_: vec3<f32>;
    var phi_2202_: bool;
    var phi_2203_: bool;
    var phi_2207_: f32;
    var phi_2208_: f32;
    var phi_2209_: f32;
    var phi_2210_: f32;
    var phi_2218_: f32;
    var phi_2228_: bool;
    var phi_2229_: bool;
    var phi_2233_: f32;
    var phi_2234_: f32;
    var phi_2235_: f32;
    var phi_2236_: f32;
    var phi_2244_: f32;
    var phi_2254_: bool;
    var phi_2255_: bool;
    var phi_2259_: f32;
    var phi_2260_: f32;
    var phi_2261_: f32;
    var phi_2262_: f32;
    var phi_2270_: f32;
    var phi_2285_: f32;
    var phi_2286_: bool;
    var phi_2287_: f32;
    var phi_2288_: bool;
    var phi_2289_: f32;
    var phi_2290_: bool;
    var phi_2308_: f32;
    var phi_2309_: bool;
    var phi_2310_: bool;
    var phi_2311_: f32;
    var phi_2312_: bool;
    var phi_2313_: bool;
    var phi_2317_: bool;
    var phi_2318_: f32;
    var phi_2319_: bool;
    var phi_2347_: vec3<f32>;
    var phi_2348_: vec3<f32>;
    var phi_2373_: vec3<f32>;
    var phi_2374_: vec3<f32>;
    var phi_2399_: vec3<f32>;
    var phi_2400_: vec3<f32>;
    var phi_2456_: f32;
    var phi_2465_: f32;
    var phi_2474_: f32;
    var phi_2483_: f32;
    var phi_2490_: f32;
    var phi_2497_: f32;
    var phi_2510_: f32;
    var phi_2519_: f32;
    var phi_2528_: f32;
    var phi_2537_: f32;
    var phi_2544_: f32;
    var phi_2551_: f32;
    var phi_2568_: f32;
    var phi_2573_: f32;
    var phi_2578_: f32;
    var phi_2586_: f32;
    var phi_2591_: f32;
    var phi_2596_: f32;
    var phi_2608_: f32;
    var phi_2613_: f32;
    var phi_2618_: f32;
    var phi_2623_: f32;
    var phi_2628_: lt_bvh_triangle_Intersection;
    var phi_2629_: bool;
    var phi_2630_: lt_bvh_triangle_Intersection;
    var phi_2631_: bool;
    var phi_2635_: lt_bvh_triangle_Intersection;
    var phi_2636_: bool;
    var phi_2637_: lt_bvh_triangle_Intersection;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2643_: bool;
    var phi_2647_: lt_bvh_triangle_Intersection;
    var phi_2685_: bool;
    var phi_2686_: bool;
    var phi_2687_: bool;
    var phi_2688_: bool;
    var phi_2689_: bool;
    var phi_2690_: bool;
    var phi_2694_: bool;
    var phi_2695_: bool;
    var phi_2709_: bool;
    var phi_2717_: lt_bvh_Hit;
    var phi_2718_: lt_bvh_Hit;
    var phi_2719_: lt_bvh_Hit;
    var phi_2720_: lt_bvh_Hit;
    var phi_2077_: lt_bvh_Hit;
    var phi_2080_: u32;
    var phi_2721_: bool;
    var phi_2760_: bool;
    var phi_2761_: bool;
    var phi_2792_: u32;
    var phi_1744_: lt_bvh_Hit;
    var phi_1747_: u32;
    var phi_2793_: lt_bvh_Hit;
    var phi_2794_: lt_bvh_Hit;
    var phi_2795_: bool;
    var phi_2799_: lt_bvh_Hit;
    var phi_2800_: lt_bvh_Hit;
    var phi_2801_: lt_bvh_Hit;
    var phi_2802_: lt_bvh_Hit;
    var phi_1111_: u32;
    var phi_1114_: lt_bvh_Hit;
    var phi_2803_: bool;
    var phi_2842_: bool;
    var phi_2843_: bool;
    var phi_2874_: u32;
    var phi_774_: u32;
    var phi_777_: lt_bvh_Hit;
    var phi_2875_: lt_bvh_Hit;
    var phi_2876_: lt_bvh_Hit;
    var phi_2877_: bool;
    var phi_2881_: lt_bvh_Hit;
    var phi_3069_: f32;
    var phi_3074_: f32;
    var phi_3079_: f32;
    var phi_3087_: f32;
    var phi_3092_: f32;
    var phi_3097_: f32;
    var phi_3161_: vec3<f32>;
    var phi_3282_: u32;
    var phi_3309_: f32;
    var phi_3316_: f32;
    var phi_3323_: f32;
    var phi_3358_: f32;
    var phi_3365_: f32;
    var phi_3372_: f32;
    var phi_3410_: f32;
    var phi_3417_: f32;
    var phi_3424_: f32;
    var phi_3510_: vec3<f32>;
    var phi_3511_: vec3<f32>;
    var phi_3512_: vec3<f32>;
    var phi_3521_: f32;
    var phi_3522_: f32;
    var phi_3532_: f32;
    var phi_3533_: f32;
    var phi_3543_: f32;
    var phi_3544_: f32;
    var phi_3579_: abi_Sample;
    var phi_3802_: vec3<f32>;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;

    let _e65 = id_1;
    let _e69 = arrayLength((&nodes.member));
    let _e72 = arrayLength((&triangles.member));
    let _e75 = arrayLength((&vertices.member));
    let _e84 = arrayLength((&instances.member));
    let _e87 = arrayLength((&before.member));
    let _e93 = p.member.size[0u];
    let _e95 = p.member.size[1u];
    let _e96 = lt_shaders_entry_pixel_index(_e65, _e93, _e95);
    if (bitcast<i32>(_e96.word) != 0i) {
        let _e102 = p.member.root;
        let _e106 = p.member.eye;
        let _e111 = p.member.size[0u];
        let _e115 = ((((f32(_e65.x) + 0.5f) / f32(_e111)) * 2f) - 1f);
        let _e120 = p.member.size[1u];
        let _e124 = (1f - (((f32(_e65.y) + 0.5f) / f32(_e120)) * 2f));
        let _e126 = p.member.forward;
        let _e128 = p.member.right;
        let _e142 = p.member.up;
        let _e153 = _lt_bvh_ray_Ray_new(_e106, vec3<f32>(((_e126.x + (_e128.x * _e115)) + (_e142.x * _e124)), ((_e126.y + (_e128.y * _e115)) + (_e142.y * _e124)), ((_e126.z + (_e128.z * _e115)) + (_e142.z * _e124))));
        let _e155 = lt_bvh_Hit(_e153.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e158 = abs(_e153.direction.x);
        let _e160 = abs(_e153.direction.y);
        let _e162 = abs(_e153.direction.z);
        if (abs(_e153.origin.x) < 1000000000000000f) {
            if (abs(_e153.origin.y) < 1000000000000000f) {
                phi_386_ = (abs(_e153.origin.z) < 1000000000000000f);
                phi_387_ = false;
            } else {
                phi_386_ = bool();
                phi_387_ = true;
            }
            let _e174 = phi_386_;
            let _e176 = phi_387_;
            phi_388_ = _e174;
            phi_389_ = _e176;
        } else {
            phi_388_ = bool();
            phi_389_ = true;
        }
        let _e178 = phi_388_;
        let _e180 = phi_389_;
        if _e180 {
            phi_393_ = false;
        } else {
            phi_393_ = _e178;
        }
        let _e182 = phi_393_;
        if _e182 {
            if (_e158 < 1000000000000000f) {
                if (_e160 < 1000000000000000f) {
                    phi_406_ = (_e162 < 1000000000000000f);
                    phi_407_ = false;
                } else {
                    phi_406_ = bool();
                    phi_407_ = true;
                }
                let _e187 = phi_406_;
                let _e189 = phi_407_;
                phi_408_ = _e187;
                phi_409_ = _e189;
            } else {
                phi_408_ = bool();
                phi_409_ = true;
            }
            let _e191 = phi_408_;
            let _e193 = phi_409_;
            if _e193 {
                phi_413_ = false;
            } else {
                phi_413_ = _e191;
            }
            let _e195 = phi_413_;
            if _e195 {
                if (_e158 > 0f) {
                    phi_427_ = bool();
                    phi_428_ = true;
                } else {
                    let _e197 = (_e160 > 0f);
                    if _e197 {
                        phi_426_ = bool();
                    } else {
                        phi_426_ = (_e162 > 0f);
                    }
                    let _e200 = phi_426_;
                    phi_427_ = _e200;
                    phi_428_ = _e197;
                }
                let _e202 = phi_427_;
                let _e204 = phi_428_;
                if _e204 {
                    phi_432_ = true;
                } else {
                    phi_432_ = _e202;
                }
                let _e206 = phi_432_;
                phi_433_ = _e206;
                phi_434_ = false;
            } else {
                phi_433_ = bool();
                phi_434_ = true;
            }
            let _e208 = phi_433_;
            let _e210 = phi_434_;
            phi_435_ = _e208;
            phi_436_ = _e210;
        } else {
            phi_435_ = bool();
            phi_436_ = true;
        }
        let _e212 = phi_435_;
        let _e214 = phi_436_;
        if _e214 {
            phi_440_ = false;
        } else {
            phi_440_ = _e212;
        }
        let _e216 = phi_440_;
        if _e216 {
            let _e217 = (_e102 >= _e69);
            if _e217 {
                phi_2875_ = lt_bvh_Hit();
            } else {
                if (_e102 < _e69) {
                } else {
                    return;
                }
                let _e223 = nodes.member[(0u + _e102)].frame[0u];
                let _e227 = nodes.member[(0u + _e102)].frame[1u];
                let _e231 = nodes.member[(0u + _e102)].frame[2u];
                let _e235 = nodes.member[(0u + _e102)].frame[0u];
                let _e239 = nodes.member[(0u + _e102)].frame[1u];
                let _e243 = nodes.member[(0u + _e102)].frame[2u];
                let _e247 = nodes.member[(0u + _e102)].frame[3u];
                let _e286 = core_intrinsics_maximum_number_nsz_f32_(abs(_e153.direction.x), abs(_e153.direction.y));
                let _e287 = core_intrinsics_maximum_number_nsz_f32_(_e286, abs(_e153.direction.z));
                let _e288 = (_e287 * 0.0000000000009094947f);
                if (abs(_e153.direction.x) < _e288) {
                    phi_516_ = _e288;
                } else {
                    phi_516_ = abs(_e153.direction.x);
                }
                let _e294 = phi_516_;
                if (_e153.direction.x < 0f) {
                    phi_523_ = (-1f / _e294);
                } else {
                    phi_523_ = (1f / _e294);
                }
                let _e299 = phi_523_;
                if (abs(_e153.direction.y) < _e288) {
                    phi_531_ = _e288;
                } else {
                    phi_531_ = abs(_e153.direction.y);
                }
                let _e305 = phi_531_;
                if (_e153.direction.y < 0f) {
                    phi_538_ = (-1f / _e305);
                } else {
                    phi_538_ = (1f / _e305);
                }
                let _e310 = phi_538_;
                if (abs(_e153.direction.z) < _e288) {
                    phi_546_ = _e288;
                } else {
                    phi_546_ = abs(_e153.direction.z);
                }
                let _e316 = phi_546_;
                if (_e153.direction.z < 0f) {
                    phi_553_ = (-1f / _e316);
                } else {
                    phi_553_ = (1f / _e316);
                }
                let _e321 = phi_553_;
                let _e328 = abs((bitcast<f32>(_e223) - _e153.origin.x));
                let _e329 = abs((bitcast<f32>(_e227) - _e153.origin.y));
                let _e330 = abs((bitcast<f32>(_e231) - _e153.origin.z));
                let _e337 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e247 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.x));
                let _e338 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e247 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.y));
                let _e339 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e247 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153.origin.z));
                if (_e328 > _e337) {
                    phi_576_ = _e328;
                } else {
                    phi_576_ = _e337;
                }
                let _e342 = phi_576_;
                if (_e329 > _e338) {
                    phi_581_ = _e329;
                } else {
                    phi_581_ = _e338;
                }
                let _e345 = phi_581_;
                if (_e330 > _e339) {
                    phi_586_ = _e330;
                } else {
                    phi_586_ = _e339;
                }
                let _e348 = phi_586_;
                if (_e342 > _e345) {
                    phi_591_ = _e342;
                } else {
                    phi_591_ = _e345;
                }
                let _e351 = phi_591_;
                if (_e351 > _e348) {
                    phi_596_ = _e351;
                } else {
                    phi_596_ = _e348;
                }
                let _e354 = phi_596_;
                let _e358 = (_e354 * 0.0000019073486f);
                let _e359 = (abs(_e299) * _e358);
                let _e360 = (abs(_e310) * _e358);
                let _e361 = (abs(_e321) * _e358);
                let _e365 = (_e354 * 0.0000009536743f);
                let _e366 = (abs(_e299) * _e365);
                let _e367 = (abs(_e310) * _e365);
                let _e368 = (abs(_e321) * _e365);
                if (_e299 < 0f) {
                    phi_615_ = 0u;
                } else {
                    phi_615_ = 1u;
                }
                let _e371 = phi_615_;
                if (_e310 < 0f) {
                    phi_620_ = 0u;
                } else {
                    phi_620_ = 2u;
                }
                let _e374 = phi_620_;
                if (_e321 < 0f) {
                    phi_625_ = 0u;
                } else {
                    phi_625_ = 4u;
                }
                let _e377 = phi_625_;
                let _e379 = ((_e371 | _e374) | _e377);
                let _e380 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e102, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e380.first[0], _e380.first[1], _e380.first[2], _e380.first[3], _e380.first[4], _e380.first[5], _e380.first[6], _e380.first[7], _e380.first[8], _e380.first[9], _e380.first[10], _e380.first[11], _e380.first[12], _e380.first[13], _e380.first[14], _e380.first[15], _e380.first[16], _e380.first[17], _e380.first[18], _e380.first[19], _e380.first[20], _e380.first[21], _e380.first[22], _e380.first[23], _e380.first[24], _e380.first[25], _e380.first[26], _e380.first[27], _e380.first[28], _e380.first[29], _e380.first[30], _e380.first[31]), array<u32, 32>(_e380.mask[0], _e380.mask[1], _e380.mask[2], _e380.mask[3], _e380.mask[4], _e380.mask[5], _e380.mask[6], _e380.mask[7], _e380.mask[8], _e380.mask[9], _e380.mask[10], _e380.mask[11], _e380.mask[12], _e380.mask[13], _e380.mask[14], _e380.mask[15], _e380.mask[16], _e380.mask[17], _e380.mask[18], _e380.mask[19], _e380.mask[20], _e380.mask[21], _e380.mask[22], _e380.mask[23], _e380.mask[24], _e380.mask[25], _e380.mask[26], _e380.mask[27], _e380.mask[28], _e380.mask[29], _e380.mask[30], _e380.mask[31]), _e380.len, _e380.group, _e380.group_mask);
                let _e454 = local_1.group_mask;
                if ((_e454 & 4278190080u) == 0u) {
                    let _e458 = local_1.len;
                    if (_e458 == 0u) {
                        phi_739_ = false;
                    } else {
                        let _e462 = local_1.len;
                        local_1.len = (_e462 - 1u);
                        let _e465 = local_1.len;
                        if (_e465 < 32u) {
                        } else {
                            return;
                        }
                        let _e470 = local_1.first[(0u + _e465)];
                        local_1.group = _e470;
                        let _e473 = local_1.len;
                        if (_e473 < 32u) {
                        } else {
                            return;
                        }
                        let _e478 = local_1.mask[(0u + _e473)];
                        local_1.group_mask = _e478;
                        phi_739_ = true;
                    }
                    let _e481 = phi_739_;
                    phi_740_ = _e481;
                } else {
                    phi_740_ = true;
                }
                let _e483 = phi_740_;
                if _e483 {
                    let _e485 = local_1.group_mask;
                    let _e491 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e485)), 32u, (_e485 == 0u)));
                    let _e495 = local_1.group_mask;
                    let _e509 = local_1.group_mask;
                    local_1.group_mask = (_e509 & ~((1u << bitcast<u32>((_e491 & 31u)))));
                    let _e512 = local_1.group;
                    phi_771_ = (_e512 + countOneBits(((_e495 & ~((4294967295u << bitcast<u32>((((_e491 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_771_ = 4294967295u;
                }
                let _e515 = phi_771_;
                phi_773_ = _e515;
                phi_776_ = _e155;
                loop {
                    let _e517 = phi_773_;
                    let _e519 = phi_776_;
                    local_11 = _e519;
                    let _e520 = (_e517 != 4294967295u);
                    if _e520 {
                        if (_e517 < _e69) {
                        } else {
                            return;
                        }
                        let _e528 = nodes.member[(0u + _e517)].frame[3u];
                        let _e553 = (bitcast<f32>((((_e528 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e554 = (bitcast<f32>((((_e528 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e555 = (bitcast<f32>((((_e528 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e321);
                        let _e558 = nodes.member[(0u + _e517)].frame[0u];
                        let _e562 = nodes.member[(0u + _e517)].frame[1u];
                        let _e566 = nodes.member[(0u + _e517)].frame[2u];
                        let _e574 = ((bitcast<f32>(_e558) - _e153.origin.x) * _e299);
                        let _e575 = ((bitcast<f32>(_e562) - _e153.origin.y) * _e310);
                        let _e576 = ((bitcast<f32>(_e566) - _e153.origin.z) * _e321);
                        let _e584 = nodes.member[(0u + _e517)].x;
                        if (_e299 < 0f) {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e584.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e595.unnamed.word, _e584.w), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_mask_LightPlace(_e584.x, _e601.unnamed_1.shift));
                            phi_861_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_mask_LightPlace(_e607.unnamed_1.word, _e584.y));
                        } else {
                            let _e623 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e584.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e629 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e623.unnamed.word, _e584.y), _e623.unnamed_1);
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e629.unnamed, lt_mask_LightPlace(_e584.z, _e629.unnamed_1.shift));
                            phi_861_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e635.unnamed, lt_mask_LightPlace(_e635.unnamed_1.word, _e584.w));
                        }
                        let _e643 = phi_861_;
                        let _e653 = nodes.member[(0u + _e517)].y;
                        if (_e310 < 0f) {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e664.unnamed.word, _e653.w), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_mask_LightPlace(_e653.x, _e670.unnamed_1.shift));
                            phi_888_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_mask_LightPlace(_e676.unnamed_1.word, _e653.y));
                        } else {
                            let _e692 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e653.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e698 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e692.unnamed.word, _e653.y), _e692.unnamed_1);
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e698.unnamed, lt_mask_LightPlace(_e653.z, _e698.unnamed_1.shift));
                            phi_888_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e704.unnamed, lt_mask_LightPlace(_e704.unnamed_1.word, _e653.w));
                        }
                        let _e712 = phi_888_;
                        let _e722 = nodes.member[(0u + _e517)].z;
                        if (_e321 < 0f) {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e733.unnamed.word, _e722.w), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_mask_LightPlace(_e722.x, _e739.unnamed_1.shift));
                            phi_915_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_mask_LightPlace(_e745.unnamed_1.word, _e722.y));
                        } else {
                            let _e761 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e722.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e767 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e761.unnamed.word, _e722.y), _e761.unnamed_1);
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e767.unnamed, lt_mask_LightPlace(_e722.z, _e767.unnamed_1.shift));
                            phi_915_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e773.unnamed, lt_mask_LightPlace(_e773.unnamed_1.word, _e722.w));
                        }
                        let _e781 = phi_915_;
                        phi_921_ = 0u;
                        phi_924_ = 0u;
                        loop {
                            let _e791 = phi_921_;
                            let _e793 = phi_924_;
                            local_2 = _e793;
                            local_3 = _e793;
                            local_4 = _e793;
                            let _e794 = (_e791 < 8u);
                            if _e794 {
                                let _e796 = (_e791 >> bitcast<u32>(2i));
                                let _e797 = (_e791 & 3u);
                                if (_e796 == 0u) {
                                    phi_938_ = _e643.unnamed.word;
                                } else {
                                    phi_938_ = _e643.unnamed.shift;
                                }
                                let _e800 = phi_938_;
                                if (_e796 == 0u) {
                                    phi_948_ = _e712.unnamed.word;
                                } else {
                                    phi_948_ = _e712.unnamed.shift;
                                }
                                let _e809 = phi_948_;
                                if (_e796 == 0u) {
                                    phi_958_ = _e781.unnamed.word;
                                } else {
                                    phi_958_ = _e781.unnamed.shift;
                                }
                                let _e818 = phi_958_;
                                let _e831 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e800 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e553) + (_e574 - _e359)), ((f32(((_e809 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e554) + (_e575 - _e360)));
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(_e831, ((f32(((_e818 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e555) + (_e576 - _e361)));
                                if (_e796 == 0u) {
                                    phi_976_ = _e643.unnamed_1.word;
                                } else {
                                    phi_976_ = _e643.unnamed_1.shift;
                                }
                                let _e835 = phi_976_;
                                if (_e796 == 0u) {
                                    phi_986_ = _e712.unnamed_1.word;
                                } else {
                                    phi_986_ = _e712.unnamed_1.shift;
                                }
                                let _e844 = phi_986_;
                                if (_e796 == 0u) {
                                    phi_996_ = _e781.unnamed_1.word;
                                } else {
                                    phi_996_ = _e781.unnamed_1.shift;
                                }
                                let _e853 = phi_996_;
                                let _e866 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e835 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e553) + (_e574 + _e359)), ((f32(((_e844 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e554) + (_e575 + _e360)));
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(_e866, ((f32(((_e853 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u)) * _e555) + (_e576 + _e361)));
                                if (_e832 <= _e867) {
                                    if (_e832 <= _e519.t) {
                                        if (_e867 >= _e153.tmin) {
                                            if (_e796 == 0u) {
                                                let _e874 = nodes.member[(0u + _e517)].links[2u];
                                                phi_1032_ = _e874;
                                            } else {
                                                let _e877 = nodes.member[(0u + _e517)].links[3u];
                                                phi_1032_ = _e877;
                                            }
                                            let _e879 = phi_1032_;
                                            let _e884 = ((_e879 >> bitcast<u32>(((_e797 * 8u) & 31u))) & 255u);
                                            let _e885 = (_e884 & 31u);
                                            if (_e885 >= 24u) {
                                                phi_1045_ = (24u + ((_e885 - 24u) ^ _e379));
                                            } else {
                                                phi_1045_ = _e885;
                                            }
                                            let _e891 = phi_1045_;
                                            phi_1050_ = (_e793 | ((_e884 >> bitcast<u32>(5i)) << bitcast<u32>((_e891 & 31u))));
                                        } else {
                                            phi_1050_ = _e793;
                                        }
                                        let _e899 = phi_1050_;
                                        phi_1051_ = _e899;
                                    } else {
                                        phi_1051_ = _e793;
                                    }
                                    let _e901 = phi_1051_;
                                    phi_1052_ = _e901;
                                } else {
                                    phi_1052_ = _e793;
                                }
                                let _e903 = phi_1052_;
                                phi_922_ = (_e791 + 1u);
                                phi_925_ = _e903;
                            } else {
                                phi_922_ = u32();
                                phi_925_ = u32();
                            }
                            let _e906 = phi_922_;
                            let _e908 = phi_925_;
                            continue;
                            continuing {
                                phi_921_ = _e906;
                                phi_924_ = _e908;
                                break if !(_e794);
                            }
                        }
                        let _e912 = nodes.member[(0u + _e517)].links[0u];
                        let _e916 = nodes.member[(0u + _e517)].frame[3u];
                        let _e920 = local_2;
                        if ((_e920 & 4278190080u) == 0u) {
                        } else {
                            let _e924 = local_1.group_mask;
                            if ((_e924 & 4278190080u) == 0u) {
                            } else {
                                let _e928 = local_1.len;
                                if (_e928 < 32u) {
                                    let _e931 = local_1.group;
                                    let _e933 = local_1.len;
                                    if (_e933 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e933)] = _e931;
                                    let _e939 = local_1.group_mask;
                                    let _e941 = local_1.len;
                                    if (_e941 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e941)] = _e939;
                                    let _e948 = local_1.len;
                                    local_1.len = (_e948 + 1u);
                                }
                            }
                            local_1.group = (_e102 + _e912);
                            let _e952 = local_3;
                            local_1.group_mask = ((_e952 & 4278190080u) | (_e916 >> bitcast<u32>(24i)));
                        }
                        let _e957 = local_4;
                        phi_1110_ = (_e957 & 16777215u);
                        phi_1113_ = _e519;
                        loop {
                            let _e960 = phi_1110_;
                            let _e962 = phi_1113_;
                            local_10 = _e962;
                            if (_e960 == 0u) {
                                phi_1111_ = u32();
                                phi_1114_ = lt_bvh_Hit();
                                phi_2803_ = false;
                            } else {
                                let _e966 = nodes.member[(0u + _e517)].links[1u];
                                let _e970 = (_e966 + select(firstTrailingBit(_e960), 32u, (_e960 == 0u)));
                                if (_e970 < _e84) {
                                } else {
                                    return;
                                }
                                let _e977 = instances.member[(0u + _e970)].low_world;
                                let _e979 = instances.member[(0u + _e970)].high_world;
                                let _e989 = ((_e977.x - _e153.origin.x) * _e299);
                                let _e990 = ((_e977.y - _e153.origin.y) * _e310);
                                let _e991 = ((_e977.z - _e153.origin.z) * _e321);
                                let _e1001 = ((_e979.x - _e153.origin.x) * _e299);
                                let _e1002 = ((_e979.y - _e153.origin.y) * _e310);
                                let _e1003 = ((_e979.z - _e153.origin.z) * _e321);
                                if (_e989 < _e1001) {
                                    phi_1168_ = _e989;
                                } else {
                                    phi_1168_ = _e1001;
                                }
                                let _e1006 = phi_1168_;
                                if (_e990 < _e1002) {
                                    phi_1173_ = _e990;
                                } else {
                                    phi_1173_ = _e1002;
                                }
                                let _e1009 = phi_1173_;
                                if (_e991 < _e1003) {
                                    phi_1178_ = _e991;
                                } else {
                                    phi_1178_ = _e1003;
                                }
                                let _e1012 = phi_1178_;
                                if (_e989 > _e1001) {
                                    phi_1186_ = _e989;
                                } else {
                                    phi_1186_ = _e1001;
                                }
                                let _e1018 = phi_1186_;
                                if (_e990 > _e1002) {
                                    phi_1191_ = _e990;
                                } else {
                                    phi_1191_ = _e1002;
                                }
                                let _e1021 = phi_1191_;
                                if (_e991 > _e1003) {
                                    phi_1196_ = _e991;
                                } else {
                                    phi_1196_ = _e1003;
                                }
                                let _e1024 = phi_1196_;
                                let _e1028 = core_intrinsics_maximum_number_nsz_f32_((_e1006 - _e366), (_e1009 - _e367));
                                let _e1029 = core_intrinsics_maximum_number_nsz_f32_(_e1028, (_e1012 - _e368));
                                let _e1030 = core_intrinsics_minimum_number_nsz_f32_((_e1018 + _e366), (_e1021 + _e367));
                                let _e1031 = core_intrinsics_minimum_number_nsz_f32_(_e1030, (_e1024 + _e368));
                                if (_e1029 <= _e1031) {
                                    if (_e1029 <= _e962.t) {
                                        if (_e1031 >= _e153.tmin) {
                                            let _e1043 = instances.member[(0u + _e970)].world_to_object[0u];
                                            let _e1054 = ((((_e1043.x * _e153.origin.x) + (_e1043.y * _e153.origin.y)) + (_e1043.z * _e153.origin.z)) + (_e1043.w * 1f));
                                            let _e1056 = instances.member[(0u + _e970)].world_to_object[1u];
                                            let _e1067 = ((((_e1056.x * _e153.origin.x) + (_e1056.y * _e153.origin.y)) + (_e1056.z * _e153.origin.z)) + (_e1056.w * 1f));
                                            let _e1069 = instances.member[(0u + _e970)].world_to_object[2u];
                                            let _e1080 = ((((_e1069.x * _e153.origin.x) + (_e1069.y * _e153.origin.y)) + (_e1069.z * _e153.origin.z)) + (_e1069.w * 1f));
                                            let _e1087 = instances.member[(0u + _e970)].world_to_object[0u];
                                            let _e1098 = ((((_e1087.x * _e153.direction.x) + (_e1087.y * _e153.direction.y)) + (_e1087.z * _e153.direction.z)) + (_e1087.w * 0f));
                                            let _e1100 = instances.member[(0u + _e970)].world_to_object[1u];
                                            let _e1111 = ((((_e1100.x * _e153.direction.x) + (_e1100.y * _e153.direction.y)) + (_e1100.z * _e153.direction.z)) + (_e1100.w * 0f));
                                            let _e1113 = instances.member[(0u + _e970)].world_to_object[2u];
                                            let _e1124 = ((((_e1113.x * _e153.direction.x) + (_e1113.y * _e153.direction.y)) + (_e1113.z * _e153.direction.z)) + (_e1113.w * 0f));
                                            let _e1129 = instances.member[(0u + _e970)].root;
                                            let _e1131 = instances.member[(0u + _e970)].first_triangle;
                                            let _e1132 = abs(_e1098);
                                            let _e1133 = abs(_e1111);
                                            let _e1134 = abs(_e1124);
                                            if (abs(_e1054) < 1000000000000000f) {
                                                if (abs(_e1067) < 1000000000000000f) {
                                                    phi_1328_ = (abs(_e1080) < 1000000000000000f);
                                                    phi_1329_ = false;
                                                } else {
                                                    phi_1328_ = bool();
                                                    phi_1329_ = true;
                                                }
                                                let _e1142 = phi_1328_;
                                                let _e1144 = phi_1329_;
                                                phi_1330_ = _e1142;
                                                phi_1331_ = _e1144;
                                            } else {
                                                phi_1330_ = bool();
                                                phi_1331_ = true;
                                            }
                                            let _e1146 = phi_1330_;
                                            let _e1148 = phi_1331_;
                                            if _e1148 {
                                                phi_1335_ = false;
                                            } else {
                                                phi_1335_ = _e1146;
                                            }
                                            let _e1150 = phi_1335_;
                                            if _e1150 {
                                                if (_e1132 < 1000000000000000f) {
                                                    if (_e1133 < 1000000000000000f) {
                                                        phi_1348_ = (_e1134 < 1000000000000000f);
                                                        phi_1349_ = false;
                                                    } else {
                                                        phi_1348_ = bool();
                                                        phi_1349_ = true;
                                                    }
                                                    let _e1155 = phi_1348_;
                                                    let _e1157 = phi_1349_;
                                                    phi_1350_ = _e1155;
                                                    phi_1351_ = _e1157;
                                                } else {
                                                    phi_1350_ = bool();
                                                    phi_1351_ = true;
                                                }
                                                let _e1159 = phi_1350_;
                                                let _e1161 = phi_1351_;
                                                if _e1161 {
                                                    phi_1355_ = false;
                                                } else {
                                                    phi_1355_ = _e1159;
                                                }
                                                let _e1163 = phi_1355_;
                                                if _e1163 {
                                                    if (_e1132 > 0f) {
                                                        phi_1369_ = bool();
                                                        phi_1370_ = true;
                                                    } else {
                                                        let _e1165 = (_e1133 > 0f);
                                                        if _e1165 {
                                                            phi_1368_ = bool();
                                                        } else {
                                                            phi_1368_ = (_e1134 > 0f);
                                                        }
                                                        let _e1168 = phi_1368_;
                                                        phi_1369_ = _e1168;
                                                        phi_1370_ = _e1165;
                                                    }
                                                    let _e1170 = phi_1369_;
                                                    let _e1172 = phi_1370_;
                                                    if _e1172 {
                                                        phi_1374_ = true;
                                                    } else {
                                                        phi_1374_ = _e1170;
                                                    }
                                                    let _e1174 = phi_1374_;
                                                    phi_1375_ = _e1174;
                                                    phi_1376_ = false;
                                                } else {
                                                    phi_1375_ = bool();
                                                    phi_1376_ = true;
                                                }
                                                let _e1176 = phi_1375_;
                                                let _e1178 = phi_1376_;
                                                phi_1377_ = _e1176;
                                                phi_1378_ = _e1178;
                                            } else {
                                                phi_1377_ = bool();
                                                phi_1378_ = true;
                                            }
                                            let _e1180 = phi_1377_;
                                            let _e1182 = phi_1378_;
                                            if _e1182 {
                                                phi_1382_ = false;
                                            } else {
                                                phi_1382_ = _e1180;
                                            }
                                            let _e1184 = phi_1382_;
                                            if _e1184 {
                                                let _e1185 = (_e1129 >= _e69);
                                                if _e1185 {
                                                    phi_2793_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1129 < _e69) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1191 = nodes.member[(0u + _e1129)].frame[0u];
                                                    let _e1195 = nodes.member[(0u + _e1129)].frame[1u];
                                                    let _e1199 = nodes.member[(0u + _e1129)].frame[2u];
                                                    let _e1203 = nodes.member[(0u + _e1129)].frame[0u];
                                                    let _e1207 = nodes.member[(0u + _e1129)].frame[1u];
                                                    let _e1211 = nodes.member[(0u + _e1129)].frame[2u];
                                                    let _e1215 = nodes.member[(0u + _e1129)].frame[3u];
                                                    let _e1249 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1098), abs(_e1111));
                                                    let _e1250 = core_intrinsics_maximum_number_nsz_f32_(_e1249, abs(_e1124));
                                                    let _e1251 = (_e1250 * 0.0000000000009094947f);
                                                    if (abs(_e1098) < _e1251) {
                                                        phi_1452_ = _e1251;
                                                    } else {
                                                        phi_1452_ = abs(_e1098);
                                                    }
                                                    let _e1256 = phi_1452_;
                                                    if (_e1098 < 0f) {
                                                        phi_1459_ = (-1f / _e1256);
                                                    } else {
                                                        phi_1459_ = (1f / _e1256);
                                                    }
                                                    let _e1261 = phi_1459_;
                                                    if (abs(_e1111) < _e1251) {
                                                        phi_1466_ = _e1251;
                                                    } else {
                                                        phi_1466_ = abs(_e1111);
                                                    }
                                                    let _e1266 = phi_1466_;
                                                    if (_e1111 < 0f) {
                                                        phi_1473_ = (-1f / _e1266);
                                                    } else {
                                                        phi_1473_ = (1f / _e1266);
                                                    }
                                                    let _e1271 = phi_1473_;
                                                    if (abs(_e1124) < _e1251) {
                                                        phi_1480_ = _e1251;
                                                    } else {
                                                        phi_1480_ = abs(_e1124);
                                                    }
                                                    let _e1276 = phi_1480_;
                                                    if (_e1124 < 0f) {
                                                        phi_1487_ = (-1f / _e1276);
                                                    } else {
                                                        phi_1487_ = (1f / _e1276);
                                                    }
                                                    let _e1281 = phi_1487_;
                                                    let _e1285 = abs((bitcast<f32>(_e1191) - _e1054));
                                                    let _e1286 = abs((bitcast<f32>(_e1195) - _e1067));
                                                    let _e1287 = abs((bitcast<f32>(_e1199) - _e1080));
                                                    let _e1291 = abs(((bitcast<f32>(_e1203) + (bitcast<f32>((((_e1215 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1054));
                                                    let _e1292 = abs(((bitcast<f32>(_e1207) + (bitcast<f32>((((_e1215 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1067));
                                                    let _e1293 = abs(((bitcast<f32>(_e1211) + (bitcast<f32>((((_e1215 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1080));
                                                    if (_e1285 > _e1291) {
                                                        phi_1504_ = _e1285;
                                                    } else {
                                                        phi_1504_ = _e1291;
                                                    }
                                                    let _e1296 = phi_1504_;
                                                    if (_e1286 > _e1292) {
                                                        phi_1509_ = _e1286;
                                                    } else {
                                                        phi_1509_ = _e1292;
                                                    }
                                                    let _e1299 = phi_1509_;
                                                    if (_e1287 > _e1293) {
                                                        phi_1514_ = _e1287;
                                                    } else {
                                                        phi_1514_ = _e1293;
                                                    }
                                                    let _e1302 = phi_1514_;
                                                    if (_e1296 > _e1299) {
                                                        phi_1519_ = _e1296;
                                                    } else {
                                                        phi_1519_ = _e1299;
                                                    }
                                                    let _e1305 = phi_1519_;
                                                    if (_e1305 > _e1302) {
                                                        phi_1524_ = _e1305;
                                                    } else {
                                                        phi_1524_ = _e1302;
                                                    }
                                                    let _e1308 = phi_1524_;
                                                    let _e1312 = (_e1308 * 0.0000019073486f);
                                                    let _e1313 = (abs(_e1261) * _e1312);
                                                    let _e1314 = (abs(_e1271) * _e1312);
                                                    let _e1315 = (abs(_e1281) * _e1312);
                                                    let _e1319 = (_e1308 * 0.0000009536743f);
                                                    let _e1320 = (abs(_e1261) * _e1319);
                                                    let _e1321 = (abs(_e1271) * _e1319);
                                                    let _e1322 = (abs(_e1281) * _e1319);
                                                    let _e1323 = abs(_e1098);
                                                    let _e1324 = abs(_e1111);
                                                    let _e1325 = abs(_e1124);
                                                    if (_e1323 >= _e1324) {
                                                        if (_e1323 >= _e1325) {
                                                            phi_1550_ = false;
                                                        } else {
                                                            phi_1550_ = true;
                                                        }
                                                        let _e1329 = phi_1550_;
                                                        phi_1551_ = _e1329;
                                                    } else {
                                                        phi_1551_ = true;
                                                    }
                                                    let _e1331 = phi_1551_;
                                                    if _e1331 {
                                                        if (_e1324 >= _e1325) {
                                                            phi_1559_ = 1u;
                                                        } else {
                                                            phi_1559_ = 2u;
                                                        }
                                                        let _e1334 = phi_1559_;
                                                        phi_1560_ = _e1334;
                                                    } else {
                                                        phi_1560_ = 0u;
                                                    }
                                                    let _e1336 = phi_1560_;
                                                    if (_e1336 == 0u) {
                                                        phi_1572_ = vec3<f32>(_e1111, _e1124, _e1098);
                                                    } else {
                                                        if (_e1336 == 1u) {
                                                            phi_1571_ = vec3<f32>(_e1124, _e1098, _e1111);
                                                        } else {
                                                            phi_1571_ = vec3<f32>(_e1098, _e1111, _e1124);
                                                        }
                                                        let _e1342 = phi_1571_;
                                                        phi_1572_ = _e1342;
                                                    }
                                                    let _e1344 = phi_1572_;
                                                    let _e1347 = (_e1344.x / _e1344.z);
                                                    let _e1350 = (_e1344.y / _e1344.z);
                                                    if (_e1261 < 0f) {
                                                        phi_1585_ = 0u;
                                                    } else {
                                                        phi_1585_ = 1u;
                                                    }
                                                    let _e1355 = phi_1585_;
                                                    if (_e1271 < 0f) {
                                                        phi_1590_ = 0u;
                                                    } else {
                                                        phi_1590_ = 2u;
                                                    }
                                                    let _e1358 = phi_1590_;
                                                    if (_e1281 < 0f) {
                                                        phi_1595_ = 0u;
                                                    } else {
                                                        phi_1595_ = 4u;
                                                    }
                                                    let _e1361 = phi_1595_;
                                                    let _e1363 = ((_e1355 | _e1358) | _e1361);
                                                    let _e1364 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1129, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1364.first[0], _e1364.first[1], _e1364.first[2], _e1364.first[3], _e1364.first[4], _e1364.first[5], _e1364.first[6], _e1364.first[7], _e1364.first[8], _e1364.first[9], _e1364.first[10], _e1364.first[11], _e1364.first[12], _e1364.first[13], _e1364.first[14], _e1364.first[15], _e1364.first[16], _e1364.first[17], _e1364.first[18], _e1364.first[19], _e1364.first[20], _e1364.first[21], _e1364.first[22], _e1364.first[23], _e1364.first[24], _e1364.first[25], _e1364.first[26], _e1364.first[27], _e1364.first[28], _e1364.first[29], _e1364.first[30], _e1364.first[31]), array<u32, 32>(_e1364.mask[0], _e1364.mask[1], _e1364.mask[2], _e1364.mask[3], _e1364.mask[4], _e1364.mask[5], _e1364.mask[6], _e1364.mask[7], _e1364.mask[8], _e1364.mask[9], _e1364.mask[10], _e1364.mask[11], _e1364.mask[12], _e1364.mask[13], _e1364.mask[14], _e1364.mask[15], _e1364.mask[16], _e1364.mask[17], _e1364.mask[18], _e1364.mask[19], _e1364.mask[20], _e1364.mask[21], _e1364.mask[22], _e1364.mask[23], _e1364.mask[24], _e1364.mask[25], _e1364.mask[26], _e1364.mask[27], _e1364.mask[28], _e1364.mask[29], _e1364.mask[30], _e1364.mask[31]), _e1364.len, _e1364.group, _e1364.group_mask);
                                                    let _e1438 = local.group_mask;
                                                    if ((_e1438 & 4278190080u) == 0u) {
                                                        let _e1442 = local.len;
                                                        if (_e1442 == 0u) {
                                                            phi_1709_ = false;
                                                        } else {
                                                            let _e1446 = local.len;
                                                            local.len = (_e1446 - 1u);
                                                            let _e1449 = local.len;
                                                            if (_e1449 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1454 = local.first[(0u + _e1449)];
                                                            local.group = _e1454;
                                                            let _e1457 = local.len;
                                                            if (_e1457 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1462 = local.mask[(0u + _e1457)];
                                                            local.group_mask = _e1462;
                                                            phi_1709_ = true;
                                                        }
                                                        let _e1465 = phi_1709_;
                                                        phi_1710_ = _e1465;
                                                    } else {
                                                        phi_1710_ = true;
                                                    }
                                                    let _e1467 = phi_1710_;
                                                    if _e1467 {
                                                        let _e1469 = local.group_mask;
                                                        let _e1475 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1469)), 32u, (_e1469 == 0u)));
                                                        let _e1479 = local.group_mask;
                                                        let _e1493 = local.group_mask;
                                                        local.group_mask = (_e1493 & ~((1u << bitcast<u32>((_e1475 & 31u)))));
                                                        let _e1496 = local.group;
                                                        phi_1741_ = (_e1496 + countOneBits(((_e1479 & ~((4294967295u << bitcast<u32>((((_e1475 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1741_ = 4294967295u;
                                                    }
                                                    let _e1499 = phi_1741_;
                                                    phi_1743_ = _e962;
                                                    phi_1746_ = _e1499;
                                                    loop {
                                                        let _e1501 = phi_1743_;
                                                        let _e1503 = phi_1746_;
                                                        local_9 = _e1501;
                                                        let _e1504 = (_e1503 != 4294967295u);
                                                        if _e1504 {
                                                            if (_e1503 < _e69) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1511 = nodes.member[(0u + _e1503)].frame[3u];
                                                            let _e1536 = (bitcast<f32>((((_e1511 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1261);
                                                            let _e1537 = (bitcast<f32>((((_e1511 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1271);
                                                            let _e1538 = (bitcast<f32>((((_e1511 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1281);
                                                            let _e1541 = nodes.member[(0u + _e1503)].frame[0u];
                                                            let _e1545 = nodes.member[(0u + _e1503)].frame[1u];
                                                            let _e1549 = nodes.member[(0u + _e1503)].frame[2u];
                                                            let _e1554 = ((bitcast<f32>(_e1541) - _e1054) * _e1261);
                                                            let _e1555 = ((bitcast<f32>(_e1545) - _e1067) * _e1271);
                                                            let _e1556 = ((bitcast<f32>(_e1549) - _e1080) * _e1281);
                                                            let _e1564 = nodes.member[(0u + _e1503)].x;
                                                            if (_e1261 < 0f) {
                                                                let _e1575 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1564.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1581 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1575.unnamed.word, _e1564.w), _e1575.unnamed_1);
                                                                let _e1587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1581.unnamed, lt_mask_LightPlace(_e1564.x, _e1581.unnamed_1.shift));
                                                                phi_1827_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1587.unnamed, lt_mask_LightPlace(_e1587.unnamed_1.word, _e1564.y));
                                                            } else {
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1564.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1603.unnamed.word, _e1564.y), _e1603.unnamed_1);
                                                                let _e1615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_mask_LightPlace(_e1564.z, _e1609.unnamed_1.shift));
                                                                phi_1827_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1615.unnamed, lt_mask_LightPlace(_e1615.unnamed_1.word, _e1564.w));
                                                            }
                                                            let _e1623 = phi_1827_;
                                                            let _e1633 = nodes.member[(0u + _e1503)].y;
                                                            if (_e1271 < 0f) {
                                                                let _e1644 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1633.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1650 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1644.unnamed.word, _e1633.w), _e1644.unnamed_1);
                                                                let _e1656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1650.unnamed, lt_mask_LightPlace(_e1633.x, _e1650.unnamed_1.shift));
                                                                phi_1854_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1656.unnamed, lt_mask_LightPlace(_e1656.unnamed_1.word, _e1633.y));
                                                            } else {
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1633.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1672.unnamed.word, _e1633.y), _e1672.unnamed_1);
                                                                let _e1684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_mask_LightPlace(_e1633.z, _e1678.unnamed_1.shift));
                                                                phi_1854_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1684.unnamed, lt_mask_LightPlace(_e1684.unnamed_1.word, _e1633.w));
                                                            }
                                                            let _e1692 = phi_1854_;
                                                            let _e1702 = nodes.member[(0u + _e1503)].z;
                                                            if (_e1281 < 0f) {
                                                                let _e1713 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1702.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1719 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1713.unnamed.word, _e1702.w), _e1713.unnamed_1);
                                                                let _e1725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1719.unnamed, lt_mask_LightPlace(_e1702.x, _e1719.unnamed_1.shift));
                                                                phi_1881_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1725.unnamed, lt_mask_LightPlace(_e1725.unnamed_1.word, _e1702.y));
                                                            } else {
                                                                let _e1741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1702.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1747 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1741.unnamed.word, _e1702.y), _e1741.unnamed_1);
                                                                let _e1753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1747.unnamed, lt_mask_LightPlace(_e1702.z, _e1747.unnamed_1.shift));
                                                                phi_1881_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1753.unnamed, lt_mask_LightPlace(_e1753.unnamed_1.word, _e1702.w));
                                                            }
                                                            let _e1761 = phi_1881_;
                                                            phi_1887_ = 0u;
                                                            phi_1890_ = 0u;
                                                            loop {
                                                                let _e1771 = phi_1887_;
                                                                let _e1773 = phi_1890_;
                                                                local_5 = _e1773;
                                                                local_6 = _e1773;
                                                                local_7 = _e1773;
                                                                let _e1774 = (_e1771 < 8u);
                                                                if _e1774 {
                                                                    let _e1776 = (_e1771 >> bitcast<u32>(2i));
                                                                    let _e1777 = (_e1771 & 3u);
                                                                    if (_e1776 == 0u) {
                                                                        phi_1904_ = _e1623.unnamed.word;
                                                                    } else {
                                                                        phi_1904_ = _e1623.unnamed.shift;
                                                                    }
                                                                    let _e1780 = phi_1904_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1914_ = _e1692.unnamed.word;
                                                                    } else {
                                                                        phi_1914_ = _e1692.unnamed.shift;
                                                                    }
                                                                    let _e1789 = phi_1914_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1924_ = _e1761.unnamed.word;
                                                                    } else {
                                                                        phi_1924_ = _e1761.unnamed.shift;
                                                                    }
                                                                    let _e1798 = phi_1924_;
                                                                    let _e1811 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1780 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1536) + (_e1554 - _e1313)), ((f32(((_e1789 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1537) + (_e1555 - _e1314)));
                                                                    let _e1812 = core_intrinsics_maximum_number_nsz_f32_(_e1811, ((f32(((_e1798 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1538) + (_e1556 - _e1315)));
                                                                    if (_e1776 == 0u) {
                                                                        phi_1942_ = _e1623.unnamed_1.word;
                                                                    } else {
                                                                        phi_1942_ = _e1623.unnamed_1.shift;
                                                                    }
                                                                    let _e1815 = phi_1942_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1952_ = _e1692.unnamed_1.word;
                                                                    } else {
                                                                        phi_1952_ = _e1692.unnamed_1.shift;
                                                                    }
                                                                    let _e1824 = phi_1952_;
                                                                    if (_e1776 == 0u) {
                                                                        phi_1962_ = _e1761.unnamed_1.word;
                                                                    } else {
                                                                        phi_1962_ = _e1761.unnamed_1.shift;
                                                                    }
                                                                    let _e1833 = phi_1962_;
                                                                    let _e1846 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1815 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1536) + (_e1554 + _e1313)), ((f32(((_e1824 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1537) + (_e1555 + _e1314)));
                                                                    let _e1847 = core_intrinsics_minimum_number_nsz_f32_(_e1846, ((f32(((_e1833 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u)) * _e1538) + (_e1556 + _e1315)));
                                                                    if (_e1812 <= _e1847) {
                                                                        if (_e1812 <= _e1501.t) {
                                                                            if (_e1847 >= _e153.tmin) {
                                                                                if (_e1776 == 0u) {
                                                                                    let _e1854 = nodes.member[(0u + _e1503)].links[2u];
                                                                                    phi_1998_ = _e1854;
                                                                                } else {
                                                                                    let _e1857 = nodes.member[(0u + _e1503)].links[3u];
                                                                                    phi_1998_ = _e1857;
                                                                                }
                                                                                let _e1859 = phi_1998_;
                                                                                let _e1864 = ((_e1859 >> bitcast<u32>(((_e1777 * 8u) & 31u))) & 255u);
                                                                                let _e1865 = (_e1864 & 31u);
                                                                                if (_e1865 >= 24u) {
                                                                                    phi_2011_ = (24u + ((_e1865 - 24u) ^ _e1363));
                                                                                } else {
                                                                                    phi_2011_ = _e1865;
                                                                                }
                                                                                let _e1871 = phi_2011_;
                                                                                phi_2016_ = (_e1773 | ((_e1864 >> bitcast<u32>(5i)) << bitcast<u32>((_e1871 & 31u))));
                                                                            } else {
                                                                                phi_2016_ = _e1773;
                                                                            }
                                                                            let _e1879 = phi_2016_;
                                                                            phi_2017_ = _e1879;
                                                                        } else {
                                                                            phi_2017_ = _e1773;
                                                                        }
                                                                        let _e1881 = phi_2017_;
                                                                        phi_2018_ = _e1881;
                                                                    } else {
                                                                        phi_2018_ = _e1773;
                                                                    }
                                                                    let _e1883 = phi_2018_;
                                                                    phi_1888_ = (_e1771 + 1u);
                                                                    phi_1891_ = _e1883;
                                                                } else {
                                                                    phi_1888_ = u32();
                                                                    phi_1891_ = u32();
                                                                }
                                                                let _e1886 = phi_1888_;
                                                                let _e1888 = phi_1891_;
                                                                continue;
                                                                continuing {
                                                                    phi_1887_ = _e1886;
                                                                    phi_1890_ = _e1888;
                                                                    break if !(_e1774);
                                                                }
                                                            }
                                                            let _e1892 = nodes.member[(0u + _e1503)].links[0u];
                                                            let _e1896 = nodes.member[(0u + _e1503)].frame[3u];
                                                            let _e1900 = local_5;
                                                            if ((_e1900 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1904 = local.group_mask;
                                                                if ((_e1904 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1908 = local.len;
                                                                    if (_e1908 < 32u) {
                                                                        let _e1911 = local.group;
                                                                        let _e1913 = local.len;
                                                                        if (_e1913 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1913)] = _e1911;
                                                                        let _e1919 = local.group_mask;
                                                                        let _e1921 = local.len;
                                                                        if (_e1921 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1921)] = _e1919;
                                                                        let _e1928 = local.len;
                                                                        local.len = (_e1928 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1129 + _e1892);
                                                                let _e1932 = local_6;
                                                                local.group_mask = ((_e1932 & 4278190080u) | (_e1896 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1937 = local_7;
                                                            phi_2076_ = _e1501;
                                                            phi_2079_ = (_e1937 & 16777215u);
                                                            loop {
                                                                let _e1940 = phi_2076_;
                                                                let _e1942 = phi_2079_;
                                                                local_8 = _e1940;
                                                                if (_e1942 == 0u) {
                                                                    phi_2077_ = lt_bvh_Hit();
                                                                    phi_2080_ = u32();
                                                                    phi_2721_ = false;
                                                                } else {
                                                                    let _e1946 = nodes.member[(0u + _e1503)].links[1u];
                                                                    let _e1951 = ((_e1131 + _e1946) + select(firstTrailingBit(_e1942), 32u, (_e1942 == 0u)));
                                                                    if (_e1951 < _e72) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1958 = triangles.member[(0u + _e1951)].v0_;
                                                                    let _e1960 = (_e1958.x - _e1054);
                                                                    let _e1962 = (_e1958.y - _e1067);
                                                                    let _e1964 = (_e1958.z - _e1080);
                                                                    if (_e1336 == 0u) {
                                                                        phi_2124_ = vec3<f32>(_e1962, _e1964, _e1960);
                                                                    } else {
                                                                        if (_e1336 == 1u) {
                                                                            phi_2123_ = vec3<f32>(_e1964, _e1960, _e1962);
                                                                        } else {
                                                                            phi_2123_ = (_e1958 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                        }
                                                                        let _e1972 = phi_2123_;
                                                                        phi_2124_ = _e1972;
                                                                    }
                                                                    let _e1974 = phi_2124_;
                                                                    let _e1978 = (_e1974.x - (_e1347 * _e1974.z));
                                                                    let _e1982 = (_e1974.y - (_e1350 * _e1974.z));
                                                                    let _e1984 = triangles.member[(0u + _e1951)].v1_;
                                                                    let _e1986 = (_e1984.x - _e1054);
                                                                    let _e1988 = (_e1984.y - _e1067);
                                                                    let _e1990 = (_e1984.z - _e1080);
                                                                    if (_e1336 == 0u) {
                                                                        phi_2154_ = vec3<f32>(_e1988, _e1990, _e1986);
                                                                    } else {
                                                                        if (_e1336 == 1u) {
                                                                            phi_2153_ = vec3<f32>(_e1990, _e1986, _e1988);
                                                                        } else {
                                                                            phi_2153_ = (_e1984 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                        }
                                                                        let _e1998 = phi_2153_;
                                                                        phi_2154_ = _e1998;
                                                                    }
                                                                    let _e2000 = phi_2154_;
                                                                    let _e2004 = (_e2000.x - (_e1347 * _e2000.z));
                                                                    let _e2008 = (_e2000.y - (_e1350 * _e2000.z));
                                                                    let _e2010 = triangles.member[(0u + _e1951)].v2_;
                                                                    let _e2012 = (_e2010.x - _e1054);
                                                                    let _e2014 = (_e2010.y - _e1067);
                                                                    let _e2016 = (_e2010.z - _e1080);
                                                                    if (_e1336 == 0u) {
                                                                        phi_2184_ = vec3<f32>(_e2014, _e2016, _e2012);
                                                                    } else {
                                                                        if (_e1336 == 1u) {
                                                                            phi_2183_ = vec3<f32>(_e2016, _e2012, _e2014);
                                                                        } else {
                                                                            phi_2183_ = (_e2010 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                        }
                                                                        let _e2024 = phi_2183_;
                                                                        phi_2184_ = _e2024;
                                                                    }
                                                                    let _e2026 = phi_2184_;
                                                                    let _e2030 = (_e2026.x - (_e1347 * _e2026.z));
                                                                    let _e2034 = (_e2026.y - (_e1350 * _e2026.z));
                                                                    if (_e2004 < _e2030) {
                                                                        phi_2203_ = true;
                                                                    } else {
                                                                        if (_e2004 == _e2030) {
                                                                            phi_2202_ = (_e2008 < _e2034);
                                                                        } else {
                                                                            phi_2202_ = false;
                                                                        }
                                                                        let _e2039 = phi_2202_;
                                                                        phi_2203_ = _e2039;
                                                                    }
                                                                    let _e2041 = phi_2203_;
                                                                    if _e2041 {
                                                                        phi_2207_ = _e2034;
                                                                        phi_2208_ = _e2030;
                                                                        phi_2209_ = _e2008;
                                                                        phi_2210_ = _e2004;
                                                                    } else {
                                                                        phi_2207_ = _e2008;
                                                                        phi_2208_ = _e2004;
                                                                        phi_2209_ = _e2034;
                                                                        phi_2210_ = _e2030;
                                                                    }
                                                                    let _e2043 = phi_2207_;
                                                                    let _e2045 = phi_2208_;
                                                                    let _e2047 = phi_2209_;
                                                                    let _e2049 = phi_2210_;
                                                                    let _e2052 = ((_e2049 * _e2043) - (_e2047 * _e2045));
                                                                    if _e2041 {
                                                                        phi_2218_ = -(_e2052);
                                                                    } else {
                                                                        phi_2218_ = _e2052;
                                                                    }
                                                                    let _e2055 = phi_2218_;
                                                                    if (_e2030 < _e1978) {
                                                                        phi_2229_ = true;
                                                                    } else {
                                                                        if (_e2030 == _e1978) {
                                                                            phi_2228_ = (_e2034 < _e1982);
                                                                        } else {
                                                                            phi_2228_ = false;
                                                                        }
                                                                        let _e2060 = phi_2228_;
                                                                        phi_2229_ = _e2060;
                                                                    }
                                                                    let _e2062 = phi_2229_;
                                                                    if _e2062 {
                                                                        phi_2233_ = _e1982;
                                                                        phi_2234_ = _e1978;
                                                                        phi_2235_ = _e2034;
                                                                        phi_2236_ = _e2030;
                                                                    } else {
                                                                        phi_2233_ = _e2034;
                                                                        phi_2234_ = _e2030;
                                                                        phi_2235_ = _e1982;
                                                                        phi_2236_ = _e1978;
                                                                    }
                                                                    let _e2064 = phi_2233_;
                                                                    let _e2066 = phi_2234_;
                                                                    let _e2068 = phi_2235_;
                                                                    let _e2070 = phi_2236_;
                                                                    let _e2073 = ((_e2070 * _e2064) - (_e2068 * _e2066));
                                                                    if _e2062 {
                                                                        phi_2244_ = -(_e2073);
                                                                    } else {
                                                                        phi_2244_ = _e2073;
                                                                    }
                                                                    let _e2076 = phi_2244_;
                                                                    if (_e1978 < _e2004) {
                                                                        phi_2255_ = true;
                                                                    } else {
                                                                        if (_e1978 == _e2004) {
                                                                            phi_2254_ = (_e1982 < _e2008);
                                                                        } else {
                                                                            phi_2254_ = false;
                                                                        }
                                                                        let _e2081 = phi_2254_;
                                                                        phi_2255_ = _e2081;
                                                                    }
                                                                    let _e2083 = phi_2255_;
                                                                    if _e2083 {
                                                                        phi_2259_ = _e2008;
                                                                        phi_2260_ = _e2004;
                                                                        phi_2261_ = _e1982;
                                                                        phi_2262_ = _e1978;
                                                                    } else {
                                                                        phi_2259_ = _e1982;
                                                                        phi_2260_ = _e1978;
                                                                        phi_2261_ = _e2008;
                                                                        phi_2262_ = _e2004;
                                                                    }
                                                                    let _e2085 = phi_2259_;
                                                                    let _e2087 = phi_2260_;
                                                                    let _e2089 = phi_2261_;
                                                                    let _e2091 = phi_2262_;
                                                                    let _e2094 = ((_e2091 * _e2085) - (_e2089 * _e2087));
                                                                    if _e2083 {
                                                                        phi_2270_ = -(_e2094);
                                                                    } else {
                                                                        phi_2270_ = _e2094;
                                                                    }
                                                                    let _e2097 = phi_2270_;
                                                                    if (_e2055 >= 0f) {
                                                                        if (_e2076 >= 0f) {
                                                                            if (_e2097 >= 0f) {
                                                                                phi_2285_ = ((_e2055 + _e2076) + _e2097);
                                                                                phi_2286_ = false;
                                                                            } else {
                                                                                phi_2285_ = f32();
                                                                                phi_2286_ = true;
                                                                            }
                                                                            let _e2104 = phi_2285_;
                                                                            let _e2106 = phi_2286_;
                                                                            phi_2287_ = _e2104;
                                                                            phi_2288_ = _e2106;
                                                                        } else {
                                                                            phi_2287_ = f32();
                                                                            phi_2288_ = true;
                                                                        }
                                                                        let _e2108 = phi_2287_;
                                                                        let _e2110 = phi_2288_;
                                                                        phi_2289_ = _e2108;
                                                                        phi_2290_ = _e2110;
                                                                    } else {
                                                                        phi_2289_ = f32();
                                                                        phi_2290_ = true;
                                                                    }
                                                                    let _e2112 = phi_2289_;
                                                                    let _e2114 = phi_2290_;
                                                                    if _e2114 {
                                                                        if (_e2055 <= 0f) {
                                                                            if (_e2076 <= 0f) {
                                                                                let _e2117 = (_e2097 <= 0f);
                                                                                if _e2117 {
                                                                                }
                                                                                phi_2308_ = ((_e2055 + _e2076) + _e2097);
                                                                                phi_2309_ = false;
                                                                                phi_2310_ = _e2117;
                                                                            } else {
                                                                                phi_2308_ = f32();
                                                                                phi_2309_ = true;
                                                                                phi_2310_ = false;
                                                                            }
                                                                            let _e2121 = phi_2308_;
                                                                            let _e2123 = phi_2309_;
                                                                            let _e2125 = phi_2310_;
                                                                            phi_2311_ = _e2121;
                                                                            phi_2312_ = _e2123;
                                                                            phi_2313_ = _e2125;
                                                                        } else {
                                                                            phi_2311_ = f32();
                                                                            phi_2312_ = true;
                                                                            phi_2313_ = false;
                                                                        }
                                                                        let _e2127 = phi_2311_;
                                                                        let _e2129 = phi_2312_;
                                                                        let _e2131 = phi_2313_;
                                                                        if _e2129 {
                                                                            phi_2317_ = false;
                                                                        } else {
                                                                            phi_2317_ = _e2131;
                                                                        }
                                                                        let _e2133 = phi_2317_;
                                                                        phi_2318_ = _e2127;
                                                                        phi_2319_ = _e2133;
                                                                    } else {
                                                                        phi_2318_ = _e2112;
                                                                        phi_2319_ = true;
                                                                    }
                                                                    let _e2135 = phi_2318_;
                                                                    let _e2137 = phi_2319_;
                                                                    if _e2137 {
                                                                        let _e2138 = (_e2135 == 0f);
                                                                        if _e2138 {
                                                                            phi_2635_ = lt_bvh_triangle_Intersection();
                                                                            phi_2636_ = false;
                                                                        } else {
                                                                            let _e2140 = triangles.member[(0u + _e1951)].v0_;
                                                                            let _e2142 = (_e2140.x - _e1054);
                                                                            let _e2144 = (_e2140.y - _e1067);
                                                                            let _e2146 = (_e2140.z - _e1080);
                                                                            if (_e1336 == 0u) {
                                                                                phi_2348_ = vec3<f32>(_e2144, _e2146, _e2142);
                                                                            } else {
                                                                                if (_e1336 == 1u) {
                                                                                    phi_2347_ = vec3<f32>(_e2146, _e2142, _e2144);
                                                                                } else {
                                                                                    phi_2347_ = (_e2140 - vec3<f32>(_e1054, _e1067, _e1080));
                                                                                }
                                                                                let _e2154 = phi_2347_;
                                                                                phi_2348_ = _e2154;
                                                                            }
                                                                            let _e2156 = phi_2348_;
                                                                            let _e2158 = triangles.member[(0u + _e1951)].v1_;
                                                                            let _e2160 = triangles.member[(0u + _e1951)].v0_;
                                                                            let _e2163 = (_e2158.x - _e2160.x);
                                                                            let _e2166 = (_e2158.y - _e2160.y);
                                                                            let _e2169 = (_e2158.z - _e2160.z);
                                                                            if (_e1336 == 0u) {
                                                                                phi_2374_ = vec3<f32>(_e2166, _e2169, _e2163);
                                                                            } else {
                                                                                if (_e1336 == 1u) {
                                                                                    phi_2373_ = vec3<f32>(_e2169, _e2163, _e2166);
                                                                                } else {
                                                                                    phi_2373_ = (_e2158 - _e2160);
                                                                                }
                                                                                let _e2176 = phi_2373_;
                                                                                phi_2374_ = _e2176;
                                                                            }
                                                                            let _e2178 = phi_2374_;
                                                                            let _e2180 = triangles.member[(0u + _e1951)].v2_;
                                                                            let _e2182 = triangles.member[(0u + _e1951)].v0_;
                                                                            let _e2185 = (_e2180.x - _e2182.x);
                                                                            let _e2188 = (_e2180.y - _e2182.y);
                                                                            let _e2191 = (_e2180.z - _e2182.z);
                                                                            if (_e1336 == 0u) {
                                                                                phi_2400_ = vec3<f32>(_e2188, _e2191, _e2185);
                                                                            } else {
                                                                                if (_e1336 == 1u) {
                                                                                    phi_2399_ = vec3<f32>(_e2191, _e2185, _e2188);
                                                                                } else {
                                                                                    phi_2399_ = (_e2180 - _e2182);
                                                                                }
                                                                                let _e2198 = phi_2399_;
                                                                                phi_2400_ = _e2198;
                                                                            }
                                                                            let _e2200 = phi_2400_;
                                                                            let _e2207 = ((_e2178.y * _e2200.z) - (_e2178.z * _e2200.y));
                                                                            let _e2214 = ((_e2178.z * _e2200.x) - (_e2178.x * _e2200.z));
                                                                            let _e2221 = ((_e2178.x * _e2200.y) - (_e2178.y * _e2200.x));
                                                                            let _e2235 = (((1f / _e1344.z) * (((_e2207 * _e2156.x) + (_e2214 * _e2156.y)) + (_e2221 * _e2156.z))) / (((_e2207 * _e1347) + (_e2214 * _e1350)) + _e2221));
                                                                            if (_e2235 > _e153.tmin) {
                                                                                if (_e2235 < _e153.tmax) {
                                                                                    let _e2239 = triangles.member[(0u + _e1951)].v0_;
                                                                                    let _e2241 = triangles.member[(0u + _e1951)].v1_;
                                                                                    if (_e2239.x < _e2241.x) {
                                                                                        phi_2456_ = _e2239.x;
                                                                                    } else {
                                                                                        phi_2456_ = _e2241.x;
                                                                                    }
                                                                                    let _e2248 = phi_2456_;
                                                                                    if (_e2239.y < _e2241.y) {
                                                                                        phi_2465_ = _e2239.y;
                                                                                    } else {
                                                                                        phi_2465_ = _e2241.y;
                                                                                    }
                                                                                    let _e2255 = phi_2465_;
                                                                                    if (_e2239.z < _e2241.z) {
                                                                                        phi_2474_ = _e2239.z;
                                                                                    } else {
                                                                                        phi_2474_ = _e2241.z;
                                                                                    }
                                                                                    let _e2262 = phi_2474_;
                                                                                    let _e2264 = triangles.member[(0u + _e1951)].v2_;
                                                                                    if (_e2248 < _e2264.x) {
                                                                                        phi_2483_ = _e2248;
                                                                                    } else {
                                                                                        phi_2483_ = _e2264.x;
                                                                                    }
                                                                                    let _e2269 = phi_2483_;
                                                                                    if (_e2255 < _e2264.y) {
                                                                                        phi_2490_ = _e2255;
                                                                                    } else {
                                                                                        phi_2490_ = _e2264.y;
                                                                                    }
                                                                                    let _e2274 = phi_2490_;
                                                                                    if (_e2262 < _e2264.z) {
                                                                                        phi_2497_ = _e2262;
                                                                                    } else {
                                                                                        phi_2497_ = _e2264.z;
                                                                                    }
                                                                                    let _e2279 = phi_2497_;
                                                                                    let _e2281 = triangles.member[(0u + _e1951)].v0_;
                                                                                    let _e2283 = triangles.member[(0u + _e1951)].v1_;
                                                                                    if (_e2281.x > _e2283.x) {
                                                                                        phi_2510_ = _e2281.x;
                                                                                    } else {
                                                                                        phi_2510_ = _e2283.x;
                                                                                    }
                                                                                    let _e2290 = phi_2510_;
                                                                                    if (_e2281.y > _e2283.y) {
                                                                                        phi_2519_ = _e2281.y;
                                                                                    } else {
                                                                                        phi_2519_ = _e2283.y;
                                                                                    }
                                                                                    let _e2297 = phi_2519_;
                                                                                    if (_e2281.z > _e2283.z) {
                                                                                        phi_2528_ = _e2281.z;
                                                                                    } else {
                                                                                        phi_2528_ = _e2283.z;
                                                                                    }
                                                                                    let _e2304 = phi_2528_;
                                                                                    let _e2306 = triangles.member[(0u + _e1951)].v2_;
                                                                                    if (_e2290 > _e2306.x) {
                                                                                        phi_2537_ = _e2290;
                                                                                    } else {
                                                                                        phi_2537_ = _e2306.x;
                                                                                    }
                                                                                    let _e2311 = phi_2537_;
                                                                                    if (_e2297 > _e2306.y) {
                                                                                        phi_2544_ = _e2297;
                                                                                    } else {
                                                                                        phi_2544_ = _e2306.y;
                                                                                    }
                                                                                    let _e2316 = phi_2544_;
                                                                                    if (_e2304 > _e2306.z) {
                                                                                        phi_2551_ = _e2304;
                                                                                    } else {
                                                                                        phi_2551_ = _e2306.z;
                                                                                    }
                                                                                    let _e2321 = phi_2551_;
                                                                                    let _e2325 = ((_e2269 - _e1054) * _e1261);
                                                                                    let _e2326 = ((_e2274 - _e1067) * _e1271);
                                                                                    let _e2327 = ((_e2279 - _e1080) * _e1281);
                                                                                    let _e2331 = ((_e2311 - _e1054) * _e1261);
                                                                                    let _e2332 = ((_e2316 - _e1067) * _e1271);
                                                                                    let _e2333 = ((_e2321 - _e1080) * _e1281);
                                                                                    if (_e2325 < _e2331) {
                                                                                        phi_2568_ = _e2325;
                                                                                    } else {
                                                                                        phi_2568_ = _e2331;
                                                                                    }
                                                                                    let _e2336 = phi_2568_;
                                                                                    if (_e2326 < _e2332) {
                                                                                        phi_2573_ = _e2326;
                                                                                    } else {
                                                                                        phi_2573_ = _e2332;
                                                                                    }
                                                                                    let _e2339 = phi_2573_;
                                                                                    if (_e2327 < _e2333) {
                                                                                        phi_2578_ = _e2327;
                                                                                    } else {
                                                                                        phi_2578_ = _e2333;
                                                                                    }
                                                                                    let _e2342 = phi_2578_;
                                                                                    if (_e2325 > _e2331) {
                                                                                        phi_2586_ = _e2325;
                                                                                    } else {
                                                                                        phi_2586_ = _e2331;
                                                                                    }
                                                                                    let _e2348 = phi_2586_;
                                                                                    if (_e2326 > _e2332) {
                                                                                        phi_2591_ = _e2326;
                                                                                    } else {
                                                                                        phi_2591_ = _e2332;
                                                                                    }
                                                                                    let _e2351 = phi_2591_;
                                                                                    if (_e2327 > _e2333) {
                                                                                        phi_2596_ = _e2327;
                                                                                    } else {
                                                                                        phi_2596_ = _e2333;
                                                                                    }
                                                                                    let _e2354 = phi_2596_;
                                                                                    let _e2358 = core_intrinsics_maximum_number_nsz_f32_((_e2336 - _e1320), (_e2339 - _e1321));
                                                                                    let _e2359 = core_intrinsics_maximum_number_nsz_f32_(_e2358, (_e2342 - _e1322));
                                                                                    let _e2360 = core_intrinsics_minimum_number_nsz_f32_((_e2348 + _e1320), (_e2351 + _e1321));
                                                                                    let _e2361 = core_intrinsics_minimum_number_nsz_f32_(_e2360, (_e2354 + _e1322));
                                                                                    if (_e2359 > _e1029) {
                                                                                        phi_2608_ = _e2359;
                                                                                    } else {
                                                                                        phi_2608_ = _e1029;
                                                                                    }
                                                                                    let _e2364 = phi_2608_;
                                                                                    if (_e2361 < _e1031) {
                                                                                        phi_2613_ = _e2361;
                                                                                    } else {
                                                                                        phi_2613_ = _e1031;
                                                                                    }
                                                                                    let _e2367 = phi_2613_;
                                                                                    if (_e2235 < _e2364) {
                                                                                        phi_2618_ = _e2364;
                                                                                    } else {
                                                                                        phi_2618_ = _e2235;
                                                                                    }
                                                                                    let _e2370 = phi_2618_;
                                                                                    if (_e2370 > _e2367) {
                                                                                        phi_2623_ = _e2367;
                                                                                    } else {
                                                                                        phi_2623_ = _e2370;
                                                                                    }
                                                                                    let _e2373 = phi_2623_;
                                                                                    phi_2628_ = lt_bvh_triangle_Intersection(_e2373, (_e2076 / _e2135), (_e2097 / _e2135), (_e2364 <= _e2367));
                                                                                    phi_2629_ = false;
                                                                                } else {
                                                                                    phi_2628_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2629_ = true;
                                                                                }
                                                                                let _e2379 = phi_2628_;
                                                                                let _e2381 = phi_2629_;
                                                                                phi_2630_ = _e2379;
                                                                                phi_2631_ = _e2381;
                                                                            } else {
                                                                                phi_2630_ = lt_bvh_triangle_Intersection();
                                                                                phi_2631_ = true;
                                                                            }
                                                                            let _e2383 = phi_2630_;
                                                                            let _e2385 = phi_2631_;
                                                                            if _e2385 {
                                                                            }
                                                                            phi_2635_ = _e2383;
                                                                            phi_2636_ = _e2385;
                                                                        }
                                                                        let _e2387 = phi_2635_;
                                                                        let _e2389 = phi_2636_;
                                                                        phi_2637_ = _e2387;
                                                                        phi_2638_ = _e2138;
                                                                        phi_2639_ = _e2389;
                                                                    } else {
                                                                        phi_2637_ = lt_bvh_triangle_Intersection();
                                                                        phi_2638_ = true;
                                                                        phi_2639_ = false;
                                                                    }
                                                                    let _e2391 = phi_2637_;
                                                                    let _e2393 = phi_2638_;
                                                                    let _e2395 = phi_2639_;
                                                                    if _e2393 {
                                                                        phi_2643_ = true;
                                                                    } else {
                                                                        phi_2643_ = _e2395;
                                                                    }
                                                                    let _e2397 = phi_2643_;
                                                                    if _e2397 {
                                                                        phi_2647_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2647_ = _e2391;
                                                                    }
                                                                    let _e2399 = phi_2647_;
                                                                    if _e2399.is_hit {
                                                                        if (_e2399.t > _e153.tmin) {
                                                                            if (_e2399.t < _e1940.t) {
                                                                                phi_2695_ = true;
                                                                            } else {
                                                                                if (_e2399.t == _e1940.t) {
                                                                                    if (_e1940.triangle != 4294967295u) {
                                                                                        if (_e1951 < _e1940.triangle) {
                                                                                            phi_2686_ = true;
                                                                                        } else {
                                                                                            if (_e1951 == _e1940.triangle) {
                                                                                                phi_2685_ = (_e970 < _e1940.instance);
                                                                                            } else {
                                                                                                phi_2685_ = false;
                                                                                            }
                                                                                            let _e2417 = phi_2685_;
                                                                                            phi_2686_ = _e2417;
                                                                                        }
                                                                                        let _e2419 = phi_2686_;
                                                                                        phi_2687_ = _e2419;
                                                                                        phi_2688_ = false;
                                                                                    } else {
                                                                                        phi_2687_ = bool();
                                                                                        phi_2688_ = true;
                                                                                    }
                                                                                    let _e2421 = phi_2687_;
                                                                                    let _e2423 = phi_2688_;
                                                                                    phi_2689_ = _e2421;
                                                                                    phi_2690_ = _e2423;
                                                                                } else {
                                                                                    phi_2689_ = bool();
                                                                                    phi_2690_ = true;
                                                                                }
                                                                                let _e2425 = phi_2689_;
                                                                                let _e2427 = phi_2690_;
                                                                                if _e2427 {
                                                                                    phi_2694_ = false;
                                                                                } else {
                                                                                    phi_2694_ = _e2425;
                                                                                }
                                                                                let _e2429 = phi_2694_;
                                                                                phi_2695_ = _e2429;
                                                                            }
                                                                            let _e2431 = phi_2695_;
                                                                            if _e2431 {
                                                                                let _e2433 = triangles.member[(0u + _e1951)].i0_;
                                                                                if ((_e2433 & 2147483648u) == 0u) {
                                                                                    phi_2709_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2709_ = true;
                                                                                }
                                                                                let _e2437 = phi_2709_;
                                                                                if _e2437 {
                                                                                    phi_2717_ = lt_bvh_Hit(_e2399.t, _e2399.u, _e2399.v, _e1951, _e970);
                                                                                } else {
                                                                                    phi_2717_ = _e1940;
                                                                                }
                                                                                let _e2443 = phi_2717_;
                                                                                phi_2718_ = _e2443;
                                                                            } else {
                                                                                phi_2718_ = _e1940;
                                                                            }
                                                                            let _e2445 = phi_2718_;
                                                                            phi_2719_ = _e2445;
                                                                        } else {
                                                                            phi_2719_ = _e1940;
                                                                        }
                                                                        let _e2447 = phi_2719_;
                                                                        phi_2720_ = _e2447;
                                                                    } else {
                                                                        phi_2720_ = _e1940;
                                                                    }
                                                                    let _e2449 = phi_2720_;
                                                                    phi_2077_ = _e2449;
                                                                    phi_2080_ = (_e1942 & (_e1942 - 1u));
                                                                    phi_2721_ = true;
                                                                }
                                                                let _e2451 = phi_2077_;
                                                                let _e2453 = phi_2080_;
                                                                let _e2455 = phi_2721_;
                                                                continue;
                                                                continuing {
                                                                    phi_2076_ = _e2451;
                                                                    phi_2079_ = _e2453;
                                                                    break if !(_e2455);
                                                                }
                                                            }
                                                            let _e2458 = local.group_mask;
                                                            if ((_e2458 & 4278190080u) == 0u) {
                                                                let _e2462 = local.len;
                                                                if (_e2462 == 0u) {
                                                                    phi_2760_ = false;
                                                                } else {
                                                                    let _e2466 = local.len;
                                                                    local.len = (_e2466 - 1u);
                                                                    let _e2469 = local.len;
                                                                    if (_e2469 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2474 = local.first[(0u + _e2469)];
                                                                    local.group = _e2474;
                                                                    let _e2477 = local.len;
                                                                    if (_e2477 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2482 = local.mask[(0u + _e2477)];
                                                                    local.group_mask = _e2482;
                                                                    phi_2760_ = true;
                                                                }
                                                                let _e2485 = phi_2760_;
                                                                phi_2761_ = _e2485;
                                                            } else {
                                                                phi_2761_ = true;
                                                            }
                                                            let _e2487 = phi_2761_;
                                                            if _e2487 {
                                                                let _e2489 = local.group_mask;
                                                                let _e2495 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2489)), 32u, (_e2489 == 0u)));
                                                                let _e2499 = local.group_mask;
                                                                let _e2513 = local.group_mask;
                                                                local.group_mask = (_e2513 & ~((1u << bitcast<u32>((_e2495 & 31u)))));
                                                                let _e2516 = local.group;
                                                                phi_2792_ = (_e2516 + countOneBits(((_e2499 & ~((4294967295u << bitcast<u32>((((_e2495 - 24u) ^ _e1363) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2792_ = 4294967295u;
                                                            }
                                                            let _e2519 = phi_2792_;
                                                            let _e3694 = local_8;
                                                            phi_1744_ = _e3694;
                                                            phi_1747_ = _e2519;
                                                        } else {
                                                            phi_1744_ = lt_bvh_Hit();
                                                            phi_1747_ = u32();
                                                        }
                                                        let _e2521 = phi_1744_;
                                                        let _e2523 = phi_1747_;
                                                        continue;
                                                        continuing {
                                                            phi_1743_ = _e2521;
                                                            phi_1746_ = _e2523;
                                                            break if !(_e1504);
                                                        }
                                                    }
                                                    let _e3698 = local_9;
                                                    phi_2793_ = _e3698;
                                                }
                                                let _e2526 = phi_2793_;
                                                phi_2794_ = _e2526;
                                                phi_2795_ = _e1185;
                                            } else {
                                                phi_2794_ = lt_bvh_Hit();
                                                phi_2795_ = true;
                                            }
                                            let _e2528 = phi_2794_;
                                            let _e2530 = phi_2795_;
                                            if _e2530 {
                                                phi_2799_ = _e962;
                                            } else {
                                                phi_2799_ = _e2528;
                                            }
                                            let _e2532 = phi_2799_;
                                            phi_2800_ = _e2532;
                                        } else {
                                            phi_2800_ = _e962;
                                        }
                                        let _e2534 = phi_2800_;
                                        phi_2801_ = _e2534;
                                    } else {
                                        phi_2801_ = _e962;
                                    }
                                    let _e2536 = phi_2801_;
                                    phi_2802_ = _e2536;
                                } else {
                                    phi_2802_ = _e962;
                                }
                                let _e2538 = phi_2802_;
                                phi_1111_ = (_e960 & (_e960 - 1u));
                                phi_1114_ = _e2538;
                                phi_2803_ = true;
                            }
                            let _e2540 = phi_1111_;
                            let _e2542 = phi_1114_;
                            let _e2544 = phi_2803_;
                            continue;
                            continuing {
                                phi_1110_ = _e2540;
                                phi_1113_ = _e2542;
                                break if !(_e2544);
                            }
                        }
                        let _e2547 = local_1.group_mask;
                        if ((_e2547 & 4278190080u) == 0u) {
                            let _e2551 = local_1.len;
                            if (_e2551 == 0u) {
                                phi_2842_ = false;
                            } else {
                                let _e2555 = local_1.len;
                                local_1.len = (_e2555 - 1u);
                                let _e2558 = local_1.len;
                                if (_e2558 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2563 = local_1.first[(0u + _e2558)];
                                local_1.group = _e2563;
                                let _e2566 = local_1.len;
                                if (_e2566 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2571 = local_1.mask[(0u + _e2566)];
                                local_1.group_mask = _e2571;
                                phi_2842_ = true;
                            }
                            let _e2574 = phi_2842_;
                            phi_2843_ = _e2574;
                        } else {
                            phi_2843_ = true;
                        }
                        let _e2576 = phi_2843_;
                        if _e2576 {
                            let _e2578 = local_1.group_mask;
                            let _e2584 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2578)), 32u, (_e2578 == 0u)));
                            let _e2588 = local_1.group_mask;
                            let _e2602 = local_1.group_mask;
                            local_1.group_mask = (_e2602 & ~((1u << bitcast<u32>((_e2584 & 31u)))));
                            let _e2605 = local_1.group;
                            phi_2874_ = (_e2605 + countOneBits(((_e2588 & ~((4294967295u << bitcast<u32>((((_e2584 - 24u) ^ _e379) & 31u))))) & 255u)));
                        } else {
                            phi_2874_ = 4294967295u;
                        }
                        let _e2608 = phi_2874_;
                        phi_774_ = _e2608;
                        let _e3714 = local_10;
                        phi_777_ = _e3714;
                    } else {
                        phi_774_ = u32();
                        phi_777_ = lt_bvh_Hit();
                    }
                    let _e2610 = phi_774_;
                    let _e2612 = phi_777_;
                    continue;
                    continuing {
                        phi_773_ = _e2610;
                        phi_776_ = _e2612;
                        break if !(_e520);
                    }
                }
                let _e3717 = local_11;
                phi_2875_ = _e3717;
            }
            let _e2615 = phi_2875_;
            phi_2876_ = _e2615;
            phi_2877_ = _e217;
        } else {
            phi_2876_ = lt_bvh_Hit();
            phi_2877_ = true;
        }
        let _e2617 = phi_2876_;
        let _e2619 = phi_2877_;
        if _e2619 {
            phi_2881_ = _e155;
        } else {
            phi_2881_ = _e2617;
        }
        let _e2621 = phi_2881_;
        if (_e2621.triangle != 4294967295u) {
            let _e2627 = ((1f - _e2621.u) - _e2621.v);
            if (_e2621.triangle < _e72) {
            } else {
                return;
            }
            let _e2633 = triangles.member[(0u + _e2621.triangle)];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e2644 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e2655 = ((((_e2644.x * _e2633.v0_.x) + (_e2644.y * _e2633.v0_.y)) + (_e2644.z * _e2633.v0_.z)) + (_e2644.w * 1f));
            let _e2657 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e2668 = ((((_e2657.x * _e2633.v0_.x) + (_e2657.y * _e2633.v0_.y)) + (_e2657.z * _e2633.v0_.z)) + (_e2657.w * 1f));
            let _e2670 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            let _e2681 = ((((_e2670.x * _e2633.v0_.x) + (_e2670.y * _e2633.v0_.y)) + (_e2670.z * _e2633.v0_.z)) + (_e2670.w * 1f));
            let _e2688 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e2699 = ((((_e2688.x * _e2633.v1_.x) + (_e2688.y * _e2633.v1_.y)) + (_e2688.z * _e2633.v1_.z)) + (_e2688.w * 1f));
            let _e2701 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e2712 = ((((_e2701.x * _e2633.v1_.x) + (_e2701.y * _e2633.v1_.y)) + (_e2701.z * _e2633.v1_.z)) + (_e2701.w * 1f));
            let _e2714 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            let _e2725 = ((((_e2714.x * _e2633.v1_.x) + (_e2714.y * _e2633.v1_.y)) + (_e2714.z * _e2633.v1_.z)) + (_e2714.w * 1f));
            let _e2732 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e2743 = ((((_e2732.x * _e2633.v2_.x) + (_e2732.y * _e2633.v2_.y)) + (_e2732.z * _e2633.v2_.z)) + (_e2732.w * 1f));
            let _e2745 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e2756 = ((((_e2745.x * _e2633.v2_.x) + (_e2745.y * _e2633.v2_.y)) + (_e2745.z * _e2633.v2_.z)) + (_e2745.w * 1f));
            let _e2758 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            let _e2769 = ((((_e2758.x * _e2633.v2_.x) + (_e2758.y * _e2633.v2_.y)) + (_e2758.z * _e2633.v2_.z)) + (_e2758.w * 1f));
            let _e2782 = (((_e2655 * _e2627) + (_e2699 * _e2621.u)) + (_e2743 * _e2621.v));
            let _e2783 = (((_e2668 * _e2627) + (_e2712 * _e2621.u)) + (_e2756 * _e2621.v));
            let _e2784 = (((_e2681 * _e2627) + (_e2725 * _e2621.u)) + (_e2769 * _e2621.v));
            let _e2786 = abs(_e2655);
            let _e2787 = abs(_e2668);
            let _e2788 = abs(_e2681);
            let _e2789 = abs(_e2699);
            let _e2790 = abs(_e2712);
            let _e2791 = abs(_e2725);
            if (_e2786 > _e2789) {
                phi_3069_ = _e2786;
            } else {
                phi_3069_ = _e2789;
            }
            let _e2794 = phi_3069_;
            if (_e2787 > _e2790) {
                phi_3074_ = _e2787;
            } else {
                phi_3074_ = _e2790;
            }
            let _e2797 = phi_3074_;
            if (_e2788 > _e2791) {
                phi_3079_ = _e2788;
            } else {
                phi_3079_ = _e2791;
            }
            let _e2800 = phi_3079_;
            let _e2801 = abs(_e2743);
            let _e2802 = abs(_e2756);
            let _e2803 = abs(_e2769);
            if (_e2794 > _e2801) {
                phi_3087_ = _e2794;
            } else {
                phi_3087_ = _e2801;
            }
            let _e2806 = phi_3087_;
            if (_e2797 > _e2802) {
                phi_3092_ = _e2797;
            } else {
                phi_3092_ = _e2802;
            }
            let _e2809 = phi_3092_;
            if (_e2800 > _e2803) {
                phi_3097_ = _e2800;
            } else {
                phi_3097_ = _e2803;
            }
            let _e2812 = phi_3097_;
            let _e2813 = (_e2699 - _e2655);
            let _e2814 = (_e2712 - _e2668);
            let _e2815 = (_e2725 - _e2681);
            let _e2816 = (_e2743 - _e2655);
            let _e2817 = (_e2756 - _e2668);
            let _e2818 = (_e2769 - _e2681);
            let _e2822 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2814), abs(_e2815));
            let _e2823 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2813), _e2822);
            let _e2824 = (_e2813 / _e2823);
            let _e2825 = (_e2814 / _e2823);
            let _e2826 = (_e2815 / _e2823);
            let _e2830 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2817), abs(_e2818));
            let _e2831 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2816), _e2830);
            let _e2832 = (_e2816 / _e2831);
            let _e2833 = (_e2817 / _e2831);
            let _e2834 = (_e2818 / _e2831);
            let _e2837 = ((_e2825 * _e2834) - (_e2833 * _e2826));
            let _e2840 = ((_e2826 * _e2832) - (_e2834 * _e2824));
            let _e2843 = ((_e2824 * _e2833) - (_e2832 * _e2825));
            let _e2845 = p.member.eye;
            let _e2858 = (1f / sqrt((((_e2837 * _e2837) + (_e2840 * _e2840)) + (_e2843 * _e2843))));
            let _e2859 = (_e2837 * _e2858);
            let _e2860 = (_e2840 * _e2858);
            let _e2861 = (_e2843 * _e2858);
            if ((((_e2859 * (_e2845.x - _e2782)) + (_e2860 * (_e2845.y - _e2783))) + (_e2861 * (_e2845.z - _e2784))) < 0f) {
                phi_3161_ = vec3<f32>(-(_e2859), -(_e2860), -(_e2861));
            } else {
                phi_3161_ = vec3<f32>(_e2859, _e2860, _e2861);
            }
            let _e2874 = phi_3161_;
            if (_e2621.triangle < _e72) {
            } else {
                return;
            }
            let _e2879 = triangles.member[(0u + _e2621.triangle)];
            let _e2881 = (_e2879.i0_ & 2147483647u);
            if (_e2881 < _e75) {
            } else {
                return;
            }
            let _e2887 = vertices.member[(0u + _e2881)];
            if (_e2879.i1_ < _e75) {
            } else {
                return;
            }
            let _e2891 = vertices.member[(0u + _e2879.i1_)];
            if (_e2879.i2_ < _e75) {
            } else {
                return;
            }
            let _e2895 = vertices.member[(0u + _e2879.i2_)];
            let _e2896 = array<abi_Vertex, 3>(_e2887, _e2891, _e2895);
            if (_e2896[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2902 = materials.member[(0u + _e2896[0].material)];
            let _e2919 = (1f / 255f);
            let _e2938 = (1f / 255f);
            let _e2960 = (1f / 255f);
            let _e2973 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2627, _e2621.u, _e2621.v));
            let _e2975 = ((_e2902.base_color.x * ((((f32((_e2896[0].color & 255u)) * _e2919) * _e2627) + ((f32((_e2896[1].color & 255u)) * _e2938) * _e2621.u)) + ((f32((_e2896[2].color & 255u)) * _e2960) * _e2621.v))) * _e2973.x);
            let _e2977 = ((_e2902.base_color.y * ((((f32(((_e2896[0].color >> bitcast<u32>(8i)) & 255u)) * _e2919) * _e2627) + ((f32(((_e2896[1].color >> bitcast<u32>(8i)) & 255u)) * _e2938) * _e2621.u)) + ((f32(((_e2896[2].color >> bitcast<u32>(8i)) & 255u)) * _e2960) * _e2621.v))) * _e2973.y);
            let _e2979 = ((_e2902.base_color.z * ((((f32(((_e2896[0].color >> bitcast<u32>(16i)) & 255u)) * _e2919) * _e2627) + ((f32(((_e2896[1].color >> bitcast<u32>(16i)) & 255u)) * _e2938) * _e2621.u)) + ((f32(((_e2896[2].color >> bitcast<u32>(16i)) & 255u)) * _e2960) * _e2621.v))) * _e2973.z);
            let _e2980 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2809, _e2812);
            let _e2981 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2806, _e2980);
            if ((_e2902.flags & 2u) == 0u) {
                phi_3282_ = 0u;
            } else {
                phi_3282_ = 1u;
            }
            let _e2986 = phi_3282_;
            if (_e2896[0].normal == 2147516416u) {
                phi_3512_ = _e2874;
            } else {
                let _e2999 = (f32((bitcast<i32>((_e2896[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3005 = (f32((bitcast<i32>(_e2896[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3009 = ((1f - abs(_e2999)) - abs(_e3005));
                if (_e3009 < 0f) {
                    phi_3309_ = -(_e3009);
                } else {
                    phi_3309_ = 0f;
                }
                let _e3013 = phi_3309_;
                if (_e2999 < 0f) {
                    phi_3316_ = (_e2999 + _e3013);
                } else {
                    phi_3316_ = (_e2999 - _e3013);
                }
                let _e3018 = phi_3316_;
                if (_e3005 < 0f) {
                    phi_3323_ = (_e3005 + _e3013);
                } else {
                    phi_3323_ = (_e3005 - _e3013);
                }
                let _e3023 = phi_3323_;
                let _e3030 = (1f / sqrt((((_e3018 * _e3018) + (_e3023 * _e3023)) + (_e3009 * _e3009))));
                let _e3046 = (f32((bitcast<i32>((_e2896[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3052 = (f32((bitcast<i32>(_e2896[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3056 = ((1f - abs(_e3046)) - abs(_e3052));
                if (_e3056 < 0f) {
                    phi_3358_ = -(_e3056);
                } else {
                    phi_3358_ = 0f;
                }
                let _e3060 = phi_3358_;
                if (_e3046 < 0f) {
                    phi_3365_ = (_e3046 + _e3060);
                } else {
                    phi_3365_ = (_e3046 - _e3060);
                }
                let _e3065 = phi_3365_;
                if (_e3052 < 0f) {
                    phi_3372_ = (_e3052 + _e3060);
                } else {
                    phi_3372_ = (_e3052 - _e3060);
                }
                let _e3070 = phi_3372_;
                let _e3077 = (1f / sqrt((((_e3065 * _e3065) + (_e3070 * _e3070)) + (_e3056 * _e3056))));
                let _e3096 = (f32((bitcast<i32>((_e2896[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3102 = (f32((bitcast<i32>(_e2896[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3106 = ((1f - abs(_e3096)) - abs(_e3102));
                if (_e3106 < 0f) {
                    phi_3410_ = -(_e3106);
                } else {
                    phi_3410_ = 0f;
                }
                let _e3110 = phi_3410_;
                if (_e3096 < 0f) {
                    phi_3417_ = (_e3096 + _e3110);
                } else {
                    phi_3417_ = (_e3096 - _e3110);
                }
                let _e3115 = phi_3417_;
                if (_e3102 < 0f) {
                    phi_3424_ = (_e3102 + _e3110);
                } else {
                    phi_3424_ = (_e3102 - _e3110);
                }
                let _e3120 = phi_3424_;
                let _e3127 = (1f / sqrt((((_e3115 * _e3115) + (_e3120 * _e3120)) + (_e3106 * _e3106))));
                let _e3134 = ((((_e3018 * _e3030) * _e2627) + ((_e3065 * _e3077) * _e2621.u)) + ((_e3115 * _e3127) * _e2621.v));
                let _e3135 = ((((_e3023 * _e3030) * _e2627) + ((_e3070 * _e3077) * _e2621.u)) + ((_e3120 * _e3127) * _e2621.v));
                let _e3136 = ((((_e3009 * _e3030) * _e2627) + ((_e3056 * _e3077) * _e2621.u)) + ((_e3106 * _e3127) * _e2621.v));
                if (_e2621.instance < _e84) {
                } else {
                    return;
                }
                let _e3143 = instances.member[(0u + _e2621.instance)].world_to_object[0u];
                let _e3152 = instances.member[(0u + _e2621.instance)].world_to_object[1u];
                let _e3164 = instances.member[(0u + _e2621.instance)].world_to_object[2u];
                let _e3171 = (((_e3143.x * _e3134) + (_e3152.x * _e3135)) + (_e3164.x * _e3136));
                let _e3172 = (((_e3143.y * _e3134) + (_e3152.y * _e3135)) + (_e3164.y * _e3136));
                let _e3173 = (((_e3143.z * _e3134) + (_e3152.z * _e3135)) + (_e3164.z * _e3136));
                let _e3179 = sqrt((((_e3171 * _e3171) + (_e3172 * _e3172)) + (_e3173 * _e3173)));
                if (_e3179 > 0f) {
                    let _e3181 = (_e3171 / _e3179);
                    let _e3182 = (_e3172 / _e3179);
                    let _e3183 = (_e3173 / _e3179);
                    if ((((_e3181 * _e2874.x) + (_e3182 * _e2874.y)) + (_e3183 * _e2874.z)) < 0f) {
                        phi_3510_ = vec3<f32>(-(_e3181), -(_e3182), -(_e3183));
                    } else {
                        phi_3510_ = vec3<f32>(_e3181, _e3182, _e3183);
                    }
                    let _e3199 = phi_3510_;
                    phi_3511_ = _e3199;
                } else {
                    phi_3511_ = _e2874;
                }
                let _e3201 = phi_3511_;
                phi_3512_ = _e3201;
            }
            let _e3203 = phi_3512_;
            if (_e2975 > 0f) {
                if (_e2975 < 1f) {
                    phi_3521_ = _e2975;
                } else {
                    phi_3521_ = 1f;
                }
                let _e3207 = phi_3521_;
                phi_3522_ = _e3207;
            } else {
                phi_3522_ = 0f;
            }
            let _e3209 = phi_3522_;
            if (_e2977 > 0f) {
                if (_e2977 < 1f) {
                    phi_3532_ = _e2977;
                } else {
                    phi_3532_ = 1f;
                }
                let _e3214 = phi_3532_;
                phi_3533_ = _e3214;
            } else {
                phi_3533_ = 0f;
            }
            let _e3216 = phi_3533_;
            if (_e2979 > 0f) {
                if (_e2979 < 1f) {
                    phi_3543_ = _e2979;
                } else {
                    phi_3543_ = 1f;
                }
                let _e3221 = phi_3543_;
                phi_3544_ = _e3221;
            } else {
                phi_3544_ = 0f;
            }
            let _e3223 = phi_3544_;
            let _e3226 = ((sqrt(_e3209) * 255f) + 0.5f);
            let _e3235 = ((sqrt(_e3216) * 255f) + 0.5f);
            let _e3247 = ((sqrt(_e3223) * 255f) + 0.5f);
            phi_3579_ = abi_Sample(vec3<f32>(_e2782, _e2783, _e2784), _e2981, _e2874, _e2986, _e3203, ((select(select(u32(_e3226), 0u, (_e3226 < bitcast<f32>(0u))), 4294967295u, (_e3226 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3235), 0u, (_e3235 < bitcast<f32>(0u))), 4294967295u, (_e3235 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3247), 0u, (_e3247 < bitcast<f32>(0u))), 4294967295u, (_e3247 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3579_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3261 = phi_3579_;
        if (_e96.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e96.shift)] = _e3261;
        if (_e2621.triangle != 4294967295u) {
            let _e3270 = ((1f - _e2621.u) - _e2621.v);
            if (_e2621.triangle < _e72) {
            } else {
                return;
            }
            let _e3275 = triangles.member[(0u + _e2621.triangle)];
            let _e3277 = (_e3275.i0_ & 2147483647u);
            if (_e3277 < _e87) {
            } else {
                return;
            }
            let _e3283 = before.member[(0u + _e3277)];
            if (_e3275.i1_ < _e87) {
            } else {
                return;
            }
            let _e3287 = before.member[(0u + _e3275.i1_)];
            if (_e3275.i2_ < _e87) {
            } else {
                return;
            }
            let _e3291 = before.member[(0u + _e3275.i2_)];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e3301 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e3314 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e3327 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e3351 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e3364 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e3377 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            if (_e2621.instance < _e84) {
            } else {
                return;
            }
            let _e3404 = instances.member[(0u + _e2621.instance)].object_to_world[0u];
            let _e3417 = instances.member[(0u + _e2621.instance)].object_to_world[1u];
            let _e3430 = instances.member[(0u + _e2621.instance)].object_to_world[2u];
            phi_3802_ = vec3<f32>((((((((_e3301.x * _e3283.x) + (_e3301.y * _e3283.y)) + (_e3301.z * _e3283.z)) + (_e3301.w * 1f)) * _e3270) + (((((_e3351.x * _e3287.x) + (_e3351.y * _e3287.y)) + (_e3351.z * _e3287.z)) + (_e3351.w * 1f)) * _e2621.u)) + (((((_e3404.x * _e3291.x) + (_e3404.y * _e3291.y)) + (_e3404.z * _e3291.z)) + (_e3404.w * 1f)) * _e2621.v)), (((((((_e3314.x * _e3283.x) + (_e3314.y * _e3283.y)) + (_e3314.z * _e3283.z)) + (_e3314.w * 1f)) * _e3270) + (((((_e3364.x * _e3287.x) + (_e3364.y * _e3287.y)) + (_e3364.z * _e3287.z)) + (_e3364.w * 1f)) * _e2621.u)) + (((((_e3417.x * _e3291.x) + (_e3417.y * _e3291.y)) + (_e3417.z * _e3291.z)) + (_e3417.w * 1f)) * _e2621.v)), (((((((_e3327.x * _e3283.x) + (_e3327.y * _e3283.y)) + (_e3327.z * _e3283.z)) + (_e3327.w * 1f)) * _e3270) + (((((_e3377.x * _e3287.x) + (_e3377.y * _e3287.y)) + (_e3377.z * _e3287.z)) + (_e3377.w * 1f)) * _e2621.u)) + (((((_e3430.x * _e3291.x) + (_e3430.y * _e3291.y)) + (_e3430.z * _e3291.z)) + (_e3430.w * 1f)) * _e2621.v)));
        } else {
            phi_3802_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3450 = phi_3802_;
        if (_e96.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e96.shift)] = vec4<f32>(_e3450.x, _e3450.y, _e3450.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
