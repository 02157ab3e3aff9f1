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

var<private> at_1: vec4<f32>;
var<private> triangle_1: u32;
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(1) 
var<storage> triangles: type_19;
@group(0) @binding(2) 
var<storage> vertices: type_23;
@group(0) @binding(3) 
var<storage> materials: type_27;
@group(0) @binding(4) 
var<storage> alpha_texels: type_6;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_146_: f32;
    var phi_151_: f32;
    var phi_152_: bool;
    var phi_153_: f32;
    var phi_154_: bool;
    var phi_158_: f32;
    var phi_184_: f32;
    var phi_189_: f32;
    var phi_190_: bool;
    var phi_191_: f32;
    var phi_192_: bool;
    var phi_196_: f32;
    var phi_204_: f32;
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_234_: u32;
    var phi_248_: u32;
    var phi_255_: u32;
    var phi_260_: u32;
    var phi_266_: u32;
    var phi_271_: u32;
    var phi_273_: texture_Axis;
    var phi_301_: f32;
    var phi_306_: f32;
    var phi_307_: bool;
    var phi_308_: f32;
    var phi_309_: bool;
    var phi_313_: f32;
    var phi_339_: f32;
    var phi_344_: f32;
    var phi_345_: bool;
    var phi_346_: f32;
    var phi_347_: bool;
    var phi_351_: f32;
    var phi_359_: f32;
    var phi_360_: f32;
    var phi_361_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_389_: u32;
    var phi_403_: u32;
    var phi_410_: u32;
    var phi_415_: u32;
    var phi_421_: u32;
    var phi_426_: u32;
    var phi_428_: texture_Axis;

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
                phi_146_ = 1f;
            } else {
                phi_146_ = 0f;
            }
            let _e73 = phi_146_;
            if (param_1 < 8388608f) {
                phi_151_ = (_e70 - _e73);
                phi_152_ = false;
            } else {
                phi_151_ = f32();
                phi_152_ = true;
            }
            let _e76 = phi_151_;
            let _e78 = phi_152_;
            phi_153_ = _e76;
            phi_154_ = _e78;
        } else {
            phi_153_ = f32();
            phi_154_ = true;
        }
        let _e80 = phi_153_;
        let _e82 = phi_154_;
        if _e82 {
            phi_158_ = param_1;
        } else {
            phi_158_ = _e80;
        }
        let _e84 = phi_158_;
        phi_206_ = (param_1 - _e84);
    } else {
        if (_e57 == 1u) {
            let _e87 = (param_1 * 0.5f);
            if (_e87 > -8388608f) {
                let _e99 = f32(select(0i, select(select(i32(_e87), i32(-2147483648), (_e87 < bitcast<f32>(3472883712u))), 2147483647i, (_e87 > bitcast<f32>(1325400063u))), (_e87 == _e87)));
                if (_e99 > _e87) {
                    phi_184_ = 1f;
                } else {
                    phi_184_ = 0f;
                }
                let _e102 = phi_184_;
                if (_e87 < 8388608f) {
                    phi_189_ = (_e99 - _e102);
                    phi_190_ = false;
                } else {
                    phi_189_ = f32();
                    phi_190_ = true;
                }
                let _e105 = phi_189_;
                let _e107 = phi_190_;
                phi_191_ = _e105;
                phi_192_ = _e107;
            } else {
                phi_191_ = f32();
                phi_192_ = true;
            }
            let _e109 = phi_191_;
            let _e111 = phi_192_;
            if _e111 {
                phi_196_ = _e87;
            } else {
                phi_196_ = _e109;
            }
            let _e113 = phi_196_;
            let _e115 = (param_1 - (2f * _e113));
            if (_e115 > 1f) {
                phi_204_ = (2f - _e115);
            } else {
                phi_204_ = _e115;
            }
            let _e119 = phi_204_;
            phi_205_ = _e119;
        } else {
            phi_205_ = param_1;
        }
        let _e121 = phi_205_;
        phi_206_ = _e121;
    }
    let _e123 = phi_206_;
    if (_e123 > 0f) {
        if (_e123 < 1f) {
            phi_215_ = _e123;
        } else {
            phi_215_ = 1f;
        }
        let _e127 = phi_215_;
        phi_216_ = _e127;
    } else {
        phi_216_ = 0f;
    }
    let _e129 = phi_216_;
    let _e130 = (_e44 - 1u);
    let _e132 = (_e129 * f32(_e44));
    if _e52 {
        let _e139 = select(select(u32(_e132), 0u, (_e132 < bitcast<f32>(0u))), 4294967295u, (_e132 > bitcast<f32>(1333788671u)));
        if (_e130 < _e139) {
            phi_234_ = _e130;
        } else {
            phi_234_ = _e139;
        }
        let _e142 = phi_234_;
        phi_273_ = texture_Axis(_e142, _e142, 0f);
    } else {
        let _e144 = (_e132 + 0.5f);
        let _e151 = select(select(u32(_e144), 0u, (_e144 < bitcast<f32>(0u))), 4294967295u, (_e144 > bitcast<f32>(1333788671u)));
        if (_e44 < _e151) {
            phi_248_ = _e44;
        } else {
            phi_248_ = _e151;
        }
        let _e154 = phi_248_;
        if (_e57 == 0u) {
            phi_255_ = _e130;
        } else {
            phi_255_ = 0u;
        }
        let _e159 = phi_255_;
        if (_e57 == 0u) {
            phi_260_ = 0u;
        } else {
            phi_260_ = _e130;
        }
        let _e162 = phi_260_;
        if (_e154 == 0u) {
            phi_266_ = _e159;
        } else {
            phi_266_ = (_e154 - 1u);
        }
        let _e166 = phi_266_;
        if (_e154 > _e130) {
            phi_271_ = _e162;
        } else {
            phi_271_ = _e154;
        }
        let _e169 = phi_271_;
        phi_273_ = texture_Axis(_e166, _e169, (_e144 - f32(_e154)));
    }
    let _e172 = phi_273_;
    let _e174 = (*param).flags;
    let _e177 = ((_e174 >> bitcast<u32>(6u)) & 3u);
    if (_e177 == 0u) {
        if (param_2 > -8388608f) {
            let _e190 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e190 > param_2) {
                phi_301_ = 1f;
            } else {
                phi_301_ = 0f;
            }
            let _e193 = phi_301_;
            if (param_2 < 8388608f) {
                phi_306_ = (_e190 - _e193);
                phi_307_ = false;
            } else {
                phi_306_ = f32();
                phi_307_ = true;
            }
            let _e196 = phi_306_;
            let _e198 = phi_307_;
            phi_308_ = _e196;
            phi_309_ = _e198;
        } else {
            phi_308_ = f32();
            phi_309_ = true;
        }
        let _e200 = phi_308_;
        let _e202 = phi_309_;
        if _e202 {
            phi_313_ = param_2;
        } else {
            phi_313_ = _e200;
        }
        let _e204 = phi_313_;
        phi_361_ = (param_2 - _e204);
    } else {
        if (_e177 == 1u) {
            let _e207 = (param_2 * 0.5f);
            if (_e207 > -8388608f) {
                let _e219 = f32(select(0i, select(select(i32(_e207), i32(-2147483648), (_e207 < bitcast<f32>(3472883712u))), 2147483647i, (_e207 > bitcast<f32>(1325400063u))), (_e207 == _e207)));
                if (_e219 > _e207) {
                    phi_339_ = 1f;
                } else {
                    phi_339_ = 0f;
                }
                let _e222 = phi_339_;
                if (_e207 < 8388608f) {
                    phi_344_ = (_e219 - _e222);
                    phi_345_ = false;
                } else {
                    phi_344_ = f32();
                    phi_345_ = true;
                }
                let _e225 = phi_344_;
                let _e227 = phi_345_;
                phi_346_ = _e225;
                phi_347_ = _e227;
            } else {
                phi_346_ = f32();
                phi_347_ = true;
            }
            let _e229 = phi_346_;
            let _e231 = phi_347_;
            if _e231 {
                phi_351_ = _e207;
            } else {
                phi_351_ = _e229;
            }
            let _e233 = phi_351_;
            let _e235 = (param_2 - (2f * _e233));
            if (_e235 > 1f) {
                phi_359_ = (2f - _e235);
            } else {
                phi_359_ = _e235;
            }
            let _e239 = phi_359_;
            phi_360_ = _e239;
        } else {
            phi_360_ = param_2;
        }
        let _e241 = phi_360_;
        phi_361_ = _e241;
    }
    let _e243 = phi_361_;
    if (_e243 > 0f) {
        if (_e243 < 1f) {
            phi_370_ = _e243;
        } else {
            phi_370_ = 1f;
        }
        let _e247 = phi_370_;
        phi_371_ = _e247;
    } else {
        phi_371_ = 0f;
    }
    let _e249 = phi_371_;
    let _e250 = (_e48 - 1u);
    let _e252 = (_e249 * f32(_e48));
    if _e52 {
        let _e259 = select(select(u32(_e252), 0u, (_e252 < bitcast<f32>(0u))), 4294967295u, (_e252 > bitcast<f32>(1333788671u)));
        if (_e250 < _e259) {
            phi_389_ = _e250;
        } else {
            phi_389_ = _e259;
        }
        let _e262 = phi_389_;
        phi_428_ = texture_Axis(_e262, _e262, 0f);
    } else {
        let _e264 = (_e252 + 0.5f);
        let _e271 = select(select(u32(_e264), 0u, (_e264 < bitcast<f32>(0u))), 4294967295u, (_e264 > bitcast<f32>(1333788671u)));
        if (_e48 < _e271) {
            phi_403_ = _e48;
        } else {
            phi_403_ = _e271;
        }
        let _e274 = phi_403_;
        if (_e177 == 0u) {
            phi_410_ = _e250;
        } else {
            phi_410_ = 0u;
        }
        let _e279 = phi_410_;
        if (_e177 == 0u) {
            phi_415_ = 0u;
        } else {
            phi_415_ = _e250;
        }
        let _e282 = phi_415_;
        if (_e274 == 0u) {
            phi_421_ = _e279;
        } else {
            phi_421_ = (_e274 - 1u);
        }
        let _e286 = phi_421_;
        if (_e274 > _e250) {
            phi_426_ = _e282;
        } else {
            phi_426_ = _e274;
        }
        let _e289 = phi_426_;
        phi_428_ = texture_Axis(_e286, _e289, (_e264 - f32(_e274)));
    }
    let _e292 = phi_428_;
    let _e296 = (*param).offset;
    let _e303 = (*param).offset;
    let _e310 = (*param).offset;
    let _e317 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e296 + (_e292.low * _e44)) + _e172.low), ((_e303 + (_e292.low * _e44)) + _e172.high), ((_e310 + (_e292.high * _e44)) + _e172.low), ((_e317 + (_e292.high * _e44)) + _e172.high)), vec4<f32>(((1f - _e172.fraction) * (1f - _e292.fraction)), (_e172.fraction * (1f - _e292.fraction)), ((1f - _e172.fraction) * _e292.fraction), (_e172.fraction * _e292.fraction)));
}

