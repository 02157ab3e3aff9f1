struct abi_Sample {
    position: vec3<f32>,
    magnitude: f32,
    normal: vec3<f32>,
    flags: u32,
    shading_normal: vec3<f32>,
    albedo: u32,
}

struct type_9 {
    member: array<abi_Sample>,
}

struct type_13 {
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

struct type_29 {
    member: abi_ShadowParams,
}

struct lt_math_LightPoint {
    uv: vec2<f32>,
    depth: f32,
    is_inside: bool,
}

struct type_35 {
    member: array<lt_math_LightProjection>,
}

struct lt_math_LevelPoint {
    level: u32,
    point: lt_math_LightPoint,
}

var<private> id_1: vec3<u32>;
@group(0) @binding(1) 
var<storage> samples: type_9;
var<private> global: vec3<f32> = vec3<f32>(0f, 0f, 0f);
@group(0) @binding(0) 
var<uniform> p: type_29;
@group(0) @binding(2) 
var<storage> map: type_13;
@group(0) @binding(3) 
var<storage, read_write> visibility: type_13;
@group(0) @binding(4) 
var<storage> levels: type_35;

fn lt_shaders_entry_pixel_index(param: vec3<u32>, param_1: u32, param_2: u32) -> lt_bvh_traverse_Tree {
    var phi_153_: lt_bvh_traverse_Tree;
    var phi_154_: bool;
    var phi_155_: lt_bvh_traverse_Tree;
    var phi_156_: bool;
    var phi_161_: lt_bvh_traverse_Tree;

    if (param.x < param_1) {
        if (param.y < param_2) {
            phi_153_ = lt_bvh_traverse_Tree(1u, ((param.y * param_1) + param.x));
            phi_154_ = false;
        } else {
            phi_153_ = lt_bvh_traverse_Tree();
            phi_154_ = true;
        }
        let _e64 = phi_153_;
        let _e66 = phi_154_;
        phi_155_ = _e64;
        phi_156_ = _e66;
    } else {
        phi_155_ = lt_bvh_traverse_Tree();
        phi_156_ = true;
    }
    let _e68 = phi_155_;
    let _e70 = phi_156_;
    if _e70 {
        phi_161_ = lt_bvh_traverse_Tree(0u, lt_bvh_traverse_Tree().first_primitive);
    } else {
        phi_161_ = _e68;
    }
    let _e75 = phi_161_;
    return lt_bvh_traverse_Tree(_e75.root, _e75.first_primitive);
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(param_3: vec4<f32>) -> f32 {
    return param_3.x;
}

fn _lt_math_esm_Esm_clamped_exponent(param_4: ptr<function, f32>) -> f32 {
    var phi_181_: bool;
    var phi_185_: f32;

    let _e52 = (*param_4);
    if ((bitcast<u32>(84f) & 2147483647u) > 2139095040u) {
        phi_181_ = true;
    } else {
        let _e56 = (84f < _e52);
        if _e56 {
        }
        phi_181_ = _e56;
    }
    let _e58 = phi_181_;
    if _e58 {
        phi_185_ = 84f;
    } else {
        phi_185_ = _e52;
    }
    let _e60 = phi_185_;
    return _e60;
}

fn _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather(param_5: ptr<function, f32>, param_6: vec4<f32>, param_7: vec4<f32>, param_8: f32) -> f32 {
    var phi_206_: f32;
    var phi_207_: f32;
    var phi_208_: f32;
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
    var phi_299_: f32;
    var phi_304_: f32;
    var phi_326_: f32;
    var phi_331_: f32;
    var phi_332_: bool;
    var phi_333_: f32;
    var phi_334_: bool;
    var phi_338_: f32;
    var phi_376_: f32;
    var phi_387_: f32;
    var phi_392_: f32;
    var phi_414_: f32;
    var phi_419_: f32;
    var phi_420_: bool;
    var phi_421_: f32;
    var phi_422_: bool;
    var phi_426_: f32;
    var phi_464_: f32;
    var phi_475_: f32;
    var phi_480_: f32;
    var phi_502_: f32;
    var phi_507_: f32;
    var phi_508_: bool;
    var phi_509_: f32;
    var phi_510_: bool;
    var phi_514_: f32;
    var phi_552_: f32;
    var phi_563_: f32;
    var phi_568_: f32;
    var phi_590_: f32;
    var phi_595_: f32;
    var phi_596_: bool;
    var phi_597_: f32;
    var phi_598_: bool;
    var phi_602_: f32;
    var phi_640_: f32;
    var phi_666_: f32;
    var phi_667_: f32;
    var phi_668_: f32;

    let _e55 = _lt_math_esm_Esm_clamped_exponent(param_5);
    if ((bitcast<u32>(param_8) & 2147483647u) > 2139095040u) {
        phi_208_ = param_8;
    } else {
        if (param_8 < 0f) {
            phi_207_ = 0f;
        } else {
            if (param_8 > 1f) {
                phi_206_ = 1f;
            } else {
                phi_206_ = param_8;
            }
            let _e62 = phi_206_;
            phi_207_ = _e62;
        }
        let _e64 = phi_207_;
        phi_208_ = _e64;
    }
    let _e66 = phi_208_;
    if ((bitcast<u32>(param_6.x) & 2147483647u) > 2139095040u) {
        phi_226_ = param_6.x;
    } else {
        if (param_6.x < 0f) {
            phi_225_ = 0f;
        } else {
            if (param_6.x > 1f) {
                phi_224_ = 1f;
            } else {
                phi_224_ = param_6.x;
            }
            let _e74 = phi_224_;
            phi_225_ = _e74;
        }
        let _e76 = phi_225_;
        phi_226_ = _e76;
    }
    let _e78 = phi_226_;
    if ((bitcast<u32>(param_6.y) & 2147483647u) > 2139095040u) {
        phi_244_ = param_6.y;
    } else {
        if (param_6.y < 0f) {
            phi_243_ = 0f;
        } else {
            if (param_6.y > 1f) {
                phi_242_ = 1f;
            } else {
                phi_242_ = param_6.y;
            }
            let _e86 = phi_242_;
            phi_243_ = _e86;
        }
        let _e88 = phi_243_;
        phi_244_ = _e88;
    }
    let _e90 = phi_244_;
    if ((bitcast<u32>(param_6.z) & 2147483647u) > 2139095040u) {
        phi_262_ = param_6.z;
    } else {
        if (param_6.z < 0f) {
            phi_261_ = 0f;
        } else {
            if (param_6.z > 1f) {
                phi_260_ = 1f;
            } else {
                phi_260_ = param_6.z;
            }
            let _e98 = phi_260_;
            phi_261_ = _e98;
        }
        let _e100 = phi_261_;
        phi_262_ = _e100;
    }
    let _e102 = phi_262_;
    if ((bitcast<u32>(param_6.w) & 2147483647u) > 2139095040u) {
        phi_280_ = param_6.w;
    } else {
        if (param_6.w < 0f) {
            phi_279_ = 0f;
        } else {
            if (param_6.w > 1f) {
                phi_278_ = 1f;
            } else {
                phi_278_ = param_6.w;
            }
            let _e110 = phi_278_;
            phi_279_ = _e110;
        }
        let _e112 = phi_279_;
        phi_280_ = _e112;
    }
    let _e114 = phi_280_;
    let _e119 = (_e55 * (_e78 - _e66));
    let _e120 = (_e55 * (_e90 - _e66));
    let _e121 = (_e55 * (_e102 - _e66));
    let _e122 = (_e55 * (_e114 - _e66));
    if ((bitcast<u32>(_e119) & 2147483647u) > 2139095040u) {
        phi_376_ = _e119;
    } else {
        if (_e119 < -87f) {
            phi_299_ = -87f;
        } else {
            phi_299_ = _e119;
        }
        let _e128 = phi_299_;
        if (_e128 > 88f) {
            phi_304_ = 88f;
        } else {
            phi_304_ = _e128;
        }
        let _e131 = phi_304_;
        let _e133 = ((_e131 * 1.442695f) + 0.5f);
        if (_e133 > -8388608f) {
            let _e145 = f32(select(0i, select(select(i32(_e133), i32(-2147483648), (_e133 < bitcast<f32>(3472883712u))), 2147483647i, (_e133 > bitcast<f32>(1325400063u))), (_e133 == _e133)));
            if (_e145 > _e133) {
                phi_326_ = 1f;
            } else {
                phi_326_ = 0f;
            }
            let _e148 = phi_326_;
            if (_e133 < 8388608f) {
                phi_331_ = (_e145 - _e148);
                phi_332_ = false;
            } else {
                phi_331_ = f32();
                phi_332_ = true;
            }
            let _e151 = phi_331_;
            let _e153 = phi_332_;
            phi_333_ = _e151;
            phi_334_ = _e153;
        } else {
            phi_333_ = f32();
            phi_334_ = true;
        }
        let _e155 = phi_333_;
        let _e157 = phi_334_;
        if _e157 {
            phi_338_ = _e133;
        } else {
            phi_338_ = _e155;
        }
        let _e159 = phi_338_;
        let _e163 = ((_e131 - (_e159 * 0.69314575f)) - (_e159 * 0.0000014286068f));
        phi_376_ = ((((((((((((((((1f / 5040f) * _e163) + (1f / 720f)) * _e163) + (1f / 120f)) * _e163) + (1f / 24f)) * _e163) + (1f / 6f)) * _e163) + 0.5f) * _e163) + 1f) * _e163) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e159), i32(-2147483648), (_e159 < bitcast<f32>(3472883712u))), 2147483647i, (_e159 > bitcast<f32>(1325400063u))), (_e159 == _e159)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e199 = phi_376_;
    if ((bitcast<u32>(_e120) & 2147483647u) > 2139095040u) {
        phi_464_ = _e120;
    } else {
        if (_e120 < -87f) {
            phi_387_ = -87f;
        } else {
            phi_387_ = _e120;
        }
        let _e205 = phi_387_;
        if (_e205 > 88f) {
            phi_392_ = 88f;
        } else {
            phi_392_ = _e205;
        }
        let _e208 = phi_392_;
        let _e210 = ((_e208 * 1.442695f) + 0.5f);
        if (_e210 > -8388608f) {
            let _e222 = f32(select(0i, select(select(i32(_e210), i32(-2147483648), (_e210 < bitcast<f32>(3472883712u))), 2147483647i, (_e210 > bitcast<f32>(1325400063u))), (_e210 == _e210)));
            if (_e222 > _e210) {
                phi_414_ = 1f;
            } else {
                phi_414_ = 0f;
            }
            let _e225 = phi_414_;
            if (_e210 < 8388608f) {
                phi_419_ = (_e222 - _e225);
                phi_420_ = false;
            } else {
                phi_419_ = f32();
                phi_420_ = true;
            }
            let _e228 = phi_419_;
            let _e230 = phi_420_;
            phi_421_ = _e228;
            phi_422_ = _e230;
        } else {
            phi_421_ = f32();
            phi_422_ = true;
        }
        let _e232 = phi_421_;
        let _e234 = phi_422_;
        if _e234 {
            phi_426_ = _e210;
        } else {
            phi_426_ = _e232;
        }
        let _e236 = phi_426_;
        let _e240 = ((_e208 - (_e236 * 0.69314575f)) - (_e236 * 0.0000014286068f));
        phi_464_ = ((((((((((((((((1f / 5040f) * _e240) + (1f / 720f)) * _e240) + (1f / 120f)) * _e240) + (1f / 24f)) * _e240) + (1f / 6f)) * _e240) + 0.5f) * _e240) + 1f) * _e240) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e236), i32(-2147483648), (_e236 < bitcast<f32>(3472883712u))), 2147483647i, (_e236 > bitcast<f32>(1325400063u))), (_e236 == _e236)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e276 = phi_464_;
    if ((bitcast<u32>(_e121) & 2147483647u) > 2139095040u) {
        phi_552_ = _e121;
    } else {
        if (_e121 < -87f) {
            phi_475_ = -87f;
        } else {
            phi_475_ = _e121;
        }
        let _e282 = phi_475_;
        if (_e282 > 88f) {
            phi_480_ = 88f;
        } else {
            phi_480_ = _e282;
        }
        let _e285 = phi_480_;
        let _e287 = ((_e285 * 1.442695f) + 0.5f);
        if (_e287 > -8388608f) {
            let _e299 = f32(select(0i, select(select(i32(_e287), i32(-2147483648), (_e287 < bitcast<f32>(3472883712u))), 2147483647i, (_e287 > bitcast<f32>(1325400063u))), (_e287 == _e287)));
            if (_e299 > _e287) {
                phi_502_ = 1f;
            } else {
                phi_502_ = 0f;
            }
            let _e302 = phi_502_;
            if (_e287 < 8388608f) {
                phi_507_ = (_e299 - _e302);
                phi_508_ = false;
            } else {
                phi_507_ = f32();
                phi_508_ = true;
            }
            let _e305 = phi_507_;
            let _e307 = phi_508_;
            phi_509_ = _e305;
            phi_510_ = _e307;
        } else {
            phi_509_ = f32();
            phi_510_ = true;
        }
        let _e309 = phi_509_;
        let _e311 = phi_510_;
        if _e311 {
            phi_514_ = _e287;
        } else {
            phi_514_ = _e309;
        }
        let _e313 = phi_514_;
        let _e317 = ((_e285 - (_e313 * 0.69314575f)) - (_e313 * 0.0000014286068f));
        phi_552_ = ((((((((((((((((1f / 5040f) * _e317) + (1f / 720f)) * _e317) + (1f / 120f)) * _e317) + (1f / 24f)) * _e317) + (1f / 6f)) * _e317) + 0.5f) * _e317) + 1f) * _e317) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e313), i32(-2147483648), (_e313 < bitcast<f32>(3472883712u))), 2147483647i, (_e313 > bitcast<f32>(1325400063u))), (_e313 == _e313)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e353 = phi_552_;
    if ((bitcast<u32>(_e122) & 2147483647u) > 2139095040u) {
        phi_640_ = _e122;
    } else {
        if (_e122 < -87f) {
            phi_563_ = -87f;
        } else {
            phi_563_ = _e122;
        }
        let _e359 = phi_563_;
        if (_e359 > 88f) {
            phi_568_ = 88f;
        } else {
            phi_568_ = _e359;
        }
        let _e362 = phi_568_;
        let _e364 = ((_e362 * 1.442695f) + 0.5f);
        if (_e364 > -8388608f) {
            let _e376 = f32(select(0i, select(select(i32(_e364), i32(-2147483648), (_e364 < bitcast<f32>(3472883712u))), 2147483647i, (_e364 > bitcast<f32>(1325400063u))), (_e364 == _e364)));
            if (_e376 > _e364) {
                phi_590_ = 1f;
            } else {
                phi_590_ = 0f;
            }
            let _e379 = phi_590_;
            if (_e364 < 8388608f) {
                phi_595_ = (_e376 - _e379);
                phi_596_ = false;
            } else {
                phi_595_ = f32();
                phi_596_ = true;
            }
            let _e382 = phi_595_;
            let _e384 = phi_596_;
            phi_597_ = _e382;
            phi_598_ = _e384;
        } else {
            phi_597_ = f32();
            phi_598_ = true;
        }
        let _e386 = phi_597_;
        let _e388 = phi_598_;
        if _e388 {
            phi_602_ = _e364;
        } else {
            phi_602_ = _e386;
        }
        let _e390 = phi_602_;
        let _e394 = ((_e362 - (_e390 * 0.69314575f)) - (_e390 * 0.0000014286068f));
        phi_640_ = ((((((((((((((((1f / 5040f) * _e394) + (1f / 720f)) * _e394) + (1f / 120f)) * _e394) + (1f / 24f)) * _e394) + (1f / 6f)) * _e394) + 0.5f) * _e394) + 1f) * _e394) + 1f) * bitcast<f32>((bitcast<u32>((select(0i, select(select(i32(_e390), i32(-2147483648), (_e390 < bitcast<f32>(3472883712u))), 2147483647i, (_e390 > bitcast<f32>(1325400063u))), (_e390 == _e390)) + 127i)) << bitcast<u32>(23i))));
    }
    let _e430 = phi_640_;
    let _e441 = ((((_e199 * param_7.x) + (_e276 * param_7.y)) + (_e353 * param_7.z)) + (_e430 * param_7.w));
    if ((bitcast<u32>(_e441) & 2147483647u) > 2139095040u) {
        phi_668_ = _e441;
    } else {
        if (_e441 < 0f) {
            phi_667_ = 0f;
        } else {
            if (_e441 > 1f) {
                phi_666_ = 1f;
            } else {
                phi_666_ = _e441;
            }
            let _e448 = phi_666_;
            phi_667_ = _e448;
        }
        let _e450 = phi_667_;
        phi_668_ = _e450;
    }
    let _e452 = phi_668_;
    return _e452;
}

fn function_() {
    var local: f32;
    var phi_729_: bool;
    var phi_730_: bool;
    var phi_731_: bool;
    var phi_732_: bool;
    var phi_736_: bool;
    var phi_780_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_784_: u0028_evaluate_Verdict_u0020_bool_u0029_;
    var phi_804_: lt_math_LightPoint;
    var phi_807_: u32;
    var phi_809_: lt_math_LevelPoint;
    var phi_895_: bool;
    var phi_904_: bool;
    var phi_913_: bool;
    var phi_914_: bool;
    var phi_915_: bool;
    var phi_916_: bool;
    var phi_917_: bool;
    var phi_918_: bool;
    var phi_919_: bool;
    var phi_923_: bool;
    var phi_950_: bool;
    var phi_951_: bool;
    var phi_952_: bool;
    var phi_953_: bool;
    var phi_954_: bool;
    var phi_955_: bool;
    var phi_956_: bool;
    var phi_957_: bool;
    var phi_961_: bool;
    var phi_970_: lt_math_LightPoint;
    var phi_971_: u32;
    var phi_972_: lt_math_LevelPoint;
    var phi_973_: bool;
    var phi_805_: lt_math_LightPoint;
    var phi_808_: u32;
    var phi_810_: lt_math_LevelPoint;
    var phi_974_: bool;
    var local_1: lt_math_LevelPoint;
    var local_2: lt_math_LevelPoint;
    var phi_1014_: bool;
    var phi_1015_: bool;
    var phi_1016_: bool;
    var phi_1017_: bool;
    var phi_1021_: bool;
    var phi_1103_: f32;
    var phi_1219_: f32;
    var phi_1220_: f32;
    var phi_1223_: f32;
    var phi_1252_: f32;
    var phi_1257_: f32;
    var phi_1258_: bool;
    var phi_1259_: f32;
    var phi_1260_: bool;
    var phi_1264_: f32;
    var phi_1284_: f32;
    var phi_1289_: f32;
    var phi_1290_: bool;
    var phi_1291_: f32;
    var phi_1292_: bool;
    var phi_1296_: f32;
    var local_3: lt_math_LevelPoint;
    var phi_1345_: i32;
    var phi_1350_: i32;
    var phi_1355_: i32;
    var phi_1360_: i32;
    var phi_1369_: i32;
    var phi_1374_: i32;
    var phi_1379_: i32;
    var phi_1384_: i32;
    var phi_1435_: bool;
    var phi_1443_: bool;
    var phi_1455_: bool;
    var phi_1456_: bool;
    var phi_1460_: f32;
    var phi_1466_: f32;
    var phi_1468_: evaluate_Verdict;
    var phi_1473_: evaluate_Verdict;
    var phi_1474_: evaluate_Verdict;

    let _e52 = id_1;
    let _e59 = arrayLength((&map.member));
    let _e65 = arrayLength((&levels.member));
    let _e68 = p.member.size[0u];
    let _e70 = p.member.size[1u];
    let _e71 = lt_shaders_entry_pixel_index(_e52, _e68, _e70);
    if (bitcast<i32>(_e71.root) != 0i) {
        let _e77 = p.member.level_count;
        if (_e71.first_primitive < arrayLength((&samples.member))) {
        } else {
            return;
        }
        let _e82 = p.member.light;
        let _e85 = samples.member[(0u + _e71.first_primitive)].normal[0u];
        let _e87 = global[0u];
        if (_e85 == _e87) {
            let _e90 = samples.member[(0u + _e71.first_primitive)].normal[1u];
            let _e92 = global[1u];
            if (_e90 == _e92) {
                let _e95 = samples.member[(0u + _e71.first_primitive)].normal[2u];
                let _e97 = global[2u];
                phi_729_ = (_e95 == _e97);
                phi_730_ = false;
            } else {
                phi_729_ = bool();
                phi_730_ = true;
            }
            let _e100 = phi_729_;
            let _e102 = phi_730_;
            phi_731_ = _e100;
            phi_732_ = _e102;
        } else {
            phi_731_ = bool();
            phi_732_ = true;
        }
        let _e104 = phi_731_;
        let _e106 = phi_732_;
        if _e106 {
            phi_736_ = false;
        } else {
            phi_736_ = _e104;
        }
        let _e108 = phi_736_;
        if !(_e108) {
            let _e111 = samples.member[(0u + _e71.first_primitive)].normal;
            let _e113 = samples.member[(0u + _e71.first_primitive)].position;
            if ((((_e111.x * (_e82.x - (_e113.x * _e82.w))) + (_e111.y * (_e82.y - (_e113.y * _e82.w)))) + (_e111.z * (_e82.z - (_e113.z * _e82.w)))) > 0f) {
                let _e137 = samples.member[(0u + _e71.first_primitive)].flags;
                let _e145 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(1f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e151 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e145.unnamed.visibility, false), _e145.unnamed_1);
                phi_780_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e151.unnamed, ((_e137 & 1u) == 0u));
            } else {
                let _e160 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
                let _e166 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e160.unnamed.visibility, false), _e160.unnamed_1);
                phi_780_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e166.unnamed, true);
            }
            let _e171 = phi_780_;
            phi_784_ = _e171;
        } else {
            let _e177 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(0f, u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed.is_doubted), u0028_evaluate_Verdict_u0020_bool_u0029_().unnamed_1);
            let _e183 = u0028_evaluate_Verdict_u0020_bool_u0029_(evaluate_Verdict(_e177.unnamed.visibility, false), _e177.unnamed_1);
            phi_784_ = u0028_evaluate_Verdict_u0020_bool_u0029_(_e183.unnamed, true);
        }
        let _e188 = phi_784_;
        if _e188.unnamed_1 {
            phi_1474_ = evaluate_Verdict(_e188.unnamed.visibility, _e188.unnamed.is_doubted);
        } else {
            let _e196 = samples.member[(0u + _e71.first_primitive)].position;
            let _e198 = p.member.map_size;
            let _e200 = (0.5f / f32(_e198));
            let _e207 = lt_math_LightPoint(vec2<f32>(0f, lt_math_LightPoint().uv.y), lt_math_LightPoint().depth, lt_math_LightPoint().is_inside);
            let _e214 = lt_math_LightPoint(vec2<f32>(_e207.uv.x, 0f), _e207.depth, _e207.is_inside);
            let _e218 = lt_math_LightPoint(_e214.uv, 0f, _e214.is_inside);
            phi_804_ = lt_math_LightPoint();
            phi_807_ = 0u;
            phi_809_ = lt_math_LevelPoint(0u, lt_math_LightPoint(_e218.uv, _e218.depth, false));
            loop {
                let _e225 = phi_804_;
                let _e227 = phi_807_;
                let _e229 = phi_809_;
                local_1 = _e229;
                local_2 = _e229;
                local_3 = _e229;
                if (_e227 < _e77) {
                    if _e229.point.is_inside {
                        phi_970_ = lt_math_LightPoint();
                        phi_971_ = u32();
                        phi_972_ = lt_math_LevelPoint();
                        phi_973_ = false;
                    } else {
                        if (_e227 < _e65) {
                        } else {
                            return;
                        }
                        let _e240 = levels.member[(0u + _e227)].row_w;
                        let _e251 = ((((_e240.x * _e196.x) + (_e240.y * _e196.y)) + (_e240.z * _e196.z)) + (_e240.w * 1f));
                        let _e253 = levels.member[(0u + _e227)].row_x;
                        let _e265 = (((((_e253.x * _e196.x) + (_e253.y * _e196.y)) + (_e253.z * _e196.z)) + (_e253.w * 1f)) / _e251);
                        let _e267 = levels.member[(0u + _e227)].row_y;
                        let _e279 = (((((_e267.x * _e196.x) + (_e267.y * _e196.y)) + (_e267.z * _e196.z)) + (_e267.w * 1f)) / _e251);
                        let _e281 = levels.member[(0u + _e227)].row_z;
                        let _e292 = ((((_e281.x * _e196.x) + (_e281.y * _e196.y)) + (_e281.z * _e196.z)) + (_e281.w * 1f));
                        if (_e251 > 0f) {
                            if (_e265 >= 0f) {
                                phi_895_ = (_e265 <= 1f);
                            } else {
                                phi_895_ = false;
                            }
                            let _e297 = phi_895_;
                            if _e297 {
                                if (_e279 >= 0f) {
                                    phi_904_ = (_e279 <= 1f);
                                } else {
                                    phi_904_ = false;
                                }
                                let _e301 = phi_904_;
                                if _e301 {
                                    if (_e292 >= 0f) {
                                        phi_913_ = (_e292 <= 1f);
                                    } else {
                                        phi_913_ = false;
                                    }
                                    let _e305 = phi_913_;
                                    phi_914_ = _e305;
                                    phi_915_ = false;
                                } else {
                                    phi_914_ = bool();
                                    phi_915_ = true;
                                }
                                let _e307 = phi_914_;
                                let _e309 = phi_915_;
                                phi_916_ = _e307;
                                phi_917_ = _e309;
                            } else {
                                phi_916_ = bool();
                                phi_917_ = true;
                            }
                            let _e311 = phi_916_;
                            let _e313 = phi_917_;
                            phi_918_ = _e311;
                            phi_919_ = _e313;
                        } else {
                            phi_918_ = bool();
                            phi_919_ = true;
                        }
                        let _e315 = phi_918_;
                        let _e317 = phi_919_;
                        if _e317 {
                            phi_923_ = false;
                        } else {
                            phi_923_ = _e315;
                        }
                        let _e319 = phi_923_;
                        if _e319 {
                            if (_e265 >= _e200) {
                                if (_e265 <= (1f - _e200)) {
                                    if (_e279 >= _e200) {
                                        phi_950_ = (_e279 <= (1f - _e200));
                                        phi_951_ = false;
                                    } else {
                                        phi_950_ = bool();
                                        phi_951_ = true;
                                    }
                                    let _e327 = phi_950_;
                                    let _e329 = phi_951_;
                                    phi_952_ = _e327;
                                    phi_953_ = _e329;
                                } else {
                                    phi_952_ = bool();
                                    phi_953_ = true;
                                }
                                let _e331 = phi_952_;
                                let _e333 = phi_953_;
                                phi_954_ = _e331;
                                phi_955_ = _e333;
                            } else {
                                phi_954_ = bool();
                                phi_955_ = true;
                            }
                            let _e335 = phi_954_;
                            let _e337 = phi_955_;
                            phi_956_ = _e335;
                            phi_957_ = _e337;
                        } else {
                            phi_956_ = bool();
                            phi_957_ = true;
                        }
                        let _e339 = phi_956_;
                        let _e341 = phi_957_;
                        if _e341 {
                            phi_961_ = false;
                        } else {
                            phi_961_ = _e339;
                        }
                        let _e343 = phi_961_;
                        let _e350 = lt_math_LightPoint(vec2<f32>(_e265, _e225.uv.y), _e225.depth, _e225.is_inside);
                        let _e357 = lt_math_LightPoint(vec2<f32>(_e350.uv.x, _e279), _e350.depth, _e350.is_inside);
                        let _e361 = lt_math_LightPoint(_e357.uv, _e292, _e357.is_inside);
                        let _e365 = lt_math_LightPoint(_e361.uv, _e361.depth, _e343);
                        phi_970_ = _e365;
                        phi_971_ = (_e227 + 1u);
                        phi_972_ = lt_math_LevelPoint(_e227, _e365);
                        phi_973_ = true;
                    }
                    let _e369 = phi_970_;
                    let _e371 = phi_971_;
                    let _e373 = phi_972_;
                    let _e375 = phi_973_;
                    phi_805_ = _e369;
                    phi_808_ = _e371;
                    phi_810_ = _e373;
                    phi_974_ = _e375;
                } else {
                    phi_805_ = lt_math_LightPoint();
                    phi_808_ = u32();
                    phi_810_ = lt_math_LevelPoint();
                    phi_974_ = false;
                }
                let _e377 = phi_805_;
                let _e379 = phi_808_;
                let _e381 = phi_810_;
                let _e383 = phi_974_;
                continue;
                continuing {
                    phi_804_ = _e377;
                    phi_807_ = _e379;
                    phi_809_ = _e381;
                    break if !(_e383);
                }
            }
            let _e386 = local_1;
            if _e386.point.is_inside {
                if (0f > 0f) {
                    let _e392 = local_2;
                    if (_e392.level < _e65) {
                    } else {
                        return;
                    }
                    let _e397 = levels.member[(0u + _e392.level)];
                    let _e403 = global[0u];
                    if (_e397.row_w.x == _e403) {
                        let _e406 = global[1u];
                        if (_e397.row_w.y == _e406) {
                            let _e409 = global[2u];
                            phi_1014_ = (_e397.row_w.z == _e409);
                            phi_1015_ = false;
                        } else {
                            phi_1014_ = bool();
                            phi_1015_ = true;
                        }
                        let _e412 = phi_1014_;
                        let _e414 = phi_1015_;
                        phi_1016_ = _e412;
                        phi_1017_ = _e414;
                    } else {
                        phi_1016_ = bool();
                        phi_1017_ = true;
                    }
                    let _e416 = phi_1016_;
                    let _e418 = phi_1017_;
                    if _e418 {
                        phi_1021_ = false;
                    } else {
                        phi_1021_ = _e416;
                    }
                    let _e420 = phi_1021_;
                    if _e420 {
                        let _e422 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e424 = p.member.map_size;
                        let _e494 = ((abs(((((_e397.row_x.x * _e422.x) + (_e397.row_x.y * _e422.y)) + (_e397.row_x.z * _e422.z)) / (((_e397.row_x.x * _e397.row_x.x) + (_e397.row_x.y * _e397.row_x.y)) + (_e397.row_x.z * _e397.row_x.z)))) + abs(((((_e397.row_y.x * _e422.x) + (_e397.row_y.y * _e422.y)) + (_e397.row_y.z * _e422.z)) / (((_e397.row_y.x * _e397.row_y.x) + (_e397.row_y.y * _e397.row_y.y)) + (_e397.row_y.z * _e397.row_y.z))))) / (abs(((((_e397.row_z.x * _e422.x) + (_e397.row_z.y * _e422.y)) + (_e397.row_z.z * _e422.z)) / (((_e397.row_z.x * _e397.row_z.x) + (_e397.row_z.y * _e397.row_z.y)) + (_e397.row_z.z * _e397.row_z.z)))) * f32(_e424)));
                        if (_e494 < 0.002f) {
                            phi_1103_ = _e494;
                        } else {
                            phi_1103_ = 0.002f;
                        }
                        let _e497 = phi_1103_;
                        phi_1220_ = _e497;
                    } else {
                        let _e499 = p.member.map_size;
                        let _e505 = samples.member[(0u + _e71.first_primitive)].position;
                        let _e516 = ((((_e397.row_w.x * _e505.x) + (_e397.row_w.y * _e505.y)) + (_e397.row_w.z * _e505.z)) + _e397.row_w.w);
                        let _e529 = ((_e397.row_x.x - (_e397.row_w.x * _e386.point.uv.x)) / _e516);
                        let _e530 = ((_e397.row_x.y - (_e397.row_w.y * _e386.point.uv.x)) / _e516);
                        let _e531 = ((_e397.row_x.z - (_e397.row_w.z * _e386.point.uv.x)) / _e516);
                        let _e544 = ((_e397.row_y.x - (_e397.row_w.x * _e386.point.uv.y)) / _e516);
                        let _e545 = ((_e397.row_y.y - (_e397.row_w.y * _e386.point.uv.y)) / _e516);
                        let _e546 = ((_e397.row_y.z - (_e397.row_w.z * _e386.point.uv.y)) / _e516);
                        let _e552 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e557 = ((_e545 * _e552.z) - (_e552.y * _e546));
                        let _e562 = ((_e546 * _e552.x) - (_e552.z * _e544));
                        let _e567 = ((_e544 * _e552.y) - (_e552.x * _e545));
                        let _e569 = samples.member[(0u + _e71.first_primitive)].normal;
                        let _e574 = ((_e530 * _e569.z) - (_e569.y * _e531));
                        let _e579 = ((_e531 * _e569.x) - (_e569.z * _e529));
                        let _e584 = ((_e529 * _e569.y) - (_e569.x * _e530));
                        let _e611 = ((abs(((((_e397.row_z.x * _e557) + (_e397.row_z.y * _e562)) + (_e397.row_z.z * _e567)) / (((_e529 * _e557) + (_e530 * _e562)) + (_e531 * _e567)))) + abs(((((_e397.row_z.x * _e574) + (_e397.row_z.y * _e579)) + (_e397.row_z.z * _e584)) / (((_e544 * _e574) + (_e545 * _e579)) + (_e546 * _e584))))) / f32(_e499));
                        if (_e611 < 0.002f) {
                            phi_1219_ = _e611;
                        } else {
                            phi_1219_ = 0.002f;
                        }
                        let _e614 = phi_1219_;
                        phi_1220_ = _e614;
                    }
                    let _e616 = phi_1220_;
                    phi_1223_ = (_e386.point.depth - (0f * _e616));
                } else {
                    phi_1223_ = _e386.point.depth;
                }
                let _e620 = phi_1223_;
                let _e626 = p.member.map_size;
                let _e627 = f32(_e626);
                let _e630 = ((_e386.point.uv.x * _e627) - 0.5f);
                let _e631 = ((_e386.point.uv.y * _e627) - 0.5f);
                if (_e630 > -8388608f) {
                    let _e643 = f32(select(0i, select(select(i32(_e630), i32(-2147483648), (_e630 < bitcast<f32>(3472883712u))), 2147483647i, (_e630 > bitcast<f32>(1325400063u))), (_e630 == _e630)));
                    if (_e643 > _e630) {
                        phi_1252_ = 1f;
                    } else {
                        phi_1252_ = 0f;
                    }
                    let _e646 = phi_1252_;
                    if (_e630 < 8388608f) {
                        phi_1257_ = (_e643 - _e646);
                        phi_1258_ = false;
                    } else {
                        phi_1257_ = f32();
                        phi_1258_ = true;
                    }
                    let _e649 = phi_1257_;
                    let _e651 = phi_1258_;
                    phi_1259_ = _e649;
                    phi_1260_ = _e651;
                } else {
                    phi_1259_ = f32();
                    phi_1260_ = true;
                }
                let _e653 = phi_1259_;
                let _e655 = phi_1260_;
                if _e655 {
                    phi_1264_ = _e630;
                } else {
                    phi_1264_ = _e653;
                }
                let _e657 = phi_1264_;
                if (_e631 > -8388608f) {
                    let _e669 = f32(select(0i, select(select(i32(_e631), i32(-2147483648), (_e631 < bitcast<f32>(3472883712u))), 2147483647i, (_e631 > bitcast<f32>(1325400063u))), (_e631 == _e631)));
                    if (_e669 > _e631) {
                        phi_1284_ = 1f;
                    } else {
                        phi_1284_ = 0f;
                    }
                    let _e672 = phi_1284_;
                    if (_e631 < 8388608f) {
                        phi_1289_ = (_e669 - _e672);
                        phi_1290_ = false;
                    } else {
                        phi_1289_ = f32();
                        phi_1290_ = true;
                    }
                    let _e675 = phi_1289_;
                    let _e677 = phi_1290_;
                    phi_1291_ = _e675;
                    phi_1292_ = _e677;
                } else {
                    phi_1291_ = f32();
                    phi_1292_ = true;
                }
                let _e679 = phi_1291_;
                let _e681 = phi_1292_;
                if _e681 {
                    phi_1296_ = _e631;
                } else {
                    phi_1296_ = _e679;
                }
                let _e683 = phi_1296_;
                let _e684 = (_e630 - _e657);
                let _e685 = (_e631 - _e683);
                let _e694 = select(0i, select(select(i32(_e657), i32(-2147483648), (_e657 < bitcast<f32>(3472883712u))), 2147483647i, (_e657 > bitcast<f32>(1325400063u))), (_e657 == _e657));
                let _e703 = select(0i, select(select(i32(_e683), i32(-2147483648), (_e683 < bitcast<f32>(3472883712u))), 2147483647i, (_e683 > bitcast<f32>(1325400063u))), (_e683 == _e683));
                let _e714 = p.member.test;
                let _e715 = _lt_math_esm_Esm_u0020_as_u0020_lt_shaders_evaluate_TestFromParams_from_params(_e714);
                let _e717 = p.member.map_size;
                let _e719 = local_3;
                local = _e715;
                let _e722 = ((_e719.level * _e717) * _e717);
                let _e724 = (bitcast<i32>(_e717) - 1i);
                if (_e694 > 0i) {
                    phi_1345_ = _e694;
                } else {
                    phi_1345_ = 0i;
                }
                let _e727 = phi_1345_;
                if (_e703 > 0i) {
                    phi_1350_ = _e703;
                } else {
                    phi_1350_ = 0i;
                }
                let _e730 = phi_1350_;
                if (_e727 < _e724) {
                    phi_1355_ = _e727;
                } else {
                    phi_1355_ = _e724;
                }
                let _e733 = phi_1355_;
                if (_e730 < _e724) {
                    phi_1360_ = _e730;
                } else {
                    phi_1360_ = _e724;
                }
                let _e736 = phi_1360_;
                let _e737 = bitcast<u32>(_e733);
                let _e739 = (_e694 + 1i);
                let _e740 = (_e703 + 1i);
                if (_e739 > 0i) {
                    phi_1369_ = _e739;
                } else {
                    phi_1369_ = 0i;
                }
                let _e743 = phi_1369_;
                if (_e740 > 0i) {
                    phi_1374_ = _e740;
                } else {
                    phi_1374_ = 0i;
                }
                let _e746 = phi_1374_;
                if (_e743 < _e724) {
                    phi_1379_ = _e743;
                } else {
                    phi_1379_ = _e724;
                }
                let _e749 = phi_1379_;
                if (_e746 < _e724) {
                    phi_1384_ = _e746;
                } else {
                    phi_1384_ = _e724;
                }
                let _e752 = phi_1384_;
                let _e753 = bitcast<u32>(_e749);
                let _e755 = (bitcast<u32>(_e736) * _e717);
                let _e756 = (bitcast<u32>(_e752) * _e717);
                let _e761 = ((_e755 + _e737) + _e722);
                let _e762 = ((_e755 + _e753) + _e722);
                let _e763 = ((_e756 + _e737) + _e722);
                let _e764 = ((_e756 + _e753) + _e722);
                if (_e761 < _e59) {
                } else {
                    return;
                }
                let _e768 = map.member[(0u + _e761)];
                if (_e762 < _e59) {
                } else {
                    return;
                }
                let _e772 = map.member[(0u + _e762)];
                if (_e763 < _e59) {
                } else {
                    return;
                }
                let _e776 = map.member[(0u + _e763)];
                if (_e764 < _e59) {
                } else {
                    return;
                }
                let _e780 = map.member[(0u + _e764)];
                let _e782 = _lt_math_esm_Esm_u0020_as_u0020_lt_math_shadow_test_ShadowTest_visibility_of_gather((&local), vec4<f32>(_e768, _e772, _e776, _e780), vec4<f32>(((1f - _e684) * (1f - _e685)), (_e684 * (1f - _e685)), ((1f - _e684) * _e685), (_e684 * _e685)), _e620);
                let _e784 = p.member.epsilon;
                if (_e782 <= _e784) {
                    phi_1435_ = true;
                } else {
                    phi_1435_ = (_e782 >= (1f - _e784));
                }
                let _e789 = phi_1435_;
                if ((bitcast<u32>(_e782) & 2147483647u) > 2139095040u) {
                    phi_1443_ = true;
                } else {
                    phi_1443_ = !(_e789);
                }
                let _e795 = phi_1443_;
                if _e795 {
                    if (_e782 > 0f) {
                        if (_e782 < 1f) {
                            phi_1455_ = false;
                        } else {
                            phi_1455_ = true;
                        }
                        let _e799 = phi_1455_;
                        phi_1456_ = _e799;
                    } else {
                        phi_1456_ = true;
                    }
                    let _e801 = phi_1456_;
                    if _e801 {
                        phi_1460_ = 0.5f;
                    } else {
                        phi_1460_ = _e782;
                    }
                    let _e803 = phi_1460_;
                    phi_1468_ = evaluate_Verdict(_e803, true);
                } else {
                    if (_e782 > 0.5f) {
                        phi_1466_ = 1f;
                    } else {
                        phi_1466_ = 0f;
                    }
                    let _e807 = phi_1466_;
                    phi_1468_ = evaluate_Verdict(_e807, false);
                }
                let _e810 = phi_1468_;
                phi_1473_ = evaluate_Verdict(_e810.visibility, _e810.is_doubted);
            } else {
                phi_1473_ = evaluate_Verdict(0.5f, true);
            }
            let _e816 = phi_1473_;
            phi_1474_ = _e816;
        }
        let _e818 = phi_1474_;
        if (_e71.first_primitive < arrayLength((&visibility.member))) {
        } else {
            return;
        }
        visibility.member[(0u + _e71.first_primitive)] = _e818.visibility;
    }
    return;
}

@compute @workgroup_size(8, 8, 1) 
fn entry_evaluate_evaluate_lt_esm_levels_cs(@builtin(global_invocation_id) id: vec3<u32>) {
    id_1 = id;
    function_();
}
