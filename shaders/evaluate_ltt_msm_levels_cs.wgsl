struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_10 {
    member: array<abi_Sample>,
}

struct type_14 {
    member: array<u32>,
}

struct type_18 {
    member: array<f32>,
}

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
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
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    level_count: u32,
    fade_uv: f32,
    pad0_: u32,
}

struct type_37 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

struct type_43 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_49 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_37;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_49;
@group(0) @binding(5) 
var<storage> levels: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_160_: lt_bvh_traverse_Tree;
    var phi_161_: bool;
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_168_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_160_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_161_ = false;
        } else {
            phi_160_ = lt_bvh_traverse_Tree();
            phi_161_ = true;
        }
        let _e58 = phi_160_;
        let _e60 = phi_161_;
        phi_162_ = _e58;
        phi_163_ = _e60;
    } else {
        phi_162_ = lt_bvh_traverse_Tree();
        phi_163_ = true;
    }
    let _e62 = phi_162_;
    let _e64 = phi_163_;
    if _e64 {
        phi_168_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_168_ = _e62;
    }
    let _e69 = phi_168_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_195_: f32;
    var phi_196_: f32;
    var phi_197_: f32;
    var phi_214_: f32;
    var phi_215_: f32;
    var phi_216_: f32;
    var phi_232_: f32;
    var phi_233_: f32;
    var phi_234_: f32;
    var phi_250_: f32;
    var phi_251_: f32;
    var phi_252_: f32;
    var phi_268_: f32;
    var phi_269_: f32;
    var phi_270_: f32;
    var phi_305_: bool;
    var phi_306_: bool;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_314_: bool;
    var phi_625_: f32;
    var phi_626_: f32;
    var phi_627_: f32;
    var phi_644_: f32;
    var phi_645_: f32;
    var phi_646_: f32;
    var phi_663_: f32;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_682_: f32;
    var phi_683_: f32;
    var phi_684_: f32;
    var phi_707_: f32;
    var phi_708_: f32;
    var phi_709_: f32;
    var phi_720_: f32;
    var phi_735_: f32;
    var phi_737_: lt_bvh_slab_Span;
    var phi_795_: f32;
    var phi_796_: f32;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: bool;
    var phi_804_: f32;
    var phi_819_: f32;
    var phi_820_: f32;
    var phi_821_: f32;
    var phi_822_: f32;
    var phi_823_: f32;
    var phi_824_: f32;
    var phi_825_: f32;
    var phi_826_: bool;
    var phi_827_: f32;
    var phi_828_: f32;
    var phi_829_: bool;
    var phi_833_: f32;

    let _e49 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_197_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_196_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_195_ = 1f;
            } else {
                phi_195_ = param_7;
            }
            let _e56 = phi_195_;
            phi_196_ = _e56;
        }
        let _e58 = phi_196_;
        phi_197_ = _e58;
    }
    let _e60 = phi_197_;
    let _e61 = (_e60 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_216_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_215_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_214_ = 1f;
            } else {
                phi_214_ = param_5.x;
            }
            let _e69 = phi_214_;
            phi_215_ = _e69;
        }
        let _e71 = phi_215_;
        phi_216_ = _e71;
    }
    let _e73 = phi_216_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_234_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_233_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_232_ = 1f;
            } else {
                phi_232_ = param_5.y;
            }
            let _e81 = phi_232_;
            phi_233_ = _e81;
        }
        let _e83 = phi_233_;
        phi_234_ = _e83;
    }
    let _e85 = phi_234_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_252_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_251_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_250_ = 1f;
            } else {
                phi_250_ = param_5.z;
            }
            let _e93 = phi_250_;
            phi_251_ = _e93;
        }
        let _e95 = phi_251_;
        phi_252_ = _e95;
    }
    let _e97 = phi_252_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_270_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_269_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_268_ = 1f;
            } else {
                phi_268_ = param_5.w;
            }
            let _e105 = phi_268_;
            phi_269_ = _e105;
        }
        let _e107 = phi_269_;
        phi_270_ = _e107;
    }
    let _e109 = phi_270_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    let _e124 = ((((_e110 * param_6.x) + (_e111 * param_6.y)) + (_e112 * param_6.z)) + (_e113 * param_6.w));
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_827_ = _e124;
        phi_828_ = f32();
        phi_829_ = true;
    } else {
        if (_e110 >= 0f) {
            if (_e111 >= 0f) {
                if (_e112 >= 0f) {
                    phi_305_ = (_e113 >= 0f);
                    phi_306_ = false;
                } else {
                    phi_305_ = bool();
                    phi_306_ = true;
                }
                let _e133 = phi_305_;
                let _e135 = phi_306_;
                phi_307_ = _e133;
                phi_308_ = _e135;
            } else {
                phi_307_ = bool();
                phi_308_ = true;
            }
            let _e137 = phi_307_;
            let _e139 = phi_308_;
            phi_309_ = _e137;
            phi_310_ = _e139;
        } else {
            phi_309_ = bool();
            phi_310_ = true;
        }
        let _e141 = phi_309_;
        let _e143 = phi_310_;
        if _e143 {
            phi_314_ = false;
        } else {
            phi_314_ = _e141;
        }
        let _e145 = phi_314_;
        if _e145 {
            phi_824_ = 1f;
            phi_825_ = f32();
            phi_826_ = true;
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
                    phi_627_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_626_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_625_ = 0f;
                        } else {
                            phi_625_ = 1f;
                        }
                        let _e442 = phi_625_;
                        phi_626_ = _e442;
                    }
                    let _e444 = phi_626_;
                    phi_627_ = _e444;
                }
                let _e446 = phi_627_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_646_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_645_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_644_ = 0f;
                        } else {
                            phi_644_ = 1f;
                        }
                        let _e455 = phi_644_;
                        phi_645_ = _e455;
                    }
                    let _e457 = phi_645_;
                    phi_646_ = _e457;
                }
                let _e459 = phi_646_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_665_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_664_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_663_ = 0f;
                        } else {
                            phi_663_ = 1f;
                        }
                        let _e468 = phi_663_;
                        phi_664_ = _e468;
                    }
                    let _e470 = phi_664_;
                    phi_665_ = _e470;
                }
                let _e472 = phi_665_;
                if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                    phi_684_ = _e113;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_683_ = 0f;
                    } else {
                        if (_e113 < 0f) {
                            phi_682_ = 0f;
                        } else {
                            phi_682_ = 1f;
                        }
                        let _e481 = phi_682_;
                        phi_683_ = _e481;
                    }
                    let _e483 = phi_683_;
                    phi_684_ = _e483;
                }
                let _e485 = phi_684_;
                let _e493 = (((((_e446 * _e149) + (_e459 * _e151)) + (_e472 * _e153)) + (_e485 * _e155)) + _e146);
                if ((bitcast<u32>(_e493) & 2147483647u) > 2139095040u) {
                    phi_709_ = _e493;
                } else {
                    if (_e493 < 0f) {
                        phi_708_ = 0f;
                    } else {
                        if (_e493 > 1f) {
                            phi_707_ = 1f;
                        } else {
                            phi_707_ = _e493;
                        }
                        let _e500 = phi_707_;
                        phi_708_ = _e500;
                    }
                    let _e502 = phi_708_;
                    phi_709_ = _e502;
                }
                let _e504 = phi_709_;
                phi_822_ = _e504;
                phi_823_ = f32();
            } else {
                let _e506 = ((0.5f * -(((((((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e112))) + (_e238 * (_e110 + _e156))) + (_e250 * (_e110 + _e157))) + ((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e113))) + (_e239 * (_e111 + _e156))) + (_e251 * (_e111 + _e157)))) + ((((_e212 * (_e112 + _e113)) + (_e216 * (_e112 + _e110))) + (_e240 * (_e112 + _e156))) + (_e252 * (_e112 + _e157)))) + ((((_e213 * (_e113 + _e110)) + (_e217 * (_e113 + _e111))) + (_e241 * (_e113 + _e156))) + (_e253 * (_e113 + _e157)))) + (_e424 * (_e156 + _e157))))) / _e427);
                let _e507 = ((((((((_e210 + _e214) + _e238) + _e250) + (((_e211 + _e215) + _e239) + _e251)) + (((_e212 + _e216) + _e240) + _e252)) + (((_e213 + _e217) + _e241) + _e253)) + _e424) / _e427);
                let _e509 = ((_e506 * _e506) - _e507);
                if (_e509 > 0f) {
                    phi_720_ = sqrt(_e509);
                } else {
                    phi_720_ = 0f;
                }
                let _e513 = phi_720_;
                if (_e506 > 0f) {
                    let _e516 = (-(_e506) - _e513);
                    phi_737_ = lt_bvh_slab_Span(_e516, (_e507 / _e516));
                } else {
                    let _e519 = (_e513 - _e506);
                    if (_e519 > 0f) {
                        phi_735_ = (_e507 / _e519);
                    } else {
                        phi_735_ = 0f;
                    }
                    let _e523 = phi_735_;
                    phi_737_ = lt_bvh_slab_Span(_e523, _e519);
                }
                let _e526 = phi_737_;
                if (_e526.near >= 0f) {
                    phi_798_ = 1f;
                    phi_799_ = f32();
                    phi_800_ = true;
                } else {
                    let _e530 = (_e526.far <= 0f);
                    if _e530 {
                        phi_796_ = (_e421 / _e427);
                        phi_797_ = f32();
                    } else {
                        let _e541 = (((((_e149 * _e110) + (_e151 * _e111)) + (_e153 * _e112)) + (_e155 * _e113)) + (_e146 * (_e156 + _e157)));
                        let _e557 = (((((_e149 * (_e110 * _e110)) + (_e151 * (_e111 * _e111))) + (_e153 * (_e112 * _e112))) + (_e155 * (_e113 * _e113))) + (_e146 * ((_e156 * _e156) + (_e157 * _e157))));
                        if (-(_e526.near) <= _e526.far) {
                            phi_795_ = (1f - (((_e526.near * _e526.near) * ((_e526.far * _e557) - _e541)) / (_e526.far - _e526.near)));
                        } else {
                            phi_795_ = ((_e421 / _e427) + (((_e526.far * _e526.far) * (_e541 - (_e526.near * _e557))) / (_e526.far - _e526.near)));
                        }
                        let _e576 = phi_795_;
                        phi_796_ = f32();
                        phi_797_ = _e576;
                    }
                    let _e578 = phi_796_;
                    let _e580 = phi_797_;
                    phi_798_ = _e578;
                    phi_799_ = _e580;
                    phi_800_ = _e530;
                }
                let _e582 = phi_798_;
                let _e584 = phi_799_;
                let _e586 = phi_800_;
                if _e586 {
                    phi_804_ = _e582;
                } else {
                    phi_804_ = _e584;
                }
                let _e588 = phi_804_;
                if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                    phi_821_ = _e588;
                } else {
                    if (_e588 < 0f) {
                        phi_820_ = 0f;
                    } else {
                        if (_e588 > 1f) {
                            phi_819_ = 1f;
                        } else {
                            phi_819_ = _e588;
                        }
                        let _e595 = phi_819_;
                        phi_820_ = _e595;
                    }
                    let _e597 = phi_820_;
                    phi_821_ = _e597;
                }
                let _e599 = phi_821_;
                phi_822_ = f32();
                phi_823_ = _e599;
            }
            let _e601 = phi_822_;
            let _e603 = phi_823_;
            phi_824_ = _e601;
            phi_825_ = _e603;
            phi_826_ = _e433;
        }
        let _e605 = phi_824_;
        let _e607 = phi_825_;
        let _e609 = phi_826_;
        phi_827_ = _e605;
        phi_828_ = _e607;
        phi_829_ = _e609;
    }
    let _e611 = phi_827_;
    let _e613 = phi_828_;
    let _e615 = phi_829_;
    if _e615 {
        phi_833_ = _e611;
    } else {
        phi_833_ = _e613;
    }
    let _e617 = phi_833_;
    return _e617;
}

