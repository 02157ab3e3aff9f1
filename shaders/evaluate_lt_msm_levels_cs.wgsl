struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_15 {
    member: array<abi_Sample>,
}

struct type_19 {
    member: array<f32>,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: abi_LightParams,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    pad0_: u32,
    pad1_: u32,
}

struct type_31 {
    member: abi_ShadowParams,
}

struct type_35 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_15;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_31;
@group(0) @binding(2) 
var<storage> map: type_19;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_19;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_152_: lt_bvh_traverse_Tree;
    var phi_153_: bool;
    var phi_154_: lt_bvh_traverse_Tree;
    var phi_155_: bool;
    var phi_160_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_152_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_153_ = false;
        } else {
            phi_152_ = lt_bvh_traverse_Tree();
            phi_153_ = true;
        }
        let _e58 = phi_152_;
        let _e60 = phi_153_;
        phi_154_ = _e58;
        phi_155_ = _e60;
    } else {
        phi_154_ = lt_bvh_traverse_Tree();
        phi_155_ = true;
    }
    let _e62 = phi_154_;
    let _e64 = phi_155_;
    if _e64 {
        phi_160_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_160_ = _e62;
    }
    let _e69 = phi_160_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_187_: f32;
    var phi_188_: f32;
    var phi_189_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_260_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_297_: bool;
    var phi_298_: bool;
    var phi_299_: bool;
    var phi_300_: bool;
    var phi_301_: bool;
    var phi_302_: bool;
    var phi_306_: bool;
    var phi_617_: f32;
    var phi_618_: f32;
    var phi_619_: f32;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_657_: f32;
    var phi_674_: f32;
    var phi_675_: f32;
    var phi_676_: f32;
    var phi_699_: f32;
    var phi_700_: f32;
    var phi_701_: f32;
    var phi_712_: f32;
    var phi_727_: f32;
    var phi_729_: lt_bvh_slab_Span;
    var phi_787_: f32;
    var phi_788_: f32;
    var phi_789_: f32;
    var phi_790_: f32;
    var phi_791_: f32;
    var phi_792_: bool;
    var phi_796_: f32;
    var phi_811_: f32;
    var phi_812_: f32;
    var phi_813_: f32;
    var phi_814_: f32;
    var phi_815_: f32;
    var phi_816_: f32;
    var phi_817_: f32;
    var phi_818_: bool;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_821_: bool;
    var phi_825_: f32;

    let _e49 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_189_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_188_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_187_ = 1f;
            } else {
                phi_187_ = param_7;
            }
            let _e56 = phi_187_;
            phi_188_ = _e56;
        }
        let _e58 = phi_188_;
        phi_189_ = _e58;
    }
    let _e60 = phi_189_;
    let _e61 = (_e60 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_208_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_5.x;
            }
            let _e69 = phi_206_;
            phi_207_ = _e69;
        }
        let _e71 = phi_207_;
        phi_208_ = _e71;
    }
    let _e73 = phi_208_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_226_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_5.y;
            }
            let _e81 = phi_224_;
            phi_225_ = _e81;
        }
        let _e83 = phi_225_;
        phi_226_ = _e83;
    }
    let _e85 = phi_226_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_244_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_243_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = param_5.z;
            }
            let _e93 = phi_242_;
            phi_243_ = _e93;
        }
        let _e95 = phi_243_;
        phi_244_ = _e95;
    }
    let _e97 = phi_244_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_262_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_261_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_260_ = 1f;
            } else {
                phi_260_ = param_5.w;
            }
            let _e105 = phi_260_;
            phi_261_ = _e105;
        }
        let _e107 = phi_261_;
        phi_262_ = _e107;
    }
    let _e109 = phi_262_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    let _e124 = ((((_e110 * param_6.x) + (_e111 * param_6.y)) + (_e112 * param_6.z)) + (_e113 * param_6.w));
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_819_ = _e124;
        phi_820_ = f32();
        phi_821_ = true;
    } else {
        if (_e110 >= 0f) {
            if (_e111 >= 0f) {
                if (_e112 >= 0f) {
                    phi_297_ = (_e113 >= 0f);
                    phi_298_ = false;
                } else {
                    phi_297_ = bool();
                    phi_298_ = true;
                }
                let _e133 = phi_297_;
                let _e135 = phi_298_;
                phi_299_ = _e133;
                phi_300_ = _e135;
            } else {
                phi_299_ = bool();
                phi_300_ = true;
            }
            let _e137 = phi_299_;
            let _e139 = phi_300_;
            phi_301_ = _e137;
            phi_302_ = _e139;
        } else {
            phi_301_ = bool();
            phi_302_ = true;
        }
        let _e141 = phi_301_;
        let _e143 = phi_302_;
        if _e143 {
            phi_306_ = false;
        } else {
            phi_306_ = _e141;
        }
        let _e145 = phi_306_;
        if _e145 {
            phi_816_ = 1f;
            phi_817_ = f32();
            phi_818_ = true;
        } else {
            let _e146 = (0.5f * _e49);
            let _e147 = (1f - _e49);
            let _e149 = (param_6.x * _e147);
            let _e151 = (param_6.y * _e147);
            let _e153 = (param_6.z * _e147);
            let _e155 = (param_6.w * _e147);
            let _e156 = -(_e61);
            let _e157 = (1f - _e61);
            let _e159 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e73);
            let _e161 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e85);
            let _e163 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e97);
            let _e165 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e109);
            let _e166 = (_e110 - _e111);
            let _e167 = (_e111 - _e112);
            let _e168 = (_e112 - _e113);
            let _e169 = (_e113 - _e110);
            let _e170 = (_e166 * _e166);
            let _e171 = (_e167 * _e167);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e110 - _e112);
            let _e175 = (_e111 - _e113);
            let _e176 = (_e112 - _e110);
            let _e177 = (_e113 - _e111);
            let _e178 = (_e174 * _e174);
            let _e179 = (_e175 * _e175);
            let _e180 = (_e176 * _e176);
            let _e181 = (_e177 * _e177);
            let _e186 = ((_e149 * _e151) * _e170);
            let _e187 = ((_e151 * _e153) * _e171);
            let _e188 = ((_e153 * _e155) * _e172);
            let _e189 = ((_e155 * _e149) * _e173);
            let _e198 = (((0.5f * _e149) * _e153) * _e178);
            let _e199 = (((0.5f * _e151) * _e155) * _e179);
            let _e200 = (((0.5f * _e153) * _e149) * _e180);
            let _e201 = (((0.5f * _e155) * _e151) * _e181);
            let _e202 = (_e110 * _e111);
            let _e203 = (_e111 * _e112);
            let _e204 = (_e112 * _e113);
            let _e205 = (_e113 * _e110);
            let _e206 = (_e110 * _e112);
            let _e207 = (_e111 * _e113);
            let _e208 = (_e112 * _e110);
            let _e209 = (_e113 * _e111);
            let _e210 = (_e186 * _e202);
            let _e211 = (_e187 * _e203);
            let _e212 = (_e188 * _e204);
            let _e213 = (_e189 * _e205);
            let _e214 = (_e198 * _e206);
            let _e215 = (_e199 * _e207);
            let _e216 = (_e200 * _e208);
            let _e217 = (_e201 * _e209);
            let _e218 = (_e73 * _e73);
            let _e219 = (_e85 * _e85);
            let _e220 = (_e97 * _e97);
            let _e221 = (_e109 * _e109);
            let _e222 = (_e159 * _e159);
            let _e223 = (_e161 * _e161);
            let _e224 = (_e163 * _e163);
            let _e225 = (_e165 * _e165);
            let _e226 = (_e146 * _e149);
            let _e227 = (_e146 * _e151);
            let _e228 = (_e146 * _e153);
            let _e229 = (_e146 * _e155);
            let _e238 = (((_e226 * _e110) * _e218) * _e156);
            let _e239 = (((_e227 * _e111) * _e219) * _e156);
            let _e240 = (((_e228 * _e112) * _e220) * _e156);
            let _e241 = (((_e229 * _e113) * _e221) * _e156);
            let _e250 = (((_e226 * _e110) * _e222) * _e157);
            let _e251 = (((_e227 * _e111) * _e223) * _e157);
            let _e252 = (((_e228 * _e112) * _e224) * _e157);
            let _e253 = (((_e229 * _e113) * _e225) * _e157);
            let _e421 = (((((((_e186 * _e153) * _e171) * _e178) + (_e146 * (((_e186 * ((_e218 * _e219) + (_e222 * _e223))) + (_e198 * ((_e218 * _e220) + (_e222 * _e224)))) + ((_e226 * _e218) * _e222)))) + ((((_e187 * _e155) * _e172) * _e179) + (_e146 * (((_e187 * ((_e219 * _e220) + (_e223 * _e224))) + (_e199 * ((_e219 * _e221) + (_e223 * _e225)))) + ((_e227 * _e219) * _e223))))) + ((((_e188 * _e149) * _e173) * _e180) + (_e146 * (((_e188 * ((_e220 * _e221) + (_e224 * _e225))) + (_e200 * ((_e220 * _e218) + (_e224 * _e222)))) + ((_e228 * _e220) * _e224))))) + ((((_e189 * _e151) * _e170) * _e181) + (_e146 * (((_e189 * ((_e221 * _e218) + (_e225 * _e222))) + (_e201 * ((_e221 * _e219) + (_e225 * _e223)))) + ((_e229 * _e221) * _e225)))));
            let _e424 = (((_e146 * _e146) * _e156) * _e157);
            let _e427 = (((((((_e210 * _e202) + (_e214 * _e206)) + (_e110 * ((_e238 * _e156) + (_e250 * _e157)))) + (((_e211 * _e203) + (_e215 * _e207)) + (_e111 * ((_e239 * _e156) + (_e251 * _e157))))) + (((_e212 * _e204) + (_e216 * _e208)) + (_e112 * ((_e240 * _e156) + (_e252 * _e157))))) + (((_e213 * _e205) + (_e217 * _e209)) + (_e113 * ((_e241 * _e156) + (_e253 * _e157))))) + ((_e424 * _e156) * _e157));
            let _e433 = (_e427 < 0.0000000000000000000000000000000001f);
            if _e433 {
                if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
                    phi_619_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_618_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_617_ = 0f;
                        } else {
                            phi_617_ = 1f;
                        }
                        let _e442 = phi_617_;
                        phi_618_ = _e442;
                    }
                    let _e444 = phi_618_;
                    phi_619_ = _e444;
                }
                let _e446 = phi_619_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_638_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_637_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_636_ = 0f;
                        } else {
                            phi_636_ = 1f;
                        }
                        let _e455 = phi_636_;
                        phi_637_ = _e455;
                    }
                    let _e457 = phi_637_;
                    phi_638_ = _e457;
                }
                let _e459 = phi_638_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_657_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_656_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_655_ = 0f;
                        } else {
                            phi_655_ = 1f;
                        }
                        let _e468 = phi_655_;
                        phi_656_ = _e468;
                    }
                    let _e470 = phi_656_;
                    phi_657_ = _e470;
                }
                let _e472 = phi_657_;
                if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                    phi_676_ = _e113;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_675_ = 0f;
                    } else {
                        if (_e113 < 0f) {
                            phi_674_ = 0f;
                        } else {
                            phi_674_ = 1f;
                        }
                        let _e481 = phi_674_;
                        phi_675_ = _e481;
                    }
                    let _e483 = phi_675_;
                    phi_676_ = _e483;
                }
                let _e485 = phi_676_;
                let _e493 = (((((_e446 * _e149) + (_e459 * _e151)) + (_e472 * _e153)) + (_e485 * _e155)) + _e146);
                if ((bitcast<u32>(_e493) & 2147483647u) > 2139095040u) {
                    phi_701_ = _e493;
                } else {
                    if (_e493 < 0f) {
                        phi_700_ = 0f;
                    } else {
                        if (_e493 > 1f) {
                            phi_699_ = 1f;
                        } else {
                            phi_699_ = _e493;
                        }
                        let _e500 = phi_699_;
                        phi_700_ = _e500;
                    }
                    let _e502 = phi_700_;
                    phi_701_ = _e502;
                }
                let _e504 = phi_701_;
                phi_814_ = _e504;
                phi_815_ = f32();
            } else {
                let _e506 = ((0.5f * -(((((((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e112))) + (_e238 * (_e110 + _e156))) + (_e250 * (_e110 + _e157))) + ((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e113))) + (_e239 * (_e111 + _e156))) + (_e251 * (_e111 + _e157)))) + ((((_e212 * (_e112 + _e113)) + (_e216 * (_e112 + _e110))) + (_e240 * (_e112 + _e156))) + (_e252 * (_e112 + _e157)))) + ((((_e213 * (_e113 + _e110)) + (_e217 * (_e113 + _e111))) + (_e241 * (_e113 + _e156))) + (_e253 * (_e113 + _e157)))) + (_e424 * (_e156 + _e157))))) / _e427);
                let _e507 = ((((((((_e210 + _e214) + _e238) + _e250) + (((_e211 + _e215) + _e239) + _e251)) + (((_e212 + _e216) + _e240) + _e252)) + (((_e213 + _e217) + _e241) + _e253)) + _e424) / _e427);
                let _e509 = ((_e506 * _e506) - _e507);
                if (_e509 > 0f) {
                    phi_712_ = sqrt(_e509);
                } else {
                    phi_712_ = 0f;
                }
                let _e513 = phi_712_;
                if (_e506 > 0f) {
                    let _e516 = (-(_e506) - _e513);
                    phi_729_ = lt_bvh_slab_Span(_e516, (_e507 / _e516));
                } else {
                    let _e519 = (_e513 - _e506);
                    if (_e519 > 0f) {
                        phi_727_ = (_e507 / _e519);
                    } else {
                        phi_727_ = 0f;
                    }
                    let _e523 = phi_727_;
                    phi_729_ = lt_bvh_slab_Span(_e523, _e519);
                }
                let _e526 = phi_729_;
                if (_e526.near >= 0f) {
                    phi_790_ = 1f;
                    phi_791_ = f32();
                    phi_792_ = true;
                } else {
                    let _e530 = (_e526.far <= 0f);
                    if _e530 {
                        phi_788_ = (_e421 / _e427);
                        phi_789_ = f32();
                    } else {
                        let _e541 = (((((_e149 * _e110) + (_e151 * _e111)) + (_e153 * _e112)) + (_e155 * _e113)) + (_e146 * (_e156 + _e157)));
                        let _e557 = (((((_e149 * (_e110 * _e110)) + (_e151 * (_e111 * _e111))) + (_e153 * (_e112 * _e112))) + (_e155 * (_e113 * _e113))) + (_e146 * ((_e156 * _e156) + (_e157 * _e157))));
                        if (-(_e526.near) <= _e526.far) {
                            phi_787_ = (1f - (((_e526.near * _e526.near) * ((_e526.far * _e557) - _e541)) / (_e526.far - _e526.near)));
                        } else {
                            phi_787_ = ((_e421 / _e427) + (((_e526.far * _e526.far) * (_e541 - (_e526.near * _e557))) / (_e526.far - _e526.near)));
                        }
                        let _e576 = phi_787_;
                        phi_788_ = f32();
                        phi_789_ = _e576;
                    }
                    let _e578 = phi_788_;
                    let _e580 = phi_789_;
                    phi_790_ = _e578;
                    phi_791_ = _e580;
                    phi_792_ = _e530;
                }
                let _e582 = phi_790_;
                let _e584 = phi_791_;
                let _e586 = phi_792_;
                if _e586 {
                    phi_796_ = _e582;
                } else {
                    phi_796_ = _e584;
                }
                let _e588 = phi_796_;
                if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                    phi_813_ = _e588;
                } else {
                    if (_e588 < 0f) {
                        phi_812_ = 0f;
                    } else {
                        if (_e588 > 1f) {
                            phi_811_ = 1f;
                        } else {
                            phi_811_ = _e588;
                        }
                        let _e595 = phi_811_;
                        phi_812_ = _e595;
                    }
                    let _e597 = phi_812_;
                    phi_813_ = _e597;
                }
                let _e599 = phi_813_;
                phi_814_ = f32();
                phi_815_ = _e599;
            }
            let _e601 = phi_814_;
            let _e603 = phi_815_;
            phi_816_ = _e601;
            phi_817_ = _e603;
            phi_818_ = _e433;
        }
        let _e605 = phi_816_;
        let _e607 = phi_817_;
        let _e609 = phi_818_;
        phi_819_ = _e605;
        phi_820_ = _e607;
        phi_821_ = _e609;
    }
    let _e611 = phi_819_;
    let _e613 = phi_820_;
    let _e615 = phi_821_;
    if _e615 {
        phi_825_ = _e611;
    } else {
        phi_825_ = _e613;
    }
    let _e617 = phi_825_;
    return _e617;
}

