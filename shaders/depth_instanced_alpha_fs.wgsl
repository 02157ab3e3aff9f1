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

struct type_50 {
    member: array<lt_bvh_Instance>,
}

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_12;
@group(0) @binding(1) 
var<storage> triangles: type_16;
@group(0) @binding(2) 
var<storage> instances: type_50;
var<private> placed_1: u32;
@group(0) @binding(3) 
var<storage> vertices: type_20;
@group(0) @binding(4) 
var<storage> materials: type_25;
@group(0) @binding(5) 
var<storage> alpha_texels: type_29;

fn lt_shaders_depth_weights_at(param: f32, param_1: f32, param_2: ptr<function, array<vec3<f32>, 3>>) -> vec3<f32> {
    var phi_174_: vec3<f32>;

    let _e38 = (*param_2)[0u];
    let _e41 = (_e38.x - param);
    let _e42 = (_e38.y - param_1);
    let _e44 = (*param_2)[1u];
    let _e47 = (_e44.x - param);
    let _e48 = (_e44.y - param_1);
    let _e50 = (*param_2)[2u];
    let _e53 = (_e50.x - param);
    let _e54 = (_e50.y - param_1);
    let _e57 = ((_e53 * _e48) - (_e54 * _e47));
    let _e60 = ((_e41 * _e54) - (_e42 * _e53));
    let _e63 = ((_e47 * _e42) - (_e48 * _e41));
    let _e65 = ((_e57 + _e60) + _e63);
    if (_e65 == 0f) {
        phi_174_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_174_ = vec3<f32>((_e57 / _e65), (_e60 / _e65), (_e63 / _e65));
    }
    let _e72 = phi_174_;
    return _e72;
}

fn lt_shaders_texture_unorm_bytes(param_3: u32) -> vec4<f32> {
    let _e48 = (1f / 255f);
    return vec4<f32>((f32((param_3 & 255u)) * _e48), (f32(((param_3 >> bitcast<u32>(8i)) & 255u)) * _e48), (f32(((param_3 >> bitcast<u32>(16i)) & 255u)) * _e48), (f32((param_3 >> bitcast<u32>(24i))) * _e48));
}

fn lt_shaders_surface_vertex_color(param_4: ptr<function, array<abi_Vertex, 3>>, param_5: vec3<f32>) -> vec4<f32> {
    let _e38 = (*param_4)[0u].color;
    let _e39 = lt_shaders_texture_unorm_bytes(_e38);
    let _e51 = (*param_4)[1u].color;
    let _e52 = lt_shaders_texture_unorm_bytes(_e51);
    let _e68 = (*param_4)[2u].color;
    let _e69 = lt_shaders_texture_unorm_bytes(_e68);
    return vec4<f32>((((_e39.x * param_5.x) + (_e52.x * param_5.y)) + (_e69.x * param_5.z)), (((_e39.y * param_5.x) + (_e52.y * param_5.y)) + (_e69.y * param_5.z)), (((_e39.z * param_5.x) + (_e52.z * param_5.y)) + (_e69.z * param_5.z)), (((_e39.w * param_5.x) + (_e52.w * param_5.y)) + (_e69.w * param_5.z)));
}

fn lt_shaders_surface_texture_coordinate(param_6: ptr<function, array<abi_Vertex, 3>>, param_7: vec3<f32>) -> vec2<f32> {
    let _e38 = (*param_6)[0u].u;
    let _e41 = (*param_6)[0u].v;
    let _e47 = (*param_6)[1u].u;
    let _e50 = (*param_6)[1u].v;
    let _e58 = (*param_6)[2u].u;
    let _e61 = (*param_6)[2u].v;
    return vec2<f32>((((_e38 * param_7.x) + (_e47 * param_7.y)) + (_e58 * param_7.z)), (((_e41 * param_7.x) + (_e50 * param_7.y)) + (_e61 * param_7.z)));
}

fn lt_shaders_texture_wrap_to_unit(param_8: f32, param_9: u32) -> f32 {
    var phi_432_: f32;
    var phi_433_: f32;
    var phi_434_: f32;
    var phi_443_: f32;
    var phi_444_: f32;

    if (param_9 == 0u) {
        phi_434_ = (param_8 - floor(param_8));
    } else {
        if (param_9 == 1u) {
            let _e43 = (param_8 - (2f * floor((param_8 * 0.5f))));
            if (_e43 > 1f) {
                phi_432_ = (2f - _e43);
            } else {
                phi_432_ = _e43;
            }
            let _e47 = phi_432_;
            phi_433_ = _e47;
        } else {
            phi_433_ = param_8;
        }
        let _e49 = phi_433_;
        phi_434_ = _e49;
    }
    let _e51 = phi_434_;
    if (_e51 > 0f) {
        if (_e51 < 1f) {
            phi_443_ = _e51;
        } else {
            phi_443_ = 1f;
        }
        let _e55 = phi_443_;
        phi_444_ = _e55;
    } else {
        phi_444_ = 0f;
    }
    let _e57 = phi_444_;
    return _e57;
}

