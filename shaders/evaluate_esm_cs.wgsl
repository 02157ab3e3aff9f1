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

struct type_17 {
    member: array<abi_Sample>,
}

struct type_21 {
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

struct type_29 {
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
var<storage> samples: type_17;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_21;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_21;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_135_: lt_bvh_traverse_Tree;
    var phi_136_: bool;
    var phi_137_: lt_bvh_traverse_Tree;
    var phi_138_: bool;
    var phi_143_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_135_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_136_ = false;
        } else {
            phi_135_ = lt_bvh_traverse_Tree();
            phi_136_ = true;
        }
        let _e58 = phi_135_;
        let _e60 = phi_136_;
        phi_137_ = _e58;
        phi_138_ = _e60;
    } else {
        phi_137_ = lt_bvh_traverse_Tree();
        phi_138_ = true;
    }
    let _e62 = phi_137_;
    let _e64 = phi_138_;
    if _e64 {
        phi_143_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_143_ = _e62;
    }
    let _e69 = phi_143_;
    return lt_bvh_traverse_Tree(_e69.root, _e69.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_163_: bool;
    var phi_167_: f32;

    let _e46 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_163_ = true;
    } else {
        let _e50 = (84f < _e46);
        if _e50 {
        }
        phi_163_ = _e50;
    }
    let _e52 = phi_163_;
    if _e52 {
        phi_167_ = 84f;
    } else {
        phi_167_ = _e46;
    }
    let _e54 = phi_167_;
    return _e54;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_624_: f32;
    var phi_625_: f32;
    var phi_626_: f32;
    var phi_642_: f32;
    var phi_643_: f32;
    var phi_644_: f32;
    var phi_660_: f32;
    var phi_661_: f32;
    var phi_662_: f32;
    var phi_678_: f32;
    var phi_679_: f32;
    var phi_680_: f32;
    var phi_696_: f32;
    var phi_697_: f32;
    var phi_698_: f32;
    var phi_717_: f32;
    var phi_722_: f32;
    var phi_744_: f32;
    var phi_749_: f32;
    var phi_750_: bool;
    var phi_751_: f32;
    var phi_752_: bool;
    var phi_756_: f32;
    var phi_794_: f32;
    var phi_805_: f32;
    var phi_810_: f32;
    var phi_832_: f32;
    var phi_837_: f32;
    var phi_838_: bool;
    var phi_839_: f32;
    var phi_840_: bool;
    var phi_844_: f32;
    var phi_882_: f32;
    var phi_893_: f32;
    var phi_898_: f32;
    var phi_920_: f32;
    var phi_925_: f32;
    var phi_926_: bool;
    var phi_927_: f32;
    var phi_928_: bool;
    var phi_932_: f32;
    var phi_970_: f32;
    var phi_981_: f32;
    var phi_986_: f32;
    var phi_1008_: f32;
    var phi_1013_: f32;
    var phi_1014_: bool;
    var phi_1015_: f32;
    var phi_1016_: bool;
    var phi_1020_: f32;
    var phi_1058_: f32;
    var phi_1084_: f32;
    var phi_1085_: f32;
    var phi_1086_: f32;

    let _e49 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_626_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_625_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_624_ = 1f;
            } else {
                phi_624_ = param_8;
            }
            let _e56 = phi_624_;
            phi_625_ = _e56;
        }
        let _e58 = phi_625_;
        phi_626_ = _e58;
    }
    let _e60 = phi_626_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_644_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_643_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_642_ = 1f;
            } else {
                phi_642_ = param_6.x;
            }
            let _e68 = phi_642_;
            phi_643_ = _e68;
        }
        let _e70 = phi_643_;
        phi_644_ = _e70;
    }
    let _e72 = phi_644_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_662_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_661_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_660_ = 1f;
            } else {
                phi_660_ = param_6.y;
            }
            let _e80 = phi_660_;
            phi_661_ = _e80;
        }
        let _e82 = phi_661_;
        phi_662_ = _e82;
    }
    let _e84 = phi_662_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_680_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_679_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_678_ = 1f;
            } else {
                phi_678_ = param_6.z;
            }
            let _e92 = phi_678_;
            phi_679_ = _e92;
        }
        let _e94 = phi_679_;
        phi_680_ = _e94;
    }
    let _e96 = phi_680_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_698_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_697_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_696_ = 1f;
            } else {
                phi_696_ = param_6.w;
            }
            let _e104 = phi_696_;
            phi_697_ = _e104;
        }
        let _e106 = phi_697_;
        phi_698_ = _e106;
    }
    let _e108 = phi_698_;
    let _e113 = (_e49 * (_e72 - _e60));
    let _e114 = (_e49 * (_e84 - _e60));
    let _e115 = (_e49 * (_e96 - _e60));
    let _e116 = (_e49 * (_e108 - _e60));
    if ((bitcast<u32>(_e113) & 2147483647u) > 2139095040u) {
        phi_794_ = _e113;
    } else {
        if (_e113 < -87f) {
            phi_717_ = -87f;
        } else {
            phi_717_ = _e113;
        }
        let _e122 = phi_717_;
        if (_e122 > 88f) {
            phi_722_ = 88f;
        } else {
            phi_722_ = _e122;
        }
        let _e125 = phi_722_;
        let _e127 = ((_e125 * 1.442695f) + 0.5f);
        if (_e127 > -8388608f) {
            let _e139 = f32(select(0i, select(select(i32(_e127), i32(-2147483648), (_e127 < bitcast<f32>(3472883712u))), 2147483647i, (_e127 > bitcast<f32>(1325400063u))), (_e127 == _e127)));
            if (_e139 > _e127) {
                phi_744_ = 1f;
            } else {
                phi_744_ = 0f;
            }
            let _e142 = phi_744_;
            if (_e127 < 8388608f) {
                phi_749_ = (_e139 - _e142);
                phi_750_ = false;
            } else {
                phi_749_ = f32();
                phi_750_ = true;
            }
            let _e145 = phi_749_;
            let _e147 = phi_750_;
            phi_751_ = _e145;
            phi_752_ = _e147;
        } else {
            phi_751_ = f32();
            phi_752_ = true;
        }
        let _e149 = phi_751_;
        let _e151 = phi_752_;
        if _e151 {
            phi_756_ = _e127;
        } else {
            phi_756_ = _e149;
        }
        let _e153 = phi_756_;
        let _e157 = ((_e125 - (_e153 * 0.69314575f)) - (_e153 * 0.0000014286068f));
        phi_794_ = ((((((((((((((((1f / 5040f) * _e157) + (1f / 720f)) * _e157) + (1f / 120f)) * _e157) + (1f / 24f)) * _e157) + (1f / 6f)) * _e157) + 0.5f) * _e157) + 1f) * _e157) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e153), i32(-2147483648), (_e153 < bitcast<f32>(3472883712u))), 2147483647i, (_e153 > bitcast<f32>(1325400063u))), (_e153 == _e153)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e193 = phi_794_;
    if ((bitcast<u32>(_e114) & 2147483647u) > 2139095040u) {
        phi_882_ = _e114;
    } else {
        if (_e114 < -87f) {
            phi_805_ = -87f;
        } else {
            phi_805_ = _e114;
        }
        let _e199 = phi_805_;
        if (_e199 > 88f) {
            phi_810_ = 88f;
        } else {
            phi_810_ = _e199;
        }
        let _e202 = phi_810_;
        let _e204 = ((_e202 * 1.442695f) + 0.5f);
        if (_e204 > -8388608f) {
            let _e216 = f32(select(0i, select(select(i32(_e204), i32(-2147483648), (_e204 < bitcast<f32>(3472883712u))), 2147483647i, (_e204 > bitcast<f32>(1325400063u))), (_e204 == _e204)));
            if (_e216 > _e204) {
                phi_832_ = 1f;
            } else {
                phi_832_ = 0f;
            }
            let _e219 = phi_832_;
            if (_e204 < 8388608f) {
                phi_837_ = (_e216 - _e219);
                phi_838_ = false;
            } else {
                phi_837_ = f32();
                phi_838_ = true;
            }
            let _e222 = phi_837_;
            let _e224 = phi_838_;
            phi_839_ = _e222;
            phi_840_ = _e224;
        } else {
            phi_839_ = f32();
            phi_840_ = true;
        }
        let _e226 = phi_839_;
        let _e228 = phi_840_;
        if _e228 {
            phi_844_ = _e204;
        } else {
            phi_844_ = _e226;
        }
        let _e230 = phi_844_;
        let _e234 = ((_e202 - (_e230 * 0.69314575f)) - (_e230 * 0.0000014286068f));
        phi_882_ = ((((((((((((((((1f / 5040f) * _e234) + (1f / 720f)) * _e234) + (1f / 120f)) * _e234) + (1f / 24f)) * _e234) + (1f / 6f)) * _e234) + 0.5f) * _e234) + 1f) * _e234) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e230), i32(-2147483648), (_e230 < bitcast<f32>(3472883712u))), 2147483647i, (_e230 > bitcast<f32>(1325400063u))), (_e230 == _e230)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e270 = phi_882_;
    if ((bitcast<u32>(_e115) & 2147483647u) > 2139095040u) {
        phi_970_ = _e115;
    } else {
        if (_e115 < -87f) {
            phi_893_ = -87f;
        } else {
            phi_893_ = _e115;
        }
        let _e276 = phi_893_;
        if (_e276 > 88f) {
            phi_898_ = 88f;
        } else {
            phi_898_ = _e276;
        }
        let _e279 = phi_898_;
        let _e281 = ((_e279 * 1.442695f) + 0.5f);
        if (_e281 > -8388608f) {
            let _e293 = f32(select(0i, select(select(i32(_e281), i32(-2147483648), (_e281 < bitcast<f32>(3472883712u))), 2147483647i, (_e281 > bitcast<f32>(1325400063u))), (_e281 == _e281)));
            if (_e293 > _e281) {
                phi_920_ = 1f;
            } else {
                phi_920_ = 0f;
            }
            let _e296 = phi_920_;
            if (_e281 < 8388608f) {
                phi_925_ = (_e293 - _e296);
                phi_926_ = false;
            } else {
                phi_925_ = f32();
                phi_926_ = true;
            }
            let _e299 = phi_925_;
            let _e301 = phi_926_;
            phi_927_ = _e299;
            phi_928_ = _e301;
        } else {
            phi_927_ = f32();
            phi_928_ = true;
        }
        let _e303 = phi_927_;
        let _e305 = phi_928_;
        if _e305 {
            phi_932_ = _e281;
        } else {
            phi_932_ = _e303;
        }
        let _e307 = phi_932_;
        let _e311 = ((_e279 - (_e307 * 0.69314575f)) - (_e307 * 0.0000014286068f));
        phi_970_ = ((((((((((((((((1f / 5040f) * _e311) + (1f / 720f)) * _e311) + (1f / 120f)) * _e311) + (1f / 24f)) * _e311) + (1f / 6f)) * _e311) + 0.5f) * _e311) + 1f) * _e311) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e307), i32(-2147483648), (_e307 < bitcast<f32>(3472883712u))), 2147483647i, (_e307 > bitcast<f32>(1325400063u))), (_e307 == _e307)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e347 = phi_970_;
    if ((bitcast<u32>(_e116) & 2147483647u) > 2139095040u) {
        phi_1058_ = _e116;
    } else {
        if (_e116 < -87f) {
            phi_981_ = -87f;
        } else {
            phi_981_ = _e116;
        }
        let _e353 = phi_981_;
        if (_e353 > 88f) {
            phi_986_ = 88f;
        } else {
            phi_986_ = _e353;
        }
        let _e356 = phi_986_;
        let _e358 = ((_e356 * 1.442695f) + 0.5f);
        if (_e358 > -8388608f) {
            let _e370 = f32(select(0i, select(select(i32(_e358), i32(-2147483648), (_e358 < bitcast<f32>(3472883712u))), 2147483647i, (_e358 > bitcast<f32>(1325400063u))), (_e358 == _e358)));
            if (_e370 > _e358) {
                phi_1008_ = 1f;
            } else {
                phi_1008_ = 0f;
            }
            let _e373 = phi_1008_;
            if (_e358 < 8388608f) {
                phi_1013_ = (_e370 - _e373);
                phi_1014_ = false;
            } else {
                phi_1013_ = f32();
                phi_1014_ = true;
            }
            let _e376 = phi_1013_;
            let _e378 = phi_1014_;
            phi_1015_ = _e376;
            phi_1016_ = _e378;
        } else {
            phi_1015_ = f32();
            phi_1016_ = true;
        }
        let _e380 = phi_1015_;
        let _e382 = phi_1016_;
        if _e382 {
            phi_1020_ = _e358;
        } else {
            phi_1020_ = _e380;
        }
        let _e384 = phi_1020_;
        let _e388 = ((_e356 - (_e384 * 0.69314575f)) - (_e384 * 0.0000014286068f));
        phi_1058_ = ((((((((((((((((1f / 5040f) * _e388) + (1f / 720f)) * _e388) + (1f / 120f)) * _e388) + (1f / 24f)) * _e388) + (1f / 6f)) * _e388) + 0.5f) * _e388) + 1f) * _e388) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e384), i32(-2147483648), (_e384 < bitcast<f32>(3472883712u))), 2147483647i, (_e384 > bitcast<f32>(1325400063u))), (_e384 == _e384)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e424 = phi_1058_;
    let _e435 = ((((_e193 * param_7.x) + (_e270 * param_7.y)) + (_e347 * param_7.z)) + (_e424 * param_7.w));
    if ((bitcast<u32>(_e435) & 2147483647u) > 2139095040u) {
        phi_1086_ = _e435;
    } else {
        if (_e435 < 0f) {
            phi_1085_ = 0f;
        } else {
            if (_e435 > 1f) {
                phi_1084_ = 1f;
            } else {
                phi_1084_ = _e435;
            }
            let _e442 = phi_1084_;
            phi_1085_ = _e442;
        }
        let _e444 = phi_1085_;
        phi_1086_ = _e444;
    }
    let _e446 = phi_1086_;
    return _e446;
}

