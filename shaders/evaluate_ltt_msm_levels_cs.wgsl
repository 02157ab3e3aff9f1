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

struct type_43 {
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
var<storage> levels: type_43;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_170_: lt_bvh_traverse_Tree;
    var phi_171_: bool;
    var phi_172_: lt_bvh_traverse_Tree;
    var phi_173_: bool;
    var phi_178_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_170_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_171_ = false;
        } else {
            phi_170_ = lt_bvh_traverse_Tree();
            phi_171_ = true;
        }
        let _e63 = phi_170_;
        let _e65 = phi_171_;
        phi_172_ = _e63;
        phi_173_ = _e65;
    } else {
        phi_172_ = lt_bvh_traverse_Tree();
        phi_173_ = true;
    }
    let _e67 = phi_172_;
    let _e69 = phi_173_;
    if _e69 {
        phi_178_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_178_ = _e67;
    }
    let _e74 = phi_178_;
    return lt_bvh_traverse_Tree(_e74.root, _e74.first_primitive);
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: ptr<function, f32>, param_5: vec4<f32>, param_6: vec4<f32>, param_7: f32) -> f32 {
    var phi_205_: f32;
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_224_: f32;
    var phi_225_: f32;
    var phi_226_: f32;
    var phi_242_: f32;
    var phi_243_: f32;
    var phi_244_: f32;
    var phi_260_: f32;
    var phi_261_: f32;
    var phi_262_: f32;
    var phi_278_: f32;
    var phi_279_: f32;
    var phi_280_: f32;
    var phi_315_: bool;
    var phi_316_: bool;
    var phi_317_: bool;
    var phi_318_: bool;
    var phi_319_: bool;
    var phi_320_: bool;
    var phi_324_: bool;
    var phi_635_: f32;
    var phi_636_: f32;
    var phi_637_: f32;
    var phi_654_: f32;
    var phi_655_: f32;
    var phi_656_: f32;
    var phi_673_: f32;
    var phi_674_: f32;
    var phi_675_: f32;
    var phi_692_: f32;
    var phi_693_: f32;
    var phi_694_: f32;
    var phi_717_: f32;
    var phi_718_: f32;
    var phi_719_: f32;
    var phi_730_: f32;
    var phi_745_: f32;
    var phi_747_: lt_bvh_slab_Span;
    var phi_805_: f32;
    var phi_806_: f32;
    var phi_807_: f32;
    var phi_808_: f32;
    var phi_809_: f32;
    var phi_810_: bool;
    var phi_814_: f32;
    var phi_829_: f32;
    var phi_830_: f32;
    var phi_831_: f32;
    var phi_832_: f32;
    var phi_833_: f32;
    var phi_834_: f32;
    var phi_835_: f32;
    var phi_836_: bool;
    var phi_837_: f32;
    var phi_838_: f32;
    var phi_839_: bool;
    var phi_843_: f32;

    let _e54 = (*param_4);
    if ((bitcast<u32>(param_7) & 2147483647u) > 2139095040u) {
        phi_207_ = param_7;
    } else {
        if (param_7 < 0f) {
            phi_206_ = 0f;
        } else {
            if (param_7 > 1f) {
                phi_205_ = 1f;
            } else {
                phi_205_ = param_7;
            }
            let _e61 = phi_205_;
            phi_206_ = _e61;
        }
        let _e63 = phi_206_;
        phi_207_ = _e63;
    }
    let _e65 = phi_207_;
    let _e66 = (_e65 - 0.00000047683716f);
    if ((bitcast<u32>(param_5.x) & 2147483647u) > 2139095040u) {
        phi_226_ = param_5.x;
    } else {
        if (param_5.x < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_5.x > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_5.x;
            }
            let _e74 = phi_224_;
            phi_225_ = _e74;
        }
        let _e76 = phi_225_;
        phi_226_ = _e76;
    }
    let _e78 = phi_226_;
    if ((bitcast<u32>(param_5.y) & 2147483647u) > 2139095040u) {
        phi_244_ = param_5.y;
    } else {
        if (param_5.y < 0f) {
            phi_243_ = 0f;
        } else {
            if (param_5.y > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = param_5.y;
            }
            let _e86 = phi_242_;
            phi_243_ = _e86;
        }
        let _e88 = phi_243_;
        phi_244_ = _e88;
    }
    let _e90 = phi_244_;
    if ((bitcast<u32>(param_5.z) & 2147483647u) > 2139095040u) {
        phi_262_ = param_5.z;
    } else {
        if (param_5.z < 0f) {
            phi_261_ = 0f;
        } else {
            if (param_5.z > 1f) {
                phi_260_ = 1f;
            } else {
                phi_260_ = param_5.z;
            }
            let _e98 = phi_260_;
            phi_261_ = _e98;
        }
        let _e100 = phi_261_;
        phi_262_ = _e100;
    }
    let _e102 = phi_262_;
    if ((bitcast<u32>(param_5.w) & 2147483647u) > 2139095040u) {
        phi_280_ = param_5.w;
    } else {
        if (param_5.w < 0f) {
            phi_279_ = 0f;
        } else {
            if (param_5.w > 1f) {
                phi_278_ = 1f;
            } else {
                phi_278_ = param_5.w;
            }
            let _e110 = phi_278_;
            phi_279_ = _e110;
        }
        let _e112 = phi_279_;
        phi_280_ = _e112;
    }
    let _e114 = phi_280_;
    let _e115 = (_e78 - _e66);
    let _e116 = (_e90 - _e66);
    let _e117 = (_e102 - _e66);
    let _e118 = (_e114 - _e66);
    let _e129 = ((((_e115 * param_6.x) + (_e116 * param_6.y)) + (_e117 * param_6.z)) + (_e118 * param_6.w));
    if ((bitcast<u32>(_e129) & 2147483647u) > 2139095040u) {
        phi_837_ = _e129;
        phi_838_ = f32();
        phi_839_ = true;
    } else {
        if (_e115 >= 0f) {
            if (_e116 >= 0f) {
                if (_e117 >= 0f) {
                    phi_315_ = (_e118 >= 0f);
                    phi_316_ = false;
                } else {
                    phi_315_ = bool();
                    phi_316_ = true;
                }
                let _e138 = phi_315_;
                let _e140 = phi_316_;
                phi_317_ = _e138;
                phi_318_ = _e140;
            } else {
                phi_317_ = bool();
                phi_318_ = true;
            }
            let _e142 = phi_317_;
            let _e144 = phi_318_;
            phi_319_ = _e142;
            phi_320_ = _e144;
        } else {
            phi_319_ = bool();
            phi_320_ = true;
        }
        let _e146 = phi_319_;
        let _e148 = phi_320_;
        if _e148 {
            phi_324_ = false;
        } else {
            phi_324_ = _e146;
        }
        let _e150 = phi_324_;
        if _e150 {
            phi_834_ = 1f;
            phi_835_ = f32();
            phi_836_ = true;
        } else {
            let _e151 = (0.5f * _e54);
            let _e152 = (1f - _e54);
            let _e154 = (param_6.x * _e152);
            let _e156 = (param_6.y * _e152);
            let _e158 = (param_6.z * _e152);
            let _e160 = (param_6.w * _e152);
            let _e161 = -(_e66);
            let _e162 = (1f - _e66);
            let _e164 = (vec4<f32>(1f, 1f, 1f, 1f).x - _e78);
            let _e166 = (vec4<f32>(1f, 1f, 1f, 1f).y - _e90);
            let _e168 = (vec4<f32>(1f, 1f, 1f, 1f).z - _e102);
            let _e170 = (vec4<f32>(1f, 1f, 1f, 1f).w - _e114);
            let _e171 = (_e115 - _e116);
            let _e172 = (_e116 - _e117);
            let _e173 = (_e117 - _e118);
            let _e174 = (_e118 - _e115);
            let _e175 = (_e171 * _e171);
            let _e176 = (_e172 * _e172);
            let _e177 = (_e173 * _e173);
            let _e178 = (_e174 * _e174);
            let _e179 = (_e115 - _e117);
            let _e180 = (_e116 - _e118);
            let _e181 = (_e117 - _e115);
            let _e182 = (_e118 - _e116);
            let _e183 = (_e179 * _e179);
            let _e184 = (_e180 * _e180);
            let _e185 = (_e181 * _e181);
            let _e186 = (_e182 * _e182);
            let _e191 = ((_e154 * _e156) * _e175);
            let _e192 = ((_e156 * _e158) * _e176);
            let _e193 = ((_e158 * _e160) * _e177);
            let _e194 = ((_e160 * _e154) * _e178);
            let _e203 = (((0.5f * _e154) * _e158) * _e183);
            let _e204 = (((0.5f * _e156) * _e160) * _e184);
            let _e205 = (((0.5f * _e158) * _e154) * _e185);
            let _e206 = (((0.5f * _e160) * _e156) * _e186);
            let _e207 = (_e115 * _e116);
            let _e208 = (_e116 * _e117);
            let _e209 = (_e117 * _e118);
            let _e210 = (_e118 * _e115);
            let _e211 = (_e115 * _e117);
            let _e212 = (_e116 * _e118);
            let _e213 = (_e117 * _e115);
            let _e214 = (_e118 * _e116);
            let _e215 = (_e191 * _e207);
            let _e216 = (_e192 * _e208);
            let _e217 = (_e193 * _e209);
            let _e218 = (_e194 * _e210);
            let _e219 = (_e203 * _e211);
            let _e220 = (_e204 * _e212);
            let _e221 = (_e205 * _e213);
            let _e222 = (_e206 * _e214);
            let _e223 = (_e78 * _e78);
            let _e224 = (_e90 * _e90);
            let _e225 = (_e102 * _e102);
            let _e226 = (_e114 * _e114);
            let _e227 = (_e164 * _e164);
            let _e228 = (_e166 * _e166);
            let _e229 = (_e168 * _e168);
            let _e230 = (_e170 * _e170);
            let _e231 = (_e151 * _e154);
            let _e232 = (_e151 * _e156);
            let _e233 = (_e151 * _e158);
            let _e234 = (_e151 * _e160);
            let _e243 = (((_e231 * _e115) * _e223) * _e161);
            let _e244 = (((_e232 * _e116) * _e224) * _e161);
            let _e245 = (((_e233 * _e117) * _e225) * _e161);
            let _e246 = (((_e234 * _e118) * _e226) * _e161);
            let _e255 = (((_e231 * _e115) * _e227) * _e162);
            let _e256 = (((_e232 * _e116) * _e228) * _e162);
            let _e257 = (((_e233 * _e117) * _e229) * _e162);
            let _e258 = (((_e234 * _e118) * _e230) * _e162);
            let _e426 = (((((((_e191 * _e158) * _e176) * _e183) + (_e151 * (((_e191 * ((_e223 * _e224) + (_e227 * _e228))) + (_e203 * ((_e223 * _e225) + (_e227 * _e229)))) + ((_e231 * _e223) * _e227)))) + ((((_e192 * _e160) * _e177) * _e184) + (_e151 * (((_e192 * ((_e224 * _e225) + (_e228 * _e229))) + (_e204 * ((_e224 * _e226) + (_e228 * _e230)))) + ((_e232 * _e224) * _e228))))) + ((((_e193 * _e154) * _e178) * _e185) + (_e151 * (((_e193 * ((_e225 * _e226) + (_e229 * _e230))) + (_e205 * ((_e225 * _e223) + (_e229 * _e227)))) + ((_e233 * _e225) * _e229))))) + ((((_e194 * _e156) * _e175) * _e186) + (_e151 * (((_e194 * ((_e226 * _e223) + (_e230 * _e227))) + (_e206 * ((_e226 * _e224) + (_e230 * _e228)))) + ((_e234 * _e226) * _e230)))));
            let _e429 = (((_e151 * _e151) * _e161) * _e162);
            let _e432 = (((((((_e215 * _e207) + (_e219 * _e211)) + (_e115 * ((_e243 * _e161) + (_e255 * _e162)))) + (((_e216 * _e208) + (_e220 * _e212)) + (_e116 * ((_e244 * _e161) + (_e256 * _e162))))) + (((_e217 * _e209) + (_e221 * _e213)) + (_e117 * ((_e245 * _e161) + (_e257 * _e162))))) + (((_e218 * _e210) + (_e222 * _e214)) + (_e118 * ((_e246 * _e161) + (_e258 * _e162))))) + ((_e429 * _e161) * _e162));
            let _e438 = (_e432 < 0.0000000000000000000000000000000001f);
            if _e438 {
                if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
                    phi_637_ = _e115;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_636_ = 0f;
                    } else {
                        if (_e115 < 0f) {
                            phi_635_ = 0f;
                        } else {
                            phi_635_ = 1f;
                        }
                        let _e447 = phi_635_;
                        phi_636_ = _e447;
                    }
                    let _e449 = phi_636_;
                    phi_637_ = _e449;
                }
                let _e451 = phi_637_;
                if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
                    phi_656_ = _e116;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_655_ = 0f;
                    } else {
                        if (_e116 < 0f) {
                            phi_654_ = 0f;
                        } else {
                            phi_654_ = 1f;
                        }
                        let _e460 = phi_654_;
                        phi_655_ = _e460;
                    }
                    let _e462 = phi_655_;
                    phi_656_ = _e462;
                }
                let _e464 = phi_656_;
                if ((bitcast<u32>(_e117) & 2147483647u) > 2139095040u) {
                    phi_675_ = _e117;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_674_ = 0f;
                    } else {
                        if (_e117 < 0f) {
                            phi_673_ = 0f;
                        } else {
                            phi_673_ = 1f;
                        }
                        let _e473 = phi_673_;
                        phi_674_ = _e473;
                    }
                    let _e475 = phi_674_;
                    phi_675_ = _e475;
                }
                let _e477 = phi_675_;
                if ((bitcast<u32>(_e118) & 2147483647u) > 2139095040u) {
                    phi_694_ = _e118;
                } else {
                    if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                        phi_693_ = 0f;
                    } else {
                        if (_e118 < 0f) {
                            phi_692_ = 0f;
                        } else {
                            phi_692_ = 1f;
                        }
                        let _e486 = phi_692_;
                        phi_693_ = _e486;
                    }
                    let _e488 = phi_693_;
                    phi_694_ = _e488;
                }
                let _e490 = phi_694_;
                let _e498 = (((((_e451 * _e154) + (_e464 * _e156)) + (_e477 * _e158)) + (_e490 * _e160)) + _e151);
                if ((bitcast<u32>(_e498) & 2147483647u) > 2139095040u) {
                    phi_719_ = _e498;
                } else {
                    if (_e498 < 0f) {
                        phi_718_ = 0f;
                    } else {
                        if (_e498 > 1f) {
                            phi_717_ = 1f;
                        } else {
                            phi_717_ = _e498;
                        }
                        let _e505 = phi_717_;
                        phi_718_ = _e505;
                    }
                    let _e507 = phi_718_;
                    phi_719_ = _e507;
                }
                let _e509 = phi_719_;
                phi_832_ = _e509;
                phi_833_ = f32();
            } else {
                let _e511 = ((0.5f * -(((((((((_e215 * (_e115 + _e116)) + (_e219 * (_e115 + _e117))) + (_e243 * (_e115 + _e161))) + (_e255 * (_e115 + _e162))) + ((((_e216 * (_e116 + _e117)) + (_e220 * (_e116 + _e118))) + (_e244 * (_e116 + _e161))) + (_e256 * (_e116 + _e162)))) + ((((_e217 * (_e117 + _e118)) + (_e221 * (_e117 + _e115))) + (_e245 * (_e117 + _e161))) + (_e257 * (_e117 + _e162)))) + ((((_e218 * (_e118 + _e115)) + (_e222 * (_e118 + _e116))) + (_e246 * (_e118 + _e161))) + (_e258 * (_e118 + _e162)))) + (_e429 * (_e161 + _e162))))) / _e432);
                let _e512 = ((((((((_e215 + _e219) + _e243) + _e255) + (((_e216 + _e220) + _e244) + _e256)) + (((_e217 + _e221) + _e245) + _e257)) + (((_e218 + _e222) + _e246) + _e258)) + _e429) / _e432);
                let _e514 = ((_e511 * _e511) - _e512);
                if (_e514 > 0f) {
                    phi_730_ = sqrt(_e514);
                } else {
                    phi_730_ = 0f;
                }
                let _e518 = phi_730_;
                if (_e511 > 0f) {
                    let _e521 = (-(_e511) - _e518);
                    phi_747_ = lt_bvh_slab_Span(_e521, (_e512 / _e521));
                } else {
                    let _e524 = (_e518 - _e511);
                    if (_e524 > 0f) {
                        phi_745_ = (_e512 / _e524);
                    } else {
                        phi_745_ = 0f;
                    }
                    let _e528 = phi_745_;
                    phi_747_ = lt_bvh_slab_Span(_e528, _e524);
                }
                let _e531 = phi_747_;
                if (_e531.near >= 0f) {
                    phi_808_ = 1f;
                    phi_809_ = f32();
                    phi_810_ = true;
                } else {
                    let _e535 = (_e531.far <= 0f);
                    if _e535 {
                        phi_806_ = (_e426 / _e432);
                        phi_807_ = f32();
                    } else {
                        let _e546 = (((((_e154 * _e115) + (_e156 * _e116)) + (_e158 * _e117)) + (_e160 * _e118)) + (_e151 * (_e161 + _e162)));
                        let _e562 = (((((_e154 * (_e115 * _e115)) + (_e156 * (_e116 * _e116))) + (_e158 * (_e117 * _e117))) + (_e160 * (_e118 * _e118))) + (_e151 * ((_e161 * _e161) + (_e162 * _e162))));
                        if (-(_e531.near) <= _e531.far) {
                            phi_805_ = (1f - (((_e531.near * _e531.near) * ((_e531.far * _e562) - _e546)) / (_e531.far - _e531.near)));
                        } else {
                            phi_805_ = ((_e426 / _e432) + (((_e531.far * _e531.far) * (_e546 - (_e531.near * _e562))) / (_e531.far - _e531.near)));
                        }
                        let _e581 = phi_805_;
                        phi_806_ = f32();
                        phi_807_ = _e581;
                    }
                    let _e583 = phi_806_;
                    let _e585 = phi_807_;
                    phi_808_ = _e583;
                    phi_809_ = _e585;
                    phi_810_ = _e535;
                }
                let _e587 = phi_808_;
                let _e589 = phi_809_;
                let _e591 = phi_810_;
                if _e591 {
                    phi_814_ = _e587;
                } else {
                    phi_814_ = _e589;
                }
                let _e593 = phi_814_;
                if ((bitcast<u32>(_e593) & 2147483647u) > 2139095040u) {
                    phi_831_ = _e593;
                } else {
                    if (_e593 < 0f) {
                        phi_830_ = 0f;
                    } else {
                        if (_e593 > 1f) {
                            phi_829_ = 1f;
                        } else {
                            phi_829_ = _e593;
                        }
                        let _e600 = phi_829_;
                        phi_830_ = _e600;
                    }
                    let _e602 = phi_830_;
                    phi_831_ = _e602;
                }
                let _e604 = phi_831_;
                phi_832_ = f32();
                phi_833_ = _e604;
            }
            let _e606 = phi_832_;
            let _e608 = phi_833_;
            phi_834_ = _e606;
            phi_835_ = _e608;
            phi_836_ = _e438;
        }
        let _e610 = phi_834_;
        let _e612 = phi_835_;
        let _e614 = phi_836_;
        phi_837_ = _e610;
        phi_838_ = _e612;
        phi_839_ = _e614;
    }
    let _e616 = phi_837_;
    let _e618 = phi_838_;
    let _e620 = phi_839_;
    if _e620 {
        phi_843_ = _e616;
    } else {
        phi_843_ = _e618;
    }
    let _e622 = phi_843_;
    return _e622;
}