fn lt_shaders_texture_axis(param_10: f32, param_11: u32, param_12: u32, param_13: bool) -> texture_Axis {
    var phi_370_: u32;
    var phi_384_: u32;
    var phi_391_: u32;
    var phi_396_: u32;
    var phi_402_: u32;
    var phi_407_: u32;
    var phi_409_: texture_Axis;

    let _e38 = lt_shaders_texture_wrap_to_unit(param_10, param_12);
    let _e39 = (param_11 - 1u);
    let _e41 = (_e38 * f32(param_11));
    if param_13 {
        let _e48 = select(select(u32(_e41), 0u, (_e41 < bitcast<f32>(0u))), 4294967295u, (_e41 > bitcast<f32>(1333788671u)));
        if (_e39 < _e48) {
            phi_370_ = _e39;
        } else {
            phi_370_ = _e48;
        }
        let _e51 = phi_370_;
        phi_409_ = texture_Axis(_e51, _e51, 0f);
    } else {
        let _e53 = (_e41 + 0.5f);
        let _e60 = select(select(u32(_e53), 0u, (_e53 < bitcast<f32>(0u))), 4294967295u, (_e53 > bitcast<f32>(1333788671u)));
        if (param_11 < _e60) {
            phi_384_ = param_11;
        } else {
            phi_384_ = _e60;
        }
        let _e63 = phi_384_;
        if (param_12 == 0u) {
            phi_391_ = _e39;
        } else {
            phi_391_ = 0u;
        }
        let _e68 = phi_391_;
        if (param_12 == 0u) {
            phi_396_ = 0u;
        } else {
            phi_396_ = _e39;
        }
        let _e71 = phi_396_;
        if (_e63 == 0u) {
            phi_402_ = _e68;
        } else {
            phi_402_ = (_e63 - 1u);
        }
        let _e75 = phi_402_;
        if (_e63 > _e39) {
            phi_407_ = _e71;
        } else {
            phi_407_ = _e63;
        }
        let _e78 = phi_407_;
        phi_409_ = texture_Axis(_e75, _e78, (_e53 - f32(_e63)));
    }
    let _e81 = phi_409_;
    return _e81;
}

fn _lt_shaders_texture_TextureView_quad(param_14: ptr<function, texture_TextureView>, param_15: f32, param_16: f32) -> texture_TexelQuad {
    let _e38 = (*param_14).size;
    let _e39 = (_e38 & 65535u);
    let _e41 = (*param_14).size;
    let _e45 = (*param_14).flags;
    let _e47 = ((_e45 & 4u) != 0u);
    let _e49 = (*param_14).flags;
    let _e53 = lt_shaders_texture_axis(param_15, _e39, ((_e49 >> bitcast<u32>(4u)) & 3u), _e47);
    let _e55 = (*param_14).flags;
    let _e59 = lt_shaders_texture_axis(param_16, (_e41 >> bitcast<u32>(16i)), ((_e55 >> bitcast<u32>(6u)) & 3u), _e47);
    let _e63 = (*param_14).offset;
    let _e70 = (*param_14).offset;
    let _e77 = (*param_14).offset;
    let _e84 = (*param_14).offset;
    return texture_TexelQuad(array<u32, 4>(((_e63 + (_e59.low * _e39)) + _e53.low), ((_e70 + (_e59.low * _e39)) + _e53.high), ((_e77 + (_e59.high * _e39)) + _e53.low), ((_e84 + (_e59.high * _e39)) + _e53.high)), vec4<f32>(((1f - _e53.fraction) * (1f - _e59.fraction)), (_e53.fraction * (1f - _e59.fraction)), ((1f - _e53.fraction) * _e59.fraction), (_e53.fraction * _e59.fraction)));
}

fn spirv_std_arch_kill() {
    discard;
}