fn function_() {
    var local: f32;
    var phi_221_: bool;
    var phi_222_: bool;
    var phi_223_: bool;
    var phi_224_: bool;
    var phi_228_: bool;
    var phi_272_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_276_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_353_: bool;
    var phi_362_: bool;
    var phi_371_: bool;
    var phi_372_: bool;
    var phi_373_: bool;
    var phi_374_: bool;
    var phi_375_: bool;
    var phi_376_: bool;
    var phi_377_: bool;
    var phi_381_: bool;
    var phi_417_: f32;
    var phi_422_: f32;
    var phi_423_: bool;
    var phi_424_: f32;
    var phi_425_: bool;
    var phi_429_: f32;
    var phi_449_: f32;
    var phi_454_: f32;
    var phi_455_: bool;
    var phi_456_: f32;
    var phi_457_: bool;
    var phi_461_: f32;
    var phi_507_: i32;
    var phi_512_: i32;
    var phi_517_: i32;
    var phi_522_: i32;
    var phi_531_: i32;
    var phi_536_: i32;
    var phi_541_: i32;
    var phi_546_: i32;
    var phi_587_: evaluate_Verdict;
    var phi_588_: evaluate_Verdict;
    var phi_589_: bool;
    var phi_590_: evaluate_Verdict;
    var phi_591_: evaluate_Verdict;
    var phi_592_: bool;
    var phi_596_: evaluate_Verdict;

    let _e46 = id_1;
    let _e53 = arrayLength((&map.member));
    let _e59 = p.member.size[0u];
    let _e61 = p.member.size[1u];
    let _e62 = lt_shaders_entry_pixel_index(_e46, _e59, _e61);
    if (bitcast<i32>(_e62.root) != 0i) {
        if (_e62.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e71 = p.member.light;
        let _e74 = samples.member[(0u + _e62.first_primitive)].normal[0u];
        let _e76 = global[0u];
        if (_e74 == _e76) {
            let _e79 = samples.member[(0u + _e62.first_primitive)].normal[1u];
            let _e81 = global[1u];
            if (_e79 == _e81) {
                let _e84 = samples.member[(0u + _e62.first_primitive)].normal[2u];
                let _e86 = global[2u];
                phi_221_ = (_e84 == _e86);
                phi_222_ = false;
            } else {
                phi_221_ = bool();
                phi_222_ = true;
            }
            let _e89 = phi_221_;
            let _e91 = phi_222_;
            phi_223_ = _e89;
            phi_224_ = _e91;
        } else {
            phi_223_ = bool();
            phi_224_ = true;
        }
        let _e93 = phi_223_;
        let _e95 = phi_224_;
        if _e95 {
            phi_228_ = false;
        } else {
            phi_228_ = _e93;
        }
        let _e97 = phi_228_;
        if !(_e97) {
            let _e100 = samples.member[(0u + _e62.first_primitive)].normal;
            let _e102 = samples.member[(0u + _e62.first_primitive)].position;
            if ((((_e100.x * (_e71.x - (_e102.x * _e71.w))) + (_e100.y * (_e71.y - (_e102.y * _e71.w)))) + (_e100.z * (_e71.z - (_e102.z * _e71.w)))) > 0f) {
                let _e126 = samples.member[(0u + _e62.first_primitive)].flags;
                let _e134 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e140 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e134.unnamed.visibility, false), _e134.unnamed_1);
                phi_272_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e140.unnamed, ((_e126 & 1u) == 0u));
            } else {
                let _e149 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e155 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e149.unnamed.visibility, false), _e149.unnamed_1);
                phi_272_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e155.unnamed, true);
            }
            let _e160 = phi_272_;
            phi_276_ = _e160;
        } else {
            let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e172 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e166.unnamed.visibility, false), _e166.unnamed_1);
            phi_276_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e172.unnamed, true);
        }
        let _e177 = phi_276_;
        if _e177.unnamed_1 {
            phi_590_ = evaluate_Verdict(_e177.unnamed.visibility, _e177.unnamed.is_doubted);
            phi_591_ = evaluate_Verdict();
            phi_592_ = true;
        } else {
            let _e185 = samples.member[(0u + _e62.first_primitive)].position;
            let _e191 = p.member.projection.row_w;
            let _e202 = ((((_e191.x * _e185.x) + (_e191.y * _e185.y)) + (_e191.z * _e185.z)) + (_e191.w * 1f));
            let _e204 = p.member.projection.row_x;
            let _e216 = (((((_e204.x * _e185.x) + (_e204.y * _e185.y)) + (_e204.z * _e185.z)) + (_e204.w * 1f)) / _e202);
            let _e218 = p.member.projection.row_y;
            let _e230 = (((((_e218.x * _e185.x) + (_e218.y * _e185.y)) + (_e218.z * _e185.z)) + (_e218.w * 1f)) / _e202);
            let _e232 = p.member.projection.row_z;
            let _e243 = ((((_e232.x * _e185.x) + (_e232.y * _e185.y)) + (_e232.z * _e185.z)) + (_e232.w * 1f));
            if (_e202 > 0f) {
                if (_e216 >= 0f) {
                    phi_353_ = (_e216 <= 1f);
                } else {
                    phi_353_ = false;
                }
                let _e248 = phi_353_;
                if _e248 {
                    if (_e230 >= 0f) {
                        phi_362_ = (_e230 <= 1f);
                    } else {
                        phi_362_ = false;
                    }
                    let _e252 = phi_362_;
                    if _e252 {
                        if (_e243 >= 0f) {
                            phi_371_ = (_e243 <= 1f);
                        } else {
                            phi_371_ = false;
                        }
                        let _e256 = phi_371_;
                        phi_372_ = _e256;
                        phi_373_ = false;
                    } else {
                        phi_372_ = bool();
                        phi_373_ = true;
                    }
                    let _e258 = phi_372_;
                    let _e260 = phi_373_;
                    phi_374_ = _e258;
                    phi_375_ = _e260;
                } else {
                    phi_374_ = bool();
                    phi_375_ = true;
                }
                let _e262 = phi_374_;
                let _e264 = phi_375_;
                phi_376_ = _e262;
                phi_377_ = _e264;
            } else {
                phi_376_ = bool();
                phi_377_ = true;
            }
            let _e266 = phi_376_;
            let _e268 = phi_377_;
            if _e268 {
                phi_381_ = false;
            } else {
                phi_381_ = _e266;
            }
            let _e270 = phi_381_;
            if _e270 {
                let _e272 = p.member.map_size;
                let _e273 = f32(_e272);
                let _e276 = ((_e216 * _e273) - 0.5f);
                let _e277 = ((_e230 * _e273) - 0.5f);
                if (_e276 > -8388608f) {
                    let _e289 = f32(select(0i, select(select(i32(_e276), i32(-2147483648), (_e276 < bitcast<f32>(3472883712u))), 2147483647i, (_e276 > bitcast<f32>(1325400063u))), (_e276 == _e276)));
                    if (_e289 > _e276) {
                        phi_417_ = 1f;
                    } else {
                        phi_417_ = 0f;
                    }
                    let _e292 = phi_417_;
                    if (_e276 < 8388608f) {
                        phi_422_ = (_e289 - _e292);
                        phi_423_ = false;
                    } else {
                        phi_422_ = f32();
                        phi_423_ = true;
                    }
                    let _e295 = phi_422_;
                    let _e297 = phi_423_;
                    phi_424_ = _e295;
                    phi_425_ = _e297;
                } else {
                    phi_424_ = f32();
                    phi_425_ = true;
                }
                let _e299 = phi_424_;
                let _e301 = phi_425_;
                if _e301 {
                    phi_429_ = _e276;
                } else {
                    phi_429_ = _e299;
                }
                let _e303 = phi_429_;
                if (_e277 > -8388608f) {
                    let _e315 = f32(select(0i, select(select(i32(_e277), i32(-2147483648), (_e277 < bitcast<f32>(3472883712u))), 2147483647i, (_e277 > bitcast<f32>(1325400063u))), (_e277 == _e277)));
                    if (_e315 > _e277) {
                        phi_449_ = 1f;
                    } else {
                        phi_449_ = 0f;
                    }
                    let _e318 = phi_449_;
                    if (_e277 < 8388608f) {
                        phi_454_ = (_e315 - _e318);
                        phi_455_ = false;
                    } else {
                        phi_454_ = f32();
                        phi_455_ = true;
                    }
                    let _e321 = phi_454_;
                    let _e323 = phi_455_;
                    phi_456_ = _e321;
                    phi_457_ = _e323;
                } else {
                    phi_456_ = f32();
                    phi_457_ = true;
                }
                let _e325 = phi_456_;
                let _e327 = phi_457_;
                if _e327 {
                    phi_461_ = _e277;
                } else {
                    phi_461_ = _e325;
                }
                let _e329 = phi_461_;
                let _e330 = (_e276 - _e303);
                let _e331 = (_e277 - _e329);
                let _e340 = select(0i, select(select(i32(_e303), i32(-2147483648), (_e303 < bitcast<f32>(3472883712u))), 2147483647i, (_e303 > bitcast<f32>(1325400063u))), (_e303 == _e303));
                let _e349 = select(0i, select(select(i32(_e329), i32(-2147483648), (_e329 < bitcast<f32>(3472883712u))), 2147483647i, (_e329 > bitcast<f32>(1325400063u))), (_e329 == _e329));
                let _e360 = p.member.test;
                let _e361 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e360);
                let _e363 = p.member.map_size;
                local = _e361;
                let _e365 = (bitcast<i32>(_e363) - 1i);
                if (_e340 > 0i) {
                    phi_507_ = _e340;
                } else {
                    phi_507_ = 0i;
                }
                let _e368 = phi_507_;
                if (_e349 > 0i) {
                    phi_512_ = _e349;
                } else {
                    phi_512_ = 0i;
                }
                let _e371 = phi_512_;
                if (_e368 < _e365) {
                    phi_517_ = _e368;
                } else {
                    phi_517_ = _e365;
                }
                let _e374 = phi_517_;
                if (_e371 < _e365) {
                    phi_522_ = _e371;
                } else {
                    phi_522_ = _e365;
                }
                let _e377 = phi_522_;
                let _e378 = bitcast<u32>(_e374);
                let _e380 = (_e340 + 1i);
                let _e381 = (_e349 + 1i);
                if (_e380 > 0i) {
                    phi_531_ = _e380;
                } else {
                    phi_531_ = 0i;
                }
                let _e384 = phi_531_;
                if (_e381 > 0i) {
                    phi_536_ = _e381;
                } else {
                    phi_536_ = 0i;
                }
                let _e387 = phi_536_;
                if (_e384 < _e365) {
                    phi_541_ = _e384;
                } else {
                    phi_541_ = _e365;
                }
                let _e390 = phi_541_;
                if (_e387 < _e365) {
                    phi_546_ = _e387;
                } else {
                    phi_546_ = _e365;
                }
                let _e393 = phi_546_;
                let _e394 = bitcast<u32>(_e390);
                let _e396 = (bitcast<u32>(_e377) * _e363);
                let _e397 = (bitcast<u32>(_e393) * _e363);
                let _e398 = (_e396 + _e378);
                let _e399 = (_e396 + _e394);
                let _e400 = (_e397 + _e378);
                let _e401 = (_e397 + _e394);
                if (_e398 < _e53) {
                } else {
                    return;
                }
                let _e405 = map.member[(0u + _e398)];
                if (_e399 < _e53) {
                } else {
                    return;
                }
                let _e409 = map.member[(0u + _e399)];
                if (_e400 < _e53) {
                } else {
                    return;
                }
                let _e413 = map.member[(0u + _e400)];
                if (_e401 < _e53) {
                } else {
                    return;
                }
                let _e417 = map.member[(0u + _e401)];
                let _e419 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e405, _e409, _e413, _e417), vec4<f32>(((1f - _e330) * (1f - _e331)), (_e330 * (1f - _e331)), ((1f - _e330) * _e331), (_e330 * _e331)), _e243);
                phi_587_ = evaluate_Verdict(_e419, false);
                phi_588_ = evaluate_Verdict();
                phi_589_ = false;
            } else {
                phi_587_ = evaluate_Verdict();
                phi_588_ = evaluate_Verdict(1f, false);
                phi_589_ = true;
            }
            let _e423 = phi_587_;
            let _e425 = phi_588_;
            let _e427 = phi_589_;
            phi_590_ = _e425;
            phi_591_ = _e423;
            phi_592_ = _e427;
        }
        let _e429 = phi_590_;
        let _e431 = phi_591_;
        let _e433 = phi_592_;
        if _e433 {
            phi_596_ = _e429;
        } else {
            phi_596_ = _e431;
        }
        let _e435 = phi_596_;
        if (_e62.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e62.first_primitive)] = _e435.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_esm_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
