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

struct type_20 {
    member: array<abi_Sample>,
}

struct type_24 {
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
var<storage> samples: type_20;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
var<workgroup> shared_: array<atomic<u32>, 2>;
@group(0) @binding(0) 
var<uniform> p: type_39;
@group(0) @binding(2) 
var<storage> map: type_24;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_24;
@group(0) @binding(4) 
var<storage, read_write> list: type_51;
@group(0) @binding(5) 
var<storage> levels: type_45;

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

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
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
    var phi_820_: bool;
    var phi_833_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_848_: bool;
    var phi_849_: bool;
    var phi_850_: bool;
    var phi_854_: bool;
    var phi_905_: f32;
    var phi_906_: f32;
    var phi_907_: f32;
    var phi_924_: f32;
    var phi_925_: f32;
    var phi_926_: f32;
    var phi_943_: f32;
    var phi_944_: f32;
    var phi_945_: f32;
    var phi_962_: f32;
    var phi_963_: f32;
    var phi_964_: f32;
    var phi_987_: f32;
    var phi_988_: f32;
    var phi_989_: f32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_1088_: bool;
    var phi_1092_: f32;
    var phi_1093_: f32;
    var phi_1108_: f32;
    var phi_1109_: f32;
    var phi_1110_: f32;
    var phi_1111_: f32;
    var phi_1112_: f32;
    var phi_1113_: f32;
    var phi_1114_: f32;
    var phi_1115_: bool;
    var phi_1116_: f32;
    var phi_1117_: f32;
    var phi_1118_: bool;
    var phi_1122_: f32;

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
        phi_1116_ = _e127;
        phi_1117_ = f32();
        phi_1118_ = true;
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
            phi_1113_ = 1f;
            phi_1114_ = f32();
            phi_1115_ = true;
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
                phi_1111_ = _e507;
                phi_1112_ = f32();
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
                if ((_e529.near * _e159) >= (1f - 0.00001f)) {
                    phi_820_ = true;
                } else {
                    phi_820_ = ((_e529.near * _e160) >= (1f - 0.00001f));
                }
                let _e599 = phi_820_;
                if _e599 {
                    if ((_e529.far * _e159) >= (1f - 0.00001f)) {
                        phi_833_ = true;
                    } else {
                        phi_833_ = ((_e529.far * _e160) >= (1f - 0.00001f));
                    }
                    let _e607 = phi_833_;
                    if _e607 {
                        phi_837_ = false;
                    } else {
                        phi_837_ = true;
                    }
                    let _e609 = phi_837_;
                    phi_838_ = _e609;
                } else {
                    phi_838_ = true;
                }
                let _e611 = phi_838_;
                if _e611 {
                    let _e613 = (-(_e159) < 0.0001f);
                    if _e613 {
                        phi_848_ = bool();
                    } else {
                        phi_848_ = (_e160 < 0.0001f);
                    }
                    let _e616 = phi_848_;
                    phi_849_ = _e616;
                    phi_850_ = _e613;
                } else {
                    phi_849_ = bool();
                    phi_850_ = true;
                }
                let _e618 = phi_849_;
                let _e620 = phi_850_;
                if _e620 {
                    phi_854_ = true;
                } else {
                    phi_854_ = _e618;
                }
                let _e622 = phi_854_;
                if !(_e622) {
                    let _e628 = ((_e152 * _e76) * _e162);
                    let _e629 = ((_e154 * _e88) * _e164);
                    let _e630 = ((_e156 * _e100) * _e166);
                    let _e631 = ((_e158 * _e112) * _e168);
                    let _e649 = ((((_e628 * (_e113 * _e113)) + (_e629 * (_e114 * _e114))) + (_e630 * (_e115 * _e115))) + (_e631 * (_e116 * _e116)));
                    if (_e649 < 0.0000000000000000000000000000000001f) {
                        if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
                            phi_907_ = _e113;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_906_ = 0f;
                            } else {
                                if (_e113 < 0f) {
                                    phi_905_ = 0f;
                                } else {
                                    phi_905_ = 1f;
                                }
                                let _e659 = phi_905_;
                                phi_906_ = _e659;
                            }
                            let _e661 = phi_906_;
                            phi_907_ = _e661;
                        }
                        let _e663 = phi_907_;
                        if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
                            phi_926_ = _e114;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_925_ = 0f;
                            } else {
                                if (_e114 < 0f) {
                                    phi_924_ = 0f;
                                } else {
                                    phi_924_ = 1f;
                                }
                                let _e672 = phi_924_;
                                phi_925_ = _e672;
                            }
                            let _e674 = phi_925_;
                            phi_926_ = _e674;
                        }
                        let _e676 = phi_926_;
                        if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                            phi_945_ = _e115;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_944_ = 0f;
                            } else {
                                if (_e115 < 0f) {
                                    phi_943_ = 0f;
                                } else {
                                    phi_943_ = 1f;
                                }
                                let _e685 = phi_943_;
                                phi_944_ = _e685;
                            }
                            let _e687 = phi_944_;
                            phi_945_ = _e687;
                        }
                        let _e689 = phi_945_;
                        if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
                            phi_964_ = _e116;
                        } else {
                            if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                                phi_963_ = 0f;
                            } else {
                                if (_e116 < 0f) {
                                    phi_962_ = 0f;
                                } else {
                                    phi_962_ = 1f;
                                }
                                let _e698 = phi_962_;
                                phi_963_ = _e698;
                            }
                            let _e700 = phi_963_;
                            phi_964_ = _e700;
                        }
                        let _e702 = phi_964_;
                        let _e710 = (((((_e663 * _e152) + (_e676 * _e154)) + (_e689 * _e156)) + (_e702 * _e158)) + _e149);
                        if ((bitcast<u32>(_e710) & 2147483647u) > 2139095040u) {
                            phi_989_ = _e710;
                        } else {
                            if (_e710 < 0f) {
                                phi_988_ = 0f;
                            } else {
                                if (_e710 > 1f) {
                                    phi_987_ = 1f;
                                } else {
                                    phi_987_ = _e710;
                                }
                                let _e717 = phi_987_;
                                phi_988_ = _e717;
                            }
                            let _e719 = phi_988_;
                            phi_989_ = _e719;
                        }
                        let _e721 = phi_989_;
                        phi_1077_ = _e721;
                    } else {
                        let _e722 = (((((_e628 * _e113) + (_e629 * _e114)) + (_e630 * _e115)) + (_e631 * _e116)) / _e649);
                        let _e739 = ((_e152 * _e113) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e722 * _e113)));
                        let _e740 = ((_e154 * _e114) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e722 * _e114)));
                        let _e741 = ((_e156 * _e115) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e722 * _e115)));
                        let _e742 = ((_e158 * _e116) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e722 * _e116)));
                        if (_e722 > 0f) {
                            phi_1076_ = ((1f - _e149) - (((((_e739 * _e162) + (_e740 * _e164)) + (_e741 * _e166)) + (_e742 * _e168)) / (_e159 * (1f - (_e159 * _e722)))));
                        } else {
                            phi_1076_ = ((((((((_e628 * ((_e629 * _e173) + ((0.5f * _e630) * _e181))) * vec4<f32>(1f, 1f, 1f, 1f).x) + ((_e629 * ((_e630 * _e174) + ((0.5f * _e631) * _e182))) * vec4<f32>(1f, 1f, 1f, 1f).y)) + ((_e630 * ((_e631 * _e175) + ((0.5f * _e628) * _e183))) * vec4<f32>(1f, 1f, 1f, 1f).z)) + ((_e631 * ((_e628 * _e176) + ((0.5f * _e629) * _e184))) * vec4<f32>(1f, 1f, 1f, 1f).w)) / (_e649 * (-(_e159) * _e160))) + _e149) + (((((_e739 * _e76) + (_e740 * _e88)) + (_e741 * _e100)) + (_e742 * _e112)) / (_e160 * (1f - (_e722 * _e160)))));
                        }
                        let _e806 = phi_1076_;
                        phi_1077_ = _e806;
                    }
                    let _e808 = phi_1077_;
                    if ((bitcast<u32>(_e591) & 2147483647u) > 2139095040u) {
                        phi_1088_ = true;
                    } else {
                        let _e812 = (_e591 < _e808);
                        if _e812 {
                        }
                        phi_1088_ = _e812;
                    }
                    let _e814 = phi_1088_;
                    if _e814 {
                        phi_1092_ = _e591;
                    } else {
                        phi_1092_ = _e808;
                    }
                    let _e816 = phi_1092_;
                    phi_1093_ = _e816;
                } else {
                    phi_1093_ = _e591;
                }
                let _e818 = phi_1093_;
                if ((bitcast<u32>(_e818) & 2147483647u) > 2139095040u) {
                    phi_1110_ = _e818;
                } else {
                    if (_e818 < 0f) {
                        phi_1109_ = 0f;
                    } else {
                        if (_e818 > 1f) {
                            phi_1108_ = 1f;
                        } else {
                            phi_1108_ = _e818;
                        }
                        let _e825 = phi_1108_;
                        phi_1109_ = _e825;
                    }
                    let _e827 = phi_1109_;
                    phi_1110_ = _e827;
                }
                let _e829 = phi_1110_;
                phi_1111_ = f32();
                phi_1112_ = _e829;
            }
            let _e831 = phi_1111_;
            let _e833 = phi_1112_;
            phi_1113_ = _e831;
            phi_1114_ = _e833;
            phi_1115_ = _e436;
        }
        let _e835 = phi_1113_;
        let _e837 = phi_1114_;
        let _e839 = phi_1115_;
        phi_1116_ = _e835;
        phi_1117_ = _e837;
        phi_1118_ = _e839;
    }
    let _e841 = phi_1116_;
    let _e843 = phi_1117_;
    let _e845 = phi_1118_;
    if _e845 {
        phi_1122_ = _e841;
    } else {
        phi_1122_ = _e843;
    }
    let _e847 = phi_1122_;
    return _e847;
}

