struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
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

struct lt_bvh_traverse_Tree {
    root: u32,
    first_primitive: u32,
}

struct abi_ShadowParams {
    projection: lt_math_LightProjection,
    light: vec4<f32>,
    test: vec4<f32>,
    size: vec2<u32>,
    map_size: u32,
    epsilon: f32,
    root: u32,
    pad0_: u32,
    pad1_: u32,
    pad2_: u32,
}

struct type_30 {
    member: abi_ShadowParams,
}

struct evaluate_Verdict {
    visibility: f32,
    is_doubted: bool,
}

struct u0028_evaluate_Verdict_u0020_bool_u0029_ {
    unnamed: evaluate_Verdict,
    unnamed_1: bool,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_19;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_30;
@group(0) @binding(2) 
var<storage> map: type_23;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_23;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_138_: lt_bvh_traverse_Tree;
    var phi_139_: bool;
    var phi_140_: lt_bvh_traverse_Tree;
    var phi_141_: bool;
    var phi_146_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_138_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_139_ = false;
        } else {
            phi_138_ = lt_bvh_traverse_Tree();
            phi_139_ = true;
        }
        let _e55 = phi_138_;
        let _e57 = phi_139_;
        phi_140_ = _e55;
        phi_141_ = _e57;
    } else {
        phi_140_ = lt_bvh_traverse_Tree();
        phi_141_ = true;
    }
    let _e59 = phi_140_;
    let _e61 = phi_141_;
    if _e61 {
        phi_146_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_146_ = _e59;
    }
    let _e66 = phi_146_;
    return lt_bvh_traverse_Tree(_e66.root, _e66.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_172_: bool;
    var phi_176_: f32;
    var phi_177_: f32;

    let _e43 = (*param_4);
    if ((bitcast<u32>(_e43) & 2147483647u) > 2139095040u) {
        phi_177_ = _e43;
    } else {
        if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
            phi_172_ = true;
        } else {
            let _e50 = (84f < _e43);
            if _e50 {
            }
            phi_172_ = _e50;
        }
        let _e52 = phi_172_;
        if _e52 {
            phi_176_ = 84f;
        } else {
            phi_176_ = _e43;
        }
        let _e54 = phi_176_;
        phi_177_ = _e54;
    }
    let _e56 = phi_177_;
    return _e56;
}

fn lt_shaders_evaluate_to_light(param_5: vec3<f32>, param_6: vec4<f32>) -> vec3<f32> {
    return vec3<f32>((param_6.x - (param_5.x * param_6.w)), (param_6.y - (param_5.y * param_6.w)), (param_6.z - (param_5.z * param_6.w)));
}