fn function_() {
    var local: f32;
    var phi_885_: bool;
    var phi_886_: bool;
    var phi_887_: bool;
    var phi_888_: bool;
    var phi_892_: bool;
    var phi_962_: bool;
    var phi_963_: bool;
    var phi_974_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_975_: bool;
    var phi_976_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_977_: bool;
    var phi_984_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_988_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1008_: lt_math_LightPoint;
    var phi_1011_: u32;
    var phi_1013_: lt_math_LevelPoint;
    var phi_1099_: bool;
    var phi_1108_: bool;
    var phi_1117_: bool;
    var phi_1118_: bool;
    var phi_1119_: bool;
    var phi_1120_: bool;
    var phi_1121_: bool;
    var phi_1122_: bool;
    var phi_1123_: bool;
    var phi_1127_: bool;
    var phi_1154_: bool;
    var phi_1155_: bool;
    var phi_1156_: bool;
    var phi_1157_: bool;
    var phi_1158_: bool;
    var phi_1159_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1165_: bool;
    var phi_1174_: lt_math_LightPoint;
    var phi_1175_: u32;
    var phi_1176_: lt_math_LevelPoint;
    var phi_1177_: bool;
    var phi_1009_: lt_math_LightPoint;
    var phi_1012_: u32;
    var phi_1014_: lt_math_LevelPoint;
    var phi_1178_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1218_: bool;
    var phi_1219_: bool;
    var phi_1220_: bool;
    var phi_1221_: bool;
    var phi_1225_: bool;
    var phi_1307_: f32;
    var phi_1425_: f32;
    var phi_1426_: f32;
    var phi_1429_: f32;
    var phi_1458_: f32;
    var phi_1463_: f32;
    var phi_1464_: bool;
    var phi_1465_: f32;
    var phi_1466_: bool;
    var phi_1470_: f32;
    var phi_1490_: f32;
    var phi_1495_: f32;
    var phi_1496_: bool;
    var phi_1497_: f32;
    var phi_1498_: bool;
    var phi_1502_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1551_: i32;
    var phi_1556_: i32;
    var phi_1561_: i32;
    var phi_1566_: i32;
    var phi_1575_: i32;
    var phi_1580_: i32;
    var phi_1585_: i32;
    var phi_1590_: i32;
    var phi_1643_: bool;
    var phi_1651_: bool;
    var phi_1663_: bool;
    var phi_1664_: bool;
    var phi_1668_: f32;
    var phi_1674_: f32;
    var phi_1676_: evaluate_Verdict;
    var phi_1686_: u32;
    var phi_1695_: f32;
    var phi_1697_: evaluate_Verdict;
    var phi_1698_: bool;
    var phi_1699_: evaluate_Verdict;
    var phi_1700_: bool;
    var phi_1705_: evaluate_Verdict;
    var phi_1710_: evaluate_Verdict;
    var phi_1711_: evaluate_Verdict;

    let _e46 = id_1;
    let _e53 = arrayLength((&map.member));
    let _e59 = arrayLength((&levels.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e46, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e71 = p.member.level_count;
        if (_e65.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e78 = samples.member[(0u + _e65.first_primitive)].normal[0u];
        let _e80 = global[0u];
        if (_e78 == _e80) {
            let _e83 = samples.member[(0u + _e65.first_primitive)].normal[1u];
            let _e85 = global[1u];
            if (_e83 == _e85) {
                let _e88 = samples.member[(0u + _e65.first_primitive)].normal[2u];
                let _e90 = global[2u];
                phi_885_ = (_e88 == _e90);
                phi_886_ = false;
            } else {
                phi_885_ = bool();
                phi_886_ = true;
            }
            let _e93 = phi_885_;
            let _e95 = phi_886_;
            phi_887_ = _e93;
            phi_888_ = _e95;
        } else {
            phi_887_ = bool();
            phi_888_ = true;
        }
        let _e97 = phi_887_;
        let _e99 = phi_888_;
        if _e99 {
            phi_892_ = false;
        } else {
            phi_892_ = _e97;
        }
        let _e101 = phi_892_;
        if !(_e101) {
            let _e104 = samples.member[(0u + _e65.first_primitive)].position;
            let _e106 = p.member.light.place;
            let _e112 = p.member.light.place[3u];
            let _e119 = (_e106.x - (_e104.x * _e112));
            let _e120 = (_e106.y - (_e104.y * _e112));
            let _e121 = (_e106.z - (_e104.z * _e112));
            let _e123 = samples.member[(0u + _e65.first_primitive)].normal;
            if ((((_e123.x * _e119) + (_e123.y * _e120)) + (_e123.z * _e121)) > 0f) {
                let _e137 = (((_e119 * _e119) + (_e120 * _e120)) + (_e121 * _e121));
                let _e139 = p.member.light.axis;
                let _e151 = p.member.light.place[3u];
                if (_e151 == 0f) {
                    phi_963_ = true;
                } else {
                    let _e154 = p.member.light.range_squared;
                    if (_e137 <= _e154) {
                        let _e157 = p.member.light.cos_outer;
                        phi_962_ = (-((((_e119 * _e139.x) + (_e120 * _e139.y)) + (_e121 * _e139.z))) >= (_e157 * sqrt(_e137)));
                    } else {
                        phi_962_ = false;
                    }
                    let _e162 = phi_962_;
                    phi_963_ = _e162;
                }
                let _e164 = phi_963_;
                if _e164 {
                    let _e166 = samples.member[(0u + _e65.first_primitive)].flags;
                    let _e174 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e174.unnamed.visibility, false), _e174.unnamed_1);
                    phi_974_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e180.unnamed, ((_e166 & 1u) == 0u));
                    phi_975_ = false;
                } else {
                    phi_974_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_975_ = true;
                }
                let _e185 = phi_974_;
                let _e187 = phi_975_;
                phi_976_ = _e185;
                phi_977_ = _e187;
            } else {
                phi_976_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_977_ = true;
            }
            let _e189 = phi_976_;
            let _e191 = phi_977_;
            if _e191 {
                let _e197 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e197.unnamed.visibility, false), _e197.unnamed_1);
                phi_984_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e203.unnamed, true);
            } else {
                phi_984_ = _e189;
            }
            let _e208 = phi_984_;
            phi_988_ = _e208;
        } else {
            let _e214 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e214.unnamed.visibility, false), _e214.unnamed_1);
            phi_988_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e220.unnamed, true);
        }
        let _e225 = phi_988_;
        if _e225.unnamed_1 {
            phi_1711_ = evaluate_Verdict(_e225.unnamed.visibility, _e225.unnamed.is_doubted);
        } else {
            let _e233 = samples.member[(0u + _e65.first_primitive)].position;
            let _e235 = p.member.map_size;
            let _e237 = (0.5f / f32(_e235));
            let _e244 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e251 = lt_math_LightPoint(vec2<f32>(_e244.uv.x, 0f), _e244.depth, _e244.is_inside);
            let _e255 = lt_math_LightPoint(_e251.uv, 0f, _e251.is_inside);
            phi_1008_ = lt_math_LightPoint();
            phi_1011_ = 0u;
            phi_1013_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e255.uv, _e255.depth, false));
            loop {
                let _e262 = phi_1008_;
                let _e264 = phi_1011_;
                let _e266 = phi_1013_;
                local_1 = _e266;
                local_2 = _e266;
                local_3 = _e266;
                if (_e264 < _e71) {
                    if _e266.point.is_inside {
                        phi_1174_ = lt_math_LightPoint();
                        phi_1175_ = u32();
                        phi_1176_ = lt_math_LevelPoint();
                        phi_1177_ = false;
                    } else {
                        if (_e264 < _e59) {
                        } else {
                            return;
                        }
                        let _e277 = levels.member[(0u + _e264)].row_w;
                        let _e288 = ((((_e277.x * _e233.x) + (_e277.y * _e233.y)) + (_e277.z * _e233.z)) + (_e277.w * 1f));
                        let _e290 = levels.member[(0u + _e264)].row_x;
                        let _e302 = (((((_e290.x * _e233.x) + (_e290.y * _e233.y)) + (_e290.z * _e233.z)) + (_e290.w * 1f)) / _e288);
                        let _e304 = levels.member[(0u + _e264)].row_y;
                        let _e316 = (((((_e304.x * _e233.x) + (_e304.y * _e233.y)) + (_e304.z * _e233.z)) + (_e304.w * 1f)) / _e288);
                        let _e318 = levels.member[(0u + _e264)].row_z;
                        let _e329 = ((((_e318.x * _e233.x) + (_e318.y * _e233.y)) + (_e318.z * _e233.z)) + (_e318.w * 1f));
                        if (_e288 > 0f) {
                            if (_e302 >= 0f) {
                                phi_1099_ = (_e302 <= 1f);
                            } else {
                                phi_1099_ = false;
                            }
                            let _e334 = phi_1099_;
                            if _e334 {
                                if (_e316 >= 0f) {
                                    phi_1108_ = (_e316 <= 1f);
                                } else {
                                    phi_1108_ = false;
                                }
                                let _e338 = phi_1108_;
                                if _e338 {
                                    if (_e329 >= 0f) {
                                        phi_1117_ = (_e329 <= 1f);
                                    } else {
                                        phi_1117_ = false;
                                    }
                                    let _e342 = phi_1117_;
                                    phi_1118_ = _e342;
                                    phi_1119_ = false;
                                } else {
                                    phi_1118_ = bool();
                                    phi_1119_ = true;
                                }
                                let _e344 = phi_1118_;
                                let _e346 = phi_1119_;
                                phi_1120_ = _e344;
                                phi_1121_ = _e346;
                            } else {
                                phi_1120_ = bool();
                                phi_1121_ = true;
                            }
                            let _e348 = phi_1120_;
                            let _e350 = phi_1121_;
                            phi_1122_ = _e348;
                            phi_1123_ = _e350;
                        } else {
                            phi_1122_ = bool();
                            phi_1123_ = true;
                        }
                        let _e352 = phi_1122_;
                        let _e354 = phi_1123_;
                        if _e354 {
                            phi_1127_ = false;
                        } else {
                            phi_1127_ = _e352;
                        }
                        let _e356 = phi_1127_;
                        if _e356 {
                            if (_e302 >= _e237) {
                                if (_e302 <= (1f - _e237)) {
                                    if (_e316 >= _e237) {
                                        phi_1154_ = (_e316 <= (1f - _e237));
                                        phi_1155_ = false;
                                    } else {
                                        phi_1154_ = bool();
                                        phi_1155_ = true;
                                    }
                                    let _e364 = phi_1154_;
                                    let _e366 = phi_1155_;
                                    phi_1156_ = _e364;
                                    phi_1157_ = _e366;
                                } else {
                                    phi_1156_ = bool();
                                    phi_1157_ = true;
                                }
                                let _e368 = phi_1156_;
                                let _e370 = phi_1157_;
                                phi_1158_ = _e368;
                                phi_1159_ = _e370;
                            } else {
                                phi_1158_ = bool();
                                phi_1159_ = true;
                            }
                            let _e372 = phi_1158_;
                            let _e374 = phi_1159_;
                            phi_1160_ = _e372;
                            phi_1161_ = _e374;
                        } else {
                            phi_1160_ = bool();
                            phi_1161_ = true;
                        }
                        let _e376 = phi_1160_;
                        let _e378 = phi_1161_;
                        if _e378 {
                            phi_1165_ = false;
                        } else {
                            phi_1165_ = _e376;
                        }
                        let _e380 = phi_1165_;
                        let _e387 = lt_math_LightPoint(vec2<f32>(_e302, _e262.uv.y), _e262.depth, _e262.is_inside);
                        let _e394 = lt_math_LightPoint(vec2<f32>(_e387.uv.x, _e316), _e387.depth, _e387.is_inside);
                        let _e398 = lt_math_LightPoint(_e394.uv, _e329, _e394.is_inside);
                        let _e402 = lt_math_LightPoint(_e398.uv, _e398.depth, _e380);
                        phi_1174_ = _e402;
                        phi_1175_ = (_e264 + 1u);
                        phi_1176_ = lt_math_LevelPoint(_e264, _e402);
                        phi_1177_ = true;
                    }
                    let _e406 = phi_1174_;
                    let _e408 = phi_1175_;
                    let _e410 = phi_1176_;
                    let _e412 = phi_1177_;
                    phi_1009_ = _e406;
                    phi_1012_ = _e408;
                    phi_1014_ = _e410;
                    phi_1178_ = _e412;
                } else {
                    phi_1009_ = lt_math_LightPoint();
                    phi_1012_ = u32();
                    phi_1014_ = lt_math_LevelPoint();
                    phi_1178_ = false;
                }
                let _e414 = phi_1009_;
                let _e416 = phi_1012_;
                let _e418 = phi_1014_;
                let _e420 = phi_1178_;
                continue;
                continuing {
                    phi_1008_ = _e414;
                    phi_1011_ = _e416;
                    phi_1013_ = _e418;
                    break if !(_e420);
                }
            }
            let _e423 = local_1;
            if _e423.point.is_inside {
                if (0f > 0f) {
                    let _e429 = local_2;
                    if (_e429.level < _e59) {
                    } else {
                        return;
                    }
                    let _e434 = levels.member[(0u + _e429.level)];
                    let _e440 = global[0u];
                    if (_e434.row_w.x == _e440) {
                        let _e443 = global[1u];
                        if (_e434.row_w.y == _e443) {
                            let _e446 = global[2u];
                            phi_1218_ = (_e434.row_w.z == _e446);
                            phi_1219_ = false;
                        } else {
                            phi_1218_ = bool();
                            phi_1219_ = true;
                        }
                        let _e449 = phi_1218_;
                        let _e451 = phi_1219_;
                        phi_1220_ = _e449;
                        phi_1221_ = _e451;
                    } else {
                        phi_1220_ = bool();
                        phi_1221_ = true;
                    }
                    let _e453 = phi_1220_;
                    let _e455 = phi_1221_;
                    if _e455 {
                        phi_1225_ = false;
                    } else {
                        phi_1225_ = _e453;
                    }
                    let _e457 = phi_1225_;
                    if _e457 {
                        let _e459 = samples.member[(0u + _e65.first_primitive)].normal;
                        let _e461 = p.member.map_size;
                        let _e531 = ((abs(((((_e434.row_x.x * _e459.x) + (_e434.row_x.y * _e459.y)) + (_e434.row_x.z * _e459.z)) / (((_e434.row_x.x * _e434.row_x.x) + (_e434.row_x.y * _e434.row_x.y)) + (_e434.row_x.z * _e434.row_x.z)))) + abs(((((_e434.row_y.x * _e459.x) + (_e434.row_y.y * _e459.y)) + (_e434.row_y.z * _e459.z)) / (((_e434.row_y.x * _e434.row_y.x) + (_e434.row_y.y * _e434.row_y.y)) + (_e434.row_y.z * _e434.row_y.z))))) / (abs(((((_e434.row_z.x * _e459.x) + (_e434.row_z.y * _e459.y)) + (_e434.row_z.z * _e459.z)) / (((_e434.row_z.x * _e434.row_z.x) + (_e434.row_z.y * _e434.row_z.y)) + (_e434.row_z.z * _e434.row_z.z)))) * f32(_e461)));
                        if (_e531 < 0.002f) {
                            phi_1307_ = _e531;
                        } else {
                            phi_1307_ = 0.002f;
                        }
                        let _e534 = phi_1307_;
                        phi_1426_ = _e534;
                    } else {
                        let _e536 = p.member.map_size;
                        let _e542 = samples.member[(0u + _e65.first_primitive)].position;
                        let _e553 = ((((_e434.row_w.x * _e542.x) + (_e434.row_w.y * _e542.y)) + (_e434.row_w.z * _e542.z)) + _e434.row_w.w);
                        let _e566 = ((_e434.row_x.x - (_e434.row_w.x * _e423.point.uv.x)) / _e553);
                        let _e567 = ((_e434.row_x.y - (_e434.row_w.y * _e423.point.uv.x)) / _e553);
                        let _e568 = ((_e434.row_x.z - (_e434.row_w.z * _e423.point.uv.x)) / _e553);
                        let _e581 = ((_e434.row_y.x - (_e434.row_w.x * _e423.point.uv.y)) / _e553);
                        let _e582 = ((_e434.row_y.y - (_e434.row_w.y * _e423.point.uv.y)) / _e553);
                        let _e583 = ((_e434.row_y.z - (_e434.row_w.z * _e423.point.uv.y)) / _e553);
                        let _e589 = samples.member[(0u + _e65.first_primitive)].normal;
                        let _e594 = ((_e582 * _e589.z) - (_e589.y * _e583));
                        let _e599 = ((_e583 * _e589.x) - (_e589.z * _e581));
                        let _e604 = ((_e581 * _e589.y) - (_e589.x * _e582));
                        let _e606 = samples.member[(0u + _e65.first_primitive)].normal;
                        let _e611 = ((_e567 * _e606.z) - (_e606.y * _e568));
                        let _e616 = ((_e568 * _e606.x) - (_e606.z * _e566));
                        let _e621 = ((_e566 * _e606.y) - (_e606.x * _e567));
                        let _e648 = ((abs(((((_e434.row_z.x * _e594) + (_e434.row_z.y * _e599)) + (_e434.row_z.z * _e604)) / (((_e566 * _e594) + (_e567 * _e599)) + (_e568 * _e604)))) + abs(((((_e434.row_z.x * _e611) + (_e434.row_z.y * _e616)) + (_e434.row_z.z * _e621)) / (((_e581 * _e611) + (_e582 * _e616)) + (_e583 * _e621))))) / f32(_e536));
                        let _e650 = (16f / f32(_e536));
                        if (_e648 < _e650) {
                            phi_1425_ = _e648;
                        } else {
                            phi_1425_ = _e650;
                        }
                        let _e653 = phi_1425_;
                        phi_1426_ = _e653;
                    }
                    let _e655 = phi_1426_;
                    phi_1429_ = (_e423.point.depth - (0f * _e655));
                } else {
                    phi_1429_ = _e423.point.depth;
                }
                let _e659 = phi_1429_;
                let _e665 = p.member.map_size;
                let _e666 = f32(_e665);
                let _e669 = ((_e423.point.uv.x * _e666) - 0.5f);
                let _e670 = ((_e423.point.uv.y * _e666) - 0.5f);
                if (_e669 > -8388608f) {
                    let _e682 = f32(select(0i, select(select(i32(_e669), i32(-2147483648), (_e669 < bitcast<f32>(3472883712u))), 2147483647i, (_e669 > bitcast<f32>(1325400063u))), (_e669 == _e669)));
                    if (_e682 > _e669) {
                        phi_1458_ = 1f;
                    } else {
                        phi_1458_ = 0f;
                    }
                    let _e685 = phi_1458_;
                    if (_e669 < 8388608f) {
                        phi_1463_ = (_e682 - _e685);
                        phi_1464_ = false;
                    } else {
                        phi_1463_ = f32();
                        phi_1464_ = true;
                    }
                    let _e688 = phi_1463_;
                    let _e690 = phi_1464_;
                    phi_1465_ = _e688;
                    phi_1466_ = _e690;
                } else {
                    phi_1465_ = f32();
                    phi_1466_ = true;
                }
                let _e692 = phi_1465_;
                let _e694 = phi_1466_;
                if _e694 {
                    phi_1470_ = _e669;
                } else {
                    phi_1470_ = _e692;
                }
                let _e696 = phi_1470_;
                if (_e670 > -8388608f) {
                    let _e708 = f32(select(0i, select(select(i32(_e670), i32(-2147483648), (_e670 < bitcast<f32>(3472883712u))), 2147483647i, (_e670 > bitcast<f32>(1325400063u))), (_e670 == _e670)));
                    if (_e708 > _e670) {
                        phi_1490_ = 1f;
                    } else {
                        phi_1490_ = 0f;
                    }
                    let _e711 = phi_1490_;
                    if (_e670 < 8388608f) {
                        phi_1495_ = (_e708 - _e711);
                        phi_1496_ = false;
                    } else {
                        phi_1495_ = f32();
                        phi_1496_ = true;
                    }
                    let _e714 = phi_1495_;
                    let _e716 = phi_1496_;
                    phi_1497_ = _e714;
                    phi_1498_ = _e716;
                } else {
                    phi_1497_ = f32();
                    phi_1498_ = true;
                }
                let _e718 = phi_1497_;
                let _e720 = phi_1498_;
                if _e720 {
                    phi_1502_ = _e670;
                } else {
                    phi_1502_ = _e718;
                }
                let _e722 = phi_1502_;
                let _e723 = (_e669 - _e696);
                let _e724 = (_e670 - _e722);
                let _e733 = select(0i, select(select(i32(_e696), i32(-2147483648), (_e696 < bitcast<f32>(3472883712u))), 2147483647i, (_e696 > bitcast<f32>(1325400063u))), (_e696 == _e696));
                let _e742 = select(0i, select(select(i32(_e722), i32(-2147483648), (_e722 < bitcast<f32>(3472883712u))), 2147483647i, (_e722 > bitcast<f32>(1325400063u))), (_e722 == _e722));
                let _e753 = p.member.test;
                let _e754 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e753);
                let _e756 = p.member.map_size;
                let _e758 = local_3;
                local = _e754;
                let _e761 = ((_e758.level * _e756) * _e756);
                let _e763 = (bitcast<i32>(_e756) - 1i);
                if (_e733 > 0i) {
                    phi_1551_ = _e733;
                } else {
                    phi_1551_ = 0i;
                }
                let _e766 = phi_1551_;
                if (_e742 > 0i) {
                    phi_1556_ = _e742;
                } else {
                    phi_1556_ = 0i;
                }
                let _e769 = phi_1556_;
                if (_e766 < _e763) {
                    phi_1561_ = _e766;
                } else {
                    phi_1561_ = _e763;
                }
                let _e772 = phi_1561_;
                if (_e769 < _e763) {
                    phi_1566_ = _e769;
                } else {
                    phi_1566_ = _e763;
                }
                let _e775 = phi_1566_;
                let _e776 = bitcast<u32>(_e772);
                let _e778 = (_e733 + 1i);
                let _e779 = (_e742 + 1i);
                if (_e778 > 0i) {
                    phi_1575_ = _e778;
                } else {
                    phi_1575_ = 0i;
                }
                let _e782 = phi_1575_;
                if (_e779 > 0i) {
                    phi_1580_ = _e779;
                } else {
                    phi_1580_ = 0i;
                }
                let _e785 = phi_1580_;
                if (_e782 < _e763) {
                    phi_1585_ = _e782;
                } else {
                    phi_1585_ = _e763;
                }
                let _e788 = phi_1585_;
                if (_e785 < _e763) {
                    phi_1590_ = _e785;
                } else {
                    phi_1590_ = _e763;
                }
                let _e791 = phi_1590_;
                let _e792 = bitcast<u32>(_e788);
                let _e794 = (bitcast<u32>(_e775) * _e756);
                let _e795 = (bitcast<u32>(_e791) * _e756);
                let _e800 = ((_e794 + _e776) + _e761);
                let _e801 = ((_e794 + _e792) + _e761);
                let _e802 = ((_e795 + _e776) + _e761);
                let _e803 = ((_e795 + _e792) + _e761);
                if (_e800 < _e53) {
                } else {
                    return;
                }
                let _e807 = map.member[(0u + _e800)];
                if (_e801 < _e53) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e801)];
                if (_e802 < _e53) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e802)];
                if (_e803 < _e53) {
                } else {
                    return;
                }
                let _e819 = map.member[(0u + _e803)];
                let _e821 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e807, _e811, _e815, _e819), vec4<f32>(((1f - _e723) * (1f - _e724)), (_e723 * (1f - _e724)), ((1f - _e723) * _e724), (_e723 * _e724)), _e659);
                let _e825 = p.member.epsilon;
                if (_e821 <= _e825) {
                    phi_1643_ = true;
                } else {
                    phi_1643_ = (_e821 >= (1f - _e825));
                }
                let _e830 = phi_1643_;
                if ((bitcast<u32>(_e821) & 2147483647u) > 2139095040u) {
                    phi_1651_ = true;
                } else {
                    phi_1651_ = !(_e830);
                }
                let _e836 = phi_1651_;
                if _e836 {
                    if (_e821 > 0f) {
                        if (_e821 < 1f) {
                            phi_1663_ = false;
                        } else {
                            phi_1663_ = true;
                        }
                        let _e840 = phi_1663_;
                        phi_1664_ = _e840;
                    } else {
                        phi_1664_ = true;
                    }
                    let _e842 = phi_1664_;
                    if _e842 {
                        phi_1668_ = 0.5f;
                    } else {
                        phi_1668_ = _e821;
                    }
                    let _e844 = phi_1668_;
                    phi_1676_ = evaluate_Verdict(_e844, true);
                } else {
                    if (_e821 > 0.5f) {
                        phi_1674_ = 1f;
                    } else {
                        phi_1674_ = 0f;
                    }
                    let _e848 = phi_1674_;
                    phi_1676_ = evaluate_Verdict(_e848, false);
                }
                let _e851 = phi_1676_;
                let _e854 = (_e851.visibility < 0.5f);
                if _e851.is_doubted {
                    phi_1699_ = evaluate_Verdict();
                    phi_1700_ = true;
                } else {
                    if _e854 {
                        phi_1686_ = 2u;
                    } else {
                        phi_1686_ = 1u;
                    }
                    let _e856 = phi_1686_;
                    if ((0u & _e856) != 0u) {
                        if _e854 {
                            phi_1695_ = 0.000000059604645f;
                        } else {
                            phi_1695_ = 0.99999994f;
                        }
                        let _e860 = phi_1695_;
                        phi_1697_ = evaluate_Verdict(_e860, true);
                        phi_1698_ = false;
                    } else {
                        phi_1697_ = evaluate_Verdict();
                        phi_1698_ = true;
                    }
                    let _e863 = phi_1697_;
                    let _e865 = phi_1698_;
                    phi_1699_ = _e863;
                    phi_1700_ = _e865;
                }
                let _e867 = phi_1699_;
                let _e869 = phi_1700_;
                if _e869 {
                    phi_1705_ = evaluate_Verdict(_e851.visibility, _e851.is_doubted);
                } else {
                    phi_1705_ = _e867;
                }
                let _e872 = phi_1705_;
                phi_1710_ = evaluate_Verdict(_e872.visibility, _e872.is_doubted);
            } else {
                phi_1710_ = evaluate_Verdict(0.5f, true);
            }
            let _e878 = phi_1710_;
            phi_1711_ = _e878;
        }
        let _e880 = phi_1711_;
        if (_e65.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e65.first_primitive)] = _e880.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
