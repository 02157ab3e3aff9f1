struct abi_LightParams {
    place: vec4<f32>,
    axis: vec3<f32>,
    cos_outer: f32,
    range_squared: f32,
    cos_inner: f32,
    number: u32,
    mask_words: u32,
}

struct type_9 {
    member: array<u32>,
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

struct type_19 {
    member: array<abi_Sample>,
}

struct type_23 {
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

struct type_35 {
    member: abi_ShadowParams,
}

struct type_39 {
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
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_35;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;
@group(0) @binding(4) 
var<storage> marks: type_9;
@group(0) @binding(5) 
var<storage> levels: type_39;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_166_: lt_bvh_traverse_Tree;
    var phi_167_: bool;
    var phi_168_: lt_bvh_traverse_Tree;
    var phi_169_: bool;
    var phi_174_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_166_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_167_ = false;
        } else {
            phi_166_ = lt_bvh_traverse_Tree();
            phi_167_ = true;
        }
        let _e61 = phi_166_;
        let _e63 = phi_167_;
        phi_168_ = _e61;
        phi_169_ = _e63;
    } else {
        phi_168_ = lt_bvh_traverse_Tree();
        phi_169_ = true;
    }
    let _e65 = phi_168_;
    let _e67 = phi_169_;
    if _e67 {
        phi_174_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_174_ = _e65;
    }
    let _e72 = phi_174_;
    return lt_bvh_traverse_Tree(_e72.root, _e72.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_203_: f32;
    var phi_220_: f32;
    var phi_221_: f32;
    var phi_222_: f32;
    var phi_238_: f32;
    var phi_239_: f32;
    var phi_240_: f32;
    var phi_256_: f32;
    var phi_257_: f32;
    var phi_258_: f32;
    var phi_274_: f32;
    var phi_275_: f32;
    var phi_276_: f32;
    var phi_311_: bool;
    var phi_312_: bool;
    var phi_313_: bool;
    var phi_314_: bool;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_320_: bool;
    var phi_631_: f32;
    var phi_632_: f32;
    var phi_633_: f32;
    var phi_650_: f32;
    var phi_651_: f32;
    var phi_652_: f32;
    var phi_669_: f32;
    var phi_670_: f32;
    var phi_671_: f32;
    var phi_688_: f32;
    var phi_689_: f32;
    var phi_690_: f32;
    var phi_713_: f32;
    var phi_714_: f32;
    var phi_715_: f32;
    var phi_726_: f32;
    var phi_741_: f32;
    var phi_743_: lt_bvh_slab_Span;
    var phi_801_: f32;
    var phi_802_: f32;
    var phi_803_: f32;
    var phi_804_: f32;
    var phi_805_: f32;
    var phi_806_: bool;
    var phi_810_: f32;
    var phi_825_: f32;
    var phi_826_: f32;
    var phi_827_: f32;
    var phi_828_: f32;
    var phi_829_: f32;
    var phi_830_: f32;
    var phi_831_: f32;
    var phi_832_: bool;
    var phi_833_: f32;
    var phi_834_: f32;
    var phi_835_: bool;
    var phi_839_: f32;

    let _e52 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_203_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_202_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_201_ = 1f;
            } else {
                phi_201_ = param_7;
            }
            let _e59 = phi_201_;
            phi_202_ = _e59;
        }
        let _e61 = phi_202_;
        phi_203_ = _e61;
    }
    let _e63 = phi_203_;
    let _e64 = (_e63 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_222_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_221_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_220_ = 1f;
            } else {
                phi_220_ = param_5.x;
            }
            let _e72 = phi_220_;
            phi_221_ = _e72;
        }
        let _e74 = phi_221_;
        phi_222_ = _e74;
    }
    let _e76 = phi_222_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_240_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_239_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_238_ = 1f;
            } else {
                phi_238_ = param_5.y;
            }
            let _e84 = phi_238_;
            phi_239_ = _e84;
        }
        let _e86 = phi_239_;
        phi_240_ = _e86;
    }
    let _e88 = phi_240_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_258_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_257_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_256_ = 1f;
            } else {
                phi_256_ = param_5.z;
            }
            let _e96 = phi_256_;
            phi_257_ = _e96;
        }
        let _e98 = phi_257_;
        phi_258_ = _e98;
    }
    let _e100 = phi_258_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_276_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_275_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_274_ = 1f;
            } else {
                phi_274_ = param_5.w;
            }
            let _e108 = phi_274_;
            phi_275_ = _e108;
        }
        let _e110 = phi_275_;
        phi_276_ = _e110;
    }
    let _e112 = phi_276_;
    let _e113 = (_e76 - _e64);
    let _e114 = (_e88 - _e64);
    let _e115 = (_e100 - _e64);
    let _e116 = (_e112 - _e64);
    let _e127 = ((((_e113 * param_6.x) + (_e114 * param_6.y)) + (_e115 * param_6.z)) + (_e116 * param_6.w));
    if ((bitcast<u32>(_e127) & 2147483647u) > 2139095040u) {
        phi_833_ = _e127;
        phi_834_ = f32();
        phi_835_ = true;
    } else {
        if (_e113 >= 0f) {
            if (_e114 >= 0f) {
                if (_e115 >= 0f) {
                    phi_311_ = (_e116 >= 0f);
                    phi_312_ = false;
                } else {
                    phi_311_ = bool();
                    phi_312_ = true;
                }
                let _e136 = phi_311_;
                let _e138 = phi_312_;
                phi_313_ = _e136;
                phi_314_ = _e138;
            } else {
                phi_313_ = bool();
                phi_314_ = true;
            }
            let _e140 = phi_313_;
            let _e142 = phi_314_;
            phi_315_ = _e140;
            phi_316_ = _e142;
        } else {
            phi_315_ = bool();
            phi_316_ = true;
        }
        let _e144 = phi_315_;
        let _e146 = phi_316_;
        if _e146 {
            phi_320_ = false;
        } else {
            phi_320_ = _e144;
        }
        let _e148 = phi_320_;
        if _e148 {
            phi_830_ = 1f;
            phi_831_ = f32();
            phi_832_ = true;
        } else {
            let _e149 = (0.5f * _e52);
            let _e150 = (1f - _e52);
            let _e152 = (param_6.x * _e150);
            let _e154 = (param_6.y * _e150);
            let _e156 = (param_6.z * _e150);
            let _e158 = (param_6.w * _e150);
            let _e159 = -(_e64);
            let _e160 = (1f - _e64);
            let _e162 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e76);
            let _e164 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e88);
            let _e166 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e100);
            let _e168 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e112);
            let _e169 = (_e113 - _e114);
            let _e170 = (_e114 - _e115);
            let _e171 = (_e115 - _e116);
            let _e172 = (_e116 - _e113);
            let _e173 = (_e169 * _e169);
            let _e174 = (_e170 * _e170);
            let _e175 = (_e171 * _e171);
            let _e176 = (_e172 * _e172);
            let _e177 = (_e113 - _e115);
            let _e178 = (_e114 - _e116);
            let _e179 = (_e115 - _e113);
            let _e180 = (_e116 - _e114);
            let _e181 = (_e177 * _e177);
            let _e182 = (_e178 * _e178);
            let _e183 = (_e179 * _e179);
            let _e184 = (_e180 * _e180);
            let _e189 = ((_e152 * _e154) * _e173);
            let _e190 = ((_e154 * _e156) * _e174);
            let _e191 = ((_e156 * _e158) * _e175);
            let _e192 = ((_e158 * _e152) * _e176);
            let _e201 = (((0.5f * _e152) * _e156) * _e181);
            let _e202 = (((0.5f * _e154) * _e158) * _e182);
            let _e203 = (((0.5f * _e156) * _e152) * _e183);
            let _e204 = (((0.5f * _e158) * _e154) * _e184);
            let _e205 = (_e113 * _e114);
            let _e206 = (_e114 * _e115);
            let _e207 = (_e115 * _e116);
            let _e208 = (_e116 * _e113);
            let _e209 = (_e113 * _e115);
            let _e210 = (_e114 * _e116);
            let _e211 = (_e115 * _e113);
            let _e212 = (_e116 * _e114);
            let _e213 = (_e189 * _e205);
            let _e214 = (_e190 * _e206);
            let _e215 = (_e191 * _e207);
            let _e216 = (_e192 * _e208);
            let _e217 = (_e201 * _e209);
            let _e218 = (_e202 * _e210);
            let _e219 = (_e203 * _e211);
            let _e220 = (_e204 * _e212);
            let _e221 = (_e76 * _e76);
            let _e222 = (_e88 * _e88);
            let _e223 = (_e100 * _e100);
            let _e224 = (_e112 * _e112);
            let _e225 = (_e162 * _e162);
            let _e226 = (_e164 * _e164);
            let _e227 = (_e166 * _e166);
            let _e228 = (_e168 * _e168);
            let _e229 = (_e149 * _e152);
            let _e230 = (_e149 * _e154);
            let _e231 = (_e149 * _e156);
            let _e232 = (_e149 * _e158);
            let _e241 = (((_e229 * _e113) * _e221) * _e159);
            let _e242 = (((_e230 * _e114) * _e222) * _e159);
            let _e243 = (((_e231 * _e115) * _e223) * _e159);
            let _e244 = (((_e232 * _e116) * _e224) * _e159);
            let _e253 = (((_e229 * _e113) * _e225) * _e160);
            let _e254 = (((_e230 * _e114) * _e226) * _e160);
            let _e255 = (((_e231 * _e115) * _e227) * _e160);
            let _e256 = (((_e232 * _e116) * _e228) * _e160);
            let _e424 = (((((((_e189 * _e156) * _e174) * _e181) + (_e149 * (((_e189 * ((_e221 * _e222) + (_e225 * _e226))) + (_e201 * ((_e221 * _e223) + (_e225 * _e227)))) + ((_e229 * _e221) * _e225)))) + ((((_e190 * _e158) * _e175) * _e182) + (_e149 * (((_e190 * ((_e222 * _e223) + (_e226 * _e227))) + (_e202 * ((_e222 * _e224) + (_e226 * _e228)))) + ((_e230 * _e222) * _e226))))) + ((((_e191 * _e152) * _e176) * _e183) + (_e149 * (((_e191 * ((_e223 * _e224) + (_e227 * _e228))) + (_e203 * ((_e223 * _e221) + (_e227 * _e225)))) + ((_e231 * _e223) * _e227))))) + ((((_e192 * _e154) * _e173) * _e184) + (_e149 * (((_e192 * ((_e224 * _e221) + (_e228 * _e225))) + (_e204 * ((_e224 * _e222) + (_e228 * _e226)))) + ((_e232 * _e224) * _e228)))));
            let _e427 = (((_e149 * _e149) * _e159) * _e160);
            let _e430 = (((((((_e213 * _e205) + (_e217 * _e209)) + (_e113 * ((_e241 * _e159) + (_e253 * _e160)))) + (((_e214 * _e206) + (_e218 * _e210)) + (_e114 * ((_e242 * _e159) + (_e254 * _e160))))) + (((_e215 * _e207) + (_e219 * _e211)) + (_e115 * ((_e243 * _e159) + (_e255 * _e160))))) + (((_e216 * _e208) + (_e220 * _e212)) + (_e116 * ((_e244 * _e159) + (_e256 * _e160))))) + ((_e427 * _e159) * _e160));
            let _e436 = (_e430 < 0.0000000000000000000000000000000001f);
            if _e436 {
                if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                    phi_633_ = _e113;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_632_ = 0f;
                    } else {
                        if (_e113 < 0f) {
                            phi_631_ = 0f;
                        } else {
                            phi_631_ = 1f;
                        }
                        let _e445 = phi_631_;
                        phi_632_ = _e445;
                    }
                    let _e447 = phi_632_;
                    phi_633_ = _e447;
                }
                let _e449 = phi_633_;
                if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                    phi_652_ = _e114;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_651_ = 0f;
                    } else {
                        if (_e114 < 0f) {
                            phi_650_ = 0f;
                        } else {
                            phi_650_ = 1f;
                        }
                        let _e458 = phi_650_;
                        phi_651_ = _e458;
                    }
                    let _e460 = phi_651_;
                    phi_652_ = _e460;
                }
                let _e462 = phi_652_;
                if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                    phi_671_ = _e115;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_670_ = 0f;
                    } else {
                        if (_e115 < 0f) {
                            phi_669_ = 0f;
                        } else {
                            phi_669_ = 1f;
                        }
                        let _e471 = phi_669_;
                        phi_670_ = _e471;
                    }
                    let _e473 = phi_670_;
                    phi_671_ = _e473;
                }
                let _e475 = phi_671_;
                if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
                    phi_690_ = _e116;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_689_ = 0f;
                    } else {
                        if (_e116 < 0f) {
                            phi_688_ = 0f;
                        } else {
                            phi_688_ = 1f;
                        }
                        let _e484 = phi_688_;
                        phi_689_ = _e484;
                    }
                    let _e486 = phi_689_;
                    phi_690_ = _e486;
                }
                let _e488 = phi_690_;
                let _e496 = (((((_e449 * _e152) + (_e462 * _e154)) + (_e475 * _e156)) + (_e488 * _e158)) + _e149);
                if ((bitcast<u32>(_e496) & 2147483647u) > 2139095040u) {
                    phi_715_ = _e496;
                } else {
                    if (_e496 < 0f) {
                        phi_714_ = 0f;
                    } else {
                        if (_e496 > 1f) {
                            phi_713_ = 1f;
                        } else {
                            phi_713_ = _e496;
                        }
                        let _e503 = phi_713_;
                        phi_714_ = _e503;
                    }
                    let _e505 = phi_714_;
                    phi_715_ = _e505;
                }
                let _e507 = phi_715_;
                phi_828_ = _e507;
                phi_829_ = f32();
            } else {
                let _e509 = ((0.5f * -(((((((((_e213 * (_e113 + _e114)) + (_e217 * (_e113 + _e115))) + (_e241 * (_e113 + _e159))) + (_e253 * (_e113 + _e160))) + ((((_e214 * (_e114 + _e115)) + (_e218 * (_e114 + _e116))) + (_e242 * (_e114 + _e159))) + (_e254 * (_e114 + _e160)))) + ((((_e215 * (_e115 + _e116)) + (_e219 * (_e115 + _e113))) + (_e243 * (_e115 + _e159))) + (_e255 * (_e115 + _e160)))) + ((((_e216 * (_e116 + _e113)) + (_e220 * (_e116 + _e114))) + (_e244 * (_e116 + _e159))) + (_e256 * (_e116 + _e160)))) + (_e427 * (_e159 + _e160))))) / _e430);
                let _e510 = ((((((((_e213 + _e217) + _e241) + _e253) + (((_e214 + _e218) + _e242) + _e254)) + (((_e215 + _e219) + _e243) + _e255)) + (((_e216 + _e220) + _e244) + _e256)) + _e427) / _e430);
                let _e512 = ((_e509 * _e509) - _e510);
                if (_e512 > 0f) {
                    phi_726_ = sqrt(_e512);
                } else {
                    phi_726_ = 0f;
                }
                let _e516 = phi_726_;
                if (_e509 > 0f) {
                    let _e519 = (-(_e509) - _e516);
                    phi_743_ = lt_bvh_slab_Span(_e519, (_e510 / _e519));
                } else {
                    let _e522 = (_e516 - _e509);
                    if (_e522 > 0f) {
                        phi_741_ = (_e510 / _e522);
                    } else {
                        phi_741_ = 0f;
                    }
                    let _e526 = phi_741_;
                    phi_743_ = lt_bvh_slab_Span(_e526, _e522);
                }
                let _e529 = phi_743_;
                if (_e529.near >= 0f) {
                    phi_804_ = 1f;
                    phi_805_ = f32();
                    phi_806_ = true;
                } else {
                    let _e533 = (_e529.far <= 0f);
                    if _e533 {
                        phi_802_ = (_e424 / _e430);
                        phi_803_ = f32();
                    } else {
                        let _e544 = (((((_e152 * _e113) + (_e154 * _e114)) + (_e156 * _e115)) + (_e158 * _e116)) + (_e149 * (_e159 + _e160)));
                        let _e560 = (((((_e152 * (_e113 * _e113)) + (_e154 * (_e114 * _e114))) + (_e156 * (_e115 * _e115))) + (_e158 * (_e116 * _e116))) + (_e149 * ((_e159 * _e159) + (_e160 * _e160))));
                        if (-(_e529.near) <= _e529.far) {
                            phi_801_ = (1f - (((_e529.near * _e529.near) * ((_e529.far * _e560) - _e544)) / (_e529.far - _e529.near)));
                        } else {
                            phi_801_ = ((_e424 / _e430) + (((_e529.far * _e529.far) * (_e544 - (_e529.near * _e560))) / (_e529.far - _e529.near)));
                        }
                        let _e579 = phi_801_;
                        phi_802_ = f32();
                        phi_803_ = _e579;
                    }
                    let _e581 = phi_802_;
                    let _e583 = phi_803_;
                    phi_804_ = _e581;
                    phi_805_ = _e583;
                    phi_806_ = _e533;
                }
                let _e585 = phi_804_;
                let _e587 = phi_805_;
                let _e589 = phi_806_;
                if _e589 {
                    phi_810_ = _e585;
                } else {
                    phi_810_ = _e587;
                }
                let _e591 = phi_810_;
                if ((bitcast<u32>(_e591) & 2147483647u) > 2139095040u) {
                    phi_827_ = _e591;
                } else {
                    if (_e591 < 0f) {
                        phi_826_ = 0f;
                    } else {
                        if (_e591 > 1f) {
                            phi_825_ = 1f;
                        } else {
                            phi_825_ = _e591;
                        }
                        let _e598 = phi_825_;
                        phi_826_ = _e598;
                    }
                    let _e600 = phi_826_;
                    phi_827_ = _e600;
                }
                let _e602 = phi_827_;
                phi_828_ = f32();
                phi_829_ = _e602;
            }
            let _e604 = phi_828_;
            let _e606 = phi_829_;
            phi_830_ = _e604;
            phi_831_ = _e606;
            phi_832_ = _e436;
        }
        let _e608 = phi_830_;
        let _e610 = phi_831_;
        let _e612 = phi_832_;
        phi_833_ = _e608;
        phi_834_ = _e610;
        phi_835_ = _e612;
    }
    let _e614 = phi_833_;
    let _e616 = phi_834_;
    let _e618 = phi_835_;
    if _e618 {
        phi_839_ = _e614;
    } else {
        phi_839_ = _e616;
    }
    let _e620 = phi_839_;
    return _e620;
}

