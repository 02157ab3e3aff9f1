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

struct type_29 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_33 {
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

struct type_37 {
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

struct type_50 {
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_56 {
    member: abi_ShadowParams,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
@group(0) @binding(4) 
var<storage, read_write> visibility: type_17;
@group(0) @binding(0) 
var<uniform> p: type_56;
@group(0) @binding(2) 
var<storage> nodes: type_50;
@group(0) @binding(3) 
var<storage> triangles: type_29;
@group(0) @binding(5) 
var<storage> list: type_13;
@group(0) @binding(6) 
var<storage> vertices: type_33;
@group(0) @binding(7) 
var<storage> materials: type_37;
@group(0) @binding(8) 
var<storage> alpha_texels: type_13;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_222_: f32;
    var phi_227_: f32;
    var phi_228_: bool;
    var phi_229_: f32;
    var phi_230_: bool;
    var phi_234_: f32;
    var phi_260_: f32;
    var phi_265_: f32;
    var phi_266_: bool;
    var phi_267_: f32;
    var phi_268_: bool;
    var phi_272_: f32;
    var phi_280_: f32;
    var phi_281_: f32;
    var phi_282_: f32;
    var phi_291_: f32;
    var phi_292_: f32;
    var phi_310_: u32;
    var phi_324_: u32;
    var phi_331_: u32;
    var phi_336_: u32;
    var phi_342_: u32;
    var phi_347_: u32;
    var phi_349_: texture_Axis;
    var phi_377_: f32;
    var phi_382_: f32;
    var phi_383_: bool;
    var phi_384_: f32;
    var phi_385_: bool;
    var phi_389_: f32;
    var phi_415_: f32;
    var phi_420_: f32;
    var phi_421_: bool;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_427_: f32;
    var phi_435_: f32;
    var phi_436_: f32;
    var phi_437_: f32;
    var phi_446_: f32;
    var phi_447_: f32;
    var phi_465_: u32;
    var phi_479_: u32;
    var phi_486_: u32;
    var phi_491_: u32;
    var phi_497_: u32;
    var phi_502_: u32;
    var phi_504_: texture_Axis;

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
                phi_222_ = 1f;
            } else {
                phi_222_ = 0f;
            }
            let _e100 = phi_222_;
            if (param_1 < 8388608f) {
                phi_227_ = (_e97 - _e100);
                phi_228_ = false;
            } else {
                phi_227_ = f32();
                phi_228_ = true;
            }
            let _e103 = phi_227_;
            let _e105 = phi_228_;
            phi_229_ = _e103;
            phi_230_ = _e105;
        } else {
            phi_229_ = f32();
            phi_230_ = true;
        }
        let _e107 = phi_229_;
        let _e109 = phi_230_;
        if _e109 {
            phi_234_ = param_1;
        } else {
            phi_234_ = _e107;
        }
        let _e111 = phi_234_;
        phi_282_ = (param_1 - _e111);
    } else {
        if (_e84 == 1u) {
            let _e114 = (param_1 * 0.5f);
            if (_e114 > -8388608f) {
                let _e126 = f32(select(0i, select(select(i32(_e114), i32(-2147483648), (_e114 < bitcast<f32>(3472883712u))), 2147483647i, (_e114 > bitcast<f32>(1325400063u))), (_e114 == _e114)));
                if (_e126 > _e114) {
                    phi_260_ = 1f;
                } else {
                    phi_260_ = 0f;
                }
                let _e129 = phi_260_;
                if (_e114 < 8388608f) {
                    phi_265_ = (_e126 - _e129);
                    phi_266_ = false;
                } else {
                    phi_265_ = f32();
                    phi_266_ = true;
                }
                let _e132 = phi_265_;
                let _e134 = phi_266_;
                phi_267_ = _e132;
                phi_268_ = _e134;
            } else {
                phi_267_ = f32();
                phi_268_ = true;
            }
            let _e136 = phi_267_;
            let _e138 = phi_268_;
            if _e138 {
                phi_272_ = _e114;
            } else {
                phi_272_ = _e136;
            }
            let _e140 = phi_272_;
            let _e142 = (param_1 - (2f * _e140));
            if (_e142 > 1f) {
                phi_280_ = (2f - _e142);
            } else {
                phi_280_ = _e142;
            }
            let _e146 = phi_280_;
            phi_281_ = _e146;
        } else {
            phi_281_ = param_1;
        }
        let _e148 = phi_281_;
        phi_282_ = _e148;
    }
    let _e150 = phi_282_;
    if (_e150 > 0f) {
        if (_e150 < 1f) {
            phi_291_ = _e150;
        } else {
            phi_291_ = 1f;
        }
        let _e154 = phi_291_;
        phi_292_ = _e154;
    } else {
        phi_292_ = 0f;
    }
    let _e156 = phi_292_;
    let _e157 = (_e71 - 1u);
    let _e159 = (_e156 * f32(_e71));
    if _e79 {
        let _e166 = select(select(u32(_e159), 0u, (_e159 < bitcast<f32>(0u))), 4294967295u, (_e159 > bitcast<f32>(1333788671u)));
        if (_e157 < _e166) {
            phi_310_ = _e157;
        } else {
            phi_310_ = _e166;
        }
        let _e169 = phi_310_;
        phi_349_ = texture_Axis(_e169, _e169, 0f);
    } else {
        let _e171 = (_e159 + 0.5f);
        let _e178 = select(select(u32(_e171), 0u, (_e171 < bitcast<f32>(0u))), 4294967295u, (_e171 > bitcast<f32>(1333788671u)));
        if (_e71 < _e178) {
            phi_324_ = _e71;
        } else {
            phi_324_ = _e178;
        }
        let _e181 = phi_324_;
        if (_e84 == 0u) {
            phi_331_ = _e157;
        } else {
            phi_331_ = 0u;
        }
        let _e186 = phi_331_;
        if (_e84 == 0u) {
            phi_336_ = 0u;
        } else {
            phi_336_ = _e157;
        }
        let _e189 = phi_336_;
        if (_e181 == 0u) {
            phi_342_ = _e186;
        } else {
            phi_342_ = (_e181 - 1u);
        }
        let _e193 = phi_342_;
        if (_e181 > _e157) {
            phi_347_ = _e189;
        } else {
            phi_347_ = _e181;
        }
        let _e196 = phi_347_;
        phi_349_ = texture_Axis(_e193, _e196, (_e171 - f32(_e181)));
    }
    let _e199 = phi_349_;
    let _e201 = (*param).flags;
    let _e204 = ((_e201 >> bitcast<u32>(6u)) & 3u);
    if (_e204 == 0u) {
        if (param_2 > -8388608f) {
            let _e217 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e217 > param_2) {
                phi_377_ = 1f;
            } else {
                phi_377_ = 0f;
            }
            let _e220 = phi_377_;
            if (param_2 < 8388608f) {
                phi_382_ = (_e217 - _e220);
                phi_383_ = false;
            } else {
                phi_382_ = f32();
                phi_383_ = true;
            }
            let _e223 = phi_382_;
            let _e225 = phi_383_;
            phi_384_ = _e223;
            phi_385_ = _e225;
        } else {
            phi_384_ = f32();
            phi_385_ = true;
        }
        let _e227 = phi_384_;
        let _e229 = phi_385_;
        if _e229 {
            phi_389_ = param_2;
        } else {
            phi_389_ = _e227;
        }
        let _e231 = phi_389_;
        phi_437_ = (param_2 - _e231);
    } else {
        if (_e204 == 1u) {
            let _e234 = (param_2 * 0.5f);
            if (_e234 > -8388608f) {
                let _e246 = f32(select(0i, select(select(i32(_e234), i32(-2147483648), (_e234 < bitcast<f32>(3472883712u))), 2147483647i, (_e234 > bitcast<f32>(1325400063u))), (_e234 == _e234)));
                if (_e246 > _e234) {
                    phi_415_ = 1f;
                } else {
                    phi_415_ = 0f;
                }
                let _e249 = phi_415_;
                if (_e234 < 8388608f) {
                    phi_420_ = (_e246 - _e249);
                    phi_421_ = false;
                } else {
                    phi_420_ = f32();
                    phi_421_ = true;
                }
                let _e252 = phi_420_;
                let _e254 = phi_421_;
                phi_422_ = _e252;
                phi_423_ = _e254;
            } else {
                phi_422_ = f32();
                phi_423_ = true;
            }
            let _e256 = phi_422_;
            let _e258 = phi_423_;
            if _e258 {
                phi_427_ = _e234;
            } else {
                phi_427_ = _e256;
            }
            let _e260 = phi_427_;
            let _e262 = (param_2 - (2f * _e260));
            if (_e262 > 1f) {
                phi_435_ = (2f - _e262);
            } else {
                phi_435_ = _e262;
            }
            let _e266 = phi_435_;
            phi_436_ = _e266;
        } else {
            phi_436_ = param_2;
        }
        let _e268 = phi_436_;
        phi_437_ = _e268;
    }
    let _e270 = phi_437_;
    if (_e270 > 0f) {
        if (_e270 < 1f) {
            phi_446_ = _e270;
        } else {
            phi_446_ = 1f;
        }
        let _e274 = phi_446_;
        phi_447_ = _e274;
    } else {
        phi_447_ = 0f;
    }
    let _e276 = phi_447_;
    let _e277 = (_e75 - 1u);
    let _e279 = (_e276 * f32(_e75));
    if _e79 {
        let _e286 = select(select(u32(_e279), 0u, (_e279 < bitcast<f32>(0u))), 4294967295u, (_e279 > bitcast<f32>(1333788671u)));
        if (_e277 < _e286) {
            phi_465_ = _e277;
        } else {
            phi_465_ = _e286;
        }
        let _e289 = phi_465_;
        phi_504_ = texture_Axis(_e289, _e289, 0f);
    } else {
        let _e291 = (_e279 + 0.5f);
        let _e298 = select(select(u32(_e291), 0u, (_e291 < bitcast<f32>(0u))), 4294967295u, (_e291 > bitcast<f32>(1333788671u)));
        if (_e75 < _e298) {
            phi_479_ = _e75;
        } else {
            phi_479_ = _e298;
        }
        let _e301 = phi_479_;
        if (_e204 == 0u) {
            phi_486_ = _e277;
        } else {
            phi_486_ = 0u;
        }
        let _e306 = phi_486_;
        if (_e204 == 0u) {
            phi_491_ = 0u;
        } else {
            phi_491_ = _e277;
        }
        let _e309 = phi_491_;
        if (_e301 == 0u) {
            phi_497_ = _e306;
        } else {
            phi_497_ = (_e301 - 1u);
        }
        let _e313 = phi_497_;
        if (_e301 > _e277) {
            phi_502_ = _e309;
        } else {
            phi_502_ = _e301;
        }
        let _e316 = phi_502_;
        phi_504_ = texture_Axis(_e313, _e316, (_e291 - f32(_e301)));
    }
    let _e319 = phi_504_;
    let _e323 = (*param).offset;
    let _e330 = (*param).offset;
    let _e337 = (*param).offset;
    let _e344 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e323 + (_e319.low * _e71)) + _e199.low), ((_e330 + (_e319.low * _e71)) + _e199.high), ((_e337 + (_e319.high * _e71)) + _e199.low), ((_e344 + (_e319.high * _e71)) + _e199.high)), vec4<f32>(((1f - _e199.fraction) * (1f - _e319.fraction)), (_e199.fraction * (1f - _e319.fraction)), ((1f - _e199.fraction) * _e319.fraction), (_e199.fraction * _e319.fraction)));
}

