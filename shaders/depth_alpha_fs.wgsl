struct type_8 {
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

struct abi_DepthParams {
    projection: lt_math_LightProjection,
    map_size: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_19 {
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

struct type_23 {
    member: array<lt_bvh_Triangle>,
}

struct abi_Vertex {
    u: f32,
    v: f32,
    normal: u32,
    color: u32,
    material: u32,
}

struct type_27 {
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

struct type_31 {
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

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_19;
@group(0) @binding(1) 
var<storage> triangles: type_23;
@group(0) @binding(2) 
var<storage> vertices: type_27;
@group(0) @binding(3) 
var<storage> materials: type_31;
@group(0) @binding(4) 
var<storage> alpha_texels: type_8;

fn spirv_std_arch_kill() {
    discard;
}

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_538_: f32;
    var phi_543_: f32;
    var phi_544_: bool;
    var phi_545_: f32;
    var phi_546_: bool;
    var phi_550_: f32;
    var phi_576_: f32;
    var phi_581_: f32;
    var phi_582_: bool;
    var phi_583_: f32;
    var phi_584_: bool;
    var phi_588_: f32;
    var phi_596_: f32;
    var phi_597_: f32;
    var phi_598_: f32;
    var phi_607_: f32;
    var phi_608_: f32;
    var phi_626_: u32;
    var phi_640_: u32;
    var phi_647_: u32;
    var phi_652_: u32;
    var phi_658_: u32;
    var phi_663_: u32;
    var phi_665_: texture_Axis;
    var phi_693_: f32;
    var phi_698_: f32;
    var phi_699_: bool;
    var phi_700_: f32;
    var phi_701_: bool;
    var phi_705_: f32;
    var phi_731_: f32;
    var phi_736_: f32;
    var phi_737_: bool;
    var phi_738_: f32;
    var phi_739_: bool;
    var phi_743_: f32;
    var phi_751_: f32;
    var phi_752_: f32;
    var phi_753_: f32;
    var phi_762_: f32;
    var phi_763_: f32;
    var phi_781_: u32;
    var phi_795_: u32;
    var phi_802_: u32;
    var phi_807_: u32;
    var phi_813_: u32;
    var phi_818_: u32;
    var phi_820_: texture_Axis;

    let _e43 = (*param).size;
    let _e44 = (_e43 & 65535u);
    let _e46 = (*param).size;
    let _e48 = (_e46 >> bitcast<u32>(16i));
    let _e50 = (*param).flags;
    let _e52 = ((_e50 & 4u) != 0u);
    let _e54 = (*param).flags;
    let _e57 = ((_e54 >> bitcast<u32>(4u)) & 3u);
    if (_e57 == 0u) {
        if (param_1 > -8388608f) {
            let _e70 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e70 > param_1) {
                phi_538_ = 1f;
            } else {
                phi_538_ = 0f;
            }
            let _e73 = phi_538_;
            if (param_1 < 8388608f) {
                phi_543_ = (_e70 - _e73);
                phi_544_ = false;
            } else {
                phi_543_ = f32();
                phi_544_ = true;
            }
            let _e76 = phi_543_;
            let _e78 = phi_544_;
            phi_545_ = _e76;
            phi_546_ = _e78;
        } else {
            phi_545_ = f32();
            phi_546_ = true;
        }
        let _e80 = phi_545_;
        let _e82 = phi_546_;
        if _e82 {
            phi_550_ = param_1;
        } else {
            phi_550_ = _e80;
        }
        let _e84 = phi_550_;
        phi_598_ = (param_1 - _e84);
    } else {
        if (_e57 == 1u) {
            let _e87 = (param_1 * 0.5f);
            if (_e87 > -8388608f) {
                let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
                if (_e99 > _e87) {
                    phi_576_ = 1f;
                } else {
                    phi_576_ = 0f;
                }
                let _e102 = phi_576_;
                if (_e87 < 8388608f) {
                    phi_581_ = (_e99 - _e102);
                    phi_582_ = false;
                } else {
                    phi_581_ = f32();
                    phi_582_ = true;
                }
                let _e105 = phi_581_;
                let _e107 = phi_582_;
                phi_583_ = _e105;
                phi_584_ = _e107;
            } else {
                phi_583_ = f32();
                phi_584_ = true;
            }
            let _e109 = phi_583_;
            let _e111 = phi_584_;
            if _e111 {
                phi_588_ = _e87;
            } else {
                phi_588_ = _e109;
            }
            let _e113 = phi_588_;
            let _e115 = (param_1 - (2f * _e113));
            if (_e115 > 1f) {
                phi_596_ = (2f - _e115);
            } else {
                phi_596_ = _e115;
            }
            let _e119 = phi_596_;
            phi_597_ = _e119;
        } else {
            phi_597_ = param_1;
        }
        let _e121 = phi_597_;
        phi_598_ = _e121;
    }
    let _e123 = phi_598_;
    if (_e123 > 0f) {
        if (_e123 < 1f) {
            phi_607_ = _e123;
        } else {
            phi_607_ = 1f;
        }
        let _e127 = phi_607_;
        phi_608_ = _e127;
    } else {
        phi_608_ = 0f;
    }
    let _e129 = phi_608_;
    let _e130 = (_e44 - 1u);
    let _e132 = (_e129 * f32(_e44));
    if _e52 {
        let _e139 = select(select(u32(_e132), 0u, (_e132 < bitcast<f32>(0u))), 4294967295u, (_e132 > bitcast<f32>(1333788671u)));
        if (_e130 < _e139) {
            phi_626_ = _e130;
        } else {
            phi_626_ = _e139;
        }
        let _e142 = phi_626_;
        phi_665_ = texture_Axis(_e142, _e142, 0f);
    } else {
        let _e144 = (_e132 + 0.5f);
        let _e151 = select(select(u32(_e144), 0u, (_e144 < bitcast<f32>(0u))), 4294967295u, (_e144 > bitcast<f32>(1333788671u)));
        if (_e44 < _e151) {
            phi_640_ = _e44;
        } else {
            phi_640_ = _e151;
        }
        let _e154 = phi_640_;
        if (_e57 == 0u) {
            phi_647_ = _e130;
        } else {
            phi_647_ = 0u;
        }
        let _e159 = phi_647_;
        if (_e57 == 0u) {
            phi_652_ = 0u;
        } else {
            phi_652_ = _e130;
        }
        let _e162 = phi_652_;
        if (_e154 == 0u) {
            phi_658_ = _e159;
        } else {
            phi_658_ = (_e154 - 1u);
        }
        let _e166 = phi_658_;
        if (_e154 > _e130) {
            phi_663_ = _e162;
        } else {
            phi_663_ = _e154;
        }
        let _e169 = phi_663_;
        phi_665_ = texture_Axis(_e166, _e169, (_e144 - f32(_e154)));
    }
    let _e172 = phi_665_;
    let _e174 = (*param).flags;
    let _e177 = ((_e174 >> bitcast<u32>(6u)) & 3u);
    if (_e177 == 0u) {
        if (param_2 > -8388608f) {
            let _e190 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e190 > param_2) {
                phi_693_ = 1f;
            } else {
                phi_693_ = 0f;
            }
            let _e193 = phi_693_;
            if (param_2 < 8388608f) {
                phi_698_ = (_e190 - _e193);
                phi_699_ = false;
            } else {
                phi_698_ = f32();
                phi_699_ = true;
            }
            let _e196 = phi_698_;
            let _e198 = phi_699_;
            phi_700_ = _e196;
            phi_701_ = _e198;
        } else {
            phi_700_ = f32();
            phi_701_ = true;
        }
        let _e200 = phi_700_;
        let _e202 = phi_701_;
        if _e202 {
            phi_705_ = param_2;
        } else {
            phi_705_ = _e200;
        }
        let _e204 = phi_705_;
        phi_753_ = (param_2 - _e204);
    } else {
        if (_e177 == 1u) {
            let _e207 = (param_2 * 0.5f);
            if (_e207 > -8388608f) {
                let _e219 = f32(select(0i, select(select(i32(_e207), i32(-2147483648), (_e207 < bitcast<f32>(3472883712u))), 2147483647i, (_e207 > bitcast<f32>(1325400063u))), (_e207 == _e207)));
                if (_e219 > _e207) {
                    phi_731_ = 1f;
                } else {
                    phi_731_ = 0f;
                }
                let _e222 = phi_731_;
                if (_e207 < 8388608f) {
                    phi_736_ = (_e219 - _e222);
                    phi_737_ = false;
                } else {
                    phi_736_ = f32();
                    phi_737_ = true;
                }
                let _e225 = phi_736_;
                let _e227 = phi_737_;
                phi_738_ = _e225;
                phi_739_ = _e227;
            } else {
                phi_738_ = f32();
                phi_739_ = true;
            }
            let _e229 = phi_738_;
            let _e231 = phi_739_;
            if _e231 {
                phi_743_ = _e207;
            } else {
                phi_743_ = _e229;
            }
            let _e233 = phi_743_;
            let _e235 = (param_2 - (2f * _e233));
            if (_e235 > 1f) {
                phi_751_ = (2f - _e235);
            } else {
                phi_751_ = _e235;
            }
            let _e239 = phi_751_;
            phi_752_ = _e239;
        } else {
            phi_752_ = param_2;
        }
        let _e241 = phi_752_;
        phi_753_ = _e241;
    }
    let _e243 = phi_753_;
    if (_e243 > 0f) {
        if (_e243 < 1f) {
            phi_762_ = _e243;
        } else {
            phi_762_ = 1f;
        }
        let _e247 = phi_762_;
        phi_763_ = _e247;
    } else {
        phi_763_ = 0f;
    }
    let _e249 = phi_763_;
    let _e250 = (_e48 - 1u);
    let _e252 = (_e249 * f32(_e48));
    if _e52 {
        let _e259 = select(select(u32(_e252), 0u, (_e252 < bitcast<f32>(0u))), 4294967295u, (_e252 > bitcast<f32>(1333788671u)));
        if (_e250 < _e259) {
            phi_781_ = _e250;
        } else {
            phi_781_ = _e259;
        }
        let _e262 = phi_781_;
        phi_820_ = texture_Axis(_e262, _e262, 0f);
    } else {
        let _e264 = (_e252 + 0.5f);
        let _e271 = select(select(u32(_e264), 0u, (_e264 < bitcast<f32>(0u))), 4294967295u, (_e264 > bitcast<f32>(1333788671u)));
        if (_e48 < _e271) {
            phi_795_ = _e48;
        } else {
            phi_795_ = _e271;
        }
        let _e274 = phi_795_;
        if (_e177 == 0u) {
            phi_802_ = _e250;
        } else {
            phi_802_ = 0u;
        }
        let _e279 = phi_802_;
        if (_e177 == 0u) {
            phi_807_ = 0u;
        } else {
            phi_807_ = _e250;
        }
        let _e282 = phi_807_;
        if (_e274 == 0u) {
            phi_813_ = _e279;
        } else {
            phi_813_ = (_e274 - 1u);
        }
        let _e286 = phi_813_;
        if (_e274 > _e250) {
            phi_818_ = _e282;
        } else {
            phi_818_ = _e274;
        }
        let _e289 = phi_818_;
        phi_820_ = texture_Axis(_e286, _e289, (_e264 - f32(_e274)));
    }
    let _e292 = phi_820_;
    let _e296 = (*param).offset;
    let _e303 = (*param).offset;
    let _e310 = (*param).offset;
    let _e317 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e296 + (_e292.low * _e44)) + _e172.low), ((_e303 + (_e292.low * _e44)) + _e172.high), ((_e310 + (_e292.high * _e44)) + _e172.low), ((_e317 + (_e292.high * _e44)) + _e172.high)), vec4<f32>(((1f - _e172.fraction) * (1f - _e292.fraction)), (_e172.fraction * (1f - _e292.fraction)), ((1f - _e172.fraction) * _e292.fraction), (_e172.fraction * _e292.fraction)));
}

