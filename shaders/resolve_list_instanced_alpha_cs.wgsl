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

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
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

struct type_32 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_36 {
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
    pad: vec2<u32>,
}

struct type_40 {
    member: array<abi_Material>,
}

struct texture_TexelQuad {
    indices: array<u32, 4>,
    weights: vec4<f32>,
}

struct texture_Axis {
    low: u32,
    high: u32,
    fraction: f32,
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

struct type_60 {
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

struct type_66 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(6) 
var<storage> instances: type_51;
@group(0) @binding(0) 
var<uniform> p: type_66;
@group(0) @binding(2) 
var<storage> nodes: type_60;
@group(0) @binding(3) 
var<storage> triangles: type_32;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(7) 
var<storage> vertices: type_36;
@group(0) @binding(8) 
var<storage> materials: type_40;
@group(0) @binding(9) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_236_: f32;
    var phi_241_: f32;
    var phi_242_: bool;
    var phi_243_: f32;
    var phi_244_: bool;
    var phi_248_: f32;
    var phi_274_: f32;
    var phi_279_: f32;
    var phi_280_: bool;
    var phi_281_: f32;
    var phi_282_: bool;
    var phi_286_: f32;
    var phi_294_: f32;
    var phi_295_: f32;
    var phi_296_: f32;
    var phi_305_: f32;
    var phi_306_: f32;
    var phi_324_: u32;
    var phi_338_: u32;
    var phi_345_: u32;
    var phi_350_: u32;
    var phi_356_: u32;
    var phi_361_: u32;
    var phi_363_: texture_Axis;
    var phi_391_: f32;
    var phi_396_: f32;
    var phi_397_: bool;
    var phi_398_: f32;
    var phi_399_: bool;
    var phi_403_: f32;
    var phi_429_: f32;
    var phi_434_: f32;
    var phi_435_: bool;
    var phi_436_: f32;
    var phi_437_: bool;
    var phi_441_: f32;
    var phi_449_: f32;
    var phi_450_: f32;
    var phi_451_: f32;
    var phi_460_: f32;
    var phi_461_: f32;
    var phi_479_: u32;
    var phi_493_: u32;
    var phi_500_: u32;
    var phi_505_: u32;
    var phi_511_: u32;
    var phi_516_: u32;
    var phi_518_: texture_Axis;

