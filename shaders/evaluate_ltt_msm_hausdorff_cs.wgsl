struct lt_math_LightProjection {
    row_x: vec4<f32>,
    row_y: vec4<f32>,
    row_z: vec4<f32>,
    row_w: vec4<f32>,
}

struct type_8 {
    member: array<u32>,
}

struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_22 {
    member: array<abi_Sample>,
}

struct type_26 {
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

struct type_34 {
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

struct lt_bvh_slab_Span {
    near: f32,
    far: f32,
}

struct type_41 {
    member: array<atomic<u32>>,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_22;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_34;
@group(0) @binding(2) 
var<storage> map: type_26;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_26;
var<private> local_1: u32;
@group(0) @binding(4) 
var<storage, read_write> list: type_41;
var<workgroup> shared_: array<atomic<u32>, 2>;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_148_: lt_bvh_traverse_Tree;
    var phi_149_: bool;
    var phi_150_: lt_bvh_traverse_Tree;
    var phi_151_: bool;
    var phi_156_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_148_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_149_ = false;
        } else {
            phi_148_ = lt_bvh_traverse_Tree();
            phi_149_ = true;
        }
        let _e57 = phi_148_;
        let _e59 = phi_149_;
        phi_150_ = _e57;
        phi_151_ = _e59;
    } else {
        phi_150_ = lt_bvh_traverse_Tree();
        phi_151_ = true;
    }
    let _e61 = phi_150_;
    let _e63 = phi_151_;
    if _e63 {
        phi_156_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_156_ = _e61;
    }
    let _e68 = phi_156_;
    return lt_bvh_traverse_Tree(_e68.root, _e68.first_primitive);
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_4: vec4<f32>, param_5: vec4<f32>, param_6: f32) -> f32 {
    var phi_181_: f32;
    var phi_182_: f32;
    var phi_183_: f32;
    var phi_200_: f32;
    var phi_201_: f32;
    var phi_202_: f32;
    var phi_218_: f32;
    var phi_219_: f32;
    var phi_220_: f32;
    var phi_236_: f32;
    var phi_237_: f32;
    var phi_238_: f32;
    var phi_254_: f32;
    var phi_255_: f32;
    var phi_256_: f32;
    var phi_271_: bool;
    var phi_275_: f32;
    var phi_286_: bool;
    var phi_290_: f32;
    var phi_301_: bool;
    var phi_305_: f32;
    var phi_316_: bool;
    var phi_320_: f32;
    var phi_331_: bool;
    var phi_335_: f32;
    var phi_346_: bool;
    var phi_350_: f32;
    var phi_373_: bool;
    var phi_377_: f32;
    var phi_388_: bool;
    var phi_392_: f32;
    var phi_501_: f32;
    var phi_502_: f32;
    var phi_503_: f32;
    var phi_520_: f32;
    var phi_521_: f32;
    var phi_522_: f32;
    var phi_539_: f32;
    var phi_540_: f32;
    var phi_541_: f32;
    var phi_558_: f32;
    var phi_559_: f32;
    var phi_560_: f32;
    var phi_586_: f32;
    var phi_587_: f32;
    var phi_588_: f32;
    var phi_589_: f32;
    var phi_590_: f32;
    var phi_602_: bool;
    var phi_603_: bool;
    var phi_604_: bool;
    var phi_608_: bool;
    var phi_620_: bool;
    var phi_621_: bool;
    var phi_625_: f32;
    var phi_636_: f32;
    var phi_651_: f32;
    var phi_653_: lt_bvh_slab_Span;
    var phi_781_: f32;
    var phi_782_: f32;
    var phi_783_: f32;
    var phi_784_: f32;
    var phi_785_: f32;
    var phi_786_: bool;
    var phi_790_: f32;
    var phi_800_: bool;
    var phi_813_: bool;
    var phi_822_: bool;
    var phi_827_: bool;
    var phi_828_: bool;
    var phi_829_: bool;
    var phi_830_: bool;
    var phi_837_: bool;
    var phi_838_: bool;
    var phi_839_: bool;
    var phi_840_: bool;
    var phi_841_: bool;
    var phi_845_: bool;
    var phi_910_: f32;
    var phi_911_: f32;
    var phi_912_: f32;
    var phi_929_: f32;
    var phi_930_: f32;
    var phi_931_: f32;
    var phi_948_: f32;
    var phi_949_: f32;
    var phi_950_: f32;
    var phi_967_: f32;
    var phi_968_: f32;
    var phi_969_: f32;
    var phi_1059_: f32;
    var phi_1060_: f32;
    var phi_1071_: bool;
    var phi_1075_: f32;
    var phi_1076_: f32;
    var phi_1077_: f32;
    var phi_1078_: bool;
    var phi_1082_: f32;
    var phi_1097_: f32;
    var phi_1098_: f32;
    var phi_1099_: f32;
    var phi_1107_: bool;
    var phi_1108_: bool;
    var phi_1112_: f32;
    var phi_1113_: f32;

    if ((bitcast<u32>(param_6) & 2147483647u) > 2139095040u) {
        phi_183_ = param_6;
    } else {
        if (param_6 < 0f) {
            phi_182_ = 0f;
        } else {
            if (param_6 > 1f) {
                phi_181_ = 1f;
            } else {
                phi_181_ = param_6;
            }
            let _e53 = phi_181_;
            phi_182_ = _e53;
        }
        let _e55 = phi_182_;
        phi_183_ = _e55;
    }
    let _e57 = phi_183_;
    let _e58 = (_e57 - 0.00000047683716f);
    if ((bitcast<u32>(param_4.x) & 2147483647u) > 2139095040u) {
        phi_202_ = param_4.x;
    } else {
        if (param_4.x < 0f) {
            phi_201_ = 0f;
        } else {
            if (param_4.x > 1f) {
                phi_200_ = 1f;
            } else {
                phi_200_ = param_4.x;
            }
            let _e66 = phi_200_;
            phi_201_ = _e66;
        }
        let _e68 = phi_201_;
        phi_202_ = _e68;
    }
    let _e70 = phi_202_;
    if ((bitcast<u32>(param_4.y) & 2147483647u) > 2139095040u) {
        phi_220_ = param_4.y;
    } else {
        if (param_4.y < 0f) {
            phi_219_ = 0f;
        } else {
            if (param_4.y > 1f) {
                phi_218_ = 1f;
            } else {
                phi_218_ = param_4.y;
            }
            let _e78 = phi_218_;
            phi_219_ = _e78;
        }
        let _e80 = phi_219_;
        phi_220_ = _e80;
    }
    let _e82 = phi_220_;
    if ((bitcast<u32>(param_4.z) & 2147483647u) > 2139095040u) {
        phi_238_ = param_4.z;
    } else {
        if (param_4.z < 0f) {
            phi_237_ = 0f;
        } else {
            if (param_4.z > 1f) {
                phi_236_ = 1f;
            } else {
                phi_236_ = param_4.z;
            }
            let _e90 = phi_236_;
            phi_237_ = _e90;
        }
        let _e92 = phi_237_;
        phi_238_ = _e92;
    }
    let _e94 = phi_238_;
    if ((bitcast<u32>(param_4.w) & 2147483647u) > 2139095040u) {
        phi_256_ = param_4.w;
    } else {
        if (param_4.w < 0f) {
            phi_255_ = 0f;
        } else {
            if (param_4.w > 1f) {
                phi_254_ = 1f;
            } else {
                phi_254_ = param_4.w;
            }
            let _e102 = phi_254_;
            phi_255_ = _e102;
        }
        let _e104 = phi_255_;
        phi_256_ = _e104;
    }
    let _e106 = phi_256_;
    let _e107 = (_e70 - _e58);
    let _e108 = (_e82 - _e58);
    let _e109 = (_e94 - _e58);
    let _e110 = (_e106 - _e58);
    if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
        phi_271_ = true;
    } else {
        let _e114 = (_e108 < _e107);
        if _e114 {
        }
        phi_271_ = _e114;
    }
    let _e116 = phi_271_;
    if _e116 {
        phi_275_ = _e108;
    } else {
        phi_275_ = _e107;
    }
    let _e118 = phi_275_;
    if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
        phi_286_ = true;
    } else {
        let _e122 = (_e110 < _e109);
        if _e122 {
        }
        phi_286_ = _e122;
    }
    let _e124 = phi_286_;
    if _e124 {
        phi_290_ = _e110;
    } else {
        phi_290_ = _e109;
    }
    let _e126 = phi_290_;
    if ((bitcast<u32>(_e126) & 2147483647u) > 2139095040u) {
        phi_301_ = true;
    } else {
        let _e130 = (_e126 < _e118);
        if _e130 {
        }
        phi_301_ = _e130;
    }
    let _e132 = phi_301_;
    if _e132 {
        phi_305_ = _e126;
    } else {
        phi_305_ = _e118;
    }
    let _e134 = phi_305_;
    if ((bitcast<u32>(_e108) & 2147483647u) > 2139095040u) {
        phi_316_ = true;
    } else {
        let _e138 = (_e108 > _e107);
        if _e138 {
        }
        phi_316_ = _e138;
    }
    let _e140 = phi_316_;
    if _e140 {
        phi_320_ = _e108;
    } else {
        phi_320_ = _e107;
    }
    let _e142 = phi_320_;
    if ((bitcast<u32>(_e110) & 2147483647u) > 2139095040u) {
        phi_331_ = true;
    } else {
        let _e146 = (_e110 > _e109);
        if _e146 {
        }
        phi_331_ = _e146;
    }
    let _e148 = phi_331_;
    if _e148 {
        phi_335_ = _e110;
    } else {
        phi_335_ = _e109;
    }
    let _e150 = phi_335_;
    if ((bitcast<u32>(_e150) & 2147483647u) > 2139095040u) {
        phi_346_ = true;
    } else {
        let _e154 = (_e150 > _e142);
        if _e154 {
        }
        phi_346_ = _e154;
    }
    let _e156 = phi_346_;
    if _e156 {
        phi_350_ = _e150;
    } else {
        phi_350_ = _e142;
    }
    let _e158 = phi_350_;
    let _e169 = ((((_e107 * param_5.x) + (_e108 * param_5.y)) + (_e109 * param_5.z)) + (_e110 * param_5.w));
    let _e170 = -(_e134);
    if ((bitcast<u32>(_e158) & 2147483647u) > 2139095040u) {
        phi_373_ = true;
    } else {
        let _e174 = (_e158 > _e170);
        if _e174 {
        }
        phi_373_ = _e174;
    }
    let _e176 = phi_373_;
    if _e176 {
        phi_377_ = _e158;
    } else {
        phi_377_ = _e170;
    }
    let _e178 = phi_377_;
    if ((bitcast<u32>(0.0000009536743f) & 2147483647u) > 2139095040u) {
        phi_388_ = true;
    } else {
        let _e182 = (0.0000009536743f > _e178);
        if _e182 {
        }
        phi_388_ = _e182;
    }
    let _e184 = phi_388_;
    if _e184 {
        phi_392_ = 0.0000009536743f;
    } else {
        phi_392_ = _e178;
    }
    let _e186 = phi_392_;
    let _e190 = bitcast<f32>((2130706432u - (bitcast<u32>(_e186) & 2139095040u)));
    let _e191 = (_e107 * _e190);
    let _e192 = (_e108 * _e190);
    let _e193 = (_e109 * _e190);
    let _e194 = (_e110 * _e190);
    let _e195 = (_e191 - _e192);
    let _e196 = (_e192 - _e193);
    let _e197 = (_e193 - _e194);
    let _e198 = (_e194 - _e191);
    let _e199 = (_e195 * _e195);
    let _e200 = (_e196 * _e196);
    let _e201 = (_e197 * _e197);
    let _e202 = (_e198 * _e198);
    let _e205 = ((_e191 - _e193) * (_e191 - _e193));
    let _e208 = ((_e192 - _e194) * (_e192 - _e194));
    let _e210 = (param_5.x * _e191);
    let _e212 = (param_5.y * _e192);
    let _e214 = (param_5.z * _e193);
    let _e216 = (param_5.w * _e194);
    let _e221 = ((_e210 * _e212) * _e199);
    let _e222 = ((_e212 * _e214) * _e200);
    let _e223 = ((_e214 * _e216) * _e201);
    let _e224 = ((_e216 * _e210) * _e202);
    let _e226 = ((_e210 * _e214) * _e205);
    let _e228 = ((_e212 * _e216) * _e208);
    let _e245 = ((((((_e221 * (_e191 * _e192)) + (_e222 * (_e192 * _e193))) + (_e223 * (_e193 * _e194))) + (_e224 * (_e194 * _e191))) + (_e226 * (_e191 * _e193))) + (_e228 * (_e192 * _e194)));
    let _e269 = (_e134 >= 0f);
    let _e272 = ((bitcast<u32>(_e169) & 2147483647u) > 2139095040u);
    if _e272 {
        phi_590_ = _e169;
    } else {
        if _e269 {
            phi_589_ = 1f;
        } else {
            if ((bitcast<u32>(_e191) & 2147483647u) > 2139095040u) {
                phi_503_ = _e191;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_502_ = 0f;
                } else {
                    if (_e191 < 0f) {
                        phi_501_ = 0f;
                    } else {
                        phi_501_ = 1f;
                    }
                    let _e281 = phi_501_;
                    phi_502_ = _e281;
                }
                let _e283 = phi_502_;
                phi_503_ = _e283;
            }
            let _e285 = phi_503_;
            if ((bitcast<u32>(_e192) & 2147483647u) > 2139095040u) {
                phi_522_ = _e192;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_521_ = 0f;
                } else {
                    if (_e192 < 0f) {
                        phi_520_ = 0f;
                    } else {
                        phi_520_ = 1f;
                    }
                    let _e294 = phi_520_;
                    phi_521_ = _e294;
                }
                let _e296 = phi_521_;
                phi_522_ = _e296;
            }
            let _e298 = phi_522_;
            if ((bitcast<u32>(_e193) & 2147483647u) > 2139095040u) {
                phi_541_ = _e193;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_540_ = 0f;
                } else {
                    if (_e193 < 0f) {
                        phi_539_ = 0f;
                    } else {
                        phi_539_ = 1f;
                    }
                    let _e307 = phi_539_;
                    phi_540_ = _e307;
                }
                let _e309 = phi_540_;
                phi_541_ = _e309;
            }
            let _e311 = phi_541_;
            if ((bitcast<u32>(_e194) & 2147483647u) > 2139095040u) {
                phi_560_ = _e194;
            } else {
                if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                    phi_559_ = 0f;
                } else {
                    if (_e194 < 0f) {
                        phi_558_ = 0f;
                    } else {
                        phi_558_ = 1f;
                    }
                    let _e320 = phi_558_;
                    phi_559_ = _e320;
                }
                let _e322 = phi_559_;
                phi_560_ = _e322;
            }
            let _e324 = phi_560_;
            let _e335 = ((((_e285 * param_5.x) + (_e298 * param_5.y)) + (_e311 * param_5.z)) + (_e324 * param_5.w));
            if ((bitcast<u32>(_e335) & 2147483647u) > 2139095040u) {
                phi_588_ = _e335;
            } else {
                if (_e335 < 0f) {
                    phi_587_ = 0f;
                } else {
                    if (_e335 > 1f) {
                        phi_586_ = 1f;
                    } else {
                        phi_586_ = _e335;
                    }
                    let _e342 = phi_586_;
                    phi_587_ = _e342;
                }
                let _e344 = phi_587_;
                phi_588_ = _e344;
            }
            let _e346 = phi_588_;
            phi_589_ = _e346;
        }
        let _e348 = phi_589_;
        phi_590_ = _e348;
    }
    let _e350 = phi_590_;
    let _e352 = (-(_e58) * _e190);
    let _e354 = ((1f - _e58) * _e190);
    if _e272 {
        phi_603_ = bool();
        phi_604_ = true;
    } else {
        if _e269 {
            phi_602_ = bool();
        } else {
            phi_602_ = (_e245 < 0.0000000000000000000000000000000001f);
        }
        let _e357 = phi_602_;
        phi_603_ = _e357;
        phi_604_ = _e269;
    }
    let _e359 = phi_603_;
    let _e361 = phi_604_;
    if _e361 {
        phi_608_ = true;
    } else {
        phi_608_ = _e359;
    }
    let _e363 = phi_608_;
    let _e364 = (_e169 >= 0f);
    if _e363 {
        if _e364 {
            if (_e350 < 0.05f) {
                phi_620_ = false;
            } else {
                phi_620_ = true;
            }
            let _e367 = phi_620_;
            phi_621_ = _e367;
        } else {
            phi_621_ = true;
        }
        let _e369 = phi_621_;
        if _e369 {
            phi_625_ = _e350;
        } else {
            phi_625_ = 0.05f;
        }
        let _e371 = phi_625_;
        phi_1113_ = _e371;
    } else {
        let _e373 = ((0.5f * -(((((((_e221 * (_e191 + _e192)) + (_e222 * (_e192 + _e193))) + (_e223 * (_e193 + _e194))) + (_e224 * (_e194 + _e191))) + (_e226 * (_e191 + _e193))) + (_e228 * (_e192 + _e194))))) / _e245);
        let _e374 = ((((((_e221 + _e222) + _e223) + _e224) + _e226) + _e228) / _e245);
        let _e376 = ((_e373 * _e373) - _e374);
        if (_e376 > 0f) {
            phi_636_ = sqrt(_e376);
        } else {
            phi_636_ = 0f;
        }
        let _e380 = phi_636_;
        if (_e373 > 0f) {
            let _e383 = (-(_e373) - _e380);
            phi_653_ = lt_bvh_slab_Span(_e383, (_e374 / _e383));
        } else {
            let _e386 = (_e380 - _e373);
            if (_e386 > 0f) {
                phi_651_ = (_e374 / _e386);
            } else {
                phi_651_ = 0f;
            }
            let _e390 = phi_651_;
            phi_653_ = lt_bvh_slab_Span(_e390, _e386);
        }
        let _e393 = phi_653_;
        if (_e393.near >= 0f) {
            phi_784_ = 1f;
            phi_785_ = f32();
            phi_786_ = true;
        } else {
            let _e397 = (_e393.far <= 0f);
            if _e397 {
                phi_782_ = (((((((((param_5.x * param_5.y) * param_5.z) * _e199) * _e200) * _e205) + (((((param_5.y * param_5.z) * param_5.w) * _e200) * _e201) * _e208)) + (((((param_5.z * param_5.w) * param_5.x) * _e201) * _e202) * _e205)) + (((((param_5.w * param_5.x) * param_5.y) * _e202) * _e199) * _e208)) / _e245);
                phi_783_ = f32();
            } else {
                let _e444 = ((((param_5.x * _e191) + (param_5.y * _e192)) + (param_5.z * _e193)) + (param_5.w * _e194));
                let _e459 = ((((param_5.x * (_e191 * _e191)) + (param_5.y * (_e192 * _e192))) + (param_5.z * (_e193 * _e193))) + (param_5.w * (_e194 * _e194)));
                if (-(_e393.near) <= _e393.far) {
                    phi_781_ = (1f - (((_e393.near * _e393.near) * ((_e393.far * _e459) - _e444)) / (_e393.far - _e393.near)));
                } else {
                    phi_781_ = ((((((((((param_5.x * param_5.y) * param_5.z) * _e199) * _e200) * _e205) + (((((param_5.y * param_5.z) * param_5.w) * _e200) * _e201) * _e208)) + (((((param_5.z * param_5.w) * param_5.x) * _e201) * _e202) * _e205)) + (((((param_5.w * param_5.x) * param_5.y) * _e202) * _e199) * _e208)) / _e245) + (((_e393.far * _e393.far) * (_e444 - (_e393.near * _e459))) / (_e393.far - _e393.near)));
                }
                let _e513 = phi_781_;
                phi_782_ = f32();
                phi_783_ = _e513;
            }
            let _e515 = phi_782_;
            let _e517 = phi_783_;
            phi_784_ = _e515;
            phi_785_ = _e517;
            phi_786_ = _e397;
        }
        let _e519 = phi_784_;
        let _e521 = phi_785_;
        let _e523 = phi_786_;
        if _e523 {
            phi_790_ = _e519;
        } else {
            phi_790_ = _e521;
        }
        let _e525 = phi_790_;
        if ((_e393.near * _e352) >= (1f - 0.00001f)) {
            phi_800_ = true;
        } else {
            phi_800_ = ((_e393.near * _e354) >= (1f - 0.00001f));
        }
        let _e533 = phi_800_;
        if _e533 {
            if ((_e393.far * _e352) >= (1f - 0.00001f)) {
                phi_813_ = true;
            } else {
                phi_813_ = ((_e393.far * _e354) >= (1f - 0.00001f));
            }
            let _e541 = phi_813_;
            if (-(_e352) < 0.0001f) {
                if _e541 {
                    phi_822_ = false;
                } else {
                    phi_822_ = true;
                }
                let _e545 = phi_822_;
                phi_828_ = bool();
                phi_829_ = _e545;
                phi_830_ = false;
            } else {
                if _e541 {
                    phi_827_ = false;
                } else {
                    phi_827_ = true;
                }
                let _e548 = phi_827_;
                phi_828_ = (_e354 < 0.0001f);
                phi_829_ = false;
                phi_830_ = _e548;
            }
            let _e550 = phi_828_;
            let _e552 = phi_829_;
            let _e554 = phi_830_;
            phi_839_ = _e550;
            phi_840_ = _e552;
            phi_841_ = _e554;
        } else {
            let _e556 = (-(_e352) < 0.0001f);
            if _e556 {
                phi_837_ = bool();
                phi_838_ = false;
            } else {
                phi_837_ = (_e354 < 0.0001f);
                phi_838_ = true;
            }
            let _e559 = phi_837_;
            let _e561 = phi_838_;
            phi_839_ = _e559;
            phi_840_ = _e556;
            phi_841_ = _e561;
        }
        let _e563 = phi_839_;
        let _e565 = phi_840_;
        let _e567 = phi_841_;
        if _e565 {
            phi_845_ = false;
        } else {
            phi_845_ = _e567;
        }
        let _e569 = phi_845_;
        if _e569 {
            if _e563 {
                phi_1076_ = f32();
            } else {
                let _e570 = (_e191 - _e352);
                let _e571 = (_e192 - _e352);
                let _e572 = (_e193 - _e352);
                let _e573 = (_e194 - _e352);
                let _e574 = (_e354 - _e191);
                let _e575 = (_e354 - _e192);
                let _e576 = (_e354 - _e193);
                let _e577 = (_e354 - _e194);
                let _e586 = ((param_5.x * _e570) * _e574);
                let _e587 = ((param_5.y * _e571) * _e575);
                let _e588 = ((param_5.z * _e572) * _e576);
                let _e589 = ((param_5.w * _e573) * _e577);
                let _e607 = ((((_e586 * (_e191 * _e191)) + (_e587 * (_e192 * _e192))) + (_e588 * (_e193 * _e193))) + (_e589 * (_e194 * _e194)));
                if (_e607 < 0.0000000000000000000000000000000001f) {
                    if ((bitcast<u32>(_e191) & 2147483647u) > 2139095040u) {
                        phi_912_ = _e191;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_911_ = 0f;
                        } else {
                            if (_e191 < 0f) {
                                phi_910_ = 0f;
                            } else {
                                phi_910_ = 1f;
                            }
                            let _e617 = phi_910_;
                            phi_911_ = _e617;
                        }
                        let _e619 = phi_911_;
                        phi_912_ = _e619;
                    }
                    let _e621 = phi_912_;
                    if ((bitcast<u32>(_e192) & 2147483647u) > 2139095040u) {
                        phi_931_ = _e192;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_930_ = 0f;
                        } else {
                            if (_e192 < 0f) {
                                phi_929_ = 0f;
                            } else {
                                phi_929_ = 1f;
                            }
                            let _e630 = phi_929_;
                            phi_930_ = _e630;
                        }
                        let _e632 = phi_930_;
                        phi_931_ = _e632;
                    }
                    let _e634 = phi_931_;
                    if ((bitcast<u32>(_e193) & 2147483647u) > 2139095040u) {
                        phi_950_ = _e193;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_949_ = 0f;
                        } else {
                            if (_e193 < 0f) {
                                phi_948_ = 0f;
                            } else {
                                phi_948_ = 1f;
                            }
                            let _e643 = phi_948_;
                            phi_949_ = _e643;
                        }
                        let _e645 = phi_949_;
                        phi_950_ = _e645;
                    }
                    let _e647 = phi_950_;
                    if ((bitcast<u32>(_e194) & 2147483647u) > 2139095040u) {
                        phi_969_ = _e194;
                    } else {
                        if ((bitcast<u32>(0f) & 2147483647u) > 2139095040u) {
                            phi_968_ = 0f;
                        } else {
                            if (_e194 < 0f) {
                                phi_967_ = 0f;
                            } else {
                                phi_967_ = 1f;
                            }
                            let _e656 = phi_967_;
                            phi_968_ = _e656;
                        }
                        let _e658 = phi_968_;
                        phi_969_ = _e658;
                    }
                    let _e660 = phi_969_;
                    phi_1060_ = ((((_e621 * param_5.x) + (_e634 * param_5.y)) + (_e647 * param_5.z)) + (_e660 * param_5.w));
                } else {
                    let _e672 = (((((_e586 * _e191) + (_e587 * _e192)) + (_e588 * _e193)) + (_e589 * _e194)) / _e607);
                    let _e693 = ((param_5.x * _e191) * (vec4<f32>(1f, 1f, 1f, 1f).x - (_e672 * _e191)));
                    let _e694 = ((param_5.y * _e192) * (vec4<f32>(1f, 1f, 1f, 1f).y - (_e672 * _e192)));
                    let _e695 = ((param_5.z * _e193) * (vec4<f32>(1f, 1f, 1f, 1f).z - (_e672 * _e193)));
                    let _e696 = ((param_5.w * _e194) * (vec4<f32>(1f, 1f, 1f, 1f).w - (_e672 * _e194)));
                    if (_e672 > 0f) {
                        phi_1059_ = (1f - (((((_e693 * _e574) + (_e694 * _e575)) + (_e695 * _e576)) + (_e696 * _e577)) / ((_e352 * ((_e352 * _e672) - 1f)) * (_e352 - _e354))));
                    } else {
                        phi_1059_ = (((((((((_e586 * _e587) * _e199) + ((_e587 * _e588) * _e200)) + ((_e588 * _e589) * _e201)) + ((_e589 * _e586) * _e202)) + ((_e586 * _e588) * _e205)) + ((_e587 * _e589) * _e208)) / (_e607 * (-(_e352) * _e354))) + (((((_e693 * _e570) + (_e694 * _e571)) + (_e695 * _e572)) + (_e696 * _e573)) / ((_e354 * (1f - (_e672 * _e354))) * (_e354 - _e352))));
                    }
                    let _e748 = phi_1059_;
                    phi_1060_ = _e748;
                }
                let _e750 = phi_1060_;
                if ((bitcast<u32>(_e525) & 2147483647u) > 2139095040u) {
                    phi_1071_ = true;
                } else {
                    let _e754 = (_e525 < _e750);
                    if _e754 {
                    }
                    phi_1071_ = _e754;
                }
                let _e756 = phi_1071_;
                if _e756 {
                    phi_1075_ = _e525;
                } else {
                    phi_1075_ = _e750;
                }
                let _e758 = phi_1075_;
                phi_1076_ = _e758;
            }
            let _e760 = phi_1076_;
            phi_1077_ = _e760;
            phi_1078_ = _e563;
        } else {
            phi_1077_ = f32();
            phi_1078_ = true;
        }
        let _e762 = phi_1077_;
        let _e764 = phi_1078_;
        if _e764 {
            phi_1082_ = _e525;
        } else {
            phi_1082_ = _e762;
        }
        let _e766 = phi_1082_;
        if ((bitcast<u32>(_e766) & 2147483647u) > 2139095040u) {
            phi_1099_ = _e766;
        } else {
            if (_e766 < 0f) {
                phi_1098_ = 0f;
            } else {
                if (_e766 > 1f) {
                    phi_1097_ = 1f;
                } else {
                    phi_1097_ = _e766;
                }
                let _e773 = phi_1097_;
                phi_1098_ = _e773;
            }
            let _e775 = phi_1098_;
            phi_1099_ = _e775;
        }
        let _e777 = phi_1099_;
        if _e364 {
            if (_e777 < 0.05f) {
                phi_1107_ = false;
            } else {
                phi_1107_ = true;
            }
            let _e780 = phi_1107_;
            phi_1108_ = _e780;
        } else {
            phi_1108_ = true;
        }
        let _e782 = phi_1108_;
        if _e782 {
            phi_1112_ = _e777;
        } else {
            phi_1112_ = 0.05f;
        }
        let _e784 = phi_1112_;
        phi_1113_ = _e784;
    }
    let _e786 = phi_1113_;
    return _e786;
}