fn function_() {
    var local: texture_TextureView;
    var local_1: array<vec3<f32>, 3>;
    var local_2: array<abi_Vertex, 3>;
    var phi_491_: vec3<f32>;
    var phi_492_: vec3<f32>;
    var phi_589_: vec3<f32>;
    var phi_590_: vec3<f32>;
    var phi_687_: vec3<f32>;
    var phi_688_: vec3<f32>;
    var phi_951_: f32;
    var phi_955_: bool;
    var phi_956_: bool;

    let _e37 = at_1;
    let _e38 = triangle_1;
    let _e39 = placed_1;
    let _e49 = arrayLength((&vertices.member));
    let _e55 = arrayLength((&alpha_texels.member));
    if (_e38 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e59 = triangles.member[(0u + _e38)];
    if (_e39 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    let _e63 = instances.member[(0u + _e39)];
    if (0u == 0u) {
        phi_492_ = _e59.v0_;
    } else {
        if (0u == 1u) {
            phi_491_ = _e59.v1_;
        } else {
            phi_491_ = _e59.v2_;
        }
        let _e72 = phi_491_;
        phi_492_ = _e72;
    }
    let _e74 = phi_492_;
    let _e90 = ((((_e63.object_to_world[0].x * _e74.x) + (_e63.object_to_world[0].y * _e74.y)) + (_e63.object_to_world[0].z * _e74.z)) + (_e63.object_to_world[0].w * 1f));
    let _e103 = ((((_e63.object_to_world[1].x * _e74.x) + (_e63.object_to_world[1].y * _e74.y)) + (_e63.object_to_world[1].z * _e74.z)) + (_e63.object_to_world[1].w * 1f));
    let _e116 = ((((_e63.object_to_world[2].x * _e74.x) + (_e63.object_to_world[2].y * _e74.y)) + (_e63.object_to_world[2].z * _e74.z)) + (_e63.object_to_world[2].w * 1f));
    let _e118 = p.member.map_size;
    let _e120 = f32(_e118);
    let _e122 = p.member.projection.row_x;
    let _e136 = p.member.projection.row_y;
    let _e150 = p.member.projection.row_z;
    if (1u == 0u) {
        phi_590_ = _e59.v0_;
    } else {
        if (1u == 1u) {
            phi_589_ = _e59.v1_;
        } else {
            phi_589_ = _e59.v2_;
        }
        let _e169 = phi_589_;
        phi_590_ = _e169;
    }
    let _e171 = phi_590_;
    let _e187 = ((((_e63.object_to_world[0].x * _e171.x) + (_e63.object_to_world[0].y * _e171.y)) + (_e63.object_to_world[0].z * _e171.z)) + (_e63.object_to_world[0].w * 1f));
    let _e200 = ((((_e63.object_to_world[1].x * _e171.x) + (_e63.object_to_world[1].y * _e171.y)) + (_e63.object_to_world[1].z * _e171.z)) + (_e63.object_to_world[1].w * 1f));
    let _e213 = ((((_e63.object_to_world[2].x * _e171.x) + (_e63.object_to_world[2].y * _e171.y)) + (_e63.object_to_world[2].z * _e171.z)) + (_e63.object_to_world[2].w * 1f));
    let _e215 = p.member.map_size;
    let _e217 = f32(_e215);
    let _e219 = p.member.projection.row_x;
    let _e233 = p.member.projection.row_y;
    let _e247 = p.member.projection.row_z;
    if (2u == 0u) {
        phi_688_ = _e59.v0_;
    } else {
        if (2u == 1u) {
            phi_687_ = _e59.v1_;
        } else {
            phi_687_ = _e59.v2_;
        }
        let _e266 = phi_687_;
        phi_688_ = _e266;
    }
    let _e268 = phi_688_;
    let _e284 = ((((_e63.object_to_world[0].x * _e268.x) + (_e63.object_to_world[0].y * _e268.y)) + (_e63.object_to_world[0].z * _e268.z)) + (_e63.object_to_world[0].w * 1f));
    let _e297 = ((((_e63.object_to_world[1].x * _e268.x) + (_e63.object_to_world[1].y * _e268.y)) + (_e63.object_to_world[1].z * _e268.z)) + (_e63.object_to_world[1].w * 1f));
    let _e310 = ((((_e63.object_to_world[2].x * _e268.x) + (_e63.object_to_world[2].y * _e268.y)) + (_e63.object_to_world[2].z * _e268.z)) + (_e63.object_to_world[2].w * 1f));
    let _e312 = p.member.map_size;
    let _e314 = f32(_e312);
    let _e316 = p.member.projection.row_x;
    let _e330 = p.member.projection.row_y;
    let _e344 = p.member.projection.row_z;
    local_1[0u] = vec3<f32>((((((_e122.x * _e90) + (_e122.y * _e103)) + (_e122.z * _e116)) + (_e122.w * 1f)) * _e120), (((((_e136.x * _e90) + (_e136.y * _e103)) + (_e136.z * _e116)) + (_e136.w * 1f)) * _e120), ((((_e150.x * _e90) + (_e150.y * _e103)) + (_e150.z * _e116)) + (_e150.w * 1f)));
    local_1[1u] = vec3<f32>((((((_e219.x * _e187) + (_e219.y * _e200)) + (_e219.z * _e213)) + (_e219.w * 1f)) * _e217), (((((_e233.x * _e187) + (_e233.y * _e200)) + (_e233.z * _e213)) + (_e233.w * 1f)) * _e217), ((((_e247.x * _e187) + (_e247.y * _e200)) + (_e247.z * _e213)) + (_e247.w * 1f)));
    local_1[2u] = vec3<f32>((((((_e316.x * _e284) + (_e316.y * _e297)) + (_e316.z * _e310)) + (_e316.w * 1f)) * _e314), (((((_e330.x * _e284) + (_e330.y * _e297)) + (_e330.z * _e310)) + (_e330.w * 1f)) * _e314), ((((_e344.x * _e284) + (_e344.y * _e297)) + (_e344.z * _e310)) + (_e344.w * 1f)));
    let _e360 = lt_shaders_depth_weights_at(_e37.x, _e37.y, (&local_1));
    let _e362 = (_e59.i0_ & 2147483647u);
    if (_e362 < _e49) {
    } else {
        return;
    }
    let _e368 = vertices.member[(0u + _e362)];
    if (_e59.i1_ < _e49) {
    } else {
        return;
    }
    let _e372 = vertices.member[(0u + _e59.i1_)];
    if (_e59.i2_ < _e49) {
    } else {
        return;
    }
    let _e376 = vertices.member[(0u + _e59.i2_)];
    let _e377 = array<abi_Vertex, 3>(_e368, _e372, _e376);
    local_2 = array<abi_Vertex, 3>(abi_Vertex(_e377[0].u, _e377[0].v, _e377[0].normal, _e377[0].color, _e377[0].material), abi_Vertex(_e377[1].u, _e377[1].v, _e377[1].normal, _e377[1].color, _e377[1].material), abi_Vertex(_e377[2].u, _e377[2].v, _e377[2].normal, _e377[2].color, _e377[2].material));
    let _e402 = local_2[0u].material;
    if (_e402 < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e407 = materials.member[(0u + _e402)].flags;
    if ((_e407 & 1u) == 0u) {
        phi_956_ = false;
    } else {
        let _e411 = materials.member[(0u + _e402)].cutoff;
        if (_e411 <= 0f) {
            phi_955_ = true;
        } else {
            let _e415 = materials.member[(0u + _e402)].base_color[3u];
            let _e416 = lt_shaders_surface_vertex_color((&local_2), _e360);
            let _e418 = (_e415 * _e416.w);
            let _e420 = materials.member[(0u + _e402)].alpha_size;
            if (_e420 == 0u) {
                phi_951_ = _e418;
            } else {
                let _e423 = materials.member[(0u + _e402)].alpha_offset;
                let _e425 = materials.member[(0u + _e402)].alpha_size;
                let _e427 = materials.member[(0u + _e402)].flags;
                local.offset = _e423;
                local.size = _e425;
                local.flags = _e427;
                let _e431 = lt_shaders_surface_texture_coordinate((&local_2), _e360);
                let _e434 = _lt_shaders_texture_TextureView_quad((&local), _e431.x, _e431.y);
                let _e438 = (_e434.indices[0] >> bitcast<u32>(2i));
                if (_e438 < _e55) {
                } else {
                    return;
                }
                let _e442 = alpha_texels.member[(0u + _e438)];
                let _e458 = (_e434.indices[1] >> bitcast<u32>(2i));
                if (_e458 < _e55) {
                } else {
                    return;
                }
                let _e462 = alpha_texels.member[(0u + _e458)];
                let _e479 = (_e434.indices[2] >> bitcast<u32>(2i));
                if (_e479 < _e55) {
                } else {
                    return;
                }
                let _e483 = alpha_texels.member[(0u + _e479)];
                let _e500 = (_e434.indices[3] >> bitcast<u32>(2i));
                if (_e500 < _e55) {
                } else {
                    return;
                }
                let _e504 = alpha_texels.member[(0u + _e500)];
                phi_951_ = (_e418 * (((((f32(((_e442 >> bitcast<u32>((((_e434.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e434.weights.x) + ((f32(((_e462 >> bitcast<u32>((((_e434.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e434.weights.y)) + ((f32(((_e483 >> bitcast<u32>((((_e434.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e434.weights.z)) + ((f32(((_e504 >> bitcast<u32>((((_e434.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e434.weights.w)));
            }
            let _e520 = phi_951_;
            let _e522 = materials.member[(0u + _e402)].cutoff;
            phi_955_ = (_e520 >= _e522);
        }
        let _e525 = phi_955_;
        phi_956_ = _e525;
    }
    let _e527 = phi_956_;
    if _e527 {
    } else {
        spirv_std_arch_kill();
    }
    return;
}

@fragment 
fn entry_depth_depth_instanced_alpha_fs(@builtin(position) at: vec4<f32>, @location(0) @interpolate(flat) triangle: u32, @location(1) @interpolate(flat) placed: u32) {
    at_1 = at;
    triangle_1 = triangle;
    placed_1 = placed;
    function_();
}
