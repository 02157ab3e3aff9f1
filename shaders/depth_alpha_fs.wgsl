struct texture_TextureView {
    offset: u32,
    size: u32,
    flags: u32,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_DepthParams {
    projection: lt_math_LightProjection,
    map_size: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_12 {
    member: abi_DepthParams,
}

struct lt_bvh_Triangle {
    v0_: vec3<f32>,
    i0_: u32,
    v1_: vec3<f32>,
    i1_: u32,
    v2_: vec3<f32>,
    i2_: u32,
}

struct type_16 {
    member: array<lt_bvh_Triangle>,
}

struct type_20 {
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

struct type_25 {
    member: array<abi_Material>,
}

struct type_29 {
    member: array<u32>,
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

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_12;
@group(0) @binding(1) 
var<storage> triangles: type_16;
@group(0) @binding(2) 
var<storage> vertices: type_20;
@group(0) @binding(3) 
var<storage> materials: type_25;
@group(0) @binding(4) 
var<storage> alpha_texels: type_29;

fn spirv_std_arch_kill() {
    discard;
}

fn lt_shaders_texture_wrap_to_unit(param: f32, param_1: u32) -> f32 {
    var phi_818_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_829_: f32;
    var phi_830_: f32;

    if (param_1 == 0u) {
        phi_820_ = (param - floor(param));
    } else {
        if (param_1 == 1u) {
            let _e41 = (param - (2f * floor((param * 0.5f))));
            if (_e41 > 1f) {
                phi_818_ = (2f - _e41);
            } else {
                phi_818_ = _e41;
            }
            let _e45 = phi_818_;
            phi_819_ = _e45;
        } else {
            phi_819_ = param;
        }
        let _e47 = phi_819_;
        phi_820_ = _e47;
    }
    let _e49 = phi_820_;
    if (_e49 > 0f) {
        if (_e49 < 1f) {
            phi_829_ = _e49;
        } else {
            phi_829_ = 1f;
        }
        let _e53 = phi_829_;
        phi_830_ = _e53;
    } else {
        phi_830_ = 0f;
    }
    let _e55 = phi_830_;
    return _e55;
}

fn lt_shaders_texture_axis(param_2: f32, param_3: u32, param_4: u32, param_5: bool) -> texture_Axis {
    var phi_756_: u32;
    var phi_770_: u32;
    var phi_777_: u32;
    var phi_782_: u32;
    var phi_788_: u32;
    var phi_793_: u32;
    var phi_795_: texture_Axis;

    let _e36 = lt_shaders_texture_wrap_to_unit(param_2, param_4);
    let _e37 = (param_3 - 1u);
    let _e39 = (_e36 * f32(param_3));
    if param_5 {
        let _e46 = select(select(u32(_e39), 0u, (_e39 < bitcast<f32>(0u))), 4294967295u, (_e39 > bitcast<f32>(1333788671u)));
        if (_e37 < _e46) {
            phi_756_ = _e37;
        } else {
            phi_756_ = _e46;
        }
        let _e49 = phi_756_;
        phi_795_ = texture_Axis(_e49, _e49, 0f);
    } else {
        let _e51 = (_e39 + 0.5f);
        let _e58 = select(select(u32(_e51), 0u, (_e51 < bitcast<f32>(0u))), 4294967295u, (_e51 > bitcast<f32>(1333788671u)));
        if (param_3 < _e58) {
            phi_770_ = param_3;
        } else {
            phi_770_ = _e58;
        }
        let _e61 = phi_770_;
        if (param_4 == 0u) {
            phi_777_ = _e37;
        } else {
            phi_777_ = 0u;
        }
        let _e66 = phi_777_;
        if (param_4 == 0u) {
            phi_782_ = 0u;
        } else {
            phi_782_ = _e37;
        }
        let _e69 = phi_782_;
        if (_e61 == 0u) {
            phi_788_ = _e66;
        } else {
            phi_788_ = (_e61 - 1u);
        }
        let _e73 = phi_788_;
        if (_e61 > _e37) {
            phi_793_ = _e69;
        } else {
            phi_793_ = _e61;
        }
        let _e76 = phi_793_;
        phi_795_ = texture_Axis(_e73, _e76, (_e51 - f32(_e61)));
    }
    let _e79 = phi_795_;
    return _e79;
}

fn _lt_shaders_texture_TextureView_quad(param_6: ptr<function, texture_TextureView>, param_7: f32, param_8: f32) -> texture_TexelQuad {
    let _e36 = (*param_6).size;
    let _e37 = (_e36 & 65535u);
    let _e39 = (*param_6).size;
    let _e43 = (*param_6).flags;
    let _e45 = ((_e43 & 4u) != 0u);
    let _e47 = (*param_6).flags;
    let _e51 = lt_shaders_texture_axis(param_7, _e37, ((_e47 >> bitcast<u32>(4u)) & 3u), _e45);
    let _e53 = (*param_6).flags;
    let _e57 = lt_shaders_texture_axis(param_8, (_e39 >> bitcast<u32>(16i)), ((_e53 >> bitcast<u32>(6u)) & 3u), _e45);
    let _e61 = (*param_6).offset;
    let _e68 = (*param_6).offset;
    let _e75 = (*param_6).offset;
    let _e82 = (*param_6).offset;
    return texture_TexelQuad(array<u32, 4>(((_e61 + (_e57.low * _e37)) + _e51.low), ((_e68 + (_e57.low * _e37)) + _e51.high), ((_e75 + (_e57.high * _e37)) + _e51.low), ((_e82 + (_e57.high * _e37)) + _e51.high)), vec4<f32>(((1f - _e51.fraction) * (1f - _e57.fraction)), (_e51.fraction * (1f - _e57.fraction)), ((1f - _e51.fraction) * _e57.fraction), (_e51.fraction * _e57.fraction)));
}

fn lt_shaders_surface_texture_coordinate(param_9: ptr<function, array<abi_Vertex, 3>>, param_10: vec3<f32>) -> vec2<f32> {
    let _e36 = (*param_9)[0u].u;
    let _e39 = (*param_9)[0u].v;
    let _e45 = (*param_9)[1u].u;
    let _e48 = (*param_9)[1u].v;
    let _e56 = (*param_9)[2u].u;
    let _e59 = (*param_9)[2u].v;
    return vec2<f32>((((_e36 * param_10.x) + (_e45 * param_10.y)) + (_e56 * param_10.z)), (((_e39 * param_10.x) + (_e48 * param_10.y)) + (_e59 * param_10.z)));
}

fn lt_shaders_texture_unorm_bytes(param_11: u32) -> vec4<f32> {
    let _e46 = (1f / 255f);
    return vec4<f32>((f32((param_11 & 255u)) * _e46), (f32(((param_11 >> bitcast<u32>(8i)) & 255u)) * _e46), (f32(((param_11 >> bitcast<u32>(16i)) & 255u)) * _e46), (f32((param_11 >> bitcast<u32>(24i))) * _e46));
}

fn lt_shaders_surface_vertex_color(param_12: ptr<function, array<abi_Vertex, 3>>, param_13: vec3<f32>) -> vec4<f32> {
    let _e36 = (*param_12)[0u].color;
    let _e37 = lt_shaders_texture_unorm_bytes(_e36);
    let _e49 = (*param_12)[1u].color;
    let _e50 = lt_shaders_texture_unorm_bytes(_e49);
    let _e66 = (*param_12)[2u].color;
    let _e67 = lt_shaders_texture_unorm_bytes(_e66);
    return vec4<f32>((((_e37.x * param_13.x) + (_e50.x * param_13.y)) + (_e67.x * param_13.z)), (((_e37.y * param_13.x) + (_e50.y * param_13.y)) + (_e67.y * param_13.z)), (((_e37.z * param_13.x) + (_e50.z * param_13.y)) + (_e67.z * param_13.z)), (((_e37.w * param_13.x) + (_e50.w * param_13.y)) + (_e67.w * param_13.z)));
}

fn lt_shaders_depth_weights_at(param_14: f32, param_15: f32, param_16: ptr<function, array<vec3<f32>, 3>>) -> vec3<f32> {
    var phi_560_: vec3<f32>;

    let _e36 = (*param_16)[0u];
    let _e39 = (_e36.x - param_14);
    let _e40 = (_e36.y - param_15);
    let _e42 = (*param_16)[1u];
    let _e45 = (_e42.x - param_14);
    let _e46 = (_e42.y - param_15);
    let _e48 = (*param_16)[2u];
    let _e51 = (_e48.x - param_14);
    let _e52 = (_e48.y - param_15);
    let _e55 = ((_e51 * _e46) - (_e52 * _e45));
    let _e58 = ((_e39 * _e52) - (_e40 * _e51));
    let _e61 = ((_e45 * _e40) - (_e46 * _e39));
    let _e63 = ((_e55 + _e58) + _e61);
    if (_e63 == 0f) {
        phi_560_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_560_ = vec3<f32>((_e55 / _e63), (_e58 / _e63), (_e61 / _e63));
    }
    let _e70 = phi_560_;
    return _e70;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<vec3<f32>, 3>;
    var local_2: array<abi_Vertex, 3>;
    var phi_157_: vec3<f32>;
    var phi_158_: vec3<f32>;
    var phi_219_: vec3<f32>;
    var phi_220_: vec3<f32>;
    var phi_281_: vec3<f32>;
    var phi_282_: vec3<f32>;
    var phi_509_: f32;
    var phi_513_: bool;
    var phi_514_: bool;

    let _e35 = at_1;
    let _e36 = triangle_1;
    let _e43 = arrayLength((&vertices.member));
    let _e49 = arrayLength((&alpha_texels.member));
    if (_e36 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e53 = triangles.member[(0u + _e36)];
    if (0u == 0u) {
        phi_158_ = _e53.v0_;
    } else {
        if (0u == 1u) {
            phi_157_ = _e53.v1_;
        } else {
            phi_157_ = _e53.v2_;
        }
        let _e62 = phi_157_;
        phi_158_ = _e62;
    }
    let _e64 = phi_158_;
    let _e66 = p.member.map_size;
    let _e71 = f32(_e66);
    let _e73 = p.member.projection.row_x;
    let _e87 = p.member.projection.row_y;
    let _e101 = p.member.projection.row_z;
    if (1u == 0u) {
        phi_220_ = _e53.v0_;
    } else {
        if (1u == 1u) {
            phi_219_ = _e53.v1_;
        } else {
            phi_219_ = _e53.v2_;
        }
        let _e120 = phi_219_;
        phi_220_ = _e120;
    }
    let _e122 = phi_220_;
    let _e124 = p.member.map_size;
    let _e129 = f32(_e124);
    let _e131 = p.member.projection.row_x;
    let _e145 = p.member.projection.row_y;
    let _e159 = p.member.projection.row_z;
    if (2u == 0u) {
        phi_282_ = _e53.v0_;
    } else {
        if (2u == 1u) {
            phi_281_ = _e53.v1_;
        } else {
            phi_281_ = _e53.v2_;
        }
        let _e178 = phi_281_;
        phi_282_ = _e178;
    }
    let _e180 = phi_282_;
    let _e182 = p.member.map_size;
    let _e187 = f32(_e182);
    let _e189 = p.member.projection.row_x;
    let _e203 = p.member.projection.row_y;
    let _e217 = p.member.projection.row_z;
    local_1[0u] = vec3<f32>((((((_e73.x * _e64.x) + (_e73.y * _e64.y)) + (_e73.z * _e64.z)) + (_e73.w * 1f)) * _e71), (((((_e87.x * _e64.x) + (_e87.y * _e64.y)) + (_e87.z * _e64.z)) + (_e87.w * 1f)) * _e71), ((((_e101.x * _e64.x) + (_e101.y * _e64.y)) + (_e101.z * _e64.z)) + (_e101.w * 1f)));
    local_1[1u] = vec3<f32>((((((_e131.x * _e122.x) + (_e131.y * _e122.y)) + (_e131.z * _e122.z)) + (_e131.w * 1f)) * _e129), (((((_e145.x * _e122.x) + (_e145.y * _e122.y)) + (_e145.z * _e122.z)) + (_e145.w * 1f)) * _e129), ((((_e159.x * _e122.x) + (_e159.y * _e122.y)) + (_e159.z * _e122.z)) + (_e159.w * 1f)));
    local_1[2u] = vec3<f32>((((((_e189.x * _e180.x) + (_e189.y * _e180.y)) + (_e189.z * _e180.z)) + (_e189.w * 1f)) * _e187), (((((_e203.x * _e180.x) + (_e203.y * _e180.y)) + (_e203.z * _e180.z)) + (_e203.w * 1f)) * _e187), ((((_e217.x * _e180.x) + (_e217.y * _e180.y)) + (_e217.z * _e180.z)) + (_e217.w * 1f)));
    let _e233 = lt_shaders_depth_weights_at(_e35.x, _e35.y, (&local_1));
    let _e235 = (_e53.i0_ & 2147483647u);
    if (_e235 < _e43) {
    } else {
        return;
    }
    let _e241 = vertices.member[(0u + _e235)];
    if (_e53.i1_ < _e43) {
    } else {
        return;
    }
    let _e245 = vertices.member[(0u + _e53.i1_)];
    if (_e53.i2_ < _e43) {
    } else {
        return;
    }
    let _e249 = vertices.member[(0u + _e53.i2_)];
    let _e250 = array<abi_Vertex, 3>(_e241, _e245, _e249);
    local_2 = array<abi_Vertex, 3>(abi_Vertex(_e250[0].u, _e250[0].v, _e250[0].normal, _e250[0].color, _e250[0].material), abi_Vertex(_e250[1].u, _e250[1].v, _e250[1].normal, _e250[1].color, _e250[1].material), abi_Vertex(_e250[2].u, _e250[2].v, _e250[2].normal, _e250[2].color, _e250[2].material));
    let _e275 = local_2[0u].material;
    if (_e275 < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e280 = materials.member[(0u + _e275)].flags;
    if ((_e280 & 1u) == 0u) {
        phi_514_ = false;
    } else {
        let _e284 = materials.member[(0u + _e275)].cutoff;
        if (_e284 <= 0f) {
            phi_513_ = true;
        } else {
            let _e288 = materials.member[(0u + _e275)].base_color[3u];
            let _e289 = lt_shaders_surface_vertex_color((&local_2), _e233);
            let _e291 = (_e288 * _e289.w);
            let _e293 = materials.member[(0u + _e275)].alpha_size;
            if (_e293 == 0u) {
                phi_509_ = _e291;
            } else {
                let _e296 = materials.member[(0u + _e275)].alpha_offset;
                let _e298 = materials.member[(0u + _e275)].alpha_size;
                let _e300 = materials.member[(0u + _e275)].flags;
                local.offset = _e296;
                local.size = _e298;
                local.flags = _e300;
                let _e304 = lt_shaders_surface_texture_coordinate((&local_2), _e233);
                let _e307 = _lt_shaders_texture_TextureView_quad((&local), _e304.x, _e304.y);
                let _e311 = (_e307.indices[0] >> bitcast<u32>(2i));
                if (_e311 < _e49) {
                } else {
                    return;
                }
                let _e315 = alpha_texels.member[(0u + _e311)];
                let _e331 = (_e307.indices[1] >> bitcast<u32>(2i));
                if (_e331 < _e49) {
                } else {
                    return;
                }
                let _e335 = alpha_texels.member[(0u + _e331)];
                let _e352 = (_e307.indices[2] >> bitcast<u32>(2i));
                if (_e352 < _e49) {
                } else {
                    return;
                }
                let _e356 = alpha_texels.member[(0u + _e352)];
                let _e373 = (_e307.indices[3] >> bitcast<u32>(2i));
                if (_e373 < _e49) {
                } else {
                    return;
                }
                let _e377 = alpha_texels.member[(0u + _e373)];
                phi_509_ = (_e291 * (((((f32(((_e315 >> bitcast<u32>((((_e307.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e307.weights.x) + ((f32(((_e335 >> bitcast<u32>((((_e307.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e307.weights.y)) + ((f32(((_e356 >> bitcast<u32>((((_e307.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e307.weights.z)) + ((f32(((_e377 >> bitcast<u32>((((_e307.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e307.weights.w)));
            }
            let _e393 = phi_509_;
            let _e395 = materials.member[(0u + _e275)].cutoff;
            phi_513_ = (_e393 >= _e395);
        }
        let _e398 = phi_513_;
        phi_514_ = _e398;
    }
    let _e400 = phi_514_;
    if _e400 {
    } else {
        spirv_std_arch_kill();
    }
    return;
}

@fragment 
fn entry_depth_depth_alpha_fs(@builtin(position) at: vec4<f32>, @location(0) @interpolate(flat) triangle: u32) {
    at_1 = at;
    triangle_1 = triangle;
    function_();
}
