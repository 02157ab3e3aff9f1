struct type_6 {
    member: array<u32>,
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

struct type_20 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_24 {
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

struct type_28 {
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

struct abi_DepthParams {
    projection: lt_math_LightProjection,
    map_size: u32,
    near: f32,
    pad0_: u32,
    pad1_: u32,
}

struct type_36 {
    member: abi_DepthParams,
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

struct type_42 {
    member: array<lt_bvh_Instance>,
}

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_36;
@group(0) @binding(1) 
var<storage> triangles: type_20;
@group(0) @binding(2) 
var<storage> instances: type_42;
var<private> depth: f32 = 0f;
var<private> placed_1: u32;
@group(0) @binding(3) 
var<storage> vertices: type_24;
@group(0) @binding(4) 
var<storage> materials: type_28;
@group(0) @binding(5) 
var<storage> alpha_texels: type_6;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_164_: f32;
    var phi_169_: f32;
    var phi_170_: bool;
    var phi_171_: f32;
    var phi_172_: bool;
    var phi_176_: f32;
    var phi_202_: f32;
    var phi_207_: f32;
    var phi_208_: bool;
    var phi_209_: f32;
    var phi_210_: bool;
    var phi_214_: f32;
    var phi_222_: f32;
    var phi_223_: f32;
    var phi_224_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_252_: u32;
    var phi_266_: u32;
    var phi_273_: u32;
    var phi_278_: u32;
    var phi_284_: u32;
    var phi_289_: u32;
    var phi_291_: texture_Axis;
    var phi_319_: f32;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_326_: f32;
    var phi_327_: bool;
    var phi_331_: f32;
    var phi_357_: f32;
    var phi_362_: f32;
    var phi_363_: bool;
    var phi_364_: f32;
    var phi_365_: bool;
    var phi_369_: f32;
    var phi_377_: f32;
    var phi_378_: f32;
    var phi_379_: f32;
    var phi_388_: f32;
    var phi_389_: f32;
    var phi_407_: u32;
    var phi_421_: u32;
    var phi_428_: u32;
    var phi_433_: u32;
    var phi_439_: u32;
    var phi_444_: u32;
    var phi_446_: texture_Axis;

    let _e46 = (*param).size;
    let _e47 = (_e46 & 65535u);
    let _e49 = (*param).size;
    let _e51 = (_e49 >> bitcast<u32>(16i));
    let _e53 = (*param).flags;
    let _e55 = ((_e53 & 4u) != 0u);
    let _e57 = (*param).flags;
    let _e60 = ((_e57 >> bitcast<u32>(4u)) & 3u);
    if (_e60 == 0u) {
        if (param_1 > -8388608f) {
            let _e73 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e73 > param_1) {
                phi_164_ = 1f;
            } else {
                phi_164_ = 0f;
            }
            let _e76 = phi_164_;
            if (param_1 < 8388608f) {
                phi_169_ = (_e73 - _e76);
                phi_170_ = false;
            } else {
                phi_169_ = f32();
                phi_170_ = true;
            }
            let _e79 = phi_169_;
            let _e81 = phi_170_;
            phi_171_ = _e79;
            phi_172_ = _e81;
        } else {
            phi_171_ = f32();
            phi_172_ = true;
        }
        let _e83 = phi_171_;
        let _e85 = phi_172_;
        if _e85 {
            phi_176_ = param_1;
        } else {
            phi_176_ = _e83;
        }
        let _e87 = phi_176_;
        phi_224_ = (param_1 - _e87);
    } else {
        if (_e60 == 1u) {
            let _e90 = (param_1 * 0.5f);
            if (_e90 > -8388608f) {
                let _e102 = f32(select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)));
                if (_e102 > _e90) {
                    phi_202_ = 1f;
                } else {
                    phi_202_ = 0f;
                }
                let _e105 = phi_202_;
                if (_e90 < 8388608f) {
                    phi_207_ = (_e102 - _e105);
                    phi_208_ = false;
                } else {
                    phi_207_ = f32();
                    phi_208_ = true;
                }
                let _e108 = phi_207_;
                let _e110 = phi_208_;
                phi_209_ = _e108;
                phi_210_ = _e110;
            } else {
                phi_209_ = f32();
                phi_210_ = true;
            }
            let _e112 = phi_209_;
            let _e114 = phi_210_;
            if _e114 {
                phi_214_ = _e90;
            } else {
                phi_214_ = _e112;
            }
            let _e116 = phi_214_;
            let _e118 = (param_1 - (2f * _e116));
            if (_e118 > 1f) {
                phi_222_ = (2f - _e118);
            } else {
                phi_222_ = _e118;
            }
            let _e122 = phi_222_;
            phi_223_ = _e122;
        } else {
            phi_223_ = param_1;
        }
        let _e124 = phi_223_;
        phi_224_ = _e124;
    }
    let _e126 = phi_224_;
    if (_e126 > 0f) {
        if (_e126 < 1f) {
            phi_233_ = _e126;
        } else {
            phi_233_ = 1f;
        }
        let _e130 = phi_233_;
        phi_234_ = _e130;
    } else {
        phi_234_ = 0f;
    }
    let _e132 = phi_234_;
    let _e133 = (_e47 - 1u);
    let _e135 = (_e132 * f32(_e47));
    if _e55 {
        let _e142 = select(select(u32(_e135), 0u, (_e135 < bitcast<f32>(0u))), 4294967295u, (_e135 > bitcast<f32>(1333788671u)));
        if (_e133 < _e142) {
            phi_252_ = _e133;
        } else {
            phi_252_ = _e142;
        }
        let _e145 = phi_252_;
        phi_291_ = texture_Axis(_e145, _e145, 0f);
    } else {
        let _e147 = (_e135 + 0.5f);
        let _e154 = select(select(u32(_e147), 0u, (_e147 < bitcast<f32>(0u))), 4294967295u, (_e147 > bitcast<f32>(1333788671u)));
        if (_e47 < _e154) {
            phi_266_ = _e47;
        } else {
            phi_266_ = _e154;
        }
        let _e157 = phi_266_;
        if (_e60 == 0u) {
            phi_273_ = _e133;
        } else {
            phi_273_ = 0u;
        }
        let _e162 = phi_273_;
        if (_e60 == 0u) {
            phi_278_ = 0u;
        } else {
            phi_278_ = _e133;
        }
        let _e165 = phi_278_;
        if (_e157 == 0u) {
            phi_284_ = _e162;
        } else {
            phi_284_ = (_e157 - 1u);
        }
        let _e169 = phi_284_;
        if (_e157 > _e133) {
            phi_289_ = _e165;
        } else {
            phi_289_ = _e157;
        }
        let _e172 = phi_289_;
        phi_291_ = texture_Axis(_e169, _e172, (_e147 - f32(_e157)));
    }
    let _e175 = phi_291_;
    let _e177 = (*param).flags;
    let _e180 = ((_e177 >> bitcast<u32>(6u)) & 3u);
    if (_e180 == 0u) {
        if (param_2 > -8388608f) {
            let _e193 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e193 > param_2) {
                phi_319_ = 1f;
            } else {
                phi_319_ = 0f;
            }
            let _e196 = phi_319_;
            if (param_2 < 8388608f) {
                phi_324_ = (_e193 - _e196);
                phi_325_ = false;
            } else {
                phi_324_ = f32();
                phi_325_ = true;
            }
            let _e199 = phi_324_;
            let _e201 = phi_325_;
            phi_326_ = _e199;
            phi_327_ = _e201;
        } else {
            phi_326_ = f32();
            phi_327_ = true;
        }
        let _e203 = phi_326_;
        let _e205 = phi_327_;
        if _e205 {
            phi_331_ = param_2;
        } else {
            phi_331_ = _e203;
        }
        let _e207 = phi_331_;
        phi_379_ = (param_2 - _e207);
    } else {
        if (_e180 == 1u) {
            let _e210 = (param_2 * 0.5f);
            if (_e210 > -8388608f) {
                let _e222 = f32(select(0i, select(select(i32(_e210), i32(-2147483648), (_e210 < bitcast<f32>(3472883712u))), 2147483647i, (_e210 > bitcast<f32>(1325400063u))), (_e210 == _e210)));
                if (_e222 > _e210) {
                    phi_357_ = 1f;
                } else {
                    phi_357_ = 0f;
                }
                let _e225 = phi_357_;
                if (_e210 < 8388608f) {
                    phi_362_ = (_e222 - _e225);
                    phi_363_ = false;
                } else {
                    phi_362_ = f32();
                    phi_363_ = true;
                }
                let _e228 = phi_362_;
                let _e230 = phi_363_;
                phi_364_ = _e228;
                phi_365_ = _e230;
            } else {
                phi_364_ = f32();
                phi_365_ = true;
            }
            let _e232 = phi_364_;
            let _e234 = phi_365_;
            if _e234 {
                phi_369_ = _e210;
            } else {
                phi_369_ = _e232;
            }
            let _e236 = phi_369_;
            let _e238 = (param_2 - (2f * _e236));
            if (_e238 > 1f) {
                phi_377_ = (2f - _e238);
            } else {
                phi_377_ = _e238;
            }
            let _e242 = phi_377_;
            phi_378_ = _e242;
        } else {
            phi_378_ = param_2;
        }
        let _e244 = phi_378_;
        phi_379_ = _e244;
    }
    let _e246 = phi_379_;
    if (_e246 > 0f) {
        if (_e246 < 1f) {
            phi_388_ = _e246;
        } else {
            phi_388_ = 1f;
        }
        let _e250 = phi_388_;
        phi_389_ = _e250;
    } else {
        phi_389_ = 0f;
    }
    let _e252 = phi_389_;
    let _e253 = (_e51 - 1u);
    let _e255 = (_e252 * f32(_e51));
    if _e55 {
        let _e262 = select(select(u32(_e255), 0u, (_e255 < bitcast<f32>(0u))), 4294967295u, (_e255 > bitcast<f32>(1333788671u)));
        if (_e253 < _e262) {
            phi_407_ = _e253;
        } else {
            phi_407_ = _e262;
        }
        let _e265 = phi_407_;
        phi_446_ = texture_Axis(_e265, _e265, 0f);
    } else {
        let _e267 = (_e255 + 0.5f);
        let _e274 = select(select(u32(_e267), 0u, (_e267 < bitcast<f32>(0u))), 4294967295u, (_e267 > bitcast<f32>(1333788671u)));
        if (_e51 < _e274) {
            phi_421_ = _e51;
        } else {
            phi_421_ = _e274;
        }
        let _e277 = phi_421_;
        if (_e180 == 0u) {
            phi_428_ = _e253;
        } else {
            phi_428_ = 0u;
        }
        let _e282 = phi_428_;
        if (_e180 == 0u) {
            phi_433_ = 0u;
        } else {
            phi_433_ = _e253;
        }
        let _e285 = phi_433_;
        if (_e277 == 0u) {
            phi_439_ = _e282;
        } else {
            phi_439_ = (_e277 - 1u);
        }
        let _e289 = phi_439_;
        if (_e277 > _e253) {
            phi_444_ = _e285;
        } else {
            phi_444_ = _e277;
        }
        let _e292 = phi_444_;
        phi_446_ = texture_Axis(_e289, _e292, (_e267 - f32(_e277)));
    }
    let _e295 = phi_446_;
    let _e299 = (*param).offset;
    let _e306 = (*param).offset;
    let _e313 = (*param).offset;
    let _e320 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e299 + (_e295.low * _e47)) + _e175.low), ((_e306 + (_e295.low * _e47)) + _e175.high), ((_e313 + (_e295.high * _e47)) + _e175.low), ((_e320 + (_e295.high * _e47)) + _e175.high)), vec4<f32>(((1f - _e175.fraction) * (1f - _e295.fraction)), (_e175.fraction * (1f - _e295.fraction)), ((1f - _e175.fraction) * _e295.fraction), (_e175.fraction * _e295.fraction)));
}