fn lt_shaders_evaluate_quad_indices(param_7: i32, param_8: i32, param_9: u32) -> array<u32, 4> {
    var phi_205_: i32;
    var phi_210_: i32;
    var phi_215_: i32;
    var phi_220_: i32;
    var phi_229_: i32;
    var phi_234_: i32;
    var phi_239_: i32;
    var phi_244_: i32;

    let _e46 = (bitcast<i32>(param_9) - 1i);
    if (param_7 > 0i) {
        phi_205_ = param_7;
    } else {
        phi_205_ = 0i;
    }
    let _e49 = phi_205_;
    if (param_8 > 0i) {
        phi_210_ = param_8;
    } else {
        phi_210_ = 0i;
    }
    let _e52 = phi_210_;
    if (_e49 < _e46) {
        phi_215_ = _e49;
    } else {
        phi_215_ = _e46;
    }
    let _e55 = phi_215_;
    if (_e52 < _e46) {
        phi_220_ = _e52;
    } else {
        phi_220_ = _e46;
    }
    let _e58 = phi_220_;
    let _e59 = bitcast<u32>(_e55);
    let _e61 = (param_7 + 1i);
    let _e62 = (param_8 + 1i);
    if (_e61 > 0i) {
        phi_229_ = _e61;
    } else {
        phi_229_ = 0i;
    }
    let _e65 = phi_229_;
    if (_e62 > 0i) {
        phi_234_ = _e62;
    } else {
        phi_234_ = 0i;
    }
    let _e68 = phi_234_;
    if (_e65 < _e46) {
        phi_239_ = _e65;
    } else {
        phi_239_ = _e46;
    }
    let _e71 = phi_239_;
    if (_e68 < _e46) {
        phi_244_ = _e68;
    } else {
        phi_244_ = _e46;
    }
    let _e74 = phi_244_;
    let _e75 = bitcast<u32>(_e71);
    let _e77 = (bitcast<u32>(_e58) * param_9);
    let _e78 = (bitcast<u32>(_e74) * param_9);
    return array<u32, 4>((_e77 + _e59), (_e77 + _e75), (_e78 + _e59), (_e78 + _e75));
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_10: ptr<function, f32>, param_11: vec4<f32>, param_12: vec4<f32>, param_13: f32) -> f32 {
    var phi_593_: f32;
    var phi_594_: f32;
    var phi_595_: f32;
    var phi_611_: f32;
    var phi_612_: f32;
    var phi_613_: f32;
    var phi_638_: bool;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_660_: bool;
    var phi_664_: f32;
    var phi_665_: f32;
    var phi_706_: f32;
    var phi_722_: f32;
    var phi_723_: f32;
    var phi_724_: f32;
    var phi_749_: bool;
    var phi_753_: f32;
    var phi_754_: f32;
    var phi_771_: bool;
    var phi_775_: f32;
    var phi_776_: f32;
    var phi_817_: f32;
    var phi_833_: f32;
    var phi_834_: f32;
    var phi_835_: f32;
    var phi_860_: bool;
    var phi_864_: f32;
    var phi_865_: f32;
    var phi_882_: bool;
    var phi_886_: f32;
    var phi_887_: f32;
    var phi_928_: f32;
    var phi_944_: f32;
    var phi_945_: f32;
    var phi_946_: f32;
    var phi_971_: bool;
    var phi_975_: f32;
    var phi_976_: f32;
    var phi_993_: bool;
    var phi_997_: f32;
    var phi_998_: f32;
    var phi_1039_: f32;
    var phi_1065_: f32;
    var phi_1066_: f32;
    var phi_1067_: f32;

    let _e46 = _lt_math_esm_Esm_clamped_exponent(param_10);
    if ((bitcast<u32>(param_13) & 2147483647u) > 2139095040u) {
        phi_595_ = param_13;
    } else {
        if (param_13 < 0f) {
            phi_594_ = 0f;
        } else {
            if (param_13 > 1f) {
                phi_593_ = 1f;
            } else {
                phi_593_ = param_13;
            }
            let _e53 = phi_593_;
            phi_594_ = _e53;
        }
        let _e55 = phi_594_;
        phi_595_ = _e55;
    }
    let _e57 = phi_595_;
    if ((bitcast<u32>(param_11.x) & 2147483647u) > 2139095040u) {
        phi_613_ = param_11.x;
    } else {
        if (param_11.x < 0f) {
            phi_612_ = 0f;
        } else {
            if (param_11.x > 1f) {
                phi_611_ = 1f;
            } else {
                phi_611_ = param_11.x;
            }
            let _e65 = phi_611_;
            phi_612_ = _e65;
        }
        let _e67 = phi_612_;
        phi_613_ = _e67;
    }
    let _e69 = phi_613_;
    let _e71 = (_e46 * (_e69 - _e57));
    if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
        phi_706_ = _e71;
    } else {
        if ((bitcast<u32>(_e71) & 2147483647u) > 2139095040u) {
            phi_643_ = _e71;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_638_ = true;
            } else {
                let _e81 = (-87f > _e71);
                if _e81 {
                }
                phi_638_ = _e81;
            }
            let _e83 = phi_638_;
            if _e83 {
                phi_642_ = -87f;
            } else {
                phi_642_ = _e71;
            }
            let _e85 = phi_642_;
            phi_643_ = _e85;
        }
        let _e87 = phi_643_;
        if ((bitcast<u32>(_e87) & 2147483647u) > 2139095040u) {
            phi_665_ = _e87;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_660_ = true;
            } else {
                let _e94 = (88f < _e87);
                if _e94 {
                }
                phi_660_ = _e94;
            }
            let _e96 = phi_660_;
            if _e96 {
                phi_664_ = 88f;
            } else {
                phi_664_ = _e87;
            }
            let _e98 = phi_664_;
            phi_665_ = _e98;
        }
        let _e100 = phi_665_;
        let _e103 = floor(((_e100 * 1.442695f) + 0.5f));
        let _e107 = ((_e100 - (_e103 * 0.69314575f)) - (_e103 * 0.0000014286068f));
        phi_706_ = ((((((((((((((((1f / 5040f) * _e107) + (1f / 720f)) * _e107) + (1f / 120f)) * _e107) + (1f / 24f)) * _e107) + (1f / 6f)) * _e107) + 0.5f) * _e107) + 1f) * _e107) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e103), i32(-2147483648), (_e103 < bitcast<f32>(3472883712u))), 2147483647i, (_e103 > bitcast<f32>(1325400063u))), (_e103 == _e103)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e143 = phi_706_;
    if ((bitcast<u32>(param_11.y) & 2147483647u) > 2139095040u) {
        phi_724_ = param_11.y;
    } else {
        if (param_11.y < 0f) {
            phi_723_ = 0f;
        } else {
            if (param_11.y > 1f) {
                phi_722_ = 1f;
            } else {
                phi_722_ = param_11.y;
            }
            let _e151 = phi_722_;
            phi_723_ = _e151;
        }
        let _e153 = phi_723_;
        phi_724_ = _e153;
    }
    let _e155 = phi_724_;
    let _e157 = (_e46 * (_e155 - _e57));
    if ((bitcast<u32>(_e157) & 2147483647u) > 2139095040u) {
        phi_817_ = _e157;
    } else {
        if ((bitcast<u32>(_e157) & 2147483647u) > 2139095040u) {
            phi_754_ = _e157;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_749_ = true;
            } else {
                let _e167 = (-87f > _e157);
                if _e167 {
                }
                phi_749_ = _e167;
            }
            let _e169 = phi_749_;
            if _e169 {
                phi_753_ = -87f;
            } else {
                phi_753_ = _e157;
            }
            let _e171 = phi_753_;
            phi_754_ = _e171;
        }
        let _e173 = phi_754_;
        if ((bitcast<u32>(_e173) & 2147483647u) > 2139095040u) {
            phi_776_ = _e173;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_771_ = true;
            } else {
                let _e180 = (88f < _e173);
                if _e180 {
                }
                phi_771_ = _e180;
            }
            let _e182 = phi_771_;
            if _e182 {
                phi_775_ = 88f;
            } else {
                phi_775_ = _e173;
            }
            let _e184 = phi_775_;
            phi_776_ = _e184;
        }
        let _e186 = phi_776_;
        let _e189 = floor(((_e186 * 1.442695f) + 0.5f));
        let _e193 = ((_e186 - (_e189 * 0.69314575f)) - (_e189 * 0.0000014286068f));
        phi_817_ = ((((((((((((((((1f / 5040f) * _e193) + (1f / 720f)) * _e193) + (1f / 120f)) * _e193) + (1f / 24f)) * _e193) + (1f / 6f)) * _e193) + 0.5f) * _e193) + 1f) * _e193) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e189), i32(-2147483648), (_e189 < bitcast<f32>(3472883712u))), 2147483647i, (_e189 > bitcast<f32>(1325400063u))), (_e189 == _e189)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e229 = phi_817_;
    if ((bitcast<u32>(param_11.z) & 2147483647u) > 2139095040u) {
        phi_835_ = param_11.z;
    } else {
        if (param_11.z < 0f) {
            phi_834_ = 0f;
        } else {
            if (param_11.z > 1f) {
                phi_833_ = 1f;
            } else {
                phi_833_ = param_11.z;
            }
            let _e237 = phi_833_;
            phi_834_ = _e237;
        }
        let _e239 = phi_834_;
        phi_835_ = _e239;
    }
    let _e241 = phi_835_;
    let _e243 = (_e46 * (_e241 - _e57));
    if ((bitcast<u32>(_e243) & 2147483647u) > 2139095040u) {
        phi_928_ = _e243;
    } else {
        if ((bitcast<u32>(_e243) & 2147483647u) > 2139095040u) {
            phi_865_ = _e243;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_860_ = true;
            } else {
                let _e253 = (-87f > _e243);
                if _e253 {
                }
                phi_860_ = _e253;
            }
            let _e255 = phi_860_;
            if _e255 {
                phi_864_ = -87f;
            } else {
                phi_864_ = _e243;
            }
            let _e257 = phi_864_;
            phi_865_ = _e257;
        }
        let _e259 = phi_865_;
        if ((bitcast<u32>(_e259) & 2147483647u) > 2139095040u) {
            phi_887_ = _e259;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_882_ = true;
            } else {
                let _e266 = (88f < _e259);
                if _e266 {
                }
                phi_882_ = _e266;
            }
            let _e268 = phi_882_;
            if _e268 {
                phi_886_ = 88f;
            } else {
                phi_886_ = _e259;
            }
            let _e270 = phi_886_;
            phi_887_ = _e270;
        }
        let _e272 = phi_887_;
        let _e275 = floor(((_e272 * 1.442695f) + 0.5f));
        let _e279 = ((_e272 - (_e275 * 0.69314575f)) - (_e275 * 0.0000014286068f));
        phi_928_ = ((((((((((((((((1f / 5040f) * _e279) + (1f / 720f)) * _e279) + (1f / 120f)) * _e279) + (1f / 24f)) * _e279) + (1f / 6f)) * _e279) + 0.5f) * _e279) + 1f) * _e279) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e275), i32(-2147483648), (_e275 < bitcast<f32>(3472883712u))), 2147483647i, (_e275 > bitcast<f32>(1325400063u))), (_e275 == _e275)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e315 = phi_928_;
    if ((bitcast<u32>(param_11.w) & 2147483647u) > 2139095040u) {
        phi_946_ = param_11.w;
    } else {
        if (param_11.w < 0f) {
            phi_945_ = 0f;
        } else {
            if (param_11.w > 1f) {
                phi_944_ = 1f;
            } else {
                phi_944_ = param_11.w;
            }
            let _e323 = phi_944_;
            phi_945_ = _e323;
        }
        let _e325 = phi_945_;
        phi_946_ = _e325;
    }
    let _e327 = phi_946_;
    let _e329 = (_e46 * (_e327 - _e57));
    if ((bitcast<u32>(_e329) & 2147483647u) > 2139095040u) {
        phi_1039_ = _e329;
    } else {
        if ((bitcast<u32>(_e329) & 2147483647u) > 2139095040u) {
            phi_976_ = _e329;
        } else {
            if ((bitcast<u32>(-87f) & 2147483647u) > 2139095040u) {
                phi_971_ = true;
            } else {
                let _e339 = (-87f > _e329);
                if _e339 {
                }
                phi_971_ = _e339;
            }
            let _e341 = phi_971_;
            if _e341 {
                phi_975_ = -87f;
            } else {
                phi_975_ = _e329;
            }
            let _e343 = phi_975_;
            phi_976_ = _e343;
        }
        let _e345 = phi_976_;
        if ((bitcast<u32>(_e345) & 2147483647u) > 2139095040u) {
            phi_998_ = _e345;
        } else {
            if ((bitcast<u32>(88f) & 2147483647u) > 2139095040u) {
                phi_993_ = true;
            } else {
                let _e352 = (88f < _e345);
                if _e352 {
                }
                phi_993_ = _e352;
            }
            let _e354 = phi_993_;
            if _e354 {
                phi_997_ = 88f;
            } else {
                phi_997_ = _e345;
            }
            let _e356 = phi_997_;
            phi_998_ = _e356;
        }
        let _e358 = phi_998_;
        let _e361 = floor(((_e358 * 1.442695f) + 0.5f));
        let _e365 = ((_e358 - (_e361 * 0.69314575f)) - (_e361 * 0.0000014286068f));
        phi_1039_ = ((((((((((((((((1f / 5040f) * _e365) + (1f / 720f)) * _e365) + (1f / 120f)) * _e365) + (1f / 24f)) * _e365) + (1f / 6f)) * _e365) + 0.5f) * _e365) + 1f) * _e365) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e361), i32(-2147483648), (_e361 < bitcast<f32>(3472883712u))), 2147483647i, (_e361 > bitcast<f32>(1325400063u))), (_e361 == _e361)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e401 = phi_1039_;
    let _e412 = ((((_e143 * param_12.x) + (_e229 * param_12.y)) + (_e315 * param_12.z)) + (_e401 * param_12.w));
    if ((bitcast<u32>(_e412) & 2147483647u) > 2139095040u) {
        phi_1067_ = _e412;
    } else {
        if (_e412 < 0f) {
            phi_1066_ = 0f;
        } else {
            if (_e412 > 1f) {
                phi_1065_ = 1f;
            } else {
                phi_1065_ = _e412;
            }
            let _e419 = phi_1065_;
            phi_1066_ = _e419;
        }
        let _e421 = phi_1066_;
        phi_1067_ = _e421;
    }
    let _e423 = phi_1067_;
    return _e423;
}

