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
    var phi_165_: lt_bvh_traverse_Tree;
    var phi_166_: bool;
    var phi_167_: lt_bvh_traverse_Tree;
    var phi_168_: bool;
    var phi_173_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_165_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_166_ = false;
        } else {
            phi_165_ = lt_bvh_traverse_Tree();
            phi_166_ = true;
        }
        let _e60 = phi_165_;
        let _e62 = phi_166_;
        phi_167_ = _e60;
        phi_168_ = _e62;
    } else {
        phi_167_ = lt_bvh_traverse_Tree();
        phi_168_ = true;
    }
    let _e64 = phi_167_;
    let _e66 = phi_168_;
    if _e66 {
        phi_173_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_173_ = _e64;
    }
    let _e71 = phi_173_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_273_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_319_: bool;
    var phi_630_: f32;
    var phi_631_: f32;
    var phi_632_: f32;
    var phi_649_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_668_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_687_: f32;
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_725_: f32;
    var phi_740_: f32;
    var phi_742_: lt_bvh_slab_Span;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_805_: bool;
    var phi_809_: f32;
    var phi_819_: bool;
    var phi_832_: bool;
    var phi_836_: bool;
    var phi_837_: bool;
    var phi_847_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_853_: bool;
    var phi_904_: f32;
    var phi_905_: f32;
    var phi_906_: f32;
    var phi_923_: f32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_942_: f32;
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_961_: f32;
    var phi_962_: f32;
    var phi_963_: f32;
    var phi_986_: f32;
    var phi_987_: f32;
    var phi_988_: f32;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1087_: bool;
    var phi_1091_: f32;
    var phi_1092_: f32;
    var phi_1107_: f32;
    var phi_1108_: f32;
    var phi_1109_: f32;
    var phi_1110_: f32;
    var phi_1111_: f32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_1114_: bool;
    var phi_1115_: f32;
    var phi_1116_: f32;
    var phi_1117_: bool;
    var phi_1121_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_202_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_7;
            }
            let _e58 = phi_200_;
            phi_201_ = _e58;
        }
        let _e60 = phi_201_;
        phi_202_ = _e60;
    }
    let _e62 = phi_202_;
    let _e63 = (_e62 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_221_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_220_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_219_ = 1f;
            } else {
                phi_219_ = param_5.x;
            }
            let _e71 = phi_219_;
            phi_220_ = _e71;
        }
        let _e73 = phi_220_;
        phi_221_ = _e73;
    }
    let _e75 = phi_221_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_239_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_238_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_237_ = 1f;
            } else {
                phi_237_ = param_5.y;
            }
            let _e83 = phi_237_;
            phi_238_ = _e83;
        }
        let _e85 = phi_238_;
        phi_239_ = _e85;
    }
    let _e87 = phi_239_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_257_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_256_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_255_ = 1f;
            } else {
                phi_255_ = param_5.z;
            }
            let _e95 = phi_255_;
            phi_256_ = _e95;
        }
        let _e97 = phi_256_;
        phi_257_ = _e97;
    }
    let _e99 = phi_257_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_275_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_274_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_273_ = 1f;
            } else {
                phi_273_ = param_5.w;
            }
            let _e107 = phi_273_;
            phi_274_ = _e107;
        }
        let _e109 = phi_274_;
        phi_275_ = _e109;
    }
    let _e111 = phi_275_;
    let _e112 = (_e75 - _e63);
    let _e113 = (_e87 - _e63);
    let _e114 = (_e99 - _e63);
    let _e115 = (_e111 - _e63);
    let _e126 = ((((_e112 * param_6.x) + (_e113 * param_6.y)) + (_e114 * param_6.z)) + (_e115 * param_6.w));
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_1115_ = _e126;
        phi_1116_ = f32();
        phi_1117_ = true;
    } else {
        if (_e112 >= 0f) {
            if (_e113 >= 0f) {
                if (_e114 >= 0f) {
                    phi_310_ = (_e115 >= 0f);
                    phi_311_ = false;
                } else {
                    phi_310_ = bool();
                    phi_311_ = true;
                }
                let _e135 = phi_310_;
                let _e137 = phi_311_;
                phi_312_ = _e135;
                phi_313_ = _e137;
            } else {
                phi_312_ = bool();
                phi_313_ = true;
            }
            let _e139 = phi_312_;
            let _e141 = phi_313_;
            phi_314_ = _e139;
            phi_315_ = _e141;
        } else {
            phi_314_ = bool();
            phi_315_ = true;
        }
        let _e143 = phi_314_;
        let _e145 = phi_315_;
        if _e145 {
            phi_319_ = false;
        } else {
            phi_319_ = _e143;
        }
        let _e147 = phi_319_;
        if _e147 {
            phi_1112_ = 1f;
            phi_1113_ = f32();
            phi_1114_ = true;
        } else {
            let _e148 = (0.5f * _e51);
            let _e149 = (1f - _e51);
            let _e151 = (param_6.x * _e149);
            let _e153 = (param_6.y * _e149);
            let _e155 = (param_6.z * _e149);
            let _e157 = (param_6.w * _e149);
            let _e158 = -(_e63);
            let _e159 = (1f - _e63);
            let _e161 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e75);
            let _e163 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e87);
            let _e165 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e99);
            let _e167 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e111);
            let _e168 = (_e112 - _e113);
            let _e169 = (_e113 - _e114);
            let _e170 = (_e114 - _e115);
            let _e171 = (_e115 - _e112);
            let _e172 = (_e168 * _e168);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e170 * _e170);
            let _e175 = (_e171 * _e171);
            let _e176 = (_e112 - _e114);
            let _e177 = (_e113 - _e115);
            let _e178 = (_e114 - _e112);
            let _e179 = (_e115 - _e113);
            let _e180 = (_e176 * _e176);
            let _e181 = (_e177 * _e177);
            let _e182 = (_e178 * _e178);
            let _e183 = (_e179 * _e179);
            let _e188 = ((_e151 * _e153) * _e172);
            let _e189 = ((_e153 * _e155) * _e173);
            let _e190 = ((_e155 * _e157) * _e174);
            let _e191 = ((_e157 * _e151) * _e175);
            let _e200 = (((0.5f * _e151) * _e155) * _e180);
            let _e201 = (((0.5f * _e153) * _e157) * _e181);
            let _e202 = (((0.5f * _e155) * _e151) * _e182);
            let _e203 = (((0.5f * _e157) * _e153) * _e183);
            let _e204 = (_e112 * _e113);
            let _e205 = (_e113 * _e114);
            let _e206 = (_e114 * _e115);
            let _e207 = (_e115 * _e112);
            let _e208 = (_e112 * _e114);
            let _e209 = (_e113 * _e115);
            let _e210 = (_e114 * _e112);
            let _e211 = (_e115 * _e113);
            let _e212 = (_e188 * _e204);
            let _e213 = (_e189 * _e205);
            let _e214 = (_e190 * _e206);
            let _e215 = (_e191 * _e207);
            let _e216 = (_e200 * _e208);
            let _e217 = (_e201 * _e209);
            let _e218 = (_e202 * _e210);
            let _e219 = (_e203 * _e211);
            let _e220 = (_e75 * _e75);
            let _e221 = (_e87 * _e87);
            let _e222 = (_e99 * _e99);
            let _e223 = (_e111 * _e111);
            let _e224 = (_e161 * _e161);
            let _e225 = (_e163 * _e163);
            let _e226 = (_e165 * _e165);
            let _e227 = (_e167 * _e167);
            let _e228 = (_e148 * _e151);
            let _e229 = (_e148 * _e153);
            let _e230 = (_e148 * _e155);
            let _e231 = (_e148 * _e157);
            let _e240 = (((_e228 * _e112) * _e220) * _e158);
            let _e241 = (((_e229 * _e113) * _e221) * _e158);
            let _e242 = (((_e230 * _e114) * _e222) * _e158);
            let _e243 = (((_e231 * _e115) * _e223) * _e158);
            let _e252 = (((_e228 * _e112) * _e224) * _e159);
            let _e253 = (((_e229 * _e113) * _e225) * _e159);
            let _e254 = (((_e230 * _e114) * _e226) * _e159);
            let _e255 = (((_e231 * _e115) * _e227) * _e159);
            let _e423 = (((((((_e188 * _e155) * _e173) * _e180) + (_e148 * (((_e188 * ((_e220 * _e221) + (_e224 * _e225))) + (_e200 * ((_e220 * _e222) + (_e224 * _e226)))) + ((_e228 * _e220) * _e224)))) + ((((_e189 * _e157) * _e174) * _e181) + (_e148 * (((_e189 * ((_e221 * _e222) + (_e225 * _e226))) + (_e201 * ((_e221 * _e223) + (_e225 * _e227)))) + ((_e229 * _e221) * _e225))))) + ((((_e190 * _e151) * _e175) * _e182) + (_e148 * (((_e190 * ((_e222 * _e223) + (_e226 * _e227))) + (_e202 * ((_e222 * _e220) + (_e226 * _e224)))) + ((_e230 * _e222) * _e226))))) + ((((_e191 * _e153) * _e172) * _e183) + (_e148 * (((_e191 * ((_e223 * _e220) + (_e227 * _e224))) + (_e203 * ((_e223 * _e221) + (_e227 * _e225)))) + ((_e231 * _e223) * _e227)))));
            let _e426 = (((_e148 * _e148) * _e158) * _e159);
            let _e429 = (((((((_e212 * _e204) + (_e216 * _e208)) + (_e112 * ((_e240 * _e158) + (_e252 * _e159)))) + (((_e213 * _e205) + (_e217 * _e209)) + (_e113 * ((_e241 * _e158) + (_e253 * _e159))))) + (((_e214 * _e206) + (_e218 * _e210)) + (_e114 * ((_e242 * _e158) + (_e254 * _e159))))) + (((_e215 * _e207) + (_e219 * _e211)) + (_e115 * ((_e243 * _e158) + (_e255 * _e159))))) + ((_e426 * _e158) * _e159));
            let _e435 = (_e429 < 0.0000000000000000000000000000000001f);
            if _e435 {
                if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                    phi_632_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_631_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_630_ = 0f;
                        } else {
                            phi_630_ = 1f;
                        }
                        let _e444 = phi_630_;
                        phi_631_ = _e444;
                    }
                    let _e446 = phi_631_;
                    phi_632_ = _e446;
                }
                let _e448 = phi_632_;
                if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                    phi_651_ = _e113;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_650_ = 0f;
                    } else {
                        if (_e113 < 0f) {
                            phi_649_ = 0f;
                        } else {
                            phi_649_ = 1f;
                        }
                        let _e457 = phi_649_;
                        phi_650_ = _e457;
                    }
                    let _e459 = phi_650_;
                    phi_651_ = _e459;
                }
                let _e461 = phi_651_;
                if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                    phi_670_ = _e114;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_669_ = 0f;
                    } else {
                        if (_e114 < 0f) {
                            phi_668_ = 0f;
                        } else {
                            phi_668_ = 1f;
                        }
                        let _e470 = phi_668_;
                        phi_669_ = _e470;
                    }
                    let _e472 = phi_669_;
                    phi_670_ = _e472;
                }
                let _e474 = phi_670_;
                if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                    phi_689_ = _e115;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_688_ = 0f;
                    } else {
                        if (_e115 < 0f) {
                            phi_687_ = 0f;
                        } else {
                            phi_687_ = 1f;
                        }
                        let _e483 = phi_687_;
                        phi_688_ = _e483;
                    }
                    let _e485 = phi_688_;
                    phi_689_ = _e485;
                }
                let _e487 = phi_689_;
                let _e495 = (((((_e448 * _e151) + (_e461 * _e153)) + (_e474 * _e155)) + (_e487 * _e157)) + _e148);
                if ((bitcast<u32>(_e495) & 2147483647u) > 2139095040u) {
                    phi_714_ = _e495;
                } else {
                    if (_e495 < 0f) {
                        phi_713_ = 0f;
                    } else {
                        if (_e495 > 1f) {
                            phi_712_ = 1f;
                        } else {
                            phi_712_ = _e495;
                        }
                        let _e502 = phi_712_;
                        phi_713_ = _e502;
                    }
                    let _e504 = phi_713_;
                    phi_714_ = _e504;
                }
                let _e506 = phi_714_;
                phi_1110_ = _e506;
                phi_1111_ = f32();
            } else {
                let _e508 = ((0.5f * -(((((((((_e212 * (_e112 + _e113)) + (_e216 * (_e112 + _e114))) + (_e240 * (_e112 + _e158))) + (_e252 * (_e112 + _e159))) + ((((_e213 * (_e113 + _e114)) + (_e217 * (_e113 + _e115))) + (_e241 * (_e113 + _e158))) + (_e253 * (_e113 + _e159)))) + ((((_e214 * (_e114 + _e115)) + (_e218 * (_e114 + _e112))) + (_e242 * (_e114 + _e158))) + (_e254 * (_e114 + _e159)))) + ((((_e215 * (_e115 + _e112)) + (_e219 * (_e115 + _e113))) + (_e243 * (_e115 + _e158))) + (_e255 * (_e115 + _e159)))) + (_e426 * (_e158 + _e159))))) / _e429);
                let _e509 = ((((((((_e212 + _e216) + _e240) + _e252) + (((_e213 + _e217) + _e241) + _e253)) + (((_e214 + _e218) + _e242) + _e254)) + (((_e215 + _e219) + _e243) + _e255)) + _e426) / _e429);
                let _e511 = ((_e508 * _e508) - _e509);
                if (_e511 > 0f) {
                    phi_725_ = sqrt(_e511);
                } else {
                    phi_725_ = 0f;
                }
                let _e515 = phi_725_;
                if (_e508 > 0f) {
                    let _e518 = (-(_e508) - _e515);
                    phi_742_ = lt_bvh_slab_Span(_e518, (_e509 / _e518));
                } else {
                    let _e521 = (_e515 - _e508);
                    if (_e521 > 0f) {
                        phi_740_ = (_e509 / _e521);
                    } else {
                        phi_740_ = 0f;
                    }
                    let _e525 = phi_740_;
                    phi_742_ = lt_bvh_slab_Span(_e525, _e521);
                }
                let _e528 = phi_742_;
                if (_e528.near >= 0f) {
                    phi_803_ = 1f;
                    phi_804_ = f32();
                    phi_805_ = true;
                } else {
                    let _e532 = (_e528.far <= 0f);
                    if _e532 {
                        phi_801_ = (_e423 / _e429);
                        phi_802_ = f32();
                    } else {
                        let _e543 = (((((_e151 * _e112) + (_e153 * _e113)) + (_e155 * _e114)) + (_e157 * _e115)) + (_e148 * (_e158 + _e159)));
                        let _e559 = (((((_e151 * (_e112 * _e112)) + (_e153 * (_e113 * _e113))) + (_e155 * (_e114 * _e114))) + (_e157 * (_e115 * _e115))) + (_e148 * ((_e158 * _e158) + (_e159 * _e159))));
                        if (-(_e528.near) <= _e528.far) {
                            phi_800_ = (1f - (((_e528.near * _e528.near) * ((_e528.far * _e559) - _e543)) / (_e528.far - _e528.near)));
                        } else {
                            phi_800_ = ((_e423 / _e429) + (((_e528.far * _e528.far) * (_e543 - (_e528.near * _e559))) / (_e528.far - _e528.near)));
                        }
                        let _e578 = phi_800_;
                        phi_801_ = f32();
                        phi_802_ = _e578;
                    }
                    let _e580 = phi_801_;
                    let _e582 = phi_802_;
                    phi_803_ = _e580;
                    phi_804_ = _e582;
                    phi_805_ = _e532;
                }
                let _e584 = phi_803_;
                let _e586 = phi_804_;
                let _e588 = phi_805_;
                if _e588 {
                    phi_809_ = _e584;
                } else {
                    phi_809_ = _e586;
                }
                let _e590 = phi_809_;
                if ((_e528.near * _e158) >= (1f - 0.00001f)) {
                    phi_819_ = true;
                } else {
                    phi_819_ = ((_e528.near * _e159) >= (1f - 0.00001f));
                }
                let _e598 = phi_819_;
                if _e598 {
                    if ((_e528.far * _e158) >= (1f - 0.00001f)) {
                        phi_832_ = true;
                    } else {
                        phi_832_ = ((_e528.far * _e159) >= (1f - 0.00001f));
                    }
                    let _e606 = phi_832_;
                    if _e606 {
                        phi_836_ = false;
                    } else {
                        phi_836_ = true;
                    }
                    let _e608 = phi_836_;
                    phi_837_ = _e608;
                } else {
                    phi_837_ = true;
                }
                let _e610 = phi_837_;
                if _e610 {
                    let _e612 = (-(_e158) < 0.0001f);
                    if _e612 {
                        phi_847_ = bool();
                    } else {
                        phi_847_ = (_e159 < 0.0001f);
                    }
                    let _e615 = phi_847_;
                    phi_848_ = _e615;
                    phi_849_ = _e612;
                } else {
                    phi_848_ = bool();
                    phi_849_ = true;
                }
                let _e617 = phi_848_;
                let _e619 = phi_849_;
                if _e619 {
                    phi_853_ = true;
                } else {
                    phi_853_ = _e617;
                }
                let _e621 = phi_853_;
                if !(_e621) {
                    let _e627 = ((_e151 * _e75) * _e161);
                    let _e628 = ((_e153 * _e87) * _e163);
                    let _e629 = ((_e155 * _e99) * _e165);
                    let _e630 = ((_e157 * _e111) * _e167);
                    let _e648 = ((((_e627 * (_e112 * _e112)) + (_e628 * (_e113 * _e113))) + (_e629 * (_e114 * _e114))) + (_e630 * (_e115 * _e115)));
                    if (_e648 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                            phi_906_ = _e112;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_905_ = 0f;
                            } else {
                                if (_e112 < 0f) {
                                    phi_904_ = 0f;
                                } else {
                                    phi_904_ = 1f;
                                }
                                let _e658 = phi_904_;
                                phi_905_ = _e658;
                            }
                            let _e660 = phi_905_;
                            phi_906_ = _e660;
                        }
                        let _e662 = phi_906_;
                        if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                            phi_925_ = _e113;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_924_ = 0f;
                            } else {
                                if (_e113 < 0f) {
                                    phi_923_ = 0f;
                                } else {
                                    phi_923_ = 1f;
                                }
                                let _e671 = phi_923_;
                                phi_924_ = _e671;
                            }
                            let _e673 = phi_924_;
                            phi_925_ = _e673;
                        }
                        let _e675 = phi_925_;
                        if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                            phi_944_ = _e114;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_943_ = 0f;
                            } else {
                                if (_e114 < 0f) {
                                    phi_942_ = 0f;
                                } else {
                                    phi_942_ = 1f;
                                }
                                let _e684 = phi_942_;
                                phi_943_ = _e684;
                            }
                            let _e686 = phi_943_;
                            phi_944_ = _e686;
                        }
                        let _e688 = phi_944_;
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_963_ = _e115;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_962_ = 0f;
                            } else {
                                if (_e115 < 0f) {
                                    phi_961_ = 0f;
                                } else {
                                    phi_961_ = 1f;
                                }
                                let _e697 = phi_961_;
                                phi_962_ = _e697;
                            }
                            let _e699 = phi_962_;
                            phi_963_ = _e699;
                        }
                        let _e701 = phi_963_;
                        let _e709 = (((((_e662 * _e151) + (_e675 * _e153)) + (_e688 * _e155)) + (_e701 * _e157)) + _e148);
                        if ((bitcast<u32>(_e709) & 2147483647u) > 2139095040u) {
                            phi_988_ = _e709;
                        } else {
                            if (_e709 < 0f) {
                                phi_987_ = 0f;
                            } else {
                                if (_e709 > 1f) {
                                    phi_986_ = 1f;
                                } else {
                                    phi_986_ = _e709;
                                }
                                let _e716 = phi_986_;
                                phi_987_ = _e716;
                            }
                            let _e718 = phi_987_;
                            phi_988_ = _e718;
                        }
                        let _e720 = phi_988_;
                        phi_1076_ = _e720;
                    } else {
                        let _e721 = (((((_e627 * _e112) + (_e628 * _e113)) + (_e629 * _e114)) + (_e630 * _e115)) / _e648);
                        let _e738 = ((_e151 * _e112) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e721 * _e112)));
                        let _e739 = ((_e153 * _e113) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e721 * _e113)));
                        let _e740 = ((_e155 * _e114) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e721 * _e114)));
                        let _e741 = ((_e157 * _e115) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e721 * _e115)));
                        if (_e721 > 0f) {
                            phi_1075_ = ((1f - _e148) - (((((_e738 * _e161) + (_e739 * _e163)) + (_e740 * _e165)) + (_e741 * _e167)) / (_e158 * (1f - (_e158 * _e721)))));
                        } else {
                            phi_1075_ = ((((((((_e627 * ((_e628 * _e172) + ((0.5f * _e629) * _e180))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e628 * ((_e629 * _e173) + ((0.5f * _e630) * _e181))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e629 * ((_e630 * _e174) + ((0.5f * _e627) * _e182))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e630 * ((_e627 * _e175) + ((0.5f * _e628) * _e183))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e648 * (-(_e158) * _e159))) + _e148) + (((((_e738 * _e75) + (_e739 * _e87)) + (_e740 * _e99)) + (_e741 * _e111)) / (_e159 * (1f - (_e721 * _e159)))));
                        }
                        let _e805 = phi_1075_;
                        phi_1076_ = _e805;
                    }
                    let _e807 = phi_1076_;
                    if ((bitcast<u32>(_e590) & 2147483647u) > 2139095040u) {
                        phi_1087_ = true;
                    } else {
                        let _e811 = (_e590 < _e807);
                        if _e811 {
                        }
                        phi_1087_ = _e811;
                    }
                    let _e813 = phi_1087_;
                    if _e813 {
                        phi_1091_ = _e590;
                    } else {
                        phi_1091_ = _e807;
                    }
                    let _e815 = phi_1091_;
                    phi_1092_ = _e815;
                } else {
                    phi_1092_ = _e590;
                }
                let _e817 = phi_1092_;
                if ((bitcast<u32>(_e817) & 2147483647u) > 2139095040u) {
                    phi_1109_ = _e817;
                } else {
                    if (_e817 < 0f) {
                        phi_1108_ = 0f;
                    } else {
                        if (_e817 > 1f) {
                            phi_1107_ = 1f;
                        } else {
                            phi_1107_ = _e817;
                        }
                        let _e824 = phi_1107_;
                        phi_1108_ = _e824;
                    }
                    let _e826 = phi_1108_;
                    phi_1109_ = _e826;
                }
                let _e828 = phi_1109_;
                phi_1110_ = f32();
                phi_1111_ = _e828;
            }
            let _e830 = phi_1110_;
            let _e832 = phi_1111_;
            phi_1112_ = _e830;
            phi_1113_ = _e832;
            phi_1114_ = _e435;
        }
        let _e834 = phi_1112_;
        let _e836 = phi_1113_;
        let _e838 = phi_1114_;
        phi_1115_ = _e834;
        phi_1116_ = _e836;
        phi_1117_ = _e838;
    }
    let _e840 = phi_1115_;
    let _e842 = phi_1116_;
    let _e844 = phi_1117_;
    if _e844 {
        phi_1121_ = _e840;
    } else {
        phi_1121_ = _e842;
    }
    let _e846 = phi_1121_;
    return _e846;
}

