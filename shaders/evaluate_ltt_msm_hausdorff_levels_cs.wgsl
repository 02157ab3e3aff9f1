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
    var phi_162_: lt_bvh_traverse_Tree;
    var phi_163_: bool;
    var phi_164_: lt_bvh_traverse_Tree;
    var phi_165_: bool;
    var phi_170_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_162_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_163_ = false;
        } else {
            phi_162_ = lt_bvh_traverse_Tree();
            phi_163_ = true;
        }
        let _e60 = phi_162_;
        let _e62 = phi_163_;
        phi_164_ = _e60;
        phi_165_ = _e62;
    } else {
        phi_164_ = lt_bvh_traverse_Tree();
        phi_165_ = true;
    }
    let _e64 = phi_164_;
    let _e66 = phi_165_;
    if _e66 {
        phi_170_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_170_ = _e64;
    }
    let _e71 = phi_170_;
    return lt_bvh_traverse_Tree(_e71.root, _e71.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_197_: f32;
    var phi_198_: f32;
    var phi_199_: f32;
    var phi_216_: f32;
    var phi_217_: f32;
    var phi_218_: f32;
    var phi_234_: f32;
    var phi_235_: f32;
    var phi_236_: f32;
    var phi_252_: f32;
    var phi_253_: f32;
    var phi_254_: f32;
    var phi_270_: f32;
    var phi_271_: f32;
    var phi_272_: f32;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_316_: bool;
    var phi_627_: f32;
    var phi_628_: f32;
    var phi_629_: f32;
    var phi_646_: f32;
    var phi_647_: f32;
    var phi_648_: f32;
    var phi_665_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_684_: f32;
    var phi_685_: f32;
    var phi_686_: f32;
    var phi_709_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_722_: f32;
    var phi_737_: f32;
    var phi_739_: lt_bvh_slab_Span;
    var phi_797_: f32;
    var phi_798_: f32;
    var phi_799_: f32;
    var phi_800_: f32;
    var phi_801_: f32;
    var phi_802_: bool;
    var phi_806_: f32;
    var phi_816_: bool;
    var phi_829_: bool;
    var phi_833_: bool;
    var phi_834_: bool;
    var phi_844_: bool;
    var phi_845_: bool;
    var phi_846_: bool;
    var phi_850_: bool;
    var phi_901_: f32;
    var phi_902_: f32;
    var phi_903_: f32;
    var phi_920_: f32;
    var phi_921_: f32;
    var phi_922_: f32;
    var phi_939_: f32;
    var phi_940_: f32;
    var phi_941_: f32;
    var phi_958_: f32;
    var phi_959_: f32;
    var phi_960_: f32;
    var phi_983_: f32;
    var phi_984_: f32;
    var phi_985_: f32;
    var phi_1072_: f32;
    var phi_1073_: f32;
    var phi_1084_: bool;
    var phi_1088_: f32;
    var phi_1089_: f32;
    var phi_1104_: f32;
    var phi_1105_: f32;
    var phi_1106_: f32;
    var phi_1107_: f32;
    var phi_1108_: f32;
    var phi_1109_: f32;
    var phi_1110_: f32;
    var phi_1111_: bool;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_1114_: bool;
    var phi_1118_: f32;

    let _e51 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_199_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_198_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_197_ = 1f;
            } else {
                phi_197_ = param_7;
            }
            let _e58 = phi_197_;
            phi_198_ = _e58;
        }
        let _e60 = phi_198_;
        phi_199_ = _e60;
    }
    let _e62 = phi_199_;
    let _e63 = (_e62 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_218_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_217_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_216_ = 1f;
            } else {
                phi_216_ = param_5.x;
            }
            let _e71 = phi_216_;
            phi_217_ = _e71;
        }
        let _e73 = phi_217_;
        phi_218_ = _e73;
    }
    let _e75 = phi_218_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_236_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_235_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_234_ = 1f;
            } else {
                phi_234_ = param_5.y;
            }
            let _e83 = phi_234_;
            phi_235_ = _e83;
        }
        let _e85 = phi_235_;
        phi_236_ = _e85;
    }
    let _e87 = phi_236_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_254_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_253_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_252_ = 1f;
            } else {
                phi_252_ = param_5.z;
            }
            let _e95 = phi_252_;
            phi_253_ = _e95;
        }
        let _e97 = phi_253_;
        phi_254_ = _e97;
    }
    let _e99 = phi_254_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_272_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_271_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_270_ = 1f;
            } else {
                phi_270_ = param_5.w;
            }
            let _e107 = phi_270_;
            phi_271_ = _e107;
        }
        let _e109 = phi_271_;
        phi_272_ = _e109;
    }
    let _e111 = phi_272_;
    let _e112 = (_e75 - _e63);
    let _e113 = (_e87 - _e63);
    let _e114 = (_e99 - _e63);
    let _e115 = (_e111 - _e63);
    let _e126 = ((((_e112 * param_6.x) + (_e113 * param_6.y)) + (_e114 * param_6.z)) + (_e115 * param_6.w));
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_1112_ = _e126;
        phi_1113_ = f32();
        phi_1114_ = true;
    } else {
        if (_e112 >= 0f) {
            if (_e113 >= 0f) {
                if (_e114 >= 0f) {
                    phi_307_ = (_e115 >= 0f);
                    phi_308_ = false;
                } else {
                    phi_307_ = bool();
                    phi_308_ = true;
                }
                let _e135 = phi_307_;
                let _e137 = phi_308_;
                phi_309_ = _e135;
                phi_310_ = _e137;
            } else {
                phi_309_ = bool();
                phi_310_ = true;
            }
            let _e139 = phi_309_;
            let _e141 = phi_310_;
            phi_311_ = _e139;
            phi_312_ = _e141;
        } else {
            phi_311_ = bool();
            phi_312_ = true;
        }
        let _e143 = phi_311_;
        let _e145 = phi_312_;
        if _e145 {
            phi_316_ = false;
        } else {
            phi_316_ = _e143;
        }
        let _e147 = phi_316_;
        if _e147 {
            phi_1109_ = 1f;
            phi_1110_ = f32();
            phi_1111_ = true;
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
                    phi_629_ = _e112;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_628_ = 0f;
                    } else {
                        if (_e112 < 0f) {
                            phi_627_ = 0f;
                        } else {
                            phi_627_ = 1f;
                        }
                        let _e444 = phi_627_;
                        phi_628_ = _e444;
                    }
                    let _e446 = phi_628_;
                    phi_629_ = _e446;
                }
                let _e448 = phi_629_;
                if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                    phi_648_ = _e113;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_647_ = 0f;
                    } else {
                        if (_e113 < 0f) {
                            phi_646_ = 0f;
                        } else {
                            phi_646_ = 1f;
                        }
                        let _e457 = phi_646_;
                        phi_647_ = _e457;
                    }
                    let _e459 = phi_647_;
                    phi_648_ = _e459;
                }
                let _e461 = phi_648_;
                if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                    phi_667_ = _e114;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_666_ = 0f;
                    } else {
                        if (_e114 < 0f) {
                            phi_665_ = 0f;
                        } else {
                            phi_665_ = 1f;
                        }
                        let _e470 = phi_665_;
                        phi_666_ = _e470;
                    }
                    let _e472 = phi_666_;
                    phi_667_ = _e472;
                }
                let _e474 = phi_667_;
                if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                    phi_686_ = _e115;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_685_ = 0f;
                    } else {
                        if (_e115 < 0f) {
                            phi_684_ = 0f;
                        } else {
                            phi_684_ = 1f;
                        }
                        let _e483 = phi_684_;
                        phi_685_ = _e483;
                    }
                    let _e485 = phi_685_;
                    phi_686_ = _e485;
                }
                let _e487 = phi_686_;
                let _e495 = (((((_e448 * _e151) + (_e461 * _e153)) + (_e474 * _e155)) + (_e487 * _e157)) + _e148);
                if ((bitcast<u32>(_e495) & 2147483647u) > 2139095040u) {
                    phi_711_ = _e495;
                } else {
                    if (_e495 < 0f) {
                        phi_710_ = 0f;
                    } else {
                        if (_e495 > 1f) {
                            phi_709_ = 1f;
                        } else {
                            phi_709_ = _e495;
                        }
                        let _e502 = phi_709_;
                        phi_710_ = _e502;
                    }
                    let _e504 = phi_710_;
                    phi_711_ = _e504;
                }
                let _e506 = phi_711_;
                phi_1107_ = _e506;
                phi_1108_ = f32();
            } else {
                let _e508 = ((0.5f * -(((((((((_e212 * (_e112 + _e113)) + (_e216 * (_e112 + _e114))) + (_e240 * (_e112 + _e158))) + (_e252 * (_e112 + _e159))) + ((((_e213 * (_e113 + _e114)) + (_e217 * (_e113 + _e115))) + (_e241 * (_e113 + _e158))) + (_e253 * (_e113 + _e159)))) + ((((_e214 * (_e114 + _e115)) + (_e218 * (_e114 + _e112))) + (_e242 * (_e114 + _e158))) + (_e254 * (_e114 + _e159)))) + ((((_e215 * (_e115 + _e112)) + (_e219 * (_e115 + _e113))) + (_e243 * (_e115 + _e158))) + (_e255 * (_e115 + _e159)))) + (_e426 * (_e158 + _e159))))) / _e429);
                let _e509 = ((((((((_e212 + _e216) + _e240) + _e252) + (((_e213 + _e217) + _e241) + _e253)) + (((_e214 + _e218) + _e242) + _e254)) + (((_e215 + _e219) + _e243) + _e255)) + _e426) / _e429);
                let _e511 = ((_e508 * _e508) - _e509);
                if (_e511 > 0f) {
                    phi_722_ = sqrt(_e511);
                } else {
                    phi_722_ = 0f;
                }
                let _e515 = phi_722_;
                if (_e508 > 0f) {
                    let _e518 = (-(_e508) - _e515);
                    phi_739_ = lt_bvh_slab_Span(_e518, (_e509 / _e518));
                } else {
                    let _e521 = (_e515 - _e508);
                    if (_e521 > 0f) {
                        phi_737_ = (_e509 / _e521);
                    } else {
                        phi_737_ = 0f;
                    }
                    let _e525 = phi_737_;
                    phi_739_ = lt_bvh_slab_Span(_e525, _e521);
                }
                let _e528 = phi_739_;
                if (_e528.near >= 0f) {
                    phi_800_ = 1f;
                    phi_801_ = f32();
                    phi_802_ = true;
                } else {
                    let _e532 = (_e528.far <= 0f);
                    if _e532 {
                        phi_798_ = (_e423 / _e429);
                        phi_799_ = f32();
                    } else {
                        let _e543 = (((((_e151 * _e112) + (_e153 * _e113)) + (_e155 * _e114)) + (_e157 * _e115)) + (_e148 * (_e158 + _e159)));
                        let _e559 = (((((_e151 * (_e112 * _e112)) + (_e153 * (_e113 * _e113))) + (_e155 * (_e114 * _e114))) + (_e157 * (_e115 * _e115))) + (_e148 * ((_e158 * _e158) + (_e159 * _e159))));
                        if (-(_e528.near) <= _e528.far) {
                            phi_797_ = (1f - (((_e528.near * _e528.near) * ((_e528.far * _e559) - _e543)) / (_e528.far - _e528.near)));
                        } else {
                            phi_797_ = ((_e423 / _e429) + (((_e528.far * _e528.far) * (_e543 - (_e528.near * _e559))) / (_e528.far - _e528.near)));
                        }
                        let _e578 = phi_797_;
                        phi_798_ = f32();
                        phi_799_ = _e578;
                    }
                    let _e580 = phi_798_;
                    let _e582 = phi_799_;
                    phi_800_ = _e580;
                    phi_801_ = _e582;
                    phi_802_ = _e532;
                }
                let _e584 = phi_800_;
                let _e586 = phi_801_;
                let _e588 = phi_802_;
                if _e588 {
                    phi_806_ = _e584;
                } else {
                    phi_806_ = _e586;
                }
                let _e590 = phi_806_;
                if ((_e528.near * _e158) >= (1f - 0.00001f)) {
                    phi_816_ = true;
                } else {
                    phi_816_ = ((_e528.near * _e159) >= (1f - 0.00001f));
                }
                let _e598 = phi_816_;
                if _e598 {
                    if ((_e528.far * _e158) >= (1f - 0.00001f)) {
                        phi_829_ = true;
                    } else {
                        phi_829_ = ((_e528.far * _e159) >= (1f - 0.00001f));
                    }
                    let _e606 = phi_829_;
                    if _e606 {
                        phi_833_ = false;
                    } else {
                        phi_833_ = true;
                    }
                    let _e608 = phi_833_;
                    phi_834_ = _e608;
                } else {
                    phi_834_ = true;
                }
                let _e610 = phi_834_;
                if _e610 {
                    let _e612 = (-(_e158) < 0.0001f);
                    if _e612 {
                        phi_844_ = bool();
                    } else {
                        phi_844_ = (_e159 < 0.0001f);
                    }
                    let _e615 = phi_844_;
                    phi_845_ = _e615;
                    phi_846_ = _e612;
                } else {
                    phi_845_ = bool();
                    phi_846_ = true;
                }
                let _e617 = phi_845_;
                let _e619 = phi_846_;
                if _e619 {
                    phi_850_ = true;
                } else {
                    phi_850_ = _e617;
                }
                let _e621 = phi_850_;
                if !(_e621) {
                    let _e627 = ((_e151 * _e75) * _e161);
                    let _e628 = ((_e153 * _e87) * _e163);
                    let _e629 = ((_e155 * _e99) * _e165);
                    let _e630 = ((_e157 * _e111) * _e167);
                    let _e648 = ((((_e627 * (_e112 * _e112)) + (_e628 * (_e113 * _e113))) + (_e629 * (_e114 * _e114))) + (_e630 * (_e115 * _e115)));
                    if (_e648 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e112) & 2147483647u) > 2139095040u) {
                            phi_903_ = _e112;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_902_ = 0f;
                            } else {
                                if (_e112 < 0f) {
                                    phi_901_ = 0f;
                                } else {
                                    phi_901_ = 1f;
                                }
                                let _e658 = phi_901_;
                                phi_902_ = _e658;
                            }
                            let _e660 = phi_902_;
                            phi_903_ = _e660;
                        }
                        let _e662 = phi_903_;
                        if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                            phi_922_ = _e113;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_921_ = 0f;
                            } else {
                                if (_e113 < 0f) {
                                    phi_920_ = 0f;
                                } else {
                                    phi_920_ = 1f;
                                }
                                let _e671 = phi_920_;
                                phi_921_ = _e671;
                            }
                            let _e673 = phi_921_;
                            phi_922_ = _e673;
                        }
                        let _e675 = phi_922_;
                        if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                            phi_941_ = _e114;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_940_ = 0f;
                            } else {
                                if (_e114 < 0f) {
                                    phi_939_ = 0f;
                                } else {
                                    phi_939_ = 1f;
                                }
                                let _e684 = phi_939_;
                                phi_940_ = _e684;
                            }
                            let _e686 = phi_940_;
                            phi_941_ = _e686;
                        }
                        let _e688 = phi_941_;
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_960_ = _e115;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_959_ = 0f;
                            } else {
                                if (_e115 < 0f) {
                                    phi_958_ = 0f;
                                } else {
                                    phi_958_ = 1f;
                                }
                                let _e697 = phi_958_;
                                phi_959_ = _e697;
                            }
                            let _e699 = phi_959_;
                            phi_960_ = _e699;
                        }
                        let _e701 = phi_960_;
                        let _e709 = (((((_e662 * _e151) + (_e675 * _e153)) + (_e688 * _e155)) + (_e701 * _e157)) + _e148);
                        if ((bitcast<u32>(_e709) & 2147483647u) > 2139095040u) {
                            phi_985_ = _e709;
                        } else {
                            if (_e709 < 0f) {
                                phi_984_ = 0f;
                            } else {
                                if (_e709 > 1f) {
                                    phi_983_ = 1f;
                                } else {
                                    phi_983_ = _e709;
                                }
                                let _e716 = phi_983_;
                                phi_984_ = _e716;
                            }
                            let _e718 = phi_984_;
                            phi_985_ = _e718;
                        }
                        let _e720 = phi_985_;
                        phi_1073_ = _e720;
                    } else {
                        let _e721 = (((((_e627 * _e112) + (_e628 * _e113)) + (_e629 * _e114)) + (_e630 * _e115)) / _e648);
                        let _e738 = ((_e151 * _e112) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e721 * _e112)));
                        let _e739 = ((_e153 * _e113) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e721 * _e113)));
                        let _e740 = ((_e155 * _e114) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e721 * _e114)));
                        let _e741 = ((_e157 * _e115) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e721 * _e115)));
                        if (_e721 > 0f) {
                            phi_1072_ = ((1f - _e148) - (((((_e738 * _e161) + (_e739 * _e163)) + (_e740 * _e165)) + (_e741 * _e167)) / (_e158 * (1f - (_e158 * _e721)))));
                        } else {
                            phi_1072_ = ((((((((_e627 * ((_e628 * _e172) + ((0.5f * _e629) * _e180))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e628 * ((_e629 * _e173) + ((0.5f * _e630) * _e181))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e629 * ((_e630 * _e174) + ((0.5f * _e627) * _e182))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e630 * ((_e627 * _e175) + ((0.5f * _e628) * _e183))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e648 * (-(_e158) * _e159))) + _e148) + (((((_e738 * _e75) + (_e739 * _e87)) + (_e740 * _e99)) + (_e741 * _e111)) / (_e159 * (1f - (_e721 * _e159)))));
                        }
                        let _e805 = phi_1072_;
                        phi_1073_ = _e805;
                    }
                    let _e807 = phi_1073_;
                    if ((bitcast<u32>(_e590) & 2147483647u) > 2139095040u) {
                        phi_1084_ = true;
                    } else {
                        let _e811 = (_e590 < _e807);
                        if _e811 {
                        }
                        phi_1084_ = _e811;
                    }
                    let _e813 = phi_1084_;
                    if _e813 {
                        phi_1088_ = _e590;
                    } else {
                        phi_1088_ = _e807;
                    }
                    let _e815 = phi_1088_;
                    phi_1089_ = _e815;
                } else {
                    phi_1089_ = _e590;
                }
                let _e817 = phi_1089_;
                if ((bitcast<u32>(_e817) & 2147483647u) > 2139095040u) {
                    phi_1106_ = _e817;
                } else {
                    if (_e817 < 0f) {
                        phi_1105_ = 0f;
                    } else {
                        if (_e817 > 1f) {
                            phi_1104_ = 1f;
                        } else {
                            phi_1104_ = _e817;
                        }
                        let _e824 = phi_1104_;
                        phi_1105_ = _e824;
                    }
                    let _e826 = phi_1105_;
                    phi_1106_ = _e826;
                }
                let _e828 = phi_1106_;
                phi_1107_ = f32();
                phi_1108_ = _e828;
            }
            let _e830 = phi_1107_;
            let _e832 = phi_1108_;
            phi_1109_ = _e830;
            phi_1110_ = _e832;
            phi_1111_ = _e435;
        }
        let _e834 = phi_1109_;
        let _e836 = phi_1110_;
        let _e838 = phi_1111_;
        phi_1112_ = _e834;
        phi_1113_ = _e836;
        phi_1114_ = _e838;
    }
    let _e840 = phi_1112_;
    let _e842 = phi_1113_;
    let _e844 = phi_1114_;
    if _e844 {
        phi_1118_ = _e840;
    } else {
        phi_1118_ = _e842;
    }
    let _e846 = phi_1118_;
    return _e846;
}