fn function_() {
    var local: f32;
    var phi_905_: bool;
    var phi_906_: bool;
    var phi_907_: bool;
    var phi_908_: bool;
    var phi_912_: bool;
    var phi_982_: bool;
    var phi_983_: bool;
    var phi_994_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_995_: bool;
    var phi_996_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_997_: bool;
    var phi_1004_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1008_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1028_: lt_math_LightPoint;
    var phi_1031_: u32;
    var phi_1033_: lt_math_LevelPoint;
    var phi_1119_: bool;
    var phi_1128_: bool;
    var phi_1137_: bool;
    var phi_1138_: bool;
    var phi_1139_: bool;
    var phi_1140_: bool;
    var phi_1141_: bool;
    var phi_1142_: bool;
    var phi_1143_: bool;
    var phi_1147_: bool;
    var phi_1174_: bool;
    var phi_1175_: bool;
    var phi_1176_: bool;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1181_: bool;
    var phi_1185_: bool;
    var phi_1194_: lt_math_LightPoint;
    var phi_1195_: u32;
    var phi_1196_: lt_math_LevelPoint;
    var phi_1197_: bool;
    var phi_1029_: lt_math_LightPoint;
    var phi_1032_: u32;
    var phi_1034_: lt_math_LevelPoint;
    var phi_1198_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1238_: bool;
    var phi_1239_: bool;
    var phi_1240_: bool;
    var phi_1241_: bool;
    var phi_1245_: bool;
    var phi_1327_: f32;
    var phi_1445_: f32;
    var phi_1446_: f32;
    var phi_1449_: f32;
    var phi_1478_: f32;
    var phi_1483_: f32;
    var phi_1484_: bool;
    var phi_1485_: f32;
    var phi_1486_: bool;
    var phi_1490_: f32;
    var phi_1510_: f32;
    var phi_1515_: f32;
    var phi_1516_: bool;
    var phi_1517_: f32;
    var phi_1518_: bool;
    var phi_1522_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1573_: i32;
    var phi_1578_: i32;
    var phi_1583_: i32;
    var phi_1588_: i32;
    var phi_1597_: i32;
    var phi_1602_: i32;
    var phi_1607_: i32;
    var phi_1612_: i32;
    var local_4: lt_math_LevelPoint;
    var phi_1668_: i32;
    var phi_1673_: i32;
    var phi_1678_: i32;
    var phi_1683_: i32;
    var phi_1702_: i32;
    var phi_1707_: i32;
    var phi_1712_: i32;
    var phi_1717_: i32;
    var phi_1736_: i32;
    var phi_1741_: i32;
    var phi_1746_: i32;
    var phi_1751_: i32;
    var phi_1770_: i32;
    var phi_1775_: i32;
    var phi_1780_: i32;
    var phi_1785_: i32;
    var phi_1863_: bool;
    var phi_1871_: bool;
    var phi_1883_: bool;
    var phi_1884_: bool;
    var phi_1888_: f32;
    var phi_1894_: f32;
    var phi_1896_: evaluate_Verdict;
    var phi_1906_: u32;
    var phi_1915_: f32;
    var phi_1917_: evaluate_Verdict;
    var phi_1918_: bool;
    var phi_1919_: evaluate_Verdict;
    var phi_1920_: bool;
    var phi_1925_: evaluate_Verdict;
    var phi_1930_: evaluate_Verdict;
    var phi_1931_: evaluate_Verdict;

    let _e49 = id_1;
    let _e56 = arrayLength((&map.member));
    let _e62 = arrayLength((&marks.member));
    let _e65 = arrayLength((&levels.member));
    let _e68 = p.member.size[0u];
    let _e70 = p.member.size[1u];
    let _e71 = lt_shaders_entry_pixel_index(_e49, _e68, _e70);
    if (bitcast<i32>(_e71.root) != 0i) {
        let _e77 = p.member.level_count;
        if (_e71.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e84 = samples.member[(0u + _e71.first_primitive)].normal[0u];
        let _e86 = global[0u];
        if (_e84 == _e86) {
            let _e89 = samples.member[(0u + _e71.first_primitive)].normal[1u];
            let _e91 = global[1u];
            if (_e89 == _e91) {
                let _e94 = samples.member[(0u + _e71.first_primitive)].normal[2u];
                let _e96 = global[2u];
                phi_905_ = (_e94 == _e96);
                phi_906_ = false;
            } else {
                phi_905_ = bool();
                phi_906_ = true;
            }
            let _e99 = phi_905_;
            let _e101 = phi_906_;
            phi_907_ = _e99;
            phi_908_ = _e101;
        } else {
            phi_907_ = bool();
            phi_908_ = true;
        }
        let _e103 = phi_907_;
        let _e105 = phi_908_;
        if _e105 {
            phi_912_ = false;
        } else {
            phi_912_ = _e103;
        }
        let _e107 = phi_912_;
        if !(_e107) {
            let _e110 = samples.member[(0u + _e71.first_primitive)].position;
            let _e112 = p.member.light.place;
            let _e118 = p.member.light.place[3u];
            let _e125 = (_e112.x - (_e110.x * _e118));
            let _e126 = (_e112.y - (_e110.y * _e118));
            let _e127 = (_e112.z - (_e110.z * _e118));
            let _e129 = samples.member[(0u + _e71.first_primitive)].normal;
            if ((((_e129.x * _e125) + (_e129.y * _e126)) + (_e129.z * _e127)) > 0f) {
                let _e143 = (((_e125 * _e125) + (_e126 * _e126)) + (_e127 * _e127));
                let _e145 = p.member.light.axis;
                let _e157 = p.member.light.place[3u];
                if (_e157 == 0f) {
                    phi_983_ = true;
                } else {
                    let _e160 = p.member.light.range_squared;
                    if (_e143 <= _e160) {
                        let _e163 = p.member.light.cos_outer;
                        phi_982_ = (-((((_e125 * _e145.x) + (_e126 * _e145.y)) + (_e127 * _e145.z))) >= (_e163 * sqrt(_e143)));
                    } else {
                        phi_982_ = false;
                    }
                    let _e168 = phi_982_;
                    phi_983_ = _e168;
                }
                let _e170 = phi_983_;
                if _e170 {
                    let _e172 = samples.member[(0u + _e71.first_primitive)].flags;
                    let _e180 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e186 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e180.unnamed.visibility, false), _e180.unnamed_1);
                    phi_994_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e186.unnamed, ((_e172 & 1u) == 0u));
                    phi_995_ = false;
                } else {
                    phi_994_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_995_ = true;
                }
                let _e191 = phi_994_;
                let _e193 = phi_995_;
                phi_996_ = _e191;
                phi_997_ = _e193;
            } else {
                phi_996_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_997_ = true;
            }
            let _e195 = phi_996_;
            let _e197 = phi_997_;
            if _e197 {
                let _e203 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e209 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e203.unnamed.visibility, false), _e203.unnamed_1);
                phi_1004_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e209.unnamed, true);
            } else {
                phi_1004_ = _e195;
            }
            let _e214 = phi_1004_;
            phi_1008_ = _e214;
        } else {
            let _e220 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e226 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e220.unnamed.visibility, false), _e220.unnamed_1);
            phi_1008_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e226.unnamed, true);
        }
        let _e231 = phi_1008_;
        if _e231.unnamed_1 {
            phi_1931_ = evaluate_Verdict(_e231.unnamed.visibility, _e231.unnamed.is_doubted);
        } else {
            let _e239 = samples.member[(0u + _e71.first_primitive)].position;
            let _e241 = p.member.map_size;
            let _e243 = (0.5f / f32(_e241));
            let _e250 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e257 = lt_math_LightPoint(vec2<f32>(_e250.uv.x, 0f), _e250.depth, _e250.is_inside);
            let _e261 = lt_math_LightPoint(_e257.uv, 0f, _e257.is_inside);
            phi_1028_ = lt_math_LightPoint();
            phi_1031_ = 0u;
            phi_1033_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e261.uv, _e261.depth, false));
            loop {
                let _e268 = phi_1028_;
                let _e270 = phi_1031_;
                let _e272 = phi_1033_;
                local_1 = _e272;
                local_2 = _e272;
                local_3 = _e272;
                local_4 = _e272;
                if (_e270 < _e77) {
                    if _e272.point.is_inside {
                        phi_1194_ = lt_math_LightPoint();
                        phi_1195_ = u32();
                        phi_1196_ = lt_math_LevelPoint();
                        phi_1197_ = false;
                    } else {
                        if (_e270 < _e65) {
                        } else {
                            return;
                        }
                        let _e283 = levels.member[(0u + _e270)].row_w;
                        let _e294 = ((((_e283.x * _e239.x) + (_e283.y * _e239.y)) + (_e283.z * _e239.z)) + (_e283.w * 1f));
                        let _e296 = levels.member[(0u + _e270)].row_x;
                        let _e308 = (((((_e296.x * _e239.x) + (_e296.y * _e239.y)) + (_e296.z * _e239.z)) + (_e296.w * 1f)) / _e294);
                        let _e310 = levels.member[(0u + _e270)].row_y;
                        let _e322 = (((((_e310.x * _e239.x) + (_e310.y * _e239.y)) + (_e310.z * _e239.z)) + (_e310.w * 1f)) / _e294);
                        let _e324 = levels.member[(0u + _e270)].row_z;
                        let _e335 = ((((_e324.x * _e239.x) + (_e324.y * _e239.y)) + (_e324.z * _e239.z)) + (_e324.w * 1f));
                        if (_e294 > 0f) {
                            if (_e308 >= 0f) {
                                phi_1119_ = (_e308 <= 1f);
                            } else {
                                phi_1119_ = false;
                            }
                            let _e340 = phi_1119_;
                            if _e340 {
                                if (_e322 >= 0f) {
                                    phi_1128_ = (_e322 <= 1f);
                                } else {
                                    phi_1128_ = false;
                                }
                                let _e344 = phi_1128_;
                                if _e344 {
                                    if (_e335 >= 0f) {
                                        phi_1137_ = (_e335 <= 1f);
                                    } else {
                                        phi_1137_ = false;
                                    }
                                    let _e348 = phi_1137_;
                                    phi_1138_ = _e348;
                                    phi_1139_ = false;
                                } else {
                                    phi_1138_ = bool();
                                    phi_1139_ = true;
                                }
                                let _e350 = phi_1138_;
                                let _e352 = phi_1139_;
                                phi_1140_ = _e350;
                                phi_1141_ = _e352;
                            } else {
                                phi_1140_ = bool();
                                phi_1141_ = true;
                            }
                            let _e354 = phi_1140_;
                            let _e356 = phi_1141_;
                            phi_1142_ = _e354;
                            phi_1143_ = _e356;
                        } else {
                            phi_1142_ = bool();
                            phi_1143_ = true;
                        }
                        let _e358 = phi_1142_;
                        let _e360 = phi_1143_;
                        if _e360 {
                            phi_1147_ = false;
                        } else {
                            phi_1147_ = _e358;
                        }
                        let _e362 = phi_1147_;
                        if _e362 {
                            if (_e308 >= _e243) {
                                if (_e308 <= (1f - _e243)) {
                                    if (_e322 >= _e243) {
                                        phi_1174_ = (_e322 <= (1f - _e243));
                                        phi_1175_ = false;
                                    } else {
                                        phi_1174_ = bool();
                                        phi_1175_ = true;
                                    }
                                    let _e370 = phi_1174_;
                                    let _e372 = phi_1175_;
                                    phi_1176_ = _e370;
                                    phi_1177_ = _e372;
                                } else {
                                    phi_1176_ = bool();
                                    phi_1177_ = true;
                                }
                                let _e374 = phi_1176_;
                                let _e376 = phi_1177_;
                                phi_1178_ = _e374;
                                phi_1179_ = _e376;
                            } else {
                                phi_1178_ = bool();
                                phi_1179_ = true;
                            }
                            let _e378 = phi_1178_;
                            let _e380 = phi_1179_;
                            phi_1180_ = _e378;
                            phi_1181_ = _e380;
                        } else {
                            phi_1180_ = bool();
                            phi_1181_ = true;
                        }
                        let _e382 = phi_1180_;
                        let _e384 = phi_1181_;
                        if _e384 {
                            phi_1185_ = false;
                        } else {
                            phi_1185_ = _e382;
                        }
                        let _e386 = phi_1185_;
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e308, _e268.uv.y), _e268.depth, _e268.is_inside);
                        let _e400 = lt_math_LightPoint(vec2<f32>(_e393.uv.x, _e322), _e393.depth, _e393.is_inside);
                        let _e404 = lt_math_LightPoint(_e400.uv, _e335, _e400.is_inside);
                        let _e408 = lt_math_LightPoint(_e404.uv, _e404.depth, _e386);
                        phi_1194_ = _e408;
                        phi_1195_ = (_e270 + 1u);
                        phi_1196_ = lt_math_LevelPoint(_e270, _e408);
                        phi_1197_ = true;
                    }
                    let _e412 = phi_1194_;
                    let _e414 = phi_1195_;
                    let _e416 = phi_1196_;
                    let _e418 = phi_1197_;
                    phi_1029_ = _e412;
                    phi_1032_ = _e414;
                    phi_1034_ = _e416;
                    phi_1198_ = _e418;
                } else {
                    phi_1029_ = lt_math_LightPoint();
                    phi_1032_ = u32();
                    phi_1034_ = lt_math_LevelPoint();
                    phi_1198_ = false;
                }
                let _e420 = phi_1029_;
                let _e422 = phi_1032_;
                let _e424 = phi_1034_;
                let _e426 = phi_1198_;
                continue;
                continuing {
                    phi_1028_ = _e420;
                    phi_1031_ = _e422;
                    phi_1033_ = _e424;
                    break if !(_e426);
                }
            }
            let _e429 = local_1;
            if _e429.point.is_inside {
                if (0f > 0f) {
                    let _e435 = local_2;
                    if (_e435.level < _e65) {
                    } else {
                        return;
                    }
                    let _e440 = levels.member[(0u + _e435.level)];
                    let _e446 = global[0u];
                    if (_e440.row_w.x == _e446) {
                        let _e449 = global[1u];
                        if (_e440.row_w.y == _e449) {
                            let _e452 = global[2u];
                            phi_1238_ = (_e440.row_w.z == _e452);
                            phi_1239_ = false;
                        } else {
                            phi_1238_ = bool();
                            phi_1239_ = true;
                        }
                        let _e455 = phi_1238_;
                        let _e457 = phi_1239_;
                        phi_1240_ = _e455;
                        phi_1241_ = _e457;
                    } else {
                        phi_1240_ = bool();
                        phi_1241_ = true;
                    }
                    let _e459 = phi_1240_;
                    let _e461 = phi_1241_;
                    if _e461 {
                        phi_1245_ = false;
                    } else {
                        phi_1245_ = _e459;
                    }
                    let _e463 = phi_1245_;
                    if _e463 {
                        let _e465 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e467 = p.member.map_size;
                        let _e537 = ((abs(((((_e440.row_x.x * _e465.x) + (_e440.row_x.y * _e465.y)) + (_e440.row_x.z * _e465.z)) / (((_e440.row_x.x * _e440.row_x.x) + (_e440.row_x.y * _e440.row_x.y)) + (_e440.row_x.z * _e440.row_x.z)))) + abs(((((_e440.row_y.x * _e465.x) + (_e440.row_y.y * _e465.y)) + (_e440.row_y.z * _e465.z)) / (((_e440.row_y.x * _e440.row_y.x) + (_e440.row_y.y * _e440.row_y.y)) + (_e440.row_y.z * _e440.row_y.z))))) / (abs(((((_e440.row_z.x * _e465.x) + (_e440.row_z.y * _e465.y)) + (_e440.row_z.z * _e465.z)) / (((_e440.row_z.x * _e440.row_z.x) + (_e440.row_z.y * _e440.row_z.y)) + (_e440.row_z.z * _e440.row_z.z)))) * f32(_e467)));
                        if (_e537 < 0.002f) {
                            phi_1327_ = _e537;
                        } else {
                            phi_1327_ = 0.002f;
                        }
                        let _e540 = phi_1327_;
                        phi_1446_ = _e540;
                    } else {
                        let _e542 = p.member.map_size;
                        let _e548 = samples.member[(0u + _e71.first_primitive)].position;
                        let _e559 = ((((_e440.row_w.x * _e548.x) + (_e440.row_w.y * _e548.y)) + (_e440.row_w.z * _e548.z)) + _e440.row_w.w);
                        let _e572 = ((_e440.row_x.x - (_e440.row_w.x * _e429.point.uv.x)) / _e559);
                        let _e573 = ((_e440.row_x.y - (_e440.row_w.y * _e429.point.uv.x)) / _e559);
                        let _e574 = ((_e440.row_x.z - (_e440.row_w.z * _e429.point.uv.x)) / _e559);
                        let _e587 = ((_e440.row_y.x - (_e440.row_w.x * _e429.point.uv.y)) / _e559);
                        let _e588 = ((_e440.row_y.y - (_e440.row_w.y * _e429.point.uv.y)) / _e559);
                        let _e589 = ((_e440.row_y.z - (_e440.row_w.z * _e429.point.uv.y)) / _e559);
                        let _e595 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e600 = ((_e588 * _e595.z) - (_e595.y * _e589));
                        let _e605 = ((_e589 * _e595.x) - (_e595.z * _e587));
                        let _e610 = ((_e587 * _e595.y) - (_e595.x * _e588));
                        let _e612 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e617 = ((_e573 * _e612.z) - (_e612.y * _e574));
                        let _e622 = ((_e574 * _e612.x) - (_e612.z * _e572));
                        let _e627 = ((_e572 * _e612.y) - (_e612.x * _e573));
                        let _e654 = ((abs(((((_e440.row_z.x * _e600) + (_e440.row_z.y * _e605)) + (_e440.row_z.z * _e610)) / (((_e572 * _e600) + (_e573 * _e605)) + (_e574 * _e610)))) + abs(((((_e440.row_z.x * _e617) + (_e440.row_z.y * _e622)) + (_e440.row_z.z * _e627)) / (((_e587 * _e617) + (_e588 * _e622)) + (_e589 * _e627))))) / f32(_e542));
                        let _e656 = (16f / f32(_e542));
                        if (_e654 < _e656) {
                            phi_1445_ = _e654;
                        } else {
                            phi_1445_ = _e656;
                        }
                        let _e659 = phi_1445_;
                        phi_1446_ = _e659;
                    }
                    let _e661 = phi_1446_;
                    phi_1449_ = (_e429.point.depth - (0f * _e661));
                } else {
                    phi_1449_ = _e429.point.depth;
                }
                let _e665 = phi_1449_;
                let _e671 = p.member.map_size;
                let _e672 = f32(_e671);
                let _e675 = ((_e429.point.uv.x * _e672) - 0.5f);
                let _e676 = ((_e429.point.uv.y * _e672) - 0.5f);
                if (_e675 > -8388608f) {
                    let _e688 = f32(select(0i, select(select(i32(_e675), i32(-2147483648), (_e675 < bitcast<f32>(3472883712u))), 2147483647i, (_e675 > bitcast<f32>(1325400063u))), (_e675 == _e675)));
                    if (_e688 > _e675) {
                        phi_1478_ = 1f;
                    } else {
                        phi_1478_ = 0f;
                    }
                    let _e691 = phi_1478_;
                    if (_e675 < 8388608f) {
                        phi_1483_ = (_e688 - _e691);
                        phi_1484_ = false;
                    } else {
                        phi_1483_ = f32();
                        phi_1484_ = true;
                    }
                    let _e694 = phi_1483_;
                    let _e696 = phi_1484_;
                    phi_1485_ = _e694;
                    phi_1486_ = _e696;
                } else {
                    phi_1485_ = f32();
                    phi_1486_ = true;
                }
                let _e698 = phi_1485_;
                let _e700 = phi_1486_;
                if _e700 {
                    phi_1490_ = _e675;
                } else {
                    phi_1490_ = _e698;
                }
                let _e702 = phi_1490_;
                if (_e676 > -8388608f) {
                    let _e714 = f32(select(0i, select(select(i32(_e676), i32(-2147483648), (_e676 < bitcast<f32>(3472883712u))), 2147483647i, (_e676 > bitcast<f32>(1325400063u))), (_e676 == _e676)));
                    if (_e714 > _e676) {
                        phi_1510_ = 1f;
                    } else {
                        phi_1510_ = 0f;
                    }
                    let _e717 = phi_1510_;
                    if (_e676 < 8388608f) {
                        phi_1515_ = (_e714 - _e717);
                        phi_1516_ = false;
                    } else {
                        phi_1515_ = f32();
                        phi_1516_ = true;
                    }
                    let _e720 = phi_1515_;
                    let _e722 = phi_1516_;
                    phi_1517_ = _e720;
                    phi_1518_ = _e722;
                } else {
                    phi_1517_ = f32();
                    phi_1518_ = true;
                }
                let _e724 = phi_1517_;
                let _e726 = phi_1518_;
                if _e726 {
                    phi_1522_ = _e676;
                } else {
                    phi_1522_ = _e724;
                }
                let _e728 = phi_1522_;
                let _e729 = (_e675 - _e702);
                let _e730 = (_e676 - _e728);
                let _e739 = select(0i, select(select(i32(_e702), i32(-2147483648), (_e702 < bitcast<f32>(3472883712u))), 2147483647i, (_e702 > bitcast<f32>(1325400063u))), (_e702 == _e702));
                let _e748 = select(0i, select(select(i32(_e728), i32(-2147483648), (_e728 < bitcast<f32>(3472883712u))), 2147483647i, (_e728 > bitcast<f32>(1325400063u))), (_e728 == _e728));
                let _e759 = p.member.test;
                let _e760 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e759);
                let _e762 = p.member.map_size;
                let _e764 = local_3;
                local = _e760;
                let _e767 = ((_e764.level * _e762) * _e762);
                let _e769 = (bitcast<i32>(_e762) - 1i);
                if (_e739 > 0i) {
                    phi_1573_ = _e739;
                } else {
                    phi_1573_ = 0i;
                }
                let _e772 = phi_1573_;
                if (_e748 > 0i) {
                    phi_1578_ = _e748;
                } else {
                    phi_1578_ = 0i;
                }
                let _e775 = phi_1578_;
                if (_e772 < _e769) {
                    phi_1583_ = _e772;
                } else {
                    phi_1583_ = _e769;
                }
                let _e778 = phi_1583_;
                if (_e775 < _e769) {
                    phi_1588_ = _e775;
                } else {
                    phi_1588_ = _e769;
                }
                let _e781 = phi_1588_;
                let _e782 = bitcast<u32>(_e778);
                let _e784 = (_e739 + 1i);
                let _e785 = (_e748 + 1i);
                if (_e784 > 0i) {
                    phi_1597_ = _e784;
                } else {
                    phi_1597_ = 0i;
                }
                let _e788 = phi_1597_;
                if (_e785 > 0i) {
                    phi_1602_ = _e785;
                } else {
                    phi_1602_ = 0i;
                }
                let _e791 = phi_1602_;
                if (_e788 < _e769) {
                    phi_1607_ = _e788;
                } else {
                    phi_1607_ = _e769;
                }
                let _e794 = phi_1607_;
                if (_e791 < _e769) {
                    phi_1612_ = _e791;
                } else {
                    phi_1612_ = _e769;
                }
                let _e797 = phi_1612_;
                let _e798 = bitcast<u32>(_e794);
                let _e800 = (bitcast<u32>(_e781) * _e762);
                let _e801 = (bitcast<u32>(_e797) * _e762);
                let _e806 = ((_e800 + _e782) + _e767);
                let _e807 = ((_e800 + _e798) + _e767);
                let _e808 = ((_e801 + _e782) + _e767);
                let _e809 = ((_e801 + _e798) + _e767);
                if (_e806 < _e56) {
                } else {
                    return;
                }
                let _e813 = map.member[(0u + _e806)];
                if (_e807 < _e56) {
                } else {
                    return;
                }
                let _e817 = map.member[(0u + _e807)];
                if (_e808 < _e56) {
                } else {
                    return;
                }
                let _e821 = map.member[(0u + _e808)];
                if (_e809 < _e56) {
                } else {
                    return;
                }
                let _e825 = map.member[(0u + _e809)];
                let _e827 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e813, _e817, _e821, _e825), vec4<f32>(((1f - _e729) * (1f - _e730)), (_e729 * (1f - _e730)), ((1f - _e729) * _e730), (_e729 * _e730)), _e665);
                let _e829 = p.member.map_size;
                let _e831 = local_4;
                let _e834 = (bitcast<i32>(_e829) - 1i);
                if (_e739 > 0i) {
                    phi_1668_ = _e739;
                } else {
                    phi_1668_ = 0i;
                }
                let _e837 = phi_1668_;
                if (_e748 > 0i) {
                    phi_1673_ = _e748;
                } else {
                    phi_1673_ = 0i;
                }
                let _e840 = phi_1673_;
                if (_e837 < _e834) {
                    phi_1678_ = _e837;
                } else {
                    phi_1678_ = _e834;
                }
                let _e843 = phi_1678_;
                if (_e840 < _e834) {
                    phi_1683_ = _e840;
                } else {
                    phi_1683_ = _e834;
                }
                let _e846 = phi_1683_;
                let _e847 = bitcast<u32>(_e843);
                let _e854 = ((((_e831.level * _e829) + bitcast<u32>(_e846)) * (_e829 / 16u)) + (_e847 / 16u));
                let _e857 = (_e739 + 1i);
                let _e858 = (_e748 + 0i);
                let _e860 = (bitcast<i32>(_e829) - 1i);
                if (_e857 > 0i) {
                    phi_1702_ = _e857;
                } else {
                    phi_1702_ = 0i;
                }
                let _e863 = phi_1702_;
                if (_e858 > 0i) {
                    phi_1707_ = _e858;
                } else {
                    phi_1707_ = 0i;
                }
                let _e866 = phi_1707_;
                if (_e863 < _e860) {
                    phi_1712_ = _e863;
                } else {
                    phi_1712_ = _e860;
                }
                let _e869 = phi_1712_;
                if (_e866 < _e860) {
                    phi_1717_ = _e866;
                } else {
                    phi_1717_ = _e860;
                }
                let _e872 = phi_1717_;
                let _e873 = bitcast<u32>(_e869);
                let _e880 = ((((_e831.level * _e829) + bitcast<u32>(_e872)) * (_e829 / 16u)) + (_e873 / 16u));
                let _e883 = (_e739 + 0i);
                let _e884 = (_e748 + 1i);
                let _e886 = (bitcast<i32>(_e829) - 1i);
                if (_e883 > 0i) {
                    phi_1736_ = _e883;
                } else {
                    phi_1736_ = 0i;
                }
                let _e889 = phi_1736_;
                if (_e884 > 0i) {
                    phi_1741_ = _e884;
                } else {
                    phi_1741_ = 0i;
                }
                let _e892 = phi_1741_;
                if (_e889 < _e886) {
                    phi_1746_ = _e889;
                } else {
                    phi_1746_ = _e886;
                }
                let _e895 = phi_1746_;
                if (_e892 < _e886) {
                    phi_1751_ = _e892;
                } else {
                    phi_1751_ = _e886;
                }
                let _e898 = phi_1751_;
                let _e899 = bitcast<u32>(_e895);
                let _e906 = ((((_e831.level * _e829) + bitcast<u32>(_e898)) * (_e829 / 16u)) + (_e899 / 16u));
                let _e909 = (_e739 + 1i);
                let _e910 = (_e748 + 1i);
                let _e912 = (bitcast<i32>(_e829) - 1i);
                if (_e909 > 0i) {
                    phi_1770_ = _e909;
                } else {
                    phi_1770_ = 0i;
                }
                let _e915 = phi_1770_;
                if (_e910 > 0i) {
                    phi_1775_ = _e910;
                } else {
                    phi_1775_ = 0i;
                }
                let _e918 = phi_1775_;
                if (_e915 < _e912) {
                    phi_1780_ = _e915;
                } else {
                    phi_1780_ = _e912;
                }
                let _e921 = phi_1780_;
                if (_e918 < _e912) {
                    phi_1785_ = _e918;
                } else {
                    phi_1785_ = _e912;
                }
                let _e924 = phi_1785_;
                let _e925 = bitcast<u32>(_e921);
                let _e932 = ((((_e831.level * _e829) + bitcast<u32>(_e924)) * (_e829 / 16u)) + (_e925 / 16u));
                if (_e854 < _e62) {
                } else {
                    return;
                }
                let _e938 = marks.member[(0u + _e854)];
                if (_e880 < _e62) {
                } else {
                    return;
                }
                let _e946 = marks.member[(0u + _e880)];
                if (_e906 < _e62) {
                } else {
                    return;
                }
                let _e955 = marks.member[(0u + _e906)];
                if (_e932 < _e62) {
                } else {
                    return;
                }
                let _e963 = marks.member[(0u + _e932)];
                let _e971 = p.member.epsilon;
                if (_e827 <= _e971) {
                    phi_1863_ = true;
                } else {
                    phi_1863_ = (_e827 >= (1f - _e971));
                }
                let _e976 = phi_1863_;
                if ((bitcast<u32>(_e827) & 2147483647u) > 2139095040u) {
                    phi_1871_ = true;
                } else {
                    phi_1871_ = !(_e976);
                }
                let _e982 = phi_1871_;
                if _e982 {
                    if (_e827 > 0f) {
                        if (_e827 < 1f) {
                            phi_1883_ = false;
                        } else {
                            phi_1883_ = true;
                        }
                        let _e986 = phi_1883_;
                        phi_1884_ = _e986;
                    } else {
                        phi_1884_ = true;
                    }
                    let _e988 = phi_1884_;
                    if _e988 {
                        phi_1888_ = 0.5f;
                    } else {
                        phi_1888_ = _e827;
                    }
                    let _e990 = phi_1888_;
                    phi_1896_ = evaluate_Verdict(_e990, true);
                } else {
                    if (_e827 > 0.5f) {
                        phi_1894_ = 1f;
                    } else {
                        phi_1894_ = 0f;
                    }
                    let _e994 = phi_1894_;
                    phi_1896_ = evaluate_Verdict(_e994, false);
                }
                let _e997 = phi_1896_;
                let _e1000 = (_e997.visibility < 0.5f);
                if _e997.is_doubted {
                    phi_1919_ = evaluate_Verdict();
                    phi_1920_ = true;
                } else {
                    if _e1000 {
                        phi_1906_ = 2u;
                    } else {
                        phi_1906_ = 1u;
                    }
                    let _e1002 = phi_1906_;
                    if ((((((_e938 >> bitcast<u32>((((_e847 % 16u) * 2u) & 31u))) & 3u) | ((_e946 >> bitcast<u32>((((_e873 % 16u) * 2u) & 31u))) & 3u)) | (((_e955 >> bitcast<u32>((((_e899 % 16u) * 2u) & 31u))) & 3u) | ((_e963 >> bitcast<u32>((((_e925 % 16u) * 2u) & 31u))) & 3u))) & _e1002) != 0u) {
                        if _e1000 {
                            phi_1915_ = 0.000000059604645f;
                        } else {
                            phi_1915_ = 0.99999994f;
                        }
                        let _e1006 = phi_1915_;
                        phi_1917_ = evaluate_Verdict(_e1006, true);
                        phi_1918_ = false;
                    } else {
                        phi_1917_ = evaluate_Verdict();
                        phi_1918_ = true;
                    }
                    let _e1009 = phi_1917_;
                    let _e1011 = phi_1918_;
                    phi_1919_ = _e1009;
                    phi_1920_ = _e1011;
                }
                let _e1013 = phi_1919_;
                let _e1015 = phi_1920_;
                if _e1015 {
                    phi_1925_ = evaluate_Verdict(_e997.visibility, _e997.is_doubted);
                } else {
                    phi_1925_ = _e1013;
                }
                let _e1018 = phi_1925_;
                phi_1930_ = evaluate_Verdict(_e1018.visibility, _e1018.is_doubted);
            } else {
                phi_1930_ = evaluate_Verdict(0.5f, true);
            }
            let _e1024 = phi_1930_;
            phi_1931_ = _e1024;
        }
        let _e1026 = phi_1931_;
        if (_e71.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e71.first_primitive)] = _e1026.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_msm_levels_marks_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
