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
    unnamed: lt_bvh_traverse_Tree,
    unnamed_1: lt_bvh_traverse_Tree,
}

struct lt_bvh_triangle_Intersection {
    t: f32,
    u: f32,
    v: f32,
    is_hit: bool,
}

struct type_46 {
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
var<uniform> p: type_46;
@group(0) @binding(1) 
var<storage> nodes: type_26;
@group(0) @binding(2) 
var<storage> triangles: type_30;
@group(0) @binding(5) 
var<storage, read_write> samples: type_16;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_188_: lt_bvh_traverse_Tree;
    var phi_189_: bool;
    var phi_190_: lt_bvh_traverse_Tree;
    var phi_191_: bool;
    var phi_196_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_188_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_189_ = false;
        } else {
            phi_188_ = lt_bvh_traverse_Tree();
            phi_189_ = true;
        }
        let _e74 = phi_188_;
        let _e76 = phi_189_;
        phi_190_ = _e74;
        phi_191_ = _e76;
    } else {
        phi_190_ = lt_bvh_traverse_Tree();
        phi_191_ = true;
    }
    let _e78 = phi_190_;
    let _e80 = phi_191_;
    if _e80 {
        phi_196_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_196_ = _e78;
    }
    let _e85 = phi_196_;
    return lt_bvh_traverse_Tree(_e85.root, _e85.first_primitive);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_211_: bool;
    var phi_215_: f32;

    if (param_3 != param_3) {
        phi_211_ = true;
    } else {
        let _e64 = (param_4 >= param_3);
        if _e64 {
        }
        phi_211_ = _e64;
    }
    let _e66 = phi_211_;
    if _e66 {
        phi_215_ = param_4;
    } else {
        phi_215_ = param_3;
    }
    let _e68 = phi_215_;
    return _e68;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_227_: bool;
    var phi_231_: f32;

    if (param_5 != param_5) {
        phi_227_ = true;
    } else {
        let _e64 = (param_6 <= param_5);
        if _e64 {
        }
        phi_227_ = _e64;
    }
    let _e66 = phi_227_;
    if _e66 {
        phi_231_ = param_6;
    } else {
        phi_231_ = param_5;
    }
    let _e68 = phi_231_;
    return _e68;
}

