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
var<private> depth: f32 = 0f;

fn _lt_shaders_texture_TextureView_quad(param: ptr<function, texture_TextureView>, param_1: f32, param_2: f32) -> texture_TexelQuad {
    var phi_151_: f32;
    var phi_156_: f32;
    var phi_157_: bool;
    var phi_158_: f32;
    var phi_159_: bool;
    var phi_163_: f32;
    var phi_189_: f32;
    var phi_194_: f32;
    var phi_195_: bool;
    var phi_196_: f32;
    var phi_197_: bool;
    var phi_201_: f32;
    var phi_209_: f32;
    var phi_210_: f32;
    var phi_211_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_239_: u32;
    var phi_253_: u32;
    var phi_260_: u32;
    var phi_265_: u32;
    var phi_271_: u32;
    var phi_276_: u32;
    var phi_278_: texture_Axis;
    var phi_306_: f32;
    var phi_311_: f32;
    var phi_312_: bool;
    var phi_313_: f32;
    var phi_314_: bool;
    var phi_318_: f32;
    var phi_344_: f32;
    var phi_349_: f32;
    var phi_350_: bool;
    var phi_351_: f32;
    var phi_352_: bool;
    var phi_356_: f32;
    var phi_364_: f32;
    var phi_365_: f32;
    var phi_366_: f32;
    var phi_375_: f32;
    var phi_376_: f32;
    var phi_394_: u32;
    var phi_408_: u32;
    var phi_415_: u32;
    var phi_420_: u32;
    var phi_426_: u32;
    var phi_431_: u32;
    var phi_433_: texture_Axis;

    let _e44 = (*param).size;
    let _e45 = (_e44 & 65535u);
    let _e47 = (*param).size;
    let _e49 = (_e47 >> bitcast<u32>(16i));
    let _e51 = (*param).flags;
    let _e53 = ((_e51 & 4u) != 0u);
    let _e55 = (*param).flags;
    let _e58 = ((_e55 >> bitcast<u32>(4u)) & 3u);
    if (_e58 == 0u) {
        if (param_1 > -8388608f) {
            let _e71 = f32(select(0i, select(select(i32(param_1), i32(-2147483648), (param_1 < bitcast<f32>(3472883712u))), 2147483647i, (param_1 > bitcast<f32>(1325400063u))), (param_1 == param_1)));
            if (_e71 > param_1) {
                phi_151_ = 1f;
            } else {
                phi_151_ = 0f;
            }
            let _e74 = phi_151_;
            if (param_1 < 8388608f) {
                phi_156_ = (_e71 - _e74);
                phi_157_ = false;
            } else {
                phi_156_ = f32();
                phi_157_ = true;
            }
            let _e77 = phi_156_;
            let _e79 = phi_157_;
            phi_158_ = _e77;
            phi_159_ = _e79;
        } else {
            phi_158_ = f32();
            phi_159_ = true;
        }
        let _e81 = phi_158_;
        let _e83 = phi_159_;
        if _e83 {
            phi_163_ = param_1;
        } else {
            phi_163_ = _e81;
        }
        let _e85 = phi_163_;
        phi_211_ = (param_1 - _e85);
    } else {
        if (_e58 == 1u) {
            let _e88 = (param_1 * 0.5f);
            if (_e88 > -8388608f) {
                let _e100 = f32(select(0i, select(select(i32(_e88), i32(-2147483648), (_e88 < bitcast<f32>(3472883712u))), 2147483647i, (_e88 > bitcast<f32>(1325400063u))), (_e88 == _e88)));
                if (_e100 > _e88) {
                    phi_189_ = 1f;
                } else {
                    phi_189_ = 0f;
                }
                let _e103 = phi_189_;
                if (_e88 < 8388608f) {
                    phi_194_ = (_e100 - _e103);
                    phi_195_ = false;
                } else {
                    phi_194_ = f32();
                    phi_195_ = true;
                }
                let _e106 = phi_194_;
                let _e108 = phi_195_;
                phi_196_ = _e106;
                phi_197_ = _e108;
            } else {
                phi_196_ = f32();
                phi_197_ = true;
            }
            let _e110 = phi_196_;
            let _e112 = phi_197_;
            if _e112 {
                phi_201_ = _e88;
            } else {
                phi_201_ = _e110;
            }
            let _e114 = phi_201_;
            let _e116 = (param_1 - (2f * _e114));
            if (_e116 > 1f) {
                phi_209_ = (2f - _e116);
            } else {
                phi_209_ = _e116;
            }
            let _e120 = phi_209_;
            phi_210_ = _e120;
        } else {
            phi_210_ = param_1;
        }
        let _e122 = phi_210_;
        phi_211_ = _e122;
    }
    let _e124 = phi_211_;
    if (_e124 > 0f) {
        if (_e124 < 1f) {
            phi_220_ = _e124;
        } else {
            phi_220_ = 1f;
        }
        let _e128 = phi_220_;
        phi_221_ = _e128;
    } else {
        phi_221_ = 0f;
    }
    let _e130 = phi_221_;
    let _e131 = (_e45 - 1u);
    let _e133 = (_e130 * f32(_e45));
    if _e53 {
        let _e140 = select(select(u32(_e133), 0u, (_e133 < bitcast<f32>(0u))), 4294967295u, (_e133 > bitcast<f32>(1333788671u)));
        if (_e131 < _e140) {
            phi_239_ = _e131;
        } else {
            phi_239_ = _e140;
        }
        let _e143 = phi_239_;
        phi_278_ = texture_Axis(_e143, _e143, 0f);
    } else {
        let _e145 = (_e133 + 0.5f);
        let _e152 = select(select(u32(_e145), 0u, (_e145 < bitcast<f32>(0u))), 4294967295u, (_e145 > bitcast<f32>(1333788671u)));
        if (_e45 < _e152) {
            phi_253_ = _e45;
        } else {
            phi_253_ = _e152;
        }
        let _e155 = phi_253_;
        if (_e58 == 0u) {
            phi_260_ = _e131;
        } else {
            phi_260_ = 0u;
        }
        let _e160 = phi_260_;
        if (_e58 == 0u) {
            phi_265_ = 0u;
        } else {
            phi_265_ = _e131;
        }
        let _e163 = phi_265_;
        if (_e155 == 0u) {
            phi_271_ = _e160;
        } else {
            phi_271_ = (_e155 - 1u);
        }
        let _e167 = phi_271_;
        if (_e155 > _e131) {
            phi_276_ = _e163;
        } else {
            phi_276_ = _e155;
        }
        let _e170 = phi_276_;
        phi_278_ = texture_Axis(_e167, _e170, (_e145 - f32(_e155)));
    }
    let _e173 = phi_278_;
    let _e175 = (*param).flags;
    let _e178 = ((_e175 >> bitcast<u32>(6u)) & 3u);
    if (_e178 == 0u) {
        if (param_2 > -8388608f) {
            let _e191 = f32(select(0i, select(select(i32(param_2), i32(-2147483648), (param_2 < bitcast<f32>(3472883712u))), 2147483647i, (param_2 > bitcast<f32>(1325400063u))), (param_2 == param_2)));
            if (_e191 > param_2) {
                phi_306_ = 1f;
            } else {
                phi_306_ = 0f;
            }
            let _e194 = phi_306_;
            if (param_2 < 8388608f) {
                phi_311_ = (_e191 - _e194);
                phi_312_ = false;
            } else {
                phi_311_ = f32();
                phi_312_ = true;
            }
            let _e197 = phi_311_;
            let _e199 = phi_312_;
            phi_313_ = _e197;
            phi_314_ = _e199;
        } else {
            phi_313_ = f32();
            phi_314_ = true;
        }
        let _e201 = phi_313_;
        let _e203 = phi_314_;
        if _e203 {
            phi_318_ = param_2;
        } else {
            phi_318_ = _e201;
        }
        let _e205 = phi_318_;
        phi_366_ = (param_2 - _e205);
    } else {
        if (_e178 == 1u) {
            let _e208 = (param_2 * 0.5f);
            if (_e208 > -8388608f) {
                let _e220 = f32(select(0i, select(select(i32(_e208), i32(-2147483648), (_e208 < bitcast<f32>(3472883712u))), 2147483647i, (_e208 > bitcast<f32>(1325400063u))), (_e208 == _e208)));
                if (_e220 > _e208) {
                    phi_344_ = 1f;
                } else {
                    phi_344_ = 0f;
                }
                let _e223 = phi_344_;
                if (_e208 < 8388608f) {
                    phi_349_ = (_e220 - _e223);
                    phi_350_ = false;
                } else {
                    phi_349_ = f32();
                    phi_350_ = true;
                }
                let _e226 = phi_349_;
                let _e228 = phi_350_;
                phi_351_ = _e226;
                phi_352_ = _e228;
            } else {
                phi_351_ = f32();
                phi_352_ = true;
            }
            let _e230 = phi_351_;
            let _e232 = phi_352_;
            if _e232 {
                phi_356_ = _e208;
            } else {
                phi_356_ = _e230;
            }
            let _e234 = phi_356_;
            let _e236 = (param_2 - (2f * _e234));
            if (_e236 > 1f) {
                phi_364_ = (2f - _e236);
            } else {
                phi_364_ = _e236;
            }
            let _e240 = phi_364_;
            phi_365_ = _e240;
        } else {
            phi_365_ = param_2;
        }
        let _e242 = phi_365_;
        phi_366_ = _e242;
    }
    let _e244 = phi_366_;
    if (_e244 > 0f) {
        if (_e244 < 1f) {
            phi_375_ = _e244;
        } else {
            phi_375_ = 1f;
        }
        let _e248 = phi_375_;
        phi_376_ = _e248;
    } else {
        phi_376_ = 0f;
    }
    let _e250 = phi_376_;
    let _e251 = (_e49 - 1u);
    let _e253 = (_e250 * f32(_e49));
    if _e53 {
        let _e260 = select(select(u32(_e253), 0u, (_e253 < bitcast<f32>(0u))), 4294967295u, (_e253 > bitcast<f32>(1333788671u)));
        if (_e251 < _e260) {
            phi_394_ = _e251;
        } else {
            phi_394_ = _e260;
        }
        let _e263 = phi_394_;
        phi_433_ = texture_Axis(_e263, _e263, 0f);
    } else {
        let _e265 = (_e253 + 0.5f);
        let _e272 = select(select(u32(_e265), 0u, (_e265 < bitcast<f32>(0u))), 4294967295u, (_e265 > bitcast<f32>(1333788671u)));
        if (_e49 < _e272) {
            phi_408_ = _e49;
        } else {
            phi_408_ = _e272;
        }
        let _e275 = phi_408_;
        if (_e178 == 0u) {
            phi_415_ = _e251;
        } else {
            phi_415_ = 0u;
        }
        let _e280 = phi_415_;
        if (_e178 == 0u) {
            phi_420_ = 0u;
        } else {
            phi_420_ = _e251;
        }
        let _e283 = phi_420_;
        if (_e275 == 0u) {
            phi_426_ = _e280;
        } else {
            phi_426_ = (_e275 - 1u);
        }
        let _e287 = phi_426_;
        if (_e275 > _e251) {
            phi_431_ = _e283;
        } else {
            phi_431_ = _e275;
        }
        let _e290 = phi_431_;
        phi_433_ = texture_Axis(_e287, _e290, (_e265 - f32(_e275)));
    }
    let _e293 = phi_433_;
    let _e297 = (*param).offset;
    let _e304 = (*param).offset;
    let _e311 = (*param).offset;
    let _e318 = (*param).offset;
    return texture_TexelQuad(array<u32, 4>(((_e297 + (_e293.low * _e45)) + _e173.low), ((_e304 + (_e293.low * _e45)) + _e173.high), ((_e311 + (_e293.high * _e45)) + _e173.low), ((_e318 + (_e293.high * _e45)) + _e173.high)), vec4<f32>(((1f - _e173.fraction) * (1f - _e293.fraction)), (_e173.fraction * (1f - _e293.fraction)), ((1f - _e173.fraction) * _e293.fraction), (_e173.fraction * _e293.fraction)));
}