fn spirv_std_arch_kill() {
    discard;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(param_3: f32, param_4: f32) -> f32 {
    var phi_502_: f32;

    if (param_3 < param_4) {
        phi_502_ = param_3;
    } else {
        phi_502_ = param_4;
    }
    let _e46 = phi_502_;
    return _e46;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(param_5: f32, param_6: f32) -> f32 {
    var phi_510_: f32;

    if (param_5 > param_6) {
        phi_510_ = param_5;
    } else {
        phi_510_ = param_6;
    }
    let _e46 = phi_510_;
    return _e46;
}

fn function_() {
    var local: texture_TextureView;
    var phi_551_: vec3<f32>;
    var phi_552_: vec3<f32>;
    var phi_665_: vec3<f32>;
    var phi_666_: vec3<f32>;
    var phi_779_: vec3<f32>;
    var phi_780_: vec3<f32>;
    var phi_948_: vec3<f32>;
    var phi_1099_: f32;
    var phi_1103_: bool;
    var phi_1104_: bool;
    var phi_1142_: vec3<f32>;
    var phi_1165_: f32;
    var phi_1166_: f32;

    let _e43 = at_1;
    let _e44 = triangle_1;
    let _e45 = placed_1;
    let _e55 = arrayLength((&vertices.member));
    let _e61 = arrayLength((&alpha_texels.member));
    if (_e44 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e65 = triangles.member[(0u + _e44)];
    if (_e45 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    if (0u == 0u) {
        phi_552_ = _e65.v0_;
    } else {
        if (0u == 1u) {
            phi_551_ = _e65.v1_;
        } else {
            phi_551_ = _e65.v2_;
        }
        let _e75 = phi_551_;
        phi_552_ = _e75;
    }
    let _e77 = phi_552_;
    let _e83 = instances.member[(0u + _e45)].object_to_world[0u];
    let _e94 = ((((_e83.x * _e77.x) + (_e83.y * _e77.y)) + (_e83.z * _e77.z)) + (_e83.w * 1f));
    let _e96 = instances.member[(0u + _e45)].object_to_world[1u];
    let _e107 = ((((_e96.x * _e77.x) + (_e96.y * _e77.y)) + (_e96.z * _e77.z)) + (_e96.w * 1f));
    let _e109 = instances.member[(0u + _e45)].object_to_world[2u];
    let _e120 = ((((_e109.x * _e77.x) + (_e109.y * _e77.y)) + (_e109.z * _e77.z)) + (_e109.w * 1f));
    let _e122 = p.member.map_size;
    let _e124 = f32(_e122);
    let _e126 = p.member.projection.row_x;
    let _e138 = (((((_e126.x * _e94) + (_e126.y * _e107)) + (_e126.z * _e120)) + (_e126.w * 1f)) * _e124);
    let _e140 = p.member.projection.row_y;
    let _e152 = (((((_e140.x * _e94) + (_e140.y * _e107)) + (_e140.z * _e120)) + (_e140.w * 1f)) * _e124);
    let _e154 = p.member.projection.row_z;
    let _e165 = ((((_e154.x * _e94) + (_e154.y * _e107)) + (_e154.z * _e120)) + (_e154.w * 1f));
    let _e167 = p.member.projection.row_w;
    let _e178 = ((((_e167.x * _e94) + (_e167.y * _e107)) + (_e167.z * _e120)) + (_e167.w * 1f));
    if (1u == 0u) {
        phi_666_ = _e65.v0_;
    } else {
        if (1u == 1u) {
            phi_665_ = _e65.v1_;
        } else {
            phi_665_ = _e65.v2_;
        }
        let _e185 = phi_665_;
        phi_666_ = _e185;
    }
    let _e187 = phi_666_;
    let _e193 = instances.member[(0u + _e45)].object_to_world[0u];
    let _e204 = ((((_e193.x * _e187.x) + (_e193.y * _e187.y)) + (_e193.z * _e187.z)) + (_e193.w * 1f));
    let _e206 = instances.member[(0u + _e45)].object_to_world[1u];
    let _e217 = ((((_e206.x * _e187.x) + (_e206.y * _e187.y)) + (_e206.z * _e187.z)) + (_e206.w * 1f));
    let _e219 = instances.member[(0u + _e45)].object_to_world[2u];
    let _e230 = ((((_e219.x * _e187.x) + (_e219.y * _e187.y)) + (_e219.z * _e187.z)) + (_e219.w * 1f));
    let _e232 = p.member.map_size;
    let _e234 = f32(_e232);
    let _e236 = p.member.projection.row_x;
    let _e248 = (((((_e236.x * _e204) + (_e236.y * _e217)) + (_e236.z * _e230)) + (_e236.w * 1f)) * _e234);
    let _e250 = p.member.projection.row_y;
    let _e262 = (((((_e250.x * _e204) + (_e250.y * _e217)) + (_e250.z * _e230)) + (_e250.w * 1f)) * _e234);
    let _e264 = p.member.projection.row_z;
    let _e275 = ((((_e264.x * _e204) + (_e264.y * _e217)) + (_e264.z * _e230)) + (_e264.w * 1f));
    let _e277 = p.member.projection.row_w;
    let _e288 = ((((_e277.x * _e204) + (_e277.y * _e217)) + (_e277.z * _e230)) + (_e277.w * 1f));
    if (2u == 0u) {
        phi_780_ = _e65.v0_;
    } else {
        if (2u == 1u) {
            phi_779_ = _e65.v1_;
        } else {
            phi_779_ = _e65.v2_;
        }
        let _e295 = phi_779_;
        phi_780_ = _e295;
    }
    let _e297 = phi_780_;
    let _e303 = instances.member[(0u + _e45)].object_to_world[0u];
    let _e314 = ((((_e303.x * _e297.x) + (_e303.y * _e297.y)) + (_e303.z * _e297.z)) + (_e303.w * 1f));
    let _e316 = instances.member[(0u + _e45)].object_to_world[1u];
    let _e327 = ((((_e316.x * _e297.x) + (_e316.y * _e297.y)) + (_e316.z * _e297.z)) + (_e316.w * 1f));
    let _e329 = instances.member[(0u + _e45)].object_to_world[2u];
    let _e340 = ((((_e329.x * _e297.x) + (_e329.y * _e297.y)) + (_e329.z * _e297.z)) + (_e329.w * 1f));
    let _e342 = p.member.map_size;
    let _e344 = f32(_e342);
    let _e346 = p.member.projection.row_x;
    let _e358 = (((((_e346.x * _e314) + (_e346.y * _e327)) + (_e346.z * _e340)) + (_e346.w * 1f)) * _e344);
    let _e360 = p.member.projection.row_y;
    let _e372 = (((((_e360.x * _e314) + (_e360.y * _e327)) + (_e360.z * _e340)) + (_e360.w * 1f)) * _e344);
    let _e374 = p.member.projection.row_z;
    let _e385 = ((((_e374.x * _e314) + (_e374.y * _e327)) + (_e374.z * _e340)) + (_e374.w * 1f));
    let _e387 = p.member.projection.row_w;
    let _e398 = ((((_e387.x * _e314) + (_e387.y * _e327)) + (_e387.z * _e340)) + (_e387.w * 1f));
    let _e402 = (_e65.i0_ & 2147483647u);
    if (_e402 < _e55) {
    } else {
        return;
    }
    let _e408 = vertices.member[(0u + _e402)];
    if (_e65.i1_ < _e55) {
    } else {
        return;
    }
    let _e412 = vertices.member[(0u + _e65.i1_)];
    if (_e65.i2_ < _e55) {
    } else {
        return;
    }
    let _e416 = vertices.member[(0u + _e65.i2_)];
    let _e417 = array<abi_Vertex, 3>(_e408, _e412, _e416);
    if (_e417[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e425 = (_e138 - (_e43.x * _e178));
    let _e426 = (_e152 - (_e43.y * _e178));
    let _e429 = (_e248 - (_e43.x * _e288));
    let _e430 = (_e262 - (_e43.y * _e288));
    let _e433 = (_e358 - (_e43.x * _e398));
    let _e434 = (_e372 - (_e43.y * _e398));
    let _e437 = ((_e433 * _e430) - (_e434 * _e429));
    let _e440 = ((_e425 * _e434) - (_e426 * _e433));
    let _e443 = ((_e429 * _e426) - (_e430 * _e425));
    let _e445 = ((_e437 + _e440) + _e443);
    if (_e445 == 0f) {
        phi_948_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_948_ = vec3<f32>((_e437 / _e445), (_e440 / _e445), (_e443 / _e445));
    }
    let _e452 = phi_948_;
    let _e454 = materials.member[(0u + _e417[0].material)].flags;
    if ((_e454 & 1u) == 0u) {
        phi_1104_ = false;
    } else {
        let _e458 = materials.member[(0u + _e417[0].material)].cutoff;
        if (_e458 <= 0f) {
            phi_1103_ = true;
        } else {
            let _e462 = materials.member[(0u + _e417[0].material)].base_color[3u];
            let _e488 = (_e462 * ((((f32((_e417[0].color >> bitcast<u32>(24i))) * _e452.x) + (f32((_e417[1].color >> bitcast<u32>(24i))) * _e452.y)) + (f32((_e417[2].color >> bitcast<u32>(24i))) * _e452.z)) * (1f / 255f)));
            let _e490 = materials.member[(0u + _e417[0].material)].alpha_size;
            if (_e490 == 0u) {
                phi_1099_ = _e488;
            } else {
                let _e493 = materials.member[(0u + _e417[0].material)].alpha_offset;
                let _e495 = materials.member[(0u + _e417[0].material)].alpha_size;
                let _e497 = materials.member[(0u + _e417[0].material)].flags;
                local.offset = _e493;
                local.size = _e495;
                local.flags = _e497;
                let _e526 = _lt_shaders_texture_TextureView_quad((&local), (((_e417[0].u * _e452.x) + (_e417[1].u * _e452.y)) + (_e417[2].u * _e452.z)), (((_e417[0].v * _e452.x) + (_e417[1].v * _e452.y)) + (_e417[2].v * _e452.z)));
                let _e530 = (_e526.indices[0] >> bitcast<u32>(2i));
                if (_e530 < _e61) {
                } else {
                    return;
                }
                let _e534 = alpha_texels.member[(0u + _e530)];
                let _e550 = (_e526.indices[1] >> bitcast<u32>(2i));
                if (_e550 < _e61) {
                } else {
                    return;
                }
                let _e554 = alpha_texels.member[(0u + _e550)];
                let _e571 = (_e526.indices[2] >> bitcast<u32>(2i));
                if (_e571 < _e61) {
                } else {
                    return;
                }
                let _e575 = alpha_texels.member[(0u + _e571)];
                let _e592 = (_e526.indices[3] >> bitcast<u32>(2i));
                if (_e592 < _e61) {
                } else {
                    return;
                }
                let _e596 = alpha_texels.member[(0u + _e592)];
                phi_1099_ = (_e488 * (((((f32(((_e534 >> bitcast<u32>((((_e526.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e526.weights.x) + ((f32(((_e554 >> bitcast<u32>((((_e526.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e526.weights.y)) + ((f32(((_e575 >> bitcast<u32>((((_e526.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e526.weights.z)) + ((f32(((_e596 >> bitcast<u32>((((_e526.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e526.weights.w)));
            }
            let _e612 = phi_1099_;
            let _e614 = materials.member[(0u + _e417[0].material)].cutoff;
            phi_1103_ = (_e612 >= _e614);
        }
        let _e617 = phi_1103_;
        phi_1104_ = _e617;
    }
    let _e619 = phi_1104_;
    if _e619 {
    } else {
        spirv_std_arch_kill();
    }
    let _e624 = (_e138 - (_e43.x * _e178));
    let _e625 = (_e152 - (_e43.y * _e178));
    let _e628 = (_e248 - (_e43.x * _e288));
    let _e629 = (_e262 - (_e43.y * _e288));
    let _e632 = (_e358 - (_e43.x * _e398));
    let _e633 = (_e372 - (_e43.y * _e398));
    let _e636 = ((_e632 * _e629) - (_e633 * _e628));
    let _e639 = ((_e624 * _e633) - (_e625 * _e632));
    let _e642 = ((_e628 * _e625) - (_e629 * _e624));
    let _e644 = ((_e636 + _e639) + _e642);
    if (_e644 == 0f) {
        phi_1142_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_1142_ = vec3<f32>((_e636 / _e644), (_e639 / _e644), (_e642 / _e644));
    }
    let _e651 = phi_1142_;
    let _e659 = (((_e651.x * _e165) + (_e651.y * _e275)) + (_e651.z * _e385));
    let _e660 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e165, _e275);
    let _e661 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e660, _e385);
    let _e662 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e661, 0f);
    let _e663 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e165, _e275);
    let _e664 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e663, _e385);
    let _e665 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e664, 1f);
    if (_e659 > _e662) {
        if (_e659 < _e665) {
            phi_1165_ = _e659;
        } else {
            phi_1165_ = _e665;
        }
        let _e669 = phi_1165_;
        phi_1166_ = _e669;
    } else {
        phi_1166_ = _e662;
    }
    let _e671 = phi_1166_;
    depth = _e671;
    return;
}

@fragment 
fn entry_depth_depth_perspective_instanced_alpha_fs(@builtin(position) at: vec4<f32>, @location(0) @interpolate(flat) triangle: u32, @location(1) @interpolate(flat) placed: u32) -> @builtin(frag_depth) f32 {
    at_1 = at;
    triangle_1 = triangle;
    placed_1 = placed;
    function_();
    let _e7 = depth;
    return _e7;
}
