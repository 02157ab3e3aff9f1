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

struct type_19 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_23 {
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

struct type_27 {
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

struct type_35 {
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

struct type_41 {
    member: array<lt_bvh_Instance>,
}

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(1) 
var<storage> triangles: type_19;
@group(0) @binding(2) 
var<storage> instances: type_41;
var<private> depth: f32 = 0f;
var<private> placed_1: u32;
@group(0) @binding(3) 
var<storage> vertices: type_23;
@group(0) @binding(4) 
var<storage> materials: type_27;
@group(0) @binding(5) 
var<storage> alpha_texels: type_6;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_162_: f32;
    var phi_167_: f32;
    var phi_168_: bool;
    var phi_169_: f32;
    var phi_170_: bool;
    var phi_174_: f32;
    var phi_200_: f32;
    var phi_205_: f32;
    var phi_206_: bool;
    var phi_207_: f32;
    var phi_208_: bool;
    var phi_212_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_231_: f32;
    var phi_232_: f32;
    var phi_250_: u32;
    var phi_264_: u32;
    var phi_271_: u32;
    var phi_276_: u32;
    var phi_282_: u32;
    var phi_287_: u32;
    var phi_289_: texture_Axis;
    var phi_317_: f32;
    var phi_322_: f32;
    var phi_323_: bool;
    var phi_324_: f32;
    var phi_325_: bool;
    var phi_329_: f32;
    var phi_355_: f32;
    var phi_360_: f32;
    var phi_361_: bool;
    var phi_362_: f32;
    var phi_363_: bool;
    var phi_367_: f32;
    var phi_375_: f32;
    var phi_376_: f32;
    var phi_377_: f32;
    var phi_386_: f32;
    var phi_387_: f32;
    var phi_405_: u32;
    var phi_419_: u32;
    var phi_426_: u32;
    var phi_431_: u32;
    var phi_437_: u32;
    var phi_442_: u32;
    var phi_444_: texture_Axis;

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
                phi_162_ = 1f;
            } else {
                phi_162_ = 0f;
            }
            let _e76 = phi_162_;
            if (param_1 < 8388608f) {
                phi_167_ = (_e73 - _e76);
                phi_168_ = false;
            } else {
                phi_167_ = f32();
                phi_168_ = true;
            }
            let _e79 = phi_167_;
            let _e81 = phi_168_;
            phi_169_ = _e79;
            phi_170_ = _e81;
        } else {
            phi_169_ = f32();
            phi_170_ = true;
        }
        let _e83 = phi_169_;
        let _e85 = phi_170_;
        if _e85 {
            phi_174_ = param_1;
        } else {
            phi_174_ = _e83;
        }
        let _e87 = phi_174_;
        phi_222_ = (param_1 - _e87);
    } else {
        if (_e60 == 1u) {
            let _e90 = (param_1 * 0.5f);
            if (_e90 > -8388608f) {
                let _e102 = f32(select(0i, select(select(i32(_e90), i32(-2147483648), (_e90 < bitcast<f32>(3472883712u))), 2147483647i, (_e90 > bitcast<f32>(1325400063u))), (_e90 == _e90)));
                if (_e102 > _e90) {
                    phi_200_ = 1f;
                } else {
                    phi_200_ = 0f;
                }
                let _e105 = phi_200_;
                if (_e90 < 8388608f) {
                    phi_205_ = (_e102 - _e105);
                    phi_206_ = false;
                } else {
                    phi_205_ = f32();
                    phi_206_ = true;
                }
                let _e108 = phi_205_;
                let _e110 = phi_206_;
                phi_207_ = _e108;
                phi_208_ = _e110;
            } else {
                phi_207_ = f32();
                phi_208_ = true;
            }
            let _e112 = phi_207_;
            let _e114 = phi_208_;
            if _e114 {
                phi_212_ = _e90;
            } else {
                phi_212_ = _e112;
            }
            let _e116 = phi_212_;
            let _e118 = (param_1 - (2f * _e116));
            if (_e118 > 1f) {
                phi_220_ = (2f - _e118);
            } else {
                phi_220_ = _e118;
            }
            let _e122 = phi_220_;
            phi_221_ = _e122;
        } else {
            phi_221_ = param_1;
        }
        let _e124 = phi_221_;
        phi_222_ = _e124;
    }
    let _e126 = phi_222_;
    if (_e126 > 0f) {
        if (_e126 < 1f) {
            phi_231_ = _e126;
        } else {
            phi_231_ = 1f;
        }
        let _e130 = phi_231_;
        phi_232_ = _e130;
    } else {
        phi_232_ = 0f;
    }
    let _e132 = phi_232_;
    let _e133 = (_e47 - 1u);
    let _e135 = (_e132 * f32(_e47));
    if _e55 {
        let _e142 = select(select(u32(_e135), 0u, (_e135 < bitcast<f32>(0u))), 4294967295u, (_e135 > bitcast<f32>(1333788671u)));
        if (_e133 < _e142) {
            phi_250_ = _e133;
        } else {
            phi_250_ = _e142;
        }
        let _e145 = phi_250_;
        phi_289_ = texture_Axis(_e145, _e145, 0f);
    } else {
        let _e147 = (_e135 + 0.5f);
        let _e154 = select(select(u32(_e147), 0u, (_e147 < bitcast<f32>(0u))), 4294967295u, (_e147 > bitcast<f32>(1333788671u)));
        if (_e47 < _e154) {
            phi_264_ = _e47;
        } else {
            phi_264_ = _e154;
        }
        let _e157 = phi_264_;
        if (_e60 == 0u) {
            phi_271_ = _e133;
        } else {
            phi_271_ = 0u;
        }
        let _e162 = phi_271_;
        if (_e60 == 0u) {
            phi_276_ = 0u;
        } else {
            phi_276_ = _e133;
        }
        let _e165 = phi_276_;
        if (_e157 == 0u) {
            phi_282_ = _e162;
        } else {
            phi_282_ = (_e157 - 1u);
        }
        let _e169 = phi_282_;
        if (_e157 > _e133) {
            phi_287_ = _e165;
        } else {
            phi_287_ = _e157;
        }
        let _e172 = phi_287_;
        phi_289_ = texture_Axis(_e169, _e172, (_e147 - f32(_e157)));
    }
    let _e175 = phi_289_;
    let _e177 = (*param).flags;
    let _e180 = ((_e177 >> bitcast<u32>(6u)) & 3u);
    if (_e180 == 0u) {
        if (param_2 > -8388608f) {
            let _e193 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e193 > param_2) {
                phi_317_ = 1f;
            } else {
                phi_317_ = 0f;
            }
            let _e196 = phi_317_;
            if (param_2 < 8388608f) {
                phi_322_ = (_e193 - _e196);
                phi_323_ = false;
            } else {
                phi_322_ = f32();
                phi_323_ = true;
            }
            let _e199 = phi_322_;
            let _e201 = phi_323_;
            phi_324_ = _e199;
            phi_325_ = _e201;
        } else {
            phi_324_ = f32();
            phi_325_ = true;
        }
        let _e203 = phi_324_;
        let _e205 = phi_325_;
        if _e205 {
            phi_329_ = param_2;
        } else {
            phi_329_ = _e203;
        }
        let _e207 = phi_329_;
        phi_377_ = (param_2 - _e207);
    } else {
        if (_e180 == 1u) {
            let _e210 = (param_2 * 0.5f);
            if (_e210 > -8388608f) {
                let _e222 = f32(select(0i, select(select(i32(_e210), i32(-2147483648), (_e210 < bitcast<f32>(3472883712u))), 2147483647i, (_e210 > bitcast<f32>(1325400063u))), (_e210 == _e210)));
                if (_e222 > _e210) {
                    phi_355_ = 1f;
                } else {
                    phi_355_ = 0f;
                }
                let _e225 = phi_355_;
                if (_e210 < 8388608f) {
                    phi_360_ = (_e222 - _e225);
                    phi_361_ = false;
                } else {
                    phi_360_ = f32();
                    phi_361_ = true;
                }
                let _e228 = phi_360_;
                let _e230 = phi_361_;
                phi_362_ = _e228;
                phi_363_ = _e230;
            } else {
                phi_362_ = f32();
                phi_363_ = true;
            }
            let _e232 = phi_362_;
            let _e234 = phi_363_;
            if _e234 {
                phi_367_ = _e210;
            } else {
                phi_367_ = _e232;
            }
            let _e236 = phi_367_;
            let _e238 = (param_2 - (2f * _e236));
            if (_e238 > 1f) {
                phi_375_ = (2f - _e238);
            } else {
                phi_375_ = _e238;
            }
            let _e242 = phi_375_;
            phi_376_ = _e242;
        } else {
            phi_376_ = param_2;
        }
        let _e244 = phi_376_;
        phi_377_ = _e244;
    }
    let _e246 = phi_377_;
    if (_e246 > 0f) {
        if (_e246 < 1f) {
            phi_386_ = _e246;
        } else {
            phi_386_ = 1f;
        }
        let _e250 = phi_386_;
        phi_387_ = _e250;
    } else {
        phi_387_ = 0f;
    }
    let _e252 = phi_387_;
    let _e253 = (_e51 - 1u);
    let _e255 = (_e252 * f32(_e51));
    if _e55 {
        let _e262 = select(select(u32(_e255), 0u, (_e255 < bitcast<f32>(0u))), 4294967295u, (_e255 > bitcast<f32>(1333788671u)));
        if (_e253 < _e262) {
            phi_405_ = _e253;
        } else {
            phi_405_ = _e262;
        }
        let _e265 = phi_405_;
        phi_444_ = texture_Axis(_e265, _e265, 0f);
    } else {
        let _e267 = (_e255 + 0.5f);
        let _e274 = select(select(u32(_e267), 0u, (_e267 < bitcast<f32>(0u))), 4294967295u, (_e267 > bitcast<f32>(1333788671u)));
        if (_e51 < _e274) {
            phi_419_ = _e51;
        } else {
            phi_419_ = _e274;
        }
        let _e277 = phi_419_;
        if (_e180 == 0u) {
            phi_426_ = _e253;
        } else {
            phi_426_ = 0u;
        }
        let _e282 = phi_426_;
        if (_e180 == 0u) {
            phi_431_ = 0u;
        } else {
            phi_431_ = _e253;
        }
        let _e285 = phi_431_;
        if (_e277 == 0u) {
            phi_437_ = _e282;
        } else {
            phi_437_ = (_e277 - 1u);
        }
        let _e289 = phi_437_;
        if (_e277 > _e253) {
            phi_442_ = _e285;
        } else {
            phi_442_ = _e277;
        }
        let _e292 = phi_442_;
        phi_444_ = texture_Axis(_e289, _e292, (_e267 - f32(_e277)));
    }
    let _e295 = phi_444_;
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
    var phi_500_: f32;

    if (param_3 < param_4) {
        phi_500_ = param_3;
    } else {
        phi_500_ = param_4;
    }
    let _e46 = phi_500_;
    return _e46;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(param_5: f32, param_6: f32) -> f32 {
    var phi_508_: f32;

    if (param_5 > param_6) {
        phi_508_ = param_5;
    } else {
        phi_508_ = param_6;
    }
    let _e46 = phi_508_;
    return _e46;
}