fn function_() {
    var local: texture_TextureView;
    var phi_139_: vec3<f32>;
    var phi_140_: vec3<f32>;
    var phi_189_: vec3<f32>;
    var phi_190_: vec3<f32>;
    var phi_239_: vec3<f32>;
    var phi_240_: vec3<f32>;
    var phi_303_: vec3<f32>;
    var phi_487_: f32;
    var phi_491_: bool;
    var phi_492_: bool;

    let _e40 = at_1;
    let _e41 = triangle_1;
    let _e48 = arrayLength((&vertices.member));
    let _e54 = arrayLength((&alpha_texels.member));
    if (_e41 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e58 = triangles.member[(0u + _e41)];
    if (0u == 0u) {
        phi_140_ = _e58.v0_;
    } else {
        if (0u == 1u) {
            phi_139_ = _e58.v1_;
        } else {
            phi_139_ = _e58.v2_;
        }
        let _e67 = phi_139_;
        phi_140_ = _e67;
    }
    let _e69 = phi_140_;
    let _e71 = p.member.map_size;
    let _e76 = f32(_e71);
    let _e78 = p.member.projection.row_x;
    let _e92 = p.member.projection.row_y;
    if (1u == 0u) {
        phi_190_ = _e58.v0_;
    } else {
        if (1u == 1u) {
            phi_189_ = _e58.v1_;
        } else {
            phi_189_ = _e58.v2_;
        }
        let _e113 = phi_189_;
        phi_190_ = _e113;
    }
    let _e115 = phi_190_;
    let _e117 = p.member.map_size;
    let _e122 = f32(_e117);
    let _e124 = p.member.projection.row_x;
    let _e138 = p.member.projection.row_y;
    if (2u == 0u) {
        phi_240_ = _e58.v0_;
    } else {
        if (2u == 1u) {
            phi_239_ = _e58.v1_;
        } else {
            phi_239_ = _e58.v2_;
        }
        let _e159 = phi_239_;
        phi_240_ = _e159;
    }
    let _e161 = phi_240_;
    let _e163 = p.member.map_size;
    let _e168 = f32(_e163);
    let _e170 = p.member.projection.row_x;
    let _e184 = p.member.projection.row_y;
    let _e199 = ((((((_e78.x * _e69.x) + (_e78.y * _e69.y)) + (_e78.z * _e69.z)) + (_e78.w * 1f)) * _e76) - _e40.x);
    let _e200 = ((((((_e92.x * _e69.x) + (_e92.y * _e69.y)) + (_e92.z * _e69.z)) + (_e92.w * 1f)) * _e76) - _e40.y);
    let _e201 = ((((((_e124.x * _e115.x) + (_e124.y * _e115.y)) + (_e124.z * _e115.z)) + (_e124.w * 1f)) * _e122) - _e40.x);
    let _e202 = ((((((_e138.x * _e115.x) + (_e138.y * _e115.y)) + (_e138.z * _e115.z)) + (_e138.w * 1f)) * _e122) - _e40.y);
    let _e203 = ((((((_e170.x * _e161.x) + (_e170.y * _e161.y)) + (_e170.z * _e161.z)) + (_e170.w * 1f)) * _e168) - _e40.x);
    let _e204 = ((((((_e184.x * _e161.x) + (_e184.y * _e161.y)) + (_e184.z * _e161.z)) + (_e184.w * 1f)) * _e168) - _e40.y);
    let _e207 = ((_e203 * _e202) - (_e204 * _e201));
    let _e210 = ((_e199 * _e204) - (_e200 * _e203));
    let _e213 = ((_e201 * _e200) - (_e202 * _e199));
    let _e215 = ((_e207 + _e210) + _e213);
    if (_e215 == 0f) {
        phi_303_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_303_ = vec3<f32>((_e207 / _e215), (_e210 / _e215), (_e213 / _e215));
    }
    let _e222 = phi_303_;
    let _e224 = (_e58.i0_ & 2147483647u);
    if (_e224 < _e48) {
    } else {
        return;
    }
    let _e230 = vertices.member[(0u + _e224)];
    if (_e58.i1_ < _e48) {
    } else {
        return;
    }
    let _e234 = vertices.member[(0u + _e58.i1_)];
    if (_e58.i2_ < _e48) {
    } else {
        return;
    }
    let _e238 = vertices.member[(0u + _e58.i2_)];
    let _e239 = array<abi_Vertex, 3>(_e230, _e234, _e238);
    if (_e239[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e246 = materials.member[(0u + _e239[0].material)].flags;
    if ((_e246 & 1u) == 0u) {
        phi_492_ = false;
    } else {
        let _e250 = materials.member[(0u + _e239[0].material)].cutoff;
        if (_e250 <= 0f) {
            phi_491_ = true;
        } else {
            let _e254 = materials.member[(0u + _e239[0].material)].base_color[3u];
            let _e280 = (_e254 * ((((f32((_e239[0].color >> bitcast<u32>(24i))) * _e222.x) + (f32((_e239[1].color >> bitcast<u32>(24i))) * _e222.y)) + (f32((_e239[2].color >> bitcast<u32>(24i))) * _e222.z)) * (1f / 255f)));
            let _e282 = materials.member[(0u + _e239[0].material)].alpha_size;
            if (_e282 == 0u) {
                phi_487_ = _e280;
            } else {
                let _e285 = materials.member[(0u + _e239[0].material)].alpha_offset;
                let _e287 = materials.member[(0u + _e239[0].material)].alpha_size;
                let _e289 = materials.member[(0u + _e239[0].material)].flags;
                local.offset = _e285;
                local.size = _e287;
                local.flags = _e289;
                let _e318 = _lt_shaders_texture_TextureView_quad((&local), (((_e239[0].u * _e222.x) + (_e239[1].u * _e222.y)) + (_e239[2].u * _e222.z)), (((_e239[0].v * _e222.x) + (_e239[1].v * _e222.y)) + (_e239[2].v * _e222.z)));
                let _e322 = (_e318.indices[0] >> bitcast<u32>(2i));
                if (_e322 < _e54) {
                } else {
                    return;
                }
                let _e326 = alpha_texels.member[(0u + _e322)];
                let _e342 = (_e318.indices[1] >> bitcast<u32>(2i));
                if (_e342 < _e54) {
                } else {
                    return;
                }
                let _e346 = alpha_texels.member[(0u + _e342)];
                let _e363 = (_e318.indices[2] >> bitcast<u32>(2i));
                if (_e363 < _e54) {
                } else {
                    return;
                }
                let _e367 = alpha_texels.member[(0u + _e363)];
                let _e384 = (_e318.indices[3] >> bitcast<u32>(2i));
                if (_e384 < _e54) {
                } else {
                    return;
                }
                let _e388 = alpha_texels.member[(0u + _e384)];
                phi_487_ = (_e280 * (((((f32(((_e326 >> bitcast<u32>((((_e318.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e318.weights.x) + ((f32(((_e346 >> bitcast<u32>((((_e318.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e318.weights.y)) + ((f32(((_e367 >> bitcast<u32>((((_e318.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e318.weights.z)) + ((f32(((_e388 >> bitcast<u32>((((_e318.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e318.weights.w)));
            }
            let _e404 = phi_487_;
            let _e406 = materials.member[(0u + _e239[0].material)].cutoff;
            phi_491_ = (_e404 >= _e406);
        }
        let _e409 = phi_491_;
        phi_492_ = _e409;
    }
    let _e411 = phi_492_;
    if _e411 {
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