fn function_() {
    var local: f32;
    var phi_307_: bool;
    var phi_308_: bool;
    var phi_309_: bool;
    var phi_310_: bool;
    var phi_314_: bool;
    var phi_349_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_353_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_446_: bool;
    var phi_447_: bool;
    var phi_448_: bool;
    var phi_449_: bool;
    var phi_450_: bool;
    var phi_451_: bool;
    var phi_452_: bool;
    var phi_453_: bool;
    var phi_454_: bool;
    var phi_455_: bool;
    var phi_456_: bool;
    var phi_457_: bool;
    var phi_461_: bool;
    var phi_556_: evaluate_Verdict;
    var phi_557_: evaluate_Verdict;
    var phi_558_: bool;
    var phi_559_: evaluate_Verdict;
    var phi_560_: evaluate_Verdict;
    var phi_561_: bool;
    var phi_565_: evaluate_Verdict;

    let _e43 = id_1;
    let _e50 = arrayLength((&map.member));
    let _e56 = p.member.size[0u];
    let _e58 = p.member.size[1u];
    let _e59 = lt_shaders_entry_pixel_index(_e43, _e56, _e58);
    if (bitcast<i32>(_e59.root) != 0i) {
        if (_e59.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e68 = p.member.light;
        let _e71 = samples.member[(0u + _e59.first_primitive)].normal[0u];
        let _e73 = global[0u];
        if (_e71 == _e73) {
            let _e76 = samples.member[(0u + _e59.first_primitive)].normal[1u];
            let _e78 = global[1u];
            if (_e76 == _e78) {
                let _e81 = samples.member[(0u + _e59.first_primitive)].normal[2u];
                let _e83 = global[2u];
                phi_307_ = (_e81 == _e83);
                phi_308_ = false;
            } else {
                phi_307_ = bool();
                phi_308_ = true;
            }
            let _e86 = phi_307_;
            let _e88 = phi_308_;
            phi_309_ = _e86;
            phi_310_ = _e88;
        } else {
            phi_309_ = bool();
            phi_310_ = true;
        }
        let _e90 = phi_309_;
        let _e92 = phi_310_;
        if _e92 {
            phi_314_ = false;
        } else {
            phi_314_ = _e90;
        }
        let _e94 = phi_314_;
        if !(_e94) {
            let _e97 = samples.member[(0u + _e59.first_primitive)].normal;
            let _e99 = samples.member[(0u + _e59.first_primitive)].position;
            let _e100 = lt_shaders_evaluate_to_light(_e99, _e68);
            if ((((_e97.x * _e100.x) + (_e97.y * _e100.y)) + (_e97.z * _e100.z)) > 0f) {
                let _e114 = samples.member[(0u + _e59.first_primitive)].flags;
                let _e122 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e128 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e122.unnamed.visibility, false), _e122.unnamed_1);
                phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e128.unnamed, ((_e114 & 1u) == 0u));
            } else {
                let _e137 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e143 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e137.unnamed.visibility, false), _e137.unnamed_1);
                phi_349_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e143.unnamed, true);
            }
            let _e148 = phi_349_;
            phi_353_ = _e148;
        } else {
            let _e154 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e154.unnamed.visibility, false), _e154.unnamed_1);
            phi_353_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e160.unnamed, true);
        }
        let _e165 = phi_353_;
        if _e165.unnamed_1 {
            phi_559_ = evaluate_Verdict(_e165.unnamed.visibility, _e165.unnamed.is_doubted);
            phi_560_ = evaluate_Verdict();
            phi_561_ = true;
        } else {
            let _e173 = samples.member[(0u + _e59.first_primitive)].position;
            let _e179 = p.member.projection.row_w;
            let _e190 = ((((_e179.x * _e173.x) + (_e179.y * _e173.y)) + (_e179.z * _e173.z)) + (_e179.w * 1f));
            let _e192 = p.member.projection.row_x;
            let _e204 = (((((_e192.x * _e173.x) + (_e192.y * _e173.y)) + (_e192.z * _e173.z)) + (_e192.w * 1f)) / _e190);
            let _e206 = p.member.projection.row_y;
            let _e218 = (((((_e206.x * _e173.x) + (_e206.y * _e173.y)) + (_e206.z * _e173.z)) + (_e206.w * 1f)) / _e190);
            let _e220 = p.member.projection.row_z;
            let _e231 = ((((_e220.x * _e173.x) + (_e220.y * _e173.y)) + (_e220.z * _e173.z)) + (_e220.w * 1f));
            if (_e190 > 0f) {
                if (_e204 >= 0f) {
                    if (_e204 <= 1f) {
                        if (_e218 >= 0f) {
                            if (_e218 <= 1f) {
                                if (_e231 >= 0f) {
                                    phi_446_ = (_e231 <= 1f);
                                    phi_447_ = false;
                                } else {
                                    phi_446_ = bool();
                                    phi_447_ = true;
                                }
                                let _e240 = phi_446_;
                                let _e242 = phi_447_;
                                phi_448_ = _e240;
                                phi_449_ = _e242;
                            } else {
                                phi_448_ = bool();
                                phi_449_ = true;
                            }
                            let _e244 = phi_448_;
                            let _e246 = phi_449_;
                            phi_450_ = _e244;
                            phi_451_ = _e246;
                        } else {
                            phi_450_ = bool();
                            phi_451_ = true;
                        }
                        let _e248 = phi_450_;
                        let _e250 = phi_451_;
                        phi_452_ = _e248;
                        phi_453_ = _e250;
                    } else {
                        phi_452_ = bool();
                        phi_453_ = true;
                    }
                    let _e252 = phi_452_;
                    let _e254 = phi_453_;
                    phi_454_ = _e252;
                    phi_455_ = _e254;
                } else {
                    phi_454_ = bool();
                    phi_455_ = true;
                }
                let _e256 = phi_454_;
                let _e258 = phi_455_;
                phi_456_ = _e256;
                phi_457_ = _e258;
            } else {
                phi_456_ = bool();
                phi_457_ = true;
            }
            let _e260 = phi_456_;
            let _e262 = phi_457_;
            if _e262 {
                phi_461_ = false;
            } else {
                phi_461_ = _e260;
            }
            let _e264 = phi_461_;
            if _e264 {
                let _e266 = p.member.map_size;
                let _e267 = f32(_e266);
                let _e270 = ((_e204 * _e267) - 0.5f);
                let _e271 = ((_e218 * _e267) - 0.5f);
                let _e272 = floor(_e270);
                let _e273 = floor(_e271);
                let _e274 = (_e270 - _e272);
                let _e275 = (_e271 - _e273);
                let _e304 = p.member.test;
                let _e305 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e304);
                let _e307 = p.member.map_size;
                local = _e305;
                let _e308 = lt_shaders_evaluate_quad_indices(select(0i, select(select(i32(_e272), i32(-2147483648), (_e272 < bitcast<f32>(3472883712u))), 2147483647i, (_e272 > bitcast<f32>(1325400063u))), (_e272 == _e272)), select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < bitcast<f32>(3472883712u))), 2147483647i, (_e273 > bitcast<f32>(1325400063u))), (_e273 == _e273)), _e307);
                if (_e308[0] < _e50) {
                } else {
                    return;
                }
                let _e313 = map.member[(0u + _e308[0])];
                if (_e308[1] < _e50) {
                } else {
                    return;
                }
                let _e318 = map.member[(0u + _e308[1])];
                if (_e308[2] < _e50) {
                } else {
                    return;
                }
                let _e323 = map.member[(0u + _e308[2])];
                if (_e308[3] < _e50) {
                } else {
                    return;
                }
                let _e328 = map.member[(0u + _e308[3])];
                let _e330 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e313, _e318, _e323, _e328), vec4<f32>(((1f - _e274) * (1f - _e275)), (_e274 * (1f - _e275)), ((1f - _e274) * _e275), (_e274 * _e275)), _e231);
                phi_556_ = evaluate_Verdict(_e330, false);
                phi_557_ = evaluate_Verdict();
                phi_558_ = false;
            } else {
                phi_556_ = evaluate_Verdict();
                phi_557_ = evaluate_Verdict(1f, false);
                phi_558_ = true;
            }
            let _e334 = phi_556_;
            let _e336 = phi_557_;
            let _e338 = phi_558_;
            phi_559_ = _e336;
            phi_560_ = _e334;
            phi_561_ = _e338;
        }
        let _e340 = phi_559_;
        let _e342 = phi_560_;
        let _e344 = phi_561_;
        if _e344 {
            phi_565_ = _e340;
        } else {
            phi_565_ = _e342;
        }
        let _e346 = phi_565_;
        if (_e59.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e59.first_primitive)] = _e346.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