fn _lt_bvh_ray_Ray_new(param_7: vec3<f32>, param_8: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_7, 0f, param_8, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_9: f32, param_10: f32) -> f32 {
    var phi_243_: f32;

    if (param_9 > param_10) {
        phi_243_ = param_9;
    } else {
        phi_243_ = param_10;
    }
    let _e65 = phi_243_;
    return _e65;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_11: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(param_12: vec3<f32>) -> vec3<f32> {
    return param_12;
}

fn function_() {
    var local: lt_bvh_traverse_Stack;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_378_: bool;
    var phi_379_: bool;
    var phi_383_: bool;
    var phi_396_: bool;
    var phi_397_: bool;
    var phi_398_: bool;
    var phi_399_: bool;
    var phi_403_: bool;
    var phi_416_: bool;
    var phi_417_: bool;
    var phi_418_: bool;
    var phi_422_: bool;
    var phi_423_: bool;
    var phi_424_: bool;
    var phi_425_: bool;
    var phi_426_: bool;
    var phi_430_: bool;
    var phi_506_: f32;
    var phi_513_: f32;
    var phi_521_: f32;
    var phi_528_: f32;
    var phi_536_: f32;
    var phi_543_: f32;
    var phi_566_: f32;
    var phi_571_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_586_: f32;
    var phi_617_: bool;
    var phi_618_: bool;
    var phi_626_: u32;
    var phi_627_: u32;
    var phi_644_: vec3<f32>;
    var phi_645_: vec3<f32>;
    var phi_658_: u32;
    var phi_663_: u32;
    var phi_668_: u32;
    var phi_782_: bool;
    var phi_783_: bool;
    var phi_814_: u32;
    var phi_816_: lt_bvh_Hit;
    var phi_819_: u32;
    var phi_904_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_931_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_958_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_964_: u32;
    var phi_967_: u32;
    var phi_981_: u32;
    var phi_991_: u32;
    var phi_1001_: u32;
    var phi_1019_: u32;
    var phi_1029_: u32;
    var phi_1039_: u32;
    var phi_1075_: u32;
    var phi_1088_: u32;
    var phi_1093_: u32;
    var phi_1094_: u32;
    var phi_1095_: u32;
    var phi_965_: u32;
    var phi_968_: u32;
    var local_1: u32;
    var local_2: u32;
    var local_3: u32;
    var phi_1153_: lt_bvh_Hit;
    var phi_1156_: u32;
    var phi_1202_: vec3<f32>;
    var phi_1203_: vec3<f32>;
    var phi_1234_: vec3<f32>;
    var phi_1235_: vec3<f32>;
    var phi_1266_: vec3<f32>;
    var phi_1267_: vec3<f32>;
    var phi_1285_: bool;
    var phi_1286_: bool;
    var phi_1290_: f32;
    var phi_1291_: f32;
    var phi_1292_: f32;
    var phi_1293_: f32;
    var phi_1301_: f32;
    var phi_1311_: bool;
    var phi_1312_: bool;
    var phi_1316_: f32;
    var phi_1317_: f32;
    var phi_1318_: f32;
    var phi_1319_: f32;
    var phi_1327_: f32;
    var phi_1337_: bool;
    var phi_1338_: bool;
    var phi_1342_: f32;
    var phi_1343_: f32;
    var phi_1344_: f32;
    var phi_1345_: f32;
    var phi_1353_: f32;
    var phi_1368_: f32;
    var phi_1369_: bool;
    var phi_1370_: f32;
    var phi_1371_: bool;
    var phi_1372_: f32;
    var phi_1373_: bool;
    var phi_1391_: f32;
    var phi_1392_: bool;
    var phi_1393_: bool;
    var phi_1394_: f32;
    var phi_1395_: bool;
    var phi_1396_: bool;
    var phi_1400_: bool;
    var phi_1401_: f32;
    var phi_1402_: bool;
    var phi_1432_: vec3<f32>;
    var phi_1433_: vec3<f32>;
    var phi_1458_: vec3<f32>;
    var phi_1459_: vec3<f32>;
    var phi_1484_: vec3<f32>;
    var phi_1485_: vec3<f32>;
    var phi_1543_: f32;
    var phi_1552_: f32;
    var phi_1561_: f32;
    var phi_1570_: f32;
    var phi_1577_: f32;
    var phi_1584_: f32;
    var phi_1597_: f32;
    var phi_1606_: f32;
    var phi_1615_: f32;
    var phi_1624_: f32;
    var phi_1631_: f32;
    var phi_1638_: f32;
    var phi_1661_: f32;
    var phi_1666_: f32;
    var phi_1671_: f32;
    var phi_1679_: f32;
    var phi_1684_: f32;
    var phi_1689_: f32;
    var phi_1701_: f32;
    var phi_1706_: f32;
    var phi_1711_: f32;
    var phi_1716_: f32;
    var phi_1721_: lt_bvh_triangle_Intersection;
    var phi_1722_: bool;
    var phi_1723_: lt_bvh_triangle_Intersection;
    var phi_1724_: bool;
    var phi_1728_: lt_bvh_triangle_Intersection;
    var phi_1729_: bool;
    var phi_1730_: lt_bvh_triangle_Intersection;
    var phi_1731_: bool;
    var phi_1732_: bool;
    var phi_1736_: bool;
    var phi_1740_: lt_bvh_triangle_Intersection;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1782_: bool;
    var phi_1783_: bool;
    var phi_1784_: bool;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1803_: bool;
    var phi_1811_: lt_bvh_Hit;
    var phi_1812_: lt_bvh_Hit;
    var phi_1813_: lt_bvh_Hit;
    var phi_1814_: lt_bvh_Hit;
    var phi_1154_: lt_bvh_Hit;
    var phi_1157_: u32;
    var phi_1815_: bool;
    var phi_1854_: bool;
    var phi_1855_: bool;
    var phi_1886_: u32;
    var phi_817_: lt_bvh_Hit;
    var phi_820_: u32;
    var phi_1887_: lt_bvh_Hit;
    var phi_1888_: lt_bvh_Hit;
    var phi_1889_: bool;
    var phi_1893_: lt_bvh_Hit;
    var phi_1958_: f32;
    var phi_1963_: f32;
    var phi_1968_: f32;
    var phi_1979_: f32;
    var phi_1984_: f32;
    var phi_1989_: f32;
    var phi_2065_: vec3<f32>;
    var phi_2186_: u32;
    var phi_2213_: f32;
    var phi_2220_: f32;
    var phi_2227_: f32;
    var phi_2262_: f32;
    var phi_2269_: f32;
    var phi_2276_: f32;
    var phi_2314_: f32;
    var phi_2321_: f32;
    var phi_2328_: f32;
    var phi_2387_: vec3<f32>;
    var phi_2388_: vec3<f32>;
    var phi_2389_: vec3<f32>;
    var phi_2398_: f32;
    var phi_2399_: f32;
    var phi_2409_: f32;
    var phi_2410_: f32;
    var phi_2420_: f32;
    var phi_2421_: f32;
    var phi_2456_: abi_Sample;
    var local_4: lt_bvh_Hit;
    var local_5: lt_bvh_Hit;

    let _e62 = id_1;
    let _e66 = arrayLength((&nodes.member));
    let _e69 = arrayLength((&triangles.member));
    let _e72 = arrayLength((&vertices.member));
    let _e81 = p.member.size[0u];
    let _e83 = p.member.size[1u];
    let _e84 = lt_shaders_entry_pixel_index(_e62, _e81, _e83);
    if (bitcast<i32>(_e84.root) != 0i) {
        let _e92 = p.member.eye;
        let _e95 = p.member.grid[0u];
        let _e97 = p.member.grid[1u];
        let _e116 = p.member.size[0u];
        let _e120 = ((((f32(_e62.x) + ((f32((_e62.y & (_e97 - 1u))) + 0.5f) / f32(_e97))) / f32(_e116)) * 2f) - 1f);
        let _e123 = p.member.size[1u];
        let _e127 = (1f - (((f32(_e62.y) + ((f32((_e62.x & (_e95 - 1u))) + 0.5f) / f32(_e95))) / f32(_e123)) * 2f));
        let _e129 = p.member.forward;
        let _e131 = p.member.right;
        let _e145 = p.member.up;
        let _e156 = _lt_bvh_ray_Ray_new(_e92, vec3<f32>(((_e129.x + (_e131.x * _e120)) + (_e145.x * _e127)), ((_e129.y + (_e131.y * _e120)) + (_e145.y * _e127)), ((_e129.z + (_e131.z * _e120)) + (_e145.z * _e127))));
        let _e158 = lt_bvh_Hit(_e156.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e161 = abs(_e156.direction.x);
        let _e163 = abs(_e156.direction.y);
        let _e165 = abs(_e156.direction.z);
        if (abs(_e156.origin.x) < 1000000000000000f) {
            if (abs(_e156.origin.y) < 1000000000000000f) {
                phi_376_ = (abs(_e156.origin.z) < 1000000000000000f);
                phi_377_ = false;
            } else {
                phi_376_ = bool();
                phi_377_ = true;
            }
            let _e177 = phi_376_;
            let _e179 = phi_377_;
            phi_378_ = _e177;
            phi_379_ = _e179;
        } else {
            phi_378_ = bool();
            phi_379_ = true;
        }
        let _e181 = phi_378_;
        let _e183 = phi_379_;
        if _e183 {
            phi_383_ = false;
        } else {
            phi_383_ = _e181;
        }
        let _e185 = phi_383_;
        if _e185 {
            if (_e161 < 1000000000000000f) {
                if (_e163 < 1000000000000000f) {
                    phi_396_ = (_e165 < 1000000000000000f);
                    phi_397_ = false;
                } else {
                    phi_396_ = bool();
                    phi_397_ = true;
                }
                let _e190 = phi_396_;
                let _e192 = phi_397_;
                phi_398_ = _e190;
                phi_399_ = _e192;
            } else {
                phi_398_ = bool();
                phi_399_ = true;
            }
            let _e194 = phi_398_;
            let _e196 = phi_399_;
            if _e196 {
                phi_403_ = false;
            } else {
                phi_403_ = _e194;
            }
            let _e198 = phi_403_;
            if _e198 {
                if (_e161 > 0f) {
                    phi_417_ = bool();
                    phi_418_ = true;
                } else {
                    let _e200 = (_e163 > 0f);
                    if _e200 {
                        phi_416_ = bool();
                    } else {
                        phi_416_ = (_e165 > 0f);
                    }
                    let _e203 = phi_416_;
                    phi_417_ = _e203;
                    phi_418_ = _e200;
                }
                let _e205 = phi_417_;
                let _e207 = phi_418_;
                if _e207 {
                    phi_422_ = true;
                } else {
                    phi_422_ = _e205;
                }
                let _e209 = phi_422_;
                phi_423_ = _e209;
                phi_424_ = false;
            } else {
                phi_423_ = bool();
                phi_424_ = true;
            }
            let _e211 = phi_423_;
            let _e213 = phi_424_;
            phi_425_ = _e211;
            phi_426_ = _e213;
        } else {
            phi_425_ = bool();
            phi_426_ = true;
        }
        let _e215 = phi_425_;
        let _e217 = phi_426_;
        if _e217 {
            phi_430_ = false;
        } else {
            phi_430_ = _e215;
        }
        let _e219 = phi_430_;
        if _e219 {
            let _e220 = (0u >= _e66);
            if _e220 {
                phi_1887_ = lt_bvh_Hit();
            } else {
                if (0u < _e66) {
                } else {
                    return;
                }
                let _e226 = nodes.member[(0u + 0u)].frame[0u];
                let _e230 = nodes.member[(0u + 0u)].frame[1u];
                let _e234 = nodes.member[(0u + 0u)].frame[2u];
                let _e238 = nodes.member[(0u + 0u)].frame[0u];
                let _e242 = nodes.member[(0u + 0u)].frame[1u];
                let _e246 = nodes.member[(0u + 0u)].frame[2u];
                let _e250 = nodes.member[(0u + 0u)].frame[3u];
                let _e289 = core_intrinsics_maximum_number_nsz_f32_(abs(_e156.direction.x), abs(_e156.direction.y));
                let _e290 = core_intrinsics_maximum_number_nsz_f32_(_e289, abs(_e156.direction.z));
                let _e291 = (_e290 * 0.0000000000009094947f);
                if (abs(_e156.direction.x) < _e291) {
                    phi_506_ = _e291;
                } else {
                    phi_506_ = abs(_e156.direction.x);
                }
                let _e297 = phi_506_;
                if (_e156.direction.x < 0f) {
                    phi_513_ = (-1f / _e297);
                } else {
                    phi_513_ = (1f / _e297);
                }
                let _e302 = phi_513_;
                if (abs(_e156.direction.y) < _e291) {
                    phi_521_ = _e291;
                } else {
                    phi_521_ = abs(_e156.direction.y);
                }
                let _e308 = phi_521_;
                if (_e156.direction.y < 0f) {
                    phi_528_ = (-1f / _e308);
                } else {
                    phi_528_ = (1f / _e308);
                }
                let _e313 = phi_528_;
                if (abs(_e156.direction.z) < _e291) {
                    phi_536_ = _e291;
                } else {
                    phi_536_ = abs(_e156.direction.z);
                }
                let _e319 = phi_536_;
                if (_e156.direction.z < 0f) {
                    phi_543_ = (-1f / _e319);
                } else {
                    phi_543_ = (1f / _e319);
                }
                let _e324 = phi_543_;
                let _e331 = abs((bitcast<f32>(_e226) - _e156.origin.x));
                let _e332 = abs((bitcast<f32>(_e230) - _e156.origin.y));
                let _e333 = abs((bitcast<f32>(_e234) - _e156.origin.z));
                let _e340 = abs(((bitcast<f32>(_e238) + (bitcast<f32>((((_e250 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.x));
                let _e341 = abs(((bitcast<f32>(_e242) + (bitcast<f32>((((_e250 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.y));
                let _e342 = abs(((bitcast<f32>(_e246) + (bitcast<f32>((((_e250 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e156.origin.z));
                if (_e331 > _e340) {
                    phi_566_ = _e331;
                } else {
                    phi_566_ = _e340;
                }
                let _e345 = phi_566_;
                if (_e332 > _e341) {
                    phi_571_ = _e332;
                } else {
                    phi_571_ = _e341;
                }
                let _e348 = phi_571_;
                if (_e333 > _e342) {
                    phi_576_ = _e333;
                } else {
                    phi_576_ = _e342;
                }
                let _e351 = phi_576_;
                if (_e345 > _e348) {
                    phi_581_ = _e345;
                } else {
                    phi_581_ = _e348;
                }
                let _e354 = phi_581_;
                if (_e354 > _e351) {
                    phi_586_ = _e354;
                } else {
                    phi_586_ = _e351;
                }
                let _e357 = phi_586_;
                let _e361 = (_e357 * 0.0000019073486f);
                let _e362 = (abs(_e302) * _e361);
                let _e363 = (abs(_e313) * _e361);
                let _e364 = (abs(_e324) * _e361);
                let _e368 = (_e357 * 0.0000009536743f);
                let _e369 = (abs(_e302) * _e368);
                let _e370 = (abs(_e313) * _e368);
                let _e371 = (abs(_e324) * _e368);
                let _e375 = abs(_e156.direction.x);
                let _e377 = abs(_e156.direction.y);
                let _e379 = abs(_e156.direction.z);
                if (_e375 >= _e377) {
                    if (_e375 >= _e379) {
                        phi_617_ = false;
                    } else {
                        phi_617_ = true;
                    }
                    let _e383 = phi_617_;
                    phi_618_ = _e383;
                } else {
                    phi_618_ = true;
                }
                let _e385 = phi_618_;
                if _e385 {
                    if (_e377 >= _e379) {
                        phi_626_ = 1u;
                    } else {
                        phi_626_ = 2u;
                    }
                    let _e388 = phi_626_;
                    phi_627_ = _e388;
                } else {
                    phi_627_ = 0u;
                }
                let _e390 = phi_627_;
                if (_e390 == 0u) {
                    phi_645_ = vec3<f32>(_e156.direction.y, _e156.direction.z, _e156.direction.x);
                } else {
                    if (_e390 == 1u) {
                        phi_644_ = vec3<f32>(_e156.direction.z, _e156.direction.x, _e156.direction.y);
                    } else {
                        phi_644_ = _e156.direction;
                    }
                    let _e402 = phi_644_;
                    phi_645_ = _e402;
                }
                let _e404 = phi_645_;
                let _e407 = (_e404.x / _e404.z);
                let _e410 = (_e404.y / _e404.z);
                if (_e302 < 0f) {
                    phi_658_ = 0u;
                } else {
                    phi_658_ = 1u;
                }
                let _e415 = phi_658_;
                if (_e313 < 0f) {
                    phi_663_ = 0u;
                } else {
                    phi_663_ = 2u;
                }
                let _e418 = phi_663_;
                if (_e324 < 0f) {
                    phi_668_ = 0u;
                } else {
                    phi_668_ = 4u;
                }
                let _e421 = phi_668_;
                let _e423 = ((_e415 | _e418) | _e421);
                let _e424 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local = lt_bvh_traverse_Stack(array<u32, 32>(_e424.first[0], _e424.first[1], _e424.first[2], _e424.first[3], _e424.first[4], _e424.first[5], _e424.first[6], _e424.first[7], _e424.first[8], _e424.first[9], _e424.first[10], _e424.first[11], _e424.first[12], _e424.first[13], _e424.first[14], _e424.first[15], _e424.first[16], _e424.first[17], _e424.first[18], _e424.first[19], _e424.first[20], _e424.first[21], _e424.first[22], _e424.first[23], _e424.first[24], _e424.first[25], _e424.first[26], _e424.first[27], _e424.first[28], _e424.first[29], _e424.first[30], _e424.first[31]), array<u32, 32>(_e424.mask[0], _e424.mask[1], _e424.mask[2], _e424.mask[3], _e424.mask[4], _e424.mask[5], _e424.mask[6], _e424.mask[7], _e424.mask[8], _e424.mask[9], _e424.mask[10], _e424.mask[11], _e424.mask[12], _e424.mask[13], _e424.mask[14], _e424.mask[15], _e424.mask[16], _e424.mask[17], _e424.mask[18], _e424.mask[19], _e424.mask[20], _e424.mask[21], _e424.mask[22], _e424.mask[23], _e424.mask[24], _e424.mask[25], _e424.mask[26], _e424.mask[27], _e424.mask[28], _e424.mask[29], _e424.mask[30], _e424.mask[31]), _e424.len, _e424.group, _e424.group_mask);
                let _e498 = local.group_mask;
                if ((_e498 & 4278190080u) == 0u) {
                    let _e502 = local.len;
                    if (_e502 == 0u) {
                        phi_782_ = false;
                    } else {
                        let _e506 = local.len;
                        local.len = (_e506 - 1u);
                        let _e509 = local.len;
                        if (_e509 < 32u) {
                        } else {
                            return;
                        }
                        let _e514 = local.first[(0u + _e509)];
                        local.group = _e514;
                        let _e517 = local.len;
                        if (_e517 < 32u) {
                        } else {
                            return;
                        }
                        let _e522 = local.mask[(0u + _e517)];
                        local.group_mask = _e522;
                        phi_782_ = true;
                    }
                    let _e525 = phi_782_;
                    phi_783_ = _e525;
                } else {
                    phi_783_ = true;
                }
                let _e527 = phi_783_;
                if _e527 {
                    let _e529 = local.group_mask;
                    let _e535 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e529)), 32u, (_e529 == 0u)));
                    let _e539 = local.group_mask;
                    let _e553 = local.group_mask;
                    local.group_mask = (_e553 & ~((1u << bitcast<u32>((_e535 & 31u)))));
                    let _e556 = local.group;
                    phi_814_ = (_e556 + countOneBits(((_e539 & ~((4294967295u << bitcast<u32>((((_e535 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_814_ = 4294967295u;
                }
                let _e559 = phi_814_;
                phi_816_ = _e158;
                phi_819_ = _e559;
                loop {
                    let _e561 = phi_816_;
                    let _e563 = phi_819_;
                    local_5 = _e561;
                    let _e564 = (_e563 != 4294967295u);
                    if _e564 {
                        if (_e563 < _e66) {
                        } else {
                            return;
                        }
                        let _e572 = nodes.member[(0u + _e563)].frame[3u];
                        let _e597 = (bitcast<f32>((((_e572 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e302);
                        let _e598 = (bitcast<f32>((((_e572 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e313);
                        let _e599 = (bitcast<f32>((((_e572 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e324);
                        let _e602 = nodes.member[(0u + _e563)].frame[0u];
                        let _e606 = nodes.member[(0u + _e563)].frame[1u];
                        let _e610 = nodes.member[(0u + _e563)].frame[2u];
                        let _e618 = ((bitcast<f32>(_e602) - _e156.origin.x) * _e302);
                        let _e619 = ((bitcast<f32>(_e606) - _e156.origin.y) * _e313);
                        let _e620 = ((bitcast<f32>(_e610) - _e156.origin.z) * _e324);
                        let _e628 = nodes.member[(0u + _e563)].x;
                        if (_e302 < 0f) {
                            let _e639 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e645 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e639.unnamed.root, _e628.w), _e639.unnamed_1);
                            let _e651 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e645.unnamed, lt_bvh_traverse_Tree(_e628.x, _e645.unnamed_1.first_primitive));
                            phi_904_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e651.unnamed, lt_bvh_traverse_Tree(_e651.unnamed_1.root, _e628.y));
                        } else {
                            let _e667 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e628.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e673 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e667.unnamed.root, _e628.y), _e667.unnamed_1);
                            let _e679 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e673.unnamed, lt_bvh_traverse_Tree(_e628.z, _e673.unnamed_1.first_primitive));
                            phi_904_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e679.unnamed, lt_bvh_traverse_Tree(_e679.unnamed_1.root, _e628.w));
                        }
                        let _e687 = phi_904_;
                        let _e697 = nodes.member[(0u + _e563)].y;
                        if (_e313 < 0f) {
                            let _e708 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e714 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e708.unnamed.root, _e697.w), _e708.unnamed_1);
                            let _e720 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e714.unnamed, lt_bvh_traverse_Tree(_e697.x, _e714.unnamed_1.first_primitive));
                            phi_931_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e720.unnamed, lt_bvh_traverse_Tree(_e720.unnamed_1.root, _e697.y));
                        } else {
                            let _e736 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e697.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e742 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e736.unnamed.root, _e697.y), _e736.unnamed_1);
                            let _e748 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e742.unnamed, lt_bvh_traverse_Tree(_e697.z, _e742.unnamed_1.first_primitive));
                            phi_931_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e748.unnamed, lt_bvh_traverse_Tree(_e748.unnamed_1.root, _e697.w));
                        }
                        let _e756 = phi_931_;
                        let _e766 = nodes.member[(0u + _e563)].z;
                        if (_e324 < 0f) {
                            let _e777 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e766.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e783 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e777.unnamed.root, _e766.w), _e777.unnamed_1);
                            let _e789 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e783.unnamed, lt_bvh_traverse_Tree(_e766.x, _e783.unnamed_1.first_primitive));
                            phi_958_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e789.unnamed, lt_bvh_traverse_Tree(_e789.unnamed_1.root, _e766.y));
                        } else {
                            let _e805 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e766.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e811 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e805.unnamed.root, _e766.y), _e805.unnamed_1);
                            let _e817 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e811.unnamed, lt_bvh_traverse_Tree(_e766.z, _e811.unnamed_1.first_primitive));
                            phi_958_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e817.unnamed, lt_bvh_traverse_Tree(_e817.unnamed_1.root, _e766.w));
                        }
                        let _e825 = phi_958_;
                        phi_964_ = 0u;
                        phi_967_ = 0u;
                        loop {
                            let _e835 = phi_964_;
                            let _e837 = phi_967_;
                            local_1 = _e837;
                            local_2 = _e837;
                            local_3 = _e837;
                            let _e838 = (_e835 < 8u);
                            if _e838 {
                                let _e840 = (_e835 >> bitcast<u32>(2i));
                                let _e841 = (_e835 & 3u);
                                if (_e840 == 0u) {
                                    phi_981_ = _e687.unnamed.root;
                                } else {
                                    phi_981_ = _e687.unnamed.first_primitive;
                                }
                                let _e844 = phi_981_;
                                if (_e840 == 0u) {
                                    phi_991_ = _e756.unnamed.root;
                                } else {
                                    phi_991_ = _e756.unnamed.first_primitive;
                                }
                                let _e853 = phi_991_;
                                if (_e840 == 0u) {
                                    phi_1001_ = _e825.unnamed.root;
                                } else {
                                    phi_1001_ = _e825.unnamed.first_primitive;
                                }
                                let _e862 = phi_1001_;
                                let _e875 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e844 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 - _e362)), ((f32(((_e853 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 - _e363)));
                                let _e876 = core_intrinsics_maximum_number_nsz_f32_(_e875, ((f32(((_e862 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 - _e364)));
                                if (_e840 == 0u) {
                                    phi_1019_ = _e687.unnamed_1.root;
                                } else {
                                    phi_1019_ = _e687.unnamed_1.first_primitive;
                                }
                                let _e879 = phi_1019_;
                                if (_e840 == 0u) {
                                    phi_1029_ = _e756.unnamed_1.root;
                                } else {
                                    phi_1029_ = _e756.unnamed_1.first_primitive;
                                }
                                let _e888 = phi_1029_;
                                if (_e840 == 0u) {
                                    phi_1039_ = _e825.unnamed_1.root;
                                } else {
                                    phi_1039_ = _e825.unnamed_1.first_primitive;
                                }
                                let _e897 = phi_1039_;
                                let _e910 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e879 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e597) + (_e618 + _e362)), ((f32(((_e888 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e598) + (_e619 + _e363)));
                                let _e911 = core_intrinsics_minimum_number_nsz_f32_(_e910, ((f32(((_e897 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u)) * _e599) + (_e620 + _e364)));
                                if (_e876 <= _e911) {
                                    if (_e876 <= _e561.t) {
                                        if (_e911 >= _e156.tmin) {
                                            if (_e840 == 0u) {
                                                let _e918 = nodes.member[(0u + _e563)].links[2u];
                                                phi_1075_ = _e918;
                                            } else {
                                                let _e921 = nodes.member[(0u + _e563)].links[3u];
                                                phi_1075_ = _e921;
                                            }
                                            let _e923 = phi_1075_;
                                            let _e928 = ((_e923 >> bitcast<u32>(((_e841 * 8u) & 31u))) & 255u);
                                            let _e929 = (_e928 & 31u);
                                            if (_e929 >= 24u) {
                                                phi_1088_ = (24u + ((_e929 - 24u) ^ _e423));
                                            } else {
                                                phi_1088_ = _e929;
                                            }
                                            let _e935 = phi_1088_;
                                            phi_1093_ = (_e837 | ((_e928 >> bitcast<u32>(5i)) << bitcast<u32>((_e935 & 31u))));
                                        } else {
                                            phi_1093_ = _e837;
                                        }
                                        let _e943 = phi_1093_;
                                        phi_1094_ = _e943;
                                    } else {
                                        phi_1094_ = _e837;
                                    }
                                    let _e945 = phi_1094_;
                                    phi_1095_ = _e945;
                                } else {
                                    phi_1095_ = _e837;
                                }
                                let _e947 = phi_1095_;
                                phi_965_ = (_e835 + 1u);
                                phi_968_ = _e947;
                            } else {
                                phi_965_ = u32();
                                phi_968_ = u32();
                            }
                            let _e950 = phi_965_;
                            let _e952 = phi_968_;
                            continue;
                            continuing {
                                phi_964_ = _e950;
                                phi_967_ = _e952;
                                break if !(_e838);
                            }
                        }
                        let _e956 = nodes.member[(0u + _e563)].links[0u];
                        let _e960 = nodes.member[(0u + _e563)].frame[3u];
                        let _e964 = local_1;
                        if ((_e964 & 4278190080u) == 0u) {
                        } else {
                            let _e968 = local.group_mask;
                            if ((_e968 & 4278190080u) == 0u) {
                            } else {
                                let _e972 = local.len;
                                if (_e972 < 32u) {
                                    let _e975 = local.group;
                                    let _e977 = local.len;
                                    if (_e977 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.first[(0u + _e977)] = _e975;
                                    let _e983 = local.group_mask;
                                    let _e985 = local.len;
                                    if (_e985 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local.mask[(0u + _e985)] = _e983;
                                    let _e992 = local.len;
                                    local.len = (_e992 + 1u);
                                }
                            }
                            local.group = (0u + _e956);
                            let _e996 = local_2;
                            local.group_mask = ((_e996 & 4278190080u) | (_e960 >> bitcast<u32>(24i)));
                        }
                        let _e1001 = local_3;
                        phi_1153_ = _e561;
                        phi_1156_ = (_e1001 & 16777215u);
                        loop {
                            let _e1004 = phi_1153_;
                            let _e1006 = phi_1156_;
                            local_4 = _e1004;
                            if (_e1006 == 0u) {
                                phi_1154_ = lt_bvh_Hit();
                                phi_1157_ = u32();
                                phi_1815_ = false;
                            } else {
                                let _e1010 = nodes.member[(0u + _e563)].links[1u];
                                let _e1015 = ((0u + _e1010) + select(firstTrailingBit(_e1006), 32u, (_e1006 == 0u)));
                                if (_e1015 < _e69) {
                                } else {
                                    return;
                                }
                                let _e1022 = triangles.member[(0u + _e1015)].v0_;
                                let _e1025 = (_e1022.x - _e156.origin.x);
                                let _e1028 = (_e1022.y - _e156.origin.y);
                                let _e1031 = (_e1022.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1203_ = vec3<f32>(_e1028, _e1031, _e1025);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1202_ = vec3<f32>(_e1031, _e1025, _e1028);
                                    } else {
                                        phi_1202_ = (_e1022 - _e156.origin);
                                    }
                                    let _e1038 = phi_1202_;
                                    phi_1203_ = _e1038;
                                }
                                let _e1040 = phi_1203_;
                                let _e1044 = (_e1040.x - (_e407 * _e1040.z));
                                let _e1048 = (_e1040.y - (_e410 * _e1040.z));
                                let _e1050 = triangles.member[(0u + _e1015)].v1_;
                                let _e1053 = (_e1050.x - _e156.origin.x);
                                let _e1056 = (_e1050.y - _e156.origin.y);
                                let _e1059 = (_e1050.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1235_ = vec3<f32>(_e1056, _e1059, _e1053);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1234_ = vec3<f32>(_e1059, _e1053, _e1056);
                                    } else {
                                        phi_1234_ = (_e1050 - _e156.origin);
                                    }
                                    let _e1066 = phi_1234_;
                                    phi_1235_ = _e1066;
                                }
                                let _e1068 = phi_1235_;
                                let _e1072 = (_e1068.x - (_e407 * _e1068.z));
                                let _e1076 = (_e1068.y - (_e410 * _e1068.z));
                                let _e1078 = triangles.member[(0u + _e1015)].v2_;
                                let _e1081 = (_e1078.x - _e156.origin.x);
                                let _e1084 = (_e1078.y - _e156.origin.y);
                                let _e1087 = (_e1078.z - _e156.origin.z);
                                if (_e390 == 0u) {
                                    phi_1267_ = vec3<f32>(_e1084, _e1087, _e1081);
                                } else {
                                    if (_e390 == 1u) {
                                        phi_1266_ = vec3<f32>(_e1087, _e1081, _e1084);
                                    } else {
                                        phi_1266_ = (_e1078 - _e156.origin);
                                    }
                                    let _e1094 = phi_1266_;
                                    phi_1267_ = _e1094;
                                }
                                let _e1096 = phi_1267_;
                                let _e1100 = (_e1096.x - (_e407 * _e1096.z));
                                let _e1104 = (_e1096.y - (_e410 * _e1096.z));
                                if (_e1072 < _e1100) {
                                    phi_1286_ = true;
                                } else {
                                    if (_e1072 == _e1100) {
                                        phi_1285_ = (_e1076 < _e1104);
                                    } else {
                                        phi_1285_ = false;
                                    }
                                    let _e1109 = phi_1285_;
                                    phi_1286_ = _e1109;
                                }
                                let _e1111 = phi_1286_;
                                if _e1111 {
                                    phi_1290_ = _e1104;
                                    phi_1291_ = _e1100;
                                    phi_1292_ = _e1076;
                                    phi_1293_ = _e1072;
                                } else {
                                    phi_1290_ = _e1076;
                                    phi_1291_ = _e1072;
                                    phi_1292_ = _e1104;
                                    phi_1293_ = _e1100;
                                }
                                let _e1113 = phi_1290_;
                                let _e1115 = phi_1291_;
                                let _e1117 = phi_1292_;
                                let _e1119 = phi_1293_;
                                let _e1122 = ((_e1119 * _e1113) - (_e1117 * _e1115));
                                if _e1111 {
                                    phi_1301_ = -(_e1122);
                                } else {
                                    phi_1301_ = _e1122;
                                }
                                let _e1125 = phi_1301_;
                                if (_e1100 < _e1044) {
                                    phi_1312_ = true;
                                } else {
                                    if (_e1100 == _e1044) {
                                        phi_1311_ = (_e1104 < _e1048);
                                    } else {
                                        phi_1311_ = false;
                                    }
                                    let _e1130 = phi_1311_;
                                    phi_1312_ = _e1130;
                                }
                                let _e1132 = phi_1312_;
                                if _e1132 {
                                    phi_1316_ = _e1048;
                                    phi_1317_ = _e1044;
                                    phi_1318_ = _e1104;
                                    phi_1319_ = _e1100;
                                } else {
                                    phi_1316_ = _e1104;
                                    phi_1317_ = _e1100;
                                    phi_1318_ = _e1048;
                                    phi_1319_ = _e1044;
                                }
                                let _e1134 = phi_1316_;
                                let _e1136 = phi_1317_;
                                let _e1138 = phi_1318_;
                                let _e1140 = phi_1319_;
                                let _e1143 = ((_e1140 * _e1134) - (_e1138 * _e1136));
                                if _e1132 {
                                    phi_1327_ = -(_e1143);
                                } else {
                                    phi_1327_ = _e1143;
                                }
                                let _e1146 = phi_1327_;
                                if (_e1044 < _e1072) {
                                    phi_1338_ = true;
                                } else {
                                    if (_e1044 == _e1072) {
                                        phi_1337_ = (_e1048 < _e1076);
                                    } else {
                                        phi_1337_ = false;
                                    }
                                    let _e1151 = phi_1337_;
                                    phi_1338_ = _e1151;
                                }
                                let _e1153 = phi_1338_;
                                if _e1153 {
                                    phi_1342_ = _e1076;
                                    phi_1343_ = _e1072;
                                    phi_1344_ = _e1048;
                                    phi_1345_ = _e1044;
                                } else {
                                    phi_1342_ = _e1048;
                                    phi_1343_ = _e1044;
                                    phi_1344_ = _e1076;
                                    phi_1345_ = _e1072;
                                }
                                let _e1155 = phi_1342_;
                                let _e1157 = phi_1343_;
                                let _e1159 = phi_1344_;
                                let _e1161 = phi_1345_;
                                let _e1164 = ((_e1161 * _e1155) - (_e1159 * _e1157));
                                if _e1153 {
                                    phi_1353_ = -(_e1164);
                                } else {
                                    phi_1353_ = _e1164;
                                }
                                let _e1167 = phi_1353_;
                                if (_e1125 >= 0f) {
                                    if (_e1146 >= 0f) {
                                        if (_e1167 >= 0f) {
                                            phi_1368_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1369_ = false;
                                        } else {
                                            phi_1368_ = f32();
                                            phi_1369_ = true;
                                        }
                                        let _e1174 = phi_1368_;
                                        let _e1176 = phi_1369_;
                                        phi_1370_ = _e1174;
                                        phi_1371_ = _e1176;
                                    } else {
                                        phi_1370_ = f32();
                                        phi_1371_ = true;
                                    }
                                    let _e1178 = phi_1370_;
                                    let _e1180 = phi_1371_;
                                    phi_1372_ = _e1178;
                                    phi_1373_ = _e1180;
                                } else {
                                    phi_1372_ = f32();
                                    phi_1373_ = true;
                                }
                                let _e1182 = phi_1372_;
                                let _e1184 = phi_1373_;
                                if _e1184 {
                                    if (_e1125 <= 0f) {
                                        if (_e1146 <= 0f) {
                                            let _e1187 = (_e1167 <= 0f);
                                            if _e1187 {
                                            }
                                            phi_1391_ = ((_e1125 + _e1146) + _e1167);
                                            phi_1392_ = false;
                                            phi_1393_ = _e1187;
                                        } else {
                                            phi_1391_ = f32();
                                            phi_1392_ = true;
                                            phi_1393_ = false;
                                        }
                                        let _e1191 = phi_1391_;
                                        let _e1193 = phi_1392_;
                                        let _e1195 = phi_1393_;
                                        phi_1394_ = _e1191;
                                        phi_1395_ = _e1193;
                                        phi_1396_ = _e1195;
                                    } else {
                                        phi_1394_ = f32();
                                        phi_1395_ = true;
                                        phi_1396_ = false;
                                    }
                                    let _e1197 = phi_1394_;
                                    let _e1199 = phi_1395_;
                                    let _e1201 = phi_1396_;
                                    if _e1199 {
                                        phi_1400_ = false;
                                    } else {
                                        phi_1400_ = _e1201;
                                    }
                                    let _e1203 = phi_1400_;
                                    phi_1401_ = _e1197;
                                    phi_1402_ = _e1203;
                                } else {
                                    phi_1401_ = _e1182;
                                    phi_1402_ = true;
                                }
                                let _e1205 = phi_1401_;
                                let _e1207 = phi_1402_;
                                if _e1207 {
                                    let _e1208 = (_e1205 == 0f);
                                    if _e1208 {
                                        phi_1728_ = lt_bvh_triangle_Intersection();
                                        phi_1729_ = false;
                                    } else {
                                        let _e1210 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1213 = (_e1210.x - _e156.origin.x);
                                        let _e1216 = (_e1210.y - _e156.origin.y);
                                        let _e1219 = (_e1210.z - _e156.origin.z);
                                        if (_e390 == 0u) {
                                            phi_1433_ = vec3<f32>(_e1216, _e1219, _e1213);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1432_ = vec3<f32>(_e1219, _e1213, _e1216);
                                            } else {
                                                phi_1432_ = (_e1210 - _e156.origin);
                                            }
                                            let _e1226 = phi_1432_;
                                            phi_1433_ = _e1226;
                                        }
                                        let _e1228 = phi_1433_;
                                        let _e1230 = triangles.member[(0u + _e1015)].v1_;
                                        let _e1232 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1235 = (_e1230.x - _e1232.x);
                                        let _e1238 = (_e1230.y - _e1232.y);
                                        let _e1241 = (_e1230.z - _e1232.z);
                                        if (_e390 == 0u) {
                                            phi_1459_ = vec3<f32>(_e1238, _e1241, _e1235);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1458_ = vec3<f32>(_e1241, _e1235, _e1238);
                                            } else {
                                                phi_1458_ = (_e1230 - _e1232);
                                            }
                                            let _e1248 = phi_1458_;
                                            phi_1459_ = _e1248;
                                        }
                                        let _e1250 = phi_1459_;
                                        let _e1252 = triangles.member[(0u + _e1015)].v2_;
                                        let _e1254 = triangles.member[(0u + _e1015)].v0_;
                                        let _e1257 = (_e1252.x - _e1254.x);
                                        let _e1260 = (_e1252.y - _e1254.y);
                                        let _e1263 = (_e1252.z - _e1254.z);
                                        if (_e390 == 0u) {
                                            phi_1485_ = vec3<f32>(_e1260, _e1263, _e1257);
                                        } else {
                                            if (_e390 == 1u) {
                                                phi_1484_ = vec3<f32>(_e1263, _e1257, _e1260);
                                            } else {
                                                phi_1484_ = (_e1252 - _e1254);
                                            }
                                            let _e1270 = phi_1484_;
                                            phi_1485_ = _e1270;
                                        }
                                        let _e1272 = phi_1485_;
                                        let _e1279 = ((_e1250.y * _e1272.z) - (_e1250.z * _e1272.y));
                                        let _e1286 = ((_e1250.z * _e1272.x) - (_e1250.x * _e1272.z));
                                        let _e1293 = ((_e1250.x * _e1272.y) - (_e1250.y * _e1272.x));
                                        let _e1307 = (((1f / _e404.z) * (((_e1279 * _e1228.x) + (_e1286 * _e1228.y)) + (_e1293 * _e1228.z))) / (((_e1279 * _e407) + (_e1286 * _e410)) + _e1293));
                                        if (_e1307 > _e156.tmin) {
                                            if (_e1307 < _e156.tmax) {
                                                let _e1313 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1315 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1313.x < _e1315.x) {
                                                    phi_1543_ = _e1313.x;
                                                } else {
                                                    phi_1543_ = _e1315.x;
                                                }
                                                let _e1322 = phi_1543_;
                                                if (_e1313.y < _e1315.y) {
                                                    phi_1552_ = _e1313.y;
                                                } else {
                                                    phi_1552_ = _e1315.y;
                                                }
                                                let _e1329 = phi_1552_;
                                                if (_e1313.z < _e1315.z) {
                                                    phi_1561_ = _e1313.z;
                                                } else {
                                                    phi_1561_ = _e1315.z;
                                                }
                                                let _e1336 = phi_1561_;
                                                let _e1338 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1322 < _e1338.x) {
                                                    phi_1570_ = _e1322;
                                                } else {
                                                    phi_1570_ = _e1338.x;
                                                }
                                                let _e1343 = phi_1570_;
                                                if (_e1329 < _e1338.y) {
                                                    phi_1577_ = _e1329;
                                                } else {
                                                    phi_1577_ = _e1338.y;
                                                }
                                                let _e1348 = phi_1577_;
                                                if (_e1336 < _e1338.z) {
                                                    phi_1584_ = _e1336;
                                                } else {
                                                    phi_1584_ = _e1338.z;
                                                }
                                                let _e1353 = phi_1584_;
                                                let _e1355 = triangles.member[(0u + _e1015)].v0_;
                                                let _e1357 = triangles.member[(0u + _e1015)].v1_;
                                                if (_e1355.x > _e1357.x) {
                                                    phi_1597_ = _e1355.x;
                                                } else {
                                                    phi_1597_ = _e1357.x;
                                                }
                                                let _e1364 = phi_1597_;
                                                if (_e1355.y > _e1357.y) {
                                                    phi_1606_ = _e1355.y;
                                                } else {
                                                    phi_1606_ = _e1357.y;
                                                }
                                                let _e1371 = phi_1606_;
                                                if (_e1355.z > _e1357.z) {
                                                    phi_1615_ = _e1355.z;
                                                } else {
                                                    phi_1615_ = _e1357.z;
                                                }
                                                let _e1378 = phi_1615_;
                                                let _e1380 = triangles.member[(0u + _e1015)].v2_;
                                                if (_e1364 > _e1380.x) {
                                                    phi_1624_ = _e1364;
                                                } else {
                                                    phi_1624_ = _e1380.x;
                                                }
                                                let _e1385 = phi_1624_;
                                                if (_e1371 > _e1380.y) {
                                                    phi_1631_ = _e1371;
                                                } else {
                                                    phi_1631_ = _e1380.y;
                                                }
                                                let _e1390 = phi_1631_;
                                                if (_e1378 > _e1380.z) {
                                                    phi_1638_ = _e1378;
                                                } else {
                                                    phi_1638_ = _e1380.z;
                                                }
                                                let _e1395 = phi_1638_;
                                                let _e1402 = ((_e1343 - _e156.origin.x) * _e302);
                                                let _e1403 = ((_e1348 - _e156.origin.y) * _e313);
                                                let _e1404 = ((_e1353 - _e156.origin.z) * _e324);
                                                let _e1411 = ((_e1385 - _e156.origin.x) * _e302);
                                                let _e1412 = ((_e1390 - _e156.origin.y) * _e313);
                                                let _e1413 = ((_e1395 - _e156.origin.z) * _e324);
                                                if (_e1402 < _e1411) {
                                                    phi_1661_ = _e1402;
                                                } else {
                                                    phi_1661_ = _e1411;
                                                }
                                                let _e1416 = phi_1661_;
                                                if (_e1403 < _e1412) {
                                                    phi_1666_ = _e1403;
                                                } else {
                                                    phi_1666_ = _e1412;
                                                }
                                                let _e1419 = phi_1666_;
                                                if (_e1404 < _e1413) {
                                                    phi_1671_ = _e1404;
                                                } else {
                                                    phi_1671_ = _e1413;
                                                }
                                                let _e1422 = phi_1671_;
                                                if (_e1402 > _e1411) {
                                                    phi_1679_ = _e1402;
                                                } else {
                                                    phi_1679_ = _e1411;
                                                }
                                                let _e1428 = phi_1679_;
                                                if (_e1403 > _e1412) {
                                                    phi_1684_ = _e1403;
                                                } else {
                                                    phi_1684_ = _e1412;
                                                }
                                                let _e1431 = phi_1684_;
                                                if (_e1404 > _e1413) {
                                                    phi_1689_ = _e1404;
                                                } else {
                                                    phi_1689_ = _e1413;
                                                }
                                                let _e1434 = phi_1689_;
                                                let _e1438 = core_intrinsics_maximum_number_nsz_f32_((_e1416 - _e369), (_e1419 - _e370));
                                                let _e1439 = core_intrinsics_maximum_number_nsz_f32_(_e1438, (_e1422 - _e371));
                                                let _e1440 = core_intrinsics_minimum_number_nsz_f32_((_e1428 + _e369), (_e1431 + _e370));
                                                let _e1441 = core_intrinsics_minimum_number_nsz_f32_(_e1440, (_e1434 + _e371));
                                                if (_e1439 > -300000000000000000000000000000000000000f) {
                                                    phi_1701_ = _e1439;
                                                } else {
                                                    phi_1701_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1444 = phi_1701_;
                                                if (_e1441 < 300000000000000000000000000000000000000f) {
                                                    phi_1706_ = _e1441;
                                                } else {
                                                    phi_1706_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1447 = phi_1706_;
                                                if (_e1307 < _e1444) {
                                                    phi_1711_ = _e1444;
                                                } else {
                                                    phi_1711_ = _e1307;
                                                }
                                                let _e1450 = phi_1711_;
                                                if (_e1450 > _e1447) {
                                                    phi_1716_ = _e1447;
                                                } else {
                                                    phi_1716_ = _e1450;
                                                }
                                                let _e1453 = phi_1716_;
                                                phi_1721_ = lt_bvh_triangle_Intersection(_e1453, (_e1146 / _e1205), (_e1167 / _e1205), (_e1444 <= _e1447));
                                                phi_1722_ = false;
                                            } else {
                                                phi_1721_ = lt_bvh_triangle_Intersection();
                                                phi_1722_ = true;
                                            }
                                            let _e1459 = phi_1721_;
                                            let _e1461 = phi_1722_;
                                            phi_1723_ = _e1459;
                                            phi_1724_ = _e1461;
                                        } else {
                                            phi_1723_ = lt_bvh_triangle_Intersection();
                                            phi_1724_ = true;
                                        }
                                        let _e1463 = phi_1723_;
                                        let _e1465 = phi_1724_;
                                        if _e1465 {
                                        }
                                        phi_1728_ = _e1463;
                                        phi_1729_ = _e1465;
                                    }
                                    let _e1467 = phi_1728_;
                                    let _e1469 = phi_1729_;
                                    phi_1730_ = _e1467;
                                    phi_1731_ = _e1208;
                                    phi_1732_ = _e1469;
                                } else {
                                    phi_1730_ = lt_bvh_triangle_Intersection();
                                    phi_1731_ = true;
                                    phi_1732_ = false;
                                }
                                let _e1471 = phi_1730_;
                                let _e1473 = phi_1731_;
                                let _e1475 = phi_1732_;
                                if _e1473 {
                                    phi_1736_ = true;
                                } else {
                                    phi_1736_ = _e1475;
                                }
                                let _e1477 = phi_1736_;
                                if _e1477 {
                                    phi_1740_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1740_ = _e1471;
                                }
                                let _e1479 = phi_1740_;
                                if _e1479.is_hit {
                                    if (_e1479.t > _e156.tmin) {
                                        if (_e1479.t < _e1004.t) {
                                            phi_1789_ = true;
                                        } else {
                                            if (_e1479.t == _e1004.t) {
                                                if (_e1004.triangle != 4294967295u) {
                                                    if (_e1015 < _e1004.triangle) {
                                                        phi_1780_ = true;
                                                    } else {
                                                        if (_e1015 == _e1004.triangle) {
                                                            phi_1779_ = (4294967295u < _e1004.instance);
                                                        } else {
                                                            phi_1779_ = false;
                                                        }
                                                        let _e1498 = phi_1779_;
                                                        phi_1780_ = _e1498;
                                                    }
                                                    let _e1500 = phi_1780_;
                                                    phi_1781_ = _e1500;
                                                    phi_1782_ = false;
                                                } else {
                                                    phi_1781_ = bool();
                                                    phi_1782_ = true;
                                                }
                                                let _e1502 = phi_1781_;
                                                let _e1504 = phi_1782_;
                                                phi_1783_ = _e1502;
                                                phi_1784_ = _e1504;
                                            } else {
                                                phi_1783_ = bool();
                                                phi_1784_ = true;
                                            }
                                            let _e1506 = phi_1783_;
                                            let _e1508 = phi_1784_;
                                            if _e1508 {
                                                phi_1788_ = false;
                                            } else {
                                                phi_1788_ = _e1506;
                                            }
                                            let _e1510 = phi_1788_;
                                            phi_1789_ = _e1510;
                                        }
                                        let _e1512 = phi_1789_;
                                        if _e1512 {
                                            let _e1514 = triangles.member[(0u + _e1015)].i0_;
                                            if ((_e1514 & 2147483648u) == 0u) {
                                                phi_1803_ = true;
                                            } else {
                                                if true {
                                                }
                                                phi_1803_ = true;
                                            }
                                            let _e1518 = phi_1803_;
                                            if _e1518 {
                                                phi_1811_ = lt_bvh_Hit(_e1479.t, _e1479.u, _e1479.v, _e1015, 4294967295u);
                                            } else {
                                                phi_1811_ = _e1004;
                                            }
                                            let _e1524 = phi_1811_;
                                            phi_1812_ = _e1524;
                                        } else {
                                            phi_1812_ = _e1004;
                                        }
                                        let _e1526 = phi_1812_;
                                        phi_1813_ = _e1526;
                                    } else {
                                        phi_1813_ = _e1004;
                                    }
                                    let _e1528 = phi_1813_;
                                    phi_1814_ = _e1528;
                                } else {
                                    phi_1814_ = _e1004;
                                }
                                let _e1530 = phi_1814_;
                                phi_1154_ = _e1530;
                                phi_1157_ = (_e1006 & (_e1006 - 1u));
                                phi_1815_ = true;
                            }
                            let _e1532 = phi_1154_;
                            let _e1534 = phi_1157_;
                            let _e1536 = phi_1815_;
                            continue;
                            continuing {
                                phi_1153_ = _e1532;
                                phi_1156_ = _e1534;
                                break if !(_e1536);
                            }
                        }
                        let _e1539 = local.group_mask;
                        if ((_e1539 & 4278190080u) == 0u) {
                            let _e1543 = local.len;
                            if (_e1543 == 0u) {
                                phi_1854_ = false;
                            } else {
                                let _e1547 = local.len;
                                local.len = (_e1547 - 1u);
                                let _e1550 = local.len;
                                if (_e1550 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1555 = local.first[(0u + _e1550)];
                                local.group = _e1555;
                                let _e1558 = local.len;
                                if (_e1558 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1563 = local.mask[(0u + _e1558)];
                                local.group_mask = _e1563;
                                phi_1854_ = true;
                            }
                            let _e1566 = phi_1854_;
                            phi_1855_ = _e1566;
                        } else {
                            phi_1855_ = true;
                        }
                        let _e1568 = phi_1855_;
                        if _e1568 {
                            let _e1570 = local.group_mask;
                            let _e1576 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1570)), 32u, (_e1570 == 0u)));
                            let _e1580 = local.group_mask;
                            let _e1594 = local.group_mask;
                            local.group_mask = (_e1594 & ~((1u << bitcast<u32>((_e1576 & 31u)))));
                            let _e1597 = local.group;
                            phi_1886_ = (_e1597 + countOneBits(((_e1580 & ~((4294967295u << bitcast<u32>((((_e1576 - 24u) ^ _e423) & 31u))))) & 255u)));
                        } else {
                            phi_1886_ = 4294967295u;
                        }
                        let _e1600 = phi_1886_;
                        let _e2298 = local_4;
                        phi_817_ = _e2298;
                        phi_820_ = _e1600;
                    } else {
                        phi_817_ = lt_bvh_Hit();
                        phi_820_ = u32();
                    }
                    let _e1602 = phi_817_;
                    let _e1604 = phi_820_;
                    continue;
                    continuing {
                        phi_816_ = _e1602;
                        phi_819_ = _e1604;
                        break if !(_e564);
                    }
                }
                let _e2302 = local_5;
                phi_1887_ = _e2302;
            }
            let _e1607 = phi_1887_;
            phi_1888_ = _e1607;
            phi_1889_ = _e220;
        } else {
            phi_1888_ = lt_bvh_Hit();
            phi_1889_ = true;
        }
        let _e1609 = phi_1888_;
        let _e1611 = phi_1889_;
        if _e1611 {
            phi_1893_ = _e158;
        } else {
            phi_1893_ = _e1609;
        }
        let _e1613 = phi_1893_;
        if (_e1613.triangle != 4294967295u) {
            let _e1619 = ((1f - _e1613.u) - _e1613.v);
            if (_e1613.triangle < _e69) {
            } else {
                return;
            }
            let _e1625 = triangles.member[(0u + _e1613.triangle)];
            let _e1650 = (((_e1625.v0_.x * _e1619) + (_e1625.v1_.x * _e1613.u)) + (_e1625.v2_.x * _e1613.v));
            let _e1651 = (((_e1625.v0_.y * _e1619) + (_e1625.v1_.y * _e1613.u)) + (_e1625.v2_.y * _e1613.v));
            let _e1652 = (((_e1625.v0_.z * _e1619) + (_e1625.v1_.z * _e1613.u)) + (_e1625.v2_.z * _e1613.v));
            let _e1655 = abs(_e1625.v0_.x);
            let _e1657 = abs(_e1625.v0_.y);
            let _e1659 = abs(_e1625.v0_.z);
            let _e1661 = abs(_e1625.v1_.x);
            let _e1663 = abs(_e1625.v1_.y);
            let _e1665 = abs(_e1625.v1_.z);
            if (_e1655 > _e1661) {
                phi_1958_ = _e1655;
            } else {
                phi_1958_ = _e1661;
            }
            let _e1668 = phi_1958_;
            if (_e1657 > _e1663) {
                phi_1963_ = _e1657;
            } else {
                phi_1963_ = _e1663;
            }
            let _e1671 = phi_1963_;
            if (_e1659 > _e1665) {
                phi_1968_ = _e1659;
            } else {
                phi_1968_ = _e1665;
            }
            let _e1674 = phi_1968_;
            let _e1676 = abs(_e1625.v2_.x);
            let _e1678 = abs(_e1625.v2_.y);
            let _e1680 = abs(_e1625.v2_.z);
            if (_e1668 > _e1676) {
                phi_1979_ = _e1668;
            } else {
                phi_1979_ = _e1676;
            }
            let _e1683 = phi_1979_;
            if (_e1671 > _e1678) {
                phi_1984_ = _e1671;
            } else {
                phi_1984_ = _e1678;
            }
            let _e1686 = phi_1984_;
            if (_e1674 > _e1680) {
                phi_1989_ = _e1674;
            } else {
                phi_1989_ = _e1680;
            }
            let _e1689 = phi_1989_;
            let _e1692 = (_e1625.v1_.x - _e1625.v0_.x);
            let _e1695 = (_e1625.v1_.y - _e1625.v0_.y);
            let _e1698 = (_e1625.v1_.z - _e1625.v0_.z);
            let _e1701 = (_e1625.v2_.x - _e1625.v0_.x);
            let _e1704 = (_e1625.v2_.y - _e1625.v0_.y);
            let _e1707 = (_e1625.v2_.z - _e1625.v0_.z);
            let _e1711 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1695), abs(_e1698));
            let _e1712 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1692), _e1711);
            let _e1713 = (_e1692 / _e1712);
            let _e1714 = (_e1695 / _e1712);
            let _e1715 = (_e1698 / _e1712);
            let _e1719 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1704), abs(_e1707));
            let _e1720 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e1701), _e1719);
            let _e1721 = (_e1701 / _e1720);
            let _e1722 = (_e1704 / _e1720);
            let _e1723 = (_e1707 / _e1720);
            let _e1726 = ((_e1714 * _e1723) - (_e1722 * _e1715));
            let _e1729 = ((_e1715 * _e1721) - (_e1723 * _e1713));
            let _e1732 = ((_e1713 * _e1722) - (_e1721 * _e1714));
            let _e1734 = p.member.eye;
            let _e1747 = (1f / sqrt((((_e1726 * _e1726) + (_e1729 * _e1729)) + (_e1732 * _e1732))));
            let _e1748 = (_e1726 * _e1747);
            let _e1749 = (_e1729 * _e1747);
            let _e1750 = (_e1732 * _e1747);
            if ((((_e1748 * (_e1734.x - _e1650)) + (_e1749 * (_e1734.y - _e1651))) + (_e1750 * (_e1734.z - _e1652))) < 0f) {
                phi_2065_ = vec3<f32>(-(_e1748), -(_e1749), -(_e1750));
            } else {
                phi_2065_ = vec3<f32>(_e1748, _e1749, _e1750);
            }
            let _e1763 = phi_2065_;
            if (_e1613.triangle < _e69) {
            } else {
                return;
            }
            let _e1768 = triangles.member[(0u + _e1613.triangle)];
            let _e1770 = (_e1768.i0_ & 2147483647u);
            if (_e1770 < _e72) {
            } else {
                return;
            }
            let _e1776 = vertices.member[(0u + _e1770)];
            if (_e1768.i1_ < _e72) {
            } else {
                return;
            }
            let _e1780 = vertices.member[(0u + _e1768.i1_)];
            if (_e1768.i2_ < _e72) {
            } else {
                return;
            }
            let _e1784 = vertices.member[(0u + _e1768.i2_)];
            let _e1785 = array<abi_Vertex, 3>(_e1776, _e1780, _e1784);
            if (_e1785[0].material < arrayLength((&materials.member))) {
            } else {
                return;
            }
            let _e1791 = materials.member[(0u + _e1785[0].material)];
            let _e1808 = (1f / 255f);
            let _e1827 = (1f / 255f);
            let _e1849 = (1f / 255f);
            let _e1862 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e1619, _e1613.u, _e1613.v));
            let _e1864 = ((_e1791.base_color.x * ((((f32((_e1785[0].color & 255u)) * _e1808) * _e1619) + ((f32((_e1785[1].color & 255u)) * _e1827) * _e1613.u)) + ((f32((_e1785[2].color & 255u)) * _e1849) * _e1613.v))) * _e1862.x);
            let _e1866 = ((_e1791.base_color.y * ((((f32(((_e1785[0].color >> bitcast<u32>(8i)) & 255u)) * _e1808) * _e1619) + ((f32(((_e1785[1].color >> bitcast<u32>(8i)) & 255u)) * _e1827) * _e1613.u)) + ((f32(((_e1785[2].color >> bitcast<u32>(8i)) & 255u)) * _e1849) * _e1613.v))) * _e1862.y);
            let _e1868 = ((_e1791.base_color.z * ((((f32(((_e1785[0].color >> bitcast<u32>(16i)) & 255u)) * _e1808) * _e1619) + ((f32(((_e1785[1].color >> bitcast<u32>(16i)) & 255u)) * _e1827) * _e1613.u)) + ((f32(((_e1785[2].color >> bitcast<u32>(16i)) & 255u)) * _e1849) * _e1613.v))) * _e1862.z);
            let _e1869 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1686, _e1689);
            let _e1870 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e1683, _e1869);
            if ((_e1791.flags & 2u) == 0u) {
                phi_2186_ = 0u;
            } else {
                phi_2186_ = 1u;
            }
            let _e1875 = phi_2186_;
            if (_e1785[0].normal == 2147516416u) {
                phi_2389_ = _e1763;
            } else {
                let _e1888 = (f32((bitcast<i32>((_e1785[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1894 = (f32((bitcast<i32>(_e1785[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1898 = ((1f - abs(_e1888)) - abs(_e1894));
                if (_e1898 < 0f) {
                    phi_2213_ = -(_e1898);
                } else {
                    phi_2213_ = 0f;
                }
                let _e1902 = phi_2213_;
                if (_e1888 < 0f) {
                    phi_2220_ = (_e1888 + _e1902);
                } else {
                    phi_2220_ = (_e1888 - _e1902);
                }
                let _e1907 = phi_2220_;
                if (_e1894 < 0f) {
                    phi_2227_ = (_e1894 + _e1902);
                } else {
                    phi_2227_ = (_e1894 - _e1902);
                }
                let _e1912 = phi_2227_;
                let _e1919 = (1f / sqrt((((_e1907 * _e1907) + (_e1912 * _e1912)) + (_e1898 * _e1898))));
                let _e1935 = (f32((bitcast<i32>((_e1785[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1941 = (f32((bitcast<i32>(_e1785[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1945 = ((1f - abs(_e1935)) - abs(_e1941));
                if (_e1945 < 0f) {
                    phi_2262_ = -(_e1945);
                } else {
                    phi_2262_ = 0f;
                }
                let _e1949 = phi_2262_;
                if (_e1935 < 0f) {
                    phi_2269_ = (_e1935 + _e1949);
                } else {
                    phi_2269_ = (_e1935 - _e1949);
                }
                let _e1954 = phi_2269_;
                if (_e1941 < 0f) {
                    phi_2276_ = (_e1941 + _e1949);
                } else {
                    phi_2276_ = (_e1941 - _e1949);
                }
                let _e1959 = phi_2276_;
                let _e1966 = (1f / sqrt((((_e1954 * _e1954) + (_e1959 * _e1959)) + (_e1945 * _e1945))));
                let _e1985 = (f32((bitcast<i32>((_e1785[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1991 = (f32((bitcast<i32>(_e1785[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e1995 = ((1f - abs(_e1985)) - abs(_e1991));
                if (_e1995 < 0f) {
                    phi_2314_ = -(_e1995);
                } else {
                    phi_2314_ = 0f;
                }
                let _e1999 = phi_2314_;
                if (_e1985 < 0f) {
                    phi_2321_ = (_e1985 + _e1999);
                } else {
                    phi_2321_ = (_e1985 - _e1999);
                }
                let _e2004 = phi_2321_;
                if (_e1991 < 0f) {
                    phi_2328_ = (_e1991 + _e1999);
                } else {
                    phi_2328_ = (_e1991 - _e1999);
                }
                let _e2009 = phi_2328_;
                let _e2016 = (1f / sqrt((((_e2004 * _e2004) + (_e2009 * _e2009)) + (_e1995 * _e1995))));
                let _e2027 = _lt_shaders_geometry_FlatGeometry_u0020_as_u0020_lt_shaders_geometry_Geometry_normal_to_world(vec3<f32>(((((_e1907 * _e1919) * _e1619) + ((_e1954 * _e1966) * _e1613.u)) + ((_e2004 * _e2016) * _e1613.v)), ((((_e1912 * _e1919) * _e1619) + ((_e1959 * _e1966) * _e1613.u)) + ((_e2009 * _e2016) * _e1613.v)), ((((_e1898 * _e1919) * _e1619) + ((_e1945 * _e1966) * _e1613.u)) + ((_e1995 * _e2016) * _e1613.v))));
                let _e2039 = sqrt((((_e2027.x * _e2027.x) + (_e2027.y * _e2027.y)) + (_e2027.z * _e2027.z)));
                if (_e2039 > 0f) {
                    let _e2042 = (_e2027.x / _e2039);
                    let _e2044 = (_e2027.y / _e2039);
                    let _e2046 = (_e2027.z / _e2039);
                    if ((((_e2042 * _e1763.x) + (_e2044 * _e1763.y)) + (_e2046 * _e1763.z)) < 0f) {
                        phi_2387_ = vec3<f32>(-(_e2042), -(_e2044), -(_e2046));
                    } else {
                        phi_2387_ = (_e2027 / vec3(_e2039));
                    }
                    let _e2063 = phi_2387_;
                    phi_2388_ = _e2063;
                } else {
                    phi_2388_ = _e1763;
                }
                let _e2065 = phi_2388_;
                phi_2389_ = _e2065;
            }
            let _e2067 = phi_2389_;
            if (_e1864 > 0f) {
                if (_e1864 < 1f) {
                    phi_2398_ = _e1864;
                } else {
                    phi_2398_ = 1f;
                }
                let _e2071 = phi_2398_;
                phi_2399_ = _e2071;
            } else {
                phi_2399_ = 0f;
            }
            let _e2073 = phi_2399_;
            if (_e1866 > 0f) {
                if (_e1866 < 1f) {
                    phi_2409_ = _e1866;
                } else {
                    phi_2409_ = 1f;
                }
                let _e2078 = phi_2409_;
                phi_2410_ = _e2078;
            } else {
                phi_2410_ = 0f;
            }
            let _e2080 = phi_2410_;
            if (_e1868 > 0f) {
                if (_e1868 < 1f) {
                    phi_2420_ = _e1868;
                } else {
                    phi_2420_ = 1f;
                }
                let _e2085 = phi_2420_;
                phi_2421_ = _e2085;
            } else {
                phi_2421_ = 0f;
            }
            let _e2087 = phi_2421_;
            let _e2090 = ((sqrt(_e2073) * 255f) + 0.5f);
            let _e2099 = ((sqrt(_e2080) * 255f) + 0.5f);
            let _e2111 = ((sqrt(_e2087) * 255f) + 0.5f);
            phi_2456_ = abi_Sample(vec3<f32>(_e1650, _e1651, _e1652), _e1870, _e1763, _e1875, _e2067, ((select(select(u32(_e2090), 0u, (_e2090 < bitcast<f32>(0u))), 4294967295u, (_e2090 > bitcast<f32>(1333788671u))) | (select(select(u32(_e2099), 0u, (_e2099 < bitcast<f32>(0u))), 4294967295u, (_e2099 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e2111), 0u, (_e2111 < bitcast<f32>(0u))), 4294967295u, (_e2111 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_2456_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e2125 = phi_2456_;
        if (_e84.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e84.first_primitive)] = _e2125;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
