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

struct type_26 {
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

struct type_30 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_34 {
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

struct type_38 {
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

struct type_51 {
    member: array<lt_bvh_Instance>,
}

struct type_55 {
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
var<storage> vertices: type_34;
@group(0) @binding(4) 
var<storage> materials: type_38;
@group(0) @binding(0) 
var<uniform> p: type_55;
@group(0) @binding(1) 
var<storage> nodes: type_26;
@group(0) @binding(2) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_51;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_197_: lt_mask_LightPlace;
    var phi_198_: bool;
    var phi_199_: lt_mask_LightPlace;
    var phi_200_: bool;
    var phi_205_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_197_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_198_ = false;
        } else {
            phi_197_ = lt_mask_LightPlace();
            phi_198_ = true;
        }
        let _e74 = phi_197_;
        let _e76 = phi_198_;
        phi_199_ = _e74;
        phi_200_ = _e76;
    } else {
        phi_199_ = lt_mask_LightPlace();
        phi_200_ = true;
    }
    let _e78 = phi_199_;
    let _e80 = phi_200_;
    if _e80 {
        phi_205_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_205_ = _e78;
    }
    let _e85 = phi_205_;
    return lt_mask_LightPlace(_e85.word, _e85.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_220_: bool;
    var phi_224_: f32;

    if (param_3 != param_3) {
        phi_220_ = true;
    } else {
        let _e64 = (param_4 >= param_3);
        if _e64 {
        }
        phi_220_ = _e64;
    }
    let _e66 = phi_220_;
    if _e66 {
        phi_224_ = param_4;
    } else {
        phi_224_ = param_3;
    }
    let _e68 = phi_224_;
    return _e68;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_236_: bool;
    var phi_240_: f32;

    if (param_5 != param_5) {
        phi_236_ = true;
    } else {
        let _e64 = (param_6 <= param_5);
        if _e64 {
        }
        phi_236_ = _e64;
    }
    let _e66 = phi_236_;
    if _e66 {
        phi_240_ = param_6;
    } else {
        phi_240_ = param_5;
    }
    let _e68 = phi_240_;
    return _e68;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_252_: f32;

    if (param_9 > param_10) {
        phi_252_ = param_9;
    } else {
        phi_252_ = param_10;
    }
    let _e65 = phi_252_;
    return _e65;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_400_: bool;
    var phi_401_: bool;
    var phi_402_: bool;
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
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_419_: bool;
    var phi_420_: bool;
    var phi_421_: bool;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_427_: bool;
    var phi_431_: bool;
    var phi_506_: f32;
    var phi_513_: f32;
    var phi_521_: f32;
    var phi_528_: f32;
    var phi_536_: f32;
    var phi_543_: f32;
    var phi_568_: f32;
    var phi_573_: f32;
    var phi_578_: f32;
    var phi_600_: u32;
    var phi_605_: u32;
    var phi_610_: u32;
    var phi_724_: bool;
    var phi_725_: bool;
    var phi_756_: u32;
    var phi_758_: u32;
    var phi_761_: lt_bvh_Hit;
    var phi_846_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_873_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_900_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_906_: u32;
    var phi_909_: u32;
    var phi_923_: u32;
    var phi_933_: u32;
    var phi_943_: u32;
    var phi_961_: u32;
    var phi_971_: u32;
    var phi_981_: u32;
    var phi_1017_: u32;
    var phi_1030_: u32;
    var phi_1035_: u32;
    var phi_1036_: u32;
    var phi_1037_: u32;
    var phi_907_: u32;
    var phi_910_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1095_: u32;
    var phi_1098_: lt_bvh_Hit;
    var phi_1153_: f32;
    var phi_1158_: f32;
    var phi_1163_: f32;
    var phi_1171_: f32;
    var phi_1176_: f32;
    var phi_1181_: f32;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1339_: bool;
    var phi_1343_: bool;
    var phi_1344_: bool;
    var phi_1345_: bool;
    var phi_1346_: bool;
    var phi_1347_: bool;
    var phi_1348_: bool;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1353_: bool;
    var phi_1354_: bool;
    var phi_1355_: bool;
    var phi_1356_: bool;
    var phi_1357_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1364_: bool;
    var phi_1368_: bool;
    var phi_1438_: f32;
    var phi_1445_: f32;
    var phi_1452_: f32;
    var phi_1459_: f32;
    var phi_1466_: f32;
    var phi_1473_: f32;
    var phi_1490_: f32;
    var phi_1495_: f32;
    var phi_1500_: f32;
    var phi_1528_: bool;
    var phi_1529_: bool;
    var phi_1537_: u32;
    var phi_1538_: u32;
    var phi_1549_: vec3<f32>;
    var phi_1550_: vec3<f32>;
    var phi_1563_: u32;
    var phi_1568_: u32;
    var phi_1573_: u32;
    var phi_1687_: bool;
    var phi_1688_: bool;
    var phi_1719_: u32;
    var phi_1721_: lt_bvh_Hit;
    var phi_1724_: u32;
    var phi_1805_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1832_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1859_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1865_: u32;
    var phi_1868_: u32;
    var phi_1882_: u32;
    var phi_1892_: u32;
    var phi_1902_: u32;
    var phi_1920_: u32;
    var phi_1930_: u32;
    var phi_1940_: u32;
    var phi_1976_: u32;
    var phi_1989_: u32;
    var phi_1994_: u32;
    var phi_1995_: u32;
    var phi_1996_: u32;
    var phi_1866_: u32;
    var phi_1869_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2054_: lt_bvh_Hit;
    var phi_2057_: u32;
    var phi_2101_: vec3<f32>;
    var phi_2102_: vec3<f32>;
    var phi_2131_: vec3<f32>;
    var phi_2132_: vec3<f32>;
    var phi_2161_: vec3<f32>;
    var phi_2162_: vec3<f32>;
    var phi_2180_: bool;
    var phi_2181_: bool;
    var phi_2185_: f32;
    var phi_2186_: f32;
    var phi_2187_: f32;
    var phi_2188_: f32;
    var phi_2196_: f32;
    var phi_2206_: bool;
    var phi_2207_: bool;
    var phi_2211_: f32;
    var phi_2212_: f32;
    var phi_2213_: f32;
    var phi_2214_: f32;
    var phi_2222_: f32;
    var phi_2232_: bool;
    var phi_2233_: bool;
    var phi_2237_: f32;
    var phi_2238_: f32;
    var phi_2239_: f32;
    var phi_2240_: f32;
    var phi_2248_: f32;
    var phi_2263_: f32;
    var phi_2264_: bool;
    var phi_2265_: f32;
    var phi_2266_: bool;
    var phi_2267_: f32;
    var phi_2268_: bool;
    var phi_2286_: f32;
    var phi_2287_: bool;
    var phi_2288_: bool;
    var phi_2289_: f32;
    var phi_2290_: bool;
    var phi_2291_: bool;
    var phi_2295_: bool;
    var phi_2296_: f32;
    var phi_2297_: bool;
    var phi_2325_: vec3<f32>;
    var phi_2326_: vec3<f32>;
    var phi_2351_: vec3<f32>;
    var phi_2352_: vec3<f32>;
    var phi_2377_: vec3<f32>;
    var phi_2378_: vec3<f32>;
    var phi_2434_: f32;
    var phi_2443_: f32;
    var phi_2452_: f32;
    var phi_2461_: f32;
    var phi_2468_: f32;
    var phi_2475_: f32;
    var phi_2488_: f32;
    var phi_2497_: f32;
    var phi_2506_: f32;
    var phi_2515_: f32;
    var phi_2522_: f32;
    var phi_2529_: f32;
    var phi_2546_: f32;
    var phi_2551_: f32;
    var phi_2556_: f32;
    var phi_2564_: f32;
    var phi_2569_: f32;
    var phi_2574_: f32;
    var phi_2586_: f32;
    var phi_2591_: f32;
    var phi_2596_: f32;
    var phi_2601_: f32;
    var phi_2606_: lt_bvh_triangle_Intersection;
    var phi_2607_: bool;
    var phi_2608_: lt_bvh_triangle_Intersection;
    var phi_2609_: bool;
    var phi_2613_: lt_bvh_triangle_Intersection;
    var phi_2614_: bool;
    var phi_2615_: lt_bvh_triangle_Intersection;
    var phi_2616_: bool;
    var phi_2617_: bool;
    var phi_2621_: bool;
    var phi_2625_: lt_bvh_triangle_Intersection;
    var phi_2663_: bool;
    var phi_2664_: bool;
    var phi_2665_: bool;
    var phi_2666_: bool;
    var phi_2667_: bool;
    var phi_2668_: bool;
    var phi_2672_: bool;
    var phi_2673_: bool;
    var phi_2687_: bool;
    var phi_2695_: lt_bvh_Hit;
    var phi_2696_: lt_bvh_Hit;
    var phi_2697_: lt_bvh_Hit;
    var phi_2698_: lt_bvh_Hit;
    var phi_2055_: lt_bvh_Hit;
    var phi_2058_: u32;
    var phi_2699_: bool;
    var phi_2738_: bool;
    var phi_2739_: bool;
    var phi_2770_: u32;
    var phi_1722_: lt_bvh_Hit;
    var phi_1725_: u32;
    var phi_2771_: lt_bvh_Hit;
    var phi_2772_: lt_bvh_Hit;
    var phi_2773_: bool;
    var phi_2777_: lt_bvh_Hit;
    var phi_2778_: lt_bvh_Hit;
    var phi_2779_: lt_bvh_Hit;
    var phi_2780_: lt_bvh_Hit;
    var phi_1096_: u32;
    var phi_1099_: lt_bvh_Hit;
    var phi_2781_: bool;
    var phi_2820_: bool;
    var phi_2821_: bool;
    var phi_2852_: u32;
    var phi_759_: u32;
    var phi_762_: lt_bvh_Hit;
    var phi_2853_: lt_bvh_Hit;
    var phi_2854_: lt_bvh_Hit;
    var phi_2855_: bool;
    var phi_2859_: lt_bvh_Hit;
    var phi_3047_: f32;
    var phi_3052_: f32;
    var phi_3057_: f32;
    var phi_3065_: f32;
    var phi_3070_: f32;
    var phi_3075_: f32;
    var phi_3139_: vec3<f32>;
    var phi_3260_: u32;
    var phi_3287_: f32;
    var phi_3294_: f32;
    var phi_3301_: f32;
    var phi_3336_: f32;
    var phi_3343_: f32;
    var phi_3350_: f32;
    var phi_3388_: f32;
    var phi_3395_: f32;
    var phi_3402_: f32;
    var phi_3488_: vec3<f32>;
    var phi_3489_: vec3<f32>;
    var phi_3490_: vec3<f32>;
    var phi_3499_: f32;
    var phi_3500_: f32;
    var phi_3510_: f32;
    var phi_3511_: f32;
    var phi_3521_: f32;
    var phi_3522_: f32;
    var phi_3557_: abi_Sample;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;

    let _e63 = id_1;
    let _e67 = arrayLength((&nodes.member));
    let _e70 = arrayLength((&triangles.member));
    let _e73 = arrayLength((&vertices.member));
    let _e82 = arrayLength((&instances.member));
    let _e85 = p.member.size[0u];
    let _e87 = p.member.size[1u];
    let _e88 = lt_shaders_entry_pixel_index(_e63, _e85, _e87);
    if (bitcast<i32>(_e88.word) != 0i) {
        let _e94 = p.member.root;
        let _e98 = p.member.eye;
        let _e103 = p.member.size[0u];
        let _e107 = ((((f32(_e63.x) + 0.5f) / f32(_e103)) * 2f) - 1f);
        let _e112 = p.member.size[1u];
        let _e116 = (1f - (((f32(_e63.y) + 0.5f) / f32(_e112)) * 2f));
        let _e118 = p.member.forward;
        let _e120 = p.member.right;
        let _e134 = p.member.up;
        let _e145 = _lt_bvh_ray_Ray_new(_e98, vec3<f32>(((_e118.x + (_e120.x * _e107)) + (_e134.x * _e116)), ((_e118.y + (_e120.y * _e107)) + (_e134.y * _e116)), ((_e118.z + (_e120.z * _e107)) + (_e134.z * _e116))));
        let _e147 = lt_bvh_Hit(_e145.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e157 = abs(_e145.direction.x);
        let _e159 = abs(_e145.direction.y);
        let _e161 = abs(_e145.direction.z);
        if (abs(_e145.origin.x) < 1000000000000000f) {
            if (abs(_e145.origin.y) < 1000000000000000f) {
                if (abs(_e145.origin.z) < 1000000000000000f) {
                    if (_e157 < 1000000000000000f) {
                        if (_e159 < 1000000000000000f) {
                            if (_e161 < 1000000000000000f) {
                                if (_e157 > 0f) {
                                    phi_401_ = bool();
                                    phi_402_ = true;
                                } else {
                                    let _e169 = (_e159 > 0f);
                                    if _e169 {
                                        phi_400_ = bool();
                                    } else {
                                        phi_400_ = (_e161 > 0f);
                                    }
                                    let _e172 = phi_400_;
                                    phi_401_ = _e172;
                                    phi_402_ = _e169;
                                }
                                let _e174 = phi_401_;
                                let _e176 = phi_402_;
                                if _e176 {
                                    phi_406_ = true;
                                } else {
                                    phi_406_ = _e174;
                                }
                                let _e178 = phi_406_;
                                phi_407_ = _e178;
                                phi_408_ = false;
                            } else {
                                phi_407_ = bool();
                                phi_408_ = true;
                            }
                            let _e180 = phi_407_;
                            let _e182 = phi_408_;
                            phi_409_ = _e180;
                            phi_410_ = false;
                            phi_411_ = _e182;
                        } else {
                            phi_409_ = bool();
                            phi_410_ = true;
                            phi_411_ = false;
                        }
                        let _e184 = phi_409_;
                        let _e186 = phi_410_;
                        let _e188 = phi_411_;
                        phi_412_ = _e184;
                        phi_413_ = _e186;
                        phi_414_ = _e188;
                    } else {
                        phi_412_ = bool();
                        phi_413_ = true;
                        phi_414_ = false;
                    }
                    let _e190 = phi_412_;
                    let _e192 = phi_413_;
                    let _e194 = phi_414_;
                    phi_415_ = _e190;
                    phi_416_ = _e192;
                    phi_417_ = _e194;
                } else {
                    phi_415_ = bool();
                    phi_416_ = true;
                    phi_417_ = false;
                }
                let _e196 = phi_415_;
                let _e198 = phi_416_;
                let _e200 = phi_417_;
                phi_418_ = _e196;
                phi_419_ = _e198;
                phi_420_ = _e200;
            } else {
                phi_418_ = bool();
                phi_419_ = true;
                phi_420_ = false;
            }
            let _e202 = phi_418_;
            let _e204 = phi_419_;
            let _e206 = phi_420_;
            phi_421_ = _e202;
            phi_422_ = _e204;
            phi_423_ = _e206;
        } else {
            phi_421_ = bool();
            phi_422_ = true;
            phi_423_ = false;
        }
        let _e208 = phi_421_;
        let _e210 = phi_422_;
        let _e212 = phi_423_;
        if _e210 {
            phi_427_ = true;
        } else {
            phi_427_ = _e212;
        }
        let _e214 = phi_427_;
        if _e214 {
            phi_431_ = false;
        } else {
            phi_431_ = _e208;
        }
        let _e216 = phi_431_;
        if _e216 {
            let _e217 = (_e94 >= _e67);
            if _e217 {
                phi_2853_ = lt_bvh_Hit();
            } else {
                if (_e94 < _e67) {
                } else {
                    return;
                }
                let _e223 = nodes.member[(0u + _e94)].frame[0u];
                let _e227 = nodes.member[(0u + _e94)].frame[1u];
                let _e231 = nodes.member[(0u + _e94)].frame[2u];
                let _e235 = nodes.member[(0u + _e94)].frame[0u];
                let _e239 = nodes.member[(0u + _e94)].frame[1u];
                let _e243 = nodes.member[(0u + _e94)].frame[2u];
                let _e247 = nodes.member[(0u + _e94)].frame[3u];
                let _e285 = core_intrinsics_maximum_number_nsz_f32_(abs(_e145.direction.x), abs(_e145.direction.y));
                let _e286 = core_intrinsics_maximum_number_nsz_f32_(_e285, abs(_e145.direction.z));
                let _e287 = (_e286 * 0.0000000000009094947f);
                if (abs(_e145.direction.x) < _e287) {
                    phi_506_ = _e287;
                } else {
                    phi_506_ = abs(_e145.direction.x);
                }
                let _e293 = phi_506_;
                if (_e145.direction.x < 0f) {
                    phi_513_ = (-1f / _e293);
                } else {
                    phi_513_ = (1f / _e293);
                }
                let _e298 = phi_513_;
                if (abs(_e145.direction.y) < _e287) {
                    phi_521_ = _e287;
                } else {
                    phi_521_ = abs(_e145.direction.y);
                }
                let _e304 = phi_521_;
                if (_e145.direction.y < 0f) {
                    phi_528_ = (-1f / _e304);
                } else {
                    phi_528_ = (1f / _e304);
                }
                let _e309 = phi_528_;
                if (abs(_e145.direction.z) < _e287) {
                    phi_536_ = _e287;
                } else {
                    phi_536_ = abs(_e145.direction.z);
                }
                let _e315 = phi_536_;
                if (_e145.direction.z < 0f) {
                    phi_543_ = (-1f / _e315);
                } else {
                    phi_543_ = (1f / _e315);
                }
                let _e320 = phi_543_;
                let _e328 = abs((bitcast<f32>(_e223) - _e145.origin.x));
                let _e329 = abs((bitcast<f32>(_e227) - _e145.origin.y));
                let _e330 = abs((bitcast<f32>(_e231) - _e145.origin.z));
                let _e338 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e247 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.x));
                let _e339 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e247 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.y));
                let _e340 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e247 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.z));
                if (_e328 > _e338) {
                    phi_568_ = _e328;
                } else {
                    phi_568_ = _e338;
                }
                let _e343 = phi_568_;
                if (_e329 > _e339) {
                    phi_573_ = _e329;
                } else {
                    phi_573_ = _e339;
                }
                let _e346 = phi_573_;
                if (_e330 > _e340) {
                    phi_578_ = _e330;
                } else {
                    phi_578_ = _e340;
                }
                let _e349 = phi_578_;
                let _e350 = core_intrinsics_maximum_number_nsz_f32_(_e343, _e346);
                let _e351 = core_intrinsics_maximum_number_nsz_f32_(_e350, _e349);
                let _e356 = (_e351 * 0.0000019073486f);
                let _e357 = (abs(_e298) * _e356);
                let _e358 = (abs(_e309) * _e356);
                let _e359 = (abs(_e320) * _e356);
                let _e363 = (_e351 * 0.0000009536743f);
                let _e364 = (abs(_e298) * _e363);
                let _e365 = (abs(_e309) * _e363);
                let _e366 = (abs(_e320) * _e363);
                if (_e298 < 0f) {
                    phi_600_ = 0u;
                } else {
                    phi_600_ = 1u;
                }
                let _e369 = phi_600_;
                if (_e309 < 0f) {
                    phi_605_ = 0u;
                } else {
                    phi_605_ = 2u;
                }
                let _e372 = phi_605_;
                if (_e320 < 0f) {
                    phi_610_ = 0u;
                } else {
                    phi_610_ = 4u;
                }
                let _e375 = phi_610_;
                let _e377 = ((_e369 | _e372) | _e375);
                let _e378 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e94, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e378.first[0], _e378.first[1], _e378.first[2], _e378.first[3], _e378.first[4], _e378.first[5], _e378.first[6], _e378.first[7], _e378.first[8], _e378.first[9], _e378.first[10], _e378.first[11], _e378.first[12], _e378.first[13], _e378.first[14], _e378.first[15], _e378.first[16], _e378.first[17], _e378.first[18], _e378.first[19], _e378.first[20], _e378.first[21], _e378.first[22], _e378.first[23], _e378.first[24], _e378.first[25], _e378.first[26], _e378.first[27], _e378.first[28], _e378.first[29], _e378.first[30], _e378.first[31]), array<u32, 32>(_e378.mask[0], _e378.mask[1], _e378.mask[2], _e378.mask[3], _e378.mask[4], _e378.mask[5], _e378.mask[6], _e378.mask[7], _e378.mask[8], _e378.mask[9], _e378.mask[10], _e378.mask[11], _e378.mask[12], _e378.mask[13], _e378.mask[14], _e378.mask[15], _e378.mask[16], _e378.mask[17], _e378.mask[18], _e378.mask[19], _e378.mask[20], _e378.mask[21], _e378.mask[22], _e378.mask[23], _e378.mask[24], _e378.mask[25], _e378.mask[26], _e378.mask[27], _e378.mask[28], _e378.mask[29], _e378.mask[30], _e378.mask[31]), _e378.len, _e378.group, _e378.group_mask);
                let _e452 = local_1.group_mask;
                if ((_e452 & 4278190080u) == 0u) {
                    let _e456 = local_1.len;
                    if (_e456 == 0u) {
                        phi_724_ = false;
                    } else {
                        let _e460 = local_1.len;
                        local_1.len = (_e460 - 1u);
                        let _e463 = local_1.len;
                        if (_e463 < 32u) {
                        } else {
                            return;
                        }
                        let _e468 = local_1.first[(0u + _e463)];
                        local_1.group = _e468;
                        let _e471 = local_1.len;
                        if (_e471 < 32u) {
                        } else {
                            return;
                        }
                        let _e476 = local_1.mask[(0u + _e471)];
                        local_1.group_mask = _e476;
                        phi_724_ = true;
                    }
                    let _e479 = phi_724_;
                    phi_725_ = _e479;
                } else {
                    phi_725_ = true;
                }
                let _e481 = phi_725_;
                if _e481 {
                    let _e483 = local_1.group_mask;
                    let _e489 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e483)), 32u, (_e483 == 0u)));
                    let _e493 = local_1.group_mask;
                    let _e507 = local_1.group_mask;
                    local_1.group_mask = (_e507 & ~((1u << bitcast<u32>((_e489 & 31u)))));
                    let _e510 = local_1.group;
                    phi_756_ = (_e510 + countOneBits(((_e493 & ~((4294967295u << bitcast<u32>((((_e489 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_756_ = 4294967295u;
                }
                let _e513 = phi_756_;
                phi_758_ = _e513;
                phi_761_ = _e147;
                loop {
                    let _e515 = phi_758_;
                    let _e517 = phi_761_;
                    local_11 = _e517;
                    let _e518 = (_e515 != 4294967295u);
                    if _e518 {
                        if (_e515 < _e67) {
                        } else {
                            return;
                        }
                        let _e526 = nodes.member[(0u + _e515)].frame[3u];
                        let _e551 = (bitcast<f32>((((_e526 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e298);
                        let _e552 = (bitcast<f32>((((_e526 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e309);
                        let _e553 = (bitcast<f32>((((_e526 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e320);
                        let _e556 = nodes.member[(0u + _e515)].frame[0u];
                        let _e560 = nodes.member[(0u + _e515)].frame[1u];
                        let _e564 = nodes.member[(0u + _e515)].frame[2u];
                        let _e572 = ((bitcast<f32>(_e556) - _e145.origin.x) * _e298);
                        let _e573 = ((bitcast<f32>(_e560) - _e145.origin.y) * _e309);
                        let _e574 = ((bitcast<f32>(_e564) - _e145.origin.z) * _e320);
                        let _e582 = nodes.member[(0u + _e515)].x;
                        if (_e298 < 0f) {
                            let _e593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e582.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e593.unnamed.word, _e582.w), _e593.unnamed_1);
                            let _e605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e599.unnamed, lt_mask_LightPlace(_e582.x, _e599.unnamed_1.shift));
                            phi_846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e605.unnamed, lt_mask_LightPlace(_e605.unnamed_1.word, _e582.y));
                        } else {
                            let _e621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e582.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e621.unnamed.word, _e582.y), _e621.unnamed_1);
                            let _e633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e627.unnamed, lt_mask_LightPlace(_e582.z, _e627.unnamed_1.shift));
                            phi_846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e633.unnamed, lt_mask_LightPlace(_e633.unnamed_1.word, _e582.w));
                        }
                        let _e641 = phi_846_;
                        let _e651 = nodes.member[(0u + _e515)].y;
                        if (_e309 < 0f) {
                            let _e662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e651.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e662.unnamed.word, _e651.w), _e662.unnamed_1);
                            let _e674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e668.unnamed, lt_mask_LightPlace(_e651.x, _e668.unnamed_1.shift));
                            phi_873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e674.unnamed, lt_mask_LightPlace(_e674.unnamed_1.word, _e651.y));
                        } else {
                            let _e690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e651.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e690.unnamed.word, _e651.y), _e690.unnamed_1);
                            let _e702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e696.unnamed, lt_mask_LightPlace(_e651.z, _e696.unnamed_1.shift));
                            phi_873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e702.unnamed, lt_mask_LightPlace(_e702.unnamed_1.word, _e651.w));
                        }
                        let _e710 = phi_873_;
                        let _e720 = nodes.member[(0u + _e515)].z;
                        if (_e320 < 0f) {
                            let _e731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e720.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e731.unnamed.word, _e720.w), _e731.unnamed_1);
                            let _e743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e737.unnamed, lt_mask_LightPlace(_e720.x, _e737.unnamed_1.shift));
                            phi_900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e743.unnamed, lt_mask_LightPlace(_e743.unnamed_1.word, _e720.y));
                        } else {
                            let _e759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e720.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e759.unnamed.word, _e720.y), _e759.unnamed_1);
                            let _e771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e765.unnamed, lt_mask_LightPlace(_e720.z, _e765.unnamed_1.shift));
                            phi_900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e771.unnamed, lt_mask_LightPlace(_e771.unnamed_1.word, _e720.w));
                        }
                        let _e779 = phi_900_;
                        phi_906_ = 0u;
                        phi_909_ = 0u;
                        loop {
                            let _e789 = phi_906_;
                            let _e791 = phi_909_;
                            local_2 = _e791;
                            local_3 = _e791;
                            local_4 = _e791;
                            let _e792 = (_e789 < 8u);
                            if _e792 {
                                let _e794 = (_e789 >> bitcast<u32>(2i));
                                let _e795 = (_e789 & 3u);
                                if (_e794 == 0u) {
                                    phi_923_ = _e641.unnamed.word;
                                } else {
                                    phi_923_ = _e641.unnamed.shift;
                                }
                                let _e798 = phi_923_;
                                if (_e794 == 0u) {
                                    phi_933_ = _e710.unnamed.word;
                                } else {
                                    phi_933_ = _e710.unnamed.shift;
                                }
                                let _e807 = phi_933_;
                                if (_e794 == 0u) {
                                    phi_943_ = _e779.unnamed.word;
                                } else {
                                    phi_943_ = _e779.unnamed.shift;
                                }
                                let _e816 = phi_943_;
                                let _e829 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e798 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e551) + (_e572 - _e357)), ((f32(((_e807 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e552) + (_e573 - _e358)));
                                let _e830 = core_intrinsics_maximum_number_nsz_f32_(_e829, ((f32(((_e816 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e553) + (_e574 - _e359)));
                                if (_e794 == 0u) {
                                    phi_961_ = _e641.unnamed_1.word;
                                } else {
                                    phi_961_ = _e641.unnamed_1.shift;
                                }
                                let _e833 = phi_961_;
                                if (_e794 == 0u) {
                                    phi_971_ = _e710.unnamed_1.word;
                                } else {
                                    phi_971_ = _e710.unnamed_1.shift;
                                }
                                let _e842 = phi_971_;
                                if (_e794 == 0u) {
                                    phi_981_ = _e779.unnamed_1.word;
                                } else {
                                    phi_981_ = _e779.unnamed_1.shift;
                                }
                                let _e851 = phi_981_;
                                let _e864 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e833 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e551) + (_e572 + _e357)), ((f32(((_e842 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e552) + (_e573 + _e358)));
                                let _e865 = core_intrinsics_minimum_number_nsz_f32_(_e864, ((f32(((_e851 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u)) * _e553) + (_e574 + _e359)));
                                if (_e830 <= _e865) {
                                    if (_e830 <= _e517.t) {
                                        if (_e865 >= _e145.tmin) {
                                            if (_e794 == 0u) {
                                                let _e872 = nodes.member[(0u + _e515)].links[2u];
                                                phi_1017_ = _e872;
                                            } else {
                                                let _e875 = nodes.member[(0u + _e515)].links[3u];
                                                phi_1017_ = _e875;
                                            }
                                            let _e877 = phi_1017_;
                                            let _e882 = ((_e877 >> bitcast<u32>(((_e795 * 8u) & 31u))) & 255u);
                                            let _e883 = (_e882 & 31u);
                                            if (_e883 >= 24u) {
                                                phi_1030_ = (24u + ((_e883 - 24u) ^ _e377));
                                            } else {
                                                phi_1030_ = _e883;
                                            }
                                            let _e889 = phi_1030_;
                                            phi_1035_ = (_e791 | ((_e882 >> bitcast<u32>(5i)) << bitcast<u32>((_e889 & 31u))));
                                        } else {
                                            phi_1035_ = _e791;
                                        }
                                        let _e897 = phi_1035_;
                                        phi_1036_ = _e897;
                                    } else {
                                        phi_1036_ = _e791;
                                    }
                                    let _e899 = phi_1036_;
                                    phi_1037_ = _e899;
                                } else {
                                    phi_1037_ = _e791;
                                }
                                let _e901 = phi_1037_;
                                phi_907_ = (_e789 + 1u);
                                phi_910_ = _e901;
                            } else {
                                phi_907_ = u32();
                                phi_910_ = u32();
                            }
                            let _e904 = phi_907_;
                            let _e906 = phi_910_;
                            continue;
                            continuing {
                                phi_906_ = _e904;
                                phi_909_ = _e906;
                                break if !(_e792);
                            }
                        }
                        let _e910 = nodes.member[(0u + _e515)].links[0u];
                        let _e914 = nodes.member[(0u + _e515)].frame[3u];
                        let _e918 = local_2;
                        if ((_e918 & 4278190080u) == 0u) {
                        } else {
                            let _e922 = local_1.group_mask;
                            if ((_e922 & 4278190080u) == 0u) {
                            } else {
                                let _e926 = local_1.len;
                                if (_e926 < 32u) {
                                    let _e929 = local_1.group;
                                    let _e931 = local_1.len;
                                    if (_e931 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e931)] = _e929;
                                    let _e937 = local_1.group_mask;
                                    let _e939 = local_1.len;
                                    if (_e939 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e939)] = _e937;
                                    let _e946 = local_1.len;
                                    local_1.len = (_e946 + 1u);
                                }
                            }
                            local_1.group = (_e94 + _e910);
                            let _e950 = local_3;
                            local_1.group_mask = ((_e950 & 4278190080u) | (_e914 >> bitcast<u32>(24i)));
                        }
                        let _e955 = local_4;
                        phi_1095_ = (_e955 & 16777215u);
                        phi_1098_ = _e517;
                        loop {
                            let _e958 = phi_1095_;
                            let _e960 = phi_1098_;
                            local_10 = _e960;
                            if (_e958 == 0u) {
                                phi_1096_ = u32();
                                phi_1099_ = lt_bvh_Hit();
                                phi_2781_ = false;
                            } else {
                                let _e964 = nodes.member[(0u + _e515)].links[1u];
                                let _e968 = (_e964 + select(firstTrailingBit(_e958), 32u, (_e958 == 0u)));
                                if (_e968 < _e82) {
                                } else {
                                    return;
                                }
                                let _e975 = instances.member[(0u + _e968)].low_world;
                                let _e977 = instances.member[(0u + _e968)].high_world;
                                let _e987 = ((_e975.x - _e145.origin.x) * _e298);
                                let _e988 = ((_e975.y - _e145.origin.y) * _e309);
                                let _e989 = ((_e975.z - _e145.origin.z) * _e320);
                                let _e999 = ((_e977.x - _e145.origin.x) * _e298);
                                let _e1000 = ((_e977.y - _e145.origin.y) * _e309);
                                let _e1001 = ((_e977.z - _e145.origin.z) * _e320);
                                if (_e987 < _e999) {
                                    phi_1153_ = _e987;
                                } else {
                                    phi_1153_ = _e999;
                                }
                                let _e1004 = phi_1153_;
                                if (_e988 < _e1000) {
                                    phi_1158_ = _e988;
                                } else {
                                    phi_1158_ = _e1000;
                                }
                                let _e1007 = phi_1158_;
                                if (_e989 < _e1001) {
                                    phi_1163_ = _e989;
                                } else {
                                    phi_1163_ = _e1001;
                                }
                                let _e1010 = phi_1163_;
                                if (_e987 > _e999) {
                                    phi_1171_ = _e987;
                                } else {
                                    phi_1171_ = _e999;
                                }
                                let _e1016 = phi_1171_;
                                if (_e988 > _e1000) {
                                    phi_1176_ = _e988;
                                } else {
                                    phi_1176_ = _e1000;
                                }
                                let _e1019 = phi_1176_;
                                if (_e989 > _e1001) {
                                    phi_1181_ = _e989;
                                } else {
                                    phi_1181_ = _e1001;
                                }
                                let _e1022 = phi_1181_;
                                let _e1026 = core_intrinsics_maximum_number_nsz_f32_((_e1004 - _e364), (_e1007 - _e365));
                                let _e1027 = core_intrinsics_maximum_number_nsz_f32_(_e1026, (_e1010 - _e366));
                                let _e1028 = core_intrinsics_minimum_number_nsz_f32_((_e1016 + _e364), (_e1019 + _e365));
                                let _e1029 = core_intrinsics_minimum_number_nsz_f32_(_e1028, (_e1022 + _e366));
                                if (_e1027 <= _e1029) {
                                    if (_e1027 <= _e960.t) {
                                        if (_e1029 >= _e145.tmin) {
                                            let _e1041 = instances.member[(0u + _e968)].world_to_object[0u];
                                            let _e1052 = ((((_e1041.x * _e145.origin.x) + (_e1041.y * _e145.origin.y)) + (_e1041.z * _e145.origin.z)) + (_e1041.w * 1f));
                                            let _e1054 = instances.member[(0u + _e968)].world_to_object[1u];
                                            let _e1065 = ((((_e1054.x * _e145.origin.x) + (_e1054.y * _e145.origin.y)) + (_e1054.z * _e145.origin.z)) + (_e1054.w * 1f));
                                            let _e1067 = instances.member[(0u + _e968)].world_to_object[2u];
                                            let _e1078 = ((((_e1067.x * _e145.origin.x) + (_e1067.y * _e145.origin.y)) + (_e1067.z * _e145.origin.z)) + (_e1067.w * 1f));
                                            let _e1085 = instances.member[(0u + _e968)].world_to_object[0u];
                                            let _e1096 = ((((_e1085.x * _e145.direction.x) + (_e1085.y * _e145.direction.y)) + (_e1085.z * _e145.direction.z)) + (_e1085.w * 0f));
                                            let _e1098 = instances.member[(0u + _e968)].world_to_object[1u];
                                            let _e1109 = ((((_e1098.x * _e145.direction.x) + (_e1098.y * _e145.direction.y)) + (_e1098.z * _e145.direction.z)) + (_e1098.w * 0f));
                                            let _e1111 = instances.member[(0u + _e968)].world_to_object[2u];
                                            let _e1122 = ((((_e1111.x * _e145.direction.x) + (_e1111.y * _e145.direction.y)) + (_e1111.z * _e145.direction.z)) + (_e1111.w * 0f));
                                            let _e1127 = instances.member[(0u + _e968)].root;
                                            let _e1129 = instances.member[(0u + _e968)].first_triangle;
                                            let _e1133 = abs(_e1096);
                                            let _e1134 = abs(_e1109);
                                            let _e1135 = abs(_e1122);
                                            if (abs(_e1052) < 1000000000000000f) {
                                                if (abs(_e1065) < 1000000000000000f) {
                                                    if (abs(_e1078) < 1000000000000000f) {
                                                        if (_e1133 < 1000000000000000f) {
                                                            if (_e1134 < 1000000000000000f) {
                                                                if (_e1135 < 1000000000000000f) {
                                                                    if (_e1133 > 0f) {
                                                                        phi_1338_ = bool();
                                                                        phi_1339_ = true;
                                                                    } else {
                                                                        let _e1143 = (_e1134 > 0f);
                                                                        if _e1143 {
                                                                            phi_1337_ = bool();
                                                                        } else {
                                                                            phi_1337_ = (_e1135 > 0f);
                                                                        }
                                                                        let _e1146 = phi_1337_;
                                                                        phi_1338_ = _e1146;
                                                                        phi_1339_ = _e1143;
                                                                    }
                                                                    let _e1148 = phi_1338_;
                                                                    let _e1150 = phi_1339_;
                                                                    if _e1150 {
                                                                        phi_1343_ = true;
                                                                    } else {
                                                                        phi_1343_ = _e1148;
                                                                    }
                                                                    let _e1152 = phi_1343_;
                                                                    phi_1344_ = _e1152;
                                                                    phi_1345_ = false;
                                                                } else {
                                                                    phi_1344_ = bool();
                                                                    phi_1345_ = true;
                                                                }
                                                                let _e1154 = phi_1344_;
                                                                let _e1156 = phi_1345_;
                                                                phi_1346_ = _e1154;
                                                                phi_1347_ = false;
                                                                phi_1348_ = _e1156;
                                                            } else {
                                                                phi_1346_ = bool();
                                                                phi_1347_ = true;
                                                                phi_1348_ = false;
                                                            }
                                                            let _e1158 = phi_1346_;
                                                            let _e1160 = phi_1347_;
                                                            let _e1162 = phi_1348_;
                                                            phi_1349_ = _e1158;
                                                            phi_1350_ = _e1160;
                                                            phi_1351_ = _e1162;
                                                        } else {
                                                            phi_1349_ = bool();
                                                            phi_1350_ = true;
                                                            phi_1351_ = false;
                                                        }
                                                        let _e1164 = phi_1349_;
                                                        let _e1166 = phi_1350_;
                                                        let _e1168 = phi_1351_;
                                                        phi_1352_ = _e1164;
                                                        phi_1353_ = _e1166;
                                                        phi_1354_ = _e1168;
                                                    } else {
                                                        phi_1352_ = bool();
                                                        phi_1353_ = true;
                                                        phi_1354_ = false;
                                                    }
                                                    let _e1170 = phi_1352_;
                                                    let _e1172 = phi_1353_;
                                                    let _e1174 = phi_1354_;
                                                    phi_1355_ = _e1170;
                                                    phi_1356_ = _e1172;
                                                    phi_1357_ = _e1174;
                                                } else {
                                                    phi_1355_ = bool();
                                                    phi_1356_ = true;
                                                    phi_1357_ = false;
                                                }
                                                let _e1176 = phi_1355_;
                                                let _e1178 = phi_1356_;
                                                let _e1180 = phi_1357_;
                                                phi_1358_ = _e1176;
                                                phi_1359_ = _e1178;
                                                phi_1360_ = _e1180;
                                            } else {
                                                phi_1358_ = bool();
                                                phi_1359_ = true;
                                                phi_1360_ = false;
                                            }
                                            let _e1182 = phi_1358_;
                                            let _e1184 = phi_1359_;
                                            let _e1186 = phi_1360_;
                                            if _e1184 {
                                                phi_1364_ = true;
                                            } else {
                                                phi_1364_ = _e1186;
                                            }
                                            let _e1188 = phi_1364_;
                                            if _e1188 {
                                                phi_1368_ = false;
                                            } else {
                                                phi_1368_ = _e1182;
                                            }
                                            let _e1190 = phi_1368_;
                                            if _e1190 {
                                                let _e1191 = (_e1127 >= _e67);
                                                if _e1191 {
                                                    phi_2771_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1127 < _e67) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1197 = nodes.member[(0u + _e1127)].frame[0u];
                                                    let _e1201 = nodes.member[(0u + _e1127)].frame[1u];
                                                    let _e1205 = nodes.member[(0u + _e1127)].frame[2u];
                                                    let _e1209 = nodes.member[(0u + _e1127)].frame[0u];
                                                    let _e1213 = nodes.member[(0u + _e1127)].frame[1u];
                                                    let _e1217 = nodes.member[(0u + _e1127)].frame[2u];
                                                    let _e1221 = nodes.member[(0u + _e1127)].frame[3u];
                                                    let _e1255 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1096), abs(_e1109));
                                                    let _e1256 = core_intrinsics_maximum_number_nsz_f32_(_e1255, abs(_e1122));
                                                    let _e1257 = (_e1256 * 0.0000000000009094947f);
                                                    if (abs(_e1096) < _e1257) {
                                                        phi_1438_ = _e1257;
                                                    } else {
                                                        phi_1438_ = abs(_e1096);
                                                    }
                                                    let _e1262 = phi_1438_;
                                                    if (_e1096 < 0f) {
                                                        phi_1445_ = (-1f / _e1262);
                                                    } else {
                                                        phi_1445_ = (1f / _e1262);
                                                    }
                                                    let _e1267 = phi_1445_;
                                                    if (abs(_e1109) < _e1257) {
                                                        phi_1452_ = _e1257;
                                                    } else {
                                                        phi_1452_ = abs(_e1109);
                                                    }
                                                    let _e1272 = phi_1452_;
                                                    if (_e1109 < 0f) {
                                                        phi_1459_ = (-1f / _e1272);
                                                    } else {
                                                        phi_1459_ = (1f / _e1272);
                                                    }
                                                    let _e1277 = phi_1459_;
                                                    if (abs(_e1122) < _e1257) {
                                                        phi_1466_ = _e1257;
                                                    } else {
                                                        phi_1466_ = abs(_e1122);
                                                    }
                                                    let _e1282 = phi_1466_;
                                                    if (_e1122 < 0f) {
                                                        phi_1473_ = (-1f / _e1282);
                                                    } else {
                                                        phi_1473_ = (1f / _e1282);
                                                    }
                                                    let _e1287 = phi_1473_;
                                                    let _e1291 = abs((bitcast<f32>(_e1197) - _e1052));
                                                    let _e1292 = abs((bitcast<f32>(_e1201) - _e1065));
                                                    let _e1293 = abs((bitcast<f32>(_e1205) - _e1078));
                                                    let _e1297 = abs(((bitcast<f32>(_e1209) + (bitcast<f32>((((_e1221 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1052));
                                                    let _e1298 = abs(((bitcast<f32>(_e1213) + (bitcast<f32>((((_e1221 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1065));
                                                    let _e1299 = abs(((bitcast<f32>(_e1217) + (bitcast<f32>((((_e1221 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1078));
                                                    if (_e1291 > _e1297) {
                                                        phi_1490_ = _e1291;
                                                    } else {
                                                        phi_1490_ = _e1297;
                                                    }
                                                    let _e1302 = phi_1490_;
                                                    if (_e1292 > _e1298) {
                                                        phi_1495_ = _e1292;
                                                    } else {
                                                        phi_1495_ = _e1298;
                                                    }
                                                    let _e1305 = phi_1495_;
                                                    if (_e1293 > _e1299) {
                                                        phi_1500_ = _e1293;
                                                    } else {
                                                        phi_1500_ = _e1299;
                                                    }
                                                    let _e1308 = phi_1500_;
                                                    let _e1309 = core_intrinsics_maximum_number_nsz_f32_(_e1302, _e1305);
                                                    let _e1310 = core_intrinsics_maximum_number_nsz_f32_(_e1309, _e1308);
                                                    let _e1314 = (_e1310 * 0.0000019073486f);
                                                    let _e1315 = (abs(_e1267) * _e1314);
                                                    let _e1316 = (abs(_e1277) * _e1314);
                                                    let _e1317 = (abs(_e1287) * _e1314);
                                                    let _e1321 = (_e1310 * 0.0000009536743f);
                                                    let _e1322 = (abs(_e1267) * _e1321);
                                                    let _e1323 = (abs(_e1277) * _e1321);
                                                    let _e1324 = (abs(_e1287) * _e1321);
                                                    let _e1325 = abs(_e1096);
                                                    let _e1326 = abs(_e1109);
                                                    let _e1327 = abs(_e1122);
                                                    if (_e1325 >= _e1326) {
                                                        if (_e1325 >= _e1327) {
                                                            phi_1528_ = false;
                                                        } else {
                                                            phi_1528_ = true;
                                                        }
                                                        let _e1331 = phi_1528_;
                                                        phi_1529_ = _e1331;
                                                    } else {
                                                        phi_1529_ = true;
                                                    }
                                                    let _e1333 = phi_1529_;
                                                    if _e1333 {
                                                        if (_e1326 >= _e1327) {
                                                            phi_1537_ = 1u;
                                                        } else {
                                                            phi_1537_ = 2u;
                                                        }
                                                        let _e1336 = phi_1537_;
                                                        phi_1538_ = _e1336;
                                                    } else {
                                                        phi_1538_ = 0u;
                                                    }
                                                    let _e1338 = phi_1538_;
                                                    if (_e1338 == 0u) {
                                                        phi_1550_ = vec3<f32>(_e1109, _e1122, _e1096);
                                                    } else {
                                                        if (_e1338 == 1u) {
                                                            phi_1549_ = vec3<f32>(_e1122, _e1096, _e1109);
                                                        } else {
                                                            phi_1549_ = vec3<f32>(_e1096, _e1109, _e1122);
                                                        }
                                                        let _e1344 = phi_1549_;
                                                        phi_1550_ = _e1344;
                                                    }
                                                    let _e1346 = phi_1550_;
                                                    let _e1349 = (_e1346.x / _e1346.z);
                                                    let _e1352 = (_e1346.y / _e1346.z);
                                                    if (_e1267 < 0f) {
                                                        phi_1563_ = 0u;
                                                    } else {
                                                        phi_1563_ = 1u;
                                                    }
                                                    let _e1357 = phi_1563_;
                                                    if (_e1277 < 0f) {
                                                        phi_1568_ = 0u;
                                                    } else {
                                                        phi_1568_ = 2u;
                                                    }
                                                    let _e1360 = phi_1568_;
                                                    if (_e1287 < 0f) {
                                                        phi_1573_ = 0u;
                                                    } else {
                                                        phi_1573_ = 4u;
                                                    }
                                                    let _e1363 = phi_1573_;
                                                    let _e1365 = ((_e1357 | _e1360) | _e1363);
                                                    let _e1366 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1127, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1366.first[0], _e1366.first[1], _e1366.first[2], _e1366.first[3], _e1366.first[4], _e1366.first[5], _e1366.first[6], _e1366.first[7], _e1366.first[8], _e1366.first[9], _e1366.first[10], _e1366.first[11], _e1366.first[12], _e1366.first[13], _e1366.first[14], _e1366.first[15], _e1366.first[16], _e1366.first[17], _e1366.first[18], _e1366.first[19], _e1366.first[20], _e1366.first[21], _e1366.first[22], _e1366.first[23], _e1366.first[24], _e1366.first[25], _e1366.first[26], _e1366.first[27], _e1366.first[28], _e1366.first[29], _e1366.first[30], _e1366.first[31]), array<u32, 32>(_e1366.mask[0], _e1366.mask[1], _e1366.mask[2], _e1366.mask[3], _e1366.mask[4], _e1366.mask[5], _e1366.mask[6], _e1366.mask[7], _e1366.mask[8], _e1366.mask[9], _e1366.mask[10], _e1366.mask[11], _e1366.mask[12], _e1366.mask[13], _e1366.mask[14], _e1366.mask[15], _e1366.mask[16], _e1366.mask[17], _e1366.mask[18], _e1366.mask[19], _e1366.mask[20], _e1366.mask[21], _e1366.mask[22], _e1366.mask[23], _e1366.mask[24], _e1366.mask[25], _e1366.mask[26], _e1366.mask[27], _e1366.mask[28], _e1366.mask[29], _e1366.mask[30], _e1366.mask[31]), _e1366.len, _e1366.group, _e1366.group_mask);
                                                    let _e1440 = local.group_mask;
                                                    if ((_e1440 & 4278190080u) == 0u) {
                                                        let _e1444 = local.len;
                                                        if (_e1444 == 0u) {
                                                            phi_1687_ = false;
                                                        } else {
                                                            let _e1448 = local.len;
                                                            local.len = (_e1448 - 1u);
                                                            let _e1451 = local.len;
                                                            if (_e1451 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1456 = local.first[(0u + _e1451)];
                                                            local.group = _e1456;
                                                            let _e1459 = local.len;
                                                            if (_e1459 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1464 = local.mask[(0u + _e1459)];
                                                            local.group_mask = _e1464;
                                                            phi_1687_ = true;
                                                        }
                                                        let _e1467 = phi_1687_;
                                                        phi_1688_ = _e1467;
                                                    } else {
                                                        phi_1688_ = true;
                                                    }
                                                    let _e1469 = phi_1688_;
                                                    if _e1469 {
                                                        let _e1471 = local.group_mask;
                                                        let _e1477 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1471)), 32u, (_e1471 == 0u)));
                                                        let _e1481 = local.group_mask;
                                                        let _e1495 = local.group_mask;
                                                        local.group_mask = (_e1495 & ~((1u << bitcast<u32>((_e1477 & 31u)))));
                                                        let _e1498 = local.group;
                                                        phi_1719_ = (_e1498 + countOneBits(((_e1481 & ~((4294967295u << bitcast<u32>((((_e1477 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1719_ = 4294967295u;
                                                    }
                                                    let _e1501 = phi_1719_;
                                                    phi_1721_ = _e960;
                                                    phi_1724_ = _e1501;
                                                    loop {
                                                        let _e1503 = phi_1721_;
                                                        let _e1505 = phi_1724_;
                                                        local_9 = _e1503;
                                                        let _e1506 = (_e1505 != 4294967295u);
                                                        if _e1506 {
                                                            if (_e1505 < _e67) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1513 = nodes.member[(0u + _e1505)].frame[3u];
                                                            let _e1538 = (bitcast<f32>((((_e1513 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1267);
                                                            let _e1539 = (bitcast<f32>((((_e1513 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1277);
                                                            let _e1540 = (bitcast<f32>((((_e1513 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1287);
                                                            let _e1543 = nodes.member[(0u + _e1505)].frame[0u];
                                                            let _e1547 = nodes.member[(0u + _e1505)].frame[1u];
                                                            let _e1551 = nodes.member[(0u + _e1505)].frame[2u];
                                                            let _e1556 = ((bitcast<f32>(_e1543) - _e1052) * _e1267);
                                                            let _e1557 = ((bitcast<f32>(_e1547) - _e1065) * _e1277);
                                                            let _e1558 = ((bitcast<f32>(_e1551) - _e1078) * _e1287);
                                                            let _e1566 = nodes.member[(0u + _e1505)].x;
                                                            if (_e1267 < 0f) {
                                                                let _e1577 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1566.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1583 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1577.unnamed.word, _e1566.w), _e1577.unnamed_1);
                                                                let _e1589 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1583.unnamed, lt_mask_LightPlace(_e1566.x, _e1583.unnamed_1.shift));
                                                                phi_1805_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1589.unnamed, lt_mask_LightPlace(_e1589.unnamed_1.word, _e1566.y));
                                                            } else {
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1566.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1611 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1605.unnamed.word, _e1566.y), _e1605.unnamed_1);
                                                                let _e1617 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1611.unnamed, lt_mask_LightPlace(_e1566.z, _e1611.unnamed_1.shift));
                                                                phi_1805_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1617.unnamed, lt_mask_LightPlace(_e1617.unnamed_1.word, _e1566.w));
                                                            }
                                                            let _e1625 = phi_1805_;
                                                            let _e1635 = nodes.member[(0u + _e1505)].y;
                                                            if (_e1277 < 0f) {
                                                                let _e1646 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1635.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1652 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1646.unnamed.word, _e1635.w), _e1646.unnamed_1);
                                                                let _e1658 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1652.unnamed, lt_mask_LightPlace(_e1635.x, _e1652.unnamed_1.shift));
                                                                phi_1832_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1658.unnamed, lt_mask_LightPlace(_e1658.unnamed_1.word, _e1635.y));
                                                            } else {
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1635.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1680 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1674.unnamed.word, _e1635.y), _e1674.unnamed_1);
                                                                let _e1686 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1680.unnamed, lt_mask_LightPlace(_e1635.z, _e1680.unnamed_1.shift));
                                                                phi_1832_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1686.unnamed, lt_mask_LightPlace(_e1686.unnamed_1.word, _e1635.w));
                                                            }
                                                            let _e1694 = phi_1832_;
                                                            let _e1704 = nodes.member[(0u + _e1505)].z;
                                                            if (_e1287 < 0f) {
                                                                let _e1715 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1704.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1721 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1715.unnamed.word, _e1704.w), _e1715.unnamed_1);
                                                                let _e1727 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1721.unnamed, lt_mask_LightPlace(_e1704.x, _e1721.unnamed_1.shift));
                                                                phi_1859_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1727.unnamed, lt_mask_LightPlace(_e1727.unnamed_1.word, _e1704.y));
                                                            } else {
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1704.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1749 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1743.unnamed.word, _e1704.y), _e1743.unnamed_1);
                                                                let _e1755 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1749.unnamed, lt_mask_LightPlace(_e1704.z, _e1749.unnamed_1.shift));
                                                                phi_1859_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1755.unnamed, lt_mask_LightPlace(_e1755.unnamed_1.word, _e1704.w));
                                                            }
                                                            let _e1763 = phi_1859_;
                                                            phi_1865_ = 0u;
                                                            phi_1868_ = 0u;
                                                            loop {
                                                                let _e1773 = phi_1865_;
                                                                let _e1775 = phi_1868_;
                                                                local_5 = _e1775;
                                                                local_6 = _e1775;
                                                                local_7 = _e1775;
                                                                let _e1776 = (_e1773 < 8u);
                                                                if _e1776 {
                                                                    let _e1778 = (_e1773 >> bitcast<u32>(2i));
                                                                    let _e1779 = (_e1773 & 3u);
                                                                    if (_e1778 == 0u) {
                                                                        phi_1882_ = _e1625.unnamed.word;
                                                                    } else {
                                                                        phi_1882_ = _e1625.unnamed.shift;
                                                                    }
                                                                    let _e1782 = phi_1882_;
                                                                    if (_e1778 == 0u) {
                                                                        phi_1892_ = _e1694.unnamed.word;
                                                                    } else {
                                                                        phi_1892_ = _e1694.unnamed.shift;
                                                                    }
                                                                    let _e1791 = phi_1892_;
                                                                    if (_e1778 == 0u) {
                                                                        phi_1902_ = _e1763.unnamed.word;
                                                                    } else {
                                                                        phi_1902_ = _e1763.unnamed.shift;
                                                                    }
                                                                    let _e1800 = phi_1902_;
                                                                    let _e1813 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1782 >> bitcast<u32>(((_e1779 * 8u) & 31u))) & 255u)) * _e1538) + (_e1556 - _e1315)), ((f32(((_e1791 >> bitcast<u32>(((_e1779 * 8u) & 31u))) & 255u)) * _e1539) + (_e1557 - _e1316)));
                                                                    let _e1814 = core_intrinsics_maximum_number_nsz_f32_(_e1813, ((f32(((_e1800 >> bitcast<u32>(((_e1779 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 - _e1317)));
                                                                    if (_e1778 == 0u) {
                                                                        phi_1920_ = _e1625.unnamed_1.word;
                                                                    } else {
                                                                        phi_1920_ = _e1625.unnamed_1.shift;
                                                                    }
                                                                    let _e1817 = phi_1920_;
                                                                    if (_e1778 == 0u) {
                                                                        phi_1930_ = _e1694.unnamed_1.word;
                                                                    } else {
                                                                        phi_1930_ = _e1694.unnamed_1.shift;
                                                                    }
                                                                    let _e1826 = phi_1930_;
                                                                    if (_e1778 == 0u) {
                                                                        phi_1940_ = _e1763.unnamed_1.word;
                                                                    } else {
                                                                        phi_1940_ = _e1763.unnamed_1.shift;
                                                                    }
                                                                    let _e1835 = phi_1940_;
                                                                    let _e1848 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1817 >> bitcast<u32>(((_e1779 * 8u) & 31u))) & 255u)) * _e1538) + (_e1556 + _e1315)), ((f32(((_e1826 >> bitcast<u32>(((_e1779 * 8u) & 31u))) & 255u)) * _e1539) + (_e1557 + _e1316)));
                                                                    let _e1849 = core_intrinsics_minimum_number_nsz_f32_(_e1848, ((f32(((_e1835 >> bitcast<u32>(((_e1779 * 8u) & 31u))) & 255u)) * _e1540) + (_e1558 + _e1317)));
                                                                    if (_e1814 <= _e1849) {
                                                                        if (_e1814 <= _e1503.t) {
                                                                            if (_e1849 >= _e145.tmin) {
                                                                                if (_e1778 == 0u) {
                                                                                    let _e1856 = nodes.member[(0u + _e1505)].links[2u];
                                                                                    phi_1976_ = _e1856;
                                                                                } else {
                                                                                    let _e1859 = nodes.member[(0u + _e1505)].links[3u];
                                                                                    phi_1976_ = _e1859;
                                                                                }
                                                                                let _e1861 = phi_1976_;
                                                                                let _e1866 = ((_e1861 >> bitcast<u32>(((_e1779 * 8u) & 31u))) & 255u);
                                                                                let _e1867 = (_e1866 & 31u);
                                                                                if (_e1867 >= 24u) {
                                                                                    phi_1989_ = (24u + ((_e1867 - 24u) ^ _e1365));
                                                                                } else {
                                                                                    phi_1989_ = _e1867;
                                                                                }
                                                                                let _e1873 = phi_1989_;
                                                                                phi_1994_ = (_e1775 | ((_e1866 >> bitcast<u32>(5i)) << bitcast<u32>((_e1873 & 31u))));
                                                                            } else {
                                                                                phi_1994_ = _e1775;
                                                                            }
                                                                            let _e1881 = phi_1994_;
                                                                            phi_1995_ = _e1881;
                                                                        } else {
                                                                            phi_1995_ = _e1775;
                                                                        }
                                                                        let _e1883 = phi_1995_;
                                                                        phi_1996_ = _e1883;
                                                                    } else {
                                                                        phi_1996_ = _e1775;
                                                                    }
                                                                    let _e1885 = phi_1996_;
                                                                    phi_1866_ = (_e1773 + 1u);
                                                                    phi_1869_ = _e1885;
                                                                } else {
                                                                    phi_1866_ = u32();
                                                                    phi_1869_ = u32();
                                                                }
                                                                let _e1888 = phi_1866_;
                                                                let _e1890 = phi_1869_;
                                                                continue;
                                                                continuing {
                                                                    phi_1865_ = _e1888;
                                                                    phi_1868_ = _e1890;
                                                                    break if !(_e1776);
                                                                }
                                                            }
                                                            let _e1894 = nodes.member[(0u + _e1505)].links[0u];
                                                            let _e1898 = nodes.member[(0u + _e1505)].frame[3u];
                                                            let _e1902 = local_5;
                                                            if ((_e1902 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1906 = local.group_mask;
                                                                if ((_e1906 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1910 = local.len;
                                                                    if (_e1910 < 32u) {
                                                                        let _e1913 = local.group;
                                                                        let _e1915 = local.len;
                                                                        if (_e1915 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1915)] = _e1913;
                                                                        let _e1921 = local.group_mask;
                                                                        let _e1923 = local.len;
                                                                        if (_e1923 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1923)] = _e1921;
                                                                        let _e1930 = local.len;
                                                                        local.len = (_e1930 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1127 + _e1894);
                                                                let _e1934 = local_6;
                                                                local.group_mask = ((_e1934 & 4278190080u) | (_e1898 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1939 = local_7;
                                                            phi_2054_ = _e1503;
                                                            phi_2057_ = (_e1939 & 16777215u);
                                                            loop {
                                                                let _e1942 = phi_2054_;
                                                                let _e1944 = phi_2057_;
                                                                local_8 = _e1942;
                                                                if (_e1944 == 0u) {
                                                                    phi_2055_ = lt_bvh_Hit();
                                                                    phi_2058_ = u32();
                                                                    phi_2699_ = false;
                                                                } else {
                                                                    let _e1948 = nodes.member[(0u + _e1505)].links[1u];
                                                                    let _e1953 = ((_e1129 + _e1948) + select(firstTrailingBit(_e1944), 32u, (_e1944 == 0u)));
                                                                    if (_e1953 < _e70) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1960 = triangles.member[(0u + _e1953)].v0_;
                                                                    let _e1962 = (_e1960.x - _e1052);
                                                                    let _e1964 = (_e1960.y - _e1065);
                                                                    let _e1966 = (_e1960.z - _e1078);
                                                                    if (_e1338 == 0u) {
                                                                        phi_2102_ = vec3<f32>(_e1964, _e1966, _e1962);
                                                                    } else {
                                                                        if (_e1338 == 1u) {
                                                                            phi_2101_ = vec3<f32>(_e1966, _e1962, _e1964);
                                                                        } else {
                                                                            phi_2101_ = (_e1960 - vec3<f32>(_e1052, _e1065, _e1078));
                                                                        }
                                                                        let _e1974 = phi_2101_;
                                                                        phi_2102_ = _e1974;
                                                                    }
                                                                    let _e1976 = phi_2102_;
                                                                    let _e1980 = (_e1976.x - (_e1349 * _e1976.z));
                                                                    let _e1984 = (_e1976.y - (_e1352 * _e1976.z));
                                                                    let _e1986 = triangles.member[(0u + _e1953)].v1_;
                                                                    let _e1988 = (_e1986.x - _e1052);
                                                                    let _e1990 = (_e1986.y - _e1065);
                                                                    let _e1992 = (_e1986.z - _e1078);
                                                                    if (_e1338 == 0u) {
                                                                        phi_2132_ = vec3<f32>(_e1990, _e1992, _e1988);
                                                                    } else {
                                                                        if (_e1338 == 1u) {
                                                                            phi_2131_ = vec3<f32>(_e1992, _e1988, _e1990);
                                                                        } else {
                                                                            phi_2131_ = (_e1986 - vec3<f32>(_e1052, _e1065, _e1078));
                                                                        }
                                                                        let _e2000 = phi_2131_;
                                                                        phi_2132_ = _e2000;
                                                                    }
                                                                    let _e2002 = phi_2132_;
                                                                    let _e2006 = (_e2002.x - (_e1349 * _e2002.z));
                                                                    let _e2010 = (_e2002.y - (_e1352 * _e2002.z));
                                                                    let _e2012 = triangles.member[(0u + _e1953)].v2_;
                                                                    let _e2014 = (_e2012.x - _e1052);
                                                                    let _e2016 = (_e2012.y - _e1065);
                                                                    let _e2018 = (_e2012.z - _e1078);
                                                                    if (_e1338 == 0u) {
                                                                        phi_2162_ = vec3<f32>(_e2016, _e2018, _e2014);
                                                                    } else {
                                                                        if (_e1338 == 1u) {
                                                                            phi_2161_ = vec3<f32>(_e2018, _e2014, _e2016);
                                                                        } else {
                                                                            phi_2161_ = (_e2012 - vec3<f32>(_e1052, _e1065, _e1078));
                                                                        }
                                                                        let _e2026 = phi_2161_;
                                                                        phi_2162_ = _e2026;
                                                                    }
                                                                    let _e2028 = phi_2162_;
                                                                    let _e2032 = (_e2028.x - (_e1349 * _e2028.z));
                                                                    let _e2036 = (_e2028.y - (_e1352 * _e2028.z));
                                                                    if (_e2006 < _e2032) {
                                                                        phi_2181_ = true;
                                                                    } else {
                                                                        if (_e2006 == _e2032) {
                                                                            phi_2180_ = (_e2010 < _e2036);
                                                                        } else {
                                                                            phi_2180_ = false;
                                                                        }
                                                                        let _e2041 = phi_2180_;
                                                                        phi_2181_ = _e2041;
                                                                    }
                                                                    let _e2043 = phi_2181_;
                                                                    if _e2043 {
                                                                        phi_2185_ = _e2036;
                                                                        phi_2186_ = _e2032;
                                                                        phi_2187_ = _e2010;
                                                                        phi_2188_ = _e2006;
                                                                    } else {
                                                                        phi_2185_ = _e2010;
                                                                        phi_2186_ = _e2006;
                                                                        phi_2187_ = _e2036;
                                                                        phi_2188_ = _e2032;
                                                                    }
                                                                    let _e2045 = phi_2185_;
                                                                    let _e2047 = phi_2186_;
                                                                    let _e2049 = phi_2187_;
                                                                    let _e2051 = phi_2188_;
                                                                    let _e2054 = ((_e2051 * _e2045) - (_e2049 * _e2047));
                                                                    if _e2043 {
                                                                        phi_2196_ = -(_e2054);
                                                                    } else {
                                                                        phi_2196_ = _e2054;
                                                                    }
                                                                    let _e2057 = phi_2196_;
                                                                    if (_e2032 < _e1980) {
                                                                        phi_2207_ = true;
                                                                    } else {
                                                                        if (_e2032 == _e1980) {
                                                                            phi_2206_ = (_e2036 < _e1984);
                                                                        } else {
                                                                            phi_2206_ = false;
                                                                        }
                                                                        let _e2062 = phi_2206_;
                                                                        phi_2207_ = _e2062;
                                                                    }
                                                                    let _e2064 = phi_2207_;
                                                                    if _e2064 {
                                                                        phi_2211_ = _e1984;
                                                                        phi_2212_ = _e1980;
                                                                        phi_2213_ = _e2036;
                                                                        phi_2214_ = _e2032;
                                                                    } else {
                                                                        phi_2211_ = _e2036;
                                                                        phi_2212_ = _e2032;
                                                                        phi_2213_ = _e1984;
                                                                        phi_2214_ = _e1980;
                                                                    }
                                                                    let _e2066 = phi_2211_;
                                                                    let _e2068 = phi_2212_;
                                                                    let _e2070 = phi_2213_;
                                                                    let _e2072 = phi_2214_;
                                                                    let _e2075 = ((_e2072 * _e2066) - (_e2070 * _e2068));
                                                                    if _e2064 {
                                                                        phi_2222_ = -(_e2075);
                                                                    } else {
                                                                        phi_2222_ = _e2075;
                                                                    }
                                                                    let _e2078 = phi_2222_;
                                                                    if (_e1980 < _e2006) {
                                                                        phi_2233_ = true;
                                                                    } else {
                                                                        if (_e1980 == _e2006) {
                                                                            phi_2232_ = (_e1984 < _e2010);
                                                                        } else {
                                                                            phi_2232_ = false;
                                                                        }
                                                                        let _e2083 = phi_2232_;
                                                                        phi_2233_ = _e2083;
                                                                    }
                                                                    let _e2085 = phi_2233_;
                                                                    if _e2085 {
                                                                        phi_2237_ = _e2010;
                                                                        phi_2238_ = _e2006;
                                                                        phi_2239_ = _e1984;
                                                                        phi_2240_ = _e1980;
                                                                    } else {
                                                                        phi_2237_ = _e1984;
                                                                        phi_2238_ = _e1980;
                                                                        phi_2239_ = _e2010;
                                                                        phi_2240_ = _e2006;
                                                                    }
                                                                    let _e2087 = phi_2237_;
                                                                    let _e2089 = phi_2238_;
                                                                    let _e2091 = phi_2239_;
                                                                    let _e2093 = phi_2240_;
                                                                    let _e2096 = ((_e2093 * _e2087) - (_e2091 * _e2089));
                                                                    if _e2085 {
                                                                        phi_2248_ = -(_e2096);
                                                                    } else {
                                                                        phi_2248_ = _e2096;
                                                                    }
                                                                    let _e2099 = phi_2248_;
                                                                    if (_e2057 >= 0f) {
                                                                        if (_e2078 >= 0f) {
                                                                            if (_e2099 >= 0f) {
                                                                                phi_2263_ = ((_e2057 + _e2078) + _e2099);
                                                                                phi_2264_ = false;
                                                                            } else {
                                                                                phi_2263_ = f32();
                                                                                phi_2264_ = true;
                                                                            }
                                                                            let _e2106 = phi_2263_;
                                                                            let _e2108 = phi_2264_;
                                                                            phi_2265_ = _e2106;
                                                                            phi_2266_ = _e2108;
                                                                        } else {
                                                                            phi_2265_ = f32();
                                                                            phi_2266_ = true;
                                                                        }
                                                                        let _e2110 = phi_2265_;
                                                                        let _e2112 = phi_2266_;
                                                                        phi_2267_ = _e2110;
                                                                        phi_2268_ = _e2112;
                                                                    } else {
                                                                        phi_2267_ = f32();
                                                                        phi_2268_ = true;
                                                                    }
                                                                    let _e2114 = phi_2267_;
                                                                    let _e2116 = phi_2268_;
                                                                    if _e2116 {
                                                                        if (_e2057 <= 0f) {
                                                                            if (_e2078 <= 0f) {
                                                                                let _e2119 = (_e2099 <= 0f);
                                                                                if _e2119 {
                                                                                }
                                                                                phi_2286_ = ((_e2057 + _e2078) + _e2099);
                                                                                phi_2287_ = false;
                                                                                phi_2288_ = _e2119;
                                                                            } else {
                                                                                phi_2286_ = f32();
                                                                                phi_2287_ = true;
                                                                                phi_2288_ = false;
                                                                            }
                                                                            let _e2123 = phi_2286_;
                                                                            let _e2125 = phi_2287_;
                                                                            let _e2127 = phi_2288_;
                                                                            phi_2289_ = _e2123;
                                                                            phi_2290_ = _e2125;
                                                                            phi_2291_ = _e2127;
                                                                        } else {
                                                                            phi_2289_ = f32();
                                                                            phi_2290_ = true;
                                                                            phi_2291_ = false;
                                                                        }
                                                                        let _e2129 = phi_2289_;
                                                                        let _e2131 = phi_2290_;
                                                                        let _e2133 = phi_2291_;
                                                                        if _e2131 {
                                                                            phi_2295_ = false;
                                                                        } else {
                                                                            phi_2295_ = _e2133;
                                                                        }
                                                                        let _e2135 = phi_2295_;
                                                                        phi_2296_ = _e2129;
                                                                        phi_2297_ = _e2135;
                                                                    } else {
                                                                        phi_2296_ = _e2114;
                                                                        phi_2297_ = true;
                                                                    }
                                                                    let _e2137 = phi_2296_;
                                                                    let _e2139 = phi_2297_;
                                                                    if _e2139 {
                                                                        let _e2140 = (_e2137 == 0f);
                                                                        if _e2140 {
                                                                            phi_2613_ = lt_bvh_triangle_Intersection();
                                                                            phi_2614_ = false;
                                                                        } else {
                                                                            let _e2142 = triangles.member[(0u + _e1953)].v0_;
                                                                            let _e2144 = (_e2142.x - _e1052);
                                                                            let _e2146 = (_e2142.y - _e1065);
                                                                            let _e2148 = (_e2142.z - _e1078);
                                                                            if (_e1338 == 0u) {
                                                                                phi_2326_ = vec3<f32>(_e2146, _e2148, _e2144);
                                                                            } else {
                                                                                if (_e1338 == 1u) {
                                                                                    phi_2325_ = vec3<f32>(_e2148, _e2144, _e2146);
                                                                                } else {
                                                                                    phi_2325_ = (_e2142 - vec3<f32>(_e1052, _e1065, _e1078));
                                                                                }
                                                                                let _e2156 = phi_2325_;
                                                                                phi_2326_ = _e2156;
                                                                            }
                                                                            let _e2158 = phi_2326_;
                                                                            let _e2160 = triangles.member[(0u + _e1953)].v1_;
                                                                            let _e2162 = triangles.member[(0u + _e1953)].v0_;
                                                                            let _e2165 = (_e2160.x - _e2162.x);
                                                                            let _e2168 = (_e2160.y - _e2162.y);
                                                                            let _e2171 = (_e2160.z - _e2162.z);
                                                                            if (_e1338 == 0u) {
                                                                                phi_2352_ = vec3<f32>(_e2168, _e2171, _e2165);
                                                                            } else {
                                                                                if (_e1338 == 1u) {
                                                                                    phi_2351_ = vec3<f32>(_e2171, _e2165, _e2168);
                                                                                } else {
                                                                                    phi_2351_ = (_e2160 - _e2162);
                                                                                }
                                                                                let _e2178 = phi_2351_;
                                                                                phi_2352_ = _e2178;
                                                                            }
                                                                            let _e2180 = phi_2352_;
                                                                            let _e2182 = triangles.member[(0u + _e1953)].v2_;
                                                                            let _e2184 = triangles.member[(0u + _e1953)].v0_;
                                                                            let _e2187 = (_e2182.x - _e2184.x);
                                                                            let _e2190 = (_e2182.y - _e2184.y);
                                                                            let _e2193 = (_e2182.z - _e2184.z);
                                                                            if (_e1338 == 0u) {
                                                                                phi_2378_ = vec3<f32>(_e2190, _e2193, _e2187);
                                                                            } else {
                                                                                if (_e1338 == 1u) {
                                                                                    phi_2377_ = vec3<f32>(_e2193, _e2187, _e2190);
                                                                                } else {
                                                                                    phi_2377_ = (_e2182 - _e2184);
                                                                                }
                                                                                let _e2200 = phi_2377_;
                                                                                phi_2378_ = _e2200;
                                                                            }
                                                                            let _e2202 = phi_2378_;
                                                                            let _e2209 = ((_e2180.y * _e2202.z) - (_e2180.z * _e2202.y));
                                                                            let _e2216 = ((_e2180.z * _e2202.x) - (_e2180.x * _e2202.z));
                                                                            let _e2223 = ((_e2180.x * _e2202.y) - (_e2180.y * _e2202.x));
                                                                            let _e2237 = (((1f / _e1346.z) * (((_e2209 * _e2158.x) + (_e2216 * _e2158.y)) + (_e2223 * _e2158.z))) / (((_e2209 * _e1349) + (_e2216 * _e1352)) + _e2223));
                                                                            if (_e2237 > _e145.tmin) {
                                                                                if (_e2237 < _e145.tmax) {
                                                                                    let _e2241 = triangles.member[(0u + _e1953)].v0_;
                                                                                    let _e2243 = triangles.member[(0u + _e1953)].v1_;
                                                                                    if (_e2241.x < _e2243.x) {
                                                                                        phi_2434_ = _e2241.x;
                                                                                    } else {
                                                                                        phi_2434_ = _e2243.x;
                                                                                    }
                                                                                    let _e2250 = phi_2434_;
                                                                                    if (_e2241.y < _e2243.y) {
                                                                                        phi_2443_ = _e2241.y;
                                                                                    } else {
                                                                                        phi_2443_ = _e2243.y;
                                                                                    }
                                                                                    let _e2257 = phi_2443_;
                                                                                    if (_e2241.z < _e2243.z) {
                                                                                        phi_2452_ = _e2241.z;
                                                                                    } else {
                                                                                        phi_2452_ = _e2243.z;
                                                                                    }
                                                                                    let _e2264 = phi_2452_;
                                                                                    let _e2266 = triangles.member[(0u + _e1953)].v2_;
                                                                                    if (_e2250 < _e2266.x) {
                                                                                        phi_2461_ = _e2250;
                                                                                    } else {
                                                                                        phi_2461_ = _e2266.x;
                                                                                    }
                                                                                    let _e2271 = phi_2461_;
                                                                                    if (_e2257 < _e2266.y) {
                                                                                        phi_2468_ = _e2257;
                                                                                    } else {
                                                                                        phi_2468_ = _e2266.y;
                                                                                    }
                                                                                    let _e2276 = phi_2468_;
                                                                                    if (_e2264 < _e2266.z) {
                                                                                        phi_2475_ = _e2264;
                                                                                    } else {
                                                                                        phi_2475_ = _e2266.z;
                                                                                    }
                                                                                    let _e2281 = phi_2475_;
                                                                                    let _e2283 = triangles.member[(0u + _e1953)].v0_;
                                                                                    let _e2285 = triangles.member[(0u + _e1953)].v1_;
                                                                                    if (_e2283.x > _e2285.x) {
                                                                                        phi_2488_ = _e2283.x;
                                                                                    } else {
                                                                                        phi_2488_ = _e2285.x;
                                                                                    }
                                                                                    let _e2292 = phi_2488_;
                                                                                    if (_e2283.y > _e2285.y) {
                                                                                        phi_2497_ = _e2283.y;
                                                                                    } else {
                                                                                        phi_2497_ = _e2285.y;
                                                                                    }
                                                                                    let _e2299 = phi_2497_;
                                                                                    if (_e2283.z > _e2285.z) {
                                                                                        phi_2506_ = _e2283.z;
                                                                                    } else {
                                                                                        phi_2506_ = _e2285.z;
                                                                                    }
                                                                                    let _e2306 = phi_2506_;
                                                                                    let _e2308 = triangles.member[(0u + _e1953)].v2_;
                                                                                    if (_e2292 > _e2308.x) {
                                                                                        phi_2515_ = _e2292;
                                                                                    } else {
                                                                                        phi_2515_ = _e2308.x;
                                                                                    }
                                                                                    let _e2313 = phi_2515_;
                                                                                    if (_e2299 > _e2308.y) {
                                                                                        phi_2522_ = _e2299;
                                                                                    } else {
                                                                                        phi_2522_ = _e2308.y;
                                                                                    }
                                                                                    let _e2318 = phi_2522_;
                                                                                    if (_e2306 > _e2308.z) {
                                                                                        phi_2529_ = _e2306;
                                                                                    } else {
                                                                                        phi_2529_ = _e2308.z;
                                                                                    }
                                                                                    let _e2323 = phi_2529_;
                                                                                    let _e2327 = ((_e2271 - _e1052) * _e1267);
                                                                                    let _e2328 = ((_e2276 - _e1065) * _e1277);
                                                                                    let _e2329 = ((_e2281 - _e1078) * _e1287);
                                                                                    let _e2333 = ((_e2313 - _e1052) * _e1267);
                                                                                    let _e2334 = ((_e2318 - _e1065) * _e1277);
                                                                                    let _e2335 = ((_e2323 - _e1078) * _e1287);
                                                                                    if (_e2327 < _e2333) {
                                                                                        phi_2546_ = _e2327;
                                                                                    } else {
                                                                                        phi_2546_ = _e2333;
                                                                                    }
                                                                                    let _e2338 = phi_2546_;
                                                                                    if (_e2328 < _e2334) {
                                                                                        phi_2551_ = _e2328;
                                                                                    } else {
                                                                                        phi_2551_ = _e2334;
                                                                                    }
                                                                                    let _e2341 = phi_2551_;
                                                                                    if (_e2329 < _e2335) {
                                                                                        phi_2556_ = _e2329;
                                                                                    } else {
                                                                                        phi_2556_ = _e2335;
                                                                                    }
                                                                                    let _e2344 = phi_2556_;
                                                                                    if (_e2327 > _e2333) {
                                                                                        phi_2564_ = _e2327;
                                                                                    } else {
                                                                                        phi_2564_ = _e2333;
                                                                                    }
                                                                                    let _e2350 = phi_2564_;
                                                                                    if (_e2328 > _e2334) {
                                                                                        phi_2569_ = _e2328;
                                                                                    } else {
                                                                                        phi_2569_ = _e2334;
                                                                                    }
                                                                                    let _e2353 = phi_2569_;
                                                                                    if (_e2329 > _e2335) {
                                                                                        phi_2574_ = _e2329;
                                                                                    } else {
                                                                                        phi_2574_ = _e2335;
                                                                                    }
                                                                                    let _e2356 = phi_2574_;
                                                                                    let _e2360 = core_intrinsics_maximum_number_nsz_f32_((_e2338 - _e1322), (_e2341 - _e1323));
                                                                                    let _e2361 = core_intrinsics_maximum_number_nsz_f32_(_e2360, (_e2344 - _e1324));
                                                                                    let _e2362 = core_intrinsics_minimum_number_nsz_f32_((_e2350 + _e1322), (_e2353 + _e1323));
                                                                                    let _e2363 = core_intrinsics_minimum_number_nsz_f32_(_e2362, (_e2356 + _e1324));
                                                                                    if (_e2361 > _e1027) {
                                                                                        phi_2586_ = _e2361;
                                                                                    } else {
                                                                                        phi_2586_ = _e1027;
                                                                                    }
                                                                                    let _e2366 = phi_2586_;
                                                                                    if (_e2363 < _e1029) {
                                                                                        phi_2591_ = _e2363;
                                                                                    } else {
                                                                                        phi_2591_ = _e1029;
                                                                                    }
                                                                                    let _e2369 = phi_2591_;
                                                                                    if (_e2237 < _e2366) {
                                                                                        phi_2596_ = _e2366;
                                                                                    } else {
                                                                                        phi_2596_ = _e2237;
                                                                                    }
                                                                                    let _e2372 = phi_2596_;
                                                                                    if (_e2372 > _e2369) {
                                                                                        phi_2601_ = _e2369;
                                                                                    } else {
                                                                                        phi_2601_ = _e2372;
                                                                                    }
                                                                                    let _e2375 = phi_2601_;
                                                                                    phi_2606_ = lt_bvh_triangle_Intersection(_e2375, (_e2078 / _e2137), (_e2099 / _e2137), (_e2366 <= _e2369));
                                                                                    phi_2607_ = false;
                                                                                } else {
                                                                                    phi_2606_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2607_ = true;
                                                                                }
                                                                                let _e2381 = phi_2606_;
                                                                                let _e2383 = phi_2607_;
                                                                                phi_2608_ = _e2381;
                                                                                phi_2609_ = _e2383;
                                                                            } else {
                                                                                phi_2608_ = lt_bvh_triangle_Intersection();
                                                                                phi_2609_ = true;
                                                                            }
                                                                            let _e2385 = phi_2608_;
                                                                            let _e2387 = phi_2609_;
                                                                            if _e2387 {
                                                                            }
                                                                            phi_2613_ = _e2385;
                                                                            phi_2614_ = _e2387;
                                                                        }
                                                                        let _e2389 = phi_2613_;
                                                                        let _e2391 = phi_2614_;
                                                                        phi_2615_ = _e2389;
                                                                        phi_2616_ = _e2140;
                                                                        phi_2617_ = _e2391;
                                                                    } else {
                                                                        phi_2615_ = lt_bvh_triangle_Intersection();
                                                                        phi_2616_ = true;
                                                                        phi_2617_ = false;
                                                                    }
                                                                    let _e2393 = phi_2615_;
                                                                    let _e2395 = phi_2616_;
                                                                    let _e2397 = phi_2617_;
                                                                    if _e2395 {
                                                                        phi_2621_ = true;
                                                                    } else {
                                                                        phi_2621_ = _e2397;
                                                                    }
                                                                    let _e2399 = phi_2621_;
                                                                    if _e2399 {
                                                                        phi_2625_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2625_ = _e2393;
                                                                    }
                                                                    let _e2401 = phi_2625_;
                                                                    if _e2401.is_hit {
                                                                        if (_e2401.t > _e145.tmin) {
                                                                            if (_e2401.t < _e1942.t) {
                                                                                phi_2673_ = true;
                                                                            } else {
                                                                                if (_e2401.t == _e1942.t) {
                                                                                    if (_e1942.triangle != 4294967295u) {
                                                                                        if (_e1953 < _e1942.triangle) {
                                                                                            phi_2664_ = true;
                                                                                        } else {
                                                                                            if (_e1953 == _e1942.triangle) {
                                                                                                phi_2663_ = (_e968 < _e1942.instance);
                                                                                            } else {
                                                                                                phi_2663_ = false;
                                                                                            }
                                                                                            let _e2419 = phi_2663_;
                                                                                            phi_2664_ = _e2419;
                                                                                        }
                                                                                        let _e2421 = phi_2664_;
                                                                                        phi_2665_ = _e2421;
                                                                                        phi_2666_ = false;
                                                                                    } else {
                                                                                        phi_2665_ = bool();
                                                                                        phi_2666_ = true;
                                                                                    }
                                                                                    let _e2423 = phi_2665_;
                                                                                    let _e2425 = phi_2666_;
                                                                                    phi_2667_ = _e2423;
                                                                                    phi_2668_ = _e2425;
                                                                                } else {
                                                                                    phi_2667_ = bool();
                                                                                    phi_2668_ = true;
                                                                                }
                                                                                let _e2427 = phi_2667_;
                                                                                let _e2429 = phi_2668_;
                                                                                if _e2429 {
                                                                                    phi_2672_ = false;
                                                                                } else {
                                                                                    phi_2672_ = _e2427;
                                                                                }
                                                                                let _e2431 = phi_2672_;
                                                                                phi_2673_ = _e2431;
                                                                            }
                                                                            let _e2433 = phi_2673_;
                                                                            if _e2433 {
                                                                                let _e2435 = triangles.member[(0u + _e1953)].i0_;
                                                                                if ((_e2435 & 2147483648u) == 0u) {
                                                                                    phi_2687_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2687_ = true;
                                                                                }
                                                                                let _e2439 = phi_2687_;
                                                                                if _e2439 {
                                                                                    phi_2695_ = lt_bvh_Hit(_e2401.t, _e2401.u, _e2401.v, _e1953, _e968);
                                                                                } else {
                                                                                    phi_2695_ = _e1942;
                                                                                }
                                                                                let _e2445 = phi_2695_;
                                                                                phi_2696_ = _e2445;
                                                                            } else {
                                                                                phi_2696_ = _e1942;
                                                                            }
                                                                            let _e2447 = phi_2696_;
                                                                            phi_2697_ = _e2447;
                                                                        } else {
                                                                            phi_2697_ = _e1942;
                                                                        }
                                                                        let _e2449 = phi_2697_;
                                                                        phi_2698_ = _e2449;
                                                                    } else {
                                                                        phi_2698_ = _e1942;
                                                                    }
                                                                    let _e2451 = phi_2698_;
                                                                    phi_2055_ = _e2451;
                                                                    phi_2058_ = (_e1944 & (_e1944 - 1u));
                                                                    phi_2699_ = true;
                                                                }
                                                                let _e2453 = phi_2055_;
                                                                let _e2455 = phi_2058_;
                                                                let _e2457 = phi_2699_;
                                                                continue;
                                                                continuing {
                                                                    phi_2054_ = _e2453;
                                                                    phi_2057_ = _e2455;
                                                                    break if !(_e2457);
                                                                }
                                                            }
                                                            let _e2460 = local.group_mask;
                                                            if ((_e2460 & 4278190080u) == 0u) {
                                                                let _e2464 = local.len;
                                                                if (_e2464 == 0u) {
                                                                    phi_2738_ = false;
                                                                } else {
                                                                    let _e2468 = local.len;
                                                                    local.len = (_e2468 - 1u);
                                                                    let _e2471 = local.len;
                                                                    if (_e2471 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2476 = local.first[(0u + _e2471)];
                                                                    local.group = _e2476;
                                                                    let _e2479 = local.len;
                                                                    if (_e2479 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2484 = local.mask[(0u + _e2479)];
                                                                    local.group_mask = _e2484;
                                                                    phi_2738_ = true;
                                                                }
                                                                let _e2487 = phi_2738_;
                                                                phi_2739_ = _e2487;
                                                            } else {
                                                                phi_2739_ = true;
                                                            }
                                                            let _e2489 = phi_2739_;
                                                            if _e2489 {
                                                                let _e2491 = local.group_mask;
                                                                let _e2497 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2491)), 32u, (_e2491 == 0u)));
                                                                let _e2501 = local.group_mask;
                                                                let _e2515 = local.group_mask;
                                                                local.group_mask = (_e2515 & ~((1u << bitcast<u32>((_e2497 & 31u)))));
                                                                let _e2518 = local.group;
                                                                phi_2770_ = (_e2518 + countOneBits(((_e2501 & ~((4294967295u << bitcast<u32>((((_e2497 - 24u) ^ _e1365) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2770_ = 4294967295u;
                                                            }
                                                            let _e2521 = phi_2770_;
                                                            let _e3507 = local_8;
                                                            phi_1722_ = _e3507;
                                                            phi_1725_ = _e2521;
                                                        } else {
                                                            phi_1722_ = lt_bvh_Hit();
                                                            phi_1725_ = u32();
                                                        }
                                                        let _e2523 = phi_1722_;
                                                        let _e2525 = phi_1725_;
                                                        continue;
                                                        continuing {
                                                            phi_1721_ = _e2523;
                                                            phi_1724_ = _e2525;
                                                            break if !(_e1506);
                                                        }
                                                    }
                                                    let _e3511 = local_9;
                                                    phi_2771_ = _e3511;
                                                }
                                                let _e2528 = phi_2771_;
                                                phi_2772_ = _e2528;
                                                phi_2773_ = _e1191;
                                            } else {
                                                phi_2772_ = lt_bvh_Hit();
                                                phi_2773_ = true;
                                            }
                                            let _e2530 = phi_2772_;
                                            let _e2532 = phi_2773_;
                                            if _e2532 {
                                                phi_2777_ = _e960;
                                            } else {
                                                phi_2777_ = _e2530;
                                            }
                                            let _e2534 = phi_2777_;
                                            phi_2778_ = _e2534;
                                        } else {
                                            phi_2778_ = _e960;
                                        }
                                        let _e2536 = phi_2778_;
                                        phi_2779_ = _e2536;
                                    } else {
                                        phi_2779_ = _e960;
                                    }
                                    let _e2538 = phi_2779_;
                                    phi_2780_ = _e2538;
                                } else {
                                    phi_2780_ = _e960;
                                }
                                let _e2540 = phi_2780_;
                                phi_1096_ = (_e958 & (_e958 - 1u));
                                phi_1099_ = _e2540;
                                phi_2781_ = true;
                            }
                            let _e2542 = phi_1096_;
                            let _e2544 = phi_1099_;
                            let _e2546 = phi_2781_;
                            continue;
                            continuing {
                                phi_1095_ = _e2542;
                                phi_1098_ = _e2544;
                                break if !(_e2546);
                            }
                        }
                        let _e2549 = local_1.group_mask;
                        if ((_e2549 & 4278190080u) == 0u) {
                            let _e2553 = local_1.len;
                            if (_e2553 == 0u) {
                                phi_2820_ = false;
                            } else {
                                let _e2557 = local_1.len;
                                local_1.len = (_e2557 - 1u);
                                let _e2560 = local_1.len;
                                if (_e2560 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2565 = local_1.first[(0u + _e2560)];
                                local_1.group = _e2565;
                                let _e2568 = local_1.len;
                                if (_e2568 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2573 = local_1.mask[(0u + _e2568)];
                                local_1.group_mask = _e2573;
                                phi_2820_ = true;
                            }
                            let _e2576 = phi_2820_;
                            phi_2821_ = _e2576;
                        } else {
                            phi_2821_ = true;
                        }
                        let _e2578 = phi_2821_;
                        if _e2578 {
                            let _e2580 = local_1.group_mask;
                            let _e2586 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2580)), 32u, (_e2580 == 0u)));
                            let _e2590 = local_1.group_mask;
                            let _e2604 = local_1.group_mask;
                            local_1.group_mask = (_e2604 & ~((1u << bitcast<u32>((_e2586 & 31u)))));
                            let _e2607 = local_1.group;
                            phi_2852_ = (_e2607 + countOneBits(((_e2590 & ~((4294967295u << bitcast<u32>((((_e2586 - 24u) ^ _e377) & 31u))))) & 255u)));
                        } else {
                            phi_2852_ = 4294967295u;
                        }
                        let _e2610 = phi_2852_;
                        phi_759_ = _e2610;
                        let _e3527 = local_10;
                        phi_762_ = _e3527;
                    } else {
                        phi_759_ = u32();
                        phi_762_ = lt_bvh_Hit();
                    }
                    let _e2612 = phi_759_;
                    let _e2614 = phi_762_;
                    continue;
                    continuing {
                        phi_758_ = _e2612;
                        phi_761_ = _e2614;
                        break if !(_e518);
                    }
                }
                let _e3530 = local_11;
                phi_2853_ = _e3530;
            }
            let _e2617 = phi_2853_;
            phi_2854_ = _e2617;
            phi_2855_ = _e217;
        } else {
            phi_2854_ = lt_bvh_Hit();
            phi_2855_ = true;
        }
        let _e2619 = phi_2854_;
        let _e2621 = phi_2855_;
        if _e2621 {
            phi_2859_ = _e147;
        } else {
            phi_2859_ = _e2619;
        }
        let _e2623 = phi_2859_;
        if (_e2623.triangle != 4294967295u) {
            let _e2629 = ((1f - _e2623.u) - _e2623.v);
            if (_e2623.triangle < _e70) {
            } else {
                return;
            }
            let _e2635 = triangles.member[(0u + _e2623.triangle)];
            if (_e2623.instance < _e82) {
            } else {
                return;
            }
            let _e2646 = instances.member[(0u + _e2623.instance)].object_to_world[0u];
            let _e2657 = ((((_e2646.x * _e2635.v0_.x) + (_e2646.y * _e2635.v0_.y)) + (_e2646.z * _e2635.v0_.z)) + (_e2646.w * 1f));
            let _e2659 = instances.member[(0u + _e2623.instance)].object_to_world[1u];
            let _e2670 = ((((_e2659.x * _e2635.v0_.x) + (_e2659.y * _e2635.v0_.y)) + (_e2659.z * _e2635.v0_.z)) + (_e2659.w * 1f));
            let _e2672 = instances.member[(0u + _e2623.instance)].object_to_world[2u];
            let _e2683 = ((((_e2672.x * _e2635.v0_.x) + (_e2672.y * _e2635.v0_.y)) + (_e2672.z * _e2635.v0_.z)) + (_e2672.w * 1f));
            let _e2690 = instances.member[(0u + _e2623.instance)].object_to_world[0u];
            let _e2701 = ((((_e2690.x * _e2635.v1_.x) + (_e2690.y * _e2635.v1_.y)) + (_e2690.z * _e2635.v1_.z)) + (_e2690.w * 1f));
            let _e2703 = instances.member[(0u + _e2623.instance)].object_to_world[1u];
            let _e2714 = ((((_e2703.x * _e2635.v1_.x) + (_e2703.y * _e2635.v1_.y)) + (_e2703.z * _e2635.v1_.z)) + (_e2703.w * 1f));
            let _e2716 = instances.member[(0u + _e2623.instance)].object_to_world[2u];
            let _e2727 = ((((_e2716.x * _e2635.v1_.x) + (_e2716.y * _e2635.v1_.y)) + (_e2716.z * _e2635.v1_.z)) + (_e2716.w * 1f));
            let _e2734 = instances.member[(0u + _e2623.instance)].object_to_world[0u];
            let _e2745 = ((((_e2734.x * _e2635.v2_.x) + (_e2734.y * _e2635.v2_.y)) + (_e2734.z * _e2635.v2_.z)) + (_e2734.w * 1f));
            let _e2747 = instances.member[(0u + _e2623.instance)].object_to_world[1u];
            let _e2758 = ((((_e2747.x * _e2635.v2_.x) + (_e2747.y * _e2635.v2_.y)) + (_e2747.z * _e2635.v2_.z)) + (_e2747.w * 1f));
            let _e2760 = instances.member[(0u + _e2623.instance)].object_to_world[2u];
            let _e2771 = ((((_e2760.x * _e2635.v2_.x) + (_e2760.y * _e2635.v2_.y)) + (_e2760.z * _e2635.v2_.z)) + (_e2760.w * 1f));
            let _e2784 = (((_e2657 * _e2629) + (_e2701 * _e2623.u)) + (_e2745 * _e2623.v));
            let _e2785 = (((_e2670 * _e2629) + (_e2714 * _e2623.u)) + (_e2758 * _e2623.v));
            let _e2786 = (((_e2683 * _e2629) + (_e2727 * _e2623.u)) + (_e2771 * _e2623.v));
            let _e2788 = abs(_e2657);
            let _e2789 = abs(_e2670);
            let _e2790 = abs(_e2683);
            let _e2791 = abs(_e2701);
            let _e2792 = abs(_e2714);
            let _e2793 = abs(_e2727);
            if (_e2788 > _e2791) {
                phi_3047_ = _e2788;
            } else {
                phi_3047_ = _e2791;
            }
            let _e2796 = phi_3047_;
            if (_e2789 > _e2792) {
                phi_3052_ = _e2789;
            } else {
                phi_3052_ = _e2792;
            }
            let _e2799 = phi_3052_;
            if (_e2790 > _e2793) {
                phi_3057_ = _e2790;
            } else {
                phi_3057_ = _e2793;
            }
            let _e2802 = phi_3057_;
            let _e2803 = abs(_e2745);
            let _e2804 = abs(_e2758);
            let _e2805 = abs(_e2771);
            if (_e2796 > _e2803) {
                phi_3065_ = _e2796;
            } else {
                phi_3065_ = _e2803;
            }
            let _e2808 = phi_3065_;
            if (_e2799 > _e2804) {
                phi_3070_ = _e2799;
            } else {
                phi_3070_ = _e2804;
            }
            let _e2811 = phi_3070_;
            if (_e2802 > _e2805) {
                phi_3075_ = _e2802;
            } else {
                phi_3075_ = _e2805;
            }
            let _e2814 = phi_3075_;
            let _e2815 = (_e2701 - _e2657);
            let _e2816 = (_e2714 - _e2670);
            let _e2817 = (_e2727 - _e2683);
            let _e2818 = (_e2745 - _e2657);
            let _e2819 = (_e2758 - _e2670);
            let _e2820 = (_e2771 - _e2683);
            let _e2824 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2816), abs(_e2817));
            let _e2825 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2815), _e2824);
            let _e2826 = (_e2815 / _e2825);
            let _e2827 = (_e2816 / _e2825);
            let _e2828 = (_e2817 / _e2825);
            let _e2832 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2819), abs(_e2820));
            let _e2833 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2818), _e2832);
            let _e2834 = (_e2818 / _e2833);
            let _e2835 = (_e2819 / _e2833);
            let _e2836 = (_e2820 / _e2833);
            let _e2839 = ((_e2827 * _e2836) - (_e2835 * _e2828));
            let _e2842 = ((_e2828 * _e2834) - (_e2836 * _e2826));
            let _e2845 = ((_e2826 * _e2835) - (_e2834 * _e2827));
            let _e2847 = p.member.eye;
            let _e2860 = (1f / sqrt((((_e2839 * _e2839) + (_e2842 * _e2842)) + (_e2845 * _e2845))));
            let _e2861 = (_e2839 * _e2860);
            let _e2862 = (_e2842 * _e2860);
            let _e2863 = (_e2845 * _e2860);
            if ((((_e2861 * (_e2847.x - _e2784)) + (_e2862 * (_e2847.y - _e2785))) + (_e2863 * (_e2847.z - _e2786))) < 0f) {
                phi_3139_ = vec3<f32>(-(_e2861), -(_e2862), -(_e2863));
            } else {
                phi_3139_ = vec3<f32>(_e2861, _e2862, _e2863);
            }
            let _e2876 = phi_3139_;
            if (_e2623.triangle < _e70) {
            } else {
                return;
            }
            let _e2881 = triangles.member[(0u + _e2623.triangle)];
            let _e2883 = (_e2881.i0_ & 2147483647u);
            if (_e2883 < _e73) {
            } else {
                return;
            }
            let _e2889 = vertices.member[(0u + _e2883)];
            if (_e2881.i1_ < _e73) {
            } else {
                return;
            }
            let _e2893 = vertices.member[(0u + _e2881.i1_)];
            if (_e2881.i2_ < _e73) {
            } else {
                return;
            }
            let _e2897 = vertices.member[(0u + _e2881.i2_)];
            let _e2898 = array<abi_Vertex, 3>(_e2889, _e2893, _e2897);
            if (_e2898[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2904 = materials.member[(0u + _e2898[0].material)];
            let _e2921 = (1f / 255f);
            let _e2940 = (1f / 255f);
            let _e2962 = (1f / 255f);
            let _e2975 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2629, _e2623.u, _e2623.v));
            let _e2977 = ((_e2904.base_color.x * ((((f32((_e2898[0].color & 255u)) * _e2921) * _e2629) + ((f32((_e2898[1].color & 255u)) * _e2940) * _e2623.u)) + ((f32((_e2898[2].color & 255u)) * _e2962) * _e2623.v))) * _e2975.x);
            let _e2979 = ((_e2904.base_color.y * ((((f32(((_e2898[0].color >> bitcast<u32>(8i)) & 255u)) * _e2921) * _e2629) + ((f32(((_e2898[1].color >> bitcast<u32>(8i)) & 255u)) * _e2940) * _e2623.u)) + ((f32(((_e2898[2].color >> bitcast<u32>(8i)) & 255u)) * _e2962) * _e2623.v))) * _e2975.y);
            let _e2981 = ((_e2904.base_color.z * ((((f32(((_e2898[0].color >> bitcast<u32>(16i)) & 255u)) * _e2921) * _e2629) + ((f32(((_e2898[1].color >> bitcast<u32>(16i)) & 255u)) * _e2940) * _e2623.u)) + ((f32(((_e2898[2].color >> bitcast<u32>(16i)) & 255u)) * _e2962) * _e2623.v))) * _e2975.z);
            let _e2982 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2811, _e2814);
            let _e2983 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2808, _e2982);
            if ((_e2904.flags & 2u) == 0u) {
                phi_3260_ = 0u;
            } else {
                phi_3260_ = 1u;
            }
            let _e2988 = phi_3260_;
            if (_e2898[0].normal == 2147516416u) {
                phi_3490_ = _e2876;
            } else {
                let _e3001 = (f32((bitcast<i32>((_e2898[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3007 = (f32((bitcast<i32>(_e2898[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3011 = ((1f - abs(_e3001)) - abs(_e3007));
                if (_e3011 < 0f) {
                    phi_3287_ = -(_e3011);
                } else {
                    phi_3287_ = 0f;
                }
                let _e3015 = phi_3287_;
                if (_e3001 < 0f) {
                    phi_3294_ = (_e3001 + _e3015);
                } else {
                    phi_3294_ = (_e3001 - _e3015);
                }
                let _e3020 = phi_3294_;
                if (_e3007 < 0f) {
                    phi_3301_ = (_e3007 + _e3015);
                } else {
                    phi_3301_ = (_e3007 - _e3015);
                }
                let _e3025 = phi_3301_;
                let _e3032 = (1f / sqrt((((_e3020 * _e3020) + (_e3025 * _e3025)) + (_e3011 * _e3011))));
                let _e3048 = (f32((bitcast<i32>((_e2898[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3054 = (f32((bitcast<i32>(_e2898[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3058 = ((1f - abs(_e3048)) - abs(_e3054));
                if (_e3058 < 0f) {
                    phi_3336_ = -(_e3058);
                } else {
                    phi_3336_ = 0f;
                }
                let _e3062 = phi_3336_;
                if (_e3048 < 0f) {
                    phi_3343_ = (_e3048 + _e3062);
                } else {
                    phi_3343_ = (_e3048 - _e3062);
                }
                let _e3067 = phi_3343_;
                if (_e3054 < 0f) {
                    phi_3350_ = (_e3054 + _e3062);
                } else {
                    phi_3350_ = (_e3054 - _e3062);
                }
                let _e3072 = phi_3350_;
                let _e3079 = (1f / sqrt((((_e3067 * _e3067) + (_e3072 * _e3072)) + (_e3058 * _e3058))));
                let _e3098 = (f32((bitcast<i32>((_e2898[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3104 = (f32((bitcast<i32>(_e2898[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3108 = ((1f - abs(_e3098)) - abs(_e3104));
                if (_e3108 < 0f) {
                    phi_3388_ = -(_e3108);
                } else {
                    phi_3388_ = 0f;
                }
                let _e3112 = phi_3388_;
                if (_e3098 < 0f) {
                    phi_3395_ = (_e3098 + _e3112);
                } else {
                    phi_3395_ = (_e3098 - _e3112);
                }
                let _e3117 = phi_3395_;
                if (_e3104 < 0f) {
                    phi_3402_ = (_e3104 + _e3112);
                } else {
                    phi_3402_ = (_e3104 - _e3112);
                }
                let _e3122 = phi_3402_;
                let _e3129 = (1f / sqrt((((_e3117 * _e3117) + (_e3122 * _e3122)) + (_e3108 * _e3108))));
                let _e3136 = ((((_e3020 * _e3032) * _e2629) + ((_e3067 * _e3079) * _e2623.u)) + ((_e3117 * _e3129) * _e2623.v));
                let _e3137 = ((((_e3025 * _e3032) * _e2629) + ((_e3072 * _e3079) * _e2623.u)) + ((_e3122 * _e3129) * _e2623.v));
                let _e3138 = ((((_e3011 * _e3032) * _e2629) + ((_e3058 * _e3079) * _e2623.u)) + ((_e3108 * _e3129) * _e2623.v));
                if (_e2623.instance < _e82) {
                } else {
                    return;
                }
                let _e3145 = instances.member[(0u + _e2623.instance)].world_to_object[0u];
                let _e3154 = instances.member[(0u + _e2623.instance)].world_to_object[1u];
                let _e3166 = instances.member[(0u + _e2623.instance)].world_to_object[2u];
                let _e3173 = (((_e3145.x * _e3136) + (_e3154.x * _e3137)) + (_e3166.x * _e3138));
                let _e3174 = (((_e3145.y * _e3136) + (_e3154.y * _e3137)) + (_e3166.y * _e3138));
                let _e3175 = (((_e3145.z * _e3136) + (_e3154.z * _e3137)) + (_e3166.z * _e3138));
                let _e3181 = sqrt((((_e3173 * _e3173) + (_e3174 * _e3174)) + (_e3175 * _e3175)));
                if (_e3181 > 0f) {
                    let _e3183 = (_e3173 / _e3181);
                    let _e3184 = (_e3174 / _e3181);
                    let _e3185 = (_e3175 / _e3181);
                    if ((((_e3183 * _e2876.x) + (_e3184 * _e2876.y)) + (_e3185 * _e2876.z)) < 0f) {
                        phi_3488_ = vec3<f32>(-(_e3183), -(_e3184), -(_e3185));
                    } else {
                        phi_3488_ = vec3<f32>(_e3183, _e3184, _e3185);
                    }
                    let _e3201 = phi_3488_;
                    phi_3489_ = _e3201;
                } else {
                    phi_3489_ = _e2876;
                }
                let _e3203 = phi_3489_;
                phi_3490_ = _e3203;
            }
            let _e3205 = phi_3490_;
            if (_e2977 > 0f) {
                if (_e2977 < 1f) {
                    phi_3499_ = _e2977;
                } else {
                    phi_3499_ = 1f;
                }
                let _e3209 = phi_3499_;
                phi_3500_ = _e3209;
            } else {
                phi_3500_ = 0f;
            }
            let _e3211 = phi_3500_;
            if (_e2979 > 0f) {
                if (_e2979 < 1f) {
                    phi_3510_ = _e2979;
                } else {
                    phi_3510_ = 1f;
                }
                let _e3216 = phi_3510_;
                phi_3511_ = _e3216;
            } else {
                phi_3511_ = 0f;
            }
            let _e3218 = phi_3511_;
            if (_e2981 > 0f) {
                if (_e2981 < 1f) {
                    phi_3521_ = _e2981;
                } else {
                    phi_3521_ = 1f;
                }
                let _e3223 = phi_3521_;
                phi_3522_ = _e3223;
            } else {
                phi_3522_ = 0f;
            }
            let _e3225 = phi_3522_;
            let _e3228 = ((sqrt(_e3211) * 255f) + 0.5f);
            let _e3237 = ((sqrt(_e3218) * 255f) + 0.5f);
            let _e3249 = ((sqrt(_e3225) * 255f) + 0.5f);
            phi_3557_ = abi_Sample(vec3<f32>(_e2784, _e2785, _e2786), _e2983, _e2876, _e2988, _e3205, ((select(select(u32(_e3228), 0u, (_e3228 < bitcast<f32>(0u))), 4294967295u, (_e3228 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3237), 0u, (_e3237 < bitcast<f32>(0u))), 4294967295u, (_e3237 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3249), 0u, (_e3249 < bitcast<f32>(0u))), 4294967295u, (_e3249 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3557_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3263 = phi_3557_;
        if (_e88.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e88.shift)] = _e3263;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