fn spirv_std_arch_kill() {
    discard;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(param_3: f32, param_4: f32) -> f32 {
    var phi_489_: f32;

    if (param_3 < param_4) {
        phi_489_ = param_3;
    } else {
        phi_489_ = param_4;
    }
    let _e44 = phi_489_;
    return _e44;
}

fn lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(param_5: f32, param_6: f32) -> f32 {
    var phi_497_: f32;

    if (param_5 > param_6) {
        phi_497_ = param_5;
    } else {
        phi_497_ = param_6;
    }
    let _e44 = phi_497_;
    return _e44;
}

fn function_() {
    var local: texture_TextureView;
    var phi_529_: vec3<f32>;
    var phi_530_: vec3<f32>;
    var phi_603_: vec3<f32>;
    var phi_604_: vec3<f32>;
    var phi_677_: vec3<f32>;
    var phi_678_: vec3<f32>;
    var phi_806_: vec3<f32>;
    var phi_957_: f32;
    var phi_961_: bool;
    var phi_962_: bool;
    var phi_1000_: vec3<f32>;
    var phi_1023_: f32;
    var phi_1024_: f32;

    let _e41 = at_1;
    let _e42 = triangle_1;
    let _e49 = arrayLength((&vertices.member));
    let _e55 = arrayLength((&alpha_texels.member));
    if (_e42 < arrayLength((&triangles.member))) {
    } else {
        return;
    }
    let _e59 = triangles.member[(0u + _e42)];
    if (0u == 0u) {
        phi_530_ = _e59.v0_;
    } else {
        if (0u == 1u) {
            phi_529_ = _e59.v1_;
        } else {
            phi_529_ = _e59.v2_;
        }
        let _e66 = phi_529_;
        phi_530_ = _e66;
    }
    let _e68 = phi_530_;
    let _e70 = p.member.map_size;
    let _e75 = f32(_e70);
    let _e77 = p.member.projection.row_x;
    let _e89 = (((((_e77.x * _e68.x) + (_e77.y * _e68.y)) + (_e77.z * _e68.z)) + (_e77.w * 1f)) * _e75);
    let _e91 = p.member.projection.row_y;
    let _e103 = (((((_e91.x * _e68.x) + (_e91.y * _e68.y)) + (_e91.z * _e68.z)) + (_e91.w * 1f)) * _e75);
    let _e105 = p.member.projection.row_z;
    let _e116 = ((((_e105.x * _e68.x) + (_e105.y * _e68.y)) + (_e105.z * _e68.z)) + (_e105.w * 1f));
    let _e118 = p.member.projection.row_w;
    let _e129 = ((((_e118.x * _e68.x) + (_e118.y * _e68.y)) + (_e118.z * _e68.z)) + (_e118.w * 1f));
    if (1u == 0u) {
        phi_604_ = _e59.v0_;
    } else {
        if (1u == 1u) {
            phi_603_ = _e59.v1_;
        } else {
            phi_603_ = _e59.v2_;
        }
        let _e136 = phi_603_;
        phi_604_ = _e136;
    }
    let _e138 = phi_604_;
    let _e140 = p.member.map_size;
    let _e145 = f32(_e140);
    let _e147 = p.member.projection.row_x;
    let _e159 = (((((_e147.x * _e138.x) + (_e147.y * _e138.y)) + (_e147.z * _e138.z)) + (_e147.w * 1f)) * _e145);
    let _e161 = p.member.projection.row_y;
    let _e173 = (((((_e161.x * _e138.x) + (_e161.y * _e138.y)) + (_e161.z * _e138.z)) + (_e161.w * 1f)) * _e145);
    let _e175 = p.member.projection.row_z;
    let _e186 = ((((_e175.x * _e138.x) + (_e175.y * _e138.y)) + (_e175.z * _e138.z)) + (_e175.w * 1f));
    let _e188 = p.member.projection.row_w;
    let _e199 = ((((_e188.x * _e138.x) + (_e188.y * _e138.y)) + (_e188.z * _e138.z)) + (_e188.w * 1f));
    if (2u == 0u) {
        phi_678_ = _e59.v0_;
    } else {
        if (2u == 1u) {
            phi_677_ = _e59.v1_;
        } else {
            phi_677_ = _e59.v2_;
        }
        let _e206 = phi_677_;
        phi_678_ = _e206;
    }
    let _e208 = phi_678_;
    let _e210 = p.member.map_size;
    let _e215 = f32(_e210);
    let _e217 = p.member.projection.row_x;
    let _e229 = (((((_e217.x * _e208.x) + (_e217.y * _e208.y)) + (_e217.z * _e208.z)) + (_e217.w * 1f)) * _e215);
    let _e231 = p.member.projection.row_y;
    let _e243 = (((((_e231.x * _e208.x) + (_e231.y * _e208.y)) + (_e231.z * _e208.z)) + (_e231.w * 1f)) * _e215);
    let _e245 = p.member.projection.row_z;
    let _e256 = ((((_e245.x * _e208.x) + (_e245.y * _e208.y)) + (_e245.z * _e208.z)) + (_e245.w * 1f));
    let _e258 = p.member.projection.row_w;
    let _e269 = ((((_e258.x * _e208.x) + (_e258.y * _e208.y)) + (_e258.z * _e208.z)) + (_e258.w * 1f));
    let _e273 = (_e59.i0_ & 2147483647u);
    if (_e273 < _e49) {
    } else {
        return;
    }
    let _e279 = vertices.member[(0u + _e273)];
    if (_e59.i1_ < _e49) {
    } else {
        return;
    }
    let _e283 = vertices.member[(0u + _e59.i1_)];
    if (_e59.i2_ < _e49) {
    } else {
        return;
    }
    let _e287 = vertices.member[(0u + _e59.i2_)];
    let _e288 = array<abi_Vertex, 3>(_e279, _e283, _e287);
    if (_e288[0].material < arrayLength((&materials.member))) {
    } else {
        return;
    }
    let _e296 = (_e89 - (_e41.x * _e129));
    let _e297 = (_e103 - (_e41.y * _e129));
    let _e300 = (_e159 - (_e41.x * _e199));
    let _e301 = (_e173 - (_e41.y * _e199));
    let _e304 = (_e229 - (_e41.x * _e269));
    let _e305 = (_e243 - (_e41.y * _e269));
    let _e308 = ((_e304 * _e301) - (_e305 * _e300));
    let _e311 = ((_e296 * _e305) - (_e297 * _e304));
    let _e314 = ((_e300 * _e297) - (_e301 * _e296));
    let _e316 = ((_e308 + _e311) + _e314);
    if (_e316 == 0f) {
        phi_806_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_806_ = vec3<f32>((_e308 / _e316), (_e311 / _e316), (_e314 / _e316));
    }
    let _e323 = phi_806_;
    let _e325 = materials.member[(0u + _e288[0].material)].flags;
    if ((_e325 & 1u) == 0u) {
        phi_962_ = false;
    } else {
        let _e329 = materials.member[(0u + _e288[0].material)].cutoff;
        if (_e329 <= 0f) {
            phi_961_ = true;
        } else {
            let _e333 = materials.member[(0u + _e288[0].material)].base_color[3u];
            let _e359 = (_e333 * ((((f32((_e288[0].color >> bitcast<u32>(24i))) * _e323.x) + (f32((_e288[1].color >> bitcast<u32>(24i))) * _e323.y)) + (f32((_e288[2].color >> bitcast<u32>(24i))) * _e323.z)) * (1f / 255f)));
            let _e361 = materials.member[(0u + _e288[0].material)].alpha_size;
            if (_e361 == 0u) {
                phi_957_ = _e359;
            } else {
                let _e364 = materials.member[(0u + _e288[0].material)].alpha_offset;
                let _e366 = materials.member[(0u + _e288[0].material)].alpha_size;
                let _e368 = materials.member[(0u + _e288[0].material)].flags;
                local.offset = _e364;
                local.size = _e366;
                local.flags = _e368;
                let _e397 = _lt_shaders_texture_TextureView_quad((&local), (((_e288[0].u * _e323.x) + (_e288[1].u * _e323.y)) + (_e288[2].u * _e323.z)), (((_e288[0].v * _e323.x) + (_e288[1].v * _e323.y)) + (_e288[2].v * _e323.z)));
                let _e401 = (_e397.indices[0] >> bitcast<u32>(2i));
                if (_e401 < _e55) {
                } else {
                    return;
                }
                let _e405 = alpha_texels.member[(0u + _e401)];
                let _e421 = (_e397.indices[1] >> bitcast<u32>(2i));
                if (_e421 < _e55) {
                } else {
                    return;
                }
                let _e425 = alpha_texels.member[(0u + _e421)];
                let _e442 = (_e397.indices[2] >> bitcast<u32>(2i));
                if (_e442 < _e55) {
                } else {
                    return;
                }
                let _e446 = alpha_texels.member[(0u + _e442)];
                let _e463 = (_e397.indices[3] >> bitcast<u32>(2i));
                if (_e463 < _e55) {
                } else {
                    return;
                }
                let _e467 = alpha_texels.member[(0u + _e463)];
                phi_957_ = (_e359 * (((((f32(((_e405 >> bitcast<u32>((((_e397.indices[0] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e397.weights.x) + ((f32(((_e425 >> bitcast<u32>((((_e397.indices[1] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e397.weights.y)) + ((f32(((_e446 >> bitcast<u32>((((_e397.indices[2] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e397.weights.z)) + ((f32(((_e467 >> bitcast<u32>((((_e397.indices[3] & 3u) * 8u) & 31u))) & 255u)) * (1f / 255f)) * _e397.weights.w)));
            }
            let _e483 = phi_957_;
            let _e485 = materials.member[(0u + _e288[0].material)].cutoff;
            phi_961_ = (_e483 >= _e485);
        }
        let _e488 = phi_961_;
        phi_962_ = _e488;
    }
    let _e490 = phi_962_;
    if _e490 {
    } else {
        spirv_std_arch_kill();
    }
    let _e495 = (_e89 - (_e41.x * _e129));
    let _e496 = (_e103 - (_e41.y * _e129));
    let _e499 = (_e159 - (_e41.x * _e199));
    let _e500 = (_e173 - (_e41.y * _e199));
    let _e503 = (_e229 - (_e41.x * _e269));
    let _e504 = (_e243 - (_e41.y * _e269));
    let _e507 = ((_e503 * _e500) - (_e504 * _e499));
    let _e510 = ((_e495 * _e504) - (_e496 * _e503));
    let _e513 = ((_e499 * _e496) - (_e500 * _e495));
    let _e515 = ((_e507 + _e510) + _e513);
    if (_e515 == 0f) {
        phi_1000_ = vec3<f32>(1f, 0f, 0f);
    } else {
        phi_1000_ = vec3<f32>((_e507 / _e515), (_e510 / _e515), (_e513 / _e515));
    }
    let _e522 = phi_1000_;
    let _e530 = (((_e522.x * _e116) + (_e522.y * _e186)) + (_e522.z * _e256));
    let _e531 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e116, _e186);
    let _e532 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e531, _e256);
    let _e533 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e532, 0f);
    let _e534 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e116, _e186);
    let _e535 = lt_shaders_depth_depth_at_u007b_closure_u0023_1_u007d(_e534, _e256);
    let _e536 = lt_shaders_depth_depth_at_u007b_closure_u0023_0_u007d(_e535, 1f);
    if (_e530 > _e533) {
        if (_e530 < _e536) {
            phi_1023_ = _e530;
        } else {
            phi_1023_ = _e536;
        }
        let _e540 = phi_1023_;
        phi_1024_ = _e540;
    } else {
        phi_1024_ = _e533;
    }
    let _e542 = phi_1024_;
    depth = _e542;
    return;
}

@fragment 
fn entry_depth_depth_perspective_alpha_fs(@builtin(position) at: vec4<f32>, @location(0) @interpolate(flat) triangle: u32) -> @builtin(frag_depth) f32 {
    at_1 = at;
    triangle_1 = triangle;
    function_();
    let _e5 = depth;
    return _e5;
}