fn function_() {
    var local_1: f32;
    var phi_1177_: bool;
    var phi_1178_: bool;
    var phi_1179_: bool;
    var phi_1180_: bool;
    var phi_1184_: bool;
    var phi_1254_: bool;
    var phi_1255_: bool;
    var phi_1266_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1267_: bool;
    var phi_1268_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1269_: bool;
    var phi_1276_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1280_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1300_: lt_math_LightPoint;
    var phi_1303_: u32;
    var phi_1305_: lt_math_LevelPoint;
    var phi_1391_: bool;
    var phi_1400_: bool;
    var phi_1409_: bool;
    var phi_1410_: bool;
    var phi_1411_: bool;
    var phi_1412_: bool;
    var phi_1413_: bool;
    var phi_1414_: bool;
    var phi_1415_: bool;
    var phi_1419_: bool;
    var phi_1446_: bool;
    var phi_1447_: bool;
    var phi_1448_: bool;
    var phi_1449_: bool;
    var phi_1450_: bool;
    var phi_1451_: bool;
    var phi_1452_: bool;
    var phi_1453_: bool;
    var phi_1457_: bool;
    var phi_1466_: lt_math_LightPoint;
    var phi_1467_: u32;
    var phi_1468_: lt_math_LevelPoint;
    var phi_1469_: bool;
    var phi_1301_: lt_math_LightPoint;
    var phi_1304_: u32;
    var phi_1306_: lt_math_LevelPoint;
    var phi_1470_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1510_: bool;
    var phi_1511_: bool;
    var phi_1512_: bool;
    var phi_1513_: bool;
    var phi_1517_: bool;
    var phi_1599_: f32;
    var phi_1717_: f32;
    var phi_1718_: f32;
    var phi_1721_: f32;
    var phi_1750_: f32;
    var phi_1755_: f32;
    var phi_1756_: bool;
    var phi_1757_: f32;
    var phi_1758_: bool;
    var phi_1762_: f32;
    var phi_1782_: f32;
    var phi_1787_: f32;
    var phi_1788_: bool;
    var phi_1789_: f32;
    var phi_1790_: bool;
    var phi_1794_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1843_: i32;
    var phi_1848_: i32;
    var phi_1853_: i32;
    var phi_1858_: i32;
    var phi_1867_: i32;
    var phi_1872_: i32;
    var phi_1877_: i32;
    var phi_1882_: i32;
    var phi_1933_: bool;
    var phi_1941_: bool;
    var phi_1953_: bool;
    var phi_1954_: bool;
    var phi_1958_: f32;
    var phi_1964_: f32;
    var phi_1966_: evaluate_Verdict;
    var phi_1971_: evaluate_Verdict;
    var phi_1972_: evaluate_Verdict;
    var phi_1976_: bool;
    var phi_1977_: u32;
    var phi_1988_: u32;

    let _e49 = id_1;
    let _e50 = local_5;
    let _e55 = arrayLength((&map.member));
    let _e60 = arrayLength((&levels.member));
    let _e63 = p.member.size[0u];
    let _e65 = p.member.size[1u];
    let _e66 = lt_shaders_entry_pixel_index(_e49, _e63, _e65);
    if (bitcast<i32>(_e66.root) != 0i) {
        let _e73 = p.member.level_count;
        let _e77 = samples.member[_e66.first_primitive].normal[0u];
        let _e79 = global[0u];
        if (_e77 == _e79) {
            let _e82 = samples.member[_e66.first_primitive].normal[1u];
            let _e84 = global[1u];
            if (_e82 == _e84) {
                let _e87 = samples.member[_e66.first_primitive].normal[2u];
                let _e89 = global[2u];
                phi_1177_ = (_e87 == _e89);
                phi_1178_ = false;
            } else {
                phi_1177_ = bool();
                phi_1178_ = true;
            }
            let _e92 = phi_1177_;
            let _e94 = phi_1178_;
            phi_1179_ = _e92;
            phi_1180_ = _e94;
        } else {
            phi_1179_ = bool();
            phi_1180_ = true;
        }
        let _e96 = phi_1179_;
        let _e98 = phi_1180_;
        if _e98 {
            phi_1184_ = false;
        } else {
            phi_1184_ = _e96;
        }
        let _e100 = phi_1184_;
        if !(_e100) {
            let _e103 = samples.member[_e66.first_primitive].position;
            let _e105 = p.member.light.place;
            let _e111 = p.member.light.place[3u];
            let _e118 = (_e105.x - (_e103.x * _e111));
            let _e119 = (_e105.y - (_e103.y * _e111));
            let _e120 = (_e105.z - (_e103.z * _e111));
            let _e122 = samples.member[_e66.first_primitive].normal;
            if ((((_e122.x * _e118) + (_e122.y * _e119)) + (_e122.z * _e120)) > 0f) {
                let _e136 = (((_e118 * _e118) + (_e119 * _e119)) + (_e120 * _e120));
                let _e138 = p.member.light.axis;
                let _e150 = p.member.light.place[3u];
                if (_e150 == 0f) {
                    phi_1255_ = true;
                } else {
                    let _e153 = p.member.light.range_squared;
                    if (_e136 <= _e153) {
                        let _e156 = p.member.light.cos_outer;
                        phi_1254_ = (-((((_e118 * _e138.x) + (_e119 * _e138.y)) + (_e120 * _e138.z))) >= (_e156 * sqrt(_e136)));
                    } else {
                        phi_1254_ = false;
                    }
                    let _e161 = phi_1254_;
                    phi_1255_ = _e161;
                }
                let _e163 = phi_1255_;
                if _e163 {
                    let _e165 = samples.member[_e66.first_primitive].flags;
                    let _e173 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e179 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e173.unnamed.visibility, false), _e173.unnamed_1);
                    phi_1266_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e179.unnamed, ((_e165 & 1u) == 0u));
                    phi_1267_ = false;
                } else {
                    phi_1266_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_1267_ = true;
                }
                let _e184 = phi_1266_;
                let _e186 = phi_1267_;
                phi_1268_ = _e184;
                phi_1269_ = _e186;
            } else {
                phi_1268_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_1269_ = true;
            }
            let _e188 = phi_1268_;
            let _e190 = phi_1269_;
            if _e190 {
                let _e196 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e202 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e196.unnamed.visibility, false), _e196.unnamed_1);
                phi_1276_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e202.unnamed, true);
            } else {
                phi_1276_ = _e188;
            }
            let _e207 = phi_1276_;
            phi_1280_ = _e207;
        } else {
            let _e213 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e219 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e213.unnamed.visibility, false), _e213.unnamed_1);
            phi_1280_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e219.unnamed, true);
        }
        let _e224 = phi_1280_;
        if _e224.unnamed_1 {
            phi_1972_ = evaluate_Verdict(_e224.unnamed.visibility, _e224.unnamed.is_doubted);
        } else {
            let _e232 = samples.member[_e66.first_primitive].position;
            let _e234 = p.member.map_size;
            let _e236 = (0.5f / f32(_e234));
            let _e243 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e250 = lt_math_LightPoint(vec2<f32>(_e243.uv.x, 0f), _e243.depth, _e243.is_inside);
            let _e254 = lt_math_LightPoint(_e250.uv, 0f, _e250.is_inside);
            phi_1300_ = lt_math_LightPoint();
            phi_1303_ = 0u;
            phi_1305_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e254.uv, _e254.depth, false));
            loop {
                let _e261 = phi_1300_;
                let _e263 = phi_1303_;
                let _e265 = phi_1305_;
                local_2 = _e265;
                local_3 = _e265;
                local_4 = _e265;
                if (_e263 < _e73) {
                    if _e265.point.is_inside {
                        phi_1466_ = lt_math_LightPoint();
                        phi_1467_ = u32();
                        phi_1468_ = lt_math_LevelPoint();
                        phi_1469_ = false;
                    } else {
                        if (_e263 < _e60) {
                        } else {
                            return;
                        }
                        let _e276 = levels.member[(0u + _e263)].row_w;
                        let _e287 = ((((_e276.x * _e232.x) + (_e276.y * _e232.y)) + (_e276.z * _e232.z)) + (_e276.w * 1f));
                        let _e289 = levels.member[(0u + _e263)].row_x;
                        let _e301 = (((((_e289.x * _e232.x) + (_e289.y * _e232.y)) + (_e289.z * _e232.z)) + (_e289.w * 1f)) / _e287);
                        let _e303 = levels.member[(0u + _e263)].row_y;
                        let _e315 = (((((_e303.x * _e232.x) + (_e303.y * _e232.y)) + (_e303.z * _e232.z)) + (_e303.w * 1f)) / _e287);
                        let _e317 = levels.member[(0u + _e263)].row_z;
                        let _e328 = ((((_e317.x * _e232.x) + (_e317.y * _e232.y)) + (_e317.z * _e232.z)) + (_e317.w * 1f));
                        if (_e287 > 0f) {
                            if (_e301 >= 0f) {
                                phi_1391_ = (_e301 <= 1f);
                            } else {
                                phi_1391_ = false;
                            }
                            let _e333 = phi_1391_;
                            if _e333 {
                                if (_e315 >= 0f) {
                                    phi_1400_ = (_e315 <= 1f);
                                } else {
                                    phi_1400_ = false;
                                }
                                let _e337 = phi_1400_;
                                if _e337 {
                                    if (_e328 >= 0f) {
                                        phi_1409_ = (_e328 <= 1f);
                                    } else {
                                        phi_1409_ = false;
                                    }
                                    let _e341 = phi_1409_;
                                    phi_1410_ = _e341;
                                    phi_1411_ = false;
                                } else {
                                    phi_1410_ = bool();
                                    phi_1411_ = true;
                                }
                                let _e343 = phi_1410_;
                                let _e345 = phi_1411_;
                                phi_1412_ = _e343;
                                phi_1413_ = _e345;
                            } else {
                                phi_1412_ = bool();
                                phi_1413_ = true;
                            }
                            let _e347 = phi_1412_;
                            let _e349 = phi_1413_;
                            phi_1414_ = _e347;
                            phi_1415_ = _e349;
                        } else {
                            phi_1414_ = bool();
                            phi_1415_ = true;
                        }
                        let _e351 = phi_1414_;
                        let _e353 = phi_1415_;
                        if _e353 {
                            phi_1419_ = false;
                        } else {
                            phi_1419_ = _e351;
                        }
                        let _e355 = phi_1419_;
                        if _e355 {
                            if (_e301 >= _e236) {
                                if (_e301 <= (1f - _e236)) {
                                    if (_e315 >= _e236) {
                                        phi_1446_ = (_e315 <= (1f - _e236));
                                        phi_1447_ = false;
                                    } else {
                                        phi_1446_ = bool();
                                        phi_1447_ = true;
                                    }
                                    let _e363 = phi_1446_;
                                    let _e365 = phi_1447_;
                                    phi_1448_ = _e363;
                                    phi_1449_ = _e365;
                                } else {
                                    phi_1448_ = bool();
                                    phi_1449_ = true;
                                }
                                let _e367 = phi_1448_;
                                let _e369 = phi_1449_;
                                phi_1450_ = _e367;
                                phi_1451_ = _e369;
                            } else {
                                phi_1450_ = bool();
                                phi_1451_ = true;
                            }
                            let _e371 = phi_1450_;
                            let _e373 = phi_1451_;
                            phi_1452_ = _e371;
                            phi_1453_ = _e373;
                        } else {
                            phi_1452_ = bool();
                            phi_1453_ = true;
                        }
                        let _e375 = phi_1452_;
                        let _e377 = phi_1453_;
                        if _e377 {
                            phi_1457_ = false;
                        } else {
                            phi_1457_ = _e375;
                        }
                        let _e379 = phi_1457_;
                        let _e386 = lt_math_LightPoint(vec2<f32>(_e301, _e261.uv.y), _e261.depth, _e261.is_inside);
                        let _e393 = lt_math_LightPoint(vec2<f32>(_e386.uv.x, _e315), _e386.depth, _e386.is_inside);
                        let _e397 = lt_math_LightPoint(_e393.uv, _e328, _e393.is_inside);
                        let _e401 = lt_math_LightPoint(_e397.uv, _e397.depth, _e379);
                        phi_1466_ = _e401;
                        phi_1467_ = (_e263 + 1u);
                        phi_1468_ = lt_math_LevelPoint(_e263, _e401);
                        phi_1469_ = true;
                    }
                    let _e405 = phi_1466_;
                    let _e407 = phi_1467_;
                    let _e409 = phi_1468_;
                    let _e411 = phi_1469_;
                    phi_1301_ = _e405;
                    phi_1304_ = _e407;
                    phi_1306_ = _e409;
                    phi_1470_ = _e411;
                } else {
                    phi_1301_ = lt_math_LightPoint();
                    phi_1304_ = u32();
                    phi_1306_ = lt_math_LevelPoint();
                    phi_1470_ = false;
                }
                let _e413 = phi_1301_;
                let _e415 = phi_1304_;
                let _e417 = phi_1306_;
                let _e419 = phi_1470_;
                continue;
                continuing {
                    phi_1300_ = _e413;
                    phi_1303_ = _e415;
                    phi_1305_ = _e417;
                    break if !(_e419);
                }
            }
            let _e422 = local_2;
            if _e422.point.is_inside {
                if (0f > 0f) {
                    let _e428 = local_3;
                    if (_e428.level < _e60) {
                    } else {
                        return;
                    }
                    let _e433 = levels.member[(0u + _e428.level)];
                    let _e439 = global[0u];
                    if (_e433.row_w.x == _e439) {
                        let _e442 = global[1u];
                        if (_e433.row_w.y == _e442) {
                            let _e445 = global[2u];
                            phi_1510_ = (_e433.row_w.z == _e445);
                            phi_1511_ = false;
                        } else {
                            phi_1510_ = bool();
                            phi_1511_ = true;
                        }
                        let _e448 = phi_1510_;
                        let _e450 = phi_1511_;
                        phi_1512_ = _e448;
                        phi_1513_ = _e450;
                    } else {
                        phi_1512_ = bool();
                        phi_1513_ = true;
                    }
                    let _e452 = phi_1512_;
                    let _e454 = phi_1513_;
                    if _e454 {
                        phi_1517_ = false;
                    } else {
                        phi_1517_ = _e452;
                    }
                    let _e456 = phi_1517_;
                    if _e456 {
                        let _e458 = samples.member[_e66.first_primitive].normal;
                        let _e460 = p.member.map_size;
                        let _e530 = ((abs(((((_e433.row_x.x * _e458.x) + (_e433.row_x.y * _e458.y)) + (_e433.row_x.z * _e458.z)) / (((_e433.row_x.x * _e433.row_x.x) + (_e433.row_x.y * _e433.row_x.y)) + (_e433.row_x.z * _e433.row_x.z)))) + abs(((((_e433.row_y.x * _e458.x) + (_e433.row_y.y * _e458.y)) + (_e433.row_y.z * _e458.z)) / (((_e433.row_y.x * _e433.row_y.x) + (_e433.row_y.y * _e433.row_y.y)) + (_e433.row_y.z * _e433.row_y.z))))) / (abs(((((_e433.row_z.x * _e458.x) + (_e433.row_z.y * _e458.y)) + (_e433.row_z.z * _e458.z)) / (((_e433.row_z.x * _e433.row_z.x) + (_e433.row_z.y * _e433.row_z.y)) + (_e433.row_z.z * _e433.row_z.z)))) * f32(_e460)));
                        if (_e530 < 0.002f) {
                            phi_1599_ = _e530;
                        } else {
                            phi_1599_ = 0.002f;
                        }
                        let _e533 = phi_1599_;
                        phi_1718_ = _e533;
                    } else {
                        let _e535 = p.member.map_size;
                        let _e541 = samples.member[_e66.first_primitive].position;
                        let _e552 = ((((_e433.row_w.x * _e541.x) + (_e433.row_w.y * _e541.y)) + (_e433.row_w.z * _e541.z)) + _e433.row_w.w);
                        let _e565 = ((_e433.row_x.x - (_e433.row_w.x * _e422.point.uv.x)) / _e552);
                        let _e566 = ((_e433.row_x.y - (_e433.row_w.y * _e422.point.uv.x)) / _e552);
                        let _e567 = ((_e433.row_x.z - (_e433.row_w.z * _e422.point.uv.x)) / _e552);
                        let _e580 = ((_e433.row_y.x - (_e433.row_w.x * _e422.point.uv.y)) / _e552);
                        let _e581 = ((_e433.row_y.y - (_e433.row_w.y * _e422.point.uv.y)) / _e552);
                        let _e582 = ((_e433.row_y.z - (_e433.row_w.z * _e422.point.uv.y)) / _e552);
                        let _e588 = samples.member[_e66.first_primitive].normal;
                        let _e593 = ((_e581 * _e588.z) - (_e588.y * _e582));
                        let _e598 = ((_e582 * _e588.x) - (_e588.z * _e580));
                        let _e603 = ((_e580 * _e588.y) - (_e588.x * _e581));
                        let _e605 = samples.member[_e66.first_primitive].normal;
                        let _e610 = ((_e566 * _e605.z) - (_e605.y * _e567));
                        let _e615 = ((_e567 * _e605.x) - (_e605.z * _e565));
                        let _e620 = ((_e565 * _e605.y) - (_e605.x * _e566));
                        let _e647 = ((abs(((((_e433.row_z.x * _e593) + (_e433.row_z.y * _e598)) + (_e433.row_z.z * _e603)) / (((_e565 * _e593) + (_e566 * _e598)) + (_e567 * _e603)))) + abs(((((_e433.row_z.x * _e610) + (_e433.row_z.y * _e615)) + (_e433.row_z.z * _e620)) / (((_e580 * _e610) + (_e581 * _e615)) + (_e582 * _e620))))) / f32(_e535));
                        let _e649 = (16f / f32(_e535));
                        if (_e647 < _e649) {
                            phi_1717_ = _e647;
                        } else {
                            phi_1717_ = _e649;
                        }
                        let _e652 = phi_1717_;
                        phi_1718_ = _e652;
                    }
                    let _e654 = phi_1718_;
                    phi_1721_ = (_e422.point.depth - (0f * _e654));
                } else {
                    phi_1721_ = _e422.point.depth;
                }
                let _e658 = phi_1721_;
                let _e664 = p.member.map_size;
                let _e665 = f32(_e664);
                let _e668 = ((_e422.point.uv.x * _e665) - 0.5f);
                let _e669 = ((_e422.point.uv.y * _e665) - 0.5f);
                if (_e668 > -8388608f) {
                    let _e681 = f32(select(0i, select(select(i32(_e668), i32(-2147483648), (_e668 < bitcast<f32>(3472883712u))), 2147483647i, (_e668 > bitcast<f32>(1325400063u))), (_e668 == _e668)));
                    if (_e681 > _e668) {
                        phi_1750_ = 1f;
                    } else {
                        phi_1750_ = 0f;
                    }
                    let _e684 = phi_1750_;
                    if (_e668 < 8388608f) {
                        phi_1755_ = (_e681 - _e684);
                        phi_1756_ = false;
                    } else {
                        phi_1755_ = f32();
                        phi_1756_ = true;
                    }
                    let _e687 = phi_1755_;
                    let _e689 = phi_1756_;
                    phi_1757_ = _e687;
                    phi_1758_ = _e689;
                } else {
                    phi_1757_ = f32();
                    phi_1758_ = true;
                }
                let _e691 = phi_1757_;
                let _e693 = phi_1758_;
                if _e693 {
                    phi_1762_ = _e668;
                } else {
                    phi_1762_ = _e691;
                }
                let _e695 = phi_1762_;
                if (_e669 > -8388608f) {
                    let _e707 = f32(select(0i, select(select(i32(_e669), i32(-2147483648), (_e669 < bitcast<f32>(3472883712u))), 2147483647i, (_e669 > bitcast<f32>(1325400063u))), (_e669 == _e669)));
                    if (_e707 > _e669) {
                        phi_1782_ = 1f;
                    } else {
                        phi_1782_ = 0f;
                    }
                    let _e710 = phi_1782_;
                    if (_e669 < 8388608f) {
                        phi_1787_ = (_e707 - _e710);
                        phi_1788_ = false;
                    } else {
                        phi_1787_ = f32();
                        phi_1788_ = true;
                    }
                    let _e713 = phi_1787_;
                    let _e715 = phi_1788_;
                    phi_1789_ = _e713;
                    phi_1790_ = _e715;
                } else {
                    phi_1789_ = f32();
                    phi_1790_ = true;
                }
                let _e717 = phi_1789_;
                let _e719 = phi_1790_;
                if _e719 {
                    phi_1794_ = _e669;
                } else {
                    phi_1794_ = _e717;
                }
                let _e721 = phi_1794_;
                let _e722 = (_e668 - _e695);
                let _e723 = (_e669 - _e721);
                let _e732 = select(0i, select(select(i32(_e695), i32(-2147483648), (_e695 < bitcast<f32>(3472883712u))), 2147483647i, (_e695 > bitcast<f32>(1325400063u))), (_e695 == _e695));
                let _e741 = select(0i, select(select(i32(_e721), i32(-2147483648), (_e721 < bitcast<f32>(3472883712u))), 2147483647i, (_e721 > bitcast<f32>(1325400063u))), (_e721 == _e721));
                let _e752 = p.member.test;
                let _e753 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e752);
                let _e755 = p.member.map_size;
                let _e757 = local_4;
                local_1 = _e753;
                let _e760 = ((_e757.level * _e755) * _e755);
                let _e762 = (bitcast<i32>(_e755) - 1i);
                if (_e732 > 0i) {
                    phi_1843_ = _e732;
                } else {
                    phi_1843_ = 0i;
                }
                let _e765 = phi_1843_;
                if (_e741 > 0i) {
                    phi_1848_ = _e741;
                } else {
                    phi_1848_ = 0i;
                }
                let _e768 = phi_1848_;
                if (_e765 < _e762) {
                    phi_1853_ = _e765;
                } else {
                    phi_1853_ = _e762;
                }
                let _e771 = phi_1853_;
                if (_e768 < _e762) {
                    phi_1858_ = _e768;
                } else {
                    phi_1858_ = _e762;
                }
                let _e774 = phi_1858_;
                let _e775 = bitcast<u32>(_e771);
                let _e777 = (_e732 + 1i);
                let _e778 = (_e741 + 1i);
                if (_e777 > 0i) {
                    phi_1867_ = _e777;
                } else {
                    phi_1867_ = 0i;
                }
                let _e781 = phi_1867_;
                if (_e778 > 0i) {
                    phi_1872_ = _e778;
                } else {
                    phi_1872_ = 0i;
                }
                let _e784 = phi_1872_;
                if (_e781 < _e762) {
                    phi_1877_ = _e781;
                } else {
                    phi_1877_ = _e762;
                }
                let _e787 = phi_1877_;
                if (_e784 < _e762) {
                    phi_1882_ = _e784;
                } else {
                    phi_1882_ = _e762;
                }
                let _e790 = phi_1882_;
                let _e791 = bitcast<u32>(_e787);
                let _e793 = (bitcast<u32>(_e774) * _e755);
                let _e794 = (bitcast<u32>(_e790) * _e755);
                let _e799 = ((_e793 + _e775) + _e760);
                let _e800 = ((_e793 + _e791) + _e760);
                let _e801 = ((_e794 + _e775) + _e760);
                let _e802 = ((_e794 + _e791) + _e760);
                if (_e799 < _e55) {
                } else {
                    return;
                }
                let _e806 = map.member[(0u + _e799)];
                if (_e800 < _e55) {
                } else {
                    return;
                }
                let _e810 = map.member[(0u + _e800)];
                if (_e801 < _e55) {
                } else {
                    return;
                }
                let _e814 = map.member[(0u + _e801)];
                if (_e802 < _e55) {
                } else {
                    return;
                }
                let _e818 = map.member[(0u + _e802)];
                let _e820 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e806, _e810, _e814, _e818), vec4<f32>(((1f - _e722) * (1f - _e723)), (_e722 * (1f - _e723)), ((1f - _e722) * _e723), (_e722 * _e723)), _e658);
                let _e822 = p.member.epsilon;
                if (_e820 <= _e822) {
                    phi_1933_ = true;
                } else {
                    phi_1933_ = (_e820 >= (1f - _e822));
                }
                let _e827 = phi_1933_;
                if ((bitcast<u32>(_e820) & 2147483647u) > 2139095040u) {
                    phi_1941_ = true;
                } else {
                    phi_1941_ = !(_e827);
                }
                let _e833 = phi_1941_;
                if _e833 {
                    if (_e820 > 0f) {
                        if (_e820 < 1f) {
                            phi_1953_ = false;
                        } else {
                            phi_1953_ = true;
                        }
                        let _e837 = phi_1953_;
                        phi_1954_ = _e837;
                    } else {
                        phi_1954_ = true;
                    }
                    let _e839 = phi_1954_;
                    if _e839 {
                        phi_1958_ = 0.5f;
                    } else {
                        phi_1958_ = _e820;
                    }
                    let _e841 = phi_1958_;
                    phi_1966_ = evaluate_Verdict(_e841, true);
                } else {
                    if (_e820 > 0.5f) {
                        phi_1964_ = 1f;
                    } else {
                        phi_1964_ = 0f;
                    }
                    let _e845 = phi_1964_;
                    phi_1966_ = evaluate_Verdict(_e845, false);
                }
                let _e848 = phi_1966_;
                phi_1971_ = evaluate_Verdict(_e848.visibility, _e848.is_doubted);
            } else {
                phi_1971_ = evaluate_Verdict(0.5f, true);
            }
            let _e854 = phi_1971_;
            phi_1972_ = _e854;
        }
        let _e856 = phi_1972_;
        visibility.member[_e66.first_primitive] = _e856.visibility;
        phi_1976_ = _e856.is_doubted;
        phi_1977_ = _e66.first_primitive;
    } else {
        phi_1976_ = false;
        phi_1977_ = 0u;
    }
    let _e861 = phi_1976_;
    let _e863 = phi_1977_;
    if (_e50 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e861 {
        let _e867 = atomicAdd((&shared_[0u]), 1u);
        phi_1988_ = _e867;
    } else {
        phi_1988_ = 0u;
    }
    let _e869 = phi_1988_;
    workgroupBarrier();
    if (_e50 == 0u) {
        let _e873 = atomicLoad((&shared_[0u]));
        let _e874 = atomicAdd((&list.member[3u]), _e873);
        atomicStore((&shared_[1u]), _e874);
    }
    workgroupBarrier();
    if _e861 {
        let _e877 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e877) + _e869)]), _e863);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