fn function_() {
    var local_1: f32;
    var phi_898_: bool;
    var phi_899_: bool;
    var phi_900_: bool;
    var phi_901_: bool;
    var phi_905_: bool;
    var phi_975_: bool;
    var phi_976_: bool;
    var phi_987_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_988_: bool;
    var phi_989_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_990_: bool;
    var phi_997_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1001_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1021_: lt_math_LightPoint;
    var phi_1024_: u32;
    var phi_1026_: lt_math_LevelPoint;
    var phi_1112_: bool;
    var phi_1121_: bool;
    var phi_1130_: bool;
    var phi_1131_: bool;
    var phi_1132_: bool;
    var phi_1133_: bool;
    var phi_1134_: bool;
    var phi_1135_: bool;
    var phi_1136_: bool;
    var phi_1140_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1170_: bool;
    var phi_1171_: bool;
    var phi_1172_: bool;
    var phi_1173_: bool;
    var phi_1174_: bool;
    var phi_1178_: bool;
    var phi_1187_: lt_math_LightPoint;
    var phi_1188_: u32;
    var phi_1189_: lt_math_LevelPoint;
    var phi_1190_: bool;
    var phi_1022_: lt_math_LightPoint;
    var phi_1025_: u32;
    var phi_1027_: lt_math_LevelPoint;
    var phi_1191_: bool;
    var local_2: lt_math_LevelPoint;
    var local_3: lt_math_LevelPoint;
    var phi_1231_: bool;
    var phi_1232_: bool;
    var phi_1233_: bool;
    var phi_1234_: bool;
    var phi_1238_: bool;
    var phi_1320_: f32;
    var phi_1438_: f32;
    var phi_1439_: f32;
    var phi_1442_: f32;
    var phi_1471_: f32;
    var phi_1476_: f32;
    var phi_1477_: bool;
    var phi_1478_: f32;
    var phi_1479_: bool;
    var phi_1483_: f32;
    var phi_1503_: f32;
    var phi_1508_: f32;
    var phi_1509_: bool;
    var phi_1510_: f32;
    var phi_1511_: bool;
    var phi_1515_: f32;
    var local_4: lt_math_LevelPoint;
    var phi_1564_: i32;
    var phi_1569_: i32;
    var phi_1574_: i32;
    var phi_1579_: i32;
    var phi_1588_: i32;
    var phi_1593_: i32;
    var phi_1598_: i32;
    var phi_1603_: i32;
    var phi_1656_: bool;
    var phi_1664_: bool;
    var phi_1676_: bool;
    var phi_1677_: bool;
    var phi_1681_: f32;
    var phi_1687_: f32;
    var phi_1689_: evaluate_Verdict;
    var phi_1699_: u32;
    var phi_1708_: f32;
    var phi_1710_: evaluate_Verdict;
    var phi_1711_: bool;
    var phi_1712_: evaluate_Verdict;
    var phi_1713_: bool;
    var phi_1718_: evaluate_Verdict;
    var phi_1723_: evaluate_Verdict;
    var phi_1724_: evaluate_Verdict;
    var phi_1728_: bool;
    var phi_1729_: u32;
    var phi_1740_: u32;
    var phi_1757_: u32;

    let _e51 = id_1;
    let _e52 = local_5;
    let _e57 = arrayLength((&map.member));
    let _e62 = arrayLength((&levels.member));
    let _e65 = p.member.size[0u];
    let _e67 = p.member.size[1u];
    let _e68 = lt_shaders_entry_pixel_index(_e51, _e65, _e67);
    if (bitcast<i32>(_e68.root) != 0i) {
        let _e75 = p.member.level_count;
        let _e79 = samples.member[_e68.first_primitive].normal[0u];
        let _e81 = global[0u];
        if (_e79 == _e81) {
            let _e84 = samples.member[_e68.first_primitive].normal[1u];
            let _e86 = global[1u];
            if (_e84 == _e86) {
                let _e89 = samples.member[_e68.first_primitive].normal[2u];
                let _e91 = global[2u];
                phi_898_ = (_e89 == _e91);
                phi_899_ = false;
            } else {
                phi_898_ = bool();
                phi_899_ = true;
            }
            let _e94 = phi_898_;
            let _e96 = phi_899_;
            phi_900_ = _e94;
            phi_901_ = _e96;
        } else {
            phi_900_ = bool();
            phi_901_ = true;
        }
        let _e98 = phi_900_;
        let _e100 = phi_901_;
        if _e100 {
            phi_905_ = false;
        } else {
            phi_905_ = _e98;
        }
        let _e102 = phi_905_;
        if !(_e102) {
            let _e105 = samples.member[_e68.first_primitive].position;
            let _e107 = p.member.light.place;
            let _e113 = p.member.light.place[3u];
            let _e120 = (_e107.x - (_e105.x * _e113));
            let _e121 = (_e107.y - (_e105.y * _e113));
            let _e122 = (_e107.z - (_e105.z * _e113));
            let _e124 = samples.member[_e68.first_primitive].normal;
            if ((((_e124.x * _e120) + (_e124.y * _e121)) + (_e124.z * _e122)) > 0f) {
                let _e138 = (((_e120 * _e120) + (_e121 * _e121)) + (_e122 * _e122));
                let _e140 = p.member.light.axis;
                let _e152 = p.member.light.place[3u];
                if (_e152 == 0f) {
                    phi_976_ = true;
                } else {
                    let _e155 = p.member.light.range_squared;
                    if (_e138 <= _e155) {
                        let _e158 = p.member.light.cos_outer;
                        phi_975_ = (-((((_e120 * _e140.x) + (_e121 * _e140.y)) + (_e122 * _e140.z))) >= (_e158 * sqrt(_e138)));
                    } else {
                        phi_975_ = false;
                    }
                    let _e163 = phi_975_;
                    phi_976_ = _e163;
                }
                let _e165 = phi_976_;
                if _e165 {
                    let _e167 = samples.member[_e68.first_primitive].flags;
                    let _e175 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                    let _e181 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e175.unnamed.visibility, false), _e175.unnamed_1);
                    phi_987_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e181.unnamed, ((_e167 & 1u) == 0u));
                    phi_988_ = false;
                } else {
                    phi_987_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                    phi_988_ = true;
                }
                let _e186 = phi_987_;
                let _e188 = phi_988_;
                phi_989_ = _e186;
                phi_990_ = _e188;
            } else {
                phi_989_ = u0028_evaluate_Verdict_u0020_bool_u0029_();
                phi_990_ = true;
            }
            let _e190 = phi_989_;
            let _e192 = phi_990_;
            if _e192 {
                let _e198 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e204 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e198.unnamed.visibility, false), _e198.unnamed_1);
                phi_997_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e204.unnamed, true);
            } else {
                phi_997_ = _e190;
            }
            let _e209 = phi_997_;
            phi_1001_ = _e209;
        } else {
            let _e215 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e221 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e215.unnamed.visibility, false), _e215.unnamed_1);
            phi_1001_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e221.unnamed, true);
        }
        let _e226 = phi_1001_;
        if _e226.unnamed_1 {
            phi_1724_ = evaluate_Verdict(_e226.unnamed.visibility, _e226.unnamed.is_doubted);
        } else {
            let _e234 = samples.member[_e68.first_primitive].position;
            let _e236 = p.member.map_size;
            let _e238 = (0.5f / f32(_e236));
            let _e245 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e252 = lt_math_LightPoint(vec2<f32>(_e245.uv.x, 0f), _e245.depth, _e245.is_inside);
            let _e256 = lt_math_LightPoint(_e252.uv, 0f, _e252.is_inside);
            phi_1021_ = lt_math_LightPoint();
            phi_1024_ = 0u;
            phi_1026_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e256.uv, _e256.depth, false));
            loop {
                let _e263 = phi_1021_;
                let _e265 = phi_1024_;
                let _e267 = phi_1026_;
                local_2 = _e267;
                local_3 = _e267;
                local_4 = _e267;
                if (_e265 < _e75) {
                    if _e267.point.is_inside {
                        phi_1187_ = lt_math_LightPoint();
                        phi_1188_ = u32();
                        phi_1189_ = lt_math_LevelPoint();
                        phi_1190_ = false;
                    } else {
                        if (_e265 < _e62) {
                        } else {
                            return;
                        }
                        let _e278 = levels.member[(0u + _e265)].row_w;
                        let _e289 = ((((_e278.x * _e234.x) + (_e278.y * _e234.y)) + (_e278.z * _e234.z)) + (_e278.w * 1f));
                        let _e291 = levels.member[(0u + _e265)].row_x;
                        let _e303 = (((((_e291.x * _e234.x) + (_e291.y * _e234.y)) + (_e291.z * _e234.z)) + (_e291.w * 1f)) / _e289);
                        let _e305 = levels.member[(0u + _e265)].row_y;
                        let _e317 = (((((_e305.x * _e234.x) + (_e305.y * _e234.y)) + (_e305.z * _e234.z)) + (_e305.w * 1f)) / _e289);
                        let _e319 = levels.member[(0u + _e265)].row_z;
                        let _e330 = ((((_e319.x * _e234.x) + (_e319.y * _e234.y)) + (_e319.z * _e234.z)) + (_e319.w * 1f));
                        if (_e289 > 0f) {
                            if (_e303 >= 0f) {
                                phi_1112_ = (_e303 <= 1f);
                            } else {
                                phi_1112_ = false;
                            }
                            let _e335 = phi_1112_;
                            if _e335 {
                                if (_e317 >= 0f) {
                                    phi_1121_ = (_e317 <= 1f);
                                } else {
                                    phi_1121_ = false;
                                }
                                let _e339 = phi_1121_;
                                if _e339 {
                                    if (_e330 >= 0f) {
                                        phi_1130_ = (_e330 <= 1f);
                                    } else {
                                        phi_1130_ = false;
                                    }
                                    let _e343 = phi_1130_;
                                    phi_1131_ = _e343;
                                    phi_1132_ = false;
                                } else {
                                    phi_1131_ = bool();
                                    phi_1132_ = true;
                                }
                                let _e345 = phi_1131_;
                                let _e347 = phi_1132_;
                                phi_1133_ = _e345;
                                phi_1134_ = _e347;
                            } else {
                                phi_1133_ = bool();
                                phi_1134_ = true;
                            }
                            let _e349 = phi_1133_;
                            let _e351 = phi_1134_;
                            phi_1135_ = _e349;
                            phi_1136_ = _e351;
                        } else {
                            phi_1135_ = bool();
                            phi_1136_ = true;
                        }
                        let _e353 = phi_1135_;
                        let _e355 = phi_1136_;
                        if _e355 {
                            phi_1140_ = false;
                        } else {
                            phi_1140_ = _e353;
                        }
                        let _e357 = phi_1140_;
                        if _e357 {
                            if (_e303 >= _e238) {
                                if (_e303 <= (1f - _e238)) {
                                    if (_e317 >= _e238) {
                                        phi_1167_ = (_e317 <= (1f - _e238));
                                        phi_1168_ = false;
                                    } else {
                                        phi_1167_ = bool();
                                        phi_1168_ = true;
                                    }
                                    let _e365 = phi_1167_;
                                    let _e367 = phi_1168_;
                                    phi_1169_ = _e365;
                                    phi_1170_ = _e367;
                                } else {
                                    phi_1169_ = bool();
                                    phi_1170_ = true;
                                }
                                let _e369 = phi_1169_;
                                let _e371 = phi_1170_;
                                phi_1171_ = _e369;
                                phi_1172_ = _e371;
                            } else {
                                phi_1171_ = bool();
                                phi_1172_ = true;
                            }
                            let _e373 = phi_1171_;
                            let _e375 = phi_1172_;
                            phi_1173_ = _e373;
                            phi_1174_ = _e375;
                        } else {
                            phi_1173_ = bool();
                            phi_1174_ = true;
                        }
                        let _e377 = phi_1173_;
                        let _e379 = phi_1174_;
                        if _e379 {
                            phi_1178_ = false;
                        } else {
                            phi_1178_ = _e377;
                        }
                        let _e381 = phi_1178_;
                        let _e388 = lt_math_LightPoint(vec2<f32>(_e303, _e263.uv.y), _e263.depth, _e263.is_inside);
                        let _e395 = lt_math_LightPoint(vec2<f32>(_e388.uv.x, _e317), _e388.depth, _e388.is_inside);
                        let _e399 = lt_math_LightPoint(_e395.uv, _e330, _e395.is_inside);
                        let _e403 = lt_math_LightPoint(_e399.uv, _e399.depth, _e381);
                        phi_1187_ = _e403;
                        phi_1188_ = (_e265 + 1u);
                        phi_1189_ = lt_math_LevelPoint(_e265, _e403);
                        phi_1190_ = true;
                    }
                    let _e407 = phi_1187_;
                    let _e409 = phi_1188_;
                    let _e411 = phi_1189_;
                    let _e413 = phi_1190_;
                    phi_1022_ = _e407;
                    phi_1025_ = _e409;
                    phi_1027_ = _e411;
                    phi_1191_ = _e413;
                } else {
                    phi_1022_ = lt_math_LightPoint();
                    phi_1025_ = u32();
                    phi_1027_ = lt_math_LevelPoint();
                    phi_1191_ = false;
                }
                let _e415 = phi_1022_;
                let _e417 = phi_1025_;
                let _e419 = phi_1027_;
                let _e421 = phi_1191_;
                continue;
                continuing {
                    phi_1021_ = _e415;
                    phi_1024_ = _e417;
                    phi_1026_ = _e419;
                    break if !(_e421);
                }
            }
            let _e424 = local_2;
            if _e424.point.is_inside {
                if (0f > 0f) {
                    let _e430 = local_3;
                    if (_e430.level < _e62) {
                    } else {
                        return;
                    }
                    let _e435 = levels.member[(0u + _e430.level)];
                    let _e441 = global[0u];
                    if (_e435.row_w.x == _e441) {
                        let _e444 = global[1u];
                        if (_e435.row_w.y == _e444) {
                            let _e447 = global[2u];
                            phi_1231_ = (_e435.row_w.z == _e447);
                            phi_1232_ = false;
                        } else {
                            phi_1231_ = bool();
                            phi_1232_ = true;
                        }
                        let _e450 = phi_1231_;
                        let _e452 = phi_1232_;
                        phi_1233_ = _e450;
                        phi_1234_ = _e452;
                    } else {
                        phi_1233_ = bool();
                        phi_1234_ = true;
                    }
                    let _e454 = phi_1233_;
                    let _e456 = phi_1234_;
                    if _e456 {
                        phi_1238_ = false;
                    } else {
                        phi_1238_ = _e454;
                    }
                    let _e458 = phi_1238_;
                    if _e458 {
                        let _e460 = samples.member[_e68.first_primitive].normal;
                        let _e462 = p.member.map_size;
                        let _e532 = ((abs(((((_e435.row_x.x * _e460.x) + (_e435.row_x.y * _e460.y)) + (_e435.row_x.z * _e460.z)) / (((_e435.row_x.x * _e435.row_x.x) + (_e435.row_x.y * _e435.row_x.y)) + (_e435.row_x.z * _e435.row_x.z)))) + abs(((((_e435.row_y.x * _e460.x) + (_e435.row_y.y * _e460.y)) + (_e435.row_y.z * _e460.z)) / (((_e435.row_y.x * _e435.row_y.x) + (_e435.row_y.y * _e435.row_y.y)) + (_e435.row_y.z * _e435.row_y.z))))) / (abs(((((_e435.row_z.x * _e460.x) + (_e435.row_z.y * _e460.y)) + (_e435.row_z.z * _e460.z)) / (((_e435.row_z.x * _e435.row_z.x) + (_e435.row_z.y * _e435.row_z.y)) + (_e435.row_z.z * _e435.row_z.z)))) * f32(_e462)));
                        if (_e532 < 0.002f) {
                            phi_1320_ = _e532;
                        } else {
                            phi_1320_ = 0.002f;
                        }
                        let _e535 = phi_1320_;
                        phi_1439_ = _e535;
                    } else {
                        let _e537 = p.member.map_size;
                        let _e543 = samples.member[_e68.first_primitive].position;
                        let _e554 = ((((_e435.row_w.x * _e543.x) + (_e435.row_w.y * _e543.y)) + (_e435.row_w.z * _e543.z)) + _e435.row_w.w);
                        let _e567 = ((_e435.row_x.x - (_e435.row_w.x * _e424.point.uv.x)) / _e554);
                        let _e568 = ((_e435.row_x.y - (_e435.row_w.y * _e424.point.uv.x)) / _e554);
                        let _e569 = ((_e435.row_x.z - (_e435.row_w.z * _e424.point.uv.x)) / _e554);
                        let _e582 = ((_e435.row_y.x - (_e435.row_w.x * _e424.point.uv.y)) / _e554);
                        let _e583 = ((_e435.row_y.y - (_e435.row_w.y * _e424.point.uv.y)) / _e554);
                        let _e584 = ((_e435.row_y.z - (_e435.row_w.z * _e424.point.uv.y)) / _e554);
                        let _e590 = samples.member[_e68.first_primitive].normal;
                        let _e595 = ((_e583 * _e590.z) - (_e590.y * _e584));
                        let _e600 = ((_e584 * _e590.x) - (_e590.z * _e582));
                        let _e605 = ((_e582 * _e590.y) - (_e590.x * _e583));
                        let _e607 = samples.member[_e68.first_primitive].normal;
                        let _e612 = ((_e568 * _e607.z) - (_e607.y * _e569));
                        let _e617 = ((_e569 * _e607.x) - (_e607.z * _e567));
                        let _e622 = ((_e567 * _e607.y) - (_e607.x * _e568));
                        let _e649 = ((abs(((((_e435.row_z.x * _e595) + (_e435.row_z.y * _e600)) + (_e435.row_z.z * _e605)) / (((_e567 * _e595) + (_e568 * _e600)) + (_e569 * _e605)))) + abs(((((_e435.row_z.x * _e612) + (_e435.row_z.y * _e617)) + (_e435.row_z.z * _e622)) / (((_e582 * _e612) + (_e583 * _e617)) + (_e584 * _e622))))) / f32(_e537));
                        let _e651 = (16f / f32(_e537));
                        if (_e649 < _e651) {
                            phi_1438_ = _e649;
                        } else {
                            phi_1438_ = _e651;
                        }
                        let _e654 = phi_1438_;
                        phi_1439_ = _e654;
                    }
                    let _e656 = phi_1439_;
                    phi_1442_ = (_e424.point.depth - (0f * _e656));
                } else {
                    phi_1442_ = _e424.point.depth;
                }
                let _e660 = phi_1442_;
                let _e666 = p.member.map_size;
                let _e667 = f32(_e666);
                let _e670 = ((_e424.point.uv.x * _e667) - 0.5f);
                let _e671 = ((_e424.point.uv.y * _e667) - 0.5f);
                if (_e670 > -8388608f) {
                    let _e683 = f32(select(0i, select(select(i32(_e670), i32(-2147483648), (_e670 < bitcast<f32>(3472883712u))), 2147483647i, (_e670 > bitcast<f32>(1325400063u))), (_e670 == _e670)));
                    if (_e683 > _e670) {
                        phi_1471_ = 1f;
                    } else {
                        phi_1471_ = 0f;
                    }
                    let _e686 = phi_1471_;
                    if (_e670 < 8388608f) {
                        phi_1476_ = (_e683 - _e686);
                        phi_1477_ = false;
                    } else {
                        phi_1476_ = f32();
                        phi_1477_ = true;
                    }
                    let _e689 = phi_1476_;
                    let _e691 = phi_1477_;
                    phi_1478_ = _e689;
                    phi_1479_ = _e691;
                } else {
                    phi_1478_ = f32();
                    phi_1479_ = true;
                }
                let _e693 = phi_1478_;
                let _e695 = phi_1479_;
                if _e695 {
                    phi_1483_ = _e670;
                } else {
                    phi_1483_ = _e693;
                }
                let _e697 = phi_1483_;
                if (_e671 > -8388608f) {
                    let _e709 = f32(select(0i, select(select(i32(_e671), i32(-2147483648), (_e671 < bitcast<f32>(3472883712u))), 2147483647i, (_e671 > bitcast<f32>(1325400063u))), (_e671 == _e671)));
                    if (_e709 > _e671) {
                        phi_1503_ = 1f;
                    } else {
                        phi_1503_ = 0f;
                    }
                    let _e712 = phi_1503_;
                    if (_e671 < 8388608f) {
                        phi_1508_ = (_e709 - _e712);
                        phi_1509_ = false;
                    } else {
                        phi_1508_ = f32();
                        phi_1509_ = true;
                    }
                    let _e715 = phi_1508_;
                    let _e717 = phi_1509_;
                    phi_1510_ = _e715;
                    phi_1511_ = _e717;
                } else {
                    phi_1510_ = f32();
                    phi_1511_ = true;
                }
                let _e719 = phi_1510_;
                let _e721 = phi_1511_;
                if _e721 {
                    phi_1515_ = _e671;
                } else {
                    phi_1515_ = _e719;
                }
                let _e723 = phi_1515_;
                let _e724 = (_e670 - _e697);
                let _e725 = (_e671 - _e723);
                let _e734 = select(0i, select(select(i32(_e697), i32(-2147483648), (_e697 < bitcast<f32>(3472883712u))), 2147483647i, (_e697 > bitcast<f32>(1325400063u))), (_e697 == _e697));
                let _e743 = select(0i, select(select(i32(_e723), i32(-2147483648), (_e723 < bitcast<f32>(3472883712u))), 2147483647i, (_e723 > bitcast<f32>(1325400063u))), (_e723 == _e723));
                let _e754 = p.member.test;
                let _e755 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e754);
                let _e757 = p.member.map_size;
                let _e759 = local_4;
                local_1 = _e755;
                let _e762 = ((_e759.level * _e757) * _e757);
                let _e764 = (bitcast<i32>(_e757) - 1i);
                if (_e734 > 0i) {
                    phi_1564_ = _e734;
                } else {
                    phi_1564_ = 0i;
                }
                let _e767 = phi_1564_;
                if (_e743 > 0i) {
                    phi_1569_ = _e743;
                } else {
                    phi_1569_ = 0i;
                }
                let _e770 = phi_1569_;
                if (_e767 < _e764) {
                    phi_1574_ = _e767;
                } else {
                    phi_1574_ = _e764;
                }
                let _e773 = phi_1574_;
                if (_e770 < _e764) {
                    phi_1579_ = _e770;
                } else {
                    phi_1579_ = _e764;
                }
                let _e776 = phi_1579_;
                let _e777 = bitcast<u32>(_e773);
                let _e779 = (_e734 + 1i);
                let _e780 = (_e743 + 1i);
                if (_e779 > 0i) {
                    phi_1588_ = _e779;
                } else {
                    phi_1588_ = 0i;
                }
                let _e783 = phi_1588_;
                if (_e780 > 0i) {
                    phi_1593_ = _e780;
                } else {
                    phi_1593_ = 0i;
                }
                let _e786 = phi_1593_;
                if (_e783 < _e764) {
                    phi_1598_ = _e783;
                } else {
                    phi_1598_ = _e764;
                }
                let _e789 = phi_1598_;
                if (_e786 < _e764) {
                    phi_1603_ = _e786;
                } else {
                    phi_1603_ = _e764;
                }
                let _e792 = phi_1603_;
                let _e793 = bitcast<u32>(_e789);
                let _e795 = (bitcast<u32>(_e776) * _e757);
                let _e796 = (bitcast<u32>(_e792) * _e757);
                let _e801 = ((_e795 + _e777) + _e762);
                let _e802 = ((_e795 + _e793) + _e762);
                let _e803 = ((_e796 + _e777) + _e762);
                let _e804 = ((_e796 + _e793) + _e762);
                if (_e801 < _e57) {
                } else {
                    return;
                }
                let _e808 = map.member[(0u + _e801)];
                if (_e802 < _e57) {
                } else {
                    return;
                }
                let _e812 = map.member[(0u + _e802)];
                if (_e803 < _e57) {
                } else {
                    return;
                }
                let _e816 = map.member[(0u + _e803)];
                if (_e804 < _e57) {
                } else {
                    return;
                }
                let _e820 = map.member[(0u + _e804)];
                let _e822 = _lt_math_msm_MsmHamburger_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local_1), vec4<f32>(_e808, _e812, _e816, _e820), vec4<f32>(((1f - _e724) * (1f - _e725)), (_e724 * (1f - _e725)), ((1f - _e724) * _e725), (_e724 * _e725)), _e660);
                let _e826 = p.member.epsilon;
                if (_e822 <= _e826) {
                    phi_1656_ = true;
                } else {
                    phi_1656_ = (_e822 >= (1f - _e826));
                }
                let _e831 = phi_1656_;
                if ((bitcast<u32>(_e822) & 2147483647u) > 2139095040u) {
                    phi_1664_ = true;
                } else {
                    phi_1664_ = !(_e831);
                }
                let _e837 = phi_1664_;
                if _e837 {
                    if (_e822 > 0f) {
                        if (_e822 < 1f) {
                            phi_1676_ = false;
                        } else {
                            phi_1676_ = true;
                        }
                        let _e841 = phi_1676_;
                        phi_1677_ = _e841;
                    } else {
                        phi_1677_ = true;
                    }
                    let _e843 = phi_1677_;
                    if _e843 {
                        phi_1681_ = 0.5f;
                    } else {
                        phi_1681_ = _e822;
                    }
                    let _e845 = phi_1681_;
                    phi_1689_ = evaluate_Verdict(_e845, true);
                } else {
                    if (_e822 > 0.5f) {
                        phi_1687_ = 1f;
                    } else {
                        phi_1687_ = 0f;
                    }
                    let _e849 = phi_1687_;
                    phi_1689_ = evaluate_Verdict(_e849, false);
                }
                let _e852 = phi_1689_;
                let _e855 = (_e852.visibility < 0.5f);
                if _e852.is_doubted {
                    phi_1712_ = evaluate_Verdict();
                    phi_1713_ = true;
                } else {
                    if _e855 {
                        phi_1699_ = 2u;
                    } else {
                        phi_1699_ = 1u;
                    }
                    let _e857 = phi_1699_;
                    if ((0u & _e857) != 0u) {
                        if _e855 {
                            phi_1708_ = 0.000000059604645f;
                        } else {
                            phi_1708_ = 0.99999994f;
                        }
                        let _e861 = phi_1708_;
                        phi_1710_ = evaluate_Verdict(_e861, true);
                        phi_1711_ = false;
                    } else {
                        phi_1710_ = evaluate_Verdict();
                        phi_1711_ = true;
                    }
                    let _e864 = phi_1710_;
                    let _e866 = phi_1711_;
                    phi_1712_ = _e864;
                    phi_1713_ = _e866;
                }
                let _e868 = phi_1712_;
                let _e870 = phi_1713_;
                if _e870 {
                    phi_1718_ = evaluate_Verdict(_e852.visibility, _e852.is_doubted);
                } else {
                    phi_1718_ = _e868;
                }
                let _e873 = phi_1718_;
                phi_1723_ = evaluate_Verdict(_e873.visibility, _e873.is_doubted);
            } else {
                phi_1723_ = evaluate_Verdict(0.5f, true);
            }
            let _e879 = phi_1723_;
            phi_1724_ = _e879;
        }
        let _e881 = phi_1724_;
        visibility.member[_e68.first_primitive] = _e881.visibility;
        phi_1728_ = _e881.is_doubted;
        phi_1729_ = _e68.first_primitive;
    } else {
        phi_1728_ = false;
        phi_1729_ = 0u;
    }
    let _e886 = phi_1728_;
    let _e888 = phi_1729_;
    if (_e52 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    if _e886 {
        let _e892 = atomicAdd((&shared_[0u]), 1u);
        phi_1740_ = _e892;
    } else {
        phi_1740_ = 0u;
    }
    let _e894 = phi_1740_;
    workgroupBarrier();
    if (_e52 == 0u) {
        let _e898 = atomicLoad((&shared_[0u]));
        let _e899 = atomicAdd((&list.member[3u]), _e898);
        atomicStore((&shared_[1u]), _e899);
    }
    workgroupBarrier();
    if _e886 {
        if false {
            phi_1757_ = (_e888 | 2147483648u);
        } else {
            phi_1757_ = _e888;
        }
        let _e903 = phi_1757_;
        let _e905 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e905) + _e894)]), _e903);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_5 = local;
    function_();
}
