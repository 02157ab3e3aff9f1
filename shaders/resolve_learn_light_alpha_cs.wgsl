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

struct type_13 {
    member: array<vec4<u32>>,
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

struct type_24 {
    member: array<abi_Sample>,
}

struct type_28 {
    member: array<f32>,
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

struct type_38 {
    member: abi_ShadowParams,
}

struct lt_bvh_Node {
    frame: vec4<u32>,
    links: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    z: vec4<u32>,
}

struct type_42 {
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

struct type_46 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_50 {
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

struct type_54 {
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

struct texture_TexelQuad {
    indices: array<u32, 4>,
    weights: vec4<f32>,
}

struct texture_Axis {
    low: u32,
    high: u32,
    fraction: f32,
}

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct lt_bvh_LightSpace {
    shear: vec2<f32>,
    diagonal: vec2<f32>,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    axis: u32,
    roots: vec4<u32>,
    roots_z: vec4<u32>,
}

struct type_64 {
    member: lt_bvh_LightSpace,
}

struct u0028_lt_bvh_LightPoint_u0020_u32_u0029_ {
    unnamed: lt_math_Evsm,
    unnamed_1: u32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_24;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_28;
@group(0) @binding(0) 
var<uniform> p: type_38;
@group(0) @binding(2) 
var<storage> nodes: type_42;
@group(0) @binding(3) 
var<storage> triangles: type_46;
@group(0) @binding(5) 
var<storage> list: type_9;
@group(0) @binding(6) 
var<storage, read_write> bits: type_9;
@group(0) @binding(7) 
var<storage> rows: type_13;
@group(0) @binding(8) 
var<uniform> space: type_64;
@group(0) @binding(9) 
var<storage> vertices: type_50;
@group(0) @binding(10) 
var<storage> materials: type_54;
@group(0) @binding(11) 
var<storage> alpha_texels: type_9;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_230_: bool;
    var phi_234_: f32;

    if (param != param) {
        phi_230_ = true;
    } else {
        let _e82 = (param_1 >= param);
        if _e82 {
        }
        phi_230_ = _e82;
    }
    let _e84 = phi_230_;
    if _e84 {
        phi_234_ = param_1;
    } else {
        phi_234_ = param;
    }
    let _e86 = phi_234_;
    return _e86;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_246_: bool;
    var phi_250_: f32;

    if (param_2 != param_2) {
        phi_246_ = true;
    } else {
        let _e82 = (param_3 <= param_2);
        if _e82 {
        }
        phi_246_ = _e82;
    }
    let _e84 = phi_246_;
    if _e84 {
        phi_250_ = param_3;
    } else {
        phi_250_ = param_2;
    }
    let _e86 = phi_250_;
    return _e86;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_292_: f32;
    var phi_297_: f32;
    var phi_298_: bool;
    var phi_299_: f32;
    var phi_300_: bool;
    var phi_304_: f32;
    var phi_330_: f32;
    var phi_335_: f32;
    var phi_336_: bool;
    var phi_337_: f32;
    var phi_338_: bool;
    var phi_342_: f32;
    var phi_350_: f32;
    var phi_351_: f32;
    var phi_352_: f32;
    var phi_361_: f32;
    var phi_362_: f32;
    var phi_380_: u32;
    var phi_394_: u32;
    var phi_401_: u32;
    var phi_406_: u32;
    var phi_412_: u32;
    var phi_417_: u32;
    var phi_419_: texture_Axis;
    var phi_447_: f32;
    var phi_452_: f32;
    var phi_453_: bool;
    var phi_454_: f32;
    var phi_455_: bool;
    var phi_459_: f32;
    var phi_485_: f32;
    var phi_490_: f32;
    var phi_491_: bool;
    var phi_492_: f32;
    var phi_493_: bool;
    var phi_497_: f32;
    var phi_505_: f32;
    var phi_506_: f32;
    var phi_507_: f32;
    var phi_516_: f32;
    var phi_517_: f32;
    var phi_535_: u32;
    var phi_549_: u32;
    var phi_556_: u32;
    var phi_561_: u32;
    var phi_567_: u32;
    var phi_572_: u32;
    var phi_574_: texture_Axis;

