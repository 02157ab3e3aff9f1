struct abi_CameraParams {
    eye: vec3<f32>,
    root: u32,
    right: vec3<f32>,
    layers_behind: u32,
    up: vec3<f32>,
    pad1_: u32,
    forward: vec3<f32>,
    pad2_: u32,
    size: vec2<u32>,
    grid: vec2<u32>,
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

struct type_16 {
    member: array<abi_Sample>,
}

struct type_24 {
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

struct type_31 {
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

struct type_35 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_39 {
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

struct type_43 {
    member: array<abi_Material>,
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

struct type_54 {
    member: array<lt_bvh_Instance>,
}

struct type_58 {
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
var<storage> vertices: type_39;
@group(0) @binding(4) 
var<storage> materials: type_43;
@group(0) @binding(0) 
var<uniform> p: type_58;
@group(0) @binding(1) 
var<storage> nodes: type_31;
@group(0) @binding(2) 
var<storage> triangles: type_35;
@group(0) @binding(5) 
var<storage, read_write> samples: type_16;
@group(0) @binding(6) 
var<storage> instances: type_54;
@group(0) @binding(7) 
var<storage> before: type_24;
@group(0) @binding(8) 
var<storage, read_write> past: type_24;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_207_: lt_bvh_traverse_Tree;
    var phi_208_: bool;
    var phi_209_: lt_bvh_traverse_Tree;
    var phi_210_: bool;
    var phi_215_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_207_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_208_ = false;
        } else {
            phi_207_ = lt_bvh_traverse_Tree();
            phi_208_ = true;
        }
        let _e77 = phi_207_;
        let _e79 = phi_208_;
        phi_209_ = _e77;
        phi_210_ = _e79;
    } else {
        phi_209_ = lt_bvh_traverse_Tree();
        phi_210_ = true;
    }
    let _e81 = phi_209_;
    let _e83 = phi_210_;
    if _e83 {
        phi_215_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_215_ = _e81;
    }
    let _e88 = phi_215_;
    return lt_bvh_traverse_Tree(_e88.root, _e88.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_230_: bool;
    var phi_234_: f32;

    if (param_3 != param_3) {
        phi_230_ = true;
    } else {
        let _e67 = (param_4 >= param_3);
        if _e67 {
        }
        phi_230_ = _e67;
    }
    let _e69 = phi_230_;
    if _e69 {
        phi_234_ = param_4;
    } else {
        phi_234_ = param_3;
    }
    let _e71 = phi_234_;
    return _e71;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_246_: bool;
    var phi_250_: f32;

    if (param_5 != param_5) {
        phi_246_ = true;
    } else {
        let _e67 = (param_6 <= param_5);
        if _e67 {
        }
        phi_246_ = _e67;
    }
    let _e69 = phi_246_;
    if _e69 {
        phi_250_ = param_6;
    } else {
        phi_250_ = param_5;
    }
    let _e71 = phi_250_;
    return _e71;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_262_: f32;

    if (param_9 > param_10) {
        phi_262_ = param_9;
    } else {
        phi_262_ = param_10;
    }
    let _e68 = phi_262_;
    return _e68;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var local_1: lt_bvh_traverse_Stack;
    var phi_407_: bool;
    var phi_408_: bool;
    var phi_409_: bool;
    var phi_410_: bool;
    var phi_414_: bool;
    var phi_427_: bool;
    var phi_428_: bool;
    var phi_429_: bool;
    var phi_430_: bool;
    var phi_434_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_461_: bool;
    var phi_537_: f32;
    var phi_544_: f32;
    var phi_552_: f32;
    var phi_559_: f32;
    var phi_567_: f32;
    var phi_574_: f32;
    var phi_597_: f32;
    var phi_602_: f32;
    var phi_607_: f32;
    var phi_612_: f32;
    var phi_617_: f32;
    var phi_636_: u32;
    var phi_641_: u32;
    var phi_646_: u32;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_792_: u32;
    var phi_794_: u32;
    var phi_797_: lt_bvh_Hit;
    var phi_882_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_909_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_936_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_942_: u32;
    var phi_945_: u32;
    var phi_959_: u32;
    var phi_969_: u32;
    var phi_979_: u32;
    var phi_997_: u32;
    var phi_1007_: u32;
    var phi_1017_: u32;
    var phi_1053_: u32;
    var phi_1066_: u32;
    var phi_1071_: u32;
    var phi_1072_: u32;
    var phi_1073_: u32;
    var phi_943_: u32;
    var phi_946_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1131_: u32;
    var phi_1134_: lt_bvh_Hit;
    var phi_1189_: f32;
    var phi_1194_: f32;
    var phi_1199_: f32;
    var phi_1207_: f32;
    var phi_1212_: f32;
    var phi_1217_: f32;
    var phi_1349_: bool;
    var phi_1350_: bool;
    var phi_1351_: bool;
    var phi_1352_: bool;
    var phi_1356_: bool;
    var phi_1369_: bool;
    var phi_1370_: bool;
    var phi_1371_: bool;
    var phi_1372_: bool;
    var phi_1376_: bool;
    var phi_1389_: bool;
    var phi_1390_: bool;
    var phi_1391_: bool;
    var phi_1395_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1403_: bool;
    var phi_1473_: f32;
    var phi_1480_: f32;
    var phi_1487_: f32;
    var phi_1494_: f32;
    var phi_1501_: f32;
    var phi_1508_: f32;
    var phi_1525_: f32;
    var phi_1530_: f32;
    var phi_1535_: f32;
    var phi_1540_: f32;
    var phi_1545_: f32;
    var phi_1571_: bool;
    var phi_1572_: bool;
    var phi_1580_: u32;
    var phi_1581_: u32;
    var phi_1592_: vec3<f32>;
    var phi_1593_: vec3<f32>;
    var phi_1606_: u32;
    var phi_1611_: u32;
    var phi_1616_: u32;
    var phi_1730_: bool;
    var phi_1731_: bool;
    var phi_1762_: u32;
    var phi_1764_: lt_bvh_Hit;
    var phi_1767_: u32;
    var phi_1848_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1875_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1902_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1908_: u32;
    var phi_1911_: u32;
    var phi_1925_: u32;
    var phi_1935_: u32;
    var phi_1945_: u32;
    var phi_1963_: u32;
    var phi_1973_: u32;
    var phi_1983_: u32;
    var phi_2019_: u32;
    var phi_2032_: u32;
    var phi_2037_: u32;
    var phi_2038_: u32;
    var phi_2039_: u32;
    var phi_1909_: u32;
    var phi_1912_: u32;
    var local_5: u32;
    var local_6: u32;
    var local_7: u32;
    var phi_2097_: lt_bvh_Hit;
    var phi_2100_: u32;
    var phi_2144_: vec3<f32>;
    var phi_2145_: vec3<f32>;
    var phi_2174_: vec3<f32>;
    var phi_2175_: vec3<f32>;
    var phi_2204_: vec3<f32>;
    var phi_2205_: vec3<f32>;
    var phi_2223_: bool;
    var phi_2224_: bool;
    var phi_2228_: f32;
    var phi_2229_: f32;
    var phi_2230_: f32;
    var phi_2231_: f32;
    var phi_2239_: f32;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2254_: f32;
    var phi_2255_: f32;
    var phi_2256_: f32;
    var phi_2257_: f32;
    var phi_2265_: f32;
    var phi_2275_: bool;
    var phi_2276_: bool;
    var phi_2280_: f32;
    var phi_2281_: f32;
    var phi_2282_: f32;
    var phi_2283_: f32;
    var phi_2291_: f32;
    var phi_2306_: f32;
    var phi_2307_: bool;
    var phi_2308_: f32;
    var phi_2309_: bool;
    var phi_2310_: f32;
    var phi_2311_: bool;
    var phi_2329_: f32;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2332_: f32;
    var phi_2333_: bool;
    var phi_2334_: bool;
    var phi_2338_: bool;
    var phi_2339_: f32;
    var phi_2340_: bool;
    var phi_2368_: vec3<f32>;
    var phi_2369_: vec3<f32>;
    var phi_2394_: vec3<f32>;
    var phi_2395_: vec3<f32>;
    var phi_2420_: vec3<f32>;
    var phi_2421_: vec3<f32>;
    var phi_2477_: f32;
    var phi_2486_: f32;
    var phi_2495_: f32;
    var phi_2504_: f32;
    var phi_2511_: f32;
    var phi_2518_: f32;
    var phi_2531_: f32;
    var phi_2540_: f32;
    var phi_2549_: f32;
    var phi_2558_: f32;
    var phi_2565_: f32;
    var phi_2572_: f32;
    var phi_2589_: f32;
    var phi_2594_: f32;
    var phi_2599_: f32;
    var phi_2607_: f32;
    var phi_2612_: f32;
    var phi_2617_: f32;
    var phi_2629_: f32;
    var phi_2634_: f32;
    var phi_2639_: f32;
    var phi_2644_: f32;
    var phi_2649_: lt_bvh_triangle_Intersection;
    var phi_2650_: bool;
    var phi_2651_: lt_bvh_triangle_Intersection;
    var phi_2652_: bool;
    var phi_2656_: lt_bvh_triangle_Intersection;
    var phi_2657_: bool;
    var phi_2658_: lt_bvh_triangle_Intersection;
    var phi_2659_: bool;
    var phi_2660_: bool;
    var phi_2664_: bool;
    var phi_2668_: lt_bvh_triangle_Intersection;
    var phi_2706_: bool;
    var phi_2707_: bool;
    var phi_2708_: bool;
    var phi_2709_: bool;
    var phi_2710_: bool;
    var phi_2711_: bool;
    var phi_2715_: bool;
    var phi_2716_: bool;
    var phi_2730_: bool;
    var phi_2738_: lt_bvh_Hit;
    var phi_2739_: lt_bvh_Hit;
    var phi_2740_: lt_bvh_Hit;
    var phi_2741_: lt_bvh_Hit;
    var phi_2098_: lt_bvh_Hit;
    var phi_2101_: u32;
    var phi_2742_: bool;
    var phi_2781_: bool;
    var phi_2782_: bool;
    var phi_2813_: u32;
    var phi_1765_: lt_bvh_Hit;
    var phi_1768_: u32;
    var phi_2814_: lt_bvh_Hit;
    var phi_2815_: lt_bvh_Hit;
    var phi_2816_: bool;
    var phi_2820_: lt_bvh_Hit;
    var phi_2821_: lt_bvh_Hit;
    var phi_2822_: lt_bvh_Hit;
    var phi_2823_: lt_bvh_Hit;
    var phi_1132_: u32;
    var phi_1135_: lt_bvh_Hit;
    var phi_2824_: bool;
    var phi_2863_: bool;
    var phi_2864_: bool;
    var phi_2895_: u32;
    var phi_795_: u32;
    var phi_798_: lt_bvh_Hit;
    var phi_2896_: lt_bvh_Hit;
    var phi_2897_: lt_bvh_Hit;
    var phi_2898_: bool;
    var phi_2902_: lt_bvh_Hit;
    var phi_3090_: f32;
    var phi_3095_: f32;
    var phi_3100_: f32;
    var phi_3108_: f32;
    var phi_3113_: f32;
    var phi_3118_: f32;
    var phi_3182_: vec3<f32>;
    var phi_3303_: u32;
    var phi_3330_: f32;
    var phi_3337_: f32;
    var phi_3344_: f32;
    var phi_3379_: f32;
    var phi_3386_: f32;
    var phi_3393_: f32;
    var phi_3431_: f32;
    var phi_3438_: f32;
    var phi_3445_: f32;
    var phi_3531_: vec3<f32>;
    var phi_3532_: vec3<f32>;
    var phi_3533_: vec3<f32>;
    var phi_3542_: f32;
    var phi_3543_: f32;
    var phi_3553_: f32;
    var phi_3554_: f32;
    var phi_3564_: f32;
    var phi_3565_: f32;
    var phi_3600_: abi_Sample;
    var phi_3823_: vec3<f32>;
    var local_8: lt_bvh_Hit;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;

    let _e66 = id_1;
    let _e70 = arrayLength((&nodes.member));
    let _e73 = arrayLength((&triangles.member));
    let _e76 = arrayLength((&vertices.member));
    let _e85 = arrayLength((&instances.member));
    let _e88 = arrayLength((&before.member));
    let _e94 = p.member.size[0u];
    let _e96 = p.member.size[1u];
    let _e97 = lt_shaders_entry_pixel_index(_e66, _e94, _e96);
    if (bitcast<i32>(_e97.root) != 0i) {
        let _e103 = p.member.root;
        let _e107 = p.member.eye;
        let _e110 = p.member.grid[0u];
        let _e112 = p.member.grid[1u];
        let _e131 = p.member.size[0u];
        let _e135 = ((((f32(_e66.x) + ((f32((_e66.y & (_e112 - 1u))) + 0.5f) / f32(_e112))) / f32(_e131)) * 2f) - 1f);
        let _e138 = p.member.size[1u];
        let _e142 = (1f - (((f32(_e66.y) + ((f32((_e66.x & (_e110 - 1u))) + 0.5f) / f32(_e110))) / f32(_e138)) * 2f));
        let _e144 = p.member.forward;
        let _e146 = p.member.right;
        let _e160 = p.member.up;
        let _e171 = _lt_bvh_ray_Ray_new(_e107, vec3<f32>(((_e144.x + (_e146.x * _e135)) + (_e160.x * _e142)), ((_e144.y + (_e146.y * _e135)) + (_e160.y * _e142)), ((_e144.z + (_e146.z * _e135)) + (_e160.z * _e142))));
        let _e173 = lt_bvh_Hit(_e171.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e176 = abs(_e171.direction.x);
        let _e178 = abs(_e171.direction.y);
        let _e180 = abs(_e171.direction.z);
        if (abs(_e171.origin.x) < 1000000000000000f) {
            if (abs(_e171.origin.y) < 1000000000000000f) {
                phi_407_ = (abs(_e171.origin.z) < 1000000000000000f);
                phi_408_ = false;
            } else {
                phi_407_ = bool();
                phi_408_ = true;
            }
            let _e192 = phi_407_;
            let _e194 = phi_408_;
            phi_409_ = _e192;
            phi_410_ = _e194;
        } else {
            phi_409_ = bool();
            phi_410_ = true;
        }
        let _e196 = phi_409_;
        let _e198 = phi_410_;
        if _e198 {
            phi_414_ = false;
        } else {
            phi_414_ = _e196;
        }
        let _e200 = phi_414_;
        if _e200 {
            if (_e176 < 1000000000000000f) {
                if (_e178 < 1000000000000000f) {
                    phi_427_ = (_e180 < 1000000000000000f);
                    phi_428_ = false;
                } else {
                    phi_427_ = bool();
                    phi_428_ = true;
                }
                let _e205 = phi_427_;
                let _e207 = phi_428_;
                phi_429_ = _e205;
                phi_430_ = _e207;
            } else {
                phi_429_ = bool();
                phi_430_ = true;
            }
            let _e209 = phi_429_;
            let _e211 = phi_430_;
            if _e211 {
                phi_434_ = false;
            } else {
                phi_434_ = _e209;
            }
            let _e213 = phi_434_;
            if _e213 {
                if (_e176 > 0f) {
                    phi_448_ = bool();
                    phi_449_ = true;
                } else {
                    let _e215 = (_e178 > 0f);
                    if _e215 {
                        phi_447_ = bool();
                    } else {
                        phi_447_ = (_e180 > 0f);
                    }
                    let _e218 = phi_447_;
                    phi_448_ = _e218;
                    phi_449_ = _e215;
                }
                let _e220 = phi_448_;
                let _e222 = phi_449_;
                if _e222 {
                    phi_453_ = true;
                } else {
                    phi_453_ = _e220;
                }
                let _e224 = phi_453_;
                phi_454_ = _e224;
                phi_455_ = false;
            } else {
                phi_454_ = bool();
                phi_455_ = true;
            }
            let _e226 = phi_454_;
            let _e228 = phi_455_;
            phi_456_ = _e226;
            phi_457_ = _e228;
        } else {
            phi_456_ = bool();
            phi_457_ = true;
        }
        let _e230 = phi_456_;
        let _e232 = phi_457_;
        if _e232 {
            phi_461_ = false;
        } else {
            phi_461_ = _e230;
        }
        let _e234 = phi_461_;
        if _e234 {
            let _e235 = (_e103 >= _e70);
            if _e235 {
                phi_2896_ = lt_bvh_Hit();
            } else {
                if (_e103 < _e70) {
                } else {
                    return;
                }
                let _e241 = nodes.member[(0u + _e103)].frame[0u];
                let _e245 = nodes.member[(0u + _e103)].frame[1u];
                let _e249 = nodes.member[(0u + _e103)].frame[2u];
                let _e253 = nodes.member[(0u + _e103)].frame[0u];
                let _e257 = nodes.member[(0u + _e103)].frame[1u];
                let _e261 = nodes.member[(0u + _e103)].frame[2u];
                let _e265 = nodes.member[(0u + _e103)].frame[3u];
                let _e304 = core_intrinsics_maximum_number_nsz_f32_(abs(_e171.direction.x), abs(_e171.direction.y));
                let _e305 = core_intrinsics_maximum_number_nsz_f32_(_e304, abs(_e171.direction.z));
                let _e306 = (_e305 * 0.0000000000009094947f);
                if (abs(_e171.direction.x) < _e306) {
                    phi_537_ = _e306;
                } else {
                    phi_537_ = abs(_e171.direction.x);
                }
                let _e312 = phi_537_;
                if (_e171.direction.x < 0f) {
                    phi_544_ = (-1f / _e312);
                } else {
                    phi_544_ = (1f / _e312);
                }
                let _e317 = phi_544_;
                if (abs(_e171.direction.y) < _e306) {
                    phi_552_ = _e306;
                } else {
                    phi_552_ = abs(_e171.direction.y);
                }
                let _e323 = phi_552_;
                if (_e171.direction.y < 0f) {
                    phi_559_ = (-1f / _e323);
                } else {
                    phi_559_ = (1f / _e323);
                }
                let _e328 = phi_559_;
                if (abs(_e171.direction.z) < _e306) {
                    phi_567_ = _e306;
                } else {
                    phi_567_ = abs(_e171.direction.z);
                }
                let _e334 = phi_567_;
                if (_e171.direction.z < 0f) {
                    phi_574_ = (-1f / _e334);
                } else {
                    phi_574_ = (1f / _e334);
                }
                let _e339 = phi_574_;
                let _e346 = abs((bitcast<f32>(_e241) - _e171.origin.x));
                let _e347 = abs((bitcast<f32>(_e245) - _e171.origin.y));
                let _e348 = abs((bitcast<f32>(_e249) - _e171.origin.z));
                let _e355 = abs(((bitcast<f32>(_e253) + (bitcast<f32>((((_e265 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e171.origin.x));
                let _e356 = abs(((bitcast<f32>(_e257) + (bitcast<f32>((((_e265 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e171.origin.y));
                let _e357 = abs(((bitcast<f32>(_e261) + (bitcast<f32>((((_e265 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e171.origin.z));
                if (_e346 > _e355) {
                    phi_597_ = _e346;
                } else {
                    phi_597_ = _e355;
                }
                let _e360 = phi_597_;
                if (_e347 > _e356) {
                    phi_602_ = _e347;
                } else {
                    phi_602_ = _e356;
                }
                let _e363 = phi_602_;
                if (_e348 > _e357) {
                    phi_607_ = _e348;
                } else {
                    phi_607_ = _e357;
                }
                let _e366 = phi_607_;
                if (_e360 > _e363) {
                    phi_612_ = _e360;
                } else {
                    phi_612_ = _e363;
                }
                let _e369 = phi_612_;
                if (_e369 > _e366) {
                    phi_617_ = _e369;
                } else {
                    phi_617_ = _e366;
                }
                let _e372 = phi_617_;
                let _e376 = (_e372 * 0.0000019073486f);
                let _e377 = (abs(_e317) * _e376);
                let _e378 = (abs(_e328) * _e376);
                let _e379 = (abs(_e339) * _e376);
                let _e383 = (_e372 * 0.0000009536743f);
                let _e384 = (abs(_e317) * _e383);
                let _e385 = (abs(_e328) * _e383);
                let _e386 = (abs(_e339) * _e383);
                if (_e317 < 0f) {
                    phi_636_ = 0u;
                } else {
                    phi_636_ = 1u;
                }
                let _e389 = phi_636_;
                if (_e328 < 0f) {
                    phi_641_ = 0u;
                } else {
                    phi_641_ = 2u;
                }
                let _e392 = phi_641_;
                if (_e339 < 0f) {
                    phi_646_ = 0u;
                } else {
                    phi_646_ = 4u;
                }
                let _e395 = phi_646_;
                let _e397 = ((_e389 | _e392) | _e395);
                let _e398 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e103, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e398.first[0], _e398.first[1], _e398.first[2], _e398.first[3], _e398.first[4], _e398.first[5], _e398.first[6], _e398.first[7], _e398.first[8], _e398.first[9], _e398.first[10], _e398.first[11], _e398.first[12], _e398.first[13], _e398.first[14], _e398.first[15], _e398.first[16], _e398.first[17], _e398.first[18], _e398.first[19], _e398.first[20], _e398.first[21], _e398.first[22], _e398.first[23], _e398.first[24], _e398.first[25], _e398.first[26], _e398.first[27], _e398.first[28], _e398.first[29], _e398.first[30], _e398.first[31]), array<u32, 32>(_e398.mask[0], _e398.mask[1], _e398.mask[2], _e398.mask[3], _e398.mask[4], _e398.mask[5], _e398.mask[6], _e398.mask[7], _e398.mask[8], _e398.mask[9], _e398.mask[10], _e398.mask[11], _e398.mask[12], _e398.mask[13], _e398.mask[14], _e398.mask[15], _e398.mask[16], _e398.mask[17], _e398.mask[18], _e398.mask[19], _e398.mask[20], _e398.mask[21], _e398.mask[22], _e398.mask[23], _e398.mask[24], _e398.mask[25], _e398.mask[26], _e398.mask[27], _e398.mask[28], _e398.mask[29], _e398.mask[30], _e398.mask[31]), _e398.len, _e398.group, _e398.group_mask);
                let _e472 = local_1.group_mask;
                if ((_e472 & 4278190080u) == 0u) {
                    let _e476 = local_1.len;
                    if (_e476 == 0u) {
                        phi_760_ = false;
                    } else {
                        let _e480 = local_1.len;
                        local_1.len = (_e480 - 1u);
                        let _e483 = local_1.len;
                        if (_e483 < 32u) {
                        } else {
                            return;
                        }
                        let _e488 = local_1.first[(0u + _e483)];
                        local_1.group = _e488;
                        let _e491 = local_1.len;
                        if (_e491 < 32u) {
                        } else {
                            return;
                        }
                        let _e496 = local_1.mask[(0u + _e491)];
                        local_1.group_mask = _e496;
                        phi_760_ = true;
                    }
                    let _e499 = phi_760_;
                    phi_761_ = _e499;
                } else {
                    phi_761_ = true;
                }
                let _e501 = phi_761_;
                if _e501 {
                    let _e503 = local_1.group_mask;
                    let _e509 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e503)), 32u, (_e503 == 0u)));
                    let _e513 = local_1.group_mask;
                    let _e527 = local_1.group_mask;
                    local_1.group_mask = (_e527 & ~((1u << bitcast<u32>((_e509 & 31u)))));
                    let _e530 = local_1.group;
                    phi_792_ = (_e530 + countOneBits(((_e513 & ~((4294967295u << bitcast<u32>((((_e509 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_792_ = 4294967295u;
                }
                let _e533 = phi_792_;
                phi_794_ = _e533;
                phi_797_ = _e173;
                loop {
                    let _e535 = phi_794_;
                    let _e537 = phi_797_;
                    local_11 = _e537;
                    let _e538 = (_e535 != 4294967295u);
                    if _e538 {
                        if (_e535 < _e70) {
                        } else {
                            return;
                        }
                        let _e546 = nodes.member[(0u + _e535)].frame[3u];
                        let _e571 = (bitcast<f32>((((_e546 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e317);
                        let _e572 = (bitcast<f32>((((_e546 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e328);
                        let _e573 = (bitcast<f32>((((_e546 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e339);
                        let _e576 = nodes.member[(0u + _e535)].frame[0u];
                        let _e580 = nodes.member[(0u + _e535)].frame[1u];
                        let _e584 = nodes.member[(0u + _e535)].frame[2u];
                        let _e592 = ((bitcast<f32>(_e576) - _e171.origin.x) * _e317);
                        let _e593 = ((bitcast<f32>(_e580) - _e171.origin.y) * _e328);
                        let _e594 = ((bitcast<f32>(_e584) - _e171.origin.z) * _e339);
                        let _e602 = nodes.member[(0u + _e535)].x;
                        if (_e317 < 0f) {
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e613.unnamed.root, _e602.w), _e613.unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_bvh_traverse_Tree(_e602.x, _e619.unnamed_1.first_primitive));
                            phi_882_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_bvh_traverse_Tree(_e625.unnamed_1.root, _e602.y));
                        } else {
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e602.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e641.unnamed.root, _e602.y), _e641.unnamed_1);
                            let _e653 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_bvh_traverse_Tree(_e602.z, _e647.unnamed_1.first_primitive));
                            phi_882_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e653.unnamed, lt_bvh_traverse_Tree(_e653.unnamed_1.root, _e602.w));
                        }
                        let _e661 = phi_882_;
                        let _e671 = nodes.member[(0u + _e535)].y;
                        if (_e328 < 0f) {
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e682.unnamed.root, _e671.w), _e682.unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_bvh_traverse_Tree(_e671.x, _e688.unnamed_1.first_primitive));
                            phi_909_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e694.unnamed_1.root, _e671.y));
                        } else {
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e671.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e710.unnamed.root, _e671.y), _e710.unnamed_1);
                            let _e722 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_bvh_traverse_Tree(_e671.z, _e716.unnamed_1.first_primitive));
                            phi_909_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e722.unnamed, lt_bvh_traverse_Tree(_e722.unnamed_1.root, _e671.w));
                        }
                        let _e730 = phi_909_;
                        let _e740 = nodes.member[(0u + _e535)].z;
                        if (_e339 < 0f) {
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e740.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e751.unnamed.root, _e740.w), _e751.unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_bvh_traverse_Tree(_e740.x, _e757.unnamed_1.first_primitive));
                            phi_936_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e763.unnamed_1.root, _e740.y));
                        } else {
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e740.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e779.unnamed.root, _e740.y), _e779.unnamed_1);
                            let _e791 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_bvh_traverse_Tree(_e740.z, _e785.unnamed_1.first_primitive));
                            phi_936_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e791.unnamed, lt_bvh_traverse_Tree(_e791.unnamed_1.root, _e740.w));
                        }
                        let _e799 = phi_936_;
                        phi_942_ = 0u;
                        phi_945_ = 0u;
                        loop {
                            let _e809 = phi_942_;
                            let _e811 = phi_945_;
                            local_2 = _e811;
                            local_3 = _e811;
                            local_4 = _e811;
                            let _e812 = (_e809 < 8u);
                            if _e812 {
                                let _e814 = (_e809 >> bitcast<u32>(2i));
                                let _e815 = (_e809 & 3u);
                                if (_e814 == 0u) {
                                    phi_959_ = _e661.unnamed.root;
                                } else {
                                    phi_959_ = _e661.unnamed.first_primitive;
                                }
                                let _e818 = phi_959_;
                                if (_e814 == 0u) {
                                    phi_969_ = _e730.unnamed.root;
                                } else {
                                    phi_969_ = _e730.unnamed.first_primitive;
                                }
                                let _e827 = phi_969_;
                                if (_e814 == 0u) {
                                    phi_979_ = _e799.unnamed.root;
                                } else {
                                    phi_979_ = _e799.unnamed.first_primitive;
                                }
                                let _e836 = phi_979_;
                                let _e849 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e818 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 - _e377)), ((f32(((_e827 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 - _e378)));
                                let _e850 = core_intrinsics_maximum_number_nsz_f32_(_e849, ((f32(((_e836 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 - _e379)));
                                if (_e814 == 0u) {
                                    phi_997_ = _e661.unnamed_1.root;
                                } else {
                                    phi_997_ = _e661.unnamed_1.first_primitive;
                                }
                                let _e853 = phi_997_;
                                if (_e814 == 0u) {
                                    phi_1007_ = _e730.unnamed_1.root;
                                } else {
                                    phi_1007_ = _e730.unnamed_1.first_primitive;
                                }
                                let _e862 = phi_1007_;
                                if (_e814 == 0u) {
                                    phi_1017_ = _e799.unnamed_1.root;
                                } else {
                                    phi_1017_ = _e799.unnamed_1.first_primitive;
                                }
                                let _e871 = phi_1017_;
                                let _e884 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e853 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e571) + (_e592 + _e377)), ((f32(((_e862 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e572) + (_e593 + _e378)));
                                let _e885 = core_intrinsics_minimum_number_nsz_f32_(_e884, ((f32(((_e871 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u)) * _e573) + (_e594 + _e379)));
                                if (_e850 <= _e885) {
                                    if (_e850 <= _e537.t) {
                                        if (_e885 >= _e171.tmin) {
                                            if (_e814 == 0u) {
                                                let _e892 = nodes.member[(0u + _e535)].links[2u];
                                                phi_1053_ = _e892;
                                            } else {
                                                let _e895 = nodes.member[(0u + _e535)].links[3u];
                                                phi_1053_ = _e895;
                                            }
                                            let _e897 = phi_1053_;
                                            let _e902 = ((_e897 >> bitcast<u32>(((_e815 * 8u) & 31u))) & 255u);
                                            let _e903 = (_e902 & 31u);
                                            if (_e903 >= 24u) {
                                                phi_1066_ = (24u + ((_e903 - 24u) ^ _e397));
                                            } else {
                                                phi_1066_ = _e903;
                                            }
                                            let _e909 = phi_1066_;
                                            phi_1071_ = (_e811 | ((_e902 >> bitcast<u32>(5i)) << bitcast<u32>((_e909 & 31u))));
                                        } else {
                                            phi_1071_ = _e811;
                                        }
                                        let _e917 = phi_1071_;
                                        phi_1072_ = _e917;
                                    } else {
                                        phi_1072_ = _e811;
                                    }
                                    let _e919 = phi_1072_;
                                    phi_1073_ = _e919;
                                } else {
                                    phi_1073_ = _e811;
                                }
                                let _e921 = phi_1073_;
                                phi_943_ = (_e809 + 1u);
                                phi_946_ = _e921;
                            } else {
                                phi_943_ = u32();
                                phi_946_ = u32();
                            }
                            let _e924 = phi_943_;
                            let _e926 = phi_946_;
                            continue;
                            continuing {
                                phi_942_ = _e924;
                                phi_945_ = _e926;
                                break if !(_e812);
                            }
                        }
                        let _e930 = nodes.member[(0u + _e535)].links[0u];
                        let _e934 = nodes.member[(0u + _e535)].frame[3u];
                        let _e938 = local_2;
                        if ((_e938 & 4278190080u) == 0u) {
                        } else {
                            let _e942 = local_1.group_mask;
                            if ((_e942 & 4278190080u) == 0u) {
                            } else {
                                let _e946 = local_1.len;
                                if (_e946 < 32u) {
                                    let _e949 = local_1.group;
                                    let _e951 = local_1.len;
                                    if (_e951 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e951)] = _e949;
                                    let _e957 = local_1.group_mask;
                                    let _e959 = local_1.len;
                                    if (_e959 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e959)] = _e957;
                                    let _e966 = local_1.len;
                                    local_1.len = (_e966 + 1u);
                                }
                            }
                            local_1.group = (_e103 + _e930);
                            let _e970 = local_3;
                            local_1.group_mask = ((_e970 & 4278190080u) | (_e934 >> bitcast<u32>(24i)));
                        }
                        let _e975 = local_4;
                        phi_1131_ = (_e975 & 16777215u);
                        phi_1134_ = _e537;
                        loop {
                            let _e978 = phi_1131_;
                            let _e980 = phi_1134_;
                            local_10 = _e980;
                            if (_e978 == 0u) {
                                phi_1132_ = u32();
                                phi_1135_ = lt_bvh_Hit();
                                phi_2824_ = false;
                            } else {
                                let _e984 = nodes.member[(0u + _e535)].links[1u];
                                let _e988 = (_e984 + select(firstTrailingBit(_e978), 32u, (_e978 == 0u)));
                                if (_e988 < _e85) {
                                } else {
                                    return;
                                }
                                let _e995 = instances.member[(0u + _e988)].low_world;
                                let _e997 = instances.member[(0u + _e988)].high_world;
                                let _e1007 = ((_e995.x - _e171.origin.x) * _e317);
                                let _e1008 = ((_e995.y - _e171.origin.y) * _e328);
                                let _e1009 = ((_e995.z - _e171.origin.z) * _e339);
                                let _e1019 = ((_e997.x - _e171.origin.x) * _e317);
                                let _e1020 = ((_e997.y - _e171.origin.y) * _e328);
                                let _e1021 = ((_e997.z - _e171.origin.z) * _e339);
                                if (_e1007 < _e1019) {
                                    phi_1189_ = _e1007;
                                } else {
                                    phi_1189_ = _e1019;
                                }
                                let _e1024 = phi_1189_;
                                if (_e1008 < _e1020) {
                                    phi_1194_ = _e1008;
                                } else {
                                    phi_1194_ = _e1020;
                                }
                                let _e1027 = phi_1194_;
                                if (_e1009 < _e1021) {
                                    phi_1199_ = _e1009;
                                } else {
                                    phi_1199_ = _e1021;
                                }
                                let _e1030 = phi_1199_;
                                if (_e1007 > _e1019) {
                                    phi_1207_ = _e1007;
                                } else {
                                    phi_1207_ = _e1019;
                                }
                                let _e1036 = phi_1207_;
                                if (_e1008 > _e1020) {
                                    phi_1212_ = _e1008;
                                } else {
                                    phi_1212_ = _e1020;
                                }
                                let _e1039 = phi_1212_;
                                if (_e1009 > _e1021) {
                                    phi_1217_ = _e1009;
                                } else {
                                    phi_1217_ = _e1021;
                                }
                                let _e1042 = phi_1217_;
                                let _e1046 = core_intrinsics_maximum_number_nsz_f32_((_e1024 - _e384), (_e1027 - _e385));
                                let _e1047 = core_intrinsics_maximum_number_nsz_f32_(_e1046, (_e1030 - _e386));
                                let _e1048 = core_intrinsics_minimum_number_nsz_f32_((_e1036 + _e384), (_e1039 + _e385));
                                let _e1049 = core_intrinsics_minimum_number_nsz_f32_(_e1048, (_e1042 + _e386));
                                if (_e1047 <= _e1049) {
                                    if (_e1047 <= _e980.t) {
                                        if (_e1049 >= _e171.tmin) {
                                            let _e1061 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1072 = ((((_e1061.x * _e171.origin.x) + (_e1061.y * _e171.origin.y)) + (_e1061.z * _e171.origin.z)) + (_e1061.w * 1f));
                                            let _e1074 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1085 = ((((_e1074.x * _e171.origin.x) + (_e1074.y * _e171.origin.y)) + (_e1074.z * _e171.origin.z)) + (_e1074.w * 1f));
                                            let _e1087 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1098 = ((((_e1087.x * _e171.origin.x) + (_e1087.y * _e171.origin.y)) + (_e1087.z * _e171.origin.z)) + (_e1087.w * 1f));
                                            let _e1105 = instances.member[(0u + _e988)].world_to_object[0u];
                                            let _e1116 = ((((_e1105.x * _e171.direction.x) + (_e1105.y * _e171.direction.y)) + (_e1105.z * _e171.direction.z)) + (_e1105.w * 0f));
                                            let _e1118 = instances.member[(0u + _e988)].world_to_object[1u];
                                            let _e1129 = ((((_e1118.x * _e171.direction.x) + (_e1118.y * _e171.direction.y)) + (_e1118.z * _e171.direction.z)) + (_e1118.w * 0f));
                                            let _e1131 = instances.member[(0u + _e988)].world_to_object[2u];
                                            let _e1142 = ((((_e1131.x * _e171.direction.x) + (_e1131.y * _e171.direction.y)) + (_e1131.z * _e171.direction.z)) + (_e1131.w * 0f));
                                            let _e1147 = instances.member[(0u + _e988)].root;
                                            let _e1149 = instances.member[(0u + _e988)].first_triangle;
                                            let _e1150 = abs(_e1116);
                                            let _e1151 = abs(_e1129);
                                            let _e1152 = abs(_e1142);
                                            if (abs(_e1072) < 1000000000000000f) {
                                                if (abs(_e1085) < 1000000000000000f) {
                                                    phi_1349_ = (abs(_e1098) < 1000000000000000f);
                                                    phi_1350_ = false;
                                                } else {
                                                    phi_1349_ = bool();
                                                    phi_1350_ = true;
                                                }
                                                let _e1160 = phi_1349_;
                                                let _e1162 = phi_1350_;
                                                phi_1351_ = _e1160;
                                                phi_1352_ = _e1162;
                                            } else {
                                                phi_1351_ = bool();
                                                phi_1352_ = true;
                                            }
                                            let _e1164 = phi_1351_;
                                            let _e1166 = phi_1352_;
                                            if _e1166 {
                                                phi_1356_ = false;
                                            } else {
                                                phi_1356_ = _e1164;
                                            }
                                            let _e1168 = phi_1356_;
                                            if _e1168 {
                                                if (_e1150 < 1000000000000000f) {
                                                    if (_e1151 < 1000000000000000f) {
                                                        phi_1369_ = (_e1152 < 1000000000000000f);
                                                        phi_1370_ = false;
                                                    } else {
                                                        phi_1369_ = bool();
                                                        phi_1370_ = true;
                                                    }
                                                    let _e1173 = phi_1369_;
                                                    let _e1175 = phi_1370_;
                                                    phi_1371_ = _e1173;
                                                    phi_1372_ = _e1175;
                                                } else {
                                                    phi_1371_ = bool();
                                                    phi_1372_ = true;
                                                }
                                                let _e1177 = phi_1371_;
                                                let _e1179 = phi_1372_;
                                                if _e1179 {
                                                    phi_1376_ = false;
                                                } else {
                                                    phi_1376_ = _e1177;
                                                }
                                                let _e1181 = phi_1376_;
                                                if _e1181 {
                                                    if (_e1150 > 0f) {
                                                        phi_1390_ = bool();
                                                        phi_1391_ = true;
                                                    } else {
                                                        let _e1183 = (_e1151 > 0f);
                                                        if _e1183 {
                                                            phi_1389_ = bool();
                                                        } else {
                                                            phi_1389_ = (_e1152 > 0f);
                                                        }
                                                        let _e1186 = phi_1389_;
                                                        phi_1390_ = _e1186;
                                                        phi_1391_ = _e1183;
                                                    }
                                                    let _e1188 = phi_1390_;
                                                    let _e1190 = phi_1391_;
                                                    if _e1190 {
                                                        phi_1395_ = true;
                                                    } else {
                                                        phi_1395_ = _e1188;
                                                    }
                                                    let _e1192 = phi_1395_;
                                                    phi_1396_ = _e1192;
                                                    phi_1397_ = false;
                                                } else {
                                                    phi_1396_ = bool();
                                                    phi_1397_ = true;
                                                }
                                                let _e1194 = phi_1396_;
                                                let _e1196 = phi_1397_;
                                                phi_1398_ = _e1194;
                                                phi_1399_ = _e1196;
                                            } else {
                                                phi_1398_ = bool();
                                                phi_1399_ = true;
                                            }
                                            let _e1198 = phi_1398_;
                                            let _e1200 = phi_1399_;
                                            if _e1200 {
                                                phi_1403_ = false;
                                            } else {
                                                phi_1403_ = _e1198;
                                            }
                                            let _e1202 = phi_1403_;
                                            if _e1202 {
                                                let _e1203 = (_e1147 >= _e70);
                                                if _e1203 {
                                                    phi_2814_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1147 < _e70) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1209 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1213 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1217 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1221 = nodes.member[(0u + _e1147)].frame[0u];
                                                    let _e1225 = nodes.member[(0u + _e1147)].frame[1u];
                                                    let _e1229 = nodes.member[(0u + _e1147)].frame[2u];
                                                    let _e1233 = nodes.member[(0u + _e1147)].frame[3u];
                                                    let _e1267 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1116), abs(_e1129));
                                                    let _e1268 = core_intrinsics_maximum_number_nsz_f32_(_e1267, abs(_e1142));
                                                    let _e1269 = (_e1268 * 0.0000000000009094947f);
                                                    if (abs(_e1116) < _e1269) {
                                                        phi_1473_ = _e1269;
                                                    } else {
                                                        phi_1473_ = abs(_e1116);
                                                    }
                                                    let _e1274 = phi_1473_;
                                                    if (_e1116 < 0f) {
                                                        phi_1480_ = (-1f / _e1274);
                                                    } else {
                                                        phi_1480_ = (1f / _e1274);
                                                    }
                                                    let _e1279 = phi_1480_;
                                                    if (abs(_e1129) < _e1269) {
                                                        phi_1487_ = _e1269;
                                                    } else {
                                                        phi_1487_ = abs(_e1129);
                                                    }
                                                    let _e1284 = phi_1487_;
                                                    if (_e1129 < 0f) {
                                                        phi_1494_ = (-1f / _e1284);
                                                    } else {
                                                        phi_1494_ = (1f / _e1284);
                                                    }
                                                    let _e1289 = phi_1494_;
                                                    if (abs(_e1142) < _e1269) {
                                                        phi_1501_ = _e1269;
                                                    } else {
                                                        phi_1501_ = abs(_e1142);
                                                    }
                                                    let _e1294 = phi_1501_;
                                                    if (_e1142 < 0f) {
                                                        phi_1508_ = (-1f / _e1294);
                                                    } else {
                                                        phi_1508_ = (1f / _e1294);
                                                    }
                                                    let _e1299 = phi_1508_;
                                                    let _e1303 = abs((bitcast<f32>(_e1209) - _e1072));
                                                    let _e1304 = abs((bitcast<f32>(_e1213) - _e1085));
                                                    let _e1305 = abs((bitcast<f32>(_e1217) - _e1098));
                                                    let _e1309 = abs(((bitcast<f32>(_e1221) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1072));
                                                    let _e1310 = abs(((bitcast<f32>(_e1225) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1085));
                                                    let _e1311 = abs(((bitcast<f32>(_e1229) + (bitcast<f32>((((_e1233 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1098));
                                                    if (_e1303 > _e1309) {
                                                        phi_1525_ = _e1303;
                                                    } else {
                                                        phi_1525_ = _e1309;
                                                    }
                                                    let _e1314 = phi_1525_;
                                                    if (_e1304 > _e1310) {
                                                        phi_1530_ = _e1304;
                                                    } else {
                                                        phi_1530_ = _e1310;
                                                    }
                                                    let _e1317 = phi_1530_;
                                                    if (_e1305 > _e1311) {
                                                        phi_1535_ = _e1305;
                                                    } else {
                                                        phi_1535_ = _e1311;
                                                    }
                                                    let _e1320 = phi_1535_;
                                                    if (_e1314 > _e1317) {
                                                        phi_1540_ = _e1314;
                                                    } else {
                                                        phi_1540_ = _e1317;
                                                    }
                                                    let _e1323 = phi_1540_;
                                                    if (_e1323 > _e1320) {
                                                        phi_1545_ = _e1323;
                                                    } else {
                                                        phi_1545_ = _e1320;
                                                    }
                                                    let _e1326 = phi_1545_;
                                                    let _e1330 = (_e1326 * 0.0000019073486f);
                                                    let _e1331 = (abs(_e1279) * _e1330);
                                                    let _e1332 = (abs(_e1289) * _e1330);
                                                    let _e1333 = (abs(_e1299) * _e1330);
                                                    let _e1337 = (_e1326 * 0.0000009536743f);
                                                    let _e1338 = (abs(_e1279) * _e1337);
                                                    let _e1339 = (abs(_e1289) * _e1337);
                                                    let _e1340 = (abs(_e1299) * _e1337);
                                                    let _e1341 = abs(_e1116);
                                                    let _e1342 = abs(_e1129);
                                                    let _e1343 = abs(_e1142);
                                                    if (_e1341 >= _e1342) {
                                                        if (_e1341 >= _e1343) {
                                                            phi_1571_ = false;
                                                        } else {
                                                            phi_1571_ = true;
                                                        }
                                                        let _e1347 = phi_1571_;
                                                        phi_1572_ = _e1347;
                                                    } else {
                                                        phi_1572_ = true;
                                                    }
                                                    let _e1349 = phi_1572_;
                                                    if _e1349 {
                                                        if (_e1342 >= _e1343) {
                                                            phi_1580_ = 1u;
                                                        } else {
                                                            phi_1580_ = 2u;
                                                        }
                                                        let _e1352 = phi_1580_;
                                                        phi_1581_ = _e1352;
                                                    } else {
                                                        phi_1581_ = 0u;
                                                    }
                                                    let _e1354 = phi_1581_;
                                                    if (_e1354 == 0u) {
                                                        phi_1593_ = vec3<f32>(_e1129, _e1142, _e1116);
                                                    } else {
                                                        if (_e1354 == 1u) {
                                                            phi_1592_ = vec3<f32>(_e1142, _e1116, _e1129);
                                                        } else {
                                                            phi_1592_ = vec3<f32>(_e1116, _e1129, _e1142);
                                                        }
                                                        let _e1360 = phi_1592_;
                                                        phi_1593_ = _e1360;
                                                    }
                                                    let _e1362 = phi_1593_;
                                                    let _e1365 = (_e1362.x / _e1362.z);
                                                    let _e1368 = (_e1362.y / _e1362.z);
                                                    if (_e1279 < 0f) {
                                                        phi_1606_ = 0u;
                                                    } else {
                                                        phi_1606_ = 1u;
                                                    }
                                                    let _e1373 = phi_1606_;
                                                    if (_e1289 < 0f) {
                                                        phi_1611_ = 0u;
                                                    } else {
                                                        phi_1611_ = 2u;
                                                    }
                                                    let _e1376 = phi_1611_;
                                                    if (_e1299 < 0f) {
                                                        phi_1616_ = 0u;
                                                    } else {
                                                        phi_1616_ = 4u;
                                                    }
                                                    let _e1379 = phi_1616_;
                                                    let _e1381 = ((_e1373 | _e1376) | _e1379);
                                                    let _e1382 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1147, 2147483648u);
                                                    local = lt_bvh_traverse_Stack(array<u32, 32>(_e1382.first[0], _e1382.first[1], _e1382.first[2], _e1382.first[3], _e1382.first[4], _e1382.first[5], _e1382.first[6], _e1382.first[7], _e1382.first[8], _e1382.first[9], _e1382.first[10], _e1382.first[11], _e1382.first[12], _e1382.first[13], _e1382.first[14], _e1382.first[15], _e1382.first[16], _e1382.first[17], _e1382.first[18], _e1382.first[19], _e1382.first[20], _e1382.first[21], _e1382.first[22], _e1382.first[23], _e1382.first[24], _e1382.first[25], _e1382.first[26], _e1382.first[27], _e1382.first[28], _e1382.first[29], _e1382.first[30], _e1382.first[31]), array<u32, 32>(_e1382.mask[0], _e1382.mask[1], _e1382.mask[2], _e1382.mask[3], _e1382.mask[4], _e1382.mask[5], _e1382.mask[6], _e1382.mask[7], _e1382.mask[8], _e1382.mask[9], _e1382.mask[10], _e1382.mask[11], _e1382.mask[12], _e1382.mask[13], _e1382.mask[14], _e1382.mask[15], _e1382.mask[16], _e1382.mask[17], _e1382.mask[18], _e1382.mask[19], _e1382.mask[20], _e1382.mask[21], _e1382.mask[22], _e1382.mask[23], _e1382.mask[24], _e1382.mask[25], _e1382.mask[26], _e1382.mask[27], _e1382.mask[28], _e1382.mask[29], _e1382.mask[30], _e1382.mask[31]), _e1382.len, _e1382.group, _e1382.group_mask);
                                                    let _e1456 = local.group_mask;
                                                    if ((_e1456 & 4278190080u) == 0u) {
                                                        let _e1460 = local.len;
                                                        if (_e1460 == 0u) {
                                                            phi_1730_ = false;
                                                        } else {
                                                            let _e1464 = local.len;
                                                            local.len = (_e1464 - 1u);
                                                            let _e1467 = local.len;
                                                            if (_e1467 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1472 = local.first[(0u + _e1467)];
                                                            local.group = _e1472;
                                                            let _e1475 = local.len;
                                                            if (_e1475 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1480 = local.mask[(0u + _e1475)];
                                                            local.group_mask = _e1480;
                                                            phi_1730_ = true;
                                                        }
                                                        let _e1483 = phi_1730_;
                                                        phi_1731_ = _e1483;
                                                    } else {
                                                        phi_1731_ = true;
                                                    }
                                                    let _e1485 = phi_1731_;
                                                    if _e1485 {
                                                        let _e1487 = local.group_mask;
                                                        let _e1493 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1487)), 32u, (_e1487 == 0u)));
                                                        let _e1497 = local.group_mask;
                                                        let _e1511 = local.group_mask;
                                                        local.group_mask = (_e1511 & ~((1u << bitcast<u32>((_e1493 & 31u)))));
                                                        let _e1514 = local.group;
                                                        phi_1762_ = (_e1514 + countOneBits(((_e1497 & ~((4294967295u << bitcast<u32>((((_e1493 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_1762_ = 4294967295u;
                                                    }
                                                    let _e1517 = phi_1762_;
                                                    phi_1764_ = _e980;
                                                    phi_1767_ = _e1517;
                                                    loop {
                                                        let _e1519 = phi_1764_;
                                                        let _e1521 = phi_1767_;
                                                        local_9 = _e1519;
                                                        let _e1522 = (_e1521 != 4294967295u);
                                                        if _e1522 {
                                                            if (_e1521 < _e70) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1529 = nodes.member[(0u + _e1521)].frame[3u];
                                                            let _e1554 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1279);
                                                            let _e1555 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1289);
                                                            let _e1556 = (bitcast<f32>((((_e1529 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1299);
                                                            let _e1559 = nodes.member[(0u + _e1521)].frame[0u];
                                                            let _e1563 = nodes.member[(0u + _e1521)].frame[1u];
                                                            let _e1567 = nodes.member[(0u + _e1521)].frame[2u];
                                                            let _e1572 = ((bitcast<f32>(_e1559) - _e1072) * _e1279);
                                                            let _e1573 = ((bitcast<f32>(_e1563) - _e1085) * _e1289);
                                                            let _e1574 = ((bitcast<f32>(_e1567) - _e1098) * _e1299);
                                                            let _e1582 = nodes.member[(0u + _e1521)].x;
                                                            if (_e1279 < 0f) {
                                                                let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1582.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1593.unnamed.root, _e1582.w), _e1593.unnamed_1);
                                                                let _e1605 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1599.unnamed, lt_bvh_traverse_Tree(_e1582.x, _e1599.unnamed_1.first_primitive));
                                                                phi_1848_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1605.unnamed, lt_bvh_traverse_Tree(_e1605.unnamed_1.root, _e1582.y));
                                                            } else {
                                                                let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1582.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1621.unnamed.root, _e1582.y), _e1621.unnamed_1);
                                                                let _e1633 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_bvh_traverse_Tree(_e1582.z, _e1627.unnamed_1.first_primitive));
                                                                phi_1848_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1633.unnamed, lt_bvh_traverse_Tree(_e1633.unnamed_1.root, _e1582.w));
                                                            }
                                                            let _e1641 = phi_1848_;
                                                            let _e1651 = nodes.member[(0u + _e1521)].y;
                                                            if (_e1289 < 0f) {
                                                                let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1662.unnamed.root, _e1651.w), _e1662.unnamed_1);
                                                                let _e1674 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1668.unnamed, lt_bvh_traverse_Tree(_e1651.x, _e1668.unnamed_1.first_primitive));
                                                                phi_1875_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1674.unnamed, lt_bvh_traverse_Tree(_e1674.unnamed_1.root, _e1651.y));
                                                            } else {
                                                                let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1651.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1690.unnamed.root, _e1651.y), _e1690.unnamed_1);
                                                                let _e1702 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_bvh_traverse_Tree(_e1651.z, _e1696.unnamed_1.first_primitive));
                                                                phi_1875_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1702.unnamed, lt_bvh_traverse_Tree(_e1702.unnamed_1.root, _e1651.w));
                                                            }
                                                            let _e1710 = phi_1875_;
                                                            let _e1720 = nodes.member[(0u + _e1521)].z;
                                                            if (_e1299 < 0f) {
                                                                let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1720.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1731.unnamed.root, _e1720.w), _e1731.unnamed_1);
                                                                let _e1743 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1737.unnamed, lt_bvh_traverse_Tree(_e1720.x, _e1737.unnamed_1.first_primitive));
                                                                phi_1902_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1743.unnamed, lt_bvh_traverse_Tree(_e1743.unnamed_1.root, _e1720.y));
                                                            } else {
                                                                let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1720.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1759.unnamed.root, _e1720.y), _e1759.unnamed_1);
                                                                let _e1771 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1765.unnamed, lt_bvh_traverse_Tree(_e1720.z, _e1765.unnamed_1.first_primitive));
                                                                phi_1902_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1771.unnamed, lt_bvh_traverse_Tree(_e1771.unnamed_1.root, _e1720.w));
                                                            }
                                                            let _e1779 = phi_1902_;
                                                            phi_1908_ = 0u;
                                                            phi_1911_ = 0u;
                                                            loop {
                                                                let _e1789 = phi_1908_;
                                                                let _e1791 = phi_1911_;
                                                                local_5 = _e1791;
                                                                local_6 = _e1791;
                                                                local_7 = _e1791;
                                                                let _e1792 = (_e1789 < 8u);
                                                                if _e1792 {
                                                                    let _e1794 = (_e1789 >> bitcast<u32>(2i));
                                                                    let _e1795 = (_e1789 & 3u);
                                                                    if (_e1794 == 0u) {
                                                                        phi_1925_ = _e1641.unnamed.root;
                                                                    } else {
                                                                        phi_1925_ = _e1641.unnamed.first_primitive;
                                                                    }
                                                                    let _e1798 = phi_1925_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1935_ = _e1710.unnamed.root;
                                                                    } else {
                                                                        phi_1935_ = _e1710.unnamed.first_primitive;
                                                                    }
                                                                    let _e1807 = phi_1935_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1945_ = _e1779.unnamed.root;
                                                                    } else {
                                                                        phi_1945_ = _e1779.unnamed.first_primitive;
                                                                    }
                                                                    let _e1816 = phi_1945_;
                                                                    let _e1829 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1798 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 - _e1331)), ((f32(((_e1807 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 - _e1332)));
                                                                    let _e1830 = core_intrinsics_maximum_number_nsz_f32_(_e1829, ((f32(((_e1816 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 - _e1333)));
                                                                    if (_e1794 == 0u) {
                                                                        phi_1963_ = _e1641.unnamed_1.root;
                                                                    } else {
                                                                        phi_1963_ = _e1641.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1833 = phi_1963_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1973_ = _e1710.unnamed_1.root;
                                                                    } else {
                                                                        phi_1973_ = _e1710.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1842 = phi_1973_;
                                                                    if (_e1794 == 0u) {
                                                                        phi_1983_ = _e1779.unnamed_1.root;
                                                                    } else {
                                                                        phi_1983_ = _e1779.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1851 = phi_1983_;
                                                                    let _e1864 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1833 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1554) + (_e1572 + _e1331)), ((f32(((_e1842 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1555) + (_e1573 + _e1332)));
                                                                    let _e1865 = core_intrinsics_minimum_number_nsz_f32_(_e1864, ((f32(((_e1851 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u)) * _e1556) + (_e1574 + _e1333)));
                                                                    if (_e1830 <= _e1865) {
                                                                        if (_e1830 <= _e1519.t) {
                                                                            if (_e1865 >= _e171.tmin) {
                                                                                if (_e1794 == 0u) {
                                                                                    let _e1872 = nodes.member[(0u + _e1521)].links[2u];
                                                                                    phi_2019_ = _e1872;
                                                                                } else {
                                                                                    let _e1875 = nodes.member[(0u + _e1521)].links[3u];
                                                                                    phi_2019_ = _e1875;
                                                                                }
                                                                                let _e1877 = phi_2019_;
                                                                                let _e1882 = ((_e1877 >> bitcast<u32>(((_e1795 * 8u) & 31u))) & 255u);
                                                                                let _e1883 = (_e1882 & 31u);
                                                                                if (_e1883 >= 24u) {
                                                                                    phi_2032_ = (24u + ((_e1883 - 24u) ^ _e1381));
                                                                                } else {
                                                                                    phi_2032_ = _e1883;
                                                                                }
                                                                                let _e1889 = phi_2032_;
                                                                                phi_2037_ = (_e1791 | ((_e1882 >> bitcast<u32>(5i)) << bitcast<u32>((_e1889 & 31u))));
                                                                            } else {
                                                                                phi_2037_ = _e1791;
                                                                            }
                                                                            let _e1897 = phi_2037_;
                                                                            phi_2038_ = _e1897;
                                                                        } else {
                                                                            phi_2038_ = _e1791;
                                                                        }
                                                                        let _e1899 = phi_2038_;
                                                                        phi_2039_ = _e1899;
                                                                    } else {
                                                                        phi_2039_ = _e1791;
                                                                    }
                                                                    let _e1901 = phi_2039_;
                                                                    phi_1909_ = (_e1789 + 1u);
                                                                    phi_1912_ = _e1901;
                                                                } else {
                                                                    phi_1909_ = u32();
                                                                    phi_1912_ = u32();
                                                                }
                                                                let _e1904 = phi_1909_;
                                                                let _e1906 = phi_1912_;
                                                                continue;
                                                                continuing {
                                                                    phi_1908_ = _e1904;
                                                                    phi_1911_ = _e1906;
                                                                    break if !(_e1792);
                                                                }
                                                            }
                                                            let _e1910 = nodes.member[(0u + _e1521)].links[0u];
                                                            let _e1914 = nodes.member[(0u + _e1521)].frame[3u];
                                                            let _e1918 = local_5;
                                                            if ((_e1918 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1922 = local.group_mask;
                                                                if ((_e1922 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1926 = local.len;
                                                                    if (_e1926 < 32u) {
                                                                        let _e1929 = local.group;
                                                                        let _e1931 = local.len;
                                                                        if (_e1931 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.first[(0u + _e1931)] = _e1929;
                                                                        let _e1937 = local.group_mask;
                                                                        let _e1939 = local.len;
                                                                        if (_e1939 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local.mask[(0u + _e1939)] = _e1937;
                                                                        let _e1946 = local.len;
                                                                        local.len = (_e1946 + 1u);
                                                                    }
                                                                }
                                                                local.group = (_e1147 + _e1910);
                                                                let _e1950 = local_6;
                                                                local.group_mask = ((_e1950 & 4278190080u) | (_e1914 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1955 = local_7;
                                                            phi_2097_ = _e1519;
                                                            phi_2100_ = (_e1955 & 16777215u);
                                                            loop {
                                                                let _e1958 = phi_2097_;
                                                                let _e1960 = phi_2100_;
                                                                local_8 = _e1958;
                                                                if (_e1960 == 0u) {
                                                                    phi_2098_ = lt_bvh_Hit();
                                                                    phi_2101_ = u32();
                                                                    phi_2742_ = false;
                                                                } else {
                                                                    let _e1964 = nodes.member[(0u + _e1521)].links[1u];
                                                                    let _e1969 = ((_e1149 + _e1964) + select(firstTrailingBit(_e1960), 32u, (_e1960 == 0u)));
                                                                    if (_e1969 < _e73) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1976 = triangles.member[(0u + _e1969)].v0_;
                                                                    let _e1978 = (_e1976.x - _e1072);
                                                                    let _e1980 = (_e1976.y - _e1085);
                                                                    let _e1982 = (_e1976.z - _e1098);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2145_ = vec3<f32>(_e1980, _e1982, _e1978);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2144_ = vec3<f32>(_e1982, _e1978, _e1980);
                                                                        } else {
                                                                            phi_2144_ = (_e1976 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e1990 = phi_2144_;
                                                                        phi_2145_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2145_;
                                                                    let _e1996 = (_e1992.x - (_e1365 * _e1992.z));
                                                                    let _e2000 = (_e1992.y - (_e1368 * _e1992.z));
                                                                    let _e2002 = triangles.member[(0u + _e1969)].v1_;
                                                                    let _e2004 = (_e2002.x - _e1072);
                                                                    let _e2006 = (_e2002.y - _e1085);
                                                                    let _e2008 = (_e2002.z - _e1098);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2175_ = vec3<f32>(_e2006, _e2008, _e2004);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2174_ = vec3<f32>(_e2008, _e2004, _e2006);
                                                                        } else {
                                                                            phi_2174_ = (_e2002 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2016 = phi_2174_;
                                                                        phi_2175_ = _e2016;
                                                                    }
                                                                    let _e2018 = phi_2175_;
                                                                    let _e2022 = (_e2018.x - (_e1365 * _e2018.z));
                                                                    let _e2026 = (_e2018.y - (_e1368 * _e2018.z));
                                                                    let _e2028 = triangles.member[(0u + _e1969)].v2_;
                                                                    let _e2030 = (_e2028.x - _e1072);
                                                                    let _e2032 = (_e2028.y - _e1085);
                                                                    let _e2034 = (_e2028.z - _e1098);
                                                                    if (_e1354 == 0u) {
                                                                        phi_2205_ = vec3<f32>(_e2032, _e2034, _e2030);
                                                                    } else {
                                                                        if (_e1354 == 1u) {
                                                                            phi_2204_ = vec3<f32>(_e2034, _e2030, _e2032);
                                                                        } else {
                                                                            phi_2204_ = (_e2028 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                        }
                                                                        let _e2042 = phi_2204_;
                                                                        phi_2205_ = _e2042;
                                                                    }
                                                                    let _e2044 = phi_2205_;
                                                                    let _e2048 = (_e2044.x - (_e1365 * _e2044.z));
                                                                    let _e2052 = (_e2044.y - (_e1368 * _e2044.z));
                                                                    if (_e2022 < _e2048) {
                                                                        phi_2224_ = true;
                                                                    } else {
                                                                        if (_e2022 == _e2048) {
                                                                            phi_2223_ = (_e2026 < _e2052);
                                                                        } else {
                                                                            phi_2223_ = false;
                                                                        }
                                                                        let _e2057 = phi_2223_;
                                                                        phi_2224_ = _e2057;
                                                                    }
                                                                    let _e2059 = phi_2224_;
                                                                    if _e2059 {
                                                                        phi_2228_ = _e2052;
                                                                        phi_2229_ = _e2048;
                                                                        phi_2230_ = _e2026;
                                                                        phi_2231_ = _e2022;
                                                                    } else {
                                                                        phi_2228_ = _e2026;
                                                                        phi_2229_ = _e2022;
                                                                        phi_2230_ = _e2052;
                                                                        phi_2231_ = _e2048;
                                                                    }
                                                                    let _e2061 = phi_2228_;
                                                                    let _e2063 = phi_2229_;
                                                                    let _e2065 = phi_2230_;
                                                                    let _e2067 = phi_2231_;
                                                                    let _e2070 = ((_e2067 * _e2061) - (_e2065 * _e2063));
                                                                    if _e2059 {
                                                                        phi_2239_ = -(_e2070);
                                                                    } else {
                                                                        phi_2239_ = _e2070;
                                                                    }
                                                                    let _e2073 = phi_2239_;
                                                                    if (_e2048 < _e1996) {
                                                                        phi_2250_ = true;
                                                                    } else {
                                                                        if (_e2048 == _e1996) {
                                                                            phi_2249_ = (_e2052 < _e2000);
                                                                        } else {
                                                                            phi_2249_ = false;
                                                                        }
                                                                        let _e2078 = phi_2249_;
                                                                        phi_2250_ = _e2078;
                                                                    }
                                                                    let _e2080 = phi_2250_;
                                                                    if _e2080 {
                                                                        phi_2254_ = _e2000;
                                                                        phi_2255_ = _e1996;
                                                                        phi_2256_ = _e2052;
                                                                        phi_2257_ = _e2048;
                                                                    } else {
                                                                        phi_2254_ = _e2052;
                                                                        phi_2255_ = _e2048;
                                                                        phi_2256_ = _e2000;
                                                                        phi_2257_ = _e1996;
                                                                    }
                                                                    let _e2082 = phi_2254_;
                                                                    let _e2084 = phi_2255_;
                                                                    let _e2086 = phi_2256_;
                                                                    let _e2088 = phi_2257_;
                                                                    let _e2091 = ((_e2088 * _e2082) - (_e2086 * _e2084));
                                                                    if _e2080 {
                                                                        phi_2265_ = -(_e2091);
                                                                    } else {
                                                                        phi_2265_ = _e2091;
                                                                    }
                                                                    let _e2094 = phi_2265_;
                                                                    if (_e1996 < _e2022) {
                                                                        phi_2276_ = true;
                                                                    } else {
                                                                        if (_e1996 == _e2022) {
                                                                            phi_2275_ = (_e2000 < _e2026);
                                                                        } else {
                                                                            phi_2275_ = false;
                                                                        }
                                                                        let _e2099 = phi_2275_;
                                                                        phi_2276_ = _e2099;
                                                                    }
                                                                    let _e2101 = phi_2276_;
                                                                    if _e2101 {
                                                                        phi_2280_ = _e2026;
                                                                        phi_2281_ = _e2022;
                                                                        phi_2282_ = _e2000;
                                                                        phi_2283_ = _e1996;
                                                                    } else {
                                                                        phi_2280_ = _e2000;
                                                                        phi_2281_ = _e1996;
                                                                        phi_2282_ = _e2026;
                                                                        phi_2283_ = _e2022;
                                                                    }
                                                                    let _e2103 = phi_2280_;
                                                                    let _e2105 = phi_2281_;
                                                                    let _e2107 = phi_2282_;
                                                                    let _e2109 = phi_2283_;
                                                                    let _e2112 = ((_e2109 * _e2103) - (_e2107 * _e2105));
                                                                    if _e2101 {
                                                                        phi_2291_ = -(_e2112);
                                                                    } else {
                                                                        phi_2291_ = _e2112;
                                                                    }
                                                                    let _e2115 = phi_2291_;
                                                                    if (_e2073 >= 0f) {
                                                                        if (_e2094 >= 0f) {
                                                                            if (_e2115 >= 0f) {
                                                                                phi_2306_ = ((_e2073 + _e2094) + _e2115);
                                                                                phi_2307_ = false;
                                                                            } else {
                                                                                phi_2306_ = f32();
                                                                                phi_2307_ = true;
                                                                            }
                                                                            let _e2122 = phi_2306_;
                                                                            let _e2124 = phi_2307_;
                                                                            phi_2308_ = _e2122;
                                                                            phi_2309_ = _e2124;
                                                                        } else {
                                                                            phi_2308_ = f32();
                                                                            phi_2309_ = true;
                                                                        }
                                                                        let _e2126 = phi_2308_;
                                                                        let _e2128 = phi_2309_;
                                                                        phi_2310_ = _e2126;
                                                                        phi_2311_ = _e2128;
                                                                    } else {
                                                                        phi_2310_ = f32();
                                                                        phi_2311_ = true;
                                                                    }
                                                                    let _e2130 = phi_2310_;
                                                                    let _e2132 = phi_2311_;
                                                                    if _e2132 {
                                                                        if (_e2073 <= 0f) {
                                                                            if (_e2094 <= 0f) {
                                                                                let _e2135 = (_e2115 <= 0f);
                                                                                if _e2135 {
                                                                                }
                                                                                phi_2329_ = ((_e2073 + _e2094) + _e2115);
                                                                                phi_2330_ = false;
                                                                                phi_2331_ = _e2135;
                                                                            } else {
                                                                                phi_2329_ = f32();
                                                                                phi_2330_ = true;
                                                                                phi_2331_ = false;
                                                                            }
                                                                            let _e2139 = phi_2329_;
                                                                            let _e2141 = phi_2330_;
                                                                            let _e2143 = phi_2331_;
                                                                            phi_2332_ = _e2139;
                                                                            phi_2333_ = _e2141;
                                                                            phi_2334_ = _e2143;
                                                                        } else {
                                                                            phi_2332_ = f32();
                                                                            phi_2333_ = true;
                                                                            phi_2334_ = false;
                                                                        }
                                                                        let _e2145 = phi_2332_;
                                                                        let _e2147 = phi_2333_;
                                                                        let _e2149 = phi_2334_;
                                                                        if _e2147 {
                                                                            phi_2338_ = false;
                                                                        } else {
                                                                            phi_2338_ = _e2149;
                                                                        }
                                                                        let _e2151 = phi_2338_;
                                                                        phi_2339_ = _e2145;
                                                                        phi_2340_ = _e2151;
                                                                    } else {
                                                                        phi_2339_ = _e2130;
                                                                        phi_2340_ = true;
                                                                    }
                                                                    let _e2153 = phi_2339_;
                                                                    let _e2155 = phi_2340_;
                                                                    if _e2155 {
                                                                        let _e2156 = (_e2153 == 0f);
                                                                        if _e2156 {
                                                                            phi_2656_ = lt_bvh_triangle_Intersection();
                                                                            phi_2657_ = false;
                                                                        } else {
                                                                            let _e2158 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2160 = (_e2158.x - _e1072);
                                                                            let _e2162 = (_e2158.y - _e1085);
                                                                            let _e2164 = (_e2158.z - _e1098);
                                                                            if (_e1354 == 0u) {
                                                                                phi_2369_ = vec3<f32>(_e2162, _e2164, _e2160);
                                                                            } else {
                                                                                if (_e1354 == 1u) {
                                                                                    phi_2368_ = vec3<f32>(_e2164, _e2160, _e2162);
                                                                                } else {
                                                                                    phi_2368_ = (_e2158 - vec3<f32>(_e1072, _e1085, _e1098));
                                                                                }
                                                                                let _e2172 = phi_2368_;
                                                                                phi_2369_ = _e2172;
                                                                            }
                                                                            let _e2174 = phi_2369_;
                                                                            let _e2176 = triangles.member[(0u + _e1969)].v1_;
                                                                            let _e2178 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2181 = (_e2176.x - _e2178.x);
                                                                            let _e2184 = (_e2176.y - _e2178.y);
                                                                            let _e2187 = (_e2176.z - _e2178.z);
                                                                            if (_e1354 == 0u) {
                                                                                phi_2395_ = vec3<f32>(_e2184, _e2187, _e2181);
                                                                            } else {
                                                                                if (_e1354 == 1u) {
                                                                                    phi_2394_ = vec3<f32>(_e2187, _e2181, _e2184);
                                                                                } else {
                                                                                    phi_2394_ = (_e2176 - _e2178);
                                                                                }
                                                                                let _e2194 = phi_2394_;
                                                                                phi_2395_ = _e2194;
                                                                            }
                                                                            let _e2196 = phi_2395_;
                                                                            let _e2198 = triangles.member[(0u + _e1969)].v2_;
                                                                            let _e2200 = triangles.member[(0u + _e1969)].v0_;
                                                                            let _e2203 = (_e2198.x - _e2200.x);
                                                                            let _e2206 = (_e2198.y - _e2200.y);
                                                                            let _e2209 = (_e2198.z - _e2200.z);
                                                                            if (_e1354 == 0u) {
                                                                                phi_2421_ = vec3<f32>(_e2206, _e2209, _e2203);
                                                                            } else {
                                                                                if (_e1354 == 1u) {
                                                                                    phi_2420_ = vec3<f32>(_e2209, _e2203, _e2206);
                                                                                } else {
                                                                                    phi_2420_ = (_e2198 - _e2200);
                                                                                }
                                                                                let _e2216 = phi_2420_;
                                                                                phi_2421_ = _e2216;
                                                                            }
                                                                            let _e2218 = phi_2421_;
                                                                            let _e2225 = ((_e2196.y * _e2218.z) - (_e2196.z * _e2218.y));
                                                                            let _e2232 = ((_e2196.z * _e2218.x) - (_e2196.x * _e2218.z));
                                                                            let _e2239 = ((_e2196.x * _e2218.y) - (_e2196.y * _e2218.x));
                                                                            let _e2253 = (((1f / _e1362.z) * (((_e2225 * _e2174.x) + (_e2232 * _e2174.y)) + (_e2239 * _e2174.z))) / (((_e2225 * _e1365) + (_e2232 * _e1368)) + _e2239));
                                                                            if (_e2253 > _e171.tmin) {
                                                                                if (_e2253 < _e171.tmax) {
                                                                                    let _e2257 = triangles.member[(0u + _e1969)].v0_;
                                                                                    let _e2259 = triangles.member[(0u + _e1969)].v1_;
                                                                                    if (_e2257.x < _e2259.x) {
                                                                                        phi_2477_ = _e2257.x;
                                                                                    } else {
                                                                                        phi_2477_ = _e2259.x;
                                                                                    }
                                                                                    let _e2266 = phi_2477_;
                                                                                    if (_e2257.y < _e2259.y) {
                                                                                        phi_2486_ = _e2257.y;
                                                                                    } else {
                                                                                        phi_2486_ = _e2259.y;
                                                                                    }
                                                                                    let _e2273 = phi_2486_;
                                                                                    if (_e2257.z < _e2259.z) {
                                                                                        phi_2495_ = _e2257.z;
                                                                                    } else {
                                                                                        phi_2495_ = _e2259.z;
                                                                                    }
                                                                                    let _e2280 = phi_2495_;
                                                                                    let _e2282 = triangles.member[(0u + _e1969)].v2_;
                                                                                    if (_e2266 < _e2282.x) {
                                                                                        phi_2504_ = _e2266;
                                                                                    } else {
                                                                                        phi_2504_ = _e2282.x;
                                                                                    }
                                                                                    let _e2287 = phi_2504_;
                                                                                    if (_e2273 < _e2282.y) {
                                                                                        phi_2511_ = _e2273;
                                                                                    } else {
                                                                                        phi_2511_ = _e2282.y;
                                                                                    }
                                                                                    let _e2292 = phi_2511_;
                                                                                    if (_e2280 < _e2282.z) {
                                                                                        phi_2518_ = _e2280;
                                                                                    } else {
                                                                                        phi_2518_ = _e2282.z;
                                                                                    }
                                                                                    let _e2297 = phi_2518_;
                                                                                    let _e2299 = triangles.member[(0u + _e1969)].v0_;
                                                                                    let _e2301 = triangles.member[(0u + _e1969)].v1_;
                                                                                    if (_e2299.x > _e2301.x) {
                                                                                        phi_2531_ = _e2299.x;
                                                                                    } else {
                                                                                        phi_2531_ = _e2301.x;
                                                                                    }
                                                                                    let _e2308 = phi_2531_;
                                                                                    if (_e2299.y > _e2301.y) {
                                                                                        phi_2540_ = _e2299.y;
                                                                                    } else {
                                                                                        phi_2540_ = _e2301.y;
                                                                                    }
                                                                                    let _e2315 = phi_2540_;
                                                                                    if (_e2299.z > _e2301.z) {
                                                                                        phi_2549_ = _e2299.z;
                                                                                    } else {
                                                                                        phi_2549_ = _e2301.z;
                                                                                    }
                                                                                    let _e2322 = phi_2549_;
                                                                                    let _e2324 = triangles.member[(0u + _e1969)].v2_;
                                                                                    if (_e2308 > _e2324.x) {
                                                                                        phi_2558_ = _e2308;
                                                                                    } else {
                                                                                        phi_2558_ = _e2324.x;
                                                                                    }
                                                                                    let _e2329 = phi_2558_;
                                                                                    if (_e2315 > _e2324.y) {
                                                                                        phi_2565_ = _e2315;
                                                                                    } else {
                                                                                        phi_2565_ = _e2324.y;
                                                                                    }
                                                                                    let _e2334 = phi_2565_;
                                                                                    if (_e2322 > _e2324.z) {
                                                                                        phi_2572_ = _e2322;
                                                                                    } else {
                                                                                        phi_2572_ = _e2324.z;
                                                                                    }
                                                                                    let _e2339 = phi_2572_;
                                                                                    let _e2343 = ((_e2287 - _e1072) * _e1279);
                                                                                    let _e2344 = ((_e2292 - _e1085) * _e1289);
                                                                                    let _e2345 = ((_e2297 - _e1098) * _e1299);
                                                                                    let _e2349 = ((_e2329 - _e1072) * _e1279);
                                                                                    let _e2350 = ((_e2334 - _e1085) * _e1289);
                                                                                    let _e2351 = ((_e2339 - _e1098) * _e1299);
                                                                                    if (_e2343 < _e2349) {
                                                                                        phi_2589_ = _e2343;
                                                                                    } else {
                                                                                        phi_2589_ = _e2349;
                                                                                    }
                                                                                    let _e2354 = phi_2589_;
                                                                                    if (_e2344 < _e2350) {
                                                                                        phi_2594_ = _e2344;
                                                                                    } else {
                                                                                        phi_2594_ = _e2350;
                                                                                    }
                                                                                    let _e2357 = phi_2594_;
                                                                                    if (_e2345 < _e2351) {
                                                                                        phi_2599_ = _e2345;
                                                                                    } else {
                                                                                        phi_2599_ = _e2351;
                                                                                    }
                                                                                    let _e2360 = phi_2599_;
                                                                                    if (_e2343 > _e2349) {
                                                                                        phi_2607_ = _e2343;
                                                                                    } else {
                                                                                        phi_2607_ = _e2349;
                                                                                    }
                                                                                    let _e2366 = phi_2607_;
                                                                                    if (_e2344 > _e2350) {
                                                                                        phi_2612_ = _e2344;
                                                                                    } else {
                                                                                        phi_2612_ = _e2350;
                                                                                    }
                                                                                    let _e2369 = phi_2612_;
                                                                                    if (_e2345 > _e2351) {
                                                                                        phi_2617_ = _e2345;
                                                                                    } else {
                                                                                        phi_2617_ = _e2351;
                                                                                    }
                                                                                    let _e2372 = phi_2617_;
                                                                                    let _e2376 = core_intrinsics_maximum_number_nsz_f32_((_e2354 - _e1338), (_e2357 - _e1339));
                                                                                    let _e2377 = core_intrinsics_maximum_number_nsz_f32_(_e2376, (_e2360 - _e1340));
                                                                                    let _e2378 = core_intrinsics_minimum_number_nsz_f32_((_e2366 + _e1338), (_e2369 + _e1339));
                                                                                    let _e2379 = core_intrinsics_minimum_number_nsz_f32_(_e2378, (_e2372 + _e1340));
                                                                                    if (_e2377 > _e1047) {
                                                                                        phi_2629_ = _e2377;
                                                                                    } else {
                                                                                        phi_2629_ = _e1047;
                                                                                    }
                                                                                    let _e2382 = phi_2629_;
                                                                                    if (_e2379 < _e1049) {
                                                                                        phi_2634_ = _e2379;
                                                                                    } else {
                                                                                        phi_2634_ = _e1049;
                                                                                    }
                                                                                    let _e2385 = phi_2634_;
                                                                                    if (_e2253 < _e2382) {
                                                                                        phi_2639_ = _e2382;
                                                                                    } else {
                                                                                        phi_2639_ = _e2253;
                                                                                    }
                                                                                    let _e2388 = phi_2639_;
                                                                                    if (_e2388 > _e2385) {
                                                                                        phi_2644_ = _e2385;
                                                                                    } else {
                                                                                        phi_2644_ = _e2388;
                                                                                    }
                                                                                    let _e2391 = phi_2644_;
                                                                                    phi_2649_ = lt_bvh_triangle_Intersection(_e2391, (_e2094 / _e2153), (_e2115 / _e2153), (_e2382 <= _e2385));
                                                                                    phi_2650_ = false;
                                                                                } else {
                                                                                    phi_2649_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2650_ = true;
                                                                                }
                                                                                let _e2397 = phi_2649_;
                                                                                let _e2399 = phi_2650_;
                                                                                phi_2651_ = _e2397;
                                                                                phi_2652_ = _e2399;
                                                                            } else {
                                                                                phi_2651_ = lt_bvh_triangle_Intersection();
                                                                                phi_2652_ = true;
                                                                            }
                                                                            let _e2401 = phi_2651_;
                                                                            let _e2403 = phi_2652_;
                                                                            if _e2403 {
                                                                            }
                                                                            phi_2656_ = _e2401;
                                                                            phi_2657_ = _e2403;
                                                                        }
                                                                        let _e2405 = phi_2656_;
                                                                        let _e2407 = phi_2657_;
                                                                        phi_2658_ = _e2405;
                                                                        phi_2659_ = _e2156;
                                                                        phi_2660_ = _e2407;
                                                                    } else {
                                                                        phi_2658_ = lt_bvh_triangle_Intersection();
                                                                        phi_2659_ = true;
                                                                        phi_2660_ = false;
                                                                    }
                                                                    let _e2409 = phi_2658_;
                                                                    let _e2411 = phi_2659_;
                                                                    let _e2413 = phi_2660_;
                                                                    if _e2411 {
                                                                        phi_2664_ = true;
                                                                    } else {
                                                                        phi_2664_ = _e2413;
                                                                    }
                                                                    let _e2415 = phi_2664_;
                                                                    if _e2415 {
                                                                        phi_2668_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2668_ = _e2409;
                                                                    }
                                                                    let _e2417 = phi_2668_;
                                                                    if _e2417.is_hit {
                                                                        if (_e2417.t > _e171.tmin) {
                                                                            if (_e2417.t < _e1958.t) {
                                                                                phi_2716_ = true;
                                                                            } else {
                                                                                if (_e2417.t == _e1958.t) {
                                                                                    if (_e1958.triangle != 4294967295u) {
                                                                                        if (_e1969 < _e1958.triangle) {
                                                                                            phi_2707_ = true;
                                                                                        } else {
                                                                                            if (_e1969 == _e1958.triangle) {
                                                                                                phi_2706_ = (_e988 < _e1958.instance);
                                                                                            } else {
                                                                                                phi_2706_ = false;
                                                                                            }
                                                                                            let _e2435 = phi_2706_;
                                                                                            phi_2707_ = _e2435;
                                                                                        }
                                                                                        let _e2437 = phi_2707_;
                                                                                        phi_2708_ = _e2437;
                                                                                        phi_2709_ = false;
                                                                                    } else {
                                                                                        phi_2708_ = bool();
                                                                                        phi_2709_ = true;
                                                                                    }
                                                                                    let _e2439 = phi_2708_;
                                                                                    let _e2441 = phi_2709_;
                                                                                    phi_2710_ = _e2439;
                                                                                    phi_2711_ = _e2441;
                                                                                } else {
                                                                                    phi_2710_ = bool();
                                                                                    phi_2711_ = true;
                                                                                }
                                                                                let _e2443 = phi_2710_;
                                                                                let _e2445 = phi_2711_;
                                                                                if _e2445 {
                                                                                    phi_2715_ = false;
                                                                                } else {
                                                                                    phi_2715_ = _e2443;
                                                                                }
                                                                                let _e2447 = phi_2715_;
                                                                                phi_2716_ = _e2447;
                                                                            }
                                                                            let _e2449 = phi_2716_;
                                                                            if _e2449 {
                                                                                let _e2451 = triangles.member[(0u + _e1969)].i0_;
                                                                                if ((_e2451 & 2147483648u) == 0u) {
                                                                                    phi_2730_ = true;
                                                                                } else {
                                                                                    if true {
                                                                                    }
                                                                                    phi_2730_ = true;
                                                                                }
                                                                                let _e2455 = phi_2730_;
                                                                                if _e2455 {
                                                                                    phi_2738_ = lt_bvh_Hit(_e2417.t, _e2417.u, _e2417.v, _e1969, _e988);
                                                                                } else {
                                                                                    phi_2738_ = _e1958;
                                                                                }
                                                                                let _e2461 = phi_2738_;
                                                                                phi_2739_ = _e2461;
                                                                            } else {
                                                                                phi_2739_ = _e1958;
                                                                            }
                                                                            let _e2463 = phi_2739_;
                                                                            phi_2740_ = _e2463;
                                                                        } else {
                                                                            phi_2740_ = _e1958;
                                                                        }
                                                                        let _e2465 = phi_2740_;
                                                                        phi_2741_ = _e2465;
                                                                    } else {
                                                                        phi_2741_ = _e1958;
                                                                    }
                                                                    let _e2467 = phi_2741_;
                                                                    phi_2098_ = _e2467;
                                                                    phi_2101_ = (_e1960 & (_e1960 - 1u));
                                                                    phi_2742_ = true;
                                                                }
                                                                let _e2469 = phi_2098_;
                                                                let _e2471 = phi_2101_;
                                                                let _e2473 = phi_2742_;
                                                                continue;
                                                                continuing {
                                                                    phi_2097_ = _e2469;
                                                                    phi_2100_ = _e2471;
                                                                    break if !(_e2473);
                                                                }
                                                            }
                                                            let _e2476 = local.group_mask;
                                                            if ((_e2476 & 4278190080u) == 0u) {
                                                                let _e2480 = local.len;
                                                                if (_e2480 == 0u) {
                                                                    phi_2781_ = false;
                                                                } else {
                                                                    let _e2484 = local.len;
                                                                    local.len = (_e2484 - 1u);
                                                                    let _e2487 = local.len;
                                                                    if (_e2487 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2492 = local.first[(0u + _e2487)];
                                                                    local.group = _e2492;
                                                                    let _e2495 = local.len;
                                                                    if (_e2495 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2500 = local.mask[(0u + _e2495)];
                                                                    local.group_mask = _e2500;
                                                                    phi_2781_ = true;
                                                                }
                                                                let _e2503 = phi_2781_;
                                                                phi_2782_ = _e2503;
                                                            } else {
                                                                phi_2782_ = true;
                                                            }
                                                            let _e2505 = phi_2782_;
                                                            if _e2505 {
                                                                let _e2507 = local.group_mask;
                                                                let _e2513 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2507)), 32u, (_e2507 == 0u)));
                                                                let _e2517 = local.group_mask;
                                                                let _e2531 = local.group_mask;
                                                                local.group_mask = (_e2531 & ~((1u << bitcast<u32>((_e2513 & 31u)))));
                                                                let _e2534 = local.group;
                                                                phi_2813_ = (_e2534 + countOneBits(((_e2517 & ~((4294967295u << bitcast<u32>((((_e2513 - 24u) ^ _e1381) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_2813_ = 4294967295u;
                                                            }
                                                            let _e2537 = phi_2813_;
                                                            let _e3712 = local_8;
                                                            phi_1765_ = _e3712;
                                                            phi_1768_ = _e2537;
                                                        } else {
                                                            phi_1765_ = lt_bvh_Hit();
                                                            phi_1768_ = u32();
                                                        }
                                                        let _e2539 = phi_1765_;
                                                        let _e2541 = phi_1768_;
                                                        continue;
                                                        continuing {
                                                            phi_1764_ = _e2539;
                                                            phi_1767_ = _e2541;
                                                            break if !(_e1522);
                                                        }
                                                    }
                                                    let _e3716 = local_9;
                                                    phi_2814_ = _e3716;
                                                }
                                                let _e2544 = phi_2814_;
                                                phi_2815_ = _e2544;
                                                phi_2816_ = _e1203;
                                            } else {
                                                phi_2815_ = lt_bvh_Hit();
                                                phi_2816_ = true;
                                            }
                                            let _e2546 = phi_2815_;
                                            let _e2548 = phi_2816_;
                                            if _e2548 {
                                                phi_2820_ = _e980;
                                            } else {
                                                phi_2820_ = _e2546;
                                            }
                                            let _e2550 = phi_2820_;
                                            phi_2821_ = _e2550;
                                        } else {
                                            phi_2821_ = _e980;
                                        }
                                        let _e2552 = phi_2821_;
                                        phi_2822_ = _e2552;
                                    } else {
                                        phi_2822_ = _e980;
                                    }
                                    let _e2554 = phi_2822_;
                                    phi_2823_ = _e2554;
                                } else {
                                    phi_2823_ = _e980;
                                }
                                let _e2556 = phi_2823_;
                                phi_1132_ = (_e978 & (_e978 - 1u));
                                phi_1135_ = _e2556;
                                phi_2824_ = true;
                            }
                            let _e2558 = phi_1132_;
                            let _e2560 = phi_1135_;
                            let _e2562 = phi_2824_;
                            continue;
                            continuing {
                                phi_1131_ = _e2558;
                                phi_1134_ = _e2560;
                                break if !(_e2562);
                            }
                        }
                        let _e2565 = local_1.group_mask;
                        if ((_e2565 & 4278190080u) == 0u) {
                            let _e2569 = local_1.len;
                            if (_e2569 == 0u) {
                                phi_2863_ = false;
                            } else {
                                let _e2573 = local_1.len;
                                local_1.len = (_e2573 - 1u);
                                let _e2576 = local_1.len;
                                if (_e2576 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2581 = local_1.first[(0u + _e2576)];
                                local_1.group = _e2581;
                                let _e2584 = local_1.len;
                                if (_e2584 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2589 = local_1.mask[(0u + _e2584)];
                                local_1.group_mask = _e2589;
                                phi_2863_ = true;
                            }
                            let _e2592 = phi_2863_;
                            phi_2864_ = _e2592;
                        } else {
                            phi_2864_ = true;
                        }
                        let _e2594 = phi_2864_;
                        if _e2594 {
                            let _e2596 = local_1.group_mask;
                            let _e2602 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2596)), 32u, (_e2596 == 0u)));
                            let _e2606 = local_1.group_mask;
                            let _e2620 = local_1.group_mask;
                            local_1.group_mask = (_e2620 & ~((1u << bitcast<u32>((_e2602 & 31u)))));
                            let _e2623 = local_1.group;
                            phi_2895_ = (_e2623 + countOneBits(((_e2606 & ~((4294967295u << bitcast<u32>((((_e2602 - 24u) ^ _e397) & 31u))))) & 255u)));
                        } else {
                            phi_2895_ = 4294967295u;
                        }
                        let _e2626 = phi_2895_;
                        phi_795_ = _e2626;
                        let _e3732 = local_10;
                        phi_798_ = _e3732;
                    } else {
                        phi_795_ = u32();
                        phi_798_ = lt_bvh_Hit();
                    }
                    let _e2628 = phi_795_;
                    let _e2630 = phi_798_;
                    continue;
                    continuing {
                        phi_794_ = _e2628;
                        phi_797_ = _e2630;
                        break if !(_e538);
                    }
                }
                let _e3735 = local_11;
                phi_2896_ = _e3735;
            }
            let _e2633 = phi_2896_;
            phi_2897_ = _e2633;
            phi_2898_ = _e235;
        } else {
            phi_2897_ = lt_bvh_Hit();
            phi_2898_ = true;
        }
        let _e2635 = phi_2897_;
        let _e2637 = phi_2898_;
        if _e2637 {
            phi_2902_ = _e173;
        } else {
            phi_2902_ = _e2635;
        }
        let _e2639 = phi_2902_;
        if (_e2639.triangle != 4294967295u) {
            let _e2645 = ((1f - _e2639.u) - _e2639.v);
            if (_e2639.triangle < _e73) {
            } else {
                return;
            }
            let _e2651 = triangles.member[(0u + _e2639.triangle)];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e2662 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e2673 = ((((_e2662.x * _e2651.v0_.x) + (_e2662.y * _e2651.v0_.y)) + (_e2662.z * _e2651.v0_.z)) + (_e2662.w * 1f));
            let _e2675 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e2686 = ((((_e2675.x * _e2651.v0_.x) + (_e2675.y * _e2651.v0_.y)) + (_e2675.z * _e2651.v0_.z)) + (_e2675.w * 1f));
            let _e2688 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            let _e2699 = ((((_e2688.x * _e2651.v0_.x) + (_e2688.y * _e2651.v0_.y)) + (_e2688.z * _e2651.v0_.z)) + (_e2688.w * 1f));
            let _e2706 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e2717 = ((((_e2706.x * _e2651.v1_.x) + (_e2706.y * _e2651.v1_.y)) + (_e2706.z * _e2651.v1_.z)) + (_e2706.w * 1f));
            let _e2719 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e2730 = ((((_e2719.x * _e2651.v1_.x) + (_e2719.y * _e2651.v1_.y)) + (_e2719.z * _e2651.v1_.z)) + (_e2719.w * 1f));
            let _e2732 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            let _e2743 = ((((_e2732.x * _e2651.v1_.x) + (_e2732.y * _e2651.v1_.y)) + (_e2732.z * _e2651.v1_.z)) + (_e2732.w * 1f));
            let _e2750 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e2761 = ((((_e2750.x * _e2651.v2_.x) + (_e2750.y * _e2651.v2_.y)) + (_e2750.z * _e2651.v2_.z)) + (_e2750.w * 1f));
            let _e2763 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e2774 = ((((_e2763.x * _e2651.v2_.x) + (_e2763.y * _e2651.v2_.y)) + (_e2763.z * _e2651.v2_.z)) + (_e2763.w * 1f));
            let _e2776 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            let _e2787 = ((((_e2776.x * _e2651.v2_.x) + (_e2776.y * _e2651.v2_.y)) + (_e2776.z * _e2651.v2_.z)) + (_e2776.w * 1f));
            let _e2800 = (((_e2673 * _e2645) + (_e2717 * _e2639.u)) + (_e2761 * _e2639.v));
            let _e2801 = (((_e2686 * _e2645) + (_e2730 * _e2639.u)) + (_e2774 * _e2639.v));
            let _e2802 = (((_e2699 * _e2645) + (_e2743 * _e2639.u)) + (_e2787 * _e2639.v));
            let _e2804 = abs(_e2673);
            let _e2805 = abs(_e2686);
            let _e2806 = abs(_e2699);
            let _e2807 = abs(_e2717);
            let _e2808 = abs(_e2730);
            let _e2809 = abs(_e2743);
            if (_e2804 > _e2807) {
                phi_3090_ = _e2804;
            } else {
                phi_3090_ = _e2807;
            }
            let _e2812 = phi_3090_;
            if (_e2805 > _e2808) {
                phi_3095_ = _e2805;
            } else {
                phi_3095_ = _e2808;
            }
            let _e2815 = phi_3095_;
            if (_e2806 > _e2809) {
                phi_3100_ = _e2806;
            } else {
                phi_3100_ = _e2809;
            }
            let _e2818 = phi_3100_;
            let _e2819 = abs(_e2761);
            let _e2820 = abs(_e2774);
            let _e2821 = abs(_e2787);
            if (_e2812 > _e2819) {
                phi_3108_ = _e2812;
            } else {
                phi_3108_ = _e2819;
            }
            let _e2824 = phi_3108_;
            if (_e2815 > _e2820) {
                phi_3113_ = _e2815;
            } else {
                phi_3113_ = _e2820;
            }
            let _e2827 = phi_3113_;
            if (_e2818 > _e2821) {
                phi_3118_ = _e2818;
            } else {
                phi_3118_ = _e2821;
            }
            let _e2830 = phi_3118_;
            let _e2831 = (_e2717 - _e2673);
            let _e2832 = (_e2730 - _e2686);
            let _e2833 = (_e2743 - _e2699);
            let _e2834 = (_e2761 - _e2673);
            let _e2835 = (_e2774 - _e2686);
            let _e2836 = (_e2787 - _e2699);
            let _e2840 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2832), abs(_e2833));
            let _e2841 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2831), _e2840);
            let _e2842 = (_e2831 / _e2841);
            let _e2843 = (_e2832 / _e2841);
            let _e2844 = (_e2833 / _e2841);
            let _e2848 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2835), abs(_e2836));
            let _e2849 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e2834), _e2848);
            let _e2850 = (_e2834 / _e2849);
            let _e2851 = (_e2835 / _e2849);
            let _e2852 = (_e2836 / _e2849);
            let _e2855 = ((_e2843 * _e2852) - (_e2851 * _e2844));
            let _e2858 = ((_e2844 * _e2850) - (_e2852 * _e2842));
            let _e2861 = ((_e2842 * _e2851) - (_e2850 * _e2843));
            let _e2863 = p.member.eye;
            let _e2876 = (1f / sqrt((((_e2855 * _e2855) + (_e2858 * _e2858)) + (_e2861 * _e2861))));
            let _e2877 = (_e2855 * _e2876);
            let _e2878 = (_e2858 * _e2876);
            let _e2879 = (_e2861 * _e2876);
            if ((((_e2877 * (_e2863.x - _e2800)) + (_e2878 * (_e2863.y - _e2801))) + (_e2879 * (_e2863.z - _e2802))) < 0f) {
                phi_3182_ = vec3<f32>(-(_e2877), -(_e2878), -(_e2879));
            } else {
                phi_3182_ = vec3<f32>(_e2877, _e2878, _e2879);
            }
            let _e2892 = phi_3182_;
            if (_e2639.triangle < _e73) {
            } else {
                return;
            }
            let _e2897 = triangles.member[(0u + _e2639.triangle)];
            let _e2899 = (_e2897.i0_ & 2147483647u);
            if (_e2899 < _e76) {
            } else {
                return;
            }
            let _e2905 = vertices.member[(0u + _e2899)];
            if (_e2897.i1_ < _e76) {
            } else {
                return;
            }
            let _e2909 = vertices.member[(0u + _e2897.i1_)];
            if (_e2897.i2_ < _e76) {
            } else {
                return;
            }
            let _e2913 = vertices.member[(0u + _e2897.i2_)];
            let _e2914 = array<abi_Vertex, 3>(_e2905, _e2909, _e2913);
            if (_e2914[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e2920 = materials.member[(0u + _e2914[0].material)];
            let _e2937 = (1f / 255f);
            let _e2956 = (1f / 255f);
            let _e2978 = (1f / 255f);
            let _e2991 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2645, _e2639.u, _e2639.v));
            let _e2993 = ((_e2920.base_color.x * ((((f32((_e2914[0].color & 255u)) * _e2937) * _e2645) + ((f32((_e2914[1].color & 255u)) * _e2956) * _e2639.u)) + ((f32((_e2914[2].color & 255u)) * _e2978) * _e2639.v))) * _e2991.x);
            let _e2995 = ((_e2920.base_color.y * ((((f32(((_e2914[0].color >> bitcast<u32>(8i)) & 255u)) * _e2937) * _e2645) + ((f32(((_e2914[1].color >> bitcast<u32>(8i)) & 255u)) * _e2956) * _e2639.u)) + ((f32(((_e2914[2].color >> bitcast<u32>(8i)) & 255u)) * _e2978) * _e2639.v))) * _e2991.y);
            let _e2997 = ((_e2920.base_color.z * ((((f32(((_e2914[0].color >> bitcast<u32>(16i)) & 255u)) * _e2937) * _e2645) + ((f32(((_e2914[1].color >> bitcast<u32>(16i)) & 255u)) * _e2956) * _e2639.u)) + ((f32(((_e2914[2].color >> bitcast<u32>(16i)) & 255u)) * _e2978) * _e2639.v))) * _e2991.z);
            let _e2998 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2827, _e2830);
            let _e2999 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e2824, _e2998);
            if ((_e2920.flags & 2u) == 0u) {
                phi_3303_ = 0u;
            } else {
                phi_3303_ = 1u;
            }
            let _e3004 = phi_3303_;
            if (_e2914[0].normal == 2147516416u) {
                phi_3533_ = _e2892;
            } else {
                let _e3017 = (f32((bitcast<i32>((_e2914[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3023 = (f32((bitcast<i32>(_e2914[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3027 = ((1f - abs(_e3017)) - abs(_e3023));
                if (_e3027 < 0f) {
                    phi_3330_ = -(_e3027);
                } else {
                    phi_3330_ = 0f;
                }
                let _e3031 = phi_3330_;
                if (_e3017 < 0f) {
                    phi_3337_ = (_e3017 + _e3031);
                } else {
                    phi_3337_ = (_e3017 - _e3031);
                }
                let _e3036 = phi_3337_;
                if (_e3023 < 0f) {
                    phi_3344_ = (_e3023 + _e3031);
                } else {
                    phi_3344_ = (_e3023 - _e3031);
                }
                let _e3041 = phi_3344_;
                let _e3048 = (1f / sqrt((((_e3036 * _e3036) + (_e3041 * _e3041)) + (_e3027 * _e3027))));
                let _e3064 = (f32((bitcast<i32>((_e2914[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3070 = (f32((bitcast<i32>(_e2914[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3074 = ((1f - abs(_e3064)) - abs(_e3070));
                if (_e3074 < 0f) {
                    phi_3379_ = -(_e3074);
                } else {
                    phi_3379_ = 0f;
                }
                let _e3078 = phi_3379_;
                if (_e3064 < 0f) {
                    phi_3386_ = (_e3064 + _e3078);
                } else {
                    phi_3386_ = (_e3064 - _e3078);
                }
                let _e3083 = phi_3386_;
                if (_e3070 < 0f) {
                    phi_3393_ = (_e3070 + _e3078);
                } else {
                    phi_3393_ = (_e3070 - _e3078);
                }
                let _e3088 = phi_3393_;
                let _e3095 = (1f / sqrt((((_e3083 * _e3083) + (_e3088 * _e3088)) + (_e3074 * _e3074))));
                let _e3114 = (f32((bitcast<i32>((_e2914[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3120 = (f32((bitcast<i32>(_e2914[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3124 = ((1f - abs(_e3114)) - abs(_e3120));
                if (_e3124 < 0f) {
                    phi_3431_ = -(_e3124);
                } else {
                    phi_3431_ = 0f;
                }
                let _e3128 = phi_3431_;
                if (_e3114 < 0f) {
                    phi_3438_ = (_e3114 + _e3128);
                } else {
                    phi_3438_ = (_e3114 - _e3128);
                }
                let _e3133 = phi_3438_;
                if (_e3120 < 0f) {
                    phi_3445_ = (_e3120 + _e3128);
                } else {
                    phi_3445_ = (_e3120 - _e3128);
                }
                let _e3138 = phi_3445_;
                let _e3145 = (1f / sqrt((((_e3133 * _e3133) + (_e3138 * _e3138)) + (_e3124 * _e3124))));
                let _e3152 = ((((_e3036 * _e3048) * _e2645) + ((_e3083 * _e3095) * _e2639.u)) + ((_e3133 * _e3145) * _e2639.v));
                let _e3153 = ((((_e3041 * _e3048) * _e2645) + ((_e3088 * _e3095) * _e2639.u)) + ((_e3138 * _e3145) * _e2639.v));
                let _e3154 = ((((_e3027 * _e3048) * _e2645) + ((_e3074 * _e3095) * _e2639.u)) + ((_e3124 * _e3145) * _e2639.v));
                if (_e2639.instance < _e85) {
                } else {
                    return;
                }
                let _e3161 = instances.member[(0u + _e2639.instance)].world_to_object[0u];
                let _e3170 = instances.member[(0u + _e2639.instance)].world_to_object[1u];
                let _e3182 = instances.member[(0u + _e2639.instance)].world_to_object[2u];
                let _e3189 = (((_e3161.x * _e3152) + (_e3170.x * _e3153)) + (_e3182.x * _e3154));
                let _e3190 = (((_e3161.y * _e3152) + (_e3170.y * _e3153)) + (_e3182.y * _e3154));
                let _e3191 = (((_e3161.z * _e3152) + (_e3170.z * _e3153)) + (_e3182.z * _e3154));
                let _e3197 = sqrt((((_e3189 * _e3189) + (_e3190 * _e3190)) + (_e3191 * _e3191)));
                if (_e3197 > 0f) {
                    let _e3199 = (_e3189 / _e3197);
                    let _e3200 = (_e3190 / _e3197);
                    let _e3201 = (_e3191 / _e3197);
                    if ((((_e3199 * _e2892.x) + (_e3200 * _e2892.y)) + (_e3201 * _e2892.z)) < 0f) {
                        phi_3531_ = vec3<f32>(-(_e3199), -(_e3200), -(_e3201));
                    } else {
                        phi_3531_ = vec3<f32>(_e3199, _e3200, _e3201);
                    }
                    let _e3217 = phi_3531_;
                    phi_3532_ = _e3217;
                } else {
                    phi_3532_ = _e2892;
                }
                let _e3219 = phi_3532_;
                phi_3533_ = _e3219;
            }
            let _e3221 = phi_3533_;
            if (_e2993 > 0f) {
                if (_e2993 < 1f) {
                    phi_3542_ = _e2993;
                } else {
                    phi_3542_ = 1f;
                }
                let _e3225 = phi_3542_;
                phi_3543_ = _e3225;
            } else {
                phi_3543_ = 0f;
            }
            let _e3227 = phi_3543_;
            if (_e2995 > 0f) {
                if (_e2995 < 1f) {
                    phi_3553_ = _e2995;
                } else {
                    phi_3553_ = 1f;
                }
                let _e3232 = phi_3553_;
                phi_3554_ = _e3232;
            } else {
                phi_3554_ = 0f;
            }
            let _e3234 = phi_3554_;
            if (_e2997 > 0f) {
                if (_e2997 < 1f) {
                    phi_3564_ = _e2997;
                } else {
                    phi_3564_ = 1f;
                }
                let _e3239 = phi_3564_;
                phi_3565_ = _e3239;
            } else {
                phi_3565_ = 0f;
            }
            let _e3241 = phi_3565_;
            let _e3244 = ((sqrt(_e3227) * 255f) + 0.5f);
            let _e3253 = ((sqrt(_e3234) * 255f) + 0.5f);
            let _e3265 = ((sqrt(_e3241) * 255f) + 0.5f);
            phi_3600_ = abi_Sample(vec3<f32>(_e2800, _e2801, _e2802), _e2999, _e2892, _e3004, _e3221, ((select(select(u32(_e3244), 0u, (_e3244 < bitcast<f32>(0u))), 4294967295u, (_e3244 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3253), 0u, (_e3253 < bitcast<f32>(0u))), 4294967295u, (_e3253 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3265), 0u, (_e3265 < bitcast<f32>(0u))), 4294967295u, (_e3265 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_3600_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3279 = phi_3600_;
        if (_e97.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e97.first_primitive)] = _e3279;
        if (_e2639.triangle != 4294967295u) {
            let _e3288 = ((1f - _e2639.u) - _e2639.v);
            if (_e2639.triangle < _e73) {
            } else {
                return;
            }
            let _e3293 = triangles.member[(0u + _e2639.triangle)];
            let _e3295 = (_e3293.i0_ & 2147483647u);
            if (_e3295 < _e88) {
            } else {
                return;
            }
            let _e3301 = before.member[(0u + _e3295)];
            if (_e3293.i1_ < _e88) {
            } else {
                return;
            }
            let _e3305 = before.member[(0u + _e3293.i1_)];
            if (_e3293.i2_ < _e88) {
            } else {
                return;
            }
            let _e3309 = before.member[(0u + _e3293.i2_)];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e3319 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e3332 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e3345 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e3369 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e3382 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e3395 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            if (_e2639.instance < _e85) {
            } else {
                return;
            }
            let _e3422 = instances.member[(0u + _e2639.instance)].object_to_world[0u];
            let _e3435 = instances.member[(0u + _e2639.instance)].object_to_world[1u];
            let _e3448 = instances.member[(0u + _e2639.instance)].object_to_world[2u];
            phi_3823_ = vec3<f32>((((((((_e3319.x * _e3301.x) + (_e3319.y * _e3301.y)) + (_e3319.z * _e3301.z)) + (_e3319.w * 1f)) * _e3288) + (((((_e3369.x * _e3305.x) + (_e3369.y * _e3305.y)) + (_e3369.z * _e3305.z)) + (_e3369.w * 1f)) * _e2639.u)) + (((((_e3422.x * _e3309.x) + (_e3422.y * _e3309.y)) + (_e3422.z * _e3309.z)) + (_e3422.w * 1f)) * _e2639.v)), (((((((_e3332.x * _e3301.x) + (_e3332.y * _e3301.y)) + (_e3332.z * _e3301.z)) + (_e3332.w * 1f)) * _e3288) + (((((_e3382.x * _e3305.x) + (_e3382.y * _e3305.y)) + (_e3382.z * _e3305.z)) + (_e3382.w * 1f)) * _e2639.u)) + (((((_e3435.x * _e3309.x) + (_e3435.y * _e3309.y)) + (_e3435.z * _e3309.z)) + (_e3435.w * 1f)) * _e2639.v)), (((((((_e3345.x * _e3301.x) + (_e3345.y * _e3301.y)) + (_e3345.z * _e3301.z)) + (_e3345.w * 1f)) * _e3288) + (((((_e3395.x * _e3305.x) + (_e3395.y * _e3305.y)) + (_e3395.z * _e3305.z)) + (_e3395.w * 1f)) * _e2639.u)) + (((((_e3448.x * _e3309.x) + (_e3448.y * _e3309.y)) + (_e3448.z * _e3309.z)) + (_e3448.w * 1f)) * _e2639.v)));
        } else {
            phi_3823_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3468 = phi_3823_;
        if (_e97.first_primitive < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e97.first_primitive)] = vec4<f32>(_e3468.x, _e3468.y, _e3468.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