fn function_() {
    var phi_1166_: bool;
    var phi_1167_: bool;
    var phi_1168_: bool;
    var phi_1169_: bool;
    var phi_1173_: bool;
    var phi_1217_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1221_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_1298_: bool;
    var phi_1307_: bool;
    var phi_1316_: bool;
    var phi_1317_: bool;
    var phi_1318_: bool;
    var phi_1319_: bool;
    var phi_1320_: bool;
    var phi_1321_: bool;
    var phi_1322_: bool;
    var phi_1326_: bool;
    var phi_1362_: f32;
    var phi_1367_: f32;
    var phi_1368_: bool;
    var phi_1369_: f32;
    var phi_1370_: bool;
    var phi_1374_: f32;
    var phi_1394_: f32;
    var phi_1399_: f32;
    var phi_1400_: bool;
    var phi_1401_: f32;
    var phi_1402_: bool;
    var phi_1406_: f32;
    var phi_1452_: i32;
    var phi_1457_: i32;
    var phi_1462_: i32;
    var phi_1467_: i32;
    var phi_1476_: i32;
    var phi_1481_: i32;
    var phi_1486_: i32;
    var phi_1491_: i32;
    var phi_1538_: bool;
    var phi_1546_: bool;
    var phi_1551_: f32;
    var phi_1554_: evaluate_Verdict;
    var phi_1555_: evaluate_Verdict;
    var phi_1559_: bool;
    var phi_1560_: u32;
    var phi_1566_: u32;

    let _e44 = id_1;
    let _e45 = local_1;
    let _e50 = arrayLength((&map.member));
    if (_e45 == 0u) {
        atomicStore((&shared_[0u]), 0u);
    }
    workgroupBarrier();
    let _e57 = p.member.size[0u];
    let _e59 = p.member.size[1u];
    let _e60 = lt_shaders_entry_pixel_index(_e44, _e57, _e59);
    if (bitcast<i32>(_e60.root) != 0i) {
        let _e67 = p.member.light;
        let _e70 = samples.member[_e60.first_primitive].normal[0u];
        let _e72 = global[0u];
        if (_e70 == _e72) {
            let _e75 = samples.member[_e60.first_primitive].normal[1u];
            let _e77 = global[1u];
            if (_e75 == _e77) {
                let _e80 = samples.member[_e60.first_primitive].normal[2u];
                let _e82 = global[2u];
                phi_1166_ = (_e80 == _e82);
                phi_1167_ = false;
            } else {
                phi_1166_ = bool();
                phi_1167_ = true;
            }
            let _e85 = phi_1166_;
            let _e87 = phi_1167_;
            phi_1168_ = _e85;
            phi_1169_ = _e87;
        } else {
            phi_1168_ = bool();
            phi_1169_ = true;
        }
        let _e89 = phi_1168_;
        let _e91 = phi_1169_;
        if _e91 {
            phi_1173_ = false;
        } else {
            phi_1173_ = _e89;
        }
        let _e93 = phi_1173_;
        if !(_e93) {
            let _e96 = samples.member[_e60.first_primitive].normal;
            let _e98 = samples.member[_e60.first_primitive].position;
            if ((((_e96.x * (_e67.x - (_e98.x * _e67.w))) + (_e96.y * (_e67.y - (_e98.y * _e67.w)))) + (_e96.z * (_e67.z - (_e98.z * _e67.w)))) > 0f) {
                let _e122 = samples.member[_e60.first_primitive].flags;
                let _e130 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e136 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e130.unnamed.visibility, false), _e130.unnamed_1);
                phi_1217_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e136.unnamed, ((_e122 & 1u) == 0u));
            } else {
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_1217_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, true);
            }
            let _e156 = phi_1217_;
            phi_1221_ = _e156;
        } else {
            let _e162 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e168 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e162.unnamed.visibility, false), _e162.unnamed_1);
            phi_1221_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e168.unnamed, true);
        }
        let _e173 = phi_1221_;
        if _e173.unnamed_1 {
            phi_1555_ = evaluate_Verdict(_e173.unnamed.visibility, _e173.unnamed.is_doubted);
        } else {
            let _e181 = samples.member[_e60.first_primitive].position;
            let _e187 = p.member.projection.row_w;
            let _e198 = ((((_e187.x * _e181.x) + (_e187.y * _e181.y)) + (_e187.z * _e181.z)) + (_e187.w * 1f));
            let _e200 = p.member.projection.row_x;
            let _e212 = (((((_e200.x * _e181.x) + (_e200.y * _e181.y)) + (_e200.z * _e181.z)) + (_e200.w * 1f)) / _e198);
            let _e214 = p.member.projection.row_y;
            let _e226 = (((((_e214.x * _e181.x) + (_e214.y * _e181.y)) + (_e214.z * _e181.z)) + (_e214.w * 1f)) / _e198);
            let _e228 = p.member.projection.row_z;
            let _e239 = ((((_e228.x * _e181.x) + (_e228.y * _e181.y)) + (_e228.z * _e181.z)) + (_e228.w * 1f));
            if (_e198 > 0f) {
                if (_e212 >= 0f) {
                    phi_1298_ = (_e212 <= 1f);
                } else {
                    phi_1298_ = false;
                }
                let _e244 = phi_1298_;
                if _e244 {
                    if (_e226 >= 0f) {
                        phi_1307_ = (_e226 <= 1f);
                    } else {
                        phi_1307_ = false;
                    }
                    let _e248 = phi_1307_;
                    if _e248 {
                        if (_e239 >= 0f) {
                            phi_1316_ = (_e239 <= 1f);
                        } else {
                            phi_1316_ = false;
                        }
                        let _e252 = phi_1316_;
                        phi_1317_ = _e252;
                        phi_1318_ = false;
                    } else {
                        phi_1317_ = bool();
                        phi_1318_ = true;
                    }
                    let _e254 = phi_1317_;
                    let _e256 = phi_1318_;
                    phi_1319_ = _e254;
                    phi_1320_ = _e256;
                } else {
                    phi_1319_ = bool();
                    phi_1320_ = true;
                }
                let _e258 = phi_1319_;
                let _e260 = phi_1320_;
                phi_1321_ = _e258;
                phi_1322_ = _e260;
            } else {
                phi_1321_ = bool();
                phi_1322_ = true;
            }
            let _e262 = phi_1321_;
            let _e264 = phi_1322_;
            if _e264 {
                phi_1326_ = false;
            } else {
                phi_1326_ = _e262;
            }
            let _e266 = phi_1326_;
            if _e266 {
                let _e268 = p.member.map_size;
                let _e269 = f32(_e268);
                let _e272 = ((_e212 * _e269) - 0.5f);
                let _e273 = ((_e226 * _e269) - 0.5f);
                if (_e272 > -8388608f) {
                    let _e285 = f32(select(0i, select(select(i32(_e272), i32(-2147483648), (_e272 < bitcast<f32>(3472883712u))), 2147483647i, (_e272 > bitcast<f32>(1325400063u))), (_e272 == _e272)));
                    if (_e285 > _e272) {
                        phi_1362_ = 1f;
                    } else {
                        phi_1362_ = 0f;
                    }
                    let _e288 = phi_1362_;
                    if (_e272 < 8388608f) {
                        phi_1367_ = (_e285 - _e288);
                        phi_1368_ = false;
                    } else {
                        phi_1367_ = f32();
                        phi_1368_ = true;
                    }
                    let _e291 = phi_1367_;
                    let _e293 = phi_1368_;
                    phi_1369_ = _e291;
                    phi_1370_ = _e293;
                } else {
                    phi_1369_ = f32();
                    phi_1370_ = true;
                }
                let _e295 = phi_1369_;
                let _e297 = phi_1370_;
                if _e297 {
                    phi_1374_ = _e272;
                } else {
                    phi_1374_ = _e295;
                }
                let _e299 = phi_1374_;
                if (_e273 > -8388608f) {
                    let _e311 = f32(select(0i, select(select(i32(_e273), i32(-2147483648), (_e273 < bitcast<f32>(3472883712u))), 2147483647i, (_e273 > bitcast<f32>(1325400063u))), (_e273 == _e273)));
                    if (_e311 > _e273) {
                        phi_1394_ = 1f;
                    } else {
                        phi_1394_ = 0f;
                    }
                    let _e314 = phi_1394_;
                    if (_e273 < 8388608f) {
                        phi_1399_ = (_e311 - _e314);
                        phi_1400_ = false;
                    } else {
                        phi_1399_ = f32();
                        phi_1400_ = true;
                    }
                    let _e317 = phi_1399_;
                    let _e319 = phi_1400_;
                    phi_1401_ = _e317;
                    phi_1402_ = _e319;
                } else {
                    phi_1401_ = f32();
                    phi_1402_ = true;
                }
                let _e321 = phi_1401_;
                let _e323 = phi_1402_;
                if _e323 {
                    phi_1406_ = _e273;
                } else {
                    phi_1406_ = _e321;
                }
                let _e325 = phi_1406_;
                let _e326 = (_e272 - _e299);
                let _e327 = (_e273 - _e325);
                let _e336 = select(0i, select(select(i32(_e299), i32(-2147483648), (_e299 < bitcast<f32>(3472883712u))), 2147483647i, (_e299 > bitcast<f32>(1325400063u))), (_e299 == _e299));
                let _e345 = select(0i, select(select(i32(_e325), i32(-2147483648), (_e325 < bitcast<f32>(3472883712u))), 2147483647i, (_e325 > bitcast<f32>(1325400063u))), (_e325 == _e325));
                let _e356 = p.member.test;
                let _e357 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e356);
                let _e359 = p.member.map_size;
                let _e361 = (bitcast<i32>(_e359) - 1i);
                if (_e336 > 0i) {
                    phi_1452_ = _e336;
                } else {
                    phi_1452_ = 0i;
                }
                let _e364 = phi_1452_;
                if (_e345 > 0i) {
                    phi_1457_ = _e345;
                } else {
                    phi_1457_ = 0i;
                }
                let _e367 = phi_1457_;
                if (_e364 < _e361) {
                    phi_1462_ = _e364;
                } else {
                    phi_1462_ = _e361;
                }
                let _e370 = phi_1462_;
                if (_e367 < _e361) {
                    phi_1467_ = _e367;
                } else {
                    phi_1467_ = _e361;
                }
                let _e373 = phi_1467_;
                let _e374 = bitcast<u32>(_e370);
                let _e376 = (_e336 + 1i);
                let _e377 = (_e345 + 1i);
                if (_e376 > 0i) {
                    phi_1476_ = _e376;
                } else {
                    phi_1476_ = 0i;
                }
                let _e380 = phi_1476_;
                if (_e377 > 0i) {
                    phi_1481_ = _e377;
                } else {
                    phi_1481_ = 0i;
                }
                let _e383 = phi_1481_;
                if (_e380 < _e361) {
                    phi_1486_ = _e380;
                } else {
                    phi_1486_ = _e361;
                }
                let _e386 = phi_1486_;
                if (_e383 < _e361) {
                    phi_1491_ = _e383;
                } else {
                    phi_1491_ = _e361;
                }
                let _e389 = phi_1491_;
                let _e390 = bitcast<u32>(_e386);
                let _e392 = (bitcast<u32>(_e373) * _e359);
                let _e393 = (bitcast<u32>(_e389) * _e359);
                let _e394 = (_e392 + _e374);
                let _e395 = (_e392 + _e390);
                let _e396 = (_e393 + _e374);
                let _e397 = (_e393 + _e390);
                if (_e394 < _e50) {
                } else {
                    return;
                }
                let _e401 = map.member[(0u + _e394)];
                if (_e395 < _e50) {
                } else {
                    return;
                }
                let _e405 = map.member[(0u + _e395)];
                if (_e396 < _e50) {
                } else {
                    return;
                }
                let _e409 = map.member[(0u + _e396)];
                if (_e397 < _e50) {
                } else {
                    return;
                }
                let _e413 = map.member[(0u + _e397)];
                let _e415 = _lt_math_msm_MsmHausdorff_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(vec4<f32>(_e401, _e405, _e409, _e413), vec4<f32>(((1f - _e326) * (1f - _e327)), (_e326 * (1f - _e327)), ((1f - _e326) * _e327), (_e326 * _e327)), _e239);
                let _e417 = p.member.epsilon;
                if (_e415 <= _e417) {
                    phi_1538_ = true;
                } else {
                    phi_1538_ = (_e415 >= (1f - _e417));
                }
                let _e422 = phi_1538_;
                if ((bitcast<u32>(_e415) & 2147483647u) > 2139095040u) {
                    phi_1546_ = true;
                } else {
                    phi_1546_ = !(_e422);
                }
                let _e428 = phi_1546_;
                if (_e415 > 0.5f) {
                    phi_1551_ = 1f;
                } else {
                    phi_1551_ = 0f;
                }
                let _e431 = phi_1551_;
                phi_1554_ = evaluate_Verdict(_e431, _e428);
            } else {
                phi_1554_ = evaluate_Verdict(1f, true);
            }
            let _e435 = phi_1554_;
            phi_1555_ = _e435;
        }
        let _e437 = phi_1555_;
        visibility.member[_e60.first_primitive] = _e437.visibility;
        phi_1559_ = _e437.is_doubted;
        phi_1560_ = _e60.first_primitive;
    } else {
        phi_1559_ = false;
        phi_1560_ = 0u;
    }
    let _e442 = phi_1559_;
    let _e444 = phi_1560_;
    if _e442 {
        let _e446 = atomicAdd((&shared_[0u]), 1u);
        phi_1566_ = _e446;
    } else {
        phi_1566_ = 0u;
    }
    let _e448 = phi_1566_;
    workgroupBarrier();
    if (_e45 == 0u) {
        let _e452 = atomicLoad((&shared_[0u]));
        let _e453 = atomicAdd((&list.member[3u]), _e452);
        atomicStore((&shared_[1u]), _e453);
    }
    workgroupBarrier();
    if _e442 {
        let _e456 = atomicLoad((&shared_[1u]));
        atomicStore((&list.member[((4u + _e456) + _e448)]), _e444);
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_ltt_msm_hausdorff_cs(@builtin(global_invocation_id) id: vec3<u32>, @builtin(local_invocation_index) local: u32) {
    id_1 = id;
    local_1 = local;
    function_();
}