fn function_() {
    var local_1: f32;
    var phi_889_: bool;
    var phi_890_: bool;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_896_: bool;
    var phi_940_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_944_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_964_: lt_math_LightPoint;
    var phi_967_: u32;
    var phi_969_: lt_math_LevelPoint;
    var phi_1055_: bool;
    var phi_1064_: bool;
    var phi_1073_: bool;
    var phi_1074_: bool;
    var phi_1075_: bool;
    var phi_1076_: bool;
    var phi_1077_: bool;
    var phi_1078_: bool;
    var phi_1079_: bool;
    var phi_1083_: bool;
    var phi_1110_: bool;
    var phi_1111_: bool;
    var phi_1112_: bool;
    var phi_1113_: bool;
    var phi_1114_: bool;
    var phi_1115_: bool;
    var phi_1116_: bool;
    var phi_1117_: bool;
    var phi_1121_: bool;
    var phi_1130_: lt_math_LightPoint;
    var phi_1131_: u32;
    var phi_1132_: lt_math_LevelPoint;
    var phi_1133_: bool;
    var phi_965_: lt_math_LightPoint;
    var phi_968_: u32;
    var phi_970_: lt_math_LevelPoint;
    var phi_1134_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1177_: bool;
    var phi_1181_: bool;
    var phi_1263_: f32;
    var phi_1379_: f32;
    var phi_1380_: f32;
    var phi_1383_: f32;
    var phi_1412_: f32;
    var phi_1417_: f32;
    var phi_1418_: bool;
    var phi_1419_: f32;
    var phi_1420_: bool;
    var phi_1424_: f32;
    var phi_1444_: f32;
    var phi_1449_: f32;
    var phi_1450_: bool;
    var phi_1451_: f32;
    var phi_1452_: bool;
    var phi_1456_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1505_: i32;
    var phi_1510_: i32;
    var phi_1515_: i32;
    var phi_1520_: i32;
    var phi_1529_: i32;
    var phi_1534_: i32;
    var phi_1539_: i32;
    var phi_1544_: i32;
    var phi_1595_: bool;
    var phi_1603_: bool;
    var phi_1615_: bool;
    var phi_1616_: bool;
    var phi_1620_: f32;
    var phi_1626_: f32;
    var phi_1628_: evaluate_Verdict;
    var phi_1633_: evaluate_Verdict;
    var phi_1634_: evaluate_Verdict;
    var phi_1638_: bool;
    var phi_1639_: u32;
    var phi_1650_: u32;

    let _e46 = id_1;
    let _e47 = local_5;
    let _e52 = arrayLength((&map.member));
    let _e57 = arrayLength((&levels.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e46, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e70 = p.member.level_count;
        let _e72 = p.member.light;
        let _e75 = samples.member[_e63.first_primitive].normal[0u];
        let _e77 = global[0u];
        if (_e75 == _e77) {
            let _e80 = samples.member[_e63.first_primitive].normal[1u];
            let _e82 = global[1u];
            if (_e80 == _e82) {
                let _e85 = samples.member[_e63.first_primitive].normal[2u];
                let _e87 = global[2u];
                phi_889_ = (_e85 == _e87);
                phi_890_ = false;
            } else {
                phi_889_ = bool();
                phi_890_ = true;
            }
            let _e90 = phi_889_;
            let _e92 = phi_890_;
            phi_891_ = _e90;
            phi_892_ = _e92;
        } else {
            phi_891_ = bool();
            phi_892_ = true;
        }
        let _e94 = phi_891_;
        let _e96 = phi_892_;
        if _e96 {
            phi_896_ = false;
        } else {
            phi_896_ = _e94;
        }
        let _e98 = phi_896_;
        if !(_e98) {
            let _e101 = samples.member[_e63.first_primitive].normal;
            let _e103 = samples.member[_e63.first_primitive].position;
            if ((((_e101.x * (_e72.x - (_e103.x * _e72.w))) + (_e101.y * (_e72.y - (_e103.y * _e72.w)))) + (_e101.z * (_e72.z - (_e103.z * _e72.w)))) > 0f) {
                let _e127 = samples.member[_e63.first_primitive].flags;
                let _e135 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e141 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e135.unnamed.visibility, false), _e135.unnamed_1);
                phi_940_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e141.unnamed, ((_e127 & 1u) == 0u));
            } else {
                let _e150 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e156 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e150.unnamed.visibility, false), _e150.unnamed_1);
                phi_940_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e156.unnamed, true);
            }
            let _e161 = phi_940_;
            phi_944_ = _e161;
        } else {
            let _e167 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e167.unnamed.visibility, false), _e167.unnamed_1);
            phi_944_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e173.unnamed, true);
        }
        let _e178 = phi_944_;
        if _e178.unnamed_1 {
            phi_1634_ = evaluate_Verdict(_e178.unnamed.visibility, _e178.unnamed.is_doubted);
        } else {
            let _e186 = samples.member[_e63.first_primitive].position;
            let _e188 = p.member.map_size;
            let _e190 = (0.5f / f32(_e188));
            let _e197 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e204 = lt_math_LightPoint(vec2<f32>(_e197.uv.x, 0f), _e197.depth, _e197.is_inside);
            let _e208 = lt_math_LightPoint(_e204.uv, 0f, _e204.is_inside);
            phi_964_ = lt_math_LightPoint();
            phi_967_ = 0u;
            phi_969_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e208.uv, _e208.depth, false));
            loop {
                let _e215 = phi_964_;
                let _e217 = phi_967_;
                let _e219 = phi_969_;
                local_2 = _e219;
                local_3 = _e219;
                local_4 = _e219;
                if (_e217 < _e70) {
                    if _e219.point.is_inside {
                        phi_1130_ = lt_math_LightPoint();
                        phi_1131_ = u32();
                        phi_1132_ = lt_math_LevelPoint();
                        phi_1133_ = false;
                    } else {
                        if (_e217 < _e57) {
                        } else {
                            return;
                        }
                        let _e230 = levels.member[(0u + _e217)].row_w;
                        let _e241 = ((((_e230.x * _e186.x) + (_e230.y * _e186.y)) + (_e230.z * _e186.z)) + (_e230.w * 1f));
                        let _e243 = levels.member[(0u + _e217)].row_x;
                        let _e255 = (((((_e243.x * _e186.x) + (_e243.y * _e186.y)) + (_e243.z * _e186.z)) + (_e243.w * 1f)) / _e241);
                        let _e257 = levels.member[(0u + _e217)].row_y;
                        let _e269 = (((((_e257.x * _e186.x) + (_e257.y * _e186.y)) + (_e257.z * _e186.z)) + (_e257.w * 1f)) / _e241);
                        let _e271 = levels.member[(0u + _e217)].row_z;
                        let _e282 = ((((_e271.x * _e186.x) + (_e271.y * _e186.y)) + (_e271.z * _e186.z)) + (_e271.w * 1f));
                        if (_e241 > 0f) {
                            if (_e255 >= 0f) {
                                phi_1055_ = (_e255 <= 1f);
                            } else {
                                phi_1055_ = false;
                            }
                            let _e287 = phi_1055_;
                            if _e287 {
                                if (_e269 >= 0f) {
                                    phi_1064_ = (_e269 <= 1f);
                                } else {
                                    phi_1064_ = false;
                                }
                                let _e291 = phi_1064_;
                                if _e291 {
                                    if (_e282 >= 0f) {
                                        phi_1073_ = (_e282 <= 1f);
                                    } else {
                                        phi_1073_ = false;
                                    }
                                    let _e295 = phi_1073_;
                                    phi_1074_ = _e295;
                                    phi_1075_ = false;
                                } else {
                                    phi_1074_ = bool();
                                    phi_1075_ = true;
                                }
                                let _e297 = phi_1074_;
                                let _e299 = phi_1075_;
                                phi_1076_ = _e297;
                                phi_1077_ = _e299;
                            } else {
                                phi_1076_ = bool();
                                phi_1077_ = true;
                            }
                            let _e301 = phi_1076_;
                            let _e303 = phi_1077_;
                            phi_1078_ = _e301;
                            phi_1079_ = _e303;
                        } else {
                            phi_1078_ = bool();
                            phi_1079_ = true;
                        }
                        let _e305 = phi_1078_;
                        let _e307 = phi_1079_;
                        if _e307 {
                            phi_1083_ = false;
                        } else {
                            phi_1083_ = _e305;
                        }
                        let _e309 = phi_1083_;
                        if _e309 {
                            if (_e255 >= _e190) {
                                if (_e255 <= (1f - _e190)) {
                                    if (_e269 >= _e190) {
                                        phi_1110_ = (_e269 <= (1f - _e190));
                                        phi_1111_ = false;
                                    } else {
                                        phi_1110_ = bool();
                                        phi_1111_ = true;
                                    }
                                    let _e317 = phi_1110_;
                                    let _e319 = phi_1111_;
                                    phi_1112_ = _e317;
                                    phi_1113_ = _e319;
                                } else {
                                    phi_1112_ = bool();
                                    phi_1113_ = true;
                                }
                                let _e321 = phi_1112_;
                                let _e323 = phi_1113_;
                                phi_1114_ = _e321;
                                phi_1115_ = _e323;
                            } else {
                                phi_1114_ = bool();
                                phi_1115_ = true;
                            }
                            let _e325 = phi_1114_;
                            let _e327 = phi_1115_;
                            phi_1116_ = _e325;
                            phi_1117_ = _e327;
                        } else {
                            phi_1116_ = bool();
                            phi_1117_ = true;
                        }
                        let _e329 = phi_1116_;
                        let _e331 = phi_1117_;
                        if _e331 {
                            phi_1121_ = false;
                        } else {
                            phi_1121_ = _e329;
                        }
                        let _e333 = phi_1121_;
                        let _e340 = lt_math_LightPoint(vec2<f32>(_e255, _e215.uv.y), _e215.depth, _e215.is_inside);
                        let _e347 = lt_math_LightPoint(vec2<f32>(_e340.uv.x, _e269), _e340.depth, _e340.is_inside);
                        let _e351 = lt_math_LightPoint(_e347.uv, _e282, _e347.is_inside);
                        let _e355 = lt_math_LightPoint(_e351.uv, _e351.depth, _e333);
                        phi_1130_ = _e355;
                        phi_1131_ = (_e217 + 1u);
                        phi_1132_ = lt_math_LevelPoint(_e217, _e355);
                        phi_1133_ = true;
                    }
                    let _e359 = phi_1130_;
                    let _e361 = phi_1131_;
                    let _e363 = phi_1132_;
                    let _e365 = phi_1133_;
                    phi_965_ = _e359;
                    phi_968_ = _e361;
                    phi_970_ = _e363;
                    phi_1134_ = _e365;
                } else {
                    phi_965_ = lt_math_LightPoint();
                    phi_968_ = u32();
                    phi_970_ = lt_math_LevelPoint();
                    phi_1134_ = false;
                }
                let _e367 = phi_965_;
                let _e369 = phi_968_;
                let _e371 = phi_970_;
                let _e373 = phi_1134_;
                continue;
                continuing {
                    phi_964_ = _e367;
                    phi_967_ = _e369;
                    phi_969_ = _e371;
                    break if !(_e373);
                }
            }
            let _e376 = local_2;
            if _e376.point.is_inside {
                if (0f > 0f) {
                    let _e382 = local_3;
                    if (_e382.level < _e57) {
                    } else {
                        return;
                    }
                    let _e387 = levels.member[(0u + _e382.level)];
                    let _e393 = global[0u];
                    if (_e387.row_w.x == _e393) {
                        let _e396 = global[1u];
                        if (_e387.row_w.y == _e396) {
                            let _e399 = global[2u];
                            phi_1174_ = (_e387.row_w.z == _e399);
                            phi_1175_ = false;
                        } else {
                            phi_1174_ = bool();
                            phi_1175_ = true;
                        }
                        let _e402 = phi_1174_;
                        let _e404 = phi_1175_;
                        phi_1176_ = _e402;
                        phi_1177_ = _e404;
                    } else {
                        phi_1176_ = bool();
                        phi_1177_ = true;
                    }
                    let _e406 = phi_1176_;
                    let _e408 = phi_1177_;
                    if _e408 {
                        phi_1181_ = false;
                    } else {
                        phi_1181_ = _e406;
                    }
                    let _e410 = phi_1181_;
                    if _e410 {
                        let _e412 = samples.member[_e63.first_primitive].normal;
                        let _e414 = p.member.map_size;
                        let _e484 = ((abs(((((_e387.row_x.x * _e412.x) + (_e387.row_x.y * _e412.y)) + (_e387.row_x.z * _e412.z)) / (((_e387.row_x.x * _e387.row_x.x) + (_e387.row_x.y * _e387.row_x.y)) + (_e387.row_x.z * _e387.row_x.z)))) + abs(((((_e387.row_y.x * _e412.x) + (_e387.row_y.y * _e412.y)) + (_e387.row_y.z * _e412.z)) / (((_e387.row_y.x * _e387.row_y.x) + (_e387.row_y.y * _e387.row_y.y)) + (_e387.row_y.z * _e387.row_y.z))))) / (abs(((((_e387.row_z.x * _e412.x) + (_e387.row_z.y * _e412.y)) + (_e387.row_z.z * _e412.z)) / (((_e387.row_z.x * _e387.row_z.x) + (_e387.row_z.y * _e387.row_z.y)) + (_e387.row_z.z * _e387.row_z.z)))) * f32(_e414)));
                        if (_e484 < 0.002f) {
                            phi_1263_ = _e484;
                        } else {
                            phi_1263_ = 0.002f;
                        }
                        let _e487 = phi_1263_;
                        phi_1380_ = _e487;
                    } else {
                        let _e489 = p.member.map_size;
                        let _e495 = samples.member[_e63.first_primitive].position;
                        let _e506 = ((((_e387.row_w.x * _e495.x) + (_e387.row_w.y * _e495.y)) + (_e387.row_w.z * _e495.z)) + _e387.row_w.w);
                        let _e519 = ((_e387.row_x.x - (_e387.row_w.x * _e376.point.uv.x)) / _e506);
                        let _e520 = ((_e387.row_x.y - (_e387.row_w.y * _e376.point.uv.x)) / _e506);
                        let _e521 = ((_e387.row_x.z - (_e387.row_w.z * _e376.point.uv.x)) / _e506);
                        let _e534 = ((_e387.row_y.x - (_e387.row_w.x * _e376.point.uv.y)) / _e506);
                        let _e535 = ((_e387.row_y.y - (_e387.row_w.y * _e376.point.uv.y)) / _e506);
                        let _e536 = ((_e387.row_y.z - (_e387.row_w.z * _e376.point.uv.y)) / _e506);
                        let _e542 = samples.member[_e63.first_primitive].normal;
                        let _e547 = ((_e535 * _e542.z) - (_e542.y * _e536));
                        let _e552 = ((_e536 * _e542.x) - (_e542.z * _e534));
                        let _e557 = ((_e534 * _e542.y) - (_e542.x * _e535));
                        let _e559 = samples.member[_e63.first_primitive].normal;
                        let _e564 = ((_e520 * _e559.z) - (_e559.y * _e521));
                        let _e569 = ((_e521 * _e559.x) - (_e559.z * _e519));
                        let _e574 = ((_e519 * _e559.y) - (_e559.x * _e520));
                        let _e601 = ((abs(((((_e387.row_z.x * _e547) + (_e387.row_z.y * _e552)) + (_e387.row_z.z * _e557)) / (((_e519 * _e547) + (_e520 * _e552)) + (_e521 * _e557)))) + abs(((((_e387.row_z.x * _e564) + (_e387.row_z.y * _e569)) + (_e387.row_z.z * _e574)) / (((_e534 * _e564) + (_e535 * _e569)) + (_e536 * _e574))))) / f32(_e489));
                        if (_e601 < 0.002f) {
                            phi_1379_ = _e601;
                        } else {
                            phi_1379_ = 0.002f;
                        }
                        let _e604 = phi_1379_;
                        phi_1380_ = _e604;
                    }
                    let _e606 = phi_1380_;
                    phi_1383_ = (_e376.point.depth - (0f * _e606));
                } else {
                    phi_1383_ = _e376.point.depth;
                }
                let _e610 = phi_1383_;
                let _e616 = p.member.map_size;
                let _e617 = f32(_e616);
                let _e620 = ((_e376.point.uv.x * _e617) - 0.5f);
                let _e621 = ((_e376.point.uv.y * _e617) - 0.5f);
                if (_e620 > -8388608f) {
                    let _e633 = f32(select(0i, select(select(i32(_e620), i32(-2147483648), (_e620 < bitcast<f32>(3472883712u))), 2147483647i, (_e620 > bitcast<f32>(1325400063u))), (_e620 == _e620)));
                    if (_e633 > _e620) {
                        phi_1412_ = 1f;
                    } else {
                        phi_1412_ = 0f;
                    }
                    let _e636 = phi_1412_;
                    if (_e620 < 8388608f) {
                        phi_1417_ = (_e633 - _e636);
                        phi_1418_ = false;
                    } else {
                        phi_1417_ = f32();
                        phi_1418_ = true;
                    }
                    let _e639 = phi_1417_;
                    let _e641 = phi_1418_;
                    phi_1419_ = _e639;
                    phi_1420_ = _e641;
                } else {
                    phi_1419_ = f32();
                    phi_1420_ = true;
                }
                let _e643 = phi_1419_;
                let _e645 = phi_1420_;
                if _e645 {
                    phi_1424_ = _e620;
                } else {
                    phi_1424_ = _e643;
                }
                let _e647 = phi_1424_;
                if (_e621 > -8388608f) {
                    let _e659 = f32(select(0i, select(select(i32(_e621), i32(-2147483648), (_e621 < bitcast<f32>(3472883712u))), 2147483647i, (_e621 > bitcast<f32>(1325400063u))), (_e621 == _e621)));
                    if (_e659 > _e621) {
                        phi_1444_ = 1f;
                    } else {
                        phi_1444_ = 0f;
                    }
                    let _e662 = phi_1444_;
                    if (_e621 < 8388608f) {
                        phi_1449_ = (_e659 - _e662);
                        phi_1450_ = false;
                    } else {
                        phi_1449_ = f32();
                        phi_1450_ = true;
                    }
                    let _e665 = phi_1449_;
                    let _e667 = phi_1450_;
                    phi_1451_ = _e665;
                    phi_1452_ = _e667;
                } else {
                    phi_1451_ = f32();
                    phi_1452_ = true;
                }
                let _e669 = phi_1451_;
                let _e671 = phi_1452_;
                if _e671 {
                    phi_1456_ = _e621;
                } else {
                    phi_1456_ = _e669;
                }
                let _e673 = phi_1456_;
                let _e674 = (_e620 - _e647);
                let _e675 = (_e621 - _e673);
                let _e684 = select(0i, select(select(i32(_e647), i32(-2147483648), (_e647 < bitcast<f32>(3472883712u))), 2147483647i, (_e647 > bitcast<f32>(1325400063u))), (_e647 == _e647));
                let _e693 = select(0i, select(select(i32(_e673), i32(-2147483648), (_e673 < bitcast<f32>(3472883712u))), 2147483647i, (_e673 > bitcast<f32>(1325400063u))), (_e673 == _e673));
                let _e704 = p.member.test;
                let _e705 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e704);
                let _e707 = p.member.map_size;
                let _e709 = local_4;
                local_1 = _e705;
                let _e712 = ((_e709.level * _e707) * _e707);
                let _e714 = (bitcast<i32>(_e707) - 1i);
                if (_e684 > 0i) {
                    phi_1505_ = _e684;
                } else {
                    phi_1505_ = 0i;
                }
                let _e717 = phi_1505_;
                if (_e693 > 0i) {
                    phi_1510_ = _e693;
                } else {
                    phi_1510_ = 0i;
                }
                let _e720 = phi_1510_;
                if (_e717 < _e714) {
                    phi_1515_ = _e717;
                } else {
                    phi_1515_ = _e714;
                }
                let _e723 = phi_1515_;
                if (_e720 < _e714) {
                    phi_1520_ = _e720;
                } else {
                    phi_1520_ = _e714;
                }
                let _e726 = phi_1520_;
                let _e727 = bitcast<u32>(_e723);
                let _e729 = (_e684 + 1i);
                let _e730 = (_e693 + 1i);
                if (_e729 > 0i) {
                    phi_1529_ = _e729;
                } else {
                    phi_1529_ = 0i;
                }
                let _e733 = phi_1529_;
                if (_e730 > 0i) {
                    phi_1534_ = _e730;
                } else {
                    phi_1534_ = 0i;
                }
                let _e736 = phi_1534_;
                if (_e733 < _e714) {
                    phi_1539_ = _e733;
                } else {
                    phi_1539_ = _e714;
                }
                let _e739 = phi_1539_;
                if (_e736 < _e714) {
                    phi_1544_ = _e736;
                } else {
                    phi_1544_ = _e714;
                }
                let _e742 = phi_1544_;
                let _e743 = bitcast<u32>(_e739);
                let _e745 = (bitcast<u32>(_e726) * _e707);
                let _e746 = (bitcast<u32>(_e742) * _e707);
                let _e751 = ((_e745 + _e727) + _e712);
                let _e752 = ((_e745 + _e743) + _e712);
                let _e753 = ((_e746 + _e727) + _e712);
                let _e754 = ((_e746 + _e743) + _e712);
                if (_e751 < _e52) {
                } else {
                    return;
                }
                let _e758 = map.member[(0u + _e751)];
                if (_e752 < _e52) {
                } else {
                    return;
                }
                let _e762 = map.member[(0u + _e752)];
                if (_e753 < _e52) {
                } else {
                    return;
                }
                let _e766 = map.member[(0u + _e753)];
                if (_e754 < _e52) {
                } else {
                    return;
                }
                let _e770 = map.member[(0u + _e754)];
                let _e772 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e758, _e762, _e766, _e770), vec4<f32>(((1f - _e674) * (1f - _e675)), (_e674 * (1f - _e675)), ((1f - _e674) * _e675), (_e674 * _e675)), _e610);
                let _e774 = p.member.epsilon;
                if (_e772 <= _e774) {
                    phi_1595_ = true;
                } else {
                    phi_1595_ = (_e772 >= (1f - _e774));
                }
                let _e779 = phi_1595_;
                if ((bitcast<u32>(_e772) & 2147483647u) > 2139095040u) {
                    phi_1603_ = true;
                } else {
                    phi_1603_ = !(_e779);
                }
                let _e785 = phi_1603_;
                if _e785 {
                    if (_e772 > 0f) {
                        if (_e772 < 1f) {
                            phi_1615_ = false;
                        } else {
                            phi_1615_ = true;
                        }
                        let _e789 = phi_1615_;
                        phi_1616_ = _e789;
                    } else {
                        phi_1616_ = true;
                    }
                    let _e791 = phi_1616_;
                    if _e791 {
                        phi_1620_ = 0.5f;
                    } else {
                        phi_1620_ = _e772;
                    }
                    let _e793 = phi_1620_;
                    phi_1628_ = evaluate_Verdict(_e793, true);
                } else {
                    if (_e772 > 0.5f) {
                        phi_1626_ = 1f;
                    } else {
                        phi_1626_ = 0f;
                    }
                    let _e797 = phi_1626_;
                    phi_1628_ = evaluate_Verdict(_e797, false);
                }
                let _e800 = phi_1628_;
                phi_1633_ = evaluate_Verdict(_e800.visibility, _e800.is_doubted);
            } else {
                phi_1633_ = evaluate_Verdict(0.5f, true);
            }
            let _e806 = phi_1633_;
            phi_1634_ = _e806;
        }
        let _e808 = phi_1634_;
        visibility.member[_e63.first_primitive] = _e808.visibility;
        phi_1638_ = _e808.is_doubted;
        phi_1639_ = _e63.first_primitive;
    } else {
        phi_1638_ = false;
        phi_1639_ = 0u;
    }
    let _e813 = phi_1638_;
    let _e815 = phi_1639_;
    if (_e47 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e813 {
        let _e819 = atomicAdd((&shared_[0u]), 1u);
        phi_1650_ = _e819;
    } else {
        phi_1650_ = 0u;
    }
    let _e821 = phi_1650_;
    workgroupBarrier();
    if (_e47 == 0u) {
        let _e825 = atomicLoad((&shared_[0u]));
        let _e826 = atomicAdd((&list.member[3u]), _e825);
        atomicStore((&shared_[1u]), _e826);
    }
    workgroupBarrier();
    if _e813 {
        let _e829 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e829) + _e821)]), _e815);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