fn function_() {
    var local_1: f32;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1177_: bool;
    var phi_1181_: bool;
    var phi_1225_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1229_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1249_: lt_math_LightPoint;
    var phi_1252_: u32;
    var phi_1254_: lt_math_LevelPoint;
    var phi_1340_: bool;
    var phi_1349_: bool;
    var phi_1358_: bool;
    var phi_1359_: bool;
    var phi_1360_: bool;
    var phi_1361_: bool;
    var phi_1362_: bool;
    var phi_1363_: bool;
    var phi_1364_: bool;
    var phi_1368_: bool;
    var phi_1395_: bool;
    var phi_1396_: bool;
    var phi_1397_: bool;
    var phi_1398_: bool;
    var phi_1399_: bool;
    var phi_1400_: bool;
    var phi_1401_: bool;
    var phi_1402_: bool;
    var phi_1406_: bool;
    var phi_1415_: lt_math_LightPoint;
    var phi_1416_: u32;
    var phi_1417_: lt_math_LevelPoint;
    var phi_1418_: bool;
    var phi_1250_: lt_math_LightPoint;
    var phi_1253_: u32;
    var phi_1255_: lt_math_LevelPoint;
    var phi_1419_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1459_: bool;
    var phi_1460_: bool;
    var phi_1461_: bool;
    var phi_1462_: bool;
    var phi_1466_: bool;
    var phi_1548_: f32;
    var phi_1664_: f32;
    var phi_1665_: f32;
    var phi_1668_: f32;
    var phi_1697_: f32;
    var phi_1702_: f32;
    var phi_1703_: bool;
    var phi_1704_: f32;
    var phi_1705_: bool;
    var phi_1709_: f32;
    var phi_1729_: f32;
    var phi_1734_: f32;
    var phi_1735_: bool;
    var phi_1736_: f32;
    var phi_1737_: bool;
    var phi_1741_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1790_: i32;
    var phi_1795_: i32;
    var phi_1800_: i32;
    var phi_1805_: i32;
    var phi_1814_: i32;
    var phi_1819_: i32;
    var phi_1824_: i32;
    var phi_1829_: i32;
    var phi_1880_: bool;
    var phi_1888_: bool;
    var phi_1900_: bool;
    var phi_1901_: bool;
    var phi_1905_: f32;
    var phi_1911_: f32;
    var phi_1913_: evaluate_Verdict;
    var phi_1918_: evaluate_Verdict;
    var phi_1919_: evaluate_Verdict;
    var phi_1923_: bool;
    var phi_1924_: u32;
    var phi_1935_: u32;

    let _e48 = id_1;
    let _e49 = local_5;
    let _e54 = arrayLength((&map.member));
    let _e59 = arrayLength((&levels.member));
    let _e62 = p.member.size[0u];
    let _e64 = p.member.size[1u];
    let _e65 = lt_shaders_entry_pixel_index(_e48, _e62, _e64);
    if (bitcast<i32>(_e65.root) != 0i) {
        let _e72 = p.member.level_count;
        let _e74 = p.member.light;
        let _e77 = samples.member[_e65.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e65.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e65.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_1174_ = (_e87 == _e89);
                phi_1175_ = false;
            } else {
                phi_1174_ = bool();
                phi_1175_ = true;
            }
            let _e92 = phi_1174_;
            let _e94 = phi_1175_;
            phi_1176_ = _e92;
            phi_1177_ = _e94;
        } else {
            phi_1176_ = bool();
            phi_1177_ = true;
        }
        let _e96 = phi_1176_;
        let _e98 = phi_1177_;
        if _e98 {
            phi_1181_ = false;
        } else {
            phi_1181_ = _e96;
        }
        let _e100 = phi_1181_;
        if !(_e100) {
            let _e103 = samples.member[_e65.first_primitive].normal;
            let _e105 = samples.member[_e65.first_primitive].position;
            if ((((_e103.x * (_e74.x - (_e105.x * _e74.w))) + (_e103.y * (_e74.y - (_e105.y * _e74.w)))) + (_e103.z * (_e74.z - (_e105.z * _e74.w)))) > 0f) {
                let _e129 = samples.member[_e65.first_primitive].flags;
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_1225_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, ((_e129 & 1u) == 0u));
            } else {
                let _e152 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e158 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e152.unnamed.visibility, false), _e152.unnamed_1);
                phi_1225_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e158.unnamed, true);
            }
            let _e163 = phi_1225_;
            phi_1229_ = _e163;
        } else {
            let _e169 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e169.unnamed.visibility, false), _e169.unnamed_1);
            phi_1229_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e175.unnamed, true);
        }
        let _e180 = phi_1229_;
        if _e180.unnamed_1 {
            phi_1919_ = evaluate_Verdict(_e180.unnamed.visibility, _e180.unnamed.is_doubted);
        } else {
            let _e188 = samples.member[_e65.first_primitive].position;
            let _e190 = p.member.map_size;
            let _e192 = (0.5f / f32(_e190));
            let _e199 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e206 = lt_math_LightPoint(vec2<f32>(_e199.uv.x, 0f), _e199.depth, _e199.is_inside);
            let _e210 = lt_math_LightPoint(_e206.uv, 0f, _e206.is_inside);
            phi_1249_ = lt_math_LightPoint();
            phi_1252_ = 0u;
            phi_1254_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e210.uv, _e210.depth, false));
            loop {
                let _e217 = phi_1249_;
                let _e219 = phi_1252_;
                let _e221 = phi_1254_;
                local_2 = _e221;
                local_3 = _e221;
                local_4 = _e221;
                if (_e219 < _e72) {
                    if _e221.point.is_inside {
                        phi_1415_ = lt_math_LightPoint();
                        phi_1416_ = u32();
                        phi_1417_ = lt_math_LevelPoint();
                        phi_1418_ = false;
                    } else {
                        if (_e219 < _e59) {
                        } else {
                            return;
                        }
                        let _e232 = levels.member[(0u + _e219)].row_w;
                        let _e243 = ((((_e232.x * _e188.x) + (_e232.y * _e188.y)) + (_e232.z * _e188.z)) + (_e232.w * 1f));
                        let _e245 = levels.member[(0u + _e219)].row_x;
                        let _e257 = (((((_e245.x * _e188.x) + (_e245.y * _e188.y)) + (_e245.z * _e188.z)) + (_e245.w * 1f)) / _e243);
                        let _e259 = levels.member[(0u + _e219)].row_y;
                        let _e271 = (((((_e259.x * _e188.x) + (_e259.y * _e188.y)) + (_e259.z * _e188.z)) + (_e259.w * 1f)) / _e243);
                        let _e273 = levels.member[(0u + _e219)].row_z;
                        let _e284 = ((((_e273.x * _e188.x) + (_e273.y * _e188.y)) + (_e273.z * _e188.z)) + (_e273.w * 1f));
                        if (_e243 > 0f) {
                            if (_e257 >= 0f) {
                                phi_1340_ = (_e257 <= 1f);
                            } else {
                                phi_1340_ = false;
                            }
                            let _e289 = phi_1340_;
                            if _e289 {
                                if (_e271 >= 0f) {
                                    phi_1349_ = (_e271 <= 1f);
                                } else {
                                    phi_1349_ = false;
                                }
                                let _e293 = phi_1349_;
                                if _e293 {
                                    if (_e284 >= 0f) {
                                        phi_1358_ = (_e284 <= 1f);
                                    } else {
                                        phi_1358_ = false;
                                    }
                                    let _e297 = phi_1358_;
                                    phi_1359_ = _e297;
                                    phi_1360_ = false;
                                } else {
                                    phi_1359_ = bool();
                                    phi_1360_ = true;
                                }
                                let _e299 = phi_1359_;
                                let _e301 = phi_1360_;
                                phi_1361_ = _e299;
                                phi_1362_ = _e301;
                            } else {
                                phi_1361_ = bool();
                                phi_1362_ = true;
                            }
                            let _e303 = phi_1361_;
                            let _e305 = phi_1362_;
                            phi_1363_ = _e303;
                            phi_1364_ = _e305;
                        } else {
                            phi_1363_ = bool();
                            phi_1364_ = true;
                        }
                        let _e307 = phi_1363_;
                        let _e309 = phi_1364_;
                        if _e309 {
                            phi_1368_ = false;
                        } else {
                            phi_1368_ = _e307;
                        }
                        let _e311 = phi_1368_;
                        if _e311 {
                            if (_e257 >= _e192) {
                                if (_e257 <= (1f - _e192)) {
                                    if (_e271 >= _e192) {
                                        phi_1395_ = (_e271 <= (1f - _e192));
                                        phi_1396_ = false;
                                    } else {
                                        phi_1395_ = bool();
                                        phi_1396_ = true;
                                    }
                                    let _e319 = phi_1395_;
                                    let _e321 = phi_1396_;
                                    phi_1397_ = _e319;
                                    phi_1398_ = _e321;
                                } else {
                                    phi_1397_ = bool();
                                    phi_1398_ = true;
                                }
                                let _e323 = phi_1397_;
                                let _e325 = phi_1398_;
                                phi_1399_ = _e323;
                                phi_1400_ = _e325;
                            } else {
                                phi_1399_ = bool();
                                phi_1400_ = true;
                            }
                            let _e327 = phi_1399_;
                            let _e329 = phi_1400_;
                            phi_1401_ = _e327;
                            phi_1402_ = _e329;
                        } else {
                            phi_1401_ = bool();
                            phi_1402_ = true;
                        }
                        let _e331 = phi_1401_;
                        let _e333 = phi_1402_;
                        if _e333 {
                            phi_1406_ = false;
                        } else {
                            phi_1406_ = _e331;
                        }
                        let _e335 = phi_1406_;
                        let _e342 = lt_math_LightPoint(vec2<f32>(_e257, _e217.uv.y), _e217.depth, _e217.is_inside);
                        let _e349 = lt_math_LightPoint(vec2<f32>(_e342.uv.x, _e271), _e342.depth, _e342.is_inside);
                        let _e353 = lt_math_LightPoint(_e349.uv, _e284, _e349.is_inside);
                        let _e357 = lt_math_LightPoint(_e353.uv, _e353.depth, _e335);
                        phi_1415_ = _e357;
                        phi_1416_ = (_e219 + 1u);
                        phi_1417_ = lt_math_LevelPoint(_e219, _e357);
                        phi_1418_ = true;
                    }
                    let _e361 = phi_1415_;
                    let _e363 = phi_1416_;
                    let _e365 = phi_1417_;
                    let _e367 = phi_1418_;
                    phi_1250_ = _e361;
                    phi_1253_ = _e363;
                    phi_1255_ = _e365;
                    phi_1419_ = _e367;
                } else {
                    phi_1250_ = lt_math_LightPoint();
                    phi_1253_ = u32();
                    phi_1255_ = lt_math_LevelPoint();
                    phi_1419_ = false;
                }
                let _e369 = phi_1250_;
                let _e371 = phi_1253_;
                let _e373 = phi_1255_;
                let _e375 = phi_1419_;
                continue;
                continuing {
                    phi_1249_ = _e369;
                    phi_1252_ = _e371;
                    phi_1254_ = _e373;
                    break if !(_e375);
                }
            }
            let _e378 = local_2;
            if _e378.point.is_inside {
                if (0f > 0f) {
                    let _e384 = local_3;
                    if (_e384.level < _e59) {
                    } else {
                        return;
                    }
                    let _e389 = levels.member[(0u + _e384.level)];
                    let _e395 = global[0u];
                    if (_e389.row_w.x == _e395) {
                        let _e398 = global[1u];
                        if (_e389.row_w.y == _e398) {
                            let _e401 = global[2u];
                            phi_1459_ = (_e389.row_w.z == _e401);
                            phi_1460_ = false;
                        } else {
                            phi_1459_ = bool();
                            phi_1460_ = true;
                        }
                        let _e404 = phi_1459_;
                        let _e406 = phi_1460_;
                        phi_1461_ = _e404;
                        phi_1462_ = _e406;
                    } else {
                        phi_1461_ = bool();
                        phi_1462_ = true;
                    }
                    let _e408 = phi_1461_;
                    let _e410 = phi_1462_;
                    if _e410 {
                        phi_1466_ = false;
                    } else {
                        phi_1466_ = _e408;
                    }
                    let _e412 = phi_1466_;
                    if _e412 {
                        let _e414 = samples.member[_e65.first_primitive].normal;
                        let _e416 = p.member.map_size;
                        let _e486 = ((abs(((((_e389.row_x.x * _e414.x) + (_e389.row_x.y * _e414.y)) + (_e389.row_x.z * _e414.z)) / (((_e389.row_x.x * _e389.row_x.x) + (_e389.row_x.y * _e389.row_x.y)) + (_e389.row_x.z * _e389.row_x.z)))) + abs(((((_e389.row_y.x * _e414.x) + (_e389.row_y.y * _e414.y)) + (_e389.row_y.z * _e414.z)) / (((_e389.row_y.x * _e389.row_y.x) + (_e389.row_y.y * _e389.row_y.y)) + (_e389.row_y.z * _e389.row_y.z))))) / (abs(((((_e389.row_z.x * _e414.x) + (_e389.row_z.y * _e414.y)) + (_e389.row_z.z * _e414.z)) / (((_e389.row_z.x * _e389.row_z.x) + (_e389.row_z.y * _e389.row_z.y)) + (_e389.row_z.z * _e389.row_z.z)))) * f32(_e416)));
                        if (_e486 < 0.002f) {
                            phi_1548_ = _e486;
                        } else {
                            phi_1548_ = 0.002f;
                        }
                        let _e489 = phi_1548_;
                        phi_1665_ = _e489;
                    } else {
                        let _e491 = p.member.map_size;
                        let _e497 = samples.member[_e65.first_primitive].position;
                        let _e508 = ((((_e389.row_w.x * _e497.x) + (_e389.row_w.y * _e497.y)) + (_e389.row_w.z * _e497.z)) + _e389.row_w.w);
                        let _e521 = ((_e389.row_x.x - (_e389.row_w.x * _e378.point.uv.x)) / _e508);
                        let _e522 = ((_e389.row_x.y - (_e389.row_w.y * _e378.point.uv.x)) / _e508);
                        let _e523 = ((_e389.row_x.z - (_e389.row_w.z * _e378.point.uv.x)) / _e508);
                        let _e536 = ((_e389.row_y.x - (_e389.row_w.x * _e378.point.uv.y)) / _e508);
                        let _e537 = ((_e389.row_y.y - (_e389.row_w.y * _e378.point.uv.y)) / _e508);
                        let _e538 = ((_e389.row_y.z - (_e389.row_w.z * _e378.point.uv.y)) / _e508);
                        let _e544 = samples.member[_e65.first_primitive].normal;
                        let _e549 = ((_e537 * _e544.z) - (_e544.y * _e538));
                        let _e554 = ((_e538 * _e544.x) - (_e544.z * _e536));
                        let _e559 = ((_e536 * _e544.y) - (_e544.x * _e537));
                        let _e561 = samples.member[_e65.first_primitive].normal;
                        let _e566 = ((_e522 * _e561.z) - (_e561.y * _e523));
                        let _e571 = ((_e523 * _e561.x) - (_e561.z * _e521));
                        let _e576 = ((_e521 * _e561.y) - (_e561.x * _e522));
                        let _e603 = ((abs(((((_e389.row_z.x * _e549) + (_e389.row_z.y * _e554)) + (_e389.row_z.z * _e559)) / (((_e521 * _e549) + (_e522 * _e554)) + (_e523 * _e559)))) + abs(((((_e389.row_z.x * _e566) + (_e389.row_z.y * _e571)) + (_e389.row_z.z * _e576)) / (((_e536 * _e566) + (_e537 * _e571)) + (_e538 * _e576))))) / f32(_e491));
                        if (_e603 < 0.002f) {
                            phi_1664_ = _e603;
                        } else {
                            phi_1664_ = 0.002f;
                        }
                        let _e606 = phi_1664_;
                        phi_1665_ = _e606;
                    }
                    let _e608 = phi_1665_;
                    phi_1668_ = (_e378.point.depth - (0f * _e608));
                } else {
                    phi_1668_ = _e378.point.depth;
                }
                let _e612 = phi_1668_;
                let _e618 = p.member.map_size;
                let _e619 = f32(_e618);
                let _e622 = ((_e378.point.uv.x * _e619) - 0.5f);
                let _e623 = ((_e378.point.uv.y * _e619) - 0.5f);
                if (_e622 > -8388608f) {
                    let _e635 = f32(select(0i, select(select(i32(_e622), i32(-2147483648), (_e622 < bitcast<f32>(3472883712u))), 2147483647i, (_e622 > bitcast<f32>(1325400063u))), (_e622 == _e622)));
                    if (_e635 > _e622) {
                        phi_1697_ = 1f;
                    } else {
                        phi_1697_ = 0f;
                    }
                    let _e638 = phi_1697_;
                    if (_e622 < 8388608f) {
                        phi_1702_ = (_e635 - _e638);
                        phi_1703_ = false;
                    } else {
                        phi_1702_ = f32();
                        phi_1703_ = true;
                    }
                    let _e641 = phi_1702_;
                    let _e643 = phi_1703_;
                    phi_1704_ = _e641;
                    phi_1705_ = _e643;
                } else {
                    phi_1704_ = f32();
                    phi_1705_ = true;
                }
                let _e645 = phi_1704_;
                let _e647 = phi_1705_;
                if _e647 {
                    phi_1709_ = _e622;
                } else {
                    phi_1709_ = _e645;
                }
                let _e649 = phi_1709_;
                if (_e623 > -8388608f) {
                    let _e661 = f32(select(0i, select(select(i32(_e623), i32(-2147483648), (_e623 < bitcast<f32>(3472883712u))), 2147483647i, (_e623 > bitcast<f32>(1325400063u))), (_e623 == _e623)));
                    if (_e661 > _e623) {
                        phi_1729_ = 1f;
                    } else {
                        phi_1729_ = 0f;
                    }
                    let _e664 = phi_1729_;
                    if (_e623 < 8388608f) {
                        phi_1734_ = (_e661 - _e664);
                        phi_1735_ = false;
                    } else {
                        phi_1734_ = f32();
                        phi_1735_ = true;
                    }
                    let _e667 = phi_1734_;
                    let _e669 = phi_1735_;
                    phi_1736_ = _e667;
                    phi_1737_ = _e669;
                } else {
                    phi_1736_ = f32();
                    phi_1737_ = true;
                }
                let _e671 = phi_1736_;
                let _e673 = phi_1737_;
                if _e673 {
                    phi_1741_ = _e623;
                } else {
                    phi_1741_ = _e671;
                }
                let _e675 = phi_1741_;
                let _e676 = (_e622 - _e649);
                let _e677 = (_e623 - _e675);
                let _e686 = select(0i, select(select(i32(_e649), i32(-2147483648), (_e649 < bitcast<f32>(3472883712u))), 2147483647i, (_e649 > bitcast<f32>(1325400063u))), (_e649 == _e649));
                let _e695 = select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675));
                let _e706 = p.member.test;
                let _e707 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e706);
                let _e709 = p.member.map_size;
                let _e711 = local_4;
                local_1 = _e707;
                let _e714 = ((_e711.level * _e709) * _e709);
                let _e716 = (bitcast<i32>(_e709) - 1i);
                if (_e686 > 0i) {
                    phi_1790_ = _e686;
                } else {
                    phi_1790_ = 0i;
                }
                let _e719 = phi_1790_;
                if (_e695 > 0i) {
                    phi_1795_ = _e695;
                } else {
                    phi_1795_ = 0i;
                }
                let _e722 = phi_1795_;
                if (_e719 < _e716) {
                    phi_1800_ = _e719;
                } else {
                    phi_1800_ = _e716;
                }
                let _e725 = phi_1800_;
                if (_e722 < _e716) {
                    phi_1805_ = _e722;
                } else {
                    phi_1805_ = _e716;
                }
                let _e728 = phi_1805_;
                let _e729 = bitcast<u32>(_e725);
                let _e731 = (_e686 + 1i);
                let _e732 = (_e695 + 1i);
                if (_e731 > 0i) {
                    phi_1814_ = _e731;
                } else {
                    phi_1814_ = 0i;
                }
                let _e735 = phi_1814_;
                if (_e732 > 0i) {
                    phi_1819_ = _e732;
                } else {
                    phi_1819_ = 0i;
                }
                let _e738 = phi_1819_;
                if (_e735 < _e716) {
                    phi_1824_ = _e735;
                } else {
                    phi_1824_ = _e716;
                }
                let _e741 = phi_1824_;
                if (_e738 < _e716) {
                    phi_1829_ = _e738;
                } else {
                    phi_1829_ = _e716;
                }
                let _e744 = phi_1829_;
                let _e745 = bitcast<u32>(_e741);
                let _e747 = (bitcast<u32>(_e728) * _e709);
                let _e748 = (bitcast<u32>(_e744) * _e709);
                let _e753 = ((_e747 + _e729) + _e714);
                let _e754 = ((_e747 + _e745) + _e714);
                let _e755 = ((_e748 + _e729) + _e714);
                let _e756 = ((_e748 + _e745) + _e714);
                if (_e753 < _e54) {
                } else {
                    return;
                }
                let _e760 = map.member[(0u + _e753)];
                if (_e754 < _e54) {
                } else {
                    return;
                }
                let _e764 = map.member[(0u + _e754)];
                if (_e755 < _e54) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e755)];
                if (_e756 < _e54) {
                } else {
                    return;
                }
                let _e772 = map.member[(0u + _e756)];
                let _e774 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e760, _e764, _e768, _e772), vec4<f32>(((1f - _e676) * (1f - _e677)), (_e676 * (1f - _e677)), ((1f - _e676) * _e677), (_e676 * _e677)), _e612);
                let _e776 = p.member.epsilon;
                if (_e774 <= _e776) {
                    phi_1880_ = true;
                } else {
                    phi_1880_ = (_e774 >= (1f - _e776));
                }
                let _e781 = phi_1880_;
                if ((bitcast<u32>(_e774) & 2147483647u) > 2139095040u) {
                    phi_1888_ = true;
                } else {
                    phi_1888_ = !(_e781);
                }
                let _e787 = phi_1888_;
                if _e787 {
                    if (_e774 > 0f) {
                        if (_e774 < 1f) {
                            phi_1900_ = false;
                        } else {
                            phi_1900_ = true;
                        }
                        let _e791 = phi_1900_;
                        phi_1901_ = _e791;
                    } else {
                        phi_1901_ = true;
                    }
                    let _e793 = phi_1901_;
                    if _e793 {
                        phi_1905_ = 0.5f;
                    } else {
                        phi_1905_ = _e774;
                    }
                    let _e795 = phi_1905_;
                    phi_1913_ = evaluate_Verdict(_e795, true);
                } else {
                    if (_e774 > 0.5f) {
                        phi_1911_ = 1f;
                    } else {
                        phi_1911_ = 0f;
                    }
                    let _e799 = phi_1911_;
                    phi_1913_ = evaluate_Verdict(_e799, false);
                }
                let _e802 = phi_1913_;
                phi_1918_ = evaluate_Verdict(_e802.visibility, _e802.is_doubted);
            } else {
                phi_1918_ = evaluate_Verdict(0.5f, true);
            }
            let _e808 = phi_1918_;
            phi_1919_ = _e808;
        }
        let _e810 = phi_1919_;
        visibility.member[_e65.first_primitive] = _e810.visibility;
        phi_1923_ = _e810.is_doubted;
        phi_1924_ = _e65.first_primitive;
    } else {
        phi_1923_ = false;
        phi_1924_ = 0u;
    }
    let _e815 = phi_1923_;
    let _e817 = phi_1924_;
    if (_e49 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e815 {
        let _e821 = atomicAdd((&shared_[0u]), 1u);
        phi_1935_ = _e821;
    } else {
        phi_1935_ = 0u;
    }
    let _e823 = phi_1935_;
    workgroupBarrier();
    if (_e49 == 0u) {
        let _e827 = atomicLoad((&shared_[0u]));
        let _e828 = atomicAdd((&list.member[3u]), _e827);
        atomicStore((&shared_[1u]), _e828);
    }
    workgroupBarrier();
    if _e815 {
        let _e831 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e831) + _e823)]), _e817);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