fn function_() {
    var local: texture_TextureView;
    var phi_550_: vec3<f32>;
    var phi_551_: vec3<f32>;
    var phi_660_: vec3<f32>;
    var phi_661_: vec3<f32>;
    var phi_770_: vec3<f32>;
    var phi_771_: vec3<f32>;
    var phi_902_: vec3<f32>;
    var phi_1086_: f32;
    var phi_1090_: bool;
    var phi_1091_: bool;
    var phi_1129_: vec3<f32>;
    var phi_1152_: f32;
    var phi_1153_: f32;

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
    let _e69 = instances.member[(0u + _e45)];
    if (0u == 0u) {
        phi_551_ = _e65.v0_;
    } else {
        if (0u == 1u) {
            phi_550_ = _e65.v1_;
        } else {
            phi_550_ = _e65.v2_;
        }
        let _e76 = phi_550_;
        phi_551_ = _e76;
    }
    let _e78 = phi_551_;
    let _e94 = ((((_e69.object_to_world[0].x * _e78.x) + (_e69.object_to_world[0].y * _e78.y)) + (_e69.object_to_world[0].z * _e78.z)) + (_e69.object_to_world[0].w * 1f));
    let _e107 = ((((_e69.object_to_world[1].x * _e78.x) + (_e69.object_to_world[1].y * _e78.y)) + (_e69.object_to_world[1].z * _e78.z)) + (_e69.object_to_world[1].w * 1f));
    let _e120 = ((((_e69.object_to_world[2].x * _e78.x) + (_e69.object_to_world[2].y * _e78.y)) + (_e69.object_to_world[2].z * _e78.z)) + (_e69.object_to_world[2].w * 1f));
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
        phi_661_ = _e65.v0_;
    } else {
        if (1u == 1u) {
            phi_660_ = _e65.v1_;
        } else {
            phi_660_ = _e65.v2_;
        }
        let _e185 = phi_660_;
        phi_661_ = _e185;
    }
    let _e187 = phi_661_;
    let _e203 = ((((_e69.object_to_world[0].x * _e187.x) + (_e69.object_to_world[0].y * _e187.y)) + (_e69.object_to_world[0].z * _e187.z)) + (_e69.object_to_world[0].w * 1f));
    let _e216 = ((((_e69.object_to_world[1].x * _e187.x) + (_e69.object_to_world[1].y * _e187.y)) + (_e69.object_to_world[1].z * _e187.z)) + (_e69.object_to_world[1].w * 1f));
    let _e229 = ((((_e69.object_to_world[2].x * _e187.x) + (_e69.object_to_world[2].y * _e187.y)) + (_e69.object_to_world[2].z * _e187.z)) + (_e69.object_to_world[2].w * 1f));
    let _e231 = p.member.map_size;
    let _e233 = f32(_e231);
    let _e235 = p.member.projection.row_x;
    let _e247 = (((((_e235.x * _e203) + (_e235.y * _e216)) + (_e235.z * _e229)) + (_e235.w * 1f)) * _e233);
    let _e249 = p.member.projection.row_y;
    let _e261 = (((((_e249.x * _e203) + (_e249.y * _e216)) + (_e249.z * _e229)) + (_e249.w * 1f)) * _e233);
    let _e263 = p.member.projection.row_z;
    let _e274 = ((((_e263.x * _e203) + (_e263.y * _e216)) + (_e263.z * _e229)) + (_e263.w * 1f));
    let _e276 = p.member.projection.row_w;
    let _e287 = ((((_e276.x * _e203) + (_e276.y * _e216)) + (_e276.z * _e229)) + (_e276.w * 1f));
    if (2u == 0u) {
        phi_771_ = _e65.v0_;
    } else {
        if (2u == 1u) {
            phi_770_ = _e65.v1_;
        } else {
            phi_770_ = _e65.v2_;
        }
        let _e294 = phi_770_;
        phi_771_ = _e294;
    }
    let _e296 = phi_771_;
    let _e312 = ((((_e69.object_to_world[0].x * _e296.x) + (_e69.object_to_world[0].y * _e296.y)) + (_e69.object_to_world[0].z * _e296.z)) + (_e69.object_to_world[0].w * 1f));
    let _e325 = ((((_e69.object_to_world[1].x * _e296.x) + (_e69.object_to_world[1].y * _e296.y)) + (_e69.object_to_world[1].z * _e296.z)) + (_e69.object_to_world[1].w * 1f));
    let _e338 = ((((_e69.object_to_world[2].x * _e296.x) + (_e69.object_to_world[2].y * _e296.y)) + (_e69.object_to_world[2].z * _e296.z)) + (_e69.object_to_world[2].w * 1f));
    let _e340 = p.member.map_size;
    let _e342 = f32(_e340);
    let _e344 = p.member.projection.row_x;
    let _e356 = (((((_e344.x * _e312) + (_e344.y * _e325)) + (_e344.z * _e338)) + (_e344.w * 1f)) * _e342);
    let _e358 = p.member.projection.row_y;
    let _e370 = (((((_e358.x * _e312) + (_e358.y * _e325)) + (_e358.z * _e338)) + (_e358.w * 1f)) * _e342);
    let _e372 = p.member.projection.row_z;
    let _e383 = ((((_e372.x * _e312) + (_e372.y * _e325)) + (_e372.z * _e338)) + (_e372.w * 1f));
    let _e385 = p.member.projection.row_w;
    let _e396 = ((((_e385.x * _e312) + (_e385.y * _e325)) + (_e385.z * _e338)) + (_e385.w * 1f));
    let _e401 = (_e138 - (_e43.x * _e178));
    let _e402 = (_e152 - (_e43.y * _e178));
    let _e405 = (_e247 - (_e43.x * _e287));
    let _e406 = (_e261 - (_e43.y * _e287));
    let _e409 = (_e356 - (_e43.x * _e396));
    let _e410 = (_e370 - (_e43.y * _e396));
    let _e413 = ((_e409 * _e406) - (_e410 * _e405));
    let _e416 = ((_e401 * _e410) - (_e402 * _e409));
    let _e419 = ((_e405 * _e402) - (_e406 * _e401));
    let _e421 = ((_e413 + _e416) + _e419);
    if (_e421 == 0f) {
        phi_902_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_902_ = vec3<f32>((_e413 / _e421), (_e416 / _e421), (_e419 / _e421));
    }
    let _e428 = phi_902_;
    let _e430 = (_e65.i0_ & 2147483647u);
    if (_e430 < _e55) {
    } else {
        return;
    }
    let _e436 = vertices.member[(0u + _e430)];
    if (_e65.i1_ < _e55) {
    } else {
        return;
    }
    let _e440 = vertices.member[(0u + _e65.i1_)];
    if (_e65.i2_ < _e55) {
    } else {
        return;
    }
    let _e444 = vertices.member[(0u + _e65.i2_)];
    let _e445 = array<abi_Vertex, 3>(_e436, _e440, _e444);
    if (_e445[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e452 = materials.member[(0u + _e445[0].material)].flags;
    if ((_e452 & 1u) == 0u) {
        phi_1091_ = false;
    } else {
        let _e456 = materials.member[(0u + _e445[0].material)].cutoff;
        if (_e456 <= 0f) {
            phi_1090_ = true;
        } else {
            let _e460 = materials.member[(0u + _e445[0].material)].base_color[3u];
            let _e486 = (_e460 * ((((f32((_e445[0].color >> bitcast<u32>(24i))) * _e428.x) + (f32((_e445[1].color >> bitcast<u32>(24i))) * _e428.y)) + (f32((_e445[2].color >> bitcast<u32>(24i))) * _e428.z)) * (1f / 255f)));
            let _e488 = materials.member[(0u + _e445[0].material)].alpha_size;
            if (_e488 == 0u) {
                phi_1086_ = _e486;
            } else {
                let _e491 = materials.member[(0u + _e445[0].material)].alpha_offset;
                let _e493 = materials.member[(0u + _e445[0].material)].alpha_size;
                let _e495 = materials.member[(0u + _e445[0].material)].flags;
                local.offset = _e491;
                local.size = _e493;
                local.flags = _e495;
                let _e524 = _lt_shaders_texture_TextureView_quad((&local), (((_e445[0].u * _e428.x) + (_e445[1].u * _e428.y)) + (_e445[2].u * _e428.z)), (((_e445[0].v * _e428.x) + (_e445[1].v * _e428.y)) + (_e445[2].v * _e428.z)));
                let _e528 = (_e524.indices[0] >> bitcast<u32>(2i));
                if (_e528 < _e61) {
                } else {
                    return;
                }
                let _e532 = alpha_texels.member[(0u + _e528)];
                let _e548 = (_e524.indices[1] >> bitcast<u32>(2i));
                if (_e548 < _e61) {
                } else {
                    return;
                }
                let _e552 = alpha_texels.member[(0u + _e548)];
                let _e569 = (_e524.indices[2] >> bitcast<u32>(2i));
                if (_e569 < _e61) {
                } else {
                    return;
                }
                let _e573 = alpha_texels.member[(0u + _e569)];
                let _e590 = (_e524.indices[3] >> bitcast<u32>(2i));
                if (_e590 < _e61) {
                } else {
                    return;
                }
                let _e594 = alpha_texels.member[(0u + _e590)];
                phi_1086_ = (_e486 * (((((f32(((_e532 >> bitcast<u32>((((_e524.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e524.weights.x) + ((f32(((_e552 >> bitcast<u32>((((_e524.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e524.weights.y)) + ((f32(((_e573 >> bitcast<u32>((((_e524.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e524.weights.z)) + ((f32(((_e594 >> bitcast<u32>((((_e524.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e524.weights.w)));
            }
            let _e610 = phi_1086_;
            let _e612 = materials.member[(0u + _e445[0].material)].cutoff;
            phi_1090_ = (_e610 >= _e612);
        }
        let _e615 = phi_1090_;
        phi_1091_ = _e615;
    }
    let _e617 = phi_1091_;
    if _e617 {
    } else {
        spirv_std_arch_kill();
    }
    let _e622 = (_e138 - (_e43.x * _e178));
    let _e623 = (_e152 - (_e43.y * _e178));
    let _e626 = (_e247 - (_e43.x * _e287));
    let _e627 = (_e261 - (_e43.y * _e287));
    let _e630 = (_e356 - (_e43.x * _e396));
    let _e631 = (_e370 - (_e43.y * _e396));
    let _e634 = ((_e630 * _e627) - (_e631 * _e626));
    let _e637 = ((_e622 * _e631) - (_e623 * _e630));
    let _e640 = ((_e626 * _e623) - (_e627 * _e622));
    let _e642 = ((_e634 + _e637) + _e640);
    if (_e642 == 0f) {
        phi_1129_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_1129_ = vec3<f32>((_e634 / _e642), (_e637 / _e642), (_e640 / _e642));
    }
    let _e649 = phi_1129_;
    let _e657 = (((_e649.x * _e165) + (_e649.y * _e274)) + (_e649.z * _e383));
    let _e658 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e165, _e274);
    let _e659 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e658, _e383);
    let _e660 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e659, 0f);
    let _e661 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e165, _e274);
    let _e662 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e661, _e383);
    let _e663 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e662, 1f);
    if (_e657 > _e660) {
        if (_e657 < _e663) {
            phi_1152_ = _e657;
        } else {
            phi_1152_ = _e663;
        }
        let _e667 = phi_1152_;
        phi_1153_ = _e667;
    } else {
        phi_1153_ = _e660;
    }
    let _e669 = phi_1153_;
    depth = _e669;
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
