struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    pad: vec2<u32>,
}

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

struct type_39 {
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

struct type_45 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
var<private> local_5: u32;
@group(0) @binding(1) 
var<storage> samples: type_10;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_18;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_18;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(5) 
var<storage> levels: type_45;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_163_: lt_bvh_traverse_Tree;
    var phi_164_: bool;
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_171_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_163_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_164_ = false;
        } else {
            phi_163_ = lt_bvh_traverse_Tree();
            phi_164_ = true;
        }
        let _e58 = phi_163_;
        let _e60 = phi_164_;
        phi_165_ = _e58;
        phi_166_ = _e60;
    } else {
        phi_165_ = lt_bvh_traverse_Tree();
        phi_166_ = true;
    }
    let _e62 = phi_165_;
    let _e64 = phi_166_;
    if _e64 {
        phi_171_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_171_ = _e62;
    }
    let _e69 = phi_171_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_200_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_273_: f32;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_317_: bool;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_630_: f32;
    var phi_647_: f32;
    var phi_648_: f32;
    var phi_649_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: f32;
    var phi_685_: f32;
    var phi_686_: f32;
    var phi_687_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_712_: f32;
    var phi_723_: f32;
    var phi_738_: f32;
    var phi_740_: lt_bvh_slab_Span;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_803_: bool;
    var phi_807_: f32;
    var phi_822_: f32;
    var phi_823_: f32;
    var phi_824_: f32;
    var phi_825_: f32;
    var phi_826_: f32;
    var phi_827_: f32;
    var phi_828_: f32;
    var phi_829_: bool;
    var phi_830_: f32;
    var phi_831_: f32;
    var phi_832_: bool;
    var phi_836_: f32;

    let _e49 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_200_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_199_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_198_ = 1f;
            } else {
                phi_198_ = param_7;
            }
            let _e56 = phi_198_;
            phi_199_ = _e56;
        }
        let _e58 = phi_199_;
        phi_200_ = _e58;
    }
    let _e60 = phi_200_;
    let _e61 = (_e60 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_219_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_218_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_217_ = 1f;
            } else {
                phi_217_ = param_5.x;
            }
            let _e69 = phi_217_;
            phi_218_ = _e69;
        }
        let _e71 = phi_218_;
        phi_219_ = _e71;
    }
    let _e73 = phi_219_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_237_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_236_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_235_ = 1f;
            } else {
                phi_235_ = param_5.y;
            }
            let _e81 = phi_235_;
            phi_236_ = _e81;
        }
        let _e83 = phi_236_;
        phi_237_ = _e83;
    }
    let _e85 = phi_237_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_255_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_254_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_253_ = 1f;
            } else {
                phi_253_ = param_5.z;
            }
            let _e93 = phi_253_;
            phi_254_ = _e93;
        }
        let _e95 = phi_254_;
        phi_255_ = _e95;
    }
    let _e97 = phi_255_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_273_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_272_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_271_ = 1f;
            } else {
                phi_271_ = param_5.w;
            }
            let _e105 = phi_271_;
            phi_272_ = _e105;
        }
        let _e107 = phi_272_;
        phi_273_ = _e107;
    }
    let _e109 = phi_273_;
    let _e110 = (_e73 - _e61);
    let _e111 = (_e85 - _e61);
    let _e112 = (_e97 - _e61);
    let _e113 = (_e109 - _e61);
    let _e124 = ((((_e110 * param_6.x) + (_e111 * param_6.y)) + (_e112 * param_6.z)) + (_e113 * param_6.w));
    if ((bitcast<u32>(_e124) & 2147483647u) > 2139095040u) {
        phi_830_ = _e124;
        phi_831_ = f32();
        phi_832_ = true;
    } else {
        if (_e110 >= 0f) {
            if (_e111 >= 0f) {
                if (_e112 >= 0f) {
                    phi_308_ = (_e113 >= 0f);
                    phi_309_ = false;
                } else {
                    phi_308_ = bool();
                    phi_309_ = true;
                }
                let _e133 = phi_308_;
                let _e135 = phi_309_;
                phi_310_ = _e133;
                phi_311_ = _e135;
            } else {
                phi_310_ = bool();
                phi_311_ = true;
            }
            let _e137 = phi_310_;
            let _e139 = phi_311_;
            phi_312_ = _e137;
            phi_313_ = _e139;
        } else {
            phi_312_ = bool();
            phi_313_ = true;
        }
        let _e141 = phi_312_;
        let _e143 = phi_313_;
        if _e143 {
            phi_317_ = false;
        } else {
            phi_317_ = _e141;
        }
        let _e145 = phi_317_;
        if _e145 {
            phi_827_ = 1f;
            phi_828_ = f32();
            phi_829_ = true;
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
                    phi_630_ = _e110;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_629_ = 0f;
                    } else {
                        if (_e110 < 0f) {
                            phi_628_ = 0f;
                        } else {
                            phi_628_ = 1f;
                        }
                        let _e442 = phi_628_;
                        phi_629_ = _e442;
                    }
                    let _e444 = phi_629_;
                    phi_630_ = _e444;
                }
                let _e446 = phi_630_;
                if ((bitcast<u32>(_e111) & 2147483647u) > 2139095040u) {
                    phi_649_ = _e111;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_648_ = 0f;
                    } else {
                        if (_e111 < 0f) {
                            phi_647_ = 0f;
                        } else {
                            phi_647_ = 1f;
                        }
                        let _e455 = phi_647_;
                        phi_648_ = _e455;
                    }
                    let _e457 = phi_648_;
                    phi_649_ = _e457;
                }
                let _e459 = phi_649_;
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_668_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_667_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_666_ = 0f;
                        } else {
                            phi_666_ = 1f;
                        }
                        let _e468 = phi_666_;
                        phi_667_ = _e468;
                    }
                    let _e470 = phi_667_;
                    phi_668_ = _e470;
                }
                let _e472 = phi_668_;
                if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                    phi_687_ = _e113;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_686_ = 0f;
                    } else {
                        if (_e113 < 0f) {
                            phi_685_ = 0f;
                        } else {
                            phi_685_ = 1f;
                        }
                        let _e481 = phi_685_;
                        phi_686_ = _e481;
                    }
                    let _e483 = phi_686_;
                    phi_687_ = _e483;
                }
                let _e485 = phi_687_;
                let _e493 = (((((_e446 * _e149) + (_e459 * _e151)) + (_e472 * _e153)) + (_e485 * _e155)) + _e146);
                if ((bitcast<u32>(_e493) & 2147483647u) > 2139095040u) {
                    phi_712_ = _e493;
                } else {
                    if (_e493 < 0f) {
                        phi_711_ = 0f;
                    } else {
                        if (_e493 > 1f) {
                            phi_710_ = 1f;
                        } else {
                            phi_710_ = _e493;
                        }
                        let _e500 = phi_710_;
                        phi_711_ = _e500;
                    }
                    let _e502 = phi_711_;
                    phi_712_ = _e502;
                }
                let _e504 = phi_712_;
                phi_825_ = _e504;
                phi_826_ = f32();
            } else {
                let _e506 = ((0.5f * -(((((((((_e210 * (_e110 + _e111)) + (_e214 * (_e110 + _e112))) + (_e238 * (_e110 + _e156))) + (_e250 * (_e110 + _e157))) + ((((_e211 * (_e111 + _e112)) + (_e215 * (_e111 + _e113))) + (_e239 * (_e111 + _e156))) + (_e251 * (_e111 + _e157)))) + ((((_e212 * (_e112 + _e113)) + (_e216 * (_e112 + _e110))) + (_e240 * (_e112 + _e156))) + (_e252 * (_e112 + _e157)))) + ((((_e213 * (_e113 + _e110)) + (_e217 * (_e113 + _e111))) + (_e241 * (_e113 + _e156))) + (_e253 * (_e113 + _e157)))) + (_e424 * (_e156 + _e157))))) / _e427);
                let _e507 = ((((((((_e210 + _e214) + _e238) + _e250) + (((_e211 + _e215) + _e239) + _e251)) + (((_e212 + _e216) + _e240) + _e252)) + (((_e213 + _e217) + _e241) + _e253)) + _e424) / _e427);
                let _e509 = ((_e506 * _e506) - _e507);
                if (_e509 > 0f) {
                    phi_723_ = sqrt(_e509);
                } else {
                    phi_723_ = 0f;
                }
                let _e513 = phi_723_;
                if (_e506 > 0f) {
                    let _e516 = (-(_e506) - _e513);
                    phi_740_ = lt_bvh_slab_Span(_e516, (_e507 / _e516));
                } else {
                    let _e519 = (_e513 - _e506);
                    if (_e519 > 0f) {
                        phi_738_ = (_e507 / _e519);
                    } else {
                        phi_738_ = 0f;
                    }
                    let _e523 = phi_738_;
                    phi_740_ = lt_bvh_slab_Span(_e523, _e519);
                }
                let _e526 = phi_740_;
                if (_e526.near >= 0f) {
                    phi_801_ = 1f;
                    phi_802_ = f32();
                    phi_803_ = true;
                } else {
                    let _e530 = (_e526.far <= 0f);
                    if _e530 {
                        phi_799_ = (_e421 / _e427);
                        phi_800_ = f32();
                    } else {
                        let _e541 = (((((_e149 * _e110) + (_e151 * _e111)) + (_e153 * _e112)) + (_e155 * _e113)) + (_e146 * (_e156 + _e157)));
                        let _e557 = (((((_e149 * (_e110 * _e110)) + (_e151 * (_e111 * _e111))) + (_e153 * (_e112 * _e112))) + (_e155 * (_e113 * _e113))) + (_e146 * ((_e156 * _e156) + (_e157 * _e157))));
                        if (-(_e526.near) <= _e526.far) {
                            phi_798_ = (1f - (((_e526.near * _e526.near) * ((_e526.far * _e557) - _e541)) / (_e526.far - _e526.near)));
                        } else {
                            phi_798_ = ((_e421 / _e427) + (((_e526.far * _e526.far) * (_e541 - (_e526.near * _e557))) / (_e526.far - _e526.near)));
                        }
                        let _e576 = phi_798_;
                        phi_799_ = f32();
                        phi_800_ = _e576;
                    }
                    let _e578 = phi_799_;
                    let _e580 = phi_800_;
                    phi_801_ = _e578;
                    phi_802_ = _e580;
                    phi_803_ = _e530;
                }
                let _e582 = phi_801_;
                let _e584 = phi_802_;
                let _e586 = phi_803_;
                if _e586 {
                    phi_807_ = _e582;
                } else {
                    phi_807_ = _e584;
                }
                let _e588 = phi_807_;
                if ((bitcast<u32>(_e588) & 2147483647u) > 2139095040u) {
                    phi_824_ = _e588;
                } else {
                    if (_e588 < 0f) {
                        phi_823_ = 0f;
                    } else {
                        if (_e588 > 1f) {
                            phi_822_ = 1f;
                        } else {
                            phi_822_ = _e588;
                        }
                        let _e595 = phi_822_;
                        phi_823_ = _e595;
                    }
                    let _e597 = phi_823_;
                    phi_824_ = _e597;
                }
                let _e599 = phi_824_;
                phi_825_ = f32();
                phi_826_ = _e599;
            }
            let _e601 = phi_825_;
            let _e603 = phi_826_;
            phi_827_ = _e601;
            phi_828_ = _e603;
            phi_829_ = _e433;
        }
        let _e605 = phi_827_;
        let _e607 = phi_828_;
        let _e609 = phi_829_;
        phi_830_ = _e605;
        phi_831_ = _e607;
        phi_832_ = _e609;
    }
    let _e611 = phi_830_;
    let _e613 = phi_831_;
    let _e615 = phi_832_;
    if _e615 {
        phi_836_ = _e611;
    } else {
        phi_836_ = _e613;
    }
    let _e617 = phi_836_;
    return _e617;
}

