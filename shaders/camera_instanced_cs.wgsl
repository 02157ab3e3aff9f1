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
                let _e294 = phi_506_;
                if (_e145.direction.x < 0f) {
                    phi_513_ = (-1f / _e294);
                } else {
                    phi_513_ = (1f / _e294);
                }
                let _e299 = phi_513_;
                if (abs(_e145.direction.y) < _e287) {
                    phi_521_ = _e287;
                } else {
                    phi_521_ = abs(_e145.direction.y);
                }
                let _e306 = phi_521_;
                if (_e145.direction.y < 0f) {
                    phi_528_ = (-1f / _e306);
                } else {
                    phi_528_ = (1f / _e306);
                }
                let _e311 = phi_528_;
                if (abs(_e145.direction.z) < _e287) {
                    phi_536_ = _e287;
                } else {
                    phi_536_ = abs(_e145.direction.z);
                }
                let _e318 = phi_536_;
                if (_e145.direction.z < 0f) {
                    phi_543_ = (-1f / _e318);
                } else {
                    phi_543_ = (1f / _e318);
                }
                let _e323 = phi_543_;
                let _e331 = abs((bitcast<f32>(_e223) - _e145.origin.x));
                let _e332 = abs((bitcast<f32>(_e227) - _e145.origin.y));
                let _e333 = abs((bitcast<f32>(_e231) - _e145.origin.z));
                let _e341 = abs(((bitcast<f32>(_e235) + (bitcast<f32>((((_e247 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.x));
                let _e342 = abs(((bitcast<f32>(_e239) + (bitcast<f32>((((_e247 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.y));
                let _e343 = abs(((bitcast<f32>(_e243) + (bitcast<f32>((((_e247 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145.origin.z));
                if (_e331 > _e341) {
                    phi_568_ = _e331;
                } else {
                    phi_568_ = _e341;
                }
                let _e346 = phi_568_;
                if (_e332 > _e342) {
                    phi_573_ = _e332;
                } else {
                    phi_573_ = _e342;
                }
                let _e349 = phi_573_;
                if (_e333 > _e343) {
                    phi_578_ = _e333;
                } else {
                    phi_578_ = _e343;
                }
                let _e352 = phi_578_;
                let _e353 = core_intrinsics_maximum_number_nsz_f32_(_e346, _e349);
                let _e354 = core_intrinsics_maximum_number_nsz_f32_(_e353, _e352);
                let _e359 = (_e354 * 0.0000019073486f);
                let _e360 = (abs(_e299) * _e359);
                let _e361 = (abs(_e311) * _e359);
                let _e362 = (abs(_e323) * _e359);
                let _e366 = (_e354 * 0.0000009536743f);
                let _e367 = (abs(_e299) * _e366);
                let _e368 = (abs(_e311) * _e366);
                let _e369 = (abs(_e323) * _e366);
                if (_e299 < 0f) {
                    phi_600_ = 0u;
                } else {
                    phi_600_ = 1u;
                }
                let _e372 = phi_600_;
                if (_e311 < 0f) {
                    phi_605_ = 0u;
                } else {
                    phi_605_ = 2u;
                }
                let _e375 = phi_605_;
                if (_e323 < 0f) {
                    phi_610_ = 0u;
                } else {
                    phi_610_ = 4u;
                }
                let _e378 = phi_610_;
                let _e380 = ((_e372 | _e375) | _e378);
                let _e381 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e94, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e381.first[0], _e381.first[1], _e381.first[2], _e381.first[3], _e381.first[4], _e381.first[5], _e381.first[6], _e381.first[7], _e381.first[8], _e381.first[9], _e381.first[10], _e381.first[11], _e381.first[12], _e381.first[13], _e381.first[14], _e381.first[15], _e381.first[16], _e381.first[17], _e381.first[18], _e381.first[19], _e381.first[20], _e381.first[21], _e381.first[22], _e381.first[23], _e381.first[24], _e381.first[25], _e381.first[26], _e381.first[27], _e381.first[28], _e381.first[29], _e381.first[30], _e381.first[31]), array<u32, 32>(_e381.mask[0], _e381.mask[1], _e381.mask[2], _e381.mask[3], _e381.mask[4], _e381.mask[5], _e381.mask[6], _e381.mask[7], _e381.mask[8], _e381.mask[9], _e381.mask[10], _e381.mask[11], _e381.mask[12], _e381.mask[13], _e381.mask[14], _e381.mask[15], _e381.mask[16], _e381.mask[17], _e381.mask[18], _e381.mask[19], _e381.mask[20], _e381.mask[21], _e381.mask[22], _e381.mask[23], _e381.mask[24], _e381.mask[25], _e381.mask[26], _e381.mask[27], _e381.mask[28], _e381.mask[29], _e381.mask[30], _e381.mask[31]), _e381.len, _e381.group, _e381.group_mask);
                let _e455 = local_1.group_mask;
                if ((_e455 & 4278190080u) == 0u) {
                    let _e459 = local_1.len;
                    if (_e459 == 0u) {
                        phi_724_ = false;
                    } else {
                        let _e463 = local_1.len;
                        local_1.len = (_e463 - 1u);
                        let _e466 = local_1.len;
                        if (_e466 < 32u) {
                        } else {
                            return;
                        }
                        let _e471 = local_1.first[(0u + _e466)];
                        local_1.group = _e471;
                        let _e474 = local_1.len;
                        if (_e474 < 32u) {
                        } else {
                            return;
                        }
                        let _e479 = local_1.mask[(0u + _e474)];
                        local_1.group_mask = _e479;
                        phi_724_ = true;
                    }
                    let _e482 = phi_724_;
                    phi_725_ = _e482;
                } else {
                    phi_725_ = true;
                }
                let _e484 = phi_725_;
                if _e484 {
                    let _e486 = local_1.group_mask;
                    let _e492 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e486)), 32u, (_e486 == 0u)));
                    let _e496 = local_1.group_mask;
                    let _e510 = local_1.group_mask;
                    local_1.group_mask = (_e510 & ~((1u << bitcast<u32>((_e492 & 31u)))));
                    let _e513 = local_1.group;
                    phi_756_ = (_e513 + countOneBits(((_e496 & ~((4294967295u << bitcast<u32>((((_e492 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_756_ = 4294967295u;
                }
                let _e516 = phi_756_;
                phi_758_ = _e516;
                phi_761_ = _e147;
                loop {
                    let _e518 = phi_758_;
                    let _e520 = phi_761_;
                    local_11 = _e520;
                    let _e521 = (_e518 != 4294967295u);
                    if _e521 {
                        if (_e518 < _e67) {
                        } else {
                            return;
                        }
                        let _e529 = nodes.member[(0u + _e518)].frame[3u];
                        let _e554 = (bitcast<f32>((((_e529 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e299);
                        let _e555 = (bitcast<f32>((((_e529 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e311);
                        let _e556 = (bitcast<f32>((((_e529 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e323);
                        let _e559 = nodes.member[(0u + _e518)].frame[0u];
                        let _e563 = nodes.member[(0u + _e518)].frame[1u];
                        let _e567 = nodes.member[(0u + _e518)].frame[2u];
                        let _e575 = ((bitcast<f32>(_e559) - _e145.origin.x) * _e299);
                        let _e576 = ((bitcast<f32>(_e563) - _e145.origin.y) * _e311);
                        let _e577 = ((bitcast<f32>(_e567) - _e145.origin.z) * _e323);
                        let _e585 = nodes.member[(0u + _e518)].x;
                        if (_e299 < 0f) {
                            let _e596 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e585.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e602 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e596.unnamed.word, _e585.w), _e596.unnamed_1);
                            let _e608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e602.unnamed, lt_mask_LightPlace(_e585.x, _e602.unnamed_1.shift));
                            phi_846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e608.unnamed, lt_mask_LightPlace(_e608.unnamed_1.word, _e585.y));
                        } else {
                            let _e624 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e585.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e630 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e624.unnamed.word, _e585.y), _e624.unnamed_1);
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e630.unnamed, lt_mask_LightPlace(_e585.z, _e630.unnamed_1.shift));
                            phi_846_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e636.unnamed, lt_mask_LightPlace(_e636.unnamed_1.word, _e585.w));
                        }
                        let _e644 = phi_846_;
                        let _e654 = nodes.member[(0u + _e518)].y;
                        if (_e311 < 0f) {
                            let _e665 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e654.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e671 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e665.unnamed.word, _e654.w), _e665.unnamed_1);
                            let _e677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e671.unnamed, lt_mask_LightPlace(_e654.x, _e671.unnamed_1.shift));
                            phi_873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e677.unnamed, lt_mask_LightPlace(_e677.unnamed_1.word, _e654.y));
                        } else {
                            let _e693 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e654.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e699 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e693.unnamed.word, _e654.y), _e693.unnamed_1);
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e699.unnamed, lt_mask_LightPlace(_e654.z, _e699.unnamed_1.shift));
                            phi_873_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e705.unnamed, lt_mask_LightPlace(_e705.unnamed_1.word, _e654.w));
                        }
                        let _e713 = phi_873_;
                        let _e723 = nodes.member[(0u + _e518)].z;
                        if (_e323 < 0f) {
                            let _e734 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e723.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e740 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e734.unnamed.word, _e723.w), _e734.unnamed_1);
                            let _e746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e740.unnamed, lt_mask_LightPlace(_e723.x, _e740.unnamed_1.shift));
                            phi_900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e746.unnamed, lt_mask_LightPlace(_e746.unnamed_1.word, _e723.y));
                        } else {
                            let _e762 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e723.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e768 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e762.unnamed.word, _e723.y), _e762.unnamed_1);
                            let _e774 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e768.unnamed, lt_mask_LightPlace(_e723.z, _e768.unnamed_1.shift));
                            phi_900_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e774.unnamed, lt_mask_LightPlace(_e774.unnamed_1.word, _e723.w));
                        }
                        let _e782 = phi_900_;
                        phi_906_ = 0u;
                        phi_909_ = 0u;
                        loop {
                            let _e792 = phi_906_;
                            let _e794 = phi_909_;
                            local_2 = _e794;
                            local_3 = _e794;
                            local_4 = _e794;
                            let _e795 = (_e792 < 8u);
                            if _e795 {
                                let _e797 = (_e792 >> bitcast<u32>(2i));
                                let _e798 = (_e792 & 3u);
                                if (_e797 == 0u) {
                                    phi_923_ = _e644.unnamed.word;
                                } else {
                                    phi_923_ = _e644.unnamed.shift;
                                }
                                let _e801 = phi_923_;
                                if (_e797 == 0u) {
                                    phi_933_ = _e713.unnamed.word;
                                } else {
                                    phi_933_ = _e713.unnamed.shift;
                                }
                                let _e810 = phi_933_;
                                if (_e797 == 0u) {
                                    phi_943_ = _e782.unnamed.word;
                                } else {
                                    phi_943_ = _e782.unnamed.shift;
                                }
                                let _e819 = phi_943_;
                                let _e832 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e801 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e554) + (_e575 - _e360)), ((f32(((_e810 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e555) + (_e576 - _e361)));
                                let _e833 = core_intrinsics_maximum_number_nsz_f32_(_e832, ((f32(((_e819 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e556) + (_e577 - _e362)));
                                if (_e797 == 0u) {
                                    phi_961_ = _e644.unnamed_1.word;
                                } else {
                                    phi_961_ = _e644.unnamed_1.shift;
                                }
                                let _e836 = phi_961_;
                                if (_e797 == 0u) {
                                    phi_971_ = _e713.unnamed_1.word;
                                } else {
                                    phi_971_ = _e713.unnamed_1.shift;
                                }
                                let _e845 = phi_971_;
                                if (_e797 == 0u) {
                                    phi_981_ = _e782.unnamed_1.word;
                                } else {
                                    phi_981_ = _e782.unnamed_1.shift;
                                }
                                let _e854 = phi_981_;
                                let _e867 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e836 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e554) + (_e575 + _e360)), ((f32(((_e845 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e555) + (_e576 + _e361)));
                                let _e868 = core_intrinsics_minimum_number_nsz_f32_(_e867, ((f32(((_e854 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u)) * _e556) + (_e577 + _e362)));
                                if (_e833 <= _e868) {
                                    if (_e833 <= _e520.t) {
                                        if (_e868 >= _e145.tmin) {
                                            if (_e797 == 0u) {
                                                let _e875 = nodes.member[(0u + _e518)].links[2u];
                                                phi_1017_ = _e875;
                                            } else {
                                                let _e878 = nodes.member[(0u + _e518)].links[3u];
                                                phi_1017_ = _e878;
                                            }
                                            let _e880 = phi_1017_;
                                            let _e885 = ((_e880 >> bitcast<u32>(((_e798 * 8u) & 31u))) & 255u);
                                            let _e886 = (_e885 & 31u);
                                            if (_e886 >= 24u) {
                                                phi_1030_ = (24u + ((_e886 - 24u) ^ _e380));
                                            } else {
                                                phi_1030_ = _e886;
                                            }
                                            let _e892 = phi_1030_;
                                            phi_1035_ = (_e794 | ((_e885 >> bitcast<u32>(5i)) << bitcast<u32>((_e892 & 31u))));
                                        } else {
                                            phi_1035_ = _e794;
                                        }
                                        let _e900 = phi_1035_;
                                        phi_1036_ = _e900;
                                    } else {
                                        phi_1036_ = _e794;
                                    }
                                    let _e902 = phi_1036_;
                                    phi_1037_ = _e902;
                                } else {
                                    phi_1037_ = _e794;
                                }
                                let _e904 = phi_1037_;
                                phi_907_ = (_e792 + 1u);
                                phi_910_ = _e904;
                            } else {
                                phi_907_ = u32();
                                phi_910_ = u32();
                            }
                            let _e907 = phi_907_;
                            let _e909 = phi_910_;
                            continue;
                            continuing {
                                phi_906_ = _e907;
                                phi_909_ = _e909;
                                break if !(_e795);
                            }
                        }
                        let _e913 = nodes.member[(0u + _e518)].links[0u];
                        let _e917 = nodes.member[(0u + _e518)].frame[3u];
                        let _e921 = local_2;
                        if ((_e921 & 4278190080u) == 0u) {
                        } else {
                            let _e925 = local_1.group_mask;
                            if ((_e925 & 4278190080u) == 0u) {
                            } else {
                                let _e929 = local_1.len;
                                if (_e929 < 32u) {
                                    let _e932 = local_1.group;
                                    let _e934 = local_1.len;
                                    if (_e934 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e934)] = _e932;
                                    let _e940 = local_1.group_mask;
                                    let _e942 = local_1.len;
                                    if (_e942 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e942)] = _e940;
                                    let _e949 = local_1.len;
                                    local_1.len = (_e949 + 1u);
                                }
                            }
                            local_1.group = (_e94 + _e913);
                            let _e953 = local_3;
                            local_1.group_mask = ((_e953 & 4278190080u) | (_e917 >> bitcast<u32>(24i)));
                        }
                        let _e958 = local_4;
                        phi_1095_ = (_e958 & 16777215u);
                        phi_1098_ = _e520;
                        loop {
                            let _e961 = phi_1095_;
                            let _e963 = phi_1098_;
                            local_10 = _e963;
                            if (_e961 == 0u) {
                                phi_1096_ = u32();
                                phi_1099_ = lt_bvh_Hit();
                                phi_2781_ = false;
                            } else {
                                let _e967 = nodes.member[(0u + _e518)].links[1u];
                                let _e971 = (_e967 + select(firstTrailingBit(_e961), 32u, (_e961 == 0u)));
                                if (_e971 < _e82) {
                                } else {
                                    return;
                                }
                                let _e978 = instances.member[(0u + _e971)].low_world;
                                let _e980 = instances.member[(0u + _e971)].high_world;
                                let _e990 = ((_e978.x - _e145.origin.x) * _e299);
                                let _e991 = ((_e978.y - _e145.origin.y) * _e311);
                                let _e992 = ((_e978.z - _e145.origin.z) * _e323);
                                let _e1002 = ((_e980.x - _e145.origin.x) * _e299);
                                let _e1003 = ((_e980.y - _e145.origin.y) * _e311);
                                let _e1004 = ((_e980.z - _e145.origin.z) * _e323);
                                if (_e990 < _e1002) {
                                    phi_1153_ = _e990;
                                } else {
                                    phi_1153_ = _e1002;
                                }
                                let _e1007 = phi_1153_;
                                if (_e991 < _e1003) {
                                    phi_1158_ = _e991;
                                } else {
                                    phi_1158_ = _e1003;
                                }
                                let _e1010 = phi_1158_;
                                if (_e992 < _e1004) {
                                    phi_1163_ = _e992;
                                } else {
                                    phi_1163_ = _e1004;
                                }
                                let _e1013 = phi_1163_;
                                if (_e990 > _e1002) {
                                    phi_1171_ = _e990;
                                } else {
                                    phi_1171_ = _e1002;
                                }
                                let _e1019 = phi_1171_;
                                if (_e991 > _e1003) {
                                    phi_1176_ = _e991;
                                } else {
                                    phi_1176_ = _e1003;
                                }
                                let _e1022 = phi_1176_;
                                if (_e992 > _e1004) {
                                    phi_1181_ = _e992;
                                } else {
                                    phi_1181_ = _e1004;
                                }
                                let _e1025 = phi_1181_;
                                let _e1029 = core_intrinsics_maximum_number_nsz_f32_((_e1007 - _e367), (_e1010 - _e368));
                                let _e1030 = core_intrinsics_maximum_number_nsz_f32_(_e1029, (_e1013 - _e369));
                                let _e1031 = core_intrinsics_minimum_number_nsz_f32_((_e1019 + _e367), (_e1022 + _e368));
                                let _e1032 = core_intrinsics_minimum_number_nsz_f32_(_e1031, (_e1025 + _e369));
                                if (_e1030 <= _e1032) {
                                    if (_e1030 <= _e963.t) {
                                        if (_e1032 >= _e145.tmin) {
                                            let _e1044 = instances.member[(0u + _e971)].world_to_object[0u];
                                            let _e1055 = ((((_e1044.x * _e145.origin.x) + (_e1044.y * _e145.origin.y)) + (_e1044.z * _e145.origin.z)) + (_e1044.w * 1f));
                                            let _e1057 = instances.member[(0u + _e971)].world_to_object[1u];
                                            let _e1068 = ((((_e1057.x * _e145.origin.x) + (_e1057.y * _e145.origin.y)) + (_e1057.z * _e145.origin.z)) + (_e1057.w * 1f));
                                            let _e1070 = instances.member[(0u + _e971)].world_to_object[2u];
                                            let _e1081 = ((((_e1070.x * _e145.origin.x) + (_e1070.y * _e145.origin.y)) + (_e1070.z * _e145.origin.z)) + (_e1070.w * 1f));
                                            let _e1088 = instances.member[(0u + _e971)].world_to_object[0u];
                                            let _e1099 = ((((_e1088.x * _e145.direction.x) + (_e1088.y * _e145.direction.y)) + (_e1088.z * _e145.direction.z)) + (_e1088.w * 0f));
                                            let _e1101 = instances.member[(0u + _e971)].world_to_object[1u];
                                            let _e1112 = ((((_e1101.x * _e145.direction.x) + (_e1101.y * _e145.direction.y)) + (_e1101.z * _e145.direction.z)) + (_e1101.w * 0f));
                                            let _e1114 = instances.member[(0u + _e971)].world_to_object[2u];
                                            let _e1125 = ((((_e1114.x * _e145.direction.x) + (_e1114.y * _e145.direction.y)) + (_e1114.z * _e145.direction.z)) + (_e1114.w * 0f));
                                            let _e1130 = instances.member[(0u + _e971)].root;
                                            let _e1132 = instances.member[(0u + _e971)].first_triangle;
                                            let _e1136 = abs(_e1099);
                                            let _e1137 = abs(_e1112);
                                            let _e1138 = abs(_e1125);
                                            if (abs(_e1055) < 1000000000000000f) {
                                                if (abs(_e1068) < 1000000000000000f) {
                                                    if (abs(_e1081) < 1000000000000000f) {
                                                        if (_e1136 < 1000000000000000f) {
                                                            if (_e1137 < 1000000000000000f) {
                                                                if (_e1138 < 1000000000000000f) {
                                                                    if (_e1136 > 0f) {
                                                                        phi_1338_ = bool();
                                                                        phi_1339_ = true;
                                                                    } else {
                                                                        let _e1146 = (_e1137 > 0f);
                                                                        if _e1146 {
                                                                            phi_1337_ = bool();
                                                                        } else {
                                                                            phi_1337_ = (_e1138 > 0f);
                                                                        }
                                                                        let _e1149 = phi_1337_;
                                                                        phi_1338_ = _e1149;
                                                                        phi_1339_ = _e1146;
                                                                    }
                                                                    let _e1151 = phi_1338_;
                                                                    let _e1153 = phi_1339_;
                                                                    if _e1153 {
                                                                        phi_1343_ = true;
                                                                    } else {
                                                                        phi_1343_ = _e1151;
                                                                    }
                                                                    let _e1155 = phi_1343_;
                                                                    phi_1344_ = _e1155;
                                                                    phi_1345_ = false;
                                                                } else {
                                                                    phi_1344_ = bool();
                                                                    phi_1345_ = true;
                                                                }
                                                                let _e1157 = phi_1344_;
                                                                let _e1159 = phi_1345_;
                                                                phi_1346_ = _e1157;
                                                                phi_1347_ = false;
                                                                phi_1348_ = _e1159;
                                                            } else {
                                                                phi_1346_ = bool();
                                                                phi_1347_ = true;
                                                                phi_1348_ = false;
                                                            }
                                                            let _e1161 = phi_1346_;
                                                            let _e1163 = phi_1347_;
                                                            let _e1165 = phi_1348_;
                                                            phi_1349_ = _e1161;
                                                            phi_1350_ = _e1163;
                                                            phi_1351_ = _e1165;
                                                        } else {
                                                            phi_1349_ = bool();
                                                            phi_1350_ = true;
                                                            phi_1351_ = false;
                                                        }
                                                        let _e1167 = phi_1349_;
                                                        let _e1169 = phi_1350_;
                                                        let _e1171 = phi_1351_;
                                                        phi_1352_ = _e1167;
                                                        phi_1353_ = _e1169;
                                                        phi_1354_ = _e1171;
                                                    } else {
                                                        phi_1352_ = bool();
                                                        phi_1353_ = true;
                                                        phi_1354_ = false;
                                                    }
                                                    let _e1173 = phi_1352_;
                                                    let _e1175 = phi_1353_;
                                                    let _e1177 = phi_1354_;
                                                    phi_1355_ = _e1173;
                                                    phi_1356_ = _e1175;
                                                    phi_1357_ = _e1177;
                                                } else {
                                                    phi_1355_ = bool();
                                                    phi_1356_ = true;
                                                    phi_1357_ = false;
                                                }
                                                let _e1179 = phi_1355_;
                                                let _e1181 = phi_1356_;
                                                let _e1183 = phi_1357_;
                                                phi_1358_ = _e1179;
                                                phi_1359_ = _e1181;
                                                phi_1360_ = _e1183;
                                            } else {
                                                phi_1358_ = bool();
                                                phi_1359_ = true;
                                                phi_1360_ = false;
                                            }
                                            let _e1185 = phi_1358_;
                                            let _e1187 = phi_1359_;
                                            let _e1189 = phi_1360_;
                                            if _e1187 {
                                                phi_1364_ = true;
                                            } else {
                                                phi_1364_ = _e1189;
                                            }
                                            let _e1191 = phi_1364_;
                                            if _e1191 {
                                                phi_1368_ = false;
                                            } else {
                                                phi_1368_ = _e1185;
                                            }
                                            let _e1193 = phi_1368_;
                                            if _e1193 {
                                                let _e1194 = (_e1130 >= _e67);
                                                if _e1194 {
                                                    phi_2771_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1130 < _e67) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1200 = nodes.member[(0u + _e1130)].frame[0u];
                                                    let _e1204 = nodes.member[(0u + _e1130)].frame[1u];
                                                    let _e1208 = nodes.member[(0u + _e1130)].frame[2u];
                                                    let _e1212 = nodes.member[(0u + _e1130)].frame[0u];
                                                    let _e1216 = nodes.member[(0u + _e1130)].frame[1u];
                                                    let _e1220 = nodes.member[(0u + _e1130)].frame[2u];
                                                    let _e1224 = nodes.member[(0u + _e1130)].frame[3u];
                                                    let _e1258 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1099), abs(_e1112));
                                                    let _e1259 = core_intrinsics_maximum_number_nsz_f32_(_e1258, abs(_e1125));
                                                    let _e1260 = (_e1259 * 0.0000000000009094947f);
                                                    if (abs(_e1099) < _e1260) {
                                                        phi_1438_ = _e1260;
                                                    } else {
                                                        phi_1438_ = abs(_e1099);
                                                    }
                                                    let _e1265 = phi_1438_;
                                                    if (_e1099 < 0f) {
                                                        phi_1445_ = (-1f / _e1265);
                                                    } else {
                                                        phi_1445_ = (1f / _e1265);
                                                    }
                                                    let _e1270 = phi_1445_;
                                                    if (abs(_e1112) < _e1260) {
                                                        phi_1452_ = _e1260;
                                                    } else {
                                                        phi_1452_ = abs(_e1112);
                                                    }
                                                    let _e1275 = phi_1452_;
                                                    if (_e1112 < 0f) {
                                                        phi_1459_ = (-1f / _e1275);
                                                    } else {
                                                        phi_1459_ = (1f / _e1275);
                                                    }
                                                    let _e1280 = phi_1459_;
                                                    if (abs(_e1125) < _e1260) {
                                                        phi_1466_ = _e1260;
                                                    } else {
                                                        phi_1466_ = abs(_e1125);
                                                    }
                                                    let _e1285 = phi_1466_;
                                                    if (_e1125 < 0f) {
                                                        phi_1473_ = (-1f / _e1285);
                                                    } else {
                                                        phi_1473_ = (1f / _e1285);
                                                    }
                                                    let _e1290 = phi_1473_;
                                                    let _e1294 = abs((bitcast<f32>(_e1200) - _e1055));
                                                    let _e1295 = abs((bitcast<f32>(_e1204) - _e1068));
                                                    let _e1296 = abs((bitcast<f32>(_e1208) - _e1081));
                                                    let _e1300 = abs(((bitcast<f32>(_e1212) + (bitcast<f32>((((_e1224 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1055));
                                                    let _e1301 = abs(((bitcast<f32>(_e1216) + (bitcast<f32>((((_e1224 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1068));
                                                    let _e1302 = abs(((bitcast<f32>(_e1220) + (bitcast<f32>((((_e1224 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1081));
                                                    if (_e1294 > _e1300) {
                                                        phi_1490_ = _e1294;
                                                    } else {
                                                        phi_1490_ = _e1300;
                                                    }
                                                    let _e1305 = phi_1490_;
                                                    if (_e1295 > _e1301) {
                                                        phi_1495_ = _e1295;
                                                    } else {
                                                        phi_1495_ = _e1301;
                                                    }
                                                    let _e1308 = phi_1495_;
                                                    if (_e1296 > _e1302) {
                                                        phi_1500_ = _e1296;
                                                    } else {
                                                        phi_1500_ = _e1302;
                                                    }
                                                    let _e1311 = phi_1500_;
                                                    let _e1312 = core_intrinsics_maximum_number_nsz_f32_(_e1305, _e1308);
                                                    let _e1313 = core_intrinsics_maximum_number_nsz_f32_(_e1312, _e1311);
                                                    let _e1317 = (_e1313 * 0.0000019073486f);
                                                    let _e1318 = (abs(_e1270) * _e1317);
                                                    let _e1319 = (abs(_e1280) * _e1317);
                                                    let _e1320 = (abs(_e1290) * _e1317);
                                                    let _e1324 = (_e1313 * 0.0000009536743f);
                                                    let _e1325 = (abs(_e1270) * _e1324);
                                                    let _e1326 = (abs(_e1280) * _e1324);
                                                    let _e1327 = (abs(_e1290) * _e1324);
                                                    let _e1328 = abs(_e1099);
                                                    let _e1329 = abs(_e1112);
                                                    let _e1330 = abs(_e1125);
                                                    if (_e1328 >= _e1329) {
                                                        if (_e1328 >= _e1330) {
                                                            phi_1528_ = false;
                                                        } else {
                                                            phi_1528_ = true;
                                                        }
                                                        let _e1334 = phi_1528_;
                                                        phi_1529_ = _e1334;
                                                    } else {
                                                        phi_1529_ = true;
                                                    }
                                                    let _e1336 = phi_1529_;
                                                    if _e1336 {
                                                        if (_e1329 >= _e1330) {
                                                            phi_1537_ = 1u;
                                                        } else {
                                                            phi_1537_ = 2u;
                                                        }
                                                        let _e1339 = phi_1537_;
                                                        phi_1538_ = _e1339;
                                                    } else {
                                                        phi_1538_ = 0u;
                                                    }
                                                    let _e1341 = phi_1538_;
                                                    if (_e1341 == 0u) {
                                                        phi_1550_ = vec3<f32>(_e1112, _e1125, _e1099);
                                                    } else {
                                                        if (_e1341 == 1u) {
                                                            phi_1549_ = vec3<f32>(_e1125, _e1099, _e1112);
                                                        } else {
                                                            phi_1549_ = vec3<f32>(_e1099, _e1112, _e1125);
                                                        }
                                                        let _e1347 = phi_1549_;
                                                        phi_1550_ = _e1347;
                                                    }
                                                    let _e1349 = phi_1550_;
                                                    let _e1352 = (_e1349.x / _e1349.z);
                                                    let _e1355 = (_e1349.y / _e1349.z);
                                                    if (_e1270 < 0f) {
                                                        phi_1563_ = 0u;
                                                    } else {
                                                        phi_1563_ = 1u;
                                                    }
                                                    let _e1360 = phi_1563_;
                                                    if (_e1280 < 0f) {
                                                        phi_1568_ = 0u;
                                                    } else {
                                                        phi_1568_ = 2u;
                                                    }
                                                    let _e1363 = phi_1568_;
                                                    if (_e1290 < 0f) {
                                                        phi_1573_ = 0u;
                                                    } else {
                                                        phi_1573_ = 4u;
                                                    }
                                                    let _e1366 = phi_1573_;
                                                    let _e1368 = ((_e1360 | _e1363) | _e1366);
                                                    let _e1369 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1130, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1369.first[0], _e1369.first[1], _e1369.first[2], _e1369.first[3], _e1369.first[4], _e1369.first[5], _e1369.first[6], _e1369.first[7], _e1369.first[8], _e1369.first[9], _e1369.first[10], _e1369.first[11], _e1369.first[12], _e1369.first[13], _e1369.first[14], _e1369.first[15], _e1369.first[16], _e1369.first[17], _e1369.first[18], _e1369.first[19], _e1369.first[20], _e1369.first[21], _e1369.first[22], _e1369.first[23], _e1369.first[24], _e1369.first[25], _e1369.first[26], _e1369.first[27], _e1369.first[28], _e1369.first[29], _e1369.first[30], _e1369.first[31]), array<u32, 32>(_e1369.mask[0], _e1369.mask[1], _e1369.mask[2], _e1369.mask[3], _e1369.mask[4], _e1369.mask[5], _e1369.mask[6], _e1369.mask[7], _e1369.mask[8], _e1369.mask[9], _e1369.mask[10], _e1369.mask[11], _e1369.mask[12], _e1369.mask[13], _e1369.mask[14], _e1369.mask[15], _e1369.mask[16], _e1369.mask[17], _e1369.mask[18], _e1369.mask[19], _e1369.mask[20], _e1369.mask[21], _e1369.mask[22], _e1369.mask[23], _e1369.mask[24], _e1369.mask[25], _e1369.mask[26], _e1369.mask[27], _e1369.mask[28], _e1369.mask[29], _e1369.mask[30], _e1369.mask[31]), _e1369.len, _e1369.group, _e1369.group_mask);
                                                    let _e1443 = local.group_mask;
                                                    if ((_e1443 & 4278190080u) == 0u) {
                                                        let _e1447 = local.len;
                                                        if (_e1447 == 0u) {
                                                            phi_1687_ = false;
                                                        } else {
                                                            let _e1451 = local.len;
                                                            local.len = (_e1451 - 1u);
                                                            let _e1454 = local.len;
                                                            if (_e1454 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1459 = local.first[(0u + _e1454)];
                                                            local.group = _e1459;
                                                            let _e1462 = local.len;
                                                            if (_e1462 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1467 = local.mask[(0u + _e1462)];
                                                            local.group_mask = _e1467;
                                                            phi_1687_ = true;
                                                        }
                                                        let _e1470 = phi_1687_;
                                                        phi_1688_ = _e1470;
                                                    } else {
                                                        phi_1688_ = true;
                                                    }
                                                    let _e1472 = phi_1688_;
                                                    if _e1472 {
                                                        let _e1474 = local.group_mask;
                                                        let _e1480 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1474)), 32u, (_e1474 == 0u)));
                                                        let _e1484 = local.group_mask;
                                                        let _e1498 = local.group_mask;
                                                        local.group_mask = (_e1498 & ~((1u << bitcast<u32>((_e1480 & 31u)))));
                                                        let _e1501 = local.group;
                                                        phi_1719_ = (_e1501 + countOneBits(((_e1484 & ~((4294967295u << bitcast<u32>((((_e1480 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1719_ = 4294967295u;
                                                    }
                                                    let _e1504 = phi_1719_;
                                                    phi_1721_ = _e963;
                                                    phi_1724_ = _e1504;
                                                    loop {
                                                        let _e1506 = phi_1721_;
                                                        let _e1508 = phi_1724_;
                                                        local_9 = _e1506;
                                                        let _e1509 = (_e1508 != 4294967295u);
                                                        if _e1509 {
                                                            if (_e1508 < _e67) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1516 = nodes.member[(0u + _e1508)].frame[3u];
                                                            let _e1541 = (bitcast<f32>((((_e1516 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1270);
                                                            let _e1542 = (bitcast<f32>((((_e1516 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1280);
                                                            let _e1543 = (bitcast<f32>((((_e1516 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1290);
                                                            let _e1546 = nodes.member[(0u + _e1508)].frame[0u];
                                                            let _e1550 = nodes.member[(0u + _e1508)].frame[1u];
                                                            let _e1554 = nodes.member[(0u + _e1508)].frame[2u];
                                                            let _e1559 = ((bitcast<f32>(_e1546) - _e1055) * _e1270);
                                                            let _e1560 = ((bitcast<f32>(_e1550) - _e1068) * _e1280);
                                                            let _e1561 = ((bitcast<f32>(_e1554) - _e1081) * _e1290);
                                                            let _e1569 = nodes.member[(0u + _e1508)].x;
                                                            if (_e1270 < 0f) {
                                                                let _e1580 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1569.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1586 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1580.unnamed.word, _e1569.w), _e1580.unnamed_1);
                                                                let _e1592 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1586.unnamed, lt_mask_LightPlace(_e1569.x, _e1586.unnamed_1.shift));
                                                                phi_1805_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1592.unnamed, lt_mask_LightPlace(_e1592.unnamed_1.word, _e1569.y));
                                                            } else {
                                                                let _e1608 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1569.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1614 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1608.unnamed.word, _e1569.y), _e1608.unnamed_1);
                                                                let _e1620 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1614.unnamed, lt_mask_LightPlace(_e1569.z, _e1614.unnamed_1.shift));
                                                                phi_1805_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1620.unnamed, lt_mask_LightPlace(_e1620.unnamed_1.word, _e1569.w));
                                                            }
                                                            let _e1628 = phi_1805_;
                                                            let _e1638 = nodes.member[(0u + _e1508)].y;
                                                            if (_e1280 < 0f) {
                                                                let _e1649 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1638.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1655 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1649.unnamed.word, _e1638.w), _e1649.unnamed_1);
                                                                let _e1661 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1655.unnamed, lt_mask_LightPlace(_e1638.x, _e1655.unnamed_1.shift));
                                                                phi_1832_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1661.unnamed, lt_mask_LightPlace(_e1661.unnamed_1.word, _e1638.y));
                                                            } else {
                                                                let _e1677 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1638.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1683 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1677.unnamed.word, _e1638.y), _e1677.unnamed_1);
                                                                let _e1689 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1683.unnamed, lt_mask_LightPlace(_e1638.z, _e1683.unnamed_1.shift));
                                                                phi_1832_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1689.unnamed, lt_mask_LightPlace(_e1689.unnamed_1.word, _e1638.w));
                                                            }
                                                            let _e1697 = phi_1832_;
                                                            let _e1707 = nodes.member[(0u + _e1508)].z;
                                                            if (_e1290 < 0f) {
                                                                let _e1718 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1707.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1724 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1718.unnamed.word, _e1707.w), _e1718.unnamed_1);
                                                                let _e1730 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1724.unnamed, lt_mask_LightPlace(_e1707.x, _e1724.unnamed_1.shift));
                                                                phi_1859_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1730.unnamed, lt_mask_LightPlace(_e1730.unnamed_1.word, _e1707.y));
                                                            } else {
                                                                let _e1746 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1707.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1752 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1746.unnamed.word, _e1707.y), _e1746.unnamed_1);
                                                                let _e1758 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1752.unnamed, lt_mask_LightPlace(_e1707.z, _e1752.unnamed_1.shift));
                                                                phi_1859_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1758.unnamed, lt_mask_LightPlace(_e1758.unnamed_1.word, _e1707.w));
                                                            }
                                                            let _e1766 = phi_1859_;
                                                            phi_1865_ = 0u;
                                                            phi_1868_ = 0u;
                                                            loop {
                                                                let _e1776 = phi_1865_;
                                                                let _e1778 = phi_1868_;
                                                                local_5 = _e1778;
                                                                local_6 = _e1778;
                                                                local_7 = _e1778;
                                                                let _e1779 = (_e1776 < 8u);
                                                                if _e1779 {
                                                                    let _e1781 = (_e1776 >> bitcast<u32>(2i));
                                                                    let _e1782 = (_e1776 & 3u);
                                                                    if (_e1781 == 0u) {
                                                                        phi_1882_ = _e1628.unnamed.word;
                                                                    } else {
                                                                        phi_1882_ = _e1628.unnamed.shift;
                                                                    }
                                                                    let _e1785 = phi_1882_;
                                                                    if (_e1781 == 0u) {
                                                                        phi_1892_ = _e1697.unnamed.word;
                                                                    } else {
                                                                        phi_1892_ = _e1697.unnamed.shift;
                                                                    }
                                                                    let _e1794 = phi_1892_;
                                                                    if (_e1781 == 0u) {
                                                                        phi_1902_ = _e1766.unnamed.word;
                                                                    } else {
                                                                        phi_1902_ = _e1766.unnamed.shift;
                                                                    }
                                                                    let _e1803 = phi_1902_;
                                                                    let _e1816 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1785 >> bitcast<u32>(((_e1782 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 - _e1318)), ((f32(((_e1794 >> bitcast<u32>(((_e1782 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 - _e1319)));
                                                                    let _e1817 = core_intrinsics_maximum_number_nsz_f32_(_e1816, ((f32(((_e1803 >> bitcast<u32>(((_e1782 * 8u) & 31u))) & 255u)) * _e1543) + (_e1561 - _e1320)));
                                                                    if (_e1781 == 0u) {
                                                                        phi_1920_ = _e1628.unnamed_1.word;
                                                                    } else {
                                                                        phi_1920_ = _e1628.unnamed_1.shift;
                                                                    }
                                                                    let _e1820 = phi_1920_;
                                                                    if (_e1781 == 0u) {
                                                                        phi_1930_ = _e1697.unnamed_1.word;
                                                                    } else {
                                                                        phi_1930_ = _e1697.unnamed_1.shift;
                                                                    }
                                                                    let _e1829 = phi_1930_;
                                                                    if (_e1781 == 0u) {
                                                                        phi_1940_ = _e1766.unnamed_1.word;
                                                                    } else {
                                                                        phi_1940_ = _e1766.unnamed_1.shift;
                                                                    }
                                                                    let _e1838 = phi_1940_;
                                                                    let _e1851 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1820 >> bitcast<u32>(((_e1782 * 8u) & 31u))) & 255u)) * _e1541) + (_e1559 + _e1318)), ((f32(((_e1829 >> bitcast<u32>(((_e1782 * 8u) & 31u))) & 255u)) * _e1542) + (_e1560 + _e1319)));
                                                                    let _e1852 = core_intrinsics_minimum_number_nsz_f32_(_e1851, ((f32(((_e1838 >> bitcast<u32>(((_e1782 * 8u) & 31u))) & 255u)) * _e1543) + (_e1561 + _e1320)));
                                                                    if (_e1817 <= _e1852) {
                                                                        if (_e1817 <= _e1506.t) {
                                                                            if (_e1852 >= _e145.tmin) {
                                                                                if (_e1781 == 0u) {
                                                                                    let _e1859 = nodes.member[(0u + _e1508)].links[2u];
                                                                                    phi_1976_ = _e1859;
                                                                                } else {
                                                                                    let _e1862 = nodes.member[(0u + _e1508)].links[3u];
                                                                                    phi_1976_ = _e1862;
                                                                                }
                                                                                let _e1864 = phi_1976_;
                                                                                let _e1869 = ((_e1864 >> bitcast<u32>(((_e1782 * 8u) & 31u))) & 255u);
                                                                                let _e1870 = (_e1869 & 31u);
                                                                                if (_e1870 >= 24u) {
                                                                                    phi_1989_ = (24u + ((_e1870 - 24u) ^ _e1368));
                                                                                } else {
                                                                                    phi_1989_ = _e1870;
                                                                                }
                                                                                let _e1876 = phi_1989_;
                                                                                phi_1994_ = (_e1778 | ((_e1869 >> bitcast<u32>(5i)) << bitcast<u32>((_e1876 & 31u))));
                                                                            } else {
                                                                                phi_1994_ = _e1778;
                                                                            }
                                                                            let _e1884 = phi_1994_;
                                                                            phi_1995_ = _e1884;
                                                                        } else {
                                                                            phi_1995_ = _e1778;
                                                                        }
                                                                        let _e1886 = phi_1995_;
                                                                        phi_1996_ = _e1886;
                                                                    } else {
                                                                        phi_1996_ = _e1778;
                                                                    }
                                                                    let _e1888 = phi_1996_;
                                                                    phi_1866_ = (_e1776 + 1u);
                                                                    phi_1869_ = _e1888;
                                                                } else {
                                                                    phi_1866_ = u32();
                                                                    phi_1869_ = u32();
                                                                }
                                                                let _e1891 = phi_1866_;
                                                                let _e1893 = phi_1869_;
                                                                continue;
                                                                continuing {
                                                                    phi_1865_ = _e1891;
                                                                    phi_1868_ = _e1893;
                                                                    break if !(_e1779);
                                                                }
                                                            }
                                                            let _e1897 = nodes.member[(0u + _e1508)].links[0u];
                                                            let _e1901 = nodes.member[(0u + _e1508)].frame[3u];
                                                            let _e1905 = local_5;
                                                            if ((_e1905 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1909 = local.group_mask;
                                                                if ((_e1909 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1913 = local.len;
                                                                    if (_e1913 < 32u) {
                                                                        let _e1916 = local.group;
                                                                        let _e1918 = local.len;
                                                                        if (_e1918 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1918)] = _e1916;
                                                                        let _e1924 = local.group_mask;
                                                                        let _e1926 = local.len;
                                                                        if (_e1926 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1926)] = _e1924;
                                                                        let _e1933 = local.len;
                                                                        local.len = (_e1933 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1130 + _e1897);
                                                                let _e1937 = local_6;
                                                                local.group_mask = ((_e1937 & 4278190080u) | (_e1901 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1942 = local_7;
                                                            phi_2054_ = _e1506;
                                                            phi_2057_ = (_e1942 & 16777215u);
                                                            loop {
                                                                let _e1945 = phi_2054_;
                                                                let _e1947 = phi_2057_;
                                                                local_8 = _e1945;
                                                                if (_e1947 == 0u) {
                                                                    phi_2055_ = lt_bvh_Hit();
                                                                    phi_2058_ = u32();
                                                                    phi_2699_ = false;
                                                                } else {
                                                                    let _e1951 = nodes.member[(0u + _e1508)].links[1u];
                                                                    let _e1956 = ((_e1132 + _e1951) + select(firstTrailingBit(_e1947), 32u, (_e1947 == 0u)));
                                                                    if (_e1956 < _e70) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1963 = triangles.member[(0u + _e1956)].v0_;
                                                                    let _e1965 = (_e1963.x - _e1055);
                                                                    let _e1967 = (_e1963.y - _e1068);
                                                                    let _e1969 = (_e1963.z - _e1081);
                                                                    if (_e1341 == 0u) {
                                                                        phi_2102_ = vec3<f32>(_e1967, _e1969, _e1965);
                                                                    } else {
                                                                        if (_e1341 == 1u) {
                                                                            phi_2101_ = vec3<f32>(_e1969, _e1965, _e1967);
                                                                        } else {
                                                                            phi_2101_ = (_e1963 - vec3<f32>(_e1055, _e1068, _e1081));
                                                                        }
                                                                        let _e1977 = phi_2101_;
                                                                        phi_2102_ = _e1977;
                                                                    }
                                                                    let _e1979 = phi_2102_;
                                                                    let _e1983 = (_e1979.x - (_e1352 * _e1979.z));
                                                                    let _e1987 = (_e1979.y - (_e1355 * _e1979.z));
                                                                    let _e1989 = triangles.member[(0u + _e1956)].v1_;
                                                                    let _e1991 = (_e1989.x - _e1055);
                                                                    let _e1993 = (_e1989.y - _e1068);
                                                                    let _e1995 = (_e1989.z - _e1081);
                                                                    if (_e1341 == 0u) {
                                                                        phi_2132_ = vec3<f32>(_e1993, _e1995, _e1991);
                                                                    } else {
                                                                        if (_e1341 == 1u) {
                                                                            phi_2131_ = vec3<f32>(_e1995, _e1991, _e1993);
                                                                        } else {
                                                                            phi_2131_ = (_e1989 - vec3<f32>(_e1055, _e1068, _e1081));
                                                                        }
                                                                        let _e2003 = phi_2131_;
                                                                        phi_2132_ = _e2003;
                                                                    }
                                                                    let _e2005 = phi_2132_;
                                                                    let _e2009 = (_e2005.x - (_e1352 * _e2005.z));
                                                                    let _e2013 = (_e2005.y - (_e1355 * _e2005.z));
                                                                    let _e2015 = triangles.member[(0u + _e1956)].v2_;
                                                                    let _e2017 = (_e2015.x - _e1055);
                                                                    let _e2019 = (_e2015.y - _e1068);
                                                                    let _e2021 = (_e2015.z - _e1081);
                                                                    if (_e1341 == 0u) {
                                                                        phi_2162_ = vec3<f32>(_e2019, _e2021, _e2017);
                                                                    } else {
                                                                        if (_e1341 == 1u) {
                                                                            phi_2161_ = vec3<f32>(_e2021, _e2017, _e2019);
                                                                        } else {
                                                                            phi_2161_ = (_e2015 - vec3<f32>(_e1055, _e1068, _e1081));
                                                                        }
                                                                        let _e2029 = phi_2161_;
                                                                        phi_2162_ = _e2029;
                                                                    }
                                                                    let _e2031 = phi_2162_;
                                                                    let _e2035 = (_e2031.x - (_e1352 * _e2031.z));
                                                                    let _e2039 = (_e2031.y - (_e1355 * _e2031.z));
                                                                    if (_e2009 < _e2035) {
                                                                        phi_2181_ = true;
                                                                    } else {
                                                                        if (_e2009 == _e2035) {
                                                                            phi_2180_ = (_e2013 < _e2039);
                                                                        } else {
                                                                            phi_2180_ = false;
                                                                        }
                                                                        let _e2044 = phi_2180_;
                                                                        phi_2181_ = _e2044;
                                                                    }
                                                                    let _e2046 = phi_2181_;
                                                                    if _e2046 {
                                                                        phi_2185_ = _e2039;
                                                                        phi_2186_ = _e2035;
                                                                        phi_2187_ = _e2013;
                                                                        phi_2188_ = _e2009;
                                                                    } else {
                                                                        phi_2185_ = _e2013;
                                                                        phi_2186_ = _e2009;
                                                                        phi_2187_ = _e2039;
                                                                        phi_2188_ = _e2035;
                                                                    }
                                                                    let _e2048 = phi_2185_;
                                                                    let _e2050 = phi_2186_;
                                                                    let _e2052 = phi_2187_;
                                                                    let _e2054 = phi_2188_;
                                                                    let _e2057 = ((_e2054 * _e2048) - (_e2052 * _e2050));
                                                                    if _e2046 {
                                                                        phi_2196_ = -(_e2057);
                                                                    } else {
                                                                        phi_2196_ = _e2057;
                                                                    }
                                                                    let _e2060 = phi_2196_;
                                                                    if (_e2035 < _e1983) {
                                                                        phi_2207_ = true;
                                                                    } else {
                                                                        if (_e2035 == _e1983) {
                                                                            phi_2206_ = (_e2039 < _e1987);
                                                                        } else {
                                                                            phi_2206_ = false;
                                                                        }
                                                                        let _e2065 = phi_2206_;
                                                                        phi_2207_ = _e2065;
                                                                    }
                                                                    let _e2067 = phi_2207_;
                                                                    if _e2067 {
                                                                        phi_2211_ = _e1987;
                                                                        phi_2212_ = _e1983;
                                                                        phi_2213_ = _e2039;
                                                                        phi_2214_ = _e2035;
                                                                    } else {
                                                                        phi_2211_ = _e2039;
                                                                        phi_2212_ = _e2035;
                                                                        phi_2213_ = _e1987;
                                                                        phi_2214_ = _e1983;
                                                                    }
                                                                    let _e2069 = phi_2211_;
                                                                    let _e2071 = phi_2212_;
                                                                    let _e2073 = phi_2213_;
                                                                    let _e2075 = phi_2214_;
                                                                    let _e2078 = ((_e2075 * _e2069) - (_e2073 * _e2071));
                                                                    if _e2067 {
                                                                        phi_2222_ = -(_e2078);
                                                                    } else {
                                                                        phi_2222_ = _e2078;
                                                                    }
                                                                    let _e2081 = phi_2222_;
                                                                    if (_e1983 < _e2009) {
                                                                        phi_2233_ = true;
                                                                    } else {
                                                                        if (_e1983 == _e2009) {
                                                                            phi_2232_ = (_e1987 < _e2013);
                                                                        } else {
                                                                            phi_2232_ = false;
                                                                        }
                                                                        let _e2086 = phi_2232_;
                                                                        phi_2233_ = _e2086;
                                                                    }
                                                                    let _e2088 = phi_2233_;
                                                                    if _e2088 {
                                                                        phi_2237_ = _e2013;
                                                                        phi_2238_ = _e2009;
                                                                        phi_2239_ = _e1987;
                                                                        phi_2240_ = _e1983;
                                                                    } else {
                                                                        phi_2237_ = _e1987;
                                                                        phi_2238_ = _e1983;
                                                                        phi_2239_ = _e2013;
                                                                        phi_2240_ = _e2009;
                                                                    }
                                                                    let _e2090 = phi_2237_;
                                                                    let _e2092 = phi_2238_;
                                                                    let _e2094 = phi_2239_;
                                                                    let _e2096 = phi_2240_;
                                                                    let _e2099 = ((_e2096 * _e2090) - (_e2094 * _e2092));
                                                                    if _e2088 {
                                                                        phi_2248_ = -(_e2099);
                                                                    } else {
                                                                        phi_2248_ = _e2099;
                                                                    }
                                                                    let _e2102 = phi_2248_;
                                                                    if (_e2060 >= 0f) {
                                                                        if (_e2081 >= 0f) {
                                                                            if (_e2102 >= 0f) {
                                                                                phi_2263_ = ((_e2060 + _e2081) + _e2102);
                                                                                phi_2264_ = false;
                                                                            } else {
                                                                                phi_2263_ = f32();
                                                                                phi_2264_ = true;
                                                                            }
                                                                            let _e2109 = phi_2263_;
                                                                            let _e2111 = phi_2264_;
                                                                            phi_2265_ = _e2109;
                                                                            phi_2266_ = _e2111;
                                                                        } else {
                                                                            phi_2265_ = f32();
                                                                            phi_2266_ = true;
                                                                        }
                                                                        let _e2113 = phi_2265_;
                                                                        let _e2115 = phi_2266_;
                                                                        phi_2267_ = _e2113;
                                                                        phi_2268_ = _e2115;
                                                                    } else {
                                                                        phi_2267_ = f32();
                                                                        phi_2268_ = true;
                                                                    }
                                                                    let _e2117 = phi_2267_;
                                                                    let _e2119 = phi_2268_;
                                                                    if _e2119 {
                                                                        if (_e2060 <= 0f) {
                                                                            if (_e2081 <= 0f) {
                                                                                let _e2122 = (_e2102 <= 0f);
                                                                                if _e2122 {
                                                                                }
                                                                                phi_2286_ = ((_e2060 + _e2081) + _e2102);
                                                                                phi_2287_ = false;
                                                                                phi_2288_ = _e2122;
                                                                            } else {
                                                                                phi_2286_ = f32();
                                                                                phi_2287_ = true;
                                                                                phi_2288_ = false;
                                                                            }
                                                                            let _e2126 = phi_2286_;
                                                                            let _e2128 = phi_2287_;
                                                                            let _e2130 = phi_2288_;
                                                                            phi_2289_ = _e2126;
                                                                            phi_2290_ = _e2128;
                                                                            phi_2291_ = _e2130;
                                                                        } else {
                                                                            phi_2289_ = f32();
                                                                            phi_2290_ = true;
                                                                            phi_2291_ = false;
                                                                        }
                                                                        let _e2132 = phi_2289_;
                                                                        let _e2134 = phi_2290_;
                                                                        let _e2136 = phi_2291_;
                                                                        if _e2134 {
                                                                            phi_2295_ = false;
                                                                        } else {
                                                                            phi_2295_ = _e2136;
                                                                        }
                                                                        let _e2138 = phi_2295_;
                                                                        phi_2296_ = _e2132;
                                                                        phi_2297_ = _e2138;
                                                                    } else {
                                                                        phi_2296_ = _e2117;
                                                                        phi_2297_ = true;
                                                                    }
                                                                    let _e2140 = phi_2296_;
                                                                    let _e2142 = phi_2297_;
                                                                    if _e2142 {
                                                                        let _e2143 = (_e2140 == 0f);
                                                                        if _e2143 {
                                                                            phi_2613_ = lt_bvh_triangle_Intersection();
                                                                            phi_2614_ = false;
                                                                        } else {
                                                                            let _e2145 = triangles.member[(0u + _e1956)].v0_;
                                                                            let _e2147 = (_e2145.x - _e1055);
                                                                            let _e2149 = (_e2145.y - _e1068);
                                                                            let _e2151 = (_e2145.z - _e1081);
                                                                            if (_e1341 == 0u) {
                                                                                phi_2326_ = vec3<f32>(_e2149, _e2151, _e2147);
                                                                            } else {
                                                                                if (_e1341 == 1u) {
                                                                                    phi_2325_ = vec3<f32>(_e2151, _e2147, _e2149);
                                                                                } else {
                                                                                    phi_2325_ = (_e2145 - vec3<f32>(_e1055, _e1068, _e1081));
                                                                                }
                                                                                let _e2159 = phi_2325_;
                                                                                phi_2326_ = _e2159;
                                                                            }
                                                                            let _e2161 = phi_2326_;
                                                                            let _e2163 = triangles.member[(0u + _e1956)].v1_;
                                                                            let _e2165 = triangles.member[(0u + _e1956)].v0_;
                                                                            let _e2168 = (_e2163.x - _e2165.x);
                                                                            let _e2171 = (_e2163.y - _e2165.y);
                                                                            let _e2174 = (_e2163.z - _e2165.z);
                                                                            if (_e1341 == 0u) {
                                                                                phi_2352_ = vec3<f32>(_e2171, _e2174, _e2168);
                                                                            } else {
                                                                                if (_e1341 == 1u) {
                                                                                    phi_2351_ = vec3<f32>(_e2174, _e2168, _e2171);
                                                                                } else {
                                                                                    phi_2351_ = (_e2163 - _e2165);
                                                                                }
                                                                                let _e2181 = phi_2351_;
                                                                                phi_2352_ = _e2181;
                                                                            }
                                                                            let _e2183 = phi_2352_;
                                                                            let _e2185 = triangles.member[(0u + _e1956)].v2_;
                                                                            let _e2187 = triangles.member[(0u + _e1956)].v0_;
                                                                            let _e2190 = (_e2185.x - _e2187.x);
                                                                            let _e2193 = (_e2185.y - _e2187.y);
                                                                            let _e2196 = (_e2185.z - _e2187.z);
                                                                            if (_e1341 == 0u) {
                                                                                phi_2378_ = vec3<f32>(_e2193, _e2196, _e2190);
                                                                            } else {
                                                                                if (_e1341 == 1u) {
                                                                                    phi_2377_ = vec3<f32>(_e2196, _e2190, _e2193);
                                                                                } else {
                                                                                    phi_2377_ = (_e2185 - _e2187);
                                                                                }
                                                                                let _e2203 = phi_2377_;
                                                                                phi_2378_ = _e2203;
                                                                            }
                                                                            let _e2205 = phi_2378_;
                                                                            let _e2212 = ((_e2183.y * _e2205.z) - (_e2183.z * _e2205.y));
                                                                            let _e2219 = ((_e2183.z * _e2205.x) - (_e2183.x * _e2205.z));
                                                                            let _e2226 = ((_e2183.x * _e2205.y) - (_e2183.y * _e2205.x));
                                                                            let _e2240 = (((1f / _e1349.z) * (((_e2212 * _e2161.x) + (_e2219 * _e2161.y)) + (_e2226 * _e2161.z))) / (((_e2212 * _e1352) + (_e2219 * _e1355)) + _e2226));
                                                                            if (_e2240 > _e145.tmin) {
                                                                                if (_e2240 < _e145.tmax) {
                                                                                    let _e2244 = triangles.member[(0u + _e1956)].v0_;
                                                                                    let _e2246 = triangles.member[(0u + _e1956)].v1_;
                                                                                    if (_e2244.x < _e2246.x) {
                                                                                        phi_2434_ = _e2244.x;
                                                                                    } else {
                                                                                        phi_2434_ = _e2246.x;
                                                                                    }
                                                                                    let _e2253 = phi_2434_;
                                                                                    if (_e2244.y < _e2246.y) {
                                                                                        phi_2443_ = _e2244.y;
                                                                                    } else {
                                                                                        phi_2443_ = _e2246.y;
                                                                                    }
                                                                                    let _e2260 = phi_2443_;
                                                                                    if (_e2244.z < _e2246.z) {
                                                                                        phi_2452_ = _e2244.z;
                                                                                    } else {
                                                                                        phi_2452_ = _e2246.z;
                                                                                    }
                                                                                    let _e2267 = phi_2452_;
                                                                                    let _e2269 = triangles.member[(0u + _e1956)].v2_;
                                                                                    if (_e2253 < _e2269.x) {
                                                                                        phi_2461_ = _e2253;
                                                                                    } else {
                                                                                        phi_2461_ = _e2269.x;
                                                                                    }
                                                                                    let _e2274 = phi_2461_;
                                                                                    if (_e2260 < _e2269.y) {
                                                                                        phi_2468_ = _e2260;
                                                                                    } else {
                                                                                        phi_2468_ = _e2269.y;
                                                                                    }
                                                                                    let _e2279 = phi_2468_;
                                                                                    if (_e2267 < _e2269.z) {
                                                                                        phi_2475_ = _e2267;
                                                                                    } else {
                                                                                        phi_2475_ = _e2269.z;
                                                                                    }
                                                                                    let _e2284 = phi_2475_;
                                                                                    let _e2286 = triangles.member[(0u + _e1956)].v0_;
                                                                                    let _e2288 = triangles.member[(0u + _e1956)].v1_;
                                                                                    if (_e2286.x > _e2288.x) {
                                                                                        phi_2488_ = _e2286.x;
                                                                                    } else {
                                                                                        phi_2488_ = _e2288.x;
                                                                                    }
                                                                                    let _e2295 = phi_2488_;
                                                                                    if (_e2286.y > _e2288.y) {
                                                                                        phi_2497_ = _e2286.y;
                                                                                    } else {
                                                                                        phi_2497_ = _e2288.y;
                                                                                    }
                                                                                    let _e2302 = phi_2497_;
                                                                                    if (_e2286.z > _e2288.z) {
                                                                                        phi_2506_ = _e2286.z;
                                                                                    } else {
                                                                                        phi_2506_ = _e2288.z;
                                                                                    }
                                                                                    let _e2309 = phi_2506_;
                                                                                    let _e2311 = triangles.member[(0u + _e1956)].v2_;
                                                                                    if (_e2295 > _e2311.x) {
                                                                                        phi_2515_ = _e2295;
                                                                                    } else {
                                                                                        phi_2515_ = _e2311.x;
                                                                                    }
                                                                                    let _e2316 = phi_2515_;
                                                                                    if (_e2302 > _e2311.y) {
                                                                                        phi_2522_ = _e2302;
                                                                                    } else {
                                                                                        phi_2522_ = _e2311.y;
                                                                                    }
                                                                                    let _e2321 = phi_2522_;
                                                                                    if (_e2309 > _e2311.z) {
                                                                                        phi_2529_ = _e2309;
                                                                                    } else {
                                                                                        phi_2529_ = _e2311.z;
                                                                                    }
                                                                                    let _e2326 = phi_2529_;
                                                                                    let _e2330 = ((_e2274 - _e1055) * _e1270);
                                                                                    let _e2331 = ((_e2279 - _e1068) * _e1280);
                                                                                    let _e2332 = ((_e2284 - _e1081) * _e1290);
                                                                                    let _e2336 = ((_e2316 - _e1055) * _e1270);
                                                                                    let _e2337 = ((_e2321 - _e1068) * _e1280);
                                                                                    let _e2338 = ((_e2326 - _e1081) * _e1290);
                                                                                    if (_e2330 < _e2336) {
                                                                                        phi_2546_ = _e2330;
                                                                                    } else {
                                                                                        phi_2546_ = _e2336;
                                                                                    }
                                                                                    let _e2341 = phi_2546_;
                                                                                    if (_e2331 < _e2337) {
                                                                                        phi_2551_ = _e2331;
                                                                                    } else {
                                                                                        phi_2551_ = _e2337;
                                                                                    }
                                                                                    let _e2344 = phi_2551_;
                                                                                    if (_e2332 < _e2338) {
                                                                                        phi_2556_ = _e2332;
                                                                                    } else {
                                                                                        phi_2556_ = _e2338;
                                                                                    }
                                                                                    let _e2347 = phi_2556_;
                                                                                    if (_e2330 > _e2336) {
                                                                                        phi_2564_ = _e2330;
                                                                                    } else {
                                                                                        phi_2564_ = _e2336;
                                                                                    }
                                                                                    let _e2353 = phi_2564_;
                                                                                    if (_e2331 > _e2337) {
                                                                                        phi_2569_ = _e2331;
                                                                                    } else {
                                                                                        phi_2569_ = _e2337;
                                                                                    }
                                                                                    let _e2356 = phi_2569_;
                                                                                    if (_e2332 > _e2338) {
                                                                                        phi_2574_ = _e2332;
                                                                                    } else {
                                                                                        phi_2574_ = _e2338;
                                                                                    }
                                                                                    let _e2359 = phi_2574_;
                                                                                    let _e2363 = core_intrinsics_maximum_number_nsz_f32_((_e2341 - _e1325), (_e2344 - _e1326));
                                                                                    let _e2364 = core_intrinsics_maximum_number_nsz_f32_(_e2363, (_e2347 - _e1327));
                                                                                    let _e2365 = core_intrinsics_minimum_number_nsz_f32_((_e2353 + _e1325), (_e2356 + _e1326));
                                                                                    let _e2366 = core_intrinsics_minimum_number_nsz_f32_(_e2365, (_e2359 + _e1327));
                                                                                    if (_e2364 > _e1030) {
                                                                                        phi_2586_ = _e2364;
                                                                                    } else {
                                                                                        phi_2586_ = _e1030;
                                                                                    }
                                                                                    let _e2369 = phi_2586_;
                                                                                    if (_e2366 < _e1032) {
                                                                                        phi_2591_ = _e2366;
                                                                                    } else {
                                                                                        phi_2591_ = _e1032;
                                                                                    }
                                                                                    let _e2372 = phi_2591_;
                                                                                    if (_e2240 < _e2369) {
                                                                                        phi_2596_ = _e2369;
                                                                                    } else {
                                                                                        phi_2596_ = _e2240;
                                                                                    }
                                                                                    let _e2375 = phi_2596_;
                                                                                    if (_e2375 > _e2372) {
                                                                                        phi_2601_ = _e2372;
                                                                                    } else {
                                                                                        phi_2601_ = _e2375;
                                                                                    }
                                                                                    let _e2378 = phi_2601_;
                                                                                    phi_2606_ = lt_bvh_triangle_Intersection(_e2378, (_e2081 / _e2140), (_e2102 / _e2140), (_e2369 <= _e2372));
                                                                                    phi_2607_ = false;
                                                                                } else {
                                                                                    phi_2606_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2607_ = true;
                                                                                }
                                                                                let _e2384 = phi_2606_;
                                                                                let _e2386 = phi_2607_;
                                                                                phi_2608_ = _e2384;
                                                                                phi_2609_ = _e2386;
                                                                            } else {
                                                                                phi_2608_ = lt_bvh_triangle_Intersection();
                                                                                phi_2609_ = true;
                                                                            }
                                                                            let _e2388 = phi_2608_;
                                                                            let _e2390 = phi_2609_;
                                                                            if _e2390 {
                                                                            }
                                                                            phi_2613_ = _e2388;
                                                                            phi_2614_ = _e2390;
                                                                        }
                                                                        let _e2392 = phi_2613_;
                                                                        let _e2394 = phi_2614_;
                                                                        phi_2615_ = _e2392;
                                                                        phi_2616_ = _e2143;
                                                                        phi_2617_ = _e2394;
                                                                    } else {
                                                                        phi_2615_ = lt_bvh_triangle_Intersection();
                                                                        phi_2616_ = true;
                                                                        phi_2617_ = false;
                                                                    }
                                                                    let _e2396 = phi_2615_;
                                                                    let _e2398 = phi_2616_;
                                                                    let _e2400 = phi_2617_;
                                                                    if _e2398 {
                                                                        phi_2621_ = true;
                                                                    } else {
                                                                        phi_2621_ = _e2400;
                                                                    }
                                                                    let _e2402 = phi_2621_;
                                                                    if _e2402 {
                                                                        phi_2625_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2625_ = _e2396;
                                                                    }
                                                                    let _e2404 = phi_2625_;
                                                                    if _e2404.is_hit {
                                                                        if (_e2404.t > _e145.tmin) {
                                                                            if (_e2404.t < _e1945.t) {
                                                                                phi_2673_ = true;
                                                                            } else {
                                                                                if (_e2404.t == _e1945.t) {
                                                                                    if (_e1945.triangle != 4294967295u) {
                                                                                        if (_e1956 < _e1945.triangle) {
                                                                                            phi_2664_ = true;
                                                                                        } else {
                                                                                            if (_e1956 == _e1945.triangle) {
                                                                                                phi_2663_ = (_e971 < _e1945.instance);
                                                                                            } else {
                                                                                                phi_2663_ = false;
                                                                                            }
                                                                                            let _e2422 = phi_2663_;
                                                                                            phi_2664_ = _e2422;
                                                                                        }
                                                                                        let _e2424 = phi_2664_;
                                                                                        phi_2665_ = _e2424;
                                                                                        phi_2666_ = false;
                                                                                    } else {
                                                                                        phi_2665_ = bool();
                                                                                        phi_2666_ = true;
                                                                                    }
                                                                                    let _e2426 = phi_2665_;
                                                                                    let _e2428 = phi_2666_;
                                                                                    phi_2667_ = _e2426;
                                                                                    phi_2668_ = _e2428;
                                                                                } else {
                                                                                    phi_2667_ = bool();
                                                                                    phi_2668_ = true;
                                                                                }
                                                                                let _e2430 = phi_2667_;
                                                                                let _e2432 = phi_2668_;
                                                                                if _e2432 {
                                                                                    phi_2672_ = false;
                                                                                } else {
                                                                                    phi_2672_ = _e2430;
                                                                                }
                                                                                let _e2434 = phi_2672_;
                                                                                phi_2673_ = _e2434;
                                                                            }
                                                                            let _e2436 = phi_2673_;
                                                                            if _e2436 {
                                                                                let _e2438 = triangles.member[(0u + _e1956)].i0_;
                                                                                if ((_e2438 & 2147483648u) == 0u) {
                                                                                    phi_2687_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2687_ = true;
                                                                                }
                                                                                let _e2442 = phi_2687_;
                                                                                if _e2442 {
                                                                                    phi_2695_ = lt_bvh_Hit(_e2404.t, _e2404.u, _e2404.v, _e1956, _e971);
                                                                                } else {
                                                                                    phi_2695_ = _e1945;
                                                                                }
                                                                                let _e2448 = phi_2695_;
                                                                                phi_2696_ = _e2448;
                                                                            } else {
                                                                                phi_2696_ = _e1945;
                                                                            }
                                                                            let _e2450 = phi_2696_;
                                                                            phi_2697_ = _e2450;
                                                                        } else {
                                                                            phi_2697_ = _e1945;
                                                                        }
                                                                        let _e2452 = phi_2697_;
                                                                        phi_2698_ = _e2452;
                                                                    } else {
                                                                        phi_2698_ = _e1945;
                                                                    }
                                                                    let _e2454 = phi_2698_;
                                                                    phi_2055_ = _e2454;
                                                                    phi_2058_ = (_e1947 & (_e1947 - 1u));
                                                                    phi_2699_ = true;
                                                                }
                                                                let _e2456 = phi_2055_;
                                                                let _e2458 = phi_2058_;
                                                                let _e2460 = phi_2699_;
                                                                continue;
                                                                continuing {
                                                                    phi_2054_ = _e2456;
                                                                    phi_2057_ = _e2458;
                                                                    break if !(_e2460);
                                                                }
                                                            }
                                                            let _e2463 = local.group_mask;
                                                            if ((_e2463 & 4278190080u) == 0u) {
                                                                let _e2467 = local.len;
                                                                if (_e2467 == 0u) {
                                                                    phi_2738_ = false;
                                                                } else {
                                                                    let _e2471 = local.len;
                                                                    local.len = (_e2471 - 1u);
                                                                    let _e2474 = local.len;
                                                                    if (_e2474 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2479 = local.first[(0u + _e2474)];
                                                                    local.group = _e2479;
                                                                    let _e2482 = local.len;
                                                                    if (_e2482 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2487 = local.mask[(0u + _e2482)];
                                                                    local.group_mask = _e2487;
                                                                    phi_2738_ = true;
                                                                }
                                                                let _e2490 = phi_2738_;
                                                                phi_2739_ = _e2490;
                                                            } else {
                                                                phi_2739_ = true;
                                                            }
                                                            let _e2492 = phi_2739_;
                                                            if _e2492 {
                                                                let _e2494 = local.group_mask;
                                                                let _e2500 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2494)), 32u, (_e2494 == 0u)));
                                                                let _e2504 = local.group_mask;
                                                                let _e2518 = local.group_mask;
                                                                local.group_mask = (_e2518 & ~((1u << bitcast<u32>((_e2500 & 31u)))));
                                                                let _e2521 = local.group;
                                                                phi_2770_ = (_e2521 + countOneBits(((_e2504 & ~((4294967295u << bitcast<u32>((((_e2500 - 24u) ^ _e1368) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2770_ = 4294967295u;
                                                            }
                                                            let _e2524 = phi_2770_;
                                                            let _e3510 = local_8;
                                                            phi_1722_ = _e3510;
                                                            phi_1725_ = _e2524;
                                                        } else {
                                                            phi_1722_ = lt_bvh_Hit();
                                                            phi_1725_ = u32();
                                                        }
                                                        let _e2526 = phi_1722_;
                                                        let _e2528 = phi_1725_;
                                                        continue;
                                                        continuing {
                                                            phi_1721_ = _e2526;
                                                            phi_1724_ = _e2528;
                                                            break if !(_e1509);
                                                        }
                                                    }
                                                    let _e3514 = local_9;
                                                    phi_2771_ = _e3514;
                                                }
                                                let _e2531 = phi_2771_;
                                                phi_2772_ = _e2531;
                                                phi_2773_ = _e1194;
                                            } else {
                                                phi_2772_ = lt_bvh_Hit();
                                                phi_2773_ = true;
                                            }
                                            let _e2533 = phi_2772_;
                                            let _e2535 = phi_2773_;
                                            if _e2535 {
                                                phi_2777_ = _e963;
                                            } else {
                                                phi_2777_ = _e2533;
                                            }
                                            let _e2537 = phi_2777_;
                                            phi_2778_ = _e2537;
                                        } else {
                                            phi_2778_ = _e963;
                                        }
                                        let _e2539 = phi_2778_;
                                        phi_2779_ = _e2539;
                                    } else {
                                        phi_2779_ = _e963;
                                    }
                                    let _e2541 = phi_2779_;
                                    phi_2780_ = _e2541;
                                } else {
                                    phi_2780_ = _e963;
                                }
                                let _e2543 = phi_2780_;
                                phi_1096_ = (_e961 & (_e961 - 1u));
                                phi_1099_ = _e2543;
                                phi_2781_ = true;
                            }
                            let _e2545 = phi_1096_;
                            let _e2547 = phi_1099_;
                            let _e2549 = phi_2781_;
                            continue;
                            continuing {
                                phi_1095_ = _e2545;
                                phi_1098_ = _e2547;
                                break if !(_e2549);
                            }
                        }
                        let _e2552 = local_1.group_mask;
                        if ((_e2552 & 4278190080u) == 0u) {
                            let _e2556 = local_1.len;
                            if (_e2556 == 0u) {
                                phi_2820_ = false;
                            } else {
                                let _e2560 = local_1.len;
                                local_1.len = (_e2560 - 1u);
                                let _e2563 = local_1.len;
                                if (_e2563 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2568 = local_1.first[(0u + _e2563)];
                                local_1.group = _e2568;
                                let _e2571 = local_1.len;
                                if (_e2571 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2576 = local_1.mask[(0u + _e2571)];
                                local_1.group_mask = _e2576;
                                phi_2820_ = true;
                            }
                            let _e2579 = phi_2820_;
                            phi_2821_ = _e2579;
                        } else {
                            phi_2821_ = true;
                        }
                        let _e2581 = phi_2821_;
                        if _e2581 {
                            let _e2583 = local_1.group_mask;
                            let _e2589 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2583)), 32u, (_e2583 == 0u)));
                            let _e2593 = local_1.group_mask;
                            let _e2607 = local_1.group_mask;
                            local_1.group_mask = (_e2607 & ~((1u << bitcast<u32>((_e2589 & 31u)))));
                            let _e2610 = local_1.group;
                            phi_2852_ = (_e2610 + countOneBits(((_e2593 & ~((4294967295u << bitcast<u32>((((_e2589 - 24u) ^ _e380) & 31u))))) & 255u)));
                        } else {
                            phi_2852_ = 4294967295u;
                        }
                        let _e2613 = phi_2852_;
                        phi_759_ = _e2613;
                        let _e3530 = local_10;
                        phi_762_ = _e3530;
                    } else {
                        phi_759_ = u32();
                        phi_762_ = lt_bvh_Hit();
                    }
                    let _e2615 = phi_759_;
                    let _e2617 = phi_762_;
                    continue;
                    continuing {
                        phi_758_ = _e2615;
                        phi_761_ = _e2617;
                        break if !(_e521);
                    }
                }
                let _e3533 = local_11;
                phi_2853_ = _e3533;
            }
            let _e2620 = phi_2853_;
            phi_2854_ = _e2620;
            phi_2855_ = _e217;
        } else {
            phi_2854_ = lt_bvh_Hit();
            phi_2855_ = true;
        }
        let _e2622 = phi_2854_;
        let _e2624 = phi_2855_;
        if _e2624 {
            phi_2859_ = _e147;
        } else {
            phi_2859_ = _e2622;
        }
        let _e2626 = phi_2859_;
        if (_e2626.triangle != 4294967295u) {
            let _e2632 = ((1f - _e2626.u) - _e2626.v);
            if (_e2626.triangle < _e70) {
            } else {
                return;
            }
            let _e2638 = triangles.member[(0u + _e2626.triangle)];
            if (_e2626.instance < _e82) {
            } else {
                return;
            }
            let _e2649 = instances.member[(0u + _e2626.instance)].object_to_world[0u];
            let _e2660 = ((((_e2649.x * _e2638.v0_.x) + (_e2649.y * _e2638.v0_.y)) + (_e2649.z * _e2638.v0_.z)) + (_e2649.w * 1f));
            let _e2662 = instances.member[(0u + _e2626.instance)].object_to_world[1u];
            let _e2673 = ((((_e2662.x * _e2638.v0_.x) + (_e2662.y * _e2638.v0_.y)) + (_e2662.z * _e2638.v0_.z)) + (_e2662.w * 1f));
            let _e2675 = instances.member[(0u + _e2626.instance)].object_to_world[2u];
            let _e2686 = ((((_e2675.x * _e2638.v0_.x) + (_e2675.y * _e2638.v0_.y)) + (_e2675.z * _e2638.v0_.z)) + (_e2675.w * 1f));
            let _e2693 = instances.member[(0u + _e2626.instance)].object_to_world[0u];
            let _e2704 = ((((_e2693.x * _e2638.v1_.x) + (_e2693.y * _e2638.v1_.y)) + (_e2693.z * _e2638.v1_.z)) + (_e2693.w * 1f));
            let _e2706 = instances.member[(0u + _e2626.instance)].object_to_world[1u];
            let _e2717 = ((((_e2706.x * _e2638.v1_.x) + (_e2706.y * _e2638.v1_.y)) + (_e2706.z * _e2638.v1_.z)) + (_e2706.w * 1f));
            let _e2719 = instances.member[(0u + _e2626.instance)].object_to_world[2u];
            let _e2730 = ((((_e2719.x * _e2638.v1_.x) + (_e2719.y * _e2638.v1_.y)) + (_e2719.z * _e2638.v1_.z)) + (_e2719.w * 1f));
            let _e2737 = instances.member[(0u + _e2626.instance)].object_to_world[0u];
            let _e2748 = ((((_e2737.x * _e2638.v2_.x) + (_e2737.y * _e2638.v2_.y)) + (_e2737.z * _e2638.v2_.z)) + (_e2737.w * 1f));
            let _e2750 = instances.member[(0u + _e2626.instance)].object_to_world[1u];
            let _e2761 = ((((_e2750.x * _e2638.v2_.x) + (_e2750.y * _e2638.v2_.y)) + (_e2750.z * _e2638.v2_.z)) + (_e2750.w * 1f));
            let _e2763 = instances.member[(0u + _e2626.instance)].object_to_world[2u];
            let _e2774 = ((((_e2763.x * _e2638.v2_.x) + (_e2763.y * _e2638.v2_.y)) + (_e2763.z * _e2638.v2_.z)) + (_e2763.w * 1f));
            let _e2787 = (((_e2660 * _e2632) + (_e2704 * _e2626.u)) + (_e2748 * _e2626.v));
            let _e2788 = (((_e2673 * _e2632) + (_e2717 * _e2626.u)) + (_e2761 * _e2626.v));
            let _e2789 = (((_e2686 * _e2632) + (_e2730 * _e2626.u)) + (_e2774 * _e2626.v));
            let _e2791 = abs(_e2660);
            let _e2792 = abs(_e2673);
            let _e2793 = abs(_e2686);
            let _e2794 = abs(_e2704);
            let _e2795 = abs(_e2717);
            let _e2796 = abs(_e2730);
            if (_e2791 > _e2794) {
                phi_3047_ = _e2791;
            } else {
                phi_3047_ = _e2794;
            }
            let _e2799 = phi_3047_;
            if (_e2792 > _e2795) {
                phi_3052_ = _e2792;
            } else {
                phi_3052_ = _e2795;
            }
            let _e2802 = phi_3052_;
            if (_e2793 > _e2796) {
                phi_3057_ = _e2793;
            } else {
                phi_3057_ = _e2796;
            }
            let _e2805 = phi_3057_;
            let _e2806 = abs(_e2748);
            let _e2807 = abs(_e2761);
            let _e2808 = abs(_e2774);
            if (_e2799 > _e2806) {
                phi_3065_ = _e2799;
            } else {
                phi_3065_ = _e2806;
            }
            let _e2811 = phi_3065_;
            if (_e2802 > _e2807) {
                phi_3070_ = _e2802;
            } else {
                phi_3070_ = _e2807;
            }
            let _e2814 = phi_3070_;
            if (_e2805 > _e2808) {
                phi_3075_ = _e2805;
            } else {
                phi_3075_ = _e2808;
            }
            let _e2817 = phi_3075_;
            let _e2818 = (_e2704 - _e2660);
            let _e2819 = (_e2717 - _e2673);
            let _e2820 = (_e2730 - _e2686);
            let _e2821 = (_e2748 - _e2660);
            let _e2822 = (_e2761 - _e2673);
            let _e2823 = (_e2774 - _e2686);
            let _e2827 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2819), abs(_e2820));
            let _e2828 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2818), _e2827);
            let _e2829 = (_e2818 / _e2828);
            let _e2830 = (_e2819 / _e2828);
            let _e2831 = (_e2820 / _e2828);
            let _e2835 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2822), abs(_e2823));
            let _e2836 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2821), _e2835);
            let _e2837 = (_e2821 / _e2836);
            let _e2838 = (_e2822 / _e2836);
            let _e2839 = (_e2823 / _e2836);
            let _e2842 = ((_e2830 * _e2839) - (_e2838 * _e2831));
            let _e2845 = ((_e2831 * _e2837) - (_e2839 * _e2829));
            let _e2848 = ((_e2829 * _e2838) - (_e2837 * _e2830));
            let _e2850 = p.member.eye;
            let _e2863 = (1f / sqrt((((_e2842 * _e2842) + (_e2845 * _e2845)) + (_e2848 * _e2848))));
            let _e2864 = (_e2842 * _e2863);
            let _e2865 = (_e2845 * _e2863);
            let _e2866 = (_e2848 * _e2863);
            if ((((_e2864 * (_e2850.x - _e2787)) + (_e2865 * (_e2850.y - _e2788))) + (_e2866 * (_e2850.z - _e2789))) < 0f) {
                phi_3139_ = vec3<f32>(-(_e2864), -(_e2865), -(_e2866));
            } else {
                phi_3139_ = vec3<f32>(_e2864, _e2865, _e2866);
            }
            let _e2879 = phi_3139_;
            if (_e2626.triangle < _e70) {
            } else {
                return;
            }
            let _e2884 = triangles.member[(0u + _e2626.triangle)];
            let _e2886 = (_e2884.i0_ & 2147483647u);
            if (_e2886 < _e73) {
            } else {
                return;
            }
            let _e2892 = vertices.member[(0u + _e2886)];
            if (_e2884.i1_ < _e73) {
            } else {
                return;
            }
            let _e2896 = vertices.member[(0u + _e2884.i1_)];
            if (_e2884.i2_ < _e73) {
            } else {
                return;
            }
            let _e2900 = vertices.member[(0u + _e2884.i2_)];
            let _e2901 = array<abi_Vertex, 3>(_e2892, _e2896, _e2900);
            if (_e2901[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2907 = materials.member[(0u + _e2901[0].material)];
            let _e2924 = (1f / 255f);
            let _e2943 = (1f / 255f);
            let _e2965 = (1f / 255f);
            let _e2978 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2632, _e2626.u, _e2626.v));
            let _e2980 = ((_e2907.base_color.x * ((((f32((_e2901[0].color & 255u)) * _e2924) * _e2632) + ((f32((_e2901[1].color & 255u)) * _e2943) * _e2626.u)) + ((f32((_e2901[2].color & 255u)) * _e2965) * _e2626.v))) * _e2978.x);
            let _e2982 = ((_e2907.base_color.y * ((((f32(((_e2901[0].color >> bitcast<u32>(8i)) & 255u)) * _e2924) * _e2632) + ((f32(((_e2901[1].color >> bitcast<u32>(8i)) & 255u)) * _e2943) * _e2626.u)) + ((f32(((_e2901[2].color >> bitcast<u32>(8i)) & 255u)) * _e2965) * _e2626.v))) * _e2978.y);
            let _e2984 = ((_e2907.base_color.z * ((((f32(((_e2901[0].color >> bitcast<u32>(16i)) & 255u)) * _e2924) * _e2632) + ((f32(((_e2901[1].color >> bitcast<u32>(16i)) & 255u)) * _e2943) * _e2626.u)) + ((f32(((_e2901[2].color >> bitcast<u32>(16i)) & 255u)) * _e2965) * _e2626.v))) * _e2978.z);
            let _e2985 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2814, _e2817);
            let _e2986 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2811, _e2985);
            if ((_e2907.flags & 2u) == 0u) {
                phi_3260_ = 0u;
            } else {
                phi_3260_ = 1u;
            }
            let _e2991 = phi_3260_;
            if (_e2901[0].normal == 2147516416u) {
                phi_3490_ = _e2879;
            } else {
                let _e3004 = (f32((bitcast<i32>((_e2901[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3010 = (f32((bitcast<i32>(_e2901[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3014 = ((1f - abs(_e3004)) - abs(_e3010));
                if (_e3014 < 0f) {
                    phi_3287_ = -(_e3014);
                } else {
                    phi_3287_ = 0f;
                }
                let _e3018 = phi_3287_;
                if (_e3004 < 0f) {
                    phi_3294_ = (_e3004 + _e3018);
                } else {
                    phi_3294_ = (_e3004 - _e3018);
                }
                let _e3023 = phi_3294_;
                if (_e3010 < 0f) {
                    phi_3301_ = (_e3010 + _e3018);
                } else {
                    phi_3301_ = (_e3010 - _e3018);
                }
                let _e3028 = phi_3301_;
                let _e3035 = (1f / sqrt((((_e3023 * _e3023) + (_e3028 * _e3028)) + (_e3014 * _e3014))));
                let _e3051 = (f32((bitcast<i32>((_e2901[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3057 = (f32((bitcast<i32>(_e2901[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3061 = ((1f - abs(_e3051)) - abs(_e3057));
                if (_e3061 < 0f) {
                    phi_3336_ = -(_e3061);
                } else {
                    phi_3336_ = 0f;
                }
                let _e3065 = phi_3336_;
                if (_e3051 < 0f) {
                    phi_3343_ = (_e3051 + _e3065);
                } else {
                    phi_3343_ = (_e3051 - _e3065);
                }
                let _e3070 = phi_3343_;
                if (_e3057 < 0f) {
                    phi_3350_ = (_e3057 + _e3065);
                } else {
                    phi_3350_ = (_e3057 - _e3065);
                }
                let _e3075 = phi_3350_;
                let _e3082 = (1f / sqrt((((_e3070 * _e3070) + (_e3075 * _e3075)) + (_e3061 * _e3061))));
                let _e3101 = (f32((bitcast<i32>((_e2901[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3107 = (f32((bitcast<i32>(_e2901[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3111 = ((1f - abs(_e3101)) - abs(_e3107));
                if (_e3111 < 0f) {
                    phi_3388_ = -(_e3111);
                } else {
                    phi_3388_ = 0f;
                }
                let _e3115 = phi_3388_;
                if (_e3101 < 0f) {
                    phi_3395_ = (_e3101 + _e3115);
                } else {
                    phi_3395_ = (_e3101 - _e3115);
                }
                let _e3120 = phi_3395_;
                if (_e3107 < 0f) {
                    phi_3402_ = (_e3107 + _e3115);
                } else {
                    phi_3402_ = (_e3107 - _e3115);
                }
                let _e3125 = phi_3402_;
                let _e3132 = (1f / sqrt((((_e3120 * _e3120) + (_e3125 * _e3125)) + (_e3111 * _e3111))));
                let _e3139 = ((((_e3023 * _e3035) * _e2632) + ((_e3070 * _e3082) * _e2626.u)) + ((_e3120 * _e3132) * _e2626.v));
                let _e3140 = ((((_e3028 * _e3035) * _e2632) + ((_e3075 * _e3082) * _e2626.u)) + ((_e3125 * _e3132) * _e2626.v));
                let _e3141 = ((((_e3014 * _e3035) * _e2632) + ((_e3061 * _e3082) * _e2626.u)) + ((_e3111 * _e3132) * _e2626.v));
                if (_e2626.instance < _e82) {
                } else {
                    return;
                }
                let _e3148 = instances.member[(0u + _e2626.instance)].world_to_object[0u];
                let _e3157 = instances.member[(0u + _e2626.instance)].world_to_object[1u];
                let _e3169 = instances.member[(0u + _e2626.instance)].world_to_object[2u];
                let _e3176 = (((_e3148.x * _e3139) + (_e3157.x * _e3140)) + (_e3169.x * _e3141));
                let _e3177 = (((_e3148.y * _e3139) + (_e3157.y * _e3140)) + (_e3169.y * _e3141));
                let _e3178 = (((_e3148.z * _e3139) + (_e3157.z * _e3140)) + (_e3169.z * _e3141));
                let _e3184 = sqrt((((_e3176 * _e3176) + (_e3177 * _e3177)) + (_e3178 * _e3178)));
                if (_e3184 > 0f) {
                    let _e3186 = (_e3176 / _e3184);
                    let _e3187 = (_e3177 / _e3184);
                    let _e3188 = (_e3178 / _e3184);
                    if ((((_e3186 * _e2879.x) + (_e3187 * _e2879.y)) + (_e3188 * _e2879.z)) < 0f) {
                        phi_3488_ = vec3<f32>(-(_e3186), -(_e3187), -(_e3188));
                    } else {
                        phi_3488_ = vec3<f32>(_e3186, _e3187, _e3188);
                    }
                    let _e3204 = phi_3488_;
                    phi_3489_ = _e3204;
                } else {
                    phi_3489_ = _e2879;
                }
                let _e3206 = phi_3489_;
                phi_3490_ = _e3206;
            }
            let _e3208 = phi_3490_;
            if (_e2980 > 0f) {
                if (_e2980 < 1f) {
                    phi_3499_ = _e2980;
                } else {
                    phi_3499_ = 1f;
                }
                let _e3212 = phi_3499_;
                phi_3500_ = _e3212;
            } else {
                phi_3500_ = 0f;
            }
            let _e3214 = phi_3500_;
            if (_e2982 > 0f) {
                if (_e2982 < 1f) {
                    phi_3510_ = _e2982;
                } else {
                    phi_3510_ = 1f;
                }
                let _e3219 = phi_3510_;
                phi_3511_ = _e3219;
            } else {
                phi_3511_ = 0f;
            }
            let _e3221 = phi_3511_;
            if (_e2984 > 0f) {
                if (_e2984 < 1f) {
                    phi_3521_ = _e2984;
                } else {
                    phi_3521_ = 1f;
                }
                let _e3226 = phi_3521_;
                phi_3522_ = _e3226;
            } else {
                phi_3522_ = 0f;
            }
            let _e3228 = phi_3522_;
            let _e3231 = ((sqrt(_e3214) * 255f) + 0.5f);
            let _e3240 = ((sqrt(_e3221) * 255f) + 0.5f);
            let _e3252 = ((sqrt(_e3228) * 255f) + 0.5f);
            phi_3557_ = abi_Sample(vec3<f32>(_e2787, _e2788, _e2789), _e2986, _e2879, _e2991, _e3208, ((select(select(u32(_e3231), 0u, (_e3231 < bitcast<f32>(0u))), 4294967295u, (_e3231 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3240), 0u, (_e3240 < bitcast<f32>(0u))), 4294967295u, (_e3240 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3252), 0u, (_e3252 < bitcast<f32>(0u))), 4294967295u, (_e3252 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3557_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3266 = phi_3557_;
        if (_e88.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e88.shift)] = _e3266;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