fn spirv_std_arch_kill() {
    discard;
}

fn function_() {
    var local: texture_TextureView;
    var phi_509_: vec3<f32>;
    var phi_510_: vec3<f32>;
    var phi_572_: vec3<f32>;
    var phi_573_: vec3<f32>;
    var phi_635_: vec3<f32>;
    var phi_636_: vec3<f32>;
    var phi_751_: vec3<f32>;
    var phi_902_: f32;
    var phi_906_: bool;
    var phi_907_: bool;

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
        phi_510_ = _e58.v0_;
    } else {
        if (0u == 1u) {
            phi_509_ = _e58.v1_;
        } else {
            phi_509_ = _e58.v2_;
        }
        let _e67 = phi_509_;
        phi_510_ = _e67;
    }
    let _e69 = phi_510_;
    let _e71 = p.member.map_size;
    let _e76 = f32(_e71);
    let _e78 = p.member.projection.row_x;
    let _e92 = p.member.projection.row_y;
    let _e108 = p.member.projection.row_w;
    let _e119 = ((((_e108.x * _e69.x) + (_e108.y * _e69.y)) + (_e108.z * _e69.z)) + (_e108.w * 1f));
    if (1u == 0u) {
        phi_573_ = _e58.v0_;
    } else {
        if (1u == 1u) {
            phi_572_ = _e58.v1_;
        } else {
            phi_572_ = _e58.v2_;
        }
        let _e126 = phi_572_;
        phi_573_ = _e126;
    }
    let _e128 = phi_573_;
    let _e130 = p.member.map_size;
    let _e135 = f32(_e130);
    let _e137 = p.member.projection.row_x;
    let _e151 = p.member.projection.row_y;
    let _e167 = p.member.projection.row_w;
    let _e178 = ((((_e167.x * _e128.x) + (_e167.y * _e128.y)) + (_e167.z * _e128.z)) + (_e167.w * 1f));
    if (2u == 0u) {
        phi_636_ = _e58.v0_;
    } else {
        if (2u == 1u) {
            phi_635_ = _e58.v1_;
        } else {
            phi_635_ = _e58.v2_;
        }
        let _e185 = phi_635_;
        phi_636_ = _e185;
    }
    let _e187 = phi_636_;
    let _e189 = p.member.map_size;
    let _e194 = f32(_e189);
    let _e196 = p.member.projection.row_x;
    let _e210 = p.member.projection.row_y;
    let _e226 = p.member.projection.row_w;
    let _e237 = ((((_e226.x * _e187.x) + (_e226.y * _e187.y)) + (_e226.z * _e187.z)) + (_e226.w * 1f));
    let _e239 = (_e58.i0_ & 2147483647u);
    if (_e239 < _e48) {
    } else {
        return;
    }
    let _e245 = vertices.member[(0u + _e239)];
    if (_e58.i1_ < _e48) {
    } else {
        return;
    }
    let _e249 = vertices.member[(0u + _e58.i1_)];
    if (_e58.i2_ < _e48) {
    } else {
        return;
    }
    let _e253 = vertices.member[(0u + _e58.i2_)];
    let _e254 = array<abi_Vertex, 3>(_e245, _e249, _e253);
    if (_e254[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e262 = ((((((_e78.x * _e69.x) + (_e78.y * _e69.y)) + (_e78.z * _e69.z)) + (_e78.w * 1f)) * _e76) - (_e40.x * _e119));
    let _e263 = ((((((_e92.x * _e69.x) + (_e92.y * _e69.y)) + (_e92.z * _e69.z)) + (_e92.w * 1f)) * _e76) - (_e40.y * _e119));
    let _e266 = ((((((_e137.x * _e128.x) + (_e137.y * _e128.y)) + (_e137.z * _e128.z)) + (_e137.w * 1f)) * _e135) - (_e40.x * _e178));
    let _e267 = ((((((_e151.x * _e128.x) + (_e151.y * _e128.y)) + (_e151.z * _e128.z)) + (_e151.w * 1f)) * _e135) - (_e40.y * _e178));
    let _e270 = ((((((_e196.x * _e187.x) + (_e196.y * _e187.y)) + (_e196.z * _e187.z)) + (_e196.w * 1f)) * _e194) - (_e40.x * _e237));
    let _e271 = ((((((_e210.x * _e187.x) + (_e210.y * _e187.y)) + (_e210.z * _e187.z)) + (_e210.w * 1f)) * _e194) - (_e40.y * _e237));
    let _e274 = ((_e270 * _e267) - (_e271 * _e266));
    let _e277 = ((_e262 * _e271) - (_e263 * _e270));
    let _e280 = ((_e266 * _e263) - (_e267 * _e262));
    let _e282 = ((_e274 + _e277) + _e280);
    if (_e282 == 0f) {
        phi_751_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_751_ = vec3<f32>((_e274 / _e282), (_e277 / _e282), (_e280 / _e282));
    }
    let _e289 = phi_751_;
    let _e291 = materials.member[(0u + _e254[0].material)].flags;
    if ((_e291 & 1u) == 0u) {
        phi_907_ = false;
    } else {
        let _e295 = materials.member[(0u + _e254[0].material)].cutoff;
        if (_e295 <= 0f) {
            phi_906_ = true;
        } else {
            let _e299 = materials.member[(0u + _e254[0].material)].base_color[3u];
            let _e325 = (_e299 * ((((f32((_e254[0].color >> bitcast<u32>(24i))) * _e289.x) + (f32((_e254[1].color >> bitcast<u32>(24i))) * _e289.y)) + (f32((_e254[2].color >> bitcast<u32>(24i))) * _e289.z)) * (1f / 255f)));
            let _e327 = materials.member[(0u + _e254[0].material)].alpha_size;
            if (_e327 == 0u) {
                phi_902_ = _e325;
            } else {
                let _e330 = materials.member[(0u + _e254[0].material)].alpha_offset;
                let _e332 = materials.member[(0u + _e254[0].material)].alpha_size;
                let _e334 = materials.member[(0u + _e254[0].material)].flags;
                local.offset = _e330;
                local.size = _e332;
                local.flags = _e334;
                let _e363 = _lt_shaders_texture_TextureView_quad((&local), (((_e254[0].u * _e289.x) + (_e254[1].u * _e289.y)) + (_e254[2].u * _e289.z)), (((_e254[0].v * _e289.x) + (_e254[1].v * _e289.y)) + (_e254[2].v * _e289.z)));
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
                phi_902_ = (_e325 * (((((f32(((_e371 >> bitcast<u32>((((_e363.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.x) + ((f32(((_e391 >> bitcast<u32>((((_e363.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.y)) + ((f32(((_e412 >> bitcast<u32>((((_e363.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.z)) + ((f32(((_e433 >> bitcast<u32>((((_e363.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e363.weights.w)));
            }
            let _e449 = phi_902_;
            let _e451 = materials.member[(0u + _e254[0].material)].cutoff;
            phi_906_ = (_e449 >= _e451);
        }
        let _e454 = phi_906_;
        phi_907_ = _e454;
    }
    let _e456 = phi_907_;
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
