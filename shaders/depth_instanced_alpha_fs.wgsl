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
var<private> placed_1: u32;
@group(0) @binding(3) 
var<storage> vertices: type_24;
@group(0) @binding(4) 
var<storage> materials: type_28;
@group(0) @binding(5) 
var<storage> alpha_texels: type_6;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_159_: f32;
    var phi_164_: f32;
    var phi_165_: bool;
    var phi_166_: f32;
    var phi_167_: bool;
    var phi_171_: f32;
    var phi_197_: f32;
    var phi_202_: f32;
    var phi_203_: bool;
    var phi_204_: f32;
    var phi_205_: bool;
    var phi_209_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_228_: f32;
    var phi_229_: f32;
    var phi_247_: u32;
    var phi_261_: u32;
    var phi_268_: u32;
    var phi_273_: u32;
    var phi_279_: u32;
    var phi_284_: u32;
    var phi_286_: texture_Axis;
    var phi_314_: f32;
    var phi_319_: f32;
    var phi_320_: bool;
    var phi_321_: f32;
    var phi_322_: bool;
    var phi_326_: f32;
    var phi_352_: f32;
    var phi_357_: f32;
    var phi_358_: bool;
    var phi_359_: f32;
    var phi_360_: bool;
    var phi_364_: f32;
    var phi_372_: f32;
    var phi_373_: f32;
    var phi_374_: f32;
    var phi_383_: f32;
    var phi_384_: f32;
    var phi_402_: u32;
    var phi_416_: u32;
    var phi_423_: u32;
    var phi_428_: u32;
    var phi_434_: u32;
    var phi_439_: u32;
    var phi_441_: texture_Axis;

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
                phi_159_ = 1f;
            } else {
                phi_159_ = 0f;
            }
            let _e75 = phi_159_;
            if (param_1 < 8388608f) {
                phi_164_ = (_e72 - _e75);
                phi_165_ = false;
            } else {
                phi_164_ = f32();
                phi_165_ = true;
            }
            let _e78 = phi_164_;
            let _e80 = phi_165_;
            phi_166_ = _e78;
            phi_167_ = _e80;
        } else {
            phi_166_ = f32();
            phi_167_ = true;
        }
        let _e82 = phi_166_;
        let _e84 = phi_167_;
        if _e84 {
            phi_171_ = param_1;
        } else {
            phi_171_ = _e82;
        }
        let _e86 = phi_171_;
        phi_219_ = (param_1 - _e86);
    } else {
        if (_e59 == 1u) {
            let _e89 = (param_1 * 0.5f);
            if (_e89 > -8388608f) {
                let _e101 = f32(select(0i, select(select(i32(_e89), i32(-2147483648), (_e89 < bitcast<f32>(3472883712u))), 2147483647i, (_e89 > bitcast<f32>(1325400063u))), (_e89 == _e89)));
                if (_e101 > _e89) {
                    phi_197_ = 1f;
                } else {
                    phi_197_ = 0f;
                }
                let _e104 = phi_197_;
                if (_e89 < 8388608f) {
                    phi_202_ = (_e101 - _e104);
                    phi_203_ = false;
                } else {
                    phi_202_ = f32();
                    phi_203_ = true;
                }
                let _e107 = phi_202_;
                let _e109 = phi_203_;
                phi_204_ = _e107;
                phi_205_ = _e109;
            } else {
                phi_204_ = f32();
                phi_205_ = true;
            }
            let _e111 = phi_204_;
            let _e113 = phi_205_;
            if _e113 {
                phi_209_ = _e89;
            } else {
                phi_209_ = _e111;
            }
            let _e115 = phi_209_;
            let _e117 = (param_1 - (2f * _e115));
            if (_e117 > 1f) {
                phi_217_ = (2f - _e117);
            } else {
                phi_217_ = _e117;
            }
            let _e121 = phi_217_;
            phi_218_ = _e121;
        } else {
            phi_218_ = param_1;
        }
        let _e123 = phi_218_;
        phi_219_ = _e123;
    }
    let _e125 = phi_219_;
    if (_e125 > 0f) {
        if (_e125 < 1f) {
            phi_228_ = _e125;
        } else {
            phi_228_ = 1f;
        }
        let _e129 = phi_228_;
        phi_229_ = _e129;
    } else {
        phi_229_ = 0f;
    }
    let _e131 = phi_229_;
    let _e132 = (_e46 - 1u);
    let _e134 = (_e131 * f32(_e46));
    if _e54 {
        let _e141 = select(select(u32(_e134), 0u, (_e134 < bitcast<f32>(0u))), 4294967295u, (_e134 > bitcast<f32>(1333788671u)));
        if (_e132 < _e141) {
            phi_247_ = _e132;
        } else {
            phi_247_ = _e141;
        }
        let _e144 = phi_247_;
        phi_286_ = texture_Axis(_e144, _e144, 0f);
    } else {
        let _e146 = (_e134 + 0.5f);
        let _e153 = select(select(u32(_e146), 0u, (_e146 < bitcast<f32>(0u))), 4294967295u, (_e146 > bitcast<f32>(1333788671u)));
        if (_e46 < _e153) {
            phi_261_ = _e46;
        } else {
            phi_261_ = _e153;
        }
        let _e156 = phi_261_;
        if (_e59 == 0u) {
            phi_268_ = _e132;
        } else {
            phi_268_ = 0u;
        }
        let _e161 = phi_268_;
        if (_e59 == 0u) {
            phi_273_ = 0u;
        } else {
            phi_273_ = _e132;
        }
        let _e164 = phi_273_;
        if (_e156 == 0u) {
            phi_279_ = _e161;
        } else {
            phi_279_ = (_e156 - 1u);
        }
        let _e168 = phi_279_;
        if (_e156 > _e132) {
            phi_284_ = _e164;
        } else {
            phi_284_ = _e156;
        }
        let _e171 = phi_284_;
        phi_286_ = texture_Axis(_e168, _e171, (_e146 - f32(_e156)));
    }
    let _e174 = phi_286_;
    let _e176 = (*param).flags;
    let _e179 = ((_e176 >> bitcast<u32>(6u)) & 3u);
    if (_e179 == 0u) {
        if (param_2 > -8388608f) {
            let _e192 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e192 > param_2) {
                phi_314_ = 1f;
            } else {
                phi_314_ = 0f;
            }
            let _e195 = phi_314_;
            if (param_2 < 8388608f) {
                phi_319_ = (_e192 - _e195);
                phi_320_ = false;
            } else {
                phi_319_ = f32();
                phi_320_ = true;
            }
            let _e198 = phi_319_;
            let _e200 = phi_320_;
            phi_321_ = _e198;
            phi_322_ = _e200;
        } else {
            phi_321_ = f32();
            phi_322_ = true;
        }
        let _e202 = phi_321_;
        let _e204 = phi_322_;
        if _e204 {
            phi_326_ = param_2;
        } else {
            phi_326_ = _e202;
        }
        let _e206 = phi_326_;
        phi_374_ = (param_2 - _e206);
    } else {
        if (_e179 == 1u) {
            let _e209 = (param_2 * 0.5f);
            if (_e209 > -8388608f) {
                let _e221 = f32(select(0i, select(select(i32(_e209), i32(-2147483648), (_e209 < bitcast<f32>(3472883712u))), 2147483647i, (_e209 > bitcast<f32>(1325400063u))), (_e209 == _e209)));
                if (_e221 > _e209) {
                    phi_352_ = 1f;
                } else {
                    phi_352_ = 0f;
                }
                let _e224 = phi_352_;
                if (_e209 < 8388608f) {
                    phi_357_ = (_e221 - _e224);
                    phi_358_ = false;
                } else {
                    phi_357_ = f32();
                    phi_358_ = true;
                }
                let _e227 = phi_357_;
                let _e229 = phi_358_;
                phi_359_ = _e227;
                phi_360_ = _e229;
            } else {
                phi_359_ = f32();
                phi_360_ = true;
            }
            let _e231 = phi_359_;
            let _e233 = phi_360_;
            if _e233 {
                phi_364_ = _e209;
            } else {
                phi_364_ = _e231;
            }
            let _e235 = phi_364_;
            let _e237 = (param_2 - (2f * _e235));
            if (_e237 > 1f) {
                phi_372_ = (2f - _e237);
            } else {
                phi_372_ = _e237;
            }
            let _e241 = phi_372_;
            phi_373_ = _e241;
        } else {
            phi_373_ = param_2;
        }
        let _e243 = phi_373_;
        phi_374_ = _e243;
    }
    let _e245 = phi_374_;
    if (_e245 > 0f) {
        if (_e245 < 1f) {
            phi_383_ = _e245;
        } else {
            phi_383_ = 1f;
        }
        let _e249 = phi_383_;
        phi_384_ = _e249;
    } else {
        phi_384_ = 0f;
    }
    let _e251 = phi_384_;
    let _e252 = (_e50 - 1u);
    let _e254 = (_e251 * f32(_e50));
    if _e54 {
        let _e261 = select(select(u32(_e254), 0u, (_e254 < bitcast<f32>(0u))), 4294967295u, (_e254 > bitcast<f32>(1333788671u)));
        if (_e252 < _e261) {
            phi_402_ = _e252;
        } else {
            phi_402_ = _e261;
        }
        let _e264 = phi_402_;
        phi_441_ = texture_Axis(_e264, _e264, 0f);
    } else {
        let _e266 = (_e254 + 0.5f);
        let _e273 = select(select(u32(_e266), 0u, (_e266 < bitcast<f32>(0u))), 4294967295u, (_e266 > bitcast<f32>(1333788671u)));
        if (_e50 < _e273) {
            phi_416_ = _e50;
        } else {
            phi_416_ = _e273;
        }
        let _e276 = phi_416_;
        if (_e179 == 0u) {
            phi_423_ = _e252;
        } else {
            phi_423_ = 0u;
        }
        let _e281 = phi_423_;
        if (_e179 == 0u) {
            phi_428_ = 0u;
        } else {
            phi_428_ = _e252;
        }
        let _e284 = phi_428_;
        if (_e276 == 0u) {
            phi_434_ = _e281;
        } else {
            phi_434_ = (_e276 - 1u);
        }
        let _e288 = phi_434_;
        if (_e276 > _e252) {
            phi_439_ = _e284;
        } else {
            phi_439_ = _e276;
        }
        let _e291 = phi_439_;
        phi_441_ = texture_Axis(_e288, _e291, (_e266 - f32(_e276)));
    }
    let _e294 = phi_441_;
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
    var phi_530_: vec3<f32>;
    var phi_531_: vec3<f32>;
    var phi_633_: vec3<f32>;
    var phi_634_: vec3<f32>;
    var phi_736_: vec3<f32>;
    var phi_737_: vec3<f32>;
    var phi_894_: vec3<f32>;
    var phi_1045_: f32;
    var phi_1049_: bool;
    var phi_1050_: bool;

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
    if (0u == 0u) {
        phi_531_ = _e64.v0_;
    } else {
        if (0u == 1u) {
            phi_530_ = _e64.v1_;
        } else {
            phi_530_ = _e64.v2_;
        }
        let _e74 = phi_530_;
        phi_531_ = _e74;
    }
    let _e76 = phi_531_;
    let _e82 = instances.member[(0u + _e44)].object_to_world[0u];
    let _e93 = ((((_e82.x * _e76.x) + (_e82.y * _e76.y)) + (_e82.z * _e76.z)) + (_e82.w * 1f));
    let _e95 = instances.member[(0u + _e44)].object_to_world[1u];
    let _e106 = ((((_e95.x * _e76.x) + (_e95.y * _e76.y)) + (_e95.z * _e76.z)) + (_e95.w * 1f));
    let _e108 = instances.member[(0u + _e44)].object_to_world[2u];
    let _e119 = ((((_e108.x * _e76.x) + (_e108.y * _e76.y)) + (_e108.z * _e76.z)) + (_e108.w * 1f));
    let _e121 = p.member.map_size;
    let _e123 = f32(_e121);
    let _e125 = p.member.projection.row_x;
    let _e139 = p.member.projection.row_y;
    let _e155 = p.member.projection.row_w;
    let _e166 = ((((_e155.x * _e93) + (_e155.y * _e106)) + (_e155.z * _e119)) + (_e155.w * 1f));
    if (1u == 0u) {
        phi_634_ = _e64.v0_;
    } else {
        if (1u == 1u) {
            phi_633_ = _e64.v1_;
        } else {
            phi_633_ = _e64.v2_;
        }
        let _e173 = phi_633_;
        phi_634_ = _e173;
    }
    let _e175 = phi_634_;
    let _e181 = instances.member[(0u + _e44)].object_to_world[0u];
    let _e192 = ((((_e181.x * _e175.x) + (_e181.y * _e175.y)) + (_e181.z * _e175.z)) + (_e181.w * 1f));
    let _e194 = instances.member[(0u + _e44)].object_to_world[1u];
    let _e205 = ((((_e194.x * _e175.x) + (_e194.y * _e175.y)) + (_e194.z * _e175.z)) + (_e194.w * 1f));
    let _e207 = instances.member[(0u + _e44)].object_to_world[2u];
    let _e218 = ((((_e207.x * _e175.x) + (_e207.y * _e175.y)) + (_e207.z * _e175.z)) + (_e207.w * 1f));
    let _e220 = p.member.map_size;
    let _e222 = f32(_e220);
    let _e224 = p.member.projection.row_x;
    let _e238 = p.member.projection.row_y;
    let _e254 = p.member.projection.row_w;
    let _e265 = ((((_e254.x * _e192) + (_e254.y * _e205)) + (_e254.z * _e218)) + (_e254.w * 1f));
    if (2u == 0u) {
        phi_737_ = _e64.v0_;
    } else {
        if (2u == 1u) {
            phi_736_ = _e64.v1_;
        } else {
            phi_736_ = _e64.v2_;
        }
        let _e272 = phi_736_;
        phi_737_ = _e272;
    }
    let _e274 = phi_737_;
    let _e280 = instances.member[(0u + _e44)].object_to_world[0u];
    let _e291 = ((((_e280.x * _e274.x) + (_e280.y * _e274.y)) + (_e280.z * _e274.z)) + (_e280.w * 1f));
    let _e293 = instances.member[(0u + _e44)].object_to_world[1u];
    let _e304 = ((((_e293.x * _e274.x) + (_e293.y * _e274.y)) + (_e293.z * _e274.z)) + (_e293.w * 1f));
    let _e306 = instances.member[(0u + _e44)].object_to_world[2u];
    let _e317 = ((((_e306.x * _e274.x) + (_e306.y * _e274.y)) + (_e306.z * _e274.z)) + (_e306.w * 1f));
    let _e319 = p.member.map_size;
    let _e321 = f32(_e319);
    let _e323 = p.member.projection.row_x;
    let _e337 = p.member.projection.row_y;
    let _e353 = p.member.projection.row_w;
    let _e364 = ((((_e353.x * _e291) + (_e353.y * _e304)) + (_e353.z * _e317)) + (_e353.w * 1f));
    let _e368 = (_e64.i0_ & 2147483647u);
    if (_e368 < _e54) {
    } else {
        return;
    }
    let _e374 = vertices.member[(0u + _e368)];
    if (_e64.i1_ < _e54) {
    } else {
        return;
    }
    let _e378 = vertices.member[(0u + _e64.i1_)];
    if (_e64.i2_ < _e54) {
    } else {
        return;
    }
    let _e382 = vertices.member[(0u + _e64.i2_)];
    let _e383 = array<abi_Vertex, 3>(_e374, _e378, _e382);
    if (_e383[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e391 = ((((((_e125.x * _e93) + (_e125.y * _e106)) + (_e125.z * _e119)) + (_e125.w * 1f)) * _e123) - (_e42.x * _e166));
    let _e392 = ((((((_e139.x * _e93) + (_e139.y * _e106)) + (_e139.z * _e119)) + (_e139.w * 1f)) * _e123) - (_e42.y * _e166));
    let _e395 = ((((((_e224.x * _e192) + (_e224.y * _e205)) + (_e224.z * _e218)) + (_e224.w * 1f)) * _e222) - (_e42.x * _e265));
    let _e396 = ((((((_e238.x * _e192) + (_e238.y * _e205)) + (_e238.z * _e218)) + (_e238.w * 1f)) * _e222) - (_e42.y * _e265));
    let _e399 = ((((((_e323.x * _e291) + (_e323.y * _e304)) + (_e323.z * _e317)) + (_e323.w * 1f)) * _e321) - (_e42.x * _e364));
    let _e400 = ((((((_e337.x * _e291) + (_e337.y * _e304)) + (_e337.z * _e317)) + (_e337.w * 1f)) * _e321) - (_e42.y * _e364));
    let _e403 = ((_e399 * _e396) - (_e400 * _e395));
    let _e406 = ((_e391 * _e400) - (_e392 * _e399));
    let _e409 = ((_e395 * _e392) - (_e396 * _e391));
    let _e411 = ((_e403 + _e406) + _e409);
    if (_e411 == 0f) {
        phi_894_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_894_ = vec3<f32>((_e403 / _e411), (_e406 / _e411), (_e409 / _e411));
    }
    let _e418 = phi_894_;
    let _e420 = materials.member[(0u + _e383[0].material)].flags;
    if ((_e420 & 1u) == 0u) {
        phi_1050_ = false;
    } else {
        let _e424 = materials.member[(0u + _e383[0].material)].cutoff;
        if (_e424 <= 0f) {
            phi_1049_ = true;
        } else {
            let _e428 = materials.member[(0u + _e383[0].material)].base_color[3u];
            let _e454 = (_e428 * ((((f32((_e383[0].color >> bitcast<u32>(24i))) * _e418.x) + (f32((_e383[1].color >> bitcast<u32>(24i))) * _e418.y)) + (f32((_e383[2].color >> bitcast<u32>(24i))) * _e418.z)) * (1f / 255f)));
            let _e456 = materials.member[(0u + _e383[0].material)].alpha_size;
            if (_e456 == 0u) {
                phi_1045_ = _e454;
            } else {
                let _e459 = materials.member[(0u + _e383[0].material)].alpha_offset;
                let _e461 = materials.member[(0u + _e383[0].material)].alpha_size;
                let _e463 = materials.member[(0u + _e383[0].material)].flags;
                local.offset = _e459;
                local.size = _e461;
                local.flags = _e463;
                let _e492 = _lt_shaders_texture_TextureView_quad((&local), (((_e383[0].u * _e418.x) + (_e383[1].u * _e418.y)) + (_e383[2].u * _e418.z)), (((_e383[0].v * _e418.x) + (_e383[1].v * _e418.y)) + (_e383[2].v * _e418.z)));
                let _e496 = (_e492.indices[0] >> bitcast<u32>(2i));
                if (_e496 < _e60) {
                } else {
                    return;
                }
                let _e500 = alpha_texels.member[(0u + _e496)];
                let _e516 = (_e492.indices[1] >> bitcast<u32>(2i));
                if (_e516 < _e60) {
                } else {
                    return;
                }
                let _e520 = alpha_texels.member[(0u + _e516)];
                let _e537 = (_e492.indices[2] >> bitcast<u32>(2i));
                if (_e537 < _e60) {
                } else {
                    return;
                }
                let _e541 = alpha_texels.member[(0u + _e537)];
                let _e558 = (_e492.indices[3] >> bitcast<u32>(2i));
                if (_e558 < _e60) {
                } else {
                    return;
                }
                let _e562 = alpha_texels.member[(0u + _e558)];
                phi_1045_ = (_e454 * (((((f32(((_e500 >> bitcast<u32>((((_e492.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e492.weights.x) + ((f32(((_e520 >> bitcast<u32>((((_e492.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e492.weights.y)) + ((f32(((_e541 >> bitcast<u32>((((_e492.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e492.weights.z)) + ((f32(((_e562 >> bitcast<u32>((((_e492.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e492.weights.w)));
            }
            let _e578 = phi_1045_;
            let _e580 = materials.member[(0u + _e383[0].material)].cutoff;
            phi_1049_ = (_e578 >= _e580);
        }
        let _e583 = phi_1049_;
        phi_1050_ = _e583;
    }
    let _e585 = phi_1050_;
    if _e585 {
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
