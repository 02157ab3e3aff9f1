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
var<private> placed_1: u32;
@group(0) @binding(3) 
var<storage> vertices: type_23;
@group(0) @binding(4) 
var<storage> materials: type_27;
@group(0) @binding(5) 
var<storage> alpha_texels: type_6;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_157_: f32;
    var phi_162_: f32;
    var phi_163_: bool;
    var phi_164_: f32;
    var phi_165_: bool;
    var phi_169_: f32;
    var phi_195_: f32;
    var phi_200_: f32;
    var phi_201_: bool;
    var phi_202_: f32;
    var phi_203_: bool;
    var phi_207_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_226_: f32;
    var phi_227_: f32;
    var phi_245_: u32;
    var phi_259_: u32;
    var phi_266_: u32;
    var phi_271_: u32;
    var phi_277_: u32;
    var phi_282_: u32;
    var phi_284_: texture_Axis;
    var phi_312_: f32;
    var phi_317_: f32;
    var phi_318_: bool;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_324_: f32;
    var phi_350_: f32;
    var phi_355_: f32;
    var phi_356_: bool;
    var phi_357_: f32;
    var phi_358_: bool;
    var phi_362_: f32;
    var phi_370_: f32;
    var phi_371_: f32;
    var phi_372_: f32;
    var phi_381_: f32;
    var phi_382_: f32;
    var phi_400_: u32;
    var phi_414_: u32;
    var phi_421_: u32;
    var phi_426_: u32;
    var phi_432_: u32;
    var phi_437_: u32;
    var phi_439_: texture_Axis;

    let _e45 = (*param).size;
    let _e46 = (_e45 & 65535u);
    let _e48 = (*param).size;
    let _e50 = (_e48 >> bitcast<u32>(16i));
    let _e52 = (*param).flags;
    let _e54 = ((_e52 & 4u) != 0u);
    let _e56 = (*param).flags;
    let _e59 = ((_e56 >> bitcast<u32>(4u)) & 3u);
    if (_e59 == 0u) {
        if (param_1 > -8388608f) {
            let _e72 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e72 > param_1) {
                phi_157_ = 1f;
            } else {
                phi_157_ = 0f;
            }
            let _e75 = phi_157_;
            if (param_1 < 8388608f) {
                phi_162_ = (_e72 - _e75);
                phi_163_ = false;
            } else {
                phi_162_ = f32();
                phi_163_ = true;
            }
            let _e78 = phi_162_;
            let _e80 = phi_163_;
            phi_164_ = _e78;
            phi_165_ = _e80;
        } else {
            phi_164_ = f32();
            phi_165_ = true;
        }
        let _e82 = phi_164_;
        let _e84 = phi_165_;
        if _e84 {
            phi_169_ = param_1;
        } else {
            phi_169_ = _e82;
        }
        let _e86 = phi_169_;
        phi_217_ = (param_1 - _e86);
    } else {
        if (_e59 == 1u) {
            let _e89 = (param_1 * 0.5f);
            if (_e89 > -8388608f) {
                let _e101 = f32(select(0i, select(select(i32(_e89), i32(-2147483648), (_e89 < bitcast<f32>(3472883712u))), 2147483647i, (_e89 > bitcast<f32>(1325400063u))), (_e89 == _e89)));
                if (_e101 > _e89) {
                    phi_195_ = 1f;
                } else {
                    phi_195_ = 0f;
                }
                let _e104 = phi_195_;
                if (_e89 < 8388608f) {
                    phi_200_ = (_e101 - _e104);
                    phi_201_ = false;
                } else {
                    phi_200_ = f32();
                    phi_201_ = true;
                }
                let _e107 = phi_200_;
                let _e109 = phi_201_;
                phi_202_ = _e107;
                phi_203_ = _e109;
            } else {
                phi_202_ = f32();
                phi_203_ = true;
            }
            let _e111 = phi_202_;
            let _e113 = phi_203_;
            if _e113 {
                phi_207_ = _e89;
            } else {
                phi_207_ = _e111;
            }
            let _e115 = phi_207_;
            let _e117 = (param_1 - (2f * _e115));
            if (_e117 > 1f) {
                phi_215_ = (2f - _e117);
            } else {
                phi_215_ = _e117;
            }
            let _e121 = phi_215_;
            phi_216_ = _e121;
        } else {
            phi_216_ = param_1;
        }
        let _e123 = phi_216_;
        phi_217_ = _e123;
    }
    let _e125 = phi_217_;
    if (_e125 > 0f) {
        if (_e125 < 1f) {
            phi_226_ = _e125;
        } else {
            phi_226_ = 1f;
        }
        let _e129 = phi_226_;
        phi_227_ = _e129;
    } else {
        phi_227_ = 0f;
    }
    let _e131 = phi_227_;
    let _e132 = (_e46 - 1u);
    let _e134 = (_e131 * f32(_e46));
    if _e54 {
        let _e141 = select(select(u32(_e134), 0u, (_e134 < bitcast<f32>(0u))), 4294967295u, (_e134 > bitcast<f32>(1333788671u)));
        if (_e132 < _e141) {
            phi_245_ = _e132;
        } else {
            phi_245_ = _e141;
        }
        let _e144 = phi_245_;
        phi_284_ = texture_Axis(_e144, _e144, 0f);
    } else {
        let _e146 = (_e134 + 0.5f);
        let _e153 = select(select(u32(_e146), 0u, (_e146 < bitcast<f32>(0u))), 4294967295u, (_e146 > bitcast<f32>(1333788671u)));
        if (_e46 < _e153) {
            phi_259_ = _e46;
        } else {
            phi_259_ = _e153;
        }
        let _e156 = phi_259_;
        if (_e59 == 0u) {
            phi_266_ = _e132;
        } else {
            phi_266_ = 0u;
        }
        let _e161 = phi_266_;
        if (_e59 == 0u) {
            phi_271_ = 0u;
        } else {
            phi_271_ = _e132;
        }
        let _e164 = phi_271_;
        if (_e156 == 0u) {
            phi_277_ = _e161;
        } else {
            phi_277_ = (_e156 - 1u);
        }
        let _e168 = phi_277_;
        if (_e156 > _e132) {
            phi_282_ = _e164;
        } else {
            phi_282_ = _e156;
        }
        let _e171 = phi_282_;
        phi_284_ = texture_Axis(_e168, _e171, (_e146 - f32(_e156)));
    }
    let _e174 = phi_284_;
    let _e176 = (*param).flags;
    let _e179 = ((_e176 >> bitcast<u32>(6u)) & 3u);
    if (_e179 == 0u) {
        if (param_2 > -8388608f) {
            let _e192 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e192 > param_2) {
                phi_312_ = 1f;
            } else {
                phi_312_ = 0f;
            }
            let _e195 = phi_312_;
            if (param_2 < 8388608f) {
                phi_317_ = (_e192 - _e195);
                phi_318_ = false;
            } else {
                phi_317_ = f32();
                phi_318_ = true;
            }
            let _e198 = phi_317_;
            let _e200 = phi_318_;
            phi_319_ = _e198;
            phi_320_ = _e200;
        } else {
            phi_319_ = f32();
            phi_320_ = true;
        }
        let _e202 = phi_319_;
        let _e204 = phi_320_;
        if _e204 {
            phi_324_ = param_2;
        } else {
            phi_324_ = _e202;
        }
        let _e206 = phi_324_;
        phi_372_ = (param_2 - _e206);
    } else {
        if (_e179 == 1u) {
            let _e209 = (param_2 * 0.5f);
            if (_e209 > -8388608f) {
                let _e221 = f32(select(0i, select(select(i32(_e209), i32(-2147483648), (_e209 < bitcast<f32>(3472883712u))), 2147483647i, (_e209 > bitcast<f32>(1325400063u))), (_e209 == _e209)));
                if (_e221 > _e209) {
                    phi_350_ = 1f;
                } else {
                    phi_350_ = 0f;
                }
                let _e224 = phi_350_;
                if (_e209 < 8388608f) {
                    phi_355_ = (_e221 - _e224);
                    phi_356_ = false;
                } else {
                    phi_355_ = f32();
                    phi_356_ = true;
                }
                let _e227 = phi_355_;
                let _e229 = phi_356_;
                phi_357_ = _e227;
                phi_358_ = _e229;
            } else {
                phi_357_ = f32();
                phi_358_ = true;
            }
            let _e231 = phi_357_;
            let _e233 = phi_358_;
            if _e233 {
                phi_362_ = _e209;
            } else {
                phi_362_ = _e231;
            }
            let _e235 = phi_362_;
            let _e237 = (param_2 - (2f * _e235));
            if (_e237 > 1f) {
                phi_370_ = (2f - _e237);
            } else {
                phi_370_ = _e237;
            }
            let _e241 = phi_370_;
            phi_371_ = _e241;
        } else {
            phi_371_ = param_2;
        }
        let _e243 = phi_371_;
        phi_372_ = _e243;
    }
    let _e245 = phi_372_;
    if (_e245 > 0f) {
        if (_e245 < 1f) {
            phi_381_ = _e245;
        } else {
            phi_381_ = 1f;
        }
        let _e249 = phi_381_;
        phi_382_ = _e249;
    } else {
        phi_382_ = 0f;
    }
    let _e251 = phi_382_;
    let _e252 = (_e50 - 1u);
    let _e254 = (_e251 * f32(_e50));
    if _e54 {
        let _e261 = select(select(u32(_e254), 0u, (_e254 < bitcast<f32>(0u))), 4294967295u, (_e254 > bitcast<f32>(1333788671u)));
        if (_e252 < _e261) {
            phi_400_ = _e252;
        } else {
            phi_400_ = _e261;
        }
        let _e264 = phi_400_;
        phi_439_ = texture_Axis(_e264, _e264, 0f);
    } else {
        let _e266 = (_e254 + 0.5f);
        let _e273 = select(select(u32(_e266), 0u, (_e266 < bitcast<f32>(0u))), 4294967295u, (_e266 > bitcast<f32>(1333788671u)));
        if (_e50 < _e273) {
            phi_414_ = _e50;
        } else {
            phi_414_ = _e273;
        }
        let _e276 = phi_414_;
        if (_e179 == 0u) {
            phi_421_ = _e252;
        } else {
            phi_421_ = 0u;
        }
        let _e281 = phi_421_;
        if (_e179 == 0u) {
            phi_426_ = 0u;
        } else {
            phi_426_ = _e252;
        }
        let _e284 = phi_426_;
        if (_e276 == 0u) {
            phi_432_ = _e281;
        } else {
            phi_432_ = (_e276 - 1u);
        }
        let _e288 = phi_432_;
        if (_e276 > _e252) {
            phi_437_ = _e284;
        } else {
            phi_437_ = _e276;
        }
        let _e291 = phi_437_;
        phi_439_ = texture_Axis(_e288, _e291, (_e266 - f32(_e276)));
    }
    let _e294 = phi_439_;
    let _e298 = (*param).offset;
    let _e305 = (*param).offset;
    let _e312 = (*param).offset;
    let _e319 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e298 + (_e294.low * _e46)) + _e174.low), ((_e305 + (_e294.low * _e46)) + _e174.high), ((_e312 + (_e294.high * _e46)) + _e174.low), ((_e319 + (_e294.high * _e46)) + _e174.high)), vec4<f32>(((1f - _e174.fraction) * (1f - _e294.fraction)), (_e174.fraction * (1f - _e294.fraction)), ((1f - _e174.fraction) * _e294.fraction), (_e174.fraction * _e294.fraction)));
}