fn core_intrinsics_maximum_number_nsz_f32_(param_3: f32, param_4: f32) -> f32 {
    var phi_563_: bool;
    var phi_567_: f32;

    if (param_3 != param_3) {
        phi_563_ = true;
    } else {
        let _e69 = (param_4 >= param_3);
        if _e69 {
        }
        phi_563_ = _e69;
    }
    let _e71 = phi_563_;
    if _e71 {
        phi_567_ = param_4;
    } else {
        phi_567_ = param_3;
    }
    let _e73 = phi_567_;
    return _e73;
}

fn core_intrinsics_minimum_number_nsz_f32_(param_5: f32, param_6: f32) -> f32 {
    var phi_579_: bool;
    var phi_583_: f32;

    if (param_5 != param_5) {
        phi_579_ = true;
    } else {
        let _e69 = (param_6 <= param_5);
        if _e69 {
        }
        phi_579_ = _e69;
    }
    let _e71 = phi_579_;
    if _e71 {
        phi_583_ = param_6;
    } else {
        phi_583_ = param_5;
    }
    let _e73 = phi_583_;
    return _e73;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: lt_bvh_traverse_Stack;
    var phi_673_: f32;
    var phi_728_: bool;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_734_: bool;
    var phi_735_: bool;
    var phi_736_: bool;
    var phi_737_: bool;
    var phi_738_: bool;
    var phi_739_: bool;
    var phi_740_: bool;
    var phi_741_: bool;
    var phi_742_: bool;
    var phi_743_: bool;
    var phi_744_: bool;
    var phi_745_: bool;
    var phi_746_: bool;
    var phi_747_: bool;
    var phi_748_: bool;
    var phi_749_: bool;
    var phi_750_: bool;
    var phi_751_: bool;
    var phi_755_: bool;
    var phi_759_: bool;
    var phi_829_: f32;
    var phi_836_: f32;
    var phi_843_: f32;
    var phi_850_: f32;
    var phi_857_: f32;
    var phi_864_: f32;
    var phi_881_: f32;
    var phi_886_: f32;
    var phi_891_: f32;
    var phi_919_: bool;
    var phi_920_: bool;
    var phi_928_: u32;
    var phi_929_: u32;
    var phi_940_: vec3<f32>;
    var phi_941_: vec3<f32>;
    var phi_954_: u32;
    var phi_959_: u32;
    var phi_964_: u32;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1110_: u32;
    var phi_1112_: u32;
    var phi_1193_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1220_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1247_: u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_;
    var phi_1253_: u32;
    var phi_1256_: u32;
    var phi_1270_: u32;
    var phi_1280_: u32;
    var phi_1290_: u32;
    var phi_1308_: u32;
    var phi_1318_: u32;
    var phi_1328_: u32;
    var phi_1364_: u32;
    var phi_1377_: u32;
    var phi_1382_: u32;
    var phi_1383_: u32;
    var phi_1384_: u32;
    var phi_1254_: u32;
    var phi_1257_: u32;
    var local_2: u32;
    var local_3: u32;
    var local_4: u32;
    var phi_1442_: u32;
    var phi_1487_: vec3<f32>;
    var phi_1488_: vec3<f32>;
    var phi_1519_: vec3<f32>;
    var phi_1520_: vec3<f32>;
    var phi_1551_: vec3<f32>;
    var phi_1552_: vec3<f32>;
    var phi_1572_: bool;
    var phi_1573_: bool;
    var phi_1577_: f32;
    var phi_1578_: f32;
    var phi_1579_: f32;
    var phi_1580_: f32;
    var phi_1588_: f32;
    var phi_1598_: bool;
    var phi_1599_: bool;
    var phi_1603_: f32;
    var phi_1604_: f32;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1614_: f32;
    var phi_1624_: bool;
    var phi_1625_: bool;
    var phi_1629_: f32;
    var phi_1630_: f32;
    var phi_1631_: f32;
    var phi_1632_: f32;
    var phi_1640_: f32;
    var phi_1655_: f32;
    var phi_1656_: bool;
    var phi_1657_: f32;
    var phi_1658_: bool;
    var phi_1659_: f32;
    var phi_1660_: bool;
    var phi_1678_: f32;
    var phi_1679_: bool;
    var phi_1680_: bool;
    var phi_1681_: f32;
    var phi_1682_: bool;
    var phi_1683_: bool;
    var phi_1687_: bool;
    var phi_1688_: f32;
    var phi_1689_: bool;
    var phi_1723_: f32;
    var phi_1732_: f32;
    var phi_1741_: f32;
    var phi_1750_: f32;
    var phi_1757_: f32;
    var phi_1764_: f32;
    var phi_1777_: f32;
    var phi_1786_: f32;
    var phi_1795_: f32;
    var phi_1804_: f32;
    var phi_1811_: f32;
    var phi_1818_: f32;
    var phi_1835_: f32;
    var phi_1840_: f32;
    var phi_1845_: f32;
    var phi_1853_: f32;
    var phi_1858_: f32;
    var phi_1863_: f32;
    var phi_1875_: f32;
    var phi_1880_: f32;
    var phi_1885_: f32;
    var phi_1890_: f32;
    var phi_1895_: lt_bvh_triangle_Intersection;
    var phi_1896_: bool;
    var phi_1897_: lt_bvh_triangle_Intersection;
    var phi_1898_: bool;
    var phi_1902_: lt_bvh_triangle_Intersection;
    var phi_1903_: bool;
    var phi_1904_: lt_bvh_triangle_Intersection;
    var phi_1905_: bool;
    var phi_1906_: bool;
    var phi_1910_: bool;
    var phi_1914_: lt_bvh_triangle_Intersection;
    var phi_2128_: f32;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2136_: bool;
    var phi_2137_: bool;
    var phi_2138_: bool;
    var phi_2139_: bool;
    var phi_2140_: bool;
    var phi_2141_: bool;
    var phi_2142_: bool;
    var phi_2143_: bool;
    var phi_2144_: bool;
    var phi_2145_: bool;
    var phi_2146_: bool;
    var phi_2147_: bool;
    var phi_2151_: bool;
    var phi_2152_: bool;
    var phi_1443_: u32;
    var phi_2153_: bool;
    var phi_2154_: bool;
    var phi_2155_: bool;
    var local_5: bool;
    var phi_2197_: bool;
    var phi_2198_: bool;
    var phi_2229_: u32;
    var phi_2230_: u32;
    var phi_2231_: bool;
    var phi_2232_: bool;
    var phi_1113_: u32;
    var phi_2233_: bool;
    var phi_2234_: bool;
    var phi_2235_: bool;
    var phi_2236_: bool;
    var local_6: bool;
    var phi_2240_: bool;
    var phi_2241_: bool;
    var phi_2245_: bool;
    var phi_2249_: bool;
    var phi_2250_: bool;
    var phi_2251_: bool;
    var phi_2252_: bool;
    var phi_2256_: bool;
    var phi_2260_: f32;
    var local_7: bool;
    var local_8: bool;
    var local_9: bool;
    var local_10: bool;
    var local_11: bool;

    let _e68 = id_1;
    let _e75 = arrayLength((&nodes.member));
    let _e78 = arrayLength((&triangles.member));
    let _e84 = arrayLength((&list.member));
    let _e87 = arrayLength((&vertices.member));
    let _e93 = arrayLength((&alpha_texels.member));
    let _e97 = ((_e68.y * 2097152u) + _e68.x);
    if (3u < _e84) {
    } else {
        return;
    }
    let _e100 = list.member[3u];
    if (_e97 < _e100) {
        let _e102 = (_e97 + 4u);
        if (_e102 < _e84) {
        } else {
            return;
        }
        let _e106 = list.member[(0u + _e102)];
        if (_e106 < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e111 = p.member.light;
        let _e113 = samples.member[(0u + _e106)].position;
        let _e115 = samples.member[(0u + _e106)].normal;
        let _e117 = samples.member[(0u + _e106)].magnitude;
        let _e119 = ((8f / 8388608f) * _e117);
        let _e127 = (_e113.x + (_e115.x * _e119));
        let _e129 = (_e113.y + (_e115.y * _e119));
        let _e131 = (_e113.z + (_e115.z * _e119));
        if (_e111.w == 0f) {
            phi_673_ = 300000000000000000000000000000000000000f;
        } else {
            phi_673_ = 1f;
        }
        let _e135 = phi_673_;
        let _e143 = (_e111.x - (_e127 * _e111.w));
        let _e144 = (_e111.y - (_e129 * _e111.w));
        let _e145 = (_e111.z - (_e131 * _e111.w));
        let _e150 = abs(_e143);
        let _e151 = abs(_e144);
        let _e152 = abs(_e145);
        if (abs(_e127) < 1000000000000000f) {
            if (abs(_e129) < 1000000000000000f) {
                if (abs(_e131) < 1000000000000000f) {
                    if (_e150 < 1000000000000000f) {
                        if (_e151 < 1000000000000000f) {
                            if (_e152 < 1000000000000000f) {
                                if (_e150 > 0f) {
                                    phi_729_ = bool();
                                    phi_730_ = true;
                                } else {
                                    let _e160 = (_e151 > 0f);
                                    if _e160 {
                                        phi_728_ = bool();
                                    } else {
                                        phi_728_ = (_e152 > 0f);
                                    }
                                    let _e163 = phi_728_;
                                    phi_729_ = _e163;
                                    phi_730_ = _e160;
                                }
                                let _e165 = phi_729_;
                                let _e167 = phi_730_;
                                if _e167 {
                                    phi_734_ = true;
                                } else {
                                    phi_734_ = _e165;
                                }
                                let _e169 = phi_734_;
                                phi_735_ = _e169;
                                phi_736_ = false;
                            } else {
                                phi_735_ = bool();
                                phi_736_ = true;
                            }
                            let _e171 = phi_735_;
                            let _e173 = phi_736_;
                            phi_737_ = _e171;
                            phi_738_ = false;
                            phi_739_ = _e173;
                        } else {
                            phi_737_ = bool();
                            phi_738_ = true;
                            phi_739_ = false;
                        }
                        let _e175 = phi_737_;
                        let _e177 = phi_738_;
                        let _e179 = phi_739_;
                        phi_740_ = _e175;
                        phi_741_ = _e177;
                        phi_742_ = _e179;
                    } else {
                        phi_740_ = bool();
                        phi_741_ = true;
                        phi_742_ = false;
                    }
                    let _e181 = phi_740_;
                    let _e183 = phi_741_;
                    let _e185 = phi_742_;
                    phi_743_ = _e181;
                    phi_744_ = _e183;
                    phi_745_ = _e185;
                } else {
                    phi_743_ = bool();
                    phi_744_ = true;
                    phi_745_ = false;
                }
                let _e187 = phi_743_;
                let _e189 = phi_744_;
                let _e191 = phi_745_;
                phi_746_ = _e187;
                phi_747_ = _e189;
                phi_748_ = _e191;
            } else {
                phi_746_ = bool();
                phi_747_ = true;
                phi_748_ = false;
            }
            let _e193 = phi_746_;
            let _e195 = phi_747_;
            let _e197 = phi_748_;
            phi_749_ = _e193;
            phi_750_ = _e195;
            phi_751_ = _e197;
        } else {
            phi_749_ = bool();
            phi_750_ = true;
            phi_751_ = false;
        }
        let _e199 = phi_749_;
        let _e201 = phi_750_;
        let _e203 = phi_751_;
        if _e201 {
            phi_755_ = true;
        } else {
            phi_755_ = _e203;
        }
        let _e205 = phi_755_;
        if _e205 {
            phi_759_ = false;
        } else {
            phi_759_ = _e199;
        }
        let _e207 = phi_759_;
        if _e207 {
            let _e208 = (0u >= _e75);
            if _e208 {
                phi_2250_ = bool();
            } else {
                if (0u < _e75) {
                } else {
                    return;
                }
                let _e214 = nodes.member[(0u + 0u)].frame[0u];
                let _e218 = nodes.member[(0u + 0u)].frame[1u];
                let _e222 = nodes.member[(0u + 0u)].frame[2u];
                let _e226 = nodes.member[(0u + 0u)].frame[0u];
                let _e230 = nodes.member[(0u + 0u)].frame[1u];
                let _e234 = nodes.member[(0u + 0u)].frame[2u];
                let _e238 = nodes.member[(0u + 0u)].frame[3u];
                let _e272 = core_intrinsics_maximum_number_nsz_f32_(abs(_e143), abs(_e144));
                let _e273 = core_intrinsics_maximum_number_nsz_f32_(_e272, abs(_e145));
                let _e274 = (_e273 * 0.0000000000009094947f);
                if (abs(_e143) < _e274) {
                    phi_829_ = _e274;
                } else {
                    phi_829_ = abs(_e143);
                }
                let _e279 = phi_829_;
                if (_e143 < 0f) {
                    phi_836_ = (-1f / _e279);
                } else {
                    phi_836_ = (1f / _e279);
                }
                let _e284 = phi_836_;
                if (abs(_e144) < _e274) {
                    phi_843_ = _e274;
                } else {
                    phi_843_ = abs(_e144);
                }
                let _e289 = phi_843_;
                if (_e144 < 0f) {
                    phi_850_ = (-1f / _e289);
                } else {
                    phi_850_ = (1f / _e289);
                }
                let _e294 = phi_850_;
                if (abs(_e145) < _e274) {
                    phi_857_ = _e274;
                } else {
                    phi_857_ = abs(_e145);
                }
                let _e299 = phi_857_;
                if (_e145 < 0f) {
                    phi_864_ = (-1f / _e299);
                } else {
                    phi_864_ = (1f / _e299);
                }
                let _e304 = phi_864_;
                let _e308 = abs((bitcast<f32>(_e214) - _e127));
                let _e309 = abs((bitcast<f32>(_e218) - _e129));
                let _e310 = abs((bitcast<f32>(_e222) - _e131));
                let _e314 = abs(((bitcast<f32>(_e226) + (bitcast<f32>((((_e238 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e127));
                let _e315 = abs(((bitcast<f32>(_e230) + (bitcast<f32>((((_e238 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e129));
                let _e316 = abs(((bitcast<f32>(_e234) + (bitcast<f32>((((_e238 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * 255f)) - _e131));
                if (_e308 > _e314) {
                    phi_881_ = _e308;
                } else {
                    phi_881_ = _e314;
                }
                let _e319 = phi_881_;
                if (_e309 > _e315) {
                    phi_886_ = _e309;
                } else {
                    phi_886_ = _e315;
                }
                let _e322 = phi_886_;
                if (_e310 > _e316) {
                    phi_891_ = _e310;
                } else {
                    phi_891_ = _e316;
                }
                let _e325 = phi_891_;
                let _e326 = core_intrinsics_maximum_number_nsz_f32_(_e319, _e322);
                let _e327 = core_intrinsics_maximum_number_nsz_f32_(_e326, _e325);
                let _e331 = (_e327 * 0.0000019073486f);
                let _e332 = (abs(_e284) * _e331);
                let _e333 = (abs(_e294) * _e331);
                let _e334 = (abs(_e304) * _e331);
                let _e338 = (_e327 * 0.0000009536743f);
                let _e339 = (abs(_e284) * _e338);
                let _e340 = (abs(_e294) * _e338);
                let _e341 = (abs(_e304) * _e338);
                let _e342 = abs(_e143);
                let _e343 = abs(_e144);
                let _e344 = abs(_e145);
                if (_e342 >= _e343) {
                    if (_e342 >= _e344) {
                        phi_919_ = false;
                    } else {
                        phi_919_ = true;
                    }
                    let _e348 = phi_919_;
                    phi_920_ = _e348;
                } else {
                    phi_920_ = true;
                }
                let _e350 = phi_920_;
                if _e350 {
                    if (_e343 >= _e344) {
                        phi_928_ = 1u;
                    } else {
                        phi_928_ = 2u;
                    }
                    let _e353 = phi_928_;
                    phi_929_ = _e353;
                } else {
                    phi_929_ = 0u;
                }
                let _e355 = phi_929_;
                if (_e355 == 0u) {
                    phi_941_ = vec3<f32>(_e144, _e145, _e143);
                } else {
                    if (_e355 == 1u) {
                        phi_940_ = vec3<f32>(_e145, _e143, _e144);
                    } else {
                        phi_940_ = vec3<f32>(_e143, _e144, _e145);
                    }
                    let _e361 = phi_940_;
                    phi_941_ = _e361;
                }
                let _e363 = phi_941_;
                let _e366 = (_e363.x / _e363.z);
                let _e369 = (_e363.y / _e363.z);
                let _e371 = (1f / _e363.z);
                if (_e284 < 0f) {
                    phi_954_ = 0u;
                } else {
                    phi_954_ = 1u;
                }
                let _e374 = phi_954_;
                if (_e294 < 0f) {
                    phi_959_ = 0u;
                } else {
                    phi_959_ = 2u;
                }
                let _e377 = phi_959_;
                if (_e304 < 0f) {
                    phi_964_ = 0u;
                } else {
                    phi_964_ = 4u;
                }
                let _e380 = phi_964_;
                let _e382 = ((_e374 | _e377) | _e380);
                let _e383 = lt_bvh_traverse_Stack(array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), array<u32, 32>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u), 0u, 0u, 2147483648u);
                local_1 = lt_bvh_traverse_Stack(array<u32, 32>(_e383.first[0], _e383.first[1], _e383.first[2], _e383.first[3], _e383.first[4], _e383.first[5], _e383.first[6], _e383.first[7], _e383.first[8], _e383.first[9], _e383.first[10], _e383.first[11], _e383.first[12], _e383.first[13], _e383.first[14], _e383.first[15], _e383.first[16], _e383.first[17], _e383.first[18], _e383.first[19], _e383.first[20], _e383.first[21], _e383.first[22], _e383.first[23], _e383.first[24], _e383.first[25], _e383.first[26], _e383.first[27], _e383.first[28], _e383.first[29], _e383.first[30], _e383.first[31]), array<u32, 32>(_e383.mask[0], _e383.mask[1], _e383.mask[2], _e383.mask[3], _e383.mask[4], _e383.mask[5], _e383.mask[6], _e383.mask[7], _e383.mask[8], _e383.mask[9], _e383.mask[10], _e383.mask[11], _e383.mask[12], _e383.mask[13], _e383.mask[14], _e383.mask[15], _e383.mask[16], _e383.mask[17], _e383.mask[18], _e383.mask[19], _e383.mask[20], _e383.mask[21], _e383.mask[22], _e383.mask[23], _e383.mask[24], _e383.mask[25], _e383.mask[26], _e383.mask[27], _e383.mask[28], _e383.mask[29], _e383.mask[30], _e383.mask[31]), _e383.len, _e383.group, _e383.group_mask);
                let _e457 = local_1.group_mask;
                if ((_e457 & 4278190080u) == 0u) {
                    let _e461 = local_1.len;
                    if (_e461 == 0u) {
                        phi_1078_ = false;
                    } else {
                        let _e465 = local_1.len;
                        local_1.len = (_e465 - 1u);
                        let _e468 = local_1.len;
                        if (_e468 < 32u) {
                        } else {
                            return;
                        }
                        let _e473 = local_1.first[(0u + _e468)];
                        local_1.group = _e473;
                        let _e476 = local_1.len;
                        if (_e476 < 32u) {
                        } else {
                            return;
                        }
                        let _e481 = local_1.mask[(0u + _e476)];
                        local_1.group_mask = _e481;
                        phi_1078_ = true;
                    }
                    let _e484 = phi_1078_;
                    phi_1079_ = _e484;
                } else {
                    phi_1079_ = true;
                }
                let _e486 = phi_1079_;
                if _e486 {
                    let _e488 = local_1.group_mask;
                    let _e494 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e488)), 32u, (_e488 == 0u)));
                    let _e498 = local_1.group_mask;
                    let _e512 = local_1.group_mask;
                    local_1.group_mask = (_e512 & ~((1u << bitcast<u32>((_e494 & 31u)))));
                    let _e515 = local_1.group;
                    phi_1110_ = (_e515 + countOneBits(((_e498 & ~((4294967295u << bitcast<u32>((((_e494 - 24u) ^ 7u) & 31u))))) & 255u)));
                } else {
                    phi_1110_ = 4294967295u;
                }
                let _e518 = phi_1110_;
                phi_1112_ = _e518;
                loop {
                    let _e520 = phi_1112_;
                    if (_e520 != 4294967295u) {
                        if (_e520 < _e75) {
                        } else {
                            return;
                        }
                        let _e527 = nodes.member[(0u + _e520)].frame[3u];
                        let _e552 = (bitcast<f32>((((_e527 >> bitcast<u32>(((0u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e284);
                        let _e553 = (bitcast<f32>((((_e527 >> bitcast<u32>(((1u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e294);
                        let _e554 = (bitcast<f32>((((_e527 >> bitcast<u32>(((2u * 8u) & 31u))) & 255u) << bitcast<u32>(23i))) * _e304);
                        let _e557 = nodes.member[(0u + _e520)].frame[0u];
                        let _e561 = nodes.member[(0u + _e520)].frame[1u];
                        let _e565 = nodes.member[(0u + _e520)].frame[2u];
                        let _e570 = ((bitcast<f32>(_e557) - _e127) * _e284);
                        let _e571 = ((bitcast<f32>(_e561) - _e129) * _e294);
                        let _e572 = ((bitcast<f32>(_e565) - _e131) * _e304);
                        let _e580 = nodes.member[(0u + _e520)].x;
                        if (_e284 < 0f) {
                            let _e591 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e580.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e597 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e591.unnamed.root, _e580.w), _e591.unnamed_1);
                            let _e603 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e597.unnamed, lt_bvh_traverse_Tree(_e580.x, _e597.unnamed_1.first_primitive));
                            phi_1193_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e603.unnamed, lt_bvh_traverse_Tree(_e603.unnamed_1.root, _e580.y));
                        } else {
                            let _e619 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e580.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e625 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e619.unnamed.root, _e580.y), _e619.unnamed_1);
                            let _e631 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e625.unnamed, lt_bvh_traverse_Tree(_e580.z, _e625.unnamed_1.first_primitive));
                            phi_1193_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e631.unnamed, lt_bvh_traverse_Tree(_e631.unnamed_1.root, _e580.w));
                        }
                        let _e639 = phi_1193_;
                        let _e649 = nodes.member[(0u + _e520)].y;
                        if (_e294 < 0f) {
                            let _e660 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e666 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e660.unnamed.root, _e649.w), _e660.unnamed_1);
                            let _e672 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e666.unnamed, lt_bvh_traverse_Tree(_e649.x, _e666.unnamed_1.first_primitive));
                            phi_1220_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e672.unnamed, lt_bvh_traverse_Tree(_e672.unnamed_1.root, _e649.y));
                        } else {
                            let _e688 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e649.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e694 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e688.unnamed.root, _e649.y), _e688.unnamed_1);
                            let _e700 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e694.unnamed, lt_bvh_traverse_Tree(_e649.z, _e694.unnamed_1.first_primitive));
                            phi_1220_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e700.unnamed, lt_bvh_traverse_Tree(_e700.unnamed_1.root, _e649.w));
                        }
                        let _e708 = phi_1220_;
                        let _e718 = nodes.member[(0u + _e520)].z;
                        if (_e304 < 0f) {
                            let _e729 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.z, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e735 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e729.unnamed.root, _e718.w), _e729.unnamed_1);
                            let _e741 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e735.unnamed, lt_bvh_traverse_Tree(_e718.x, _e735.unnamed_1.first_primitive));
                            phi_1247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e741.unnamed, lt_bvh_traverse_Tree(_e741.unnamed_1.root, _e718.y));
                        } else {
                            let _e757 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e718.x, u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed.first_primitive), u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_().unnamed_1);
                            let _e763 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(lt_bvh_traverse_Tree(_e757.unnamed.root, _e718.y), _e757.unnamed_1);
                            let _e769 = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e763.unnamed, lt_bvh_traverse_Tree(_e718.z, _e763.unnamed_1.first_primitive));
                            phi_1247_ = u0028_u0028_u32_u0020_u32_u0029_u0020_u0028_u32_u0020_u32_u0029_u0029_(_e769.unnamed, lt_bvh_traverse_Tree(_e769.unnamed_1.root, _e718.w));
                        }
                        let _e777 = phi_1247_;
                        phi_1253_ = 0u;
                        phi_1256_ = 0u;
                        loop {
                            let _e787 = phi_1253_;
                            let _e789 = phi_1256_;
                            local_2 = _e789;
                            local_3 = _e789;
                            local_4 = _e789;
                            let _e790 = (_e787 < 8u);
                            if _e790 {
                                let _e792 = (_e787 >> bitcast<u32>(2i));
                                let _e793 = (_e787 & 3u);
                                if (_e792 == 0u) {
                                    phi_1270_ = _e639.unnamed.root;
                                } else {
                                    phi_1270_ = _e639.unnamed.first_primitive;
                                }
                                let _e796 = phi_1270_;
                                if (_e792 == 0u) {
                                    phi_1280_ = _e708.unnamed.root;
                                } else {
                                    phi_1280_ = _e708.unnamed.first_primitive;
                                }
                                let _e805 = phi_1280_;
                                if (_e792 == 0u) {
                                    phi_1290_ = _e777.unnamed.root;
                                } else {
                                    phi_1290_ = _e777.unnamed.first_primitive;
                                }
                                let _e814 = phi_1290_;
                                let _e827 = core_intrinsics_maximum_number_nsz_f32_(((f32(((_e796 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e552) + (_e570 - _e332)), ((f32(((_e805 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e553) + (_e571 - _e333)));
                                let _e828 = core_intrinsics_maximum_number_nsz_f32_(_e827, ((f32(((_e814 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e554) + (_e572 - _e334)));
                                if (_e792 == 0u) {
                                    phi_1308_ = _e639.unnamed_1.root;
                                } else {
                                    phi_1308_ = _e639.unnamed_1.first_primitive;
                                }
                                let _e831 = phi_1308_;
                                if (_e792 == 0u) {
                                    phi_1318_ = _e708.unnamed_1.root;
                                } else {
                                    phi_1318_ = _e708.unnamed_1.first_primitive;
                                }
                                let _e840 = phi_1318_;
                                if (_e792 == 0u) {
                                    phi_1328_ = _e777.unnamed_1.root;
                                } else {
                                    phi_1328_ = _e777.unnamed_1.first_primitive;
                                }
                                let _e849 = phi_1328_;
                                let _e862 = core_intrinsics_minimum_number_nsz_f32_(((f32(((_e831 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e552) + (_e570 + _e332)), ((f32(((_e840 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e553) + (_e571 + _e333)));
                                let _e863 = core_intrinsics_minimum_number_nsz_f32_(_e862, ((f32(((_e849 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u)) * _e554) + (_e572 + _e334)));
                                if (_e828 <= _e863) {
                                    if (_e828 <= _e135) {
                                        if (_e863 >= 0f) {
                                            if (_e792 == 0u) {
                                                let _e870 = nodes.member[(0u + _e520)].links[2u];
                                                phi_1364_ = _e870;
                                            } else {
                                                let _e873 = nodes.member[(0u + _e520)].links[3u];
                                                phi_1364_ = _e873;
                                            }
                                            let _e875 = phi_1364_;
                                            let _e880 = ((_e875 >> bitcast<u32>(((_e793 * 8u) & 31u))) & 255u);
                                            let _e881 = (_e880 & 31u);
                                            if (_e881 >= 24u) {
                                                phi_1377_ = (24u + ((_e881 - 24u) ^ _e382));
                                            } else {
                                                phi_1377_ = _e881;
                                            }
                                            let _e887 = phi_1377_;
                                            phi_1382_ = (_e789 | ((_e880 >> bitcast<u32>(5i)) << bitcast<u32>((_e887 & 31u))));
                                        } else {
                                            phi_1382_ = _e789;
                                        }
                                        let _e895 = phi_1382_;
                                        phi_1383_ = _e895;
                                    } else {
                                        phi_1383_ = _e789;
                                    }
                                    let _e897 = phi_1383_;
                                    phi_1384_ = _e897;
                                } else {
                                    phi_1384_ = _e789;
                                }
                                let _e899 = phi_1384_;
                                phi_1254_ = (_e787 + 1u);
                                phi_1257_ = _e899;
                            } else {
                                phi_1254_ = u32();
                                phi_1257_ = u32();
                            }
                            let _e902 = phi_1254_;
                            let _e904 = phi_1257_;
                            continue;
                            continuing {
                                phi_1253_ = _e902;
                                phi_1256_ = _e904;
                                break if !(_e790);
                            }
                        }
                        let _e908 = nodes.member[(0u + _e520)].links[0u];
                        let _e912 = nodes.member[(0u + _e520)].frame[3u];
                        let _e916 = local_2;
                        if ((_e916 & 4278190080u) == 0u) {
                        } else {
                            let _e920 = local_1.group_mask;
                            if ((_e920 & 4278190080u) == 0u) {
                            } else {
                                let _e924 = local_1.len;
                                if (_e924 < 32u) {
                                    let _e927 = local_1.group;
                                    let _e929 = local_1.len;
                                    if (_e929 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.first[(0u + _e929)] = _e927;
                                    let _e935 = local_1.group_mask;
                                    let _e937 = local_1.len;
                                    if (_e937 < 32u) {
                                    } else {
                                        return;
                                    }
                                    local_1.mask[(0u + _e937)] = _e935;
                                    let _e944 = local_1.len;
                                    local_1.len = (_e944 + 1u);
                                }
                            }
                            local_1.group = (0u + _e908);
                            let _e948 = local_3;
                            local_1.group_mask = ((_e948 & 4278190080u) | (_e912 >> bitcast<u32>(24i)));
                        }
                        let _e953 = local_4;
                        phi_1442_ = (_e953 & 16777215u);
                        loop {
                            let _e956 = phi_1442_;
                            let _e957 = (_e956 == 0u);
                            local_5 = _e957;
                            local_9 = _e957;
                            if _e957 {
                                phi_1443_ = u32();
                                phi_2153_ = false;
                                phi_2154_ = false;
                                phi_2155_ = false;
                            } else {
                                let _e960 = nodes.member[(0u + _e520)].links[1u];
                                let _e965 = ((0u + _e960) + select(firstTrailingBit(_e956), 32u, (_e956 == 0u)));
                                if (_e965 < _e78) {
                                } else {
                                    return;
                                }
                                let _e972 = triangles.member[(0u + _e965)].v0_;
                                let _e974 = (_e972.x - _e127);
                                let _e976 = (_e972.y - _e129);
                                let _e978 = (_e972.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1488_ = vec3<f32>(_e976, _e978, _e974);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1487_ = vec3<f32>(_e978, _e974, _e976);
                                    } else {
                                        phi_1487_ = (_e972 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e986 = phi_1487_;
                                    phi_1488_ = _e986;
                                }
                                let _e988 = phi_1488_;
                                let _e992 = (_e988.x - (_e366 * _e988.z));
                                let _e996 = (_e988.y - (_e369 * _e988.z));
                                let _e1000 = triangles.member[(0u + _e965)].v1_;
                                let _e1002 = (_e1000.x - _e127);
                                let _e1004 = (_e1000.y - _e129);
                                let _e1006 = (_e1000.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1520_ = vec3<f32>(_e1004, _e1006, _e1002);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1519_ = vec3<f32>(_e1006, _e1002, _e1004);
                                    } else {
                                        phi_1519_ = (_e1000 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1014 = phi_1519_;
                                    phi_1520_ = _e1014;
                                }
                                let _e1016 = phi_1520_;
                                let _e1020 = (_e1016.x - (_e366 * _e1016.z));
                                let _e1024 = (_e1016.y - (_e369 * _e1016.z));
                                let _e1028 = triangles.member[(0u + _e965)].v2_;
                                let _e1030 = (_e1028.x - _e127);
                                let _e1032 = (_e1028.y - _e129);
                                let _e1034 = (_e1028.z - _e131);
                                if (_e355 == 0u) {
                                    phi_1552_ = vec3<f32>(_e1032, _e1034, _e1030);
                                } else {
                                    if (_e355 == 1u) {
                                        phi_1551_ = vec3<f32>(_e1034, _e1030, _e1032);
                                    } else {
                                        phi_1551_ = (_e1028 - vec3<f32>(_e127, _e129, _e131));
                                    }
                                    let _e1042 = phi_1551_;
                                    phi_1552_ = _e1042;
                                }
                                let _e1044 = phi_1552_;
                                let _e1048 = (_e1044.x - (_e366 * _e1044.z));
                                let _e1052 = (_e1044.y - (_e369 * _e1044.z));
                                if (_e1020 < _e1048) {
                                    phi_1573_ = true;
                                } else {
                                    if (_e1020 == _e1048) {
                                        phi_1572_ = (_e1024 < _e1052);
                                    } else {
                                        phi_1572_ = false;
                                    }
                                    let _e1059 = phi_1572_;
                                    phi_1573_ = _e1059;
                                }
                                let _e1061 = phi_1573_;
                                if _e1061 {
                                    phi_1577_ = _e1052;
                                    phi_1578_ = _e1048;
                                    phi_1579_ = _e1024;
                                    phi_1580_ = _e1020;
                                } else {
                                    phi_1577_ = _e1024;
                                    phi_1578_ = _e1020;
                                    phi_1579_ = _e1052;
                                    phi_1580_ = _e1048;
                                }
                                let _e1063 = phi_1577_;
                                let _e1065 = phi_1578_;
                                let _e1067 = phi_1579_;
                                let _e1069 = phi_1580_;
                                let _e1072 = ((_e1069 * _e1063) - (_e1067 * _e1065));
                                if _e1061 {
                                    phi_1588_ = -(_e1072);
                                } else {
                                    phi_1588_ = _e1072;
                                }
                                let _e1075 = phi_1588_;
                                if (_e1048 < _e992) {
                                    phi_1599_ = true;
                                } else {
                                    if (_e1048 == _e992) {
                                        phi_1598_ = (_e1052 < _e996);
                                    } else {
                                        phi_1598_ = false;
                                    }
                                    let _e1080 = phi_1598_;
                                    phi_1599_ = _e1080;
                                }
                                let _e1082 = phi_1599_;
                                if _e1082 {
                                    phi_1603_ = _e996;
                                    phi_1604_ = _e992;
                                    phi_1605_ = _e1052;
                                    phi_1606_ = _e1048;
                                } else {
                                    phi_1603_ = _e1052;
                                    phi_1604_ = _e1048;
                                    phi_1605_ = _e996;
                                    phi_1606_ = _e992;
                                }
                                let _e1084 = phi_1603_;
                                let _e1086 = phi_1604_;
                                let _e1088 = phi_1605_;
                                let _e1090 = phi_1606_;
                                let _e1093 = ((_e1090 * _e1084) - (_e1088 * _e1086));
                                if _e1082 {
                                    phi_1614_ = -(_e1093);
                                } else {
                                    phi_1614_ = _e1093;
                                }
                                let _e1096 = phi_1614_;
                                if (_e992 < _e1020) {
                                    phi_1625_ = true;
                                } else {
                                    if (_e992 == _e1020) {
                                        phi_1624_ = (_e996 < _e1024);
                                    } else {
                                        phi_1624_ = false;
                                    }
                                    let _e1101 = phi_1624_;
                                    phi_1625_ = _e1101;
                                }
                                let _e1103 = phi_1625_;
                                if _e1103 {
                                    phi_1629_ = _e1024;
                                    phi_1630_ = _e1020;
                                    phi_1631_ = _e996;
                                    phi_1632_ = _e992;
                                } else {
                                    phi_1629_ = _e996;
                                    phi_1630_ = _e992;
                                    phi_1631_ = _e1024;
                                    phi_1632_ = _e1020;
                                }
                                let _e1105 = phi_1629_;
                                let _e1107 = phi_1630_;
                                let _e1109 = phi_1631_;
                                let _e1111 = phi_1632_;
                                let _e1114 = ((_e1111 * _e1105) - (_e1109 * _e1107));
                                if _e1103 {
                                    phi_1640_ = -(_e1114);
                                } else {
                                    phi_1640_ = _e1114;
                                }
                                let _e1117 = phi_1640_;
                                if (_e1075 >= 0f) {
                                    if (_e1096 >= 0f) {
                                        if (_e1117 >= 0f) {
                                            phi_1655_ = ((_e1075 + _e1096) + _e1117);
                                            phi_1656_ = false;
                                        } else {
                                            phi_1655_ = f32();
                                            phi_1656_ = true;
                                        }
                                        let _e1124 = phi_1655_;
                                        let _e1126 = phi_1656_;
                                        phi_1657_ = _e1124;
                                        phi_1658_ = _e1126;
                                    } else {
                                        phi_1657_ = f32();
                                        phi_1658_ = true;
                                    }
                                    let _e1128 = phi_1657_;
                                    let _e1130 = phi_1658_;
                                    phi_1659_ = _e1128;
                                    phi_1660_ = _e1130;
                                } else {
                                    phi_1659_ = f32();
                                    phi_1660_ = true;
                                }
                                let _e1132 = phi_1659_;
                                let _e1134 = phi_1660_;
                                if _e1134 {
                                    if (_e1075 <= 0f) {
                                        if (_e1096 <= 0f) {
                                            let _e1137 = (_e1117 <= 0f);
                                            if _e1137 {
                                            }
                                            phi_1678_ = ((_e1075 + _e1096) + _e1117);
                                            phi_1679_ = false;
                                            phi_1680_ = _e1137;
                                        } else {
                                            phi_1678_ = f32();
                                            phi_1679_ = true;
                                            phi_1680_ = false;
                                        }
                                        let _e1141 = phi_1678_;
                                        let _e1143 = phi_1679_;
                                        let _e1145 = phi_1680_;
                                        phi_1681_ = _e1141;
                                        phi_1682_ = _e1143;
                                        phi_1683_ = _e1145;
                                    } else {
                                        phi_1681_ = f32();
                                        phi_1682_ = true;
                                        phi_1683_ = false;
                                    }
                                    let _e1147 = phi_1681_;
                                    let _e1149 = phi_1682_;
                                    let _e1151 = phi_1683_;
                                    if _e1149 {
                                        phi_1687_ = false;
                                    } else {
                                        phi_1687_ = _e1151;
                                    }
                                    let _e1153 = phi_1687_;
                                    phi_1688_ = _e1147;
                                    phi_1689_ = _e1153;
                                } else {
                                    phi_1688_ = _e1132;
                                    phi_1689_ = true;
                                }
                                let _e1155 = phi_1688_;
                                let _e1157 = phi_1689_;
                                if _e1157 {
                                    let _e1158 = (_e1155 == 0f);
                                    if _e1158 {
                                        phi_1902_ = lt_bvh_triangle_Intersection();
                                        phi_1903_ = false;
                                    } else {
                                        let _e1164 = ((((_e1075 * (_e371 * _e988.z)) + (_e1096 * (_e371 * _e1016.z))) + (_e1117 * (_e371 * _e1044.z))) / _e1155);
                                        if (_e1164 > 0f) {
                                            if (_e1164 < _e135) {
                                                let _e1168 = triangles.member[(0u + _e965)].v0_;
                                                let _e1170 = triangles.member[(0u + _e965)].v1_;
                                                if (_e1168.x < _e1170.x) {
                                                    phi_1723_ = _e1168.x;
                                                } else {
                                                    phi_1723_ = _e1170.x;
                                                }
                                                let _e1177 = phi_1723_;
                                                if (_e1168.y < _e1170.y) {
                                                    phi_1732_ = _e1168.y;
                                                } else {
                                                    phi_1732_ = _e1170.y;
                                                }
                                                let _e1184 = phi_1732_;
                                                if (_e1168.z < _e1170.z) {
                                                    phi_1741_ = _e1168.z;
                                                } else {
                                                    phi_1741_ = _e1170.z;
                                                }
                                                let _e1191 = phi_1741_;
                                                let _e1193 = triangles.member[(0u + _e965)].v2_;
                                                if (_e1177 < _e1193.x) {
                                                    phi_1750_ = _e1177;
                                                } else {
                                                    phi_1750_ = _e1193.x;
                                                }
                                                let _e1198 = phi_1750_;
                                                if (_e1184 < _e1193.y) {
                                                    phi_1757_ = _e1184;
                                                } else {
                                                    phi_1757_ = _e1193.y;
                                                }
                                                let _e1203 = phi_1757_;
                                                if (_e1191 < _e1193.z) {
                                                    phi_1764_ = _e1191;
                                                } else {
                                                    phi_1764_ = _e1193.z;
                                                }
                                                let _e1208 = phi_1764_;
                                                let _e1210 = triangles.member[(0u + _e965)].v0_;
                                                let _e1212 = triangles.member[(0u + _e965)].v1_;
                                                if (_e1210.x > _e1212.x) {
                                                    phi_1777_ = _e1210.x;
                                                } else {
                                                    phi_1777_ = _e1212.x;
                                                }
                                                let _e1219 = phi_1777_;
                                                if (_e1210.y > _e1212.y) {
                                                    phi_1786_ = _e1210.y;
                                                } else {
                                                    phi_1786_ = _e1212.y;
                                                }
                                                let _e1226 = phi_1786_;
                                                if (_e1210.z > _e1212.z) {
                                                    phi_1795_ = _e1210.z;
                                                } else {
                                                    phi_1795_ = _e1212.z;
                                                }
                                                let _e1233 = phi_1795_;
                                                let _e1235 = triangles.member[(0u + _e965)].v2_;
                                                if (_e1219 > _e1235.x) {
                                                    phi_1804_ = _e1219;
                                                } else {
                                                    phi_1804_ = _e1235.x;
                                                }
                                                let _e1240 = phi_1804_;
                                                if (_e1226 > _e1235.y) {
                                                    phi_1811_ = _e1226;
                                                } else {
                                                    phi_1811_ = _e1235.y;
                                                }
                                                let _e1245 = phi_1811_;
                                                if (_e1233 > _e1235.z) {
                                                    phi_1818_ = _e1233;
                                                } else {
                                                    phi_1818_ = _e1235.z;
                                                }
                                                let _e1250 = phi_1818_;
                                                let _e1254 = ((_e1198 - _e127) * _e284);
                                                let _e1255 = ((_e1203 - _e129) * _e294);
                                                let _e1256 = ((_e1208 - _e131) * _e304);
                                                let _e1260 = ((_e1240 - _e127) * _e284);
                                                let _e1261 = ((_e1245 - _e129) * _e294);
                                                let _e1262 = ((_e1250 - _e131) * _e304);
                                                if (_e1254 < _e1260) {
                                                    phi_1835_ = _e1254;
                                                } else {
                                                    phi_1835_ = _e1260;
                                                }
                                                let _e1265 = phi_1835_;
                                                if (_e1255 < _e1261) {
                                                    phi_1840_ = _e1255;
                                                } else {
                                                    phi_1840_ = _e1261;
                                                }
                                                let _e1268 = phi_1840_;
                                                if (_e1256 < _e1262) {
                                                    phi_1845_ = _e1256;
                                                } else {
                                                    phi_1845_ = _e1262;
                                                }
                                                let _e1271 = phi_1845_;
                                                if (_e1254 > _e1260) {
                                                    phi_1853_ = _e1254;
                                                } else {
                                                    phi_1853_ = _e1260;
                                                }
                                                let _e1277 = phi_1853_;
                                                if (_e1255 > _e1261) {
                                                    phi_1858_ = _e1255;
                                                } else {
                                                    phi_1858_ = _e1261;
                                                }
                                                let _e1280 = phi_1858_;
                                                if (_e1256 > _e1262) {
                                                    phi_1863_ = _e1256;
                                                } else {
                                                    phi_1863_ = _e1262;
                                                }
                                                let _e1283 = phi_1863_;
                                                let _e1287 = core_intrinsics_maximum_number_nsz_f32_((_e1265 - _e339), (_e1268 - _e340));
                                                let _e1288 = core_intrinsics_maximum_number_nsz_f32_(_e1287, (_e1271 - _e341));
                                                let _e1289 = core_intrinsics_minimum_number_nsz_f32_((_e1277 + _e339), (_e1280 + _e340));
                                                let _e1290 = core_intrinsics_minimum_number_nsz_f32_(_e1289, (_e1283 + _e341));
                                                if (_e1288 > -300000000000000000000000000000000000000f) {
                                                    phi_1875_ = _e1288;
                                                } else {
                                                    phi_1875_ = -300000000000000000000000000000000000000f;
                                                }
                                                let _e1293 = phi_1875_;
                                                if (_e1290 < 300000000000000000000000000000000000000f) {
                                                    phi_1880_ = _e1290;
                                                } else {
                                                    phi_1880_ = 300000000000000000000000000000000000000f;
                                                }
                                                let _e1296 = phi_1880_;
                                                if (_e1164 < _e1293) {
                                                    phi_1885_ = _e1293;
                                                } else {
                                                    phi_1885_ = _e1164;
                                                }
                                                let _e1299 = phi_1885_;
                                                if (_e1299 > _e1296) {
                                                    phi_1890_ = _e1296;
                                                } else {
                                                    phi_1890_ = _e1299;
                                                }
                                                let _e1302 = phi_1890_;
                                                phi_1895_ = lt_bvh_triangle_Intersection(_e1302, (_e1096 / _e1155), (_e1117 / _e1155), (_e1293 <= _e1296));
                                                phi_1896_ = false;
                                            } else {
                                                phi_1895_ = lt_bvh_triangle_Intersection();
                                                phi_1896_ = true;
                                            }
                                            let _e1308 = phi_1895_;
                                            let _e1310 = phi_1896_;
                                            phi_1897_ = _e1308;
                                            phi_1898_ = _e1310;
                                        } else {
                                            phi_1897_ = lt_bvh_triangle_Intersection();
                                            phi_1898_ = true;
                                        }
                                        let _e1312 = phi_1897_;
                                        let _e1314 = phi_1898_;
                                        if _e1314 {
                                        }
                                        phi_1902_ = _e1312;
                                        phi_1903_ = _e1314;
                                    }
                                    let _e1316 = phi_1902_;
                                    let _e1318 = phi_1903_;
                                    phi_1904_ = _e1316;
                                    phi_1905_ = _e1158;
                                    phi_1906_ = _e1318;
                                } else {
                                    phi_1904_ = lt_bvh_triangle_Intersection();
                                    phi_1905_ = true;
                                    phi_1906_ = false;
                                }
                                let _e1320 = phi_1904_;
                                let _e1322 = phi_1905_;
                                let _e1324 = phi_1906_;
                                if _e1322 {
                                    phi_1910_ = true;
                                } else {
                                    phi_1910_ = _e1324;
                                }
                                let _e1326 = phi_1910_;
                                if _e1326 {
                                    phi_1914_ = lt_bvh_triangle_Intersection(0f, 0f, 0f, false);
                                } else {
                                    phi_1914_ = _e1320;
                                }
                                let _e1328 = phi_1914_;
                                if _e1328.is_hit {
                                    if (_e1328.t > 0f) {
                                        if (_e1328.t < _e135) {
                                            let _e1335 = triangles.member[(0u + _e965)].i0_;
                                            let _e1337 = ((_e1335 & 2147483648u) == 0u);
                                            if _e1337 {
                                                phi_2137_ = false;
                                                phi_2138_ = false;
                                            } else {
                                                if (_e965 < _e78) {
                                                } else {
                                                    return;
                                                }
                                                let _e1344 = triangles.member[(0u + _e965)].i0_;
                                                let _e1345 = (_e1344 & 2147483647u);
                                                let _e1347 = triangles.member[(0u + _e965)].i1_;
                                                let _e1349 = triangles.member[(0u + _e965)].i2_;
                                                if (_e1345 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1353 = vertices.member[(0u + _e1345)];
                                                if (_e1347 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1357 = vertices.member[(0u + _e1347)];
                                                if (_e1349 < _e87) {
                                                } else {
                                                    return;
                                                }
                                                let _e1361 = vertices.member[(0u + _e1349)];
                                                let _e1362 = array<abi_Vertex, 3>(_e1353, _e1357, _e1361);
                                                if (_e1362[0].material < arrayLength((&materials.member))) {
                                                } else {
                                                    return;
                                                }
                                                let _e1368 = materials.member[(0u + _e1362[0].material)];
                                                if ((_e1368.flags & 1u) == 1u) {
                                                    let _e1373 = ((1f - _e1328.u) - _e1328.v);
                                                    if (_e1368.cutoff <= 0f) {
                                                        phi_2131_ = true;
                                                    } else {
                                                        let _e1400 = (_e1368.base_color.w * ((((f32((_e1362[0].color >> bitcast<u32>(24i))) * _e1373) + (f32((_e1362[1].color >> bitcast<u32>(24i))) * _e1328.u)) + (f32((_e1362[2].color >> bitcast<u32>(24i))) * _e1328.v)) * (1f / 255f)));
                                                        if (_e1368.alpha_size == 0u) {
                                                            phi_2128_ = _e1400;
                                                        } else {
                                                            local.offset = _e1368.alpha_offset;
                                                            local.size = _e1368.alpha_size;
                                                            local.flags = _e1368.flags;
                                                            let _e1431 = _lt_shaders_texture_TextureView_quad((&local), (((_e1362[0].u * _e1373) + (_e1362[1].u * _e1328.u)) + (_e1362[2].u * _e1328.v)), (((_e1362[0].v * _e1373) + (_e1362[1].v * _e1328.u)) + (_e1362[2].v * _e1328.v)));
                                                            let _e1435 = (_e1431.indices[0] >> bitcast<u32>(2i));
                                                            if (_e1435 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1439 = alpha_texels.member[(0u + _e1435)];
                                                            let _e1455 = (_e1431.indices[1] >> bitcast<u32>(2i));
                                                            if (_e1455 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1459 = alpha_texels.member[(0u + _e1455)];
                                                            let _e1476 = (_e1431.indices[2] >> bitcast<u32>(2i));
                                                            if (_e1476 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1480 = alpha_texels.member[(0u + _e1476)];
                                                            let _e1497 = (_e1431.indices[3] >> bitcast<u32>(2i));
                                                            if (_e1497 < _e93) {
                                                            } else {
                                                                return;
                                                            }
                                                            let _e1501 = alpha_texels.member[(0u + _e1497)];
                                                            phi_2128_ = (_e1400 * (((((f32(((_e1439 >> bitcast<u32>((((_e1431.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1431.weights.x) + ((f32(((_e1459 >> bitcast<u32>((((_e1431.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1431.weights.y)) + ((f32(((_e1480 >> bitcast<u32>((((_e1431.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1431.weights.z)) + ((f32(((_e1501 >> bitcast<u32>((((_e1431.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e1431.weights.w)));
                                                        }
                                                        let _e1517 = phi_2128_;
                                                        phi_2131_ = (_e1517 >= _e1368.cutoff);
                                                    }
                                                    let _e1521 = phi_2131_;
                                                    phi_2132_ = _e1521;
                                                } else {
                                                    phi_2132_ = false;
                                                }
                                                let _e1523 = phi_2132_;
                                                if _e1523 {
                                                    phi_2136_ = false;
                                                } else {
                                                    phi_2136_ = true;
                                                }
                                                let _e1525 = phi_2136_;
                                                phi_2137_ = _e1525;
                                                phi_2138_ = _e1523;
                                            }
                                            let _e1527 = phi_2137_;
                                            let _e1529 = phi_2138_;
                                            phi_2139_ = _e1527;
                                            phi_2140_ = _e1337;
                                            phi_2141_ = _e1529;
                                        } else {
                                            phi_2139_ = true;
                                            phi_2140_ = false;
                                            phi_2141_ = false;
                                        }
                                        let _e1531 = phi_2139_;
                                        let _e1533 = phi_2140_;
                                        let _e1535 = phi_2141_;
                                        phi_2142_ = _e1531;
                                        phi_2143_ = _e1533;
                                        phi_2144_ = _e1535;
                                    } else {
                                        phi_2142_ = true;
                                        phi_2143_ = false;
                                        phi_2144_ = false;
                                    }
                                    let _e1537 = phi_2142_;
                                    let _e1539 = phi_2143_;
                                    let _e1541 = phi_2144_;
                                    phi_2145_ = _e1537;
                                    phi_2146_ = _e1539;
                                    phi_2147_ = _e1541;
                                } else {
                                    phi_2145_ = true;
                                    phi_2146_ = false;
                                    phi_2147_ = false;
                                }
                                let _e1543 = phi_2145_;
                                let _e1545 = phi_2146_;
                                let _e1547 = phi_2147_;
                                if _e1543 {
                                    phi_2151_ = false;
                                    phi_2152_ = false;
                                } else {
                                    phi_2151_ = _e1545;
                                    phi_2152_ = _e1547;
                                }
                                let _e1549 = phi_2151_;
                                let _e1551 = phi_2152_;
                                phi_1443_ = (_e956 & (_e956 - 1u));
                                phi_2153_ = _e1543;
                                phi_2154_ = _e1549;
                                phi_2155_ = _e1551;
                            }
                            let _e1553 = phi_1443_;
                            let _e1555 = phi_2153_;
                            let _e1557 = phi_2154_;
                            let _e1559 = phi_2155_;
                            local_7 = _e1557;
                            local_8 = _e1559;
                            continue;
                            continuing {
                                phi_1442_ = _e1553;
                                break if !(_e1555);
                            }
                        }
                        let _e1562 = local_5;
                        if _e1562 {
                            let _e1564 = local_1.group_mask;
                            if ((_e1564 & 4278190080u) == 0u) {
                                let _e1568 = local_1.len;
                                if (_e1568 == 0u) {
                                    phi_2197_ = false;
                                } else {
                                    let _e1572 = local_1.len;
                                    local_1.len = (_e1572 - 1u);
                                    let _e1575 = local_1.len;
                                    if (_e1575 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1580 = local_1.first[(0u + _e1575)];
                                    local_1.group = _e1580;
                                    let _e1583 = local_1.len;
                                    if (_e1583 < 32u) {
                                    } else {
                                        return;
                                    }
                                    let _e1588 = local_1.mask[(0u + _e1583)];
                                    local_1.group_mask = _e1588;
                                    phi_2197_ = true;
                                }
                                let _e1591 = phi_2197_;
                                phi_2198_ = _e1591;
                            } else {
                                phi_2198_ = true;
                            }
                            let _e1593 = phi_2198_;
                            if _e1593 {
                                let _e1595 = local_1.group_mask;
                                let _e1601 = (31u - select((bitcast<u32>(31i) - firstLeadingBit(_e1595)), 32u, (_e1595 == 0u)));
                                let _e1605 = local_1.group_mask;
                                let _e1619 = local_1.group_mask;
                                local_1.group_mask = (_e1619 & ~((1u << bitcast<u32>((_e1601 & 31u)))));
                                let _e1622 = local_1.group;
                                phi_2229_ = (_e1622 + countOneBits(((_e1605 & ~((4294967295u << bitcast<u32>((((_e1601 - 24u) ^ _e382) & 31u))))) & 255u)));
                            } else {
                                phi_2229_ = 4294967295u;
                            }
                            let _e1625 = phi_2229_;
                            phi_2230_ = _e1625;
                            phi_2231_ = false;
                            phi_2232_ = false;
                        } else {
                            phi_2230_ = u32();
                            let _e1837 = local_7;
                            phi_2231_ = _e1837;
                            let _e1840 = local_8;
                            phi_2232_ = _e1840;
                        }
                        let _e1627 = phi_2230_;
                        let _e1629 = phi_2231_;
                        let _e1631 = phi_2232_;
                        phi_1113_ = _e1627;
                        let _e1844 = local_9;
                        phi_2233_ = _e1844;
                        phi_2234_ = false;
                        phi_2235_ = _e1629;
                        phi_2236_ = _e1631;
                    } else {
                        phi_1113_ = u32();
                        phi_2233_ = false;
                        phi_2234_ = true;
                        phi_2235_ = false;
                        phi_2236_ = false;
                    }
                    let _e1633 = phi_1113_;
                    let _e1635 = phi_2233_;
                    let _e1637 = phi_2234_;
                    let _e1639 = phi_2235_;
                    let _e1641 = phi_2236_;
                    local_6 = _e1637;
                    local_10 = _e1639;
                    local_11 = _e1641;
                    continue;
                    continuing {
                        phi_1112_ = _e1633;
                        break if !(_e1635);
                    }
                }
                let _e1644 = local_6;
                if _e1644 {
                    phi_2240_ = false;
                    phi_2241_ = false;
                } else {
                    let _e1851 = local_10;
                    phi_2240_ = _e1851;
                    let _e1854 = local_11;
                    phi_2241_ = _e1854;
                }
                let _e1646 = phi_2240_;
                let _e1648 = phi_2241_;
                if _e1646 {
                    phi_2245_ = true;
                } else {
                    phi_2245_ = _e1648;
                }
                let _e1650 = phi_2245_;
                if _e1650 {
                    phi_2249_ = true;
                } else {
                    phi_2249_ = false;
                }
                let _e1652 = phi_2249_;
                phi_2250_ = _e1652;
            }
            let _e1654 = phi_2250_;
            phi_2251_ = _e1654;
            phi_2252_ = _e208;
        } else {
            phi_2251_ = bool();
            phi_2252_ = true;
        }
        let _e1656 = phi_2251_;
        let _e1658 = phi_2252_;
        if _e1658 {
            phi_2256_ = false;
        } else {
            phi_2256_ = _e1656;
        }
        let _e1660 = phi_2256_;
        if _e1660 {
            phi_2260_ = 0f;
        } else {
            phi_2260_ = 1f;
        }
        let _e1662 = phi_2260_;
        if (_e106 < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e106)] = _e1662;
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn entry_resolve_resolve_list_alpha_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
