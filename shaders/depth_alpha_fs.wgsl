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
    near: f32,
    pad0_: u32,
    pad1_: u32,
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
    var phi_583_: f32;
    var phi_588_: f32;
    var phi_589_: bool;
    var phi_590_: f32;
    var phi_591_: bool;
    var phi_595_: f32;
    var phi_621_: f32;
    var phi_626_: f32;
    var phi_627_: bool;
    var phi_628_: f32;
    var phi_629_: bool;
    var phi_633_: f32;
    var phi_641_: f32;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_652_: f32;
    var phi_653_: f32;
    var phi_671_: u32;
    var phi_685_: u32;
    var phi_692_: u32;
    var phi_697_: u32;
    var phi_703_: u32;
    var phi_708_: u32;
    var phi_710_: texture_Axis;
    var phi_738_: f32;
    var phi_743_: f32;
    var phi_744_: bool;
    var phi_745_: f32;
    var phi_746_: bool;
    var phi_750_: f32;
    var phi_776_: f32;
    var phi_781_: f32;
    var phi_782_: bool;
    var phi_783_: f32;
    var phi_784_: bool;
    var phi_788_: f32;
    var phi_796_: f32;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_826_: u32;
    var phi_840_: u32;
    var phi_847_: u32;
    var phi_852_: u32;
    var phi_858_: u32;
    var phi_863_: u32;
    var phi_865_: texture_Axis;

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
                phi_583_ = 1f;
            } else {
                phi_583_ = 0f;
            }
            let _e73 = phi_583_;
            if (param_1 < 8388608f) {
                phi_588_ = (_e70 - _e73);
                phi_589_ = false;
            } else {
                phi_588_ = f32();
                phi_589_ = true;
            }
            let _e76 = phi_588_;
            let _e78 = phi_589_;
            phi_590_ = _e76;
            phi_591_ = _e78;
        } else {
            phi_590_ = f32();
            phi_591_ = true;
        }
        let _e80 = phi_590_;
        let _e82 = phi_591_;
        if _e82 {
            phi_595_ = param_1;
        } else {
            phi_595_ = _e80;
        }
        let _e84 = phi_595_;
        phi_643_ = (param_1 - _e84);
    } else {
        if (_e57 == 1u) {
            let _e87 = (param_1 * 0.5f);
            if (_e87 > -8388608f) {
                let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
                if (_e99 > _e87) {
                    phi_621_ = 1f;
                } else {
                    phi_621_ = 0f;
                }
                let _e102 = phi_621_;
                if (_e87 < 8388608f) {
                    phi_626_ = (_e99 - _e102);
                    phi_627_ = false;
                } else {
                    phi_626_ = f32();
                    phi_627_ = true;
                }
                let _e105 = phi_626_;
                let _e107 = phi_627_;
                phi_628_ = _e105;
                phi_629_ = _e107;
            } else {
                phi_628_ = f32();
                phi_629_ = true;
            }
            let _e109 = phi_628_;
            let _e111 = phi_629_;
            if _e111 {
                phi_633_ = _e87;
            } else {
                phi_633_ = _e109;
            }
            let _e113 = phi_633_;
            let _e115 = (param_1 - (2f * _e113));
            if (_e115 > 1f) {
                phi_641_ = (2f - _e115);
            } else {
                phi_641_ = _e115;
            }
            let _e119 = phi_641_;
            phi_642_ = _e119;
        } else {
            phi_642_ = param_1;
        }
        let _e121 = phi_642_;
        phi_643_ = _e121;
    }
    let _e123 = phi_643_;
    if (_e123 > 0f) {
        if (_e123 < 1f) {
            phi_652_ = _e123;
        } else {
            phi_652_ = 1f;
        }
        let _e127 = phi_652_;
        phi_653_ = _e127;
    } else {
        phi_653_ = 0f;
    }
    let _e129 = phi_653_;
    let _e130 = (_e44 - 1u);
    let _e132 = (_e129 * f32(_e44));
    if _e52 {
        let _e139 = select(select(u32(_e132), 0u, (_e132 < bitcast<f32>(0u))), 4294967295u, (_e132 > bitcast<f32>(1333788671u)));
        if (_e130 < _e139) {
            phi_671_ = _e130;
        } else {
            phi_671_ = _e139;
        }
        let _e142 = phi_671_;
        phi_710_ = texture_Axis(_e142, _e142, 0f);
    } else {
        let _e144 = (_e132 + 0.5f);
        let _e151 = select(select(u32(_e144), 0u, (_e144 < bitcast<f32>(0u))), 4294967295u, (_e144 > bitcast<f32>(1333788671u)));
        if (_e44 < _e151) {
            phi_685_ = _e44;
        } else {
            phi_685_ = _e151;
        }
        let _e154 = phi_685_;
        if (_e57 == 0u) {
            phi_692_ = _e130;
        } else {
            phi_692_ = 0u;
        }
        let _e159 = phi_692_;
        if (_e57 == 0u) {
            phi_697_ = 0u;
        } else {
            phi_697_ = _e130;
        }
        let _e162 = phi_697_;
        if (_e154 == 0u) {
            phi_703_ = _e159;
        } else {
            phi_703_ = (_e154 - 1u);
        }
        let _e166 = phi_703_;
        if (_e154 > _e130) {
            phi_708_ = _e162;
        } else {
            phi_708_ = _e154;
        }
        let _e169 = phi_708_;
        phi_710_ = texture_Axis(_e166, _e169, (_e144 - f32(_e154)));
    }
    let _e172 = phi_710_;
    let _e174 = (*param).flags;
    let _e177 = ((_e174 >> bitcast<u32>(6u)) & 3u);
    if (_e177 == 0u) {
        if (param_2 > -8388608f) {
            let _e190 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e190 > param_2) {
                phi_738_ = 1f;
            } else {
                phi_738_ = 0f;
            }
            let _e193 = phi_738_;
            if (param_2 < 8388608f) {
                phi_743_ = (_e190 - _e193);
                phi_744_ = false;
            } else {
                phi_743_ = f32();
                phi_744_ = true;
            }
            let _e196 = phi_743_;
            let _e198 = phi_744_;
            phi_745_ = _e196;
            phi_746_ = _e198;
        } else {
            phi_745_ = f32();
            phi_746_ = true;
        }
        let _e200 = phi_745_;
        let _e202 = phi_746_;
        if _e202 {
            phi_750_ = param_2;
        } else {
            phi_750_ = _e200;
        }
        let _e204 = phi_750_;
        phi_798_ = (param_2 - _e204);
    } else {
        if (_e177 == 1u) {
            let _e207 = (param_2 * 0.5f);
            if (_e207 > -8388608f) {
                let _e219 = f32(select(0i, select(select(i32(_e207), i32(-2147483648), (_e207 < bitcast<f32>(3472883712u))), 2147483647i, (_e207 > bitcast<f32>(1325400063u))), (_e207 == _e207)));
                if (_e219 > _e207) {
                    phi_776_ = 1f;
                } else {
                    phi_776_ = 0f;
                }
                let _e222 = phi_776_;
                if (_e207 < 8388608f) {
                    phi_781_ = (_e219 - _e222);
                    phi_782_ = false;
                } else {
                    phi_781_ = f32();
                    phi_782_ = true;
                }
                let _e225 = phi_781_;
                let _e227 = phi_782_;
                phi_783_ = _e225;
                phi_784_ = _e227;
            } else {
                phi_783_ = f32();
                phi_784_ = true;
            }
            let _e229 = phi_783_;
            let _e231 = phi_784_;
            if _e231 {
                phi_788_ = _e207;
            } else {
                phi_788_ = _e229;
            }
            let _e233 = phi_788_;
            let _e235 = (param_2 - (2f * _e233));
            if (_e235 > 1f) {
                phi_796_ = (2f - _e235);
            } else {
                phi_796_ = _e235;
            }
            let _e239 = phi_796_;
            phi_797_ = _e239;
        } else {
            phi_797_ = param_2;
        }
        let _e241 = phi_797_;
        phi_798_ = _e241;
    }
    let _e243 = phi_798_;
    if (_e243 > 0f) {
        if (_e243 < 1f) {
            phi_807_ = _e243;
        } else {
            phi_807_ = 1f;
        }
        let _e247 = phi_807_;
        phi_808_ = _e247;
    } else {
        phi_808_ = 0f;
    }
    let _e249 = phi_808_;
    let _e250 = (_e48 - 1u);
    let _e252 = (_e249 * f32(_e48));
    if _e52 {
        let _e259 = select(select(u32(_e252), 0u, (_e252 < bitcast<f32>(0u))), 4294967295u, (_e252 > bitcast<f32>(1333788671u)));
        if (_e250 < _e259) {
            phi_826_ = _e250;
        } else {
            phi_826_ = _e259;
        }
        let _e262 = phi_826_;
        phi_865_ = texture_Axis(_e262, _e262, 0f);
    } else {
        let _e264 = (_e252 + 0.5f);
        let _e271 = select(select(u32(_e264), 0u, (_e264 < bitcast<f32>(0u))), 4294967295u, (_e264 > bitcast<f32>(1333788671u)));
        if (_e48 < _e271) {
            phi_840_ = _e48;
        } else {
            phi_840_ = _e271;
        }
        let _e274 = phi_840_;
        if (_e177 == 0u) {
            phi_847_ = _e250;
        } else {
            phi_847_ = 0u;
        }
        let _e279 = phi_847_;
        if (_e177 == 0u) {
            phi_852_ = 0u;
        } else {
            phi_852_ = _e250;
        }
        let _e282 = phi_852_;
        if (_e274 == 0u) {
            phi_858_ = _e279;
        } else {
            phi_858_ = (_e274 - 1u);
        }
        let _e286 = phi_858_;
        if (_e274 > _e250) {
            phi_863_ = _e282;
        } else {
            phi_863_ = _e274;
        }
        let _e289 = phi_863_;
        phi_865_ = texture_Axis(_e286, _e289, (_e264 - f32(_e274)));
    }
    let _e292 = phi_865_;
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
    var phi_202_: vec3<f32>;
    var phi_203_: vec3<f32>;
    var phi_265_: vec3<f32>;
    var phi_266_: vec3<f32>;
    var phi_348_: vec3<f32>;
    var phi_532_: f32;
    var phi_536_: bool;
    var phi_537_: bool;

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
    let _e108 = p.member.projection.row_w;
    let _e119 = ((((_e108.x * _e69.x) + (_e108.y * _e69.y)) + (_e108.z * _e69.z)) + (_e108.w * 1f));
    if (1u == 0u) {
        phi_203_ = _e58.v0_;
    } else {
        if (1u == 1u) {
            phi_202_ = _e58.v1_;
        } else {
            phi_202_ = _e58.v2_;
        }
        let _e126 = phi_202_;
        phi_203_ = _e126;
    }
    let _e128 = phi_203_;
    let _e130 = p.member.map_size;
    let _e135 = f32(_e130);
    let _e137 = p.member.projection.row_x;
    let _e151 = p.member.projection.row_y;
    let _e167 = p.member.projection.row_w;
    let _e178 = ((((_e167.x * _e128.x) + (_e167.y * _e128.y)) + (_e167.z * _e128.z)) + (_e167.w * 1f));
    if (2u == 0u) {
        phi_266_ = _e58.v0_;
    } else {
        if (2u == 1u) {
            phi_265_ = _e58.v1_;
        } else {
            phi_265_ = _e58.v2_;
        }
        let _e185 = phi_265_;
        phi_266_ = _e185;
    }
    let _e187 = phi_266_;
    let _e189 = p.member.map_size;
    let _e194 = f32(_e189);
    let _e196 = p.member.projection.row_x;
    let _e210 = p.member.projection.row_y;
    let _e226 = p.member.projection.row_w;
    let _e237 = ((((_e226.x * _e187.x) + (_e226.y * _e187.y)) + (_e226.z * _e187.z)) + (_e226.w * 1f));
    let _e240 = ((((((_e78.x * _e69.x) + (_e78.y * _e69.y)) + (_e78.z * _e69.z)) + (_e78.w * 1f)) * _e76) - (_e40.x * _e119));
    let _e241 = ((((((_e92.x * _e69.x) + (_e92.y * _e69.y)) + (_e92.z * _e69.z)) + (_e92.w * 1f)) * _e76) - (_e40.y * _e119));
    let _e244 = ((((((_e137.x * _e128.x) + (_e137.y * _e128.y)) + (_e137.z * _e128.z)) + (_e137.w * 1f)) * _e135) - (_e40.x * _e178));
    let _e245 = ((((((_e151.x * _e128.x) + (_e151.y * _e128.y)) + (_e151.z * _e128.z)) + (_e151.w * 1f)) * _e135) - (_e40.y * _e178));
    let _e248 = ((((((_e196.x * _e187.x) + (_e196.y * _e187.y)) + (_e196.z * _e187.z)) + (_e196.w * 1f)) * _e194) - (_e40.x * _e237));
    let _e249 = ((((((_e210.x * _e187.x) + (_e210.y * _e187.y)) + (_e210.z * _e187.z)) + (_e210.w * 1f)) * _e194) - (_e40.y * _e237));
    let _e252 = ((_e248 * _e245) - (_e249 * _e244));
    let _e255 = ((_e240 * _e249) - (_e241 * _e248));
    let _e258 = ((_e244 * _e241) - (_e245 * _e240));
    let _e260 = ((_e252 + _e255) + _e258);
    if (_e260 == 0f) {
        phi_348_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_348_ = vec3<f32>((_e252 / _e260), (_e255 / _e260), (_e258 / _e260));
    }
    let _e267 = phi_348_;
    let _e269 = (_e58.i0_ & 2147483647u);
    if (_e269 < _e48) {
    } else {
        return;
    }
    let _e275 = vertices.member[(0u + _e269)];
    if (_e58.i1_ < _e48) {
    } else {
        return;
    }
    let _e279 = vertices.member[(0u + _e58.i1_)];
    if (_e58.i2_ < _e48) {
    } else {
        return;
    }
    let _e283 = vertices.member[(0u + _e58.i2_)];
    let _e284 = array<abi_Vertex, 3>(_e275, _e279, _e283);
    if (_e284[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e291 = materials.member[(0u + _e284[0].material)].flags;
    if ((_e291 & 1u) == 0u) {
        phi_537_ = false;
    } else {
        let _e295 = materials.member[(0u + _e284[0].material)].cutoff;
        if (_e295 <= 0f) {
            phi_536_ = true;
        } else {
            let _e299 = materials.member[(0u + _e284[0].material)].base_color[3u];
            let _e325 = (_e299 * ((((f32((_e284[0].color >> bitcast<u32>(24i))) * _e267.x) + (f32((_e284[1].color >> bitcast<u32>(24i))) * _e267.y)) + (f32((_e284[2].color >> bitcast<u32>(24i))) * _e267.z)) * (1f / 255f)));
            let _e327 = materials.member[(0u + _e284[0].material)].alpha_size;
            if (_e327 == 0u) {
                phi_532_ = _e325;
            } else {
                let _e330 = materials.member[(0u + _e284[0].material)].alpha_offset;
                let _e332 = materials.member[(0u + _e284[0].material)].alpha_size;
                let _e334 = materials.member[(0u + _e284[0].material)].flags;
                local.offset = _e330;
                local.size = _e332;
                local.flags = _e334;
                let _e363 = _lt_shaders_texture_TextureView_quad((&local), (((_e284[0].u * _e267.x) + (_e284[1].u * _e267.y)) + (_e284[2].u * _e267.z)), (((_e284[0].v * _e267.x) + (_e284[1].v * _e267.y)) + (_e284[2].v * _e267.z)));
                let _e367 = (_e363.indices[0] >> bitcast<u32>(2i));
                if (_e367 < _e54) {
                } else {
                    return;
                }
                let _e371 = alpha_texels.member[(0u + _e367)];
                let _e387 = (_e363.indices[1] >> bitcast<u32>(2i));
                if (_e387 < _e54) {
                } else {
                    return;
                }
                let _e391 = alpha_texels.member[(0u + _e387)];
                let _e408 = (_e363.indices[2] >> bitcast<u32>(2i));
                if (_e408 < _e54) {
                } else {
                    return;
                }
                let _e412 = alpha_texels.member[(0u + _e408)];
                let _e429 = (_e363.indices[3] >> bitcast<u32>(2i));
                if (_e429 < _e54) {
                } else {
                    return;
                }
                let _e433 = alpha_texels.member[(0u + _e429)];
                phi_532_ = (_e325 * (((((f32(((_e371 >> bitcast<u32>((((_e363.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.x) + ((f32(((_e391 >> bitcast<u32>((((_e363.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.y)) + ((f32(((_e412 >> bitcast<u32>((((_e363.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.z)) + ((f32(((_e433 >> bitcast<u32>((((_e363.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.w)));
            }
            let _e449 = phi_532_;
            let _e451 = materials.member[(0u + _e284[0].material)].cutoff;
            phi_536_ = (_e449 >= _e451);
        }
        let _e454 = phi_536_;
        phi_537_ = _e454;
    }
    let _e456 = phi_537_;
    if _e456 {
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
