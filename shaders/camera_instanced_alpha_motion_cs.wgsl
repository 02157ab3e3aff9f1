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

struct type_13 {
    member: array<u32>,
}

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
}

struct type_26 {
    member: array<vec4<f32>>,
}

struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
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

struct type_35 {
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

struct type_39 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_43 {
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

struct type_47 {
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

struct type_61 {
    member: array<lt_bvh_Instance>,
}

struct type_65 {
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
var<storage> vertices: type_43;
@group(0) @binding(4) 
var<storage> materials: type_47;
@group(0) @binding(0) 
var<uniform> p: type_65;
@group(0) @binding(1) 
var<storage> nodes: type_35;
@group(0) @binding(2) 
var<storage> triangles: type_39;
@group(0) @binding(5) 
var<storage, read_write> samples: type_9;
@group(0) @binding(6) 
var<storage> instances: type_61;
@group(0) @binding(7) 
var<storage> alpha_texels: type_13;
@group(0) @binding(8) 
var<storage> before: type_26;
@group(0) @binding(9) 
var<storage, read_write> past: type_26;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_mask_LightPlace {
    var phi_231_: lt_mask_LightPlace;
    var phi_232_: bool;
    var phi_233_: lt_mask_LightPlace;
    var phi_234_: bool;
    var phi_239_: lt_mask_LightPlace;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_231_ = lt_mask_LightPlace(1u, ((param.y * param_1) + param.x));
            phi_232_ = false;
        } else {
            phi_231_ = lt_mask_LightPlace();
            phi_232_ = true;
        }
        let _e84 = phi_231_;
        let _e86 = phi_232_;
        phi_233_ = _e84;
        phi_234_ = _e86;
    } else {
        phi_233_ = lt_mask_LightPlace();
        phi_234_ = true;
    }
    let _e88 = phi_233_;
    let _e90 = phi_234_;
    if _e90 {
        phi_239_ = lt_mask_LightPlace(0u, lt_mask_LightPlace().shift);
    } else {
        phi_239_ = _e88;
    }
    let _e95 = phi_239_;
    return lt_mask_LightPlace(_e95.word, _e95.shift);
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_254_: bool;
    var phi_258_: f32;

    if (param_3 != param_3) {
        phi_254_ = true;
    } else {
        let _e74 = (param_4 >= param_3);
        if _e74 {
        }
        phi_254_ = _e74;
    }
    let _e76 = phi_254_;
    if _e76 {
        phi_258_ = param_4;
    } else {
        phi_258_ = param_3;
    }
    let _e78 = phi_258_;
    return _e78;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_270_: bool;
    var phi_274_: f32;

    if (param_5 != param_5) {
        phi_270_ = true;
    } else {
        let _e74 = (param_6 <= param_5);
        if _e74 {
        }
        phi_270_ = _e74;
    }
    let _e76 = phi_270_;
    if _e76 {
        phi_274_ = param_6;
    } else {
        phi_274_ = param_5;
    }
    let _e78 = phi_274_;
    return _e78;
}

fn _lt_shaders_texture_TextureView_quad(param_7: ptr<function, texture_TextureView>, param_8: f32, param_9: f32) -> texture_TexelQuad {
    var phi_316_: f32;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_323_: f32;
    var phi_324_: bool;
    var phi_328_: f32;
    var phi_354_: f32;
    var phi_359_: f32;
    var phi_360_: bool;
    var phi_361_: f32;
    var phi_362_: bool;
    var phi_366_: f32;
    var phi_374_: f32;
    var phi_375_: f32;
    var phi_376_: f32;
    var phi_385_: f32;
    var phi_386_: f32;
    var phi_404_: u32;
    var phi_418_: u32;
    var phi_425_: u32;
    var phi_430_: u32;
    var phi_436_: u32;
    var phi_441_: u32;
    var phi_443_: texture_Axis;
    var phi_471_: f32;
    var phi_476_: f32;
    var phi_477_: bool;
    var phi_478_: f32;
    var phi_479_: bool;
    var phi_483_: f32;
    var phi_509_: f32;
    var phi_514_: f32;
    var phi_515_: bool;
    var phi_516_: f32;
    var phi_517_: bool;
    var phi_521_: f32;
    var phi_529_: f32;
    var phi_530_: f32;
    var phi_531_: f32;
    var phi_540_: f32;
    var phi_541_: f32;
    var phi_559_: u32;
    var phi_573_: u32;
    var phi_580_: u32;
    var phi_585_: u32;
    var phi_591_: u32;
    var phi_596_: u32;
    var phi_598_: texture_Axis;

    let _e75 = (*param_7).size;
    let _e76 = (_e75 & 65535u);
    let _e78 = (*param_7).size;
    let _e80 = (_e78 >> bitcast<u32>(16i));
    let _e82 = (*param_7).flags;
    let _e84 = ((_e82 & 4u) != 0u);
    let _e86 = (*param_7).flags;
    let _e89 = ((_e86 >> bitcast<u32>(4u)) & 3u);
    if (_e89 == 0u) {
        if (param_8 > -8388608f) {
            let _e102 = f32(select(0i, select(select(i32(param_8), i32(-2147483648), (param_8 < bitcast<f32>(3472883712u))), 2147483647i, (param_8 > bitcast<f32>(1325400063u))), (param_8 == param_8)));
            if (_e102 > param_8) {
                phi_316_ = 1f;
            } else {
                phi_316_ = 0f;
            }
            let _e105 = phi_316_;
            if (param_8 < 8388608f) {
                phi_321_ = (_e102 - _e105);
                phi_322_ = false;
            } else {
                phi_321_ = f32();
                phi_322_ = true;
            }
            let _e108 = phi_321_;
            let _e110 = phi_322_;
            phi_323_ = _e108;
            phi_324_ = _e110;
        } else {
            phi_323_ = f32();
            phi_324_ = true;
        }
        let _e112 = phi_323_;
        let _e114 = phi_324_;
        if _e114 {
            phi_328_ = param_8;
        } else {
            phi_328_ = _e112;
        }
        let _e116 = phi_328_;
        phi_376_ = (param_8 - _e116);
    } else {
        if (_e89 == 1u) {
            let _e119 = (param_8 * 0.5f);
            if (_e119 > -8388608f) {
                let _e131 = f32(select(0i, select(select(i32(_e119), i32(-2147483648), (_e119 < bitcast<f32>(3472883712u))), 2147483647i, (_e119 > bitcast<f32>(1325400063u))), (_e119 == _e119)));
                if (_e131 > _e119) {
                    phi_354_ = 1f;
                } else {
                    phi_354_ = 0f;
                }
                let _e134 = phi_354_;
                if (_e119 < 8388608f) {
                    phi_359_ = (_e131 - _e134);
                    phi_360_ = false;
                } else {
                    phi_359_ = f32();
                    phi_360_ = true;
                }
                let _e137 = phi_359_;
                let _e139 = phi_360_;
                phi_361_ = _e137;
                phi_362_ = _e139;
            } else {
                phi_361_ = f32();
                phi_362_ = true;
            }
            let _e141 = phi_361_;
            let _e143 = phi_362_;
            if _e143 {
                phi_366_ = _e119;
            } else {
                phi_366_ = _e141;
            }
            let _e145 = phi_366_;
            let _e147 = (param_8 - (2f * _e145));
            if (_e147 > 1f) {
                phi_374_ = (2f - _e147);
            } else {
                phi_374_ = _e147;
            }
            let _e151 = phi_374_;
            phi_375_ = _e151;
        } else {
            phi_375_ = param_8;
        }
        let _e153 = phi_375_;
        phi_376_ = _e153;
    }
    let _e155 = phi_376_;
    if (_e155 > 0f) {
        if (_e155 < 1f) {
            phi_385_ = _e155;
        } else {
            phi_385_ = 1f;
        }
        let _e159 = phi_385_;
        phi_386_ = _e159;
    } else {
        phi_386_ = 0f;
    }
    let _e161 = phi_386_;
    let _e162 = (_e76 - 1u);
    let _e164 = (_e161 * f32(_e76));
    if _e84 {
        let _e171 = select(select(u32(_e164), 0u, (_e164 < bitcast<f32>(0u))), 4294967295u, (_e164 > bitcast<f32>(1333788671u)));
        if (_e162 < _e171) {
            phi_404_ = _e162;
        } else {
            phi_404_ = _e171;
        }
        let _e174 = phi_404_;
        phi_443_ = texture_Axis(_e174, _e174, 0f);
    } else {
        let _e176 = (_e164 + 0.5f);
        let _e183 = select(select(u32(_e176), 0u, (_e176 < bitcast<f32>(0u))), 4294967295u, (_e176 > bitcast<f32>(1333788671u)));
        if (_e76 < _e183) {
            phi_418_ = _e76;
        } else {
            phi_418_ = _e183;
        }
        let _e186 = phi_418_;
        if (_e89 == 0u) {
            phi_425_ = _e162;
        } else {
            phi_425_ = 0u;
        }
        let _e191 = phi_425_;
        if (_e89 == 0u) {
            phi_430_ = 0u;
        } else {
            phi_430_ = _e162;
        }
        let _e194 = phi_430_;
        if (_e186 == 0u) {
            phi_436_ = _e191;
        } else {
            phi_436_ = (_e186 - 1u);
        }
        let _e198 = phi_436_;
        if (_e186 > _e162) {
            phi_441_ = _e194;
        } else {
            phi_441_ = _e186;
        }
        let _e201 = phi_441_;
        phi_443_ = texture_Axis(_e198, _e201, (_e176 - f32(_e186)));
    }
    let _e204 = phi_443_;
    let _e206 = (*param_7).flags;
    let _e209 = ((_e206 >> bitcast<u32>(6u)) & 3u);
    if (_e209 == 0u) {
        if (param_9 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(param_9), i32(-2147483648), (param_9 < bitcast<f32>(3472883712u))), 2147483647i, (param_9 > bitcast<f32>(1325400063u))), (param_9 == param_9)));
            if (_e222 > param_9) {
                phi_471_ = 1f;
            } else {
                phi_471_ = 0f;
            }
            let _e225 = phi_471_;
            if (param_9 < 8388608f) {
                phi_476_ = (_e222 - _e225);
                phi_477_ = false;
            } else {
                phi_476_ = f32();
                phi_477_ = true;
            }
            let _e228 = phi_476_;
            let _e230 = phi_477_;
            phi_478_ = _e228;
            phi_479_ = _e230;
        } else {
            phi_478_ = f32();
            phi_479_ = true;
        }
        let _e232 = phi_478_;
        let _e234 = phi_479_;
        if _e234 {
            phi_483_ = param_9;
        } else {
            phi_483_ = _e232;
        }
        let _e236 = phi_483_;
        phi_531_ = (param_9 - _e236);
    } else {
        if (_e209 == 1u) {
            let _e239 = (param_9 * 0.5f);
            if (_e239 > -8388608f) {
                let _e251 = f32(select(0i, select(select(i32(_e239), i32(-2147483648), (_e239 < bitcast<f32>(3472883712u))), 2147483647i, (_e239 > bitcast<f32>(1325400063u))), (_e239 == _e239)));
                if (_e251 > _e239) {
                    phi_509_ = 1f;
                } else {
                    phi_509_ = 0f;
                }
                let _e254 = phi_509_;
                if (_e239 < 8388608f) {
                    phi_514_ = (_e251 - _e254);
                    phi_515_ = false;
                } else {
                    phi_514_ = f32();
                    phi_515_ = true;
                }
                let _e257 = phi_514_;
                let _e259 = phi_515_;
                phi_516_ = _e257;
                phi_517_ = _e259;
            } else {
                phi_516_ = f32();
                phi_517_ = true;
            }
            let _e261 = phi_516_;
            let _e263 = phi_517_;
            if _e263 {
                phi_521_ = _e239;
            } else {
                phi_521_ = _e261;
            }
            let _e265 = phi_521_;
            let _e267 = (param_9 - (2f * _e265));
            if (_e267 > 1f) {
                phi_529_ = (2f - _e267);
            } else {
                phi_529_ = _e267;
            }
            let _e271 = phi_529_;
            phi_530_ = _e271;
        } else {
            phi_530_ = param_9;
        }
        let _e273 = phi_530_;
        phi_531_ = _e273;
    }
    let _e275 = phi_531_;
    if (_e275 > 0f) {
        if (_e275 < 1f) {
            phi_540_ = _e275;
        } else {
            phi_540_ = 1f;
        }
        let _e279 = phi_540_;
        phi_541_ = _e279;
    } else {
        phi_541_ = 0f;
    }
    let _e281 = phi_541_;
    let _e282 = (_e80 - 1u);
    let _e284 = (_e281 * f32(_e80));
    if _e84 {
        let _e291 = select(select(u32(_e284), 0u, (_e284 < bitcast<f32>(0u))), 4294967295u, (_e284 > bitcast<f32>(1333788671u)));
        if (_e282 < _e291) {
            phi_559_ = _e282;
        } else {
            phi_559_ = _e291;
        }
        let _e294 = phi_559_;
        phi_598_ = texture_Axis(_e294, _e294, 0f);
    } else {
        let _e296 = (_e284 + 0.5f);
        let _e303 = select(select(u32(_e296), 0u, (_e296 < bitcast<f32>(0u))), 4294967295u, (_e296 > bitcast<f32>(1333788671u)));
        if (_e80 < _e303) {
            phi_573_ = _e80;
        } else {
            phi_573_ = _e303;
        }
        let _e306 = phi_573_;
        if (_e209 == 0u) {
            phi_580_ = _e282;
        } else {
            phi_580_ = 0u;
        }
        let _e311 = phi_580_;
        if (_e209 == 0u) {
            phi_585_ = 0u;
        } else {
            phi_585_ = _e282;
        }
        let _e314 = phi_585_;
        if (_e306 == 0u) {
            phi_591_ = _e311;
        } else {
            phi_591_ = (_e306 - 1u);
        }
        let _e318 = phi_591_;
        if (_e306 > _e282) {
            phi_596_ = _e314;
        } else {
            phi_596_ = _e306;
        }
        let _e321 = phi_596_;
        phi_598_ = texture_Axis(_e318, _e321, (_e296 - f32(_e306)));
    }
    let _e324 = phi_598_;
    let _e328 = (*param_7).offset;
    let _e335 = (*param_7).offset;
    let _e342 = (*param_7).offset;
    let _e349 = (*param_7).offset;
    return texture_TexelQuad(array<u32, 4>(((_e328 + (_e324.low * _e76)) + _e204.low), ((_e335 + (_e324.low * _e76)) + _e204.high), ((_e342 + (_e324.high * _e76)) + _e204.low), ((_e349 + (_e324.high * _e76)) + _e204.high)), vec4<f32>(((1f - _e204.fraction) * (1f - _e324.fraction)), (_e204.fraction * (1f - _e324.fraction)), ((1f - _e204.fraction) * _e324.fraction), (_e204.fraction * _e324.fraction)));
}

fn _lt_bvh_ray_Ray_new(param_10: vec3<f32>, param_11: vec3<f32>) -> lt_bvh_Ray {
    return lt_bvh_Ray(param_10, 0f, param_11, 300000000000000000000000000000000000000f);
}

fn _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(param_12: f32, param_13: f32) -> f32 {
    var phi_657_: f32;

    if (param_12 > param_13) {
        phi_657_ = param_12;
    } else {
        phi_657_ = param_13;
    }
    let _e75 = phi_657_;
    return _e75;
}