fn spirv_std_arch_kill() {
    discard;
}

fn function_() {
    var local: texture_TextureView;
    var phi_531_: vec3<f32>;
    var phi_532_: vec3<f32>;
    var phi_630_: vec3<f32>;
    var phi_631_: vec3<f32>;
    var phi_729_: vec3<f32>;
    var phi_730_: vec3<f32>;
    var phi_848_: vec3<f32>;
    var phi_1032_: f32;
    var phi_1036_: bool;
    var phi_1037_: bool;

    let _e42 = at_1;
    let _e43 = triangle_1;
    let _e44 = placed_1;
    let _e54 = arrayLength((&vertices.member));
    let _e60 = arrayLength((&alpha_texels.member));
    if (_e43 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e64 = triangles.member[(0u + _e43)];
    if (_e44 < arrayLength((&instances.member))) {
    } else {
        return;
    }
    let _e68 = instances.member[(0u + _e44)];
    if (0u == 0u) {
        phi_532_ = _e64.v0_;
    } else {
        if (0u == 1u) {
            phi_531_ = _e64.v1_;
        } else {
            phi_531_ = _e64.v2_;
        }
        let _e77 = phi_531_;
        phi_532_ = _e77;
    }
    let _e79 = phi_532_;
    let _e95 = ((((_e68.object_to_world[0].x * _e79.x) + (_e68.object_to_world[0].y * _e79.y)) + (_e68.object_to_world[0].z * _e79.z)) + (_e68.object_to_world[0].w * 1f));
    let _e108 = ((((_e68.object_to_world[1].x * _e79.x) + (_e68.object_to_world[1].y * _e79.y)) + (_e68.object_to_world[1].z * _e79.z)) + (_e68.object_to_world[1].w * 1f));
    let _e121 = ((((_e68.object_to_world[2].x * _e79.x) + (_e68.object_to_world[2].y * _e79.y)) + (_e68.object_to_world[2].z * _e79.z)) + (_e68.object_to_world[2].w * 1f));
    let _e123 = p.member.map_size;
    let _e125 = f32(_e123);
    let _e127 = p.member.projection.row_x;
    let _e141 = p.member.projection.row_y;
    let _e157 = p.member.projection.row_w;
    let _e168 = ((((_e157.x * _e95) + (_e157.y * _e108)) + (_e157.z * _e121)) + (_e157.w * 1f));
    if (1u == 0u) {
        phi_631_ = _e64.v0_;
    } else {
        if (1u == 1u) {
            phi_630_ = _e64.v1_;
        } else {
            phi_630_ = _e64.v2_;
        }
        let _e175 = phi_630_;
        phi_631_ = _e175;
    }
    let _e177 = phi_631_;
    let _e193 = ((((_e68.object_to_world[0].x * _e177.x) + (_e68.object_to_world[0].y * _e177.y)) + (_e68.object_to_world[0].z * _e177.z)) + (_e68.object_to_world[0].w * 1f));
    let _e206 = ((((_e68.object_to_world[1].x * _e177.x) + (_e68.object_to_world[1].y * _e177.y)) + (_e68.object_to_world[1].z * _e177.z)) + (_e68.object_to_world[1].w * 1f));
    let _e219 = ((((_e68.object_to_world[2].x * _e177.x) + (_e68.object_to_world[2].y * _e177.y)) + (_e68.object_to_world[2].z * _e177.z)) + (_e68.object_to_world[2].w * 1f));
    let _e221 = p.member.map_size;
    let _e223 = f32(_e221);
    let _e225 = p.member.projection.row_x;
    let _e239 = p.member.projection.row_y;
    let _e255 = p.member.projection.row_w;
    let _e266 = ((((_e255.x * _e193) + (_e255.y * _e206)) + (_e255.z * _e219)) + (_e255.w * 1f));
    if (2u == 0u) {
        phi_730_ = _e64.v0_;
    } else {
        if (2u == 1u) {
            phi_729_ = _e64.v1_;
        } else {
            phi_729_ = _e64.v2_;
        }
        let _e273 = phi_729_;
        phi_730_ = _e273;
    }
    let _e275 = phi_730_;
    let _e291 = ((((_e68.object_to_world[0].x * _e275.x) + (_e68.object_to_world[0].y * _e275.y)) + (_e68.object_to_world[0].z * _e275.z)) + (_e68.object_to_world[0].w * 1f));
    let _e304 = ((((_e68.object_to_world[1].x * _e275.x) + (_e68.object_to_world[1].y * _e275.y)) + (_e68.object_to_world[1].z * _e275.z)) + (_e68.object_to_world[1].w * 1f));
    let _e317 = ((((_e68.object_to_world[2].x * _e275.x) + (_e68.object_to_world[2].y * _e275.y)) + (_e68.object_to_world[2].z * _e275.z)) + (_e68.object_to_world[2].w * 1f));
    let _e319 = p.member.map_size;
    let _e321 = f32(_e319);
    let _e323 = p.member.projection.row_x;
    let _e337 = p.member.projection.row_y;
    let _e353 = p.member.projection.row_w;
    let _e364 = ((((_e353.x * _e291) + (_e353.y * _e304)) + (_e353.z * _e317)) + (_e353.w * 1f));
    let _e367 = ((((((_e127.x * _e95) + (_e127.y * _e108)) + (_e127.z * _e121)) + (_e127.w * 1f)) * _e125) - (_e42.x * _e168));
    let _e368 = ((((((_e141.x * _e95) + (_e141.y * _e108)) + (_e141.z * _e121)) + (_e141.w * 1f)) * _e125) - (_e42.y * _e168));
    let _e371 = ((((((_e225.x * _e193) + (_e225.y * _e206)) + (_e225.z * _e219)) + (_e225.w * 1f)) * _e223) - (_e42.x * _e266));
    let _e372 = ((((((_e239.x * _e193) + (_e239.y * _e206)) + (_e239.z * _e219)) + (_e239.w * 1f)) * _e223) - (_e42.y * _e266));
    let _e375 = ((((((_e323.x * _e291) + (_e323.y * _e304)) + (_e323.z * _e317)) + (_e323.w * 1f)) * _e321) - (_e42.x * _e364));
    let _e376 = ((((((_e337.x * _e291) + (_e337.y * _e304)) + (_e337.z * _e317)) + (_e337.w * 1f)) * _e321) - (_e42.y * _e364));
    let _e379 = ((_e375 * _e372) - (_e376 * _e371));
    let _e382 = ((_e367 * _e376) - (_e368 * _e375));
    let _e385 = ((_e371 * _e368) - (_e372 * _e367));
    let _e387 = ((_e379 + _e382) + _e385);
    if (_e387 == 0f) {
        phi_848_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_848_ = vec3<f32>((_e379 / _e387), (_e382 / _e387), (_e385 / _e387));
    }
    let _e394 = phi_848_;
    let _e396 = (_e64.i0_ & 2147483647u);
    if (_e396 < _e54) {
    } else {
        return;
    }
    let _e402 = vertices.member[(0u + _e396)];
    if (_e64.i1_ < _e54) {
    } else {
        return;
    }
    let _e406 = vertices.member[(0u + _e64.i1_)];
    if (_e64.i2_ < _e54) {
    } else {
        return;
    }
    let _e410 = vertices.member[(0u + _e64.i2_)];
    let _e411 = array<abi_Vertex, 3>(_e402, _e406, _e410);
    if (_e411[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e418 = materials.member[(0u + _e411[0].material)].flags;
    if ((_e418 & 1u) == 0u) {
        phi_1037_ = false;
    } else {
        let _e422 = materials.member[(0u + _e411[0].material)].cutoff;
        if (_e422 <= 0f) {
            phi_1036_ = true;
        } else {
            let _e426 = materials.member[(0u + _e411[0].material)].base_color[3u];
            let _e452 = (_e426 * ((((f32((_e411[0].color >> bitcast<u32>(24i))) * _e394.x) + (f32((_e411[1].color >> bitcast<u32>(24i))) * _e394.y)) + (f32((_e411[2].color >> bitcast<u32>(24i))) * _e394.z)) * (1f / 255f)));
            let _e454 = materials.member[(0u + _e411[0].material)].alpha_size;
            if (_e454 == 0u) {
                phi_1032_ = _e452;
            } else {
                let _e457 = materials.member[(0u + _e411[0].material)].alpha_offset;
                let _e459 = materials.member[(0u + _e411[0].material)].alpha_size;
                let _e461 = materials.member[(0u + _e411[0].material)].flags;
                local.offset = _e457;
                local.size = _e459;
                local.flags = _e461;
                let _e490 = _lt_shaders_texture_TextureView_quad((&local), (((_e411[0].u * _e394.x) + (_e411[1].u * _e394.y)) + (_e411[2].u * _e394.z)), (((_e411[0].v * _e394.x) + (_e411[1].v * _e394.y)) + (_e411[2].v * _e394.z)));
                let _e494 = (_e490.indices[0] >> bitcast<u32>(2i));
                if (_e494 < _e60) {
                } else {
                    return;
                }
                let _e498 = alpha_texels.member[(0u + _e494)];
                let _e514 = (_e490.indices[1] >> bitcast<u32>(2i));
                if (_e514 < _e60) {
                } else {
                    return;
                }
                let _e518 = alpha_texels.member[(0u + _e514)];
                let _e535 = (_e490.indices[2] >> bitcast<u32>(2i));
                if (_e535 < _e60) {
                } else {
                    return;
                }
                let _e539 = alpha_texels.member[(0u + _e535)];
                let _e556 = (_e490.indices[3] >> bitcast<u32>(2i));
                if (_e556 < _e60) {
                } else {
                    return;
                }
                let _e560 = alpha_texels.member[(0u + _e556)];
                phi_1032_ = (_e452 * (((((f32(((_e498 >> bitcast<u32>((((_e490.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e490.weights.x) + ((f32(((_e518 >> bitcast<u32>((((_e490.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e490.weights.y)) + ((f32(((_e539 >> bitcast<u32>((((_e490.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e490.weights.z)) + ((f32(((_e560 >> bitcast<u32>((((_e490.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e490.weights.w)));
            }
            let _e576 = phi_1032_;
            let _e578 = materials.member[(0u + _e411[0].material)].cutoff;
            phi_1036_ = (_e576 >= _e578);
        }
        let _e581 = phi_1036_;
        phi_1037_ = _e581;
    }
    let _e583 = phi_1037_;
    if _e583 {
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