    let _e83 = (*param_4).size;
    let _e84 = (_e83 & 65535u);
    let _e86 = (*param_4).size;
    let _e88 = (_e86 >> bitcast<u32>(16i));
    let _e90 = (*param_4).flags;
    let _e92 = ((_e90 & 4u) != 0u);
    let _e94 = (*param_4).flags;
    let _e97 = ((_e94 >> bitcast<u32>(4u)) & 3u);
    if (_e97 == 0u) {
        if (param_5 > -8388608f) {
            let _e110 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e110 > param_5) {
                phi_292_ = 1f;
            } else {
                phi_292_ = 0f;
            }
            let _e113 = phi_292_;
            if (param_5 < 8388608f) {
                phi_297_ = (_e110 - _e113);
                phi_298_ = false;
            } else {
                phi_297_ = f32();
                phi_298_ = true;
            }
            let _e116 = phi_297_;
            let _e118 = phi_298_;
            phi_299_ = _e116;
            phi_300_ = _e118;
        } else {
            phi_299_ = f32();
            phi_300_ = true;
        }
        let _e120 = phi_299_;
        let _e122 = phi_300_;
        if _e122 {
            phi_304_ = param_5;
        } else {
            phi_304_ = _e120;
        }
        let _e124 = phi_304_;
        phi_352_ = (param_5 - _e124);
    } else {
        if (_e97 == 1u) {
            let _e127 = (param_5 * 0.5f);
            if (_e127 > -8388608f) {
                let _e139 = f32(select(0i, select(select(i32(_e127), i32(-2147483648), (_e127 < bitcast<f32>(3472883712u))), 2147483647i, (_e127 > bitcast<f32>(1325400063u))), (_e127 == _e127)));
                if (_e139 > _e127) {
                    phi_330_ = 1f;
                } else {
                    phi_330_ = 0f;
                }
                let _e142 = phi_330_;
                if (_e127 < 8388608f) {
                    phi_335_ = (_e139 - _e142);
                    phi_336_ = false;
                } else {
                    phi_335_ = f32();
                    phi_336_ = true;
                }
                let _e145 = phi_335_;
                let _e147 = phi_336_;
                phi_337_ = _e145;
                phi_338_ = _e147;
            } else {
                phi_337_ = f32();
                phi_338_ = true;
            }
            let _e149 = phi_337_;
            let _e151 = phi_338_;
            if _e151 {
                phi_342_ = _e127;
            } else {
                phi_342_ = _e149;
            }
            let _e153 = phi_342_;
            let _e155 = (param_5 - (2f * _e153));
            if (_e155 > 1f) {
                phi_350_ = (2f - _e155);
            } else {
                phi_350_ = _e155;
            }
            let _e159 = phi_350_;
            phi_351_ = _e159;
        } else {
            phi_351_ = param_5;
        }
        let _e161 = phi_351_;
        phi_352_ = _e161;
    }
    let _e163 = phi_352_;
    if (_e163 > 0f) {
        if (_e163 < 1f) {
            phi_361_ = _e163;
        } else {
            phi_361_ = 1f;
        }
        let _e167 = phi_361_;
        phi_362_ = _e167;
    } else {
        phi_362_ = 0f;
    }
    let _e169 = phi_362_;
    let _e170 = (_e84 - 1u);
    let _e172 = (_e169 * f32(_e84));
    if _e92 {
        let _e179 = select(select(u32(_e172), 0u, (_e172 < bitcast<f32>(0u))), 4294967295u, (_e172 > bitcast<f32>(1333788671u)));
        if (_e170 < _e179) {
            phi_380_ = _e170;
        } else {
            phi_380_ = _e179;
        }
        let _e182 = phi_380_;
        phi_419_ = texture_Axis(_e182, _e182, 0f);
    } else {
        let _e184 = (_e172 + 0.5f);
        let _e191 = select(select(u32(_e184), 0u, (_e184 < bitcast<f32>(0u))), 4294967295u, (_e184 > bitcast<f32>(1333788671u)));
        if (_e84 < _e191) {
            phi_394_ = _e84;
        } else {
            phi_394_ = _e191;
        }
        let _e194 = phi_394_;
        if (_e97 == 0u) {
            phi_401_ = _e170;
        } else {
            phi_401_ = 0u;
        }
        let _e199 = phi_401_;
        if (_e97 == 0u) {
            phi_406_ = 0u;
        } else {
            phi_406_ = _e170;
        }
        let _e202 = phi_406_;
        if (_e194 == 0u) {
            phi_412_ = _e199;
        } else {
            phi_412_ = (_e194 - 1u);
        }
        let _e206 = phi_412_;
        if (_e194 > _e170) {
            phi_417_ = _e202;
        } else {
            phi_417_ = _e194;
        }
        let _e209 = phi_417_;
        phi_419_ = texture_Axis(_e206, _e209, (_e184 - f32(_e194)));
    }
    let _e212 = phi_419_;
    let _e214 = (*param_4).flags;
    let _e217 = ((_e214 >> bitcast<u32>(6u)) & 3u);
    if (_e217 == 0u) {
        if (param_6 > -8388608f) {
            let _e230 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e230 > param_6) {
                phi_447_ = 1f;
            } else {
                phi_447_ = 0f;
            }
            let _e233 = phi_447_;
            if (param_6 < 8388608f) {
                phi_452_ = (_e230 - _e233);
                phi_453_ = false;
            } else {
                phi_452_ = f32();
                phi_453_ = true;
            }
            let _e236 = phi_452_;
            let _e238 = phi_453_;
            phi_454_ = _e236;
            phi_455_ = _e238;
        } else {
            phi_454_ = f32();
            phi_455_ = true;
        }
        let _e240 = phi_454_;
        let _e242 = phi_455_;
        if _e242 {
            phi_459_ = param_6;
        } else {
            phi_459_ = _e240;
        }
        let _e244 = phi_459_;
        phi_507_ = (param_6 - _e244);
    } else {
        if (_e217 == 1u) {
            let _e247 = (param_6 * 0.5f);
            if (_e247 > -8388608f) {
                let _e259 = f32(select(0i, select(select(i32(_e247), i32(-2147483648), (_e247 < bitcast<f32>(3472883712u))), 2147483647i, (_e247 > bitcast<f32>(1325400063u))), (_e247 == _e247)));
                if (_e259 > _e247) {
                    phi_485_ = 1f;
                } else {
                    phi_485_ = 0f;
                }
                let _e262 = phi_485_;
                if (_e247 < 8388608f) {
                    phi_490_ = (_e259 - _e262);
                    phi_491_ = false;
                } else {
                    phi_490_ = f32();
                    phi_491_ = true;
                }
                let _e265 = phi_490_;
                let _e267 = phi_491_;
                phi_492_ = _e265;
                phi_493_ = _e267;
            } else {
                phi_492_ = f32();
                phi_493_ = true;
            }
            let _e269 = phi_492_;
            let _e271 = phi_493_;
            if _e271 {
                phi_497_ = _e247;
            } else {
                phi_497_ = _e269;
            }
            let _e273 = phi_497_;
            let _e275 = (param_6 - (2f * _e273));
            if (_e275 > 1f) {
                phi_505_ = (2f - _e275);
            } else {
                phi_505_ = _e275;
            }
            let _e279 = phi_505_;
            phi_506_ = _e279;
        } else {
            phi_506_ = param_6;
        }
        let _e281 = phi_506_;
        phi_507_ = _e281;
    }
    let _e283 = phi_507_;
    if (_e283 > 0f) {
        if (_e283 < 1f) {
            phi_516_ = _e283;
        } else {
            phi_516_ = 1f;
        }
        let _e287 = phi_516_;
        phi_517_ = _e287;
    } else {
        phi_517_ = 0f;
    }
    let _e289 = phi_517_;
    let _e290 = (_e88 - 1u);
    let _e292 = (_e289 * f32(_e88));
    if _e92 {
        let _e299 = select(select(u32(_e292), 0u, (_e292 < bitcast<f32>(0u))), 4294967295u, (_e292 > bitcast<f32>(1333788671u)));
        if (_e290 < _e299) {
            phi_535_ = _e290;
        } else {
            phi_535_ = _e299;
        }
        let _e302 = phi_535_;
        phi_574_ = texture_Axis(_e302, _e302, 0f);
    } else {
        let _e304 = (_e292 + 0.5f);
        let _e311 = select(select(u32(_e304), 0u, (_e304 < bitcast<f32>(0u))), 4294967295u, (_e304 > bitcast<f32>(1333788671u)));
        if (_e88 < _e311) {
            phi_549_ = _e88;
        } else {
            phi_549_ = _e311;
        }
        let _e314 = phi_549_;
        if (_e217 == 0u) {
            phi_556_ = _e290;
        } else {
            phi_556_ = 0u;
        }
        let _e319 = phi_556_;
        if (_e217 == 0u) {
            phi_561_ = 0u;
        } else {
            phi_561_ = _e290;
        }
        let _e322 = phi_561_;
        if (_e314 == 0u) {
            phi_567_ = _e319;
        } else {
            phi_567_ = (_e314 - 1u);
        }
        let _e326 = phi_567_;
        if (_e314 > _e290) {
            phi_572_ = _e322;
        } else {
            phi_572_ = _e314;
        }
        let _e329 = phi_572_;
        phi_574_ = texture_Axis(_e326, _e329, (_e304 - f32(_e314)));
    }
    let _e332 = phi_574_;
    let _e336 = (*param_4).offset;
    let _e343 = (*param_4).offset;
    let _e350 = (*param_4).offset;
    let _e357 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e336 + (_e332.low * _e84)) + _e212.low), ((_e343 + (_e332.low * _e84)) + _e212.high), ((_e350 + (_e332.high * _e84)) + _e212.low), ((_e357 + (_e332.high * _e84)) + _e212.high)), vec4<f32>(((1f - _e212.fraction) * (1f - _e332.fraction)), (_e212.fraction * (1f - _e332.fraction)), ((1f - _e212.fraction) * _e332.fraction), (_e212.fraction * _e332.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: texture_TextureView;
    var local_3: array<u32, 32>;
    var phi_726_: f32;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_762_: bool;
    var phi_766_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_782_: bool;
    var phi_786_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_801_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_809_: bool;
    var phi_813_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_845_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_860_: bool;
    var phi_864_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_891_: bool;
    var phi_911_: bool;
    var phi_912_: bool;
    var phi_920_: u32;
    var phi_921_: f32;
    var phi_922_: u32;
    var phi_923_: f32;
    var phi_928_: f32;
    var phi_939_: u32;
    var phi_949_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_957_: u32;
    var phi_968_: vec3<f32>;
    var phi_969_: vec3<f32>;
    var phi_991_: vec3<f32>;
    var phi_992_: vec3<f32>;
    var phi_1014_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1089_: f32;
    var phi_1096_: f32;
    var phi_1103_: f32;
    var phi_1110_: f32;
    var phi_1117_: f32;
    var phi_1124_: f32;
    var phi_1141_: f32;
    var phi_1146_: f32;
    var phi_1151_: f32;
    var phi_1156_: f32;
    var phi_1161_: f32;
    var phi_1183_: bool;
    var phi_1184_: bool;
    var phi_1192_: u32;
    var phi_1193_: u32;
    var phi_1204_: vec3<f32>;
    var phi_1205_: vec3<f32>;
    var phi_1217_: u32;
    var phi_1220_: u32;
    var phi_1225_: u32;
    var phi_1227_: u32;
    var phi_1229_: u32;
    var phi_1231_: u32;
    var phi_1303_: f32;
    var phi_1304_: f32;
    var phi_1318_: u32;
    var phi_1341_: f32;
    var phi_1342_: f32;
    var phi_1356_: u32;
    var phi_1378_: f32;
    var phi_1379_: f32;
    var phi_1393_: u32;
    var phi_1416_: f32;
    var phi_1417_: f32;
    var phi_1431_: u32;
    var phi_1623_: u32;
    var phi_1624_: u32;
    var phi_1629_: u32;
    var phi_1630_: u32;
    var phi_1631_: u32;
    var phi_1228_: u32;
    var phi_1230_: u32;
    var phi_1632_: u32;
    var phi_1650_: u32;
    var phi_1651_: u32;
    var phi_1218_: u32;
    var phi_1221_: u32;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var phi_1662_: bool;
    var local_4: bool;
    var local_5: u32;
    var phi_1671_: u32;
    var local_6: u32;
    var phi_1706_: u32;
    var phi_1707_: u32;
    var phi_1713_: u32;
    var phi_1741_: vec3<f32>;
    var phi_1742_: vec3<f32>;
    var phi_1771_: vec3<f32>;
    var phi_1772_: vec3<f32>;
    var phi_1801_: vec3<f32>;
    var phi_1802_: vec3<f32>;
    var phi_1820_: bool;
    var phi_1821_: bool;
    var phi_1825_: f32;
    var phi_1826_: f32;
    var phi_1827_: f32;
    var phi_1828_: f32;
    var phi_1836_: f32;
    var phi_1846_: bool;
    var phi_1847_: bool;
    var phi_1851_: f32;
    var phi_1852_: f32;
    var phi_1853_: f32;
    var phi_1854_: f32;
    var phi_1862_: f32;
    var phi_1872_: bool;
    var phi_1873_: bool;
    var phi_1877_: f32;
    var phi_1878_: f32;
    var phi_1879_: f32;
    var phi_1880_: f32;
    var phi_1888_: f32;
    var phi_1903_: f32;
    var phi_1904_: bool;
    var phi_1905_: f32;
    var phi_1906_: bool;
    var phi_1907_: f32;
    var phi_1908_: bool;
    var phi_1926_: f32;
    var phi_1927_: bool;
    var phi_1928_: bool;
    var phi_1929_: f32;
    var phi_1930_: bool;
    var phi_1931_: bool;
    var phi_1935_: bool;
    var phi_1936_: f32;
    var phi_1937_: bool;
    var phi_1965_: vec3<f32>;
    var phi_1966_: vec3<f32>;
    var phi_1991_: vec3<f32>;
    var phi_1992_: vec3<f32>;
    var phi_2017_: vec3<f32>;
    var phi_2018_: vec3<f32>;
    var phi_2074_: f32;
    var phi_2083_: f32;
    var phi_2092_: f32;
    var phi_2101_: f32;
    var phi_2108_: f32;
    var phi_2115_: f32;
    var phi_2128_: f32;
    var phi_2137_: f32;
    var phi_2146_: f32;
    var phi_2155_: f32;
    var phi_2162_: f32;
    var phi_2169_: f32;
    var phi_2186_: f32;
    var phi_2191_: f32;
    var phi_2196_: f32;
    var phi_2204_: f32;
    var phi_2209_: f32;
    var phi_2214_: f32;
    var phi_2226_: f32;
    var phi_2231_: f32;
    var phi_2236_: f32;
    var phi_2241_: f32;
    var phi_2246_: lt_bvh_triangle_Intersection;
    var phi_2247_: bool;
    var phi_2248_: lt_bvh_triangle_Intersection;
    var phi_2249_: bool;
    var phi_2253_: lt_bvh_triangle_Intersection;
    var phi_2254_: bool;
    var phi_2255_: lt_bvh_triangle_Intersection;
    var phi_2256_: bool;
    var phi_2257_: bool;
    var phi_2261_: bool;
    var phi_2265_: lt_bvh_triangle_Intersection;
    var phi_2479_: f32;
    var phi_2482_: bool;
    var phi_2483_: bool;
    var phi_2487_: bool;
    var phi_2488_: bool;
    var phi_2489_: bool;
    var phi_2490_: bool;
    var phi_2491_: bool;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2496_: bool;
    var phi_2497_: bool;
    var phi_2498_: bool;
    var phi_2499_: bool;
    var phi_2500_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2506_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var phi_2518_: bool;
    var local_7: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var phi_2526_: bool;
    var local_8: u32;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var phi_2537_: bool;
    var local_9: bool;
    var phi_2541_: bool;
    var phi_2545_: bool;
    var phi_2549_: bool;
    var phi_2550_: bool;
    var phi_2566_: bool;
    var phi_2567_: bool;
    var phi_2568_: bool;
    var phi_2569_: bool;
    var phi_2573_: bool;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2588_: bool;
    var phi_2589_: bool;
    var phi_2593_: bool;
    var phi_2606_: bool;
    var phi_2607_: bool;
    var phi_2608_: bool;
    var phi_2612_: bool;
    var phi_2613_: bool;
    var phi_2614_: bool;
    var phi_2615_: bool;
    var phi_2616_: bool;
    var phi_2620_: bool;
    var phi_2690_: f32;
    var phi_2697_: f32;
    var phi_2704_: f32;
    var phi_2711_: f32;
    var phi_2718_: f32;
    var phi_2725_: f32;
    var phi_2742_: f32;
    var phi_2747_: f32;
    var phi_2752_: f32;
    var phi_2757_: f32;
    var phi_2762_: f32;
    var phi_2788_: bool;
    var phi_2789_: bool;
    var phi_2797_: u32;
    var phi_2798_: u32;
    var phi_2809_: vec3<f32>;
    var phi_2810_: vec3<f32>;
    var phi_2823_: u32;
    var phi_2828_: u32;
    var phi_2833_: u32;
    var phi_2947_: bool;
    var phi_2948_: bool;
    var phi_2979_: u32;
    var phi_2981_: u32;
    var phi_2984_: bool;
    var phi_3064_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3091_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3118_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3124_: u32;
    var phi_3127_: u32;
    var phi_3141_: u32;
    var phi_3151_: u32;
    var phi_3161_: u32;
    var phi_3179_: u32;
    var phi_3189_: u32;
    var phi_3199_: u32;
    var phi_3235_: u32;
    var phi_3248_: u32;
    var phi_3253_: u32;
    var phi_3254_: u32;
    var phi_3255_: u32;
    var phi_3125_: u32;
    var phi_3128_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_3313_: u32;
    var phi_3316_: bool;
    var phi_3360_: vec3<f32>;
    var phi_3361_: vec3<f32>;
    var phi_3390_: vec3<f32>;
    var phi_3391_: vec3<f32>;
    var phi_3420_: vec3<f32>;
    var phi_3421_: vec3<f32>;
    var phi_3439_: bool;
    var phi_3440_: bool;
    var phi_3444_: f32;
    var phi_3445_: f32;
    var phi_3446_: f32;
    var phi_3447_: f32;
    var phi_3455_: f32;
    var phi_3465_: bool;
    var phi_3466_: bool;
    var phi_3470_: f32;
    var phi_3471_: f32;
    var phi_3472_: f32;
    var phi_3473_: f32;
    var phi_3481_: f32;
    var phi_3491_: bool;
    var phi_3492_: bool;
    var phi_3496_: f32;
    var phi_3497_: f32;
    var phi_3498_: f32;
    var phi_3499_: f32;
    var phi_3507_: f32;
    var phi_3522_: f32;
    var phi_3523_: bool;
    var phi_3524_: f32;
    var phi_3525_: bool;
    var phi_3526_: f32;
    var phi_3527_: bool;
    var phi_3545_: f32;
    var phi_3546_: bool;
    var phi_3547_: bool;
    var phi_3548_: f32;
    var phi_3549_: bool;
    var phi_3550_: bool;
    var phi_3554_: bool;
    var phi_3555_: f32;
    var phi_3556_: bool;
    var phi_3584_: vec3<f32>;
    var phi_3585_: vec3<f32>;
    var phi_3610_: vec3<f32>;
    var phi_3611_: vec3<f32>;
    var phi_3636_: vec3<f32>;
    var phi_3637_: vec3<f32>;
    var phi_3693_: f32;
    var phi_3702_: f32;
    var phi_3711_: f32;
    var phi_3720_: f32;
    var phi_3727_: f32;
    var phi_3734_: f32;
    var phi_3747_: f32;
    var phi_3756_: f32;
    var phi_3765_: f32;
    var phi_3774_: f32;
    var phi_3781_: f32;
    var phi_3788_: f32;
    var phi_3805_: f32;
    var phi_3810_: f32;
    var phi_3815_: f32;
    var phi_3823_: f32;
    var phi_3828_: f32;
    var phi_3833_: f32;
    var phi_3845_: f32;
    var phi_3850_: f32;
    var phi_3855_: f32;
    var phi_3860_: f32;
    var phi_3865_: lt_bvh_triangle_Intersection;
    var phi_3866_: bool;
    var phi_3867_: lt_bvh_triangle_Intersection;
    var phi_3868_: bool;
    var phi_3872_: lt_bvh_triangle_Intersection;
    var phi_3873_: bool;
    var phi_3874_: lt_bvh_triangle_Intersection;
    var phi_3875_: bool;
    var phi_3876_: bool;
    var phi_3880_: bool;
    var phi_3884_: lt_bvh_triangle_Intersection;
    var phi_4098_: f32;
    var phi_4101_: bool;
    var phi_4102_: bool;
    var phi_4103_: bool;
    var phi_4107_: bool;
    var phi_4108_: bool;
    var phi_4109_: bool;
    var phi_4110_: bool;
    var phi_4111_: bool;
    var phi_4112_: bool;
    var phi_4113_: bool;
    var phi_4114_: bool;
    var phi_4115_: bool;
    var phi_4116_: bool;
    var phi_3314_: u32;
    var phi_3317_: bool;
    var phi_4120_: bool;
    var phi_4121_: bool;
    var local_13: bool;
    var phi_4163_: bool;
    var phi_4164_: bool;
    var phi_4195_: u32;
    var phi_4196_: u32;
    var phi_2982_: u32;
    var phi_2985_: bool;
    var phi_4197_: bool;
    var phi_4198_: bool;
    var phi_4199_: bool;
    var local_14: bool;
    var phi_4203_: bool;
    var phi_4207_: bool;
    var phi_4208_: bool;
    var phi_4209_: bool;
    var phi_4210_: bool;
    var phi_4214_: bool;
    var phi_4215_: bool;
    var phi_4216_: bool;
    var phi_4220_: f32;
    var phi_4261_: u32;
    var phi_4280_: u32;
    var phi_4288_: u32;
    var phi_4296_: u32;
    var phi_4301_: u32;
    var local_15: u32;
    var local_16: u32;
    var local_17: u32;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;
    var local_21: bool;
    var local_22: bool;
    var local_23: bool;
    var local_24: bool;
    var local_25: bool;
    var local_26: bool;
    var local_27: bool;

    let _e83 = id_1;
    let _e90 = arrayLength((&nodes.member));
    let _e93 = arrayLength((&triangles.member));
    let _e96 = arrayLength((&visibility.member));
    let _e99 = arrayLength((&list.member));
    let _e102 = arrayLength((&bits.member));
    let _e105 = arrayLength((&rows.member));
    let _e109 = arrayLength((&vertices.member));
    let _e112 = arrayLength((&materials.member));
    let _e115 = arrayLength((&alpha_texels.member));
    let _e119 = ((_e83.y * 2097152u) + _e83.x);
    if (3u < _e99) {
    } else {
        return;
    }
    let _e122 = list.member[3u];
    if (_e119 < _e122) {
        let _e124 = (_e119 + 4u);
        if (_e124 < _e99) {
        } else {
            return;
        }
        let _e128 = list.member[(0u + _e124)];
        let _e129 = (_e128 & 2147483647u);
        let _e130 = space.member;
        if (_e129 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e136 = samples.member[(0u + _e129)].position;
        let _e138 = samples.member[(0u + _e129)].normal;
        let _e140 = samples.member[(0u + _e129)].magnitude;
        let _e142 = ((8f / 8388608f) * _e140);
        let _e144 = (_e138.x * _e142);
        let _e146 = (_e138.y * _e142);
        let _e148 = (_e138.z * _e142);
        let _e150 = (_e136.x + _e144);
        let _e152 = (_e136.y + _e146);
        let _e154 = (_e136.z + _e148);
        let _e158 = p.member.light.place;
        if (_e158.w == 0f) {
            phi_726_ = 300000000000000000000000000000000000000f;
        } else {
            phi_726_ = 1f;
        }
        let _e162 = phi_726_;
        let _e170 = (_e158.x - (_e150 * _e158.w));
        let _e171 = (_e158.y - (_e152 * _e158.w));
        let _e172 = (_e158.z - (_e154 * _e158.w));
        let _e173 = vec3<f32>(_e170, _e171, _e172);
        let _e174 = abs(_e170);
        let _e175 = abs(_e171);
        let _e176 = abs(_e172);
        if (abs(_e150) < 1000000000000000f) {
            if (abs(_e152) < 1000000000000000f) {
                phi_759_ = (abs(_e154) < 1000000000000000f);
                phi_760_ = false;
            } else {
                phi_759_ = bool();
                phi_760_ = true;
            }
            let _e184 = phi_759_;
            let _e186 = phi_760_;
            phi_761_ = _e184;
            phi_762_ = _e186;
        } else {
            phi_761_ = bool();
            phi_762_ = true;
        }
        let _e188 = phi_761_;
        let _e190 = phi_762_;
        if _e190 {
            phi_766_ = false;
        } else {
            phi_766_ = _e188;
        }
        let _e192 = phi_766_;
        if _e192 {
            if (_e174 < 1000000000000000f) {
                if (_e175 < 1000000000000000f) {
                    phi_779_ = (_e176 < 1000000000000000f);
                    phi_780_ = false;
                } else {
                    phi_779_ = bool();
                    phi_780_ = true;
                }
                let _e197 = phi_779_;
                let _e199 = phi_780_;
                phi_781_ = _e197;
                phi_782_ = _e199;
            } else {
                phi_781_ = bool();
                phi_782_ = true;
            }
            let _e201 = phi_781_;
            let _e203 = phi_782_;
            if _e203 {
                phi_786_ = false;
            } else {
                phi_786_ = _e201;
            }
            let _e205 = phi_786_;
            if _e205 {
                if (_e174 > 0f) {
                    phi_800_ = bool();
                    phi_801_ = true;
                } else {
                    let _e207 = (_e175 > 0f);
                    if _e207 {
                        phi_799_ = bool();
                    } else {
                        phi_799_ = (_e176 > 0f);
                    }
                    let _e210 = phi_799_;
                    phi_800_ = _e210;
                    phi_801_ = _e207;
                }
                let _e212 = phi_800_;
                let _e214 = phi_801_;
                if _e214 {
                    phi_805_ = true;
                } else {
                    phi_805_ = _e212;
                }
                let _e216 = phi_805_;
                phi_806_ = _e216;
                phi_807_ = false;
            } else {
                phi_806_ = bool();
                phi_807_ = true;
            }
            let _e218 = phi_806_;
            let _e220 = phi_807_;
            phi_808_ = _e218;
            phi_809_ = _e220;
        } else {
            phi_808_ = bool();
            phi_809_ = true;
        }
        let _e222 = phi_808_;
        let _e224 = phi_809_;
        if _e224 {
            phi_813_ = false;
        } else {
            phi_813_ = _e222;
        }
        let _e226 = phi_813_;
        if _e226 {
            if (_e130.low.x <= _e150) {
                if (_e150 <= _e130.high.x) {
                    if (_e130.low.y <= _e152) {
                        phi_836_ = (_e152 <= _e130.high.y);
                        phi_837_ = false;
                    } else {
                        phi_836_ = bool();
                        phi_837_ = true;
                    }
                    let _e244 = phi_836_;
                    let _e246 = phi_837_;
                    phi_838_ = _e244;
                    phi_839_ = _e246;
                } else {
                    phi_838_ = bool();
                    phi_839_ = true;
                }
                let _e248 = phi_838_;
                let _e250 = phi_839_;
                phi_840_ = _e248;
                phi_841_ = _e250;
            } else {
                phi_840_ = bool();
                phi_841_ = true;
            }
            let _e252 = phi_840_;
            let _e254 = phi_841_;
            if _e254 {
                phi_845_ = false;
            } else {
                phi_845_ = _e252;
            }
            let _e256 = phi_845_;
            if (abs(_e170) > 0.000000000000000000000000000001f) {
                phi_859_ = bool();
                phi_860_ = true;
            } else {
                let _e261 = (abs(_e171) > 0.000000000000000000000000000001f);
                if _e261 {
                    phi_858_ = bool();
                } else {
                    phi_858_ = (abs(_e172) > 0.000000000000000000000000000001f);
                }
                let _e264 = phi_858_;
                phi_859_ = _e264;
                phi_860_ = _e261;
            }
            let _e266 = phi_859_;
            let _e268 = phi_860_;
            if _e268 {
                phi_864_ = true;
            } else {
                phi_864_ = _e266;
            }
            let _e270 = phi_864_;
            if _e256 {
                if (_e130.low.z <= _e154) {
                    if (_e154 <= _e130.high.z) {
                        if (_e130.is_parallel == 0u) {
                            phi_881_ = _e270;
                        } else {
                            phi_881_ = true;
                        }
                        let _e276 = phi_881_;
                        phi_882_ = _e276;
                        phi_883_ = false;
                    } else {
                        phi_882_ = bool();
                        phi_883_ = true;
                    }
                    let _e278 = phi_882_;
                    let _e280 = phi_883_;
                    phi_884_ = _e278;
                    phi_885_ = _e280;
                } else {
                    phi_884_ = bool();
                    phi_885_ = true;
                }
                let _e282 = phi_884_;
                let _e284 = phi_885_;
                phi_886_ = _e282;
                phi_887_ = _e284;
            } else {
                phi_886_ = bool();
                phi_887_ = true;
            }
            let _e286 = phi_886_;
            let _e288 = phi_887_;
            if _e288 {
                phi_891_ = false;
            } else {
                phi_891_ = _e286;
            }
            let _e290 = phi_891_;
            if _e290 {
                if (_e130.is_parallel == 0u) {
                    let _e293 = abs(_e170);
                    let _e294 = abs(_e171);
                    let _e295 = abs(_e172);
                    if (_e293 >= _e294) {
                        if (_e293 >= _e295) {
                            phi_911_ = false;
                        } else {
                            phi_911_ = true;
                        }
                        let _e299 = phi_911_;
                        phi_912_ = _e299;
                    } else {
                        phi_912_ = true;
                    }
                    let _e301 = phi_912_;
                    if _e301 {
                        if (_e294 >= _e295) {
                            phi_920_ = 1u;
                            phi_921_ = _e171;
                        } else {
                            phi_920_ = 2u;
                            phi_921_ = _e172;
                        }
                        let _e304 = phi_920_;
                        let _e306 = phi_921_;
                        phi_922_ = _e304;
                        phi_923_ = _e306;
                    } else {
                        phi_922_ = 0u;
                        phi_923_ = _e170;
                    }
                    let _e308 = phi_922_;
                    let _e310 = phi_923_;
                    if (_e310 < 0f) {
                        phi_928_ = -1f;
                    } else {
                        phi_928_ = 1f;
                    }
                    let _e313 = phi_928_;
                    let _e314 = (_e313 < 0f);
                    if (_e308 == 0u) {
                        if _e314 {
                            phi_939_ = _e130.roots.y;
                        } else {
                            phi_939_ = _e130.roots.x;
                        }
                        let _e321 = phi_939_;
                        phi_957_ = _e321;
                    } else {
                        if (_e308 == 1u) {
                            if _e314 {
                                phi_949_ = _e130.roots.w;
                            } else {
                                phi_949_ = _e130.roots.z;
                            }
                            let _e328 = phi_949_;
                            phi_956_ = _e328;
                        } else {
                            if _e314 {
                                phi_955_ = _e130.roots_z.y;
                            } else {
                                phi_955_ = _e130.roots_z.x;
                            }
                            let _e334 = phi_955_;
                            phi_956_ = _e334;
                        }
                        let _e336 = phi_956_;
                        phi_957_ = _e336;
                    }
                    let _e338 = phi_957_;
                    if (_e308 == 0u) {
                        phi_969_ = vec3<f32>(_e171, _e172, _e170);
                    } else {
                        if (_e308 == 1u) {
                            phi_968_ = vec3<f32>(_e172, _e170, _e171);
                        } else {
                            phi_968_ = _e173;
                        }
                        let _e344 = phi_968_;
                        phi_969_ = _e344;
                    }
                    let _e346 = phi_969_;
                    phi_1014_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e346.x / _e346.z), (_e346.y / _e346.z), (_e313 / _e346.z)), _e338);
                } else {
                    if (_e130.axis == 0u) {
                        phi_992_ = vec3<f32>(_e152, _e154, _e150);
                    } else {
                        if (_e130.axis == 1u) {
                            phi_991_ = vec3<f32>(_e154, _e150, _e152);
                        } else {
                            phi_991_ = (_e136 + vec3<f32>(_e144, _e146, _e148));
                        }
                        let _e363 = phi_991_;
                        phi_992_ = _e363;
                    }
                    let _e365 = phi_992_;
                    let _e380 = (_e365.z - _e130.middle.z);
                    phi_1014_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e365.x - _e130.middle.x) - (_e130.shear.x * _e380)), ((_e365.y - _e130.middle.y) - (_e130.shear.y * _e380)), (_e130.sign * _e380)), _e130.roots.x);
                }
                let _e391 = phi_1014_;
                if (_e391.unnamed_1 == 4294967295u) {
                    phi_2550_ = false;
                } else {
                    if (0u < _e90) {
                    } else {
                        return;
                    }
                    let _e408 = nodes.member[0u].frame[0u];
                    let _e412 = nodes.member[0u].frame[1u];
                    let _e416 = nodes.member[0u].frame[2u];
                    let _e420 = nodes.member[0u].frame[0u];
                    let _e424 = nodes.member[0u].frame[1u];
                    let _e428 = nodes.member[0u].frame[2u];
                    let _e432 = nodes.member[0u].frame[3u];
                    let _e466 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170), abs(_e171));
                    let _e467 = core_intrinsics_maximum_number_nsz_f32_(_e466, abs(_e172));
                    let _e468 = (_e467 * 0.0000000000009094947f);
                    if (abs(_e170) < _e468) {
                        phi_1089_ = _e468;
                    } else {
                        phi_1089_ = abs(_e170);
                    }
                    let _e473 = phi_1089_;
                    if (_e170 < 0f) {
                        phi_1096_ = (-1f / _e473);
                    } else {
                        phi_1096_ = (1f / _e473);
                    }
                    let _e478 = phi_1096_;
                    if (abs(_e171) < _e468) {
                        phi_1103_ = _e468;
                    } else {
                        phi_1103_ = abs(_e171);
                    }
                    let _e483 = phi_1103_;
                    if (_e171 < 0f) {
                        phi_1110_ = (-1f / _e483);
                    } else {
                        phi_1110_ = (1f / _e483);
                    }
                    let _e488 = phi_1110_;
                    if (abs(_e172) < _e468) {
                        phi_1117_ = _e468;
                    } else {
                        phi_1117_ = abs(_e172);
                    }
                    let _e493 = phi_1117_;
                    if (_e172 < 0f) {
                        phi_1124_ = (-1f / _e493);
                    } else {
                        phi_1124_ = (1f / _e493);
                    }
                    let _e498 = phi_1124_;
                    let _e502 = abs((bitcast<f32>(_e408) - _e150));
                    let _e503 = abs((bitcast<f32>(_e412) - _e152));
                    let _e504 = abs((bitcast<f32>(_e416) - _e154));
                    let _e508 = abs(((bitcast<f32>(_e420) + (bitcast<f32>((((_e432 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150));
                    let _e509 = abs(((bitcast<f32>(_e424) + (bitcast<f32>((((_e432 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e152));
                    let _e510 = abs(((bitcast<f32>(_e428) + (bitcast<f32>((((_e432 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154));
                    if (_e502 > _e508) {
                        phi_1141_ = _e502;
                    } else {
                        phi_1141_ = _e508;
                    }
                    let _e513 = phi_1141_;
                    if (_e503 > _e509) {
                        phi_1146_ = _e503;
                    } else {
                        phi_1146_ = _e509;
                    }
                    let _e516 = phi_1146_;
                    if (_e504 > _e510) {
                        phi_1151_ = _e504;
                    } else {
                        phi_1151_ = _e510;
                    }
                    let _e519 = phi_1151_;
                    if (_e513 > _e516) {
                        phi_1156_ = _e513;
                    } else {
                        phi_1156_ = _e516;
                    }
                    let _e522 = phi_1156_;
                    if (_e522 > _e519) {
                        phi_1161_ = _e522;
                    } else {
                        phi_1161_ = _e519;
                    }
                    let _e525 = phi_1161_;
                    let _e532 = (_e525 * 0.0000009536743f);
                    let _e533 = (abs(_e478) * _e532);
                    let _e534 = (abs(_e488) * _e532);
                    let _e535 = (abs(_e498) * _e532);
                    let _e536 = abs(_e170);
                    let _e537 = abs(_e171);
                    let _e538 = abs(_e172);
                    if (_e536 >= _e537) {
                        if (_e536 >= _e538) {
                            phi_1183_ = false;
                        } else {
                            phi_1183_ = true;
                        }
                        let _e542 = phi_1183_;
                        phi_1184_ = _e542;
                    } else {
                        phi_1184_ = true;
                    }
                    let _e544 = phi_1184_;
                    if _e544 {
                        if (_e537 >= _e538) {
                            phi_1192_ = 1u;
                        } else {
                            phi_1192_ = 2u;
                        }
                        let _e547 = phi_1192_;
                        phi_1193_ = _e547;
                    } else {
                        phi_1193_ = 0u;
                    }
                    let _e549 = phi_1193_;
                    if (_e549 == 0u) {
                        phi_1205_ = vec3<f32>(_e171, _e172, _e170);
                    } else {
                        if (_e549 == 1u) {
                            phi_1204_ = vec3<f32>(_e172, _e170, _e171);
                        } else {
                            phi_1204_ = _e173;
                        }
                        let _e555 = phi_1204_;
                        phi_1205_ = _e555;
                    }
                    let _e557 = phi_1205_;
                    let _e560 = (_e557.x / _e557.z);
                    let _e563 = (_e557.y / _e557.z);
                    local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_1217_ = ((_e391.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_1220_ = 0u;
                    loop {
                        let _e570 = phi_1217_;
                        let _e572 = phi_1220_;
                        phi_1225_ = _e570;
                        phi_1227_ = 0u;
                        phi_1229_ = 0u;
                        phi_1231_ = _e572;
                        loop {
                            let _e574 = phi_1225_;
                            let _e576 = phi_1227_;
                            let _e578 = phi_1229_;
                            let _e580 = phi_1231_;
                            let _e587 = (((_e574 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e574), 32u, (_e574 == 0u))) * 5u);
                            if (_e587 < _e105) {
                            } else {
                                return;
                            }
                            let _e591 = rows.member[(0u + _e587)];
                            let _e592 = (_e587 + 1u);
                            if (_e592 < _e105) {
                            } else {
                                return;
                            }
                            let _e596 = rows.member[(0u + _e592)];
                            let _e597 = (_e587 + 2u);
                            if (_e597 < _e105) {
                            } else {
                                return;
                            }
                            let _e601 = rows.member[(0u + _e597)];
                            let _e602 = (_e587 + 3u);
                            if (_e602 < _e105) {
                            } else {
                                return;
                            }
                            let _e606 = rows.member[(0u + _e602)];
                            let _e607 = (_e587 + 4u);
                            if (_e607 < _e105) {
                            } else {
                                return;
                            }
                            let _e611 = rows.member[(0u + _e607)];
                            let _e612 = lt_bvh_Node(_e591, _e596, _e601, _e606, _e611);
                            let _e614 = (_e574 & (_e574 - 1u));
                            let _e626 = (_e391.unnamed.positive_exponent - bitcast<f32>(_e612.frame.x));
                            let _e629 = bitcast<f32>((((_e612.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e626 > 0f) {
                                if (_e626 < (255f * _e629)) {
                                    phi_1303_ = (_e626 / _e629);
                                } else {
                                    phi_1303_ = 255f;
                                }
                                let _e635 = phi_1303_;
                                phi_1304_ = _e635;
                            } else {
                                phi_1304_ = 0f;
                            }
                            let _e637 = phi_1304_;
                            let _e644 = select(select(u32(_e637), 0u, (_e637 < bitcast<f32>(0u))), 4294967295u, (_e637 > bitcast<f32>(1333788671u)));
                            if (f32(_e644) < _e637) {
                                phi_1318_ = (_e644 + 1u);
                            } else {
                                phi_1318_ = _e644;
                            }
                            let _e649 = phi_1318_;
                            let _e650 = (_e644 * 16843009u);
                            let _e651 = (_e649 * 16843009u);
                            let _e661 = (_e391.unnamed.negative_exponent - bitcast<f32>(_e612.frame.y));
                            let _e664 = bitcast<f32>((((_e612.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e661 > 0f) {
                                if (_e661 < (255f * _e664)) {
                                    phi_1341_ = (_e661 / _e664);
                                } else {
                                    phi_1341_ = 255f;
                                }
                                let _e670 = phi_1341_;
                                phi_1342_ = _e670;
                            } else {
                                phi_1342_ = 0f;
                            }
                            let _e672 = phi_1342_;
                            let _e679 = select(select(u32(_e672), 0u, (_e672 < bitcast<f32>(0u))), 4294967295u, (_e672 > bitcast<f32>(1333788671u)));
                            if (f32(_e679) < _e672) {
                                phi_1356_ = (_e679 + 1u);
                            } else {
                                phi_1356_ = _e679;
                            }
                            let _e684 = phi_1356_;
                            let _e685 = (_e679 * 16843009u);
                            let _e686 = (_e684 * 16843009u);
                            let _e695 = (((_e130.diagonal.x * _e391.unnamed.positive_exponent) + (_e130.diagonal.y * _e391.unnamed.negative_exponent)) - bitcast<f32>(_e612.frame.z));
                            let _e698 = bitcast<f32>((((_e612.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e695 > 0f) {
                                if (_e695 < (255f * _e698)) {
                                    phi_1378_ = (_e695 / _e698);
                                } else {
                                    phi_1378_ = 255f;
                                }
                                let _e704 = phi_1378_;
                                phi_1379_ = _e704;
                            } else {
                                phi_1379_ = 0f;
                            }
                            let _e706 = phi_1379_;
                            let _e713 = select(select(u32(_e706), 0u, (_e706 < bitcast<f32>(0u))), 4294967295u, (_e706 > bitcast<f32>(1333788671u)));
                            if (f32(_e713) < _e706) {
                                phi_1393_ = (_e713 + 1u);
                            } else {
                                phi_1393_ = _e713;
                            }
                            let _e718 = phi_1393_;
                            let _e719 = (_e713 * 16843009u);
                            let _e720 = (_e718 * 16843009u);
                            let _e730 = (_e391.unnamed.min_variance - bitcast<f32>(_e612.frame.w));
                            let _e733 = bitcast<f32>((((_e612.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e730 > 0f) {
                                if (_e730 < (255f * _e733)) {
                                    phi_1416_ = (_e730 / _e733);
                                } else {
                                    phi_1416_ = 255f;
                                }
                                let _e739 = phi_1416_;
                                phi_1417_ = _e739;
                            } else {
                                phi_1417_ = 0f;
                            }
                            let _e741 = phi_1417_;
                            let _e748 = select(select(u32(_e741), 0u, (_e741 < bitcast<f32>(0u))), 4294967295u, (_e741 > bitcast<f32>(1333788671u)));
                            if (f32(_e748) < _e741) {
                                phi_1431_ = (_e748 + 1u);
                            } else {
                                phi_1431_ = _e748;
                            }
                            let _e753 = phi_1431_;
                            let _e754 = (_e753 * 16843009u);
                            let _e935 = (((((((((((_e650 & ~(_e612.links.x)) | (~((_e612.links.x ^ _e650)) & ((_e650 | 2155905152u) - (_e612.links.x & 2139062143u)))) & ((_e612.links.z & ~(_e651)) | (~((_e651 ^ _e612.links.z)) & ((_e612.links.z | 2155905152u) - (_e651 & 2139062143u))))) & (((_e685 & ~(_e612.x.x)) | (~((_e612.x.x ^ _e685)) & ((_e685 | 2155905152u) - (_e612.x.x & 2139062143u)))) & ((_e612.x.z & ~(_e686)) | (~((_e686 ^ _e612.x.z)) & ((_e612.x.z | 2155905152u) - (_e686 & 2139062143u)))))) & (((_e719 & ~(_e612.y.x)) | (~((_e612.y.x ^ _e719)) & ((_e719 | 2155905152u) - (_e612.y.x & 2139062143u)))) & ((_e612.y.z & ~(_e720)) | (~((_e720 ^ _e612.y.z)) & ((_e612.y.z | 2155905152u) - (_e720 & 2139062143u)))))) & ((_e612.z.x & ~(_e754)) | (~((_e754 ^ _e612.z.x)) & ((_e612.z.x | 2155905152u) - (_e754 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e650 & ~(_e612.links.y)) | (~((_e612.links.y ^ _e650)) & ((_e650 | 2155905152u) - (_e612.links.y & 2139062143u)))) & ((_e612.links.w & ~(_e651)) | (~((_e651 ^ _e612.links.w)) & ((_e612.links.w | 2155905152u) - (_e651 & 2139062143u))))) & (((_e685 & ~(_e612.x.y)) | (~((_e612.x.y ^ _e685)) & ((_e685 | 2155905152u) - (_e612.x.y & 2139062143u)))) & ((_e612.x.w & ~(_e686)) | (~((_e686 ^ _e612.x.w)) & ((_e612.x.w | 2155905152u) - (_e686 & 2139062143u)))))) & (((_e719 & ~(_e612.y.y)) | (~((_e612.y.y ^ _e719)) & ((_e719 | 2155905152u) - (_e612.y.y & 2139062143u)))) & ((_e612.y.w & ~(_e720)) | (~((_e720 ^ _e612.y.w)) & ((_e612.y.w | 2155905152u) - (_e720 & 2139062143u)))))) & ((_e612.z.y & ~(_e754)) | (~((_e754 ^ _e612.z.y)) & ((_e612.z.y | 2155905152u) - (_e754 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e612.z.w & 2147483648u) != 0u) {
                                phi_1631_ = _e614;
                                phi_1228_ = (_e612.z.w & 2147483647u);
                                phi_1230_ = _e935;
                                phi_1632_ = _e580;
                            } else {
                                if (_e935 == 0u) {
                                    phi_1629_ = _e614;
                                    phi_1630_ = _e580;
                                } else {
                                    if ((_e614 & 255u) == 0u) {
                                        phi_1624_ = _e580;
                                    } else {
                                        if (_e580 < 32u) {
                                            if (_e580 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_3[(0u + _e580)] = _e614;
                                            phi_1623_ = (_e580 + 1u);
                                        } else {
                                            phi_1623_ = _e580;
                                        }
                                        let _e952 = phi_1623_;
                                        phi_1624_ = _e952;
                                    }
                                    let _e954 = phi_1624_;
                                    phi_1629_ = (((_e612.z.w & 2147483647u) << bitcast<u32>(8i)) | _e935);
                                    phi_1630_ = _e954;
                                }
                                let _e962 = phi_1629_;
                                let _e964 = phi_1630_;
                                phi_1631_ = _e962;
                                phi_1228_ = _e576;
                                phi_1230_ = _e578;
                                phi_1632_ = _e964;
                            }
                            let _e966 = phi_1631_;
                            let _e968 = phi_1228_;
                            let _e970 = phi_1230_;
                            let _e972 = phi_1632_;
                            local_5 = _e970;
                            local_17 = _e970;
                            local_6 = _e968;
                            if ((_e966 & 255u) == 0u) {
                                if (_e972 > 0u) {
                                    let _e976 = (_e972 - 1u);
                                    if (_e976 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e980 = local_3[(0u + _e976)];
                                    phi_1650_ = _e980;
                                    phi_1651_ = _e976;
                                } else {
                                    phi_1650_ = 0u;
                                    phi_1651_ = _e972;
                                }
                                let _e982 = phi_1650_;
                                let _e984 = phi_1651_;
                                phi_1218_ = _e982;
                                phi_1221_ = _e984;
                            } else {
                                phi_1218_ = _e966;
                                phi_1221_ = _e972;
                            }
                            let _e986 = phi_1218_;
                            let _e988 = phi_1221_;
                            local_15 = _e986;
                            local_16 = _e988;
                            local_8 = _e986;
                            if (_e970 == 0u) {
                                let _e990 = (_e986 == 0u);
                                if _e990 {
                                    phi_1660_ = false;
                                } else {
                                    phi_1660_ = true;
                                }
                                let _e992 = phi_1660_;
                                phi_1661_ = _e992;
                                phi_1662_ = _e990;
                            } else {
                                phi_1661_ = false;
                                phi_1662_ = false;
                            }
                            let _e994 = phi_1661_;
                            let _e996 = phi_1662_;
                            local_4 = _e996;
                            continue;
                            continuing {
                                phi_1225_ = _e986;
                                phi_1227_ = _e968;
                                phi_1229_ = _e970;
                                phi_1231_ = _e988;
                                break if !(_e994);
                            }
                        }
                        let _e999 = local_4;
                        if _e999 {
                        }
                        let _e1001 = local_5;
                        if (_e1001 == 0u) {
                            phi_2524_ = true;
                            phi_2525_ = false;
                            phi_2526_ = false;
                        } else {
                            let _e3561 = local_17;
                            phi_1671_ = _e3561;
                            loop {
                                let _e1004 = phi_1671_;
                                let _e1007 = select(firstTrailingBit(_e1004), 32u, (_e1004 == 0u));
                                let _e1011 = local_6;
                                let _e1012 = (_e1011 + (_e1007 >> bitcast<u32>(2i)));
                                if (_e1012 < _e105) {
                                } else {
                                    return;
                                }
                                let _e1017 = rows.member[(0u + _e1012)][0u];
                                let _e1021 = rows.member[(0u + _e1012)][1u];
                                let _e1025 = rows.member[(0u + _e1012)][2u];
                                let _e1029 = rows.member[(0u + _e1012)][3u];
                                if ((_e1007 & 2u) == 0u) {
                                    phi_1706_ = _e1021;
                                    phi_1707_ = _e1017;
                                } else {
                                    phi_1706_ = _e1029;
                                    phi_1707_ = _e1025;
                                }
                                let _e1033 = phi_1706_;
                                let _e1035 = phi_1707_;
                                if ((_e1007 & 1u) == 0u) {
                                    phi_1713_ = _e1035;
                                } else {
                                    phi_1713_ = _e1033;
                                }
                                let _e1039 = phi_1713_;
                                let _e1041 = (_e1004 & (_e1004 - 1u));
                                if (_e1039 < _e93) {
                                } else {
                                    return;
                                }
                                let _e1046 = triangles.member[(0u + _e1039)].v0_;
                                let _e1048 = (_e1046.x - _e150);
                                let _e1050 = (_e1046.y - _e152);
                                let _e1052 = (_e1046.z - _e154);
                                if (_e549 == 0u) {
                                    phi_1742_ = vec3<f32>(_e1050, _e1052, _e1048);
                                } else {
                                    if (_e549 == 1u) {
                                        phi_1741_ = vec3<f32>(_e1052, _e1048, _e1050);
                                    } else {
                                        phi_1741_ = (_e1046 - vec3<f32>(_e150, _e152, _e154));
                                    }
                                    let _e1060 = phi_1741_;
                                    phi_1742_ = _e1060;
                                }
                                let _e1062 = phi_1742_;
                                let _e1066 = (_e1062.x - (_e560 * _e1062.z));
                                let _e1070 = (_e1062.y - (_e563 * _e1062.z));
                                let _e1072 = triangles.member[(0u + _e1039)].v1_;
                                let _e1074 = (_e1072.x - _e150);
                                let _e1076 = (_e1072.y - _e152);
                                let _e1078 = (_e1072.z - _e154);
                                if (_e549 == 0u) {
                                    phi_1772_ = vec3<f32>(_e1076, _e1078, _e1074);
                                } else {
                                    if (_e549 == 1u) {
                                        phi_1771_ = vec3<f32>(_e1078, _e1074, _e1076);
                                    } else {
                                        phi_1771_ = (_e1072 - vec3<f32>(_e150, _e152, _e154));
                                    }
                                    let _e1086 = phi_1771_;
                                    phi_1772_ = _e1086;
                                }
                                let _e1088 = phi_1772_;
                                let _e1092 = (_e1088.x - (_e560 * _e1088.z));
                                let _e1096 = (_e1088.y - (_e563 * _e1088.z));
                                let _e1098 = triangles.member[(0u + _e1039)].v2_;
                                let _e1100 = (_e1098.x - _e150);
                                let _e1102 = (_e1098.y - _e152);
                                let _e1104 = (_e1098.z - _e154);
                                if (_e549 == 0u) {
                                    phi_1802_ = vec3<f32>(_e1102, _e1104, _e1100);
                                } else {
                                    if (_e549 == 1u) {
                                        phi_1801_ = vec3<f32>(_e1104, _e1100, _e1102);
                                    } else {
                                        phi_1801_ = (_e1098 - vec3<f32>(_e150, _e152, _e154));
                                    }
                                    let _e1112 = phi_1801_;
                                    phi_1802_ = _e1112;
                                }
                                let _e1114 = phi_1802_;
                                let _e1118 = (_e1114.x - (_e560 * _e1114.z));
                                let _e1122 = (_e1114.y - (_e563 * _e1114.z));
                                if (_e1092 < _e1118) {
                                    phi_1821_ = true;
                                } else {
                                    if (_e1092 == _e1118) {
                                        phi_1820_ = (_e1096 < _e1122);
                                    } else {
                                        phi_1820_ = false;
                                    }
                                    let _e1127 = phi_1820_;
                                    phi_1821_ = _e1127;
                                }
                                let _e1129 = phi_1821_;
                                if _e1129 {
                                    phi_1825_ = _e1122;
                                    phi_1826_ = _e1118;
                                    phi_1827_ = _e1096;
                                    phi_1828_ = _e1092;
                                } else {
                                    phi_1825_ = _e1096;
                                    phi_1826_ = _e1092;
                                    phi_1827_ = _e1122;
                                    phi_1828_ = _e1118;
                                }
                                let _e1131 = phi_1825_;
                                let _e1133 = phi_1826_;
                                let _e1135 = phi_1827_;
                                let _e1137 = phi_1828_;
                                let _e1140 = ((_e1137 * _e1131) - (_e1135 * _e1133));
                                if _e1129 {
                                    phi_1836_ = -(_e1140);
                                } else {
                                    phi_1836_ = _e1140;
                                }
                                let _e1143 = phi_1836_;
                                if (_e1118 < _e1066) {
                                    phi_1847_ = true;
                                } else {
                                    if (_e1118 == _e1066) {
                                        phi_1846_ = (_e1122 < _e1070);
                                    } else {
                                        phi_1846_ = false;
                                    }
                                    let _e1148 = phi_1846_;
                                    phi_1847_ = _e1148;
                                }
                                let _e1150 = phi_1847_;
                                if _e1150 {
                                    phi_1851_ = _e1070;
                                    phi_1852_ = _e1066;
                                    phi_1853_ = _e1122;
                                    phi_1854_ = _e1118;
                                } else {
                                    phi_1851_ = _e1122;
                                    phi_1852_ = _e1118;
                                    phi_1853_ = _e1070;
                                    phi_1854_ = _e1066;
                                }
                                let _e1152 = phi_1851_;
                                let _e1154 = phi_1852_;
                                let _e1156 = phi_1853_;
                                let _e1158 = phi_1854_;
                                let _e1161 = ((_e1158 * _e1152) - (_e1156 * _e1154));
                                if _e1150 {
                                    phi_1862_ = -(_e1161);
                                } else {
                                    phi_1862_ = _e1161;
                                }
                                let _e1164 = phi_1862_;
                                if (_e1066 < _e1092) {
                                    phi_1873_ = true;
                                } else {
                                    if (_e1066 == _e1092) {
                                        phi_1872_ = (_e1070 < _e1096);
                                    } else {
                                        phi_1872_ = false;
                                    }
                                    let _e1169 = phi_1872_;
                                    phi_1873_ = _e1169;
                                }
                                let _e1171 = phi_1873_;
                                if _e1171 {
                                    phi_1877_ = _e1096;
                                    phi_1878_ = _e1092;
                                    phi_1879_ = _e1070;
                                    phi_1880_ = _e1066;
                                } else {
                                    phi_1877_ = _e1070;
                                    phi_1878_ = _e1066;
                                    phi_1879_ = _e1096;
                                    phi_1880_ = _e1092;
                                }
                                let _e1173 = phi_1877_;
                                let _e1175 = phi_1878_;
                                let _e1177 = phi_1879_;
                                let _e1179 = phi_1880_;
                                let _e1182 = ((_e1179 * _e1173) - (_e1177 * _e1175));
                                if _e1171 {
                                    phi_1888_ = -(_e1182);
                                } else {
                                    phi_1888_ = _e1182;
                                }
                                let _e1185 = phi_1888_;
                                if (_e1143 >= 0f) {
                                    if (_e1164 >= 0f) {
                                        if (_e1185 >= 0f) {
                                            phi_1903_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1904_ = false;
                                        } else {
                                            phi_1903_ = f32();
                                            phi_1904_ = true;
                                        }
                                        let _e1192 = phi_1903_;
                                        let _e1194 = phi_1904_;
                                        phi_1905_ = _e1192;
                                        phi_1906_ = _e1194;
                                    } else {
                                        phi_1905_ = f32();
                                        phi_1906_ = true;
                                    }
                                    let _e1196 = phi_1905_;
                                    let _e1198 = phi_1906_;
                                    phi_1907_ = _e1196;
                                    phi_1908_ = _e1198;
                                } else {
                                    phi_1907_ = f32();
                                    phi_1908_ = true;
                                }
                                let _e1200 = phi_1907_;
                                let _e1202 = phi_1908_;
                                if _e1202 {
                                    if (_e1143 <= 0f) {
                                        if (_e1164 <= 0f) {
                                            let _e1205 = (_e1185 <= 0f);
                                            if _e1205 {
                                            }
                                            phi_1926_ = ((_e1143 + _e1164) + _e1185);
                                            phi_1927_ = false;
                                            phi_1928_ = _e1205;
                                        } else {
                                            phi_1926_ = f32();
                                            phi_1927_ = true;
                                            phi_1928_ = false;
                                        }
                                        let _e1209 = phi_1926_;
                                        let _e1211 = phi_1927_;
                                        let _e1213 = phi_1928_;
                                        phi_1929_ = _e1209;
                                        phi_1930_ = _e1211;
                                        phi_1931_ = _e1213;
                                    } else {
                                        phi_1929_ = f32();
                                        phi_1930_ = true;
                                        phi_1931_ = false;
                                    }
                                    let _e1215 = phi_1929_;
                                    let _e1217 = phi_1930_;
                                    let _e1219 = phi_1931_;
                                    if _e1217 {
                                        phi_1935_ = false;
                                    } else {
                                        phi_1935_ = _e1219;
                                    }
                                    let _e1221 = phi_1935_;
                                    phi_1936_ = _e1215;
                                    phi_1937_ = _e1221;
                                } else {
                                    phi_1936_ = _e1200;
                                    phi_1937_ = true;
                                }
                                let _e1223 = phi_1936_;
                                let _e1225 = phi_1937_;
                                if _e1225 {
                                    let _e1226 = (_e1223 == 0f);
                                    if _e1226 {
                                        phi_2253_ = lt_bvh_triangle_Intersection();
                                        phi_2254_ = false;
                                    } else {
                                        let _e1228 = triangles.member[(0u + _e1039)].v0_;
                                        let _e1230 = (_e1228.x - _e150);
                                        let _e1232 = (_e1228.y - _e152);
                                        let _e1234 = (_e1228.z - _e154);
                                        if (_e549 == 0u) {
                                            phi_1966_ = vec3<f32>(_e1232, _e1234, _e1230);
                                        } else {
                                            if (_e549 == 1u) {
                                                phi_1965_ = vec3<f32>(_e1234, _e1230, _e1232);
                                            } else {
                                                phi_1965_ = (_e1228 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e1242 = phi_1965_;
                                            phi_1966_ = _e1242;
                                        }
                                        let _e1244 = phi_1966_;
                                        let _e1246 = triangles.member[(0u + _e1039)].v1_;
                                        let _e1248 = triangles.member[(0u + _e1039)].v0_;
                                        let _e1251 = (_e1246.x - _e1248.x);
                                        let _e1254 = (_e1246.y - _e1248.y);
                                        let _e1257 = (_e1246.z - _e1248.z);
                                        if (_e549 == 0u) {
                                            phi_1992_ = vec3<f32>(_e1254, _e1257, _e1251);
                                        } else {
                                            if (_e549 == 1u) {
                                                phi_1991_ = vec3<f32>(_e1257, _e1251, _e1254);
                                            } else {
                                                phi_1991_ = (_e1246 - _e1248);
                                            }
                                            let _e1264 = phi_1991_;
                                            phi_1992_ = _e1264;
                                        }
                                        let _e1266 = phi_1992_;
                                        let _e1268 = triangles.member[(0u + _e1039)].v2_;
                                        let _e1270 = triangles.member[(0u + _e1039)].v0_;
                                        let _e1273 = (_e1268.x - _e1270.x);
                                        let _e1276 = (_e1268.y - _e1270.y);
                                        let _e1279 = (_e1268.z - _e1270.z);
                                        if (_e549 == 0u) {
                                            phi_2018_ = vec3<f32>(_e1276, _e1279, _e1273);
                                        } else {
                                            if (_e549 == 1u) {
                                                phi_2017_ = vec3<f32>(_e1279, _e1273, _e1276);
                                            } else {
                                                phi_2017_ = (_e1268 - _e1270);
                                            }
                                            let _e1286 = phi_2017_;
                                            phi_2018_ = _e1286;
                                        }
                                        let _e1288 = phi_2018_;
                                        let _e1295 = ((_e1266.y * _e1288.z) - (_e1266.z * _e1288.y));
                                        let _e1302 = ((_e1266.z * _e1288.x) - (_e1266.x * _e1288.z));
                                        let _e1309 = ((_e1266.x * _e1288.y) - (_e1266.y * _e1288.x));
                                        let _e1323 = (((1f / _e557.z) * (((_e1295 * _e1244.x) + (_e1302 * _e1244.y)) + (_e1309 * _e1244.z))) / (((_e1295 * _e560) + (_e1302 * _e563)) + _e1309));
                                        if (_e1323 > 0f) {
                                            if (_e1323 < _e162) {
                                                let _e1327 = triangles.member[(0u + _e1039)].v0_;
                                                let _e1329 = triangles.member[(0u + _e1039)].v1_;
                                                if (_e1327.x < _e1329.x) {
                                                    phi_2074_ = _e1327.x;
                                                } else {
                                                    phi_2074_ = _e1329.x;
                                                }
                                                let _e1336 = phi_2074_;
                                                if (_e1327.y < _e1329.y) {
                                                    phi_2083_ = _e1327.y;
                                                } else {
                                                    phi_2083_ = _e1329.y;
                                                }
                                                let _e1343 = phi_2083_;
                                                if (_e1327.z < _e1329.z) {
                                                    phi_2092_ = _e1327.z;
                                                } else {
                                                    phi_2092_ = _e1329.z;
                                                }
                                                let _e1350 = phi_2092_;
                                                let _e1352 = triangles.member[(0u + _e1039)].v2_;
                                                if (_e1336 < _e1352.x) {
                                                    phi_2101_ = _e1336;
                                                } else {
                                                    phi_2101_ = _e1352.x;
                                                }
                                                let _e1357 = phi_2101_;
                                                if (_e1343 < _e1352.y) {
                                                    phi_2108_ = _e1343;
                                                } else {
                                                    phi_2108_ = _e1352.y;
                                                }
                                                let _e1362 = phi_2108_;
                                                if (_e1350 < _e1352.z) {
                                                    phi_2115_ = _e1350;
                                                } else {
                                                    phi_2115_ = _e1352.z;
                                                }
                                                let _e1367 = phi_2115_;
                                                let _e1369 = triangles.member[(0u + _e1039)].v0_;
                                                let _e1371 = triangles.member[(0u + _e1039)].v1_;
                                                if (_e1369.x > _e1371.x) {
                                                    phi_2128_ = _e1369.x;
                                                } else {
                                                    phi_2128_ = _e1371.x;
                                                }
                                                let _e1378 = phi_2128_;
                                                if (_e1369.y > _e1371.y) {
                                                    phi_2137_ = _e1369.y;
                                                } else {
                                                    phi_2137_ = _e1371.y;
                                                }
                                                let _e1385 = phi_2137_;
                                                if (_e1369.z > _e1371.z) {
                                                    phi_2146_ = _e1369.z;
                                                } else {
                                                    phi_2146_ = _e1371.z;
                                                }
                                                let _e1392 = phi_2146_;
                                                let _e1394 = triangles.member[(0u + _e1039)].v2_;
                                                if (_e1378 > _e1394.x) {
                                                    phi_2155_ = _e1378;
                                                } else {
                                                    phi_2155_ = _e1394.x;
                                                }
                                                let _e1399 = phi_2155_;
                                                if (_e1385 > _e1394.y) {
                                                    phi_2162_ = _e1385;
                                                } else {
                                                    phi_2162_ = _e1394.y;
                                                }
                                                let _e1404 = phi_2162_;
                                                if (_e1392 > _e1394.z) {
                                                    phi_2169_ = _e1392;
                                                } else {
                                                    phi_2169_ = _e1394.z;
                                                }
                                                let _e1409 = phi_2169_;
                                                let _e1413 = ((_e1357 - _e150) * _e478);
                                                let _e1414 = ((_e1362 - _e152) * _e488);
                                                let _e1415 = ((_e1367 - _e154) * _e498);
                                                let _e1419 = ((_e1399 - _e150) * _e478);
                                                let _e1420 = ((_e1404 - _e152) * _e488);
                                                let _e1421 = ((_e1409 - _e154) * _e498);
                                                if (_e1413 < _e1419) {
                                                    phi_2186_ = _e1413;
                                                } else {
                                                    phi_2186_ = _e1419;
                                                }
                                                let _e1424 = phi_2186_;
                                                if (_e1414 < _e1420) {
                                                    phi_2191_ = _e1414;
                                                } else {
                                                    phi_2191_ = _e1420;
                                                }
                                                let _e1427 = phi_2191_;
                                                if (_e1415 < _e1421) {
                                                    phi_2196_ = _e1415;
                                                } else {
                                                    phi_2196_ = _e1421;
                                                }
                                                let _e1430 = phi_2196_;
                                                if (_e1413 > _e1419) {
                                                    phi_2204_ = _e1413;
                                                } else {
                                                    phi_2204_ = _e1419;
                                                }
                                                let _e1436 = phi_2204_;
                                                if (_e1414 > _e1420) {
                                                    phi_2209_ = _e1414;
                                                } else {
                                                    phi_2209_ = _e1420;
                                                }
                                                let _e1439 = phi_2209_;
                                                if (_e1415 > _e1421) {
                                                    phi_2214_ = _e1415;
                                                } else {
                                                    phi_2214_ = _e1421;
                                                }
                                                let _e1442 = phi_2214_;
                                                let _e1446 = core_intrinsics_maximum_number_nsz_f32_((_e1424 - _e533), (_e1427 - _e534));
                                                let _e1447 = core_intrinsics_maximum_number_nsz_f32_(_e1446, (_e1430 - _e535));
                                                let _e1448 = core_intrinsics_minimum_number_nsz_f32_((_e1436 + _e533), (_e1439 + _e534));
                                                let _e1449 = core_intrinsics_minimum_number_nsz_f32_(_e1448, (_e1442 + _e535));
                                                if (_e1447 > -300000000000000000000000000000000000000f) {
                                                    phi_2226_ = _e1447;
                                                } else {
                                                    phi_2226_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1452 = phi_2226_;
                                                if (_e1449 < 300000000000000000000000000000000000000f) {
                                                    phi_2231_ = _e1449;
                                                } else {
                                                    phi_2231_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1455 = phi_2231_;
                                                if (_e1323 < _e1452) {
                                                    phi_2236_ = _e1452;
                                                } else {
                                                    phi_2236_ = _e1323;
                                                }
                                                let _e1458 = phi_2236_;
                                                if (_e1458 > _e1455) {
                                                    phi_2241_ = _e1455;
                                                } else {
                                                    phi_2241_ = _e1458;
                                                }
                                                let _e1461 = phi_2241_;
                                                phi_2246_ = lt_bvh_triangle_Intersection(_e1461, (_e1164 / _e1223), (_e1185 / _e1223), (_e1452 <= _e1455));
                                                phi_2247_ = false;
                                            } else {
                                                phi_2246_ = lt_bvh_triangle_Intersection();
                                                phi_2247_ = true;
                                            }
                                            let _e1467 = phi_2246_;
                                            let _e1469 = phi_2247_;
                                            phi_2248_ = _e1467;
                                            phi_2249_ = _e1469;
                                        } else {
                                            phi_2248_ = lt_bvh_triangle_Intersection();
                                            phi_2249_ = true;
                                        }
                                        let _e1471 = phi_2248_;
                                        let _e1473 = phi_2249_;
                                        if _e1473 {
                                        }
                                        phi_2253_ = _e1471;
                                        phi_2254_ = _e1473;
                                    }
                                    let _e1475 = phi_2253_;
                                    let _e1477 = phi_2254_;
                                    phi_2255_ = _e1475;
                                    phi_2256_ = _e1226;
                                    phi_2257_ = _e1477;
                                } else {
                                    phi_2255_ = lt_bvh_triangle_Intersection();
                                    phi_2256_ = true;
                                    phi_2257_ = false;
                                }
                                let _e1479 = phi_2255_;
                                let _e1481 = phi_2256_;
                                let _e1483 = phi_2257_;
                                if _e1481 {
                                    phi_2261_ = true;
                                } else {
                                    phi_2261_ = _e1483;
                                }
                                let _e1485 = phi_2261_;
                                if _e1485 {
                                    phi_2265_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2265_ = _e1479;
                                }
                                let _e1487 = phi_2265_;
                                if _e1487.is_hit {
                                    if (_e1487.t > 0f) {
                                        if (_e1487.t < _e162) {
                                            let _e1494 = triangles.member[(0u + _e1039)].i0_;
                                            let _e1496 = ((_e1494 & 2147483648u) == 0u);
                                            if _e1496 {
                                                phi_2488_ = false;
                                                phi_2489_ = false;
                                            } else {
                                                if (_e1039 < _e93) {
                                                } else {
                                                    return;
                                                }
                                                let _e1503 = triangles.member[(0u + _e1039)].i0_;
                                                let _e1504 = (_e1503 & 2147483647u);
                                                let _e1506 = triangles.member[(0u + _e1039)].i1_;
                                                let _e1508 = triangles.member[(0u + _e1039)].i2_;
                                                if (_e1504 < _e109) {
                                                } else {
                                                    return;
                                                }
                                                let _e1512 = vertices.member[(0u + _e1504)];
                                                if (_e1506 < _e109) {
                                                } else {
                                                    return;
                                                }
                                                let _e1516 = vertices.member[(0u + _e1506)];
                                                if (_e1508 < _e109) {
                                                } else {
                                                    return;
                                                }
                                                let _e1520 = vertices.member[(0u + _e1508)];
                                                let _e1521 = array<abi_Vertex, 3>(_e1512, _e1516, _e1520);
                                                if (_e1521[0].material < _e112) {
                                                } else {
                                                    return;
                                                }
                                                let _e1527 = materials.member[(0u + _e1521[0].material)];
                                                if ((_e1527.flags & 1u) == 1u) {
                                                    let _e1532 = ((1f - _e1487.u) - _e1487.v);
                                                    if (_e1527.cutoff <= 0f) {
                                                        phi_2482_ = true;
                                                    } else {
                                                        let _e1559 = (_e1527.base_color.w * ((((f32((_e1521[0].color >> bitcast<u32>(24i))) * _e1532) + (f32((_e1521[1].color >> bitcast<u32>(24i))) * _e1487.u)) + (f32((_e1521[2].color >> bitcast<u32>(24i))) * _e1487.v)) * (1f / 255f)));
                                                        if (_e1527.alpha_size == 0u) {
                                                            phi_2479_ = _e1559;
                                                        } else {
                                                            local_2.offset = _e1527.alpha_offset;
                                                            local_2.size = _e1527.alpha_size;
                                                            local_2.flags = _e1527.flags;
                                                            let _e1590 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1521[0].u * _e1532) + (_e1521[1].u * _e1487.u)) + (_e1521[2].u * _e1487.v)), (((_e1521[0].v * _e1532) + (_e1521[1].v * _e1487.u)) + (_e1521[2].v * _e1487.v)));
                                                            let _e1594 = (_e1590.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1594 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1598 = alpha_texels.member[(0u + _e1594)];
                                                            let _e1614 = (_e1590.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1614 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1618 = alpha_texels.member[(0u + _e1614)];
                                                            let _e1635 = (_e1590.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1635 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1639 = alpha_texels.member[(0u + _e1635)];
                                                            let _e1656 = (_e1590.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1656 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1660 = alpha_texels.member[(0u + _e1656)];
                                                            phi_2479_ = (_e1559 * (((((f32(((_e1598 >> bitcast<u32>((((_e1590.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1590.weights.x) + ((f32(((_e1618 >> bitcast<u32>((((_e1590.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1590.weights.y)) + ((f32(((_e1639 >> bitcast<u32>((((_e1590.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1590.weights.z)) + ((f32(((_e1660 >> bitcast<u32>((((_e1590.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1590.weights.w)));
                                                        }
                                                        let _e1676 = phi_2479_;
                                                        phi_2482_ = (_e1676 >= _e1527.cutoff);
                                                    }
                                                    let _e1680 = phi_2482_;
                                                    phi_2483_ = _e1680;
                                                } else {
                                                    phi_2483_ = false;
                                                }
                                                let _e1682 = phi_2483_;
                                                if _e1682 {
                                                    phi_2487_ = false;
                                                } else {
                                                    phi_2487_ = true;
                                                }
                                                let _e1684 = phi_2487_;
                                                phi_2488_ = _e1684;
                                                phi_2489_ = _e1682;
                                            }
                                            let _e1686 = phi_2488_;
                                            let _e1688 = phi_2489_;
                                            phi_2490_ = _e1686;
                                            phi_2491_ = _e1496;
                                            phi_2492_ = _e1688;
                                        } else {
                                            phi_2490_ = true;
                                            phi_2491_ = false;
                                            phi_2492_ = false;
                                        }
                                        let _e1690 = phi_2490_;
                                        let _e1692 = phi_2491_;
                                        let _e1694 = phi_2492_;
                                        phi_2493_ = false;
                                        phi_2494_ = _e1690;
                                        phi_2495_ = _e1692;
                                        phi_2496_ = _e1694;
                                    } else {
                                        phi_2493_ = true;
                                        phi_2494_ = false;
                                        phi_2495_ = false;
                                        phi_2496_ = false;
                                    }
                                    let _e1696 = phi_2493_;
                                    let _e1698 = phi_2494_;
                                    let _e1700 = phi_2495_;
                                    let _e1702 = phi_2496_;
                                    phi_2497_ = _e1696;
                                    phi_2498_ = _e1698;
                                    phi_2499_ = _e1700;
                                    phi_2500_ = _e1702;
                                } else {
                                    phi_2497_ = true;
                                    phi_2498_ = false;
                                    phi_2499_ = false;
                                    phi_2500_ = false;
                                }
                                let _e1704 = phi_2497_;
                                let _e1706 = phi_2498_;
                                let _e1708 = phi_2499_;
                                let _e1710 = phi_2500_;
                                if _e1704 {
                                    phi_2504_ = true;
                                    phi_2505_ = false;
                                    phi_2506_ = false;
                                } else {
                                    phi_2504_ = _e1706;
                                    phi_2505_ = _e1708;
                                    phi_2506_ = _e1710;
                                }
                                let _e1712 = phi_2504_;
                                let _e1714 = phi_2505_;
                                let _e1716 = phi_2506_;
                                if _e1712 {
                                    let _e1717 = (_e1041 == 0u);
                                    if _e1717 {
                                        phi_2514_ = false;
                                    } else {
                                        phi_2514_ = true;
                                    }
                                    let _e1719 = phi_2514_;
                                    phi_2515_ = _e1719;
                                    phi_2516_ = _e1717;
                                    phi_2517_ = false;
                                    phi_2518_ = false;
                                } else {
                                    phi_2515_ = false;
                                    phi_2516_ = false;
                                    phi_2517_ = _e1714;
                                    phi_2518_ = _e1716;
                                }
                                let _e1721 = phi_2515_;
                                let _e1723 = phi_2516_;
                                let _e1725 = phi_2517_;
                                let _e1727 = phi_2518_;
                                local_7 = _e1723;
                                local_18 = _e1725;
                                local_19 = _e1727;
                                local_20 = _e1723;
                                continue;
                                continuing {
                                    phi_1671_ = _e1041;
                                    break if !(_e1721);
                                }
                            }
                            let _e1730 = local_7;
                            if _e1730 {
                                phi_2522_ = false;
                                phi_2523_ = false;
                            } else {
                                let _e3675 = local_18;
                                phi_2522_ = _e3675;
                                let _e3678 = local_19;
                                phi_2523_ = _e3678;
                            }
                            let _e1732 = phi_2522_;
                            let _e1734 = phi_2523_;
                            let _e3681 = local_20;
                            phi_2524_ = _e3681;
                            phi_2525_ = _e1732;
                            phi_2526_ = _e1734;
                        }
                        let _e1736 = phi_2524_;
                        let _e1738 = phi_2525_;
                        let _e1740 = phi_2526_;
                        if _e1736 {
                            let _e1742 = local_8;
                            if (_e1742 == 0u) {
                                phi_2534_ = false;
                            } else {
                                phi_2534_ = true;
                            }
                            let _e1745 = phi_2534_;
                            phi_2535_ = _e1745;
                            phi_2536_ = false;
                            phi_2537_ = false;
                        } else {
                            phi_2535_ = false;
                            phi_2536_ = _e1738;
                            phi_2537_ = _e1740;
                        }
                        let _e1747 = phi_2535_;
                        let _e1749 = phi_2536_;
                        let _e1751 = phi_2537_;
                        local_9 = _e1749;
                        local_21 = _e1751;
                        local_22 = _e1749;
                        continue;
                        continuing {
                            let _e3522 = local_15;
                            phi_1217_ = _e3522;
                            let _e3525 = local_16;
                            phi_1220_ = _e3525;
                            break if !(_e1747);
                        }
                    }
                    let _e1754 = local_9;
                    if _e1754 {
                        phi_2541_ = false;
                    } else {
                        let _e3692 = local_21;
                        phi_2541_ = _e3692;
                    }
                    let _e1756 = phi_2541_;
                    if _e1756 {
                        phi_2545_ = true;
                    } else {
                        let _e3695 = local_22;
                        phi_2545_ = _e3695;
                    }
                    let _e1758 = phi_2545_;
                    if _e1758 {
                        phi_2549_ = true;
                    } else {
                        phi_2549_ = false;
                    }
                    let _e1760 = phi_2549_;
                    phi_2550_ = _e1760;
                }
                let _e1762 = phi_2550_;
                phi_4215_ = _e1762;
            } else {
                let _e1763 = abs(_e170);
                let _e1764 = abs(_e171);
                let _e1765 = abs(_e172);
                if (abs(_e150) < 1000000000000000f) {
                    if (abs(_e152) < 1000000000000000f) {
                        phi_2566_ = (abs(_e154) < 1000000000000000f);
                        phi_2567_ = false;
                    } else {
                        phi_2566_ = bool();
                        phi_2567_ = true;
                    }
                    let _e1773 = phi_2566_;
                    let _e1775 = phi_2567_;
                    phi_2568_ = _e1773;
                    phi_2569_ = _e1775;
                } else {
                    phi_2568_ = bool();
                    phi_2569_ = true;
                }
                let _e1777 = phi_2568_;
                let _e1779 = phi_2569_;
                if _e1779 {
                    phi_2573_ = false;
                } else {
                    phi_2573_ = _e1777;
                }
                let _e1781 = phi_2573_;
                if _e1781 {
                    if (_e1763 < 1000000000000000f) {
                        if (_e1764 < 1000000000000000f) {
                            phi_2586_ = (_e1765 < 1000000000000000f);
                            phi_2587_ = false;
                        } else {
                            phi_2586_ = bool();
                            phi_2587_ = true;
                        }
                        let _e1786 = phi_2586_;
                        let _e1788 = phi_2587_;
                        phi_2588_ = _e1786;
                        phi_2589_ = _e1788;
                    } else {
                        phi_2588_ = bool();
                        phi_2589_ = true;
                    }
                    let _e1790 = phi_2588_;
                    let _e1792 = phi_2589_;
                    if _e1792 {
                        phi_2593_ = false;
                    } else {
                        phi_2593_ = _e1790;
                    }
                    let _e1794 = phi_2593_;
                    if _e1794 {
                        if (_e1763 > 0f) {
                            phi_2607_ = bool();
                            phi_2608_ = true;
                        } else {
                            let _e1796 = (_e1764 > 0f);
                            if _e1796 {
                                phi_2606_ = bool();
                            } else {
                                phi_2606_ = (_e1765 > 0f);
                            }
                            let _e1799 = phi_2606_;
                            phi_2607_ = _e1799;
                            phi_2608_ = _e1796;
                        }
                        let _e1801 = phi_2607_;
                        let _e1803 = phi_2608_;
                        if _e1803 {
                            phi_2612_ = true;
                        } else {
                            phi_2612_ = _e1801;
                        }
                        let _e1805 = phi_2612_;
                        phi_2613_ = _e1805;
                        phi_2614_ = false;
                    } else {
                        phi_2613_ = bool();
                        phi_2614_ = true;
                    }
                    let _e1807 = phi_2613_;
                    let _e1809 = phi_2614_;
                    phi_2615_ = _e1807;
                    phi_2616_ = _e1809;
                } else {
                    phi_2615_ = bool();
                    phi_2616_ = true;
                }
                let _e1811 = phi_2615_;
                let _e1813 = phi_2616_;
                if _e1813 {
                    phi_2620_ = false;
                } else {
                    phi_2620_ = _e1811;
                }
                let _e1815 = phi_2620_;
                if _e1815 {
                    let _e1816 = (0u >= _e90);
                    if _e1816 {
                        phi_4208_ = bool();
                    } else {
                        if (0u < _e90) {
                        } else {
                            return;
                        }
                        let _e1822 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1826 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1830 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1834 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1838 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1842 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1846 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1880 = core_intrinsics_maximum_number_nsz_f32_(abs(_e170), abs(_e171));
                        let _e1881 = core_intrinsics_maximum_number_nsz_f32_(_e1880, abs(_e172));
                        let _e1882 = (_e1881 * 0.0000000000009094947f);
                        if (abs(_e170) < _e1882) {
                            phi_2690_ = _e1882;
                        } else {
                            phi_2690_ = abs(_e170);
                        }
                        let _e1887 = phi_2690_;
                        if (_e170 < 0f) {
                            phi_2697_ = (-1f / _e1887);
                        } else {
                            phi_2697_ = (1f / _e1887);
                        }
                        let _e1892 = phi_2697_;
                        if (abs(_e171) < _e1882) {
                            phi_2704_ = _e1882;
                        } else {
                            phi_2704_ = abs(_e171);
                        }
                        let _e1897 = phi_2704_;
                        if (_e171 < 0f) {
                            phi_2711_ = (-1f / _e1897);
                        } else {
                            phi_2711_ = (1f / _e1897);
                        }
                        let _e1902 = phi_2711_;
                        if (abs(_e172) < _e1882) {
                            phi_2718_ = _e1882;
                        } else {
                            phi_2718_ = abs(_e172);
                        }
                        let _e1907 = phi_2718_;
                        if (_e172 < 0f) {
                            phi_2725_ = (-1f / _e1907);
                        } else {
                            phi_2725_ = (1f / _e1907);
                        }
                        let _e1912 = phi_2725_;
                        let _e1916 = abs((bitcast<f32>(_e1822) - _e150));
                        let _e1917 = abs((bitcast<f32>(_e1826) - _e152));
                        let _e1918 = abs((bitcast<f32>(_e1830) - _e154));
                        let _e1922 = abs(((bitcast<f32>(_e1834) + (bitcast<f32>((((_e1846 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e150));
                        let _e1923 = abs(((bitcast<f32>(_e1838) + (bitcast<f32>((((_e1846 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e152));
                        let _e1924 = abs(((bitcast<f32>(_e1842) + (bitcast<f32>((((_e1846 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e154));
                        if (_e1916 > _e1922) {
                            phi_2742_ = _e1916;
                        } else {
                            phi_2742_ = _e1922;
                        }
                        let _e1927 = phi_2742_;
                        if (_e1917 > _e1923) {
                            phi_2747_ = _e1917;
                        } else {
                            phi_2747_ = _e1923;
                        }
                        let _e1930 = phi_2747_;
                        if (_e1918 > _e1924) {
                            phi_2752_ = _e1918;
                        } else {
                            phi_2752_ = _e1924;
                        }
                        let _e1933 = phi_2752_;
                        if (_e1927 > _e1930) {
                            phi_2757_ = _e1927;
                        } else {
                            phi_2757_ = _e1930;
                        }
                        let _e1936 = phi_2757_;
                        if (_e1936 > _e1933) {
                            phi_2762_ = _e1936;
                        } else {
                            phi_2762_ = _e1933;
                        }
                        let _e1939 = phi_2762_;
                        let _e1943 = (_e1939 * 0.0000019073486f);
                        let _e1944 = (abs(_e1892) * _e1943);
                        let _e1945 = (abs(_e1902) * _e1943);
                        let _e1946 = (abs(_e1912) * _e1943);
                        let _e1950 = (_e1939 * 0.0000009536743f);
                        let _e1951 = (abs(_e1892) * _e1950);
                        let _e1952 = (abs(_e1902) * _e1950);
                        let _e1953 = (abs(_e1912) * _e1950);
                        let _e1954 = abs(_e170);
                        let _e1955 = abs(_e171);
                        let _e1956 = abs(_e172);
                        if (_e1954 >= _e1955) {
                            if (_e1954 >= _e1956) {
                                phi_2788_ = false;
                            } else {
                                phi_2788_ = true;
                            }
                            let _e1960 = phi_2788_;
                            phi_2789_ = _e1960;
                        } else {
                            phi_2789_ = true;
                        }
                        let _e1962 = phi_2789_;
                        if _e1962 {
                            if (_e1955 >= _e1956) {
                                phi_2797_ = 1u;
                            } else {
                                phi_2797_ = 2u;
                            }
                            let _e1965 = phi_2797_;
                            phi_2798_ = _e1965;
                        } else {
                            phi_2798_ = 0u;
                        }
                        let _e1967 = phi_2798_;
                        if (_e1967 == 0u) {
                            phi_2810_ = vec3<f32>(_e171, _e172, _e170);
                        } else {
                            if (_e1967 == 1u) {
                                phi_2809_ = vec3<f32>(_e172, _e170, _e171);
                            } else {
                                phi_2809_ = _e173;
                            }
                            let _e1973 = phi_2809_;
                            phi_2810_ = _e1973;
                        }
                        let _e1975 = phi_2810_;
                        let _e1978 = (_e1975.x / _e1975.z);
                        let _e1981 = (_e1975.y / _e1975.z);
                        if (_e1892 < 0f) {
                            phi_2823_ = 0u;
                        } else {
                            phi_2823_ = 1u;
                        }
                        let _e1986 = phi_2823_;
                        if (_e1902 < 0f) {
                            phi_2828_ = 0u;
                        } else {
                            phi_2828_ = 2u;
                        }
                        let _e1989 = phi_2828_;
                        if (_e1912 < 0f) {
                            phi_2833_ = 0u;
                        } else {
                            phi_2833_ = 4u;
                        }
                        let _e1992 = phi_2833_;
                        let _e1994 = ((_e1986 | _e1989) | _e1992);
                        let _e1995 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1995.first[0], _e1995.first[1], _e1995.first[2], _e1995.first[3], _e1995.first[4], _e1995.first[5], _e1995.first[6], _e1995.first[7], _e1995.first[8], _e1995.first[9], _e1995.first[10], _e1995.first[11], _e1995.first[12], _e1995.first[13], _e1995.first[14], _e1995.first[15], _e1995.first[16], _e1995.first[17], _e1995.first[18], _e1995.first[19], _e1995.first[20], _e1995.first[21], _e1995.first[22], _e1995.first[23], _e1995.first[24], _e1995.first[25], _e1995.first[26], _e1995.first[27], _e1995.first[28], _e1995.first[29], _e1995.first[30], _e1995.first[31]), array<u32, 32>(_e1995.mask[0], _e1995.mask[1], _e1995.mask[2], _e1995.mask[3], _e1995.mask[4], _e1995.mask[5], _e1995.mask[6], _e1995.mask[7], _e1995.mask[8], _e1995.mask[9], _e1995.mask[10], _e1995.mask[11], _e1995.mask[12], _e1995.mask[13], _e1995.mask[14], _e1995.mask[15], _e1995.mask[16], _e1995.mask[17], _e1995.mask[18], _e1995.mask[19], _e1995.mask[20], _e1995.mask[21], _e1995.mask[22], _e1995.mask[23], _e1995.mask[24], _e1995.mask[25], _e1995.mask[26], _e1995.mask[27], _e1995.mask[28], _e1995.mask[29], _e1995.mask[30], _e1995.mask[31]), _e1995.len, _e1995.group, _e1995.group_mask);
                        let _e2069 = local_1.group_mask;
                        if ((_e2069 & 4278190080u) == 0u) {
                            let _e2073 = local_1.len;
                            if (_e2073 == 0u) {
                                phi_2947_ = false;
                            } else {
                                let _e2077 = local_1.len;
                                local_1.len = (_e2077 - 1u);
                                let _e2080 = local_1.len;
                                if (_e2080 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2085 = local_1.first[(0u + _e2080)];
                                local_1.group = _e2085;
                                let _e2088 = local_1.len;
                                if (_e2088 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2093 = local_1.mask[(0u + _e2088)];
                                local_1.group_mask = _e2093;
                                phi_2947_ = true;
                            }
                            let _e2096 = phi_2947_;
                            phi_2948_ = _e2096;
                        } else {
                            phi_2948_ = true;
                        }
                        let _e2098 = phi_2948_;
                        if _e2098 {
                            let _e2100 = local_1.group_mask;
                            let _e2106 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2100)), 32u, (_e2100 == 0u)));
                            let _e2110 = local_1.group_mask;
                            let _e2124 = local_1.group_mask;
                            local_1.group_mask = (_e2124 & ~((1u << bitcast<u32>((_e2106 & 31u)))));
                            let _e2127 = local_1.group;
                            phi_2979_ = (_e2127 + countOneBits(((_e2110 & ~((4294967295u << bitcast<u32>((((_e2106 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2979_ = 4294967295u;
                        }
                        let _e2130 = phi_2979_;
                        phi_2981_ = _e2130;
                        phi_2984_ = false;
                        loop {
                            let _e2132 = phi_2981_;
                            let _e2134 = phi_2984_;
                            local_27 = _e2134;
                            if (_e2132 != 4294967295u) {
                                if (_e2132 < _e90) {
                                } else {
                                    return;
                                }
                                let _e2141 = nodes.member[(0u + _e2132)].frame[3u];
                                let _e2166 = (bitcast<f32>((((_e2141 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1892);
                                let _e2167 = (bitcast<f32>((((_e2141 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1902);
                                let _e2168 = (bitcast<f32>((((_e2141 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1912);
                                let _e2171 = nodes.member[(0u + _e2132)].frame[0u];
                                let _e2175 = nodes.member[(0u + _e2132)].frame[1u];
                                let _e2179 = nodes.member[(0u + _e2132)].frame[2u];
                                let _e2184 = ((bitcast<f32>(_e2171) - _e150) * _e1892);
                                let _e2185 = ((bitcast<f32>(_e2175) - _e152) * _e1902);
                                let _e2186 = ((bitcast<f32>(_e2179) - _e154) * _e1912);
                                let _e2194 = nodes.member[(0u + _e2132)].x;
                                if (_e1892 < 0f) {
                                    let _e2205 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2194.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2211 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2205.unnamed.root, _e2194.w), _e2205.unnamed_1);
                                    let _e2217 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2211.unnamed, lt_bvh_traverse_Tree(_e2194.x, _e2211.unnamed_1.first_primitive));
                                    phi_3064_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2217.unnamed, lt_bvh_traverse_Tree(_e2217.unnamed_1.root, _e2194.y));
                                } else {
                                    let _e2233 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2194.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2239 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2233.unnamed.root, _e2194.y), _e2233.unnamed_1);
                                    let _e2245 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2239.unnamed, lt_bvh_traverse_Tree(_e2194.z, _e2239.unnamed_1.first_primitive));
                                    phi_3064_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2245.unnamed, lt_bvh_traverse_Tree(_e2245.unnamed_1.root, _e2194.w));
                                }
                                let _e2253 = phi_3064_;
                                let _e2263 = nodes.member[(0u + _e2132)].y;
                                if (_e1902 < 0f) {
                                    let _e2274 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2263.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2280 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2274.unnamed.root, _e2263.w), _e2274.unnamed_1);
                                    let _e2286 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2280.unnamed, lt_bvh_traverse_Tree(_e2263.x, _e2280.unnamed_1.first_primitive));
                                    phi_3091_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2286.unnamed, lt_bvh_traverse_Tree(_e2286.unnamed_1.root, _e2263.y));
                                } else {
                                    let _e2302 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2263.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2308 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2302.unnamed.root, _e2263.y), _e2302.unnamed_1);
                                    let _e2314 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2308.unnamed, lt_bvh_traverse_Tree(_e2263.z, _e2308.unnamed_1.first_primitive));
                                    phi_3091_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2314.unnamed, lt_bvh_traverse_Tree(_e2314.unnamed_1.root, _e2263.w));
                                }
                                let _e2322 = phi_3091_;
                                let _e2332 = nodes.member[(0u + _e2132)].z;
                                if (_e1912 < 0f) {
                                    let _e2343 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2332.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2349 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2343.unnamed.root, _e2332.w), _e2343.unnamed_1);
                                    let _e2355 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2349.unnamed, lt_bvh_traverse_Tree(_e2332.x, _e2349.unnamed_1.first_primitive));
                                    phi_3118_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2355.unnamed, lt_bvh_traverse_Tree(_e2355.unnamed_1.root, _e2332.y));
                                } else {
                                    let _e2371 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2332.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2377 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2371.unnamed.root, _e2332.y), _e2371.unnamed_1);
                                    let _e2383 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2377.unnamed, lt_bvh_traverse_Tree(_e2332.z, _e2377.unnamed_1.first_primitive));
                                    phi_3118_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2383.unnamed, lt_bvh_traverse_Tree(_e2383.unnamed_1.root, _e2332.w));
                                }
                                let _e2391 = phi_3118_;
                                phi_3124_ = 0u;
                                phi_3127_ = 0u;
                                loop {
                                    let _e2401 = phi_3124_;
                                    let _e2403 = phi_3127_;
                                    local_10 = _e2403;
                                    local_11 = _e2403;
                                    local_12 = _e2403;
                                    let _e2404 = (_e2401 < 8u);
                                    if _e2404 {
                                        let _e2406 = (_e2401 >> bitcast<u32>(2i));
                                        let _e2407 = (_e2401 & 3u);
                                        if (_e2406 == 0u) {
                                            phi_3141_ = _e2253.unnamed.root;
                                        } else {
                                            phi_3141_ = _e2253.unnamed.first_primitive;
                                        }
                                        let _e2410 = phi_3141_;
                                        if (_e2406 == 0u) {
                                            phi_3151_ = _e2322.unnamed.root;
                                        } else {
                                            phi_3151_ = _e2322.unnamed.first_primitive;
                                        }
                                        let _e2419 = phi_3151_;
                                        if (_e2406 == 0u) {
                                            phi_3161_ = _e2391.unnamed.root;
                                        } else {
                                            phi_3161_ = _e2391.unnamed.first_primitive;
                                        }
                                        let _e2428 = phi_3161_;
                                        let _e2441 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2410 >> bitcast<u32>(((_e2407 * 8u) & 31u))) & 255u)) * _e2166) + (_e2184 - _e1944)), ((f32(((_e2419 >> bitcast<u32>(((_e2407 * 8u) & 31u))) & 255u)) * _e2167) + (_e2185 - _e1945)));
                                        let _e2442 = core_intrinsics_maximum_number_nsz_f32_(_e2441, ((f32(((_e2428 >> bitcast<u32>(((_e2407 * 8u) & 31u))) & 255u)) * _e2168) + (_e2186 - _e1946)));
                                        if (_e2406 == 0u) {
                                            phi_3179_ = _e2253.unnamed_1.root;
                                        } else {
                                            phi_3179_ = _e2253.unnamed_1.first_primitive;
                                        }
                                        let _e2445 = phi_3179_;
                                        if (_e2406 == 0u) {
                                            phi_3189_ = _e2322.unnamed_1.root;
                                        } else {
                                            phi_3189_ = _e2322.unnamed_1.first_primitive;
                                        }
                                        let _e2454 = phi_3189_;
                                        if (_e2406 == 0u) {
                                            phi_3199_ = _e2391.unnamed_1.root;
                                        } else {
                                            phi_3199_ = _e2391.unnamed_1.first_primitive;
                                        }
                                        let _e2463 = phi_3199_;
                                        let _e2476 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2445 >> bitcast<u32>(((_e2407 * 8u) & 31u))) & 255u)) * _e2166) + (_e2184 + _e1944)), ((f32(((_e2454 >> bitcast<u32>(((_e2407 * 8u) & 31u))) & 255u)) * _e2167) + (_e2185 + _e1945)));
                                        let _e2477 = core_intrinsics_minimum_number_nsz_f32_(_e2476, ((f32(((_e2463 >> bitcast<u32>(((_e2407 * 8u) & 31u))) & 255u)) * _e2168) + (_e2186 + _e1946)));
                                        if (_e2442 <= _e2477) {
                                            if (_e2442 <= _e162) {
                                                if (_e2477 >= 0f) {
                                                    if (_e2406 == 0u) {
                                                        let _e2484 = nodes.member[(0u + _e2132)].links[2u];
                                                        phi_3235_ = _e2484;
                                                    } else {
                                                        let _e2487 = nodes.member[(0u + _e2132)].links[3u];
                                                        phi_3235_ = _e2487;
                                                    }
                                                    let _e2489 = phi_3235_;
                                                    let _e2494 = ((_e2489 >> bitcast<u32>(((_e2407 * 8u) & 31u))) & 255u);
                                                    let _e2495 = (_e2494 & 31u);
                                                    if (_e2495 >= 24u) {
                                                        phi_3248_ = (24u + ((_e2495 - 24u) ^ _e1994));
                                                    } else {
                                                        phi_3248_ = _e2495;
                                                    }
                                                    let _e2501 = phi_3248_;
                                                    phi_3253_ = (_e2403 | ((_e2494 >> bitcast<u32>(5i)) << bitcast<u32>((_e2501 & 31u))));
                                                } else {
                                                    phi_3253_ = _e2403;
                                                }
                                                let _e2509 = phi_3253_;
                                                phi_3254_ = _e2509;
                                            } else {
                                                phi_3254_ = _e2403;
                                            }
                                            let _e2511 = phi_3254_;
                                            phi_3255_ = _e2511;
                                        } else {
                                            phi_3255_ = _e2403;
                                        }
                                        let _e2513 = phi_3255_;
                                        phi_3125_ = (_e2401 + 1u);
                                        phi_3128_ = _e2513;
                                    } else {
                                        phi_3125_ = u32();
                                        phi_3128_ = u32();
                                    }
                                    let _e2516 = phi_3125_;
                                    let _e2518 = phi_3128_;
                                    continue;
                                    continuing {
                                        phi_3124_ = _e2516;
                                        phi_3127_ = _e2518;
                                        break if !(_e2404);
                                    }
                                }
                                let _e2522 = nodes.member[(0u + _e2132)].links[0u];
                                let _e2526 = nodes.member[(0u + _e2132)].frame[3u];
                                let _e2530 = local_10;
                                if ((_e2530 & 4278190080u) == 0u) {
                                } else {
                                    let _e2534 = local_1.group_mask;
                                    if ((_e2534 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2538 = local_1.len;
                                        if (_e2538 < 32u) {
                                            let _e2541 = local_1.group;
                                            let _e2543 = local_1.len;
                                            if (_e2543 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2543)] = _e2541;
                                            let _e2549 = local_1.group_mask;
                                            let _e2551 = local_1.len;
                                            if (_e2551 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2551)] = _e2549;
                                            let _e2558 = local_1.len;
                                            local_1.len = (_e2558 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2522);
                                    let _e2562 = local_11;
                                    local_1.group_mask = ((_e2562 & 4278190080u) | (_e2526 >> bitcast<u32>(24i)));
                                }
                                let _e2567 = local_12;
                                phi_3313_ = (_e2567 & 16777215u);
                                phi_3316_ = _e2134;
                                loop {
                                    let _e2570 = phi_3313_;
                                    let _e2572 = phi_3316_;
                                    local_23 = _e2572;
                                    let _e2573 = (_e2570 == 0u);
                                    local_13 = _e2573;
                                    local_25 = _e2573;
                                    if _e2573 {
                                        phi_3314_ = u32();
                                        phi_3317_ = bool();
                                        phi_4120_ = bool();
                                        phi_4121_ = false;
                                    } else {
                                        let _e2576 = nodes.member[(0u + _e2132)].links[1u];
                                        let _e2581 = ((0u + _e2576) + select(firstTrailingBit(_e2570), 32u, (_e2570 == 0u)));
                                        if (_e2581 < _e93) {
                                        } else {
                                            return;
                                        }
                                        let _e2588 = triangles.member[(0u + _e2581)].v0_;
                                        let _e2590 = (_e2588.x - _e150);
                                        let _e2592 = (_e2588.y - _e152);
                                        let _e2594 = (_e2588.z - _e154);
                                        if (_e1967 == 0u) {
                                            phi_3361_ = vec3<f32>(_e2592, _e2594, _e2590);
                                        } else {
                                            if (_e1967 == 1u) {
                                                phi_3360_ = vec3<f32>(_e2594, _e2590, _e2592);
                                            } else {
                                                phi_3360_ = (_e2588 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2602 = phi_3360_;
                                            phi_3361_ = _e2602;
                                        }
                                        let _e2604 = phi_3361_;
                                        let _e2608 = (_e2604.x - (_e1978 * _e2604.z));
                                        let _e2612 = (_e2604.y - (_e1981 * _e2604.z));
                                        let _e2614 = triangles.member[(0u + _e2581)].v1_;
                                        let _e2616 = (_e2614.x - _e150);
                                        let _e2618 = (_e2614.y - _e152);
                                        let _e2620 = (_e2614.z - _e154);
                                        if (_e1967 == 0u) {
                                            phi_3391_ = vec3<f32>(_e2618, _e2620, _e2616);
                                        } else {
                                            if (_e1967 == 1u) {
                                                phi_3390_ = vec3<f32>(_e2620, _e2616, _e2618);
                                            } else {
                                                phi_3390_ = (_e2614 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2628 = phi_3390_;
                                            phi_3391_ = _e2628;
                                        }
                                        let _e2630 = phi_3391_;
                                        let _e2634 = (_e2630.x - (_e1978 * _e2630.z));
                                        let _e2638 = (_e2630.y - (_e1981 * _e2630.z));
                                        let _e2640 = triangles.member[(0u + _e2581)].v2_;
                                        let _e2642 = (_e2640.x - _e150);
                                        let _e2644 = (_e2640.y - _e152);
                                        let _e2646 = (_e2640.z - _e154);
                                        if (_e1967 == 0u) {
                                            phi_3421_ = vec3<f32>(_e2644, _e2646, _e2642);
                                        } else {
                                            if (_e1967 == 1u) {
                                                phi_3420_ = vec3<f32>(_e2646, _e2642, _e2644);
                                            } else {
                                                phi_3420_ = (_e2640 - vec3<f32>(_e150, _e152, _e154));
                                            }
                                            let _e2654 = phi_3420_;
                                            phi_3421_ = _e2654;
                                        }
                                        let _e2656 = phi_3421_;
                                        let _e2660 = (_e2656.x - (_e1978 * _e2656.z));
                                        let _e2664 = (_e2656.y - (_e1981 * _e2656.z));
                                        if (_e2634 < _e2660) {
                                            phi_3440_ = true;
                                        } else {
                                            if (_e2634 == _e2660) {
                                                phi_3439_ = (_e2638 < _e2664);
                                            } else {
                                                phi_3439_ = false;
                                            }
                                            let _e2669 = phi_3439_;
                                            phi_3440_ = _e2669;
                                        }
                                        let _e2671 = phi_3440_;
                                        if _e2671 {
                                            phi_3444_ = _e2664;
                                            phi_3445_ = _e2660;
                                            phi_3446_ = _e2638;
                                            phi_3447_ = _e2634;
                                        } else {
                                            phi_3444_ = _e2638;
                                            phi_3445_ = _e2634;
                                            phi_3446_ = _e2664;
                                            phi_3447_ = _e2660;
                                        }
                                        let _e2673 = phi_3444_;
                                        let _e2675 = phi_3445_;
                                        let _e2677 = phi_3446_;
                                        let _e2679 = phi_3447_;
                                        let _e2682 = ((_e2679 * _e2673) - (_e2677 * _e2675));
                                        if _e2671 {
                                            phi_3455_ = -(_e2682);
                                        } else {
                                            phi_3455_ = _e2682;
                                        }
                                        let _e2685 = phi_3455_;
                                        if (_e2660 < _e2608) {
                                            phi_3466_ = true;
                                        } else {
                                            if (_e2660 == _e2608) {
                                                phi_3465_ = (_e2664 < _e2612);
                                            } else {
                                                phi_3465_ = false;
                                            }
                                            let _e2690 = phi_3465_;
                                            phi_3466_ = _e2690;
                                        }
                                        let _e2692 = phi_3466_;
                                        if _e2692 {
                                            phi_3470_ = _e2612;
                                            phi_3471_ = _e2608;
                                            phi_3472_ = _e2664;
                                            phi_3473_ = _e2660;
                                        } else {
                                            phi_3470_ = _e2664;
                                            phi_3471_ = _e2660;
                                            phi_3472_ = _e2612;
                                            phi_3473_ = _e2608;
                                        }
                                        let _e2694 = phi_3470_;
                                        let _e2696 = phi_3471_;
                                        let _e2698 = phi_3472_;
                                        let _e2700 = phi_3473_;
                                        let _e2703 = ((_e2700 * _e2694) - (_e2698 * _e2696));
                                        if _e2692 {
                                            phi_3481_ = -(_e2703);
                                        } else {
                                            phi_3481_ = _e2703;
                                        }
                                        let _e2706 = phi_3481_;
                                        if (_e2608 < _e2634) {
                                            phi_3492_ = true;
                                        } else {
                                            if (_e2608 == _e2634) {
                                                phi_3491_ = (_e2612 < _e2638);
                                            } else {
                                                phi_3491_ = false;
                                            }
                                            let _e2711 = phi_3491_;
                                            phi_3492_ = _e2711;
                                        }
                                        let _e2713 = phi_3492_;
                                        if _e2713 {
                                            phi_3496_ = _e2638;
                                            phi_3497_ = _e2634;
                                            phi_3498_ = _e2612;
                                            phi_3499_ = _e2608;
                                        } else {
                                            phi_3496_ = _e2612;
                                            phi_3497_ = _e2608;
                                            phi_3498_ = _e2638;
                                            phi_3499_ = _e2634;
                                        }
                                        let _e2715 = phi_3496_;
                                        let _e2717 = phi_3497_;
                                        let _e2719 = phi_3498_;
                                        let _e2721 = phi_3499_;
                                        let _e2724 = ((_e2721 * _e2715) - (_e2719 * _e2717));
                                        if _e2713 {
                                            phi_3507_ = -(_e2724);
                                        } else {
                                            phi_3507_ = _e2724;
                                        }
                                        let _e2727 = phi_3507_;
                                        if (_e2685 >= 0f) {
                                            if (_e2706 >= 0f) {
                                                if (_e2727 >= 0f) {
                                                    phi_3522_ = ((_e2685 + _e2706) + _e2727);
                                                    phi_3523_ = false;
                                                } else {
                                                    phi_3522_ = f32();
                                                    phi_3523_ = true;
                                                }
                                                let _e2734 = phi_3522_;
                                                let _e2736 = phi_3523_;
                                                phi_3524_ = _e2734;
                                                phi_3525_ = _e2736;
                                            } else {
                                                phi_3524_ = f32();
                                                phi_3525_ = true;
                                            }
                                            let _e2738 = phi_3524_;
                                            let _e2740 = phi_3525_;
                                            phi_3526_ = _e2738;
                                            phi_3527_ = _e2740;
                                        } else {
                                            phi_3526_ = f32();
                                            phi_3527_ = true;
                                        }
                                        let _e2742 = phi_3526_;
                                        let _e2744 = phi_3527_;
                                        if _e2744 {
                                            if (_e2685 <= 0f) {
                                                if (_e2706 <= 0f) {
                                                    let _e2747 = (_e2727 <= 0f);
                                                    if _e2747 {
                                                    }
                                                    phi_3545_ = ((_e2685 + _e2706) + _e2727);
                                                    phi_3546_ = false;
                                                    phi_3547_ = _e2747;
                                                } else {
                                                    phi_3545_ = f32();
                                                    phi_3546_ = true;
                                                    phi_3547_ = false;
                                                }
                                                let _e2751 = phi_3545_;
                                                let _e2753 = phi_3546_;
                                                let _e2755 = phi_3547_;
                                                phi_3548_ = _e2751;
                                                phi_3549_ = _e2753;
                                                phi_3550_ = _e2755;
                                            } else {
                                                phi_3548_ = f32();
                                                phi_3549_ = true;
                                                phi_3550_ = false;
                                            }
                                            let _e2757 = phi_3548_;
                                            let _e2759 = phi_3549_;
                                            let _e2761 = phi_3550_;
                                            if _e2759 {
                                                phi_3554_ = false;
                                            } else {
                                                phi_3554_ = _e2761;
                                            }
                                            let _e2763 = phi_3554_;
                                            phi_3555_ = _e2757;
                                            phi_3556_ = _e2763;
                                        } else {
                                            phi_3555_ = _e2742;
                                            phi_3556_ = true;
                                        }
                                        let _e2765 = phi_3555_;
                                        let _e2767 = phi_3556_;
                                        if _e2767 {
                                            let _e2768 = (_e2765 == 0f);
                                            if _e2768 {
                                                phi_3872_ = lt_bvh_triangle_Intersection();
                                                phi_3873_ = false;
                                            } else {
                                                let _e2770 = triangles.member[(0u + _e2581)].v0_;
                                                let _e2772 = (_e2770.x - _e150);
                                                let _e2774 = (_e2770.y - _e152);
                                                let _e2776 = (_e2770.z - _e154);
                                                if (_e1967 == 0u) {
                                                    phi_3585_ = vec3<f32>(_e2774, _e2776, _e2772);
                                                } else {
                                                    if (_e1967 == 1u) {
                                                        phi_3584_ = vec3<f32>(_e2776, _e2772, _e2774);
                                                    } else {
                                                        phi_3584_ = (_e2770 - vec3<f32>(_e150, _e152, _e154));
                                                    }
                                                    let _e2784 = phi_3584_;
                                                    phi_3585_ = _e2784;
                                                }
                                                let _e2786 = phi_3585_;
                                                let _e2788 = triangles.member[(0u + _e2581)].v1_;
                                                let _e2790 = triangles.member[(0u + _e2581)].v0_;
                                                let _e2793 = (_e2788.x - _e2790.x);
                                                let _e2796 = (_e2788.y - _e2790.y);
                                                let _e2799 = (_e2788.z - _e2790.z);
                                                if (_e1967 == 0u) {
                                                    phi_3611_ = vec3<f32>(_e2796, _e2799, _e2793);
                                                } else {
                                                    if (_e1967 == 1u) {
                                                        phi_3610_ = vec3<f32>(_e2799, _e2793, _e2796);
                                                    } else {
                                                        phi_3610_ = (_e2788 - _e2790);
                                                    }
                                                    let _e2806 = phi_3610_;
                                                    phi_3611_ = _e2806;
                                                }
                                                let _e2808 = phi_3611_;
                                                let _e2810 = triangles.member[(0u + _e2581)].v2_;
                                                let _e2812 = triangles.member[(0u + _e2581)].v0_;
                                                let _e2815 = (_e2810.x - _e2812.x);
                                                let _e2818 = (_e2810.y - _e2812.y);
                                                let _e2821 = (_e2810.z - _e2812.z);
                                                if (_e1967 == 0u) {
                                                    phi_3637_ = vec3<f32>(_e2818, _e2821, _e2815);
                                                } else {
                                                    if (_e1967 == 1u) {
                                                        phi_3636_ = vec3<f32>(_e2821, _e2815, _e2818);
                                                    } else {
                                                        phi_3636_ = (_e2810 - _e2812);
                                                    }
                                                    let _e2828 = phi_3636_;
                                                    phi_3637_ = _e2828;
                                                }
                                                let _e2830 = phi_3637_;
                                                let _e2837 = ((_e2808.y * _e2830.z) - (_e2808.z * _e2830.y));
                                                let _e2844 = ((_e2808.z * _e2830.x) - (_e2808.x * _e2830.z));
                                                let _e2851 = ((_e2808.x * _e2830.y) - (_e2808.y * _e2830.x));
                                                let _e2865 = (((1f / _e1975.z) * (((_e2837 * _e2786.x) + (_e2844 * _e2786.y)) + (_e2851 * _e2786.z))) / (((_e2837 * _e1978) + (_e2844 * _e1981)) + _e2851));
                                                if (_e2865 > 0f) {
                                                    if (_e2865 < _e162) {
                                                        let _e2869 = triangles.member[(0u + _e2581)].v0_;
                                                        let _e2871 = triangles.member[(0u + _e2581)].v1_;
                                                        if (_e2869.x < _e2871.x) {
                                                            phi_3693_ = _e2869.x;
                                                        } else {
                                                            phi_3693_ = _e2871.x;
                                                        }
                                                        let _e2878 = phi_3693_;
                                                        if (_e2869.y < _e2871.y) {
                                                            phi_3702_ = _e2869.y;
                                                        } else {
                                                            phi_3702_ = _e2871.y;
                                                        }
                                                        let _e2885 = phi_3702_;
                                                        if (_e2869.z < _e2871.z) {
                                                            phi_3711_ = _e2869.z;
                                                        } else {
                                                            phi_3711_ = _e2871.z;
                                                        }
                                                        let _e2892 = phi_3711_;
                                                        let _e2894 = triangles.member[(0u + _e2581)].v2_;
                                                        if (_e2878 < _e2894.x) {
                                                            phi_3720_ = _e2878;
                                                        } else {
                                                            phi_3720_ = _e2894.x;
                                                        }
                                                        let _e2899 = phi_3720_;
                                                        if (_e2885 < _e2894.y) {
                                                            phi_3727_ = _e2885;
                                                        } else {
                                                            phi_3727_ = _e2894.y;
                                                        }
                                                        let _e2904 = phi_3727_;
                                                        if (_e2892 < _e2894.z) {
                                                            phi_3734_ = _e2892;
                                                        } else {
                                                            phi_3734_ = _e2894.z;
                                                        }
                                                        let _e2909 = phi_3734_;
                                                        let _e2911 = triangles.member[(0u + _e2581)].v0_;
                                                        let _e2913 = triangles.member[(0u + _e2581)].v1_;
                                                        if (_e2911.x > _e2913.x) {
                                                            phi_3747_ = _e2911.x;
                                                        } else {
                                                            phi_3747_ = _e2913.x;
                                                        }
                                                        let _e2920 = phi_3747_;
                                                        if (_e2911.y > _e2913.y) {
                                                            phi_3756_ = _e2911.y;
                                                        } else {
                                                            phi_3756_ = _e2913.y;
                                                        }
                                                        let _e2927 = phi_3756_;
                                                        if (_e2911.z > _e2913.z) {
                                                            phi_3765_ = _e2911.z;
                                                        } else {
                                                            phi_3765_ = _e2913.z;
                                                        }
                                                        let _e2934 = phi_3765_;
                                                        let _e2936 = triangles.member[(0u + _e2581)].v2_;
                                                        if (_e2920 > _e2936.x) {
                                                            phi_3774_ = _e2920;
                                                        } else {
                                                            phi_3774_ = _e2936.x;
                                                        }
                                                        let _e2941 = phi_3774_;
                                                        if (_e2927 > _e2936.y) {
                                                            phi_3781_ = _e2927;
                                                        } else {
                                                            phi_3781_ = _e2936.y;
                                                        }
                                                        let _e2946 = phi_3781_;
                                                        if (_e2934 > _e2936.z) {
                                                            phi_3788_ = _e2934;
                                                        } else {
                                                            phi_3788_ = _e2936.z;
                                                        }
                                                        let _e2951 = phi_3788_;
                                                        let _e2955 = ((_e2899 - _e150) * _e1892);
                                                        let _e2956 = ((_e2904 - _e152) * _e1902);
                                                        let _e2957 = ((_e2909 - _e154) * _e1912);
                                                        let _e2961 = ((_e2941 - _e150) * _e1892);
                                                        let _e2962 = ((_e2946 - _e152) * _e1902);
                                                        let _e2963 = ((_e2951 - _e154) * _e1912);
                                                        if (_e2955 < _e2961) {
                                                            phi_3805_ = _e2955;
                                                        } else {
                                                            phi_3805_ = _e2961;
                                                        }
                                                        let _e2966 = phi_3805_;
                                                        if (_e2956 < _e2962) {
                                                            phi_3810_ = _e2956;
                                                        } else {
                                                            phi_3810_ = _e2962;
                                                        }
                                                        let _e2969 = phi_3810_;
                                                        if (_e2957 < _e2963) {
                                                            phi_3815_ = _e2957;
                                                        } else {
                                                            phi_3815_ = _e2963;
                                                        }
                                                        let _e2972 = phi_3815_;
                                                        if (_e2955 > _e2961) {
                                                            phi_3823_ = _e2955;
                                                        } else {
                                                            phi_3823_ = _e2961;
                                                        }
                                                        let _e2978 = phi_3823_;
                                                        if (_e2956 > _e2962) {
                                                            phi_3828_ = _e2956;
                                                        } else {
                                                            phi_3828_ = _e2962;
                                                        }
                                                        let _e2981 = phi_3828_;
                                                        if (_e2957 > _e2963) {
                                                            phi_3833_ = _e2957;
                                                        } else {
                                                            phi_3833_ = _e2963;
                                                        }
                                                        let _e2984 = phi_3833_;
                                                        let _e2988 = core_intrinsics_maximum_number_nsz_f32_((_e2966 - _e1951), (_e2969 - _e1952));
                                                        let _e2989 = core_intrinsics_maximum_number_nsz_f32_(_e2988, (_e2972 - _e1953));
                                                        let _e2990 = core_intrinsics_minimum_number_nsz_f32_((_e2978 + _e1951), (_e2981 + _e1952));
                                                        let _e2991 = core_intrinsics_minimum_number_nsz_f32_(_e2990, (_e2984 + _e1953));
                                                        if (_e2989 > -300000000000000000000000000000000000000f) {
                                                            phi_3845_ = _e2989;
                                                        } else {
                                                            phi_3845_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2994 = phi_3845_;
                                                        if (_e2991 < 300000000000000000000000000000000000000f) {
                                                            phi_3850_ = _e2991;
                                                        } else {
                                                            phi_3850_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2997 = phi_3850_;
                                                        if (_e2865 < _e2994) {
                                                            phi_3855_ = _e2994;
                                                        } else {
                                                            phi_3855_ = _e2865;
                                                        }
                                                        let _e3000 = phi_3855_;
                                                        if (_e3000 > _e2997) {
                                                            phi_3860_ = _e2997;
                                                        } else {
                                                            phi_3860_ = _e3000;
                                                        }
                                                        let _e3003 = phi_3860_;
                                                        phi_3865_ = lt_bvh_triangle_Intersection(_e3003, (_e2706 / _e2765), (_e2727 / _e2765), (_e2994 <= _e2997));
                                                        phi_3866_ = false;
                                                    } else {
                                                        phi_3865_ = lt_bvh_triangle_Intersection();
                                                        phi_3866_ = true;
                                                    }
                                                    let _e3009 = phi_3865_;
                                                    let _e3011 = phi_3866_;
                                                    phi_3867_ = _e3009;
                                                    phi_3868_ = _e3011;
                                                } else {
                                                    phi_3867_ = lt_bvh_triangle_Intersection();
                                                    phi_3868_ = true;
                                                }
                                                let _e3013 = phi_3867_;
                                                let _e3015 = phi_3868_;
                                                if _e3015 {
                                                }
                                                phi_3872_ = _e3013;
                                                phi_3873_ = _e3015;
                                            }
                                            let _e3017 = phi_3872_;
                                            let _e3019 = phi_3873_;
                                            phi_3874_ = _e3017;
                                            phi_3875_ = _e2768;
                                            phi_3876_ = _e3019;
                                        } else {
                                            phi_3874_ = lt_bvh_triangle_Intersection();
                                            phi_3875_ = true;
                                            phi_3876_ = false;
                                        }
                                        let _e3021 = phi_3874_;
                                        let _e3023 = phi_3875_;
                                        let _e3025 = phi_3876_;
                                        if _e3023 {
                                            phi_3880_ = true;
                                        } else {
                                            phi_3880_ = _e3025;
                                        }
                                        let _e3027 = phi_3880_;
                                        if _e3027 {
                                            phi_3884_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3884_ = _e3021;
                                        }
                                        let _e3029 = phi_3884_;
                                        if _e3029.is_hit {
                                            if (_e3029.t > 0f) {
                                                if (_e3029.t < _e162) {
                                                    let _e3036 = triangles.member[(0u + _e2581)].i0_;
                                                    if ((_e3036 & 2147483648u) == 0u) {
                                                        phi_4103_ = true;
                                                    } else {
                                                        if (_e2581 < _e93) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3045 = triangles.member[(0u + _e2581)].i0_;
                                                        let _e3046 = (_e3045 & 2147483647u);
                                                        let _e3048 = triangles.member[(0u + _e2581)].i1_;
                                                        let _e3050 = triangles.member[(0u + _e2581)].i2_;
                                                        if (_e3046 < _e109) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3054 = vertices.member[(0u + _e3046)];
                                                        if (_e3048 < _e109) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3058 = vertices.member[(0u + _e3048)];
                                                        if (_e3050 < _e109) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3062 = vertices.member[(0u + _e3050)];
                                                        let _e3063 = array<abi_Vertex, 3>(_e3054, _e3058, _e3062);
                                                        if (_e3063[0].material < _e112) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3069 = materials.member[(0u + _e3063[0].material)];
                                                        if ((_e3069.flags & 1u) == 1u) {
                                                            let _e3074 = ((1f - _e3029.u) - _e3029.v);
                                                            if (_e3069.cutoff <= 0f) {
                                                                phi_4101_ = true;
                                                            } else {
                                                                let _e3101 = (_e3069.base_color.w * ((((f32((_e3063[0].color >> bitcast<u32>(24i))) * _e3074) + (f32((_e3063[1].color >> bitcast<u32>(24i))) * _e3029.u)) + (f32((_e3063[2].color >> bitcast<u32>(24i))) * _e3029.v)) * (1f / 255f)));
                                                                if (_e3069.alpha_size == 0u) {
                                                                    phi_4098_ = _e3101;
                                                                } else {
                                                                    local.offset = _e3069.alpha_offset;
                                                                    local.size = _e3069.alpha_size;
                                                                    local.flags = _e3069.flags;
                                                                    let _e3132 = _lt_shaders_texture_TextureView_quad((&local), (((_e3063[0].u * _e3074) + (_e3063[1].u * _e3029.u)) + (_e3063[2].u * _e3029.v)), (((_e3063[0].v * _e3074) + (_e3063[1].v * _e3029.u)) + (_e3063[2].v * _e3029.v)));
                                                                    let _e3136 = (_e3132.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3136 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3140 = alpha_texels.member[(0u + _e3136)];
                                                                    let _e3156 = (_e3132.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3156 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3160 = alpha_texels.member[(0u + _e3156)];
                                                                    let _e3177 = (_e3132.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3177 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3181 = alpha_texels.member[(0u + _e3177)];
                                                                    let _e3198 = (_e3132.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3198 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3202 = alpha_texels.member[(0u + _e3198)];
                                                                    phi_4098_ = (_e3101 * (((((f32(((_e3140 >> bitcast<u32>((((_e3132.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3132.weights.x) + ((f32(((_e3160 >> bitcast<u32>((((_e3132.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3132.weights.y)) + ((f32(((_e3181 >> bitcast<u32>((((_e3132.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3132.weights.z)) + ((f32(((_e3202 >> bitcast<u32>((((_e3132.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3132.weights.w)));
                                                                }
                                                                let _e3218 = phi_4098_;
                                                                phi_4101_ = (_e3218 >= _e3069.cutoff);
                                                            }
                                                            let _e3222 = phi_4101_;
                                                            phi_4102_ = _e3222;
                                                        } else {
                                                            phi_4102_ = false;
                                                        }
                                                        let _e3224 = phi_4102_;
                                                        phi_4103_ = _e3224;
                                                    }
                                                    let _e3226 = phi_4103_;
                                                    if _e3226 {
                                                        phi_4107_ = false;
                                                    } else {
                                                        phi_4107_ = true;
                                                    }
                                                    let _e3228 = phi_4107_;
                                                    phi_4108_ = _e3226;
                                                    phi_4109_ = _e3226;
                                                    phi_4110_ = _e3228;
                                                } else {
                                                    phi_4108_ = bool();
                                                    phi_4109_ = _e2572;
                                                    phi_4110_ = true;
                                                }
                                                let _e3230 = phi_4108_;
                                                let _e3232 = phi_4109_;
                                                let _e3234 = phi_4110_;
                                                phi_4111_ = _e3230;
                                                phi_4112_ = _e3232;
                                                phi_4113_ = _e3234;
                                            } else {
                                                phi_4111_ = bool();
                                                phi_4112_ = _e2572;
                                                phi_4113_ = true;
                                            }
                                            let _e3236 = phi_4111_;
                                            let _e3238 = phi_4112_;
                                            let _e3240 = phi_4113_;
                                            phi_4114_ = _e3236;
                                            phi_4115_ = _e3238;
                                            phi_4116_ = _e3240;
                                        } else {
                                            phi_4114_ = bool();
                                            phi_4115_ = _e2572;
                                            phi_4116_ = true;
                                        }
                                        let _e3242 = phi_4114_;
                                        let _e3244 = phi_4115_;
                                        let _e3246 = phi_4116_;
                                        if _e3246 {
                                        }
                                        phi_3314_ = (_e2570 & (_e2570 - 1u));
                                        phi_3317_ = _e3244;
                                        phi_4120_ = _e3242;
                                        phi_4121_ = _e3246;
                                    }
                                    let _e3248 = phi_3314_;
                                    let _e3250 = phi_3317_;
                                    let _e3252 = phi_4120_;
                                    let _e3254 = phi_4121_;
                                    local_24 = _e3252;
                                    continue;
                                    continuing {
                                        phi_3313_ = _e3248;
                                        phi_3316_ = _e3250;
                                        break if !(_e3254);
                                    }
                                }
                                let _e3257 = local_13;
                                if _e3257 {
                                    let _e3259 = local_1.group_mask;
                                    if ((_e3259 & 4278190080u) == 0u) {
                                        let _e3263 = local_1.len;
                                        if (_e3263 == 0u) {
                                            phi_4163_ = false;
                                        } else {
                                            let _e3267 = local_1.len;
                                            local_1.len = (_e3267 - 1u);
                                            let _e3270 = local_1.len;
                                            if (_e3270 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3275 = local_1.first[(0u + _e3270)];
                                            local_1.group = _e3275;
                                            let _e3278 = local_1.len;
                                            if (_e3278 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3283 = local_1.mask[(0u + _e3278)];
                                            local_1.group_mask = _e3283;
                                            phi_4163_ = true;
                                        }
                                        let _e3286 = phi_4163_;
                                        phi_4164_ = _e3286;
                                    } else {
                                        phi_4164_ = true;
                                    }
                                    let _e3288 = phi_4164_;
                                    if _e3288 {
                                        let _e3290 = local_1.group_mask;
                                        let _e3296 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3290)), 32u, (_e3290 == 0u)));
                                        let _e3300 = local_1.group_mask;
                                        let _e3314 = local_1.group_mask;
                                        local_1.group_mask = (_e3314 & ~((1u << bitcast<u32>((_e3296 & 31u)))));
                                        let _e3317 = local_1.group;
                                        phi_4195_ = (_e3317 + countOneBits(((_e3300 & ~((4294967295u << bitcast<u32>((((_e3296 - 24u) ^ _e1994) & 31u))))) & 255u)));
                                    } else {
                                        phi_4195_ = 4294967295u;
                                    }
                                    let _e3320 = phi_4195_;
                                    phi_4196_ = _e3320;
                                } else {
                                    phi_4196_ = u32();
                                }
                                let _e3322 = phi_4196_;
                                phi_2982_ = _e3322;
                                let _e3872 = local_23;
                                phi_2985_ = _e3872;
                                let _e3875 = local_24;
                                phi_4197_ = _e3875;
                                let _e3878 = local_25;
                                phi_4198_ = _e3878;
                                phi_4199_ = false;
                            } else {
                                phi_2982_ = u32();
                                phi_2985_ = bool();
                                phi_4197_ = bool();
                                phi_4198_ = false;
                                phi_4199_ = true;
                            }
                            let _e3324 = phi_2982_;
                            let _e3326 = phi_2985_;
                            let _e3328 = phi_4197_;
                            let _e3330 = phi_4198_;
                            let _e3332 = phi_4199_;
                            local_14 = _e3332;
                            local_26 = _e3328;
                            continue;
                            continuing {
                                phi_2981_ = _e3324;
                                phi_2984_ = _e3326;
                                break if !(_e3330);
                            }
                        }
                        let _e3335 = local_14;
                        if _e3335 {
                            phi_4203_ = false;
                        } else {
                            phi_4203_ = true;
                        }
                        let _e3337 = phi_4203_;
                        if _e3337 {
                            let _e3884 = local_26;
                            phi_4207_ = _e3884;
                        } else {
                            let _e3886 = local_27;
                            phi_4207_ = _e3886;
                        }
                        let _e3339 = phi_4207_;
                        phi_4208_ = _e3339;
                    }
                    let _e3341 = phi_4208_;
                    phi_4209_ = _e3341;
                    phi_4210_ = _e1816;
                } else {
                    phi_4209_ = bool();
                    phi_4210_ = true;
                }
                let _e3343 = phi_4209_;
                let _e3345 = phi_4210_;
                if _e3345 {
                    phi_4214_ = false;
                } else {
                    phi_4214_ = _e3343;
                }
                let _e3347 = phi_4214_;
                phi_4215_ = _e3347;
            }
            let _e3349 = phi_4215_;
            phi_4216_ = _e3349;
        } else {
            phi_4216_ = false;
        }
        let _e3351 = phi_4216_;
        if _e3351 {
            phi_4220_ = 0f;
        } else {
            phi_4220_ = 1f;
        }
        let _e3353 = phi_4220_;
        if (_e129 < _e96) {
        } else {
            return;
        }
        visibility.member[(0u + _e129)] = _e3353;
        let _e3359 = p.member.light.number;
        let _e3360 = (_e3359 * 3u);
        let _e3361 = (_e3360 / 32u);
        let _e3362 = (_e3360 % 32u);
        let _e3364 = p.member.light.mask_words;
        if (_e129 < _e96) {
        } else {
            return;
        }
        let _e3368 = visibility.member[(0u + _e129)];
        let _e3370 = ((_e129 * _e3364) + _e3361);
        if (_e3362 > 29u) {
            let _e3372 = (_e3370 + 1u);
            if (_e3372 < _e102) {
            } else {
                return;
            }
            let _e3376 = bits.member[(0u + _e3372)];
            phi_4261_ = _e3376;
        } else {
            phi_4261_ = 0u;
        }
        let _e3378 = phi_4261_;
        if (_e3370 < _e102) {
        } else {
            return;
        }
        let _e3382 = bits.member[(0u + _e3370)];
        let _e3385 = (_e3382 >> bitcast<u32>((_e3362 & 31u)));
        if (_e3362 > 29u) {
            phi_4280_ = (_e3385 | (_e3378 << bitcast<u32>(((32u - _e3362) & 31u))));
        } else {
            phi_4280_ = _e3385;
        }
        let _e3393 = phi_4280_;
        if ((_e3393 & 2u) == 0u) {
            phi_4288_ = (_e3393 & 1u);
        } else {
            phi_4288_ = (_e3393 & 7u);
        }
        let _e3399 = phi_4288_;
        if ((_e3399 & 1u) != 0u) {
            phi_4296_ = (2u | 1u);
        } else {
            phi_4296_ = 2u;
        }
        let _e3405 = phi_4296_;
        if (_e3368 < 0.5f) {
            phi_4301_ = (_e3405 | 4u);
        } else {
            phi_4301_ = _e3405;
        }
        let _e3408 = phi_4301_;
        let _e3410 = ((_e129 * _e3364) + _e3361);
        if (_e3410 < _e102) {
        } else {
            return;
        }
        let _e3414 = bits.member[(0u + _e3410)];
        if (_e3410 < _e102) {
        } else {
            return;
        }
        bits.member[(0u + _e3410)] = ((_e3414 & ~((7u << bitcast<u32>((_e3362 & 31u))))) | (_e3408 << bitcast<u32>((_e3362 & 31u))));
        if (_e3362 > 29u) {
            let _e3428 = (_e3410 + 1u);
            if (_e3428 < _e102) {
            } else {
                return;
            }
            let _e3432 = bits.member[(0u + _e3428)];
            let _e3433 = (32u - _e3362);
            let _e3443 = (_e3410 + 1u);
            if (_e3443 < _e102) {
            } else {
                return;
            }
            bits.member[(0u + _e3443)] = ((_e3432 & ~((7u >> bitcast<u32>((_e3433 & 31u))))) | (_e3408 >> bitcast<u32>((_e3433 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
