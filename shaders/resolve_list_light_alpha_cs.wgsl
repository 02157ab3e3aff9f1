struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
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

struct lt_mask_LightPlace {
    word: u32,
    shift: u32,
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

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_44 {
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

struct type_48 {
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

struct lt_math_Evsm {
    positive_exponent: f32,
    negative_exponent: f32,
    min_variance: f32,
}

struct type_61 {
    member: array<vec4<u32>>,
}

struct lt_bvh_LightSpace {
    shear: vec3<f32>,
    axis: u32,
    middle: vec3<f32>,
    sign: f32,
    low: vec3<f32>,
    is_parallel: u32,
    high: vec3<f32>,
    pad: u32,
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

struct lt_bvh_LightNode {
    frame: vec4<u32>,
    x: vec4<u32>,
    y: vec4<u32>,
    rest: vec4<u32>,
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
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage> rows: type_61;
@group(0) @binding(7) 
var<uniform> space: type_64;
@group(0) @binding(8) 
var<storage> vertices: type_44;
@group(0) @binding(9) 
var<storage> materials: type_48;
@group(0) @binding(10) 
var<storage> alpha_texels: type_13;

fn core_intrinsics_maximum_number_nsz_f32_(param: f32, param_1: f32) -> f32 {
    var phi_222_: bool;
    var phi_226_: f32;

    if (param != param) {
        phi_222_ = true;
    } else {
        let _e81 = (param_1 >= param);
        if _e81 {
        }
        phi_222_ = _e81;
    }
    let _e83 = phi_222_;
    if _e83 {
        phi_226_ = param_1;
    } else {
        phi_226_ = param;
    }
    let _e85 = phi_226_;
    return _e85;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_2: f32, param_3: f32) -> f32 {
    var phi_238_: bool;
    var phi_242_: f32;

    if (param_2 != param_2) {
        phi_238_ = true;
    } else {
        let _e81 = (param_3 <= param_2);
        if _e81 {
        }
        phi_238_ = _e81;
    }
    let _e83 = phi_238_;
    if _e83 {
        phi_242_ = param_3;
    } else {
        phi_242_ = param_2;
    }
    let _e85 = phi_242_;
    return _e85;
}

fn _lt_shaders_texture_TextureView_quad(param_4: ptr<function, texture_TextureView>, param_5: f32, param_6: f32) -> texture_TexelQuad {
    var phi_284_: f32;
    var phi_289_: f32;
    var phi_290_: bool;
    var phi_291_: f32;
    var phi_292_: bool;
    var phi_296_: f32;
    var phi_322_: f32;
    var phi_327_: f32;
    var phi_328_: bool;
    var phi_329_: f32;
    var phi_330_: bool;
    var phi_334_: f32;
    var phi_342_: f32;
    var phi_343_: f32;
    var phi_344_: f32;
    var phi_353_: f32;
    var phi_354_: f32;
    var phi_372_: u32;
    var phi_386_: u32;
    var phi_393_: u32;
    var phi_398_: u32;
    var phi_404_: u32;
    var phi_409_: u32;
    var phi_411_: texture_Axis;
    var phi_439_: f32;
    var phi_444_: f32;
    var phi_445_: bool;
    var phi_446_: f32;
    var phi_447_: bool;
    var phi_451_: f32;
    var phi_477_: f32;
    var phi_482_: f32;
    var phi_483_: bool;
    var phi_484_: f32;
    var phi_485_: bool;
    var phi_489_: f32;
    var phi_497_: f32;
    var phi_498_: f32;
    var phi_499_: f32;
    var phi_508_: f32;
    var phi_509_: f32;
    var phi_527_: u32;
    var phi_541_: u32;
    var phi_548_: u32;
    var phi_553_: u32;
    var phi_559_: u32;
    var phi_564_: u32;
    var phi_566_: texture_Axis;

    let _e82 = (*param_4).size;
    let _e83 = (_e82 & 65535u);
    let _e85 = (*param_4).size;
    let _e87 = (_e85 >> bitcast<u32>(16i));
    let _e89 = (*param_4).flags;
    let _e91 = ((_e89 & 4u) != 0u);
    let _e93 = (*param_4).flags;
    let _e96 = ((_e93 >> bitcast<u32>(4u)) & 3u);
    if (_e96 == 0u) {
        if (param_5 > -8388608f) {
            let _e109 = f32(select(0i, select(select(i32(param_5), i32(-2147483648), (param_5 < bitcast<f32>(3472883712u))), 2147483647i, (param_5 > bitcast<f32>(1325400063u))), (param_5 == param_5)));
            if (_e109 > param_5) {
                phi_284_ = 1f;
            } else {
                phi_284_ = 0f;
            }
            let _e112 = phi_284_;
            if (param_5 < 8388608f) {
                phi_289_ = (_e109 - _e112);
                phi_290_ = false;
            } else {
                phi_289_ = f32();
                phi_290_ = true;
            }
            let _e115 = phi_289_;
            let _e117 = phi_290_;
            phi_291_ = _e115;
            phi_292_ = _e117;
        } else {
            phi_291_ = f32();
            phi_292_ = true;
        }
        let _e119 = phi_291_;
        let _e121 = phi_292_;
        if _e121 {
            phi_296_ = param_5;
        } else {
            phi_296_ = _e119;
        }
        let _e123 = phi_296_;
        phi_344_ = (param_5 - _e123);
    } else {
        if (_e96 == 1u) {
            let _e126 = (param_5 * 0.5f);
            if (_e126 > -8388608f) {
                let _e138 = f32(select(0i, select(select(i32(_e126), i32(-2147483648), (_e126 < bitcast<f32>(3472883712u))), 2147483647i, (_e126 > bitcast<f32>(1325400063u))), (_e126 == _e126)));
                if (_e138 > _e126) {
                    phi_322_ = 1f;
                } else {
                    phi_322_ = 0f;
                }
                let _e141 = phi_322_;
                if (_e126 < 8388608f) {
                    phi_327_ = (_e138 - _e141);
                    phi_328_ = false;
                } else {
                    phi_327_ = f32();
                    phi_328_ = true;
                }
                let _e144 = phi_327_;
                let _e146 = phi_328_;
                phi_329_ = _e144;
                phi_330_ = _e146;
            } else {
                phi_329_ = f32();
                phi_330_ = true;
            }
            let _e148 = phi_329_;
            let _e150 = phi_330_;
            if _e150 {
                phi_334_ = _e126;
            } else {
                phi_334_ = _e148;
            }
            let _e152 = phi_334_;
            let _e154 = (param_5 - (2f * _e152));
            if (_e154 > 1f) {
                phi_342_ = (2f - _e154);
            } else {
                phi_342_ = _e154;
            }
            let _e158 = phi_342_;
            phi_343_ = _e158;
        } else {
            phi_343_ = param_5;
        }
        let _e160 = phi_343_;
        phi_344_ = _e160;
    }
    let _e162 = phi_344_;
    if (_e162 > 0f) {
        if (_e162 < 1f) {
            phi_353_ = _e162;
        } else {
            phi_353_ = 1f;
        }
        let _e166 = phi_353_;
        phi_354_ = _e166;
    } else {
        phi_354_ = 0f;
    }
    let _e168 = phi_354_;
    let _e169 = (_e83 - 1u);
    let _e171 = (_e168 * f32(_e83));
    if _e91 {
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e169 < _e178) {
            phi_372_ = _e169;
        } else {
            phi_372_ = _e178;
        }
        let _e181 = phi_372_;
        phi_411_ = texture_Axis(_e181, _e181, 0f);
    } else {
        let _e183 = (_e171 + 0.5f);
        let _e190 = select(select(u32(_e183), 0u, (_e183 < bitcast<f32>(0u))), 4294967295u, (_e183 > bitcast<f32>(1333788671u)));
        if (_e83 < _e190) {
            phi_386_ = _e83;
        } else {
            phi_386_ = _e190;
        }
        let _e193 = phi_386_;
        if (_e96 == 0u) {
            phi_393_ = _e169;
        } else {
            phi_393_ = 0u;
        }
        let _e198 = phi_393_;
        if (_e96 == 0u) {
            phi_398_ = 0u;
        } else {
            phi_398_ = _e169;
        }
        let _e201 = phi_398_;
        if (_e193 == 0u) {
            phi_404_ = _e198;
        } else {
            phi_404_ = (_e193 - 1u);
        }
        let _e205 = phi_404_;
        if (_e193 > _e169) {
            phi_409_ = _e201;
        } else {
            phi_409_ = _e193;
        }
        let _e208 = phi_409_;
        phi_411_ = texture_Axis(_e205, _e208, (_e183 - f32(_e193)));
    }
    let _e211 = phi_411_;
    let _e213 = (*param_4).flags;
    let _e216 = ((_e213 >> bitcast<u32>(6u)) & 3u);
    if (_e216 == 0u) {
        if (param_6 > -8388608f) {
            let _e229 = f32(select(0i, select(select(i32(param_6), i32(-2147483648), (param_6 < bitcast<f32>(3472883712u))), 2147483647i, (param_6 > bitcast<f32>(1325400063u))), (param_6 == param_6)));
            if (_e229 > param_6) {
                phi_439_ = 1f;
            } else {
                phi_439_ = 0f;
            }
            let _e232 = phi_439_;
            if (param_6 < 8388608f) {
                phi_444_ = (_e229 - _e232);
                phi_445_ = false;
            } else {
                phi_444_ = f32();
                phi_445_ = true;
            }
            let _e235 = phi_444_;
            let _e237 = phi_445_;
            phi_446_ = _e235;
            phi_447_ = _e237;
        } else {
            phi_446_ = f32();
            phi_447_ = true;
        }
        let _e239 = phi_446_;
        let _e241 = phi_447_;
        if _e241 {
            phi_451_ = param_6;
        } else {
            phi_451_ = _e239;
        }
        let _e243 = phi_451_;
        phi_499_ = (param_6 - _e243);
    } else {
        if (_e216 == 1u) {
            let _e246 = (param_6 * 0.5f);
            if (_e246 > -8388608f) {
                let _e258 = f32(select(0i, select(select(i32(_e246), i32(-2147483648), (_e246 < bitcast<f32>(3472883712u))), 2147483647i, (_e246 > bitcast<f32>(1325400063u))), (_e246 == _e246)));
                if (_e258 > _e246) {
                    phi_477_ = 1f;
                } else {
                    phi_477_ = 0f;
                }
                let _e261 = phi_477_;
                if (_e246 < 8388608f) {
                    phi_482_ = (_e258 - _e261);
                    phi_483_ = false;
                } else {
                    phi_482_ = f32();
                    phi_483_ = true;
                }
                let _e264 = phi_482_;
                let _e266 = phi_483_;
                phi_484_ = _e264;
                phi_485_ = _e266;
            } else {
                phi_484_ = f32();
                phi_485_ = true;
            }
            let _e268 = phi_484_;
            let _e270 = phi_485_;
            if _e270 {
                phi_489_ = _e246;
            } else {
                phi_489_ = _e268;
            }
            let _e272 = phi_489_;
            let _e274 = (param_6 - (2f * _e272));
            if (_e274 > 1f) {
                phi_497_ = (2f - _e274);
            } else {
                phi_497_ = _e274;
            }
            let _e278 = phi_497_;
            phi_498_ = _e278;
        } else {
            phi_498_ = param_6;
        }
        let _e280 = phi_498_;
        phi_499_ = _e280;
    }
    let _e282 = phi_499_;
    if (_e282 > 0f) {
        if (_e282 < 1f) {
            phi_508_ = _e282;
        } else {
            phi_508_ = 1f;
        }
        let _e286 = phi_508_;
        phi_509_ = _e286;
    } else {
        phi_509_ = 0f;
    }
    let _e288 = phi_509_;
    let _e289 = (_e87 - 1u);
    let _e291 = (_e288 * f32(_e87));
    if _e91 {
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e289 < _e298) {
            phi_527_ = _e289;
        } else {
            phi_527_ = _e298;
        }
        let _e301 = phi_527_;
        phi_566_ = texture_Axis(_e301, _e301, 0f);
    } else {
        let _e303 = (_e291 + 0.5f);
        let _e310 = select(select(u32(_e303), 0u, (_e303 < bitcast<f32>(0u))), 4294967295u, (_e303 > bitcast<f32>(1333788671u)));
        if (_e87 < _e310) {
            phi_541_ = _e87;
        } else {
            phi_541_ = _e310;
        }
        let _e313 = phi_541_;
        if (_e216 == 0u) {
            phi_548_ = _e289;
        } else {
            phi_548_ = 0u;
        }
        let _e318 = phi_548_;
        if (_e216 == 0u) {
            phi_553_ = 0u;
        } else {
            phi_553_ = _e289;
        }
        let _e321 = phi_553_;
        if (_e313 == 0u) {
            phi_559_ = _e318;
        } else {
            phi_559_ = (_e313 - 1u);
        }
        let _e325 = phi_559_;
        if (_e313 > _e289) {
            phi_564_ = _e321;
        } else {
            phi_564_ = _e313;
        }
        let _e328 = phi_564_;
        phi_566_ = texture_Axis(_e325, _e328, (_e303 - f32(_e313)));
    }
    let _e331 = phi_566_;
    let _e335 = (*param_4).offset;
    let _e342 = (*param_4).offset;
    let _e349 = (*param_4).offset;
    let _e356 = (*param_4).offset;
    return texture_TexelQuad(array<u32, 4>(((_e335 + (_e331.low * _e83)) + _e211.low), ((_e342 + (_e331.low * _e83)) + _e211.high), ((_e349 + (_e331.high * _e83)) + _e211.low), ((_e356 + (_e331.high * _e83)) + _e211.high)), vec4<f32>(((1f - _e211.fraction) * (1f - _e331.fraction)), (_e211.fraction * (1f - _e331.fraction)), ((1f - _e211.fraction) * _e331.fraction), (_e211.fraction * _e331.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var local_2: texture_TextureView;
    var local_3: array<u32, 32>;
    var phi_715_: f32;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_768_: bool;
    var phi_769_: bool;
    var phi_770_: bool;
    var phi_771_: bool;
    var phi_775_: bool;
    var phi_788_: bool;
    var phi_789_: bool;
    var phi_790_: bool;
    var phi_794_: bool;
    var phi_795_: bool;
    var phi_796_: bool;
    var phi_797_: bool;
    var phi_798_: bool;
    var phi_802_: bool;
    var phi_825_: bool;
    var phi_826_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_834_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_853_: bool;
    var phi_870_: bool;
    var phi_871_: bool;
    var phi_872_: bool;
    var phi_873_: bool;
    var phi_874_: bool;
    var phi_875_: bool;
    var phi_876_: bool;
    var phi_880_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_909_: u32;
    var phi_910_: f32;
    var phi_911_: u32;
    var phi_912_: f32;
    var phi_917_: f32;
    var phi_928_: u32;
    var phi_938_: u32;
    var phi_944_: u32;
    var phi_945_: u32;
    var phi_946_: u32;
    var phi_957_: vec3<f32>;
    var phi_958_: vec3<f32>;
    var phi_980_: vec3<f32>;
    var phi_981_: vec3<f32>;
    var phi_1004_: u0028_lt_bvh_LightPoint_u0020_u32_u0029_;
    var phi_1072_: f32;
    var phi_1079_: f32;
    var phi_1086_: f32;
    var phi_1093_: f32;
    var phi_1100_: f32;
    var phi_1107_: f32;
    var phi_1124_: f32;
    var phi_1129_: f32;
    var phi_1134_: f32;
    var phi_1139_: f32;
    var phi_1144_: f32;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1175_: u32;
    var phi_1176_: u32;
    var phi_1187_: vec3<f32>;
    var phi_1188_: vec3<f32>;
    var phi_1200_: u32;
    var phi_1203_: u32;
    var phi_1272_: f32;
    var phi_1273_: f32;
    var phi_1287_: u32;
    var phi_1310_: f32;
    var phi_1311_: f32;
    var phi_1325_: u32;
    var phi_1348_: f32;
    var phi_1349_: f32;
    var phi_1363_: u32;
    var phi_1490_: u32;
    var phi_1530_: u32;
    var phi_1531_: u32;
    var phi_1537_: u32;
    var phi_1566_: vec3<f32>;
    var phi_1567_: vec3<f32>;
    var phi_1596_: vec3<f32>;
    var phi_1597_: vec3<f32>;
    var phi_1626_: vec3<f32>;
    var phi_1627_: vec3<f32>;
    var phi_1645_: bool;
    var phi_1646_: bool;
    var phi_1650_: f32;
    var phi_1651_: f32;
    var phi_1652_: f32;
    var phi_1653_: f32;
    var phi_1661_: f32;
    var phi_1671_: bool;
    var phi_1672_: bool;
    var phi_1676_: f32;
    var phi_1677_: f32;
    var phi_1678_: f32;
    var phi_1679_: f32;
    var phi_1687_: f32;
    var phi_1697_: bool;
    var phi_1698_: bool;
    var phi_1702_: f32;
    var phi_1703_: f32;
    var phi_1704_: f32;
    var phi_1705_: f32;
    var phi_1713_: f32;
    var phi_1728_: f32;
    var phi_1729_: bool;
    var phi_1730_: f32;
    var phi_1731_: bool;
    var phi_1732_: f32;
    var phi_1733_: bool;
    var phi_1751_: f32;
    var phi_1752_: bool;
    var phi_1753_: bool;
    var phi_1754_: f32;
    var phi_1755_: bool;
    var phi_1756_: bool;
    var phi_1760_: bool;
    var phi_1761_: f32;
    var phi_1762_: bool;
    var phi_1790_: vec3<f32>;
    var phi_1791_: vec3<f32>;
    var phi_1816_: vec3<f32>;
    var phi_1817_: vec3<f32>;
    var phi_1842_: vec3<f32>;
    var phi_1843_: vec3<f32>;
    var phi_1899_: f32;
    var phi_1908_: f32;
    var phi_1917_: f32;
    var phi_1926_: f32;
    var phi_1933_: f32;
    var phi_1940_: f32;
    var phi_1953_: f32;
    var phi_1962_: f32;
    var phi_1971_: f32;
    var phi_1980_: f32;
    var phi_1987_: f32;
    var phi_1994_: f32;
    var phi_2011_: f32;
    var phi_2016_: f32;
    var phi_2021_: f32;
    var phi_2029_: f32;
    var phi_2034_: f32;
    var phi_2039_: f32;
    var phi_2051_: f32;
    var phi_2056_: f32;
    var phi_2061_: f32;
    var phi_2066_: f32;
    var phi_2071_: lt_bvh_triangle_Intersection;
    var phi_2072_: bool;
    var phi_2073_: lt_bvh_triangle_Intersection;
    var phi_2074_: bool;
    var phi_2078_: lt_bvh_triangle_Intersection;
    var phi_2079_: bool;
    var phi_2080_: lt_bvh_triangle_Intersection;
    var phi_2081_: bool;
    var phi_2082_: bool;
    var phi_2086_: bool;
    var phi_2090_: lt_bvh_triangle_Intersection;
    var phi_2304_: f32;
    var phi_2307_: bool;
    var phi_2308_: bool;
    var phi_2312_: bool;
    var phi_2313_: bool;
    var phi_2314_: bool;
    var phi_2315_: bool;
    var phi_2316_: bool;
    var phi_2317_: bool;
    var phi_2318_: bool;
    var phi_2319_: bool;
    var phi_2320_: bool;
    var phi_2321_: bool;
    var phi_2322_: bool;
    var phi_2323_: bool;
    var phi_2324_: bool;
    var phi_2325_: bool;
    var phi_2329_: bool;
    var phi_2330_: bool;
    var phi_2331_: bool;
    var phi_2335_: bool;
    var phi_2336_: bool;
    var phi_1491_: u32;
    var phi_2337_: bool;
    var phi_2338_: bool;
    var phi_2339_: bool;
    var local_4: bool;
    var phi_2343_: bool;
    var phi_2344_: bool;
    var phi_2365_: u32;
    var phi_2366_: u32;
    var phi_2370_: u32;
    var phi_2371_: u32;
    var phi_2372_: u32;
    var phi_2373_: u32;
    var phi_2374_: bool;
    var phi_2375_: bool;
    var phi_2376_: bool;
    var phi_2397_: u32;
    var phi_2398_: u32;
    var phi_2399_: u32;
    var phi_2400_: u32;
    var phi_2401_: u32;
    var phi_2402_: u32;
    var phi_2403_: bool;
    var phi_2404_: bool;
    var phi_1201_: u32;
    var phi_1204_: u32;
    var phi_2405_: bool;
    var phi_2406_: bool;
    var phi_2407_: bool;
    var local_5: bool;
    var phi_2411_: bool;
    var phi_2412_: bool;
    var phi_2416_: bool;
    var phi_2420_: bool;
    var phi_2424_: bool;
    var phi_2425_: bool;
    var phi_2429_: bool;
    var phi_2445_: bool;
    var phi_2446_: bool;
    var phi_2447_: bool;
    var phi_2448_: bool;
    var phi_2452_: bool;
    var phi_2465_: bool;
    var phi_2466_: bool;
    var phi_2467_: bool;
    var phi_2468_: bool;
    var phi_2472_: bool;
    var phi_2485_: bool;
    var phi_2486_: bool;
    var phi_2487_: bool;
    var phi_2491_: bool;
    var phi_2492_: bool;
    var phi_2493_: bool;
    var phi_2494_: bool;
    var phi_2495_: bool;
    var phi_2499_: bool;
    var phi_2569_: f32;
    var phi_2576_: f32;
    var phi_2583_: f32;
    var phi_2590_: f32;
    var phi_2597_: f32;
    var phi_2604_: f32;
    var phi_2621_: f32;
    var phi_2626_: f32;
    var phi_2631_: f32;
    var phi_2636_: f32;
    var phi_2641_: f32;
    var phi_2667_: bool;
    var phi_2668_: bool;
    var phi_2676_: u32;
    var phi_2677_: u32;
    var phi_2688_: vec3<f32>;
    var phi_2689_: vec3<f32>;
    var phi_2702_: u32;
    var phi_2707_: u32;
    var phi_2712_: u32;
    var phi_2826_: bool;
    var phi_2827_: bool;
    var phi_2858_: u32;
    var phi_2860_: u32;
    var phi_2863_: bool;
    var phi_2943_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2970_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_2997_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_3003_: u32;
    var phi_3006_: u32;
    var phi_3020_: u32;
    var phi_3030_: u32;
    var phi_3040_: u32;
    var phi_3058_: u32;
    var phi_3068_: u32;
    var phi_3078_: u32;
    var phi_3114_: u32;
    var phi_3127_: u32;
    var phi_3132_: u32;
    var phi_3133_: u32;
    var phi_3134_: u32;
    var phi_3004_: u32;
    var phi_3007_: u32;
    var local_6: u32;
    var local_7: u32;
    var local_8: u32;
    var phi_3192_: u32;
    var phi_3195_: bool;
    var phi_3239_: vec3<f32>;
    var phi_3240_: vec3<f32>;
    var phi_3269_: vec3<f32>;
    var phi_3270_: vec3<f32>;
    var phi_3299_: vec3<f32>;
    var phi_3300_: vec3<f32>;
    var phi_3318_: bool;
    var phi_3319_: bool;
    var phi_3323_: f32;
    var phi_3324_: f32;
    var phi_3325_: f32;
    var phi_3326_: f32;
    var phi_3334_: f32;
    var phi_3344_: bool;
    var phi_3345_: bool;
    var phi_3349_: f32;
    var phi_3350_: f32;
    var phi_3351_: f32;
    var phi_3352_: f32;
    var phi_3360_: f32;
    var phi_3370_: bool;
    var phi_3371_: bool;
    var phi_3375_: f32;
    var phi_3376_: f32;
    var phi_3377_: f32;
    var phi_3378_: f32;
    var phi_3386_: f32;
    var phi_3401_: f32;
    var phi_3402_: bool;
    var phi_3403_: f32;
    var phi_3404_: bool;
    var phi_3405_: f32;
    var phi_3406_: bool;
    var phi_3424_: f32;
    var phi_3425_: bool;
    var phi_3426_: bool;
    var phi_3427_: f32;
    var phi_3428_: bool;
    var phi_3429_: bool;
    var phi_3433_: bool;
    var phi_3434_: f32;
    var phi_3435_: bool;
    var phi_3463_: vec3<f32>;
    var phi_3464_: vec3<f32>;
    var phi_3489_: vec3<f32>;
    var phi_3490_: vec3<f32>;
    var phi_3515_: vec3<f32>;
    var phi_3516_: vec3<f32>;
    var phi_3572_: f32;
    var phi_3581_: f32;
    var phi_3590_: f32;
    var phi_3599_: f32;
    var phi_3606_: f32;
    var phi_3613_: f32;
    var phi_3626_: f32;
    var phi_3635_: f32;
    var phi_3644_: f32;
    var phi_3653_: f32;
    var phi_3660_: f32;
    var phi_3667_: f32;
    var phi_3684_: f32;
    var phi_3689_: f32;
    var phi_3694_: f32;
    var phi_3702_: f32;
    var phi_3707_: f32;
    var phi_3712_: f32;
    var phi_3724_: f32;
    var phi_3729_: f32;
    var phi_3734_: f32;
    var phi_3739_: f32;
    var phi_3744_: lt_bvh_triangle_Intersection;
    var phi_3745_: bool;
    var phi_3746_: lt_bvh_triangle_Intersection;
    var phi_3747_: bool;
    var phi_3751_: lt_bvh_triangle_Intersection;
    var phi_3752_: bool;
    var phi_3753_: lt_bvh_triangle_Intersection;
    var phi_3754_: bool;
    var phi_3755_: bool;
    var phi_3759_: bool;
    var phi_3763_: lt_bvh_triangle_Intersection;
    var phi_3977_: f32;
    var phi_3980_: bool;
    var phi_3981_: bool;
    var phi_3982_: bool;
    var phi_3986_: bool;
    var phi_3987_: bool;
    var phi_3988_: bool;
    var phi_3989_: bool;
    var phi_3990_: bool;
    var phi_3991_: bool;
    var phi_3992_: bool;
    var phi_3993_: bool;
    var phi_3994_: bool;
    var phi_3995_: bool;
    var phi_3193_: u32;
    var phi_3196_: bool;
    var phi_3999_: bool;
    var phi_4000_: bool;
    var local_9: bool;
    var phi_4042_: bool;
    var phi_4043_: bool;
    var phi_4074_: u32;
    var phi_4075_: u32;
    var phi_2861_: u32;
    var phi_2864_: bool;
    var phi_4076_: bool;
    var phi_4077_: bool;
    var phi_4078_: bool;
    var local_10: bool;
    var phi_4082_: bool;
    var phi_4086_: bool;
    var phi_4087_: bool;
    var phi_4088_: bool;
    var phi_4089_: bool;
    var phi_4093_: bool;
    var phi_4094_: bool;
    var phi_4095_: bool;
    var phi_4099_: f32;
    var local_11: bool;
    var local_12: bool;
    var local_13: bool;
    var local_14: bool;
    var local_15: bool;
    var local_16: bool;
    var local_17: bool;
    var local_18: bool;
    var local_19: bool;
    var local_20: bool;

    let _e82 = id_1;
    let _e89 = arrayLength((&nodes.member));
    let _e92 = arrayLength((&triangles.member));
    let _e98 = arrayLength((&list.member));
    let _e101 = arrayLength((&rows.member));
    let _e105 = arrayLength((&vertices.member));
    let _e108 = arrayLength((&materials.member));
    let _e111 = arrayLength((&alpha_texels.member));
    let _e115 = ((_e82.y * 2097152u) + _e82.x);
    if (3u < _e98) {
    } else {
        return;
    }
    let _e118 = list.member[3u];
    if (_e115 < _e118) {
        let _e120 = (_e115 + 4u);
        if (_e120 < _e98) {
        } else {
            return;
        }
        let _e124 = list.member[(0u + _e120)];
        let _e125 = space.member;
        if (_e124 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e131 = samples.member[(0u + _e124)].position;
        let _e133 = samples.member[(0u + _e124)].normal;
        let _e135 = samples.member[(0u + _e124)].magnitude;
        let _e137 = ((8f / 8388608f) * _e135);
        let _e139 = (_e133.x * _e137);
        let _e141 = (_e133.y * _e137);
        let _e143 = (_e133.z * _e137);
        let _e145 = (_e131.x + _e139);
        let _e147 = (_e131.y + _e141);
        let _e149 = (_e131.z + _e143);
        let _e153 = p.member.light.place;
        if (_e153.w == 0f) {
            phi_715_ = 300000000000000000000000000000000000000f;
        } else {
            phi_715_ = 1f;
        }
        let _e157 = phi_715_;
        let _e165 = (_e153.x - (_e145 * _e153.w));
        let _e166 = (_e153.y - (_e147 * _e153.w));
        let _e167 = (_e153.z - (_e149 * _e153.w));
        let _e168 = vec3<f32>(_e165, _e166, _e167);
        let _e169 = abs(_e165);
        let _e170 = abs(_e166);
        let _e171 = abs(_e167);
        if (abs(_e145) < 1000000000000000f) {
            if (abs(_e147) < 1000000000000000f) {
                phi_748_ = (abs(_e149) < 1000000000000000f);
                phi_749_ = false;
            } else {
                phi_748_ = bool();
                phi_749_ = true;
            }
            let _e179 = phi_748_;
            let _e181 = phi_749_;
            phi_750_ = _e179;
            phi_751_ = _e181;
        } else {
            phi_750_ = bool();
            phi_751_ = true;
        }
        let _e183 = phi_750_;
        let _e185 = phi_751_;
        if _e185 {
            phi_755_ = false;
        } else {
            phi_755_ = _e183;
        }
        let _e187 = phi_755_;
        if _e187 {
            if (_e169 < 1000000000000000f) {
                if (_e170 < 1000000000000000f) {
                    phi_768_ = (_e171 < 1000000000000000f);
                    phi_769_ = false;
                } else {
                    phi_768_ = bool();
                    phi_769_ = true;
                }
                let _e192 = phi_768_;
                let _e194 = phi_769_;
                phi_770_ = _e192;
                phi_771_ = _e194;
            } else {
                phi_770_ = bool();
                phi_771_ = true;
            }
            let _e196 = phi_770_;
            let _e198 = phi_771_;
            if _e198 {
                phi_775_ = false;
            } else {
                phi_775_ = _e196;
            }
            let _e200 = phi_775_;
            if _e200 {
                if (_e169 > 0f) {
                    phi_789_ = bool();
                    phi_790_ = true;
                } else {
                    let _e202 = (_e170 > 0f);
                    if _e202 {
                        phi_788_ = bool();
                    } else {
                        phi_788_ = (_e171 > 0f);
                    }
                    let _e205 = phi_788_;
                    phi_789_ = _e205;
                    phi_790_ = _e202;
                }
                let _e207 = phi_789_;
                let _e209 = phi_790_;
                if _e209 {
                    phi_794_ = true;
                } else {
                    phi_794_ = _e207;
                }
                let _e211 = phi_794_;
                phi_795_ = _e211;
                phi_796_ = false;
            } else {
                phi_795_ = bool();
                phi_796_ = true;
            }
            let _e213 = phi_795_;
            let _e215 = phi_796_;
            phi_797_ = _e213;
            phi_798_ = _e215;
        } else {
            phi_797_ = bool();
            phi_798_ = true;
        }
        let _e217 = phi_797_;
        let _e219 = phi_798_;
        if _e219 {
            phi_802_ = false;
        } else {
            phi_802_ = _e217;
        }
        let _e221 = phi_802_;
        if _e221 {
            if (_e125.low.x <= _e145) {
                if (_e145 <= _e125.high.x) {
                    if (_e125.low.y <= _e147) {
                        phi_825_ = (_e147 <= _e125.high.y);
                        phi_826_ = false;
                    } else {
                        phi_825_ = bool();
                        phi_826_ = true;
                    }
                    let _e239 = phi_825_;
                    let _e241 = phi_826_;
                    phi_827_ = _e239;
                    phi_828_ = _e241;
                } else {
                    phi_827_ = bool();
                    phi_828_ = true;
                }
                let _e243 = phi_827_;
                let _e245 = phi_828_;
                phi_829_ = _e243;
                phi_830_ = _e245;
            } else {
                phi_829_ = bool();
                phi_830_ = true;
            }
            let _e247 = phi_829_;
            let _e249 = phi_830_;
            if _e249 {
                phi_834_ = false;
            } else {
                phi_834_ = _e247;
            }
            let _e251 = phi_834_;
            if (abs(_e165) > 0.000000000000000000000000000001f) {
                phi_848_ = bool();
                phi_849_ = true;
            } else {
                let _e256 = (abs(_e166) > 0.000000000000000000000000000001f);
                if _e256 {
                    phi_847_ = bool();
                } else {
                    phi_847_ = (abs(_e167) > 0.000000000000000000000000000001f);
                }
                let _e259 = phi_847_;
                phi_848_ = _e259;
                phi_849_ = _e256;
            }
            let _e261 = phi_848_;
            let _e263 = phi_849_;
            if _e263 {
                phi_853_ = true;
            } else {
                phi_853_ = _e261;
            }
            let _e265 = phi_853_;
            if _e251 {
                if (_e125.low.z <= _e149) {
                    if (_e149 <= _e125.high.z) {
                        if (_e125.is_parallel == 0u) {
                            phi_870_ = _e265;
                        } else {
                            phi_870_ = true;
                        }
                        let _e271 = phi_870_;
                        phi_871_ = _e271;
                        phi_872_ = false;
                    } else {
                        phi_871_ = bool();
                        phi_872_ = true;
                    }
                    let _e273 = phi_871_;
                    let _e275 = phi_872_;
                    phi_873_ = _e273;
                    phi_874_ = _e275;
                } else {
                    phi_873_ = bool();
                    phi_874_ = true;
                }
                let _e277 = phi_873_;
                let _e279 = phi_874_;
                phi_875_ = _e277;
                phi_876_ = _e279;
            } else {
                phi_875_ = bool();
                phi_876_ = true;
            }
            let _e281 = phi_875_;
            let _e283 = phi_876_;
            if _e283 {
                phi_880_ = false;
            } else {
                phi_880_ = _e281;
            }
            let _e285 = phi_880_;
            if _e285 {
                if (_e125.is_parallel == 0u) {
                    let _e288 = abs(_e165);
                    let _e289 = abs(_e166);
                    let _e290 = abs(_e167);
                    if (_e288 >= _e289) {
                        if (_e288 >= _e290) {
                            phi_900_ = false;
                        } else {
                            phi_900_ = true;
                        }
                        let _e294 = phi_900_;
                        phi_901_ = _e294;
                    } else {
                        phi_901_ = true;
                    }
                    let _e296 = phi_901_;
                    if _e296 {
                        if (_e289 >= _e290) {
                            phi_909_ = 1u;
                            phi_910_ = _e166;
                        } else {
                            phi_909_ = 2u;
                            phi_910_ = _e167;
                        }
                        let _e299 = phi_909_;
                        let _e301 = phi_910_;
                        phi_911_ = _e299;
                        phi_912_ = _e301;
                    } else {
                        phi_911_ = 0u;
                        phi_912_ = _e165;
                    }
                    let _e303 = phi_911_;
                    let _e305 = phi_912_;
                    if (_e305 < 0f) {
                        phi_917_ = -1f;
                    } else {
                        phi_917_ = 1f;
                    }
                    let _e308 = phi_917_;
                    let _e309 = (_e308 < 0f);
                    if (_e303 == 0u) {
                        if _e309 {
                            phi_928_ = _e125.roots.y;
                        } else {
                            phi_928_ = _e125.roots.x;
                        }
                        let _e316 = phi_928_;
                        phi_946_ = _e316;
                    } else {
                        if (_e303 == 1u) {
                            if _e309 {
                                phi_938_ = _e125.roots.w;
                            } else {
                                phi_938_ = _e125.roots.z;
                            }
                            let _e323 = phi_938_;
                            phi_945_ = _e323;
                        } else {
                            if _e309 {
                                phi_944_ = _e125.roots_z.y;
                            } else {
                                phi_944_ = _e125.roots_z.x;
                            }
                            let _e329 = phi_944_;
                            phi_945_ = _e329;
                        }
                        let _e331 = phi_945_;
                        phi_946_ = _e331;
                    }
                    let _e333 = phi_946_;
                    if (_e303 == 0u) {
                        phi_958_ = vec3<f32>(_e166, _e167, _e165);
                    } else {
                        if (_e303 == 1u) {
                            phi_957_ = vec3<f32>(_e167, _e165, _e166);
                        } else {
                            phi_957_ = _e168;
                        }
                        let _e339 = phi_957_;
                        phi_958_ = _e339;
                    }
                    let _e341 = phi_958_;
                    phi_1004_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm((_e341.x / _e341.z), (_e341.y / _e341.z), (_e308 / _e341.z)), _e333);
                } else {
                    if (_e125.axis == 0u) {
                        phi_981_ = vec3<f32>(_e147, _e149, _e145);
                    } else {
                        if (_e125.axis == 1u) {
                            phi_980_ = vec3<f32>(_e149, _e145, _e147);
                        } else {
                            phi_980_ = (_e131 + vec3<f32>(_e139, _e141, _e143));
                        }
                        let _e358 = phi_980_;
                        phi_981_ = _e358;
                    }
                    let _e360 = phi_981_;
                    let _e372 = (_e360.z - _e125.middle.z);
                    phi_1004_ = u0028_lt_bvh_LightPoint_u0020_u32_u0029_(lt_math_Evsm(((_e360.x - _e125.middle.x) - (_e125.shear.x * _e372)), ((_e360.y - _e125.middle.y) - (_e125.shear.y * _e372)), (_e125.sign * _e372)), _e125.roots.x);
                }
                let _e385 = phi_1004_;
                if (_e385.unnamed_1 == 4294967295u) {
                    phi_2424_ = false;
                    phi_2425_ = true;
                } else {
                    if (0u < _e89) {
                    } else {
                        return;
                    }
                    let _e393 = nodes.member[0u].frame[0u];
                    let _e397 = nodes.member[0u].frame[1u];
                    let _e401 = nodes.member[0u].frame[2u];
                    let _e405 = nodes.member[0u].frame[0u];
                    let _e409 = nodes.member[0u].frame[1u];
                    let _e413 = nodes.member[0u].frame[2u];
                    let _e417 = nodes.member[0u].frame[3u];
                    let _e451 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165), abs(_e166));
                    let _e452 = core_intrinsics_maximum_number_nsz_f32_(_e451, abs(_e167));
                    let _e453 = (_e452 * 0.0000000000009094947f);
                    if (abs(_e165) < _e453) {
                        phi_1072_ = _e453;
                    } else {
                        phi_1072_ = abs(_e165);
                    }
                    let _e458 = phi_1072_;
                    if (_e165 < 0f) {
                        phi_1079_ = (-1f / _e458);
                    } else {
                        phi_1079_ = (1f / _e458);
                    }
                    let _e463 = phi_1079_;
                    if (abs(_e166) < _e453) {
                        phi_1086_ = _e453;
                    } else {
                        phi_1086_ = abs(_e166);
                    }
                    let _e468 = phi_1086_;
                    if (_e166 < 0f) {
                        phi_1093_ = (-1f / _e468);
                    } else {
                        phi_1093_ = (1f / _e468);
                    }
                    let _e473 = phi_1093_;
                    if (abs(_e167) < _e453) {
                        phi_1100_ = _e453;
                    } else {
                        phi_1100_ = abs(_e167);
                    }
                    let _e478 = phi_1100_;
                    if (_e167 < 0f) {
                        phi_1107_ = (-1f / _e478);
                    } else {
                        phi_1107_ = (1f / _e478);
                    }
                    let _e483 = phi_1107_;
                    let _e487 = abs((bitcast<f32>(_e393) - _e145));
                    let _e488 = abs((bitcast<f32>(_e397) - _e147));
                    let _e489 = abs((bitcast<f32>(_e401) - _e149));
                    let _e493 = abs(((bitcast<f32>(_e405) + (bitcast<f32>((((_e417 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145));
                    let _e494 = abs(((bitcast<f32>(_e409) + (bitcast<f32>((((_e417 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147));
                    let _e495 = abs(((bitcast<f32>(_e413) + (bitcast<f32>((((_e417 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                    if (_e487 > _e493) {
                        phi_1124_ = _e487;
                    } else {
                        phi_1124_ = _e493;
                    }
                    let _e498 = phi_1124_;
                    if (_e488 > _e494) {
                        phi_1129_ = _e488;
                    } else {
                        phi_1129_ = _e494;
                    }
                    let _e501 = phi_1129_;
                    if (_e489 > _e495) {
                        phi_1134_ = _e489;
                    } else {
                        phi_1134_ = _e495;
                    }
                    let _e504 = phi_1134_;
                    if (_e498 > _e501) {
                        phi_1139_ = _e498;
                    } else {
                        phi_1139_ = _e501;
                    }
                    let _e507 = phi_1139_;
                    if (_e507 > _e504) {
                        phi_1144_ = _e507;
                    } else {
                        phi_1144_ = _e504;
                    }
                    let _e510 = phi_1144_;
                    let _e517 = (_e510 * 0.0000009536743f);
                    let _e518 = (abs(_e463) * _e517);
                    let _e519 = (abs(_e473) * _e517);
                    let _e520 = (abs(_e483) * _e517);
                    let _e521 = abs(_e165);
                    let _e522 = abs(_e166);
                    let _e523 = abs(_e167);
                    if (_e521 >= _e522) {
                        if (_e521 >= _e523) {
                            phi_1166_ = false;
                        } else {
                            phi_1166_ = true;
                        }
                        let _e527 = phi_1166_;
                        phi_1167_ = _e527;
                    } else {
                        phi_1167_ = true;
                    }
                    let _e529 = phi_1167_;
                    if _e529 {
                        if (_e522 >= _e523) {
                            phi_1175_ = 1u;
                        } else {
                            phi_1175_ = 2u;
                        }
                        let _e532 = phi_1175_;
                        phi_1176_ = _e532;
                    } else {
                        phi_1176_ = 0u;
                    }
                    let _e534 = phi_1176_;
                    if (_e534 == 0u) {
                        phi_1188_ = vec3<f32>(_e166, _e167, _e165);
                    } else {
                        if (_e534 == 1u) {
                            phi_1187_ = vec3<f32>(_e167, _e165, _e166);
                        } else {
                            phi_1187_ = _e168;
                        }
                        let _e540 = phi_1187_;
                        phi_1188_ = _e540;
                    }
                    let _e542 = phi_1188_;
                    let _e545 = (_e542.x / _e542.z);
                    let _e548 = (_e542.y / _e542.z);
                    local_3 = array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    phi_1200_ = ((_e385.unnamed_1 << bitcast<u32>(8i)) | 1u);
                    phi_1203_ = 0u;
                    loop {
                        let _e555 = phi_1200_;
                        let _e557 = phi_1203_;
                        let _e558 = (_e555 == 0u);
                        local_5 = _e558;
                        if _e558 {
                            phi_1201_ = u32();
                            phi_1204_ = u32();
                            phi_2405_ = false;
                            phi_2406_ = false;
                            phi_2407_ = false;
                        } else {
                            let _e566 = (_e555 & (_e555 - 1u));
                            let _e567 = (((_e555 >> bitcast<u32>(8i)) + select(firstTrailingBit(_e555), 32u, (_e555 == 0u))) * 4u);
                            if (_e567 < _e101) {
                            } else {
                                return;
                            }
                            let _e571 = rows.member[(0u + _e567)];
                            let _e572 = (_e567 + 1u);
                            if (_e572 < _e101) {
                            } else {
                                return;
                            }
                            let _e576 = rows.member[(0u + _e572)];
                            let _e577 = (_e567 + 2u);
                            if (_e577 < _e101) {
                            } else {
                                return;
                            }
                            let _e581 = rows.member[(0u + _e577)];
                            let _e582 = (_e567 + 3u);
                            if (_e582 < _e101) {
                            } else {
                                return;
                            }
                            let _e586 = rows.member[(0u + _e582)];
                            let _e587 = lt_bvh_LightNode(_e571, _e576, _e581, _e586);
                            let _e599 = (_e385.unnamed.positive_exponent - bitcast<f32>(_e587.frame.x));
                            let _e602 = bitcast<f32>((((_e587.frame.w >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e599 > 0f) {
                                if (_e599 < (255f * _e602)) {
                                    phi_1272_ = (_e599 / _e602);
                                } else {
                                    phi_1272_ = 255f;
                                }
                                let _e608 = phi_1272_;
                                phi_1273_ = _e608;
                            } else {
                                phi_1273_ = 0f;
                            }
                            let _e610 = phi_1273_;
                            let _e617 = select(select(u32(_e610), 0u, (_e610 < bitcast<f32>(0u))), 4294967295u, (_e610 > bitcast<f32>(1333788671u)));
                            if (f32(_e617) < _e610) {
                                phi_1287_ = (_e617 + 1u);
                            } else {
                                phi_1287_ = _e617;
                            }
                            let _e622 = phi_1287_;
                            let _e623 = (_e617 * 16843009u);
                            let _e624 = (_e622 * 16843009u);
                            let _e634 = (_e385.unnamed.negative_exponent - bitcast<f32>(_e587.frame.y));
                            let _e637 = bitcast<f32>((((_e587.frame.w >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e634 > 0f) {
                                if (_e634 < (255f * _e637)) {
                                    phi_1310_ = (_e634 / _e637);
                                } else {
                                    phi_1310_ = 255f;
                                }
                                let _e643 = phi_1310_;
                                phi_1311_ = _e643;
                            } else {
                                phi_1311_ = 0f;
                            }
                            let _e645 = phi_1311_;
                            let _e652 = select(select(u32(_e645), 0u, (_e645 < bitcast<f32>(0u))), 4294967295u, (_e645 > bitcast<f32>(1333788671u)));
                            if (f32(_e652) < _e645) {
                                phi_1325_ = (_e652 + 1u);
                            } else {
                                phi_1325_ = _e652;
                            }
                            let _e657 = phi_1325_;
                            let _e658 = (_e652 * 16843009u);
                            let _e659 = (_e657 * 16843009u);
                            let _e669 = (_e385.unnamed.min_variance - bitcast<f32>(_e587.frame.z));
                            let _e672 = bitcast<f32>((((_e587.frame.w >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i)));
                            if (_e669 > 0f) {
                                if (_e669 < (255f * _e672)) {
                                    phi_1348_ = (_e669 / _e672);
                                } else {
                                    phi_1348_ = 255f;
                                }
                                let _e678 = phi_1348_;
                                phi_1349_ = _e678;
                            } else {
                                phi_1349_ = 0f;
                            }
                            let _e680 = phi_1349_;
                            let _e687 = select(select(u32(_e680), 0u, (_e680 < bitcast<f32>(0u))), 4294967295u, (_e680 > bitcast<f32>(1333788671u)));
                            if (f32(_e687) < _e680) {
                                phi_1363_ = (_e687 + 1u);
                            } else {
                                phi_1363_ = _e687;
                            }
                            let _e692 = phi_1363_;
                            let _e693 = (_e692 * 16843009u);
                            let _e826 = (((((((((((_e623 & ~(_e587.x.x)) | (~((_e587.x.x ^ _e623)) & ((_e623 | 2155905152u) - (_e587.x.x & 2139062143u)))) & ((_e587.x.z & ~(_e624)) | (~((_e624 ^ _e587.x.z)) & ((_e587.x.z | 2155905152u) - (_e624 & 2139062143u))))) & ((_e658 & ~(_e587.y.x)) | (~((_e587.y.x ^ _e658)) & ((_e658 | 2155905152u) - (_e587.y.x & 2139062143u))))) & ((_e587.y.z & ~(_e659)) | (~((_e659 ^ _e587.y.z)) & ((_e587.y.z | 2155905152u) - (_e659 & 2139062143u))))) & ((_e587.rest.x & ~(_e693)) | (~((_e693 ^ _e587.rest.x)) & ((_e587.rest.x | 2155905152u) - (_e693 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) | (((((((((((_e623 & ~(_e587.x.y)) | (~((_e587.x.y ^ _e623)) & ((_e623 | 2155905152u) - (_e587.x.y & 2139062143u)))) & ((_e587.x.w & ~(_e624)) | (~((_e624 ^ _e587.x.w)) & ((_e587.x.w | 2155905152u) - (_e624 & 2139062143u))))) & ((_e658 & ~(_e587.y.y)) | (~((_e587.y.y ^ _e658)) & ((_e658 | 2155905152u) - (_e587.y.y & 2139062143u))))) & ((_e587.y.w & ~(_e659)) | (~((_e659 ^ _e587.y.w)) & ((_e587.y.w | 2155905152u) - (_e659 & 2139062143u))))) & ((_e587.rest.y & ~(_e693)) | (~((_e693 ^ _e587.rest.y)) & ((_e587.rest.y | 2155905152u) - (_e693 & 2139062143u))))) & 2155905152u) >> bitcast<u32>(7i)) * 16909320u) >> bitcast<u32>(24i)) << bitcast<u32>(4i)));
                            if ((_e587.frame.w & 16777216u) != 0u) {
                                phi_1490_ = _e826;
                                loop {
                                    let _e832 = phi_1490_;
                                    let _e833 = (_e832 == 0u);
                                    local_4 = _e833;
                                    local_13 = _e833;
                                    if _e833 {
                                        phi_1491_ = u32();
                                        phi_2337_ = false;
                                        phi_2338_ = false;
                                        phi_2339_ = false;
                                    } else {
                                        let _e836 = select(firstTrailingBit(_e832), 32u, (_e832 == 0u));
                                        let _e841 = (_e587.rest.z + (_e836 >> bitcast<u32>(2i)));
                                        if (_e841 < _e101) {
                                        } else {
                                            return;
                                        }
                                        let _e846 = rows.member[(0u + _e841)][0u];
                                        let _e850 = rows.member[(0u + _e841)][1u];
                                        let _e854 = rows.member[(0u + _e841)][2u];
                                        let _e858 = rows.member[(0u + _e841)][3u];
                                        if ((_e836 & 2u) == 0u) {
                                            phi_1530_ = _e850;
                                            phi_1531_ = _e846;
                                        } else {
                                            phi_1530_ = _e858;
                                            phi_1531_ = _e854;
                                        }
                                        let _e862 = phi_1530_;
                                        let _e864 = phi_1531_;
                                        if ((_e836 & 1u) == 0u) {
                                            phi_1537_ = _e864;
                                        } else {
                                            phi_1537_ = _e862;
                                        }
                                        let _e868 = phi_1537_;
                                        if (_e868 < _e92) {
                                        } else {
                                            return;
                                        }
                                        let _e875 = triangles.member[(0u + _e868)].v0_;
                                        let _e877 = (_e875.x - _e145);
                                        let _e879 = (_e875.y - _e147);
                                        let _e881 = (_e875.z - _e149);
                                        if (_e534 == 0u) {
                                            phi_1567_ = vec3<f32>(_e879, _e881, _e877);
                                        } else {
                                            if (_e534 == 1u) {
                                                phi_1566_ = vec3<f32>(_e881, _e877, _e879);
                                            } else {
                                                phi_1566_ = (_e875 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e889 = phi_1566_;
                                            phi_1567_ = _e889;
                                        }
                                        let _e891 = phi_1567_;
                                        let _e895 = (_e891.x - (_e545 * _e891.z));
                                        let _e899 = (_e891.y - (_e548 * _e891.z));
                                        let _e901 = triangles.member[(0u + _e868)].v1_;
                                        let _e903 = (_e901.x - _e145);
                                        let _e905 = (_e901.y - _e147);
                                        let _e907 = (_e901.z - _e149);
                                        if (_e534 == 0u) {
                                            phi_1597_ = vec3<f32>(_e905, _e907, _e903);
                                        } else {
                                            if (_e534 == 1u) {
                                                phi_1596_ = vec3<f32>(_e907, _e903, _e905);
                                            } else {
                                                phi_1596_ = (_e901 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e915 = phi_1596_;
                                            phi_1597_ = _e915;
                                        }
                                        let _e917 = phi_1597_;
                                        let _e921 = (_e917.x - (_e545 * _e917.z));
                                        let _e925 = (_e917.y - (_e548 * _e917.z));
                                        let _e927 = triangles.member[(0u + _e868)].v2_;
                                        let _e929 = (_e927.x - _e145);
                                        let _e931 = (_e927.y - _e147);
                                        let _e933 = (_e927.z - _e149);
                                        if (_e534 == 0u) {
                                            phi_1627_ = vec3<f32>(_e931, _e933, _e929);
                                        } else {
                                            if (_e534 == 1u) {
                                                phi_1626_ = vec3<f32>(_e933, _e929, _e931);
                                            } else {
                                                phi_1626_ = (_e927 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e941 = phi_1626_;
                                            phi_1627_ = _e941;
                                        }
                                        let _e943 = phi_1627_;
                                        let _e947 = (_e943.x - (_e545 * _e943.z));
                                        let _e951 = (_e943.y - (_e548 * _e943.z));
                                        if (_e921 < _e947) {
                                            phi_1646_ = true;
                                        } else {
                                            if (_e921 == _e947) {
                                                phi_1645_ = (_e925 < _e951);
                                            } else {
                                                phi_1645_ = false;
                                            }
                                            let _e956 = phi_1645_;
                                            phi_1646_ = _e956;
                                        }
                                        let _e958 = phi_1646_;
                                        if _e958 {
                                            phi_1650_ = _e951;
                                            phi_1651_ = _e947;
                                            phi_1652_ = _e925;
                                            phi_1653_ = _e921;
                                        } else {
                                            phi_1650_ = _e925;
                                            phi_1651_ = _e921;
                                            phi_1652_ = _e951;
                                            phi_1653_ = _e947;
                                        }
                                        let _e960 = phi_1650_;
                                        let _e962 = phi_1651_;
                                        let _e964 = phi_1652_;
                                        let _e966 = phi_1653_;
                                        let _e969 = ((_e966 * _e960) - (_e964 * _e962));
                                        if _e958 {
                                            phi_1661_ = -(_e969);
                                        } else {
                                            phi_1661_ = _e969;
                                        }
                                        let _e972 = phi_1661_;
                                        if (_e947 < _e895) {
                                            phi_1672_ = true;
                                        } else {
                                            if (_e947 == _e895) {
                                                phi_1671_ = (_e951 < _e899);
                                            } else {
                                                phi_1671_ = false;
                                            }
                                            let _e977 = phi_1671_;
                                            phi_1672_ = _e977;
                                        }
                                        let _e979 = phi_1672_;
                                        if _e979 {
                                            phi_1676_ = _e899;
                                            phi_1677_ = _e895;
                                            phi_1678_ = _e951;
                                            phi_1679_ = _e947;
                                        } else {
                                            phi_1676_ = _e951;
                                            phi_1677_ = _e947;
                                            phi_1678_ = _e899;
                                            phi_1679_ = _e895;
                                        }
                                        let _e981 = phi_1676_;
                                        let _e983 = phi_1677_;
                                        let _e985 = phi_1678_;
                                        let _e987 = phi_1679_;
                                        let _e990 = ((_e987 * _e981) - (_e985 * _e983));
                                        if _e979 {
                                            phi_1687_ = -(_e990);
                                        } else {
                                            phi_1687_ = _e990;
                                        }
                                        let _e993 = phi_1687_;
                                        if (_e895 < _e921) {
                                            phi_1698_ = true;
                                        } else {
                                            if (_e895 == _e921) {
                                                phi_1697_ = (_e899 < _e925);
                                            } else {
                                                phi_1697_ = false;
                                            }
                                            let _e998 = phi_1697_;
                                            phi_1698_ = _e998;
                                        }
                                        let _e1000 = phi_1698_;
                                        if _e1000 {
                                            phi_1702_ = _e925;
                                            phi_1703_ = _e921;
                                            phi_1704_ = _e899;
                                            phi_1705_ = _e895;
                                        } else {
                                            phi_1702_ = _e899;
                                            phi_1703_ = _e895;
                                            phi_1704_ = _e925;
                                            phi_1705_ = _e921;
                                        }
                                        let _e1002 = phi_1702_;
                                        let _e1004 = phi_1703_;
                                        let _e1006 = phi_1704_;
                                        let _e1008 = phi_1705_;
                                        let _e1011 = ((_e1008 * _e1002) - (_e1006 * _e1004));
                                        if _e1000 {
                                            phi_1713_ = -(_e1011);
                                        } else {
                                            phi_1713_ = _e1011;
                                        }
                                        let _e1014 = phi_1713_;
                                        if (_e972 >= 0f) {
                                            if (_e993 >= 0f) {
                                                if (_e1014 >= 0f) {
                                                    phi_1728_ = ((_e972 + _e993) + _e1014);
                                                    phi_1729_ = false;
                                                } else {
                                                    phi_1728_ = f32();
                                                    phi_1729_ = true;
                                                }
                                                let _e1021 = phi_1728_;
                                                let _e1023 = phi_1729_;
                                                phi_1730_ = _e1021;
                                                phi_1731_ = _e1023;
                                            } else {
                                                phi_1730_ = f32();
                                                phi_1731_ = true;
                                            }
                                            let _e1025 = phi_1730_;
                                            let _e1027 = phi_1731_;
                                            phi_1732_ = _e1025;
                                            phi_1733_ = _e1027;
                                        } else {
                                            phi_1732_ = f32();
                                            phi_1733_ = true;
                                        }
                                        let _e1029 = phi_1732_;
                                        let _e1031 = phi_1733_;
                                        if _e1031 {
                                            if (_e972 <= 0f) {
                                                if (_e993 <= 0f) {
                                                    let _e1034 = (_e1014 <= 0f);
                                                    if _e1034 {
                                                    }
                                                    phi_1751_ = ((_e972 + _e993) + _e1014);
                                                    phi_1752_ = false;
                                                    phi_1753_ = _e1034;
                                                } else {
                                                    phi_1751_ = f32();
                                                    phi_1752_ = true;
                                                    phi_1753_ = false;
                                                }
                                                let _e1038 = phi_1751_;
                                                let _e1040 = phi_1752_;
                                                let _e1042 = phi_1753_;
                                                phi_1754_ = _e1038;
                                                phi_1755_ = _e1040;
                                                phi_1756_ = _e1042;
                                            } else {
                                                phi_1754_ = f32();
                                                phi_1755_ = true;
                                                phi_1756_ = false;
                                            }
                                            let _e1044 = phi_1754_;
                                            let _e1046 = phi_1755_;
                                            let _e1048 = phi_1756_;
                                            if _e1046 {
                                                phi_1760_ = false;
                                            } else {
                                                phi_1760_ = _e1048;
                                            }
                                            let _e1050 = phi_1760_;
                                            phi_1761_ = _e1044;
                                            phi_1762_ = _e1050;
                                        } else {
                                            phi_1761_ = _e1029;
                                            phi_1762_ = true;
                                        }
                                        let _e1052 = phi_1761_;
                                        let _e1054 = phi_1762_;
                                        if _e1054 {
                                            let _e1055 = (_e1052 == 0f);
                                            if _e1055 {
                                                phi_2078_ = lt_bvh_triangle_Intersection();
                                                phi_2079_ = false;
                                            } else {
                                                let _e1057 = triangles.member[(0u + _e868)].v0_;
                                                let _e1059 = (_e1057.x - _e145);
                                                let _e1061 = (_e1057.y - _e147);
                                                let _e1063 = (_e1057.z - _e149);
                                                if (_e534 == 0u) {
                                                    phi_1791_ = vec3<f32>(_e1061, _e1063, _e1059);
                                                } else {
                                                    if (_e534 == 1u) {
                                                        phi_1790_ = vec3<f32>(_e1063, _e1059, _e1061);
                                                    } else {
                                                        phi_1790_ = (_e1057 - vec3<f32>(_e145, _e147, _e149));
                                                    }
                                                    let _e1071 = phi_1790_;
                                                    phi_1791_ = _e1071;
                                                }
                                                let _e1073 = phi_1791_;
                                                let _e1075 = triangles.member[(0u + _e868)].v1_;
                                                let _e1077 = triangles.member[(0u + _e868)].v0_;
                                                let _e1080 = (_e1075.x - _e1077.x);
                                                let _e1083 = (_e1075.y - _e1077.y);
                                                let _e1086 = (_e1075.z - _e1077.z);
                                                if (_e534 == 0u) {
                                                    phi_1817_ = vec3<f32>(_e1083, _e1086, _e1080);
                                                } else {
                                                    if (_e534 == 1u) {
                                                        phi_1816_ = vec3<f32>(_e1086, _e1080, _e1083);
                                                    } else {
                                                        phi_1816_ = (_e1075 - _e1077);
                                                    }
                                                    let _e1093 = phi_1816_;
                                                    phi_1817_ = _e1093;
                                                }
                                                let _e1095 = phi_1817_;
                                                let _e1097 = triangles.member[(0u + _e868)].v2_;
                                                let _e1099 = triangles.member[(0u + _e868)].v0_;
                                                let _e1102 = (_e1097.x - _e1099.x);
                                                let _e1105 = (_e1097.y - _e1099.y);
                                                let _e1108 = (_e1097.z - _e1099.z);
                                                if (_e534 == 0u) {
                                                    phi_1843_ = vec3<f32>(_e1105, _e1108, _e1102);
                                                } else {
                                                    if (_e534 == 1u) {
                                                        phi_1842_ = vec3<f32>(_e1108, _e1102, _e1105);
                                                    } else {
                                                        phi_1842_ = (_e1097 - _e1099);
                                                    }
                                                    let _e1115 = phi_1842_;
                                                    phi_1843_ = _e1115;
                                                }
                                                let _e1117 = phi_1843_;
                                                let _e1124 = ((_e1095.y * _e1117.z) - (_e1095.z * _e1117.y));
                                                let _e1131 = ((_e1095.z * _e1117.x) - (_e1095.x * _e1117.z));
                                                let _e1138 = ((_e1095.x * _e1117.y) - (_e1095.y * _e1117.x));
                                                let _e1152 = (((1f / _e542.z) * (((_e1124 * _e1073.x) + (_e1131 * _e1073.y)) + (_e1138 * _e1073.z))) / (((_e1124 * _e545) + (_e1131 * _e548)) + _e1138));
                                                if (_e1152 > 0f) {
                                                    if (_e1152 < _e157) {
                                                        let _e1156 = triangles.member[(0u + _e868)].v0_;
                                                        let _e1158 = triangles.member[(0u + _e868)].v1_;
                                                        if (_e1156.x < _e1158.x) {
                                                            phi_1899_ = _e1156.x;
                                                        } else {
                                                            phi_1899_ = _e1158.x;
                                                        }
                                                        let _e1165 = phi_1899_;
                                                        if (_e1156.y < _e1158.y) {
                                                            phi_1908_ = _e1156.y;
                                                        } else {
                                                            phi_1908_ = _e1158.y;
                                                        }
                                                        let _e1172 = phi_1908_;
                                                        if (_e1156.z < _e1158.z) {
                                                            phi_1917_ = _e1156.z;
                                                        } else {
                                                            phi_1917_ = _e1158.z;
                                                        }
                                                        let _e1179 = phi_1917_;
                                                        let _e1181 = triangles.member[(0u + _e868)].v2_;
                                                        if (_e1165 < _e1181.x) {
                                                            phi_1926_ = _e1165;
                                                        } else {
                                                            phi_1926_ = _e1181.x;
                                                        }
                                                        let _e1186 = phi_1926_;
                                                        if (_e1172 < _e1181.y) {
                                                            phi_1933_ = _e1172;
                                                        } else {
                                                            phi_1933_ = _e1181.y;
                                                        }
                                                        let _e1191 = phi_1933_;
                                                        if (_e1179 < _e1181.z) {
                                                            phi_1940_ = _e1179;
                                                        } else {
                                                            phi_1940_ = _e1181.z;
                                                        }
                                                        let _e1196 = phi_1940_;
                                                        let _e1198 = triangles.member[(0u + _e868)].v0_;
                                                        let _e1200 = triangles.member[(0u + _e868)].v1_;
                                                        if (_e1198.x > _e1200.x) {
                                                            phi_1953_ = _e1198.x;
                                                        } else {
                                                            phi_1953_ = _e1200.x;
                                                        }
                                                        let _e1207 = phi_1953_;
                                                        if (_e1198.y > _e1200.y) {
                                                            phi_1962_ = _e1198.y;
                                                        } else {
                                                            phi_1962_ = _e1200.y;
                                                        }
                                                        let _e1214 = phi_1962_;
                                                        if (_e1198.z > _e1200.z) {
                                                            phi_1971_ = _e1198.z;
                                                        } else {
                                                            phi_1971_ = _e1200.z;
                                                        }
                                                        let _e1221 = phi_1971_;
                                                        let _e1223 = triangles.member[(0u + _e868)].v2_;
                                                        if (_e1207 > _e1223.x) {
                                                            phi_1980_ = _e1207;
                                                        } else {
                                                            phi_1980_ = _e1223.x;
                                                        }
                                                        let _e1228 = phi_1980_;
                                                        if (_e1214 > _e1223.y) {
                                                            phi_1987_ = _e1214;
                                                        } else {
                                                            phi_1987_ = _e1223.y;
                                                        }
                                                        let _e1233 = phi_1987_;
                                                        if (_e1221 > _e1223.z) {
                                                            phi_1994_ = _e1221;
                                                        } else {
                                                            phi_1994_ = _e1223.z;
                                                        }
                                                        let _e1238 = phi_1994_;
                                                        let _e1242 = ((_e1186 - _e145) * _e463);
                                                        let _e1243 = ((_e1191 - _e147) * _e473);
                                                        let _e1244 = ((_e1196 - _e149) * _e483);
                                                        let _e1248 = ((_e1228 - _e145) * _e463);
                                                        let _e1249 = ((_e1233 - _e147) * _e473);
                                                        let _e1250 = ((_e1238 - _e149) * _e483);
                                                        if (_e1242 < _e1248) {
                                                            phi_2011_ = _e1242;
                                                        } else {
                                                            phi_2011_ = _e1248;
                                                        }
                                                        let _e1253 = phi_2011_;
                                                        if (_e1243 < _e1249) {
                                                            phi_2016_ = _e1243;
                                                        } else {
                                                            phi_2016_ = _e1249;
                                                        }
                                                        let _e1256 = phi_2016_;
                                                        if (_e1244 < _e1250) {
                                                            phi_2021_ = _e1244;
                                                        } else {
                                                            phi_2021_ = _e1250;
                                                        }
                                                        let _e1259 = phi_2021_;
                                                        if (_e1242 > _e1248) {
                                                            phi_2029_ = _e1242;
                                                        } else {
                                                            phi_2029_ = _e1248;
                                                        }
                                                        let _e1265 = phi_2029_;
                                                        if (_e1243 > _e1249) {
                                                            phi_2034_ = _e1243;
                                                        } else {
                                                            phi_2034_ = _e1249;
                                                        }
                                                        let _e1268 = phi_2034_;
                                                        if (_e1244 > _e1250) {
                                                            phi_2039_ = _e1244;
                                                        } else {
                                                            phi_2039_ = _e1250;
                                                        }
                                                        let _e1271 = phi_2039_;
                                                        let _e1275 = core_intrinsics_maximum_number_nsz_f32_((_e1253 - _e518), (_e1256 - _e519));
                                                        let _e1276 = core_intrinsics_maximum_number_nsz_f32_(_e1275, (_e1259 - _e520));
                                                        let _e1277 = core_intrinsics_minimum_number_nsz_f32_((_e1265 + _e518), (_e1268 + _e519));
                                                        let _e1278 = core_intrinsics_minimum_number_nsz_f32_(_e1277, (_e1271 + _e520));
                                                        if (_e1276 > -300000000000000000000000000000000000000f) {
                                                            phi_2051_ = _e1276;
                                                        } else {
                                                            phi_2051_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1281 = phi_2051_;
                                                        if (_e1278 < 300000000000000000000000000000000000000f) {
                                                            phi_2056_ = _e1278;
                                                        } else {
                                                            phi_2056_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e1284 = phi_2056_;
                                                        if (_e1152 < _e1281) {
                                                            phi_2061_ = _e1281;
                                                        } else {
                                                            phi_2061_ = _e1152;
                                                        }
                                                        let _e1287 = phi_2061_;
                                                        if (_e1287 > _e1284) {
                                                            phi_2066_ = _e1284;
                                                        } else {
                                                            phi_2066_ = _e1287;
                                                        }
                                                        let _e1290 = phi_2066_;
                                                        phi_2071_ = lt_bvh_triangle_Intersection(_e1290, (_e993 / _e1052), (_e1014 / _e1052), (_e1281 <= _e1284));
                                                        phi_2072_ = false;
                                                    } else {
                                                        phi_2071_ = lt_bvh_triangle_Intersection();
                                                        phi_2072_ = true;
                                                    }
                                                    let _e1296 = phi_2071_;
                                                    let _e1298 = phi_2072_;
                                                    phi_2073_ = _e1296;
                                                    phi_2074_ = _e1298;
                                                } else {
                                                    phi_2073_ = lt_bvh_triangle_Intersection();
                                                    phi_2074_ = true;
                                                }
                                                let _e1300 = phi_2073_;
                                                let _e1302 = phi_2074_;
                                                if _e1302 {
                                                }
                                                phi_2078_ = _e1300;
                                                phi_2079_ = _e1302;
                                            }
                                            let _e1304 = phi_2078_;
                                            let _e1306 = phi_2079_;
                                            phi_2080_ = _e1304;
                                            phi_2081_ = _e1055;
                                            phi_2082_ = _e1306;
                                        } else {
                                            phi_2080_ = lt_bvh_triangle_Intersection();
                                            phi_2081_ = true;
                                            phi_2082_ = false;
                                        }
                                        let _e1308 = phi_2080_;
                                        let _e1310 = phi_2081_;
                                        let _e1312 = phi_2082_;
                                        if _e1310 {
                                            phi_2086_ = true;
                                        } else {
                                            phi_2086_ = _e1312;
                                        }
                                        let _e1314 = phi_2086_;
                                        if _e1314 {
                                            phi_2090_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_2090_ = _e1308;
                                        }
                                        let _e1316 = phi_2090_;
                                        if _e1316.is_hit {
                                            if (_e1316.t > 0f) {
                                                if (_e1316.t < _e157) {
                                                    let _e1323 = triangles.member[(0u + _e868)].i0_;
                                                    let _e1325 = ((_e1323 & 2147483648u) == 0u);
                                                    if _e1325 {
                                                        phi_2313_ = false;
                                                        phi_2314_ = false;
                                                    } else {
                                                        if (_e868 < _e92) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1332 = triangles.member[(0u + _e868)].i0_;
                                                        let _e1333 = (_e1332 & 2147483647u);
                                                        let _e1335 = triangles.member[(0u + _e868)].i1_;
                                                        let _e1337 = triangles.member[(0u + _e868)].i2_;
                                                        if (_e1333 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1341 = vertices.member[(0u + _e1333)];
                                                        if (_e1335 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1345 = vertices.member[(0u + _e1335)];
                                                        if (_e1337 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1349 = vertices.member[(0u + _e1337)];
                                                        let _e1350 = array<abi_Vertex, 3>(_e1341, _e1345, _e1349);
                                                        if (_e1350[0].material < _e108) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e1356 = materials.member[(0u + _e1350[0].material)];
                                                        if ((_e1356.flags & 1u) == 1u) {
                                                            let _e1361 = ((1f - _e1316.u) - _e1316.v);
                                                            if (_e1356.cutoff <= 0f) {
                                                                phi_2307_ = true;
                                                            } else {
                                                                let _e1388 = (_e1356.base_color.w * ((((f32((_e1350[0].color >> bitcast<u32>(24i))) * _e1361) + (f32((_e1350[1].color >> bitcast<u32>(24i))) * _e1316.u)) + (f32((_e1350[2].color >> bitcast<u32>(24i))) * _e1316.v)) * (1f / 255f)));
                                                                if (_e1356.alpha_size == 0u) {
                                                                    phi_2304_ = _e1388;
                                                                } else {
                                                                    local_2.offset = _e1356.alpha_offset;
                                                                    local_2.size = _e1356.alpha_size;
                                                                    local_2.flags = _e1356.flags;
                                                                    let _e1419 = _lt_shaders_texture_TextureView_quad((&local_2), (((_e1350[0].u * _e1361) + (_e1350[1].u * _e1316.u)) + (_e1350[2].u * _e1316.v)), (((_e1350[0].v * _e1361) + (_e1350[1].v * _e1316.u)) + (_e1350[2].v * _e1316.v)));
                                                                    let _e1423 = (_e1419.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e1423 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1427 = alpha_texels.member[(0u + _e1423)];
                                                                    let _e1443 = (_e1419.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e1443 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1447 = alpha_texels.member[(0u + _e1443)];
                                                                    let _e1464 = (_e1419.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e1464 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1468 = alpha_texels.member[(0u + _e1464)];
                                                                    let _e1485 = (_e1419.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e1485 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e1489 = alpha_texels.member[(0u + _e1485)];
                                                                    phi_2304_ = (_e1388 * (((((f32(((_e1427 >> bitcast<u32>((((_e1419.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1419.weights.x) + ((f32(((_e1447 >> bitcast<u32>((((_e1419.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1419.weights.y)) + ((f32(((_e1468 >> bitcast<u32>((((_e1419.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1419.weights.z)) + ((f32(((_e1489 >> bitcast<u32>((((_e1419.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1419.weights.w)));
                                                                }
                                                                let _e1505 = phi_2304_;
                                                                phi_2307_ = (_e1505 >= _e1356.cutoff);
                                                            }
                                                            let _e1509 = phi_2307_;
                                                            phi_2308_ = _e1509;
                                                        } else {
                                                            phi_2308_ = false;
                                                        }
                                                        let _e1511 = phi_2308_;
                                                        if _e1511 {
                                                            phi_2312_ = false;
                                                        } else {
                                                            phi_2312_ = true;
                                                        }
                                                        let _e1513 = phi_2312_;
                                                        phi_2313_ = _e1513;
                                                        phi_2314_ = _e1511;
                                                    }
                                                    let _e1515 = phi_2313_;
                                                    let _e1517 = phi_2314_;
                                                    phi_2315_ = _e1515;
                                                    phi_2316_ = _e1325;
                                                    phi_2317_ = _e1517;
                                                } else {
                                                    phi_2315_ = true;
                                                    phi_2316_ = false;
                                                    phi_2317_ = false;
                                                }
                                                let _e1519 = phi_2315_;
                                                let _e1521 = phi_2316_;
                                                let _e1523 = phi_2317_;
                                                phi_2318_ = false;
                                                phi_2319_ = _e1519;
                                                phi_2320_ = _e1521;
                                                phi_2321_ = _e1523;
                                            } else {
                                                phi_2318_ = true;
                                                phi_2319_ = false;
                                                phi_2320_ = false;
                                                phi_2321_ = false;
                                            }
                                            let _e1525 = phi_2318_;
                                            let _e1527 = phi_2319_;
                                            let _e1529 = phi_2320_;
                                            let _e1531 = phi_2321_;
                                            phi_2322_ = _e1525;
                                            phi_2323_ = _e1527;
                                            phi_2324_ = _e1529;
                                            phi_2325_ = _e1531;
                                        } else {
                                            phi_2322_ = true;
                                            phi_2323_ = false;
                                            phi_2324_ = false;
                                            phi_2325_ = false;
                                        }
                                        let _e1533 = phi_2322_;
                                        let _e1535 = phi_2323_;
                                        let _e1537 = phi_2324_;
                                        let _e1539 = phi_2325_;
                                        if _e1533 {
                                            phi_2329_ = true;
                                            phi_2330_ = false;
                                            phi_2331_ = false;
                                        } else {
                                            phi_2329_ = _e1535;
                                            phi_2330_ = _e1537;
                                            phi_2331_ = _e1539;
                                        }
                                        let _e1541 = phi_2329_;
                                        let _e1543 = phi_2330_;
                                        let _e1545 = phi_2331_;
                                        if _e1541 {
                                            phi_2335_ = false;
                                            phi_2336_ = false;
                                        } else {
                                            phi_2335_ = _e1543;
                                            phi_2336_ = _e1545;
                                        }
                                        let _e1547 = phi_2335_;
                                        let _e1549 = phi_2336_;
                                        phi_1491_ = (_e832 & (_e832 - 1u));
                                        phi_2337_ = _e1541;
                                        phi_2338_ = _e1547;
                                        phi_2339_ = _e1549;
                                    }
                                    let _e1551 = phi_1491_;
                                    let _e1553 = phi_2337_;
                                    let _e1555 = phi_2338_;
                                    let _e1557 = phi_2339_;
                                    local_11 = _e1555;
                                    local_12 = _e1557;
                                    continue;
                                    continuing {
                                        phi_1490_ = _e1551;
                                        break if !(_e1553);
                                    }
                                }
                                let _e1560 = local_4;
                                if _e1560 {
                                    phi_2343_ = false;
                                    phi_2344_ = false;
                                } else {
                                    let _e3439 = local_11;
                                    phi_2343_ = _e3439;
                                    let _e3442 = local_12;
                                    phi_2344_ = _e3442;
                                }
                                let _e1562 = phi_2343_;
                                let _e1564 = phi_2344_;
                                phi_2372_ = _e566;
                                phi_2373_ = _e557;
                                let _e3451 = local_13;
                                phi_2374_ = _e3451;
                                phi_2375_ = _e1562;
                                phi_2376_ = _e1564;
                            } else {
                                if (_e826 == 0u) {
                                    phi_2370_ = _e566;
                                    phi_2371_ = _e557;
                                } else {
                                    if ((_e566 & 255u) == 0u) {
                                        phi_2366_ = _e557;
                                    } else {
                                        if (_e557 < 32u) {
                                            if (_e557 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_3[(0u + _e557)] = _e566;
                                            phi_2365_ = (_e557 + 1u);
                                        } else {
                                            phi_2365_ = _e557;
                                        }
                                        let _e1574 = phi_2365_;
                                        phi_2366_ = _e1574;
                                    }
                                    let _e1576 = phi_2366_;
                                    phi_2370_ = ((_e587.rest.z << bitcast<u32>(8i)) | _e826);
                                    phi_2371_ = _e1576;
                                }
                                let _e1583 = phi_2370_;
                                let _e1585 = phi_2371_;
                                phi_2372_ = _e1583;
                                phi_2373_ = _e1585;
                                phi_2374_ = true;
                                phi_2375_ = false;
                                phi_2376_ = false;
                            }
                            let _e1587 = phi_2372_;
                            let _e1589 = phi_2373_;
                            let _e1591 = phi_2374_;
                            let _e1593 = phi_2375_;
                            let _e1595 = phi_2376_;
                            if _e1591 {
                                if ((_e1587 & 255u) == 0u) {
                                    if (_e1589 > 0u) {
                                        let _e1599 = (_e1589 - 1u);
                                        if (_e1599 < 32u) {
                                        } else {
                                            return;
                                        }
                                        let _e1603 = local_3[(0u + _e1599)];
                                        phi_2397_ = _e1603;
                                        phi_2398_ = _e1599;
                                    } else {
                                        phi_2397_ = 0u;
                                        phi_2398_ = _e1589;
                                    }
                                    let _e1605 = phi_2397_;
                                    let _e1607 = phi_2398_;
                                    phi_2399_ = _e1605;
                                    phi_2400_ = _e1607;
                                } else {
                                    phi_2399_ = _e1587;
                                    phi_2400_ = _e1589;
                                }
                                let _e1609 = phi_2399_;
                                let _e1611 = phi_2400_;
                                phi_2401_ = _e1609;
                                phi_2402_ = _e1611;
                                phi_2403_ = false;
                                phi_2404_ = false;
                            } else {
                                phi_2401_ = u32();
                                phi_2402_ = u32();
                                phi_2403_ = _e1593;
                                phi_2404_ = _e1595;
                            }
                            let _e1613 = phi_2401_;
                            let _e1615 = phi_2402_;
                            let _e1617 = phi_2403_;
                            let _e1619 = phi_2404_;
                            phi_1201_ = _e1613;
                            phi_1204_ = _e1615;
                            phi_2405_ = _e1591;
                            phi_2406_ = _e1617;
                            phi_2407_ = _e1619;
                        }
                        let _e1621 = phi_1201_;
                        let _e1623 = phi_1204_;
                        let _e1625 = phi_2405_;
                        let _e1627 = phi_2406_;
                        let _e1629 = phi_2407_;
                        local_14 = _e1627;
                        local_15 = _e1629;
                        continue;
                        continuing {
                            phi_1200_ = _e1621;
                            phi_1203_ = _e1623;
                            break if !(_e1625);
                        }
                    }
                    let _e1632 = local_5;
                    if _e1632 {
                        phi_2411_ = false;
                        phi_2412_ = false;
                    } else {
                        let _e3470 = local_14;
                        phi_2411_ = _e3470;
                        let _e3473 = local_15;
                        phi_2412_ = _e3473;
                    }
                    let _e1634 = phi_2411_;
                    let _e1636 = phi_2412_;
                    if _e1634 {
                        phi_2416_ = false;
                    } else {
                        phi_2416_ = _e1636;
                    }
                    let _e1638 = phi_2416_;
                    if _e1638 {
                        phi_2420_ = true;
                    } else {
                        phi_2420_ = _e1634;
                    }
                    let _e1640 = phi_2420_;
                    if _e1640 {
                    }
                    phi_2424_ = true;
                    phi_2425_ = _e1640;
                }
                let _e1642 = phi_2424_;
                let _e1644 = phi_2425_;
                if _e1644 {
                    phi_2429_ = _e1642;
                } else {
                    phi_2429_ = false;
                }
                let _e1646 = phi_2429_;
                phi_4094_ = _e1646;
            } else {
                let _e1647 = abs(_e165);
                let _e1648 = abs(_e166);
                let _e1649 = abs(_e167);
                if (abs(_e145) < 1000000000000000f) {
                    if (abs(_e147) < 1000000000000000f) {
                        phi_2445_ = (abs(_e149) < 1000000000000000f);
                        phi_2446_ = false;
                    } else {
                        phi_2445_ = bool();
                        phi_2446_ = true;
                    }
                    let _e1657 = phi_2445_;
                    let _e1659 = phi_2446_;
                    phi_2447_ = _e1657;
                    phi_2448_ = _e1659;
                } else {
                    phi_2447_ = bool();
                    phi_2448_ = true;
                }
                let _e1661 = phi_2447_;
                let _e1663 = phi_2448_;
                if _e1663 {
                    phi_2452_ = false;
                } else {
                    phi_2452_ = _e1661;
                }
                let _e1665 = phi_2452_;
                if _e1665 {
                    if (_e1647 < 1000000000000000f) {
                        if (_e1648 < 1000000000000000f) {
                            phi_2465_ = (_e1649 < 1000000000000000f);
                            phi_2466_ = false;
                        } else {
                            phi_2465_ = bool();
                            phi_2466_ = true;
                        }
                        let _e1670 = phi_2465_;
                        let _e1672 = phi_2466_;
                        phi_2467_ = _e1670;
                        phi_2468_ = _e1672;
                    } else {
                        phi_2467_ = bool();
                        phi_2468_ = true;
                    }
                    let _e1674 = phi_2467_;
                    let _e1676 = phi_2468_;
                    if _e1676 {
                        phi_2472_ = false;
                    } else {
                        phi_2472_ = _e1674;
                    }
                    let _e1678 = phi_2472_;
                    if _e1678 {
                        if (_e1647 > 0f) {
                            phi_2486_ = bool();
                            phi_2487_ = true;
                        } else {
                            let _e1680 = (_e1648 > 0f);
                            if _e1680 {
                                phi_2485_ = bool();
                            } else {
                                phi_2485_ = (_e1649 > 0f);
                            }
                            let _e1683 = phi_2485_;
                            phi_2486_ = _e1683;
                            phi_2487_ = _e1680;
                        }
                        let _e1685 = phi_2486_;
                        let _e1687 = phi_2487_;
                        if _e1687 {
                            phi_2491_ = true;
                        } else {
                            phi_2491_ = _e1685;
                        }
                        let _e1689 = phi_2491_;
                        phi_2492_ = _e1689;
                        phi_2493_ = false;
                    } else {
                        phi_2492_ = bool();
                        phi_2493_ = true;
                    }
                    let _e1691 = phi_2492_;
                    let _e1693 = phi_2493_;
                    phi_2494_ = _e1691;
                    phi_2495_ = _e1693;
                } else {
                    phi_2494_ = bool();
                    phi_2495_ = true;
                }
                let _e1695 = phi_2494_;
                let _e1697 = phi_2495_;
                if _e1697 {
                    phi_2499_ = false;
                } else {
                    phi_2499_ = _e1695;
                }
                let _e1699 = phi_2499_;
                if _e1699 {
                    let _e1700 = (0u >= _e89);
                    if _e1700 {
                        phi_4087_ = bool();
                    } else {
                        if (0u < _e89) {
                        } else {
                            return;
                        }
                        let _e1706 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1710 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1714 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1718 = nodes.member[(0u + 0u)].frame[0u];
                        let _e1722 = nodes.member[(0u + 0u)].frame[1u];
                        let _e1726 = nodes.member[(0u + 0u)].frame[2u];
                        let _e1730 = nodes.member[(0u + 0u)].frame[3u];
                        let _e1764 = core_intrinsics_maximum_number_nsz_f32_(abs(_e165), abs(_e166));
                        let _e1765 = core_intrinsics_maximum_number_nsz_f32_(_e1764, abs(_e167));
                        let _e1766 = (_e1765 * 0.0000000000009094947f);
                        if (abs(_e165) < _e1766) {
                            phi_2569_ = _e1766;
                        } else {
                            phi_2569_ = abs(_e165);
                        }
                        let _e1771 = phi_2569_;
                        if (_e165 < 0f) {
                            phi_2576_ = (-1f / _e1771);
                        } else {
                            phi_2576_ = (1f / _e1771);
                        }
                        let _e1776 = phi_2576_;
                        if (abs(_e166) < _e1766) {
                            phi_2583_ = _e1766;
                        } else {
                            phi_2583_ = abs(_e166);
                        }
                        let _e1781 = phi_2583_;
                        if (_e166 < 0f) {
                            phi_2590_ = (-1f / _e1781);
                        } else {
                            phi_2590_ = (1f / _e1781);
                        }
                        let _e1786 = phi_2590_;
                        if (abs(_e167) < _e1766) {
                            phi_2597_ = _e1766;
                        } else {
                            phi_2597_ = abs(_e167);
                        }
                        let _e1791 = phi_2597_;
                        if (_e167 < 0f) {
                            phi_2604_ = (-1f / _e1791);
                        } else {
                            phi_2604_ = (1f / _e1791);
                        }
                        let _e1796 = phi_2604_;
                        let _e1800 = abs((bitcast<f32>(_e1706) - _e145));
                        let _e1801 = abs((bitcast<f32>(_e1710) - _e147));
                        let _e1802 = abs((bitcast<f32>(_e1714) - _e149));
                        let _e1806 = abs(((bitcast<f32>(_e1718) + (bitcast<f32>((((_e1730 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e145));
                        let _e1807 = abs(((bitcast<f32>(_e1722) + (bitcast<f32>((((_e1730 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e147));
                        let _e1808 = abs(((bitcast<f32>(_e1726) + (bitcast<f32>((((_e1730 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e149));
                        if (_e1800 > _e1806) {
                            phi_2621_ = _e1800;
                        } else {
                            phi_2621_ = _e1806;
                        }
                        let _e1811 = phi_2621_;
                        if (_e1801 > _e1807) {
                            phi_2626_ = _e1801;
                        } else {
                            phi_2626_ = _e1807;
                        }
                        let _e1814 = phi_2626_;
                        if (_e1802 > _e1808) {
                            phi_2631_ = _e1802;
                        } else {
                            phi_2631_ = _e1808;
                        }
                        let _e1817 = phi_2631_;
                        if (_e1811 > _e1814) {
                            phi_2636_ = _e1811;
                        } else {
                            phi_2636_ = _e1814;
                        }
                        let _e1820 = phi_2636_;
                        if (_e1820 > _e1817) {
                            phi_2641_ = _e1820;
                        } else {
                            phi_2641_ = _e1817;
                        }
                        let _e1823 = phi_2641_;
                        let _e1827 = (_e1823 * 0.0000019073486f);
                        let _e1828 = (abs(_e1776) * _e1827);
                        let _e1829 = (abs(_e1786) * _e1827);
                        let _e1830 = (abs(_e1796) * _e1827);
                        let _e1834 = (_e1823 * 0.0000009536743f);
                        let _e1835 = (abs(_e1776) * _e1834);
                        let _e1836 = (abs(_e1786) * _e1834);
                        let _e1837 = (abs(_e1796) * _e1834);
                        let _e1838 = abs(_e165);
                        let _e1839 = abs(_e166);
                        let _e1840 = abs(_e167);
                        if (_e1838 >= _e1839) {
                            if (_e1838 >= _e1840) {
                                phi_2667_ = false;
                            } else {
                                phi_2667_ = true;
                            }
                            let _e1844 = phi_2667_;
                            phi_2668_ = _e1844;
                        } else {
                            phi_2668_ = true;
                        }
                        let _e1846 = phi_2668_;
                        if _e1846 {
                            if (_e1839 >= _e1840) {
                                phi_2676_ = 1u;
                            } else {
                                phi_2676_ = 2u;
                            }
                            let _e1849 = phi_2676_;
                            phi_2677_ = _e1849;
                        } else {
                            phi_2677_ = 0u;
                        }
                        let _e1851 = phi_2677_;
                        if (_e1851 == 0u) {
                            phi_2689_ = vec3<f32>(_e166, _e167, _e165);
                        } else {
                            if (_e1851 == 1u) {
                                phi_2688_ = vec3<f32>(_e167, _e165, _e166);
                            } else {
                                phi_2688_ = _e168;
                            }
                            let _e1857 = phi_2688_;
                            phi_2689_ = _e1857;
                        }
                        let _e1859 = phi_2689_;
                        let _e1862 = (_e1859.x / _e1859.z);
                        let _e1865 = (_e1859.y / _e1859.z);
                        if (_e1776 < 0f) {
                            phi_2702_ = 0u;
                        } else {
                            phi_2702_ = 1u;
                        }
                        let _e1870 = phi_2702_;
                        if (_e1786 < 0f) {
                            phi_2707_ = 0u;
                        } else {
                            phi_2707_ = 2u;
                        }
                        let _e1873 = phi_2707_;
                        if (_e1796 < 0f) {
                            phi_2712_ = 0u;
                        } else {
                            phi_2712_ = 4u;
                        }
                        let _e1876 = phi_2712_;
                        let _e1878 = ((_e1870 | _e1873) | _e1876);
                        let _e1879 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                        local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e1879.first[0], _e1879.first[1], _e1879.first[2], _e1879.first[3], _e1879.first[4], _e1879.first[5], _e1879.first[6], _e1879.first[7], _e1879.first[8], _e1879.first[9], _e1879.first[10], _e1879.first[11], _e1879.first[12], _e1879.first[13], _e1879.first[14], _e1879.first[15], _e1879.first[16], _e1879.first[17], _e1879.first[18], _e1879.first[19], _e1879.first[20], _e1879.first[21], _e1879.first[22], _e1879.first[23], _e1879.first[24], _e1879.first[25], _e1879.first[26], _e1879.first[27], _e1879.first[28], _e1879.first[29], _e1879.first[30], _e1879.first[31]), array<u32, 32>(_e1879.mask[0], _e1879.mask[1], _e1879.mask[2], _e1879.mask[3], _e1879.mask[4], _e1879.mask[5], _e1879.mask[6], _e1879.mask[7], _e1879.mask[8], _e1879.mask[9], _e1879.mask[10], _e1879.mask[11], _e1879.mask[12], _e1879.mask[13], _e1879.mask[14], _e1879.mask[15], _e1879.mask[16], _e1879.mask[17], _e1879.mask[18], _e1879.mask[19], _e1879.mask[20], _e1879.mask[21], _e1879.mask[22], _e1879.mask[23], _e1879.mask[24], _e1879.mask[25], _e1879.mask[26], _e1879.mask[27], _e1879.mask[28], _e1879.mask[29], _e1879.mask[30], _e1879.mask[31]), _e1879.len, _e1879.group, _e1879.group_mask);
                        let _e1953 = local_1.group_mask;
                        if ((_e1953 & 4278190080u) == 0u) {
                            let _e1957 = local_1.len;
                            if (_e1957 == 0u) {
                                phi_2826_ = false;
                            } else {
                                let _e1961 = local_1.len;
                                local_1.len = (_e1961 - 1u);
                                let _e1964 = local_1.len;
                                if (_e1964 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1969 = local_1.first[(0u + _e1964)];
                                local_1.group = _e1969;
                                let _e1972 = local_1.len;
                                if (_e1972 < 32u) {
                                } else {
                                    return;
                                }
                                let _e1977 = local_1.mask[(0u + _e1972)];
                                local_1.group_mask = _e1977;
                                phi_2826_ = true;
                            }
                            let _e1980 = phi_2826_;
                            phi_2827_ = _e1980;
                        } else {
                            phi_2827_ = true;
                        }
                        let _e1982 = phi_2827_;
                        if _e1982 {
                            let _e1984 = local_1.group_mask;
                            let _e1990 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1984)), 32u, (_e1984 == 0u)));
                            let _e1994 = local_1.group_mask;
                            let _e2008 = local_1.group_mask;
                            local_1.group_mask = (_e2008 & ~((1u << bitcast<u32>((_e1990 & 31u)))));
                            let _e2011 = local_1.group;
                            phi_2858_ = (_e2011 + countOneBits(((_e1994 & ~((4294967295u << bitcast<u32>((((_e1990 - 24u) ^ 7u) & 31u))))) & 255u)));
                        } else {
                            phi_2858_ = 4294967295u;
                        }
                        let _e2014 = phi_2858_;
                        phi_2860_ = _e2014;
                        phi_2863_ = false;
                        loop {
                            let _e2016 = phi_2860_;
                            let _e2018 = phi_2863_;
                            local_20 = _e2018;
                            if (_e2016 != 4294967295u) {
                                if (_e2016 < _e89) {
                                } else {
                                    return;
                                }
                                let _e2025 = nodes.member[(0u + _e2016)].frame[3u];
                                let _e2050 = (bitcast<f32>((((_e2025 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1776);
                                let _e2051 = (bitcast<f32>((((_e2025 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1786);
                                let _e2052 = (bitcast<f32>((((_e2025 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e1796);
                                let _e2055 = nodes.member[(0u + _e2016)].frame[0u];
                                let _e2059 = nodes.member[(0u + _e2016)].frame[1u];
                                let _e2063 = nodes.member[(0u + _e2016)].frame[2u];
                                let _e2068 = ((bitcast<f32>(_e2055) - _e145) * _e1776);
                                let _e2069 = ((bitcast<f32>(_e2059) - _e147) * _e1786);
                                let _e2070 = ((bitcast<f32>(_e2063) - _e149) * _e1796);
                                let _e2078 = nodes.member[(0u + _e2016)].x;
                                if (_e1776 < 0f) {
                                    let _e2089 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2078.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2095 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2089.unnamed.word, _e2078.w), _e2089.unnamed_1);
                                    let _e2101 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2095.unnamed, lt_mask_LightPlace(_e2078.x, _e2095.unnamed_1.shift));
                                    phi_2943_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2101.unnamed, lt_mask_LightPlace(_e2101.unnamed_1.word, _e2078.y));
                                } else {
                                    let _e2117 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2078.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2123 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2117.unnamed.word, _e2078.y), _e2117.unnamed_1);
                                    let _e2129 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2123.unnamed, lt_mask_LightPlace(_e2078.z, _e2123.unnamed_1.shift));
                                    phi_2943_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2129.unnamed, lt_mask_LightPlace(_e2129.unnamed_1.word, _e2078.w));
                                }
                                let _e2137 = phi_2943_;
                                let _e2147 = nodes.member[(0u + _e2016)].y;
                                if (_e1786 < 0f) {
                                    let _e2158 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2147.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2164 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2158.unnamed.word, _e2147.w), _e2158.unnamed_1);
                                    let _e2170 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2164.unnamed, lt_mask_LightPlace(_e2147.x, _e2164.unnamed_1.shift));
                                    phi_2970_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2170.unnamed, lt_mask_LightPlace(_e2170.unnamed_1.word, _e2147.y));
                                } else {
                                    let _e2186 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2147.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2192 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2186.unnamed.word, _e2147.y), _e2186.unnamed_1);
                                    let _e2198 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2192.unnamed, lt_mask_LightPlace(_e2147.z, _e2192.unnamed_1.shift));
                                    phi_2970_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2198.unnamed, lt_mask_LightPlace(_e2198.unnamed_1.word, _e2147.w));
                                }
                                let _e2206 = phi_2970_;
                                let _e2216 = nodes.member[(0u + _e2016)].z;
                                if (_e1796 < 0f) {
                                    let _e2227 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2216.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2233 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2227.unnamed.word, _e2216.w), _e2227.unnamed_1);
                                    let _e2239 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2233.unnamed, lt_mask_LightPlace(_e2216.x, _e2233.unnamed_1.shift));
                                    phi_2997_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2239.unnamed, lt_mask_LightPlace(_e2239.unnamed_1.word, _e2216.y));
                                } else {
                                    let _e2255 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2216.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.shift), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                                    let _e2261 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_mask_LightPlace(_e2255.unnamed.word, _e2216.y), _e2255.unnamed_1);
                                    let _e2267 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2261.unnamed, lt_mask_LightPlace(_e2216.z, _e2261.unnamed_1.shift));
                                    phi_2997_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e2267.unnamed, lt_mask_LightPlace(_e2267.unnamed_1.word, _e2216.w));
                                }
                                let _e2275 = phi_2997_;
                                phi_3003_ = 0u;
                                phi_3006_ = 0u;
                                loop {
                                    let _e2285 = phi_3003_;
                                    let _e2287 = phi_3006_;
                                    local_6 = _e2287;
                                    local_7 = _e2287;
                                    local_8 = _e2287;
                                    let _e2288 = (_e2285 < 8u);
                                    if _e2288 {
                                        let _e2290 = (_e2285 >> bitcast<u32>(2i));
                                        let _e2291 = (_e2285 & 3u);
                                        if (_e2290 == 0u) {
                                            phi_3020_ = _e2137.unnamed.word;
                                        } else {
                                            phi_3020_ = _e2137.unnamed.shift;
                                        }
                                        let _e2294 = phi_3020_;
                                        if (_e2290 == 0u) {
                                            phi_3030_ = _e2206.unnamed.word;
                                        } else {
                                            phi_3030_ = _e2206.unnamed.shift;
                                        }
                                        let _e2303 = phi_3030_;
                                        if (_e2290 == 0u) {
                                            phi_3040_ = _e2275.unnamed.word;
                                        } else {
                                            phi_3040_ = _e2275.unnamed.shift;
                                        }
                                        let _e2312 = phi_3040_;
                                        let _e2325 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e2294 >> bitcast<u32>(((_e2291 * 8u) & 31u))) & 255u)) * _e2050) + (_e2068 - _e1828)), ((f32(((_e2303 >> bitcast<u32>(((_e2291 * 8u) & 31u))) & 255u)) * _e2051) + (_e2069 - _e1829)));
                                        let _e2326 = core_intrinsics_maximum_number_nsz_f32_(_e2325, ((f32(((_e2312 >> bitcast<u32>(((_e2291 * 8u) & 31u))) & 255u)) * _e2052) + (_e2070 - _e1830)));
                                        if (_e2290 == 0u) {
                                            phi_3058_ = _e2137.unnamed_1.word;
                                        } else {
                                            phi_3058_ = _e2137.unnamed_1.shift;
                                        }
                                        let _e2329 = phi_3058_;
                                        if (_e2290 == 0u) {
                                            phi_3068_ = _e2206.unnamed_1.word;
                                        } else {
                                            phi_3068_ = _e2206.unnamed_1.shift;
                                        }
                                        let _e2338 = phi_3068_;
                                        if (_e2290 == 0u) {
                                            phi_3078_ = _e2275.unnamed_1.word;
                                        } else {
                                            phi_3078_ = _e2275.unnamed_1.shift;
                                        }
                                        let _e2347 = phi_3078_;
                                        let _e2360 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e2329 >> bitcast<u32>(((_e2291 * 8u) & 31u))) & 255u)) * _e2050) + (_e2068 + _e1828)), ((f32(((_e2338 >> bitcast<u32>(((_e2291 * 8u) & 31u))) & 255u)) * _e2051) + (_e2069 + _e1829)));
                                        let _e2361 = core_intrinsics_minimum_number_nsz_f32_(_e2360, ((f32(((_e2347 >> bitcast<u32>(((_e2291 * 8u) & 31u))) & 255u)) * _e2052) + (_e2070 + _e1830)));
                                        if (_e2326 <= _e2361) {
                                            if (_e2326 <= _e157) {
                                                if (_e2361 >= 0f) {
                                                    if (_e2290 == 0u) {
                                                        let _e2368 = nodes.member[(0u + _e2016)].links[2u];
                                                        phi_3114_ = _e2368;
                                                    } else {
                                                        let _e2371 = nodes.member[(0u + _e2016)].links[3u];
                                                        phi_3114_ = _e2371;
                                                    }
                                                    let _e2373 = phi_3114_;
                                                    let _e2378 = ((_e2373 >> bitcast<u32>(((_e2291 * 8u) & 31u))) & 255u);
                                                    let _e2379 = (_e2378 & 31u);
                                                    if (_e2379 >= 24u) {
                                                        phi_3127_ = (24u + ((_e2379 - 24u) ^ _e1878));
                                                    } else {
                                                        phi_3127_ = _e2379;
                                                    }
                                                    let _e2385 = phi_3127_;
                                                    phi_3132_ = (_e2287 | ((_e2378 >> bitcast<u32>(5i)) << bitcast<u32>((_e2385 & 31u))));
                                                } else {
                                                    phi_3132_ = _e2287;
                                                }
                                                let _e2393 = phi_3132_;
                                                phi_3133_ = _e2393;
                                            } else {
                                                phi_3133_ = _e2287;
                                            }
                                            let _e2395 = phi_3133_;
                                            phi_3134_ = _e2395;
                                        } else {
                                            phi_3134_ = _e2287;
                                        }
                                        let _e2397 = phi_3134_;
                                        phi_3004_ = (_e2285 + 1u);
                                        phi_3007_ = _e2397;
                                    } else {
                                        phi_3004_ = u32();
                                        phi_3007_ = u32();
                                    }
                                    let _e2400 = phi_3004_;
                                    let _e2402 = phi_3007_;
                                    continue;
                                    continuing {
                                        phi_3003_ = _e2400;
                                        phi_3006_ = _e2402;
                                        break if !(_e2288);
                                    }
                                }
                                let _e2406 = nodes.member[(0u + _e2016)].links[0u];
                                let _e2410 = nodes.member[(0u + _e2016)].frame[3u];
                                let _e2414 = local_6;
                                if ((_e2414 & 4278190080u) == 0u) {
                                } else {
                                    let _e2418 = local_1.group_mask;
                                    if ((_e2418 & 4278190080u) == 0u) {
                                    } else {
                                        let _e2422 = local_1.len;
                                        if (_e2422 < 32u) {
                                            let _e2425 = local_1.group;
                                            let _e2427 = local_1.len;
                                            if (_e2427 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.first[(0u + _e2427)] = _e2425;
                                            let _e2433 = local_1.group_mask;
                                            let _e2435 = local_1.len;
                                            if (_e2435 < 32u) {
                                            } else {
                                                return;
                                            }
                                            local_1.mask[(0u + _e2435)] = _e2433;
                                            let _e2442 = local_1.len;
                                            local_1.len = (_e2442 + 1u);
                                        }
                                    }
                                    local_1.group = (0u + _e2406);
                                    let _e2446 = local_7;
                                    local_1.group_mask = ((_e2446 & 4278190080u) | (_e2410 >> bitcast<u32>(24i)));
                                }
                                let _e2451 = local_8;
                                phi_3192_ = (_e2451 & 16777215u);
                                phi_3195_ = _e2018;
                                loop {
                                    let _e2454 = phi_3192_;
                                    let _e2456 = phi_3195_;
                                    local_16 = _e2456;
                                    let _e2457 = (_e2454 == 0u);
                                    local_9 = _e2457;
                                    local_18 = _e2457;
                                    if _e2457 {
                                        phi_3193_ = u32();
                                        phi_3196_ = bool();
                                        phi_3999_ = bool();
                                        phi_4000_ = false;
                                    } else {
                                        let _e2460 = nodes.member[(0u + _e2016)].links[1u];
                                        let _e2465 = ((0u + _e2460) + select(firstTrailingBit(_e2454), 32u, (_e2454 == 0u)));
                                        if (_e2465 < _e92) {
                                        } else {
                                            return;
                                        }
                                        let _e2472 = triangles.member[(0u + _e2465)].v0_;
                                        let _e2474 = (_e2472.x - _e145);
                                        let _e2476 = (_e2472.y - _e147);
                                        let _e2478 = (_e2472.z - _e149);
                                        if (_e1851 == 0u) {
                                            phi_3240_ = vec3<f32>(_e2476, _e2478, _e2474);
                                        } else {
                                            if (_e1851 == 1u) {
                                                phi_3239_ = vec3<f32>(_e2478, _e2474, _e2476);
                                            } else {
                                                phi_3239_ = (_e2472 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2486 = phi_3239_;
                                            phi_3240_ = _e2486;
                                        }
                                        let _e2488 = phi_3240_;
                                        let _e2492 = (_e2488.x - (_e1862 * _e2488.z));
                                        let _e2496 = (_e2488.y - (_e1865 * _e2488.z));
                                        let _e2498 = triangles.member[(0u + _e2465)].v1_;
                                        let _e2500 = (_e2498.x - _e145);
                                        let _e2502 = (_e2498.y - _e147);
                                        let _e2504 = (_e2498.z - _e149);
                                        if (_e1851 == 0u) {
                                            phi_3270_ = vec3<f32>(_e2502, _e2504, _e2500);
                                        } else {
                                            if (_e1851 == 1u) {
                                                phi_3269_ = vec3<f32>(_e2504, _e2500, _e2502);
                                            } else {
                                                phi_3269_ = (_e2498 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2512 = phi_3269_;
                                            phi_3270_ = _e2512;
                                        }
                                        let _e2514 = phi_3270_;
                                        let _e2518 = (_e2514.x - (_e1862 * _e2514.z));
                                        let _e2522 = (_e2514.y - (_e1865 * _e2514.z));
                                        let _e2524 = triangles.member[(0u + _e2465)].v2_;
                                        let _e2526 = (_e2524.x - _e145);
                                        let _e2528 = (_e2524.y - _e147);
                                        let _e2530 = (_e2524.z - _e149);
                                        if (_e1851 == 0u) {
                                            phi_3300_ = vec3<f32>(_e2528, _e2530, _e2526);
                                        } else {
                                            if (_e1851 == 1u) {
                                                phi_3299_ = vec3<f32>(_e2530, _e2526, _e2528);
                                            } else {
                                                phi_3299_ = (_e2524 - vec3<f32>(_e145, _e147, _e149));
                                            }
                                            let _e2538 = phi_3299_;
                                            phi_3300_ = _e2538;
                                        }
                                        let _e2540 = phi_3300_;
                                        let _e2544 = (_e2540.x - (_e1862 * _e2540.z));
                                        let _e2548 = (_e2540.y - (_e1865 * _e2540.z));
                                        if (_e2518 < _e2544) {
                                            phi_3319_ = true;
                                        } else {
                                            if (_e2518 == _e2544) {
                                                phi_3318_ = (_e2522 < _e2548);
                                            } else {
                                                phi_3318_ = false;
                                            }
                                            let _e2553 = phi_3318_;
                                            phi_3319_ = _e2553;
                                        }
                                        let _e2555 = phi_3319_;
                                        if _e2555 {
                                            phi_3323_ = _e2548;
                                            phi_3324_ = _e2544;
                                            phi_3325_ = _e2522;
                                            phi_3326_ = _e2518;
                                        } else {
                                            phi_3323_ = _e2522;
                                            phi_3324_ = _e2518;
                                            phi_3325_ = _e2548;
                                            phi_3326_ = _e2544;
                                        }
                                        let _e2557 = phi_3323_;
                                        let _e2559 = phi_3324_;
                                        let _e2561 = phi_3325_;
                                        let _e2563 = phi_3326_;
                                        let _e2566 = ((_e2563 * _e2557) - (_e2561 * _e2559));
                                        if _e2555 {
                                            phi_3334_ = -(_e2566);
                                        } else {
                                            phi_3334_ = _e2566;
                                        }
                                        let _e2569 = phi_3334_;
                                        if (_e2544 < _e2492) {
                                            phi_3345_ = true;
                                        } else {
                                            if (_e2544 == _e2492) {
                                                phi_3344_ = (_e2548 < _e2496);
                                            } else {
                                                phi_3344_ = false;
                                            }
                                            let _e2574 = phi_3344_;
                                            phi_3345_ = _e2574;
                                        }
                                        let _e2576 = phi_3345_;
                                        if _e2576 {
                                            phi_3349_ = _e2496;
                                            phi_3350_ = _e2492;
                                            phi_3351_ = _e2548;
                                            phi_3352_ = _e2544;
                                        } else {
                                            phi_3349_ = _e2548;
                                            phi_3350_ = _e2544;
                                            phi_3351_ = _e2496;
                                            phi_3352_ = _e2492;
                                        }
                                        let _e2578 = phi_3349_;
                                        let _e2580 = phi_3350_;
                                        let _e2582 = phi_3351_;
                                        let _e2584 = phi_3352_;
                                        let _e2587 = ((_e2584 * _e2578) - (_e2582 * _e2580));
                                        if _e2576 {
                                            phi_3360_ = -(_e2587);
                                        } else {
                                            phi_3360_ = _e2587;
                                        }
                                        let _e2590 = phi_3360_;
                                        if (_e2492 < _e2518) {
                                            phi_3371_ = true;
                                        } else {
                                            if (_e2492 == _e2518) {
                                                phi_3370_ = (_e2496 < _e2522);
                                            } else {
                                                phi_3370_ = false;
                                            }
                                            let _e2595 = phi_3370_;
                                            phi_3371_ = _e2595;
                                        }
                                        let _e2597 = phi_3371_;
                                        if _e2597 {
                                            phi_3375_ = _e2522;
                                            phi_3376_ = _e2518;
                                            phi_3377_ = _e2496;
                                            phi_3378_ = _e2492;
                                        } else {
                                            phi_3375_ = _e2496;
                                            phi_3376_ = _e2492;
                                            phi_3377_ = _e2522;
                                            phi_3378_ = _e2518;
                                        }
                                        let _e2599 = phi_3375_;
                                        let _e2601 = phi_3376_;
                                        let _e2603 = phi_3377_;
                                        let _e2605 = phi_3378_;
                                        let _e2608 = ((_e2605 * _e2599) - (_e2603 * _e2601));
                                        if _e2597 {
                                            phi_3386_ = -(_e2608);
                                        } else {
                                            phi_3386_ = _e2608;
                                        }
                                        let _e2611 = phi_3386_;
                                        if (_e2569 >= 0f) {
                                            if (_e2590 >= 0f) {
                                                if (_e2611 >= 0f) {
                                                    phi_3401_ = ((_e2569 + _e2590) + _e2611);
                                                    phi_3402_ = false;
                                                } else {
                                                    phi_3401_ = f32();
                                                    phi_3402_ = true;
                                                }
                                                let _e2618 = phi_3401_;
                                                let _e2620 = phi_3402_;
                                                phi_3403_ = _e2618;
                                                phi_3404_ = _e2620;
                                            } else {
                                                phi_3403_ = f32();
                                                phi_3404_ = true;
                                            }
                                            let _e2622 = phi_3403_;
                                            let _e2624 = phi_3404_;
                                            phi_3405_ = _e2622;
                                            phi_3406_ = _e2624;
                                        } else {
                                            phi_3405_ = f32();
                                            phi_3406_ = true;
                                        }
                                        let _e2626 = phi_3405_;
                                        let _e2628 = phi_3406_;
                                        if _e2628 {
                                            if (_e2569 <= 0f) {
                                                if (_e2590 <= 0f) {
                                                    let _e2631 = (_e2611 <= 0f);
                                                    if _e2631 {
                                                    }
                                                    phi_3424_ = ((_e2569 + _e2590) + _e2611);
                                                    phi_3425_ = false;
                                                    phi_3426_ = _e2631;
                                                } else {
                                                    phi_3424_ = f32();
                                                    phi_3425_ = true;
                                                    phi_3426_ = false;
                                                }
                                                let _e2635 = phi_3424_;
                                                let _e2637 = phi_3425_;
                                                let _e2639 = phi_3426_;
                                                phi_3427_ = _e2635;
                                                phi_3428_ = _e2637;
                                                phi_3429_ = _e2639;
                                            } else {
                                                phi_3427_ = f32();
                                                phi_3428_ = true;
                                                phi_3429_ = false;
                                            }
                                            let _e2641 = phi_3427_;
                                            let _e2643 = phi_3428_;
                                            let _e2645 = phi_3429_;
                                            if _e2643 {
                                                phi_3433_ = false;
                                            } else {
                                                phi_3433_ = _e2645;
                                            }
                                            let _e2647 = phi_3433_;
                                            phi_3434_ = _e2641;
                                            phi_3435_ = _e2647;
                                        } else {
                                            phi_3434_ = _e2626;
                                            phi_3435_ = true;
                                        }
                                        let _e2649 = phi_3434_;
                                        let _e2651 = phi_3435_;
                                        if _e2651 {
                                            let _e2652 = (_e2649 == 0f);
                                            if _e2652 {
                                                phi_3751_ = lt_bvh_triangle_Intersection();
                                                phi_3752_ = false;
                                            } else {
                                                let _e2654 = triangles.member[(0u + _e2465)].v0_;
                                                let _e2656 = (_e2654.x - _e145);
                                                let _e2658 = (_e2654.y - _e147);
                                                let _e2660 = (_e2654.z - _e149);
                                                if (_e1851 == 0u) {
                                                    phi_3464_ = vec3<f32>(_e2658, _e2660, _e2656);
                                                } else {
                                                    if (_e1851 == 1u) {
                                                        phi_3463_ = vec3<f32>(_e2660, _e2656, _e2658);
                                                    } else {
                                                        phi_3463_ = (_e2654 - vec3<f32>(_e145, _e147, _e149));
                                                    }
                                                    let _e2668 = phi_3463_;
                                                    phi_3464_ = _e2668;
                                                }
                                                let _e2670 = phi_3464_;
                                                let _e2672 = triangles.member[(0u + _e2465)].v1_;
                                                let _e2674 = triangles.member[(0u + _e2465)].v0_;
                                                let _e2677 = (_e2672.x - _e2674.x);
                                                let _e2680 = (_e2672.y - _e2674.y);
                                                let _e2683 = (_e2672.z - _e2674.z);
                                                if (_e1851 == 0u) {
                                                    phi_3490_ = vec3<f32>(_e2680, _e2683, _e2677);
                                                } else {
                                                    if (_e1851 == 1u) {
                                                        phi_3489_ = vec3<f32>(_e2683, _e2677, _e2680);
                                                    } else {
                                                        phi_3489_ = (_e2672 - _e2674);
                                                    }
                                                    let _e2690 = phi_3489_;
                                                    phi_3490_ = _e2690;
                                                }
                                                let _e2692 = phi_3490_;
                                                let _e2694 = triangles.member[(0u + _e2465)].v2_;
                                                let _e2696 = triangles.member[(0u + _e2465)].v0_;
                                                let _e2699 = (_e2694.x - _e2696.x);
                                                let _e2702 = (_e2694.y - _e2696.y);
                                                let _e2705 = (_e2694.z - _e2696.z);
                                                if (_e1851 == 0u) {
                                                    phi_3516_ = vec3<f32>(_e2702, _e2705, _e2699);
                                                } else {
                                                    if (_e1851 == 1u) {
                                                        phi_3515_ = vec3<f32>(_e2705, _e2699, _e2702);
                                                    } else {
                                                        phi_3515_ = (_e2694 - _e2696);
                                                    }
                                                    let _e2712 = phi_3515_;
                                                    phi_3516_ = _e2712;
                                                }
                                                let _e2714 = phi_3516_;
                                                let _e2721 = ((_e2692.y * _e2714.z) - (_e2692.z * _e2714.y));
                                                let _e2728 = ((_e2692.z * _e2714.x) - (_e2692.x * _e2714.z));
                                                let _e2735 = ((_e2692.x * _e2714.y) - (_e2692.y * _e2714.x));
                                                let _e2749 = (((1f / _e1859.z) * (((_e2721 * _e2670.x) + (_e2728 * _e2670.y)) + (_e2735 * _e2670.z))) / (((_e2721 * _e1862) + (_e2728 * _e1865)) + _e2735));
                                                if (_e2749 > 0f) {
                                                    if (_e2749 < _e157) {
                                                        let _e2753 = triangles.member[(0u + _e2465)].v0_;
                                                        let _e2755 = triangles.member[(0u + _e2465)].v1_;
                                                        if (_e2753.x < _e2755.x) {
                                                            phi_3572_ = _e2753.x;
                                                        } else {
                                                            phi_3572_ = _e2755.x;
                                                        }
                                                        let _e2762 = phi_3572_;
                                                        if (_e2753.y < _e2755.y) {
                                                            phi_3581_ = _e2753.y;
                                                        } else {
                                                            phi_3581_ = _e2755.y;
                                                        }
                                                        let _e2769 = phi_3581_;
                                                        if (_e2753.z < _e2755.z) {
                                                            phi_3590_ = _e2753.z;
                                                        } else {
                                                            phi_3590_ = _e2755.z;
                                                        }
                                                        let _e2776 = phi_3590_;
                                                        let _e2778 = triangles.member[(0u + _e2465)].v2_;
                                                        if (_e2762 < _e2778.x) {
                                                            phi_3599_ = _e2762;
                                                        } else {
                                                            phi_3599_ = _e2778.x;
                                                        }
                                                        let _e2783 = phi_3599_;
                                                        if (_e2769 < _e2778.y) {
                                                            phi_3606_ = _e2769;
                                                        } else {
                                                            phi_3606_ = _e2778.y;
                                                        }
                                                        let _e2788 = phi_3606_;
                                                        if (_e2776 < _e2778.z) {
                                                            phi_3613_ = _e2776;
                                                        } else {
                                                            phi_3613_ = _e2778.z;
                                                        }
                                                        let _e2793 = phi_3613_;
                                                        let _e2795 = triangles.member[(0u + _e2465)].v0_;
                                                        let _e2797 = triangles.member[(0u + _e2465)].v1_;
                                                        if (_e2795.x > _e2797.x) {
                                                            phi_3626_ = _e2795.x;
                                                        } else {
                                                            phi_3626_ = _e2797.x;
                                                        }
                                                        let _e2804 = phi_3626_;
                                                        if (_e2795.y > _e2797.y) {
                                                            phi_3635_ = _e2795.y;
                                                        } else {
                                                            phi_3635_ = _e2797.y;
                                                        }
                                                        let _e2811 = phi_3635_;
                                                        if (_e2795.z > _e2797.z) {
                                                            phi_3644_ = _e2795.z;
                                                        } else {
                                                            phi_3644_ = _e2797.z;
                                                        }
                                                        let _e2818 = phi_3644_;
                                                        let _e2820 = triangles.member[(0u + _e2465)].v2_;
                                                        if (_e2804 > _e2820.x) {
                                                            phi_3653_ = _e2804;
                                                        } else {
                                                            phi_3653_ = _e2820.x;
                                                        }
                                                        let _e2825 = phi_3653_;
                                                        if (_e2811 > _e2820.y) {
                                                            phi_3660_ = _e2811;
                                                        } else {
                                                            phi_3660_ = _e2820.y;
                                                        }
                                                        let _e2830 = phi_3660_;
                                                        if (_e2818 > _e2820.z) {
                                                            phi_3667_ = _e2818;
                                                        } else {
                                                            phi_3667_ = _e2820.z;
                                                        }
                                                        let _e2835 = phi_3667_;
                                                        let _e2839 = ((_e2783 - _e145) * _e1776);
                                                        let _e2840 = ((_e2788 - _e147) * _e1786);
                                                        let _e2841 = ((_e2793 - _e149) * _e1796);
                                                        let _e2845 = ((_e2825 - _e145) * _e1776);
                                                        let _e2846 = ((_e2830 - _e147) * _e1786);
                                                        let _e2847 = ((_e2835 - _e149) * _e1796);
                                                        if (_e2839 < _e2845) {
                                                            phi_3684_ = _e2839;
                                                        } else {
                                                            phi_3684_ = _e2845;
                                                        }
                                                        let _e2850 = phi_3684_;
                                                        if (_e2840 < _e2846) {
                                                            phi_3689_ = _e2840;
                                                        } else {
                                                            phi_3689_ = _e2846;
                                                        }
                                                        let _e2853 = phi_3689_;
                                                        if (_e2841 < _e2847) {
                                                            phi_3694_ = _e2841;
                                                        } else {
                                                            phi_3694_ = _e2847;
                                                        }
                                                        let _e2856 = phi_3694_;
                                                        if (_e2839 > _e2845) {
                                                            phi_3702_ = _e2839;
                                                        } else {
                                                            phi_3702_ = _e2845;
                                                        }
                                                        let _e2862 = phi_3702_;
                                                        if (_e2840 > _e2846) {
                                                            phi_3707_ = _e2840;
                                                        } else {
                                                            phi_3707_ = _e2846;
                                                        }
                                                        let _e2865 = phi_3707_;
                                                        if (_e2841 > _e2847) {
                                                            phi_3712_ = _e2841;
                                                        } else {
                                                            phi_3712_ = _e2847;
                                                        }
                                                        let _e2868 = phi_3712_;
                                                        let _e2872 = core_intrinsics_maximum_number_nsz_f32_((_e2850 - _e1835), (_e2853 - _e1836));
                                                        let _e2873 = core_intrinsics_maximum_number_nsz_f32_(_e2872, (_e2856 - _e1837));
                                                        let _e2874 = core_intrinsics_minimum_number_nsz_f32_((_e2862 + _e1835), (_e2865 + _e1836));
                                                        let _e2875 = core_intrinsics_minimum_number_nsz_f32_(_e2874, (_e2868 + _e1837));
                                                        if (_e2873 > -300000000000000000000000000000000000000f) {
                                                            phi_3724_ = _e2873;
                                                        } else {
                                                            phi_3724_ = -300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2878 = phi_3724_;
                                                        if (_e2875 < 300000000000000000000000000000000000000f) {
                                                            phi_3729_ = _e2875;
                                                        } else {
                                                            phi_3729_ = 300000000000000000000000000000000000000f;
                                                        }
                                                        let _e2881 = phi_3729_;
                                                        if (_e2749 < _e2878) {
                                                            phi_3734_ = _e2878;
                                                        } else {
                                                            phi_3734_ = _e2749;
                                                        }
                                                        let _e2884 = phi_3734_;
                                                        if (_e2884 > _e2881) {
                                                            phi_3739_ = _e2881;
                                                        } else {
                                                            phi_3739_ = _e2884;
                                                        }
                                                        let _e2887 = phi_3739_;
                                                        phi_3744_ = lt_bvh_triangle_Intersection(_e2887, (_e2590 / _e2649), (_e2611 / _e2649), (_e2878 <= _e2881));
                                                        phi_3745_ = false;
                                                    } else {
                                                        phi_3744_ = lt_bvh_triangle_Intersection();
                                                        phi_3745_ = true;
                                                    }
                                                    let _e2893 = phi_3744_;
                                                    let _e2895 = phi_3745_;
                                                    phi_3746_ = _e2893;
                                                    phi_3747_ = _e2895;
                                                } else {
                                                    phi_3746_ = lt_bvh_triangle_Intersection();
                                                    phi_3747_ = true;
                                                }
                                                let _e2897 = phi_3746_;
                                                let _e2899 = phi_3747_;
                                                if _e2899 {
                                                }
                                                phi_3751_ = _e2897;
                                                phi_3752_ = _e2899;
                                            }
                                            let _e2901 = phi_3751_;
                                            let _e2903 = phi_3752_;
                                            phi_3753_ = _e2901;
                                            phi_3754_ = _e2652;
                                            phi_3755_ = _e2903;
                                        } else {
                                            phi_3753_ = lt_bvh_triangle_Intersection();
                                            phi_3754_ = true;
                                            phi_3755_ = false;
                                        }
                                        let _e2905 = phi_3753_;
                                        let _e2907 = phi_3754_;
                                        let _e2909 = phi_3755_;
                                        if _e2907 {
                                            phi_3759_ = true;
                                        } else {
                                            phi_3759_ = _e2909;
                                        }
                                        let _e2911 = phi_3759_;
                                        if _e2911 {
                                            phi_3763_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                        } else {
                                            phi_3763_ = _e2905;
                                        }
                                        let _e2913 = phi_3763_;
                                        if _e2913.is_hit {
                                            if (_e2913.t > 0f) {
                                                if (_e2913.t < _e157) {
                                                    let _e2920 = triangles.member[(0u + _e2465)].i0_;
                                                    if ((_e2920 & 2147483648u) == 0u) {
                                                        phi_3982_ = true;
                                                    } else {
                                                        if (_e2465 < _e92) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2929 = triangles.member[(0u + _e2465)].i0_;
                                                        let _e2930 = (_e2929 & 2147483647u);
                                                        let _e2932 = triangles.member[(0u + _e2465)].i1_;
                                                        let _e2934 = triangles.member[(0u + _e2465)].i2_;
                                                        if (_e2930 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2938 = vertices.member[(0u + _e2930)];
                                                        if (_e2932 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2942 = vertices.member[(0u + _e2932)];
                                                        if (_e2934 < _e105) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2946 = vertices.member[(0u + _e2934)];
                                                        let _e2947 = array<abi_Vertex, 3>(_e2938, _e2942, _e2946);
                                                        if (_e2947[0].material < _e108) {
                                                        } else {
                                                            return;
                                                        }
                                                        let _e2953 = materials.member[(0u + _e2947[0].material)];
                                                        if ((_e2953.flags & 1u) == 1u) {
                                                            let _e2958 = ((1f - _e2913.u) - _e2913.v);
                                                            if (_e2953.cutoff <= 0f) {
                                                                phi_3980_ = true;
                                                            } else {
                                                                let _e2985 = (_e2953.base_color.w * ((((f32((_e2947[0].color >> bitcast<u32>(24i))) * _e2958) + (f32((_e2947[1].color >> bitcast<u32>(24i))) * _e2913.u)) + (f32((_e2947[2].color >> bitcast<u32>(24i))) * _e2913.v)) * (1f / 255f)));
                                                                if (_e2953.alpha_size == 0u) {
                                                                    phi_3977_ = _e2985;
                                                                } else {
                                                                    local.offset = _e2953.alpha_offset;
                                                                    local.size = _e2953.alpha_size;
                                                                    local.flags = _e2953.flags;
                                                                    let _e3016 = _lt_shaders_texture_TextureView_quad((&local), (((_e2947[0].u * _e2958) + (_e2947[1].u * _e2913.u)) + (_e2947[2].u * _e2913.v)), (((_e2947[0].v * _e2958) + (_e2947[1].v * _e2913.u)) + (_e2947[2].v * _e2913.v)));
                                                                    let _e3020 = (_e3016.indices[0] >> bitcast<u32>(2i));
                                                                    if (_e3020 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3024 = alpha_texels.member[(0u + _e3020)];
                                                                    let _e3040 = (_e3016.indices[1] >> bitcast<u32>(2i));
                                                                    if (_e3040 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3044 = alpha_texels.member[(0u + _e3040)];
                                                                    let _e3061 = (_e3016.indices[2] >> bitcast<u32>(2i));
                                                                    if (_e3061 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3065 = alpha_texels.member[(0u + _e3061)];
                                                                    let _e3082 = (_e3016.indices[3] >> bitcast<u32>(2i));
                                                                    if (_e3082 < _e111) {
                                                                    } else {
                                                                        return;
                                                                    }
                                                                    let _e3086 = alpha_texels.member[(0u + _e3082)];
                                                                    phi_3977_ = (_e2985 * (((((f32(((_e3024 >> bitcast<u32>((((_e3016.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3016.weights.x) + ((f32(((_e3044 >> bitcast<u32>((((_e3016.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3016.weights.y)) + ((f32(((_e3065 >> bitcast<u32>((((_e3016.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3016.weights.z)) + ((f32(((_e3086 >> bitcast<u32>((((_e3016.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e3016.weights.w)));
                                                                }
                                                                let _e3102 = phi_3977_;
                                                                phi_3980_ = (_e3102 >= _e2953.cutoff);
                                                            }
                                                            let _e3106 = phi_3980_;
                                                            phi_3981_ = _e3106;
                                                        } else {
                                                            phi_3981_ = false;
                                                        }
                                                        let _e3108 = phi_3981_;
                                                        phi_3982_ = _e3108;
                                                    }
                                                    let _e3110 = phi_3982_;
                                                    if _e3110 {
                                                        phi_3986_ = false;
                                                    } else {
                                                        phi_3986_ = true;
                                                    }
                                                    let _e3112 = phi_3986_;
                                                    phi_3987_ = _e3110;
                                                    phi_3988_ = _e3110;
                                                    phi_3989_ = _e3112;
                                                } else {
                                                    phi_3987_ = bool();
                                                    phi_3988_ = _e2456;
                                                    phi_3989_ = true;
                                                }
                                                let _e3114 = phi_3987_;
                                                let _e3116 = phi_3988_;
                                                let _e3118 = phi_3989_;
                                                phi_3990_ = _e3114;
                                                phi_3991_ = _e3116;
                                                phi_3992_ = _e3118;
                                            } else {
                                                phi_3990_ = bool();
                                                phi_3991_ = _e2456;
                                                phi_3992_ = true;
                                            }
                                            let _e3120 = phi_3990_;
                                            let _e3122 = phi_3991_;
                                            let _e3124 = phi_3992_;
                                            phi_3993_ = _e3120;
                                            phi_3994_ = _e3122;
                                            phi_3995_ = _e3124;
                                        } else {
                                            phi_3993_ = bool();
                                            phi_3994_ = _e2456;
                                            phi_3995_ = true;
                                        }
                                        let _e3126 = phi_3993_;
                                        let _e3128 = phi_3994_;
                                        let _e3130 = phi_3995_;
                                        if _e3130 {
                                        }
                                        phi_3193_ = (_e2454 & (_e2454 - 1u));
                                        phi_3196_ = _e3128;
                                        phi_3999_ = _e3126;
                                        phi_4000_ = _e3130;
                                    }
                                    let _e3132 = phi_3193_;
                                    let _e3134 = phi_3196_;
                                    let _e3136 = phi_3999_;
                                    let _e3138 = phi_4000_;
                                    local_17 = _e3136;
                                    continue;
                                    continuing {
                                        phi_3192_ = _e3132;
                                        phi_3195_ = _e3134;
                                        break if !(_e3138);
                                    }
                                }
                                let _e3141 = local_9;
                                if _e3141 {
                                    let _e3143 = local_1.group_mask;
                                    if ((_e3143 & 4278190080u) == 0u) {
                                        let _e3147 = local_1.len;
                                        if (_e3147 == 0u) {
                                            phi_4042_ = false;
                                        } else {
                                            let _e3151 = local_1.len;
                                            local_1.len = (_e3151 - 1u);
                                            let _e3154 = local_1.len;
                                            if (_e3154 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3159 = local_1.first[(0u + _e3154)];
                                            local_1.group = _e3159;
                                            let _e3162 = local_1.len;
                                            if (_e3162 < 32u) {
                                            } else {
                                                return;
                                            }
                                            let _e3167 = local_1.mask[(0u + _e3162)];
                                            local_1.group_mask = _e3167;
                                            phi_4042_ = true;
                                        }
                                        let _e3170 = phi_4042_;
                                        phi_4043_ = _e3170;
                                    } else {
                                        phi_4043_ = true;
                                    }
                                    let _e3172 = phi_4043_;
                                    if _e3172 {
                                        let _e3174 = local_1.group_mask;
                                        let _e3180 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e3174)), 32u, (_e3174 == 0u)));
                                        let _e3184 = local_1.group_mask;
                                        let _e3198 = local_1.group_mask;
                                        local_1.group_mask = (_e3198 & ~((1u << bitcast<u32>((_e3180 & 31u)))));
                                        let _e3201 = local_1.group;
                                        phi_4074_ = (_e3201 + countOneBits(((_e3184 & ~((4294967295u << bitcast<u32>((((_e3180 - 24u) ^ _e1878) & 31u))))) & 255u)));
                                    } else {
                                        phi_4074_ = 4294967295u;
                                    }
                                    let _e3204 = phi_4074_;
                                    phi_4075_ = _e3204;
                                } else {
                                    phi_4075_ = u32();
                                }
                                let _e3206 = phi_4075_;
                                phi_2861_ = _e3206;
                                let _e3653 = local_16;
                                phi_2864_ = _e3653;
                                let _e3656 = local_17;
                                phi_4076_ = _e3656;
                                let _e3659 = local_18;
                                phi_4077_ = _e3659;
                                phi_4078_ = false;
                            } else {
                                phi_2861_ = u32();
                                phi_2864_ = bool();
                                phi_4076_ = bool();
                                phi_4077_ = false;
                                phi_4078_ = true;
                            }
                            let _e3208 = phi_2861_;
                            let _e3210 = phi_2864_;
                            let _e3212 = phi_4076_;
                            let _e3214 = phi_4077_;
                            let _e3216 = phi_4078_;
                            local_10 = _e3216;
                            local_19 = _e3212;
                            continue;
                            continuing {
                                phi_2860_ = _e3208;
                                phi_2863_ = _e3210;
                                break if !(_e3214);
                            }
                        }
                        let _e3219 = local_10;
                        if _e3219 {
                            phi_4082_ = false;
                        } else {
                            phi_4082_ = true;
                        }
                        let _e3221 = phi_4082_;
                        if _e3221 {
                            let _e3665 = local_19;
                            phi_4086_ = _e3665;
                        } else {
                            let _e3667 = local_20;
                            phi_4086_ = _e3667;
                        }
                        let _e3223 = phi_4086_;
                        phi_4087_ = _e3223;
                    }
                    let _e3225 = phi_4087_;
                    phi_4088_ = _e3225;
                    phi_4089_ = _e1700;
                } else {
                    phi_4088_ = bool();
                    phi_4089_ = true;
                }
                let _e3227 = phi_4088_;
                let _e3229 = phi_4089_;
                if _e3229 {
                    phi_4093_ = false;
                } else {
                    phi_4093_ = _e3227;
                }
                let _e3231 = phi_4093_;
                phi_4094_ = _e3231;
            }
            let _e3233 = phi_4094_;
            phi_4095_ = _e3233;
        } else {
            phi_4095_ = false;
        }
        let _e3235 = phi_4095_;
        if _e3235 {
            phi_4099_ = 0f;
        } else {
            phi_4099_ = 1f;
        }
        let _e3237 = phi_4099_;
        if (_e124 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e124)] = _e3237;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_light_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