fn function_() {
    var local_1: f32;
    var phi_891_: bool;
    var phi_892_: bool;
    var phi_893_: bool;
    var phi_894_: bool;
    var phi_898_: bool;
    var phi_968_: bool;
    var phi_969_: bool;
    var phi_980_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_981_: bool;
    var phi_982_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_983_: bool;
    var phi_990_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_994_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1014_: lt_math_LightPoint;
    var phi_1017_: u32;
    var phi_1019_: lt_math_LevelPoint;
    var phi_1105_: bool;
    var phi_1114_: bool;
    var phi_1123_: bool;
    var phi_1124_: bool;
    var phi_1125_: bool;
    var phi_1126_: bool;
    var phi_1127_: bool;
    var phi_1128_: bool;
    var phi_1129_: bool;
    var phi_1133_: bool;
    var phi_1160_: bool;
    var phi_1161_: bool;
    var phi_1162_: bool;
    var phi_1163_: bool;
    var phi_1164_: bool;
    var phi_1165_: bool;
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1171_: bool;
    var phi_1180_: lt_math_LightPoint;
    var phi_1181_: u32;
    var phi_1182_: lt_math_LevelPoint;
    var phi_1183_: bool;
    var phi_1015_: lt_math_LightPoint;
    var phi_1018_: u32;
    var phi_1020_: lt_math_LevelPoint;
    var phi_1184_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1224_: bool;
    var phi_1225_: bool;
    var phi_1226_: bool;
    var phi_1227_: bool;
    var phi_1231_: bool;
    var phi_1313_: f32;
    var phi_1429_: f32;
    var phi_1430_: f32;
    var phi_1433_: f32;
    var phi_1462_: f32;
    var phi_1467_: f32;
    var phi_1468_: bool;
    var phi_1469_: f32;
    var phi_1470_: bool;
    var phi_1474_: f32;
    var phi_1494_: f32;
    var phi_1499_: f32;
    var phi_1500_: bool;
    var phi_1501_: f32;
    var phi_1502_: bool;
    var phi_1506_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1555_: i32;
    var phi_1560_: i32;
    var phi_1565_: i32;
    var phi_1570_: i32;
    var phi_1579_: i32;
    var phi_1584_: i32;
    var phi_1589_: i32;
    var phi_1594_: i32;
    var phi_1645_: bool;
    var phi_1653_: bool;
    var phi_1665_: bool;
    var phi_1666_: bool;
    var phi_1670_: f32;
    var phi_1676_: f32;
    var phi_1678_: evaluate_Verdict;
    var phi_1683_: evaluate_Verdict;
    var phi_1684_: evaluate_Verdict;
    var phi_1688_: bool;
    var phi_1689_: u32;
    var phi_1700_: u32;

    let _e46 = id_1;
    let _e47 = local_5;
    let _e52 = arrayLength((&map.member));
    let _e57 = arrayLength((&levels.member));
    let _e60 = p.member.size[0u];
    let _e62 = p.member.size[1u];
    let _e63 = lt_shaders_entry_pixel_index(_e46, _e60, _e62);
    if (bitcast<i32>(_e63.root) != 0i) {
        let _e70 = p.member.level_count;
        let _e74 = samples.member[_e63.first_primitive].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[_e63.first_primitive].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[_e63.first_primitive].normal[2u];
                let _e86 = global[2u];
                phi_891_ = (_e84 == _e86);
                phi_892_ = false;
            } else {
                phi_891_ = bool();
                phi_892_ = true;
            }
            let _e89 = phi_891_;
            let _e91 = phi_892_;
            phi_893_ = _e89;
            phi_894_ = _e91;
        } else {
            phi_893_ = bool();
            phi_894_ = true;
        }
        let _e93 = phi_893_;
        let _e95 = phi_894_;
        if _e95 {
            phi_898_ = false;
        } else {
            phi_898_ = _e93;
        }
        let _e97 = phi_898_;
        if !(_e97) {
            let _e100 = samples.member[_e63.first_primitive].position;
            let _e102 = p.member.light.place;
            let _e108 = p.member.light.place[3u];
            let _e115 = (_e102.x - (_e100.x * _e108));
            let _e116 = (_e102.y - (_e100.y * _e108));
            let _e117 = (_e102.z - (_e100.z * _e108));
            let _e119 = samples.member[_e63.first_primitive].normal;
            if ((((_e119.x * _e115) + (_e119.y * _e116)) + (_e119.z * _e117)) > 0f) {
                let _e133 = (((_e115 * _e115) + (_e116 * _e116)) + (_e117 * _e117));
                let _e135 = p.member.light.axis;
                let _e147 = p.member.light.place[3u];
                if (_e147 == 0f) {
                    phi_969_ = true;
                } else {
                    let _e150 = p.member.light.range_squared;
                    if (_e133 <= _e150) {
                        let _e153 = p.member.light.cos_outer;
                        phi_968_ = (-((((_e115 * _e135.x) + (_e116 * _e135.y)) + (_e117 * _e135.z))) >= (_e153 * sqrt(_e133)));
                    } else {
                        phi_968_ = false;
                    }
                    let _e158 = phi_968_;
                    phi_969_ = _e158;
                }
                let _e160 = phi_969_;
                if _e160 {
                    let _e162 = samples.member[_e63.first_primitive].flags;
                    let _e170 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e176 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e170.unnamed.visibility, false), _e170.unnamed_1);
                    phi_980_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e176.unnamed, ((_e162 & 1u) == 0u));
                    phi_981_ = false;
                } else {
                    phi_980_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_981_ = true;
                }
                let _e181 = phi_980_;
                let _e183 = phi_981_;
                phi_982_ = _e181;
                phi_983_ = _e183;
            } else {
                phi_982_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_983_ = true;
            }
            let _e185 = phi_982_;
            let _e187 = phi_983_;
            if _e187 {
                let _e193 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e199 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e193.unnamed.visibility, false), _e193.unnamed_1);
                phi_990_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e199.unnamed, true);
            } else {
                phi_990_ = _e185;
            }
            let _e204 = phi_990_;
            phi_994_ = _e204;
        } else {
            let _e210 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e216 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e210.unnamed.visibility, false), _e210.unnamed_1);
            phi_994_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e216.unnamed, true);
        }
        let _e221 = phi_994_;
        if _e221.unnamed_1 {
            phi_1684_ = evaluate_Verdict(_e221.unnamed.visibility, _e221.unnamed.is_doubted);
        } else {
            let _e229 = samples.member[_e63.first_primitive].position;
            let _e231 = p.member.map_size;
            let _e233 = (0.5f / f32(_e231));
            let _e240 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e247 = lt_math_LightPoint(vec2<f32>(_e240.uv.x, 0f), _e240.depth, _e240.is_inside);
            let _e251 = lt_math_LightPoint(_e247.uv, 0f, _e247.is_inside);
            phi_1014_ = lt_math_LightPoint();
            phi_1017_ = 0u;
            phi_1019_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e251.uv, _e251.depth, false));
            loop {
                let _e258 = phi_1014_;
                let _e260 = phi_1017_;
                let _e262 = phi_1019_;
                local_2 = _e262;
                local_3 = _e262;
                local_4 = _e262;
                if (_e260 < _e70) {
                    if _e262.point.is_inside {
                        phi_1180_ = lt_math_LightPoint();
                        phi_1181_ = u32();
                        phi_1182_ = lt_math_LevelPoint();
                        phi_1183_ = false;
                    } else {
                        if (_e260 < _e57) {
                        } else {
                            return;
                        }
                        let _e273 = levels.member[(0u + _e260)].row_w;
                        let _e284 = ((((_e273.x * _e229.x) + (_e273.y * _e229.y)) + (_e273.z * _e229.z)) + (_e273.w * 1f));
                        let _e286 = levels.member[(0u + _e260)].row_x;
                        let _e298 = (((((_e286.x * _e229.x) + (_e286.y * _e229.y)) + (_e286.z * _e229.z)) + (_e286.w * 1f)) / _e284);
                        let _e300 = levels.member[(0u + _e260)].row_y;
                        let _e312 = (((((_e300.x * _e229.x) + (_e300.y * _e229.y)) + (_e300.z * _e229.z)) + (_e300.w * 1f)) / _e284);
                        let _e314 = levels.member[(0u + _e260)].row_z;
                        let _e325 = ((((_e314.x * _e229.x) + (_e314.y * _e229.y)) + (_e314.z * _e229.z)) + (_e314.w * 1f));
                        if (_e284 > 0f) {
                            if (_e298 >= 0f) {
                                phi_1105_ = (_e298 <= 1f);
                            } else {
                                phi_1105_ = false;
                            }
                            let _e330 = phi_1105_;
                            if _e330 {
                                if (_e312 >= 0f) {
                                    phi_1114_ = (_e312 <= 1f);
                                } else {
                                    phi_1114_ = false;
                                }
                                let _e334 = phi_1114_;
                                if _e334 {
                                    if (_e325 >= 0f) {
                                        phi_1123_ = (_e325 <= 1f);
                                    } else {
                                        phi_1123_ = false;
                                    }
                                    let _e338 = phi_1123_;
                                    phi_1124_ = _e338;
                                    phi_1125_ = false;
                                } else {
                                    phi_1124_ = bool();
                                    phi_1125_ = true;
                                }
                                let _e340 = phi_1124_;
                                let _e342 = phi_1125_;
                                phi_1126_ = _e340;
                                phi_1127_ = _e342;
                            } else {
                                phi_1126_ = bool();
                                phi_1127_ = true;
                            }
                            let _e344 = phi_1126_;
                            let _e346 = phi_1127_;
                            phi_1128_ = _e344;
                            phi_1129_ = _e346;
                        } else {
                            phi_1128_ = bool();
                            phi_1129_ = true;
                        }
                        let _e348 = phi_1128_;
                        let _e350 = phi_1129_;
                        if _e350 {
                            phi_1133_ = false;
                        } else {
                            phi_1133_ = _e348;
                        }
                        let _e352 = phi_1133_;
                        if _e352 {
                            if (_e298 >= _e233) {
                                if (_e298 <= (1f - _e233)) {
                                    if (_e312 >= _e233) {
                                        phi_1160_ = (_e312 <= (1f - _e233));
                                        phi_1161_ = false;
                                    } else {
                                        phi_1160_ = bool();
                                        phi_1161_ = true;
                                    }
                                    let _e360 = phi_1160_;
                                    let _e362 = phi_1161_;
                                    phi_1162_ = _e360;
                                    phi_1163_ = _e362;
                                } else {
                                    phi_1162_ = bool();
                                    phi_1163_ = true;
                                }
                                let _e364 = phi_1162_;
                                let _e366 = phi_1163_;
                                phi_1164_ = _e364;
                                phi_1165_ = _e366;
                            } else {
                                phi_1164_ = bool();
                                phi_1165_ = true;
                            }
                            let _e368 = phi_1164_;
                            let _e370 = phi_1165_;
                            phi_1166_ = _e368;
                            phi_1167_ = _e370;
                        } else {
                            phi_1166_ = bool();
                            phi_1167_ = true;
                        }
                        let _e372 = phi_1166_;
                        let _e374 = phi_1167_;
                        if _e374 {
                            phi_1171_ = false;
                        } else {
                            phi_1171_ = _e372;
                        }
                        let _e376 = phi_1171_;
                        let _e383 = lt_math_LightPoint(vec2<f32>(_e298, _e258.uv.y), _e258.depth, _e258.is_inside);
                        let _e390 = lt_math_LightPoint(vec2<f32>(_e383.uv.x, _e312), _e383.depth, _e383.is_inside);
                        let _e394 = lt_math_LightPoint(_e390.uv, _e325, _e390.is_inside);
                        let _e398 = lt_math_LightPoint(_e394.uv, _e394.depth, _e376);
                        phi_1180_ = _e398;
                        phi_1181_ = (_e260 + 1u);
                        phi_1182_ = lt_math_LevelPoint(_e260, _e398);
                        phi_1183_ = true;
                    }
                    let _e402 = phi_1180_;
                    let _e404 = phi_1181_;
                    let _e406 = phi_1182_;
                    let _e408 = phi_1183_;
                    phi_1015_ = _e402;
                    phi_1018_ = _e404;
                    phi_1020_ = _e406;
                    phi_1184_ = _e408;
                } else {
                    phi_1015_ = lt_math_LightPoint();
                    phi_1018_ = u32();
                    phi_1020_ = lt_math_LevelPoint();
                    phi_1184_ = false;
                }
                let _e410 = phi_1015_;
                let _e412 = phi_1018_;
                let _e414 = phi_1020_;
                let _e416 = phi_1184_;
                continue;
                continuing {
                    phi_1014_ = _e410;
                    phi_1017_ = _e412;
                    phi_1019_ = _e414;
                    break if !(_e416);
                }
            }
            let _e419 = local_2;
            if _e419.point.is_inside {
                if (0f > 0f) {
                    let _e425 = local_3;
                    if (_e425.level < _e57) {
                    } else {
                        return;
                    }
                    let _e430 = levels.member[(0u + _e425.level)];
                    let _e436 = global[0u];
                    if (_e430.row_w.x == _e436) {
                        let _e439 = global[1u];
                        if (_e430.row_w.y == _e439) {
                            let _e442 = global[2u];
                            phi_1224_ = (_e430.row_w.z == _e442);
                            phi_1225_ = false;
                        } else {
                            phi_1224_ = bool();
                            phi_1225_ = true;
                        }
                        let _e445 = phi_1224_;
                        let _e447 = phi_1225_;
                        phi_1226_ = _e445;
                        phi_1227_ = _e447;
                    } else {
                        phi_1226_ = bool();
                        phi_1227_ = true;
                    }
                    let _e449 = phi_1226_;
                    let _e451 = phi_1227_;
                    if _e451 {
                        phi_1231_ = false;
                    } else {
                        phi_1231_ = _e449;
                    }
                    let _e453 = phi_1231_;
                    if _e453 {
                        let _e455 = samples.member[_e63.first_primitive].normal;
                        let _e457 = p.member.map_size;
                        let _e527 = ((abs(((((_e430.row_x.x * _e455.x) + (_e430.row_x.y * _e455.y)) + (_e430.row_x.z * _e455.z)) / (((_e430.row_x.x * _e430.row_x.x) + (_e430.row_x.y * _e430.row_x.y)) + (_e430.row_x.z * _e430.row_x.z)))) + abs(((((_e430.row_y.x * _e455.x) + (_e430.row_y.y * _e455.y)) + (_e430.row_y.z * _e455.z)) / (((_e430.row_y.x * _e430.row_y.x) + (_e430.row_y.y * _e430.row_y.y)) + (_e430.row_y.z * _e430.row_y.z))))) / (abs(((((_e430.row_z.x * _e455.x) + (_e430.row_z.y * _e455.y)) + (_e430.row_z.z * _e455.z)) / (((_e430.row_z.x * _e430.row_z.x) + (_e430.row_z.y * _e430.row_z.y)) + (_e430.row_z.z * _e430.row_z.z)))) * f32(_e457)));
                        if (_e527 < 0.002f) {
                            phi_1313_ = _e527;
                        } else {
                            phi_1313_ = 0.002f;
                        }
                        let _e530 = phi_1313_;
                        phi_1430_ = _e530;
                    } else {
                        let _e532 = p.member.map_size;
                        let _e538 = samples.member[_e63.first_primitive].position;
                        let _e549 = ((((_e430.row_w.x * _e538.x) + (_e430.row_w.y * _e538.y)) + (_e430.row_w.z * _e538.z)) + _e430.row_w.w);
                        let _e562 = ((_e430.row_x.x - (_e430.row_w.x * _e419.point.uv.x)) / _e549);
                        let _e563 = ((_e430.row_x.y - (_e430.row_w.y * _e419.point.uv.x)) / _e549);
                        let _e564 = ((_e430.row_x.z - (_e430.row_w.z * _e419.point.uv.x)) / _e549);
                        let _e577 = ((_e430.row_y.x - (_e430.row_w.x * _e419.point.uv.y)) / _e549);
                        let _e578 = ((_e430.row_y.y - (_e430.row_w.y * _e419.point.uv.y)) / _e549);
                        let _e579 = ((_e430.row_y.z - (_e430.row_w.z * _e419.point.uv.y)) / _e549);
                        let _e585 = samples.member[_e63.first_primitive].normal;
                        let _e590 = ((_e578 * _e585.z) - (_e585.y * _e579));
                        let _e595 = ((_e579 * _e585.x) - (_e585.z * _e577));
                        let _e600 = ((_e577 * _e585.y) - (_e585.x * _e578));
                        let _e602 = samples.member[_e63.first_primitive].normal;
                        let _e607 = ((_e563 * _e602.z) - (_e602.y * _e564));
                        let _e612 = ((_e564 * _e602.x) - (_e602.z * _e562));
                        let _e617 = ((_e562 * _e602.y) - (_e602.x * _e563));
                        let _e644 = ((abs(((((_e430.row_z.x * _e590) + (_e430.row_z.y * _e595)) + (_e430.row_z.z * _e600)) / (((_e562 * _e590) + (_e563 * _e595)) + (_e564 * _e600)))) + abs(((((_e430.row_z.x * _e607) + (_e430.row_z.y * _e612)) + (_e430.row_z.z * _e617)) / (((_e577 * _e607) + (_e578 * _e612)) + (_e579 * _e617))))) / f32(_e532));
                        if (_e644 < 0.002f) {
                            phi_1429_ = _e644;
                        } else {
                            phi_1429_ = 0.002f;
                        }
                        let _e647 = phi_1429_;
                        phi_1430_ = _e647;
                    }
                    let _e649 = phi_1430_;
                    phi_1433_ = (_e419.point.depth - (0f * _e649));
                } else {
                    phi_1433_ = _e419.point.depth;
                }
                let _e653 = phi_1433_;
                let _e659 = p.member.map_size;
                let _e660 = f32(_e659);
                let _e663 = ((_e419.point.uv.x * _e660) - 0.5f);
                let _e664 = ((_e419.point.uv.y * _e660) - 0.5f);
                if (_e663 > -8388608f) {
                    let _e676 = f32(select(0i, select(select(i32(_e663), i32(-2147483648), (_e663 < bitcast<f32>(3472883712u))), 2147483647i, (_e663 > bitcast<f32>(1325400063u))), (_e663 == _e663)));
                    if (_e676 > _e663) {
                        phi_1462_ = 1f;
                    } else {
                        phi_1462_ = 0f;
                    }
                    let _e679 = phi_1462_;
                    if (_e663 < 8388608f) {
                        phi_1467_ = (_e676 - _e679);
                        phi_1468_ = false;
                    } else {
                        phi_1467_ = f32();
                        phi_1468_ = true;
                    }
                    let _e682 = phi_1467_;
                    let _e684 = phi_1468_;
                    phi_1469_ = _e682;
                    phi_1470_ = _e684;
                } else {
                    phi_1469_ = f32();
                    phi_1470_ = true;
                }
                let _e686 = phi_1469_;
                let _e688 = phi_1470_;
                if _e688 {
                    phi_1474_ = _e663;
                } else {
                    phi_1474_ = _e686;
                }
                let _e690 = phi_1474_;
                if (_e664 > -8388608f) {
                    let _e702 = f32(select(0i, select(select(i32(_e664), i32(-2147483648), (_e664 < bitcast<f32>(3472883712u))), 2147483647i, (_e664 > bitcast<f32>(1325400063u))), (_e664 == _e664)));
                    if (_e702 > _e664) {
                        phi_1494_ = 1f;
                    } else {
                        phi_1494_ = 0f;
                    }
                    let _e705 = phi_1494_;
                    if (_e664 < 8388608f) {
                        phi_1499_ = (_e702 - _e705);
                        phi_1500_ = false;
                    } else {
                        phi_1499_ = f32();
                        phi_1500_ = true;
                    }
                    let _e708 = phi_1499_;
                    let _e710 = phi_1500_;
                    phi_1501_ = _e708;
                    phi_1502_ = _e710;
                } else {
                    phi_1501_ = f32();
                    phi_1502_ = true;
                }
                let _e712 = phi_1501_;
                let _e714 = phi_1502_;
                if _e714 {
                    phi_1506_ = _e664;
                } else {
                    phi_1506_ = _e712;
                }
                let _e716 = phi_1506_;
                let _e717 = (_e663 - _e690);
                let _e718 = (_e664 - _e716);
                let _e727 = select(0i, select(select(i32(_e690), i32(-2147483648), (_e690 < bitcast<f32>(3472883712u))), 2147483647i, (_e690 > bitcast<f32>(1325400063u))), (_e690 == _e690));
                let _e736 = select(0i, select(select(i32(_e716), i32(-2147483648), (_e716 < bitcast<f32>(3472883712u))), 2147483647i, (_e716 > bitcast<f32>(1325400063u))), (_e716 == _e716));
                let _e747 = p.member.test;
                let _e748 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e747);
                let _e750 = p.member.map_size;
                let _e752 = local_4;
                local_1 = _e748;
                let _e755 = ((_e752.level * _e750) * _e750);
                let _e757 = (bitcast<i32>(_e750) - 1i);
                if (_e727 > 0i) {
                    phi_1555_ = _e727;
                } else {
                    phi_1555_ = 0i;
                }
                let _e760 = phi_1555_;
                if (_e736 > 0i) {
                    phi_1560_ = _e736;
                } else {
                    phi_1560_ = 0i;
                }
                let _e763 = phi_1560_;
                if (_e760 < _e757) {
                    phi_1565_ = _e760;
                } else {
                    phi_1565_ = _e757;
                }
                let _e766 = phi_1565_;
                if (_e763 < _e757) {
                    phi_1570_ = _e763;
                } else {
                    phi_1570_ = _e757;
                }
                let _e769 = phi_1570_;
                let _e770 = bitcast<u32>(_e766);
                let _e772 = (_e727 + 1i);
                let _e773 = (_e736 + 1i);
                if (_e772 > 0i) {
                    phi_1579_ = _e772;
                } else {
                    phi_1579_ = 0i;
                }
                let _e776 = phi_1579_;
                if (_e773 > 0i) {
                    phi_1584_ = _e773;
                } else {
                    phi_1584_ = 0i;
                }
                let _e779 = phi_1584_;
                if (_e776 < _e757) {
                    phi_1589_ = _e776;
                } else {
                    phi_1589_ = _e757;
                }
                let _e782 = phi_1589_;
                if (_e779 < _e757) {
                    phi_1594_ = _e779;
                } else {
                    phi_1594_ = _e757;
                }
                let _e785 = phi_1594_;
                let _e786 = bitcast<u32>(_e782);
                let _e788 = (bitcast<u32>(_e769) * _e750);
                let _e789 = (bitcast<u32>(_e785) * _e750);
                let _e794 = ((_e788 + _e770) + _e755);
                let _e795 = ((_e788 + _e786) + _e755);
                let _e796 = ((_e789 + _e770) + _e755);
                let _e797 = ((_e789 + _e786) + _e755);
                if (_e794 < _e52) {
                } else {
                    return;
                }
                let _e801 = map.member[(0u + _e794)];
                if (_e795 < _e52) {
                } else {
                    return;
                }
                let _e805 = map.member[(0u + _e795)];
                if (_e796 < _e52) {
                } else {
                    return;
                }
                let _e809 = map.member[(0u + _e796)];
                if (_e797 < _e52) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e797)];
                let _e815 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e801, _e805, _e809, _e813), vec4<f32>(((1f - _e717) * (1f - _e718)), (_e717 * (1f - _e718)), ((1f - _e717) * _e718), (_e717 * _e718)), _e653);
                let _e817 = p.member.epsilon;
                if (_e815 <= _e817) {
                    phi_1645_ = true;
                } else {
                    phi_1645_ = (_e815 >= (1f - _e817));
                }
                let _e822 = phi_1645_;
                if ((bitcast<u32>(_e815) & 2147483647u) > 2139095040u) {
                    phi_1653_ = true;
                } else {
                    phi_1653_ = !(_e822);
                }
                let _e828 = phi_1653_;
                if _e828 {
                    if (_e815 > 0f) {
                        if (_e815 < 1f) {
                            phi_1665_ = false;
                        } else {
                            phi_1665_ = true;
                        }
                        let _e832 = phi_1665_;
                        phi_1666_ = _e832;
                    } else {
                        phi_1666_ = true;
                    }
                    let _e834 = phi_1666_;
                    if _e834 {
                        phi_1670_ = 0.5f;
                    } else {
                        phi_1670_ = _e815;
                    }
                    let _e836 = phi_1670_;
                    phi_1678_ = evaluate_Verdict(_e836, true);
                } else {
                    if (_e815 > 0.5f) {
                        phi_1676_ = 1f;
                    } else {
                        phi_1676_ = 0f;
                    }
                    let _e840 = phi_1676_;
                    phi_1678_ = evaluate_Verdict(_e840, false);
                }
                let _e843 = phi_1678_;
                phi_1683_ = evaluate_Verdict(_e843.visibility, _e843.is_doubted);
            } else {
                phi_1683_ = evaluate_Verdict(0.5f, true);
            }
            let _e849 = phi_1683_;
            phi_1684_ = _e849;
        }
        let _e851 = phi_1684_;
        visibility.member[_e63.first_primitive] = _e851.visibility;
        phi_1688_ = _e851.is_doubted;
        phi_1689_ = _e63.first_primitive;
    } else {
        phi_1688_ = false;
        phi_1689_ = 0u;
    }
    let _e856 = phi_1688_;
    let _e858 = phi_1689_;
    if (_e47 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e856 {
        let _e862 = atomicAdd((&shared_[0u]), 1u);
        phi_1700_ = _e862;
    } else {
        phi_1700_ = 0u;
    }
    let _e864 = phi_1700_;
    workgroupBarrier();
    if (_e47 == 0u) {
        let _e868 = atomicLoad((&shared_[0u]));
        let _e869 = atomicAdd((&list.member[3u]), _e868);
        atomicStore((&shared_[1u]), _e869);
    }
    workgroupBarrier();
    if _e856 {
        let _e872 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e872) + _e864)]), _e858);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
