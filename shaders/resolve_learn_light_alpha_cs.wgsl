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
    var phi_725_: f32;
    var phi_758_: bool;
    var phi_759_: bool;
    var phi_760_: bool;
    var phi_761_: bool;
    var phi_765_: bool;
    var phi_778_: bool;
    var phi_779_: bool;
    var phi_780_: bool;
    var phi_781_: bool;
    var phi_785_: bool;
    var phi_798_: bool;
    var phi_799_: bool;
    var phi_800_: bool;
    var phi_804_: bool;
    var phi_805_: bool;
    var phi_806_: bool;
    var phi_807_: bool;
    var phi_808_: bool;
    var phi_812_: bool;
    var phi_835_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_844_: bool;
    var phi_857_: bool;
    var phi_858_: bool;
    var phi_859_: bool;
    var phi_863_: bool;
    var phi_880_: bool;
    var phi_881_: bool;
    var phi_882_: bool;
    var phi_883_: bool;
    var phi_884_: bool;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_890_: bool;
    var phi_910_: bool;
    var phi_911_: bool;
    var phi_919_: u32;
    var phi_920_: f32;
    var phi_921_: u32;
    var phi_922_: f32;
    var phi_927_: f32;
    var phi_938_: u32;
    var phi_948_: u32;
    var phi_954_: u32;
    var phi_955_: u32;
    var phi_956_: u32;
    var phi_967_: vec3<f32>;
    var phi_968_: vec3<f32>;
    var phi_990_: vec3<f32>;
    var phi_991_: vec3<f32>;
    var phi_1013_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1088_: f32;
    var phi_1095_: f32;
    var phi_1102_: f32;
    var phi_1109_: f32;
    var phi_1116_: f32;
    var phi_1123_: f32;
    var phi_1140_: f32;
    var phi_1145_: f32;
    var phi_1150_: f32;
    var phi_1155_: f32;
    var phi_1160_: f32;
    var phi_1182_: bool;
    var phi_1183_: bool;
    var phi_1191_: u32;
    var phi_1192_: u32;
    var phi_1203_: vec3<f32>;
    var phi_1204_: vec3<f32>;
    var phi_1216_: u32;
    var phi_1219_: u32;
    var phi_1224_: u32;
    var phi_1226_: u32;
    var phi_1228_: u32;
    var phi_1230_: u32;
    var phi_1302_: f32;
    var phi_1303_: f32;
    var phi_1317_: u32;
    var phi_1340_: f32;
    var phi_1341_: f32;
    var phi_1355_: u32;
    var phi_1377_: f32;
    var phi_1378_: f32;
    var phi_1392_: u32;
    var phi_1415_: f32;
    var phi_1416_: f32;
    var phi_1430_: u32;
    var phi_1622_: u32;
    var phi_1623_: u32;
    var phi_1628_: u32;
    var phi_1629_: u32;
    var phi_1630_: u32;
    var phi_1227_: u32;
    var phi_1229_: u32;
    var phi_1631_: u32;
    var phi_1649_: u32;
    var phi_1650_: u32;
    var phi_1217_: u32;
    var phi_1220_: u32;
    var phi_1659_: bool;
    var phi_1660_: bool;
    var phi_1661_: bool;
    var local_4: bool;
    var local_5: u32;
    var phi_1670_: u32;
    var local_6: u32;
    var phi_1705_: u32;
    var phi_1706_: u32;
    var phi_1712_: u32;
    var phi_1740_: vec3<f32>;
    var phi_1741_: vec3<f32>;
    var phi_1770_: vec3<f32>;
    var phi_1771_: vec3<f32>;
    var phi_1800_: vec3<f32>;
    var phi_1801_: vec3<f32>;
    var phi_1819_: bool;
    var phi_1820_: bool;
    var phi_1824_: f32;
    var phi_1825_: f32;
    var phi_1826_: f32;
    var phi_1827_: f32;
    var phi_1835_: f32;
    var phi_1845_: bool;
    var phi_1846_: bool;
    var phi_1850_: f32;
    var phi_1851_: f32;
    var phi_1852_: f32;
    var phi_1853_: f32;
    var phi_1861_: f32;
    var phi_1871_: bool;
    var phi_1872_: bool;
    var phi_1876_: f32;
    var phi_1877_: f32;
    var phi_1878_: f32;
    var phi_1879_: f32;
    var phi_1887_: f32;
    var phi_1902_: f32;
    var phi_1903_: bool;
    var phi_1904_: f32;
    var phi_1905_: bool;
    var phi_1906_: f32;
    var phi_1907_: bool;
    var phi_1925_: f32;
    var phi_1926_: bool;
    var phi_1927_: bool;
    var phi_1928_: f32;
    var phi_1929_: bool;
    var phi_1930_: bool;
    var phi_1934_: bool;
    var phi_1935_: f32;
    var phi_1936_: bool;
    var phi_1964_: vec3<f32>;
    var phi_1965_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_1991_: vec3<f32>;
    var phi_2016_: vec3<f32>;
    var phi_2017_: vec3<f32>;
    var phi_2073_: f32;
    var phi_2082_: f32;
    var phi_2091_: f32;
    var phi_2100_: f32;
    var phi_2107_: f32;
    var phi_2114_: f32;
    var phi_2127_: f32;
    var phi_2136_: f32;
    var phi_2145_: f32;
    var phi_2154_: f32;
    var phi_2161_: f32;
    var phi_2168_: f32;
    var phi_2185_: f32;
    var phi_2190_: f32;
    var phi_2195_: f32;
    var phi_2203_: f32;
    var phi_2208_: f32;
    var phi_2213_: f32;
    var phi_2225_: f32;
    var phi_2230_: f32;
    var phi_2235_: f32;
    var phi_2240_: f32;
    var phi_2245_: lt_bvh_triangle_Intersection;
    var phi_2246_: bool;
    var phi_2247_: lt_bvh_triangle_Intersection;
    var phi_2248_: bool;
    var phi_2252_: lt_bvh_triangle_Intersection;
    var phi_2253_: bool;
    var phi_2254_: lt_bvh_triangle_Intersection;
    var phi_2255_: bool;
    var phi_2256_: bool;
    var phi_2260_: bool;
    var phi_2264_: lt_bvh_triangle_Intersection;
    var phi_2478_: f32;
    var phi_2481_: bool;
    var phi_2482_: bool;
    var phi_2486_: bool;
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
    var phi_2503_: bool;
    var phi_2504_: bool;
    var phi_2505_: bool;
    var phi_2513_: bool;
    var phi_2514_: bool;
    var phi_2515_: bool;
    var phi_2516_: bool;
    var phi_2517_: bool;
    var local_7: bool;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2523_: bool;
    var phi_2524_: bool;
    var phi_2525_: bool;
    var local_8: u32;
    var phi_2533_: bool;
    var phi_2534_: bool;
    var phi_2535_: bool;
    var phi_2536_: bool;
    var local_9: bool;
    var phi_2540_: bool;
    var phi_2544_: bool;
    var phi_2548_: bool;
    var phi_2549_: bool;
    var phi_2565_: bool;
    var phi_2566_: bool;
    var phi_2567_: bool;
    var phi_2568_: bool;
    var phi_2572_: bool;
    var phi_2585_: bool;
    var phi_2586_: bool;
    var phi_2587_: bool;
    var phi_2588_: bool;
    var phi_2592_: bool;
    var phi_2605_: bool;
    var phi_2606_: bool;
    var phi_2607_: bool;
    var phi_2611_: bool;
    var phi_2612_: bool;
    var phi_2613_: bool;
    var phi_2614_: bool;
    var phi_2615_: bool;
    var phi_2619_: bool;
    var phi_2689_: f32;
    var phi_2696_: f32;
    var phi_2703_: f32;
    var phi_2710_: f32;
    var phi_2717_: f32;
    var phi_2724_: f32;
    var phi_2741_: f32;
    var phi_2746_: f32;
    var phi_2751_: f32;
    var phi_2756_: f32;
    var phi_2761_: f32;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2796_: u32;
    var phi_2797_: u32;
    var phi_2808_: vec3<f32>;
    var phi_2809_: vec3<f32>;
    var phi_2822_: u32;
    var phi_2827_: u32;
    var phi_2832_: u32;
    var phi_2946_: bool;
    var phi_2947_: bool;
    var phi_2978_: u32;
    var phi_2980_: u32;
    var phi_2983_: bool;
    var phi_3063_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3090_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3117_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3123_: u32;
    var phi_3126_: u32;
    var phi_3140_: u32;
    var phi_3150_: u32;
    var phi_3160_: u32;
    var phi_3178_: u32;
    var phi_3188_: u32;
    var phi_3198_: u32;
    var phi_3234_: u32;
    var phi_3247_: u32;
    var phi_3252_: u32;
    var phi_3253_: u32;
    var phi_3254_: u32;
    var phi_3124_: u32;
    var phi_3127_: u32;
    var local_10: u32;
    var local_11: u32;
    var local_12: u32;
    var phi_3312_: u32;
    var phi_3315_: bool;
    var phi_3359_: vec3<f32>;
    var phi_3360_: vec3<f32>;
    var phi_3389_: vec3<f32>;
    var phi_3390_: vec3<f32>;
    var phi_3419_: vec3<f32>;
    var phi_3420_: vec3<f32>;
    var phi_3438_: bool;
    var phi_3439_: bool;
    var phi_3443_: f32;
    var phi_3444_: f32;
    var phi_3445_: f32;
    var phi_3446_: f32;
    var phi_3454_: f32;
    var phi_3464_: bool;
    var phi_3465_: bool;
    var phi_3469_: f32;
    var phi_3470_: f32;
    var phi_3471_: f32;
    var phi_3472_: f32;
    var phi_3480_: f32;
    var phi_3490_: bool;
    var phi_3491_: bool;
    var phi_3495_: f32;
    var phi_3496_: f32;
    var phi_3497_: f32;
    var phi_3498_: f32;
    var phi_3506_: f32;
    var phi_3521_: f32;
    var phi_3522_: bool;
    var phi_3523_: f32;
    var phi_3524_: bool;
    var phi_3525_: f32;
    var phi_3526_: bool;
    var phi_3544_: f32;
    var phi_3545_: bool;
    var phi_3546_: bool;
    var phi_3547_: f32;
    var phi_3548_: bool;
    var phi_3549_: bool;
    var phi_3553_: bool;
    var phi_3554_: f32;
    var phi_3555_: bool;
    var phi_3583_: vec3<f32>;
    var phi_3584_: vec3<f32>;
    var phi_3609_: vec3<f32>;
    var phi_3610_: vec3<f32>;
    var phi_3635_: vec3<f32>;
    var phi_3636_: vec3<f32>;
    var phi_3692_: f32;
    var phi_3701_: f32;
    var phi_3710_: f32;
    var phi_3719_: f32;
    var phi_3726_: f32;
    var phi_3733_: f32;
    var phi_3746_: f32;
    var phi_3755_: f32;
    var phi_3764_: f32;
    var phi_3773_: f32;
    var phi_3780_: f32;
    var phi_3787_: f32;
    var phi_3804_: f32;
    var phi_3809_: f32;
    var phi_3814_: f32;
    var phi_3822_: f32;
    var phi_3827_: f32;
    var phi_3832_: f32;
    var phi_3844_: f32;
    var phi_3849_: f32;
    var phi_3854_: f32;
    var phi_3859_: f32;
    var phi_3864_: lt_bvh_triangle_Intersection;
    var phi_3865_: bool;
    var phi_3866_: lt_bvh_triangle_Intersection;
    var phi_3867_: bool;
    var phi_3871_: lt_bvh_triangle_Intersection;
    var phi_3872_: bool;
    var phi_3873_: lt_bvh_triangle_Intersection;
    var phi_3874_: bool;
    var phi_3875_: bool;
    var phi_3879_: bool;
    var phi_3883_: lt_bvh_triangle_Intersection;
    var phi_4097_: f32;
    var phi_4100_: bool;
    var phi_4101_: bool;
    var phi_4102_: bool;
    var phi_4106_: bool;
    var phi_4107_: bool;
    var phi_4108_: bool;
    var phi_4109_: bool;
    var phi_4110_: bool;
    var phi_4111_: bool;
    var phi_4112_: bool;
    var phi_4113_: bool;
    var phi_4114_: bool;
    var phi_4115_: bool;
    var phi_3313_: u32;
    var phi_3316_: bool;
    var phi_4119_: bool;
    var phi_4120_: bool;
    var local_13: bool;
    var phi_4162_: bool;
    var phi_4163_: bool;
    var phi_4194_: u32;
    var phi_4195_: u32;
    var phi_2981_: u32;
    var phi_2984_: bool;
    var phi_4196_: bool;
    var phi_4197_: bool;
    var phi_4198_: bool;
    var local_14: bool;
    var phi_4202_: bool;
    var phi_4206_: bool;
    var phi_4207_: bool;
    var phi_4208_: bool;
    var phi_4209_: bool;
    var phi_4213_: bool;
    var phi_4214_: bool;
    var phi_4215_: bool;
    var phi_4219_: f32;
    var phi_4260_: u32;
    var phi_4279_: u32;
    var phi_4287_: u32;
    var phi_4295_: u32;
    var phi_4300_: u32;
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
        let _e129 = space.member;
        if (_e128 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e135 = samples.member[(0u + _e128)].position;
        let _e137 = samples.member[(0u + _e128)].normal;
        let _e139 = samples.member[(0u + _e128)].magnitude;
        let _e141 = ((8f / 8388608f) * _e139);
        let _e143 = (_e137.x * _e141);
        let _e145 = (_e137.y * _e141);
        let _e147 = (_e137.z * _e141);
        let _e149 = (_e135.x + _e143);
        let _e151 = (_e135.y + _e145);
        let _e153 = (_e135.z + _e147);
        let _e157 = p.member.light.place;
        if (_e157.w == 0f) {
            phi_725_ = 300000000000000000000000000000000000000f;
        } else {
            phi_725_ = 1f;
        }
        let _e161 = phi_725_;
        let _e169 = (_e157.x - (_e149 * _e157.w));
        let _e170 = (_e157.y - (_e151 * _e157.w));
        let _e171 = (_e157.z - (_e153 * _e157.w));
        let _e172 = vec3<f32>(_e169, _e170, _e171);
        let _e173 = abs(_e169);
        let _e174 = abs(_e170);
        let _e175 = abs(_e171);
        if (abs(_e149) < 1000000000000000f) {
            if (abs(_e151) < 1000000000000000f) {
                phi_758_ = (abs(_e153) < 1000000000000000f);
                phi_759_ = false;
            } else {
                phi_758_ = bool();
                phi_759_ = true;
            }
            let _e183 = phi_758_;
            let _e185 = phi_759_;
            phi_760_ = _e183;
            phi_761_ = _e185;
        } else {
            phi_760_ = bool();
            phi_761_ = true;
        }
        let _e187 = phi_760_;
        let _e189 = phi_761_;
        if _e189 {
            phi_765_ = false;
        } else {
            phi_765_ = _e187;
        }
        let _e191 = phi_765_;
        if _e191 {
            if (_e173 < 1000000000000000f) {
                if (_e174 < 1000000000000000f) {
                    phi_778_ = (_e175 < 1000000000000000f);
                    phi_779_ = false;
                } else {
                    phi_778_ = bool();
                    phi_779_ = true;
                }
                let _e196 = phi_778_;
                let _e198 = phi_779_;
                phi_780_ = _e196;
                phi_781_ = _e198;
            } else {
                phi_780_ = bool();
                phi_781_ = true;
            }
            let _e200 = phi_780_;
            let _e202 = phi_781_;
            if _e202 {
                phi_785_ = false;
            } else {
                phi_785_ = _e200;
            }
            let _e204 = phi_785_;
            if _e204 {
                if (_e173 > 0f) {
                    phi_799_ = bool();
                    phi_800_ = true;
                } else {
                    let _e206 = (_e174 > 0f);
                    if _e206 {
                        phi_798_ = bool();
                    } else {
                        phi_798_ = (_e175 > 0f);
                    }
                    let _e209 = phi_798_;
                    phi_799_ = _e209;
                    phi_800_ = _e206;
                }
                let _e211 = phi_799_;
                let _e213 = phi_800_;
                if _e213 {
                    phi_804_ = true;
                } else {
                    phi_804_ = _e211;
                }
                let _e215 = phi_804_;
                phi_805_ = _e215;
                phi_806_ = false;
            } else {
                phi_805_ = bool();
                phi_806_ = true;
            }
            let _e217 = phi_805_;
            let _e219 = phi_806_;
            phi_807_ = _e217;
            phi_808_ = _e219;
        } else {
            phi_807_ = bool();
            phi_808_ = true;
        }
        let _e221 = phi_807_;
        let _e223 = phi_808_;
        if _e223 {
            phi_812_ = false;
        } else {
            phi_812_ = _e221;
        }
        let _e225 = phi_812_;
        if _e225 {
            if (_e129.low.x <= _e149) {
                if (_e149 <= _e129.high.x) {
                    if (_e129.low.y <= _e151) {
                        phi_835_ = (_e151 <= _e129.high.y);
                        phi_836_ = false;
                    } else {
                        phi_835_ = bool();
                        phi_836_ = true;
                    }
                    let _e243 = phi_835_;
                    let _e245 = phi_836_;
                    phi_837_ = _e243;
                    phi_838_ = _e245;
                } else {
                    phi_837_ = bool();
                    phi_838_ = true;
                }
                let _e247 = phi_837_;
                let _e249 = phi_838_;
                phi_839_ = _e247;
                phi_840_ = _e249;
            } else {
                phi_839_ = bool();
                phi_840_ = true;
            }
            let _e251 = phi_839_;
            let _e253 = phi_840_;
            if _e253 {
                phi_844_ = false;
            } else {
                phi_844_ = _e251;
            }
            let _e255 = phi_844_;
            if (abs(_e169) > 0.000000000000000000000000000001f) {
                phi_858_ = bool();
                phi_859_ = true;
            } else {
                let _e260 = (abs(_e170) > 0.000000000000000000000000000001f);
                if _e260 {
                    phi_857_ = bool();
                } else {
                    phi_857_ = (abs(_e171) > 0.000000000000000000000000000001f);
                }
                let _e263 = phi_857_;
                phi_858_ = _e263;
                phi_859_ = _e260;
            }
            let _e265 = phi_858_;
            let _e267 = phi_859_;
            if _e267 {
                phi_863_ = true;
            } else {
                phi_863_ = _e265;
            }
            let _e269 = phi_863_;
            if _e255 {
                if (_e129.low.z <= _e153) {
                    if (_e153 <= _e129.high.z) {
                        if (_e129.is_parallel == 0u) {
                            phi_880_ = _e269;
                        } else {
                            phi_880_ = true;
                        }
                        let _e275 = phi_880_;
                        phi_881_ = _e275;
                        phi_882_ = false;
                    } else {
                        phi_881_ = bool();
                        phi_882_ = true;
                    }
                    let _e277 = phi_881_;
                    let _e279 = phi_882_;
                    phi_883_ = _e277;
                    phi_884_ = _e279;
                } else {
                    phi_883_ = bool();
                    phi_884_ = true;
                }
                let _e281 = phi_883_;
                let _e283 = phi_884_;
                phi_885_ = _e281;
                phi_886_ = _e283;
            } else {
                phi_885_ = bool();
                phi_886_ = true;
            }
            let _e285 = phi_885_;
            let _e287 = phi_886_;
            if _e287 {
                phi_890_ = false;
            } else {
                phi_890_ = _e285;
            }
            let _e289 = phi_890_;
            if _e289 {
                if (_e129.is_parallel == 0u) {
                    let _e292 = abs(_e169);
                    let _e293 = abs(_e170);
                    let _e294 = abs(_e171);
                    if (_e292 >= _e293) {
                        if (_e292 >= _e294) {
                            phi_910_ = false;
                        } else {
                            phi_910_ = true;
                        }
                        let _e298 = phi_910_;
                        phi_911_ = _e298;
                    } else {
                        phi_911_ = true;
                    }
                    let _e300 = phi_911_;
                    if _e300 {
                        if (_e293 >= _e294) {
                            phi_919_ = 1u;
                            phi_920_ = _e170;
                        } else {
                            phi_919_ = 2u;
                            phi_920_ = _e171;
                        }
                        let _e303 = phi_919_;
                        let _e305 = phi_920_;
                        phi_921_ = _e303;
                        phi_922_ = _e305;
                    } else {
                        phi_921_ = 0u;
                        phi_922_ = _e169;
                    }
                    let _e307 = phi_921_;
                    let _e309 = phi_922_;
                    if (_e309 < 0f) {
                        phi_927_ = -1f;
                    } else {
                        phi_927_ = 1f;
                    }
                    let _e312 = phi_927_;
                    let _e313 = (_e312 < 0f);
                    if (_e307 == 0u) {
                        if _e313 {
                            phi_938_ = _e129.roots.y;
                        } else {
                            phi_938_ = _e129.roots.x;
                        }
                        let _e320 = phi_938_;
                        phi_956_ = _e320;
                    } else {
                        if (_e307 == 1u) {
                            if _e313 {
                                phi_948_ = _e129.roots.w;
                            } else {
                                phi_948_ = _e129.roots.z;
                            }
                            let _e327 = phi_948_;
                            phi_955_ = _e327;
                        } else {
                            if _e313 {
                                phi_954_ = _e129.roots_z.y;
                            } else {
                                phi_954_ = _e129.roots_z.x;
                            }
                            let _e333 = phi_954_;
                            phi_955_ = _e333;
                        }
                        let _e335 = phi_955_;
                        phi_956_ = _e335;
                    }
                    let _e337 = phi_956_;
                    if (_e307 == 0u) {
                        phi_968_ = vec3<f32>(_e170, _e171, _e169);
                    } else {
                        if (_e307 == 1u) {
                            phi_967_ = vec3<f32>(_e171, _e169, _e170);
                        } else {
                            phi_967_ = _e172;
                        }
                        let _e343 = phi_967_;
                        phi_968_ = _e343;
                    }
                    let _e345 = phi_968_;
                    phi_1013_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e345.x / _e345.z), (_e345.y / _e345.z), (_e312 / _e345.z)), _e337);
                } else {
                    if (_e129.axis == 0u) {
                        phi_991_ = vec3<f32>(_e151, _e153, _e149);
                    } else {
                        if (_e129.axis == 1u) {
                            phi_990_ = vec3<f32>(_e153, _e149, _e151);
                        } else {
                            phi_990_ = (_e135 + vec3<f32>(_e143, _e145, _e147));
                        }
                        let _e362 = phi_990_;
                        phi_991_ = _e362;
                    }
                    let _e364 = phi_991_;
                    let _e379 = (_e364.z - _e129.middle.z);
                    phi_1013_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e364.x - _e129.middle.x) - (_e129.shear.x * _e379)), ((_e364.y - _e129.middle.y) - (_e129.shear.y * _e379)), (_e129.sign * _e379)), _e129.roots.x);
                }
                let _e390 = phi_1013_;
                if (_e390.unnamed_1 == 4294967295u) {
                    phi_2549_ = false;
                } else {
                    if (0u < _e90) {
                    } else {
                        return;
                    }
                    let _e407 = nodes.member[0u].frame[0u];
                    let _e411 = nodes.member[0u].frame[1u];
                    let _e415 = nodes.member[0u].frame[2u];
                    let _e419 = nodes.member[0u].frame[0u];
                    let _e423 = nodes.member[0u].frame[1u];
                    let _e427 = nodes.member[0u].frame[2u];
                    let _e431 = nodes.member[0u].frame[3u];
                    let _e465 = core_intrinsics_maximum_number_nsz_f32_(abs(_e169), abs(_e170));
                    let _e466 = core_intrinsics_maximum_number_nsz_f32_(_e465, abs(_e171));
                    let _e467 = (_e466 * 0.0000000000009094947f);
                    if (abs(_e169) < _e467) {
                        phi_1088_ = _e467;
                    } else {
                        phi_1088_ = abs(_e169);
                    }
                    let _e472 = phi_1088_;
                    if (_e169 < 0f) {
                        phi_1095_ = (-1f / _e472);
                    } else {
                        phi_1095_ = (1f / _e472);
                    }
                    let _e477 = phi_1095_;
                    if (abs(_e170) < _e467) {
                        phi_1102_ = _e467;
                    } else {
                        phi_1102_ = abs(_e170);
                    }
                    let _e482 = phi_1102_;
                    if (_e170 < 0f) {
                        phi_1109_ = (-1f / _e482);
                    } else {
                        phi_1109_ = (1f / _e482);
                    }
                    let _e487 = phi_1109_;
                    if (abs(_e171) < _e467) {
                        phi_1116_ = _e467;
                    } else {
                        phi_1116_ = abs(_e171);
                    }
                    let _e492 = phi_1116_;
                    if (_e171 < 0f) {
                        phi_1123_ = (-1f / _e492);
                    } else {
                        phi_1123_ = (1f / _e492);
                    }
                    let _e497 = phi_1123_;
                    let _e501 = abs((bitcast<f32>(_e407) - _e149));
                    let _e502 = abs((bitcast<f32>(_e411) - _e151));
                    let _e503 = abs((bitcast<f32>(_e415) - _e153));
                    let _e507 = abs(((bitcast<f32>(_e419) + (bitcast<f32>((((_e431 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                    let _e508 = abs(((bitcast<f32>(_e423) + (bitcast<f32>((((_e431 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151));
                    let _e509 = abs(((bitcast<f32>(_e427) + (bitcast<f32>((((_e431 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153));
                    if (_e501 > _e507) {
                        phi_1140_ = _e501;
                    } else {
                        phi_1140_ = _e507;
                    }
                    let _e512 = phi_1140_;
                    if (_e502 > _e508) {
                        phi_1145_ = _e502;
                    } else {
                        phi_1145_ = _e508;
                    }
                    let _e515 = phi_1145_;
                    if (_e503 > _e509) {
                        phi_1150_ = _e503;
                    } else {
                        phi_1150_ = _e509;
                    }
                    let _e518 = phi_1150_;
                    if (_e512 > _e515) {
                        phi_1155_ = _e512;
                    } else {
                        phi_1155_ = _e515;
                    }
                    let _e521 = phi_1155_;
                    if (_e521 > _e518) {
                        phi_1160_ = _e521;
                    } else {
                        phi_1160_ = _e518;
                    }
                    let _e524 = phi_1160_;
                    let _e531 = (_e524 * 0.0000009536743f);
                    let _e532 = (abs(_e477) * _e531);
                    let _e533 = (abs(_e487) * _e531);
                    let _e534 = (abs(_e497) * _e531);
                    let _e535 = abs(_e169);
                    let _e536 = abs(_e170);
                    let _e537 = abs(_e171);
                    if (_e535 >= _e536) {
                        if (_e535 >= _e537) {
                            phi_1182_ = false;
                        } else {
                            phi_1182_ = true;
                        }
                        let _e541 = phi_1182_;
                        phi_1183_ = _e541;
                    } else {
                        phi_1183_ = true;
                    }
                    let _e543 = phi_1183_;
                    if _e543 {
                        if (_e536 >= _e537) {
                            phi_1191_ = 1u;
                        } else {
                            phi_1191_ = 2u;
                        }
                        let _e546 = phi_1191_;
                        phi_1192_ = _e546;
                    } else {
                        phi_1192_ = 0u;
                    }
                    let _e548 = phi_1192_;
                    if (_e548 == 0u) {
                        phi_1204_ = vec3<f32>(_e170, _e171, _e169);
                    } else {
                        if (_e548 == 1u) {
                            phi_1203_ = vec3<f32>(_e171, _e169, _e170);
                        } else {
                            phi_1203_ = _e172;
                        }
                        let _e554 = phi_1203_;
                        phi_1204_ = _e554;
                    }
                    let _e556 = phi_1204_;
                    let _e559 = (_e556.x / _e556.z);
                    let _e562 = (_e556.y / _e556.z);
                    local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_1216_ = ((_e390.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_1219_ = 0u;
                    loop {
                        let _e569 = phi_1216_;
                        let _e571 = phi_1219_;
                        phi_1224_ = _e569;
                        phi_1226_ = 0u;
                        phi_1228_ = 0u;
                        phi_1230_ = _e571;
                        loop {
                            let _e573 = phi_1224_;
                            let _e575 = phi_1226_;
                            let _e577 = phi_1228_;
                            let _e579 = phi_1230_;
                            let _e586 = (((_e573 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e573), 32u, (_e573 == 0u))) * 5u);
                            if (_e586 < _e105) {
                            } else {
                                return;
                            }
                            let _e590 = rows.member[(0u + _e586)];
                            let _e591 = (_e586 + 1u);
                            if (_e591 < _e105) {
                            } else {
                                return;
                            }
                            let _e595 = rows.member[(0u + _e591)];
                            let _e596 = (_e586 + 2u);
                            if (_e596 < _e105) {
                            } else {
                                return;
                            }
                            let _e600 = rows.member[(0u + _e596)];
                            let _e601 = (_e586 + 3u);
                            if (_e601 < _e105) {
                            } else {
                                return;
                            }
                            let _e605 = rows.member[(0u + _e601)];
                            let _e606 = (_e586 + 4u);
                            if (_e606 < _e105) {
                            } else {
                                return;
                            }
                            let _e610 = rows.member[(0u + _e606)];
                            let _e611 = lt_bvh_Node(_e590, _e595, _e600, _e605, _e610);
                            let _e613 = (_e573 & (_e573 - 1u));
                            let _e625 = (_e390.unnamed.positive_exponent - bitcast<f32>(_e611.frame.x));
                            let _e628 = bitcast<f32>((((_e611.z.z >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e625 > 0f) {
                                if (_e625 < (255f * _e628)) {
                                    phi_1302_ = (_e625 / _e628);
                                } else {
                                    phi_1302_ = 255f;
                                }
                                let _e634 = phi_1302_;
                                phi_1303_ = _e634;
                            } else {
                                phi_1303_ = 0f;
                            }
                            let _e636 = phi_1303_;
                            let _e643 = select(select(u32(_e636), 0u, (_e636 < bitcast<f32>(0u))), 4294967295u, (_e636 > bitcast<f32>(1333788671u)));
                            if (f32(_e643) < _e636) {
                                phi_1317_ = (_e643 + 1u);
                            } else {
                                phi_1317_ = _e643;
                            }
                            let _e648 = phi_1317_;
                            let _e649 = (_e643 * 16843009u);
                            let _e650 = (_e648 * 16843009u);
                            let _e660 = (_e390.unnamed.negative_exponent - bitcast<f32>(_e611.frame.y));
                            let _e663 = bitcast<f32>((((_e611.z.z >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e660 > 0f) {
                                if (_e660 < (255f * _e663)) {
                                    phi_1340_ = (_e660 / _e663);
                                } else {
                                    phi_1340_ = 255f;
                                }
                                let _e669 = phi_1340_;
                                phi_1341_ = _e669;
                            } else {
                                phi_1341_ = 0f;
                            }
                            let _e671 = phi_1341_;
                            let _e678 = select(select(u32(_e671), 0u, (_e671 < bitcast<f32>(0u))), 4294967295u, (_e671 > bitcast<f32>(1333788671u)));
                            if (f32(_e678) < _e671) {
                                phi_1355_ = (_e678 + 1u);
                            } else {
                                phi_1355_ = _e678;
                            }
                            let _e683 = phi_1355_;
                            let _e684 = (_e678 * 16843009u);
                            let _e685 = (_e683 * 16843009u);
                            let _e694 = (((_e129.diagonal.x * _e390.unnamed.positive_exponent) + (_e129.diagonal.y * _e390.unnamed.negative_exponent)) - bitcast<f32>(_e611.frame.z));
                            let _e697 = bitcast<f32>((((_e611.z.z >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e694 > 0f) {
                                if (_e694 < (255f * _e697)) {
                                    phi_1377_ = (_e694 / _e697);
                                } else {
                                    phi_1377_ = 255f;
                                }
                                let _e703 = phi_1377_;
                                phi_1378_ = _e703;
                            } else {
                                phi_1378_ = 0f;
                            }
                            let _e705 = phi_1378_;
                            let _e712 = select(select(u32(_e705), 0u, (_e705 < bitcast<f32>(0u))), 4294967295u, (_e705 > bitcast<f32>(1333788671u)));
                            if (f32(_e712) < _e705) {
                                phi_1392_ = (_e712 + 1u);
                            } else {
                                phi_1392_ = _e712;
                            }
                            let _e717 = phi_1392_;
                            let _e718 = (_e712 * 16843009u);
                            let _e719 = (_e717 * 16843009u);
                            let _e729 = (_e390.unnamed.min_variance - bitcast<f32>(_e611.frame.w));
                            let _e732 = bitcast<f32>((((_e611.z.z >> bitcast<u32>(((3u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e729 > 0f) {
                                if (_e729 < (255f * _e732)) {
                                    phi_1415_ = (_e729 / _e732);
                                } else {
                                    phi_1415_ = 255f;
                                }
                                let _e738 = phi_1415_;
                                phi_1416_ = _e738;
                            } else {
                                phi_1416_ = 0f;
                            }
                            let _e740 = phi_1416_;
                            let _e747 = select(select(u32(_e740), 0u, (_e740 < bitcast<f32>(0u))), 4294967295u, (_e740 > bitcast<f32>(1333788671u)));
                            if (f32(_e747) < _e740) {
                                phi_1430_ = (_e747 + 1u);
                            } else {
                                phi_1430_ = _e747;
                            }
                            let _e752 = phi_1430_;
                            let _e753 = (_e752 * 16843009u);
                            let _e934 = (((((((((((_e649 & ~(_e611.links.x)) | (~((_e611.links.x ^ _e649)) & ((_e649 | 2155905152u) - (_e611.links.x & 2139062143u)))) & ((_e611.links.z & ~(_e650)) | (~((_e650 ^ _e611.links.z)) & ((_e611.links.z | 2155905152u) - (_e650 & 2139062143u))))) & (((_e684 & ~(_e611.x.x)) | (~((_e611.x.x ^ _e684)) & ((_e684 | 2155905152u) - (_e611.x.x & 2139062143u)))) & ((_e611.x.z & ~(_e685)) | (~((_e685 ^ _e611.x.z)) & ((_e611.x.z | 2155905152u) - (_e685 & 2139062143u)))))) & (((_e718 & ~(_e611.y.x)) | (~((_e611.y.x ^ _e718)) & ((_e718 | 2155905152u) - (_e611.y.x & 2139062143u)))) & ((_e611.y.z & ~(_e719)) | (~((_e719 ^ _e611.y.z)) & ((_e611.y.z | 2155905152u) - (_e719 & 2139062143u)))))) & ((_e611.z.x & ~(_e753)) | (~((_e753 ^ _e611.z.x)) & ((_e611.z.x | 2155905152u) - (_e753 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e649 & ~(_e611.links.y)) | (~((_e611.links.y ^ _e649)) & ((_e649 | 2155905152u) - (_e611.links.y & 2139062143u)))) & ((_e611.links.w & ~(_e650)) | (~((_e650 ^ _e611.links.w)) & ((_e611.links.w | 2155905152u) - (_e650 & 2139062143u))))) & (((_e684 & ~(_e611.x.y)) | (~((_e611.x.y ^ _e684)) & ((_e684 | 2155905152u) - (_e611.x.y & 2139062143u)))) & ((_e611.x.w & ~(_e685)) | (~((_e685 ^ _e611.x.w)) & ((_e611.x.w | 2155905152u) - (_e685 & 2139062143u)))))) & (((_e718 & ~(_e611.y.y)) | (~((_e611.y.y ^ _e718)) & ((_e718 | 2155905152u) - (_e611.y.y & 2139062143u)))) & ((_e611.y.w & ~(_e719)) | (~((_e719 ^ _e611.y.w)) & ((_e611.y.w | 2155905152u) - (_e719 & 2139062143u)))))) & ((_e611.z.y & ~(_e753)) | (~((_e753 ^ _e611.z.y)) & ((_e611.z.y | 2155905152u) - (_e753 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e611.z.w & 2147483648u) != 0u) {
                                phi_1630_ = _e613;
                                phi_1227_ = (_e611.z.w & 2147483647u);
                                phi_1229_ = _e934;
                                phi_1631_ = _e579;
                            } else {
                                if (_e934 == 0u) {
                                    phi_1628_ = _e613;
                                    phi_1629_ = _e579;
                                } else {
                                    if ((_e613 & 255u) == 0u) {
                                        phi_1623_ = _e579;
                                    } else {
                                        if (_e579 < 32u) {
                                            if (_e579 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_3[(0u + _e579)] = _e613;
                                            phi_1622_ = (_e579 + 1u);
                                        } else {
                                            phi_1622_ = _e579;
                                        }
                                        let _e951 = phi_1622_;
                                        phi_1623_ = _e951;
                                    }
                                    let _e953 = phi_1623_;
                                    phi_1628_ = (((_e611.z.w & 2147483647u) << bitcast<u32>(8i)) | _e934);
                                    phi_1629_ = _e953;
                                }
                                let _e961 = phi_1628_;
                                let _e963 = phi_1629_;
                                phi_1630_ = _e961;
                                phi_1227_ = _e575;
                                phi_1229_ = _e577;
                                phi_1631_ = _e963;
                            }
                            let _e965 = phi_1630_;
                            let _e967 = phi_1227_;
                            let _e969 = phi_1229_;
                            let _e971 = phi_1631_;
                            local_5 = _e969;
                            local_17 = _e969;
                            local_6 = _e967;
                            if ((_e965 & 255u) == 0u) {
                                if (_e971 > 0u) {
                                    let _e975 = (_e971 - 1u);
                                    if (_e975 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e979 = local_3[(0u + _e975)];
                                    phi_1649_ = _e979;
                                    phi_1650_ = _e975;
                                } else {
                                    phi_1649_ = 0u;
                                    phi_1650_ = _e971;
                                }
                                let _e981 = phi_1649_;
                                let _e983 = phi_1650_;
                                phi_1217_ = _e981;
                                phi_1220_ = _e983;
                            } else {
                                phi_1217_ = _e965;
                                phi_1220_ = _e971;
                            }
                            let _e985 = phi_1217_;
                            let _e987 = phi_1220_;
                            local_15 = _e985;
                            local_16 = _e987;
                            local_8 = _e985;
                            if (_e969 == 0u) {
                                let _e989 = (_e985 == 0u);
                                if _e989 {
                                    phi_1659_ = false;
                                } else {
                                    phi_1659_ = true;
                                }
                                let _e991 = phi_1659_;
                                phi_1660_ = _e991;
                                phi_1661_ = _e989;
                            } else {
                                phi_1660_ = false;
                                phi_1661_ = false;
                            }
                            let _e993 = phi_1660_;
                            let _e995 = phi_1661_;
                            local_4 = _e995;
                            continue;
                            continuing {
                                phi_1224_ = _e985;
                                phi_1226_ = _e967;
                                phi_1228_ = _e969;
                                phi_1230_ = _e987;
                                break if !(_e993);
                            }
                        }
                        let _e998 = local_4;
                        if _e998 {
                        }
                        let _e1000 = local_5;
                        if (_e1000 == 0u) {
                            phi_2523_ = true;
                            phi_2524_ = false;
                            phi_2525_ = false;
                        } else {
                            let _e3560 = local_17;
                            phi_1670_ = _e3560;
                            loop {
                                let _e1003 = phi_1670_;
                                let _e1006 = select(firstTrailingBit(_e1003), 32u, (_e1003 == 0u));
                                let _e1010 = local_6;
                                let _e1011 = (_e1010 + (_e1006 >> bitcast<u32>(2i)));
                                if (_e1011 < _e105) {
                                } else {
                                    return;
                                }
                                let _e1016 = rows.member[(0u + _e1011)][0u];
                                let _e1020 = rows.member[(0u + _e1011)][1u];
                                let _e1024 = rows.member[(0u + _e1011)][2u];
                                let _e1028 = rows.member[(0u + _e1011)][3u];
                                if ((_e1006 & 2u) == 0u) {
                                    phi_1705_ = _e1020;
                                    phi_1706_ = _e1016;
                                } else {
                                    phi_1705_ = _e1028;
                                    phi_1706_ = _e1024;
                                }
                                let _e1032 = phi_1705_;
                                let _e1034 = phi_1706_;
                                if ((_e1006 & 1u) == 0u) {
                                    phi_1712_ = _e1034;
                                } else {
                                    phi_1712_ = _e1032;
                                }
                                let _e1038 = phi_1712_;
                                let _e1040 = (_e1003 & (_e1003 - 1u));
                                if (_e1038 < _e93) {
                                } else {
                                    return;
                                }
                                let _e1045 = triangles.member[(0u + _e1038)].v0_;
                                let _e1047 = (_e1045.x - _e149);
                                let _e1049 = (_e1045.y - _e151);
                                let _e1051 = (_e1045.z - _e153);
                                if (_e548 == 0u) {
                                    phi_1741_ = vec3<f32>(_e1049, _e1051, _e1047);
                                } else {
                                    if (_e548 == 1u) {
                                        phi_1740_ = vec3<f32>(_e1051, _e1047, _e1049);
                                    } else {
                                        phi_1740_ = (_e1045 - vec3<f32>(_e149, _e151, _e153));
                                    }
                                    let _e1059 = phi_1740_;
                                    phi_1741_ = _e1059;
                                }
                                let _e1061 = phi_1741_;
                                let _e1065 = (_e1061.x - (_e559 * _e1061.z));
                                let _e1069 = (_e1061.y - (_e562 * _e1061.z));
                                let _e1071 = triangles.member[(0u + _e1038)].v1_;
                                let _e1073 = (_e1071.x - _e149);
                                let _e1075 = (_e1071.y - _e151);
                                let _e1077 = (_e1071.z - _e153);
                                if (_e548 == 0u) {
                                    phi_1771_ = vec3<f32>(_e1075, _e1077, _e1073);
                                } else {
                                    if (_e548 == 1u) {
                                        phi_1770_ = vec3<f32>(_e1077, _e1073, _e1075);
                                    } else {
                                        phi_1770_ = (_e1071 - vec3<f32>(_e149, _e151, _e153));
                                    }
                                    let _e1085 = phi_1770_;
                                    phi_1771_ = _e1085;
                                }
                                let _e1087 = phi_1771_;
                                let _e1091 = (_e1087.x - (_e559 * _e1087.z));
                                let _e1095 = (_e1087.y - (_e562 * _e1087.z));
                                let _e1097 = triangles.member[(0u + _e1038)].v2_;
                                let _e1099 = (_e1097.x - _e149);
                                let _e1101 = (_e1097.y - _e151);
                                let _e1103 = (_e1097.z - _e153);
                                if (_e548 == 0u) {
                                    phi_1801_ = vec3<f32>(_e1101, _e1103, _e1099);
                                } else {
                                    if (_e548 == 1u) {
                                        phi_1800_ = vec3<f32>(_e1103, _e1099, _e1101);
                                    } else {
                                        phi_1800_ = (_e1097 - vec3<f32>(_e149, _e151, _e153));
                                    }
                                    let _e1111 = phi_1800_;
                                    phi_1801_ = _e1111;
                                }
                                let _e1113 = phi_1801_;
                                let _e1117 = (_e1113.x - (_e559 * _e1113.z));
                                let _e1121 = (_e1113.y - (_e562 * _e1113.z));
                                if (_e1091 < _e1117) {
                                    phi_1820_ = true;
                                } else {
                                    if (_e1091 == _e1117) {
                                        phi_1819_ = (_e1095 < _e1121);
                                    } else {
                                        phi_1819_ = false;
                                    }
                                    let _e1126 = phi_1819_;
                                    phi_1820_ = _e1126;
                                }
                                let _e1128 = phi_1820_;
                                if _e1128 {
                                    phi_1824_ = _e1121;
                                    phi_1825_ = _e1117;
                                    phi_1826_ = _e1095;
                                    phi_1827_ = _e1091;
                                } else {
                                    phi_1824_ = _e1095;
                                    phi_1825_ = _e1091;
                                    phi_1826_ = _e1121;
                                    phi_1827_ = _e1117;
                                }
                                let _e1130 = phi_1824_;
                                let _e1132 = phi_1825_;
                                let _e1134 = phi_1826_;
                                let _e1136 = phi_1827_;
                                let _e1139 = ((_e1136 * _e1130) - (_e1134 * _e1132));
                                if _e1128 {
                                    phi_1835_ = -(_e1139);
                                } else {
                                    phi_1835_ = _e1139;
                                }
                                let _e1142 = phi_1835_;
                                if (_e1117 < _e1065) {
                                    phi_1846_ = true;
                                } else {
                                    if (_e1117 == _e1065) {
                                        phi_1845_ = (_e1121 < _e1069);
                                    } else {
                                        phi_1845_ = false;
                                    }
                                    let _e1147 = phi_1845_;
                                    phi_1846_ = _e1147;
                                }
                                let _e1149 = phi_1846_;
                                if _e1149 {
                                    phi_1850_ = _e1069;
                                    phi_1851_ = _e1065;
                                    phi_1852_ = _e1121;
                                    phi_1853_ = _e1117;
                                } else {
                                    phi_1850_ = _e1121;
                                    phi_1851_ = _e1117;
                                    phi_1852_ = _e1069;
                                    phi_1853_ = _e1065;
                                }
                                let _e1151 = phi_1850_;
                                let _e1153 = phi_1851_;
                                let _e1155 = phi_1852_;
                                let _e1157 = phi_1853_;
                                let _e1160 = ((_e1157 * _e1151) - (_e1155 * _e1153));
                                if _e1149 {
                                    phi_1861_ = -(_e1160);
                                } else {
                                    phi_1861_ = _e1160;
                                }
                                let _e1163 = phi_1861_;
                                if (_e1065 < _e1091) {
                                    phi_1872_ = true;
                                } else {
                                    if (_e1065 == _e1091) {
                                        phi_1871_ = (_e1069 < _e1095);
                                    } else {
                                        phi_1871_ = false;
                                    }
                                    let _e1168 = phi_1871_;
                                    phi_1872_ = _e1168;
                                }
                                let _e1170 = phi_1872_;
                                if _e1170 {
                                    phi_1876_ = _e1095;
                                    phi_1877_ = _e1091;
                                    phi_1878_ = _e1069;
                                    phi_1879_ = _e1065;
                                } else {
                                    phi_1876_ = _e1069;
                                    phi_1877_ = _e1065;
                                    phi_1878_ = _e1095;
                                    phi_1879_ = _e1091;
                                }
                                let _e1172 = phi_1876_;
                                let _e1174 = phi_1877_;
                                let _e1176 = phi_1878_;
                                let _e1178 = phi_1879_;
                                let _e1181 = ((_e1178 * _e1172) - (_e1176 * _e1174));
                                if _e1170 {
                                    phi_1887_ = -(_e1181);
                                } else {
                                    phi_1887_ = _e1181;
                                }
                                let _e1184 = phi_1887_;
                                if (_e1142 >= 0f) {
                                    if (_e1163 >= 0f) {
                                        if (_e1184 >= 0f) {
                                            phi_1902_ = ((_e1142 + _e1163) + _e1184);
                                            phi_1903_ = false;
                                        } else {
                                            phi_1902_ = f32();
                                            phi_1903_ = true;
                                        }
                                        let _e1191 = phi_1902_;
                                        let _e1193 = phi_1903_;
                                        phi_1904_ = _e1191;
                                        phi_1905_ = _e1193;
                                    } else {
                                        phi_1904_ = f32();
                                        phi_1905_ = true;
                                    }
                                    let _e1195 = phi_1904_;
                                    let _e1197 = phi_1905_;
                                    phi_1906_ = _e1195;
                                    phi_1907_ = _e1197;
                                } else {
                                    phi_1906_ = f32();
                                    phi_1907_ = true;
                                }
                                let _e1199 = phi_1906_;
                                let _e1201 = phi_1907_;
                                if _e1201 {
                                    if (_e1142 <= 0f) {
                                        if (_e1163 <= 0f) {
                                            let _e1204 = (_e1184 <= 0f);
                                            if _e1204 {
                                            }
                                            phi_1925_ = ((_e1142 + _e1163) + _e1184);
                                            phi_1926_ = false;
                                            phi_1927_ = _e1204;
                                        } else {
                                            phi_1925_ = f32();
                                            phi_1926_ = true;
                                            phi_1927_ = false;
                                        }
                                        let _e1208 = phi_1925_;
                                        let _e1210 = phi_1926_;
                                        let _e1212 = phi_1927_;
                                        phi_1928_ = _e1208;
                                        phi_1929_ = _e1210;
                                        phi_1930_ = _e1212;
                                    } else {
                                        phi_1928_ = f32();
                                        phi_1929_ = true;
                                        phi_1930_ = false;
                                    }
                                    let _e1214 = phi_1928_;
                                    let _e1216 = phi_1929_;
                                    let _e1218 = phi_1930_;
                                    if _e1216 {
                                        phi_1934_ = false;
                                    } else {
                                        phi_1934_ = _e1218;
                                    }
                                    let _e1220 = phi_1934_;
                                    phi_1935_ = _e1214;
                                    phi_1936_ = _e1220;
                                } else {
                                    phi_1935_ = _e1199;
                                    phi_1936_ = true;
                                }
                                let _e1222 = phi_1935_;
                                let _e1224 = phi_1936_;
                                if _e1224 {
                                    let _e1225 = (_e1222 == 0f);
                                    if _e1225 {
                                        phi_2252_ = lt_bvh_triangle_Intersection();
                                        phi_2253_ = false;
                                    } else {
                                        let _e1227 = triangles.member[(0u + _e1038)].v0_;
                                        let _e1229 = (_e1227.x - _e149);
                                        let _e1231 = (_e1227.y - _e151);
                                        let _e1233 = (_e1227.z - _e153);
                                        if (_e548 == 0u) {
                                            phi_1965_ = vec3<f32>(_e1231, _e1233, _e1229);
                                        } else {
                                            if (_e548 == 1u) {
                                                phi_1964_ = vec3<f32>(_e1233, _e1229, _e1231);
                                            } else {
                                                phi_1964_ = (_e1227 - vec3<f32>(_e149, _e151, _e153));
                                            }
                                            let _e1241 = phi_1964_;
                                            phi_1965_ = _e1241;
                                        }
                                        let _e1243 = phi_1965_;
                                        let _e1245 = triangles.member[(0u + _e1038)].v1_;
                                        let _e1247 = triangles.member[(0u + _e1038)].v0_;
                                        let _e1250 = (_e1245.x - _e1247.x);
                                        let _e1253 = (_e1245.y - _e1247.y);
                                        let _e1256 = (_e1245.z - _e1247.z);
                                        if (_e548 == 0u) {
                                            phi_1991_ = vec3<f32>(_e1253, _e1256, _e1250);
                                        } else {
                                            if (_e548 == 1u) {
                                                phi_1990_ = vec3<f32>(_e1256, _e1250, _e1253);
                                            } else {
                                                phi_1990_ = (_e1245 - _e1247);
                                            }
                                            let _e1263 = phi_1990_;
                                            phi_1991_ = _e1263;
                                        }
                                        let _e1265 = phi_1991_;
                                        let _e1267 = triangles.member[(0u + _e1038)].v2_;
                                        let _e1269 = triangles.member[(0u + _e1038)].v0_;
                                        let _e1272 = (_e1267.x - _e1269.x);
                                        let _e1275 = (_e1267.y - _e1269.y);
                                        let _e1278 = (_e1267.z - _e1269.z);
                                        if (_e548 == 0u) {
                                            phi_2017_ = vec3<f32>(_e1275, _e1278, _e1272);
                                        } else {
                                            if (_e548 == 1u) {
                                                phi_2016_ = vec3<f32>(_e1278, _e1272, _e1275);
                                            } else {
                                                phi_2016_ = (_e1267 - _e1269);
                                            }
                                            let _e1285 = phi_2016_;
                                            phi_2017_ = _e1285;
                                        }
                                        let _e1287 = phi_2017_;
                                        let _e1294 = ((_e1265.y * _e1287.z) - (_e1265.z * _e1287.y));
                                        let _e1301 = ((_e1265.z * _e1287.x) - (_e1265.x * _e1287.z));
                                        let _e1308 = ((_e1265.x * _e1287.y) - (_e1265.y * _e1287.x));
                                        let _e1322 = (((1f / _e556.z) * (((_e1294 * _e1243.x) + (_e1301 * _e1243.y)) + (_e1308 * _e1243.z))) / (((_e1294 * _e559) + (_e1301 * _e562)) + _e1308));
                                        if (_e1322 > 0f) {
                                            if (_e1322 < _e161) {
                                                let _e1326 = triangles.member[(0u + _e1038)].v0_;
                                                let _e1328 = triangles.member[(0u + _e1038)].v1_;
                                                if (_e1326.x < _e1328.x) {
                                                    phi_2073_ = _e1326.x;
                                                } else {
                                                    phi_2073_ = _e1328.x;
                                                }
                                                let _e1335 = phi_2073_;
                                                if (_e1326.y < _e1328.y) {
                                                    phi_2082_ = _e1326.y;
                                                } else {
                                                    phi_2082_ = _e1328.y;
                                                }
                                                let _e1342 = phi_2082_;
                                                if (_e1326.z < _e1328.z) {
                                                    phi_2091_ = _e1326.z;
                                                } else {
                                                    phi_2091_ = _e1328.z;
                                                }
                                                let _e1349 = phi_2091_;
                                                let _e1351 = triangles.member[(0u + _e1038)].v2_;
                                                if (_e1335 < _e1351.x) {
                                                    phi_2100_ = _e1335;
                                                } else {
                                                    phi_2100_ = _e1351.x;
                                                }
                                                let _e1356 = phi_2100_;
                                                if (_e1342 < _e1351.y) {
                                                    phi_2107_ = _e1342;
                                                } else {
                                                    phi_2107_ = _e1351.y;
                                                }
                                                let _e1361 = phi_2107_;
                                                if (_e1349 < _e1351.z) {
                                                    phi_2114_ = _e1349;
                                                } else {
                                                    phi_2114_ = _e1351.z;
                                                }
                                                let _e1366 = phi_2114_;
                                                let _e1368 = triangles.member[(0u + _e1038)].v0_;
                                                let _e1370 = triangles.member[(0u + _e1038)].v1_;
                                                if (_e1368.x > _e1370.x) {
                                                    phi_2127_ = _e1368.x;
                                                } else {
                                                    phi_2127_ = _e1370.x;
                                                }
                                                let _e1377 = phi_2127_;
                                                if (_e1368.y > _e1370.y) {
                                                    phi_2136_ = _e1368.y;
                                                } else {
                                                    phi_2136_ = _e1370.y;
                                                }
                                                let _e1384 = phi_2136_;
                                                if (_e1368.z > _e1370.z) {
                                                    phi_2145_ = _e1368.z;
                                                } else {
                                                    phi_2145_ = _e1370.z;
                                                }
                                                let _e1391 = phi_2145_;
                                                let _e1393 = triangles.member[(0u + _e1038)].v2_;
                                                if (_e1377 > _e1393.x) {
                                                    phi_2154_ = _e1377;
                                                } else {
                                                    phi_2154_ = _e1393.x;
                                                }
                                                let _e1398 = phi_2154_;
                                                if (_e1384 > _e1393.y) {
                                                    phi_2161_ = _e1384;
                                                } else {
                                                    phi_2161_ = _e1393.y;
                                                }
                                                let _e1403 = phi_2161_;
                                                if (_e1391 > _e1393.z) {
                                                    phi_2168_ = _e1391;
                                                } else {
                                                    phi_2168_ = _e1393.z;
                                                }
                                                let _e1408 = phi_2168_;
                                                let _e1412 = ((_e1356 - _e149) * _e477);
                                                let _e1413 = ((_e1361 - _e151) * _e487);
                                                let _e1414 = ((_e1366 - _e153) * _e497);
                                                let _e1418 = ((_e1398 - _e149) * _e477);
                                                let _e1419 = ((_e1403 - _e151) * _e487);
                                                let _e1420 = ((_e1408 - _e153) * _e497);
                                                if (_e1412 < _e1418) {
                                                    phi_2185_ = _e1412;
                                                } else {
                                                    phi_2185_ = _e1418;
                                                }
                                                let _e1423 = phi_2185_;
                                                if (_e1413 < _e1419) {
                                                    phi_2190_ = _e1413;
                                                } else {
                                                    phi_2190_ = _e1419;
                                                }
                                                let _e1426 = phi_2190_;
                                                if (_e1414 < _e1420) {
                                                    phi_2195_ = _e1414;
                                                } else {
                                                    phi_2195_ = _e1420;
                                                }
                                                let _e1429 = phi_2195_;
                                                if (_e1412 > _e1418) {
                                                    phi_2203_ = _e1412;
                                                } else {
                                                    phi_2203_ = _e1418;
                                                }
                                                let _e1435 = phi_2203_;
                                                if (_e1413 > _e1419) {
                                                    phi_2208_ = _e1413;
                                                } else {
                                                    phi_2208_ = _e1419;
                                                }
                                                let _e1438 = phi_2208_;
                                                if (_e1414 > _e1420) {
                                                    phi_2213_ = _e1414;
                                                } else {
                                                    phi_2213_ = _e1420;
                                                }
                                                let _e1441 = phi_2213_;
                                                let _e1445 = core_intrinsics_maximum_number_nsz_f32_((_e1423 - _e532), (_e1426 - _e533));
                                                let _e1446 = core_intrinsics_maximum_number_nsz_f32_(_e1445, (_e1429 - _e534));
                                                let _e1447 = core_intrinsics_minimum_number_nsz_f32_((_e1435 + _e532), (_e1438 + _e533));
                                                let _e1448 = core_intrinsics_minimum_number_nsz_f32_(_e1447, (_e1441 + _e534));
                                                if (_e1446 > -300000000000000000000000000000000000000f) {
                                                    phi_2225_ = _e1446;
                                                } else {
                                                    phi_2225_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1451 = phi_2225_;
                                                if (_e1448 < 300000000000000000000000000000000000000f) {
                                                    phi_2230_ = _e1448;
                                                } else {
                                                    phi_2230_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1454 = phi_2230_;
                                                if (_e1322 < _e1451) {
                                                    phi_2235_ = _e1451;
                                                } else {
                                                    phi_2235_ = _e1322;
                                                }
                                                let _e1457 = phi_2235_;
                                                if (_e1457 > _e1454) {
                                                    phi_2240_ = _e1454;
                                                } else {
                                                    phi_2240_ = _e1457;
                                                }
                                                let _e1460 = phi_2240_;
                                                phi_2245_ = lt_bvh_triangle_Intersection(_e1460, (_e1163 / _e1222), (_e1184 / _e1222), (_e1451 <= _e1454));
                                                phi_2246_ = false;
                                            } else {
                                                phi_2245_ = lt_bvh_triangle_Intersection();
                                                phi_2246_ = true;
                                            }
                                            let _e1466 = phi_2245_;
                                            let _e1468 = phi_2246_;
                                            phi_2247_ = _e1466;
                                            phi_2248_ = _e1468;
                                        } else {
                                            phi_2247_ = lt_bvh_triangle_Intersection();
                                            phi_2248_ = true;
                                        }
                                        let _e1470 = phi_2247_;
                                        let _e1472 = phi_2248_;
                                        if _e1472 {
                                        }
                                        phi_2252_ = _e1470;
                                        phi_2253_ = _e1472;
                                    }
                                    let _e1474 = phi_2252_;
                                    let _e1476 = phi_2253_;
                                    phi_2254_ = _e1474;
                                    phi_2255_ = _e1225;
                                    phi_2256_ = _e1476;
                                } else {
                                    phi_2254_ = lt_bvh_triangle_Intersection();
                                    phi_2255_ = true;
                                    phi_2256_ = false;
                                }
                                let _e1478 = phi_2254_;
                                let _e1480 = phi_2255_;
                                let _e1482 = phi_2256_;
                                if _e1480 {
                                    phi_2260_ = true;
                                } else {
                                    phi_2260_ = _e1482;
                                }
                                let _e1484 = phi_2260_;
                                if _e1484 {
                                    phi_2264_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_2264_ = _e1478;
                                }
                                let _e1486 = phi_2264_;
                                if _e1486.is_hit {
                                    if (_e1486.t > 0f) {
                                        if (_e1486.t < _e161) {
                                            let _e1493 = triangles.member[(0u + _e1038)].i0_;
                                            let _e1495 = ((_e1493 & 2147483648u) == 0u);
                                            if _e1495 {
                                                phi_2487_ = false;
                                                phi_2488_ = false;
                                            } else {
                                                if (_e1038 < _e93) {
                                                } else {
                                                    return;
                                                }
                                                let _e1502 = triangles.member[(0u + _e1038)].i0_;
                                                let _e1503 = (_e1502 & 2147483647u);
                                                let _e1505 = triangles.member[(0u + _e1038)].i1_;
                                                let _e1507 = triangles.member[(0u + _e1038)].i2_;
                                                if (_e1503 < _e109) {
                                                } else {
                                                    return;
                                                }
                                                let _e1511 = vertices.member[(0u + _e1503)];
                                                if (_e1505 < _e109) {
                                                } else {
                                                    return;
                                                }
                                                let _e1515 = vertices.member[(0u + _e1505)];
                                                if (_e1507 < _e109) {
                                                } else {
                                                    return;
                                                }
                                                let _e1519 = vertices.member[(0u + _e1507)];
                                                let _e1520 = array<abi_Vertex, 3>(_e1511, _e1515, _e1519);
                                                if (_e1520[0].material < _e112) {
                                                } else {
                                                    return;
                                                }
                                                let _e1526 = materials.member[(0u + _e1520[0].material)];
                                                if ((_e1526.flags & 1u) == 1u) {
                                                    let _e1531 = ((1f - _e1486.u) - _e1486.v);
                                                    if (_e1526.cutoff <= 0f) {
                                                        phi_2481_ = true;
                                                    } else {
                                                        let _e1558 = (_e1526.base_color.w * ((((f32((_e1520[0].color >> bitcast<u32>(24i))) * _e1531) + (f32((_e1520[1].color >> bitcast<u32>(24i))) * _e1486.u)) + (f32((_e1520[2].color >> bitcast<u32>(24i))) * _e1486.v)) * (1f / 255f)));
                                                        if (_e1526.alpha_size == 0u) {
                                                            phi_2478_ = _e1558;
                                                        } else {
                                                            local_2.offset = _e1526.alpha_offset;
                                                            local_2.size = _e1526.alpha_size;
                                                            local_2.flags = _e1526.flags;
                                                            let _e1589 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1520[0].u * _e1531) + (_e1520[1].u * _e1486.u)) + (_e1520[2].u * _e1486.v)), (((_e1520[0].v * _e1531) + (_e1520[1].v * _e1486.u)) + (_e1520[2].v * _e1486.v)));
                                                            let _e1593 = (_e1589.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1593 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1597 = alpha_texels.member[(0u + _e1593)];
                                                            let _e1613 = (_e1589.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1613 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1617 = alpha_texels.member[(0u + _e1613)];
                                                            let _e1634 = (_e1589.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1634 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1638 = alpha_texels.member[(0u + _e1634)];
                                                            let _e1655 = (_e1589.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1655 < _e115) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1659 = alpha_texels.member[(0u + _e1655)];
                                                            phi_2478_ = (_e1558 * (((((f32(((_e1597 >> bitcast<u32>((((_e1589.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1589.weights.x) + ((f32(((_e1617 >> bitcast<u32>((((_e1589.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1589.weights.y)) + ((f32(((_e1638 >> bitcast<u32>((((_e1589.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1589.weights.z)) + ((f32(((_e1659 >> bitcast<u32>((((_e1589.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1589.weights.w)));
                                                        }
                                                        let _e1675 = phi_2478_;
                                                        phi_2481_ = (_e1675 >= _e1526.cutoff);
                                                    }
                                                    let _e1679 = phi_2481_;
                                                    phi_2482_ = _e1679;
                                                } else {
                                                    phi_2482_ = false;
                                                }
                                                let _e1681 = phi_2482_;
                                                if _e1681 {
                                                    phi_2486_ = false;
                                                } else {
                                                    phi_2486_ = true;
                                                }
                                                let _e1683 = phi_2486_;
                                                phi_2487_ = _e1683;
                                                phi_2488_ = _e1681;
                                            }
                                            let _e1685 = phi_2487_;
                                            let _e1687 = phi_2488_;
                                            phi_2489_ = _e1685;
                                            phi_2490_ = _e1495;
                                            phi_2491_ = _e1687;
                                        } else {
                                            phi_2489_ = true;
                                            phi_2490_ = false;
                                            phi_2491_ = false;
                                        }
                                        let _e1689 = phi_2489_;
                                        let _e1691 = phi_2490_;
                                        let _e1693 = phi_2491_;
                                        phi_2492_ = false;
                                        phi_2493_ = _e1689;
                                        phi_2494_ = _e1691;
                                        phi_2495_ = _e1693;
                                    } else {
                                        phi_2492_ = true;
                                        phi_2493_ = false;
                                        phi_2494_ = false;
                                        phi_2495_ = false;
                                    }
                                    let _e1695 = phi_2492_;
                                    let _e1697 = phi_2493_;
                                    let _e1699 = phi_2494_;
                                    let _e1701 = phi_2495_;
                                    phi_2496_ = _e1695;
                                    phi_2497_ = _e1697;
                                    phi_2498_ = _e1699;
                                    phi_2499_ = _e1701;
                                } else {
                                    phi_2496_ = true;
                                    phi_2497_ = false;
                                    phi_2498_ = false;
                                    phi_2499_ = false;
                                }
                                let _e1703 = phi_2496_;
                                let _e1705 = phi_2497_;
                                let _e1707 = phi_2498_;
                                let _e1709 = phi_2499_;
                                if _e1703 {
                                    phi_2503_ = true;
                                    phi_2504_ = false;
                                    phi_2505_ = false;
                                } else {
                                    phi_2503_ = _e1705;
                                    phi_2504_ = _e1707;
                                    phi_2505_ = _e1709;
                                }
                                let _e1711 = phi_2503_;
                                let _e1713 = phi_2504_;
                                let _e1715 = phi_2505_;
                                if _e1711 {
                                    let _e1716 = (_e1040 == 0u);
                                    if _e1716 {
                                        phi_2513_ = false;
                                    } else {
                                        phi_2513_ = true;
                                    }
                                    let _e1718 = phi_2513_;
                                    phi_2514_ = _e1718;
                                    phi_2515_ = _e1716;
                                    phi_2516_ = false;
                                    phi_2517_ = false;
                                } else {
                                    phi_2514_ = false;
                                    phi_2515_ = false;
                                    phi_2516_ = _e1713;
                                    phi_2517_ = _e1715;
                                }
                                let _e1720 = phi_2514_;
                                let _e1722 = phi_2515_;
                                let _e1724 = phi_2516_;
                                let _e1726 = phi_2517_;
                                local_7 = _e1722;
                                local_18 = _e1724;
                                local_19 = _e1726;
                                local_20 = _e1722;
                                continue;
                                continuing {
                                    phi_1670_ = _e1040;
                                    break if !(_e1720);
                                }
                            }
                            let _e1729 = local_7;
                            if _e1729 {
                                phi_2521_ = false;
                                phi_2522_ = false;
                            } else {
                                let _e3674 = local_18;
                                phi_2521_ = _e3674;
                                let _e3677 = local_19;
                                phi_2522_ = _e3677;
                            }
                            let _e1731 = phi_2521_;
                            let _e1733 = phi_2522_;
                            let _e3680 = local_20;
                            phi_2523_ = _e3680;
                            phi_2524_ = _e1731;
                            phi_2525_ = _e1733;
                        }
                        let _e1735 = phi_2523_;
                        let _e1737 = phi_2524_;
                        let _e1739 = phi_2525_;
                        if _e1735 {
                            let _e1741 = local_8;
                            if (_e1741 == 0u) {
                                phi_2533_ = false;
                            } else {
                                phi_2533_ = true;
                            }
                            let _e1744 = phi_2533_;
                            phi_2534_ = _e1744;
                            phi_2535_ = false;
                            phi_2536_ = false;
                        } else {
                            phi_2534_ = false;
                            phi_2535_ = _e1737;
                            phi_2536_ = _e1739;
                        }
                        let _e1746 = phi_2534_;
                        let _e1748 = phi_2535_;
                        let _e1750 = phi_2536_;
                        local_9 = _e1748;
                        local_21 = _e1750;
                        local_22 = _e1748;
                        continue;
                        continuing {
                            let _e3521 = local_15;
                            phi_1216_ = _e3521;
                            let _e3524 = local_16;
                            phi_1219_ = _e3524;
                            break if !(_e1746);
                        }
                    }
                    let _e1753 = local_9;
                    if _e1753 {
                        phi_2540_ = false;
                    } else {
                        let _e3691 = local_21;
                        phi_2540_ = _e3691;
                    }
                    let _e1755 = phi_2540_;
                    if _e1755 {
                        phi_2544_ = true;
                    } else {
                        let _e3694 = local_22;
                        phi_2544_ = _e3694;
                    }
                    let _e1757 = phi_2544_;
                    if _e1757 {
                        phi_2548_ = true;
                    } else {
                        phi_2548_ = false;
                    }
                    let _e1759 = phi_2548_;
                    phi_2549_ = _e1759;
                }
                let _e1761 = phi_2549_;
                phi_4214_ = _e1761;
            } else {
                let _e1762 = abs(_e169);
                let _e1763 = abs(_e170);
                let _e1764 = abs(_e171);
                if (abs(_e149) < 1000000000000000f) {
                    if (abs(_e151) < 1000000000000000f) {
                        phi_2565_ = (abs(_e153) < 1000000000000000f);
                        phi_2566_ = false;
                    } else {
                        phi_2565_ = bool();
                        phi_2566_ = true;
                    }
                    let _e1772 = phi_2565_;
                    let _e1774 = phi_2566_;
                    phi_2567_ = _e1772;
                    phi_2568_ = _e1774;
                } else {
                    phi_2567_ = bool();
                    phi_2568_ = true;
                }
                let _e1776 = phi_2567_;
                let _e1778 = phi_2568_;
                if _e1778 {
                    phi_2572_ = false;
                } else {
                    phi_2572_ = _e1776;
                }
                let _e1780 = phi_2572_;
                if _e1780 {
                    if (_e1762 < 1000000000000000f) {
                        if (_e1763 < 1000000000000000f) {
                            phi_2585_ = (_e1764 < 1000000000000000f);
                            phi_2586_ = false;
                        } else {
                            phi_2585_ = bool();
                            phi_2586_ = true;
                        }
                        let _e1785 = phi_2585_;
                        let _e1787 = phi_2586_;
                        phi_2587_ = _e1785;
                        phi_2588_ = _e1787;
                    } else {
                        phi_2587_ = bool();
                        phi_2588_ = true;
                    }
                    let _e1789 = phi_2587_;
                    let _e1791 = phi_2588_;
                    if _e1791 {
                        phi_2592_ = false;
                    } else {
                        phi_2592_ = _e1789;
                    }
                    let _e1793 = phi_2592_;
                    if _e1793 {
                        if (_e1762 > 0f) {
                            phi_2606_ = bool();
                            phi_2607_ = true;
                        } else {
                            let _e1795 = (_e1763 > 0f);
                            if _e1795 {
                                phi_2605_ = bool();
                            } else {
                                phi_2605_ = (_e1764 > 0f);
                            }
                            let _e1798 = phi_2605_;
                            phi_2606_ = _e1798;
                            phi_2607_ = _e1795;
                        }
                        let _e1800 = phi_2606_;
                        let _e1802 = phi_2607_;
                        if _e1802 {
                            phi_2611_ = true;
                        } else {
                            phi_2611_ = _e1800;
                        }
                        let _e1804 = phi_2611_;
                        phi_2612_ = _e1804;
                        phi_2613_ = false;
                    } else {
                        phi_2612_ = bool();
                        phi_2613_ = true;
                    }
                    let _e1806 = phi_2612_;
                    let _e1808 = phi_2613_;
                    phi_2614_ = _e1806;
                    phi_2615_ = _e1808;
                } else {
                    phi_2614_ = bool();
                    phi_2615_ = true;
                }
                let _e1810 = phi_2614_;
                let _e1812 = phi_2615_;
                if _e1812 {
                    phi_2619_ = false;
                } else {
                    phi_2619_ = _e1810;
                }
                let _e1814 = phi_2619_;
                if _e1814 {
                    let _e1815 = (0u >= _e90);
                    if _e1815 {
                        phi_4207_ = bool();
                    } else {
                        if (0u < _e90) {
                        } else {
                            return;
                        }
                        let _e1821 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1825 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1829 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1833 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1837 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1841 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1845 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1879 = core_intrinsics_maximum_number_nsz_f32_(abs(_e169), abs(_e170));
                        let _e1880 = core_intrinsics_maximum_number_nsz_f32_(_e1879, abs(_e171));
                        let _e1881 = (_e1880 * 0.0000000000009094947f);
                        if (abs(_e169) < _e1881) {
                            phi_2689_ = _e1881;
                        } else {
                            phi_2689_ = abs(_e169);
                        }
                        let _e1886 = phi_2689_;
                        if (_e169 < 0f) {
                            phi_2696_ = (-1f / _e1886);
                        } else {
                            phi_2696_ = (1f / _e1886);
                        }
                        let _e1891 = phi_2696_;
                        if (abs(_e170) < _e1881) {
                            phi_2703_ = _e1881;
                        } else {
                            phi_2703_ = abs(_e170);
                        }
                        let _e1896 = phi_2703_;
                        if (_e170 < 0f) {
                            phi_2710_ = (-1f / _e1896);
                        } else {
                            phi_2710_ = (1f / _e1896);
                        }
                        let _e1901 = phi_2710_;
                        if (abs(_e171) < _e1881) {
                            phi_2717_ = _e1881;
                        } else {
                            phi_2717_ = abs(_e171);
                        }
                        let _e1906 = phi_2717_;
                        if (_e171 < 0f) {
                            phi_2724_ = (-1f / _e1906);
                        } else {
                            phi_2724_ = (1f / _e1906);
                        }
                        let _e1911 = phi_2724_;
                        let _e1915 = abs((bitcast<f32>(_e1821) - _e149));
                        let _e1916 = abs((bitcast<f32>(_e1825) - _e151));
                        let _e1917 = abs((bitcast<f32>(_e1829) - _e153));
                        let _e1921 = abs(((bitcast<f32>(_e1833) + (bitcast<f32>((((_e1845 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                        let _e1922 = abs(((bitcast<f32>(_e1837) + (bitcast<f32>((((_e1845 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e151));
                        let _e1923 = abs(((bitcast<f32>(_e1841) + (bitcast<f32>((((_e1845 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e153));
                        if (_e1915 > _e1921) {
                            phi_2741_ = _e1915;
                        } else {
                            phi_2741_ = _e1921;
                        }
                        let _e1926 = phi_2741_;
                        if (_e1916 > _e1922) {
                            phi_2746_ = _e1916;
                        } else {
                            phi_2746_ = _e1922;
                        }
                        let _e1929 = phi_2746_;
                        if (_e1917 > _e1923) {
                            phi_2751_ = _e1917;
                        } else {
                            phi_2751_ = _e1923;
                        }
                        let _e1932 = phi_2751_;
                        if (_e1926 > _e1929) {
                            phi_2756_ = _e1926;
                        } else {
                            phi_2756_ = _e1929;
                        }
                        let _e1935 = phi_2756_;
                        if (_e1935 > _e1932) {
                            phi_2761_ = _e1935;
                        } else {
                            phi_2761_ = _e1932;
                        }
                        let _e1938 = phi_2761_;
                        let _e1942 = (_e1938 * 0.0000019073486f);
                        let _e1943 = (abs(_e1891) * _e1942);
                        let _e1944 = (abs(_e1901) * _e1942);
                        let _e1945 = (abs(_e1911) * _e1942);
                        let _e1949 = (_e1938 * 0.0000009536743f);
                        let _e1950 = (abs(_e1891) * _e1949);
                        let _e1951 = (abs(_e1901) * _e1949);
                        let _e1952 = (abs(_e1911) * _e1949);
                        let _e1953 = abs(_e169);
                        let _e1954 = abs(_e170);
                        let _e1955 = abs(_e171);
                        if (_e1953 >= _e1954) {
                            if (_e1953 >= _e1955) {
                                phi_2787_ = false;
                            } else {
                                phi_2787_ = true;
                            }
                            let _e1959 = phi_2787_;
                            phi_2788_ = _e1959;
                        } else {
                            phi_2788_ = true;
                        }
                        let _e1961 = phi_2788_;
                        if _e1961 {
                            if (_e1954 >= _e1955) {
                                phi_2796_ = 1u;
                            } else {
                                phi_2796_ = 2u;
                            }
                            let _e1964 = phi_2796_;
                            phi_2797_ = _e1964;
                        } else {
                            phi_2797_ = 0u;
                        }
                        let _e1966 = phi_2797_;
                        if (_e1966 == 0u) {
                            phi_2809_ = vec3<f32>(_e170, _e171, _e169);
                        } else {
                            if (_e1966 == 1u) {
                                phi_2808_ = vec3<f32>(_e171, _e169, _e170);
                            } else {
                                phi_2808_ = _e172;
                            }
                            let _e1972 = phi_2808_;
                            phi_2809_ = _e1972;
                        }
                        let _e1974 = phi_2809_;
                        let _e1977 = (_e1974.x / _e1974.z);
                        let _e1980 = (_e1974.y / _e1974.z);
                        if (_e1891 < 0f) {
                            phi_2822_ = 0u;
                        } else {
                            phi_2822_ = 1u;
                        }
                        let _e1985 = phi_2822_;
                        if (_e1901 < 0f) {
                            phi_2827_ = 0u;
                        } else {
                            phi_2827_ = 2u;
                        }
                        let _e1988 = phi_2827_;
                        if (_e1911 < 0f) {
                            phi_2832_ = 0u;
                        } else {
                            phi_2832_ = 4u;
                        }
                        let _e1991 = phi_2832_;
                        let _e1993 = ((_e1985 | _e1988) | _e1991);
                        let _e1994 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1994.first[0], _e1994.first[1], _e1994.first[2], _e1994.first[3], _e1994.first[4], _e1994.first[5], _e1994.first[6], _e1994.first[7], _e1994.first[8], _e1994.first[9], _e1994.first[10], _e1994.first[11], _e1994.first[12], _e1994.first[13], _e1994.first[14], _e1994.first[15], _e1994.first[16], _e1994.first[17], _e1994.first[18], _e1994.first[19], _e1994.first[20], _e1994.first[21], _e1994.first[22], _e1994.first[23], _e1994.first[24], _e1994.first[25], _e1994.first[26], _e1994.first[27], _e1994.first[28], _e1994.first[29], _e1994.first[30], _e1994.first[31]), array<u32, 32>(_e1994.mask[0], _e1994.mask[1], _e1994.mask[2], _e1994.mask[3], _e1994.mask[4], _e1994.mask[5], _e1994.mask[6], _e1994.mask[7], _e1994.mask[8], _e1994.mask[9], _e1994.mask[10], _e1994.mask[11], _e1994.mask[12], _e1994.mask[13], _e1994.mask[14], _e1994.mask[15], _e1994.mask[16], _e1994.mask[17], _e1994.mask[18], _e1994.mask[19], _e1994.mask[20], _e1994.mask[21], _e1994.mask[22], _e1994.mask[23], _e1994.mask[24], _e1994.mask[25], _e1994.mask[26], _e1994.mask[27], _e1994.mask[28], _e1994.mask[29], _e1994.mask[30], _e1994.mask[31]), _e1994.len, _e1994.group, _e1994.group_mask);
                        let _e2068 = local_1.group_mask;
                        if ((_e2068 & 4278190080u) == 0u) {
                            let _e2072 = local_1.len;
                            if (_e2072 == 0u) {
                                phi_2946_ = false;
                            } else {
                                let _e2076 = local_1.len;
                                local_1.len = (_e2076 - 1u);
                                let _e2079 = local_1.len;
                                if (_e2079 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2084 = local_1.first[(0u + _e2079)];
                                local_1.group = _e2084;
                                let _e2087 = local_1.len;
                                if (_e2087 < 32u) {
                                } else {
                                    return;
                                }
                                let _e2092 = local_1.mask[(0u + _e2087)];
                                local_1.group_mask = _e2092;
                                phi_2946_ = true;
                            }
                            let _e2095 = phi_2946_;
                            phi_2947_ = _e2095;
                        } else {
                            phi_2947_ = true;
                        }
                        let _e2097 = phi_2947_;
                        if _e2097 {
                            let _e2099 = local_1.group_mask;
                            let _e2105 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e2099)), 32u, (_e2099 == 0u)));
                            let _e2109 = local_1.group_mask;
                            let _e2123 = local_1.group_mask;
                            local_1.group_mask = (_e2123 & ~((1u << bitcast<u32>((_e2105 & 31u)))));
                            let _e2126 = local_1.group;
                            phi_2978_ = (_e2126 + countOneBits(((_e2109 & ~((4294967295u << bitcast<u32>((((_e2105 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2978_ = 4294967295u;
                        }
                        let _e2129 = phi_2978_;
                        phi_2980_ = _e2129;
                        phi_2983_ = false;
                        loop {
                            let _e2131 = phi_2980_;
                            let _e2133 = phi_2983_;
                            local_27 = _e2133;
                            if (_e2131 != 4294967295u) {
                                if (_e2131 < _e90) {
                                } else {
                                    return;
                                }
                                let _e2140 = nodes.member[(0u + _e2131)].frame[3u];
                                let _e2165 = (bitcast<f32>((((_e2140 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1891);
                                let _e2166 = (bitcast<f32>((((_e2140 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1901);
                                let _e2167 = (bitcast<f32>((((_e2140 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1911);
                                let _e2170 = nodes.member[(0u + _e2131)].frame[0u];
                                let _e2174 = nodes.member[(0u + _e2131)].frame[1u];
                                let _e2178 = nodes.member[(0u + _e2131)].frame[2u];
                                let _e2183 = ((bitcast<f32>(_e2170) - _e149) * _e1891);
                                let _e2184 = ((bitcast<f32>(_e2174) - _e151) * _e1901);
                                let _e2185 = ((bitcast<f32>(_e2178) - _e153) * _e1911);
                                let _e2193 = nodes.member[(0u + _e2131)].x;
                                if (_e1891 < 0f) {
                                    let _e2204 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2193.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2210 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2204.unnamed.root, _e2193.w), _e2204.unnamed_1);
                                    let _e2216 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2210.unnamed, lt_bvh_traverse_Tree(_e2193.x, _e2210.unnamed_1.first_primitive));
                                    phi_3063_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2216.unnamed, lt_bvh_traverse_Tree(_e2216.unnamed_1.root, _e2193.y));
                                } else {
                                    let _e2232 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2193.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2238 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2232.unnamed.root, _e2193.y), _e2232.unnamed_1);
                                    let _e2244 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2238.unnamed, lt_bvh_traverse_Tree(_e2193.z, _e2238.unnamed_1.first_primitive));
                                    phi_3063_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2244.unnamed, lt_bvh_traverse_Tree(_e2244.unnamed_1.root, _e2193.w));
                                }
                                let _e2252 = phi_3063_;
                                let _e2262 = nodes.member[(0u + _e2131)].y;
                                if (_e1901 < 0f) {
                                    let _e2273 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2262.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2279 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2273.unnamed.root, _e2262.w), _e2273.unnamed_1);
                                    let _e2285 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2279.unnamed, lt_bvh_traverse_Tree(_e2262.x, _e2279.unnamed_1.first_primitive));
                                    phi_3090_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2285.unnamed, lt_bvh_traverse_Tree(_e2285.unnamed_1.root, _e2262.y));
                                } else {
                                    let _e2301 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2262.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2307 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2301.unnamed.root, _e2262.y), _e2301.unnamed_1);
                                    let _e2313 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2307.unnamed, lt_bvh_traverse_Tree(_e2262.z, _e2307.unnamed_1.first_primitive));
                                    phi_3090_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2313.unnamed, lt_bvh_traverse_Tree(_e2313.unnamed_1.root, _e2262.w));
                                }
                                let _e2321 = phi_3090_;
                                let _e2331 = nodes.member[(0u + _e2131)].z;
                                if (_e1911 < 0f) {
                                    let _e2342 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2331.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2348 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2342.unnamed.root, _e2331.w), _e2342.unnamed_1);
                                    let _e2354 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2348.unnamed, lt_bvh_traverse_Tree(_e2331.x, _e2348.unnamed_1.first_primitive));
                                    phi_3117_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2354.unnamed, lt_bvh_traverse_Tree(_e2354.unnamed_1.root, _e2331.y));
                                } else {
                                    let _e2370 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2331.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2376 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e2370.unnamed.root, _e2331.y), _e2370.unnamed_1);
                                    let _e2382 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2376.unnamed, lt_bvh_traverse_Tree(_e2331.z, _e2376.unnamed_1.first_primitive));
                                    phi_3117_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2382.unnamed, lt_bvh_traverse_Tree(_e2382.unnamed_1.root, _e2331.w));
                                }
                                let _e2390 = phi_3117_;
                                phi_3123_ = 0u;
                                phi_3126_ = 0u;
                                loop {
                                    let _e2400 = phi_3123_;
                                    let _e2402 = phi_3126_;
                                    local_10 = _e2402;
                                    local_11 = _e2402;
                                    local_12 = _e2402;
                                    let _e2403 = (_e2400 < 8u);
                                    if _e2403 {
                                        let _e2405 = (_e2400 >> bitcast<u32>(2i));
                                        let _e2406 = (_e2400 & 3u);
                                        if (_e2405 == 0u) {
                                            phi_3140_ = _e2252.unnamed.root;
                                        } else {
                                            phi_3140_ = _e2252.unnamed.first_primitive;
                                        }
                                        let _e2409 = phi_3140_;
                                        if (_e2405 == 0u) {
                                            phi_3150_ = _e2321.unnamed.root;
                                        } else {
                                            phi_3150_ = _e2321.unnamed.first_primitive;
                                        }
                                        let _e2418 = phi_3150_;
                                        if (_e2405 == 0u) {
                                            phi_3160_ = _e2390.unnamed.root;
                                        } else {
                                            phi_3160_ = _e2390.unnamed.first_primitive;
                                        }
                                        let _e2427 = phi_3160_;
                                        let _e2440 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2409 >> bitcast<u32>(((_e2406 * 8u) & 31u))) & 255u)) * _e2165) + (_e2183 - _e1943)), ((f32(((_e2418 >> bitcast<u32>(((_e2406 * 8u) & 31u))) & 255u)) * _e2166) + (_e2184 - _e1944)));
                                        let _e2441 = core_intrinsics_maximum_number_nsz_f32_(_e2440, ((f32(((_e2427 >> bitcast<u32>(((_e2406 * 8u) & 31u))) & 255u)) * _e2167) + (_e2185 - _e1945)));
                                        if (_e2405 == 0u) {
                                            phi_3178_ = _e2252.unnamed_1.root;
                                        } else {
                                            phi_3178_ = _e2252.unnamed_1.first_primitive;
                                        }
                                        let _e2444 = phi_3178_;
                                        if (_e2405 == 0u) {
                                            phi_3188_ = _e2321.unnamed_1.root;
                                        } else {
                                            phi_3188_ = _e2321.unnamed_1.first_primitive;
                                        }
                                        let _e2453 = phi_3188_;
                                        if (_e2405 == 0u) {
                                            phi_3198_ = _e2390.unnamed_1.root;
                                        } else {
                                            phi_3198_ = _e2390.unnamed_1.first_primitive;
                                        }
                                        let _e2462 = phi_3198_;
                                        let _e2475 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2444 >> bitcast<u32>(((_e2406 * 8u) & 31u))) & 255u)) * _e2165) + (_e2183 + _e1943)), ((f32(((_e2453 >> bitcast<u32>(((_e2406 * 8u) & 31u))) & 255u)) * _e2166) + (_e2184 + _e1944)));
                                        let _e2476 = core_intrinsics_minimum_number_nsz_f32_(_e2475, ((f32(((_e2462 >> bitcast<u32>(((_e2406 * 8u) & 31u))) & 255u)) * _e2167) + (_e2185 + _e1945)));
                                        if (_e2441 <= _e2476) {
                                            if (_e2441 <= _e161) {
                                                if (_e2476 >= 0f) {
                                                    if (_e2405 == 0u) {
                                                        let _e2483 = nodes.member[(0u + _e2131)].links[2u];
                                                        phi_3234_ = _e2483;
                                                    } else {
                                                        let _e2486 = nodes.member[(0u + _e2131)].links[3u];
                                                        phi_3234_ = _e2486;
                                                    }
                                                    let _e2488 = phi_3234_;
                                                    let _e2493 = ((_e2488 >> bitcast<u32>(((_e2406 * 8u) & 31u))) & 255u);
                                                    let _e2494 = (_e2493 & 31u);
                                                    if (_e2494 >= 24u) {
                                                        phi_3247_ = (24u + ((_e2494 - 24u) ^ _e1993));
                                                    } else {
                                                        phi_3247_ = _e2494;
                                                    }
                                                    let _e2500 = phi_3247_;
                                                    phi_3252_ = (_e2402 | ((_e2493 >> bitcast<u32>(5i)) << bitcast<u32>((_e2500 & 31u))));
                                                } else {
                                                    phi_3252_ = _e2402;
                                                }
                                                let _e2508 = phi_3252_;
                                                phi_3253_ = _e2508;
                                            } else {
                                                phi_3253_ = _e2402;
                                            }
                                            let _e2510 = phi_3253_;
                                            phi_3254_ = _e2510;
                                        } else {
                                            phi_3254_ = _e2402;
                                        }
                                        let _e2512 = phi_3254_;
                                        phi_3124_ = (_e2400 + 1u);
                                        phi_3127_ = _e2512;
                                    } else {
                                        phi_3124_ = u32();
                                        phi_3127_ = u32();
                                    }
                                    let _e2515 = phi_3124_;
                                    let _e2517 = phi_3127_;
                                    continue;
                                    continuing {
                                        phi_3123_ = _e2515;
                                        phi_3126_ = _e2517;
                                        break if !(_e2403);
                                    }
                                }
                                let _e2521 = nodes.member[(0u + _e2131)].links[0u];
                                let _e2525 = nodes.member[(0u + _e2131)].frame[3u];
                                let _e2529 = local_10;
                                if ((_e2529 & 4278190080u) == 0u) {
                                } else {
                                    let _e2533 = local_1.group_mask;
                                    if ((_e2533 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2537 = local_1.len;
                                        if (_e2537 < 32u) {
                                            let _e2540 = local_1.group;
                                            let _e2542 = local_1.len;
                                            if (_e2542 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2542)] = _e2540;
                                            let _e2548 = local_1.group_mask;
                                            let _e2550 = local_1.len;
                                            if (_e2550 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2550)] = _e2548;
                                            let _e2557 = local_1.len;
                                            local_1.len = (_e2557 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2521);
                                    let _e2561 = local_11;
                                    local_1.group_mask = ((_e2561 & 4278190080u) | (_e2525 >> bitcast<u32>(24i)));
                                }
                                let _e2566 = local_12;
                                phi_3312_ = (_e2566 & 16777215u);
                                phi_3315_ = _e2133;
                                loop {
                                    let _e2569 = phi_3312_;
                                    let _e2571 = phi_3315_;
                                    local_23 = _e2571;
                                    let _e2572 = (_e2569 == 0u);
                                    local_13 = _e2572;
                                    local_25 = _e2572;
                                    if _e2572 {
                                        phi_3313_ = u32();
                                        phi_3316_ = bool();
                                        phi_4119_ = bool();
                                        phi_4120_ = false;
                                    } else {
                                        let _e2575 = nodes.member[(0u + _e2131)].links[1u];
                                        let _e2580 = ((0u + _e2575) + select(firstTrailingBit(_e2569), 32u, (_e2569 == 0u)));
                                        if (_e2580 < _e93) {
                                        } else {
                                            return;
                                        }
                                        let _e2587 = triangles.member[(0u + _e2580)].v0_;
                                        let _e2589 = (_e2587.x - _e149);
                                        let _e2591 = (_e2587.y - _e151);
                                        let _e2593 = (_e2587.z - _e153);
                                        if (_e1966 == 0u) {
                                            phi_3360_ = vec3<f32>(_e2591, _e2593, _e2589);
                                        } else {
                                            if (_e1966 == 1u) {
                                                phi_3359_ = vec3<f32>(_e2593, _e2589, _e2591);
                                            } else {
                                                phi_3359_ = (_e2587 - vec3<f32>(_e149, _e151, _e153));
                                            }
                                            let _e2601 = phi_3359_;
                                            phi_3360_ = _e2601;
                                        }
                                        let _e2603 = phi_3360_;
                                        let _e2607 = (_e2603.x - (_e1977 * _e2603.z));
                                        let _e2611 = (_e2603.y - (_e1980 * _e2603.z));
                                        let _e2613 = triangles.member[(0u + _e2580)].v1_;
                                        let _e2615 = (_e2613.x - _e149);
                                        let _e2617 = (_e2613.y - _e151);
                                        let _e2619 = (_e2613.z - _e153);
                                        if (_e1966 == 0u) {
                                            phi_3390_ = vec3<f32>(_e2617, _e2619, _e2615);
                                        } else {
                                            if (_e1966 == 1u) {
                                                phi_3389_ = vec3<f32>(_e2619, _e2615, _e2617);
                                            } else {
                                                phi_3389_ = (_e2613 - vec3<f32>(_e149, _e151, _e153));
                                            }
                                            let _e2627 = phi_3389_;
                                            phi_3390_ = _e2627;
                                        }
                                        let _e2629 = phi_3390_;
                                        let _e2633 = (_e2629.x - (_e1977 * _e2629.z));
                                        let _e2637 = (_e2629.y - (_e1980 * _e2629.z));
                                        let _e2639 = triangles.member[(0u + _e2580)].v2_;
                                        let _e2641 = (_e2639.x - _e149);
                                        let _e2643 = (_e2639.y - _e151);
                                        let _e2645 = (_e2639.z - _e153);
                                        if (_e1966 == 0u) {
                                            phi_3420_ = vec3<f32>(_e2643, _e2645, _e2641);
                                        } else {
                                            if (_e1966 == 1u) {
                                                phi_3419_ = vec3<f32>(_e2645, _e2641, _e2643);
                                            } else {
                                                phi_3419_ = (_e2639 - vec3<f32>(_e149, _e151, _e153));
                                            }
                                            let _e2653 = phi_3419_;
                                            phi_3420_ = _e2653;
                                        }
                                        let _e2655 = phi_3420_;
                                        let _e2659 = (_e2655.x - (_e1977 * _e2655.z));
                                        let _e2663 = (_e2655.y - (_e1980 * _e2655.z));
                                        if (_e2633 < _e2659) {
                                            phi_3439_ = true;
                                        } else {
                                            if (_e2633 == _e2659) {
                                                phi_3438_ = (_e2637 < _e2663);
                                            } else {
                                                phi_3438_ = false;
                                            }
                                            let _e2668 = phi_3438_;
                                            phi_3439_ = _e2668;
                                        }
                                        let _e2670 = phi_3439_;
                                        if _e2670 {
                                            phi_3443_ = _e2663;
                                            phi_3444_ = _e2659;
                                            phi_3445_ = _e2637;
                                            phi_3446_ = _e2633;
                                        } else {
                                            phi_3443_ = _e2637;
                                            phi_3444_ = _e2633;
                                            phi_3445_ = _e2663;
                                            phi_3446_ = _e2659;
                                        }
                                        let _e2672 = phi_3443_;
                                        let _e2674 = phi_3444_;
                                        let _e2676 = phi_3445_;
                                        let _e2678 = phi_3446_;
                                        let _e2681 = ((_e2678 * _e2672) - (_e2676 * _e2674));
                                        if _e2670 {
                                            phi_3454_ = -(_e2681);
                                        } else {
                                            phi_3454_ = _e2681;
                                        }
                                        let _e2684 = phi_3454_;
                                        if (_e2659 < _e2607) {
                                            phi_3465_ = true;
                                        } else {
                                            if (_e2659 == _e2607) {
                                                phi_3464_ = (_e2663 < _e2611);
                                            } else {
                                                phi_3464_ = false;
                                            }
                                            let _e2689 = phi_3464_;
                                            phi_3465_ = _e2689;
                                        }
                                        let _e2691 = phi_3465_;
                                        if _e2691 {
                                            phi_3469_ = _e2611;
                                            phi_3470_ = _e2607;
                                            phi_3471_ = _e2663;
                                            phi_3472_ = _e2659;
                                        } else {
                                            phi_3469_ = _e2663;
                                            phi_3470_ = _e2659;
                                            phi_3471_ = _e2611;
                                            phi_3472_ = _e2607;
                                        }
                                        let _e2693 = phi_3469_;
                                        let _e2695 = phi_3470_;
                                        let _e2697 = phi_3471_;
                                        let _e2699 = phi_3472_;
                                        let _e2702 = ((_e2699 * _e2693) - (_e2697 * _e2695));
                                        if _e2691 {
                                            phi_3480_ = -(_e2702);
                                        } else {
                                            phi_3480_ = _e2702;
                                        }
                                        let _e2705 = phi_3480_;
                                        if (_e2607 < _e2633) {
                                            phi_3491_ = true;
                                        } else {
                                            if (_e2607 == _e2633) {
                                                phi_3490_ = (_e2611 < _e2637);
                                            } else {
                                                phi_3490_ = false;
                                            }
                                            let _e2710 = phi_3490_;
                                            phi_3491_ = _e2710;
                                        }
                                        let _e2712 = phi_3491_;
                                        if _e2712 {
                                            phi_3495_ = _e2637;
                                            phi_3496_ = _e2633;
                                            phi_3497_ = _e2611;
                                            phi_3498_ = _e2607;
                                        } else {
                                            phi_3495_ = _e2611;
                                            phi_3496_ = _e2607;
                                            phi_3497_ = _e2637;
                                            phi_3498_ = _e2633;
                                        }
                                        let _e2714 = phi_3495_;
                                        let _e2716 = phi_3496_;
                                        let _e2718 = phi_3497_;
                                        let _e2720 = phi_3498_;
                                        let _e2723 = ((_e2720 * _e2714) - (_e2718 * _e2716));
                                        if _e2712 {
                                            phi_3506_ = -(_e2723);
                                        } else {
                                            phi_3506_ = _e2723;
                                        }
                                        let _e2726 = phi_3506_;
                                        if (_e2684 >= 0f) {
                                            if (_e2705 >= 0f) {
                                                if (_e2726 >= 0f) {
                                                    phi_3521_ = ((_e2684 + _e2705) + _e2726);
                                                    phi_3522_ = false;
                                                } else {
                                                    phi_3521_ = f32();
                                                    phi_3522_ = true;
                                                }
                                                let _e2733 = phi_3521_;
                                                let _e2735 = phi_3522_;
                                                phi_3523_ = _e2733;
                                                phi_3524_ = _e2735;
                                            } else {
                                                phi_3523_ = f32();
                                                phi_3524_ = true;
                                            }
                                            let _e2737 = phi_3523_;
                                            let _e2739 = phi_3524_;
                                            phi_3525_ = _e2737;
                                            phi_3526_ = _e2739;
                                        } else {
                                            phi_3525_ = f32();
                                            phi_3526_ = true;
                                        }
                                        let _e2741 = phi_3525_;
                                        let _e2743 = phi_3526_;
                                        if _e2743 {
                                            if (_e2684 <= 0f) {
                                                if (_e2705 <= 0f) {
                                                    let _e2746 = (_e2726 <= 0f);
                                                    if _e2746 {
                                                    }
                                                    phi_3544_ = ((_e2684 + _e2705) + _e2726);
                                                    phi_3545_ = false;
                                                    phi_3546_ = _e2746;
                                                } else {
                                                    phi_3544_ = f32();
                                                    phi_3545_ = true;
                                                    phi_3546_ = false;
                                                }
                                                let _e2750 = phi_3544_;
                                                let _e2752 = phi_3545_;
                                                let _e2754 = phi_3546_;
                                                phi_3547_ = _e2750;
                                                phi_3548_ = _e2752;
                                                phi_3549_ = _e2754;
                                            } else {
                                                phi_3547_ = f32();
                                                phi_3548_ = true;
                                                phi_3549_ = false;
                                            }
                                            let _e2756 = phi_3547_;
                                            let _e2758 = phi_3548_;
                                            let _e2760 = phi_3549_;
                                            if _e2758 {
                                                phi_3553_ = false;
                                            } else {
                                                phi_3553_ = _e2760;
                                            }
                                            let _e2762 = phi_3553_;
                                            phi_3554_ = _e2756;
                                            phi_3555_ = _e2762;
                                        } else {
                                            phi_3554_ = _e2741;
                                            phi_3555_ = true;
                                        }
                                        let _e2764 = phi_3554_;
                                        let _e2766 = phi_3555_;
                                        if _e2766 {
                                            let _e2767 = (_e2764 == 0f);
                                            if _e2767 {
                                                phi_3871_ = lt_bvh_triangle_Intersection();
                                                phi_3872_ = false;
                                            } else {
                                                let _e2769 = triangles.member[(0u + _e2580)].v0_;
                                                let _e2771 = (_e2769.x - _e149);
                                                let _e2773 = (_e2769.y - _e151);
                                                let _e2775 = (_e2769.z - _e153);
                                                if (_e1966 == 0u) {
                                                    phi_3584_ = vec3<f32>(_e2773, _e2775, _e2771);
                                                } else {
                                                    if (_e1966 == 1u) {
                                                        phi_3583_ = vec3<f32>(_e2775, _e2771, _e2773);
                                                    } else {
                                                        phi_3583_ = (_e2769 - vec3<f32>(_e149, _e151, _e153));
                                                    }
                                                    let _e2783 = phi_3583_;
                                                    phi_3584_ = _e2783;
                                                }
                                                let _e2785 = phi_3584_;
                                                let _e2787 = triangles.member[(0u + _e2580)].v1_;
                                                let _e2789 = triangles.member[(0u + _e2580)].v0_;
                                                let _e2792 = (_e2787.x - _e2789.x);
                                                let _e2795 = (_e2787.y - _e2789.y);
                                                let _e2798 = (_e2787.z - _e2789.z);
                                                if (_e1966 == 0u) {
                                                    phi_3610_ = vec3<f32>(_e2795, _e2798, _e2792);
                                                } else {
                                                    if (_e1966 == 1u) {
                                                        phi_3609_ = vec3<f32>(_e2798, _e2792, _e2795);
                                                    } else {
                                                        phi_3609_ = (_e2787 - _e2789);
                                                    }
                                                    let _e2805 = phi_3609_;
                                                    phi_3610_ = _e2805;
                                                }
                                                let _e2807 = phi_3610_;
                                                let _e2809 = triangles.member[(0u + _e2580)].v2_;
                                                let _e2811 = triangles.member[(0u + _e2580)].v0_;
                                                let _e2814 = (_e2809.x - _e2811.x);
                                                let _e2817 = (_e2809.y - _e2811.y);
                                                let _e2820 = (_e2809.z - _e2811.z);
                                                if (_e1966 == 0u) {
                                                    phi_3636_ = vec3<f32>(_e2817, _e2820, _e2814);
                                                } else {
                                                    if (_e1966 == 1u) {
                                                        phi_3635_ = vec3<f32>(_e2820, _e2814, _e2817);
                                                    } else {
                                                        phi_3635_ = (_e2809 - _e2811);
                                                    }
                                                    let _e2827 = phi_3635_;
                                                    phi_3636_ = _e2827;
                                                }
                                                let _e2829 = phi_3636_;
                                                let _e2836 = ((_e2807.y * _e2829.z) - (_e2807.z * _e2829.y));
                                                let _e2843 = ((_e2807.z * _e2829.x) - (_e2807.x * _e2829.z));
                                                let _e2850 = ((_e2807.x * _e2829.y) - (_e2807.y * _e2829.x));
                                                let _e2864 = (((1f / _e1974.z) * (((_e2836 * _e2785.x) + (_e2843 * _e2785.y)) + (_e2850 * _e2785.z))) / (((_e2836 * _e1977) + (_e2843 * _e1980)) + _e2850));
                                                if (_e2864 > 0f) {
                                                    if (_e2864 < _e161) {
                                                        let _e2868 = triangles.member[(0u + _e2580)].v0_;
                                                        let _e2870 = triangles.member[(0u + _e2580)].v1_;
                                                        if (_e2868.x < _e2870.x) {
                                                            phi_3692_ = _e2868.x;
                                                        } else {
                                                            phi_3692_ = _e2870.x;
                                                        }
                                                        let _e2877 = phi_3692_;
                                                        if (_e2868.y < _e2870.y) {
                                                            phi_3701_ = _e2868.y;
                                                        } else {
                                                            phi_3701_ = _e2870.y;
                                                        }
                                                        let _e2884 = phi_3701_;
                                                        if (_e2868.z < _e2870.z) {
                                                            phi_3710_ = _e2868.z;
                                                        } else {
                                                            phi_3710_ = _e2870.z;
                                                        }
                                                        let _e2891 = phi_3710_;
                                                        let _e2893 = triangles.member[(0u + _e2580)].v2_;
                                                        if (_e2877 < _e2893.x) {
                                                            phi_3719_ = _e2877;
                                                        } else {
                                                            phi_3719_ = _e2893.x;
                                                        }
                                                        let _e2898 = phi_3719_;
                                                        if (_e2884 < _e2893.y) {
                                                            phi_3726_ = _e2884;
                                                        } else {
                                                            phi_3726_ = _e2893.y;
                                                        }
                                                        let _e2903 = phi_3726_;
                                                        if (_e2891 < _e2893.z) {
                                                            phi_3733_ = _e2891;
                                                        } else {
                                                            phi_3733_ = _e2893.z;
                                                        }
                                                        let _e2908 = phi_3733_;
                                                        let _e2910 = triangles.member[(0u + _e2580)].v0_;
                                                        let _e2912 = triangles.member[(0u + _e2580)].v1_;
                                                        if (_e2910.x > _e2912.x) {
                                                            phi_3746_ = _e2910.x;
                                                        } else {
                                                            phi_3746_ = _e2912.x;
                                                        }
                                                        let _e2919 = phi_3746_;
                                                        if (_e2910.y > _e2912.y) {
                                                            phi_3755_ = _e2910.y;
                                                        } else {
                                                            phi_3755_ = _e2912.y;
                                                        }
                                                        let _e2926 = phi_3755_;
                                                        if (_e2910.z > _e2912.z) {
                                                            phi_3764_ = _e2910.z;
                                                        } else {
                                                            phi_3764_ = _e2912.z;
                                                        }
                                                        let _e2933 = phi_3764_;
                                                        let _e2935 = triangles.member[(0u + _e2580)].v2_;
                                                        if (_e2919 > _e2935.x) {
                                                            phi_3773_ = _e2919;
                                                        } else {
                                                            phi_3773_ = _e2935.x;
                                                        }
                                                        let _e2940 = phi_3773_;
                                                        if (_e2926 > _e2935.y) {
                                                            phi_3780_ = _e2926;
                                                        } else {
                                                            phi_3780_ = _e2935.y;
                                                        }
                                                        let _e2945 = phi_3780_;
                                                        if (_e2933 > _e2935.z) {
                                                            phi_3787_ = _e2933;
                                                        } else {
                                                            phi_3787_ = _e2935.z;
                                                        }
                                                        let _e2950 = phi_3787_;
                                                        let _e2954 = ((_e2898 - _e149) * _e1891);
                                                        let _e2955 = ((_e2903 - _e151) * _e1901);
                                                        let _e2956 = ((_e2908 - _e153) * _e1911);
                                                        let _e2960 = ((_e2940 - _e149) * _e1891);
                                                        let _e2961 = ((_e2945 - _e151) * _e1901);
                                                        let _e2962 = ((_e2950 - _e153) * _e1911);
                                                        if (_e2954 < _e2960) {
                                                            phi_3804_ = _e2954;
                                                        } else {
                                                            phi_3804_ = _e2960;
                                                        }
                                                        let _e2965 = phi_3804_;
                                                        if (_e2955 < _e2961) {
                                                            phi_3809_ = _e2955;
                                                        } else {
                                                            phi_3809_ = _e2961;
                                                        }
                                                        let _e2968 = phi_3809_;
                                                        if (_e2956 < _e2962) {
                                                            phi_3814_ = _e2956;
                                                        } else {
                                                            phi_3814_ = _e2962;
                                                        }
                                                        let _e2971 = phi_3814_;
                                                        if (_e2954 > _e2960) {
                                                            phi_3822_ = _e2954;
                                                        } else {
                                                            phi_3822_ = _e2960;
                                                        }
                                                        let _e2977 = phi_3822_;
                                                        if (_e2955 > _e2961) {
                                                            phi_3827_ = _e2955;
                                                        } else {
                                                            phi_3827_ = _e2961;
                                                        }
                                                        let _e2980 = phi_3827_;
                                                        if (_e2956 > _e2962) {
                                                            phi_3832_ = _e2956;
                                                        } else {
                                                            phi_3832_ = _e2962;
                                                        }
                                                        let _e2983 = phi_3832_;
                                                        let _e2987 = core_intrinsics_maximum_number_nsz_f32_((_e2965 - _e1950), (_e2968 - _e1951));
                                                        let _e2988 = core_intrinsics_maximum_number_nsz_f32_(_e2987, (_e2971 - _e1952));
                                                        let _e2989 = core_intrinsics_minimum_number_nsz_f32_((_e2977 + _e1950), (_e2980 + _e1951));
                                                        let _e2990 = core_intrinsics_minimum_number_nsz_f32_(_e2989, (_e2983 + _e1952));
                                                        if (_e2988 > -300000000000000000000000000000000000000f) {
                                                            phi_3844_ = _e2988;
                                                        } else {
                                                            phi_3844_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2993 = phi_3844_;
                                                        if (_e2990 < 300000000000000000000000000000000000000f) {
                                                            phi_3849_ = _e2990;
                                                        } else {
                                                            phi_3849_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2996 = phi_3849_;
                                                        if (_e2864 < _e2993) {
                                                            phi_3854_ = _e2993;
                                                        } else {
                                                            phi_3854_ = _e2864;
                                                        }
                                                        let _e2999 = phi_3854_;
                                                        if (_e2999 > _e2996) {
                                                            phi_3859_ = _e2996;
                                                        } else {
                                                            phi_3859_ = _e2999;
                                                        }
                                                        let _e3002 = phi_3859_;
                                                        phi_3864_ = lt_bvh_triangle_Intersection(_e3002, (_e2705 / _e2764), (_e2726 / _e2764), (_e2993 <= _e2996));
                                                        phi_3865_ = false;
                                                    } else {
                                                        phi_3864_ = lt_bvh_triangle_Intersection();
                                                        phi_3865_ = true;
                                                    }
                                                    let _e3008 = phi_3864_;
                                                    let _e3010 = phi_3865_;
                                                    phi_3866_ = _e3008;
                                                    phi_3867_ = _e3010;
                                                } else {
                                                    phi_3866_ = lt_bvh_triangle_Intersection();
                                                    phi_3867_ = true;
                                                }
                                                let _e3012 = phi_3866_;
                                                let _e3014 = phi_3867_;
                                                if _e3014 {
                                                }
                                                phi_3871_ = _e3012;
                                                phi_3872_ = _e3014;
                                            }
                                            let _e3016 = phi_3871_;
                                            let _e3018 = phi_3872_;
                                            phi_3873_ = _e3016;
                                            phi_3874_ = _e2767;
                                            phi_3875_ = _e3018;
                                        } else {
                                            phi_3873_ = lt_bvh_triangle_Intersection();
                                            phi_3874_ = true;
                                            phi_3875_ = false;
                                        }
                                        let _e3020 = phi_3873_;
                                        let _e3022 = phi_3874_;
                                        let _e3024 = phi_3875_;
                                        if _e3022 {
                                            phi_3879_ = true;
                                        } else {
                                            phi_3879_ = _e3024;
                                        }
                                        let _e3026 = phi_3879_;
                                        if _e3026 {
                                            phi_3883_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3883_ = _e3020;
                                        }
                                        let _e3028 = phi_3883_;
                                        if _e3028.is_hit {
                                            if (_e3028.t > 0f) {
                                                if (_e3028.t < _e161) {
                                                    let _e3035 = triangles.member[(0u + _e2580)].i0_;
                                                    if ((_e3035 & 2147483648u) == 0u) {
                                                        phi_4102_ = true;
                                                    } else {
                                                        if (_e2580 < _e93) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3044 = triangles.member[(0u + _e2580)].i0_;
                                                        let _e3045 = (_e3044 & 2147483647u);
                                                        let _e3047 = triangles.member[(0u + _e2580)].i1_;
                                                        let _e3049 = triangles.member[(0u + _e2580)].i2_;
                                                        if (_e3045 < _e109) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3053 = vertices.member[(0u + _e3045)];
                                                        if (_e3047 < _e109) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3057 = vertices.member[(0u + _e3047)];
                                                        if (_e3049 < _e109) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3061 = vertices.member[(0u + _e3049)];
                                                        let _e3062 = array<abi_Vertex, 3>(_e3053, _e3057, _e3061);
                                                        if (_e3062[0].material < _e112) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e3068 = materials.member[(0u + _e3062[0].material)];
                                                        if ((_e3068.flags & 1u) == 1u) {
                                                            let _e3073 = ((1f - _e3028.u) - _e3028.v);
                                                            if (_e3068.cutoff <= 0f) {
                                                                phi_4100_ = true;
                                                            } else {
                                                                let _e3100 = (_e3068.base_color.w * ((((f32((_e3062[0].color >> bitcast<u32>(24i))) * _e3073) + (f32((_e3062[1].color >> bitcast<u32>(24i))) * _e3028.u)) + (f32((_e3062[2].color >> bitcast<u32>(24i))) * _e3028.v)) * (1f / 255f)));
                                                                if (_e3068.alpha_size == 0u) {
                                                                    phi_4097_ = _e3100;
                                                                } else {
                                                                    local.offset = _e3068.alpha_offset;
                                                                    local.size = _e3068.alpha_size;
                                                                    local.flags = _e3068.flags;
                                                                    let _e3131 = _lt_shaders_texture_TextureView_quad((&local), (((_e3062[0].u * _e3073) + (_e3062[1].u * _e3028.u)) + (_e3062[2].u * _e3028.v)), (((_e3062[0].v * _e3073) + (_e3062[1].v * _e3028.u)) + (_e3062[2].v * _e3028.v)));
                                                                    let _e3135 = (_e3131.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3135 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3139 = alpha_texels.member[(0u + _e3135)];
                                                                    let _e3155 = (_e3131.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3155 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3159 = alpha_texels.member[(0u + _e3155)];
                                                                    let _e3176 = (_e3131.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3176 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3180 = alpha_texels.member[(0u + _e3176)];
                                                                    let _e3197 = (_e3131.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3197 < _e115) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3201 = alpha_texels.member[(0u + _e3197)];
                                                                    phi_4097_ = (_e3100 * (((((f32(((_e3139 >> bitcast<u32>((((_e3131.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3131.weights.x) + ((f32(((_e3159 >> bitcast<u32>((((_e3131.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3131.weights.y)) + ((f32(((_e3180 >> bitcast<u32>((((_e3131.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3131.weights.z)) + ((f32(((_e3201 >> bitcast<u32>((((_e3131.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3131.weights.w)));
                                                                }
                                                                let _e3217 = phi_4097_;
                                                                phi_4100_ = (_e3217 >= _e3068.cutoff);
                                                            }
                                                            let _e3221 = phi_4100_;
                                                            phi_4101_ = _e3221;
                                                        } else {
                                                            phi_4101_ = false;
                                                        }
                                                        let _e3223 = phi_4101_;
                                                        phi_4102_ = _e3223;
                                                    }
                                                    let _e3225 = phi_4102_;
                                                    if _e3225 {
                                                        phi_4106_ = false;
                                                    } else {
                                                        phi_4106_ = true;
                                                    }
                                                    let _e3227 = phi_4106_;
                                                    phi_4107_ = _e3225;
                                                    phi_4108_ = _e3225;
                                                    phi_4109_ = _e3227;
                                                } else {
                                                    phi_4107_ = bool();
                                                    phi_4108_ = _e2571;
                                                    phi_4109_ = true;
                                                }
                                                let _e3229 = phi_4107_;
                                                let _e3231 = phi_4108_;
                                                let _e3233 = phi_4109_;
                                                phi_4110_ = _e3229;
                                                phi_4111_ = _e3231;
                                                phi_4112_ = _e3233;
                                            } else {
                                                phi_4110_ = bool();
                                                phi_4111_ = _e2571;
                                                phi_4112_ = true;
                                            }
                                            let _e3235 = phi_4110_;
                                            let _e3237 = phi_4111_;
                                            let _e3239 = phi_4112_;
                                            phi_4113_ = _e3235;
                                            phi_4114_ = _e3237;
                                            phi_4115_ = _e3239;
                                        } else {
                                            phi_4113_ = bool();
                                            phi_4114_ = _e2571;
                                            phi_4115_ = true;
                                        }
                                        let _e3241 = phi_4113_;
                                        let _e3243 = phi_4114_;
                                        let _e3245 = phi_4115_;
                                        if _e3245 {
                                        }
                                        phi_3313_ = (_e2569 & (_e2569 - 1u));
                                        phi_3316_ = _e3243;
                                        phi_4119_ = _e3241;
                                        phi_4120_ = _e3245;
                                    }
                                    let _e3247 = phi_3313_;
                                    let _e3249 = phi_3316_;
                                    let _e3251 = phi_4119_;
                                    let _e3253 = phi_4120_;
                                    local_24 = _e3251;
                                    continue;
                                    continuing {
                                        phi_3312_ = _e3247;
                                        phi_3315_ = _e3249;
                                        break if !(_e3253);
                                    }
                                }
                                let _e3256 = local_13;
                                if _e3256 {
                                    let _e3258 = local_1.group_mask;
                                    if ((_e3258 & 4278190080u) == 0u) {
                                        let _e3262 = local_1.len;
                                        if (_e3262 == 0u) {
                                            phi_4162_ = false;
                                        } else {
                                            let _e3266 = local_1.len;
                                            local_1.len = (_e3266 - 1u);
                                            let _e3269 = local_1.len;
                                            if (_e3269 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3274 = local_1.first[(0u + _e3269)];
                                            local_1.group = _e3274;
                                            let _e3277 = local_1.len;
                                            if (_e3277 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3282 = local_1.mask[(0u + _e3277)];
                                            local_1.group_mask = _e3282;
                                            phi_4162_ = true;
                                        }
                                        let _e3285 = phi_4162_;
                                        phi_4163_ = _e3285;
                                    } else {
                                        phi_4163_ = true;
                                    }
                                    let _e3287 = phi_4163_;
                                    if _e3287 {
                                        let _e3289 = local_1.group_mask;
                                        let _e3295 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3289)), 32u, (_e3289 == 0u)));
                                        let _e3299 = local_1.group_mask;
                                        let _e3313 = local_1.group_mask;
                                        local_1.group_mask = (_e3313 & ~((1u << bitcast<u32>((_e3295 & 31u)))));
                                        let _e3316 = local_1.group;
                                        phi_4194_ = (_e3316 + countOneBits(((_e3299 & ~((4294967295u << bitcast<u32>((((_e3295 - 24u) ^ _e1993) & 31u))))) & 255u)));
                                    } else {
                                        phi_4194_ = 4294967295u;
                                    }
                                    let _e3319 = phi_4194_;
                                    phi_4195_ = _e3319;
                                } else {
                                    phi_4195_ = u32();
                                }
                                let _e3321 = phi_4195_;
                                phi_2981_ = _e3321;
                                let _e3871 = local_23;
                                phi_2984_ = _e3871;
                                let _e3874 = local_24;
                                phi_4196_ = _e3874;
                                let _e3877 = local_25;
                                phi_4197_ = _e3877;
                                phi_4198_ = false;
                            } else {
                                phi_2981_ = u32();
                                phi_2984_ = bool();
                                phi_4196_ = bool();
                                phi_4197_ = false;
                                phi_4198_ = true;
                            }
                            let _e3323 = phi_2981_;
                            let _e3325 = phi_2984_;
                            let _e3327 = phi_4196_;
                            let _e3329 = phi_4197_;
                            let _e3331 = phi_4198_;
                            local_14 = _e3331;
                            local_26 = _e3327;
                            continue;
                            continuing {
                                phi_2980_ = _e3323;
                                phi_2983_ = _e3325;
                                break if !(_e3329);
                            }
                        }
                        let _e3334 = local_14;
                        if _e3334 {
                            phi_4202_ = false;
                        } else {
                            phi_4202_ = true;
                        }
                        let _e3336 = phi_4202_;
                        if _e3336 {
                            let _e3883 = local_26;
                            phi_4206_ = _e3883;
                        } else {
                            let _e3885 = local_27;
                            phi_4206_ = _e3885;
                        }
                        let _e3338 = phi_4206_;
                        phi_4207_ = _e3338;
                    }
                    let _e3340 = phi_4207_;
                    phi_4208_ = _e3340;
                    phi_4209_ = _e1815;
                } else {
                    phi_4208_ = bool();
                    phi_4209_ = true;
                }
                let _e3342 = phi_4208_;
                let _e3344 = phi_4209_;
                if _e3344 {
                    phi_4213_ = false;
                } else {
                    phi_4213_ = _e3342;
                }
                let _e3346 = phi_4213_;
                phi_4214_ = _e3346;
            }
            let _e3348 = phi_4214_;
            phi_4215_ = _e3348;
        } else {
            phi_4215_ = false;
        }
        let _e3350 = phi_4215_;
        if _e3350 {
            phi_4219_ = 0f;
        } else {
            phi_4219_ = 1f;
        }
        let _e3352 = phi_4219_;
        if (_e128 < _e96) {
        } else {
            return;
        }
        visibility.member[(0u + _e128)] = _e3352;
        let _e3358 = p.member.light.number;
        let _e3359 = (_e3358 * 3u);
        let _e3360 = (_e3359 / 32u);
        let _e3361 = (_e3359 % 32u);
        let _e3363 = p.member.light.mask_words;
        if (_e128 < _e96) {
        } else {
            return;
        }
        let _e3367 = visibility.member[(0u + _e128)];
        let _e3369 = ((_e128 * _e3363) + _e3360);
        if (_e3361 > 29u) {
            let _e3371 = (_e3369 + 1u);
            if (_e3371 < _e102) {
            } else {
                return;
            }
            let _e3375 = bits.member[(0u + _e3371)];
            phi_4260_ = _e3375;
        } else {
            phi_4260_ = 0u;
        }
        let _e3377 = phi_4260_;
        if (_e3369 < _e102) {
        } else {
            return;
        }
        let _e3381 = bits.member[(0u + _e3369)];
        let _e3384 = (_e3381 >> bitcast<u32>((_e3361 & 31u)));
        if (_e3361 > 29u) {
            phi_4279_ = (_e3384 | (_e3377 << bitcast<u32>(((32u - _e3361) & 31u))));
        } else {
            phi_4279_ = _e3384;
        }
        let _e3392 = phi_4279_;
        if ((_e3392 & 2u) == 0u) {
            phi_4287_ = (_e3392 & 1u);
        } else {
            phi_4287_ = (_e3392 & 7u);
        }
        let _e3398 = phi_4287_;
        if ((_e3398 & 1u) != 0u) {
            phi_4295_ = (2u | 1u);
        } else {
            phi_4295_ = 2u;
        }
        let _e3404 = phi_4295_;
        if (_e3367 < 0.5f) {
            phi_4300_ = (_e3404 | 4u);
        } else {
            phi_4300_ = _e3404;
        }
        let _e3407 = phi_4300_;
        let _e3409 = ((_e128 * _e3363) + _e3360);
        if (_e3409 < _e102) {
        } else {
            return;
        }
        let _e3413 = bits.member[(0u + _e3409)];
        if (_e3409 < _e102) {
        } else {
            return;
        }
        bits.member[(0u + _e3409)] = ((_e3413 & ~((7u << bitcast<u32>((_e3361 & 31u))))) | (_e3407 << bitcast<u32>((_e3361 & 31u))));
        if (_e3361 > 29u) {
            let _e3427 = (_e3409 + 1u);
            if (_e3427 < _e102) {
            } else {
                return;
            }
            let _e3431 = bits.member[(0u + _e3427)];
            let _e3432 = (32u - _e3361);
            let _e3442 = (_e3409 + 1u);
            if (_e3442 < _e102) {
            } else {
                return;
            }
            bits.member[(0u + _e3442)] = ((_e3431 & ~((7u >> bitcast<u32>((_e3432 & 31u))))) | (_e3407 >> bitcast<u32>((_e3432 & 31u))));
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_learn_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