fn function_() {
    var local_1: f32;
    var phi_1176_: bool;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1183_: bool;
    var phi_1253_: bool;
    var phi_1254_: bool;
    var phi_1265_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1266_: bool;
    var phi_1267_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1268_: bool;
    var phi_1275_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1279_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1299_: lt_math_LightPoint;
    var phi_1302_: u32;
    var phi_1304_: lt_math_LevelPoint;
    var phi_1390_: bool;
    var phi_1399_: bool;
    var phi_1408_: bool;
    var phi_1409_: bool;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1418_: bool;
    var phi_1445_: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1448_: bool;
    var phi_1449_: bool;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1456_: bool;
    var phi_1465_: lt_math_LightPoint;
    var phi_1466_: u32;
    var phi_1467_: lt_math_LevelPoint;
    var phi_1468_: bool;
    var phi_1300_: lt_math_LightPoint;
    var phi_1303_: u32;
    var phi_1305_: lt_math_LevelPoint;
    var phi_1469_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1509_: bool;
    var phi_1510_: bool;
    var phi_1511_: bool;
    var phi_1512_: bool;
    var phi_1516_: bool;
    var phi_1598_: f32;
    var phi_1714_: f32;
    var phi_1715_: f32;
    var phi_1718_: f32;
    var phi_1747_: f32;
    var phi_1752_: f32;
    var phi_1753_: bool;
    var phi_1754_: f32;
    var phi_1755_: bool;
    var phi_1759_: f32;
    var phi_1779_: f32;
    var phi_1784_: f32;
    var phi_1785_: bool;
    var phi_1786_: f32;
    var phi_1787_: bool;
    var phi_1791_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1840_: i32;
    var phi_1845_: i32;
    var phi_1850_: i32;
    var phi_1855_: i32;
    var phi_1864_: i32;
    var phi_1869_: i32;
    var phi_1874_: i32;
    var phi_1879_: i32;
    var phi_1930_: bool;
    var phi_1938_: bool;
    var phi_1950_: bool;
    var phi_1951_: bool;
    var phi_1955_: f32;
    var phi_1961_: f32;
    var phi_1963_: evaluate_Verdict;
    var phi_1968_: evaluate_Verdict;
    var phi_1969_: evaluate_Verdict;
    var phi_1973_: bool;
    var phi_1974_: u32;
    var phi_1985_: u32;

    let _e48 = id_1;
    let _e49 = local_5;
    let _e54 = arrayLength((&map.member));
    let _e59 = arrayLength((&levels.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e48, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.level_count;
        let _e76 = samples.member[_e65.first_primitive].normal[0u];
        let _e78 = global[0u];
        if (_e76 == _e78) {
            let _e81 = samples.member[_e65.first_primitive].normal[1u];
            let _e83 = global[1u];
            if (_e81 == _e83) {
                let _e86 = samples.member[_e65.first_primitive].normal[2u];
                let _e88 = global[2u];
                phi_1176_ = (_e86 == _e88);
                phi_1177_ = false;
            } else {
                phi_1176_ = bool();
                phi_1177_ = true;
            }
            let _e91 = phi_1176_;
            let _e93 = phi_1177_;
            phi_1178_ = _e91;
            phi_1179_ = _e93;
        } else {
            phi_1178_ = bool();
            phi_1179_ = true;
        }
        let _e95 = phi_1178_;
        let _e97 = phi_1179_;
        if _e97 {
            phi_1183_ = false;
        } else {
            phi_1183_ = _e95;
        }
        let _e99 = phi_1183_;
        if !(_e99) {
            let _e102 = samples.member[_e65.first_primitive].position;
            let _e104 = p.member.light.place;
            let _e110 = p.member.light.place[3u];
            let _e117 = (_e104.x - (_e102.x * _e110));
            let _e118 = (_e104.y - (_e102.y * _e110));
            let _e119 = (_e104.z - (_e102.z * _e110));
            let _e121 = samples.member[_e65.first_primitive].normal;
            if ((((_e121.x * _e117) + (_e121.y * _e118)) + (_e121.z * _e119)) > 0f) {
                let _e135 = (((_e117 * _e117) + (_e118 * _e118)) + (_e119 * _e119));
                let _e137 = p.member.light.axis;
                let _e149 = p.member.light.place[3u];
                if (_e149 == 0f) {
                    phi_1254_ = true;
                } else {
                    let _e152 = p.member.light.range_squared;
                    if (_e135 <= _e152) {
                        let _e155 = p.member.light.cos_outer;
                        phi_1253_ = (-((((_e117 * _e137.x) + (_e118 * _e137.y)) + (_e119 * _e137.z))) >= (_e155 * sqrt(_e135)));
                    } else {
                        phi_1253_ = false;
                    }
                    let _e160 = phi_1253_;
                    phi_1254_ = _e160;
                }
                let _e162 = phi_1254_;
                if _e162 {
                    let _e164 = samples.member[_e65.first_primitive].flags;
                    let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e178 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e172.unnamed.visibility, false), _e172.unnamed_1);
                    phi_1265_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e178.unnamed, ((_e164 & 1u) == 0u));
                    phi_1266_ = false;
                } else {
                    phi_1265_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1266_ = true;
                }
                let _e183 = phi_1265_;
                let _e185 = phi_1266_;
                phi_1267_ = _e183;
                phi_1268_ = _e185;
            } else {
                phi_1267_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1268_ = true;
            }
            let _e187 = phi_1267_;
            let _e189 = phi_1268_;
            if _e189 {
                let _e195 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e201 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e195.unnamed.visibility, false), _e195.unnamed_1);
                phi_1275_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e201.unnamed, true);
            } else {
                phi_1275_ = _e187;
            }
            let _e206 = phi_1275_;
            phi_1279_ = _e206;
        } else {
            let _e212 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e218 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e212.unnamed.visibility, false), _e212.unnamed_1);
            phi_1279_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e218.unnamed, true);
        }
        let _e223 = phi_1279_;
        if _e223.unnamed_1 {
            phi_1969_ = evaluate_Verdict(_e223.unnamed.visibility, _e223.unnamed.is_doubted);
        } else {
            let _e231 = samples.member[_e65.first_primitive].position;
            let _e233 = p.member.map_size;
            let _e235 = (0.5f / f32(_e233));
            let _e242 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e249 = lt_math_LightPoint(vec2<f32>(_e242.uv.x, 0f), _e242.depth, _e242.is_inside);
            let _e253 = lt_math_LightPoint(_e249.uv, 0f, _e249.is_inside);
            phi_1299_ = lt_math_LightPoint();
            phi_1302_ = 0u;
            phi_1304_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e253.uv, _e253.depth, false));
            loop {
                let _e260 = phi_1299_;
                let _e262 = phi_1302_;
                let _e264 = phi_1304_;
                local_2 = _e264;
                local_3 = _e264;
                local_4 = _e264;
                if (_e262 < _e72) {
                    if _e264.point.is_inside {
                        phi_1465_ = lt_math_LightPoint();
                        phi_1466_ = u32();
                        phi_1467_ = lt_math_LevelPoint();
                        phi_1468_ = false;
                    } else {
                        if (_e262 < _e59) {
                        } else {
                            return;
                        }
                        let _e275 = levels.member[(0u + _e262)].row_w;
                        let _e286 = ((((_e275.x * _e231.x) + (_e275.y * _e231.y)) + (_e275.z * _e231.z)) + (_e275.w * 1f));
                        let _e288 = levels.member[(0u + _e262)].row_x;
                        let _e300 = (((((_e288.x * _e231.x) + (_e288.y * _e231.y)) + (_e288.z * _e231.z)) + (_e288.w * 1f)) / _e286);
                        let _e302 = levels.member[(0u + _e262)].row_y;
                        let _e314 = (((((_e302.x * _e231.x) + (_e302.y * _e231.y)) + (_e302.z * _e231.z)) + (_e302.w * 1f)) / _e286);
                        let _e316 = levels.member[(0u + _e262)].row_z;
                        let _e327 = ((((_e316.x * _e231.x) + (_e316.y * _e231.y)) + (_e316.z * _e231.z)) + (_e316.w * 1f));
                        if (_e286 > 0f) {
                            if (_e300 >= 0f) {
                                phi_1390_ = (_e300 <= 1f);
                            } else {
                                phi_1390_ = false;
                            }
                            let _e332 = phi_1390_;
                            if _e332 {
                                if (_e314 >= 0f) {
                                    phi_1399_ = (_e314 <= 1f);
                                } else {
                                    phi_1399_ = false;
                                }
                                let _e336 = phi_1399_;
                                if _e336 {
                                    if (_e327 >= 0f) {
                                        phi_1408_ = (_e327 <= 1f);
                                    } else {
                                        phi_1408_ = false;
                                    }
                                    let _e340 = phi_1408_;
                                    phi_1409_ = _e340;
                                    phi_1410_ = false;
                                } else {
                                    phi_1409_ = bool();
                                    phi_1410_ = true;
                                }
                                let _e342 = phi_1409_;
                                let _e344 = phi_1410_;
                                phi_1411_ = _e342;
                                phi_1412_ = _e344;
                            } else {
                                phi_1411_ = bool();
                                phi_1412_ = true;
                            }
                            let _e346 = phi_1411_;
                            let _e348 = phi_1412_;
                            phi_1413_ = _e346;
                            phi_1414_ = _e348;
                        } else {
                            phi_1413_ = bool();
                            phi_1414_ = true;
                        }
                        let _e350 = phi_1413_;
                        let _e352 = phi_1414_;
                        if _e352 {
                            phi_1418_ = false;
                        } else {
                            phi_1418_ = _e350;
                        }
                        let _e354 = phi_1418_;
                        if _e354 {
                            if (_e300 >= _e235) {
                                if (_e300 <= (1f - _e235)) {
                                    if (_e314 >= _e235) {
                                        phi_1445_ = (_e314 <= (1f - _e235));
                                        phi_1446_ = false;
                                    } else {
                                        phi_1445_ = bool();
                                        phi_1446_ = true;
                                    }
                                    let _e362 = phi_1445_;
                                    let _e364 = phi_1446_;
                                    phi_1447_ = _e362;
                                    phi_1448_ = _e364;
                                } else {
                                    phi_1447_ = bool();
                                    phi_1448_ = true;
                                }
                                let _e366 = phi_1447_;
                                let _e368 = phi_1448_;
                                phi_1449_ = _e366;
                                phi_1450_ = _e368;
                            } else {
                                phi_1449_ = bool();
                                phi_1450_ = true;
                            }
                            let _e370 = phi_1449_;
                            let _e372 = phi_1450_;
                            phi_1451_ = _e370;
                            phi_1452_ = _e372;
                        } else {
                            phi_1451_ = bool();
                            phi_1452_ = true;
                        }
                        let _e374 = phi_1451_;
                        let _e376 = phi_1452_;
                        if _e376 {
                            phi_1456_ = false;
                        } else {
                            phi_1456_ = _e374;
                        }
                        let _e378 = phi_1456_;
                        let _e385 = lt_math_LightPoint(vec2<f32>(_e300, _e260.uv.y), _e260.depth, _e260.is_inside);
                        let _e392 = lt_math_LightPoint(vec2<f32>(_e385.uv.x, _e314), _e385.depth, _e385.is_inside);
                        let _e396 = lt_math_LightPoint(_e392.uv, _e327, _e392.is_inside);
                        let _e400 = lt_math_LightPoint(_e396.uv, _e396.depth, _e378);
                        phi_1465_ = _e400;
                        phi_1466_ = (_e262 + 1u);
                        phi_1467_ = lt_math_LevelPoint(_e262, _e400);
                        phi_1468_ = true;
                    }
                    let _e404 = phi_1465_;
                    let _e406 = phi_1466_;
                    let _e408 = phi_1467_;
                    let _e410 = phi_1468_;
                    phi_1300_ = _e404;
                    phi_1303_ = _e406;
                    phi_1305_ = _e408;
                    phi_1469_ = _e410;
                } else {
                    phi_1300_ = lt_math_LightPoint();
                    phi_1303_ = u32();
                    phi_1305_ = lt_math_LevelPoint();
                    phi_1469_ = false;
                }
                let _e412 = phi_1300_;
                let _e414 = phi_1303_;
                let _e416 = phi_1305_;
                let _e418 = phi_1469_;
                continue;
                continuing {
                    phi_1299_ = _e412;
                    phi_1302_ = _e414;
                    phi_1304_ = _e416;
                    break if !(_e418);
                }
            }
            let _e421 = local_2;
            if _e421.point.is_inside {
                if (0f > 0f) {
                    let _e427 = local_3;
                    if (_e427.level < _e59) {
                    } else {
                        return;
                    }
                    let _e432 = levels.member[(0u + _e427.level)];
                    let _e438 = global[0u];
                    if (_e432.row_w.x == _e438) {
                        let _e441 = global[1u];
                        if (_e432.row_w.y == _e441) {
                            let _e444 = global[2u];
                            phi_1509_ = (_e432.row_w.z == _e444);
                            phi_1510_ = false;
                        } else {
                            phi_1509_ = bool();
                            phi_1510_ = true;
                        }
                        let _e447 = phi_1509_;
                        let _e449 = phi_1510_;
                        phi_1511_ = _e447;
                        phi_1512_ = _e449;
                    } else {
                        phi_1511_ = bool();
                        phi_1512_ = true;
                    }
                    let _e451 = phi_1511_;
                    let _e453 = phi_1512_;
                    if _e453 {
                        phi_1516_ = false;
                    } else {
                        phi_1516_ = _e451;
                    }
                    let _e455 = phi_1516_;
                    if _e455 {
                        let _e457 = samples.member[_e65.first_primitive].normal;
                        let _e459 = p.member.map_size;
                        let _e529 = ((abs(((((_e432.row_x.x * _e457.x) + (_e432.row_x.y * _e457.y)) + (_e432.row_x.z * _e457.z)) / (((_e432.row_x.x * _e432.row_x.x) + (_e432.row_x.y * _e432.row_x.y)) + (_e432.row_x.z * _e432.row_x.z)))) + abs(((((_e432.row_y.x * _e457.x) + (_e432.row_y.y * _e457.y)) + (_e432.row_y.z * _e457.z)) / (((_e432.row_y.x * _e432.row_y.x) + (_e432.row_y.y * _e432.row_y.y)) + (_e432.row_y.z * _e432.row_y.z))))) / (abs(((((_e432.row_z.x * _e457.x) + (_e432.row_z.y * _e457.y)) + (_e432.row_z.z * _e457.z)) / (((_e432.row_z.x * _e432.row_z.x) + (_e432.row_z.y * _e432.row_z.y)) + (_e432.row_z.z * _e432.row_z.z)))) * f32(_e459)));
                        if (_e529 < 0.002f) {
                            phi_1598_ = _e529;
                        } else {
                            phi_1598_ = 0.002f;
                        }
                        let _e532 = phi_1598_;
                        phi_1715_ = _e532;
                    } else {
                        let _e534 = p.member.map_size;
                        let _e540 = samples.member[_e65.first_primitive].position;
                        let _e551 = ((((_e432.row_w.x * _e540.x) + (_e432.row_w.y * _e540.y)) + (_e432.row_w.z * _e540.z)) + _e432.row_w.w);
                        let _e564 = ((_e432.row_x.x - (_e432.row_w.x * _e421.point.uv.x)) / _e551);
                        let _e565 = ((_e432.row_x.y - (_e432.row_w.y * _e421.point.uv.x)) / _e551);
                        let _e566 = ((_e432.row_x.z - (_e432.row_w.z * _e421.point.uv.x)) / _e551);
                        let _e579 = ((_e432.row_y.x - (_e432.row_w.x * _e421.point.uv.y)) / _e551);
                        let _e580 = ((_e432.row_y.y - (_e432.row_w.y * _e421.point.uv.y)) / _e551);
                        let _e581 = ((_e432.row_y.z - (_e432.row_w.z * _e421.point.uv.y)) / _e551);
                        let _e587 = samples.member[_e65.first_primitive].normal;
                        let _e592 = ((_e580 * _e587.z) - (_e587.y * _e581));
                        let _e597 = ((_e581 * _e587.x) - (_e587.z * _e579));
                        let _e602 = ((_e579 * _e587.y) - (_e587.x * _e580));
                        let _e604 = samples.member[_e65.first_primitive].normal;
                        let _e609 = ((_e565 * _e604.z) - (_e604.y * _e566));
                        let _e614 = ((_e566 * _e604.x) - (_e604.z * _e564));
                        let _e619 = ((_e564 * _e604.y) - (_e604.x * _e565));
                        let _e646 = ((abs(((((_e432.row_z.x * _e592) + (_e432.row_z.y * _e597)) + (_e432.row_z.z * _e602)) / (((_e564 * _e592) + (_e565 * _e597)) + (_e566 * _e602)))) + abs(((((_e432.row_z.x * _e609) + (_e432.row_z.y * _e614)) + (_e432.row_z.z * _e619)) / (((_e579 * _e609) + (_e580 * _e614)) + (_e581 * _e619))))) / f32(_e534));
                        if (_e646 < 0.002f) {
                            phi_1714_ = _e646;
                        } else {
                            phi_1714_ = 0.002f;
                        }
                        let _e649 = phi_1714_;
                        phi_1715_ = _e649;
                    }
                    let _e651 = phi_1715_;
                    phi_1718_ = (_e421.point.depth - (0f * _e651));
                } else {
                    phi_1718_ = _e421.point.depth;
                }
                let _e655 = phi_1718_;
                let _e661 = p.member.map_size;
                let _e662 = f32(_e661);
                let _e665 = ((_e421.point.uv.x * _e662) - 0.5f);
                let _e666 = ((_e421.point.uv.y * _e662) - 0.5f);
                if (_e665 > -8388608f) {
                    let _e678 = f32(select(0i, select(select(i32(_e665), i32(-2147483648), (_e665 < bitcast<f32>(3472883712u))), 2147483647i, (_e665 > bitcast<f32>(1325400063u))), (_e665 == _e665)));
                    if (_e678 > _e665) {
                        phi_1747_ = 1f;
                    } else {
                        phi_1747_ = 0f;
                    }
                    let _e681 = phi_1747_;
                    if (_e665 < 8388608f) {
                        phi_1752_ = (_e678 - _e681);
                        phi_1753_ = false;
                    } else {
                        phi_1752_ = f32();
                        phi_1753_ = true;
                    }
                    let _e684 = phi_1752_;
                    let _e686 = phi_1753_;
                    phi_1754_ = _e684;
                    phi_1755_ = _e686;
                } else {
                    phi_1754_ = f32();
                    phi_1755_ = true;
                }
                let _e688 = phi_1754_;
                let _e690 = phi_1755_;
                if _e690 {
                    phi_1759_ = _e665;
                } else {
                    phi_1759_ = _e688;
                }
                let _e692 = phi_1759_;
                if (_e666 > -8388608f) {
                    let _e704 = f32(select(0i, select(select(i32(_e666), i32(-2147483648), (_e666 < bitcast<f32>(3472883712u))), 2147483647i, (_e666 > bitcast<f32>(1325400063u))), (_e666 == _e666)));
                    if (_e704 > _e666) {
                        phi_1779_ = 1f;
                    } else {
                        phi_1779_ = 0f;
                    }
                    let _e707 = phi_1779_;
                    if (_e666 < 8388608f) {
                        phi_1784_ = (_e704 - _e707);
                        phi_1785_ = false;
                    } else {
                        phi_1784_ = f32();
                        phi_1785_ = true;
                    }
                    let _e710 = phi_1784_;
                    let _e712 = phi_1785_;
                    phi_1786_ = _e710;
                    phi_1787_ = _e712;
                } else {
                    phi_1786_ = f32();
                    phi_1787_ = true;
                }
                let _e714 = phi_1786_;
                let _e716 = phi_1787_;
                if _e716 {
                    phi_1791_ = _e666;
                } else {
                    phi_1791_ = _e714;
                }
                let _e718 = phi_1791_;
                let _e719 = (_e665 - _e692);
                let _e720 = (_e666 - _e718);
                let _e729 = select(0i, select(select(i32(_e692), i32(-2147483648), (_e692 < bitcast<f32>(3472883712u))), 2147483647i, (_e692 > bitcast<f32>(1325400063u))), (_e692 == _e692));
                let _e738 = select(0i, select(select(i32(_e718), i32(-2147483648), (_e718 < bitcast<f32>(3472883712u))), 2147483647i, (_e718 > bitcast<f32>(1325400063u))), (_e718 == _e718));
                let _e749 = p.member.test;
                let _e750 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e749);
                let _e752 = p.member.map_size;
                let _e754 = local_4;
                local_1 = _e750;
                let _e757 = ((_e754.level * _e752) * _e752);
                let _e759 = (bitcast<i32>(_e752) - 1i);
                if (_e729 > 0i) {
                    phi_1840_ = _e729;
                } else {
                    phi_1840_ = 0i;
                }
                let _e762 = phi_1840_;
                if (_e738 > 0i) {
                    phi_1845_ = _e738;
                } else {
                    phi_1845_ = 0i;
                }
                let _e765 = phi_1845_;
                if (_e762 < _e759) {
                    phi_1850_ = _e762;
                } else {
                    phi_1850_ = _e759;
                }
                let _e768 = phi_1850_;
                if (_e765 < _e759) {
                    phi_1855_ = _e765;
                } else {
                    phi_1855_ = _e759;
                }
                let _e771 = phi_1855_;
                let _e772 = bitcast<u32>(_e768);
                let _e774 = (_e729 + 1i);
                let _e775 = (_e738 + 1i);
                if (_e774 > 0i) {
                    phi_1864_ = _e774;
                } else {
                    phi_1864_ = 0i;
                }
                let _e778 = phi_1864_;
                if (_e775 > 0i) {
                    phi_1869_ = _e775;
                } else {
                    phi_1869_ = 0i;
                }
                let _e781 = phi_1869_;
                if (_e778 < _e759) {
                    phi_1874_ = _e778;
                } else {
                    phi_1874_ = _e759;
                }
                let _e784 = phi_1874_;
                if (_e781 < _e759) {
                    phi_1879_ = _e781;
                } else {
                    phi_1879_ = _e759;
                }
                let _e787 = phi_1879_;
                let _e788 = bitcast<u32>(_e784);
                let _e790 = (bitcast<u32>(_e771) * _e752);
                let _e791 = (bitcast<u32>(_e787) * _e752);
                let _e796 = ((_e790 + _e772) + _e757);
                let _e797 = ((_e790 + _e788) + _e757);
                let _e798 = ((_e791 + _e772) + _e757);
                let _e799 = ((_e791 + _e788) + _e757);
                if (_e796 < _e54) {
                } else {
                    return;
                }
                let _e803 = map.member[(0u + _e796)];
                if (_e797 < _e54) {
                } else {
                    return;
                }
                let _e807 = map.member[(0u + _e797)];
                if (_e798 < _e54) {
                } else {
                    return;
                }
                let _e811 = map.member[(0u + _e798)];
                if (_e799 < _e54) {
                } else {
                    return;
                }
                let _e815 = map.member[(0u + _e799)];
                let _e817 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e803, _e807, _e811, _e815), vec4<f32>(((1f - _e719) * (1f - _e720)), (_e719 * (1f - _e720)), ((1f - _e719) * _e720), (_e719 * _e720)), _e655);
                let _e819 = p.member.epsilon;
                if (_e817 <= _e819) {
                    phi_1930_ = true;
                } else {
                    phi_1930_ = (_e817 >= (1f - _e819));
                }
                let _e824 = phi_1930_;
                if ((bitcast<u32>(_e817) & 2147483647u) > 2139095040u) {
                    phi_1938_ = true;
                } else {
                    phi_1938_ = !(_e824);
                }
                let _e830 = phi_1938_;
                if _e830 {
                    if (_e817 > 0f) {
                        if (_e817 < 1f) {
                            phi_1950_ = false;
                        } else {
                            phi_1950_ = true;
                        }
                        let _e834 = phi_1950_;
                        phi_1951_ = _e834;
                    } else {
                        phi_1951_ = true;
                    }
                    let _e836 = phi_1951_;
                    if _e836 {
                        phi_1955_ = 0.5f;
                    } else {
                        phi_1955_ = _e817;
                    }
                    let _e838 = phi_1955_;
                    phi_1963_ = evaluate_Verdict(_e838, true);
                } else {
                    if (_e817 > 0.5f) {
                        phi_1961_ = 1f;
                    } else {
                        phi_1961_ = 0f;
                    }
                    let _e842 = phi_1961_;
                    phi_1963_ = evaluate_Verdict(_e842, false);
                }
                let _e845 = phi_1963_;
                phi_1968_ = evaluate_Verdict(_e845.visibility, _e845.is_doubted);
            } else {
                phi_1968_ = evaluate_Verdict(0.5f, true);
            }
            let _e851 = phi_1968_;
            phi_1969_ = _e851;
        }
        let _e853 = phi_1969_;
        visibility.member[_e65.first_primitive] = _e853.visibility;
        phi_1973_ = _e853.is_doubted;
        phi_1974_ = _e65.first_primitive;
    } else {
        phi_1973_ = false;
        phi_1974_ = 0u;
    }
    let _e858 = phi_1973_;
    let _e860 = phi_1974_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e858 {
        let _e864 = atomicAdd((&shared_[0u]), 1u);
        phi_1985_ = _e864;
    } else {
        phi_1985_ = 0u;
    }
    let _e866 = phi_1985_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e870 = atomicLoad((&shared_[0u]));
        let _e871 = atomicAdd((&list.member[3u]), _e870);
        atomicStore((&shared_[1u]), _e871);
    }
    workgroupBarrier();
    if _e858 {
        let _e874 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e874) + _e866)]), _e860);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