fn _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(param_14: vec3<f32>) -> vec3<f32> {
    return vec3<f32>(1f, 1f, 1f);
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: lt_bvh_traverse_Stack;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_804_: bool;
    var phi_817_: bool;
    var phi_818_: bool;
    var phi_819_: bool;
    var phi_820_: bool;
    var phi_824_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_843_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_847_: bool;
    var phi_851_: bool;
    var phi_927_: f32;
    var phi_934_: f32;
    var phi_942_: f32;
    var phi_949_: f32;
    var phi_957_: f32;
    var phi_964_: f32;
    var phi_987_: f32;
    var phi_992_: f32;
    var phi_997_: f32;
    var phi_1002_: f32;
    var phi_1007_: f32;
    var phi_1026_: u32;
    var phi_1031_: u32;
    var phi_1036_: u32;
    var phi_1150_: bool;
    var phi_1151_: bool;
    var phi_1182_: u32;
    var phi_1184_: u32;
    var phi_1187_: lt_bvh_Hit;
    var phi_1272_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1299_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1326_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1332_: u32;
    var phi_1335_: u32;
    var phi_1349_: u32;
    var phi_1359_: u32;
    var phi_1369_: u32;
    var phi_1387_: u32;
    var phi_1397_: u32;
    var phi_1407_: u32;
    var phi_1443_: u32;
    var phi_1456_: u32;
    var phi_1461_: u32;
    var phi_1462_: u32;
    var phi_1463_: u32;
    var phi_1333_: u32;
    var phi_1336_: u32;
    var local_3: u32;
    var local_4: u32;
    var local_5: u32;
    var phi_1521_: u32;
    var phi_1524_: lt_bvh_Hit;
    var phi_1579_: f32;
    var phi_1584_: f32;
    var phi_1589_: f32;
    var phi_1597_: f32;
    var phi_1602_: f32;
    var phi_1607_: f32;
    var phi_1739_: bool;
    var phi_1740_: bool;
    var phi_1741_: bool;
    var phi_1742_: bool;
    var phi_1746_: bool;
    var phi_1759_: bool;
    var phi_1760_: bool;
    var phi_1761_: bool;
    var phi_1762_: bool;
    var phi_1766_: bool;
    var phi_1779_: bool;
    var phi_1780_: bool;
    var phi_1781_: bool;
    var phi_1785_: bool;
    var phi_1786_: bool;
    var phi_1787_: bool;
    var phi_1788_: bool;
    var phi_1789_: bool;
    var phi_1793_: bool;
    var phi_1863_: f32;
    var phi_1870_: f32;
    var phi_1877_: f32;
    var phi_1884_: f32;
    var phi_1891_: f32;
    var phi_1898_: f32;
    var phi_1915_: f32;
    var phi_1920_: f32;
    var phi_1925_: f32;
    var phi_1930_: f32;
    var phi_1935_: f32;
    var phi_1961_: bool;
    var phi_1962_: bool;
    var phi_1970_: u32;
    var phi_1971_: u32;
    var phi_1982_: vec3<f32>;
    var phi_1983_: vec3<f32>;
    var phi_1996_: u32;
    var phi_2001_: u32;
    var phi_2006_: u32;
    var phi_2120_: bool;
    var phi_2121_: bool;
    var phi_2152_: u32;
    var phi_2154_: lt_bvh_Hit;
    var phi_2157_: u32;
    var phi_2238_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2265_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2292_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2298_: u32;
    var phi_2301_: u32;
    var phi_2315_: u32;
    var phi_2325_: u32;
    var phi_2335_: u32;
    var phi_2353_: u32;
    var phi_2363_: u32;
    var phi_2373_: u32;
    var phi_2409_: u32;
    var phi_2422_: u32;
    var phi_2427_: u32;
    var phi_2428_: u32;
    var phi_2429_: u32;
    var phi_2299_: u32;
    var phi_2302_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_2487_: lt_bvh_Hit;
    var phi_2490_: u32;
    var phi_2534_: vec3<f32>;
    var phi_2535_: vec3<f32>;
    var phi_2564_: vec3<f32>;
    var phi_2565_: vec3<f32>;
    var phi_2594_: vec3<f32>;
    var phi_2595_: vec3<f32>;
    var phi_2613_: bool;
    var phi_2614_: bool;
    var phi_2618_: f32;
    var phi_2619_: f32;
    var phi_2620_: f32;
    var phi_2621_: f32;
    var phi_2629_: f32;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2644_: f32;
    var phi_2645_: f32;
    var phi_2646_: f32;
    var phi_2647_: f32;
    var phi_2655_: f32;
    var phi_2665_: bool;
    var phi_2666_: bool;
    var phi_2670_: f32;
    var phi_2671_: f32;
    var phi_2672_: f32;
    var phi_2673_: f32;
    var phi_2681_: f32;
    var phi_2696_: f32;
    var phi_2697_: bool;
    var phi_2698_: f32;
    var phi_2699_: bool;
    var phi_2700_: f32;
    var phi_2701_: bool;
    var phi_2719_: f32;
    var phi_2720_: bool;
    var phi_2721_: bool;
    var phi_2722_: f32;
    var phi_2723_: bool;
    var phi_2724_: bool;
    var phi_2728_: bool;
    var phi_2729_: f32;
    var phi_2730_: bool;
    var phi_2758_: vec3<f32>;
    var phi_2759_: vec3<f32>;
    var phi_2784_: vec3<f32>;
    var phi_2785_: vec3<f32>;
    var phi_2810_: vec3<f32>;
    var phi_2811_: vec3<f32>;
    var phi_2867_: f32;
    var phi_2876_: f32;
    var phi_2885_: f32;
    var phi_2894_: f32;
    var phi_2901_: f32;
    var phi_2908_: f32;
    var phi_2921_: f32;
    var phi_2930_: f32;
    var phi_2939_: f32;
    var phi_2948_: f32;
    var phi_2955_: f32;
    var phi_2962_: f32;
    var phi_2979_: f32;
    var phi_2984_: f32;
    var phi_2989_: f32;
    var phi_2997_: f32;
    var phi_3002_: f32;
    var phi_3007_: f32;
    var phi_3019_: f32;
    var phi_3024_: f32;
    var phi_3029_: f32;
    var phi_3034_: f32;
    var phi_3039_: lt_bvh_triangle_Intersection;
    var phi_3040_: bool;
    var phi_3041_: lt_bvh_triangle_Intersection;
    var phi_3042_: bool;
    var phi_3046_: lt_bvh_triangle_Intersection;
    var phi_3047_: bool;
    var phi_3048_: lt_bvh_triangle_Intersection;
    var phi_3049_: bool;
    var phi_3050_: bool;
    var phi_3054_: bool;
    var phi_3058_: lt_bvh_triangle_Intersection;
    var phi_3096_: bool;
    var phi_3097_: bool;
    var phi_3098_: bool;
    var phi_3099_: bool;
    var phi_3100_: bool;
    var phi_3101_: bool;
    var phi_3105_: bool;
    var phi_3106_: bool;
    var phi_3309_: f32;
    var phi_3312_: bool;
    var phi_3313_: bool;
    var phi_3317_: bool;
    var phi_3325_: lt_bvh_Hit;
    var phi_3326_: lt_bvh_Hit;
    var phi_3327_: lt_bvh_Hit;
    var phi_3328_: lt_bvh_Hit;
    var phi_2488_: lt_bvh_Hit;
    var phi_2491_: u32;
    var phi_3329_: bool;
    var phi_3368_: bool;
    var phi_3369_: bool;
    var phi_3400_: u32;
    var phi_2155_: lt_bvh_Hit;
    var phi_2158_: u32;
    var phi_3401_: lt_bvh_Hit;
    var phi_3402_: lt_bvh_Hit;
    var phi_3403_: bool;
    var phi_3407_: lt_bvh_Hit;
    var phi_3408_: lt_bvh_Hit;
    var phi_3409_: lt_bvh_Hit;
    var phi_3410_: lt_bvh_Hit;
    var phi_1522_: u32;
    var phi_1525_: lt_bvh_Hit;
    var phi_3411_: bool;
    var phi_3450_: bool;
    var phi_3451_: bool;
    var phi_3482_: u32;
    var phi_1185_: u32;
    var phi_1188_: lt_bvh_Hit;
    var phi_3483_: lt_bvh_Hit;
    var phi_3484_: lt_bvh_Hit;
    var phi_3485_: bool;
    var phi_3489_: lt_bvh_Hit;
    var phi_3677_: f32;
    var phi_3682_: f32;
    var phi_3687_: f32;
    var phi_3695_: f32;
    var phi_3700_: f32;
    var phi_3705_: f32;
    var phi_3769_: vec3<f32>;
    var phi_3890_: u32;
    var phi_3917_: f32;
    var phi_3924_: f32;
    var phi_3931_: f32;
    var phi_3966_: f32;
    var phi_3973_: f32;
    var phi_3980_: f32;
    var phi_4018_: f32;
    var phi_4025_: f32;
    var phi_4032_: f32;
    var phi_4118_: vec3<f32>;
    var phi_4119_: vec3<f32>;
    var phi_4120_: vec3<f32>;
    var phi_4129_: f32;
    var phi_4130_: f32;
    var phi_4140_: f32;
    var phi_4141_: f32;
    var phi_4151_: f32;
    var phi_4152_: f32;
    var phi_4187_: abi_Sample;
    var phi_4410_: vec3<f32>;
    var local_9: lt_bvh_Hit;
    var local_10: lt_bvh_Hit;
    var local_11: lt_bvh_Hit;
    var local_12: lt_bvh_Hit;

    let _e74 = id_1;
    let _e78 = arrayLength((&nodes.member));
    let _e81 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&vertices.member));
    let _e87 = arrayLength((&materials.member));
    let _e93 = arrayLength((&instances.member));
    let _e96 = arrayLength((&alpha_texels.member));
    let _e99 = arrayLength((&before.member));
    let _e105 = p.member.size[0u];
    let _e107 = p.member.size[1u];
    let _e108 = lt_shaders_entry_pixel_index(_e74, _e105, _e107);
    if (bitcast<i32>(_e108.word) != 0i) {
        let _e114 = p.member.root;
        let _e118 = p.member.eye;
        let _e123 = p.member.size[0u];
        let _e127 = ((((f32(_e74.x) + 0.5f) / f32(_e123)) * 2f) - 1f);
        let _e132 = p.member.size[1u];
        let _e136 = (1f - (((f32(_e74.y) + 0.5f) / f32(_e132)) * 2f));
        let _e138 = p.member.forward;
        let _e140 = p.member.right;
        let _e154 = p.member.up;
        let _e165 = _lt_bvh_ray_Ray_new(_e118, vec3<f32>(((_e138.x + (_e140.x * _e127)) + (_e154.x * _e136)), ((_e138.y + (_e140.y * _e127)) + (_e154.y * _e136)), ((_e138.z + (_e140.z * _e127)) + (_e154.z * _e136))));
        let _e167 = lt_bvh_Hit(_e165.tmax, 0f, 0f, 4294967295u, 4294967295u);
        let _e170 = abs(_e165.direction.x);
        let _e172 = abs(_e165.direction.y);
        let _e174 = abs(_e165.direction.z);
        if (abs(_e165.origin.x) < 1000000000000000f) {
            if (abs(_e165.origin.y) < 1000000000000000f) {
                phi_797_ = (abs(_e165.origin.z) < 1000000000000000f);
                phi_798_ = false;
            } else {
                phi_797_ = bool();
                phi_798_ = true;
            }
            let _e186 = phi_797_;
            let _e188 = phi_798_;
            phi_799_ = _e186;
            phi_800_ = _e188;
        } else {
            phi_799_ = bool();
            phi_800_ = true;
        }
        let _e190 = phi_799_;
        let _e192 = phi_800_;
        if _e192 {
            phi_804_ = false;
        } else {
            phi_804_ = _e190;
        }
        let _e194 = phi_804_;
        if _e194 {
            if (_e170 < 1000000000000000f) {
                if (_e172 < 1000000000000000f) {
                    phi_817_ = (_e174 < 1000000000000000f);
                    phi_818_ = false;
                } else {
                    phi_817_ = bool();
                    phi_818_ = true;
                }
                let _e199 = phi_817_;
                let _e201 = phi_818_;
                phi_819_ = _e199;
                phi_820_ = _e201;
            } else {
                phi_819_ = bool();
                phi_820_ = true;
            }
            let _e203 = phi_819_;
            let _e205 = phi_820_;
            if _e205 {
                phi_824_ = false;
            } else {
                phi_824_ = _e203;
            }
            let _e207 = phi_824_;
            if _e207 {
                if (_e170 > 0f) {
                    phi_838_ = bool();
                    phi_839_ = true;
                } else {
                    let _e209 = (_e172 > 0f);
                    if _e209 {
                        phi_837_ = bool();
                    } else {
                        phi_837_ = (_e174 > 0f);
                    }
                    let _e212 = phi_837_;
                    phi_838_ = _e212;
                    phi_839_ = _e209;
                }
                let _e214 = phi_838_;
                let _e216 = phi_839_;
                if _e216 {
                    phi_843_ = true;
                } else {
                    phi_843_ = _e214;
                }
                let _e218 = phi_843_;
                phi_844_ = _e218;
                phi_845_ = false;
            } else {
                phi_844_ = bool();
                phi_845_ = true;
            }
            let _e220 = phi_844_;
            let _e222 = phi_845_;
            phi_846_ = _e220;
            phi_847_ = _e222;
        } else {
            phi_846_ = bool();
            phi_847_ = true;
        }
        let _e224 = phi_846_;
        let _e226 = phi_847_;
        if _e226 {
            phi_851_ = false;
        } else {
            phi_851_ = _e224;
        }
        let _e228 = phi_851_;
        if _e228 {
            let _e229 = (_e114 >= _e78);
            if _e229 {
                phi_3483_ = lt_bvh_Hit();
            } else {
                if (_e114 < _e78) {
                } else {
                    return;
                }
                let _e235 = nodes.member[(0u + _e114)].frame[0u];
                let _e239 = nodes.member[(0u + _e114)].frame[1u];
                let _e243 = nodes.member[(0u + _e114)].frame[2u];
                let _e247 = nodes.member[(0u + _e114)].frame[0u];
                let _e251 = nodes.member[(0u + _e114)].frame[1u];
                let _e255 = nodes.member[(0u + _e114)].frame[2u];
                let _e259 = nodes.member[(0u + _e114)].frame[3u];
                let _e298 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165.direction.x), abs(_e165.direction.y));
                let _e299 = core_intrinsics_maximum_number_nsz_f32_(_e298, abs(_e165.direction.z));
                let _e300 = (_e299 * 0.0000000000009094947f);
                if (abs(_e165.direction.x) < _e300) {
                    phi_927_ = _e300;
                } else {
                    phi_927_ = abs(_e165.direction.x);
                }
                let _e306 = phi_927_;
                if (_e165.direction.x < 0f) {
                    phi_934_ = (-1f / _e306);
                } else {
                    phi_934_ = (1f / _e306);
                }
                let _e311 = phi_934_;
                if (abs(_e165.direction.y) < _e300) {
                    phi_942_ = _e300;
                } else {
                    phi_942_ = abs(_e165.direction.y);
                }
                let _e317 = phi_942_;
                if (_e165.direction.y < 0f) {
                    phi_949_ = (-1f / _e317);
                } else {
                    phi_949_ = (1f / _e317);
                }
                let _e322 = phi_949_;
                if (abs(_e165.direction.z) < _e300) {
                    phi_957_ = _e300;
                } else {
                    phi_957_ = abs(_e165.direction.z);
                }
                let _e328 = phi_957_;
                if (_e165.direction.z < 0f) {
                    phi_964_ = (-1f / _e328);
                } else {
                    phi_964_ = (1f / _e328);
                }
                let _e333 = phi_964_;
                let _e340 = abs((bitcast<f32>(_e235) - _e165.origin.x));
                let _e341 = abs((bitcast<f32>(_e239) - _e165.origin.y));
                let _e342 = abs((bitcast<f32>(_e243) - _e165.origin.z));
                let _e349 = abs(((bitcast<f32>(_e247) + (bitcast<f32>((((_e259 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.x));
                let _e350 = abs(((bitcast<f32>(_e251) + (bitcast<f32>((((_e259 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.y));
                let _e351 = abs(((bitcast<f32>(_e255) + (bitcast<f32>((((_e259 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e165.origin.z));
                if (_e340 > _e349) {
                    phi_987_ = _e340;
                } else {
                    phi_987_ = _e349;
                }
                let _e354 = phi_987_;
                if (_e341 > _e350) {
                    phi_992_ = _e341;
                } else {
                    phi_992_ = _e350;
                }
                let _e357 = phi_992_;
                if (_e342 > _e351) {
                    phi_997_ = _e342;
                } else {
                    phi_997_ = _e351;
                }
                let _e360 = phi_997_;
                if (_e354 > _e357) {
                    phi_1002_ = _e354;
                } else {
                    phi_1002_ = _e357;
                }
                let _e363 = phi_1002_;
                if (_e363 > _e360) {
                    phi_1007_ = _e363;
                } else {
                    phi_1007_ = _e360;
                }
                let _e366 = phi_1007_;
                let _e370 = (_e366 * 0.0000019073486f);
                let _e371 = (abs(_e311) * _e370);
                let _e372 = (abs(_e322) * _e370);
                let _e373 = (abs(_e333) * _e370);
                let _e377 = (_e366 * 0.0000009536743f);
                let _e378 = (abs(_e311) * _e377);
                let _e379 = (abs(_e322) * _e377);
                let _e380 = (abs(_e333) * _e377);
                if (_e311 < 0f) {
                    phi_1026_ = 0u;
                } else {
                    phi_1026_ = 1u;
                }
                let _e383 = phi_1026_;
                if (_e322 < 0f) {
                    phi_1031_ = 0u;
                } else {
                    phi_1031_ = 2u;
                }
                let _e386 = phi_1031_;
                if (_e333 < 0f) {
                    phi_1036_ = 0u;
                } else {
                    phi_1036_ = 4u;
                }
                let _e389 = phi_1036_;
                let _e391 = ((_e383 | _e386) | _e389);
                let _e392 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e114, 2147483648u);
                local_2 = lt_bvh_traverse_Stack(array<u32, 32>(_e392.first[0], _e392.first[1], _e392.first[2], _e392.first[3], _e392.first[4], _e392.first[5], _e392.first[6], _e392.first[7], _e392.first[8], _e392.first[9], _e392.first[10], _e392.first[11], _e392.first[12], _e392.first[13], _e392.first[14], _e392.first[15], _e392.first[16], _e392.first[17], _e392.first[18], _e392.first[19], _e392.first[20], _e392.first[21], _e392.first[22], _e392.first[23], _e392.first[24], _e392.first[25], _e392.first[26], _e392.first[27], _e392.first[28], _e392.first[29], _e392.first[30], _e392.first[31]), array<u32, 32>(_e392.mask[0], _e392.mask[1], _e392.mask[2], _e392.mask[3], _e392.mask[4], _e392.mask[5], _e392.mask[6], _e392.mask[7], _e392.mask[8], _e392.mask[9], _e392.mask[10], _e392.mask[11], _e392.mask[12], _e392.mask[13], _e392.mask[14], _e392.mask[15], _e392.mask[16], _e392.mask[17], _e392.mask[18], _e392.mask[19], _e392.mask[20], _e392.mask[21], _e392.mask[22], _e392.mask[23], _e392.mask[24], _e392.mask[25], _e392.mask[26], _e392.mask[27], _e392.mask[28], _e392.mask[29], _e392.mask[30], _e392.mask[31]), _e392.len, _e392.group, _e392.group_mask);
                let _e466 = local_2.group_mask;
                if ((_e466 & 4278190080u) == 0u) {
                    let _e470 = local_2.len;
                    if (_e470 == 0u) {
                        phi_1150_ = false;
                    } else {
                        let _e474 = local_2.len;
                        local_2.len = (_e474 - 1u);
                        let _e477 = local_2.len;
                        if (_e477 < 32u) {
                        } else {
                            return;
                        }
                        let _e482 = local_2.first[(0u + _e477)];
                        local_2.group = _e482;
                        let _e485 = local_2.len;
                        if (_e485 < 32u) {
                        } else {
                            return;
                        }
                        let _e490 = local_2.mask[(0u + _e485)];
                        local_2.group_mask = _e490;
                        phi_1150_ = true;
                    }
                    let _e493 = phi_1150_;
                    phi_1151_ = _e493;
                } else {
                    phi_1151_ = true;
                }
                let _e495 = phi_1151_;
                if _e495 {
                    let _e497 = local_2.group_mask;
                    let _e503 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e497)), 32u, (_e497 == 0u)));
                    let _e507 = local_2.group_mask;
                    let _e521 = local_2.group_mask;
                    local_2.group_mask = (_e521 & ~((1u << bitcast<u32>((_e503 & 31u)))));
                    let _e524 = local_2.group;
                    phi_1182_ = (_e524 + countOneBits(((_e507 & ~((4294967295u << bitcast<u32>((((_e503 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1182_ = 4294967295u;
                }
                let _e527 = phi_1182_;
                phi_1184_ = _e527;
                phi_1187_ = _e167;
                loop {
                    let _e529 = phi_1184_;
                    let _e531 = phi_1187_;
                    local_12 = _e531;
                    let _e532 = (_e529 != 4294967295u);
                    if _e532 {
                        if (_e529 < _e78) {
                        } else {
                            return;
                        }
                        let _e540 = nodes.member[(0u + _e529)].frame[3u];
                        let _e565 = (bitcast<f32>((((_e540 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e311);
                        let _e566 = (bitcast<f32>((((_e540 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e322);
                        let _e567 = (bitcast<f32>((((_e540 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e333);
                        let _e570 = nodes.member[(0u + _e529)].frame[0u];
                        let _e574 = nodes.member[(0u + _e529)].frame[1u];
                        let _e578 = nodes.member[(0u + _e529)].frame[2u];
                        let _e586 = ((bitcast<f32>(_e570) - _e165.origin.x) * _e311);
                        let _e587 = ((bitcast<f32>(_e574) - _e165.origin.y) * _e322);
                        let _e588 = ((bitcast<f32>(_e578) - _e165.origin.z) * _e333);
                        let _e596 = nodes.member[(0u + _e529)].x;
                        if (_e311 < 0f) {
                            let _e607 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e596.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e613 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e607.unnamed.word, _e596.w), _e607.unnamed_1);
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e613.unnamed, lt_mask_LightPlace(_e596.x, _e613.unnamed_1.shift));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e619.unnamed, lt_mask_LightPlace(_e619.unnamed_1.word, _e596.y));
                        } else {
                            let _e635 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e596.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e641 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e635.unnamed.word, _e596.y), _e635.unnamed_1);
                            let _e647 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e641.unnamed, lt_mask_LightPlace(_e596.z, _e641.unnamed_1.shift));
                            phi_1272_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e647.unnamed, lt_mask_LightPlace(_e647.unnamed_1.word, _e596.w));
                        }
                        let _e655 = phi_1272_;
                        let _e665 = nodes.member[(0u + _e529)].y;
                        if (_e322 < 0f) {
                            let _e676 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e665.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e682 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e676.unnamed.word, _e665.w), _e676.unnamed_1);
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e682.unnamed, lt_mask_LightPlace(_e665.x, _e682.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e688.unnamed, lt_mask_LightPlace(_e688.unnamed_1.word, _e665.y));
                        } else {
                            let _e704 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e665.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e710 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e704.unnamed.word, _e665.y), _e704.unnamed_1);
                            let _e716 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e710.unnamed, lt_mask_LightPlace(_e665.z, _e710.unnamed_1.shift));
                            phi_1299_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e716.unnamed, lt_mask_LightPlace(_e716.unnamed_1.word, _e665.w));
                        }
                        let _e724 = phi_1299_;
                        let _e734 = nodes.member[(0u + _e529)].z;
                        if (_e333 < 0f) {
                            let _e745 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e734.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e751 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e745.unnamed.word, _e734.w), _e745.unnamed_1);
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e751.unnamed, lt_mask_LightPlace(_e734.x, _e751.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e757.unnamed, lt_mask_LightPlace(_e757.unnamed_1.word, _e734.y));
                        } else {
                            let _e773 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e734.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e779 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e773.unnamed.word, _e734.y), _e773.unnamed_1);
                            let _e785 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e779.unnamed, lt_mask_LightPlace(_e734.z, _e779.unnamed_1.shift));
                            phi_1326_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e785.unnamed, lt_mask_LightPlace(_e785.unnamed_1.word, _e734.w));
                        }
                        let _e793 = phi_1326_;
                        phi_1332_ = 0u;
                        phi_1335_ = 0u;
                        loop {
                            let _e803 = phi_1332_;
                            let _e805 = phi_1335_;
                            local_3 = _e805;
                            local_4 = _e805;
                            local_5 = _e805;
                            let _e806 = (_e803 < 8u);
                            if _e806 {
                                let _e808 = (_e803 >> bitcast<u32>(2i));
                                let _e809 = (_e803 & 3u);
                                if (_e808 == 0u) {
                                    phi_1349_ = _e655.unnamed.word;
                                } else {
                                    phi_1349_ = _e655.unnamed.shift;
                                }
                                let _e812 = phi_1349_;
                                if (_e808 == 0u) {
                                    phi_1359_ = _e724.unnamed.word;
                                } else {
                                    phi_1359_ = _e724.unnamed.shift;
                                }
                                let _e821 = phi_1359_;
                                if (_e808 == 0u) {
                                    phi_1369_ = _e793.unnamed.word;
                                } else {
                                    phi_1369_ = _e793.unnamed.shift;
                                }
                                let _e830 = phi_1369_;
                                let _e843 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e812 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e565) + (_e586 - _e371)), ((f32(((_e821 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e566) + (_e587 - _e372)));
                                let _e844 = core_intrinsics_maximum_number_nsz_f32_(_e843, ((f32(((_e830 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e567) + (_e588 - _e373)));
                                if (_e808 == 0u) {
                                    phi_1387_ = _e655.unnamed_1.word;
                                } else {
                                    phi_1387_ = _e655.unnamed_1.shift;
                                }
                                let _e847 = phi_1387_;
                                if (_e808 == 0u) {
                                    phi_1397_ = _e724.unnamed_1.word;
                                } else {
                                    phi_1397_ = _e724.unnamed_1.shift;
                                }
                                let _e856 = phi_1397_;
                                if (_e808 == 0u) {
                                    phi_1407_ = _e793.unnamed_1.word;
                                } else {
                                    phi_1407_ = _e793.unnamed_1.shift;
                                }
                                let _e865 = phi_1407_;
                                let _e878 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e847 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e565) + (_e586 + _e371)), ((f32(((_e856 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e566) + (_e587 + _e372)));
                                let _e879 = core_intrinsics_minimum_number_nsz_f32_(_e878, ((f32(((_e865 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u)) * _e567) + (_e588 + _e373)));
                                if (_e844 <= _e879) {
                                    if (_e844 <= _e531.t) {
                                        if (_e879 >= _e165.tmin) {
                                            if (_e808 == 0u) {
                                                let _e886 = nodes.member[(0u + _e529)].links[2u];
                                                phi_1443_ = _e886;
                                            } else {
                                                let _e889 = nodes.member[(0u + _e529)].links[3u];
                                                phi_1443_ = _e889;
                                            }
                                            let _e891 = phi_1443_;
                                            let _e896 = ((_e891 >> bitcast<u32>(((_e809 * 8u) & 31u))) & 255u);
                                            let _e897 = (_e896 & 31u);
                                            if (_e897 >= 24u) {
                                                phi_1456_ = (24u + ((_e897 - 24u) ^ _e391));
                                            } else {
                                                phi_1456_ = _e897;
                                            }
                                            let _e903 = phi_1456_;
                                            phi_1461_ = (_e805 | ((_e896 >> bitcast<u32>(5i)) << bitcast<u32>((_e903 & 31u))));
                                        } else {
                                            phi_1461_ = _e805;
                                        }
                                        let _e911 = phi_1461_;
                                        phi_1462_ = _e911;
                                    } else {
                                        phi_1462_ = _e805;
                                    }
                                    let _e913 = phi_1462_;
                                    phi_1463_ = _e913;
                                } else {
                                    phi_1463_ = _e805;
                                }
                                let _e915 = phi_1463_;
                                phi_1333_ = (_e803 + 1u);
                                phi_1336_ = _e915;
                            } else {
                                phi_1333_ = u32();
                                phi_1336_ = u32();
                            }
                            let _e918 = phi_1333_;
                            let _e920 = phi_1336_;
                            continue;
                            continuing {
                                phi_1332_ = _e918;
                                phi_1335_ = _e920;
                                break if !(_e806);
                            }
                        }
                        let _e924 = nodes.member[(0u + _e529)].links[0u];
                        let _e928 = nodes.member[(0u + _e529)].frame[3u];
                        let _e932 = local_3;
                        if ((_e932 & 4278190080u) == 0u) {
                        } else {
                            let _e936 = local_2.group_mask;
                            if ((_e936 & 4278190080u) == 0u) {
                            } else {
                                let _e940 = local_2.len;
                                if (_e940 < 32u) {
                                    let _e943 = local_2.group;
                                    let _e945 = local_2.len;
                                    if (_e945 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.first[(0u + _e945)] = _e943;
                                    let _e951 = local_2.group_mask;
                                    let _e953 = local_2.len;
                                    if (_e953 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_2.mask[(0u + _e953)] = _e951;
                                    let _e960 = local_2.len;
                                    local_2.len = (_e960 + 1u);
                                }
                            }
                            local_2.group = (_e114 + _e924);
                            let _e964 = local_4;
                            local_2.group_mask = ((_e964 & 4278190080u) | (_e928 >> bitcast<u32>(24i)));
                        }
                        let _e969 = local_5;
                        phi_1521_ = (_e969 & 16777215u);
                        phi_1524_ = _e531;
                        loop {
                            let _e972 = phi_1521_;
                            let _e974 = phi_1524_;
                            local_11 = _e974;
                            if (_e972 == 0u) {
                                phi_1522_ = u32();
                                phi_1525_ = lt_bvh_Hit();
                                phi_3411_ = false;
                            } else {
                                let _e978 = nodes.member[(0u + _e529)].links[1u];
                                let _e982 = (_e978 + select(firstTrailingBit(_e972), 32u, (_e972 == 0u)));
                                if (_e982 < _e93) {
                                } else {
                                    return;
                                }
                                let _e989 = instances.member[(0u + _e982)].low_world;
                                let _e991 = instances.member[(0u + _e982)].high_world;
                                let _e1001 = ((_e989.x - _e165.origin.x) * _e311);
                                let _e1002 = ((_e989.y - _e165.origin.y) * _e322);
                                let _e1003 = ((_e989.z - _e165.origin.z) * _e333);
                                let _e1013 = ((_e991.x - _e165.origin.x) * _e311);
                                let _e1014 = ((_e991.y - _e165.origin.y) * _e322);
                                let _e1015 = ((_e991.z - _e165.origin.z) * _e333);
                                if (_e1001 < _e1013) {
                                    phi_1579_ = _e1001;
                                } else {
                                    phi_1579_ = _e1013;
                                }
                                let _e1018 = phi_1579_;
                                if (_e1002 < _e1014) {
                                    phi_1584_ = _e1002;
                                } else {
                                    phi_1584_ = _e1014;
                                }
                                let _e1021 = phi_1584_;
                                if (_e1003 < _e1015) {
                                    phi_1589_ = _e1003;
                                } else {
                                    phi_1589_ = _e1015;
                                }
                                let _e1024 = phi_1589_;
                                if (_e1001 > _e1013) {
                                    phi_1597_ = _e1001;
                                } else {
                                    phi_1597_ = _e1013;
                                }
                                let _e1030 = phi_1597_;
                                if (_e1002 > _e1014) {
                                    phi_1602_ = _e1002;
                                } else {
                                    phi_1602_ = _e1014;
                                }
                                let _e1033 = phi_1602_;
                                if (_e1003 > _e1015) {
                                    phi_1607_ = _e1003;
                                } else {
                                    phi_1607_ = _e1015;
                                }
                                let _e1036 = phi_1607_;
                                let _e1040 = core_intrinsics_maximum_number_nsz_f32_((_e1018 - _e378), (_e1021 - _e379));
                                let _e1041 = core_intrinsics_maximum_number_nsz_f32_(_e1040, (_e1024 - _e380));
                                let _e1042 = core_intrinsics_minimum_number_nsz_f32_((_e1030 + _e378), (_e1033 + _e379));
                                let _e1043 = core_intrinsics_minimum_number_nsz_f32_(_e1042, (_e1036 + _e380));
                                if (_e1041 <= _e1043) {
                                    if (_e1041 <= _e974.t) {
                                        if (_e1043 >= _e165.tmin) {
                                            let _e1055 = instances.member[(0u + _e982)].world_to_object[0u];
                                            let _e1066 = ((((_e1055.x * _e165.origin.x) + (_e1055.y * _e165.origin.y)) + (_e1055.z * _e165.origin.z)) + (_e1055.w * 1f));
                                            let _e1068 = instances.member[(0u + _e982)].world_to_object[1u];
                                            let _e1079 = ((((_e1068.x * _e165.origin.x) + (_e1068.y * _e165.origin.y)) + (_e1068.z * _e165.origin.z)) + (_e1068.w * 1f));
                                            let _e1081 = instances.member[(0u + _e982)].world_to_object[2u];
                                            let _e1092 = ((((_e1081.x * _e165.origin.x) + (_e1081.y * _e165.origin.y)) + (_e1081.z * _e165.origin.z)) + (_e1081.w * 1f));
                                            let _e1099 = instances.member[(0u + _e982)].world_to_object[0u];
                                            let _e1110 = ((((_e1099.x * _e165.direction.x) + (_e1099.y * _e165.direction.y)) + (_e1099.z * _e165.direction.z)) + (_e1099.w * 0f));
                                            let _e1112 = instances.member[(0u + _e982)].world_to_object[1u];
                                            let _e1123 = ((((_e1112.x * _e165.direction.x) + (_e1112.y * _e165.direction.y)) + (_e1112.z * _e165.direction.z)) + (_e1112.w * 0f));
                                            let _e1125 = instances.member[(0u + _e982)].world_to_object[2u];
                                            let _e1136 = ((((_e1125.x * _e165.direction.x) + (_e1125.y * _e165.direction.y)) + (_e1125.z * _e165.direction.z)) + (_e1125.w * 0f));
                                            let _e1141 = instances.member[(0u + _e982)].root;
                                            let _e1143 = instances.member[(0u + _e982)].first_triangle;
                                            let _e1144 = abs(_e1110);
                                            let _e1145 = abs(_e1123);
                                            let _e1146 = abs(_e1136);
                                            if (abs(_e1066) < 1000000000000000f) {
                                                if (abs(_e1079) < 1000000000000000f) {
                                                    phi_1739_ = (abs(_e1092) < 1000000000000000f);
                                                    phi_1740_ = false;
                                                } else {
                                                    phi_1739_ = bool();
                                                    phi_1740_ = true;
                                                }
                                                let _e1154 = phi_1739_;
                                                let _e1156 = phi_1740_;
                                                phi_1741_ = _e1154;
                                                phi_1742_ = _e1156;
                                            } else {
                                                phi_1741_ = bool();
                                                phi_1742_ = true;
                                            }
                                            let _e1158 = phi_1741_;
                                            let _e1160 = phi_1742_;
                                            if _e1160 {
                                                phi_1746_ = false;
                                            } else {
                                                phi_1746_ = _e1158;
                                            }
                                            let _e1162 = phi_1746_;
                                            if _e1162 {
                                                if (_e1144 < 1000000000000000f) {
                                                    if (_e1145 < 1000000000000000f) {
                                                        phi_1759_ = (_e1146 < 1000000000000000f);
                                                        phi_1760_ = false;
                                                    } else {
                                                        phi_1759_ = bool();
                                                        phi_1760_ = true;
                                                    }
                                                    let _e1167 = phi_1759_;
                                                    let _e1169 = phi_1760_;
                                                    phi_1761_ = _e1167;
                                                    phi_1762_ = _e1169;
                                                } else {
                                                    phi_1761_ = bool();
                                                    phi_1762_ = true;
                                                }
                                                let _e1171 = phi_1761_;
                                                let _e1173 = phi_1762_;
                                                if _e1173 {
                                                    phi_1766_ = false;
                                                } else {
                                                    phi_1766_ = _e1171;
                                                }
                                                let _e1175 = phi_1766_;
                                                if _e1175 {
                                                    if (_e1144 > 0f) {
                                                        phi_1780_ = bool();
                                                        phi_1781_ = true;
                                                    } else {
                                                        let _e1177 = (_e1145 > 0f);
                                                        if _e1177 {
                                                            phi_1779_ = bool();
                                                        } else {
                                                            phi_1779_ = (_e1146 > 0f);
                                                        }
                                                        let _e1180 = phi_1779_;
                                                        phi_1780_ = _e1180;
                                                        phi_1781_ = _e1177;
                                                    }
                                                    let _e1182 = phi_1780_;
                                                    let _e1184 = phi_1781_;
                                                    if _e1184 {
                                                        phi_1785_ = true;
                                                    } else {
                                                        phi_1785_ = _e1182;
                                                    }
                                                    let _e1186 = phi_1785_;
                                                    phi_1786_ = _e1186;
                                                    phi_1787_ = false;
                                                } else {
                                                    phi_1786_ = bool();
                                                    phi_1787_ = true;
                                                }
                                                let _e1188 = phi_1786_;
                                                let _e1190 = phi_1787_;
                                                phi_1788_ = _e1188;
                                                phi_1789_ = _e1190;
                                            } else {
                                                phi_1788_ = bool();
                                                phi_1789_ = true;
                                            }
                                            let _e1192 = phi_1788_;
                                            let _e1194 = phi_1789_;
                                            if _e1194 {
                                                phi_1793_ = false;
                                            } else {
                                                phi_1793_ = _e1192;
                                            }
                                            let _e1196 = phi_1793_;
                                            if _e1196 {
                                                let _e1197 = (_e1141 >= _e78);
                                                if _e1197 {
                                                    phi_3401_ = lt_bvh_Hit();
                                                } else {
                                                    if (_e1141 < _e78) {
                                                    } else {
                                                        return;
                                                    }
                                                    let _e1203 = nodes.member[(0u + _e1141)].frame[0u];
                                                    let _e1207 = nodes.member[(0u + _e1141)].frame[1u];
                                                    let _e1211 = nodes.member[(0u + _e1141)].frame[2u];
                                                    let _e1215 = nodes.member[(0u + _e1141)].frame[0u];
                                                    let _e1219 = nodes.member[(0u + _e1141)].frame[1u];
                                                    let _e1223 = nodes.member[(0u + _e1141)].frame[2u];
                                                    let _e1227 = nodes.member[(0u + _e1141)].frame[3u];
                                                    let _e1261 = core_intrinsics_maximum_number_nsz_f32_(abs(_e1110), abs(_e1123));
                                                    let _e1262 = core_intrinsics_maximum_number_nsz_f32_(_e1261, abs(_e1136));
                                                    let _e1263 = (_e1262 * 0.0000000000009094947f);
                                                    if (abs(_e1110) < _e1263) {
                                                        phi_1863_ = _e1263;
                                                    } else {
                                                        phi_1863_ = abs(_e1110);
                                                    }
                                                    let _e1268 = phi_1863_;
                                                    if (_e1110 < 0f) {
                                                        phi_1870_ = (-1f / _e1268);
                                                    } else {
                                                        phi_1870_ = (1f / _e1268);
                                                    }
                                                    let _e1273 = phi_1870_;
                                                    if (abs(_e1123) < _e1263) {
                                                        phi_1877_ = _e1263;
                                                    } else {
                                                        phi_1877_ = abs(_e1123);
                                                    }
                                                    let _e1278 = phi_1877_;
                                                    if (_e1123 < 0f) {
                                                        phi_1884_ = (-1f / _e1278);
                                                    } else {
                                                        phi_1884_ = (1f / _e1278);
                                                    }
                                                    let _e1283 = phi_1884_;
                                                    if (abs(_e1136) < _e1263) {
                                                        phi_1891_ = _e1263;
                                                    } else {
                                                        phi_1891_ = abs(_e1136);
                                                    }
                                                    let _e1288 = phi_1891_;
                                                    if (_e1136 < 0f) {
                                                        phi_1898_ = (-1f / _e1288);
                                                    } else {
                                                        phi_1898_ = (1f / _e1288);
                                                    }
                                                    let _e1293 = phi_1898_;
                                                    let _e1297 = abs((bitcast<f32>(_e1203) - _e1066));
                                                    let _e1298 = abs((bitcast<f32>(_e1207) - _e1079));
                                                    let _e1299 = abs((bitcast<f32>(_e1211) - _e1092));
                                                    let _e1303 = abs(((bitcast<f32>(_e1215) + (bitcast<f32>((((_e1227 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1066));
                                                    let _e1304 = abs(((bitcast<f32>(_e1219) + (bitcast<f32>((((_e1227 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1079));
                                                    let _e1305 = abs(((bitcast<f32>(_e1223) + (bitcast<f32>((((_e1227 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e1092));
                                                    if (_e1297 > _e1303) {
                                                        phi_1915_ = _e1297;
                                                    } else {
                                                        phi_1915_ = _e1303;
                                                    }
                                                    let _e1308 = phi_1915_;
                                                    if (_e1298 > _e1304) {
                                                        phi_1920_ = _e1298;
                                                    } else {
                                                        phi_1920_ = _e1304;
                                                    }
                                                    let _e1311 = phi_1920_;
                                                    if (_e1299 > _e1305) {
                                                        phi_1925_ = _e1299;
                                                    } else {
                                                        phi_1925_ = _e1305;
                                                    }
                                                    let _e1314 = phi_1925_;
                                                    if (_e1308 > _e1311) {
                                                        phi_1930_ = _e1308;
                                                    } else {
                                                        phi_1930_ = _e1311;
                                                    }
                                                    let _e1317 = phi_1930_;
                                                    if (_e1317 > _e1314) {
                                                        phi_1935_ = _e1317;
                                                    } else {
                                                        phi_1935_ = _e1314;
                                                    }
                                                    let _e1320 = phi_1935_;
                                                    let _e1324 = (_e1320 * 0.0000019073486f);
                                                    let _e1325 = (abs(_e1273) * _e1324);
                                                    let _e1326 = (abs(_e1283) * _e1324);
                                                    let _e1327 = (abs(_e1293) * _e1324);
                                                    let _e1331 = (_e1320 * 0.0000009536743f);
                                                    let _e1332 = (abs(_e1273) * _e1331);
                                                    let _e1333 = (abs(_e1283) * _e1331);
                                                    let _e1334 = (abs(_e1293) * _e1331);
                                                    let _e1335 = abs(_e1110);
                                                    let _e1336 = abs(_e1123);
                                                    let _e1337 = abs(_e1136);
                                                    if (_e1335 >= _e1336) {
                                                        if (_e1335 >= _e1337) {
                                                            phi_1961_ = false;
                                                        } else {
                                                            phi_1961_ = true;
                                                        }
                                                        let _e1341 = phi_1961_;
                                                        phi_1962_ = _e1341;
                                                    } else {
                                                        phi_1962_ = true;
                                                    }
                                                    let _e1343 = phi_1962_;
                                                    if _e1343 {
                                                        if (_e1336 >= _e1337) {
                                                            phi_1970_ = 1u;
                                                        } else {
                                                            phi_1970_ = 2u;
                                                        }
                                                        let _e1346 = phi_1970_;
                                                        phi_1971_ = _e1346;
                                                    } else {
                                                        phi_1971_ = 0u;
                                                    }
                                                    let _e1348 = phi_1971_;
                                                    if (_e1348 == 0u) {
                                                        phi_1983_ = vec3<f32>(_e1123, _e1136, _e1110);
                                                    } else {
                                                        if (_e1348 == 1u) {
                                                            phi_1982_ = vec3<f32>(_e1136, _e1110, _e1123);
                                                        } else {
                                                            phi_1982_ = vec3<f32>(_e1110, _e1123, _e1136);
                                                        }
                                                        let _e1354 = phi_1982_;
                                                        phi_1983_ = _e1354;
                                                    }
                                                    let _e1356 = phi_1983_;
                                                    let _e1359 = (_e1356.x / _e1356.z);
                                                    let _e1362 = (_e1356.y / _e1356.z);
                                                    if (_e1273 < 0f) {
                                                        phi_1996_ = 0u;
                                                    } else {
                                                        phi_1996_ = 1u;
                                                    }
                                                    let _e1367 = phi_1996_;
                                                    if (_e1283 < 0f) {
                                                        phi_2001_ = 0u;
                                                    } else {
                                                        phi_2001_ = 2u;
                                                    }
                                                    let _e1370 = phi_2001_;
                                                    if (_e1293 < 0f) {
                                                        phi_2006_ = 0u;
                                                    } else {
                                                        phi_2006_ = 4u;
                                                    }
                                                    let _e1373 = phi_2006_;
                                                    let _e1375 = ((_e1367 | _e1370) | _e1373);
                                                    let _e1376 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, _e1141, 2147483648u);
                                                    local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1376.first[0], _e1376.first[1], _e1376.first[2], _e1376.first[3], _e1376.first[4], _e1376.first[5], _e1376.first[6], _e1376.first[7], _e1376.first[8], _e1376.first[9], _e1376.first[10], _e1376.first[11], _e1376.first[12], _e1376.first[13], _e1376.first[14], _e1376.first[15], _e1376.first[16], _e1376.first[17], _e1376.first[18], _e1376.first[19], _e1376.first[20], _e1376.first[21], _e1376.first[22], _e1376.first[23], _e1376.first[24], _e1376.first[25], _e1376.first[26], _e1376.first[27], _e1376.first[28], _e1376.first[29], _e1376.first[30], _e1376.first[31]), array<u32, 32>(_e1376.mask[0], _e1376.mask[1], _e1376.mask[2], _e1376.mask[3], _e1376.mask[4], _e1376.mask[5], _e1376.mask[6], _e1376.mask[7], _e1376.mask[8], _e1376.mask[9], _e1376.mask[10], _e1376.mask[11], _e1376.mask[12], _e1376.mask[13], _e1376.mask[14], _e1376.mask[15], _e1376.mask[16], _e1376.mask[17], _e1376.mask[18], _e1376.mask[19], _e1376.mask[20], _e1376.mask[21], _e1376.mask[22], _e1376.mask[23], _e1376.mask[24], _e1376.mask[25], _e1376.mask[26], _e1376.mask[27], _e1376.mask[28], _e1376.mask[29], _e1376.mask[30], _e1376.mask[31]), _e1376.len, _e1376.group, _e1376.group_mask);
                                                    let _e1450 = local_1.group_mask;
                                                    if ((_e1450 & 4278190080u) == 0u) {
                                                        let _e1454 = local_1.len;
                                                        if (_e1454 == 0u) {
                                                            phi_2120_ = false;
                                                        } else {
                                                            let _e1458 = local_1.len;
                                                            local_1.len = (_e1458 - 1u);
                                                            let _e1461 = local_1.len;
                                                            if (_e1461 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1466 = local_1.first[(0u + _e1461)];
                                                            local_1.group = _e1466;
                                                            let _e1469 = local_1.len;
                                                            if (_e1469 < 32u) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1474 = local_1.mask[(0u + _e1469)];
                                                            local_1.group_mask = _e1474;
                                                            phi_2120_ = true;
                                                        }
                                                        let _e1477 = phi_2120_;
                                                        phi_2121_ = _e1477;
                                                    } else {
                                                        phi_2121_ = true;
                                                    }
                                                    let _e1479 = phi_2121_;
                                                    if _e1479 {
                                                        let _e1481 = local_1.group_mask;
                                                        let _e1487 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1481)), 32u, (_e1481 == 0u)));
                                                        let _e1491 = local_1.group_mask;
                                                        let _e1505 = local_1.group_mask;
                                                        local_1.group_mask = (_e1505 & ~((1u << bitcast<u32>((_e1487 & 31u)))));
                                                        let _e1508 = local_1.group;
                                                        phi_2152_ = (_e1508 + countOneBits(((_e1491 & ~((4294967295u << bitcast<u32>((((_e1487 - 24u) ^ 7u) & 31u))))) & 255u)));
                                                    } else {
                                                        phi_2152_ = 4294967295u;
                                                    }
                                                    let _e1511 = phi_2152_;
                                                    phi_2154_ = _e974;
                                                    phi_2157_ = _e1511;
                                                    loop {
                                                        let _e1513 = phi_2154_;
                                                        let _e1515 = phi_2157_;
                                                        local_10 = _e1513;
                                                        let _e1516 = (_e1515 != 4294967295u);
                                                        if _e1516 {
                                                            if (_e1515 < _e78) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1523 = nodes.member[(0u + _e1515)].frame[3u];
                                                            let _e1548 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1273);
                                                            let _e1549 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1283);
                                                            let _e1550 = (bitcast<f32>((((_e1523 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1293);
                                                            let _e1553 = nodes.member[(0u + _e1515)].frame[0u];
                                                            let _e1557 = nodes.member[(0u + _e1515)].frame[1u];
                                                            let _e1561 = nodes.member[(0u + _e1515)].frame[2u];
                                                            let _e1566 = ((bitcast<f32>(_e1553) - _e1066) * _e1273);
                                                            let _e1567 = ((bitcast<f32>(_e1557) - _e1079) * _e1283);
                                                            let _e1568 = ((bitcast<f32>(_e1561) - _e1092) * _e1293);
                                                            let _e1576 = nodes.member[(0u + _e1515)].x;
                                                            if (_e1273 < 0f) {
                                                                let _e1587 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1576.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1593 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1587.unnamed.word, _e1576.w), _e1587.unnamed_1);
                                                                let _e1599 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1593.unnamed, lt_mask_LightPlace(_e1576.x, _e1593.unnamed_1.shift));
                                                                phi_2238_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1599.unnamed, lt_mask_LightPlace(_e1599.unnamed_1.word, _e1576.y));
                                                            } else {
                                                                let _e1615 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1576.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1621 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1615.unnamed.word, _e1576.y), _e1615.unnamed_1);
                                                                let _e1627 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1621.unnamed, lt_mask_LightPlace(_e1576.z, _e1621.unnamed_1.shift));
                                                                phi_2238_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1627.unnamed, lt_mask_LightPlace(_e1627.unnamed_1.word, _e1576.w));
                                                            }
                                                            let _e1635 = phi_2238_;
                                                            let _e1645 = nodes.member[(0u + _e1515)].y;
                                                            if (_e1283 < 0f) {
                                                                let _e1656 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1645.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1662 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1656.unnamed.word, _e1645.w), _e1656.unnamed_1);
                                                                let _e1668 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1662.unnamed, lt_mask_LightPlace(_e1645.x, _e1662.unnamed_1.shift));
                                                                phi_2265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1668.unnamed, lt_mask_LightPlace(_e1668.unnamed_1.word, _e1645.y));
                                                            } else {
                                                                let _e1684 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1645.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1690 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1684.unnamed.word, _e1645.y), _e1684.unnamed_1);
                                                                let _e1696 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1690.unnamed, lt_mask_LightPlace(_e1645.z, _e1690.unnamed_1.shift));
                                                                phi_2265_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1696.unnamed, lt_mask_LightPlace(_e1696.unnamed_1.word, _e1645.w));
                                                            }
                                                            let _e1704 = phi_2265_;
                                                            let _e1714 = nodes.member[(0u + _e1515)].z;
                                                            if (_e1293 < 0f) {
                                                                let _e1725 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1714.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1731 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1725.unnamed.word, _e1714.w), _e1725.unnamed_1);
                                                                let _e1737 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1731.unnamed, lt_mask_LightPlace(_e1714.x, _e1731.unnamed_1.shift));
                                                                phi_2292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1737.unnamed, lt_mask_LightPlace(_e1737.unnamed_1.word, _e1714.y));
                                                            } else {
                                                                let _e1753 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1714.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                                                let _e1759 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e1753.unnamed.word, _e1714.y), _e1753.unnamed_1);
                                                                let _e1765 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1759.unnamed, lt_mask_LightPlace(_e1714.z, _e1759.unnamed_1.shift));
                                                                phi_2292_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e1765.unnamed, lt_mask_LightPlace(_e1765.unnamed_1.word, _e1714.w));
                                                            }
                                                            let _e1773 = phi_2292_;
                                                            phi_2298_ = 0u;
                                                            phi_2301_ = 0u;
                                                            loop {
                                                                let _e1783 = phi_2298_;
                                                                let _e1785 = phi_2301_;
                                                                local_6 = _e1785;
                                                                local_7 = _e1785;
                                                                local_8 = _e1785;
                                                                let _e1786 = (_e1783 < 8u);
                                                                if _e1786 {
                                                                    let _e1788 = (_e1783 >> bitcast<u32>(2i));
                                                                    let _e1789 = (_e1783 & 3u);
                                                                    if (_e1788 == 0u) {
                                                                        phi_2315_ = _e1635.unnamed.word;
                                                                    } else {
                                                                        phi_2315_ = _e1635.unnamed.shift;
                                                                    }
                                                                    let _e1792 = phi_2315_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2325_ = _e1704.unnamed.word;
                                                                    } else {
                                                                        phi_2325_ = _e1704.unnamed.shift;
                                                                    }
                                                                    let _e1801 = phi_2325_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2335_ = _e1773.unnamed.word;
                                                                    } else {
                                                                        phi_2335_ = _e1773.unnamed.shift;
                                                                    }
                                                                    let _e1810 = phi_2335_;
                                                                    let _e1823 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e1792 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 - _e1325)), ((f32(((_e1801 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 - _e1326)));
                                                                    let _e1824 = core_intrinsics_maximum_number_nsz_f32_(_e1823, ((f32(((_e1810 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 - _e1327)));
                                                                    if (_e1788 == 0u) {
                                                                        phi_2353_ = _e1635.unnamed_1.word;
                                                                    } else {
                                                                        phi_2353_ = _e1635.unnamed_1.shift;
                                                                    }
                                                                    let _e1827 = phi_2353_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2363_ = _e1704.unnamed_1.word;
                                                                    } else {
                                                                        phi_2363_ = _e1704.unnamed_1.shift;
                                                                    }
                                                                    let _e1836 = phi_2363_;
                                                                    if (_e1788 == 0u) {
                                                                        phi_2373_ = _e1773.unnamed_1.word;
                                                                    } else {
                                                                        phi_2373_ = _e1773.unnamed_1.shift;
                                                                    }
                                                                    let _e1845 = phi_2373_;
                                                                    let _e1858 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e1827 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1548) + (_e1566 + _e1325)), ((f32(((_e1836 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1549) + (_e1567 + _e1326)));
                                                                    let _e1859 = core_intrinsics_minimum_number_nsz_f32_(_e1858, ((f32(((_e1845 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u)) * _e1550) + (_e1568 + _e1327)));
                                                                    if (_e1824 <= _e1859) {
                                                                        if (_e1824 <= _e1513.t) {
                                                                            if (_e1859 >= _e165.tmin) {
                                                                                if (_e1788 == 0u) {
                                                                                    let _e1866 = nodes.member[(0u + _e1515)].links[2u];
                                                                                    phi_2409_ = _e1866;
                                                                                } else {
                                                                                    let _e1869 = nodes.member[(0u + _e1515)].links[3u];
                                                                                    phi_2409_ = _e1869;
                                                                                }
                                                                                let _e1871 = phi_2409_;
                                                                                let _e1876 = ((_e1871 >> bitcast<u32>(((_e1789 * 8u) & 31u))) & 255u);
                                                                                let _e1877 = (_e1876 & 31u);
                                                                                if (_e1877 >= 24u) {
                                                                                    phi_2422_ = (24u + ((_e1877 - 24u) ^ _e1375));
                                                                                } else {
                                                                                    phi_2422_ = _e1877;
                                                                                }
                                                                                let _e1883 = phi_2422_;
                                                                                phi_2427_ = (_e1785 | ((_e1876 >> bitcast<u32>(5i)) << bitcast<u32>((_e1883 & 31u))));
                                                                            } else {
                                                                                phi_2427_ = _e1785;
                                                                            }
                                                                            let _e1891 = phi_2427_;
                                                                            phi_2428_ = _e1891;
                                                                        } else {
                                                                            phi_2428_ = _e1785;
                                                                        }
                                                                        let _e1893 = phi_2428_;
                                                                        phi_2429_ = _e1893;
                                                                    } else {
                                                                        phi_2429_ = _e1785;
                                                                    }
                                                                    let _e1895 = phi_2429_;
                                                                    phi_2299_ = (_e1783 + 1u);
                                                                    phi_2302_ = _e1895;
                                                                } else {
                                                                    phi_2299_ = u32();
                                                                    phi_2302_ = u32();
                                                                }
                                                                let _e1898 = phi_2299_;
                                                                let _e1900 = phi_2302_;
                                                                continue;
                                                                continuing {
                                                                    phi_2298_ = _e1898;
                                                                    phi_2301_ = _e1900;
                                                                    break if !(_e1786);
                                                                }
                                                            }
                                                            let _e1904 = nodes.member[(0u + _e1515)].links[0u];
                                                            let _e1908 = nodes.member[(0u + _e1515)].frame[3u];
                                                            let _e1912 = local_6;
                                                            if ((_e1912 & 4278190080u) == 0u) {
                                                            } else {
                                                                let _e1916 = local_1.group_mask;
                                                                if ((_e1916 & 4278190080u) == 0u) {
                                                                } else {
                                                                    let _e1920 = local_1.len;
                                                                    if (_e1920 < 32u) {
                                                                        let _e1923 = local_1.group;
                                                                        let _e1925 = local_1.len;
                                                                        if (_e1925 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.first[(0u + _e1925)] = _e1923;
                                                                        let _e1931 = local_1.group_mask;
                                                                        let _e1933 = local_1.len;
                                                                        if (_e1933 < 32u) {
                                                                        } else {
                                                                            return;
                                                                        }
                                                                        local_1.mask[(0u + _e1933)] = _e1931;
                                                                        let _e1940 = local_1.len;
                                                                        local_1.len = (_e1940 + 1u);
                                                                    }
                                                                }
                                                                local_1.group = (_e1141 + _e1904);
                                                                let _e1944 = local_7;
                                                                local_1.group_mask = ((_e1944 & 4278190080u) | (_e1908 >> bitcast<u32>(24i)));
                                                            }
                                                            let _e1949 = local_8;
                                                            phi_2487_ = _e1513;
                                                            phi_2490_ = (_e1949 & 16777215u);
                                                            loop {
                                                                let _e1952 = phi_2487_;
                                                                let _e1954 = phi_2490_;
                                                                local_9 = _e1952;
                                                                if (_e1954 == 0u) {
                                                                    phi_2488_ = lt_bvh_Hit();
                                                                    phi_2491_ = u32();
                                                                    phi_3329_ = false;
                                                                } else {
                                                                    let _e1958 = nodes.member[(0u + _e1515)].links[1u];
                                                                    let _e1963 = ((_e1143 + _e1958) + select(firstTrailingBit(_e1954), 32u, (_e1954 == 0u)));
                                                                    if (_e1963 < _e81) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1970 = triangles.member[(0u + _e1963)].v0_;
                                                                    let _e1972 = (_e1970.x - _e1066);
                                                                    let _e1974 = (_e1970.y - _e1079);
                                                                    let _e1976 = (_e1970.z - _e1092);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2535_ = vec3<f32>(_e1974, _e1976, _e1972);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2534_ = vec3<f32>(_e1976, _e1972, _e1974);
                                                                        } else {
                                                                            phi_2534_ = (_e1970 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                        }
                                                                        let _e1984 = phi_2534_;
                                                                        phi_2535_ = _e1984;
                                                                    }
                                                                    let _e1986 = phi_2535_;
                                                                    let _e1990 = (_e1986.x - (_e1359 * _e1986.z));
                                                                    let _e1994 = (_e1986.y - (_e1362 * _e1986.z));
                                                                    let _e1996 = triangles.member[(0u + _e1963)].v1_;
                                                                    let _e1998 = (_e1996.x - _e1066);
                                                                    let _e2000 = (_e1996.y - _e1079);
                                                                    let _e2002 = (_e1996.z - _e1092);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2565_ = vec3<f32>(_e2000, _e2002, _e1998);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2564_ = vec3<f32>(_e2002, _e1998, _e2000);
                                                                        } else {
                                                                            phi_2564_ = (_e1996 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                        }
                                                                        let _e2010 = phi_2564_;
                                                                        phi_2565_ = _e2010;
                                                                    }
                                                                    let _e2012 = phi_2565_;
                                                                    let _e2016 = (_e2012.x - (_e1359 * _e2012.z));
                                                                    let _e2020 = (_e2012.y - (_e1362 * _e2012.z));
                                                                    let _e2022 = triangles.member[(0u + _e1963)].v2_;
                                                                    let _e2024 = (_e2022.x - _e1066);
                                                                    let _e2026 = (_e2022.y - _e1079);
                                                                    let _e2028 = (_e2022.z - _e1092);
                                                                    if (_e1348 == 0u) {
                                                                        phi_2595_ = vec3<f32>(_e2026, _e2028, _e2024);
                                                                    } else {
                                                                        if (_e1348 == 1u) {
                                                                            phi_2594_ = vec3<f32>(_e2028, _e2024, _e2026);
                                                                        } else {
                                                                            phi_2594_ = (_e2022 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                        }
                                                                        let _e2036 = phi_2594_;
                                                                        phi_2595_ = _e2036;
                                                                    }
                                                                    let _e2038 = phi_2595_;
                                                                    let _e2042 = (_e2038.x - (_e1359 * _e2038.z));
                                                                    let _e2046 = (_e2038.y - (_e1362 * _e2038.z));
                                                                    if (_e2016 < _e2042) {
                                                                        phi_2614_ = true;
                                                                    } else {
                                                                        if (_e2016 == _e2042) {
                                                                            phi_2613_ = (_e2020 < _e2046);
                                                                        } else {
                                                                            phi_2613_ = false;
                                                                        }
                                                                        let _e2051 = phi_2613_;
                                                                        phi_2614_ = _e2051;
                                                                    }
                                                                    let _e2053 = phi_2614_;
                                                                    if _e2053 {
                                                                        phi_2618_ = _e2046;
                                                                        phi_2619_ = _e2042;
                                                                        phi_2620_ = _e2020;
                                                                        phi_2621_ = _e2016;
                                                                    } else {
                                                                        phi_2618_ = _e2020;
                                                                        phi_2619_ = _e2016;
                                                                        phi_2620_ = _e2046;
                                                                        phi_2621_ = _e2042;
                                                                    }
                                                                    let _e2055 = phi_2618_;
                                                                    let _e2057 = phi_2619_;
                                                                    let _e2059 = phi_2620_;
                                                                    let _e2061 = phi_2621_;
                                                                    let _e2064 = ((_e2061 * _e2055) - (_e2059 * _e2057));
                                                                    if _e2053 {
                                                                        phi_2629_ = -(_e2064);
                                                                    } else {
                                                                        phi_2629_ = _e2064;
                                                                    }
                                                                    let _e2067 = phi_2629_;
                                                                    if (_e2042 < _e1990) {
                                                                        phi_2640_ = true;
                                                                    } else {
                                                                        if (_e2042 == _e1990) {
                                                                            phi_2639_ = (_e2046 < _e1994);
                                                                        } else {
                                                                            phi_2639_ = false;
                                                                        }
                                                                        let _e2072 = phi_2639_;
                                                                        phi_2640_ = _e2072;
                                                                    }
                                                                    let _e2074 = phi_2640_;
                                                                    if _e2074 {
                                                                        phi_2644_ = _e1994;
                                                                        phi_2645_ = _e1990;
                                                                        phi_2646_ = _e2046;
                                                                        phi_2647_ = _e2042;
                                                                    } else {
                                                                        phi_2644_ = _e2046;
                                                                        phi_2645_ = _e2042;
                                                                        phi_2646_ = _e1994;
                                                                        phi_2647_ = _e1990;
                                                                    }
                                                                    let _e2076 = phi_2644_;
                                                                    let _e2078 = phi_2645_;
                                                                    let _e2080 = phi_2646_;
                                                                    let _e2082 = phi_2647_;
                                                                    let _e2085 = ((_e2082 * _e2076) - (_e2080 * _e2078));
                                                                    if _e2074 {
                                                                        phi_2655_ = -(_e2085);
                                                                    } else {
                                                                        phi_2655_ = _e2085;
                                                                    }
                                                                    let _e2088 = phi_2655_;
                                                                    if (_e1990 < _e2016) {
                                                                        phi_2666_ = true;
                                                                    } else {
                                                                        if (_e1990 == _e2016) {
                                                                            phi_2665_ = (_e1994 < _e2020);
                                                                        } else {
                                                                            phi_2665_ = false;
                                                                        }
                                                                        let _e2093 = phi_2665_;
                                                                        phi_2666_ = _e2093;
                                                                    }
                                                                    let _e2095 = phi_2666_;
                                                                    if _e2095 {
                                                                        phi_2670_ = _e2020;
                                                                        phi_2671_ = _e2016;
                                                                        phi_2672_ = _e1994;
                                                                        phi_2673_ = _e1990;
                                                                    } else {
                                                                        phi_2670_ = _e1994;
                                                                        phi_2671_ = _e1990;
                                                                        phi_2672_ = _e2020;
                                                                        phi_2673_ = _e2016;
                                                                    }
                                                                    let _e2097 = phi_2670_;
                                                                    let _e2099 = phi_2671_;
                                                                    let _e2101 = phi_2672_;
                                                                    let _e2103 = phi_2673_;
                                                                    let _e2106 = ((_e2103 * _e2097) - (_e2101 * _e2099));
                                                                    if _e2095 {
                                                                        phi_2681_ = -(_e2106);
                                                                    } else {
                                                                        phi_2681_ = _e2106;
                                                                    }
                                                                    let _e2109 = phi_2681_;
                                                                    if (_e2067 >= 0f) {
                                                                        if (_e2088 >= 0f) {
                                                                            if (_e2109 >= 0f) {
                                                                                phi_2696_ = ((_e2067 + _e2088) + _e2109);
                                                                                phi_2697_ = false;
                                                                            } else {
                                                                                phi_2696_ = f32();
                                                                                phi_2697_ = true;
                                                                            }
                                                                            let _e2116 = phi_2696_;
                                                                            let _e2118 = phi_2697_;
                                                                            phi_2698_ = _e2116;
                                                                            phi_2699_ = _e2118;
                                                                        } else {
                                                                            phi_2698_ = f32();
                                                                            phi_2699_ = true;
                                                                        }
                                                                        let _e2120 = phi_2698_;
                                                                        let _e2122 = phi_2699_;
                                                                        phi_2700_ = _e2120;
                                                                        phi_2701_ = _e2122;
                                                                    } else {
                                                                        phi_2700_ = f32();
                                                                        phi_2701_ = true;
                                                                    }
                                                                    let _e2124 = phi_2700_;
                                                                    let _e2126 = phi_2701_;
                                                                    if _e2126 {
                                                                        if (_e2067 <= 0f) {
                                                                            if (_e2088 <= 0f) {
                                                                                let _e2129 = (_e2109 <= 0f);
                                                                                if _e2129 {
                                                                                }
                                                                                phi_2719_ = ((_e2067 + _e2088) + _e2109);
                                                                                phi_2720_ = false;
                                                                                phi_2721_ = _e2129;
                                                                            } else {
                                                                                phi_2719_ = f32();
                                                                                phi_2720_ = true;
                                                                                phi_2721_ = false;
                                                                            }
                                                                            let _e2133 = phi_2719_;
                                                                            let _e2135 = phi_2720_;
                                                                            let _e2137 = phi_2721_;
                                                                            phi_2722_ = _e2133;
                                                                            phi_2723_ = _e2135;
                                                                            phi_2724_ = _e2137;
                                                                        } else {
                                                                            phi_2722_ = f32();
                                                                            phi_2723_ = true;
                                                                            phi_2724_ = false;
                                                                        }
                                                                        let _e2139 = phi_2722_;
                                                                        let _e2141 = phi_2723_;
                                                                        let _e2143 = phi_2724_;
                                                                        if _e2141 {
                                                                            phi_2728_ = false;
                                                                        } else {
                                                                            phi_2728_ = _e2143;
                                                                        }
                                                                        let _e2145 = phi_2728_;
                                                                        phi_2729_ = _e2139;
                                                                        phi_2730_ = _e2145;
                                                                    } else {
                                                                        phi_2729_ = _e2124;
                                                                        phi_2730_ = true;
                                                                    }
                                                                    let _e2147 = phi_2729_;
                                                                    let _e2149 = phi_2730_;
                                                                    if _e2149 {
                                                                        let _e2150 = (_e2147 == 0f);
                                                                        if _e2150 {
                                                                            phi_3046_ = lt_bvh_triangle_Intersection();
                                                                            phi_3047_ = false;
                                                                        } else {
                                                                            let _e2152 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2154 = (_e2152.x - _e1066);
                                                                            let _e2156 = (_e2152.y - _e1079);
                                                                            let _e2158 = (_e2152.z - _e1092);
                                                                            if (_e1348 == 0u) {
                                                                                phi_2759_ = vec3<f32>(_e2156, _e2158, _e2154);
                                                                            } else {
                                                                                if (_e1348 == 1u) {
                                                                                    phi_2758_ = vec3<f32>(_e2158, _e2154, _e2156);
                                                                                } else {
                                                                                    phi_2758_ = (_e2152 - vec3<f32>(_e1066, _e1079, _e1092));
                                                                                }
                                                                                let _e2166 = phi_2758_;
                                                                                phi_2759_ = _e2166;
                                                                            }
                                                                            let _e2168 = phi_2759_;
                                                                            let _e2170 = triangles.member[(0u + _e1963)].v1_;
                                                                            let _e2172 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2175 = (_e2170.x - _e2172.x);
                                                                            let _e2178 = (_e2170.y - _e2172.y);
                                                                            let _e2181 = (_e2170.z - _e2172.z);
                                                                            if (_e1348 == 0u) {
                                                                                phi_2785_ = vec3<f32>(_e2178, _e2181, _e2175);
                                                                            } else {
                                                                                if (_e1348 == 1u) {
                                                                                    phi_2784_ = vec3<f32>(_e2181, _e2175, _e2178);
                                                                                } else {
                                                                                    phi_2784_ = (_e2170 - _e2172);
                                                                                }
                                                                                let _e2188 = phi_2784_;
                                                                                phi_2785_ = _e2188;
                                                                            }
                                                                            let _e2190 = phi_2785_;
                                                                            let _e2192 = triangles.member[(0u + _e1963)].v2_;
                                                                            let _e2194 = triangles.member[(0u + _e1963)].v0_;
                                                                            let _e2197 = (_e2192.x - _e2194.x);
                                                                            let _e2200 = (_e2192.y - _e2194.y);
                                                                            let _e2203 = (_e2192.z - _e2194.z);
                                                                            if (_e1348 == 0u) {
                                                                                phi_2811_ = vec3<f32>(_e2200, _e2203, _e2197);
                                                                            } else {
                                                                                if (_e1348 == 1u) {
                                                                                    phi_2810_ = vec3<f32>(_e2203, _e2197, _e2200);
                                                                                } else {
                                                                                    phi_2810_ = (_e2192 - _e2194);
                                                                                }
                                                                                let _e2210 = phi_2810_;
                                                                                phi_2811_ = _e2210;
                                                                            }
                                                                            let _e2212 = phi_2811_;
                                                                            let _e2219 = ((_e2190.y * _e2212.z) - (_e2190.z * _e2212.y));
                                                                            let _e2226 = ((_e2190.z * _e2212.x) - (_e2190.x * _e2212.z));
                                                                            let _e2233 = ((_e2190.x * _e2212.y) - (_e2190.y * _e2212.x));
                                                                            let _e2247 = (((1f / _e1356.z) * (((_e2219 * _e2168.x) + (_e2226 * _e2168.y)) + (_e2233 * _e2168.z))) / (((_e2219 * _e1359) + (_e2226 * _e1362)) + _e2233));
                                                                            if (_e2247 > _e165.tmin) {
                                                                                if (_e2247 < _e165.tmax) {
                                                                                    let _e2251 = triangles.member[(0u + _e1963)].v0_;
                                                                                    let _e2253 = triangles.member[(0u + _e1963)].v1_;
                                                                                    if (_e2251.x < _e2253.x) {
                                                                                        phi_2867_ = _e2251.x;
                                                                                    } else {
                                                                                        phi_2867_ = _e2253.x;
                                                                                    }
                                                                                    let _e2260 = phi_2867_;
                                                                                    if (_e2251.y < _e2253.y) {
                                                                                        phi_2876_ = _e2251.y;
                                                                                    } else {
                                                                                        phi_2876_ = _e2253.y;
                                                                                    }
                                                                                    let _e2267 = phi_2876_;
                                                                                    if (_e2251.z < _e2253.z) {
                                                                                        phi_2885_ = _e2251.z;
                                                                                    } else {
                                                                                        phi_2885_ = _e2253.z;
                                                                                    }
                                                                                    let _e2274 = phi_2885_;
                                                                                    let _e2276 = triangles.member[(0u + _e1963)].v2_;
                                                                                    if (_e2260 < _e2276.x) {
                                                                                        phi_2894_ = _e2260;
                                                                                    } else {
                                                                                        phi_2894_ = _e2276.x;
                                                                                    }
                                                                                    let _e2281 = phi_2894_;
                                                                                    if (_e2267 < _e2276.y) {
                                                                                        phi_2901_ = _e2267;
                                                                                    } else {
                                                                                        phi_2901_ = _e2276.y;
                                                                                    }
                                                                                    let _e2286 = phi_2901_;
                                                                                    if (_e2274 < _e2276.z) {
                                                                                        phi_2908_ = _e2274;
                                                                                    } else {
                                                                                        phi_2908_ = _e2276.z;
                                                                                    }
                                                                                    let _e2291 = phi_2908_;
                                                                                    let _e2293 = triangles.member[(0u + _e1963)].v0_;
                                                                                    let _e2295 = triangles.member[(0u + _e1963)].v1_;
                                                                                    if (_e2293.x > _e2295.x) {
                                                                                        phi_2921_ = _e2293.x;
                                                                                    } else {
                                                                                        phi_2921_ = _e2295.x;
                                                                                    }
                                                                                    let _e2302 = phi_2921_;
                                                                                    if (_e2293.y > _e2295.y) {
                                                                                        phi_2930_ = _e2293.y;
                                                                                    } else {
                                                                                        phi_2930_ = _e2295.y;
                                                                                    }
                                                                                    let _e2309 = phi_2930_;
                                                                                    if (_e2293.z > _e2295.z) {
                                                                                        phi_2939_ = _e2293.z;
                                                                                    } else {
                                                                                        phi_2939_ = _e2295.z;
                                                                                    }
                                                                                    let _e2316 = phi_2939_;
                                                                                    let _e2318 = triangles.member[(0u + _e1963)].v2_;
                                                                                    if (_e2302 > _e2318.x) {
                                                                                        phi_2948_ = _e2302;
                                                                                    } else {
                                                                                        phi_2948_ = _e2318.x;
                                                                                    }
                                                                                    let _e2323 = phi_2948_;
                                                                                    if (_e2309 > _e2318.y) {
                                                                                        phi_2955_ = _e2309;
                                                                                    } else {
                                                                                        phi_2955_ = _e2318.y;
                                                                                    }
                                                                                    let _e2328 = phi_2955_;
                                                                                    if (_e2316 > _e2318.z) {
                                                                                        phi_2962_ = _e2316;
                                                                                    } else {
                                                                                        phi_2962_ = _e2318.z;
                                                                                    }
                                                                                    let _e2333 = phi_2962_;
                                                                                    let _e2337 = ((_e2281 - _e1066) * _e1273);
                                                                                    let _e2338 = ((_e2286 - _e1079) * _e1283);
                                                                                    let _e2339 = ((_e2291 - _e1092) * _e1293);
                                                                                    let _e2343 = ((_e2323 - _e1066) * _e1273);
                                                                                    let _e2344 = ((_e2328 - _e1079) * _e1283);
                                                                                    let _e2345 = ((_e2333 - _e1092) * _e1293);
                                                                                    if (_e2337 < _e2343) {
                                                                                        phi_2979_ = _e2337;
                                                                                    } else {
                                                                                        phi_2979_ = _e2343;
                                                                                    }
                                                                                    let _e2348 = phi_2979_;
                                                                                    if (_e2338 < _e2344) {
                                                                                        phi_2984_ = _e2338;
                                                                                    } else {
                                                                                        phi_2984_ = _e2344;
                                                                                    }
                                                                                    let _e2351 = phi_2984_;
                                                                                    if (_e2339 < _e2345) {
                                                                                        phi_2989_ = _e2339;
                                                                                    } else {
                                                                                        phi_2989_ = _e2345;
                                                                                    }
                                                                                    let _e2354 = phi_2989_;
                                                                                    if (_e2337 > _e2343) {
                                                                                        phi_2997_ = _e2337;
                                                                                    } else {
                                                                                        phi_2997_ = _e2343;
                                                                                    }
                                                                                    let _e2360 = phi_2997_;
                                                                                    if (_e2338 > _e2344) {
                                                                                        phi_3002_ = _e2338;
                                                                                    } else {
                                                                                        phi_3002_ = _e2344;
                                                                                    }
                                                                                    let _e2363 = phi_3002_;
                                                                                    if (_e2339 > _e2345) {
                                                                                        phi_3007_ = _e2339;
                                                                                    } else {
                                                                                        phi_3007_ = _e2345;
                                                                                    }
                                                                                    let _e2366 = phi_3007_;
                                                                                    let _e2370 = core_intrinsics_maximum_number_nsz_f32_((_e2348 - _e1332), (_e2351 - _e1333));
                                                                                    let _e2371 = core_intrinsics_maximum_number_nsz_f32_(_e2370, (_e2354 - _e1334));
                                                                                    let _e2372 = core_intrinsics_minimum_number_nsz_f32_((_e2360 + _e1332), (_e2363 + _e1333));
                                                                                    let _e2373 = core_intrinsics_minimum_number_nsz_f32_(_e2372, (_e2366 + _e1334));
                                                                                    if (_e2371 > _e1041) {
                                                                                        phi_3019_ = _e2371;
                                                                                    } else {
                                                                                        phi_3019_ = _e1041;
                                                                                    }
                                                                                    let _e2376 = phi_3019_;
                                                                                    if (_e2373 < _e1043) {
                                                                                        phi_3024_ = _e2373;
                                                                                    } else {
                                                                                        phi_3024_ = _e1043;
                                                                                    }
                                                                                    let _e2379 = phi_3024_;
                                                                                    if (_e2247 < _e2376) {
                                                                                        phi_3029_ = _e2376;
                                                                                    } else {
                                                                                        phi_3029_ = _e2247;
                                                                                    }
                                                                                    let _e2382 = phi_3029_;
                                                                                    if (_e2382 > _e2379) {
                                                                                        phi_3034_ = _e2379;
                                                                                    } else {
                                                                                        phi_3034_ = _e2382;
                                                                                    }
                                                                                    let _e2385 = phi_3034_;
                                                                                    phi_3039_ = lt_bvh_triangle_Intersection(_e2385, (_e2088 / _e2147), (_e2109 / _e2147), (_e2376 <= _e2379));
                                                                                    phi_3040_ = false;
                                                                                } else {
                                                                                    phi_3039_ = lt_bvh_triangle_Intersection();
                                                                                    phi_3040_ = true;
                                                                                }
                                                                                let _e2391 = phi_3039_;
                                                                                let _e2393 = phi_3040_;
                                                                                phi_3041_ = _e2391;
                                                                                phi_3042_ = _e2393;
                                                                            } else {
                                                                                phi_3041_ = lt_bvh_triangle_Intersection();
                                                                                phi_3042_ = true;
                                                                            }
                                                                            let _e2395 = phi_3041_;
                                                                            let _e2397 = phi_3042_;
                                                                            if _e2397 {
                                                                            }
                                                                            phi_3046_ = _e2395;
                                                                            phi_3047_ = _e2397;
                                                                        }
                                                                        let _e2399 = phi_3046_;
                                                                        let _e2401 = phi_3047_;
                                                                        phi_3048_ = _e2399;
                                                                        phi_3049_ = _e2150;
                                                                        phi_3050_ = _e2401;
                                                                    } else {
                                                                        phi_3048_ = lt_bvh_triangle_Intersection();
                                                                        phi_3049_ = true;
                                                                        phi_3050_ = false;
                                                                    }
                                                                    let _e2403 = phi_3048_;
                                                                    let _e2405 = phi_3049_;
                                                                    let _e2407 = phi_3050_;
                                                                    if _e2405 {
                                                                        phi_3054_ = true;
                                                                    } else {
                                                                        phi_3054_ = _e2407;
                                                                    }
                                                                    let _e2409 = phi_3054_;
                                                                    if _e2409 {
                                                                        phi_3058_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                                                    } else {
                                                                        phi_3058_ = _e2403;
                                                                    }
                                                                    let _e2411 = phi_3058_;
                                                                    if _e2411.is_hit {
                                                                        if (_e2411.t > _e165.tmin) {
                                                                            if (_e2411.t < _e1952.t) {
                                                                                phi_3106_ = true;
                                                                            } else {
                                                                                if (_e2411.t == _e1952.t) {
                                                                                    if (_e1952.triangle != 4294967295u) {
                                                                                        if (_e1963 < _e1952.triangle) {
                                                                                            phi_3097_ = true;
                                                                                        } else {
                                                                                            if (_e1963 == _e1952.triangle) {
                                                                                                phi_3096_ = (_e982 < _e1952.instance);
                                                                                            } else {
                                                                                                phi_3096_ = false;
                                                                                            }
                                                                                            let _e2429 = phi_3096_;
                                                                                            phi_3097_ = _e2429;
                                                                                        }
                                                                                        let _e2431 = phi_3097_;
                                                                                        phi_3098_ = _e2431;
                                                                                        phi_3099_ = false;
                                                                                    } else {
                                                                                        phi_3098_ = bool();
                                                                                        phi_3099_ = true;
                                                                                    }
                                                                                    let _e2433 = phi_3098_;
                                                                                    let _e2435 = phi_3099_;
                                                                                    phi_3100_ = _e2433;
                                                                                    phi_3101_ = _e2435;
                                                                                } else {
                                                                                    phi_3100_ = bool();
                                                                                    phi_3101_ = true;
                                                                                }
                                                                                let _e2437 = phi_3100_;
                                                                                let _e2439 = phi_3101_;
                                                                                if _e2439 {
                                                                                    phi_3105_ = false;
                                                                                } else {
                                                                                    phi_3105_ = _e2437;
                                                                                }
                                                                                let _e2441 = phi_3105_;
                                                                                phi_3106_ = _e2441;
                                                                            }
                                                                            let _e2443 = phi_3106_;
                                                                            if _e2443 {
                                                                                let _e2445 = triangles.member[(0u + _e1963)].i0_;
                                                                                if ((_e2445 & 2147483648u) == 0u) {
                                                                                    phi_3317_ = true;
                                                                                } else {
                                                                                    if (_e1963 < _e81) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2454 = triangles.member[(0u + _e1963)].i0_;
                                                                                    let _e2455 = (_e2454 & 2147483647u);
                                                                                    let _e2457 = triangles.member[(0u + _e1963)].i1_;
                                                                                    let _e2459 = triangles.member[(0u + _e1963)].i2_;
                                                                                    if (_e2455 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2463 = vertices.member[(0u + _e2455)];
                                                                                    if (_e2457 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2467 = vertices.member[(0u + _e2457)];
                                                                                    if (_e2459 < _e84) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2471 = vertices.member[(0u + _e2459)];
                                                                                    let _e2472 = array<abi_Vertex, 3>(_e2463, _e2467, _e2471);
                                                                                    if (_e2472[0].material < _e87) {
                                                                                    } else {
                                                                                        return;
                                                                                    }
                                                                                    let _e2478 = materials.member[(0u + _e2472[0].material)];
                                                                                    if ((_e2478.flags & 0u) == 0u) {
                                                                                        let _e2483 = ((1f - _e2411.u) - _e2411.v);
                                                                                        if (_e2478.cutoff <= 0f) {
                                                                                            phi_3312_ = true;
                                                                                        } else {
                                                                                            let _e2510 = (_e2478.base_color.w * ((((f32((_e2472[0].color >> bitcast<u32>(24i))) * _e2483) + (f32((_e2472[1].color >> bitcast<u32>(24i))) * _e2411.u)) + (f32((_e2472[2].color >> bitcast<u32>(24i))) * _e2411.v)) * (1f / 255f)));
                                                                                            if (_e2478.alpha_size == 0u) {
                                                                                                phi_3309_ = _e2510;
                                                                                            } else {
                                                                                                local.offset = _e2478.alpha_offset;
                                                                                                local.size = _e2478.alpha_size;
                                                                                                local.flags = _e2478.flags;
                                                                                                let _e2541 = _lt_shaders_texture_TextureView_quad((&local), (((_e2472[0].u * _e2483) + (_e2472[1].u * _e2411.u)) + (_e2472[2].u * _e2411.v)), (((_e2472[0].v * _e2483) + (_e2472[1].v * _e2411.u)) + (_e2472[2].v * _e2411.v)));
                                                                                                let _e2545 = (_e2541.indices[0] >> bitcast<u32>(2i));
                                                                                                if (_e2545 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2549 = alpha_texels.member[(0u + _e2545)];
                                                                                                let _e2565 = (_e2541.indices[1] >> bitcast<u32>(2i));
                                                                                                if (_e2565 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2569 = alpha_texels.member[(0u + _e2565)];
                                                                                                let _e2586 = (_e2541.indices[2] >> bitcast<u32>(2i));
                                                                                                if (_e2586 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2590 = alpha_texels.member[(0u + _e2586)];
                                                                                                let _e2607 = (_e2541.indices[3] >> bitcast<u32>(2i));
                                                                                                if (_e2607 < _e96) {
                                                                                                } else {
                                                                                                    return;
                                                                                                }
                                                                                                let _e2611 = alpha_texels.member[(0u + _e2607)];
                                                                                                phi_3309_ = (_e2510 * (((((f32(((_e2549 >> bitcast<u32>((((_e2541.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2541.weights.x) + ((f32(((_e2569 >> bitcast<u32>((((_e2541.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2541.weights.y)) + ((f32(((_e2590 >> bitcast<u32>((((_e2541.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2541.weights.z)) + ((f32(((_e2611 >> bitcast<u32>((((_e2541.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e2541.weights.w)));
                                                                                            }
                                                                                            let _e2627 = phi_3309_;
                                                                                            phi_3312_ = (_e2627 >= _e2478.cutoff);
                                                                                        }
                                                                                        let _e2631 = phi_3312_;
                                                                                        phi_3313_ = _e2631;
                                                                                    } else {
                                                                                        phi_3313_ = false;
                                                                                    }
                                                                                    let _e2633 = phi_3313_;
                                                                                    if _e2633 {
                                                                                    }
                                                                                    phi_3317_ = _e2633;
                                                                                }
                                                                                let _e2635 = phi_3317_;
                                                                                if _e2635 {
                                                                                    phi_3325_ = lt_bvh_Hit(_e2411.t, _e2411.u, _e2411.v, _e1963, _e982);
                                                                                } else {
                                                                                    phi_3325_ = _e1952;
                                                                                }
                                                                                let _e2641 = phi_3325_;
                                                                                phi_3326_ = _e2641;
                                                                            } else {
                                                                                phi_3326_ = _e1952;
                                                                            }
                                                                            let _e2643 = phi_3326_;
                                                                            phi_3327_ = _e2643;
                                                                        } else {
                                                                            phi_3327_ = _e1952;
                                                                        }
                                                                        let _e2645 = phi_3327_;
                                                                        phi_3328_ = _e2645;
                                                                    } else {
                                                                        phi_3328_ = _e1952;
                                                                    }
                                                                    let _e2647 = phi_3328_;
                                                                    phi_2488_ = _e2647;
                                                                    phi_2491_ = (_e1954 & (_e1954 - 1u));
                                                                    phi_3329_ = true;
                                                                }
                                                                let _e2649 = phi_2488_;
                                                                let _e2651 = phi_2491_;
                                                                let _e2653 = phi_3329_;
                                                                continue;
                                                                continuing {
                                                                    phi_2487_ = _e2649;
                                                                    phi_2490_ = _e2651;
                                                                    break if !(_e2653);
                                                                }
                                                            }
                                                            let _e2656 = local_1.group_mask;
                                                            if ((_e2656 & 4278190080u) == 0u) {
                                                                let _e2660 = local_1.len;
                                                                if (_e2660 == 0u) {
                                                                    phi_3368_ = false;
                                                                } else {
                                                                    let _e2664 = local_1.len;
                                                                    local_1.len = (_e2664 - 1u);
                                                                    let _e2667 = local_1.len;
                                                                    if (_e2667 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2672 = local_1.first[(0u + _e2667)];
                                                                    local_1.group = _e2672;
                                                                    let _e2675 = local_1.len;
                                                                    if (_e2675 < 32u) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e2680 = local_1.mask[(0u + _e2675)];
                                                                    local_1.group_mask = _e2680;
                                                                    phi_3368_ = true;
                                                                }
                                                                let _e2683 = phi_3368_;
                                                                phi_3369_ = _e2683;
                                                            } else {
                                                                phi_3369_ = true;
                                                            }
                                                            let _e2685 = phi_3369_;
                                                            if _e2685 {
                                                                let _e2687 = local_1.group_mask;
                                                                let _e2693 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2687)), 32u, (_e2687 == 0u)));
                                                                let _e2697 = local_1.group_mask;
                                                                let _e2711 = local_1.group_mask;
                                                                local_1.group_mask = (_e2711 & ~((1u << bitcast<u32>((_e2693 & 31u)))));
                                                                let _e2714 = local_1.group;
                                                                phi_3400_ = (_e2714 + countOneBits(((_e2697 & ~((4294967295u << bitcast<u32>((((_e2693 - 24u) ^ _e1375) & 31u))))) & 255u)));
                                                            } else {
                                                                phi_3400_ = 4294967295u;
                                                            }
                                                            let _e2717 = phi_3400_;
                                                            let _e3895 = local_9;
                                                            phi_2155_ = _e3895;
                                                            phi_2158_ = _e2717;
                                                        } else {
                                                            phi_2155_ = lt_bvh_Hit();
                                                            phi_2158_ = u32();
                                                        }
                                                        let _e2719 = phi_2155_;
                                                        let _e2721 = phi_2158_;
                                                        continue;
                                                        continuing {
                                                            phi_2154_ = _e2719;
                                                            phi_2157_ = _e2721;
                                                            break if !(_e1516);
                                                        }
                                                    }
                                                    let _e3899 = local_10;
                                                    phi_3401_ = _e3899;
                                                }
                                                let _e2724 = phi_3401_;
                                                phi_3402_ = _e2724;
                                                phi_3403_ = _e1197;
                                            } else {
                                                phi_3402_ = lt_bvh_Hit();
                                                phi_3403_ = true;
                                            }
                                            let _e2726 = phi_3402_;
                                            let _e2728 = phi_3403_;
                                            if _e2728 {
                                                phi_3407_ = _e974;
                                            } else {
                                                phi_3407_ = _e2726;
                                            }
                                            let _e2730 = phi_3407_;
                                            phi_3408_ = _e2730;
                                        } else {
                                            phi_3408_ = _e974;
                                        }
                                        let _e2732 = phi_3408_;
                                        phi_3409_ = _e2732;
                                    } else {
                                        phi_3409_ = _e974;
                                    }
                                    let _e2734 = phi_3409_;
                                    phi_3410_ = _e2734;
                                } else {
                                    phi_3410_ = _e974;
                                }
                                let _e2736 = phi_3410_;
                                phi_1522_ = (_e972 & (_e972 - 1u));
                                phi_1525_ = _e2736;
                                phi_3411_ = true;
                            }
                            let _e2738 = phi_1522_;
                            let _e2740 = phi_1525_;
                            let _e2742 = phi_3411_;
                            continue;
                            continuing {
                                phi_1521_ = _e2738;
                                phi_1524_ = _e2740;
                                break if !(_e2742);
                            }
                        }
                        let _e2745 = local_2.group_mask;
                        if ((_e2745 & 4278190080u) == 0u) {
                            let _e2749 = local_2.len;
                            if (_e2749 == 0u) {
                                phi_3450_ = false;
                            } else {
                                let _e2753 = local_2.len;
                                local_2.len = (_e2753 - 1u);
                                let _e2756 = local_2.len;
                                if (_e2756 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2761 = local_2.first[(0u + _e2756)];
                                local_2.group = _e2761;
                                let _e2764 = local_2.len;
                                if (_e2764 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2769 = local_2.mask[(0u + _e2764)];
                                local_2.group_mask = _e2769;
                                phi_3450_ = true;
                            }
                            let _e2772 = phi_3450_;
                            phi_3451_ = _e2772;
                        } else {
                            phi_3451_ = true;
                        }
                        let _e2774 = phi_3451_;
                        if _e2774 {
                            let _e2776 = local_2.group_mask;
                            let _e2782 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2776)), 32u, (_e2776 == 0u)));
                            let _e2786 = local_2.group_mask;
                            let _e2800 = local_2.group_mask;
                            local_2.group_mask = (_e2800 & ~((1u << bitcast<u32>((_e2782 & 31u)))));
                            let _e2803 = local_2.group;
                            phi_3482_ = (_e2803 + countOneBits(((_e2786 & ~((4294967295u << bitcast<u32>((((_e2782 - 24u) ^ _e391) & 31u))))) & 255u)));
                        } else {
                            phi_3482_ = 4294967295u;
                        }
                        let _e2806 = phi_3482_;
                        phi_1185_ = _e2806;
                        let _e3915 = local_11;
                        phi_1188_ = _e3915;
                    } else {
                        phi_1185_ = u32();
                        phi_1188_ = lt_bvh_Hit();
                    }
                    let _e2808 = phi_1185_;
                    let _e2810 = phi_1188_;
                    continue;
                    continuing {
                        phi_1184_ = _e2808;
                        phi_1187_ = _e2810;
                        break if !(_e532);
                    }
                }
                let _e3918 = local_12;
                phi_3483_ = _e3918;
            }
            let _e2813 = phi_3483_;
            phi_3484_ = _e2813;
            phi_3485_ = _e229;
        } else {
            phi_3484_ = lt_bvh_Hit();
            phi_3485_ = true;
        }
        let _e2815 = phi_3484_;
        let _e2817 = phi_3485_;
        if _e2817 {
            phi_3489_ = _e167;
        } else {
            phi_3489_ = _e2815;
        }
        let _e2819 = phi_3489_;
        if (_e2819.triangle != 4294967295u) {
            let _e2825 = ((1f - _e2819.u) - _e2819.v);
            if (_e2819.triangle < _e81) {
            } else {
                return;
            }
            let _e2831 = triangles.member[(0u + _e2819.triangle)];
            if (_e2819.instance < _e93) {
            } else {
                return;
            }
            let _e2842 = instances.member[(0u + _e2819.instance)].object_to_world[0u];
            let _e2853 = ((((_e2842.x * _e2831.v0_.x) + (_e2842.y * _e2831.v0_.y)) + (_e2842.z * _e2831.v0_.z)) + (_e2842.w * 1f));
            let _e2855 = instances.member[(0u + _e2819.instance)].object_to_world[1u];
            let _e2866 = ((((_e2855.x * _e2831.v0_.x) + (_e2855.y * _e2831.v0_.y)) + (_e2855.z * _e2831.v0_.z)) + (_e2855.w * 1f));
            let _e2868 = instances.member[(0u + _e2819.instance)].object_to_world[2u];
            let _e2879 = ((((_e2868.x * _e2831.v0_.x) + (_e2868.y * _e2831.v0_.y)) + (_e2868.z * _e2831.v0_.z)) + (_e2868.w * 1f));
            let _e2886 = instances.member[(0u + _e2819.instance)].object_to_world[0u];
            let _e2897 = ((((_e2886.x * _e2831.v1_.x) + (_e2886.y * _e2831.v1_.y)) + (_e2886.z * _e2831.v1_.z)) + (_e2886.w * 1f));
            let _e2899 = instances.member[(0u + _e2819.instance)].object_to_world[1u];
            let _e2910 = ((((_e2899.x * _e2831.v1_.x) + (_e2899.y * _e2831.v1_.y)) + (_e2899.z * _e2831.v1_.z)) + (_e2899.w * 1f));
            let _e2912 = instances.member[(0u + _e2819.instance)].object_to_world[2u];
            let _e2923 = ((((_e2912.x * _e2831.v1_.x) + (_e2912.y * _e2831.v1_.y)) + (_e2912.z * _e2831.v1_.z)) + (_e2912.w * 1f));
            let _e2930 = instances.member[(0u + _e2819.instance)].object_to_world[0u];
            let _e2941 = ((((_e2930.x * _e2831.v2_.x) + (_e2930.y * _e2831.v2_.y)) + (_e2930.z * _e2831.v2_.z)) + (_e2930.w * 1f));
            let _e2943 = instances.member[(0u + _e2819.instance)].object_to_world[1u];
            let _e2954 = ((((_e2943.x * _e2831.v2_.x) + (_e2943.y * _e2831.v2_.y)) + (_e2943.z * _e2831.v2_.z)) + (_e2943.w * 1f));
            let _e2956 = instances.member[(0u + _e2819.instance)].object_to_world[2u];
            let _e2967 = ((((_e2956.x * _e2831.v2_.x) + (_e2956.y * _e2831.v2_.y)) + (_e2956.z * _e2831.v2_.z)) + (_e2956.w * 1f));
            let _e2980 = (((_e2853 * _e2825) + (_e2897 * _e2819.u)) + (_e2941 * _e2819.v));
            let _e2981 = (((_e2866 * _e2825) + (_e2910 * _e2819.u)) + (_e2954 * _e2819.v));
            let _e2982 = (((_e2879 * _e2825) + (_e2923 * _e2819.u)) + (_e2967 * _e2819.v));
            let _e2984 = abs(_e2853);
            let _e2985 = abs(_e2866);
            let _e2986 = abs(_e2879);
            let _e2987 = abs(_e2897);
            let _e2988 = abs(_e2910);
            let _e2989 = abs(_e2923);
            if (_e2984 > _e2987) {
                phi_3677_ = _e2984;
            } else {
                phi_3677_ = _e2987;
            }
            let _e2992 = phi_3677_;
            if (_e2985 > _e2988) {
                phi_3682_ = _e2985;
            } else {
                phi_3682_ = _e2988;
            }
            let _e2995 = phi_3682_;
            if (_e2986 > _e2989) {
                phi_3687_ = _e2986;
            } else {
                phi_3687_ = _e2989;
            }
            let _e2998 = phi_3687_;
            let _e2999 = abs(_e2941);
            let _e3000 = abs(_e2954);
            let _e3001 = abs(_e2967);
            if (_e2992 > _e2999) {
                phi_3695_ = _e2992;
            } else {
                phi_3695_ = _e2999;
            }
            let _e3004 = phi_3695_;
            if (_e2995 > _e3000) {
                phi_3700_ = _e2995;
            } else {
                phi_3700_ = _e3000;
            }
            let _e3007 = phi_3700_;
            if (_e2998 > _e3001) {
                phi_3705_ = _e2998;
            } else {
                phi_3705_ = _e3001;
            }
            let _e3010 = phi_3705_;
            let _e3011 = (_e2897 - _e2853);
            let _e3012 = (_e2910 - _e2866);
            let _e3013 = (_e2923 - _e2879);
            let _e3014 = (_e2941 - _e2853);
            let _e3015 = (_e2954 - _e2866);
            let _e3016 = (_e2967 - _e2879);
            let _e3020 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3012), abs(_e3013));
            let _e3021 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3011), _e3020);
            let _e3022 = (_e3011 / _e3021);
            let _e3023 = (_e3012 / _e3021);
            let _e3024 = (_e3013 / _e3021);
            let _e3028 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3015), abs(_e3016));
            let _e3029 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(abs(_e3014), _e3028);
            let _e3030 = (_e3014 / _e3029);
            let _e3031 = (_e3015 / _e3029);
            let _e3032 = (_e3016 / _e3029);
            let _e3035 = ((_e3023 * _e3032) - (_e3031 * _e3024));
            let _e3038 = ((_e3024 * _e3030) - (_e3032 * _e3022));
            let _e3041 = ((_e3022 * _e3031) - (_e3030 * _e3023));
            let _e3043 = p.member.eye;
            let _e3056 = (1f / sqrt((((_e3035 * _e3035) + (_e3038 * _e3038)) + (_e3041 * _e3041))));
            let _e3057 = (_e3035 * _e3056);
            let _e3058 = (_e3038 * _e3056);
            let _e3059 = (_e3041 * _e3056);
            if ((((_e3057 * (_e3043.x - _e2980)) + (_e3058 * (_e3043.y - _e2981))) + (_e3059 * (_e3043.z - _e2982))) < 0f) {
                phi_3769_ = vec3<f32>(-(_e3057), -(_e3058), -(_e3059));
            } else {
                phi_3769_ = vec3<f32>(_e3057, _e3058, _e3059);
            }
            let _e3072 = phi_3769_;
            if (_e2819.triangle < _e81) {
            } else {
                return;
            }
            let _e3077 = triangles.member[(0u + _e2819.triangle)];
            let _e3079 = (_e3077.i0_ & 2147483647u);
            if (_e3079 < _e84) {
            } else {
                return;
            }
            let _e3085 = vertices.member[(0u + _e3079)];
            if (_e3077.i1_ < _e84) {
            } else {
                return;
            }
            let _e3089 = vertices.member[(0u + _e3077.i1_)];
            if (_e3077.i2_ < _e84) {
            } else {
                return;
            }
            let _e3093 = vertices.member[(0u + _e3077.i2_)];
            let _e3094 = array<abi_Vertex, 3>(_e3085, _e3089, _e3093);
            if (_e3094[0].material < _e87) {
            } else {
                return;
            }
            let _e3100 = materials.member[(0u + _e3094[0].material)];
            let _e3117 = (1f / 255f);
            let _e3136 = (1f / 255f);
            let _e3158 = (1f / 255f);
            let _e3171 = _lt_shaders_camera_NoColorTextures_u0020_as_u0020_lt_shaders_camera_ColorSource_texture_color(vec3<f32>(_e2825, _e2819.u, _e2819.v));
            let _e3173 = ((_e3100.base_color.x * ((((f32((_e3094[0].color & 255u)) * _e3117) * _e2825) + ((f32((_e3094[1].color & 255u)) * _e3136) * _e2819.u)) + ((f32((_e3094[2].color & 255u)) * _e3158) * _e2819.v))) * _e3171.x);
            let _e3175 = ((_e3100.base_color.y * ((((f32(((_e3094[0].color >> bitcast<u32>(8i)) & 255u)) * _e3117) * _e2825) + ((f32(((_e3094[1].color >> bitcast<u32>(8i)) & 255u)) * _e3136) * _e2819.u)) + ((f32(((_e3094[2].color >> bitcast<u32>(8i)) & 255u)) * _e3158) * _e2819.v))) * _e3171.y);
            let _e3177 = ((_e3100.base_color.z * ((((f32(((_e3094[0].color >> bitcast<u32>(16i)) & 255u)) * _e3117) * _e2825) + ((f32(((_e3094[1].color >> bitcast<u32>(16i)) & 255u)) * _e3136) * _e2819.u)) + ((f32(((_e3094[2].color >> bitcast<u32>(16i)) & 255u)) * _e3158) * _e2819.v))) * _e3171.z);
            let _e3178 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3007, _e3010);
            let _e3179 = _glam_f32_vec3_Vec3_max_element_u007b_closure_u0023_0_u007d(_e3004, _e3178);
            if ((_e3100.flags & 2u) == 0u) {
                phi_3890_ = 0u;
            } else {
                phi_3890_ = 1u;
            }
            let _e3184 = phi_3890_;
            if (_e3094[0].normal == 2147516416u) {
                phi_4120_ = _e3072;
            } else {
                let _e3197 = (f32((bitcast<i32>((_e3094[0].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3203 = (f32((bitcast<i32>(_e3094[0].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3207 = ((1f - abs(_e3197)) - abs(_e3203));
                if (_e3207 < 0f) {
                    phi_3917_ = -(_e3207);
                } else {
                    phi_3917_ = 0f;
                }
                let _e3211 = phi_3917_;
                if (_e3197 < 0f) {
                    phi_3924_ = (_e3197 + _e3211);
                } else {
                    phi_3924_ = (_e3197 - _e3211);
                }
                let _e3216 = phi_3924_;
                if (_e3203 < 0f) {
                    phi_3931_ = (_e3203 + _e3211);
                } else {
                    phi_3931_ = (_e3203 - _e3211);
                }
                let _e3221 = phi_3931_;
                let _e3228 = (1f / sqrt((((_e3216 * _e3216) + (_e3221 * _e3221)) + (_e3207 * _e3207))));
                let _e3244 = (f32((bitcast<i32>((_e3094[1].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3250 = (f32((bitcast<i32>(_e3094[1].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3254 = ((1f - abs(_e3244)) - abs(_e3250));
                if (_e3254 < 0f) {
                    phi_3966_ = -(_e3254);
                } else {
                    phi_3966_ = 0f;
                }
                let _e3258 = phi_3966_;
                if (_e3244 < 0f) {
                    phi_3973_ = (_e3244 + _e3258);
                } else {
                    phi_3973_ = (_e3244 - _e3258);
                }
                let _e3263 = phi_3973_;
                if (_e3250 < 0f) {
                    phi_3980_ = (_e3250 + _e3258);
                } else {
                    phi_3980_ = (_e3250 - _e3258);
                }
                let _e3268 = phi_3980_;
                let _e3275 = (1f / sqrt((((_e3263 * _e3263) + (_e3268 * _e3268)) + (_e3254 * _e3254))));
                let _e3294 = (f32((bitcast<i32>((_e3094[2].normal << bitcast<u32>(16i))) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3300 = (f32((bitcast<i32>(_e3094[2].normal) >> bitcast<u32>(16i))) * (1f / 32767f));
                let _e3304 = ((1f - abs(_e3294)) - abs(_e3300));
                if (_e3304 < 0f) {
                    phi_4018_ = -(_e3304);
                } else {
                    phi_4018_ = 0f;
                }
                let _e3308 = phi_4018_;
                if (_e3294 < 0f) {
                    phi_4025_ = (_e3294 + _e3308);
                } else {
                    phi_4025_ = (_e3294 - _e3308);
                }
                let _e3313 = phi_4025_;
                if (_e3300 < 0f) {
                    phi_4032_ = (_e3300 + _e3308);
                } else {
                    phi_4032_ = (_e3300 - _e3308);
                }
                let _e3318 = phi_4032_;
                let _e3325 = (1f / sqrt((((_e3313 * _e3313) + (_e3318 * _e3318)) + (_e3304 * _e3304))));
                let _e3332 = ((((_e3216 * _e3228) * _e2825) + ((_e3263 * _e3275) * _e2819.u)) + ((_e3313 * _e3325) * _e2819.v));
                let _e3333 = ((((_e3221 * _e3228) * _e2825) + ((_e3268 * _e3275) * _e2819.u)) + ((_e3318 * _e3325) * _e2819.v));
                let _e3334 = ((((_e3207 * _e3228) * _e2825) + ((_e3254 * _e3275) * _e2819.u)) + ((_e3304 * _e3325) * _e2819.v));
                if (_e2819.instance < _e93) {
                } else {
                    return;
                }
                let _e3341 = instances.member[(0u + _e2819.instance)].world_to_object[0u];
                let _e3350 = instances.member[(0u + _e2819.instance)].world_to_object[1u];
                let _e3362 = instances.member[(0u + _e2819.instance)].world_to_object[2u];
                let _e3369 = (((_e3341.x * _e3332) + (_e3350.x * _e3333)) + (_e3362.x * _e3334));
                let _e3370 = (((_e3341.y * _e3332) + (_e3350.y * _e3333)) + (_e3362.y * _e3334));
                let _e3371 = (((_e3341.z * _e3332) + (_e3350.z * _e3333)) + (_e3362.z * _e3334));
                let _e3377 = sqrt((((_e3369 * _e3369) + (_e3370 * _e3370)) + (_e3371 * _e3371)));
                if (_e3377 > 0f) {
                    let _e3379 = (_e3369 / _e3377);
                    let _e3380 = (_e3370 / _e3377);
                    let _e3381 = (_e3371 / _e3377);
                    if ((((_e3379 * _e3072.x) + (_e3380 * _e3072.y)) + (_e3381 * _e3072.z)) < 0f) {
                        phi_4118_ = vec3<f32>(-(_e3379), -(_e3380), -(_e3381));
                    } else {
                        phi_4118_ = vec3<f32>(_e3379, _e3380, _e3381);
                    }
                    let _e3397 = phi_4118_;
                    phi_4119_ = _e3397;
                } else {
                    phi_4119_ = _e3072;
                }
                let _e3399 = phi_4119_;
                phi_4120_ = _e3399;
            }
            let _e3401 = phi_4120_;
            if (_e3173 > 0f) {
                if (_e3173 < 1f) {
                    phi_4129_ = _e3173;
                } else {
                    phi_4129_ = 1f;
                }
                let _e3405 = phi_4129_;
                phi_4130_ = _e3405;
            } else {
                phi_4130_ = 0f;
            }
            let _e3407 = phi_4130_;
            if (_e3175 > 0f) {
                if (_e3175 < 1f) {
                    phi_4140_ = _e3175;
                } else {
                    phi_4140_ = 1f;
                }
                let _e3412 = phi_4140_;
                phi_4141_ = _e3412;
            } else {
                phi_4141_ = 0f;
            }
            let _e3414 = phi_4141_;
            if (_e3177 > 0f) {
                if (_e3177 < 1f) {
                    phi_4151_ = _e3177;
                } else {
                    phi_4151_ = 1f;
                }
                let _e3419 = phi_4151_;
                phi_4152_ = _e3419;
            } else {
                phi_4152_ = 0f;
            }
            let _e3421 = phi_4152_;
            let _e3424 = ((sqrt(_e3407) * 255f) + 0.5f);
            let _e3433 = ((sqrt(_e3414) * 255f) + 0.5f);
            let _e3445 = ((sqrt(_e3421) * 255f) + 0.5f);
            phi_4187_ = abi_Sample(vec3<f32>(_e2980, _e2981, _e2982), _e3179, _e3072, _e3184, _e3401, ((select(select(u32(_e3424), 0u, (_e3424 < bitcast<f32>(0u))), 4294967295u, (_e3424 > bitcast<f32>(1333788671u))) | (select(select(u32(_e3433), 0u, (_e3433 < bitcast<f32>(0u))), 4294967295u, (_e3433 > bitcast<f32>(1333788671u))) << bitcast<u32>(8i))) | (select(select(u32(_e3445), 0u, (_e3445 < bitcast<f32>(0u))), 4294967295u, (_e3445 > bitcast<f32>(1333788671u))) << bitcast<u32>(16i))));
        } else {
            phi_4187_ = abi_Sample(vec3<f32>(0f, 0f, 0f), 0f, vec3<f32>(0f, 0f, 0f), 0u, vec3<f32>(0f, 0f, 0f), 0u);
        }
        let _e3459 = phi_4187_;
        if (_e108.shift < arrayLength((&samples.member))) {
        } else {
            return;
        }
        samples.member[(0u + _e108.shift)] = _e3459;
        if (_e2819.triangle != 4294967295u) {
            let _e3468 = ((1f - _e2819.u) - _e2819.v);
            if (_e2819.triangle < _e81) {
            } else {
                return;
            }
            let _e3473 = triangles.member[(0u + _e2819.triangle)];
            let _e3475 = (_e3473.i0_ & 2147483647u);
            if (_e3475 < _e99) {
            } else {
                return;
            }
            let _e3481 = before.member[(0u + _e3475)];
            if (_e3473.i1_ < _e99) {
            } else {
                return;
            }
            let _e3485 = before.member[(0u + _e3473.i1_)];
            if (_e3473.i2_ < _e99) {
            } else {
                return;
            }
            let _e3489 = before.member[(0u + _e3473.i2_)];
            if (_e2819.instance < _e93) {
            } else {
                return;
            }
            let _e3499 = instances.member[(0u + _e2819.instance)].object_to_world[0u];
            let _e3512 = instances.member[(0u + _e2819.instance)].object_to_world[1u];
            let _e3525 = instances.member[(0u + _e2819.instance)].object_to_world[2u];
            if (_e2819.instance < _e93) {
            } else {
                return;
            }
            let _e3549 = instances.member[(0u + _e2819.instance)].object_to_world[0u];
            let _e3562 = instances.member[(0u + _e2819.instance)].object_to_world[1u];
            let _e3575 = instances.member[(0u + _e2819.instance)].object_to_world[2u];
            if (_e2819.instance < _e93) {
            } else {
                return;
            }
            let _e3602 = instances.member[(0u + _e2819.instance)].object_to_world[0u];
            let _e3615 = instances.member[(0u + _e2819.instance)].object_to_world[1u];
            let _e3628 = instances.member[(0u + _e2819.instance)].object_to_world[2u];
            phi_4410_ = vec3<f32>((((((((_e3499.x * _e3481.x) + (_e3499.y * _e3481.y)) + (_e3499.z * _e3481.z)) + (_e3499.w * 1f)) * _e3468) + (((((_e3549.x * _e3485.x) + (_e3549.y * _e3485.y)) + (_e3549.z * _e3485.z)) + (_e3549.w * 1f)) * _e2819.u)) + (((((_e3602.x * _e3489.x) + (_e3602.y * _e3489.y)) + (_e3602.z * _e3489.z)) + (_e3602.w * 1f)) * _e2819.v)), (((((((_e3512.x * _e3481.x) + (_e3512.y * _e3481.y)) + (_e3512.z * _e3481.z)) + (_e3512.w * 1f)) * _e3468) + (((((_e3562.x * _e3485.x) + (_e3562.y * _e3485.y)) + (_e3562.z * _e3485.z)) + (_e3562.w * 1f)) * _e2819.u)) + (((((_e3615.x * _e3489.x) + (_e3615.y * _e3489.y)) + (_e3615.z * _e3489.z)) + (_e3615.w * 1f)) * _e2819.v)), (((((((_e3525.x * _e3481.x) + (_e3525.y * _e3481.y)) + (_e3525.z * _e3481.z)) + (_e3525.w * 1f)) * _e3468) + (((((_e3575.x * _e3485.x) + (_e3575.y * _e3485.y)) + (_e3575.z * _e3485.z)) + (_e3575.w * 1f)) * _e2819.u)) + (((((_e3628.x * _e3489.x) + (_e3628.y * _e3489.y)) + (_e3628.z * _e3489.z)) + (_e3628.w * 1f)) * _e2819.v)));
        } else {
            phi_4410_ = vec3<f32>(0f, 0f, 0f);
        }
        let _e3648 = phi_4410_;
        if (_e108.shift < arrayLength((&past.member))) {
        } else {
            return;
        }
        past.member[(0u + _e108.shift)] = vec4<f32>(_e3648.x, _e3648.y, _e3648.z, 1f);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_camera_camera_instanced_alpha_motion_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