    let _e70 = (*param).size;
    let _e71 = (_e70 & 65535u);
    let _e73 = (*param).size;
    let _e75 = (_e73 >> bitcast<u32>(16i));
    let _e77 = (*param).flags;
    let _e79 = ((_e77 & 4u) != 0u);
    let _e81 = (*param).flags;
    let _e84 = ((_e81 >> bitcast<u32>(4u)) & 3u);
    if (_e84 == 0u) {
        if (param_1 > -8388608f) {
            let _e97 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e97 > param_1) {
                phi_236_ = 1f;
            } else {
                phi_236_ = 0f;
            }
            let _e100 = phi_236_;
            if (param_1 < 8388608f) {
                phi_241_ = (_e97 - _e100);
                phi_242_ = false;
            } else {
                phi_241_ = f32();
                phi_242_ = true;
            }
            let _e103 = phi_241_;
            let _e105 = phi_242_;
            phi_243_ = _e103;
            phi_244_ = _e105;
        } else {
            phi_243_ = f32();
            phi_244_ = true;
        }
        let _e107 = phi_243_;
        let _e109 = phi_244_;
        if _e109 {
            phi_248_ = param_1;
        } else {
            phi_248_ = _e107;
        }
        let _e111 = phi_248_;
        phi_296_ = (param_1 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_1 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_274_ = 1f;
                } else {
                    phi_274_ = 0f;
                }
                let _e129 = phi_274_;
                if (_e114 < 8388608f) {
                    phi_279_ = (_e126 - _e129);
                    phi_280_ = false;
                } else {
                    phi_279_ = f32();
                    phi_280_ = true;
                }
                let _e132 = phi_279_;
                let _e134 = phi_280_;
                phi_281_ = _e132;
                phi_282_ = _e134;
            } else {
                phi_281_ = f32();
                phi_282_ = true;
            }
            let _e136 = phi_281_;
            let _e138 = phi_282_;
            if _e138 {
                phi_286_ = _e114;
            } else {
                phi_286_ = _e136;
            }
            let _e140 = phi_286_;
            let _e142 = (param_1 - (2f * _e140));
            if (_e142 > 1f) {
                phi_294_ = (2f - _e142);
            } else {
                phi_294_ = _e142;
            }
            let _e146 = phi_294_;
            phi_295_ = _e146;
        } else {
            phi_295_ = param_1;
        }
        let _e148 = phi_295_;
        phi_296_ = _e148;
    }
    let _e150 = phi_296_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_305_ = _e150;
        } else {
            phi_305_ = 1f;
        }
        let _e154 = phi_305_;
        phi_306_ = _e154;
    } else {
        phi_306_ = 0f;
    }
    let _e156 = phi_306_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_324_ = _e157;
        } else {
            phi_324_ = _e166;
        }
        let _e169 = phi_324_;
        phi_363_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_338_ = _e71;
        } else {
            phi_338_ = _e178;
        }
        let _e181 = phi_338_;
        if (_e84 == 0u) {
            phi_345_ = _e157;
        } else {
            phi_345_ = 0u;
        }
        let _e186 = phi_345_;
        if (_e84 == 0u) {
            phi_350_ = 0u;
        } else {
            phi_350_ = _e157;
        }
        let _e189 = phi_350_;
        if (_e181 == 0u) {
            phi_356_ = _e186;
        } else {
            phi_356_ = (_e181 - 1u);
        }
        let _e193 = phi_356_;
        if (_e181 > _e157) {
            phi_361_ = _e189;
        } else {
            phi_361_ = _e181;
        }
        let _e196 = phi_361_;
        phi_363_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_363_;
    let _e201 = (*param).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_2 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e217 > param_2) {
                phi_391_ = 1f;
            } else {
                phi_391_ = 0f;
            }
            let _e220 = phi_391_;
            if (param_2 < 8388608f) {
                phi_396_ = (_e217 - _e220);
                phi_397_ = false;
            } else {
                phi_396_ = f32();
                phi_397_ = true;
            }
            let _e223 = phi_396_;
            let _e225 = phi_397_;
            phi_398_ = _e223;
            phi_399_ = _e225;
        } else {
            phi_398_ = f32();
            phi_399_ = true;
        }
        let _e227 = phi_398_;
        let _e229 = phi_399_;
        if _e229 {
            phi_403_ = param_2;
        } else {
            phi_403_ = _e227;
        }
        let _e231 = phi_403_;
        phi_451_ = (param_2 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_2 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_429_ = 1f;
                } else {
                    phi_429_ = 0f;
                }
                let _e249 = phi_429_;
                if (_e234 < 8388608f) {
                    phi_434_ = (_e246 - _e249);
                    phi_435_ = false;
                } else {
                    phi_434_ = f32();
                    phi_435_ = true;
                }
                let _e252 = phi_434_;
                let _e254 = phi_435_;
                phi_436_ = _e252;
                phi_437_ = _e254;
            } else {
                phi_436_ = f32();
                phi_437_ = true;
            }
            let _e256 = phi_436_;
            let _e258 = phi_437_;
            if _e258 {
                phi_441_ = _e234;
            } else {
                phi_441_ = _e256;
            }
            let _e260 = phi_441_;
            let _e262 = (param_2 - (2f * _e260));
            if (_e262 > 1f) {
                phi_449_ = (2f - _e262);
            } else {
                phi_449_ = _e262;
            }
            let _e266 = phi_449_;
            phi_450_ = _e266;
        } else {
            phi_450_ = param_2;
        }
        let _e268 = phi_450_;
        phi_451_ = _e268;
    }
    let _e270 = phi_451_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_460_ = _e270;
        } else {
            phi_460_ = 1f;
        }
        let _e274 = phi_460_;
        phi_461_ = _e274;
    } else {
        phi_461_ = 0f;
    }
    let _e276 = phi_461_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_479_ = _e277;
        } else {
            phi_479_ = _e286;
        }
        let _e289 = phi_479_;
        phi_518_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_493_ = _e75;
        } else {
            phi_493_ = _e298;
        }
        let _e301 = phi_493_;
        if (_e204 == 0u) {
            phi_500_ = _e277;
        } else {
            phi_500_ = 0u;
        }
        let _e306 = phi_500_;
        if (_e204 == 0u) {
            phi_505_ = 0u;
        } else {
            phi_505_ = _e277;
        }
        let _e309 = phi_505_;
        if (_e301 == 0u) {
            phi_511_ = _e306;
        } else {
            phi_511_ = (_e301 - 1u);
        }
        let _e313 = phi_511_;
        if (_e301 > _e277) {
            phi_516_ = _e309;
        } else {
            phi_516_ = _e301;
        }
        let _e316 = phi_516_;
        phi_518_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_518_;
    let _e323 = (*param).offset;
    let _e330 = (*param).offset;
    let _e337 = (*param).offset;
    let _e344 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_577_: bool;
    var phi_581_: f32;

    if (param_3 != param_3) {
        phi_577_ = true;
    } else {
        let _e69 = (param_4 >= param_3);
        if _e69 {
        }
        phi_577_ = _e69;
    }
    let _e71 = phi_577_;
    if _e71 {
        phi_581_ = param_4;
    } else {
        phi_581_ = param_3;
    }
    let _e73 = phi_581_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_593_: bool;
    var phi_597_: f32;

    if (param_5 != param_5) {
        phi_593_ = true;
    } else {
        let _e69 = (param_6 <= param_5);
        if _e69 {
        }
        phi_593_ = _e69;
    }
    let _e71 = phi_593_;
    if _e71 {
        phi_597_ = param_6;
    } else {
        phi_597_ = param_5;
    }
    let _e73 = phi_597_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_696_: f32;
    var phi_752_: bool;
    var phi_753_: bool;
    var phi_754_: bool;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_763_: bool;
    var phi_764_: bool;
    var phi_765_: bool;
    var phi_766_: bool;
    var phi_767_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_772_: bool;
    var phi_773_: bool;
    var phi_774_: bool;
    var phi_775_: bool;
    var phi_779_: bool;
    var phi_783_: bool;
    var phi_853_: f32;
    var phi_860_: f32;
    var phi_867_: f32;
    var phi_874_: f32;
    var phi_881_: f32;
    var phi_888_: f32;
    var phi_905_: f32;
    var phi_910_: f32;
    var phi_915_: f32;
    var phi_936_: u32;
    var phi_941_: u32;
    var phi_946_: u32;
    var phi_1060_: bool;
    var phi_1061_: bool;
    var phi_1092_: u32;
    var phi_1094_: u32;
    var phi_1175_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1202_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1229_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1235_: u32;
    var phi_1238_: u32;
    var phi_1252_: u32;
    var phi_1262_: u32;
    var phi_1272_: u32;
    var phi_1290_: u32;
    var phi_1300_: u32;
    var phi_1310_: u32;
    var phi_1346_: u32;
    var phi_1359_: u32;
    var phi_1364_: u32;
    var phi_1365_: u32;
    var phi_1366_: u32;
    var phi_1236_: u32;
    var phi_1239_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1424_: u32;
    var phi_1474_: f32;
    var phi_1479_: f32;
    var phi_1484_: f32;
    var phi_1492_: f32;
    var phi_1497_: f32;
    var phi_1502_: f32;
    var phi_1646_: bool;
    var phi_1647_: bool;
    var phi_1648_: bool;
    var phi_1652_: bool;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1655_: bool;
    var phi_1656_: bool;
    var phi_1657_: bool;
    var phi_1658_: bool;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var phi_1663_: bool;
    var phi_1664_: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1667_: bool;
    var phi_1668_: bool;
    var phi_1669_: bool;
    var phi_1673_: bool;
    var phi_1677_: bool;
    var phi_1747_: f32;
    var phi_1754_: f32;
    var phi_1761_: f32;
    var phi_1768_: f32;
    var phi_1775_: f32;
    var phi_1782_: f32;
    var phi_1799_: f32;
    var phi_1804_: f32;
    var phi_1809_: f32;
    var phi_1837_: bool;
    var phi_1838_: bool;
    var phi_1846_: u32;
    var phi_1847_: u32;
    var phi_1858_: vec3<f32>;
    var phi_1859_: vec3<f32>;
    var phi_1872_: u32;
    var phi_1877_: u32;
    var phi_1882_: u32;
    var phi_1996_: bool;
    var phi_1997_: bool;
    var phi_2028_: u32;
    var phi_2030_: u32;
    var phi_2111_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2138_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2165_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2171_: u32;
    var phi_2174_: u32;
    var phi_2188_: u32;
    var phi_2198_: u32;
    var phi_2208_: u32;
    var phi_2226_: u32;
    var phi_2236_: u32;
    var phi_2246_: u32;
    var phi_2282_: u32;
    var phi_2295_: u32;
    var phi_2300_: u32;
    var phi_2301_: u32;
    var phi_2302_: u32;
    var phi_2172_: u32;
    var phi_2175_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2360_: u32;
    var phi_2405_: vec3<f32>;
    var phi_2406_: vec3<f32>;
    var phi_2435_: vec3<f32>;
    var phi_2436_: vec3<f32>;
    var phi_2465_: vec3<f32>;
    var phi_2466_: vec3<f32>;
    var phi_2484_: bool;
    var phi_2485_: bool;
    var phi_2489_: f32;
    var phi_2490_: f32;
    var phi_2491_: f32;
    var phi_2492_: f32;
    var phi_2500_: f32;
    var phi_2510_: bool;
    var phi_2511_: bool;
    var phi_2515_: f32;
    var phi_2516_: f32;
    var phi_2517_: f32;
    var phi_2518_: f32;
    var phi_2526_: f32;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var phi_2541_: f32;
    var phi_2542_: f32;
    var phi_2543_: f32;
    var phi_2544_: f32;
    var phi_2552_: f32;
    var phi_2567_: f32;
    var phi_2568_: bool;
    var phi_2569_: f32;
    var phi_2570_: bool;
    var phi_2571_: f32;
    var phi_2572_: bool;
    var phi_2590_: f32;
    var phi_2591_: bool;
    var phi_2592_: bool;
    var phi_2593_: f32;
    var phi_2594_: bool;
    var phi_2595_: bool;
    var phi_2599_: bool;
    var phi_2600_: f32;
    var phi_2601_: bool;
    var phi_2629_: vec3<f32>;
    var phi_2630_: vec3<f32>;
    var phi_2655_: vec3<f32>;
    var phi_2656_: vec3<f32>;
    var phi_2681_: vec3<f32>;
    var phi_2682_: vec3<f32>;
    var phi_2738_: f32;
    var phi_2747_: f32;
    var phi_2756_: f32;
    var phi_2765_: f32;
    var phi_2772_: f32;
    var phi_2779_: f32;
    var phi_2792_: f32;
    var phi_2801_: f32;
    var phi_2810_: f32;
    var phi_2819_: f32;
    var phi_2826_: f32;
    var phi_2833_: f32;
    var phi_2850_: f32;
    var phi_2855_: f32;
    var phi_2860_: f32;
    var phi_2868_: f32;
    var phi_2873_: f32;
    var phi_2878_: f32;
    var phi_2890_: f32;
    var phi_2895_: f32;
    var phi_2900_: f32;
    var phi_2905_: f32;
    var phi_2910_: lt_bvh_triangle_Intersection;
    var phi_2911_: bool;
    var phi_2912_: lt_bvh_triangle_Intersection;
    var phi_2913_: bool;
    var phi_2917_: lt_bvh_triangle_Intersection;
    var phi_2918_: bool;
    var phi_2919_: lt_bvh_triangle_Intersection;
    var phi_2920_: bool;
    var phi_2921_: bool;
    var phi_2925_: bool;
    var phi_2929_: lt_bvh_triangle_Intersection;
    var phi_3143_: f32;
    var phi_3146_: bool;
    var phi_3147_: bool;
    var phi_3151_: bool;
    var phi_3152_: bool;
    var phi_3153_: bool;
    var phi_3154_: bool;
    var phi_3155_: bool;
    var phi_3156_: bool;
    var phi_3157_: bool;
    var phi_3158_: bool;
    var phi_3159_: bool;
    var phi_3160_: bool;
    var phi_3161_: bool;
    var phi_3162_: bool;
    var phi_3166_: bool;
    var phi_3167_: bool;
    var phi_2361_: u32;
    var phi_3168_: bool;
    var phi_3169_: bool;
    var phi_3170_: bool;
    var local_9: bool;
    var phi_3212_: bool;
    var phi_3213_: bool;
    var phi_3244_: u32;
    var phi_3245_: u32;
    var phi_3246_: bool;
    var phi_3247_: bool;
    var phi_2031_: u32;
    var phi_3248_: bool;
    var phi_3249_: bool;
    var phi_3250_: bool;
    var phi_3251_: bool;
    var local_10: bool;
    var phi_3255_: bool;
    var phi_3256_: bool;
    var phi_3260_: bool;
    var phi_3264_: bool;
    var phi_3265_: bool;
    var phi_3266_: bool;
    var phi_3267_: bool;
    var phi_3271_: bool;
    var phi_3275_: bool;
    var phi_3276_: bool;
    var phi_3277_: bool;
    var phi_3278_: bool;
    var phi_1425_: u32;
    var phi_3282_: bool;
    var local_11: bool;
    var phi_3324_: bool;
    var phi_3325_: bool;
    var phi_3356_: u32;
    var phi_3357_: u32;
    var phi_1095_: u32;
    var phi_3358_: bool;
    var phi_3359_: bool;
    var local_12: bool;
    var phi_3363_: bool;
    var phi_3367_: bool;
    var phi_3368_: bool;
    var phi_3369_: bool;
    var phi_3370_: bool;
    var phi_3374_: bool;
    var phi_3378_: f32;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;

    let _e69 = id_1;
    let _e76 = arrayLength((&nodes.member));
    let _e79 = arrayLength((&triangles.member));
    let _e85 = arrayLength((&list.member));
    let _e91 = arrayLength((&vertices.member));
    let _e97 = arrayLength((&alpha_texels.member));
    let _e101 = ((_e69.y * 2097152u) + _e69.x);
    if (3u < _e85) {
    } else {
        return;
    }
    let _e104 = list.member[3u];
    if (_e101 < _e104) {
        let _e106 = (_e101 + 4u);
        if (_e106 < _e85) {
        } else {
            return;
        }
        let _e110 = list.member[(0u + _e106)];
        let _e112 = p.member.root;
        if (_e110 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e118 = samples.member[(0u + _e110)].position;
        let _e120 = samples.member[(0u + _e110)].normal;
        let _e122 = samples.member[(0u + _e110)].magnitude;
        let _e124 = ((8f / 8388608f) * _e122);
        let _e132 = (_e118.x + (_e120.x * _e124));
        let _e134 = (_e118.y + (_e120.y * _e124));
        let _e136 = (_e118.z + (_e120.z * _e124));
        let _e138 = p.member.light.place;
        if (_e138.w == 0f) {
            phi_696_ = 300000000000000000000000000000000000000f;
        } else {
            phi_696_ = 1f;
        }
        let _e142 = phi_696_;
        let _e150 = (_e138.x - (_e132 * _e138.w));
        let _e151 = (_e138.y - (_e134 * _e138.w));
        let _e152 = (_e138.z - (_e136 * _e138.w));
        let _e156 = abs(_e150);
        let _e157 = abs(_e151);
        let _e158 = abs(_e152);
        if (abs(_e132) < 1000000000000000f) {
            if (abs(_e134) < 1000000000000000f) {
                if (abs(_e136) < 1000000000000000f) {
                    if (_e156 < 1000000000000000f) {
                        if (_e157 < 1000000000000000f) {
                            if (_e158 < 1000000000000000f) {
                                if (_e156 > 0f) {
                                    phi_753_ = bool();
                                    phi_754_ = true;
                                } else {
                                    let _e166 = (_e157 > 0f);
                                    if _e166 {
                                        phi_752_ = bool();
                                    } else {
                                        phi_752_ = (_e158 > 0f);
                                    }
                                    let _e169 = phi_752_;
                                    phi_753_ = _e169;
                                    phi_754_ = _e166;
                                }
                                let _e171 = phi_753_;
                                let _e173 = phi_754_;
                                if _e173 {
                                    phi_758_ = true;
                                } else {
                                    phi_758_ = _e171;
                                }
                                let _e175 = phi_758_;
                                phi_759_ = _e175;
                                phi_760_ = false;
                            } else {
                                phi_759_ = bool();
                                phi_760_ = true;
                            }
                            let _e177 = phi_759_;
                            let _e179 = phi_760_;
                            phi_761_ = _e177;
                            phi_762_ = false;
                            phi_763_ = _e179;
                        } else {
                            phi_761_ = bool();
                            phi_762_ = true;
                            phi_763_ = false;
                        }
                        let _e181 = phi_761_;
                        let _e183 = phi_762_;
                        let _e185 = phi_763_;
                        phi_764_ = _e181;
                        phi_765_ = _e183;
                        phi_766_ = _e185;
                    } else {
                        phi_764_ = bool();
                        phi_765_ = true;
                        phi_766_ = false;
                    }
                    let _e187 = phi_764_;
                    let _e189 = phi_765_;
                    let _e191 = phi_766_;
                    phi_767_ = _e187;
                    phi_768_ = _e189;
                    phi_769_ = _e191;
                } else {
                    phi_767_ = bool();
                    phi_768_ = true;
                    phi_769_ = false;
                }
                let _e193 = phi_767_;
                let _e195 = phi_768_;
                let _e197 = phi_769_;
                phi_770_ = _e193;
                phi_771_ = _e195;
                phi_772_ = _e197;
            } else {
                phi_770_ = bool();
                phi_771_ = true;
                phi_772_ = false;
            }
            let _e199 = phi_770_;
            let _e201 = phi_771_;
            let _e203 = phi_772_;
            phi_773_ = _e199;
            phi_774_ = _e201;
            phi_775_ = _e203;
        } else {
            phi_773_ = bool();
            phi_774_ = true;
            phi_775_ = false;
        }
        let _e205 = phi_773_;
        let _e207 = phi_774_;
        let _e209 = phi_775_;
        if _e207 {
            phi_779_ = true;
        } else {
            phi_779_ = _e209;
        }
        let _e211 = phi_779_;
        if _e211 {
            phi_783_ = false;
        } else {
            phi_783_ = _e205;
        }
        let _e213 = phi_783_;
        if _e213 {
            let _e214 = (_e112 >= _e76);
            if _e214 {
                phi_3368_ = bool();
            } else {
                if (_e112 < _e76) {
                } else {
                    return;
                }
                let _e220 = nodes.member[(0u + _e112)].frame[0u];
                let _e224 = nodes.member[(0u + _e112)].frame[1u];
                let _e228 = nodes.member[(0u + _e112)].frame[2u];
                let _e232 = nodes.member[(0u + _e112)].frame[0u];
                let _e236 = nodes.member[(0u + _e112)].frame[1u];
                let _e240 = nodes.member[(0u + _e112)].frame[2u];
                let _e244 = nodes.member[(0u + _e112)].frame[3u];
                let _e278 = core_intrinsics_maximum_number_nsz_f32_(abs(_e150), abs(_e151));
                let _e279 = core_intrinsics_maximum_number_nsz_f32_(_e278, abs(_e152));
                let _e280 = (_e279 * 0.0000000000009094947f);
                if (abs(_e150) < _e280) {
                    phi_853_ = _e280;
                } else {
                    phi_853_ = abs(_e150);
                }
                let _e285 = phi_853_;
                if (_e150 < 0f) {
                    phi_860_ = (-1f / _e285);
                } else {
                    phi_860_ = (1f / _e285);
                }
                let _e290 = phi_860_;
                if (abs(_e151) < _e280) {
                    phi_867_ = _e280;
                } else {
                    phi_867_ = abs(_e151);
                }
                let _e295 = phi_867_;
                if (_e151 < 0f) {
                    phi_874_ = (-1f / _e295);
                } else {
                    phi_874_ = (1f / _e295);
                }
                let _e300 = phi_874_;
                if (abs(_e152) < _e280) {
                    phi_881_ = _e280;
                } else {
                    phi_881_ = abs(_e152);
                }
                let _e305 = phi_881_;
                if (_e152 < 0f) {
                    phi_888_ = (-1f / _e305);
                } else {
                    phi_888_ = (1f / _e305);
                }
                let _e310 = phi_888_;
                let _e314 = abs((bitcast<f32>(_e220) - _e132));
                let _e315 = abs((bitcast<f32>(_e224) - _e134));
                let _e316 = abs((bitcast<f32>(_e228) - _e136));
                let _e320 = abs(((bitcast<f32>(_e232) + (bitcast<f32>((((_e244 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e132));
                let _e321 = abs(((bitcast<f32>(_e236) + (bitcast<f32>((((_e244 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e134));
                let _e322 = abs(((bitcast<f32>(_e240) + (bitcast<f32>((((_e244 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e136));
                if (_e314 > _e320) {
                    phi_905_ = _e314;
                } else {
                    phi_905_ = _e320;
                }
                let _e325 = phi_905_;
                if (_e315 > _e321) {
                    phi_910_ = _e315;
                } else {
                    phi_910_ = _e321;
                }
                let _e328 = phi_910_;
                if (_e316 > _e322) {
                    phi_915_ = _e316;
                } else {
                    phi_915_ = _e322;
                }
                let _e331 = phi_915_;
                let _e332 = core_intrinsics_maximum_number_nsz_f32_(_e325, _e328);
                let _e333 = core_intrinsics_maximum_number_nsz_f32_(_e332, _e331);
                let _e337 = (_e333 * 0.0000019073486f);
                let _e338 = (abs(_e290) * _e337);
                let _e339 = (abs(_e300) * _e337);
                let _e340 = (abs(_e310) * _e337);
                let _e344 = (_e333 * 0.0000009536743f);
                let _e345 = (abs(_e290) * _e344);
                let _e346 = (abs(_e300) * _e344);
                let _e347 = (abs(_e310) * _e344);
                if (_e290 < 0f) {
                    phi_936_ = 0u;
                } else {
                    phi_936_ = 1u;
                }
                let _e350 = phi_936_;
                if (_e300 < 0f) {
                    phi_941_ = 0u;
                } else {
                    phi_941_ = 2u;
                }
                let _e353 = phi_941_;
                if (_e310 < 0f) {
                    phi_946_ = 0u;
                } else {
                    phi_946_ = 4u;
                }
                let _e356 = phi_946_;
                let _e358 = ((_e350 | _e353) | _e356);
                let _e359 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e112, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e359.first[0], _e359.first[1], _e359.first[2], _e359.first[3], _e359.first[4], _e359.first[5], _e359.first[6], _e359.first[7], _e359.first[8], _e359.first[9], _e359.first[10], _e359.first[11], _e359.first[12], _e359.first[13], _e359.first[14], _e359.first[15], _e359.first[16], _e359.first[17], _e359.first[18], _e359.first[19], _e359.first[20], _e359.first[21], _e359.first[22], _e359.first[23], _e359.first[24], _e359.first[25], _e359.first[26], _e359.first[27], _e359.first[28], _e359.first[29], _e359.first[30], _e359.first[31]), array<u32, 32>(_e359.mask[0], _e359.mask[1], _e359.mask[2], _e359.mask[3], _e359.mask[4], _e359.mask[5], _e359.mask[6], _e359.mask[7], _e359.mask[8], _e359.mask[9], _e359.mask[10], _e359.mask[11], _e359.mask[12], _e359.mask[13], _e359.mask[14], _e359.mask[15], _e359.mask[16], _e359.mask[17], _e359.mask[18], _e359.mask[19], _e359.mask[20], _e359.mask[21], _e359.mask[22], _e359.mask[23], _e359.mask[24], _e359.mask[25], _e359.mask[26], _e359.mask[27], _e359.mask[28], _e359.mask[29], _e359.mask[30], _e359.mask[31]), _e359.len, _e359.group, _e359.group_mask);
                let _e433 = local_2.group_mask;
                if ((_e433 & 4278190080u) == 0u) {
                    let _e437 = local_2.len;
                    if (_e437 == 0u) {
                        phi_1060_ = false;
                    } else {
                        let _e441 = local_2.len;
                        local_2.len = (_e441 - 1u);
                        let _e444 = local_2.len;
                        if (_e444 < 32u) {
                        } else {
                            return;
                        }
                        let _e449 = local_2.first[(0u + _e444)];
                        local_2.group = _e449;
                        let _e452 = local_2.len;
                        if (_e452 < 32u) {
                        } else {
                            return;
                        }
                        let _e457 = local_2.mask[(0u + _e452)];
                        local_2.group_mask = _e457;
                        phi_1060_ = true;
                    }
                    let _e460 = phi_1060_;
                    phi_1061_ = _e460;
                } else {
                    phi_1061_ = true;
                }
                let _e462 = phi_1061_;
                if _e462 {
                    let _e464 = local_2.group_mask;
                    let _e470 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e464)), 32u, (_e464 == 0u)));
                    let _e474 = local_2.group_mask;
                    let _e488 = local_2.group_mask;
                    local_2.group_mask = (_e488 & ~((1u << bitcast<u32>((_e470 & 31u)))));
                    let _e491 = local_2.group;
                    phi_1092_ = (_e491 + countOneBits(((_e474 & ~((4294967295u << bitcast<u32>((((_e470 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1092_ = 4294967295u;
                }
                let _e494 = phi_1092_;
                phi_1094_ = _e494;
                loop {
                    let _e496 = phi_1094_;
                    if (_e496 != 4294967295u) {
                        if (_e496 < _e76) {
                        } else {
                            return;
                        }
                        let _e503 = nodes.member[(0u + _e496)].frame[3u];
                        let _e528 = (bitcast<f32>((((_e503 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e290);
                        let _e529 = (bitcast<f32>((((_e503 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e300);
                        let _e530 = (bitcast<f32>((((_e503 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e310);
                        let _e533 = nodes.member[(0u + _e496)].frame[0u];
                        let _e537 = nodes.member[(0u + _e496)].frame[1u];
                        let _e541 = nodes.member[(0u + _e496)].frame[2u];
                        let _e546 = ((bitcast<f32>(_e533) - _e132) * _e290);
                        let _e547 = ((bitcast<f32>(_e537) - _e134) * _e300);
                        let _e548 = ((bitcast<f32>(_e541) - _e136) * _e310);
                        let _e556 = nodes.member[(0u + _e496)].x;
                        if (_e290 < 0f) {
                            let _e567 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e556.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e573 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e567.unnamed.root, _e556.w), _e567.unnamed_1);
                            let _e579 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e573.unnamed, lt_bvh_traverse_Tree(_e556.x, _e573.unnamed_1.first_primitive));
                            phi_1175_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e579.unnamed, lt_bvh_traverse_Tree(_e579.unnamed_1.root, _e556.y));
                        } else {
                            let _e595 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e556.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e601 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e595.unnamed.root, _e556.y), _e595.unnamed_1);
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e601.unnamed, lt_bvh_traverse_Tree(_e556.z, _e601.unnamed_1.first_primitive));
                            phi_1175_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e607.unnamed, lt_bvh_traverse_Tree(_e607.unnamed_1.root, _e556.w));
                        }
                        let _e615 = phi_1175_;
                        let _e625 = nodes.member[(0u + _e496)].y;
                        if (_e300 < 0f) {
                            let _e636 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e625.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e642 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e636.unnamed.root, _e625.w), _e636.unnamed_1);
                            let _e648 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e642.unnamed, lt_bvh_traverse_Tree(_e625.x, _e642.unnamed_1.first_primitive));
                            phi_1202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e648.unnamed, lt_bvh_traverse_Tree(_e648.unnamed_1.root, _e625.y));
                        } else {
                            let _e664 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e625.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e670 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e664.unnamed.root, _e625.y), _e664.unnamed_1);
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e670.unnamed, lt_bvh_traverse_Tree(_e625.z, _e670.unnamed_1.first_primitive));
                            phi_1202_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e676.unnamed, lt_bvh_traverse_Tree(_e676.unnamed_1.root, _e625.w));
                        }
                        let _e684 = phi_1202_;
                        let _e694 = nodes.member[(0u + _e496)].z;
                        if (_e310 < 0f) {
                            let _e705 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e694.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e711 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e705.unnamed.root, _e694.w), _e705.unnamed_1);
                            let _e717 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e711.unnamed, lt_bvh_traverse_Tree(_e694.x, _e711.unnamed_1.first_primitive));
                            phi_1229_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e717.unnamed, lt_bvh_traverse_Tree(_e717.unnamed_1.root, _e694.y));
                        } else {
                            let _e733 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e694.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e739 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e733.unnamed.root, _e694.y), _e733.unnamed_1);
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e739.unnamed, lt_bvh_traverse_Tree(_e694.z, _e739.unnamed_1.first_primitive));
                            phi_1229_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e745.unnamed, lt_bvh_traverse_Tree(_e745.unnamed_1.root, _e694.w));
                        }
                        let _e753 = phi_1229_;
                        phi_1235_ = 0u;
                        phi_1238_ = 0u;
                        loop {
                            let _e763 = phi_1235_;
                            let _e765 = phi_1238_;
                            local_3 = _e765;
                            local_4 = _e765;
                            local_5 = _e765;
                            let _e766 = (_e763 < 8u);
                            if _e766 {
                                let _e768 = (_e763 >> bitcast<u32>(2i));
                                let _e769 = (_e763 & 3u);
                                if (_e768 == 0u) {
                                    phi_1252_ = _e615.unnamed.root;
                                } else {
                                    phi_1252_ = _e615.unnamed.first_primitive;
                                }
                                let _e772 = phi_1252_;
                                if (_e768 == 0u) {
                                    phi_1262_ = _e684.unnamed.root;
                                } else {
                                    phi_1262_ = _e684.unnamed.first_primitive;
                                }
                                let _e781 = phi_1262_;
                                if (_e768 == 0u) {
                                    phi_1272_ = _e753.unnamed.root;
                                } else {
                                    phi_1272_ = _e753.unnamed.first_primitive;
                                }
                                let _e790 = phi_1272_;
                                let _e803 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e772 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e528) + (_e546 - _e338)), ((f32(((_e781 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e529) + (_e547 - _e339)));
                                let _e804 = core_intrinsics_maximum_number_nsz_f32_(_e803, ((f32(((_e790 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e530) + (_e548 - _e340)));
                                if (_e768 == 0u) {
                                    phi_1290_ = _e615.unnamed_1.root;
                                } else {
                                    phi_1290_ = _e615.unnamed_1.first_primitive;
                                }
                                let _e807 = phi_1290_;
                                if (_e768 == 0u) {
                                    phi_1300_ = _e684.unnamed_1.root;
                                } else {
                                    phi_1300_ = _e684.unnamed_1.first_primitive;
                                }
                                let _e816 = phi_1300_;
                                if (_e768 == 0u) {
                                    phi_1310_ = _e753.unnamed_1.root;
                                } else {
                                    phi_1310_ = _e753.unnamed_1.first_primitive;
                                }
                                let _e825 = phi_1310_;
                                let _e838 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e807 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e528) + (_e546 + _e338)), ((f32(((_e816 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e529) + (_e547 + _e339)));
                                let _e839 = core_intrinsics_minimum_number_nsz_f32_(_e838, ((f32(((_e825 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u)) * _e530) + (_e548 + _e340)));
                                if (_e804 <= _e839) {
                                    if (_e804 <= _e142) {
                                        if (_e839 >= 0f) {
                                            if (_e768 == 0u) {
                                                let _e846 = nodes.member[(0u + _e496)].links[2u];
                                                phi_1346_ = _e846;
                                            } else {
                                                let _e849 = nodes.member[(0u + _e496)].links[3u];
                                                phi_1346_ = _e849;
                                            }
                                            let _e851 = phi_1346_;
                                            let _e856 = ((_e851 >> bitcast<u32>(((_e769 * 8u) & 31u))) & 255u);
                                            let _e857 = (_e856 & 31u);
                                            if (_e857 >= 24u) {
                                                phi_1359_ = (24u + ((_e857 - 24u) ^ _e358));
                                            } else {
                                                phi_1359_ = _e857;
                                            }
                                            let _e863 = phi_1359_;
                                            phi_1364_ = (_e765 | ((_e856 >> bitcast<u32>(5i)) << bitcast<u32>((_e863 & 31u))));
                                        } else {
                                            phi_1364_ = _e765;
                                        }
                                        let _e871 = phi_1364_;
                                        phi_1365_ = _e871;
                                    } else {
                                        phi_1365_ = _e765;
                                    }
                                    let _e873 = phi_1365_;
                                    phi_1366_ = _e873;
                                } else {
                                    phi_1366_ = _e765;
                                }
                                let _e875 = phi_1366_;
                                phi_1236_ = (_e763 + 1u);
                                phi_1239_ = _e875;
                            } else {
                                phi_1236_ = u32();
                                phi_1239_ = u32();
                            }
                            let _e878 = phi_1236_;
                            let _e880 = phi_1239_;
                            continue;
                            continuing {
                                phi_1235_ = _e878;
                                phi_1238_ = _e880;
                                break if !(_e766);
                            }
                        }
                        let _e884 = nodes.member[(0u + _e496)].links[0u];
                        let _e888 = nodes.member[(0u + _e496)].frame[3u];
                        let _e892 = local_3;
                        if ((_e892 & 4278190080u) == 0u) {
                        } else {
                            let _e896 = local_2.group_mask;
                            if ((_e896 & 4278190080u) == 0u) {
                            } else {
                                let _e900 = local_2.len;
                                if (_e900 < 32u) {
                                    let _e903 = local_2.group;
                                    let _e905 = local_2.len;
                                    if (_e905 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e905)] = _e903;
                                    let _e911 = local_2.group_mask;
                                    let _e913 = local_2.len;
                                    if (_e913 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e913)] = _e911;
                                    let _e920 = local_2.len;
                                    local_2.len = (_e920 + 1u);
                                }
                            }
                            local_2.group = (_e112 + _e884);
                            let _e924 = local_4;
                            local_2.group_mask = ((_e924 & 4278190080u) | (_e888 >> bitcast<u32>(24i)));
                        }
                        let _e929 = local_5;
                        phi_1424_ = (_e929 & 16777215u);
                        loop {
                            let _e932 = phi_1424_;
                            let _e933 = (_e932 == 0u);
                            local_11 = _e933;
                            local_18 = _e933;
                            if _e933 {
                                phi_1425_ = u32();
                                phi_3282_ = false;
                            } else {
                                let _e936 = nodes.member[(0u + _e496)].links[1u];
                                let _e940 = (_e936 + select(firstTrailingBit(_e932), 32u, (_e932 == 0u)));
                                if (_e940 < arrayLength((&instances.member))) {
                                } else {
                                    return;
                                }
                                let _e947 = instances.member[(0u + _e940)].low_world;
                                let _e949 = instances.member[(0u + _e940)].high_world;
                                let _e956 = ((_e947.x - _e132) * _e290);
                                let _e957 = ((_e947.y - _e134) * _e300);
                                let _e958 = ((_e947.z - _e136) * _e310);
                                let _e965 = ((_e949.x - _e132) * _e290);
                                let _e966 = ((_e949.y - _e134) * _e300);
                                let _e967 = ((_e949.z - _e136) * _e310);
                                if (_e956 < _e965) {
                                    phi_1474_ = _e956;
                                } else {
                                    phi_1474_ = _e965;
                                }
                                let _e970 = phi_1474_;
                                if (_e957 < _e966) {
                                    phi_1479_ = _e957;
                                } else {
                                    phi_1479_ = _e966;
                                }
                                let _e973 = phi_1479_;
                                if (_e958 < _e967) {
                                    phi_1484_ = _e958;
                                } else {
                                    phi_1484_ = _e967;
                                }
                                let _e976 = phi_1484_;
                                if (_e956 > _e965) {
                                    phi_1492_ = _e956;
                                } else {
                                    phi_1492_ = _e965;
                                }
                                let _e982 = phi_1492_;
                                if (_e957 > _e966) {
                                    phi_1497_ = _e957;
                                } else {
                                    phi_1497_ = _e966;
                                }
                                let _e985 = phi_1497_;
                                if (_e958 > _e967) {
                                    phi_1502_ = _e958;
                                } else {
                                    phi_1502_ = _e967;
                                }
                                let _e988 = phi_1502_;
                                let _e992 = core_intrinsics_maximum_number_nsz_f32_((_e970 - _e345), (_e973 - _e346));
                                let _e993 = core_intrinsics_maximum_number_nsz_f32_(_e992, (_e976 - _e347));
                                let _e994 = core_intrinsics_minimum_number_nsz_f32_((_e982 + _e345), (_e985 + _e346));
                                let _e995 = core_intrinsics_minimum_number_nsz_f32_(_e994, (_e988 + _e347));
                                if (_e993 <= _e995) {
                                    if (_e993 <= _e142) {
                                        if (_e995 >= 0f) {
                                            let _e1001 = instances.member[(0u + _e940)].world_to_object[0u];
                                            let _e1012 = ((((_e1001.x * _e132) + (_e1001.y * _e134)) + (_e1001.z * _e136)) + (_e1001.w * 1f));
                                            let _e1014 = instances.member[(0u + _e940)].world_to_object[1u];
                                            let _e1025 = ((((_e1014.x * _e132) + (_e1014.y * _e134)) + (_e1014.z * _e136)) + (_e1014.w * 1f));
                                            let _e1027 = instances.member[(0u + _e940)].world_to_object[2u];
                                            let _e1038 = ((((_e1027.x * _e132) + (_e1027.y * _e134)) + (_e1027.z * _e136)) + (_e1027.w * 1f));
                                            let _e1041 = instances.member[(0u + _e940)].world_to_object[0u];
                                            let _e1052 = ((((_e1041.x * _e150) + (_e1041.y * _e151)) + (_e1041.z * _e152)) + (_e1041.w * 0f));
                                            let _e1054 = instances.member[(0u + _e940)].world_to_object[1u];
                                            let _e1065 = ((((_e1054.x * _e150) + (_e1054.y * _e151)) + (_e1054.z * _e152)) + (_e1054.w * 0f));
                                            let _e1067 = instances.member[(0u + _e940)].world_to_object[2u];
                                            let _e1078 = ((((_e1067.x * _e150) + (_e1067.y * _e151)) + (_e1067.z * _e152)) + (_e1067.w * 0f));
                                            let _e1081 = instances.member[(0u + _e940)].root;
                                            let _e1083 = instances.member[(0u + _e940)].first_triangle;
                                            let _e1087 = abs(_e1052);
                                            let _e1088 = abs(_e1065);
                                            let _e1089 = abs(_e1078);
                                            if (abs(_e1012) < 1000000000000000f) {
                                                if (abs(_e1025) < 1000000000000000f) {
                                                    if (abs(_e1038) < 1000000000000000f) {
                                                        if (_e1087 < 1000000000000000f) {
                                                            if (_e1088 < 1000000000000000f) {
                                                                if (_e1089 < 1000000000000000f) {
                                                                    if (_e1087 > 0f) {
                                                                        phi_1647_ = bool();
                                                                        phi_1648_ = true;
                                                                    } else {
                                                                        let _e1097 = (_e1088 > 0f);
                                                                        if _e1097 {
                                                                            phi_1646_ = bool();
                                                                        } else {
                                                                            phi_1646_ = (_e1089 > 0f);
                                                                        }
                                                                        let _e1100 = phi_1646_;
                                                                        phi_1647_ = _e1100;
                                                                        phi_1648_ = _e1097;
                                                                    }
                                                                    let _e1102 = phi_1647_;
                                                                    let _e1104 = phi_1648_;
                                                                    if _e1104 {
                                                                        phi_1652_ = true;
                                                                    } else {
                                                                        phi_1652_ = _e1102;
                                                                    }
                                                                    let _e1106 = phi_1652_;
                                                                    phi_1653_ = _e1106;
                                                                    phi_1654_ = false;
                                                                } else {
                                                                    phi_1653_ = bool();
                                                                    phi_1654_ = true;
                                                                }
                                                                let _e1108 = phi_1653_;
                                                                let _e1110 = phi_1654_;
                                                                phi_1655_ = _e1108;
                                                                phi_1656_ = false;
                                                                phi_1657_ = _e1110;
                                                            } else {
                                                                phi_1655_ = bool();
                                                                phi_1656_ = true;
                                                                phi_1657_ = false;
                                                            }
                                                            let _e1112 = phi_1655_;
                                                            let _e1114 = phi_1656_;
                                                            let _e1116 = phi_1657_;
                                                            phi_1658_ = _e1112;
                                                            phi_1659_ = _e1114;
                                                            phi_1660_ = _e1116;
                                                        } else {
                                                            phi_1658_ = bool();
                                                            phi_1659_ = true;
                                                            phi_1660_ = false;
                                                        }
                                                        let _e1118 = phi_1658_;
                                                        let _e1120 = phi_1659_;
                                                        let _e1122 = phi_1660_;
                                                        phi_1661_ = _e1118;
                                                        phi_1662_ = _e1120;
                                                        phi_1663_ = _e1122;
                                                    } else {
                                                        phi_1661_ = bool();
                                                        phi_1662_ = true;
                                                        phi_1663_ = false;
                                                    }
                                                    let _e1124 = phi_1661_;
                                                    let _e1126 = phi_1662_;
                                                    let _e1128 = phi_1663_;
                                                    phi_1664_ = _e1124;
                                                    phi_1665_ = _e1126;
                                                    phi_1666_ = _e1128;
                                                } else {
                                                    phi_1664_ = bool();
                                                    phi_1665_ = true;
                                                    phi_1666_ = false;
                                                }
                                                let _e1130 = phi_1664_;
                                                let _e1132 = phi_1665_;
                                                let _e1134 = phi_1666_;
                                                phi_1667_ = _e1130;
                                                phi_1668_ = _e1132;
                                                phi_1669_ = _e1134;
                                            } else {
                                                phi_1667_ = bool();
                                                phi_1668_ = true;
                                                phi_1669_ = false;
                                            }
                                            let _e1136 = phi_1667_;
                                            let _e1138 = phi_1668_;
                                            let _e1140 = phi_1669_;
                                            if _e1138 {
                                                phi_1673_ = true;
                                            } else {
                                                phi_1673_ = _e1140;
                                            }
                                            let _e1142 = phi_1673_;
                                            if _e1142 {
                                                phi_1677_ = false;
                                            } else {
                                                phi_1677_ = _e1136;
                                            }
                                            let _e1144 = phi_1677_;
                                            if _e1144 {
                                                let _e1145 = (_e1081 >= _e76);
                                                if _e1145 {
                                                    phi_3265_ = bool();
                                                } else {
                                                    if (_e1081 < _e76) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1151 = nodes.member[(0u + _e1081)].frame[0u];
                                                    let _e1155 = nodes.member[(0u + _e1081)].frame[1u];
                                                    let _e1159 = nodes.member[(0u + _e1081)].frame[2u];
                                                    let _e1163 = nodes.member[(0u + _e1081)].frame[0u];
                                                    let _e1167 = nodes.member[(0u + _e1081)].frame[1u];
                                                    let _e1171 = nodes.member[(0u + _e1081)].frame[2u];
                                                    let _e1175 = nodes.member[(0u + _e1081)].frame[3u];
                                                    let _e1209 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1052), abs(_e1065));
                                                    let _e1210 = core_intrinsics_maximum_number_nsz_f32_(_e1209, abs(_e1078));
                                                    let _e1211 = (_e1210 * 0.0000000000009094947f);
                                                    if (abs(_e1052) < _e1211) {
                                                        phi_1747_ = _e1211;
                                                    } else {
                                                        phi_1747_ = abs(_e1052);
                                                    }
                                                    let _e1216 = phi_1747_;
                                                    if (_e1052 < 0f) {
                                                        phi_1754_ = (-1f / _e1216);
                                                    } else {
                                                        phi_1754_ = (1f / _e1216);
                                                    }
                                                    let _e1221 = phi_1754_;
                                                    if (abs(_e1065) < _e1211) {
                                                        phi_1761_ = _e1211;
                                                    } else {
                                                        phi_1761_ = abs(_e1065);
                                                    }
                                                    let _e1226 = phi_1761_;
                                                    if (_e1065 < 0f) {
                                                        phi_1768_ = (-1f / _e1226);
                                                    } else {
                                                        phi_1768_ = (1f / _e1226);
                                                    }
                                                    let _e1231 = phi_1768_;
                                                    if (abs(_e1078) < _e1211) {
                                                        phi_1775_ = _e1211;
                                                    } else {
                                                        phi_1775_ = abs(_e1078);
                                                    }
                                                    let _e1236 = phi_1775_;
                                                    if (_e1078 < 0f) {
                                                        phi_1782_ = (-1f / _e1236);
                                                    } else {
                                                        phi_1782_ = (1f / _e1236);
                                                    }
                                                    let _e1241 = phi_1782_;
                                                    let _e1245 = abs((bitcast<f32>(_e1151) - _e1012));
                                                    let _e1246 = abs((bitcast<f32>(_e1155) - _e1025));
                                                    let _e1247 = abs((bitcast<f32>(_e1159) - _e1038));
                                                    let _e1251 = abs(((bitcast<f32>(_e1163) + (bitcast<f32>((((_e1175 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1012));
                                                    let _e1252 = abs(((bitcast<f32>(_e1167) + (bitcast<f32>((((_e1175 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1025));
                                                    let _e1253 = abs(((bitcast<f32>(_e1171) + (bitcast<f32>((((_e1175 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1038));
                                                    if (_e1245 > _e1251) {
                                                        phi_1799_ = _e1245;
                                                    } else {
                                                        phi_1799_ = _e1251;
                                                    }
                                                    let _e1256 = phi_1799_;
                                                    if (_e1246 > _e1252) {
                                                        phi_1804_ = _e1246;
                                                    } else {
                                                        phi_1804_ = _e1252;
                                                    }
                                                    let _e1259 = phi_1804_;
                                                    if (_e1247 > _e1253) {
                                                        phi_1809_ = _e1247;
                                                    } else {
                                                        phi_1809_ = _e1253;
                                                    }
                                                    let _e1262 = phi_1809_;
                                                    let _e1263 = core_intrinsics_maximum_number_nsz_f32_(_e1256, _e1259);
                                                    let _e1264 = core_intrinsics_maximum_number_nsz_f32_(_e1263, _e1262);
                                                    let _e1268 = (_e1264 * 0.0000019073486f);
                                                    let _e1269 = (abs(_e1221) * _e1268);
                                                    let _e1270 = (abs(_e1231) * _e1268);
                                                    let _e1271 = (abs(_e1241) * _e1268);
                                                    let _e1275 = (_e1264 * 0.0000009536743f);
                                                    let _e1276 = (abs(_e1221) * _e1275);
                                                    let _e1277 = (abs(_e1231) * _e1275);
                                                    let _e1278 = (abs(_e1241) * _e1275);
                                                    let _e1279 = abs(_e1052);
                                                    let _e1280 = abs(_e1065);
                                                    let _e1281 = abs(_e1078);
                                                    if (_e1279 >= _e1280) {
                                                        if (_e1279 >= _e1281) {
                                                            phi_1837_ = false;
                                                        } else {
                                                            phi_1837_ = true;
                                                        }
                                                        let _e1285 = phi_1837_;
                                                        phi_1838_ = _e1285;
                                                    } else {
                                                        phi_1838_ = true;
                                                    }
                                                    let _e1287 = phi_1838_;
                                                    if _e1287 {
                                                        if (_e1280 >= _e1281) {
                                                            phi_1846_ = 1u;
                                                        } else {
                                                            phi_1846_ = 2u;
                                                        }
                                                        let _e1290 = phi_1846_;
                                                        phi_1847_ = _e1290;
                                                    } else {
                                                        phi_1847_ = 0u;
                                                    }
                                                    let _e1292 = phi_1847_;
                                                    if (_e1292 == 0u) {
                                                        phi_1859_ = vec3<f32>(_e1065, _e1078, _e1052);
                                                    } else {
                                                        if (_e1292 == 1u) {
                                                            phi_1858_ = vec3<f32>(_e1078, _e1052, _e1065);
                                                        } else {
                                                            phi_1858_ = vec3<f32>(_e1052, _e1065, _e1078);
                                                        }
                                                        let _e1298 = phi_1858_;
                                                        phi_1859_ = _e1298;
                                                    }
                                                    let _e1300 = phi_1859_;
                                                    let _e1303 = (_e1300.x / _e1300.z);
                                                    let _e1306 = (_e1300.y / _e1300.z);
                                                    if (_e1221 < 0f) {
                                                        phi_1872_ = 0u;
                                                    } else {
                                                        phi_1872_ = 1u;
                                                    }
                                                    let _e1311 = phi_1872_;
                                                    if (_e1231 < 0f) {
                                                        phi_1877_ = 0u;
                                                    } else {
                                                        phi_1877_ = 2u;
                                                    }
                                                    let _e1314 = phi_1877_;
                                                    if (_e1241 < 0f) {
                                                        phi_1882_ = 0u;
                                                    } else {
                                                        phi_1882_ = 4u;
                                                    }
                                                    let _e1317 = phi_1882_;
                                                    let _e1319 = ((_e1311 | _e1314) | _e1317);
                                                    let _e1320 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1081, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1320.first[0], _e1320.first[1], _e1320.first[2], _e1320.first[3], _e1320.first[4], _e1320.first[5], _e1320.first[6], _e1320.first[7], _e1320.first[8], _e1320.first[9], _e1320.first[10], _e1320.first[11], _e1320.first[12], _e1320.first[13], _e1320.first[14], _e1320.first[15], _e1320.first[16], _e1320.first[17], _e1320.first[18], _e1320.first[19], _e1320.first[20], _e1320.first[21], _e1320.first[22], _e1320.first[23], _e1320.first[24], _e1320.first[25], _e1320.first[26], _e1320.first[27], _e1320.first[28], _e1320.first[29], _e1320.first[30], _e1320.first[31]), array<u32, 32>(_e1320.mask[0], _e1320.mask[1], _e1320.mask[2], _e1320.mask[3], _e1320.mask[4], _e1320.mask[5], _e1320.mask[6], _e1320.mask[7], _e1320.mask[8], _e1320.mask[9], _e1320.mask[10], _e1320.mask[11], _e1320.mask[12], _e1320.mask[13], _e1320.mask[14], _e1320.mask[15], _e1320.mask[16], _e1320.mask[17], _e1320.mask[18], _e1320.mask[19], _e1320.mask[20], _e1320.mask[21], _e1320.mask[22], _e1320.mask[23], _e1320.mask[24], _e1320.mask[25], _e1320.mask[26], _e1320.mask[27], _e1320.mask[28], _e1320.mask[29], _e1320.mask[30], _e1320.mask[31]), _e1320.len, _e1320.group, _e1320.group_mask);
                                                    let _e1394 = local_1.group_mask;
                                                    if ((_e1394 & 4278190080u) == 0u) {
                                                        let _e1398 = local_1.len;
                                                        if (_e1398 == 0u) {
                                                            phi_1996_ = false;
                                                        } else {
                                                            let _e1402 = local_1.len;
                                                            local_1.len = (_e1402 - 1u);
                                                            let _e1405 = local_1.len;
                                                            if (_e1405 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1410 = local_1.first[(0u + _e1405)];
                                                            local_1.group = _e1410;
                                                            let _e1413 = local_1.len;
                                                            if (_e1413 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1418 = local_1.mask[(0u + _e1413)];
                                                            local_1.group_mask = _e1418;
                                                            phi_1996_ = true;
                                                        }
                                                        let _e1421 = phi_1996_;
                                                        phi_1997_ = _e1421;
                                                    } else {
                                                        phi_1997_ = true;
                                                    }
                                                    let _e1423 = phi_1997_;
                                                    if _e1423 {
                                                        let _e1425 = local_1.group_mask;
                                                        let _e1431 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1425)), 32u, (_e1425 == 0u)));
                                                        let _e1435 = local_1.group_mask;
                                                        let _e1449 = local_1.group_mask;
                                                        local_1.group_mask = (_e1449 & ~((1u << bitcast<u32>((_e1431 & 31u)))));
                                                        let _e1452 = local_1.group;
                                                        phi_2028_ = (_e1452 + countOneBits(((_e1435 & ~((4294967295u << bitcast<u32>((((_e1431 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2028_ = 4294967295u;
                                                    }
                                                    let _e1455 = phi_2028_;
                                                    phi_2030_ = _e1455;
                                                    loop {
                                                        let _e1457 = phi_2030_;
                                                        if (_e1457 != 4294967295u) {
                                                            if (_e1457 < _e76) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1464 = nodes.member[(0u + _e1457)].frame[3u];
                                                            let _e1489 = (bitcast<f32>((((_e1464 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1221);
                                                            let _e1490 = (bitcast<f32>((((_e1464 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1231);
                                                            let _e1491 = (bitcast<f32>((((_e1464 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1241);
                                                            let _e1494 = nodes.member[(0u + _e1457)].frame[0u];
                                                            let _e1498 = nodes.member[(0u + _e1457)].frame[1u];
                                                            let _e1502 = nodes.member[(0u + _e1457)].frame[2u];
                                                            let _e1507 = ((bitcast<f32>(_e1494) - _e1012) * _e1221);
                                                            let _e1508 = ((bitcast<f32>(_e1498) - _e1025) * _e1231);
                                                            let _e1509 = ((bitcast<f32>(_e1502) - _e1038) * _e1241);
                                                            let _e1517 = nodes.member[(0u + _e1457)].x;
                                                            if (_e1221 < 0f) {
                                                                let _e1528 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1517.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1534 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1528.unnamed.root, _e1517.w), _e1528.unnamed_1);
                                                                let _e1540 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1534.unnamed, lt_bvh_traverse_Tree(_e1517.x, _e1534.unnamed_1.first_primitive));
                                                                phi_2111_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1540.unnamed, lt_bvh_traverse_Tree(_e1540.unnamed_1.root, _e1517.y));
                                                            } else {
                                                                let _e1556 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1517.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1562 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1556.unnamed.root, _e1517.y), _e1556.unnamed_1);
                                                                let _e1568 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1562.unnamed, lt_bvh_traverse_Tree(_e1517.z, _e1562.unnamed_1.first_primitive));
                                                                phi_2111_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1568.unnamed, lt_bvh_traverse_Tree(_e1568.unnamed_1.root, _e1517.w));
                                                            }
                                                            let _e1576 = phi_2111_;
                                                            let _e1586 = nodes.member[(0u + _e1457)].y;
                                                            if (_e1231 < 0f) {
                                                                let _e1597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1597.unnamed.root, _e1586.w), _e1597.unnamed_1);
                                                                let _e1609 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1603.unnamed, lt_bvh_traverse_Tree(_e1586.x, _e1603.unnamed_1.first_primitive));
                                                                phi_2138_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1609.unnamed, lt_bvh_traverse_Tree(_e1609.unnamed_1.root, _e1586.y));
                                                            } else {
                                                                let _e1625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1586.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1625.unnamed.root, _e1586.y), _e1625.unnamed_1);
                                                                let _e1637 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1631.unnamed, lt_bvh_traverse_Tree(_e1586.z, _e1631.unnamed_1.first_primitive));
                                                                phi_2138_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1637.unnamed, lt_bvh_traverse_Tree(_e1637.unnamed_1.root, _e1586.w));
                                                            }
                                                            let _e1645 = phi_2138_;
                                                            let _e1655 = nodes.member[(0u + _e1457)].z;
                                                            if (_e1241 < 0f) {
                                                                let _e1666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1666.unnamed.root, _e1655.w), _e1666.unnamed_1);
                                                                let _e1678 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1672.unnamed, lt_bvh_traverse_Tree(_e1655.x, _e1672.unnamed_1.first_primitive));
                                                                phi_2165_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1678.unnamed, lt_bvh_traverse_Tree(_e1678.unnamed_1.root, _e1655.y));
                                                            } else {
                                                                let _e1694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1655.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e1694.unnamed.root, _e1655.y), _e1694.unnamed_1);
                                                                let _e1706 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1700.unnamed, lt_bvh_traverse_Tree(_e1655.z, _e1700.unnamed_1.first_primitive));
                                                                phi_2165_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1706.unnamed, lt_bvh_traverse_Tree(_e1706.unnamed_1.root, _e1655.w));
                                                            }
                                                            let _e1714 = phi_2165_;
                                                            phi_2171_ = 0u;
                                                            phi_2174_ = 0u;
                                                            loop {
                                                                let _e1724 = phi_2171_;
                                                                let _e1726 = phi_2174_;
                                                                local_6 = _e1726;
                                                                local_7 = _e1726;
                                                                local_8 = _e1726;
                                                                let _e1727 = (_e1724 < 8u);
                                                                if _e1727 {
                                                                    let _e1729 = (_e1724 >> bitcast<u32>(2i));
                                                                    let _e1730 = (_e1724 & 3u);
                                                                    if (_e1729 == 0u) {
                                                                        phi_2188_ = _e1576.unnamed.root;
                                                                    } else {
                                                                        phi_2188_ = _e1576.unnamed.first_primitive;
                                                                    }
                                                                    let _e1733 = phi_2188_;
                                                                    if (_e1729 == 0u) {
                                                                        phi_2198_ = _e1645.unnamed.root;
                                                                    } else {
                                                                        phi_2198_ = _e1645.unnamed.first_primitive;
                                                                    }
                                                                    let _e1742 = phi_2198_;
                                                                    if (_e1729 == 0u) {
                                                                        phi_2208_ = _e1714.unnamed.root;
                                                                    } else {
                                                                        phi_2208_ = _e1714.unnamed.first_primitive;
                                                                    }
                                                                    let _e1751 = phi_2208_;
                                                                    let _e1764 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1733 >> bitcast<u32>(((_e1730 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 - _e1269)), ((f32(((_e1742 >> bitcast<u32>(((_e1730 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 - _e1270)));
                                                                    let _e1765 = core_intrinsics_maximum_number_nsz_f32_(_e1764, ((f32(((_e1751 >> bitcast<u32>(((_e1730 * 8u) & 31u))) & 255u)) * _e1491) + (_e1509 - _e1271)));
                                                                    if (_e1729 == 0u) {
                                                                        phi_2226_ = _e1576.unnamed_1.root;
                                                                    } else {
                                                                        phi_2226_ = _e1576.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1768 = phi_2226_;
                                                                    if (_e1729 == 0u) {
                                                                        phi_2236_ = _e1645.unnamed_1.root;
                                                                    } else {
                                                                        phi_2236_ = _e1645.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1777 = phi_2236_;
                                                                    if (_e1729 == 0u) {
                                                                        phi_2246_ = _e1714.unnamed_1.root;
                                                                    } else {
                                                                        phi_2246_ = _e1714.unnamed_1.first_primitive;
                                                                    }
                                                                    let _e1786 = phi_2246_;
                                                                    let _e1799 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1768 >> bitcast<u32>(((_e1730 * 8u) & 31u))) & 255u)) * _e1489) + (_e1507 + _e1269)), ((f32(((_e1777 >> bitcast<u32>(((_e1730 * 8u) & 31u))) & 255u)) * _e1490) + (_e1508 + _e1270)));
                                                                    let _e1800 = core_intrinsics_minimum_number_nsz_f32_(_e1799, ((f32(((_e1786 >> bitcast<u32>(((_e1730 * 8u) & 31u))) & 255u)) * _e1491) + (_e1509 + _e1271)));
                                                                    if (_e1765 <= _e1800) {
                                                                        if (_e1765 <= _e142) {
                                                                            if (_e1800 >= 0f) {
                                                                                if (_e1729 == 0u) {
                                                                                    let _e1807 = nodes.member[(0u + _e1457)].links[2u];
                                                                                    phi_2282_ = _e1807;
                                                                                } else {
                                                                                    let _e1810 = nodes.member[(0u + _e1457)].links[3u];
                                                                                    phi_2282_ = _e1810;
                                                                                }
                                                                                let _e1812 = phi_2282_;
                                                                                let _e1817 = ((_e1812 >> bitcast<u32>(((_e1730 * 8u) & 31u))) & 255u);
                                                                                let _e1818 = (_e1817 & 31u);
                                                                                if (_e1818 >= 24u) {
                                                                                    phi_2295_ = (24u + ((_e1818 - 24u) ^ _e1319));
                                                                                } else {
                                                                                    phi_2295_ = _e1818;
                                                                                }
                                                                                let _e1824 = phi_2295_;
                                                                                phi_2300_ = (_e1726 | ((_e1817 >> bitcast<u32>(5i)) << bitcast<u32>((_e1824 & 31u))));
                                                                            } else {
                                                                                phi_2300_ = _e1726;
                                                                            }
                                                                            let _e1832 = phi_2300_;
                                                                            phi_2301_ = _e1832;
                                                                        } else {
                                                                            phi_2301_ = _e1726;
                                                                        }
                                                                        let _e1834 = phi_2301_;
                                                                        phi_2302_ = _e1834;
                                                                    } else {
                                                                        phi_2302_ = _e1726;
                                                                    }
                                                                    let _e1836 = phi_2302_;
                                                                    phi_2172_ = (_e1724 + 1u);
                                                                    phi_2175_ = _e1836;
                                                                } else {
                                                                    phi_2172_ = u32();
                                                                    phi_2175_ = u32();
                                                                }
                                                                let _e1839 = phi_2172_;
                                                                let _e1841 = phi_2175_;
                                                                continue;
                                                                continuing {
                                                                    phi_2171_ = _e1839;
                                                                    phi_2174_ = _e1841;
                                                                    break if !(_e1727);
                                                                }
                                                            }
                                                            let _e1845 = nodes.member[(0u + _e1457)].links[0u];
                                                            let _e1849 = nodes.member[(0u + _e1457)].frame[3u];
                                                            let _e1853 = local_6;
                                                            if ((_e1853 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1857 = local_1.group_mask;
                                                                if ((_e1857 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1861 = local_1.len;
                                                                    if (_e1861 < 32u) {
                                                                        let _e1864 = local_1.group;
                                                                        let _e1866 = local_1.len;
                                                                        if (_e1866 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1866)] = _e1864;
                                                                        let _e1872 = local_1.group_mask;
                                                                        let _e1874 = local_1.len;
                                                                        if (_e1874 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1874)] = _e1872;
                                                                        let _e1881 = local_1.len;
                                                                        local_1.len = (_e1881 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1081 + _e1845);
                                                                let _e1885 = local_7;
                                                                local_1.group_mask = ((_e1885 & 4278190080u) | (_e1849 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1890 = local_8;
                                                            phi_2360_ = (_e1890 & 16777215u);
                                                            loop {
                                                                let _e1893 = phi_2360_;
                                                                let _e1894 = (_e1893 == 0u);
                                                                local_9 = _e1894;
                                                                local_15 = _e1894;
                                                                if _e1894 {
                                                                    phi_2361_ = u32();
                                                                    phi_3168_ = false;
                                                                    phi_3169_ = false;
                                                                    phi_3170_ = false;
                                                                } else {
                                                                    let _e1897 = nodes.member[(0u + _e1457)].links[1u];
                                                                    let _e1902 = ((_e1083 + _e1897) + select(firstTrailingBit(_e1893), 32u, (_e1893 == 0u)));
                                                                    if (_e1902 < _e79) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1909 = triangles.member[(0u + _e1902)].v0_;
                                                                    let _e1911 = (_e1909.x - _e1012);
                                                                    let _e1913 = (_e1909.y - _e1025);
                                                                    let _e1915 = (_e1909.z - _e1038);
                                                                    if (_e1292 == 0u) {
                                                                        phi_2406_ = vec3<f32>(_e1913, _e1915, _e1911);
                                                                    } else {
                                                                        if (_e1292 == 1u) {
                                                                            phi_2405_ = vec3<f32>(_e1915, _e1911, _e1913);
                                                                        } else {
                                                                            phi_2405_ = (_e1909 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1923 = phi_2405_;
                                                                        phi_2406_ = _e1923;
                                                                    }
                                                                    let _e1925 = phi_2406_;
                                                                    let _e1929 = (_e1925.x - (_e1303 * _e1925.z));
                                                                    let _e1933 = (_e1925.y - (_e1306 * _e1925.z));
                                                                    let _e1935 = triangles.member[(0u + _e1902)].v1_;
                                                                    let _e1937 = (_e1935.x - _e1012);
                                                                    let _e1939 = (_e1935.y - _e1025);
                                                                    let _e1941 = (_e1935.z - _e1038);
                                                                    if (_e1292 == 0u) {
                                                                        phi_2436_ = vec3<f32>(_e1939, _e1941, _e1937);
                                                                    } else {
                                                                        if (_e1292 == 1u) {
                                                                            phi_2435_ = vec3<f32>(_e1941, _e1937, _e1939);
                                                                        } else {
                                                                            phi_2435_ = (_e1935 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1949 = phi_2435_;
                                                                        phi_2436_ = _e1949;
                                                                    }
                                                                    let _e1951 = phi_2436_;
                                                                    let _e1955 = (_e1951.x - (_e1303 * _e1951.z));
                                                                    let _e1959 = (_e1951.y - (_e1306 * _e1951.z));
                                                                    let _e1961 = triangles.member[(0u + _e1902)].v2_;
                                                                    let _e1963 = (_e1961.x - _e1012);
                                                                    let _e1965 = (_e1961.y - _e1025);
                                                                    let _e1967 = (_e1961.z - _e1038);
                                                                    if (_e1292 == 0u) {
                                                                        phi_2466_ = vec3<f32>(_e1965, _e1967, _e1963);
                                                                    } else {
                                                                        if (_e1292 == 1u) {
                                                                            phi_2465_ = vec3<f32>(_e1967, _e1963, _e1965);
                                                                        } else {
                                                                            phi_2465_ = (_e1961 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                        }
                                                                        let _e1975 = phi_2465_;
                                                                        phi_2466_ = _e1975;
                                                                    }
                                                                    let _e1977 = phi_2466_;
                                                                    let _e1981 = (_e1977.x - (_e1303 * _e1977.z));
                                                                    let _e1985 = (_e1977.y - (_e1306 * _e1977.z));
                                                                    if (_e1955 < _e1981) {
                                                                        phi_2485_ = true;
                                                                    } else {
                                                                        if (_e1955 == _e1981) {
                                                                            phi_2484_ = (_e1959 < _e1985);
                                                                        } else {
                                                                            phi_2484_ = false;
                                                                        }
                                                                        let _e1990 = phi_2484_;
                                                                        phi_2485_ = _e1990;
                                                                    }
                                                                    let _e1992 = phi_2485_;
                                                                    if _e1992 {
                                                                        phi_2489_ = _e1985;
                                                                        phi_2490_ = _e1981;
                                                                        phi_2491_ = _e1959;
                                                                        phi_2492_ = _e1955;
                                                                    } else {
                                                                        phi_2489_ = _e1959;
                                                                        phi_2490_ = _e1955;
                                                                        phi_2491_ = _e1985;
                                                                        phi_2492_ = _e1981;
                                                                    }
                                                                    let _e1994 = phi_2489_;
                                                                    let _e1996 = phi_2490_;
                                                                    let _e1998 = phi_2491_;
                                                                    let _e2000 = phi_2492_;
                                                                    let _e2003 = ((_e2000 * _e1994) - (_e1998 * _e1996));
                                                                    if _e1992 {
                                                                        phi_2500_ = -(_e2003);
                                                                    } else {
                                                                        phi_2500_ = _e2003;
                                                                    }
                                                                    let _e2006 = phi_2500_;
                                                                    if (_e1981 < _e1929) {
                                                                        phi_2511_ = true;
                                                                    } else {
                                                                        if (_e1981 == _e1929) {
                                                                            phi_2510_ = (_e1985 < _e1933);
                                                                        } else {
                                                                            phi_2510_ = false;
                                                                        }
                                                                        let _e2011 = phi_2510_;
                                                                        phi_2511_ = _e2011;
                                                                    }
                                                                    let _e2013 = phi_2511_;
                                                                    if _e2013 {
                                                                        phi_2515_ = _e1933;
                                                                        phi_2516_ = _e1929;
                                                                        phi_2517_ = _e1985;
                                                                        phi_2518_ = _e1981;
                                                                    } else {
                                                                        phi_2515_ = _e1985;
                                                                        phi_2516_ = _e1981;
                                                                        phi_2517_ = _e1933;
                                                                        phi_2518_ = _e1929;
                                                                    }
                                                                    let _e2015 = phi_2515_;
                                                                    let _e2017 = phi_2516_;
                                                                    let _e2019 = phi_2517_;
                                                                    let _e2021 = phi_2518_;
                                                                    let _e2024 = ((_e2021 * _e2015) - (_e2019 * _e2017));
                                                                    if _e2013 {
                                                                        phi_2526_ = -(_e2024);
                                                                    } else {
                                                                        phi_2526_ = _e2024;
                                                                    }
                                                                    let _e2027 = phi_2526_;
                                                                    if (_e1929 < _e1955) {
                                                                        phi_2537_ = true;
                                                                    } else {
                                                                        if (_e1929 == _e1955) {
                                                                            phi_2536_ = (_e1933 < _e1959);
                                                                        } else {
                                                                            phi_2536_ = false;
                                                                        }
                                                                        let _e2032 = phi_2536_;
                                                                        phi_2537_ = _e2032;
                                                                    }
                                                                    let _e2034 = phi_2537_;
                                                                    if _e2034 {
                                                                        phi_2541_ = _e1959;
                                                                        phi_2542_ = _e1955;
                                                                        phi_2543_ = _e1933;
                                                                        phi_2544_ = _e1929;
                                                                    } else {
                                                                        phi_2541_ = _e1933;
                                                                        phi_2542_ = _e1929;
                                                                        phi_2543_ = _e1959;
                                                                        phi_2544_ = _e1955;
                                                                    }
                                                                    let _e2036 = phi_2541_;
                                                                    let _e2038 = phi_2542_;
                                                                    let _e2040 = phi_2543_;
                                                                    let _e2042 = phi_2544_;
                                                                    let _e2045 = ((_e2042 * _e2036) - (_e2040 * _e2038));
                                                                    if _e2034 {
                                                                        phi_2552_ = -(_e2045);
                                                                    } else {
                                                                        phi_2552_ = _e2045;
                                                                    }
                                                                    let _e2048 = phi_2552_;
                                                                    if (_e2006 >= 0f) {
                                                                        if (_e2027 >= 0f) {
                                                                            if (_e2048 >= 0f) {
                                                                                phi_2567_ = ((_e2006 + _e2027) + _e2048);
                                                                                phi_2568_ = false;
                                                                            } else {
                                                                                phi_2567_ = f32();
                                                                                phi_2568_ = true;
                                                                            }
                                                                            let _e2055 = phi_2567_;
                                                                            let _e2057 = phi_2568_;
                                                                            phi_2569_ = _e2055;
                                                                            phi_2570_ = _e2057;
                                                                        } else {
                                                                            phi_2569_ = f32();
                                                                            phi_2570_ = true;
                                                                        }
                                                                        let _e2059 = phi_2569_;
                                                                        let _e2061 = phi_2570_;
                                                                        phi_2571_ = _e2059;
                                                                        phi_2572_ = _e2061;
                                                                    } else {
                                                                        phi_2571_ = f32();
                                                                        phi_2572_ = true;
                                                                    }
                                                                    let _e2063 = phi_2571_;
                                                                    let _e2065 = phi_2572_;
                                                                    if _e2065 {
                                                                        if (_e2006 <= 0f) {
                                                                            if (_e2027 <= 0f) {
                                                                                let _e2068 = (_e2048 <= 0f);
                                                                                if _e2068 {
                                                                                }
                                                                                phi_2590_ = ((_e2006 + _e2027) + _e2048);
                                                                                phi_2591_ = false;
                                                                                phi_2592_ = _e2068;
                                                                            } else {
                                                                                phi_2590_ = f32();
                                                                                phi_2591_ = true;
                                                                                phi_2592_ = false;
                                                                            }
                                                                            let _e2072 = phi_2590_;
                                                                            let _e2074 = phi_2591_;
                                                                            let _e2076 = phi_2592_;
                                                                            phi_2593_ = _e2072;
                                                                            phi_2594_ = _e2074;
                                                                            phi_2595_ = _e2076;
                                                                        } else {
                                                                            phi_2593_ = f32();
                                                                            phi_2594_ = true;
                                                                            phi_2595_ = false;
                                                                        }
                                                                        let _e2078 = phi_2593_;
                                                                        let _e2080 = phi_2594_;
                                                                        let _e2082 = phi_2595_;
                                                                        if _e2080 {
                                                                            phi_2599_ = false;
                                                                        } else {
                                                                            phi_2599_ = _e2082;
                                                                        }
                                                                        let _e2084 = phi_2599_;
                                                                        phi_2600_ = _e2078;
                                                                        phi_2601_ = _e2084;
                                                                    } else {
                                                                        phi_2600_ = _e2063;
                                                                        phi_2601_ = true;
                                                                    }
                                                                    let _e2086 = phi_2600_;
                                                                    let _e2088 = phi_2601_;
                                                                    if _e2088 {
                                                                        let _e2089 = (_e2086 == 0f);
                                                                        if _e2089 {
                                                                            phi_2917_ = lt_bvh_triangle_Intersection();
                                                                            phi_2918_ = false;
                                                                        } else {
                                                                            let _e2091 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2093 = (_e2091.x - _e1012);
                                                                            let _e2095 = (_e2091.y - _e1025);
                                                                            let _e2097 = (_e2091.z - _e1038);
                                                                            if (_e1292 == 0u) {
                                                                                phi_2630_ = vec3<f32>(_e2095, _e2097, _e2093);
                                                                            } else {
                                                                                if (_e1292 == 1u) {
                                                                                    phi_2629_ = vec3<f32>(_e2097, _e2093, _e2095);
                                                                                } else {
                                                                                    phi_2629_ = (_e2091 - vec3<f32>(_e1012, _e1025, _e1038));
                                                                                }
                                                                                let _e2105 = phi_2629_;
                                                                                phi_2630_ = _e2105;
                                                                            }
                                                                            let _e2107 = phi_2630_;
                                                                            let _e2109 = triangles.member[(0u + _e1902)].v1_;
                                                                            let _e2111 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2114 = (_e2109.x - _e2111.x);
                                                                            let _e2117 = (_e2109.y - _e2111.y);
                                                                            let _e2120 = (_e2109.z - _e2111.z);
                                                                            if (_e1292 == 0u) {
                                                                                phi_2656_ = vec3<f32>(_e2117, _e2120, _e2114);
                                                                            } else {
                                                                                if (_e1292 == 1u) {
                                                                                    phi_2655_ = vec3<f32>(_e2120, _e2114, _e2117);
                                                                                } else {
                                                                                    phi_2655_ = (_e2109 - _e2111);
                                                                                }
                                                                                let _e2127 = phi_2655_;
                                                                                phi_2656_ = _e2127;
                                                                            }
                                                                            let _e2129 = phi_2656_;
                                                                            let _e2131 = triangles.member[(0u + _e1902)].v2_;
                                                                            let _e2133 = triangles.member[(0u + _e1902)].v0_;
                                                                            let _e2136 = (_e2131.x - _e2133.x);
                                                                            let _e2139 = (_e2131.y - _e2133.y);
                                                                            let _e2142 = (_e2131.z - _e2133.z);
                                                                            if (_e1292 == 0u) {
                                                                                phi_2682_ = vec3<f32>(_e2139, _e2142, _e2136);
                                                                            } else {
                                                                                if (_e1292 == 1u) {
                                                                                    phi_2681_ = vec3<f32>(_e2142, _e2136, _e2139);
                                                                                } else {
                                                                                    phi_2681_ = (_e2131 - _e2133);
                                                                                }
                                                                                let _e2149 = phi_2681_;
                                                                                phi_2682_ = _e2149;
                                                                            }
                                                                            let _e2151 = phi_2682_;
                                                                            let _e2158 = ((_e2129.y * _e2151.z) - (_e2129.z * _e2151.y));
                                                                            let _e2165 = ((_e2129.z * _e2151.x) - (_e2129.x * _e2151.z));
                                                                            let _e2172 = ((_e2129.x * _e2151.y) - (_e2129.y * _e2151.x));
                                                                            let _e2186 = (((1f / _e1300.z) * (((_e2158 * _e2107.x) + (_e2165 * _e2107.y)) + (_e2172 * _e2107.z))) / (((_e2158 * _e1303) + (_e2165 * _e1306)) + _e2172));
                                                                            if (_e2186 > 0f) {
                                                                                if (_e2186 < _e142) {
                                                                                    let _e2190 = triangles.member[(0u + _e1902)].v0_;
                                                                                    let _e2192 = triangles.member[(0u + _e1902)].v1_;
                                                                                    if (_e2190.x < _e2192.x) {
                                                                                        phi_2738_ = _e2190.x;
                                                                                    } else {
                                                                                        phi_2738_ = _e2192.x;
                                                                                    }
                                                                                    let _e2199 = phi_2738_;
                                                                                    if (_e2190.y < _e2192.y) {
                                                                                        phi_2747_ = _e2190.y;
                                                                                    } else {
                                                                                        phi_2747_ = _e2192.y;
                                                                                    }
                                                                                    let _e2206 = phi_2747_;
                                                                                    if (_e2190.z < _e2192.z) {
                                                                                        phi_2756_ = _e2190.z;
                                                                                    } else {
                                                                                        phi_2756_ = _e2192.z;
                                                                                    }
                                                                                    let _e2213 = phi_2756_;
                                                                                    let _e2215 = triangles.member[(0u + _e1902)].v2_;
                                                                                    if (_e2199 < _e2215.x) {
                                                                                        phi_2765_ = _e2199;
                                                                                    } else {
                                                                                        phi_2765_ = _e2215.x;
                                                                                    }
                                                                                    let _e2220 = phi_2765_;
                                                                                    if (_e2206 < _e2215.y) {
                                                                                        phi_2772_ = _e2206;
                                                                                    } else {
                                                                                        phi_2772_ = _e2215.y;
                                                                                    }
                                                                                    let _e2225 = phi_2772_;
                                                                                    if (_e2213 < _e2215.z) {
                                                                                        phi_2779_ = _e2213;
                                                                                    } else {
                                                                                        phi_2779_ = _e2215.z;
                                                                                    }
                                                                                    let _e2230 = phi_2779_;
                                                                                    let _e2232 = triangles.member[(0u + _e1902)].v0_;
                                                                                    let _e2234 = triangles.member[(0u + _e1902)].v1_;
                                                                                    if (_e2232.x > _e2234.x) {
                                                                                        phi_2792_ = _e2232.x;
                                                                                    } else {
                                                                                        phi_2792_ = _e2234.x;
                                                                                    }
                                                                                    let _e2241 = phi_2792_;
                                                                                    if (_e2232.y > _e2234.y) {
                                                                                        phi_2801_ = _e2232.y;
                                                                                    } else {
                                                                                        phi_2801_ = _e2234.y;
                                                                                    }
                                                                                    let _e2248 = phi_2801_;
                                                                                    if (_e2232.z > _e2234.z) {
                                                                                        phi_2810_ = _e2232.z;
                                                                                    } else {
                                                                                        phi_2810_ = _e2234.z;
                                                                                    }
                                                                                    let _e2255 = phi_2810_;
                                                                                    let _e2257 = triangles.member[(0u + _e1902)].v2_;
                                                                                    if (_e2241 > _e2257.x) {
                                                                                        phi_2819_ = _e2241;
                                                                                    } else {
                                                                                        phi_2819_ = _e2257.x;
                                                                                    }
                                                                                    let _e2262 = phi_2819_;
                                                                                    if (_e2248 > _e2257.y) {
                                                                                        phi_2826_ = _e2248;
                                                                                    } else {
                                                                                        phi_2826_ = _e2257.y;
                                                                                    }
                                                                                    let _e2267 = phi_2826_;
                                                                                    if (_e2255 > _e2257.z) {
                                                                                        phi_2833_ = _e2255;
                                                                                    } else {
                                                                                        phi_2833_ = _e2257.z;
                                                                                    }
                                                                                    let _e2272 = phi_2833_;
                                                                                    let _e2276 = ((_e2220 - _e1012) * _e1221);
                                                                                    let _e2277 = ((_e2225 - _e1025) * _e1231);
                                                                                    let _e2278 = ((_e2230 - _e1038) * _e1241);
                                                                                    let _e2282 = ((_e2262 - _e1012) * _e1221);
                                                                                    let _e2283 = ((_e2267 - _e1025) * _e1231);
                                                                                    let _e2284 = ((_e2272 - _e1038) * _e1241);
                                                                                    if (_e2276 < _e2282) {
                                                                                        phi_2850_ = _e2276;
                                                                                    } else {
                                                                                        phi_2850_ = _e2282;
                                                                                    }
                                                                                    let _e2287 = phi_2850_;
                                                                                    if (_e2277 < _e2283) {
                                                                                        phi_2855_ = _e2277;
                                                                                    } else {
                                                                                        phi_2855_ = _e2283;
                                                                                    }
                                                                                    let _e2290 = phi_2855_;
                                                                                    if (_e2278 < _e2284) {
                                                                                        phi_2860_ = _e2278;
                                                                                    } else {
                                                                                        phi_2860_ = _e2284;
                                                                                    }
                                                                                    let _e2293 = phi_2860_;
                                                                                    if (_e2276 > _e2282) {
                                                                                        phi_2868_ = _e2276;
                                                                                    } else {
                                                                                        phi_2868_ = _e2282;
                                                                                    }
                                                                                    let _e2299 = phi_2868_;
                                                                                    if (_e2277 > _e2283) {
                                                                                        phi_2873_ = _e2277;
                                                                                    } else {
                                                                                        phi_2873_ = _e2283;
                                                                                    }
                                                                                    let _e2302 = phi_2873_;
                                                                                    if (_e2278 > _e2284) {
                                                                                        phi_2878_ = _e2278;
                                                                                    } else {
                                                                                        phi_2878_ = _e2284;
                                                                                    }
                                                                                    let _e2305 = phi_2878_;
                                                                                    let _e2309 = core_intrinsics_maximum_number_nsz_f32_((_e2287 - _e1276), (_e2290 - _e1277));
                                                                                    let _e2310 = core_intrinsics_maximum_number_nsz_f32_(_e2309, (_e2293 - _e1278));
                                                                                    let _e2311 = core_intrinsics_minimum_number_nsz_f32_((_e2299 + _e1276), (_e2302 + _e1277));
                                                                                    let _e2312 = core_intrinsics_minimum_number_nsz_f32_(_e2311, (_e2305 + _e1278));
                                                                                    if (_e2310 > _e993) {
                                                                                        phi_2890_ = _e2310;
                                                                                    } else {
                                                                                        phi_2890_ = _e993;
                                                                                    }
                                                                                    let _e2315 = phi_2890_;
                                                                                    if (_e2312 < _e995) {
                                                                                        phi_2895_ = _e2312;
                                                                                    } else {
                                                                                        phi_2895_ = _e995;
                                                                                    }
                                                                                    let _e2318 = phi_2895_;
                                                                                    if (_e2186 < _e2315) {
                                                                                        phi_2900_ = _e2315;
                                                                                    } else {
                                                                                        phi_2900_ = _e2186;
                                                                                    }
                                                                                    let _e2321 = phi_2900_;
                                                                                    if (_e2321 > _e2318) {
                                                                                        phi_2905_ = _e2318;
                                                                                    } else {
                                                                                        phi_2905_ = _e2321;
                                                                                    }
                                                                                    let _e2324 = phi_2905_;
                                                                                    phi_2910_ = lt_bvh_triangle_Intersection(_e2324, (_e2027 / _e2086), (_e2048 / _e2086), (_e2315 <= _e2318));
                                                                                    phi_2911_ = false;
                                                                                } else {
                                                                                    phi_2910_ = lt_bvh_triangle_Intersection();
                                                                                    phi_2911_ = true;
                                                                                }
                                                                                let _e2330 = phi_2910_;
                                                                                let _e2332 = phi_2911_;
                                                                                phi_2912_ = _e2330;
                                                                                phi_2913_ = _e2332;
                                                                            } else {
                                                                                phi_2912_ = lt_bvh_triangle_Intersection();
                                                                                phi_2913_ = true;
                                                                            }
                                                                            let _e2334 = phi_2912_;
                                                                            let _e2336 = phi_2913_;
                                                                            if _e2336 {
                                                                            }
                                                                            phi_2917_ = _e2334;
                                                                            phi_2918_ = _e2336;
                                                                        }
                                                                        let _e2338 = phi_2917_;
                                                                        let _e2340 = phi_2918_;
                                                                        phi_2919_ = _e2338;
                                                                        phi_2920_ = _e2089;
                                                                        phi_2921_ = _e2340;
                                                                    } else {
                                                                        phi_2919_ = lt_bvh_triangle_Intersection();
                                                                        phi_2920_ = true;
                                                                        phi_2921_ = false;
                                                                    }
                                                                    let _e2342 = phi_2919_;
                                                                    let _e2344 = phi_2920_;
                                                                    let _e2346 = phi_2921_;
                                                                    if _e2344 {
                                                                        phi_2925_ = true;
                                                                    } else {
                                                                        phi_2925_ = _e2346;
                                                                    }
                                                                    let _e2348 = phi_2925_;
                                                                    if _e2348 {
                                                                        phi_2929_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_2929_ = _e2342;
                                                                    }
                                                                    let _e2350 = phi_2929_;
                                                                    if _e2350.is_hit {
                                                                        if (_e2350.t > 0f) {
                                                                            if (_e2350.t < _e142) {
                                                                                let _e2357 = triangles.member[(0u + _e1902)].i0_;
                                                                                let _e2359 = ((_e2357 & 2147483648u) == 0u);
                                                                                if _e2359 {
                                                                                    phi_3152_ = false;
                                                                                    phi_3153_ = false;
                                                                                } else {
                                                                                    if (_e1902 < _e79) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2366 = triangles.member[(0u + _e1902)].i0_;
                                                                                    let _e2367 = (_e2366 & 2147483647u);
                                                                                    let _e2369 = triangles.member[(0u + _e1902)].i1_;
                                                                                    let _e2371 = triangles.member[(0u + _e1902)].i2_;
                                                                                    if (_e2367 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2375 = vertices.member[(0u + _e2367)];
                                                                                    if (_e2369 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2379 = vertices.member[(0u + _e2369)];
                                                                                    if (_e2371 < _e91) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2383 = vertices.member[(0u + _e2371)];
                                                                                    let _e2384 = array<abi_Vertex, 3>(_e2375, _e2379, _e2383);
                                                                                    if (_e2384[0].material < arrayLength((&materials.member))) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2390 = materials.member[(0u + _e2384[0].material)];
                                                                                    if ((_e2390.flags & 1u) == 1u) {
                                                                                        let _e2395 = ((1f - _e2350.u) - _e2350.v);
                                                                                        if (_e2390.cutoff <= 0f) {
                                                                                            phi_3146_ = true;
                                                                                        } else {
                                                                                            let _e2422 = (_e2390.base_color.w * ((((f32((_e2384[0].color >> bitcast<u32>(24i))) * _e2395) + (f32((_e2384[1].color >> bitcast<u32>(24i))) * _e2350.u)) + (f32((_e2384[2].color >> bitcast<u32>(24i))) * _e2350.v)) * (1f / 255f)));
                                                                                            if (_e2390.alpha_size == 0u) {
                                                                                                phi_3143_ = _e2422;
                                                                                            } else {
                                                                                                local.offset = _e2390.alpha_offset;
                                                                                                local.size = _e2390.alpha_size;
                                                                                                local.flags = _e2390.flags;
                                                                                                let _e2453 = _lt_shaders_texture_TextureView_quad((&local), (((_e2384[0].u * _e2395) + (_e2384[1].u * _e2350.u)) + (_e2384[2].u * _e2350.v)), (((_e2384[0].v * _e2395) + (_e2384[1].v * _e2350.u)) + (_e2384[2].v * _e2350.v)));
                                                                                                let _e2457 = (_e2453.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2457 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2461 = alpha_texels.member[(0u + _e2457)];
                                                                                                let _e2477 = (_e2453.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2477 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2481 = alpha_texels.member[(0u + _e2477)];
                                                                                                let _e2498 = (_e2453.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2498 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2502 = alpha_texels.member[(0u + _e2498)];
                                                                                                let _e2519 = (_e2453.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2519 < _e97) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2523 = alpha_texels.member[(0u + _e2519)];
                                                                                                phi_3143_ = (_e2422 * (((((f32(((_e2461 >> bitcast<u32>((((_e2453.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.x) + ((f32(((_e2481 >> bitcast<u32>((((_e2453.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.y)) + ((f32(((_e2502 >> bitcast<u32>((((_e2453.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.z)) + ((f32(((_e2523 >> bitcast<u32>((((_e2453.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2453.weights.w)));
                                                                                            }
                                                                                            let _e2539 = phi_3143_;
                                                                                            phi_3146_ = (_e2539 >= _e2390.cutoff);
                                                                                        }
                                                                                        let _e2543 = phi_3146_;
                                                                                        phi_3147_ = _e2543;
                                                                                    } else {
                                                                                        phi_3147_ = false;
                                                                                    }
                                                                                    let _e2545 = phi_3147_;
                                                                                    if _e2545 {
                                                                                        phi_3151_ = false;
                                                                                    } else {
                                                                                        phi_3151_ = true;
                                                                                    }
                                                                                    let _e2547 = phi_3151_;
                                                                                    phi_3152_ = _e2547;
                                                                                    phi_3153_ = _e2545;
                                                                                }
                                                                                let _e2549 = phi_3152_;
                                                                                let _e2551 = phi_3153_;
                                                                                phi_3154_ = _e2549;
                                                                                phi_3155_ = _e2359;
                                                                                phi_3156_ = _e2551;
                                                                            } else {
                                                                                phi_3154_ = true;
                                                                                phi_3155_ = false;
                                                                                phi_3156_ = false;
                                                                            }
                                                                            let _e2553 = phi_3154_;
                                                                            let _e2555 = phi_3155_;
                                                                            let _e2557 = phi_3156_;
                                                                            phi_3157_ = _e2553;
                                                                            phi_3158_ = _e2555;
                                                                            phi_3159_ = _e2557;
                                                                        } else {
                                                                            phi_3157_ = true;
                                                                            phi_3158_ = false;
                                                                            phi_3159_ = false;
                                                                        }
                                                                        let _e2559 = phi_3157_;
                                                                        let _e2561 = phi_3158_;
                                                                        let _e2563 = phi_3159_;
                                                                        phi_3160_ = _e2559;
                                                                        phi_3161_ = _e2561;
                                                                        phi_3162_ = _e2563;
                                                                    } else {
                                                                        phi_3160_ = true;
                                                                        phi_3161_ = false;
                                                                        phi_3162_ = false;
                                                                    }
                                                                    let _e2565 = phi_3160_;
                                                                    let _e2567 = phi_3161_;
                                                                    let _e2569 = phi_3162_;
                                                                    if _e2565 {
                                                                        phi_3166_ = false;
                                                                        phi_3167_ = false;
                                                                    } else {
                                                                        phi_3166_ = _e2567;
                                                                        phi_3167_ = _e2569;
                                                                    }
                                                                    let _e2571 = phi_3166_;
                                                                    let _e2573 = phi_3167_;
                                                                    phi_2361_ = (_e1893 & (_e1893 - 1u));
                                                                    phi_3168_ = _e2565;
                                                                    phi_3169_ = _e2571;
                                                                    phi_3170_ = _e2573;
                                                                }
                                                                let _e2575 = phi_2361_;
                                                                let _e2577 = phi_3168_;
                                                                let _e2579 = phi_3169_;
                                                                let _e2581 = phi_3170_;
                                                                local_13 = _e2579;
                                                                local_14 = _e2581;
                                                                continue;
                                                                continuing {
                                                                    phi_2360_ = _e2575;
                                                                    break if !(_e2577);
                                                                }
                                                            }
                                                            let _e2584 = local_9;
                                                            if _e2584 {
                                                                let _e2586 = local_1.group_mask;
                                                                if ((_e2586 & 4278190080u) == 0u) {
                                                                    let _e2590 = local_1.len;
                                                                    if (_e2590 == 0u) {
                                                                        phi_3212_ = false;
                                                                    } else {
                                                                        let _e2594 = local_1.len;
                                                                        local_1.len = (_e2594 - 1u);
                                                                        let _e2597 = local_1.len;
                                                                        if (_e2597 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2602 = local_1.first[(0u + _e2597)];
                                                                        local_1.group = _e2602;
                                                                        let _e2605 = local_1.len;
                                                                        if (_e2605 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        let _e2610 = local_1.mask[(0u + _e2605)];
                                                                        local_1.group_mask = _e2610;
                                                                        phi_3212_ = true;
                                                                    }
                                                                    let _e2613 = phi_3212_;
                                                                    phi_3213_ = _e2613;
                                                                } else {
                                                                    phi_3213_ = true;
                                                                }
                                                                let _e2615 = phi_3213_;
                                                                if _e2615 {
                                                                    let _e2617 = local_1.group_mask;
                                                                    let _e2623 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2617)), 32u, (_e2617 == 0u)));
                                                                    let _e2627 = local_1.group_mask;
                                                                    let _e2641 = local_1.group_mask;
                                                                    local_1.group_mask = (_e2641 & ~((1u << bitcast<u32>((_e2623 & 31u)))));
                                                                    let _e2644 = local_1.group;
                                                                    phi_3244_ = (_e2644 + countOneBits(((_e2627 & ~((4294967295u << bitcast<u32>((((_e2623 - 24u) ^ _e1319) & 31u))))) & 255u)));
                                                                } else {
                                                                    phi_3244_ = 4294967295u;
                                                                }
                                                                let _e2647 = phi_3244_;
                                                                phi_3245_ = _e2647;
                                                                phi_3246_ = false;
                                                                phi_3247_ = false;
                                                            } else {
                                                                phi_3245_ = u32();
                                                                let _e3033 = local_13;
                                                                phi_3246_ = _e3033;
                                                                let _e3036 = local_14;
                                                                phi_3247_ = _e3036;
                                                            }
                                                            let _e2649 = phi_3245_;
                                                            let _e2651 = phi_3246_;
                                                            let _e2653 = phi_3247_;
                                                            phi_2031_ = _e2649;
                                                            let _e3040 = local_15;
                                                            phi_3248_ = _e3040;
                                                            phi_3249_ = false;
                                                            phi_3250_ = _e2651;
                                                            phi_3251_ = _e2653;
                                                        } else {
                                                            phi_2031_ = u32();
                                                            phi_3248_ = false;
                                                            phi_3249_ = true;
                                                            phi_3250_ = false;
                                                            phi_3251_ = false;
                                                        }
                                                        let _e2655 = phi_2031_;
                                                        let _e2657 = phi_3248_;
                                                        let _e2659 = phi_3249_;
                                                        let _e2661 = phi_3250_;
                                                        let _e2663 = phi_3251_;
                                                        local_10 = _e2659;
                                                        local_16 = _e2661;
                                                        local_17 = _e2663;
                                                        continue;
                                                        continuing {
                                                            phi_2030_ = _e2655;
                                                            break if !(_e2657);
                                                        }
                                                    }
                                                    let _e2666 = local_10;
                                                    if _e2666 {
                                                        phi_3255_ = false;
                                                        phi_3256_ = false;
                                                    } else {
                                                        let _e3047 = local_16;
                                                        phi_3255_ = _e3047;
                                                        let _e3050 = local_17;
                                                        phi_3256_ = _e3050;
                                                    }
                                                    let _e2668 = phi_3255_;
                                                    let _e2670 = phi_3256_;
                                                    if _e2668 {
                                                        phi_3260_ = true;
                                                    } else {
                                                        phi_3260_ = _e2670;
                                                    }
                                                    let _e2672 = phi_3260_;
                                                    if _e2672 {
                                                        phi_3264_ = true;
                                                    } else {
                                                        phi_3264_ = false;
                                                    }
                                                    let _e2674 = phi_3264_;
                                                    phi_3265_ = _e2674;
                                                }
                                                let _e2676 = phi_3265_;
                                                phi_3266_ = _e2676;
                                                phi_3267_ = _e1145;
                                            } else {
                                                phi_3266_ = bool();
                                                phi_3267_ = true;
                                            }
                                            let _e2678 = phi_3266_;
                                            let _e2680 = phi_3267_;
                                            if _e2680 {
                                                phi_3271_ = false;
                                            } else {
                                                phi_3271_ = _e2678;
                                            }
                                            let _e2682 = phi_3271_;
                                            if _e2682 {
                                                phi_3275_ = false;
                                            } else {
                                                phi_3275_ = true;
                                            }
                                            let _e2684 = phi_3275_;
                                            phi_3276_ = _e2684;
                                        } else {
                                            phi_3276_ = true;
                                        }
                                        let _e2686 = phi_3276_;
                                        phi_3277_ = _e2686;
                                    } else {
                                        phi_3277_ = true;
                                    }
                                    let _e2688 = phi_3277_;
                                    phi_3278_ = _e2688;
                                } else {
                                    phi_3278_ = true;
                                }
                                let _e2690 = phi_3278_;
                                if _e2690 {
                                }
                                phi_1425_ = (_e932 & (_e932 - 1u));
                                phi_3282_ = _e2690;
                            }
                            let _e2692 = phi_1425_;
                            let _e2694 = phi_3282_;
                            continue;
                            continuing {
                                phi_1424_ = _e2692;
                                break if !(_e2694);
                            }
                        }
                        let _e2697 = local_11;
                        if _e2697 {
                            let _e2699 = local_2.group_mask;
                            if ((_e2699 & 4278190080u) == 0u) {
                                let _e2703 = local_2.len;
                                if (_e2703 == 0u) {
                                    phi_3324_ = false;
                                } else {
                                    let _e2707 = local_2.len;
                                    local_2.len = (_e2707 - 1u);
                                    let _e2710 = local_2.len;
                                    if (_e2710 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2715 = local_2.first[(0u + _e2710)];
                                    local_2.group = _e2715;
                                    let _e2718 = local_2.len;
                                    if (_e2718 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e2723 = local_2.mask[(0u + _e2718)];
                                    local_2.group_mask = _e2723;
                                    phi_3324_ = true;
                                }
                                let _e2726 = phi_3324_;
                                phi_3325_ = _e2726;
                            } else {
                                phi_3325_ = true;
                            }
                            let _e2728 = phi_3325_;
                            if _e2728 {
                                let _e2730 = local_2.group_mask;
                                let _e2736 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2730)), 32u, (_e2730 == 0u)));
                                let _e2740 = local_2.group_mask;
                                let _e2754 = local_2.group_mask;
                                local_2.group_mask = (_e2754 & ~((1u << bitcast<u32>((_e2736 & 31u)))));
                                let _e2757 = local_2.group;
                                phi_3356_ = (_e2757 + countOneBits(((_e2740 & ~((4294967295u << bitcast<u32>((((_e2736 - 24u) ^ _e358) & 31u))))) & 255u)));
                            } else {
                                phi_3356_ = 4294967295u;
                            }
                            let _e2760 = phi_3356_;
                            phi_3357_ = _e2760;
                        } else {
                            phi_3357_ = u32();
                        }
                        let _e2762 = phi_3357_;
                        phi_1095_ = _e2762;
                        let _e3071 = local_18;
                        phi_3358_ = _e3071;
                        phi_3359_ = false;
                    } else {
                        phi_1095_ = u32();
                        phi_3358_ = false;
                        phi_3359_ = true;
                    }
                    let _e2764 = phi_1095_;
                    let _e2766 = phi_3358_;
                    let _e2768 = phi_3359_;
                    local_12 = _e2768;
                    continue;
                    continuing {
                        phi_1094_ = _e2764;
                        break if !(_e2766);
                    }
                }
                let _e2771 = local_12;
                if _e2771 {
                    phi_3363_ = false;
                } else {
                    phi_3363_ = true;
                }
                let _e2773 = phi_3363_;
                if _e2773 {
                    phi_3367_ = true;
                } else {
                    phi_3367_ = false;
                }
                let _e2775 = phi_3367_;
                phi_3368_ = _e2775;
            }
            let _e2777 = phi_3368_;
            phi_3369_ = _e2777;
            phi_3370_ = _e214;
        } else {
            phi_3369_ = bool();
            phi_3370_ = true;
        }
        let _e2779 = phi_3369_;
        let _e2781 = phi_3370_;
        if _e2781 {
            phi_3374_ = false;
        } else {
            phi_3374_ = _e2779;
        }
        let _e2783 = phi_3374_;
        if _e2783 {
            phi_3378_ = 0f;
        } else {
            phi_3378_ = 1f;
        }
        let _e2785 = phi_3378_;
        if (_e110 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e110)] = _e2785;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_instanced_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
